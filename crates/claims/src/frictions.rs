//! The friction that the shoulder and an inner joint ask for, along sliding and along rotation.
//!
//! Two frictions belong to a purely rotational state: `M`, which the shoulder asks for, (17), and `m`,
//! which an inner joint asks for, (18). Both grow with the half opening; `M` is the larger one before
//! `T` and the smaller one beyond.

use super::along::{CurveStates, around, below, landmark, on_all};
use super::letters::{ring, term};
use super::overturning::end_of_rotation_is_simple;
use super::sliding::ratio_without_thrust;
use super::{Checked, Derivation, Support, claims, lemmas};
use crate::arch::{SelfWeight, overturning, sliding, statics, thrust};
use crate::number::{Angle, Ball, Enclosure, Field};
use crate::problem::Landmark;
use crate::symbolic::{Letters, Relations, Symbol, along_the_joint, along_the_opening};
use rug::Rational;

claims! {
    Ours("friction-slopes", "Eq. (17), (18)", friction_slopes):
        "where N > 0, mu_ss grows with the thrust and, from beta_s on, with the half opening, and is not positive \
         before; mu_is falls as the thrust grows";
    Implicit("friction-unbounded", "Eq. (18)", friction_of_small_thrust):
        "mu_is is unbounded as the thrust falls to 0";
    Ours("friction-large", "Eq. (18)", thrust_of_large_friction):
        "where an inner joint slides, h <= 1/(4 mu²)";
    AsPrinted("sliding-order", "Sec. 2.2", sliding_states_in_order):
        "to each half opening belongs one purely sliding state; as it grows, the friction grows and the thrust falls";
    AsPrinted("sliding-flat", "Sec. 2.2", sliding_thrust_goes_flatly_to_zero):
        "the thrust of the purely sliding states goes flatly to 0 as alpha -> pi";
    AsPrinted("map-asymptotes", "Sec. 3", dividing_lines_tend_to_the_end_of_rotation):
        "the lines beta_r = beta_s and beta_r = 0 tend to eta_l as mu -> inf";
    AsPrinted("friction-rotation", "Sec. 5", frictions_grow):
        "along the purely rotational states the friction needed to prevent sliding grows with the half opening, M of \
         the shoulder and m of an inner joint, and m is unbounded at the end";
    AsPrinted("map-T", "Sec. 2.2, 3", order_of_frictions):
        "the lines h(alpha) of the purely rotational and of the purely sliding states intersect at T and nowhere \
         else: before T the shoulder asks for more friction than an inner joint, M > m, beyond T for less, M < m";
}

/// Change of (17) and (18) with the half opening and the thrust.
fn friction_slopes(d: &mut Derivation) -> Checked {
    let (alpha, joint, h) = (Symbol::half_opening(), Symbol::joint(), Symbol::Thrust.number());
    let shoulder = sliding::shoulder(&alpha, &h).value();
    let normal = statics::normal_force(&alpha, &h).square();
    d.on_circle(
        "d mu_ss/d alpha",
        shoulder.derivative(&along_the_opening()),
        (alpha.rad.square() - (h.int(1) - &h) * &h) / &normal,
    )?;
    d.on_circle("d mu_ss/dh", shoulder.partial(Symbol::Thrust), alpha.rad / normal)?;
    let normal = statics::normal_force(&joint, &h);
    let ratio = statics::shear_force(&joint, &h) / &normal;
    let words =
        "d(T/N)/dh at a fixed joint; as T/N is stationary at beta_s, this is d mu_is/dh there";
    d.on_circle(words, ratio.partial(Symbol::Thrust), -(joint.rad.clone() / normal.square()))?;
    d.on_circle(
        "d(T/N)/d beta",
        ratio.derivative(&along_the_joint()),
        -(sliding::steepest(&joint.rad, &h) / normal.square()),
    )?;
    d.conclude(
        "mu_ss grows with h, and with alpha from beta_s on; before, -T/N is not positive, since T/N is \
         0 at the crown and grows up to beta_s. mu_is falls as h grows.",
    )
}

