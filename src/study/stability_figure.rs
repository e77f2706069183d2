//! The figure of the study of stability, from its rungs.

use super::limits::LIMITS;
use super::stability::Rung;
use crate::picture::figure::{Axis, Figure, Kind, Line, Panel, Scale};

/// Digits lost against the distance, a panel for each limit, with the loss of the problem itself.
pub fn figure(rungs: &[Rung]) -> Figure {
    let panels = LIMITS.iter().filter_map(|limit| {
        let here: Vec<&Rung> = rungs.iter().filter(|rung| rung.limit == limit.name).collect();
        let first = here.first()?;
        let mut methods: Vec<&str> = Vec::new();
        for rung in &here {
            if !methods.contains(&rung.method) {
                methods.push(rung.method);
            }
        }
        let distance = |rung: &Rung| f64::from(rung.distance_log10);
        let mut lines: Vec<Line> = methods
            .into_iter()
            .map(|method| {
                let points = here.iter().filter(|rung| rung.method == method);
                let lost = |rung: &&&Rung| (distance(rung), rung.digits_lost.unwrap_or(f64::NAN));
                Line {
                    label: method.to_owned(),
                    points: points.map(|rung| lost(&rung)).collect(),
                    // Few distances, far apart: a line between them would invent values.
                    kind: Kind::Points,
                }
            })
            .collect();
        let mut own: Vec<(f64, f64)> =
            here.iter().map(|rung| (distance(rung), rung.condition_log10.max(0.0))).collect();
        own.dedup();
        lines.push(Line {
            label: "by the problem itself".into(),
            points: own,
            kind: Kind::Reference,
        });
        Some(Panel {
            title: format!("{}, {} ({})", first.output.replace('_', " "), limit.words, limit.name),
            x: Axis { label: "distance from the limit".into(), scale: Scale::Approach },
            y: Axis { label: "decimal digits lost".into(), scale: Scale::Linear },
            lines,
        })
    });
    Figure { title: "Digits lost towards each limit".into(), panels: panels.collect(), columns: 2 }
}
