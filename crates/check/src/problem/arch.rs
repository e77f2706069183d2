//! An arch, as it is asked about.

use crate::arch::joint::Grip;
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::number::{
    AstroInterval, DoubleBall, Engine, ExactNumber, Form, ParseExactError, Ternary, is_angle,
    is_plain, says, shown, shown_as_text,
};
use num_bigint::Sign;
use num_rational::BigRational;
use serde::de::Error;
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

/// The friction of the joints.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Friction {
    /// `mu`.
    Coefficient(ExactNumber),
    /// `phi = atan(mu)`, rad.
    Angle(ExactNumber),
    /// The friction has no limit.
    Infinite,
}

/// An arch whose thickness is asked for.
///
/// ```
/// use couplet_check::problem::Arch;
/// let arch = Arch::parse("milankovitch", "80deg", "0.6").unwrap();
/// assert_eq!(arch.to_string(), "milankovitch, half opening 80deg, friction 0.6");
/// assert!(Arch::parse("milankovitch", "180deg", "0.6").is_err(), "not below pi");
/// assert!(std::collections::HashSet::from([arch.clone()]).contains(&arch));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Arch {
    weight: SelfWeight,
    half_opening: ExactNumber,
    friction: Friction,
}

/// Reason why an arch is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ArchError {
    /// The half opening is not between 0 and pi.
    HalfOpening(ExactNumber),
    /// The friction is negative.
    Friction(String),
    /// The friction angle is not between 0 and a right angle.
    FrictionAngle(String),
    /// The self-weight model has no such name.
    SelfWeight(String),
    /// A text is not an exact number.
    Number(ParseExactError),
}

says!(ArchError {
    Self::HalfOpening(angle) => "the half opening {angle} is not between 0 and pi (180deg){}", meant_degrees(angle);
    Self::Friction(friction) => "the friction {friction} is negative";
    Self::FrictionAngle(angle) =>
        "the friction angle {angle} is not between 0 and pi/2 (90deg){}", meant_friction_angle(angle);
    Self::SelfWeight(name) => "'{name}' is not a self-weight model: heyman or milankovitch";
} from {
    ParseExactError => Self::Number;
});

impl ArchError {
    /// Suggestion of the number that a refused one may have been meant to be; empty if nothing is near.
    pub fn hint(&self) -> String {
        match self {
            Self::HalfOpening(angle) => meant_degrees(angle),
            Self::FrictionAngle(angle) => meant_friction_angle(angle),
            Self::Friction(_) | Self::SelfWeight(_) | Self::Number(_) => String::new(),
        }
    }
}

/// Spellings of unlimited friction, in small letters.
const INFINITE: [&str; 5] = ["inf", "infinity", "infinite", "unlimited", "∞"];

impl FromStr for Friction {
    type Err = ParseExactError;

    /// Reads a coefficient (`0.6`), an angle with its unit (`31deg`, `0.54rad`) or as the argument of a
    /// tangent (`tan(0.54)`, `tan(31deg)`), or `inf`, also as `infinity`, `unlimited` and `∞`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        if is_plain(text) {
            return text.parse().map(Self::Coefficient);
        }
        let is_infinite = INFINITE.contains(&text.trim_start_matches('+').to_lowercase().as_str());
        let tangent = text.strip_prefix("tan(").and_then(|rest| rest.strip_suffix(')'));
        let friction = match tangent {
            Some(angle) => angle.parse().map(Self::Angle),
            None if is_infinite => Ok(Self::Infinite),
            None if is_angle(text) => text.parse().map(Self::Angle),
            None => text.parse().map(Self::Coefficient),
        };
        friction.map_err(|error| match error {
            ParseExactError::Syntax(shown) => ParseExactError::Friction(shown),
            error => error,
        })
    }
}

impl Friction {
    /// Tells whether nothing resists sliding.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Coefficient(x) | Self::Angle(x) => x.factor().numer().bits() == 0,
            Self::Infinite => false,
        }
    }

    /// The friction as the ratio that a joint asks for, in numbers of `bits` bits.
    pub fn grip<E: Engine>(&self, bits: u32) -> Grip<E> {
        let one = E::zero(bits as usize).int(1);
        match self {
            Self::Coefficient(mu) => Grip { shear: one, normal: mu.enclosure(bits) },
            Self::Angle(phi) => {
                let (sin, cos) = phi.enclosure::<E>(bits).sin_cos();
                Grip { shear: cos, normal: sin }
            }
            Self::Infinite => Grip { shear: one.int(0), normal: one },
        }
    }
}

