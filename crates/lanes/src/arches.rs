//! Arches of a weight, answered many at a time: the door.

use super::answer::{FromFriction, LaneAnswer, LaneFrictions, LaneRoots};
use super::asked::{Asked, LaneArch};
use super::asking::{Asking, double, is_below, overturning_at};
use super::crown::Crown;
use super::rotation::{Rotating, rotating};
use super::sliding::{Sliding, Steepest, Tangent};
use super::start;
use super::touching::{Above, Below};
use super::width::Width;
use crate::arch::SelfWeight;
use crate::number::DoubleDoubleBall;

/// Lanes for the arches of a weight.
#[derive(Clone, Copy, Debug)]
pub struct Lanes {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Number of arches that go through a proof at a time.
    pub width: Width,
}

impl Lanes {
    /// The widest lanes that this processor has.
    pub fn of(weight: SelfWeight) -> Self {
        Self { weight, width: Width::widest() }
    }

    /// Answers to arches, in their order; `None` where nothing is proved. Rows of one half opening that follow each
    /// other share its proof. Any number may be asked: what makes no sense has no answer.
    ///
    /// ```
    /// use couplet_check::arch::SelfWeight;
    /// use couplet_lanes::{LaneAnswer, Lanes};
    /// use couplet_number::number::{DoubleDouble, DoubleDoubleBall};
    /// let number = |x| DoubleDoubleBall::exact(DoubleDouble::exact(x));
    /// let arches = [(1.5, 0.5), (1.5, 0.01), (-1.0, 0.5)];
    /// let arches = arches.map(|(alpha, mu)| (number(alpha), Some(number(mu))));
    /// let answers = Lanes::of(SelfWeight::Heyman).states(&arches);
    /// let [Some(LaneAnswer::Stands(state)), Some(LaneAnswer::Falls), None] = answers[..] else { panic!() };
    /// assert_eq!(state.thickness.nearest_double(), Some(0.090140690267333675));
    /// ```
    pub fn states(self, arches: &[LaneArch]) -> Vec<Option<LaneAnswer>> {
        Asked::answers((self.width, self.weight), arches)
    }

    /// Tangents of angles between zero and a right angle, rad.
    pub fn tangents(self, angles: &[[DoubleDoubleBall; 1]]) -> Vec<Option<[DoubleDoubleBall; 1]>> {
        self.width.prove(&Tangent, angles)
    }

    /// Roots that bound the thrusts of arches with thicknesses, in their order: with those that a required friction is
    /// found from, and those by which friction bounds the thrusts, as they are wanted.
    pub fn roots(
        self,
        arches: &[(LaneArch, DoubleDoubleBall)],
        [wants_friction, wants_thrusts]: [bool; 2],
    ) -> Vec<LaneRoots> {
        let Self { weight, width } = self;
        let mut all = vec![LaneRoots::default(); arches.len()];
        let (mut least, mut largest) = (Asking::default(), Asking::default());
        let (mut sliding, mut steepest) = (Asking::default(), Asking::default());
        let below = Below { weight, table: start::below(weight) };
        for (row, ((alpha, friction), eta)) in arches.iter().enumerate() {
            least.push(row, [*eta]);
            if wants_friction {
                sliding.push(row, [*alpha]);
            }
            if let Some(mu) = friction.filter(|_| wants_thrusts) {
                steepest.push(row, [mu]);
            }
            if below.square([double(alpha), double(eta)]) > 0.0 {
                largest.push(row, [*alpha, *eta]);
            }
        }
        let above = || Above { weight, table: start::above(weight) };
        least.each(width, above, |row, _, found| all[row].least = Some(found));
        largest.each(width, || below, |row, _, found| all[row].largest = Some(found));
        let proof = || Sliding(start::sliding());
        sliding.each(width, proof, |row, _, found| all[row].sliding = Some(found));
        let proof = || Steepest(start::steepest());
        steepest.each(width, proof, |row, _, found| all[row].steepest = Some(found));
        all
    }

    /// The frictions at which the mode changes, of some half openings, rad.
    pub fn frictions(self, half_openings: &[DoubleDoubleBall]) -> Vec<LaneFrictions> {
        let Self { weight, width } = self;
        let rows: Vec<_> = half_openings.iter().map(|alpha| [*alpha]).collect();
        let larger = |[.., at_shoulder, inside]: Rotating| match (
            is_below(&at_shoulder, &inside),
            is_below(&inside, &at_shoulder),
        ) {
            (true, _) => Some(FromFriction::From(inside)),
            (_, true) => Some(FromFriction::From(at_shoulder)),
            (false, false) => None,
        };
        let rotating = rotating::<true>((width, weight), &rows).into_iter();
        let sliding = width.prove(&Sliding(start::sliding()), &rows).into_iter();
        let both = rotating.zip(sliding).map(|(rotating, sliding)| LaneFrictions {
            sliding: sliding.map(|[friction, _]| friction),
            rotational: rotating.and_then(larger),
        });
        let mut all: Vec<LaneFrictions> = both.collect();
        // Where arches overturn at unlimited friction they never rotate.
        let mut overturning = Asking::default();
        for (row, alpha) in half_openings.iter().enumerate() {
            if all[row].rotational.is_none() && double(alpha) > start::rotates(weight)[1] {
                overturning.push(row, overturning_at(*alpha));
            }
        }
        let proof = || Crown { weight, is_limited: false };
        overturning.each(width, proof, |row, _, [..]| {
            all[row].rotational = Some(FromFriction::Never);
        });
        all
    }
}

