//! Geometric safety of arches of one thickness and one rise.
//!
//! Of one rise the thickness over the radius falls with the half opening, at the extrados the faster the thicker the
//! arch is, but no faster than `(1 - cos(alpha))²`. Along a way on which `eta/(1 - cos(alpha))²` is kept an arch that
//! stands goes on standing: so its least thickness falls faster, and its safety grows. The rate of a number is `E`, its
//! slope to the logarithm of `1 - cos(alpha)` on that way.
//!
//! Of thin arches both fall like the fourth power of the half opening, and only the haunch at which the line of thrust
//! touches tells them apart. There, with `B = beta cot(beta/2)` and in the letters of `rises.rs`,
//!
//! ```text
//! q = beta/sin(beta) - 1      tau h = (1 - tau) q (1 - cos(beta))      2 - A = 2 - B + q [1 + g (1 - cos(beta))/h]
//! ```

use super::along::landmark;
use super::contacts::margin_at;
use super::curve::cubic_of;
use super::letters::ring;
use super::rises::{
    centroids, opening_variable, rate_of_opening, relief, slenderness, sliding_shoulder,
    thrust_of_haunch,
};
use super::states::at_all_states;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::{Ring, SelfWeight, statics};
use crate::certify::between;
use crate::number::{Angle, Ball, DoubleDoubleBall, Field, Real};
use crate::problem::Landmark;
use crate::symbolic::{Fraction, Letters, Symbol, along_the_opening};
use rug::Rational;
use std::sync::OnceLock;

claims! {
    Ours("safety-opening", "Fig. 1", opening):
        "for 0 < alpha < pi, alpha/sin(alpha) - 1 is more than y + y²/2, y = 2 - A";
    Ours("safety-haunch", "Sec. 2.1", haunch):
        "at the haunch of each purely rotational state up to eta = 39/50, whatever delta_M between 0 and 1, three \
         numbers are positive: what is left of y + y²/2 by the haunch, of [3 (1 - h) + (1 - h)²]/2 and of 4/3 by the \
         growth of h where eta/(1 - cos(alpha))² is kept";
    Ours("safety-rotation", "Fig. 1", rotation):
        "along the purely rotational and overturning states eta/(1 - cos(alpha))² grows with the half opening";
    Ours("safety-shoulder", "Fig. 1", shoulder):
        "where the shoulder slides and the haunch is on the intrados, the shoulder is relieved as the half opening \
         falls and eta/(1 - cos(alpha))² is kept, though it makes the thrust grow";
    Ours("safety-inner", "Fig. 1", inner):
        "where an inner joint slides, the same way relieves the shoulder's extrados";
    Ours("survey-safety", "Fig. 1", safety):
        "of the arches with one thickness, rise and friction a longer one has no smaller geometric safety, eta over \
         its least value, wherever the rise is measured: of those between measured ends it is least and largest at \
         the corners that stand least and most easily";
}

/// Rate `E` where `eta/(1 - cos(alpha))²` is kept.
fn along_the_square(value: &Fraction) -> Fraction {
    let alpha = Symbol::half_opening();
    let by_thickness = value.partial(Symbol::Thickness) * &ring().thickness * value.int(2);
    by_thickness + value.derivative(&along_the_opening()) * alpha.versine() / &alpha.sin
}

/// `n = -dg/d tau`.
fn fall_of_centroids() -> Fraction {
    let (eta, delta) = (ring().thickness, Symbol::Flag.number());
    let growth = (eta.int(4) + &eta) * &eta * delta / eta.int(24);
    eta.ratio(1, 2) - growth
}

/// `c_1(u), ..., c_5(u)`, Stumpff's functions, for `0 <= u <= 10`; `unit` holds the numbers from 0 to 1.
///
/// The terms that are left out alternate and fall: what stands for them in the innermost bracket is in the unit.
fn tails<T: Field>(u: &T, unit: &T) -> [T; 5] {
    [1, 2, 3, 4, 5].map(|n| {
        let brackets = (1..=12).rev().fold(unit.clone(), |rest, k| {
            u.int(1) - rest * u / (u.int(2 * k + n) * u.int(2 * k + n - 1))
        });
        brackets / u.int((1..=n).product())
    })
}

