//! Asymmetric solutions of Eq. (19) on the whole arch, proved.
//!
//! For a half opening, a friction and a weight, with candidates from [`solve`](crate::solve::asymmetric):
//!
//! 1. **The state.** The equations of an [`AsymmetricMode`] have exactly one solution in a box (Krawczyk): joints
//!    are at their limits where the mechanism moves.
//! 2. **Admissible on the whole arch**, at every joint of `[-alpha, alpha]`, as [`check`](crate::check) sees it
//!    too: each of the four margins is positive, but next to a joint that touches its limit, where the margin and
//!    its slope are zero at the root and the curvature is positive, and at the shoulder that slides, where the
//!    margin falls to zero. Margins at the two faces add up to `eta N`, so that `N >= 0` needs no word.
//! 3. **The motion.** The blocks fit by the choice of the rates, and every rate is positive. So each condition of
//!    Eq. (19) holds: `phi <= 0`, `lambda >= 0`, `phi^T lambda = 0`, and compatibility without dilatancy.
//! 4. The power of the weight is that of friction, block by block: not needed, but another route to the same.
//!
//! The mirror image is a solution at the same thickness. A search that finds nothing proves nothing: that there are no
//! others is said where as many are proved as an arch can have at the [most](most_asymmetric).

use super::state::{Certify, Outcome, State};
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode, Place};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::whole::{Side, WholeMotion};
use crate::arch::{Configuration, Ring, SelfWeight};
use crate::check::whole;
use crate::number::{
    Angle, Ball, DoubleBall, DoubleDoubleBall, Enclosure, Engine, ExactNumber, Field, Real,
    Ternary, bits_of,
};
use crate::problem::{Arch, Mode, Problem};
use crate::prover::decide::{ensure, in_few_bits};
use crate::prover::posed::Posed;
use crate::prover::{Figure, Refused, Undecided, raise};
use crate::solve::asymmetric::{AsymmetricCandidate, asymmetric as candidates};
use rug::Float;
use std::collections::BTreeSet;

/// Asymmetric solutions of an arch.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct AsymmetricSolutions {
    /// Solutions that are found, each proved, or the reason why it is not.
    pub found: Vec<Result<AsymmetricDigits, Undecided>>,
    /// True if it is proved that there are no other asymmetric ones.
    pub are_all: bool,
}

/// An asymmetric solution with its digits, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct AsymmetricDigits {
    /// Way in which its mechanism closes.
    pub mode: AsymmetricMode,
    /// `eta`.
    pub thickness: Figure,
    /// `h`.
    pub thrust: Figure,
    /// `p`, the moment of the forces in the crown about the centre.
    pub crown_moment: Figure,
    /// `v`, the part of the weight of the half whose shoulder slides that the other half carries.
    pub vertical_force: Figure,
    /// The joints that give way, from the right springing to the left.
    pub joints: Vec<AsymmetricJoint>,
    /// The power of the weight, and of friction, where the hinge next to the crown turns at the rate one.
    pub power: Figure,
}

/// A joint that gives way.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct AsymmetricJoint {
    /// Limit that it is at, on its side.
    pub contact: Contact,
    /// Side of the crown.
    pub side: Side,
    /// Place of the joint: at the shoulder, or elsewhere.
    pub place: Place,
    /// The angle from the crown, rad.
    pub angle: Figure,
    /// The rotation, or the slip in units of `r`, with the rotation one at the hinge next to the crown.
    pub rate: Figure,
}

/// An asymmetric solution that is proved.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct CertifiedAsymmetric<T = Ball> {
    /// Way in which its mechanism closes.
    pub mode: AsymmetricMode,
    /// Variables of the solution.
    pub at: Asymmetric<T>,
    /// Motion of the solution: every rate is positive.
    pub motion: WholeMotion<T>,
    /// The power of the weight.
    pub power: T,
}

/// Bits beyond those of the digits.
const GUARD: u32 = 64;
/// Bits of what a search in doubles is given.
const SEARCH_BITS: u32 = 64;

/// The asymmetric solutions that the search finds for an arch, to `digits` significant digits. With unlimited friction
/// none is sought. Digits beyond [`MAX_DIGITS`](super::MAX_DIGITS) are refused.
pub fn asymmetric(arch: &Arch, digits: usize) -> Result<AsymmetricSolutions, Refused> {
    Refused::digits(digits)?;
    let found = found(arch).into_iter().map(|candidate| certified(arch, &candidate, digits));
    let found: Vec<Result<AsymmetricDigits, Undecided>> = found.collect();
    // Of two one opens the shoulder, by the claim: what is found twice counts once.
    let opens = |mode: AsymmetricMode| mode == AsymmetricMode::ShoulderOpening;
    let proved = found.iter().filter_map(|of| Some(opens(of.as_ref().ok()?.mode)));
    let count = proved.collect::<BTreeSet<bool>>().len();
    let are_all = count == found.len() && most_asymmetric(arch) == Some(count);
    Ok(AsymmetricSolutions { found, are_all })
}

