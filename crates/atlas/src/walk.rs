//! Walk from one end of a form to the other, in pieces as long as the tolerance lets them be.

use super::form::CurveForm;
use super::search::{self, CurvePoint};
use super::tube::{Node, Tube};
use super::variable::Variable;
use crate::number::Ball;

/// Nodes in order, and what lies between each and the next: a tube, or nothing where none is proved.
#[derive(Clone, Debug)]
pub(super) struct Walk {
    pub nodes: Vec<Node>,
    pub tubes: Vec<Option<Tube>>,
}

impl Walk {
    /// Tells whether the point with these values is proved to be on the curve, in the first tube or in the last.
    pub(super) fn reaches(
        &self,
        form: &CurveForm,
        value: impl Fn(Variable) -> Ball,
        is_first: bool,
    ) -> bool {
        let tube = if is_first { self.tubes.first() } else { self.tubes.last() };
        let (s, root) = form.point(value);
        tube.and_then(Option::as_ref).is_some_and(|tube| tube.holds(&s, &root))
    }
}

/// The parts into which the way is cut at least.
const PARTS: f64 = 4.0;
/// A piece of this part of the way that cannot be proved is left as a gap; each gap is twice as long as the last.
const SHORTEST: f64 = 1e-7;
/// A step is this part of the one that would just do.
const CARE: f64 = 0.9;
/// A step is longer than the last one by this factor at most, and not at all after one that failed.
const GROWTH: f64 = 1.5;
/// A step is at least this part of the last one, and half of one that could not be proved.
const LOSS: f64 = 1.0 / 3.0;

/// The largest half-width of a tube in the coordinates in which maps are drawn.
pub(super) fn width(form: &CurveForm, tube: &Tube) -> f64 {
    let is_drawn = |variable: &Variable| Variable::PLANE.contains(variable);
    let widths = form.unknowns.iter().zip(&tube.widths).filter(|(unknown, _)| is_drawn(unknown));
    widths.map(|(_, width)| width.to_float().to_f64()).fold(0.0, f64::max)
}

/// Walks a form from a start towards a parameter, up or down, until it is beyond another one; no tube is wider than the
/// tolerance. `None` if there is nothing to start from or no node to go on from.
pub(super) fn walk(
    form: &CurveForm,
    from: f64,
    start: Vec<f64>,
    (to, until): (f64, f64),
    tolerance: f64,
) -> Option<Walk> {
    let first = Node::prove(form, search::point(form, from, start)?)?;
    let (mut nodes, mut tubes) = (vec![first], Vec::new());
    // Lengths are parts of the whole way.
    let way = to - from;
    let longest = 1.0 / PARTS;
    let (mut step, mut growth, mut gap) = (longest, GROWTH, SHORTEST);
    while let Some(last) = nodes.last().filter(|node| (until - node.sketch.s) / way > 0.0) {
        let left = (to - last.sketch.s) / way;
        // No short rest: what is left is one step, or two of one length.
        let length = match left / step {
            rest if rest <= 1.05 => left,
            rest if rest < 2.0 => left / 2.0,
            _ => step,
        };
        let beyond = |length: f64| if length < left { last.sketch.s + length * way } else { to };
        let next = beyond(length);
        let node = || Node::prove(form, search::point(form, next, ahead(&last.sketch, next))?);
        let proved = node().and_then(|node| {
            let tube = Tube::prove(form, last, &node)?;
            Some((node, tube))
        });
        let factor = match &proved {
            // The width grows like the fourth power of the length.
            Some((_, tube)) => CARE * (tolerance / width(form, tube)).powf(0.25),
            None => 0.5,
        };
        step = (length * factor.clamp(LOSS, growth)).min(longest);
        growth = if proved.is_some() { GROWTH } else { 1.0 };
        match proved {
            Some((node, tube)) if width(form, &tube) <= tolerance => {
                nodes.push(node);
                tubes.push(Some(tube));
            }
            _ if length > SHORTEST => {}
            _ => {
                gap *= 2.0;
                let next = beyond(gap);
                let found = search::point(form, next, ahead(&last.sketch, next))?;
                nodes.push(Node::prove(form, found)?);
                tubes.push(None);
                step = longest;
            }
        }
    }
    Some(Walk { nodes, tubes })
}

/// Where the tangent leads.
fn ahead(from: &CurvePoint, s: f64) -> Vec<f64> {
    from.x.iter().zip(&from.slopes).map(|(x, slope)| x + slope * (s - from.s)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::curve::Curve;
    use super::*;
    use crate::arch::SelfWeight;

    fn rotation() -> CurveForm {
        Curve::Rotation.legs(SelfWeight::Heyman).swap_remove(0).form
    }

    #[test]
    fn each_tube_is_as_narrow_as_was_asked() {
        for tolerance in [1e-2, 1e-5] {
            let walk = walk(&rotation(), 0.0, vec![0.0, 0.0], (1.5, 1.5), tolerance).unwrap();
            assert_eq!(walk.nodes.len(), walk.tubes.len() + 1);
            for tube in &walk.tubes {
                assert!(width(&rotation(), tube.as_ref().unwrap()) <= tolerance);
            }
            assert!(walk.nodes.windows(2).all(|pair| pair[0].sketch.s < pair[1].sketch.s));
            assert_eq!(walk.nodes.last().unwrap().sketch.s, 1.5);
        }
    }

    /// A part that cannot be proved is a gap, which is seen, and the way goes on behind it.
    #[test]
    fn no_tube_is_as_narrow_as_nothing() {
        let walk = walk(&rotation(), 0.0, vec![0.0, 0.0], (1.5, 1.5), 0.0).unwrap();
        assert!(!walk.tubes.is_empty() && walk.tubes.iter().all(Option::is_none));
        assert_eq!(walk.nodes.last().unwrap().sketch.s, 1.5);
    }

    #[test]
    fn there_is_no_way_from_a_point_that_is_no_root() {
        assert!(walk(&rotation(), 0.5, vec![f64::NAN, 0.0], (1.5, 1.5), 1e-3).is_none());
    }
}
