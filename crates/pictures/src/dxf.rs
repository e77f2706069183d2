//! An arch for programs that draw: lines and arcs in units of `r` or in the unit of who asks, `y` up, each kind on a
//! layer of its own, with the angles of the joints, the sizes and the forces. An arch that is shown with several modes
//! is a block, which each panel inserts.

use super::Sketched;
use super::caption::title;
use super::dimensions::{pressed, reaction, thrust};
use super::joints::named;
use super::metres::{Metres, Size};
use super::numbers::{label, told};
use crate::arch::mechanism::Contact;
use crate::atlas::Sketch;
use crate::picture::Anchor;
use crate::picture::arcs::arcs;
use crate::picture::dxf::DxfFile;
use crate::problem::measures::LengthUnit;
use crate::sketch::{Blocks, Hull, WholeView, across, on_sides, polar};
use std::io;

/// The layers and their colours by number.
const LAYERS: [(&str, u8); 10] = [
    ("ARCH", 7),
    ("STONES", 8),
    ("THRUST", 1),
    ("FRICTION", 5),
    ("HINGES", 7),
    ("SLIDING", 5),
    ("MECHANISM", 3),
    ("FORCES", 1),
    ("DIMENSIONS", 8),
    ("TEXT", 7),
];
/// Distance that a line's points may have from the arcs that stand for it, and that as a part of the thickness.
const WITHIN: f64 = 1e-5;
const PART: f64 = 4e-4;
/// Distance between two arches.
const BETWEEN: f64 = 0.8;
/// Height of letters, half of the cross at the centre, and how far off the sizes stand.
const LETTERS: f64 = 0.05;
const CENTRE: f64 = 0.03;
const AWAY: f64 = 0.2;
/// The length of a force and the room that it takes, with its words, beside the arch; and its distance from a joint.
const ARROW: f64 = 0.35;
const FORCE: f64 = 0.55;
const NEAR: f64 = 0.02;
/// Digits of a size.
const DIGITS: usize = 6;
/// The radius of a hinge.
const HINGE: f64 = 0.015;

fn mirrored([x, y]: [f64; 2], side: f64) -> [f64; 2] {
    [side * x, y]
}

/// The outline between two joints, and the joints between stones.
fn ring(dxf: &mut DxfFile, [from, to]: [f64; 2], radii: [f64; 2], stones: &[f64]) {
    let degrees = |joint: f64| 90.0 - joint.to_degrees();
    for radius in radii.into_iter().filter(|radius| *radius > 0.0) {
        dxf.arc("ARCH", [0.0, 0.0], radius, [degrees(to), degrees(from)]);
    }
    let ends = [from, to].map(|joint| ("ARCH", joint));
    for (layer, joint) in ends.into_iter().chain(stones.iter().map(|joint| ("STONES", *joint))) {
        dxf.line(layer, radii.map(|radius| polar(joint, radius)));
    }
}

/// A line of thrust or of friction in an arch of a thickness.
fn line(dxf: &mut DxfFile, layer: &str, points: &[[f64; 2]], thickness: f64) {
    dxf.arcs(layer, &arcs(points, WITHIN.min(PART * thickness)), false);
}

fn arch(dxf: &mut DxfFile, sketch: &Sketch, half: bool) {
    let alpha = sketch.half_opening();
    let stones = sketch.stone_joints();
    let left = stones.iter().filter(|joint| !half && **joint > 0.0).map(|joint| -joint);
    let stones: Vec<f64> = stones.iter().copied().chain(left).collect();
    ring(dxf, [if half { 0.0 } else { -alpha }, alpha], sketch.radii(), &stones);
    for forces in &sketch.forces {
        let thrust = forces.thrust_lines.iter().map(|line| ("THRUST", line));
        for (layer, of) in thrust.chain([("FRICTION", &forces.friction_line)]) {
            line(dxf, layer, &across(of.places(), half), sketch.thickness());
        }
    }
}

fn mark(dxf: &mut DxfFile, (contact, joint): (Contact, f64), [inner, outer]: [f64; 2]) {
    match contact {
        Contact::Extrados => dxf.circle("HINGES", polar(joint, outer), HINGE),
        Contact::Intrados => dxf.circle("HINGES", polar(joint, inner), HINGE),
        _ => dxf.line("SLIDING", [inner, outer].map(|radius| polar(joint, radius))),
    }
}

