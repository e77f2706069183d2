//! Cases that are measured: problems of every kind, with the numbers from which every method starts.

use super::Task;
use super::closed::{ClosedForm, RootBranch, trigonometric};
use crate::arch::{SelfWeight, cubic};
use crate::certify::state::{Certify, Outcome};
use crate::number::{Angle, ExactNumber};
use crate::problem::{Arch, Friction, Landmark, Mode};
use crate::solve::start;
use rug::Rational;

/// A problem with its names and the numbers from which every method starts.
#[non_exhaustive]
pub struct Case {
    /// The kind of quantity.
    pub quantity: &'static str,
    /// Name of the case.
    pub name: String,
    /// Task that is computed.
    pub problem: Task,
    /// Start values, good to three digits or so.
    pub start: Vec<f64>,
    /// The closed form, where there is one: which, on which branch, at which joint.
    pub(super) closed: Option<(ClosedForm, RootBranch, Rational)>,
}

/// The kinds of quantity, in order.
pub const QUANTITIES: [&str; 7] =
    ["eta-cubic", "A-cubic", "h-cubic", "radicand", "half-opening", "landmark", "state"];

/// A case without a closed form.
fn case(quantity: &'static str, name: String, problem: Task, start: Vec<f64>) -> Case {
    Case { quantity, name, problem, start, closed: None }
}

/// All cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let weight = SelfWeight::Milankovitch;
    // The last is next to that of sb, 1.11986…, where the two branches meet.
    let joints = [(1, 10), (1, 2), (1, 1), (1119, 1000)].map(Rational::from);
    for joint in &joints {
        let at = Angle::new(joint.to_f64());
        for (branch, side) in [(RootBranch::Upper, "thin"), (RootBranch::Lower, "thick")] {
            let kinds = [
                ("eta-cubic", ClosedForm::Thickness),
                ("A-cubic", ClosedForm::OpeningVariable),
                ("h-cubic", ClosedForm::Thrust),
            ];
            for (quantity, form) in kinds {
                let problem = Task::Cubic { form, weight, joint: joint.clone() };
                let start = vec![trigonometric(form, branch, &at)];
                let closed = Some((form, branch, joint.clone()));
                let name = format!("beta = {joint}, {side}");
                cases.push(Case { closed, ..case(quantity, name, problem, start) });
            }
        }
        let start = vec![cubic::radicand(&cubic::abbreviations(&at), &1.0)];
        let problem = Task::Radicand { weight, joint: joint.clone() };
        cases.push(case("radicand", format!("beta = {joint}"), problem, start));
    }
    for (a, alpha) in
        [((19, 10), 0.77), ((1, 1), 2.33), ((7, 10), 2.618), ((19_999, 10_000), 0.02449)]
    {
        let a = Rational::from(a);
        let name = format!("A = {a}");
        cases.push(case("half-opening", name, Task::HalfOpening { a }, vec![alpha]));
    }
    for landmark in Landmark::ALL {
        for weight in SelfWeight::ALL {
            let name = format!("{landmark} {weight}");
            let start = start::landmark(landmark, weight).to_vec();
            cases.push(case("landmark", name, Task::Landmark { weight, landmark }, start));
        }
    }
    cases.extend(states());
    cases
}

/// A state of every mode that has a thickness and a finite friction, and pure rotation.
fn states() -> Vec<Case> {
    let weight = SelfWeight::Milankovitch;
    let queries = [
        (Mode::Rotational, (11, 7), (1, 2)),
        (Mode::SlidingRotational, (11, 7), (19, 50)),
        (Mode::RotationalSliding, (49, 20), (27, 20)),
        (Mode::RotationalSlidingRotational, (1277, 500), (2, 1)),
        (Mode::OverturningSliding, (13, 5), (2, 1)),
    ];
    let cases = queries.into_iter().filter_map(|(mode, alpha, mu)| {
        let (half_opening, friction) = (Rational::from(alpha), Rational::from(mu));
        let arch = arch(weight, &half_opening, Some(&friction))?;
        let Ok(Outcome::Stands(state)) = arch.state(128) else { return None };
        // Nobody starts at the solution.
        let start = |&unknown| Some(state.value(unknown)?.mid().to_f64() * 1.001);
        let start: Option<_> = mode.system(weight).unknowns.iter().map(start).collect();
        let name = format!("{mode} alpha = {half_opening}, mu = {friction}");
        let problem = Task::State { weight, mode, half_opening, friction };
        (state.mode == mode).then_some(case("state", name, problem, start?))
    });
    cases.collect()
}

/// The arch of exact numbers; without a friction of unlimited friction.
pub(super) fn arch(
    weight: SelfWeight,
    half_opening: &Rational,
    friction: Option<&Rational>,
) -> Option<Arch> {
    let limited = |mu| Friction::Coefficient(ExactNumber::from(mu));
    let friction = friction.map_or(Friction::Infinite, limited);
    Arch::new(weight, ExactNumber::from(half_opening), friction).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_quantity_is_there() {
        let cases = cases();
        for quantity in QUANTITIES {
            assert!(cases.iter().any(|case| case.quantity == quantity), "{quantity}");
        }
        assert_eq!(cases.iter().filter(|case| case.quantity == "state").count(), 5);
    }
}
