//! Halved until proved: the one loop behind a statement on all of an interval, a rectangle or a piece of a curve.

use rug::Rational;

/// Proves a statement on a whole: on each part at once, or, where the proof of a part is left open, on its halves, one
/// after the other. Returns the number of parts.
///
/// A part that is not proved after `deepest` halvings, or has no halves, ends the search with why its proof is open:
/// then nothing is proved of the whole.
pub fn halve<P, E>(
    whole: P,
    deepest: u32,
    halves: impl Fn(&P) -> Option<[P; 2]>,
    mut proof: impl FnMut(&P) -> Result<(), E>,
) -> Result<usize, E> {
    let (mut parts, mut open) = (0, vec![(whole, deepest)]);
    while let Some((part, left)) = open.pop() {
        let Err(why) = proof(&part) else {
            parts += 1;
            continue;
        };
        let [first, last] = if left > 0 { halves(&part) } else { None }.ok_or(why)?;
        open.extend([(last, left - 1), (first, left - 1)]);
    }
    Ok(parts)
}

/// Halves of the numbers from one to another; none of a point.
pub fn halves((low, high): &(Rational, Rational)) -> Option<[(Rational, Rational); 2]> {
    let middle: Rational = Rational::from(low + high) / 2;
    (low < high).then(|| [(low.clone(), middle.clone()), (middle, high.clone())])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parts of the numbers from 0 to 1 on which a statement holds that it is proved on if they are short, or low.
    #[test]
    fn a_whole_is_proved_part_by_part_or_not_at_all() {
        let whole = || (Rational::from(0), Rational::from(1));
        let proved = |deepest, from: i32| {
            let mut tried = 0;
            let found = halve(whole(), deepest, halves, |(low, high)| {
                tried += 1;
                let is_short = Rational::from(high - low) < Rational::from((1, 3));
                let is_true = *high <= Rational::from((from, 4));
                (is_short && is_true).then_some(()).ok_or((low.to_f64(), high.to_f64()))
            });
            (found, tried)
        };
        assert_eq!(proved(2, 4), (Ok(4), 7));
        assert_eq!(proved(1, 4), (Err((0.0, 0.5)), 2), "not so deep");
        assert_eq!(proved(2, 3), (Err((0.75, 1.0)), 7), "false twin: not on the last part");
        let point = (Rational::from(1), Rational::from(1));
        assert!(halve(point, 9, halves, |_| Err::<(), _>(())).is_err(), "nothing to halve");
    }
}
