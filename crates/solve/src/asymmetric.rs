//! Candidates of asymmetric solutions of Eq. (19), in doubles.
//!
//! The states whose right shoulder slides and whose line of thrust touches the extrados near the crown and the
//! intrados at the left haunch are a curve, one for each vertical force `v` in the crown; at `v = 0` it is the
//! symmetric state of shoulder sliding, admissible or not. Newton's method follows it to larger `v`. Where one of
//! the three closing conditions changes its sign along the curve, the system of that [`AsymmetricMode`] is solved;
//! what has a rate or, at one of some joints, a margin below zero is left out.
//!
//! **Nothing is proved, and nothing says that these are all.**

use super::newton_step;
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::whole::margin;
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, Dual};

/// A solution that seems to be one.
#[derive(Clone, Debug)]
pub struct AsymmetricCandidate {
    /// Way in which its mechanism closes.
    pub mode: AsymmetricMode,
    /// `h, p, v, eta, b0, b1` and, where an inner joint slides, `b2`.
    pub unknowns: Vec<f64>,
}

/// The curve is followed in steps of this part of the half opening.
const STEP: f64 = 1.0 / 128.0;
/// Part of the half opening up to which a branch is followed, by its vertical force: solutions of all half
/// openings and frictions between which they are known have at most 0.073 of it (`couplet complementarity
/// --branch`).
const LARGEST: f64 = 1.0 / 8.0;
/// Newton's method takes fewer steps from a neighbour.
const NEWTON_STEPS: usize = 20;
/// A step that is this short beside the unknowns is the last one.
const SHORT: f64 = 1e-13;
/// Tolerance on the way, where the error that is left is about its square.
const ROUGH: f64 = 1e-6;
/// Joints of half an arch at which the margins of a candidate are looked at.
const JOINTS: i32 = 64;
/// A margin that is rounding.
const ROUNDING: f64 = 1e-9;

/// Candidates of an arch, by their thickness from the curve's beginning; none where friction is unlimited.
pub fn asymmetric(
    weight: SelfWeight,
    half_opening: f64,
    grip: &Grip<f64>,
) -> Vec<AsymmetricCandidate> {
    let search = CurveSearch { weight, half_opening, grip };
    let mut found = Vec::new();
    let mut last: Option<(Vec<f64>, [f64; 3])> = None;
    for unknowns in search.curve() {
        let Some(closing) = search.closing(&unknowns) else { break };
        if let Some((before, old)) = &last {
            let kinds = AsymmetricMode::ALL.into_iter().enumerate();
            let crossed = kinds.filter(|(k, _)| old[*k] * closing[*k] <= 0.0);
            found.extend(crossed.filter_map(|(k, mode)| {
                let part = old[k] / (old[k] - closing[k]);
                let between = before.iter().zip(&unknowns).map(|(a, b)| a + part * (b - a));
                search.solved(mode, between.collect())
            }));
        }
        last = Some((unknowns, closing));
    }
    found.retain(|candidate| search.seems_admissible(candidate));
    found
}

struct CurveSearch<'a> {
    weight: SelfWeight,
    half_opening: f64,
    grip: &'a Grip<f64>,
}

