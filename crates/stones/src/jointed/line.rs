//! Three conditions that may be dependent.
//!
//! Where the rows of a triple are dependent at a thickness, or at all, its polynomials have a common zero there,
//! and balls around it tell no sign. But two of the three, with rows that are not parallel anywhere on the piece,
//! leave a line of states at each of its thicknesses. What satisfies the third condition too is on that line.
//!
//! - **The line.** With rows `a`, `b` and loads `c`, `d` it is `x = place + t along`, with `along = a x b` and
//!   `place = -(c b x along + d along x a)/|along|^2`: there `a . x = -c` and `b . x = -d` for every `t`. In balls
//!   over the piece both hold those of all its thicknesses, and so does `value + slope t` for what another
//!   condition is on the line, with any ball around `t`.
//! - **The stretch.** An admissible state has `value + slope t <= 0`. Where `slope > 0` on the piece this is `t <=
//!   -value/slope`, where `slope < 0` it is `t >= -value/slope`; what is kept is the upper bound of the one and the
//!   lower bound of the other. So at every thickness of the piece all admissible states of the line have a `t` in
//!   between, and there are none if the bounds have passed each other. Without a bound on both sides nothing is
//!   told.
//! - **The parts.** The stretch is halved until on each part the third condition is not zero, or another one is
//!   positive, so that no state of the triple is admissible; or the motions of the triple, and of all conditions
//!   that may be zero there, fit with no rates but zero (`vertex`). That may be said without the state: a motion
//!   that is looked at is one more that has to be parted from rates, so that too many cost a proof and never make
//!   one.
//! - **Three hinges** alone have motions that may fit where they are dependent, and are passed all the same: a
//!   vertex has independent rows, so that where these are dependent the state is found by other triples. That is
//!   all that is said of a triple: at no thickness of the piece is it the vertex of a solution.

use super::polynomial::ShortPolynomial;
use super::vertex::{ThicknessPiece, Vertex};
use crate::number::{DoubleBall, Enclosure};
use crate::prover::decide::is_positive;
use crate::vector::{ForceLine, ForceRow, cross, dot, parts};

/// Parts of a stretch that are looked at, at most.
const PARTS: usize = 200;

/// Part free of `t` in a condition on a line, and what multiplies it.
type OnLine = [DoubleBall; 2];

/// Stretch that conditions leave of a line: the states may be admissible at these `t` at most. Its ends have passed
/// each other where they are nowhere, and are infinite where nothing limits them, as far as is seen.
fn stretch(conditions: &[OnLine]) -> ThicknessPiece {
    let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
    for [value, slope] in conditions {
        let bound = || -*value / slope;
        if is_positive(slope) {
            most = most.min(bound().upper());
        } else if is_positive(&-*slope) {
            least = least.max(bound().lower());
        }
    }
    ThicknessPiece { low: least, high: most }
}

/// The line of the two conditions that are the least parallel, and the third one on it; `None` if no two are sure
/// to leave a line.
fn line_of(own: [ForceRow; 3]) -> Option<(ForceLine, OnLine)> {
    let [a, b, c] = own;
    let size = |one: &ForceRow, other: &ForceRow| {
        let along = cross(&parts(one).0, &parts(other).0);
        dot(&along, &along).mid()
    };
    let pairs = [(a, b, c), (a, c, b), (b, c, a)];
    let (one, other, third) =
        pairs.into_iter().max_by(|x, y| size(&x.0, &x.1).total_cmp(&size(&y.0, &y.1)))?;
    let line = ForceLine::of(&one, &other)?;
    let third = line.value(&third);
    Some((line, third))
}

