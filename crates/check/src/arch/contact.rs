//! Conditions under which a state of the half arch is statically admissible everywhere, and why no thinner
//! arch stands.
//!
//! Let `p = h (1 + e0)`. The moments that must not be negative at a joint `beta` are
//!
//! ```text
//! U(beta) = (1 + eta/2) N - p - fac (1 - cos beta)     distance from the extrados
//! L(beta) = p + fac (1 - cos beta) - (1 - eta/2) N     distance from the intrados
//! ```
//!
//! with `N = h cos beta + beta sin beta`. **Lemma**: `k(beta) = beta cot beta` falls strictly from 1 on
//! `[0, pi)`, since `k' sin² beta = sin beta cos beta - beta < 0`. From
//!
//! ```text
//! U' = sin beta [(1 + eta/2) (1 - h + k) - fac]
//! L' = sin beta [fac - (1 - eta/2) (1 - h + k)]
//! N' = sin beta [1 - h + k]
//! (T/N)' N² = h (1 - h) - beta²
//! ```
//!
//! each of them changes its direction at most once on `(0, pi)`: `U` and `N` first grow and then fall,
//! so that they are least at the crown or at the shoulder; `L` (for `eta <= 2`) first falls and then
//! grows, so that a joint where `L = 0` and `L' = 0` is where it is least, and it is least at the crown
//! if `L' >= 0` there; `T/N` is largest at `beta_s` and least at the shoulder. **Admissibility on the
//! whole half arch therefore comes down to a handful of signs**, and no subdivision is needed.
//!
//! **Least thickness.** In `(h, p)` these conditions are linear. Positive multipliers of the three that
//! hold with equality, chosen so that `h` and `p` drop out, make a combination that is zero at the
//! thickness of the state. At a thinner `eta'` it is, for any admissible `(h', p')`, at most
//!
//! ```text
//! -(eta - eta') [ W/2 + delta_M (eta + eta')/12 (b (1 - cos beta) - c (1 - cos alpha)) ]
//! ```
//!
//! where `b`, `c` are the multipliers of `L` at `beta` and of `U` at `alpha`, and `W` is a lower bound
//! of the sum of the multipliers times `N'` over the states that friction allows. If the bracket is
//! positive at `eta' = eta`, and `W` is, it is positive for all `eta' < eta`: the combination would be
//! negative though each of its parts is not, so that **no thinner arch has an admissible state**.
//!
//! **Thicker arches stand.** At a fixed thrust the gap that is left for `p` between the shoulder's
//! extrados and the intrados is the least over all joints of
//! `(1 + eta/2) N(alpha) - (1 - eta/2) N(beta) - fac (cos beta - cos alpha)`, each concave in `eta`, so
//! that the gap is concave in `eta`; at `eta = 2` it is `2 N(alpha) - fac (1 - cos alpha)`
//! ([`margin_at_physical_limit`]). If that is positive, the gap stays open from the least thickness up
//! to 2. The gap at the crown's extrados grows with `eta`, and friction does not see it. So an arch
//! stands **exactly** from its least thickness on.
//!
//! **No thickness is enough.** If that margin is negative at the least thrust that friction allows, no
//! arch up to `eta = 2` stands. It is negative only if `cos alpha < 0` (else `A >= pi/2`), so that a
//! larger thrust makes `N(alpha)` smaller; `p` cannot be negative; and with `n = N(alpha)/(1 - cos
//! alpha)` the function `(1 + eta/2) n - 1 - delta_M eta²/12` is, for Heyman's weight, linear in `eta`
//! and negative at 0 and 2 (`n < 1/2`), and for Milankovitch's, with `n < 2/3`, at most its value
//! `(3n² + 4n - 4)/4 < 0` at the top `eta = 3n`.
//!
//! **The mode is unique.** At the least thickness the combination is zero for every admissible `(h, p)`,
//! and its multipliers are positive: each of the three conditions holds with equality. They fix `h` and
//! `p`, and (5) the joint, as `k` is strictly monotone. So any two states that are proved are the same, and
//! the signs that are strict for one mode and zero for another (friction at the shoulder, friction inside,
//! the extrados at crown and shoulder, the slope at the crown, the order of the joints) leave one mode. A
//! proved state therefore needs no comparison with those that it is not.
//!
//! The multipliers are the rates of the collapse mechanism: the rotations at the hinges, and for a
//! sliding joint the horizontal part of the slip. [`mechanism`](super::mechanism) has the motion.

