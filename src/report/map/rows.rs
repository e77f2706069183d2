//! A row for each node of a curve, in the columns that every format of data has.

use super::Map;
use crate::atlas::{Curve, Piece, Place, Point, Trace, Variable};
use crate::number::{Ball, Enclosure};
use crate::report::csv;
use rug::Float;
use rug::float::Round;
use std::io;

/// A node with the piece that begins there; behind the last node there is none.
pub(super) struct Row<'a> {
    pub index: usize,
    trace: &'a Trace,
    point: Point,
    piece: Option<Piece<'a>>,
    /// The piece whose cubic ends here, for the last node.
    before: Option<Piece<'a>>,
}

/// How the cells of a column are found; each may be missing.
pub(super) enum Column {
    Text(fn(&Row) -> Option<String>),
    Double(fn(&Row) -> Option<f64>),
    Integer(fn(&Row) -> Option<u64>),
    Truth(fn(&Row) -> Option<bool>),
}

use Column::{Double, Integer, Text, Truth};

/// The columns. Bounds are rounded outward, as decimals and as doubles. Between two nodes the curve is as near as `tube`, in half
/// opening, friction angle and thickness, to the cubic in the parameter that goes through `…_node` with the
/// slopes `…_rate`.
pub(super) const COLUMNS: [(&str, Column); 29] = [
    ("weight", Text(|row| Some(row.weight()?.to_owned()))),
    ("curve", Text(|row| Some(row.trace.curve.to_string()))),
    ("node", Integer(|row| Some(row.index as u64))),
    ("end", Text(|row| Some(row.point.end?.to_string()))),
    ("parameter", Double(|row| Some(row.point.parameter))),
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

/// Whose weight a curve belongs to; sliding is the same for both.
pub(super) fn weight_of(trace: &Trace) -> Option<&'static str> {
    (trace.curve != Curve::Sliding).then(|| trace.weight.name())
}

impl<'a> Row<'a> {
    /// The rows of a curve.
    pub(super) fn all(trace: &'a Trace) -> Vec<Self> {
        let pieces: Vec<Piece> = trace.pieces().collect();
        let row = |(index, point): (usize, Point)| {
            let piece = pieces.get(index).copied();
            let before = index.checked_sub(1).and_then(|i| pieces.get(i)).copied();
            Self { index, trace, point, piece, before }
        };
        trace.points().into_iter().enumerate().map(row).collect()
    }

    fn weight(&self) -> Option<&'static str> {
        weight_of(self.trace)
    }

    fn place(&self) -> &Place {
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

pub(super) fn lower(ball: Option<&Ball>) -> Option<f64> {
    let ball = ball.filter(|ball| ball.is_bounded())?;
    Some(outward(&ball.lower(), Round::Down))
}

pub(super) fn upper(ball: Option<&Ball>) -> Option<f64> {
    let ball = ball.filter(|ball| ball.is_bounded())?;
    Some(outward(&ball.upper(), Round::Up))
}

/// A row for each node, with a header.
pub(in crate::report) fn csv(report: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    let header = COLUMNS.iter().map(|(name, _)| (*name).to_owned()).collect();
    let rows = report.traces.iter().flat_map(Row::all).map(|row| {
        let cell = |(_, column): &(&str, Column)| {
            let text = match column {
                Text(cell) => cell(&row),
                Double(cell) => cell(&row).map(|x| format!("{x:?}")),
                Integer(cell) => cell(&row).map(|x| x.to_string()),
                Truth(cell) => cell(&row).map(|x| x.to_string()),
            };
            text.unwrap_or_default()
        };
        COLUMNS.iter().map(cell).collect()
    });
    csv::write(std::iter::once(header).chain(rows), out)
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
