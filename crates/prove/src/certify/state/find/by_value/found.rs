//! States with a value, and what is proved of them.

use crate::certify::state::state::Fall;
use crate::problem::{Mode, Quantity};
use crate::prover::{Absence, Figure, Undecided};

/// All states with a value.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct StatesOfValue {
    /// The states, by their half opening, or why one that is sought stays open.
    pub states: Vec<Result<StateOfValue, Undecided>>,
    /// Half openings that have the value with unlimited friction, and another state with this one.
    pub others: Vec<Result<OtherState, Undecided>>,
    /// Proof that there is no state at all.
    pub none: Option<Absence>,
    /// Statement that is proved besides: why there are no others.
    pub proved: &'static str,
}

/// A state with the value that was asked for.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct StateOfValue {
    /// Mode of its collapse.
    pub mode: Mode,
    /// Figures of the state, in the order of [`VALUES`](Self::VALUES).
    pub values: Vec<(Quantity, Figure)>,
}

/// A half opening whose purely rotational state has the value, but needs more friction.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct OtherState {
    /// The half opening, rad.
    pub half_opening: Figure,
    /// Mode of its state with the friction given, or why it falls.
    pub mode: Result<Mode, Fall>,
}

impl StateOfValue {
    /// Quantities of the states that are found, those that a state has.
    pub const VALUES: [Quantity; 8] = [
        Quantity::HalfOpening,
        Quantity::HalfOpeningDegrees,
        Quantity::OpeningVariable,
        Quantity::Thickness,
        Quantity::Thrust,
        Quantity::IntrinsicThrust,
        Quantity::RotationJoint,
        Quantity::SlidingJoint,
    ];

    /// Digits of a quantity; empty where the state has none.
    pub fn value(&self, quantity: Quantity) -> String {
        let found = self.values.iter().find(|(of, _)| *of == quantity);
        found.map_or(String::new(), |(_, figure)| figure.to_string())
    }
}

impl StatesOfValue {
    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<&Undecided> {
        let states = self.states.iter().find_map(|of| of.as_ref().err());
        states.or_else(|| self.others.iter().find_map(|of| of.as_ref().err()))
    }

    /// States in the order of their half openings.
    pub(super) fn sorted(mut self) -> Self {
        let opening = |of: &Result<StateOfValue, Undecided>| {
            let values = of.as_ref().ok().and_then(|state| state.values.first());
            values.map_or(f64::INFINITY, |(_, figure)| figure.double)
        };
        self.states.sort_by(|a, b| opening(a).total_cmp(&opening(b)));
        self
    }
}
