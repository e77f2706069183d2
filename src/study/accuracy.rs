//! Error against run time: every way the product can compute a value, on the same problems.

use super::Task;
use super::closed::{Branch, Form, printed, trigonometric};
use super::double_double;
use super::enclosure::{Errors, enclose, enclose_at, error, relative_radius};
use super::newton::{doubling, newton};
use super::row::{Row, Timed, timed};
use super::static_programme::least_thickness;
use crate::arch::{SelfWeight, Unknown, cubic};
use crate::certify::CertifiedLandmark;
use crate::certify::state::{Certify, Outcome};
use crate::number::Engine;
use crate::number::{Angle, AstroInterval, Ball, Enclosure, ExactNumber, Real, rational_like};
use crate::problem::{Arch, Friction};
use crate::problem::{Landmark, Mode, tally};
use crate::solve::start;
use qd::Quad;
use rug::{Float, Rational};
use std::time::Duration;

/// A problem with its names and the numbers from which every method starts.
#[non_exhaustive]
pub struct Case {
    /// The kind of quantity.
    pub quantity: &'static str,
    /// Which of them.
    pub name: String,
    /// What is computed.
    pub problem: Task,
    /// Start values, good to three digits or so.
    pub start: Vec<f64>,
    /// The closed form, where there is one: which, on which branch, at which joint.
    closed: Option<(Form, Branch, Rational)>,
}

/// How much is measured.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Effort {
    /// Precisions in bits.
    pub bits: &'static [u32],
    /// The largest precision for the second arithmetic, which is slow.
    pub astro_bits: u32,
    /// Time for the repeats of one measurement.
    pub budget: Duration,
}

/// A look of some seconds.
pub const QUICK: Effort =
    Effort { bits: &[64, 113, 256, 1024], astro_bits: 256, budget: Duration::from_millis(5) };
/// The whole study.
pub const FULL: Effort = Effort {
    bits: &[64, 113, 256, 1024, 4096, 16_384, 65_536],
    astro_bits: 4096,
    budget: Duration::from_millis(100),
};

/// Joints of the static programme.
const JOINTS: &[usize] = &[100, 1000];

/// Bits by which the reference is more precise than what is measured.
const REFERENCE: u32 = 160;

/// The kinds of quantity, in order.
pub const QUANTITIES: [&str; 7] =
    ["eta-cubic", "A-cubic", "h-cubic", "radicand", "half-opening", "landmark", "state"];

/// All cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let weight = SelfWeight::Milankovitch;
    // The last is next to that of sb, 1.11986…, where the two branches meet.
    let joints = [(1, 10), (1, 2), (1, 1), (1119, 1000)].map(Rational::from);
    for joint in &joints {
        let at = Angle::new(joint.to_f64());
        for (branch, side) in [(Branch::Upper, "thin"), (Branch::Lower, "thick")] {
            let kinds = [
                ("eta-cubic", Form::Thickness),
                ("A-cubic", Form::OpeningVariable),
                ("h-cubic", Form::Thrust),
            ];
            for (quantity, form) in kinds {
                let joint = joint.clone();
                let problem = match form {
                    Form::Thickness => Task::Thickness { weight, joint: joint.clone() },
                    Form::OpeningVariable => Task::OpeningVariable { weight, joint: joint.clone() },
                    Form::Thrust => Task::Thrust { weight, joint: joint.clone() },
                };
                cases.push(Case {
                    quantity,
                    name: format!("beta = {joint}, {side}"),
                    problem,
                    start: vec![trigonometric(form, branch, &at)],
                    closed: Some((form, branch, joint)),
                });
            }
        }
        cases.push(Case {
            quantity: "radicand",
            name: format!("beta = {joint}"),
            start: vec![cubic::radicand(&cubic::abbreviations(&at), &1.0)],
            problem: Task::Radicand { weight, joint: joint.clone() },
            closed: None,
        });
    }
    for (a, alpha) in
        [((19, 10), 0.77), ((1, 1), 2.33), ((7, 10), 2.618), ((19_999, 10_000), 0.02449)]
    {
        let a = Rational::from(a);
        cases.push(Case {
            quantity: "half-opening",
            name: format!("A = {a}"),
            problem: Task::HalfOpening { a },
            start: vec![alpha],
            closed: None,
        });
    }
    for landmark in Landmark::ALL {
        for weight in SelfWeight::ALL {
            cases.push(Case {
                quantity: "landmark",
                name: format!("{} {}", landmark.symbol(), weight.name()),
                problem: Task::Landmark { weight, landmark },
                start: start::landmark(landmark, weight).to_vec(),
                closed: None,
            });
        }
    }
    cases.extend(states());
    cases
}

