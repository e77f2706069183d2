//! An arch as it is measured: in metres, at one of its circles, with the weight of its material.
//!
//! Angles are the same at all circles, so the half opening needs no thickness:
//!
//! ```text
//! tan(alpha/2) = rise / (span/2)        R = (span²/4 + rise²) / (2 rise)
//! ```
//!
//! The centreline is half a thickness from the intrados and from the extrados. With `c` = 1, 0, -1 where the circle of
//! radius `R` is the intrados, the centreline, the extrados:
//!
//! ```text
//! r = R + c t/2        eta = t/r        and back: r = R / (1 - c eta/2), t = eta r
//! span = 2 R sin(alpha)        rise = R (1 - cos(alpha))
//! ```
//!
//! So any two of half opening, span, rise and radius make the others. With a radius the square of the cotangent of the
//! half opening is rational; of a span and a radius there are two arcs, of which the flatter one is meant.
//!
//! Everything given is rational, and so is `eta`. A span is measured at the intrados unless another circle is named.

use crate::number::{
    Engine, ExactNumber, Field, decimal, rational_sine_and_cosine, says, shown, worded,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::fmt;
use std::str::FromStr;

worded! {
    /// The circle at which an arch is measured.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Circle {
        /// The inner face: the clear span.
        #[default]
        Intrados = "intrados",
        /// The circle half a thickness from both faces: the radius `r` of the paper.
        Centreline = "centreline",
        /// The outer face.
        Extrados = "extrados",
    }
    /// All of them, in order.
    pub const ALL;
    /// Name of the circle in files and on the command line.
    pub fn name -> &'static str;
}

worded! {
    /// A unit in which lengths are told.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum LengthUnit {
        /// Metre.
        #[default]
        Metre = "m",
        /// A hundredth of a metre.
        Centimetre = "cm",
        /// A thousandth of a metre.
        Millimetre = "mm",
        /// 0.3048 m.
        Foot = "ft",
        /// A twelfth of a foot.
        Inch = "in",
        /// Three feet.
        Yard = "yd",
    }
    /// All of them.
    pub const ALL;
    /// Sign of the unit.
    pub fn name -> &'static str;
}

/// A length above zero, in metres.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Length(BigRational);

/// The weight of a volume, in kN/m³, above zero.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct UnitWeight(BigRational);

/// The size of an arch.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Measures {
    circle: Circle,
    radius: Length,
    loaded: Option<(UnitWeight, Length)>,
    unit: LengthUnit,
}

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

/// A unit by its name, in the base unit: numerator and denominator.
type UnitOf = (&'static str, i64, i64);

/// Units of length in metres.
const LENGTHS: [UnitOf; 14] = [
    ("cm", 1, 100),
    ("mm", 1, 1000),
    ("m", 1, 1),
    ("metres", 1, 1),
    ("meters", 1, 1),
    FEET[0],
    FEET[1],
    FEET[2],
    FEET[3],
    INCHES[0],
    INCHES[1],
    INCHES[2],
    INCHES[3],
    ("yd", 9_144, 10_000),
];
const FEET: [UnitOf; 4] = [
    ("feet", 3_048, 10_000),
    ("foot", 3_048, 10_000),
    ("ft", 3_048, 10_000),
    ("\'", 3_048, 10_000),
];
const INCHES: [UnitOf; 4] =
    [("inches", 254, 10_000), ("inch", 254, 10_000), ("in", 254, 10_000), ("\"", 254, 10_000)];
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

fn quantity(text: &str, units: &[UnitOf]) -> Option<BigRational> {
    let of = |(unit, n, d): &UnitOf| Some((text.trim().strip_suffix(unit)?, *n, *d));
    let (number, n, d) = units.iter().find_map(of)?;
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
    let (feet, rest) = FEET.iter().find_map(|(name, ..)| text.trim().split_once(name))?;
    let (feet, rest) = (feet.trim(), rest.trim());
    let inches = quantity(rest.strip_prefix('-').unwrap_or(rest), &INCHES)?;
    let foot = BigRational::new(FEET[0].1.into(), FEET[0].2.into());
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
        let read = || quantity(&plain, &LENGTHS).or_else(|| feet_and_inches(&plain));
        with_unit(text, read, MeasureError::Length).map(Self)
    }
}

