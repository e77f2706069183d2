//! The certificates in `proofs/constants`, `proofs/states`, `proofs/asymmetric` and `proofs/surveys` are accepted, and
//! are those that the program makes.

use couplet::arch::SelfWeight;
use couplet::arch::asymmetric::AsymmetricMode;
use couplet::check::{Accepted, SurveyCertificate, check, check_survey};
use couplet::number::AstroInterval;
use couplet::problem::Landmark;
use couplet::problem::Problem;
use std::fs;
use std::path::{Path, PathBuf};

fn stored(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs").join(folder);
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|path| path.extension().is_some_and(|e| e == "json")).collect()
}

fn accepted(text: &str) -> Accepted {
    check::<AstroInterval>(text.as_bytes(), 1000).unwrap()
}

#[test]
fn every_landmark_has_an_accepted_certificate() {
    let mut subjects: Vec<(Landmark, SelfWeight)> = Vec::new();
    for path in stored("constants") {
        let text = fs::read_to_string(&path).unwrap();
        let accepted = accepted(&text);
        let Problem::Landmark { landmark, weight } = accepted.problem else { panic!("{path:?}") };
        {
            let made = couplet::certify::certify_landmark(landmark, weight, 100).unwrap();
            let made = serde_json::to_string_pretty(&made).unwrap() + "\n";
            assert!(text == made, "{}: run `make constants`", path.display());
        }
        assert_eq!(accepted.digits, 100);
        subjects.push((landmark, weight));
    }
    subjects.sort_by_key(|(landmark, weight)| (*landmark, weight.flag()));
    let all: Vec<_> =
        Landmark::ALL.into_iter().flat_map(|l| SelfWeight::ALL.map(|w| (l, w))).collect();
    assert_eq!(subjects, all);
}

#[test]
fn the_stored_states_are_those_that_the_program_makes() {
    for path in stored("states") {
        let text = fs::read_to_string(&path).unwrap();
        let accepted = accepted(&text);
        let (Problem::State { arch, .. } | Problem::Verdict { arch, .. }) = accepted.problem else {
            panic!("{path:?}")
        };
        let made = couplet::certify::certify_arch(&arch, None, accepted.digits).unwrap();
        let made = serde_json::to_string_pretty(&made).unwrap() + "\n";
        assert!(text == made, "{}: run `make states`", path.display());
    }
}

#[test]
fn the_stored_asymmetric_solutions_are_those_that_the_program_makes() {
    let mut kinds = Vec::new();
    for path in stored("asymmetric") {
        let text = fs::read_to_string(&path).unwrap();
        let accepted = accepted(&text);
        let Problem::Asymmetric { mode, arch } = accepted.problem else { panic!("{path:?}") };
        let made = couplet::certify::certify_asymmetric(&arch, mode, accepted.digits).unwrap();
        let made = serde_json::to_string_pretty(&made).unwrap() + "\n";
        assert!(text == made, "{}: run `make states`", path.display());
        kinds.push((mode.name(), arch.weight().flag()));
    }
    kinds.sort_unstable();
    let all = AsymmetricMode::ALL.map(|mode| [0, 1].map(|flag| (mode.name(), flag)));
    assert_eq!(kinds, all.concat());
}

#[test]
fn the_stored_surveys_are_those_that_the_program_makes() {
    let mut verdicts = Vec::new();
    for path in stored("surveys") {
        let text = fs::read_to_string(&path).unwrap();
        let read = SurveyCertificate::read(text.as_bytes()).unwrap();
        let accepted = check_survey::<AstroInterval>(&read, 1000).unwrap();
        let made = couplet::certify::certify_survey(&accepted.survey, 10).unwrap();
        let made = serde_json::to_string_pretty(&made).unwrap() + "\n";
        assert!(text == made, "{}: run `make states`", path.display());
        verdicts.push(accepted.verdict.name());
    }
    verdicts.sort_unstable();
    assert_eq!(verdicts, ["all_stand", "all_stand", "both_occur", "none_stands"]);
}
