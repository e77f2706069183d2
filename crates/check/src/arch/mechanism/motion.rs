//! Finite motions of the blocks: what a picture shows, as scaled velocities would stretch the blocks.
//!
//! Each mode has one parameter, the angle by which the half arch turns about the shoulder's hinge, clockwise, or
//! the slip at the shoulder. Everything else follows in closed form: a crown that stays on the axis.

use super::Contact;
use crate::arch::Configuration;
use crate::number::{Angle, Field, Real};

/// A rigid motion, `X` to `R X + shift`.
#[derive(Clone, Debug)]
pub struct Motion<T> {
    /// Cosine and sine of the rotation, counter-clockwise.
    pub turn: [T; 2],
    /// The shift behind it.
    pub shift: [T; 2],
}

impl<T: Field> Motion<T> {
    /// A translation.
    pub fn translation(shift: [T; 2]) -> Self {
        Self { turn: [shift[0].int(1), shift[0].int(0)], shift }
    }

    /// The rotation that takes a point to another, by the cosine and sine of its angle.
    pub fn about(from: &[T; 2], to: &[T; 2], turn: [T; 2]) -> Self {
        let turned = Self { shift: [turn[0].int(0), turn[0].int(0)], turn };
        let shift = difference(to, &turned.to(from));
        Self { shift, ..turned }
    }

    /// Place to which a point goes.
    pub fn to(&self, [x, y]: &[T; 2]) -> [T; 2] {
        let ([cos, sin], [right, up]) = (&self.turn, &self.shift);
        [cos.clone() * x - sin.clone() * y + right, sin.clone() * x + cos.clone() * y + up]
    }

    /// Motion followed by a translation by so many times a vector, which turns with the block.
    fn slid(&self, by: &T, [x, y]: &[T; 2]) -> Self {
        let [cos, sin] = &self.turn;
        let along = [cos.clone() * x - sin.clone() * y, sin.clone() * x + cos.clone() * y];
        let [right, up] = [0, 1].map(|k| self.shift[k].clone() + along[k].clone() * by);
        Self { turn: self.turn.clone(), shift: [right, up] }
    }
}

fn difference<T: Field>(to: &[T; 2], from: &[T; 2]) -> [T; 2] {
    [to[0].clone() - &from[0], to[1].clone() - &from[1]]
}

/// The points about which an arch turns: at the shoulder's extrados, the haunch's intrados, the crown's extrados.
fn hinges<T: Field>(at: &Configuration<T>) -> [[T; 2]; 3] {
    let two = at.thickness.int(2);
    let (outer, inner) = (two.clone() + &at.thickness, two.clone() - &at.thickness);
    let point =
        |twice: &T, joint: &Angle<T>| [&joint.sin, &joint.cos].map(|x| twice.clone() * x / &two);
    let (shoulder, haunch) = (&at.half_opening, &at.rotation_joint);
    [point(&outer, shoulder), point(&inner, haunch), point(&outer, &at.crown_hinge)]
}

/// The half arch turned about the shoulder's hinge.
fn turned<T: Field>(at: &Configuration<T>, by: &Angle<T>) -> Motion<T> {
    let [shoulder, _, _] = hinges(at);
    Motion::about(&shoulder, &shoulder, [by.cos.clone(), -by.sin.clone()])
}

/// The direction in which a joint slides.
fn direction<T: Field>(contact: Contact, joint: &Angle<T>, dilatancy: &T) -> [T; 2] {
    contact.twist(joint, dilatancy, dilatancy).velocity
}

/// The part above the haunch, as its hinge moves with the part below and the crown's stays on the axis, or as far
/// from it.
fn above_haunch<T: Real>(at: &Configuration<T>, lower: Motion<T>) -> Vec<Motion<T>> {
    let [_, haunch, crown] = hinges(at);
    let (moved, [x, y]) = (lower.to(&haunch), difference(&crown, &haunch));
    // The rotation that takes the bar from the haunch to the crown, (x, y), to (across, height).
    let across = crown[0].clone() - &moved[0];
    let square = x.square() + y.square();
    let height = (square.clone() - across.square()).sqrt();
    let cos = (height.clone() * &y + across.clone() * &x) / &square;
    let sin = (height * &x - across * &y) / square;
    let upper = Motion::about(&haunch, &moved, [cos, sin]);
    vec![lower, upper]
}

/// A keystone above the crown's hinge, as the block below moves it.
pub fn moves_keystone<T: Field>(at: &Configuration<T>, below: &Motion<T>) -> Motion<T> {
    let [_, _, crown] = hinges(at);
    Motion::translation(difference(&below.to(&crown), &crown))
}

