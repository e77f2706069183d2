//! The file of a state: its one solution, the signs that are left, and what they make of it.

use super::asymmetric;
use super::given::friction;
use super::names::{BITS, DECIMALS, argument};
use super::numeral::unit;
use super::root::CoqRoot;
use super::sign::sign;
use super::solution::{CoqSolution, Holes};
use crate::arch::Unknown;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::Undecided;
use crate::check::{Certificate, Refusal, verify};
use crate::number::{Ball, Magnitude};
use crate::problem::{Arch, Mode, Problem, System, Verdict};
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
    let (weight, templates) = match mode {
        Mode::Sliding => (
            String::new(),
            [include_str!("templates/sliding.v"), include_str!("templates/least_friction.v")],
        ),
        _ => (
            format!("{:?}", arch.weight()),
            [include_str!("templates/state.v"), include_str!("templates/least_thickness.v")],
        ),
    };
    Ok((format!("State{mode:?}{weight}.v"), solution.between(templates)))
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
    let conditions = problem.conditions().into_iter().flat_map(|(_, conditions)| conditions);
    let mut signs: Vec<String> = conditions.filter_map(|c| sign(c, mode, &system)).collect();
    let least = match mode {
        Mode::Sliding => Unknown::Friction,
        _ => Unknown::Thickness,
    };
    let friction = friction(arch);
    if let (Mode::Sliding, Some(mu)) = (mode, &friction) {
        signs.extend(["0 < alpha".into(), "alpha < PI".into()]);
        signs.extend([format!("0 <= {mu}"), format!("{mu} < mu")]);
    }
    let mut values = vec![
        ("mode", mode.label().into()),
        ("signs", signs.join(" /\\\n  ")),
        ("least", solution.centre(&system, least)),
        ("friction", friction.unwrap_or_default()),
    ];
    values.extend(admissibility(mode, arch, &system));
    values
}

/// Claims on the whole half arch, and the theorem of `States.v` behind it.
fn admissibility(mode: Mode, arch: &Arch, system: &System) -> Holes {
    let delta = system.weight.flag();
    let h = argument(system, Unknown::Thrust);
    let moment = match mode {
        Mode::Rotational | Mode::SlidingRotational => format!("(at_crown eta {h})"),
        Mode::Overturning => "0".into(),
        _ => format!("(at_shoulder {delta} alpha eta {h})"),
    };
    let theorem = match mode {
        Mode::Rotational if arch.is_limited() => "rotational",
        Mode::Rotational => "rotational_without_limit",
        Mode::SlidingRotational => "sliding_rotational",
        Mode::RotationalSliding | Mode::RotationalSlidingRotational => "rotational_sliding",
        Mode::OverturningSliding => "overturning_sliding",
        Mode::Overturning => "overturning",
        Mode::Sliding => "purely_sliding",
    };
    let [admissible, stands_from, holds, mu] = match arch.is_limited() {
        true => ["admissible", "stands_from", ", and friction holds,", " mu"],
        false => ["thrust_inside", "stands_without_limit_from", "", ""],
    };
    vec![
        ("admissible", format!("{admissible} {delta} alpha eta{mu} {h} {moment}")),
        ("stands_from", format!("{stands_from} {delta} alpha{mu}")),
        ("holds", holds.into()),
        ("theorem", format!("{theorem} {delta} alpha{mu}")),
    ]
}
