//! Reach of asymmetric branches in the plane of half opening and friction.

use super::canvas::Canvas;
use super::chain::Chain;
use super::domain;
use super::plane::Plane;
use super::sheet::Sheet;
use crate::arch::SelfWeight;
use crate::atlas::{BorderLine, Curve};
use crate::picture::color::{INK, WHITE};
use crate::picture::room::Rectangle;
use crate::picture::text;
use crate::picture::{Anchor, Color, Frame, Hatch, Page, Path, Point, Stroke, Svg, Type};
use crate::problem::Line;

/// The lines of one weight, and what they enclose together with those between modes.
pub(super) struct AsymmetricLines {
    lines: Vec<(BorderLine, bool, Chain)>,
    region: Option<Chain>,
}

/// Stroke where a branch ends, and where its mechanism changes; the first differs from the lines between
/// modes by its dashes.
const OUTER: Stroke = Stroke { color: Color(0x5B, 0x2A, 0x86), width: 3.0, dashes: &[7.0, 3.0] };
const INNER: Stroke = Stroke { color: Color(0x5B, 0x2A, 0x86), width: 1.4, dashes: &[2.0, 3.0] };
const GROUND: Color = Color(0xE4, 0xD6, 0xF0);
const OVER: Color = Color(0xA5, 0x86, 0xC6);

fn fill(svg: &mut Svg, path: &Path) {
    svg.hatch(path, Hatch { ground: GROUND, color: OVER, gap: 5.0, turn: 0.0 });
}

/// Rest of a line from a place on, if it runs to the right.
fn after(chain: Chain, place: f64) -> Option<Chain> {
    let [from, to] = chain.ends()?;
    if from.0 >= to.0 {
        return None;
    }
    let [_, after] = chain.split(place);
    Some(after)
}

impl AsymmetricLines {
    /// The lines of a sheet; `None` where there are none, or in another plane.
    pub(super) fn new(sheet: &Sheet, canvas: &Canvas) -> Option<Self> {
        if sheet.borders.is_empty() || canvas.plane != Plane::OpeningFriction {
            return None;
        }
        let line = |border: &&crate::atlas::Border| {
            let chain =
                Chain::of_pieces(border.section.pieces(), &border.section.ends()[0], &canvas.axes)?;
            Some((border.line, border.line.is_outer(sheet.weight), chain))
        };
        let lines: Vec<(BorderLine, bool, Chain)> = sheet.borders.iter().filter_map(line).collect();
        let region = Self::region(sheet, canvas, &lines);
        Some(Self { lines, region })
    }

    fn region(
        sheet: &Sheet,
        canvas: &Canvas,
        lines: &[(BorderLine, bool, Chain)],
    ) -> Option<Chain> {
        let mut outer = lines.iter().filter(|(_, is_outer, _)| *is_outer).map(|(.., chain)| chain);
        let mut way = outer.next()?.clone();
        let [x, y] = way.ends()?;
        way.0.extend(outer.flat_map(|chain| chain.0.iter().copied()));
        let of = |line| sheet.chain(Curve::Line(line), canvas);
        if sheet.weight == SelfWeight::Milankovitch {
            way.0.extend(after(of(Line::RotationShoulder)?, y.0)?.0);
        }
        way.0.extend(after(of(Line::ShoulderEnd)?, x.0)?.reversed().0);
        Some(way)
    }

    /// Draws the areas that are enclosed.
    pub(super) fn fill(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        let Some(way) = &self.region else { return };
        svg.group(&format!("{of}asymmetric"), |svg| fill(svg, &domain::area(way, frame)));
    }

    /// The lines.
    pub(super) fn draw(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        for (line, is_outer, chain) in &self.lines {
            let id = format!("{of}line-{}", line.name().replace(['/', '_'], "-"));
            svg.group(&id, |svg| chain.draw(svg, frame, if *is_outer { OUTER } else { INNER }));
        }
    }

    /// The chains, for how near they are.
    pub(super) fn chains(&self) -> impl Iterator<Item = &Chain> {
        self.lines.iter().map(|(.., chain)| chain)
    }
}

/// Area that the legend takes of a frame, below on the right, where nothing stands.
pub(super) fn legend_in(frame: &Frame) -> Rectangle {
    let widest = text::widest(LEGEND.map(|(name, _)| name), Page::SMALL);
    let across = widest + GAP / 2.0 + SAMPLE + GAP;
    let up = LEADING * LEGEND.len() as f64 + GAP / 2.0;
    [(frame.right() - across, frame.bottom() - up), (frame.right(), frame.bottom())]
}

/// Draws the names of the areas above and to the left of a corner.
pub(super) fn legend(svg: &mut Svg, (right, bottom): Point) {
    let right = right - GAP;
    svg.group("legend", |svg| {
        for (k, (name, stroke)) in LEGEND.into_iter().enumerate() {
            let y = bottom - GAP - LEADING * (2 - k) as f64;
            let (from, to) = (right - SAMPLE, right);
            match stroke {
                Some(stroke) => svg.stroke(&Path::through([(from, y), (to, y)]), stroke),
                None => fill(svg, &Path::rectangle((from, y - 7.0), (to, y + 7.0))),
            }
            let style = Type::new(Page::SMALL, INK).at(Anchor::End).on(WHITE);
            svg.text(name, (from - GAP / 2.0, y), style);
        }
    });
}

const LEGEND: [(&str, Option<Stroke>); 3] = [
    ("asymmetric solutions of (19) too", None),
    ("the border of what they reach", Some(OUTER)),
    ("their mechanism changes", Some(INNER)),
];
const GAP: f64 = 16.0;
const LEADING: f64 = 21.0;
const SAMPLE: f64 = 42.0;

/// Description of the areas for the caption.
pub(super) fn words(weight: SelfWeight) -> String {
    let [meet, turn] = match weight {
        SelfWeight::Milankovitch => ["the dashed line", ""],
        SelfWeight::Heyman => {
            ["the dashed line on the left", "; on that above, beyond, they turn back"]
        }
    };
    format!(
        " Hatched in violet: what asymmetric solutions of (19) reach, in branches from the edge of [s,s] that are \
         above the least thickness and meet it on {meet} and where [s,r,r] meets [r,r,r]{turn}. The lines are proved; \
         that there are no other solutions is not."
    )
}