impl fmt::Display for Friction {
    /// The coefficient, `tan(angle)` or `inf`: what [`Friction::from_str`] reads.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coefficient(mu) => mu.fmt(f),
            Self::Angle(phi) => write!(f, "tan({phi})"),
            Self::Infinite => f.write_str("inf"),
        }
    }
}

impl Friction {
    /// The friction, if it may be that of an arch; a right angle is infinite.
    pub(super) fn checked(self, in_doubles: bool) -> Result<Self, ArchError> {
        match self {
            Self::Coefficient(mu) if sign(&mu) == Sign::Minus => {
                Err(ArchError::Friction(mu.to_string()))
            }
            friction if friction.is_of_right_angle() => Ok(Self::Infinite),
            Self::Angle(phi) if !is_between(&phi, true, 2, in_doubles) => {
                Err(ArchError::FrictionAngle(phi.to_string()))
            }
            friction => Ok(friction),
        }
    }

    /// Tells whether it is the tangent of exactly a right angle.
    pub(crate) fn is_of_right_angle(&self) -> bool {
        matches!(self, Self::Angle(phi) if phi.form() == Form::TimesPi && *phi.factor() == ratio(1, 2))
    }
}

/// Tells whether a thickness is above 0 and at most the physical limit 2.
pub fn is_thickness(thickness: &ExactNumber) -> bool {
    let (zero, limit) = (ratio(0, 1), ratio(2, 1));
    thickness.is_rational() && *thickness.factor() > zero && *thickness.factor() <= limit
}

impl Arch {
    /// An arch, if its half opening is in `(0, pi)`, in radians, and its friction coefficient in
    /// `[0, inf)` or its friction angle in `[0, pi/2]`, in radians; pi/2 is [`Friction::Infinite`].
    pub fn new(
        weight: SelfWeight,
        half_opening: ExactNumber,
        friction: Friction,
    ) -> Result<Self, ArchError> {
        Self::new_with(weight, half_opening, friction, true)
    }

    /// [`Arch::new`] with balls of doubles or, for a checker that need not trust them then, without.
    pub(crate) fn new_with(
        weight: SelfWeight,
        half_opening: ExactNumber,
        friction: Friction,
        in_doubles: bool,
    ) -> Result<Self, ArchError> {
        if !is_between(&half_opening, false, 1, in_doubles) {
            return Err(ArchError::HalfOpening(half_opening));
        }
        Ok(Self { weight, half_opening, friction: friction.checked(in_doubles)? })
    }

    /// An arch from the texts that the command line reads: `heyman` or `milankovitch`, a half opening
    /// in radians or degrees, a [`Friction`].
    pub fn parse(weight: &str, half_opening: &str, friction: &str) -> Result<Self, ArchError> {
        let unknown = || ArchError::SelfWeight(shown(weight));
        let weight = SelfWeight::named(weight).ok_or_else(unknown)?;
        Self::new(weight, half_opening.parse()?, friction.parse()?)
    }

    /// An arch from doubles, each taken as the number that it is: a half opening in radians, and a friction
    /// coefficient, of which an infinite one is unlimited friction. NaN is refused.
    ///
    /// ```
    /// use couplet_check::arch::SelfWeight;
    /// use couplet_check::problem::Arch;
    /// let arch = Arch::from_doubles(SelfWeight::Heyman, 1.25, 0.5).unwrap();
    /// assert_eq!(arch.to_string(), "heyman, half opening 5/4, friction 1/2");
    /// assert!(!Arch::from_doubles(SelfWeight::Heyman, 1.3, f64::INFINITY).unwrap().is_limited());
    /// assert!(Arch::from_doubles(SelfWeight::Heyman, f64::NAN, 0.5).is_err());
    /// ```
    pub fn from_doubles(
        weight: SelfWeight,
        half_opening: f64,
        friction: f64,
    ) -> Result<Self, ArchError> {
        let friction = match friction {
            f64::INFINITY => Friction::Infinite,
            mu => Friction::Coefficient(mu.try_into()?),
        };
        Self::new(weight, half_opening.try_into()?, friction)
    }

