//! A curve as a chain of proved pieces.

use super::cubic::exact;
use super::curve::{Curve, Leg};
use super::end::{CurveEnd, EndValues};
use super::form::CurveForm;
use super::place::Place;
use super::tube::{Node, Tube};
use super::variable::Variable;
use super::walk::{Walk, walk, width};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{Ball, Enclosure};
use crate::problem::Line;
use rug::float::Round;

/// The least tolerance: the nodes are doubles.
pub const LEAST_TOLERANCE: f64 = 1e-12;

/// A curve from end to end, as nodes and the pieces between them.
///
/// Guaranteed: on each piece there is, for **each** value of the parameter, exactly one solution in the tube about the
/// cubic that has the values and slopes of its two nodes; the solutions of neighbouring pieces join; and both ends
/// of the curve, which are proved on their own, lie on it. Not guaranteed: anything about a piece that is a gap.
#[derive(Clone, Debug)]
pub struct Trace {
    /// The curve.
    pub curve: Curve,
    /// The self-weight model.
    pub weight: SelfWeight,
    pub(super) ends: [Place; 2],
    parameters: [Ball; 2],
    legs: Vec<(CurveForm, Walk)>,
}

/// A piece of a curve.
#[derive(Clone, Copy, Debug)]
pub struct Piece<'a> {
    pub(super) form: &'a CurveForm,
    from: &'a Node,
    to: &'a Node,
    pub(super) tube: Option<&'a Tube>,
}

/// A node of a curve.
#[derive(Clone, Debug)]
pub struct TracePoint {
    /// The parameter, exactly; at an end the double next to that of the end.
    pub parameter: f64,
    /// The end of the curve, if it is one.
    pub end: Option<CurveEnd>,
    /// The quantities; at an end those of the end.
    pub place: Place,
}

impl Trace {
    /// Follows a curve and proves it piece by piece, with tubes no wider on either side than `tolerance` in `alpha` and
    /// `phi`, rad, and in `eta`: from [`LEAST_TOLERANCE`] up to 1. Undecided if an end cannot be reached.
    pub fn new(curve: Curve, weight: SelfWeight, tolerance: f64) -> Result<Self, Undecided> {
        Self::along(curve, weight, curve.legs(weight), tolerance)
    }

    /// Trace with the inclination `chi` as the parameter, of a line between modes: to it belongs one friction
    /// angle, `phi = chi - sin chi cos chi`, whatever the weight and the mode.
    pub(super) fn over_inclination(
        line: Line,
        weight: SelfWeight,
        tolerance: f64,
    ) -> Result<Self, Undecided> {
        let curve = Curve::Line(line);
        Self::along(curve, weight, curve.legs_over_inclination(weight), tolerance)
    }

    fn along(
        curve: Curve,
        weight: SelfWeight,
        parts: Vec<Leg>,
        tolerance: f64,
    ) -> Result<Self, Undecided> {
        let names = curve.ends();
        let values = EndValues::both(names, weight)?;
        let about = |what: &str| Undecided::new(format!("{curve}, {weight}: {what}"));
        let legs = follow(parts, &values, None, tolerance).map_err(about)?;
        let (Some(leg), Some(last_leg)) = (legs.first(), legs.last()) else {
            return Err(about("it has no equations"));
        };
        if !last_leg.1.reaches(&last_leg.0, |variable| values[1].value(variable), false) {
            return Err(about(NOT_REACHED));
        }
        let sides = [(names[0], &values[0], leg), (names[1], &values[1], last_leg)];
        let ends = sides.map(|(name, values, (form, _))| {
            let (s, root) = form.point(|variable| values.value(variable));
            let place = Place::new(form, &s, &root);
            let is_unlimited = place.friction.is_some() && name.is_unlimited();
            Place { is_unlimited: place.is_unlimited || is_unlimited, ..place }
        });
        let parameters = values.map(|values| values.value(leg.0.parameter));
        Ok(Self { curve, weight, ends, parameters, legs })
    }

    /// The parameters of the ends.
    pub fn parameters(&self) -> &[Ball; 2] {
        &self.parameters
    }

    /// The tube over a parameter, with its form.
    pub(super) fn tube_at(&self, s: &Ball) -> Option<(&CurveForm, &Tube)> {
        let piece = self.pieces().find(|piece| piece.is_over(s))?;
        Some((piece.form, piece.tube?))
    }

