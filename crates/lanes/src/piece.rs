//! Arches that go through a proof together.

use super::sine::Long;
use crate::number::{
    BallColumn, Dekker, DoubleDoubleBall, Enclosure, Product, SinePoint, SinePoints,
};
use std::array;

/// Arches of one call of a proof.
pub(super) const ARCHES: usize = 64;

/// Numbers of them.
type LaneColumn = BallColumn<ARCHES>;

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
        Self { given: [LaneColumn::WHOLE; IN], found: [LaneColumn::WHOLE; OUT] }
    }

    /// Puts the numbers of an arch in a place.
    #[inline(always)]
    pub(super) fn put(&mut self, place: usize, given: &[DoubleDoubleBall; IN]) {
        for (column, x) in self.given.iter_mut().zip(given) {
            column.put(place, x);
        }
    }

    /// The one text of all widths.
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "a place is one of many columns")]
    pub(super) fn prove<P: Product, const ANGLES: usize>(
        &mut self,
        proof: &impl Proof<IN, ANGLES, OUT>,
    ) {
        let mut candidates = [[f64::NAN; ARCHES]; ANGLES];
        let mut points: [SinePoints<ARCHES>; ANGLES] = array::from_fn(|_| SinePoints::NONE);
        for place in 0..ARCHES {
            let given = self.given.each_ref().map(|column| column.get(place).mid().hi());
            let of = proof.candidates(given);
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
            let given = self.given.each_ref().map(|column| column.given::<P>(place));
            let found = proof.prove(given, angles);
            for (column, x) in self.found.iter_mut().zip(&found) {
                column.put_found(place, x);
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
            let all = (0..ARCHES).map(|place| piece.found.each_ref().map(|of| of.get(place)));
            all.map(|balls| balls.map(|ball| ball.to_bits())).collect::<Vec<_>>()
        };
        bits(self) == bits(&other)
    }

    /// Values of the arch in a place, if they are proved.
    pub(super) fn found(&self, place: usize) -> Option<[DoubleDoubleBall; OUT]> {
        let all = self.found.each_ref().map(|column| column.get(place));
        all.iter().all(Enclosure::is_bounded).then_some(all)
    }
}
