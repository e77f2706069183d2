//! Drawing of an arch at the largest horizontal acceleration that it bears: the line of thrust there, the joints that
//! give way, by their angles and sides, and how it falls.

use super::Sketched;
use super::beside::Beside;
use super::dxf::whole;
use super::json::{placed, polyline};
use super::lean::write_lean;
use super::legend::{Legend, LegendSample};
use super::sheet::{Headings, sheet};
use crate::arch::whole::{Side, carried};
use crate::arch::{Ring, statics};
use crate::number::{Angle, Ball, Drawable, arctangent, degrees};
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::{Name, Page, Path, Point, Print, Stroke, Svg, Type, text};
use crate::problem::Friction;
use crate::problem::measures::{LengthUnit, Measures};
use crate::report::numbers::rounded;
use crate::report::{Content, Format, JointAtLimit, Record, Reported, TiltedArch, words};
use crate::sketch::{
    Blocks, Hull, Linkage, PageScale, SketchedLine, WholeView, arrow, faces, look,
};
use couplet_stones::{LargestTilt, TiltMechanism};
use std::io;

const WIDTH: f64 = 880.0;
/// The most that an arch is high.
const HEIGHT: f64 = 560.0;
/// The least width of an arch.
const LEAST: f64 = 130.0;
/// Height of what shows the push below the title, and of the names of joints around the arch.
const PUSH: f64 = 12.0;
const ABOVE: f64 = 40.0;
/// Distance of a name from the extrados.
const AWAY: f64 = 12.0;
const DIGITS: usize = 6;
const BITS: u32 = 256;

/// The radius of a line by a joint, the same with the weight that is carried, and the thrust.
type RadiusAt<'a> = dyn Fn(&Angle<Ball>, &Angle<Ball>, &Ball) -> Ball + 'a;

/// Arches of a thickness under an acceleration, as they are drawn.
#[derive(Debug)]
pub struct TiltDrawing {
    /// The arches, with what is proved of them.
    pub arches: Vec<TiltedArch>,
    /// Measures of the arches, if they are measured.
    pub measures: Option<Measures>,
    /// Distance by which the corner that moves most is moved, in units of `r`.
    pub amplitude: f64,
}

impl Reported for TiltDrawing {
    fn content() -> Content {
        Sketched::content()
    }

    /// Records of the arches, each with its geometry.
    fn records(&self) -> Vec<Record> {
        let of = |panel: TiltPanel<'_>| {
            let mut drawing = Record::default();
            drawing.add_record("drawing", Some(panel.geometry(self.unit(panel.arch))));
            let mut records = panel.arch.records();
            records.iter_mut().for_each(|record| record.append(std::mem::take(&mut drawing)));
            records
        };
        self.panels().into_iter().flat_map(of).collect()
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        picture(&self.panels(), print)
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        match format.name {
            "json" => Some(write_lean(&self.records(), out)),
            "dxf" => Some(out.write_all(self.dxf().as_bytes())),
            _ => None,
        }
    }
}

impl TiltDrawing {
    fn panels(&self) -> Vec<TiltPanel<'_>> {
        self.arches.iter().map(|arch| TiltPanel::new(arch, self.amplitude)).collect()
    }

    /// The unit of lengths, and that of the radius of an arch's centreline in it.
    fn unit(&self, arch: &TiltedArch) -> (Option<LengthUnit>, f64) {
        let Some(measures) = &self.measures else { return (None, 1.0) };
        let eta: Ball = arch.thickness.enclosure(BITS);
        let alpha = arch.arch.given::<Ball>(BITS).half_opening;
        let unit = measures.unit().metres().enclosure::<Ball>(BITS);
        let radius = measures.sizes(&eta, &alpha.rad, BITS).radius / unit;
        (Some(measures.unit()), radius.double())
    }

    fn dxf(&self) -> String {
        let panels = self.panels();
        let shown = panels.iter().map(|panel| {
            let headings = panel.lines().map(|(words, _)| words);
            (&panel.view, headings, panel.names().collect())
        });
        let unit = self.arches.first().map_or((None, 1.0), |arch| self.unit(arch));
        whole(unit, shown)
    }
}

/// An arch with what is drawn of it.
struct TiltPanel<'a> {
    arch: &'a TiltedArch,
    view: WholeView,
    joints: Vec<JointAtLimit<'a>>,
    moved: Option<f64>,
}

