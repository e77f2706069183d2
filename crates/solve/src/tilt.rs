//! Candidates for the largest horizontal acceleration that an arch of a given thickness can bear, in doubles.
//!
//! It is a linear programme in `h, p, v` and `k`. With a joint at every angle it begins with many of them; where the
//! state that it finds passes a condition at a joint between, that joint comes in too, until no condition is passed.

use super::programme::{HalfSpace, Optimum, largest_last};
use crate::arch::mechanism::Contact;
use crate::arch::tilt::TiltedRow;
use crate::arch::whole::along;
use crate::number::{Angle, Jet};
use crate::problem::Joints;

/// A condition that holds with equality at a joint of the whole arch.
#[derive(Clone, Copy, Debug)]
pub struct TiltTouch {
    /// The condition, by its sign.
    pub contact: Contact,
    /// Angle of the joint, rad, in `[-alpha, alpha]`.
    pub joint: f64,
    /// True if the touch is between the springings.
    pub is_inside: bool,
    /// Multiplier of the condition.
    pub rate: f64,
}

/// Probable limit of the largest acceleration.
#[derive(Clone, Debug)]
pub enum TiltCandidate {
    /// The largest acceleration is this.
    Limited(TiltNear),
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
    /// The state there, `h, p, v, k`. Where only slips touch, nothing fixes `p`, and hinges have room.
    pub state: [f64; 4],
}

/// An arch of a given thickness, with conditions at some of its joints.
pub struct TiltSearch {
    half_opening: f64,
    joints: Joints<f64>,
    /// The conditions that are asked at each joint.
    contacts: &'static [Contact],
    places: Vec<(Contact, f64)>,
    rows: Vec<TiltedRow<f64>>,
}

/// Joints of each condition at the beginning.
const JOINTS: usize = 201;
/// Programmes at most: each has joints nearer to the true ones, as much as Newton's method has.
const ROUNDS: usize = 12;
/// Rounding errors of a condition at a joint.
const ROUNDING: f64 = 1e-14;

/// The conditions at a joint: with unlimited friction slips ask for a normal force alone, of which the two hinges leave
/// no other than a positive one, as what they ask for adds up to it.
pub fn contacts(is_limited: bool) -> &'static [Contact] {
    if is_limited { &Contact::ALL } else { &Contact::ALL[..2] }
}

impl TiltSearch {
    /// An arch by its half opening, and what its joints share.
    pub fn new(half_opening: f64, joints: Joints<f64>, is_limited: bool) -> Self {
        let contacts = contacts(is_limited);
        let (places, rows) = (Vec::new(), Vec::new());
        let mut search = Self { half_opening, joints, contacts, places, rows };
        let joints: Vec<f64> = search.joints().collect();
        let all = joints.iter().flat_map(|joint| contacts.iter().map(move |of| (*of, *joint)));
        all.for_each(|place| search.add(place));
        search
    }

    /// Joints at equal distances, from one springing to the other.
    fn joints(&self) -> impl Iterator<Item = f64> + use<> {
        let alpha = self.half_opening;
        (0..JOINTS).map(move |j| alpha * (2.0 * j as f64 / (JOINTS - 1) as f64 - 1.0))
    }

    fn add(&mut self, (contact, joint): (Contact, f64)) {
        self.places.push((contact, joint));
        self.rows.push(self.joints.tilted(contact, &Angle::new(joint)));
    }

    /// The largest acceleration.
    pub fn candidate(mut self) -> TiltCandidate {
        let mut found = TiltCandidate::Nothing;
        for _ in 0..ROUNDS {
            let (state, active) = match largest_last(&half_spaces(&self.rows)) {
                Optimum::At { unknowns, active } => (unknowns, active),
                Optimum::Unbounded => return TiltCandidate::Unlimited,
                Optimum::Nothing => return found,
            };
            found = TiltCandidate::Limited(self.near(state, &active));
            let passed = self.passed(&state);
            if passed.is_empty() {
                break;
            }
            passed.into_iter().for_each(|place| self.add(place));
        }
        found
    }

