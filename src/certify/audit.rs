//! The printed values against the certified ones, and the two weights against each other.

use super::exact::Exact;
use super::{CertifiedLandmark, Refined, Undecided};
use crate::arch::published::{PRINTED, Printed};
use crate::arch::{Landmark, Quantity, SelfWeight};
use crate::number::{Ball, Decimal, Enclosure, Field, Rounded, Ternary};
use rug::{Integer, Rational, ops::Pow};

/// Bits that decide every comparison of 16-digit values with a wide margin.
const BITS: u32 = 256;
/// Significant digits of an error in units of the last place.
const ERROR_DIGITS: usize = 3;

/// A printed number beside the certified value.
#[derive(Clone, Debug)]
pub struct Audited {
    /// What is printed, and where.
    pub printed: &'static Printed,
    /// `|printed - true|` in units of the last printed place, correctly rounded to three digits;
    /// `0` if the printed number is exactly the true one.
    pub error_units: Decimal,
    /// All printed digits if they are the correct rounding; otherwise how many leading significant
    /// digits are those of the true value.
    pub correct_digits: usize,
    /// How good the last place is.
    pub verdict: PrintedVerdict,
}

/// How good the last printed place is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrintedVerdict {
    /// The error is at most half a unit of the last place.
    CorrectlyRounded,
    /// The error is below one unit.
    Faithful,
    /// The error is one unit or more.
    Wrong,
}

impl PrintedVerdict {
    /// The words used in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::CorrectlyRounded => "correctly rounded",
            Self::Faithful => "faithful",
            Self::Wrong => "wrong",
        }
    }
}

/// A claim of the paper: at a landmark, Milankovitch's weight gives a lower or a higher value than
/// Heyman's.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The landmark.
    pub landmark: Landmark,
    /// The quantity compared.
    pub quantity: Quantity,
    /// What the paper says of Milankovitch's value.
    pub claimed: Relation,
    /// What is certified.
    pub certified: Relation,
}

impl Comparison {
    /// `proved` or `refuted`; a value that is the same for both weights refutes both claims.
    pub fn verdict(&self) -> &'static str {
        if self.claimed == self.certified { "proved" } else { "refuted" }
    }
}

/// How Milankovitch's value relates to Heyman's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Below it.
    Lower,
    /// Exactly the same.
    Equal,
    /// Above it.
    Higher,
}

impl Relation {
    /// The word used in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lower => "lower",
            Self::Equal => "equal",
            Self::Higher => "higher",
        }
    }
}

/// A landmark with an enclosure that decides every comparison with what is printed.
pub type Enclosed = (CertifiedLandmark, Refined);

/// The enclosure of a landmark for [`audit_of`].
pub fn enclosed(point: CertifiedLandmark) -> Result<Enclosed, Undecided> {
    let refined = point.enclosure(BITS)?;
    Ok((point, refined))
}

/// Compares every printed number with its enclosure.
pub fn audit() -> Result<Vec<Audited>, Undecided> {
    audit_of(&all_enclosed(&Landmark::ALL)?)
}

/// Compares the printed numbers of some landmarks with their enclosures.
pub fn audit_of(points: &[Enclosed]) -> Result<Vec<Audited>, Undecided> {
    let points = Points(points);
    let known = |printed: &&Printed| points.find(printed.landmark, printed.weight).is_some();
    PRINTED.iter().filter(known).map(|printed| audit_one(printed, &points)).collect()
}

/// Decides the paper's claims on the two weights at T, S, J and B: lower thickness, friction and half
/// opening, higher thrust and joints for Milankovitch's weight.
pub fn compare_weights() -> Result<Vec<Comparison>, Undecided> {
    compare_weights_of(&all_enclosed(&COMPARED)?)
}

/// The landmarks at which the paper compares the weights.
const COMPARED: [Landmark; 4] =
    [Landmark::Triple, Landmark::Shift, Landmark::Junction, Landmark::Border];

