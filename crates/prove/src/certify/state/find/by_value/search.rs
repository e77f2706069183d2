//! The search for the states with a value.

use super::exact::is_value;
use super::found::{OtherState, StateOfValue, StatesOfValue};
use crate::arch::{Configuration, SelfWeight, Unknown, thrust};
use crate::certify::equation::touched_thicknesses;
use crate::certify::state::find::widest::{ModeAt, at_thickness, bits_lost, widest};
use crate::certify::state::mode::outcome;
use crate::certify::state::query::{GUARD, Query};
use crate::certify::state::state::{Outcome, State};
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field, Real, Stumpff, bits_of};
use crate::problem::{Arch, Equation, Mode, Quantity, System};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::{decide, ensure};
use crate::prover::root::{Form, root_near};
use crate::prover::{Error, Figure, Undecided, raise};
use crate::solve::start;
use rug::{Float, Rational};

const OF_JOINT: &str = "(7) has no other thickness, (5) and (18) one at most, and each is the least of one half opening at most";
const OF_THRUST: &str =
    "one thickness of the purely rotational states has this thrust, none that slides inside";
const OF_THICKNESS: &str = "the least thickness grows strictly with the half opening";
const OF_OPENING: &str = "one half opening has this A, and one state";

/// A search for the states with a value.
pub(super) struct Search<'a> {
    pub(super) quantity: Quantity,
    pub(super) value: &'a ExactNumber,
    /// Arch of the friction, with something in place of the half opening.
    pub(super) arch: Arch,
    /// Arch of unlimited friction.
    pub(super) unlimited: Arch,
    pub(super) digits: usize,
}

/// Family of states on which a thickness is sought.
#[derive(Clone, Copy)]
enum Family {
    /// The purely rotational curve, with the number of its thickness.
    Curve(usize),
    /// States that slide inside.
    Inside,
}

