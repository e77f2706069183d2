//! The algebra of the equations, exactly: rational points of the unit circle, rational thickness.

use crate::hard::{circle_point, config, positive_rational, weights};
use couplet::arch::{Quotient, Ring, SelfWeight, cubic, overturning, sliding, statics, thrust};
use couplet::number::{Angle, Dual, Field};
use couplet::symbolic::{Letters, Notation, Symbol};
use proptest::prelude::*;
use rug::Rational;

type Exact = Rational;

fn angle((sin, cos): (Exact, Exact), rad: Exact) -> Angle<Exact> {
    Angle { rad, sin, cos }
}

fn value(quotient: &Quotient<Exact>) -> Option<Exact> {
    (quotient.denominator != 0).then(|| quotient.value())
}

proptest! {
    #![proptest_config(config(300))]

    /// (2) and (4) together imply (3): with the half opening that makes the thrusts of (2) and (4)
    /// equal, (3) gives that thrust too.
    #[test]
    fn upper_thrust_follows_from_lower_and_whole(
        weight in weights(), joint in circle_point(), beta in positive_rational(),
        shoulder in circle_point(), eta in positive_rational(),
    ) {
        let (joint, ring) = (angle(joint, beta), Ring::new(weight, &eta));
        let Some(h) = value(&thrust::lower(&joint, &ring)) else { return Ok(()) };
        // (4) solved for alpha, which enters it linearly when sine and cosine are given.
        let (sin, cos) = shoulder;
        let opening = h.clone() + overturning::opening_variable(&ring).value();
        let alpha = opening * (Exact::from(1) - &cos) / &sin;
        let shoulder = angle((sin, cos), alpha);
        prop_assert_eq!(thrust::whole(&shoulder, &ring).residual(&h), Exact::new());
        let upper = thrust::upper(&shoulder, &joint, &ring);
        prop_assert_eq!(upper.residual(&h), Exact::new());
        let other = Ring { centroid_factor: ring.centroid_factor.clone() + Exact::from(1), ..ring };
        let twin = thrust::upper(&shoulder, &joint, &other).residual(&h);
        prop_assert!(twin != 0 || joint.cos == shoulder.cos, "false twin");
    }

    /// (2) and (5) have one thrust in common, whatever the weight: with the centroid factor that gives (5)
    /// this thrust, (2) gives it too.
    #[test]
    fn the_touching_thrust_is_that_of_lower_and_tangency(
        joint in circle_point(), beta in positive_rational(), eta in positive_rational(),
    ) {
        let joint = angle(joint, beta);
        let ring = Ring::new(SelfWeight::Heyman, &eta);
        let excess = joint.rad.clone() / &joint.sin - Exact::from(1);
        let Some(h) = value(&thrust::touching(&joint.versine(), &excess, &ring)) else {
            return Ok(());
        };
        let cotangent = joint.times_cotangent();
        let factor = |h: &Exact| (Exact::from(1) + &cotangent - h) * ring.intrados() / Exact::from(2);
        let with = |h: &Exact| Ring { centroid_factor: factor(h), ..ring.clone() };
        prop_assert_eq!(thrust::tangency(&cotangent, &with(&h)).residual(&h), Exact::new());
        prop_assert_eq!(thrust::lower(&joint, &with(&h)).residual(&h), Exact::new());
        let twin = h.clone() + Exact::from(1);
        prop_assert_ne!(thrust::lower(&joint, &with(&twin)).residual(&twin), Exact::new());
    }

    /// (2), (4) and (5) have one thickness in common, whatever the weight.
    #[test]
    fn the_rotating_thickness_is_that_of_all_three(
        joint in circle_point(), beta in positive_rational(), opening in positive_rational(),
    ) {
        let joint = angle(joint, beta);
        let Some(eta) = value(&thrust::rotating(&joint, &opening)) else { return Ok(()) };
        let excess = joint.rad.clone() / &joint.sin - Exact::from(1);
        // With the centroid factor that gives (5) the touching thrust, (2) holds; what is left is (4).
        let whole = |eta: &Exact| {
            let ring = Ring::new(SelfWeight::Heyman, eta);
            let h = value(&thrust::touching(&joint.versine(), &excess, &ring))?;
            let cotangent = joint.times_cotangent();
            let centroid_factor = (Exact::from(1) + &cotangent - &h) * ring.intrados() / Exact::from(2);
            let ring = Ring { centroid_factor, ..ring };
            Some(overturning::opening_variable(&ring).residual(&(opening.clone() - h)))
        };
        if let Some(residual) = whole(&eta) {
            prop_assert_eq!(residual, Exact::new());
        }
        if let Some(twin) = whole(&(eta.clone() + Exact::from(1))) {
            prop_assert_ne!(twin, Exact::new(), "false twin");
        }
    }

    /// The thrust of (2) puts the pressure point on the extrados at the crown and on the intrados at
    /// the joint; that of (4) puts it on the extrados at both ends.
    #[test]
    fn moments_and_statics_agree(
        weight in weights(), joint in circle_point(), beta in positive_rational(), eta in positive_rational(),
    ) {
        let (joint, ring) = (angle(joint, beta), Ring::new(weight, &eta));
        let half = eta.clone() / Exact::from(2);
        let eccentricity = |h: &Exact| {
            (statics::normal_force(&joint, h) != 0)
                .then(|| statics::eccentricity(&joint, h, &half, &ring.centroid_factor))
        };
        if let Some(e) = value(&thrust::lower(&joint, &ring)).and_then(|h| eccentricity(&h)) {
            prop_assert_eq!(&e, &-half.clone());
        }
        if let Some(e) = value(&thrust::whole(&joint, &ring)).and_then(|h| eccentricity(&h)) {
            prop_assert_eq!(&e, &half);
        }
    }

    /// (5) is the tangency: where the pressure point lies on the intrados with the thrust of (5), the
    /// derivative of the eccentricity is zero.
    #[test]
    fn tangency_is_a_stationary_eccentricity(
        weight in weights(), joint in circle_point(), beta in positive_rational(), eta in positive_rational(),
    ) {
        let (joint, ring) = (angle(joint, beta), Ring::new(weight, &eta));
        let Some(h) = value(&thrust::tangency(&joint.times_cotangent(), &ring)) else { return Ok(()) };
        if h == 0 || statics::normal_force(&joint, &h) == 0 { return Ok(()) }
        // The crown eccentricity that brings the pressure point at the joint to the intrados.
        let half = eta / Exact::from(2);
        let moment = (Exact::from(1) - &half) * statics::normal_force(&joint, &h)
            - joint.versine() * &ring.centroid_factor;
        let crown = moment / &h - Exact::from(1);
        let e = |h: &Exact, crown: &Exact| {
            statics::eccentricity(
                &joint.variable(0),
                &Dual::constant(h.clone()),
                &Dual::constant(crown.clone()),
                &Dual::constant(ring.centroid_factor.clone()),
            )
        };
        let touching = e(&h, &crown);
        prop_assert_eq!(touching.value(), &-half);
        prop_assert_eq!(touching.derivative(0), Exact::new());
    }

    /// The three cubics (7) of Milankovitch's weight share the state of (2), (4), (5): where the one
    /// in thickness is zero, so are the others, at the thrust of (5) and the `A` of (4). The thickness
    /// is made a root by choosing `beta`, which enters linearly.
    #[test]
    fn the_cubics_have_a_common_state(point in circle_point(), eta in positive_rational()) {
        let one = Exact::from(1);
        // in_thickness is linear in beta when sine and cosine are given.
        let at = |beta: Exact| cubic::in_thickness(&cubic::abbreviations(&angle(point.clone(), beta)), &one, &eta);
        let (start, slope) = (at(Exact::new()), at(one.clone()) - at(Exact::new()));
        if slope == 0 || start == 0 || eta == 2 { return Ok(()) }
        let joint = angle(point.clone(), -start / slope);
        prop_assert_eq!(cubic::in_thickness(&cubic::abbreviations(&joint), &one, &eta), Exact::new());
        let ring = Ring::new(SelfWeight::Milankovitch, &eta);
        let h = thrust::tangency(&joint.times_cotangent(), &ring).value();
        let a = h.clone() + overturning::opening_variable(&ring).value();
        prop_assert_eq!(cubic::in_thrust(&cubic::abbreviations(&joint), &one, &h), Exact::new());
        prop_assert_eq!(cubic::in_opening_variable(&cubic::abbreviations(&joint), &one, &a), Exact::new());
        prop_assert!(cubic::in_thrust(&cubic::abbreviations(&joint), &one, &(h + &one)) != 0, "false twin");
        prop_assert!(cubic::in_opening_variable(&cubic::abbreviations(&joint), &one, &(a - &one)) != 0, "false twin");
    }

    /// Heyman's model is the same code with `delta_M = 0`.
    #[test]
    fn heyman_is_the_case_delta_zero(joint in circle_point(), beta in positive_rational(), eta in positive_rational()) {
        let (joint, zero) = (angle(joint, beta), Exact::new());
        let (named, flagged) = (Ring::new(SelfWeight::Heyman, &eta), Ring::with_flag(&zero, &eta));
        prop_assert_eq!(&named.centroid_factor, &flagged.centroid_factor);
        prop_assert_eq!(&named.centroid_factor, &Exact::from(1));
        let f = cubic::abbreviations(&joint).f;
        let quadratic = cubic::in_thickness(&cubic::abbreviations(&joint), &zero, &eta);
        let g = cubic::abbreviations(&joint).g;
        let (a, b, c) = ((f.clone() + &g) * Exact::from(3), (g.clone() - &joint.sin) * Exact::from(-12), (g - f) * Exact::from(12));
        prop_assert_eq!(quadratic, (a.clone() * &eta + &b) * &eta + &c);
        let discriminant = Field::square(&b) - a.clone() * c * Exact::from(4);
        // Its radicand is the Heyman discriminant times a square factor of known sign.
        let radicand = cubic::radicand(&cubic::abbreviations(&joint), &zero);
        prop_assert_eq!(radicand * Exact::from(-432), Field::square(&a) * discriminant);
    }

    /// (17) and (18) are `|T| = mu N` at their joints.
    #[test]
    fn sliding_is_the_friction_of_the_statics(point in circle_point(), alpha in positive_rational(), h in positive_rational()) {
        let shoulder = angle(point, alpha);
        let Some(mu) = value(&sliding::shoulder(&shoulder, &h)) else { return Ok(()) };
        let (shear, normal) = (statics::shear_force(&shoulder, &h), statics::normal_force(&shoulder, &h));
        prop_assert_eq!(-shear, mu.clone() * normal);
        if let Some(back) = value(&sliding::shoulder_thrust(&shoulder, &mu)) {
            prop_assert_eq!(back, h);
        }
    }

    /// `T/N` is stationary where `beta² = h (1 - h)`: its derivative has that factor.
    #[test]
    fn the_sliding_joint_is_the_steepest(point in circle_point(), h in positive_rational(), beta in positive_rational()) {
        let joint = angle(point, beta.clone());
        let (dual, thrust) = (joint.variable(0), Dual::constant(h.clone()));
        let (shear, normal) = (statics::shear_force(&dual, &thrust), statics::normal_force(&dual, &thrust));
        if *normal.value() == 0 { return Ok(()) }
        let slope = (shear / &normal).derivative(0);
        let steepness = -sliding::steepest(&beta, &h) / Field::square(normal.value());
        prop_assert_eq!(slope, steepness);
    }
}

#[test]
fn the_cubic_reads_as_in_the_paper() {
    let delta = Symbol::Flag.number();
    let cubic = cubic::in_thickness(
        &cubic::abbreviations(&Symbol::joint()),
        &delta,
        &Symbol::Thickness.number(),
    );
    let cubic = cubic.as_polynomial().unwrap();
    assert_eq!(
        cubic.show_by(Symbol::Thickness, Notation::Text),
        "S delta eta^3 + 3 (beta C + beta + S C + S) eta^2 - 12 (beta + S C - S) eta \
         - 12 (beta C - beta - S C + S)"
    );
    let latex = cubic.show_by(Symbol::Thickness, Notation::Latex);
    assert!(latex.starts_with(r"S \delta_M {\eta}^{3} + 3 (\beta C"), "{latex}");
}