/// The quantity of the rows of [`sines`].
pub const SINES: &str = "sin-cos";

/// One sine and cosine in MPFR at each precision: the unit in which everything else can be read.
pub fn sines(effort: &Effort) -> Vec<Row> {
    let measure = |&bits: &u32| {
        let angle = Float::with_val(bits, 3).sqrt();
        let timed = timed(effort.budget, || Real::sin_cos(&angle));
        let digits = f64::from(bits) * std::f64::consts::LOG10_2;
        let row = Row {
            quantity: SINES.into(),
            case: "sqrt(3)".into(),
            method: "one sine and cosine, MPFR".into(),
            precision_bits: Some(bits),
            error_relative_log10: Some(-digits),
            verdict: "computed".into(),
            ..Row::default()
        };
        row.with_times(&timed)
    };
    effort.bits.iter().map(measure).collect()
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
        let arch = arch(weight, &half_opening, &friction)?;
        let Ok(Outcome::Stands(state)) = arch.state(128) else { return None };
        // Nobody starts at the solution.
        let start = |&unknown| Some(state.value(unknown)?.mid().to_f64() * 1.001);
        let start: Option<_> = mode.system(weight).unknowns.iter().map(start).collect();
        (state.mode == mode).then_some(Case {
            quantity: "state",
            name: format!("{} alpha = {half_opening}, mu = {friction}", mode.label()),
            start: start?,
            problem: Task::State { weight, mode, half_opening, friction },
            closed: None,
        })
    });
    cases.collect()
}

fn arch(weight: SelfWeight, half_opening: &Rational, friction: &Rational) -> Option<Arch> {
    let friction = Friction::Coefficient(ExactNumber::from(friction));
    Arch::new(weight, ExactNumber::from(half_opening), friction).ok()
}

