//! The curves as Parquet, read back, beside the same curves as JSON.

use crate::export::parquet::read;
use crate::program::{Json, couplet, object};
use parquet::record::Field;
use serde_json::Value;

/// A cell as JSON has it; what is infinite is a text there.
fn as_json(field: &Field) -> Value {
    match field {
        Field::Null => Value::Null,
        Field::Bool(truth) => (*truth).into(),
        Field::Long(number) => (*number).into(),
        Field::Double(x) if x.is_infinite() => "inf".into(),
        Field::Double(x) => (*x).into(),
        Field::Str(text) => text.as_str().into(),
        other => panic!("{other:?}"),
    }
}

/// Each node of a document with what its curve, or its part of the line of a half opening, says of it.
fn nodes(document: &Value) -> Vec<Value> {
    let array = |value: &Value| value.list().to_vec();
    let named = |nodes: &Value, names: [(&str, &Value); 3]| -> Vec<Value> {
        let mut nodes = array(nodes);
        for (index, node) in nodes.iter_mut().enumerate() {
            names.iter().for_each(|(name, value)| node[*name] = (*value).clone());
            node["node"] = index.into();
        }
        nodes
    };
    let of_curve = |curve: &Value| {
        let names = [("weight", &curve["weight"]), ("curve", &curve["curve"])];
        named(&curve["nodes"], [names[0], names[1], ("mode", &Value::Null)])
    };
    let of_level = |level: &Value| -> Vec<Value> {
        let named_by = format!("half opening {}", level["half_opening"].text()).into();
        let names = [("weight", &level["weight"]), ("curve", &named_by)];
        let parts = array(&level["parts"]).into_iter();
        parts
            .flat_map(|part| named(&part["nodes"], [names[0], names[1], ("mode", &part["mode"])]))
            .collect()
    };
    let curves = array(&document["curves"]);
    let levels = array(&document["levels"]);
    curves.iter().flat_map(of_curve).chain(levels.iter().flat_map(of_level)).collect()
}

#[test]
fn parquet_and_json_say_the_same() {
    let line = "map --curve rrr/rrs,sliding,limit --alpha 2.58 --weight both --tolerance 1e-3";
    let document = object(line);
    let (rows, notes) = read(couplet(format!("{line} --format parquet")).stdout);
    assert_eq!(notes["couplet.schema"], document["schema"].text());
    assert_eq!(notes["couplet.tolerance"].parse::<f64>().ok(), document["tolerance"].as_f64());
    let nodes = nodes(&document);
    assert_eq!(rows.len(), nodes.len());
    for (row, node) in rows.iter().zip(&nodes) {
        let keys: Vec<&String> = node.as_object().unwrap().keys().collect();
        assert_eq!(row.len(), keys.len(), "{keys:?}");
        for (name, cell) in row {
            assert_eq!(as_json(cell), node[name], "{name} in {node}");
        }
    }
    let of = |name: &str, value: &str| rows.iter().any(|row| as_json(&row[name]) == value);
    assert!(of("friction_upper", "inf") && of("mode", "[r,s]") && of("weight", "heyman"));
    assert!(rows.iter().any(|row| row["weight"] == Field::Null), "sliding is of any weight");
}