    /// Arch with the measures of this one and unlimited friction.
    pub fn unlimited(&self) -> Self {
        Self { friction: Friction::Infinite, ..self.clone() }
    }

    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        self.weight
    }

    /// The half opening as given.
    pub fn half_opening(&self) -> &ExactNumber {
        &self.half_opening
    }

    /// The friction as given.
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// Tells whether the friction is limited.
    pub fn is_limited(&self) -> bool {
        self.friction != Friction::Infinite
    }

    /// Given variables, in numbers of `bits` bits: the half opening and, if it is limited, the friction;
    /// everything else zero.
    pub fn given<E: Engine>(&self, bits: u32) -> Configuration<E> {
        let half_opening = self.half_opening.angle(bits);
        let given = Configuration { half_opening, ..Configuration::zero(&E::zero(bits as usize)) };
        match &self.friction {
            Friction::Coefficient(mu) => given.with(Unknown::Friction, mu.enclosure(bits)),
            Friction::Angle(phi) => {
                let (sin, cos) = phi.enclosure::<E>(bits).sin_cos();
                given.with(Unknown::Friction, sin / cos)
            }
            Friction::Infinite => given,
        }
    }
}

impl fmt::Display for Arch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { weight, half_opening, friction } = self;
        write!(f, "{weight}, half opening {half_opening}, friction {friction}")
    }
}

shown_as_text!(Arch);

impl Serialize for Arch {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut fields = to.serialize_map(Some(3))?;
        fields.serialize_entry("weight", &self.weight())?;
        fields.serialize_entry("half_opening", self.half_opening())?;
        fields.serialize_entry("friction", self.friction())?;
        fields.end()
    }
}

impl<'de> Deserialize<'de> for Arch {
    /// Reads an object of the texts that [`Arch::parse`] takes.
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let texts = BTreeMap::<String, String>::deserialize(from)?;
        let text = |name| texts.get(name).ok_or_else(|| D::Error::missing_field(name));
        let arch = Self::parse(text("weight")?, text("half_opening")?, text("friction")?);
        arch.map_err(|error: ArchError| D::Error::custom(error))
    }
}

/// Suggestion of the half opening that a refused one may have been meant to be, if it would be one in degrees.
fn meant_degrees(half_opening: &ExactNumber) -> String {
    // Hardly anybody means four times a radian.
    let in_degrees = half_opening.is_rational()
        && *half_opening.factor() >= ratio(4, 1)
        && is_between(&half_opening.degrees(), false, 1, true);
    match in_degrees {
        true => format!("; did you mean {}?", half_opening.degrees()),
        false => String::new(),
    }
}

/// Suggestion of the friction angle that a refused one may have been meant to be.
fn meant_friction_angle(angle: &str) -> String {
    let in_degrees = |angle: &ExactNumber| {
        let is_large = angle.is_rational() && *angle.factor() >= ratio(2, 1);
        is_large && is_between(&angle.degrees(), true, 2, true)
    };
    match angle.parse().ok().filter(in_degrees) {
        Some(angle) => format!("; did you mean {}?", angle.degrees()),
        None => String::new(),
    }
}

fn ratio(numerator: i32, denominator: i32) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// The sign of a number, whose denominator may be negative.
fn sign(x: &ExactNumber) -> Sign {
    x.factor().numer().sign() * x.factor().denom().sign()
}

/// Tells whether an angle is above zero (or is zero, if that is allowed) and below `pi / divisor`.
fn is_between(x: &ExactNumber, zero_is_in: bool, divisor: i32, in_doubles: bool) -> bool {
    // Its sign says on which side of a right angle it is.
    if x.form() == Form::ArctangentOfRoot && divisor <= 2 {
        return divisor == 1 || sign(x) == Sign::Minus;
    }
    let positive = match sign(x) {
        Sign::Plus => true,
        Sign::NoSign => zero_is_in,
        Sign::Minus => false,
    };
    match x.form() {
        // A multiple of pi is compared exactly.
        Form::TimesPi => return positive && *x.factor() < ratio(1, divisor),
        // Below pi whatever its tangent.
        Form::TwiceArctangent if divisor == 1 => return positive,
        _ => {}
    }
    // Doubles decide nearly always; the last bits are more than the longest number that is read has.
    let quick = in_doubles.then(|| is_below::<DoubleBall>(x, divisor, 0));
    let long = [128, 80_000].into_iter().map(|bits| is_below::<AstroInterval>(x, divisor, bits));
    let below = quick.into_iter().chain(long).find(|below| *below != Ternary::Undecided);
    positive && below == Some(Ternary::True)
}

