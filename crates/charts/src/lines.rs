//! The lines of both weights in one plane.

use super::canvas::Canvas;
use super::caption::{caption, of_levels};
use super::content::lines as curves;
use super::inset::Inset;
use super::known::{TANGENTS, known};
use super::look::{self, mark};
use super::page::{BELOW, MapPage};
use super::plane::{DEGREES, Plane};
use super::sheet::Sheet;
use super::spot::disc;
use crate::arch::SelfWeight;
use crate::atlas::tangent;
use crate::picture::color::{INK, WHITE};
use crate::picture::{Frame, Name, Path, Point, Print, Stroke, Svg, Type};
use crate::problem::{Landmark, Line};
use crate::report::words;
use std::io;

/// The lines of both weights, as a picture.
pub(super) struct LinesPicture<'a> {
    /// The curves of each weight.
    pub sheets: &'a [Sheet<'a>],
    /// The command that makes it.
    pub command: &'a str,
}

const NAME: f64 = 18.0;
/// The height of a row of the legend, and the length of a sample in it.
const ROW: f64 = 22.0;
const SAMPLE: f64 = 54.0;
/// Half of a tangent, in degrees.
const TANGENT: f64 = 20.0;
/// The only plane in which they can be told apart.
const PLANE: Plane = Plane::ThicknessFriction;
const SHOWS: &str = "The lines between the domains of the collapse modes";

impl LinesPicture<'_> {
    /// The picture as SVG.
    pub(super) fn svg(&self, print: &Print) -> io::Result<String> {
        let sheets = self.sheets;
        let canvas = Canvas::usual(PLANE);
        let width = sheets.iter().map(|sheet| sheet.width()).fold(0.0, f64::max);
        let of = |landmark| -> Vec<Point> {
            sheets.iter().filter_map(|sheet| sheet.landmark(landmark, &canvas)).collect()
        };
        let page = MapPage::new(&canvas, false, print)?;
        let frame = &page.frame;
        let insets = Inset::of_both(of, frame);
        let off = canvas.axes.map(|axis| (axis, width));
        let mut words =
            caption(SHOWS, sheets, (&off, frame.size), &of_levels(sheets), self.command);
        if !insets.is_empty() {
            words.splice(1..1, known(self.sheets));
        }
        let down = Inset::down(&insets, frame);
        let rows = ROW * sheets.len() as f64;
        let legend = match page.is_narrow() {
            true => (frame.corner.0, frame.bottom() + BELOW + down + ROW / 2.0),
            false => (frame.corner.0 + 360.0, frame.bottom() + ROW / 4.0 - rows),
        };
        let down = if page.is_narrow() { down + rows } else { 0.0 };
        let mut svg = page.svg(SHOWS, &words, down, |svg| self.draw(svg, frame, ""));
        for inset in &insets {
            inset.draw(&mut svg, &canvas, |svg, id| {
                self.tangents(svg, &inset.frame, id);
                self.draw(svg, &inset.frame, id);
            });
            self.landmarks(&mut svg, &inset.frame, Vec::new(), true);
            svg.take(inset.taken());
        }
        let parts = Inset::draw_parts(&insets, &mut svg, frame);
        self.landmarks(&mut svg, frame, parts, false);
        self.legend(&mut svg, legend);
        Ok(svg.finish())
    }

    fn draw(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        for sheet in self.sheets {
            let weight = sheet.weight.name();
            for curve in curves() {
                let Some(chain) = sheet.chain(curve, &Canvas::usual(PLANE)) else { continue };
                let id = format!("{of}{weight}-line-{}", curve.to_string().replace('/', "-"));
                svg.group(&id, |svg| chain.draw(svg, frame, look::of_weight(sheet.weight)));
            }
        }
    }

    /// The tangents at T, where a frame shows T larger.
    fn tangents(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        for (weight, line, ends) in self.tangent_ends(frame) {
            let id = format!("{of}{}-tangent-{line}", weight.name()).replace('/', "-");
            let stroke = Stroke::new(look::of_weight(weight).color, 0.8);
            svg.group(&id, |svg| svg.stroke(&Path::through(ends), stroke));
        }
    }

    /// The ends of these on the page.
    fn tangent_ends(&self, frame: &Frame) -> impl Iterator<Item = (SelfWeight, Line, [Point; 2])> {
        self.sheets.iter().flat_map(move |sheet| {
            let triple = sheet.landmark(Landmark::Triple, &Canvas::usual(PLANE));
            let at = triple.filter(|at| frame.shows(*at));
            TANGENTS.into_iter().filter_map(move |line| {
                let (at, weight) = (at?, sheet.weight);
                // Per degree.
                let slope = tangent(line, weight, Landmark::Triple).ok()?.mid().to_f64() / DEGREES;
                let end = |across: f64| frame.at((at.0 + across, at.1 + across * slope));
                Some((weight, line, [end(-TANGENT), end(TANGENT)]))
            })
        })
    }

    /// The landmarks with their names, and other names, off all that is drawn.
    fn landmarks(&self, svg: &mut Svg, frame: &Frame, mut names: Vec<Name>, is_inset: bool) {
        let canvas = Canvas::usual(PLANE);
        svg.window([frame.corner, (frame.right(), frame.bottom())]);
        let all = self.sheets.iter().flat_map(|sheet| {
            let seen = sheet.landmarks(&canvas).into_iter().filter(|(_, at)| frame.shows(*at));
            seen.map(|(landmark, at)| (landmark, sheet.weight, frame.at(at)))
        });
        let all: Vec<(Landmark, SelfWeight, Point)> = all.collect();
        all.iter().for_each(|(.., at)| disc(svg, *at));
        for (landmark, weight, at) in all {
            let is_close = matches!(landmark, Landmark::Shift | Landmark::Junction);
            let (name, color) = match landmark {
                // It is that of both.
                Landmark::OverturningEnd if weight != SelfWeight::Heyman => continue,
                Landmark::OverturningEnd => ("L".to_owned(), INK),
                _ if is_close && !is_inset => continue,
                _ => {
                    let name = format!("{}{}", words::symbol(landmark), mark(weight));
                    (name, look::of_weight(weight).color)
                }
            };
            // Milankovitch's to the left of their lines, Heyman's to the right.
            let towards = match (landmark, weight) {
                (Landmark::OverturningEnd, _) => (-1.0, 1.0),
                (Landmark::RotationEnd, SelfWeight::Heyman) => (-1.0, -1.5),
                (Landmark::RotationEnd, _) => (-0.7, 1.7),
                (Landmark::Border, SelfWeight::Milankovitch) => (-1.0, 1.5),
                (Landmark::Shift, _) => (1.0, 1.4),
                (Landmark::Junction, _) | (_, SelfWeight::Milankovitch) => (-1.0, -0.8),
                (_, SelfWeight::Heyman) => (1.0, 1.3),
            };
            names.push(Name { color, ..Name::new(name, at, towards) });
        }
        svg.names(&names, |_| Type::new(NAME, INK).on(WHITE));
    }

    /// Names of the weights, one below the other.
    fn legend(&self, svg: &mut Svg, (x, top): Point) {
        svg.group("legend", |svg| {
            for (k, sheet) in self.sheets.iter().enumerate() {
                let y = top + ROW * k as f64;
                let sample = Path::through([(x, y), (x + SAMPLE, y)]);
                svg.stroke(&sample, look::of_weight(sheet.weight));
                let name = words::model(sheet.weight);
                svg.text(&name, (x + SAMPLE + 10.0, y), Type::new(NAME, INK));
            }
        });
    }
}
