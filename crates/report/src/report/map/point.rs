//! A point of a curve at a parameter, with digits: for a person, CSV, and JSON (`couplet.map_point/1`).

use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::number::Rounded;
use crate::problem::Quantity;
use crate::report::fields::Fields;
use crate::report::words::{apart, model};
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

impl MapPoint {
    fn weight(&self) -> Option<&'static str> {
        (!self.curve.is_weightless()).then(|| self.weight.name())
    }
}

pub(in crate::report) fn table(all: &[MapPoint], out: &mut dyn io::Write) -> io::Result<()> {
    apart(all, out, |point, out| {
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
        Ok(())
    })
}

/// Fields that name a point.
fn named(point: &MapPoint) -> Fields {
    let mut fields = Fields::of("couplet.map_point/1");
    fields.add("weight", point.weight());
    fields.add("curve", point.curve.to_string());
    fields.add("parameter", point.curve.parameter().name());
    fields.add("given", point.given.as_str());
    fields
}

pub(in crate::report) fn csv(all: &[MapPoint], out: &mut dyn io::Write) -> io::Result<()> {
    let row = |point, quantity: Quantity, of: &Rounded| {
        let mut row = named(point);
        row.add("quantity", quantity.name());
        for (name, x) in [("value", &of.value), ("lower", &of.lower), ("upper", &of.upper)] {
            row.add(name, x.to_string());
        }
        row
    };
    let rows =
        all.iter().flat_map(|point| point.values.iter().map(move |(q, x)| row(point, *q, x)));
    csv::table("weight curve parameter given quantity value lower upper", rows, out)
}

pub(in crate::report) fn json(all: &[MapPoint], out: &mut dyn io::Write) -> io::Result<()> {
    let entry = |point: &MapPoint| {
        let (mut fields, mut values) = (named(point), Fields::default());
        point.values.iter().for_each(|(of, value)| values.add_rounded(of.name(), Some(value)));
        fields.add_fields("values", Some(values));
        fields
    };
    json::write_all(all.iter().map(entry), out)
}
