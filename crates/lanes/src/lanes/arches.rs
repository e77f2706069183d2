//! Arches of any mode, each proved by the proof of its mode.
//!
//! Which proof an arch goes through is chosen by candidates; what is proved does not depend on that, as a state that is
//! proved is the only one.

use super::answer::{FromFriction, LaneAnswer, LaneFrictions, LaneState};
use super::crown::{Crown, TooWide};
use super::inner::Inner;
use super::piece::Proof;
use super::rotation::Rotation;
use super::shoulder::Shoulder;
use super::sliding::{Falling, Sliding, Steepest};
use super::start;
use super::width::Width;
use crate::arch::SelfWeight;
use crate::number::{DoubleDouble, DoubleDoubleBall, Enclosure};
use crate::problem::Mode;
use std::ops::RangeInclusive;

/// A half opening, rad, and a friction, `None` if it is unlimited, in enclosures.
pub type LaneArch = (DoubleDoubleBall, Option<DoubleDoubleBall>);

/// What [`Rotation`] proves of a half opening: last the frictions that it asks for at the shoulder and inside.
type Rotating = [DoubleDoubleBall; 6];

/// Arches of a weight that are asked together.
struct Asked<'a> {
    width: Width,
    weight: SelfWeight,
    arches: &'a [LaneArch],
    answers: Vec<Option<LaneAnswer>>,
}

/// Half openings that are asked, rad: below the first other equations keep their digits, and the last is below pi.
const HALF_OPENINGS: RangeInclusive<f64> = start::LEAST..=3.14;

/// Rows of one half opening from which it pays to prove its purely sliding friction.
const MANY: usize = 4;

/// The double next to what a ball has in its middle.
fn double(x: &DoubleDoubleBall) -> f64 {
    x.mid().hi()
}

/// Tells whether one is proved to be below the other.
fn is_below(one: &DoubleDoubleBall, other: &DoubleDoubleBall) -> bool {
    one.is_less_than(other).is_proved()
}

impl Width {
    /// What is proved of arches of a weight, in their order; `None` where nothing is. Rows of one half opening that
    /// follow each other share its proof. Any number may be asked: what makes no sense has no answer.
    ///
    /// ```
    /// use couplet_check::arch::SelfWeight;
    /// use couplet_lanes::lanes::{LaneAnswer, Width};
    /// use couplet_number::number::{DoubleDouble, DoubleDoubleBall};
    /// let number = |x| DoubleDoubleBall::exact(DoubleDouble::exact(x));
    /// let arches = [(1.5, 0.5), (1.5, 0.01), (-1.0, 0.5)];
    /// let arches = arches.map(|(alpha, mu)| (number(alpha), Some(number(mu))));
    /// let answers = Width::widest().states(SelfWeight::Heyman, &arches);
    /// let [Some(LaneAnswer::Stands(state)), Some(LaneAnswer::Falls), None] = answers[..] else { panic!() };
    /// assert_eq!(state.thickness.nearest_double(), Some(0.090140690267333675));
    /// ```
    pub fn states(self, weight: SelfWeight, arches: &[LaneArch]) -> Vec<Option<LaneAnswer>> {
        let answers = vec![None; arches.len()];
        let mut asked = Asked { width: self, weight, arches, answers };
        asked.answer();
        asked.answers
    }

