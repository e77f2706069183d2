//! Every line of `tests/refused.txt`: what makes no sense is refused in one line, with what is possible.

use crate::program::{fed, said};
use rayon::prelude::*;

/// What is wrong with the answer to a line, if it is not refused as it says.
fn fault(row: &str) -> Option<String> {
    let (asked, words) = row.split_once(" => ").unwrap();
    let (line, input) = asked.split_once(" < ").unwrap_or((asked, ""));
    let arguments: Vec<&str> = line.split(' ').map(|word| word.trim_matches('\'')).collect();
    let (code, output, message) = said(&fed(arguments, input.replace("\\n", "\n")));
    let is_one_line = message.starts_with("couplet: ") && message.lines().count() == 1;
    let is_told = words.split(" => ").all(|words| message.contains(words));
    let is_refused = code == Some(2) && output.is_empty() && is_one_line && is_told;
    (!is_refused).then(|| format!("{row}: {code:?} {output}{message}"))
}

#[test]
fn what_makes_no_sense_is_refused_in_one_line() {
    let rows = include_str!("../refused.txt").lines();
    let rows: Vec<&str> = rows.filter(|row| !row.is_empty() && !row.starts_with('#')).collect();
    let is_here = |row: &&str| cfg!(feature = "parquet") || !row.starts_with("sweep");
    let faults: Vec<String> = rows.par_iter().copied().filter(is_here).filter_map(fault).collect();
    assert!(faults.is_empty(), "{faults:#?}");
    assert!(rows.len() > 400);
}

/// An answer, another word and a file that is not there are seen.
#[test]
fn what_is_not_refused_so_is_seen() {
    for row in ["constants T => T", "constants X => banana", "check missing.json => missing"] {
        assert!(fault(row).is_some(), "{row}");
    }
}

#[cfg(not(feature = "parquet"))]
#[test]
fn parquet_needs_its_feature() {
    for command in ["constants", "states"] {
        let row = format!("{command} --format parquet => --features parquet");
        assert_eq!(fault(&row), None);
    }
}
