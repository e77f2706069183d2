//! The cubics (7) of the purely rotational state, their abbreviations (8) and the radicand (12).

use crate::number::{Angle, Field};

/// The abbreviations of Eq. (8) at one joint.
#[derive(Clone, Debug)]
pub struct Abbreviations<T> {
    /// `S = sin(beta)`.
    pub sin: T,
    /// `f = (beta S)' = S + beta C`.
    pub f: T,
    /// `g = f C + beta S² = beta + S C`.
    pub g: T,
}

/// Eq. (8): `f` and `g` at a joint.
pub fn abbreviations<T: Field>(joint: &Angle<T>) -> Abbreviations<T> {
    Abbreviations {
        sin: joint.sin.clone(),
        f: joint.sin.clone() + joint.rad.clone() * &joint.cos,
        g: joint.rad.clone() + joint.sin.clone() * &joint.cos,
    }
}

/// The link of Eq. (8), `beta S² + C f - g`, which is zero identically.
pub fn link<T: Field>(joint: &Angle<T>) -> T {
    let Abbreviations { sin, f, g } = abbreviations(joint);
    joint.rad.clone() * sin.square() + joint.cos.clone() * f - g
}

/// The first cubic of Eq. (7), in `A`:
///
/// ```text
/// S² (3g - 2S) A³ + 3 g S (g - f) A² - 3 f g² A + 2 g³        for delta_M = 1
/// ```
///
/// The paper prints it for Milankovitch's self-weight. With `delta_M` kept, four coefficients gain a
/// multiple of `(delta_M - 1)/2`; at `delta_M = 0` it has the factor `S A + g` besides Heyman's
/// quadratic.
pub fn in_opening_variable<T: Field>(at: &Abbreviations<T>, delta: &T, a: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let excess = (delta.clone() - sin.int(1)) * sin / sin.int(2);
    let cubic = sin.square() * (g.int(3) * g - g.int(2) * sin - &excess);
    let quadratic = g.int(3) * g * sin * (g.clone() - f + &excess);
    let linear = g.int(3) * g.square() * (f.clone() + &excess);
    // S times the constant term.
    let constant = g.square() * g * (sin.int(2) * sin + &excess);
    ((cubic * a + quadratic) * a - linear) * a + constant / sin
}

/// The second cubic of Eq. (7), whose roots are the thicknesses at which the line of thrust can touch
/// the intrados at this joint:
///
/// ```text
/// delta_M S eta³ + 3 (f + g) eta² - 12 (g - S) eta + 12 (g - f)
/// ```
///
/// The paper prints it for `delta_M = 1`; it is `3 S` times what remains of `(2) = (5)` after
/// clearing denominators, so at `delta_M = 0` it is the Heyman quadratic.
pub fn in_thickness<T: Field>(at: &Abbreviations<T>, delta: &T, eta: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let cubic = delta.clone() * sin * eta;
    let quadratic = (f.clone() + g) * f.int(3);
    let linear = (g.clone() - sin) * f.int(12);
    ((cubic + quadratic) * eta - linear) * eta + (g.clone() - f) * f.int(12)
}

/// The third cubic of Eq. (7), in `h`:
///
/// ```text
/// 6 S² h³ - 3 S (3f - g - 2S) h² - 3 (g - f) (f - 2S) h + 2 (g - f)²        for delta_M = 1
/// ```
///
/// The paper prints it for Milankovitch's self-weight. With `delta_M` kept, only the constant term
/// changes, to `(3 + delta_M)/2 (g - f)²`; at `delta_M = 0` it has the factor `2 S h + g - f` besides
/// Heyman's quadratic.
pub fn in_thrust<T: Field>(at: &Abbreviations<T>, delta: &T, h: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let twice = sin.int(2) * sin;
    let cubic = sin.int(6) * sin.square();
    let quadratic = sin.int(3) * sin * (f.int(3) * f - g - &twice);
    let difference = g.clone() - f;
    let linear = sin.int(3) * &difference * (f.clone() - twice);
    let constant = (delta.int(3) + delta) / delta.int(2) * difference.square();
    ((cubic * h - quadratic) * h - linear) * h + constant
}

/// The radicand of Eq. (12), with `delta_M` kept:
///
/// ```text
/// delta_M² 9 S² (g-f)² - delta_M 2 S (g-S) (9f² - g² - 16gS + 8S²) - 3 (f+g)² (f² - 2gS + S²)
/// ```
///
/// It is the discriminant of [`in_thickness`] divided by -432. The paper prints it for
/// `delta_M = 1`; at `delta_M = 0` it is the discriminant `f² - 2gS + S²` of the Heyman quadratic
/// times `-3 (f+g)²`. It is negative where the rotational state is real and vanishes at the widest
/// joint `sb`; beyond a second zero, at 2.509… (Heyman) or 2.713… (Milankovitch), it is negative again, where
/// no thickness is between 0 and 2.
pub fn radicand<T: Field>(at: &Abbreviations<T>, delta: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let (f2, g2, s2) = (f.square(), g.square(), sin.square());
    let gs = g.clone() * sin;
    let first = f.int(9) * &s2 * (g.clone() - f).square();
    let bracket = f.int(9) * &f2 - g2 - f.int(16) * &gs + f.int(8) * &s2;
    let second = f.int(2) * sin * (g.clone() - sin) * bracket;
    let third = f.int(3) * (f.clone() + g).square() * (f2 - f.int(2) * gs + s2);
    delta.clone() * (delta.clone() * first - second) - third
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Ring, SelfWeight, thrust};
    use rug::{Rational, ops::Pow};

    /// A point of the unit circle with rational coordinates, and an unrelated rational "angle":
    /// the algebra uses nothing but `sin² + cos² = 1`.
    fn joint() -> Angle<Rational> {
        Angle { rad: (7, 5).into(), sin: (20, 29).into(), cos: (21, 29).into() }
    }

    #[test]
    fn the_cubic_in_thickness_is_what_remains_of_2_and_5() {
        for weight in SelfWeight::ALL {
            let (joint, eta) = (joint(), Rational::from((3, 8)));
            let ring = Ring::new(weight, &eta);
            let (lower, tangent) =
                (thrust::lower(&joint, &ring), thrust::tangency(&joint.times_cotangent(), &ring));
            let difference = lower.difference(&tangent) * &joint.sin * 3;
            let delta = Rational::from(weight.flag());
            assert_eq!(in_thickness(&abbreviations(&joint), &delta, &eta), difference);
            assert_ne!(
                in_thickness(&abbreviations(&joint), &(delta + 1), &eta),
                difference,
                "false twin"
            );
        }
    }

    #[test]
    fn the_radicand_is_the_discriminant_over_minus_432() {
        let (joint, delta) = (joint(), Rational::from((5, 3)));
        let Abbreviations { sin, f, g } = abbreviations(&joint);
        let (a, b) = (delta.clone() * &sin, (f.clone() + &g) * Rational::from(3));
        let (c, d) = ((g.clone() - &sin) * Rational::from(-12), (g - f) * Rational::from(12));
        let power = |x: &Rational, n: u32| Rational::from(x.pow(n));
        let discriminant = power(&b, 2) * power(&c, 2)
            - power(&c, 3) * &a * Rational::from(4)
            - power(&b, 3) * &d * Rational::from(4)
            - power(&a, 2) * power(&d, 2) * Rational::from(27)
            + a * b * c * d * Rational::from(18);
        assert_eq!(radicand(&abbreviations(&joint), &delta) * Rational::from(-432), discriminant);
    }
}
