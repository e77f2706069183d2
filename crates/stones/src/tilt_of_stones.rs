//! The largest horizontal acceleration at which an arch of stones of a given thickness has an admissible state, proved.
//!
//! Between stones it is a linear programme in `h, p, v` and `k`. **From above**: conditions that are zero together
//! at one state, with positive multipliers that leave `k` alone, leave this `k` as a bound. **From below**: that
//! state satisfies all other conditions, each with room but for the fourth of a joint whose other three are zero,
//! and which bears nothing, or of both hinges of a joint whose two slips are zero, where `p` is chosen so. So the
//! largest acceleration is that of the state, exactly. Four conditions fix the state, or three slips, which leave
//! room for `p`. What a search says of which they are is trusted for nothing. The proof is done once, with few bits;
//! the digits are those of the one solution of these equations.
//!
//! **At one acceleration** a state with room says that there is one, and four conditions that contradict each other
//! that there is none, whatever of the largest stays open.
//!
//! What it means is said in [`tilted`](super::tilted): with friction an admissible state does not exclude a motion.

use super::jointed::limits_at_joint;
use super::tilt::{NOT_FOUND, TiltDigits, UNBOUNDED, contradict, determinant};
use super::tilt_mechanism::{TiltMechanism, TiltedJoint, kept};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::tilt::TiltedRow;
use crate::arch::whole::Side;
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Joints, Slope};
use crate::prover::decide::{ensure, is_positive};
use crate::prover::{Refused, Undecided};
use crate::solve::tilt::{StoneTilt, against, inside, largest};
use rug::Float;

/// More stones are refused: the programme has four conditions at each joint.
pub const MOST_TILTED_STONES: u64 = 2_001;

/// The place of a condition: the joint by its number from the crown, its side, and what it says.
type LimitPlace = (u64, Side, Contact);

/// A condition of a stone's joint.
struct StoneLimit {
    place: LimitPlace,
    /// Angle of the joint from the crown, positive on the right.
    angle: Ball,
    row: TiltedRow<Ball>,
}

/// Proves what holds for an arch of stones that stands at this thickness under an acceleration, to `digits`
/// significant digits.
pub fn tilted_stones(
    arch: &Arch,
    stones: &Stones,
    thickness: &ExactNumber,
    tilt: &Slope,
    digits: usize,
) -> Result<TiltDigits, Refused> {
    Refused::thickness(thickness)?;
    Refused::digits(digits)?;
    stones.check()?;
    Refused::stones(stones.number(), MOST_TILTED_STONES)?;
    let at = |places: &[LimitPlace], bits| conditions(arch, stones, thickness, places, bits);
    let all = |bits| at(&places(arch, stones), bits);
    let refined = |(limits, mechanism): &(Vec<LimitPlace>, TiltMechanism), bits| {
        let mut refined = mechanism.clone();
        if refined.tilt().prec() < bits {
            let limits = at(limits, bits);
            let limits: Vec<&StoneLimit> = limits.iter().collect();
            let system = StoneSystem::new(&limits)?;
            let fixed = system.kept.iter().enumerate();
            fixed.for_each(|(column, k)| refined.forces[*k] = system.unknown(column));
        }
        Ok(refined)
    };
    let told: [&dyn Fn(&Ball) -> bool; 2] =
        [&|tilt| has_state(&all(tilt.prec()), tilt), &|tilt| has_none(&all(tilt.prec()), tilt)];
    Ok(TiltDigits::found(digits, tilt, |bits| largest_of(&all(bits), bits), refined, told))
}

/// Tells whether the state at an acceleration that is farthest from all conditions satisfies them.
fn has_state(all: &[StoneLimit], tilt: &Ball) -> bool {
    let Some(state) = inside(&in_doubles(all), tilt.mid().to_f64()) else { return false };
    let [h, p, v, _] = state.map(|x| Ball::exact(Float::with_val(tilt.prec(), x), tilt.prec()));
    let (one, unknowns) = (h.int(1), [h, p, v, tilt.clone()]);
    all.iter().all(|of| (-of.row.at(&unknowns, &one)).is_positive().is_proved())
}