/// A length with the signs of feet and inches that a keyboard has.
fn plain(text: &str) -> String {
    text.replace(['’', '′'], "'").replace(['”', '″'], "\"")
}

impl LengthUnit {
    /// Unit of a length, the larger one of feet and inches; `None` if it names none.
    pub fn of(length: &str) -> Option<Self> {
        let plain = plain(length.trim());
        let end = LENGTHS.iter().find(|(name, ..)| plain.ends_with(name))?;
        let (_, n, d) = feet_and_inches(&plain).map_or(end, |_| &FEET[0]);
        let size = BigRational::new((*n).into(), (*d).into());
        Self::ALL.into_iter().find(|unit| *unit.metres().factor() == size)
    }

    /// The unit in metres.
    pub fn metres(self) -> ExactNumber {
        let sizes = LENGTHS.iter().filter(|(name, ..)| *name == self.name());
        ExactNumber::rational(
            sizes.map(|(_, n, d)| BigRational::new((*n).into(), (*d).into())).sum(),
        )
    }
}

impl FromStr for UnitWeight {
    type Err = MeasureError;

    /// Reads `24kN/m3`, `22 kN/m^3`, or a density in standard gravity, `2400kg/m³`, `150lb/ft3`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let plain = text.replace('³', "3").replace("^3", "3");
        with_unit(text, || quantity(&plain, &DENSITIES), MeasureError::Density).map(Self)
    }
}

impl FromStr for Circle {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let all = [Self::Intrados, Self::Centreline, Self::Extrados];
        let found = all.into_iter().find(|circle| circle.name() == text);
        found.ok_or_else(|| "one of intrados, centreline, extrados".to_owned())
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

impl Circle {
    /// Half thicknesses from it to the centreline, outwards.
    pub const fn to_centreline(self) -> i32 {
        match self {
            Self::Intrados => 1,
            Self::Centreline => 0,
            Self::Extrados => -1,
        }
    }

