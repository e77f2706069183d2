//! A point of a curve at a parameter, with digits, `couplet.map_point/1`.

use super::rows::weight_of;
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::number::Rounded;
use crate::problem::Quantity;
use crate::report::words::model;
use crate::report::{Record, Reported, Tabular};

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
    /// Cells that name the point.
    fn named(&self) -> Record {
        let mut record = Record::of("couplet.map_point/1");
        record.add("weight", weight_of(self.curve, self.weight));
        record.add("curve", self.curve.to_string());
        record.add("parameter", self.curve.parameter().name());
        record.add("given", self.given.as_str());
        record
    }
}

impl Reported for MapPoint {
    fn records(&self) -> Vec<Record> {
        let mut record = self.named();
        let parameter = self.curve.parameter().name().replace('_', " ");
        let weight = weight_of(self.curve, self.weight)
            .map_or("any self-weight".to_owned(), |_| model(self.weight));
        record.say(format!("{} at {parameter} {}, {weight}\n", self.curve, self.given));
        let mut values = Record::default();
        self.values.iter().for_each(|(of, value)| values.show(*of, 12, value));
        record.add_record("values", Some(values));
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let rows = self.values.iter().map(|(quantity, value)| {
            let mut row = self.named();
            row.add("quantity", quantity.name());
            row.append(Record::bounds(value));
            row
        });
        Tabular::of("weight curve parameter given quantity value lower upper", rows)
    }
}