/// The same at those of some landmarks that are there for both weights.
pub fn compare_weights_of(points: &[Enclosed]) -> Result<Vec<Comparison>, Undecided> {
    use {Quantity::*, Relation::*};
    let points = Points(points);
    let both = |landmark: &Landmark| {
        SelfWeight::ALL.iter().all(|&weight| points.find(*landmark, weight).is_some())
    };
    let landmarks: Vec<Landmark> = COMPARED.into_iter().filter(both).collect();
    let claims = [
        (Thickness, Lower),
        (Friction, Lower),
        (HalfOpening, Lower),
        (Thrust, Higher),
        (RotationJoint, Higher),
        (SlidingJoint, Higher),
    ];
    let pairs = landmarks.iter().flat_map(|&landmark| claims.map(|claim| (landmark, claim)));
    pairs
        .map(|(landmark, (quantity, claimed))| {
            let values = SelfWeight::ALL.map(|weight| points.value(landmark, weight, quantity));
            let [heyman, milankovitch] = values;
            let certified = relation(&milankovitch?, &heyman?).ok_or_else(|| {
                Undecided(format!("{} at {}", quantity.name(), landmark.symbol()))
            })?;
            Ok(Comparison { landmark, quantity, claimed, certified })
        })
        .collect()
}

/// A certified value: exact, or in an enclosure.
enum Known {
    Exact(Rational),
    Enclosed(Ball),
}

/// Landmarks of both weights with an enclosure each.
fn all_enclosed(landmarks: &[Landmark]) -> Result<Vec<Enclosed>, Undecided> {
    let all: Vec<(Landmark, SelfWeight)> = landmarks
        .iter()
        .flat_map(|&landmark| SelfWeight::ALL.map(|weight| (landmark, weight)))
        .collect();
    // One after the other: claims that are decided in parallel wait for the same comparisons, and a thread
    // that waits for parts of them could meanwhile take up one of those claims.
    let points = all.into_iter();
    points.map(|(landmark, weight)| enclosed(CertifiedLandmark::new(landmark, weight)?)).collect()
}

/// Landmarks with an enclosure each.
struct Points<'a>(&'a [Enclosed]);

impl Points<'_> {
    fn find(&self, landmark: Landmark, weight: SelfWeight) -> Option<&Enclosed> {
        self.0.iter().find(|(point, _)| point.landmark() == landmark && point.weight() == weight)
    }

    fn value(
        &self,
        landmark: Landmark,
        weight: SelfWeight,
        quantity: Quantity,
    ) -> Result<Known, Undecided> {
        let missing =
            || Undecided(format!("{} has no finite {}", landmark.symbol(), quantity.name()));
        let (point, refined) = self.find(landmark, weight).ok_or_else(missing)?;
        match point.exact(quantity) {
            Some(Exact::Surd(surd)) => Ok(match surd.parts() {
                (rational, factor, _) if factor.is_zero() => Known::Exact(rational.clone()),
                _ => Known::Enclosed(surd.enclosure(BITS)),
            }),
            _ => point.quantity(refined, quantity).map(Known::Enclosed).ok_or_else(missing),
        }
    }
}

fn audit_one(printed: &'static Printed, points: &Points<'_>) -> Result<Audited, Undecided> {
    let undecided = || Undecided(format!("{} {}", printed.place, printed.text));
    let Figures { value, unit, digits } = figures(printed.text).ok_or_else(undecided)?;
    let (error, shared) = match points.value(printed.landmark, printed.weight, printed.quantity)? {
        Known::Exact(truth) => {
            let error = Rational::from(&value - &truth).abs() / unit;
            let shown = Rounded::from_rational(&truth, digits.len());
            let shared = shown.map_or(0, |shown| shared_digits(&digits, &value, &shown.value));
            (Error::Exact(error), shared)
        }
        Known::Enclosed(truth) => {
            let difference = truth.clone() - Ball::enclosing(&value, BITS);
            let error = difference / Ball::enclosing(&unit, BITS);
            let shown = Rounded::from_ball(&truth, digits.len()).ok_or_else(undecided)?;
            (Error::Enclosed(error), shared_digits(&digits, &value, &shown.lower))
        }
    };
    let verdict = error.verdict().ok_or_else(undecided)?;
    let correct_digits =
        if verdict == PrintedVerdict::CorrectlyRounded { digits.len() } else { shared };
    let error_units = error.shown().ok_or_else(undecided)?;
    Ok(Audited { printed, error_units, correct_digits, verdict })
}

/// A printed number as it is meant: its value, one unit of its last place, its digits.
struct Figures {
    value: Rational,
    unit: Rational,
    digits: String,
}

