//! `couplet states --ranges`: rows of which each is about all arches between its ends.

use crate::program::{Json, ended, fed, lines, of_lines, rows, tells};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

fn objects(arguments: &str, input: &str) -> Vec<Value> {
    lines(format!("states --ranges {arguments}"), input)
}

fn table(arguments: &str, input: &str) -> Vec<BTreeMap<String, String>> {
    rows(fed(format!("states --ranges {arguments}"), input).stdout)
}

fn end<'a>(row: &'a Value, quantity: &str, end: &str) -> &'a Value {
    let all = row["ranges"].list();
    &all.iter().find(|range| range["quantity"] == quantity).unwrap()[end]["value"]
}

/// Free and measured, of both weights, with each outcome, unlimited friction and angles in it.
const ROWS: &str = "weight,alpha,span,rise,mu,eta\n\
    heyman,80deg±1deg,,,0.6±10%,0.1..0.12\n\
    milankovitch,1.5..1.6,,,31deg±1deg,0.06±0.01\n\
    milankovitch,1.5..1.6,,,0.5..inf,0.09..0.2\n\
    heyman,2..2.3,,,inf,0.2..0.3\n\
    heyman,,10m±10cm,3m±5cm,0.5,15cm+-1cm\n\
    milankovitch,2.4..2.9,,,0.6..0.9,\n\
    milankovitch,1..1.1,,,0.3,\n";

#[test]
fn a_table_has_the_ends_that_the_objects_have() {
    let (objects, cells) = (objects("", ROWS), table("", ROWS));
    let names: Vec<&String> = cells[0].keys().collect();
    assert!(!names.iter().any(|name| *name == "least_thickness"), "{names:?}");
    let outcomes: BTreeSet<&str> =
        objects.iter().filter_map(|row| row["outcome"].as_str()).collect();
    let all = ["all_can_stand", "all_stand", "both_occur", "none_can_stand", "none_stands"];
    assert_eq!(outcomes, BTreeSet::from(all));
    let mut told = 0;
    for (row, cells) in objects.iter().zip(&cells) {
        assert_eq!(row["outcome"].as_str(), Some(&*cells["outcome"]));
        assert_eq!(cells["verdict"], "proved");
        for range in row["ranges"].list() {
            let name = range["quantity"].text();
            for side in ["lower", "upper"] {
                let cell = &cells[&format!("{name}_{side}")];
                let expected = match range[side]["bound"].text() {
                    "unbounded" => "inf",
                    "not_enough" => "",
                    _ => range[side]["value"].text(),
                };
                assert_eq!(cell, expected, "{name}_{side} of {cells:?}");
                told += 1;
            }
        }
    }
    assert!(told > 50, "{told}");
    let unlimited = &cells[2];
    assert_eq!(unlimited["friction"], "0.5..inf");
    assert_eq!(unlimited["friction_safety_upper"], "inf");
    let measured = &cells[4];
    assert_eq!(measured["thickness"], "14cm..16cm");
    assert!(measured["half_opening"].starts_with("2atan("), "{measured:?}");
    assert!(!measured["least_thickness_m_upper"].is_empty());
    let states = table("", "alpha,mu\n1,1\n");
    let has = |name: &str| states[0].contains_key(name);
    assert!(has("thrust_upper") && !has("least_thrust_upper"));
    let chosen = table("--quantity thickness", ROWS);
    assert_eq!(chosen[0]["least_thickness_upper"], cells[0]["least_thickness_upper"]);
    assert!(!chosen[0].contains_key("geometric_safety_lower"));
}

/// The ends of a row without extent are the two bounds of the one value, digit for digit.
#[test]
fn a_range_of_one_value_is_answered_as_the_point_is() {
    let points = "weight,alpha,mu,eta\nheyman,80deg,0.6,0.12\nmilankovitch,pi/2,31deg,0.1\n\
        heyman,1.5,inf,0.3\nmilankovitch,2.6,0.7,1.9\nmilankovitch,80deg,0.6,\nheyman,2.2,1.1,\n\
        milankovitch,1e-3,0.3,0.01\n";
    let same = points.replace("80deg,0.6", "80deg±0,0.6..3/5").replace("pi/2,", "90deg..pi/2,");
    let alone = lines("states", points);
    let same = same.replace("±0,", "±0%,");
    for ranged in [objects("", points), objects("", &same)] {
        let mut compared = 0;
        for (one, ranged) in alone.iter().zip(&ranged) {
            for range in ranged["ranges"].list() {
                let name = match range["quantity"].text() {
                    "least_thickness" if one["stands"].is_null() => "thickness",
                    name => name,
                };
                let value = one[name].get("thrust").unwrap_or(&one[name]);
                for side in ["lower", "upper"] {
                    if range[side]["bound"] == "number" {
                        assert_eq!(range[side]["value"], value[side], "{name} of {one}");
                        compared += 1;
                    } else {
                        assert!(value.is_null() || value["value"] == "inf", "{name} of {one}");
                    }
                }
            }
            let stands = one["stands"].as_bool().or(one["can_stand"].as_bool()).unwrap();
            let outcome = ranged["outcome"].text();
            assert_eq!(outcome.starts_with("all"), stands, "{ranged}");
        }
        assert!(compared > 40, "{compared}");
    }
}

