//! The equations for small half openings, in variables of order one: none of them cancels.
//!
//! As `alpha -> 0` the thickness falls like `alpha⁴`, the friction like `alpha³`, and the thrust differs
//! from one by `alpha²`; (2), (4), (5) as printed are then differences of nearly equal numbers. With
//!
//! ```text
//! y = alpha²,  beta_r² = y p,  beta_s² = y z²,  eta = y² q,  h = 1 - y r,  mu = alpha³ m
//! ```
//!
//! and [Stumpff's functions](crate::number::Stumpff) `c_n` for sines and cosines, a power of `y` can be
//! divided out of each equation, and what is left has a root of order one (`p = 1/2`, `q = 1/48`,
//! `r = 1/6` for the rotational states at `alpha = 0`). The tests show, exactly, that each equation here
//! is the printed one.

use super::{Quotient, SelfWeight, Unknown};
use crate::number::{Field, Stumpff};

/// An arch of a small half opening in variables of order one.
#[derive(Clone, Debug)]
pub struct Scaled<T> {
    /// `y = alpha²`.
    pub opening: SquaredAngle<T>,
    /// `c_n(y/4)`, for half the half opening.
    pub half: Vec<T>,
    /// `p`, with the functions at `beta_r² = y p`.
    pub rotation: SquaredAngle<T>,
    /// `z = beta_s/alpha`.
    pub sliding_joint: T,
    /// `z²`, with the functions at `beta_s² = y z²`.
    pub sliding: SquaredAngle<T>,
    /// `q = eta/alpha⁴`.
    pub thickness: T,
    /// `r = (1 - h)/alpha²`.
    pub deficit: T,
    /// `m = mu/alpha³`.
    pub friction: T,
}

/// An angle by its square.
#[derive(Clone, Debug)]
pub struct SquaredAngle<T> {
    /// The square of the angle; for a joint over that of the half opening.
    pub square: T,
    /// `c_0, ..., c_4` at the square of the angle.
    pub functions: Vec<T>,
}

/// Functions that the equations need.
const FUNCTIONS: usize = 5;

impl<T: Stumpff> Scaled<T> {
    /// The half opening `sqrt(y)`, all else zero.
    pub fn new(y: &T) -> Self {
        let zero = y.int(0);
        let opening = SquaredAngle { square: y.clone(), functions: y.stumpff(FUNCTIONS) };
        let at_crown = SquaredAngle { square: zero.clone(), functions: zero.stumpff(FUNCTIONS) };
        Self {
            opening,
            half: (y.clone() / y.int(4)).stumpff(FUNCTIONS),
            rotation: at_crown.clone(),
            sliding_joint: zero.clone(),
            sliding: at_crown,
            thickness: zero.clone(),
            deficit: zero.clone(),
            friction: zero,
        }
    }

    /// Scaled variables with one of them given another value, in its scaled form: `p`, `z`, `q`, `r`, `m`.
    pub fn with(mut self, unknown: Unknown, value: T) -> Self {
        let joint = |square: T| {
            let functions = (self.opening.square.clone() * &square).stumpff(FUNCTIONS);
            SquaredAngle { square, functions }
        };
        match unknown {
            Unknown::HalfOpening => return Self::new(&value),
            Unknown::RotationJoint => self.rotation = joint(value),
            Unknown::SlidingJoint => {
                self.sliding = joint(value.square());
                self.sliding_joint = value;
            }
            Unknown::Thickness => self.thickness = value,
            Unknown::Thrust => self.deficit = value,
            Unknown::Friction => self.friction = value,
            // No symmetric state has them.
            Unknown::CrownHinge | Unknown::CrownMoment | Unknown::VerticalForce => {}
        }
        self
    }
}

impl<T> Scaled<T> {
    /// Maps the variables to another number.
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Scaled<U> {
        self.mapped(&f)
    }

