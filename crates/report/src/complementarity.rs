//! Solutions of the complementarity problem (19) of an arch, `couplet.complementarity/1`.

use super::jointed;
use super::programme::{self, AtThickness};
use super::record::{Record, Symbol};
use super::reported::Reported;
use super::tabular::Tabular;
use super::understood::Understood;
use super::words::{kind, padded};
use crate::certify::state::{Answer, Digits, Figure};
use crate::certify::{AsymmetricDigits, AsymmetricJoint, AsymmetricSolutions, Undecided};
use crate::problem::{Arch, Extent};
use couplet_stones::Enumeration;

/// An arch with the solutions that are found.
#[derive(Debug)]
pub struct ComplementarityArch {
    /// Question as it is understood.
    pub asked: Understood,
    /// The arch.
    pub arch: Arch,
    /// Joints at which the conditions hold, and what is found there.
    pub found: SolutionsFound,
}

/// Solutions of one arch: an arch of stones is another than that with a joint at every angle.
#[derive(Debug)]
pub enum SolutionsFound {
    /// Solutions with a joint at every angle.
    Continuous {
        /// Symmetric state of the arch, or why nothing stands.
        symmetric: Result<Answer, Undecided>,
        /// The asymmetric solutions.
        asymmetric: AsymmetricSolutions,
    },
    /// All solutions between equal stones.
    Stones {
        /// The stones of the whole arch.
        stones: u64,
        /// States that are looked at.
        extent: Extent,
        /// The solutions, or why nothing is known.
        all: Result<Enumeration, Undecided>,
    },
    /// The programme (20) between equal stones.
    Programme(AtThickness),
}

/// Description of how many solutions there are.
const NUMBER: [&str; 4] = [
    "Among symmetric states there is at most one such thickness (couplet prove unique-thickness),",
    "except at the friction of pure sliding. Asymmetric states have mechanisms of three kinds, in arches",
    "of more than 90 degrees only: at the most one with Milankovitch's weight, and two with Heyman's",
    "(couplet prove asymmetric-number).",
];
/// Conclusion where as many asymmetric solutions are found as the arch can have.
const ARE_ALL: [&str; 1] = ["It is proved that this arch has no other solution."];
/// Conclusion elsewhere.
const MAY_BE_OTHERS: [&str; 2] = [
    "They are sought along those with a sliding shoulder, from the symmetric one to larger vertical",
    "forces in the crown. What is found is proved; that there is no other solution is not.",
];
/// Conclusion where nothing slides.
const NOTHING_SLIDES: [&str; 1] = ["With unlimited friction nothing slides, and none is sought."];

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
        match &self.found {
            SolutionsFound::Continuous { symmetric, asymmetric } => {
                let asymmetric =
                    asymmetric.found.iter().find_map(|solution| solution.as_ref().err());
                symmetric.as_ref().err().or(asymmetric).cloned()
            }
            SolutionsFound::Stones { all: Ok(all), .. } => all.first_open(),
            SolutionsFound::Stones { all: Err(undecided), .. } => Some(undecided.clone()),
            SolutionsFound::Programme(of) => of.found.as_ref().err().cloned(),
        }
    }

    /// Solutions with a joint at every angle that are proved, thin arches first.
    fn solutions(&self) -> Vec<Solution<'_>> {
        let SolutionsFound::Continuous { symmetric, asymmetric } = &self.found else {
            return Vec::new();
        };
        let symmetric = match symmetric {
            Ok(Answer::Stands(state)) => Some(Solution::symmetric(state)),
            _ => None,
        };
        let proved = asymmetric.found.iter().filter_map(|solution| solution.as_ref().ok());
        let mut all: Vec<Solution<'_>> =
            symmetric.into_iter().chain(proved.map(Solution::asymmetric)).collect();
        all.sort_by(|a, b| a.thickness.double.total_cmp(&b.thickness.double));
        all
    }

    /// The record of the solutions with a joint at every angle.
    fn continuous(
        &self,
        symmetric: &Result<Answer, Undecided>,
        asymmetric: &AsymmetricSolutions,
        record: &mut Record,
    ) {
        let fall = match symmetric {
            Ok(Answer::Falls { fall, .. }) => Some(fall.reason()),
            _ => None,
        };
        record.add("fall", fall);
        let solutions = self.solutions();
        if !solutions.is_empty() {
            record.say("it has a solution at the thickness");
        }
        record.say_all(solutions.iter().map(|of| format!("   {}  {}", of.thickness, of.words)));
        record.say_all(fall.map(|reason| format!("no thickness is enough: {reason}")));
        let undecided = symmetric.as_ref().err();
        record.say_all(undecided.map(|undecided| format!("the symmetric state is {undecided}")));
        let undecided = asymmetric.found.iter().filter_map(|solution| solution.as_ref().err());
        record.say_all(undecided.map(|of| format!("an asymmetric solution that is found is {of}")));
        record.add_list("solutions", solutions.iter().map(solved));
        record.say("");
        let are_all = symmetric.is_ok() && asymmetric.are_all;
        if asymmetric.found.is_empty() {
            let words = if asymmetric.are_all {
                "there is no asymmetric solution"
            } else {
                "no asymmetric solution is found"
            };
            record.say_all([words, ""]);
        } else if asymmetric.found.iter().any(Result::is_ok) {
            record.say_all(PROOF.into_iter().chain(MEANING));
        }
        let conclusion = match (are_all, self.arch.is_limited()) {
            (true, _) => &ARE_ALL[..],
            (false, true) => &MAY_BE_OTHERS,
            (false, false) => &NOTHING_SLIDES,
        };
        let search = [&NUMBER[..], conclusion].concat();
        record.say_all(search.iter().copied());
        record.add("search", search.join(" "));
        record.add("complete", are_all);
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

impl Reported for ComplementarityArch {
    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.complementarity/1");
        let extent = match &self.found {
            SolutionsFound::Continuous { .. } => Extent::Whole,
            SolutionsFound::Stones { extent, .. } => *extent,
            SolutionsFound::Programme(of) => of.extent,
        };
        let extent = jointed::extent(extent);
        record.say(format!("Complementarity problem (19) of the {extent} arch"));
        record.say(format!("{}\n", self.asked.with_weight(self.arch.weight())));
        self.asked.add_to(&mut record);
        record.add_arch(&self.arch);
        let open = self.first_open();
        record.add("verdict", if open.is_some() { "undecided" } else { "proved" });
        record.add("reason", open.map(|open| open.reason.to_string()));
        match &self.found {
            SolutionsFound::Continuous { symmetric, asymmetric } => {
                self.continuous(symmetric, asymmetric, &mut record);
            }
            SolutionsFound::Stones { all, .. } => {
                record.add_record("enumeration", Some(jointed::record(all)));
            }
            SolutionsFound::Programme(of) => {
                record.add_record("programme", Some(programme::record(of)));
            }
        }
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let rows = match &self.found {
            SolutionsFound::Continuous { .. } => {
                let row = |solution: &Solution<'_>| {
                    let mut row = solved(solution);
                    row.add("outcome", "solution");
                    row
                };
                self.solutions().iter().map(row).collect()
            }
            SolutionsFound::Stones { stones, all, .. } => jointed::rows(*stones, all),
            SolutionsFound::Programme(of) => vec![programme::row(of)],
        };
        let row = |mut row: Record| {
            row.add_arch(&self.arch);
            row.note(self.asked.note());
            row
        };
        let columns = "weight half_opening friction symmetric mode thickness thrust crown_moment vertical_force stones \
                       outcome until least_value least_value_lower";
        Tabular::of(columns, rows.into_iter().map(row))
    }
}

