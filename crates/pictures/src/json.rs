//! JSON: `couplet.drawing/2`. Fields may be added, none changes its meaning.

use super::Sketched;
use super::caption::name;
use super::falling::Falling;
use super::metres::{Loads, Metres, Size};
use crate::arch::mechanism::{Joint, Mechanism, Twist};
use crate::atlas::{Block, Collapse, Forces, Sketch, SketchedLine, Subject, moved};
use crate::number::{Ball, Drawable};
use crate::problem::Mode;
use crate::report::Record;
use rug::float::Round;
use serde_json::{Value as Json, json};

/// Digits of a value; its double is exact for them.
const DIGITS: usize = 17;

/// A value correctly rounded, with bounds, and the nearest double.
fn figure(x: &Ball) -> Json {
    size(&Size::from(x.clone()))
}

/// Writes a size, of what may be known exactly.
fn size(x: &Size) -> Json {
    let (Some(rounded), Some(double)) = (x.rounded(DIGITS), x.value.nearest_double()) else {
        return enclosure(&x.value);
    };
    let [value, lower, upper] =
        [rounded.value, rounded.lower, rounded.upper].map(|decimal| decimal.to_string());
    json!({ "value": value, "lower": lower, "upper": upper, "double": double })
}

/// A double with bounds: what it is next to a number that it may be.
fn enclosure(x: &Ball) -> Json {
    let [lower, upper] = [x.lower().to_f64_round(Round::Down), x.upper().to_f64_round(Round::Up)];
    let double = x.nearest_double().unwrap_or_else(|| x.mid().to_f64());
    json!({ "lower": lower, "upper": upper, "double": double })
}

fn given(sketch: &Sketch) -> Record {
    let mut fields = Record::default();
    fields.add("weight", sketch.weight.name());
    let (landmark, arch, thickness) = match &sketch.subject {
        Subject::Landmark(landmark) => (Some(landmark.symbol()), None, None),
        Subject::Least(arch) | Subject::Standing { arch, is_chosen: true, .. } => {
            (None, Some(arch), None)
        }
        Subject::Standing { arch, thickness, .. } | Subject::Sliding { arch, thickness } => {
            (None, Some(arch), Some(thickness.to_string()))
        }
    };
    fields.add("landmark", landmark);
    fields.add("half_opening_given", arch.map(|arch| arch.half_opening().to_string()));
    let has_friction = !matches!(sketch.subject, Subject::Sliding { .. });
    fields.add(
        "friction_given",
        arch.filter(|_| has_friction).map(|arch| arch.friction().to_string()),
    );
    fields.add("thickness_given", thickness);
    let stones = sketch.stones.as_ref();
    fields.add("stone_joints", stones.map(|_| sketch.stone_joints()));
    let asymmetric = match &sketch.subject {
        Subject::Standing { asymmetric, .. } => asymmetric.first(),
        _ => None,
    };
    fields.add_bounds("asymmetric_thickness", asymmetric);
    fields
}

/// Measures of an arch, m and kN.
fn measures(of: &Metres) -> Json {
    let load = |get: fn(&Loads) -> &Size| of.loads.as_ref().map(|loads| size(get(loads)));
    json!({
        "measured_at": of.circle.name(),
        "radius_m": size(&of.radius),
        "thickness_m": size(&of.thickness),
        "span_m": size(&of.span),
        "rise_m": size(&of.rise),
        "unit_force_kn": load(|loads| &loads.unit),
        "weight_kn": load(|loads| &loads.weight),
        "reaction_kn": load(|loads| &loads.reaction),
    })
}

/// Points in a unit of so many `r`.
pub(crate) fn polyline(points: impl Iterator<Item = [f64; 2]>, unit: f64) -> Json {
    points.map(|point| Vec::from(point.map(|x| x * unit))).collect::<Vec<_>>().into()
}

fn forces(forces: &Forces, metres: Option<&Metres>, unit: f64) -> Json {
    let at_limit = forces
        .marks
        .iter()
        .map(|mark| json!({ "contact": mark.contact.name(), "joint": figure(&mark.at) }));
    let polyline = |line: &SketchedLine| polyline(line.places(), unit);
    let loads = metres.and_then(|of| of.loads.as_ref());
    json!({
        "thrust": figure(&forces.thrust),
        "thrust_kn": loads.map(|loads| size(&loads.thrust(&forces.thrust))),
        "limited_by": forces.limited_by,
        "beyond": forces.beyond.as_ref().map(|by| figure(&(by.clone() * by.of_double(unit)))),
        "crown_moments": forces.moments.each_ref().map(enclosure),
        "thrust_lines": forces.thrust_lines.iter().map(polyline).collect::<Vec<_>>(),
        "friction_line": polyline(&forces.friction_line),
        "at_limit": at_limit.collect::<Vec<_>>(),
    })
}

