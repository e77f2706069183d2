//! The page: panels beside and below each other, a legend, a caption.

use super::Sketched;
use super::beside::Beside;
use super::caption::{heading, paragraphs};
use super::legend::Legend;
use super::panel::{ABOVE, ModePanel};
use super::sheet::{GAP, Headings, sheet};
use super::strip::{self, Strip};
use crate::picture::{Page, Print, Svg};
use crate::sketch::{Hull, PageScale};
use std::io;

/// The width of a panel where there is one in a row, and where there are more.
const WIDTHS: [f64; 3] = [880.0, 620.0, 470.0];
/// The least width of an arch, and what it has in a panel beside another.
const LEAST: f64 = 130.0;
const BESIDE: f64 = 240.0;
/// The most that an arch is high.
const HEIGHT: f64 = 620.0;

/// The picture as SVG.
pub(crate) fn picture(report: &Sketched, print: &Print) -> io::Result<String> {
    let panels = ModePanel::all(report);
    let under = panels.iter().map(ModePanel::under).fold(0.0, f64::max);
    let hull = Hull::around(panels.iter().map(|panel| panel.view.hull()));
    let beside = panels.iter().map(ModePanel::beside).fold(Beside::default(), Beside::and);
    // The width of a panel with an arch of a width.
    let needed = |arch: f64| beside.width(arch / hull.width());
    let most = if report.between.is_empty() { 2 } else { WIDTHS.len() };
    let columns = panels.len().clamp(1, most);
    let page = Page::with_room(print, columns as f64 * WIDTHS[columns - 1], needed(LEAST))?;
    let room = page.room();
    let fit = |columns: &usize| room >= *columns as f64 * needed(BESIDE);
    let columns = (2..=columns).rev().find(fit).unwrap_or(1);
    let wide = room / columns as f64;
    let headings: Vec<Headings> = panels.iter().map(|panel| panel.headings(wide, print)).collect();
    let head = headings.iter().map(Headings::height).fold(0.0, f64::max);
    let radius = beside.radius(wide).min(HEIGHT / hull.height());
    let arch = radius * hull.width();
    let strips: Vec<Option<Strip>> =
        panels.iter().map(|panel| Strip::of(panel, radius, report.style.half)).collect();
    let below = if strips.iter().any(Option::is_some) { strip::HEIGHT } else { 0.0 };
    let tall = head + ABOVE + radius * hull.height() + under + below;
    let rows = panels.len().div_ceil(columns);
    let bottom = Page::MARGIN + rows as f64 * tall + GAP / 2.0;
    let (legend, words) = (Legend::new(report, room), paragraphs(report));
    let draw = |svg: &mut Svg| {
        for (place, panel) in panels.iter().enumerate() {
            let (column, row) = (place % columns, place / columns);
            // A last one that is alone stands in the middle.
            let is_alone = place + 1 == panels.len() && column == 0;
            let x = match is_alone {
                true => (page.width - wide) / 2.0,
                false => Page::MARGIN + column as f64 * wide,
            };
            let (y, middle) = (Page::MARGIN + row as f64 * tall, x + wide / 2.0);
            let center = (
                beside.center(middle - radius * hull.middle(), [x, x + wide], radius),
                y + head + ABOVE + radius * hull.high,
            );
            svg.window([(x, y + head), (x + wide, y + tall - below)]);
            svg.group(&format!("panel-{place}"), |svg| {
                headings[place].draw(svg, (middle, y));
                panel.draw(svg, &PageScale { center, radius });
                if let Some(strip) = &strips[place] {
                    strip.draw(svg, panel, (x + (wide - arch) / 2.0, y + tall - below), arch);
                }
            });
        }
    };
    Ok(sheet(&page, (&heading(report), &words), (&legend, bottom), draw))
}
