//! DXF (release 12, text): lines and arcs in units of `r` or in metres, `y` up, each kind on a layer of its own. An
//! arch that is shown with several modes is a block, which each panel inserts.

use super::Sketched;
use super::arcs::{Bulge, arcs};
use crate::arch::mechanism::Contact;
use crate::atlas::{Collapse, Sketch};
use crate::sketch::{Blocks, across};
use std::io;

/// The layers and their colours by number.
const LAYERS: [(&str, u8); 7] = [
    ("ARCH", 7),
    ("STONES", 8),
    ("THRUST", 1),
    ("FRICTION", 5),
    ("HINGES", 7),
    ("SLIDING", 5),
    ("MECHANISM", 3),
];
/// Distance that a line's points may have from the arcs that stand for it, and that as a part of the thickness.
const WITHIN: f64 = 1e-5;
const PART: f64 = 4e-4;
/// Distance between two arches.
const BETWEEN: f64 = 0.5;
/// The radius of a hinge.
const HINGE: f64 = 0.015;

/// A file in the making: pairs of a code and a value.
struct Dxf {
    text: String,
    /// Centre of the arch, in units of `r`.
    x: f64,
    /// A unit of `r` in that of the file.
    unit: f64,
}

/// Decimals of a length in units of `r`.
const DECIMALS: i32 = 7;

impl Dxf {
    fn put(&mut self, code: u16, value: &str) {
        self.text += &format!("{code}\n{value}\n");
    }

    fn put_all(&mut self, pairs: &[(u16, &str)]) {
        pairs.iter().for_each(|(code, value)| self.put(*code, value));
    }

    /// A number as short as it goes.
    fn number(&mut self, code: u16, value: f64, decimals: i32) {
        let text = format!("{value:.*}", decimals.max(0) as usize);
        let short = match text.contains('.') {
            true => text.trim_end_matches('0').trim_end_matches('.'),
            false => &text,
        };
        self.put(code, if short == "-0" { "0" } else { short });
    }

    /// Writes a length, as precise in a small unit as in a large one.
    fn length(&mut self, code: u16, value: f64) {
        let value = value * self.unit;
        self.number(code, value, DECIMALS - self.unit.log10().floor() as i32);
    }

    fn degrees(&mut self, code: u16, value: f64) {
        self.number(code, value, DECIMALS);
    }

    fn begin(&mut self, kind: &str, layer: &str) {
        self.put_all(&[(0, kind), (8, layer)]);
    }

    fn point(&mut self, first: u16, [x, y]: [f64; 2]) {
        self.length(first, self.x + x);
        self.length(first + 10, y);
    }

    fn line(&mut self, layer: &str, [from, to]: [[f64; 2]; 2]) {
        self.begin("LINE", layer);
        self.point(10, from);
        self.point(11, to);
    }

    fn chain(&mut self, layer: &str, points: &[Bulge]) {
        self.begin("POLYLINE", layer);
        // What is zero says nothing, and the release asks for it.
        self.put_all(&[(66, "1"), (10, "0"), (20, "0"), (70, "0")]);
        for (point, bulge) in points {
            self.begin("VERTEX", layer);
            self.point(10, *point);
            if *bulge != 0.0 {
                self.number(42, *bulge, DECIMALS);
            }
        }
        self.put(0, "SEQEND");
    }

    fn circle(&mut self, layer: &str, at: [f64; 2], radius: f64) {
        self.begin("CIRCLE", layer);
        self.point(10, at);
        self.length(40, radius);
    }

    /// About a centre, counter-clockwise from one angle to another, in degrees from the right.
    fn arc(&mut self, layer: &str, center: [f64; 2], radius: f64, [from, to]: [f64; 2]) {
        self.begin("ARC", layer);
        self.point(10, center);
        self.length(40, radius);
        self.degrees(50, from);
        self.degrees(51, to);
    }

    fn insert(&mut self, block: &str) {
        self.begin("INSERT", "ARCH");
        self.put(2, block);
        self.point(10, [0.0, 0.0]);
    }
}

fn polar(joint: f64, radius: f64) -> [f64; 2] {
    [radius * joint.sin(), radius * joint.cos()]
}

fn mirrored([x, y]: [f64; 2], side: f64) -> [f64; 2] {
    [side * x, y]
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
    let sides: &[f64] = if half { &[1.0] } else { &[1.0, -1.0] };
    for joint in sketch.stone_joints() {
        for side in sides.iter().filter(|side| joint > 0.0 || **side > 0.0) {
            dxf.line("STONES", radii.map(|radius| mirrored(polar(joint, radius), *side)));
        }
    }
    let within = WITHIN.min(PART * sketch.thickness());
    for forces in &sketch.forces {
        for line in &forces.thrust_lines {
            dxf.chain("THRUST", &arcs(&across(line.places(), half), within));
        }
        dxf.chain("FRICTION", &arcs(&across(forces.friction_line.places(), half), within));
    }
}

