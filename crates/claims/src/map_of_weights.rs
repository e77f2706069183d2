//! The two self-weights compared on the map: at one half opening and friction, and along the dividing lines.

use super::along::{around, landmark, on_sliding};
use super::contacts::cotangent_falls;
use super::landmarks::{both, semicircle, state_of};
use super::letters::ring;
use super::measured::shown;
use super::sign::{Positive, RingSigns};
use super::tiling::intrados_factor_grows;
use super::{Checked, Derivation, Finding, Support, claims, lemmas};
use crate::arch::{Ring, SelfWeight, statics, thrust};
use crate::certify::between;
use crate::number::{Angle, Ball, Dual, Enclosure, Field};
use crate::problem::Landmark;
use crate::symbolic::{Letters, Symbol};
use rug::Rational;

claims! {
    Ours("weights-shoulder-turns", "Sec. 3", thickness_where_the_shoulder_turns):
        "where the shoulder turns about the extrados, (3), the same thrust and half opening mean a larger thickness \
         for Milankovitch's weight";
    Ours("weights-joint-given", "Sec. 3", thickness_where_the_joint_is_given):
        "where the line of thrust touches the intrados, (5), the same thrust and joint mean a smaller thickness for \
         Milankovitch's weight";
    Finds("weights-same-opening", "Sec. 3", same_opening_compared):
        "in the eta-mu map the curves of one half opening lie lower for Milankovitch's weight: Heyman's is on the \
         safe side";
    Implicit("weights-lines-rise", "Sec. 3, Fig. 5", lines_rise):
        "in the eta-mu map each dividing line rises, so that what lies left of it lies above";
    Finds("weights-dividing-lines", "Sec. 3, Fig. 5", dividing_lines_compared):
        "in the eta-mu map the dividing lines of Milankovitch's weight lie always below and left of Heyman's";
}

/// Where the shoulder turns, (3) gives the thickness of a given thrust and half opening.
fn thickness_where_the_shoulder_turns(d: &mut Derivation) -> Checked {
    let (alpha, joint, h) = (Symbol::half_opening(), Symbol::joint(), Symbol::Thrust.number());
    let (eta, delta) = (Symbol::Thickness.number(), Symbol::Flag.number());
    let ring = Ring::with_flag(&delta, &eta);
    d.assume("0 < eta < 2, 0 <= delta_M <= 1, N(beta) > 0, beta < alpha");
    let margin = -(thrust::upper(&alpha, &joint, &ring).residual(&h) / h.int(2));
    let drop = joint.cos.clone() - &alpha.cos;
    let (extrados, intrados) = (ring.extrados() / h.int(2), ring.intrados() / h.int(2));
    let sum = extrados * statics::normal_force(&alpha, &h)
        - intrados * statics::normal_force(&joint, &h)
        - drop.clone() * &ring.centroid_factor;
    d.identity(
        "W, which vanishes where (3) holds, is the sum of the distances of the shoulder from the extrados \
         and of a joint from the intrados",
        &margin,
        &sum,
    )?;
    let words = "dW/d delta_M, negative";
    d.identity(words, margin.partial(Symbol::Flag), -(eta.square() * &drop / eta.int(12)))?;
    let rest = eta.int(12) * (eta.int(1) - &delta) + delta * ring.intrados() * (eta.int(6) + &eta);
    let normal = statics::normal_force(&joint, &h);
    d.identity(
        "(2 + eta) dW/d eta less W, positive",
        margin.partial(Symbol::Thickness) * ring.extrados() - &margin,
        h.int(2) * normal + drop * rest / h.int(12),
    )?;
    d.conclude(
        "So W/(2 + eta) grows with eta, and W falls as delta_M grows. Let a state of thickness eta_0 have \
         delta_M = 0, W = 0 at its joint, and an admissible one of thickness eta_1 have delta_M = 1 and \
         the shoulder on the extrados, so that W >= 0 at each joint. With delta_M = 1, W < 0 at eta_0 and \
         the joint of the first, and W >= 0 there at eta_1: eta_0 < eta_1.",
    )
}

/// (5) gives the thickness of a given thrust and joint.
fn thickness_where_the_joint_is_given(d: &mut Derivation) -> Checked {
    let (eta, delta) = (Symbol::Thickness.number(), Symbol::Flag.number());
    let ring = Ring::with_flag(&delta, &eta);
    let signs = RingSigns::of(d)?;
    let thrust = thrust::tangency(&Symbol::joint().times_cotangent(), &ring).value();
    let fall = |symbol| -thrust.partial(symbol);
    let square = signs.thickness.clone() * &signs.thickness;
    let words = "the fall of h_e with delta_M";
    (square / &(Positive::int(6) * &signs.intrados)).is(d, words, fall(Symbol::Flag))?;
    let gain = signs.flag * &signs.thickness * &signs.intrados / &Positive::int(3)
        + &(Positive::int(2) * &signs.factor);
    let words = "the fall of h_e with eta";
    (gain / &(signs.intrados.clone() * &signs.intrados)).is(d, words, fall(Symbol::Thickness))?;
    d.conclude("So with the thrust and the joint kept, the thickness falls as delta_M grows.")
}

