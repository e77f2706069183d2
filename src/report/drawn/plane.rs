//! What lies along the axes.

use crate::atlas::Variable;
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
    fn ticks_are_round_and_end_with_the_range() {
        let labels = |ticks: Vec<Tick>| ticks.into_iter().map(|t| t.label).collect::<Vec<_>>();
        let ticks = labels(THICKNESS.ticks(THICKNESS.range, None));
        assert_eq!((ticks.len(), ticks[0].as_str(), ticks[10].as_str()), (11, "0.0", "2.0"));
        assert_eq!(labels(FRICTION.ticks([59.3, 60.7], Some(0.5))), ["59.5", "60.0", "60.5"]);
        assert_eq!(friction_ticks()[12].place, 90.0);
        assert!((friction_ticks()[5].place - 45.0).abs() < 1e-12);
    }
}
