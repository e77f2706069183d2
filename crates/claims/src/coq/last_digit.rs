//! Consequences for the values that the paper prints.

use super::value::{decimal, quantity, variable};
use crate::check::Certificate;
use crate::judge::published::{PRINTED, Printed};
use crate::problem::Quantity;
use rug::Integer;
use rug::ops::Pow;

/// One corollary for each printed value of a landmark, where it is printed first, that the digits of its certificate
/// decide: the tables come before the text.
pub(super) fn corollaries(certificate: &Certificate, subject: &str) -> String {
    let mut out = String::new();
    let mut seen = Vec::new();
    let point = subject.trim_start_matches("Landmark ");
    let claim = &certificate.claim;
    for printed in PRINTED {
        let belongs = claim.landmark.as_deref() == Some(printed.landmark.symbol())
            && claim.weight == printed.weight.name();
        if !belongs || seen.contains(&(printed.quantity, printed.text)) {
            continue;
        }
        seen.push((printed.quantity, printed.text));
        let Some((is_right, all, places)) = decided(printed, certificate) else { continue };
        if out.is_empty() {
            out.push_str("\n(** Is the last digit of a printed value right? *)\n");
        }
        let distance = format!("Rabs ({} - {})", term(printed.quantity), printed.text);
        let half = format!("5e-{}", places + 1);
        let (verdict, claimed) = match is_right {
            true => ("right", format!("{distance} <= {half}")),
            false => ("wrong", format!("{half} < {distance}")),
        };
        let place = printed.place.to_lowercase().replace(". ", "_").replace([' ', '.'], "_");
        let (name, quantity) = (printed.quantity.name(), quantity(printed.quantity.name()));
        out.push_str(&format!(
            "Corollary {place}_{name}_{verdict} x : is_landmark this {point} x -> {claimed}.\n\
             Proof. intros here. exact ({verdict}_there _ _ _ _ here {quantity} {all} {places} eq_refl). Qed.\n"
        ));
    }
    out
}

/// Verdict on the last digit of a printed decimal, right or not, by the digits of the certificate as Coq compares them
/// (`is_right`, `is_wrong` of `Landmarks.v`), its digits and how many are decimals; `None` if the certificate does not
/// decide it, as for none that is an integer or a fraction.
fn decided(printed: &Printed, certificate: &Certificate) -> Option<(bool, Integer, u32)> {
    let value = certificate.values.iter().find(|v| v.quantity == printed.quantity.name())?;
    let (all, exponent) = decimal(&value.value, certificate.digits)?;
    let (whole, part) = printed.text.split_once('.')?;
    let places = u32::try_from(part.len()).ok()?;
    let beyond = u32::try_from(-exponent).ok()?.checked_sub(places)?;
    let units = Integer::from(10).pow(beyond);
    let digits: Integer = format!("{whole}{part}").parse().ok()?;
    let all: Integer = all.parse().ok().filter(|all| *all > 0)?;
    let twice = (all - units.clone() * &digits).abs() * 2u32;
    (twice != units).then(|| (twice < units, digits, places))
}

/// A quantity in the variables of a configuration.
fn term(quantity: Quantity) -> String {
    let x = |name: &str| format!("x {}", variable(name));
    match (quantity, quantity.name().strip_suffix("_degrees")) {
        (Quantity::OpeningVariable, _) => "A (x Alpha)".to_owned(),
        (Quantity::FrictionAngle, _) => "atan (x Mu)".to_owned(),
        (Quantity::FrictionAngleDegrees, _) => "180 * atan (x Mu) / PI".to_owned(),
        (Quantity::IntrinsicThrust, _) => "x Eta * x Thrust".to_owned(),
        (_, Some(angle)) => format!("180 * {} / PI", x(angle)),
        (_, None) => x(quantity.name()),
    }
}
