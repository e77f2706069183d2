//! The certificates in `proofs/constants`, `proofs/states`, `proofs/asymmetric` and `proofs/surveys` are accepted, and
//! are those that the program makes.

use crate::house::certificates;
use couplet::arch::SelfWeight;
use couplet::arch::asymmetric::AsymmetricMode;
use couplet::certify::{certify_arch, certify_asymmetric, certify_landmark, certify_survey};
use couplet::check::{Accepted, Certificate, SurveyCertificate, check, check_survey};
use couplet::number::AstroInterval;
use couplet::problem::{Landmark, Problem};
use std::fs;
use std::path::PathBuf;

fn accepted(text: &str) -> Accepted {
    check::<AstroInterval>(text.as_bytes(), 1000).unwrap()
}

/// The certificates of a folder, each that which the program makes again of what it proves, with what this is.
fn made_again<T>(folder: &str, target: &str, make: impl Fn(&str) -> (T, String)) -> Vec<T> {
    let again = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let (subject, made) = make(&text);
        assert!(text == made + "\n", "{}: run `make {target}`", path.display());
        subject
    };
    certificates([folder]).into_iter().map(again).collect()
}

fn pretty(made: Certificate) -> String {
    serde_json::to_string_pretty(&made).unwrap()
}

#[test]
fn every_landmark_has_an_accepted_certificate() {
    let mut subjects = made_again("constants", "constants", |text| {
        let accepted = accepted(text);
        let Problem::Landmark { landmark, weight } = accepted.problem else { panic!("{text}") };
        assert_eq!(accepted.digits, 100);
        ((landmark, weight), pretty(certify_landmark(landmark, weight, 100).unwrap()))
    });
    subjects.sort_by_key(|(landmark, weight)| (*landmark, weight.flag()));
    let all: Vec<_> =
        Landmark::ALL.into_iter().flat_map(|l| SelfWeight::ALL.map(|w| (l, w))).collect();
    assert_eq!(subjects, all);
}

#[test]
fn the_stored_states_are_those_that_the_program_makes() {
    let states = made_again("states", "states", |text| {
        let accepted = accepted(text);
        let (Problem::State { arch, .. } | Problem::Verdict { arch, .. }) = accepted.problem else {
            panic!("{text}")
        };
        ((), pretty(certify_arch(&arch, None, accepted.digits).unwrap()))
    });
    assert!(!states.is_empty());
}

#[test]
fn the_stored_asymmetric_solutions_are_those_that_the_program_makes() {
    let mut kinds = made_again("asymmetric", "states", |text| {
        let accepted = accepted(text);
        let Problem::Asymmetric { mode, arch } = accepted.problem else { panic!("{text}") };
        let made = certify_asymmetric(&arch, mode, accepted.digits).unwrap();
        ((mode.name(), arch.weight().flag()), pretty(made))
    });
    kinds.sort_unstable();
    let all = AsymmetricMode::ALL.map(|mode| [0, 1].map(|flag| (mode.name(), flag)));
    assert_eq!(kinds, all.concat());
}

#[test]
fn the_stored_surveys_are_those_that_the_program_makes() {
    let mut verdicts = made_again("surveys", "states", |text| {
        let read = SurveyCertificate::read(text.as_bytes()).unwrap();
        let accepted = check_survey::<AstroInterval>(&read, 1000).unwrap();
        let made = certify_survey(&accepted.survey, 10).unwrap();
        (accepted.verdict.name(), serde_json::to_string_pretty(&made).unwrap())
    });
    verdicts.sort_unstable();
    assert_eq!(verdicts, ["all_stand", "all_stand", "both_occur", "none_stands"]);
}
