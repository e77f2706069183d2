//! Proof of a state that turns about the crown, `[r,s]` from the thrust and the joint of (18), or `[r]` without thrust.
//!
//! (3) at `beta = 0` is `delta_M eta²/6 - B eta + 2 C = 0`, with the thickness as its smaller root:
//!
//! ```text
//! B = A + h (1 + cos(alpha))/(1 - cos(alpha)),   C = 1 + h - A,   eta = 4 C/(B + √(B² - delta_M 4 C/3))
//! ```

use super::margins::{Thinnest, are_positive, in_doubles, of_state};
use super::piece::Proof;
use super::root::known_if;
use super::sine::{Long, Short, Sine, around};
use crate::arch::contact::{self, Rates};
use crate::arch::{Configuration, SelfWeight, sliding, thrust};
use crate::number::{Angle, Field, Product, SinePoint};

/// Proof of states that turn about the crown.
pub(super) struct Crown {
    pub(super) weight: SelfWeight,
    /// False for `[r]`: without a limit of friction there is no thrust.
    pub(super) is_limited: bool,
}

/// `B` and `C`.
#[inline(always)]
fn coefficients<T: Field>(half_opening: &Angle<T>, h: &T) -> [T; 2] {
    let a = thrust::opening_variable(half_opening).value();
    let one = h.int(1);
    let ratio = (one.clone() + &half_opening.cos) / half_opening.versine();
    [a.clone() + ratio * h, one + h - a]
}

/// Margins of its own.
#[inline(always)]
fn margins<T: Field>(weight: SelfWeight, at: &Configuration<T>, rates: &Rates<T>) -> [T; 2] {
    [contact::crown_slope(weight, at), rates.sliding.clone()]
}

/// Margins where friction has a limit.
#[inline(always)]
fn limited<T: Field>(at: &Configuration<T>) -> [T; 2] {
    [
        at.half_opening.rad.clone() - &at.sliding_joint.rad,
        at.friction.clone() - sliding::shoulder(&at.half_opening, &at.thrust).value(),
    ]
}

/// Values: thickness and intrinsic thrust.
impl Proof<4, 1, 2> for Crown {
    #[inline(always)]
    fn candidates(&self, [alpha, ..]: [f64; 4]) -> [f64; 1] {
        [alpha]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha, friction, thrust, slides]: [Long<P>; 4],
        [(_, at_alpha)]: [(f64, SinePoint); 1],
    ) -> [Long<P>; 2] {
        let Self { weight, is_limited } = *self;
        let half_opening = alpha.angle(&at_alpha);
        let [b, c] = coefficients(&half_opening, &thrust);
        let four_c = c.int(4) * c;
        let root = match weight {
            SelfWeight::Heyman => b,
            SelfWeight::Milankovitch => (b.square() - four_c / c.int(3)).root(),
        };
        let thickness = four_c / (b + root);
        let crown = Angle::zero(&Short::exact(0.0));
        let mut at = in_doubles(&half_opening, [&thickness, &thrust, &friction], crown);
        at.sliding_joint.rad = slides.in_doubles();
        let rates = contact::rates_of_inner_sliding(&at);
        let [normal, thin, thick, h, rest]: [Short; 5] = of_state(&at);
        let thinnest = Thinnest::new(weight, &at, &rates);
        let is_proved = are_positive(&[normal, thin, thick])
            & are_positive(&margins(weight, &at, &rates))
            & match is_limited {
                true => are_positive(&[h, rest]) & are_positive(&limited(&at)) & thinnest.holds(),
                false => thinnest.holds_unlimited(),
            };
        [thickness, thickness * thrust].map(|x| known_if(is_proved, x))
    }
}

/// Proof that an arch falls whatever its thickness, from the least thrust that friction allows.
pub(super) struct TooWide {
    pub(super) weight: SelfWeight,
}

/// Values: the half opening, where the arch falls.
impl Proof<2, 1, 1> for TooWide {
    #[inline(always)]
    fn candidates(&self, [alpha, _]: [f64; 2]) -> [f64; 1] {
        [alpha]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha, thrust]: [Long<P>; 2],
        [(_, at_alpha)]: [(f64, SinePoint); 1],
    ) -> [Long<P>; 1] {
        let at = Configuration {
            half_opening: around(&alpha.angle(&at_alpha), 0.0),
            thrust: thrust.in_doubles(),
            ..Configuration::zero(&Short::exact(0.0))
        };
        let margin = contact::margin_at_physical_limit(self.weight, &at);
        [known_if(are_positive(&[-margin]), alpha)]
    }
}

#[cfg(test)]
mod tests {
    use super::super::margins::tests::{assert_are_all, configuration};
    use super::*;
    use crate::arch::Ring;
    use couplet_check::problem::Mode;
    use rug::Rational;

    #[test]
    fn the_quadratic_is_equation_3_at_the_crown() {
        let alpha = Angle {
            rad: Rational::from((12, 5)),
            sin: Rational::from((4, 5)),
            cos: Rational::from((-3, 5)),
        };
        let crown = Angle::zero(&alpha.rad);
        for weight in SelfWeight::ALL {
            for eta in [(1, 3), (7, 4)].map(Rational::from) {
                let h = thrust::upper(&alpha, &crown, &Ring::new(weight, &eta)).value();
                let [b, c] = coefficients(&alpha, &h);
                let square = Rational::from(weight.flag()) * &eta * &eta / Rational::from(6);
                let left = |b: &Rational| {
                    square.clone() - b.clone() * &eta + c.clone() * Rational::from(2)
                };
                assert_eq!(left(&b), 0);
                assert_ne!(left(&(b + Rational::from(1))), 0, "false twin");
            }
        }
    }

    #[test]
    fn the_margins_are_those_of_all_conditions() {
        let limited_and_not = [(Mode::OverturningSliding, true), (Mode::Overturning, false)];
        for (mode, is_limited) in limited_and_not {
            let (weight, at) = (SelfWeight::Milankovitch, configuration([262, 0, 24, 170, 6, 180]));
            let at = match is_limited {
                true => at,
                false => Configuration { thrust: at.thrust.int(0), ..at },
            };
            let rates = contact::rates_of_inner_sliding(&at);
            let [normal, thin, thick, h, rest] = of_state(&at);
            let mut found = vec![normal, thin, thick];
            found.extend(margins(weight, &at, &rates));
            if is_limited {
                found.extend([h, rest]);
                found.extend(limited(&at));
            }
            let thinnest = Thinnest::new(weight, &at, &rates);
            assert_are_all((weight, mode, is_limited), &at, &found, &thinnest);
        }
    }
}
