//! What is lost where the problem is hard: ladders of distances towards each limit.
//!
//! The [condition number](super::condition) of a problem says how many digits of the result the input
//! decides. What a method loses beyond it, the method has lost.

use super::Problem;
use super::closed::{Branch, Form, printed, trigonometric};
use super::condition::condition;
use super::double_double;
use super::enclosure::{enclose_at, error, relative_radius};
use super::newton::{doubling, newton};
use super::row::timed;
use crate::arch::small::Scaled;
use crate::arch::{Landmark, Mode, SelfWeight, Unknown, overturning};
use crate::certify::CertifiedLandmark;
use crate::certify::state::{Arch, Friction, Outcome};
use crate::number::{Angle, Ball, Dual, ExactNumber, Real, rational_like};
use crate::solve::{settle, start_state};
use qd::Quad;
use rug::ops::Pow;
use rug::{Float, Integer, Rational};
use serde::Serialize;
use std::time::Duration;

/// One method on one rung.
#[derive(Clone, Debug, Default, Serialize)]
#[non_exhaustive]
pub struct Rung {
    /// Which limit.
    pub limit: &'static str,
    /// What is computed.
    pub output: &'static str,
    /// `log10` of the distance from the limit.
    pub distance_log10: i32,
    /// How it was computed.
    pub method: &'static str,
    /// The bits that the method was given, or needed.
    pub working_bits: u32,
    /// `log10` of the condition number.
    pub condition_log10: f64,
    /// `log10` of the relative error.
    pub error_relative_log10: Option<f64>,
    /// Decimal digits lost: those of the precision beyond the error. For a certified result those of the
    /// working precision beyond what is proved.
    pub digits_lost: Option<f64>,
    /// Median CPU time, s.
    pub cpu_seconds: f64,
    /// `proved`, `computed`, or why there is no value.
    pub verdict: &'static str,
}

/// A limit with the problem at each distance from it.
#[non_exhaustive]
pub struct Limit {
    /// A short name.
    pub name: &'static str,
    /// What happens there.
    pub words: &'static str,
    /// What is computed.
    pub output: &'static str,
    /// Whether it is that of small half openings.
    is_small: bool,
    /// The problem at the distance `10^-k`.
    at: fn(&Rational) -> Option<Target>,
}

/// All limits.
pub const LIMITS: [Limit; 8] = [
    Limit {
        name: "alpha-to-zero",
        words: "a tiny half opening: eta falls like alpha^4, h tends to 1",
        output: "thickness",
        is_small: true,
        at: |x| rotational(x.clone(), Unknown::Thickness),
    },
    Limit {
        name: "radicand-to-zero",
        words: "a joint below that of sb, where two roots of the cubic meet",
        output: "thickness",
        is_small: false,
        at: |x| {
            let joint = before(Landmark::WidestJoint, Unknown::RotationJoint, x)?;
            Some(Target::Closed { joint })
        },
    },
    Limit {
        name: "joint-to-crown",
        words: "a half opening below that of l: beta_r falls like the root of the distance",
        output: "rotation_joint",
        is_small: false,
        at: |x| {
            let alpha = before(Landmark::RotationEnd, Unknown::HalfOpening, x)?;
            rotational(alpha, Unknown::RotationJoint)
        },
    },
    Limit {
        name: "eta-to-two",
        words: "overturning at A above 2/3: the square root in (15) tends to 0",
        output: "thickness",
        is_small: false,
        at: |x| Some(Target::Overturning { distance: x.clone() }),
    },
    Limit {
        name: "mu-to-infinity",
        words: "a large friction: an inner joint slides at a thrust like 1/(4 mu^2)",
        output: "thrust",
        is_small: false,
        at: |x| {
            Some(Target::State {
                mode: Mode::OverturningSliding,
                half_opening: Rational::from((13, 5)),
                friction: Some(x.clone().recip()),
                output: Unknown::Thrust,
            })
        },
    },
    Limit {
        name: "mu-to-zero",
        words: "pure sliding of a tiny half opening: mu falls like alpha^3/12",
        output: "friction",
        is_small: true,
        at: |x| Some(Target::Sliding { half_opening: x.clone() }),
    },
    Limit {
        name: "alpha-to-pi",
        words: "pure sliding towards the full circle: mu grows without bound",
        output: "friction",
        is_small: false,
        at: |x| {
            // pi to far more places than the distance has.
            let places = 60 + 4 * x.denom().significant_bits();
            let pi = Float::with_val(places, rug::float::Constant::Pi).to_rational()?;
            Some(Target::Sliding { half_opening: pi - x })
        },
    },
    Limit {
        name: "next-to-T",
        words: "a half opening and a friction above those of T: four modes meet",
        output: "thickness",
        is_small: false,
        at: |x| {
            let zero = Rational::new();
            let alpha = before(Landmark::Triple, Unknown::HalfOpening, &zero)? + x;
            let friction = before(Landmark::Triple, Unknown::Friction, &zero)? + x.clone() * 10;
            let mode = match arch(&alpha, Some(&friction))?.state(1024).ok()? {
                Outcome::Stands(state) => state.mode,
                Outcome::Falls(_) => return None,
            };
            Some(Target::State {
                mode,
                half_opening: alpha,
                friction: Some(friction),
                output: Unknown::Thickness,
            })
        },
    },
];