    /// Maps by any function, as a copy for each would be as long as this.
    fn mapped<U>(self, f: &dyn Fn(T) -> U) -> Scaled<U> {
        let all = |functions: Vec<T>| functions.into_iter().map(f).collect();
        let joint =
            |j: SquaredAngle<T>| SquaredAngle { square: f(j.square), functions: all(j.functions) };
        Scaled {
            opening: joint(self.opening),
            half: all(self.half),
            rotation: joint(self.rotation),
            sliding_joint: f(self.sliding_joint),
            sliding: joint(self.sliding),
            thickness: f(self.thickness),
            deficit: f(self.deficit),
            friction: f(self.friction),
        }
    }
}

/// `eta = y² q`.
pub fn thickness<T: Field>(at: &Scaled<T>) -> T {
    at.opening.square.square() * &at.thickness
}

/// `1 - h = y r`.
pub fn rest<T: Field>(at: &Scaled<T>) -> T {
    at.opening.square.clone() * &at.deficit
}

/// `delta_M eta²/6` over `y`: what the centroids add to (2), (4) and (5).
fn centroid_term<T: Field>(weight: SelfWeight, at: &Scaled<T>) -> T {
    let flag = at.thickness.int(weight.flag());
    flag * thickness(at) * &at.opening.square * &at.thickness / at.thickness.int(6)
}

/// (2) over `y²`: `(2 + eta - (2 - eta) cos) h - (2 - eta) beta sin + 2 fac (1 - cos)`.
///
/// ```text
/// 2 p² (c_3 - 2 c_4) - 2 p r c_2 + q [2 (1 - y r) + y p (c_1 - c_2 (1 - y r))] + delta_M eta²/6 p c_2 / y
/// ```
pub fn lower<T: Field>(weight: SelfWeight, at: &Scaled<T>) -> T {
    let SquaredAngle { square: p, functions: c } = &at.rotation;
    let two = p.int(2);
    let (h, u) = (two.int(1) - rest(at), at.opening.square.clone() * p);
    let bending = p.square() * (c[3].clone() - two.clone() * &c[4]);
    let crown = at.deficit.clone() * p * &c[2];
    let depth = two.clone() * &h + u * (c[1].clone() - h * &c[2]);
    two * (bending - crown) + depth * &at.thickness + centroid_term(weight, at) * p * &c[2]
}

/// (5) over `y`, times `c_1`: `(2 - eta) (h - beta cot beta - 1) + 2 fac`.
///
/// ```text
/// (2 - eta) (p (c_2 - c_3) - r c_1) + c_1 (y q + delta_M eta²/6 / y)
/// ```
pub fn tangency<T: Field>(weight: SelfWeight, at: &Scaled<T>) -> T {
    let SquaredAngle { square: p, functions: c } = &at.rotation;
    let intrados = p.int(2) - thickness(at);
    let gap = (c[2].clone() - &c[3]) * p - at.deficit.clone() * &c[1];
    let added = at.opening.square.clone() * &at.thickness + centroid_term(weight, at);
    intrados * gap + added * &c[1]
}

/// (4) over `y`, times `2 c_1(y/4)`: `(2 + eta) (h - A(alpha)) + 2 fac`, with the sign changed.
///
/// ```text
/// (2 + eta) (2 r c_1 - c_2 + c_3) + 2 c_1 (y q - delta_M eta²/6 / y),   c_n at y/4
/// ```
pub fn whole<T: Field>(weight: SelfWeight, at: &Scaled<T>) -> T {
    let c = &at.half;
    let two = c[1].int(2);
    let extrados = two.clone() + thickness(at);
    let gap = two.clone() * &at.deficit * &c[1] - &c[2] + &c[3];
    let added = at.opening.square.clone() * &at.thickness - centroid_term(weight, at);
    extrados * gap + two * added * &c[1]
}

/// (17) over `alpha³`: `m = (c_2 - c_3 - r c_1) / N(alpha)`.
pub fn shoulder<T: Field>(at: &Scaled<T>) -> Quotient<T> {
    let c = &at.opening.functions;
    Quotient {
        numerator: c[2].clone() - &c[3] - at.deficit.clone() * &c[1],
        denominator: normal_force(at),
    }
}

/// `N(alpha) = h cos(alpha) + alpha sin(alpha)`.
pub fn normal_force<T: Field>(at: &Scaled<T>) -> T {
    let SquaredAngle { square: y, functions: c } = &at.opening;
    (y.int(1) - rest(at)) * &c[0] + y.clone() * &c[1]
}

