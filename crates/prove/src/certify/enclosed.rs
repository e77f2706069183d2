//! A landmark in enclosures of some bits, which knows of what it is.

use super::closed_value::{Exact, exact};
use super::constant::{Constant, Value, quantities};

use crate::arch::{Configuration, SelfWeight, Unknown, thrust};
use crate::number::{Ball, Binary, Real, Rounded, degrees};
use crate::problem::{Landmark, Quantity};
use crate::prover::Isolated;
use crate::prover::refine::Refined;
use rayon::prelude::*;
use std::sync::Arc;

/// A landmark whose variables are enclosed; [`CertifiedLandmark::enclosure`](super::CertifiedLandmark::enclosure)
/// makes them.
///
/// ```
/// use couplet_number::number::Enclosure;
/// use couplet_prove::prelude::*;
/// let triple = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Heyman)?.enclosure(256)?;
/// let thickness = triple.quantity(Quantity::Thickness).unwrap();
/// assert_eq!((triple.landmark(), thickness.mid().to_f64()), (Landmark::Triple, 0.6796047320988855));
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Enclosed {
    landmark: Landmark,
    isolated: Arc<Isolated>,
    refined: Refined,
}

impl Enclosed {
    pub(super) fn new(landmark: Landmark, isolated: Isolated, refined: Refined) -> Self {
        Self { landmark, isolated: Arc::new(isolated), refined }
    }

    /// Landmark in other enclosures of its root.
    pub(super) fn narrowed(&self, refined: Refined) -> Self {
        Self { isolated: self.isolated.clone(), refined, ..*self }
    }

    /// The landmark.
    pub fn landmark(&self) -> Landmark {
        self.landmark
    }

    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        self.isolated.system().weight
    }

    /// The system and the box in which its root is unique.
    pub fn isolated(&self) -> &Isolated {
        &self.isolated
    }

    /// The exact value of a quantity, where it has one.
    pub fn exact(&self, quantity: Quantity) -> Option<Exact> {
        exact(self.landmark, &self.isolated, quantity)
    }

    /// An enclosure of a variable; `None` where the landmark does not have it or it is infinite.
    pub fn value(&self, unknown: Unknown) -> Option<Ball> {
        self.refined.value(unknown)
    }

    /// An enclosure of `phi = atan(mu)`; `None` where there is no finite friction.
    pub fn friction_angle(&self) -> Option<Ball> {
        self.refined.friction_angle()
    }

    /// Enclosures of all variables, angles with sine and cosine.
    pub fn configuration(&self) -> &Configuration<Ball> {
        self.refined.configuration()
    }

    /// An enclosure of a quantity; `None` where it does not exist or is infinite.
    pub fn quantity(&self, quantity: Quantity) -> Option<Ball> {
        if let Some(angle) = quantity.in_radians() {
            return Some(degrees(&self.quantity(angle)?));
        }
        if let Some(Exact::Pi(factor)) = self.exact(quantity) {
            let pi = self.value(Unknown::HalfOpening)?.pi();
            return Some(Ball::enclosing(&factor, pi.prec()) * pi);
        }
        match quantity {
            Quantity::FrictionAngle => self.friction_angle(),
            Quantity::IntrinsicThrust => {
                Some(self.value(Unknown::Thickness)? * self.value(Unknown::Thrust)?)
            }
            Quantity::OpeningVariable => {
                Some(thrust::opening_variable(&self.configuration().half_opening).value())
            }
            _ => self.value(quantity.variable()?),
        }
    }

    /// All quantities of the landmark; `None` if a rounding stays open.
    pub(super) fn constants(&self, digits: usize) -> Option<Vec<Constant>> {
        let all: Vec<Quantity> = quantities(self.landmark).collect();
        all.into_par_iter().map(|quantity| self.rounded(quantity, digits)).collect()
    }

    /// The value rounded to digits and to a double, if the enclosure decides both.
    pub(super) fn rounded(&self, quantity: Quantity, digits: usize) -> Option<Constant> {
        let prec = || self.value(Unknown::HalfOpening).map(|x| x.prec());
        let exact = self.exact(quantity);
        let finite = |ball: Ball, rounded: Option<Rounded>| {
            let (double, binary) = Binary::nearest(&ball)?;
            Some((Value::Finite(rounded?), double, binary))
        };
        let from_ball = |ball: Ball| {
            let rounded = Rounded::from_ball(&ball, digits);
            finite(ball, rounded)
        };
        let (value, double, binary) = match &exact {
            Some(Exact::Infinite) => (Value::Infinite, f64::INFINITY, Binary::infinite()),
            Some(Exact::Surd(surd)) => match surd.parts() {
                (rational, factor, _) if factor.is_zero() => finite(
                    Ball::enclosing(rational, prec()?),
                    Rounded::from_rational(rational, digits),
                )?,
                _ => from_ball(surd.enclosure(prec()?))?,
            },
            Some(Exact::Pi(_)) | None => from_ball(self.quantity(quantity)?)?,
        };
        let exact = exact.map(|exact| exact.text());
        let (weight, landmark) = (self.weight(), self.landmark);
        Some(Constant { weight, landmark, quantity, value, exact, double, binary })
    }
}
