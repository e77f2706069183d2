//! Places of the modes on the map: T, S, J and B as limits of the modes, sections 3 and 5.
//!
//! All about mixed modes follows from the order of the two frictions along rotation, since an admissible
//! state with a hinge at the shoulder has at least the thrust of rotation, and one that slides there has
//! at most the half opening of rotation.

use super::along::{CurveStates, around, below, landmark, on_all, on_sliding};
use super::letters::{variables, with};
use super::{Checked, Derivation, Support, claims, lemmas};
use crate::arch::{Ring, SelfWeight, contact, sliding, statics, thrust};
use crate::number::{Angle, Ball, Enclosure, Field, Real};
use crate::problem::Landmark;
use crate::symbolic::{Fraction, Letters, Symbol};
use rug::Rational;

claims! {
    AsPrinted("map-T-shoulder", "Sec. 3, 5", no_shoulder_sliding_beyond_t):
        "a friction above mu_T precludes any mixed sliding-rotational mode; its thickness is at most eta_T and its \
         half opening at most alpha_T";
    AsPrinted("map-T-inner", "Sec. 3, 5", inner_sliding_beyond_t):
        "modes with shoulder rotation and inner sliding are seen only on the right of T, and above it";
    Implicit("map-S", "Sec. 3, Fig. 6", shift_beyond_s):
        "modes with the sliding joint below the rotational one are seen only on the right of S, and above it";
    AsPrinted("map-J", "Sec. 3", overturning_sliding_beyond_j):
        "overturning-sliding modes are seen only on the right of J, and above it";
    AsPrinted("map-B", "Sec. 3, 5", pure_sliding_ends_at_b):
        "a friction above mu_B precludes any purely sliding mode of thickness up to 2; each one below has such a \
         mode";
}

/// The shoulder's distance from the extrados with the crown's pressure point on the extrados.
fn shoulder_margin(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-order", "friction-slopes", "friction-rotation", "map-T"])?;
    let at = variables();
    for weight in SelfWeight::ALL {
        let ring = Ring::new(weight, &at.thickness);
        let whole = thrust::whole(&at.half_opening, &ring);
        let margin = contact::extrados_margin_at_shoulder(weight, &at, &contact::crown_moment(&at));
        let expected = (whole.value() - &at.thrust) * whole.denominator / at.thrust.int(2);
        let words = format!(
            "the distance of the shoulder from the extrados, if the crown is on it, is h_2 - h up to \
             a positive factor, {weight} weight"
        );
        d.identity(words, &margin, &expected)?;
    }
    Ok(())
}

fn no_shoulder_sliding_beyond_t(d: &mut Derivation) -> Checked {
    shoulder_margin(d)?;
    d.theorems(["Map.sliding_shoulder_before_T"])?;
    d.conclude(
        "It has the thickness and thrust of a rotational state of half opening alpha_0 >= alpha, with M >= m: alpha <= \
         alpha_0 <= alpha_T, eta <= eta_T, and mu <= M(alpha_0) <= mu_T.",
    )
}

fn inner_sliding_beyond_t(d: &mut Derivation) -> Checked {
    shoulder_margin(d)?;
    d.theorems(["Mechanisms.shoulder_hinge_keeps_rotation"])?;
    d.conclude(
        "For alpha < alpha_l, mu = mu_is(h) <= m(alpha) and mu >= mu_ss(alpha, h) >= M(alpha): so M <= m, and alpha >= alpha_T, \
         eta >= eta_T and mu >= M(alpha) >= mu_T. From alpha_l on the parts of the arch stand, so that eta >= eta_l, and mu >= \
         mu_ss(alpha, 0) >= mu_ss(alpha_l, 0), the limit of M.",
    )
}

/// A line on which the rotational joint is known: at the crown, or where the inner joint slides.
#[derive(Clone, Copy, PartialEq, Eq)]
enum HaunchPlace {
    Crown,
    Sliding,
}

