//! Candidates for the largest horizontal acceleration that an arch of a given thickness can bear.
//!
//! On many joints of the whole arch it is a linear programme in `h, p, v` and `k`. The conditions that hold with
//! equality are then moved to where they touch: Newton's method on the unknowns, the joints and the multipliers
//! together,
//!
//! ```text
//! sum of rates times coefficients = (0, 0, 0, 1)      condition = 0      slope of the condition = 0 inside the arch
//! ```
//!
//! as a line that touches may need fewer joints than unknowns. Where only slips count, nothing fixes `p`.

use crate::arch::mechanism::Contact;
use crate::arch::tilt::TiltedRow;
use crate::arch::whole::along;
use crate::number::{Angle, Field, Jet};
use crate::problem::Joints;
use crate::solve::inverse;
use crate::solve::programme::{HalfSpace, Optimum, largest_last};
use rug::Float;

/// A condition at a joint of the whole arch.
#[derive(Clone, Debug)]
pub struct TiltTouch {
    /// The condition, by its sign.
    pub contact: Contact,
    /// Angle of the joint, rad, in `[-alpha, alpha]`.
    pub joint: Float,
    /// True if the touch is between the springings.
    pub is_inside: bool,
}

/// Probable limit of the largest acceleration.
#[derive(Clone, Debug)]
pub enum TiltCandidate {
    /// The largest acceleration is this.
    Limited(Box<TiltNear>),
    /// There is no largest acceleration.
    Unlimited,
    /// Nothing is admissible at any acceleration.
    Nothing,
}

/// The largest acceleration as far as it is known.
#[derive(Clone, Debug)]
pub struct TiltNear {
    /// The conditions that hold with equality.
    pub touches: Vec<TiltTouch>,
    /// Multipliers of these conditions.
    pub rates: Vec<Float>,
    /// The state there, `h, p, v, k`.
    pub limit: [Float; 4],
    /// A state inside all conditions.
    pub inside: [Float; 4],
}

/// An arch of a given thickness in numbers of some bits.
pub struct TiltSearch {
    half_opening: Float,
    joints: Joints<Float>,
    /// The conditions that are asked at each joint.
    contacts: &'static [Contact],
    bits: u32,
}

/// Joints of each condition in the programme.
const JOINTS: usize = 401;
/// Newton's steps beyond those that double the digits.
const EXTRA: u32 = 12;

/// The conditions at a joint: with unlimited friction both slips ask for a normal force, and one is enough.
pub fn contacts(is_limited: bool) -> &'static [Contact] {
    if is_limited { &Contact::ALL } else { &Contact::ALL[..3] }
}

impl TiltSearch {
    /// An arch by its half opening, and what its joints share.
    pub fn new(half_opening: Float, joints: Joints<Float>, is_limited: bool, bits: u32) -> Self {
        Self { half_opening, joints, contacts: contacts(is_limited), bits }
    }

    /// The largest acceleration.
    pub fn candidate(&self) -> TiltCandidate {
        let (places, rows) = self.grid();
        let (unknowns, active) = match largest_last(&half_spaces(&rows)) {
            Optimum::At { unknowns, active } => (unknowns, active),
            Optimum::Unbounded => return TiltCandidate::Unlimited,
            Optimum::Nothing => return TiltCandidate::Nothing,
        };
        let Some(inside) = inside(&rows, unknowns[3] / 2.0) else {
            return TiltCandidate::Nothing;
        };
        let mut touches = self.touches(&places, active);
        let limit = self.settled(unknowns, &mut touches);
        let inside = inside.map(|x| Float::with_val(self.bits, x));
        let (touches, rates) = touches.into_iter().unzip();
        TiltCandidate::Limited(Box::new(TiltNear { touches, rates, limit, inside }))
    }

    /// The `h, p, v, k` at an acceleration that are farthest from all conditions, if some are inside.
    pub fn inside_at(&self, tilt: f64) -> Option<[f64; 4]> {
        inside(&self.grid().1, tilt)
    }

    /// The conditions on many joints, with their places.
    fn grid(&self) -> (Vec<(Contact, f64)>, Vec<TiltedRow<f64>>) {
        let alpha = self.half_opening.to_f64();
        let joints = self.joints.map(Float::to_f64);
        let places = (0..JOINTS).map(|j| alpha * (2.0 * j as f64 / (JOINTS - 1) as f64 - 1.0));
        let at = |place: f64| {
            let angle = Angle::new(place);
            let row = |contact: &Contact| ((*contact, place), joints.tilted(*contact, &angle));
            self.contacts.iter().map(row).collect::<Vec<_>>()
        };
        places.flat_map(at).unzip()
    }

