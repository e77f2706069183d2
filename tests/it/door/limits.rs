//! `docs/limits.md` has the limits that the program names where it refuses a value.

use crate::program::ended;

const PAGE: &str = include_str!("../../../docs/limits.md");

/// Questions beyond a limit.
const BEYOND: [&str; 9] = [
    "state --half-opening 1 --friction 1 --digits 0",
    "voussoirs --half-opening 1 --friction 1 --stones 1",
    "voussoirs --half-opening 1 --friction 1 --thickness 1 --tilt 0.1 --stones 5000",
    "complementarity --half-opening 1 --friction 1 --stones 1000",
    "draw --half-opening 1 --friction 1 --stones 1 --format svg",
    "sample --count x",
    "map --tolerance 5",
    "state --half-opening 1 --friction 1 --threads 0",
    "state --half-opening 1e-2000 --friction 1",
];

/// The numbers that a refusal names behind `to`, `most` or `below`, as the page has them.
fn limits(refusal: &str) -> Vec<String> {
    let words: Vec<&str> = refusal.split_whitespace().collect();
    let named = words.windows(2).filter(|pair| ["to", "most", "below"].contains(&pair[0]));
    let numbers = named.map(|pair| pair[1].trim_end_matches([',', ';']));
    numbers.filter(|number| number.starts_with(|c: char| c.is_ascii_digit())).map(grouped).collect()
}

/// A whole number with commas between its thousands; another one as it is.
fn grouped(number: &str) -> String {
    if !number.bytes().all(|digit| digit.is_ascii_digit()) {
        return number.to_owned();
    }
    let mut text = number.to_owned();
    for place in (1..number.len()).rev().filter(|place| (number.len() - place).is_multiple_of(3)) {
        text.insert(place, ',');
    }
    text
}

#[test]
fn every_limit_that_is_named_is_on_the_page() {
    for question in BEYOND {
        let (_, said) = ended(2, question, "");
        let found = limits(&said);
        assert!(!found.is_empty(), "{said}");
        for limit in found {
            assert!(PAGE.contains(&limit), "{limit} of: {said}");
        }
    }
    let twin = limits("from 2 to 1000000001, or a range of at most 10000");
    assert!(twin.iter().any(|limit| !PAGE.contains(limit)), "false twin");
}
