//! Values are believed to the last place only if they are right.

use super::originals::{landmark, state};
use super::refusals::{Cases, Original, Spoiled, arch, point};
use couplet::check::Refusal;
use couplet::problem::Quantity;
use serde_json::{Value, json};

/// The quantity of this name.
fn quantity(name: &Value) -> &'static str {
    Quantity::LANDMARK.iter().find(|quantity| *name == quantity.name()).unwrap().name()
}

/// A copy for each value of the triple point, with the text that `other` makes of the number of the value
/// and of what is right there.
fn each(other: impl Fn(usize, &str) -> String, reason: fn(&'static str) -> Refusal) -> Cases {
    let values = point().0["values"].as_array().unwrap();
    assert_eq!(values.len(), 13);
    let case = |(k, value): (usize, &Value)| {
        let text = other(k, value["value"].as_str().unwrap());
        (point().with(&format!("/values/{k}/value"), text), reason(quantity(&value["quantity"])))
    };
    values.iter().enumerate().map(case).collect()
}

fn each_is_not(text: &str) -> Cases {
    each(|_, _| text.to_owned(), Refusal::Rounding)
}

fn no_decimal(text: &str) -> Cases {
    each(|_, _| text.to_owned(), Refusal::Decimal)
}

/// Each value with something before and behind it.
fn no_decimal_with(before: &str, behind: &str) -> Cases {
    each(|_, right| format!("{before}{right}{behind}"), Refusal::Decimal)
}

fn other_last_digit(step: u32) -> Cases {
    let other = |_, right: &str| {
        let (head, last) = right.split_at(right.len() - 1);
        format!("{head}{}", (last.parse::<u32>().unwrap() + step) % 10)
    };
    each(other, Refusal::Rounding)
}

fn the_next_value() -> Cases {
    let values = &point().0["values"];
    each(|k, _| values[(k + 1) % 13]["value"].as_str().unwrap().to_owned(), Refusal::Rounding)
}

/// A small box that is true and too large to tell.
fn too_wide() -> Spoiled {
    point().changed("too wide", |copy| {
        for radius in copy["root"]["radius"].as_array_mut().unwrap() {
            let text = radius.as_str().unwrap();
            let (mantissa, exponent) = text.split_once('p').unwrap();
            *radius = json!(format!("{mantissa}p{}", exponent.parse::<i32>().unwrap() + 60));
        }
    })
}

/// Where a quantity stands among the values of `l`, the end of rotation.
fn at_the_end(name: &str) -> usize {
    landmark("l")["values"].as_array().unwrap().iter().position(|v| v["quantity"] == name).unwrap()
}

/// Another value than the exact one at the end of rotation.
fn near(name: &str, text: &str) -> Cases {
    let place = format!("/values/{}/value", at_the_end(name));
    let known = quantity(&json!(name));
    vec![(Original(landmark("l")).with(&place, text), Refusal::Rounding(known))]
}

fn no_quantity(original: Original, text: &str) -> Cases {
    vec![(original.with("/values/0/quantity", text), Refusal::Quantity(text.to_owned()))]
}

fn widest_joint() -> Original {
    Original(landmark("sb"))
}

fn the_first_value() -> Value {
    point().0["values"][0].clone()
}

#[test]
fn exact_values_are_what_they_are() {
    for (quantity, text) in
        [("friction", "inf"), ("thrust", "0"), ("thickness", "1"), ("friction_angle_degrees", "90")]
    {
        assert_eq!(landmark("l")["values"][at_the_end(quantity)]["value"], text);
    }
}

refusals! {
    a_last_digit_too_high: other_last_digit(1);
    a_last_digit_too_low: other_last_digit(9);
    values_that_are_another: [
        "0", "inf", "1e-3000000", "1e3000000", "9e9",
    ].into_iter().flat_map(each_is_not).collect();
    the_value_of_another_quantity: the_next_value();

    texts_that_are_no_decimals: [
        "", "abc", "nan", "Inf", "-inf", "infinity", ".5", "-0", "0.000", "00.5", "1.", "1e+5", "+0.5", " 0.5",
        "0.5 ", "0,5", "1e", "1e3000001", "1e-9223372036854775808", "1e9223372036854775807",
        "1e99999999999999999999", "0x1p0", "½",
    ].into_iter().flat_map(no_decimal).collect();
    a_minus: no_decimal_with("-", "");
    a_zero_too_many: no_decimal_with("", "0");
    a_digit_too_many: no_decimal_with("", "1");
    a_root_too_wide_to_tell: too_wide() => Refusal::Rounding("thickness");

    // Infinite and zero where they are exact, and what is near them.

    a_quantity_twice:
        point().with("/values/1", the_first_value()) => Refusal::Quantity("thickness".to_owned());
    a_sliding_joint_of_rotation:
        no_quantity(Original(state("pi/2", "1/2")), "sliding_joint");
    values_near_those_that_are_exact: [
        ("friction", "1e3000000"), ("friction", "0"), ("thrust", "1e-3000000"), ("thrust", "inf"),
        ("thickness", "1.00001"), ("thickness", "0.99999"), ("friction_angle", "inf"),
        ("friction_angle_degrees", "89.999"), ("rotation_joint", "1e-30"),
    ].into_iter().flat_map(|(name, text)| near(name, text)).collect();
    names_of_no_quantity: [
        "", "Thickness", "thickness ", "eta", "tool",
    ].into_iter().flat_map(|text| no_quantity(point(), text)).collect();
    quantities_that_the_widest_joint_lacks: [
        "friction", "sliding_joint",
    ].into_iter().flat_map(|text| no_quantity(widest_joint(), text)).collect();
    quantities_that_a_state_lacks: [
        "half_opening", "half_opening_degrees", "friction", "friction_angle", "A",
    ].into_iter().flat_map(|text| no_quantity(arch(), text)).collect();
}
