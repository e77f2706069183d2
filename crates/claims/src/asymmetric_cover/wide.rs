//! All thrusts, vertical forces and thicknesses outside the rectangle: no asymmetric state.
//!
//! A box is empty for one of four reasons, each of which is a sign in balls:
//!
//! - **it is too thin**: the extrados of a joint on the right leaves less to the moment than the intrados of one on the
//!   left asks for;
//! - **no hinge**: along the right half the distance from the extrados has no least value inside;
//! - **it is too thick**: the hinges, wherever they are in their ranges, do not both touch;
//! - **the shoulder opens**: at some half opening that the right angle, the sliding joint or the fit of the hinges says
//!   to be too small, the line of thrust is outside already, and further on it is so too.

use super::{ForceBox, ForceRectangle, Span};
use crate::arch::asymmetric::Asymmetric;
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::whole::{Forces, Side, margin, margin_along};
use crate::arch::{Ring, SelfWeight, cycloid};
use crate::certify::Undecided;
use crate::number::{Angle, DoubleBall, Enclosure, Field, Real};
use crate::prover::halve::halve;

/// A box is halved so often at the most.
const DEPTH: u32 = 40;

/// A box of thrusts, vertical forces and thicknesses.
#[derive(Clone, Copy, Debug)]
struct ForceCell {
    /// The inclinations `chi` of thrusts `cos² chi`, or thrusts themselves.
    thrust: Span,
    /// True of thrusts themselves, from one on: no inner joint can slide.
    is_large: bool,
    vertical: Span,
    thickness: Span,
}

/// Joints at which margins are looked at.
struct MarginJoints {
    /// From the crown to the right angle.
    above: Vec<Angle<DoubleBall>>,
    /// From the right angle on.
    below: Vec<Angle<DoubleBall>>,
}

impl MarginJoints {
    fn new() -> Self {
        let zero = DoubleBall::exact(0.0);
        let right = zero.pi() / zero.int(2);
        let at = |k: i32, parts: i32| Angle::new(right * right.ratio(k, parts));
        Self {
            above: (0..=20).map(|k| at(k, 20)).collect(),
            below: (60..120).map(|k| at(k, 60)).collect(),
        }
    }
}

/// Ring and forces of a cell.
struct Bodies {
    ring: Ring<DoubleBall>,
    grip: Grip<DoubleBall>,
    forces: Forces<DoubleBall>,
}

impl Bodies {
    fn new(cell: ForceCell, weight: SelfWeight) -> Self {
        let zero = DoubleBall::exact(0.0);
        let thrust = cell.thrust.ball();
        let thrust = if cell.is_large { thrust } else { cycloid::thrust(&Angle::new(thrust)) };
        Self {
            ring: Ring::new(weight, &cell.thickness.ball()),
            grip: Grip { shear: zero, normal: zero.int(1) },
            forces: Forces { thrust, moment: zero, vertical: cell.vertical.ball() },
        }
    }

    /// The most that the moment may be by the extrados of a joint of the right half.
    fn above(&self, joint: &Angle<DoubleBall>) -> DoubleBall {
        margin(Contact::Extrados, joint, &self.ring, &self.grip, &self.forces)
    }

    /// The least that it may be by the intrados of a joint of the left half.
    fn below(&self, joint: &Angle<DoubleBall>) -> DoubleBall {
        let joint = Side::Left.joint(joint);
        -margin(Contact::Intrados, &joint, &self.ring, &self.grip, &self.forces)
    }

    /// The slope of a bound by the angle from the crown.
    fn slope(&self, contact: Contact, joint: &Angle<DoubleBall>) -> DoubleBall {
        // On the left both the bound and the angle change their signs.
        let side = if contact == Contact::Extrados { Side::Right } else { Side::Left };
        let joint = side.joint(joint);
        margin_along(contact, &joint, &self.ring, &self.grip, &self.forces).coefficient(1)
    }

    /// `c = h - 1 + fac/(1 + eta/2)`: the distance from the extrados rises along the right half as `x - v - c tan(x)`
    /// is positive.
    fn curvature(&self) -> DoubleBall {
        let Ring { centroid_factor, .. } = self.ring;
        let two = centroid_factor.int(2);
        self.forces.thrust - two.int(1) + two * centroid_factor / self.ring.extrados()
    }
}

fn is_positive(x: DoubleBall) -> bool {
    x.is_positive().is_proved()
}

/// A ball that holds all numbers from one to another.
fn between([low, high]: [&DoubleBall; 2]) -> DoubleBall {
    let two = low.int(2);
    ((*low + high) / two).widened(((*high - low) / two).size())
}

/// A bound on a range about its middle, and by its slope on all of the range.
fn both_ways(
    value: impl Fn(&Angle<DoubleBall>) -> DoubleBall,
    slope: DoubleBall,
    range: &Angle<DoubleBall>,
) -> [DoubleBall; 2] {
    let middle = range.rad.midpoint();
    [value(range), value(&Angle::new(middle)) + slope * (range.rad - middle)]
}

impl ForceCell {
    fn place(self) -> Option<ForceBox> {
        let Self { thrust: inclination, vertical, .. } = self;
        (!self.is_large).then_some(ForceBox { inclination, vertical })
    }

    fn is_inside(self, rectangle: ForceRectangle) -> bool {
        let [inclinations, verticals] =
            [rectangle.inclinations, [0, rectangle.vertical]].map(Span::of_parts);
        self.place().is_some_and(|place| {
            inclinations.low <= place.inclination.low
                && place.inclination.high <= inclinations.high
                && place.vertical.high <= verticals.high
        })
    }