    /// The joints of the programme that hold with equality: neighbours are one.
    fn touches(
        &self,
        places: &[(Contact, f64)],
        active: Vec<(usize, f64)>,
    ) -> Vec<(TiltTouch, Float)> {
        let alpha = self.half_opening.to_f64();
        let step = 2.0 * alpha / (JOINTS - 1) as f64;
        let mut merged: Vec<(Contact, f64, f64)> = Vec::new();
        for (index, rate) in active {
            let (contact, joint) = &places[index];
            let near = merged
                .iter_mut()
                .find(|(other, at, _)| other == contact && (at as &f64 - joint).abs() < 1.5 * step);
            match near {
                Some((_, at, sum)) => {
                    *at = (*at * *sum + joint * rate) / (*sum + rate);
                    *sum += rate;
                }
                None => merged.push((*contact, *joint, rate)),
            }
        }
        let float = |x: f64| Float::with_val(self.bits, x);
        let touch = |(contact, joint, rate): (Contact, f64, f64)| {
            let is_inside = alpha - joint.abs() > 0.1 * step;
            let joint = match is_inside {
                true => float(joint),
                false if joint > 0.0 => self.half_opening.clone(),
                false => -self.half_opening.clone(),
            };
            (TiltTouch { contact, joint, is_inside }, float(rate))
        };
        merged.into_iter().map(touch).collect()
    }

    /// The row at a joint as a series along the arch.
    fn series(&self, touch: &TiltTouch) -> TiltedRow<Jet<Float>> {
        let at = along(&Angle::new(touch.joint.clone()));
        self.joints.constant(2).tilted(touch.contact, &at)
    }

    /// Newton's method: the unknowns, with the touching joints moved.
    fn settled(&self, start: [f64; 4], touches: &mut [(TiltTouch, Float)]) -> [Float; 4] {
        let mut unknowns = start.map(|x| Float::with_val(self.bits, x));
        let is_pinned = touches.iter().any(|(touch, _)| touch.contact.is_hinge());
        // Of the unknowns: without a hinge nothing is said of p.
        let kept: &[usize] = if is_pinned { &[0, 1, 2, 3] } else { &[0, 2, 3] };
        for _ in 0..EXTRA + self.bits.ilog2() {
            let Some(step) = self.step(&unknowns, touches, kept) else { break };
            let mut step = step.into_iter();
            let mut next = || step.next().unwrap_or_else(|| Float::with_val(self.bits, 0));
            kept.iter().for_each(|k| unknowns[*k] -= next());
            for (touch, _) in touches.iter_mut().filter(|(touch, _)| touch.is_inside) {
                touch.joint -= next();
            }
            touches.iter_mut().for_each(|(_, rate)| *rate -= next());
        }
        if !is_pinned {
            let near = unknowns.each_ref().map(Float::to_f64);
            unknowns[1] = Float::with_val(self.bits, moment_between(&self.grid().1, near));
        }
        unknowns
    }

    /// A step of Newton's method: for the unknowns, the joints inside, the multipliers.
    fn step(
        &self,
        unknowns: &[Float; 4],
        touches: &[(TiltTouch, Float)],
        kept: &[usize],
    ) -> Option<Vec<Float>> {
        let zero = Float::with_val(self.bits, 0);
        let one = Jet::constant(zero.int(1), 2);
        let inside: Vec<usize> = (0..touches.len()).filter(|i| touches[*i].0.is_inside).collect();
        let joint_column = |i: usize| inside.iter().position(|j| *j == i).map(|j| kept.len() + j);
        let rate_column = |i: usize| kept.len() + inside.len() + i;
        let size = kept.len() + inside.len() + touches.len();
        let rows: Vec<_> = touches.iter().map(|(touch, _)| self.series(touch)).collect();
        let values = unknowns.each_ref().map(|x| Jet::constant(x.clone(), 2));
        let mut matrix = Vec::new();
        let mut residuals = Vec::new();
        for k in kept {
            let mut line = vec![zero.clone(); size];
            let mut residual = if *k == 3 { -zero.int(1) } else { zero.clone() };
            for (i, (_, rate)) in touches.iter().enumerate() {
                let coefficient = &rows[i].coefficients[*k];
                residual += coefficient.coefficient(0) * rate;
                line[rate_column(i)] = coefficient.coefficient(0);
                if let Some(column) = joint_column(i) {
                    line[column] = coefficient.coefficient(1) * rate;
                }
            }
            matrix.push(line);
            residuals.push(residual);
        }
        for order in 0..2 {
            for (i, row) in rows.iter().enumerate() {
                if order == 1 && joint_column(i).is_none() {
                    continue;
                }
                let condition = row.at(&values, &one);
                let mut line = vec![zero.clone(); size];
                for (column, k) in kept.iter().enumerate() {
                    line[column] = row.coefficients[*k].coefficient(order);
                }
                if let Some(column) = joint_column(i) {
                    line[column] = condition.coefficient(order + 1) * (order as u32 + 1);
                }
                matrix.push(line);
                residuals.push(condition.coefficient(order));
            }
        }
        let inverse = inverse(matrix)?;
        let product = |line: &Vec<Float>| {
            let terms = line.iter().zip(&residuals);
            terms.fold(zero.clone(), |sum, (a, b)| sum + Float::with_val(self.bits, a * b))
        };
        Some(inverse.iter().map(product).collect())
    }
}