    /// Radius of the centreline of an arch of thickness `eta` whose radius at this circle is given.
    pub fn centreline<T: Field>(self, radius: T, eta: &T) -> T {
        radius / (eta.int(1) - eta.ratio(self.to_centreline(), 2) * eta)
    }
}

/// Tells whether the first of two lengths is the larger one. Their own comparison goes down a continued fraction, a
/// step of recursion for each of its terms, which many digits make too many.
pub(super) fn exceeds(a: &BigRational, b: &BigRational) -> bool {
    a.numer() * b.denom() > b.numer() * a.denom()
}

/// The circle of a span and a rise: the tangent of a quarter of its opening, and its radius.
pub fn circle<T: Field>(span: &T, rise: &T) -> [T; 2] {
    let half = span.ratio(1, 2) * span;
    [rise.clone() / &half, (half.square() + rise.square()) / (rise.int(2) * rise)]
}

/// The half opening of an arch of this span and rise, and the radius of the circle at which both are measured.
pub fn of_span_and_rise(span: &Length, rise: &Length) -> (ExactNumber, Length) {
    let [tangent, radius] = circle(&span.0, &rise.0);
    (ExactNumber::twice_arctangent(tangent), Length(radius))
}

/// Least and largest radius of the circles of some spans and rises: it grows with the span, and is convex in the rise
/// and least at half the span.
pub fn radii([short, long]: &[Length; 2], [low, high]: &[Length; 2]) -> [Length; 2] {
    let half = Length(&short.0 / BigInt::from(2));
    let nearest = if low.exceeds(&half) { low } else { &half };
    let nearest = if nearest.exceeds(high) { high } else { nearest };
    let radius = |span: &Length, rise: &Length| of_span_and_rise(span, rise).1;
    let [one, other] = [low, high].map(|rise| radius(long, rise));
    [radius(short, nearest), if one.exceeds(&other) { one } else { other }]
}

/// The half opening of a span, the flatter arc, or of a rise at this radius; nothing if there is neither.
pub fn half_opening_of(
    [span, rise]: [Option<&Length>; 2],
    radius: &Length,
) -> Option<Result<ExactNumber, MeasureError>> {
    let square = |x: &BigRational| x * x;
    // Squares of `R cos(alpha)` and of `R sin(alpha)`.
    let (name, chord, height, is_obtuse) = match (span, rise) {
        (Some(span), _) => {
            ("span", span, square(&radius.0) - square(&(&span.0 / BigInt::from(2))), false)
        }
        (None, rise) => {
            let rise = rise?;
            ("rise", rise, square(&(&radius.0 - &rise.0)), exceeds(&rise.0, &radius.0))
        }
    };
    let (half, zero) = (square(&radius.0) - &height, BigRational::from(BigInt::ZERO));
    if height < zero || half <= zero {
        return Some(Err(MeasureError::Chord {
            chord: format!("{name} {chord}"),
            radius: radius.to_string(),
            diameter: Length(&radius.0 * BigInt::from(2)).to_string(),
        }));
    }
    let cotangent = height / half;
    let q = if is_obtuse { cotangent } else { -cotangent };
    Some(Ok(ExactNumber::arctangent_of_root(q)))
}

/// The radius of a span or a rise at a half opening, where that is known exactly.
pub fn radius_at(half_opening: &ExactNumber, [span, rise]: [Option<&Length>; 2]) -> Option<Length> {
    let [sine, cosine] = rational_sine_and_cosine(half_opening);
    let one = BigRational::from(BigInt::from(1));
    match (span, rise) {
        (Some(span), _) => sine.map(|sine| Length(&span.0 / (sine * BigInt::from(2)))),
        (None, Some(rise)) => cosine.map(|cosine| Length(&rise.0 / (one - cosine))),
        (None, None) => None,
    }
}

impl Measures {
    /// The radius of a circle of the arch; with the weight of its material and its depth there are forces too.
    pub fn new(circle: Circle, radius: Length, loaded: Option<(UnitWeight, Length)>) -> Self {
        Self { circle, radius, loaded, unit: LengthUnit::default() }
    }

    /// Measures with another unit, in which they are told.
    pub fn told_in(self, unit: LengthUnit) -> Self {
        Self { unit, ..self }
    }

    /// The unit in which lengths are told, metres unless one was given.
    pub fn unit(&self) -> LengthUnit {
        self.unit
    }

    /// The circle that is measured.
    pub fn circle(&self) -> Circle {
        self.circle
    }

    /// The radius of that circle, in metres.
    pub fn radius(&self) -> ExactNumber {
        ExactNumber::rational(self.radius.0.clone())
    }

    /// The span and the rise of that circle at the half opening `alpha` (rad), in metres.
    pub fn span_and_rise<E: Engine>(&self, alpha: &E, bits: u32) -> [E; 2] {
        let radius: E = self.radius().enclosure(bits);
        // Nothing cancels in the rise of half the angle.
        let (sin, cos) = (alpha.clone() / alpha.int(2)).sin_cos();
        let chord = radius.int(2) * radius * &sin;
        [chord.int(2) * &chord * cos, chord * sin]
    }

    /// Span and rise, where they are rational.
    pub fn exact_span_and_rise(&self, half_opening: &ExactNumber) -> [Option<ExactNumber>; 2] {
        let radius = &self.radius.0;
        let [sine, cosine] = rational_sine_and_cosine(half_opening);
        let span = sine.map(|sine| radius * BigInt::from(2) * sine);
        let rise = cosine.map(|cosine| radius * (BigRational::from(BigInt::from(1)) - cosine));
        [span, rise].map(|length| length.map(ExactNumber::rational))
    }

