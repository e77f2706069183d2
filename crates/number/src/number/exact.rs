//! Exact input: decimals, fractions, multiples of pi and arctangents, read as text and never rounded.

mod sine;

pub use sine::{rational_sine_and_cosine, sine_and_cosine};

use super::range::{TELL_OF_RANGES, is_range};
use super::spelt::over_twos;
use super::unit::{AngleUnit, minutes, unit};
use super::{
    Angle, Decimal, Dyadic, Engine, Field, ParseDecimalError, as_text, decimal, is_plain, says,
    shown, shown_as_text, spelt,
};
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::str::FromStr;

/// A number given exactly.
#[derive(Clone)]
pub struct ExactNumber {
    /// The rational number of its form.
    factor: BigRational,
    form: Form,
    /// Text as it was given.
    text: String,
}

/// Form of an exact number, made of a rational number `q`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// `q`.
    Rational,
    /// `q pi`.
    TimesPi,
    /// `2 atan(q)`: the half opening of an arch whose rise is `q` times half its span.
    TwiceArctangent,
    /// The angle between 0 and pi whose cotangent has the square `|q|`, above a right angle where `q` is above zero, so
    /// that it rises with `q`: the half opening of an arch by its radius and its span, or its rise.
    ArctangentOfRoot,
}

impl Field for BigRational {
    fn int(&self, n: i32) -> Self {
        BigInt::from(n).into()
    }
}

/// Texts longer than this are refused; it is far more than any number of digits worth giving.
const MAX_LENGTH: usize = 20_000;
/// Exponents beyond this are refused.
const MAX_EXPONENT: u32 = 1_000;
/// Bits of the largest exponent, and a little more.
const MAX_BITS: u64 = 3_330;

/// Reason why a text is not an exact number.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParseExactError {
    /// None of the forms that are read.
    Syntax(String),
    /// None of the forms in which a friction is read.
    Friction(String),
    /// Pi behind the line of a fraction, which is not told from below it.
    PiBelow(String),
    /// A range, where one value is read.
    Several(String),
    /// A comma instead of the point.
    Comma(String),
    /// A fraction with nothing below.
    DivisionByZero(String),
    /// Too long to be meant.
    Length(usize),
    /// Too large or too small to be meant.
    Range(String),
    /// Degrees of a multiple of pi.
    Units(String),
}

says!(ParseExactError {
    Self::Syntax(text) =>
        "'{text}' is not a number: give a decimal (0.1), a fraction (1/3), a multiple of pi (2pi/3), or for an \
         angle degrees (80deg)";
    Self::Friction(text) => "'{text}' is not a friction: give a coefficient (0.6, 3/5, inf) or an angle (31deg)";
    Self::PiBelow(text) => "'{text}' has pi behind the line of the fraction: write it above the line, 3pi/4";
    Self::Several(text) =>
        "'{text}' is a range: one value is read here; of ranges tell {TELL_OF_RANGES}";
    Self::Comma(text) => "'{text}' has a comma; give the decimals behind a point (1.5)";
    Self::DivisionByZero(text) => "'{text}' divides by zero";
    Self::Length(length) => "a number of {length} characters is too long: at most {MAX_LENGTH} are read";
    Self::Range(text) => "'{text}' is out of range: sizes from 1e-{MAX_EXPONENT} to below 1e{MAX_EXPONENT} are read";
    Self::Units(text) => "'{text}' has two units";
});

impl ExactNumber {
    /// An exact rational number.
    pub fn rational(factor: BigRational) -> Self {
        let text = factor.to_string();
        Self { factor, form: Form::Rational, text }
    }

    /// Text of the number, of a fraction as the decimal that it is where that ends soon: `1/8` is a date to a
    /// spreadsheet.
    pub fn in_decimals(&self) -> String {
        const LONGEST: usize = 20;
        // Over so many twos alone a decimal has as many fives, which are more digits.
        const MOST_TWOS: u64 = 29;
        let below = self.factor.denom();
        let twos = below.trailing_zeros().unwrap_or(0);
        match self.form {
            Form::Rational if twos > MOST_TWOS && below.bits() == twos + 1 => self.text.clone(),
            Form::Rational if self.text.contains('/') => {
                let ended = decimal(&self.factor);
                if ended.len() > LONGEST { self.text.clone() } else { ended }
            }
            _ => self.text.clone(),
        }
    }