use super::{Configuration, Ring, SelfWeight, statics};
use crate::number::{Angle, Field};

/// `U` at the shoulder for the crown moment `p`.
#[inline(always)]
pub fn extrados_margin_at_shoulder<T: Field>(
    weight: SelfWeight,
    at: &Configuration<T>,
    crown_moment: &T,
) -> T {
    shoulder_moment(weight, at) - crown_moment
}

/// `L` at a joint for the crown moment `p`: `p + fac (1 - cos beta) - (1 - eta/2) N(beta)`.
pub fn intrados_margin<T: Field>(
    weight: SelfWeight,
    joint: &Angle<T>,
    at: &Configuration<T>,
    crown_moment: &T,
) -> T {
    let ring = Ring::new(weight, &at.thickness);
    let normal = statics::normal_force(joint, &at.thrust);
    joint.versine() * &ring.centroid_factor + crown_moment
        - ring.intrados() * normal / at.thrust.int(2)
}

/// `L'` at a joint below the crown, `fac sin beta - (1 - eta/2) ((1 - h) sin beta + beta cos beta)`: negative where the
/// line of thrust still comes nearer to the intrados.
pub fn approach<T: Field>(weight: SelfWeight, joint: &Angle<T>, at: &Configuration<T>) -> T {
    let ring = Ring::new(weight, &at.thickness);
    let rest = at.thrust.int(1) - &at.thrust;
    let rise = rest * &joint.sin + joint.rad.clone() * &joint.cos;
    ring.centroid_factor.clone() * &joint.sin - ring.intrados() * rise / at.thrust.int(2)
}

/// The crown moment `p` that puts the pressure point on the extrados of the shoulder:
/// `(1 + eta/2) N(alpha) - fac (1 - cos alpha)`.
#[inline(always)]
pub fn shoulder_moment<T: Field>(weight: SelfWeight, at: &Configuration<T>) -> T {
    let ring = Ring::new(weight, &at.thickness);
    let normal = statics::normal_force(&at.half_opening, &at.thrust);
    ring.extrados() * normal / at.thrust.int(2) - at.half_opening.versine() * ring.centroid_factor
}

/// The crown moment `p` that puts the pressure point on the extrados of the crown: `(1 + eta/2) h`.
#[inline(always)]
pub fn crown_moment<T: Field>(at: &Configuration<T>) -> T {
    (at.thickness.int(2) + &at.thickness) * &at.thrust / at.thrust.int(2)
}

/// `L' / sin beta` at the crown, `fac - (1 - eta/2) (2 - h)`: not negative where the moment `L` about
/// the intrados is least at the crown.
#[inline(always)]
pub fn crown_slope<T: Field>(weight: SelfWeight, at: &Configuration<T>) -> T {
    let ring = Ring::new(weight, &at.thickness);
    let rest = at.thrust.int(2) - &at.thrust;
    ring.centroid_factor.clone() - ring.intrados() * rest / at.thrust.int(2)
}

/// The moment about the shoulder's extrados with the crown's pressure point at the centre, at the
/// physical limit `eta = 2`: `2 N(alpha) - fac (1 - cos alpha)`. Where it is negative with the least
/// thrust that friction allows, no thickness up to the limit is enough.
#[inline(always)]
pub fn margin_at_physical_limit<T: Field>(weight: SelfWeight, at: &Configuration<T>) -> T {
    let ring = Ring::new(weight, &at.thrust.int(2));
    let normal = statics::normal_force(&at.half_opening, &at.thrust);
    normal * at.thrust.int(2) - at.half_opening.versine() * ring.centroid_factor
}

