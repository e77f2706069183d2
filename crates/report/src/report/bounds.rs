//! A value and its bounds, as an object.

use super::fields::Fields;
use crate::certify::state::Figure;
use crate::number::Rounded;

/// A value and its bounds.
pub(crate) fn bounds(figure: &Figure) -> Fields {
    of_rounded(&figure.decimal)
}

/// The same of a decimal.
pub(crate) fn of_rounded(decimal: &Rounded) -> Fields {
    let mut fields = Fields::default();
    fields.add("value", decimal.value.to_string());
    fields.add("lower", decimal.lower.to_string());
    fields.add("upper", decimal.upper.to_string());
    fields
}
