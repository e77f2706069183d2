//! The stones of an assembly as bodies: corners, weights, centroids, and the ground that they stand on.

use super::assembly::Assembly;
use crate::arch::Ring;
use crate::number::{Angle, Ball, Field, Real};

/// A point, `y` up, the centre of the arch the origin.
pub type Point = [f64; 2];

/// A stone: corners counter-clockwise, from the intrados of its right joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// The corners. The faces between the joints are chords: a stone is a sector of the ring.
    pub polygon: [Point; 4],
    /// `t r` times its angle: the area of the sector, its weight at unit weight and unit depth.
    pub weight: f64,
    /// The point at which the weight acts.
    pub centroid: Point,
}

/// Bodies of an assembly, from the left springing to the right one, each number within one unit in the last place of
/// the nearest double.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Blocks {
    /// Radius of the centreline.
    pub radius: f64,
    /// The stones.
    pub stones: Vec<Block>,
    /// The ground at the left and at the right springing: a piece of the ring that goes on below it.
    pub supports: [[Point; 4]; 2],
    /// The joints between them, the springings first and last: intrados, then extrados.
    pub joints: Vec<[Point; 2]>,
}

/// Bits in which they are computed.
const BITS: u32 = 192;

impl Blocks {
    /// Bodies of an assembly; `None` if it has no radius.
    pub fn of(assembly: &Assembly) -> Option<Self> {
        let stones = assembly.stones.number();
        let radius: Ball = assembly.radius()?.enclosure(BITS);
        let ring = Ring::new(assembly.weight, &assembly.thickness.enclosure::<Ball>(BITS));
        let half_opening: Ball = assembly.stones.half_opening().enclosure(BITS);
        let one = radius.int(1);
        let half = ring.thickness.clone() / one.int(2);
        let radii = [one.clone() - &half, one.clone() + &half].map(|x| x * &radius);
        let at = |angle: &Angle<Ball>, radius: &Ball, is_right: bool| {
            let x = (radius.clone() * &angle.sin).mid().to_f64();
            let y = (radius.clone() * &angle.cos).mid().to_f64();
            // Zero has one sign.
            [if is_right { x } else { -x } + 0.0, y]
        };
        let ends = |angle: &Angle<Ball>, is_right| {
            radii.each_ref().map(|radius| at(angle, radius, is_right))
        };
        let joints: Vec<[Point; 2]> = (0..=stones)
            .map(|joint| {
                let from_crown = ((2 * joint).abs_diff(stones) - stones % 2) / 2;
                ends(&assembly.stones.angle(from_crown, BITS), 2 * joint >= stones)
            })
            .collect();
        let share =
            |parts: u64| half_opening.clone() * one.int(parts as i32) / one.int(stones as i32);
        let half_stone = share(1);
        let sine = half_stone.clone().sin_cos().0 / &half_stone;
        let arm = ring.centroid_factor.clone() * &radius * sine;
        let weight = ring.thickness.clone() * &radius * &radius * share(2);
        let stone = |index: u64| {
            let middle = Angle::new(share((2 * index + 1).abs_diff(stones)));
            let [right, left] = [index + 1, index].map(|joint| joints[joint as usize]);
            Block {
                polygon: [right[0], right[1], left[1], left[0]],
                weight: weight.mid().to_f64(),
                centroid: at(&middle, &arm, 2 * index + 1 >= stones),
            }
        };
        let left = (one.pi() - &half_opening) / one.int(2);
        let wide = share(2);
        let ground = if wide.mid() < left.mid() { wide } else { left };
        let below = Angle::new(half_opening.clone() + ground);
        let support = |is_right: bool| {
            let [low, joint] =
                [ends(&below, is_right), joints[if is_right { stones as usize } else { 0 }]];
            let [right, left] = if is_right { [low, joint] } else { [joint, low] };
            [right[0], right[1], left[1], left[0]]
        };
        Some(Self {
            radius: radius.mid().to_f64(),
            stones: (0..stones).map(stone).collect(),
            supports: [support(false), support(true)],
            joints: joints.clone(),
        })
    }
}
