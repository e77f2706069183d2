//! Arches that are asked together, each proved by the proof of its mode.
//!
//! Candidates choose which proof an arch goes through; what is proved does not depend on that, as a state that is
//! proved is the only one.

use super::answer::{LaneAnswer, LaneState};
use super::asking::{Asking, double, is_below, overturning_at, zero};
use super::crown::{Crown, TooWide};
use super::inner::Inner;
use super::rotation::rotating;
use super::shoulder::Shoulder;
use super::sliding::{Falling, Sliding, Steepest};
use super::start;
use super::width::Width;
use crate::arch::SelfWeight;
use crate::number::{DoubleDouble, DoubleDoubleBall, Enclosure};
use crate::problem::Mode;
use std::ops::RangeInclusive;

/// Half opening, rad, and friction of an arch, `None` if it is unlimited, in enclosures.
pub type LaneArch = (DoubleDoubleBall, Option<DoubleDoubleBall>);

/// Half openings that are asked, rad: below the first other equations keep their digits, and the last is below pi.
const HALF_OPENINGS: RangeInclusive<f64> = start::LEAST..=3.125;

/// Rows of one half opening from which it pays to prove its purely sliding friction.
const MANY: usize = 4;

/// Arches of a weight that are asked together.
pub(super) struct Asked<'a> {
    width: Width,
    weight: SelfWeight,
    arches: &'a [LaneArch],
    answers: Vec<Option<LaneAnswer>>,
}

impl<'a> Asked<'a> {
    /// Answers to arches, in their order; `None` where nothing is proved.
    pub(super) fn answers(
        (width, weight): (Width, SelfWeight),
        arches: &'a [LaneArch],
    ) -> Vec<Option<LaneAnswer>> {
        let answers = vec![None; arches.len()];
        let mut asked = Self { width, weight, arches, answers };
        asked.answer();
        asked.answers
    }

    fn answer(&mut self) {
        let (openings, opening_of) = self.openings();
        let rotating = rotating::<false>((self.width, self.weight), &openings);
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
                    Some(found) => self.stands(row, LaneState::rotating(found)),
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
                    self.stands(row, LaneState::rotating(found));
                }
                _ if start::seems_to_slide(double(&alpha), double(&mu)) => falling.push(row),
                Some([.., at_shoulder, _]) if double(at_shoulder) > double(&mu) => {
                    shoulder.push(row);
                }
                _ => inside.push(row),
            }
        }
        self.slides_at_shoulder(&shoulder);
        self.lack_friction(&falling);
        self.slide_inside(&inside);
        self.overturns(&unlimited);
    }

    /// Half openings that follow each other, and for each row its place among them.
    fn openings(&self) -> (Vec<[DoubleDoubleBall; 1]>, Vec<usize>) {
        let mut openings: Vec<[DoubleDoubleBall; 1]> = Vec::new();
        let place = |(alpha, _): &LaneArch| {
            if openings.last().is_none_or(|[last]| last.to_bits() != alpha.to_bits()) {
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
        let proof = || Sliding(start::sliding());
        asking.each(self.width, proof, |place, _, [friction, _]| all[place] = Some([friction]));
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
        let Self { weight, width, .. } = *self;
        let mut asking = Asking::default();
        rows.iter().for_each(|row| asking.push(*row, self.given(*row)));
        let proof = || Shoulder { weight, table: start::shoulder(weight) };
        asking.each(width, proof, |row, _, found| {
            self.stands(row, LaneState::new(Mode::SlidingRotational, found, None));
        });
    }

    /// Rows with their half openings, frictions, and the thrusts and joints at which an inner joint slides.
    fn with_steepest(&self, given: &[(usize, [DoubleDoubleBall; 2])]) -> Asking<4> {
        let mut asking = Asking::default();
        given.iter().enumerate().for_each(|(place, (_, [_, mu]))| asking.push(place, [*mu]));
        let mut all = Asking::default();
        asking.each(
            self.width,
            || Steepest(start::steepest()),
            |place, [mu], [thrust, joint]| {
                let (row, [alpha, _]) = given[place];
                all.push(row, [alpha, mu, thrust, joint]);
            },
        );
        all
    }

    /// Rows whose friction seems to be too little.
    fn lack_friction(&mut self, rows: &[usize]) {
        // What falls with more friction falls with less.
        let least = DoubleDoubleBall::exact(DoubleDouble::exact(start::FRICTIONS[0]));
        let given = |row: &usize| {
            let [alpha, mu] = self.given(*row);
            let is_less = mu.is_positive().is_proved() && is_below(&mu, &least);
            (*row, [alpha, if is_less { least } else { mu }])
        };
        let given: Vec<_> = rows.iter().map(given).collect();
        let mut asking = Asking::default();
        for (row, [alpha, mu, thrust, _]) in self.with_steepest(&given).into_rows() {
            asking.push(row, [alpha, mu, thrust]);
        }
        asking.each(self.width, || Falling, |row, _, [_]| self.falls(row));
    }

    /// Rows in which an inner joint seems to slide.
    fn slide_inside(&mut self, rows: &[usize]) {
        let Self { weight, width, .. } = *self;
        let given: Vec<_> = rows.iter().map(|row| (*row, self.given(*row))).collect();
        let (mut wide, mut crown, mut haunch) =
            (Asking::default(), Asking::default(), Asking::default());
        for (row, given) in self.with_steepest(&given).into_rows() {
            let [alpha, _, thrust, _] = given;
            let (opening, h) = (double(&alpha), double(&thrust));
            if start::seems_too_wide(weight, opening, h) {
                wide.push(row, [alpha, thrust]);
            } else if start::plane(weight).at(opening, h) > 0.0 {
                haunch.push(row, given);
            } else {
                crown.push(row, given);
            }
        }
        wide.each(width, || TooWide { weight }, |row, _, [_]| self.falls(row));
        let proof = || Crown { weight, is_limited: true };
        crown.each(width, proof, |row, [_, _, thrust, slides], [thickness, intrinsic_thrust]| {
            let found = [thickness, thrust, intrinsic_thrust, zero()];
            self.stands(row, LaneState::new(Mode::OverturningSliding, found, Some(slides)));
        });
        let proof = || Inner { weight, plane: start::plane(weight) };
        haunch.each(width, proof, |row, [_, _, thrust, slides], found| {
            let [thickness, intrinsic_thrust, rotation_joint] = found;
            let is_above = is_below(&slides, &rotation_joint);
            let mode = match (is_above, is_below(&rotation_joint, &slides)) {
                (true, _) => Mode::RotationalSliding,
                (_, true) => Mode::RotationalSlidingRotational,
                (false, false) => return,
            };
            let found = [thickness, thrust, intrinsic_thrust, rotation_joint];
            self.stands(row, LaneState::new(mode, found, Some(slides)));
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
        wide.each(width, || TooWide { weight }, |row, _, [_]| self.falls(row));
        let proof = || Crown { weight, is_limited: false };
        crown.each(width, proof, |row, _, [thickness, _]| {
            let found = [thickness, zero(), zero(), zero()];
            self.stands(row, LaneState::new(Mode::Overturning, found, None));
        });
    }
}
