//! Sines and roots of the numbers that go through a proof: doubles, both balls and their gradients.

use crate::number::{
    Angle, Branchless, DoubleDoubleBy, Field, FloatBall, Gradient, Product, Real, SinePoint,
};

/// Ball of doubles.
pub(super) type Short = FloatBall<f64, Branchless>;
/// Ball of double-doubles.
pub(super) type Long<P> = FloatBall<DoubleDoubleBy<P>, Branchless>;

/// A number whose sine is found from a point next to it, with products by `P` where they have to be exact.
pub(super) trait Sine<P: Product>: Field + Copy {
    /// The angle of so many radians; the whole line where the point does not reach it.
    fn angle(self, point: &SinePoint) -> Angle<Self>;

    /// The square root of a positive number.
    fn root(self) -> Self;
}

/// A candidate.
impl<P: Product> Sine<P> for f64 {
    #[inline(always)]
    fn angle(self, point: &SinePoint) -> Angle<Self> {
        let (sin, cos) = point.sin_cos_in_doubles(self);
        Angle { rad: self, sin, cos }
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl<P: Product> Sine<P> for Long<P> {
    /// At the midpoint both errors are at most [`SinePoint::ERROR`] here, and
    /// [`ERROR_IN_DOUBLES`](SinePoint::ERROR_IN_DOUBLES) in doubles; elsewhere `|sin x - sin m| <= |x - m|`, and the
    /// same for the cosine.
    #[inline(always)]
    fn angle(self, point: &SinePoint) -> Angle<Self> {
        let (sin, cos) = point.sin_cos(self.mid());
        let error = if point.reaches(self.mid().hi()) { SinePoint::ERROR } else { f64::NAN };
        let [sin, cos] = [sin, cos].map(|x| Self::new(x, error).widened(self.rad()));
        Angle { rad: self, sin, cos }
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl<P: Product> Sine<P> for Short {
    #[inline(always)]
    fn angle(self, point: &SinePoint) -> Angle<Self> {
        let (sin, cos) = point.sin_cos_in_doubles(self.mid());
        let reaches = point.reaches(self.mid());
        let error = if reaches { SinePoint::ERROR_IN_DOUBLES } else { f64::NAN };
        let [sin, cos] = [sin, cos].map(|x| Self::new(x, error).widened(self.rad()));
        Angle { rad: self, sin, cos }
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl<P: Product, T: Sine<P>> Sine<P> for Gradient<T, 1> {
    #[inline(always)]
    fn angle(self, point: &SinePoint) -> Angle<Self> {
        with_slope(&self.value.angle(point), self.slopes[0])
    }

    #[inline(always)]
    fn root(self) -> Self {
        let root = self.value.root();
        Self { value: root, slopes: [self.slopes[0] / (root.int(2) * root)] }
    }
}

/// An angle with the slope of its radians.
#[inline(always)]
fn with_slope<T: Field + Copy>(angle: &Angle<T>, slope: T) -> Angle<Gradient<T, 1>> {
    let with = |value: T, slope: T| Gradient { value, slopes: [slope] };
    Angle {
        rad: with(angle.rad, slope),
        sin: with(angle.sin, angle.cos * slope),
        cos: with(angle.cos, -angle.sin * slope),
    }
}

/// An angle as the unknown.
#[inline(always)]
pub(super) fn unknown<T: Field + Copy>(angle: &Angle<T>) -> Angle<Gradient<T, 1>> {
    with_slope(angle, angle.rad.int(1))
}

/// All angles within a distance, in doubles.
#[inline(always)]
pub(super) fn around<P: Product>(angle: &Angle<Long<P>>, distance: f64) -> Angle<Short> {
    let around = |x: &Long<P>| x.in_doubles().widened(distance);
    Angle { rad: around(&angle.rad), sin: around(&angle.sin), cos: around(&angle.cos) }
}
