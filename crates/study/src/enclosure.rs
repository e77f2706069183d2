//! The root of a problem in a proved box: the reference for every error, and a method itself.

use super::{Task, newton};
use crate::number::{Ball, Enclosure, Engine, Magnitude};
use crate::prover::operator::{Equations, Operator, corrections, inflated, inverse_jacobian};
use rug::Float;

/// A box that holds exactly one root next to the start, to about `bits` bits, in the arithmetic `E`;
/// `None` if that is not proved.
///
/// The centre comes from Newton's method in MPFR: where the box is does not need to be trusted.
pub fn enclose<E: Engine>(task: &Task, start: &[f64], bits: u32) -> Option<Vec<E>> {
    let centre = newton::doubling(task, start, bits)?.root;
    enclose_at(task, &centre, bits)
}

/// Encloses a solution around a centre that is known.
pub fn enclose_at<E: Engine>(task: &Task, centre: &[Float], bits: u32) -> Option<Vec<E>> {
    // The inverse only has to be near; but a stiff system is told from a singular one by many bits.
    let near = bits.min(2048);
    let low: Vec<Ball> =
        centre.iter().map(|x| Ball::exact(Float::with_val(near, x), near)).collect();
    let inverse = inverse_jacobian(&task.slopes(near, &low), near)?;
    // How wide the box has to be is seen in balls.
    let points: Vec<Ball> = centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
    let residuals = Equations::residuals(task, bits, &points);
    let corrections = corrections(&inverse, &residuals, centre, bits);
    let operator = Operator::<_, E>::new(task, bits, centre, &inverse);
    inflated(&operator, &corrections).map(|[_, image]| image)
}

/// An upper bound of the distance of a value from the truth, which `truth` encloses.
pub fn error(value: &Float, truth: &Ball) -> ErrorSizes {
    let bits = truth.prec().max(value.prec()) + 64;
    let difference = Ball::exact(value.clone(), bits) - truth;
    let up = |x: &Ball| Magnitude::upper(x.mid()).plus(x.rad());
    let absolute = up(&difference);
    let relative = match truth.excludes_zero() {
        true => up(&(difference / truth)),
        false => absolute,
    };
    let log2 = |x: Magnitude| x.to_float().to_f64_exp();
    let (a, r) = (log2(absolute), log2(relative));
    let ulp = absolute.shifted(i64::from(value.prec()) - i64::from(value.get_exp().unwrap_or(0)));
    ErrorSizes {
        absolute: decimal_exponent(a),
        relative: decimal_exponent(r),
        units: ulp.to_float().to_f64(),
    }
}

/// `log10` of `m * 2^e`; negative infinity for zero.
fn decimal_exponent((mantissa, exponent): (f64, i32)) -> f64 {
    mantissa.abs().log10() + f64::from(exponent) * std::f64::consts::LOG10_2
}

/// Distance of a value from the truth. Sizes are decimal logarithms, as errors of `10^-20000` occur; minus
/// infinity is exact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ErrorSizes {
    /// `log10 |value - truth|`.
    pub absolute: f64,
    /// `log10 |value - truth|/|truth|`.
    pub relative: f64,
    /// Error in units of the last place of the value.
    pub units: f64,
}

/// `log10` of the radius of a ball relative to its midpoint.
pub fn relative_radius(ball: &Ball) -> f64 {
    let size = ball.rad().over(Magnitude::lower(ball.mid()));
    decimal_exponent(size.to_float().to_f64_exp())
}