/// (18) over `alpha³` at the joint of [`steepest`]:
///
/// ```text
/// m = (r² - r z² c_2 + z⁴ c_3) / (z (y r c_1 + c_0))
/// ```
pub fn inner<T: Field>(at: &Scaled<T>) -> Quotient<T> {
    let SquaredAngle { square, functions: c } = &at.sliding;
    let r = &at.deficit;
    Quotient {
        numerator: r.square() - square.clone() * r * &c[2] + square.square() * &c[3],
        denominator: (rest(at) * &c[1] + &c[0]) * &at.sliding_joint,
    }
}

/// `beta_s² = h (1 - h)` over `y`: `z² - r (1 - y r)`.
pub fn steepest<T: Field>(at: &Scaled<T>) -> T {
    at.sliding.square.clone() - (at.deficit.int(1) - rest(at)) * &at.deficit
}

/// The moment that is left for the crown's pressure point inside the extrados of the shoulder when it is
/// on the extrados of the crown, over `y²`; see [`contact`](super::contact).
///
/// ```text
/// (1 + eta/2) (r c_2 - c_3 + 2 c_4) + c_2 (y q/2 - delta_M eta²/12 / y)
/// ```
pub fn extrados_margin_at_shoulder<T: Field>(weight: SelfWeight, at: &Scaled<T>) -> T {
    let SquaredAngle { square: y, functions: c } = &at.opening;
    let two = y.int(2);
    let extrados = two.clone() + thickness(at);
    let gap = at.deficit.clone() * &c[2] - &c[3] + two.clone() * &c[4];
    let added = y.clone() * &at.thickness - centroid_term(weight, at);
    (extrados * gap + added * &c[2]) / two
}

