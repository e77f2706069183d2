//! The question as it is understood: what is given, in the words of who asks and in the paper's units.

use super::numbers::{decided, in_digits};
use super::record::Record;
use super::value::Value;
use super::words::model;
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchGiven, Field, Range, SurveyGiven, notes};
use crate::number::{Ball, Drawable, ExactNumber, arctangent, degrees};
use crate::problem::measures::{Circle, LengthUnit};
use crate::problem::{Friction, Quantity};

/// Bits in which a given value is shown in other units.
const BITS: u32 = 192;
/// Digits of such a value.
const DIGITS: usize = 6;
/// Fields as they are said one after the other; the circle is said with what is measured there.
const SAID: [Field; 12] = [
    Field::Span,
    Field::Rise,
    Field::Radius,
    Field::HalfOpening,
    Field::Stones,
    Field::Joints,
    Field::Thickness,
    Field::Friction,
    Field::FrictionAngle,
    Field::Tilt,
    Field::Density,
    Field::Depth,
];

/// Arch as it is understood, beside the text of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Understood {
    given: Vec<(Field, String)>,
    words: String,
    note: Option<String>,
}

impl Understood {
    /// The question of these texts, which were read as `given`.
    pub fn new(asked: &ArchAsked, given: &ArchGiven) -> Self {
        let alpha = given.half_opening.as_ref().map(in_degrees);
        let arc = given.measures.as_ref().zip(alpha).map(|(measures, alpha)| {
            (measures.circle(), decided(&alpha, DIGITS).map(|alpha| format!("{alpha} deg")))
        });
        Self::of(asked, &arc, given.notes(), |of, text| in_words(of, text, given))
    }

    /// The question of these texts, some of which are ranges, which were read as `given`.
    pub fn of_ranges(asked: &ArchAsked, given: &SurveyGiven) -> Self {
        let alphas = given.half_opening().map(|alpha| decided(&in_degrees(&alpha), DIGITS));
        let alphas = match alphas {
            [Some(narrow), Some(wide)] if narrow == wide => Some(format!("{narrow} deg")),
            [Some(narrow), Some(wide)] => Some(format!("{narrow} to {wide} deg")),
            _ => None,
        };
        let arc = given.sizes.as_ref().map(|[of, _]| (of.circle(), alphas));
        Self::of(asked, &arc, notes(&given.friction), in_words_of_range)
    }

    /// The question of these texts, each in its words, with the circle and the half opening of an arc.
    fn of(
        asked: &ArchAsked,
        arc: &Option<(Circle, Option<String>)>,
        notes: Vec<String>,
        words: impl Fn(Field, &str) -> String,
    ) -> Self {
        let text = |field| Some((field, asked.get(field)?.trim()));
        let words = |(of, text)| words(of, text) + &in_arc(of, asked, arc);
        let words: Vec<String> = SAID.into_iter().filter_map(text).map(words).collect();
        let texts = Field::ALL.iter().copied().filter_map(text);
        let given = texts.map(|(field, text)| (field, text.to_owned())).collect();
        Self { words: words.join(", "), given, note: joined(notes) }
    }

    /// Words without the self-weight: `half opening 80deg = 1.39626 rad, friction 0.6 = 30.9638 deg`. What stands
    /// behind an equals sign is correctly rounded to six digits.
    pub fn in_words(&self) -> &str {
        &self.words
    }

    /// Words with the self-weight, which is the only load.
    pub fn with_weight(&self, weight: SelfWeight) -> String {
        format!("{}, {} alone", self.words, model(weight))
    }

    /// A given value as it was written.
    pub(crate) fn text(&self, of: Field) -> Option<&str> {
        self.given.iter().find(|(field, _)| *field == of).map(|(_, text)| text.as_str())
    }

    /// A length in metres in the unit of the first that is given, correctly rounded, where that is another.
    pub(crate) fn length(&self, of: Quantity, metres: &Value) -> Option<String> {
        let given = [Field::Span, Field::Rise, Field::Radius].into_iter();
        let unit = given.filter_map(|of| LengthUnit::of(self.text(of)?)).next()?;
        if unit == LengthUnit::Metre || !of.name().ends_with("_m") {
            return None;
        }
        let size = unit.metres().enclosure::<Ball>(BITS);
        let [lower, upper] = [metres.binary.lower, metres.binary.upper].map(|x| size.of_double(x));
        let told = lower.hull(&upper) / &size;
        // A length that ends has no zeros.
        let is_exact = metres.decimal.as_ref().is_some_and(|of| of.lower == of.upper);
        let told = match is_exact {
            true => decided(&told, DIGITS)?.to_string(),
            false => in_digits(&told, DIGITS)?,
        };
        Some(format!("{told} {}", unit.name()))
    }

