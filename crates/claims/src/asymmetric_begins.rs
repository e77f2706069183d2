//! Half openings at which the symmetric state at an edge of `[s,r,r]` has an asymmetric mechanism too: from a
//! half opening on, up to T.
//!
//! There the curves of asymmetric solutions leave the symmetric ones: with `b0 = v = 0` the equations of the first
//! kind are those of the line between `[s,r,r]` and `[s,s]`, those of the second that between `[r,r,r]` and
//! `[s,r,r]`.

use super::along::landmark;
use super::asymmetric::variables;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::SelfWeight;
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode};
use crate::arch::joint::Grip;
use crate::arch::whole::Forces;
use crate::certify::{Undecided, between};
use crate::number::{Angle, DoubleBall, Enclosure, Field, Real, Stumpff};
use crate::problem::Landmark;
use crate::prover::halve::{halve, halves};
use crate::prover::in_doubles::root_of_many;
use crate::prover::root::Form;
use rug::Rational;
use std::sync::OnceLock;

claims! {
    Ours("asymmetric-begins", "Eq. (19)", begins):
        "the equations of the line where [s,r,r] meets [s,s] have a symmetric solution with an asymmetric mechanism \
         of the first kind at each alpha from near 126.21° (Milankovitch) or 125.63° (Heyman) on up to T, and one \
         without at each from 90° on before; those of the line where [r,r,r] meets [s,r,r] one of the second kind \
         from 128.73° on up to T, and one without before";
}

/// The symmetric states of an edge of `[s,r,r]`, by their half opening.
#[derive(Clone, Copy, Debug)]
struct EdgeOfStates {
    weight: SelfWeight,
    /// Mode of the edge: with a joint that slides inside, `[s,s]`, or with a shoulder that opens, `[r,r,r]`.
    mode: AsymmetricMode,
    /// Hundredths of a degree between which the mechanism begins to exist.
    begins: [i32; 2],
}

const EDGES: [EdgeOfStates; 4] = {
    use AsymmetricMode::{InnerSliding, ShoulderOpening};
    use SelfWeight::{Heyman, Milankovitch};
    [
        EdgeOfStates { weight: Milankovitch, mode: InnerSliding, begins: [12_621, 12_622] },
        EdgeOfStates { weight: Heyman, mode: InnerSliding, begins: [12_562, 12_563] },
        EdgeOfStates { weight: Milankovitch, mode: ShoulderOpening, begins: [12_872, 12_873] },
        EdgeOfStates { weight: Heyman, mode: ShoulderOpening, begins: [12_872, 12_873] },
    ]
};

/// A range is halved so often at the most.
const DEPTH: u32 = 16;

/// The equations of an edge, for all half openings of a ball: `h, p, eta, beta_r + h`, the friction, and `beta_s`
/// with the first kind. At `sb` the joint `beta_r` alone turns back, and a box that is as narrow as it moves has no
/// room for the rest.
struct BeginEquations {
    edge: EdgeOfStates,
    half_opening: DoubleBall,
}

impl Form<DoubleBall> for BeginEquations {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&DoubleBall) -> T, x: &[T]) -> Vec<T> {
        let EdgeOfStates { weight, mode, .. } = self.edge;
        let at = self.edge.at(&number(&self.half_opening), x);
        at.map_or_else(Vec::new, |at| {
            // The slope at the crown is that of a symmetric state: it is zero.
            let common = at.common(weight).into_iter().enumerate().filter(|(k, _)| *k != 1);
            common.map(|(_, residual)| residual).chain(at.closing(mode, weight)).collect()
        })
    }

    /// Nothing is divided by but integers.
    fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&DoubleBall) -> T, _: &[T]) -> bool {
        true
    }
}

impl EdgeOfStates {
    fn at<T: Real>(self, half_opening: &T, x: &[T]) -> Option<Asymmetric<T>> {
        let [thrust, moment, thickness, lower, friction, rest @ ..] = x else { return None };
        let zero = Angle::zero(thrust);
        Some(Asymmetric {
            half_opening: Angle::new(half_opening.clone()),
            grip: Grip { shear: thrust.int(1), normal: friction.clone() },
            thickness: thickness.clone(),
            forces: Forces {
                thrust: thrust.clone(),
                moment: moment.clone(),
                vertical: thrust.int(0),
            },
            crown_hinge: zero.clone(),
            haunch: Angle::new(lower.clone() - thrust),
            sliding_joint: rest.first().map_or(zero, |joint| Angle::new(joint.clone())),
        })
    }

    /// The unknowns at T, where the edge ends, and its half opening in degrees, rounded up.
    fn end(self) -> Checked<(Vec<f64>, Rational)> {
        let at = landmark(Landmark::Triple, self.weight)?;
        let moment =
            at.thrust.clone() * (at.thickness.clone() / at.thrust.int(2) + at.thrust.int(1));
        let lower = at.rotation_joint.rad + &at.thrust;
        let mut unknowns = vec![at.thrust, moment, at.thickness, lower, at.friction];
        if self.mode == AsymmetricMode::InnerSliding {
            unknowns.push(at.sliding_joint.rad);
        }
        let degrees = at.half_opening.rad.clone() * at.half_opening.rad.int(18_000)
            / at.half_opening.rad.pi();
        let hundredths = degrees.upper().ceil().to_integer().and_then(|n| n.to_i32());
        let hundredths = hundredths.ok_or_else(|| Undecided::new("an unbounded landmark"))?;
        let unknowns = unknowns.iter().map(|x| x.mid().to_f64()).collect();
        Ok((unknowns, Rational::from((hundredths, 100))))
    }

