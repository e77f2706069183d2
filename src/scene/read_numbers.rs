//! Exact numbers of a scene: one, a list, or a range `{ from, to, steps }`.

use super::schema::MAX_ARCHES;
use super::value::{Reader, Value};
use crate::arch::SelfWeight;
use crate::number::{ExactNumber, Form, ParseExactError, terminating};
use crate::problem::{Arch, ArchError, Friction, Quantity, is_thickness};
use crate::report::words::shortened;
use rug::Rational;
use std::collections::HashMap;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// What an exact number is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    HalfOpening,
    Friction,
    FrictionAngle,
    Thickness,
}

/// The numbers of a key. A range is written out only when it is known not to be too much.
pub(super) enum Numbers {
    /// As they were given.
    Listed(Vec<SceneNumber>),
    /// `steps` numbers, each `step` above the one before.
    Range { meaning: Meaning, first: Rational, step: Rational, unit: Unit, steps: usize },
}

impl Numbers {
    /// How many there are.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Listed(all) => all.len(),
            Self::Range { steps, .. } => *steps,
        }
    }

    /// All of them, if they can be written as numbers that are read.
    pub(super) fn all(self) -> Result<Vec<SceneNumber>, ParseExactError> {
        match self {
            Self::Listed(all) => Ok(all),
            Self::Range { meaning, first, step, unit, steps } => (0..steps)
                .map(|k| {
                    let text = text(&(Rational::from(&step * k) + &first), unit);
                    Ok(SceneNumber { number: meaning.parse(&text)?, text })
                })
                .collect(),
        }
    }
}

/// A number, or `inf`, as it was written.
#[derive(Clone)]
pub(super) struct SceneNumber {
    /// `None` is infinite.
    pub number: Option<ExactNumber>,
    pub text: String,
}

impl Meaning {
    fn quantity(self) -> Quantity {
        match self {
            Self::HalfOpening => Quantity::HalfOpening,
            Self::Friction => Quantity::Friction,
            Self::FrictionAngle => Quantity::FrictionAngle,
            Self::Thickness => Quantity::Thickness,
        }
    }

    pub(super) fn key(self) -> &'static str {
        self.quantity().name()
    }

    /// What a table says of it, under its name or its letter.
    pub(super) fn given<'v, 's>(
        self,
        reader: &mut Reader,
        table: &'v DeTable<'s>,
    ) -> Option<&'v Value<'s>> {
        let named = table.get(self.key());
        let letter = self.quantity().letter();
        let Some((letter, value)) = letter.and_then(|letter| Some((letter, table.get(letter)?)))
        else {
            return named;
        };
        if named.is_some() {
            let key = self.key();
            reader.fault(value.span(), format!("both {key} and {letter}; give one of them"));
        }
        named.or(Some(value))
    }

    /// What may be given.
    pub(super) fn allowed(self) -> &'static str {
        match self {
            Self::HalfOpening => "an angle (2.45, \"pi/2\", \"80deg\")",
            Self::Friction => "a coefficient (0.6, \"3/5\", \"inf\")",
            Self::FrictionAngle => "an angle (0.5, \"pi/6\", \"21deg\")",
            Self::Thickness => "a ratio of thickness to radius (0.12, \"3/25\")",
        }
    }

    fn parse(self, text: &str) -> Result<Option<ExactNumber>, ParseExactError> {
        match self {
            Self::Friction => match text.parse()? {
                Friction::Coefficient(mu) => Ok(Some(mu)),
                Friction::Infinite => Ok(None),
                Friction::Angle(_) => Err(ParseExactError::Syntax(text.to_owned())),
            },
            _ => text.parse().map(Some),
        }
    }

    /// The range that a number is not in, if it is not.
    fn outside(self, number: &ExactNumber) -> Option<&'static str> {
        let weight = SelfWeight::Milankovitch;
        let one = || ExactNumber::from(&Rational::from(1));
        let made = match self {
            Self::HalfOpening => Arch::new(weight, number.clone(), Friction::Infinite),
            Self::Friction => Arch::new(weight, one(), Friction::Coefficient(number.clone())),
            Self::FrictionAngle => Arch::new(weight, one(), Friction::Angle(number.clone())),
            // Between 0 and 2 too, but no ratio.
            Self::Thickness if !number.is_rational() => return Some(self.allowed()),
            Self::Thickness => {
                return (!is_thickness(number)).then_some("between 0 and 2");
            }
        };
        made.err().map(|error| match error {
            ArchError::HalfOpening(_) => "between 0 and pi (180deg)",
            ArchError::Friction(_) => "0 or more",
            ArchError::FrictionAngle(_) => "between 0 and pi/2 (90deg)",
            _ => self.allowed(),
        })
    }
}

/// Unit in which a number is written; a range keeps that of its ends.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    One,
    Pi,
    Degrees,
}

/// The numbers of a key, each once. `None` if any is wrong.
pub(super) fn numbers(reader: &mut Reader, meaning: Meaning, value: &Value) -> Option<Numbers> {
    if let DeValue::Table(table) = value.get_ref() {
        return range(reader, meaning, value, table);
    }
    let before = reader.faults.len();
    let mut found: Vec<SceneNumber> = Vec::new();
    let mut seen: HashMap<Option<(Rational, Form)>, Range<usize>> = HashMap::new();
    for element in reader.elements(meaning.key(), value, meaning.allowed()) {
        let Some(given) = number(reader, meaning, element) else { continue };
        let number = given.number.as_ref().map(|x| (x.to_rational(), x.form()));
        if let Some(first) = seen.insert(number, element.span()) {
            let (text, at) =
                (reader.source.shown(element.span()), reader.source.place(first.start));
            let message = format!(
                "{} {text} is listed twice, first in line {}, column {}",
                meaning.key(),
                at.line,
                at.column
            );
            reader.fault(element.span(), message);
        }
        found.push(given);
    }
    (reader.faults.len() == before).then_some(Numbers::Listed(found))
}

