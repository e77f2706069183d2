//! What is no certificate is told with its place.

use super::originals::alike;
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled, arch, point};
use couplet::check::Refusal;
use serde_json::{Value, json};

fn format(words: &str) -> Refusal {
    Refusal::Format(words.to_owned())
}

fn missing(key: &str) -> Refusal {
    format(&format!("missing field `{key}`"))
}

/// A stored file, as it came.
macro_rules! stored {
    ($name:literal) => {
        Spoiled::new($name, include_bytes!(concat!("refused/", $name, ".json")))
    };
}

/// A text in place of a number.
fn no_number(text: &str) -> Cases {
    let words =
        format!("{text:?} is not a valid certificate number: it is not of the form -0x1f3p-12");
    vec![(point().with("/root/centre/0", text), format(&words))]
}

fn too_large(text: &str) -> Cases {
    let words =
        format!("{text:?} is not a valid certificate number: its exponent is beyond ±10000000");
    vec![(point().with("/inverse/0/0", text), format(&words))]
}

refusals! {
    // No JSON, or not the JSON of an object.
    an_empty_file: stored!("empty") => format("EOF while parsing a value at line 1 column 0");
    null: stored!("null") => format("invalid type: null, expected an object");
    a_number: Spoiled::new("number", "1") => format("invalid type: integer `1`, expected an object");
    a_file_that_is_cut: stored!("cut") => format("EOF while parsing a list");
    a_list: stored!("list") => format("invalid type: sequence, expected an object");
    latin_1: stored!("latin-1") => Refusal::Encoding(49);
    utf_16: stored!("utf-16") => Refusal::Encoding(0);
    two_byte_order_marks:
        stored!("two-byte-order-marks") => format("expected value at line 1 column 1");
    half_a_surrogate: stored!("surrogate") => format("unexpected end of hex escape");
    a_comment: stored!("comment") => format("expected value at line 1 column 1");
    plain_text: stored!("text") => format("expected value at line 1 column 1");
    control_characters: stored!("control") => format("unknown field `a\\n\\u{1b}[2J`");
    an_empty_object: Spoiled::new("{}", "{}") => missing("schema");
    lists_that_are_too_long: long_lists();

    // Fields that are unknown, or there twice.
    a_field_too_many: point().replaced("{", "{\"extra\":1,") => format("unknown field `extra`");
    a_field_of_the_claim_in_capitals:
        point().replaced("\"weight\"", "\"Weight\"") => format("unknown field `Weight`");
    a_field_in_american:
        point().replaced("\"centre\"", "\"center\"") => format("unknown field `center`");
    a_field_too_many_in_a_value:
        point().replaced("\"quantity\"", "\"error\":1,\"quantity\"") => format("unknown field `error`");
    a_field_of_a_state_in_capitals:
        arch().replaced("\"mode\"", "\"Mode\"") => format("unknown field `Mode`");
    digits_twice:
        point().replaced("\"digits\"", "\"digits\":30,\"digits\"") => format("duplicate field `digits`");
    a_landmark_twice:
        point().replaced("\"landmark\"", "\"landmark\":\"T\",\"landmark\"")
        => format("duplicate field `landmark`");
    a_centre_twice:
        point().replaced("\"centre\"", "\"centre\":[],\"centre\"") => format("duplicate field `centre`");
    a_value_twice:
        point().replaced("\"value\":", "\"value\":\"1\",\"value\":") => format("duplicate field `value`");
    a_mode_twice:
        arch().replaced("\"mode\"", "\"mode\":\"[r]\",\"mode\"") => format("duplicate field `mode`");

    // JSON with a slip.
    a_comma_before_the_end: point().replaced("}]}", "}],}") => format("trailing comma");
    a_comma_after_the_last_value: point().replaced("}]}", "},]}") => format("trailing comma");
    an_object_behind_the_end: point().replaced("}]}", "}]}{}") => format("trailing characters");
    a_null_character_behind_the_end:
        point().replaced("}]}", "}]}\u{0}") => format("trailing characters");
    a_brace_too_few: point().replaced("}]}", "}]") => format("EOF while parsing an object");
    a_key_in_single_quotes:
        point().replaced("\"digits\"", "'digits'") => format("key must be a string");
    a_leading_zero: point().replaced("\"digits\":30", "\"digits\":030") => format("invalid number");
    a_plus: point().replaced("\"digits\":30", "\"digits\":+30") => format("expected value");
    nan: point().replaced("\"digits\":30", "\"digits\":NaN") => format("expected value");
    a_number_out_of_range:
        point().replaced("\"digits\":30", "\"digits\":1e400") => format("number out of range");

    // Every field of every object is needed.
    no_schema: point().without("", "schema") => missing("schema");
    no_tool: point().without("", "tool") => missing("tool");
    no_claim: point().without("", "claim") => missing("claim");
    no_digits: point().without("", "digits") => missing("digits");
    no_unique_box: point().without("", "unique") => missing("unique");
    no_inverse: point().without("", "inverse") => missing("inverse");
    no_root: point().without("", "root") => missing("root");
    no_list_of_values: point().without("", "values") => missing("values");
    no_weight: point().without("/claim", "weight") => missing("weight");
    no_unknowns: point().without("/claim", "unknowns") => missing("unknowns");
    no_equations: point().without("/claim", "equations") => missing("equations");
    no_centre_of_the_unique_box: point().without("/unique", "centre") => missing("centre");
    no_radius_of_the_unique_box: point().without("/unique", "radius") => missing("radius");
    no_centre_of_the_root: point().without("/root", "centre") => missing("centre");
    no_radius_of_the_root: point().without("/root", "radius") => missing("radius");
    no_quantity: point().without("/values/0", "quantity") => missing("quantity");
    no_value: point().without("/values/0", "value") => missing("value");
    no_mode: arch().without("/claim/state", "mode") => missing("mode");
    no_half_opening: arch().without("/claim/state", "half_opening") => missing("half_opening");
    no_friction: arch().without("/claim/state", "friction") => missing("friction");

    // Values of another type.
    a_tool_that_is_a_number:
        point().with("/tool", 5) => format("invalid type: integer `5`, expected a string");
    digits_as_text:
        point().with("/digits", "30") => format("invalid type: string \"30\", expected usize");
    negative_digits:
        point().with("/digits", -1) => format("invalid value: integer `-1`, expected usize");
    digits_with_a_point:
        point().with("/digits", 30.0) => format("invalid type: floating point `30.0`, expected usize");
    digits_with_an_exponent:
        point().with("/digits", 1e30) => format("invalid type: floating point `1e+30`, expected usize");
    no_number_of_digits:
        point().with("/digits", Value::Null) => format("invalid type: null, expected usize");
    a_claim_as_a_list:
        point().with("/claim", json!(["heyman", "T", [], []]))
        => format("invalid type: sequence, expected an object");
    a_null_landmark:
        point().with("/claim/landmark", Value::Null) => format("invalid type: null, expected a string");
    one_unknown_without_a_list:
        point().with("/claim/unknowns", "thickness")
        => format("invalid type: string \"thickness\", expected a sequence");
    a_null_state:
        arch().with("/claim/state", Value::Null) => format("invalid type: null, expected an object");
    a_state_as_a_list:
        arch().with("/claim/state", json!(["[r]", "1/1", "inf"])) => format("invalid type: sequence");
    a_box_as_a_list:
        point().with("/unique", json!([[], []])) => format("invalid type: sequence, expected an object");
    a_null_root:
        point().with("/root", Value::Null) => format("invalid type: null, expected an object");
    a_row_that_is_a_number:
        point().with("/inverse/0", "0x1p0")
        => format("invalid type: string \"0x1p0\", expected a sequence");
    a_double_in_the_root:
        point().with("/root/centre/0", 1.5)
        => format("invalid type: floating point `1.5`, expected a string");
    values_as_an_object:
        point().with("/values", json!({})) => format("invalid type: map, expected a sequence");
    a_value_as_a_list:
        point().with("/values/0", json!(["thickness", "0.7"]))
        => format("invalid type: sequence, expected an object");
    a_double_as_a_value:
        point().with("/values/0/value", 0.7)
        => format("invalid type: floating point `0.7`, expected a string");

    // Texts that are no numbers.
    no_text_as_a_number: no_number("");
    a_decimal_as_a_number: no_number("1.5");
    no_exponent: no_number("0x1");
    an_empty_exponent: no_number("0x1p");
    capitals_in_a_number: no_number("0xFp1");
    a_plus_before_a_number: no_number("+0x1p1");
    a_point_in_a_number: no_number("0x1.8p0");
    a_plus_in_the_exponent: no_number("0x1p+1");
    two_minus_signs: no_number("--0x1p0");
    a_space_before_a_number: no_number(" 0x1p0");
    a_new_line_behind_a_number: no_number("0x1p0\n");
    infinity_as_a_number: no_number("inf");
    an_exponent_too_large: too_large("0x1p10000001");
    an_exponent_too_small: too_large("0x1p-10000001");
    a_zero_with_a_large_exponent: too_large("0x0p10000001");
    an_exponent_beyond_64_bits: too_large("0x1p999999999999999999");
}

