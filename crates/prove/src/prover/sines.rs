//! Balls that know sines and cosines of points nearby.
//!
//! A root is refined in numbers of more and more bits, so that each of its angles, and each that an equation makes of
//! them, is asked for again and again at almost the same place. Its sine and cosine are computed **once**, at a short
//! argument next to it ([`SineAnchor`]), and moved along.

use crate::number::{Angle, Ball, Field, Magnitude, Real, SineAnchor, Stumpff, stumpff_with};
use rayon::prelude::*;
use rug::Float;
use std::cell::{Cell, RefCell};

/// Up to these bits a sine is computed afresh, if there is no anchor.
const FEW: u32 = 400;
/// Below this, angles are computed one after the other: faster, and it avoids a deadlock when a thread
/// that fills a `OnceLock` steals a job that waits for it.
const WORTH_THREADS: u32 = 1 << 14;

/// Sines and cosines of a few places, to move to the angles next to them.
#[derive(Debug, Default)]
pub struct Sines {
    /// The bits of a place, and those of its sine.
    near: u32,
    bits: u32,
    /// Bits up to which the places have moved along, or shall be at the next question.
    nearer: Cell<u32>,
    places: RefCell<Vec<AnchoredPlace>>,
}

/// A place with its sine and cosine.
#[derive(Debug)]
struct AnchoredPlace {
    at: Float,
    anchor: SineAnchor,
    moved: u32,
    /// The last angle that was asked for with all bits.
    last: Option<Angle<Ball>>,
}

impl Sines {
    /// Sines to `bits` bits of places of `near` bits.
    pub(super) fn new(near: u32, bits: u32) -> Self {
        Self { near, bits, ..Self::default() }
    }

    /// Computes those of some angles beforehand, on several threads, calling `tick` once for each.
    pub(super) fn prepare(&self, angles: &[&Float], tick: &(dyn Fn() + Sync)) {
        let (near, bits) = (self.near, self.bits);
        let place = |x: &&Float| {
            let place = AnchoredPlace::new(x, near, bits);
            tick();
            place
        };
        // Outside a pool no thread is started: who calls a library may fork afterwards.
        let is_alone = bits < WORTH_THREADS || rayon::current_thread_index().is_none();
        let places: Vec<AnchoredPlace> = match is_alone {
            true => angles.iter().map(place).collect(),
            false => {
                SineAnchor::prepare(bits);
                angles.par_iter().map(place).collect()
            }
        };
        self.places.replace(places);
    }

    /// Moves each place along at the next question, which is known to so many bits: from nearer places what follows
    /// sums fewer terms.
    pub(super) fn come_nearer(&self, bits: u32) {
        self.nearer.set(bits);
    }

    /// A ball that knows them.
    pub fn ball(&self, ball: Ball) -> SinedBall<'_> {
        SinedBall { ball, sines: self }
    }

    /// The angle with its sine and cosine.
    pub(crate) fn angle(&self, rad: &Ball) -> Angle<Ball> {
        // A joint on the left has the place of the one on the right.
        if *rad.mid() < 0 {
            let Angle { rad, sin, cos } = self.angle(&-rad);
            return Angle { rad: -rad, sin: -sin, cos };
        }
        let mut places = self.places.borrow_mut();
        let known = places.iter().position(|place| place.is_near(rad, self.near));
        let place = match known {
            Some(index) => &mut places[index],
            None if rad.prec() <= FEW || self.bits < FEW => return Angle::new(rad.clone()),
            None => {
                let place = AnchoredPlace::new(rad.mid(), self.near, self.bits);
                places.push(place);
                let last = places.len() - 1;
                &mut places[last]
            }
        };
        place.come_nearer(rad, self.nearer.get());
        if let Some(last) = &place.last
            && let Some(angle) = beside(last, rad)
        {
            return angle;
        }
        if rad.prec() < self.bits {
            return place.anchor.with_precision(rad.prec()).angle(rad);
        }
        let angle = place.anchor.angle(rad);
        place.last = Some(angle.clone());
        angle
    }
}

impl AnchoredPlace {
    fn new(x: &Float, near: u32, bits: u32) -> Self {
        let at = Float::with_val(near, x);
        Self { anchor: SineAnchor::new(&at, bits), at, moved: near, last: None }
    }

    /// Tells whether an angle is next to the place, to half of its bits.
    fn is_near(&self, rad: &Ball, near: u32) -> bool {
        let distance = Float::with_val(64, rad.mid() - &self.at);
        Magnitude::upper(&distance) < Magnitude::power_of_two(-i64::from(near / 2))
    }

    fn come_nearer(&mut self, rad: &Ball, bits: u32) {
        if self.moved < bits {
            self.anchor = self.anchor.moved(&Float::with_val(bits, rad.mid()));
            self.moved = bits;
        }
    }
}

