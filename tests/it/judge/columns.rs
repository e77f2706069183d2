//! Wrong columns are refused before anything is computed.

use crate::program::{Scratch, ended};

const RESULTS: &str = "weight,half_opening,friction,thickness\nheyman,1,0.5,0.0190\n";

#[test]
fn what_is_judged_is_not_written_over() {
    let scratch = Scratch::new();
    scratch.write("results.csv", RESULTS);
    let file = scratch.path("results.csv");
    let (_, message) = ended(2, ["judge", &file, "--output", &file], "");
    assert_eq!(message, format!("couplet: refusing to overwrite the input {file}\n"));
    assert_eq!(scratch.read("results.csv"), RESULTS);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_resource_failure() {
    let (_, message) = ended(3, "judge - --output /dev/full", RESULTS);
    assert!(message.starts_with("couplet: cannot write /dev/full: "), "{message}");
}
