//! The arguments that describe an arch.

use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Spelling};
use crate::problem::Arch;
use crate::problem::measures::Measures;
use crate::report::{Format, Understood};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use clap::Args;

/// An arch, all of it exact: `0.1` is one tenth, `80deg` and `pi/2` are what they say.
#[derive(Args)]
pub(super) struct ArchArguments {
    #[command(flatten)]
    pub asked: ArchAsked,

    /// Self-weight model: heyman, milankovitch or both.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weights)]
    pub weight: Weights,

    /// Significant digits, 1 to 1000000, to which values are correctly rounded; if not given 30, of metres, kN and
    /// ranges 6, as of all that a table tells of an arch in metres.
    #[arg(long, value_parser = parse::digits, allow_negative_numbers = true)]
    digits: Option<usize>,
}

/// Significant digits of the ends of ranges, if none are asked for.
pub(super) const RANGE_DIGITS: usize = 6;

impl ArchArguments {
    /// Significant digits of ratios.
    pub(super) fn digits(&self) -> usize {
        self.digits.unwrap_or(30)
    }

    /// Significant digits of what is told of an arch that is given: to who builds in metres, more than six say nothing.
    pub(super) fn digits_of(&self, given: &ArchGiven, format: &Format) -> usize {
        let is_for_who_builds = given.measures.is_some() && format.is_for_people();
        self.digits.unwrap_or(if is_for_who_builds { 6 } else { 30 })
    }

    /// Significant digits of the ends of ranges.
    pub(super) fn range_digits(&self) -> usize {
        self.digits.unwrap_or(RANGE_DIGITS)
    }

    /// Measures, with the significant digits of sizes.
    pub(super) fn measures<'g>(&self, given: &'g ArchGiven) -> Option<(&'g Measures, usize)> {
        Some((given.measures.as_ref()?, self.digits.unwrap_or(6)))
    }

    /// Arches that a question is about, one for each self-weight asked for, with what else is given.
    pub(super) fn read(&self, question: &ArchQuestion) -> Result<(ArchGiven, Vec<Arch>), Failure> {
        let given = ArchGiven::read(question, &self.asked, Spelling::Option)?;
        let arches: Result<_, _> =
            self.weight.iter().copied().map(|weight| given.arch(weight)).collect();
        Ok((given, arches?))
    }

    /// The question as it is understood.
    pub(super) fn understood(&self, given: &ArchGiven) -> Understood {
        Understood::new(&self.asked, given)
    }

    /// The self-weight, if it is one.
    pub(super) fn one_weight(&self) -> Result<SelfWeight, Failure> {
        match self.weight {
            &[weight] => Ok(weight),
            _ => Err("a picture shows one weight: give --weight a name".into()),
        }
    }
}
