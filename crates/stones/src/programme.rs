//! The least value of the bilinear programme (20) of an arch of stones, enclosed.
//!
//! The forces `x = (h, p, v)` satisfy `phi(x) <= 0`, four conditions at each joint; the rates `lambda >= 0` fit,
//! without dilatancy, and add up to one. `-phi(x)^T lambda` is not negative, and is zero where (19) has a solution.
//!
//! For fixed rates the value is linear in `x`: so it is least at a vertex of the admissible forces, if there is
//! one. Each vertex lies on the line on which two conditions are zero, at an end of what the others leave of that
//! line. In balls:
//!
//! 1. On each such line every other condition bounds a ray; where two bounds exclude each other, nothing is left.
//!    If nothing is left on any line there is no vertex; and as there is no line among the admissible forces,
//!    nothing is admissible.
//! 2. At each end, prices `y` of the equations give the lower bound `min (-phi_j - y . b_j)` of the value for all
//!    rates: they come from [`solve`](crate::solve::rates) and are trusted for nothing. A bound that is left out,
//!    as its direction is not decided, makes the stretch longer; as the value is linear on it, what holds at its
//!    ends holds between.
//! 3. Two conditions that may be parallel make no line here. A vertex on them is on two other lines, unless three
//!    conditions may be parallel in pairs; then nothing is decided. Three slips are no vertex: none says anything of
//!    `p`.
//! 4. The least of these bounds is a lower bound of the programme; the value at one end, with rates that are proved
//!    to be positive and to fit, is an upper one.
//!
//! 5. **By the letter** the value is zero where a joint bears nothing in an admissible state, `N = T = 0`: both of
//!    its slips are zero, and as their motions are opposite, equal rates of both fit. With one hinge of this joint
//!    the two slips fix such a state, and the other hinge is zero with them; that all other joints have room is
//!    proved.
//! 6. A solid arch, of thickness 2, has its intrados at the centre: the hinges there say `p >= -fac (1 - cos
//!    beta)`, each for its joint, and all but those nearest to the crown follow from these. Conditions that follow
//!    from another with the same row make no lines, as no vertex needs them.
//!
//! **No rates at all** fit where the motions of all joints point to one side of a plane: then (19) has no solution,
//! and the programme no value. It may be so with unlimited friction alone: else equal rates of a joint's two slips fit.
//!
//! **Complete** for the joints that there are: all pairs of conditions are looked at. Between the joints nothing is
//! asked.
//!
//! **Of a half arch** the forces are `(h, p)` and two equations of compatibility are left: `v = 0` takes the place
//! of the first condition of each pair.
//!
//! **At the least thickness** the value is exactly zero, which no ball tells from a small one: there (19) has the
//! solution that is proved with the other thicknesses ([`enumerate`](super::enumerate)).

use crate::arch::mechanism::Contact;
use crate::number::{DoubleBall, Enclosure, ExactNumber, Field};
use crate::problem::{Arch, Extent};
use crate::prover::arithmetic::{larger, lesser};
use crate::prover::decide::ensure;
use crate::prover::{Error, Refused, Undecided};
use crate::solve::rates::{PositiveRates, least_cost, parting};
use crate::vector::{ForceLine, Vector, at, cross, dot, parts};
use conditions::{MovingLimit, conditions, follows};

mod conditions;

/// Result of the programme (20).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Programme {
    /// No rates fit but zero: (19) has no solution.
    NoRates,
    /// No forces satisfy the conditions at all joints.
    NothingAdmissible,
    /// The least value of the programme is zero: (19) has a solution.
    Zero,
    /// The least value of the programme is zero by the letter alone: in an admissible state a joint bears
    /// nothing, and its two opposite slips, which are no motion, cost nothing. Whether a motion costs nothing
    /// is not said.
    Idle,
    /// The least value of the programme is positive, and lies between two numbers.
    Least {
        /// Bound not above the least value; positive.
        lower: f64,
        /// Bound not below the least value, if rates are proved.
        upper: Option<f64>,
    },
}

