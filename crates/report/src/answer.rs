//! An answer about a landmark or an arch: all that a format sees.
//!
//! **No format computes anything.** Doubles are correctly rounded and their bounds rounded outward before
//! they come here ([`Binary`](crate::number::Binary)). What is not proved has a reason and no values.

use super::kept::Kept;
use super::subject::Subject;
use super::understood::{Understood, joined};
use super::value::Value;
use super::words::reason;
use crate::arch::{SelfWeight, Unknown};
use crate::ask::notes;
use crate::certify::state::find::{Finding, Question};
use crate::certify::state::{
    Answer as Outcome, AssessmentDigits, Enough, Fall, Figure, SomeDigits,
};
use crate::certify::{CertifiedLandmark, Constant, Error, Refused, Undecided};
use crate::number::ExactNumber;
use crate::problem::Arch;
use crate::problem::asymmetric_region::{LOOK, MAY_MOVE};
use crate::problem::measures::Circle;
use crate::problem::{Equation, Friction, Landmark, Mode, Quantity};
use std::borrow::Cow;

/// A landmark or an arch, what became of it, and its proved values.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Subject of the answer.
    pub subject: Subject,
    /// Question as it is understood, where it was asked about one arch.
    pub asked: Option<Box<Understood>>,
    /// Status of the subject.
    pub status: Status,
    /// True if an arch can stand at some thickness, where that is asked and decided.
    pub can_stand: Option<bool>,
    /// True if an arch stands at the thickness that it has, where that is decided.
    pub stands: Option<bool>,
    /// Modes in which an arch collapses at its least thickness; at a landmark the modes that meet there, if
    /// asked for.
    pub modes: Vec<Mode>,
    /// The values, all proved.
    pub values: Vec<(Quantity, Value)>,
    /// The quantities of an arch of a given thickness that could not be decided, and why.
    pub open: Vec<(Quantity, Undecided)>,
    /// The circle at which an arch is measured, where it is.
    pub measured_at: Option<Circle>,
    /// Remedies for an arch that stands at no thickness: the least friction at its half opening, and the
    /// widest half opening (rad) with its friction.
    pub enough: [Option<Value>; 2],
    /// The thicknesses of the asymmetric solutions of (19) that are found for an arch that stands, the largest first.
    pub asymmetric: Vec<Figure>,
    /// True if an asymmetric solution is known of any of the arches of which a finding says that they stand.
    pub some_may_move: bool,
    /// Statement that is proved of a finding besides its digits.
    pub proved: Option<String>,
    /// Note on what may have been meant otherwise.
    pub note: Option<String>,
    /// Proof of a landmark.
    pub proof: Option<Proof>,
    /// The certificate that holds these values, or why there is none.
    pub certificate: Result<Fingerprint, String>,
    /// Values that the query has beside the arch, by name, and is handed on.
    pub kept: Vec<(String, Kept)>,
}

/// Status of a subject.
#[derive(Clone, Debug)]
pub enum Status {
    /// The values of the subject are proved.
    Proved,
    /// A proof says that no thickness is enough.
    Falls(Fall),
    /// Nothing is known of the subject.
    Undecided(Undecided),
    /// The query is wrong, and how.
    Refused(String),
}

/// Proof of a landmark: one solution of its equations in a box.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The equations.
    pub equations: Vec<&'static str>,
    /// The radius of the box for each unknown, relative to its value.
    pub radii: Vec<(&'static str, f64)>,
}

/// Extent of what is made of an answer: what is not shown is not made, where many rows would pay for it.
#[derive(Clone, Copy, Debug)]
pub struct Extent<'a> {
    /// The quantities of which values are shown, if not of all.
    pub quantities: Option<&'a [Quantity]>,
    /// True if given values are shown as doubles.
    pub doubles: bool,
}

impl Extent<'_> {
    /// All that any format shows.
    pub const ALL: Self = Self { quantities: None, doubles: true };

    /// Tells whether a value is shown; what goes with the verdict is.
    pub fn shows(self, of: Quantity) -> bool {
        of == Quantity::AsymmetricThickness
            || self.quantities.is_none_or(|all| all.iter().any(|asked| asked.tells(of)))
    }
}

