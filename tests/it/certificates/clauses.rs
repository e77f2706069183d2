//! Each clause of a statement is a claim: a copy that denies it is refused, and nothing but clauses is said.

use super::asymmetric::another_digit;
use super::listed::{original, spoil};
use super::originals::file_alike;
use super::refusals::{MAX_DIGITS, Original, Spoiled, arch};
use super::verdicts::stands_at_the_crown;

/// A clause, a copy that denies it, and what the reason says for which the copy is refused.
type Clause = (String, Spoiled, String);

/// The statement on a certificate that is accepted.
fn statement(original: Original) -> String {
    file_alike(original.0.to_string().as_bytes(), MAX_DIGITS).unwrap().statement()
}

/// The values of a certificate, and their digits.
fn of_values(original: Original) -> Vec<Clause> {
    let Some(values) = original.0["values"].as_array() else { return Vec::new() };
    let clause =
        |(value, (copy, reason)): (&serde_json::Value, (Spoiled, couplet::check::Refusal))| {
            let [name, value] = ["quantity", "value"].map(|key| value[key].as_str().unwrap());
            (format!("{name} = {value}"), copy, reason.to_string())
        };
    let mut clauses: Vec<Clause> = values.iter().zip(another_digit(original)).map(clause).collect();
    if !clauses.is_empty() {
        let digits = original.0["digits"].as_u64().unwrap();
        let rounded = format!("each correctly rounded to {digits} significant digits");
        clauses.push((rounded, original.with("/digits", digits + 1), "values: ".to_owned()));
    }
    clauses
}

/// Every clause is denied by a copy that is refused, and without its clauses nothing is left of a statement.
#[test]
fn each_clause_is_a_claim_and_nothing_else_is_said() {
    let mut faults = Vec::new();
    let sections: Vec<&str> = include_str!("clauses.txt").split("\n# ").skip(2).collect();
    assert_eq!(sections.len(), 8);
    for section in sections {
        let (name, lines) = section.split_once('\n').unwrap();
        let clause = |line: &str| {
            let [words, what, reason] = line.split(" | ").collect::<Vec<_>>()[..] else {
                panic!("{line}")
            };
            let of_root = what.strip_prefix("root ").map(|root| spoil("root", root));
            let copy = of_root.unwrap_or_else(|| spoil(name, what));
            (words.to_owned(), copy, reason.to_owned())
        };
        let lines = lines.lines().filter(|line| !line.is_empty());
        let statement = statement(original(name));
        let mut rest = statement.clone();
        // No weight decides whether an arch slides at every thickness: no copy with another one is false.
        if name == "slides" {
            rest = rest.replacen("milankovitch weight", "", 1);
        }
        for (words, Spoiled { what, bytes }, reason) in
            lines.map(clause).chain(of_values(original(name)))
        {
            assert!(rest.contains(&words), "'{words}' is not said: {statement}");
            rest = rest.replacen(&words, "", 1);
            match file_alike(&bytes, MAX_DIGITS) {
                Err(refusal) if refusal.to_string().contains(&reason) => {}
                other => faults.push(format!("{words}: {what}: {other:?}")),
            }
        }
        let mut left = rest.split([',', ':', ';', ' ']).filter(|word| !word.is_empty());
        assert!(left.all(|word| ["and", "there"].contains(&word)), "'{rest}' is left: {statement}");
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Where a line of thrust comes nearest to the intrados is another joint than where its moment is least.
#[test]
fn a_hint_is_not_said() {
    let expected = "half opening 13/5, friction 2/1, thickness 3/2, milankovitch weight: the arch stands (an admissible \
                    symmetric state exists)";
    assert_eq!(statement(stands_at_the_crown()), expected);
}

/// The short line says from what an arch stands on only behind that thickness.
#[test]
fn only_a_thickness_is_what_an_arch_stands_from() {
    let line = |keep: &[&str]| {
        let copy = arch().changed("values", |copy| {
            let all = copy["values"].as_array_mut().unwrap();
            all.reverse();
            all.retain(|value| keep.contains(&value["quantity"].as_str().unwrap()));
        });
        file_alike(&copy.bytes, MAX_DIGITS).unwrap().summary()
    };
    let both = line(&["thickness", "rotation_joint"]);
    assert!(both.contains("  thickness 0.65024") && both.contains("stands from it on"), "{both}");
    let joint = line(&["rotation_joint"]);
    assert!(joint.contains("  rotation_joint ") && !joint.contains("stands"), "{joint}");
}