const WEIGHT: SelfWeight = SelfWeight::Milankovitch;

/// A problem on a rung, and which of its unknowns is looked at.
#[derive(Clone, Debug)]
enum Target {
    /// A state.
    State { mode: Mode, half_opening: Rational, friction: Option<Rational>, output: Unknown },
    /// The friction of pure sliding.
    Sliding { half_opening: Rational },
    /// The thin root of the cubic in `eta`.
    Closed { joint: Rational },
    /// (15) at `A = 2/3 +` the distance.
    Overturning { distance: Rational },
}

fn rotational(half_opening: Rational, output: Unknown) -> Option<Target> {
    Some(Target::State { mode: Mode::Rotational, half_opening, friction: None, output })
}

/// A variable of a landmark, to many places, less a distance.
fn before(landmark: Landmark, unknown: Unknown, distance: &Rational) -> Option<Rational> {
    let refined = CertifiedLandmark::new(landmark, WEIGHT).ok()?.enclosure(640).ok()?;
    Some(refined.value(unknown)?.mid().to_rational()? - distance)
}

fn arch(half_opening: &Rational, friction: Option<&Rational>) -> Option<Arch> {
    let friction = friction
        .map_or(Friction::Infinite, |mu| Friction::Coefficient(ExactNumber::rational(mu.clone())));
    Arch::new(WEIGHT, ExactNumber::rational(half_opening.clone()), friction).ok()
}

/// Digits that a certified result is asked for.
const DIGITS: f64 = 16.0;
/// The largest working precision that is tried.
const MOST_BITS: u32 = 1 << 14;

impl Target {
    /// The output in a certified enclosure, computed with `bits` bits; `None` if it is not proved.
    fn enclosure(&self, bits: u32) -> Option<Ball> {
        match self {
            Self::State { half_opening, friction, output, mode } => {
                let Outcome::Stands(state) =
                    arch(half_opening, friction.as_ref())?.state_alone(bits).ok()?
                else {
                    return None;
                };
                (state.mode == *mode).then_some(match output {
                    Unknown::RotationJoint => state.rotation_joint,
                    Unknown::Thrust => state.thrust,
                    _ => state.thickness,
                })
            }
            Self::Sliding { half_opening } => arch(half_opening, None)?.sliding_friction(bits).ok(),
            Self::Closed { joint } => {
                let at = Angle::new(rational_like(&Float::new(bits), joint));
                let centre = trigonometric(Form::Thickness, Branch::Upper, &at);
                Some(enclose_at::<Ball>(&self.problem()?, &[centre], bits)?.swap_remove(0))
            }
            Self::Overturning { distance } => {
                let x = Ball::enclosing(distance, bits);
                Some(factored(&x))
            }
        }
    }

    /// The equations as a problem for the methods of others.
    fn problem(&self) -> Option<Problem> {
        Some(match self {
            Self::State { mode, half_opening, friction, .. } => Problem::State {
                weight: WEIGHT,
                mode: *mode,
                half_opening: half_opening.clone(),
                friction: friction.clone().unwrap_or_default(),
            },
            Self::Sliding { half_opening } => Problem::State {
                weight: WEIGHT,
                mode: Mode::Sliding,
                half_opening: half_opening.clone(),
                friction: Rational::new(),
            },
            Self::Closed { joint } => Problem::Thickness { weight: WEIGHT, joint: joint.clone() },
            Self::Overturning { .. } => return None,
        })
    }

    /// The place of the output among the unknowns.
    fn index(&self) -> usize {
        match self {
            Self::State { mode, output, .. } => {
                mode.system().0.iter().position(|unknown| unknown == output).unwrap_or(0)
            }
            _ => 0,
        }
    }