/// `mu_is` is unbounded for small thrusts.
fn friction_of_small_thrust(d: &mut Derivation) -> Checked {
    ratio_without_thrust(d)?;
    d.conclude(
        "mu_is(h) is at least T/N at any joint, which tends to cot(beta) as h -> 0: as beta may be as \
         small as one likes, mu_is(h) -> inf.",
    )
}

fn sliding_states_in_order(d: &mut Derivation) -> Checked {
    lemmas(d, ["friction-slopes", "friction-unbounded"])?;
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let numerator = -statics::shear_force(&alpha, &h);
    let slope = numerator.derivative(&along_the_opening());
    let rest = alpha.rad.clone() * &alpha.sin - (h.int(1) - &h) * &alpha.cos;
    d.identity("d(-T)/d alpha", &slope, &rest)?;
    d.conclude(
        "At h = 1 this is alpha sin(alpha), so that -T > 0 there. At a given half opening mu_is falls from inf to 0 \
         as h grows from 0 to 1, while mu_ss grows from -cot(alpha) to a positive number or, if N vanishes before, to \
         inf: there is one thrust at which they are equal. Along these states dh/d alpha = -(d mu_ss/d alpha)/(d \
         mu_ss/dh - d mu_is/dh) < 0, and mu = mu_is(h) grows.",
    )
}

/// `h <= 1/(4 mu²)` where an inner joint slides.
fn thrust_of_large_friction(d: &mut Derivation) -> Checked {
    let (joint, h) = (Symbol::joint(), Symbol::Thrust.number());
    let (shear, normal) = (statics::shear_force(&joint, &h), statics::normal_force(&joint, &h));
    d.identity(
        "T/N, for 0 < beta_s <= 1/2, is below beta/(h + beta tan(beta))",
        joint.rad.clone() * &joint.cos / &normal - shear / &normal,
        h.clone() * &joint.sin / &normal,
    )?;
    let tangent = joint.sin.clone() / &joint.cos;
    d.identity(
        "the same bound",
        joint.rad.clone() * &joint.cos / &normal,
        joint.rad.clone() / (h.clone() + joint.rad.clone() * tangent),
    )?;
    let root = Symbol::SquareRoot.number();
    let rooted = Relations::none().with(Symbol::SquareRoot, 2, Symbol::Thrust.polynomial());
    d.identity_under(
        "h + beta² - 2 √h beta, with q = √h",
        h.clone() + joint.rad.square() - h.int(2) * &root * &joint.rad,
        (root - &joint.rad).square(),
        &rooted,
    )?;
    d.conclude("As tan(beta) > beta, mu_is <= beta/(h + beta²) <= 1/(2 √h): h <= 1/(4 mu²).")
}

fn sliding_thrust_goes_flatly_to_zero(d: &mut Derivation) -> Checked {
    lemmas(d, ["friction-large"])?;
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let cotangent = alpha.cos.clone() / &alpha.sin;
    d.on_circle(
        "mu_ss + cot(alpha)",
        sliding::shoulder(&alpha, &h).value() + cotangent,
        h.clone() / (statics::normal_force(&alpha, &h) * &alpha.sin),
    )?;
    d.conclude(
        "With N > 0, mu >= -cot(alpha), so that h <= tan²(alpha)/4, which vanishes at pi with its \
         slope.",
    )
}

fn dividing_lines_tend_to_the_end_of_rotation(d: &mut Derivation) -> Checked {
    lemmas(d, ["friction-large"])?;
    let (ring, eta) = (ring(), Symbol::Thickness.number());
    let limit = thrust::tangency(&eta.int(1), &ring);
    let words = "(5), cleared, for h -> 0 and beta -> 0, where beta cot(beta) -> 1";
    let condition = overturning::end_of_rotation(&ring);
    d.identity(words, limit.residual(&eta.int(0)), eta.int(-2) * condition)?;
    let words = "its slope to eta, up to the factor, is not zero";
    end_of_rotation_is_simple(d, words, |end| format!(" = {end}"))?;
    d.conclude(
        "On either line beta_r <= beta_s <= √h, and h <= 1/(4 mu²): as mu -> inf, (5) tends to this \
         condition, whose only root in (0, 2) is eta_l.",
    )
}

