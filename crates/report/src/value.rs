//! A proved value, as every format takes it.

use crate::certify::state::Figure;
use crate::certify::{self, Constant};
use crate::judge::published::PRINTED;
use crate::number::{Binary, Rounded};
use std::fmt::Display;

/// One proved value.
#[derive(Clone, Debug)]
pub struct Value {
    /// The true value correctly rounded; `None` for infinity.
    pub decimal: Option<Rounded>,
    /// The nearest double of the true value.
    pub double: f64,
    /// Bounds of what that double leaves open.
    pub binary: Binary,
    /// The exact value, where there is one.
    pub exact: Option<String>,
    /// Texts that the paper prints for the value, each text once. Not proved.
    pub printed: Vec<&'static str>,
    /// Limit of a thrust.
    pub limited_by: Option<&'static str>,
}

impl Value {
    /// The value as text.
    pub fn text(&self) -> String {
        self.decimal.as_ref().map_or("inf".into(), |decimal| decimal.value.to_string())
    }

    /// The value, its lower and its upper bound as they are written; all `inf` for infinity.
    pub fn texts(&self) -> [&dyn Display; 3] {
        match &self.decimal {
            Some(decimal) => [&decimal.value, &decimal.lower, &decimal.upper],
            None => [&"inf"; 3],
        }
    }

    /// The exact value where it says more than the digits.
    pub fn closed_form(&self) -> Option<&str> {
        self.exact.as_deref().filter(|exact| *exact != self.text())
    }

    /// The nearest quadruple with the 36 digits that tell every one from its neighbours; `None` where it
    /// is not known.
    pub fn quad(&self) -> Option<String> {
        let digits = |quad: &rug::Float| quad.to_string_radix(10, Some(36));
        self.binary.quad.as_ref().map(digits)
    }

    /// The value of a constant, beside what the paper prints for it.
    pub fn constant(constant: Constant) -> Self {
        let Constant { landmark, weight, quantity, value, exact, double, binary, .. } = constant;
        let mut printed: Vec<&str> = PRINTED
            .iter()
            .filter(|p| (p.landmark, p.weight, p.quantity) == (landmark, weight, quantity))
            .map(|p| p.text)
            .collect();
        printed.sort_unstable();
        printed.dedup();
        let decimal = match value {
            certify::Value::Finite(decimal) => Some(decimal),
            certify::Value::Infinite => None,
        };
        Self { decimal, double, binary, exact, printed, limited_by: None }
    }

    /// A figure, or infinity where no number is enough.
    pub fn figure(figure: Option<&Figure>) -> Self {
        figure.cloned().into()
    }
}

impl From<Option<Figure>> for Value {
    fn from(figure: Option<Figure>) -> Self {
        let (decimal, double, binary, exact) = match figure {
            Some(Figure { decimal, double, binary, .. }) => (Some(decimal), double, binary, None),
            None => (None, f64::INFINITY, Binary::infinite(), Some("inf".into())),
        };
        Self { decimal, double, binary, exact, printed: Vec::new(), limited_by: None }
    }
}