/// The pictures of all arches, below each other.
fn picture(panels: &[TiltPanel<'_>], print: &Print) -> io::Result<String> {
    let hull = Hull::around(panels.iter().map(|panel| panel.view.hull()));
    let beside = panels.iter().map(TiltPanel::beside).fold(Beside::default(), Beside::and);
    let page = Page::with_room(print, WIDTH, beside.width(LEAST / hull.width()))?;
    let (room, middle) = (page.room(), page.width / 2.0);
    let radius = beside.radius(room).min(HEIGHT / hull.height());
    let headings: Vec<Headings> = panels.iter().map(|panel| panel.headings(room, print)).collect();
    let head = headings.iter().map(Headings::height).fold(0.0, f64::max) + PUSH;
    let tall = head + 2.0 * ABOVE + radius * hull.height();
    let bottom = Page::MARGIN + panels.len() as f64 * tall;
    let words: Vec<String> = panels.iter().flat_map(TiltPanel::paragraphs).collect();
    let title: Vec<String> = panels.iter().map(TiltPanel::subject).collect();
    let draw = |svg: &mut Svg| {
        for (place, (panel, headings)) in panels.iter().zip(&headings).enumerate() {
            let top = Page::MARGIN + place as f64 * tall;
            let ends = [Page::MARGIN, page.width - Page::MARGIN];
            let x = beside.center(middle - radius * hull.middle(), ends, radius);
            let center = (x, top + head + ABOVE + radius * hull.high);
            let [left, right] = [0.5 * Page::MARGIN, page.width - 0.5 * Page::MARGIN];
            svg.window([(left, top + head), (right, top + tall)]);
            svg.group(&format!("panel-{place}"), |svg| {
                headings.draw(svg, (middle, top));
                let below = top + headings.height() + PUSH;
                panel.draw(svg, &PageScale { center, radius }, (middle, below));
            });
        }
    };
    Ok(sheet(&page, (&title.join("; "), &words), (&legend(panels, room), bottom), draw))
}

fn legend(panels: &[TiltPanel<'_>], room: f64) -> Legend {
    let has = |is: &dyn Fn(&WholeView) -> bool| panels.iter().any(|panel| is(&panel.view));
    let marked = |hinge| has(&|view| view.marks.iter().any(|mark| mark.0.is_hinge() == hinge));
    let all = [
        (has(&|view| view.thrust.is_some()), LegendSample::Line(look::THRUST), "line of thrust"),
        (
            has(&|view| view.friction.is_some()),
            LegendSample::Line(look::FRICTION),
            "line of friction",
        ),
        (marked(true), LegendSample::Hinge, "hinge"),
        (marked(false), LegendSample::Sliding, "joint that slides"),
        (has(&|view| view.blocks.is_some()), LegendSample::Fallen, "as it falls"),
    ];
    Legend::of_those(all, room)
}

impl<'a> TiltPanel<'a> {
    fn new(arch: &'a TiltedArch, amplitude: f64) -> Self {
        let at = arch.arch.given::<Ball>(BITS);
        let eta: Ball = arch.thickness.enclosure(BITS);
        let (half_opening, thickness) = (at.half_opening.rad.double(), eta.double());
        let stones: Vec<f64> = arch
            .stones
            .iter()
            .flat_map(|stones| {
                (0..stones.count() - 1).map(|joint| stones.angle::<Ball>(joint, BITS).rad.double())
            })
            .collect();
        let mirrored = stones.iter().filter(|joint| **joint > 0.0).map(|joint| -joint);
        let all: Vec<f64> = mirrored.chain(stones.iter().copied()).collect();
        let mut view = WholeView {
            half_opening,
            radii: faces(thickness),
            stones: all,
            ..WholeView::default()
        };
        let mut moved = None;
        if let Some(TiltMechanism { forces, joints }) = arch.mechanism() {
            let ring = Ring::new(arch.arch.weight(), &eta);
            let [h, p, v, k] = forces;
            // At a joint of a half: the weight that is carried, and the thrust with what the acceleration adds.
            let both = |radius: &RadiusAt<'_>| {
                let at_joint = |side: Side, joint: &Angle<Ball>| {
                    let joint = side.joint(joint);
                    let thrust = k.clone() * &joint.rad + h;
                    radius(&joint, &carried(&joint, v), &thrust)
                };
                let ends = [&at.half_opening.rad, &eta];
                [Side::Right, Side::Left]
                    .map(|side| SketchedLine::new(ends, &stones, |joint| at_joint(side, joint)))
            };
            let fac = &ring.centroid_factor;
            if joints.iter().any(|joint| joint.contact.is_hinge()) {
                view.thrust = Some(both(&|joint, carried, thrust| {
                    let moment = k.clone() * fac * &joint.sin + p;
                    statics::pressure_radius(carried, thrust, &moment, fac)
                }));
            }
            if arch.arch.is_limited() {
                view.friction = Some(both(&|_, carried, thrust| {
                    statics::friction_radius(carried, [thrust, &at.friction, &eta])
                }));
            }
            view.marks = joints.iter().map(|joint| (joint.contact, joint.angle.double())).collect();
            if let Ok(joints) = view.marks.clone().try_into() {
                let found = Linkage { joints, thickness }.moved(amplitude);
                moved = found.as_ref().map(|found| found.by);
                view.blocks =
                    found.map(|found| Blocks::at_rest(found.blocks, view.radii, &view.stones));
            }
        }
        Self { arch, view, joints: arch.joints(), moved }
    }

    /// The largest acceleration and the angle of the ground that goes with it.
    fn largest(&self) -> Option<[String; 2]> {
        let figure = self.arch.figure()?;
        let tilt = figure.enclosure(BITS);
        let angle = degrees(&arctangent(&tilt));
        Some([&tilt, &angle].map(|x| rounded(x, DIGITS)))
    }

    /// Words above, with their sizes: what was asked, and from where on it falls.
    fn lines(&self) -> [(String, f64); 3] {
        let stands = match self.arch.is_admissible() {
            Some(true) => "stands",
            Some(false) => "falls",
            None => "undecided",
        };
        let falls = if self.arch.arch.is_limited() { "falls from" } else { "falls beyond" };
        let (asked, is_angle) = match &*self.arch.tilt {
            Friction::Angle(angle) => (angle.to_string().replace("deg", "°"), true),
            slope => (format!("{slope} g"), false),
        };
        let [first, second] = match self.largest() {
            Some([tilt, angle]) => {
                let [tilt, angle] = [format!("{tilt} g"), format!("{angle}°")];
                let [from, other] = if is_angle { [angle, tilt] } else { [tilt, angle] };
                [format!("{stands} at {asked}; {falls} {from}"), format!("which is {other}")]
            }
            None => [format!("{stands} at {asked}"), String::new()],
        };
        let push = "pushed to the right".to_owned();
        [(first, Page::TITLE), (second, Page::LABEL), (push, Page::SMALL)]
    }

    /// Lines above in a room.
    fn headings(&self, room: f64, print: &Print) -> Headings {
        // Without headings it is still told which way is pushed.
        Headings::of(self.lines().into_iter().skip(if print.title { 0 } else { 2 }), room)
    }

    /// The lines, and the blocks from the right to the left, where they are drawn.
    fn geometry(&self, (unit, radius): (Option<LengthUnit>, f64)) -> Record {
        let view = &self.view;
        let line = |halves: &Option<[SketchedLine; 2]>| {
            halves.as_ref().map(|halves| polyline(WholeView::across(halves).into_iter(), radius))
        };
        let blocks = view.blocks.iter().flat_map(|blocks| &blocks.fallen);
        let mut fields = Record::default();
        fields.add("unit", unit.map_or("r", LengthUnit::name));
        fields.add("radii", view.radii.map(|x| x * radius).to_vec());
        fields.add("stone_joints", self.arch.stones.as_ref().map(|_| view.stones.clone()));
        fields.add("thrust_line", line(&view.thrust));
        fields.add("friction_line", line(&view.friction));
        fields.add("amplitude", self.moved.map(|by| by * radius));
        fields.add("blocks", blocks.map(|of| placed(of, view.radii, radius)).collect::<Vec<_>>());
        fields
    }

    fn subject(&self) -> String {
        format!("Arch of {}", self.arch.asked.with_weight(self.arch.arch.weight()))
    }

    /// Number of a joint between stones, from the crown.
    fn number(&self, joint: &JointAtLimit<'_>) -> Option<String> {
        let (joint, stones) = joint.number.zip(self.arch.stones.as_ref())?;
        Some(format!("joint {}", stones.from_crown(joint)))
    }

    /// Words on what a joint does, and where it is.
    fn named(&self, joint: &JointAtLimit<'_>, digits: usize) -> [String; 2] {
        let angle = joint.degrees(digits);
        let happens = self.arch.happens(joint.side, joint.of.contact);
        let number = self.number(joint).map_or(String::new(), |number| format!(", {number}"));
        let place = match joint.is_crown() {
            true => "the crown".to_owned(),
            false => format!("{angle}° {}{number}", joint.side.name()),
        };
        [happens.to_owned(), place]
    }

    fn paragraphs(&self) -> Vec<String> {
        let mut all = vec![format!("{}.", self.subject())];
        let Some([tilt, angle]) = self.largest() else {
            let found = self.arch.found.as_ref();
            let words = match found.map(|found| found.as_ref().map(|found| &found.largest)) {
                Ok(None) => "It does not stand without tilt either: proved.".to_owned(),
                Ok(Some(Ok(LargestTilt::Unlimited))) => {
                    "It stands at every tilt: proved.".to_owned()
                }
                Ok(Some(Err(open))) | Err(open) => words::capital(&format!("{open}.")),
                Ok(Some(Ok(LargestTilt::Limited(..)))) => String::new(),
            };
            all[0] += &format!(" {words}");
            all.push(format!("Command: {}", self.arch.command));
            return all;
        };
        let joints: Vec<String> =
            self.joints.iter().map(|joint| self.named(joint, DIGITS).join(" ")).collect();
        let joints = joints.join("; ");
        all[0] += &format!(
            " Proved: admissible states exist exactly up to a horizontal acceleration to the right of {tilt} times gravity, \
             which is ground that falls to the right by {angle}°."
        );
        all.push(format!(
            "There give way, from the right to the left: {joints}. To the left all is the mirror image."
        ));
        let moved = match self.moved {
            Some(by) => format!(
                "; the blocks, moved rigidly and without dilatancy, the corner that moves most by {by:.3} r"
            ),
            None => {
                "; how it falls is not drawn, as these joints alone do not fix it without dilatancy"
                    .to_owned()
            }
        };
        if !self.joints.is_empty() {
            all.push(format!("Drawn, not proved: the lines at that acceleration{moved}."));
        }
        all.push(format!("Command: {}", self.arch.command));
        all
    }

    /// Names beside the arch.
    fn beside(&self) -> Beside {
        let Hull { left, right, .. } = self.view.hull();
        let arch = Beside { left: vec![(left, AWAY)], right: vec![(right, AWAY)] };
        let name = |(angle, out, words): (f64, f64, String)| {
            let room = text::width(&words, Page::SMALL) + 2.5 * AWAY;
            Beside::name(angle.sin(), out * angle.sin(), room)
        };
        self.names().map(name).fold(arch, Beside::and)
    }

    /// The joints' angles, the radii to which blocks reach there, and their names.
    fn names(&self) -> impl Iterator<Item = (f64, f64, String)> {
        // A place where two give way has one name.
        let mut joints: Vec<&JointAtLimit> = self.joints.iter().collect();
        joints.dedup_by_key(|joint| joint.of.angle.double());
        joints.into_iter().map(|joint| {
            let angle = joint.of.angle.double();
            let near = |[x, y]: &[f64; 2]| (x.atan2(*y) - angle).abs() < 0.2;
            let corners = self.view.blocks.iter().flat_map(Blocks::corners).filter(near);
            let out = corners.map(|[x, y]| x.hypot(y)).fold(self.view.radii[1], f64::max);
            let number = self.number(joint).map_or(String::new(), |number| format!("{number}, "));
            let place = match joint.is_crown() {
                true => "the crown".to_owned(),
                false => format!("{number}{}°", joint.degrees(4)),
            };
            (angle, out, place)
        })
    }

    /// The arch, below the way in which it is pushed.
    fn draw(&self, svg: &mut Svg, scale: &PageScale, (middle, y): Point) {
        svg.group("tilt", |svg| arrow(svg, (middle - 60.0, y), (middle + 60.0, y)));
        self.view.body(svg, scale);
        self.view.lines(svg, scale);
        self.view.marks(svg, scale);
        svg.group("names", |svg| {
            let name = |(angle, out, words): (f64, f64, String)| {
                let beyond = |radius: f64, more: f64| radius + more / scale.radius;
                let ends = [beyond(self.view.radii[1], 0.4 * AWAY), beyond(out, 0.8 * AWAY)];
                let ends = ends.map(|radius| scale.polar(angle, radius, 1.0));
                svg.stroke(&Path::through(ends), Stroke::new(GUIDE, 1.0));
                Name::new(words, ends[1], (angle.sin(), -angle.cos()))
            };
            let names: Vec<Name> = self.names().map(name).collect();
            svg.names(&names, |_| Type::new(Page::SMALL, INK).on(WHITE));
        });
    }
}
