//! All vertices and all thicknesses.
//!
//! Each triple of conditions is looked at on the whole range of thicknesses; a piece on which nothing is proved of
//! it is halved. A triple and its mirror image share their fate.

use super::conditions::{Conditions, Minors};
use super::event::{Event, event};
use super::line;
use super::vertex::{Passing, SweepStart, ThicknessPiece, Vertex, in_doubles};
use crate::arch::mechanism::Contact;
use crate::number::DoubleBall;
use rayon::prelude::*;

/// Rest of the range of thicknesses.
#[derive(Debug, Default)]
pub(super) struct Swept {
    /// Solutions, each alone on its piece.
    pub events: Vec<Event>,
    /// Pieces on which nothing is proved.
    pub open: Vec<ThicknessPiece>,
    /// Number of triples.
    pub triples: u64,
    /// Number of pieces that were looked at.
    pieces: usize,
}

/// Pieces of a triple at most.
const PIECES: usize = 4_000;
/// Pieces for each triple, of all with the same first condition together, beyond those of one. In arches from 0.1 rad
/// on, of 4 to 60 stones, of which nothing stays open, at most 11 are needed.
const PIECES_EACH: usize = 40;
/// Open pieces of all triples with the same first condition at most: as the answer is undecided then, the rest is left
/// open too. So it is in an arch of a millionth of a radian, whose polynomials doubles do not tell from zero.
const OPEN: usize = 100;
/// Halvings at most.
const DEPTH: u32 = 44;
/// Until so many halvings a piece is halved where a triple seems to be no vertex.
const COARSE: u32 = 10;
/// From so many halvings on three conditions are looked at that may be dependent.
const NARROW: u32 = 6;

impl Swept {
    fn with(mut self, other: Self) -> Self {
        self.events.extend(other.events);
        self.open.extend(other.open);
        self.triples += other.triples;
        self.pieces += other.pieces;
        self
    }
}

/// Looks at all triples of conditions of the whole arch, or pairs of the half, on a range of thicknesses.
pub(super) fn sweep(
    conditions: &Conditions<DoubleBall>,
    range: ThicknessPiece,
    start: Option<&SweepStart>,
) -> Swept {
    let rows = in_doubles(conditions);
    let count = conditions.all.len();
    let with_first = |i: usize| {
        let seconds = i + 1..count;
        let all: Vec<Vec<usize>> = match conditions.rank() {
            2 => seconds.map(|j| vec![i, j]).collect(),
            _ => seconds.flat_map(|j| (j + 1..count).map(move |k| vec![i, j, k])).collect(),
        };
        let most = PIECES + PIECES_EACH * all.len();
        // What passes one passes the next, where the last condition is of the same kind.
        let mut passed = [[i, i]; Contact::ALL.len()];
        let mut known: Option<(usize, Minors<DoubleBall>)> = None;
        let mut look = |before: Swept, of: Vec<usize>| {
            let pair = known.take().filter(|(second, _)| *second == of[1]);
            let pair = pair.unwrap_or_else(|| (of[1], conditions.minors(&of)));
            let (_, minors) = known.insert(pair);
            let is_left = before.pieces > most || before.open.len() > OPEN;
            let passed = &mut passed[of[of.len() - 1] % Contact::ALL.len()];
            let found = match conditions.mirrored(&of) < of {
                false if is_left && before.open.last() == Some(&range) => Swept::default(),
                false if is_left => Swept { open: vec![range], ..Swept::default() },
                false => one(Vertex::new(conditions, of, minors), range, start, (&rows, passed)),
                true => Swept::default(),
            };
            before.with(Swept { triples: 1, ..found })
        };
        all.into_iter().fold(Swept::default(), &mut look)
    };
    let parts: Vec<Swept> = (0..count).into_par_iter().map(with_first).collect();
    parts.into_iter().fold(Swept::default(), Swept::with)
}

fn one(
    mut vertex: Vertex<'_>,
    range: ThicknessPiece,
    start: Option<&SweepStart>,
    (rows, before): (&[[[f64; 3]; 4]], &mut [usize; 2]),
) -> Swept {
    let mut found = Swept::default();
    let mut pending = vec![(range, 0)];
    while let Some((piece, depth)) = pending.pop() {
        found.pieces += 1;
        if found.pieces > PIECES || depth > DEPTH || found.open.len() > OPEN {
            found.open.push(piece);
            continue;
        }
        let passed = vertex.is_passed_by_one(&piece, rows, before);
        if passed == Passing::Proved {
            continue;
        }
        if depth >= NARROW
            && vertex.may_be_dependent(&piece)
            && line::bears_no_motion(&vertex, &piece)
        {
            continue;
        }
        if passed == Passing::Unlikely || depth > COARSE {
            let Some(others) = vertex.near(&piece, start) else { continue };
            if vertex.bears_no_motion(&others, &piece) {
                continue;
            }
            if let Some(event) = event(&mut vertex, &piece, range, start) {
                found.events.push(event);
                continue;
            }
        }
        let Some([lower, upper]) = piece.halves() else {
            found.open.push(piece);
            continue;
        };
        pending.extend([(upper, depth + 1), (lower, depth + 1)]);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::{Arch, Extent};

    /// An arch so flat that doubles do not tell its conditions from zero costs no more pieces than one that is decided.
    #[test]
    fn a_tiny_arch_is_left_open_soon() {
        let swept = |alpha: &str, stones| {
            let arch = Arch::parse("milankovitch", alpha, "0.6").unwrap();
            let conditions = Conditions::new(&arch, stones, Extent::Whole, 106);
            sweep(&conditions, ThicknessPiece { low: 0.0, high: 2.0 }, None)
        };
        for stones in [4, 6, 8] {
            let triples = swept("1", stones).triples;
            for alpha in ["1e-5", "1e-7", "1e-9"] {
                let Swept { open, pieces, triples: all, .. } = swept(alpha, stones);
                assert!(!open.is_empty() && all == triples, "{alpha} {stones}");
                assert!(pieces as u64 <= 60 * triples, "{alpha} {stones}: {pieces} of {triples}");
            }
        }
    }
}