/// Numbers of a joint that stay what they are as it comes near the crown.
struct JointNumbers<T> {
    cos: T,
    /// `1 - cos(beta)`.
    versine: T,
    /// `beta cot(beta)`.
    times_cotangent: T,
    /// `q`.
    excess: T,
    /// `q/(1 - cos(beta))`.
    excess_over_versine: T,
    /// `1 - (2 - B)/q`.
    lag: T,
    /// Lag over `1 - cos(beta)`.
    lag_over_versine: T,
}

impl<T: Field> JointNumbers<T> {
    /// The numbers by sine and cosine.
    fn of_angle(joint: &Angle<T>) -> Self {
        let (versine, one) = (joint.versine(), joint.rad.int(1));
        let excess = joint.rad.clone() / &joint.sin - &one;
        let below_two = one.int(2) - joint.rad.clone() * &joint.sin / &versine;
        let lag = one - below_two / &excess;
        Self {
            cos: joint.cos.clone(),
            times_cotangent: joint.times_cotangent(),
            excess_over_versine: excess.clone() / &versine,
            lag_over_versine: lag.clone() / &versine,
            versine,
            excess,
            lag,
        }
    }

    /// The numbers by Stumpff's functions of the square of the joint.
    fn of_square(square: &T, unit: &T) -> Self {
        let [sine, versine, excess, c4, c5] = tails(square, unit);
        let cos = square.int(1) - versine.clone() * square;
        let lag = (c4 - c5.int(3) * &c5) / &excess;
        Self {
            times_cotangent: cos.clone() / &sine,
            cos,
            excess_over_versine: excess.clone() / &sine / &versine,
            excess: excess * square / sine,
            lag_over_versine: lag.clone() / &versine,
            lag: lag * square,
            versine: versine * square,
        }
    }
}

/// Line of thrust and ring at a haunch.
struct ThrustAtHaunch<T> {
    joint: JointNumbers<T>,
    thrust: T,
    centroids: T,
    slenderness: T,
}

impl<T: Field> ThrustAtHaunch<T> {
    /// `1 - tau`.
    fn rest(&self) -> T {
        self.thrust.int(1) - &self.slenderness
    }

    /// `k = g (1 - cos(beta))/h`.
    fn load(&self) -> T {
        self.centroids.clone() * &self.joint.versine / &self.thrust
    }

    /// `s = (1 - tau) cos(beta)/h`, so that the lever arm is `(1 - cos(beta)) (1 + q s)`.
    fn lever(&self) -> T {
        self.rest() * &self.joint.cos / &self.thrust
    }

    /// `1 + q s`.
    fn arm(&self) -> T {
        self.thrust.int(1) + self.lever() * &self.joint.excess
    }

    /// Room that the haunch leaves of `y + y²/2`, over `q (1 - cos(beta))`.
    fn rotation(&self) -> T {
        let (joint, [k, s]) = (&self.joint, [self.load(), self.lever()]);
        let one = k.int(1);
        let m = one.int(2) - &joint.lag + &k;
        let gain = m.square() * self.arm() / one.int(2) + m * &s;
        let loss = joint.lag_over_versine.clone() + self.centroids.clone() / &self.thrust;
        let thick = self.rest() * &joint.excess / &self.thrust;
        let half = s.clone() * &self.slenderness / one.int(2);
        joint.excess_over_versine.clone() * gain - loss + thick * (one + k + half - s)
    }

    /// Bound of the growth of `h`, over `q`.
    fn growth(&self) -> T {
        let one = self.thrust.int(1);
        (one.clone() + self.rest()) * (one + self.load()) / self.arm()
    }

    /// Room left of `[3 (1 - h) + (1 - h)²]/2` at least, over `q`.
    fn narrow(&self) -> T {
        let one = self.thrust.int(1);
        let thin = self.rest() * &self.joint.versine / (self.thrust.clone() * one.int(2));
        let lack = one.int(2) + self.load() - &self.joint.lag - thin;
        lack * (one.int(4) - &self.thrust) / one.int(2) - self.growth()
    }

    /// Room left of 4/3 at least.
    fn wide(&self) -> T {
        self.thrust.ratio(4, 3) - self.growth() * &self.joint.excess
    }
}

