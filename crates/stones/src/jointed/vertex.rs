//! A vertex of the admissible forces, as it moves with the thickness.
//!
//! Three conditions that are zero together, or two of a half arch, leave one state for each thickness, `(h, p, v) =
//! (M_0, M_1, M_2)/M_3` with polynomials `M` in the thickness, and `M_3` the determinant of their rows. Any other
//! condition there is `D/M_3` with a polynomial `D` too. So on a piece of thicknesses, without a quotient:
//!
//! - **It is no vertex** if `M_3 <= 0` or some `D > 0` on the piece, and `M_3 >= 0` or some `D < 0`.
//! - **At most those conditions are zero with it** whose `D` may vanish on the piece.
//! - **It bears no motion** if some `y` has `y . b > 0` for the motions `b` of its conditions and of all those: then no
//!   rates but zero fit. Each `b` is linear in the thickness. Where both slips of a joint are among them there is
//!   such a `y` without the one, and one without the other.
//! - **Nor does it** if `y . b + z w > 0` for the motions and what the weight does along each, `w`, with `z <= 0`,
//!   or any `z` if all are hinges. A hinge's condition is zero, `b . x + w = 0`, and a slip's takes what friction
//!   takes, `b . x + w = mu N >= 0`. So rates with `sum rate b = 0` have `sum rate w = sum rate mu N >= 0`, which
//!   is zero for hinges; and then `sum rate (y . b + z w) <= 0`. Hinges on one line have motions that fit, with a
//!   thrust that has no limit, and only the weight tells that they are not in equilibrium.

use super::conditions::{Conditions, Minors};
use super::polynomial::ShortPolynomial;
use crate::arch::mechanism::Contact;
use crate::number::{DoubleBall, Enclosure};
use crate::prover::decide::is_positive;
use crate::solve::rates::parting;

/// A piece of thicknesses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ThicknessPiece {
    pub low: f64,
    pub high: f64,
}

impl ThicknessPiece {
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

    /// The lower and the upper half; `None` if doubles tell no middle.
    pub(super) fn halves(&self) -> Option<[Self; 2]> {
        let middle = self.middle();
        let is_inside = self.low < middle && middle < self.high;
        is_inside.then_some([Self { high: middle, ..*self }, Self { low: middle, ..*self }])
    }
}

/// Exact zeros where the range begins: at the least thickness, or at 0.
#[derive(Clone, Debug)]
pub(super) struct SweepStart {
    /// A double below the least thickness and next to it; or 0.
    pub below: f64,
    /// Conditions that are all zero in the state there.
    pub touching: Vec<usize>,
}

impl SweepStart {
    /// Tells whether the polynomial of a condition, at the state of others, is zero where the range begins.
    /// At 0 both faces are one line, and both hinges of a joint one condition, which is left out with the
    /// factor `eta`: it is said of different joints alone.
    fn is_tied(&self, conditions: &Conditions<DoubleBall>, of: &[usize], place: usize) -> bool {
        let are_apart = || {
            let all = of.iter().chain([&place]);
            let mut joints: Vec<usize> = all.map(|at| conditions.joint(*at)).collect();
            joints.sort_unstable();
            joints.windows(2).all(|two| two[0] != two[1])
        };
        let mut all = of.iter().chain([&place]);
        all.all(|at| self.touching.contains(at)) && (self.below > 0.0 || are_apart())
    }
}

/// Three conditions, or two of a half arch.
pub(super) struct Vertex<'a> {
    conditions: &'a Conditions<DoubleBall>,
    /// Places of the conditions, in order.
    pub of: Vec<usize>,
    meeting: [ShortPolynomial<DoubleBall>; 4],
    /// The other conditions there, when they are needed.
    values: Vec<ShortPolynomial<DoubleBall>>,
}

impl<'a> Vertex<'a> {
    /// The vertex of these conditions, from the minors of the first two.
    pub(super) fn new(
        conditions: &'a Conditions<DoubleBall>,
        of: Vec<usize>,
        minors: &Minors<DoubleBall>,
    ) -> Self {
        let meeting = conditions.meeting_by(&of, minors);
        Self { conditions, of, meeting, values: Vec::new() }
    }

    /// The sign that is left to the common factor on a piece: positive, negative.
    fn signs(&self, piece: &DoubleBall) -> [bool; 2] {
        let factor = self.meeting[3].on(piece);
        let is_zero = factor.size() == 0.0;
        [factor.upper() > 0.0 && !is_zero, factor.lower() < 0.0 && !is_zero]
    }

