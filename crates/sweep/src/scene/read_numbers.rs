//! Exact numbers of a scene: one, a list, or a range `{ from, to, steps }`.

use super::schema::MAX_ARCHES;
use super::value::{TomlReader, TomlValue};
use crate::arch::SelfWeight;
use crate::ask::{Field, Spelling, given_thickness};
use crate::number::{ExactNumber, Form, terminating};
use crate::problem::{Arch, Friction, Quantity};
use crate::report::words::shortened;
use rug::Rational;
use toml::de::{DeTable, DeValue};

/// Meaning of an exact number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    HalfOpening,
    Friction,
    FrictionAngle,
    Thickness,
}

/// The numbers of a key. A range is written out only when it is known not to be too much.
pub(super) enum Numbers {
    /// Numbers as they were given.
    Listed(Vec<SceneNumber>),
    /// `steps` numbers, each `step` above the one before.
    Range {
        meaning: Meaning,
        first: Rational,
        step: Rational,
        unit: (WrittenUnit, bool),
        steps: usize,
    },
}

impl Numbers {
    /// Number of values.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Listed(all) => all.len(),
            Self::Range { steps, .. } => *steps,
        }
    }

    /// All of them, if they can be written as numbers that are read.
    pub(super) fn all(self) -> Result<Vec<SceneNumber>, String> {
        match self {
            Self::Listed(all) => Ok(all),
            Self::Range { meaning, first, step, unit, steps } => {
                // The angle of a friction is written as a friction.
                let meaning = if unit.1 { Meaning::Friction } else { meaning };
                let number = |k| meaning.read(&text(&(Rational::from(&step * k) + &first), unit));
                (0..steps).map(number).collect()
            }
        }
    }
}

/// A number, or `inf`, as it was written.
#[derive(Clone)]
pub(super) struct SceneNumber {
    /// `None` is infinite.
    pub number: Option<ExactNumber>,
    /// True if the number is the angle of a friction.
    is_angle: bool,
    pub text: String,
}

impl SceneNumber {
    /// Text that every reader of such a number takes.
    pub(super) fn exact_text(self) -> String {
        if self.is_angle || self.number.is_none() { self.friction().to_string() } else { self.text }
    }

    /// The friction that it says.
    pub(super) fn friction(self) -> Friction {
        match self.number {
            None => Friction::Infinite,
            Some(phi) if self.is_angle => Friction::Angle(phi),
            Some(mu) => Friction::Coefficient(mu),
        }
    }
}

impl Meaning {
    /// Meaning of a field that is a number without a unit.
    pub(super) fn of(field: Field) -> Option<Self> {
        Some(match field {
            Field::HalfOpening => Self::HalfOpening,
            Field::Friction => Self::Friction,
            Field::FrictionAngle => Self::FrictionAngle,
            Field::Thickness => Self::Thickness,
            _ => return None,
        })
    }

    pub(super) fn quantity(self) -> Quantity {
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

    /// Description of what may be given.
    pub(super) fn allowed(self) -> &'static str {
        match self {
            Self::HalfOpening => "an angle (2.45, \"pi/2\", \"80deg\")",
            Self::Friction => "a coefficient (0.6, \"3/5\", \"inf\") or an angle (\"31deg\")",
            Self::FrictionAngle => "an angle (0.5, \"pi/6\", \"21deg\")",
            Self::Thickness => "a ratio of thickness to radius (0.12, \"3/25\")",
        }
    }

    /// Number of a text, in the range that an arch allows: refused with the sentence of every other door.
    fn read(self, text: &str) -> Result<SceneNumber, String> {
        fn said(error: impl ToString) -> String {
            error.to_string()
        }
        let is_possible = |alpha: Option<&ExactNumber>, friction: Friction| {
            let one = || ExactNumber::from(&Rational::from(1));
            let alpha = alpha.cloned().unwrap_or_else(one);
            Arch::new(SelfWeight::Milankovitch, alpha, friction).map(|_| ()).map_err(said)
        };
        let (number, is_angle) = match self {
            Self::HalfOpening => {
                let alpha = text.parse().map_err(said)?;
                is_possible(Some(&alpha), Friction::Infinite)?;
                (Some(alpha), false)
            }
            Self::Friction | Self::FrictionAngle => {
                let friction = match self {
                    Self::Friction => text.parse().map_err(said)?,
                    _ => Friction::Angle(text.parse().map_err(said)?),
                };
                is_possible(None, friction.clone())?;
                match friction {
                    Friction::Coefficient(mu) => (Some(mu), false),
                    Friction::Angle(phi) => (Some(phi), true),
                    Friction::Infinite => (None, false),
                }
            }
            Self::Thickness => {
                let eta = given_thickness(text, None, Spelling::Key);
                (Some(eta.map_err(|misfit| misfit.message)?), false)
            }
        };
        Ok(SceneNumber { number, is_angle, text: text.to_owned() })
    }
}

