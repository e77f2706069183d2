//! Boxes at the limit: how far the large box of a certificate can be widened until an arithmetic no longer shows that
//! it holds one root.

use crate::house::certificates;
use couplet::check::{AcceptedFile, Refusal, check_file};
use couplet::number::{AstroInterval, Ball, Dyadic};
use rug::Integer;
use rug::integer::Order;
use serde_json::Value;
use std::fs;

/// A box is widened by a multiple of `2^-SCALE`.
const SCALE: i32 = 10;
/// Box as it is.
const ONE: u64 = 1 << SCALE;

/// An arithmetic, by its check of a file.
type Check = fn(&[u8], usize) -> Result<AcceptedFile, Refusal>;

/// The certificates of landmarks and of states in `proofs`.
fn stored() -> Vec<Value> {
    let read = |path| serde_json::from_slice(&fs::read(path).unwrap()).unwrap();
    let all: Vec<Value> = certificates(["constants", "states"]).into_iter().map(read).collect();
    assert!(all.len() > 25);
    all
}

/// The certificate with the radii of its large box times `factor 2^-SCALE`.
fn widened(certificate: &Value, factor: u64) -> Vec<u8> {
    let mut copy = certificate.clone();
    for radius in copy.pointer_mut("/unique/radius").unwrap().as_array_mut().unwrap() {
        let number: Dyadic = radius.as_str().unwrap().parse().unwrap();
        let mantissa = Integer::from_digits(number.words(), Order::Lsf) * factor;
        *radius = format!("0x{mantissa:x}p{}", number.exponent() - SCALE).into();
    }
    copy.to_string().into_bytes()
}

/// The largest factor with which an arithmetic accepts. With the next one it refuses, as nothing is contracted.
fn limit(certificate: &Value, check: Check) -> u64 {
    let answer = |factor| check(&widened(certificate, factor), 1000);
    let (mut low, mut high) = (ONE, 16 * ONE);
    assert!(answer(low).is_ok());
    while high - low > 1 {
        let middle = low.midpoint(high);
        match answer(middle) {
            Ok(_) => low = middle,
            Err(Refusal::Contraction { .. } | Refusal::Denominator(_)) => high = middle,
            Err(other) => panic!("{other}"),
        }
    }
    low
}

/// An interval keeps both ends of a product, a ball the larger distance: astro accepts what mpfr accepts, and a little
/// more.
#[test]
fn astro_accepts_wider_boxes_than_mpfr() {
    let mut is_wider = false;
    for certificate in stored() {
        let [astro, mpfr] = [check_file::<AstroInterval> as Check, check_file::<Ball>]
            .map(|check| limit(&certificate, check));
        let claim = &certificate["claim"];
        assert!(mpfr <= astro && 5 * astro < 6 * mpfr, "{claim}: {astro} {mpfr}");
        is_wider |= mpfr < astro;
    }
    assert!(is_wider, "they differ");
}

/// What is written is no box at its limit.
#[test]
fn boxes_that_are_written_have_room() {
    for certificate in stored() {
        for check in [check_file::<AstroInterval> as Check, check_file::<Ball>] {
            check(&widened(&certificate, ONE + ONE / 16), 1000).unwrap();
        }
    }
}
