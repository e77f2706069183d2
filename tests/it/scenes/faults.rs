//! Every class of fault has its place, and says what is allowed.

use super::{faults, scene_in};
use crate::program::{Scratch, couplet, text};
use std::time::{Duration, Instant};

/// One test for each fault, and the list of all: what comes after the first line of the scene, and what is
/// said of it.
macro_rules! faults {
    ($($name:ident: $scene:literal => $fault:literal;)*) => {
        $(
            #[test]
            fn $name() {
                assert_eq!(faults($scene), [$fault]);
            }
        )*

        const SCENES: &[&str] = &[$($scene),*];
    };
}

faults! {
    nothing_asked:
        ""
        => "1:1: the scene asks for nothing; it may have [[constants]], [[arches]], [[claims]], [[audit]], [[map]], [[figure]], [[drawing]]";
    a_key_twice:
        "digits = 3\ndigits = 4\n"
        => "3:1: not TOML: duplicate key";
    a_bracket_too_few:
        "[[arches]\n"
        => "2:10: not TOML: unclosed array table, expected `]`";
    an_unknown_key:
        "colour = 1\n"
        => "2:1: unknown key \"colour\" in a scene; the keys are schema, digits, weight, constants, arches, claims, audit, map, figure, drawing";
    digits_as_text:
        "digits = \"30\"\n"
        => "2:10: digits \"30\" is not a whole number from 1 to 1000000";
    no_digits:
        "digits = 0\n"
        => "2:10: digits 0 is not a whole number from 1 to 1000000";
    no_weight:
        "weight = []\n"
        => "2:10: weight is an empty list; give one of heyman, milankovitch";
    constants_as_a_number:
        "constants = 3\n"
        => "2:13: constants 3 is not a table [[constants]]";
    an_unknown_landmark:
        "[constants]\nlandmarks = \"X\"\n"
        => "3:13: landmarks \"X\" is not one of T, S, J, B, l, L, sb, triple, shift, junction, border, rotation-end, overturning-end, widest-joint";
    a_landmark_that_is_a_number:
        "[constants]\nlandmarks = [\"T\", 3]\n"
        => "3:19: landmarks 3 is not one of T, S, J, B, l, L, sb, triple, shift, junction, border, rotation-end, overturning-end, widest-joint";
    a_key_without_its_last_letter:
        "[constants]\nlandmark = \"T\"\n"
        => "3:1: unknown key \"landmark\" in [[constants]] (did you mean \"landmarks\"?); the keys are landmarks, quantities, weight, digits, format, output";
    a_quantity_that_none_of_the_landmarks_has:
        "[constants]\nlandmarks = \"sb\"\nquantities = \"friction\"\n"
        => "4:14: none of the landmarks has the quantity friction";
    a_quantity_without_its_last_letter:
        "[constants]\nquantities = \"thicknes\"\n"
        => "3:14: quantities \"thicknes\" is not one of thickness, friction, friction_angle, friction_angle_degrees, half_opening, half_opening_degrees, thrust, intrinsic_thrust, rotation_joint, rotation_joint_degrees, sliding_joint, sliding_joint_degrees, A (did you mean \"thickness\"?)";
    an_unknown_format:
        "[audit]\nformat = \"xml\"\n"
        => "3:10: format \"xml\" is not one of table, json, csv, csv2, latex, markdown";
    an_unknown_end_of_a_file:
        "[audit]\noutput = \"a.xml\"\n"
        => "3:10: output \"a.xml\" does not tell a format by its end (txt, json, csv, tex, md); give it such an end, or a format, one of table, json, csv, csv2, latex, markdown";
    an_output_that_is_a_number:
        "[constants]\noutput = 3\n"
        => "3:10: output 3 is not a text";
    an_output_outside_the_folder:
        "[constants]\noutput = \"../a.csv\"\n"
        => "3:10: output \"../a.csv\" is not a file inside the folder of outputs (a relative path without ..)";
    an_absolute_output:
        "[constants]\noutput = \"/a.csv\"\n"
        => "3:10: output \"/a.csv\" is not a file inside the folder of outputs (a relative path without ..)";
    an_output_of_two_lines:
        "[constants]\noutput = \"a\\nb.csv\"\n"
        => "3:10: output \"a\\nb.csv\" is not a file inside the folder of outputs (a relative path without ..)";
    the_record_of_the_run_as_an_output:
        "[constants]\noutput = \"couplet-run.json\"\n"
        => "3:10: output \"couplet-run.json\" is where the run keeps its own record";
    an_output_twice:
        "[[constants]]\noutput = \"a.csv\"\n[[audit]]\noutput = \"./a.csv\"\n"
        => "5:10: output \"./a.csv\" is already written by the item whose output is in line 3";
    outputs_that_differ_in_case:
        "[[constants]]\noutput = \"a.csv\"\n[[audit]]\noutput = \"A.csv\"\n"
        => "5:10: output \"A.csv\" differs in case only from the output in line 3";
    a_file_as_a_folder:
        "[[constants]]\noutput = \"a.csv\"\n[[audit]]\noutput = \"a.csv/b.csv\"\n"
        => "5:10: output \"a.csv/b.csv\" and the output in line 3 cannot be a file and its folder";
    a_quantity_of_arches_of_a_thickness:
        "[arches]\nhalf_opening = 1\nfriction = 1\nquantities = \"least_thickness\"\n"
        => "5:14: quantities \"least_thickness\" needs a thickness; give a ratio of thickness to radius (0.12, \"3/25\")";
    a_letter_beside_its_name:
        "[arches]\nhalf_opening = 1\nalpha = 1\nmu = 1\n"
        => "4:9: both half_opening and alpha; give one of them";
    no_half_opening:
        "[arches]\nfriction = 1\n"
        => "2:1: half_opening is missing";
    no_friction:
        "[arches]\nhalf_opening = 1\n"
        => "2:1: friction (or friction_angle) is missing";
    two_frictions:
        "[arches]\nhalf_opening = 1\nfriction = 1\nfriction_angle = 1\n"
        => "5:18: friction and friction_angle say the same: give one of them";
    a_half_opening_beyond_a_turn:
        "[arches]\nfriction = 1\nhalf_opening = \"200deg\"\n"
        => "4:16: the half opening 200deg is not between 0 and pi (180deg)";
    two_units:
        "[arches]\nfriction = 1\nhalf_opening = \"2pideg\"\n"
        => "4:16: '2pideg' has two units";
    a_friction_out_of_range:
        "[arches]\nhalf_opening = 1\nfriction = 1e99999999999999999999\n"
        => "4:12: '1e99999999999999999999' is out of range: sizes from 1e-1000 to below 1e1000 are read";
    a_half_opening_that_is_true:
        "[arches]\nfriction = 1\nhalf_opening = [1, true]\n"
        => "4:20: half_opening true is not an angle (2.45, \"pi/2\", \"80deg\")";
    no_half_openings:
        "[arches]\nfriction = 1\nhalf_opening = []\n"
        => "4:16: half_opening is an empty list; give an angle (2.45, \"pi/2\", \"80deg\")";
    a_half_opening_without_its_unit:
        "[arches]\nfriction = 1\nhalf_opening = [1, 80]\n"
        => "4:20: the half opening 80 is not between 0 and pi (180deg); did you mean 80deg?";
    a_friction_angle_without_its_unit:
        "[arches]\nhalf_opening = 1\nfriction_angle = 31\n"
        => "4:18: the friction angle 31 is not between 0 and pi/2 (90deg); did you mean 31deg?";
    a_friction_that_is_too_large_an_angle:
        "[arches]\nhalf_opening = 1\nfriction = \"91deg\"\n"
        => "4:12: the friction angle 91deg is not between 0 and pi/2 (90deg)";
    a_range_from_a_coefficient_to_an_angle:
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.2, to = \"31deg\", steps = 3 }\n"
        => "4:12: friction: '0.2..31deg' is in two units, or in none that is cut into parts: give both ends as numbers, as lengths, or as angles in radians, as multiples of pi or in degrees";
    a_negative_friction:
        "[arches]\nhalf_opening = 1\nfriction = -0.5\n"
        => "4:12: the friction -0.5 is negative";
    a_friction_angle_of_half_a_turn:
        "[arches]\nhalf_opening = 1\nfriction_angle = \"pi\"\n"
        => "4:18: the friction angle pi is not between 0 and pi/2 (90deg)";
    a_thickness_in_multiples_of_pi:
        "[arches]\nhalf_opening = 1\nfriction = 1\nthickness = \"pi/3\"\n"
        => "5:13: the thickness pi/3 is no ratio of thickness to radius (0.12, 3/25)";
    a_thickness_that_is_a_length:
        "[arches]\nhalf_opening = 1\nfriction = 1\nthickness = [\"0.1r\", \"60cm\"]\n"
        => "5:22: the thickness 60cm is a length: give its ratio to the radius (0.12), or the arch in metres: span and rise, or radius";
    a_thickness_beyond_the_limit:
        "[arches]\nhalf_opening = 1\nfriction = 1\nthickness = 2.1\n"
        => "5:13: the thickness 2.1 is not between 0 and 2";
    a_range_that_falls:
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, to = 0.3, steps = 3 }\n"
        => "4:12: friction: '0.5..0.3' does not rise: give the smaller end first";
    a_range_of_one_step:
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, to = 0.6, steps = 1 }\n"
        => "4:44: steps 1 is not a whole number from 2 to 100000";
    a_range_without_end:
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, to = \"inf\", steps = 3 }\n"
        => "4:12: friction: in '0.5..inf' the part 'inf' is not a number with or without a unit (0.1, 2cm, 1deg) or, behind ±, of % (5%)";
    a_range_without_its_end:
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, steps = 3 }\n"
        => "4:12: friction has no to; a range is { from = …, to = …, steps = … }";
    a_range_in_two_units:
        "[arches]\nfriction = 1\nhalf_opening = { from = 1, to = \"pi/2\", steps = 3 }\n"
        => "4:16: half_opening: '1..pi/2' is in two units, or in none that is cut into parts: give both ends as numbers, as lengths, or as angles in radians, as multiples of pi or in degrees";
    too_many_arches:
        "[arches]\nhalf_opening = { from = 1, to = 2, steps = 1000 }\nfriction = { from = 1, to = 2, steps = 101 }\n"
        => "2:1: 101000 arches are too many; a scene has at most 100000, `couplet states` reads any number";
    a_text_for_true_or_false:
        "[claims]\nshow = \"yes\"\n"
        => "3:8: show \"yes\" is not true or false";
}

