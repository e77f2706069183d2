//! The file of a certificate: the numbers of it, and that the verified checker accepts them.
//!
//! Coq computes that by itself, so that nothing here is trusted: what is claimed is `claim_of` of
//! `proofs/coq/verified/Certificate.v`.

use super::last_digit;
use super::value::{decimal, quantity};
use crate::check::{ArchFile, Certificate, ClaimFile, Refusal, ValueFile, Witness, verify};
use crate::number::Dyadic;
use rug::Integer;
use rug::integer::Order;

/// Reason why a certificate does not become a theorem.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CertificateError {
    /// The checker does not accept it.
    #[error("refused: {0}")]
    Refused(#[from] Refusal),
}

/// The file of a certificate, name and content, after a check of it.
///
/// Its theorem is the claim of the certificate to all its digits: a landmark, a state, that an arch stands, is too
/// thin, too wide or slides, or an asymmetric solution. A landmark has a corollary for each value that the paper prints
/// of it.
pub fn certificate(bytes: &[u8]) -> Result<(String, String), CertificateError> {
    verify(bytes)?;
    let certificate = Certificate::read(bytes)?;
    let Subject { name, title, term } = Subject::new(&certificate.claim);
    let theory = if certificate.claim.landmark.is_some() { "Landmarks" } else { "Sound" };
    let weight = capital(&certificate.claim.weight);
    let values = [
        ("title", title),
        ("theory", theory.to_owned()),
        ("subject", term.clone()),
        ("digits", certificate.digits.to_string()),
        ("unique", boxed(&certificate.unique)),
        ("inverse", rows(certificate.inverse.iter().map(|row| list(row.iter().map(dyadic))))),
        ("root", boxed(&certificate.root)),
        ("values", rows(certificate.values.iter().map(|v| value(v, certificate.digits)))),
    ];
    let template = include_str!("certificate.v").to_owned();
    let fill =
        |text: String, (hole, value): &(&str, String)| text.replace(&format!("<<{hole}>>"), value);
    let text = values.iter().fold(template, fill);
    Ok((format!("{name}{weight}.v"), text + &last_digit::corollaries(&certificate, &term)))
}

/// The subject of a claim.
struct Subject {
    /// Beginning of the file's name.
    name: String,
    /// Title for a reader.
    title: String,
    /// Term of Coq.
    term: String,
}

impl Subject {
    fn new(claim: &ClaimFile) -> Self {
        let weight = capital(&claim.weight);
        let arch = |half_opening: &str, friction: &str| {
            format!("(Arch {weight} {} {})", number(half_opening), coefficient(friction))
        };
        let of = |a: &ArchFile| arch(&a.half_opening, &a.friction);
        let subject = |name: &str, title: String, term: String| Self {
            name: name.to_owned(),
            title: format!("{title}, {weight}'s self-weight"),
            term,
        };
        if let Some(s) = &claim.state {
            let (mode, arch) = (mode(&s.mode), arch(&s.half_opening, &s.friction));
            let title = format!("An arch at its least thickness: [{}]", s.mode);
            return subject(&format!("State{mode}"), title, format!("State {mode} {arch}"));
        }
        if let Some(s) = &claim.too_thin {
            let (mode, arch) = (mode(&s.mode), arch(&s.half_opening, &s.friction));
            let term = format!("TooThin {mode} {arch} {}", number(&s.thickness));
            return subject("TooThin", "An arch that is too thin".into(), term);
        }
        if let Some(a) = &claim.slides {
            return subject("Slides", "An arch that slides".into(), format!("Slides {}", of(a)));
        }
        if let Some(a) = &claim.too_wide {
            return subject(
                "TooWide",
                "An arch that is too wide".into(),
                format!("TooWide {}", of(a)),
            );
        }
        if let Some(s) = &claim.stands {
            let nearest = capital(&s.nearest);
            let forces = format!("{} {}", dyadic(&s.thrust), dyadic(&s.crown_moment));
            let thickness = number(&s.thickness);
            let arch = arch(&s.half_opening, &s.friction);
            let term = format!("Stands {arch} {thickness} {forces} At{nearest}");
            return subject("Stands", "An arch that stands".into(), term);
        }
        if let Some(a) = &claim.asymmetric {
            let kind = match a.mode.as_str() {
                "inner_sliding" => "SlidesInside",
                "shoulder_opening" => "OpensAtShoulder",
                _ => "SlidesAlone",
            };
            let term = format!("Asymmetric {kind} {}", arch(&a.half_opening, &a.friction));
            let title = "An asymmetric solution of the complementarity problem (19)";
            return subject(&format!("Asymmetric{kind}"), title.into(), term);
        }
        let symbol = claim.landmark.as_deref().unwrap_or_default();
        let landmark = match symbol {
            "T" => "Triple",
            "S" => "Shift",
            "J" => "Junction",
            "B" => "Border",
            "l" => "RotationEnd",
            "L" => "OverturningEnd",
            _ => "WidestJoint",
        };
        let title = format!("The point {symbol}");
        subject(&format!("Landmark{landmark}"), title, format!("Landmark {landmark} {weight}"))
    }
}

fn mode(label: &str) -> &'static str {
    match label {
        "[r,r,r]" => "Rotational",
        "[s,r,r]" => "SlidingRotational",
        "[r,r,s]" => "RotationalSliding",
        "[r,s,r]" => "RotationalSlidingRotational",
        "[r,s]" => "OverturningSliding",
        _ => "Overturning",
    }
}

/// A name with its first letter large.
fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// An exact number of a claim: `49/20`, `1/2 pi`, `2 atan 3/5`.
fn number(text: &str) -> String {
    let (quotient, form) = match (text.strip_suffix(" pi"), text.strip_prefix("2 atan ")) {
        (Some(quotient), _) => (quotient, "TimesPi"),
        (None, Some(quotient)) => (quotient, "TwiceArctangent"),
        (None, None) => (text, "Fraction"),
    };
    format!("({form} {})", quotient.replace('/', " "))
}

/// A friction of a claim.
fn coefficient(text: &str) -> String {
    match (text, text.strip_prefix("tan ")) {
        ("inf", _) => "Unlimited".to_owned(),
        (_, Some(angle)) => format!("(Angle {})", number(angle)),
        _ => format!("(Coefficient {})", number(text)),
    }
}

fn dyadic(x: &Dyadic) -> String {
    let mantissa = Integer::from_digits(x.words(), Order::Lsf);
    let sign = if x.is_negative() { "-" } else { "" };
    format!("(Dyadic ({sign}{mantissa}) ({}))", x.exponent())
}

fn list(entries: impl Iterator<Item = String>) -> String {
    format!("[{}]", entries.collect::<Vec<_>>().join("; "))
}

/// A list with a line for each entry.
fn rows(entries: impl Iterator<Item = String>) -> String {
    format!("[ {} ]", entries.collect::<Vec<_>>().join(";\n      "))
}

fn boxed(witness: &Witness) -> String {
    let all = |numbers: &[Dyadic]| list(numbers.iter().map(dyadic));
    format!("(Box {}\n      {})", all(&witness.centre), all(&witness.radius))
}

/// A value as all its digits and a power of ten.
fn value(value: &ValueFile, digits: usize) -> String {
    let written = match decimal(&value.value, digits) {
        Some((all, exponent)) => format!("Decimal {all} ({exponent})"),
        None => "Infinite".to_owned(),
    };
    format!("({}, {written})", quantity(&value.quantity))
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
        assert_eq!(dyadic(&"-0x1f3p-12".parse().unwrap()), "(Dyadic (-499) (-12))");
    }
}
