//! The certified landmarks against everything they were not computed from.

mod second_arithmetic;

use couplet::arch::{
    Configuration, Ring, SelfWeight, Unknown, cubic, overturning, sliding, statics, thrust,
};
use couplet::certify::CertifiedLandmark;
use couplet::number::{Angle, Ball, Dual, Enclosure, Field, Ternary};
use couplet::problem::{Equation, Landmark};
use rug::Float;

const BITS: u32 = 400;

fn certified(landmark: Landmark, weight: SelfWeight) -> CertifiedLandmark {
    CertifiedLandmark::new(landmark, weight).unwrap()
}

fn at(landmark: Landmark, weight: SelfWeight) -> Configuration<Ball> {
    certified(landmark, weight).enclosure(BITS).unwrap().configuration().clone()
}

/// Whether a ball holds zero and is so narrow that this says something.
fn is_zero(x: &Ball) -> bool {
    let narrow = Ball::new(Float::new(32), x.rad(), 64).is_less_than(&tiny());
    x.overlaps(&x.int(0)) && narrow == Ternary::True
}

fn tiny() -> Ball {
    Ball::exact(Float::with_val(64, 1) >> 350, 64)
}

fn half<T: Field>(x: &T) -> T {
    x.clone() / x.int(2)
}

/// What holds at a landmark besides the equations that define it.
#[test]
fn landmarks_satisfy_the_equations_they_are_not_defined_by() {
    for weight in SelfWeight::ALL {
        let besides: [(Landmark, &[Equation]); 4] = [
            (Landmark::Triple, &[Equation::UpperThrust]),
            (Landmark::WidestJoint, &[Equation::UpperThrust]),
            // At l, (2) and (3) hold in the limit too; there the joint is at the crown.
            (Landmark::RotationEnd, &[Equation::LowerThrust, Equation::UpperThrust]),
            (Landmark::OverturningEnd, &[Equation::UpperThrust]),
        ];
        for (landmark, equations) in besides {
            let at = at(landmark, weight);
            for equation in equations {
                let residual = equation.residual(weight, &at);
                assert!(is_zero(&residual), "{landmark:?} {weight:?} {equation:?} {residual:?}");
            }
        }
        // And what does not hold: B is beyond tangency, S and J are not purely rotational.
        let border = at(Landmark::Border, weight);
        assert!(Equation::TangencyAtCrown.residual(weight, &border).excludes_zero());
        for landmark in [Landmark::Shift, Landmark::Junction] {
            let residual = Equation::WholeThrust.residual(weight, &at(landmark, weight));
            assert!(residual.excludes_zero(), "{landmark:?} {weight:?}");
        }
    }
}

#[test]
fn the_cubics_and_the_radicand_vanish_where_they_should() {
    for weight in SelfWeight::ALL {
        for landmark in [Landmark::Triple, Landmark::WidestJoint] {
            let at = at(landmark, weight);
            let delta = at.thrust.int(weight.flag());
            let joint = &at.rotation_joint;
            let letters = cubic::abbreviations(joint);
            assert!(is_zero(&cubic::in_thickness(&letters, &delta, &at.thickness)));
            let radicand = cubic::radicand(&letters, &delta);
            if landmark == Landmark::WidestJoint {
                assert!(is_zero(&radicand), "{weight:?}");
                // A simple zero in beta: it changes sign there.
                let along = cubic::abbreviations(&joint.variable(0));
                let slope = cubic::radicand(&along, &Dual::constant(delta.clone())).derivative(0);
                assert!(slope.excludes_zero());
            } else {
                assert_eq!(radicand.is_positive(), Ternary::False, "real branches at T");
                assert!(radicand.excludes_zero());
            }
            let a = thrust::opening_variable(&at.half_opening).value();
            assert!(is_zero(&cubic::in_opening_variable(&letters, &delta, &a)));
            assert!(is_zero(&cubic::in_thrust(&letters, &delta, &at.thrust)));
        }
    }
}