/// The lever arms of the thrust about the haunch's intrados, from the crown's extrados and from the
/// shoulder's, over `y`; see [`contact`](super::contact).
pub fn arms<T: Field>(at: &Scaled<T>) -> (T, T) {
    let (y, two) = (&at.opening.square, at.thickness.int(2));
    let (eta, depth) = (thickness(at), y.clone() * &at.thickness);
    let haunch = (two.clone() - &eta) * &at.rotation.square * &at.rotation.functions[2] / &two;
    let shoulder = (eta + &two) * &at.opening.functions[2] / two;
    (haunch.clone() + &depth, shoulder - haunch - depth)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Configuration, contact, statics};
    use crate::number::Angle;
    use crate::problem::Equation;
    use crate::symbolic::{Fraction, Letters, Relations, Symbol};

    /// The letters: `x = alpha`, the ratios `b = beta_r/alpha` and `z = beta_s/alpha`, and for each angle
    /// `c_3` and `c_4`, of which everything else follows by the recurrence.
    fn functions(u: &Fraction, c3: Symbol, c4: Symbol) -> Vec<Fraction> {
        let (c3, c4) = (c3.number(), c4.number());
        let c2 = u.ratio(1, 2) - u.clone() * &c4;
        let c1 = u.int(1) - u.clone() * &c3;
        vec![u.int(1) - u.clone() * &c2, c1, c2, c3, c4]
    }

    fn scaled() -> Scaled<Fraction> {
        let (x, b, z) =
            (Symbol::HalfOpening.number(), Symbol::Joint.number(), Symbol::SquareRoot.number());
        let y = x.square();
        let joint = |part: &Fraction, c3, c4| SquaredAngle {
            square: part.square(),
            functions: functions(&(y.clone() * part.square()), c3, c4),
        };
        Scaled {
            opening: SquaredAngle {
                square: y.clone(),
                functions: functions(&y, Symbol::SineOfOpening, Symbol::CosineOfOpening),
            },
            half: functions(&(y.clone() / y.int(4)), Symbol::F, Symbol::G),
            rotation: joint(&b, Symbol::Sine, Symbol::Cosine),
            sliding: joint(&z, Symbol::CrownMoment, Symbol::CrownEccentricity),
            sliding_joint: z,
            thickness: Symbol::Thickness.number(),
            deficit: Symbol::Thrust.number(),
            friction: Symbol::Friction.number(),
        }
    }

    /// The printed variables that the scaled ones stand for.
    fn printed(at: &Scaled<Fraction>) -> Configuration<Fraction> {
        let x = Symbol::HalfOpening.number();
        let angle = |rad: Fraction, c: &[Fraction]| Angle {
            sin: rad.clone() * &c[1],
            cos: c[0].clone(),
            rad,
        };
        Configuration {
            half_opening: angle(x.clone(), &at.opening.functions),
            rotation_joint: angle(x.clone() * Symbol::Joint.number(), &at.rotation.functions),
            sliding_joint: angle(x.clone() * &at.sliding_joint, &at.sliding.functions),
            thickness: thickness(at),
            thrust: x.int(1) - rest(at),
            friction: x.square() * &x * &at.friction,
            ..Configuration::zero(&x)
        }
    }

    fn power(n: i32) -> Fraction {
        (0..n).fold(Fraction::from(crate::symbolic::Polynomial::from(1)), |product, _| {
            product * Symbol::HalfOpening.number()
        })
    }

    #[test]
    fn each_equation_is_the_printed_one() {
        let at = scaled();
        let mut whole = printed(&at);
        // (4) sees the half opening through its half.
        let half = Symbol::HalfOpening.number() / power(0).int(2);
        let (sin, cos) = (half * &at.half[1], at.half[0].clone());
        whole.half_opening.sin = sin.int(2) * &sin * &cos;
        whole.half_opening.cos = sin.int(1) - sin.int(2) * sin.square();
        let printed = printed(&at);
        for weight in SelfWeight::ALL {
            let cases = [
                (Equation::LowerThrust, &printed, power(4)),
                (Equation::Tangency, &printed, power(2) / &at.rotation.functions[1] * power(0)),
                (Equation::WholeThrust, &whole, -(sin.square() * power(2) / &at.half[1])),
                (Equation::ShoulderSliding, &printed, power(3)),
                (Equation::Steepest, &printed, power(2)),
            ];
            for (equation, at_printed, factor) in cases {
                let scaled = equation.scaled_residual(weight, &at).unwrap();
                let twin = scaled.clone() + scaled.int(1);
                let original = equation.residual(weight, at_printed);
                let difference = |scaled: Fraction| original.clone() - scaled * &factor;
                assert!(difference(scaled).vanishes(&Relations::none()), "{equation:?} {weight:?}");
                assert!(!difference(twin).vanishes(&Relations::none()), "{equation:?}: false twin");
            }
        }
    }

    /// (18) is used where `beta_s² = h (1 - h)`: with `r - z² = y r²`.
    #[test]
    fn inner_sliding_is_the_printed_one_at_the_steepest_joint() {
        let at = scaled();
        let printed = Equation::InnerSliding.residual(SelfWeight::Heyman, &printed(&at));
        let x = Symbol::HalfOpening.number();
        let difference = printed - inner(&at).residual(&at.friction) * power(4);
        // What is left is a multiple of the equation of the steepest joint.
        assert!((difference.clone() - steepest(&at) * x.square()).vanishes(&Relations::none()));
        assert!(!difference.vanishes(&Relations::none()));
    }

    #[test]
    fn the_margins_are_those_of_the_lemma() {
        let at = scaled();
        let printed = printed(&at);
        for weight in SelfWeight::ALL {
            let moment = contact::crown_moment(&printed);
            let margin = contact::extrados_margin_at_shoulder(weight, &printed, &moment);
            let scaled = extrados_margin_at_shoulder(weight, &at) * power(4);
            assert!((margin - scaled).vanishes(&Relations::none()), "{weight:?}");
        }
        let normal = statics::normal_force(&printed.half_opening, &printed.thrust);
        assert!((normal - normal_force(&at)).vanishes(&Relations::none()));
        let (upper, lower) = arms(&at);
        let rates = contact::rates_of_shoulder_sliding(&printed);
        assert!((rates.sliding - upper.clone() * power(2)).vanishes(&Relations::none()));
        let rotation = contact::rates_of_rotation(&printed);
        assert!((rotation.shoulder - upper / lower).vanishes(&Relations::none()));
    }
}