fn figures(text: &str) -> Option<Figures> {
    if let Some((numerator, denominator)) = text.split_once('/') {
        // A fraction is exact and has no last place; its unit is one.
        let value = Rational::from((
            numerator.parse::<Integer>().ok()?,
            denominator.parse::<Integer>().ok().filter(|d| !d.is_zero())?,
        ));
        let digits = format!("{numerator}{denominator}");
        return Some(Figures { value, unit: Rational::from(1), digits });
    }
    let decimal: Decimal = text.parse().ok()?;
    let power = Integer::from(10).pow(u32::try_from(decimal.exponent().unsigned_abs()).ok()?);
    let unit = if decimal.exponent() < 0 { Rational::from((1, power)) } else { power.into() };
    let digits = if decimal.digits().is_empty() { "0" } else { decimal.digits() };
    Some(Figures { value: decimal.to_rational(), unit, digits: digits.to_owned() })
}

/// How many leading digits of a printed number are those of the true value cut off.
fn shared_digits(printed: &str, value: &Rational, truth: &Decimal) -> usize {
    let magnitude = Rounded::from_rational(value, printed.len()).map(|r| r.value.magnitude());
    if magnitude != Some(truth.magnitude()) {
        return 0;
    }
    printed.bytes().zip(truth.digits().bytes()).take_while(|(a, b)| a == b).count()
}

enum Error {
    Exact(Rational),
    /// Either sign.
    Enclosed(Ball),
}

impl Error {
    fn verdict(&self) -> Option<PrintedVerdict> {
        let half = Rational::from((1, 2));
        let (within_half, within_one) = match self {
            Self::Exact(error) => (*error <= half, *error < 1),
            Self::Enclosed(error) => {
                let within =
                    |limit: Ball| error.is_less_than(&limit).and((-limit).is_less_than(error));
                (decided(within(Ball::enclosing(&half, BITS)))?, decided(within(error.int(1)))?)
            }
        };
        Some(match (within_half, within_one) {
            (true, _) => PrintedVerdict::CorrectlyRounded,
            (false, true) => PrintedVerdict::Faithful,
            (false, false) => PrintedVerdict::Wrong,
        })
    }

    fn shown(&self) -> Option<Decimal> {
        match self {
            Self::Exact(error) => Some(Rounded::from_rational(error, ERROR_DIGITS)?.value),
            Self::Enclosed(error) => {
                let negative = decided((-error.clone()).is_positive())?;
                let size = if negative { -error.clone() } else { error.clone() };
                Some(Rounded::from_ball(&size, ERROR_DIGITS)?.value)
            }
        }
    }
}

fn decided(answer: Ternary) -> Option<bool> {
    match answer {
        Ternary::True => Some(true),
        Ternary::False => Some(false),
        Ternary::Undecided => None,
    }
}

fn relation(a: &Known, b: &Known) -> Option<Relation> {
    let ball = |x: &Known| match x {
        Known::Exact(rational) => Ball::enclosing(rational, BITS),
        Known::Enclosed(ball) => ball.clone(),
    };
    if let (Known::Exact(a), Known::Exact(b)) = (a, b)
        && a == b
    {
        return Some(Relation::Equal);
    }
    let (a, b) = (ball(a), ball(b));
    match (a.is_less_than(&b), b.is_less_than(&a)) {
        (Ternary::True, _) => Some(Relation::Lower),
        (_, Ternary::True) => Some(Relation::Higher),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_at_the_borders() {
        let verdict = |n: i32, d: i32| Error::Exact(Rational::from((n, d))).verdict().unwrap();
        assert_eq!(verdict(1, 2), PrintedVerdict::CorrectlyRounded);
        assert_eq!(verdict(501, 1000), PrintedVerdict::Faithful);
        assert_eq!(verdict(1, 1), PrintedVerdict::Wrong);
        let wide = Ball::enclosing(&Rational::from((1, 2)), BITS) + Ball::whole(BITS);
        assert_eq!(Error::Enclosed(wide).verdict(), None);
    }

    #[test]
    fn a_relation_of_overlapping_enclosures_is_unknown() {
        let third = || Known::Enclosed(Ball::integer(1, 64) / Ball::integer(3, 64));
        assert_eq!(relation(&third(), &third()), None);
        let one = Known::Exact(Rational::from(1));
        assert_eq!(relation(&third(), &one), Some(Relation::Lower));
        assert_eq!(relation(&one, &third()), Some(Relation::Higher));
    }
}