/// More stones are refused: the cost grows with the cube of their number.
pub const MOST_JOINTED_STONES: u64 = 100;

/// The programme of an arch of equal stones, 2 to [`MOST_JOINTED_STONES`], at a thickness: of the whole arch, or of
/// its half. With unlimited friction the hinges alone are conditions.
pub fn programme(
    arch: &Arch,
    thickness: &ExactNumber,
    (stones, extent): (u64, Extent),
) -> Result<Programme, Error> {
    Refused::thickness(thickness)?;
    let number = Refused::stones(stones, MOST_JOINTED_STONES)?;
    let all = RateSearch::new(conditions(arch, thickness, (number, extent)), extent);
    Ok(all.least()?)
}

/// The conditions, and their motions as columns of the programme of the rates.
struct RateSearch {
    all: Vec<MovingLimit>,
    columns: Vec<[f64; 4]>,
    /// Flags of the conditions that follow from another one.
    follows: Vec<bool>,
    /// Condition that a state of a half arch satisfies beside them: `v = 0`.
    plane: Option<MovingLimit>,
}

/// Stretch that two conditions leave to all others on the line where they are zero.
enum FreeStretch {
    Empty,
    /// The two may be parallel.
    Parallel,
    /// Ends of the stretch, and whether they are proved to be admissible.
    Ends(Vec<Vector>, bool),
}

impl RateSearch {
    fn new(all: Vec<MovingLimit>, extent: Extent) -> Self {
        let column = |limit: &MovingLimit| {
            let [a, b, c] = limit.motion.map(|x| x.mid());
            [a, b, c, 1.0]
        };
        let row = [0.0, 0.0, 1.0, 0.0].map(DoubleBall::exact);
        let plane = MovingLimit { contact: Contact::Inwards, joint: 0, row, motion: [row[0]; 3] };
        let plane = (extent == Extent::Half).then_some(plane);
        let columns = all.iter().map(column).collect();
        let follows = |of: &MovingLimit| all.iter().any(|other| follows(of, other));
        let follows = all.iter().map(follows).collect();
        Self { columns, follows, all, plane }
    }

    fn least(&self) -> Result<Programme, Undecided> {
        if self.has_no_rates() {
            return Ok(Programme::NoRates);
        }
        let mut found: Vec<(f64, Option<f64>)> = Vec::new();
        let mut parallel = Vec::new();
        for pair in self.pairs() {
            match self.stretch(pair)? {
                FreeStretch::Empty => {}
                FreeStretch::Parallel if pair.iter().all(|of| self.is_free_of_moment(*of)) => {}
                FreeStretch::Parallel => parallel.push(pair),
                FreeStretch::Ends(ends, admissible) => {
                    for end in &ends {
                        let (lower, best) = self.bound(end)?;
                        let upper = if admissible { self.value(end, &best) } else { None };
                        found.push((lower, upper));
                    }
                }
            }
        }
        // In a half arch a vertex is on two lines, and one of them is enough.
        let is_open = match self.plane {
            None => has_triangle(&parallel),
            Some(_) => parallel.len() > 1,
        };
        ensure(!is_open, "whether conditions are parallel")?;
        let upper = found.iter().filter_map(|(_, upper)| *upper).reduce(f64::min);
        Ok(match found.into_iter().map(|(lower, _)| lower).reduce(f64::min) {
            None => Programme::NothingAdmissible,
            Some(lower) if lower > 0.0 => Programme::Least { lower, upper },
            Some(_) if self.bears_nothing() => Programme::Idle,
            Some(_) => return Err(Undecided::new("whether the least value is zero")),
        })
    }

    /// Tells whether a direction is proved in which all motions point, `y . b > 0`: then rates that are not negative
    /// and have `sum rate b = 0` are zero.
    fn has_no_rates(&self) -> bool {
        let columns: Vec<[f64; 4]> =
            self.columns.iter().map(|[a, b, c, _]| [*a, *b, *c, 0.0]).collect();
        parting(&columns, 0.0).is_some_and(|[x, y, z, _]| {
            let direction = [x, y, z].map(DoubleBall::exact);
            let along = |limit: &MovingLimit| dot(&limit.motion, &direction);
            self.all.iter().all(|limit| along(limit).is_positive().is_proved())
        })
    }