/// The three numbers at a haunch with the thrust of (5).
fn rooms<T: Field>(joint: &T, delta: &T, eta: &T, unit: &T) -> [T; 3] {
    let joint = JointNumbers::of_square(&joint.square(), unit);
    let ring = Ring::with_flag(delta, eta);
    let slenderness = eta.int(2) * eta / ring.extrados();
    let centroids = eta.int(2) * &ring.centroid_factor / ring.extrados();
    let rest = eta.int(1) - &slenderness;
    let thrust = joint.times_cotangent.clone() + eta.int(1) - centroids.clone() / rest;
    let haunch = ThrustAtHaunch { joint, thrust, centroids, slenderness };
    [haunch.rotation(), haunch.narrow(), haunch.wide()]
}

/// The numbers from 0 to 1.
fn unit() -> Ball {
    between(&Rational::new(), &Rational::from(1))
}

/// A rational as a ball.
fn number(n: i32, m: i32) -> Ball {
    Ball::enclosing(&Rational::from((n, m)), 128)
}

fn opening(d: &mut Derivation) -> Checked {
    let (alpha, versine) = (Symbol::half_opening(), Symbol::half_opening().versine());
    let (one, two) = (versine.int(1), versine.int(2));
    let lack = two.clone() - opening_variable();
    let rate = alpha.rad.clone() / &alpha.sin - &one;
    let cusa = (two.clone() + &alpha.cos) * &alpha.rad - alpha.sin.int(3) * &alpha.sin;
    let below_two = versine.clone() * &two - alpha.rad.clone() * &alpha.sin;
    let bracket = cusa * versine.square() - below_two.square() * &alpha.sin / &two;
    let words = "alpha/sin(alpha) - 1 - y - y²/2";
    let value = rate - &lack - lack.square() / &two;
    d.on_circle(words, value, bracket / (alpha.sin * versine.square()))?;
    d.conclude(
        "With Stumpff's functions c_n of u = alpha² the bracket is alpha⁹ times (c_4 - 3 c_5) c_2² - c_1 (c_3 - 2 \
         c_4)²/2, as alpha (2 + cos) - 3 sin is alpha⁵ (c_4 - 3 c_5), 2 (1 - cos) - alpha sin is alpha⁴ (c_3 - 2 \
         c_4).",
    )?;
    let range = (&Rational::new(), &Rational::from(10));
    d.positive("(c_4 - 3 c_5) c_2² - c_1 (c_3 - 2 c_4)²/2, u to above pi²", range, |u| {
        let [c1, c2, c3, c4, c5] = tails(u, &unit());
        let below_two = c3 - c4.int(2) * &c4;
        (c4 - c5.int(3) * &c5) * c2.square() - c1 * below_two.square() / u.int(2)
    })
}

/// Number of pieces on which the three numbers are proved to be positive, or with the other sign negative, from a
/// thickness on.
fn at_haunches(sign: i32) -> Checked<usize> {
    let range = (Rational::from((1, 2500)), Rational::from((39, 50)));
    let unit = DoubleDoubleBall::from(&unit());
    at_all_states(&range, &|joint, delta, eta| {
        rooms(joint, delta, eta, &unit).map(|room| room * eta.int(sign)).to_vec()
    })
}

fn haunch(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-joint"])?;
    static DECIDED: OnceLock<Checked<usize>> = OnceLock::new();
    let pieces = DECIDED.get_or_init(|| at_haunches(1)).clone()?;
    let words =
        format!("the three numbers are positive for eta in [1/2500, 39/50], {pieces} pieces");
    d.known(words, &Ok(pieces), -1, at_haunches)?;
    let (least, thin) = (Rational::new(), Rational::from((1, 2500)));
    let joint = Angle::new(number(27, 100));
    d.positive("the cubic (7) at beta = 27/100, delta_M = 0", (&least, &thin), |eta| {
        cubic_of(&joint, &eta.int(0), eta)
    })?;
    d.conclude("It grows with delta_M and, over sin(beta), with beta: up to eta = 1/2500 beta is below 27/100.")?;
    let (delta, eta, range) = (unit(), between(&least, &thin), Rational::from((27, 100)));
    for (index, name) in ["first", "second", "third"].into_iter().enumerate() {
        let words = format!("the {name} of them, eta <= 1/2500, beta");
        let room = |joint: &Ball| rooms(joint, &delta, &eta, &unit())[index].clone();
        d.positive(&words, (&least, &range), room)?;
    }
    Ok(())
}

