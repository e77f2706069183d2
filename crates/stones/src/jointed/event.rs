//! A solution of (19) on a piece of thicknesses, which has no other one there.
//!
//! At a vertex one more condition becomes zero, or the motions of its own begin to fit with each other. Either is
//! the zero of a polynomial: with a slope that keeps its sign, and two signs at the ends, there is exactly one.
//! **There** the state is admissible, as all other conditions keep their sign, and the rates are positive.
//! **Elsewhere** on the piece only the vertex's own conditions are zero, and no motion fits.

use super::conditions::Conditions;
use super::polynomial::ShortPolynomial;
use super::vertex::{SweepStart, ThicknessPiece, Vertex};
use crate::number::{DoubleBall, Enclosure, Field};

/// A solution that is alone on a piece.
#[derive(Clone, Debug)]
pub(super) struct Event {
    pub kind: EventKind,
    /// Piece on which it lies.
    pub piece: ThicknessPiece,
}

/// Quantity that is zero there.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum EventKind {
    /// One condition more than fix the forces: the first ones, and that one.
    Statics(Vec<usize>, usize),
    /// The determinant of three motions, of which the rates follow from these equations.
    Motion([usize; 3], [usize; 2]),
}

impl EventKind {
    /// The conditions that are zero.
    pub(super) fn conditions(&self) -> Vec<usize> {
        let mut all = match self {
            Self::Statics(of, other) => of.iter().copied().chain([*other]).collect(),
            Self::Motion(of, _) => of.to_vec(),
        };
        all.sort_unstable();
        all
    }
}

/// A piece is looked at with so much of it on both sides.
const MARGIN: f64 = 0.25;

/// The solution on a piece or next to it, if it can be proved, and that there is no other one for this vertex.
pub(super) fn event(
    vertex: &mut Vertex<'_>,
    piece: &ThicknessPiece,
    range: ThicknessPiece,
    start: Option<&SweepStart>,
) -> Option<Event> {
    let room = MARGIN * (piece.high - piece.low);
    let piece = ThicknessPiece {
        low: (piece.low - room).max(range.low),
        high: (piece.high + room).min(range.high),
    };
    if start.is_some_and(|start| piece.low == start.below) || !vertex.is_regular(&piece) {
        return None;
    }
    let others = vertex.near(&piece, start)?;
    let kind = match others[..] {
        [] => motion(vertex, &piece)?,
        [other] => statics(vertex, other, &piece)?,
        _ => return None,
    };
    Some(Event { kind, piece })
}

/// Tells whether a polynomial is zero exactly once on a piece.
fn is_once_zero(polynomial: &ShortPolynomial<DoubleBall>, piece: &ThicknessPiece) -> bool {
    let [low, high] = [piece.low, piece.high].map(|x| polynomial.at(&DoubleBall::exact(x)));
    polynomial.derivative().on(&piece.ball()).excludes_zero()
        && low.excludes_zero()
        && high.excludes_zero()
        && (low.mid() > 0.0) != (high.mid() > 0.0)
}

/// Tells whether all rates have the same sign on a piece.
fn have_one_sign(rates: &[ShortPolynomial<DoubleBall>], piece: &ThicknessPiece) -> bool {
    let ball = piece.ball();
    let all = |sign: i32| {
        rates.iter().all(|rate| (ball.int(sign) * rate.on(&ball)).is_positive().is_proved())
    };
    all(1) || all(-1)
}

fn statics(vertex: &Vertex<'_>, other: usize, piece: &ThicknessPiece) -> Option<EventKind> {
    let mut all = vertex.of.clone();
    all.push(other);
    let rates = vertex.conditions().rates(&all);
    let is_solution = is_once_zero(&vertex.value(other), piece) && have_one_sign(&rates, piece);
    // Where the other one is not zero, these alone have to do.
    let is_alone = vertex.bears_no_motion(&[], piece);
    (is_solution && is_alone).then(|| EventKind::Statics(vertex.of.clone(), other))
}

fn motion(vertex: &Vertex<'_>, piece: &ThicknessPiece) -> Option<EventKind> {
    let of: [usize; 3] = vertex.of.clone().try_into().ok()?;
    let conditions: &Conditions<DoubleBall> = vertex.conditions();
    if !is_once_zero(&conditions.determinant(&of), piece) {
        return None;
    }
    let by = [[0, 1], [0, 2], [1, 2]]
        .into_iter()
        .find(|by| have_one_sign(&conditions.rates_of_three(&of, *by), piece))?;
    Some(EventKind::Motion(of, by))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::mechanism::Contact;
    use crate::problem::Arch;
    use crate::problem::Extent;

    fn conditions(mu: &str) -> Conditions<DoubleBall> {
        let arch = Arch::parse("milankovitch", "2.3", mu).unwrap();
        Conditions::new(&arch, 8, Extent::Whole, 106)
    }

    /// Knowledge of three conditions on a piece: whether a solution is proved there, and whether it is proved
    /// that there is none.
    fn known(mu: &str, of: &[(Contact, i32)], [low, high]: [f64; 2]) -> [bool; 2] {
        let conditions = conditions(mu);
        let places = of.iter().map(|at| conditions.place(at.0, at.1).unwrap());
        let mut places: Vec<usize> = places.collect();
        places.sort_unstable();
        let (piece, range) =
            (ThicknessPiece { low, high }, ThicknessPiece { low: 0.52, high: 2.0 });
        let minors = conditions.minors(&places);
        let mut vertex = Vertex::new(&conditions, places, &minors);
        let near = vertex.near(&piece, None);
        let nothing = near.is_none_or(|near| vertex.bears_no_motion(&near, &piece));
        [event(&mut vertex, &piece, range, None).is_some(), nothing]
    }

    /// Next to the asymmetric solution at 0.684421733 it is proved, and elsewhere that there is none: on a piece
    /// beside it, with another friction, with a condition that moves the other way, or with three that are no
    /// vertex there.
    #[test]
    fn a_solution_is_proved_where_it_is_and_refused_elsewhere() {
        use Contact::{Extrados, Intrados, Inwards, Outwards};
        let of = [(Outwards, 8), (Extrados, 0), (Outwards, 0)];
        assert_eq!(known("1.05", &of, [0.6843, 0.6846]), [true, false]);
        assert_eq!(known("1.05", &of, [0.6860, 0.6863]), [false, true]);
        assert_eq!(known("1.06", &of, [0.6843, 0.6846]), [false, true]);
        let turned = [(Outwards, 8), (Extrados, 0), (Inwards, 0)];
        assert_eq!(known("1.05", &turned, [0.6843, 0.6846]), [false, true]);
        let passed = [(Intrados, 8), (Extrados, 0), (Outwards, 0)];
        assert_eq!(known("1.05", &passed, [0.6843, 0.6846]), [false, true]);
        // The mirror image has the same thickness.
        let mirrored = [(Inwards, -8), (Extrados, 0), (Inwards, 0)];
        assert_eq!(known("1.05", &mirrored, [0.6843, 0.6846]), [true, false]);
        // A piece that ends at the solution, and one that is too wide to tell.
        assert_eq!(known("1.05", &of, [0.6844, 0.684_421_733]), [true, false]);
        assert_eq!(known("1.05", &of, [0.6, 1.2]), [false, false]);
    }
}