    /// Tells whether forces can be told.
    pub fn has_forces(&self) -> bool {
        self.loaded.is_some()
    }

    /// `eta = t/r`, at most 2: there the intrados is a point.
    pub fn thickness(&self, thickness: &Length) -> Result<ExactNumber, MeasureError> {
        let (t, radius) = (&thickness.0, &self.radius.0);
        // At twice the radius of the centreline the intrados has none.
        let most = match self.circle {
            Circle::Intrados => None,
            Circle::Centreline => Some((radius * BigInt::from(2), "diameter")),
            Circle::Extrados => Some((radius.clone(), "radius")),
        };
        match most.filter(|(most, _)| exceeds(t, most)) {
            Some((most, rule)) => Err(MeasureError::Thickness {
                thickness: thickness.to_string(),
                circle: self.circle.name(),
                most: Length(most).to_string(),
                rule,
            }),
            None => {
                let half = BigRational::new(self.circle.to_centreline().into(), 2.into());
                Ok(ExactNumber::rational(t / (radius + t * half)))
            }
        }
    }

    /// The radius of the centreline in metres, where it is known exactly: of a given thickness `eta`, or measured
    /// itself.
    pub fn exact_radius(&self, eta: Option<&ExactNumber>) -> Option<ExactNumber> {
        let one = || BigRational::from(BigInt::from(1));
        let half = BigRational::new(self.circle.to_centreline().into(), 2.into());
        let outwards = match (self.circle, eta) {
            (Circle::Centreline, _) => one(),
            (_, Some(eta)) => one() - half * eta.factor(),
            (_, None) => return None,
        };
        let has_intrados = outwards > BigInt::ZERO.into();
        has_intrados.then(|| ExactNumber::rational(&self.radius.0 / outwards))
    }

    /// `w r` in kN at a thickness `eta`, the unit of the thrust `h`: it grows with the radius and the thickness, up to
    /// `eta = 2`.
    pub fn exact_force(&self, eta: &ExactNumber) -> Option<ExactNumber> {
        let ((unit, depth), radius) = self.loaded.as_ref().zip(self.exact_radius(Some(eta)))?;
        let area = radius.factor() * radius.factor() * eta.factor();
        Some(ExactNumber::rational(&unit.0 * &depth.0 * area))
    }

    /// The sizes of an arch of thickness `eta` and half opening `alpha` (rad), in numbers of `bits` bits.
    pub fn sizes<E: Engine>(&self, eta: &E, alpha: &E, bits: u32) -> Sizes<E> {
        let number = |x: &BigRational| ExactNumber::rational(x.clone()).enclosure::<E>(bits);
        let radius = self.circle.centreline(number(&self.radius.0), eta);
        let thickness = eta.clone() * &radius;
        let loaded = self.loaded.as_ref();
        let unit = |(weight, depth): &(UnitWeight, Length)| {
            number(&weight.0) * number(&depth.0) * &thickness * &radius
        };
        let force = loaded.map(unit);
        let weight = force.clone().map(|force| force * alpha.int(2) * alpha);
        Sizes { radius, thickness, force, weight }
    }
}

/// Sizes of an arch.
#[derive(Clone, Debug)]
pub struct Sizes<E> {
    /// The radius of the centreline, m.
    pub radius: E,
    /// The thickness, m.
    pub thickness: E,
    /// `w r`, kN: the unit of the thrust `h`.
    pub force: Option<E>,
    /// The weight of the whole arch, kN.
    pub weight: Option<E>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Enclosure, Field, Form, Real};

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

