//! The record of an arch under a horizontal acceleration, `couplet.tilt/2`.

use super::record::Record;
use super::reported::Reported;
use super::sizes::Sizes;
use super::tabular::Tabular;
use super::tilt::{JointAtLimit, TiltedArch};
use super::words::division;
use crate::number::{Rounded, degrees};
use crate::problem::asymmetric_region::MAY_MOVE;
use couplet_stones::LargestTilt;

impl Reported for TiltedArch {
    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.tilt/2");
        say(self, &mut record);
        self.asked.add_to(&mut record);
        record.add_arch(&self.arch);
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
        for (name, figure) in &self.at_largest() {
            record.add_bounds(name, Some(figure));
        }
        self.sizes.iter().for_each(|sizes| sizes.add_to(&mut record));
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let columns = "weight half_opening friction thickness tilt outcome largest_tilt limited_by reason may_move stones \
                       largest_tilt_degrees thrust vertical_force";
        let columns = columns.to_owned() + &Sizes::columns(self.sizes.iter());
        let rows = self.records().into_iter().map(|mut row| {
            if let Some(LargestTilt::Unlimited) = self.largest() {
                row.add("largest_tilt", "inf");
            }
            row
        });
        Tabular::of(&columns, rows)
    }
}

fn joint(arch: &TiltedArch, of: &JointAtLimit) -> Record {
    let mut record = Record::default();
    record.add("happens", arch.happens(of.side, of.of.contact));
    record.add("side", if of.is_crown() { "crown" } else { of.side.name() });
    record.add_rounded("angle", Rounded::around(&of.size, arch.digits).as_ref());
    let degrees = Rounded::around(&degrees(&of.size), arch.digits);
    record.add_rounded("angle_degrees", degrees.as_ref());
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
    record.say_all(arch.largest().into_iter().flat_map(|largest| limited(arch, largest)));
    record.say_all(arch.sizes.iter().flat_map(|sizes| {
        sizes.lines("as measured; forces at the largest tilt, beside full gravity", &arch.asked)
    }));
}

/// Lines on the largest acceleration, and on the forces there.
fn limited(arch: &TiltedArch, largest: &LargestTilt) -> Vec<String> {
    let told = arch.at_largest();
    let told = |name| told.iter().find(|(of, _)| *of == name).map(|(_, figure)| figure);
    let text = match largest {
        LargestTilt::Limited(figure, _) => match told("largest_tilt_degrees") {
            Some(angle) => format!("{figure} = {angle} deg"),
            None => figure.to_string(),
        },
        LargestTilt::Unlimited => "unbounded".to_owned(),
    };
    let words = if arch.arch.is_limited() { "falls from the tilt" } else { "largest tilt" };
    let mut lines = vec![format!("\n   {words:<24} {text}")];
    for (index, limit) in arch.limits().iter().enumerate() {
        let words = if index == 0 { "        limited by" } else { "" };
        lines.push(format!("   {words:<24} {limit}"));
    }
    let forces =
        [("thrust in the crown then", "thrust"), ("vertical force there", "vertical_force")];
    let line = |(words, name)| told(name).map(|force| format!("   {words:<24} {force}"));
    lines.extend(forces.into_iter().filter_map(line));
    lines
}
