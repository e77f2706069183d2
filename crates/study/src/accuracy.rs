//! Error against run time: every way the product can compute a value, on the same problems.

use super::Task;
use super::cases::{Case, arch};
use super::closed::{printed, trigonometric, trigonometric_at};
use super::double_double;
use super::enclosure::{ErrorSizes, enclose, error, relative_radius};
use super::newton::{Newton, doubling, in_double_doubles, in_doubles};
use super::row::{Measurement, timed};
use super::static_programme::least_thickness;
use crate::arch::Unknown;
use crate::certify::CertifiedLandmark;
use crate::certify::state::{Answer, Certify, Outcome, state_in_double_doubles};
use crate::number::{
    Angle, AstroInterval, Ball, DoubleBall, DoubleDoubleBall, Enclosure, Engine, Magnitude, Real,
    Rounded,
};
use crate::problem::tally;
use rug::Float;
use std::f64::consts::LOG10_2;
use std::time::Duration;

/// Amount of what is measured.
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
/// Bits that a landmark's root may have, however few are asked for.
const ROOT: u32 = 2_200;

/// Name of the product's own way to a state: the certified digits of the command.
pub const COMMAND: &str = "what couplet state does";

/// The quantity of the rows of [`sines`].
pub const SINES: &str = "sin-cos";

/// One sine and cosine in MPFR at each precision: the unit in which everything else can be read.
pub fn sines(effort: &Effort) -> Vec<Measurement> {
    let measure = |&bits: &u32| {
        let angle = Float::with_val(bits, 3).sqrt();
        let timed = timed(effort.budget, || Real::sin_cos(&angle));
        let digits = f64::from(bits) * LOG10_2;
        let row = Measurement {
            quantity: SINES.into(),
            case: "sqrt(3)".into(),
            method: "one sine and cosine, MPFR".into(),
            precision_bits: Some(bits),
            error_relative_log10: Some(-digits),
            verdict: "computed".into(),
            ..Measurement::default()
        };
        row.with_times(&timed)
    };
    effort.bits.iter().map(measure).collect()
}

/// All measurements of one case.
pub fn measure(case: &Case, effort: &Effort) -> Vec<Measurement> {
    let mut rows = Vec::new();
    let most = effort.bits.iter().max().copied().unwrap_or(64);
    let bits = most.max(ROOT) + REFERENCE;
    let Some(truth) = enclose::<Ball>(&case.problem, &case.start, bits) else {
        return vec![Measurement {
            verdict: "no reference".into(),
            ..named(case, "reference", None)
        }];
    };
    let study = CaseStudy { case, effort, truth: &truth };
    let mut computed = |method: &str, bits: u32, job: &dyn Fn() -> Option<Newton<Float>>| {
        rows.push(study.computed(method, bits, job));
    };
    let value = |x: Float| x.is_finite().then(|| Newton { root: vec![x], steps: 0 });
    let double = |x: f64| value(Float::with_val(53, x));
    let (problem, start) = (&case.problem, &case.start);
    if let Some((form, branch, joint)) = &case.closed {
        let joint = joint.to_f64();
        computed("closed form, complex double", 53, &|| double(printed(*form, *branch, joint)));
        computed("trigonometric form, double", 53, &|| {
            double(trigonometric(*form, *branch, &Angle::new(joint)))
        });
    }
    computed("Newton, double", 53, &|| in_doubles(problem, start));
    let bits = double_double::BITS;
    computed("Newton, double-double", bits, &|| in_double_doubles(problem, start));
    for &bits in effort.bits {
        if let Some((form, branch, joint)) = &case.closed {
            computed("trigonometric form, MPFR", bits, &|| {
                value(trigonometric_at(*form, *branch, joint, bits))
            });
        }
        computed("Newton, MPFR", bits, &|| doubling(problem, start, bits));
    }
    for &joints in JOINTS {
        if let Some(row) = study.static_programme(joints) {
            rows.push(row);
        }
    }
    for &bits in effort.bits {
        let method = "one proved root, balls of MPFR";
        rows.push(study.proved(method, bits, || enclose(problem, start, bits), Some));
        if bits <= effort.astro_bits {
            let hulls = |all: Vec<AstroInterval>| all.iter().map(|x| hull(x, bits + 64)).collect();
            let method = "one proved root, astro-float";
            rows.push(study.proved(method, bits, || enclose(problem, start, bits), hulls));
        }
        if matches!(case.problem, Task::Landmark { .. } | Task::State { .. }) {
            rows.push(study.proofs(bits));
        }
    }
    rows.extend(study.quick_proofs());
    rows
}

