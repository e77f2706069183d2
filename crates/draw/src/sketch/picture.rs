//! An arch alone, as a picture: what a page shows beside words of its own.

use super::scale::PageScale;
use super::view::ArchView;
use crate::picture::Svg;

/// Around the arch.
const MARGIN: f64 = 14.0;

/// The arch as SVG, `width` units wide and at most as high, with words for those who do not see it.
pub fn picture(view: &ArchView, width: f64, title: &str) -> String {
    let hull = view.hull();
    let room = width - 2.0 * MARGIN;
    let radius = room / hull.width().max(hull.height());
    let height = 2.0 * MARGIN + radius * hull.height();
    let center = (width / 2.0 - radius * hull.middle(), MARGIN + radius * hull.high);
    let scale = PageScale { center, radius };
    let mut svg = Svg::new((width, height), title, "");
    view.body(&mut svg, &scale);
    view.lines(&mut svg, &scale);
    view.marks(&mut svg, &scale);
    svg.finish()
}
