//! The certificate as a file: JSON, `couplet.certificate/1`, described in `docs/certificate.md`.

use super::object::{Object, given, given_object, list, lists, object, objects};
use super::refusal::Refusal;
use super::visible::{beginning, shortened};
use crate::arch::{SelfWeight, Unknown};
use crate::number::{Dyadic, ExactNumber};
use crate::problem::{Arch, Equation, Friction, Landmark, Mode, Problem, System};
use serde::{Deserialize, Serialize};
use std::io;

/// The schema of this version.
pub const SCHEMA: &str = "couplet.certificate/1";

/// A certificate: a claim about a root, and the witnesses that let a checker prove it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// [`SCHEMA`].
    pub schema: String,
    /// What made it, with the version; not checked.
    pub tool: String,
    /// What is claimed.
    #[serde(deserialize_with = "object")]
    pub claim: ClaimFile,
    /// How many significant digits the values have.
    pub digits: usize,
    /// The witness of existence and uniqueness in a large box.
    #[serde(deserialize_with = "object")]
    pub unique: Witness,
    /// An approximate inverse of the Jacobian at the centre of that box, row by row.
    #[serde(deserialize_with = "lists")]
    pub inverse: Vec<Vec<Dyadic>>,
    /// A small box that holds the root.
    #[serde(deserialize_with = "object")]
    pub root: Witness,
    /// The decimal values claimed.
    #[serde(deserialize_with = "objects")]
    pub values: Vec<ValueFile>,
}

impl Certificate {
    /// Writes the file, whose bytes depend on the certificate only.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut *out, self)?;
        writeln!(out)
    }
}

/// A box: all points within `radius` of `centre`, unknown by unknown.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Witness {
    /// The centre.
    #[serde(deserialize_with = "list")]
    pub centre: Vec<Dyadic>,
    /// The radii.
    #[serde(deserialize_with = "list")]
    pub radius: Vec<Dyadic>,
}

/// A decimal value.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ValueFile {
    /// The name of the quantity.
    pub quantity: String,
    /// The correct rounding, or `inf`.
    pub value: String,
}

/// What is claimed, in names and text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClaimFile {
    /// `heyman` or `milankovitch`.
    pub weight: String,
    /// The symbol of a landmark; not for a state.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    pub landmark: Option<String>,
    /// The state of an arch; not for a landmark.
    #[serde(default, deserialize_with = "given_object", skip_serializing_if = "Option::is_none")]
    pub state: Option<StateFile>,
    /// The names of what is solved for, in the order of every vector.
    #[serde(deserialize_with = "list")]
    pub unknowns: Vec<String>,
    /// The labels of what holds.
    #[serde(deserialize_with = "list")]
    pub equations: Vec<String>,
}

/// The state of an arch.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StateFile {
    /// The label of the mode.
    pub mode: String,
    /// The half opening, rad: a fraction of integers, with ` pi` behind it if pi is a factor.
    pub half_opening: String,
    /// The friction coefficient in the same form, or `inf`.
    pub friction: String,
}

/// Decimal digits of a number that is given.
const MAX_GIVEN: usize = 100_000;

impl Certificate {
    /// Reads a file, with or without a byte order mark. A file that is not such a certificate is refused with
    /// the place and the cause.
    pub fn read(bytes: &[u8]) -> Result<Self, Refusal> {
        let text = str::from_utf8(bytes).map_err(|error| Refusal::Encoding(error.valid_up_to()))?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let Object(certificate): Object<Self> =
            serde_json::from_str(text).map_err(|error| Refusal::Format(reason(&error)))?;
        if certificate.schema != SCHEMA {
            return Err(Refusal::Schema(shortened(&certificate.schema)));
        }
        Ok(certificate)
    }
}

/// Why a text is not a certificate. The reason may quote the text, which may be long and hold anything.
fn reason(error: &serde_json::Error) -> String {
    let words = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    match words.strip_suffix(&place) {
        Some(words) => beginning(words, 160) + &place,
        None => beginning(&words, 160),
    }
}

