//! All arches between two ends: proved together, for an answer of its own or for a row of a table of boxes.

use super::computable::{Computable, Done};
use super::read_arches::given;
use super::schema::SceneSurvey;
use crate::problem::Quantity;
use crate::report::words::list;
use crate::report::{SurveyedArches, SurveyedRows, Understood};
use crate::surveyed::{ranges, surveyed};
use std::sync::Arc;

/// All arches between two ends, and what is told of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct SurveyNode<'s> {
    /// The arches.
    pub survey: &'s SceneSurvey,
    /// Columns, if the arches are a box of which the cells of a table are told.
    pub rows: Option<&'s SurveyedRows>,
    /// Quantities that are told.
    pub quantities: &'s [Quantity],
    /// Significant digits.
    pub digits: usize,
}

impl SurveyNode<'_> {
    /// Answer about all of them as it is, or why the question makes no sense.
    fn found(&self) -> Result<SurveyedArches, String> {
        let Self { survey, quantities, digits, rows } = self;
        let given = given(&survey.asked).map_err(|misfit| misfit.message)?;
        // What to measure better is told of a survey, not of each of its boxes.
        let proof = if rows.is_some() { ranges } else { surveyed };
        let found = proof(&survey.asked, &given, survey.weight, (quantities, *digits));
        found.map_err(|error| error.to_string())
    }

    /// Answer about all of them, or the cells of its row.
    pub(super) fn done(&self) -> Done {
        let found = self.found();
        match self.rows {
            None => Box::new(found.map(Arc::new)),
            Some(rows) => Box::new(found.map(|found| Arc::new(rows.cell(&found)))),
        }
    }
}

impl Computable for SurveyNode<'_> {
    fn key(&self) -> String {
        format!("{self:?}")
    }

    fn lines(&self) -> Vec<String> {
        let Self { survey, quantities, digits, .. } = self;
        let words = given(&survey.asked).map(|given| Understood::of_ranges(&survey.asked, &given));
        let words = words.map_or(String::new(), |words| words.in_words().to_owned());
        let names = list(quantities.iter().map(|quantity| quantity.name()));
        vec![
            format!("every arch of {words}, {}", survey.weight.name()),
            format!("to {digits} digits: {names}"),
        ]
    }
}