/// Tells whether some conditions contradict each other at an acceleration.
fn has_none(all: &[StoneLimit], tilt: &Ball) -> bool {
    let Some(places) = against(&in_doubles(all), tilt.mid().to_f64()) else {
        return false;
    };
    let row = |place: &usize| Some(all.get(*place)?.row.clone());
    contradict(&places.iter().filter_map(row).collect::<Vec<_>>(), tilt)
}

/// The rows in doubles.
fn in_doubles(all: &[StoneLimit]) -> Vec<TiltedRow<f64>> {
    all.iter().map(|of| of.row.map(|x| x.mid().to_f64())).collect()
}

/// The places of all conditions, from the crown.
fn places(arch: &Arch, stones: &Stones) -> Vec<LimitPlace> {
    // Both hinges together ask for a normal force: without limit of friction this is all.
    let asked = &Contact::ALL[..limits_at_joint(arch)];
    let sides = |joint: u64| {
        let crown = joint == 0 && stones.has_joint_at_crown();
        let sides: &[Side] = if crown { &[Side::Right] } else { &[Side::Right, Side::Left] };
        sides.iter().map(move |side| (joint, *side))
    };
    let all = (0..stones.count()).flat_map(sides);
    all.flat_map(|(joint, side)| asked.iter().map(move |of| (joint, side, *of))).collect()
}

/// The conditions at some places.
fn conditions(
    arch: &Arch,
    stones: &Stones,
    thickness: &ExactNumber,
    places: &[LimitPlace],
    bits: u32,
) -> Vec<StoneLimit> {
    let grip: Grip<Ball> = arch.friction().grip(bits);
    let joints = Joints::new(arch.weight(), &thickness.enclosure(bits), grip);
    let mut last: Option<(u64, Angle<Ball>)> = None;
    let limit = |&(joint, side, contact): &LimitPlace| {
        let angle = match last.take() {
            Some((index, angle)) if index == joint => angle,
            _ => stones.angle(joint, bits),
        };
        let at = side.joint(&angle);
        last = Some((joint, angle));
        let row = joints.tilted(contact, &at);
        StoneLimit { place: (joint, side, contact), angle: at.rad, row }
    };
    places.iter().map(limit).collect()
}

/// The joints that give way at the largest acceleration, proved, and the places of their conditions; `None` if there
/// is no largest one.
fn largest_of(
    all: &[StoneLimit],
    bits: u32,
) -> Result<Option<(Vec<LimitPlace>, TiltMechanism)>, Undecided> {
    match largest(&in_doubles(all)) {
        StoneTilt::Nothing => Err(Undecided::new(NOT_FOUND)),
        StoneTilt::Unlimited(direction) => unlimited(all, &direction, bits).map(|()| None),
        StoneTilt::Limited { active, moment } => {
            let mechanism = limited(all, &active, moment, bits)?;
            Ok(Some((active.iter().map(|place| all[*place].place).collect(), mechanism)))
        }
    }
}

/// The equations of some conditions that are zero together, as many as unknowns.
struct StoneSystem<'a> {
    of: &'a [&'a StoneLimit],
    /// The unknowns of `h, p, v, k` that they leave no room for: without a hinge nothing is said of `p`.
    kept: &'static [usize],
    matrix: Vec<Vec<Ball>>,
    determinant: Ball,
}

