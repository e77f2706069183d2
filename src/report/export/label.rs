//! What a quantity is called: in files, in words, and in a formula.

use crate::problem::Quantity;

/// The names of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// The name in files; an identifier in every language.
    pub name: &'static str,
    /// The symbol of the paper and the unit, as plain text.
    pub symbol: &'static str,
    /// The same for LaTeX.
    pub latex: &'static str,
}

const fn label(name: &'static str, symbol: &'static str, latex: &'static str) -> Label {
    Label { name, symbol, latex }
}

impl From<Quantity> for Label {
    fn from(quantity: Quantity) -> Self {
        label(quantity.name(), quantity.symbol(), quantity.latex())
    }
}
