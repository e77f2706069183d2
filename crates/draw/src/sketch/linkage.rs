//! The blocks of the whole arch between four joints that give way, after a finite motion.
//!
//! Right of the first joint and left of the last there is the ground. The relative twists of the joints add up to
//! zero, which are three equations for the ratios of their rates: the blocks move as a four-bar linkage does, or as one
//! with slides. The motion is followed in small steps, for the eye.

use super::moved::{Block, Moved};
use super::scale::faces;
use crate::arch::mechanism::{Contact, Motion, Twist};
use crate::number::Angle;

/// Four joints that give way together, from the right springing to the left one.
#[derive(Clone, Debug)]
pub struct Linkage {
    /// Contact of each, by its sign, and its angle from the crown, rad, positive on the right.
    pub joints: [(Contact, f64); 4],
    /// The thickness, in units of `r`.
    pub thickness: f64,
}

/// Angle and shift of each block.
type Place = [[f64; 3]; 3];

/// Steps in which an amplitude is reached, about; and the most.
const STEPS: f64 = 60.0;
const MOST: u32 = 600;
/// Halvings of the last step.
const HALVINGS: u32 = 40;

impl Linkage {
    /// The blocks from the right, moved so far that the corner that moves most has moved by `amplitude`, in units of
    /// `r`, or as far as they go; and by how much it has. `None` if not every rate is positive at rest.
    pub fn moved(&self, amplitude: f64) -> Option<Moved> {
        let mut place: Place = [[0.0; 3]; 3];
        let speed = self.velocities(&place)?;
        let fastest = |block: &Block| {
            let [turn, x, y] = speed[block.place];
            let corners = block.corners(faces(self.thickness));
            corners.map(|at| (x - turn * at[1]).hypot(y + turn * at[0])).fold(0.0, f64::max)
        };
        let fastest = self.blocks(&place).iter().map(fastest).fold(f64::MIN_POSITIVE, f64::max);
        let step = amplitude / STEPS / fastest;
        for _ in 0..MOST {
            let Some(next) = self.stepped(&place, step) else { break };
            if self.largest(&next) < amplitude {
                place = next;
                continue;
            }
            let (mut low, mut high) = (0.0, step);
            for _ in 0..HALVINGS {
                let middle = (low + high) / 2.0;
                let beyond =
                    self.stepped(&place, middle).is_none_or(|at| self.largest(&at) > amplitude);
                if beyond { high = middle } else { low = middle }
            }
            place = self.stepped(&place, low).unwrap_or(place);
            break;
        }
        // Where two joints give way at one place, the arch comes apart there, and nothing is between them.
        let has_width = |block: &Block| block.between[0] < block.between[1];
        let blocks = self.blocks(&place).into_iter().filter(has_width).collect();
        Some(Moved { blocks, by: self.largest(&place) })
    }

    /// The blocks where they are.
    fn blocks(&self, at: &Place) -> [Block; 3] {
        std::array::from_fn(|k| Block {
            place: k,
            between: [self.joints[k + 1].1, self.joints[k].1],
            motion: motion(&at[k]),
        })
    }

    /// A step of the fourth order.
    fn stepped(&self, at: &Place, by: f64) -> Option<Place> {
        let plus = |v: &Place, share: f64| -> Place {
            std::array::from_fn(|k| std::array::from_fn(|i| at[k][i] + by * share * v[k][i]))
        };
        let a = self.velocities(at)?;
        let b = self.velocities(&plus(&a, 0.5))?;
        let c = self.velocities(&plus(&b, 0.5))?;
        let d = self.velocities(&plus(&c, 1.0))?;
        let mean = |k: usize, i: usize| (a[k][i] + 2.0 * (b[k][i] + c[k][i]) + d[k][i]) / 6.0;
        let mean: Place = std::array::from_fn(|k| std::array::from_fn(|i| mean(k, i)));
        Some(plus(&mean, 1.0))
    }