impl HaunchPlace {
    fn joint<T: Real>(self, h: &T) -> Angle<T> {
        match self {
            Self::Crown => Angle::zero(h),
            Self::Sliding => Angle::new((h.clone() * (h.int(1) - h)).sqrt()),
        }
    }

    /// The thickness at which the line of thrust of this thrust touches the intrados there, (5).
    fn thickness<T: Real>(self, weight: SelfWeight, h: &T) -> T {
        let cotangent = match self {
            Self::Crown => h.int(1),
            Self::Sliding => self.joint(h).times_cotangent(),
        };
        let sum = cotangent + h.int(1) - h;
        match weight {
            SelfWeight::Heyman => sum.int(2) - sum.int(2) / sum,
            SelfWeight::Milankovitch => {
                let radicand = sum.square() + (sum.clone() - sum.int(1)) * sum.ratio(4, 3);
                (radicand.sqrt() - &sum) * sum.int(3)
            }
        }
    }

    /// `U` at another joint with `L = 0` at the haunch, at this thickness.
    fn room<T: Real>(self, weight: SelfWeight, other: &Angle<T>, h: &T) -> T {
        let ring = Ring::new(weight, &self.thickness(weight, h));
        let joint = self.joint(h);
        let (outer, inner) = (statics::normal_force(other, h), statics::normal_force(&joint, h));
        (ring.extrados() * outer - ring.intrados() * inner) / h.int(2)
            - (joint.cos - &other.cos) * &ring.centroid_factor
    }
}

/// The thickness at which the line of thrust touches the intrados, from (5) solved for it.
fn touching_thickness(d: &mut Derivation) -> Checked {
    let (h, q, cotangent) =
        (Symbol::Thrust.number(), Symbol::SquareRoot.number(), Symbol::joint().times_cotangent());
    let sum = cotangent.clone() + h.int(1) - &h;
    let radicand = sum.square() + (sum.clone() - h.int(1)) * h.ratio(4, 3);
    let cases = [
        (SelfWeight::Heyman, h.int(2) - h.int(2) / &sum),
        (SelfWeight::Milankovitch, (q.clone() - &sum) * h.int(3)),
    ];
    for (weight, thickness) in cases {
        let residual = thrust::tangency(&cotangent, &Ring::new(weight, &thickness)).residual(&h);
        let words = format!("(5) holds at eta_5, {weight} weight");
        let expected = (q.square() - &radicand) * h.ratio(3, 2) * h.int(weight.flag());
        d.identity(words, &residual, &expected)?;
    }
    d.conclude("The last is zero, as q is the square root of the radicand.")
}

fn shift_beyond_s(d: &mut Derivation) -> Checked {
    only_beyond(d, HaunchPlace::Sliding, Landmark::Shift)?;
    d.conclude(
        "[r,s,r] has beta_r < beta_s, so that eta > eta_5(h), as by (5) beta_r falls as eta grows. So mu >= mu_S, h \
         <= h_S and eta >= eta_5(h_S) = eta_S, as beta_s cot(beta_s) - h falls with h below 1/2, and eta_5 with it.",
    )
}

fn overturning_sliding_beyond_j(d: &mut Derivation) -> Checked {
    only_beyond(d, HaunchPlace::Crown, Landmark::Junction)?;
    d.conclude(
        "[r,s] has L = 0 at the crown with a slope that is not negative and grows with eta, so that eta >= eta_5(h). \
         So mu >= mu_J, h <= h_J and eta >= eta_5(h_J) = eta_J, as eta_5 falls with h.",
    )
}

