//! The neutral list: what was proved of a landmark or of an arch, ready to be written.

use super::label::{
    FRICTION_SAFETY, GEOMETRIC_SAFETY, LEAST_THICKNESS, Label, REQUIRED_FRICTION,
    ROTATIONAL_FRICTION, SLIDING_FRICTION, THRUST_LIMITS,
};
use crate::arch::{SelfWeight, Unknown};
use crate::certify::state::Figure;
use crate::certify::{Constant, Value};
use crate::number::{Binary, Rounded};
use crate::problem::published::PRINTED;
use crate::problem::{Equation, Landmark, Mode, Quantity};
use crate::report::{AssessReport, LandmarkReport, StateOf, StateReport, reason as reason_of_fall};

/// A landmark or an arch with its values.
#[derive(Debug)]
pub struct Subject {
    /// What it is.
    pub of: Of,
    /// Whether its values are proved.
    pub status: Status,
    /// The values: all proved. None where the status is another, or where an arch does not stand.
    pub values: Vec<Exported>,
    /// How a landmark is proved.
    pub proof: Option<Proof>,
    /// The certificate that holds these values.
    pub certificate: Certificate,
}

/// What a subject is.
#[derive(Debug)]
pub enum Of {
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
        number: u64,
        /// The self-weight model.
        weight: SelfWeight,
        /// The half opening as given.
        half_opening: String,
        /// The friction as given.
        friction: String,
        /// The thickness as given, where the arch has one.
        thickness: Option<String>,
        /// Whether it stands, where that is decided.
        stands: Option<bool>,
        /// How it collapses at its least thickness.
        mode: Option<Mode>,
    },
    /// A query that could not be read.
    Query {
        /// Its line.
        number: u64,
    },
}

/// Whether values are proved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// They are. Of an arch that does not stand, the word why.
    Proved(Option<String>),
    /// Nothing is known, and why.
    Undecided(String),
    /// The query is wrong, and how.
    Refused(String),
}

/// How a landmark is proved: one solution of its equations in a box.
#[derive(Debug)]
pub struct Proof {
    /// The equations.
    pub equations: Vec<&'static str>,
    /// The radius of the box for each unknown, relative to its value.
    pub radii: Vec<(&'static str, f64)>,
}

/// The certificate of the same values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Certificate {
    /// What writes it, and the SHA-256 of what is written.
    Hash {
        /// The command.
        command: String,
        /// In hexadecimal.
        sha256: String,
    },
    /// There is none, and why.
    None(String),
}

/// One proved value.
#[derive(Debug)]
pub struct Exported {
    /// What it is called.
    pub label: Label,
    /// The true value correctly rounded; `None` for infinity.
    pub decimal: Option<Rounded>,
    /// The nearest double of the true value.
    pub double: f64,
    /// What that double leaves open.
    pub binary: Binary,
    /// The exact value, where there is one.
    pub exact: Option<String>,
    /// What the paper prints for it, each text once. Not proved.
    pub printed: Vec<&'static str>,
}

impl Status {
    /// The word for it, and the reason that goes with it.
    pub fn words(&self) -> (&'static str, Option<&str>) {
        match self {
            Self::Proved(reason) => ("proved", reason.as_deref()),
            Self::Undecided(reason) => {
                ("undecided", Some(reason.strip_prefix("undecided: ").unwrap_or(reason)))
            }
            Self::Refused(reason) => ("refused", Some(reason)),
        }
    }
}

impl Exported {
    /// The texts of the value, its lower and its upper bound; all `inf` for infinity.
    pub fn texts(&self) -> [String; 3] {
        match &self.decimal {
            Some(decimal) => {
                [&decimal.value, &decimal.lower, &decimal.upper].map(ToString::to_string)
            }
            None => [(); 3].map(|()| "inf".to_owned()),
        }
    }

    /// The exact value where it says more than the digits.
    pub fn closed_form(&self) -> Option<&str> {
        self.exact.as_deref().filter(|exact| *exact != self.texts()[0])
    }

    /// The nearest quadruple with the 36 digits that tell every one from its neighbours; `None` where it
    /// is not known.
    pub fn quad(&self) -> Option<String> {
        let digits = |quad: &rug::Float| quad.to_string_radix(10, Some(36));
        self.binary.quad.as_ref().map(digits)
    }

    fn constant(constant: &Constant) -> Self {
        let Constant { landmark, weight, quantity, .. } = *constant;
        let mut printed: Vec<&str> = PRINTED
            .iter()
            .filter(|p| (p.landmark, p.weight, p.quantity) == (landmark, weight, quantity))
            .map(|p| p.text)
            .collect();
        printed.sort_unstable();
        printed.dedup();
        Self {
            label: quantity.into(),
            decimal: match &constant.value {
                Value::Finite(decimal) => Some(decimal.clone()),
                Value::Infinite => None,
            },
            double: constant.double,
            binary: constant.binary.clone(),
            exact: constant.exact.clone(),
            printed,
        }
    }

    fn figure(label: impl Into<Label>, figure: &Figure) -> Self {
        Self {
            label: label.into(),
            decimal: Some(figure.decimal.clone()),
            double: figure.double,
            binary: figure.binary.clone(),
            exact: None,
            printed: Vec::new(),
        }
    }

