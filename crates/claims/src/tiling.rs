//! The map as the graph of one function: to each thickness and friction belongs one half opening that just stands,
//! and two questions tell its mode.
//!
//! The inner part asks for a thrust: at least `h_R` of the rotational state of the thickness, so that the line of
//! thrust stays between crown and haunch, and at least `h_s` of the friction, so that no inner joint slides. The
//! shoulder ends the arch where it is on the extrados or where it slides, and does so the later the smaller the thrust.

use super::along::landmark;
use super::contacts::margin_at;
use super::letters::{ring, variables};
use super::overturning::end_of_rotation_is_simple;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::{Ring, SelfWeight, contact, overturning, sliding, statics, thrust};
use crate::number::{Angle, Field};
use crate::problem::Landmark;
use crate::symbolic::{Letters, Symbol, along_the_joint};

claims! {
    AsPrinted("map-columns", "Sec. 3, Fig. 5, 6", columns):
        "the modes fill the map: at a given friction they follow each other, as the thickness grows, in the order \
         [r,r,r], [s,r,r], [r,r,s], [r,s,r], [r,s], [s,s], each on an interval or not at all; the second is left of \
         T, the next three are right of it";
    Ours("map-rows", "Sec. 3, Fig. 5, 6", rows):
        "at a given half opening the modes follow each other as the friction grows: before T [s,s], [s,r,r], \
         [r,r,r], beyond T [s,s], [r,s], [r,s,r], [r,r,s], [r,r,r], each on an interval or not at all, so that the \
         line of a half opening meets each domain at most once";
    AsPrinted("map-T-frictions", "Sec. 3", frictions_beyond_t):
        "beyond T an inner joint asks for a higher friction than the shoulder, in the purely rotational states and, \
         without limit, in the purely overturning ones; in the mixed ones it takes all there is";
    AsPrinted("map-beyond-l", "Sec. 5", overturning_sliding_beyond_l):
        "beyond alpha_l finite friction makes overturning states overturning-sliding: at its least thickness [r,s] \
         moves the arch, and no other symmetric mode but, at its least friction, [s,s] as well";
}

fn columns(d: &mut Derivation) -> Checked {
    d.assume("0 < eta <= 2, 0 < mu < inf");
    lemmas(d, ["map-function", "modes-seven", "modes-contacts", "unique-thicker"])?;
    lemmas(d, ["friction-slopes", "friction-unbounded", "curve-order", "friction-rotation"])?;
    lemmas(d, ["map-T-inner", "map-T-shoulder"])?;
    let (at, ring) = (variables(), ring());
    let two = at.thrust.int(2);
    let lower = thrust::lower(&at.rotation_joint, &ring);
    let sum = margin_at(Contact::Extrados, &Angle::zero(&two))
        + margin_at(Contact::Intrados, &at.rotation_joint);
    let words = "U at the crown and L at a joint add up to h - h_L up to a positive factor";
    d.identity(words, &sum, lower.residual(&at.thrust) / &two)?;
    let h = lower.value();
    let whole = h.clone() + overturning::opening_variable(&ring).value();
    let further = two.clone() * &ring.thickness * &h
        / (ring.intrados() * at.rotation_joint.versine())
        + two.clone() * &ring.centroid_factor * (two.clone() * &ring.thickness)
            / (ring.intrados() * ring.extrados());
    let words = "A(beta) less A(alpha_0) along rotation: positive, so that beta < alpha_0";
    let wider = thrust::opening_variable(&at.rotation_joint).value() - whole;
    d.identity(words, &wider, &further)?;
    let touching = thrust::tangency(&at.rotation_joint.times_cotangent(), &ring).value();
    let excess =
        ring.thickness.clone() + Symbol::Flag.number() * ring.thickness.square() / two.int(6);
    let words = "beta cot(beta) less the thrust of (5): positive";
    let lack = at.rotation_joint.times_cotangent() - touching;
    d.identity(words, &lack, excess / ring.intrados())?;
    let outwards = (at.thrust.clone() - at.half_opening.times_cotangent()) * &at.half_opening.sin;
    let words = "-T at the shoulder: positive where it slides, so that h > alpha cot(alpha)";
    d.identity(words, -statics::shear_force(&at.half_opening, &at.thrust), &outwards)?;
    falls_with_the_thickness(d)?;
    d.theorems(["Map.each_point_has_a_mode", "Map.modes_of_a_column"])?;
    d.theorems(["Map.intervals_of_a_column"])?;
    d.conclude(
        "M grows along rotation, with the half opening and so with the thickness. [s,r,r] has at most the half opening \
         and the thickness of T, [r,r,s], [r,s,r] and [r,s] at least.",
    )
}

/// Proves that `beta_s` falls with the friction right of T: `h_s` falls from `h_T` on.
pub(super) fn thrust_at_triple_is_below_half(d: &mut Derivation, weight: SelfWeight) -> Checked {
    let thrust = landmark(Landmark::Triple, weight)?.thrust;
    d.less(format!("h_T < 1/2, {weight}"), [&thrust, &thrust.ratio(1, 2)])
}

/// By (5) the rotational joint falls as the thickness grows.
pub(super) fn falls_with_the_thickness(d: &mut Derivation) -> Checked {
    intrados_factor_grows(d, "2 fac/(2 - eta), by which beta_r falls in (5), grows")
}

