//! `couplet states` of many rows of one half opening, which share its proofs; and of some quantities alone.

use crate::program::{header, lines};
use serde_json::Value;

/// Two half openings of each kind: that rotate, that overturn, that fall whatever the friction.
const OPENINGS: [&str; 6] = ["1/2", "80deg", "2.45", "2.6", "2.62", "2.85"];
const FRICTIONS: [&str; 6] = ["0.1", "0.35", "tan(40deg)", "1.35", "3", "inf"];

/// A table of every half opening with these frictions, the half openings in turn.
fn grid(frictions: &[&str]) -> String {
    let row = |mu: &&str| OPENINGS.map(|alpha| format!("{alpha},{mu}\n")).concat();
    format!("alpha,mu\n{}", frictions.iter().map(row).collect::<String>())
}

/// The answers to a table, without the numbers of their lines.
fn answers(arguments: &str, input: &str) -> Vec<Value> {
    let mut rows = lines(format!("states {arguments}"), input);
    rows.iter_mut().for_each(|row| drop(row.as_object_mut().unwrap().remove("line")));
    rows
}

/// So few rows of a half opening are proved one by one.
#[test]
fn rows_that_share_proofs_are_those_that_each_has_alone() {
    for asked in ["--digits 17", "--digits 30 --quantity thickness,h"] {
        let together = answers(asked, &grid(&FRICTIONS));
        let alone: Vec<Value> =
            FRICTIONS.chunks(2).flat_map(|some| answers(asked, &grid(some))).collect();
        assert_eq!(together.len(), OPENINGS.len() * FRICTIONS.len());
        assert_eq!(together, alone, "{asked}");
        let falls = together.iter().filter(|row| row["can_stand"] == false).count();
        assert!((8..30).contains(&falls), "{falls}");
    }
}

#[test]
fn only_what_is_asked_for_is_there() {
    let input = grid(&["0.1", "1.35"]);
    let (all, some) = (answers("", &input), answers("--quantity eta", &input));
    for (all, some) in all.iter().zip(&some) {
        let same =
            ["half_opening", "friction", "verdict", "can_stand", "mode", "thickness", "reason"];
        for key in same {
            assert_eq!(all[key], some[key], "{key}");
        }
        for key in ["thrust", "sliding_friction", "rotational_friction", "enough"] {
            assert!(some[key].is_null(), "{key}");
        }
    }
    assert!(all.iter().any(|row| row["enough"].is_object()));
    let header = |asked: &str, input: &str| header(format!("states --digits 5 {asked}"), input);
    let names = "weight,half_opening,friction,verdict,can_stand,mode,asymmetric_thickness,thrust,thickness,reason,note,line,error";
    for asked in ["--quantity thrust,thickness", "--quantities h,eta,h"] {
        assert!(header(asked, &input).starts_with(names), "{}", header(asked, &input));
    }
    // Where rows may have a thickness, the least has its own name.
    let names = "weight,half_opening,friction,thickness,verdict,can_stand,stands,mode,asymmetric_thickness,least_thickness,thrust,reason";
    let asked = "--quantity thickness,thrust,least_thickness";
    assert!(header(asked, "alpha,mu,eta\n1,1,\n1,1,0.1\n").starts_with(names));
    let mixed = answers(asked, "{\"alpha\":1,\"mu\":1}\n{\"alpha\":1,\"mu\":1,\"eta\":0.1}\n");
    assert_eq!(mixed[0]["thickness"]["value"], mixed[1]["least_thickness"]["value"]);
    assert!(mixed[0]["thickness"].is_object() && mixed[1]["geometric_safety"].is_null());
}
