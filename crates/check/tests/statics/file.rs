//! What a certificate says, read from its text alone.

use super::ball::Ball;
use rug::{Integer, Rational};
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// A certificate, and which of its values are not judged yet.
pub(crate) struct File<'a> {
    pub(crate) json: &'a Value,
    pub(crate) digits: u32,
    pub(crate) bits: u32,
    values: RefCell<BTreeMap<&'a str, &'a str>>,
}

impl<'a> File<'a> {
    pub(crate) fn new(json: &'a Value, bits: u32) -> Self {
        let values = json["values"].as_array().expect("a list");
        let values = values.iter().map(|v| (text(&v["quantity"]), text(&v["value"])));
        Self {
            json,
            digits: json["digits"].as_u64().expect("a number") as u32,
            bits,
            values: RefCell::new(values.collect()),
        }
    }

    pub(crate) fn true_centroids(&self) -> bool {
        match text(&self.json["claim"]["weight"]) {
            "heyman" => false,
            "milankovitch" => true,
            other => panic!("no weight: {other}"),
        }
    }

    /// An exact number; an angle after `tan` or an arctangent becomes what is meant.
    pub(crate) fn number(&self, words: &str) -> Ball {
        let ball = |x: &str| Ball::new(&x.parse::<Rational>().expect(x), self.bits);
        match words.split_once(' ') {
            Some(("tan", angle)) => {
                let [sin, cos] = self.number(angle).sin_cos();
                sin.divided_by(&cos).expect("acute")
            }
            Some(("2", rest)) => {
                let half = ball(rest.strip_prefix("atan ").expect(rest)).arctangent();
                &half + &half
            }
            Some((factor, "pi")) => &ball(factor) * &ball("1").pi(),
            Some(_) => panic!("no number: {words}"),
            None => ball(words),
        }
    }

    pub(crate) fn friction(&self, words: &str) -> Option<Ball> {
        (words != "inf").then(|| self.number(words))
    }

    /// Where the file says that an unknown is.
    pub(crate) fn hint(&self, unknown: &str) -> Option<Ball> {
        let names = self.json["claim"]["unknowns"].as_array().expect("a list");
        let k = names.iter().position(|name| name == unknown)?;
        Some(Ball::new(&dyadic(text(&self.json["root"]["centre"][k])), self.bits))
    }

    /// The ends between which a value is, and what is said of it counts as judged.
    pub(crate) fn value(&self, quantity: &str) -> Option<[Ball; 2]> {
        let words = self.values.borrow_mut().remove(quantity)?;
        let ends = match words {
            "0" => [Rational::new(), Rational::new()],
            _ => rounded_to(words, self.digits),
        };
        Some(ends.map(|x| Ball::new(&x, self.bits)))
    }

    /// Whether a value is these words, which then count as judged.
    pub(crate) fn says(&self, quantity: &str, words: &str) -> bool {
        let mut values = self.values.borrow_mut();
        values.get(quantity).is_none_or(|said| *said == words) && {
            values.remove(quantity);
            true
        }
    }

    /// Tells of a quantity between two numbers that its value is right.
    pub(crate) fn agrees(&self, quantity: &str, [low, high]: [&Ball; 2]) -> Result<(), String> {
        match self.value(quantity) {
            Some([from, to]) if !((low - &from).is_positive() && (&to - high).is_positive()) => {
                let [a, b] = [low, high].map(|x| x.rational().to_f64());
                Err(format!(
                    "{quantity} is from {a:e} to {b:e}, which are {:e} apart",
                    (high - low).rational().to_f64()
                ))
            }
            _ => Ok(()),
        }
    }

    pub(crate) fn all_judged(&self) -> Result<(), String> {
        match self.values.borrow().keys().next() {
            Some(quantity) => Err(format!("{quantity} was not judged")),
            None => Ok(()),
        }
    }
}

pub(crate) fn text(value: &Value) -> &str {
    value.as_str().expect("text")
}

/// `-0x1f3p-12` is -499 / 4096.
pub(crate) fn dyadic(words: &str) -> Rational {
    let (sign, rest) = words.strip_prefix('-').map_or((1, words), |rest| (-1, rest));
    let (mantissa, exponent) =
        rest.strip_prefix("0x").and_then(|x| x.split_once('p')).expect(words);
    let mantissa = Integer::from_str_radix(mantissa, 16).expect(words) * sign;
    Rational::from(mantissa) << exponent.parse::<i32>().expect(words)
}

/// The ends of what is rounded to a decimal of so many digits: half a unit of the last on either side, a twentieth below
/// a power of ten.
fn rounded_to(words: &str, digits: u32) -> [Rational; 2] {
    let (sign, words) = words.strip_prefix('-').map_or((1, words), |rest| (-1, rest));
    let (number, exponent) = words.split_once('e').unwrap_or((words, "0"));
    let (whole, part) = number.split_once('.').unwrap_or((number, ""));
    let exponent = exponent.parse::<i32>().expect(words) - part.len() as i32;
    let mantissa: Integer = format!("{whole}{part}").parse().expect(words);
    let places = mantissa.to_string().len() as i32;
    let ten = |n: i32| {
        let power = Rational::from(Integer::from(Integer::u_pow_u(10, n.unsigned_abs())));
        if n < 0 { power.recip() } else { power }
    };
    let unit = ten(exponent + places - digits as i32);
    let value = Rational::from(&mantissa) * ten(exponent);
    let is_power = value == ten(exponent + places - 1);
    let below = Rational::from(&unit / if is_power { 20 } else { 2 });
    let ends = [(&value - below), value + unit / 2];
    if sign > 0 { ends } else { ends.map(|x| -x) }
}