/// Left of a landmark the purely sliding arch stands at the thickness of (5).
fn only_beyond(d: &mut Derivation, haunch: HaunchPlace, end: Landmark) -> Checked {
    lemmas(d, ["friction-slopes", "map-T-inner", "sliding-order", "unique-thicker"])?;
    lemmas(d, ["map-function"])?;
    touching_thickness(d)?;
    let sliding = CurveStates::sliding;
    let symbol = end.symbol();
    for weight in SelfWeight::ALL {
        let start = below(&landmark(Landmark::Triple, weight)?.half_opening.rad, 100)?;
        let (before, beyond) = around(&landmark(end, weight)?.half_opening.rad, 1000)?;
        let shoulder = |at: &CurveStates| haunch.room(weight, &at.alpha, &at.thrust);
        let further = beyond.clone() + Rational::from((1, 100));
        let words = format!("U at the shoulder, along sliding from {start} to {before}, {weight}");
        d.certain(Support::Balls, words, [(&start, &before), (&beyond, &further)], |range| {
            on_sliding(range, |all| shoulder(all).is_positive())
        })?;
        // At three, beyond the shoulder, there is no room.
        let words = format!("U at the crown, along sliding from {start} to {beyond}, {weight}");
        d.certain(Support::Balls, words, [0, 3], |joint| {
            let room = |at: &CurveStates| {
                haunch.room(weight, &Angle::new(at.thrust.int(joint)), &at.thrust)
            };
            let range = (&start, &beyond);
            on_sliding(range, |all| room(all).is_positive())
        })?;
        let all = sliding(&before)?.up_to(&sliding(&beyond)?);
        let slope = all.slope_along_sliding(|alpha, h| haunch.room(weight, alpha, h));
        let words = format!(
            "U at the shoulder falls from {before} to {beyond}, which holds alpha_{symbol}, {weight}"
        );
        d.less(words, [&slope, &slope.int(0)])?;
    }
    d.conclude(format!(
        "Let mu_T <= mu < mu_{symbol}. The arch that just slides stands at the thickness eta_5 of its thrust h, with \
         room at crown and shoulder, and at each larger one with room at all faces. There [s,s] moves, and no other \
         half opening has a mechanism; this one has none that turns at the shoulder."
    ))
}

/// The largest `n` at which no thickness up to 2 holds the shoulder of a purely sliding state.
fn bound_at_b(weight: SelfWeight) -> Rational {
    Ring::new(weight, &Rational::from(2)).centroid_factor / 2
}

