//! A certificate of what the page shows, and its check: what is called proved there.
//!
//! The witnesses come from a candidate. The checker believes none of them; what it accepts is proved, and the file that
//! it accepted is the one that the page hands out.

use crate::candidate::{Candidate, candidate, dyadic};
use couplet::arch::Unknown;
use couplet::check::{
    Certificate, ClaimFile, Refusal, SCHEMA, ValueFile, Witness, check_certificate,
};
use couplet::number::{AstroInterval, DoubleDouble, DoubleDoubleBall};
use couplet::problem::{Arch, Known, Mode, Problem, Quantity, Verdict};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What is to be proved of an arch, in texts that the command line reads too, and where its root seems to be.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// `heyman` or `milankovitch`.
    pub weight: String,
    /// In radians, or with `deg` or `pi`.
    pub half_opening: String,
    /// A coefficient, an angle in degrees, or `inf`.
    pub friction: String,
    /// The label of a mode, `slides` or `too_wide`.
    pub subject: String,
    /// A thickness, which the least one of the mode is said to be above.
    pub thickness: Option<String>,
    /// A start for each unknown, by its name.
    pub start: BTreeMap<String, f64>,
    /// How many digits are wanted; fewer are given where these are not decided.
    pub digits: usize,
    /// Whether the certificate is wanted, checked in the second arithmetic too.
    pub file: bool,
}

/// What is proved, or why not.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Answer {
    /// The checker accepts it.
    Proved {
        /// How many digits the values have.
        digits: usize,
        /// The values, correctly rounded, by their names.
        values: BTreeMap<&'static str, String>,
        /// The file, if it was wanted.
        certificate: Option<String>,
    },
    /// It does not.
    Open {
        /// Why.
        reason: String,
    },
}

impl From<Result<Answer, String>> for Answer {
    fn from(found: Result<Answer, String>) -> Self {
        found.unwrap_or_else(|reason| Self::Open { reason })
    }
}

/// Powers of two: the sides of the large box as parts of the root, tried in turn.
const LARGE: [i32; 4] = [-14, -20, -28, -40];
/// The same of the small box.
const SMALL: i32 = -78;

/// Proves it, by a certificate that the checker accepts.
pub fn proof(question: &Question) -> Result<Answer, String> {
    let problem = problem(question)?;
    let unknowns = problem.system().unknowns;
    let start = |unknown: &Unknown| question.start.get(unknown.name()).copied();
    let start: Option<Vec<f64>> = unknowns.iter().map(start).collect();
    let start = start.ok_or("a start is missing")?;
    let found = candidate(&problem, &start).ok_or("no candidate was found")?;
    let mut last = String::new();
    for digits in (1..=question.digits.min(16)).rev() {
        match accepted(&problem, &found, digits) {
            Ok(certificate) => return answer(certificate, question.file),
            Err(rounding @ Refusal::Rounding(_)) => last = rounding.to_string(),
            Err(refusal) => return Err(refusal.to_string()),
        }
    }
    Err(last)
}

fn problem(question: &Question) -> Result<Problem, String> {
    let Question { weight, half_opening, friction, subject, .. } = question;
    let arch = Arch::parse(weight, half_opening, friction).map_err(|error| error.to_string())?;
    let verdict = |verdict| Problem::Verdict { verdict, arch: arch.clone() };
    match &subject[..] {
        "slides" => return Ok(verdict(Verdict::Slides)),
        "too_wide" => return Ok(verdict(Verdict::TooWide)),
        _ => {}
    }
    let mode = Mode::named(subject).ok_or("there is no such subject")?;
    let Some(thickness) = &question.thickness else {
        return Ok(Problem::State { mode, arch });
    };
    let thickness = thickness.parse().map_err(|error| format!("thickness: {error}"))?;
    Ok(verdict(Verdict::TooThin { mode, thickness }))
}

/// The certificate with the largest box that is accepted, in balls of double-doubles.
fn accepted(problem: &Problem, found: &Candidate, digits: usize) -> Result<Certificate, Refusal> {
    let mut last = Refusal::NoValues;
    for large in LARGE {
        let certificate = certificate(problem, found, digits, large);
        match check_certificate::<DoubleDoubleBall>(&certificate, digits) {
            Ok(_) => return Ok(certificate),
            Err(refusal @ (Refusal::Contraction { .. } | Refusal::Denominator(_))) => {
                last = refusal
            }
            Err(refusal) => return Err(refusal),
        }
    }
    Err(last)
}

