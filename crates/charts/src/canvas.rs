//! A plane with its axes, in the units and ranges asked for.

use super::plane::{DEGREES, Plane, PlaneAxis, step};
use crate::atlas::{Coordinate, LEAST_TOLERANCE, Place};
use crate::number::shown;
use crate::picture::Point;
use crate::report::Format;

/// Ranges of the axes: how a quantity is shown along an axis, and from where to where. What is not asked for
/// is as usual.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Axes {
    /// The half opening in degrees, in radians, or as `A`.
    pub half_opening: Shown,
    /// The friction angle in degrees, in radians, or its tangent.
    pub friction: Shown,
    /// The thickness or its logarithm.
    pub thickness: Shown,
}

/// A unit, and a range in that unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shown {
    /// The unit.
    pub unit: Unit,
    /// Range in the unit; of a logarithm the thicknesses.
    pub range: Option<[f64; 2]>,
}

/// A unit of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Degrees, and of the thickness itself.
    #[default]
    Usual,
    /// Radians.
    Radians,
    /// A derived quantity: `A = alpha cot(alpha/2)`, `mu = tan phi`, the logarithm of the thickness.
    Derived,
}

/// The least thickness of a logarithmic axis, and the one from which on it is usual.
const THINNEST: f64 = 1e-9;
const THIN: f64 = 1e-4;

impl Unit {
    /// The unit of a name: `deg`, `rad`, `A`, `mu`, `linear`, `log`.
    pub fn named(name: &str) -> Self {
        match name.to_ascii_lowercase().as_str() {
            "rad" => Self::Radians,
            "mu" | "a" | "log" => Self::Derived,
            _ => Self::Usual,
        }
    }
}

impl Axes {
    /// The axes on which what asymmetric branches reach is seen, if no others are given: in a picture between the half
    /// openings where they begin and end.
    pub fn of_asymmetric(self, format: &Format) -> Self {
        if self != Self::default() || !format.is_picture {
            return self;
        }
        let shown = |from, to| Shown { range: Some([from, to]), ..Shown::default() };
        Self { half_opening: shown(120.0, 145.0), friction: shown(38.0, 56.0), ..Self::default() }
    }

    /// Reason why these are no axes of a map in a plane.
    pub fn misfit(&self, plane: Plane) -> Option<String> {
        let name = plane.name();
        for (quantity, asked) in [
            ("opening", self.half_opening),
            ("friction", self.friction),
            ("thickness", self.thickness),
        ] {
            if asked != Shown::default() && !name.contains(quantity) {
                return Some(format!("the plane {name} has no axis of {quantity}"));
            }
        }
        let is_too_thin = self.thinnest().is_some_and(|thinnest| thinnest < THINNEST);
        let message = format!(
            "on a logarithmic scale a range of thicknesses begins at {THINNEST:e} or above"
        );
        is_too_thin.then_some(message)
    }

    /// The half-width of tubes that is asked for: on a logarithmic axis in parts of the least thickness shown.
    pub fn tolerance(&self, asked: f64) -> f64 {
        match self.thinnest() {
            Some(thinnest) => (asked * thinnest.min(1.0)).max(LEAST_TOLERANCE),
            None => asked,
        }
    }

    /// The least thickness that a logarithmic axis shows.
    fn thinnest(&self) -> Option<f64> {
        let is_logarithm = self.thickness.unit == Unit::Derived;
        is_logarithm.then(|| self.thickness.range.map_or(THIN, |[from, _]| from))
    }
}

/// A plane to draw in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Canvas {
    pub plane: Plane,
    /// Axes to the right, and up.
    pub axes: [PlaneAxis; 2],
    /// True if the axes are as usual, so that insets and words have their places.
    pub is_usual: bool,
}

impl Canvas {
    /// Place of a point, in the units shown.
    pub(super) fn place(&self, place: &Place) -> Option<Point> {
        let [x, y] = &self.axes;
        Some((x.place(place)?, y.place(place)?))
    }

    pub(super) fn usual(plane: Plane) -> Self {
        Self { plane, axes: plane.axes(), is_usual: true }
    }