    /// Start values of all unknowns as the product makes them, in numbers of `bits` bits.
    fn start(&self, bits: u32) -> Option<Vec<Float>> {
        let number = |x: &Rational| Float::with_val(bits, x);
        Some(match self {
            Self::State { mode: Mode::Rotational, half_opening, .. } => {
                start_state::rotational(WEIGHT, &number(half_opening)).to_vec()
            }
            Self::State { mode, half_opening, friction, .. } => {
                // Next to the certified state: what is measured is the last digits.
                let Outcome::Stands(state) =
                    arch(half_opening, friction.as_ref())?.state(1024).ok()?
                else {
                    return None;
                };
                let value = |unknown: &Unknown| match unknown {
                    Unknown::RotationJoint => Some(state.rotation_joint.mid().clone()),
                    Unknown::SlidingJoint => Some(state.sliding_joint.as_ref()?.mid().clone()),
                    Unknown::Thickness => Some(state.thickness.mid().clone()),
                    _ => Some(state.thrust.mid().clone()),
                };
                let values: Option<Vec<Float>> = mode.system().0.iter().map(value).collect();
                values?.iter().map(|x| Float::with_val(bits, x) * 1.0001f64).collect()
            }
            Self::Sliding { half_opening } => start_state::sliding(&number(half_opening)).to_vec(),
            Self::Closed { joint } => {
                let at = Angle::new(rational_like(&Float::new(bits), joint));
                vec![trigonometric(Form::Thickness, Branch::Upper, &at)]
            }
            Self::Overturning { .. } => return None,
        })
    }

    /// `log10` of the condition number, from numbers of `bits` bits; minus infinity where the result does
    /// not depend on what is given.
    fn condition(&self, bits: u32) -> Option<f64> {
        if let Self::Overturning { distance } = self {
            // What is given is A.
            let a = Float::with_val(bits, Rational::from((2, 3)) + distance);
            let eta = overturning::thickness(WEIGHT, &Dual::variable(a.clone(), 0));
            return Some((eta.derivative(0) * a / eta.value()).abs().log10().to_f64());
        }
        let problem = self.problem()?;
        let root = newton(&problem, &self.start(bits)?, bits)?.root;
        condition(&problem, &root, self.index())
    }

    /// The output by Newton's method on the equations in scaled variables, in numbers of `bits` bits.
    fn scaled(&self, bits: u32) -> Option<Float> {
        let (mode, half_opening) = match self {
            Self::State { mode: Mode::Rotational, half_opening, .. } => {
                (Mode::Rotational, half_opening)
            }
            Self::Sliding { half_opening } => (Mode::Sliding, half_opening),
            _ => return None,
        };
        let (unknowns, equations) = mode.system();
        let alpha = Float::with_val(bits, half_opening);
        let y = alpha.clone().square();
        let start = match mode {
            Mode::Sliding => start_state::scaled_sliding(&y),
            _ => start_state::scaled_rotational(WEIGHT, &y)?,
        };
        let given = Scaled::new(&Dual::constant(y.clone()));
        let root = settle(start.to_vec(), |x| {
            let variables = unknowns.iter().zip(x).enumerate();
            let at = variables.fold(given.clone(), |at, (index, (&u, x))| {
                at.with(u, Dual::variable(x.clone(), index))
            });
            equations.iter().filter_map(|e| e.scaled_residual(WEIGHT, &at)).collect()
        })?;
        let [first, second, _] = &root[..] else { return None };
        Some(match mode {
            Mode::Sliding => first.clone() * y * alpha,
            _ => second.clone() * y.square(),
        })
    }
}

/// (15) with its radicand `9 (A - 2/3)(A + 2)`, from `x = A - 2/3`.
fn factored<T: Real>(x: &T) -> T {
    let radicand = x.int(9) * x * &(x.ratio(8, 3) + x);
    x.int(2) + x.int(3) * x - radicand.sqrt()
}

fn tenth_to(k: u32) -> Rational {
    Rational::from((Integer::from(1), Integer::from(10).pow(k)))
}

