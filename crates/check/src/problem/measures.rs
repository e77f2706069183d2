//! An arch as it is measured: in metres, at one of its circles, with the weight of its material.
//!
//! Angles are the same at all circles, so the half opening needs no thickness:
//!
//! ```text
//! tan(alpha/2) = rise / (span/2)        R = (span²/4 + rise²) / (2 rise)
//! ```
//!
//! The centreline is half a thickness from the intrados and from the extrados. With `c` = 1, 0, -1 where the circle of
//! radius `R` is the intrados, the centreline, the extrados:
//!
//! ```text
//! r = R + c t/2        eta = t/r        and back: r = R / (1 - c eta/2), t = eta r
//! span = 2 R sin(alpha)        rise = R (1 - cos(alpha))
//! ```
//!
//! So any two of half opening, span, rise and radius make the others. With a radius the square of the cotangent of the
//! half opening is rational; of a span and a radius there are two arcs, of which the flatter one is meant.
//!
//! Everything given is rational, and so is `eta`. A span is measured at the intrados unless another circle is named.

use super::length::exceeds;
pub use super::length::{Length, LengthUnit, MeasureError, UnitWeight};
use crate::number::{Engine, ExactNumber, Field, rational_sine_and_cosine, worded};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::str::FromStr;

worded! {
    /// The circle at which an arch is measured.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Circle {
        /// The inner face: the clear span.
        #[default]
        Intrados = "intrados",
        /// The circle half a thickness from both faces: the radius `r` of the paper.
        Centreline = "centreline",
        /// The outer face.
        Extrados = "extrados",
    }
    /// All of them, in order.
    pub const ALL;
    /// Name of the circle in files and on the command line.
    pub fn name -> &'static str;
}

/// The size of an arch.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Measures {
    circle: Circle,
    radius: Length,
    loaded: Option<(UnitWeight, Length)>,
    unit: LengthUnit,
}

impl FromStr for Circle {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let found = Self::ALL.into_iter().find(|circle| circle.name() == text);
        found.ok_or_else(|| "one of intrados, centreline, extrados".to_owned())
    }
}

impl Circle {
    /// Half thicknesses from it to the centreline, outwards.
    pub const fn to_centreline(self) -> i32 {
        match self {
            Self::Intrados => 1,
            Self::Centreline => 0,
            Self::Extrados => -1,
        }
    }

    /// Radius of the centreline of an arch of thickness `eta` whose radius at this circle is given.
    pub fn centreline<T: Field>(self, radius: T, eta: &T) -> T {
        radius / (eta.int(1) - eta.ratio(self.to_centreline(), 2) * eta)
    }
}

/// The circle of a span and a rise: the tangent of a quarter of its opening, and its radius.
pub fn circle<T: Field>(span: &T, rise: &T) -> [T; 2] {
    let half = span.ratio(1, 2) * span;
    [rise.clone() / &half, (half.square() + rise.square()) / (rise.int(2) * rise)]
}

/// The half opening of an arch of this span and rise, and the radius of the circle at which both are measured.
pub fn of_span_and_rise(span: &Length, rise: &Length) -> (ExactNumber, Length) {
    let [tangent, radius] = circle(&span.0, &rise.0);
    (ExactNumber::twice_arctangent(tangent), Length(radius))
}

/// Least and largest radius of the circles of some spans and rises: it grows with the span, and is convex in the rise
/// and least at half the span.
pub fn radii([short, long]: &[Length; 2], [low, high]: &[Length; 2]) -> [Length; 2] {
    let half = Length(&short.0 / BigInt::from(2));
    let nearest = if low.exceeds(&half) { low } else { &half };
    let nearest = if nearest.exceeds(high) { high } else { nearest };
    let radius = |span: &Length, rise: &Length| of_span_and_rise(span, rise).1;
    let [one, other] = [low, high].map(|rise| radius(long, rise));
    [radius(short, nearest), if one.exceeds(&other) { one } else { other }]
}

/// The half opening of a span, the flatter arc, or of a rise at this radius; nothing if there is neither.
pub fn half_opening_of(
    [span, rise]: [Option<&Length>; 2],
    radius: &Length,
) -> Option<Result<ExactNumber, MeasureError>> {
    let square = |x: &BigRational| x * x;
    // Squares of `R cos(alpha)` and of `R sin(alpha)`.
    let (name, chord, height, is_obtuse) = match (span, rise) {
        (Some(span), _) => {
            ("span", span, square(&radius.0) - square(&(&span.0 / BigInt::from(2))), false)
        }
        (None, rise) => {
            let rise = rise?;
            ("rise", rise, square(&(&radius.0 - &rise.0)), exceeds(&rise.0, &radius.0))
        }
    };
    let (half, zero) = (square(&radius.0) - &height, BigRational::from(BigInt::ZERO));
    if height < zero || half <= zero {
        return Some(Err(MeasureError::Chord {
            chord: format!("{name} {chord}"),
            radius: radius.to_string(),
            diameter: Length(&radius.0 * BigInt::from(2)).to_string(),
        }));
    }
    let cotangent = height / half;
    let q = if is_obtuse { cotangent } else { -cotangent };
    Some(Ok(ExactNumber::arctangent_of_root(q)))
}