    /// The pieces in order, gaps among them.
    pub fn pieces(&self) -> impl Iterator<Item = Piece<'_>> {
        self.legs.iter().flat_map(|(form, walk)| pieces_of(form, walk))
    }

    /// The nodes in order, from end to end.
    pub fn points(&self) -> Vec<TracePoint> {
        let [first, last] = self.curve.ends();
        let mut points: Vec<TracePoint> = Vec::new();
        for (index, (form, walk)) in self.legs.iter().enumerate() {
            // The last node of a part is the first one of the next.
            points.extend(points_of(form, walk).into_iter().skip(usize::from(index > 0)));
        }
        let [at_first, at_last] = self.ends.clone();
        if let Some(point) = points.first_mut() {
            (point.end, point.place) = (Some(first), at_first);
        }
        if let Some(point) = points.last_mut() {
            (point.end, point.place) = (Some(last), at_last);
        }
        points
    }

    /// The pieces that are not proved.
    pub fn gaps(&self) -> impl Iterator<Item = Piece<'_>> {
        self.pieces().filter(|piece| piece.tube.is_none())
    }

    /// The largest half-width of a tube.
    pub fn width(&self) -> f64 {
        self.pieces().filter_map(|piece| piece.width()).fold(0.0, f64::max)
    }
}

/// Reason why a curve is not proved.
const NOT_REACHED: &str = "it is not proved to reach its end";

/// Follows the parts of a curve from its first end, which is proved to be on it, to the other one, or until a piece is
/// beyond a parameter.
fn follow(
    parts: Vec<Leg>,
    [start, end]: &[EndValues; 2],
    until: Option<f64>,
    tolerance: f64,
) -> Result<Vec<(CurveForm, Walk)>, &'static str> {
    let mut legs: Vec<(CurveForm, Walk)> = Vec::new();
    for Leg { form, from, to } in parts {
        let [first, last] = [start, end].map(|end| end.value(form.parameter));
        let is_rising = first.mid() <= last.mid();
        let (from, to) =
            (from.unwrap_or(outward(&first, is_rising)), to.unwrap_or(outward(&last, !is_rising)));
        let guess = |variable: &Variable| match legs.last() {
            Some((before, walk)) => last_value(before, walk, *variable),
            None => start.value(*variable).mid().to_f64(),
        };
        let guess = form.unknowns.iter().map(guess).collect();
        let stop = until.filter(|s| (to - s) / (to - from) > 0.0);
        let walk = walk(&form, from, guess, (to, stop.unwrap_or(to)), tolerance);
        legs.push((form, walk.ok_or("a node cannot be proved")?));
        if stop.is_some() {
            break;
        }
    }
    if !legs.windows(2).all(|pair| joins(&pair[0], &pair[1])) {
        return Err("its parts do not join");
    }
    match legs.first() {
        Some((form, walk)) if !walk.reaches(form, |variable| start.value(variable), true) => {
            Err(NOT_REACHED)
        }
        _ => Ok(legs),
    }
}

/// A tolerance at which the tubes tell one branch from another.
const COARSE: f64 = 1e-2;

/// The last leg of the way to a parameter between the ends of a curve, from the nearer of them: its last piece is over
/// the parameter.
pub(super) fn leg_to(
    curve: Curve,
    weight: SelfWeight,
    mut ends: [EndValues; 2],
    s: &Ball,
) -> Result<(CurveForm, Walk), Undecided> {
    let mut parts = curve.legs(weight);
    let [low, high] = ends.each_ref().map(|end| end.value(curve.parameter()));
    let from_last = high.mid().to_f64() - s.mid().to_f64() < s.mid().to_f64() - low.mid().to_f64();
    if from_last {
        parts = parts
            .into_iter()
            .rev()
            .map(|Leg { form, from, to }| Leg { form, from: to, to: from })
            .collect();
        ends.reverse();
    }
    let legs = follow(parts, &ends, Some(outward(s, from_last)), COARSE);
    let legs = legs.map_err(|what| Undecided::new(format!("{curve}, {weight}: {what}")))?;
    legs.into_iter().last().ok_or_else(|| Undecided::new("there are no equations"))
}