/// One number, read from its text: `0.1` is one tenth with and without quotes.
fn number(reader: &mut Reader, meaning: Meaning, value: &Value) -> Option<SceneNumber> {
    let text = match value.get_ref() {
        DeValue::String(text) => text.as_ref(),
        DeValue::Float(float) => float.as_str(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str(),
        _ => {
            reader.is_not(meaning.key(), value, meaning.allowed());
            return None;
        }
    };
    let text = text.strip_prefix('+').unwrap_or(text);
    match meaning.parse(text) {
        Ok(number) => {
            if let Some(range) = number.as_ref().and_then(|number| meaning.outside(number)) {
                reader.is_not(meaning.key(), value, range);
                return None;
            }
            Some(SceneNumber { number, text: text.to_owned() })
        }
        Err(ParseExactError::Syntax(_) | ParseExactError::Friction(_)) => {
            reader.is_not(meaning.key(), value, meaning.allowed());
            None
        }
        Err(error) => {
            reader.fault(value.span(), format!("{}: {error}", meaning.key()));
            None
        }
    }
}

/// `{ from, to, steps }`: `steps` numbers at equal distances, both ends included.
fn range(reader: &mut Reader, meaning: Meaning, value: &Value, table: &DeTable) -> Option<Numbers> {
    let before = reader.faults.len();
    reader.unknown_keys(table, "a range", &["from", "to", "steps"], &[]);
    for key in ["from", "to", "steps"].iter().filter(|key| !table.contains_key(**key)) {
        let message =
            format!("{} has no {key}; a range is {{ from = …, to = …, steps = … }}", meaning.key());
        reader.fault(value.span(), message);
    }
    let ends = ["from", "to"].map(|key| number(reader, meaning, table.get(key)?));
    let steps = table.get("steps").and_then(|steps| reader.whole("steps", steps, 2..=MAX_ARCHES));
    let [Some(from), Some(to)] = ends else { return None };
    let (Some((first, unit)), Some((last, unit_of_last))) = (scaled(&from), scaled(&to)) else {
        let has_end = [&from, &to].iter().all(|end| end.number.is_some());
        let why = if has_end { "of arctangents, which has no steps" } else { "without end" };
        let message = format!("{} has a range {why}", meaning.key());
        reader.fault(value.span(), message);
        return None;
    };
    let (key, from, to) = (meaning.key(), shortened(&from.text), shortened(&to.text));
    if unit != unit_of_last {
        let message = format!(
            "{key} from {from} to {to} is in two units; give both in radians, as multiples of pi, or \
             in degrees"
        );
        reader.fault(value.span(), message);
    } else if first >= last {
        reader.fault(
            value.span(),
            format!("{key} from {from} to {to} does not rise; give the smaller first"),
        );
    }
    let steps = steps?;
    if reader.faults.len() > before {
        return None;
    }
    let step = (last - &first) / Rational::from(steps - 1);
    Some(Numbers::Range { meaning, first, step, unit, steps })
}

/// A number in the unit in which it is written; none that is infinite or an arctangent has one.
fn scaled(given: &SceneNumber) -> Option<(Rational, Unit)> {
    let number = given.number.as_ref()?;
    let factor = number.to_rational();
    match number.form() {
        Form::TimesPi if number.is_in_degrees() => Some((factor * 180, Unit::Degrees)),
        Form::TimesPi => Some((factor, Unit::Pi)),
        Form::Rational => Some((factor, Unit::One)),
        Form::TwiceArctangent => None,
    }
}

/// Decimals up to this length are written as such, others as fractions.
const SHORT: usize = 30;

/// A number as a person would write it.
fn text(value: &Rational, unit: Unit) -> String {
    let plain = || match terminating(value, SHORT) {
        Some(decimal) => decimal.to_string(),
        None => value.to_string(),
    };
    match unit {
        Unit::One => plain(),
        Unit::Degrees => format!("{}deg", plain()),
        Unit::Pi => match (*value.numer() == 1, *value.denom() == 1) {
            (true, true) => "pi".to_owned(),
            (true, false) => format!("pi/{}", value.denom()),
            (false, true) => format!("{}pi", value.numer()),
            (false, false) => format!("{}pi/{}", value.numer(), value.denom()),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_a_range_is_what_its_text_says() {
        for (value, unit, written) in [
            ((3, 20), Unit::One, "0.15"),
            ((1, 3), Unit::One, "1/3"),
            ((1, 2), Unit::Pi, "pi/2"),
            ((1, 1), Unit::Pi, "pi"),
            ((5, 6), Unit::Pi, "5pi/6"),
            ((245, 2), Unit::Degrees, "122.5deg"),
        ] {
            let value = Rational::from(value);
            assert_eq!(text(&value, unit), written);
            let number = written.parse::<ExactNumber>().unwrap();
            let read =
                scaled(&SceneNumber { number: Some(number), text: written.to_owned() }).unwrap();
            assert!(read.0 == value && read.1 == unit, "{written}");
        }
    }
}
