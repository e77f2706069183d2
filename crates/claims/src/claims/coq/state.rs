//! The file of a state: its one solution, the signs that are left, and what they make of it.

use super::asymmetric;
use super::given::friction;
use super::names::{BITS, DECIMALS};
use super::numeral::unit;
use super::root::CoqRoot;
use super::solution::{CoqSolution, Holes};
use super::stands::{admissibility, conjunction, signs};
use crate::arch::Unknown;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::Undecided;
use crate::check::{Certificate, Refusal, verify};
use crate::number::{Ball, Magnitude};
use crate::problem::{Arch, Mode, Problem, Verdict};
use rug::float::Round;
use rug::{Float, Rational};

/// Reason why a certificate does not become a theorem.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StateError {
    /// The checker does not accept it.
    #[error("refused: {0}")]
    Refused(#[from] Refusal),
    /// The certificate is about something else.
    #[error(
        "it is not the certificate of a state, of an arch that slides (`couplet certify state` writes them), or of an \
         asymmetric solution with an inner joint that slides (`couplet certify asymmetric`)"
    )]
    NotState,
    /// The numbers for Coq were not found.
    #[error(transparent)]
    Undecided(#[from] Undecided),
}

/// The file of the state that a certificate is about, name and content, after a check of the certificate.
///
/// Of an arch that slides it is the purely sliding state, which has no thickness but a friction. Of the asymmetric
/// solutions those with an inner joint that slides have one.
pub fn state(certificate: &[u8]) -> Result<(String, String), StateError> {
    let problem = verify(certificate)?.problem;
    let root = || -> Result<CoqRoot, StateError> {
        Ok(CoqRoot::of_certificate(&problem, &Certificate::read(certificate)?)?)
    };
    let (mode, arch) = match &problem {
        Problem::State { mode, arch } => (*mode, arch),
        Problem::Verdict { verdict: Verdict::Slides, arch } => (Mode::Sliding, arch),
        Problem::Asymmetric { mode: AsymmetricMode::InnerSliding, arch } => {
            return Ok(asymmetric::file(&root()?, arch)?);
        }
        _ => return Err(StateError::NotState),
    };
    let root = root()?;
    let mut solution = CoqSolution::of_arch(&root, arch)?;
    signs_hold(&problem, &root, &solution)?;
    solution.values.extend(claims(&problem, mode, arch, &solution));
    // Pure sliding does not know the weight.
    let (weight, heading, theorems) = match mode {
        Mode::Sliding => (
            String::new(),
            include_str!("templates/sliding.v"),
            [
                include_str!("templates/signs.v"),
                include_str!("templates/less_friction.v"),
                include_str!("templates/least_friction.v"),
            ],
        ),
        _ => (
            format!("{:?}", arch.weight()),
            include_str!("templates/state.v"),
            [
                include_str!("templates/signs.v"),
                include_str!("templates/stands.v"),
                include_str!("templates/least_thickness.v"),
            ],
        ),
    };
    Ok((format!("State{mode:?}{weight}.v"), solution.between(heading, &theorems)))
}

/// Tells whether the digits that are printed tell every sign.
fn signs_hold(problem: &Problem, root: &CoqRoot, solution: &CoqSolution) -> Result<(), Undecided> {
    let radius = Magnitude::upper(&Float::with_val_round(64, unit(DECIMALS), Round::Up).0);
    let digits = |x: &Rational| Ball::enclosing(x, BITS).widened(radius);
    let narrow: Vec<Ball> = solution.table.centre.iter().map(digits).collect();
    let at = root.system.place(root.given.clone(), &narrow);
    problem.first_failure(&at, BITS).map_or(Ok(()), |open| {
        let open = open.label();
        Err(Undecided::new(format!("for Coq: {DECIMALS} decimals do not tell {open}")))
    })
}

/// Claims on the state beside the digits of its solution.
fn claims(problem: &Problem, mode: Mode, arch: &Arch, solution: &CoqSolution) -> Holes {
    let system = problem.system();
    let mut signs = signs(problem.conditions(), &system);
    let (least, looked_at) = match mode {
        Mode::Sliding => (Unknown::Friction, "the joints that slide, and the friction of the arch"),
        _ => (Unknown::Thickness, "the ends of the arch and the joints that open or slide"),
    };
    let friction = friction(arch);
    if let (Mode::Sliding, Some(mu)) = (mode, &friction) {
        signs.extend(["0 < alpha".into(), "alpha < PI".into()]);
        signs.extend([format!("0 <= {mu}"), format!("{mu} < mu")]);
    }
    let mut values = vec![
        ("mode", mode.label().into()),
        ("signs", conjunction(&signs)),
        ("looked_at", looked_at.into()),
        ("tied", String::new()),
        ("less_friction", "state".into()),
        ("least", solution.centre(&system, least)),
        ("friction", friction.unwrap_or_default()),
    ];
    values.extend(admissibility(mode, arch.is_limited(), &system));
    values
}