/// The double next to an end, outside of the curve.
fn outward(end: &Ball, is_low: bool) -> f64 {
    match is_low {
        // Rounding downward makes a zero negative.
        true => end.lower().to_f64_round(Round::Down) + 0.0,
        false => end.upper().to_f64_round(Round::Up),
    }
}

/// The pieces of a walk.
pub(super) fn pieces_of<'a>(
    form: &'a CurveForm,
    walk: &'a Walk,
) -> impl Iterator<Item = Piece<'a>> {
    let nodes = walk.nodes.windows(2).zip(&walk.tubes);
    nodes.map(move |(pair, tube)| Piece { form, from: &pair[0], to: &pair[1], tube: tube.as_ref() })
}

/// The nodes of a walk.
pub(super) fn points_of(form: &CurveForm, walk: &Walk) -> Vec<TracePoint> {
    let point = |node: &Node| TracePoint {
        parameter: node.sketch.s,
        end: None,
        place: Place::new(form, &exact(node.sketch.s), &node.root),
    };
    walk.nodes.iter().map(point).collect()
}

/// The value of a variable at the last node of a part.
fn last_value(form: &CurveForm, walk: &Walk, variable: Variable) -> f64 {
    let node = walk.nodes.last();
    let value = node.and_then(|node| form.value(variable, &node.sketch.s, &node.sketch.x).copied());
    value.unwrap_or(f64::NAN)
}

/// Tells whether the root at the last node of a part, which solves the equations of the next one too, lies in
/// its first tube.
fn joins((before, walk): &(CurveForm, Walk), (after, next): &(CurveForm, Walk)) -> bool {
    let (Some(node), Some(Some(tube))) = (walk.nodes.last(), next.tubes.first()) else {
        return false;
    };
    let s = exact(node.sketch.s);
    let root: Option<Vec<Ball>> =
        after.unknowns.iter().map(|u| before.value(*u, &s, &node.root).cloned()).collect();
    root.is_some_and(|root| tube.holds(&s, &root))
}

impl<'a> Piece<'a> {
    /// The parameters between which it runs.
    pub fn range(&self) -> [f64; 2] {
        [self.from.sketch.s, self.to.sketch.s]
    }

    /// Tells whether it runs over all of a set of parameters.
    pub(super) fn is_over(&self, s: &Ball) -> bool {
        let [from, to] = self.range();
        s.lower() >= from.min(to) && s.upper() <= from.max(to)
    }

    /// Tells whether the piece is proved.
    pub fn is_proved(&self) -> bool {
        self.tube.is_some()
    }

    /// The values and the slopes at its two ends of the cubic of a coordinate; `None` for one that the curve leaves
    /// open or that is constant.
    pub fn cubic(&self, variable: Variable) -> Option<[[f64; 2]; 2]> {
        let index = self.form.unknowns.iter().position(|unknown| *unknown == variable);
        let ends = [&self.from.sketch, &self.to.sketch];
        match index {
            Some(i) => Some([ends.map(|node| node.x[i]), ends.map(|node| node.slopes[i])]),
            None => (self.form.parameter == variable).then(|| [ends.map(|node| node.s), [1.0; 2]]),
        }
    }

    /// The largest half-width of the tube in `alpha`, `phi` and `eta`, rounded up; `None` for a gap.
    pub fn width(&self) -> Option<f64> {
        self.tube.map(|tube| width(self.form, tube))
    }

    /// The slope of a variable to the parameter, over the whole piece.
    pub fn slope(&self, variable: Variable) -> Option<Ball> {
        let tube = self.tube?;
        self.form.value(variable, &exact(1.0), &tube.slopes).cloned()
    }

    /// The slope of one variable to another, `dy/dx`, over the whole piece; `None` if a curve leaves one of them
    /// open or `x` may stand still.
    pub fn slope_of(&self, y: Variable, x: Variable) -> Option<Ball> {
        let slope = self.slope(y)? / self.slope(x)?;
        slope.is_bounded().then_some(slope)
    }

    /// Nodes of the piece.
    pub(super) fn nodes(&self) -> [&'a Node; 2] {
        [self.from, self.to]
    }

