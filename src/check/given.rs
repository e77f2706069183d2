//! How a certificate gives a number exactly: `49/20`, `1/2 pi`; a friction also as `tan 7/36 pi` or `inf`.

use crate::number::ExactNumber;
use crate::problem::Friction;

/// Decimal digits of an integer that is given.
const MAX_GIVEN: usize = 100_000;

/// `49/20`, or `49/20 pi`.
pub(crate) fn given_text(x: &ExactNumber) -> String {
    let pi = if x.is_rational() { "" } else { " pi" };
    format!("{}/{}{pi}", x.factor().numer(), x.factor().denom())
}

/// A coefficient in that form, `tan` before an angle in that form, or `inf`.
pub(crate) fn friction_text(friction: &Friction) -> String {
    match friction {
        Friction::Coefficient(mu) => given_text(mu),
        Friction::Angle(phi) => format!("tan {}", given_text(phi)),
        Friction::Infinite => "inf".to_owned(),
    }
}

/// Reads a number: two integers in decimal digits, the second above zero, with or without pi.
pub(super) fn read_given(text: &str) -> Option<ExactNumber> {
    let (quotient, times_pi) = match text.strip_suffix(" pi") {
        Some(quotient) => (quotient, true),
        None => (text, false),
    };
    let (numerator, denominator) = quotient.split_once('/')?;
    let is_integer = |text: &str| {
        (1..=MAX_GIVEN).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit())
    };
    if !is_integer(numerator) || !is_integer(denominator) {
        return None;
    }
    ExactNumber::fraction(numerator.parse().ok()?, denominator.parse().ok()?, times_pi)
}

/// Reads a friction.
pub(super) fn read_friction(text: &str) -> Option<Friction> {
    match (text, text.strip_prefix("tan ")) {
        ("inf", _) => Some(Friction::Infinite),
        (_, Some(angle)) => read_given(angle).map(Friction::Angle),
        _ => read_given(text).map(Friction::Coefficient),
    }
}
