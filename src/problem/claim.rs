//! What a certificate claims: which equations have a root, and what is given.

use super::condition::conditions;
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::number::{Angle, Dual, Enclosure, Engine, Field, Ternary, integer_text};
use crate::problem::{Equation, Fixed, Landmark, Mode, Point, System};

/// A claim about one root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// What the root is.
    pub subject: Subject,
}

/// What the root is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A landmark point.
    Landmark(Landmark),
    /// The state of an arch at its least thickness.
    State(State),
}

/// An arch and how it collapses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct State {
    /// How it collapses.
    pub mode: Mode,
    /// The half opening, rad.
    pub half_opening: Exact,
    /// The friction coefficient; `None` if it is unlimited.
    pub friction: Option<Exact>,
}

/// `numerator/denominator`, or that times pi.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exact {
    /// Decimal digits, with a sign or without.
    pub numerator: String,
    /// Decimal digits, not all zero.
    pub denominator: String,
    /// Whether pi is a factor.
    pub times_pi: bool,
}

impl Claim {
    /// What is solved for, in order.
    pub fn unknowns(&self) -> &'static [Unknown] {
        match &self.subject {
            Subject::Landmark(landmark) => landmark.system(self.weight).unknowns,
            Subject::State(state) => state.mode.system().0,
        }
    }

    /// What holds, in order.
    pub fn equations(&self) -> &'static [Equation] {
        match &self.subject {
            Subject::Landmark(landmark) => landmark.system(self.weight).equations,
            Subject::State(state) => state.mode.system().1,
        }
    }

    /// What is known of a variable beforehand.
    pub fn fixed(&self, unknown: Unknown) -> Option<Fixed> {
        match &self.subject {
            Subject::Landmark(landmark) => landmark.system(self.weight).fixed_value(unknown),
            Subject::State(state) => match (state.mode, unknown) {
                (Mode::OverturningSliding | Mode::Overturning, Unknown::RotationJoint)
                | (Mode::Overturning, Unknown::Thrust) => Some(Fixed::Integer(0)),
                _ => None,
            },
        }
    }

    /// The system of a landmark.
    fn system(&self) -> Option<System> {
        match &self.subject {
            Subject::Landmark(landmark) => Some(landmark.system(self.weight)),
            Subject::State(_) => None,
        }
    }

    /// All variables where the unknowns have the values given.
    pub fn configuration<E: Engine>(&self, values: &[E]) -> Configuration<E> {
        match (&self.subject, self.system()) {
            (Subject::State(state), _) => self
                .unknowns()
                .iter()
                .zip(values)
                .fold(state.given(&values[0]), |at, (&unknown, x)| at.with(unknown, x.clone())),
            (_, Some(system)) => system.configuration(&Point::new(&system, values)),
            (Subject::Landmark(_), None) => Configuration::zero(&values[0]),
        }
    }

    /// The same with every unknown a variable of dual numbers.
    pub fn variables<E: Engine>(&self, values: &[E]) -> Configuration<Dual<E>> {
        let at = self.configuration(values).map(Dual::constant);
        let unknowns = self.unknowns().iter().zip(values).enumerate();
        let same = |unknown| match self.fixed(unknown) {
            Some(Fixed::SameAs(other)) => other,
            _ => unknown,
        };
        unknowns.fold(at, |mut at, (index, (&unknown, x))| {
            let angle = |angle: &Angle<Dual<E>>| {
                angle.clone().map(|part| part.value().clone()).variable(index)
            };
            let number = || Dual::variable(x.clone(), index);
            match unknown {
                Unknown::HalfOpening => at.half_opening = angle(&at.half_opening),
                Unknown::RotationJoint => at.rotation_joint = angle(&at.rotation_joint),
                Unknown::SlidingJoint => at.sliding_joint = angle(&at.sliding_joint),
                Unknown::Thickness => at.thickness = number(),
                Unknown::Thrust => at.thrust = number(),
                Unknown::Friction => at.friction = number(),
            }
            if same(Unknown::RotationJoint) == unknown {
                at.rotation_joint = angle(&at.rotation_joint);
            }
            at
        })
    }

    /// The residuals of the equations.
    pub fn residuals<T: Field>(&self, at: &Configuration<T>) -> Vec<T> {
        self.equations().iter().map(|equation| equation.residual(self.weight, at)).collect()
    }

    /// The denominators that the residuals have cleared.
    pub fn denominators<T: Field>(&self, at: &Configuration<T>) -> Vec<T> {
        self.equations()
            .iter()
            .filter_map(|equation| equation.denominator(self.weight, at))
            .collect()
    }

    /// What has to be positive besides: the physical range and, for a state, its admissibility, that
    /// no thinner arch stands, and what tells its mode from others.
    pub fn margins<E: Engine>(&self, at: &Configuration<E>) -> Vec<(E, &'static str)> {
        let mut margins = Vec::new();
        let pi = at.half_opening.rad.pi();
        margins.push((at.half_opening.rad.clone(), "a positive half opening"));
        margins.push((pi - &at.half_opening.rad, "a half opening below pi"));
        match &self.subject {
            Subject::Landmark(_) => {
                for &unknown in self.unknowns() {
                    margins.extend(range(unknown, at));
                }
            }
            Subject::State(state) => {
                let friction = state.friction.as_ref().map(|_| &at.friction);
                margins.extend(conditions(self.weight, state.mode, at, friction));
                margins.extend(order(state.mode, at));
            }
        }
        margins
    }
}

/// The physical range of an unknown.
fn range<E: Enclosure>(unknown: Unknown, at: &Configuration<E>) -> Vec<(E, &'static str)> {
    let alpha = &at.half_opening.rad;
    let between = |x: &E, top: E| {
        vec![(x.clone(), "an unknown above zero"), (top - x, "an unknown below its largest value")]
    };
    match unknown {
        Unknown::HalfOpening => Vec::new(),
        Unknown::RotationJoint => between(&at.rotation_joint.rad, alpha.clone()),
        Unknown::SlidingJoint => between(&at.sliding_joint.rad, alpha.clone()),
        Unknown::Thickness => between(&at.thickness, alpha.int(2)),
        Unknown::Thrust => between(&at.thrust, alpha.int(1)),
        Unknown::Friction => vec![(at.friction.clone(), "a positive friction")],
    }
}

/// Which of the two inner joints is higher.
fn order<E: Enclosure>(mode: Mode, at: &Configuration<E>) -> Option<(E, &'static str)> {
    let above = at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
    match mode {
        Mode::RotationalSliding => Some((above, "a sliding joint nearer to the crown")),
        Mode::RotationalSlidingRotational => {
            Some((-above, "a rotational joint nearer to the crown"))
        }
        _ => None,
    }
}

impl State {
    /// The configuration with what is given; everything else zero.
    fn given<E: Engine>(&self, like: &E) -> Configuration<E> {
        let at =
            Configuration::zero(like).with(Unknown::HalfOpening, self.half_opening.enclosure(like));
        match &self.friction {
            Some(friction) => at.with(Unknown::Friction, friction.enclosure(like)),
            None => at,
        }
    }
}

impl Exact {
    fn enclosure<E: Engine>(&self, like: &E) -> E {
        let quotient = integer_text(&self.numerator, like) / integer_text(&self.denominator, like);
        if self.times_pi { quotient * like.pi() } else { quotient }
    }
}

/// Whether all margins are positive, or the first that is not.
pub fn first_failure<E: Enclosure>(margins: &[(E, &'static str)]) -> Option<&'static str> {
    margins.iter().find(|(x, _)| x.is_positive() != Ternary::True).map(|(_, words)| *words)
}
