//! Arches of voussoirs as CSV: a row for each.

use super::arch::{VoussoirArches, stones};
use super::given;
use crate::certify::state::Figure;
use crate::report::csv;
use std::io;

pub(crate) fn csv(
    VoussoirArches { arches, .. }: &VoussoirArches,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let header =
        ["weight", "half_opening", "stones", "friction", "outcome", "mode"].map(str::to_owned);
    let names = [
        "thickness",
        "thrust",
        "rotation_joint",
        "sliding_joint",
        "continuous_thickness",
        "loss",
        "relative_loss",
        "may_move",
    ];
    let names = names.map(str::to_owned);
    let rows = arches.iter().map(|arch| {
        let given = [
            arch.weight.name().to_owned(),
            arch.stones.half_opening().to_string(),
            stones(arch).unwrap_or_default(),
            arch.friction.clone(),
        ];
        let mode = arch.state().map_or("", |state| state.mode.label());
        let found = [arch.outcome().to_owned(), mode.to_owned()];
        let text = |figure: Option<&Figure>| figure.map_or(String::new(), ToString::to_string);
        let figures = arch.figures().into_iter().map(|(_, figure)| text(figure));
        let continuous = text(arch.continuous.as_ref());
        let loss = arch
            .loss
            .as_ref()
            .map(|loss| [&loss.thickness, &loss.share].map(|x| x.value.to_string()));
        let loss = loss.unwrap_or_default();
        let assessed = arch.given.iter().flat_map(|given| given::cells(arch, given));
        given
            .into_iter()
            .chain(found)
            .chain(figures)
            .chain([continuous])
            .chain(loss)
            .chain([arch.may_move().to_string()])
            .chain(assessed)
            .collect()
    });
    let is_assessed = arches.iter().any(|arch| arch.given.is_some());
    let assessed = given::COLUMNS.iter().filter(|_| is_assessed).map(|name| (*name).to_owned());
    let header = header.into_iter().chain(names).chain(assessed).collect();
    csv::write(std::iter::once(header).chain(rows), out)
}
