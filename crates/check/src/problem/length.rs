//! Lengths and densities with their units, as they are read and told.

use crate::number::{ExactNumber, decimal, says, shown, worded};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::fmt;
use std::str::FromStr;

/// A unit by its name, in the base unit: numerator and denominator.
type UnitOf = (&'static str, i64, i64);

worded! {
    /// A unit in which lengths are told.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum LengthUnit {
        /// Metre.
        #[default]
        Metre = ("m", 1, 1),
        /// A hundredth of a metre.
        Centimetre = ("cm", 1, 100),
        /// A thousandth of a metre.
        Millimetre = ("mm", 1, 1000),
        /// 0.3048 m.
        Foot = ("ft", 3_048, 10_000),
        /// A twelfth of a foot.
        Inch = ("in", 254, 10_000),
        /// Three feet.
        Yard = ("yd", 9_144, 10_000),
    }
    /// All of them.
    pub const ALL;
    /// Sign of the unit, and its metres.
    fn row -> UnitOf;
}

/// A length above zero, in metres.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Length(pub(super) BigRational);

/// The weight of a volume, in kN/m³, above zero.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct UnitWeight(pub(super) BigRational);

/// Reason why measures are refused.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeasureError {
    /// The text has no number, or no unit behind it.
    Length(String),
    /// The text has no number, or no unit behind it.
    Density(String),
    /// A sign stands between digits.
    Apart {
        /// Text as given.
        text: String,
        /// The sign.
        sign: char,
    },
    /// A length or a density is zero or negative.
    NotPositive(String),
    /// The intrados would have no radius.
    Thickness {
        /// Thickness as given.
        thickness: String,
        /// The circle that is measured.
        circle: &'static str,
        /// The thickness at which the intrados is a point.
        most: String,
        /// Rule that bounds the thickness.
        rule: &'static str,
    },
    /// A span or a rise that a circle of the radius does not have.
    Chord {
        /// The span, or the rise, in words.
        chord: String,
        /// Radius of the circle.
        radius: String,
        /// Diameter of the circle.
        diameter: String,
    },
}

says!(MeasureError {
    Self::Length(text) => "'{text}' is not a length: give a number and its unit, m, cm, mm, ft or in (10m, 60cm, 60ft1in)";
    Self::Density(text) => "'{text}' is not a density: give a number and its unit, kg/m3, kN/m3 or lb/ft3 (2400kg/m3)";
    Self::Apart { text, sign } =>
        "'{text}' has '{sign}' between its digits: decimals stand behind a point, and nothing between thousands (1250.5cm)";
    Self::NotPositive(text) => "{text} is not above 0";
    Self::Thickness { thickness, circle, most, rule } =>
        "the thickness {thickness} is too large for this {circle}: at most {most}, its {rule}";
    Self::Chord { chord, radius, diameter } => "the {chord} is too large for the radius {radius}: its diameter is {diameter}";
});

/// Units of length by all their names, in the order in which the end of a text is compared with them.
const LENGTHS: [(&str, LengthUnit); 14] = {
    use LengthUnit::{Centimetre, Foot, Inch, Metre, Millimetre, Yard};
    [
        ("cm", Centimetre),
        ("mm", Millimetre),
        ("m", Metre),
        ("metres", Metre),
        ("meters", Metre),
        ("feet", Foot),
        ("foot", Foot),
        ("ft", Foot),
        ("\'", Foot),
        ("inches", Inch),
        ("inch", Inch),
        ("in", Inch),
        ("\"", Inch),
        ("yd", Yard),
    ]
};

/// Units of density in kN/m³. The standard acceleration of gravity is 9.80665 m/s² (3rd General Conference on Weights
/// and Measures, 1901), a pound 0.45359237 kg (1959), both exactly.
const DENSITIES: [UnitOf; 7] = [
    ("kg/m3", 980_665, 100_000_000),
    ("t/m3", 980_665, 100_000),
    ("g/cm3", 980_665, 100_000),
    ("kN/m3", 1, 1),
    ("N/m3", 1, 1000),
    ("lb/ft3", 45_359_237 * 980_665, 283_168_465_920_000),
    ("pcf", 45_359_237 * 980_665, 283_168_465_920_000),
];

/// A rational number above zero with one of these units behind it, in the unit's base; or why it is none.
fn with_unit(
    text: &str,
    read: impl Fn() -> Option<BigRational>,
    is_none: fn(String) -> MeasureError,
) -> Result<BigRational, MeasureError> {
    let value = read().ok_or_else(|| match apart(text) {
        Some(sign) => MeasureError::Apart { text: shown(text), sign },
        None => is_none(shown(text)),
    })?;
    match value > BigInt::ZERO.into() {
        true => Ok(value),
        false => Err(MeasureError::NotPositive(shown(text))),
    }
}

