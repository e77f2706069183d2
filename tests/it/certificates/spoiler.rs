//! Spoils a certificate: its values, or the bytes of its text.

use crate::hard::config;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};
use std::cell::Cell;

/// A step of spoiling: what, where and how.
type Step = (u8, u64, u64);

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

/// Spoils originals again and again, in their values and then in their bytes, and looks whether each copy is accepted;
/// so many of a thousand are at least, and so many are refused.
pub(super) fn spoiled(
    cases: u32,
    least: [[u32; 2]; 2],
    originals: &[&Value],
    is_accepted: impl Fn(&[u8]) -> bool,
) {
    let config = config(cases);
    let share = |thousandths| config.cases / 1000 * thousandths;
    let steps = prop::collection::vec((any::<u8>(), any::<u64>(), any::<u64>()), 1..3);
    for ([some, most], in_bytes) in least.into_iter().zip([false, true]) {
        let counts: [Cell<u32>; 2] = Default::default();
        TestRunner::new(config.clone())
            .run(&(0..originals.len(), steps.clone()), |(original, steps)| {
                let mut copy = originals[original].clone();
                if !in_bytes {
                    steps.iter().for_each(|step| spoil(&mut copy, step));
                }
                let mut bytes = copy.to_string().into_bytes();
                if in_bytes {
                    steps.iter().for_each(|step| spoil_bytes(&mut bytes, step));
                }
                let count = &counts[usize::from(is_accepted(&bytes))];
                count.set(count.get() + 1);
                Ok(())
            })
            .unwrap_or_else(|failure| panic!("{failure}"));
        let [refused, accepted] = counts.map(|count| count.get());
        println!("{accepted} spoiled certificates accepted, {refused} refused");
        assert!(accepted >= share(some) && refused >= share(most), "{accepted} {refused}");
    }
}
