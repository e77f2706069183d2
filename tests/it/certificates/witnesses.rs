//! Witnesses that prove nothing are refused.

use super::refusals::{Spoiled, arch, point};
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
    // 2 - eta is a denominator; so is the thrust's, which an angle of every size makes zero.
    a_thickness_of_two_in_the_box:
        point().with("/unique/radius/3", "0x1p1") => Refusal::Denominator("unique");
    angles_of_every_size_in_the_box:
        point().with("/unique/radius/0", "0x1p10000000") => Refusal::Denominator("unique");

    // A box without the root, one that is too large, and an inverse that is none.
    a_box_without_the_root:
        point().with("/unique/centre/1", "0x1p-1") => contraction("unique", "half_opening");
    a_box_that_is_too_large:
        point().with("/unique/radius/5", "0x1p0") => contraction("unique", "half_opening");
    an_inverse_of_zeros:
        point().with("/inverse", json!(zeros())) => contraction("unique", "half_opening");
    a_row_of_zeros: point().with("/inverse/3", zeros().remove(0)) => contraction("unique", "thickness");
    rows_in_another_order: two_rows_swapped() => contraction("unique", "thrust");
    a_large_entry:
        point().with("/inverse/0/0", "0x1p200") => contraction("unique", "half_opening");

    // A small box outside, astride, as large as the large one, and beside the root.
    a_root_outside: point().with("/root/centre/0", "0x1p1") => Refusal::Outside("half_opening");
    a_root_on_the_other_side:
        point().with("/root/centre/5", "-0x1p-1") => Refusal::Outside("friction");
    a_root_astride: point().with("/root/radius/4", "0x1p0") => Refusal::Outside("thrust");
    a_root_as_large_as_the_box:
        point().with("/root", unique("/unique")) => Refusal::Outside("half_opening");
    a_root_at_the_centre_of_the_box:
        point().with("/root/centre", unique("/unique/centre")) => contraction("root", "half_opening");
    a_root_too_small: point().with("/root/radius/3", "0x1p-300") => contraction("root", "thickness");
    a_root_far_too_small:
        point().with("/root/radius/2", "0x1p-10000000") => contraction("root", "sliding_joint");

    // Another landmark's box, another weight's, another arch's: their roots are not here.
    the_box_of_the_other_weight:
        point().with("/claim/weight", "milankovitch") => contraction("unique", "half_opening");
    the_root_of_another_arch:
        arch().with(
            "/claim/state/half_opening",
            "245000000000000000000000000001/100000000000000000000000000000",
        ) => contraction("root", "rotation_joint");
}