fn quantity(text: &str, mut units: impl Iterator<Item = UnitOf>) -> Option<BigRational> {
    let of = |(unit, n, d)| Some((text.trim().strip_suffix(unit)?, n, d));
    let (number, n, d) = units.find_map(of)?;
    Some(mixed(number.trim_end())? * BigRational::new(n.into(), d.into()))
}

/// A rational number, or a whole one and a fraction below one behind a blank or a hyphen: `5 1/2`.
fn mixed(text: &str) -> Option<BigRational> {
    let number = |text: &str| {
        let number: ExactNumber = text.parse().ok()?;
        number.is_rational().then(|| number.factor().clone())
    };
    let Some((whole, part)) = text.split_once([' ', '-']).filter(|(_, part)| part.contains('/'))
    else {
        return number(text);
    };
    let (is_whole, part) = (whole.bytes().all(|c| c.is_ascii_digit()), number(part.trim())?);
    let is_part = part > BigInt::ZERO.into() && part < BigInt::from(1).into();
    (is_whole && is_part).then(|| Some(number(whole)? + part))?
}

/// Metres of whole feet and less than twelve inches: `60ft1in`, `60'1"`, `34' 5 1/2"`, `34'-5"`.
fn feet_and_inches(text: &str) -> Option<BigRational> {
    let of_feet = |(name, ..): UnitOf| text.trim().split_once(name);
    let (feet, rest) = LengthUnit::Foot.names().find_map(of_feet)?;
    let (feet, rest) = (feet.trim(), rest.trim());
    let inches = quantity(rest.strip_prefix('-').unwrap_or(rest), LengthUnit::Inch.names())?;
    let foot = LengthUnit::Foot.metres().factor().clone();
    let is_whole = !feet.is_empty() && feet.bytes().all(|c| c.is_ascii_digit());
    let is_less = inches >= BigInt::ZERO.into() && inches < foot;
    (is_whole && is_less).then(|| Some(mixed(feet)? * foot + inches))?
}

/// Sign that stands between the digits of a number and is no point.
fn apart(text: &str) -> Option<char> {
    let is_digit = |c: Option<&char>| c.is_some_and(char::is_ascii_digit);
    let all: Vec<char> = text.trim().chars().collect();
    let place = (1..all.len()).find(|&k| {
        [',', '\'', '’', ' ', '\u{a0}', '\u{202f}'].contains(&all[k])
            && is_digit(all.get(k - 1))
            && is_digit(all.get(k + 1))
    });
    place.map(|place| all[place])
}

impl FromStr for Length {
    type Err = MeasureError;

    /// Reads `10m`, `3.5 m`, `60cm`, `600mm`, `33ft`, `7in`, `60ft1in`, `34' 5 1/2"`, with decimals or fractions.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let plain = plain(text);
        let all = || LENGTHS.into_iter().map(|(name, unit)| unit.named(name));
        let read = || quantity(&plain, all()).or_else(|| feet_and_inches(&plain));
        with_unit(text, read, MeasureError::Length).map(Self)
    }
}

/// A length with the signs of feet and inches that a keyboard has.
fn plain(text: &str) -> String {
    text.replace(['’', '′'], "'").replace(['”', '″'], "\"")
}

impl LengthUnit {
    /// Sign of the unit.
    pub const fn name(self) -> &'static str {
        self.row().0
    }

    fn named(self, name: &'static str) -> UnitOf {
        let (_, n, d) = self.row();
        (name, n, d)
    }

    fn names(self) -> impl Iterator<Item = UnitOf> {
        let own = LENGTHS.into_iter().filter(move |(_, unit)| *unit == self);
        own.map(|(name, unit)| unit.named(name))
    }

    /// Unit of a length, the larger one of feet and inches; `None` if it names none.
    pub fn of(length: &str) -> Option<Self> {
        let plain = plain(length.trim());
        let (_, end) = LENGTHS.into_iter().find(|(name, _)| plain.ends_with(name))?;
        Some(feet_and_inches(&plain).map_or(end, |_| Self::Foot))
    }

    /// The unit in metres.
    pub fn metres(self) -> ExactNumber {
        let (_, n, d) = self.row();
        ExactNumber::rational(BigRational::new(n.into(), d.into()))
    }
}

impl FromStr for UnitWeight {
    type Err = MeasureError;

    /// Reads `24kN/m3`, `22 kN/m^3`, or a density in standard gravity, `2400kg/m³`, `150lb/ft3`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let plain = text.replace('³', "3").replace("^3", "3");
        with_unit(text, || quantity(&plain, DENSITIES.into_iter()), MeasureError::Density).map(Self)
    }
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let many = BigInt::from(1_000_000);
        let cut = BigRational::from((&self.0 * &many).to_integer()) / many;
        let exact = decimal(&self.0);
        // A decimal that does not end is told to a micrometre; what is shorter is a fraction.
        match exact.contains('/') && cut > BigInt::ZERO.into() {
            true => write!(f, "{}… m", decimal(&cut)),
            false => write!(f, "{exact} m"),
        }
    }
}

