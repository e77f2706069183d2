//! A vertex of the admissible forces, as it moves with the thickness.
//!
//! Three conditions that are zero together, or two of a half arch, leave one state for each thickness, `(h, p, v) = (M_0, M_1, M_2)/M_3`
//! with polynomials `M` in the thickness, and `M_3` the determinant of their rows. Any other condition there is `D/M_3` with a
//! polynomial `D` too. So on a piece of thicknesses, without a quotient:
//!
//! - **It is no vertex** if `M_3 <= 0` or some `D > 0` on the piece, and `M_3 >= 0` or some `D < 0`.
//! - **At most those conditions are zero with it** whose `D` may vanish on the piece.
//! - **It bears no motion** if some `y` has `y . b > 0` for the motions `b` of its conditions and of all those: then no
//!   rates but zero fit. Each `b` is linear in the thickness. Where both slips of a joint are among them there is such a `y` without the one, and
//!   one without the other.

use super::conditions::Conditions;
use super::polynomial::Polynomial;
use crate::arch::mechanism::Contact;
use crate::number::{DoubleBall, Enclosure};
use crate::solve::rates::parting;

/// A piece of thicknesses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece {
    pub low: f64,
    pub high: f64,
}

impl Piece {
    /// A ball that holds it.
    pub(super) fn ball(&self) -> DoubleBall {
        let [low, high] = [self.low, self.high].map(DoubleBall::exact);
        let middle = DoubleBall::exact(self.middle());
        let [below, above] = [middle - low, high - middle];
        middle.widened(below.size().max(above.size()))
    }

    /// A number in it.
    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

/// What is known of three conditions on a piece.
#[derive(Clone, Debug)]
pub(super) struct Near {
    /// The conditions that may be zero with them, where they may be a vertex.
    pub others: Vec<usize>,
}

/// What is exactly so at the least thickness.
#[derive(Clone, Debug)]
pub(super) struct Start {
    /// A double below the least thickness and next to it.
    pub below: f64,
    /// Conditions that are all zero in the state there.
    pub touching: Vec<usize>,
}

/// Three conditions, or two of a half arch.
pub(super) struct Vertex<'a> {
    conditions: &'a Conditions<DoubleBall>,
    /// Their places, in order.
    pub of: Vec<usize>,
    meeting: [Polynomial<DoubleBall>; 4],
    /// The other conditions there, when they are needed.
    values: Vec<Polynomial<DoubleBall>>,
}

fn is_positive(x: &DoubleBall) -> bool {
    x.is_positive().is_proved()
}

fn is_negative(x: &DoubleBall) -> bool {
    is_positive(&-*x)
}

impl<'a> Vertex<'a> {
    /// The vertex of these conditions.
    pub(super) fn new(conditions: &'a Conditions<DoubleBall>, of: Vec<usize>) -> Self {
        let meeting = conditions.meeting(&of);
        Self { conditions, of, meeting, values: Vec::new() }
    }

    /// The sign that is left to the common factor on a piece: positive, negative.
    fn signs(&self, piece: &DoubleBall) -> [bool; 2] {
        let factor = self.meeting[3].on(piece);
        [factor.upper() > 0.0 && !is_zero(&factor), factor.lower() < 0.0 && !is_zero(&factor)]
    }

    /// Whether a single condition shows that it is no vertex on a piece; a guess says which.
    pub(super) fn is_passed_by_one(&self, piece: &Piece, rows: &[[[f64; 3]; 4]]) -> Passed {
        let ball = piece.ball();
        let [mut plus, mut minus] = self.signs(&ball);
        let x = piece.middle();
        let at: [f64; 4] = std::array::from_fn(|k| self.meeting[k].near(x));
        let (mut most, mut least) = ((0, 0.0), (0, 0.0));
        for (place, row) in rows.iter().enumerate() {
            let entry = |k: usize| (row[k][2] * x + row[k][1]) * x + row[k][0];
            let value = entry(0) * at[0] + entry(1) * at[1] + entry(2) * at[2] + entry(3) * at[3];
            if value > most.1 {
                most = (place, value);
            }
            if value < least.1 {
                least = (place, value);
            }
        }
        let size = at.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let seems_passed = match at[3] > 0.0 {
            true => most.1 > CLEAR * size,
            false => -least.1 > CLEAR * size,
        };
        let value = |place| self.conditions.value(place, &self.meeting).on(&ball);
        plus = plus && !(most.1 > 0.0 && is_positive(&value(most.0)));
        minus = minus && !(least.1 < 0.0 && is_negative(&value(least.0)));
        match (plus || minus, seems_passed) {
            (false, _) => Passed::Proved,
            (true, true) => Passed::Likely,
            (true, false) => Passed::Unlikely,
        }
    }

