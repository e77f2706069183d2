//! The record of an arch of voussoirs, `couplet.voussoirs/1`, and its row.

use super::arch::{VoussoirArch, VoussoirArches, at_limit};
use super::{convergence, given, words};
use crate::format::{Content, Format};
use crate::json;
use crate::picture::Print;
use crate::problem::stones::{JointContact, Stones};
use crate::record::Record;
use crate::reported::Reported;
use crate::sizes::Sizes;
use crate::tabular::Tabular;
use std::io;

impl Reported for VoussoirArches {
    fn content() -> Content {
        Content(&["table", "json", "csv", "csv2", "latex", "markdown", "svg", "png", "pdf", "dxf"])
    }

    fn records(&self) -> Vec<Record> {
        let entry = |arch| {
            let mut record = Record::of("couplet.voussoirs/1");
            if !self.is_range {
                words::say(self, arch, &mut record);
                record.add_record("asked", Some(self.asked.fields()));
            }
            record.note(self.asked.note());
            record.append(entry(arch));
            record
        };
        self.arches.iter().map(entry).collect()
    }

    fn tabular(&self) -> Tabular {
        let row = |arch: &VoussoirArch| {
            let mut row = entry(arch);
            row.note(self.asked.note());
            row.append(
                arch.given.as_ref().map(|given| given::cells(arch, given)).unwrap_or_default(),
            );
            row
        };
        let rows = self.arches.iter().map(row);
        let sizes = Sizes::columns(self.arches.iter().flat_map(|arch| &arch.sizes));
        match self.arches.iter().any(|arch| arch.given.is_some()) {
            true => Tabular::of(&([COLUMNS, given::COLUMNS].join(" ") + &sizes), rows),
            false => Tabular::of(&(COLUMNS.to_owned() + &sizes), rows),
        }
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        convergence::figure(self).captioned(print, &convergence::words(self))
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        match format.name {
            "table" if self.is_range => Some(convergence::rows(self, out)),
            "json" if self.is_range => Some(json::write(&self.records(), out)),
            _ => None,
        }
    }
}

const COLUMNS: &str = "weight half_opening stones friction outcome mode thickness thrust rotation_joint sliding_joint \
                       continuous_thickness loss relative_loss may_move";

fn entry(arch: &VoussoirArch) -> Record {
    let mut fields = Record::default();
    fields.add("weight", arch.weight.name());
    fields.add("half_opening", arch.stones.half_opening().to_string());
    match &arch.stones {
        Stones::Equal { stones, .. } => fields.add("stones", *stones),
        Stones::Joints(angles) => {
            let angles: Vec<String> = angles.iter().map(ToString::to_string).collect();
            fields.add("joints", angles);
        }
    }
    fields.add("friction", arch.friction.as_str());
    fields.add("outcome", arch.outcome());
    fields.add("may_move", arch.may_move());
    fields.add("reason", arch.found.as_ref().err().map(|undecided| undecided.reason.to_string()));
    fields.add("mode", arch.state().map(|state| state.mode.label()));
    for (quantity, figure) in arch.figures() {
        fields.add_bounds(quantity.name(), figure);
    }
    fields.add_bounds("continuous_thickness", arch.continuous.as_ref());
    let loss = arch.loss.as_ref();
    fields.add_rounded("loss", loss.map(|loss| &loss.thickness));
    fields.add_rounded("relative_loss", loss.map(|loss| &loss.share));
    let contacts = arch.state().map(|state| {
        let contact = |contact: &JointContact| format!("{} {}", at_limit(arch, contact), contact.1);
        state.contacts.iter().map(contact).collect::<Vec<_>>()
    });
    fields.add("contacts", contacts);
    fields.add_list("gives_way", arch.gives_way());
    if let Some(given) = &arch.given {
        fields.add_record("assessment", Some(given::fields(arch, given)));
    }
    arch.sizes.iter().for_each(|sizes| sizes.add_to(&mut fields));
    fields
}