/// Tells whether at no thickness of a piece the three conditions are a vertex that bears a motion. `false`
/// tells nothing.
pub(super) fn bears_no_motion(vertex: &Vertex<'_>, piece: &ThicknessPiece) -> bool {
    let ball = piece.ball();
    let on = |row: &[ShortPolynomial<DoubleBall>; 4]| row.each_ref().map(|entry| entry.on(&ball));
    let conditions = vertex.conditions();
    let own: Vec<ForceRow> = conditions.rows_of(&vertex.of).into_iter().map(on).collect();
    let Some((line, third)) = own.try_into().ok().and_then(line_of) else { return false };
    let (places, others): (Vec<usize>, Vec<OnLine>) = (0..conditions.all.len())
        .filter(|place| !vertex.of.contains(place))
        .map(|place| (place, line.value(&on(&conditions.all[place].row))))
        .unzip();
    let all = stretch(&others);
    if all.low > all.high || all.low.is_infinite() || all.high.is_infinite() {
        return all.low > all.high;
    }
    let mut pending = vec![all];
    for _ in 0..PARTS {
        let Some(part) = pending.pop() else { return true };
        let t = part.ball();
        let at = |[value, slope]: &OnLine| *value + *slope * t;
        if at(&third).excludes_zero() || others.iter().any(|of| is_positive(&at(of))) {
            continue;
        }
        let may_be_zero: Vec<usize> = (places.iter().zip(&others))
            .filter(|(_, of)| !at(of).excludes_zero())
            .map(|(place, _)| *place)
            .collect();
        if vertex.bears_no_motion(&may_be_zero, piece) {
            continue;
        }
        let Some([lower, upper]) = part.halves() else { return false };
        pending.extend([upper, lower]);
    }
    pending.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::mechanism::Contact::{self, Extrados, Intrados, Outwards};
    use crate::arch::whole::Side;
    use crate::jointed::conditions::Conditions;
    use crate::problem::Arch;
    use crate::problem::Extent;
    use crate::{JointedMotion, JointedSolution, enumerate};

    /// The ends of a stretch are outside of what the conditions allow, by little; a slope of which the sign is open
    /// is no limit.
    #[test]
    fn a_stretch_holds_all_that_is_allowed() {
        let on_line = |value: f64, slope: f64| [value, slope].map(|x| DoubleBall::new(x, 1e-6));
        // `3 t - 1 <= 0`, `t - 1 <= 0` and `-7 t - 2 <= 0`.
        let (near, far, below) = (on_line(-1.0, 3.0), on_line(-1.0, 1.0), on_line(-2.0, -7.0));
        let ThicknessPiece { low, high } = stretch(&[far, near, below]);
        // What the balls allow at most, but for the rounding of the test.
        let ends = [-(2.0 + 1e-6) / (7.0 - 1e-6), (1.0 + 1e-6) / (3.0 - 1e-6)];
        assert!((0.0..1e-6).contains(&(ends[0] + 1e-12 - low)), "{low}");
        assert!((0.0..1e-6).contains(&(high - ends[1] + 1e-12)), "{high}");
        let is_endless = |of: &[OnLine]| stretch(of).low == f64::NEG_INFINITY;
        assert!(is_endless(&[near]) && is_endless(&[near, on_line(-2.0, 1e-7)]));
        // `t >= 1/2` leaves nothing, and `t >= 1/3` what the balls cannot tell from it.
        let is_empty = |piece: ThicknessPiece| piece.low > piece.high;
        assert!(is_empty(stretch(&[near, on_line(1.0, -2.0)])));
        assert!(!is_empty(stretch(&[near, on_line(1.0, -3.0)])));
    }

    /// Tells whether a triple may be dependent next to a thickness, and whether it is proved to bear no motion.
    fn told(conditions: &Conditions<DoubleBall>, mut of: Vec<usize>, eta: f64) -> [bool; 2] {
        of.sort_unstable();
        let minors = conditions.minors(&of);
        let vertex = Vertex::new(conditions, of, &minors);
        let piece = ThicknessPiece { low: eta - 1e-6, high: eta + 1e-6 };
        [vertex.may_be_dependent(&piece), bears_no_motion(&vertex, &piece)]
    }

    /// A slip at 45 degrees with a friction of one says `h >= 0`, as a crown without force does: dependent at all
    /// thicknesses, whether the state without thrust is admissible or not. With another friction the three are
    /// independent.
    #[test]
    fn dependent_conditions_are_decided_along_their_line() {
        let of: [(Contact, i32); 3] = [(Outwards, -2), (Extrados, 0), (Intrados, 0)];
        for (mu, is_dependent) in [("1", true), ("1.01", false)] {
            let arch = Arch::parse("milankovitch", "pi/2", mu).unwrap();
            let conditions = Conditions::new(&arch, 4, Extent::Whole, 106);
            let of = of.map(|at| conditions.place(at.0, at.1).unwrap());
            for eta in [0.5, 1.2, 1.9] {
                let [may_be, is_told] = told(&conditions, of.to_vec(), eta);
                assert_eq!(may_be, is_dependent, "{mu} {eta}");
                assert!(is_told || !is_dependent, "{mu} {eta}");
            }
        }
    }

    /// The conditions that move in a solution.
    fn moving(
        conditions: &Conditions<DoubleBall>,
        stones: u64,
        of: &JointedSolution,
    ) -> Vec<usize> {
        let outermost = of.joints[0].angle.double;
        let stones = stones as f64;
        let place = |at: &JointedMotion| {
            let joint = (at.angle.double / outermost * stones).round() as i32;
            let right = conditions.place(at.contact, joint).unwrap();
            if at.side == Some(Side::Left) { conditions.mirrored(&[right])[0] } else { right }
        };
        of.joints.iter().map(place).collect()
    }

    /// A motion is never denied: at solutions, symmetric or not, under a crown that bears nothing too, no three of
    /// the conditions that move are told to bear none; beside the solutions some are.
    #[test]
    fn a_motion_is_not_denied() {
        for (alpha, mu, stones, count) in
            [("pi/2", "1", 4, 1), ("2.3", "1.05", 4, 2), ("2.606", "1.888", 4, 1)]
        {
            let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
            let conditions = Conditions::new(&arch, stones as i32, Extent::Whole, 106);
            let all = enumerate(&arch, stones, Extent::Whole, 15).unwrap().solutions;
            assert_eq!(all.len(), count);
            for solution in all.into_iter().map(Result::unwrap) {
                let eta = solution.thickness.double;
                let of = moving(&conditions, stones, &solution);
                let mut beside = 0;
                for i in 0..of.len() {
                    for j in i + 1..of.len() {
                        for k in j + 1..of.len() {
                            let three = || vec![of[i], of[j], of[k]];
                            assert!(!told(&conditions, three(), eta)[1], "{alpha} {eta} {i}{j}{k}");
                            beside += u32::from(told(&conditions, three(), eta + 1e-3)[1]);
                        }
                    }
                }
                assert!(beside > 0, "{alpha} {eta}");
            }
        }
    }
}
