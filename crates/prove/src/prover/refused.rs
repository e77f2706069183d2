//! A question that makes no sense: what was wrong with it, and what is allowed.
//!
//! Every door of this room asks here before anything is computed.

use crate::arch::SelfWeight;
use crate::check::MAX_LENGTH_DIGITS;
use crate::number::{Ball, Enclosure, ExactNumber, Form, says};
use crate::problem::stones::StonesError;
use crate::problem::{Arch, ArchError, Friction, Landmark, Line, Quantity, ThicknessError};

/// The largest number of digits that can be asked for, of a constant or of an arch.
pub const MAX_DIGITS: usize = 1_000_000;

/// Refusal of a question that was asked wrongly. Nothing was computed, and the same question is refused again.
///
/// ```
/// use couplet_prove::certify::Refused;
/// use couplet_prove::prelude::*;
/// let arch = Arch::parse("heyman", "80deg", "0.6")?;
/// let Err(couplet_prove::certify::Error::Refused(why)) = arch.certify(0) else { panic!() };
/// assert_eq!(why, Refused::Digits { asked: 0, most: 1_000_000 });
/// assert_eq!(why.to_string(), "digits are a whole number from 1 to 1000000");
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Refused {
    /// No value has so many digits, or none at all.
    Digits {
        /// Number that was asked for.
        asked: usize,
        /// The most that there are.
        most: usize,
    },
    /// The subject does not have the quantity.
    NoSuchQuantity {
        /// Quantity that was asked for.
        quantity: Quantity,
        /// Quantities that there are.
        possible: Vec<Quantity>,
    },
    /// The thickness is not above 0 and at most 2, or a multiple of pi, which is no ratio.
    Thickness(ThicknessError),
    /// The half opening or the friction is out of its range.
    Arch(ArchError),
    /// The stones are none of an arch.
    Stones(StonesError),
    /// The stones are too few, or more than this question is answered for.
    StoneCount {
        /// Number that was asked for.
        asked: u64,
        /// The most that there may be.
        most: u64,
    },
    /// The line of the map does not end at the landmark.
    NoEnd {
        /// The line.
        line: Line,
        /// The landmark that was asked for.
        at: Landmark,
    },
    /// A boundary at unlimited friction.
    UnlimitedFriction,
    /// The rotational joint is not between 0 and pi.
    RotationJoint(ExactNumber),
    /// The rotational joint is beyond the widest one.
    BeyondWidestJoint(ExactNumber),
    /// A value of a quantity is out of its range.
    Outside {
        /// Quantity that is given.
        quantity: Quantity,
        /// Value as it was given.
        value: String,
        /// Limits of the quantity.
        limits: [&'static str; 2],
    },
    /// A quantity is missing.
    Missing {
        /// Quantity that is missing.
        missing: Quantity,
        /// Quantities that have to be given.
        needed: Vec<Quantity>,
    },
    /// An equation of the other self-weight.
    OtherWeight {
        /// Number of the equation.
        equation: u8,
        /// The self-weight model that was asked for.
        weight: SelfWeight,
    },
    /// A pole of an equation.
    DividesByZero {
        /// Number of the equation.
        equation: u8,
    },
    /// A closed form that the paper does not have.
    ClosedFormOfHeyman,
    /// A certificate of a survey whose arches have no thickness.
    SurveyWithoutThickness,
    /// A length of more digits than the certificate of a survey has.
    LongLengths,
    /// An angle that no certificate holds.
    Uncertifiable(ExactNumber),
    /// Arrays that have to be of one length are not.
    Lengths(Vec<usize>),
}

says!(Refused {
    Self::Digits { most, .. } => "digits are a whole number from 1 to {most}";
    Self::NoSuchQuantity { quantity, possible } =>
        "there is no {} here; the quantities are {}", quantity.name(), names(possible);
    Self::StoneCount { asked, most } => "{asked} is no number of stones here: give one from 2 to {most}";
    Self::NoEnd { line, at } =>
        "the line {line} does not end at {}, but at {}", at.symbol(), ends(line);
    Self::UnlimitedFriction => "a boundary needs a limited friction: with inf nothing slides";
    Self::RotationJoint(joint) =>
        "the rotational joint {} is not between 0 and pi (180deg){}", joint, meant(joint);
    Self::BeyondWidestJoint(joint) =>
        "the rotational joint {joint} is beyond the widest one, beta_sb: (9), (10) and (11) are real up to it";
    Self::Outside { quantity, value, limits } =>
        "{} = {value} is not between {} and {}", quantity.name(), limits[0], limits[1];
    Self::Missing { missing, needed } =>
        "{} is missing; the equation needs {}", missing.name(), names(needed);
    Self::OtherWeight { equation, weight } => "({equation}) is not for {}'s weight", weight.name();
    Self::DividesByZero { equation } =>
        "({equation}) has no value there: what it divides by is exactly zero";
    Self::ClosedFormOfHeyman =>
        "(9), (10) and (11) are for Milankovitch's weight; for Heyman's give (7), which has quadratics then";
    Self::SurveyWithoutThickness =>
        "a certificate of a survey needs a thickness: without one there is no verdict";
    Self::LongLengths =>
        "in a certificate of a survey a length is a fraction of integers of at most {MAX_LENGTH_DIGITS} digits";
    Self::Uncertifiable(angle) =>
        "no certificate holds {angle}: give span and rise, a part of pi or a rational number";
    Self::Lengths(all) => "the arrays are not of one length: {}", lengths(all);
} from {
    ThicknessError => Self::Thickness;
    ArchError => Self::Arch;
    StonesError => Self::Stones;
});

impl Refused {
    /// Checks that so many digits can be asked for.
    pub fn digits(asked: usize) -> Result<(), Self> {
        Self::digits_to(asked, MAX_DIGITS)
    }

    /// Checks that no more digits are asked for than a number of one's own.
    pub fn digits_to(asked: usize, most: usize) -> Result<(), Self> {
        (1..=most).contains(&asked).then_some(()).ok_or(Self::Digits { asked, most })
    }

    /// Checks that angles are of the forms that a certificate holds.
    pub fn certifiable<'a>(
        half_openings: impl IntoIterator<Item = &'a ExactNumber>,
        frictions: impl IntoIterator<Item = &'a Friction>,
    ) -> Result<(), Self> {
        let angle = |friction: &'a Friction| match friction {
            Friction::Angle(phi) => Some(phi),
            Friction::Coefficient(_) | Friction::Infinite => None,
        };
        let mut all = half_openings.into_iter().chain(frictions.into_iter().filter_map(angle));
        let other = all.find(|angle| angle.form() == Form::ArctangentOfRoot);
        other.map_or(Ok(()), |angle| Err(Self::Uncertifiable(angle.clone())))
    }

    /// Checks that a number is a thickness.
    pub fn thickness(thickness: &ExactNumber) -> Result<(), Self> {
        Ok(ThicknessError::check(thickness, &thickness.to_string())?)
    }

    /// Checks that a number is an angle of a rotational joint.
    pub(crate) fn rotation_joint(joint: &ExactNumber) -> Result<(), Self> {
        as_half_opening(joint).map_err(|_| Self::RotationJoint(joint.clone()))
    }

    /// Checks that a value of a quantity of a state is in its range.
    pub(crate) fn value_of(quantity: Quantity, value: &ExactNumber) -> Result<(), Self> {
        match quantity {
            Quantity::HalfOpening => Ok(as_half_opening(value)?),
            Quantity::RotationJoint => Self::rotation_joint(value),
            Quantity::Thickness => Self::thickness(value),
            Quantity::Thrust => Self::between(quantity, value, ["0", "1"]),
            _ => Self::between(quantity, value, ["0", "2"]),
        }
    }

    /// Checks that a value of a quantity is between two limits, and none of them.
    pub(crate) fn between(
        quantity: Quantity,
        value: &ExactNumber,
        limits: [&'static str; 2],
    ) -> Result<(), Self> {
        /// Bits with which a value is compared that is no rational number.
        const BITS: u32 = 256;
        let is_less = |a: &ExactNumber, b: &ExactNumber| match a.is_rational() && b.is_rational() {
            true => a.factor() < b.factor(),
            false => a.enclosure::<Ball>(BITS).is_less_than(&b.enclosure(BITS)).is_proved(),
        };
        let inside = match limits.map(str::parse::<ExactNumber>) {
            [Ok(lower), Ok(upper)] => is_less(&lower, value) && is_less(value, &upper),
            _ => false,
        };
        let refused = || Self::Outside { quantity, value: value.to_string(), limits };
        inside.then_some(()).ok_or_else(refused)
    }

    /// Checks that a value of a quantity is between two limits, or one of them.
    pub(crate) fn from_to(
        quantity: Quantity,
        value: &ExactNumber,
        limits: [&'static str; 2],
    ) -> Result<(), Self> {
        let is_value = |end: ExactNumber| value.is_rational() && end.factor() == value.factor();
        match limits.iter().any(|end| end.parse().is_ok_and(is_value)) {
            true => Ok(()),
            false => Self::between(quantity, value, limits),
        }
    }

    /// Checks that a quantity is one of the possible ones.
    pub fn quantity(asked: Quantity, possible: &[Quantity]) -> Result<(), Self> {
        let refused = || Self::NoSuchQuantity { quantity: asked, possible: possible.to_vec() };
        possible.contains(&asked).then_some(()).ok_or_else(refused)
    }

    /// The number of stones, from 2 to as many.
    #[doc(hidden)]
    pub fn stones(asked: u64, most: u64) -> Result<i32, Self> {
        let number = i32::try_from(asked).ok().filter(|_| (2..=most).contains(&asked));
        number.ok_or(Self::StoneCount { asked, most })
    }
}

/// Joints and half openings have one range.
fn as_half_opening(joint: &ExactNumber) -> Result<(), ArchError> {
    Arch::new(SelfWeight::Heyman, joint.clone(), Friction::Infinite).map(|_| ())
}

/// Degrees that a joint was perhaps meant to be given in.
fn meant(joint: &ExactNumber) -> String {
    as_half_opening(joint).err().map_or(String::new(), |error| error.hint())
}

fn names(quantities: &[Quantity]) -> String {
    quantities.iter().map(|of| of.name()).collect::<Vec<_>>().join(", ")
}

fn ends(line: &Line) -> String {
    let ends = line.ends().into_iter().flatten();
    ends.map(Landmark::symbol).collect::<Vec<_>>().join(" and ")
}

fn lengths(all: &[usize]) -> String {
    all.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}