fn solved(solution: &Solution<'_>) -> Record {
    let mut record = Record::default();
    record.add("symmetric", solution.asymmetric.is_none());
    record.add("mode", solution.mode);
    record.add_bounds("thickness", Some(solution.thickness));
    let Some(state) = solution.asymmetric else {
        record.add_bounds("thrust", Some(solution.thrust));
        return record;
    };
    record.say(format!("\nasymmetric at {}; its mirror image is a solution too", state.thickness));
    for (name, text, figure) in [
        ("thrust", "h = H/(w r)", &state.thrust),
        ("crown_moment", "p", &state.crown_moment),
        ("vertical_force", "v", &state.vertical_force),
        ("power", "w r", &state.power),
    ] {
        record.show_as(name, Symbol { text, width: 12, name_width: 20 }, &figure.decimal);
    }
    let angles: Vec<String> = state.joints.iter().map(|joint| joint.angle.to_string()).collect();
    let width = angles.iter().map(String::len).max().unwrap_or(0).max(16);
    let heading = padded("angle from crown", width);
    record.say(format!("   {:<22} {:<15} {heading}  rate", "joint", ""));
    let joint = |(joint, angle): (&AsymmetricJoint, &String)| {
        let mut record = Record::default();
        let (contact, at) =
            (joint.contact.name(), format!("{}, {}", joint.side.name(), joint.place.name()));
        record.say(format!("   {contact:<22} {at:<15} {}  {}", padded(angle, width), joint.rate));
        record.add("contact", contact);
        record.add("side", joint.side.name());
        record.add("place", joint.place.name());
        record.add_bounds("angle", Some(&joint.angle));
        record.add_bounds("rate", Some(&joint.rate));
        record
    };
    record.add_list("joints", state.joints.iter().zip(&angles).map(joint));
    record
}