/// All methods on one rung.
pub fn climb(limit: &Limit, k: u32, budget: Duration) -> Vec<Rung> {
    let rung = |method, working_bits| Rung {
        limit: limit.name,
        output: limit.output,
        distance_log10: -(k as i32),
        method,
        working_bits,
        ..Rung::default()
    };
    let nothing = |verdict| vec![Rung { verdict, ..rung("certified", 0) }];
    let Some(target) = (limit.at)(&tenth_to(k)) else { return nothing("no problem") };
    // The reference: many more bits than any method is given.
    let high = 2048 + 48 * k;
    let Some(truth) = target.enclosure(high) else { return nothing("no reference") };
    let Some(condition_log10) = target.condition(high) else { return nothing("no condition") };
    let mut rungs = Vec::new();
    let mut add = |method, bits: u32, job: &dyn Fn() -> Option<Float>| {
        let timed = timed(budget, job);
        let mut found = Rung {
            condition_log10,
            cpu_seconds: timed.cpu.as_secs_f64(),
            verdict: "no value",
            ..rung(method, bits)
        };
        if let Some(value) = timed.value.filter(|x| x.is_finite()) {
            let relative = error(&value, &truth).relative;
            let digits = f64::from(bits) * std::f64::consts::LOG10_2;
            found.error_relative_log10 = Some(relative);
            found.digits_lost = Some((digits + relative).clamp(0.0, digits));
            found.verdict = "computed";
        }
        rungs.push(found);
    };
    let double = |x: f64| Some(Float::with_val(53, x));
    if let Target::Closed { joint } = &target {
        let joint = joint.to_f64();
        add("closed form, double", 53, &|| double(printed(Form::Thickness, Branch::Upper, joint)));
        add("trigonometric form, double", 53, &|| {
            double(trigonometric(Form::Thickness, Branch::Upper, &Angle::new(joint)))
        });
    }
    if let Target::Overturning { distance } = &target {
        let x = distance.to_f64();
        let a = 2.0 / 3.0 + x;
        add("(15) as printed, double", 53, &|| double(overturning::thickness(WEIGHT, &a)));
        add("(15) from A - 2/3, double", 53, &|| double(factored(&x)));
        let a = Float::with_val(256, Rational::from((2, 3)) + distance);
        add("(15) as printed, 256 bits", 256, &|| Some(overturning::thickness(WEIGHT, &a)));
    }
    if let Some(problem) = target.problem() {
        let index = target.index();
        let start: Option<Vec<f64>> =
            target.start(512).map(|start| start.iter().map(Float::to_f64).collect());
        if let Some(start) = start.filter(|x| x.iter().all(|x| x.is_normal())) {
            add("equations, Newton, double", 53, &|| {
                double(newton(&problem, &start, 53)?.root[index])
            });
            add("equations, Newton, double-double", double_double::BITS, &|| {
                let start: Vec<Quad> = start.iter().map(|&x| Quad::from(x)).collect();
                let found = newton(&problem, &start, double_double::BITS)?;
                Some(double_double::to_float(&found.root[index]))
            });
            add("equations, Newton, 256 bits", 256, &|| {
                Some(doubling(&problem, &start, 256)?.root.swap_remove(index))
            });
        }
        if limit.is_small {
            add("scaled equations, 53 bits", 53, &|| target.scaled(53));
        }
        if matches!(target, Target::State { mode: Mode::Rotational, .. }) {
            add("series or table, double", 53, &|| Some(target.start(53)?.swap_remove(index)));
        }
    }
    rungs.push(certified(&target, &truth, rung("certified", 0), condition_log10, budget));
    rungs
}

/// The certified result: the working precision is doubled until sixteen digits are proved.
fn certified(
    target: &Target,
    truth: &Ball,
    rung: Rung,
    condition_log10: f64,
    budget: Duration,
) -> Rung {
    let mut bits = 64;
    while bits <= MOST_BITS {
        let proved = target.enclosure(bits).filter(|ball| -relative_radius(ball) >= DIGITS);
        if let Some(ball) = proved {
            let timed = timed(budget, || target.enclosure(bits));
            let digits = f64::from(bits) * std::f64::consts::LOG10_2;
            return Rung {
                working_bits: bits,
                condition_log10,
                error_relative_log10: Some(error(ball.mid(), truth).relative),
                digits_lost: Some((digits + relative_radius(&ball)).max(0.0)),
                cpu_seconds: timed.cpu.as_secs_f64(),
                verdict: "proved",
                ..rung
            };
        }
        // Steps of a quarter: the precision that is needed shows.
        bits += (bits / 4).next_multiple_of(32);
    }
    Rung { condition_log10, verdict: "undecided", ..rung }
}

/// The rungs that are climbed: powers of a tenth.
pub const FULL: [u32; 13] = [1, 2, 3, 4, 6, 8, 12, 16, 20, 30, 40, 50, 60];
/// The same for a quick look.
pub const QUICK: [u32; 5] = [1, 3, 8, 20, 60];

#[cfg(test)]
mod tests {
    use super::*;

    /// The certified path proves every rung, and its error is what it claims.
    #[test]
    fn every_rung_is_proved() {
        for limit in &LIMITS {
            for k in [1, 12, 60] {
                let rungs = climb(limit, k, Duration::ZERO);
                let certified = rungs.last().unwrap();
                assert_eq!(certified.verdict, "proved", "{} 1e-{k}: {certified:?}", limit.name);
                assert!(certified.error_relative_log10.unwrap() <= -DIGITS);
            }
        }
    }
}
