//! A quantity along a piece as a cubic, with a bound of what it is off.
//!
//! Along a piece the unknowns lie in a tube about cubics `X(s)` of the parameter. What follows from them, `q(X(s))`, is
//! not a cubic; Hermite's cubic through its ends is off by no more than the fourth Taylor coefficient over the part,
//! from [jets](crate::number::Jet), times the fourth power of its half-length, and the tube adds the slopes of `q`
//! over it times its half-widths.

use super::cubic::{BITS, exact};
use super::form::CurveForm;
use super::place::root_of_square;
use super::spot::VariableValues;
use super::trace::Piece;
use super::tube::Tube;
use super::variable::Variable;
use crate::arch::haunch::opening_variable_at_half;
use crate::number::{Ball, Dual, Enclosure, Field, Jet, Real, Stumpff};
use crate::prover::arithmetic::Arithmetic;

/// A quantity that is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Coordinate {
    /// `alpha`, rad.
    HalfOpening,
    /// `A = alpha cot(alpha/2)`.
    OpeningVariable,
    /// `phi`, rad.
    FrictionAngle,
    /// `mu = tan phi`.
    Friction,
    /// `eta`.
    Thickness,
    /// The decimal logarithm of `eta`.
    LogThickness,
    /// `h`.
    Thrust,
    /// `beta_r`, rad.
    RotationJoint,
}

/// A quantity between two parameters: a cubic by its values and slopes to the parameter at both ends.
#[derive(Clone, Copy, Debug)]
pub struct CubicArc {
    /// Values at the ends.
    pub values: [f64; 2],
    /// Slopes to the parameter.
    pub slopes: [f64; 2],
    /// Largest distance of the quantity from the cubic, for each parameter.
    pub off: f64,
    /// Part of that distance that a shorter part of the curve would reduce.
    pub by_length: f64,
}

/// More than the rounding of the doubles can be, for values of a few units.
const ROUNDING: f64 = 1e-14;
/// More than `1/ln 10`.
const ABOVE: f64 = 0.435;

impl Coordinate {
    /// The variable that it is or follows from; `None` of several.
    pub fn variable(self) -> Option<Variable> {
        match self {
            Self::HalfOpening | Self::OpeningVariable => Some(Variable::HalfOpening),
            Self::FrictionAngle | Self::Friction => Some(Variable::FrictionAngle),
            Self::Thickness | Self::LogThickness => Some(Variable::Thickness),
            Self::Thrust | Self::RotationJoint => None,
        }
    }

    /// Tells whether the coordinate is a variable itself, whose cubics the curves have.
    pub fn is_variable(self) -> bool {
        matches!(self, Self::HalfOpening | Self::FrictionAngle | Self::Thickness)
    }

    /// Value of the coordinate, or, of a logarithm, what it is of.
    fn of<T: Real + Stumpff>(self, form: &CurveForm, at: &VariableValues<T>) -> T {
        match self {
            Self::HalfOpening => at.half_opening.clone(),
            Self::OpeningVariable => {
                let quarter = at.half_opening.square() / at.thrust.int(4);
                opening_variable_at_half(&quarter.stumpff(2)).value()
            }
            Self::FrictionAngle => at.friction_angle.clone(),
            Self::Friction => {
                let (sin, cos) = at.friction_angle.sin_cos();
                sin / cos
            }
            Self::Thickness | Self::LogThickness => at.thickness.clone(),
            Self::Thrust => at.thrust.clone(),
            // Where its ratio is known it is regular at the origin too.
            Self::RotationJoint if form.knows(Variable::JointRatio) => {
                at.joint_ratio.sqrt() * &at.inclination.rad
            }
            Self::RotationJoint => at.joint_square.sqrt(),
        }
    }

    /// A value that the quantity is made of, as it is drawn.
    pub fn drawn(self, value: f64) -> f64 {
        match self {
            Self::LogThickness => value.log10(),
            Self::Friction => value.tan(),
            Self::OpeningVariable if value == 0.0 => 2.0,
            Self::OpeningVariable => value / (value / 2.0).tan(),
            _ => value,
        }
    }
}

