//! What would be enough for an arch that stands at no thickness.

use super::assess::{Wanted, assessment};
use super::figure::Figure;
use super::find;
use super::mode::{Asked, outcome, pure_sliding};
use super::query::Query;
use super::raise::{GUARD, raise, raised};
use crate::certify::Undecided;
use crate::number::{Ball, ExactNumber, bits_of};
use crate::problem::Arch;
use rug::Rational;

/// What would be enough for an arch that stands at no thickness, correctly rounded; `None` where there is no
/// such value, or where it could not be told.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Enough {
    /// The friction of the purely sliding state of the half opening: with less nothing stands.
    pub sliding_friction: Option<Figure>,
    /// The least friction with which the half opening stands at some thickness.
    pub friction: Option<Figure>,
    /// The widest half opening, rad, that stands at some thickness with the friction.
    pub half_opening: Option<Figure>,
}

/// What would be enough: an arch stands at some thickness exactly if it stands at the physical limit.
pub(super) fn enough(arch: &Arch, digits: usize) -> Enough {
    let limit = ExactNumber::from(&Rational::from(2));
    let figure = |value: Option<Ball>| match value {
        Some(value) => Figure::new(&value, digits).map(Some),
        None => Some(None),
    };
    let rounded = |proof: &dyn Fn(u32) -> Result<Option<Ball>, Undecided>| {
        raised(arch, digits, |bits| Ok(figure(proof(bits)?))).ok().flatten()
    };
    let at_limit = |bits| find::at_thickness(arch, &limit, bits);
    let first = bits_of(digits) + GUARD;
    let half_opening = raise(first.saturating_add(find::bits_lost(&at_limit(first))), |bits| {
        let (_, at) = find::widest(&at_limit(bits), true)?;
        Ok(figure(Some(at.half_opening.rad)))
    });
    let unlimited = arch.unlimited();
    Enough {
        sliding_friction: rounded(&|bits| pure_sliding(&Query::new(arch, bits)).map(Some)),
        friction: rounded(&|bits| {
            let state = outcome(&Query::new(&unlimited, bits), Asked::Nothing);
            let at_limit =
                assessment(&unlimited, &limit, bits, Wanted::Everything, |_| state.clone())?;
            at_limit.required_friction
        }),
        half_opening: half_opening.ok().flatten(),
    }
}
