//! Notes on a question that is answered as it is asked but may have been meant otherwise.

use crate::number::ExactNumber;
use crate::problem::{Friction, Slope};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::collections::HashSet;

/// A coefficient above this, an angle of 76 degrees, may have been meant as an angle.
const LARGE_FRICTION: i32 = 4;
/// An acceleration above that of gravity may have been.
const LARGE_TILT: i32 = 1;

/// Note on each friction that may have been meant as an angle.
pub fn notes<'a>(frictions: impl IntoIterator<Item = &'a Friction>) -> Vec<String> {
    let mut said = HashSet::new();
    let large = frictions.into_iter().filter_map(|friction| large(friction, LARGE_FRICTION));
    let large = large.filter(|mu| said.insert(mu.to_string()));
    large.map(|mu| format!("the friction {mu} is a coefficient; {}", angle(mu))).collect()
}

/// Note on an acceleration that may have been meant as an angle.
pub fn tilt_note(tilt: &Slope) -> Option<String> {
    let k = large(tilt, LARGE_TILT)?;
    Some(format!("the tilt {k} is {k} times gravity; {}", angle(k)))
}

/// Note on frictions of an array, if any of them may have been meant as an angle.
pub fn array_note(frictions: &[f64]) -> Option<&'static str> {
    let is_large = |mu: &f64| mu.is_finite() && *mu > f64::from(LARGE_FRICTION);
    let note = "frictions above 4 are coefficients; that of an angle is its tangent";
    frictions.iter().any(is_large).then_some(note)
}

fn large(friction: &Friction, limit: i32) -> Option<&ExactNumber> {
    match friction {
        Friction::Coefficient(x)
            if x.is_rational() && *x.factor() > BigRational::from(BigInt::from(limit)) =>
        {
            Some(x)
        }
        _ => None,
    }
}

/// Spelling of a number as an angle; or any angle, where the number is none.
fn angle(x: &ExactNumber) -> String {
    match *x.factor() < BigRational::from(BigInt::from(90)) {
        true => format!("an angle of {x} degrees is written {x}deg"),
        false => "an angle is written with its unit, 31deg".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_large_numbers_without_a_unit_are_remarked_on() {
        let of = |text: &str| notes([&text.parse().unwrap()]);
        assert_eq!(
            of("15"),
            ["the friction 15 is a coefficient; an angle of 15 degrees is written 15deg"]
        );
        assert!(!of("4.1").is_empty());
        for text in ["4", "inf", "15deg", "tan(80deg)", "0.6", "1.5rad"] {
            assert!(of(text).is_empty(), "{text}");
        }
        assert!(!of("120")[0].contains("120deg"));
        assert!(tilt_note(&"9/8".parse().unwrap()).is_some());
        for text in ["1", "5deg"] {
            assert_eq!(tilt_note(&text.parse().unwrap()), None, "{text}");
        }
        let mu: Friction = "31".parse().unwrap();
        assert_eq!(notes([&mu, &mu]).len(), 1);
    }

    #[test]
    fn arrays_have_one_note() {
        assert!(array_note(&[0.6, 31.0, f64::INFINITY]).unwrap().contains("above 4"));
        assert_eq!(array_note(&[0.6, 4.0, f64::INFINITY, f64::NAN]), None);
    }
}
