//! The names of the joints that are at their limits.

use super::numbers::label;
use crate::arch::mechanism::Contact;
use crate::atlas::Sketch;
use crate::sketch::CROWN;

/// An inner joint at its limits.
pub(super) struct NamedJoint {
    /// The angle from the crown, rad.
    pub at: f64,
    /// True if it turns.
    pub turns: bool,
    pub name: String,
}

/// The inner joints at their limits, each once. What a joint is called follows from its own limits: it turns, it
/// slides, or both, be it at two thrusts.
pub(super) fn named(sketch: &Sketch, marks: &[(Contact, f64)]) -> Vec<NamedJoint> {
    let alpha = sketch.half_opening();
    let are_one = |a: f64, b: f64| (a - b).abs() < CROWN * alpha;
    let mut all: Vec<NamedJoint> = Vec::new();
    for (_, at) in marks.iter().copied() {
        let is_inner = !are_one(at, 0.0) && !are_one(at, alpha);
        if !is_inner || all.iter().any(|known| are_one(known.at, at)) {
            continue;
        }
        let contacts = marks.iter().filter(|mark| are_one(mark.1, at)).map(|mark| mark.0);
        let contacts: Vec<Contact> = contacts.collect();
        let turns = contacts.iter().any(|contact| contact.is_hinge());
        let slides = contacts.iter().any(|contact| !contact.is_hinge());
        let number = number(sketch, at);
        let symbol = match (turns, slides) {
            (true, true) => "βᵣ = βₛ",
            (false, _) => "βₛ",
            // The hinge beside a keystone has no symbol.
            _ if number.is_some() && contacts.contains(&Contact::Extrados) => "",
            _ => "βᵣ",
        };
        let name = number.unwrap_or_default() + label(symbol, at).trim_start();
        all.push(NamedJoint { at, turns, name });
    }
    all
}

/// Number of an inner joint between stones, as the answer in words has it.
fn number(sketch: &Sketch, joint: f64) -> Option<String> {
    let stones = sketch.stones.as_ref()?;
    let near = |at: &f64| (at - joint).abs() < CROWN * sketch.half_opening();
    let place = sketch.stone_joints().iter().position(near)? as u64;
    Some(format!("joint {}, ", stones.from_crown(place)))
}