fn joint(contact: &str, at: &Ball, rate: &Ball) -> Json {
    json!({ "contact": contact, "joint": figure(at), "rate": figure(rate) })
}

/// The joints from the shoulder; a crown that opens along its whole joint is no pair of hinges.
fn joints(mechanism: &Mechanism<Ball>, thickness: &Ball) -> Vec<Json> {
    let hinge = |of: &Joint<Ball>| joint(of.contact.name(), &of.at.rad, &of.rate);
    let crown = match (mechanism.crown.first(), mechanism.opening(thickness)) {
        (Some(crown), Some(opening)) => Some(joint(OPENS, &crown.at.rad, &opening)),
        (crown, _) => crown.map(hinge),
    };
    mechanism.joints.iter().map(hinge).chain(crown).collect()
}

/// The contact of a crown that opens.
const OPENS: &str = "opens at the crown";

fn twist(twist: &Twist<Ball>) -> Json {
    json!({
        "rotation": enclosure(&twist.rotation),
        "velocity": twist.velocity.each_ref().map(enclosure),
    })
}

/// A block where it has moved to.
pub(crate) fn placed(block: &Block, radii: [f64; 2], unit: f64) -> Json {
    let [cos, sin] = block.motion.turn;
    let corners = block.corners(radii).map(|at| block.motion.to(&at).map(|x| x * unit));
    json!({
        "between": block.between,
        "rotation": sin.atan2(cos),
        "shift": block.motion.shift.map(|x| x * unit),
        "corners": corners.collect::<Vec<_>>(),
    })
}

fn collapse(sketch: &Sketch, collapse: &Collapse, amplitude: f64, unit: f64) -> Json {
    let mechanism = &collapse.mechanism;
    let moved = moved(collapse, &sketch.at, amplitude);
    let blocks = moved.blocks.iter().map(|moved| {
        let mut block = placed(moved, sketch.radii(), unit);
        block["twist"] = json!(collapse.twists.get(moved.place).map(twist));
        block
    });
    json!({
        "mode": name(sketch, collapse.mode).0,
        "flow_rule": if collapse.is_dilatant { "associated" } else { "without dilatancy" },
        "joints": joints(mechanism, &sketch.at.thickness),
        "crown_drop": enclosure(&collapse.crown_drop),
        "power": enclosure(&collapse.friction_power),
        "weight_power": enclosure(&collapse.power),
        "amplitude": moved.by * unit,
        "blocks": blocks.collect::<Vec<_>>(),
    })
}

/// All geometry as numbers: the right half, to the right and up of the centre.
pub(super) fn record(report: &Sketched) -> Record {
    let arch = |(place, sketch): (usize, &Sketch)| {
        let mut fields = given(sketch);
        let metres = report.metres(sketch);
        let unit = metres.as_ref().map_or(1.0, Metres::radius_told);
        let verdict = match () {
            _ if sketch.stands() => "stands",
            _ if sketch.falls() => "falls",
            _ => "collapses",
        };
        fields.add("verdict", verdict);
        let at = &sketch.at;
        let has = |of: fn(Mode) -> bool| sketch.collapses.iter().any(|c| of(c.mode));
        let friction = match sketch.is_limited {
            true => figure(&at.friction),
            false => "inf".into(),
        };
        fields.add("half_opening", figure(&at.half_opening.rad));
        fields.add("thickness", figure(&at.thickness));
        fields.add("friction", friction);
        fields.add("thrust", (!sketch.stands()).then(|| figure(&at.thrust)));
        let turns = has(|mode| mode != Mode::Sliding);
        fields.add("rotation_joint", turns.then(|| figure(&at.rotation_joint.rad)));
        fields
            .add("sliding_joint", has(Mode::slides_inside).then(|| figure(&at.sliding_joint.rad)));
        fields.add("lines", {
            let all = sketch.forces.iter();
            all.map(|of| forces(of, metres.as_ref(), unit)).collect::<Vec<_>>()
        });
        let mechanisms =
            sketch.collapses.iter().map(|c| collapse(sketch, c, report.style.amplitude, unit));
        fields.add("measures", metres.as_ref().map(measures));
        fields.add("mechanisms", mechanisms.collect::<Vec<_>>());
        let falling = Falling::of(sketch);
        let between = report.between.get(place);
        let ends = between.map(|ends| ends.each_ref().map(|end| end.as_ref().map(figure)));
        fields.add("between_frictions", ends.map(|ends| json!(ends)));
        fields.add("proved", falling.as_ref().map(Falling::proved));
        fields.add("drawn_only", falling.as_ref().map(|of| of.drawn_only(report)));
        fields
    };
    let unit = report.measures.as_ref().map_or("r", |measures| measures.unit().name());
    let mut file = Record::of("couplet.drawing/2");
    file.add("unit", unit);
    file.add_list("arches", report.sketches.iter().enumerate().map(arch));
    file
}
