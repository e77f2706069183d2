//! Every size is looked at.

use super::originals::alike;
use super::refusals::{Cases, MAX_DIGITS, point};
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

fn one_bit_more(index: usize) -> Cases {
    let (whole, place, bits) = LARGEST[index];
    vec![(
        point().with(whole, longer(whole, bits + 1)),
        Refusal::Large { place, bits: bits as usize },
    )]
}

/// A radius that is not positive, of the first unknown and of one in the middle.
fn no_radius(place: &'static str, text: &str) -> Cases {
    [(0, "half_opening"), (4, "thrust")]
        .map(|(k, unknown)| {
            (
                point().with(&format!("/{place}/radius/{k}"), text),
                Refusal::Radius { place, unknown },
            )
        })
        .into()
}

refusals! {
    rows_of_the_inverse: other_length("/inverse", "inverse");
    the_first_row_of_the_inverse: other_length("/inverse/0", "inverse");
    the_last_row_of_the_inverse: other_length("/inverse/5", "inverse");
    the_centre_of_the_unique_box: other_length("/unique/centre", "unique");
    the_radius_of_the_unique_box: other_length("/unique/radius", "unique");
    the_centre_of_the_root: other_length("/root/centre", "root");
    the_radius_of_the_root: other_length("/root/radius", "root");

    a_bit_too_many_in_the_inverse: one_bit_more(0);
    a_bit_too_many_in_the_unique_radius: one_bit_more(1);
    a_bit_too_many_in_the_unique_centre: one_bit_more(2);
    a_bit_too_many_in_the_root_radius: one_bit_more(3);
    a_bit_too_many_in_the_root_centre: one_bit_more(4);

    a_unique_box_of_zero_width: no_radius("unique", "0x0p0");
    a_unique_box_of_negative_width: no_radius("unique", "-0x1p-90");
    a_unique_box_of_a_long_zero: no_radius("unique", "0x0000p5");
    a_root_of_zero_width: no_radius("root", "0x0p0");
    a_root_of_negative_width: no_radius("root", "-0x1p-90");
    a_root_of_a_long_zero: no_radius("root", "0x0000p5");
}
