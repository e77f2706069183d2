//! A function positive on an interval, however little room it leaves.
//!
//! On pieces its sign follows from Taylor's theorem; where it is monotone from the lower end, where it is concave
//! from both, and where it is convex from its value and slope at one point, best near the lowest: `f(c) - f'(c)²/(2
//! min f'')` is below all its values.

use super::Undecided;
use super::decide::is_positive;
use crate::number::{Ball, Enclosure, Field, Jet};
use rug::Float;

/// Halvings at most: a piece that is convex or monotone is long before.
const DEPTH: usize = 40;

/// Proves that a function, given as a series about each point, is positive from one number to another.
pub(crate) fn is_positive_on(
    series: &dyn Fn(&Ball) -> Jet<Ball>,
    (low, high): (&Float, &Float),
    bits: u32,
) -> Result<(), Undecided> {
    let exact = |x: &Float| Ball::exact(x.clone(), bits);
    let at = |x: &Float| is_positive(series(&exact(x)).value());
    let mut open = vec![(low.clone(), high.clone(), 0)];
    while let Some((low, high, depth)) = open.pop() {
        let piece = exact(&low).hull(&exact(&high));
        let whole = series(&piece);
        let (slope, bend) = (whole.coefficient(1), whole.coefficient(2));
        let middle = series(&piece.midpoint());
        let offset = piece.centred();
        let bound =
            middle.coefficient(1) * &offset + middle.value() + bend.clone() * offset.square();
        let holds = is_positive(&bound)
            || is_positive(&slope) && at(&low)
            || is_positive(&-slope.clone()) && at(&high)
            || is_positive(&-bend.clone()) && at(&low) && at(&high)
            || is_positive(&bend) && {
                // Lowest where the slope is zero, or anywhere: f(c) - f'(c)²/(4 bend) is below all values.
                let mut lowest = Float::with_val(bits, piece.mid());
                for _ in 0..4 + bits.ilog2() {
                    let here = series(&exact(&lowest));
                    let step = Float::with_val(bits, here.coefficient(1).mid())
                        / (Float::with_val(bits, here.coefficient(2).mid()) * 2u32);
                    lowest -= step;
                    lowest = lowest.clamp(&low, &high);
                }
                let here = series(&exact(&lowest));
                let drop = here.coefficient(1).square() / (bend.int(4) * &bend);
                is_positive(&(here.value().clone() - drop))
            };
        if holds {
            continue;
        }
        if depth == DEPTH {
            return Err(Undecided::new("whether a state is admissible at every joint"));
        }
        let middle = Float::with_val(bits, &low + &high) / 2u32;
        open.push((middle.clone(), high, depth + 1));
        open.push((low, middle, depth + 1));
    }
    Ok(())
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
            is_positive_on(&series, (&low, &high), 300).is_ok()
        };
        assert!(positive(2, 1) && positive(40, 1) && positive(200, 1));
        assert!(!positive(40, 0) && !positive(40, -1) && !positive(200, -1), "false twins");
    }
}
