//! The text of a range: two ends, or a value and how far off it may be.
//!
//! | text | ends |
//! |---|---|
//! | `2.98m..3.02m`, `0.5..inf` | as they are written |
//! | `3m±2cm`, `3m+-2cm` | `2.98m` and `3.02m` |
//! | `0.6±10%` | `0.54` and `0.66` |
//!
//! Both ends are exact texts, which the readers of one value read: a decimal if it ends, else a fraction; beside `±`
//! the unit is that of the value, and lengths of two units meet in metres.

use super::question::Misfit;
use crate::number::{
    BETWEEN, ExactNumber, Form, PLUS_MINUS, decimal, is_angle, is_range, shown, spelt_range,
};
use crate::problem::measures::Length;
use num_bigint::BigInt;
use num_rational::BigRational;

/// Range of a field, by the exact texts of its ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Range {
    /// Text of the lower end.
    pub lower: String,
    /// Text of the upper end.
    pub upper: String,
}

impl Range {
    /// Reads the text of a range; nothing if the text is that of one value.
    ///
    /// ```
    /// use couplet_ask::Range;
    /// let range = Range::read("3m±2cm").unwrap().unwrap();
    /// assert_eq!((range.lower.as_str(), range.upper.as_str()), ("2.98m", "3.02m"));
    /// assert_eq!(Range::read("3m"), Ok(None));
    /// ```
    pub fn read(text: &str) -> Result<Option<Self>, Misfit> {
        if !is_range(text) {
            return Ok(None);
        }
        let shown = || shown(text.trim());
        let wrong = |why: &str| Err(format!("'{}' {why}", shown()).into());
        let more = "has more parts than a range: two ends (0.5..0.7), or a value and how far off it may be (0.6±0.1)";
        let text = spelt_range(text);
        let parts = |sign: &str| text.split(sign).map(str::trim).collect::<Vec<_>>();
        let (ends, about) = (parts(BETWEEN), parts(PLUS_MINUS));
        match (&ends[..], &about[..]) {
            // Three points could be two and a decimal's.
            _ if text.contains("...") => wrong(more),
            (all, _) | (_, all) if all.len() > 1 && all.iter().any(|part| part.is_empty()) => {
                wrong(
                    "is half a range: give both ends (0.5..0.7), or a value and how far off it may be (0.6±0.1, 0.6±10%)",
                )
            }
            (&[lower, upper], &[_]) => Self::between(lower, upper, shown),
            (&[_], &[value, deviation]) => Self::about(value, deviation, shown),
            _ => wrong(more),
        }
        .map(Some)
    }

    /// Range of two ends, which stay as they are written.
    fn between(lower: &str, upper: &str, shown: impl Fn() -> String) -> Result<Self, Misfit> {
        let [low, high] = [lower, upper].map(Part::read);
        if let (Some(low), Some(high)) = (low, high)
            && let Some(unit) = low.unit.of_one_only(&high.unit)
        {
            return Err(one_unit(&shown(), [lower, upper], unit, BETWEEN));
        }
        Ok(Self { lower: lower.to_owned(), upper: upper.to_owned() })
    }

    /// Range of all that is no farther from a value than its deviation.
    fn about(value: &str, deviation: &str, shown: impl Fn() -> String) -> Result<Self, Misfit> {
        let number = |part: &str, read: Option<Part>| read.ok_or_else(|| no_number(&shown(), part));
        let middle = number(value, Part::read(value))?;
        let percents = deviation.strip_suffix('%').map(|part| plain(part.trim_end()));
        let (unit, middle, off) = match percents {
            Some(percents) => {
                let percents = percents
                    .map(|number| Part { number, unit: Unit::None })
                    .filter(|_| middle.unit != Unit::Arctangent);
                let percents = number(deviation, percents)?.number;
                let off = &middle.number * percents / BigInt::from(100);
                (middle.unit, middle.number, off)
            }
            None => {
                let off = number(deviation, Part::read(deviation))?;
                if let Some(unit) = middle.unit.of_one_only(&off.unit) {
                    return Err(one_unit(&shown(), [value, deviation], unit, PLUS_MINUS));
                }
                Part::together(middle, off).ok_or_else(|| {
                    let [value, deviation] = [value, deviation].map(self::shown);
                    format!(
                        "in '{}' {value} and {deviation} make no exact sum: give the deviation in the unit of the value, \
                         or in % of it, or give both ends (0.5..0.7)",
                        shown()
                    )
                })?
            }
        };
        match off < BigInt::ZERO.into() {
            true => Err(format!("'{}' has a deviation below 0: give its size", shown()).into()),
            false => Ok(Self {
                lower: unit.write(&(&middle - &off)),
                upper: unit.write(&(middle + off)),
            }),
        }
    }
}

/// Refusal of a range of which a part is no number.
pub(super) fn no_number(range: &str, part: &str) -> Misfit {
    let part = shown(part);
    format!(
        "in '{range}' the part '{part}' is not a number with or without a unit (0.1, 2cm, 1deg) or, behind ±, of % (5%)"
    )
    .into()
}

