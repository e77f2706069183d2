//! Arches of voussoirs for a person at a terminal.

use super::arch::{VoussoirArch, VoussoirArches, at_limit};
use super::{convergence, given};
use crate::certify::{VoussoirDigits, Voussoirs};
use crate::problem::asymmetric_region::STANDS;
use crate::report::words::apart;
use std::io;

pub(crate) fn table(all: &VoussoirArches, out: &mut dyn io::Write) -> io::Result<()> {
    if all.is_range {
        return convergence::rows(all, out);
    }
    let arches = &all.arches;
    apart(arches, out, |arch, out| {
        writeln!(out, "Arch of {}\n", all.asked.with_weight(arch.weight))?;
        if let Some(given) = &arch.given {
            given::lines(arch, given, out)?;
            return may_move(arch, out);
        }
        match &arch.found {
            Ok(Voussoirs::Stands(state)) => stands(arch, state, out)?,
            Ok(Voussoirs::AnyThickness) => writeln!(
                out,
                "stands at every thickness, proved: {STANDS}, as it has no joint inside its halves"
            )?,
            Ok(Voussoirs::Slides) => writeln!(
                out,
                "does not stand at any thickness (sliding): no thrust holds an inner joint and the shoulder"
            )?,
            Ok(Voussoirs::TooThick) => {
                writeln!(out, "does not stand at any thickness up to twice the radius (thickness)")?
            }
            Err(undecided) => writeln!(out, "{undecided}")?,
        }
        may_move(arch, out)
    })
}

/// Writes what the static theorem does not exclude.
fn may_move(arch: &VoussoirArch, out: &mut dyn io::Write) -> io::Result<()> {
    arch.may_move_in_words().map_or(Ok(()), |words| writeln!(out, "\n{words}"))
}

fn stands(arch: &VoussoirArch, state: &VoussoirDigits, out: &mut dyn io::Write) -> io::Result<()> {
    let mode = state.mode.label();
    writeln!(out, "stands from the thickness below on: {STANDS}; collapses there as {mode}")?;
    writeln!(
        out,
        "proved: admissible at all {} joints of the half arch, none thinner\n",
        arch.stones.count()
    )?;
    for (quantity, figure) in arch.figures() {
        let figure = figure.map_or("none".to_owned(), ToString::to_string);
        let (name, symbol) = (quantity.name(), quantity.symbol());
        writeln!(out, "   {name:<20} {symbol:<12} {figure}")?;
    }
    if let Some(continuous) = &arch.continuous {
        writeln!(out, "\n   with a joint at every angle       {continuous}")?;
    }
    writeln!(out, "\nmechanism, joints counted from the crown")?;
    state.contacts.iter().try_for_each(|contact| {
        let (words, place) = (at_limit(arch, contact), arch.place(contact.1));
        writeln!(out, "   {words:<22} {place}")
    })
}
