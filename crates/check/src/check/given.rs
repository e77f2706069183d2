//! Exact numbers as a certificate gives them: `49/20`, `1/2 pi`, `2 atan 3/5`; a friction also as `tan 7/36
//! pi` or `inf`.

use crate::number::{ExactNumber, Form};
use crate::problem::Friction;

/// Decimal digits of an integer that is given.
const MAX_GIVEN: usize = 100_000;
/// Text behind a factor of pi, and before a tangent.
const PI: &str = " pi";
const ARCTANGENT: &str = "2 atan ";

/// `49/20`, `49/20 pi`, or `2 atan 49/20`; the text itself of another angle, of which there is no certificate.
pub(super) fn given_text(x: &ExactNumber) -> String {
    let (numerator, denominator) = (x.factor().numer(), x.factor().denom());
    match x.form() {
        Form::Rational => format!("{numerator}/{denominator}"),
        Form::TimesPi => format!("{numerator}/{denominator}{PI}"),
        Form::TwiceArctangent => format!("{ARCTANGENT}{numerator}/{denominator}"),
        Form::ArctangentOfRoot => x.to_string(),
    }
}

/// A coefficient in that form, `tan` before an angle in that form, or `inf`.
pub(super) fn friction_text(friction: &Friction) -> String {
    match friction {
        Friction::Coefficient(mu) => given_text(mu),
        Friction::Angle(phi) => format!("tan {}", given_text(phi)),
        Friction::Infinite => "inf".to_owned(),
    }
}

/// Reads a number: two integers in decimal digits, the second above zero, in one of the three forms.
pub(super) fn read_given(text: &str) -> Option<ExactNumber> {
    let (quotient, form) = match (text.strip_suffix(PI), text.strip_prefix(ARCTANGENT)) {
        (Some(quotient), _) => (quotient, Form::TimesPi),
        (None, Some(quotient)) => (quotient, Form::TwiceArctangent),
        (None, None) => (text, Form::Rational),
    };
    let (numerator, denominator) = quotient.split_once('/')?;
    let is_integer = |text: &str| {
        (1..=MAX_GIVEN).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit())
    };
    if !is_integer(numerator) || !is_integer(denominator) {
        return None;
    }
    ExactNumber::fraction(numerator.parse().ok()?, denominator.parse().ok()?, form)
}

/// Reads a friction.
pub(super) fn read_friction(text: &str) -> Option<Friction> {
    match (text, text.strip_prefix("tan ")) {
        ("inf", _) => Some(Friction::Infinite),
        // A right angle is written as `inf`.
        (_, Some(angle)) => {
            read_given(angle).map(Friction::Angle).filter(|friction| !friction.is_of_right_angle())
        }
        _ => read_given(text).map(Friction::Coefficient),
    }
}