    /// `2 atan(q)` in radians; a right angle is [one part of pi](Form::TimesPi), as every angle is that is both.
    pub fn twice_arctangent(q: BigRational) -> Self {
        let text = format!("2atan({q})");
        // Of the rational multiples of pi below it only this one has a rational tangent of its half (Niven).
        match q == BigRational::from(BigInt::from(1)) {
            true => Self { factor: q / BigInt::from(2), form: Form::TimesPi, text: "pi/2".into() },
            false => Self { factor: q, form: Form::TwiceArctangent, text },
        }
    }

    /// The angle whose cotangent has the square `|q|`, acute where `q` is below zero and obtuse above; a part of pi, or
    /// twice an arctangent, wherever it is one.
    pub fn arctangent_of_root(q: BigRational) -> Self {
        let ratio = |n: i32, d: i32| BigRational::new(n.into(), d.into());
        let is_obtuse = q.numer().sign() == Sign::Plus;
        let square = if is_obtuse { q.clone() } else { -q.clone() };
        // Of the rational multiples of pi only these have a rational square of the cotangent (Niven).
        let turns = [(0, 1, 2), (1, 1, 4), (3, 1, 6)].map(|(n, a, b)| (ratio(n, 1), ratio(a, b)));
        let turns = turns.into_iter().chain([(ratio(1, 3), ratio(1, 3))]);
        if let Some((_, turn)) = turns.into_iter().find(|(of, _)| *of == square) {
            let factor = if is_obtuse { ratio(1, 1) - turn } else { turn };
            let text = format!("{}pi/{}", factor.numer(), factor.denom());
            return Self { factor, form: Form::TimesPi, text };
        }
        // `tan(alpha/2) = 1/sin(alpha) - cot(alpha)`.
        if let (Some(cotangent), Some(slant)) = (root(&square), root(&(&square + ratio(1, 1)))) {
            let half = if is_obtuse { slant + cotangent } else { slant - cotangent };
            return Self::twice_arctangent(half);
        }
        let text = format!("{}atan(√({}))", if is_obtuse { "pi-" } else { "" }, square.recip());
        Self { factor: q, form: Form::ArctangentOfRoot, text }
    }

    /// The number of this form of the fraction `numerator/denominator`; `None` if the denominator is zero.
    pub fn fraction(numerator: BigInt, denominator: BigInt, form: Form) -> Option<Self> {
        if denominator == BigInt::ZERO {
            return None;
        }
        // Reducing costs far more than anything that is done with it.
        let factor = BigRational::new_raw(numerator, denominator);
        let (above, below) = (factor.numer(), factor.denom());
        let text = match form {
            Form::Rational => format!("{above}/{below}"),
            Form::TimesPi => format!("{above}*pi/{below}"),
            Form::TwiceArctangent if above == below => {
                return Some(Self::twice_arctangent(factor.reduced()));
            }
            Form::TwiceArctangent => format!("2atan({above}/{below})"),
            Form::ArctangentOfRoot => return Some(Self::arctangent_of_root(factor.reduced())),
        };
        Some(Self { factor, form, text })
    }

    /// The angle of this number of degrees, in radians: `value pi / 180`. For a rational number; every other form
    /// has its unit already.
    pub fn degrees(&self) -> Self {
        let factor = &self.factor / BigInt::from(180);
        Self { factor, form: Form::TimesPi, text: format!("{}deg", self.text) }
    }

    /// The number of degrees of an angle in radians, where it is rational.
    pub fn in_degrees(&self) -> Option<Self> {
        (self.form == Form::TimesPi).then(|| Self::rational(&self.factor * BigInt::from(180)))
    }

    /// Tells whether the number was given in degrees.
    pub fn is_in_degrees(&self) -> bool {
        self.text.ends_with("deg")
    }

    /// Form of the number, made of its [factor](Self::factor).
    pub fn form(&self) -> Form {
        self.form
    }

    /// Tells whether the number is its factor.
    pub fn is_rational(&self) -> bool {
        self.form == Form::Rational
    }

    /// The rational number of its [form](Self::form).
    pub fn factor(&self) -> &BigRational {
        &self.factor
    }

    /// An enclosure in numbers of `bits` bits, at least one.
    pub fn enclosure<E: Engine>(&self, bits: u32) -> E {
        let factor: E = self.factor_enclosure(bits);
        match self.form {
            Form::Rational => factor,
            Form::TimesPi => factor.pi() * factor,
            Form::TwiceArctangent => factor.arctangent(bits as usize) * factor.int(2),
            Form::ArctangentOfRoot => {
                let is_obtuse = self.factor.numer().sign() == Sign::Plus;
                let square = if is_obtuse { factor } else { factor.int(0) - factor };
                let angle = (square.int(1) / square).sqrt().arctangent(bits as usize);
                if is_obtuse { angle.pi() - angle } else { angle }
            }
        }
    }

