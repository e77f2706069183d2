//! The line from J to B, between overturning-sliding and pure sliding.
//!
//! Its states are purely sliding, with (3) at `beta = 0`: over `1 - cos(alpha)` that is
//!
//! ```text
//! a + c eta = fac,   a = A - h,   c = (A + h cot²(alpha/2))/2
//! ```
//!
//! where `a` and `c` do not depend on the weight.

use super::along::{CurveStates, around, below, landmark, on_sliding};
use super::measured::{at_least, at_most, shown};
use super::{Checked, Derivation, Finding, Support, claims, lemmas};
use crate::arch::{Ring, SelfWeight, sliding, thrust};
use crate::certify::{Undecided, between};
use crate::number::{Angle, Ball, Enclosure, Field};
use crate::problem::Landmark;
use crate::symbolic::{Letters, Symbol};
use rug::Rational;

claims! {
    AsPrinted("weights-J-B", "Sec. 3, Fig. 5", divide_deviates):
        "from J to B the divide deviates to the left for Milankovitch's weight, the more the larger the thickness";
    Measured("weights-B-slope", "Sec. 3, Fig. 5", slope_at_the_border):
        "for Milankovitch's weight the divide arrives almost vertically at B";
    Finds("weights-B-opening", "Sec. 3, Fig. 5", saturation_along_the_opening):
        "for Milankovitch's weight the friction along the divide saturates as the half opening grows";
}

/// `a` and `c`.
fn parts<T: Field>(alpha: &Angle<T>, h: &T) -> [T; 2] {
    let opening = thrust::opening_variable(alpha).value();
    let rest = (alpha.cos.int(1) + &alpha.cos) / alpha.versine() * h;
    [opening.clone() - h, (opening + rest) / h.int(2)]
}

/// Along pure sliding, the slopes of `a`, `c` and `mu` to the half opening.
struct SlidingSlopes {
    a: Ball,
    c: Ball,
    friction: Ball,
}

fn slopes(at: &CurveStates) -> SlidingSlopes {
    let part = |n: usize| at.slope_along_sliding(|alpha, h| parts(alpha, h)[n].clone());
    let friction = at.slope_along_sliding(|alpha, h| sliding::shoulder(alpha, h).value());
    SlidingSlopes { a: part(0), c: part(1), friction }
}

fn equation(d: &mut Derivation) -> Checked {
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let (eta, delta) = (Symbol::Thickness.number(), Symbol::Flag.number());
    let ring = Ring::with_flag(&delta, &eta);
    let third = thrust::upper(&alpha, &Angle::zero(&h), &ring).residual(&h);
    let [a, c] = parts(&alpha, &h);
    let sum = a + c * &eta - &ring.centroid_factor;
    let words = "(3) at beta = 0, cleared, is fac - a - c eta up to a factor";
    d.identity(words, &third, -(sum * alpha.versine() * h.int(2)))
}

