//! A row for each node of a curve, in the columns that every format of data has.

use super::Map;
use crate::arch::SelfWeight;
use crate::atlas::{
    Border, Branch, Contour, Curve, Level, Part, Piece, Place, Stretch, Trace, TracePoint, Variable,
};
use crate::number::{Ball, Enclosure};
use crate::report::Column::{Double, Integer, Shown, Text, Truth};
use crate::report::NamedColumn;
use rug::Float;
use rug::float::Round;

/// A node with the piece that begins there; behind the last node there is none.
pub(crate) struct MapRow<'a> {
    index: usize,
    weight: Option<&'static str>,
    curve: String,
    mode: Option<String>,
    point: TracePoint,
    piece: Option<Piece<'a>>,
    /// The piece whose cubic ends here, for the last node.
    before: Option<Piece<'a>>,
    /// True if the states are admissible on the part of an asymmetric branch.
    is_admissible: Option<bool>,
}

/// Whose weight a curve belongs to; sliding is the same for both.
pub(super) fn weight_of(curve: Curve, weight: SelfWeight) -> Option<&'static str> {
    (!curve.is_weightless()).then(|| weight.name())
}

impl<'a> MapRow<'a> {
    /// The columns. Bounds are rounded outward, as decimals and as doubles. Between two nodes the curve is as near
    /// as `tube`, in half opening, friction angle and thickness, to the cubic in the parameter that goes through
    /// `…_node` with the slopes `…_rate`.
    pub(crate) const COLUMNS: [NamedColumn<Self>; 30] = [
        ("weight", Text(|row| row.weight)),
        ("curve", Text(|row| Some(&row.curve))),
        ("mode", Text(|row| row.mode.as_deref())),
        ("node", Integer(|row| Some(row.index as u64))),
        ("end", Shown(|row| row.point.end.as_ref().map(|end| end as _))),
        ("parameter", Double(|row| Some(row.point.parameter).filter(|s| s.is_finite()))),
        ("half_opening_lower", Double(|row| lower(row.place().half_opening.as_ref()))),
        ("half_opening_upper", Double(|row| upper(row.place().half_opening.as_ref()))),
        ("friction_angle_lower", Double(|row| lower(row.place().friction_angle.as_ref()))),
        ("friction_angle_upper", Double(|row| upper(row.place().friction_angle.as_ref()))),
        ("friction_lower", Double(|row| row.friction(lower))),
        ("friction_upper", Double(|row| row.friction(upper))),
        ("thickness_lower", Double(|row| lower(row.place().thickness.as_ref()))),
        ("thickness_upper", Double(|row| upper(row.place().thickness.as_ref()))),
        ("thrust_lower", Double(|row| lower(row.place().thrust.as_ref()))),
        ("thrust_upper", Double(|row| upper(row.place().thrust.as_ref()))),
        ("rotation_joint_lower", Double(|row| lower(row.place().rotation_joint.as_ref()))),
        ("rotation_joint_upper", Double(|row| upper(row.place().rotation_joint.as_ref()))),
        ("sliding_joint_lower", Double(|row| lower(row.place().sliding_joint.as_ref()))),
        ("sliding_joint_upper", Double(|row| upper(row.place().sliding_joint.as_ref()))),
        ("half_opening_node", Double(|row| row.cubic(Variable::HalfOpening, 0))),
        ("half_opening_rate", Double(|row| row.cubic(Variable::HalfOpening, 1))),
        ("friction_angle_node", Double(|row| row.cubic(Variable::FrictionAngle, 0))),
        ("friction_angle_rate", Double(|row| row.cubic(Variable::FrictionAngle, 1))),
        ("thickness_node", Double(|row| row.cubic(Variable::Thickness, 0))),
        ("thickness_rate", Double(|row| row.cubic(Variable::Thickness, 1))),
        ("slope_lower", Double(|row| lower(row.slope().as_ref()))),
        ("slope_upper", Double(|row| upper(row.slope().as_ref()))),
        ("tube", Double(|row| row.piece.as_ref()?.width())),
        ("proved", Truth(|row| Some(row.piece.as_ref()?.is_proved()))),
    ];

    /// Columns that a row of a branch has beside the columns of a map.
    pub(crate) const OF_BRANCHES: [NamedColumn<Self>; 5] = [
        ("vertical_force_lower", Double(|row| lower(row.place().vertical_force.as_ref()))),
        ("vertical_force_upper", Double(|row| upper(row.place().vertical_force.as_ref()))),
        ("crown_hinge_lower", Double(|row| lower(row.place().crown_hinge.as_ref()))),
        ("crown_hinge_upper", Double(|row| upper(row.place().crown_hinge.as_ref()))),
        ("admissible", Truth(|row| row.is_admissible)),
    ];

    /// The rows of a curve.
    pub(super) fn of_trace(trace: &'a Trace) -> Vec<Self> {
        let named = (weight_of(trace.curve, trace.weight), trace.curve.to_string(), None);
        Self::all(&named, trace.points(), trace.pieces())
    }