    /// The conditions with equality, and the state.
    fn near(&self, mut state: [f64; 4], active: &[(usize, f64)]) -> TiltNear {
        let touches = self.touches(active);
        if !touches.iter().any(|touch| touch.contact.is_hinge()) {
            state[1] = moment_between(&self.rows, state);
        }
        TiltNear { touches, state }
    }

    /// The joints where a state passes a condition farthest, one in each stretch.
    fn passed(&self, state: &[f64; 4]) -> Vec<(Contact, f64)> {
        let joints: Vec<f64> = self.joints().collect();
        let step = joints[1] - joints[0];
        let mut passed = Vec::new();
        for contact in self.contacts {
            let margin = |joint: &f64| self.margin(*contact, *joint, state);
            let margins: Vec<f64> =
                joints.iter().map(|joint| margin(joint).value().to_owned()).collect();
            for j in 0..JOINTS {
                let (before, after) = (j.saturating_sub(1), (j + 1).min(JOINTS - 1));
                if margins[j] > margins[before] || margins[j] > margins[after] {
                    continue;
                }
                let mut lowest = joints[j];
                for _ in 0..4 {
                    let here = margin(&lowest);
                    let (slope, bend) = (here.coefficient(1), here.coefficient(2));
                    if bend > 0.0 {
                        lowest -= (slope / (2.0 * bend)).clamp(-step, step);
                        lowest = lowest.clamp(joints[before], joints[after]);
                    }
                }
                if *margin(&lowest).value() < -ROUNDING {
                    passed.push((*contact, lowest));
                }
            }
        }
        passed
    }

    /// A margin as a series along the arch.
    fn margin(&self, contact: Contact, joint: f64, state: &[f64; 4]) -> Jet<f64> {
        let row = self.joints.constant(2).tilted(contact, &along(&Angle::new(joint)));
        -row.at(&state.map(|x| Jet::constant(x, 2)), &Jet::constant(1.0, 2))
    }

    /// Conditions, by place, that probably contradict each other at an acceleration.
    pub fn against(&self, tilt: f64) -> Option<Vec<(Contact, f64)>> {
        let places = against(&self.rows, tilt)?;
        Some(places.into_iter().filter_map(|place| self.places.get(place).copied()).collect())
    }

    /// The `h, p, v, k` at an acceleration that are farthest from all conditions, if some are inside.
    pub fn inside_at(&self, tilt: f64) -> Option<[f64; 4]> {
        inside(&self.rows, tilt)
    }

    /// The joints of the programme that hold with equality: neighbours are one.
    fn touches(&self, active: &[(usize, f64)]) -> Vec<TiltTouch> {
        let alpha = self.half_opening;
        let step = 2.0 * alpha / (JOINTS - 1) as f64;
        let mut touches: Vec<TiltTouch> = Vec::new();
        for &(index, rate) in active {
            let (contact, joint) = self.places[index];
            let is_near = |of: &&mut TiltTouch| {
                of.contact == contact && (of.joint - joint).abs() < 1.5 * step
            };
            match touches.iter_mut().find(is_near) {
                Some(near) => {
                    near.joint = (near.joint * near.rate + joint * rate) / (near.rate + rate);
                    near.rate += rate;
                }
                None => touches.push(TiltTouch { contact, joint, is_inside: true, rate }),
            }
        }
        for touch in &mut touches {
            touch.is_inside = alpha - touch.joint.abs() > 1e-6 * step;
        }
        touches
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
    rows.iter().map(|row| half_space(row, row.coefficients, -row.load)).collect()
}

/// A condition with coefficients next to one: those of a slip grow with the friction, of a hinge as the arch gets thin.
fn half_space(row: &TiltedRow<f64>, a: [f64; 4], d: f64) -> HalfSpace {
    let size = row.coefficients.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    HalfSpace { a: a.map(|x| x / size), d: d / size }
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
        half_space(row, [h, p, v, 1.0], -row.load - k * tilt)
    };
    // More room than one is not asked for.
    let most = HalfSpace { a: [0.0, 0.0, 0.0, 1.0], d: 1.0 };
    largest_last(&rows.iter().map(slack).chain([most]).collect::<Vec<_>>())
}