/// Degrees between which the half openings of asymmetric solutions are, by the claim `asymmetric-number`.
pub const fn asymmetric_half_openings(weight: SelfWeight) -> [i32; 2] {
    match weight {
        SelfWeight::Milankovitch => [125, 141],
        SelfWeight::Heyman => [124, 144],
    }
}

/// The most asymmetric solutions that an arch can have, by the claim `asymmetric-number`: one where the state at the
/// least thickness is `[s,r,r]` and has room to move, and elsewhere none with Milankovitch's weight, two with Heyman's.
/// Where no symmetric state is admissible nothing is (`unique-mean`). `None` with unlimited friction, of which the
/// claim says nothing.
pub fn most_asymmetric(arch: &Arch) -> Option<usize> {
    if !arch.is_limited() {
        return None;
    }
    let half_opening: Ball = arch.half_opening().enclosure(SEARCH_BITS);
    let degree = half_opening.pi() / half_opening.int(180);
    let [low, high] = asymmetric_half_openings(arch.weight())
        .map(|n| degree.clone() * half_opening.int(n) - &half_opening);
    if low.is_positive().is_proved() || (-high).is_positive().is_proved() {
        return Some(0);
    }
    let moves = match arch.state_alone(SEARCH_BITS) {
        Ok(Outcome::Falls(_)) => return Some(0),
        Ok(Outcome::Stands(state)) if state.mode != Mode::SlidingRotational => Ternary::False,
        Ok(Outcome::Stands(state)) => has_room_to_move(&half_opening, &state),
        Err(_) => Ternary::Undecided,
    };
    Some(match (arch.weight(), moves) {
        (SelfWeight::Heyman, Ternary::True) => 1,
        (SelfWeight::Heyman, _) => 2,
        (SelfWeight::Milankovitch, Ternary::False) => 0,
        (SelfWeight::Milankovitch, _) => 1,
    })
}

/// `(1 + eta/2 - (1 - eta/2) cos(beta_r)) |cot(alpha)| > (1 - eta/2) sin(beta_r)` beyond 90°, times `2 sin(alpha)`.
fn has_room_to_move(half_opening: &Ball, state: &State) -> Ternary {
    let [half_opening, haunch] =
        [half_opening, &state.rotation_joint].map(|x| Angle::new(x.clone()));
    let [two, eta] = [state.thickness.int(2), state.thickness.clone()];
    let inner = two.clone() - &eta;
    let above = two + eta - inner.clone() * &haunch.cos;
    (-(above * &half_opening.cos) - inner * &haunch.sin * &half_opening.sin).is_positive()
}

/// The solution of a candidate, proved, to `digits` significant digits.
pub(super) fn certified(
    arch: &Arch,
    candidate: &AsymmetricCandidate,
    digits: usize,
) -> Result<AsymmetricDigits, Undecided> {
    raise(bits_of(digits) + GUARD, |bits| {
        Ok(CertifiedAsymmetric::new(arch, candidate, bits)?.rounded(arch, digits))
    })
}

/// The candidates of an arch.
pub(crate) fn found(arch: &Arch) -> Vec<AsymmetricCandidate> {
    if !arch.is_limited() {
        return Vec::new();
    }
    let grip: Grip<Ball> = arch.friction().grip(SEARCH_BITS);
    let grip = grip.map(|x| x.mid().to_f64());
    let half_opening: Ball = arch.half_opening().enclosure(SEARCH_BITS);
    candidates(arch.weight(), half_opening.mid().to_f64(), &grip)
}

fn rough(x: &Ball) -> DoubleBall {
    DoubleDoubleBall::from(x).into()
}

/// The root next to a candidate, unique in a box.
pub(super) fn root(
    problem: &Problem,
    candidate: &AsymmetricCandidate,
    bits: u32,
) -> Result<Configuration<Ball>, Undecided> {
    let (system, given) = (problem.system(), problem.given(bits));
    let start: Vec<Float> = candidate.unknowns.iter().map(|x| Float::with_val(53, x)).collect();
    Posed { system: &system, given: &given }.root(bits, &start)
}

