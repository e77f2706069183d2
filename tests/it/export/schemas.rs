//! Every JSON that is written is as its schema in `docs/schemas/` says, and nothing more.

use crate::arches::tangent_of_one_half;
use crate::house::{certificates, files, read};
use crate::program::{Json, Scratch, couplet, fed, object, printed, text};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fs;

/// Schemas that belong to what a script writes, and are held against it where that is run.
const OF_SCRIPTS: [&str; 2] = ["theorem_map-1.json", "reference_index-1.json"];

/// Whether a value is of a type of JSON Schema.
fn is_of(value: &Value, name: &str) -> bool {
    match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_u64() || value.is_i64(),
        "number" => value.is_number(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("{other} is no type"),
    }
}

/// The words of JSON Schema that our schemas use.
const WORDS: &str = "$schema $id $defs $ref title description type properties required additionalProperties items enum \
                     const anyOf";

/// What is wrong with a value, if anything; a key that no schema names is.
fn fault(schema: &Value, root: &Value, value: &Value) -> Option<String> {
    if schema == &Value::Bool(true) {
        return None;
    }
    for word in schema.as_object().unwrap().keys() {
        assert!(WORDS.split(' ').any(|known| known == word), "{word} is not understood here");
    }
    if let Some(name) = schema["$ref"].as_str() {
        let definition = root.pointer(name.strip_prefix('#').unwrap());
        return fault(definition.expect("a definition"), root, value);
    }
    if let Some(choices) = schema["anyOf"].as_array() {
        let faults = choices.iter().map(|choice| fault(choice, root, value));
        let faults: Option<Vec<String>> = faults.collect();
        return faults.map(|faults| faults.join(" | "));
    }
    let names = match &schema["type"] {
        Value::String(name) => vec![name.as_str()],
        Value::Array(names) => names.iter().map(|name| name.text()).collect(),
        _ => vec![],
    };
    if !names.is_empty() && !names.iter().any(|name| is_of(value, name)) {
        return Some(format!("{value} is not {names:?}"));
    }
    let allowed = schema["enum"].as_array();
    if allowed.is_some_and(|allowed| !allowed.contains(value)) {
        return Some(format!("{value} is not one of {allowed:?}"));
    }
    if schema.get("const").is_some_and(|constant| constant != value) {
        return Some(format!("{value} is not {}", schema["const"]));
    }
    match value {
        Value::Array(list) if schema.get("items").is_some() => {
            list.iter().find_map(|value| fault(&schema["items"], root, value))
        }
        Value::Object(entries) => fault_of_object(schema, root, entries),
        _ => None,
    }
}

fn fault_of_object(schema: &Value, root: &Value, entries: &Map<String, Value>) -> Option<String> {
    let required = schema["required"].as_array().into_iter().flatten();
    let mut missing = required.filter(|name| !entries.contains_key(name.text()));
    if let Some(name) = missing.next() {
        return Some(format!("{name} is missing"));
    }
    entries.iter().find_map(|(name, value)| {
        let described = schema["properties"].get(name).or(schema.get("additionalProperties"));
        match described {
            Some(described) => {
                fault(described, root, value).map(|fault| format!("{name}: {fault}"))
            }
            None => Some(format!("{name} is not described")),
        }
    })
}

/// Holds a value against the schema that it names.
pub(crate) fn check(value: &Value, seen: &mut BTreeSet<String>) {
    let name = value["schema"].as_str().unwrap_or_else(|| panic!("no schema: {value}"));
    let file = name.strip_prefix("couplet.").unwrap().replace('/', "-") + ".json";
    let schema: Value = serde_json::from_str(&read(&format!("docs/schemas/{file}"))).unwrap();
    assert_eq!(schema["$id"], name, "{file}");
    assert_eq!(fault(&schema, &schema, value), None, "{name}: {value}");
    seen.insert(file);
}

const QUERIES: &str = "alpha,mu,eta,id\n1.5,0.6,0.3,a\n1.5,0.6,,b\n90deg,0.2,,c\n90deg,0.2,0.1,d\nx,1,,e\n\
    1.5,inf,1.9,f\n2.62,inf,,g\n1e-3,1e400,,h\n";

const RESULTS: &str = "weight,alpha,mu,eta,mode,sliding_joint\nheyman,pi/2,0.38,0.122,rrr,none\n\
    heyman,pi/2,0.3958320381380695,0.1,rrr,1\nheyman,pi/2,0.3,,none,\nheyman,x,1,1,,\nheyman,1,1,,,\n\
    milankovitch,1,1,inf,,\n";

