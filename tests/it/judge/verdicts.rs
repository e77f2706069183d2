//! Every verdict is given.

use super::{rows, verdicts};
use crate::program::printed;
use couplet::judge::Verdict;
use std::collections::BTreeSet;

const HEAD: &str = "weight,half_opening,friction,stands,mode,thickness,thrust\n";
const THICKER: &str = "thicker than the least thickness";
const THINNER: &str = "thinner than the least thickness";
const STANDS: &str = "claims that an arch falls which stands";
const FALLS: &str = "claims an arch that cannot stand";

/// The verdict on a file with this row alone, and the exit code.
fn has(row: &str, verdict: &str) {
    let (code, rows) = rows("", format!("{HEAD}{row}\n"));
    let [found] = &rows[..] else { panic!("{rows:?}") };
    assert_eq!(found["verdict"], *verdict, "{row}: {found}");
    let good = ["correctly rounded", "correct"].contains(&verdict);
    assert_eq!(found["accepted"], good);
    let expected = if good { 0 } else { 1 + i32::from(verdict == "bad row") };
    assert_eq!(code, Some(expected), "{row}");
}

/// The arch of the first rows stands from 0.122191586362546 on, as [s,r,r], with thrust 0.5969.
const ROWS: [(&str, &str); 29] = [
    ("heyman,pi/2,0.38,,\"[s,r,r]\",0.122192,0.596903", "correctly rounded"),
    ("heyman,pi/2,0.38,yes,srr,0.122191,0.5969", "correct"),
    ("heyman,pi/2,0.38,yes,srr,0.122193,0.5969", THICKER),
    ("heyman,pi/2,0.38,,srr,0.1220000000,", THINNER),
    ("heyman,pi/2,0.38,,srr,0.122191586362600,", "correct"),
    ("heyman,pi/2,0.38,,srr,0.12,", THINNER),
    ("heyman,pi/2,0.38,,,0.123,", "correct"),
    ("heyman,pi/2,0.38,,,0.12219158636254615,0.590", "inaccurate"),
    ("heyman,pi/2,0.38,,srr,0.12219158636254615,none", "inaccurate"),
    ("heyman,pi/2,0.38,,srr,0.124,0.590", THICKER),
    ("heyman,pi/2,0.38,,rrr,0.122192,", "wrong mode"),
    ("heyman,pi/2,0.38,,rrr,0.124,", "wrong mode"),
    ("heyman,pi/2,0.38,,ss,0.122192,", "wrong mode"),
    ("heyman,pi/2,0.38,no,,,", STANDS),
    ("heyman,pi/2,0.38,,,NaN,", STANDS),
    ("heyman,pi/2,0.38,,ss,,", STANDS),
    ("heyman,pi/2,0.38,,rrr,0.120,", THINNER),
    ("heyman,pi/2,0.38,,srr,0,", THINNER),
    ("heyman,pi/2,0.30,true,,,", FALLS),
    ("heyman,pi/2,0.30,,,0.2,", FALLS),
    ("milankovitch,2.65,inf,,[r],1.99,", FALLS),
    ("heyman,pi/2,0.30,,none,nan,nan", "correct"),
    ("milankovitch,2.65,inf,0,,,", "correct"),
    ("heyman,pi/2,0.30,no,,,0.5", "inaccurate"),
    ("heyman,pi/2,0.38,,,,", "no claim"),
    ("heyman,pi/2,0.38,no,,0.1,", "bad row"),
    ("heyman,pi/2,0.38,,rrrr,0.1,", "bad row"),
    ("Couplet,pi/2,0.38,,rrr,0.1,", "bad row"),
    ("heyman,4,0.38,,rrr,0.1,", "bad row"),
];

#[test]
fn every_row_has_its_verdict() {
    ROWS.iter().for_each(|(row, verdict)| has(row, verdict));
}

fn file<'a>(rows: impl Iterator<Item = &'a (&'a str, &'a str)>) -> String {
    rows.fold(HEAD.to_owned(), |file, (row, _)| file + row + "\n")
}

#[test]
fn every_verdict_is_given() {
    let (code, found) = rows("", file(ROWS.iter()));
    assert_eq!(code, Some(2), "some rows are bad");
    assert_eq!(verdicts(&found), Vec::from_iter(ROWS.iter().map(|(_, verdict)| *verdict)));
    let met: BTreeSet<_> = verdicts(&found).into_iter().collect();
    let names = Verdict::ALL.map(Verdict::name);
    let missing: Vec<_> = names.iter().filter(|name| !met.contains(*name)).collect();
    assert_eq!(missing, [&"undecided"], "which has a test of its own");
    let readable = ROWS.iter().filter(|(_, verdict)| *verdict != "bad row");
    assert_eq!(rows("", file(readable)).0, Some(1), "no row is bad");
}

/// What couplet prints with few digits is right as it is printed: the zeros of a whole number are no digits.
#[test]
fn zeros_that_only_show_a_size_are_not_judged() {
    let (code, rows) =
        rows("", printed("assess --alpha 0.001 --mu 0.5 --eta 0.1 --digits 4 --format csv"));
    assert_eq!((code, rows[0]["accepted"].as_bool()), (Some(0), Some(true)), "{rows:?}");
}

/// The friction below which nothing stands is told of an arch that falls, too.
#[test]
fn a_friction_of_pure_sliding_says_nothing_of_standing() {
    let file = "weight,half_opening,friction,sliding_friction\nmilankovitch,80deg,0.1,0.219394\n";
    let (code, rows) = rows("", file);
    assert_eq!((code, rows[0]["accepted"].as_bool()), (Some(0), Some(true)), "{rows:?}");
}