/// Multipliers of the three conditions that hold with equality: the rates of the mechanism.
#[derive(Clone, Debug)]
pub struct Rates<T> {
    /// Rotation at the crown: multiplier of `U` there.
    pub crown: T,
    /// Rotation at the rotational joint: multiplier of `L` there.
    pub haunch: T,
    /// Rotation at the shoulder: multiplier of `U` there.
    pub shoulder: T,
    /// Multiplier of the friction condition on the thrust.
    pub sliding: T,
}

/// The lever arm of `h` between the haunch's intrados and the crown's extrados, `(1 + eta/2) cos b0 -
/// (1 - eta/2) cos beta` with `b0` zero but beside a keystone, and between the shoulder's extrados and the haunch's
/// intrados, `(1 - eta/2) cos beta - (1 + eta/2) cos alpha`.
#[inline(always)]
fn arms<T: Field>(at: &Configuration<T>) -> (T, T) {
    let two = at.thickness.int(2);
    let (inner, outer) = (two.clone() - &at.thickness, two.clone() + &at.thickness);
    let haunch = inner * &at.rotation_joint.cos;
    let upper = (outer.clone() * &at.crown_hinge.cos - &haunch) / &two;
    let lower = (haunch - outer * &at.half_opening.cos) / two;
    (upper, lower)
}

/// The rates of the mode `[r,r,r]`, with rotation one at the crown.
#[inline(always)]
pub fn rates_of_rotation<T: Field>(at: &Configuration<T>) -> Rates<T> {
    let (upper, lower) = arms(at);
    let shoulder = upper / lower;
    let one = shoulder.int(1);
    Rates { haunch: one.clone() + &shoulder, crown: one.clone(), shoulder, sliding: one.int(0) }
}

/// The rates of the mode `[s,r,r]`, with rotation one at the crown.
#[inline(always)]
pub fn rates_of_shoulder_sliding<T: Field>(at: &Configuration<T>) -> Rates<T> {
    let (sliding, _) = arms(at);
    let one = sliding.int(1);
    Rates { crown: one.clone(), haunch: one.clone(), shoulder: one.int(0), sliding }
}

/// The rates of the modes with a sliding inner joint, with rotation one at the shoulder.
#[inline(always)]
pub fn rates_of_inner_sliding<T: Field>(at: &Configuration<T>) -> Rates<T> {
    let (_, sliding) = arms(at);
    let one = sliding.int(1);
    Rates { crown: one.int(0), haunch: one.clone(), shoulder: one, sliding }
}

/// `W` with the thrust left out: the multipliers times `beta sin beta` at their joints. With
/// [`thrust_coefficient`] times a thrust it is `W` for that thrust.
#[inline(always)]
pub fn weight_term<T: Field>(rates: &Rates<T>, at: &Configuration<T>) -> T {
    let (haunch, shoulder) = (&at.rotation_joint, &at.half_opening);
    rates.haunch.clone() * &haunch.rad * &haunch.sin
        + rates.shoulder.clone() * &shoulder.rad * &shoulder.sin
}

/// Addition of a thrust to `W`: the multipliers times the cosines of their joints.
#[inline(always)]
pub fn thrust_coefficient<T: Field>(rates: &Rates<T>, at: &Configuration<T>) -> T {
    rates.crown.clone()
        + rates.haunch.clone() * &at.rotation_joint.cos
        + rates.shoulder.clone() * &at.half_opening.cos
}