/// At `sb` the joint is stationary along the branch: from (2) = (5), `d beta/d eta = 0`, while the
/// thickness goes on growing with the opening.
#[test]
fn the_widest_joint_is_stationary() {
    for weight in SelfWeight::ALL {
        let at = at(Landmark::WidestJoint, weight);
        let joint = at.rotation_joint.variable(0);
        let ring = Ring::new(weight, &Dual::variable(at.thickness.clone(), 1));
        let tangency = thrust::tangency(&joint.times_cotangent(), &ring).value();
        let gap = thrust::lower(&joint, &ring).value() - tangency;
        assert!(gap.derivative(0).excludes_zero(), "d/d beta");
        assert!(is_zero(&gap.derivative(1)), "d/d eta");
    }
}

/// Statics as an independent route: where the line of thrust touches, and where the friction is used.
#[test]
fn the_line_of_thrust_touches_where_the_equations_say() {
    for weight in SelfWeight::ALL {
        for landmark in [Landmark::Triple, Landmark::WidestJoint] {
            let at = at(landmark, weight);
            let fac = Ring::new(weight, &at.thickness).centroid_factor;
            let edge = half(&at.thickness);
            let e = |joint: &Angle<Ball>| statics::eccentricity(joint, &at.thrust, &edge, &fac);
            assert!(is_zero(&(e(&at.rotation_joint) + &edge)), "intrados at the joint");
            assert!(is_zero(&(e(&at.half_opening) - &edge)), "extrados at the shoulder");
            let slope = statics::eccentricity(
                &at.rotation_joint.variable(0),
                &Dual::constant(at.thrust.clone()),
                &Dual::constant(edge.clone()),
                &Dual::constant(fac.clone()),
            )
            .derivative(0);
            assert!(is_zero(&slope), "touching, not crossing");
        }
        for landmark in [Landmark::Triple, Landmark::Shift, Landmark::Junction, Landmark::Border] {
            let at = at(landmark, weight);
            let ratio = |joint: &Angle<Ball>| {
                statics::shear_force(joint, &at.thrust) / statics::normal_force(joint, &at.thrust)
            };
            assert!(is_zero(&(ratio(&at.sliding_joint) - &at.friction)), "inner sliding");
            assert!(is_zero(&(ratio(&at.half_opening) + &at.friction)), "shoulder sliding");
            let largest = sliding::shoulder_thrust(&at.half_opening, &at.friction).value();
            assert!(is_zero(&(largest - &at.thrust)), "(17) right");
        }
    }
}

/// At S and J the pressure point lies on the shoulder's extrados and on the intrados at the joint;
/// the crown's follows from the moments on the whole half arch.
#[test]
fn shift_and_junction_have_their_hinges() {
    for weight in SelfWeight::ALL {
        for landmark in [Landmark::Shift, Landmark::Junction, Landmark::Border] {
            let at = at(landmark, weight);
            let fac = Ring::new(weight, &at.thickness).centroid_factor;
            let edge = half(&at.thickness);
            // 1 + e0 from the pressure point at the shoulder's extrados.
            let moment = (edge.int(1) + &edge)
                * statics::normal_force(&at.half_opening, &at.thrust)
                - at.half_opening.versine() * &fac;
            let crown = moment / &at.thrust - edge.int(1);
            let e = statics::eccentricity(&at.rotation_joint, &at.thrust, &crown, &fac);
            assert!(is_zero(&(e + &edge)), "{landmark:?} {weight:?}");
        }
    }
}

#[test]
fn overturning_starts_at_l_and_ends_at_big_l() {
    for weight in SelfWeight::ALL {
        for landmark in [Landmark::RotationEnd, Landmark::OverturningEnd] {
            let at = at(landmark, weight);
            let a = thrust::opening_variable(&at.half_opening).value();
            let from_thickness = overturning::opening_variable(&Ring::new(weight, &at.thickness));
            assert!(is_zero(&(from_thickness.value() - &a)), "(13)");
            // At L of Milankovitch's weight the root in (15) is zero: no ball around it has one.
            if (landmark, weight) != (Landmark::OverturningEnd, SelfWeight::Milankovitch) {
                let eta = overturning::thickness(weight, &a);
                assert!(is_zero(&(eta - &at.thickness)), "(14), (15)");
            }
        }
    }
    let l = at(Landmark::RotationEnd, SelfWeight::Heyman).half_opening.rad;
    let big_l = at(Landmark::OverturningEnd, SelfWeight::Milankovitch).half_opening.rad;
    assert!(is_zero(&(l - &big_l)), "alpha_l of Heyman is alpha_L of Milankovitch");
}

