//! The purely rotational states near their ends, in unknowns that tell their joint as well as all else: over the half
//! opening a tube about its square tells little of it where it is small.
//!
//! At the origin the joint is the half opening times the root of a ratio, which is regular. At the end of rotation it
//! falls upright, like a square root, and is the parameter itself.

use super::arc::CubicArc;
use super::cubic::exact;
use super::curve::Curve;
use super::end::{CurveEnd, EndValues};
use super::form::CurveForm;
use super::law::Law;
use super::place::Place;
use super::section::Section;
use super::trace::{Piece, Trace};
use super::variable::Variable;
use super::walk::walk;
use crate::certify::Undecided;
use crate::number::{Ball, Field, Jet};
use crate::problem::Landmark;

/// The square of the joint up to which it goes, 46 degrees: on the whole way the half opening falls.
const SQUARE: f64 = 0.64;

/// The half opening up to which it goes from the origin, rad.
const OPENING: f64 = 1.25;

/// The rotational states from the origin, with the half opening as the parameter and the ratio of the joint to it among
/// the unknowns; both ends are proved to be on the curve.
pub fn rotation_start(trace: &Trace, tolerance: f64) -> Result<Section, Undecided> {
    use {Law as L, Variable as V};
    let zero = exact(0.0);
    // The form of flat arches, whose scale is the half opening here.
    let over_opening = Curve::Rotation.legs(trace.weight).swap_remove(0).form;
    let form = CurveForm {
        parameter: V::Inclination,
        unknowns: vec![V::HalfOpening, V::JointRatio, V::JointSquare, V::Thickness],
        laws: vec![L::OpeningRatio, L::FlatTurning, L::JointRatio, L::Rotation],
        given: Some((V::OpeningRatio, exact(1.0))),
        ..over_opening
    };
    let start = |variable| match variable {
        V::JointRatio => exact(0.5),
        _ => zero.clone(),
    };
    section(trace, form, start, OPENING, tolerance, |root| match root {
        [opening, _, square, thickness] => {
            Some((opening.clone(), [square.clone(), thickness.clone()]))
        }
        _ => None,
    })
}

/// The rotational states from their end back, with the square of the joint as the parameter; both ends are proved to be
/// on the curve.
pub fn rotation_end(trace: &Trace, tolerance: f64) -> Result<Section, Undecided> {
    let over_opening = Curve::Rotation.legs(trace.weight).swap_remove(0).form;
    let (parameter, unknowns) =
        (Variable::JointSquare, vec![Variable::HalfOpening, Variable::Thickness]);
    let form = CurveForm { parameter, unknowns, ..over_opening };
    let end = EndValues::of(CurveEnd::Landmark(Landmark::RotationEnd), trace.weight)?;
    section(
        trace,
        form,
        |variable| end.value(variable),
        SQUARE,
        tolerance,
        |root| match root {
            [opening, thickness] => Some((opening.clone(), [exact(SQUARE), thickness.clone()])),
            _ => None,
        },
    )
}

/// A part of a trace in another form, from an end whose parameter is zero to a parameter; `over_opening` has the half
/// opening of a root, and the root over that.
fn section(
    trace: &Trace,
    form: CurveForm,
    start: impl Fn(Variable) -> Ball,
    to: f64,
    tolerance: f64,
    over_opening: impl Fn(&[Ball]) -> Option<(Ball, [Ball; 2])>,
) -> Result<Section, Undecided> {
    let about = |what: &str| Undecided::new(format!("{}, {}: {what}", trace.curve, trace.weight));
    let (_, at_start) = form.point(&start);
    let guess = at_start.iter().map(|value| value.mid().to_f64()).collect();
    let walk = walk(&form, 0.0, guess, (to, to), tolerance);
    let walk = walk.ok_or_else(|| about("a node cannot be proved"))?;
    let is_met = walk.reaches(&form, start, true);
    let [Some(first), Some(last)] = [walk.nodes.first(), walk.nodes.last()] else {
        return Err(about("it has no node"));
    };
    let ends = [first, last].map(|node| Place::new(&form, &exact(node.sketch.s), &node.root));
    let joins = over_opening(&last.root).is_some_and(|(opening, root)| {
        trace.tube_at(&opening).is_some_and(|(_, tube)| tube.holds(&opening, &root))
    });
    match is_met && joins {
        true => Ok(Section { form, walk, ends }),
        false => Err(about("its ends are not proved to be on it")),
    }
}

