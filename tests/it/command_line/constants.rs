//! `couplet constants` and `couplet audit`.

use super::exact;
use crate::program::{Json, object, printed, says, tells};
use couplet::number::Decimal;
use serde_json::{Value, json};

fn entry<'a>(file: &'a Value, list: &str, keys: &[(&str, &str)]) -> &'a Value {
    let all = file[list].list();
    all.iter().find(|e| keys.iter().all(|(key, value)| e[*key] == **value)).unwrap()
}

#[test]
fn the_default_table_has_every_landmark_proved() {
    let text = printed("constants");
    assert_eq!(text.matches("proved: one solution").count(), 14);
    tells(
        &text,
        [
            "0.618318241074323446374432256517",
            "0.679604732098885514787534896210",
            "= 2(2√3−3)",
            "= √3−1",
            "= 2/3",
            "inf",
        ],
    );
}

#[test]
fn json_is_stable_and_its_bounds_enclose() {
    let file = object("constants --digits 25");
    assert_eq!(file["schema"], "couplet.constants/1");
    assert_eq!(file["digits"], 25);
    let more = object("constants --digits 60");
    let [few, many] = [&file, &more].map(|file| file["constants"].list());
    assert_eq!([few.len(), many.len()], [2 * (6 * 13 + 8); 2]);
    for (few, many) in few.iter().zip(many) {
        for key in ["weight", "landmark", "quantity", "exact"] {
            assert_eq!(few[key], many[key]);
        }
        if few["value"] == "inf" {
            assert_eq!(few["exact"], "inf");
            continue;
        }
        let [lower, value, upper] = ["lower", "value", "upper"].map(|end| exact(&few[end]));
        let truth = exact(&many["value"]);
        assert!(lower <= truth && truth <= upper, "{few} {many}");
        let unit = upper.clone() - &lower;
        assert!((value.clone() - truth).abs() * 2 <= unit, "correctly rounded: {few}");
        assert!(value == lower || value == upper);
        let digits = few["value"].text().parse::<Decimal>().unwrap().significant_digits();
        assert!(digits == 25 || few["exact"] != Value::Null, "{few}");
    }
    for proof in file["proofs"].list() {
        assert_eq!(proof["verdict"], "proved");
        for radius in proof["box_relative_radius"].as_object().unwrap().values() {
            assert!(radius.number() > 1e-3, "a macroscopic box: {proof}");
        }
    }
}

#[test]
fn landmarks_and_weights_are_selected() {
    let file = object("constants T B --weight milankovitch --digits 1000");
    let constants = file["constants"].list();
    assert_eq!(constants.len(), 26);
    let thickness = entry(&file, "constants", &[("landmark", "T"), ("quantity", "thickness")]);
    let text = thickness["value"].text();
    assert!(text.starts_with("0.61831824107432344637443225651706527335"));
    assert_eq!(text.len(), 1002);
    let border = entry(&file, "constants", &[("landmark", "B"), ("quantity", "thickness")]);
    assert_eq!((&border["value"], &border["exact"]), (&"2".into(), &"2".into()));
}

#[test]
fn csv_has_a_row_for_each_constant() {
    let text = printed("constants L --digits 5 --format csv");
    assert_eq!(text.lines().count(), 27);
    assert!(text.starts_with("weight,landmark,quantity,value,lower,upper,exact\n"));
    assert!(text.contains("heyman,L,half_opening,2.7865,2.7864,2.7865,\n"), "{text}");
    assert!(text.contains("milankovitch,L,A,0.66667,0.66666,0.66667,2/3\n"), "{text}");
}

#[test]
fn the_audit_finds_what_the_tables_got_wrong() {
    let file = object("audit");
    assert_eq!(file["schema"], "couplet.audit/2");
    let number = |place, landmark, quantity| {
        entry(&file, "printed", &[("place", place), ("landmark", landmark), ("quantity", quantity)])
    };
    let thickness = number("Table 1", "T", "thickness");
    let expected = json!({
        "printed": "0.6796047320988860", "error_units": "4.85", "correct_digits": 15,
        "verdict": "wrong",
    });
    says(thickness, expected);
    assert_eq!(number("Table 2", "J", "sliding_joint")["verdict"], "correctly rounded");
    assert_eq!(number("Table 1", "T", "friction")["verdict"], "faithful");
    assert_eq!(number("Table 4", "l", "A")["verdict"], "correctly rounded");
    let comparison = |landmark, quantity| {
        entry(&file, "comparisons", &[("landmark", landmark), ("quantity", quantity)])["verdict"]
            .clone()
    };
    assert_eq!(comparison("T", "friction"), "proved");
    assert_eq!(comparison("B", "thickness"), "refuted", "both are 2");
}
