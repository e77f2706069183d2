//! Every JSON that is written is as its schema in `docs/schemas/` says, and nothing more.

use crate::program::{Scratch, couplet, fed, object, printed, text};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/schemas")
}

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
        Value::Array(names) => names.iter().map(|name| name.as_str().unwrap()).collect(),
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
    let mut missing = required.filter(|name| !entries.contains_key(name.as_str().unwrap()));
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
    let schema = fs::read_to_string(folder().join(&file)).unwrap_or_else(|_| panic!("{file}"));
    let schema: Value = serde_json::from_str(&schema).unwrap();
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
    for folder in ["asymmetric", "constants", "states", "surveys"] {
        let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs").join(folder);
        let paths = fs::read_dir(stored).unwrap().map(|entry| entry.unwrap().path());
        let paths = paths.filter(|path| path.extension().is_some_and(|end| end == "json"));
        documents.extend(paths.map(|path| fs::read_to_string(path).unwrap()));
    }
    // Nearer to the tangent of the half opening than can be told.
    let open = rug::Float::with_val(40_000, 0.5).tan().to_string_radix(10, Some(11_000));
    for line in [
        "state --alpha pi/2 --mu 0.3958320381380695 --weight heyman",
        "state --alpha 1 --mu 0",
        "state --alpha 1 --mu 1 --digits 17",
        "assess --alpha 80deg --mu 1 --eta 0.2 --digits 17",
        "find half-opening --mu 0.6 --eta 0.15",
        "find half-opening --mu 0",
        "find boundary rrs/ss --alpha 2.5 --digits 17",
        "find boundary rrs/ss --mu 1",
        &format!("assess --alpha 1/2 --mu {open} --eta 0.6"),
        "state --at T",
        "map --weight both --tolerance 1e-3",
        "map --alpha 80deg,2.58",
        "map point sliding --at 1.2 --digits 5",
        "map difference --tolerance 1e-2",
        "voussoirs --alpha pi/2 --mu 0.35 --stones 20",
        "assess --alpha pi/2 --mu 0.4 --eta 0.15 --tilt 0.1 --digits 6",
        "assess --alpha 1/2 --mu 2 --eta 0.7 --tilt 5deg",
        "draw --span 33ft --rise 10ft --eta 2ft --mu 1",
        "draw --alpha pi/2 --mu 0.4 --eta 0.15 --tilt 0.1 --stones 9",
        "draw --alpha 80deg --mu 0.6 --eta 0.1..0.12",
        "voussoirs --joints 0,1 --mu 1/9",
        "voussoirs --alpha 80deg --mu inf --stones 10 --eta 1.9",
        "voussoirs --alpha pi/2 --mu 0.6 --stones 11 --eta 0.1",
        "voussoirs --alpha pi/2 --mu 0.4 --stones 11 --eta 0.15 --tilt 0.05",
        "complementarity --alpha 2.3 --mu 1.07",
        "complementarity --alpha 2.5 --mu 0.1",
        "complementarity --alpha 2.3 --mu 1.05 --stones 8",
        "complementarity --alpha 1 --mu 0.1 --stones 5",
        "complementarity --alpha 1 --mu inf --stones 2",
        "complementarity --alpha 1 --mu inf --stones 2 --eta 1.2",
        "complementarity --alpha 2.3 --mu 1.05 --stones 8 --half --eta least",
        "complementarity --alpha 2.3 --mu 1.05 --eta 0.55 --stones 6",
        "complementarity --alpha 2.3 --mu 1.05 --eta 0.3 --stones 6",
        "complementarity --alpha 1 --mu 2 --stones 3 --thickness least",
        "complementarity --alpha 2.2 --mu 2 --stones 8 --thickness 1.83",
        "complementarity --weight heyman --alpha 1.066 --mu 0.303 --stones 5 --thickness 1.096",
        "state --beta 1.0",
        "state --beta 0.66 --mu 1.6",
        "state --beta 1.2 --weight heyman",
        "state --thrust 0.01 --mu 0.6",
        "state --opening-variable 0.7",
        "state --eta 0.15 --mu 0.6",
        "equation 4 --alpha 1 --eta 0.1",
        "equation 16 --eta 1",
        "equation 7 --beta 1.0 --weight heyman",
        "equation 7 --beta 1.2",
        "equation 8 --beta 3 --weight heyman",
        "equation 9 --beta 57deg --weight milankovitch",
        "equation 12 --beta 1.2",
        "complementarity --alpha 2.21 --branch",
        "complementarity --alpha 2 --branch",
        "map --asymmetric --tolerance 1e-2",
        "state --span=10m --rise=3m --mu=0.6",
        "state --radius=5m --alpha=1 --mu=0.1",
        "assess --span=10m --rise=3m --mu=0.6 --eta=60cm",
        "state --alpha=1.4..2.6 --mu=0.2..inf",
        "assess --alpha=80deg±1deg --mu=0.6±10% --eta=0.12",
        "find half-opening --mu=0..0.6 --eta=0.12",
        "find friction --alpha=80deg±1deg --eta=0.12",
        "voussoirs --alpha=1 --stones=2 --mu=0.6±10%",
        "assess --span=10m±2cm --rise=3m±1cm --mu=0.2..0.6 --eta=60cm±1cm",
        "voussoirs --span=10m --rise=3m --stones=9 --mu=0.6 --density=24kN/m3 --depth=1m",
        "voussoirs --radius=3m --alpha=1 --stones=9 --mu=1 --eta=60cm --density=24kN/m3 --depth=1m",
        "assess --radius=3m --alpha=1 --mu=1 --eta=60cm --tilt=5deg --density=24kN/m3 --depth=1m",
        "draw --at T",
        "draw --alpha 80deg --mu 0.35 --eta 0.16",
        "draw --alpha 2.62 --mu inf",
        "draw --alpha 1.2 --mu 1 --radius 5m",
        "draw --span 10m --rise 3m --mu 0.6 --eta 60cm --density 24kN/m3 --depth 1m",
        "audit",
        "constants --digits 20",
        "prove eq-16 --show",
        "prove eq-8",
        "prove --index",
    ] {
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
    for question in object("sample --assemblies --count 16").as_array().unwrap() {
        check(question, &mut seen);
    }
    for document in documents {
        check(&serde_json::from_str(&document).unwrap(), &mut seen);
    }
    for line in lines.lines() {
        check(&serde_json::from_str(line).unwrap(), &mut seen);
    }
    let all = fs::read_dir(folder()).unwrap();
    let all = all.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let all = all.filter(|name| cfg!(feature = "parquet") || name != "sweep-1.json");
    // What a script writes is held against its schemas where that is run.
    let all = all
        .filter(|name| !["theorem_map-1.json", "reference_index-1.json"].contains(&name.as_str()));
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
