//! The figure of the study of stability, from its rungs.

use super::accuracy_figures::distinct;
use super::limits::LIMITS;
use super::stability::Rung;
use couplet_draw::picture::figure::{Axis, Figure, Kind, Panel, PlottedLine, Scale};
use std::f64::consts::LOG10_2;

/// Digits that the problem leaves to who computes in doubles: those of a double, less the loss of the problem itself.
fn left_in_doubles(rung: &Rung) -> f64 {
    (53.0 * LOG10_2 - rung.condition_log10.max(0.0)).max(0.0)
}

/// Correct digits of a rung: no more than its precision has, and those that are proved of a certified one.
fn digits_left(rung: &Rung) -> Option<f64> {
    Some(f64::from(rung.working_bits) * LOG10_2 - rung.digits_lost?)
}

/// Correct digits left against the distance, a panel for each limit, with those that the problem leaves to doubles.
/// A method without a value has a mark at no digit.
pub fn figure(rungs: &[Rung]) -> Figure {
    let panels = LIMITS.iter().filter_map(|limit| {
        let here: Vec<&Rung> = rungs.iter().filter(|rung| rung.limit == limit.name).collect();
        let first = here.first()?;
        let distance = |rung: &Rung| f64::from(rung.distance_log10);
        let mut lines: Vec<PlottedLine> = Vec::new();
        for method in distinct(&here, |rung| rung.method) {
            let of_method = || here.iter().filter(|rung| rung.method == method);
            let left = of_method().map(|rung| (distance(rung), digits_left(rung)));
            let (known, none): (Vec<_>, Vec<_>) = left.partition(|(_, digits)| digits.is_some());
            let points = known.into_iter().map(|(x, y)| (x, y.unwrap_or(f64::NAN)));
            let none = none.into_iter().map(|(x, _)| (x, 0.0));
            let line = |kind, points| PlottedLine { label: method.to_owned(), points, kind };
            // Few distances, far apart: a line between them would invent values.
            lines.push(line(Kind::Points, points.collect()));
            lines.push(line(Kind::Failures, none.collect()));
        }
        let mut own: Vec<(f64, f64)> =
            here.iter().map(|rung| (distance(rung), left_in_doubles(rung))).collect();
        own.dedup();
        lines.push(PlottedLine {
            label: "what the problem leaves to doubles".into(),
            points: own,
            kind: Kind::Reference,
        });
        Some(Panel {
            title: format!("{}, {} ({})", first.output.replace('_', " "), limit.words, limit.name),
            x: Axis { label: "distance from the limit".into(), scale: Scale::Approach },
            y: Axis { label: "correct digits left".into(), scale: Scale::Linear },
            lines,
        })
    });
    Figure {
        title: "Correct digits left towards each limit; certified: those that are proved, 16 asked for; crossed \
                rings: no value"
            .into(),
        panels: panels.collect(),
        columns: 2,
    }
}
