//! Landmark values that are exact: rational, or in the field of `√3`, or infinite.
//!
//! A thickness found by closed form is proved to be the value of the landmark in three steps: the
//! equation it solves alone has there residual zero **exactly**, in the arithmetic of `a + b√d`; on the
//! box in which the landmark is unique that equation has a slope without zero, so it has one root
//! there; and the closed form lies in that box.

use crate::arch::{Configuration, Ring, SelfWeight, Unknown, overturning};
use crate::number::{Ball, Dual, Enclosure, ExactField, Field, Surd};
use crate::problem::{Equation, Fixed, Landmark, Quantity};
use crate::prover::Isolated;
use rug::Rational;

/// An exact value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Exact {
    /// Zero, an integer, a fraction, or a number with a square root.
    Surd(Surd),
    /// A fraction of pi.
    Pi(Rational),
    /// No bound: the friction of states that need it unlimited.
    Infinite,
}

impl Exact {
    /// The value, if it is rational.
    pub fn rational(&self) -> Option<&Rational> {
        match self {
            Self::Surd(surd) => Some(surd.parts()).filter(|(_, factor, _)| factor.is_zero()),
            Self::Pi(_) | Self::Infinite => None,
        }
        .map(|(rational, ..)| rational)
    }

    /// Text as a mathematician would write it.
    pub fn text(&self) -> String {
        match self {
            Self::Surd(surd) => surd.to_string(),
            Self::Pi(factor) => format!("π/{}", factor.clone().recip()),
            Self::Infinite => "inf".into(),
        }
    }
}

/// Only `√3` occurs.
const RADICAND: u32 = 3;

/// The exact value of a quantity at an isolated landmark, where it has one and that is proved.
pub(super) fn exact(landmark: Landmark, isolated: &Isolated, quantity: Quantity) -> Option<Exact> {
    let system = isolated.system();
    let integer = |n: i32| Exact::Surd(Surd::rational(n, RADICAND));
    let fixed = |unknown| system.fixed_value(unknown);
    match (quantity, fixed(quantity.variable()?)) {
        (Quantity::OpeningVariable, _) => {
            // With h = 0, (4) gives A from the thickness.
            (fixed(Unknown::Thrust) == Some(Fixed::Integer(0))).then_some(())?;
            let ring = Ring::new(system.weight, &thickness(landmark, isolated)?);
            Some(Exact::Surd(overturning::opening_variable(&ring).value()))
        }
        (Quantity::Thickness, _) => Some(Exact::Surd(thickness(landmark, isolated)?)),
        (Quantity::FrictionAngle, Some(Fixed::Infinite)) => Some(Exact::Pi((1, 2).into())),
        (Quantity::FrictionAngleDegrees, Some(Fixed::Infinite)) => Some(integer(90)),
        (_, Some(Fixed::Infinite)) => Some(Exact::Infinite),
        // Zero in radians is zero in degrees, and no thrust makes no intrinsic thrust.
        (_, Some(Fixed::Integer(n))) => Some(integer(n)),
        _ => None,
    }
}

fn thickness(landmark: Landmark, isolated: &Isolated) -> Option<Surd> {
    let system = isolated.system();
    if let Some(Fixed::Integer(n)) = system.fixed_value(Unknown::Thickness) {
        return Some(Surd::rational(n, RADICAND));
    }
    if landmark != Landmark::RotationEnd {
        return None;
    }
    let closed_form = overturning::thickness_at_end(system.weight, &Surd::new(0, 1, RADICAND));
    let domain = &isolated.domain()[system.index(Unknown::Thickness)?];
    is_thickness_without_thrust(system.weight, &closed_form, domain).then_some(closed_form)
}

/// Tells whether `value` is the only number in `domain` that solves (5) at `beta_r -> 0` with `h = 0`.
fn is_thickness_without_thrust(weight: SelfWeight, value: &Surd, domain: &Ball) -> bool {
    let residual_is_zero = residual(weight, value).is_zero();
    let slope = residual(weight, &Dual::variable(domain.clone(), 0)).derivative(0);
    let lies_in_domain = value.enclosure(domain.prec()).lies_inside(domain);
    residual_is_zero && slope.excludes_zero() && lies_in_domain
}

fn residual<T: Field>(weight: SelfWeight, thickness: &T) -> T {
    let at = Configuration { thickness: thickness.clone(), ..Configuration::zero(thickness) };
    Equation::TangencyAtCrown.residual(weight, &at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Magnitude;
    use rug::Float;

    fn around(x: f64) -> Ball {
        Ball::new(Float::with_val(64, x), Magnitude::power_of_two(-5), 64)
    }

    #[test]
    fn a_closed_form_is_believed_only_with_all_three_proofs() {
        let (weight, value) = (SelfWeight::Milankovitch, Surd::new(-6, 4, 3));
        assert!(is_thickness_without_thrust(weight, &value, &around(0.93)));
        assert!(!is_thickness_without_thrust(weight, &value, &around(0.5)), "outside the box");
        assert!(!is_thickness_without_thrust(SelfWeight::Heyman, &value, &around(0.93)), "no root");
        let close = value + Surd::rational((1, 1_000_000_000), 3);
        assert!(!is_thickness_without_thrust(weight, &close, &around(0.93)), "almost a root");
        let other = Surd::new(-6, -4, 3);
        assert!(residual(weight, &other).is_zero(), "the other root of the same equation");
        assert!(!is_thickness_without_thrust(weight, &other, &around(0.93)));
    }
}
