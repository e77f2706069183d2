//! `docs/questions.md`: which question is asked where, and what an arch may be given by, made of the questions
//! themselves.

use super::manual::commands;
use crate::house::{is_made, read};
use couplet::ask::{ArchQuestion, Field};
use couplet::cli::doors;
use couplet::scene::ItemKind;

/// What a question is, and for the command, a scene, a row, Python, C and the page its name there, or behind `!` why it
/// has none.
const QUESTIONS: [[&str; 7]; 18] = [
    ["an arch at its least thickness", "state", "arches", "states", "state", "couplet_arch", "yes"],
    ["an arch of a thickness", "assess", "arches", "states", "assess", "couplet_arch", "yes"],
    ["every arch between measured ends", "assess", "arches", RANGES, "assess", "couplet_arch", ONE],
    ["an arch of stones", "voussoirs", STONES, STONES, "voussoirs", NO_C, STONES],
    ["a tilted arch", "assess", TILT, TILT, "tilt", NO_C, TILT],
    ["a half opening, a friction, a boundary", "find", FIND, FIND, "find", "couplet_find", FIND],
    ["an equation of the paper", "equation", EQUATION, EQUATION, "equation", NO_C, EQUATION],
    ["all solutions of (19)", "complementarity", COSTS, COSTS, COSTS, NO_C, COSTS],
    ["many arches, one a row", "states", "arches", "states", "states", "couplet_states", ONE],
    ["grids and samples of arches", "sweep", OWN_PLAN, "!rows are given", "sweep", NO_C, ONE],
    ["somebody else's results", "judge", TABLE, "!the judge reads rows itself", "judge", NO_C, ONE],
    ["a map of the modes", "map", "map", PICTURE, "map", NO_C, "yes"],
    ["a drawing of an arch", "draw", "drawing", PICTURE, "draw", NO_C, "yes"],
    ["a figure of the paper", "figure", "figure", PICTURE, "figure", NO_C, ONE],
    ["landmark constants", "constants", "constants", LANDMARK, "constants", CONSTANT, "yes"],
    ["a certificate", "certify", OWN_FILE, LANDMARK, "certify", "couplet_certify_arch", "yes"],
    ["a check of certificates", "check", TRUST, LANDMARK, "check", "couplet_check", "yes"],
    ["claims of the paper", "prove", "claims", LANDMARK, "prove", NO_C, "!its proofs take seconds"],
];
const CONSTANT: &str = "couplet_constant";
const OWN_FILE: &str = "!a certificate is a file of its own";
const TRUST: &str = "!a checker trusts no scene";
const STONES: &str = "!an answer of stones has columns of its own";
const RANGES: &str = "states --ranges";
const TILT: &str = "!the halves of a tilted arch are told apart";
const FIND: &str = "!an arch is given whole there";
const EQUATION: &str = "!an equation is looked at, not tabulated";
const COSTS: &str = "!it takes seconds: for a shell";
const NO_C: &str = "!the library for C is of values alone";
const ONE: &str = "!the page is of one arch";
const OWN_PLAN: &str = "!a sweep has a plan of its own";
const TABLE: &str = "!it needs a table";
const PICTURE: &str = "!a row has values";
const LANDMARK: &str = "!a row is an arch";

const DOORS: [&str; 7] = ["question", "command", "scene", "row of", "Python", "C", "page"];

/// Questions that read an arch.
const OF_AN_ARCH: [(&str, &ArchQuestion); 8] = [
    ("state", &doors::STATE),
    ("assess", &doors::ASSESS),
    ("voussoirs", &doors::VOUSSOIRS),
    ("find", &couplet::door::find::QUESTION),
    ("complementarity", &doors::COMPLEMENTARITY),
    ("draw", &doors::DRAW),
    ("certify state", &doors::CERTIFY_STATE),
    ("certify arch", &doors::CERTIFY_ARCH),
];

fn row(cells: impl IntoIterator<Item = String>) -> String {
    format!("| {} |\n", cells.into_iter().collect::<Vec<_>>().join(" | "))
}

/// Why a door does not have something: each reason once, by number.
#[derive(Default)]
struct Reasons(Vec<String>);

