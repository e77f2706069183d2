//! Purely overturning states, (13)–(16): no thrust, the half arch turns about its shoulder.

use super::{Quotient, Ring, SelfWeight};
use crate::number::{Field, Real};

/// Eq. (13): the opening variable `A` at which the half arch just overturns without thrust,
/// `A = 2 fac_M / (2 + eta)`. Its two cases are (14) left and (15) left.
#[inline(always)]
pub fn opening_variable<T: Field>(ring: &Ring<T>) -> Quotient<T> {
    Quotient {
        numerator: ring.thickness.int(2) * &ring.centroid_factor,
        denominator: ring.extrados(),
    }
}

/// The inverse, (14) and (15) right: the thickness at a given `A`, which is at least 2/3 for Milankovitch's weight.
pub fn thickness<T: Real>(weight: SelfWeight, a: &T) -> T {
    match weight {
        SelfWeight::Heyman => heyman(a),
        SelfWeight::Milankovitch => milankovitch(a, &radicand(a).sqrt()),
    }
}

/// Eq. (14) right, `2 (1/A - 1)`.
pub fn heyman<T: Field>(a: &T) -> T {
    a.int(2) / a - a.int(2)
}

/// Eq. (15) right, `3A - q` with `q` the root of the [`radicand`]; the other sign of the root has `eta > 2`.
pub fn milankovitch<T: Field>(a: &T, root: &T) -> T {
    a.int(3) * a - root
}

/// The radicand of (15), `3 (3A² + 4A - 4)`: zero at `A = 2/3`, where `eta = 2`, and positive above.
pub fn radicand<T: Field>(a: &T) -> T {
    a.int(3) * (a.int(3) * a.square() + a.int(4) * a - a.int(4))
}

/// The condition behind Eq. (16), `h_e = 0` at `beta = 0`, cleared of its denominator:
/// `2 - eta - fac_M`, which is zero at the end `l` of the rotational states.
///
/// The paper prints (16) as `1 - eta/(2-eta) (1 + delta_M eta²/12) = 0`. That does not follow from
/// its Eq. (5) and does not have the root it gives; `1 - eta/(2-eta) (1 + delta_M eta/6) = 0` does.
pub fn end_of_rotation<T: Field>(ring: &Ring<T>) -> T {
    ring.intrados() - &ring.centroid_factor
}

/// The thickness `eta_l` at the end of rotation, where [`end_of_rotation`] is zero: 1 for Heyman's weight
/// and `4√3 - 6` for Milankovitch's, in the field of `root_of_three`. The other root is negative.
pub fn thickness_at_end<T: Field>(weight: SelfWeight, root_of_three: &T) -> T {
    match weight {
        SelfWeight::Heyman => root_of_three.int(1),
        SelfWeight::Milankovitch => root_of_three.int(4) * root_of_three - root_of_three.int(6),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{ExactField, Surd};

    #[test]
    fn the_inverse_is_the_inverse() {
        for weight in SelfWeight::ALL {
            for eta in [0.93, 1.2, 1.7] {
                let a = opening_variable(&Ring::new(weight, &eta)).value();
                approx::assert_relative_eq!(thickness(weight, &a), eta, max_relative = 1e-14);
            }
        }
    }

    #[test]
    fn equation_16_as_printed_does_not_hold() {
        let eta = thickness_at_end(SelfWeight::Milankovitch, &Surd::new(0, 1, 3));
        let printed =
            |inner: Surd| eta.int(1) - eta.clone() / (eta.int(2) - &eta) * (eta.int(1) + inner);
        assert!(!printed(eta.square() / eta.int(12)).is_zero());
        assert!(printed(eta.clone() / eta.int(6)).is_zero());
    }

    #[test]
    fn rotation_ends_at_the_closed_form() {
        for weight in SelfWeight::ALL {
            let eta = thickness_at_end(weight, &Surd::new(0, 1, 3));
            assert!(end_of_rotation(&Ring::new(weight, &eta)).is_zero(), "{weight:?}");
            let other = eta.clone() + eta.int(1);
            assert!(!end_of_rotation(&Ring::new(weight, &other)).is_zero(), "false twin");
        }
    }
}
