//! The published arches: `docs/arches.md` says of every row of `examples/arches.csv` what the program proves.

use crate::program::{Json, json, printed, rows};
use std::collections::BTreeMap;

const PAGE: &str = include_str!("../../../docs/arches.md");
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/arches.csv");

/// A row of a table by the names of its columns.
type Row = BTreeMap<String, String>;

fn given() -> Vec<Row> {
    rows(std::fs::read(TABLE).unwrap())
}

/// The cells of the page's table but the last, which is the source's.
fn page() -> Vec<Vec<&'static str>> {
    let lines = PAGE.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
    let cells = lines.map(|line| line.split(" | ").collect::<Vec<_>>());
    cells.skip(1).map(|cells| cells[..6].to_vec()).collect()
}

fn or_none(cell: &str) -> &str {
    if cell.is_empty() { "none" } else { cell }
}

#[test]
fn the_page_of_published_arches_says_what_is_proved() {
    let command =
        PAGE.lines().find_map(|line| line.strip_prefix("couplet states examples/arches.csv "));
    let options: Vec<&str> = command.unwrap().split(' ').collect();
    let answers = rows(printed([&["states", TABLE], &options[..]].concat()));
    let given = given();
    assert_eq!(given.len(), answers.len());
    let expected = given.iter().zip(&answers).map(|(row, answer)| {
        assert_eq!((&row["name"], &answer["verdict"]), (&answer["name"], &"proved".to_owned()));
        let measures = ["half_opening", "span", "rise", "radius", "thickness"];
        let measures = measures.map(|name| row[name].as_str()).into_iter();
        let measures: Vec<&str> = measures.filter(|cell| !cell.is_empty()).collect();
        let ends =
            ["lower", "upper"].map(|end| answer[&format!("geometric_safety_{end}")].as_str());
        vec![
            row["name"].clone(),
            measures.join(" × "),
            row["friction"].clone(),
            answer["outcome"].replace('_', " "),
            if ends == [""; 2] { "none".to_owned() } else { ends.join(" to ") },
            or_none(&answer["required_friction_upper"]).to_owned(),
        ]
    });
    assert_eq!(page(), expected.collect::<Vec<_>>());
}

#[test]
fn every_published_arch_has_its_source() {
    for row in given() {
        for name in ["work", "authors", "year"] {
            assert!(!row[name].is_empty(), "{}: {name}", row["name"]);
        }
        let read_at: Vec<&str> = row["read_at"].split(' ').collect();
        assert!(read_at.iter().all(|address| address.starts_with("https://")), "{read_at:?}");
    }
}

/// One that is of equal blocks is also asked as such.
#[test]
fn published_blocks_have_the_answer_of_their_arch() {
    let page: BTreeMap<&str, &str> = page().into_iter().map(|cells| (cells[0], cells[3])).collect();
    let of_blocks: Vec<Row> = given().into_iter().filter(|row| !row["blocks"].is_empty()).collect();
    assert_eq!(of_blocks.len(), 7);
    for row in of_blocks {
        let names = ["half_opening", "span", "rise", "radius", "measured_at", "friction"];
        let mut arguments = vec!["assess".to_owned(), "--format".to_owned(), "json".to_owned()];
        for name in names.into_iter().filter(|name| !row[*name].is_empty()) {
            arguments.extend([format!("--{}", name.replace('_', "-")), row[name].clone()]);
        }
        // A range, so that the answer has the words of one.
        let thickness = format!("{0}..{0}", row["thickness"]);
        arguments.extend(["--thickness".into(), thickness]);
        arguments.extend(["--stones".into(), row["blocks"].clone()]);
        let found = json(arguments.iter().map(String::as_str).collect::<Vec<_>>());
        let outcome = found["outcome"].text().replace('_', " ");
        assert_eq!(outcome, page[row["name"].as_str()], "{}", row["name"]);
    }
}
