//! Arches that go through a proof together.

use super::sine::Long;
use crate::number::{
    Dekker, DoubleDouble, DoubleDoubleBall, DoubleDoubleBy, Enclosure, Product, SinePoint,
    SinePoints,
};
use std::array;

/// Arches of one call of a proof.
pub(super) const ARCHES: usize = 64;

/// Numbers of them: the two doubles of each midpoint, and the radii.
pub(super) type LaneColumn = [[f64; ARCHES]; 3];

/// A proof of `OUT` values from `IN` numbers, without a branch.
pub(super) trait Proof<const IN: usize, const ANGLES: usize, const OUT: usize> {
    /// Candidates of the angles whose sines the proof needs, from the nearest doubles of what is given: looked up for
    /// all arches before they go through.
    fn candidates(&self, given: [f64; IN]) -> [f64; ANGLES];

    /// The values, each the whole line where not all is proved. The points are next to the candidates.
    fn prove<P: Product>(
        &self,
        given: [Long<P>; IN],
        candidates: [(f64, SinePoint); ANGLES],
    ) -> [Long<P>; OUT];
}

/// Numbers that are given of the arches of one call, and that are found of them.
pub(super) struct LanePiece<const IN: usize, const OUT: usize> {
    given: [LaneColumn; IN],
    found: [LaneColumn; OUT],
}

impl<const IN: usize, const OUT: usize> LanePiece<IN, OUT> {
    /// No arch yet.
    pub(super) fn new() -> Self {
        Self { given: [[[f64::NAN; ARCHES]; 3]; IN], found: [[[f64::NAN; ARCHES]; 3]; OUT] }
    }

    /// Puts the numbers of an arch in a place.
    #[inline(always)]
    pub(super) fn put(&mut self, place: usize, given: &[DoubleDoubleBall; IN]) {
        for (column, x) in self.given.iter_mut().zip(given) {
            column[0][place] = x.mid().hi();
            column[1][place] = x.mid().lo();
            column[2][place] = x.rad();
        }
    }

    /// The one text of all widths.
    #[inline(always)]
    pub(super) fn prove<P: Product, const ANGLES: usize>(
        &mut self,
        proof: &impl Proof<IN, ANGLES, OUT>,
    ) {
        let mut candidates = [[f64::NAN; ARCHES]; ANGLES];
        let mut points: [SinePoints<ARCHES>; ANGLES] = array::from_fn(|_| SinePoints::NONE);
        for place in 0..ARCHES {
            let of = proof.candidates(self.given.each_ref().map(|column| column[0][place]));
            for k in 0..ANGLES {
                candidates[k][place] = of[k];
                points[k].set(place, SinePoint::nearest(of[k]));
            }
        }
        for place in 0..ARCHES {
            let mut angles = [(f64::NAN, SinePoint::nearest(0.0)); ANGLES];
            for k in 0..ANGLES {
                angles[k] = (candidates[k][place], points[k].get(place));
            }
            let given = self.given.each_ref().map(|column| number::<P>(column, place));
            let found = proof.prove(given, angles);
            for (column, x) in self.found.iter_mut().zip(&found) {
                column[0][place] = x.mid().hi();
                column[1][place] = x.mid().lo();
                column[2][place] = x.rad();
            }
        }
    }

    /// Tells whether what was found is what every processor finds, to the last bit.
    pub(super) fn is_found_by_any<const ANGLES: usize>(
        &self,
        proof: &impl Proof<IN, ANGLES, OUT>,
    ) -> bool {
        let mut other = Self { given: self.given, ..Self::new() };
        other.prove::<Dekker, ANGLES>(proof);
        let bits = |piece: &Self| {
            // What is not a number may be so in more than one way.
            let bits = |x: &f64| if x.is_nan() { u64::MAX } else { x.to_bits() };
            piece.found.iter().flatten().flatten().map(bits).collect::<Vec<u64>>()
        };
        bits(self) == bits(&other)
    }

    /// Values of the arch in a place, if they are proved.
    pub(super) fn found(&self, place: usize) -> Option<[DoubleDoubleBall; OUT]> {
        let value = |column: &LaneColumn| {
            let [high, low, rad] = column.each_ref().map(|part| part[place]);
            DoubleDoubleBall::new(DoubleDouble::sum(high, low), rad)
        };
        let is_proved = self.found.iter().all(|[.., radii]| radii[place].is_finite());
        let all = is_proved.then(|| self.found.each_ref().map(value))?;
        all.iter().all(Enclosure::is_bounded).then_some(all)
    }
}

#[inline(always)]
fn number<P: Product>(column: &LaneColumn, place: usize) -> Long<P> {
    let [high, low, rad] = column.each_ref().map(|part| part[place]);
    Long::new(DoubleDoubleBy::sum(high, low), rad)
}