fn pure_sliding_ends_at_b(d: &mut Derivation) -> Checked {
    lemmas(d, ["map-distances", "friction-slopes", "sliding-order", "alpha-one-to-one"])?;
    let (n, eta) = (Symbol::OpeningVariable.number(), Symbol::Thickness.number());
    let margin = |weight| {
        let ring = Ring::new(weight, &eta);
        ring.extrados() * &n / eta.int(2) - ring.centroid_factor
    };
    d.identity(
        "the largest U at the shoulder over 1 - cos, with n = N/(1 - cos), Heyman's weight: linear",
        margin(SelfWeight::Heyman),
        (eta.int(2) - &eta) / eta.int(2) * (n.clone() - n.int(1))
            + eta.clone() / eta.int(2) * (n.int(2) * &n - n.int(1)),
    )?;
    let top = (n.int(3) * &n - n.int(2)) * (n.clone() + n.int(2)) / n.int(4);
    d.identity(
        "the same for Milankovitch's weight: a top at eta = 3n",
        margin(SelfWeight::Milankovitch),
        top - (eta.clone() - n.int(3) * &n).square() / n.int(12),
    )?;
    d.conclude(
        "It is negative for all eta in (0, 2] if n < 1/2 (Heyman), n < 2/3 (Milankovitch).",
    )?;
    for weight in SelfWeight::ALL {
        let thick = with(&margin(weight), &[Symbol::Thickness], &n.int(2));
        let excess = (n.clone() - Fraction::from(bound_at_b(weight))) * n.int(2);
        let words = format!("at eta = 2 it is positive above this bound, {weight}");
        d.identity(&words, &thick, &excess)?;
    }
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let normal = statics::normal_force(&alpha, &h) / alpha.versine();
    let opening = thrust::opening_variable(&alpha).value();
    let rest = h * &alpha.cos / alpha.versine();
    d.identity("n, with cos < 0 below A", &normal, opening + rest)?;
    for weight in SelfWeight::ALL {
        let sliding = CurveStates::sliding;
        let border = landmark(Landmark::Border, weight)?.half_opening.rad;
        let end = landmark(Landmark::OverturningEnd, weight)?.half_opening;
        let (before, beyond) = around(&border, 1000)?;
        let all = sliding(&before)?.up_to(&sliding(&beyond)?);
        let slope =
            all.slope_along_sliding(|alpha, h| statics::normal_force(alpha, h) / alpha.versine());
        let words = format!("n falls from {before} to {beyond}, which holds alpha_B, {weight}");
        d.less(words, [&slope, &slope.int(0)])?;
        // A(alpha) passes below the bound at L.
        let bound = Ball::enclosing(&bound_at_b(weight), 128);
        let last = below(&end.rad, 1000)?;
        // The first part falls with alpha, the second with h and, as cos/(1 - cos) does, with alpha.
        let largest = |alpha: &Angle<Ball>, thrust: &Ball| {
            thrust::opening_variable(alpha).value() + thrust.clone() * &alpha.cos / alpha.versine()
        };
        let first = Rational::from((3, 2));
        let opening = thrust::opening_variable(&Angle::new(Ball::enclosing(&first, 128))).value();
        d.less(format!("A is above the bound at {first}, {weight}"), [&bound, &opening])?;
        // What holds before B does not beyond.
        let ranges = [(&first, &before), (&beyond, &last)];
        let words = format!("n is above the bound from {first} to {before}, {weight}");
        d.certain(Support::Balls, words, ranges, |range| {
            let above = |all: &CurveStates| bound.is_less_than(&largest(&all.alpha, &all.thrust));
            on_sliding(range, above)
        })?;
        let words = format!("n is below the bound from {beyond} to {last}, {weight}");
        d.certain(Support::Balls, words, [ranges[1], ranges[0]], |range| {
            on_all(range, &CurveStates::sliding, &|a, b| {
                largest(&a.alpha, &b.thrust).is_less_than(&bound)
            })
        })?;
        let least = Ball::enclosing(&Rational::from((1, 50)), 128);
        let joint = Angle::new((least.clone() * (least.int(1) - &least)).sqrt());
        let (inner, shoulder) =
            (sliding::inner(&joint, &least).value(), sliding::shoulder(&end, &least).value());
        let words =
            format!("mu_ss < mu_is at alpha_L for h = 1/50, so h is larger there, {weight}");
        d.less(words, [&shoulder, &inner])?;
        // The larger the thrust, the smaller it is there, as cos(alpha) < 0.
        let normal = |thrust: &Ball| statics::normal_force(&end, thrust);
        d.above_zero(format!("N > 0 there, {weight}"), [&normal(&least), &normal(&least.int(50))])?;
        let value = largest(&Angle::new(Ball::enclosing(&last, 128)), &least);
        d.less(format!("n is below the bound from {last} to alpha_L, {weight}"), [&value, &bound])?;
    }
    d.conclude(
        "At B n is the bound, by (3) at eta = 2; beyond it n is below, and from alpha_L on so is A, \
         above n. A friction above mu_B makes alpha > alpha_B along the purely sliding states, where U \
         at the shoulder is negative for every thickness up to 2, wherever the thrust acts.",
    )?;
    d.conclude(
        "Before B n is above the bound, for alpha < 3/2 since n > A and A falls. At eta = 2 each of these states \
         stands with a small p > 0: L >= p, U > 0 from crown to shoulder, and T/N is largest at beta_s, -T/N at the \
         shoulder: [s,s]. Their frictions are all those below mu_B: mu goes to 0 with alpha, as alpha cot(alpha) < h \
         < 1.",
    )
}