    /// Tells whether a single condition shows that the triple is no vertex on a piece; a guess says which: those that
    /// showed it of the triple before, one for each sign of the common factor, or those that are passed most.
    pub(super) fn is_passed_by_one(
        &self,
        piece: &ThicknessPiece,
        rows: &[[[f64; 3]; 4]],
        before: &mut [usize; 2],
    ) -> Passing {
        let ball = piece.ball();
        let [mut plus, mut minus] = self.signs(&ball);
        let [low, middle, high] = &[piece.low, piece.middle(), piece.high]
            .map(|x| (x, self.meeting.each_ref().map(|entry| entry.near(x))));
        let near = |place: usize, (x, at): &(f64, [f64; 4])| {
            let row: &[[f64; 3]; 4] = &rows[place];
            let entry = |k: usize| (row[k][2] * x + row[k][1]) * x + row[k][0];
            entry(0) * at[0] + entry(1) * at[1] + entry(2) * at[2] + entry(3) * at[3]
        };
        // What is not so at both ends in doubles is not tried in balls.
        let value = |place| self.value(place).on(&ball);
        let passes = |place: usize, sign: f64| {
            [low, high].iter().all(|state| sign * near(place, state) > 0.0)
                && is_positive(&(value(place) * DoubleBall::exact(sign)))
        };
        plus = plus && !passes(before[0], 1.0);
        minus = minus && !passes(before[1], -1.0);
        if !plus && !minus {
            return Passing::Proved;
        }
        // The condition that is passed most, of some joints and then of those beside it.
        let farthest = |sign: f64| {
            let most = |from: usize, to: usize, step: usize| {
                let values = (from..to).step_by(step).map(|at| (sign * near(at, middle), at));
                values.fold((0.0, from), |most, value| if value.0 > most.0 { value } else { most })
            };
            let (_, at) = most(0, rows.len(), SOME);
            most(at.saturating_sub(4 * SOME), rows.len().min(at + 4 * SOME), 1)
        };
        let [most, least] = [1.0, -1.0].map(farthest);
        let size = middle.1.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let seems_passed = if middle.1[3] > 0.0 { most.0 } else { least.0 } > CLEAR * size;
        *before = [most.1, least.1];
        plus = plus && !passes(most.1, 1.0);
        minus = minus && !passes(least.1, -1.0);
        match (plus || minus, seems_passed) {
            (false, _) => Passing::Proved,
            (true, true) => Passing::Likely,
            (true, false) => Passing::Unlikely,
        }
    }

    /// Other conditions that may be zero with its own on a piece, which may begin at the least thickness, where they
    /// may be a vertex; `None` if it is nowhere one.
    ///
    /// Where its conditions and another one are all zero at the least thickness, a slope with a sign gives that
    /// other one this sign on the rest of the piece.
    pub(super) fn near(
        &mut self,
        piece: &ThicknessPiece,
        start: Option<&SweepStart>,
    ) -> Option<Vec<usize>> {
        if self.values.is_empty() {
            self.values = (0..self.conditions.all.len()).map(|place| self.value(place)).collect();
        }
        let ball = piece.ball();
        let [mut plus, mut minus] = self.signs(&ball);
        let start = start.filter(|start| piece.low == start.below);
        let is_tied =
            |place| start.is_some_and(|start| start.is_tied(self.conditions, &self.of, place));
        let mut others = Vec::new();
        for (place, polynomial) in self.values.iter().enumerate() {
            if self.of.contains(&place) {
                continue;
            }
            let mut value = polynomial.on(&ball);
            if !value.excludes_zero() && is_tied(place) {
                value = polynomial.derivative().on(&ball);
            }
            if is_positive(&value) {
                plus = false;
            } else if is_positive(&-value) {
                minus = false;
            } else {
                others.push(place);
            }
            if !plus && !minus {
                return None;
            }
        }
        (plus || minus).then_some(others)
    }

    /// Tells whether no joint moves with rates of its conditions and of others on a piece. Opposite slips of
    /// a joint are no motion: one of the two is left out, in turn. Nor is a slip of the crown of a half arch,
    /// which moves with its axis.
    ///
    /// Motions of hinges are the rows of their conditions: those of a vertex are independent.
    pub(super) fn bears_no_motion(&self, others: &[usize], piece: &ThicknessPiece) -> bool {
        let is_hinge = |place: &usize| self.conditions.all[*place].contact.is_hinge();
        if others.is_empty() && self.of.iter().all(is_hinge) {
            return true;
        }
        let moves = |place: &usize| {
            !self.conditions.all[*place].motion.iter().all(ShortPolynomial::is_zero)
        };
        let all: Vec<usize> = self.of.iter().chain(others).copied().filter(moves).collect();
        self.are_parted(&all, piece)
    }