/// Probable limit of the largest acceleration of an arch of stones.
#[derive(Clone, Debug)]
pub enum StoneTilt {
    /// Some conditions limit it, by place; if none of them is a hinge, with a crown moment that leaves room.
    Limited {
        /// The conditions.
        active: Vec<usize>,
        /// `p`.
        moment: f64,
    },
    /// There is no largest acceleration: this `h, p, v` may be added for each unit of the acceleration.
    Unlimited([f64; 3]),
    /// Nothing is admissible at any acceleration.
    Nothing,
}

fn half_spaces(rows: &[TiltedRow<f64>]) -> Vec<HalfSpace> {
    rows.iter().map(|row| HalfSpace { a: row.coefficients, d: -row.load }).collect()
}

/// The largest acceleration under conditions.
pub fn largest(rows: &[TiltedRow<f64>]) -> StoneTilt {
    match largest_last(&half_spaces(rows)) {
        Optimum::At { unknowns, active } => StoneTilt::Limited {
            active: active.into_iter().map(|(place, _)| place).collect(),
            moment: moment_between(rows, unknowns),
        },
        Optimum::Unbounded => {
            let along: Vec<TiltedRow<f64>> =
                rows.iter().map(|row| TiltedRow { load: 0.0, ..row.clone() }).collect();
            match inside(&along, 1.0) {
                Some([h, p, v, _]) => StoneTilt::Unlimited([h, p, v]),
                None => StoneTilt::Nothing,
            }
        }
        Optimum::Nothing => StoneTilt::Nothing,
    }
}

/// The middle of what hinges leave to the crown moment.
fn moment_between(rows: &[TiltedRow<f64>], mut unknowns: [f64; 4]) -> f64 {
    unknowns[1] = 0.0;
    let (mut least, mut most) = (f64::MIN, f64::MAX);
    for row in rows {
        let (p, room) = (row.coefficients[1], -row.at(&unknowns, &1.0));
        if p > 0.0 {
            most = most.min(room / p);
        } else if p < 0.0 {
            least = least.max(room / p);
        }
    }
    (least + most) / 2.0
}

/// Conditions, by place, that probably contradict each other at an acceleration.
pub fn against(rows: &[TiltedRow<f64>], tilt: f64) -> Option<Vec<usize>> {
    match farthest(rows, tilt) {
        Optimum::At { unknowns: [.., room], active } if room < 0.0 => {
            Some(active.into_iter().map(|(place, _)| place).collect())
        }
        _ => None,
    }
}

/// The `h, p, v, k` at an acceleration `k` that are farthest from all conditions, if some are inside.
pub fn inside(rows: &[TiltedRow<f64>], tilt: f64) -> Option<[f64; 4]> {
    match farthest(rows, tilt) {
        Optimum::At { unknowns: [h, p, v, room], .. } if room > 0.0 => Some([h, p, v, tilt]),
        _ => None,
    }
}

/// The largest room that all conditions leave at an acceleration, in place of `k`.
fn farthest(rows: &[TiltedRow<f64>], tilt: f64) -> Optimum {
    let slack = |row: &TiltedRow<f64>| {
        let [h, p, v, k] = row.coefficients;
        HalfSpace { a: [h, p, v, 1.0], d: -row.load - k * tilt }
    };
    // More room than one is not asked for.
    let most = HalfSpace { a: [0.0, 0.0, 0.0, 1.0], d: 1.0 };
    largest_last(&rows.iter().map(slack).chain([most]).collect::<Vec<_>>())
}