fn mechanism(dxf: &mut DxfFile, blocks: &Blocks, [inner, outer]: [f64; 2], sides: &[f64]) {
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

/// The angle of a joint, rad, the radius beyond which its name stands, and the name.
type JointName = (f64, f64, String);

/// The heading of a panel, above `out`, and the names of its joints.
fn texts(dxf: &mut DxfFile, headings: &[String], names: &[JointName], out: f64) {
    let lines = headings.iter().rev().filter(|words| !words.is_empty());
    for (line, words) in lines.enumerate() {
        let at = [0.0, out + (2.5 + 1.6 * line as f64) * LETTERS];
        dxf.text("TEXT", words, (at, Anchor::Middle), (LETTERS, 0.0));
    }
    for (joint, radius, name) in names {
        let at = polar(*joint, radius + LETTERS);
        dxf.text("TEXT", name, (at, Anchor::beside(joint.sin())), (LETTERS, 0.0));
    }
}

/// A force, with its head where it acts.
fn force(dxf: &mut DxfFile, [from, to]: [[f64; 2]; 2]) {
    let along = [0, 1].map(|k| (to[k] - from[k]) / ARROW);
    dxf.line("FORCES", [from, to]);
    for across in [-LETTERS / 2.0, LETTERS / 2.0] {
        let [x, y] = [0, 1].map(|k| to[k] - 1.5 * LETTERS * along[k]);
        dxf.line("FORCES", [[x - across * along[1], y + across * along[0]], to]);
    }
}

/// The reaction of the ground on the left shoulder, or on that of the half arch.
fn forces(dxf: &mut DxfFile, sketch: &Sketch, metres: &Metres, half: bool) {
    let (Some(loads), Some(radius)) = (&metres.loads, pressed(sketch)) else { return };
    let side = if half { 1.0 } else { -1.0 };
    let [[x, y], [edge, _]] = [radius, sketch.radii()[1]]
        .map(|radius| mirrored(polar(sketch.half_opening(), radius), side));
    let aside = if half { edge.max(x) } else { edge.min(x) } + side * NEAR;
    force(dxf, [[aside + side * ARROW, y], [aside, y]]);
    force(dxf, [[x, y - NEAR - ARROW], [x, y - NEAR]]);
    // On the right the half opening is told above the force.
    let (anchor, of_thrust) = match half {
        true => (Anchor::Start, [aside + ARROW + LETTERS / 2.0, y]),
        false => (Anchor::End, [aside - LETTERS, y + 1.4 * LETTERS]),
    };
    for (at, words) in
        [(of_thrust, thrust(sketch, metres)), ([x + side * LETTERS, y - ARROW], reaction(loads))]
    {
        dxf.text("FORCES", &words, (at, anchor), (LETTERS, 0.0));
    }
}

/// A line between two points with a stroke across it at each end, and what it measures.
fn measure(dxf: &mut DxfFile, [from, to]: [[f64; 2]; 2], words: &str) {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    let across = [-dy / length * LETTERS / 2.0, dx / length * LETTERS / 2.0];
    dxf.line("DIMENSIONS", [from, to]);
    for [x, y] in [from, to] {
        dxf.line("DIMENSIONS", [[x - across[0], y - across[1]], [x + across[0], y + across[1]]]);
    }
    // Above what lies, and on the left of what stands.
    let sign = if across[1] < 0.0 || across[0] > 0.0 { -1.0 } else { 1.0 };
    let [x, y] = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
    let at = [x + 2.0 * sign * across[0], y + 2.0 * sign * across[1]];
    let turn = if dx.abs() < dy.abs() { 90.0 } else { 0.0 };
    dxf.text("DIMENSIONS", words, (at, Anchor::Middle), (LETTERS, turn));
}

/// The centre, and the sizes of an arch that is measured.
fn dimensions(dxf: &mut DxfFile, sketch: &Sketch, metres: Option<&Metres>, half: bool) {
    for (dx, dy) in [(CENTRE, 0.0), (0.0, CENTRE)] {
        dxf.line("DIMENSIONS", [[-dx, -dy], [dx, dy]]);
    }
    let Some(metres) = metres else { return };
    let size = |of: &Size| told(metres, of, DIGITS);
    // Beyond the forces at a shoulder.
    let (beside, below) = match metres.loads {
        Some(_) => (AWAY + FORCE, AWAY + ARROW),
        None => (AWAY, AWAY),
    };
    let (alpha, radii) = (sketch.half_opening(), sketch.radii());
    let [x, y] = polar(alpha, metres.share);
    let low = radii.map(|radius| radius * alpha.cos()).into_iter().fold(0.0, f64::min) - below;
    let left = if half { 0.0 } else { -x };
    let of = if half { "half of the span" } else { "span" };
    measure(dxf, [[left, low], [x, low]], &format!("{of} {}", size(&metres.span)));
    let aside = if half { -AWAY } else { -radii[1] - beside };
    measure(dxf, [[aside, y], [aside, metres.share]], &format!("rise {}", size(&metres.rise)));
    let thickness = format!("t = {}", size(&metres.thickness));
    let shoulder = radii.map(|radius| polar(alpha + 0.1, radius));
    dxf.line("DIMENSIONS", shoulder);
    let at = polar(alpha + 0.1, radii[1] + LETTERS);
    dxf.text("DIMENSIONS", &thickness, (at, Anchor::Start), (LETTERS, 0.0));
}

/// The geometry for programs that draw.
pub(crate) fn dxf(report: &Sketched, out: &mut dyn io::Write) -> io::Result<()> {
    let half = report.style.half;
    let sides: &[f64] = if half { &[1.0] } else { &[1.0, -1.0] };
    let metres = report.sketches.first().and_then(|sketch| report.metres(sketch));
    let unit = metres.map_or((None, 1.0), |of| (Some(of.unit), of.radius_told()));
    let name = |place: usize| format!("COUPLET-{}", place + 1);
    let is_block = |sketch: &Sketch| sketch.collapses.len() > 1;
    let blocks = || report.sketches.iter().enumerate().filter(|(_, sketch)| is_block(sketch));
    let names: Vec<String> = blocks().map(|(place, _)| name(place)).collect();
    let mut dxf = DxfFile::new(unit, &LAYERS, &names);
    for (place, sketch) in blocks() {
        dxf.block(&name(place), |dxf| arch(dxf, sketch, half));
    }
    dxf.draw();
    for (place, sketch) in report.sketches.iter().enumerate() {
        for collapse in super::shown(sketch) {
            match is_block(sketch) {
                true => dxf.insert(&name(place)),
                false => arch(&mut dxf, sketch, half),
            }
            let (alpha, radii) = (sketch.half_opening(), sketch.radii());
            let marks = super::at_limit(sketch, collapse);
            let on_sides = on_sides(&marks, alpha, sides);
            on_sides.into_iter().for_each(|of| mark(&mut dxf, of, radii));
            let [mut widest, mut highest] = [radii[1]; 2];
            if let Some(collapse) = collapse {
                let amplitude = report.style.amplitude;
                let blocks =
                    Blocks::new(collapse, &sketch.at, amplitude, false, &sketch.stone_joints());
                for [x, y] in blocks.corners() {
                    (widest, highest) = (widest.max(x), highest.max(y));
                }
                mechanism(&mut dxf, &blocks, radii, sides);
            }
            let joints = named(sketch, &marks).into_iter();
            let joints = joints.map(|of| (of.at, radii[1], of.name));
            let shoulder = (alpha, radii[1], label("α", alpha));
            let names: Vec<_> = [shoulder].into_iter().chain(joints).collect();
            texts(&mut dxf, &title(sketch, collapse), &names, highest);
            let metres = report.metres(sketch);
            dimensions(&mut dxf, sketch, metres.as_ref(), half);
            if let Some(metres) = &metres {
                forces(&mut dxf, sketch, metres, half);
            }
            dxf.x += 2.0 * widest + BETWEEN;
        }
    }
    out.write_all(dxf.finish().as_bytes())
}

/// Whole arches whose halves differ, beside each other, each with headings and the names of its joints, with a unit of
/// `r` in that of the file.
pub(crate) fn whole<'a>(
    unit: (Option<LengthUnit>, f64),
    panels: impl Iterator<Item = (&'a WholeView, [String; 3], Vec<JointName>)>,
) -> String {
    let mut dxf = DxfFile::new(unit, &LAYERS, &[]);
    dxf.draw();
    for (view, headings, names) in panels {
        let Hull { left, right, high, .. } = view.hull();
        let (alpha, radii) = (view.half_opening, view.radii);
        ring(&mut dxf, [-alpha, alpha], radii, &view.stones);
        for (layer, halves) in [("FRICTION", &view.friction), ("THRUST", &view.thrust)] {
            let points = halves.as_ref().map(WholeView::across);
            line(&mut dxf, layer, &points.unwrap_or_default(), radii[1] - radii[0]);
        }
        view.marks.iter().for_each(|of| mark(&mut dxf, *of, radii));
        if let Some(blocks) = &view.blocks {
            mechanism(&mut dxf, blocks, radii, &[1.0]);
        }
        texts(&mut dxf, &headings, &names, high);
        dxf.x += 2.0 * right.max(-left) + BETWEEN;
    }
    dxf.finish()
}