/// Fingerprint that ties values to a certificate.
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

    /// Reason why there are no values, or why an arch falls.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Proved => None,
            Self::Falls(fall) => Some(reason(*fall)),
            Self::Undecided(undecided) => Some(&undecided.reason),
            Self::Refused(error) => Some(error),
        }
    }
}

impl From<&Error> for Status {
    fn from(error: &Error) -> Self {
        match error {
            Error::Undecided(undecided) => Self::Undecided(undecided.clone()),
            Error::Refused(refused) => Self::Refused(refused.to_string()),
        }
    }
}

/// Reason why no friction is enough at a thickness.
const TOO_THIN: &str = "there is none: the arch is too thin, whatever the friction";

impl Answer {
    /// Answer without values.
    fn new(subject: Subject, status: Status) -> Self {
        Self {
            subject,
            asked: None,
            status,
            can_stand: None,
            stands: None,
            modes: Vec::new(),
            values: Vec::new(),
            open: Vec::new(),
            measured_at: None,
            enough: [None, None],
            asymmetric: Vec::new(),
            some_may_move: false,
            proved: None,
            note: None,
            proof: None,
            certificate: Err("certificates are hashed for landmarks only".into()),
            kept: Vec::new(),
        }
    }

    /// Answer with a note on its friction, if there is one.
    fn with_note(self, friction: Option<&Friction>) -> Self {
        Self { note: joined(notes(friction)), ..self }
    }

    /// A landmark with some of its constants, or why they are not proved.
    pub fn landmark(
        (landmark, weight): (Landmark, SelfWeight),
        found: Result<(&CertifiedLandmark, Vec<Constant>), &Error>,
    ) -> Self {
        let mut answer = Self::new(Subject::Landmark { landmark, weight }, Status::Proved);
        match found {
            Ok((point, constants)) => {
                let value = |constant: Constant| (constant.quantity, Value::constant(constant));
                answer.values = constants.into_iter().map(value).collect();
                answer.proof = Some(Proof::new(point));
                answer.certificate = Err("not asked for".into());
            }
            Err(error) => {
                answer.status = error.into();
                answer.certificate = Err("nothing is proved".into());
            }
        }
        answer
    }

    /// Answer with the hash of the certificate of its values to `digits` digits, or why there is none
    /// ([`fingerprint`](crate::certify::fingerprint)). What is not proved has no certificate.
    pub fn with_certificate(mut self, digits: usize, hash: Result<String, Error>) -> Self {
        if let (Subject::Landmark { landmark, weight }, Some(_)) = (&self.subject, &self.proof) {
            let (symbol, weight) = (landmark.symbol(), weight.name());
            let command = format!("couplet certify {symbol} --weight {weight} --digits {digits}");
            self.certificate =
                hash.map(|sha256| Fingerprint { command, sha256 }).map_err(|error| match error {
                    Error::Refused(Refused::Digits { most, .. }) => {
                        format!("made up to {most} digits only")
                    }
                    Error::Refused(refused) => refused.to_string(),
                    Error::Undecided(undecided) => undecided.reason.into_owned(),
                });
        }
        self
    }

    /// The state of an arch at its least thickness. The line tells arches apart.
    pub fn state(line: u64, arch: &Arch, found: &Result<Outcome, Error>) -> Self {
        let all = |found: Outcome| found.map(|digits| digits.only(|_| true));
        Self::state_to(Extent::ALL, line, arch, found.clone().map(all))
    }

