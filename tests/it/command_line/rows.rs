//! `couplet states`: what its rows ask, how they may be written, and when they are answered.

use super::stdout;
use crate::program::{
    Json, Scratch, ended, fed, lines, object, printed, refused, rows, said, start, tells, text,
};
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};

/// The rows that `couplet states` makes of an input, as JSON.
fn objects(arguments: &str, input: impl AsRef<[u8]>) -> Vec<Value> {
    lines(format!("states {arguments}"), input)
}

/// The same as a table with all its columns, by their names.
fn table(arguments: &str, input: &str) -> Vec<BTreeMap<String, String>> {
    rows(fed(format!("states --format csv --columns all {arguments}"), input).stdout)
}

#[test]
fn a_weight_that_is_missing_is_milankovitchs_unless_said() {
    let input = "weight,alpha,mu\n,1.5,inf\nHEYMAN,1.5,inf\n";
    let weights = |arguments: &str| -> Vec<Value> {
        objects(arguments, input).into_iter().map(|row| row["weight"].clone()).collect()
    };
    assert_eq!(weights(""), ["milankovitch", "heyman"]);
    assert_eq!(weights("--weight heyman"), ["heyman", "heyman"]);
    assert_eq!(objects("", "{\"alpha\":1,\"mu\":1}")[0]["weight"], "milankovitch");
}

/// One arch in every way in which it may be written.
#[test]
fn a_file_may_be_written_by_any_program() {
    let expected = &objects("--digits 6", "half_opening,friction\n1.5,0.5\n")[0]["thickness"];
    assert!(expected.is_object());
    for input in [
        "Alpha;MU\n1,5;0,5\n",
        "alpha\tmu\r\n1.5\t0.5\r\n",
        "# half_opening friction\n1.500000000000000000e+00 5.000000000000000000e-01\n",
        "# written by hand\n#alpha,mu\n1.5,.5\n",
        "\u{feff}Half Opening,Friction\n0.15D+01,5d-1\n",
        "alpha,mu\n0x1.8p+0,0X1P-1\n",
        "[{\"alpha\": 1.5, \"mu\": 0.5}]",
        "{\n  \"alpha\": 1.5,\n  \"mu\": 0.5\n}\n",
        "{\"arches\": [\n {\"alpha\":\"3/2\",\"friction\":{\"value\":\"0.5\"}}\n]}",
    ] {
        let found = objects("--digits 6", input);
        assert_eq!(found.len(), 1, "{input:?}: {found:?}");
        assert_eq!(found[0]["thickness"], *expected, "{input:?}");
    }
    let angle = "phi,alpha\n35deg,1.5\n";
    assert_eq!(objects("", angle)[0]["friction_double"], 0.700_207_538_209_709_8);
}

#[test]
fn a_hexadecimal_double_is_exact() {
    let row = &objects("", "alpha,mu\n0x1.999999999999ap-4,1\n")[0];
    assert_eq!(row["half_opening"], "3602879701896397/36028797018963968");
    assert_eq!(row["half_opening_rad"], 0.1);
}

#[test]
fn a_comma_is_no_decimal_point_where_commas_separate() {
    let row = &objects("", "alpha,mu\n\"1,5\",1\n")[0];
    assert!(row["error"].text().contains("'1,5'"), "{row}");
}

/// Columns of others are read by the names that they are given; and what is written here can be read here.
#[test]
fn columns_of_others_are_ours_by_name() {
    let columns = "--digits 9 --columns opening=half_opening:deg,m=mu,t=thickness";
    let named = table(columns, "run,opening,m,t\n1,80,0.6,0.12\n2,1e2,inf,1/5\n");
    let ours = table("--digits 9", "alpha,mu,eta\n80deg,0.6,0.12\n100deg,inf,1/5\n");
    assert_eq!((named.len(), ours.len()), (2, 2));
    for (one, other) in named.iter().zip(&ours) {
        for key in ["stands", "least_thickness", "geometric_safety", "least_thrust"] {
            assert_eq!(one[key], other[key], "{key}");
        }
    }
    let bridge = "l,f,friction\n10m,3m,0.6\n";
    let bridge = &table("--digits 9 --columns l=span,f=rise,friction", bridge)[0];
    let alone = object("state --span 10m --rise 3m --friction 0.6 --digits 9");
    assert_eq!(alone["least_thickness_m"]["value"], bridge["least_thickness_m"]);
    let once = fed("states --digits 9", "alpha,mu\n1.5,0.6\n2,1\n").stdout;
    assert_eq!(fed("states --digits 9", &once).stdout, once, "written and read");
    // Of an arch in metres the exact half opening and thickness are read, and none of the sizes that follow.
    let sized = "span,rise,mu,eta,measured_at\n10m,3m,0.6,60cm,extrados\n33ft,9ft,0.6,,\n";
    for format in ["csv", "jsonl"] {
        let written = fed(format!("states --format {format} --columns all"), sized).stdout;
        let (first, again) = (table("", sized), table("", &text(&written)));
        for (one, other) in first.iter().zip(&again) {
            for key in ["half_opening", "thickness", "stands", "least_thickness", "can_stand"] {
                assert_eq!(one[key], other[key], "{format} {key}");
            }
            assert_eq!((&*other["error"], other.get("span_m")), ("", None));
        }
        assert_eq!((first.len(), again.len()), (2, 2));
    }
}