/// No arch of Milankovitch's weight is as thin as that of Heyman's, unless its shoulder slides.
fn thicker_unless_the_shoulder_slides(d: &mut Derivation) -> Checked {
    lemmas(d, ["unique-thicker", "modes-lever"])?;
    let (alpha, joint, ring) = (Symbol::half_opening(), Symbol::joint(), ring());
    let (eta, h) = (&ring.thickness, Symbol::Thrust.number());
    let (lower, upper) = (thrust::lower(&joint, &ring), thrust::upper(&alpha, &joint, &ring));
    let crown = lower.residual(&h) / h.int(2);
    let shoulder = -(upper.residual(&h) / h.int(2));
    let (lever, arm) = (lower.denominator, upper.denominator);
    let words = "W falls as h grows, by the lever arm in (3)";
    d.identity(words, shoulder.partial(Symbol::Thrust), -(arm.clone() / h.int(2)))?;
    let drop = joint.cos.clone() - &alpha.cos;
    let slope = -(eta.square() * drop / eta.int(12));
    d.identity("and as delta_M grows", shoulder.partial(Symbol::Flag), &slope)?;
    let both = crown * arm + shoulder * lever;
    let words = "Z, V and W times the lever arms in (3) and (2), is free of h";
    d.identity(words, both.partial(Symbol::Thrust), h.int(0))?;
    let slope = -(eta.square() * eta * &joint.cos * alpha.versine() / eta.int(6));
    d.identity("Z falls as delta_M grows", both.partial(Symbol::Flag), &slope)?;
    d.theorems(["TwoWeights.heavier_is_thicker_unless_the_shoulder_slides"])?;
    d.theorems(["TwoWeights.heavier_is_thicker_without_limit"])
}

/// Arches of both weights, by half opening and friction, and whether Milankovitch's is the thicker one.
fn thicker(
    d: &mut Derivation,
    (alpha, friction): (&str, &str),
    is_thicker: bool,
) -> Checked<String> {
    let [heyman, milankovitch] = both(|weight| state_of(alpha, friction, weight))?;
    let (eta, other) = (&milankovitch.thickness, &heyman.thickness);
    let modes =
        format!("{} with Heyman's weight, {}", heyman.mode.label(), milankovitch.mode.label());
    let place = format!("at alpha = {alpha}, mu = {friction}");
    let (word, less, more) =
        if is_thicker { ("thicker", other, eta) } else { ("thinner", eta, other) };
    let words = format!("{place} Milankovitch's arch is {word}: {modes} with Milankovitch's");
    d.less(words, [less, more])?;
    Ok(format!("{place}: eta = {}, but {} for Heyman's weight", shown(eta, 6)?, shown(other, 6)?))
}

fn same_opening_compared(d: &mut Derivation) -> Checked<Finding> {
    lemmas(d, ["curve-order", "curve-weights"])?;
    thicker_unless_the_shoulder_slides(d)?;
    d.theorems(["TwoWeights.heavier_is_thinner_where_shoulders_slide"])?;
    let first = thicker(d, ("pi/2", "inf"), true)?;
    let second = thicker(d, ("2.6", "1.9"), true)?;
    thicker(d, ("pi/2", "0.38"), false)?;
    thicker(d, ("2.3", "1.071"), false)?;
    thicker(d, ("2.3", "1.083"), true)?;
    thicker(d, ("2.45", "1.324"), false)?;
    thicker(d, ("2.45", "1.338"), true)?;
    Ok(Finding::Misprint {
        counterexample: format!("{first}; {second}"),
        corrected: "at the same half opening and friction, where both stand, Milankovitch's thickness is the \
                    larger one, so that Heyman's weight is not on the safe side, unless the shoulder slides \
                    with Heyman's weight, [s,r,r]; it is the smaller one if it slides with both; if it slides \
                    with Heyman's alone, both occur",
    })
}

