//! Numbers, quantities and decimals as Coq reads them.

use crate::number::Decimal;

/// A name with its first letter large.
pub(super) fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// An exact number of a claim: `49/20`, `1/2 pi`, `2 atan 3/5`.
pub(super) fn number(text: &str) -> String {
    let (quotient, form) = match (text.strip_suffix(" pi"), text.strip_prefix("2 atan ")) {
        (Some(quotient), _) => (quotient, "TimesPi"),
        (None, Some(quotient)) => (quotient, "TwiceArctangent"),
        (None, None) => (text, "Fraction"),
    };
    format!("({form} {})", quotient.replace('/', " "))
}

/// A friction of a claim.
pub(super) fn coefficient(text: &str) -> String {
    match (text, text.strip_prefix("tan ")) {
        ("inf", _) => "Unlimited".to_owned(),
        (_, Some(angle)) => format!("(Angle {})", number(angle)),
        _ => format!("(Coefficient {})", number(text)),
    }
}

pub(super) fn list(entries: impl Iterator<Item = String>) -> String {
    format!("[{}]", entries.collect::<Vec<_>>().join("; "))
}

/// A list with a line for each entry.
pub(super) fn rows(entries: impl Iterator<Item = String>) -> String {
    format!("[{}]", entries.collect::<Vec<_>>().join(";\n     "))
}

/// The quantity of a name.
pub(super) fn quantity(name: &str) -> String {
    match (name, name.strip_suffix("_degrees")) {
        ("intrinsic_thrust", _) => "IntrinsicThrust".to_owned(),
        ("A", _) => "OpeningVariable".to_owned(),
        ("friction_angle", _) => "FrictionAngle".to_owned(),
        ("friction_angle_degrees", _) => "FrictionAngleDegrees".to_owned(),
        (_, Some(angle)) => format!("(Degrees {})", variable(angle)),
        (name, None) => format!("(Plain {})", variable(name)),
    }
}

pub(super) fn variable(name: &str) -> &'static str {
    match name {
        "half_opening" => "Alpha",
        "rotation_joint" => "BetaR",
        "sliding_joint" => "BetaS",
        "thickness" => "Eta",
        "thrust" => "Thrust",
        "friction" => "Mu",
        "crown_moment" => "Moment",
        "vertical_force" => "Force",
        "crown_hinge" => "Hinge",
        "shoulder_slip" => "Slip",
        "inner_slip" => "InnerSlip",
        "shoulder_opening" => "Opening",
        _ => "Power",
    }
}

/// A decimal as all its digits and a power of ten, `None` for no limit: what the checker has accepted is one.
pub(super) fn decimal(text: &str, digits: usize) -> Option<(String, i64)> {
    let decimal: Decimal = text.parse().ok()?;
    let (mut all, mut power) = (decimal.digits().to_owned(), decimal.exponent());
    if all.is_empty() {
        return Some(("0".to_owned(), 0));
    }
    while all.len() > digits && all.ends_with('0') {
        all.pop();
        power += 1;
    }
    let missing = digits.saturating_sub(all.len());
    Some((all + &"0".repeat(missing), power - missing as i64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_the_file_has_them() {
        assert_eq!(number("49/20"), "(Fraction 49 20)");
        assert_eq!(number("1/2 pi"), "(TimesPi 1 2)");
        assert_eq!(number("2 atan 3/5"), "(TwiceArctangent 3 5)");
        assert_eq!(coefficient("inf"), "Unlimited");
        assert_eq!(coefficient("tan 7/36 pi"), "(Angle (TimesPi 7 36))");
        assert_eq!(coefficient("1/2"), "(Coefficient (Fraction 1 2))");
    }

    #[test]
    fn a_decimal_has_all_its_digits() {
        let cases = [
            ("0.1074", 4, Some(("1074", -4))),
            ("2", 3, Some(("200", -2))),
            ("140", 2, Some(("14", 1))),
            ("3.1e-8", 3, Some(("310", -10))),
            ("0.0640", 3, Some(("640", -4))),
            ("0", 30, Some(("0", 0))),
            ("inf", 30, None),
        ];
        for (text, digits, expected) in cases {
            let expected = expected.map(|(all, power)| (all.to_owned(), power));
            assert_eq!(decimal(text, digits), expected, "{text}");
        }
    }
}