#[cfg(test)]
mod tests {
    use super::super::asking::{double, zero};
    use super::*;
    use crate::number::{DoubleDouble, Enclosure};
    use crate::problem::Mode;

    fn number(x: f64) -> DoubleDoubleBall {
        DoubleDoubleBall::exact(DoubleDouble::exact(x))
    }

    /// Arches of every mode, in no order; among them what makes no sense.
    fn arches(count: usize) -> Vec<LaneArch> {
        let part = |k: usize, step: f64| ((k + 1) as f64 * step).fract();
        let arch = |k: usize| {
            let (x, y) = (part(k, 0.754_877_666), part(k, 0.569_840_291));
            let (alpha, mu) = match k % 2 {
                0 => (2.8 * x, 4.0 * y),
                _ => (2.4 + 0.4 * x, 1.0 + 3.0 * y),
            };
            (number(alpha), (mu < 3.8).then(|| number(mu)))
        };
        let odd = [f64::NAN, f64::INFINITY, -1.0, 0.0, -0.0, 1e300, 3.2, f64::NEG_INFINITY];
        let odd = odd.into_iter().flat_map(|x| {
            [(number(x), Some(number(1.0))), (number(x), None), (number(2.5), Some(number(x)))]
        });
        (0..count).map(arch).chain(odd).collect()
    }

    fn bits(answer: &Option<LaneAnswer>) -> Option<(Option<Mode>, Vec<[u64; 3]>)> {
        match answer.as_ref()? {
            LaneAnswer::Falls => Some((None, Vec::new())),
            LaneAnswer::Stands(state) => {
                let all =
                    [state.thickness, state.thrust, state.intrinsic_thrust, state.rotation_joint];
                let all = all.iter().chain(&state.sliding_joint).map(DoubleDoubleBall::to_bits);
                Some((Some(state.mode), all.collect()))
            }
        }
    }

    #[test]
    fn all_widths_find_the_same_bits() {
        let arches = arches(20_000);
        let openings: Vec<_> = arches.iter().map(|(alpha, _)| *alpha).collect();
        for weight in SelfWeight::ALL {
            let found = |width: Width| {
                let states = Lanes { weight, width }.states(&arches);
                let frictions = Lanes { weight, width }.frictions(&openings).into_iter();
                let of = |x: LaneFrictions| {
                    let rotational = match x.rotational {
                        Some(FromFriction::From(x)) => Some(x),
                        Some(FromFriction::Never) => Some(zero()),
                        None => None,
                    };
                    [x.sliding, rotational]
                        .map(|x| x.map(|x| (x.mid().hi().to_bits(), x.rad().to_bits())))
                };
                (states.iter().map(bits).collect::<Vec<_>>(), frictions.map(of).collect::<Vec<_>>())
            };
            let any = found(Width::Any);
            let states = any.0.iter().flatten();
            assert!(states.clone().count() > 19_000, "{}", states.count());
            for mode in Mode::ALL.into_iter().filter(|mode| *mode != Mode::Sliding) {
                let count = states.clone().filter(|(of, _)| *of == Some(mode)).count();
                assert!(count > 3, "{mode} {count}");
            }
            assert!(states.filter(|(of, _)| of.is_none()).count() > 1000);
            for width in Width::ALL.into_iter().filter(|width| width.is_here()) {
                assert!(found(width) == any, "{width:?}");
            }
        }
    }

    #[test]
    fn what_makes_no_sense_has_no_answer() {
        let arches = arches(0);
        for weight in SelfWeight::ALL {
            let answers = Lanes::of(weight).states(&arches);
            // What is no half opening may be a friction.
            let known = answers.iter().zip(&arches).filter(|(answer, _)| answer.is_some());
            assert!(known.into_iter().all(|(_, (_, mu))| mu.is_some_and(|mu| double(&mu) == 3.2)));
        }
        assert!(Lanes { weight: SelfWeight::Heyman, width: Width::Any }.states(&[]).is_empty());
    }