/// The row of a method on a case.
fn named(case: &Case, method: &str, bits: Option<u32>) -> Measurement {
    Measurement {
        quantity: case.quantity.into(),
        case: case.name.clone(),
        method: method.into(),
        precision_bits: bits,
        threads: 1,
        ..Measurement::default()
    }
}

/// A case with what is measured against.
struct CaseStudy<'a> {
    case: &'a Case,
    effort: &'a Effort,
    /// The unknowns, enclosed at a higher precision.
    truth: &'a [Ball],
}

impl CaseStudy<'_> {
    fn row(&self, method: &str, bits: Option<u32>) -> Measurement {
        named(self.case, method, bits)
    }

    fn errors(&self, values: &[Float]) -> Vec<ErrorSizes> {
        values.iter().zip(self.truth).map(|(x, t)| error(x, t)).collect()
    }

    /// The row of a method that computes the unknowns and proves nothing.
    fn computed(
        &self,
        method: &str,
        bits: u32,
        job: &dyn Fn() -> Option<Newton<Float>>,
    ) -> Measurement {
        let timed = timed(self.effort.budget, job);
        let row = self.row(method, Some(bits)).with_times(&timed);
        let Some(Newton { root, steps }) = timed.value else {
            return Measurement { verdict: "no value".into(), ..row };
        };
        let newton_steps = (steps > 0).then_some(steps);
        Measurement {
            newton_steps,
            evaluations: newton_steps.map(|steps| steps * self.truth.len()),
            verdict: "computed".into(),
            working_bits: Some(bits),
            ..row
        }
        .with_errors(&self.errors(&root), bits)
    }

    /// The discrete static programme, for the thickness of a state: its error is that of the joints.
    fn static_programme(&self, joints: usize) -> Option<Measurement> {
        let Task::State { weight, mode, half_opening, friction } = &self.case.problem else {
            return None;
        };
        let index = mode.system(*weight).index(Unknown::Thickness)?;
        let (alpha, mu) = (half_opening.to_f64(), friction.to_f64());
        let timed = timed(self.effort.budget, || least_thickness(*weight, alpha, mu, joints));
        let value = Float::with_val(53, timed.value);
        let row = self.row(&format!("static programme, {joints} joints"), Some(53));
        let row = row.with_times(&timed).with_errors(&[error(&value, &self.truth[index])], 53);
        Some(Measurement { verdict: "computed".into(), working_bits: Some(53), ..row })
    }

    /// Values that the product proves: a landmark, isolated and refined, or a state with everything that
    /// belongs to it.
    fn certified(&self, bits: u32) -> Option<Vec<Ball>> {
        match &self.case.problem {
            Task::Landmark { weight, landmark } => {
                let point = CertifiedLandmark::new(*landmark, *weight).ok()?;
                let refined = point.enclosure(bits).ok()?;
                let unknowns = landmark.system(*weight).unknowns.iter();
                unknowns.map(|&unknown| refined.value(unknown)).collect()
            }
            Task::State { weight, half_opening, friction, .. } => {
                let arch = arch(*weight, half_opening, Some(friction))?;
                self.enclosures(&arch.state_alone(bits).ok()?)
            }
            _ => None,
        }
    }

    /// The unknowns of a state that stands.
    fn enclosures<E: Enclosure>(&self, outcome: &Outcome<E>) -> Option<Vec<E>> {
        let (Task::State { weight, mode, .. }, Outcome::Stands(state)) =
            (&self.case.problem, outcome)
        else {
            return None;
        };
        let value = |&unknown| state.value(unknown).cloned();
        mode.system(*weight).unknowns.iter().map(value).collect()
    }

    /// The proofs of the product, at one precision.
    fn proofs(&self, bits: u32) -> Measurement {
        let row = self.proved("certified, balls of MPFR", bits, || self.certified(bits), Some);
        let (_, tally) = tally::measure(|| self.certified(bits));
        let counted = |count: u64| (count > 0).then_some(count as usize);
        Measurement {
            evaluations: counted(tally.evaluations()),
            newton_steps: counted(tally.newton_steps),
            ..row
        }
    }

    /// The proofs of a state that the product asks first, and what the command does.
    fn quick_proofs(&self) -> Vec<Measurement> {
        let Task::State { weight, half_opening, friction, .. } = &self.case.problem else {
            return Vec::new();
        };
        let Some(arch) = arch(*weight, half_opening, Some(friction)) else { return Vec::new() };
        let doubles = || self.enclosures(&arch.state_in_doubles().ok()?);
        let pairs = || self.enclosures(&state_in_double_doubles(&arch).ok()?);
        let of_doubles = |all: Vec<DoubleBall>| Some(all.iter().map(double_ball).collect());
        let of_pairs =
            |all: Vec<DoubleDoubleBall>| Some(all.iter().map(|x| x.to_ball(170)).collect());
        let mut rows = vec![
            self.proved("certified, balls of doubles", 53, doubles, of_doubles),
            self.proved("certified, balls of double-doubles", 106, pairs, of_pairs),
        ];
        for &bits in self.effort.bits {
            let digits = (f64::from(bits) * LOG10_2) as usize - 2;
            let answer = || arch.certify_alone(digits).ok();
            let row = self.proved(COMMAND, bits, answer, |answer| self.rounded(&answer, bits));
            rows.push(row.of_the_first_call());
        }
        rows
    }

    /// The unknowns of a state as balls around their correctly rounded digits.
    fn rounded(&self, answer: &Answer, bits: u32) -> Option<Vec<Ball>> {
        let (Task::State { weight, mode, .. }, Answer::Stands(state)) =
            (&self.case.problem, answer)
        else {
            return None;
        };
        let value = |unknown: &Unknown| {
            let figure = match unknown {
                Unknown::Thickness => Some(&state.thickness),
                Unknown::Thrust => Some(&state.thrust),
                Unknown::RotationJoint => Some(&state.rotation_joint),
                Unknown::SlidingJoint => state.sliding_joint.as_ref(),
                _ => None,
            };
            let Rounded { lower, upper, .. } = &figure?.decimal;
            let [lower, upper] =
                [lower, upper].map(|end| Ball::enclosing(&end.to_rational(), bits + 64));
            Some(lower.hull(&upper))
        };
        mode.system(*weight).unknowns.iter().map(value).collect()
    }

    /// The row of a method that proves something, of which balls are made outside of what is timed, or nothing.
    fn proved<T>(
        &self,
        method: &str,
        bits: u32,
        job: impl Fn() -> Option<T>,
        balls: impl FnOnce(T) -> Option<Vec<Ball>>,
    ) -> Measurement {
        let timed = timed(self.effort.budget, job);
        let row = self.row(method, Some(bits)).with_times(&timed);
        let Some(balls) = timed.value.and_then(balls) else {
            return Measurement { verdict: "undecided".into(), ..row };
        };
        let values: Vec<Float> = balls.iter().map(|x| x.mid().clone()).collect();
        let claimed = balls.iter().map(relative_radius).fold(f64::NEG_INFINITY, f64::max);
        Measurement {
            verdict: "proved".into(),
            claimed_relative_log10: Some(claimed),
            certified_digits: Some(-claimed),
            working_bits: values.iter().map(|x| x.prec()).max(),
            ..row
        }
        .with_errors(&self.errors(&values), bits)
    }
}

/// Ball of MPFR of what a ball of doubles holds.
fn double_ball(ball: &DoubleBall) -> Ball {
    let [mid, rad] = [ball.mid(), ball.rad()].map(|x| Float::with_val(53, x));
    Ball::exact(mid, 170).widened(Magnitude::upper(&rad))
}

/// A ball that holds an interval.
fn hull(interval: &AstroInterval, bits: u32) -> Option<Ball> {
    let (low, high) = interval.ends()?;
    let centre = Float::with_val(bits, &low + &high) / 2u32;
    let radius = Float::with_val(64, &high - &low);
    let all =
        <Ball as Engine>::exact(&(&centre).into(), bits as usize).widened_by(&(&radius).into());
    all.is_bounded().then_some(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::cases;

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
}
