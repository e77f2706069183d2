//! Whether forces exist that an arch bears at every joint: some that it does, or joints whose conditions contradict each
//! other.

use super::ball::Ball;
use super::ring::{Contact, Joint, Load, Ring};
use rug::Integer;

/// An arch of a thickness.
pub(crate) struct Arch {
    pub(crate) ring: Ring,
    pub(crate) half_opening: Ball,
}

/// Joints at which something may give way.
pub(crate) type Joints = Vec<(Contact, Joint)>;

/// What is proved of an arch, and roughly how much room the best forces leave at the worst joint.
pub(crate) struct Decided {
    pub(crate) stands: bool,
    pub(crate) room: Integer,
    pub(crate) joints: Joints,
    pub(crate) forces: [Ball; 2],
}

/// Forces that leave as much room as can be at some joints, and which joints say so: of all triples with weights that
/// lift thrust and moment from the sum of their rooms the one whose forces leave most at the others.
struct Best {
    forces: [Ball; 2],
    room: Ball,
    triple: [usize; 3],
}

fn minors(rows: [&[Ball; 3]; 3]) -> [Ball; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let [[a, b, _], [c, d, _]] = [rows[i], rows[j]];
        &(a * d) - &(b * c)
    })
}

/// Sum of the rooms with these weights, which thrust and moment are lifted from.
fn rest(rows: [&[Ball; 3]; 3], weights: &[Ball; 3]) -> Ball {
    let [x, y, z] = [0, 1, 2].map(|k| &weights[k] * &rows[k][2]);
    &(&x + &y) + &z
}

/// Tells whether the conditions of three joints contradict each other, whatever the forces: weights of one sign lift both
/// forces from the sum of the rooms, and what is left is below zero. This is a mechanism, and the work of the weight.
pub(crate) fn contradict(rows: [&[Ball; 3]; 3]) -> bool {
    let mut weights = minors(rows);
    if weights.iter().any(Ball::is_negative) {
        weights = weights.map(|x| -x);
    }
    weights.iter().all(Ball::is_not_negative) && rest(rows, &weights).is_negative()
}

/// The room that forces leave.
fn room_of([by_thrust, by_moment, rest]: &[Ball; 3], [thrust, moment]: &[Ball; 2]) -> Ball {
    &(&(by_thrust * thrust) + &(by_moment * moment)) + rest
}

impl Arch {
    /// Joints in equal steps: each but the last by one step more than that before.
    fn grid(&self, steps: u32) -> Vec<Joint> {
        let step = Joint::new(&self.half_opening.over(steps));
        let mut grid = vec![Joint::new(&self.half_opening.int(0))];
        for k in 1..steps {
            let Joint { sin, cos, .. } = &grid[grid.len() - 1];
            grid.push(Joint {
                at: (&self.half_opening * &step.at.int(k as i32)).over(steps),
                sin: &(sin * &step.cos) + &(cos * &step.sin),
                cos: &(cos * &step.cos) - &(sin * &step.sin),
            });
        }
        grid.push(Joint::new(&self.half_opening));
        grid
    }

