//! An arch for programs that draw: lines and arcs in units of `r` or in metres, `y` up, each kind on a layer of its
//! own, with the angles of the joints and the sizes. An arch that is shown with several modes is a block, which each
//! panel inserts.

use super::Sketched;
use super::arcs::arcs;
use super::caption::title;
use super::dxf_file::{DxfAnchor, DxfFile, DxfUnit};
use super::joints::named;
use super::metres::{Metres, Size};
use super::numbers::{label, shown};
use crate::arch::mechanism::Contact;
use crate::atlas::{Collapse, Sketch};
use crate::sketch::{Blocks, CROWN, across};
use std::io;

/// The layers and their colours by number.
const LAYERS: [(&str, u8); 9] = [
    ("ARCH", 7),
    ("STONES", 8),
    ("THRUST", 1),
    ("FRICTION", 5),
    ("HINGES", 7),
    ("SLIDING", 5),
    ("MECHANISM", 3),
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
/// Digits of a size.
const DIGITS: usize = 6;
/// The radius of a hinge.
const HINGE: f64 = 0.015;

fn polar(joint: f64, radius: f64) -> [f64; 2] {
    [radius * joint.sin(), radius * joint.cos()]
}

fn mirrored([x, y]: [f64; 2], side: f64) -> [f64; 2] {
    [side * x, y]
}

fn arch(dxf: &mut DxfFile, sketch: &Sketch, half: bool) {
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

fn marks(dxf: &mut DxfFile, sketch: &Sketch, collapse: Option<&Collapse>, sides: &[f64]) {
    let [inner, outer] = sketch.radii();
    for (contact, joint) in super::at_limit(sketch, collapse) {
        let is_crown = joint < CROWN * sketch.half_opening();
        for side in sides.iter().take(if is_crown { 1 } else { sides.len() }) {
            let at = |radius| mirrored(polar(joint, radius), *side);
            match contact {
                Contact::Extrados => dxf.circle("HINGES", at(outer), HINGE),
                Contact::Intrados => dxf.circle("HINGES", at(inner), HINGE),
                _ => dxf.line("SLIDING", [at(inner), at(outer)]),
            }
        }
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

/// The heading of a panel, and the angles of its joints beyond the extrados.
fn texts(dxf: &mut DxfFile, sketch: &Sketch, collapse: Option<&Collapse>, out: f64) {
    let [heading, words] = title(sketch, collapse);
    for (line, words) in [words, heading].iter().enumerate().filter(|(_, words)| !words.is_empty())
    {
        let at = [0.0, out + (2.5 + 1.6 * line as f64) * LETTERS];
        dxf.text("TEXT", words, (at, DxfAnchor::Middle), (LETTERS, 0.0));
    }
    let [_, outer] = sketch.radii();
    let alpha = sketch.half_opening();
    let joints = named(sketch, &super::at_limit(sketch, collapse));
    let joints = joints.into_iter().map(|of| (of.at, of.name));
    for (joint, name) in [(alpha, label("α", alpha))].into_iter().chain(joints) {
        let at = polar(joint, outer + LETTERS);
        let anchor = if joint.sin() > 0.3 { DxfAnchor::Start } else { DxfAnchor::Middle };
        dxf.text("TEXT", &name, (at, anchor), (LETTERS, 0.0));
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
    dxf.text("DIMENSIONS", words, (at, DxfAnchor::Middle), (LETTERS, turn));
}

/// The centre, and the sizes of an arch that is measured.
fn dimensions(dxf: &mut DxfFile, sketch: &Sketch, metres: Option<&Metres>, half: bool) {
    for (dx, dy) in [(CENTRE, 0.0), (0.0, CENTRE)] {
        dxf.line("DIMENSIONS", [[-dx, -dy], [dx, dy]]);
    }
    let Some(metres) = metres else { return };
    let size = |of: &Size| format!("{} m", shown(of, DIGITS));
    let (alpha, radii) = (sketch.half_opening(), sketch.radii());
    let [x, y] = polar(alpha, metres.share);
    let low = radii.map(|radius| radius * alpha.cos()).into_iter().fold(0.0, f64::min) - AWAY;
    let left = if half { 0.0 } else { -x };
    let of = if half { "half of the span" } else { "span" };
    measure(dxf, [[left, low], [x, low]], &format!("{of} {}", size(&metres.span)));
    let aside = if half { -AWAY } else { -radii[1] - AWAY };
    measure(dxf, [[aside, y], [aside, metres.share]], &format!("rise {}", size(&metres.rise)));
    let thickness = format!("t = {}", size(&metres.thickness));
    let shoulder = radii.map(|radius| polar(alpha + 0.06, radius));
    dxf.line("DIMENSIONS", shoulder);
    let at = polar(alpha + 0.06, radii[1] + LETTERS);
    dxf.text("DIMENSIONS", &thickness, (at, DxfAnchor::Start), (LETTERS, 0.0));
}

/// The geometry for programs that draw.
pub(crate) fn dxf(report: &Sketched, out: &mut dyn io::Write) -> io::Result<()> {
    let half = report.style.half;
    let sides: &[f64] = if half { &[1.0] } else { &[1.0, -1.0] };
    let metres = report.sketches.first().and_then(|sketch| report.metres(sketch));
    let unit = metres.map_or((DxfUnit::Radius, 1.0), |of| (DxfUnit::Metre, of.radius.double()));
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
            marks(&mut dxf, sketch, collapse, sides);
            let radii = sketch.radii();
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
            texts(&mut dxf, sketch, collapse, highest);
            dimensions(&mut dxf, sketch, report.metres(sketch).as_ref(), half);
            dxf.x += 2.0 * widest + BETWEEN;
        }
    }
    out.write_all(dxf.finish().as_bytes())
}