/// Forces follow from a density and a depth.
#[test]
fn a_row_with_a_density_and_a_depth_has_forces() {
    let input = "span,rise,mu,thickness,density,depth\n10m,3m,0.6,60cm,24kN/m3,1m\n10m,3m,0.6,,,\n";
    let found = table("--digits 6", input);
    let line = "assess --span 10m --rise 3m --friction 0.6 --thickness 60cm --density 24kN/m3 --depth 1m --digits 6";
    let alone = object(line);
    for name in ["weight_kn", "least_thrust_kn", "largest_thrust_kn"] {
        assert_eq!(alone[name]["value"], found[0][name], "{name}");
    }
    assert_eq!((&*found[1]["weight_kn"], &*found[1]["error"]), ("", ""));
}

#[test]
fn an_answer_does_not_wait_for_the_next_question() {
    for (header, row) in [("alpha,mu\n", "1,1\n"), ("", "{\"alpha\":1,\"mu\":1}\n")] {
        let mut child = start("states --digits 3");
        let mut stdin = child.stdin.take().unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        stdin.write_all(header.as_bytes()).unwrap();
        for _ in 0..3 {
            stdin.write_all(row.as_bytes()).unwrap();
            stdin.flush().unwrap();
            let answer = lines.by_ref().map(Result::unwrap).find(|line| line.contains("0.0191"));
            assert!(answer.is_some());
        }
        drop(stdin);
        assert!(child.wait().unwrap().success());
    }
}

#[test]
fn a_quote_too_many_costs_one_row() {
    let mut input = String::from("alpha,mu\n\"1,1\n");
    // Blanks around a number make a long file of few rows.
    let blanks = " ".repeat(1000);
    input += &format!("1,1{blanks}\n").repeat(1000);
    let (output, _) = ended(2, "states --digits 1", &input);
    let mut lines = output.lines();
    let bad = lines.nth(1).unwrap();
    tells(bad, [",2,the quote that opens in line 2 is not closed within 524288 bytes"]);
    assert_eq!(lines.filter(|line| line.contains("[r,r,r]")).count(), 1000);
}

#[test]
fn a_long_line_costs_one_row() {
    let input = format!("alpha,mu\n1,1\n{},1\n1,2\n", "1".repeat(1 << 21));
    let found = objects("--digits 1", input);
    assert_eq!(found[1]["error"], "a line of more than 524288 bytes");
    assert_eq!((&found[2]["line"], &found[2]["friction"]), (&4.into(), &"2".into()));
}

#[test]
fn a_file_becomes_a_file() {
    let scratch = Scratch::new();
    scratch.write("in.csv", "alpha,mu\n1,1\n");
    let (file, out) = (scratch.path("in.csv"), scratch.path("out.csv"));
    assert_eq!(printed(["states", &file, "-o", &out]), "");
    assert_eq!(scratch.read("out.csv").lines().count(), 2);
    refused(["states", &file, "-o", &file], "", "refusing to overwrite the input");
    ended(3, "states missing.csv", "");
}

#[test]
fn text_from_outside_is_not_obeyed() {
    let hostile = "1.5,0.6,\u{1b}]0;pwn\u{7}\u{9b}2K\n1.5,\u{1b}[2J,1\n\u{1b}[2J,1,1\n";
    let input = format!("alpha,mu,eta\n{hostile}");
    for command in ["states", "judge -", "judge - --format json"] {
        let output = fed(command, &input);
        let said = [stdout(&output), text(&output.stderr)].concat();
        assert!(!said.contains(['\u{1b}', '\u{7}', '\u{9b}']), "{command} {said:?}");
        assert!(said.contains(r"\u{1b}"), "{said}");
    }
    refused("judge -", "\u{1b}[2J,b\n", r"\u{1b}[2J");
}