/// A haunch in letters: the joint and the thrust are free, ring and centroids are those of (2) and (5).
fn haunch_in_letters() -> ThrustAtHaunch<Fraction> {
    let (joint, h) = (JointNumbers::of_angle(&Symbol::joint()), Symbol::Thrust.number());
    let sum = h.clone() + joint.excess.clone() * &joint.versine;
    let slenderness = joint.excess.clone() * &joint.versine / &sum;
    let touching = joint.times_cotangent.clone() + h.int(1) - &h;
    ThrustAtHaunch { joint, centroids: h.clone() / sum * touching, thrust: h, slenderness }
}

/// `tau h = (1 - tau) q (1 - cos(beta))` at a haunch.
fn slenderness_of_haunch(d: &mut Derivation) -> Checked {
    let (joint, h, ring) = (Symbol::joint(), Symbol::Thrust.number(), ring());
    let (tau, g, one) = (slenderness(), centroids(), h.int(1));
    let rest = one.clone() - &tau;
    let parts = JointNumbers::of_angle(&joint);
    let lower = rest.clone() * &joint.rad * &joint.sin
        - g.clone() * &parts.versine
        - (parts.versine.clone() + tau.clone() * &joint.cos) * &h;
    let scaled = (thrust_of_haunch() - &h) * (parts.versine.clone() + tau.clone() * &joint.cos);
    d.on_circle("(2), cleared of its lever arm", scaled, &lower)?;
    let touching = rest.clone() * (parts.times_cotangent.clone() + &one - &h) - g;
    let tangency = crate::arch::thrust::tangency(&joint.times_cotangent(), &ring).value();
    let words = "(5), cleared of its denominator";
    d.on_circle(words, (tangency - &h) * &rest, &touching)?;
    let expected = rest * &parts.excess * &parts.versine - tau * &h;
    let words = "(2) less 1 - cos(beta) times (5): tau h = (1 - tau) q (1 - cos(beta))";
    d.on_circle(words, lower - touching * &parts.versine, expected)
}

fn rotation(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-order", "curve-weights", "safety-opening", "safety-haunch"])?;
    rate_of_opening(d)?;
    slenderness_of_haunch(d)?;
    let (joint, one) = (Symbol::joint(), Symbol::Thrust.number().int(1));
    let (tau, n) = (slenderness(), fall_of_centroids());
    let arm = joint.versine() + tau.clone() * &joint.cos;
    let h = thrust_of_haunch();
    let normal = statics::normal_force(&joint, &h);
    let loss = (one.int(2) - &tau) * (normal * &tau + tau.square() * &n * &joint.cos);
    let asked = -along_the_square(&(h + centroids()));
    let words = "-E a, where a = h + g, h of (2), is what a haunch asks of A";
    d.on_circle(words, asked, loss / arm)?;
    let at = haunch_in_letters();
    let lack = one.int(2) - &at.thrust - &at.centroids;
    let (tau, half) = (&at.slenderness, one.ratio(1, 2));
    let normal = statics::normal_force(&joint, &at.thrust);
    let loss = (one.int(2) - tau) * (normal * tau + tau.square() * &joint.cos * &half);
    let arm = at.joint.versine.clone() + joint.cos.clone() * tau;
    let value = (lack.clone() + lack.square() * &half) * arm - loss;
    let scale = at.joint.excess.clone() * &at.joint.versine * &at.joint.versine;
    let words = "[y + y²/2 + E a] times the lever arm, with 1/2 for n, which is no more";
    d.on_circle(words, value, scale * at.rotation())?;
    d.conclude(
        "So y + y²/2 + E a is positive up to eta = 39/50, and E(A - a) is negative where A = a.",
    )?;
    let eta = ring().thickness;
    let far = eta.int(6) * &eta - eta.int(4) - eta.square();
    let whole = eta.int(2) + &eta;
    let (tau, g) = (slenderness(), one.int(2) / &whole);
    let value = tau.clone() * g - (one.clone() - tau).square() * one.int(2);
    let words = "tau (1 - tau/2) - 2 (1 - tau)²";
    d.on_circle(words, value, far.clone() * one.int(2) / whole.square())?;
    let least = eta.ratio(39, 50);
    let expected = (eta.clone() - &least) * (eta.ratio(261, 50) - &eta) + eta.ratio(179, 2500);
    d.identity("the bracket: positive from 39/50 on", far, expected)?;
    d.conclude(
        "Beyond, let w = q [1 + k], k = g (1 - cos(beta))/h: y = 2 - B + w, and w >= tau g/(1 - tau) >= tau, as g >= \
         1 - tau/2. The lever arm is 1 - cos(beta) times 1 + r, r = q s, and with n <= 1/2 what is left is, over 1 - \
         cos(beta), at least r (y - tau) + y + y²/2 - (2 - tau) w >= w [w/2 - (1 - tau)], positive as w > 2 (1 - \
         tau). In overturning A = g, and alpha/sin(alpha) - 1 > pi/2 - 1 > 1/2 >= (2 - tau) tau n = -E g.",
    )
}