    /// The angle of so many radians. Of a half of it the tangent is known where it is twice an arctangent: `sin = 2 q /
    /// (1 + q²)`, `cos = (1 - q²) / (1 + q²)`.
    pub fn angle<E: Engine>(&self, bits: u32) -> Angle<E> {
        let rad: E = self.enclosure(bits);
        if self.form != Form::TwiceArctangent {
            return Angle::new(rad);
        }
        let (q, one) = (self.factor_enclosure::<E>(bits), rad.int(1));
        let below = one.clone() + &q.square();
        let (sin, cos) = (q.int(2) * &q / &below, (one - &q.square()) / &below);
        Angle { rad, sin, cos }
    }

    fn factor_enclosure<E: Engine>(&self, bits: u32) -> E {
        let integer = |x: &BigInt| {
            let (sign, words) = x.to_u64_digits();
            E::exact(&Dyadic::new(sign == Sign::Minus, words, 0), bits as usize)
        };
        let numerator = integer(self.factor.numer());
        match self.factor.is_integer() {
            true => numerator,
            false => numerator / integer(self.factor.denom()),
        }
    }
}

#[cfg(feature = "mpfr")]
mod mpfr {
    use super::{BigInt, BigRational, ExactNumber, Sign};
    use crate::number::nearest_double;
    use rug::integer::Order;
    use rug::{Integer, Rational};

    impl ExactNumber {
        /// The number as one of GMP.
        pub fn to_rational(&self) -> Rational {
            let integer = |x: &BigInt| {
                let (sign, words) = x.to_u64_digits();
                let size = Integer::from_digits(&words, Order::Lsf);
                if sign == Sign::Minus { -size } else { size }
            };
            Rational::from((integer(self.factor.numer()), integer(self.factor.denom())))
        }

        /// The double nearest to it, ties to even: what a program in double precision makes of it at best.
        /// `None` beyond the largest double.
        pub fn nearest_double(&self) -> Option<f64> {
            nearest_double(self.enclosure(0), |bits| self.enclosure(bits))
        }
    }

    impl From<Rational> for ExactNumber {
        fn from(value: Rational) -> Self {
            Self::from(&value)
        }
    }

    impl From<&Rational> for ExactNumber {
        fn from(value: &Rational) -> Self {
            let integer = |x: &Integer| {
                let sign = if *x < 0 { Sign::Minus } else { Sign::Plus };
                BigInt::from_slice(sign, &x.to_digits::<u32>(Order::Lsf))
            };
            // It is in lowest terms there.
            Self::rational(BigRational::new_raw(integer(value.numer()), integer(value.denom())))
        }
    }
}

/// The text says which number it is; to compare the fractions themselves could take very long.
impl PartialEq for ExactNumber {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text && self.form == other.form
    }
}

impl Eq for ExactNumber {}

impl Hash for ExactNumber {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.text.hash(state);
        self.form.hash(state);
    }
}

impl fmt::Display for ExactNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

as_text!(ExactNumber);
shown_as_text!(ExactNumber);

impl From<i32> for ExactNumber {
    fn from(value: i32) -> Self {
        Self::rational(BigInt::from(value).into())
    }
}

impl TryFrom<f64> for ExactNumber {
    type Error = ParseExactError;

    /// The double itself: 0.1 is not one tenth. What is not finite is refused.
    fn try_from(value: f64) -> Result<Self, Self::Error> {
        if !value.is_finite() {
            return Err(ParseExactError::Syntax(value.to_string()));
        }
        let (mantissa, power, sign) = num_traits::float::FloatCore::integer_decode(value);
        let whole = (BigInt::from(mantissa) * sign) << power.max(0);
        Ok(Self::rational(over_twos(whole, power.min(0).unsigned_abs().into())))
    }
}

impl FromStr for ExactNumber {
    type Err = ParseExactError;

