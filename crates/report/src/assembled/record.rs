//! The record of an assembly, `couplet.assembly/1`, and its row.

use super::assembly::Assembled;
use crate::arch::mechanism::Contact;
use crate::csv;
use crate::json::line;
use crate::problem::stones::JointContact;
use crate::record::Record;
use crate::strategies::{Assembly, AssemblyProof, Block};
use couplet_stones::VoussoirLimit;
use std::io;

/// The columns; the bounds of the threshold stand beside it.
const COLUMNS: &str = "id stands near margin threshold threshold_lower threshold_upper safety mode mechanism weight stones \
                       friction thickness half_opening span rise measured_at unit radius half_opening_rad \
                       friction_double thickness_ratio command";

/// Names of the columns.
pub fn header() -> io::Result<Vec<u8>> {
    csv::line(COLUMNS.split(' '))
}

/// Row of a question.
pub fn row(of: &Assembled) -> io::Result<Vec<u8>> {
    let mut row = question(of);
    let threshold = &of.assembly.threshold.decimal;
    row.add("threshold_lower", threshold.lower.to_string());
    row.add("threshold_upper", threshold.upper.to_string());
    let mechanism = everywhere(&of.assembly, &of.assembly.contacts);
    row.add(
        "mechanism",
        mechanism.iter().map(|(what, joint)| format!("{what} {joint}")).collect::<Vec<_>>(),
    );
    csv::row(COLUMNS, &row)
}

/// Object of a question, on a line.
pub fn json(of: &Assembled) -> io::Result<Vec<u8>> {
    let Assembled { assembly, blocks, .. } = of;
    let mut all = Record::of("couplet.assembly/1");
    all.append(question(of));
    all.add_list("mechanism", contacts(everywhere(assembly, &assembly.contacts)));
    all.add_record("proof", Some(proof(assembly)));
    let stone = |stone: &Block| serde_json::json!({"polygon": stone.polygon, "weight": stone.weight, "centroid": stone.centroid});
    all.add("blocks", blocks.stones.iter().map(stone).collect::<Vec<_>>());
    all.add("supports", serde_json::json!(blocks.supports));
    all.add("joints", serde_json::json!(blocks.joints));
    line(&all)
}

/// Question and answer.
fn question(of: &Assembled) -> Record {
    let Assembled { id, assembly, blocks } = of;
    let asked = of.asked();
    let surveyed = assembly.surveyed.as_ref();
    let mut fields = Record::default();
    fields.add("id", id.as_str());
    fields.add("stands", assembly.stands());
    fields.add("near", assembly.near.name());
    fields.add("margin", assembly.margin.to_string());
    fields.add_bounds("threshold", Some(&assembly.threshold));
    fields.add_bounds("safety", Some(&assembly.safety));
    fields.add("mode", assembly.mode.map(|mode| mode.label()));
    fields.add("weight", assembly.weight.name());
    fields.add("stones", assembly.stones.number());
    fields.add("friction", assembly.friction.to_string());
    fields.add("thickness", assembly.thickness_text.as_str());
    fields.add("half_opening", assembly.stones.half_opening().to_string());
    fields.add("span", surveyed.map(|of| of.span.as_str()));
    fields.add("rise", surveyed.map(|of| of.rise.as_str()));
    fields.add("measured_at", surveyed.map(|of| of.measures.circle().name()));
    fields.add("unit", of.unit());
    fields.add("radius", blocks.radius);
    fields.add("half_opening_rad", assembly.stones.half_opening().nearest_double());
    fields.add("friction_double", assembly.friction.nearest_double());
    fields.add("thickness_ratio", assembly.thickness.nearest_double());
    let weight = assembly.weight;
    fields.add("command", format!("couplet voussoirs --weight {weight}{}", asked.options()));
    fields
}

/// Contacts of the half arch at the joints of the whole one, from the left springing, one at the crown once.
fn everywhere(of: &Assembly, half: &[JointContact]) -> Vec<(&'static str, u64)> {
    let both = |contact: &JointContact| {
        let name = of.stones.at_limit(*contact, true);
        [false, true].map(|is_right| (name, of.whole_joint(contact.1, is_right)))
    };
    let mut all: Vec<(&'static str, u64)> = half.iter().flat_map(both).collect();
    all.sort_by_key(|(_, joint)| *joint);
    all.dedup();
    all
}

fn contacts(of: Vec<(&'static str, u64)>) -> Vec<Record> {
    of.into_iter()
        .map(|(what, joint)| Record::named("happens joint", [what.into(), joint.into()]))
        .collect()
}

/// Proof of the verdict.
fn proof(of: &Assembly) -> Record {
    let mut fields = Record::default();
    let bound = |limit: &VoussoirLimit| {
        let mut fields = Record::default();
        fields.add_bounds("thrust", limit.thrust.as_ref());
        let at = |(contact, joint): &(Contact, u64)| (contact.name(), of.whole_joint(*joint, true));
        fields.add_list("by", contacts(limit.contacts.iter().map(at).collect()));
        Some(fields)
    };
    match &of.proof {
        AssemblyProof::Stands { thrust, moment } => {
            fields.add("thrust", thrust.to_string());
            fields.add("moment", moment.to_string());
        }
        AssemblyProof::Falls(bounds) => {
            let [needed, borne] = &**bounds;
            fields.add_record("needed", bound(needed));
            fields.add_record("borne", bound(borne));
        }
    }
    fields
}
