//! Picture of an arch at the largest horizontal acceleration that it bears: the line of thrust there, the joints that
//! give way, by their angles and sides, and how it falls.

use super::sketched::{Legend, LegendSample};
use super::tilt::{Joint, TiltedArch};
use super::words;
use crate::arch::whole::{Side, carried};
use crate::arch::{Ring, statics};
use crate::number::{Angle, Ball, Drawable, arctangent, degrees};
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::{Anchor, Path, Point, Stroke, Svg, Type, text};
use crate::sketch::{Blocks, Linkage, PageScale, SketchedLine, WholeView, arrow, look};
use couplet_stones::{LargestTilt, TiltMechanism};
use std::io;

const MARGIN: f64 = 20.0;
const WIDTH: f64 = 880.0;
/// The most that an arch is high.
const HEIGHT: f64 = 560.0;
/// Room for the title, and for the names of joints around the arch.
const HEAD: f64 = 88.0;
const ABOVE: f64 = 66.0;
const SIDE: f64 = 190.0;
const GAP: f64 = 16.0;
const TITLE: f64 = 19.0;
const LABEL: f64 = 16.0;
const SMALL: f64 = 15.0;
/// Distance of a name from the extrados.
const AWAY: f64 = 15.0;
/// Distance by which the corner that moves most is moved, in units of `r`.
const AMPLITUDE: f64 = 0.12;
const DIGITS: usize = 6;
const BITS: u32 = 256;

/// The radius of a line by a joint, the same with the weight that is carried, and the thrust.
type RadiusAt<'a> = dyn Fn(&Angle<Ball>, &Angle<Ball>, &Ball) -> Ball + 'a;

/// An arch with what is drawn of it.
struct TiltPanel<'a> {
    arch: &'a TiltedArch,
    view: WholeView,
    joints: Vec<Joint<'a>>,
    moved: Option<f64>,
}

/// The pictures of all arches, below each other.
pub(super) fn picture(all: &[TiltedArch]) -> io::Result<String> {
    let panels: Vec<TiltPanel<'_>> = all.iter().map(TiltPanel::new).collect();
    let extents = panels.iter().map(|panel| panel.view.extent());
    let hull =
        extents.reduce(|[a, b, c, d], [e, f, g, h]| [a.min(e), b.max(f), c.min(g), d.max(h)]);
    let [left, right, low, high] = hull.unwrap_or([-1.0, 1.0, 0.0, 1.0]);
    let radius = ((WIDTH - 2.0 * SIDE) / (right - left)).min(HEIGHT / (high - low));
    let tall = HEAD + 2.0 * ABOVE + radius * (high - low);
    let width = 2.0 * MARGIN + WIDTH;
    let legend = Legend::of(entries(&panels), WIDTH);
    let words: Vec<String> = panels.iter().flat_map(TiltPanel::paragraphs).collect();
    let lines: Vec<String> =
        words.iter().flat_map(|words| text::wrap(words, SMALL, WIDTH)).collect();
    let bottom = MARGIN + panels.len() as f64 * tall;
    let foot = bottom + legend.height() + GAP;
    let height = foot + lines.len() as f64 * SMALL * text::LEADING + MARGIN;
    let heading: Vec<String> = panels.iter().map(TiltPanel::subject).collect();
    let mut svg = Svg::new((width, height), &heading.join("; "), &words.join(" "));
    for (place, panel) in panels.iter().enumerate() {
        let top = MARGIN + place as f64 * tall;
        let center =
            (width / 2.0 - radius * (left + right) / 2.0, top + HEAD + ABOVE + radius * high);
        svg.group(&format!("panel-{place}"), |svg| {
            panel.draw(svg, &PageScale { center, radius }, (width / 2.0, top));
        });
    }
    legend.draw(&mut svg, (MARGIN, bottom), WIDTH);
    svg.group("caption", |svg| svg.lines(&lines, (MARGIN, foot), Type::new(SMALL, INK)));
    Ok(svg.finish())
}

