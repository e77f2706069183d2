//! The file of a state: its one solution, the signs that are left, and what they make of it.

use super::numeral::{text, unit};
use super::sign::sign;
use super::solution::{Solution, Values};
use super::table::{DECIMALS, Root};
use super::template::fill;
use super::{BITS, argument, symbol};
use crate::arch::Unknown;
use crate::certify::{Undecided, isolate_root};
use crate::check::{Certificate, Refusal, verify};
use crate::number::{Ball, Dyadic, Engine, ExactNumber, Magnitude};
use crate::problem::{Arch, Friction, Mode, Problem};
use crate::solve::Candidate;
use rug::{Float, Rational};

/// Why a certificate does not become a theorem.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StateError {
    /// The checker does not accept it.
    #[error("refused: {0}")]
    Refused(#[from] Refusal),
    /// It is about something else.
    #[error("it is not the certificate of a state (`couplet certify state` writes one)")]
    NotState,
    /// The numbers for Coq were not found.
    #[error(transparent)]
    Undecided(#[from] Undecided),
}

/// The file of the state that a certificate is about, name and content, after a check of the certificate.
pub fn state(certificate: &[u8]) -> Result<(String, String), StateError> {
    let accepted = verify(certificate)?;
    let Problem::State { mode, arch } = &accepted.problem else { return Err(StateError::NotState) };
    let root = root(&accepted.problem, &Certificate::read(certificate)?)?;
    let given = match arch.is_limited() {
        true => &["alpha", "mu"][..],
        false => &["alpha"],
    };
    let mut solution = Solution::new(&root, given)?;
    signs_hold(&accepted.problem, &root, &solution)?;
    let claims = claims(*mode, &accepted.problem, arch, &solution).ok_or(StateError::NotState)?;
    solution.values.extend(claims);
    let parts = [
        fill(include_str!("templates/state.v"), &solution.values),
        solution.text(),
        fill(include_str!("templates/least_thickness.v"), &solution.values),
    ];
    Ok((format!("State{mode:?}{:?}.v", arch.weight()), parts.concat()))
}

/// Steps with the inverse of a certificate, each of which gains many bits next to the root.
const STEPS: usize = 40;

/// The root of a certificate to the digits that are printed, however many it has itself.
fn root(problem: &Problem, certificate: &Certificate) -> Result<Root, Undecided> {
    let (system, given) = (problem.system(), problem.given::<Ball>(BITS));
    let exact = |x: &Dyadic| <Ball as Engine>::exact(x, BITS as usize);
    let inverse: Vec<Vec<Ball>> =
        certificate.inverse.iter().map(|row| row.iter().map(exact).collect()).collect();
    let mut values: Vec<Ball> = certificate.root.centre.iter().map(exact).collect();
    for _ in 0..STEPS {
        let residuals = system.residuals(&system.place(given.clone(), &values));
        for (x, row) in values.iter_mut().zip(&inverse) {
            let terms = row.iter().zip(&residuals).map(|(y, residual)| y.clone() * residual);
            *x = Ball::exact(terms.fold(x.clone(), |x, term| x - term).mid().clone(), BITS);
        }
    }
    let candidate = Candidate(values.iter().map(|x| x.mid().clone()).collect());
    let domain = isolate_root(problem, &candidate)?.domain().to_vec();
    Ok(Root { system, given, values, domain })
}

/// Whether the digits that are printed tell every sign.
fn signs_hold(problem: &Problem, root: &Root, solution: &Solution) -> Result<(), Undecided> {
    let radius = Magnitude::upper(&Float::with_val(64, unit(DECIMALS)));
    let digit = |x: &Rational| Ball::enclosing(x, BITS).widened(radius);
    let narrow: Vec<Ball> = solution.table.centre.iter().map(digit).collect();
    match problem.first_failure(&root.system.place(root.given.clone(), &narrow), BITS) {
        None => Ok(()),
        Some(condition) => {
            let reason = format!("for Coq: {DECIMALS} decimals do not tell {}", condition.label());
            Err(Undecided::new(reason))
        }
    }
}

/// What is claimed of the state.
fn claims(mode: Mode, problem: &Problem, arch: &Arch, solution: &Solution) -> Option<Values> {
    let system = problem.system();
    let signs = problem.conditions().into_iter().filter_map(|c| sign(c, mode, &system));
    let eta = system.index(Unknown::Thickness)?;
    let delta = system.weight.flag();
    let h = argument(&system, Unknown::Thrust);
    let moment = match mode {
        Mode::Rotational | Mode::SlidingRotational => format!("(at_crown eta {h})"),
        Mode::Overturning => "0".into(),
        _ => format!("(at_shoulder {delta} alpha eta {h})"),
    };
    let (theorem, friction) = match mode {
        Mode::Rotational if arch.is_limited() => ("rotational", true),
        Mode::Rotational => ("rotational_without_limit", false),
        Mode::SlidingRotational => ("sliding_rotational", true),
        Mode::RotationalSliding | Mode::RotationalSlidingRotational => ("rotational_sliding", true),
        Mode::OverturningSliding => ("overturning_sliding", true),
        Mode::Overturning => ("overturning", false),
        Mode::Sliding => return None,
    };
    let (admissible, stands_from, holds) = match friction {
        true => (
            format!("admissible {delta} alpha eta mu {h} {moment}"),
            format!("stands_from {delta} alpha mu"),
            ", and friction holds,",
        ),
        false => (
            format!("thrust_inside {delta} alpha eta {h} {moment}"),
            format!("stands_without_limit_from {delta} alpha"),
            "",
        ),
    };
    let given = if friction { " mu" } else { "" };
    Some(vec![
        ("mode", mode.label().into()),
        ("arch", definitions(arch)),
        ("holds", holds.into()),
        ("signs", signs.collect::<Vec<_>>().join(" /\\\n  ")),
        ("admissible", admissible),
        ("stands_from", stands_from),
        ("theorem", format!("{theorem} {delta} alpha{given}")),
        ("least", text(&solution.table.centre[eta])),
        ("witness", solution.symbols.iter().collect::<Vec<_>>().join(" & ")),
    ])
}

/// What is given, as definitions.
fn definitions(arch: &Arch) -> String {
    let mu = match arch.friction() {
        Friction::Coefficient(mu) => Some(number(mu)),
        Friction::Angle(phi) => Some(format!("tan ({})", number(phi))),
        Friction::Infinite => None,
    };
    let definition = |name, value| format!("Definition {name} : R := {value}.");
    let alpha = definition(symbol(Unknown::HalfOpening), number(arch.half_opening()));
    let mu = mu.map(|mu| definition(symbol(Unknown::Friction), mu));
    [Some(alpha), mu].into_iter().flatten().collect::<Vec<_>>().join("\n")
}

/// A number that is given, as Coq reads it.
fn number(x: &ExactNumber) -> String {
    let factor = x.to_rational();
    if x.is_rational() {
        return text(&factor);
    }
    let above = match factor.numer() {
        one if *one == 1 => "PI".into(),
        n => format!("{n} * PI"),
    };
    if factor.is_integer() { above } else { format!("{above} / {}", factor.denom()) }
}