    /// Tells whether a condition of the whole arch says nothing of `p`, exactly.
    fn is_free_of_moment(&self, place: usize) -> bool {
        let is_zero = |limit: &MovingLimit| limit.row[1].size() == 0.0;
        self.plane.is_none() && self.all.get(place).is_some_and(is_zero)
    }

    /// Tells whether some joint bears nothing in a state that is proved to be admissible.
    fn bears_nothing(&self) -> bool {
        let joints = self.all.chunk_by(|a, b| a.joint == b.joint);
        joints.into_iter().any(|at| self.state_without(at).is_some())
    }

    /// The admissible state in which a joint, given by its conditions, bears nothing. In a half arch only the crown
    /// may, whose slips are one condition.
    fn state_without(&self, joint: &[MovingLimit]) -> Option<Vector> {
        let [hinge, _, slip, other] = joint else { return None };
        let last = match &self.plane {
            None => other,
            Some(_) if hinge.joint != 0 => return None,
            Some(plane) => plane,
        };
        let [(first, load), (second, of_slip), (third, of_last)] =
            [hinge, slip, last].map(|limit| parts(&limit.row));
        let across = [cross(&second, &third), cross(&third, &first), cross(&first, &second)];
        let size = dot(&first, &across[0]);
        if !size.excludes_zero() {
            return None;
        }
        let forces = [0, 1, 2].map(|k| {
            -(across[0][k] * load + across[1][k] * of_slip + across[2][k] * of_last) / size
        });
        let mut others = self.all.iter().filter(|of| of.joint != hinge.joint);
        let have_room = others.all(|of| (-at(&of.row, &forces)).is_positive().is_proved());
        have_room.then_some(forces)
    }

    /// The conditions that make lines together; a place beyond the last is that of `v = 0`.
    fn pairs(&self) -> Vec<[usize; 2]> {
        let count = self.all.len();
        let needed: Vec<usize> = (0..count).filter(|k| !self.follows[*k]).collect();
        let before = |i: usize| needed.iter().filter(move |j| **j < i).map(move |j| [i, *j]);
        match self.plane {
            None => needed.iter().flat_map(|i| before(*i)).collect(),
            Some(_) => needed.iter().map(|j| [count, *j]).collect(),
        }
    }

    /// Stretch that the conditions leave of the line where two of them are zero.
    fn stretch(&self, [i, j]: [usize; 2]) -> Result<FreeStretch, Undecided> {
        let at = |place| self.all.get(place).or(self.plane.as_ref());
        let (Some(a), Some(b)) = (at(i), at(j)) else { return Ok(FreeStretch::Empty) };
        let Some(line) = ForceLine::of(&a.row, &b.row) else { return Ok(FreeStretch::Parallel) };
        let (mut least, mut most): (Option<DoubleBall>, Option<DoubleBall>) = (None, None);
        let (mut is_whole, mut is_open) = (true, false);
        let others = self.all.iter().enumerate();
        let others = others.filter(|(k, _)| *k != i && *k != j && !self.follows[*k]);
        for (_, other) in others {
            let [value, slope] = line.value(&other.row);
            let bound = -value / slope;
            if slope.is_positive().is_proved() {
                most = Some(most.map_or(bound, |most| lesser(most, bound)));
            } else if (-slope).is_positive().is_proved() {
                least = Some(least.map_or(bound, |least| larger(least, bound)));
            } else if slope.size() == 0.0 {
                if value.is_positive().is_proved() {
                    return Ok(FreeStretch::Empty);
                }
                is_whole &= (-value).is_positive().is_proved();
            } else {
                (is_whole, is_open) = (false, true);
            }
            if let (Some(least), Some(most)) = (&least, &most)
                && most.is_less_than(least).is_proved()
            {
                return Ok(FreeStretch::Empty);
            }
        }
        if let (Some(least), Some(most)) = (&least, &most) {
            is_whole &= least.is_less_than(most).is_proved();
        }
        // A bound left out makes a stretch longer, which loses nothing; but a ray has no vertex where a stretch
        // would end.
        let ends = [least, most].into_iter().flatten();
        let ends: Vec<Vector> = ends.map(|t| line.at(t)).collect();
        let has_ends = ends.len() == 2 || ends.len() == 1 && !is_open;
        ensure(has_ends, "whether a line is admissible as a whole")?;
        Ok(FreeStretch::Ends(ends, is_whole))
    }

