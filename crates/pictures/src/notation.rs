//! The symbols of the problem in an arch, as Figure 1 of the paper has them: angles and forces, an element with its
//! centroid in both models of self-weight on the left.

use super::beside::Beside;
use crate::arch::{Ring, SelfWeight};
use crate::atlas::Sketch;
use crate::picture::color::{INK, WHITE};
use crate::picture::{Anchor, Color, Name, Path, Point, Stroke, Svg, Type, text};
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
/// Room for a name, beside its width.
const NAME: f64 = 14.0;

/// Words on the centroid of the element on the left, and how far above it they stand.
const CENTROIDS: [(&str, f64); 2] = [("G at r(1 + η²/12)", 34.0), ("Heyman-like: at r", 14.0)];
/// Distance of these from the arch.
const ASIDE: f64 = 8.0;

impl ArchNotation<'_> {
    /// The symbols, with their names off all that is drawn.
    pub(super) fn draw(&self, svg: &mut Svg) {
        let (center, style) = (self.scale.center, Type::new(SIZE, INK));
        self.rays(svg);
        svg.disc(center, 2.6, INK);
        let origin = vec![Name::new("O", center, (0.7, 1.0))];
        let names =
            [self.angles(svg), self.lengths(svg), self.element(svg), self.forces(svg), origin];
        let [inner, outer] = self.sketch.radii();
        let ground = |(x, y): Point| {
            let radius = (x - center.0).hypot(y - center.1) / self.scale.radius;
            if (inner..outer).contains(&radius) { look::STONE } else { WHITE }
        };
        svg.names(&names.concat(), |at| style.on(ground(at)));
    }

    /// Names beside the arch.
    pub(super) fn beside(sketch: &Sketch) -> Beside {
        let ([_, outer], alpha) = (sketch.radii(), sketch.half_opening());
        let at = |joint: f64| -outer * joint.sin();
        let element = (at((ELEMENT[0] + ELEMENT[1]) / 2.0), ASIDE);
        let centroids = CENTROIDS.map(|(words, _)| (element.0, ASIDE + text::width(words, SIZE)));
        let name = |words| NAME + text::width(words, SIZE);
        let others = [(at(alpha), FORCE + name("H")), (at(THICKNESS), name("t = ηr"))];
        let left = centroids.into_iter().chain(others).collect();
        Beside { left, right: vec![(0.0, FORCE + name("H"))] }
    }

    /// The ends of the weight of a half, at its centroid by the moment about the centre.
    fn weight(&self) -> [Point; 2] {
        let alpha = self.sketch.half_opening();
        let ring = Ring::new(self.sketch.weight, &self.sketch.thickness());
        let arm = ring.centroid_factor * (1.0 - alpha.cos()) / alpha;
        let (x, y) = self.scale.at([arm, 0.2], -1.0);
        [(x, y), (x, y + FORCE)]
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
    fn angles(&self, svg: &mut Svg) -> Vec<Name> {
        let ([haunch, slides], alpha) = (self.joints(), self.sketch.half_opening());
        let all = [-alpha, haunch, slides].into_iter().zip(ANGLES).zip(["α", "βᵣ", "βₛ"]);
        let angle = |((joint, radius), name): ((f64, f64), &str)| {
            let at = |angle: f64, radius: f64| self.scale.polar(angle, radius, 1.0);
            let mut path = Path::through([at(0.0, radius)]);
            path.arc(self.scale.center, self.scale.radius * radius, [0.0, joint]);
            svg.stroke(&path, LINE);
            let before = joint - joint.signum() * 11.0 / (self.scale.radius * radius);
            arrow(svg, at(before, radius), at(joint, radius));
            let (from, to) = (at(joint / 2.0, radius), at(joint / 2.0, 2.0 * radius));
            Name::new(name, from, (to.0 - from.0, to.1 - from.1))
        };
        all.map(angle).collect()
    }

    /// The radius of the centreline, and the thickness.
    fn lengths(&self, svg: &mut Svg) -> Vec<Name> {
        let [inner, outer] = self.sketch.radii();
        arrow(svg, self.scale.center, self.left(RADIUS, 1.0));
        let middle = self.left(THICKNESS, 1.0);
        for radius in [inner, outer] {
            arrow(svg, middle, self.left(THICKNESS, radius));
        }
        vec![
            Name::new("r", self.left(RADIUS, 0.5), (0.0, -1.0)),
            Name::new("t = ηr", self.left(THICKNESS, outer), (-1.0, 0.0)),
        ]
    }

    /// An element on the left: its centroid, and the point of the centreline.
    fn element(&self, svg: &mut Svg) -> Vec<Name> {
        let ([from, to], radii) = (ELEMENT, self.sketch.radii());
        let sector = self.scale.sector(ELEMENT, radii, -1.0);
        svg.tint(&sector, INK, 0.18);
        svg.stroke(&sector, LINE);
        let middle = (from + to) / 2.0;
        let ring = Ring::new(SelfWeight::Milankovitch, &self.sketch.thickness());
        let [on, centroid] = [1.0, ring.centroid_factor].map(|radius| self.left(middle, radius));
        svg.ring(on, 3.2, WHITE, LINE);
        svg.disc(centroid, 3.2, INK);
        // Outside, what the two are.
        let outside = self.left(middle, radii[1]);
        for (words, up) in CENTROIDS {
            let at = (outside.0 - ASIDE, outside.1 - up);
            svg.text(words, at, Type::new(SIZE - 2.0, INK).at(Anchor::End));
        }
        vec![Name::new("G", centroid, (-1.0, -0.6))]
    }

    /// The reaction of the left shoulder, the thrust on the left half at the crown, and its weight.
    fn forces(&self, svg: &mut Svg) -> Vec<Name> {
        let Some(line) = self.sketch.forces.first().and_then(|forces| forces.thrust_lines.first())
        else {
            return Vec::new();
        };
        let radius = |point: Option<&[f64; 2]>| {
            point.map_or(1.0, |[_, offset]| 1.0 + offset * line.thickness)
        };
        let alpha = self.sketch.half_opening();
        let (x, y) = self.left(alpha, radius(line.points.last()));
        arrow(svg, (x - FORCE, y), (x - NEAR, y));
        arrow(svg, (x, y + FORCE), (x, y + NEAR));
        let (right, top) = self.scale.polar(0.0, radius(line.points.first()), 1.0);
        arrow(svg, (right + FORCE, top - 4.0), (right + NEAR, top - 4.0));
        let [from, to] = self.weight();
        arrow(svg, from, to);
        vec![
            Name::new("H", (x - FORCE, y), (-1.0, 0.0)),
            Name::new("V = wrα", (x, y + FORCE), (-1.0, -0.1)),
            Name::new("H", (right + FORCE, top - 4.0), (1.0, 0.0)),
            Name::new("W", from, (0.0, -1.0)),
        ]
    }
}