    fn infinite(label: Label) -> Self {
        Self {
            label,
            decimal: None,
            double: f64::INFINITY,
            binary: Binary::infinite(),
            exact: Some("inf".into()),
            printed: Vec::new(),
        }
    }
}

impl Subject {
    /// A landmark to `digits` digits, with the hash of its certificate or why there is none.
    pub fn landmark(report: &LandmarkReport, digits: usize) -> Self {
        let LandmarkReport { landmark, weight, .. } = *report;
        let command = format!(
            "couplet certify {} --weight {} --digits {digits}",
            landmark.symbol(),
            weight.name()
        );
        let certificate = match (&report.outcome, &report.fingerprint) {
            (Err(_), _) => Certificate::None("nothing is proved".into()),
            (_, Some(Ok(sha256))) => Certificate::Hash { command, sha256: sha256.clone() },
            (_, Some(Err(reason))) => Certificate::None(reason.clone()),
            (_, None) => Certificate::None("not asked for".into()),
        };
        let (status, values, proof) = match &report.outcome {
            Err(reason) => (Status::Undecided(reason.clone()), Vec::new(), None),
            Ok(proved) => {
                let equations = proved.system.equations.iter().copied().map(Equation::label);
                let unknowns = proved.system.unknowns.iter().copied().map(Unknown::name);
                let radii = unknowns.zip(proved.relative_radii.iter().copied());
                let proof = Proof { equations: equations.collect(), radii: radii.collect() };
                let values = proved.constants.iter().map(Exported::constant);
                (Status::Proved(None), values.collect(), Some(proof))
            }
        };
        Self { of: Of::Landmark { landmark, weight }, status, values, proof, certificate }
    }

    /// The state of an arch at its least thickness.
    pub fn state(number: u64, report: &StateReport) -> Self {
        let (mut stands, mut mode, mut values) = (None, None, Vec::new());
        let status = match &report.outcome {
            StateOf::Stands(state) => {
                (stands, mode) = (Some(true), Some(state.mode));
                let joint = state.sliding_joint.as_ref();
                let mut add = |label: Label, figure| values.push(Exported::figure(label, figure));
                add(Quantity::Thickness.into(), &state.thickness);
                add(Quantity::Thrust.into(), &state.thrust);
                add(Quantity::IntrinsicThrust.into(), &state.intrinsic_thrust);
                add(Quantity::RotationJoint.into(), &state.rotation_joint);
                joint.into_iter().for_each(|figure| add(Quantity::SlidingJoint.into(), figure));
                if let Some(frictions) = &state.frictions {
                    add(SLIDING_FRICTION, &frictions.sliding);
                    values.push(optional(ROTATIONAL_FRICTION, frictions.rotational.as_ref()));
                }
                Status::Proved(None)
            }
            StateOf::Falls(fall) => {
                stands = Some(false);
                Status::Proved(Some(reason_of_fall(*fall).into()))
            }
            StateOf::Undecided(doubt) => Status::Undecided(doubt.question.into()),
        };
        let of = Of::Arch {
            number,
            weight: report.weight,
            half_opening: report.half_opening.clone(),
            friction: report.friction.clone(),
            thickness: None,
            stands,
            mode,
        };
        Self::arch(of, status, values)
    }

    /// An arch of a given thickness.
    pub fn assessment(number: u64, report: &AssessReport) -> Self {
        let mut values = Vec::new();
        let status = match report.outcome {
            Ok(found) => {
                let mut add = |label, figure: Option<&Figure>| {
                    values.extend(figure.map(|figure| Exported::figure(label, figure)));
                };
                add(LEAST_THICKNESS, found.least_thickness.as_ref().ok());
                add(GEOMETRIC_SAFETY, found.geometric_safety.as_ref());
                add(REQUIRED_FRICTION, found.required_friction.as_ref());
                add(FRICTION_SAFETY, found.friction_safety.as_ref());
                for (limit, [thrust, joint]) in found.thrust.iter().flatten().zip(THRUST_LIMITS) {
                    values.push(optional(thrust, limit.thrust.as_ref()));
                    values.extend(limit.joint.as_ref().map(|x| Exported::figure(joint, x)));
                }
                let fall = found.least_thickness.as_ref().err();
                Status::Proved(fall.map(|fall| reason_of_fall(*fall).into()))
            }
            Err(doubt) => Status::Undecided(doubt.question.into()),
        };
        let of = Of::Arch {
            number,
            weight: report.weight,
            half_opening: report.half_opening.clone(),
            friction: report.friction.clone(),
            thickness: Some(report.thickness.clone()),
            stands: report.outcome.as_ref().ok().map(|found| found.stands),
            mode: None,
        };
        Self::arch(of, status, values)
    }

    /// A query that could not be read, and why.
    pub fn refused(number: u64, error: &str) -> Self {
        Self::arch(Of::Query { number }, Status::Refused(error.to_owned()), Vec::new())
    }

    fn arch(of: Of, status: Status, values: Vec<Exported>) -> Self {
        let certificate = Certificate::None("certificates are hashed for landmarks only".into());
        Self { of, status, values, proof: None, certificate }
    }
}

/// A figure, or infinity where no number is enough.
fn optional(label: Label, figure: Option<&Figure>) -> Exported {
    figure.map_or_else(|| Exported::infinite(label), |figure| Exported::figure(label, figure))
}
