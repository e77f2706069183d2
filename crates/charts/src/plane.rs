//! Quantities along the axes.

use crate::atlas::{Contour, Coordinate, Place};
use crate::number::{Ball, worded};
use crate::picture::scale::Tick;
use crate::picture::text;
use std::str::FromStr;

worded! {
    /// A plane in which the map is drawn.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Plane {
        /// Thickness over friction angle, as Figures 5 and 6 of the paper: every domain is an area.
        ThicknessFriction = "thickness-friction",
        /// Friction angle over half opening: which mode an arch has.
        OpeningFriction = "opening-friction",
        /// Thickness over half opening: how much friction an arch needs.
        OpeningThickness = "opening-thickness",
    }
    /// All planes.
    pub const ALL;
    /// The name on the command line.
    pub fn name -> &'static str;
}

/// One of its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlaneAxis {
    /// Coordinate that it shows.
    pub coordinate: Coordinate,
    /// Units shown in a radian, or in one of what else it shows.
    pub unit: f64,
    /// The text beside it.
    pub label: &'static str,
    /// Range in the unit shown.
    pub range: [f64; 2],
    /// Step between two ticks; of a logarithm a decade.
    pub step: f64,
}

/// Degrees in a radian.
pub(super) const DEGREES: f64 = 180.0 / std::f64::consts::PI;

const FRICTION: PlaneAxis =
    PlaneAxis::new(Coordinate::FrictionAngle, "friction angle φ (°)", [0.0, 90.0], 10.0);
const THICKNESS: PlaneAxis =
    PlaneAxis::new(Coordinate::Thickness, "thickness to radius η = t/r", [0.0, 2.0], 0.2);
const OPENING: PlaneAxis =
    PlaneAxis::new(Coordinate::HalfOpening, "half opening α (°)", [0.0, 170.0], 20.0);

/// Friction coefficients that have a tick.
const FRICTIONS: [(f64, &str); 13] = [
    (0.0, "0"),
    (0.2, "0.2"),
    (0.4, "0.4"),
    (0.6, "0.6"),
    (0.8, "0.8"),
    (1.0, "1"),
    (1.25, "1.25"),
    (1.5, "1.5"),
    (2.0, "2"),
    (3.0, "3"),
    (5.0, "5"),
    (10.0, "10"),
    (f64::INFINITY, "∞"),
];
/// The levels of each plane: what both weights have.
const OPENINGS: [&str; 9] =
    ["40deg", "60deg", "80deg", "100deg", "120deg", "130deg", "140deg", "145deg", "150deg"];
const THICKNESSES: [&str; 9] = ["0.01", "0.05", "0.1", "0.2", "0.3", "0.4", "0.6", "0.8", "1.4"];
const FRICTION_LEVELS: [&str; 9] = ["0.1", "0.2", "0.3", "0.4", "0.6", "0.8", "1", "1.5", "3"];
/// The label of their axis.
pub(super) const FRICTION_LABEL: &str = "friction coefficient μ = tan φ";

impl Plane {
    /// The plane of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|plane| plane.name().eq_ignore_ascii_case(name))
    }

    /// Sentence on what a map in the plane shows.
    pub(super) fn shows(self) -> &'static str {
        match self {
            Self::ThicknessFriction => {
                "The domains of the collapse modes over thickness and friction"
            }
            Self::OpeningFriction => {
                "The collapse mode of an arch at its least thickness, by half opening and friction"
            }
            Self::OpeningThickness => {
                "The collapse mode of an arch at its least friction, by half opening and thickness"
            }
        }
    }

    /// The name of the quantity whose levels are lines in the plane.
    pub fn contour_name(self) -> &'static str {
        match self {
            Self::ThicknessFriction => "half opening",
            Self::OpeningFriction => "thickness",
            Self::OpeningThickness => "friction",
        }
    }

    /// Label of contours, beside their values.
    pub(super) fn contour_label(self) -> &'static str {
        match self {
            Self::ThicknessFriction => "lines of equal half opening α",
            Self::OpeningFriction => "lines of equal least thickness η",
            Self::OpeningThickness => "lines of equal least friction μ",
        }
    }

    /// Tells whether the levels of a quantity are lines in the plane.
    pub fn is_crossed_by(self, contour: &Contour) -> bool {
        contour.name() == self.contour_name()
    }

    /// The levels that are drawn unless others are asked for.
    pub fn contours(self) -> Vec<Contour> {
        match self {
            Self::ThicknessFriction => levels(OPENINGS, Contour::HalfOpening),
            Self::OpeningFriction => levels(THICKNESSES, Contour::Thickness),
            Self::OpeningThickness => levels(FRICTION_LEVELS, Contour::Friction),
        }
    }

    /// Axes to the right, and up.
    pub(super) fn axes(self) -> [PlaneAxis; 2] {
        match self {
            Self::ThicknessFriction => [FRICTION, THICKNESS],
            Self::OpeningFriction => [OPENING, FRICTION],
            Self::OpeningThickness => [OPENING, THICKNESS],
        }
    }
}

