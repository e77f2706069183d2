//! An answer about a landmark or an arch: all that a format sees.
//!
//! **No format computes anything.** Doubles are correctly rounded and their bounds rounded outward before
//! they come here ([`Binary`](crate::number::Binary)). What is not proved has a reason and no values.

use super::given::GivenDoubles;
use super::value::Value;
use super::words::reason;
use crate::arch::{SelfWeight, Unknown};
use crate::certify::state::{Answer as Outcome, AssessmentDigits, Fall};
use crate::certify::{CertifiedLandmark, Constant, Undecided};
use crate::number::ExactNumber;
use crate::problem::Arch;
use crate::problem::{Equation, Landmark, Mode, Quantity};

/// A landmark or an arch, what became of it, and its proved values.
#[derive(Clone, Debug)]
pub struct Answer {
    /// What it is about.
    pub subject: Subject,
    /// What became of it.
    pub status: Status,
    /// Whether an arch can stand at some thickness, where that is asked and decided.
    pub can_stand: Option<bool>,
    /// Whether an arch stands at the thickness that it has, where that is decided.
    pub stands: Option<bool>,
    /// How an arch collapses at its least thickness; at a landmark the modes that meet there, if asked for.
    pub modes: Vec<Mode>,
    /// The values, all proved.
    pub values: Vec<(Quantity, Value)>,
    /// How a landmark is proved.
    pub proof: Option<Proof>,
    /// The certificate that holds these values, or why there is none.
    pub certificate: Result<Fingerprint, String>,
    /// What the query has beside the arch, by name, and is handed on.
    pub kept: Vec<(String, Kept)>,
}

/// What is handed on from a query to its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kept {
    /// A text.
    Text(String),
    /// JSON, as it was written.
    Json(String),
}

impl Kept {
    /// The text, or the JSON as it was written.
    pub fn text(&self) -> &str {
        match self {
            Self::Text(text) | Self::Json(text) => text,
        }
    }
}

/// What an answer is about.
#[derive(Clone, Debug)]
pub enum Subject {
    /// A landmark point.
    Landmark {
        /// Which.
        landmark: Landmark,
        /// The self-weight model.
        weight: SelfWeight,
    },
    /// An arch. What was given is text from outside.
    Arch {
        /// Tells arches apart: the line of the query.
        line: u64,
        /// The self-weight model.
        weight: SelfWeight,
        /// The half opening as given.
        half_opening: String,
        /// The friction as given.
        friction: String,
        /// The thickness as given, where the arch has one.
        thickness: Option<String>,
        /// The same as numbers.
        doubles: GivenDoubles,
    },
    /// A query that could not be read.
    Query {
        /// Its line.
        line: u64,
    },
}

/// What became of a subject.
#[derive(Clone, Debug)]
pub enum Status {
    /// Its values are proved.
    Proved,
    /// It is proved that no thickness is enough.
    Falls(Fall),
    /// Nothing is known.
    Undecided(Undecided),
    /// The query is wrong, and how.
    Refused(String),
}

/// How a landmark is proved: one solution of its equations in a box.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The equations.
    pub equations: Vec<&'static str>,
    /// The radius of the box for each unknown, relative to its value.
    pub radii: Vec<(&'static str, f64)>,
}

/// What ties values to a certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fingerprint {
    /// The command that writes the certificate.
    pub command: String,
    /// SHA-256 of what it writes, in hexadecimal.
    pub sha256: String,
}

impl Status {
    /// The word for it in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Proved | Self::Falls(_) => "proved",
            Self::Undecided(_) => "undecided",
            Self::Refused(_) => "refused",
        }
    }

    /// Why there are no values, or why an arch falls.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Proved => None,
            Self::Falls(fall) => Some(reason(*fall)),
            Self::Undecided(undecided) => Some(&undecided.reason),
            Self::Refused(error) => Some(error),
        }
    }
}

impl Answer {
    /// Without values.
    fn new(subject: Subject, status: Status) -> Self {
        Self {
            subject,
            status,
            can_stand: None,
            stands: None,
            modes: Vec::new(),
            values: Vec::new(),
            proof: None,
            certificate: Err("certificates are hashed for landmarks only".into()),
            kept: Vec::new(),
        }
    }

    /// A landmark with some of its constants, or why they are not proved.
    pub fn landmark(
        (landmark, weight): (Landmark, SelfWeight),
        found: Result<(&CertifiedLandmark, Vec<Constant>), &Undecided>,
    ) -> Self {
        let mut answer = Self::new(Subject::Landmark { landmark, weight }, Status::Proved);
        match found {
            Ok((point, constants)) => {
                let value = |constant: Constant| (constant.quantity, Value::constant(constant));
                answer.values = constants.into_iter().map(value).collect();
                answer.proof = Some(Proof::new(point));
                answer.certificate = Err("not asked for".into());
            }
            Err(undecided) => {
                answer.status = Status::Undecided(undecided.clone());
                answer.certificate = Err("nothing is proved".into());
            }
        }
        answer
    }