impl CubicArc {
    /// Cubic of a quantity by its coefficients about the ends, and on all of the part for the fourth derivative; what
    /// is beside them, on all of it, is told by `beside`.
    pub(super) fn of(
        [from, to]: [f64; 2],
        jet: impl Fn(&Ball, usize) -> Option<Vec<Ball>>,
        beside: impl FnOnce(&Ball) -> Option<f64>,
    ) -> Option<Self> {
        let ends = [jet(&exact(from), 1)?, jet(&exact(to), 1)?];
        let [values, slopes] = [0, 1].map(|k| ends.each_ref().map(|end| end[k].mid().to_f64()));
        let whole = exact(from).hull(&exact(to));
        let fourth = jet(&whole, 4)?.swap_remove(4);
        let half = (to - from) / 2.0;
        let by_length = fourth.bound() * half.powi(4) * (1.0 + ROUNDING) + ROUNDING;
        let off = by_length + beside(&whole)?;
        off.is_finite().then_some(Self { values, slopes, off, by_length })
    }
}

/// A quantity on a part of a piece; `None` in a gap, or where nothing bounds it.
pub fn arc(piece: &Piece, coordinate: Coordinate, [from, to]: [f64; 2]) -> Option<CubicArc> {
    let (form, tube) = (piece.form, piece.tube?);
    let jet = |s: &Ball, order: usize| -> Option<Vec<Ball>> {
        let number = |given: &Ball| Jet::constant(given.with_precision(BITS), order);
        let line = Jet::new(vec![s.clone(), exact(1.0)], order);
        let cubics = tube.about(s).into_iter().map(|about| Jet::new(about, order));
        let of = coordinate.of(form, &form.spot(&number, &line, &cubics.collect::<Vec<_>>()));
        let of: Vec<Ball> = (0..=order).map(|k| of.coefficient(k)).collect();
        let of = if coordinate == Coordinate::LogThickness { logarithm(of)? } else { of };
        of.iter().all(Enclosure::is_bounded).then_some(of)
    };
    let by_cubic = CubicArc::of([from, to], jet, |s| by_tube(form, coordinate, s, tube));
    let by_chord = || {
        let on = |s: &Ball| -> Option<Ball> {
            let at = form.spot(&Ball::clone, s, &tube.enclosure(s));
            let value = match coordinate {
                Coordinate::LogThickness => return None,
                Coordinate::RotationJoint => root_of_square(&at.joint_square),
                _ => coordinate.of(form, &at),
            };
            value.is_bounded().then_some(value)
        };
        let ends = [on(&exact(from))?, on(&exact(to))?];
        // Of a root the one of the middle, which is in it too.
        let root = |s: f64| {
            let s = exact(s);
            let square = form.spot(&Ball::clone, &s, &tube.enclosure(&s)).joint_square;
            square.mid().to_f64().max(0.0).sqrt()
        };
        let values = match coordinate {
            Coordinate::RotationJoint => [root(from), root(to)],
            _ => ends.each_ref().map(|end| end.mid().to_f64()),
        };
        let slope = (values[1] - values[0]) / (to - from);
        // Both ends of the chord, and so all of it, are in what holds the quantity.
        let width = |x: &Ball| 2.0 * x.rad().to_float().to_f64();
        let off = width(&on(&exact(from).hull(&exact(to)))?) + ROUNDING;
        let by_length = (off - width(&ends[0]).max(width(&ends[1]))).max(0.0);
        Some(CubicArc { values, slopes: [slope; 2], off, by_length })
    };
    // What has no slope at an end, as a square root, has a chord.
    match (by_cubic, by_chord()) {
        (Some(cubic), Some(chord)) if chord.off < cubic.off => Some(chord),
        (cubic, chord) => cubic.or(chord),
    }
}

/// Distance that the tube adds.
fn by_tube(form: &CurveForm, coordinate: Coordinate, s: &Ball, tube: &Tube) -> Option<f64> {
    let number = |given: &Ball| Dual::constant(given.with_precision(BITS));
    let x = Dual::variables(&tube.enclosure(s));
    let of = coordinate.of(form, &form.spot(&number, &Dual::constant(s.clone()), &x));
    let widths = tube.widths.iter().map(|width| width.to_float().to_f64());
    let off: f64 = widths.enumerate().map(|(k, width)| of.derivative(k).bound() * width).sum();
    if coordinate != Coordinate::LogThickness {
        return Some(off * (1.0 + ROUNDING));
    }
    let least = of.value().lower().to_f64();
    (least > 0.0).then(|| ABOVE * off / least * (1.0 + ROUNDING))
}

