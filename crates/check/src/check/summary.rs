//! Summary of what was accepted, in a few words: shortened, and true.

use super::checker::Accepted;
use super::given::{friction_text, given_text};
use crate::problem::asymmetric_region::STANDS;
use crate::problem::{Arch, Problem, Quantity, Verdict};

/// Summary of what was accepted, in a few words: the end of the line that `couplet check` gives a file.
pub fn summary(accepted: &Accepted) -> String {
    let thick = |thickness| format!(" thickness {}", shortened_fraction(&given_text(thickness)));
    // What is given is compared with the value of the same quantity, and with no other.
    let (subject, limit) = match &accepted.problem {
        Problem::Landmark { landmark, .. } => (landmark.symbol().to_owned(), None),
        Problem::State { mode, arch } => {
            (format!("{mode} {}", described(arch)), Some((Quantity::Thickness, "")))
        }
        Problem::Asymmetric { mode, arch } => {
            (format!("asymmetric solution of (19), {mode}, {}", described(arch)), None)
        }
        Problem::Verdict { verdict, arch } => {
            let arch = described(arch);
            match verdict {
                Verdict::Slides => {
                    let limit = (Quantity::Friction, "as it is below the limit, ");
                    (format!("stands at no thickness {arch}"), Some(limit))
                }
                Verdict::TooWide => {
                    let limit = (Quantity::HalfOpening, "as it is beyond the limit, ");
                    (format!("stands at no thickness {arch}"), Some(limit))
                }
                Verdict::TooThin { mode, thickness } => {
                    let thick = thick(thickness);
                    let limit = (Quantity::Thickness, "as it is below the limit, ");
                    (format!("does not stand {arch}{thick}; at the least {mode}"), Some(limit))
                }
                Verdict::Stands(standing) => {
                    (format!("stands ({STANDS}) {arch}{}", thick(&standing.thickness)), None)
                }
            }
        }
    };
    let weight = accepted.problem.weight().name();
    let of_limit = |of: Quantity| accepted.values.iter().find(|(quantity, _)| *quantity == of);
    let limit = limit.and_then(|(of, relation)| Some((of_limit(of)?, relation)));
    let first = accepted.values.first().map(|first| (first, ""));
    let Some(((quantity, value), relation)) = limit.or(first) else {
        return format!("{subject} {weight}");
    };
    let value = shortened_value(value);
    let plural = if accepted.digits == 1 { "" } else { "s" };
    let digits = accepted.digits;
    let meaning = match (&accepted.problem, quantity) {
        (Problem::State { .. }, Quantity::Thickness) => format!("; stands from it on ({STANDS})"),
        _ => String::new(),
    };
    let name = quantity.name();
    format!("{subject} {weight}  {relation}{name} {value} to {digits} digit{plural}{meaning}")
}

/// Given numbers of an arch.
fn described(arch: &Arch) -> String {
    let half_opening = shortened_fraction(&given_text(arch.half_opening()));
    let friction = shortened_fraction(&friction_text(arch.friction()));
    format!("half_opening {half_opening} friction {friction}")
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

/// A text with the first digits of its integers, and how many they have.
pub(super) fn shortened_fraction(text: &str) -> String {
    let is_digit = |c: char| c.is_ascii_digit();
    let mut shown = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(is_digit) {
        let (before, number) = rest.split_at(start);
        let (digits, behind) =
            number.split_at(number.find(|c| !is_digit(c)).unwrap_or(number.len()));
        shown += before;
        shown += &match digits.get(..SHOWN) {
            Some(first) if digits.len() > SHOWN => format!("{first}…({} digits)", digits.len()),
            _ => digits.to_owned(),
        };
        rest = behind;
    }
    shown + rest
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
        assert_eq!(shortened_fraction("tan 1/2 pi"), "tan 1/2 pi");
        assert_eq!(shortened_fraction("inf"), "inf");
        let long = format!("{}/{} pi", "7".repeat(30), "9".repeat(22));
        let shown = format!("{}…(30 digits)/{} pi", "7".repeat(22), "9".repeat(22));
        assert_eq!(shortened_fraction(&long), shown);
    }
}
