//! Proved values for serde: with the names that they have in the documents of the command, each with its bounds.

use super::Constant;
use super::state::{Answer, AssessmentDigits, Digits, Figure};
use crate::number::Rounded;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// Fields of the correctly rounded value, its bounds and the nearest double; of infinity the first three are `inf`, and
/// the double, which JSON does not have, is left to the format.
fn value<M: SerializeMap>(to: &mut M, x: Option<&Rounded>, double: f64) -> Result<(), M::Error> {
    let texts = x.map(|x| [&x.value, &x.lower, &x.upper].map(ToString::to_string));
    let texts = texts.unwrap_or_else(|| [(); 3].map(|()| "inf".to_owned()));
    for (name, text) in ["value", "lower", "upper"].into_iter().zip(texts) {
        to.serialize_entry(name, &text)?;
    }
    to.serialize_entry("double", &double)
}

fn entry<M: SerializeMap>(to: &mut M, name: &str, x: Option<&Figure>) -> Result<(), M::Error> {
    match x {
        Some(figure) => to.serialize_entry(name, figure),
        None => to.serialize_entry(name, "inf"),
    }
}

/// Fields of a state; a friction that nothing reaches is `inf`.
fn state<M: SerializeMap>(to: &mut M, state: &Digits) -> Result<(), M::Error> {
    to.serialize_entry("mode", &state.mode)?;
    state.figures().try_for_each(|(of, figure)| entry(to, of.name(), figure))
}

/// `Serialize` of types as objects, from what writes their fields.
macro_rules! objects {
    ($($type:ty: |$of:ident, $fields:ident| $write:block)+) => {$(
        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                let ($of, mut object) = (self, to.serialize_map(None)?);
                let $fields = &mut object;
                $write
                object.end()
            }
        }
    )+};
}

objects! {
    Figure: |of, fields| { value(fields, Some(&of.decimal), of.double)?; }
    Digits: |of, fields| { state(fields, of)?; }
    Answer: |of, fields| {
        fields.serialize_entry("can_stand", &matches!(of, Self::Stands(_)))?;
        match of {
            Self::Stands(digits) => state(fields, digits)?,
            Self::Falls { fall, .. } => fields.serialize_entry("reason", fall.reason())?,
        }
    }
    AssessmentDigits: |of, fields| {
        fields.serialize_entry("stands", &of.stands.as_ref().ok())?;
        of.figures().try_for_each(|(of, figure)| entry(fields, of.name(), figure))?;
        fields.serialize_entry("reason", &of.first_open().map(ToString::to_string))?;
    }
    Constant: |of, fields| {
        fields.serialize_entry("landmark", &of.landmark)?;
        fields.serialize_entry("weight", &of.weight)?;
        fields.serialize_entry("quantity", &of.quantity)?;
        value(fields, of.rounded(), of.double)?;
        fields.serialize_entry("exact", &of.exact)?;
    }
}

#[cfg(test)]
mod tests {
    use crate::prelude::*;
    use serde_json::{Value, json};

    fn written(value: impl serde::Serialize) -> Value {
        serde_json::to_value(value).unwrap()
    }

    #[test]
    fn a_state_has_the_fields_of_the_command() {
        let arch = Arch::parse("milankovitch", "80deg", "0.6").unwrap();
        let state = written(arch.certify(17).unwrap());
        let thickness = json!({
            "value": "0.068650463330373536", "lower": "0.068650463330373535",
            "upper": "0.068650463330373536", "double": 0.06865046333037353,
        });
        assert_eq!((&state["thickness"], &state["mode"]), (&thickness, &json!("[r,r,r]")));
        assert_eq!(state["can_stand"], json!(true));
        let names: Vec<&str> = state.as_object().unwrap().keys().map(String::as_str).collect();
        assert!(names.contains(&"sliding_friction") && !names.contains(&"sliding_joint"));
        let falls = written(Arch::parse("heyman", "80deg", "0.1").unwrap().certify(5).unwrap());
        assert_eq!((&falls["can_stand"], falls.get("thickness")), (&json!(false), None));
        assert!(falls["reason"].as_str().unwrap().starts_with("it slides"));
    }

    #[test]
    fn infinity_and_what_is_open_are_told() {
        let end = CertifiedLandmark::new(Landmark::RotationEnd, SelfWeight::Heyman).unwrap();
        let friction = written(end.constant(Quantity::Friction, 5).unwrap());
        assert_eq!((&friction["value"], &friction["double"]), (&json!("inf"), &Value::Null));
        let thickness = written(end.constant(Quantity::Thickness, 5).unwrap());
        assert_eq!((&thickness["lower"], &thickness["exact"]), (&json!("1"), &json!("1")));
        // Twice the thickness with which it may just turn over.
        let arch = Arch::parse("heyman", "80deg", "inf").unwrap();
        let told = written(arch.certify_thickness(&"0.5".parse().unwrap(), 5).unwrap());
        assert_eq!((&told["stands"], &told["reason"]), (&json!(true), &Value::Null));
        assert_eq!(told["friction_safety"], json!("inf"));
    }
}
