//! A turn: the point `cos x + i sin x` in fixed point, with a bound of its error.

use super::gaussian::Gaussian;
use super::product::product;
use super::small_angle::SmallAngle;
use super::{Ball, Magnitude, fixed};
use rug::{Complete, Integer};

/// Sine and cosine of an angle, in units of `2^-places`.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    pub sin: Integer,
    pub cos: Integer,
    pub places: u32,
    /// A bound of the distance, in the complex plane, from the true point.
    pub error: Magnitude,
}

/// Bits of a factor kept beyond those that reach the product with a small one.
const GUARD: u32 = 8;

impl Turn {
    /// No turn.
    pub(super) fn none(places: u32) -> Self {
        Self {
            sin: Integer::new(),
            cos: Integer::from(1) << places,
            places,
            error: Magnitude::ZERO,
        }
    }

    /// Turn from enclosures of sine and cosine.
    pub(super) fn new((sin, cos): (Ball, Ball), places: u32) -> Self {
        let error = sin.rad().plus(cos.rad());
        let [sin, cos] = [sin, cos].map(|x| fixed(x.mid(), places));
        Self { sin, cos, places, error }.off_by(2)
    }

    /// The turn back.
    pub(super) fn back(self) -> Self {
        Self { sin: -self.sin, ..self }
    }

    /// `n` right angles further; exact.
    pub(super) fn by_right_angles(self, n: i32) -> Self {
        let Self { sin, cos, .. } = self;
        let (sin, cos) = match n.rem_euclid(4) {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        };
        Self { sin, cos, ..self }
    }

    /// `2 arg u` further.
    ///
    /// Error: the product with `u²/|u|²`, exact and of modulus one, keeps it; each part loses less than a unit.
    pub(super) fn by_twice(self, u: &Gaussian) -> Self {
        let (square, norm) = (u.squared(), u.norm());
        let (a, b) = (product(&self.cos, &square.im), product(&self.sin, &square.re));
        let (c, d) = (product(&self.cos, &square.re), product(&self.sin, &square.im));
        Self { sin: (a + b) / &norm, cos: (c - d) / &norm, ..self }.off_by(2)
    }

    /// A small angle further: `sin + (cos sin d - sin vers d)`, `cos - (sin sin d + cos vers d)`, by three products.
    ///
    /// Error: with `s, c` off by `e` and `sin d`, `vers d` by `f` units, the exact product of what is there is off by
    /// `e + (1 + e) 2f` at most, for the two parts of the second factor make a point off by less than `2f`. The
    /// bits cut from `s` and `c` are below `2^(small - GUARD)` units, times numbers below `2^-small`; the parts
    /// are rounded down a few times: less than four units in all.
    pub(super) fn by_small(&self, step: &SmallAngle) -> Self {
        let cut = step.small.saturating_sub(GUARD);
        let [sin, cos] = [&self.sin, &self.cos].map(|x| (x >> cut).complete());
        let turned = product(&cos, &step.sin);
        let (lost, both) = if step.versine.is_zero() {
            (Integer::new(), turned.clone() + product(&sin, &step.sin))
        } else {
            (
                product(&sin, &step.versine),
                product(&(&sin + &cos).complete(), &(&step.sin + &step.versine).complete()),
            )
        };
        let down = self.places - cut;
        let sin = (&turned - &lost).complete() >> down;
        let cos = (both - turned - lost) >> down;
        let unit = Magnitude::power_of_two(-i64::from(self.places));
        let error = unit.times(Magnitude::from_integer(2 * SmallAngle::ERROR));
        let error = self.error.plus(error).plus(self.error.times(error));
        Self { sin: sin + &self.sin, cos: &self.cos - cos, error, ..*self }.off_by(4)
    }

    /// `d` units further; `None` beyond a quarter.
    pub(super) fn moved(&self, d: &Integer) -> Option<Self> {
        if d.is_zero() {
            return Some(self.clone());
        }
        let is_small = d.significant_bits() + 2 <= self.places;
        is_small.then(|| self.by_small(&SmallAngle::by_series(d, self.places)))
    }

    /// The turn cut to fewer places.
    pub(super) fn cut(&self, places: u32) -> Self {
        let Some(excess) = self.places.checked_sub(places).filter(|&excess| excess > 0) else {
            return self.clone();
        };
        let [sin, cos] = [&self.sin, &self.cos].map(|x| (x >> excess).complete());
        Self { sin, cos, places, error: self.error }.off_by(2)
    }

    /// Sine and cosine of the angle.
    pub(super) fn balls(&self, prec: u32) -> (Ball, Ball) {
        let ball = |x| Ball::fixed(x, self.places, prec).widened(self.error);
        (ball(&self.sin), ball(&self.cos))
    }

    /// Turn with as many units more in the bound of the error.
    fn off_by(mut self, units: u64) -> Self {
        let unit = Magnitude::power_of_two(-i64::from(self.places));
        self.error = self.error.plus(unit.times(Magnitude::from_integer(units)));
        self
    }
}
