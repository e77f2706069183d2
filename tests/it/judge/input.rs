//! What a file may hold: any inputs, units and rows, good and bad ones.

use super::{rows, verdicts};
use crate::arches::{H, M, number, stands};
use crate::program::{Json, says};
use couplet::number::ExactNumber;
use couplet::problem::{Arch, Friction};
use rug::Rational;
use serde_json::json;

/// A program in double precision computes with the double next to 0.1, which is more than 0.1.
#[test]
fn inputs_are_exact_or_doubles() {
    let thickness = |half_opening: ExactNumber, friction: ExactNumber| {
        let friction = Friction::Coefficient(friction);
        let arch = Arch::new(M, half_opening, friction).unwrap();
        stands(&arch, 25).thickness.decimal.value.to_string()
    };
    let double = |x: f64| ExactNumber::from(&Rational::from_f64(x).unwrap());
    let table = [
        ("0.1", thickness(number("0.1"), number("0.7")), thickness(double(0.1), double(0.7))),
        (
            "50.1deg",
            thickness(number("50.1").degrees(), number("0.7")),
            thickness(double(double(50.1).degrees().nearest_double().unwrap()), double(0.7)),
        ),
    ];
    for (half_opening, exact, doubles) in table {
        for (inputs, right) in [("exact", &exact), ("double", &doubles)] {
            let input = format!(
                "half_opening,friction,thickness\n{half_opening},0.7,{exact}\n{half_opening},0.7,{doubles}\n"
            );
            let (_, rows) = rows(&format!("--weight milankovitch --inputs {inputs}"), input);
            let found = rows.iter().find(|row| row["verdict"] == "correctly rounded").unwrap();
            assert_eq!(found["numbers"]["thickness"]["claimed"], **right);
            assert_eq!(verdicts(&rows).iter().filter(|v| **v == "correctly rounded").count(), 1);
        }
    }
}

#[test]
fn angles_may_be_in_degrees() {
    let input = "a,phi,joint\n80,30,52.9\n80deg,30,0.9233\n";
    let columns = "a=half_opening:deg,phi=friction_angle:deg,joint=rotation_joint:deg";
    let (_, rows) = rows(&format!("--weight heyman --columns {columns}"), input);
    let value = rows[0]["numbers"]["rotation_joint"]["value"].text();
    let arch = Arch::new(H, number("80").degrees(), Friction::Infinite).unwrap();
    let degrees = stands(&arch, 20).rotation_joint.double.to_degrees();
    approx::assert_relative_eq!(value.parse::<f64>().unwrap(), degrees, max_relative = 1e-14);
    says(&rows[0], json!({"half_opening": "80deg", "friction": "tan(30deg)"}));
    // Not twice, and radians where degrees were named.
    says(&rows[1], json!({"half_opening": "80deg", "verdict": "inaccurate"}));
}

/// An angle is rounded like any other input, in whatever column it stands.
#[test]
fn an_angle_among_the_coefficients_is_the_same_arch() {
    let thickness = "0.1102301023143341972901023";
    let judged = |column: &str, text: &str| {
        let input = format!("half_opening,{column},thickness\n1.5,{text},{thickness}\n");
        rows("--weight heyman --inputs double --accept 25", input).1[0]["verdict"].text().to_owned()
    };
    let verdict = judged("friction_angle", "18.3deg");
    assert_ne!(verdict, "correctly rounded", "24 digits of an angle that a double does not hold");
    assert_eq!(judged("friction", "18.3deg"), verdict);
    assert_eq!(judged("friction", "tan(18.3deg)"), verdict);
}