    /// No arch is answered by the numbers of another, wherever it stands.
    #[test]
    fn a_place_does_not_matter() {
        let arches = arches(300);
        let weight = SelfWeight::Milankovitch;
        let together = Lanes::of(weight).states(&arches);
        for (arch, together) in arches.iter().zip(&together) {
            let alone = Lanes { weight, width: Width::Any }.states(std::slice::from_ref(arch));
            assert_eq!(alone.iter().map(bits).next(), Some(bits(together)), "{arch:?}");
        }
    }

    #[test]
    fn the_values_are_as_narrow_as_double_doubles_allow() {
        for weight in SelfWeight::ALL {
            let arches = arches(5_000);
            for ((alpha, _), answer) in arches.iter().zip(Lanes::of(weight).states(&arches)) {
                let Some(LaneAnswer::Stands(state)) = answer else { continue };
                // Thin arches, and those next to the end of rotation, have fewer digits.
                if !(0.3..2.5).contains(&double(alpha)) {
                    continue;
                }
                let all = [state.thickness, state.thrust, state.rotation_joint];
                let joint = state.sliding_joint.iter();
                for x in all.iter().chain(joint).filter(|x| x.mid().hi() != 0.0) {
                    assert!(x.rad() < 1e-18 * x.mid().hi() && x.rad() > 0.0, "{state:?}");
                }
            }
        }
    }

    /// The roots are where candidates found one by one are, and nearly all are proved.
    #[test]
    fn the_roots_of_thicknesses_are_those_found_one_by_one() {
        use crate::solve::start::{largest_thrust, rotational_with_thickness};
        for weight in SelfWeight::ALL {
            let arches = arches(4_000);
            let states = Lanes::of(weight).states(&arches);
            let with = |(arch, answer): (&LaneArch, &Option<LaneAnswer>)| match answer {
                Some(LaneAnswer::Stands(state)) => {
                    let (part, least) = (double(&arch.0).fract(), double(&state.thickness));
                    let eta = least * (1.0 + 2.0 * part * part);
                    (eta < 2.0).then_some((*arch, number(eta)))
                }
                _ => None,
            };
            let arches: Vec<_> = arches.iter().zip(&states).filter_map(with).collect();
            let roots = Lanes::of(weight).roots(&arches, [true; 2]);
            let near = |found: [DoubleDoubleBall; 2], expected: [f64; 2]| {
                found.iter().zip(expected).all(|(x, y)| (double(x) - y).abs() < 1e-4)
            };
            let mut counts = [0; 4];
            for (((alpha, _), eta), found) in arches.iter().zip(&roots) {
                let [a, eta] = [alpha, eta].map(double);
                let all = [found.least, found.largest, found.sliding, found.steepest];
                all.iter().zip(&mut counts).for_each(|(x, n)| *n += usize::from(x.is_some()));
                if let Some(found) = found.least {
                    assert!(near(found, rotational_with_thickness(weight, &eta)), "{a} {eta}");
                }
                if let Some(found) = found.largest.filter(|[joint, _]| double(joint) > 1e-3) {
                    assert!(near(found, largest_thrust(weight, a, eta)), "{a} {eta} {found:?}");
                }
            }
            assert!(counts.iter().all(|n| *n > 800), "{counts:?} of {}", arches.len());
        }
    }

    /// The answer to an enclosure holds for each number in it.
    #[test]
    fn a_given_enclosure_is_answered_for_all_of_it() {
        let wide = |x: f64| DoubleDoubleBall::new(DoubleDouble::exact(x), 1e-20);
        for (alpha, mu) in [(1.3, 0.6), (1.3, 0.31), (2.5, 1.6), (2.55, 2.0), (2.6, 2.2)] {
            let answer = |arch| match Lanes::of(SelfWeight::Milankovitch).states(&[arch])[0] {
                Some(LaneAnswer::Stands(state)) => state,
                _ => panic!("{alpha} {mu}"),
            };
            let ends = [-1.0, 0.0, 1.0].map(|by| {
                let at = |x: f64| DoubleDoubleBall::exact(DoubleDouble::sum(x, by * 0.999e-20));
                answer((at(alpha), Some(at(mu)))).thickness
            });
            let all = answer((wide(alpha), Some(wide(mu)))).thickness;
            assert!(all.rad() > 1e-21 && all.rad() < 1e-18, "{all:?}");
            assert!(ends.iter().all(|end| all.overlaps(end)));
            // Each end is well inside.
            let inside = |end: &DoubleDoubleBall| {
                let distance =
                    (all.mid().hi() - end.mid().hi()) + (all.mid().lo() - end.mid().lo());
                distance.abs() + end.rad() <= all.rad()
            };
            assert!(ends.iter().all(inside), "{alpha} {mu}");
        }
    }
}
