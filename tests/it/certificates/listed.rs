//! The spoiled certificates of `refused.txt`.

use super::originals::{at_root, file_alike, landmark_problem, to_value};
use super::refusals::{self, Cases, MAX_DIGITS, Original, Spoiled, is_reason};
use super::{asymmetric, survey, verdicts};
use crate::arches::{H, M, arch};
use couplet::arch::asymmetric::AsymmetricMode;
use couplet::problem::{Landmark, Mode, Problem};
use serde_json::Value;

/// What makes a valid one.
type Maker = fn() -> Original;

/// The valid ones, by their names there.
const ORIGINALS: [(&str, Maker); 15] = [
    ("all", survey::all),
    ("all_measured", survey::all_measured),
    ("arch", refusals::arch),
    ("both_measured", survey::both_measured),
    ("inner", asymmetric::inner),
    ("none", survey::none),
    ("none_measured", survey::none_measured),
    ("point", refusals::point),
    ("slides", verdicts::slides),
    ("stands", verdicts::stands),
    ("stands_at_the_crown", verdicts::stands_at_the_crown),
    ("stands_at_the_shoulder", verdicts::stands_at_the_shoulder),
    ("too_thin", verdicts::too_thin),
    ("too_wide", verdicts::too_wide),
    ("too_wide_for_any_friction", verdicts::too_wide_for_any_friction),
];

pub(super) fn original(name: &str) -> Original {
    ORIGINALS.iter().find(|(of, _)| *of == name).unwrap_or_else(|| panic!("{name}")).1()
}

/// What a line says is done to a certificate.
pub(super) fn spoil(name: &str, what: &str) -> Spoiled {
    if name == "root" {
        return another_root(what);
    }
    let original = original(name);
    if let Some((from, to)) = what.split_once(" -> ") {
        return original.replaced(from, to);
    }
    match what.split_once(" = ") {
        Some((place, value)) => original.with(place, serde_json::from_str::<Value>(value).unwrap()),
        None => {
            let (place, key) = what.rsplit_once('/').unwrap();
            original.without(place, key)
        }
    }
}

/// `heyman T at 2.5 …`, or `heyman [r,r,r] 2.3 1.1 at …`.
fn another_root(what: &str) -> Spoiled {
    let (problem, start) = what.split_once(" at ").unwrap();
    let start: Vec<f64> = start.split(' ').map(|x| x.parse().unwrap()).collect();
    let (weight, problem) = problem.split_once(' ').unwrap();
    let weight = if weight == "heyman" { H } else { M };
    let problem = match problem.split(' ').collect::<Vec<_>>()[..] {
        [symbol] => {
            let landmark = Landmark::ALL.into_iter().find(|of| of.symbol() == symbol);
            landmark_problem(landmark.unwrap(), weight)
        }
        [mode, half_opening, friction] => {
            let arch = arch(weight, half_opening, friction);
            let asymmetric = AsymmetricMode::ALL.into_iter().find(|of| of.name() == mode);
            match Mode::ALL.into_iter().find(|of| of.label() == mode) {
                Some(mode) => Problem::State { mode, arch },
                None => Problem::Asymmetric { mode: asymmetric.unwrap(), arch },
            }
        }
        _ => panic!("{what}"),
    };
    Spoiled::new(what, to_value(&at_root(&problem, &start)).to_string())
}

/// The copies of a table, each refused for its reason, and the reason.
pub(super) fn listed(table: &str) -> Cases {
    let sections = include_str!("refused.txt").split("\n# ").skip(1);
    let lines = sections.filter_map(|section| section.strip_prefix(&format!("{table}\n")));
    let case = |line: &str| {
        let (copy, reason) = line.split_once(" => ").unwrap();
        let (name, what) = copy.split_once(": ").unwrap();
        let copy = spoil(name, what);
        let found = file_alike(&copy.bytes, MAX_DIGITS).expect_err(line);
        assert!(is_reason(&found, reason), "{table}: {line}: {found:?}");
        (copy, found)
    };
    lines.flat_map(str::lines).filter(|line| !line.is_empty()).map(case).collect()
}