#[test]
fn a_bad_row_is_told_in_its_row() {
    let input = "weight,alpha,mu,eta,id\n,1..1.1,0.7..0.6,0.1,a\n,1..,0.6,0.1,b\n,..,0.6,0.1,c\n\
        ,1..2..3,0.6,0.1,d\n,80..82deg,1,0.1,e\n,1..4,1,0.1,f\n,1,0.1±0.2,0.1,g\n,1..2,1,50cm..60cm,h\n\
        heymann,1,1,0.1,i\n,1..2,,0.1,j\n,1..1.2,0.6±10%,0.1,k\n,1,±5%,0.1,l\n,1,inf..1,0.1,m\n";
    let (output, told) = ended(2, "states --ranges --format jsonl --keep id", input);
    tells(&told, ["12 of 13 rows could not be read"]);
    let all = of_lines(&output);
    let reasons = [
        "the range 0.7..0.6 is empty: give the lower end first",
        "'1..' is half a range",
        "'..' is half a range",
        "'1..2..3' has more parts",
        "write 80deg..82deg",
        "4 is not between 0 and pi",
        "the friction -0.1 is negative",
        "50cm is a length",
        "a weight is one of heyman",
        "friction (or friction_angle) is missing",
        "",
        "half a range",
        "inf..1 is empty",
    ];
    assert_eq!(all.len(), reasons.len());
    for (line, (row, why)) in (2..).zip(all.iter().zip(reasons)) {
        assert_eq!((&row["line"], row["kept"]["id"].text().len()), (&line.into(), 1));
        match why {
            "" => assert_eq!(row["outcome"], "all_stand"),
            _ => {
                assert_eq!(row["schema"], "couplet.refused/1");
                tells(row["error"].text(), [why]);
            }
        }
    }
    let cells = table("--keep id", input);
    assert_eq!((&*cells[0]["id"], &*cells[0]["outcome"], &*cells[0]["line"]), ("a", "", "2"));
    assert!(cells[0]["error"].contains("is empty") && cells[10]["error"].is_empty());
}

#[test]
fn without_the_option_a_range_is_refused_with_its_name() {
    let rows = "alpha,mu,eta\n1,0.5..0.6,0.1\n1,1,0.1\n1,1,0.1±1%\n";
    let (told, _) = ended(2, "states", rows);
    let lines: Vec<&str> = told.lines().collect();
    assert!(lines[1].contains("friction 0.5..0.6 is a range: `couplet states --ranges`"), "{told}");
    assert!(lines[3].contains("thickness 0.1±1% is a range") && lines[2].contains("proved"));
    let judged = "alpha,mu,thickness\n1,0.5..0.6,0.1\n";
    let (told, _) = ended(2, "judge - --format csv", judged);
    tells(&told, ["is not judged", "--ranges --keep all"]);
}

/// Texts of a table in degrees with decimal commas, and lists of JSON.
#[test]
fn ranges_are_spelt_as_numbers_are() {
    let exact = &objects("", "alpha,mu,eta\n80.5deg..81.5deg,0.55..0.65,0.1\n")[0];
    let commas = "a;mu;eta\n80,5..81,5;0,55..0,65;0,1\n81±0,5;0,6±0,05;0,1\n";
    for row in objects("--columns a=half_opening:deg,mu,eta", commas) {
        assert_eq!(row["ranges"], exact["ranges"]);
    }
    let lists = "{\"alpha\":[\"80.5deg\",\"81.5deg\"],\"mu\":[0.55,0.65],\"eta\":0.1}\n\
        {\"alpha\":\"81deg+-0.5deg\",\"mu\":[\"0.55\",6.5e-1],\"eta\":[0.1,0.1]}\n\
        {\"alpha\":1,\"mu\":[0.5],\"eta\":0.1}\n{\"alpha\":1,\"mu\":[0.5,0.6,0.7],\"eta\":0.1}\n\
        {\"alpha\":1,\"mu\":[null,0.6],\"eta\":0.1}\n{\"alpha\":1,\"mu\":[[0,1],0.6],\"eta\":0.1}\n\
        {\"alpha\":1,\"mu\":[0.6,0.5],\"eta\":0.1}\n";
    let all = objects("", lists);
    for row in &all[..2] {
        for side in ["lower", "upper"] {
            for name in ["least_thickness", "geometric_safety", "required_friction"] {
                assert_eq!(end(row, name, side), end(exact, name, side));
            }
        }
    }
    for row in &all[2..] {
        assert_eq!(row["schema"], "couplet.refused/1", "{row}");
    }
    assert!(all[6]["error"].text().contains("0.6..0.5 is empty"), "{}", all[6]);
}

/// More rows than are answered at a time come in their order.
#[test]
fn rows_come_in_their_order() {
    let mut input = "alpha,mu,eta,id\n".to_owned();
    for id in 0..1500 {
        let wide = if id % 7 == 0 { "0.2..inf" } else { "0.6..0.61" };
        input += &format!("1..1.{:03},{wide},0.1,{id}\n", id % 999 + 1);
    }
    let cells = table("--keep id --quantity geometric_safety", &input);
    assert_eq!(cells.len(), 1500);
    for (id, row) in cells.iter().enumerate() {
        assert_eq!((row["id"].parse(), row["line"].parse()), (Ok(id), Ok(id + 2)));
    }
}