/// `sin - alpha/4 - 3/4 alpha cos`.
fn bow<T: Field>(Angle { rad, sin, cos }: &Angle<T>) -> T {
    sin.clone() - rad.clone() / rad.int(4) - rad.ratio(3, 4) * rad * cos
}

/// `M` and `m` grow along rotation.
fn frictions_grow(d: &mut Derivation) -> Checked {
    lemmas(d, ["friction-slopes", "curve-order", "friction-unbounded"])?;
    let alpha = Symbol::half_opening();
    let Angle { rad, sin, .. } = &alpha;
    let one = rad.int(1);
    let least = rad.ratio(3, 4) * rad * alpha.versine() - (rad.clone() - sin);
    d.identity("3/4 alpha (1 - cos) - (alpha - sin)", &least, bow(&alpha))?;
    let sine = term(1, 1, 1) - term(1, 6, 3);
    let cosine = one.clone() - term(1, 2, 2) + term(1, 24, 4);
    let below = sine - term(1, 4, 1) - term(3, 4, 1) * cosine;
    d.identity(
        "it is at least this, by sin >= alpha - alpha³/6 and cos <= 1 - alpha²/2 + alpha⁴/24; \
         positive for 0 < alpha <= 5/2",
        &below,
        term(5, 24, 3) - term(1, 32, 5),
    )?;
    let (low, high) = (Rational::from((5, 2)), Rational::from((315, 100)));
    d.positive("sin - alpha/4 - 3/4 alpha cos", (&low, &high), |x| bow(&Angle::new(x.clone())))?;
    let joint = Symbol::joint();
    let excess = joint.rad.clone() * &joint.cos
        - (one.clone() - joint.rad.square() / one.int(2)) * &joint.sin;
    d.identity(
        "d(x cos(x) - (1 - x²/2) sin(x))/dx, positive below pi/2",
        excess.derivative(&along_the_joint()),
        joint.rad.square() * &joint.cos / one.int(2),
    )?;
    d.conclude(
        "On the curve h >= A - 1, since 2 fac/(2 + eta) <= 1, and A = 2 x cot(x) >= 2 - x² with x = alpha/2, so that \
         h (1-h) <= 1 - h <= alpha²/4. In N² dM = (alpha² - h (1-h)) d alpha + alpha dh both A and A - h fall, so \
         that d alpha >= -dh (1 - cos)/(alpha - sin): N² dM is at least -dh times (3/4 alpha² (1 - cos)/(alpha - sin) \
         - alpha), which is positive. So M grows with alpha; m = mu_is(h) grows, since h falls, and without bound, \
         since h -> 0 at l.",
    )
}

