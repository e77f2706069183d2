//! The two self-weights compared at the landmarks of the map.

use super::landmark::title;
use super::names::{module, symbol, symbols};
use super::template::fill;
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::judge::{Comparison, Relation, compare_weights};
use crate::problem::Landmark;

/// The file of the comparisons, one theorem for each landmark.
pub(super) fn file() -> Result<String, Undecided> {
    let comparisons = compare_weights()?;
    let mut landmarks: Vec<Landmark> = comparisons.iter().map(|c| c.landmark).collect();
    landmarks.dedup();
    let mut out = include_str!("templates/weights.v").to_owned();
    for landmark in landmarks {
        let claims = comparisons.iter().filter(|c| c.landmark == landmark).filter_map(claim);
        let symbols = symbols(&landmark.system(SelfWeight::Heyman));
        let others: Vec<String> = symbols.iter().map(|x| format!("{x}'")).collect();
        let values = [
            ("title", title(landmark)),
            ("name", landmark.name().replace(' ', "_")),
            ("args", symbols.join(" ")),
            ("others", others.join(" ")),
            ("heyman", module(landmark, SelfWeight::Heyman)),
            ("milankovitch", module(landmark, SelfWeight::Milankovitch)),
            ("claims", claims.collect::<Vec<_>>().join(" /\\ ")),
        ];
        out.push_str(&fill(include_str!("templates/weight.v"), &values));
    }
    Ok(out)
}

/// Claim that is certified, if the quantity is one of the variables.
fn claim(comparison: &Comparison) -> Option<String> {
    let unknown = comparison.quantity.variable()?;
    comparison.landmark.system(SelfWeight::Heyman).index(unknown)?;
    let x = symbol(unknown);
    Some(match comparison.certified {
        Relation::Lower => format!("{x}' < {x}"),
        Relation::Equal => format!("{x}' = {x}"),
        Relation::Higher => format!("{x} < {x}'"),
    })
}
