//! Solutions of the complementarity problem (19) of an arch: for a person, CSV, and JSON (`couplet.complementarity/1`).

use super::fields::Fields;
use super::jointed;
use super::programme::{self, AtThickness};
use super::understood::Understood;
use super::words::{apart, kind};
use super::{csv, json};
use crate::certify::state::{Answer, Digits, Figure};
use crate::certify::{AsymmetricDigits, AsymmetricJoint, Enumeration, Undecided};
use crate::problem::Arch;
use std::io;

/// An arch with the solutions that are found.
#[derive(Debug)]
pub struct ComplementarityArch {
    /// Question as it is understood.
    pub asked: Understood,
    /// The arch.
    pub arch: Arch,
    /// Symmetric state of the arch, or why nothing stands.
    pub symmetric: Result<Answer, Undecided>,
    /// The asymmetric solutions, or why one that is found is not proved.
    pub asymmetric: Vec<Result<AsymmetricDigits, Undecided>>,
    /// All solutions between equal stones, where they are asked for.
    pub enumeration: Option<Result<Enumeration, Undecided>>,
    /// The programme (20), where it is asked for.
    pub programme: Option<AtThickness>,
}

/// Description of the search for solutions, and what is not proved.
const SEARCH: [&str; 5] = [
    "Among symmetric states there is at most one such thickness (couplet prove unique-thickness),",
    "except at the friction of pure sliding. Asymmetric states are sought with three kinds of",
    "mechanisms, along those with a sliding shoulder, from the symmetric one to larger vertical forces",
    "in the crown. What the search finds is proved; that there is nothing else is not: other asymmetric",
    "states may exist. With unlimited friction nothing slides, and none is sought.",
];

/// Meaning of an asymmetric solution.
const MEANING: [&str; 6] = [
    "At an asymmetric thickness the arch has an admissible state, and also a motion in which friction",
    "takes exactly the power that the weight gives. Friction without dilatancy does not forbid this",
    "motion, so that an admissible state alone does not exclude collapse there.",
    "This is said of the model. Below the least thickness no state is admissible, as before, and between",
    "the thicknesses no solution is found.",
    "",
];

/// Statements of what of a solution is proved.
const PROOF: [&str; 3] = [
    "proved: its equations have one solution in a box, which is admissible at every joint of the whole",
    "arch, and every rate is positive",
    "",
];

/// A solution of an arch.
struct Solution<'a> {
    thickness: &'a Figure,
    thrust: &'a Figure,
    mode: &'static str,
    /// Description for a person.
    words: String,
    /// The rest of an asymmetric solution.
    asymmetric: Option<&'a AsymmetricDigits>,
}

impl ComplementarityArch {
    /// Reason why something stays open, if it does.
    pub fn first_open(&self) -> Option<Undecided> {
        let asymmetric = self.asymmetric.iter().find_map(|solution| solution.as_ref().err());
        let programme = self.programme.as_ref().and_then(|of| of.found.as_ref().err());
        let enumeration = self.enumeration.as_ref().and_then(|all| match all {
            Ok(all) => all.first_open(),
            Err(undecided) => Some(undecided.clone()),
        });
        self.symmetric.as_ref().err().or(asymmetric).or(programme).cloned().or(enumeration)
    }

    /// Solutions that are proved, thin arches first.
    fn solutions(&self) -> Vec<Solution<'_>> {
        let symmetric = match &self.symmetric {
            Ok(Answer::Stands(state)) => Some(Solution::symmetric(state)),
            _ => None,
        };
        let proved = self.asymmetric.iter().filter_map(|solution| solution.as_ref().ok());
        let mut all: Vec<Solution<'_>> =
            symmetric.into_iter().chain(proved.map(Solution::asymmetric)).collect();
        all.sort_by(|a, b| a.thickness.double.total_cmp(&b.thickness.double));
        all
    }

    /// Reason why there is no symmetric state.
    fn fall(&self) -> Option<&'static str> {
        match &self.symmetric {
            Ok(Answer::Falls { fall, .. }) => Some(fall.reason()),
            _ => None,
        }
    }

    fn is_asymmetric(&self) -> bool {
        self.asymmetric.iter().any(Result::is_ok)
    }
}

impl<'a> Solution<'a> {
    fn symmetric(state: &'a Digits) -> Self {
        let (mode, Digits { thickness, thrust, .. }) = (state.mode.label(), state);
        let words = format!("symmetric, {mode}: the least thickness");
        Self { thickness, thrust, mode, words, asymmetric: None }
    }

    fn asymmetric(state: &'a AsymmetricDigits) -> Self {
        let (mode, AsymmetricDigits { thickness, thrust, .. }) = (state.mode.name(), state);
        let words = format!("asymmetric: {}", kind(state.mode));
        Self { thickness, thrust, mode, words, asymmetric: Some(state) }
    }
}

pub(super) fn table(all: &[ComplementarityArch], out: &mut dyn io::Write) -> io::Result<()> {
    apart(all, out, one)
}

