//! True roots, with witnesses that prove them, of which something else is not true.

use super::originals::{at_root, landmark_problem as point, state_problem as arch, to_value};
use super::refusals::{Cases, Spoiled};
use couplet::arch::SelfWeight::*;
use couplet::check::Refusal;
use couplet::problem::{Landmark as L, Mode as M, Problem};

/// The root of the claimed equations next to this point does not meet this condition.
pub(super) fn unmet(problem: Problem, start: &[f64], words: &'static str) -> Cases {
    let certificate = to_value(&at_root(&problem, start)).to_string();
    vec![(Spoiled::new(words, certificate), Refusal::Condition(words))]
}

refusals! {
    a_negative_half_opening:
        unmet(point(L::OverturningEnd, Heyman), &[-2.7865], "a positive half opening");
    a_half_opening_of_more_than_a_turn:
        unmet(point(L::OverturningEnd, Heyman), &[9.2], "a half opening below pi");
    a_shift_beyond_a_turn:
        unmet(
            point(L::Shift, Heyman),
            &[9.2804, 0.0718, 0.9965, 0.0052, 6.9075],
            "a half opening below pi",
        );
    a_negative_widest_joint:
        unmet(point(L::WidestJoint, Heyman), &[2.2303, -1.1291, 0.4214, 0.267], "a rotational joint below the crown");
    a_triple_point_with_a_negative_joint:
        unmet(
            point(L::Triple, Heyman),
            &[2.4872, -1.0375, 0.2971, 0.6796, 0.0978, 1.4153],
            "a rotational joint below the crown",
        );
    a_triple_point_with_a_joint_beyond_a_turn:
        unmet(
            point(L::Triple, Heyman),
            &[2.7447, 6.6674, 0.1893, 1.8854, 0.0372, 2.4796],
            "a rotational joint above the shoulder",
        );
    a_rotational_joint_above_the_crown:
        unmet(
            arch(Heyman, M::Rotational, "2.3", "1.1"),
            &[-1.1248, 0.4793, 0.2226],
            "a rotational joint below the crown",
        );
    a_rotational_joint_below_the_shoulder:
        unmet(
            arch(Heyman, M::Rotational, "2.3", "1.1"),
            &[7.3168, 1.5906, 0.4723],
            "a rotational joint above the shoulder",
        );
    a_thickness_beyond_the_limit:
        unmet(
            arch(Heyman, M::Rotational, "2.3", "1.1"),
            &[5.1537, 2.9703, 0.6269],
            "a thickness below the physical limit",
        );
    rotation_where_the_shoulder_slides:
        unmet(
            arch(Milankovitch, M::Rotational, "pi/2", "1/4"),
            &[0.9509, 0.1075, 0.6209],
            "friction enough at the shoulder",
        );
    rotation_where_a_joint_slides:
        unmet(
            arch(Milankovitch, M::Rotational, "2.45", "1.35"),
            &[1.03, 0.648, 0.105],
            "friction enough inside",
        );
    a_line_of_thrust_outside_at_the_shoulder:
        unmet(
            arch(Heyman, M::SlidingRotational, "2.3", "1.1"),
            &[1.1275, 0.4565, 0.2395],
            "the line of thrust inside the extrados at the shoulder",
        );
    a_line_of_thrust_outside_at_the_crown:
        unmet(
            arch(Heyman, M::RotationalSliding, "2.3", "1.1"),
            &[1.2592, 0.416, 0.143, 0.35],
            "the line of thrust inside the extrados at the crown",
        );
    overturning_and_sliding_with_the_thrust_inside_at_the_crown:
        unmet(
            arch(Heyman, M::OverturningSliding, "2.3", "1.1"),
            &[0.2149, 0.143, 0.35],
            "the line of thrust leaves the intrados at the crown",
        );
    a_rotational_joint_beyond_the_sliding_one:
        unmet(
            arch(Milankovitch, M::RotationalSlidingRotational, "2.45", "1.35"),
            &[1.0036, 0.6502, 0.1053, 0.307],
            "a rotational joint nearer to the crown",
        );
    a_sliding_joint_beyond_the_rotational_one:
        unmet(
            arch(Milankovitch, M::RotationalSliding, "2.533", "1.545"),
            &[0.2, 0.88, 0.085, 0.279],
            "a sliding joint nearer to the crown",
        );
    a_rotational_joint_above_the_crown_without_limit_of_friction:
        unmet(
            arch(Heyman, M::Rotational, "2.3", "inf"),
            &[-1.1248, 0.4793, 0.2226],
            "a rotational joint below the crown",
        );
    overturning_with_the_thrust_inside_at_the_crown:
        unmet(
            arch(Heyman, M::Overturning, "2.6", "inf"),
            &[0.9],
            "the line of thrust leaves the intrados at the crown",
        );
}
