//! Named fields in the order in which they are written: an object in JSON, cells of a row in CSV.

use super::kept::Kept;
use crate::certify::state::Figure;
use crate::number::Rounded;
use serde::{Serialize, Serializer};
use serde_json::Value as Json;
use serde_json::value::RawValue;
use std::borrow::Cow;

/// Named fields in their order.
#[derive(Debug, Default)]
pub(crate) struct Fields(Vec<(Cow<'static, str>, FieldValue)>);

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum FieldValue {
    Value(Option<Json>),
    /// Infinity is `null` in JSON.
    Double(f64),
    Raw(Box<RawValue>),
    Fields(Fields),
    List(Vec<Fields>),
}

impl Fields {
    /// Fields of a document of a schema.
    pub(crate) fn of(schema: &'static str) -> Self {
        Self::named("schema", [schema.into()])
    }

    /// Adds a field; nothing is `null`.
    pub(crate) fn add(&mut self, name: impl Into<Cow<'static, str>>, value: impl Into<Json>) {
        self.0.push((name.into(), FieldValue::new(value.into())));
    }

    /// Adds a double, which is infinite in CSV and TOML too.
    pub(crate) fn add_double(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        value: impl Into<Option<f64>>,
    ) {
        self.0
            .push((name.into(), value.into().map_or(FieldValue::Value(None), FieldValue::Double)));
    }

    /// Adds an object, or `null`.
    pub(crate) fn add_fields(&mut self, name: &'static str, fields: Option<Fields>) {
        self.0.push((name.into(), fields.map_or(FieldValue::Value(None), FieldValue::Fields)));
    }

    /// Adds an object of objects, in the order of their names.
    pub(crate) fn add_sorted(
        &mut self,
        name: &'static str,
        all: impl IntoIterator<Item = (&'static str, Self)>,
    ) {
        let mut all: Vec<_> = all.into_iter().collect();
        all.sort_by_key(|(name, _)| *name);
        let all = all.into_iter().map(|(name, fields)| (name.into(), FieldValue::Fields(fields)));
        self.add_fields(name, Some(Self(all.collect())));
    }

    /// Adds a list of objects.
    pub(crate) fn add_list(&mut self, name: &'static str, list: impl IntoIterator<Item = Fields>) {
        self.0.push((name.into(), FieldValue::List(list.into_iter().collect())));
    }

    /// Adds a figure with its bounds, or `null`.
    pub(crate) fn add_bounds(&mut self, name: &'static str, figure: Option<&Figure>) {
        self.add_rounded(name, figure.map(|figure| &figure.decimal));
    }

    /// Adds a decimal with its bounds, or `null`.
    pub(crate) fn add_rounded(&mut self, name: &'static str, decimal: Option<&Rounded>) {
        self.add_fields(name, decimal.map(Self::bounds));
    }

    /// A decimal with its bounds.
    pub(crate) fn bounds(of: &Rounded) -> Self {
        let texts = [&of.value, &of.lower, &of.upper].map(|x| x.to_string().into());
        Self::named("value lower upper", texts)
    }

    /// Values under names that are given in one text, in its order.
    pub(crate) fn named<const N: usize>(names: &'static str, values: [Json; N]) -> Self {
        names.split(' ').zip(values).collect()
    }

    /// Adds the fields of another.
    pub(crate) fn append(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }

    /// Adds what is handed on under a name from outside.
    pub(crate) fn keep(&mut self, name: &str, kept: &Kept) {
        let text = || FieldValue::new(kept.text().into());
        let field = match kept {
            Kept::Text(_) => text(),
            Kept::Json(json) => {
                RawValue::from_string(json.clone()).map_or_else(|_| text(), FieldValue::Raw)
            }
        };
        self.0.push((name.to_owned().into(), field));
    }

    /// Takes away all values, not their names.
    pub(crate) fn clear(&mut self) {
        self.0.iter_mut().for_each(|(_, field)| *field = FieldValue::Value(None));
    }

    /// The names of the fields.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.as_ref())
    }

    /// The fields as text, each as in a cell of a table.
    pub(crate) fn texts(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|(_, field)| field.text())
    }

    /// The text of a field, empty where there is none; of several with one name it is the last.
    pub(crate) fn text(&self, name: &str) -> String {
        let field = self.0.iter().rfind(|(of, _)| of == name);
        field.map_or(String::new(), |(_, field)| field.text())
    }
}

impl FieldValue {
    fn new(value: Json) -> Self {
        Self::Value(Some(value).filter(|value| !value.is_null()))
    }

    /// The field in a cell: of a value with bounds the value, of texts all; `null` and other lists are empty.
    fn text(&self) -> String {
        match self {
            Self::Value(Some(Json::String(text))) => text.clone(),
            Self::Value(Some(Json::Array(texts))) => {
                texts.iter().filter_map(Json::as_str).collect::<Vec<_>>().join("; ")
            }
            Self::Value(None) | Self::List(_) => String::new(),
            Self::Value(Some(other)) => other.to_string(),
            Self::Double(x) => format!("{x:?}"),
            Self::Raw(json) => json.get().to_owned(),
            Self::Fields(fields) => fields.text("value"),
        }
    }
}

impl FromIterator<(&'static str, Json)> for Fields {
    fn from_iter<I: IntoIterator<Item = (&'static str, Json)>>(fields: I) -> Self {
        let field = |(name, value): (&'static str, Json)| (name.into(), FieldValue::new(value));
        Self(fields.into_iter().map(field).collect())
    }
}

impl Serialize for Fields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, field)| (name, field)))
    }
}