fn certificate(problem: &Problem, found: &Candidate, digits: usize, large: i32) -> Certificate {
    let centre: Vec<_> = found.root.iter().map(|x| dyadic(*x)).collect();
    let witness = |power: i32| {
        // A power of two has one bit.
        let side =
            |x: &DoubleDouble| (x.hi().abs().max(1e-9).log2().floor() + f64::from(power)).exp2();
        let radius = found.root.iter().map(|x| dyadic(DoubleDouble::exact(side(x)))).collect();
        Witness { centre: centre.clone(), radius }
    };
    let row = |row: &Vec<f64>| row.iter().map(|x| dyadic(DoubleDouble::exact(*x))).collect();
    Certificate {
        schema: SCHEMA.to_owned(),
        tool: concat!("couplet-page ", env!("CARGO_PKG_VERSION")).to_owned(),
        claim: ClaimFile::new(problem),
        digits,
        unique: witness(large),
        inverse: found.inverse.iter().map(row).collect(),
        root: witness(SMALL),
        values: values(problem, found, digits),
    }
}

/// The decimals claimed; the checker says whether they are the correct roundings.
fn values(problem: &Problem, found: &Candidate, digits: usize) -> Vec<ValueFile> {
    let quantities = Quantity::LANDMARK.into_iter().filter(|of| problem.has(*of));
    let value = |of: Quantity| {
        let Some(Known::Enclosed(x)) = problem.known(of, &found.at) else { return None };
        let x = match of.in_radians() {
            Some(_) => x.mid().hi().to_degrees(),
            None => x.mid().hi(),
        };
        let value = if x == 0.0 { "0".to_owned() } else { format!("{x:.*e}", digits - 1) };
        Some(ValueFile { quantity: of.name().to_owned(), value })
    };
    quantities.filter_map(value).collect()
}

fn answer(certificate: Certificate, file: bool) -> Result<Answer, String> {
    let engine = match file {
        true => check_certificate::<AstroInterval>,
        false => check_certificate::<DoubleDoubleBall>,
    };
    let accepted =
        engine(&certificate, certificate.digits).map_err(|refusal| refusal.to_string())?;
    let values = accepted.values.into_iter().map(|(of, value)| (of.name(), value)).collect();
    let text = || {
        let mut bytes = Vec::new();
        certificate.write(&mut bytes).ok()?;
        String::from_utf8(bytes).ok()
    };
    Ok(Answer::Proved {
        digits: certificate.digits,
        values,
        certificate: if file { text() } else { None },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checked;

    fn question(arch: [&str; 3], subject: &str, start: &[(&str, f64)]) -> Question {
        let [weight, half_opening, friction] = arch.map(str::to_owned);
        let start = start.iter().map(|(name, x)| ((*name).to_owned(), *x)).collect();
        let subject = subject.to_owned();
        Question {
            weight,
            half_opening,
            friction,
            subject,
            thickness: None,
            start,
            digits: 12,
            file: true,
        }
    }

    const RIGHT: [&str; 3] = ["heyman", "90deg", "0.38"];
    const START: [(&str, f64); 3] =
        [("rotation_joint", 0.96), ("thickness", 0.122), ("thrust", 0.6)];

    #[test]
    fn a_state_is_proved_from_a_rough_start() {
        let Answer::Proved { digits, values, certificate } =
            proof(&question(RIGHT, "[s,r,r]", &START)).unwrap()
        else {
            panic!()
        };
        assert_eq!((digits, &values["thickness"][..]), (12, "0.122191586363"));
        assert!(checked(certificate.unwrap().as_bytes()).accepted);
    }

    #[test]
    fn what_is_not_so_is_not_proved() {
        for (arch, subject) in
            [(RIGHT, "[r,r,r]"), (["heyman", "90deg", "0.6"], "[s,r,r]"), (RIGHT, "[x]")]
        {
            assert!(proof(&question(arch, subject, &START)).is_err(), "{subject}");
        }
        assert!(proof(&question(RIGHT, "[s,r,r]", &START[..2])).is_err(), "no start");
    }

    #[test]
    fn a_thinner_arch_is_proved_too_thin_and_no_other() {
        let thin = |thickness: &str| {
            let thickness = Some(thickness.to_owned());
            proof(&Question { thickness, ..question(RIGHT, "[s,r,r]", &START) })
        };
        assert!(thin("0.122").is_ok());
        assert!(thin("0.1222").is_err());
    }

    #[test]
    fn too_little_friction_is_proved() {
        let start = [("friction", 0.31), ("thrust", 0.66), ("sliding_joint", 0.47)];
        let slides = |mu| proof(&question(["heyman", "90deg", mu], "slides", &start));
        let Answer::Proved { values, .. } = slides("0.3").unwrap() else { panic!() };
        assert!(values["friction"].starts_with("0.309"), "{values:?}");
        assert!(slides("0.31").is_err());
    }
}