fn levels<T: FromStr>(values: [&str; 9], level: fn(T) -> Contour) -> Vec<Contour> {
    values.into_iter().filter_map(|text| text.parse().ok().map(level)).collect()
}

/// Lengths of an axis.
const FAR: f64 = 4.0;

impl PlaneAxis {
    /// Axis of an angle in degrees, or of what else there is.
    pub(super) const fn new(
        coordinate: Coordinate,
        label: &'static str,
        range: [f64; 2],
        step: f64,
    ) -> Self {
        use Coordinate::{FrictionAngle, HalfOpening, RotationJoint};
        let is_angle = matches!(coordinate, HalfOpening | FrictionAngle | RotationJoint);
        let unit = if is_angle { DEGREES } else { 1.0 };
        Self { coordinate, unit, label, range, step }
    }

    /// Tells whether the axis shows the friction angle.
    pub(super) fn is_friction_angle(&self) -> bool {
        self.coordinate == Coordinate::FrictionAngle
    }

    /// A value of its variable in the unit shown.
    pub(super) fn shown(&self, value: f64) -> f64 {
        // As far off as this nothing is seen, and everything is finite.
        let [low, high] = self.range;
        let far = FAR * (high - low);
        (self.coordinate.drawn(value) * self.unit).clamp(low - far, high + far)
    }

    /// Place of a point on the axis, in the unit shown.
    pub(super) fn place(&self, place: &Place) -> Option<f64> {
        let other = |value: &Option<Ball>| Some(value.as_ref()?.mid().to_f64() * self.unit);
        match self.coordinate {
            Coordinate::Thrust => other(&place.thrust),
            Coordinate::RotationJoint => other(&place.rotation_joint),
            of => Some(self.shown(place.coordinate(of.variable()?)?.mid().to_f64())),
        }
    }

    /// Ticks of the axis within a range.
    pub(super) fn ticks(&self, range: [f64; 2], step: Option<f64>) -> Vec<Tick> {
        if self.coordinate == Coordinate::LogThickness {
            return decades(range);
        }
        let step = step.unwrap_or(self.step);
        even(range, step, |value| value)
    }
}

/// The first and the last multiple of a step in a range; an end that is one but for rounding is one.
fn multiples([from, to]: [f64; 2], step: f64) -> [f64; 2] {
    [(from / step - 1e-9).ceil(), (to / step + 1e-9).floor()]
}

/// Ticks at the multiples of a step in a range, each where `place` has it.
fn even(range: [f64; 2], step: f64, place: impl Fn(f64) -> f64) -> Vec<Tick> {
    let decimals = (-step.log10().floor()).max(0.0) as usize;
    let [first, last] = multiples(range, step).map(|k| k as i64);
    let values = (first..=last).map(|k| k as f64 * step);
    values.map(|x| Tick { place: place(x), label: text::number(x, decimals) }).collect()
}

