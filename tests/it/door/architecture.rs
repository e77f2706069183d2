//! The picture of the rooms in `docs/architecture.md` is drawn from the code.

use crate::house::{is_made, read};
use crate::rooms::{ROOMS, floors, room, rooms_used, sources};
use std::collections::BTreeSet;
use std::fs;

const BEGIN: &str = "<!-- rooms: drawn by `make snapshots` -->\n";
const END: &str = "<!-- end -->\n";

/// A row for each room: ■ itself, □ a room that it uses, · one that it does without.
fn picture() -> String {
    let mut lines = String::from("```text\n");
    for (level, name) in ROOMS.iter().enumerate() {
        let files = sources(&room(name));
        let used: BTreeSet<String> = files.iter().flat_map(|path| rooms_used(path)).collect();
        let uses = |other: &str| used.contains(other);
        let marks = ROOMS[..level].iter().map(|other| if uses(other) { "□ " } else { "· " });
        let marks: String = marks.chain(["■ "]).collect();
        let width = 2 * ROOMS.len();
        let line = format!("{name:<11}{marks:<width$}  {}", home(name));
        lines += &format!("{}\n", line.trim_end());
    }
    lines + "```\n\n" + &table()
}

/// The crate that a room belongs to.
fn home(name: &str) -> String {
    let place = room(name);
    let floor = floors().into_iter().find(|floor| place.starts_with(floor)).unwrap();
    let manifest = fs::read_to_string(floor.with_file_name("Cargo.toml")).unwrap();
    manifest.split("\nname = \"").nth(1).unwrap().split('"').next().unwrap().to_owned()
}

/// What each room says of itself first.
fn table() -> String {
    let mut lines = String::from("| room | what is in it |\n|---|---|\n");
    for name in ROOMS {
        let place = room(name);
        let fronts = [place.join("mod.rs"), place.join("lib.rs")];
        let front = fronts.into_iter().find(|front| front.exists()).unwrap_or(place);
        let file = fs::read_to_string(front).unwrap();
        let words = file.lines().map_while(|line| line.strip_prefix("//! "));
        let words = words.collect::<Vec<_>>().join(" ");
        let words = words.replace("[`", "`").replace("`]", "`");
        let first = words.split(". ").next().unwrap().trim_end_matches('.');
        lines += &format!("| `{name}` | {first} |\n");
    }
    lines
}

#[test]
fn the_picture_of_the_rooms_is_drawn_from_the_code() {
    let page = read("docs/architecture.md");
    let (before, rest) = page.split_once(BEGIN).unwrap();
    let (_, after) = rest.split_once(END).unwrap();
    is_made("docs/architecture.md", &format!("{before}{BEGIN}{}{END}{after}", picture()));
}

/// Each name of the table of symbols is in the code.
#[test]
fn every_symbol_has_its_name() {
    let page = include_str!("../../../docs/architecture.md");
    let table = page.split("| paper | code | meaning |\n").nth(1).unwrap();
    let rows: Vec<&str> = table.lines().skip(1).take_while(|line| line.starts_with('|')).collect();
    assert!(rows.len() > 20);
    // Names are also what stands between quotes.
    let text = |path| {
        let text = fs::read_to_string(path).unwrap();
        let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        lines.collect::<Vec<_>>().join("\n")
    };
    let texts = ["number", "arch", "problem"]
        .map(|name| sources(&room(name)).into_iter().map(text).collect::<Vec<_>>().join("\n"));
    let is_there = |name: &str| {
        let name = name.rsplit("::").next().unwrap();
        let words =
            |text: &str| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|w| w == name);
        texts.iter().any(|text| words(text))
    };
    for row in rows {
        let names = row.split('|').skip(2).flat_map(|cell| cell.split('`').skip(1).step_by(2));
        for name in names.filter(|name| !["inf", "r", "s"].contains(name)) {
            assert!(is_there(name), "{name}: {row}");
        }
    }
}
