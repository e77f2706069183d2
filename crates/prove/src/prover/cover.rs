//! A statement on a whole interval, by subdivision.

use super::Undecided;
use super::halve::{halve, halves};
use crate::number::{Ball, Magnitude, Ternary};
use rug::Rational;

/// Bits in which a piece is examined.
const BITS: u32 = 96;
/// Maximum number of subdivisions of a piece.
const DEPTH: u32 = 24;

/// Proves that `holds` on every number of `[low, high]`: the interval is halved until the answer is
/// certain on each piece. Returns the number of pieces.
///
/// `holds` is given a ball that contains the piece; `True` has to mean that the statement holds at
/// every number of the ball. A piece on which it is `False`, or not known, after 24 halvings ends the
/// search: then nothing is proved.
pub fn cover(
    low: &Rational,
    high: &Rational,
    holds: &dyn Fn(&Ball) -> Ternary,
) -> Result<usize, Undecided> {
    let proof = |(low, high): &(Rational, Rational)| match holds(&between(low, high)) {
        Ternary::True => Ok(()),
        verdict => Err((verdict, low.to_f64(), high.to_f64())),
    };
    halve((low.clone(), high.clone()), DEPTH, halves, proof).map_err(|(verdict, low, high)| {
        let what = if verdict == Ternary::False { "false" } else { "not decided" };
        Undecided::new(format!("{what} between {low} and {high}"))
    })
}

/// A ball that holds the numbers from `low` to `high`.
pub fn between(low: &Rational, high: &Rational) -> Ball {
    let middle = Ball::enclosing(&(Rational::from(low + high) / 2), BITS);
    let radius = Ball::enclosing(&(Rational::from(high - low) / 2), BITS).upper();
    middle.widened(Magnitude::upper(&radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Enclosure, Field};

    #[test]
    fn a_sign_on_an_interval_is_proved_or_refused() {
        let (low, high) = (Rational::from(-1), Rational::from(1));
        let above = |least: (i32, i32)| {
            cover(&low, &high, &|x| (x.square() + x + x.ratio(least.0, least.1)).is_positive())
        };
        assert!(above((26, 100)).is_ok(), "the least value of x² + x is -1/4");
        assert!(above((24, 100)).is_err(), "false twin");
        assert!(above((1, 4)).is_err(), "zero at -1/2 is not positive");
    }

    #[test]
    fn a_piece_is_held_whole() {
        let (low, high) = (Rational::from((1, 3)), Rational::from((2, 7)));
        let piece = between(&high, &low);
        assert!(piece.contains(&low) && piece.contains(&high));
    }
}
