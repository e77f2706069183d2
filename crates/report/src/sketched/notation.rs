//! The symbols of the problem in an arch, as Figure 1 of the paper has them: angles and forces, an element with its
//! centroid in both models of self-weight on the left.

use crate::arch::{Ring, SelfWeight};
use crate::atlas::{Sketch, SketchedLine};
use crate::picture::color::{INK, WHITE};
use crate::picture::labels::Labels;
use crate::picture::room::about;
use crate::picture::{Anchor, Color, Path, Point, Stroke, Svg, Type, text};
use crate::sketch::{PageScale, across, arrow, look};

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

/// Half the width and height of a text.
fn half(words: &str) -> Point {
    (text::width(words, SIZE) / 2.0 + 2.0, 0.62 * SIZE)
}

impl ArchNotation<'_> {
    pub(super) fn draw(&self, svg: &mut Svg) {
        let mut labels = Labels { lines: self.lines(), ..Labels::default() };
        self.rays(svg);
        self.angles(svg, &mut labels);
        self.lengths(svg, &mut labels);
        self.element(svg, &mut labels);
        self.forces(svg, &mut labels);
        let (x, y) = self.scale.center;
        svg.disc((x, y), 2.6, INK);
        text(svg, "O", (x + 9.0, y + 13.0), Anchor::Start, None);
    }

    /// The lines that names keep off: the faces, the centreline, the lines of thrust and of friction, and what is
    /// measured.
    fn lines(&self) -> Vec<Vec<Point>> {
        let ([inner, outer], alpha) = (self.sketch.radii(), self.sketch.half_opening());
        let circle = |radius: f64| (-60..=60).map(move |k| (f64::from(k) / 60.0 * alpha, radius));
        let circles = [inner, 1.0, outer].map(|radius| -> Vec<Point> {
            circle(radius).map(|(joint, radius)| self.scale.polar(joint, radius, 1.0)).collect()
        });
        let drawn = self
            .sketch
            .forces
            .iter()
            .flat_map(|of| of.thrust_lines.iter().chain([&of.friction_line]));
        let along = |line: &SketchedLine| -> Vec<Point> {
            across(line.places(), false).into_iter().map(|at| self.scale.at(at, 1.0)).collect()
        };
        let center = self.scale.center;
        let straight = [
            vec![center, self.left(RADIUS, 1.0)],
            [inner, outer].map(|radius| self.left(THICKNESS, radius)).to_vec(),
            self.weight().to_vec(),
            vec![center, self.left(alpha, inner)],
        ];
        let sides = ELEMENT.map(|joint| [inner, outer].map(|r| self.left(joint, r)).to_vec());
        circles.into_iter().chain(drawn.map(along)).chain(straight).chain(sides).collect()
    }

    /// The ends of the weight of a half, at its centroid by the moment about the centre.
    fn weight(&self) -> [Point; 2] {
        let alpha = self.sketch.half_opening();
        let ring = Ring::new(self.sketch.weight, &self.sketch.thickness());
        let arm = ring.centroid_factor * (1.0 - alpha.cos()) / alpha;
        let (x, y) = self.scale.at([arm, 0.2], -1.0);
        [(x, y), (x, y + FORCE)]
    }

    /// Writes a name beside a point, off all lines if it can be.
    fn name(&self, svg: &mut Svg, labels: &mut Labels, words: &str, (at, towards): (Point, Point)) {
        let middle = labels.beside(at, half(words), towards);
        let (x, y) = self.scale.center;
        let radius = (middle.0 - x).hypot(middle.1 - y) / self.scale.radius;
        let [inner, outer] = self.sketch.radii();
        let is_on_stone = (inner..outer).contains(&radius);
        let ground = if is_on_stone { look::STONE } else { WHITE };
        text(svg, words, middle, Anchor::Middle, Some(ground));
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
    fn angles(&self, svg: &mut Svg, labels: &mut Labels) {
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
            let (from, to) = (at(joint / 2.0, radius), at(joint / 2.0, 2.0 * radius));
            self.name(svg, labels, name, (from, (to.0 - from.0, to.1 - from.1)));
        }
    }

    /// The radius of the centreline, and the thickness.
    fn lengths(&self, svg: &mut Svg, labels: &mut Labels) {
        let [inner, outer] = self.sketch.radii();
        let center = self.scale.center;
        arrow(svg, center, self.left(RADIUS, 1.0));
        self.name(svg, labels, "r", (self.left(RADIUS, 0.5), (0.0, -1.0)));
        let middle = self.left(THICKNESS, 1.0);
        for radius in [inner, outer] {
            arrow(svg, middle, self.left(THICKNESS, radius));
        }
        self.name(svg, labels, "t = ηr", (self.left(THICKNESS, outer), (-1.0, 0.0)));
    }

    /// An element on the left: its centroid, and the point of the centreline.
    fn element(&self, svg: &mut Svg, labels: &mut Labels) {
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
        let style = Type::new(SIZE - 2.0, INK).at(Anchor::End);
        for (words, up) in [("G at r(1 + η²/12)", 34.0), ("Heyman-like: at r", 14.0)] {
            let at = (outside.0 - 8.0, outside.1 - up);
            svg.text(words, at, style);
            let (long, high) = half(words);
            labels.taken.push(about((at.0 - long, at.1), (long, high)));
        }
        labels.taken.push(about(on, (4.0, 4.0)));
        self.name(svg, labels, "G", (centroid, (-1.0, -0.6)));
    }

    /// The reaction of the left shoulder, the thrust on the left half at the crown, and its weight.
    fn forces(&self, svg: &mut Svg, labels: &mut Labels) {
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
        let [from, to] = self.weight();
        arrow(svg, from, to);
        self.name(svg, labels, "W = wrα", (from, (0.0, -1.0)));
    }
}