/// Tells whether a number is below `pi / divisor`.
fn is_below<E: Engine>(x: &ExactNumber, divisor: i32, bits: u32) -> Ternary {
    let x: E = x.enclosure(bits);
    x.is_less_than(&(x.pi() / x.int(divisor)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_displayed_is_read_back() {
        for text in ["0.6", "inf", "tan(35deg)", "tan(0.5)", "1/3"] {
            let friction: Friction = text.parse().unwrap();
            assert_eq!(friction.to_string(), text);
            assert_eq!(friction.to_string().parse(), Ok(friction));
        }
        assert_eq!("35deg".parse::<Friction>(), "tan(35deg)".parse());
        assert_eq!("35 °".parse::<Friction>(), "tan(35deg)".parse());
        for text in ["Inf", "INF", "infinity", "+Infinity", "Unlimited", "∞", " inf "] {
            assert_eq!(text.parse::<Friction>(), Ok(Friction::Infinite), "{text}");
        }
        let error = "endless".parse::<Friction>().unwrap_err().to_string();
        assert!(error.contains("inf") && error.contains("31deg"), "{error}");
        assert!("tan(35deg".parse::<Friction>().is_err());
    }

    #[test]
    fn an_arch_outside_its_range_is_refused() {
        let refused = |weight, alpha, mu| Arch::parse(weight, alpha, mu).unwrap_err();
        assert!(matches!(refused("heyman", "pi", "1"), ArchError::HalfOpening(_)));
        assert!(matches!(refused("heyman", "0", "1"), ArchError::HalfOpening(_)));
        assert!(matches!(
            refused("heyman", "3.1415926535897932385", "1"),
            ArchError::HalfOpening(_)
        ));
        assert!(Arch::parse("heyman", "3.1415926535897932384", "1").is_ok());
        assert!(matches!(refused("heyman", "1", "-1"), ArchError::Friction(_)));
        assert!(matches!(refused("heyman", "1", "tan(91deg)"), ArchError::FrictionAngle(_)));
        let degrees =
            "the friction angle 31 is not between 0 and pi/2 (90deg); did you mean 31deg?";
        assert_eq!(refused("heyman", "1", "tan(31)").to_string(), degrees);
        assert!(!refused("heyman", "1", "tan(91)").to_string().contains("mean"));
        assert!(matches!(refused("heymann", "1", "1"), ArchError::SelfWeight(_)));
        assert!(Arch::parse("Heyman", "1", "1").is_ok(), "whatever the case");
        assert_eq!(
            refused("heyman", "90", "1").to_string(),
            "the half opening 90 is not between 0 and pi (180deg); did you mean 90deg?"
        );
        assert!(matches!(refused("heyman", "200", "1"), ArchError::HalfOpening(_)));
        assert!(matches!(refused("heyman", "x", "1"), ArchError::Number(_)));
        let right = Arch::parse("heyman", "1", "90deg").unwrap();
        assert_eq!(*right.friction(), Friction::Infinite);
    }

    #[test]
    fn a_thickness_is_a_number_above_zero_and_at_most_two() {
        let is = |text: &str| is_thickness(&text.parse().unwrap());
        assert!(is("1e-30") && is("1.999") && is("2"));
        assert!(!is("0") && !is("2.0001") && !is("-1") && !is("pi/4"));
    }

    #[test]
    fn an_arch_is_an_object_of_its_texts() {
        let arch = Arch::parse("milankovitch", "80deg", "tan(31deg)").unwrap();
        let json = serde_json::to_string(&arch).unwrap();
        let text = r#"{"weight":"milankovitch","half_opening":"80deg","friction":"tan(31deg)"}"#;
        assert_eq!(json, text);
        assert_eq!(serde_json::from_str::<Arch>(&json).unwrap(), arch);
        let refused = |from: &str, to| {
            let spoiled = text.replace(from, to);
            serde_json::from_str::<Arch>(&spoiled).unwrap_err().to_string()
        };
        assert!(refused("80deg", "180deg").contains("is not between 0 and pi"));
        assert!(refused("weight", "height").contains("missing field `weight`"));
        assert!(
            refused("\"80deg\"", "80").contains("expected a string"),
            "numbers would be rounded"
        );
    }
}
