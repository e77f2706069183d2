//! The purely rotational states of the two weights at the same half opening.
//!
//! `delta_M` is taken for a number that grows from 0, Heyman's weight, to 1, Milankovitch's: the state of a
//! half opening moves with it, and what holds of its slopes for every `delta_M` holds of the difference.
//! With `A = h_L + 2 fac/(2 + eta)` kept, and `h_L` stationary in the joint, the slopes are quotients of
//! sums whose terms have one sign each.

use super::along::moving;
use super::curve::cubic_of;
use super::landmarks::state_of;
use super::letters::ring;
use super::states::at_all_states;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::{Ring, SelfWeight, overturning, thrust};
use crate::number::{Angle, Ball, DoubleBall, DoubleDoubleBall, Dual, Field};
use crate::symbolic::{Fraction, Letters, Polynomial, Symbol, along_the_joint};
use rug::Rational;
use std::sync::OnceLock;

claims! {
    AsPrinted("weights-rotation", "Sec. 2.1, Fig. 2", states_of_one_opening):
        "at every half opening below alpha_l of Milankovitch's weight its purely rotational state has a larger \
         thickness, a smaller thrust and a smaller joint than that of Heyman's, whose beta_r overshoots everywhere, \
         not only about the peak";
    AsPrinted("weights-differences", "Sec. 2.1, Fig. 2", differences_grow):
        "from alpha = 2/5 up to 2.58 the relative differences of eta, h and beta_r between the two weights grow with \
         the half opening; up to 2/5 they are below 0.01 %";
}

/// Change of a rotational state with `delta_M` while its half opening is kept: logarithmic slopes.
struct WeightSlopes<T> {
    /// Slope of `eta`; positive.
    thickness: T,
    /// Slope of `h`; negative.
    thrust: T,
    /// Slope of `beta_r`; negative.
    joint: T,
    /// Push that the slope of the cubic `p`, kept at zero, leaves to the joint; positive.
    push: T,
}

/// `-dA/d eta` of overturning, times `6 (2 + eta)²`.
fn fall<T: Field>(delta: &T, ring: &Ring<T>) -> T {
    let eta = &ring.thickness;
    eta.int(12) - (eta.int(4) + eta) * eta * delta
}

/// `-dh_L/d eta`, times the square of the lever arm in (2).
fn loss<T: Field>(joint: &Angle<T>, delta: &T, ring: &Ring<T>, lever: &T) -> T {
    let (eta, sin) = (&ring.thickness, &joint.sin);
    eta.int(4) * sin * (joint.rad.clone() - sin)
        + eta.int(2) * sin.square() * (eta.int(2) - &ring.centroid_factor)
        + delta.clone() * eta * joint.versine() * lever / eta.int(3)
}

/// `-dh_e/d eta`, times the square of `2 - eta`.
fn gain<T: Field>(delta: &T, ring: &Ring<T>) -> T {
    let eta = &ring.thickness;
    delta.clone() * eta * ring.intrados() / eta.int(3) + eta.int(2) * &ring.centroid_factor
}

fn slopes<T: Field>(joint: &Angle<T>, delta: &T, eta: &T, h: &T) -> WeightSlopes<T> {
    let ring = Ring::with_flag(delta, eta);
    let lever = thrust::lower(joint, &ring).denominator;
    let (intrados, extrados) = (ring.intrados(), ring.extrados());
    let (loss, fall) = (loss(joint, delta, &ring, &lever), fall(delta, &ring));
    let steepness = loss.clone() / lever.square() + fall.clone() / (eta.int(6) * extrados.square());
    let thickness = eta.square() * &joint.cos / (eta.int(3) * &lever * &extrados * &steepness);
    let rest = loss.clone() * &extrados / lever.square()
        + fall.clone() * joint.versine() / (eta.int(6) * &lever);
    let thrust = -(eta.square() * rest / (eta.int(6) * extrados.square() * &steepness * h));
    let tilt = eta.int(3) * loss
        + eta.int(3) * &joint.cos * gain(delta, &ring) * &lever / &intrados
        + fall * &lever / (eta.int(2) * &extrados);
    let push =
        eta.square() * eta * &joint.sin * tilt / (eta.int(3) * &lever * &extrados * &steepness);
    let joint =
        -(push.clone() / (eta.int(3) * intrados * lever * bow(joint, &ring, h) * &joint.rad));
    WeightSlopes { thickness, thrust, joint, push }
}

/// `(beta - S C)/S` on the curve, by the thrust where (2) and (5) hold both.
fn bow<T: Field>(joint: &Angle<T>, ring: &Ring<T>, h: &T) -> T {
    let eta = &ring.thickness;
    joint.versine() + eta.int(2) * eta * h / (ring.intrados() * joint.versine())
}

