//! Remedies for an arch that stands at no thickness.

use super::assess::{Wanted, assessment};
use super::find;
use super::mode::{outcome, pure_sliding};
use super::query::{DOUBLE_DOUBLE, GUARD, Query, raised};
use crate::number::{Ball, DoubleDoubleBall, ExactNumber, bits_of};
use crate::problem::{Arch, Landmark};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::figure::{Figure, Figured, optional};
use crate::prover::{Answered, raise};
use rug::Rational;

/// Remedies that would be enough for an arch that stands at no thickness, correctly rounded; `None` where
/// there is no such value, or where it could not be told.
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

/// The part of it that the half opening decides, whatever the friction.
#[derive(Clone, Debug)]
pub(crate) struct AtOpening {
    sliding_friction: Option<Figure>,
    friction: Option<Figure>,
}

impl AtOpening {
    /// An arch stands at some thickness exactly if it stands at the physical limit. `quickly` asks balls of
    /// double-doubles first.
    pub(crate) fn new(arch: &Arch, digits: usize, quickly: bool) -> Self {
        let limit = &limit();
        let sliding_friction = proved(
            quickly,
            || figure(sliding::<DoubleDoubleBall>(arch, DOUBLE_DOUBLE), digits),
            || raised(arch, digits, |bits| figure(sliding::<Ball>(arch, bits), digits)),
        );
        let friction = proved(
            quickly,
            || figure(required::<DoubleDoubleBall>(arch, limit, DOUBLE_DOUBLE), digits),
            || raised(arch, digits, |bits| figure(required::<Ball>(arch, limit, bits), digits)),
        );
        Self { sliding_friction, friction }
    }
}

impl Enough {
    /// With what the half opening decides.
    pub(crate) fn new(arch: &Arch, at: &AtOpening, digits: usize, quickly: bool) -> Self {
        let limit = &limit();
        let first = bits_of(digits) + GUARD;
        let half_opening = proved(
            quickly,
            || figure(widest::<DoubleDoubleBall>(arch, limit, DOUBLE_DOUBLE), digits),
            || {
                let lost = find::bits_lost(&find::at_thickness(arch, limit, DOUBLE_DOUBLE));
                let proof = |bits| figure(widest::<Ball>(arch, limit, bits), digits);
                raise(first.saturating_add(lost), proof)
            },
        );
        let AtOpening { sliding_friction, friction } = at.clone();
        Self { sliding_friction, friction, half_opening }
    }
}

/// Finds what would be enough for an arch.
pub(super) fn enough(arch: &Arch, digits: usize, quickly: bool) -> Enough {
    Enough::new(arch, &AtOpening::new(arch, digits, quickly), digits, quickly)
}

/// The physical limit of the thickness.
fn limit() -> ExactNumber {
    ExactNumber::from(&Rational::from(2))
}

/// The figure that a quick proof decides, if one is asked, or else one whose bits are raised.
fn proved(
    quickly: bool,
    quick: impl FnOnce() -> Answered<Option<Figure>>,
    raised: impl FnOnce() -> Answered<Figure>,
) -> Option<Figure> {
    let quick = if quickly { quick().ok().flatten() } else { None };
    quick.or_else(|| raised().ok()).flatten()
}

/// The figure of a value, if it is decided or there is no value.
fn figure<E: Figured>(value: Answered<E>, digits: usize) -> Answered<Option<Figure>> {
    Ok(optional(value?, |value| value.figure(digits)))
}

/// The friction of the purely sliding state.
fn sliding<E: Arithmetic>(arch: &Arch, bits: u32) -> Answered<E> {
    pure_sliding(&Query::new(arch, bits)).map(Some)
}

/// The friction with which the half opening stands at the limit.
fn required<E: Arithmetic>(arch: &Arch, limit: &ExactNumber, bits: u32) -> Answered<E> {
    let unlimited = arch.unlimited();
    let query = Query::new(&unlimited, bits);
    let state = outcome::<E>(&query, false);
    assessment(&unlimited, limit, query, Wanted::Everything, |_, _| state.clone()).required_friction
}

/// The widest half opening that stands at the limit.
fn widest<E: Arithmetic>(arch: &Arch, limit: &ExactNumber, bits: u32) -> Answered<E> {
    let (_, at) =
        find::widest(&find::at_thickness(arch, limit, bits), Some(Landmark::OverturningEnd))?;
    Ok(Some(at.half_opening.rad))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Balls of MPFR, which are asked what double-doubles leave open, say the same where both decide.
    #[test]
    fn what_would_be_enough_does_not_depend_on_the_numbers() {
        let figures = |enough: Enough| {
            let Enough { sliding_friction, friction, half_opening } = enough;
            [sliding_friction, friction, half_opening].map(|x| x.map(|x| x.decimal))
        };
        for (half_opening, friction) in [("1.5", "0.1"), ("2.5", "0.9"), ("2.7", "inf")] {
            let arch = Arch::parse("heyman", half_opening, friction).unwrap();
            let sliding = || sliding::<DoubleDoubleBall>(&arch, 104);
            let quick = |digits| figure(sliding(), digits).ok().flatten();
            assert!(quick(16).is_some_and(|x| x.is_some()) && quick(30).is_none(), "{arch}");
            for digits in [16, 30] {
                let [first, other] =
                    [true, false].map(|quickly| figures(enough(&arch, digits, quickly)));
                assert_eq!(first, other, "{arch}");
                assert!(first[0].is_some() && first[2].is_some(), "{arch}");
            }
        }
    }
}
