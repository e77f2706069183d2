//! A function positive on an interval, however little room it leaves.
//!
//! On pieces its sign follows from Taylor's theorem; where it is monotone from the lower end, where it is concave
//! from both, and where it is convex from its value and slope at one point, best near the lowest: `f(c) - f'(c)²/(2
//! min f'')` is below all its values. Where it is known to be zero, nothing next to it is below that.

use crate::number::{Ball, Enclosure, Field, Jet};
use crate::prover::Undecided;
use crate::prover::decide::is_positive;
use crate::prover::halve::halve;
use rug::Float;

/// Halvings at most: a piece that is convex or monotone is long before.
const DEPTH: u32 = 40;

/// A point where a function is known to be zero, enclosed.
#[derive(Clone, Debug)]
pub(crate) enum Zero {
    /// A point at which the slope is zero too.
    Touch(Ball),
    /// The lower end of the interval.
    Begin(Ball),
    /// The upper end of the interval.
    End(Ball),
}

impl Zero {
    /// Tells whether the function may be zero there: what is known of it is not contradicted.
    fn may_be(&self, series: &dyn Fn(&Ball) -> Jet<Ball>) -> bool {
        let (Self::Touch(at) | Self::Begin(at) | Self::End(at)) = self;
        let there = series(at);
        let is_level = !matches!(self, Self::Touch(_)) || !there.coefficient(1).excludes_zero();
        is_level && !there.value().excludes_zero()
    }

    /// Tells whether a function is positive on a piece but for this point: it is convex from a touch on, and rises from
    /// an end.
    fn is_least(&self, series: &dyn Fn(&Ball) -> Jet<Ball>, piece: &Ball) -> bool {
        let (Self::Touch(at) | Self::Begin(at) | Self::End(at)) = self;
        let whole = series(&piece.hull(at));
        match self {
            Self::Touch(_) => is_positive(&whole.coefficient(2)),
            Self::Begin(_) => is_positive(&whole.coefficient(1)),
            Self::End(_) => is_positive(&-whole.coefficient(1)),
        }
    }
}

fn undecided() -> Undecided {
    Undecided::new("whether a state is admissible at every joint")
}

/// Proves that a function, given as a series about each point, is positive from one number to another, but for some
/// points where it is zero.
pub(crate) fn is_positive_on(
    series: &dyn Fn(&Ball) -> Jet<Ball>,
    (low, high): (&Float, &Float),
    zeros: &[Zero],
    bits: u32,
) -> Result<(), Undecided> {
    if !zeros.iter().all(|zero| zero.may_be(series)) {
        return Err(undecided());
    }
    let exact = |x: &Float| Ball::exact(x.clone(), bits);
    let at = |x: &Float| is_positive(series(&exact(x)).value());
    let halves = |[low, high]: &[Float; 2]| {
        let middle = Float::with_val(bits, low + high) / 2u32;
        Some([[low.clone(), middle.clone()], [middle, high.clone()]])
    };
    let proof = |[low, high]: &[Float; 2]| {
        let piece = exact(low).hull(&exact(high));
        let whole = series(&piece);
        let (slope, bend) = (whole.coefficient(1), whole.coefficient(2));
        let middle = series(&piece.midpoint());
        let offset = piece.centred();
        let bound =
            middle.coefficient(1) * &offset + middle.value() + bend.clone() * offset.square();
        let holds = is_positive(&bound)
            || is_positive(&slope) && at(low)
            || is_positive(&-slope.clone()) && at(high)
            || is_positive(&-bend.clone()) && at(low) && at(high)
            || is_positive(&bend) && {
                // Lowest where the slope is zero, or anywhere: f(c) - f'(c)²/(4 bend) is below all values.
                let mut lowest = Float::with_val(bits, piece.mid());
                for _ in 0..4 + bits.ilog2() {
                    let here = series(&exact(&lowest));
                    let step = Float::with_val(bits, here.coefficient(1).mid())
                        / (Float::with_val(bits, here.coefficient(2).mid()) * 2u32);
                    lowest -= step;
                    lowest = lowest.clamp(low, high);
                }
                let here = series(&exact(&lowest));
                let drop = here.coefficient(1).square() / (bend.int(4) * &bend);
                is_positive(&(here.value().clone() - drop))
            }
            || zeros.iter().any(|zero| zero.is_least(series, &piece));
        holds.then_some(()).ok_or_else(undecided)
    };
    halve([low.clone(), high.clone()], DEPTH, halves, proof).map(drop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_on_an_interval_is_proved_however_little_room_there_is() {
        let third = |x: &Ball| x.ratio(1, 3);
        let positive = |power: i64, sign: i32| {
            let series = |x: &Ball| {
                let off = x.clone() - third(x);
                let room = x.int(sign).scaled(-power);
                Jet::new(vec![off.square() + room, off.clone() + off, x.int(1)], 2)
            };
            let (low, high) = (Float::with_val(300, -1), Float::with_val(300, 2));
            is_positive_on(&series, (&low, &high), &[], 300).is_ok()
        };
        assert!(positive(2, 1) && positive(40, 1) && positive(200, 1));
        assert!(!positive(40, 0) && !positive(40, -1) && !positive(200, -1), "false twins");
    }

    /// Where a function is known to be zero it may be, and nowhere else; and what is claimed of it there has to agree
    /// with what is seen next to it.
    #[test]
    fn a_zero_that_is_known_is_no_obstacle() {
        let at = |n: i32, d: i32| Ball::integer(0, 200).ratio(n, d);
        let third = at(1, 3);
        let (low, high) = (Float::with_val(200, 0), Float::with_val(200, 1));
        let proves = |series: &dyn Fn(&Ball) -> Jet<Ball>, zeros: &[Zero]| {
            is_positive_on(series, (&low, &high), zeros, 200).is_ok()
        };
        let square = |x: &Ball| {
            let off = x.clone() - &third;
            Jet::new(vec![off.square(), off.clone() + off, x.int(1)], 2)
        };
        let touch = || Zero::Touch(third.clone());
        assert!(proves(&square, &[touch()]) && !proves(&square, &[]));
        assert!(
            !proves(&square, &[Zero::Touch(at(1, 2))])
                && !proves(&square, &[Zero::Begin(at(0, 1))])
        );
        // A hill is not above its touch.
        assert!(!proves(&|x| -square(x), &[touch()]));
        let line = |x: &Ball| Jet::new(vec![x.clone(), x.int(1)], 2);
        let falls = |x: &Ball| Jet::new(vec![x.int(1) - x, x.int(-1)], 2);
        let (begin, end) = ([Zero::Begin(at(0, 1))], [Zero::End(at(1, 1))]);
        assert!(proves(&line, &begin) && proves(&falls, &end));
        assert!(!proves(&line, &end) && !proves(&falls, &begin));
    }
}
