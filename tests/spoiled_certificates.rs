//! Whatever is done to a certificate: what is still accepted is still true.

mod common;

use common::certificates::{both, landmark, state};
use common::config;
use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Arch, Friction};
use couplet::certify::{CertifiedLandmark, Value as Constant};
use couplet::check::{Accepted, Refusal, check};
use couplet::number::{AstroInterval, Ball, ExactNumber, Rounded};
use couplet::problem::{Exact, Subject};
use couplet::problem::{Landmark, Quantity};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use rug::ops::Pow;
use rug::{Integer, Rational};
use serde_json::{Value, json};
use std::cell::Cell;
use std::time::{Duration, Instant};

/// The largest number of digits in this file.
const MAX_DIGITS: usize = 40;

/// The number that a text of the form `d.ddd[e±n]` stands for.
fn decimal(text: &str) -> Rational {
    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: Integer = format!("{whole}{part}").parse().unwrap();
    let power: i32 = power.parse::<i32>().unwrap() - part.len() as i32;
    let ten = Integer::from(10).pow(power.unsigned_abs());
    if power < 0 { Rational::from((digits, ten)) } else { Rational::from(digits * ten) }
}

fn exact(given: &Exact) -> ExactNumber {
    let pi = if given.times_pi { "pi" } else { "" };
    format!("{}{pi}/{}", given.numerator, given.denominator).parse().unwrap()
}

/// The correctly rounded value as the solver has it; `None` for infinity.
fn truth(accepted: &Accepted, quantity: Quantity) -> Option<Rational> {
    let (claim, digits) = (&accepted.claim, accepted.digits);
    let rational = |rounded: Rounded| Some(rounded.value.to_rational());
    match &claim.subject {
        Subject::Landmark(landmark) => {
            let point = CertifiedLandmark::new(*landmark, claim.weight).unwrap();
            let constants = point.constants(digits, &|| ()).unwrap();
            match constants.into_iter().find(|c| c.quantity == quantity).unwrap().value {
                Constant::Infinite => None,
                Constant::Finite(rounded) => rational(rounded),
            }
        }
        Subject::State(state) => {
            let friction = state
                .friction
                .as_ref()
                .map_or(Friction::Infinite, |mu| Friction::Coefficient(exact(mu)));
            let arch = Arch::new(claim.weight, exact(&state.half_opening), friction).unwrap();
            let Answer::Stands(known) = arch.certify(digits).unwrap() else { panic!("{claim:?}") };
            assert_eq!(known.mode, state.mode);
            let figure = match quantity {
                Quantity::Thickness => known.thickness,
                Quantity::Thrust => known.thrust,
                Quantity::IntrinsicThrust => known.intrinsic_thrust,
                Quantity::RotationJoint => known.rotation_joint,
                Quantity::SlidingJoint => known.sliding_joint.unwrap(),
                // The solver has no degrees: a quantity put in by the spoiler, rare enough.
                _ => panic!("{quantity:?}"),
            };
            rational(figure.decimal)
        }
    }
}

/// Whether one of the arithmetics accepts it (at the edge one may and the other not); if so, every value
/// has to be the right one.
fn accepted_and_true(bytes: &[u8]) -> bool {
    let verdicts = [check::<AstroInterval>(bytes, MAX_DIGITS), check::<Ball>(bytes, MAX_DIGITS)];
    let Some(accepted) = verdicts.into_iter().find_map(Result::ok) else { return false };
    for (quantity, text) in &accepted.values {
        let right = truth(&accepted, *quantity);
        let found = (text != "inf").then(|| decimal(text));
        assert_eq!(found, right, "{:?} {quantity:?}", accepted.claim);
    }
    true
}

/// A step of spoiling: what, where and how.
type Step = (u8, u64, u64);