    /// Reads `0.1`, `1e-30`, `1/3`, `pi`, `pi/2`, `2pi/3`, `0.8*pi`, radians by name, `1.5rad`, degrees:
    /// `80deg`, `80°`, `80 degrees`, all of which are shown as `80deg`, `80°30'15"`, `88gon`, and `2atan(3/5)`,
    /// `atan(√(5/3))` and `pi-atan(√(5/3))` with a number above zero; numbers as other programs [spell](spelt) them.
    ///
    /// ```
    /// use couplet_number::number::ExactNumber;
    /// let third: ExactNumber = "1/3".parse().unwrap();
    /// assert!(third.is_rational());
    /// let [degrees, radians]: [ExactNumber; 2] = ["120deg", "2pi/3"].map(|x| x.parse().unwrap());
    /// assert_eq!(degrees.factor(), radians.factor());
    /// ```
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text.len() > MAX_LENGTH {
            return Err(ParseExactError::Length(text.len()));
        }
        if is_plain(text) {
            return Self::without_unit(text, text);
        }
        let given = text;
        let text = &*spelt(given);
        if let Some(parts) = minutes(text) {
            return Self::of_minutes(parts).ok_or_else(|| ParseExactError::Syntax(shown(given)));
        }
        let (number, unit) = unit(text);
        let tangent = number.strip_prefix("2atan(").and_then(|rest| rest.strip_suffix(')'));
        let number = match (tangent, root_of_tangent(number)) {
            (Some(tangent), _) => Self::of_tangent(tangent, text)?,
            (_, Some((square, is_obtuse))) => {
                let square = Self::positive(square, text)?.recip();
                Self::arctangent_of_root(if is_obtuse { square } else { -square })
            }
            _ => Self::without_unit(number, given)?,
        };
        match (unit, number.is_rational()) {
            (AngleUnit::None, _) | (AngleUnit::Radians, true) => Ok(number),
            (AngleUnit::Degrees, true) => Ok(number.degrees()),
            (AngleUnit::Gons, true) => {
                Ok(Self::ended(number.factor * BigRational::new(9.into(), 10.into())).degrees())
            }
            _ => Err(ParseExactError::Units(shown(text))),
        }
    }
}

impl ExactNumber {
    /// A rational number whose text is a decimal, if it ends.
    fn ended(factor: BigRational) -> Self {
        Self { text: decimal(&factor), ..Self::rational(factor) }
    }

    /// An angle of whole degrees, whole minutes and seconds, both below 60.
    fn of_minutes([degrees, minutes, seconds]: [&str; 3]) -> Option<Self> {
        let part = |text: &str| {
            let number = Self::without_unit(text, text).ok().filter(Self::is_rational)?;
            let is_below = *number.factor() < BigInt::from(60).into();
            text.starts_with(|c: char| c.is_ascii_digit())
                .then_some(number.factor)
                .filter(|_| is_below)
        };
        let (whole, minutes, sixty) = (integer(degrees)?, integer(minutes)?, BigInt::from(60));
        let minutes = part(&minutes.to_string())? + part(seconds)? / &sixty;
        Some(Self::ended(minutes / sixty + whole).degrees())
    }

    /// Twice the arctangent of a rational number above zero; `given` is the whole text.
    fn of_tangent(text: &str, given: &str) -> Result<Self, ParseExactError> {
        let q = Self::positive(text, given)?;
        Ok(Self { text: given.trim().to_owned(), ..Self::twice_arctangent(q) })
    }

    /// A rational number above zero; `given` is the whole text.
    fn positive(text: &str, given: &str) -> Result<BigRational, ParseExactError> {
        let q = Self::without_unit(text, given)?;
        let is_positive = q.is_rational() && q.factor.numer().sign() == Sign::Plus;
        is_positive.then_some(q.factor).ok_or_else(|| ParseExactError::Syntax(shown(given)))
    }