/// `d beta_r/d eta` along the states of one weight.
fn widening<T: Field>(joint: &Angle<T>, delta: &T, eta: &T, h: &T) -> T {
    let ring = Ring::with_flag(delta, eta);
    let (lever, intrados) = (thrust::lower(joint, &ring).denominator, ring.intrados());
    let by_thickness = loss(joint, delta, &ring, &lever) * &intrados / &lever
        - gain(delta, &ring) * &lever / &intrados;
    by_thickness * &joint.sin / (intrados * lever * bow(joint, &ring, h))
}

fn states_of_one_opening(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-joint", "curve-order", "curve-weights"])?;
    d.assume("0 <= delta_M <= 1");
    let (joint, ring) = (Symbol::joint(), ring());
    let (eta, delta) = (&ring.thickness, Symbol::Flag.number());
    let slopes = slopes(&joint, &delta, eta, &thrust::lower(&joint, &ring).value());
    let end = overturning::end_of_rotation(&ring);
    let last = overturning::opening_variable(&ring).value();
    d.identity(
        "A of (13) is 2 (2 - eta)/(2 + eta) at eta_l, less the condition behind (16), up to a factor",
        &last,
        (ring.intrados() - &end) * eta.int(2) / ring.extrados(),
    )?;
    let words = "which falls with delta_M, and with eta as it did: so do eta_l and alpha_l";
    let slope = end.partial(Symbol::Flag);
    d.identity(words, &slope, -(eta.square() / eta.int(12)))?;
    // A = h_L + 2 fac/(2 + eta) is kept.
    let lower = thrust::lower(&joint, &ring);
    let opening = lower.value() + &last;
    let moved = -(opening.partial(Symbol::Flag) / opening.partial(Symbol::Thickness));
    let thickness = eta.clone() * &slopes.thickness;
    d.on_circle("d eta/d delta_M where A is kept: positive, as cos(beta) is", &moved, &thickness)?;
    let moved = last.partial(Symbol::Flag) + last.partial(Symbol::Thickness) * &thickness;
    let words = "dh/d delta_M there: negative, a sum of terms of one sign";
    d.on_circle(words, -moved, lower.value() * &slopes.thrust)?;
    // p = 0 is kept too. On the curve the slope of p is that of what p is a multiple of.
    let p = cubic_of(&joint, &delta, eta);
    let multiple = lower.denominator * ring.intrados();
    let over = multiple.partial(Symbol::Thickness) / &multiple;
    let slope = p.partial(Symbol::Thickness) - p.clone() * over;
    let moved = slope.clone() * thickness + p.partial(Symbol::Flag);
    let words = "dp/d delta_M there, at a fixed joint, where p = 0: positive too";
    d.on_circle(words, &moved, &slopes.push)?;
    let rise = (p.clone() / &joint.sin).derivative(&along_the_joint());
    let bow = joint.rad.clone() - joint.sin.clone() * &joint.cos;
    let rise_on_curve = eta.int(3) * &multiple * bow / &joint.sin;
    d.on_circle("dp/d beta where p = 0", rise * &joint.sin, &rise_on_curve)?;
    // What the balls are given.
    let excess = (joint.rad.clone() - &joint.sin) / &joint.sin;
    let h = thrust::touching(&joint.versine(), &excess, &ring).value();
    let words = "d log beta_r/d delta_M";
    let moved = -(slopes.push / (rise_on_curve.clone() * &joint.rad));
    d.on_circle(words, &moved, &self::slopes(&joint, &delta, eta, &h).joint)?;
    let words = "d beta_r/d eta at one delta_M";
    let moved = -(slope / rise_on_curve);
    d.on_circle(words, &moved, widening(&joint, &delta, eta, &h))?;
    d.conclude(
        "As S < beta, fac < 2 and cos(beta) > 0, each term has the sign named; p grows with beta, so that \
         the joint falls as delta_M grows from 0 to 1. A half opening below alpha_l at delta_M = 1 is below \
         alpha_l at every delta_M, and has one state at each.",
    )
}

/// `beta/sin(beta) - 1` with its slope, both of which grow with `beta`, from the ends of the ball.
fn excess(joint: DoubleDoubleBall) -> (DoubleDoubleBall, DoubleDoubleBall) {
    let joint = DoubleBall::from(joint);
    let [low, high] = [joint.lower(), joint.upper()].map(|end| {
        let at = Angle::new(DoubleDoubleBall::from(DoubleBall::exact(end)));
        let slope = (at.rad.int(1) - at.times_cotangent()) / at.sin;
        ((at.rad - at.sin) / at.sin, slope)
    });
    (low.0.hull(&high.0), low.1.hull(&high.1))
}