#[test]
fn bad_rows_do_not_stop_the_others() {
    let long = format!("0.{}", "1".repeat(20_001));
    let mut input: Vec<u8> = b"\xEF\xBB\xBFhalf_opening , friction,thickness\r\n".to_vec();
    let bad: [&[u8]; 17] = [
        b"1,1,\xFF\xFE",
        b"1,1",
        b"1,1,1,1",
        b"nan,1,1",
        b"1,NaN,1",
        b",1,1",
        b"1,,1",
        b"1,1,1e-999999999",
        b"1,1,1e999999999999999999999999",
        b"1,1,1e5001",
        b"1e400,1,1",
        b"1e-999999999,1,1",
        b"1,1e1000000,1",
        b"1,1,\"0,1\"",
        b"1,1,0x1p",
        b"0,1,1",
        long.as_bytes(),
    ];
    for row in bad {
        input.extend(row);
        input.extend(b"\r\n\"1\",\"0.5\",\"1e-9\"\r\n");
    }
    input.extend(b"1,1,1e3000\n1,1,1e-5000\n1,1,-1\n1,\"0.5\",0.02");
    let (code, rows) = rows("--weight heyman", &input);
    assert_eq!(code, Some(2));
    assert_eq!(rows.len(), 2 * bad.len() + 4);
    for (index, row) in rows.iter().take(2 * bad.len()).enumerate() {
        assert_eq!(row["line"], index + 2);
        let verdict = if index % 2 == 0 { "bad row" } else { "thinner than the least thickness" };
        assert_eq!(row["verdict"], verdict, "{row}");
        assert!(index % 2 == 1 || !row["reason"].text().is_empty());
    }
    let last = &verdicts(&rows)[2 * bad.len()..];
    let thicker = "thicker than the least thickness";
    let thinner = "thinner than the least thickness";
    assert_eq!(last, [thicker, thinner, thinner, "correctly rounded"]);
}

#[test]
fn json_lines_are_read_as_they_are_written() {
    let input = "\u{FEFF}{\"a\":1,\"b\":0.5,\"t\":null}\n\n{\"a\":1,\"b\":0.50,\"t\":1.91e-2,\"u\":[]}\n\
        {\"a\":1,\"b\":0.5}\n{\"a\":1,\"a\":2}\n[1]\n{\"a\":{},\"b\":1,\"t\":1}\n{\"a\":1,\"b\":1,\"t\":\"\\ud800\"}\nx\n";
    let columns = "a=half_opening,b=friction,t=thickness";
    let (code, rows) = rows(&format!("--weight heyman --columns {columns}"), input);
    assert_eq!(code, Some(2));
    let falls = "claims that an arch falls which stands";
    let bad = "bad row";
    assert_eq!(verdicts(&rows), [falls, "correctly rounded", "no claim", bad, bad, bad, bad, bad]);
    let lines: Vec<_> = rows.iter().map(|row| row["line"].as_u64().unwrap()).collect();
    assert_eq!(lines, [1, 3, 4, 5, 6, 7, 8, 9]);
    assert_eq!(rows[1]["numbers"]["thickness"]["claimed"], "1.91e-2");
}

/// The same results in every way in which they may be written.
#[test]
fn results_may_be_written_by_any_program() {
    for (input, rounding) in [
        ("Alpha;MU;Eta;mode\n1,5;0,6;0,0901407;[r,r,r]\n", "correctly rounded"),
        ("# alpha mu eta\n1.5 6.0e-01 9.01407e-02\n", "correctly rounded"),
        ("alpha\tphi\teta\n0.15D+01\ttan(0.5)\t.0901407D0\n", "bad row"),
        ("alpha,mu,eta\n0x1.8p0,0.6,0x1.71375da33c6p-4\n", "wrong"),
        ("[{\"alpha\": 1.5, \"mu\": 0.6, \"eta\": 0.0901407}]", "correctly rounded"),
    ] {
        let (_, rows) = rows("--weight heyman", input);
        let found = match rows[0]["verdict"].as_str() {
            Some("bad row") => "bad row",
            _ => rows[0]["numbers"]["thickness"]["rounding"].text(),
        };
        assert_eq!((rows.len(), found), (1, rounding), "{input}: {rows:?}");
    }
}

/// The double nearest to the truth, in hexadecimal as `couplet states` writes it, is right to its last bit.
#[test]
fn a_double_in_hexadecimal_is_judged_by_its_own_last_place() {
    let hex = |text: &str| {
        let input = format!("alpha,mu,eta\npi/2,0.38,{text}\n");
        rows("--weight heyman", input).1[0]["numbers"]["thickness"].clone()
    };
    let nearest = hex("0x1.f47f2a34603cap-4");
    says(&nearest, json!({"rounding": "correctly rounded", "nearest_double": true}));
    assert_eq!(nearest["error_units"], nearest["error_ulp"]);
    assert_eq!(hex("0x1.f47f2a34603ccp-4")["rounding"], "wrong");
}
