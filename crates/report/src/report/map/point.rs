//! A point of a curve at a parameter, with digits: for a person, CSV, and JSON (`couplet.map_point/1`).

use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::number::Rounded;
use crate::problem::Quantity;
use crate::report::fields::Fields;
use crate::report::words::model;
use crate::report::{csv, json};
use std::io;

/// A point of a curve.
#[derive(Debug)]
pub struct MapPoint {
    /// The curve.
    pub curve: Curve,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The parameter as it was given.
    pub given: String,
    /// The quantities found, correctly rounded.
    pub values: Vec<(Quantity, Rounded)>,
}

/// A point of a curve for each weight asked for.
#[derive(Debug)]
pub struct MapPoints(pub Vec<MapPoint>);

impl MapPoint {
    fn weight(&self) -> Option<&'static str> {
        (!self.curve.is_weightless()).then(|| self.weight.name())
    }
}

pub(in crate::report) fn table(
    MapPoints(points): &MapPoints,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    for (index, point) in points.iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        let parameter = point.curve.parameter().name().replace('_', " ");
        let weight = match point.weight() {
            Some(_) => model(point.weight),
            None => "any self-weight".to_owned(),
        };
        writeln!(out, "{} at {parameter} {}, {weight}\n", point.curve, point.given)?;
        for (quantity, value) in &point.values {
            let (name, symbol) = (quantity.name(), quantity.symbol());
            writeln!(out, "   {name:<20} {symbol:<12} {}", value.value)?;
        }
    }
    Ok(())
}

pub(in crate::report) fn csv(
    MapPoints(points): &MapPoints,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let header = ["weight", "curve", "parameter", "given", "quantity", "value", "lower", "upper"];
    let rows = points.iter().flat_map(|point| {
        point.values.iter().map(move |(quantity, value)| {
            let names = [point.weight().unwrap_or_default().to_owned(), point.curve.to_string()];
            let parameter = [point.curve.parameter().name().to_owned(), point.given.clone()];
            let [value, lower, upper] =
                [&value.value, &value.lower, &value.upper].map(ToString::to_string);
            let found = [quantity.name().to_owned(), value, lower, upper];
            names.into_iter().chain(parameter).chain(found).collect()
        })
    });
    csv::write(std::iter::once(header.map(str::to_owned).to_vec()).chain(rows), out)
}

pub(in crate::report) fn json(
    MapPoints(points): &MapPoints,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let entry = |point: &MapPoint| {
        let mut fields = Fields::default();
        fields.add("schema", "couplet.map_point/1");
        fields.add("weight", point.weight());
        fields.add("curve", point.curve.to_string());
        fields.add("parameter", point.curve.parameter().name());
        fields.add("given", point.given.as_str());
        let mut values = Fields::default();
        for (quantity, value) in &point.values {
            let mut figure = Fields::default();
            figure.add("value", value.value.to_string());
            figure.add("lower", value.lower.to_string());
            figure.add("upper", value.upper.to_string());
            values.add_fields(quantity.name(), Some(figure));
        }
        fields.add_fields("values", Some(values));
        fields
    };
    let entries: Vec<Fields> = points.iter().map(entry).collect();
    match &entries[..] {
        [one] => json::write(one, out),
        all => json::write(&all, out),
    }
}
