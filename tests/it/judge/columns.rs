//! Wrong columns are refused before anything is computed.

use crate::program::{Scratch, couplet, fed, refused, text};

const CSV: &str = "a,b,c,c,d\n1,0.5,0.1,0.1,heyman\n";
const JSON: &str = "{\"a\":1,\"b\":0.5,\"c\":0.1}\n";
const HEYMAN: &[&str] = &["--weight", "heyman"];

/// One test for each file, with options and what its columns mean.
macro_rules! refusals {
    ($($name:ident: $input:expr, $arguments:expr $(, $columns:literal)? => $words:literal;)*) => {$(
        #[test]
        fn $name() {
            let columns: &[&str] = &[$("--columns", $columns)?];
            let arguments = [&["judge", "-", "--format", "csv"][..], $arguments, columns].concat();
            refused(&arguments, $input, $words);
        }
    )*};
}

refusals! {
    an_unknown_column_of_the_file:
        CSV, HEYMAN, "a=half_opening,b=friction,x=thickness"
        => "the file has no column 'x'; its columns are 'a', 'b', 'c', 'c', 'd'";
    a_column_that_is_there_twice:
        CSV, HEYMAN, "a=half_opening,b=friction,c=thickness" => "two columns 'c'";
    a_meaning_that_is_none:
        CSV, HEYMAN, "a=half_opening,b=friction,d=thick" => "'thick' is not one of our columns: weight";
    a_meaning_of_two_columns:
        CSV, HEYMAN, "a=half_opening,b=friction,d=friction" => "both named friction";
    a_column_with_two_meanings:
        CSV, HEYMAN, "a=half_opening,b=friction,a=thickness" => "named twice";
    nothing_to_judge: CSV, HEYMAN, "a=half_opening,b=friction" => "anything to judge";
    no_friction: CSV, HEYMAN, "a=half_opening,d=mode" => "no column for the friction";
    no_half_opening: CSV, HEYMAN, "b=friction,d=mode" => "no column for the half opening";
    a_unit_that_is_none:
        CSV, HEYMAN, "a=half_opening:turns,b=friction,d=mode" => "rad, deg, gon";
    a_unit_of_the_mode: CSV, HEYMAN, "a=half_opening,b=friction,d=mode:deg" => "mode has no unit";
    two_frictions:
        CSV, HEYMAN, "a=half_opening,b=friction,d=friction_angle,c=mode" => "choose one";
    a_weight_too_many_and_a_column_twice:
        CSV, HEYMAN, "a=half_opening,b=friction,c=mode,d=weight" => "two columns 'c'";
    other_names_than_ours: CSV, HEYMAN => "no column for the half opening";
    other_names_between_semicolons:
        "opening;friction;eta\n", HEYMAN
        => "--columns theirs=half_opening; its columns are 'opening', 'friction', 'eta'";
    two_thicknesses_that_are_given:
        "alpha,mu,a,b\n", HEYMAN, "alpha,mu,a=given_thickness,b=given_thickness" => "both named given_thickness";
    two_names_of_one_column:
        "alpha,half_opening,mu,eta\n", HEYMAN => "'half_opening' and 'alpha', which are the same";
    an_unknown_column_of_json:
        JSON, HEYMAN, "a=half_opening,b=friction,x=thickness" => "the first rows have no column 'x'";
    json_with_other_names_than_ours: JSON, HEYMAN => "no column for the half opening";
    an_empty_file: "", HEYMAN => "the file is empty";
    an_array_without_columns: "[{}]", HEYMAN => "no column for the half opening";
    both_weights: CSV, &["--weight", "both"] => "one of heyman, milankovitch";
    no_digits_accepted: CSV, &["--accept", "0"] => "from 1 to 1000000";
    fewer_than_no_worst_rows: CSV, &["--worst", "-1"] => "--worst";
    single_precision: CSV, &["--inputs", "single"] => "exact, double";
}

#[test]
fn a_missing_file_is_a_resource_failure() {
    assert_eq!(fed(&["judge", "missing.csv"], b"").status.code(), Some(3));
}

const RESULTS: &str = "weight,half_opening,friction,thickness\nheyman,1,0.5,0.0190\n";

#[test]
fn what_is_judged_is_not_written_over() {
    let scratch = Scratch::new();
    scratch.write("results.csv", RESULTS);
    let file = scratch.path("results.csv");
    let output = couplet(&["judge", &file, "--output", &file]);
    assert_eq!(output.status.code(), Some(2));
    let message = format!("couplet: refusing to overwrite the input {file}\n");
    assert_eq!(text(&output.stderr), message);
    assert_eq!(scratch.read("results.csv"), RESULTS);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_resource_failure() {
    let output = fed(&["judge", "-", "--output", "/dev/full"], RESULTS);
    assert_eq!(output.status.code(), Some(3));
    let message = text(&output.stderr);
    assert!(message.starts_with("couplet: cannot write /dev/full: "), "{message}");
}
