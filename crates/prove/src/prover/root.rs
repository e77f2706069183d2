//! One root of equations next to a start value, in balls of as many bits as are asked for.
//!
//! That it is there, and the only one, is proved in few bits; the `ladder` leads to all of them.

use super::Undecided;
use super::ladder::{FEW, Ladder, Rooted, Unique};
pub use super::operator::Form;
use super::operator::box_around;

use crate::number::{Ball, Dual};
use crate::solve::settle;
use rug::Float;

/// Up to this precision all cost about the same.
const SHORT: u32 = 512;

/// Encloses the root of equations next to a start value, proved to exist and to be unique in a box on which
/// the equations are regular.
pub fn root_near<S: Form<Ball>>(
    equations: &S,
    bits: u32,
    start: Vec<Float>,
) -> Result<Vec<Ball>, Undecided> {
    rooted_near(equations, bits, &start).map(|root| root.values)
}

/// The root next to a start value, with the sines and cosines that it took.
pub fn rooted_near<S: Form<Ball>>(
    equations: &S,
    bits: u32,
    start: &[Float],
) -> Result<Rooted, Undecided> {
    if let Some(root) = by_ladder(equations, bits, start) {
        return Ok(root);
    }
    let [_, values] = box_near(equations, bits, start, false)?;
    Ok(Rooted { values, ..Rooted::default() })
}

/// The root from its proof in as few bits as tell it; `None` where not even a part of all is enough, or this is not
/// worth while.
fn by_ladder(form: &impl Form<Ball>, bits: u32, start: &[Float]) -> Option<Rooted> {
    let precisions = std::iter::successors(Some(FEW), |few| Some(2 * few));
    let unique = precisions.take_while(|few| 2 * few < bits).find_map(|few| {
        let [domain, image] = box_near(form, few, start, true).ok()?;
        Unique::new(domain, &image, few)
    })?;
    Ladder { form, unique: &unique, tick: &|| () }.refined(bits).ok()
}

/// A box next to a start value in which exactly one root lies, and its image; a `wide` one or a narrow one.
pub(super) fn box_near<S: Form<Ball>>(
    equations: &S,
    bits: u32,
    start: &[Float],
    wide: bool,
) -> Result<[Vec<Ball>; 2], Undecided> {
    let centre = climb(equations, bits, start).ok_or_else(Undecided::no_solution)?;
    box_around(equations, bits, &centre, wide)
}

/// The precisions up to some bits, each half of the next, from the first that costs as much as any below it.
pub fn precisions(bits: u32) -> Vec<u32> {
    let halves =
        std::iter::successors(Some(bits), |bits| (*bits > SHORT).then(|| bits.div_ceil(2)));
    let mut precisions: Vec<u32> = halves.collect();
    precisions.reverse();
    precisions
}

/// Newton's method with more and more bits: at each precision it starts from the root to half of it.
fn climb(form: &impl Form<Ball>, bits: u32, start: &[Float]) -> Option<Vec<Float>> {
    let settled = |x: Vec<Float>, bits| {
        let x = x.iter().map(|x| Float::with_val(bits, x)).collect();
        let number = |given: &Ball| Dual::constant(Float::with_val(bits, given.mid()));
        settle(x, |x| form.at(number, &Dual::variables(x)))
    };
    // Where the equations lose more digits than the first precision has, only the last is of use.
    let root = precisions(bits).into_iter().try_fold(start.to_vec(), settled);
    root.or_else(|| settled(start.to_vec(), bits))
}