/// `[r,r,r]` by the angle at the shoulder.
pub fn moves_rotating<T: Real>(at: &Configuration<T>, by: &Angle<T>) -> Vec<Motion<T>> {
    above_haunch(at, turned(at, by))
}

/// `[s,r,r]` by the slip at the shoulder.
pub fn moves_with_shoulder_sliding<T: Real>(
    at: &Configuration<T>,
    by: &T,
    dilatancy: &T,
) -> Vec<Motion<T>> {
    let along = direction(Contact::Outwards, &at.half_opening, dilatancy);
    above_haunch(at, Motion::translation(along.map(|x| x * by)))
}

/// `[r,r,s]` by the angle at the shoulder: above the haunch the blocks do not turn.
pub fn moves_sliding_above_haunch<T: Field>(
    at: &Configuration<T>,
    by: &Angle<T>,
    dilatancy: &T,
) -> Vec<Motion<T>> {
    let (lower, [_, haunch, _]) = (turned(at, by), hinges(at));
    let middle = Motion::translation(difference(&lower.to(&haunch), &haunch));
    let along = direction(Contact::Inwards, &at.sliding_joint, dilatancy);
    let slip = -(middle.shift[0].clone() / &along[0]);
    let keystone = middle.slid(&slip, &along);
    vec![lower, middle, keystone]
}

/// `[r,s,r]` by the angle at the shoulder: the middle block turns with the lower one.
pub fn moves_sliding_below_haunch<T: Field>(
    at: &Configuration<T>,
    by: &Angle<T>,
    dilatancy: &T,
) -> Vec<Motion<T>> {
    let [_, haunch, _] = hinges(at);
    let mut moves = moves_overturning_sliding(at, by, dilatancy);
    let keystone = moves.last().map(|middle| difference(&middle.to(&haunch), &haunch));
    moves.extend(keystone.map(Motion::translation));
    moves
}

/// `[r,s]` by the angle at the shoulder: the point of the haunch, at the crown, stays on the axis.
pub fn moves_overturning_sliding<T: Field>(
    at: &Configuration<T>,
    by: &Angle<T>,
    dilatancy: &T,
) -> Vec<Motion<T>> {
    let (lower, [_, haunch, _]) = (turned(at, by), hinges(at));
    let along = direction(Contact::Inwards, &at.sliding_joint, dilatancy);
    let zero = at.thickness.int(0);
    let turned_along = Motion { turn: lower.turn.clone(), shift: [zero.clone(), zero] }.to(&along);
    let slip = -(difference(&lower.to(&haunch), &haunch)[0].clone() / &turned_along[0]);
    let upper = lower.slid(&slip, &along);
    vec![lower, upper]
}

/// `[r]` by the angle at the shoulder.
pub fn moves_overturning<T: Field>(at: &Configuration<T>, by: &Angle<T>) -> Vec<Motion<T>> {
    vec![turned(at, by)]
}

/// `[s,s]` by the slip at the shoulder.
pub fn moves_sliding<T: Field>(at: &Configuration<T>, by: &T, dilatancy: &T) -> Vec<Motion<T>> {
    let outwards = direction(Contact::Outwards, &at.half_opening, dilatancy);
    let lower = Motion::translation(outwards.map(|x| x * by));
    let along = direction(Contact::Inwards, &at.sliding_joint, dilatancy);
    let slip = -(lower.shift[0].clone() / &along[0]);
    let keystone = lower.slid(&slip, &along);
    vec![lower, keystone]
}

#[cfg(test)]
mod tests {
    use super::super::modes::{self, Mechanism};
    use super::*;
    use crate::number::Dual;

    fn at() -> Configuration<f64> {
        Configuration {
            half_opening: Angle::new(2.4),
            rotation_joint: Angle::new(0.9),
            sliding_joint: Angle::new(0.35),
            thickness: 0.55,
            thrust: 0.2,
            friction: 1.3,
            ..Configuration::zero(&0.0)
        }
    }

    type Moves<T> = fn(&Configuration<T>, &T, &T) -> Vec<Motion<T>>;

    /// The motions with their mechanisms, by the angle or the slip at the shoulder.
    fn all<T: Real>(at: &Configuration<T>, dilatancy: &T) -> [(Moves<T>, Mechanism<T>); 7] {
        [
            (|at, by, _| moves_rotating(at, &Angle::new(by.clone())), modes::rotation(at)),
            (moves_with_shoulder_sliding, modes::shoulder_sliding(at, dilatancy)),
            (
                |at, by, d| moves_sliding_above_haunch(at, &Angle::new(by.clone()), d),
                modes::sliding_above_haunch(at, dilatancy),
            ),
            (
                |at, by, d| moves_sliding_below_haunch(at, &Angle::new(by.clone()), d),
                modes::sliding_below_haunch(at, dilatancy),
            ),
            (
                |at, by, d| moves_overturning_sliding(at, &Angle::new(by.clone()), d),
                modes::overturning_sliding(at, dilatancy),
            ),
            (|at, by, _| moves_overturning(at, &Angle::new(by.clone())), modes::overturning(at)),
            (moves_sliding, modes::sliding(at, dilatancy)),
        ]
    }