/// Unit in which a number is written; a range keeps that of its ends.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum WrittenUnit {
    One,
    Pi,
    Degrees,
}

/// The numbers of a key, each once. `None` if any is wrong.
pub(super) fn numbers(
    reader: &mut TomlReader,
    meaning: Meaning,
    value: &TomlValue,
) -> Option<Numbers> {
    if let DeValue::Table(table) = value.get_ref() {
        return range(reader, meaning, value, table);
    }
    let all = reader.each_once(meaning.key(), value, meaning.allowed(), |reader, element| {
        let given = number(reader, meaning, element)?;
        let number = given.number.as_ref().map(|x| (x.to_rational(), x.form()));
        Some(((given.is_angle, number), given))
    });
    all.map(Numbers::Listed)
}

/// One number, read from its text: `0.1` is one tenth with and without quotes.
fn number(reader: &mut TomlReader, meaning: Meaning, value: &TomlValue) -> Option<SceneNumber> {
    let (key, allowed) = (meaning.key(), meaning.allowed());
    let text = match value.get_ref() {
        DeValue::Integer(integer) if integer.radix() != 10 => None,
        _ => TomlReader::literal(value),
    };
    let Some(text) = text else { return reader.reject(key, value, allowed) };
    let read = meaning.read(text.strip_prefix('+').unwrap_or(text));
    read.map_err(|message| reader.fault(value.span(), message)).ok()
}

/// `{ from, to, steps }`: `steps` numbers at equal distances, both ends included.
fn range(
    reader: &mut TomlReader,
    meaning: Meaning,
    value: &TomlValue,
    table: &DeTable,
) -> Option<Numbers> {
    let before = reader.faults.len();
    if table.contains_key("boxes") {
        let message = format!(
            "{} is cut into boxes, which [[arches]] of a scene takes alone; give steps here",
            meaning.key()
        );
        return reader.refuse(value.span(), message);
    }
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
        return reader.refuse(value.span(), format!("{} has a range {why}", meaning.key()));
    };
    let (key, from, to) = (meaning.key(), shortened(&from.text), shortened(&to.text));
    if unit != unit_of_last {
        let same = match meaning {
            Meaning::Friction => "give two coefficients, or two angles in one unit",
            _ => "give both in radians, as multiples of pi, or in degrees",
        };
        let message = format!("{key} from {from} to {to} is in two units; {same}");
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

/// A number in the unit in which it is written, and whether it is the angle of a friction; none that is infinite or an
/// arctangent has a unit.
fn scaled(given: &SceneNumber) -> Option<(Rational, (WrittenUnit, bool))> {
    let number = given.number.as_ref()?;
    let factor = number.to_rational();
    let (factor, unit) = match number.form() {
        Form::TimesPi if number.is_in_degrees() => (factor * 180, WrittenUnit::Degrees),
        Form::TimesPi => (factor, WrittenUnit::Pi),
        Form::Rational => (factor, WrittenUnit::One),
        Form::TwiceArctangent | Form::ArctangentOfRoot => return None,
    };
    Some((factor, (unit, given.is_angle)))
}

/// Decimals up to this length are written as such, others as fractions.
const SHORT: usize = 30;

/// A number as a person would write it.
fn text(value: &Rational, (unit, is_angle): (WrittenUnit, bool)) -> String {
    let plain = || match terminating(value, SHORT) {
        Some(decimal) => decimal.to_string(),
        None => value.to_string(),
    };
    let text = match unit {
        WrittenUnit::One => plain(),
        WrittenUnit::Degrees => format!("{}deg", plain()),
        WrittenUnit::Pi => match (*value.numer() == 1, *value.denom() == 1) {
            (true, true) => "pi".to_owned(),
            (true, false) => format!("pi/{}", value.denom()),
            (false, true) => format!("{}pi", value.numer()),
            (false, false) => format!("{}pi/{}", value.numer(), value.denom()),
        },
    };
    if is_angle { format!("tan({text})") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_a_range_is_what_its_text_says() {
        let (alpha, mu) = ((Meaning::HalfOpening, false), (Meaning::Friction, true));
        for (value, unit, written, meanings) in [
            ((3, 20), WrittenUnit::One, "0.15", &[alpha, mu][..]),
            ((1, 3), WrittenUnit::One, "1/3", &[alpha, mu]),
            ((1, 2), WrittenUnit::Pi, "pi/2", &[alpha, mu]),
            ((1, 1), WrittenUnit::Pi, "pi", &[]),
            ((5, 6), WrittenUnit::Pi, "5pi/6", &[alpha]),
            ((245, 2), WrittenUnit::Degrees, "122.5deg", &[alpha]),
        ] {
            let value = Rational::from(value);
            assert_eq!(text(&value, (unit, false)), written);
            for &(meaning, is_angle) in meanings {
                let read = meaning.read(&text(&value, (unit, is_angle))).unwrap();
                assert!(scaled(&read) == Some((value.clone(), (unit, is_angle))), "{written}");
            }
        }
    }
}