/// The bracket above at `eta' = eta` for a given `W`.
#[inline(always)]
pub fn growth<T: Field>(
    weight: SelfWeight,
    rates: &Rates<T>,
    at: &Configuration<T>,
    normal_term: &T,
) -> T {
    let drop = rates.haunch.clone() * at.rotation_joint.versine()
        - rates.shoulder.clone() * at.half_opening.versine();
    let centroid = at.thickness.int(weight.flag()) * &at.thickness * drop / at.thickness.int(6);
    normal_term.clone() / at.thickness.int(2) + centroid
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Dual;
    use rug::Rational;

    type Exact = Rational;

    fn at() -> Configuration<Exact> {
        Configuration::rational()
    }

    /// `U` and `L` at a joint, for any thrust and crown moment.
    fn conditions(
        joint: &Angle<Exact>,
        ring: &Ring<Exact>,
        h: &Exact,
        p: &Exact,
    ) -> (Exact, Exact) {
        let normal = statics::normal_force(joint, h);
        let moment = Exact::from(p + joint.versine() * ring.centroid_factor.clone());
        let half = |x: Exact| x * normal.clone() / Exact::from(2);
        (half(ring.extrados()) - &moment, moment.clone() - half(ring.intrados()))
    }

    /// In each combination `h` and `p` drop out, and its change with the thickness is the bracket.
    #[test]
    fn the_combinations_are_free_of_thrust_and_moment() {
        let (at, weight) = (at(), SelfWeight::Milankovitch);
        let ring = Ring::new(weight, &at.thickness);
        let crown = Angle::zero(&at.thrust);
        // The friction conditions h_mu - h >= 0 and h - h_is >= 0 with their slopes to h.
        let cases = [
            (rates_of_rotation(&at), 0),
            (rates_of_shoulder_sliding(&at), -1),
            (rates_of_inner_sliding(&at), 1),
        ];
        for (rates, friction) in cases {
            let combination = |h: &Exact, p: &Exact, ring: &Ring<Exact>| {
                rates.crown.clone() * conditions(&crown, ring, h, p).0
                    + rates.haunch.clone() * conditions(&at.rotation_joint, ring, h, p).1
                    + rates.shoulder.clone() * conditions(&at.half_opening, ring, h, p).0
                    + rates.sliding.clone() * Exact::from(friction) * h
            };
            let value = |h: i32, p: i32| combination(&h.into(), &p.into(), &ring);
            assert_eq!(value(0, 0), value(1, 0), "free of h");
            assert_eq!(value(0, 0), value(0, 1), "free of p");
            // The change from eta to a thinner eta', exactly as the module says.
            let (thin, h, p) = (Exact::from((1, 4)), Exact::from((1, 5)), Exact::from((2, 7)));
            let change =
                combination(&h, &p, &Ring::new(weight, &thin)) - combination(&h, &p, &ring);
            let w = weight_term(&rates, &at) + thrust_coefficient(&rates, &at) * h;
            let mean =
                Configuration { thickness: Exact::from(&at.thickness + &thin) / 2, ..at.clone() };
            let bracket = growth(weight, &rates, &mean, &w);
            assert_eq!(change, bracket * Exact::from(&thin - &at.thickness));
        }
    }

    /// The derivatives that the lemma is about.
    #[test]
    fn the_derivatives_have_the_factors_stated() {
        let (at, weight) = (at(), SelfWeight::Milankovitch);
        let ring = Ring::new(weight, &at.thickness);
        let joint = at.rotation_joint.variable(0);
        let h = Dual::constant(at.thrust.clone());
        let normal = statics::normal_force(&joint, &h);
        let lowered = Dual::constant(ring.centroid_factor.clone()) * joint.versine();
        let rise = Exact::from(1) - &at.thrust + at.rotation_joint.times_cotangent();
        let sin = at.rotation_joint.sin.clone();
        assert_eq!(normal.derivative(0), sin.clone() * &rise);
        let half = Dual::constant(ring.extrados() / Exact::from(2));
        let upper = half * &normal - &lowered;
        let expected = ring.extrados() / Exact::from(2) * rise - &ring.centroid_factor;
        assert_eq!(upper.derivative(0), expected * sin);
        let lower = intrados_margin(
            weight,
            &joint,
            &at.clone().map(Dual::constant),
            &Dual::constant(Exact::from((2, 7))),
        );
        assert_eq!(lower.derivative(0), approach(weight, &at.rotation_joint, &at));
        let (k, squared) =
            (joint.times_cotangent().derivative(0), Field::square(&at.rotation_joint.sin));
        let joint = &at.rotation_joint;
        assert_eq!(k * squared, joint.sin.clone() * &joint.cos - &joint.rad);
    }
}