    /// The state of an arch at its least thickness, as far as it is shown.
    pub fn state_to(
        extent: Extent,
        line: u64,
        arch: &Arch,
        found: Result<Outcome<SomeDigits>, Error>,
    ) -> Self {
        let mut answer =
            Self::new(Subject::arch(line, (arch, None), extent.doubles), Status::Proved)
                .with_note(Some(arch.friction()));
        match found {
            Ok(Outcome::Stands(SomeDigits { mode, values })) => {
                answer.can_stand = Some(true);
                answer.modes = vec![mode];
                let shown = values.into_iter().filter(|(of, _)| extent.shows(*of));
                answer.values = shown.map(|(of, x)| (of, Value::from(x))).collect();
            }
            Ok(Outcome::Falls { fall, enough }) => {
                answer.can_stand = Some(false);
                answer.status = Status::Falls(fall);
                if let Some(Enough { sliding_friction, friction, half_opening, .. }) =
                    enough.as_deref()
                {
                    let value = |x: &Figure| Value::figure(Some(x));
                    let sliding = sliding_friction.as_ref().map(value);
                    answer.values =
                        sliding.map(|x| (Quantity::SlidingFriction, x)).into_iter().collect();
                    answer.enough = [friction, half_opening].map(|x| x.as_ref().map(value));
                }
            }
            Err(error) => answer.status = (&error).into(),
        }
        answer
    }

    /// An arch of a given thickness, with given values as doubles where they are shown.
    pub fn assessment(
        extent: Extent,
        line: u64,
        (arch, thickness): (&Arch, &ExactNumber),
        found: &Result<AssessmentDigits, Refused>,
    ) -> Self {
        let mut answer =
            Self::new(Subject::arch(line, (arch, Some(thickness)), extent.doubles), Status::Proved)
                .with_note(Some(arch.friction()));
        match found {
            Ok(digits) => {
                match (&digits.stands, digits.fall) {
                    (Ok(stands), fall) => {
                        answer.stands = Some(*stands);
                        answer.status = fall.map_or(Status::Proved, Status::Falls);
                    }
                    (Err(open), _) => answer.status = Status::Undecided(open.clone()),
                }
                let open = digits.open().map(|(of, why)| (of, why.clone()));
                answer.open = open.collect();
                answer.values = digits.figures().map(|(of, x)| (of, Value::figure(x))).collect();
                let thrusts = answer.values.iter_mut().filter(|(of, _)| of.joint().is_some());
                for ((_, value), limit) in thrusts.zip(digits.limits().into_iter().flatten()) {
                    value.limited_by = Some(limit.touch.name());
                }
            }
            Err(refused) => answer.status = Status::Refused(refused.to_string()),
        }
        answer
    }

    /// Answer with the sizes of an arch that is measured at a circle, or why they are not proved.
    pub fn measured(
        mut self,
        circle: Circle,
        found: Result<Vec<(Quantity, Option<Figure>)>, Error>,
    ) -> Self {
        self.measured_at = Some(circle);
        match found {
            Ok(sizes) => {
                self.values.extend(sizes.iter().map(|(of, x)| (*of, Value::figure(x.as_ref()))))
            }
            // All are made from one state; the first stands for them.
            Err(Error::Undecided(undecided)) => self.open.push((Quantity::Radius, undecided)),
            Err(Error::Refused(refused)) => self.status = Status::Refused(refused.to_string()),
        }
        self
    }

    /// Answer with the [thicknesses](crate::certify::asymmetric_thicknesses) of its asymmetric solutions of
    /// (19), if it stands.
    pub fn with_asymmetric(
        mut self,
        thicknesses: impl FnOnce() -> Result<Vec<Figure>, Refused>,
    ) -> Self {
        if self.can_stand.or(self.stands) != Some(true) {
            return self;
        }
        match thicknesses() {
            Ok(all) => {
                self.asymmetric = all;
                let largest = self.asymmetric.first().map(|eta| Value::figure(Some(eta)));
                self.values.extend(largest.map(|eta| (Quantity::AsymmetricThickness, eta)));
            }
            Err(refused) => self.status = Status::Refused(refused.to_string()),
        }
        self
    }

