//! One language for all commands: the same thing may be said in the same ways everywhere.

use crate::program::{Words, ended, object, printed, tells};

/// An answer behind the question, which is told as it was written.
fn answered(line: impl Words) -> String {
    let out = printed(line);
    let (question, answer) = out.split_once("\n\n").unwrap_or(("", &out));
    assert!(question.lines().count() < 3, "{question}");
    answer.to_owned()
}

/// Arguments that mean the same have the same output.
fn same<W: Words + std::fmt::Display>(ways: &[W]) {
    let [first, others @ ..] = ways else { panic!("nothing to compare") };
    let expected = answered(first);
    assert!(!expected.is_empty(), "{first}");
    for way in others {
        assert_eq!(answered(way), expected, "{way}");
    }
}

#[test]
fn an_angle_has_many_spellings() {
    let state = |alpha: &str| printed(["state", "--alpha", alpha, "--mu", "inf", "--plain"]);
    for alpha in ["80°", "80 deg", "80 degrees", "80DEG", " 80deg"] {
        assert_eq!(state(alpha), state("80deg"), "{alpha}");
    }
    assert_eq!(state("1.5rad"), state("1.5"));
}

#[test]
fn a_friction_has_many_spellings() {
    let state = |mu| answered(format!("state --alpha 80deg --mu {mu} --digits 5"));
    for mu in ["Inf", "INF", "infinity", "Infinity", "∞"] {
        assert_eq!(state(mu), state("inf"), "{mu}");
    }
    same(&[
        "state --alpha 1 --mu 31deg",
        "state --alpha 1 --friction 31º",
        "state --half-opening 1 --friction-angle 31deg",
        "state --alpha 1 --phi 31deg --weight Milankovitch",
    ]);
    let blank = answered(["state", "--alpha", "1", "--friction", "31 °"]);
    assert_eq!(blank, answered("state --alpha 1 --mu 31deg"));
}

#[test]
fn a_landmark_has_a_symbol_and_a_name() {
    for (symbol, name) in [("T", "triple"), ("l", "rotation-end"), ("L", "overturning_end")] {
        for command in ["constants --digits 5", "certify --digits 5", "state --at", "audit --only"]
        {
            same(&[symbol, name].map(|of| format!("{command} {of}")));
        }
    }
}

#[test]
fn both_weights_are_shown_at_once() {
    for line in [
        "state --alpha 1 --mu 1 --plain",
        "constants T --plain",
        "assess --alpha 1 --mu 1 --eta 0.1 --plain",
        "state --at T --digits 5",
    ] {
        let of = |weight| printed(format!("{line} --weight {weight}"));
        assert_eq!(of("both"), of("heyman") + &of("milankovitch"), "{line}");
    }
}

#[test]
fn a_quantity_is_shown_alone() {
    let table = printed("constants T --weight heyman --quantity eta --digits 12");
    assert!(table.contains("0.679604732099") && !table.contains("friction  "), "{table}");
}

#[test]
fn an_arch_that_is_too_thin_is_told_from_one_that_stands_nowhere() {
    let find = |alpha| printed(format!("find friction --alpha {alpha} --eta 0.05"));
    assert!(find("pi/2").contains("too thin, whatever the friction"));
    assert!(find("3").contains("nothing stands (thickness)"));
}

#[test]
fn quantities_that_are_left_out_are_null_or_absent() {
    let state = "state --alpha 80deg --mu 0.6 --digits 8 --quantity thrust";
    let json = object(state);
    assert_eq!(json["thrust"]["value"], "0.69680833");
    assert!(json["thickness"].is_null() && json["sliding_friction"].is_null());
    let csv = printed(format!("{state} --format csv"));
    let header = csv.lines().next().unwrap();
    assert!(header.contains("thrust") && !header.contains(",thickness"), "{header}");
    let c = printed(format!("{state} --format c"));
    assert!(c.contains("THRUST") && !c.contains("THICKNESS"), "{c}");
}

#[test]
fn the_claims_are_listed_without_being_decided() {
    let list = printed("prove --list");
    assert_eq!(list.lines().count(), couplet::claims::claims().len());
    let some = printed("prove --list eq-7");
    assert!(some.lines().count() > 1 && some.lines().all(|line| line.starts_with("eq-7-")));
}

#[test]
fn an_audit_can_be_of_some_landmarks() {
    let audit = printed("audit --only T,S --weight heyman --format csv");
    let mut rows = audit.lines().skip(1).peekable();
    assert!(rows.peek().is_some());
    for row in rows {
        let cells: Vec<&str> = row.split(',').collect();
        let is_of = |name| cells.contains(&name);
        assert!(is_of("heyman") && (is_of("T") || is_of("S")), "{row}");
    }
}

#[test]
fn the_version_tells_the_arithmetic() {
    let (version, error) = ended(0, "--version", "");
    assert_eq!(error, "");
    tells(
        &version,
        ["couplet 0.", "commit: ", "features: ", "plots", "GMP ", "MPFR ", "astro-float"],
    );
}

#[test]
fn threads_change_no_value() {
    let one = printed("constants T --threads 1");
    assert_eq!(one, printed("constants T --threads 3"));
    assert_eq!(one, printed("--threads 2 constants T"));
}

#[test]
fn help_is_coloured_where_it_is_asked_for() {
    let help = |color| printed(format!("constants --help --color {color}"));
    assert!(help("always").contains("\u{1b}[") && !help("never").contains("\u{1b}["));
    assert!(!help("auto").contains("\u{1b}["), "not a terminal");
}

#[test]
fn help_that_cannot_be_written_is_a_failure() {
    if !std::path::Path::new("/dev/full").exists() {
        return;
    }
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let status = crate::program::command("--help").stdout(full).output().unwrap().status;
    assert_eq!(status.code(), Some(3));
}
