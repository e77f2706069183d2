//! The symbols of the problem in an arch, as Figure 1 of the paper has them: angles and forces, an element with its
//! centroid in both models of self-weight on the left.

use crate::arch::{Ring, SelfWeight};
use crate::atlas::Sketch;
use crate::picture::color::{INK, WHITE};
use crate::picture::{Anchor, Color, Path, Point, Stroke, Svg, Type};
use crate::sketch::{PageScale, arrow, look};

/// The heading.
pub(super) const TITLE: [&str; 2] =
    ["Symbols", "at the triple point T; on the right its mode [r,r,s], one of four"];

/// An arch with its symbols.
pub(super) struct ArchNotation<'a> {
    pub sketch: &'a Sketch,
    pub scale: &'a PageScale,
}

const SIZE: f64 = 17.0;
const LINE: Stroke = Stroke::new(INK, 1.1);
const RAY: Stroke =
    Stroke { color: Color(0x77, 0x77, 0x77), width: 1.0, dashes: &[7.0, 3.0, 1.5, 3.0] };
/// The radii at which angles are marked.
const ANGLES: [f64; 3] = [0.22, 0.36, 0.53];
/// Angles at which `r` and `t` are measured and the element is, on the left, rad from the crown.
const RADIUS: f64 = 1.45;
const THICKNESS: f64 = 1.78;
const ELEMENT: [f64; 2] = [0.78, 0.88];
/// Space below, for a force.
pub(super) const BELOW: f64 = 44.0;
/// The length of a force.
const FORCE: f64 = 74.0;
const NEAR: f64 = 7.0;

fn text(svg: &mut Svg, words: &str, at: Point, anchor: Anchor, ground: Option<Color>) {
    let style = Type::new(SIZE, INK).at(anchor);
    svg.text(words, at, ground.map_or(style, |ground| style.on(ground)));
}

