//! Words and numbers as every format writes them.

use crate::arch::SelfWeight;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::state::{Fall, Figure};
use crate::problem::asymmetric_region::{LOOK, MAY_MOVE};
use crate::problem::stones::Stones;
use crate::problem::{Landmark, Mode, Quantity};
use couplet_stones::MOST_ENUMERATED_STONES;
use std::borrow::Cow;
use std::fmt::Display;
use std::io;

pub use crate::number::shown as shortened;

/// With this many digits a decimal number tells the double, which is then given too.
pub const DOUBLE_DIGITS: usize = 17;

/// `1 arch`, `2 arches`.
pub fn count<N: Display + PartialEq + From<u8>>(n: N, one: &str, many: &str) -> String {
    let noun = if n == N::from(1) { one } else { many };
    format!("{n} {noun}")
}

/// Writes several, with an empty line between.
pub fn apart<T>(
    all: impl IntoIterator<Item = T>,
    out: &mut dyn io::Write,
    one: impl Fn(T, &mut dyn io::Write) -> io::Result<()>,
) -> io::Result<()> {
    all.into_iter().enumerate().try_for_each(|(index, item)| {
        if index > 0 {
            writeln!(out)?;
        }
        one(item, out)
    })
}

/// A kind of asymmetric mechanism in words.
pub fn kind(mode: AsymmetricMode) -> &'static str {
    match mode {
        AsymmetricMode::InnerSliding => "one shoulder slides out, a joint of the other half in",
        AsymmetricMode::ShoulderOpening => "one shoulder slides and opens",
        AsymmetricMode::ShoulderSliding => "one shoulder slides",
    }
}

/// Names in a sentence: `a, b, c`.
pub fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    names.into_iter().collect::<Vec<_>>().join(", ")
}

/// The first names of many in a sentence, and how many more there are: `a, b, c and 290 more`.
pub fn first_of(names: &[String], most: usize) -> String {
    let first = list(names.iter().take(most).map(String::as_str));
    match names.len().checked_sub(most) {
        None | Some(0) => first,
        Some(more) => format!("{first} and {more} more"),
    }
}

/// Labels of modes.
pub fn labels(modes: &[Mode]) -> Vec<&'static str> {
    modes.iter().map(|mode| mode.label()).collect()
}

/// Text with blanks behind it, up to a width: that of a format ends at 65,535, and a number may have a million digits.
pub fn padded(text: &str, width: usize) -> String {
    let blanks = width.saturating_sub(text.chars().count());
    [text, &" ".repeat(blanks)].concat()
}

/// Rows of cells as lines, each column as wide as its longest cell.
pub fn aligned(rows: &[Vec<String>]) -> impl Iterator<Item = String> {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    rows.iter().map(move |row| {
        let cells = row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    })
}

/// Items each once, in the order in which they come.
pub fn distinct<T: PartialEq>(all: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for one in all {
        if !found.contains(&one) {
            found.push(one);
        }
    }
    found
}

/// Minimum similarity of a suggestion.
const ALIKE: f64 = 0.75;

/// ` (did you mean "…"?)`, if one of the names is close to what was written, or is that of a letter of the paper.
pub fn did_you_mean(written: &str, names: &[&str]) -> String {
    let mut lettered = Quantity::LANDMARK.into_iter().filter(|of| of.letter() == Some(written));
    let symbol = lettered.next().map(Quantity::name);
    let alike = |name: &str| strsim::jaro_winkler(&written.to_lowercase(), &name.to_lowercase());
    let nearest = names
        .iter()
        .map(|name| (alike(name), *name))
        .filter(|(alike, _)| *alike >= ALIKE)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name);
    symbol
        .filter(|name| names.contains(name))
        .or(nearest)
        .map_or(String::new(), |name| format!(" (did you mean \"{name}\"?)"))
}

/// Sentence on what an arch that stands may do all the same, if anything is proved of that: the one sentence
/// of all formats.
pub fn may_move(thicknesses: &[Figure]) -> Option<String> {
    let at: Vec<String> = thicknesses.iter().map(ToString::to_string).collect();
    let noun = if at.len() == 1 { "thickness" } else { "thicknesses" };
    let at = at.join(" and ");
    let words = format!("asymmetric mechanism, proved, at the {noun} {at}: {MAY_MOVE} ({LOOK})");
    (!thicknesses.is_empty()).then_some(words)
}