/// `M > m` for `alpha <= 1/2`, from Taylor's theorem.
fn small_openings(d: &mut Derivation) -> Checked {
    // A >= 2 - alpha²/5, times 1 - cos.
    let versine = term(1, 2, 2) - term(1, 24, 4) + term(1, 720, 6);
    let sine = term(1, 1, 1) - term(1, 6, 3);
    let excess = term(1, 1, 1) * &sine - (term(2, 1, 0) - term(1, 5, 2)) * versine;
    let words = "alpha sin - (2 - alpha²/5)(1 - cos) is at least this, positive for 0 < alpha <= 1";
    d.identity(words, &excess, term(1, 60, 4) - term(1, 90, 6) + term(1, 3600, 8))?;
    let cosine = term(1, 1, 0) - term(1, 2, 2) + term(1, 24, 4);
    let shear = sine - term(1, 1, 1) * &cosine - term(1, 5, 2) * term(1, 1, 1);
    let words = "so y = 1 - h <= alpha²/5, and sin - alpha cos - y sin is at least this";
    d.identity(words, &shear, term(2, 15, 3) - term(1, 24, 5))?;
    let normal = cosine + term(1, 1, 2);
    let words = "N <= cos + alpha sin is at most this";
    d.identity(words, &normal, term(1, 1, 0) + term(1, 2, 2) + term(1, 24, 4))?;
    // In z = alpha²: (M/alpha³)² > (m/alpha³)², with m² <= y³/(1 - y).
    let margin = |z: &Ball| {
        let shear = z.ratio(2, 15) - z.ratio(1, 24) * z;
        let normal = z.int(1) + z.ratio(1, 2) * z + z.ratio(1, 24) * z.square();
        (shear / normal).square() - z.ratio(1, 125) / (z.int(1) - z.ratio(1, 5) * z)
    };
    let (low, high) = (Rational::new(), Rational::from((1, 4)));
    d.positive(
        "the lower bound of M² less y³/(1-y), over alpha⁶, in alpha²,",
        (&low, &high),
        margin,
    )?;
    d.conclude(
        "T(beta) <= y beta and N >= h = 1 - y at beta_s = √(y (1-y)), so that m <= y^(3/2)/√(1-y), \
         which grows with y; so M > m for alpha <= 1/2.",
    )
}

/// `M > m` before `T` and `M < m` beyond.
fn order_of_frictions(d: &mut Derivation) -> Checked {
    lemmas(d, ["friction-slopes", "friction-rotation"])?;
    small_openings(d)?;
    for weight in SelfWeight::ALL {
        let (before, beyond) = around(&landmark(Landmark::Triple, weight)?.half_opening.rad, 1000)?;
        let end = landmark(Landmark::RotationEnd, weight)?.half_opening;
        let rotational = |alpha: &Rational| CurveStates::rotational(weight, alpha);
        let half = Rational::from((1, 2));
        let last: Rational = below(&end.rad, 100)?;
        // What holds before T does not beyond.
        let ranges = [(&half, &before), (&beyond, &last)];
        let words = format!("M > m from 1/2 up to {before}, {weight}");
        let holds = |a: &CurveStates, b: &CurveStates| {
            b.inner_friction().is_less_than(&a.shoulder_friction())
        };
        d.certain(Support::Balls, words, ranges, |range| on_all(range, &rotational, &holds))?;
        let all = rotational(&before)?.up_to(&rotational(&beyond)?);
        // There the joint falls with the half opening, as all else is monotone too.
        let widest = landmark(Landmark::WidestJoint, weight)?.half_opening.rad;
        let words = format!("alpha_sb < {before}, {weight}");
        d.less(words, [&widest, &Ball::enclosing(&before, widest.prec())])?;
        let slope = all.friction_gap_slope()?;
        let words = format!("M - m falls from {before} to {beyond}, which holds alpha_T, {weight}");
        d.less(words, [&slope, &slope.int(0)])?;
        let words = format!("M < m from {beyond} to {last}, {weight}");
        let holds = |a: &CurveStates, b: &CurveStates| {
            b.shoulder_friction().is_less_than(&a.inner_friction())
        };
        let ranges = [ranges[1], ranges[0]];
        d.certain(Support::Balls, words, ranges, |range| on_all(range, &rotational, &holds))?;
        let limit = sliding::shoulder(&end, &end.rad.int(0)).value();
        let words = format!("M < m from {last} to alpha_l, where h = 0, {weight}");
        d.less(words, [&limit, &rotational(&last)?.inner_friction()])?;
    }
    d.conclude(
        "M, m grow with alpha, so that the values at the ends of a range speak for all of it. M = m at \
         T, by (17) and (18): M > m before and M < m beyond.",
    )?;
    d.conclude(
        "At a given half opening mu_ss - mu_is grows with h and vanishes for the purely sliding state: \
         the thrust of rotation is larger than that of sliding where M > m, and smaller where M < m.",
    )
}
