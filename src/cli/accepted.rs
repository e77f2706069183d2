//! What was accepted, in a few words: shortened, and true.

use crate::check::{Accepted, given_text};
use crate::problem::{Friction, Problem};

/// What was accepted, in a few words.
pub(super) fn summary(accepted: &Accepted) -> String {
    let subject = match &accepted.problem {
        Problem::Landmark { landmark, .. } => landmark.symbol().to_owned(),
        Problem::State { mode, arch } => {
            let friction = match arch.friction() {
                Friction::Coefficient(mu) => shortened_fraction(&given_text(mu)),
                friction => friction.to_string(),
            };
            let half_opening = shortened_fraction(&given_text(arch.half_opening()));
            format!("{mode} half_opening {half_opening} friction {friction}")
        }
    };
    let first = accepted.values.first().map_or(String::new(), |(quantity, value)| {
        format!("{} {} ", quantity.name(), shortened_value(value))
    });
    let plural = if accepted.digits == 1 { "" } else { "s" };
    format!(
        "{subject} {}  {first}to {} digit{plural}",
        accepted.problem.weight().name(),
        accepted.digits
    )
}

/// Characters of a number that are shown.
const SHOWN: usize = 22;

/// A value with the first of its digits and its power of ten.
fn shortened_value(value: &str) -> String {
    let power = value.find('e').unwrap_or(value.len());
    match value[..power].get(..SHOWN) {
        Some(first) if power > SHOWN => format!("{first}…{}", &value[power..]),
        _ => value.to_owned(),
    }
}

/// A fraction with the first digits of its integers, and how many they have.
fn shortened_fraction(text: &str) -> String {
    let (numerator, rest) = text.split_once('/').unwrap_or((text, ""));
    let (denominator, pi) = rest.split_once(' ').unwrap_or((rest, ""));
    let integer = |digits: &str| match digits.get(..SHOWN) {
        Some(first) if digits.len() > SHOWN => format!("{first}…({} digits)", digits.len()),
        _ => digits.to_owned(),
    };
    let pi = if pi.is_empty() { String::new() } else { format!(" {pi}") };
    format!("{}/{}{pi}", integer(numerator), integer(denominator))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_cut_keeps_its_size() {
        let long = "2.08333312500004398147e-14";
        assert_eq!(shortened_value(long), long);
        let longer = "2.083333125000043981479166e-14";
        assert_eq!(shortened_value(longer), "2.08333312500004398147…e-14");
        assert_eq!(shortened_value("0.0640"), "0.0640");
        assert_eq!(shortened_value("0"), "0");
        assert_eq!(shortened_value(&format!("0.{}", "3".repeat(30))), "0.33333333333333333333…");
    }

    #[test]
    fn what_is_cut_from_a_fraction_is_counted() {
        assert_eq!(shortened_fraction("49/20"), "49/20");
        assert_eq!(shortened_fraction("1/2 pi"), "1/2 pi");
        let long = format!("{}/{} pi", "7".repeat(30), "9".repeat(22));
        let shown = format!("{}…(30 digits)/{} pi", "7".repeat(22), "9".repeat(22));
        assert_eq!(shortened_fraction(&long), shown);
    }
}