/// `2 fac/(2 - eta)` grows with the thickness.
pub(super) fn intrados_factor_grows(d: &mut Derivation, words: &str) -> Checked {
    let (ring, delta) = (ring(), Symbol::Flag.number());
    let factor = delta.int(2) * &ring.centroid_factor;
    let slope = (factor.clone() / ring.intrados()).partial(Symbol::Thickness);
    let gain = factor + delta * &ring.thickness * ring.intrados() / ring.thickness.int(3);
    d.identity(words, slope, gain / ring.intrados().square())
}

fn rows(d: &mut Derivation) -> Checked {
    d.assume("0 < mu < inf, and the arch stands at a thickness up to 2");
    lemmas(d, ["modes-seven", "unique-thickness", "friction-slopes", "sliding-order"])?;
    lemmas(d, ["friction-rotation", "map-T-inner", "map-T-shoulder"])?;
    let at = variables();
    falls_with_the_thickness(d)?;
    for weight in SelfWeight::ALL {
        let (h, ring) = (&at.thrust, Ring::new(weight, &at.thickness));
        let side = h.int(2) * &ring.centroid_factor / ring.intrados() + h - h.int(1);
        let slope = contact::crown_slope(weight, &at) * h.int(2) / ring.intrados();
        let words = format!(
            "the slope at the crown, up to a factor: h - 1 + 2 fac/(2 - eta), of (5), less 1, {weight}"
        );
        d.identity(words, &slope, side - h.int(1))?;
        thrust_at_triple_is_below_half(d, weight)?;
    }
    let square = (at.thrust.int(1) - &at.thrust) * &at.thrust;
    let slope = at.thrust.int(1) - at.thrust.int(2) * &at.thrust;
    d.identity("d beta_s²/dh, positive below 1/2", square.partial(Symbol::Thrust), &slope)?;
    d.conclude(
        "Where an inner joint slides and the shoulder turns, mu >= mu_T: h is at most h_T, below 1/2. [s,r,r] is before \
         T: no other half opening than alpha_T has both.",
    )?;
    d.theorems(["Map.modes_of_a_row"])?;
    d.conclude(
        "At each friction at which the arch stands one of the modes moves it at its least thickness: so each is on an \
         interval or not at all.",
    )
}

fn frictions_beyond_t(d: &mut Derivation) -> Checked {
    lemmas(d, ["map-T", "friction-unbounded"])?;
    let alpha = Symbol::half_opening();
    let none = alpha.rad.int(0);
    let words = "the friction that the shoulder asks for without thrust: bounded, as alpha < pi";
    d.identity(words, sliding::shoulder(&alpha, &none).value(), -(alpha.cos / alpha.sin))?;
    d.conclude(
        "In [r,r,r] beyond T, M < m; in [r], m is unbounded. In [r,r,s], [r,s,r] and [r,s] mu = mu_is, and the \
         shoulder, which does not slide, asks for no more.",
    )
}

fn overturning_sliding_beyond_l(d: &mut Derivation) -> Checked {
    d.assume("alpha_l <= alpha < pi, 0 < mu < inf, and the arch stands at a thickness up to 2");
    lemmas(d, ["modes-contacts", "modes-seven", "curve-order", "unique-work", "unique-thicker"])?;
    lemmas(d, ["unique-thickness"])?;
    let (joint, h, ring) = (Symbol::joint(), Symbol::Thrust.number(), ring());
    let condition = overturning::end_of_rotation(&ring);
    let words = "the condition behind (16) falls as eta grows";
    end_of_rotation_is_simple(d, words, |_| String::new())?;
    let fall = (h.int(1) - joint.times_cotangent() + &h) * ring.intrados() / h.int(2);
    d.on_circle(
        "dL/d beta: positive where that condition is not, as beta cot(beta) < 1 and h > 0",
        margin_at(Contact::Intrados, &joint).derivative(&along_the_joint()),
        (fall - condition) * &joint.sin,
    )?;
    d.conclude(
        "The parts of the arch stand, so that eta is at least the thickness of the rotational state of each half \
         opening below alpha_l, or there would be room at that: eta >= eta_l. So L grows, and is zero at the crown \
         alone, where then U = eta h > 0: no hinge opens at the crown's extrados, which leaves [r,s] and [s,s]. One \
         of them moves at the least thickness.",
    )?;
    d.conclude(
        "If [s,s] does, mu is the friction of pure sliding, the least with which the arch stands, and a thinner arch \
         has the same thrust. So none stands only if U = 0 at the shoulder with L = 0 at the crown, and then [r,s] \
         moves too.",
    )
}

#[cfg(test)]
mod tests {
    use super::CLAIMS;
    use crate::problem::Mode;

    /// The claims say the orders that stand in `problem`; one turned round is said nowhere.
    #[test]
    fn the_orders_said_are_those_of_the_problem() {
        let said = |id: &str| CLAIMS.iter().find(|claim| claim.id == id).unwrap().statement;
        let words =
            |order: &[Mode]| order.iter().map(|of| of.label()).collect::<Vec<_>>().join(", ");
        let orders = [("map-columns", Mode::COLUMNS[0])];
        let rows = [Mode::ROWS[0], Mode::ROWS[1]].map(|row| ("map-rows", row));
        for (id, order) in orders.into_iter().chain(rows) {
            assert!(said(id).contains(&words(order)), "{id}");
            let turned: Vec<Mode> = order.iter().rev().copied().collect();
            assert!(!said(id).contains(&words(&turned)), "false twin");
        }
    }
}
