//! Witnesses that prove nothing are refused.

use super::refusals::{Spoiled, point};
use couplet::check::Refusal;
use serde_json::{Value, json};

fn contraction(place: &'static str, unknown: &'static str) -> Refusal {
    Refusal::Contraction { place, unknown }
}

fn zeros() -> Vec<Vec<&'static str>> {
    vec![vec!["0x0p0"; 6]; 6]
}

fn two_rows_swapped() -> Spoiled {
    let mut rows = point().0["inverse"].as_array().unwrap().clone();
    rows.swap(4, 5);
    point().with("/inverse", rows)
}

/// The large box, or its centre.
fn unique(place: &str) -> Value {
    point().0.pointer(place).unwrap().clone()
}

refusals! {
    an_inverse_of_zeros:
        point().with("/inverse", json!(zeros())) => contraction("unique", "half_opening");
    a_row_of_zeros: point().with("/inverse/3", zeros().remove(0)) => contraction("unique", "thickness");
    rows_in_another_order: two_rows_swapped() => contraction("unique", "thrust");
    a_root_as_large_as_the_box:
        point().with("/root", unique("/unique")) => Refusal::Outside("half_opening");
    a_root_at_the_centre_of_the_box:
        point().with("/root/centre", unique("/unique/centre")) => contraction("root", "half_opening");
}