impl Reasons {
    fn no(&mut self, why: &str) -> String {
        let place = self.0.iter().position(|known| known == why).unwrap_or_else(|| {
            self.0.push(why.to_owned());
            self.0.len() - 1
        });
        format!("({})", place + 1)
    }

    fn listed(self) -> String {
        let lines = self.0.iter().enumerate().map(|(place, why)| format!("{}. {why}\n", place + 1));
        format!("\n## Why not\n\n{}", lines.collect::<String>())
    }
}

fn page() -> String {
    let mut page = String::from(
        "# Questions\n\nWhich question is asked where. A number says why a door does not have one, below.\n\n",
    );
    let mut reasons = Reasons::default();
    let mut cell = |(door, text): (usize, &&str)| match (door, text.strip_prefix('!')) {
        (_, Some(why)) => reasons.no(why),
        (0, None) => (*text).to_owned(),
        (2, None) => format!("`[[{text}]]`"),
        (4, None) => format!("`couplet.{text}`"),
        (6, None) => "yes".to_owned(),
        (_, None) => format!("`{text}`"),
    };
    page += &row(DOORS.map(str::to_owned));
    page += "|---|---|---|---|---|---|---|\n";
    for question in &QUESTIONS {
        page += &row(question.iter().enumerate().map(&mut cell));
    }
    page += "\n## What an arch may be given by\n\nThe same names everywhere: options of the command (`--half-opening`), \
             keys of a scene and columns of a table (`half_opening`),\narguments in Python, fields in C.\n\n";
    page +=
        &row(std::iter::once("question".to_owned()).chain(OF_AN_ARCH.map(|of| of.0.to_owned())));
    page += &format!("|{}\n", "---|".repeat(OF_AN_ARCH.len() + 1));
    let mut rows: Vec<(String, [String; 8])> = Vec::new();
    for &field in Field::ALL {
        let letter = field.letter().map_or(String::new(), |letter| format!(", `{letter}`"));
        let name = format!("`{}`{letter}", field.name());
        let reasons = &mut reasons;
        let cell = |(_, question): (&str, &ArchQuestion)| {
            // A depth is for forces, as a density is.
            let field = if field == Field::Depth { Field::Density } else { field };
            let why = question.refuses.iter().find(|(of, _)| *of == field);
            match why {
                Some((_, why)) => reasons.no(why),
                None if question.needs.contains(&field) => "needed".to_owned(),
                None => "yes".to_owned(),
            }
        };
        let cells = OF_AN_ARCH.map(cell);
        match rows.last_mut() {
            Some((names, same)) if *same == cells => *names += &format!("; {name}"),
            _ => rows.push((name, cells)),
        }
    }
    page.extend(rows.into_iter().map(|(name, cells)| row([name].into_iter().chain(cells))));
    page + &reasons.listed()
}

#[test]
fn the_page_of_questions_is_made_of_them() {
    is_made("docs/questions.md", &page());
}

/// Each name is that of something, and no command is left out.
#[test]
fn every_question_is_where_it_is_said_to_be() {
    let (python, header) = (read("python/couplet/__init__.py"), read("c/include/couplet_c.h"));
    let commands = commands();
    for question in &QUESTIONS {
        let named = |door: usize| Some(question[door]).filter(|name| !name.starts_with('!'));
        let is_command = |name: &str| commands.iter().any(|of| of == name);
        assert!(named(1).is_some_and(is_command), "{question:?}");
        let scene = |name: &str| ItemKind::ALL.iter().any(|kind| kind.name() == name);
        assert!(named(2).is_none_or(scene), "{question:?}");
        let imports = |name: &str| [format!("\"{name}\","), format!("import {name} as {name}")];
        let in_python = |name: &str| imports(name).iter().any(|words| python.contains(words));
        assert!(named(4).is_none_or(in_python), "{question:?}");
        let in_c = |name: &str| header.contains(&format!("int {name}("));
        assert!(named(5).is_none_or(in_c), "{question:?}");
    }
    let others = ["sample", "audit", "run", "study", "completions", "man"];
    for command in commands.iter().filter(|name| !others.contains(&name.as_str())) {
        assert!(QUESTIONS.iter().any(|question| question[1] == command), "{command}");
    }
}