    /// The mode with the haunch where it has it.
    fn place(k: usize) -> Configuration<f64> {
        match k {
            4 | 5 => Configuration { rotation_joint: Angle::zero(&1.0), ..at() },
            _ => at(),
        }
    }

    const POINTS: [[f64; 2]; 3] = [[0.3, 0.8], [1.1, 0.0], [0.7, -0.7]];

    /// The derivative of each motion is the twist of its block, for the rate one at the shoulder.
    #[test]
    fn motions_begin_with_the_twists() {
        for dilatancy in [0.0, 0.6] {
            for k in 0..7 {
                let at = place(k);
                let dual = at.clone().map(Dual::constant);
                let (by, opens) = (Dual::variable(0.0, 0), Dual::constant(dilatancy));
                let moves = all(&dual, &opens)[k].0(&dual, &by, &opens);
                let mechanism = &all(&at, &dilatancy)[k].1;
                let twists = mechanism.twists(&at.thickness);
                assert_eq!(moves.len(), twists.len());
                let rate = mechanism.joints[0].rate;
                for (motion, twist) in moves.iter().zip(&twists) {
                    for point in POINTS {
                        let moved = motion.to(&point.map(Dual::constant));
                        let velocity = twist.at(&point);
                        for axis in [0, 1] {
                            let (value, slope) = (moved[axis].value(), moved[axis].derivative(0));
                            approx::assert_relative_eq!(*value, point[axis], epsilon = 1e-14);
                            let expected = velocity[axis] / rate;
                            approx::assert_relative_eq!(slope, expected, epsilon = 1e-13);
                        }
                    }
                }
            }
        }
    }

    /// Blocks turned by a millionth are where their velocities bring them, but for the square of that.
    #[test]
    fn a_small_finite_motion_is_that_of_the_rates() {
        for k in 0..7 {
            let (at, by) = (place(k), 1e-6);
            let (moves, mechanism) = all(&at, &0.0)[k].clone();
            let rate = mechanism.joints[0].rate;
            let twists = mechanism.twists(&at.thickness);
            for (motion, twist) in moves(&at, &by, &0.0).iter().zip(&twists) {
                for point in POINTS {
                    let (moved, velocity) = (motion.to(&point), twist.at(&point));
                    for axis in [0, 1] {
                        let expected = point[axis] + by * velocity[axis] / rate;
                        assert!((moved[axis] - expected).abs() < 1e-10);
                    }
                }
            }
        }
    }

    /// A point of a hinge belongs to both blocks, and the last one is on the axis.
    #[test]
    fn blocks_stay_together_at_their_hinges() {
        for by in [0.01, 0.1] {
            for k in 0..7 {
                let at = place(k);
                let (moves, mechanism) = all(&at, &0.0)[k].clone();
                let moved = moves(&at, &by, &0.0);
                let face = |joint: &super::super::Joint<f64>| {
                    let radius = match joint.contact {
                        Contact::Extrados => 1.0 + at.thickness / 2.0,
                        _ => 1.0 - at.thickness / 2.0,
                    };
                    [radius * joint.at.sin, radius * joint.at.cos]
                };
                for (below, joint) in mechanism.joints.iter().enumerate().skip(1) {
                    let point = face(joint);
                    let [low, high] = [below - 1, below].map(|block| moved[block].to(&point));
                    let apart = [high[0] - low[0], high[1] - low[1]];
                    if joint.contact.is_hinge() {
                        assert!(apart.iter().all(|x| x.abs() < 1e-14), "{k} {apart:?}");
                    } else {
                        // Along the joint, which turns with the block below.
                        let [cos, sin] = moved[below - 1].turn;
                        let across = [
                            cos * joint.at.cos + sin * joint.at.sin,
                            sin * joint.at.cos - cos * joint.at.sin,
                        ];
                        let gap = apart[0] * across[0] + apart[1] * across[1];
                        assert!(gap.abs() < 1e-14, "{k} {gap}");
                    }
                }
                let last = moved.last().unwrap();
                match &mechanism.crown[..] {
                    [] => assert!(last.to(&[0.0, 1.0])[0].abs() < 1e-14),
                    [joint] => assert!(last.to(&face(joint))[0].abs() < 1e-14, "{k}"),
                    _ => assert!(last.to(&[0.0, 1.0])[0] > 0.0, "it opens"),
                }
            }
        }
    }
}
