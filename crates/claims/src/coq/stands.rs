//! The state of an arch that a solution is: the signs that are left, the numbers that are zero, and the theorem of
//! `States.v`.

use super::names::argument;
use super::sign::{sign, tie};
use super::solution::Holes;
use crate::arch::Unknown;
use crate::problem::{Condition, Mode, System};

/// The inequalities of the conditions of a problem, each once.
pub(super) fn signs(conditions: Vec<(Mode, Vec<Condition>)>, system: &System) -> Vec<String> {
    each_once(conditions, |condition, mode| sign(condition, mode, system))
}

/// The equations that are left of conditions that are zero, each once.
pub(super) fn ties(conditions: Vec<(Mode, Vec<Condition>)>, system: &System) -> Vec<String> {
    each_once(conditions, |condition, mode| tie(condition, mode, system))
}

fn each_once(
    conditions: Vec<(Mode, Vec<Condition>)>,
    text: impl Fn(Condition, Mode) -> Option<String>,
) -> Vec<String> {
    let mut all = Vec::new();
    for (mode, conditions) in conditions {
        for one in conditions.into_iter().filter_map(|condition| text(condition, mode)) {
            if !all.contains(&one) {
                all.push(one);
            }
        }
    }
    all
}

/// Claims as a conjunction.
pub(super) fn conjunction(claims: &[String]) -> String {
    claims.join(" /\\\n  ")
}

/// Claims on the whole half arch, and the theorem behind it.
pub(super) fn admissibility(mode: Mode, is_limited: bool, system: &System) -> Holes {
    let delta = system.weight.flag();
    let of = |unknown| argument(system, unknown);
    let (h, eta) = (of(Unknown::Thrust), of(Unknown::Thickness));
    let moment = match mode {
        Mode::Rotational | Mode::SlidingRotational => format!("(at_crown {eta} {h})"),
        Mode::Overturning => "0".into(),
        _ => format!("(at_shoulder {delta} alpha {eta} {h})"),
    };
    let (beta, joint) = (of(Unknown::RotationJoint), of(Unknown::SlidingJoint));
    // The joints that the claim does not name.
    let (theorem, joints) = match mode {
        Mode::Rotational if is_limited => ("rotational", format!(" with (beta := {beta})")),
        Mode::Rotational => ("rotational_without_limit", format!(" with (beta := {beta})")),
        Mode::SlidingRotational => ("sliding_rotational", format!(" with (beta := {beta})")),
        Mode::RotationalSliding | Mode::RotationalSlidingRotational => {
            ("rotational_sliding", format!(" with (beta := {beta}) (joint := {joint})"))
        }
        Mode::OverturningSliding => ("overturning_sliding", format!(" with (joint := {joint})")),
        Mode::Overturning => ("overturning", String::new()),
        Mode::Sliding => ("purely_sliding", String::new()),
    };
    let [admissible, stands_from, holds, mu] = match is_limited {
        true => ["admissible", "stands_from", ", and friction holds,", " mu"],
        false => ["thrust_inside", "stands_without_limit_from", "", ""],
    };
    vec![
        ("admissible", format!("{admissible} {delta} alpha {eta}{mu} {h} {moment}")),
        ("stands_from", format!("{stands_from} {delta} alpha{mu} {eta}")),
        ("holds", holds.into()),
        ("theorem", format!("({theorem} {delta} alpha{mu}){joints}")),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::problem::Landmark;

    /// The table of `docs/certificate.md`, without what the equations fix to a number.
    #[test]
    fn a_landmark_has_the_ties_of_its_modes() {
        let of = |landmark: Landmark| {
            let weight = SelfWeight::Milankovitch;
            ties(landmark.ties(weight), &landmark.system(weight))
        };
        let shoulder = "mu_ss alpha h = mu";
        let extrados = "at_crown eta h = at_shoulder 1 alpha eta h";
        assert_eq!(of(Landmark::Triple), [shoulder, "mu_is h = mu", extrados]);
        assert_eq!(of(Landmark::Shift), [shoulder]);
        assert_eq!(of(Landmark::Junction), [shoulder, "intrados eta * (2 - h) = fac 1 eta"]);
        let limit = |h| format!("fac 1 2 * (1 - cos alpha) = 2 * normal_force alpha {h}");
        assert_eq!(of(Landmark::Border), [shoulder.to_owned(), limit("h")]);
        assert_eq!(of(Landmark::RotationEnd), ["intrados eta * (2 - 0) = fac 1 eta"]);
        assert_eq!(of(Landmark::OverturningEnd), [limit("0")]);
        assert_eq!(of(Landmark::WidestJoint), [""; 0]);
    }

    /// At `B` and `L` the thickness is the limit, at `S` both joints are one, at `l` and `L` there is no thrust.
    #[test]
    fn what_is_fixed_is_put_into_the_claim() {
        let of = |mode, landmark: Landmark| {
            let system = landmark.system(SelfWeight::Heyman);
            let holes = admissibility(mode, landmark.is_limited(), &system);
            ["stands_from", "theorem"].map(|name| {
                holes.iter().find(|(hole, _)| *hole == name).expect("the hole").1.clone()
            })
        };
        let [stands, theorem] = of(Mode::OverturningSliding, Landmark::Border);
        assert_eq!(stands, "stands_from 0 alpha mu 2");
        assert_eq!(theorem, "(overturning_sliding 0 alpha mu) with (joint := beta_s)");
        let [stands, theorem] = of(Mode::Overturning, Landmark::OverturningEnd);
        assert_eq!(stands, "stands_without_limit_from 0 alpha 2");
        assert_eq!(theorem, "(overturning 0 alpha)");
        let [_, theorem] = of(Mode::RotationalSliding, Landmark::Shift);
        let joints = "with (beta := beta_s) (joint := beta_s)";
        assert_eq!(theorem, format!("(rotational_sliding 0 alpha mu) {joints}"));
    }
}
