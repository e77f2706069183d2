//! Proof that one equation has one root in a box, without a branch.
//!
//! With a number `m` next to the root, a double `Y` next to `1/F'(m)` and the box `X = m ± rho`,
//!
//! ```text
//! K = m - Y F(m) + (1 - Y F'(X)) (X - m)
//! ```
//!
//! holds every root in `X`, and if `K` is inside `X` there is exactly one (Krawczyk): `|Y F(m)| + |1 - Y F'(X)| rho <
//! rho`. `F(m)` is enclosed in double-doubles, the slope in doubles. With the root `m + d` and `d` in `K - m`, a value
//! `v` is in `v(m) + v'(X) d` by the mean value theorem; `d` is about `2^-50`, so that slopes in doubles leave about
//! thirty digits. On `X` all is smooth, as a divisor that may be small makes what it divides the whole line. What is
//! given is in enclosures: all this holds for each number in them.

use super::sine::{Long, Short, Sine, around, unknown};
use crate::number::{Angle, Gradient, Product, SinePoint, power_of_two};

/// Ratio of the width of a box to the correction that the residual asks for.
const INFLATION: f64 = 4.0;
/// Least radius of a box.
const LEAST_RADIUS: f64 = power_of_two(-90);

/// One equation for a joint or another angle, in what is given.
pub(super) trait Equation<P: Product, const V: usize> {
    /// True if the residual loses many digits in doubles: then the last step to the root is one in double-doubles.
    const FINER: bool = false;

    /// The residual `F`, and `V` values that are asked for where it is zero; `number` makes what is given a number.
    fn at<T: Sine<P>>(
        &self,
        number: impl Fn(&Long<P>) -> T + Copy,
        angle: &Angle<T>,
    ) -> (T, [T; V]);
}

/// A root, if it is proved, and values there.
pub(super) struct LaneRoot<P, const V: usize> {
    /// True if the box holds exactly one root.
    pub(super) is_proved: bool,
    /// The root.
    pub(super) angle: Long<P>,
    /// The box, with sines and cosines.
    pub(super) domain: Angle<Short>,
    pub(super) values: [Long<P>; V],
}

/// A step of Newton's method in doubles, and the inverse of the slope.
#[inline(always)]
pub(super) fn newton<P: Product, const V: usize>(
    equation: &impl Equation<P, V>,
    start: f64,
    point: &SinePoint,
) -> (f64, f64) {
    let angle = unknown(&Sine::<P>::angle(start, point));
    let number = |x: &Long<P>| Gradient::constant(x.mid().hi());
    let (residual, _) = equation.at(number, &angle);
    let inverse = 1.0 / residual.slopes[0];
    (start - inverse * residual.value, inverse)
}

/// The root next to a candidate, after some steps of Newton's method; `point` is next to it.
#[inline(always)]
pub(super) fn root<P: Product, const V: usize, E: Equation<P, V>>(
    equation: &E,
    (start, point): (f64, &SinePoint),
    steps: usize,
) -> LaneRoot<P, V> {
    let (mut middle, mut inverse) = (start, 0.0);
    for _ in 0..steps {
        (middle, inverse) = newton(equation, middle, point);
    }
    let exact = |x: f64| Long::<P>::exact(x.into());
    let mut angle = exact(middle).angle(point);
    let (mut residual, mut all) = equation.at(|x: &Long<P>| *x, &angle);
    if E::FINER {
        let next = angle.rad - residual * exact(inverse);
        angle = Long::<P>::exact(next.mid()).angle(point);
        (residual, all) = equation.at(|x: &Long<P>| *x, &angle);
    }
    let step = residual * exact(inverse);
    let radius = INFLATION * step.size() + LEAST_RADIUS;
    let domain = around(&angle, radius);
    let number = |x: &Long<P>| Gradient::constant(x.in_doubles());
    let (slope, slopes) = equation.at(number, &unknown(&domain));
    let rest = Short::exact(1.0) - slope.slopes[0] * Short::exact(inverse);
    let image = (-step).widened((rest * Short::exact(radius)).size());
    let moved = |x: Long<P>, slope: Short| x + slope.in_double_doubles() * image;
    for (value, with) in all.iter_mut().zip(&slopes) {
        *value = moved(*value, with.slopes[0]);
    }
    let is_proved = image.size() < radius;
    LaneRoot { is_proved, angle: angle.rad + image, domain, values: all }
}

/// A number that is known if something is proved, else the whole line.
#[inline(always)]
pub(super) fn known_if<P: Product>(is_proved: bool, x: Long<P>) -> Long<P> {
    Long::new(x.mid(), if is_proved { x.rad() } else { f64::NAN })
}

/// Tells whether a number is between two ends, as the table of it begins and ends there.
#[inline(always)]
#[allow(clippy::manual_range_contains, reason = "a range decides in two steps")]
pub(super) fn is_within(x: f64, [first, last]: [f64; 2]) -> bool {
    (x >= first) & (x <= last)
}