/// The largest round step with so many multiples in a range.
pub(super) fn step(range: [f64; 2], least: f64) -> Option<f64> {
    let power = 10f64.powf((range[1] - range[0]).log10().floor());
    let steps = [5.0, 2.0, 1.0, 0.5, 0.2, 0.1].map(|m| m * power);
    let count = |step: f64| {
        let [first, last] = multiples(range, step);
        last - first + 1.0
    };
    steps.into_iter().find(|step| count(*step) >= least)
}

/// Part of a logarithm in which there may be no power of ten: its values have ticks at equal steps.
const SHORT: f64 = 0.5;

/// Ticks at powers of ten, and between few of them at twice and five times these.
fn decades([low, high]: [f64; 2]) -> Vec<Tick> {
    if high - low < SHORT {
        let range = [low, high].map(|end| 10f64.powf(end));
        let step = step(range, 3.0).unwrap_or(range[1] - range[0]);
        return even(range, step, f64::log10);
    }
    let digits: &[u32] = if high - low < 3.0 { &[1, 2, 5] } else { &[1] };
    let label = |digit: u32, order: i64| match digit {
        1 => text::power_of_ten(order),
        _ => format!("{digit}×{}", text::power_of_ten(order)),
    };
    let tick = |digit: u32, order: i64| Tick {
        place: order as f64 + f64::from(digit).log10(),
        label: label(digit, order),
    };
    let all = (low.floor() as i64..=high.ceil() as i64)
        .flat_map(|order| digits.iter().map(move |digit| tick(*digit, order)));
    all.filter(|tick| (low - 1e-9..=high + 1e-9).contains(&tick.place)).collect()
}

/// Ticks of the friction coefficient, at friction angles in the unit of an axis, where it shows them.
pub(super) fn friction_ticks(axis: &PlaneAxis) -> Vec<Tick> {
    let tick =
        |(mu, label): (f64, &str)| Tick { place: mu.atan() * axis.unit, label: label.into() };
    let [low, high] = axis.range;
    let is_seen = |tick: &Tick| (low..=high + 1e-9).contains(&tick.place);
    FRICTIONS.map(tick).into_iter().filter(is_seen).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_plane_has_its_levels() {
        for plane in Plane::ALL {
            let contours = plane.contours();
            assert_eq!(contours.len(), 9, "{plane:?}");
            assert!(contours.iter().all(|contour| plane.is_crossed_by(contour)));
        }
    }

    #[test]
    fn ticks_are_round_and_end_with_the_range() {
        let labels = |ticks: Vec<Tick>| ticks.into_iter().map(|t| t.label).collect::<Vec<_>>();
        let ticks = labels(THICKNESS.ticks(THICKNESS.range, None));
        assert_eq!((ticks.len(), ticks[0].as_str(), ticks[10].as_str()), (11, "0.0", "2.0"));
        assert_eq!(labels(FRICTION.ticks([59.3, 60.7], Some(0.5))), ["59.5", "60.0", "60.5"]);
        assert_eq!(labels(THICKNESS.ticks([0.0, 0.3], Some(0.05))).last().unwrap(), "0.30");
        assert_eq!(friction_ticks(&FRICTION)[12].place, 90.0);
        assert!((friction_ticks(&FRICTION)[5].place - 45.0).abs() < 1e-12);
    }

    #[test]
    fn steps_are_round() {
        for (range, expected) in
            [([0.0, 1.0], 0.5), ([59.9, 61.1], 0.5), ([56.6, 57.5], 0.2), ([0.91, 0.98], 0.02)]
        {
            let step = step(range, 3.0).unwrap();
            assert!((step - expected).abs() < 1e-12, "{range:?} {step}");
        }
        assert_eq!(step([0.0, 4.0], 5.0), Some(1.0));
    }

    #[test]
    fn a_short_part_of_a_logarithm_has_ticks_too() {
        let labels = |range| decades(range).into_iter().map(|t| t.label).collect::<Vec<_>>();
        assert_eq!(labels([-4.0, 0.3]), ["10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"]);
        assert_eq!(labels([0.86f64.log10(), 0.91f64.log10()]), ["0.86", "0.88", "0.90"]);
    }
}