impl Search<'_> {
    fn weight(&self) -> SelfWeight {
        self.arch.weight()
    }

    fn ball(&self, bits: u32) -> Ball {
        self.value.enclosure(bits)
    }

    /// Bits for the first attempt.
    fn first(&self) -> u32 {
        let size = |x: Ball| x.mid().get_exp().unwrap_or(0).min(0).unsigned_abs();
        let value = self.ball(GUARD);
        let lost = match self.quantity {
            Quantity::RotationJoint => 12 * size(value),
            Quantity::Thrust => 3 * size(self.ball(4096) - value.int(1)) + 2 * size(value),
            Quantity::OpeningVariable => 3 * size(self.ball(4096) - value.int(2)),
            _ => 0,
        };
        let thickness = match self.quantity {
            Quantity::Thickness => self.value.clone(),
            _ => ExactNumber::from(&Rational::from(1)),
        };
        let arch = bits_lost(&at_thickness(&self.arch, &thickness, 64));
        bits_of(self.digits) + GUARD + lost + arch
    }

    fn raised<T>(
        &self,
        proof: impl FnMut(u32) -> Result<Option<T>, Undecided>,
    ) -> Result<T, Undecided> {
        raise(self.first(), proof)
    }

    /// All states with the value.
    pub(super) fn all(&self) -> Result<StatesOfValue, Error> {
        if self.arch.friction().is_zero() {
            return Ok(StatesOfValue::none("without friction nothing stands", OF_THICKNESS));
        }
        match self.quantity {
            Quantity::RotationJoint | Quantity::Thrust => self.on_curve(),
            Quantity::Thickness => self.with_thickness(),
            _ => self.with_opening_variable(),
        }
    }

    /// States with a joint, or with a thrust.
    fn on_curve(&self) -> Result<StatesOfValue, Error> {
        let of_joint = self.quantity == Quantity::RotationJoint;
        let proved = if of_joint { OF_JOINT } else { OF_THRUST };
        let count = match of_joint {
            true => self.raised(|bits| Ok(Some(self.of_joint(bits)?.len())))?,
            false => 1,
        };
        let is_limited = self.arch.is_limited();
        let mut found = StatesOfValue::none("no state has this joint", proved);
        for curve in 0..count {
            let state = self.raised(|bits| self.curve_state(curve, bits));
            let has_other = is_limited
                && !matches!(&state, Ok(Some(StateOfValue { mode: Mode::Rotational, .. })));
            if has_other {
                found.others.push(self.raised(|bits| self.other(curve, bits)));
            }
            found.states.extend(state.transpose());
        }
        if is_limited && of_joint {
            let inside = self.raised(|bits| self.inside_state(bits));
            found.states.extend(inside.transpose());
        }
        if is_limited && !of_joint {
            self.raised(|bits| self.is_not_that_of_sliding(bits).map(Some))?;
        }
        found.sorted(match (count, of_joint) {
            (0, _) if !is_limited => "no state has a joint beyond the widest one, beta_sb",
            (_, true) => "with this friction no state has this joint",
            _ => "with this friction no state has this thrust",
        })
    }

    /// Thicknesses of the purely rotational curve at the joint.
    fn of_joint(&self, bits: u32) -> Result<Vec<Ball>, Undecided> {
        touched_thicknesses(self.weight(), &Angle::new(self.ball(bits)), bits)
    }

    /// Thickness of a family; `None` if the joint is none of it.
    fn thickness(&self, family: Family, bits: u32) -> Result<Option<Ball>, Undecided> {
        match (family, self.quantity) {
            (Family::Inside, _) => self.inside(bits),
            (Family::Curve(number), Quantity::RotationJoint) => {
                Ok(self.of_joint(bits)?.into_iter().nth(number))
            }
            (Family::Curve(_), _) => self.of_thrust(bits).map(Some),
        }
    }

    /// Thickness of the purely rotational curve at the thrust.
    fn of_thrust(&self, bits: u32) -> Result<Ball, Undecided> {
        use {Equation as E, Unknown as U};
        let h = self.ball(bits);
        let [beta, eta, _] = start::rotational_with_thrust(self.weight(), &h.candidate());
        let query: Query = Query::new(&self.arch, bits);
        let query = Query { given: query.given.clone().with(U::Thrust, h), ..query };
        let system = System {
            weight: self.weight(),
            unknowns: &[U::RotationJoint, U::Thickness],
            equations: &[E::LowerThrust, E::Tangency],
            fixed: &[],
        };
        Ok(query.root(system, &[beta, eta])?.thickness)
    }

    /// Thickness at which the line of thrust touches the joint at the thrust of (18).
    fn inside(&self, bits: u32) -> Result<Option<Ball>, Undecided> {
        use {Equation as E, Unknown as U};
        let query: Query = Query::new(&self.arch, bits);
        let start = start::inner_sliding(&query.given.friction.candidate());
        let slid = query.root(System::inner_sliding(self.weight()), &start)?;
        let joint = Angle::new(self.ball(bits));
        // (5) is beta cot(beta) - h + 1 = 2 fac/(2 - eta), which grows from one.
        let rest = joint.times_cotangent() - &slid.thrust;
        let question =
            "whether the line of thrust can touch this joint where an inner joint slides";
        if !decide(&rest, question, &[])? {
            return Ok(None);
        }
        let start = touching_start(self.weight(), &rest.candidate());
        let given = slid.with(U::RotationJoint, joint.rad);
        let system = System {
            weight: self.weight(),
            unknowns: &[U::Thickness],
            equations: &[E::Tangency],
            fixed: &[],
        };
        Ok(Some(Query { given, ..query }.root(system, &[start])?.thickness))
    }

    /// The one arch of which a thickness is the least.
    fn arch_of(&self, thickness: Ball, arch: &Arch, bits: u32) -> Result<ModeAt<Ball>, Undecided> {
        let query = Query::new(arch, bits);
        let given = query.given.clone().with(Unknown::HalfOpening, thickness.int(0));
        widest(&Query { given: given.with(Unknown::Thickness, thickness), ..query }, false)
    }

    /// State on the curve, if the arch of its thickness is on it.
    fn curve_state(
        &self,
        curve: usize,
        bits: u32,
    ) -> Result<Option<Option<StateOfValue>>, Undecided> {
        let modes = [Mode::Rotational, Mode::SlidingRotational];
        self.state_of(Family::Curve(curve), &modes, bits)
    }

    /// State that slides inside.
    fn inside_state(&self, bits: u32) -> Result<Option<Option<StateOfValue>>, Undecided> {
        let modes = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
        self.state_of(Family::Inside, &modes, bits)
    }

    fn state_of(
        &self,
        family: Family,
        modes: &[Mode],
        bits: u32,
    ) -> Result<Option<Option<StateOfValue>>, Undecided> {
        let Some(thickness) = self.thickness(family, bits)? else { return Ok(Some(None)) };
        let (mode, at) = self.arch_of(thickness, &self.arch, bits)?;
        if !modes.contains(&mode) {
            return Ok(Some(None));
        }
        Ok(self.shown(mode, &at)?.map(Some))
    }

    /// State, with this friction, of the half opening that has the value with unlimited friction.
    fn other(&self, curve: usize, bits: u32) -> Result<Option<OtherState>, Undecided> {
        let Some(thickness) = self.thickness(Family::Curve(curve), bits)? else { return Ok(None) };
        let (_, at) = self.arch_of(thickness, &self.unlimited, bits)?;
        let mode = match self.outcome_at(&at.half_opening.rad, bits)? {
            Outcome::Stands(state) => Ok(state.mode),
            Outcome::Falls(fall) => Err(fall),
        };
        let half_opening = Figure::new(&at.half_opening.rad, self.digits);
        Ok(half_opening.map(|half_opening| OtherState { half_opening, mode }))
    }

    /// State of a half opening.
    fn outcome_at(&self, half_opening: &Ball, bits: u32) -> Result<Outcome, Undecided> {
        let query: Query = Query::new(&self.arch, bits);
        let given = query.given.clone().with(Unknown::HalfOpening, half_opening.clone());
        outcome(&Query { given, ..query }, false)
    }

    /// Proves that the thrust is not that of an inner joint that slides, which a whole range of arches has.
    fn is_not_that_of_sliding(&self, bits: u32) -> Result<(), Undecided> {
        let query: Query = Query::new(&self.arch, bits);
        let start = start::inner_sliding(&query.given.friction.candidate());
        let slid = query.root(System::inner_sliding(self.weight()), &start)?;
        let differs = (self.ball(bits) - slid.thrust).excludes_zero();
        ensure(differs, "whether the thrust is that at which an inner joint slides")
    }

    fn with_thickness(&self) -> Result<StatesOfValue, Error> {
        let two = ExactNumber::from(&Rational::from(2));
        let is_limit = self.value.factor() == two.factor();
        let state = self.raised(|bits| {
            let (mode, at) = widest(&at_thickness(&self.arch, self.value, bits), is_limit)?;
            if mode == Mode::Sliding {
                return Ok(Some(None));
            }
            Ok(self.shown(mode, &at)?.map(Some))
        });
        let mut found = StatesOfValue::none("", OF_THICKNESS);
        found.states.extend(state.transpose());
        found.sorted(
            "with this friction every arch that stands needs less, and wider ones slide as [s,s]",
        )
    }

    fn with_opening_variable(&self) -> Result<StatesOfValue, Error> {
        let mut fall = "";
        let state = self.raised(|bits| {
            let a = self.ball(bits);
            let alpha = half_opening_of(&a, bits)?;
            match self.outcome_at(&alpha, bits)? {
                Outcome::Stands(state) => {
                    Ok(self.shown(state.mode, &placed(&state, &alpha))?.map(Some))
                }
                Outcome::Falls(why) => {
                    fall = why.reason();
                    Ok(Some(None))
                }
            }
        });
        let mut found = StatesOfValue::none("", OF_OPENING);
        found.states.extend(state.transpose());
        found.sorted(fall)
    }

    /// Figures of a state; `None` if they are not decided.
    fn shown(
        &self,
        mode: Mode,
        at: &Configuration<Ball>,
    ) -> Result<Option<StateOfValue>, Undecided> {
        let alpha = &at.half_opening;
        let inside = mode.slides_inside().then(|| at.sliding_joint.rad.clone());
        let values = [
            Some(alpha.rad.clone()),
            Some(alpha.rad.clone() * alpha.rad.int(180) / alpha.rad.pi()),
            Some(thrust::opening_variable(alpha).value()),
            Some(at.thickness.clone()),
            Some(at.thrust.clone()),
            Some(at.thickness.clone() * &at.thrust),
            Some(at.rotation_joint.rad.clone()),
            inside,
        ];
        let (given, exact) = (self.quantity, self.value);
        let of = |(quantity, value): (Quantity, Option<Ball>)| {
            let value = value?;
            let figure = match quantity == given && exact.is_rational() {
                true => Figure::exact(exact, self.digits),
                false => Figure::proved(&value, self.digits, |x| {
                    is_value(self.weight(), mode, (given, exact), quantity, &value, x)
                }),
            };
            Some(figure.map(|figure| (quantity, figure)))
        };
        let all = StateOfValue::VALUES.into_iter().zip(values);
        let is_given = all.clone().find(|(quantity, _)| *quantity == given);
        let own = is_given.and_then(|(_, value)| value);
        let holds = own.is_some_and(|own| own.overlaps(&self.ball(own.prec())));
        ensure(holds, "whether the state that is found has the value")?;
        let values: Option<Vec<(Quantity, Figure)>> = all.filter_map(of).collect();
        Ok(values.map(|values| StateOfValue { mode, values }))
    }
}