/// The certificates that are spoiled: most of them small, so that each part is hit.
fn originals() -> Vec<Value> {
    let mut all = vec![
        landmark("T").clone(),
        landmark("l").clone(),
        landmark("sb").clone(),
        state("2.45", "1.35").clone(),
        state("2.5", "inf").clone(),
    ];
    for value in &mut all {
        // A value is looked for among the constants each time: a few are enough.
        value["values"].as_array_mut().unwrap().truncate(3);
    }
    all
}

/// The places of all values in a value.
fn places(value: &Value, at: &str, all: &mut Vec<String>) {
    all.push(at.to_owned());
    match value {
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(i, v)| places(v, &format!("{at}/{i}"), all))
        }
        Value::Object(map) => map.iter().for_each(|(k, v)| places(v, &format!("{at}/{k}"), all)),
        _ => {}
    }
}

/// Another text in place of one: a character changed, left out, put in or doubled, or the number in it
/// changed a little.
fn other_text(text: &str, kind: u64, how: u64) -> String {
    const USEFUL: &[u8] = b"0123456789abcdefpx-./ eiTSJBlL+_[],rs";
    let mut bytes = text.as_bytes().to_vec();
    let at = (how / 64) as usize % bytes.len().max(1);
    let useful = USEFUL[how as usize % USEFUL.len()];
    match kind % 6 {
        0 if !bytes.is_empty() => bytes[at] = useful,
        1 if !bytes.is_empty() => drop(bytes.remove(at)),
        2 => bytes.insert(at, useful),
        3 if !bytes.is_empty() => bytes.truncate(at),
        4 => return format!("{text}{}", char::from(useful)),
        _ => {
            // The exponent of a number, or its last digit.
            let Some((mantissa, exponent)) = text.split_once('p') else {
                let Some(last) = bytes.last_mut().filter(|b| b.is_ascii_digit()) else {
                    return "0".into();
                };
                *last = b'0' + (*last - b'0' + 1 + how as u8 % 9) % 10;
                return String::from_utf8(bytes).unwrap();
            };
            let Ok(exponent) = exponent.parse::<i64>() else { return text.to_owned() };
            return format!("{mantissa}p{}", exponent + (how % 9) as i64 - 4);
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Spoils a value at one place.
fn spoil(value: &mut Value, &(what, at, how): &Step) {
    let mut all = Vec::new();
    places(value, "", &mut all);
    let place = &all[at as usize % all.len()];
    let other = value.pointer(&all[how as usize % all.len()]).unwrap().clone();
    let here = value.pointer_mut(place).unwrap();
    match (what % 6, &mut *here) {
        (0, _) => *here = other,
        (1, Value::Array(list)) if !list.is_empty() => drop(list.remove(how as usize % list.len())),
        (1, Value::Object(map)) if !map.is_empty() => {
            let key = map.keys().nth(how as usize % map.len()).unwrap().clone();
            map.remove(&key);
        }
        (2, Value::Array(list)) if !list.is_empty() => {
            let (i, j) = (how as usize % list.len(), (how / 64) as usize % list.len());
            list.swap(i, j);
        }
        (3, Value::Array(list)) if !list.is_empty() => {
            list.push(list[how as usize % list.len()].clone())
        }
        (4, _) => {
            *here = [json!(null), json!(0), json!(1), json!("inf"), json!([]), json!({})]
                [how as usize % 6]
                .clone()
        }
        (_, Value::String(text)) => *text = other_text(text, u64::from(what) / 6 + at / 7, how),
        (_, Value::Number(number)) => {
            let near = number.as_u64().unwrap_or(0).saturating_add(how % 5).saturating_sub(2);
            *here = json!(near);
        }
        _ => {}
    }
}

/// Spoils the text itself.
fn spoil_bytes(bytes: &mut Vec<u8>, &(what, at, how): &Step) {
    let at = at as usize % bytes.len().max(1);
    let size = how as usize % 40;
    let end = (at + size).min(bytes.len());
    match what % 5 {
        0 if !bytes.is_empty() => bytes[at] ^= 1 << (how % 8),
        1 => drop(bytes.drain(at..end)),
        2 => {
            let copy = bytes[at..end].to_vec();
            let to = (how / 64) as usize % (bytes.len() + 1);
            bytes.splice(to..to, copy);
        }
        3 => {
            let other = (how / 64) as usize % bytes.len().max(1);
            bytes.swap(at, other);
        }
        _ => bytes.insert(at, how as u8),
    }
}

/// Spoils the originals again and again; returns how many were accepted and how many refused.
fn spoiled(cases: u32, make: impl Fn(&Value, &[Step]) -> Vec<u8>) -> (u32, u32) {
    let originals = originals();
    let (accepted, refused) = (Cell::new(0), Cell::new(0));
    let steps = prop::collection::vec((any::<u8>(), any::<u64>(), any::<u64>()), 1..3);
    let strategy = (0..originals.len(), steps);
    TestRunner::new(config(cases))
        .run(&strategy, |(original, steps)| {
            let bytes = make(&originals[original], &steps);
            let count = if accepted_and_true(&bytes) { &accepted } else { &refused };
            count.set(count.get() + 1);
            Ok(())
        })
        .unwrap_or_else(|failure| panic!("{failure}"));
    (accepted.get(), refused.get())
}

#[test]
fn what_is_accepted_after_changes_of_values_is_true() {
    let (accepted, refused) = spoiled(8000, |original, steps| {
        let mut copy = original.clone();
        steps.iter().for_each(|step| spoil(&mut copy, step));
        copy.to_string().into_bytes()
    });
    assert!(accepted > 800 && refused > 4000, "{accepted} {refused}");
}

#[test]
fn what_is_accepted_after_changes_of_bytes_is_true() {
    let (accepted, refused) = spoiled(8000, |original, steps| {
        let mut bytes = original.to_string().into_bytes();
        steps.iter().for_each(|step| spoil_bytes(&mut bytes, step));
        bytes
    });
    assert!(accepted > 200 && refused > 4000, "{accepted} {refused}");
}

/// The right values of another claim are not those of this one.
#[test]
fn the_oracle_sees_what_is_false() {
    let accepted = both(landmark("T").to_string().as_bytes(), MAX_DIGITS).unwrap();
    let (quantity, text) = &accepted.values[0];
    assert_eq!(truth(&accepted, *quantity), Some(decimal(text)));
    let fewer = Accepted { digits: accepted.digits - 1, ..accepted.clone() };
    assert_ne!(truth(&fewer, *quantity), Some(decimal(&text[..text.len() - 3])));
    let mut other = accepted.clone();
    other.claim.weight = SelfWeight::Milankovitch;
    assert_ne!(truth(&other, *quantity), Some(decimal(text)));
    other.claim.subject = Subject::Landmark(Landmark::Junction);
    assert_ne!(truth(&other, *quantity), Some(decimal(text)));
    assert_eq!(decimal("1.25e-1"), Rational::from((1, 8)));
    assert_eq!(decimal("150"), 150);
}

/// Files that are large, deep or large in what they ask for.
fn monsters() -> Vec<(&'static str, Vec<u8>)> {
    let base = landmark("T");
    let long = "7".repeat(10_000_000);
    let with = |place: &str, value: Value| {
        let mut copy = base.clone();
        *copy.pointer_mut(place).unwrap() = value;
        copy.to_string().into_bytes()
    };
    let text = |from: &str, to: &str| base.to_string().replacen(from, to, 1).into_bytes();
    let mut all = vec![
        ("deep list", "[".repeat(1_000_000).into_bytes()),
        ("deep object", "{\"claim\":".repeat(1_000_000).into_bytes()),
        ("deep inverse", text("\"inverse\":[", &format!("\"inverse\":{}", "[".repeat(1_000_000)))),
        ("unknown field", text("{", &format!("{{\"{long}\":1,"))),
        ("digits as a number", text("\"digits\":30", &format!("\"digits\":{long}"))),
        ("digits as a text", text("\"digits\":30", &format!("\"digits\":\"{long}\""))),
        ("digits", text("\"digits\":30", "\"digits\":18446744073709551615")),
        ("more digits", text("\"digits\":30", "\"digits\":18446744073709551616")),
        (
            "half a surrogate",
            text("\"tool\":\"", &format!("\"tool\":\"{}\\ud800", "\\u0041".repeat(1_000_000))),
        ),
        ("white space", [" ".repeat(10_000_000).as_bytes(), b"x"].concat()),
        (
            "empty lists",
            text("\"inverse\":[", &format!("\"inverse\":[{}", "[],".repeat(1_000_000))),
        ),
        ("names", text("\"unknowns\":[", &format!("\"unknowns\":[{}", "\"\",".repeat(1_000_000)))),
        (
            "values",
            text(
                "\"values\":[",
                &format!("\"values\":[{}", "{\"quantity\":\"\",\"value\":\"\"},".repeat(300_000)),
            ),
        ),
    ];
    for place in [
        "/schema",
        "/claim/weight",
        "/claim/landmark",
        "/claim/unknowns/0",
        "/values/0/quantity",
        "/values/0/value",
    ] {
        all.push(("long text", with(place, json!(long))));
    }
    for number in [
        format!("0x{long}p0"),
        format!("0x1p{long}"),
        format!("0x1p-{long}"),
        long.clone(),
        format!("-0x{long}"),
    ] {
        all.push(("long number", with("/root/centre/2", json!(number))));
    }
    for value in [
        format!("0.{}1", "0".repeat(10_000_000)),
        format!("1{}", "0".repeat(10_000_000)),
        format!("1e-{long}"),
    ] {
        all.push(("long value", with("/values/0/value", json!(value))));
    }
    let mut arch = state("2.45", "1.35").clone();
    arch["claim"]["state"]["half_opening"] = json!(format!("{long}/{long}"));
    all.push(("long half opening", arch.to_string().into_bytes()));
    all.push(("large inverse", with("/inverse/2/2", json!("0x1p10000000"))));
    for exponent in ["10000000", "-10000000"] {
        for place in ["/unique/centre/0", "/unique/radius/1", "/root/centre/3", "/root/radius/4"] {
            all.push(("large exponent", with(place, json!(format!("0x1p{exponent}")))));
        }
    }
    all
}

#[test]
fn monsters_are_refused_quickly_and_in_few_words() {
    for (what, bytes) in monsters() {
        let start = Instant::now();
        let refusal = check::<AstroInterval>(&bytes, MAX_DIGITS).expect_err(what).to_string();
        let took = start.elapsed();
        assert!(took < Duration::from_secs(2), "{what}: {took:?}");
        assert!(refusal.len() < 400 && !refusal.contains(char::is_control), "{what}: {refusal}");
        assert_eq!(both(&bytes, MAX_DIGITS).unwrap_err().to_string(), refusal, "{what}");
    }
    // What made it is not looked at, however long its name.
    let mut copy = landmark("L").clone();
    copy["tool"] = json!("7".repeat(10_000_000));
    both(copy.to_string().as_bytes(), MAX_DIGITS).unwrap();
    assert!(matches!(both(&vec![b' '; 1 << 24], MAX_DIGITS), Err(Refusal::Format(_))));
}

/// The program refuses them all with a quarter of a gigabyte.
#[cfg(target_os = "linux")]
#[test]
fn monsters_are_refused_in_little_memory() {
    let folder = tempfile::tempdir().unwrap();
    let mut files = Vec::new();
    for (index, (_, bytes)) in monsters().into_iter().enumerate() {
        let path = folder.path().join(format!("{index}.json"));
        std::fs::write(&path, bytes).unwrap();
        files.push(path);
    }
    let output = std::process::Command::new("sh")
        .args(["-c", "ulimit -v 262144; exec \"$0\" check \"$@\"", env!("CARGO_BIN_EXE_couplet")])
        .args(&files)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let lines = String::from_utf8(output.stdout).unwrap();
    assert_eq!(lines.lines().filter(|line| line.contains(".json: refused: ")).count(), files.len());
    assert_eq!(lines.lines().count(), files.len());
}
