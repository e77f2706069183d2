//! The file of a certificate: the numbers of it, and that the verified checker accepts them.
//!
//! Coq computes that by itself, so that nothing here is trusted: what is claimed is `claim_of` of
//! `proofs/coq/verified/Certificate.v`.

use super::value::{capital, coefficient, decimal, list, number, quantity, rows};
use super::{last_digit, survey};
use crate::check::{
    AcceptedFile, ArchFile, Certificate, ClaimFile, Refusal, SurveyCertificate, ValueFile, Witness,
    verify_file,
};
use crate::number::Dyadic;
use crate::problem::{Landmark, Mode};
use rug::Integer;
use rug::integer::Order;

/// The file of a certificate, name and content, after a check of it; an error if the checker does not accept it.
///
/// Its theorem is the claim of the certificate to all its digits: a landmark, a state, that an arch stands, is too
/// thin, too wide or slides, an asymmetric solution, or a verdict on all arches of a survey. A landmark has a corollary
/// for each value that the paper prints of it.
pub fn certificate(bytes: &[u8]) -> Result<(String, String), Refusal> {
    let (name, title, weight, kinds, term, rest) = match verify_file(bytes)? {
        AcceptedFile::Survey(_) => {
            let certificate = SurveyCertificate::read(bytes)?;
            let name = format!("Survey{}", survey::verdict(&certificate));
            let title = "All arches of a survey".to_owned();
            let weight = capital(&certificate.survey.weight);
            let kinds = ["SurveySound", "survey_certificate", "claim_of_survey", "sound_survey"];
            (name, title, weight, kinds, survey::term(&certificate, term), String::new())
        }
        AcceptedFile::Certificate(_) => {
            let certificate = Certificate::read(bytes)?;
            let [name, title, subject] = subject(&certificate.claim);
            let is_landmark = certificate.claim.landmark.is_some();
            let theory = if is_landmark { "Landmarks" } else { "Sound" };
            let kinds = [theory, "certificate", "claim_of", "sound"];
            let weight = capital(&certificate.claim.weight);
            let rest = last_digit::corollaries(&certificate, &subject);
            (name, title, weight, kinds, term(&certificate), rest)
        }
    };
    let [theory, kind, claim, theorem] = kinds;
    let values = [
        ("title", format!("{title}, {weight}'s self-weight")),
        ("theory", theory.to_owned()),
        ("type", kind.to_owned()),
        ("term", term),
        ("claim", claim.to_owned()),
        ("theorem", theorem.to_owned()),
    ];
    let template = include_str!("certificate.v").to_owned();
    let fill =
        |text: String, (hole, value): &(&str, String)| text.replace(&format!("<<{hole}>>"), value);
    Ok((format!("{name}{weight}.v"), values.iter().fold(template, fill) + &rest))
}

/// A certificate of one landmark or arch.
fn term(certificate: &Certificate) -> String {
    format!(
        "Certificate ({}) {}\n    {}\n    {}\n    {}\n    {}",
        subject(&certificate.claim)[2],
        certificate.digits,
        boxed(&certificate.unique),
        list(certificate.inverse.iter().map(|row| list(row.iter().map(dyadic)))),
        boxed(&certificate.root),
        rows(certificate.values.iter().map(|v| value(v, certificate.digits))),
    )
}

/// The subject of a claim: beginning of the file's name, title for a reader, and term of Coq, which names modes and
/// landmarks as the variants of [`Mode`] and [`Landmark`].
fn subject(claim: &ClaimFile) -> [String; 3] {
    let weight = capital(&claim.weight);
    let arch = |half_opening: &str, friction: &str| {
        format!("(Arch {weight} {} {})", number(half_opening), coefficient(friction))
    };
    let of = |a: &ArchFile| arch(&a.half_opening, &a.friction);
    let mode = |label: &str| Mode::named(label).map_or(String::new(), |mode| format!("{mode:?}"));
    let told = |name: &str, title: &str, term: String| [name.to_owned(), title.to_owned(), term];
    if let Some(s) = &claim.state {
        let (mode, arch) = (mode(&s.mode), arch(&s.half_opening, &s.friction));
        let title = format!("An arch at its least thickness: [{}]", s.mode);
        return told(&format!("State{mode}"), &title, format!("State {mode} {arch}"));
    }
    if let Some(s) = &claim.too_thin {
        let (mode, arch) = (mode(&s.mode), arch(&s.half_opening, &s.friction));
        let term = format!("TooThin {mode} {arch} {}", number(&s.thickness));
        return told("TooThin", "An arch that is too thin", term);
    }
    if let Some(a) = &claim.slides {
        return told("Slides", "An arch that slides", format!("Slides {}", of(a)));
    }
    if let Some(a) = &claim.too_wide {
        return told("TooWide", "An arch that is too wide", format!("TooWide {}", of(a)));
    }
    if let Some(s) = &claim.stands {
        let nearest = capital(&s.nearest);
        let forces = format!("{} {}", dyadic(&s.thrust), dyadic(&s.crown_moment));
        let thickness = number(&s.thickness);
        let arch = arch(&s.half_opening, &s.friction);
        let term = format!("Stands {arch} {thickness} {forces} At{nearest}");
        return told("Stands", "An arch that stands", term);
    }
    if let Some(a) = &claim.asymmetric {
        let kind = match a.mode.as_str() {
            "inner_sliding" => "SlidesInside",
            "shoulder_opening" => "OpensAtShoulder",
            _ => "SlidesAlone",
        };
        let term = format!("Asymmetric {kind} {}", arch(&a.half_opening, &a.friction));
        let title = "An asymmetric solution of the complementarity problem (19)";
        return told(&format!("Asymmetric{kind}"), title, term);
    }
    let symbol = claim.landmark.as_deref().unwrap_or_default();
    let landmark = Landmark::named(symbol).map_or(String::new(), |point| format!("{point:?}"));
    let title = format!("The point {symbol}");
    told(&format!("Landmark{landmark}"), &title, format!("Landmark {landmark} {weight}"))
}

fn dyadic(x: &Dyadic) -> String {
    let mantissa = Integer::from_digits(x.words(), Order::Lsf);
    let sign = if x.is_negative() { "-" } else { "" };
    format!("(Dyadic ({sign}{mantissa}) ({}))", x.exponent())
}

fn boxed(witness: &Witness) -> String {
    let all = |numbers: &[Dyadic]| list(numbers.iter().map(dyadic));
    format!("(Box {} {})", all(&witness.centre), all(&witness.radius))
}

/// A value as all its digits and a power of ten.
fn value(value: &ValueFile, digits: usize) -> String {
    let written = if value.value == "inf" {
        "Infinite".to_owned()
    } else {
        // What is no number is no term, which Coq refuses.
        let (all, exponent) = decimal(&value.value, digits).unwrap_or_default();
        format!("Decimal {all} ({exponent})")
    };
    format!("({}, {written})", quantity(&value.quantity))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dyadic_number_is_a_mantissa_and_a_power() {
        assert_eq!(dyadic(&"-0x1f3p-12".parse().unwrap()), "(Dyadic (-499) (-12))");
    }
}
