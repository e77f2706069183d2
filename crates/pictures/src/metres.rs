//! Measures of an arch in metres and kilonewtons, told in the unit in which they were given.

use crate::atlas::{Sketch, Subject};
use crate::number::{Ball, Enclosure, ExactNumber, Field, Rounded};
use crate::problem::measures::{Circle, LengthUnit, Measures};
use rug::Rational;

/// The sizes of an arch that is drawn.
pub(super) struct Metres {
    /// The circle at which it is measured.
    pub circle: Circle,
    /// The unit in which lengths are told.
    pub unit: LengthUnit,
    /// The radius of that circle in units of `r`.
    pub share: f64,
    /// The radius of the centreline, m.
    pub radius: Size,
    /// The thickness, m.
    pub thickness: Size,
    /// Distance between the springing points of the circle that is measured, m.
    pub span: Size,
    /// Rise of the crown above these points, m.
    pub rise: Size,
    /// Loads: what the arch weighs and what it bears, where that is known.
    pub loads: Option<Loads>,
}

/// Forces, kN.
pub(super) struct Loads {
    /// `w r`, the unit of the thrust.
    pub unit: Size,
    /// Weight of the whole arch, `2 w r alpha`.
    pub weight: Size,
    /// Load of a half: what a shoulder carries.
    pub reaction: Size,
}

impl Loads {
    /// The thrust `h` as a force.
    pub(super) fn thrust(&self, thrust: &Ball) -> Size {
        (self.unit.value.clone() * thrust).into()
    }
}

/// A size: a ball, and the number itself where that is rational.
#[derive(Clone)]
pub(super) struct Size {
    pub value: Ball,
    exact: Option<Rational>,
}

impl From<Ball> for Size {
    fn from(value: Ball) -> Self {
        Self { value, exact: None }
    }
}

impl Size {
    /// Correctly rounded; `None` where the ball does not decide it.
    pub(super) fn rounded(&self, digits: usize) -> Option<Rounded> {
        match &self.exact {
            Some(exact) => Rounded::from_rational(exact, digits),
            None => Rounded::around(&self.value, digits),
        }
    }

    /// The size in a unit of so many metres.
    pub(super) fn over(&self, unit: &ExactNumber) -> Self {
        let value = self.value.clone() / unit.enclosure::<Ball>(self.value.prec());
        Self { value, exact: self.exact.as_ref().map(|exact| exact.clone() / unit.to_rational()) }
    }

    /// Size as a double, for the eye.
    pub(super) fn double(&self) -> f64 {
        self.value.mid().to_f64()
    }
}

impl Metres {
    pub(super) fn new(measures: &Measures, sketch: &Sketch) -> Self {
        let (eta, alpha) = (&sketch.at.thickness, &sketch.at.half_opening);
        let given = match &sketch.subject {
            Subject::Standing { thickness, .. } | Subject::Sliding { thickness, .. } => {
                Some(thickness)
            }
            Subject::Least(_) | Subject::Landmark(_) => None,
        };
        let sizes = measures.sizes(eta, &alpha.rad, eta.prec());
        let exact = measures.exact_radius(given).map(|radius| radius.to_rational());
        let thickness = exact.as_ref().zip(given).map(|(r, eta)| eta.to_rational() * r);
        let measured: Ball = measures.radius().enclosure(eta.prec());
        let [span, rise] = measures.span_and_rise(&alpha.rad, eta.prec());
        let share = (measured / &sizes.radius).mid().to_f64();
        let loads = sizes.force.zip(sizes.weight).map(|(unit, weight)| Loads {
            unit: unit.into(),
            reaction: (weight.clone() / weight.int(2)).into(),
            weight: weight.into(),
        });
        Self {
            circle: measures.circle(),
            unit: measures.unit(),
            share,
            radius: Size { value: sizes.radius, exact },
            thickness: Size { value: sizes.thickness, exact: thickness },
            span: span.into(),
            rise: rise.into(),
            loads,
        }
    }

    /// The radius of the centreline in that unit, for the eye.
    pub(super) fn radius_told(&self) -> f64 {
        self.radius.over(&self.unit.metres()).double()
    }

    /// The thickness of an arch of the same measures that is thinner or thicker, m.
    pub(super) fn thickness_of(measures: &Measures, sketch: &Sketch, eta: &Ball) -> Size {
        measures.sizes(eta, &sketch.at.half_opening.rad, eta.prec()).thickness.into()
    }

    /// Tells whether a drawing can have these sizes: from a millimetre to a thousand kilometres, and forces
    /// that doubles hold.
    pub(super) fn can_be_drawn(&self) -> bool {
        let forces = self.loads.iter().map(|loads| loads.weight.double());
        let lengths = [&self.radius, &self.thickness].map(Size::double);
        let is_bounded = [&self.radius, &self.thickness].iter().all(|x| x.value.is_bounded());
        is_bounded
            && (1e-3..=1e6).contains(&lengths[0])
            && forces.into_iter().all(|force| (1e-30..=1e30).contains(&force))
    }
}
