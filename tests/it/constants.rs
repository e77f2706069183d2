//! The certificates in `proofs/constants` are accepted, and are those that the program makes.

use couplet::arch::SelfWeight;
use couplet::check::check;
use couplet::number::AstroInterval;
use couplet::problem::Landmark;
use couplet::problem::Problem;
use std::fs;
use std::path::{Path, PathBuf};

fn stored() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/constants");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|path| path.extension().is_some_and(|e| e == "json")).collect()
}

#[test]
fn every_landmark_has_an_accepted_certificate() {
    let mut subjects: Vec<(Landmark, SelfWeight)> = Vec::new();
    for path in stored() {
        let text = fs::read_to_string(&path).unwrap();
        let accepted = check::<AstroInterval>(text.as_bytes(), 1000).unwrap();
        let Problem::Landmark { landmark, weight } = accepted.problem else { panic!("{path:?}") };
        #[cfg(feature = "mpfr")]
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
