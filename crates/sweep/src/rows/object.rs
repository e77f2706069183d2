//! A JSON object with its values as they are written.

use crate::number::BETWEEN;
use crate::report::words::shortened;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::error::Category;
use serde_json::value::RawValue;
use std::fmt;

/// Objects of more keys are refused: each key is compared with all others.
const MAX_KEYS: usize = 1000;

/// A JSON object with its values as they are written, so that a number keeps all its digits.
pub struct JsonObject<'a>(Vec<(String, &'a RawValue)>);

impl<'a> JsonObject<'a> {
    /// Reads one; a key that is there twice is an error.
    pub(crate) fn parse(bytes: &'a [u8]) -> Result<Self, String> {
        serde_json::from_slice(bytes).map_err(|error| json_error(bytes, &error))
    }

    /// A value as text: a string without its quotes, the value of an object, of two in a list the range between them,
    /// nothing for `null`, anything else as written. `None` if the key is missing.
    pub(crate) fn text(&self, key: &str) -> Option<String> {
        self.entry(key).map(text)
    }

    /// A value as it is written.
    pub(crate) fn raw(&self, key: &str) -> Option<&'a str> {
        self.entry(key).map(RawValue::get)
    }

    fn entry(&self, key: &str) -> Option<&'a RawValue> {
        self.0.iter().find(|(name, _)| name == key).map(|(_, raw)| *raw)
    }

    /// The keys.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.as_str())
    }
}

/// The error of a line of JSON, with its column if the syntax is wrong. Callers add the line number.
fn json_error(bytes: &[u8], error: &serde_json::Error) -> String {
    let text = error.to_string();
    let message = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
    let column = error.column();
    let rest = bytes.get(column.saturating_sub(1)..).unwrap_or_default();
    let is_not_json = ["NaN", "Infinity"].iter().any(|word| rest.starts_with(word.as_bytes()));
    match error.classify() {
        Category::Data | Category::Io => message.to_owned(),
        _ if is_not_json => {
            format!(
                "column {column}: NaN and Infinity are not JSON; give a text (\"nan\", \"inf\")"
            )
        }
        _ => format!("column {column}: {message}"),
    }
}

impl JsonObject<'_> {
    /// A value as `couplet states` writes it: with its bounds, or a thrust with what limits it, which
    /// without a bound is infinite.
    fn value(&self) -> Option<String> {
        match (self.entry("value"), self.entry("thrust")) {
            (Some(value), _) => (!value.get().starts_with('{')).then(|| text(value)),
            (None, Some(thrust)) if thrust.get() == "null" => Some("inf".to_owned()),
            (None, Some(thrust)) => JsonObject::parse(thrust.get().as_bytes()).ok()?.value(),
            (None, None) => None,
        }
    }
}

/// Range between the two values of a list, which are no lists themselves.
fn range(written: &str) -> Option<String> {
    let [lower, upper] = serde_json::from_str::<[&RawValue; 2]>(written).ok()?;
    let is_value = |end: &&RawValue| !end.get().starts_with(['[', 'n']);
    [lower, upper].iter().all(is_value).then(|| [lower, upper].map(text).join(BETWEEN))
}

fn text(raw: &RawValue) -> String {
    let written = raw.get();
    let meant = match written.as_bytes().first() {
        Some(b'n') => Some(String::new()),
        Some(b'"') => serde_json::from_str(written).ok(),
        Some(b'{') => JsonObject::parse(written.as_bytes()).ok().and_then(|inner| inner.value()),
        Some(b'[') => range(written),
        _ => None,
    };
    meant.unwrap_or_else(|| written.to_owned())
}

impl<'de> Deserialize<'de> for JsonObject<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries;
        impl<'de> Visitor<'de> for Entries {
            type Value = JsonObject<'de>;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a JSON object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut entries: Vec<(String, &'de RawValue)> = Vec::new();
                while let Some((key, value)) = map.next_entry::<String, &RawValue>()? {
                    if entries.iter().any(|(name, _)| *name == key) {
                        let message = format!("duplicate key '{}'", shortened(&key));
                        return Err(serde::de::Error::custom(message));
                    }
                    if entries.len() == MAX_KEYS {
                        let message = format!("an object of more than {MAX_KEYS} keys");
                        return Err(serde::de::Error::custom(message));
                    }
                    entries.push((key, value));
                }
                Ok(JsonObject(entries))
            }
        }
        deserializer.deserialize_map(Entries)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_with_a_line_is_told_with_its_column() {
        let error = |text: &str| JsonObject::parse(text.as_bytes()).err().unwrap();
        let not_json = "NaN and Infinity are not JSON; give a text (\"nan\", \"inf\")";
        assert_eq!(error(r#"{"a":NaN}"#), format!("column 6: {not_json}"));
        assert_eq!(error(r#"{"a": Infinity}"#), format!("column 7: {not_json}"));
        assert_eq!(error(r#"{"a":-Infinity}"#), format!("column 7: {not_json}"));
        assert_eq!(error(r#"{"a":x}"#), "column 6: expected value");
        assert_eq!(error(r#"{"a":1,"a":2}"#), "duplicate key 'a'");
        assert_eq!(error("3"), "invalid type: integer `3`, expected a JSON object");
    }
}