    /// Note on what may have been meant otherwise.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// Adds the question to an answer, with what may have been meant otherwise.
    pub(crate) fn add_to(&self, record: &mut Record) {
        record.add_record("asked", Some(self.fields()));
        record.note(self.note());
    }

    /// Given values as they were written, and the words.
    pub(crate) fn fields(&self) -> Record {
        let mut fields = Record::default();
        for (field, text) in &self.given {
            fields.add(field.name(), text.as_str());
        }
        fields.add("words", self.words.as_str());
        fields
    }
}

/// Notes as one text.
pub(super) fn joined(notes: Vec<String>) -> Option<String> {
    (!notes.is_empty()).then(|| notes.join("; "))
}

/// Words for a field that is given.
fn in_words(field: Field, text: &str, given: &ArchGiven) -> String {
    let name = field.name().replace('_', " ");
    match (field, given) {
        (Field::HalfOpening, ArchGiven { half_opening: Some(alpha), .. }) => {
            // Beside two measures of the arc it only agrees with that of the arch.
            let own = text.parse::<ExactNumber>();
            let alpha = own.as_ref().unwrap_or(alpha);
            let other = match alpha.is_in_degrees() {
                true => equal(&alpha.enclosure(BITS), " rad"),
                false => equal(&in_degrees(alpha), " deg"),
            };
            format!("{name} {text}{other}")
        }
        (Field::Friction | Field::FrictionAngle, ArchGiven { friction: Some(friction), .. }) => {
            let other = match friction {
                Friction::Coefficient(mu) => {
                    equal(&degrees(&arctangent(&mu.enclosure(BITS))), " deg")
                }
                Friction::Angle(_) => equal(&slope(friction), ""),
                Friction::Infinite => ": no joint slides".to_owned(),
            };
            format!("friction {text}{other}")
        }
        // A ratio says itself what it is.
        (Field::Thickness, ArchGiven { thickness: Some(eta), .. })
            if text.ends_with(char::is_alphabetic) && !text.ends_with('r') =>
        {
            format!("{name} {text}{}", equal(&eta.enclosure(BITS), " r"))
        }
        (Field::Tilt, ArchGiven { tilt: Some(tilt), .. }) => match &**tilt {
            Friction::Angle(_) => format!("{name} {text}{}", equal(&slope(tilt), " g")),
            _ => format!("{name} {} g", text.trim_end_matches('g').trim_end()),
        },
        (Field::Stones, _) => format!("{text} equal stones"),
        (Field::Joints, _) => format!("joints at {text}"),
        _ => format!("{name} {text}"),
    }
}

/// Words behind the last measure of an arc: its circle, and its half opening where that is not what is given.
fn in_arc(field: Field, asked: &ArchAsked, arc: &Option<(Circle, Option<String>)>) -> String {
    let has = |field: &Field| asked.get(*field).is_some();
    let last = [Field::Radius, Field::Rise, Field::Span].into_iter().find(has);
    let Some((circle, alpha)) = arc.as_ref().filter(|_| last == Some(field)) else {
        return String::new();
    };
    let at = format!(" {} the {}", if field == Field::Radius { "of" } else { "at" }, circle.name());
    let [is_span, is_rise] = [Field::Span, Field::Rise].map(|field| has(&field));
    let is_given = has(&Field::HalfOpening) || has(&Field::Joints);
    let is_radius = field == Field::Radius;
    let by = match (is_span, is_rise) {
        (true, true) if is_given || is_radius => " by span and rise",
        (true, true) => "",
        _ if is_given => return at,
        (true, false) if is_radius => ", the flatter arc",
        (false, false) => return at,
        _ => "",
    };
    alpha.as_ref().map_or(at.clone(), |alpha| format!("{at} (half opening {alpha}{by})"))
}

