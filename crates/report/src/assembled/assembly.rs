//! An assembly of stones as it is written.

use crate::ask::{ArchAsked, Field};
use crate::strategies::{Assembly, Blocks, Margin};

/// Assembly with its bodies, and the name of the question about it.
#[derive(Clone, Debug)]
pub struct Assembled {
    /// Name of the question, and of its files: `001-above`, `001-above-5%`.
    pub id: String,
    pub(super) assembly: Assembly,
    pub(super) blocks: Blocks,
}

impl Assembled {
    /// The assemblies above and below a threshold, the first pair being number 1.
    pub fn pair(number: u64, pair: [Assembly; 2]) -> Option<[Self; 2]> {
        let [above, below] = pair;
        let named = |assembly: Assembly, side| {
            let blocks = Blocks::of(&assembly)?;
            let margin = match assembly.margin == Margin::default() {
                true => String::new(),
                false => format!("-{}", assembly.margin),
            };
            Some(Self { id: format!("{number:03}-{side}{margin}"), assembly, blocks })
        };
        Some([named(above, "above")?, named(below, "below")?])
    }

    /// Unit of the lengths.
    pub(super) fn unit(&self) -> &'static str {
        if self.assembly.surveyed.is_some() { "m" } else { "r" }
    }

    /// Text of the arch.
    pub(super) fn asked(&self) -> ArchAsked {
        let Assembly { stones, friction, thickness_text, surveyed, .. } = &self.assembly;
        let [number, friction, half_opening] =
            [stones.number().to_string(), friction.to_string(), stones.half_opening().to_string()];
        let sizes = match surveyed {
            Some(of) => vec![
                (Field::Span, of.span.as_str()),
                (Field::Rise, &of.rise),
                (Field::MeasuredAt, of.measures.circle().name()),
            ],
            None => vec![(Field::HalfOpening, half_opening.as_str())],
        };
        let others = [
            (Field::Stones, number.as_str()),
            (Field::Friction, &friction),
            (Field::Thickness, thickness_text),
        ];
        ArchAsked::of(sizes.into_iter().chain(others))
    }

    /// The question and its answer in a line, for files that have no place for more.
    pub(super) fn line(&self) -> String {
        let Assembly { friction, weight, .. } = &self.assembly;
        let verdict = if self.assembly.stands() { "stands" } else { "falls" };
        format!("{}: lengths in {}, friction {friction}, {weight}, {verdict}", self.id, self.unit())
    }
}