impl<E: Engine> CertifiedAsymmetric<E> {
    /// The rest of the proof, for variables that enclose a root of the equations; `rough` encloses a number in
    /// doubles.
    pub(super) fn proved(
        problem: &Problem,
        at: &Configuration<E>,
        bits: u32,
        rough: impl Fn(&E) -> DoubleBall,
    ) -> Result<Self, Undecided> {
        let Problem::Asymmetric { mode, arch } = problem else {
            return Err(Undecided::new("what is asked"));
        };
        let (mode, weight) = (*mode, arch.weight());
        in_few_bits(at, bits, |at, bits| {
            let residuals = problem.system().residuals(at);
            let at_limit = residuals.iter().all(|residual| !residual.excludes_zero());
            ensure(at_limit, "whether the joints are at their limits")?;
            if let Some(condition) = problem.first_failure(at, bits) {
                return Err(Undecided::new(condition.label()));
            }
            // Balls of doubles are nearly always enough for margins.
            let rough = Asymmetric::from(&at.map_ref(&rough));
            let open = whole::first_failure::<DoubleBall>(mode, weight, &rough)
                .and_then(|_| whole::first_failure(mode, weight, &Asymmetric::from(at)));
            open.map_or(Ok(()), |contact| Err(Undecided::new(whole::label(contact))))
        })?;
        let at = Asymmetric::from(at);
        let motion = at.motion(mode);
        let power = motion.power(&Ring::new(weight, &at.thickness));
        let balance = power.overlaps(&motion.friction_power(&at.forces));
        ensure(balance, "whether the weight works by as much as friction takes")?;
        Ok(Self { mode, at, motion, power })
    }
}

impl CertifiedAsymmetric {
    /// The solution of a kind that the search finds for an arch, proved in balls of `bits` bits.
    pub fn of(arch: &Arch, mode: AsymmetricMode, bits: u32) -> Result<Self, Undecided> {
        let candidate = found(arch).into_iter().find(|candidate| candidate.mode == mode);
        Self::new(arch, &candidate.ok_or_else(Undecided::no_solution)?, bits)
    }

    /// The proof, in balls of `bits` bits.
    pub(crate) fn new(
        arch: &Arch,
        candidate: &AsymmetricCandidate,
        bits: u32,
    ) -> Result<Self, Undecided> {
        let problem = Problem::Asymmetric { mode: candidate.mode, arch: arch.clone() };
        Self::proved(&problem, &root(&problem, candidate, bits)?, bits, rough)
    }