    /// The rows of a part of a level, whose name it has.
    pub(crate) fn of_part(level: &Level, part: &'a Part) -> Vec<Self> {
        let named =
            (Some(level.weight.name()), level.contour.to_string(), Some(part.mode.to_string()));
        Self::all(&named, part.points(), part.pieces())
    }

    /// The rows of a part of an asymmetric branch, by the vertical force.
    pub(crate) fn of_stretch(branch: &Branch, stretch: &'a Stretch) -> Vec<Self> {
        let curve = Contour::HalfOpening(branch.half_opening.clone()).to_string();
        let named = (Some(branch.weight.name()), curve, Some(stretch.kind.name().to_owned()));
        let is_admissible = Some(stretch.is_admissible().is_ok());
        let rows = Self::all(&named, stretch.section.points(), stretch.section.pieces());
        rows.into_iter().map(|row| Self { is_admissible, ..row }).collect()
    }

    /// The rows of a line between asymmetric branches.
    pub(super) fn of_border(border: &'a Border) -> Vec<Self> {
        let named = (Some(border.weight.name()), border.line.name(), None);
        Self::all(&named, border.section.points(), border.section.pieces())
    }

    fn all(
        (weight, curve, mode): &(Option<&'static str>, String, Option<String>),
        points: Vec<TracePoint>,
        pieces: impl Iterator<Item = Piece<'a>>,
    ) -> Vec<Self> {
        let pieces: Vec<Piece> = pieces.collect();
        let row = |(index, point): (usize, TracePoint)| Self {
            index,
            weight: *weight,
            curve: curve.clone(),
            mode: mode.clone(),
            point,
            piece: pieces.get(index).copied(),
            is_admissible: None,
            before: index.checked_sub(1).and_then(|i| pieces.get(i)).copied(),
        };
        points.into_iter().enumerate().map(row).collect()
    }

    /// The rows of all that a report has.
    pub(crate) fn of_map(report: &'a Map) -> Vec<Self> {
        let levels = report
            .levels
            .iter()
            .flat_map(|level| level.parts.iter().flat_map(move |part| Self::of_part(level, part)));
        let borders = report.borders.iter().flat_map(Self::of_border);
        report.traces.iter().flat_map(Self::of_trace).chain(levels).chain(borders).collect()
    }

    pub(crate) fn place(&self) -> &Place {
        &self.point.place
    }

    /// A bound of the friction, infinite where it is unlimited.
    fn friction(&self, bound: fn(Option<&Ball>) -> Option<f64>) -> Option<f64> {
        match self.place().is_unlimited {
            true => Some(f64::INFINITY),
            false => bound(self.place().friction.as_ref()),
        }
    }

    /// The value (0) or the slope (1) of the cubic here.
    fn cubic(&self, variable: Variable, which: usize) -> Option<f64> {
        match (&self.piece, &self.before) {
            // Adding zero makes a negative zero positive.
            (Some(piece), _) => Some(piece.cubic(variable)?[which][0] + 0.0),
            (None, before) => Some(before.as_ref()?.cubic(variable)?[which][1] + 0.0),
        }
    }

    /// `d eta/d phi` on the piece that begins here.
    fn slope(&self) -> Option<Ball> {
        self.piece.as_ref()?.slope_of(Variable::Thickness, Variable::FrictionAngle)
    }
}

/// A double below or above a number, so that its shortest decimal is too.
fn outward(x: &Float, round: Round) -> f64 {
    let double = x.to_f64_round(round) + 0.0;
    // Numbers of few bits are written exactly; of others the decimal may be half a unit off.
    let is_short = *x == double && (double * 1024.0).fract() == 0.0 && double.abs() < 1024.0;
    match (is_short, round) {
        (true, _) => double,
        (false, Round::Down) => double.next_down(),
        _ => double.next_up(),
    }
}

pub(crate) fn lower(ball: Option<&Ball>) -> Option<f64> {
    let ball = ball.filter(|ball| ball.is_bounded())?;
    Some(outward(&ball.lower(), Round::Down))
}

pub(crate) fn upper(ball: Option<&Ball>) -> Option<f64> {
    let ball = ball.filter(|ball| ball.is_bounded())?;
    Some(outward(&ball.upper(), Round::Up))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    #[test]
    fn decimals_of_bounds_are_outward() {
        let decimal = |text: &str| {
            let (whole, digits) = text.split_once('.').unwrap();
            let power = Rational::from(10).recip();
            let scale = (0..digits.len()).fold(Rational::from(1), |scale, _| scale * &power);
            Rational::from(format!("{whole}{digits}").parse::<i128>().unwrap()) * scale
        };
        for n in 1..200 {
            let x = Rational::from((n, 371));
            let ball = Ball::enclosing(&x, 64);
            let [low, high] = [lower(Some(&ball)), upper(Some(&ball))].map(Option::unwrap);
            assert!(decimal(&format!("{low:?}")) <= x && x <= decimal(&format!("{high:?}")), "{n}");
            assert!(high - low < 1e-15);
        }
        let two = Ball::integer(2, 64);
        assert_eq!([lower(Some(&two)), upper(Some(&two))], [Some(2.0); 2], "exact as it is");
        assert_eq!(lower(Some(&Ball::whole(64))), None);
    }
}
