//! Answers of one kind, with what a report shows of them.

use super::answer::Answer;
use super::subject::Subject;
use super::words::{DOUBLE_DIGITS, distinct};
use crate::problem::Quantity;

/// The program and its version.
pub const TOOL: &str = concat!("couplet ", env!("CARGO_PKG_VERSION"));

/// Scope of answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Landmarks with their constants.
    Constants,
    /// One landmark, with the modes that meet there.
    Point,
    /// One arch.
    Arch,
    /// Many arches.
    Arches,
    /// Many arches, some of which have a thickness.
    Mixed,
    /// Values found the other way round.
    Found,
}

/// Answers of one kind.
#[derive(Clone, Debug)]
pub struct Answers {
    /// Scope of the answers.
    pub scope: Scope,
    /// Significant digits of each value.
    pub digits: usize,
    /// The quantities of an arch that are shown, of [`Quantity::STATE`] or of [`Quantity::ASSESSMENT`]; a
    /// landmark has those that were computed.
    pub quantities: Vec<Quantity>,
    /// The answers in the order in which they are shown.
    pub list: Vec<Answer>,
    /// The names of what is handed on from queries, where the rows are those of one table.
    pub kept: Vec<String>,
}

impl Answers {
    /// Answers of a scope, of which these quantities are shown.
    pub fn of(scope: Scope, digits: usize, quantities: Vec<Quantity>, list: Vec<Answer>) -> Self {
        Self { scope, digits, quantities, list, kept: Vec::new() }
    }

    /// Answers of landmarks.
    pub fn constants(digits: usize, list: Vec<Answer>) -> Self {
        Self::of(Scope::Constants, digits, Vec::new(), list)
    }

    /// Answers of one arch, with all that was found.
    pub fn arch(digits: usize, answer: Answer) -> Self {
        let quantities = Quantity::of_arch(answer.subject.is_assessed(), None);
        Self::of(Scope::Arch, digits, quantities, vec![answer])
    }

    /// Answers of many arches, with every quantity and no answers yet; `assessed` if they have a thickness.
    pub fn arches(digits: usize, assessed: bool) -> Self {
        Self::of(Scope::Arches, digits, Quantity::of_arch(assessed, None), Vec::new())
    }

    /// Answers of many arches, some of which have a thickness: in a table the least thickness is in one
    /// column, whatever was asked.
    pub fn mixed(digits: usize) -> Self {
        let state = Quantity::STATE.into_iter().filter(|of| *of != Quantity::Thickness);
        let quantities = Quantity::ASSESSMENT.into_iter().chain(state).collect();
        Self::of(Scope::Mixed, digits, quantities, Vec::new())
    }

    /// Answers of many arches as they come, with only some of the quantities.
    pub fn only(self, quantities: &[Quantity]) -> Self {
        let shown = |of: &Quantity| match (self.scope, of) {
            (Scope::Mixed, Quantity::Thickness) => Quantity::LeastThickness,
            _ => *of,
        };
        Self { quantities: distinct(quantities.iter().map(shown)), ..self }
    }

    /// Tells whether any of the arches may have a thickness.
    pub fn have_assessments(&self) -> bool {
        self.have(&Quantity::ASSESSMENT, true)
    }

    /// Tells whether any of the arches may have none.
    pub fn have_states(&self) -> bool {
        self.have(&Quantity::STATE, false)
    }

    fn have(&self, some: &[Quantity], assessed: bool) -> bool {
        let is_one = |answer: &Answer| {
            matches!(answer.subject, Subject::Arch { .. })
                && answer.subject.is_assessed() == assessed
        };
        self.scope == Scope::Mixed
            || self.quantities.iter().any(|of| some.contains(of))
            || self.list.iter().any(is_one)
    }

    /// Tells whether each arch has a row in a table for a paper.
    pub(super) fn has_row_each(&self) -> bool {
        matches!(self.scope, Scope::Arch | Scope::Arches)
    }

    /// Tells whether there is a row for each of many arches.
    pub(super) fn are_many(&self) -> bool {
        matches!(self.scope, Scope::Arches | Scope::Mixed)
    }

    /// Tells whether the arches are measured.
    pub(super) fn are_measured(&self) -> bool {
        self.quantities.iter().any(|quantity| quantity.is_measured())
    }

    /// Tells whether a quantity of an arch is shown; in a mixed table the thickness of a state is the least.
    pub(super) fn shows(&self, quantity: Quantity) -> bool {
        let is_least = quantity == Quantity::Thickness && self.have_assessments();
        self.quantities.contains(if is_least { &Quantity::LeastThickness } else { &quantity })
    }

    /// Tells whether the nearest double of each value is shown too.
    pub(super) fn have_doubles(&self) -> bool {
        self.digits == DOUBLE_DIGITS
    }

    /// The subject in a few words.
    pub(super) fn title(&self) -> &'static str {
        match self.scope {
            Scope::Constants | Scope::Point => {
                "Landmark constants of the finite-friction Couplet-Heyman problem"
            }
            Scope::Arch | Scope::Arches | Scope::Mixed | Scope::Found => {
                "States of circular masonry arches of finite friction"
            }
        }
    }

    /// The schema of the document that lists each value.
    pub(super) fn schema(&self) -> &'static str {
        match self.scope {
            Scope::Constants | Scope::Point => "couplet.constants/1",
            Scope::Arch | Scope::Arches | Scope::Mixed | Scope::Found => "couplet.states/2",
        }
    }
}