fn divide_deviates(d: &mut Derivation) -> Checked {
    lemmas(d, ["weights-lines-rise", "weights-shoulder-turns"])?;
    equation(d)?;
    let (eta, c) = (Symbol::Thickness.number(), Symbol::F.number());
    let ring = Ring::new(SelfWeight::Milankovitch, &eta);
    let a = ring.centroid_factor.clone() - c.clone() * &eta;
    d.identity(
        "c² - (1 - a)/3 where a + c eta = fac, Milankovitch's weight",
        c.square() - (c.int(1) - a) / c.int(3),
        (c.clone() - eta.clone() / eta.int(6)).square(),
    )?;
    for weight in SelfWeight::ALL {
        let first = below(&landmark(Landmark::Junction, weight)?.half_opening.rad, 100)?;
        let last = around(&landmark(Landmark::Border, weight)?.half_opening.rad, 100)?.1;
        let holds = |at: &CurveStates, (n, m): (i32, i32)| {
            let [a, c] = parts(&at.alpha, &at.thrust);
            let bound = c.ratio(n, m);
            let slopes = slopes(at);
            let rest = a.int(1) - a;
            match weight {
                SelfWeight::Heyman => {
                    let pull = (slopes.a + slopes.c * (rest / &c)) * bound;
                    (slopes.friction * c + pull).is_positive()
                }
                SelfWeight::Milankovitch => {
                    let any = between(&Rational::from((4, 5)), &Rational::from(2));
                    let pull = (slopes.a + slopes.c * any) * bound;
                    let push = slopes.friction.square() * (c.square() - rest / c.int(3));
                    (pull.square() - push).is_positive()
                }
            }
        };
        let (side, bounds) = match weight {
            SelfWeight::Heyman => ("above 4/5", [(4, 5), (4, 1)]),
            SelfWeight::Milankovitch => ("below 7/10", [(7, 10), (1, 10)]),
        };
        let words = format!("d mu/d eta is {side} on the divide, alpha in [{first}, {last}]");
        let words = format!("{words}, {weight} weight");
        d.certain(Support::Balls, words, bounds, |bound| {
            on_sliding((&first, &last), |all| holds(all, bound))
        })?;
    }
    d.conclude(
        "d mu/d eta is -mu' (c - delta_M eta/6)/(a' + c' eta), with the slopes along pure sliding; there W \
         falls, and so a' + c' eta < 0. A purely \
         sliding state of the divide is thicker for Milankovitch's weight; as the lines rise, at the same \
         thickness its friction is smaller, and the difference grows with eta.",
    )
}

fn slope_at_the_border(d: &mut Derivation) -> Checked {
    equation(d)?;
    let (eta, delta) = (Symbol::Thickness.number(), Symbol::Flag.number());
    let factor = Ring::with_flag(&delta, &eta).centroid_factor;
    let slope = factor.partial(Symbol::Thickness);
    d.identity("d fac/d eta", &slope, delta * &eta / eta.int(6))?;
    for weight in [SelfWeight::Milankovitch, SelfWeight::Heyman] {
        let at = landmark(Landmark::Border, weight)?;
        let along = CurveStates::of_landmark(weight, &at);
        let [_, c] = parts(&along.alpha, &along.thrust);
        let SlidingSlopes { a, c: c_slope, friction } = slopes(&along);
        let (eta, delta) = (&at.thickness, at.thickness.int(weight.flag()));
        let by_opening = -(a + c_slope * eta) / (c - delta * eta / eta.int(6));
        let by_friction = by_opening / friction;
        let by_angle = by_friction.clone() * (eta.int(1) + at.friction.square());
        for (name, value) in [("mu", by_friction), ("phi", by_angle)] {
            let words = format!("d eta/d {name} at B, {weight} weight");
            match weight {
                SelfWeight::Heyman => at_most(d, (&words, &value, ""), 3)?,
                SelfWeight::Milankovitch => at_least(d, (&words, &value, ""), 3)?,
            }
        }
    }
    d.conclude("d eta/d mu = -(a' + c' eta)/(c - delta_M eta/6)/mu', finite for both weights.")
}

/// Along pure sliding the friction is that of the half opening, whatever the weight.
fn saturation_along_the_opening(d: &mut Derivation) -> Checked<Finding> {
    lemmas(d, ["sliding-order"])?;
    let weight = SelfWeight::Milankovitch;
    let slope = |point| {
        let at = landmark(point, weight)?;
        Ok::<_, Undecided>(slopes(&CurveStates::of_landmark(weight, &at)).friction)
    };
    let [first, last] = [slope(Landmark::Junction)?, slope(Landmark::Border)?];
    d.less("d mu/d alpha along pure sliding, at J and at B", [&first, &last])?;
    let [first, last] = [shown(&first, 4)?, shown(&last, 4)?];
    d.conclude("The states of the divide from J to B slide purely, so that mu is a function of alpha alone.")?;
    Ok(Finding::Misprint {
        counterexample: format!(
            "d mu/d alpha is {first} at J and {last} at B, milankovitch weight"
        ),
        corrected: "it saturates as the thickness grows (weights-B-slope); with the half opening it grows faster at B \
                    than at J",
    })
}
