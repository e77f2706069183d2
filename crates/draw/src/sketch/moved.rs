//! The blocks after a finite motion.

use super::collapse::Collapse;
use super::scale::{faces, polar};
use crate::arch::Configuration;
use crate::arch::mechanism::{Motion, moves_keystone};
use crate::number::Drawable;

/// The blocks of a mode, from the shoulder, where they have moved to.
#[derive(Clone, Debug)]
pub struct Moved {
    /// The blocks: those of the mechanism that have an extent.
    pub blocks: Vec<Block>,
    /// Distance by which the corner that moved most has moved, in units of `r`.
    pub by: f64,
}

/// A rigid block of the right half.
#[derive(Clone, Debug)]
pub struct Block {
    /// Number of the block in the mechanism: the place of its twist.
    pub place: usize,
    /// Joints nearer to the crown and to the shoulder, rad.
    pub between: [f64; 2],
    /// Motion by which it is where it is.
    pub motion: Motion<f64>,
}

impl Block {
    /// Corners of the block at rest, at two radii, to the right and up.
    pub fn corners(&self, radii: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
        self.between.into_iter().flat_map(move |joint| radii.map(|radius| polar(joint, radius)))
    }

    /// Distance by which the corner that moved most has moved; what is no number is too far.
    pub(super) fn by(&self, radii: [f64; 2]) -> f64 {
        let away = self.corners(radii).map(|corner| {
            let to = self.motion.to(&corner);
            (to[0] - corner[0]).hypot(to[1] - corner[1])
        });
        away.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
    }
}

/// A block narrower than this part of the half arch is none.
const NARROW: f64 = 1e-9;
/// Halvings of the parameter.
const HALVINGS: u32 = 60;
/// Relative distance from an amplitude at which it counts as reached, but for the halvings.
const REACHED: f64 = 1e-9;
/// The parameter, an angle or a slip, is less.
const LARGEST: f64 = 1.5;

/// The blocks from the shoulder, moved so far that no corner has moved by more than `amplitude`, in units of `r`,
/// and one by so much, or as far as they go: thin arches are flat before.
pub fn moved<T: Drawable>(collapse: &Collapse<T>, at: &Configuration<T>, amplitude: f64) -> Moved {
    let at = at.map_ref(T::double);
    let dilatancy = if collapse.is_dilatant { at.friction } else { 0.0 };
    let ends: Vec<f64> =
        collapse.mechanism.joints.iter().map(|joint| joint.at.rad.double()).collect();
    let blocks = |by: f64| -> Vec<Block> {
        let mut moves = collapse.mode.moves(&at, &by, &dilatancy);
        // A keystone is one block more.
        let keystone = moves.last().filter(|_| moves.len() < ends.len());
        let keystone = keystone.map(|below| moves_keystone(&at, below));
        moves.extend(keystone);
        let uppers = ends.iter().copied().skip(1).chain([0.0]);
        let all = ends.iter().zip(uppers).zip(moves).enumerate();
        let all = all.map(|(place, ((lower, upper), motion))| Block {
            place,
            between: [upper, *lower],
            motion,
        });
        let narrow = NARROW * at.half_opening.rad;
        all.filter(|block| block.between[1] - block.between[0] > narrow).collect()
    };
    let radii = faces(at.thickness);
    let largest = |by: f64| blocks(by).iter().map(|block| block.by(radii)).fold(0.0, f64::max);
    let (mut low, mut high) = (0.0, LARGEST);
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if largest(middle) <= amplitude { low = middle } else { high = middle }
    }
    let by = largest(low);
    Moved {
        blocks: blocks(low),
        by: if amplitude - by < REACHED * amplitude { amplitude } else { by },
    }
}