    /// Velocities of each block's angle and shift, the rates adding up to one; `None` if not all are positive.
    fn velocities(&self, at: &Place) -> Option<Place> {
        // Each joint moves with the block on its right.
        let twist = |k: usize| -> [f64; 3] {
            let (contact, angle) = self.joints[k];
            let Twist { rotation, velocity } =
                contact.twist(&Angle::new(angle), &self.thickness, &0.0);
            let right = if k == 0 { motion(&[0.0; 3]) } else { motion(&at[k - 1]) };
            let moved = Motion { shift: [0.0; 2], ..right.clone() }.to(&velocity);
            // What turned about a point turns about where that is now.
            let [x, y] = right.shift;
            [rotation, moved[0] + rotation * y, moved[1] - rotation * x]
        };
        let twists: [[f64; 3]; 4] = std::array::from_fn(twist);
        let determinant = |[a, b, c]: [[f64; 3]; 3]| {
            a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        let [a, b, c, d] = twists;
        let rates = [
            determinant([b, c, d]),
            -determinant([a, c, d]),
            determinant([a, b, d]),
            -determinant([a, b, c]),
        ];
        let sum: f64 = rates.iter().sum();
        let rates = rates.map(|rate| rate / sum);
        if !rates.iter().all(|rate| *rate > 0.0) {
            return None;
        }
        let mut sum = [0.0; 3];
        let mut velocities = [[0.0; 3]; 3];
        for k in 0..3 {
            for i in 0..3 {
                sum[i] += rates[k] * twists[k][i];
            }
            // The place of a block is its turn and where the centre of the arch goes.
            let [turn, x, y] = sum;
            let [_, right, up] = at[k];
            velocities[k] = [turn, x - turn * up, y + turn * right];
        }
        Some(velocities)
    }

    /// Distance by which the corner that moved most has moved.
    fn largest(&self, at: &Place) -> f64 {
        let radii = faces(self.thickness);
        self.blocks(at).iter().map(|block| block.by(radii)).fold(0.0, f64::max)
    }
}

fn motion([turn, x, y]: &[f64; 3]) -> Motion<f64> {
    let (sin, cos) = turn.sin_cos();
    Motion { turn: [cos, sin], shift: [*x, *y] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sketch::polar;
    use Contact::{Extrados, Intrados, Inwards, Outwards};

    fn linkage(joints: [(Contact, f64); 4]) -> Linkage {
        Linkage { joints, thickness: 0.15 }
    }

    fn place((contact, joint): (Contact, f64), thickness: f64) -> [f64; 2] {
        let face = if contact == Extrados { 0.5 } else { -0.5 };
        polar(joint, 1.0 + face * thickness)
    }

    /// Four hinges in turn at both faces: blocks stay together at them, and on the ground.
    #[test]
    fn hinges_stay_together() {
        let of = linkage([(Extrados, 1.5), (Intrados, 0.5), (Extrados, -0.4), (Intrados, -1.3)]);
        for amplitude in [0.01, 0.1, 0.2] {
            let Moved { blocks, by } = of.moved(amplitude).unwrap();
            assert!((by - amplitude).abs() < 1e-9, "{by}");
            for (k, joint) in of.joints.into_iter().enumerate() {
                let point = place(joint, of.thickness);
                let to = |k: Option<usize>| match k.and_then(|k| blocks.get(k)) {
                    Some(block) => block.motion.to(&point),
                    None => point,
                };
                let (right, left) = (to(k.checked_sub(1)), to(Some(k)));
                assert!(
                    (right[0] - left[0]).hypot(right[1] - left[1]) < 1e-8,
                    "{k} {right:?} {left:?}"
                );
            }
        }
    }

    /// A joint that slides stays closed: its faces move along each other.
    #[test]
    fn what_slides_stays_closed() {
        let of = linkage([(Outwards, 1.5), (Intrados, 0.6), (Extrados, -0.3), (Intrados, -1.2)]);
        let blocks = of.moved(0.1).unwrap().blocks;
        let (sin, cos) = 1.5f64.sin_cos();
        let moved = blocks[0].motion.to(&[sin, cos]);
        // On the ground the joint has not turned.
        assert!(((moved[0] - sin) * cos - (moved[1] - cos) * sin).abs() < 1e-9);
        assert!((moved[0] - sin) * sin + (moved[1] - cos) * cos > 0.01, "outwards");
        assert!((blocks[0].motion.turn[1]).abs() < 1e-12);
    }

    #[test]
    fn what_cannot_move_is_not_moved() {
        for joints in [
            [(Extrados, 1.5), (Extrados, 0.5), (Extrados, -0.4), (Intrados, -1.3)],
            [(Intrados, 1.5), (Intrados, 0.5), (Intrados, -0.4), (Intrados, -1.3)],
            [(Inwards, 1.5), (Intrados, 0.5), (Extrados, -0.4), (Extrados, -1.3)],
        ] {
            assert!(linkage(joints).moved(0.1).is_none(), "{joints:?}");
        }
    }
}
