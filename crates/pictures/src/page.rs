//! The page: panels beside and below each other, a legend, a caption.

use super::Sketched;
use super::beside::Beside;
use super::caption::{heading, paragraphs};
use super::legend::Legend;
use super::panel::{ABOVE, ModePanel};
use super::strip::{self, Strip};
use crate::picture::color::INK;
use crate::picture::{Print, Svg, Type, text};
use crate::sketch::PageScale;
use std::io;

const MARGIN: f64 = 20.0;
/// The width of a panel where there is one in a row, and where there are more.
const WIDTHS: [f64; 3] = [880.0, 620.0, 470.0];
/// The least width of an arch, and what it has in a panel beside another.
const LEAST: f64 = 130.0;
const BESIDE: f64 = 240.0;
/// The most that an arch is high.
const HEIGHT: f64 = 620.0;
const SMALL: f64 = 15.0;
const GAP: f64 = 16.0;

/// The picture as SVG.
pub(crate) fn picture(report: &Sketched, print: &Print) -> io::Result<String> {
    let panels = ModePanel::all(report);
    let under = panels.iter().map(ModePanel::under).fold(0.0, f64::max);
    let extents: Vec<[f64; 4]> = panels.iter().map(|panel| panel.view.extent()).collect();
    let hull = extents
        .iter()
        .copied()
        .reduce(|[a, b, c, d], [e, f, g, h]| [a.min(e), b.max(f), c.min(g), d.max(h)]);
    let [left, right, low, high] = hull.unwrap_or([-1.0, 1.0, 0.0, 1.0]);
    let beside = panels.iter().map(ModePanel::beside).fold(Beside::default(), Beside::and);
    // The width of a panel with an arch of a width.
    let needed = |arch: f64| beside.width(arch / (right - left));
    let most = if report.between.is_empty() { 2 } else { WIDTHS.len() };
    let columns = panels.len().clamp(1, most);
    let own = 2.0 * MARGIN + columns as f64 * WIDTHS[columns - 1];
    let width = print.room(own, 2.0 * MARGIN + needed(LEAST))?;
    let room = width - 2.0 * MARGIN;
    let fit = |columns: &usize| room >= *columns as f64 * needed(BESIDE);
    let columns = (2..=columns).rev().find(fit).unwrap_or(1);
    let wide = room / columns as f64;
    let heads = panels.iter().map(|panel| panel.head(wide, print));
    let head = heads.fold(0.0, f64::max);
    let radius = beside.radius(wide).min(HEIGHT / (high - low));
    let arch = radius * (right - left);
    let strips: Vec<Option<Strip>> =
        panels.iter().map(|panel| Strip::of(panel, radius, report.style.half)).collect();
    let below = if strips.iter().any(Option::is_some) { strip::HEIGHT } else { 0.0 };
    let tall = head + ABOVE + radius * (high - low) + under + below;
    let rows = panels.len().div_ceil(columns);
    let legend = Legend::new(report, room);
    let words = paragraphs(report);
    let lines = print.caption(&words, SMALL, room);
    let bottom = MARGIN + rows as f64 * tall + GAP / 2.0;
    let foot = bottom + legend.height() + GAP;
    let height = foot + lines.len() as f64 * SMALL * text::LEADING + MARGIN;
    let mut svg = Svg::printed(print, (width, height), &heading(report), &words.join(" "));
    for (place, panel) in panels.iter().enumerate() {
        let (column, row) = (place % columns, place / columns);
        // A last one that is alone stands in the middle.
        let is_alone = place + 1 == panels.len() && column == 0;
        let x = match is_alone {
            true => (width - wide) / 2.0,
            false => MARGIN + column as f64 * wide,
        };
        let y = MARGIN + row as f64 * tall;
        let middle = x + wide / 2.0 - radius * (left + right) / 2.0;
        let center =
            (beside.center(middle, [x, x + wide], radius), y + head + ABOVE + radius * high);
        svg.window([(x, y + head), (x + wide, y + tall - below)]);
        svg.group(&format!("panel-{place}"), |svg| {
            panel.draw(svg, &PageScale { center, radius }, ((x, y), wide), print);
            if let Some(strip) = &strips[place] {
                strip.draw(svg, panel, (x + (wide - arch) / 2.0, y + tall - below), arch);
            }
        });
    }
    legend.draw(&mut svg, (MARGIN, bottom), room);
    svg.group("caption", |svg| svg.lines(&lines, (MARGIN, foot), Type::new(SMALL, INK)));
    Ok(svg.finish())
}