fn one(of: &ComplementarityArch, out: &mut dyn io::Write) -> io::Result<()> {
    let arch = &of.arch;
    writeln!(out, "Complementarity problem (19) of the whole arch")?;
    writeln!(out, "{}\n", of.asked.with_weight(arch.weight()))?;
    let solutions = of.solutions();
    if !solutions.is_empty() {
        writeln!(out, "it has a solution at the thickness")?;
    }
    for solution in &solutions {
        writeln!(out, "   {}  {}", solution.thickness, solution.words)?;
    }
    if let Some(reason) = of.fall() {
        writeln!(out, "no thickness is enough: {reason}")?;
    }
    if let Err(undecided) = &of.symmetric {
        writeln!(out, "the symmetric state is {undecided}")?;
    }
    for undecided in of.asymmetric.iter().filter_map(|solution| solution.as_ref().err()) {
        writeln!(out, "an asymmetric solution that is found is {undecided}")?;
    }
    for state in solutions.iter().filter_map(|solution| solution.asymmetric) {
        details(state, out)?;
    }
    writeln!(out)?;
    let lines: Vec<&str> = match of.is_asymmetric() {
        true => PROOF.into_iter().chain(MEANING).chain(SEARCH).collect(),
        false if of.asymmetric.is_empty() => {
            ["no asymmetric solution is found", ""].into_iter().chain(SEARCH).collect()
        }
        false => SEARCH.to_vec(),
    };
    lines.into_iter().try_for_each(|line| writeln!(out, "{line}"))?;
    if let Some(all) = &of.enumeration {
        writeln!(out)?;
        match all {
            Ok(all) => jointed::table(all, out)?,
            Err(undecided) => writeln!(out, "the solutions between equal stones are {undecided}")?,
        }
    }
    of.programme.as_ref().map_or(Ok(()), |at| programme::table(at, out))
}

fn details(state: &AsymmetricDigits, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "\nasymmetric at {}; its mirror image is a solution too", state.thickness)?;
    for (name, symbol, figure) in [
        ("thrust", "h = H/(w r)", &state.thrust),
        ("crown_moment", "p", &state.crown_moment),
        ("vertical_force", "v", &state.vertical_force),
        ("power", "w r", &state.power),
    ] {
        writeln!(out, "   {name:<20} {symbol:<12} {figure}")?;
    }
    let angles: Vec<String> = state.joints.iter().map(|joint| joint.angle.to_string()).collect();
    let width = angles.iter().map(String::len).max().unwrap_or(0).max(16);
    writeln!(out, "   {:<22} {:<15} {:<width$}  rate", "joint", "", "angle from crown")?;
    state.joints.iter().zip(&angles).try_for_each(|(joint, angle)| {
        let at = format!("{}, {}", joint.side.name(), joint.place.name());
        writeln!(out, "   {:<22} {at:<15} {angle:<width$}  {}", joint.contact.name(), joint.rate)
    })
}

const COLUMNS: &str = "weight half_opening friction symmetric mode thickness thrust crown_moment \
                       vertical_force stones outcome until least_value least_value_lower";

pub(super) fn csv(all: &[ComplementarityArch], out: &mut dyn io::Write) -> io::Result<()> {
    let rows = all.iter().flat_map(|of| {
        let found = of.solutions().into_iter().map(|solution| {
            let mut row = solved(&solution);
            row.add("outcome", "solution");
            row
        });
        let jointed = of.enumeration.iter().flat_map(jointed::rows);
        let all = found.chain(jointed).chain(of.programme.iter().map(programme::row));
        let row = |mut row: Fields| {
            row.append(given(&of.arch));
            row
        };
        all.map(row).collect::<Vec<_>>()
    });
    csv::table(COLUMNS, rows, out)
}

pub(super) fn json(all: &[ComplementarityArch], out: &mut dyn io::Write) -> io::Result<()> {
    json::write_all(all.iter().map(entry), out)
}

fn given(arch: &Arch) -> Fields {
    let mut fields = Fields::default();
    fields.add("weight", arch.weight().name());
    fields.add("half_opening", arch.half_opening().to_string());
    fields.add("friction", arch.friction().to_string());
    fields
}

fn entry(of: &ComplementarityArch) -> Fields {
    let mut fields = Fields::of("couplet.complementarity/1");
    fields.add_fields("asked", Some(of.asked.fields()));
    fields.append(given(&of.arch));
    fields.add("verdict", if of.first_open().is_some() { "undecided" } else { "proved" });
    fields.add("reason", of.first_open().map(|open| open.reason.to_string()));
    fields.add("fall", of.fall());
    fields.add_list("solutions", of.solutions().iter().map(solved));
    fields.add("search", SEARCH.join(" "));
    if let Some(all) = &of.enumeration {
        fields.add_fields("enumeration", Some(jointed::fields(all)));
    }
    if let Some(at) = &of.programme {
        fields.add_fields("programme", Some(programme::fields(at)));
    }
    fields
}

fn solved(solution: &Solution<'_>) -> Fields {
    let mut fields = Fields::default();
    fields.add("symmetric", solution.asymmetric.is_none());
    fields.add("mode", solution.mode);
    fields.add_bounds("thickness", Some(solution.thickness));
    fields.add_bounds("thrust", Some(solution.thrust));
    if let Some(state) = solution.asymmetric {
        fields.add_bounds("crown_moment", Some(&state.crown_moment));
        fields.add_bounds("vertical_force", Some(&state.vertical_force));
        fields.add_bounds("power", Some(&state.power));
        let joint = |joint: &AsymmetricJoint| {
            let mut fields = Fields::default();
            fields.add("contact", joint.contact.name());
            fields.add("side", joint.side.name());
            fields.add("place", joint.place.name());
            fields.add_bounds("angle", Some(&joint.angle));
            fields.add_bounds("rate", Some(&joint.rate));
            fields
        };
        fields.add_list("joints", state.joints.iter().map(joint));
    }
    fields
}