    /// Answer to a question asked the other way round.
    pub fn finding(
        line: u64,
        (weight, question): (SelfWeight, &Question),
        found: Result<Finding, Undecided>,
    ) -> Self {
        let mut answer = Self::new(Subject::sought(line, weight, question), Status::Proved)
            .with_note(question.friction());
        match found {
            Ok(Finding::Found(found)) => {
                let values = found.figures.into_iter();
                answer.values = values.map(|(of, x)| (of, Value::from(Some(x)))).collect();
                answer.modes = found.modes;
                answer.proved = Some(found.proved);
                answer.some_may_move = found.some_may_move;
            }
            Ok(Finding::Nothing(fall)) => {
                answer.stands = Some(false);
                match fall {
                    Some(fall) => answer.status = Status::Falls(fall),
                    None => answer.proved = Some(TOO_THIN.to_owned()),
                }
            }
            Ok(Finding::Beyond(line, ends)) => {
                answer.proved = Some(format!("there is none: the line {line} runs from {ends}"));
            }
            Err(undecided) => answer.status = Status::Undecided(undecided),
        }
        answer
    }

    /// Statement that is proved of a finding besides its digits, and what that leaves open.
    pub fn proved_in_words(&self) -> Option<String> {
        let proved = self.proved.clone()?;
        let known = "asymmetric mechanisms are known of some of these arches";
        Some(match self.some_may_move {
            true => format!("{proved}\n{known}: {MAY_MOVE} ({LOOK})"),
            false => proved,
        })
    }

    /// A query that could not be read, and why.
    pub fn refused(line: u64, error: String) -> Self {
        Self::new(Subject::Query { line }, Status::Refused(error))
    }

    /// Reason why a query could not be read, or is wrong.
    pub fn fault(&self) -> Option<&str> {
        match &self.status {
            Status::Refused(error) => Some(error),
            _ => None,
        }
    }

    /// Tells whether the query could be read; of another only that is told.
    pub(super) fn is_read(&self) -> bool {
        !matches!(self.subject, Subject::Query { .. })
    }

    /// The value of a quantity, if there is one.
    pub fn value(&self, quantity: Quantity) -> Option<&Value> {
        let is_least = quantity == Quantity::LeastThickness && !self.subject.is_assessed();
        // The thickness of a state is the least.
        let quantity = if is_least { Quantity::Thickness } else { quantity };
        self.values.iter().find(|(of, _)| *of == quantity).map(|(_, value)| value)
    }

    /// Answer with only the values of some quantities, and what goes with them.
    pub fn only(mut self, quantities: &[Quantity]) -> Self {
        let extent = Extent { quantities: Some(quantities), ..Extent::ALL };
        self.values.retain(|(quantity, _)| extent.shows(*quantity));
        // One size that stays open stands for all.
        let is_asked = |of: Quantity| {
            extent.shows(of) || of.is_measured() && quantities.iter().any(|of| of.is_measured())
        };
        self.open.retain(|(quantity, _)| is_asked(*quantity));
        self
    }

    /// Tells whether not everything could be told.
    pub fn is_undecided(&self) -> bool {
        self.first_open().is_some()
    }

    /// Outcome of a search in a word; that there is "nothing" is proved.
    pub fn search(&self) -> &'static str {
        match (&self.status, self.values.is_empty()) {
            (Status::Undecided(_) | Status::Refused(_), _) => self.status.name(),
            (Status::Proved | Status::Falls(_), true) => "nothing",
            (Status::Proved | Status::Falls(_), false) => "found",
        }
    }

    /// First question that could not be told, and why: all of it, or the first quantity that stays open.
    pub fn first_open(&self) -> Option<Undecided> {
        match &self.status {
            Status::Undecided(undecided) => Some(undecided.clone()),
            _ => self.open.first().map(|(of, why)| why.clone().about(of.name())),
        }
    }

    /// Reason why there are no values, why an arch falls, or which quantities stay open and why.
    pub fn reason(&self) -> Option<Cow<'_, str>> {
        if self.open.is_empty() || matches!(self.status, Status::Undecided(_)) {
            return self.status.reason().map(Cow::Borrowed);
        }
        let open = self.open.iter().map(|(of, why)| format!("{}: {}", of.name(), why.reason));
        let known = self.status.reason().map(str::to_owned).into_iter();
        Some(known.chain(open).collect::<Vec<_>>().join("; ").into())
    }

    /// Reason why a quantity stays open, if it does.
    pub fn why_open(&self, quantity: Quantity) -> Option<&Undecided> {
        self.open.iter().find(|(of, _)| *of == quantity).map(|(_, why)| why)
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