/// Lists of one entry more than is read, each in its place.
fn long_lists() -> Cases {
    let longest = |place: &str, entry: Value| {
        let list = vec![entry; 33];
        (point().with(place, list), format("a list of more than 32 entries"))
    };
    let value = json!({"quantity": "thrust", "value": "1"});
    vec![
        longest("/inverse", json!([])),
        longest("/inverse/0", json!("0x1p0")),
        longest("/unique/centre", json!("0x1p0")),
        longest("/root/radius", json!("0x1p0")),
        longest("/claim/unknowns", json!("a")),
        longest("/claim/equations", json!("ab")),
        longest("/values", value),
    ]
}

#[test]
fn one_byte_order_mark_is_no_part_of_the_file() {
    let plain = point().0.to_string();
    let marked = format!("\u{feff}{plain}");
    assert_eq!(alike(marked.as_bytes(), MAX_DIGITS), alike(plain.as_bytes(), MAX_DIGITS));
    assert!(alike(plain.as_bytes(), MAX_DIGITS).is_ok());
}

/// The table above leaves out each field of each object, but for the landmark, without which a claim may
/// be that of a state.
#[test]
fn every_field_of_every_object_is_left_out() {
    let keys = |Original(base): Original, place: &str| {
        base.pointer(place).unwrap().as_object().unwrap().len()
    };
    let places = ["", "/claim", "/unique", "/root", "/values/0"];
    let fields: usize = places.map(|place| keys(point(), place)).iter().sum();
    let fields = fields - 1 + keys(arch(), "/claim/state");
    let reasons = expected().into_iter().map(|refusal| refusal.to_string());
    let left_out = reasons.filter(|reason| reason.contains("missing field")).count();
    // The empty object lacks a field too.
    assert_eq!(left_out - 1, fields);
}
