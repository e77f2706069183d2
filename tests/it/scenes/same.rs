//! One question has one answer: of the command and of a scene.

use super::{place, scene_in};
use crate::program::{Scratch, couplet, ended, said};
use couplet::scene::read;

/// What a scene answers: its exit code, what it prints, and what it says, without places.
fn scene(table: &str) -> (Option<i32>, String, String) {
    let scratch = Scratch::new();
    let (code, printed, said) = said(&couplet(["run", &scene_in(&scratch, table)]));
    let first = said.lines().next().unwrap_or_default();
    let message = first.split_once(": ").map_or("", |(_, message)| message);
    (code, printed, message.to_owned())
}

/// The names of options as a scene has them.
fn keys(message: &str) -> String {
    let keys = message.replace("couplet: ", "").replace("--half-opening", "half_opening");
    keys.replace("--curve", "curves").replace("--mark", "marks").replace("--", "")
}

/// An option that has no effect is refused at both doors, by one sentence.
#[test]
fn what_has_no_effect_is_refused_alike() {
    for (arguments, table) in [
        ("--bare --format html", "bare = true\nformat = \"html\""),
        ("--bare --format csv", "bare = true\nformat = \"csv\""),
        ("--plane opening-friction --format csv", "plane = \"opening-friction\"\nformat = \"csv\""),
        (
            "--plane thickness-friction --format json",
            "plane = \"thickness-friction\"\nformat = \"json\"",
        ),
        ("--lines --friction 0.5 --format csv", "lines = true\nfriction = 0.5\nformat = \"csv\""),
        ("--lines --bare --format svg", "lines = true\nbare = true\nformat = \"svg\""),
        ("--lines --friction 1 --format svg", "lines = true\nfriction = 1\nformat = \"svg\""),
        ("--bare --half-opening 1 --format svg", "bare = true\nhalf_opening = 1\nformat = \"svg\""),
        ("--thickness 1 --format svg", "thickness = 1\nformat = \"svg\""),
        ("--curve limit --format html", "curves = \"limit\"\nformat = \"html\""),
        ("--weight both --format svg", "weight = \"both\"\nformat = \"svg\""),
        ("--scale log --format csv", "scale = \"log\"\nformat = \"csv\""),
        ("--mark 1,1 --format csv", "marks = \"1,1\"\nformat = \"csv\""),
    ] {
        let (printed, error) = ended(2, format!("map {arguments}"), "");
        assert_eq!((printed.as_str(), error.lines().count()), ("", 1), "{arguments}: {error}");
        let (code, printed, message) = scene(&format!("[[map]]\n{table}\n"));
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{table}");
        assert_eq!(keys(error.trim_end()), message, "{arguments}");
    }
}

/// What makes sense at one door makes the same sense at the other: a value twice, an angle as the friction.
#[test]
fn what_makes_sense_is_answered_alike() {
    let map = |options, keys, note| {
        let line = format!("map --tolerance 1e-1 --format csv {options}");
        (line, format!("[[map]]\ntolerance = 0.1\nformat = \"csv\"\n{keys}"), note)
    };
    let arch = |command, options, keys| {
        let line =
            format!("{command} --half-opening 80deg --friction 31deg --digits 9 --format csv");
        let table = "[[arches]]\nhalf_opening = \"80deg\"\nfriction = \"31deg\"\ndigits = 9\nformat = \"csv\"";
        (format!("{line} {options}"), format!("{table}\n{keys}"), "")
    };
    for (arguments, table, twice) in [
        map("--friction 0.5,1/2", "friction = [0.5, \"1/2\"]", "friction \"1/2\""),
        map("--half-opening 1,1", "half_opening = [1, 1]", "half_opening 1"),
        map("--curve limit --curve limit", "curves = [\"limit\", \"limit\"]", "curves \"limit\""),
        map("--friction 31deg", "friction = \"31deg\"", ""),
        arch("state", "", ""),
        arch("assess", "--thickness 0.1r", "thickness = \"0.1r\""),
    ] {
        let note = match twice {
            "" => String::new(),
            twice => format!("{twice} is listed twice and counts once"),
        };
        let (alone, remarks) = ended(0, &arguments, "");
        assert_eq!(remarks.contains("counts once"), !note.is_empty(), "{arguments}");
        let (code, printed, message) = scene(&format!("{table}\n"));
        assert_eq!((code, message.as_str()), (Some(0), note.as_str()), "{table}");
        assert_eq!(printed, alone, "{arguments}");
    }
}

/// Angles and coefficients go together in a list, and angles in a range.
#[test]
fn a_list_of_frictions_may_have_angles() {
    let table = "[[arches]]\nhalf_opening = 1\nfriction = [\"31deg\", 0.5, \"tan(0.5)\", \"inf\"]\n\
        quantities = \"thickness\"\ndigits = 3\nformat = \"csv\"\n";
    let (code, printed, _) = scene(table);
    assert_eq!(code, Some(0), "{printed}");
    assert_eq!(super::column(&printed, "friction"), ["tan(31deg)", "0.5", "tan(0.5)", "inf"]);
    let range = table.replace(
        "[\"31deg\", 0.5, \"tan(0.5)\", \"inf\"]",
        "{ from = \"30deg\", to = \"31deg\", steps = 3 }",
    );
    let (_, printed, _) = scene(&range);
    assert_eq!(super::column(&printed, "friction"), ["tan(30deg)", "tan(30.5deg)", "tan(31deg)"]);
    let (_, angles, _) = scene(&range.replace("friction =", "friction_angle ="));
    assert_eq!(angles, printed, "the same under either key");
    let range = range.replace("30deg", "0.5rad").replace("31deg", "0.6rad");
    let (_, printed, _) = scene(&range);
    assert_eq!(super::column(&printed, "friction"), ["tan(0.5)", "tan(0.55)", "tan(0.6)"]);
}

/// Whatever is listed twice counts once, with its place.
#[test]
fn what_is_listed_twice_is_told() {
    let notes = |table: &str| -> Vec<String> {
        let scene = read(&format!("{}{table}", super::HEAD)).unwrap();
        scene.notes.iter().map(place).collect()
    };
    for (table, note) in [
        ("weight = [\"heyman\", \"heyman\"]\n[constants]\n", "2:21: weight \"heyman\""),
        ("[claims]\nprove = [\"eq-16\", \"eq-16\"]\n", "3:19: prove \"eq-16\""),
        ("[constants]\nlandmarks = [\"T\", \"triple\"]\n", "3:19: landmarks \"triple\""),
        (
            "[[map]]\nbare = true\nformat = \"svg\"\nmarks = [\"1,1\", \"1,1\"]\n",
            "5:17: marks \"1,1\"",
        ),
        ("[arches]\nhalf_opening = 1\nfriction = [0.5, 1, \"1/2\"]\n", "4:21: friction \"1/2\""),
    ] {
        assert_eq!(notes(table), [format!("{note} is listed twice and counts once")], "{table}");
    }
    let none = notes("[arches]\nhalf_opening = [1, \"57deg\"]\nfriction = [0, \"inf\"]\n");
    assert_eq!(none, [""; 0]);
}