/// All measurements of one case.
pub fn measure(case: &Case, effort: &Effort) -> Vec<Row> {
    let mut rows = Vec::new();
    let most = effort.bits.iter().max().copied().unwrap_or(64);
    let Some(truth) = enclose::<Ball>(&case.problem, &case.start, most + REFERENCE) else {
        return vec![Row { verdict: "no reference".into(), ..case.row("reference", None) }];
    };
    let errors = |values: &[Float]| -> Vec<Errors> {
        values.iter().zip(&truth).map(|(x, t)| error(x, t)).collect()
    };
    let mut computed =
        |method: &str, bits: u32, steps: Option<usize>, timed: Timed<Option<Vec<Float>>>| {
            let evaluations = steps.map(|steps| steps * truth.len());
            let row = Row { newton_steps: steps, evaluations, ..case.row(method, Some(bits)) };
            let row = row.with_times(&timed);
            rows.push(match &timed.value {
                Some(values) => Row { verdict: "computed".into(), working_bits: Some(bits), ..row }
                    .with_errors(&errors(values), bits),
                None => Row { verdict: "no value".into(), ..row },
            });
        };
    let double = |x: f64| x.is_finite().then(|| vec![Float::with_val(53, x)]);
    if let Some((form, branch, joint)) = &case.closed {
        let joint = joint.to_f64();
        let timed_form = timed(effort.budget, || double(printed(*form, *branch, joint)));
        computed("closed form, complex double", 53, None, timed_form);
        let timed_form =
            timed(effort.budget, || double(trigonometric(*form, *branch, &Angle::new(joint))));
        computed("trigonometric form, double", 53, None, timed_form);
    }
    let steps = newton(&case.problem, &case.start, 53).map(|found| found.steps);
    let by_newton = timed(effort.budget, || {
        let found = newton(&case.problem, &case.start, 53)?;
        Some(found.root.iter().map(|x| Float::with_val(53, x)).collect())
    });
    computed("Newton, double", 53, steps, by_newton);
    let start: Vec<Quad> = case.start.iter().map(|&x| Quad::from(x)).collect();
    let steps = newton(&case.problem, &start, double_double::BITS).map(|found| found.steps);
    let by_newton = timed(effort.budget, || {
        let found = newton(&case.problem, &start, double_double::BITS)?;
        Some(found.root.iter().map(double_double::to_float).collect())
    });
    computed("Newton, double-double", double_double::BITS, steps, by_newton);
    for &bits in effort.bits {
        if let Some((form, branch, joint)) = &case.closed {
            let by_form = timed(effort.budget, || {
                let joint = rational_like(&Float::new(bits), joint);
                Some(vec![trigonometric(*form, *branch, &Angle::new(joint))])
            });
            computed("trigonometric form, MPFR", bits, None, by_form);
        }
        let steps = doubling(&case.problem, &case.start, bits).map(|found| found.steps);
        let by_newton =
            timed(effort.budget, || Some(doubling(&case.problem, &case.start, bits)?.root));
        computed("Newton, MPFR", bits, steps, by_newton);
    }
    for &joints in JOINTS {
        if let Some(row) = case.static_programme(joints, effort, &truth) {
            rows.push(row);
        }
    }
    for &bits in effort.bits {
        rows.push(case.certified_balls(bits, effort, &errors));
        if bits <= effort.astro_bits {
            rows.push(case.certified_astro(bits, effort, &errors));
        }
    }
    rows
}

impl Case {
    fn row(&self, method: &str, bits: Option<u32>) -> Row {
        Row {
            quantity: self.quantity.into(),
            case: self.name.clone(),
            method: method.into(),
            precision_bits: bits,
            threads: 1,
            ..Row::default()
        }
    }

    /// The discrete static programme, for the thickness of a state: its error is that of the joints.
    fn static_programme(&self, joints: usize, effort: &Effort, truth: &[Ball]) -> Option<Row> {
        let Task::State { weight, mode, half_opening, friction } = &self.problem else {
            return None;
        };
        let index = mode.system(*weight).index(Unknown::Thickness)?;
        let (alpha, mu) = (half_opening.to_f64(), friction.to_f64());
        let timed = timed(effort.budget, || least_thickness(*weight, alpha, mu, joints));
        let value = Float::with_val(53, timed.value);
        let row = self.row(&format!("static programme, {joints} joints"), Some(53));
        let row = row.with_times(&timed).with_errors(&[error(&value, &truth[index])], 53);
        Some(Row { verdict: "computed".into(), working_bits: Some(53), ..row })
    }

    /// The product's own path: for landmarks and states with everything that their proof needs.
    fn certified_balls(
        &self,
        bits: u32,
        effort: &Effort,
        errors: &dyn Fn(&[Float]) -> Vec<Errors>,
    ) -> Row {
        let timed = timed(effort.budget, || self.certified(bits));
        let (_, tally) = tally::measure(|| self.certified(bits));
        let counted = |count: u64| (count > 0).then_some(count as usize);
        let row = self.row("certified balls", Some(bits)).with_times(&timed);
        let Some(balls) = &timed.value else {
            return Row { verdict: "undecided".into(), ..row };
        };
        let values: Vec<Float> = balls.iter().map(|x| x.mid().clone()).collect();
        let claimed = balls.iter().map(relative_radius).fold(f64::NEG_INFINITY, f64::max);
        let working = values.iter().map(|x| x.prec()).max();
        Row {
            verdict: "proved".into(),
            claimed_relative_log10: Some(claimed),
            certified_digits: Some(-claimed),
            working_bits: working,
            evaluations: counted(tally.evaluations()),
            newton_steps: counted(tally.newton_steps),
            ..row
        }
        .with_errors(&errors(&values), bits)
    }

