//! Arches of voussoirs for a person.

use super::arch::{VoussoirArch, VoussoirArches, at_limit};
use super::given;
use crate::problem::asymmetric_region::STANDS;
use crate::record::Record;
use couplet_stones::{VoussoirDigits, Voussoirs};

/// Lines on an arch.
pub(super) fn say(all: &VoussoirArches, arch: &VoussoirArch, record: &mut Record) {
    record.say(format!("Arch of {}\n", all.asked.with_weight(arch.weight)));
    match (&arch.given, &arch.found) {
        (Some(given), _) => record.say_all(given::lines(arch, given)),
        (None, Ok(Voussoirs::Stands(state))) => stands(arch, state, record),
        (None, Ok(Voussoirs::AnyThickness)) => record.say(format!(
            "stands at every thickness, proved: {STANDS}, as it has no joint inside its halves"
        )),
        (None, Ok(Voussoirs::Slides)) => record.say(
            "does not stand at any thickness (sliding): no thrust holds an inner joint and the shoulder",
        ),
        (None, Ok(Voussoirs::TooThick)) => {
            record.say("does not stand at any thickness up to twice the radius (thickness)");
        }
        (None, Err(undecided)) => record.say(undecided.to_string()),
    }
    record.say_all(arch.sizes.iter().flat_map(|sizes| sizes.lines("as measured", &all.asked)));
    record.say_all(arch.may_move_in_words().map(|words| format!("\n{words}")));
    if arch.is_still {
        record.say("\nabove its least thickness (19) has no solution, proved: there nothing moves without dilatancy either");
    }
}

fn stands(arch: &VoussoirArch, state: &VoussoirDigits, record: &mut Record) {
    let (mode, joints) = (state.mode.label(), arch.stones.count());
    record.say(format!("stands from the thickness below on: {STANDS}; collapses there as {mode}"));
    record
        .say(format!("proved: admissible at all {joints} joints of the half arch, none thinner\n"));
    for (quantity, figure) in arch.figures() {
        let figure = figure.map_or("none".to_owned(), ToString::to_string);
        record.say(format!("   {:<20} {:<12} {figure}", quantity.name(), quantity.symbol()));
    }
    let continuous = arch.continuous.as_ref();
    record.say_all(continuous.map(|of| format!("\n   with a joint at every angle       {of}")));
    record.say("\nmechanism, joints counted from the crown");
    let contacts = state.contacts.iter();
    record
        .say_all(contacts.map(|of| format!("   {:<22} {}", at_limit(arch, of), arch.place(of.1))));
}
