//! Picture of all arches of a question with ranges: the stone of the outermost two, the band in which every line of
//! thrust lies, and in it the band of what each of them bears, on the arch and unrolled.

use super::lean::write_lean;
use super::legend::{Legend, LegendSample};
use super::sheet::{GAP, Headings, sheet};
use crate::arch::SelfWeight;
use crate::atlas::BandedArch;
use crate::picture::color::INK;
use crate::picture::{Anchor, Color, Page, Path, Point, Print, Stroke, Svg, Type};
use crate::report::{Content, Format, MEANING, Record, Reported, SurveyedArches, words};
use crate::sketch::{Hull, PageScale, across, faces, look, polar};
use couplet_survey::QuantityRange;
use std::io;

const WIDTH: f64 = 880.0;
/// The least width that the words need.
const LEAST: f64 = 300.0;
/// The most that an arch is high.
const HEIGHT: f64 = 520.0;
/// Height of the unrolled half, of the words above and below it, and of its thickest arch.
const UNROLLED: f64 = 190.0;
const TOP: f64 = 34.0;
const THICK: f64 = 120.0;

/// Stone of each arch.
const CORE: Color = Color(0xDE, 0xDA, 0xD1);
/// Edge of the widest and thinnest arch.
const THIN: Stroke = Stroke { color: INK, width: 1.3, dashes: &[8.0, 4.0] };
/// Edge of the band of what each arch bears.
const BORNE: Stroke = Stroke { color: look::BAND, width: 1.5, dashes: &[6.0, 3.0] };
/// Opacity of that band.
const DARK: f64 = 0.36;

/// All arches of a question with ranges, as they are drawn.
#[derive(Debug)]
pub struct BandedArches {
    /// The arches, with what is proved of them.
    pub arches: SurveyedArches,
    /// The unsafe arch with the band of what each bears, and the safe one with that of all lines.
    pub bands: [BandedArch; 2],
    /// The command that makes it, for its caption.
    pub command: String,
}

impl Reported for BandedArches {
    fn content() -> Content {
        Content(&["json", "svg", "png", "pdf"])
    }

    /// The answer, with the bands.
    fn records(&self) -> Vec<Record> {
        let band = |of: &BandedArch| {
            let mut record = Record::default();
            record.add("half_opening", of.half_opening);
            record.add("thickness", of.thickness);
            record.add("band", of.band.iter().map(|edges| edges.to_vec()).collect::<Vec<_>>());
            record
        };
        let [each, all] = self.bands.each_ref().map(band);
        let mut bands = Record::default();
        bands.add_sorted("bands", [("each", each), ("all", all)]);
        let mut records = self.arches.records();
        records.iter_mut().for_each(|record| record.append(std::mem::take(&mut bands)));
        records
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        (format.name == "json").then(|| write_lean(&self.records(), out))
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        let page = Page::with_room(print, WIDTH, LEAST)?;
        let (room, middle) = (page.room(), page.width / 2.0);
        let headings = self.headings(room, print);
        let [worst, best] = &self.bands;
        let hull = Hull::of_ring(worst.half_opening, radii(best));
        let radius = (room / hull.width()).min(HEIGHT / hull.height());
        let top = Page::MARGIN + headings.height() + GAP / 2.0;
        let scale = PageScale { center: (middle, top + radius * hull.high), radius };
        let unrolled = top + radius * hull.height() + GAP;
        let draw = |svg: &mut Svg| {
            headings.draw(svg, (middle, Page::MARGIN));
            self.arch(svg, &scale);
            self.unrolled(svg, (Page::MARGIN, unrolled), room);
        };
        let (words, legend) = (self.paragraphs(), self.legend(room));
        Ok(sheet(&page, (&self.subject(), &words), (&legend, unrolled + UNROLLED), draw))
    }
}

/// Radii of the intrados and the extrados.
fn radii(of: &BandedArch) -> [f64; 2] {
    faces(of.thickness)
}

/// Draws a band between its lower and its upper edge.
fn shade(svg: &mut Svg, [lower, upper]: [Vec<Point>; 2], edge: Stroke, share: f64) {
    let around = upper.iter().chain(lower.iter().rev()).copied();
    svg.tint(&Path::around(around), look::BAND, share);
    for side in [lower, upper] {
        svg.stroke(&Path::through(side), edge);
    }
}

impl BandedArches {
    fn subject(&self) -> String {
        format!("Every arch of {}", self.arches.asked.with_weight(self.arches.weight))
    }

    fn headings(&self, room: f64, print: &Print) -> Headings {
        let [_, outcome] = self.arches.outcome();
        let lines = [(words::capital(outcome), Page::TITLE), (self.subject(), Page::LABEL)];
        Headings::of(lines.into_iter().filter(|_| print.title), room)
    }

    fn legend(&self, room: f64) -> Legend {
        let [worst, best] = self.bands.each_ref().map(|of| !of.band.is_empty());
        let all = [
            (true, LegendSample::Line(look::OUTLINE), "narrowest and thickest"),
            (true, LegendSample::Line(THIN), "widest and thinnest"),
            (true, LegendSample::Area(CORE), "stone of each arch"),
            (true, LegendSample::Area(look::STONE), "stone of some"),
            (best, LegendSample::Shade(look::EXTREME, look::FAINT), "all lines of thrust"),
            (worst, LegendSample::Shade(BORNE, DARK), "those that each arch bears"),
        ];
        Legend::of_those(all, room)
    }

