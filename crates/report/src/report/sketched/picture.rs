//! The page: panels beside and below each other, a legend, a caption.

use super::Sketched;
use super::caption::{heading, paragraphs};
use super::legend::Legend;
use super::panel::{ABOVE, HEAD, ModePanel};
use super::strip::{self, Strip};
use crate::picture::color::INK;
use crate::picture::{Svg, Type, text};
use crate::sketch::PageScale;

const MARGIN: f64 = 20.0;
/// The width of a panel where there is one in a row, and where there are more.
const WIDTHS: [f64; 3] = [880.0, 620.0, 470.0];
/// The most that an arch is high.
const HEIGHT: f64 = 620.0;
const SMALL: f64 = 15.0;
const GAP: f64 = 16.0;

/// The picture as SVG.
pub(in crate::report) fn picture(report: &Sketched) -> String {
    let panels = ModePanel::all(report);
    let most = if report.between.is_empty() { 2 } else { WIDTHS.len() };
    let columns = panels.len().clamp(1, most);
    let wide = WIDTHS[columns - 1];
    let extents: Vec<[f64; 4]> = panels.iter().map(|panel| panel.view.extent()).collect();
    let hull = extents
        .iter()
        .copied()
        .reduce(|[a, b, c, d], [e, f, g, h]| [a.min(e), b.max(f), c.min(g), d.max(h)]);
    let [left, right, low, high] = hull.unwrap_or([-1.0, 1.0, 0.0, 1.0]);
    let around = panels.iter().map(ModePanel::around);
    let [side, under] = around.fold([0.0, 0.0], |[a, b]: [f64; 2], [c, d]| [a.max(c), b.max(d)]);
    let radius = ((wide - 2.0 * side) / (right - left)).min(HEIGHT / (high - low));
    let strips: Vec<Option<Strip>> =
        panels.iter().map(|panel| Strip::of(panel, radius, report.style.half)).collect();
    let below = if strips.iter().any(Option::is_some) { strip::HEIGHT } else { 0.0 };
    let tall = HEAD + ABOVE + radius * (high - low) + under + below;
    let rows = panels.len().div_ceil(columns);
    let width = 2.0 * MARGIN + columns as f64 * wide;
    let legend = Legend::new(report, width - 2.0 * MARGIN);
    let words = paragraphs(report);
    let wrapped = |words: &String| text::wrap(words, SMALL, width - 2.0 * MARGIN);
    let lines: Vec<String> = words.iter().flat_map(wrapped).collect();
    let bottom = MARGIN + rows as f64 * tall + GAP / 2.0;
    let foot = bottom + legend.height() + GAP;
    let height = foot + lines.len() as f64 * SMALL * text::LEADING + MARGIN;
    let mut svg = Svg::new((width, height), &heading(report), &words.join(" "));
    for (place, panel) in panels.iter().enumerate() {
        let (column, row) = (place % columns, place / columns);
        // A last one that is alone stands in the middle.
        let is_alone = place + 1 == panels.len() && column == 0;
        let x = match is_alone {
            true => (width - wide) / 2.0,
            false => MARGIN + column as f64 * wide,
        };
        let y = MARGIN + row as f64 * tall;
        let centre =
            (x + wide / 2.0 - radius * (left + right) / 2.0, y + HEAD + ABOVE + radius * high);
        let scale = PageScale { center: centre, radius };
        svg.group(&format!("panel-{place}"), |svg| {
            panel.draw(svg, &scale, ((x, y), wide));
            if let Some(strip) = &strips[place] {
                strip.draw(svg, panel, (x + side, y + tall - below), wide - 2.0 * side);
            }
        });
    }
    legend.draw(&mut svg, (MARGIN, bottom), width - 2.0 * MARGIN);
    svg.group("caption", |svg| svg.lines(&lines, (MARGIN, foot), Type::new(SMALL, INK)));
    svg.finish()
}
