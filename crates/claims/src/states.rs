//! A statement on all purely rotational states, whatever `delta_M` between 0 and 1.
//!
//! A thickness and a joint are those of a state where the cubic (7) in `eta`, which grows with `delta_M`, is
//! not positive for `delta_M = 0` and not negative for `delta_M = 1`.

use super::Checked;
use super::curve::cubic_of;
use crate::certify::{Undecided, between, cover};
use crate::number::{Angle, DoubleBall, DoubleDoubleBall, Enclosure, Field};
use crate::prover::decide::{ensure, is_positive};
use crate::prover::halve::{halve, halves};
use rug::Rational;

/// A range is halved so often at the most.
const DEPTH: u32 = 40;

/// From one number to another.
pub(super) type RationalRange = (Rational, Rational);

/// The joints among which those of all states are sought; that there are no others is checked.
fn joints() -> RationalRange {
    (Rational::from((1, 4)), Rational::from((6, 5)))
}

/// A ball that holds the numbers from `low` to `high`.
fn all(low: &Rational, high: &Rational) -> DoubleDoubleBall {
    (&between(low, high)).into()
}

/// The cubic (7) in `eta`.
fn cubic(joint: &Angle<DoubleDoubleBall>, delta: i32, eta: &DoubleDoubleBall) -> DoubleDoubleBall {
    cubic_of(joint, &eta.int(delta), eta)
}

/// The `delta_M` between 0 and 1 with states in a range of joints, at some of the thicknesses; none if there
/// are none. It falls as the joint grows, since `p/S` grows with both.
fn flags((least, widest): &RationalRange, eta: &DoubleDoubleBall) -> Option<DoubleDoubleBall> {
    let root = |joint: &Rational| {
        let joint = Angle::new(all(joint, joint));
        let rise = eta.square() * eta * joint.sin;
        DoubleBall::from(-(cubic(&joint, 0, eta) / rise))
    };
    let (low, high) = (root(widest).lower(), root(least).upper());
    let is_possible = !(low > 1.0 || high < 0.0);
    let end = |x: f64| DoubleBall::exact(x.clamp(0.0, 1.0));
    is_possible.then(|| end(low).hull(&end(high)).into())
}

/// Number of pieces that it takes to prove that all of `values`, of the joint, `delta_M` and the thickness,
/// are positive at all states of a range of thicknesses. They are given balls that contain the states.
pub(super) fn at_all_states(
    range: &RationalRange,
    values: &dyn Fn(
        &DoubleDoubleBall,
        &DoubleDoubleBall,
        &DoubleDoubleBall,
    ) -> Vec<DoubleDoubleBall>,
) -> Checked<usize> {
    let ((low, high), (first, last)) = (range, joints());
    let at = |x: &Rational| Angle::new(all(x, x));
    cover(low, high, &|eta| (-cubic(&at(&first), 1, &eta.into())).is_positive())?;
    cover(low, high, &|eta| cubic(&at(&last), 0, &eta.into()).is_positive())?;
    let halves = |(thickness, joint): &(RationalRange, RationalRange)| {
        Some(match width(thickness) > width(joint) {
            true => halves(thickness)?.map(|half| (half, joint.clone())),
            false => halves(joint)?.map(|half| (thickness.clone(), half)),
        })
    };
    let mut pieces = 0;
    let proof = |(thickness, joint): &(RationalRange, RationalRange)| {
        let [eta, beta] = [thickness, joint].map(|(low, high)| all(low, high));
        let Some(delta) = flags(joint, &eta) else { return Ok(()) };
        let is_proved = values(&beta, &delta, &eta).iter().all(is_positive);
        pieces += usize::from(is_proved);
        is_proved.then_some(()).ok_or((thickness.0.to_f64(), joint.0.to_f64()))
    };
    halve((range.clone(), joints()), DEPTH, halves, proof).map_err(|(eta, beta)| {
        Undecided::new(format!("not decided at eta = {eta}, beta = {beta}"))
    })?;
    ensure(pieces > 0, "no state is met")?;
    Ok(pieces)
}

/// The width over the upper end.
fn width((low, high): &RationalRange) -> Rational {
    Rational::from(high - low) / high
}