/// The angle `rad` from another that is so near that the second order in their distance is below the last bit; `None`
/// from elsewhere.
fn beside(from: &Angle<Ball>, rad: &Ball) -> Option<Angle<Ball>> {
    let d = (rad.clone() - &from.rad).trimmed();
    let size = Magnitude::upper(d.mid()).plus(d.rad());
    let rest = size.times(size).shifted(-1);
    if rest >= Magnitude::power_of_two(-i64::from(rad.prec().min(from.rad.prec()))) {
        return None;
    }
    let d = d.with_precision(d.mid().prec());
    let by = |slope: &Ball| slope.with_precision(d.prec()) * &d;
    let sin = (from.sin.clone() + by(&from.cos)).widened(rest);
    let cos = (from.cos.clone() - by(&from.sin)).widened(rest);
    Some(Angle { rad: rad.clone(), sin, cos })
}

/// A ball that knows sines and cosines of points nearby.
#[derive(Clone, Debug)]
pub struct SinedBall<'a> {
    pub ball: Ball,
    sines: &'a Sines,
}

impl SinedBall<'_> {
    fn of(&self, ball: Ball) -> Self {
        Self { ball, sines: self.sines }
    }

    fn negated(self) -> Self {
        Self { ball: -self.ball, ..self }
    }

    fn plus(self, other: &Self) -> Self {
        Self { ball: self.ball + &other.ball, ..self }
    }

    fn minus(self, other: &Self) -> Self {
        Self { ball: self.ball - &other.ball, ..self }
    }

    fn times(self, other: &Self) -> Self {
        Self { ball: self.ball * &other.ball, ..self }
    }

    fn over(self, other: &Self) -> Self {
        Self { ball: self.ball / &other.ball, ..self }
    }
}

crate::number::operators!(['a] SinedBall<'a>);

impl Field for SinedBall<'_> {
    fn int(&self, n: i32) -> Self {
        self.of(self.ball.int(n))
    }

    fn square(&self) -> Self {
        self.of(self.ball.square())
    }
}

impl Real for SinedBall<'_> {
    fn pi(&self) -> Self {
        self.of(self.ball.pi())
    }

    fn sqrt(&self) -> Self {
        self.of(self.ball.sqrt())
    }

    fn sin_cos(&self) -> (Self, Self) {
        let Angle { sin, cos, .. } = self.sines.angle(&self.ball);
        (self.of(sin), self.of(cos))
    }
}

impl Stumpff for SinedBall<'_> {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let angle = |rad: Ball| self.sines.angle(&rad);
        stumpff_with(&self.ball, count, angle).into_iter().map(|c| self.of(c)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;

    /// To the second order: what is left out shows where the way is long.
    #[test]
    fn angles_beside_others_hold_the_true_ones() {
        let from = Angle::new(Ball::exact(Float::with_val(300, 1.25), 300));
        for far in [3i32, 40, 149, 152, 200] {
            for side in [-1.0, 1.0] {
                let rad =
                    from.rad.clone() + Ball::exact(Float::with_val(300, 1.1 * side) >> far, 300);
                let found = beside(&from, &rad);
                assert_eq!(found.is_some(), far > 149, "{far}");
                let Some(there) = found else { continue };
                let truth = Angle::new(Ball::exact(Float::with_val(900, rad.mid()), 900));
                assert!(truth.sin.lies_inside(&there.sin) && truth.cos.lies_inside(&there.cos));
                assert!(there.sin.rad() < Magnitude::power_of_two(-296));
            }
        }
    }

    /// Angles near a place, of other bits and at other places are the true ones.
    #[test]
    fn angles_hold_the_true_ones() {
        let sines = Sines::new(120, 3000);
        let x = Float::with_val(3000, 2).sqrt();
        for (bits, shift) in [(200, 90), (900, 200), (3000, 1000), (3000, 1600), (3000, 2900)] {
            sines.come_nearer(if bits < 3000 { 0 } else { 900 });
            for turned in [0, 1] {
                let step = Float::with_val(64, 1.1) >> shift;
                let rad = Ball::exact(Float::with_val(bits, &x + step) / (1 + turned), bits);
                let (found, truth) = (sines.angle(&rad), rad.with_precision(4000).sin_cos());
                assert!(found.sin.overlaps(&truth.0) && found.cos.overlaps(&truth.1));
                assert!(found.sin.rad() < Magnitude::power_of_two(12 - i64::from(bits)), "{bits}");
                let left = sines.angle(&-rad);
                assert!(left.sin.overlaps(&-truth.0.clone()) && left.cos.overlaps(&truth.1));
                assert!(!found.cos.overlaps(&truth.0), "false twin");
            }
        }
        assert_eq!(sines.places.borrow().len(), 2);
    }
}