    fn certified(&self, bits: u32) -> Option<Vec<Ball>> {
        match &self.problem {
            Task::Landmark { weight, landmark } => {
                let point = CertifiedLandmark::new(*landmark, *weight).ok()?;
                let refined = point.enclosure(bits).ok()?;
                let unknowns = landmark.system(*weight).unknowns.iter();
                unknowns.map(|&unknown| refined.value(unknown)).collect()
            }
            Task::State { weight, mode, half_opening, friction } => {
                let Outcome::Stands(state) =
                    arch(*weight, half_opening, friction)?.state_alone(bits).ok()?
                else {
                    return None;
                };
                let value = |&unknown| state.value(unknown).cloned();
                mode.system(*weight).unknowns.iter().map(value).collect()
            }
            problem => enclose::<Ball>(problem, &self.start, bits),
        }
    }

    /// The second arithmetic, around a centre that MPFR has found.
    fn certified_astro(
        &self,
        bits: u32,
        effort: &Effort,
        errors: &dyn Fn(&[Float]) -> Vec<Errors>,
    ) -> Row {
        let row = self.row("certified astro-float", Some(bits));
        let Some(found) = doubling(&self.problem, &self.start, bits) else {
            return Row { verdict: "no centre".into(), ..row };
        };
        let timed =
            timed(effort.budget, || enclose_at::<AstroInterval>(&self.problem, &found.root, bits));
        let row = row.with_times(&timed);
        let Some(intervals) = &timed.value else {
            return Row { verdict: "undecided".into(), ..row };
        };
        let balls: Option<Vec<Ball>> = intervals.iter().map(|x| hull(x, bits + 64)).collect();
        let Some(balls) = balls else { return Row { verdict: "undecided".into(), ..row } };
        let values: Vec<Float> = balls.iter().map(|x| x.mid().clone()).collect();
        let claimed = balls.iter().map(relative_radius).fold(f64::NEG_INFINITY, f64::max);
        Row {
            verdict: "proved".into(),
            claimed_relative_log10: Some(claimed),
            certified_digits: Some(-claimed),
            working_bits: Some(bits.next_multiple_of(64)),
            ..row
        }
        .with_errors(&errors(&values), bits)
    }
}

/// A ball that holds an interval.
fn hull(interval: &AstroInterval, bits: u32) -> Option<Ball> {
    let (low, high) = interval.ends()?;
    let centre = Float::with_val(bits, &low + &high) / 2u32;
    let radius = Float::with_val(64, &high - &low);
    let radius = <Ball as Engine>::around(&(&centre).into(), &(&radius).into(), bits as usize);
    radius.is_bounded().then_some(radius)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A claimed bound is never below the true error, on every row of every case.
    #[test]
    fn what_is_claimed_holds() {
        let effort = Effort { bits: &[64, 256], astro_bits: 64, budget: Duration::ZERO };
        let mut proved = 0;
        for case in cases() {
            let rows = measure(&case, &effort);
            assert!(rows.len() >= 5, "{} {}: {rows:?}", case.quantity, case.name);
            for row in rows {
                if let (Some(claimed), Some(true_error)) =
                    (row.claimed_relative_log10, row.error_relative_log10)
                {
                    // Decimal logarithms in doubles, rounded to nearest.
                    assert!(claimed >= true_error - 1e-9, "{row:?}");
                    proved += 1;
                }
                assert_ne!(row.verdict, "undecided", "{row:?}");
            }
        }
        assert!(proved > 100);
    }

    #[test]
    fn every_kind_of_quantity_is_there() {
        let cases = cases();
        for quantity in QUANTITIES {
            assert!(cases.iter().any(|case| case.quantity == quantity), "{quantity}");
        }
        assert_eq!(cases.iter().filter(|case| case.quantity == "state").count(), 5);
    }
}