    /// The digits; `None` if a rounding is not decided.
    fn rounded(&self, arch: &Arch, digits: usize) -> Option<AsymmetricDigits> {
        // What is exact may be a tie, which no ball decides.
        let figure = |x: &Ball| match x.rad().is_zero() {
            true => Figure::exact(&ExactNumber::from(&x.mid().to_rational()?), digits),
            false => Figure::new(x, digits),
        };
        let shoulder = || match arch.half_opening() {
            exact if exact.is_rational() => Figure::exact(exact, digits),
            _ => figure(&self.at.half_opening.rad),
        };
        let joints = self.mode.contacts().iter().zip(&self.motion.0);
        let joints = joints.map(|(&(contact, side, place), joint)| {
            let angle = match place {
                Place::Shoulder => shoulder()?,
                inside => figure(&self.at.angle(inside).rad)?,
            };
            Some(AsymmetricJoint { contact, side, place, angle, rate: figure(&joint.rate)? })
        });
        Some(AsymmetricDigits {
            mode: self.mode,
            thickness: figure(&self.at.thickness)?,
            thrust: figure(&self.at.forces.thrust)?,
            crown_moment: figure(&self.at.forces.moment)?,
            vertical_force: figure(&self.at.forces.vertical)?,
            joints: joints.collect::<Option<_>>()?,
            power: figure(&self.power)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arch(weight: &str, alpha: &str, mu: &str) -> Arch {
        Arch::parse(weight, alpha, mu).unwrap()
    }

    fn solutions(arch: &Arch) -> Vec<AsymmetricDigits> {
        asymmetric(arch, 12).unwrap().found.into_iter().map(|solution| solution.unwrap()).collect()
    }

    fn kinds(arch: &Arch) -> Vec<AsymmetricMode> {
        solutions(arch).iter().map(|solution| solution.mode).collect()
    }

    /// The values of a search by vertices and in high precision, made apart from this one.
    #[test]
    fn known_solutions_are_proved() {
        for (weight, alpha, mu, expected) in [
            ("milankovitch", "2.25", "0.96", "0.544492255244"),
            ("milankovitch", "2.3", "1.05", "0.583084449604"),
            ("milankovitch", "2.3", "1.065", "0.600881398372"),
            ("milankovitch", "2.4", "1.22", "0.613742203273"),
            ("heyman", "2.3", "1.08", "0.641652084484"),
            ("heyman", "2.3", "1.09", "0.652991389316"),
            ("heyman", "2.4", "1.24", "0.667019490867"),
        ] {
            let known = |solution: &AsymmetricDigits| {
                (solution.mode, &solution.thickness.to_string()[..])
                    == (AsymmetricMode::InnerSliding, expected)
            };
            let found = solutions(&arch(weight, alpha, mu));
            assert!(found.iter().any(known), "{weight} {alpha} {mu}");
        }
    }

    /// Every kind occurs with each weight; Heyman's has arches with two of them.
    #[test]
    fn all_three_kinds_occur() {
        use AsymmetricMode::{InnerSliding, ShoulderOpening, ShoulderSliding};
        for (weight, alpha, mu, expected) in [
            ("milankovitch", "2.3", "1.07", &[ShoulderOpening][..]),
            ("milankovitch", "2.25", "0.99", &[ShoulderSliding]),
            ("heyman", "2.3", "1.09", &[ShoulderOpening, InnerSliding]),
            ("heyman", "2.25", "1.01", &[ShoulderSliding]),
        ] {
            assert_eq!(kinds(&arch(weight, alpha, mu)), expected, "{weight} {alpha} {mu}");
        }
        for (alpha, mu) in [("pi/2", "0.35"), ("pi/2", "inf"), ("2.15", "0.8"), ("2.5", "2")] {
            assert!(kinds(&arch("heyman", alpha, mu)).is_empty(), "{alpha} {mu}");
        }
    }

    /// Where as many are found as there can be, there are no others; next to the lines, and without a limit of
    /// friction, nothing is said.
    #[test]
    fn no_others_are_where_as_many_are_found_as_there_can_be() {
        for (weight, alpha, mu, most, are_all) in [
            ("milankovitch", "2.3", "1.05", Some(1), true),
            ("milankovitch", "2.3", "1.2", Some(0), true),
            ("milankovitch", "pi/2", "0.35", Some(0), true),
            // With a pure state.
            ("milankovitch", "2.225", "0.938", Some(0), true),
            // Outside the table, which the claim does not know.
            ("heyman", "2.3", "1.2", Some(2), false),
            ("heyman", "2.3", "1.09", Some(2), true),
            ("heyman", "2.25", "1.01", Some(1), true),
            ("heyman", "2.3", "1.05", Some(1), true),
            ("heyman", "2.31", "1.108", Some(2), false),
            ("heyman", "2.6", "3", Some(0), true),
            ("heyman", "2.3", "inf", None, false),
        ] {
            let arch = arch(weight, alpha, mu);
            let told = (most_asymmetric(&arch), asymmetric(&arch, 12).unwrap().are_all);
            assert_eq!(told, (most, are_all), "{weight} {alpha} {mu}");
        }
    }

    /// Friction as an angle is the same friction.
    #[test]
    fn a_friction_angle_is_a_friction() {
        let by_angle = solutions(&arch("heyman", "2.4", "tan(51.115deg)"));
        assert_eq!(by_angle.len(), 1);
        let mu = "1.24";
        let near = solutions(&arch("heyman", "2.4", mu));
        let gap = by_angle[0].thickness.double - near[0].thickness.double;
        assert!(gap.abs() < 1e-3 && gap != 0.0);
    }

    fn certified(alpha: &str, mu: &str) -> CertifiedAsymmetric {
        let arch = arch("milankovitch", alpha, mu);
        CertifiedAsymmetric::new(&arch, &found(&arch)[0], 128).unwrap()
    }

    /// The proof refuses what is not a solution: a contact moved, a rate turned, a friction or a thickness that is
    /// another.
    #[test]
    fn false_twins_are_refused() {
        let arch = arch("milankovitch", "2.3", "1.05");
        let candidate = &found(&arch)[0];
        let problem = Problem::Asymmetric { mode: candidate.mode, arch };
        let at = root(&problem, candidate, 128).unwrap();
        let like = at.thickness.clone();
        let small = like.ratio(1, 1000);
        let reason = |at: &Configuration<Ball>| {
            let proved = CertifiedAsymmetric::proved(&problem, at, 128, rough);
            proved.err().map(|open| open.reason.to_string())
        };
        assert_eq!(reason(&at), None);
        let refused = |spoil: &dyn Fn(&mut Configuration<Ball>)| {
            let mut twin = at.clone();
            spoil(&mut twin);
            let reason = reason(&twin).unwrap_or_default();
            assert!(reason.contains("at their limits"), "{reason}");
        };
        let moved = |angle: &Angle<Ball>, by: &Ball| Angle::new(angle.rad.clone() + by);
        let tenth = like.ratio(1, 10);
        refused(&|at| at.rotation_joint = moved(&at.rotation_joint, &tenth));
        refused(&|at| at.crown_hinge = moved(&at.crown_hinge, &tenth));
        refused(&|at| at.friction = at.friction.clone() - &small);
        refused(&|at| at.thickness = at.thickness.clone() - &small);
        refused(&|at| at.vertical_force = at.vertical_force.clone() + &small);
        refused(&|at| at.sliding_joint = moved(&at.rotation_joint, &small));
    }

    /// Where the third kind holds, the equations of the first have a root too, whose inner joint would have to
    /// slide outwards.
    #[test]
    fn a_rate_with_the_wrong_sign_is_refused() {
        let arch = arch("milankovitch", "2.25", "0.99");
        let third = &found(&arch)[0];
        assert_eq!(third.mode, AsymmetricMode::ShoulderSliding);
        let joint = third.unknowns[0].sqrt().acos() - 0.99f64.atan();
        let unknowns = third.unknowns.iter().copied().chain([joint]).collect();
        let first = AsymmetricCandidate { mode: AsymmetricMode::InnerSliding, unknowns };
        let refused = CertifiedAsymmetric::new(&arch, &first, 128).unwrap_err();
        assert_eq!(refused.reason, "an inner joint that slides inwards");
    }

    /// Block by block, the weight works by as much as friction takes; not if a joint slides the other way.
    #[test]
    fn the_weight_works_by_as_much_as_friction_takes() {
        for (alpha, mu) in [("2.3", "1.05"), ("2.3", "1.07"), ("2.25", "0.99")] {
            let CertifiedAsymmetric { at, motion, power, .. } = certified(alpha, mu);
            let gap = power.clone() - motion.friction_power(&at.forces);
            assert!(gap.rad().to_float() < 1e-30 && !gap.excludes_zero(), "{alpha} {mu}");
            for place in [0, 2] {
                let mut twin = motion.clone();
                twin.0[place].rate = -twin.0[place].rate.clone();
                let gap = power.clone() - twin.friction_power(&at.forces);
                let slides = !twin.0[place].contact.is_hinge();
                assert_eq!(gap.excludes_zero(), slides, "{alpha} {mu} {place}");
            }
        }
        let known = &solutions(&arch("milankovitch", "2.3", "1.05"))[0];
        assert_eq!(known.power.to_string(), "2.26695671354");
    }

    /// The thickness at which the two hinges fit between the faces, at a vertical force, found by halving in
    /// doubles: no derivative, no Newton, the joints by looking at many.
    fn thickness_by_halving(heyman: bool, alpha: f64, mu: f64, v: f64) -> f64 {
        let h = (alpha - v) / (alpha - mu.atan()).tan();
        let room = |eta: f64| {
            let fac = 1.0 + if heyman { 0.0 } else { eta * eta / 12.0 };
            let moment = |radius: f64, b: f64| {
                radius * (h * b.cos() + (b - v) * b.sin()) - fac * (1.0 - b.cos())
            };
            let joints = (-6000..=6000).map(|k| alpha * f64::from(k) / 6000.0);
            let near = joints.clone().filter(|b| b.abs() < 0.5);
            let most = near.map(|b| moment(1.0 + eta / 2.0, b)).fold(f64::MAX, f64::min);
            most - joints.map(|b| moment(1.0 - eta / 2.0, b)).fold(f64::MIN, f64::max)
        };
        let (mut low, mut high) = (0.0, 2.0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if room(middle) < 0.0 { low = middle } else { high = middle }
        }
        low
    }

    /// The thickness follows from the vertical force by a search that knows no derivative.
    #[test]
    fn another_route_leads_to_the_same_thickness() {
        for (weight, alpha, mu) in
            [("milankovitch", 2.3, 1.05), ("heyman", 2.3, 1.09), ("heyman", 2.25, 1.01)]
        {
            for found in solutions(&arch(weight, &alpha.to_string(), &mu.to_string())) {
                let v = found.vertical_force.double;
                let other = thickness_by_halving(weight == "heyman", alpha, mu, v);
                approx::assert_abs_diff_eq!(found.thickness.double, other, epsilon = 1e-6);
            }
        }
    }
}