/// The radius of a span or a rise at a half opening, where that is known exactly.
pub fn radius_at(half_opening: &ExactNumber, [span, rise]: [Option<&Length>; 2]) -> Option<Length> {
    let [sine, cosine] = rational_sine_and_cosine(half_opening);
    let one = BigRational::from(BigInt::from(1));
    match (span, rise) {
        (Some(span), _) => sine.map(|sine| Length(&span.0 / (sine * BigInt::from(2)))),
        (None, Some(rise)) => cosine.map(|cosine| Length(&rise.0 / (one - cosine))),
        (None, None) => None,
    }
}

impl Measures {
    /// The radius of a circle of the arch; with the weight of its material and its depth there are forces too.
    pub fn new(circle: Circle, radius: Length, loaded: Option<(UnitWeight, Length)>) -> Self {
        Self { circle, radius, loaded, unit: LengthUnit::default() }
    }

    /// Measures with another unit, in which they are told.
    pub fn told_in(self, unit: LengthUnit) -> Self {
        Self { unit, ..self }
    }

    /// The unit in which lengths are told, metres unless one was given.
    pub fn unit(&self) -> LengthUnit {
        self.unit
    }

    /// The circle that is measured.
    pub fn circle(&self) -> Circle {
        self.circle
    }

    /// The radius of that circle, in metres.
    pub fn radius(&self) -> ExactNumber {
        ExactNumber::rational(self.radius.0.clone())
    }

    /// The span and the rise of that circle at the half opening `alpha` (rad), in metres.
    pub fn span_and_rise<E: Engine>(&self, alpha: &E, bits: u32) -> [E; 2] {
        let radius: E = self.radius().enclosure(bits);
        // Nothing cancels in the rise of half the angle.
        let (sin, cos) = (alpha.clone() / alpha.int(2)).sin_cos();
        let chord = radius.int(2) * radius * &sin;
        [chord.int(2) * &chord * cos, chord * sin]
    }

    /// Span and rise, where they are rational.
    pub fn exact_span_and_rise(&self, half_opening: &ExactNumber) -> [Option<ExactNumber>; 2] {
        let radius = &self.radius.0;
        let [sine, cosine] = rational_sine_and_cosine(half_opening);
        let span = sine.map(|sine| radius * BigInt::from(2) * sine);
        let rise = cosine.map(|cosine| radius * (BigRational::from(BigInt::from(1)) - cosine));
        [span, rise].map(|length| length.map(ExactNumber::rational))
    }

    /// Tells whether forces can be told.
    pub fn has_forces(&self) -> bool {
        self.loaded.is_some()
    }

    /// `eta = t/r`, at most 2: there the intrados is a point.
    pub fn thickness(&self, thickness: &Length) -> Result<ExactNumber, MeasureError> {
        let (t, radius) = (&thickness.0, &self.radius.0);
        // At twice the radius of the centreline the intrados has none.
        let most = match self.circle {
            Circle::Intrados => None,
            Circle::Centreline => Some((radius * BigInt::from(2), "diameter")),
            Circle::Extrados => Some((radius.clone(), "radius")),
        };
        match most.filter(|(most, _)| exceeds(t, most)) {
            Some((most, rule)) => Err(MeasureError::Thickness {
                thickness: thickness.to_string(),
                circle: self.circle.name(),
                most: Length(most).to_string(),
                rule,
            }),
            None => {
                let half = BigRational::new(self.circle.to_centreline().into(), 2.into());
                Ok(ExactNumber::rational(t / (radius + t * half)))
            }
        }
    }

    /// The radius of the centreline in metres, where it is known exactly: of a given thickness `eta`, or measured
    /// itself.
    pub fn exact_radius(&self, eta: Option<&ExactNumber>) -> Option<ExactNumber> {
        let one = || BigRational::from(BigInt::from(1));
        let half = BigRational::new(self.circle.to_centreline().into(), 2.into());
        let outwards = match (self.circle, eta) {
            (Circle::Centreline, _) => one(),
            (_, Some(eta)) => one() - half * eta.factor(),
            (_, None) => return None,
        };
        let has_intrados = outwards > BigInt::ZERO.into();
        has_intrados.then(|| ExactNumber::rational(&self.radius.0 / outwards))
    }

    /// `w r` in kN at a thickness `eta`, the unit of the thrust `h`: it grows with the radius and the thickness, up to
    /// `eta = 2`.
    pub fn exact_force(&self, eta: &ExactNumber) -> Option<ExactNumber> {
        let ((unit, depth), radius) = self.loaded.as_ref().zip(self.exact_radius(Some(eta)))?;
        let area = radius.factor() * radius.factor() * eta.factor();
        Some(ExactNumber::rational(&unit.0 * &depth.0 * area))
    }

