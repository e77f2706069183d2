//! Arches of voussoirs: for a person, CSV, and JSON (`couplet.voussoirs/1`).

use super::fields::Fields;
use super::words::model;
use super::{csv, json};
use crate::arch::SelfWeight;
use crate::arch::mechanism::Contact;
use crate::certify::state::Figure;
use crate::certify::{Undecided, VoussoirDigits, Voussoirs};
use crate::problem::Quantity;
use crate::problem::stones::{JointContact, Stones};
use std::io;

/// An arch of voussoirs, what is proved of it, and the same arch without end of joints.
#[derive(Debug)]
pub struct VoussoirArch {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The friction as given.
    pub friction: String,
    /// Its stones.
    pub stones: Stones,
    /// What is proved.
    pub found: Result<Voussoirs, Undecided>,
    /// The least thickness with a joint at every angle; `None` where there is none, or it is not proved.
    pub continuous: Option<Figure>,
}

/// An arch for each weight asked for.
#[derive(Debug)]
pub struct VoussoirArches(pub Vec<VoussoirArch>);

impl VoussoirArch {
    /// What became of it, in a word.
    fn outcome(&self) -> &'static str {
        match &self.found {
            Ok(Voussoirs::Stands(_)) => "stands",
            Ok(Voussoirs::AnyThickness) => "any_thickness",
            Ok(Voussoirs::Slides) => "sliding",
            Ok(Voussoirs::TooThick) => "thickness",
            Err(_) => "undecided",
        }
    }

    /// The state, where it has one.
    fn state(&self) -> Option<&VoussoirDigits> {
        match &self.found {
            Ok(Voussoirs::Stands(state)) => Some(state),
            _ => None,
        }
    }

    fn figures(&self) -> Vec<(Quantity, Option<&Figure>)> {
        let state = self.state();
        vec![
            (Quantity::Thickness, state.map(|state| &state.thickness)),
            (Quantity::Thrust, state.map(|state| &state.thrust)),
            (Quantity::RotationJoint, state.map(|state| &state.rotation_joint)),
            (Quantity::SlidingJoint, state.and_then(|state| state.sliding_joint.as_ref())),
        ]
    }

    /// How it is divided, in words.
    fn division(&self) -> String {
        match &self.stones {
            Stones::Equal { stones, .. } => format!("{stones} equal stones"),
            Stones::Joints(angles) => {
                let angles: Vec<String> = angles.iter().map(ToString::to_string).collect();
                format!("joints at {}", angles.join(", "))
            }
        }
    }
}

/// A contact in words.
fn words(contact: Contact) -> &'static str {
    match contact {
        Contact::Extrados => "hinge at the extrados",
        Contact::Intrados => "hinge at the intrados",
        Contact::Inwards => "slides inwards",
        Contact::Outwards => "slides outwards",
    }
}

pub(super) fn table(
    VoussoirArches(arches): &VoussoirArches,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    for (index, arch) in arches.iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        let (alpha, mu) = (arch.stones.half_opening(), &arch.friction);
        let weight = model(arch.weight);
        writeln!(
            out,
            "Arch of half opening {alpha} in {}, friction {mu}, {weight}\n",
            arch.division()
        )?;
        match &arch.found {
            Ok(Voussoirs::Stands(state)) => stands(arch, state, out)?,
            Ok(Voussoirs::AnyThickness) => writeln!(
                out,
                "stands at every thickness, proved: it has no joint inside its halves"
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
    }
    Ok(())
}

fn stands(arch: &VoussoirArch, state: &VoussoirDigits, out: &mut dyn io::Write) -> io::Result<()> {
    let mode = state.mode.label();
    writeln!(out, "stands from the thickness below on; collapses there as {mode}")?;
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
    let place = |contact: &JointContact| match contact.1 {
        0 if arch.stones.has_joint_at_crown() => "at the crown".to_owned(),
        joint if joint + 1 == arch.stones.count() => "at the shoulder".to_owned(),
        joint => {
            let from_crown = u64::from(!arch.stones.has_joint_at_crown());
            format!("at joint {}", joint + from_crown)
        }
    };
    state
        .contacts
        .iter()
        .try_for_each(|contact| writeln!(out, "   {:<22} {}", words(contact.0), place(contact)))
}

pub(super) fn csv(
    VoussoirArches(arches): &VoussoirArches,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let header =
        ["weight", "half_opening", "stones", "friction", "outcome", "mode"].map(str::to_owned);
    let names = ["thickness", "thrust", "rotation_joint", "sliding_joint", "continuous_thickness"];
    let names = names.map(str::to_owned);
    let rows = arches.iter().map(|arch| {
        let given = [
            arch.weight.name().to_owned(),
            arch.stones.half_opening().to_string(),
            stones(arch).unwrap_or_default(),
            arch.friction.clone(),
        ];
        let mode = arch.state().map_or("", |state| state.mode.label());
        let found = [arch.outcome().to_owned(), mode.to_owned()];
        let text = |figure: Option<&Figure>| figure.map_or(String::new(), ToString::to_string);
        let figures = arch.figures().into_iter().map(|(_, figure)| text(figure));
        let continuous = text(arch.continuous.as_ref());
        given.into_iter().chain(found).chain(figures).chain([continuous]).collect()
    });
    let header = header.into_iter().chain(names).collect();
    csv::write(std::iter::once(header).chain(rows), out)
}

/// The number of equal stones.
fn stones(arch: &VoussoirArch) -> Option<String> {
    match arch.stones {
        Stones::Equal { stones, .. } => Some(stones.to_string()),
        Stones::Joints(_) => None,
    }
}

pub(super) fn json(
    VoussoirArches(arches): &VoussoirArches,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let entries: Vec<Fields> = arches.iter().map(entry).collect();
    match &entries[..] {
        [one] => json::write(one, out),
        all => json::write(&all, out),
    }
}

fn entry(arch: &VoussoirArch) -> Fields {
    let mut fields = Fields::default();
    fields.add("schema", "couplet.voussoirs/1");
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
    fields.add("reason", arch.found.as_ref().err().map(|undecided| undecided.reason.to_string()));
    fields.add("mode", arch.state().map(|state| state.mode.label()));
    for (quantity, figure) in arch.figures() {
        fields.add_fields(quantity.name(), figure.map(bounds));
    }
    fields.add_fields("continuous_thickness", arch.continuous.as_ref().map(bounds));
    let contacts = arch.state().map(|state| {
        let contact = |contact: &JointContact| format!("{} {}", words(contact.0), contact.1);
        state.contacts.iter().map(contact).collect::<Vec<_>>()
    });
    fields.add("contacts", contacts);
    fields
}

fn bounds(figure: &Figure) -> Fields {
    let mut fields = Fields::default();
    fields.add("value", figure.decimal.value.to_string());
    fields.add("lower", figure.decimal.lower.to_string());
    fields.add("upper", figure.decimal.upper.to_string());
    fields
}