    /// Tells whether the mechanism exists (or not) at every half opening between two, in degrees; `start` are
    /// the unknowns next to the larger one, and next to the smaller one in the end.
    fn is_so(self, exists: bool, [low, high]: [Rational; 2], start: &mut Vec<f64>) -> Checked {
        let upper_first = |piece: &_| halves(piece).map(|[lower, upper]| [upper, lower]);
        let proof = |(low, high): &(Rational, Rational)| {
            self.tells(exists, [low, high], start).map(|centre| *start = centre)
        };
        halve((low, high), DEPTH, upper_first, proof).map(drop)
    }

    /// Tells whether the mechanism exists (or not) on a piece, without halving it.
    fn tells(self, exists: bool, [low, high]: [&Rational; 2], start: &[f64]) -> Checked<Vec<f64>> {
        let degrees = DoubleBall::from(&between(low, high));
        let half_opening = degrees.pi() * degrees / degrees.int(180);
        let equations = BeginEquations { edge: self, half_opening };
        let root = root_of_many(&equations, start)?;
        let at = self.at(&equations.half_opening, &root);
        let at = at.ok_or_else(|| Undecided::new("the number of unknowns"))?;
        let motion = at.motion(self.mode);
        let is_decided = match exists {
            true => motion.0.iter().all(|joint| joint.rate.is_positive().is_proved()),
            false => motion.0.iter().any(|joint| (-joint.rate).is_positive().is_proved()),
        };
        let centre = || root.iter().map(DoubleBall::mid).collect();
        is_decided.then(centre).ok_or_else(|| Undecided::new("the sign of a rate"))
    }

    /// Proves that the mechanism begins where it is said to, from 90° on up to T.
    fn proved(self) -> Checked {
        let (mut start, end) = self.end()?;
        let [fails, holds] = self.begins.map(|hundredths| Rational::from((hundredths, 100)));
        self.is_so(true, [holds, end], &mut start)?;
        self.is_so(false, [Rational::from(90), fails], &mut start)
    }
}

/// Results of deciding whether each edge is as said, decided once.
fn decided() -> &'static [Checked] {
    static DECIDED: OnceLock<Vec<Checked>> = OnceLock::new();
    DECIDED.get_or_init(|| EDGES.iter().map(|edge| edge.proved()).collect())
}

fn begins(d: &mut Derivation) -> Checked {
    lemmas(d, ["asymmetric-motion"])?;
    for (edge, decided) in EDGES.iter().zip(decided()) {
        let EdgeOfStates { weight, mode, begins } = edge;
        let [fails, holds] = begins.map(|n| format!("{}.{:02}", n / 100, n % 100));
        let words = format!(
            "{weight}, {}: at each alpha from 90° to {fails}° a solution has a negative rate, and at each from {holds}° to \
             T one has positive rates",
            mode.name()
        );
        // A hundredth of a degree further it begins no more.
        let late = EdgeOfStates { begins: begins.map(|hundredths| hundredths + 1), ..*edge };
        d.known(words, decided, late, EdgeOfStates::proved)?;
    }
    let edge = EdgeOfStates { weight: SelfWeight::Heyman, ..EDGES[0] };
    let at = variables();
    let (alpha, joint, eta) = (&at.half_opening, &at.haunch, &at.thickness);
    let forces = Forces { vertical: eta.int(0), ..at.forces.clone() };
    let symmetric = Asymmetric { forces, crown_hinge: Angle::zero(eta), ..at.clone() };
    let misfit = symmetric.closing(AsymmetricMode::ShoulderSliding, edge.weight).swap_remove(0);
    let two = eta.int(2);
    let inner = (two.clone() - eta) * &joint.cos;
    let up = two.clone() + eta - &inner;
    let expected = -(up * &alpha.cos + (two - eta) * &joint.sin * &alpha.sin);
    let words = "at a symmetric state, twice sin(alpha + beta_s) times the slip of the inner joint";
    d.identity(words, &misfit, &expected)?;
    d.conclude(
        "The solutions are sought one from the next, from T on; that they are one curve, which is admissible, is not \
         proved here. The first bracket is positive, as the arm above the haunch is. So nothing of the kind exists \
         where cos(alpha) >= 0, and the condition is up |cot(alpha)| > (1 - eta/2) sin(beta_r), with up the height of \
         the crown's extrados above the intrados of the haunch.",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hundredth of a degree further in either direction the claim is false, and is not proved.
    #[test]
    fn another_half_opening_is_refused() {
        let [edge, .., last] = EDGES;
        for edge in [edge, last] {
            let [fails, holds] = edge.begins;
            let (mut start, end) = edge.end().unwrap();
            let ends = [fails - 1, fails].map(|n| Rational::from((n, 100)));
            edge.is_so(true, [Rational::from((holds, 100)), end], &mut start).unwrap();
            assert!(edge.is_so(true, ends.clone(), &mut start.clone()).is_err(), "{edge:?}");
            assert!(edge.is_so(false, ends, &mut start.clone()).is_ok(), "{edge:?}");
            let above = [holds, holds + 1].map(|n| Rational::from((n, 100)));
            assert!(edge.is_so(false, above, &mut start.clone()).is_err(), "{edge:?}");
        }
    }
}
