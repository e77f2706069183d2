//! Complex numbers over a field: pairs, for the closed forms that take complex roots.

use super::{Ball, Enclosure, ExactField, Field, Magnitude, Real};
use rug::Float;

/// Complex number whose parts are in a field of real numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Complex<T> {
    /// The real part.
    pub re: T,
    /// The imaginary part.
    pub im: T,
}

/// All complex numbers with the real part in one ball and the imaginary part in another.
pub type ComplexBall = Complex<Ball>;

impl<T: Field> From<T> for Complex<T> {
    fn from(re: T) -> Self {
        let im = re.int(0);
        Self { re, im }
    }
}

impl<T: Field> Complex<T> {
    fn negated(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }

    fn plus(self, other: &Self) -> Self {
        Self { re: self.re + &other.re, im: self.im + &other.im }
    }

    fn minus(self, other: &Self) -> Self {
        Self { re: self.re - &other.re, im: self.im - &other.im }
    }

    fn times(self, other: &Self) -> Self {
        let re = self.re.clone() * &other.re - self.im.clone() * &other.im;
        Self { re, im: self.re * &other.im + self.im * &other.re }
    }

    fn over(self, other: &Self) -> Self {
        let norm = other.re.square() + other.im.square();
        let conjugate = Self { re: other.re.clone(), im: -other.im.clone() };
        let Self { re, im } = self.times(&conjugate);
        Self { re: re / &norm, im: im / &norm }
    }
}

impl ComplexBall {
    /// The principal square root of a real number, by its sign; `None` if that is not known.
    pub fn root_of_real(x: &Ball) -> Option<Self> {
        if x.is_positive().is_proved() {
            return Some(x.sqrt().into());
        }
        let size = -x.clone();
        size.is_positive().is_proved().then(|| Self { re: x.int(0), im: size.sqrt() })
    }

    /// The principal cube root; `None` if the ball meets the cut, the real numbers up to zero, or is too wide.
    ///
    /// Let `w` be a number near it, and `e = z/w³ - 1`. Then `w (1 + e)^(1/3)` is a cube root of `z`, and for
    /// `|e| <= 1/2` the power is within `|e|` of one: its slope is below `(1/3) 2^(2/3) < 1`. It is the principal
    /// root where its angle is less than `pi/3`: `Re > 0` and `3 Re² > Im²`.
    ///
    /// ```
    /// use couplet_number::number::{Ball, ComplexBall};
    /// let real = |n| ComplexBall::from(Ball::integer(n, 64));
    /// assert!(real(8).cube_root().unwrap().re.contains(&2.into()));
    /// assert!(real(-8).cube_root().is_none(), "on the cut");
    /// ```
    pub fn cube_root(&self) -> Option<Self> {
        let off_cut = self.re.is_positive().is_proved() || self.im.excludes_zero();
        if !off_cut || !self.re.is_bounded() || !self.im.is_bounded() {
            return None;
        }
        let prec = self.re.prec();
        let [x, y] = [&self.re, &self.im].map(|part| Float::with_val(prec, part.mid()));
        let size = Float::with_val(prec, x.hypot_ref(&y)).cbrt();
        let (sin, cos) = (y.atan2(&x) / 3u32).sin_cos(Float::new(prec));
        let exact = |part: Float| Ball::exact(part, prec);
        let near = Self { re: exact(cos * &size), im: exact(sin * &size) };
        let cube = near.clone() * &near * &near;
        let rest = self.clone() / &cube - Self::from(near.re.int(1));
        let error = rest.re.size().plus(rest.im.size());
        if error > Magnitude::power_of_two(-1) {
            return None;
        }
        let spread = near.re.size().plus(near.im.size()).times(error);
        let root = Self { re: near.re.widened(spread), im: near.im.widened(spread) };
        let inside = root.re.int(3) * root.re.square() - root.im.square();
        let is_principal = root.re.is_positive().is_proved() && inside.is_positive().is_proved();
        is_principal.then_some(root)
    }
}

operators!([T: Field] Complex<T>);

impl<T: Field> Field for Complex<T> {
    fn int(&self, n: i32) -> Self {
        self.re.int(n).into()
    }
}

impl<T: ExactField> ExactField for Complex<T> {
    fn is_zero(&self) -> bool {
        self.re.is_zero() && self.im.is_zero()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    fn complex(re: i32, im: i32) -> ComplexBall {
        ComplexBall { re: Ball::integer(re, 128), im: Ball::integer(im, 128) }
    }

    fn holds(z: &ComplexBall, re: i32, im: i32) -> bool {
        z.re.contains(&re.into()) && z.im.contains(&im.into())
    }

    #[test]
    fn the_operations_are_those_of_complex_numbers() {
        let (z, w) = (complex(3, 4), complex(1, -2));
        assert!(holds(&(z.clone() * &w), 11, -2) && holds(&(z.clone() + &w), 4, 2));
        assert!(holds(&(z.clone() - &w), 2, 6) && holds(&-z.clone(), -3, -4));
        assert!(holds(&(z.clone() * &w / &w), 3, 4));
        assert!(!holds(&(z * &w), 11, 2), "false twin");
    }

    #[test]
    fn the_cube_root_is_the_principal_one() {
        // (2 + i)³ = 2 + 11 i; (1 + 2 i)³ = -11 - 2 i, whose principal root is another one.
        assert!(holds(&complex(2, 11).cube_root().unwrap(), 2, 1));
        let turned = complex(-11, -2).cube_root().unwrap();
        assert!(!holds(&turned, 1, 2), "not in the sector of the principal root");
        assert!(holds(&(turned.clone() * &turned * &turned), -11, -2));
        let inside = turned.re.square() * turned.re.int(3) - turned.im.square();
        assert!(inside.is_positive().is_proved());
    }

    #[test]
    fn a_ball_that_meets_the_cut_has_no_root() {
        let near = |im: i32| ComplexBall {
            re: Ball::integer(-1, 64),
            im: Ball::integer(im, 64).widened(Magnitude::power_of_two(-9)),
        };
        assert!(near(0).cube_root().is_none() && complex(0, 0).cube_root().is_none());
        assert!(near(1).cube_root().is_some(), "beside the cut");
        let [wide, narrow] = [2, -9].map(|power| {
            let re = Ball::integer(4, 64).widened(Magnitude::power_of_two(power));
            ComplexBall { im: re.int(0), re }.cube_root()
        });
        assert!(wide.is_none() && narrow.is_some());
    }

    #[test]
    fn a_square_root_of_a_real_number_needs_its_sign() {
        let root = |n: i32| ComplexBall::root_of_real(&Ball::integer(n, 64));
        assert!(holds(&root(9).unwrap(), 3, 0) && holds(&root(-9).unwrap(), 0, 3));
        let around = Ball::integer(0, 64).widened(Magnitude::power_of_two(-3));
        assert!(ComplexBall::root_of_real(&around).is_none());
        assert!(around.contains(&Rational::new()));
    }
}
