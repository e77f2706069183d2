//! The last size and the last digit that are allowed are accepted, the next ones refused.

use couplet_check::check::{EXTRA_BITS, Refusal, WITNESS_BITS, check};
use couplet_number::number::AstroInterval;
use rug::Integer;
use serde_json::Value;

/// A landmark of 100 digits.
fn landmark() -> Value {
    let bytes = include_bytes!("../../../proofs/constants/triple-point-heyman.json");
    serde_json::from_slice(bytes).unwrap()
}

/// An arch that stands.
fn standing() -> Value {
    let bytes = include_bytes!("../../../proofs/surveys/all-stand.json");
    let survey: Value = serde_json::from_slice(bytes).unwrap();
    survey["parts"][0]["certificate"].clone()
}

fn verdict(certificate: &Value, max_digits: usize) -> Result<usize, Refusal> {
    check::<AstroInterval>(certificate.to_string().as_bytes(), max_digits)
        .map(|accepted| accepted.digits)
}

/// The certificate with zeros behind the number at a place, so that it has this many bits.
fn longer(certificate: &Value, whole: &str, bits: usize) -> Value {
    let mut copy = certificate.clone();
    let here = copy.pointer_mut(whole).unwrap();
    let (mantissa, exponent) = here.as_str().unwrap().split_once('p').unwrap();
    let (sign, digits) = mantissa.split_once("0x").unwrap();
    let size = Integer::from_str_radix(digits, 16).unwrap();
    let zeros = bits - size.significant_bits() as usize;
    let exponent = exponent.parse::<i64>().unwrap() - zeros as i64;
    *here = format!("{sign}0x{:x}p{exponent}", size << zeros).into();
    copy
}

#[test]
fn the_last_bit_that_is_allowed_is_accepted_and_the_next_refused() {
    for (certificate, whole, place, bits) in [
        (landmark(), "/inverse/2/3", "inverse", EXTRA_BITS),
        (landmark(), "/unique/radius/1", "unique", WITNESS_BITS),
        (landmark(), "/unique/centre/1", "unique", EXTRA_BITS),
        (landmark(), "/root/radius/4", "root", WITNESS_BITS),
        (landmark(), "/root/centre/4", "root", 333 + EXTRA_BITS),
        (standing(), "/claim/stands/thrust", "claim", EXTRA_BITS),
        (standing(), "/claim/stands/crown_moment", "claim", EXTRA_BITS),
    ] {
        assert!(verdict(&longer(&certificate, whole, bits), 100).is_ok(), "{whole}");
        let refusal = verdict(&longer(&certificate, whole, bits + 1), 100);
        assert_eq!(refusal, Err(Refusal::Large { place, bits }), "{whole}");
    }
}

#[test]
fn the_last_digit_that_is_allowed_is_accepted_and_the_next_refused() {
    let certificate = landmark();
    assert_eq!(verdict(&certificate, 100), Ok(100));
    assert_eq!(verdict(&certificate, 99), Err(Refusal::Limit(100, 99)));
}