/// The configuration of a state at its half opening.
fn placed(state: &State<Ball>, alpha: &Ball) -> Configuration<Ball> {
    use Unknown as U;
    let at = Configuration::zero(alpha)
        .with(U::HalfOpening, alpha.clone())
        .with(U::Thickness, state.thickness.clone())
        .with(U::Thrust, state.thrust.clone())
        .with(U::RotationJoint, state.rotation_joint.clone());
    match &state.sliding_joint {
        Some(joint) => at.with(U::SlidingJoint, joint.clone()),
        None => at,
    }
}

/// A candidate: the thickness of (5) by `beta cot(beta) - h`.
fn touching_start(weight: SelfWeight, rest: &Float) -> Float {
    let sum = rest.clone() + 1u32;
    match weight {
        SelfWeight::Heyman => rest.clone() * 2u32 / sum,
        SelfWeight::Milankovitch => {
            let root = (sum.clone() * &sum * 9u32 + rest.clone() * 12u32).sqrt();
            rest.clone() * 12u32 / (sum * 3u32 + root)
        }
    }
}

/// `A = alpha cot(alpha/2)` for the half opening.
struct OpeningForm<'a>(&'a Ball);

impl Form<Ball> for OpeningForm<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let alpha = Angle::new(x[0].clone());
        vec![thrust::opening_variable(&alpha).residual(&number(self.0))]
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&Ball) -> T, x: &[T]) -> bool {
        Angle::new(x[0].clone()).versine().excludes_zero()
    }
}

/// The half opening of an opening variable between 0 and 2.
fn half_opening_of(a: &Ball, bits: u32) -> Result<Ball, Undecided> {
    /// Below this `2 - A` the leading term is used.
    const NARROW: f64 = 1e-3;
    let rest = a.int(2) - a;
    let start = match rest.candidate() {
        // A = 2 - alpha²/6 - ….
        rest if rest < NARROW => (rest * 6u32).sqrt(),
        _ => {
            let (mut low, mut high) = (0.0f64, std::f64::consts::PI);
            let a = a.mid().to_f64();
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let value = thrust::opening_variable(&Angle::new(middle)).value();
                if value > a { low = middle } else { high = middle }
            }
            Float::with_val(bits, low)
        }
    };
    let alpha = root_near(&OpeningForm(a), bits, vec![start])?.remove(0);
    let inside = (alpha.pi() - &alpha).is_positive().is_proved() && alpha.is_positive().is_proved();
    ensure(inside, "a half opening between 0 and pi")?;
    Ok(alpha)
}
