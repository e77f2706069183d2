//! The lines of both weights in one plane.

use super::canvas::Canvas;
use super::caption::{caption, of_levels};
use super::content::lines;
use super::inset::Inset;
use super::known::{TANGENTS, known};
use super::look;
use super::page::{Page, SIZE};
use super::plane::{DEGREES, Plane};
use super::sheet::Sheet;
use super::spot::disc;
use crate::arch::SelfWeight;
use crate::atlas::tangent;
use crate::picture::color::{INK, WHITE};
use crate::picture::{Anchor, Frame, Path, Point, Stroke, Svg, Type};
use crate::problem::Landmark;
use crate::report::words;

/// The lines of both weights, as a picture.
pub(super) struct LinesPicture<'a> {
    /// The curves of each weight.
    pub sheets: &'a [Sheet<'a>],
    /// The command that makes it.
    pub command: &'a str,
}

const NAME: f64 = 18.0;
/// Half of a tangent, in degrees.
const TANGENT: f64 = 20.0;
/// The only plane in which they can be told apart.
const PLANE: Plane = Plane::ThicknessFriction;
const SHOWS: &str = "The lines between the domains of the collapse modes";

impl LinesPicture<'_> {
    /// The picture as SVG.
    pub(super) fn svg(&self) -> String {
        let sheets = self.sheets;
        let canvas = Canvas::usual(PLANE);
        let width = sheets.iter().map(|sheet| sheet.width()).fold(0.0, f64::max);
        let of = |landmark| -> Vec<Point> {
            sheets.iter().filter_map(|sheet| sheet.landmark(landmark, &canvas)).collect()
        };
        let (page, _) = Page::new(&canvas, "", &[], false);
        let insets = Inset::of_both(of, page.frame.corner);
        let off = canvas.axes.map(|axis| (axis, width));
        let mut words = caption(SHOWS, sheets, (&off, SIZE), &of_levels(sheets), self.command);
        if !insets.is_empty() {
            words.splice(1..1, known(self.sheets));
        }
        let (page, mut svg) = Page::new(&canvas, SHOWS, &words, false);
        let frame = &page.frame;
        svg.clipped(&frame.outline(), |svg| self.draw(svg, frame, ""));
        page.draw(&mut svg);
        for inset in &insets {
            inset.draw(&mut svg, &canvas, |svg, id| {
                self.tangents(svg, &inset.frame, id);
                self.draw(svg, &inset.frame, id);
            });
            self.landmarks(&mut svg, &inset.frame, true);
        }
        insets.iter().for_each(|inset| inset.draw_guides(&mut svg, frame));
        self.landmarks(&mut svg, frame, false);
        self.legend(&mut svg, frame);
        svg.finish()
    }

    fn draw(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        for sheet in self.sheets {
            let weight = sheet.weight.name();
            for curve in lines() {
                let Some(chain) = sheet.chain(curve, &Canvas::usual(PLANE)) else { continue };
                let id = format!("{of}{weight}-line-{}", curve.to_string().replace('/', "-"));
                svg.group(&id, |svg| chain.draw(svg, frame, look::of_weight(sheet.weight)));
            }
        }
    }

    /// The tangents at T, where a frame shows T larger.
    fn tangents(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        for sheet in self.sheets {
            let triple = sheet.landmark(Landmark::Triple, &Canvas::usual(PLANE));
            let Some(at) = triple.filter(|at| frame.shows(*at)) else { continue };
            let color = look::of_weight(sheet.weight).color;
            for line in TANGENTS {
                let Ok(slope) = tangent(line, sheet.weight, Landmark::Triple) else { continue };
                // Per degree.
                let slope = slope.mid().to_f64() / DEGREES;
                let end = |across: f64| frame.at((at.0 + across, at.1 + across * slope));
                let id = format!("{of}{}-tangent-{line}", sheet.weight.name()).replace('/', "-");
                let whole = Path::through([end(-TANGENT), end(TANGENT)]);
                svg.group(&id, |svg| svg.stroke(&whole, Stroke::new(color, 0.8)));
            }
        }
    }

    fn landmarks(&self, svg: &mut Svg, frame: &Frame, is_inset: bool) {
        for sheet in self.sheets {
            for (landmark, at) in sheet.landmarks(&Canvas::usual(PLANE)) {
                if !frame.shows(at) {
                    continue;
                }
                disc(svg, frame.at(at));
                let is_close = matches!(landmark, Landmark::Shift | Landmark::Junction);
                let name = match landmark {
                    Landmark::OverturningEnd if sheet.weight != SelfWeight::Heyman => continue,
                    Landmark::OverturningEnd => "L".to_owned(),
                    _ if is_close && !is_inset => continue,
                    _ => format!("{}{}", words::symbol(landmark), mark(sheet.weight)),
                };
                // Milankovitch's to the left of their lines, Heyman's to the right.
                let (across, up, anchor) = match (landmark, sheet.weight) {
                    (Landmark::OverturningEnd, _) => (-10.0, 16.0, Anchor::End),
                    (Landmark::RotationEnd, SelfWeight::Heyman) => (-9.0, -15.0, Anchor::End),
                    (Landmark::RotationEnd, _) => (-7.0, 17.0, Anchor::End),
                    (Landmark::Border, SelfWeight::Milankovitch) => (-9.0, 15.0, Anchor::End),
                    (Landmark::Shift, _) => (9.0, 13.0, Anchor::Start),
                    (Landmark::Junction, _) | (_, SelfWeight::Milankovitch) => {
                        (-9.0, -7.0, Anchor::End)
                    }
                    (_, SelfWeight::Heyman) => (9.0, 12.0, Anchor::Start),
                };
                let (x, y) = frame.at(at);
                let style = Type::new(NAME, look::of_weight(sheet.weight).color);
                svg.text(&name, (x + across, y + up), style.at(anchor).on(WHITE));
            }
        }
    }

    fn legend(&self, svg: &mut Svg, frame: &Frame) {
        svg.group("legend", |svg| {
            for (k, sheet) in self.sheets.iter().enumerate() {
                let (x, y) = (frame.corner.0 + 250.0, frame.bottom() - 16.0 - 22.0 * k as f64);
                let sample = Path::through([(x + 110.0, y), (x + 164.0, y)]);
                svg.stroke(&sample, look::of_weight(sheet.weight));
                svg.text(&words::model(sheet.weight), (x + 174.0, y), Type::new(NAME, INK));
            }
        });
    }
}

/// Behind the symbol of a landmark.
fn mark(weight: SelfWeight) -> char {
    match weight {
        SelfWeight::Heyman => 'ₕ',
        SelfWeight::Milankovitch => 'ₘ',
    }
}
