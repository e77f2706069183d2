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
    let values = values.iter().enumerate();
    values
        .map(|(k, value)| {
            let text = other(k, value["value"].as_str().unwrap());
            (
                point().with(&format!("/values/{k}/value"), text),
                reason(quantity(&value["quantity"])),
            )
        })
        .collect()
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
    zero: each_is_not("0");
    infinity: each_is_not("inf");
    a_tiny_number: each_is_not("1e-3000000");
    a_huge_number: each_is_not("1e3000000");
    another_number: each_is_not("9e9");
    the_value_of_another_quantity: the_next_value();

    nothing: no_decimal("");
    letters: no_decimal("abc");
    nan: no_decimal("nan");
    infinity_in_capitals: no_decimal("Inf");
    minus_infinity: no_decimal("-inf");
    infinity_in_full: no_decimal("infinity");
    no_whole_part: no_decimal(".5");
    minus_zero: no_decimal("-0");
    zero_with_places: no_decimal("0.000");
    a_leading_zero: no_decimal("00.5");
    no_places: no_decimal("1.");
    a_plus_in_the_exponent: no_decimal("1e+5");
    a_plus: no_decimal("+0.5");
    a_space_before: no_decimal(" 0.5");
    a_space_behind: no_decimal("0.5 ");
    a_comma: no_decimal("0,5");
    no_exponent: no_decimal("1e");
    an_exponent_too_large: no_decimal("1e3000001");
    the_least_exponent_of_64_bits: no_decimal("1e-9223372036854775808");
    the_largest_exponent_of_64_bits: no_decimal("1e9223372036854775807");
    an_exponent_beyond_64_bits: no_decimal("1e99999999999999999999");
    a_hexadecimal_number: no_decimal("0x1p0");
    a_fraction_in_one_character: no_decimal("½");
    a_minus: no_decimal_with("-", "");
    a_zero_too_many: no_decimal_with("", "0");
    a_digit_too_many: no_decimal_with("", "1");

    // One digit more than the values have: a zero behind them is not right either.
    a_digit_more_than_the_values_have: point().with("/digits", 31) => Refusal::Rounding("thickness");
    a_digit_less_than_the_values_have: point().with("/digits", 29) => Refusal::Decimal("thickness");
    a_root_too_wide_to_tell: too_wide() => Refusal::Rounding("thickness");

    // Infinite and zero where they are exact, and what is near them.
    a_huge_friction: near("friction", "1e3000000");
    no_friction: near("friction", "0");
    a_tiny_thrust: near("thrust", "1e-3000000");
    an_infinite_thrust: near("thrust", "inf");
    a_thickness_a_little_larger: near("thickness", "1.00001");
    a_thickness_a_little_smaller: near("thickness", "0.99999");
    an_infinite_friction_angle: near("friction_angle", "inf");
    a_friction_angle_a_little_smaller: near("friction_angle_degrees", "89.999");
    a_rotational_joint_beside_the_crown: near("rotation_joint", "1e-30");

    no_name: no_quantity(point(), "");
    a_name_in_capitals: no_quantity(point(), "Thickness");
    a_space_behind_the_name: no_quantity(point(), "thickness ");
    a_symbol: no_quantity(point(), "eta");
    another_name: no_quantity(point(), "tool");
    a_quantity_twice:
        point().with("/values/1", the_first_value()) => Refusal::Quantity("thickness".to_owned());
    a_friction_of_the_widest_joint: no_quantity(widest_joint(), "friction");
    a_sliding_joint_of_the_widest_joint: no_quantity(widest_joint(), "sliding_joint");
    the_half_opening_of_a_state: no_quantity(arch(), "half_opening");
    the_half_opening_of_a_state_in_degrees: no_quantity(arch(), "half_opening_degrees");
    the_friction_of_a_state: no_quantity(arch(), "friction");
    the_friction_angle_of_a_state: no_quantity(arch(), "friction_angle");
    the_opening_variable_of_a_state: no_quantity(arch(), "A");
    a_sliding_joint_of_rotation:
        no_quantity(Original(state("pi/2", "1/2")), "sliding_joint");
    no_values: point().with("/values", json!([])) => Refusal::NoValues;
}
