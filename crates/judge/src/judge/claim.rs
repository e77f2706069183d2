//! Content of a row of results.

use super::possible::Possible;
use super::printed::PrintedNumber;
use crate::certify::Refused;
use crate::number::{Decimal, ExactNumber, says, shown as short};
use crate::problem::{Mode, Quantity};

/// Statement of a row on an arch.
#[derive(Clone, Debug)]
pub struct RowClaim {
    /// True if the arch can stand at some thickness; `None` if the row does not say.
    pub can_stand: Option<bool>,
    /// The thickness that the arch has, if it has one, in `(0, 2]`.
    pub thickness: Option<ExactNumber>,
    /// True if the arch stands at that thickness; `None` if the row does not say.
    pub stands: Option<bool>,
    /// Mode of its collapse.
    pub mode: Option<Mode>,
    /// Numbers of the row.
    pub numbers: Vec<Claimed>,
}

/// A number that is claimed.
#[derive(Clone, Debug)]
pub struct Claimed {
    /// Quantity that is claimed.
    pub quantity: Quantity,
    /// Number as it is written.
    pub text: String,
    /// True if the number is an angle in degrees.
    pub degrees: bool,
    pub(super) value: Possible<PrintedNumber>,
    /// The power of ten next to it, of either sign; none for zero.
    pub(super) size: u64,
}

/// The text of a row, by column; a column that the file does not have is `None`.
#[derive(Clone, Debug, Default)]
pub struct Said<'a> {
    /// Text on whether the arch can stand at some thickness.
    pub can_stand: Option<&'a str>,
    /// The thickness that it has.
    pub thickness: Option<ExactNumber>,
    /// Text on whether the arch stands at that thickness; without one, the same as `can_stand`.
    pub stands: Option<&'a str>,
    /// The mode.
    pub mode: Option<&'a str>,
    /// The numbers, and whether they are angles in degrees.
    pub numbers: Vec<(Quantity, &'a str, bool)>,
}