impl<'a> StoneSystem<'a> {
    fn new(of: &'a [&'a StoneLimit]) -> Result<Self, Undecided> {
        let kept = kept(of.iter().map(|at| at.place.2));
        ensure(of.len() == kept.len(), NOT_FOUND)?;
        let row = |at: &&StoneLimit| kept.iter().map(|k| at.row.coefficients[*k].clone()).collect();
        let matrix: Vec<Vec<Ball>> = of.iter().map(row).collect();
        let determinant = determinant(&matrix);
        ensure(determinant.excludes_zero(), NOT_FOUND)?;
        Ok(Self { of, kept, matrix, determinant })
    }

    /// The unknown of a column, by Cramer's rule, with what is on the right.
    fn solved(&self, column: usize, right: impl Fn(usize) -> Ball) -> Ball {
        let mut matrix = self.matrix.clone();
        matrix.iter_mut().enumerate().for_each(|(i, row)| row[column] = right(i));
        determinant(&matrix) / &self.determinant
    }

    fn unknown(&self, column: usize) -> Ball {
        self.solved(column, |i| -self.of[i].row.load.clone())
    }

    /// The multiplier of a condition: what the acceleration would be with that condition alone on the right.
    fn multiplier(&self, of: usize) -> Ball {
        self.solved(self.kept.len() - 1, |i| self.determinant.int(i32::from(i == of)))
    }
}

/// The state at which some conditions are zero, if it is the best and satisfies all others.
fn limited(
    all: &[StoneLimit],
    active: &[usize],
    moment: f64,
    bits: u32,
) -> Result<TiltMechanism, Undecided> {
    let of: Vec<&StoneLimit> = active.iter().filter_map(|place| all.get(*place)).collect();
    let system = StoneSystem::new(&of)?;
    let multipliers: Vec<Ball> = (0..of.len()).map(|i| system.multiplier(i)).collect();
    ensure(multipliers.iter().all(is_positive), NOT_FOUND)?;
    let mut unknowns = [0, 1, 2, 3].map(|_| Ball::exact(Float::with_val(bits, moment), bits));
    for (column, k) in system.kept.iter().enumerate() {
        unknowns[*k] = system.unknown(column);
    }
    let (zero, one) = (system.determinant.int(0), system.determinant.int(1));
    let is_pinned = system.kept.len() == unknowns.len();
    // Both slips of a joint leave it no force, and with one hinge, which pins p, no moment: the other hinge is zero
    // too.
    let joint = |of: &StoneLimit| (of.place.0, of.place.1);
    let slips = |at: &StoneLimit| {
        of.iter().filter(|other| joint(other) == joint(at) && !other.place.2.is_hinge()).count()
    };
    let idle = of.iter().find(|at| slips(at) == 2).map(|at| joint(at));
    if let (false, Some(idle)) = (is_pinned, idle) {
        let extrados = (idle.0, idle.1, Contact::Extrados);
        let hinge = all.iter().find(|of| of.place == extrados);
        let hinge = hinge.ok_or_else(|| Undecided::new(NOT_FOUND))?;
        unknowns[1] = zero;
        unknowns[1] = -(hinge.row.at(&unknowns, &one) / &hinge.row.coefficients[1]);
    }
    // Three conditions of a joint leave it no force: the fourth is zero too.
    let bears_nothing = |at: &StoneLimit| {
        let same = |other: &&&StoneLimit| joint(other) == joint(at);
        of.iter().filter(same).count() == 3 || !is_pinned && idle == Some(joint(at))
    };
    let others = all.iter().enumerate().filter(|(place, _)| !active.contains(place));
    let others = others.filter(|(_, at)| !bears_nothing(at));
    let holds = |of: &StoneLimit| (-of.row.at(&unknowns, &one)).is_positive().is_proved();
    let is_admissible = others.into_iter().all(|(_, of)| holds(of));
    ensure(is_admissible, "whether a state is admissible at every joint")?;
    let springing = all.iter().map(|of| of.place.0).max().unwrap_or(0);
    let joint = |(of, rate): (&&StoneLimit, Ball)| TiltedJoint {
        contact: of.place.2,
        angle: of.angle.clone(),
        rate,
        is_springing: of.place.0 == springing,
    };
    let joints = of.iter().zip(multipliers).map(joint).collect();
    Ok(TiltMechanism::ordered(unknowns, joints))
}

