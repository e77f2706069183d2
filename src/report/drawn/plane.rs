//! What lies along the axes.

use crate::atlas::{Contour, Place, Variable};
use crate::picture::scale::Tick;

/// A plane in which the map is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// Thickness over friction angle, as Figures 5 and 6 of the paper: every domain is an area.
    ThicknessFriction,
    /// Friction angle over half opening: which mode an arch has.
    OpeningFriction,
    /// Thickness over half opening: how much friction an arch needs.
    OpeningThickness,
}

/// One of its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    /// What it shows.
    pub variable: Variable,
    /// The text beside it.
    pub label: &'static str,
    /// In the unit shown: degrees for angles.
    pub range: [f64; 2],
    /// Between two ticks.
    pub step: f64,
}

const FRICTION: Axis = Axis {
    variable: Variable::FrictionAngle,
    label: "friction angle φ (°)",
    range: [0.0, 90.0],
    step: 10.0,
};
const THICKNESS: Axis = Axis {
    variable: Variable::Thickness,
    label: "thickness to radius η = t/r",
    range: [0.0, 2.0],
    step: 0.2,
};
const OPENING: Axis = Axis {
    variable: Variable::HalfOpening,
    label: "half opening α (°)",
    range: [0.0, 170.0],
    step: 20.0,
};

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
    /// All planes.
    pub const ALL: [Self; 3] =
        [Self::ThicknessFriction, Self::OpeningFriction, Self::OpeningThickness];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::ThicknessFriction => "thickness-friction",
            Self::OpeningFriction => "opening-friction",
            Self::OpeningThickness => "opening-thickness",
        }
    }

    /// The plane of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|plane| plane.name().eq_ignore_ascii_case(name))
    }

    /// The name of the quantity whose levels are lines in the plane.
    pub fn contour_name(self) -> &'static str {
        match self {
            Self::ThicknessFriction => "half opening",
            Self::OpeningFriction => "thickness",
            Self::OpeningThickness => "friction",
        }
    }

    /// What is written beside their values.
    pub(super) fn contour_label(self) -> &'static str {
        match self {
            Self::ThicknessFriction => "lines of equal half opening α",
            Self::OpeningFriction => "lines of equal least thickness η",
            Self::OpeningThickness => "lines of equal least friction μ",
        }
    }

    /// Whether the levels of a quantity are lines in the plane.
    pub fn is_crossed_by(self, contour: &Contour) -> bool {
        contour.name() == self.contour_name()
    }

    /// The levels that are drawn unless others are asked for.
    pub fn contours(self) -> Vec<Contour> {
        let values: &[&str] = match self {
            Self::ThicknessFriction => &OPENINGS,
            Self::OpeningFriction => &THICKNESSES,
            Self::OpeningThickness => &FRICTION_LEVELS,
        };
        let contour = |text: &&str| {
            Some(match self {
                Self::ThicknessFriction => Contour::HalfOpening(text.parse().ok()?),
                Self::OpeningFriction => Contour::Thickness(text.parse().ok()?),
                Self::OpeningThickness => Contour::Friction(text.parse().ok()?),
            })
        };
        values.iter().filter_map(contour).collect()
    }

    /// To the right, and up.
    pub(super) fn axes(self) -> [Axis; 2] {
        match self {
            Self::ThicknessFriction => [FRICTION, THICKNESS],
            Self::OpeningFriction => [OPENING, FRICTION],
            Self::OpeningThickness => [OPENING, THICKNESS],
        }
    }
}

impl Axis {
    /// A value in the unit shown.
    pub(super) fn shown(&self, value: f64) -> f64 {
        if self.variable == Variable::Thickness { value } else { value.to_degrees() }
    }

    /// Where a place is on it, in the unit shown.
    pub(super) fn place(&self, place: &Place) -> Option<f64> {
        Some(self.shown(place.coordinate(self.variable)?.mid().to_f64()))
    }

    /// Its ticks within a range.
    pub(super) fn ticks(&self, range: [f64; 2], step: Option<f64>) -> Vec<Tick> {
        let step = step.unwrap_or(self.step);
        let decimals = (-step.log10().floor()).max(0.0) as usize;
        let (first, last) = ((range[0] / step).ceil() as i64, (range[1] / step).floor() as i64);
        let place = |k: i64| k as f64 * step;
        let tick = |k| Tick { place: place(k), label: format!("{:.decimals$}", place(k)) };
        (first..=last).map(tick).collect()
    }
}

/// Ticks of the friction coefficient, at friction angles in degrees.
pub(super) fn friction_ticks() -> Vec<Tick> {
    let tick =
        |(mu, label): (f64, &str)| Tick { place: mu.atan().to_degrees(), label: label.into() };
    FRICTIONS.map(tick).into()
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
        assert_eq!(friction_ticks()[12].place, 90.0);
        assert!((friction_ticks()[5].place - 45.0).abs() < 1e-12);
    }
}