#[test]
fn an_unknown_claim() {
    let claim = faults("[claims]\nprove = \"eq-99\"\n");
    assert!(
        claim[0].starts_with("3:9: prove \"eq-99\" is not a claim (did you mean "),
        "{claim:?}"
    );
    assert!(claim[0].contains("; couplet prove --list shows the claims"), "{claim:?}");
}

#[test]
fn all_faults_are_said_at_once_and_nothing_is_computed() {
    let scratch = Scratch::new();
    // Valid items that would take hours, with one wrong thing each behind them.
    let mut scene = "[[constants]]\ndigits = 1_000_000\noutput = \"out/all.csv\"\n".to_owned();
    let wrong: Vec<&&str> = SCENES
        .iter()
        .filter(|text| text.starts_with("[arches]") || text.starts_with("[claims]"))
        .collect();
    for text in &wrong {
        scene += &text.replacen("[arches]", "[[arches]]", 1).replacen("[claims]", "[[claims]]", 1);
    }
    let path = scene_in(&scratch, &scene);
    let start = Instant::now();
    let output = couplet(&["run", &path, "--output", &scratch.path("out")]);
    assert!(start.elapsed() < Duration::from_secs(20));
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    assert_eq!(scratch.files("."), ["scene.toml"]);
    let said = text(&output.stderr);
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines.len(), wrong.len() + 1, "{said}");
    let places: Vec<usize> = lines[..wrong.len()]
        .iter()
        .map(|line| {
            let place = line.strip_prefix(&format!("{path}:")).unwrap();
            place.split(':').next().unwrap().parse().unwrap()
        })
        .collect();
    assert!(places.is_sorted(), "{said}");
    let sum = format!("couplet: {path} has {} errors; nothing was computed", wrong.len());
    assert_eq!(lines[wrong.len()], sum);
}