/// The half opening over the joint, on a part of a piece of that; `None` in a gap.
pub fn over_joint(piece: &Piece, range: [f64; 2]) -> Option<CubicArc> {
    let tube = piece.tube?;
    let index = piece.form.unknowns.iter().position(|v| *v == Variable::HalfOpening)?;
    let jet = |joint: &Ball, order: usize| -> Option<Vec<Ball>> {
        let square = Jet::new(vec![joint.clone(), exact(1.0)], order).square();
        let cubic = tube.about(square.value()).swap_remove(index);
        let step = [joint.int(0)].into_iter().chain((1..=order).map(|k| square.coefficient(k)));
        let step = Jet::new(step.collect(), order);
        let zero = Jet::constant(joint.int(0), order);
        let of = cubic
            .into_iter()
            .rev()
            .fold(zero, |sum, term| sum * &step + &Jet::constant(term, order));
        Some((0..=order).map(|k| of.coefficient(k)).collect())
    };
    CubicArc::of(range, jet, |_| Some(tube.widths[index].to_float().to_f64()))
}

#[cfg(test)]
mod tests {
    use super::super::arc::{Coordinate, arc};
    use super::*;
    use crate::arch::SelfWeight;

    /// The joint at a half opening between is that of the curve over the half opening, and the cubic is as near as
    /// said.
    #[test]
    fn it_is_the_same_curve() {
        for weight in SelfWeight::ALL {
            let trace = Trace::new(Curve::Rotation, weight, 1e-6).unwrap();
            let section = rotation_end(&trace, 1e-5).unwrap();
            assert!(!section.has_gap());
            for piece in section.pieces() {
                let [from, to] = piece.range().map(f64::sqrt);
                let arc = over_joint(&piece, [from, to]).unwrap();
                assert!(arc.off < 2e-4, "{}", arc.off);
                let [a, b] = arc.values;
                let [c, d] = arc.slopes.map(|slope| slope * (to - from));
                let drawn = (a + b) / 2.0 + (c - d) / 8.0;
                let joint = (from + to) / 2.0;
                let place = piece.place(joint * joint).unwrap();
                let opening = place.coordinate(Variable::HalfOpening).unwrap();
                assert!((opening.mid().to_f64() - drawn).abs() < arc.off);
                // Over the half opening the joint is known only as the root of what is near its square.
                let (form, tube) = trace.tube_at(opening).unwrap();
                let there = Place::new(form, opening, &tube.enclosure(opening));
                let there = there.rotation_joint.unwrap();
                assert!((there.mid().to_f64() - joint).abs() < 1e-2, "{joint}");
            }
        }
    }

    /// From the origin the joint is as near as all else.
    #[test]
    fn the_joint_is_regular_at_the_origin() {
        for weight in SelfWeight::ALL {
            let trace = Trace::new(Curve::Rotation, weight, 1e-6).unwrap();
            let section = rotation_start(&trace, 1e-5).unwrap();
            assert!(!section.has_gap());
            for piece in section.pieces() {
                let range = piece.range();
                let drawn = arc(&piece, Coordinate::RotationJoint, range).unwrap();
                assert!(drawn.off < 1e-3, "{}", drawn.off);
                // Of a flat arch it is the half opening over the root of two.
                let ratio = drawn.values[1] / range[1];
                assert!(range[1] > 0.2 || (ratio - 0.5f64.sqrt()).abs() < 1e-2, "{ratio}");
                let place = piece.place(range[1]).unwrap();
                let joint = place.rotation_joint.unwrap().mid().to_f64();
                assert!((joint - drawn.values[1]).abs() < 1e-9);
            }
        }
    }

    /// Another weight's states are not joined.
    #[test]
    fn another_curve_is_refused() {
        let mut wrong = Trace::new(Curve::Rotation, SelfWeight::Heyman, 1e-4).unwrap();
        wrong.weight = SelfWeight::Milankovitch;
        assert!(rotation_end(&wrong, 1e-4).is_err());
    }
}
