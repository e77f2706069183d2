//! Rational values of a state beside the one that is given, verified in exact arithmetic.

use crate::arch::{Ring, SelfWeight, overturning};
use crate::certify::equation::{ClosedForm, solves};
use crate::number::{Ball, ExactNumber};
use crate::problem::{Mode, Quantity};
use rug::Rational;

/// Tells whether a quantity of a state with a value is the number `x` in its enclosure `near`, exactly.
///
/// Overturning, (13) makes a rational `A` of a rational thickness. At a joint the purely rotational state may have one
/// too: Heyman's at pi/3 has the thrust 1/2.
pub(super) fn is_value(
    weight: SelfWeight,
    mode: Mode,
    (given, value): (Quantity, &ExactNumber),
    quantity: Quantity,
    near: &Ball,
    x: &Rational,
) -> bool {
    use Quantity as Q;
    match (mode, given, quantity) {
        (Mode::Overturning, Q::Thickness, Q::OpeningVariable) if value.is_rational() => {
            overturns(weight, &value.to_rational(), x)
        }
        // In a thickness up to 2, (13) falls strictly: no other one has this A.
        (Mode::Overturning, Q::OpeningVariable, Q::Thickness) if value.is_rational() => {
            *x <= 2 && overturns(weight, x, &value.to_rational())
        }
        (Mode::Rotational, Q::RotationJoint, Q::OpeningVariable) => {
            solves(weight, ClosedForm::OpeningVariable, value, near, x)
        }
        (Mode::Rotational, Q::RotationJoint, Q::Thickness) => {
            solves(weight, ClosedForm::Thickness, value, near, x)
        }
        (Mode::Rotational, Q::RotationJoint, Q::Thrust) => {
            solves(weight, ClosedForm::Thrust, value, near, x)
        }
        _ => false,
    }
}

/// (13), exactly.
fn overturns(weight: SelfWeight, thickness: &Rational, opening: &Rational) -> bool {
    overturning::opening_variable(&Ring::new(weight, thickness)).residual(opening) == 0
}
