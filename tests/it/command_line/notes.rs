//! A question that makes sense is answered as it is asked; what may have been meant otherwise is remarked on.

use crate::program::{couplet, said};

fn asked(line: &str) -> (Option<i32>, String, String) {
    said(&couplet(line))
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
        let (code, printed, noted) = asked(line);
        assert_eq!(code, Some(0), "{line}: {noted}");
        let note =
            "couplet: the friction 15 is a coefficient; an angle of 15 degrees is written 15deg\n";
        assert_eq!(noted, note, "{line}");
        assert!(!printed.is_empty());
    }
    for friction in ["15deg", "inf", "4", "tan(80deg)", "31deg"] {
        let (code, _, noted) =
            asked(&format!("state --half-opening 80deg --friction {friction} --digits 3"));
        assert_eq!((code, noted.as_str()), (Some(0), ""), "{friction}");
    }
    let (_, _, noted) = asked("state --half-opening 80deg --friction 120 --digits 3");
    assert!(noted.ends_with("an angle is written with its unit, 31deg\n"), "{noted}");
}

#[test]
fn a_large_tilt_may_have_been_an_angle() {
    let arch = "assess --half-opening 80deg --friction 0.6 --thickness 0.1 --digits 3 --tilt";
    let stones = "voussoirs --stones 5 --half-opening 80deg --friction 0.6 --thickness 0.1 --digits 3 --tilt";
    for command in [arch, stones] {
        let (code, _, noted) = asked(&format!("{command} 5"));
        let note =
            "couplet: the tilt 5 is 5 times gravity; an angle of 5 degrees is written 5deg\n";
        assert_eq!((code, noted.as_str()), (Some(0), note));
        for tilt in ["5deg", "1"] {
            let (_, _, noted) = asked(&format!("{command} {tilt}"));
            assert_eq!(noted, "", "{tilt}");
        }
    }
}

/// Bad input stays one line.
#[test]
fn what_is_refused_has_no_note() {
    for line in [
        "assess --half-opening 80deg --friction 15 --thickness 3",
        "assess --half-opening 80deg --friction 15 --thickness 0.1 --tilt -5",
        "state --half-opening 80deg --friction 15 --quantity weight_kn",
        "find friction --friction 15",
        "map --friction 15 --bare --format csv",
    ] {
        let (code, _, error) = asked(line);
        assert_eq!((code, error.lines().count()), (Some(2), 1), "{line}: {error}");
        assert!(!error.contains("is a coefficient"), "{error}");
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
        let (code, printed, noted) = asked(&format!("{once} {twice}"));
        assert_eq!(code, Some(0), "{twice}: {noted}");
        let (_, alone, quiet) = asked(once);
        assert_eq!((printed, quiet.as_str()), (alone, ""), "{twice}");
        let note = format!("couplet: {note} is given twice and counts once\n");
        assert!(noted.starts_with(&note), "{noted}");
    }
    let (_, _, noted) = asked("map --bare --mark 1,1 --mark 1,1 --tolerance 1e-1 --format svg");
    assert_eq!(noted, "couplet: the mark 1,1 is given twice and counts once\n");
}
