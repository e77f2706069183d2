//! The record of an arch under a horizontal acceleration, `couplet.tilt/2`.

use super::format::Content;
use super::record::Record;
use super::reported::Reported;
use super::tabular::Tabular;
use super::tilt::{Joint, TiltedArch};
use super::words::division;
use crate::number::Rounded;
use crate::problem::asymmetric_region::MAY_MOVE;
use couplet_stones::LargestTilt;

impl Reported for TiltedArch {
    fn content() -> Content {
        Content::RECORDS
    }

    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.tilt/2");
        say(self, &mut record);
        self.asked.add_to(&mut record);
        record.add("weight", self.arch.weight().name());
        record.add("half_opening", self.arch.half_opening().to_string());
        record.add("friction", self.arch.friction().to_string());
        record.add("thickness", self.thickness.to_string());
        record.add("tilt", self.tilt.to_string());
        record.add("outcome", self.outcome());
        record.add("may_move", self.may_move());
        record.add("reason", self.first_open().map(|open| open.reason.to_string()));
        record.add_bounds("largest_tilt", self.figure());
        let is_unbounded = self.largest().map(|largest| matches!(largest, LargestTilt::Unlimited));
        record.add("is_unbounded", is_unbounded);
        record.add("limited_by", self.limits());
        record.add("stones", self.stones.as_ref().map(division));
        record.add_list("gives_way", self.joints().iter().map(|of| joint(self, of)));
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let columns = "weight half_opening friction thickness tilt outcome largest_tilt limited_by reason may_move stones";
        let rows = self.records().into_iter().map(|mut row| {
            if let Some(LargestTilt::Unlimited) = self.largest() {
                row.add("largest_tilt", "inf");
            }
            row
        });
        Tabular::of(columns, rows)
    }
}

fn joint(arch: &TiltedArch, of: &Joint) -> Record {
    let mut record = Record::default();
    record.add("happens", arch.happens(of.side, of.of.contact));
    record.add("side", if of.is_crown() { "crown" } else { of.side.name() });
    record.add_rounded("angle", Rounded::around(&of.size, arch.digits).as_ref());
    record.add("joint", of.number);
    record
}

/// Lines for a person.
fn say(arch: &TiltedArch, record: &mut Record) {
    record.say(format!("Arch of {}\n", arch.asked.with_weight(arch.arch.weight())));
    let joints = if arch.stones.is_some() { "between the stones" } else { "on the whole arch" };
    record.say(match (arch.is_admissible(), &arch.found) {
        (_, Ok(None)) => "collapses, proved: it does not stand without tilt either".to_owned(),
        (Some(true), _) => format!(
            "stands, proved: an admissible state exists, {joints} no joint slides or is under tension"
        ),
        (Some(false), _) => "collapses, proved: no state is admissible".to_owned(),
        (None, _) => arch.first_open().map_or(String::new(), ToString::to_string),
    });
    if arch.may_move() {
        record.say(format!("{MAY_MOVE}: that is not excluded"));
    }
    let Some(largest) = arch.largest() else { return };
    let text = match largest {
        LargestTilt::Limited(figure, _) => figure.to_string(),
        LargestTilt::Unlimited => "unbounded".to_owned(),
    };
    let words = if arch.arch.is_limited() { "falls from the tilt" } else { "largest tilt" };
    record.say(format!("\n   {words:<24} {text}"));
    for (index, limit) in arch.limits().iter().enumerate() {
        let words = if index == 0 { "        limited by" } else { "" };
        record.say(format!("   {words:<24} {limit}"));
    }
}
