//! Formats that are not there are named in one line.

use crate::couplet;

#[test]
fn each_command_names_its_own_formats() {
    let answers =
        "one of table, json, csv, toml, latex, c, rust, python, julia, matlab, fortran, parquet";
    let cases = [
        (&["constants", "--format", "cpp"][..], answers),
        (&["constants", "--format", ""], answers),
        (&["states", "--format", "toml"], "one of csv, jsonl, parquet"),
        (&["audit", "--format", "toml"], "one of table, json, csv"),
        (&["state", "--alpha", "1", "--mu", "1", "--format", "jsonl"], answers),
        #[cfg(not(feature = "parquet"))]
        (&["constants", "--format", "parquet"], "--features parquet"),
        #[cfg(not(feature = "parquet"))]
        (&["states", "--format", "parquet"], "--features parquet"),
    ];
    for (arguments, possible) in cases {
        let output = couplet(arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?} {message}");
        assert!(message.contains(possible) && message.lines().count() == 1, "{message}");
        assert!(output.stdout.is_empty());
    }
}
