//! Numbers that are exact as long as they are fractions in pi, √2 and √3, and enclosed from there on.

use super::{Fraction, Letters, Polynomial, Relations, Symbol};
use crate::number::{
    Angle, Ball, Enclosure, ExactField, ExactNumber, Field, Form, Real, sine_and_cosine,
};
use num_rational::BigRational;
use rug::Rational;

/// A number of some bits: an equation over it gives the exact value where there is one, and a ball elsewhere.
///
/// ```
/// use couplet_number::number::Field;
/// use couplet_number::symbolic::Known;
/// let angle = Known::angle(&"60deg".parse().unwrap(), 64);
/// assert_eq!(angle.sin.square().rational().unwrap().to_string(), "3/4");
/// assert!((angle.rad / &angle.sin).rational().is_none());
/// let angle = Known::angle(&"1.5".parse().unwrap(), 64);
/// assert!(angle.sin.square().rational().is_none());
/// ```
#[derive(Clone, Debug)]
pub enum Known {
    /// A fraction in normal form. As pi is transcendental, it is zero, or rational, only where it looks so.
    Exact(Fraction, u32),
    /// An enclosed number.
    Enclosed(Ball),
    /// A quotient by zero, exactly.
    Undefined(u32),
}

/// `√2² = 2` and `√3² = 3`.
fn roots() -> Relations {
    let [two, three] = [2, 3].map(Polynomial::from);
    Relations::none().with(Symbol::RootOfTwo, 2, two).with(Symbol::RootOfThree, 2, three)
}

impl Known {
    /// A rational number, of as many bits as this one.
    pub fn like(&self, value: &Rational) -> Self {
        Self::Exact(value.clone().into(), self.bits())
    }

    /// A number that is given.
    pub fn new(value: &ExactNumber, bits: u32) -> Self {
        let factor = || Fraction::from(value.to_rational());
        match value.form() {
            Form::Rational => Self::Exact(factor(), bits),
            Form::TimesPi => Self::Exact(factor() * &Symbol::Pi.number(), bits),
            Form::TwiceArctangent | Form::ArctangentOfRoot => Self::Enclosed(value.enclosure(bits)),
        }
    }

    /// An angle that is given, between 0 and pi.
    pub fn angle(angle: &ExactNumber, bits: u32) -> Angle<Self> {
        let exact = |(factor, root): (BigRational, u32)| {
            let factor = Fraction::from(ExactNumber::rational(factor).to_rational());
            let value = match root {
                2 => factor * &Symbol::RootOfTwo.number(),
                3 => factor * &Symbol::RootOfThree.number(),
                _ => factor,
            };
            Self::Exact(value, bits)
        };
        let (sin, cos) = match sine_and_cosine(angle) {
            Some([sin, cos]) => (exact(sin), exact(cos)),
            None => {
                let (sin, cos) = angle.enclosure::<Ball>(bits).sin_cos();
                (Self::Enclosed(sin), Self::Enclosed(cos))
            }
        };
        Angle { rad: Self::new(angle, bits), sin, cos }
    }

    fn bits(&self) -> u32 {
        match self {
            Self::Exact(_, bits) | Self::Undefined(bits) => *bits,
            Self::Enclosed(ball) => ball.prec(),
        }
    }

    /// The number if it is rational, and that is known.
    pub fn rational(&self) -> Option<Rational> {
        let Self::Exact(fraction, _) = self else { return None };
        let Some((_, factor)) = fraction.numerator().leading() else {
            return Some(Rational::new());
        };
        let is_multiple = *fraction.numerator() == fraction.denominator().scaled(factor);
        is_multiple.then(|| factor.clone())
    }

    /// Tells whether the number is known to be zero, exactly.
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Exact(fraction, _) if fraction.is_zero())
    }

    /// An enclosure.
    pub fn ball(&self) -> Ball {
        let like = Ball::integer(1, self.bits());
        match (self, self.rational()) {
            (_, Some(rational)) => Ball::enclosing(&rational, self.bits()),
            (Self::Exact(fraction, _), None) => fraction.evaluate(&like, |symbol| match symbol {
                Symbol::Pi => like.pi(),
                Symbol::RootOfTwo => like.int(2).sqrt(),
                Symbol::RootOfThree => like.int(3).sqrt(),
                _ => Ball::whole(self.bits()),
            }),
            (Self::Enclosed(ball), None) => ball.clone(),
            (Self::Undefined(bits), None) => Ball::whole(*bits),
        }
    }

    fn combine(
        self,
        other: &Self,
        exact: impl Fn(Fraction, &Fraction) -> Fraction,
        enclosed: impl Fn(Ball, &Ball) -> Ball,
    ) -> Self {
        match (self, other) {
            (Self::Undefined(bits), _) | (Self::Exact(_, bits), Self::Undefined(_)) => {
                Self::Undefined(bits)
            }
            (Self::Exact(a, bits), Self::Exact(b, _)) => {
                Self::Exact(exact(a, b).reduced(&roots()), bits)
            }
            (a, Self::Undefined(_)) => Self::Undefined(a.bits()),
            (a, b) => Self::Enclosed(enclosed(a.ball(), &b.ball())),
        }
    }

    fn negated(self) -> Self {
        match self {
            Self::Exact(fraction, bits) => Self::Exact(-fraction, bits),
            Self::Enclosed(ball) => Self::Enclosed(-ball),
            Self::Undefined(bits) => Self::Undefined(bits),
        }
    }

    fn plus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a + b, |a, b| a + b)
    }

    fn minus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a - b, |a, b| a - b)
    }

    /// Zero times what is bounded is zero.
    fn times(self, other: &Self) -> Self {
        let is_bounded = |x: &Self| matches!(x, Self::Enclosed(ball) if ball.is_bounded());
        match (self.is_zero() && is_bounded(other)) || (other.is_zero() && is_bounded(&self)) {
            true => self.int(0),
            false => self.combine(other, |a, b| a * b, |a, b| a * b),
        }
    }

    /// Zero over what is not zero is zero.
    fn over(self, other: &Self) -> Self {
        match (self.is_zero(), other) {
            (_, zero) if zero.is_zero() => Self::Undefined(self.bits()),
            (true, Self::Enclosed(ball)) if ball.excludes_zero() => self,
            _ => self.combine(other, |a, b| a / b, |a, b| a / b),
        }
    }
}

