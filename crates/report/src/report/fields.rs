//! Named fields in the order in which they are written: an object in JSON, cells of a row in CSV.

use super::answer::Kept;
use serde::{Serialize, Serializer};
use serde_json::Value as Json;
use serde_json::value::RawValue;
use std::borrow::Cow;

/// Named fields in their order.
#[derive(Debug, Default)]
pub(crate) struct Fields(Vec<(Cow<'static, str>, Field)>);

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Field {
    Value(Json),
    Raw(Box<RawValue>),
    Fields(Fields),
    List(Vec<Fields>),
}

impl Fields {
    /// Adds a field; nothing is `null`.
    pub(crate) fn add(&mut self, name: &'static str, value: impl Into<Json>) {
        self.0.push((name.into(), Field::Value(value.into())));
    }

    /// Adds an object, or `null`.
    pub(crate) fn add_fields(&mut self, name: &'static str, fields: Option<Fields>) {
        self.0.push((name.into(), fields.map_or(Field::Value(Json::Null), Field::Fields)));
    }

    /// Adds a list of objects.
    pub(crate) fn add_list(&mut self, name: &'static str, list: Vec<Fields>) {
        self.0.push((name.into(), Field::List(list)));
    }

    /// Adds the fields of another.
    pub(crate) fn append(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }

    /// Adds what is handed on under a name from outside.
    pub(crate) fn keep(&mut self, name: &str, kept: &Kept) {
        let text = || Field::Value(kept.text().into());
        let field = match kept {
            Kept::Text(_) => text(),
            Kept::Json(json) => {
                RawValue::from_string(json.clone()).map_or_else(|_| text(), Field::Raw)
            }
        };
        self.0.push((name.to_owned().into(), field));
    }

    /// The names of the fields.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.as_ref())
    }

    /// The fields as text; `null`, objects and lists of them are empty.
    pub(crate) fn texts(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|(_, field)| match field {
            Field::Value(Json::String(text)) => text.clone(),
            Field::Value(Json::Null) | Field::Fields(_) | Field::List(_) => String::new(),
            Field::Raw(json) => json.get().to_owned(),
            Field::Value(other) => other.to_string(),
        })
    }
}

impl FromIterator<(&'static str, Json)> for Fields {
    fn from_iter<I: IntoIterator<Item = (&'static str, Json)>>(fields: I) -> Self {
        Self(fields.into_iter().map(|(name, value)| (name.into(), Field::Value(value))).collect())
    }
}

impl Serialize for Fields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, field)| (name, field)))
    }
}
