//! Consequences for the values that the paper prints.

use super::names::symbol;
use super::numeral::{text, unit};
use super::template::fill;
use crate::certify::CertifiedLandmark;
use crate::judge::{Audited, PrintedVerdict};
use crate::number::Decimal;
use crate::problem::{Fixed, Quantity};
use rug::Rational;

/// One corollary for each printed value of the landmark that the theorem determines, where it is
/// printed first: the tables come before the text.
pub(super) fn corollaries(
    point: &CertifiedLandmark,
    audited: &[Audited],
    symbols: &[&str],
) -> String {
    let mut out = String::new();
    let mut seen = Vec::new();
    for value in audited {
        let printed = value.printed;
        let belongs = (printed.landmark, printed.weight) == (point.landmark(), point.weight());
        if !belongs || seen.contains(&(printed.quantity, printed.text)) {
            continue;
        }
        seen.push((printed.quantity, printed.text));
        let (Some(quantity), Some(half)) = (term(printed.quantity, point), half_unit(printed.text))
        else {
            continue;
        };
        let distance = format!("Rabs ({quantity} - {})", printed.text);
        let (relation, verdict) = match value.verdict {
            PrintedVerdict::CorrectlyRounded => (format!("{distance} <= {half}"), "right"),
            _ => (format!("{half} < {distance}"), "wrong"),
        };
        if out.is_empty() {
            out.push_str("\n(** ** The printed values\n\n");
            out.push_str(
                "    Is the last digit right, that is, the value the nearest of its length? *)\n",
            );
        }
        let values =
            [("name", name(value, verdict)), ("args", symbols.join(" ")), ("claim", relation)];
        out.push_str(&fill(include_str!("templates/printed.v"), &values));
    }
    out
}

fn name(value: &Audited, verdict: &str) -> String {
    let place = value.printed.place.to_lowercase().replace(". ", "_").replace([' ', '.'], "_");
    format!("{place}_{}_{verdict}", value.printed.quantity.name())
}

/// Half a unit of the last place of a decimal number; `None` for a fraction.
fn half_unit(printed: &str) -> Option<String> {
    let decimal: Decimal = printed.parse().ok()?;
    let places = u32::try_from(-decimal.exponent()).ok().filter(|&places| places > 0)?;
    Some(text(&(unit(places) / Rational::from(2))))
}

/// A quantity in the variables of the theorem; `None` if they do not determine it or it is given.
fn term(quantity: Quantity, point: &CertifiedLandmark) -> Option<String> {
    let system = point.isolated().system();
    let variable = quantity.variable()?;
    let unknown = match system.fixed_value(variable) {
        Some(Fixed::SameAs(other)) => other,
        Some(_) => return None,
        None => variable,
    };
    system.index(unknown)?;
    let variable = symbol(unknown);
    Some(match quantity {
        Quantity::OpeningVariable => format!("A {variable}"),
        Quantity::FrictionAngle => format!("atan {variable}"),
        Quantity::FrictionAngleDegrees => format!("180 / PI * atan {variable}"),
        Quantity::IntrinsicThrust => return None,
        _ if quantity.in_radians().is_some() => format!("180 / PI * {variable}"),
        _ => variable.into(),
    })
}