    /// The whole arch.
    fn arch(&self, svg: &mut Svg, scale: &PageScale) {
        let [worst, best] = &self.bands;
        let [wide, narrow] = [worst, best].map(|of| [-of.half_opening, of.half_opening]);
        svg.group("arch", |svg| {
            svg.fill(&scale.sector(wide, radii(best), 1.0), look::STONE);
            svg.fill(&scale.sector(narrow, radii(worst), 1.0), CORE);
        });
        for (name, of, edge, share) in self.shades() {
            let edges = [1, 2].map(|k| {
                let places = of.band.iter().map(|at| polar(at[0], at[k]));
                let places = across(places, false).into_iter();
                places.map(|at| scale.at(at, 1.0)).collect()
            });
            svg.group(name, |svg| shade(svg, edges, edge, share));
        }
        svg.group("outlines", |svg| {
            svg.stroke(&scale.sector(wide, radii(worst), 1.0), THIN);
            svg.stroke(&scale.sector(narrow, radii(best), 1.0), look::OUTLINE);
        });
    }

    /// Bands that there are, the one below first, with edge and opacity.
    fn shades(&self) -> impl Iterator<Item = (&'static str, &BandedArch, Stroke, f64)> {
        let [worst, best] = &self.bands;
        let all = [("all", best, look::EXTREME, look::FAINT), ("each", worst, BORNE, DARK)];
        all.into_iter().filter(|(_, of, ..)| !of.band.is_empty())
    }

    /// The right half, unrolled, with its thickness enlarged.
    fn unrolled(&self, svg: &mut Svg, (left, top): Point, room: f64) {
        let [worst, best] = &self.bands;
        let per_radius = THICK / best.thickness;
        let at = |joint: f64, radius: f64| -> Point {
            let across = room * joint / worst.half_opening;
            (left + across, top + TOP + THICK / 2.0 - per_radius * (radius - 1.0))
        };
        let ring = |alpha: f64, [inner, outer]: [f64; 2]| {
            Path::rectangle(at(0.0, outer), at(alpha, inner))
        };
        let style = Type::new(Page::SMALL, INK);
        svg.group("unrolled", |svg| {
            let words = "right half, unrolled, its thickness enlarged";
            svg.text(words, (left + room / 2.0, top + TOP / 2.0), style.at(Anchor::Middle));
            svg.fill(&ring(worst.half_opening, radii(best)), look::STONE);
            svg.fill(&ring(best.half_opening, radii(worst)), CORE);
            for (_, of, edge, share) in self.shades() {
                let edges = [1, 2].map(|k| of.band.iter().map(|of| at(of[0], of[k])).collect());
                shade(svg, edges, edge, share);
            }
            svg.stroke(&ring(worst.half_opening, radii(worst)), THIN);
            svg.stroke(&ring(best.half_opening, radii(best)), look::OUTLINE);
            let below = top + TOP + THICK + 18.0;
            svg.text("crown", (left, below), style);
            svg.text("shoulder", (left + room, below), style.at(Anchor::End));
        });
    }

    /// Words below.
    fn paragraphs(&self) -> Vec<String> {
        let mut all = vec![format!("{}.", self.subject())];
        match (self.arches.first_open(), &self.arches.found) {
            (None, Ok(found)) => {
                let [_, outcome] = self.arches.outcome();
                let range = |range: &QuantityRange| {
                    let [lower, upper] =
                        [&range.lower, &range.upper].map(|end| end.value.to_string());
                    let name = range.of.name();
                    let units = [("_m", " m"), ("_kn", " kN")];
                    let unit = |(end, unit)| Some((name.strip_suffix(end)?, unit));
                    let (name, unit) = units.into_iter().find_map(unit).unwrap_or((name, ""));
                    format!("{} {lower} to {upper}{unit}", name.replace('_', " "))
                };
                let ranges: Vec<String> = self.arches.ranges().map(range).collect();
                all[0] += &format!(" Proved: {outcome}; {}.", ranges.join(", "));
                all.push(MEANING.to_owned());
                let [worst, best] = [&found.worst, &found.best].map(|of| self.arches.command(of));
                all.push(format!("Stands least easily: {worst}. Stands most easily: {best}."));
            }
            (open, _) => {
                all[0] += &open.map_or(String::new(), |open| {
                    format!(" {}.", words::capital(&open.to_string()))
                });
            }
        }
        let [worst, best] = &self.bands;
        let mut drawn = "Drawn in doubles, not proved: ".to_owned();
        drawn += match best.band.is_empty() {
            true => "no line of thrust is in any arch.",
            false => {
                "the light band, which holds each line of thrust of each arch. It goes as far as lines of all forces that \
                 the narrowest arch that has a joint there bears, with the most friction and the largest thickness: it \
                 bears what any of them bears."
            }
        };
        if self.arches.weight == SelfWeight::Milankovitch && !best.band.is_empty() {
            drawn += " The centroids of its lower edge are those of the thinnest arch, so that some of it may be below \
                      every line.";
        }
        drawn += match worst.band.is_empty() {
            true => " No thrust is borne by each of them.",
            false => {
                " The dark band holds the lines of the widest half opening with the least friction and thickness: each arch \
                 bears their thrusts."
            }
        };
        all.push(drawn);
        all.push(format!("Command: {}", self.command));
        all
    }
}
