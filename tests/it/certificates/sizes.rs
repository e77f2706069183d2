//! Every size is looked at.

use super::originals::alike;
use super::refusals::{Cases, MAX_DIGITS, Spoiled, point};
use couplet::check::Refusal;
use serde_json::{Value, json};

/// A list of another length.
fn other_length(whole: &str, place: &'static str) -> Cases {
    let list = point().0.pointer(whole).unwrap().as_array().unwrap();
    assert_eq!(list.len(), 6);
    let more = [&list[..], &list[..1]].concat();
    [more, list[1..].to_vec(), vec![]]
        .map(|list| {
            let found = list.len();
            (point().with(whole, list), Refusal::Size { place, found, expected: 6 })
        })
        .into()
}

/// The number at a place with zeros behind it, so that it has this many bits.
fn longer(whole: &str, bits: u32) -> Value {
    let text = point().0.pointer(whole).unwrap().as_str().unwrap();
    let (mantissa, exponent) = text.split_once('p').unwrap();
    let (sign, digits) = mantissa.split_once("0x").unwrap();
    let size = rug::Integer::from_str_radix(digits, 16).unwrap();
    let exponent: i64 = exponent.parse().unwrap();
    let zeros = bits - size.significant_bits();
    let mantissa = size << zeros;
    json!(format!("{sign}0x{mantissa:x}p{}", exponent - i64::from(zeros)))
}

const LARGEST: [(&str, &str, u32); 5] = [
    ("/inverse/2/3", "inverse", 24_000),
    ("/unique/radius/1", "unique", 256),
    ("/unique/centre/1", "unique", 24_000),
    ("/root/radius/4", "root", 256),
    ("/root/centre/4", "root", 24_100),
];

#[test]
fn the_last_bit_that_is_allowed_is_accepted() {
    for (whole, _, bits) in LARGEST {
        let mut copy = point().0.clone();
        *copy.pointer_mut(whole).unwrap() = longer(whole, bits);
        let accepted = alike(copy.to_string().as_bytes(), MAX_DIGITS);
        accepted.unwrap_or_else(|refusal| panic!("{whole}: {refusal}"));
    }
}

fn one_bit_more((whole, place, bits): (&str, &'static str, u32)) -> (Spoiled, Refusal) {
    let refusal = Refusal::Large { place, bits: bits as usize };
    (point().with(whole, longer(whole, bits + 1)), refusal)
}

/// A radius that is not positive, of the first unknown and of one in the middle.
fn no_radius(place: &'static str, text: &str) -> Cases {
    [(0, "half_opening"), (4, "thrust")]
        .map(|(k, unknown)| {
            let copy = point().with(&format!("/{place}/radius/{k}"), text);
            (copy, Refusal::Radius { place, unknown })
        })
        .into()
}

refusals! {
    lists_of_another_length: [
        ("/inverse", "inverse"), ("/inverse/0", "inverse"), ("/inverse/5", "inverse"),
        ("/unique/centre", "unique"), ("/unique/radius", "unique"),
        ("/root/centre", "root"), ("/root/radius", "root"),
    ].into_iter().flat_map(|(whole, place)| other_length(whole, place)).collect();
    a_bit_too_many: LARGEST.map(one_bit_more).into();
    // None, a negative one, and a long zero.
    boxes_without_a_width: ["0x0p0", "-0x1p-90", "0x0000p5"].into_iter()
        .flat_map(|text| no_radius("unique", text).into_iter().chain(no_radius("root", text))).collect();
}
