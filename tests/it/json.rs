//! JSON that the program writes, read as what a test expects there.

use serde_json::Value;

pub(crate) trait Json {
    /// The entries of a list.
    fn list(&self) -> &[Value];

    fn text(&self) -> &str;

    /// A number, not the text of one.
    fn number(&self) -> f64;

    /// The number in a text.
    fn decimal(&self) -> f64;

    /// The number in the text of a value that stands beside its bounds.
    fn value(&self) -> f64;
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
        self.as_f64().unwrap_or_else(|| panic!("no number: {self}"))
    }

    #[track_caller]
    fn decimal(&self) -> f64 {
        self.text().parse().unwrap_or_else(|_| panic!("no number in a text: {self}"))
    }

    #[track_caller]
    fn value(&self) -> f64 {
        self["value"].decimal()
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