/// The tables of a file: its layers.
fn head(dxf: &mut Dxf, unit: &str) {
    dxf.put(999, &format!("couplet: lengths in {unit}"));
    section(dxf, "HEADER", |dxf| {
        dxf.put_all(&[(9, "$ACADVER"), (1, "AC1009")]);
        if unit == "m" {
            // Younger than the release, and read by those who know them: metres, and metric.
            dxf.put_all(&[(9, "$INSUNITS"), (70, "6"), (9, "$MEASUREMENT"), (70, "1")]);
        }
    });
    section(dxf, "TABLES", |dxf| {
        dxf.put_all(&[(0, "TABLE"), (2, "LAYER"), (70, "7")]);
        for (name, color) in LAYERS {
            let color = color.to_string();
            dxf.put_all(&[(0, "LAYER"), (2, name), (70, "0"), (62, &color), (6, "CONTINUOUS")]);
        }
        dxf.put(0, "ENDTAB");
    });
}

/// A section with what is put into it.
fn section(dxf: &mut Dxf, name: &str, fill: impl FnOnce(&mut Dxf)) {
    dxf.put_all(&[(0, "SECTION"), (2, name)]);
    fill(dxf);
    dxf.put(0, "ENDSEC");
}

/// Under its name, for panels to insert.
fn block(dxf: &mut Dxf, name: &str, sketch: &Sketch, half: bool) {
    dxf.begin("BLOCK", "0");
    dxf.put_all(&[(2, name), (70, "0"), (10, "0"), (20, "0"), (3, name)]);
    arch(dxf, sketch, half);
    dxf.begin("ENDBLK", "0");
}

fn marks(dxf: &mut Dxf, sketch: &Sketch, collapse: Option<&Collapse>, sides: &[f64]) {
    let [inner, outer] = sketch.radii();
    for (contact, joint) in super::at_limit(sketch, collapse) {
        for side in sides {
            let at = |radius| mirrored(polar(joint, radius), *side);
            match contact {
                Contact::Extrados => dxf.circle("HINGES", at(outer), HINGE),
                Contact::Intrados => dxf.circle("HINGES", at(inner), HINGE),
                _ => dxf.line("SLIDING", [at(inner), at(outer)]),
            }
        }
    }
}

fn mechanism(dxf: &mut Dxf, blocks: &Blocks, [inner, outer]: [f64; 2], sides: &[f64]) {
    for block in &blocks.fallen {
        for side in sides {
            let to = |point: [f64; 2]| mirrored(block.motion.to(&point), *side);
            let [upper, lower] = block.between;
            for joint in [upper, lower] {
                // The middle of a keystone is no joint.
                if joint == 0.0 && blocks.has_keystone() {
                    continue;
                }
                dxf.line("MECHANISM", [inner, outer].map(|radius| to(polar(joint, radius))));
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

/// The geometry for programs that draw.
pub(in crate::report) fn dxf(report: &Sketched, out: &mut dyn io::Write) -> io::Result<()> {
    let half = report.style.half;
    let sides: &[f64] = if half { &[1.0] } else { &[1.0, -1.0] };
    let metres = report.sketches.first().and_then(|sketch| report.metres(sketch));
    let unit = metres.map(|of| of.radius.double());
    let mut dxf = Dxf { text: String::new(), x: 0.0, unit: unit.unwrap_or(1.0) };
    head(&mut dxf, if unit.is_some() { "m" } else { "units of r" });
    let name = |place: usize| format!("COUPLET-{}", place + 1);
    let is_block = |sketch: &Sketch| sketch.collapses.len() > 1;
    let blocks = || report.sketches.iter().enumerate().filter(|(_, sketch)| is_block(sketch));
    if blocks().next().is_some() {
        section(&mut dxf, "BLOCKS", |dxf| {
            blocks().for_each(|(place, sketch)| block(dxf, &name(place), sketch, half));
        });
    }
    section(&mut dxf, "ENTITIES", |dxf| {
        for (place, sketch) in report.sketches.iter().enumerate() {
            for collapse in super::shown(sketch) {
                match is_block(sketch) {
                    true => dxf.insert(&name(place)),
                    false => arch(dxf, sketch, half),
                }
                marks(dxf, sketch, collapse, sides);
                let radii = sketch.radii();
                let mut widest = radii[1];
                if let Some(collapse) = collapse {
                    let amplitude = report.style.amplitude;
                    let blocks =
                        Blocks::new(collapse, &sketch.at, amplitude, false, &sketch.stone_joints());
                    widest = blocks.corners().map(|[x, _]| x).fold(widest, f64::max);
                    mechanism(dxf, &blocks, radii, sides);
                }
                dxf.x += 2.0 * widest + BETWEEN;
            }
        }
    });
    dxf.put(0, "EOF");
    out.write_all(dxf.text.as_bytes())
}