/// Reason why a row says nothing that can be judged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ClaimError {
    /// Neither yes nor no.
    Stands(String),
    /// The text is not the letters of a mode.
    Mode(String),
    /// The text is not a decimal number.
    Number(&'static str, String),
    /// Too long or too far from one to be meant.
    Range(&'static str, String),
    /// The thickness that it has is none.
    Thickness(Refused),
    /// One column says that the arch stands, another that it falls.
    Contradiction(&'static str, &'static str),
}

says!(ClaimError {
    Self::Stands(text) =>
        "'{text}' does not say whether the arch stands: true, yes, 1, stands or false, no, 0, falls";
    Self::Mode(text) =>
        "'{text}' is not a mode: [r,r,r], [s,r,r], [r,r,s], [r,s,r], [r,s], [r] or [s,s], with or without \
         brackets and commas";
    Self::Number(name, text) =>
        "the {name} '{text}' is not a decimal number, nor empty, nan, inf, none or falls";
    Self::Range(name, text) =>
        "the {name} '{text}' is out of range: at most {MAX_DIGITS} digits, from 1e-{MAX_SIZE} to 1e{MAX_SIZE}";
    Self::Contradiction(one, other) =>
        "the {one} says that the arch stands, the {other} that it falls";
} from {
    Refused => Self::Thickness;
});

/// Digits of a claim; more are not printed by anybody, and cost a long time.
const MAX_DIGITS: usize = 10_000;
/// Powers of ten; the thickness of the smallest half opening that is read is above.
const MAX_SIZE: u64 = 5_000;

/// Digits with which a certified value is shown at least, and beyond the digits of the claim.
const SHOWN: usize = 17;
const BEYOND: usize = 3;

/// Words for "there is no solution".
const NOTHING: [&str; 11] =
    ["nan", "-nan", "inf", "+inf", "-inf", "infinity", "none", "null", "falls", "-", "n/a"];

fn is_word(text: &str, words: &[&str]) -> bool {
    words.iter().any(|word| text.eq_ignore_ascii_case(word))
}

impl RowClaim {
    /// Reads what a row says.
    ///
    /// `can_stand`, the least thickness or the mode claim that there is no solution: by one of the words for
    /// it, by an empty least thickness where no column says whether the arch stands, or by the mode `[s,s]`
    /// alone. Any other empty field claims nothing.
    pub fn read(said: &Said) -> Result<Self, ClaimError> {
        said.thickness.as_ref().map_or(Ok(()), Refused::thickness)?;
        let numbers: Vec<Claimed> = said
            .numbers
            .iter()
            // What our own rows leave open claims nothing.
            .filter(|(_, text, _)| !text.is_empty() && !text.eq_ignore_ascii_case("undecided"))
            .map(|&(quantity, text, degrees)| Claimed::read(quantity, text, degrees))
            .collect::<Result<_, _>>()?;
        let no_mode = |text: &&str| is_word(text, &NOTHING);
        let mode = match said.mode.filter(|text| !text.is_empty() && !no_mode(text)) {
            Some(text) => Some(Mode::named(text).ok_or_else(|| ClaimError::Mode(short(text)))?),
            None => None,
        };
        let stands = said.stands.map(yes_or_no).transpose()?.flatten();
        let can_stand = said.can_stand.map(yes_or_no).transpose()?.flatten();
        let mut votes: Vec<(&'static str, bool)> = Vec::new();
        votes.extend(can_stand.map(|vote| ("column can_stand", vote)));
        // An arch that falls at the thickness that it has may stand at another.
        let here = stands.filter(|stands| *stands || said.thickness.is_none());
        votes.extend(here.map(|vote| ("column stands", vote)));
        let least = |quantity| matches!(quantity, Quantity::Thickness | Quantity::LeastThickness);
        let has_least = said.numbers.iter().any(|(quantity, ..)| least(*quantity));
        match numbers.iter().find(|number| least(number.quantity)) {
            Some(number) => {
                votes.push(("thickness", number.value.finite().is_some()));
            }
            None if has_least && said.stands.is_none() && said.can_stand.is_none() => {
                votes.push(("thickness", false));
            }
            None => {}
        }
        match (mode, said.mode) {
            (Some(Mode::Sliding), _) => {}
            (Some(_), _) => votes.push(("mode", true)),
            (None, Some(text)) if no_mode(&text) => votes.push(("mode", false)),
            (None, _) => {}
        }
        let who = |stands| votes.iter().find(|(_, vote)| *vote == stands).map(|(name, _)| *name);
        let any_number = || {
            let is_one = |number: &Claimed| number.value.finite().is_some();
            numbers.iter().any(|number| is_one(number) && !number.is_of_half_opening())
        };
        let can_stand = match (who(true), who(false)) {
            (Some(yes), Some(no)) => return Err(ClaimError::Contradiction(yes, no)),
            (Some(_), None) => Some(true),
            (None, Some(_)) => Some(false),
            // Where the joints slide whatever the thickness, nothing stands.
            (None, None) if mode.is_some() => Some(false),
            (None, None) if said.thickness.is_some() => None,
            (None, None) => any_number().then_some(true),
        };
        let thickness = said.thickness.clone();
        let stands = stands.filter(|_| thickness.is_some());
        Ok(Self { can_stand, thickness, stands, mode, numbers })
    }

    /// Tells whether the row says nothing.
    pub(super) fn is_empty(&self) -> bool {
        let Self { can_stand, thickness, stands, numbers, .. } = self;
        let of_opening = numbers.iter().any(Claimed::is_of_half_opening);
        let says_nothing = numbers.is_empty() || (thickness.is_none() && !of_opening);
        can_stand.is_none() && stands.is_none() && says_nothing
    }
}

/// Reads whether a text says yes or no; an empty one says nothing.
fn yes_or_no(text: &str) -> Result<Option<bool>, ClaimError> {
    match text {
        "" => Ok(None),
        yes if is_word(yes, &["true", "yes", "1", "stands"]) => Ok(Some(true)),
        no if is_word(no, &["false", "no", "0", "falls"]) => Ok(Some(false)),
        other => Err(ClaimError::Stands(short(other))),
    }
}

impl RowClaim {
    /// Digits of the truth with which the claim is compared at first.
    pub(super) fn digits(&self) -> usize {
        self.numbers.iter().map(Claimed::compared_digits).max().unwrap_or(1)
    }

    /// Tells whether it speaks of the frictions at which the mode changes, or of those of a thickness.
    pub(super) fn tells_frictions(&self) -> bool {
        self.numbers.iter().any(|number| number.quantity.is_friction())
    }
}

impl Claimed {
    fn read(quantity: Quantity, text: &str, degrees: bool) -> Result<Self, ClaimError> {
        let infinite = ["inf", "+inf", "infinity"];
        let mut size = 0;
        let may_be_infinite =
            [Quantity::RotationalFriction, Quantity::LargestThrust, Quantity::FrictionSafety];
        let value = if may_be_infinite.contains(&quantity) && is_word(text, &infinite) {
            Possible::Infinite
        } else if let Some(number) = PrintedNumber::from_hexadecimal(text) {
            Possible::Finite(number)
        } else if is_word(text, &NOTHING) {
            Possible::Missing
        } else {
            let range = || ClaimError::Range(quantity.name(), short(text));
            let decimal: Decimal = match text.parse() {
                Ok(decimal) => decimal,
                Err(crate::number::ParseDecimalError::Exponent(_)) => return Err(range()),
                Err(_) => return Err(ClaimError::Number(quantity.name(), short(text))),
            };
            if !decimal.digits().is_empty() {
                size = decimal.magnitude().unsigned_abs();
            }
            let in_range = size <= MAX_SIZE
                && decimal.exponent().unsigned_abs() <= MAX_SIZE + MAX_DIGITS as u64
                && decimal.significant_digits() <= MAX_DIGITS;
            if !in_range {
                return Err(range());
            }
            Possible::Finite(PrintedNumber::from_decimal(&decimal).ok_or_else(range)?)
        };
        Ok(Self { quantity, text: text.to_owned(), degrees, value, size })
    }

    /// Tells whether the quantity belongs to the half opening, whatever the arch does: the friction below
    /// which nothing stands.
    fn is_of_half_opening(&self) -> bool {
        self.quantity == Quantity::SlidingFriction
    }

    /// Significant digits as written; none for zero.
    fn significant_digits(&self) -> usize {
        let number = self.value.finite().filter(|number| !number.value.is_zero());
        number.map_or(0, |number| number.digits)
    }

    /// Digits that the certified value beside it has.
    pub(super) fn shown_digits(&self) -> usize {
        SHOWN.max(self.significant_digits() + BEYOND)
    }

    /// Digits of the truth with which it is compared at first. For absurdly large or small claims the relative error is
    /// so close to a round number that extra digits are needed.
    fn compared_digits(&self) -> usize {
        const ORDINARY: u64 = 100;
        self.shown_digits() + if self.size > ORDINARY { self.size as usize } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(stands: Option<&str>, mode: Option<&str>, thickness: Option<&str>) -> Option<bool> {
        let numbers =
            thickness.map(|text| (Quantity::Thickness, text, false)).into_iter().collect();
        RowClaim::read(&Said { stands, mode, numbers, ..Said::default() }).unwrap().can_stand
    }

    #[test]
    fn what_stands_and_what_falls() {
        for nothing in ["", "NaN", "-nan", "inf", "None", "falls"] {
            assert_eq!(read(None, None, Some(nothing)), Some(false), "{nothing}");
        }
        assert_eq!(read(None, None, Some("0.1")), Some(true));
        assert_eq!(read(Some("FALSE"), None, Some("")), Some(false));
        assert_eq!(read(Some("true"), None, Some("")), Some(true));
        assert_eq!(read(Some(""), None, Some("")), None, "nothing is said");
        assert_eq!(read(Some("true"), None, Some("undecided")), Some(true), "nor here");
        assert_eq!(read(None, Some("s,s"), None), Some(false));
        assert_eq!(read(None, Some("s,s"), Some("0.1")), Some(true));
        assert_eq!(read(None, Some("none"), None), Some(false));
        assert_eq!(read(None, Some(""), None), None);
    }

    #[test]
    fn a_mode_is_known_by_its_letters() {
        for text in ["[r,r,s]", "rrs", "R-R-S", "( r, r, s )"] {
            assert_eq!(Mode::named(text), Some(Mode::RotationalSliding), "{text}");
        }
        for text in ["", "[]", "rr", "rrrr", "rotational", "s,s,s"] {
            assert_eq!(Mode::named(text), None, "{text}");
        }
    }

    #[test]
    fn what_makes_no_sense_is_told() {
        let error = |stands, mode, thickness: &str| {
            let numbers = vec![(Quantity::Thickness, thickness, false)];
            RowClaim::read(&Said { stands, mode, numbers, ..Said::default() }).unwrap_err()
        };
        assert!(matches!(error(Some("false"), None, "0.1"), ClaimError::Contradiction(..)));
        assert!(matches!(error(None, Some("rrr"), "nan"), ClaimError::Contradiction(..)));
        assert!(matches!(error(Some("perhaps"), None, "1"), ClaimError::Stands(_)));
        assert!(matches!(error(None, Some("x"), "1"), ClaimError::Mode(_)));
        assert!(matches!(error(None, None, "0,1"), ClaimError::Number(..)));
        for far in ["1e-999999999", "1e99999", "1e-99999999999999999999"] {
            assert!(matches!(error(None, None, far), ClaimError::Range(..)), "{far}");
        }
        let long = format!("0.{}", "1".repeat(10_001));
        assert!(matches!(error(None, None, &long), ClaimError::Range(..)));
    }
}
