//! Results at a given thickness: lines for a person, cells of a row, and an object.

use super::arch::{GivenThickness, VoussoirArch, at_limit};
use crate::certify::Undecided;
use crate::certify::state::Figure;
use crate::problem::asymmetric_region::STANDS;
use crate::problem::stones::JointContact;
use crate::record::Record;
use couplet_stones::{VoussoirAssessment, VoussoirLimit, VoussoirStanding, Voussoirs};

type RoundedGiven = Result<Option<Figure>, Undecided>;

/// The safety factors and the friction, by their names.
fn quotients(found: &VoussoirAssessment) -> [(&'static str, &'static str, &RoundedGiven); 3] {
    [
        ("geometric_safety", "geometric safety factor", &found.geometric_safety),
        ("required_friction", "required friction", &found.required_friction),
        ("friction_safety", "friction safety factor", &found.friction_safety),
    ]
}

/// The word for a value without a bound.
const UNBOUNDED: &str = "unbounded";

/// Text where a value is missing.
fn none(arch: &VoussoirArch, name: &str, found: &VoussoirAssessment) -> &'static str {
    match (name, &arch.found, &found.required_friction) {
        ("geometric_safety", Ok(Voussoirs::AnyThickness), _) => UNBOUNDED,
        ("required_friction", ..) => "none is enough",
        ("friction_safety", _, Ok(Some(_))) => UNBOUNDED,
        _ => "none",
    }
}

/// The lines below the title.
pub(super) fn lines(arch: &VoussoirArch, given: &GivenThickness) -> Vec<String> {
    let found = &given.found;
    let joints = arch.stones.count();
    let mut lines = vec![match &found.standing {
        Ok(VoussoirStanding::Stands(_)) => {
            format!(
                "stands, proved: {STANDS}, admissible at all {joints} joints of the half arch\n"
            )
        }
        Ok(VoussoirStanding::Falls(_)) => {
            "collapses, proved: no thrust satisfies all conditions\n".to_owned()
        }
        Err(undecided) => format!("{undecided}\n"),
    }];
    let mut line = |name: &str, text: &str| lines.push(format!("   {name:<24} {text}"));
    let least = match (&arch.found, arch.state()) {
        (_, Some(state)) => state.thickness.to_string(),
        (Ok(Voussoirs::AnyThickness), _) => "any is enough".to_owned(),
        (Ok(_), _) => format!("none is enough ({})", arch.outcome()),
        (Err(undecided), _) => undecided.to_string(),
    };
    line("least thickness", &least);
    for (key, name, value) in quotients(found) {
        let text = match value {
            Ok(Some(figure)) => figure.to_string(),
            Ok(None) => none(arch, key, found).to_owned(),
            Err(undecided) => undecided.to_string(),
        };
        line(name, &text);
    }
    let names = match given.stands() {
        Some(true) => [["least thrust", "largest thrust"], ["        limited by"; 2]],
        _ => [
            ["needs a thrust from", "bears a thrust up to"],
            ["        asked for by", "        limited by"],
        ],
    };
    if let Ok(VoussoirStanding::Stands(ends) | VoussoirStanding::Falls(ends)) = &found.standing {
        for (side, end) in ends.iter().enumerate() {
            let thrust = end.thrust.as_ref().map_or(UNBOUNDED.to_owned(), ToString::to_string);
            line(names[0][side], &thrust);
            if !end.contacts.is_empty() {
                line(names[1][side], &limited(arch, end));
            }
        }
    }
    lines
}

/// Limit of a thrust, in words.
fn limited(arch: &VoussoirArch, end: &VoussoirLimit) -> String {
    let one =
        |contact: &JointContact| format!("{} {}", at_limit(arch, contact), arch.place(contact.1));
    match end.contacts.is_empty() {
        true => "nothing".to_owned(),
        false => end.contacts.iter().map(one).collect::<Vec<_>>().join(", "),
    }
}

/// Names of the cells of a row.
pub(super) const COLUMNS: &str = "given_thickness can_stand geometric_safety required_friction friction_safety \
                                  least_thrust largest_thrust limited_by reason";

/// The cells of a row; what is open or does not exist is empty, and `inf` what has no bound.
pub(super) fn cells(arch: &VoussoirArch, given: &GivenThickness) -> Record {
    let mut cells = Record::default();
    cells.add("given_thickness", given.thickness.to_string());
    cells.add("can_stand", given.stands());
    let mut cell = |name: &'static str, figure: Option<&Figure>, is_unbounded: bool| match figure {
        None if is_unbounded => cells.add(name, "inf"),
        figure => cells.add_bounds(name, figure),
    };
    for (name, _, of) in quotients(&given.found) {
        let is_unbounded = of.is_ok() && none(arch, name, &given.found) == UNBOUNDED;
        cell(name, value(of), is_unbounded);
    }
    if let Ok(VoussoirStanding::Stands([least, largest])) = &given.found.standing {
        cell("least_thrust", least.thrust.as_ref(), false);
        cell("largest_thrust", largest.thrust.as_ref(), true);
    }
    let limits = given.found.standing.as_ref().ok().map(|standing| {
        let (VoussoirStanding::Stands(ends) | VoussoirStanding::Falls(ends)) = standing;
        ends.each_ref().map(|end| limited(arch, end)).join("; ")
    });
    cells.add("limited_by", limits);
    cells.add("reason", arch.first_open().map(|open| open.reason.to_string()));
    cells
}

fn value(found: &RoundedGiven) -> Option<&Figure> {
    found.as_ref().ok()?.as_ref()
}

/// The object.
pub(super) fn fields(arch: &VoussoirArch, given: &GivenThickness) -> Record {
    let mut fields = Record::default();
    fields.add("thickness", given.thickness.to_string());
    fields.add("stands", given.stands());
    for (name, _, of) in quotients(&given.found) {
        fields.add_bounds(name, value(of));
    }
    let ends = match &given.found.standing {
        Ok(VoussoirStanding::Stands(ends)) => Some((["least_thrust", "largest_thrust"], ends)),
        Ok(VoussoirStanding::Falls(ends)) => Some((["needed_thrust", "borne_thrust"], ends)),
        Err(_) => None,
    };
    let limit = |end: &VoussoirLimit| {
        let mut fields = Record::default();
        fields.add_bounds("thrust", end.thrust.as_ref());
        let contact = |contact: &(_, u64)| format!("{} {}", at_limit(arch, contact), contact.1);
        fields.add("limited_by", end.contacts.iter().map(contact).collect::<Vec<_>>());
        let joints = end.joints.iter().map(|joint| joint.decimal.value.to_string());
        fields.add("joints", joints.collect::<Vec<_>>());
        fields
    };
    if let Some((names, ends)) = ends {
        names.iter().zip(ends).for_each(|(name, end)| fields.add_record(name, Some(limit(end))));
    }
    fields.add("reason", arch.first_open().map(|open| open.reason.to_string()));
    fields
}