    /// The frictions at which the mode changes, of some half openings, rad.
    pub fn frictions(
        self,
        weight: SelfWeight,
        half_openings: &[DoubleDoubleBall],
    ) -> Vec<LaneFrictions> {
        let rows: Vec<_> = half_openings.iter().map(|alpha| [*alpha]).collect();
        let larger = |[.., at_shoulder, inside]: Rotating| match (
            is_below(&at_shoulder, &inside),
            is_below(&inside, &at_shoulder),
        ) {
            (true, _) => Some(FromFriction::From(inside)),
            (_, true) => Some(FromFriction::From(at_shoulder)),
            (false, false) => None,
        };
        let rotating = self.rotating::<true>(weight, &rows).into_iter();
        let sliding = self.prove(&Sliding(start::sliding()), &rows).into_iter();
        let both = rotating.zip(sliding).map(|(rotating, sliding)| LaneFrictions {
            sliding: sliding.map(|[friction]| friction),
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
        overturning.each(self, &Crown { weight, is_limited: false }, |row, _, [..]| {
            all[row].rotational = Some(FromFriction::Never);
        });
        all
    }

    fn rotating<const EXACTLY: bool>(
        self,
        weight: SelfWeight,
        rows: &[[DoubleDoubleBall; 1]],
    ) -> Vec<Option<Rotating>> {
        self.prove(&Rotation::<EXACTLY> { weight, table: start::rotation(weight) }, rows)
    }
}

/// The state of a half opening that rotates.
fn rotates([thickness, thrust, intrinsic_thrust, rotation_joint, ..]: &Rotating) -> LaneState {
    LaneState {
        mode: Mode::Rotational,
        thickness: *thickness,
        thrust: *thrust,
        intrinsic_thrust: *intrinsic_thrust,
        rotation_joint: *rotation_joint,
        sliding_joint: None,
    }
}

impl Asked<'_> {
    fn answer(&mut self) {
        let (openings, opening_of) = self.openings();
        let rotating = self.width.rotating::<false>(self.weight, &openings);
        let sliding = self.sliding(&openings, &opening_of);
        let (mut unlimited, mut falling, mut shoulder, mut inside) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (row, &(alpha, friction)) in self.arches.iter().enumerate() {
            if !HALF_OPENINGS.contains(&double(&alpha)) {
                continue;
            }
            let rotating = &rotating[opening_of[row]];
            let Some(mu) = friction else {
                match rotating {
                    Some(found) => self.stands(row, rotates(found)),
                    None => unlimited.push(row),
                }
                continue;
            };
            if let Some([sliding]) = &sliding[opening_of[row]]
                && is_below(&mu, sliding)
                && mu.is_positive().is_proved()
            {
                self.falls(row);
                continue;
            }
            match rotating {
                Some(found @ [.., at_shoulder, inside])
                    if is_below(at_shoulder, &mu) && is_below(inside, &mu) =>
                {
                    self.stands(row, rotates(found));
                }
                _ if start::seems_to_slide(double(&alpha), double(&mu)) => falling.push(row),
                Some([.., at_shoulder, _]) if double(at_shoulder) > double(&mu) => {
                    shoulder.push(row);
                }
                _ => inside.push(row),
            }
        }
        self.slides_at_shoulder(&shoulder);
        let count = falling.len();
        falling.append(&mut inside);
        self.slides_inside(&falling, count);
        self.overturns(&unlimited);
    }

    /// Half openings that follow each other, and for each row its place among them.
    fn openings(&self) -> (Vec<[DoubleDoubleBall; 1]>, Vec<usize>) {
        let mut openings: Vec<[DoubleDoubleBall; 1]> = Vec::new();
        let bits = |x: &DoubleDoubleBall| [x.mid().hi(), x.mid().lo(), x.rad()].map(f64::to_bits);
        let place = |(alpha, _): &LaneArch| {
            if openings.last().is_none_or(|[last]| bits(last) != bits(alpha)) {
                openings.push([*alpha]);
            }
            openings.len() - 1
        };
        let places = self.arches.iter().map(place).collect();
        (openings, places)
    }

    /// The purely sliding frictions of half openings that have many rows.
    fn sliding(
        &self,
        openings: &[[DoubleDoubleBall; 1]],
        opening_of: &[usize],
    ) -> Vec<Option<[DoubleDoubleBall; 1]>> {
        let mut counts = vec![0; openings.len()];
        opening_of.iter().for_each(|opening| counts[*opening] += 1);
        let mut asking = Asking::default();
        let many =
            openings.iter().zip(&counts).enumerate().filter(|(_, (_, count))| **count >= MANY);
        many.for_each(|(place, (opening, _))| asking.push(place, *opening));
        let mut all = vec![None; openings.len()];
        let proof = Sliding(start::sliding());
        asking.each(self.width, &proof, |place, _, found| all[place] = Some(found));
        all
    }

    fn stands(&mut self, row: usize, state: LaneState) {
        self.answers[row] = Some(LaneAnswer::Stands(state));
    }

    fn falls(&mut self, row: usize) {
        self.answers[row] = Some(LaneAnswer::Falls);
    }

    /// The half opening and the friction of a row whose friction is limited.
    fn given(&self, row: usize) -> [DoubleDoubleBall; 2] {
        let (alpha, mu) = self.arches[row];
        [alpha, mu.unwrap_or(DoubleDoubleBall::WHOLE)]
    }

    /// States in which the shoulder slides.
    fn slides_at_shoulder(&mut self, rows: &[usize]) {
        let given: Vec<_> = rows.iter().map(|row| self.given(*row)).collect();
        let proof = Shoulder { weight: self.weight, table: start::shoulder(self.weight) };
        for (row, found) in rows.iter().zip(self.width.prove(&proof, &given)) {
            let Some([thickness, thrust, intrinsic_thrust, rotation_joint]) = found else {
                continue;
            };
            let state = LaneState {
                mode: Mode::SlidingRotational,
                thickness,
                thrust,
                intrinsic_thrust,
                rotation_joint,
                sliding_joint: None,
            };
            self.stands(*row, state);
        }
    }

    /// Rows in which an inner joint slides; of the first, friction seems to be too little.
    fn slides_inside(&mut self, rows: &[usize], falling: usize) {
        // What falls with more friction falls with less.
        let least = DoubleDoubleBall::exact(DoubleDouble::exact(start::FRICTIONS[0]));
        let friction = |(place, row): (usize, &usize)| {
            let [_, mu] = self.given(*row);
            let is_less = place < falling && mu.is_positive().is_proved() && is_below(&mu, &least);
            [if is_less { least } else { mu }]
        };
        let frictions: Vec<_> = rows.iter().enumerate().map(friction).collect();
        let steepest = self.width.prove(&Steepest(start::steepest()), &frictions);
        let (mut fall, mut wide, mut crown, mut haunch) =
            (Asking::default(), Asking::default(), Asking::default(), Asking::default());
        for (place, (row, found)) in rows.iter().zip(steepest).enumerate() {
            let Some([thrust, joint]) = found else { continue };
            let ([alpha, _], [mu]) = (self.given(*row), frictions[place]);
            let (opening, h) = (double(&alpha), double(&thrust));
            match () {
                () if place < falling => fall.push(*row, [alpha, mu, thrust]),
                () if start::seems_too_wide(self.weight, opening, h) => {
                    wide.push(*row, [alpha, thrust]);
                }
                () if start::plane(self.weight).at(opening, h) > 0.0 => {
                    haunch.push(*row, [alpha, mu, thrust, joint]);
                }
                () => crown.push(*row, [alpha, mu, thrust, joint]),
            }
        }
        let Self { weight, width, .. } = *self;
        fall.each(width, &Falling, |row, _, [_]| self.falls(row));
        wide.each(width, &TooWide { weight }, |row, _, [_]| self.falls(row));
        crown.each(width, &Crown { weight, is_limited: true }, |row, given, found| {
            let [_, _, thrust, joint] = given;
            self.stands(row, at_crown(Mode::OverturningSliding, found, thrust, Some(joint)));
        });
        let plane = start::plane(weight);
        haunch.each(width, &Inner { weight, plane }, |row, [_, _, thrust, slides], found| {
            let [thickness, intrinsic_thrust, rotation_joint] = found;
            let mode =
                match (is_below(&slides, &rotation_joint), is_below(&rotation_joint, &slides)) {
                    (true, _) => Mode::RotationalSliding,
                    (_, true) => Mode::RotationalSlidingRotational,
                    (false, false) => return,
                };
            let sliding_joint = Some(slides);
            let state = LaneState {
                mode,
                thickness,
                thrust,
                intrinsic_thrust,
                rotation_joint,
                sliding_joint,
            };
            self.stands(row, state);
        });
    }

    /// Rows of unlimited friction that do not rotate.
    fn overturns(&mut self, rows: &[usize]) {
        let (mut wide, mut crown) = (Asking::default(), Asking::default());
        for &row in rows {
            let (alpha, _) = self.arches[row];
            let zero = zero();
            match start::seems_too_wide(self.weight, double(&alpha), 0.0) {
                true => wide.push(row, [alpha, zero]),
                false => crown.push(row, overturning_at(alpha)),
            }
        }
        let Self { weight, width, .. } = *self;
        wide.each(width, &TooWide { weight }, |row, _, [_]| self.falls(row));
        crown.each(width, &Crown { weight, is_limited: false }, |row, _, [thickness, _]| {
            self.stands(row, at_crown(Mode::Overturning, [thickness, zero()], zero(), None));
        });
    }
}

/// What a half opening gives to a proof that it overturns without a limit of friction.
fn overturning_at(alpha: DoubleDoubleBall) -> [DoubleDoubleBall; 4] {
    [alpha, DoubleDoubleBall::WHOLE, zero(), zero()]
}

fn zero() -> DoubleDoubleBall {
    DoubleDoubleBall::exact(DoubleDouble::ZERO)
}

/// A state that turns about the crown.
fn at_crown(
    mode: Mode,
    [thickness, intrinsic_thrust]: [DoubleDoubleBall; 2],
    thrust: DoubleDoubleBall,
    sliding_joint: Option<DoubleDoubleBall>,
) -> LaneState {
    let rotation_joint = zero();
    LaneState { mode, thickness, thrust, intrinsic_thrust, rotation_joint, sliding_joint }
}

/// Rows that go through one proof, and what is given of them.
struct Asking<const IN: usize> {
    rows: Vec<usize>,
    given: Vec<[DoubleDoubleBall; IN]>,
}

impl<const IN: usize> Default for Asking<IN> {
    fn default() -> Self {
        Self { rows: Vec::new(), given: Vec::new() }
    }
}

impl<const IN: usize> Asking<IN> {
    fn push(&mut self, row: usize, given: [DoubleDoubleBall; IN]) {
        self.rows.push(row);
        self.given.push(given);
    }

