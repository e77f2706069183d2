//! The search for the states with a value.

use super::exact::is_value;
use super::form::{TouchingForm, half_opening_of, touching_start};
use super::found::{OtherState, StateOfValue, StatesOfValue};
use crate::arch::haunch::Haunch;
use crate::arch::{Configuration, Ring, SelfWeight, Unknown, contact, overturning, thrust};
use crate::certify::equation::touched_thicknesses;
use crate::certify::state::find::widest::{at_end, at_thickness, bits_lost, exact_end, widest};
use crate::certify::state::mode::outcome;
use crate::certify::state::query::{GUARD, Query};
use crate::certify::state::rotation::JointForm;
use crate::certify::state::state::{Outcome, State};
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field, Real, bits_of};
use crate::problem::{Arch, Equation, Mode, Quantity, System};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::count::Count;
use crate::prover::decide::{decide, ensure, require};
use crate::prover::{Error, Figure, Undecided, raise};
use crate::solve::start;
use rug::Rational;

/// Digits at which modes are sought.
const FEW: usize = 20;

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
    pub(super) digits: usize,
}

/// Candidate that is proved to be a state, or to be none (`None`); or why that stays open.
type ProvedCandidate = Result<Option<StateOfValue>, Undecided>;

impl Search<'_> {
    fn weight(&self) -> SelfWeight {
        self.arch.weight()
    }

    fn ball(&self, bits: u32) -> Ball {
        self.value.enclosure(bits)
    }

    /// Bits for the first attempt at so many digits.
    fn first(&self, digits: usize) -> u32 {
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
        bits_of(digits) + GUARD + lost + arch
    }

    /// A proof of what has digits.
    fn raised<T>(
        &self,
        proof: impl FnMut(u32) -> Result<Option<T>, Undecided>,
    ) -> Result<T, Undecided> {
        raise(self.first(self.digits), proof)
    }

    /// A proof of what has none, which few bits mostly decide.
    fn decided<T>(
        &self,
        mut proof: impl FnMut(u32) -> Result<T, Undecided>,
    ) -> Result<T, Undecided> {
        raise(self.first(FEW), |bits| proof(bits).map(Some))
    }

    /// All states with the value.
    pub(super) fn all(&self) -> Result<StatesOfValue, Error> {
        if self.arch.friction().is_zero() {
            let none = Count::proved(0, "without friction nothing stands");
            return Ok(self.sieved(none, Vec::new(), "")?);
        }
        Ok(match self.quantity {
            Quantity::RotationJoint | Quantity::Thrust => self.on_curve(),
            Quantity::Thickness => self.with_thickness(),
            _ => self.with_opening_variable(),
        }?)
    }

    /// Statement why there are no others.
    fn proved(&self) -> &'static str {
        match self.quantity {
            _ if self.arch.friction().is_zero() => OF_THICKNESS,
            Quantity::RotationJoint => OF_JOINT,
            Quantity::Thrust => OF_THRUST,
            Quantity::Thickness => OF_THICKNESS,
            _ => OF_OPENING,
        }
    }

    fn sieved(
        &self,
        count: Count,
        candidates: Vec<ProvedCandidate>,
        excluded: &'static str,
    ) -> Result<StatesOfValue, Undecided> {
        let (states, none) = count.sieved(candidates, excluded)?;
        Ok(StatesOfValue { states, others: Vec::new(), none, proved: self.proved() }.sorted())
    }

    /// States with a joint, or with a thrust: each point of the purely rotational curve that has it is a candidate,
    /// and for a joint the one state that slides inside.
    fn on_curve(&self) -> Result<StatesOfValue, Undecided> {
        let of_joint = self.quantity == Quantity::RotationJoint;
        let is_limited = self.arch.is_limited();
        let points = match of_joint {
            true => {
                self.decided(|bits| Ok(self.of_joint(&Angle::new(self.ball(bits)), bits)?.len()))?
            }
            false => 1,
        };
        let mut others = Vec::new();
        let mut candidates: Vec<ProvedCandidate> = Vec::new();
        for number in 0..points {
            let mode = self.decided(|bits| self.curve_mode(number, bits));
            if is_limited && let Ok(Some(Mode::SlidingRotational) | None) = mode {
                others.push(self.other(number));
            }
            candidates.push(mode.and_then(|mode| self.curve_state(number, mode)));
        }
        let slides_inside = usize::from(is_limited && of_joint);
        if slides_inside > 0 {
            let modes = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
            candidates.push(self.arch_of(|bits| self.inside(bits), &modes));
        }
        if is_limited && !of_joint {
            self.decided(|bits| self.is_not_that_of_sliding(bits))?;
        }
        let count = Count::proved(
            points + slides_inside,
            "no state has a joint beyond the widest one, beta_sb",
        );
        let excluded = match of_joint {
            true => "with this friction no state has this joint",
            false => "with this friction no state has this thrust",
        };
        Ok(StatesOfValue { others, ..self.sieved(count, candidates, excluded)? })
    }

    /// Thicknesses of the purely rotational curve at the joint.
    fn of_joint(&self, joint: &Angle<Ball>, bits: u32) -> Result<Vec<Ball>, Undecided> {
        touched_thicknesses(self.weight(), joint, bits)
    }

    /// A point of the purely rotational curve with the value, with the half opening of (4).
    fn curve_point(&self, number: usize, bits: u32) -> Result<Configuration<Ball>, Undecided> {
        let (joint, thickness, thrust) = match self.quantity {
            Quantity::RotationJoint => {
                let joint = Angle::new(self.ball(bits));
                let found = self.of_joint(&joint, bits)?.into_iter().nth(number);
                let thickness = found.ok_or_else(Undecided::no_solution)?;
                let (ring, haunch) = (Ring::new(self.weight(), &thickness), Haunch::from(&joint));
                let thrust = thrust::touching(&haunch.versine, &haunch.excess, &ring).value();
                (joint, thickness, thrust)
            }
            _ => {
                let h = self.ball(bits);
                let (joint, thickness) = self.of_thrust(&h, bits)?;
                (joint, thickness, h)
            }
        };
        // Where (2) and (5) hold, with these in their ranges, the point is on the curve.
        let at = Configuration::zero(&thickness).with(Unknown::Thickness, thickness.clone());
        let before_end = -contact::crown_slope(self.weight(), &at);
        for (margin, what) in [
            (&joint.rad, "a touching joint below the crown"),
            (
                &(thickness.pi() - thickness.int(2) * &joint.rad),
                "a touching joint within a right angle",
            ),
            (&thickness, "a positive thickness"),
            (&before_end, "an arch that is thinner than at the end of rotation"),
        ] {
            require(margin, what)?;
        }
        let of_thickness =
            overturning::opening_variable(&Ring::new(self.weight(), &thickness)).value();
        let half_opening = half_opening_of(&(of_thickness + &thrust), bits)?;
        Ok(Configuration { thrust, rotation_joint: joint, half_opening, ..at })
    }

    /// Joint and thickness of the purely rotational curve at a thrust.
    fn of_thrust(&self, thrust: &Ball, bits: u32) -> Result<(Angle<Ball>, Ball), Undecided> {
        let [beta, eta, _] = start::rotational_with_thrust(self.weight(), &thrust.candidate());
        let (joint, start) = JointForm::near::<Ball>(beta, bits);
        let form = TouchingForm { weight: self.weight(), thrust, joint };
        let (root, sines) = Ball::rooted(&form, bits, &[start, eta])?;
        Ok((Ball::angle(&sines, &joint.rad(&root[0])), root[1].clone()))
    }

    /// The thrust of (18), at which an inner joint slides; no arch that stands with this friction has a smaller one.
    fn slid(&self, bits: u32) -> Result<Configuration<Ball>, Undecided> {
        let query: Query = Query::new(&self.arch, bits);
        let start = start::inner_sliding(&query.given.friction.candidate());
        query.root(System::inner_sliding(self.weight()), &start)
    }

    /// Thickness at which the line of thrust touches the joint at the thrust of (18).
    fn inside(&self, bits: u32) -> Result<Option<Ball>, Undecided> {
        use {Equation as E, Unknown as U};
        let slid = self.slid(bits)?;
        let joint = Angle::new(self.ball(bits));
        // (5) is beta cot(beta) - h + 1 = 2 fac/(2 - eta), which grows from one.
        let rest = joint.times_cotangent() - &slid.thrust;
        let question =
            "whether the line of thrust can touch this joint where an inner joint slides";
        if !decide(&rest, question, &[])? {
            return Ok(None);
        }
        let start = touching_start(self.weight(), &rest.candidate());
        let query = Query::new(&self.arch, bits);
        let given = slid.with(U::RotationJoint, joint.rad);
        let system = System {
            weight: self.weight(),
            unknowns: &[U::Thickness],
            equations: &[E::Tangency],
            fixed: &[],
        };
        Ok(Some(Query { given, ..query }.root(system, &[start])?.thickness))
    }

    /// The one arch of which a thickness is the least, if there is that thickness and the arch collapses in one of some
    /// modes.
    fn arch_of(
        &self,
        thickness: impl Fn(u32) -> Result<Option<Ball>, Undecided>,
        modes: &[Mode],
    ) -> ProvedCandidate {
        let arch = |bits| {
            let Some(thickness) = thickness(bits)? else { return Ok(None) };
            let query = Query::new(&self.arch, bits);
            let given = query.given.clone().with(Unknown::HalfOpening, thickness.int(0));
            let query = Query { given: given.with(Unknown::Thickness, thickness), ..query };
            Ok(Some(widest(&query, None)?).filter(|(mode, _)| modes.contains(mode)))
        };
        match self.decided(|bits| Ok(arch(bits)?.is_some()))? {
            true => self.raised(|bits| match arch(bits)? {
                Some((mode, at)) => Ok(self.shown(mode, &at)?.map(Some)),
                None => Ok(Some(None)),
            }),
            false => Ok(None),
        }
    }

    /// Mode of the state at a point of the curve: with enough friction the purely rotational one of its half opening,
    /// else the one that its thickness may have, whose shoulder slides.
    fn curve_mode(&self, number: usize, bits: u32) -> Result<Option<Mode>, Undecided> {
        let at = self.curve_point(number, bits)?;
        match self.outcome_at(&at.half_opening.rad, bits)? {
            Outcome::Stands(state) if state.mode == Mode::Rotational => {
                let is_it = state.thickness.overlaps(&at.thickness);
                ensure(is_it, "whether the state that is found has the value")?;
                Ok(Some(Mode::Rotational))
            }
            _ if self.arch.is_limited() => {
                let margin = at.thrust - &self.slid(bits)?.thrust;
                let slides_outside = decide(&margin, "whether an inner joint slides", &[])?;
                Ok(slides_outside.then_some(Mode::SlidingRotational))
            }
            _ => Err(Undecided::new("whether the state that is found is purely rotational")),
        }
    }

    /// State at a point of the curve, where it may have a mode.
    fn curve_state(&self, number: usize, mode: Option<Mode>) -> ProvedCandidate {
        match mode {
            Some(Mode::Rotational) => self.raised(|bits| {
                let at = self.curve_point(number, bits)?;
                Ok(self.shown(Mode::Rotational, &at)?.map(Some))
            }),
            Some(mode) => {
                self.arch_of(|bits| Ok(Some(self.curve_point(number, bits)?.thickness)), &[mode])
            }
            None => Ok(None),
        }
    }

    /// State, with this friction, of the half opening that has the value with unlimited friction.
    fn other(&self, number: usize) -> Result<OtherState, Undecided> {
        let half_opening = |bits| Ok(self.curve_point(number, bits)?.half_opening.rad);
        let mode = self.decided(|bits| match self.outcome_at(&half_opening(bits)?, bits)? {
            Outcome::Stands(state) => Ok(Ok(state.mode)),
            Outcome::Falls(fall) => Ok(Err(fall)),
        })?;
        let half_opening =
            self.raised(|bits| Ok(Figure::new(&half_opening(bits)?, self.digits)))?;
        Ok(OtherState { half_opening, mode })
    }

    /// State of a half opening.
    fn outcome_at(&self, half_opening: &Ball, bits: u32) -> Result<Outcome, Undecided> {
        let query: Query = Query::new(&self.arch, bits);
        let given = query.given.clone().with(Unknown::HalfOpening, half_opening.clone());
        outcome(&Query { given, ..query }, false)
    }

    /// Proves that the thrust is not that of an inner joint that slides, which a whole range of arches has.
    fn is_not_that_of_sliding(&self, bits: u32) -> Result<(), Undecided> {
        let differs = (self.ball(bits) - self.slid(bits)?.thrust).excludes_zero();
        ensure(differs, "whether the thrust is that at which an inner joint slides")
    }

    fn with_thickness(&self) -> Result<StatesOfValue, Undecided> {
        let end = exact_end(self.weight(), self.quantity, self.value);
        let state = self.raised(|bits| {
            let (mode, at) = widest(&at_thickness(&self.arch, self.value, bits), end)?;
            if mode == Mode::Sliding {
                return Ok(Some(None));
            }
            Ok(self.shown(mode, &at)?.map(Some))
        });
        let excluded =
            "with this friction every arch that stands needs less, and wider ones slide as [s,s]";
        self.sieved(Count::proved(1, OF_THICKNESS), vec![state], excluded)
    }

    fn with_opening_variable(&self) -> Result<StatesOfValue, Undecided> {
        let end = exact_end(self.weight(), self.quantity, self.value);
        let end = end.filter(|_| !self.arch.is_limited());
        let mut fall = "";
        let state = self.raised(|bits| {
            if let Some(end) = end {
                let at = at_end(end, self.weight(), bits)?;
                return Ok(self.shown(Mode::Overturning, &at)?.map(Some));
            }
            let a = self.ball(bits);
            let alpha = half_opening_of(&a, bits)?.rad;
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
        self.sieved(Count::proved(1, OF_OPENING), vec![state], fall)
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
