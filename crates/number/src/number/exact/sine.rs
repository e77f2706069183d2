//! Sines and cosines of exact angles, where they are square roots.

use super::{ExactNumber, Form, root};
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;

/// Sine and cosine of an angle between 0 and pi, each as a rational number and the integer of whose square root it
/// is the factor: 1, 2 or 3. `None` where they are no such numbers.
///
/// Of the rational multiples of pi they are rational at no others (Niven), and of the rational numbers at none
/// (Lindemann); of an [arctangent of a root](Form::ArctangentOfRoot) [one](rational_sine_and_cosine) may be.
///
/// ```
/// use couplet_number::number::{ExactNumber, sine_and_cosine};
/// let angle: ExactNumber = "120deg".parse().unwrap();
/// let [sine, cosine] = sine_and_cosine(&angle).unwrap();
/// assert_eq!((sine.0.to_string(), sine.1), ("1/2".into(), 3));
/// assert_eq!((cosine.0.to_string(), cosine.1), ("-1/2".into(), 1));
/// ```
pub fn sine_and_cosine(angle: &ExactNumber) -> Option<[(BigRational, u32); 2]> {
    let ratio = |n: i32, d: i32| BigRational::new(n.into(), d.into());
    let q = angle.factor();
    match angle.form() {
        Form::Rational | Form::ArctangentOfRoot => None,
        Form::TwiceArctangent => {
            let square = q * q;
            let below = ratio(1, 1) + &square;
            let sine = q * BigInt::from(2) / &below;
            Some([(sine, 1), ((ratio(1, 1) - square) / below, 1)])
        }
        Form::TimesPi => {
            let half = || ratio(1, 2);
            let known = [
                (ratio(1, 6), (half(), 1), (half(), 3)),
                (ratio(1, 4), (half(), 2), (half(), 2)),
                (ratio(1, 3), (half(), 3), (half(), 1)),
                (half(), (ratio(1, 1), 1), (ratio(0, 1), 1)),
            ];
            known.into_iter().find_map(|(part, sine, cosine)| match *q == part {
                true => Some([sine, cosine]),
                false => (*q == ratio(1, 1) - part).then_some([sine, (-cosine.0, cosine.1)]),
            })
        }
    }
}

/// Sine and cosine of an angle between 0 and pi, each where it is rational.
pub fn rational_sine_and_cosine(angle: &ExactNumber) -> [Option<BigRational>; 2] {
    if angle.form() != Form::ArctangentOfRoot {
        let both =
            sine_and_cosine(angle).map(|both| both.map(|(x, root)| (root == 1).then_some(x)));
        return both.unwrap_or_default();
    }
    let is_obtuse = angle.factor().numer().sign() == Sign::Plus;
    let square = if is_obtuse { angle.factor().clone() } else { -angle.factor() };
    let slant = &square + BigRational::from(BigInt::from(1));
    let cosine = root(&(square / &slant));
    [root(&slant.recip()), cosine.map(|cosine| if is_obtuse { -cosine } else { cosine })]
}
