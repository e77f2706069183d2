//! DXF (release 12, text): lines and arcs in units of `r`, `y` up, each kind on a layer of its own.

use super::Sketched;
use super::blocks::Blocks;
use crate::arch::mechanism::Contact;
use crate::atlas::{Line, Sketch};
use std::io;

/// The layers and their colours by number.
const LAYERS: [(&str, u8); 6] =
    [("ARCH", 7), ("THRUST", 1), ("FRICTION", 5), ("HINGES", 7), ("SLIDING", 5), ("MECHANISM", 3)];
/// Between two arches.
const BETWEEN: f64 = 0.5;
/// The radius of a hinge.
const HINGE: f64 = 0.015;

/// A file in the making: pairs of a code and a value.
struct Dxf {
    text: String,
    /// Where the centre of the arch is.
    x: f64,
}

impl Dxf {
    fn put(&mut self, code: u16, value: &str) {
        self.text += &format!("{code}\n{value}\n");
    }

    fn number(&mut self, code: u16, value: f64) {
        self.put(code, &format!("{value:.7}"));
    }

    fn begin(&mut self, kind: &str, layer: &str) {
        self.put(0, kind);
        self.put(8, layer);
    }

    fn point(&mut self, first: u16, [x, y]: [f64; 2]) {
        self.number(first, self.x + x);
        self.number(first + 10, y);
    }

    fn line(&mut self, layer: &str, [from, to]: [[f64; 2]; 2]) {
        self.begin("LINE", layer);
        self.point(10, from);
        self.point(11, to);
    }

    fn chain(&mut self, layer: &str, points: impl Iterator<Item = [f64; 2]>) {
        self.begin("POLYLINE", layer);
        self.put(66, "1");
        self.put(70, "0");
        for point in points {
            self.begin("VERTEX", layer);
            self.point(10, point);
        }
        self.put(0, "SEQEND");
    }

    fn circle(&mut self, layer: &str, at: [f64; 2], radius: f64) {
        self.begin("CIRCLE", layer);
        self.point(10, at);
        self.number(40, radius);
    }

    /// About a centre, counter-clockwise from one angle to another, in degrees from the right.
    fn arc(&mut self, layer: &str, center: [f64; 2], radius: f64, [from, to]: [f64; 2]) {
        self.begin("ARC", layer);
        self.point(10, center);
        self.number(40, radius);
        self.number(50, from);
        self.number(51, to);
    }
}

fn polar(joint: f64, radius: f64) -> [f64; 2] {
    [radius * joint.sin(), radius * joint.cos()]
}

fn mirrored([x, y]: [f64; 2], side: f64) -> [f64; 2] {
    [side * x, y]
}

fn along(line: &Line, half: bool) -> Vec<[f64; 2]> {
    let left = line.places().skip(1).rev().map(|point| mirrored(point, -1.0));
    let left = left.filter(|_| !half);
    left.chain(line.places()).collect()
}

fn arch(dxf: &mut Dxf, sketch: &Sketch, half: bool) {
    let (alpha, radii) = (sketch.half_opening(), sketch.radii());
    let degrees = |joint: f64| 90.0 - joint.to_degrees();
    let from = if half { 0.0 } else { -alpha };
    for radius in radii.into_iter().filter(|radius| *radius > 0.0) {
        dxf.arc("ARCH", [0.0, 0.0], radius, [degrees(alpha), degrees(from)]);
    }
    for joint in [from, alpha] {
        dxf.line("ARCH", radii.map(|radius| polar(joint, radius)));
    }
    for forces in &sketch.forces {
        for line in &forces.thrust_lines {
            dxf.chain("THRUST", along(line, half).into_iter());
        }
        dxf.chain("FRICTION", along(&forces.friction_line, half).into_iter());
    }
}

/// The geometry for programs that draw.
pub(in crate::report) fn dxf(report: &Sketched, out: &mut dyn io::Write) -> io::Result<()> {
    let half = report.style.half;
    let sides: &[f64] = if half { &[1.0] } else { &[1.0, -1.0] };
    let mut dxf = Dxf { text: String::new(), x: 0.0 };
    for (code, value) in
        [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (0, "ENDSEC")]
    {
        dxf.put(code, value);
    }
    for (code, value) in [(0, "SECTION"), (2, "TABLES"), (0, "TABLE"), (2, "LAYER"), (70, "6")] {
        dxf.put(code, value);
    }
    for (name, color) in LAYERS {
        for (code, value) in
            [(0, "LAYER"), (2, name), (70, "0"), (62, &color.to_string()), (6, "CONTINUOUS")]
        {
            dxf.put(code, value);
        }
    }
    for (code, value) in [(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")] {
        dxf.put(code, value);
    }
    for (sketch, collapse) in report.panels() {
        let [inner, outer] = sketch.radii();
        arch(&mut dxf, sketch, half);
        let marks = match collapse {
            Some(collapse) => collapse.joints_at_limit(),
            None => sketch.forces.iter().flat_map(|f| f.marks.iter().map(|m| m.place())).collect(),
        };
        for (contact, joint) in marks {
            for side in sides {
                let at = |radius| mirrored(polar(joint, radius), *side);
                match contact {
                    Contact::Extrados => dxf.circle("HINGES", at(outer), HINGE),
                    Contact::Intrados => dxf.circle("HINGES", at(inner), HINGE),
                    _ => dxf.line("SLIDING", [at(inner), at(outer)]),
                }
            }
        }
        let mut widest = outer;
        if let Some(collapse) = collapse {
            let blocks = Blocks::new(sketch, collapse, report.style.amplitude, false, &[]);
            widest = blocks.corners().map(|[x, _]| x).fold(widest, f64::max);
            for block in &blocks.fallen {
                for side in sides {
                    let to = |point: [f64; 2]| mirrored(block.motion.to(&point), *side);
                    let [upper, lower] = block.between;
                    for joint in [upper, lower] {
                        dxf.line(
                            "MECHANISM",
                            [inner, outer].map(|radius| to(polar(joint, radius))),
                        );
                    }
                    let turned = block.motion.turn[1].atan2(block.motion.turn[0]).to_degrees();
                    let ends = [lower, upper].map(|joint| 90.0 - joint.to_degrees() + turned);
                    let ends = if *side > 0.0 { ends } else { [180.0 - ends[1], 180.0 - ends[0]] };
                    for radius in [inner, outer].into_iter().filter(|radius| *radius > 0.0) {
                        dxf.arc("MECHANISM", to([0.0, 0.0]), radius, ends);
                    }
                }
            }
        }
        dxf.x += 2.0 * widest + BETWEEN;
    }
    dxf.put(0, "ENDSEC");
    dxf.put(0, "EOF");
    out.write_all(dxf.text.as_bytes())
}