/// Any amount of a direction, with its acceleration of one, may be added to a state.
fn unlimited(all: &[StoneLimit], direction: &[f64; 3], bits: u32) -> Result<(), Undecided> {
    let [h, p, v] = direction.map(|x| Ball::exact(Float::with_val(bits, x), bits));
    let (one, zero) = (h.int(1), h.int(0));
    let unknowns = [h, p, v, one];
    let falls = |of: &StoneLimit| (-of.row.at(&unknowns, &zero)).is_positive().is_proved();
    ensure(all.iter().all(falls), UNBOUNDED)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{LargestTilt, tilted};

    fn found(arch: [&str; 3], stones: u64, eta: &str, tilt: &str) -> TiltDigits {
        let [weight, alpha, mu] = arch;
        let arch = Arch::parse(weight, alpha, mu).unwrap();
        let stones = Stones::equal(stones, arch.half_opening().clone()).unwrap();
        tilted_stones(&arch, &stones, &eta.parse().unwrap(), &tilt.parse().unwrap(), 12).unwrap()
    }

    fn value(found: &TiltDigits) -> f64 {
        match &found.largest {
            Ok(LargestTilt::Limited(figure, _)) => figure.double,
            other => panic!("{other:?}"),
        }
    }

    /// Many stones bear a little more than an arch with a joint at every angle, and come near it; fewer bear more.
    #[test]
    fn many_stones_come_near_an_arch_with_all_joints() {
        for (alpha, mu, eta) in
            [("pi/2", "inf", "0.15"), ("pi/2", "0.4", "0.15"), ("1.2", "0.6", "0.1")]
        {
            let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
            let all = tilted(&arch, &eta.parse().unwrap(), &"0.01".parse().unwrap(), 12).unwrap();
            let all = value(&all);
            let [few, many] =
                [20, 200].map(|n| value(&found(["milankovitch", alpha, mu], n, eta, "0.01")));
            assert!(few >= many && many >= all - 1e-11, "{alpha} {mu}: {few} {many} {all}");
            assert!(many - all < 1e-3, "{alpha} {mu}: {many} {all}");
        }
    }

    /// The values of a linear programme; the intrados is one point.
    #[test]
    fn the_thickness_may_be_2() {
        for (arch, stones, known) in [
            (["milankovitch", "1", "1"], 4, 4.588_037_825),
            (["heyman", "2.3", "3"], 8, 0.543_358_573),
        ] {
            let largest = value(&found(arch, stones, "2", "0.1"));
            assert!((largest - known).abs() < 1e-9, "{arch:?}: {largest}");
        }
    }

    /// A keystone whose left joint bears nothing at the largest acceleration, with slips alone: its hinges pin the
    /// moment. Beside it an acceleration is decided.
    #[test]
    fn a_joint_that_bears_nothing_pins_the_moment() {
        let arch = ["heyman", "2.203", "1.838"];
        let of = |tilt: &str| found(arch, 5, "1.45", tilt);
        let largest = of("0.1");
        assert_eq!(largest.is_admissible, Ok(true));
        let Ok(LargestTilt::Limited(figure, mechanism)) = &largest.largest else {
            panic!("{largest:?}")
        };
        let joints = &mechanism.joints;
        assert!(joints.iter().all(|joint| !joint.contact.is_hinge()), "{joints:?}");
        let at = |by: f64| of(&format!("{:.9}", figure.double + by)).is_admissible;
        assert_eq!((at(-1e-8), at(1e-8)), (Ok(true), Ok(false)));
        // A state inside all conditions says so by itself, and there is none beyond the largest.
        let parsed = Arch::parse("heyman", "2.203", "1.838").unwrap();
        let stones = Stones::equal(5, parsed.half_opening().clone()).unwrap();
        let all =
            conditions(&parsed, &stones, &"1.45".parse().unwrap(), &places(&parsed, &stones), 200);
        let inside = |tilt: f64| has_state(&all, &Ball::exact(Float::with_val(200, tilt), 200));
        assert!(inside(figure.double - 1e-6) && !inside(figure.double + 1e-6));
    }

    /// Where the conditions of the largest are dependent, and it stays open, four conditions still exclude an
    /// acceleration beyond it.
    #[test]
    fn an_acceleration_is_excluded_where_the_largest_is_open() {
        let arch = ["heyman", "2pi/3", "inf"];
        let at = |tilt: &str| found(arch, 4, "1", tilt).is_admissible;
        assert_eq!((at("0.7"), at("1"), at("45deg")), (Ok(true), Ok(false), Ok(false)));
        let parsed = Arch::parse("heyman", "2pi/3", "inf").unwrap();
        let stones = Stones::equal(4, parsed.half_opening().clone()).unwrap();
        let all =
            conditions(&parsed, &stones, &"1".parse().unwrap(), &places(&parsed, &stones), 200);
        let tilt = |k: f64| Ball::exact(Float::with_val(200, k), 200);
        assert!(has_none(&all, &tilt(1.0)) && !has_none(&all, &tilt(0.7)));
        let places = against(&in_doubles(&all), 1.0).unwrap();
        let four: Vec<TiltedRow<Ball>> =
            places.iter().map(|place| all[*place].row.clone()).collect();
        // The same four say nothing of an acceleration that is borne, nor do three of them, nor one twice.
        assert!(contradict(&four, &tilt(1.0)) && !contradict(&four, &tilt(0.7)));
        assert!(!contradict(&four[..3], &tilt(1.0)));
        for k in 0..4 {
            let mut forged = four.clone();
            forged[k] = four[(k + 1) % 4].clone();
            assert!(!contradict(&forged, &tilt(1.0)), "{k}");
        }
    }

    /// On either side of the largest.
    #[test]
    fn an_acceleration_is_compared_with_the_largest() {
        let arch = ["milankovitch", "pi/2", "0.4"];
        let largest = value(&found(arch, 11, "0.15", "0"));
        let at = |tilt: f64| found(arch, 11, "0.15", &format!("{tilt:.9}")).is_admissible;
        assert_eq!((at(largest - 1e-8), at(largest + 1e-8)), (Ok(true), Ok(false)));
    }

    /// From the right springing to the left.
    #[test]
    fn what_limits_is_in_order_along_the_arch() {
        let largest = found(["milankovitch", "pi/2", "inf"], 11, "0.15", "0").largest;
        let Ok(LargestTilt::Limited(_, mechanism)) = largest else { panic!("{largest:?}") };
        let angles: Vec<f64> =
            mechanism.joints.iter().map(|joint| joint.angle.mid().to_f64()).collect();
        assert!(angles.len() == 4 && angles.windows(2).all(|two| two[0] > two[1]), "{angles:?}");
    }

    #[test]
    fn a_flat_thick_arch_has_no_limit() {
        let largest = found(["heyman", "0.5", "2"], 6, "0.7", "5").largest;
        assert!(matches!(largest, Ok(LargestTilt::Unlimited)), "{largest:?}");
    }

    /// Conditions that are not those of the limit prove nothing, and nor does a direction that passes one.
    #[test]
    fn forged_conditions_are_refused() {
        let arch = Arch::parse("heyman", "pi/2", "0.6").unwrap();
        let stones = Stones::equal(9, arch.half_opening().clone()).unwrap();
        let all =
            conditions(&arch, &stones, &"0.15".parse().unwrap(), &places(&arch, &stones), 200);
        let StoneTilt::Limited { active, .. } = largest(&in_doubles(&all)) else { panic!() };
        assert!(limited(&all, &active, 0.0, 200).is_ok());
        for k in 0..4 {
            let mut forged = active.clone();
            forged[k] = (0..all.len()).find(|place| !active.contains(place)).unwrap();
            assert!(limited(&all, &forged, 0.0, 200).is_err(), "{k}");
            forged[k] = active[(k + 1) % 4];
            assert!(limited(&all, &forged, 0.0, 200).is_err(), "{k}");
        }
        assert!(limited(&all, &active[..3], 0.0, 200).is_err());
        assert!(unlimited(&all, &[1.0, 1.0, 0.0], 200).is_err());
    }
}