/// The records of sweeps of every kind; none without the feature.
fn sweeps(scratch: &Scratch) -> Vec<String> {
    scratch.write("states.csv", "alpha,mu\n1,1\n");
    scratch.write("states.jsonl", "{\"alpha\": 1, \"mu\": 1}\n");
    let plans = [
        "weight = \"both\"\n[grid]\nalpha = [1, 2]\nphi = \"35deg\"\n",
        "[sample]\ncount = 2\n",
        "[data]\nfiles = [\"states.csv\", \"states.jsonl\", \"none.csv\"]\n",
    ];
    for plan in plans.iter().filter(|_| cfg!(feature = "parquet")) {
        scratch.write("plan.toml", format!("schema = \"couplet.sweep/1\"\n{plan}"));
        couplet(["sweep", &scratch.path("plan.toml"), "-o", &scratch.path("sweeps")]);
    }
    let mut names = scratch.files("sweeps");
    names.retain(|name| name.ends_with(".json"));
    assert!(names.len() == 3 || !cfg!(feature = "parquet"), "{names:?}");
    names.iter().map(|name| scratch.read(&format!("sweeps/{name}"))).collect()
}

#[test]
fn what_is_written_is_as_the_schemas_say() {
    let mut seen = BTreeSet::new();
    let scratch = Scratch::new();
    let scene = "schema = \"couplet.scene/1\"\n[[arches]]\nhalf_opening = 1\nfriction = [1, \"inf\"]\n\
        output = \"a.json\"\n[[arches]]\nhalf_opening = \"80deg\"\nfriction = 1\nthickness = 0.1\n\
        output = \"b.json\"\n[[arches]]\nmu = 0.6\neta = \"0.1..0.12\"\n\
        alpha = { from = 1, to = 1.5, boxes = 2 }\noutput = \"c.json\"\n[[arches]]\nmu = \"0.6..inf\"\n\
        alpha = { from = 1, to = 3, boxes = 2 }\noutput = \"d.json\"\n";
    scratch.write("scene.toml", scene);
    let out = scratch.path("out");
    printed(["run", &scratch.path("scene.toml"), "-o", &out]);
    let mut documents =
        ["a", "b", "c", "d"].map(|name| scratch.read(&format!("out/{name}.json"))).to_vec();
    documents.push(scratch.read("out/couplet-run.json"));
    documents.extend(sweeps(&scratch));
    let stored = certificates(["asymmetric", "constants", "states", "surveys"]);
    documents.extend(stored.into_iter().map(|path| fs::read_to_string(path).unwrap()));
    let asked = include_str!("schemas.txt").lines().skip(1);
    let open = format!("assess --alpha 1/2 --mu {} --eta 0.6", tangent_of_one_half());
    for line in asked.chain([open.as_str()]) {
        documents.push(text(&couplet(format!("{line} --format json")).stdout));
    }
    documents.push(text(&fed("judge - --format json", RESULTS).stdout));
    let mut lines = String::new();
    for digits in ["4", "17"] {
        let states = format!("states --format jsonl --keep id --digits {digits}");
        lines += &text(&fed(states, QUERIES).stdout);
    }
    let ranges = QUERIES.replace("0.6,0.3", "0.5..inf,0.3±10%");
    lines += &text(&fed("states --ranges --format jsonl --keep id", ranges).stdout);
    lines += &text(&fed("judge - --format jsonl", RESULTS).stdout);
    let judged = fed("states --format jsonl", QUERIES);
    lines += &text(&fed("judge - --format jsonl", &judged.stdout).stdout);
    lines += &printed("sample --hard --count 60 --format jsonl");
    for question in object("sample --assemblies --count 16").list() {
        check(question, &mut seen);
    }
    for document in documents {
        check(&serde_json::from_str(&document).unwrap(), &mut seen);
    }
    for line in lines.lines() {
        check(&serde_json::from_str(line).unwrap(), &mut seen);
    }
    let all = files("docs/schemas", "json").into_iter();
    let all = all.map(|path| path.file_name().unwrap().to_str().unwrap().to_owned());
    let all = all.filter(|name| cfg!(feature = "parquet") || name != "sweep-1.json");
    let all = all.filter(|name| !OF_SCRIPTS.contains(&name.as_str()));
    assert_eq!(seen, all.collect(), "every schema was held against something");
}

#[test]
fn the_schemas_refuse_what_they_do_not_describe() {
    let schema: Value =
        serde_json::from_str(include_str!("../../../docs/schemas/refused-1.json")).unwrap();
    let found = |value: &str| fault(&schema, &schema, &serde_json::from_str(value).unwrap());
    let good = r#"{"schema":"couplet.refused/1","line":1,"error":"x"}"#;
    assert_eq!(found(good), None);
    for (from, to) in
        [("\"line\":1", "\"line\":1.5"), (",\"error\":\"x\"", ""), ("/1", "/2"), ("\"x\"", "null")]
    {
        assert!(found(&good.replace(from, to)).is_some(), "{to}");
    }
    assert!(found(&good.replace('{', "{\"more\":1,")).unwrap().contains("more is not described"));
}