fn shoulder(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-order", "safety-haunch", "rise-relief", "map-T-shoulder"])?;
    sliding_shoulder(d)?;
    slenderness_of_haunch(d)?;
    let (joint, tau) = (Symbol::joint(), slenderness());
    let h = thrust_of_haunch();
    let one = h.int(1);
    let normal = statics::normal_force(&joint, &h);
    let growth = (one.int(2) - &tau) * &tau * (normal - fall_of_centroids() * joint.versine());
    let arm = joint.versine() + tau * &joint.cos;
    d.on_circle("-E h, h of (2)", -along_the_square(&h), growth / arm)?;
    let at = haunch_in_letters();
    let normal = statics::normal_force(&joint, &at.thrust);
    let tau = &at.slenderness;
    let arm = at.joint.versine.clone() + joint.cos.clone() * tau;
    let words = "without n: q times the bound of the growth";
    let value = (one.int(2) - tau) * normal * tau / arm;
    d.on_circle(words, value, at.growth() * &at.joint.excess)?;
    let lack = one.clone() - &at.thrust;
    let thin = at.rest() * &at.joint.versine / (at.thrust.clone() * one.int(2));
    let bound = (one.int(2) + at.load() - &at.joint.lag - thin) * &at.joint.excess;
    let words = "1 - h, less g - 1 + tau/2, which is delta_M eta²/(6 (2 + eta))";
    let lift = at.centroids.clone() - &one + at.slenderness.clone() / one.int(2);
    d.on_circle(words, lack - lift, bound)?;
    let (eta, delta) = (ring().thickness, Symbol::Flag.number());
    let lift = centroids() - &one + slenderness() / one.int(2);
    let expected = delta * eta.square() / ((eta.int(2) + &eta) * eta.int(6));
    d.identity("that: not negative", lift, expected)?;
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let beyond = alpha.rad.clone() - alpha.rad.ratio(3, 2);
    let square = (h.ratio(1, 2) - &h).square();
    let expected = beyond * (alpha.rad.clone() + alpha.rad.ratio(1, 6)) + square;
    let value = relief() * &alpha.sin / alpha.versine() - h.ratio(4, 3);
    let words = "(alpha - h (1 - h)/alpha) - 4/3: positive from alpha = 3/2 on";
    d.on_circle(words, value, expected / &alpha.rad)?;
    for weight in SelfWeight::ALL {
        let thickness = landmark(Landmark::Triple, weight)?.thickness;
        d.less(format!("eta_T is less than 39/50, {weight}"), [&thickness, &number(39, 50)])?;
    }
    d.conclude(
        "Up to a half circle X is more than [3 (1 - h) + (1 - h)²]/2 >= [3 + (1 - h)] times the bound of 1 - h over \
         2; beyond, tan(alpha/2) >= 1 and X is at least 4/3. Both are more than -E h, so that X + E h is positive.",
    )
}

