//! Every class of fault has its place, and says what is allowed: `faults.txt` has scenes without their first line, each
//! with all its faults behind `=>`.

use super::{faults, scene_in};
use crate::program::{Scratch, couplet, said};
use std::time::{Duration, Instant};

fn cases() -> Vec<(String, Vec<&'static str>)> {
    let blocks = include_str!("faults.txt").split("\n\n").filter(|block| !block.starts_with('#'));
    let case = |block: &'static str| {
        let scene = block.lines().filter(|line| !line.starts_with("=> "));
        let faults = block.lines().filter_map(|line| line.strip_prefix("=> "));
        (scene.map(|line| format!("{line}\n")).collect(), faults.collect())
    };
    blocks.map(case).collect()
}

#[test]
fn every_fault_has_its_place_and_says_what_is_allowed() {
    let cases = cases();
    assert!(cases.len() >= 120, "{}", cases.len());
    for (scene, expected) in cases {
        assert!(!expected.is_empty(), "{scene}");
        assert_eq!(faults(&scene), expected, "{scene}");
    }
}

#[test]
fn all_faults_are_said_at_once_and_nothing_is_computed() {
    let scratch = Scratch::new();
    // Valid items that would take hours, with one wrong thing each behind them.
    let mut scene = "[[constants]]\ndigits = 1_000_000\noutput = \"out/all.csv\"\n".to_owned();
    let cases = cases();
    let tables = cases.iter().map(|(scene, _)| scene);
    let wrong: Vec<&String> = tables
        .filter(|scene| scene.starts_with("[arches]") || scene.starts_with("[claims]"))
        .collect();
    for text in &wrong {
        scene += &text.replacen("[arches]", "[[arches]]", 1).replacen("[claims]", "[[claims]]", 1);
    }
    let path = scene_in(&scratch, &scene);
    let start = Instant::now();
    let (code, printed, said) = said(&couplet(["run", &path, "--output", &scratch.path("out")]));
    assert!(start.elapsed() < Duration::from_secs(20));
    assert_eq!((code, printed.as_str()), (Some(2), ""));
    assert_eq!(scratch.files("."), ["scene.toml"]);
    let (faults, sum) = said.trim_end().rsplit_once('\n').unwrap();
    let place = |line: &str| {
        let place = line.strip_prefix(&format!("{path}:")).unwrap();
        place.split(':').next().unwrap().parse::<usize>().unwrap()
    };
    let places: Vec<usize> = faults.lines().map(place).collect();
    assert!(places.is_sorted() && places.len() == wrong.len(), "{said}");
    let count = wrong.len();
    assert_eq!(sum, format!("couplet: {path} has {count} errors; nothing was computed"));
}