    /// A number without its unit; `given` is the whole text.
    fn without_unit(text: &str, given: &str) -> Result<Self, ParseExactError> {
        let shown = || shown(given);
        let syntax = || match text.contains(',') {
            _ if is_range(given) => ParseExactError::Several(shown()),
            true => ParseExactError::Comma(shown()),
            false => ParseExactError::Syntax(shown()),
        };
        let (numerator, denominator) = match text.split_once('/') {
            Some((numerator, denominator)) => (numerator, Some(denominator)),
            None => (text, None),
        };
        let (numerator, times_pi) =
            match numerator.strip_suffix("pi").or(numerator.strip_suffix('π')) {
                Some(rest) => (rest.strip_suffix('*').unwrap_or(rest), true),
                None => (numerator, false),
            };
        let form = if times_pi { Form::TimesPi } else { Form::Rational };
        let read = |text: &str| {
            let decimal: Decimal = text.parse().map_err(|error| match error {
                ParseDecimalError::Exponent(_) => ParseExactError::Range(shown()),
                ParseDecimalError::Syntax(_) => syntax(),
            })?;
            let sizes = 1 - i64::from(MAX_EXPONENT)..=i64::from(MAX_EXPONENT);
            let in_range = sizes.contains(&decimal.magnitude())
                && decimal.exponent().unsigned_abs() <= (MAX_EXPONENT as usize + MAX_LENGTH) as u64;
            match in_range || decimal.digits().is_empty() {
                true => Ok(rational(&decimal)),
                false => Err(ParseExactError::Range(shown())),
            }
        };
        let mut factor = match numerator {
            "" if times_pi => BigInt::from(1).into(),
            "-" if times_pi => BigInt::from(-1).into(),
            number => read(number)?,
        };
        if let Some(denominator) = denominator {
            if denominator.ends_with("pi") || denominator.ends_with('π') {
                return Err(ParseExactError::PiBelow(shown()));
            }
            let denominator = integer(denominator).ok_or_else(syntax)?;
            if denominator.sign() == Sign::NoSign {
                return Err(ParseExactError::DivisionByZero(shown()));
            }
            let twos = denominator.trailing_zeros().unwrap_or(0);
            factor = match factor.is_integer() && denominator == BigInt::from(1) << twos {
                true => over_twos(factor.to_integer(), twos),
                false => factor / denominator,
            };
        }
        // A division can leave the range too: 1e-1000/1000….
        let (above, below) = (factor.numer().bits(), factor.denom().bits());
        if above != 0 && above.abs_diff(below) > MAX_BITS {
            return Err(ParseExactError::Range(shown()));
        }
        Ok(Self { factor, form, text: text.to_owned() })
    }
}

/// The square root of a number that is not negative and in lowest terms, where it is rational.
pub fn root(square: &BigRational) -> Option<BigRational> {
    let whole = |x: &BigInt| Some(x.sqrt()).filter(|root| root * root == *x);
    Some(BigRational::new(whole(square.numer())?, whole(square.denom())?))
}

/// Text below the root of `atan(√(5/3))`, and whether it is the angle beside it, `pi-atan(√(5/3))`.
fn root_of_tangent(text: &str) -> Option<(&str, bool)> {
    let (text, is_obtuse) = match text.strip_prefix("pi-") {
        Some(rest) => (rest, true),
        None => (text, false),
    };
    let below = text.strip_prefix("atan(√(").or_else(|| text.strip_prefix("atan(sqrt("))?;
    Some((below.strip_suffix("))")?, is_obtuse))
}

/// The exact value of a decimal.
fn rational(decimal: &Decimal) -> BigRational {
    if let Some(short) = short_rational(decimal) {
        return short;
    }
    let Some(digits) = integer(decimal.digits()) else { return BigInt::ZERO.into() };
    let digits = if decimal.is_negative() { -digits } else { digits };
    let scale = BigInt::from(10).pow(decimal.exponent().unsigned_abs() as u32);
    match decimal.exponent() < 0 {
        true => BigRational::new(digits, scale),
        false => (digits * scale).into(),
    }
}

/// Rational number of a decimal fraction that fits words: what it has in common with its power of ten is
/// found by counting twos and fives, which is much cheaper than a common divisor of long integers.
fn short_rational(decimal: &Decimal) -> Option<BigRational> {
    let places = u32::try_from(-decimal.exponent()).ok().filter(|places| *places < 19)?;
    let mut numerator: u64 = decimal.digits().parse().ok()?;
    let twos = numerator.trailing_zeros().min(places);
    numerator >>= twos;
    let mut denominator = 5u64.pow(places) << (places - twos);
    for _ in 0..places {
        if !numerator.is_multiple_of(5) {
            break;
        }
        (numerator, denominator) = (numerator / 5, denominator / 5);
    }
    let sign = if decimal.is_negative() { Sign::Minus } else { Sign::Plus };
    let numerator = BigInt::from_biguint(sign, numerator.into());
    Some(BigRational::new_raw(numerator, denominator.into()))
}

/// An integer of decimal digits and nothing else.
fn integer(digits: &str) -> Option<BigInt> {
    let is_integer = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    is_integer.then(|| digits.parse().ok())?
}

#[cfg(test)]
mod tests;