/// Refusal of two parts of which one has a unit and the other none.
fn one_unit(range: &str, parts: [&str; 2], unit: Unit, sign: &str) -> Misfit {
    let meant = parts.map(|part| with_unit(part, unit)).join(sign);
    format!("in '{range}' one part has a unit and the other none: write {meant}").into()
}

/// A number in a unit.
pub(super) struct Part {
    number: BigRational,
    unit: Unit,
}

/// Unit of a part, in which its number is kept.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    None,
    /// Thickness over the radius, where that is said.
    Ratio,
    /// A unit of length, by its name.
    Length(&'static str),
    Radians,
    Degrees,
    Pi,
    /// An arctangent, which says itself what it is and has no sum.
    Arctangent,
}

/// A rational number without a unit.
fn plain(text: &str) -> Option<BigRational> {
    let number = text.parse::<ExactNumber>().ok().filter(|_| !is_angle(text))?;
    number.is_rational().then(|| number.factor().reduced())
}

/// A text with a unit, which it may have already.
fn with_unit(text: &str, unit: Unit) -> String {
    match Part::read(text) {
        Some(Part { unit: Unit::None, .. }) => format!("{}{}", shown(text), unit.name()),
        _ => shown(text),
    }
}

impl Part {
    /// Number and unit of a text; none of infinity, of a tangent, and of what is no number.
    pub(super) fn read(text: &str) -> Option<Self> {
        let behind = |unit: &str| plain(text.strip_suffix(unit)?.trim_end());
        let of = |unit: &'static str| Some((behind(unit)?, Unit::Length(unit)));
        let lengths = Length::units().find_map(of);
        let ratio = || Some((behind("r")?, Unit::Ratio));
        if let Some((number, unit)) = lengths.or_else(ratio) {
            return Some(Self { number, unit });
        }
        // Feet and inches.
        if let Ok(length) = text.parse::<Length>() {
            return Some(Self { number: length.metres().clone(), unit: Unit::Length("m") });
        }
        let angle: ExactNumber = text.parse().ok()?;
        let number = angle.factor().reduced();
        Some(match angle.form() {
            Form::TimesPi if angle.is_in_degrees() => {
                Self { number: number * BigInt::from(180), unit: Unit::Degrees }
            }
            Form::TimesPi => Self { number, unit: Unit::Pi },
            Form::TwiceArctangent | Form::ArctangentOfRoot => {
                Self { number, unit: Unit::Arctangent }
            }
            Form::Rational if is_angle(text) => Self { number, unit: Unit::Radians },
            Form::Rational => Self { number, unit: Unit::None },
        })
    }

    /// The numbers of two parts in one unit, if there is one.
    pub(super) fn together(
        value: Self,
        deviation: Self,
    ) -> Option<(Unit, BigRational, BigRational)> {
        let half_turn = || BigRational::from(BigInt::from(180));
        let (x, d) = (value.number, deviation.number);
        match (value.unit, deviation.unit) {
            (Unit::Arctangent, _) => None,
            (unit, other) if unit == other => Some((unit, x, d)),
            (Unit::Length(unit), Unit::Length(other)) => {
                Some((Unit::Length("m"), x * metres(unit)?, d * metres(other)?))
            }
            (Unit::Degrees, Unit::Pi) => Some((Unit::Degrees, x, d * half_turn())),
            (Unit::Pi, Unit::Degrees) => Some((Unit::Degrees, x * half_turn(), d)),
            _ => None,
        }
    }
}

/// Metres of a unit of length.
fn metres(unit: &str) -> Option<BigRational> {
    let one: Length = format!("1{unit}").parse().ok()?;
    Some(one.metres().clone())
}

impl Unit {
    /// The unit that one of two parts has and the other, a number alone, lacks.
    fn of_one_only(&self, other: &Self) -> Option<Self> {
        let says_itself = |unit: &Self| [Self::None, Self::Pi, Self::Arctangent].contains(unit);
        match (self, other) {
            (Self::None, unit) | (unit, Self::None) if !says_itself(unit) => Some(*unit),
            _ => None,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::None | Self::Pi | Self::Arctangent => "",
            Self::Ratio => "r",
            Self::Length(unit) => unit,
            Self::Radians => "rad",
            Self::Degrees => "deg",
        }
    }

