//! The thrust equations (2)–(5): where a thickness and a thrust make hinges.

use super::{Quotient, Ring, statics};
use crate::number::{Angle, Field};

/// Eq. (2), `h_L`: the thrust that puts the line of thrust on the extrados at the crown and on the
/// intrados at `joint`, from the moments on the part above the joint.
///
/// ```text
/// h = ((2-eta) beta sin(beta) - 2 (1-cos(beta)) fac_M) / (2 + eta - (2-eta) cos(beta))
/// ```
///
/// `joint` is `beta` in `[0, pi)`, `eta` in `(0, 2]`; the denominator is positive there.
///
/// ```
/// use couplet_check::arch::{thrust, Ring, SelfWeight};
/// use couplet_number::number::Angle;
/// // the semicircle (Heyman): eta = 0.107426, beta_r = 0.951141, h = 0.621772
/// let ring = Ring::new(SelfWeight::Heyman, &0.107426);
/// let h = thrust::lower(&Angle::new(0.951141), &ring).value();
/// assert!((h - 0.621772).abs() < 1e-5);
/// ```
pub fn lower<T: Field>(joint: &Angle<T>, ring: &Ring<T>) -> Quotient<T> {
    let weight_moment = ring.intrados() * &joint.rad * &joint.sin
        - ring.thickness.int(2) * joint.versine() * &ring.centroid_factor;
    Quotient {
        numerator: weight_moment,
        denominator: ring.extrados() - ring.intrados() * &joint.cos,
    }
}

/// Eq. (3), `h_U`: the same from the part below the joint, with the shoulder reaction on the
/// extrados.
///
/// ```text
/// h = ((2+eta) alpha sin(alpha) - (2-eta) beta sin(beta) - 2 (cos(beta)-cos(alpha)) fac_M)
///     / ((2-eta) cos(beta) - (2+eta) cos(alpha))
/// ```
///
/// At `beta = 0` it says that the whole half arch turns about the crown's intrados. Undefined where
/// the lever arm in the denominator vanishes.
#[inline(always)]
pub fn upper<T: Field>(half_opening: &Angle<T>, joint: &Angle<T>, ring: &Ring<T>) -> Quotient<T> {
    upper_about(half_opening, ring.intrados() * &joint.rad * &joint.sin, &joint.cos, ring)
}

/// Eq. (3) from `(2 - eta) beta sin(beta)` and `cos(beta)`, through which alone it sees the joint.
#[inline(always)]
pub fn upper_about<T: Field>(
    half_opening: &Angle<T>,
    joint_moment: T,
    cosine: &T,
    ring: &Ring<T>,
) -> Quotient<T> {
    let drop = cosine.clone() - &half_opening.cos;
    let weight_moment = ring.extrados() * &half_opening.rad * &half_opening.sin
        - joint_moment
        - drop * &ring.centroid_factor * ring.thickness.int(2);
    Quotient {
        numerator: weight_moment,
        denominator: ring.intrados() * cosine - ring.extrados() * &half_opening.cos,
    }
}

/// Eq. (4), `h_2`: the thrust from the moments on the whole half arch about the shoulder's extrados,
/// with the crown thrust on the extrados too.
///
/// ```text
/// h = A(alpha) - 2 fac_M / (2 + eta)
/// ```
///
/// `alpha` in `(0, pi)`; the denominator `(1 - cos(alpha)) (2 + eta)` is positive there.
pub fn whole<T: Field>(half_opening: &Angle<T>, ring: &Ring<T>) -> Quotient<T> {
    whole_through(&opening_variable(half_opening), ring)
}

/// Eq. (4) from `A(alpha)`, through which alone it sees the half opening.
pub fn whole_through<T: Field>(opening_variable: &Quotient<T>, ring: &Ring<T>) -> Quotient<T> {
    let Quotient { numerator, denominator } = opening_variable;
    let extrados = ring.extrados();
    Quotient {
        numerator: numerator.clone() * &extrados
            - ring.thickness.int(2) * &ring.centroid_factor * denominator,
        denominator: denominator.clone() * &extrados,
    }
}