/// The slopes with their change along the states of one weight, as the thickness grows.
fn slopes_along(
    joint: &DoubleDoubleBall,
    delta: &DoubleDoubleBall,
    eta: &DoubleDoubleBall,
) -> WeightSlopes<Dual<DoubleDoubleBall>> {
    let angle = Angle::new(*joint);
    let (excess, slope_of_excess) = excess(*joint);
    let ring = Ring::with_flag(delta, eta);
    let h = thrust::touching(&angle.versine(), &excess, &ring).value();
    let slope = widening(&angle, delta, eta, &h);
    let joint = moving(angle, &slope);
    let excess = Dual::with_derivative(excess, 0, slope_of_excess * slope);
    let (delta, eta) = (Dual::constant(*delta), Dual::variable(*eta, 0));
    let ring = Ring::with_flag(&delta, &eta);
    let h = thrust::touching(&joint.versine(), &excess, &ring).value();
    slopes(&joint, &delta, &eta, &h)
}

/// The pieces on which the slopes are proved to grow in size along the states, or with the other sign to fall.
fn growth(sign: i32) -> Checked<usize> {
    let range = (Rational::from((1, 2000)), Rational::from((9, 10)));
    at_all_states(&range, &|joint, delta, eta| {
        let WeightSlopes { thickness, thrust, joint, .. } = slopes_along(joint, delta, eta);
        [thickness, -thrust, -joint].map(|slope| slope.derivative(0) * eta.int(sign)).to_vec()
    })
}

/// Proves that the differences grow, decided once.
fn grown() -> Checked<usize> {
    static DECIDED: OnceLock<Checked<usize>> = OnceLock::new();
    DECIDED.get_or_init(|| growth(1)).clone()
}

fn differences_grow(d: &mut Derivation) -> Checked {
    lemmas(d, ["weights-rotation"])?;
    let pieces = grown()?;
    let words = "d log/d delta_M of eta, h and beta_r grow in size with eta along the states of any \
                 delta_M, eta in [1/2000, 9/10]";
    let words = format!("{words}, {pieces} pieces");
    d.known(words, &Ok(pieces), -1, growth)?;
    let number = |n: i32, m: i32| Ball::enclosing(&Rational::from((n, m)), 128);
    let first = state_of("0.4", "inf", SelfWeight::Heyman)?.thickness;
    let words = "eta > 1/2000 from alpha = 2/5 on, with Heyman's weight and so with any";
    d.less(words, [&number(1, 2000), &first])?;
    let last = state_of("2.58", "inf", SelfWeight::Milankovitch)?.thickness;
    let words = "eta < 9/10 up to alpha = 2.58, with Milankovitch's weight and so with any";
    d.less(words, [&last, &number(9, 10)])?;
    // Where the arch is thin, bounds are enough.
    let (joint, ring) = (Symbol::joint(), ring());
    let eta = &ring.thickness;
    let lever = thrust::lower(&joint, &ring).denominator;
    let words = "the lever arm of (2) is at least 2 eta cos(beta)";
    d.identity(words, lever - eta.int(2) * eta * &joint.cos, ring.extrados() * joint.versine())?;
    let touching = thrust::touching(&joint.versine(), &Fraction::from(Polynomial::from(1)), &ring);
    let slope = touching.value().partial(Symbol::Thickness) / touching.value();
    let words = "d log h/d log eta at a fixed joint, where (2) and (5) hold";
    d.identity(words, slope * eta, -(eta.int(2) / ring.intrados()))?;
    let thin = state_of("0.4", "inf", SelfWeight::Milankovitch)?;
    let (eta, h) = (&thin.thickness, &thin.thrust);
    let ring = Ring::with_flag(&eta.int(1), eta);
    let bound = eta.clone() * ring.extrados() * eta.int(2)
        / (ring.intrados().square() * (eta.int(6) + eta));
    let words = "2/(2 - eta) eta (2 + eta)/((2 - eta)(6 + eta)) at alpha = 2/5, eta the larger one";
    d.less(format!("{words}, is below 0.0001"), [&bound, &number(1, 10_001)])?;
    let bound = eta.square() / (eta.int(6) * ring.extrados() * h);
    d.less("eta²/(6 (2 + eta) h) there is below 0.0001", [&bound, &number(1, 10_001)])?;
    d.conclude(
        "As lever >= 2 eta cos(beta), d log(eta)/d delta_M is at most eta (2 + eta)/fall, and fall is at \
         least (2 - eta)(6 + eta); -dh/d delta_M is at most eta²/(6 (2 + eta)). The joint follows by h = \
         (2 - eta)/(2 eta) V, where V = (1 - cos)(beta/sin - 1): d log(V)/d log(beta) >= A(beta) >= 1. The \
         differences of the logarithms are the integrals over delta_M of these slopes, and eta grows with \
         the half opening at each delta_M.",
    )
}