    fn are_parted(&self, places: &[usize], piece: &ThicknessPiece) -> bool {
        let is_opposite = |place: &&usize| {
            let of =
                |place: usize| (self.conditions.all[place].contact, self.conditions.joint(place));
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
        let column = |place: usize| {
            let [a, b, c] = &self.conditions.all[place].motion;
            [a, b, c, &self.conditions.weights[place]]
        };
        // Ends that are nearly one thickness have columns that are nearly parallel, which the search does not bear.
        let both = [piece.low, piece.high];
        let middle = [piece.middle()];
        let ends = if piece.high - piece.low > NARROW { &both[..] } else { &middle };
        let columns: Vec<[f64; 4]> = ends
            .iter()
            .flat_map(|x| places.iter().map(move |place| (*x, *place)))
            .map(|(x, place)| column(place).map(|b| b.near(x)))
            .collect();
        let ball = piece.ball();
        let points = |y: [f64; 4], place: usize| {
            let terms = column(place).into_iter().zip(y.map(DoubleBall::exact));
            let along = terms.fold(DoubleBall::exact(0.0), |sum, (b, y)| sum + b.on(&ball) * y);
            is_positive(&along)
        };
        let slides = places.iter().any(|place| !self.conditions.all[*place].contact.is_hinge());
        let prices: &[f64] = if slides { &[0.0, -1.0] } else { &[0.0, -1.0, 1.0] };
        let mut found = prices.iter().filter_map(|price| parting(&columns, *price));
        found.any(|y| places.iter().all(|place| points(y, *place)))
    }

    /// Tells whether the vertex's rows may be dependent somewhere on a piece.
    pub(super) fn may_be_dependent(&self, piece: &ThicknessPiece) -> bool {
        let ball = piece.ball();
        self.meeting.iter().all(|entry| !entry.on(&ball).excludes_zero())
    }

    /// Tells whether the vertex's conditions leave one state at every thickness of a piece.
    pub(super) fn is_regular(&self, piece: &ThicknessPiece) -> bool {
        self.meeting[3].on(&piece.ball()).excludes_zero()
    }

    /// The conditions of the arch.
    pub(super) fn conditions(&self) -> &'a Conditions<DoubleBall> {
        self.conditions
    }

    /// The other condition as a polynomial in the thickness.
    pub(super) fn value(&self, place: usize) -> ShortPolynomial<DoubleBall> {
        self.conditions.value(place, &self.of, &self.meeting)
    }
}

/// Result of trying whether one condition passes a vertex on a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passing {
    /// The condition passes: on the whole piece it is no vertex.
    Proved,
    /// The condition seems to pass in the middle of the piece, in doubles.
    Likely,
    /// The condition does not seem to pass.
    Unlikely,
}

/// A piece whose ends are not told apart where a direction is sought.
const NARROW: f64 = 1e-5;
/// Of so many conditions one is looked at first: each of the four kinds in turn.
const SOME: usize = 5;
/// A value that is no rounding beside the size of its terms.
const CLEAR: f64 = 1e-9;

/// The rows in doubles, by the powers of the thickness.
pub(super) fn in_doubles(conditions: &Conditions<DoubleBall>) -> Vec<[[f64; 3]; 4]> {
    let entry = |of: &ShortPolynomial<DoubleBall>| {
        let second = of.derivative().derivative().near(0.0) / 2.0;
        [of.near(0.0), of.derivative().near(0.0), second]
    };
    conditions.all.iter().map(|condition| condition.row.each_ref().map(entry)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::{Arch, Extent};
    use Contact::{Extrados, Intrados, Inwards, Outwards};

    fn bears_no_motion(alpha: &str, of: [(Contact, i32); 4], eta: f64) -> bool {
        let arch = Arch::parse("heyman", alpha, "3").unwrap();
        let conditions = Conditions::new(&arch, 5, Extent::Whole, 106);
        let mut places = of.map(|at| conditions.place(at.0, at.1).unwrap()).to_vec();
        let other = places.pop().unwrap();
        let piece = ThicknessPiece { low: eta - 1e-9, high: eta + 1e-9 };
        let minors = conditions.minors(&places);
        Vertex::new(&conditions, places, &minors).bears_no_motion(&[other], &piece)
    }

    /// The springings' extrados and the keystone's intrados lie on one line at `(1 + eta/2) cos alpha = (1 - eta/2)
    /// cos(alpha/5)`. Their motions fit there, and the weight tells that nothing moves.
    #[test]
    fn hinges_on_one_line_bear_no_motion() {
        let on_one_line = [(Extrados, -5), (Intrados, -1), (Intrados, 1), (Extrados, 5)];
        let [outer, inner] = [0.8_f64.cos(), 0.16_f64.cos()];
        let eta = 2.0 * (inner - outer) / (inner + outer);
        for eta in [eta, eta + 0.1, eta - 0.1] {
            assert!(bears_no_motion("0.8", on_one_line, eta), "{eta}");
        }
        // A thrust as large as one likes, with slips that the friction takes: only a price of the other sign would
        // part them.
        let slips = [(Extrados, -5), (Intrados, -1), (Intrados, 1), (Outwards, 5)];
        assert!(bears_no_motion("0.8", slips, eta), "a slip does not fit");
    }

    /// Two halves that slide down and apart, under a crown that turns at neither face: rates fit, and the weight works.
    #[test]
    fn friction_may_take_what_the_weight_gives() {
        let sliding = [(Inwards, 1), (Outwards, -1), (Outwards, 5), (Inwards, -5)];
        assert!(!bears_no_motion("0.8", sliding, 0.5));
    }
}
