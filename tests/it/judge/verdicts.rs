//! Every verdict is given.

use super::{rows, verdicts};
use couplet::judge::Verdict;
use std::collections::BTreeSet;

const HEAD: &str = "weight,half_opening,friction,stands,mode,thickness,thrust\n";
const THICKER: &str = "thicker than the least thickness";
const THINNER: &str = "thinner than the least thickness";
const STANDS: &str = "claims that an arch falls which stands";
const FALLS: &str = "claims an arch that cannot stand";

/// The verdict on a file with this row alone, and the exit code.
fn has(row: &str, verdict: &str) {
    let (code, rows) = rows(&[], format!("{HEAD}{row}\n"));
    let [found] = &rows[..] else { panic!("{rows:?}") };
    assert_eq!(found["verdict"], *verdict, "{row}: {found}");
    let good = ["correctly rounded", "correct"].contains(&verdict);
    assert_eq!(found["accepted"], good);
    let expected = if good { 0 } else { 1 + i32::from(verdict == "bad row") };
    assert_eq!(code, Some(expected), "{row}");
}

/// One test for each row, and the list of all.
macro_rules! verdicts {
    ($($name:ident: $row:literal => $verdict:expr;)*) => {
        $(
            #[test]
            fn $name() {
                has($row, $verdict);
            }
        )*

        const ROWS: &[(&str, &str)] = &[$(($row, $verdict)),*];
    };
}

// The arch of the first rows stands from 0.122191586362546 on, as [s,r,r], with thrust 0.5969.
verdicts! {
    both_numbers_rounded: "heyman,pi/2,0.38,,\"[s,r,r]\",0.122192,0.596903" => "correctly rounded";
    a_last_digit_cut_off: "heyman,pi/2,0.38,yes,srr,0.122191,0.5969" => "correct";
    a_last_digit_off: "heyman,pi/2,0.38,yes,srr,0.122193,0.5969" => THICKER;
    zeros_that_are_not_there: "heyman,pi/2,0.38,,srr,0.1220000000," => THINNER;
    twelve_digits_of_fifteen: "heyman,pi/2,0.38,,srr,0.122191586362600," => "correct";
    coarse_and_too_thin: "heyman,pi/2,0.38,,srr,0.12," => THINNER;
    coarse_and_too_thick: "heyman,pi/2,0.38,,,0.123," => "correct";
    a_thrust_off: "heyman,pi/2,0.38,,,0.12219158636254615,0.590" => "inaccurate";
    no_thrust: "heyman,pi/2,0.38,,srr,0.12219158636254615,none" => "inaccurate";
    too_thick_with_a_thrust_off: "heyman,pi/2,0.38,,srr,0.124,0.590" => THICKER;
    another_mode: "heyman,pi/2,0.38,,rrr,0.122192," => "wrong mode";
    another_mode_and_too_thick: "heyman,pi/2,0.38,,rrr,0.124," => "wrong mode";
    the_mode_in_which_nothing_stands: "heyman,pi/2,0.38,,ss,0.122192," => "wrong mode";
    said_to_fall: "heyman,pi/2,0.38,no,,," => STANDS;
    said_to_fall_by_nan: "heyman,pi/2,0.38,,,NaN," => STANDS;
    said_to_fall_by_its_mode: "heyman,pi/2,0.38,,ss,," => STANDS;
    too_thin_in_another_mode: "heyman,pi/2,0.38,,rrr,0.120," => THINNER;
    no_thickness_at_all: "heyman,pi/2,0.38,,srr,0," => THINNER;
    said_to_stand: "heyman,pi/2,0.30,true,,," => FALLS;
    said_to_stand_by_its_thickness: "heyman,pi/2,0.30,,,0.2," => FALLS;
    said_to_stand_near_the_limit: "milankovitch,2.65,inf,,[r],1.99," => FALLS;
    a_fall_in_words: "heyman,pi/2,0.30,,none,nan,nan" => "correct";
    a_fall_as_zero: "milankovitch,2.65,inf,0,,," => "correct";
    a_thrust_where_nothing_stands: "heyman,pi/2,0.30,no,,,0.5" => "inaccurate";
    nothing_said: "heyman,pi/2,0.38,,,," => "no claim";
    a_contradiction: "heyman,pi/2,0.38,no,,0.1," => "bad row";
    a_mode_that_is_none: "heyman,pi/2,0.38,,rrrr,0.1," => "bad row";
    a_weight_that_is_none: "Couplet,pi/2,0.38,,rrr,0.1," => "bad row";
    a_half_opening_beyond_a_turn: "heyman,4,0.38,,rrr,0.1," => "bad row";
}

fn file<'a>(rows: impl Iterator<Item = &'a (&'a str, &'a str)>) -> String {
    rows.fold(HEAD.to_owned(), |file, (row, _)| file + row + "\n")
}

#[test]
fn every_verdict_is_given() {
    let (code, found) = rows(&[], file(ROWS.iter()));
    assert_eq!(code, Some(2), "some rows are bad");
    assert_eq!(verdicts(&found), Vec::from_iter(ROWS.iter().map(|(_, verdict)| *verdict)));
    let met: BTreeSet<_> = verdicts(&found).into_iter().collect();
    let names = Verdict::ALL.map(Verdict::name);
    let missing: Vec<_> = names.iter().filter(|name| !met.contains(*name)).collect();
    assert_eq!(missing, [&"undecided"], "which has a test of its own");
    let readable = ROWS.iter().filter(|(_, verdict)| *verdict != "bad row");
    assert_eq!(rows(&[], file(readable)).0, Some(1), "no row is bad");
}

/// What couplet prints with few digits is right as it is printed: the zeros of a whole number are no digits.
#[test]
fn zeros_that_only_show_a_size_are_not_judged() {
    let arch = ["assess", "--alpha", "0.001", "--mu", "0.5", "--eta", "0.1", "--digits", "4"];
    let output = crate::program::couplet(&[&arch[..], &["--format", "csv"]].concat());
    let (code, rows) = rows(&[], crate::program::text(&output.stdout));
    assert_eq!((code, rows[0]["accepted"].as_bool()), (Some(0), Some(true)), "{rows:?}");
}

/// The friction below which nothing stands is told of an arch that falls, too.
#[test]
fn a_friction_of_pure_sliding_says_nothing_of_standing() {
    let file = "weight,half_opening,friction,sliding_friction\nmilankovitch,80deg,0.1,0.219394\n";
    let (code, rows) = rows(&[], file);
    assert_eq!((code, rows[0]["accepted"].as_bool()), (Some(0), Some(true)), "{rows:?}");
}
