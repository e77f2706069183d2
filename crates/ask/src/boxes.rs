//! Parts of a range that touch each other: together they are the range, and each has two exact ends.

use super::question::Misfit;
use super::range::{Part, Range, no_number};
use crate::number::shown;
use num_bigint::BigInt;

/// Ranges of one extent, each beginning where the one before ends, from the lower end of a range to its upper end.
///
/// ```
/// use couplet_ask::{Range, boxes};
/// let of = Range { lower: "80deg".into(), upper: "81deg".into() };
/// let texts = boxes(&of, 2).unwrap().map(|part| format!("{}..{}", part.lower, part.upper));
/// assert_eq!(texts.collect::<Vec<_>>(), ["80deg..80.5deg", "80.5deg..81deg"]);
/// ```
pub fn boxes(of: &Range, count: usize) -> Result<impl Iterator<Item = Range> + use<>, Misfit> {
    let at = divided(of, count)?;
    Ok((0..count).map(move |k| Range { lower: at(k), upper: at(k + 1) }))
}

/// Exact texts of at least two numbers at equal distances, from the lower end of a range to its upper end.
///
/// ```
/// use couplet_ask::{Range, steps};
/// let of = Range { lower: "80deg".into(), upper: "81deg".into() };
/// assert_eq!(steps(&of, 3).unwrap().collect::<Vec<_>>(), ["80deg", "80.5deg", "81deg"]);
/// ```
pub fn steps(of: &Range, count: usize) -> Result<impl Iterator<Item = String> + use<>, Misfit> {
    let at = divided(of, count - 1)?;
    Ok((0..count).map(at))
}

/// Exact text of each point that cuts a range into so many parts, from the lower end on.
fn divided(of: &Range, parts: usize) -> Result<impl Fn(usize) -> String + use<>, Misfit> {
    let range = || shown(&format!("{}..{}", of.lower, of.upper));
    let read = |part: &str| Part::read(part).ok_or_else(|| no_number(&range(), part));
    let (lower, upper) = (read(&of.lower)?, read(&of.upper)?);
    let both = Part::together(lower, upper);
    let (unit, first, last) = both.ok_or_else(|| {
        format!(
            "'{}' is in two units, or in none that is cut into parts: give both ends as numbers, as lengths, or as \
             angles in radians, as multiples of pi or in degrees",
            range()
        )
    })?;
    if first >= last {
        return Err(format!("'{}' does not rise: give the smaller end first", range()).into());
    }
    Ok(move |k: usize| {
        unit.write(&(&first + (&last - &first) * BigInt::from(k) / BigInt::from(parts)))
    })
}

/// Tells whether a range has more than one number, in whatever units its ends are.
pub(super) fn has_extent(of: &Range) -> bool {
    let ends = Part::read(&of.lower).zip(Part::read(&of.upper));
    let ends = ends.and_then(|(lower, upper)| Part::together(lower, upper));
    of.lower != of.upper && ends.is_none_or(|(_, first, last)| first != last)
}

/// Exact text of the middle of a range.
pub(super) fn middle(of: &Range) -> Result<String, Misfit> {
    let upper = || of.upper.clone();
    Ok(boxes(of, 2)?.next().map_or_else(upper, |half| half.upper))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(range: &str, count: usize) -> Result<Vec<String>, String> {
        let range = Range::read(range).unwrap().unwrap();
        let all = boxes(&range, count).map_err(|error| error.to_string())?;
        Ok(all.map(|part| format!("{}..{}", part.lower, part.upper)).collect())
    }

    #[test]
    fn boxes_touch_and_are_the_whole_range() {
        for (range, count, expected) in [
            ("0.1..0.7", 3, &["0.1..0.3", "0.3..0.5", "0.5..0.7"][..]),
            ("0..1", 3, &["0..1/3", "1/3..2/3", "2/3..1"]),
            ("9m±10cm", 2, &["8.9m..9m", "9m..9.1m"]),
            ("90cm..1.1m", 2, &["0.9m..1m", "1m..1.1m"]),
            ("pi/4..pi/2", 2, &["pi/4..3pi/8", "3pi/8..pi/2"]),
            ("1rad..2rad", 1, &["1rad..2rad"]),
            ("0.1r..0.2r", 2, &["0.1r..0.15r", "0.15r..0.2r"]),
        ] {
            assert_eq!(texts(range, count).unwrap(), expected, "{range}");
        }
        let many = texts("20deg..140deg", 7).unwrap();
        assert!(many[0].starts_with("20deg..") && many[6].ends_with("..140deg"));
        let ends: Vec<_> = many.iter().map(|text| text.split_once("..").unwrap()).collect();
        assert!(ends.windows(2).all(|pair| pair[0].1 == pair[1].0));
    }

    #[test]
    fn what_has_no_parts_of_one_extent_is_refused() {
        for (range, why) in [
            ("0.5..inf", "'inf' is not a number"),
            ("0.5..tan(31deg)", "'tan(31deg)' is not a number"),
            ("1..pi/2", "'1..pi/2' is in two units"),
            ("0.7..0.5", "'0.7..0.5' does not rise"),
            ("0.5..0.5", "does not rise"),
            ("2atan(1)..2atan(2)", "is in two units, or in none"),
        ] {
            let error = texts(range, 2).unwrap_err();
            assert!(error.contains(why), "{range}: {error}");
        }
    }
}