#[test]
fn what_is_kept_is_as_it_came_unless_a_terminal_would_obey_it() {
    let input = "alpha,mu,eta,x\u{1b}[2J,\"e\u{301}\"\n1,1,1,\u{1b}]0;a\0\u{202e}b,\"\ta\tb\"\n";
    for command in ["states", "judge"] {
        let input = if command == "states" { &input.replace("eta,", "note,") } else { input };
        let output = |format| {
            let line = format!("{command} - --keep all --format {format}");
            let (_, output, message) = said(&fed(line, input));
            let is_obeyed = |c: char| c.is_control() && !"\t\n".contains(c) || c == '\u{202e}';
            assert!(!output.contains(is_obeyed), "{command} {output:?} {message}");
            output
        };
        let table = output("csv");
        tells(&table, [r"x\u{1b}[2J,", "e\u{301}", r"\u{1b}]0;a\0\u{202e}b,", ",a\tb,"]);
        let row: Value = serde_json::from_str(&output("jsonl")).unwrap();
        assert_eq!(row["kept"]["x\u{1b}[2J"], "\u{1b}]0;a\0\u{202e}b");
        assert_eq!(row["kept"]["e\u{301}"], "a\tb");
    }
}

#[test]
fn a_double_is_infinite_where_its_value_is() {
    let row = &table("", "alpha,mu\n2.6,inf\n")[0];
    for end in ["", "_double", "_hex"] {
        assert_eq!(row[&format!("rotational_friction{end}")], "inf", "{row:?}");
    }
    let row = &objects("", "alpha,mu\n2.6,inf\n")[0]["rotational_friction"];
    assert_eq!((&row["value"], row.get("double"), row.get("hex")), (&"inf".into(), None, None));
}

/// Tables as spreadsheets write them: marks at the beginning, ends of lines, separators, heads with units and Greek
/// letters.
#[test]
fn tables_are_read_as_spreadsheets_write_them() {
    let answered = |table: &str| objects("- --quantity thickness", table)[0]["thickness"].clone();
    let expected = answered("alpha,mu\n80.5deg,0.6\n");
    assert!(expected["value"].is_string());
    let mut tables = 0;
    for (separator, number) in [(";", "80,5"), (";", "80.5"), (",", "80.5"), ("\t", "80.5")] {
        let said = format!("sep={separator}\n");
        for before in ["", "\u{feff}", &said, &format!("\u{feff}\"sep={separator}\"\n")] {
            let heads =
                [("alpha_deg", ""), ("α [°]", ""), ("Half Opening (DEG)", ""), ("alpha", "º")];
            let frictions =
                [("μ", "\n"), ("Mu", "\r\n"), ("friction", " \r\n"), ("Friction ", "\n\n")];
            for (head, unit) in heads {
                for (mu, end) in frictions {
                    let cells = [[head, mu], [&format!("{number}{unit}"), "0.6"]];
                    let lines = cells.map(|row| row.join(separator) + end);
                    let table = format!("{before}{}", lines.concat());
                    assert_eq!(answered(&table), expected, "{table:?}");
                    tables += 1;
                }
            }
        }
    }
    assert_eq!(tables, 256);
    let metres = answered("span,rise,mu\n10m,300cm,0.6\n");
    for table in [
        "span_m,rise_cm,mu\n10,300,0.6\n",
        "sep=;\nSpan [m];Rise (m);friction_deg;note\n10,0;3;30,963756532073521;ü\n",
        "span [m],rise [m],mu\n10m,300 cm,0.6\n",
    ] {
        let found = answered(table);
        let digits = |of: &Value| of["value"].text()[..12].to_owned();
        assert_eq!(digits(&found), digits(&metres), "{table:?}");
    }
    let utf16: Vec<u8> = "alpha,mu\n1,1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let (_, message) = ended(2, "states", utf16);
    let said = "couplet: the file is UTF-16, which is not read: save it as UTF-8 (\"CSV UTF-8\" in Excel)\n";
    assert_eq!(message, said);
    let latin = fed("states --format jsonl", &b"alpha,mu,stra\xdfe\n1,1,M\xfcller\n"[..]);
    tells(&text(&latin.stdout), ["\"verdict\":\"proved\""]);
}