    #[test]
    fn span_and_rise_are_those_of_the_arch() {
        let (alpha, radius) = of_span_and_rise(&length("10m"), &length("3m"));
        let alpha: AstroInterval = alpha.enclosure(200);
        let (sin, cos) = alpha.sin_cos();
        let radius: AstroInterval = ExactNumber::rational(radius.0).enclosure(200);
        let ten = radius.clone() * sin * radius.int(2);
        assert!(ten.overlaps(&ten.int(10)));
        let three = radius.clone() - radius * cos;
        assert!(three.overlaps(&three.int(3)));
        let (half_turn, radius) = of_span_and_rise(&length("8m"), &length("400cm"));
        assert_eq!((half_turn.form(), radius), (Form::TimesPi, length("4m")));
    }

    /// The exact span and rise are those of the sine and the cosine, wherever there are any.
    #[test]
    fn span_and_rise_are_exact_where_they_are_rational() {
        let of = |radius: &str| Measures::new(Circle::Intrados, length(radius), None);
        let rational =
            [("2atan(3/5)", 2), ("2atan(5)", 2), ("90deg", 2), ("30deg", 1), ("5pi/6", 1)];
        let others = [("pi/3", 1), ("120deg", 1), ("45deg", 0), ("1", 0), ("1/6", 0)];
        for (text, count) in rational.into_iter().chain(others) {
            let measures = of("1.25m");
            let alpha: ExactNumber = text.parse().unwrap();
            let exact = measures.exact_span_and_rise(&alpha);
            assert_eq!(exact.iter().flatten().count(), count, "{text}");
            let alpha: AstroInterval = alpha.enclosure(100);
            for (length, exact) in measures.span_and_rise(&alpha, 100).iter().zip(&exact) {
                let exact = exact.as_ref().map(|x| x.enclosure::<AstroInterval>(100));
                assert!(exact.is_none_or(|exact| exact.overlaps(length)), "{text}");
            }
        }
        let (alpha, radius) = of_span_and_rise(&length("10m"), &length("3m"));
        let given = Measures::new(Circle::Intrados, radius, None).exact_span_and_rise(&alpha);
        assert_eq!(given.map(|x| x.unwrap().to_string()), ["10", "3"]);
    }

    #[test]
    fn the_thickness_goes_there_and_back() {
        for circle in [Circle::Intrados, Circle::Centreline, Circle::Extrados] {
            let loading = Some(("24kN/m3".parse().unwrap(), length("2m")));
            let measures = Measures::new(circle, length("5m"), loading);
            let eta: AstroInterval = measures.thickness(&length("60cm")).unwrap().enclosure(100);
            let sizes = measures.sizes(&eta, &eta.int(1), 100);
            let three_fifths = eta.ratio(3, 5);
            assert!(sizes.thickness.overlaps(&three_fifths), "{circle:?}");
            let half = three_fifths.clone() * three_fifths.ratio(circle.to_centreline(), 2);
            assert!(sizes.radius.overlaps(&(half + three_fifths.int(5))), "{circle:?}");
            // 24 kN/m3 x 2 m x 0.6 m x r, and twice the half opening of one radian.
            let force = sizes.radius.clone() * sizes.radius.ratio(144, 5);
            assert!(sizes.force.as_ref().unwrap().overlaps(&force));
            assert!(sizes.weight.unwrap().overlaps(&(force.clone() + force)));
        }
    }

    #[test]
    fn a_thickness_that_is_not_possible_is_refused() {
        let at = |circle, thickness: &str| {
            Measures::new(circle, length("5m"), None).thickness(&length(thickness))
        };
        assert!(at(Circle::Centreline, "10m").is_ok() && at(Circle::Centreline, "10.1m").is_err());
        assert!(at(Circle::Extrados, "5m").is_ok() && at(Circle::Extrados, "5001mm").is_err());
        assert!(at(Circle::Extrados, "100m").unwrap_err().to_string().contains("extrados"));
        assert!(at(Circle::Intrados, "1000m").is_ok(), "never twice its centreline");
    }
}