/// The coefficients of a decimal logarithm, by `(ln u)' = u'/u`.
fn logarithm(of: Vec<Ball>) -> Option<Vec<Ball>> {
    let value = of[0].mid().to_f64();
    if !of[0].is_positive().is_proved() {
        return None;
    }
    let order = of.len() - 1;
    let slope = (1..=order).map(|k| of[0].int(k as i32) * &of[k]).collect();
    let ratio = Jet::new(slope, order - 1) / &Jet::new(of, order - 1);
    let factor = exact(std::f64::consts::LOG10_E);
    let rest =
        (1..=order).map(|k| ratio.coefficient(k - 1) * &factor / ratio.value().int(k as i32));
    Some([exact(value.log10())].into_iter().chain(rest).collect())
}

#[cfg(test)]
mod tests {
    use super::super::curve::Curve;
    use super::super::trace::Trace;
    use super::*;
    use crate::arch::SelfWeight;

    /// At each parameter the quantity, as the tube has it, is no further from the cubic than is said, and not
    /// always much nearer.
    #[test]
    fn cubics_are_as_near_as_is_said() {
        use Coordinate as C;
        for (curve, coordinate) in [
            (Curve::Rotation, C::RotationJoint),
            (Curve::Rotation, C::Thrust),
            (Curve::Rotation, C::OpeningVariable),
            (Curve::Rotation, C::LogThickness),
            (Curve::Overturning, C::OpeningVariable),
            (Curve::Sliding, C::Thrust),
            (Curve::named("rrr/srr").unwrap(), C::Friction),
            (Curve::named("rrr/srr").unwrap(), C::Thickness),
        ] {
            let trace = Trace::new(curve, SelfWeight::Heyman, 1e-4).unwrap();
            let mut widest: f64 = 0.0;
            for piece in trace.pieces().skip(2).step_by(3) {
                let [from, end] = piece.range();
                let to = from + (end - from) / 16.0;
                let drawn = arc(&piece, coordinate, [from, to]).unwrap();
                assert!(drawn.off < 2e-2, "{curve} {coordinate:?} {drawn:?}");
                for share in [0.0, 0.3, 0.5, 1.0] {
                    let place = piece.place(from + share * (to - from)).unwrap();
                    let middle = |x: Option<&Ball>| x.unwrap().mid().to_f64();
                    let truth = match coordinate {
                        C::Thrust => middle(place.thrust.as_ref()),
                        C::RotationJoint => middle(place.rotation_joint.as_ref()),
                        _ => coordinate
                            .drawn(middle(place.coordinate(coordinate.variable().unwrap()))),
                    };
                    let away = (hermite(&drawn, to - from, share) - truth).abs();
                    assert!(away <= drawn.off, "{curve} {coordinate:?}: {away} {drawn:?}");
                    widest = widest.max(away);
                }
            }
            assert!(widest < 1e-2);
        }
    }

    fn hermite(arc: &CubicArc, length: f64, t: f64) -> f64 {
        let [a, b] = arc.values;
        let [c, d] = arc.slopes.map(|slope| slope * length);
        let (u, v) = (1.0 - t, t);
        u * u * (1.0 + 2.0 * v) * a + u * u * v * c + v * v * (1.0 + 2.0 * u) * b - v * v * u * d
    }

    /// A root has no slope where it vanishes.
    #[test]
    fn what_has_no_slope_is_bounded_by_what_holds_it() {
        let trace = Trace::new(Curve::Rotation, SelfWeight::Heyman, 1e-4).unwrap();
        let first = trace.pieces().next().unwrap();
        let drawn = arc(&first, Coordinate::RotationJoint, [0.0, 1e-3]).unwrap();
        assert!(drawn.off < 0.05 && drawn.slopes[0] == drawn.slopes[1], "{drawn:?}");
        assert!(arc(&first, Coordinate::LogThickness, [0.0, 1e-3]).is_none(), "no end");
    }
}