    /// Text of a number in this unit.
    pub(super) fn write(self, number: &BigRational) -> String {
        if self != Self::Pi {
            return decimal(number) + self.name();
        }
        let one = BigInt::from(1);
        let shown = |sign: &str, of: &BigInt| {
            if *of == one { String::new() } else { format!("{sign}{of}") }
        };
        format!("{}pi{}", shown("", number.numer()), shown("/", number.denom()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<[String; 2], String> {
        let range = Range::read(text).map_err(|error| error.to_string())?;
        let range = range.expect("a range");
        Ok([range.lower, range.upper])
    }

    #[test]
    fn the_ends_of_a_range_are_exact_texts() {
        for (text, lower, upper) in [
            ("2.98m..3.02m", "2.98m", "3.02m"),
            (" 0.50 .. 6/10 ", "0.50", "6/10"),
            ("0.5..inf", "0.5", "inf"),
            ("2.98m..302cm", "2.98m", "302cm"),
            ("0.6..0.6", "0.6", "0.6"),
            ("1..pi/2", "1", "pi/2"),
            ("tan(31deg)..0.7", "tan(31deg)", "0.7"),
            ("0.1r..0.12r", "0.1r", "0.12r"),
            ("3m±2cm", "2.98m", "3.02m"),
            ("3m+-2cm", "2.98m", "3.02m"),
            ("3 m ± 0.02 m", "2.98m", "3.02m"),
            ("300cm±2cm", "298cm", "302cm"),
            ("3m±0cm", "3m", "3m"),
            ("10ft±1in", "3.0226m", "3.0734m"),
            ("10ft±1ft", "9ft", "11ft"),
            ("33in±1%", "32.67in", "33.33in"),
            ("0.6±10%", "0.54", "0.66"),
            ("0.6±0", "0.6", "0.6"),
            ("0.6±100%", "0", "1.2"),
            ("0.1±0.3", "-0.2", "0.4"),
            ("0.12r±0.01r", "0.11r", "0.13r"),
            ("31deg±1deg", "30deg", "32deg"),
            ("31°±0.5°", "30.5deg", "31.5deg"),
            ("1.5rad±0.1rad", "1.4rad", "1.6rad"),
            ("1/3±1%", "0.33", "101/300"),
            ("1/3±1/6", "1/6", "0.5"),
            ("pi/2±1%", "99pi/200", "101pi/200"),
            ("3pi/4±pi/4", "pi/2", "pi"),
            ("pi/2±1deg", "89deg", "91deg"),
            ("80deg±pi/180", "79deg", "81deg"),
            ("1e-30±1e-31", "9e-31", "1.1e-30"),
            ("2000±1000", "1000", "3000"),
            ("1e3±1/4", "999.75", "1000.25"),
            ("2.98m±1/3%", "44551/15000m", "44849/15000m"),
        ] {
            assert_eq!(read(text), Ok([lower.to_owned(), upper.to_owned()]), "{text}");
        }
        for text in ["0.6", "80deg", "inf", "1e-5", "2atan(3/5)", "-1", "a"] {
            assert_eq!(Range::read(text), Ok(None), "{text}");
        }
    }

    /// Ends that are made are read back as the numbers that they are.
    #[test]
    fn the_ends_enclose_the_value_by_the_deviation() {
        let number = |text: &str| text.parse::<ExactNumber>().unwrap();
        for (value, deviation) in [("0.6", "0.07"), ("1/7", "0.05"), ("2pi/3", "pi/7")] {
            let [lower, upper] = read(&format!("{value}±{deviation}")).unwrap();
            let [lower, upper, x, d] =
                [&lower, &upper, value, deviation].map(|text| number(text).factor().reduced());
            assert_eq!((lower, upper), (&x - &d, x + d));
        }
        let [lower, upper] = ["2.98m", "302/100m"].map(|x| x.parse::<Length>().unwrap());
        assert!(lower.metres() < upper.metres());
    }

    #[test]
    fn what_is_no_range_is_refused_in_one_line() {
        for (text, why) in [
            ("0.6±", "'0.6±' is half a range: give both ends (0.5..0.7)"),
            ("±5%", "'±5%' is half a range"),
            ("..3m", "half a range"),
            ("3m..", "half a range"),
            ("..", "half a range"),
            ("1..2..3", "'1..2..3' has more parts than a range"),
            ("1±2±3", "more parts"),
            ("1..2±0.1", "more parts"),
            ("1...2", "more parts"),
            ("30..32deg", "one part has a unit and the other none: write 30deg..32deg"),
            ("2.98..3.02m", "write 2.98m..3.02m"),
            ("2.98m..3.02", "write 2.98m..3.02m"),
            ("0.1..0.12r", "write 0.1r..0.12r"),
            ("3±2cm", "write 3cm±2cm"),
            ("3m±0.02", "write 3m±0.02m"),
            ("31deg±1", "write 31deg±1deg"),
            (
                "3m±2deg",
                "3m and 2deg make no exact sum: give the deviation in the unit of the value",
            ),
            ("pi/2±0.1", "pi/2 and 0.1 make no exact sum"),
            ("1.5rad±1deg", "no exact sum"),
            ("2atan(3/5)±1deg", "no exact sum"),
            ("2atan(3/5)±1%", "the part '1%' is not a number"),
            ("inf±1", "the part 'inf' is not a number"),
            ("tan(31deg)±1%", "the part 'tan(31deg)' is not a number"),
            ("x±1", "the part 'x' is not a number"),
            ("1±x", "the part 'x' is not a number"),
            ("1±5%%", "the part '5%%' is not a number"),
            ("1±5deg%", "the part '5deg%' is not a number"),
            ("0.6±-0.1", "'0.6±-0.1' has a deviation below 0: give its size"),
            ("0.6+--5%", "has a deviation below 0"),
            ("3m±-2cm", "has a deviation below 0"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(why) && !error.contains('\n'), "{text}: {error}");
        }
    }
}