/// `A(alpha) = alpha sin(alpha) / (1 - cos(alpha)) = alpha cot(alpha/2)`, beside Eq. (4): the only
/// way in which the half opening enters the rotational equations. It falls from 2 at `alpha = 0` to
/// 0 at `pi`.
#[inline(always)]
pub fn opening_variable<T: Field>(half_opening: &Angle<T>) -> Quotient<T> {
    Quotient {
        numerator: half_opening.rad.clone() * &half_opening.sin,
        denominator: half_opening.versine(),
    }
}

/// The thrust where (2) and (5) hold both, whatever the weight: its moment, `fac_M`, is eliminated.
///
/// ```text
/// h = (2 - eta)/(2 eta) (1 - cos(beta)) (beta/sin(beta) - 1)
/// ```
///
/// The joint enters through `1 - cos(beta)` and `beta/sin(beta) - 1`. The thrust is positive for `beta` in
/// `(0, pi)` and `eta` in `(0, 2)`, and keeps its digits where it falls to zero with the joint, towards the
/// end of rotation, where (2) and (5) lose them.
#[inline(always)]
pub fn touching<T: Field>(versine: &T, excess: &T, ring: &Ring<T>) -> Quotient<T> {
    Quotient {
        numerator: ring.intrados() * versine * excess,
        denominator: ring.thickness.int(2) * &ring.thickness,
    }
}

/// The thickness where (2), (4) and (5) hold all three, whatever the weight: its moment and the thrust are
/// eliminated.
///
/// ```text
/// eta = 2 (W - A)/(W + A),   W = beta/sin(beta) + cos(beta)
/// ```
///
/// `joint` is `beta` in `(0, pi)` and `A` the opening variable, in `(0, 2)`; the denominator is positive
/// there. The thrust is then that of [`touching`].
#[inline(always)]
pub fn rotating<T: Field>(joint: &Angle<T>, opening_variable: &T) -> Quotient<T> {
    let sum = joint.rad.clone() / &joint.sin + &joint.cos;
    Quotient {
        numerator: (sum.clone() - opening_variable) * joint.rad.int(2),
        denominator: sum + opening_variable,
    }
}

/// The thickness where (2) and (5) hold both with a thrust, whatever the weight: [`touching`] solved for it.
///
/// ```text
/// eta = 2 c/(2 h + c),   c = (1 - cos(beta)) (beta/sin(beta) - 1)
/// ```
#[inline(always)]
pub fn touched<T: Field>(versine: &T, excess: &T, thrust: &T) -> Quotient<T> {
    let rise = versine.clone() * excess;
    let two = thrust.int(2);
    Quotient { numerator: rise.clone() * &two, denominator: two * thrust + rise }
}

/// The thickness where (3) and (5) hold both with a thrust, whatever the weight: its moment is eliminated.
///
/// ```text
/// eta = 2 (Q - P)/(Q + P),   Q = N(beta) + (cos(beta) - cos(alpha)) (1 - h + beta cot(beta)),   P = N(alpha)
/// ```
///
/// The joint enters through its cosine, `beta sin(beta)` and `beta cot(beta)`.
#[inline(always)]
pub fn touched_below<T: Field>(
    half_opening: &Angle<T>,
    [cosine, times_sine, times_cotangent]: [&T; 3],
    thrust: &T,
) -> Quotient<T> {
    let normal = thrust.clone() * cosine + times_sine;
    let rise = thrust.int(1) - thrust + times_cotangent;
    let at_joint = normal + (cosine.clone() - &half_opening.cos) * rise;
    let at_shoulder = statics::normal_force(half_opening, thrust);
    Quotient {
        numerator: (at_joint.clone() - &at_shoulder) * thrust.int(2),
        denominator: at_joint + at_shoulder,
    }
}

/// Eq. (5), `h_e`: the thrust at which the line of thrust touches the intrados at `beta` instead of
/// crossing it.
///
/// ```text
/// h = beta cot(beta) + 1 - 2 fac_M / (2 - eta)
/// ```
///
/// The joint enters through `beta cot(beta)` alone ([`Angle::times_cotangent`]), whose value in the
/// limit `beta -> 0` is exactly 1. Undefined at `eta = 2`.
#[inline(always)]
pub fn tangency<T: Field>(times_cotangent: &T, ring: &Ring<T>) -> Quotient<T> {
    let intrados = ring.intrados();
    Quotient {
        numerator: (times_cotangent.int(1) + times_cotangent) * &intrados
            - ring.thickness.int(2) * &ring.centroid_factor,
        denominator: intrados,
    }
}
