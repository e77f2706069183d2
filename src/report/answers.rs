//! Answers of one kind, with what a report shows of them.

use super::answer::{Answer, Subject};
use super::words::DOUBLE_DIGITS;
use crate::problem::Quantity;

/// The program and its version.
pub(super) const TOOL: &str = concat!("couplet ", env!("CARGO_PKG_VERSION"));

/// What answers are of.
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
}

/// Answers of one kind.
#[derive(Clone, Debug)]
pub struct Answers {
    /// What they are of.
    pub scope: Scope,
    /// Significant digits of each value.
    pub digits: usize,
    /// The quantities of an arch that are shown, of [`Quantity::STATE`] or of [`Quantity::ASSESSMENT`]; a
    /// landmark has those that were computed.
    pub quantities: Vec<Quantity>,
    /// The answers in the order in which they are shown.
    pub list: Vec<Answer>,
}

impl Answers {
    /// Of landmarks.
    pub fn constants(digits: usize, list: Vec<Answer>) -> Self {
        Self { scope: Scope::Constants, digits, quantities: Vec::new(), list }
    }

    /// Of one landmark, with the modes that meet there.
    pub fn point(digits: usize, answer: Answer) -> Self {
        Self { scope: Scope::Point, digits, quantities: Vec::new(), list: vec![answer] }
    }

    /// Of one arch, with all that was found.
    pub fn arch(digits: usize, answer: Answer) -> Self {
        let assessed = matches!(&answer.subject, Subject::Arch { thickness: Some(_), .. });
        Self { scope: Scope::Arch, list: vec![answer], ..Self::arches(digits, assessed) }
    }

    /// Of many arches, with every quantity and no answers yet; `assessed` if they have a thickness.
    pub fn arches(digits: usize, assessed: bool) -> Self {
        let quantities = match assessed {
            true => Quantity::ASSESSMENT.to_vec(),
            false => Quantity::STATE.to_vec(),
        };
        Self { scope: Scope::Arches, digits, quantities, list: Vec::new() }
    }

    /// Whether the arches have a thickness.
    pub fn are_assessed(&self) -> bool {
        self.quantities.iter().any(|quantity| Quantity::ASSESSMENT.contains(quantity))
    }

    /// Whether the nearest double of each value is shown too.
    pub(super) fn have_doubles(&self) -> bool {
        self.digits == DOUBLE_DIGITS
    }

    /// The subject in a few words.
    pub(super) fn title(&self) -> &'static str {
        match self.scope {
            Scope::Constants | Scope::Point => {
                "Landmark constants of the finite-friction Couplet-Heyman problem"
            }
            Scope::Arch | Scope::Arches => "States of circular masonry arches of finite friction",
        }
    }

    /// The schema of the document that lists each value.
    pub(super) fn schema(&self) -> &'static str {
        match self.scope {
            Scope::Constants | Scope::Point => "couplet.constants/1",
            Scope::Arch | Scope::Arches => "couplet.states/1",
        }
    }
}