/// Words for a field that may be a range: its ends, as they are read.
fn in_words_of_range(field: Field, text: &str) -> String {
    let name = match field {
        Field::FrictionAngle => "friction".to_owned(),
        _ => field.name().replace('_', " "),
    };
    let ends = match Range::read(text) {
        Ok(Some(Range { lower, upper })) => format!("{lower} to {upper}"),
        _ => text.to_owned(),
    };
    match field {
        Field::Stones => format!("{ends} equal stones"),
        Field::Joints => format!("joints at {ends}"),
        _ => format!("{name} {ends}"),
    }
}

/// A value in another unit, behind an equals sign; nothing where its digits are not decided, as of zero.
fn equal(value: &Ball, unit: &str) -> String {
    decided(value, DIGITS).map_or(String::new(), |text| format!(" = {text}{unit}"))
}

fn in_degrees(angle: &ExactNumber) -> Ball {
    angle
        .in_degrees()
        .map_or_else(|| degrees(&angle.enclosure(BITS)), |exact| exact.enclosure(BITS))
}

/// The tangent of an angle.
fn slope(of: &Friction) -> Ball {
    let grip = of.grip::<Ball>(BITS);
    grip.normal / grip.shear
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(of: &[(Field, &str)]) -> String {
        let asked = ArchAsked::of(of.iter().copied());
        let given = ArchGiven::new(&asked, crate::ask::Spelling::Key).unwrap();
        Understood::new(&asked, &given).in_words().to_owned()
    }

    #[test]
    fn what_is_given_is_said_in_both_units() {
        use Field as F;
        let measured = [
            (F::Friction, "31deg"),
            (F::Thickness, "60cm"),
            (F::Span, "10m"),
            (F::Rise, "3m"),
            (F::Stones, "41"),
        ];
        // 2 atan(3/5) = 61.9275… deg, R = 34/6 m, eta = 0.6/(R + 0.3), tan 31 deg = 0.600860…
        assert_eq!(
            words(&measured),
            "span 10m, rise 3m at the intrados (half opening 61.9275 deg), 41 equal stones, thickness 60cm = 0.100559 r, \
             friction 31deg = 0.600861"
        );
        let ratios = [
            (F::HalfOpening, "80deg"),
            (F::Friction, "0.6"),
            (F::Thickness, "3/25"),
            (F::Tilt, "5deg"),
        ];
        assert_eq!(
            words(&ratios),
            "half opening 80deg = 1.39626 rad, thickness 3/25, friction 0.6 = 30.9638 deg, tilt 5deg = 0.0874887 g"
        );
        assert!(
            words(&[(F::HalfOpening, "1"), (F::Friction, "1"), (F::Tilt, "0.1g")])
                .ends_with(", tilt 0.1 g")
        );
        let zero = [(F::HalfOpening, "1"), (F::Friction, "0")];
        assert_eq!(words(&zero), "half opening 1 = 57.2958 deg, friction 0");
        let unlimited = [(F::HalfOpening, "pi/2"), (F::Friction, "inf"), (F::Radius, "2m")];
        assert_eq!(
            words(&unlimited),
            "radius 2m of the intrados, half opening pi/2 = 90 deg, friction inf: no joint slides"
        );
        for (shape, said) in [
            (
                &[(F::Span, "3.3m"), (F::Radius, "1995mm")][..],
                "span 3.3m, radius 1995mm of the intrados (half opening 55.7987 deg, the flatter arc)",
            ),
            (
                &[(F::Span, "10m"), (F::Rise, "3m"), (F::HalfOpening, "61.9deg")],
                "span 10m, rise 3m at the intrados (half opening 61.9275 deg by span and rise), half opening 61.9deg = \
                 1.08036 rad",
            ),
            (
                &[(F::Rise, "1m"), (F::Radius, "2m")],
                "rise 1m, radius 2m of the intrados (half opening 60 deg)",
            ),
            (
                &[(F::Span, "2m"), (F::HalfOpening, "30deg")],
                "span 2m at the intrados, half opening 30deg = 0.523599 rad",
            ),
            (
                &[(F::Span, "1467mm"), (F::Rise, "593mm"), (F::Radius, "750mm")],
                "span 1467mm, rise 593mm, radius 750mm of the intrados (half opening 77.9078 deg by span and rise)",
            ),
        ] {
            assert_eq!(words(shape), said);
        }
    }
}
