//! The printed values against the certified ones, and the two weights against each other.

use super::printed::{KnownValue, PrintedNumber, PrintedVerdict, correct_digits};
use super::printed_rational::PrintedRational;
use super::published::{PRINTED, Printed};
use crate::arch::SelfWeight;
use crate::certify::{CertifiedLandmark, Enclosed, Exact, Undecided};
use crate::number::{Ball, Decimal, Enclosure, Ternary, worded};
use crate::problem::{Landmark, Quantity};
use rug::{Integer, Rational};

/// Bits that decide every comparison of 16-digit values with a wide margin.
const BITS: u32 = 256;

/// A printed number beside the certified value.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Audited {
    /// Value that is printed, and where.
    pub printed: &'static Printed,
    /// `|printed - true|` in units of the last printed place, correctly rounded to three digits;
    /// `0` if the printed number is exactly the true one.
    pub error_units: Decimal,
    /// The most digits `k` for which the error is at most half a unit of the `k`-th significant digit of
    /// the true value; all that are printed if they are exactly that.
    pub correct_digits: usize,
    /// Verdict on the last place.
    pub verdict: PrintedVerdict,
}

/// A claim of the paper: at a landmark, Milankovitch's weight gives a lower or a higher value than
/// Heyman's.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Comparison {
    /// The landmark.
    pub landmark: Landmark,
    /// The quantity compared.
    pub quantity: Quantity,
    /// Relation that the paper states for Milankovitch's value.
    pub claimed: Relation,
    /// Relation that is certified.
    pub certified: Relation,
}

impl Comparison {
    /// `proved` or `refuted`; a value that is the same for both weights refutes both claims.
    pub fn verdict(&self) -> &'static str {
        if self.claimed == self.certified { "proved" } else { "refuted" }
    }
}

worded! {
    /// Relation of Milankovitch's value to Heyman's.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Relation {
        /// The value is lower.
        Lower = "lower",
        /// Exactly the same.
        Equal = "equal",
        /// The value is higher.
        Higher = "higher",
    }
    /// All of them, in order.
    pub const ALL;
    /// The word used in files.
    pub fn name -> &'static str;
}

/// The enclosure of a landmark for [`audit_of`]: it decides every comparison with what is printed.
pub fn enclosed(point: &CertifiedLandmark) -> Result<Enclosed, Undecided> {
    point.enclosure(BITS)
}

/// Compares every printed number with its enclosure; undecided if a landmark cannot be proved or a
/// comparison stays open.
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
/// opening, higher thrust and joints for Milankovitch's weight. Undecided as [`audit`].
pub fn compare_weights() -> Result<Vec<Comparison>, Undecided> {
    compare_weights_of(&all_enclosed(&COMPARED)?)
}

/// The landmarks at which the paper compares the weights.
const COMPARED: [Landmark; 4] =
    [Landmark::Triple, Landmark::Shift, Landmark::Junction, Landmark::Border];

/// Compares the weights at those of some landmarks that are there for both weights.
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
            let certified = relation(&milankovitch?, &heyman?)
                .ok_or_else(|| Undecided::new(format!("{quantity} at {landmark}")))?;
            Ok(Comparison { landmark, quantity, claimed, certified })
        })
        .collect()
}

/// Landmarks of both weights with an enclosure each.
fn all_enclosed(landmarks: &[Landmark]) -> Result<Vec<Enclosed>, Undecided> {
    let all: Vec<(Landmark, SelfWeight)> = landmarks
        .iter()
        .flat_map(|&landmark| SelfWeight::ALL.map(|weight| (landmark, weight)))
        .collect();
    // Serial on purpose: under rayon a waiting thread could steal a claim that waits for this result, and
    // neither would end.
    let points = all.into_iter();
    points.map(|(landmark, weight)| enclosed(&CertifiedLandmark::new(landmark, weight)?)).collect()
}

/// Landmarks with an enclosure each.
struct Points<'a>(&'a [Enclosed]);

impl Points<'_> {
    fn find(&self, landmark: Landmark, weight: SelfWeight) -> Option<&Enclosed> {
        self.0.iter().find(|point| point.landmark() == landmark && point.weight() == weight)
    }

    fn value(
        &self,
        landmark: Landmark,
        weight: SelfWeight,
        quantity: Quantity,
    ) -> Result<KnownValue, Undecided> {
        let missing = || Undecided::new(format!("{landmark} has no finite {quantity}"));
        let point = self.find(landmark, weight).ok_or_else(missing)?;
        match point.exact(quantity) {
            Some(Exact::Surd(surd)) => Ok(match surd.parts() {
                (rational, factor, _) if factor.is_zero() => KnownValue::Exact(rational.clone()),
                _ => KnownValue::Enclosed(surd.enclosure(BITS)),
            }),
            _ => point.quantity(quantity).map(KnownValue::Enclosed).ok_or_else(missing),
        }
    }
}

fn audit_one(printed: &'static Printed, points: &Points<'_>) -> Result<Audited, Undecided> {
    let undecided = || Undecided::new(format!("{} {}", printed.place, printed.text));
    let PrintedNumber { value, per_unit, digits } = figures(printed.text).ok_or_else(undecided)?;
    let truth = points.value(printed.landmark, printed.weight, printed.quantity)?;
    let absolute = truth.error_of(&value);
    let error = absolute.times(&per_unit);
    let error_units = error.shown().ok_or_else(undecided)?;
    let verdict = error.verdict(&error_units).ok_or_else(undecided)?;
    let size = absolute.shown().ok_or_else(undecided)?;
    let rounded = truth.rounded(digits).ok_or_else(undecided)?;
    let correct_digits = match size.digits().is_empty() {
        true => digits,
        false => correct_digits(&absolute, &size, &rounded).ok_or_else(undecided)?,
    };
    Ok(Audited { printed, error_units, correct_digits, verdict })
}

fn figures(text: &str) -> Option<PrintedNumber> {
    if let Some((numerator, denominator)) = text.split_once('/') {
        // A fraction is exact and has no last place; its unit is one.
        let value = Rational::from((
            numerator.parse::<Integer>().ok()?,
            denominator.parse::<Integer>().ok().filter(|d| !d.is_zero())?,
        ));
        let (value, digits) = (PrintedRational::Long(value), numerator.len() + denominator.len());
        return Some(PrintedNumber { value, per_unit: PrintedRational::integer(1), digits });
    }
    PrintedNumber::from_decimal(&text.parse().ok()?)
}

fn relation(a: &KnownValue, b: &KnownValue) -> Option<Relation> {
    let ball = |x: &KnownValue| match x {
        KnownValue::Exact(rational) => Ball::enclosing(rational, BITS),
        KnownValue::Enclosed(ball) => ball.clone(),
    };
    if let (KnownValue::Exact(a), KnownValue::Exact(b)) = (a, b)
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
    fn a_relation_of_overlapping_enclosures_is_unknown() {
        let third = || KnownValue::Enclosed(Ball::integer(1, 64) / Ball::integer(3, 64));
        assert_eq!(relation(&third(), &third()), None);
        let one = KnownValue::Exact(Rational::from(1));
        assert_eq!(relation(&third(), &one), Some(Relation::Lower));
        assert_eq!(relation(&one, &third()), Some(Relation::Higher));
    }
}
