//! Notes, on standard error, of a question that is answered as it is asked but may have been meant otherwise.

use super::described::say;
use crate::number::ExactNumber;
use crate::problem::{Friction, Slope};
use num_rational::BigRational;
use std::collections::HashSet;
use std::hash::Hash;

/// A coefficient above this, an angle of 76 degrees, may have been meant as an angle.
const LARGE_FRICTION: i32 = 4;
/// An acceleration above that of gravity may have been.
const LARGE_TILT: i32 = 1;

/// Coefficients that may have been meant as angles.
pub(super) fn frictions<'a>(all: impl IntoIterator<Item = &'a Friction>) {
    let mut said = HashSet::new();
    let large = all.into_iter().filter_map(|friction| large(friction, LARGE_FRICTION));
    for mu in large.filter(|mu| said.insert(mu.to_string())) {
        say(&format!("couplet: the friction {mu} is a coefficient; {}", angle(mu)));
    }
}

/// An acceleration that may have been meant as an angle.
pub(super) fn tilt(tilt: &Slope) {
    if let Some(k) = large(tilt, LARGE_TILT) {
        say(&format!("couplet: the tilt {k} is {k} times gravity; {}", angle(k)));
    }
}

fn large(friction: &Friction, limit: i32) -> Option<&ExactNumber> {
    let limit = BigRational::from(num_bigint::BigInt::from(limit));
    match friction {
        Friction::Coefficient(x) if x.is_rational() && *x.factor() > limit => Some(x),
        _ => None,
    }
}

/// Spelling of a number as an angle; or any angle, where the number is none.
fn angle(x: &ExactNumber) -> String {
    let right = BigRational::from(num_bigint::BigInt::from(90));
    match *x.factor() < right {
        true => format!("an angle of {x} degrees is written {x}deg"),
        false => "an angle is written with its unit, 31deg".to_owned(),
    }
}

/// The values, each once; of one that is given twice that is told.
pub(super) fn each_once<T, K: Eq + Hash>(
    given: impl IntoIterator<Item = T>,
    key: impl Fn(&T) -> K,
    shown: impl Fn(&T) -> String,
) -> Vec<T> {
    let mut seen = HashSet::new();
    let is_first = |one: &T| {
        let is_first = seen.insert(key(one));
        if !is_first {
            say(&format!("couplet: {} is given twice and counts once", shown(one)));
        }
        is_first
    };
    given.into_iter().filter(is_first).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_large_numbers_without_a_unit_are_remarked_on() {
        let is = |text: &str, limit| large(&text.parse().unwrap(), limit).is_some();
        assert!(is("15", LARGE_FRICTION) && is("4.1", LARGE_FRICTION) && is("9/8", LARGE_TILT));
        for text in ["4", "inf", "15deg", "tan(80deg)", "0.6", "1.5rad"] {
            assert!(!is(text, LARGE_FRICTION), "{text}");
        }
        assert!(angle(&"15".parse().unwrap()).ends_with("15deg"));
        assert!(!angle(&"120".parse().unwrap()).contains("120"));
    }
}