    fn best(&self, rows: &[[Ball; 3]]) -> Option<Best> {
        // The best forces leave no more room than any three joints whose weights have one sign.
        let minor = |one: &[Ball; 3], other: &[Ball; 3]| {
            (&(&one[0] * &other[1]) - &(&one[1] * &other[0])).point()
        };
        let pairs: Vec<Vec<Ball>> =
            rows.iter().map(|one| rows.iter().map(|other| minor(one, other)).collect()).collect();
        let levels = triples(rows.len()).filter_map(|triple| {
            let [i, j, k] = triple;
            let weights = [&pairs[j][k], &pairs[k][i], &pairs[i][j]];
            if !(weights.iter().all(|x| x.mid >= 0) || weights.iter().all(|x| x.mid <= 0)) {
                return None;
            }
            let weights = weights.map(Ball::clone);
            let total = &(&weights[0] + &weights[1]) + &weights[2];
            let sum = rest(triple.map(|k| &rows[k]), &weights);
            Some((sum.point().divided_by(&total.point())?, triple))
        });
        let levels: Vec<(Ball, [usize; 3])> = levels.collect();
        let lowest = levels.iter().map(|(level, _)| &level.mid).min()?;
        let most = Integer::from(lowest.abs_ref()) >> 32;
        let most = most + lowest + 1024u32;
        let mut best: Option<(Integer, Best)> = None;
        for (level, triple) in levels.iter().filter(|(level, _)| level.mid <= most) {
            let three = triple.map(|k| &rows[k]);
            // The two forces at which the three have the same room.
            let [p, q] = [1, 2].map(|n| [0, 1, 2].map(|x| &three[n][x] - &three[0][x]));
            let across = &(&p[0] * &q[1]) - &(&p[1] * &q[0]);
            let forces = [(1, 2), (2, 0)].map(|(x, y)| {
                (&(&p[x] * &q[y]) - &(&p[y] * &q[x])).point().divided_by(&across.point())
            });
            let [Some(h), Some(m)] = forces else { continue };
            let forces = [h.point(), m.point()];
            let least = rows.iter().map(|row| room_of(row, &forces).mid).min().expect("rows");
            let gap = Integer::from(&level.mid - &least);
            if best.as_ref().is_none_or(|(least, _)| gap < *least) {
                best = Some((gap, Best { forces, room: level.clone(), triple: *triple }));
            }
        }
        best.map(|(_, best)| best)
    }

    /// Decides, from these joints on, at first: the worst joint for the forces that are best at them is one more, until
    /// none is worse.
    pub(crate) fn decide(&self, hints: &[(Contact, Ball)]) -> Result<Decided, String> {
        const STEPS: usize = 40;
        const GRID: u32 = 16;
        let Self { ring, half_opening } = self;
        let one = half_opening.int(1);
        let zero = half_opening.int(0);
        let grid = self.grid(GRID);
        let rows_of_grid: Vec<Vec<[Ball; 3]>> = ring
            .contacts()
            .iter()
            .map(|contact| grid.iter().map(|joint| ring.row(*contact, joint)).collect())
            .collect();
        let mut joints: Joints = Vec::new();
        // A hint of a wider arch is no joint of this one.
        for (contact, at) in hints.iter().filter(|(_, at)| at.high() <= half_opening.high()) {
            joints.push((*contact, Joint::new(at)));
        }
        for contact in ring.contacts() {
            for k in [0, GRID / 2, GRID] {
                joints.push((*contact, grid[k as usize].clone()));
            }
        }
        let mut rows: Vec<[Ball; 3]> =
            joints.iter().map(|(c, joint)| ring.row(*c, joint)).collect();
        // Of the arches that stand some do with less thrust than this; no contradiction may rest on it.
        rows.push([-one.clone(), zero.clone(), one.int(4)]);
        for _ in 0..STEPS {
            let Some(Best { forces, room, triple }) = self.best(&rows) else {
                return Err("no three joints bound the room".into());
            };
            let [thrust, moment] = &forces;
            let load = Load { thrust, moment, vertical: &zero, weight: &one };
            let mut news = Vec::new();
            for (contact, rows) in ring.contacts().iter().zip(&rows_of_grid) {
                let rooms: Vec<Integer> =
                    rows.iter().map(|row| room_of(row, &forces).mid).collect();
                for k in 0..rooms.len() {
                    let lowest = |n: Option<usize>| {
                        n.and_then(|n| rooms.get(n)).is_none_or(|x| *x >= rooms[k])
                    };
                    if !lowest(k.checked_sub(1)) || !lowest(Some(k + 1)) {
                        continue;
                    }
                    // A valley is not as deep below its lowest joint as the next ones are above.
                    let around = &rooms[k.saturating_sub(1)..(k + 2).min(rooms.len())];
                    let depth = Integer::from(around.iter().max().expect("joints") - &rooms[k]);
                    if (&rooms[k] - depth) > room.mid {
                        continue;
                    }
                    let (first, last) =
                        (&grid[k.saturating_sub(1)], &grid[(k + 1).min(grid.len() - 1)]);
                    let start = self.narrowed(*contact, [&first.at, &last.at], &load);
                    let is_last = start.mid >= half_opening.low();
                    let joint =
                        if is_last { grid[GRID as usize].clone() } else { Joint::new(&start) };
                    let found = ring.room(*contact, &joint, &load, 0).mid;
                    let gap = Integer::from(&room.mid - &found);
                    if gap > Integer::from(room.mid.abs_ref()) >> 20 && gap > 64 {
                        news.push((gap, *contact, joint));
                    }
                }
            }
            if news.is_empty() {
                let joints: Joints =
                    triple.iter().filter_map(|k| joints.get(*k).cloned()).collect();
                let stands = room.mid > 0;
                let proved = match stands {
                    true => self.bears(&forces),
                    false => joints.len() == 3 && contradict(triple.each_ref().map(|k| &rows[*k])),
                };
                return match proved {
                    true => Ok(Decided { stands, room: room.mid, joints, forces }),
                    false => Err(format!(
                        "stands {stands} is not shown, room {:e}",
                        room.rational().to_f64()
                    )),
                };
            }
            // Of the others none is among those that decide.
            let keep = triple.map(|k| (joints.get(k).cloned(), rows[k].clone()));
            let last = rows.pop().expect("the bound of the thrust");
            (joints, rows) =
                keep.into_iter().filter_map(|(joint, row)| Some((joint?, row))).unzip();
            for (_, contact, joint) in news {
                rows.push(ring.row(contact, &joint));
                joints.push((contact, joint));
            }
            rows.push(last);
        }
        Err("no end of worse joints".into())
    }