impl CurveSearch<'_> {
    /// The states of the curve, `h, p, v, eta, b0, b1`, as far as the thickness is physical and solutions are
    /// known.
    fn curve(&self) -> impl Iterator<Item = Vec<f64>> {
        let step = STEP * self.half_opening;
        let next = move |(before, last): &(Vec<f64>, Vec<f64>)| {
            // From where the last two point to.
            let near = last.iter().zip(before).map(|(last, before)| 2.0 * last - before);
            let vertical = last[2] + step;
            let state = self.with_vertical(&near.collect::<Vec<_>>(), vertical)?;
            let [h, _, _, eta, _, haunch] = state[..] else { return None };
            let is_physical = h > 0.0 && eta > 0.0 && eta < 2.0 && haunch < self.half_opening;
            let is_near = vertical <= LARGEST * self.half_opening;
            (is_physical && is_near).then(|| (last.clone(), state))
        };
        // A kind may close next to it.
        let first = self.symmetric().and_then(|near| self.with_vertical(&near, 0.0));
        let first = first.map(|state| (state.clone(), state));
        std::iter::successors(first, next).map(|(_, state)| state)
    }

    /// The state of the curve with a vertical force, next to another.
    fn with_vertical(&self, near: &[f64], vertical: f64) -> Option<Vec<f64>> {
        let [h, p, _, eta, crown, haunch] = *near else { return None };
        let state = self.settled(vec![h, p, eta, crown, haunch], ROUGH, |x| {
            let [h, p, eta, crown, haunch] = x else { return Vec::new() };
            let v = Dual::constant(vertical);
            let x = [h, p, &v, eta, crown, haunch].map(Clone::clone);
            self.at(&x).map_or_else(Vec::new, |at| at.common(self.weight))
        })?;
        let [h, p, eta, crown, haunch] = state[..] else { return None };
        Some(vec![h, p, vertical, eta, crown, haunch])
    }

    fn at(&self, x: &[Dual<f64>]) -> Option<Asymmetric<Dual<f64>>> {
        let grip = self.grip.clone().map(Dual::constant);
        Asymmetric::from_unknowns(&Dual::constant(self.half_opening), grip, x)
    }

    /// A state next to that whose both shoulders slide: the thrust is that of the shoulder, and the thickness the
    /// largest of those at which a line of thrust from the crown's extrados is on the intrados of one of some
    /// joints.
    fn symmetric(&self) -> Option<Vec<f64>> {
        let (sin, cos) = self.half_opening.sin_cos();
        let Grip { shear, normal } = self.grip;
        // (17): h = alpha cot(alpha - phi).
        let h = self.half_opening * (shear * cos + normal * sin) / (shear * sin - normal * cos);
        let thickness = |joint: f64| {
            let (sin, cos) = joint.sin_cos();
            let (weight, normal) = (1.0 - cos, h * cos + joint * sin);
            // (1 + eta/2) h + fac (1 - cos) = (1 - eta/2) N
            let (square, linear) =
                (f64::from(self.weight.flag()) * weight / 12.0, (h + normal) / 2.0);
            let constant = h + weight - normal;
            -2.0 * constant / (linear + (linear * linear - 4.0 * square * constant).max(0.0).sqrt())
        };
        let joints = (1..JOINTS).map(|k| self.half_opening * f64::from(k) / f64::from(JOINTS));
        let haunch = joints.max_by(|a, b| thickness(*a).total_cmp(&thickness(*b)))?;
        let eta = thickness(haunch);
        let is_physical = h > 0.0 && h < 1.0 && eta > 0.0 && eta < 2.0;
        is_physical.then(|| vec![h, (1.0 + eta / 2.0) * h, 0.0, eta, 0.0, haunch])
    }

    /// Conditions that are zero where a kind of mechanism closes, by kinds.
    fn closing(&self, unknowns: &[f64]) -> Option<[f64; 3]> {
        let grip = self.grip.clone();
        let at = Asymmetric::from_unknowns(&self.half_opening, grip, unknowns)?;
        let of = |mode| at.closing(mode, self.weight).first().copied();
        let [h, _, v, ..] = unknowns else { return None };
        let inner = v - self.sliding_joint(*h).1;
        Some([inner, of(AsymmetricMode::ShoulderOpening)?, of(AsymmetricMode::ShoulderSliding)?])
    }

    /// Joint where the forces of the left half are steepest, and the vertical force at which they slide
    /// there, for a thrust: `h = cos² chi`, `b2 = chi - phi`, `b2 + v = sin chi cos chi`.
    fn sliding_joint(&self, thrust: f64) -> (f64, f64) {
        let phi = self.grip.normal.atan2(self.grip.shear);
        let joint = thrust.sqrt().acos() - phi;
        (joint, (thrust * (1.0 - thrust)).sqrt() - joint)
    }

    /// The root of a kind's system next to a state of the curve.
    fn solved(&self, mode: AsymmetricMode, mut near: Vec<f64>) -> Option<AsymmetricCandidate> {
        if mode == AsymmetricMode::InnerSliding {
            near.push(self.sliding_joint(*near.first()?).0);
        }
        let unknowns = self.settled(near, SHORT, |x| {
            self.at(x).map_or_else(Vec::new, |at| at.residuals(mode, self.weight))
        })?;
        Some(AsymmetricCandidate { mode, unknowns })
    }

    /// Newton's method, up to a step that is `short`; `None` where it does not settle.
    fn settled(
        &self,
        mut x: Vec<f64>,
        short: f64,
        residuals: impl Fn(&[Dual<f64>]) -> Vec<Dual<f64>>,
    ) -> Option<Vec<f64>> {
        for _ in 0..NEWTON_STEPS {
            let steps = newton_step(&residuals(&Dual::variables(&x)))?;
            let size = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            x.iter_mut().zip(&steps).for_each(|(x, step)| *x -= step);
            if size(&steps).is_nan() || size(&x) > 10.0 {
                return None;
            }
            if size(&steps) < short * size(&x).max(1.0) {
                return Some(x);
            }
        }
        None
    }

    /// Tells whether all unknowns and rates are positive, and no margin is below zero at some joints.
    fn seems_admissible(&self, candidate: &AsymmetricCandidate) -> bool {
        let AsymmetricCandidate { mode, unknowns } = candidate;
        let grip = self.grip.clone();
        let Some(at) = Asymmetric::from_unknowns(&self.half_opening, grip, unknowns) else {
            return false;
        };
        let ring = Ring::new(self.weight, &at.thickness);
        let holds = |joint: f64| {
            let joint = Angle::new(joint);
            let margin = |contact| margin(contact, &joint, &ring, self.grip, &at.forces);
            Contact::ALL.into_iter().all(|contact| margin(contact) > -ROUNDING)
        };
        let mut joints =
            (-JOINTS..=JOINTS).map(|k| self.half_opening * f64::from(k) / f64::from(JOINTS));
        let is_positive = |x: &f64| *x > 0.0;
        unknowns.iter().all(is_positive)
            && at.thickness <= 2.0
            && at.motion(*mode).0.iter().all(|joint| is_positive(&joint.rate))
            && joints.all(holds)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(weight: SelfWeight, alpha: f64, mu: f64) -> Vec<AsymmetricCandidate> {
        asymmetric(weight, alpha, &Grip { shear: 1.0, normal: mu })
    }

    #[test]
    fn a_horseshoe_has_a_candidate_and_a_semicircle_none() {
        let all = found(SelfWeight::Milankovitch, 2.3, 1.05);
        assert_eq!(all.len(), 1, "{all:?}");
        assert_eq!(all[0].mode, AsymmetricMode::InnerSliding);
        approx::assert_relative_eq!(all[0].unknowns[3], 0.583_084_449_604_488_6, epsilon = 1e-12);
        for (alpha, mu) in [(1.57, 0.35), (1.57, 0.6), (1.0, 0.3), (2.6, 3.0)] {
            assert!(found(SelfWeight::Heyman, alpha, mu).is_empty(), "{alpha} {mu}");
        }
    }

    /// A mechanism before the first step; with a little more friction there is none.
    #[test]
    fn a_kind_next_to_the_symmetric_state_is_found() {
        let all = found(SelfWeight::Heyman, 2.233, 0.968);
        let kinds: Vec<_> = all.iter().map(|candidate| candidate.mode).collect();
        assert_eq!(kinds, [AsymmetricMode::ShoulderSliding]);
        approx::assert_abs_diff_eq!(all[0].unknowns[2], 0.010_265, epsilon = 1e-4);
        assert!(found(SelfWeight::Heyman, 2.233, 0.971).is_empty());
    }

    #[test]
    fn unlimited_friction_has_none() {
        let grip = Grip { shear: 0.0, normal: 1.0 };
        assert!(asymmetric(SelfWeight::Heyman, 2.3, &grip).is_empty());
    }
}