impl ClaimFile {
    /// The problem in the words of the file; `None` for a friction that is given as an angle, for which
    /// the format has no words.
    pub fn new(problem: &Problem) -> Option<Self> {
        let (landmark, state) = match problem {
            Problem::Landmark { landmark, .. } => (Some(landmark.symbol().to_owned()), None),
            Problem::State { mode, arch } => {
                let friction = match arch.friction() {
                    Friction::Coefficient(mu) => given_text(mu),
                    Friction::Infinite => "inf".to_owned(),
                    Friction::Angle(_) => return None,
                };
                let half_opening = given_text(arch.half_opening());
                let mode = mode.label().to_owned();
                (None, Some(StateFile { mode, half_opening, friction }))
            }
        };
        let system = problem.system();
        Some(Self {
            weight: system.weight.name().to_owned(),
            landmark,
            state,
            unknowns: system.unknowns.iter().map(|unknown| unknown.name().to_owned()).collect(),
            equations: system.equations.iter().map(|e| e.label().to_owned()).collect(),
        })
    }

    /// The problem, if every name is known and the unknowns and equations are those of the subject.
    pub fn resolve(&self) -> Result<Problem, Refusal> {
        let weight = named("weight", &self.weight, SelfWeight::ALL, SelfWeight::name)?;
        let problem = match (&self.landmark, &self.state) {
            (Some(symbol), None) => {
                let landmark = named("landmark", symbol, Landmark::ALL, Landmark::symbol)?;
                Problem::Landmark { landmark, weight }
            }
            (None, Some(state)) => state.resolve(weight)?,
            _ => return Err(Refusal::Subject),
        };
        let System { unknowns, equations, .. } = problem.system();
        let unknowns: Vec<&str> = unknowns.iter().copied().map(Unknown::name).collect();
        let equations: Vec<&str> = equations.iter().copied().map(Equation::label).collect();
        for (place, given, expected) in
            [("unknowns", &self.unknowns, unknowns), ("equations", &self.equations, equations)]
        {
            if *given != expected {
                return Err(Refusal::Mismatch { place, expected: expected.join(", ") });
            }
        }
        Ok(problem)
    }
}

fn named<T: Copy, const N: usize>(
    place: &'static str,
    text: &str,
    all: [T; N],
    name: fn(T) -> &'static str,
) -> Result<T, Refusal> {
    all.into_iter()
        .find(|x| name(*x) == text)
        .ok_or_else(|| Refusal::Name { place, text: shortened(text) })
}

impl StateFile {
    fn resolve(&self, weight: SelfWeight) -> Result<Problem, Refusal> {
        let mode = named("mode", &self.mode, Mode::ALL, Mode::label)?;
        if mode == Mode::Sliding {
            // No thickness belongs to it.
            return Err(Refusal::Name { place: "mode", text: self.mode.clone() });
        }
        let refused = |place, text: &str| Refusal::Given { place, text: shortened(text) };
        let number = |place, text: &str| read_given(text).ok_or_else(|| refused(place, text));
        let friction = match self.friction.as_str() {
            "inf" => Friction::Infinite,
            text => Friction::Coefficient(number("friction", text)?),
        };
        if !mode.exists_with(friction != Friction::Infinite) {
            return Err(refused("friction", &self.friction));
        }
        let half_opening = number("half_opening", &self.half_opening)?;
        let arch = Arch::new(weight, half_opening, friction);
        let arch = arch.map_err(|_| refused("half_opening", &self.half_opening))?;
        Ok(Problem::State { mode, arch })
    }
}

/// `49/20`, or `49/20 pi`: how a certificate gives a number.
pub(crate) fn given_text(x: &ExactNumber) -> String {
    let pi = if x.is_rational() { "" } else { " pi" };
    format!("{}/{}{pi}", x.factor().numer(), x.factor().denom())
}

/// Reads that form: two integers in decimal digits, the second above zero.
fn read_given(text: &str) -> Option<ExactNumber> {
    let (quotient, times_pi) = match text.strip_suffix(" pi") {
        Some(quotient) => (quotient, true),
        None => (text, false),
    };
    let (numerator, denominator) = quotient.split_once('/')?;
    let is_integer = |text: &str| {
        (1..=MAX_GIVEN).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit())
    };
    if !is_integer(numerator) || !is_integer(denominator) {
        return None;
    }
    ExactNumber::fraction(numerator.parse().ok()?, denominator.parse().ok()?, times_pi)
}