    /// A joint of little room between two: halved towards the falling side, then by Newton's steps.
    fn narrowed(&self, contact: Contact, [from, to]: [&Ball; 2], load: &Load) -> Ball {
        let mut piece = from.hull(to);
        for _ in 0..6 {
            let slope = self.ring.room(contact, &Joint::new(&piece.point()), load, 1);
            let half: Integer = Integer::from(&piece.rad + 1u32) >> 1;
            let sign = if slope.mid > 0 { -half.clone() } else { half.clone() };
            piece = piece.at(sign + &piece.mid).wider(&half);
        }
        self.ring.least(contact, &piece, load)
    }

    /// Tells whether these forces are borne at every joint: nowhere is room below zero.
    pub(crate) fn bears(&self, [thrust, moment]: &[Ball; 2]) -> bool {
        let (zero, weight) = (&self.half_opening.int(0), &self.half_opening.int(1));
        let load = Load { thrust, moment, vertical: zero, weight };
        self.ring.contacts().iter().all(|c| self.ring.holds(*c, [zero, &self.half_opening], &load))
    }

    /// Thrusts that these joints leave, lowest and highest: each pair of them, or one that slides alone, bounds it.
    pub(crate) fn thrusts(&self, joints: &[(Contact, Joint)]) -> [Option<Integer>; 2] {
        let rows: Vec<[Ball; 3]> =
            joints.iter().map(|(c, joint)| self.ring.row(*c, joint)).collect();
        let mut ends: [Option<Integer>; 2] = [None, None];
        let mut bound = |[slope, rest]: [Ball; 2]| {
            // slope h + rest >= 0
            let Some(end) = rest.divided_by(&slope).map(|x| -x) else { return };
            let [low, high] = &mut ends;
            match slope.is_positive() {
                true => *low = Some(low.take().map_or(end.low(), |x| x.max(end.low()))),
                false => *high = Some(high.take().map_or(end.high(), |x| x.min(end.high()))),
            }
        };
        for (i, one) in rows.iter().enumerate() {
            if joints[i].0.slides() {
                bound([one[0].clone(), one[2].clone()]);
            }
            for other in &rows[..i] {
                let (up, down) = match (one[1].is_positive(), other[1].is_negative()) {
                    (true, true) => (one, other),
                    _ if one[1].is_negative() && other[1].is_positive() => (other, one),
                    _ => continue,
                };
                bound([0, 2].map(|k| &(&up[k] * &-down[1].clone()) + &(&down[k] * &up[1])));
            }
        }
        ends
    }
}

fn triples(n: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..n).flat_map(move |k| (0..k).flat_map(move |j| (0..j).map(move |i| [i, j, k])))
}
