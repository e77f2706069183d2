//! Every question of `tests/questions.txt` and `tests/ranges.txt` by the command, in a scene and as a row: one answer,
//! and one sentence where there is none. The tests of Python, of C and of the page ask those of the first.

use crate::program::{Scratch, couplet, fed, text};
use serde_json::Value;

const QUESTIONS: &str = include_str!("../questions.txt");
const RANGES: &str = include_str!("../ranges.txt");

/// A question, whether it makes sense, and the fields of its arch.
struct Asked {
    question: &'static str,
    makes_sense: bool,
    fields: Vec<(&'static str, &'static str)>,
}

fn all(questions: &'static str) -> Vec<Asked> {
    let lines = questions.lines().filter(|line| !line.starts_with('#'));
    let asked = |line: &'static str| {
        let mut words = line.strip_prefix("! ").unwrap_or(line).split(' ');
        let question = words.next().unwrap();
        let fields = words.map(|pair| pair.split_once('=').unwrap()).collect();
        Asked { question, makes_sense: !line.starts_with('!'), fields }
    };
    let all: Vec<Asked> = lines.map(asked).collect();
    assert!(all.iter().any(|of| of.makes_sense) && all.iter().any(|of| !of.makes_sense));
    all
}

/// A sentence of the command in the words of keys, without the example.
fn in_keys(sentence: &str) -> String {
    let sentence = sentence.trim().strip_prefix("couplet: ").unwrap();
    let sentence = sentence.split("; for example").next().unwrap();
    let word = |word: &str| match word.strip_prefix("--").or(word.strip_prefix("(or --")) {
        Some(option) if word.starts_with('(') => format!("(or {}", option.replace('-', "_")),
        Some(option) => option.replace('-', "_"),
        None => word.to_owned(),
    };
    sentence.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

impl Asked {
    /// What the command says: its JSON, or the sentence in which it refuses.
    fn by_command(&self) -> Result<Value, String> {
        let options = self
            .fields
            .iter()
            .flat_map(|(name, text)| [format!("--{}", name.replace('_', "-")), (*text).to_owned()]);
        let options: Vec<String> = options.collect();
        let mut words = vec![self.question, "--digits", "12", "--format", "json"];
        words.extend(options.iter().map(String::as_str));
        let output = couplet(&words);
        match output.status.code() {
            Some(0) => {
                let found: Value = serde_json::from_str(&text(&output.stdout)).unwrap();
                let note = found["note"].as_str().map(|note| format!("couplet: {note}\n"));
                assert_eq!(text(&output.stderr), note.unwrap_or_default(), "{words:?}");
                Ok(found)
            }
            Some(2) => Err(in_keys(&text(&output.stderr))),
            code => panic!("{words:?}: {code:?}"),
        }
    }

    fn by_scene(&self, scratch: &Scratch) -> Result<Value, String> {
        let keys = self.fields.iter().map(|(name, text)| format!("{name} = \"{text}\"\n"));
        let keys: String = keys.collect();
        let head = "schema = \"couplet.scene/1\"\n[[arches]]\n";
        scratch.write("scene.toml", format!("{head}{keys}digits = 12\nformat = \"json\"\n"));
        let output = couplet(["run", &scratch.path("scene.toml")]);
        if output.status.code() == Some(0) {
            let found: Value = serde_json::from_str(&text(&output.stdout)).unwrap();
            let found = found.get("arches").map_or(&found, |arches| &arches[0]).clone();
            let remarks = text(&output.stderr);
            let note = found["note"].as_str();
            assert_eq!(note.is_some(), !remarks.is_empty(), "{remarks}");
            assert!(note.is_none_or(|note| remarks.ends_with(&format!(": {note}\n"))), "{remarks}");
            return Ok(found);
        }
        assert_eq!(output.status.code(), Some(2), "{keys}");
        let faults = text(&output.stderr);
        let fault = faults.lines().next().unwrap().splitn(4, ':').nth(3).unwrap();
        Err(fault.trim().to_owned())
    }

    fn by_row(&self, option: &str) -> Result<Value, String> {
        let [names, texts] = [0, 1].map(|k| {
            let cells = self.fields.iter().map(|pair| if k == 0 { pair.0 } else { pair.1 });
            cells.collect::<Vec<_>>().join(",")
        });
        let table = format!("{names}\n{texts}\n");
        let output = fed(format!("states --digits 12 --format jsonl {option}"), table);
        if output.stdout.is_empty() {
            let sentence = text(&output.stderr);
            let sentence = sentence.trim().strip_prefix("couplet: ").unwrap();
            return Err(sentence.split("; its columns are").next().unwrap().to_owned());
        }
        let mut row: Value = serde_json::from_slice(&output.stdout).unwrap();
        row.as_object_mut().unwrap().remove("line");
        match row["error"].as_str() {
            Some(error) => Err(error.to_owned()),
            None => Ok(row),
        }
    }
}

/// What two answers have in common is the same, and that is the answer.
fn agree(one: &Value, other: &Value, door: &str) {
    let mut shared = 0;
    assert_eq!(one.get("note"), other.get("note"), "{door}");
    for (key, value) in one.as_object().unwrap() {
        if let Some(found) = other.get(key).filter(|_| key != "asked") {
            assert_eq!(found, value, "{door}: {key}");
            shared += 1;
        }
    }
    assert!(shared >= 12, "{door}: {shared}");
}

#[test]
fn every_door_answers_alike() {
    every_door_answers(QUESTIONS, "");
}

#[test]
fn every_door_answers_alike_about_ranges() {
    every_door_answers(RANGES, "--ranges");
}

/// The option is what a table needs that has such questions.
fn every_door_answers(questions: &'static str, option: &str) {
    let scratch = Scratch::new();
    for asked in all(questions) {
        let command = asked.by_command();
        let doors = [("scene", asked.by_scene(&scratch)), ("row", asked.by_row(option))];
        assert_eq!(command.is_ok(), asked.makes_sense, "{:?}", asked.fields);
        for (door, answer) in doors {
            let place = format!("{door}: {} {:?}", asked.question, asked.fields);
            match (&command, &answer) {
                (Ok(one), Ok(other)) if one["ranges"].is_array() => {
                    assert_eq!(one, other, "{place}")
                }
                (Ok(one), Ok(other)) => agree(one, other, &place),
                // Of a column that is missing the file is told.
                (Err(one), Err(other)) if other.contains("has no column") => {
                    assert!(one.contains("missing"), "{place}: {one}");
                    assert!(one.starts_with(other.split('\'').nth(1).unwrap()), "{place}: {other}");
                }
                (Err(one), Err(other)) => assert_eq!(one, other, "{place}"),
                _ => panic!("{place}: {command:?} {answer:?}"),
            }
        }
    }
}