fn inner(d: &mut Derivation) -> Checked {
    lemmas(d, ["map-T-inner", "survey-corners"])?;
    let (haunch, shoulder) = (Symbol::joint(), Symbol::half_opening());
    let (h, tau, n) = (Symbol::Thrust.number(), slenderness(), fall_of_centroids());
    let (one, two) = (h.int(1), h.int(2));
    let sum = margin_at(Contact::Intrados, &haunch) + margin_at(Contact::Extrados, &shoulder);
    let margin = sum * &two / ring().extrados();
    let wedge = (shoulder.rad.clone() - &shoulder.sin) * shoulder.versine() / &shoulder.sin;
    let load = haunch.rad.clone() * &haunch.sin - (h.clone() + centroids()) * haunch.versine();
    let depth = haunch.cos.clone() - &shoulder.cos;
    let normal = statics::normal_force(&haunch, &h);
    let rest = one - &tau;
    let value = margin.clone() - along_the_square(&margin);
    let expected = wedge - load - tau.clone() * n * depth * (two - &tau) - rest * tau * normal;
    let words = "M - E M, where M = [L(beta) + U(alpha)]/(1 + eta/2) and h is kept";
    d.on_circle(words, value, expected)?;
    let tangent = |alpha: &Ball| alpha.sin_cos().0 / (alpha.sin_cos().1 + alpha.int(1));
    let wide = number(12, 5);
    let wedge = tangent(&wide) * (wide.clone() - wide.sin_cos().0);
    let words = "tan(alpha/2) (alpha - sin(alpha)) is more than 13/4 at alpha = 12/5, and grows";
    d.less(words, [&number(13, 4), &wedge])?;
    for weight in SelfWeight::ALL {
        let opening = landmark(Landmark::Triple, weight)?.half_opening.rad;
        d.less(format!("alpha_T is more than 12/5, {weight}"), [&wide, &opening])?;
    }
    d.conclude(
        "Here h <= 1 and beta < pi/2 < 8/5, as beta cot(beta) > h at the haunch. What is taken from the first term is \
         at most 8/5, 1 and 13/20, as tau (1 - tau) <= 1/4, n <= 1/2 and N <= 1 + 8/5: together 13/4. So M grows \
         where it is zero, as the half opening falls.",
    )
}

fn safety(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < mu <= inf, delta_M = 0 or 1, the thickness at most twice the radius of the centreline");
    lemmas(d, ["survey-corners", "modes-contacts", "modes-lever", "survey-rise"])?;
    lemmas(d, ["safety-rotation", "safety-shoulder", "safety-inner", "map-function"])?;
    lemmas(d, ["map-T-inner"])?;
    let alpha = Symbol::half_opening();
    let eta = ring().thickness;
    let kept = eta.clone() / alpha.versine().square();
    d.on_circle("E of eta/(1 - cos(alpha))²", along_the_square(&kept), eta.int(0))?;
    let (t, rise) = (Symbol::MeasuredThickness.number(), Symbol::Rise.number());
    for (circle, outwards) in [("intrados", 1), ("centreline", 0), ("extrados", -1)] {
        let radius = rise.clone() / alpha.versine() + t.ratio(outwards, 2) * &t;
        let ratio = t.clone() / radius;
        let rate = along_the_square(&ratio) / &ratio;
        let expected = t.int(1) + ratio.ratio(outwards, 2) * &ratio;
        let words = format!("2 less the rate of the logarithm of the measured eta, {circle}");
        d.on_circle(words, t.int(2) - rate, expected)?;
    }
    d.argue(
        "Let an arch stand, and let its half opening fall while eta/(1 - cos(alpha))² is kept. Take the least admissible \
         thrust h. It is h_R, the largest h of (2) of any joint, or the least that friction bears at the inner joints, \
         which is at most 1; from above it is bounded by the shoulder's extrados, as its lever arm is positive, and by its \
         friction. There are fewer joints, and h_R grows: let h follow it if it is h_R, and else be kept. A bound from \
         above that is not reached is not, on the next piece of the way, either. One that is reached is left. The \
         shoulder's extrados, if h is h_R: then U is zero at the crown too, so that h + g = A. If h = h_R = 0 at the \
         crown, as A = g is at most 1, and if h is that of friction, alpha is more than pi/2: the mode is [r,r,s], \
         [r,s,r] or [r,s], beyond T, where both thickness and friction are no less than at T. The shoulder's friction, if \
         h is that of the inner joints, as then fewer are asked, and if it is h_R: at each joint that asks for it, and so \
         for the largest. Without a limit of friction what stands is closed too, as the least thrust is then h_R, which \
         is continuous.",
    )?;
    d.theorems(["Attained.goes_on_standing"])?;
    d.argue(
        "So the least eta falls at least as fast as (1 - cos(alpha))² as the half opening falls, and the measured one, up \
         to 2, does not fall faster: their quotient does not fall.",
    )?;
    d.conclude(
        "Of one rise that is so for a longer span. An arch made larger has a smaller eta and the same least one. So, \
         as for the verdict, the shortest span with the highest rise has the least safety, with the least thickness \
         and friction, and the longest with the lowest the largest, with the largest.",
    )
}