    /// Tells whether no asymmetric state has forces and a thickness in the box.
    fn is_empty(self, weight: SelfWeight, joints: &MarginJoints) -> bool {
        let bodies = Bodies::new(self, weight);
        let highest = joints.above.iter().map(|joint| bodies.below(joint));
        let Some(highest) = highest.max_by(|a, b| a.lower().total_cmp(&b.lower())) else {
            return false;
        };
        let is_outside = |joint: &Angle<DoubleBall>| is_positive(highest - bodies.above(joint));
        if joints.above.iter().any(is_outside) {
            return true;
        }
        let Some([crown, haunch]) = self.hinges(&bodies, joints) else { return true };
        let at = |joint: &Angle<DoubleBall>| Asymmetric {
            half_opening: joint.clone(),
            grip: bodies.grip.clone(),
            thickness: bodies.ring.thickness,
            forces: bodies.forces.clone(),
            crown_hinge: crown.clone(),
            haunch: haunch.clone(),
            sliding_joint: Angle::zero(&highest),
        };
        let is_too_small = |joint: &Angle<DoubleBall>| {
            is_positive(-at(joint).misfit(&bodies.ring))
                || self.place().is_some_and(|place| is_positive(-place.room_inside(&joint.rad)))
        };
        let [right, wider @ ..] = &joints.below[..] else { return false };
        // Wider ones are outside too, and less surely too small.
        let first = wider.partition_point(|joint| !is_outside(joint));
        is_outside(right)
            || wider.get(first).is_some_and(|joint| is_outside(joint) && is_too_small(joint))
    }

    /// Ranges of the two hinges; `None` if they do not both touch.
    fn hinges(self, bodies: &Bodies, joints: &MarginJoints) -> Option<[Angle<DoubleBall>; 2]> {
        let curvature = bodies.curvature();
        let one = curvature.int(1);
        let is_beyond = |joint: &Angle<DoubleBall>| is_positive(curvature - joint.cos.square());
        let never_rises = |joint: &Angle<DoubleBall>| {
            let room = bodies.forces.vertical - cycloid::friction_angle(joint);
            is_beyond(joint) && is_positive(room)
        };
        if is_positive(curvature - one) || joints.above.iter().any(never_rises) {
            return None;
        }
        let crown = |joint: &Angle<DoubleBall>| bodies.slope(Contact::Extrados, joint);
        let range = |starts: &dyn Fn(&Angle<DoubleBall>) -> bool,
                     ends: &dyn Fn(&Angle<DoubleBall>) -> bool| {
            let inner = &joints.above[1..];
            let low = &joints.above[inner.partition_point(starts)];
            let high = inner.get(inner.partition_point(|joint| !ends(joint)));
            let high = high.or(joints.above.last())?;
            Some(Angle::new(between([&low.rad, &high.rad])))
        };
        let right = range(
            &|joint| is_positive(-crown(joint)) && is_positive(joint.cos.square() - curvature),
            &|joint| is_positive(crown(joint)) || is_beyond(joint),
        )?;
        let haunch = |joint: &Angle<DoubleBall>| bodies.slope(Contact::Intrados, joint);
        let left =
            range(&|joint| is_positive(haunch(joint)), &|joint| is_positive(-haunch(joint)))?;
        let most = both_ways(|joint| bodies.above(joint), crown(&right), &right);
        let least = both_ways(|joint| bodies.below(joint), haunch(&left), &left);
        let is_thick = most.iter().any(|u| least.iter().any(|l| is_positive(*u - l)));
        (!is_thick).then_some([right, left])
    }

    /// Halves of the box across its longest side; the thickness counts half.
    fn halves(&self) -> Option<[Self; 2]> {
        let widths = [self.thrust.width(), self.vertical.width(), self.thickness.width() / 2.0];
        let longest = widths.into_iter().fold(0.0, f64::max);
        Some(if widths[0] == longest {
            self.thrust.halves().map(|thrust| Self { thrust, ..*self })
        } else if widths[1] == longest {
            self.vertical.halves().map(|vertical| Self { vertical, ..*self })
        } else {
            self.thickness.halves().map(|thickness| Self { thickness, ..*self })
        })
    }
}

/// Proves that outside a rectangle of forces no asymmetric state is, of any half opening and any friction.
/// Returns the number of boxes, those of the rectangle among them.
pub(in super::super) fn elsewhere(
    weight: SelfWeight,
    rectangle: ForceRectangle,
) -> Result<usize, Undecided> {
    let joints = MarginJoints::new();
    // All up to the right angle, up to 3/2, and up to 2.
    let [angles, thrusts] = [[0, 104], [64, 96]].map(Span::of_parts);
    let whole = |(thrust, is_large)| ForceCell {
        thrust,
        is_large,
        vertical: Span::of_parts([0, 104]),
        thickness: Span::of_parts([0, 128]),
    };
    let proof = |cell: &ForceCell| {
        let is_settled = cell.is_inside(rectangle) || cell.is_empty(weight, &joints);
        is_settled.then_some(()).ok_or(*cell)
    };
    [(angles, false), (thrusts, true)]
        .into_iter()
        .map(|thrust| halve(whole(thrust), DEPTH, ForceCell::halves, proof))
        .sum::<Result<usize, ForceCell>>()
        .map_err(|cell| Undecided::new(format!("not decided at {cell:?}")))
}