    /// The same with the hash of the certificate of its values to `digits` digits, or why there is none
    /// ([`fingerprint`](crate::certify::fingerprint)). What is not proved has no certificate.
    pub fn with_certificate(mut self, digits: usize, hash: Result<String, Undecided>) -> Self {
        if let (Subject::Landmark { landmark, weight }, Some(_)) = (&self.subject, &self.proof) {
            let (symbol, weight) = (landmark.symbol(), weight.name());
            let command = format!("couplet certify {symbol} --weight {weight} --digits {digits}");
            self.certificate = hash
                .map(|sha256| Fingerprint { command, sha256 })
                .map_err(|undecided| undecided.reason.into_owned());
        }
        self
    }

    /// The state of an arch at its least thickness. The line tells arches apart.
    pub fn state(line: u64, arch: &Arch, found: &Result<Outcome, Undecided>) -> Self {
        let mut answer = Self::new(Subject::arch(line, arch, None), Status::Proved);
        match found {
            Ok(Outcome::Stands(digits)) => {
                answer.can_stand = Some(true);
                answer.modes = vec![digits.mode];
                answer.values = digits.figures().map(|(of, x)| (of, Value::figure(x))).collect();
            }
            Ok(Outcome::Falls(fall)) => {
                answer.can_stand = Some(false);
                answer.status = Status::Falls(*fall);
            }
            Err(undecided) => answer.status = Status::Undecided(undecided.clone()),
        }
        answer
    }

    /// An arch of a given thickness.
    pub fn assessment(
        line: u64,
        (arch, thickness): (&Arch, &ExactNumber),
        found: &Result<AssessmentDigits, Undecided>,
    ) -> Self {
        let mut answer = Self::new(Subject::arch(line, arch, Some(thickness)), Status::Proved);
        match found {
            Ok(digits) => {
                answer.stands = Some(digits.stands);
                if let Err(fall) = digits.least_thickness {
                    answer.status = Status::Falls(fall);
                }
                answer.values = digits.figures().map(|(of, x)| (of, Value::figure(x))).collect();
                let thrusts = answer.values.iter_mut().filter(|(of, _)| of.joint().is_some());
                for ((_, value), limit) in thrusts.zip(digits.thrust.iter().flatten()) {
                    value.limited_by = Some(limit.limited_by);
                }
            }
            Err(undecided) => answer.status = Status::Undecided(undecided.clone()),
        }
        answer
    }

    /// A query that could not be read, and why.
    pub fn refused(line: u64, error: String) -> Self {
        Self::new(Subject::Query { line }, Status::Refused(error))
    }

    /// The value of a quantity, if there is one.
    pub fn value(&self, quantity: Quantity) -> Option<&Value> {
        let is_least = quantity == Quantity::LeastThickness && !self.subject.is_assessed();
        // The thickness of a state is the least.
        let quantity = if is_least { Quantity::Thickness } else { quantity };
        self.values.iter().find(|(of, _)| *of == quantity).map(|(_, value)| value)
    }

    /// The same with only some of its values; with a thrust stays the joint that limits it.
    pub fn only(mut self, quantities: &[Quantity]) -> Self {
        let asked: Vec<Quantity> = quantities
            .iter()
            .flat_map(|&quantity| [Some(quantity), quantity.joint()])
            .flatten()
            .collect();
        self.values.retain(|(quantity, _)| asked.contains(quantity));
        self
    }

    /// Whether nothing could be told.
    pub fn is_undecided(&self) -> bool {
        matches!(self.status, Status::Undecided(_))
    }
}

impl Subject {
    fn arch(line: u64, arch: &Arch, thickness: Option<&ExactNumber>) -> Self {
        Self::Arch {
            line,
            weight: arch.weight(),
            half_opening: arch.half_opening().to_string(),
            friction: arch.friction().to_string(),
            thickness: thickness.map(ToString::to_string),
            doubles: GivenDoubles::new(arch, thickness),
        }
    }

    /// Whether it is an arch of a given thickness.
    pub fn is_assessed(&self) -> bool {
        matches!(self, Self::Arch { thickness: Some(_), .. })
    }

    /// The landmark, if it is one.
    pub fn landmark(&self) -> Option<Landmark> {
        match self {
            Self::Landmark { landmark, .. } => Some(*landmark),
            Self::Arch { .. } | Self::Query { .. } => None,
        }
    }

    /// The line of a query.
    pub fn line(&self) -> Option<u64> {
        match self {
            Self::Landmark { .. } => None,
            Self::Arch { line, .. } | Self::Query { line } => Some(*line),
        }
    }

    /// The self-weight model, where it could be read.
    pub fn weight(&self) -> Option<SelfWeight> {
        match self {
            Self::Landmark { weight, .. } | Self::Arch { weight, .. } => Some(*weight),
            Self::Query { .. } => None,
        }
    }
}

impl Proof {
    fn new(point: &CertifiedLandmark) -> Self {
        let isolated = point.isolated();
        let system = isolated.system();
        let unknowns = system.unknowns.iter().copied().map(Unknown::name);
        Self {
            equations: system.equations.iter().copied().map(Equation::label).collect(),
            radii: unknowns.zip(isolated.relative_radii()).collect(),
        }
    }
}