operators!(Known);

impl Field for Known {
    fn int(&self, n: i32) -> Self {
        Self::Exact(Fraction::from(Polynomial::from(n)), self.bits())
    }
}

impl Real for Known {
    fn pi(&self) -> Self {
        Self::Exact(Symbol::Pi.number(), self.bits())
    }

    /// Exact of the square of a rational number.
    fn sqrt(&self) -> Self {
        let is_square = |x: &Rational| {
            *x >= 0 && x.numer().is_perfect_square() && x.denom().is_perfect_square()
        };
        match (self, self.rational().filter(is_square)) {
            (Self::Undefined(bits), _) => Self::Undefined(*bits),
            (_, Some(square)) => {
                let (above, below) = square.into_numer_denom();
                self.like(&(above.sqrt(), below.sqrt()).into())
            }
            _ => Self::Enclosed(self.ball().sqrt()),
        }
    }

    fn sin_cos(&self) -> (Self, Self) {
        match self.is_zero() {
            true => (self.int(0), self.int(1)),
            false => {
                let (sin, cos) = self.ball().sin_cos();
                (Self::Enclosed(sin), Self::Enclosed(cos))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn angle(text: &str) -> Angle<Known> {
        Known::angle(&text.parse().unwrap(), 128)
    }

    /// Sines and cosines that are exact are those of the ball, and those of no other angle.
    #[test]
    fn exact_sines_and_cosines_are_those_of_their_angle() {
        let exact = |x: &Known| matches!(x, Known::Exact(..));
        for text in [
            "pi/6",
            "45deg",
            "60deg",
            "90deg",
            "2pi/3",
            "3pi/4",
            "150deg",
            "2atan(3)",
            "2atan(1/2)",
        ] {
            let Angle { rad, sin, cos } = angle(text);
            assert!(exact(&sin) && exact(&cos), "{text}");
            let (ball_sin, ball_cos) = rad.ball().sin_cos();
            for (x, ball) in [(&sin, &ball_sin), (&cos, &ball_cos)] {
                assert!((x.ball() - ball).mid().to_f64().abs() < 1e-30, "{text}");
                assert!(x.ball().overlaps(ball) && x.ball().rad().to_float() < 1e-30, "{text}");
            }
            let circle = sin.square() + cos.square() - sin.int(1);
            assert!(circle.is_zero() && !(circle + sin.ratio(1, 1000)).is_zero(), "{text}");
        }
        for text in ["1", "pi/5", "pi/12", "0.5"] {
            let Angle { sin, cos, .. } = angle(text);
            assert!(!exact(&sin) && !exact(&cos), "{text}");
        }
    }

    #[test]
    fn what_is_rational_is_known_to_be_and_nothing_else() {
        let Angle { rad, sin, cos } = angle("pi/6");
        let mixed = (rad.clone() + &cos) / (rad.int(2) * &rad + rad.int(2) * &cos);
        assert_eq!(mixed.rational(), Some((1, 2).into()), "pi and √3 cancel");
        assert_eq!((cos.clone() / &angle("pi/3").sin).rational(), Some(1.into()));
        let mixed = (rad.clone() + &sin) / (rad.int(2) * &rad + rad.int(2) * &cos);
        assert_eq!(mixed.rational(), None, "false twin");
        assert_eq!((angle("pi/4").sin * &sin).rational(), None);
        assert_eq!(rad.ratio(4, 9).sqrt().rational(), Some((2, 3).into()));
        assert_eq!(rad.ratio(4, 8).sqrt().rational(), None);
        assert_eq!((angle("pi/4").sin * &rad.int(2).sqrt()).rational(), None, "√2 as a ball");
    }

    #[test]
    fn zero_is_told_from_what_is_only_near() {
        let (right, other) = (angle("pi/2"), angle("1"));
        assert!((right.cos.clone() * &other.sin).is_zero());
        assert!(matches!(other.sin.clone() / &right.cos, Known::Undefined(_)));
        assert!(matches!(right.cos.clone() / &right.cos, Known::Undefined(_)));
        let near = Known::Enclosed(right.rad.ball().sin_cos().1);
        assert!(!near.is_zero() && !(near.clone() * &other.sin).is_zero());
        let quotient = other.sin.clone() / &near;
        assert!(matches!(&quotient, Known::Enclosed(ball) if !ball.is_bounded()));
        let sum = other.sin.clone() / &right.cos + &other.cos;
        assert!(matches!(sum.clone(), Known::Undefined(_)) && !sum.ball().is_bounded());
        assert!(matches!(other.cos - &sum, Known::Undefined(_)));
        assert!((right.cos.clone() / &other.sin).is_zero());
        assert!(!(right.cos / &near).is_zero());
    }
}