impl ArchNotation<'_> {
    pub(super) fn draw(&self, svg: &mut Svg) {
        self.rays(svg);
        self.angles(svg);
        self.lengths(svg);
        self.element(svg);
        self.forces(svg);
        let (x, y) = self.scale.center;
        svg.disc((x, y), 2.6, INK);
        text(svg, "O", (x + 9.0, y + 13.0), Anchor::Start, None);
    }

    /// A point on the left.
    fn left(&self, joint: f64, radius: f64) -> Point {
        self.scale.polar(joint, radius, -1.0)
    }

    /// The axis, the centreline on the left, and the sides of the angles.
    fn rays(&self, svg: &mut Svg) {
        let ([inner, outer], alpha) = (self.sketch.radii(), self.sketch.half_opening());
        let [haunch, slides] = self.joints();
        let center = self.scale.center;
        let up = |y: f64| self.scale.at([0.0, y], 1.0);
        svg.stroke(&Path::through([up(-0.16), up(outer + 0.04)]), RAY);
        let mut centreline = Path::through([self.left(0.0, 1.0)]);
        centreline.arc(center, self.scale.radius, [0.0, -alpha]);
        svg.stroke(&centreline, RAY);
        for to in [self.left(alpha, inner), self.scale.polar(haunch, inner, 1.0)] {
            svg.stroke(&Path::through([center, to]), RAY);
        }
        svg.stroke(&Path::through([center, self.scale.polar(slides, inner, 1.0)]), RAY);
    }

    /// The haunch and the sliding joint, rad.
    fn joints(&self) -> [f64; 2] {
        let at = &self.sketch.at;
        [&at.rotation_joint, &at.sliding_joint].map(|joint| joint.rad.mid().to_f64())
    }

    /// The half opening on the left, the inner joints on the right, each from the crown.
    fn angles(&self, svg: &mut Svg) {
        let ([haunch, slides], alpha) = (self.joints(), self.sketch.half_opening());
        for ((joint, radius), name) in
            [-alpha, haunch, slides].into_iter().zip(ANGLES).zip(["α", "βᵣ", "βₛ"])
        {
            let at = |angle: f64, radius: f64| self.scale.polar(angle, radius, 1.0);
            let mut path = Path::through([at(0.0, radius)]);
            path.arc(self.scale.center, self.scale.radius * radius, [0.0, joint]);
            svg.stroke(&path, LINE);
            let before = joint - joint.signum() * 11.0 / (self.scale.radius * radius);
            arrow(svg, at(before, radius), at(joint, radius));
            let (middle, aside) = (joint / 2.0, 14.0 / self.scale.radius);
            text(svg, name, at(middle, radius + aside), Anchor::Middle, Some(WHITE));
        }
    }

    /// The radius of the centreline, and the thickness.
    fn lengths(&self, svg: &mut Svg) {
        let [inner, outer] = self.sketch.radii();
        let center = self.scale.center;
        arrow(svg, center, self.left(RADIUS, 1.0));
        let at = self.left(RADIUS, 0.5);
        text(svg, "r", (at.0, at.1 - 12.0), Anchor::Middle, Some(WHITE));
        let middle = self.left(THICKNESS, 1.0);
        for radius in [inner, outer] {
            arrow(svg, middle, self.left(THICKNESS, radius));
        }
        text(svg, "t = ηr", (middle.0, middle.1 + 14.0), Anchor::Middle, Some(look::STONE));
    }

    /// An element on the left: its centroid, and the point of the centreline.
    fn element(&self, svg: &mut Svg) {
        let ([from, to], radii) = (ELEMENT, self.sketch.radii());
        let sector = self.scale.sector(ELEMENT, radii, -1.0);
        svg.tint(&sector, INK, 0.18);
        svg.stroke(&sector, LINE);
        let middle = (from + to) / 2.0;
        let ring = Ring::new(SelfWeight::Milankovitch, &self.sketch.thickness());
        let [on, centroid] = [1.0, ring.centroid_factor].map(|radius| self.left(middle, radius));
        svg.ring(on, 3.2, WHITE, LINE);
        svg.disc(centroid, 3.2, INK);
        text(svg, "G", (centroid.0 - 15.0, centroid.1 - 9.0), Anchor::Middle, Some(look::STONE));
        // Outside, what the two are.
        let outside = self.left(middle, radii[1]);
        let style = Type::new(SIZE - 2.0, INK).at(Anchor::End);
        for (words, up) in [("G at r(1 + η²/12)", 34.0), ("Heyman-like: at r", 14.0)] {
            svg.text(words, (outside.0 - 8.0, outside.1 - up), style);
        }
    }

    /// The reaction of the left shoulder, the thrust on the left half at the crown, and its weight.
    fn forces(&self, svg: &mut Svg) {
        let Some(line) = self.sketch.forces.first().and_then(|forces| forces.thrust_lines.first())
        else {
            return;
        };
        let radius = |point: Option<&[f64; 2]>| {
            point.map_or(1.0, |[_, offset]| 1.0 + offset * line.thickness)
        };
        let alpha = self.sketch.half_opening();
        let (x, y) = self.left(alpha, radius(line.points.last()));
        arrow(svg, (x - FORCE, y), (x - NEAR, y));
        text(svg, "H", (x - FORCE - 6.0, y), Anchor::End, None);
        arrow(svg, (x, y + FORCE), (x, y + NEAR));
        text(svg, "V = wrα", (x - 8.0, y + FORCE - 6.0), Anchor::End, None);
        let (x, y) = self.scale.polar(0.0, radius(line.points.first()), 1.0);
        arrow(svg, (x + FORCE, y - 4.0), (x + NEAR, y - 4.0));
        text(svg, "H", (x + FORCE + 6.0, y - 6.0), Anchor::Start, Some(WHITE));
        // The centroid of a half, by the moment about the centre.
        let ring = Ring::new(self.sketch.weight, &self.sketch.thickness());
        let arm = ring.centroid_factor * (1.0 - alpha.cos()) / alpha;
        let (x, y) = self.scale.at([arm, 0.2], -1.0);
        arrow(svg, (x, y), (x, y + FORCE));
        text(svg, "W = wrα", (x + 2.0, y - 11.0), Anchor::Middle, Some(look::STONE));
    }
}
