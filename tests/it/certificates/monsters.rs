//! Files that are large, deep or large in what they ask for: refused quickly, in few words and with
//! little memory.

use super::originals::{alike, landmark};
use super::refusals::{Original, arch, point};
use crate::program::{Scratch, limited, said};
use couplet::check::{Refusal, check};
use couplet::number::AstroInterval;
use cpu_time::ThreadTime;
use serde_json::Value;
use std::time::Duration;

/// The largest number of digits in this file.
const MAX_DIGITS: usize = 40;

/// The certificate of T with another value at a place.
fn with(place: &str, value: impl Into<Value>) -> Vec<u8> {
    point().with(place, value).bytes
}

/// The same with one text replaced by another.
fn text(from: &str, to: impl AsRef<str>) -> Vec<u8> {
    point().replaced(from, to.as_ref()).bytes
}

fn long() -> String {
    "7".repeat(10_000_000)
}

fn long_half_opening() -> Vec<u8> {
    arch().with("/claim/state/half_opening", format!("{0}/{0}", long())).bytes
}

fn is_refused(name: &str, bytes: &[u8]) {
    // Of this thread alone: a busy machine makes no file slow.
    let start = ThreadTime::now();
    let refusal = check::<AstroInterval>(bytes, MAX_DIGITS).expect_err(name).to_string();
    let took = start.elapsed();
    assert!(took < Duration::from_secs(2), "{name}: {took:?}");
    assert!(refusal.len() < 400 && !refusal.contains(char::is_control), "{name}: {refusal}");
    assert_eq!(alike(bytes, MAX_DIGITS).unwrap_err().to_string(), refusal, "{name}");
}

/// One test for each monster, and the list of all.
macro_rules! monsters {
    ($($name:ident: $bytes:expr;)*) => {
        $(
            #[test]
            fn $name() {
                is_refused(stringify!($name), &$bytes);
            }
        )*

        #[cfg(target_os = "linux")]
        const MONSTERS: &[fn() -> Vec<u8>] = &[$(|| $bytes),*];
    };
}

monsters! {
    a_deep_list: "[".repeat(1_000_000).into_bytes();
    a_deep_object: "{\"claim\":".repeat(1_000_000).into_bytes();
    a_deep_inverse: text("\"inverse\":[", format!("\"inverse\":{}", "[".repeat(1_000_000)));
    an_unknown_field: text("{", format!("{{\"{}\":1,", long()));
    digits_as_a_long_number: text("\"digits\":30", format!("\"digits\":{}", long()));
    digits_as_a_long_text: text("\"digits\":30", format!("\"digits\":\"{}\"", long()));
    digits_of_64_bits: text("\"digits\":30", "\"digits\":18446744073709551615");
    digits_beyond_64_bits: text("\"digits\":30", "\"digits\":18446744073709551616");
    half_a_surrogate:
        text("\"tool\":\"", format!("\"tool\":\"{}\\ud800", "\\u0041".repeat(1_000_000)));
    white_space: [" ".repeat(10_000_000).as_bytes(), b"x"].concat();
    empty_lists: text("\"inverse\":[", format!("\"inverse\":[{}", "[],".repeat(1_000_000)));
    empty_names: text("\"unknowns\":[", format!("\"unknowns\":[{}", "\"\",".repeat(1_000_000)));
    empty_values:
        text(
            "\"values\":[",
            format!("\"values\":[{}", "{\"quantity\":\"\",\"value\":\"\"},".repeat(300_000)),
        );
    // Thirty megabytes of entries, each of which costs many times its text in memory.
    many_rows: text("\"inverse\":[", format!("\"inverse\":[{}", "[\"0x1p0\"],".repeat(3_000_000)));
    many_names: text("\"unknowns\":[", format!("\"unknowns\":[{}", "\"a\",".repeat(8_000_000)));
    many_labels:
        text("\"equations\":[", format!("\"equations\":[{}", "\"ab\",".repeat(6_000_000)));
    a_long_schema: with("/schema", long());
    a_long_weight: with("/claim/weight", long());
    a_long_landmark: with("/claim/landmark", long());
    a_long_unknown: with("/claim/unknowns/0", long());
    a_long_quantity: with("/values/0/quantity", long());
    a_long_value: with("/values/0/value", long());
    a_long_mantissa: with("/root/centre/2", format!("0x{}p0", long()));
    a_long_exponent: with("/root/centre/2", format!("0x1p{}", long()));
    a_long_negative_exponent: with("/root/centre/2", format!("0x1p-{}", long()));
    a_long_number_without_an_exponent: with("/root/centre/2", long());
    a_long_negative_number: with("/root/centre/2", format!("-0x{}", long()));
    a_value_with_many_zeros: with("/values/0/value", format!("0.{}1", "0".repeat(10_000_000)));
    a_large_value: with("/values/0/value", format!("1{}", "0".repeat(10_000_000)));
    a_value_with_a_long_exponent: with("/values/0/value", format!("1e-{}", long()));
    a_long_half_opening: long_half_opening();
    a_large_inverse: with("/inverse/2/2", "0x1p10000000");
}

#[test]
fn large_and_small_boxes_are_refused() {
    for place in ["/unique/centre/0", "/unique/radius/1", "/root/centre/3", "/root/radius/4"] {
        for number in ["0x1p10000000", "0x1p-10000000"] {
            is_refused(place, &with(place, number));
        }
    }
}

/// What made it is not looked at, however long its name.
#[test]
fn a_long_name_of_the_tool_is_accepted() {
    let copy = Original(landmark("L")).with("/tool", long());
    alike(&copy.bytes, MAX_DIGITS).unwrap();
}

#[test]
fn a_file_of_spaces_is_refused() {
    assert!(matches!(alike(&vec![b' '; 1 << 24], MAX_DIGITS), Err(Refusal::Format(_))));
}

/// The program refuses them all with a quarter of a gigabyte.
#[cfg(target_os = "linux")]
#[test]
fn monsters_are_refused_in_little_memory() {
    let scratch = Scratch::new();
    let files: Vec<String> =
        (0..MONSTERS.len()).map(|k| scratch.path(&format!("{k}.json"))).collect();
    MONSTERS.iter().zip(&files).for_each(|(bytes, file)| std::fs::write(file, bytes()).unwrap());
    let asked = std::iter::once("check").chain(files.iter().map(String::as_str));
    let (code, lines, message) = said(&limited("ulimit -v 262144", asked.collect::<Vec<_>>()));
    assert_eq!(code, Some(1), "{message}");
    assert_eq!(lines.lines().filter(|line| line.contains(".json: refused: ")).count(), files.len());
    assert_eq!(lines.lines().count(), files.len());
}
