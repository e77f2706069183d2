//! What every language has to read back, found in another way: from sixty proved digits.

use crate::program::{Json, object};
use couplet::number::Decimal;
use rug::{Float, Rational};
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// A value: its nearest double, the doubles around it, and three of its digits.
pub(super) struct Expected {
    pub point: &'static str,
    pub weight: String,
    pub quantity: String,
    /// Nearest, lower, upper; the error is only bounded.
    pub doubles: [f64; 3],
    /// The distance of the nearest double from the true value, up to sixty digits.
    pub distance: Rational,
    pub text: String,
    /// The nearest quadruple; `None` for infinity.
    pub quad: Option<Float>,
}

impl Expected {
    /// The name in capitals, without a suffix.
    pub(super) fn name(&self) -> String {
        format!("{}_{}_{}", self.point, self.weight, self.quantity).to_uppercase()
    }

    /// Checks what a program read back: the bits of the nearest, the lower and the upper double, and of
    /// the bound of the error.
    pub(super) fn check(&self, read: [u64; 4]) {
        let name = self.name();
        let bits = self.doubles.map(f64::to_bits);
        assert_eq!(read[..3], bits, "{name}");
        let error = f64::from_bits(read[3]);
        let distance = self.distance.to_f64();
        assert!(Rational::from_f64(error).unwrap() >= self.distance, "{name}: {error:e}");
        assert!(error <= 1.001 * distance, "{name}: the bound {error:e} of {distance:e} is loose");
    }
}

fn rational(text: &str) -> Rational {
    text.parse::<Decimal>().unwrap().to_rational()
}

/// The name of a landmark in capitals, whatever the case of its symbol.
fn point(symbol: &str) -> &'static str {
    match symbol {
        "T" => "T",
        "S" => "S",
        "J" => "J",
        "B" => "B",
        "l" => "ROTATION_END",
        "L" => "OVERTURNING_END",
        "sb" => "SB",
        other => panic!("{other}"),
    }
}

/// The constant of a landmark, a weight and a quantity.
pub(super) fn of([landmark, weight, quantity]: [&str; 3]) -> &'static Expected {
    &all()[&format!("{}_{weight}_{quantity}", point(landmark)).to_uppercase()]
}

fn expected(few: &Value, many: &Value) -> Expected {
    let text = |value: &Value, key: &str| value[key].text().to_owned();
    let point = point(few["landmark"].text());
    let (doubles, distance, quad) = if many["value"] == "inf" {
        ([f64::INFINITY; 3], Rational::new(), None)
    } else {
        // The reader of the standard library rounds correctly; both bounds have to round alike.
        let [low, high] = ["lower", "upper"].map(|end| text(many, end));
        let nearest: f64 = low.parse().unwrap();
        assert_eq!(nearest, high.parse::<f64>().unwrap());
        let [low, high] = [rational(&low), rational(&high)];
        let exactly = Rational::from_f64(nearest).unwrap();
        let doubles = match (exactly <= low, exactly >= high) {
            (true, true) => [nearest; 3],
            (true, false) => [nearest, nearest, nearest.next_up()],
            (false, true) => [nearest, nearest.next_down(), nearest],
            (false, false) => panic!("sixty digits do not tell the true value from a double"),
        };
        let [from, to] = [&low, &high].map(|end| Float::with_val(113, end));
        assert_eq!(from, to);
        let distance = (exactly.clone() - low).abs().min((exactly - high).abs());
        (doubles, distance, Some(from))
    };
    let (weight, quantity) = (text(few, "weight"), text(few, "quantity"));
    Expected { point, weight, quantity, doubles, distance, text: text(few, "value"), quad }
}

/// All constants by name.
pub(super) fn all() -> &'static BTreeMap<String, Expected> {
    static ALL: OnceLock<BTreeMap<String, Expected>> = OnceLock::new();
    ALL.get_or_init(find)
}

fn find() -> BTreeMap<String, Expected> {
    let [few, many] =
        ["3", "60"].map(|digits| object(["constants", "--digits", digits])["constants"].clone());
    let pairs = few.list().iter().zip(many.list());
    let all: BTreeMap<_, _> =
        pairs.map(|(few, many)| expected(few, many)).map(|value| (value.name(), value)).collect();
    assert_eq!(all.len(), 2 * (6 * 13 + 8), "names are unique, whatever the case of their letters");
    all
}