    /// A lower bound of the value for all rates, for forces in a box; and the rates that made it.
    fn bound(&self, forces: &Vector) -> Result<(f64, PositiveRates), Undecided> {
        let costs: Vec<DoubleBall> = self.all.iter().map(|other| -at(&other.row, forces)).collect();
        let middles: Vec<f64> = costs.iter().map(DoubleBall::mid).collect();
        let best = least_cost(&self.columns, &middles);
        let best = best.ok_or_else(|| Undecided::new("rates of the least value"))?;
        let [x, y, z, _] = best.prices.map(DoubleBall::exact);
        let rest = self
            .all
            .iter()
            .zip(&costs)
            .map(|(condition, cost)| (*cost - dot(&condition.motion, &[x, y, z])).lower());
        Ok((rest.fold(f64::INFINITY, f64::min), best))
    }

    /// An upper bound of the value at admissible forces, with rates that fit, one more than there are equations;
    /// `None` where they are not proved to be positive.
    fn value(&self, forces: &Vector, best: &PositiveRates) -> Option<f64> {
        let columns = &best.moving;
        if let [a, b] = columns[..] {
            return self.value_of_opposites([&self.all[a], &self.all[b]], forces);
        }
        let motion = |k: usize| &self.all[columns[k]].motion;
        let is_enough = columns.len() == if self.plane.is_some() { 3 } else { 4 };
        if !is_enough {
            return None;
        }
        // Each rate is the determinant of the other motions, with alternating signs.
        let minor = |skip: usize| {
            let rest: Vec<usize> = (0..columns.len()).filter(|k| *k != skip).collect();
            let size = match rest[..] {
                [a, b] => cross(motion(a), motion(b))[2],
                _ => dot(motion(rest[0]), &cross(motion(rest[1]), motion(rest[2]))),
            };
            if skip.is_multiple_of(2) { size } else { -size }
        };
        let rates: Vec<DoubleBall> = (0..columns.len()).map(minor).collect();
        let sum = rates.iter().fold(rates[0].int(0), |sum, rate| sum + rate);
        let levels: Vec<DoubleBall> = rates.into_iter().map(|rate| rate / sum).collect();
        if !levels.iter().all(|level| level.is_positive().is_proved()) {
            return None;
        }
        let terms = columns.iter().zip(&levels);
        let value = terms.fold(sum.int(0), |value, (column, level)| {
            value - at(&self.all[*column].row, forces) * level
        });
        Some(value.upper())
    }

    /// An upper bound with the two slips of a joint alone, whose motions are opposite: equal rates fit.
    fn value_of_opposites(&self, [a, b]: [&MovingLimit; 2], forces: &Vector) -> Option<f64> {
        let are_slips = !a.contact.is_hinge() && !b.contact.is_hinge();
        let are_opposite = are_slips && a.joint == b.joint && a.contact != b.contact;
        let sum = at(&a.row, forces) + at(&b.row, forces);
        are_opposite.then(|| (-sum / sum.int(2)).upper())
    }
}

/// Tells whether three are paired with each other.
fn has_triangle(pairs: &[[usize; 2]]) -> bool {
    let paired = |a: usize, b: usize| pairs.contains(&[a.max(b), a.min(b)]);
    pairs.iter().enumerate().any(|(n, [a, b])| {
        pairs[..n].iter().flatten().any(|c| c != a && c != b && paired(*a, *c) && paired(*b, *c))
    })
}

#[cfg(test)]
mod tests;
