//! Proofs about the solutions of (19) between equal stones.

use crate::arch::mechanism::Contact;
use crate::arch::whole::Side;
use crate::number::Rounded;
use crate::problem::Extent;
use crate::prover::{Figure, Undecided};
use rug::Float;

/// A solution at the joints between equal stones, with its digits, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct JointedSolution {
    /// True if the solution's state and its motion are symmetric; the mirror image of another one is a solution too.
    pub is_symmetric: bool,
    /// `eta`.
    pub thickness: Figure,
    /// `h`.
    pub thrust: Figure,
    /// `p`, the moment of the forces in the crown about the centre.
    pub crown_moment: Figure,
    /// `v`, the part of the weight of the right half that the left one carries; zero in a symmetric state.
    pub vertical_force: Figure,
    /// The joints that give way, from the right springing to the left, or to the crown of a half arch.
    pub joints: Vec<JointedMotion>,
}

/// A joint that gives way.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct JointedMotion {
    /// Limit that it is at, on its side.
    pub contact: Contact,
    /// Side of the crown; `None` at the crown.
    pub side: Option<Side>,
    /// The angle from the crown, rad.
    pub angle: Figure,
    /// The rotation, or the slip in units of `r`, where the hinges of each face turn by one together.
    pub rate: Figure,
}

/// The thicknesses at which there is an admissible state.
#[derive(Clone, Debug)]
pub enum Standing<T = Box<Figure>> {
    /// Every thickness from this one on stands, up to 2.
    From(T),
    /// Every thickness stands, up to 2.
    Always,
    /// None up to 2.
    Never,
}

/// The solution at the least thickness, or that there is no such thickness.
pub type LeastSolution = Standing<Box<JointedSolution>>;

/// All solutions between equal stones.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Enumeration {
    /// States that are looked at.
    pub extent: Extent,
    /// The stones of the whole arch.
    pub stones: u64,
    /// Thicknesses at which there is anything admissible.
    pub standing: Standing,
    /// The solutions, thin arches first, each alone at its thickness but for its mirror image; or why the digits of
    /// one stay open.
    pub solutions: Vec<Result<JointedSolution, Undecided>>,
    /// The pieces of `(0, 2]` on which nothing is proved, by their bounds. On all the rest there are no other
    /// solutions.
    pub open: Vec<[f64; 2]>,
    /// The triples of conditions that are looked at, or the pairs of a half arch.
    pub triples: u64,
}

impl Enumeration {
    /// Tells whether it is proved that no thickness above the least one has a solution, up to 2.
    pub fn ends_at_the_least(&self) -> bool {
        let is_symmetric =
            |of: &Result<JointedSolution, _>| of.as_ref().is_ok_and(|of| of.is_symmetric);
        self.open.is_empty() && self.solutions.iter().all(is_symmetric)
    }

    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<Undecided> {
        let open = self.solutions.iter().find_map(|solution| solution.as_ref().err());
        let piece = || {
            let [low, high] = self.open_bounds().next()?;
            let more = match self.open.len() {
                1 => String::new(),
                n => format!(", and on {} more such pieces", n - 1),
            };
            Some(Undecided::new(format!(
                "whether there is a solution at a thickness from {low} to {high}{more}"
            )))
        };
        open.cloned().or_else(piece)
    }

    /// The bounds of the open pieces, rounded outward.
    pub fn open_bounds(&self) -> impl Iterator<Item = [String; 2]> {
        let rounded = |x: f64| Rounded::from_rational(&Float::with_val(64, x).to_rational()?, 6);
        self.open.iter().filter_map(move |piece| {
            let [low, high] = piece.map(rounded);
            Some([low?.lower.to_string(), high?.upper.to_string()])
        })
    }
}
