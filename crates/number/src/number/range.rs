//! Texts that are meant as ranges, which readers of one number refuse as such.

use super::is_plain;
use std::borrow::Cow;

/// Sign between the two ends of a range.
pub const BETWEEN: &str = "..";
/// Sign between a value and how far off it may be.
pub const PLUS_MINUS: &str = "±";

/// Other spellings of these signs; a dash may be a minus at the beginning.
const SPELLINGS: [(&str, &str); 5] =
    [("+/-", PLUS_MINUS), ("+-", PLUS_MINUS), (" to ", BETWEEN), ("–", BETWEEN), ("—", BETWEEN)];

/// Commands that tell of ranges, for who asks elsewhere.
pub const TELL_OF_RANGES: &str = "`couplet assess`, `state`, `voussoirs`, `find half-opening`, `find friction`, `draw` and `certify survey`";

/// Tells whether a text is meant as a range: `0.5..0.7`, `0.6±0.1`, `0.6+-10%`, `0.5–0.7`, `9.98m-10.02m`.
pub fn is_range(text: &str) -> bool {
    if is_plain(text) {
        return false;
    }
    let text = spelt_range(text);
    text.contains(BETWEEN) || text.contains(PLUS_MINUS)
}

/// A text with the signs of a range as they are read.
///
/// ```
/// use couplet_number::number::spelt_range;
/// let all = ["0.5 to 0.7", "0.5–0.7", "0.5-0.7", "10m+/-2cm", "-1e-5"].map(spelt_range);
/// assert_eq!(all, ["0.5..0.7", "0.5..0.7", "0.5..0.7", "10m±2cm", "-1e-5"]);
/// ```
pub fn spelt_range(text: &str) -> Cow<'_, str> {
    let text = text.trim();
    if [BETWEEN, PLUS_MINUS].iter().any(|sign| text.contains(sign)) {
        return text.into();
    }
    let start = text.chars().next().map_or(0, char::len_utf8);
    let (first, rest) = text.split_at(start);
    if let Some((sign, meant)) = SPELLINGS.into_iter().find(|(sign, _)| rest.contains(sign)) {
        return (first.to_owned() + &rest.replace(sign, meant)).into();
    }
    match hyphen(text) {
        Some(place) => {
            format!("{}{BETWEEN}{}", text[..place].trim_end(), text[place + 1..].trim_start())
                .into()
        }
        None => text.into(),
    }
}

/// Place of the hyphen between two numbers with one unit, or with a unit behind the second alone; none where it
/// could be anything else.
fn hyphen(text: &str) -> Option<usize> {
    let is_between = |&(place, _): &(usize, &str)| {
        let (before, behind) = (text[..place].trim_end(), text[place + 1..].trim_start());
        let power = before.strip_suffix(['e', 'E', 'd', 'D', 'p', 'P']);
        let is_power =
            power.is_some_and(|number| number.ends_with(|c: char| c.is_ascii_digit() || c == '.'));
        let is_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        is_number(text) && is_number(behind) && !is_power
    };
    let mut places = text.match_indices('-').filter(is_between);
    let (place, _) = places.next()?;
    let unit = |text: &str| {
        text.trim_start_matches(|c: char| !c.is_alphabetic() && !"°'\"%".contains(c)).to_owned()
    };
    let [one, other] = [&text[..place], &text[place + 1..]].map(|part| unit(part.trim()));
    (places.next().is_none() && (one.is_empty() || one == other)).then_some(place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::ExactNumber;

    #[test]
    fn a_range_is_no_number_and_is_refused_as_a_range() {
        for text in ["0.5..0.7", "80deg±1deg", "1e-5+-1%", "..", "0.5–0.7", "1e-3-2e-3", "30 to 32"]
        {
            let error = text.parse::<ExactNumber>().unwrap_err().to_string();
            assert!(is_range(text) && error.contains("is a range: one value"), "{text}: {error}");
        }
        for text in [
            "1e+5", "-1", "1,5", "a.b", "1e-5", "0x1p-1", "1.D-3", "10ft-6in", "1-2-3", "a-b", "–1",
        ] {
            let error = text.parse::<ExactNumber>().err().map(|error| error.to_string());
            let error = error.unwrap_or_default();
            assert!(!is_range(text) && !error.contains("range"), "{text}: {error}");
        }
    }

    #[test]
    fn every_sign_of_a_range_is_read() {
        for (text, meant) in [
            ("9.98m-10.02m", "9.98m..10.02m"),
            ("30-32deg", "30..32deg"),
            ("0.5 – 0.7", "0.5 .. 0.7"),
            ("−0.1—0.7", "−0.1..0.7"),
            ("5'-6'", "5'..6'"),
            ("3m +- 2cm", "3m ± 2cm"),
        ] {
            assert_eq!(spelt_range(text), meant);
        }
    }
}
