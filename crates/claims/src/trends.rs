//! The purely overturning states of the two weights beside each other: Fig. 3.

use super::along::landmark;
use super::landmarks::both;
use super::letters::{ring, with};
use super::measured::{at_least, at_most};
use super::overturning::opening_at;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::{SelfWeight, overturning, thrust};
use crate::number::{Angle, Ball, Field, degrees};
use crate::problem::Landmark::OverturningEnd;
use crate::symbolic::{Letters, Symbol};
use rug::Rational;

claims! {
    Measured("weights-overturning", "Sec. 2.1, Fig. 3", trends_compared):
        "for purely overturning modes the trends of eta differ to a quite limited extent between the two weights";
    Measured("overturning-growth", "Sec. 2.1, Fig. 4", growth):
        "towards eta = 2 the thickness of the overturning states grows almost vertically with the half opening";
    Measured("weights-range", "Sec. 2.1", ranges_compared):
        "the half openings of rotational states, purely overturning ones among them, end at about 150° for \
         Milankovitch's weight and about 160° for Heyman's";
}

/// `(1 - cos(alpha))/(alpha - sin(alpha))`, by which `A` makes `alpha` fall.
fn leverage(alpha: &Ball) -> Ball {
    let alpha = Angle::new(alpha.clone());
    alpha.versine() / (alpha.rad - alpha.sin)
}

fn trends_compared(d: &mut Derivation) -> Checked {
    lemmas(d, ["alpha-one-to-one"])?;
    let ring = ring();
    let (eta, delta) = (&ring.thickness, Symbol::Flag.number());
    let opening = overturning::opening_variable(&ring).value();
    let at = |n: i32| with(&opening, &[Symbol::Flag], &delta.int(n));
    let gap = at(1) - at(0);
    let words = "A at the same eta, Milankovitch's weight less Heyman's";
    d.identity(words, &gap, eta.square() / (eta.int(6) * ring.extrados()))?;
    let fall = eta.int(12) - (eta.int(4) + eta) * eta * &delta;
    let slope = -(fall / (eta.int(6) * ring.extrados().square()));
    d.identity("dA/d eta", opening.partial(Symbol::Thickness), &slope)?;
    let two = Rational::from(2);
    let [heyman_end, milankovitch_end] = SelfWeight::ALL.map(|weight| opening_at(weight, &two));
    let largest = Rational::from(&milankovitch_end - &heyman_end);
    d.equal("the largest difference in A, at eta = 2", &largest, &Rational::from((1, 6)))?;
    // alpha falls with A; on 1 <= eta <= 2 all of it lies between 5/2 and 14/5.
    let [low, high] = [(5, 2), (14, 5)].map(|x| Ball::enclosing(&Rational::from(x), 128));
    for (bound, eta, weight, is_above) in
        [(&low, 1, SelfWeight::Milankovitch, true), (&high, 2, SelfWeight::Heyman, false)]
    {
        let a = opening_at(weight, &bound.int(eta));
        let at_bound = thrust::opening_variable(&Angle::new(bound.clone())).value();
        let (side, order) = match is_above {
            true => ("above 5/2", [&a, &at_bound]),
            false => ("below 14/5", [&at_bound, &a]),
        };
        d.less(format!("alpha is {side} at eta = {eta}, {weight} weight"), order)?;
    }
    let margin = |n, m| leverage(&high) * low.int(n) - leverage(&low) * low.int(m);
    let words = "12 k(14/5) > 7 k(5/2), where k = (1 - cos)/(alpha - sin), d alpha = -k dA";
    d.above_zero(words, [&margin(12, 7), &margin(7, 12)])?;
    let falling = |alpha: &Ball| {
        let Angle { rad, sin, cos } = Angle::new(alpha.clone());
        (rad.int(1) - &cos).square() - (rad - &sin) * sin
    };
    let range = (&Rational::from((5, 2)), &Rational::from((14, 5)));
    d.positive("k falls: (1 - cos)² - (alpha - sin) sin", range, falling)?;
    d.conclude(
        "12 - 4 eta - eta² <= 7 for eta >= 1: as eta grows from 1 to 2, alpha grows faster for Heyman's \
         weight, so that the difference is largest at eta = 2.",
    )?;
    let [heyman, milankovitch] = both(|weight| landmark(OverturningEnd, weight))?;
    let difference = heyman.half_opening.rad - milankovitch.half_opening.rad;
    let degrees = degrees(&difference);
    let words = "alpha, at the same eta between 1 and 2";
    at_most(d, (words, &difference, ""), 3)?;
    at_most(d, ("in degrees", &degrees, "°"), 3)?;
    let thinner = opening_at(SelfWeight::Heyman, &Rational::from(1));
    let words = "A at eta = 1 with Heyman's weight is A_L with Milankovitch's, where eta = 2";
    d.equal(words, &thinner, &milankovitch_end)?;
    d.fails("eta at the same half opening: 2 and 1 at alpha_L, the only one where both overturn")
}

fn growth(d: &mut Derivation) -> Checked {
    lemmas(d, ["alpha-one-to-one"])?;
    let ring = ring();
    let opening = overturning::opening_variable(&ring).value();
    let slope = |weight: SelfWeight| {
        let at = |x| if x == Symbol::Flag { weight.flag() } else { 2 };
        let slope = opening.partial(Symbol::Thickness);
        slope.evaluate(&Rational::new(), |x| Rational::from(at(x)))
    };
    for (weight, expected) in [(SelfWeight::Milankovitch, (0, 1)), (SelfWeight::Heyman, (-1, 8))] {
        let words = format!("dA/d eta at eta = 2, {weight} weight");
        d.equal(words, &slope(weight), &Rational::from(expected))?;
    }
    d.holds("the slope is vertical at L, milankovitch weight")?;
    let alpha = landmark(OverturningEnd, SelfWeight::Heyman)?.half_opening.rad;
    let rise = alpha.int(8) / leverage(&alpha);
    at_least(d, ("d eta/d alpha at L, heyman weight", &rise, ""), 3)?;
    d.conclude(
        "d alpha = -k dA, with k = (1 - cos)/(alpha - sin): d eta/d alpha is -1/(k dA/d eta).",
    )
}

fn ranges_compared(d: &mut Derivation) -> Checked {
    let mut ends = Vec::new();
    for weight in [SelfWeight::Milankovitch, SelfWeight::Heyman] {
        let end = degrees(&landmark(OverturningEnd, weight)?.half_opening.rad);
        let words = format!("alpha_L, {weight} weight");
        at_most(d, (&words, &end, "°"), 4)?;
        ends.push(end);
    }
    let [narrow, wide] = [&ends[0], &ends[1]];
    d.less("150° is below alpha_L of Milankovitch's weight", [&narrow.int(150), narrow])?;
    d.less("160° is above alpha_L of Heyman's weight", [wide, &wide.int(160)])?;
    d.fails("150° is too small, 160° too large")
}