/// Sentence on stones and limited friction, of which it depends on their number; with the command that looks for such a
/// motion, between as many as it does.
pub fn stones_may_move(stones: &Stones) -> String {
    match stones {
        Stones::Equal { stones, .. } if *stones > MOST_ENUMERATED_STONES => MAY_MOVE.to_owned(),
        Stones::Equal { stones, .. } => format!("{MAY_MOVE} ({LOOK} --stones {stones})"),
        Stones::Joints(_) => format!("{MAY_MOVE} ({LOOK})"),
    }
}

/// Whose self-weight model it is.
pub fn author(weight: SelfWeight) -> &'static str {
    match weight {
        SelfWeight::Heyman => "Heyman",
        SelfWeight::Milankovitch => "Milankovitch",
    }
}

/// The self-weight model in words.
pub fn model(weight: SelfWeight) -> String {
    format!("{}-like self-weight", author(weight))
}

/// The symbol of a landmark in a picture: in its font the letter l is a bar.
pub fn symbol(landmark: Landmark) -> &'static str {
    if landmark == Landmark::RotationEnd { "ℓ" } else { landmark.symbol() }
}

/// The word for why an arch does not stand.
pub fn reason(fall: Fall) -> &'static str {
    match fall {
        Fall::Sliding => "sliding",
        Fall::Thickness => "thickness",
    }
}

/// A double as C and many others write it in hexadecimal: exact. Infinity is `inf`, as `printf` has it.
pub fn hexadecimal(x: f64) -> String {
    if x.is_infinite() {
        return x.to_string();
    }
    if x == 0.0 {
        return "0x0p+0".to_owned();
    }
    let (bits, sign) = (x.to_bits(), if x < 0.0 { "-" } else { "" });
    let (mut exponent, mut mantissa) = ((bits >> 52 & 0x7ff) as i64 - 1023, bits & ((1 << 52) - 1));
    if exponent == -1023 {
        // Subnormal: the leading one is moved to the front.
        let shift = mantissa.leading_zeros() - 11;
        mantissa = (mantissa << shift) & ((1 << 52) - 1);
        exponent = -1022 - i64::from(shift);
    }
    let digits = format!("{mantissa:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x1{point}{digits}p{exponent:+}")
}

/// A text of other people with what is no text as an escape, for a terminal would obey it: control characters but tabs
/// and ends of lines, and marks that turn what follows round. `escape` says how one is written.
pub fn printable(text: &str, escape: impl Fn(char) -> String) -> Cow<'_, str> {
    let is_text = |c: char| {
        let turns = matches!(c, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        matches!(c, '\t' | '\n' | '\r') || !c.is_control() && !turns
    };
    let is_plain = |byte| matches!(byte, b' '..=b'~' | b'\t' | b'\n' | b'\r');
    if text.bytes().all(is_plain) || text.chars().all(is_text) {
        return text.into();
    }
    text.chars().map(|c| if is_text(c) { c.to_string() } else { escape(c) }).collect()
}

/// Description of how an arch is divided into stones.
pub fn division(stones: &Stones) -> String {
    match stones {
        Stones::Equal { stones, .. } => format!("{stones} equal stones"),
        Stones::Joints(angles) => {
            let angles: Vec<String> = angles.iter().map(ToString::to_string).collect();
            format!("joints at {}", angles.join(", "))
        }
    }
}

/// Words with a capital at its beginning.
pub fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hexadecimal_doubles_are_exact() {
        for (x, text) in [
            (1.0, "0x1p+0"),
            (0.1, "0x1.999999999999ap-4"),
            (-2.5, "-0x1.4p+1"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (5e-324, "0x1p-1074"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(hexadecimal(x), text);
        }
    }
    #[test]
    fn the_nearest_name_is_offered_if_one_is_near() {
        let names = ["half_opening", "friction", "friction_angle"];
        assert_eq!(did_you_mean("half_openning", &names), " (did you mean \"half_opening\"?)");
        assert_eq!(did_you_mean("mu", &names), " (did you mean \"friction\"?)");
        assert_eq!(did_you_mean("colour", &names), "");
        assert_eq!(did_you_mean("eta", &names), "", "not a key here");
    }

    #[test]
    fn a_width_has_no_limit() {
        assert_eq!(padded("ab", 4), "ab  ");
        assert_eq!(padded("abc", 2), "abc");
        assert_eq!(padded("a", 70_000).len(), 70_000);
    }
}