    /// The quantities at a parameter of the piece.
    pub fn place(&self, parameter: f64) -> Option<Place> {
        let [low, high] = self.range();
        let tube = self.tube.filter(|_| (low..=high).contains(&parameter))?;
        let s = exact(parameter);
        Some(Place::new(self.form, &s, &tube.enclosure(&s)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_curve_is_proved_from_end_to_end() {
        for (curve, weight) in Curve::ALL.iter().flat_map(|c| SelfWeight::ALL.map(|w| (*c, w))) {
            let trace = Trace::new(curve, weight, 1e-3).unwrap();
            assert_eq!(trace.gaps().count(), 0, "{curve} {weight:?}");
            assert!(trace.width() <= 1e-3, "{curve} {weight:?}");
            let points = trace.points();
            assert_eq!(points.len(), trace.pieces().count() + 1);
            let [first, last] = curve.ends();
            assert_eq!(points[0].end, Some(first));
            assert_eq!(points[points.len() - 1].end, Some(last));
            // Each node is where the pieces on both its sides have it.
            let inner = points[1..].iter().filter(|point| point.end.is_none());
            for (point, piece) in inner.zip(trace.pieces()) {
                let there = piece.place(point.parameter).unwrap();
                for variable in Variable::PLANE {
                    let (node, tube) =
                        (point.place.coordinate(variable), there.coordinate(variable));
                    assert_eq!(node.is_some(), tube.is_some(), "{curve} {variable:?}");
                    let pair = node.zip(tube);
                    assert!(pair.is_none_or(|(node, tube)| node.overlaps(tube)), "{curve}");
                }
            }
        }
    }

    /// Lines that meet in a landmark have it in common.
    #[test]
    fn an_end_is_the_landmark_itself() {
        let weight = SelfWeight::Milankovitch;
        let [one, other] = [Line::RotationShoulder, Line::RotationInner]
            .map(|line| Trace::new(Curve::Line(line), weight, 1e-3).unwrap().points());
        let (one, other) = (&one[one.len() - 1], &other[0]);
        assert_eq!(one.end, other.end);
        let eta = |point: &TracePoint| point.place.thickness.clone().unwrap();
        assert!(eta(one).overlaps(&eta(other)) && eta(one).rad().to_float() < 1e-30);
    }

    #[test]
    fn what_a_curve_leaves_open_has_no_coordinate() {
        let places = |curve| Trace::new(curve, SelfWeight::Heyman, 1e-2).unwrap().points();
        assert!(places(Curve::Rotation).iter().all(|p| p.place.friction_angle.is_none()));
        assert!(places(Curve::Sliding).iter().all(|p| p.place.thickness.is_none()));
        assert!(places(Curve::Limit).iter().all(|p| p.place.thickness.is_some()));
    }

    #[test]
    fn the_slope_of_a_line_is_that_of_its_tangent() {
        // d eta/d phi at T on [r,r,r]/[s,r,r], for Heyman's weight about 1.8495.
        let line = Curve::Line(Line::RotationShoulder);
        let trace = Trace::new(line, SelfWeight::Heyman, 1e-6).unwrap();
        let last = trace.pieces().last().unwrap();
        let slope = last.slope_of(Variable::Thickness, Variable::FrictionAngle).unwrap();
        assert!(slope.overlaps(&exact(1.849504241)), "{slope:?}");
        assert!(slope.is_positive().is_proved() && !slope.overlaps(&exact(3.0)), "{slope:?}");
    }

    /// By the inclination a line is the same one, from its first end, where the arch is flat, to the last.
    #[test]
    fn over_the_inclination_a_line_is_the_same() {
        for weight in SelfWeight::ALL {
            for line in [Line::RotationShoulder, Line::CrownEnd] {
                let trace = Trace::over_inclination(line, weight, 1e-9).unwrap();
                assert_eq!(trace.gaps().count(), 0, "{line} {weight:?}");
                let usual = Trace::new(Curve::Line(line), weight, 1e-9).unwrap();
                let parameter = usual.curve.parameter();
                for piece in trace.pieces().step_by(5) {
                    let [from, to] = piece.range();
                    let place = piece.place((from + to) / 2.0).unwrap();
                    let at = place.coordinate(parameter).unwrap().mid().to_f64();
                    let same = usual.pieces().find_map(|piece| piece.place(at)).unwrap();
                    for variable in Variable::PLANE {
                        let [one, other] = [&place, &same]
                            .map(|place| place.coordinate(variable).unwrap().mid().to_f64());
                        approx::assert_abs_diff_eq!(one, other, epsilon = 1e-6 * (1.0 + at));
                    }
                }
            }
        }
    }
}
