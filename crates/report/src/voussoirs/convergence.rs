//! Arches of ever more stones: rows for a person, and a figure.

use super::arch::{VoussoirArch, VoussoirArches};
use crate::picture::figure::{Axis, Figure, Kind, Panel, PlottedLine, Scale};
use crate::words::{apart, model, padded};
use std::io;

/// The arches of each weight, in the order in which they come.
fn groups(VoussoirArches { arches, .. }: &VoussoirArches) -> Vec<&[VoussoirArch]> {
    arches.chunk_by(|a, b| a.weight == b.weight).collect()
}

/// Title of a group of arches.
fn title(arches: &[VoussoirArch]) -> String {
    let (first, friction) = (&arches[0], &arches[0].friction);
    let (alpha, weight) = (first.stones.half_opening(), model(first.weight));
    format!("half opening {alpha}, friction {friction}, {weight}")
}

/// A row for each number of stones.
pub(super) fn rows(all: &VoussoirArches, out: &mut dyn io::Write) -> io::Result<()> {
    apart(groups(all), out, |arches, out| {
        let (first, last) = (arches[0].stones.number(), arches[arches.len() - 1].stones.number());
        writeln!(out, "Arches of {first} to {last} equal stones, {}\n", title(arches))?;
        let text = |arch: &VoussoirArch| match arch.state() {
            Some(state) => state.thickness.to_string(),
            None => arch.outcome().replace('_', " "),
        };
        let width = arches.iter().map(|arch| text(arch).len()).max().unwrap_or(0).max(15);
        let line = |stones: &str, mode: &str, thickness: &str, loss: [&str; 2]| {
            let ([loss, share], thickness) = (loss, padded(thickness, width));
            let line = format!("{stones:>10}  {mode:<8} {thickness}  {loss:<12} {share}");
            line.trim_end().to_owned()
        };
        let names = line("stones", "mode", "least thickness", ["loss", "relative loss"]);
        writeln!(out, "{names}")?;
        for arch in arches {
            let loss = arch.loss.as_ref();
            let share = loss.map_or(String::new(), |loss| loss.share.value.to_string());
            let loss = loss.map_or(String::new(), |loss| loss.thickness.value.to_string());
            let mode = arch.state().map_or("", |state| state.mode.label());
            let row = line(&arch.stones.number().to_string(), mode, &text(arch), [&loss, &share]);
            writeln!(out, "{row}")?;
        }
        if let Some(continuous) = &arches[0].continuous {
            writeln!(out, "{}", line("all", "", &continuous.to_string(), ["", ""]))?;
        }
        let proved = arches.iter().filter(|arch| arch.found.is_ok()).count();
        let all = arches.len();
        writeln!(
            out,
            "\nproved: {proved} of {all}; all: a joint at every angle; loss: what so many stones need less"
        )
    })
}

/// The words below the figure.
pub(super) fn words(all: &VoussoirArches) -> Vec<String> {
    let arches: Vec<String> = groups(all).into_iter().map(title).collect();
    vec![
        format!(
            "By which share of the thickness arches of n equal stones need less than with a joint at every angle: {}. \
             Each share is proved. Odd numbers have a keystone, even ones a joint at the crown; the dashed line goes \
             through the largest n² times its share that is shown.",
            arches.join("; ")
        ),
        format!("Command: {}", all.command),
    ]
}

/// The share of the thickness that is lost, over the number of stones: both logarithmic, odd and even numbers apart.
pub(super) fn figure(all: &VoussoirArches) -> Figure {
    let panel = |arches: &[VoussoirArch]| {
        let share = |arch: &VoussoirArch| {
            let share: f64 = arch.loss.as_ref()?.share.value.to_string().parse().ok()?;
            Some((arch.stones.number() as f64, share))
        };
        let points = |keystone: bool| -> Vec<(f64, f64)> {
            let those = |arch: &&VoussoirArch| arch.stones.has_joint_at_crown() != keystone;
            arches.iter().filter(those).filter_map(share).collect()
        };
        let [odd, even] = [true, false].map(points);
        let all = || odd.iter().chain(&even);
        let most = all().map(|(n, share)| share * n * n).fold(0.0, f64::max);
        let ends = [f64::min as fn(f64, f64) -> f64, f64::max];
        let ends = ends.map(|end| all().map(|point| point.0).reduce(end).unwrap_or(1.0));
        let bound = ends.map(|n| (n, most / (n * n))).to_vec();
        let line = |label: String, points, kind| PlottedLine { label, points, kind };
        Panel {
            title: title(arches),
            x: Axis { label: "number n of stones".into(), scale: Scale::Log10 },
            y: Axis { label: "share of the thickness".into(), scale: Scale::Log10 },
            lines: vec![
                line("odd n".into(), odd, Kind::Points),
                line("even n".into(), even, Kind::Points),
                line(format!("{most:.2}/n²"), bound, Kind::Reference),
            ],
        }
    };
    let panels = groups(all).into_iter().map(panel).collect();
    Figure { title: "The least thickness of arches of n stones".into(), panels, columns: 1 }
}