/// Proves that along the purely sliding states from T to B, of both weights, the shoulder loses room.
pub(super) fn room_falls_along_sliding(d: &mut Derivation) -> Checked {
    let [first, last] =
        [(Landmark::Triple, SelfWeight::Milankovitch), (Landmark::Border, SelfWeight::Heyman)].map(
            |(point, weight)| {
                landmark(point, weight).and_then(|at| around(&at.half_opening.rad, 100))
            },
        );
    let (low, high) = (first?.0, last?.1);
    let range = |(low, high): (i32, i32), scale| {
        between(&Rational::from((low, scale)), &Rational::from((high, scale)))
    };
    let any_ring = Ring { thickness: range((0, 2), 1), centroid_factor: range((3, 4), 3) };
    let any_joint = Angle::new(range((0, 8), 5));
    let falls = |range| {
        on_sliding(range, |all| {
            let slope = all.slope_along_sliding(|alpha, h| {
                let constant = |x: &Ball| Dual::constant(x.clone());
                let ring = Ring {
                    thickness: constant(&any_ring.thickness),
                    centroid_factor: constant(&any_ring.centroid_factor),
                };
                let joint = any_joint.clone().map(Dual::constant);
                thrust::upper(alpha, &joint, &ring).residual(h)
            });
            slope.is_positive()
        })
    };
    // Where the arch is narrow it rises.
    let [narrow, less] = [(1, 2), (3, 5)].map(Rational::from);
    let words = "W falls along pure sliding, at any joint up to 8/5, eta up to 2 and fac up to 4/3";
    let words = format!("{words}, alpha in [{low}, {high}]");
    d.certain(Support::Balls, words, [(&low, &high), (&narrow, &less)], falls)
}

/// Each line, in turn.
fn lines_rise(d: &mut Derivation) -> Checked {
    lemmas(d, ["friction-rotation", "curve-order", "friction-slopes"])?;
    d.conclude(
        "About pure rotation: M and m grow with alpha, as eta does. On [s,r,r]|[s,s], by (2) and (5), eta \
         grows as h falls, and so does mu.",
    )?;
    cotangent_falls(d)?;
    intrados_factor_grows(d, "d(2 fac/(2 - eta))/d eta, positive")?;
    for weight in SelfWeight::ALL {
        let thrust = landmark(Landmark::Triple, weight)?.thrust;
        let words = format!("h < 1/2 at T and beyond, {weight} weight");
        d.less(words, [&thrust, &thrust.ratio(1, 2)])?;
    }
    d.conclude(
        "On [r,r,s]|[r,s,r] and [r,s,r]|[r,s] (5) is h - beta cot(beta) = 1 - 2 fac/(2 - eta) at beta_s = \
         sqrt(h (1-h)), which grows with h < 1/2, or at the crown, where beta cot(beta) = 1: eta grows as h \
         falls and mu grows.",
    )?;
    lemmas(d, ["sliding-order", "weights-shoulder-turns"])?;
    room_falls_along_sliding(d)?;
    d.conclude(
        "About pure sliding from T to B, W = 0 at the joint, which by (5) is below pi/2. Further along W < 0 \
         there at the same thickness and, as W/(2 + eta) grows with eta, at each smaller one: eta grows.",
    )
}

fn dividing_lines_compared(d: &mut Derivation) -> Checked<Finding> {
    lemmas(d, ["weights-lines-rise", "curve-weights", "friction-slopes"])?;
    d.conclude(
        "About pure rotation, at one thickness, alpha and h are smaller for Milankovitch's weight, so that M \
         is smaller, as mu_ss grows with both, and m = mu_is(h) is larger: [r,r,r]|[s,r,r] lies left, \
         [r,r,r]|[r,r,s] right.",
    )?;
    lemmas(d, ["weights-shoulder-turns", "weights-joint-given"])?;
    d.conclude(
        "On the other lines friction gives the thrust by (18) and, on those about pure sliding, the half \
         opening too, the same for both weights. On [s,r,r]|[s,s] the thickness follows from (2) and (5), \
         on [r,r,s]|[r,s,r] and [r,s,r]|[r,s] from (5) at beta_s or at the crown: it is smaller for \
         Milankovitch's weight. On the lines from T to B about pure sliding it follows from (3): it is \
         larger.",
    )?;
    let [heyman, milankovitch] = both(semicircle)?;
    let words = "the semicircle's point on the first line is higher for Milankovitch's weight";
    d.less(words, [&heyman[0], &milankovitch[0]])?;
    d.less("and further left", [&milankovitch[1], &heyman[1]])?;
    Ok(Finding::Misprint {
        counterexample: format!(
            "[r,r,r]|[s,r,r] at alpha = pi/2: mu = {}, eta = {} for Milankovitch's weight is left of and \
             above mu = {}, eta = {} for Heyman's, on a line that rises",
            shown(&milankovitch[1], 6)?,
            shown(&milankovitch[0], 6)?,
            shown(&heyman[1], 6)?,
            shown(&heyman[0], 6)?
        ),
        corrected: "as each line rises, left of it is above it, and right below: Milankovitch's lines lie left \
                    of Heyman's and above where they are [r,r,r]|[s,r,r] or, from T to B, bound pure sliding; \
                    the others, [r,r,r]|[r,r,s], [s,r,r]|[s,s], [r,r,s]|[r,s,r] and [r,s,r]|[r,s], lie right \
                    and below",
    })
}