    /// What all other conditions leave of it on a piece, which may begin at the least thickness; `None` if it is nowhere a vertex.
    ///
    /// Where its conditions and another one are all zero at the least thickness, a slope with a sign gives that other one this sign
    /// on the rest of the piece.
    pub(super) fn near(&mut self, piece: &Piece, start: Option<&Start>) -> Option<Near> {
        if self.values.is_empty() {
            let value = |place| self.conditions.value(place, &self.meeting);
            self.values = (0..self.conditions.all.len()).map(value).collect();
        }
        let ball = piece.ball();
        let [mut plus, mut minus] = self.signs(&ball);
        let start = start.filter(|start| piece.low == start.below);
        let touches = |place: &usize| start.is_some_and(|start| start.touching.contains(place));
        let begins = self.of.iter().all(touches);
        let mut others = Vec::new();
        for (place, polynomial) in self.values.iter().enumerate() {
            if self.of.contains(&place) {
                continue;
            }
            let mut value = polynomial.on(&ball);
            if !value.excludes_zero() && begins && touches(&place) {
                value = polynomial.derivative().on(&ball);
            }
            if is_positive(&value) {
                plus = false;
            } else if is_negative(&value) {
                minus = false;
            } else {
                others.push(place);
            }
            if !plus && !minus {
                return None;
            }
        }
        (plus || minus).then_some(Near { others })
    }

    /// Whether no joint moves with rates of its conditions and of others on a piece. Opposite slips of a joint are no motion: one of the two is
    /// left out, in turn. Nor is a slip of the crown of a half arch, which moves with its axis.
    ///
    /// Motions of hinges are the rows of their conditions: those of a vertex are independent.
    pub(super) fn bears_no_motion(&self, others: &[usize], piece: &Piece) -> bool {
        let is_hinge = |place: &usize| self.conditions.all[*place].contact.is_hinge();
        if others.is_empty() && self.of.iter().all(is_hinge) {
            return true;
        }
        let moves =
            |place: &usize| !self.conditions.all[*place].motion.iter().all(Polynomial::is_zero);
        let all: Vec<usize> = self.of.iter().chain(others).copied().filter(moves).collect();
        self.are_parted(&all, piece)
    }

    fn are_parted(&self, places: &[usize], piece: &Piece) -> bool {
        let is_opposite = |place: &&usize| {
            let of = |place: usize| (self.conditions.all[place].contact, place / 4);
            let (contact, joint) = of(**place);
            contact == Contact::Inwards
                && places.iter().any(|other| of(*other) == (Contact::Outwards, joint))
        };
        if let Some(place) = places.iter().find(is_opposite) {
            let without = |left_out: usize| {
                places.iter().copied().filter(|at| *at != left_out).collect::<Vec<_>>()
            };
            // The order is that of Contact::ALL.
            return [*place, *place + 1]
                .into_iter()
                .all(|left_out| self.are_parted(&without(left_out), piece));
        }
        let columns: Vec<[f64; 3]> = [piece.low, piece.high]
            .into_iter()
            .flat_map(|x| places.iter().map(move |place| (x, *place)))
            .map(|(x, place)| self.conditions.all[place].motion.each_ref().map(|b| b.near(x)))
            .collect();
        let Some(y) = parting(&columns) else { return false };
        let (y, ball) = (y.map(DoubleBall::exact), piece.ball());
        let along = |place: &usize| {
            let motion = self.conditions.all[*place].motion.each_ref().map(|b| b.on(&ball));
            motion[0] * y[0] + motion[1] * y[1] + motion[2] * y[2]
        };
        places.iter().all(|place| is_positive(&along(place)))
    }

    /// Whether its conditions leave one state at every thickness of a piece.
    pub(super) fn is_regular(&self, piece: &Piece) -> bool {
        self.meeting[3].on(&piece.ball()).excludes_zero()
    }

    /// The conditions of the arch.
    pub(super) fn conditions(&self) -> &'a Conditions<DoubleBall> {
        self.conditions
    }

    /// The other condition as a polynomial in the thickness.
    pub(super) fn value(&self, place: usize) -> Polynomial<DoubleBall> {
        self.conditions.value(place, &self.meeting)
    }
}

/// Whether one condition passes a vertex on a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passed {
    /// It does: on the whole piece it is no vertex.
    Proved,
    /// In the middle, in doubles.
    Likely,
    /// Not that it would be seen.
    Unlikely,
}

/// A value that is no rounding beside the size of its terms.
const CLEAR: f64 = 1e-9;

fn is_zero(x: &DoubleBall) -> bool {
    x.mid() == 0.0 && x.rad() == 0.0
}

/// The rows in doubles, by the powers of the thickness.
pub(super) fn in_doubles(conditions: &Conditions<DoubleBall>) -> Vec<[[f64; 3]; 4]> {
    let entry = |of: &Polynomial<DoubleBall>| {
        let second = of.derivative().derivative().near(0.0) / 2.0;
        [of.near(0.0), of.derivative().near(0.0), second]
    };
    conditions.all.iter().map(|condition| condition.row.each_ref().map(entry)).collect()
}