impl Length {
    /// Length of so many metres, which are above zero.
    pub fn new(metres: BigRational) -> Self {
        Self(metres)
    }

    /// Names of the units of length that are read, in the order in which the end of a text is compared with them.
    pub fn units() -> impl Iterator<Item = &'static str> {
        LENGTHS.into_iter().map(|(name, ..)| name)
    }

    /// Tells whether it is longer than another.
    pub fn exceeds(&self, other: &Self) -> bool {
        exceeds(&self.0, &other.0)
    }

    /// Number of metres.
    pub fn metres(&self) -> &BigRational {
        &self.0
    }
}

impl UnitWeight {
    /// Tells whether it is heavier than another.
    pub fn exceeds(&self, other: &Self) -> bool {
        exceeds(&self.0, &other.0)
    }
}

/// Tells whether the first of two lengths is the larger one. Their own comparison goes down a continued fraction, a
/// step of recursion for each of its terms, which many digits make too many.
pub(super) fn exceeds(a: &BigRational, b: &BigRational) -> bool {
    a.numer() * b.denom() > b.numer() * a.denom()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(text: &str) -> Length {
        text.parse().unwrap()
    }

    #[test]
    fn a_length_is_told_exactly_or_cut_off() {
        let told = ["9m", "60ft1in", "0.1234567m", "1/3m", "2/3 m", "1/3000000000m"];
        let told = told.map(|text| length(text).to_string());
        let cut =
            ["9 m", "18.3134 m", "0.1234567 m", "0.333333… m", "0.666666… m", "1/3000000000 m"];
        assert_eq!(told, cut, "no digit is rounded up: what is told as the most is no more");
    }

    #[test]
    fn lengths_and_densities_are_read_with_their_units() {
        let quotient = |n: i32, d: i32| BigRational::new(n.into(), d.into());
        for (text, n, d) in [
            ("10m", 10, 1),
            ("60 cm", 3, 5),
            ("600mm", 3, 5),
            ("1/3 m", 1, 3),
            ("10ft", 381, 125),
            ("1in", 127, 5000),
            ("60ft1in", 183_134, 10_000),
            ("60 ft 1 in", 183_134, 10_000),
            ("60'1\"", 183_134, 10_000),
            ("60’ 1”", 183_134, 10_000),
            ("34' 5 1/2\"", 105_029, 10_000),
            ("34'-5-1/2\"", 105_029, 10_000),
            ("10 1/2 feet", 32_004, 10_000),
            ("0x1p-1m", 1, 2),
            ("1.5D1cm", 3, 20),
            ("10yd", 9_144, 1000),
        ] {
            assert_eq!(length(text).0, quotient(n, d), "{text}");
        }
        for (text, sign) in [("1,5m", ','), ("1'000mm", '\''), ("1 000mm", ' '), ("1.250,5cm", ',')]
        {
            let error = text.parse::<Length>().unwrap_err();
            assert_eq!(error, MeasureError::Apart { text: text.to_owned(), sign }, "{error}");
        }
        for text in ["60ft12in", "1.5ft2in", "6'3", "-6'3\"", "5 3/2in", "10m2cm", "1in2ft"] {
            assert!(text.parse::<Length>().is_err(), "{text}");
        }
        for text in ["10", "m", "1e2000m", "10 miles", "10deg", "pi m", "inf m"] {
            let error = text.parse::<Length>().unwrap_err().to_string();
            assert!(error.contains("60cm"), "{error}");
        }
        for text in ["0m", "-1m"] {
            let error = text.parse::<Length>().unwrap_err().to_string();
            assert_eq!(error, format!("{text} is not above 0"));
        }
        let weight = |text: &str| text.parse::<UnitWeight>().unwrap().0;
        assert_eq!(weight("24kN/m3"), quotient(24, 1));
        assert_eq!(weight("1000 kg/m³"), quotient(980_665, 100_000));
        // A pound, standard gravity and a foot: 0.45359237 kg, 9.80665 m/s², 0.3048 m.
        let pound = quotient(45_359_237, 100_000_000) * quotient(980_665, 100_000);
        let foot = quotient(3048, 10_000);
        let cube = foot.clone() * &foot * &foot * quotient(1000, 1);
        assert_eq!(weight("150lb/ft3"), quotient(150, 1) * pound / cube);
        assert_eq!(weight("22 kN/m^3"), quotient(22, 1));
        assert_eq!(weight("22000 N/m3"), quotient(22, 1));
        assert_eq!(weight("150pcf"), weight("150 lb/ft^3"));
        assert_eq!(
            [weight("2.4t/m³"), weight("2.4 g/cm3")],
            [weight("2400kg/m3"), weight("2400kg/m3")]
        );
        assert!("1ft1in".parse::<UnitWeight>().is_err());
        assert!("2400".parse::<UnitWeight>().is_err() && "24m".parse::<UnitWeight>().is_err());
    }
}