/// The formulations at `beta_r -> 0` agree with the plain ones nearby: the plain system with a small
/// fixed joint has a solution that approaches `l` and `J` like `beta²`.
#[test]
fn degenerate_formulations_are_limits_of_the_plain_ones() {
    for weight in SelfWeight::ALL {
        for landmark in [Landmark::RotationEnd, Landmark::Junction] {
            let limit = at(landmark, weight);
            for shift in [5u32, 10, 20, 40] {
                let beta = Float::with_val(BITS, 1) >> shift;
                let near = plain_nearby(landmark, weight, &limit, &beta);
                let distance = Float::with_val(64, &near - limit.half_opening.rad.mid()).abs();
                let ratio = Float::with_val(64, distance / beta.clone().square());
                assert!(ratio < 1 && ratio > 1e-3, "{landmark:?} {weight:?} {shift}: {ratio}");
            }
        }
    }
}

/// The half opening of the plain system (2), (4), (5) at `l` or (3), (5), (17), (18) at `J`, with
/// the joint fixed at `beta`: Newton's method in MPFR, from the limit.
fn plain_nearby(
    landmark: Landmark,
    weight: SelfWeight,
    limit: &Configuration<Ball>,
    beta: &Float,
) -> Float {
    use Equation::*;
    let joint = Angle::new(beta.clone());
    let mid = |x: &Ball| Float::with_val(BITS, x.mid());
    let equations: &[Equation] = match landmark {
        Landmark::RotationEnd => &[LowerThrust, WholeThrust, Tangency],
        _ => &[UpperThrust, ShoulderSliding, InnerSliding, Steepest, Tangency],
    };
    // Unknowns alpha, eta, h and, for J, mu and beta_s.
    let mut x = vec![mid(&limit.half_opening.rad), mid(&limit.thickness), mid(&limit.thrust)];
    if landmark == Landmark::Junction {
        x.extend([mid(&limit.friction), mid(&limit.sliding_joint.rad)]);
    }
    for _ in 0..12 {
        let dual = |index: usize| Dual::variable(x[index].clone(), index);
        let zero = Dual::constant(Float::new(BITS));
        let optional = |index: usize| if index < x.len() { dual(index) } else { zero.clone() };
        let at = Configuration {
            half_opening: Angle::new(dual(0)),
            rotation_joint: joint.clone().map(Dual::constant),
            sliding_joint: Angle::new(optional(4)),
            thickness: dual(1),
            thrust: dual(2),
            friction: optional(3),
            ..Configuration::zero(&zero)
        };
        let residuals: Vec<_> = equations.iter().map(|e| e.residual(weight, &at)).collect();
        let jacobian =
            residuals.iter().map(|r| (0..x.len()).map(|k| r.derivative(k)).collect()).collect();
        let inverse =
            couplet::solve::inverse(jacobian).expect("a regular Jacobian beside the limit");
        for (x, row) in x.iter_mut().zip(&inverse) {
            for (y, r) in row.iter().zip(&residuals) {
                *x -= y.clone() * r.value();
            }
        }
    }
    x[0].clone()
}

#[test]
fn the_weights_differ_and_the_box_of_one_does_not_hold_the_other() {
    let [heyman, milankovitch] = SelfWeight::ALL.map(|weight| certified(Landmark::Triple, weight));
    let index = heyman.isolated().system().index(Unknown::Thickness).unwrap();
    let domain = &heyman.isolated().domain()[index];
    let other = milankovitch.enclosure(64).unwrap().value(Unknown::Thickness).unwrap();
    assert!(!other.lies_inside(domain));
}
