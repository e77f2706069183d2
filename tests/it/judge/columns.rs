//! Wrong columns are refused before anything is computed.

use crate::program::{Scratch, couplet, fed, text};

#[test]
fn a_missing_file_is_a_resource_failure() {
    assert_eq!(fed("judge missing.csv", b"").status.code(), Some(3));
}

const RESULTS: &str = "weight,half_opening,friction,thickness\nheyman,1,0.5,0.0190\n";

#[test]
fn what_is_judged_is_not_written_over() {
    let scratch = Scratch::new();
    scratch.write("results.csv", RESULTS);
    let file = scratch.path("results.csv");
    let output = couplet(["judge", &file, "--output", &file]);
    assert_eq!(output.status.code(), Some(2));
    let message = format!("couplet: refusing to overwrite the input {file}\n");
    assert_eq!(text(&output.stderr), message);
    assert_eq!(scratch.read("results.csv"), RESULTS);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_resource_failure() {
    let output = fed("judge - --output /dev/full", RESULTS);
    assert_eq!(output.status.code(), Some(3));
    let message = text(&output.stderr);
    assert!(message.starts_with("couplet: cannot write /dev/full: "), "{message}");
}