    /// Tells of each row of which something is proved what is given and what is found.
    fn each<const ANGLES: usize, const OUT: usize>(
        &self,
        width: Width,
        proof: &impl Proof<IN, ANGLES, OUT>,
        mut tell: impl FnMut(usize, [DoubleDoubleBall; IN], [DoubleDoubleBall; OUT]),
    ) {
        let found = width.prove(proof, &self.given);
        for ((row, given), found) in self.rows.iter().zip(&self.given).zip(found) {
            if let Some(found) = found {
                tell(*row, *given, found);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let of = |x: &DoubleDoubleBall| [x.mid().hi(), x.mid().lo(), x.rad()].map(f64::to_bits);
        match answer.as_ref()? {
            LaneAnswer::Falls => Some((None, Vec::new())),
            LaneAnswer::Stands(state) => {
                let all =
                    [state.thickness, state.thrust, state.intrinsic_thrust, state.rotation_joint];
                let all = all.iter().chain(&state.sliding_joint).map(of);
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
                let states = width.states(weight, &arches);
                let frictions = width.frictions(weight, &openings).into_iter();
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
            let answers = Width::widest().states(weight, &arches);
            // What is no half opening may be a friction.
            let known = answers.iter().zip(&arches).filter(|(answer, _)| answer.is_some());
            assert!(known.into_iter().all(|(_, (_, mu))| mu.is_some_and(|mu| double(&mu) == 3.2)));
        }
        assert!(Width::Any.states(SelfWeight::Heyman, &[]).is_empty());
    }

    /// No arch is answered by the numbers of another, wherever it stands.
    #[test]
    fn a_place_does_not_matter() {
        let arches = arches(300);
        let weight = SelfWeight::Milankovitch;
        let together = Width::widest().states(weight, &arches);
        for (arch, together) in arches.iter().zip(&together) {
            let alone = Width::Any.states(weight, std::slice::from_ref(arch));
            assert_eq!(alone.iter().map(bits).next(), Some(bits(together)), "{arch:?}");
        }
    }

    #[test]
    fn the_values_are_as_narrow_as_double_doubles_allow() {
        for weight in SelfWeight::ALL {
            let arches = arches(5_000);
            for ((alpha, _), answer) in arches.iter().zip(Width::widest().states(weight, &arches)) {
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

    /// What is given in an enclosure is answered for each number in it.
    #[test]
    fn a_given_enclosure_is_answered_for_all_of_it() {
        let wide = |x: f64| DoubleDoubleBall::new(DoubleDouble::exact(x), 1e-20);
        for (alpha, mu) in [(1.3, 0.6), (1.3, 0.31), (2.5, 1.6), (2.55, 2.0), (2.6, 2.2)] {
            let answer = |arch| match Width::Any.states(SelfWeight::Milankovitch, &[arch])[0] {
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
