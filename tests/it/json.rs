//! JSON that the program writes, read as what a test expects there.

use serde_json::Value;

pub(crate) trait Json {
    /// The entries of a list.
    fn list(&self) -> &[Value];

    fn text(&self) -> &str;

    /// A number: itself, its text, or the value beside its bounds.
    fn number(&self) -> f64;
}

impl Json for Value {
    #[track_caller]
    fn list(&self) -> &[Value] {
        self.as_array().unwrap_or_else(|| panic!("no list: {self}"))
    }

    #[track_caller]
    fn text(&self) -> &str {
        self.as_str().unwrap_or_else(|| panic!("no text: {self}"))
    }

    #[track_caller]
    fn number(&self) -> f64 {
        match self {
            Value::Number(number) => number.as_f64().unwrap(),
            Value::Object(of) => of["value"].number(),
            _ => self.text().parse().unwrap_or_else(|_| panic!("no number: {self}")),
        }
    }
}

/// A text of each of some objects.
#[track_caller]
pub(crate) fn texts<'a>(objects: &'a [Value], key: &str) -> Vec<&'a str> {
    objects.iter().map(|of| of[key].text()).collect()
}

/// An object says this among others, and so does each object in it.
#[track_caller]
pub(crate) fn says(of: &Value, expected: Value) {
    let Value::Object(entries) = expected else { return assert_eq!(*of, expected) };
    for (key, expected) in entries {
        match expected.is_object() {
            true => says(&of[&key], expected),
            false => assert_eq!(of[&key], expected, "{key} of {of}"),
        }
    }
}
