//! Arches of voussoirs as CSV, a row for each, and as JSON, `couplet.voussoirs/1`.

use super::arch::{VoussoirArch, VoussoirArches, at_limit};
use super::given;
use crate::problem::stones::{JointContact, Stones};
use crate::report::fields::Fields;
use crate::report::{csv, json};
use std::io;

pub(crate) fn json(
    VoussoirArches { asked, arches, is_range }: &VoussoirArches,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let entry = |arch| {
        let mut fields = Fields::of("couplet.voussoirs/1");
        if !is_range {
            fields.add_fields("asked", Some(asked.fields()));
        }
        fields.append(entry(arch));
        fields
    };
    let entries = arches.iter().map(entry);
    match is_range {
        true => json::write(&entries.collect::<Vec<_>>(), out),
        false => json::write_all(entries, out),
    }
}

const COLUMNS: &str = "weight half_opening stones friction outcome mode thickness thrust rotation_joint sliding_joint \
                       continuous_thickness loss relative_loss may_move";

pub(crate) fn csv(
    VoussoirArches { arches, .. }: &VoussoirArches,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let row = |arch: &VoussoirArch| {
        let mut row = entry(arch);
        row.append(arch.given.as_ref().map(|given| given::cells(arch, given)).unwrap_or_default());
        row
    };
    let rows = arches.iter().map(row);
    match arches.iter().any(|arch| arch.given.is_some()) {
        true => csv::table(&[COLUMNS, given::COLUMNS].join(" "), rows, out),
        false => csv::table(COLUMNS, rows, out),
    }
}

fn entry(arch: &VoussoirArch) -> Fields {
    let mut fields = Fields::default();
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
        fields.add_fields("assessment", Some(given::fields(arch, given)));
    }
    fields
}