    pub(super) fn new(plane: Plane, axes: &Axes) -> Self {
        let with = |axis: PlaneAxis| match axis.coordinate {
            Coordinate::HalfOpening => axes.half_opening.of(axis),
            Coordinate::FrictionAngle => axes.friction.of(axis),
            _ => axes.thickness.of(axis),
        };
        let asked = plane.axes().map(with);
        Self { plane, axes: asked, is_usual: asked == plane.axes() }
    }
}

impl Shown {
    /// Reads a range as it is written: `0..0.5`.
    pub fn range_of(text: &str) -> Result<[f64; 2], String> {
        let wrong = || {
            format!("'{}' is no range: two numbers, the smaller first, as in 0..0.5", shown(text))
        };
        let (from, to) = text.split_once("..").ok_or_else(wrong)?;
        let number =
            |text: &str| text.trim().parse().ok().filter(|x: &f64| (0.0..=1e3).contains(x));
        let (from, to) = (number(from).ok_or_else(wrong)?, number(to).ok_or_else(wrong)?);
        // Closer ends would ask more of the drawing than its numbers tell.
        (to - from > 1e-6 * to).then_some([from, to]).ok_or_else(wrong)
    }

    fn of(self, axis: PlaneAxis) -> PlaneAxis {
        use Coordinate as C;
        if self == Self::default() {
            return axis;
        }
        let other = |of, label, range| PlaneAxis::new(of, label, range, axis.step);
        let usual = match (self.unit, axis.coordinate) {
            (Unit::Usual, _) => axis,
            (Unit::Radians, coordinate) => {
                let label = match coordinate {
                    C::HalfOpening => "half opening α (rad)",
                    _ => "friction angle φ (rad)",
                };
                PlaneAxis { unit: 1.0, label, range: axis.range.map(|end| end / DEGREES), ..axis }
            }
            (_, C::HalfOpening) => other(C::OpeningVariable, "A = α cot(α/2)", [0.4, 2.0]),
            (_, C::FrictionAngle) => other(C::Friction, "friction coefficient μ", [0.0, 4.0]),
            _ => other(C::LogThickness, "thickness to radius η = t/r", [THIN, 2.0]),
        };
        let range = self.range.unwrap_or(usual.range);
        let is_logarithm = usual.coordinate == C::LogThickness;
        let range = if is_logarithm { range.map(f64::log10) } else { range };
        PlaneAxis { range, step: step(range, 5.0).unwrap_or(axis.step), ..usual }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_as_asked_for() {
        let axes = Axes {
            thickness: Shown { unit: Unit::Derived, range: Some([1e-3, 1.0]) },
            friction: Shown { unit: Unit::Derived, range: None },
            ..Axes::default()
        };
        let canvas = Canvas::new(Plane::ThicknessFriction, &axes);
        let [x, y] = canvas.axes;
        assert!((x.shown(1f64.atan()) - 1.0).abs() < 1e-12 && (y.shown(0.01) + 2.0).abs() < 1e-12);
        assert!(y.shown(0.0).is_finite() && y.range == [-3.0, 0.0] && !canvas.is_usual);
        assert!(x.shown(std::f64::consts::FRAC_PI_2) > 4.0, "beyond the edge");
        assert!(Canvas::new(Plane::OpeningFriction, &Axes::default()).is_usual);
    }

    #[test]
    fn axes_fit_their_plane() {
        let log = |range| Axes {
            thickness: Shown { unit: Unit::named("log"), range },
            ..Axes::default()
        };
        assert_eq!(log(None).misfit(Plane::ThicknessFriction), None);
        assert!(log(None).misfit(Plane::OpeningFriction).unwrap().contains("no axis of thickness"));
        assert!(log(Some([0.0, 1.0])).misfit(Plane::OpeningThickness).unwrap().contains("1e-9"));
        approx::assert_relative_eq!(log(Some([1e-3, 1.0])).tolerance(1e-4), 1e-7);
        assert_eq!(log(Some([1e-9, 1.0])).tolerance(1e-4), LEAST_TOLERANCE);
        assert_eq!(Axes::default().tolerance(1e-4), 1e-4);
        for wrong in ["1", "1..0.5", "-1..1", "0..x", "1..1"] {
            assert!(Shown::range_of(wrong).unwrap_err().contains("is no range"), "{wrong}");
        }
    }
}
