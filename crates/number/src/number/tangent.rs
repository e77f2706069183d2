//! The angle of a positive tangent, in any enclosures.
//!
//! ```text
//! atan(q) = 2 atan(q / (1 + √(1 + q²)))        atan(x) = x (1 - x²/3 + x⁴/5 - …)
//! ```
//!
//! The angle is halved until it is small and its series summed. All of it is done in enclosures, so that only the
//! tail needs a bound of its own: it is at most the first term left out, as the terms alternate and fall.

use super::{Dyadic, Engine};

/// `atan(q)` for a positive `q`, to about `bits` bits relative to its size.
pub(super) fn angle_of_tangent<E: Engine>(q: &E, bits: usize) -> E {
    // Balls of doubles say nothing of their bits.
    let bits = bits.max(128);
    let halvings = bits.isqrt() / 2 + 4;
    // The angle was below pi/2, so what is left is below `tan(pi/2 / 2^halvings) <= 2^-small`.
    let small = halvings - 1;
    let terms = bits / (2 * small) + 1;
    let half = |x: E| x.clone() / ((x.square() + &x.int(1)).sqrt() + &x.int(1));
    let x = (0..halvings).fold(q.clone(), |x, _| half(x));
    let square = x.square();
    let place = |k: usize| square.ratio(1, 2 * k as i32 + 1);
    let sum = (0..terms).rev().fold(square.int(0), |sum, k| place(k) - sum * &square);
    let tail = Dyadic::new(false, vec![1], -((2 * small * terms) as i32));
    // Twice the angle so often is an exact shift.
    let doublings = E::exact(&Dyadic::new(false, vec![1], halvings as i32), bits);
    x * sum.widened_by(&tail) * doublings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, DoubleDoubleBall, Ternary};

    /// The tangent of the angle is the number, however small or large that is, and not its neighbour.
    fn turns_back<E: Engine>(bits: usize, sharp: i32) {
        for (n, d) in [(1, 1_000_000), (1, 3), (3, 5), (1, 1), (7, 2), (1_000_000, 1)] {
            let q = E::zero(bits).ratio(n, d);
            let angle = angle_of_tangent(&q, bits);
            let (sin, cos) = angle.sin_cos();
            let rest = sin - cos.clone() * &q;
            assert!(rest.overlaps(&q.int(0)), "{n}/{d}");
            // The angle of so much more is larger by about its own `2^-sharp`, or by `2^-sharp`.
            let near = E::exact(&Dyadic::new(false, vec![1], -sharp), bits) * (q.square() + &q);
            let other = angle_of_tangent(&(q.clone() + near), bits);
            assert_eq!(angle.is_less_than(&other), Ternary::True, "{n}/{d}");
        }
    }

    #[test]
    fn the_tangent_of_the_angle_is_the_number() {
        turns_back::<DoubleDoubleBall>(0, 90);
        for bits in [64, 200, 1000, 4000] {
            turns_back::<AstroInterval>(bits, bits as i32 - 30);
        }
    }

    #[test]
    fn the_angle_is_that_of_mpfr() {
        use crate::number::{Ball, Magnitude};
        for bits in [64, 333, 3333] {
            for text in ["1e-300", "1e-20", "1/3", "0.999999", "1.000001", "12345.6789", "1e300"] {
                let q: crate::number::ExactNumber = text.parse().unwrap();
                let q: Ball = q.enclosure(bits);
                let ours = angle_of_tangent(&q, bits as usize);
                let truth = rug::Float::with_val(bits + 100, q.mid()).atan();
                let allowed = Magnitude::upper(&truth).shifted(40 - i64::from(bits));
                assert!(ours.lower() <= truth && truth <= ours.upper(), "{text} {bits}");
                assert!(ours.rad() < allowed, "wide: {text} {bits}");
            }
        }
    }
}