fn entries(panels: &[TiltPanel<'_>]) -> Vec<(LegendSample, &'static str)> {
    let has = |is: &dyn Fn(&WholeView) -> bool| panels.iter().any(|panel| is(&panel.view));
    let all = [
        (has(&|view| view.thrust.is_some()), LegendSample::Line(look::THRUST), "line of thrust"),
        (
            has(&|view| view.friction.is_some()),
            LegendSample::Line(look::FRICTION),
            "line of friction",
        ),
        (
            has(&|view| view.marks.iter().any(|mark| mark.0.is_hinge())),
            LegendSample::Hinge,
            "hinge",
        ),
        (
            has(&|view| view.marks.iter().any(|mark| !mark.0.is_hinge())),
            LegendSample::Sliding,
            "joint that slides",
        ),
        (has(&|view| view.blocks.is_some()), LegendSample::Fallen, "as it falls"),
    ];
    all.into_iter().filter(|(is, ..)| *is).map(|(_, sample, name)| (sample, name)).collect()
}

/// The radius of a line on a half, by the forces on a joint there: its angle with the weight that is carried, and the
/// thrust with what the acceleration adds.
fn line(
    [alpha, eta]: [&Ball; 2],
    forces: &[Ball; 4],
    stones: &[f64],
    side: Side,
    radius: impl Fn(&Angle<Ball>, &Angle<Ball>, &Ball) -> Ball,
) -> SketchedLine {
    let [h, _, v, k] = forces;
    let at = |joint: &Angle<Ball>| {
        let joint = side.joint(joint);
        let thrust = k.clone() * &joint.rad + h;
        radius(&joint, &carried(&joint, v), &thrust)
    };
    match stones {
        [] => SketchedLine::new([alpha, eta], at),
        some => SketchedLine::through_joints([alpha, eta], some, at),
    }
}

impl<'a> TiltPanel<'a> {
    fn new(arch: &'a TiltedArch) -> Self {
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
            radii: [1.0 - thickness / 2.0, 1.0 + thickness / 2.0],
            thrust: None,
            friction: None,
            marks: Vec::new(),
            blocks: None,
            stones: all,
        };
        let mut moved = None;
        if let Some(TiltMechanism { forces, joints }) = arch.mechanism() {
            let ring = Ring::new(arch.arch.weight(), &eta);
            let [_, p, _, k] = forces;
            let ends = [&at.half_opening.rad, &eta];
            let both = |radius: &RadiusAt<'_>| {
                [Side::Right, Side::Left].map(|side| line(ends, forces, &stones, side, radius))
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
                let found = Linkage { joints, thickness }.moved(AMPLITUDE);
                moved = found.as_ref().map(|(_, by)| *by);
                view.blocks =
                    found.map(|(blocks, _)| Blocks::at_rest(blocks, view.radii, &view.stones));
            }
        }
        Self { arch, view, joints: arch.joints(), moved }
    }

    /// The largest acceleration and the angle of the ground that goes with it.
    fn largest(&self) -> Option<[String; 2]> {
        let figure = self.arch.figure()?;
        let tilt = figure.enclosure(BITS);
        let angle = degrees(&arctangent(&tilt));
        Some([&tilt, &angle].map(|x| super::sketched::rounded(x, DIGITS)))
    }

    fn title(&self) -> [String; 2] {
        let outcome = format!("{} with a tilt of {}", self.arch.outcome(), *self.arch.tilt);
        match self.largest() {
            Some([tilt, angle]) => {
                let falls = if self.arch.arch.is_limited() { "falls from" } else { "falls beyond" };
                [format!("{falls} a tilt of {tilt} g, {angle}° of the ground"), outcome]
            }
            None => [outcome, String::new()],
        }
    }

    fn subject(&self) -> String {
        format!("Arch of {}", self.arch.asked.with_weight(self.arch.arch.weight()))
    }

    /// Words on what a joint does, and where it is.
    fn named(&self, joint: &Joint<'_>, digits: usize) -> [String; 2] {
        let angle = joint.degrees(digits);
        let happens = self.arch.happens(joint.side, joint.of.contact);
        let number = joint.number.zip(self.arch.stones.as_ref());
        let number = number.map(|(joint, stones)| format!(", joint {}", stones.from_crown(joint)));
        let place = match joint.is_crown() {
            true => "the crown".to_owned(),
            false => format!("{angle}° {}{}", joint.side.name(), number.unwrap_or_default()),
        };
        [happens.to_owned(), place]
    }

    fn paragraphs(&self) -> Vec<String> {
        let mut all = vec![format!("{}.", self.subject())];
        let Some([tilt, angle]) = self.largest() else {
            let words = match self
                .arch
                .found
                .as_ref()
                .map(|found| found.as_ref().map(|found| &found.largest))
            {
                Ok(None) => "It does not stand without tilt either: proved.".to_owned(),
                Ok(Some(Ok(LargestTilt::Unlimited))) => {
                    "It stands at every tilt: proved.".to_owned()
                }
                Ok(Some(Err(open))) | Err(open) => words::capital(&format!("{open}.")),
                Ok(Some(Ok(LargestTilt::Limited(..)))) => String::new(),
            };
            all.push(words);
            return all;
        };
        let joints: Vec<String> =
            self.joints.iter().map(|joint| self.named(joint, DIGITS).join(" ")).collect();
        let joints = joints.join("; ");
        all.push(format!(
            "Proved: admissible states exist exactly up to a horizontal acceleration to the right of {tilt} times gravity, \
             which is ground that falls to the right by {angle}°; \
             there give way, from the right to the left: {joints}. To the left all is the mirror image."
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

    fn draw(&self, svg: &mut Svg, scale: &PageScale, (middle, top): Point) {
        let [heading, below] = self.title();
        svg.text(&heading, (middle, top + 12.0), Type::new(TITLE, INK).at(Anchor::Middle));
        svg.text(&below, (middle, top + 36.0), Type::new(LABEL, INK).at(Anchor::Middle));
        self.view.body(svg, scale);
        self.names(svg, scale);
        self.view.lines(svg, scale);
        self.view.marks(svg, scale);
        // Which way it is pushed.
        let y = top + 64.0;
        svg.group("tilt", |svg| {
            svg.text("pushed to the right", (middle, y), Type::new(SMALL, INK).at(Anchor::Middle));
            arrow(svg, (middle - 60.0, y + 16.0), (middle + 60.0, y + 16.0));
        });
    }

    /// The joints, outside the arch or, of hinges at the intrados, inside it.
    fn names(&self, svg: &mut Svg, scale: &PageScale) {
        let outer = self.view.radii[1];
        svg.group("names", |svg| {
            for joint in &self.joints {
                let angle = joint.of.angle.double();
                let near = |[x, y]: &[f64; 2]| (x.atan2(*y) - angle).abs() < 0.2;
                let corners = self.view.blocks.iter().flat_map(Blocks::corners).filter(near);
                let out = corners.map(|[x, y]| x.hypot(y)).fold(outer, f64::max);
                let room = AWAY / scale.radius;
                let guide =
                    [outer + 0.4 * room, out + 0.8 * room].map(|r| scale.polar(angle, r, 1.0));
                svg.stroke(&Path::through(guide), Stroke::new(GUIDE, 1.0));
                let (x, y) = scale.polar(angle, out + room, 1.0);
                let (across, down) = (angle.sin(), -angle.cos());
                let style = Type::new(SMALL, INK).at(Anchor::beside(across)).on(WHITE);
                let [happens, place] = self.named(joint, 4);
                let at = (x + 4.0 * across, y + 14.0 * down);
                svg.text(&happens, (at.0, at.1 - 9.0), style);
                svg.text(&place, (at.0, at.1 + 9.0), style);
            }
        });
    }
}
