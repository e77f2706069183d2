//! The line that `couplet check` prints says what was checked, however the file spells it.

use super::originals::{landmark, state};
use super::spoiled::decimal;
use crate::program::{Scratch, couplet, ended, said};
use couplet::certify::certify_arch;
use rug::Rational;
use rug::ops::Pow;
use serde_json::{Value, json};

/// The line about a certificate from standard input, without its name.
fn line(certificate: &Value) -> String {
    let (output, message) = ended(0, "check -", certificate.to_string());
    assert_eq!((message.as_str(), output.lines().count()), ("", 1), "{output}");
    output.trim_end().strip_prefix("-: ").unwrap().to_owned()
}

/// The number that a decimal text stands for; dots only leave out digits behind the point.
fn number(text: &str) -> Rational {
    decimal(&text.replace('…', ""))
}

/// The value that a line shows.
fn shown<'a>(line: &'a str, quantity: &str) -> &'a str {
    let behind = line.split_once(&format!("{quantity} ")).unwrap().1;
    behind.split_whitespace().next().unwrap()
}

/// Whether a line shows this value, cut behind some digits at the most.
fn shows(line: &str, quantity: &str, value: &str) {
    let (shown, value) = (number(shown(line, quantity)), number(value));
    let cut = Rational::from(&value - &shown);
    let most = value.clone() / Rational::from(10).pow(13);
    assert!(cut >= 0 && cut <= most, "{line}: {value}");
}

/// Other texts of the same number and digits: with the point elsewhere.
fn spellings(value: &str) -> Vec<String> {
    let (mantissa, power) = value.split_once('e').unwrap_or((value, "0"));
    let power: i64 = power.parse().unwrap();
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{whole}{part}");
    let digits = all.trim_start_matches('0');
    let last = power - part.len() as i64;
    let (head, tail) = digits.split_at(1);
    let size = digits.len() as i64;
    vec![
        value.to_owned(),
        format!("{digits}e{last}"),
        format!("{head}.{tail}e{}", last + size - 1),
        format!("0.{digits}e{}", last + size),
        format!("0.{}{digits}e{}", "0".repeat(28), last + size + 28),
        format!("{}.{}e{}", &digits[..10], &digits[10..], last + size - 10),
        format!(
            "0.{digits}e{}{}",
            if last + size < 0 { "-" } else { "" },
            format_args!("{:07}", (last + size).abs())
        ),
    ]
}

#[test]
fn every_spelling_of_a_value_is_printed_truly() {
    for base in [landmark("T"), state("2.45", "1.35"), state("1/1000", "9/10")] {
        let value = base["values"][0]["value"].as_str().unwrap();
        let first = line(base);
        for spelling in spellings(value) {
            let mut copy = base.clone();
            copy["values"][0]["value"] = json!(spelling);
            let printed = line(&copy);
            shows(&printed, "thickness", value);
            assert_eq!(printed, first, "{spelling}");
        }
    }
}

#[test]
fn a_power_of_ten_is_not_cut_off() {
    let arch = crate::arches::arch(crate::arches::H, "1/1000", "9/10");
    for digits in [20, 21, 22, 30, 200] {
        let certificate = serde_json::to_value(certify_arch(&arch, None, digits).unwrap()).unwrap();
        let printed = line(&certificate);
        assert!(shown(&printed, "thickness").ends_with("e-14"), "{printed}");
        shows(&printed, "thickness", certificate["values"][0]["value"].as_str().unwrap());
    }
}

#[test]
fn every_value_is_printed_truly() {
    // The first value is the one that is printed: each takes its turn.
    let base = landmark("T");
    for value in base["values"].as_array().unwrap() {
        let mut copy = base.clone();
        copy["values"] = json!([value]);
        let text = value["value"].as_str().unwrap();
        shows(&line(&copy), value["quantity"].as_str().unwrap(), text);
    }
    let mut copy = landmark("l").clone();
    let infinite = |value: &&Value| value["value"] == "inf";
    let values = copy["values"].as_array().unwrap();
    copy["values"] = json!([values.iter().find(infinite).unwrap()]);
    assert_eq!(shown(&line(&copy), "friction"), "inf");
}

/// A fraction that is not in lowest terms, of a hundred thousand digits, is the same number and fits the line.
#[test]
fn a_long_fraction_is_shortened_and_counted() {
    let zeros = "0".repeat(99_990);
    let mut copy = state("2.45", "1.35").clone();
    copy["claim"]["state"]["half_opening"] = json!(format!("49{zeros}/20{zeros}"));
    copy["claim"]["state"]["friction"] = json!(format!("0000{zeros}27/20"));
    let printed = line(&copy);
    let cut = |digits: &str| format!("{digits}{}…(99992 digits)", "0".repeat(20));
    let expected = format!("half_opening {}/{} friction 27/20 ", cut("49"), cut("20"));
    assert!(printed.contains(&expected) && printed.len() < 300, "{printed}");
}

/// No name of a file prints a line, or a sequence, of its own.
#[cfg(unix)]
#[test]
fn a_name_of_a_file_is_printed_in_one_line_whatever_its_bytes_are() {
    use crate::program::command;
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let scratch = Scratch::new();
    let good = landmark("T").to_string();
    for (name, shown) in [
        (&b"a.json: accepted  T\nold.json"[..], "a.json: accepted  T\\nold.json: "),
        (b"\r\x1b[2Kx", "\\r\\u{1b}[2Kx: "),
        (b"\xffx\xfe.json", "\\xffx\\xfe.json: "),
        ("\u{202e}α.json".as_bytes(), "\\u{202e}α.json: "),
    ] {
        let path = scratch.folder().join(OsStr::from_bytes(name));
        std::fs::write(&path, &good).unwrap();
        let check = || command("check").arg(&path).output().unwrap();
        let (code, output, _) = said(&check());
        assert_eq!((code, output.lines().count()), (Some(0), 1), "{output}");
        assert!(output.contains(&format!("{shown}accepted  T heyman")), "{output}");
        std::fs::remove_file(&path).unwrap();
        let (code, output, message) = said(&check());
        assert_eq!((code, output.lines().count(), message.lines().count()), (Some(3), 1, 1));
        let end = format!("{shown}not read: no such file or folder\n");
        assert!(output.ends_with(&end), "{output}");
    }
    let wrong = command(["check", "--engine", "\u{1b}[2K\n"]).arg("x").output().unwrap();
    assert!(!said(&wrong).2.trim_end().contains(char::is_control), "{}", said(&wrong).2);
    assert_eq!(couplet(["check", "a\nb"]).status.code(), Some(3));
}
