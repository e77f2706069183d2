//! Arches of the figures of the paper.

use crate::problem::{Landmark, Mode};

/// The arches of a figure of the paper; it has them in 1 and in 7 to 12. Each is a landmark with the
/// modes of it that are shown.
pub fn arches_of_figure(number: usize) -> Option<&'static [(Landmark, &'static [Mode])]> {
    use Mode::*;
    Some(match number {
        1 => &[(Landmark::Triple, &[RotationalSliding])],
        7 => &[(Landmark::Triple, &[Sliding, Rotational])],
        8 => &[(Landmark::Triple, &[RotationalSliding, SlidingRotational])],
        9 => &[(Landmark::Shift, &[Sliding, RotationalSliding])],
        10 => &[(Landmark::Junction, &[Sliding, OverturningSliding])],
        11 => &[(Landmark::Border, &[Sliding, OverturningSliding])],
        12 => {
            &[(Landmark::OverturningEnd, &[Overturning]), (Landmark::RotationEnd, &[Overturning])]
        }
        _ => return None,
    })
}
