//! The programme (20) of an arch of equal stones.

use super::jointed;
use super::record::Record;
use crate::certify::Undecided;
use crate::certify::state::Figure;
use crate::number::{Ball, Rounded};
use crate::problem::Extent;
use couplet_stones::Programme;
use rug::Float;

/// The programme (20) of an arch of equal stones at a thickness.
#[derive(Debug)]
pub struct AtThickness {
    /// The thickness as given.
    pub thickness: String,
    /// Thickness, where it is given by a name.
    pub named: Option<Figure>,
    /// The stones of the whole arch.
    pub stones: u64,
    /// States that are looked at.
    pub extent: Extent,
    /// Result that is proved.
    pub found: Result<ProgrammeFound, Undecided>,
}

/// Result of the programme (20), or of the thickness that is asked for by its name.
#[derive(Clone, Debug)]
pub enum ProgrammeFound {
    /// The programme at a thickness.
    At(Programme),
    /// There is no least thickness, as every thickness up to 2 stands.
    EveryThicknessStands,
    /// There is no least thickness, as no thickness up to 2 stands.
    NoThicknessStands,
}

impl AtThickness {
    /// The least value in as many digits as are proved, up to twelve, or a lower bound of it.
    fn value(&self) -> Option<Result<Rounded, Rounded>> {
        let Ok(ProgrammeFound::At(Programme::Least { lower, upper })) = &self.found else {
            return None;
        };
        let ball = |x: &f64| Ball::exact(Float::with_val(64, *x), 64);
        let rounded = |x: &Ball| Rounded::most(x, 12);
        let exact = upper.as_ref().and_then(|upper| rounded(&ball(lower).hull(&ball(upper))));
        exact.map(Ok).or_else(|| rounded(&ball(lower)).map(Err))
    }

    fn is_zero(&self) -> bool {
        matches!(&self.found, Ok(ProgrammeFound::At(Programme::Zero | Programme::Idle)))
    }

    /// Result in words.
    fn words(&self) -> Vec<String> {
        let words = match &self.found {
            Err(undecided) => return vec![undecided.to_string()],
            Ok(found) => found.told().1,
        };
        let value = self.value().map(|value| match value {
            Ok(value) => format!("least value {}", value.value),
            Err(bound) => format!("least value at least {}", bound.lower),
        });
        value.into_iter().chain(words.iter().map(|&line| line.to_owned())).collect()
    }
}

impl ProgrammeFound {
    /// Outcome in a word, and in lines.
    fn told(&self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::EveryThicknessStands => (
                "every_thickness_stands",
                &["there is none, proved: every thickness up to 2 stands"],
            ),
            Self::NoThicknessStands => {
                ("no_thickness_stands", &["there is none, proved: no thickness up to 2 stands"])
            }
            Self::At(Programme::NoRates) => ("no_rates", &NO_RATES),
            Self::At(Programme::NothingAdmissible) => {
                ("nothing_admissible", &["nothing is admissible at these joints, proved", COMPLETE])
            }
            Self::At(Programme::Zero) => ("zero", &ZERO),
            Self::At(Programme::Idle) => ("zero_by_the_letter", &IDLE),
            Self::At(Programme::Least { .. }) => ("positive", &POSITIVE),
        }
    }
}

/// Proof that there is nothing else.
const COMPLETE: &str = "complete for these joints: all pairs of conditions are looked at, in balls";
/// Words where no rates fit.
const NO_RATES: [&str; 2] = [
    "no rates fit: (19) has no solution at this thickness",
    "proved: there is a direction in which each motion of a joint points, in balls",
];
/// Words where the programme is zero.
const ZERO: [&str; 2] = [
    "least value 0, exactly",
    "proved: (19) has a solution there, an admissible state with positive rates that fit",
];
/// Words where it is positive.
const POSITIVE: [&str; 2] =
    ["positive, proved: at these joints (19) has no solution at this thickness", COMPLETE];
/// Words where a joint bears nothing.
const IDLE: [&str; 3] = [
    "least value 0 by the letter, proved: in an admissible state a joint bears nothing, and its two",
    "opposite slips, which are no motion, cost nothing. Whether a motion costs nothing as well is",
    "not said; the solutions without --thickness leave such slips out",
];

/// The programme (20) as a row.
pub(super) fn row(at: &AtThickness) -> Record {
    let mut row = record(at);
    row.add("mode", "programme");
    row.add("thickness", at.named.as_ref().map_or(at.thickness.clone(), Figure::to_string));
    if at.is_zero() {
        row.add("least_value", "0");
    }
    row
}

/// The programme (20), with what a person reads of it.
pub(super) fn record(at: &AtThickness) -> Record {
    let mut record = Record::default();
    let (stones, joints) = (at.stones, jointed::joints(at.extent, at.stones));
    let eta = at.named.as_ref().map(|figure| format!("{figure}, the least"));
    let eta = eta.unwrap_or_else(|| at.thickness.clone());
    let half = if at.extent == Extent::Half { " of the half arch" } else { "" };
    record.say(format!(
        "Programme (20) at thickness {eta}, {stones} equal stones, {joints} joints{half}"
    ));
    record.say_all(at.words().iter().map(|line| format!("   {line}")));
    record.add("thickness", at.thickness.as_str());
    record.add_bounds("least_thickness", at.named.as_ref());
    record.add("extent", jointed::extent(at.extent));
    record.add("stones", at.stones);
    let outcome = at.found.as_ref().map_or("undecided", |found| found.told().0);
    record.add("outcome", outcome);
    record.add("reason", at.found.as_ref().err().map(|open| open.reason.to_string()));
    record.add_rounded("least_value", at.value().and_then(Result::ok).as_ref());
    let lower = match at.value() {
        Some(Ok(value) | Err(value)) => Some(value.lower.to_string()),
        None => at.is_zero().then(|| "0".to_owned()),
    };
    record.add("least_value_lower", lower);
    record
}
