//! What holds for items that say nothing else.

use super::schema::DIGITS;
use super::value::Reader;
use crate::arch::SelfWeight;
use crate::certify::MAX_DIGITS;
use toml::de::DeTable;

/// What holds for items that say nothing else.
pub(super) struct Overall {
    /// Significant digits.
    pub digits: usize,
    weights: Option<Vec<SelfWeight>>,
}

impl Overall {
    /// What a scene says.
    pub(super) fn new(reader: &mut Reader, root: &DeTable) -> Self {
        let digits =
            root.get("digits").and_then(|value| reader.whole("digits", value, 1..=MAX_DIGITS));
        Self { digits: digits.unwrap_or(DIGITS), weights: weights(reader, root).flatten() }
    }

    /// The weights of an item: its own, those of the scene, or the usual ones. `None` if any is wrong.
    pub(super) fn weights(
        &self,
        reader: &mut Reader,
        item: &DeTable,
        usual: &[SelfWeight],
    ) -> Option<Vec<SelfWeight>> {
        let own = weights(reader, item)?;
        Some(own.or_else(|| self.weights.clone()).unwrap_or(usual.to_vec()))
    }
}

/// The weights that a table names, if it does.
pub(super) fn weights(reader: &mut Reader, table: &DeTable) -> Option<Option<Vec<SelfWeight>>> {
    let names = SelfWeight::ALL.map(|weight| (weight.name(), weight));
    match table.get("weight") {
        Some(value) if value.get_ref().as_str() == Some("both") => {
            Some(Some(SelfWeight::ALL.to_vec()))
        }
        Some(value) => reader.names("weight", value, &names).map(Some),
        None => Some(None),
    }
}