    /// The sizes of an arch of thickness `eta` and half opening `alpha` (rad), in numbers of `bits` bits.
    pub fn sizes<E: Engine>(&self, eta: &E, alpha: &E, bits: u32) -> Sizes<E> {
        let number = |x: &BigRational| ExactNumber::rational(x.clone()).enclosure::<E>(bits);
        let radius = self.circle.centreline(number(&self.radius.0), eta);
        let thickness = eta.clone() * &radius;
        let loaded = self.loaded.as_ref();
        let unit = |(weight, depth): &(UnitWeight, Length)| {
            number(&weight.0) * number(&depth.0) * &thickness * &radius
        };
        let force = loaded.map(unit);
        let weight = force.clone().map(|force| force * alpha.int(2) * alpha);
        Sizes { radius, thickness, force, weight }
    }
}

/// Sizes of an arch.
#[derive(Clone, Debug)]
pub struct Sizes<E> {
    /// The radius of the centreline, m.
    pub radius: E,
    /// The thickness, m.
    pub thickness: E,
    /// `w r`, kN: the unit of the thrust `h`.
    pub force: Option<E>,
    /// The weight of the whole arch, kN.
    pub weight: Option<E>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Enclosure, Field, Form, Real};

    fn length(text: &str) -> Length {
        text.parse().unwrap()
    }

    #[test]
    fn span_and_rise_are_those_of_the_arch() {
        let (alpha, radius) = of_span_and_rise(&length("10m"), &length("3m"));
        let alpha: AstroInterval = alpha.enclosure(200);
        let (sin, cos) = alpha.sin_cos();
        let radius: AstroInterval = ExactNumber::rational(radius.0).enclosure(200);
        let ten = radius.clone() * sin * radius.int(2);
        assert!(ten.overlaps(&ten.int(10)));
        let three = radius.clone() - radius * cos;
        assert!(three.overlaps(&three.int(3)));
        let (half_turn, radius) = of_span_and_rise(&length("8m"), &length("400cm"));
        assert_eq!((half_turn.form(), radius), (Form::TimesPi, length("4m")));
    }

    /// The exact span and rise are those of the sine and the cosine, wherever there are any.
    #[test]
    fn span_and_rise_are_exact_where_they_are_rational() {
        let of = |radius: &str| Measures::new(Circle::Intrados, length(radius), None);
        let rational =
            [("2atan(3/5)", 2), ("2atan(5)", 2), ("90deg", 2), ("30deg", 1), ("5pi/6", 1)];
        let others = [("pi/3", 1), ("120deg", 1), ("45deg", 0), ("1", 0), ("1/6", 0)];
        for (text, count) in rational.into_iter().chain(others) {
            let measures = of("1.25m");
            let alpha: ExactNumber = text.parse().unwrap();
            let exact = measures.exact_span_and_rise(&alpha);
            assert_eq!(exact.iter().flatten().count(), count, "{text}");
            let alpha: AstroInterval = alpha.enclosure(100);
            for (length, exact) in measures.span_and_rise(&alpha, 100).iter().zip(&exact) {
                let exact = exact.as_ref().map(|x| x.enclosure::<AstroInterval>(100));
                assert!(exact.is_none_or(|exact| exact.overlaps(length)), "{text}");
            }
        }
        let (alpha, radius) = of_span_and_rise(&length("10m"), &length("3m"));
        let given = Measures::new(Circle::Intrados, radius, None).exact_span_and_rise(&alpha);
        assert_eq!(given.map(|x| x.unwrap().to_string()), ["10", "3"]);
    }

    #[test]
    fn the_thickness_goes_there_and_back() {
        for circle in [Circle::Intrados, Circle::Centreline, Circle::Extrados] {
            let loading = Some(("24kN/m3".parse().unwrap(), length("2m")));
            let measures = Measures::new(circle, length("5m"), loading);
            let eta: AstroInterval = measures.thickness(&length("60cm")).unwrap().enclosure(100);
            let sizes = measures.sizes(&eta, &eta.int(1), 100);
            let three_fifths = eta.ratio(3, 5);
            assert!(sizes.thickness.overlaps(&three_fifths), "{circle:?}");
            let half = three_fifths.clone() * three_fifths.ratio(circle.to_centreline(), 2);
            assert!(sizes.radius.overlaps(&(half + three_fifths.int(5))), "{circle:?}");
            // 24 kN/m3 x 2 m x 0.6 m x r, and twice the half opening of one radian.
            let force = sizes.radius.clone() * sizes.radius.ratio(144, 5);
            assert!(sizes.force.as_ref().unwrap().overlaps(&force));
            assert!(sizes.weight.unwrap().overlaps(&(force.clone() + force)));
        }
    }

    #[test]
    fn a_thickness_that_is_not_possible_is_refused() {
        let at = |circle, thickness: &str| {
            Measures::new(circle, length("5m"), None).thickness(&length(thickness))
        };
        assert!(at(Circle::Centreline, "10m").is_ok() && at(Circle::Centreline, "10.1m").is_err());
        assert!(at(Circle::Extrados, "5m").is_ok() && at(Circle::Extrados, "5001mm").is_err());
        assert!(at(Circle::Extrados, "100m").unwrap_err().to_string().contains("extrados"));
        assert!(at(Circle::Intrados, "1000m").is_ok(), "never twice its centreline");
    }
}
