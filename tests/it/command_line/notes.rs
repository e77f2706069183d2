//! A question that makes sense is answered as it is asked; what may have been meant otherwise is remarked on.

use crate::program::ended;

fn noted(line: &str) -> String {
    ended(0, line, "").1
}

/// At every door of the command that reads a friction, once.
#[test]
fn a_large_coefficient_may_have_been_an_angle() {
    for line in [
        "state --half-opening 80deg --friction 15 --weight both --digits 3",
        "assess --half-opening 80deg --friction 15 --thickness 0.1 --digits 3",
        "assess --half-opening 80deg --friction 15 --thickness 0.1 --tilt 0.01 --digits 3",
        "draw --half-opening 80deg --friction 15",
        "voussoirs --half-opening 80deg --friction 15 --stones 11 --digits 3",
        "find half-opening --friction 15 --thickness 0.1 --digits 3",
        "certify state --half-opening 80deg --friction 15 --digits 3",
        "complementarity --half-opening 80deg --friction 15 --digits 3",
        "map --friction 15 --tolerance 1e-2",
        "map --bare --mark 80deg,15 --mark 70deg,15 --tolerance 1e-1 --format svg",
    ] {
        let (printed, noted) = ended(0, line, "");
        let note =
            "couplet: the friction 15 is a coefficient; an angle of 15 degrees is written 15deg\n";
        assert_eq!(noted, note, "{line}");
        assert!(!printed.is_empty());
    }
    for friction in ["15deg", "inf", "4", "tan(80deg)", "31deg"] {
        let line = format!("state --half-opening 80deg --friction {friction} --digits 3");
        assert_eq!(noted(&line), "", "{friction}");
    }
    let noted = noted("state --half-opening 80deg --friction 120 --digits 3");
    assert!(noted.ends_with("an angle is written with its unit, 31deg\n"), "{noted}");
}

#[test]
fn a_large_tilt_may_have_been_an_angle() {
    let arch = "assess --half-opening 80deg --friction 0.6 --thickness 0.1 --digits 3 --tilt";
    let stones = "voussoirs --stones 5 --half-opening 80deg --friction 0.6 --thickness 0.1 --digits 3 --tilt";
    for command in [arch, stones] {
        let note =
            "couplet: the tilt 5 is 5 times gravity; an angle of 5 degrees is written 5deg\n";
        assert_eq!(noted(&format!("{command} 5")), note);
        for tilt in ["5deg", "1"] {
            assert_eq!(noted(&format!("{command} {tilt}")), "", "{tilt}");
        }
    }
}

/// A value that is given twice is told, and changes nothing else.
#[test]
fn what_is_given_twice_counts_once() {
    for (once, twice, note) in [
        ("map --friction 0.5 --tolerance 1e-1 --format csv", "--friction 1/2", "the friction 1/2"),
        (
            "map --alpha 80deg --tolerance 1e-1 --format csv",
            "--alpha 80°",
            "the half opening 80deg",
        ),
        ("map --eta 0.1 --tolerance 1e-1 --format csv", "--eta 0.1r,1/10", "the thickness 0.1"),
        ("map --curve limit --tolerance 1e-1 --format csv", "--curve limit", "the curve limit"),
        ("constants T --digits 3", "T", "T"),
        ("prove --list eq-16", "eq-16", "eq-16"),
        ("state --alpha 1 --mu 1 --digits 3 --quantity thickness", "--quantity eta", "thickness"),
    ] {
        let (printed, noted) = ended(0, format!("{once} {twice}"), "");
        assert_eq!(ended(0, once, ""), (printed, String::new()), "{twice}");
        let note = format!("couplet: {note} is given twice and counts once\n");
        assert!(noted.starts_with(&note), "{noted}");
    }
    let twice = "map --bare --mark 1,1 --mark 1,1 --tolerance 1e-1 --format svg";
    assert_eq!(noted(twice), "couplet: the mark 1,1 is given twice and counts once\n");
}
