//! A certificate of what the page shows, and its check: what is called proved there.
//!
//! The witnesses come from a candidate. The checker believes none of them; what it accepts is proved, and the file that
//! it accepted is the one that the page hands out.

use crate::candidate::{Candidate, candidate};
use crate::drawing::Drawing;
use crate::given::{Given, given};
use crate::question::Question;
use crate::rounding::{BITS, rounded, with_zeros};
use couplet_check::arch::{Configuration, Unknown};
use couplet_check::check::{
    Certificate, ClaimFile, Refusal, SCHEMA, ValueFile, Witness, check_certificate,
};
use couplet_check::problem::asymmetric_region::{LOOK, MAY_MOVE, STANDS, may_move_asymmetrically};
use couplet_check::problem::{Known, Mode, Problem, Quantity, Standing, Verdict};
use couplet_number::number::{
    AstroInterval, DoubleDouble, DoubleDoubleBall, Drawable, Dyadic, Enclosure, Engine, Ternary,
};
use couplet_solve as solve;
use serde::Serialize;
use std::collections::BTreeMap;

/// What is proved, or why not.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Answer {
    /// The checker accepts it.
    Proved(Box<Proved>),
    /// It does not.
    Open {
        /// Why.
        reason: String,
        /// The command that makes the certificate, if the arch can be read.
        command: Option<String>,
    },
}

/// What is proved of an arch.
#[derive(Debug, Default, Serialize)]
pub struct Proved {
    /// Of what: as it was asked.
    pub subject: String,
    /// How many digits the values of the state have.
    pub digits: usize,
    /// Values by their names, each a correct rounding.
    pub values: BTreeMap<&'static str, String>,
    /// Whether the arch stands with its thickness, if it has one: `None` if it is too near to the least to tell.
    pub stands: Option<bool>,
    /// What that says, if it has one and stands.
    pub meaning: Option<&'static str>,
    /// What it may do all the same, where an asymmetric mechanism is known of such arches; this page does not look for
    /// it.
    pub may_move: Option<String>,
    /// What may have been meant otherwise, as a friction of 31.
    pub note: Option<String>,
    /// Whether a line of thrust that fits its thickness is proved too.
    pub has_line: bool,
    /// The file, if it was wanted.
    pub certificate: Option<String>,
    /// The picture, if it was wanted and there is one.
    pub drawing: Option<String>,
    /// The command that makes the certificate.
    pub command: String,
}

impl Answer {
    /// What is proved of what was asked.
    pub fn of(question: &Question) -> Self {
        match proof(question) {
            Ok(proved) => Self::Proved(Box::new(proved)),
            Err(reason) => {
                let command = given(question).ok().map(|given| given.command());
                Self::Open { reason, command }
            }
        }
    }
}

/// Powers of two: the sides of the large box as parts of the root, tried in turn.
const LARGE: [i32; 4] = [-14, -20, -28, -40];
/// The same of the small box.
const SMALL: i32 = -78;

/// Proves it, by a certificate that the checker accepts.
pub fn proof(question: &Question) -> Result<Proved, String> {
    let given = given(question)?;
    let subject = subject(&question.subject, &given)?;
    let start = |unknown: &Unknown| question.start.get(unknown.name()).copied();
    let start: Option<Vec<f64>> = subject.system().unknowns.iter().map(start).collect();
    let certificate = certified(&subject, &start.ok_or("a start is missing")?, question.digits)?;
    let values = check::<DoubleDoubleBall>(&certificate)?;
    let at = enclosed(&subject, &certificate);
    let (digits, command) = (certificate.digits, given.command());
    let mut proved =
        Proved { digits, values, command, note: given.note.clone(), ..Proved::default() };
    proved.subject.clone_from(&question.subject);
    proved.values.extend(given.values(question.digits));
    let mode = match &subject {
        Problem::State { mode, .. } => Some(*mode),
        _ => None,
    };
    let least = mode.map(|_| &at.thickness);
    let eta: Option<DoubleDoubleBall> = given.thickness.as_ref().map(|eta| eta.enclosure(BITS));
    if let (Some(measures), Some(least)) = (&given.measures, least) {
        let sizes = measures.sizes(least, &at.half_opening.rad, BITS);
        let found = [("least_thickness_m", sizes.thickness), ("radius_m", sizes.radius)];
        for (name, size) in found {
            // With a thickness the radius is that of the arch, not of the least one.
            if let Some(size) = rounded(&size, question.digits) {
                proved.values.entry(name).or_insert(size);
            }
        }
    }
    // From the least thickness on it stands.
    proved.stands = match (eta, least) {
        (None, _) => None,
        (Some(_), None) => Some(false),
        (Some(eta), Some(least)) => match (eta - least).is_positive() {
            Ternary::True => Some(true),
            Ternary::False => Some(false),
            Ternary::Undecided => None,
        },
    };
    proved.meaning = (proved.stands == Some(true)).then_some(STANDS);
    let stands = mode.is_some() && proved.stands != Some(false);
    proved.may_move = (stands && may_move_asymmetrically(&given.arch)).then(|| {
        format!("Asymmetric mechanisms are known at such half openings and frictions: {MAY_MOVE} ({LOOK}).")
    });
    if let (Some(eta), Some(least)) = (eta, least) {
        proved.values.extend(with_zeros(&(eta / least), SAFETY).map(|x| ("geometric_safety", x)));
    }
    // The line of thrust of an arch that stands has a certificate of its own.
    let stands = match (proved.stands, eta) {
        (Some(true), Some(eta)) => standing(&given, &at, eta, question.digits).ok(),
        _ => None,
    };
    proved.has_line = stands.is_some();
    if let Some(how) = &question.drawing {
        let (arch, moves) = (&given.arch, how == "moving");
        let at = match eta {
            Some(eta) => at.clone().with(Unknown::Thickness, eta),
            None => at.clone(),
        };
        // What slides has a friction of its own in its proof.
        let at = at.with(Unknown::Friction, arch.given(BITS).friction);
        let slides = matches!(&subject, Problem::Verdict { verdict: Verdict::Slides, .. });
        let falls = mode.or(slides.then_some(Mode::Sliding));
        let falls = falls.filter(|_| proved.stands == Some(false));
        let (weight, is_limited) = (arch.weight(), arch.is_limited());
        let drawing = |at| Drawing { weight, at, is_limited, title: "The arch" };
        proved.drawing = match (eta, mode, &stands) {
            (None, Some(mode), _) => drawing(&at).state(mode, moves),
            (Some(_), _, Some((line, _))) => {
                let moment = Engine::exact(&line.crown_moment, BITS as usize);
                let at = at.with(Unknown::Thrust, Engine::exact(&line.thrust, BITS as usize));
                Some(drawing(&at).standing(moment))
            }
            (Some(_), _, None) => {
                let falling = falls.and_then(|mode| drawing(&at).falling(mode, moves));
                falling.or_else(|| mode.map(|_| drawing(&at).bare()))
            }
            _ => None,
        };
    }
    if question.file {
        let file = match (proved.stands, mode, &given.thickness) {
            (Some(true), ..) => {
                let found = stands.map(|(_, certificate)| certificate);
                found.ok_or("no line of thrust inside the arch is found here")?
            }
            (Some(false), Some(mode), Some(thickness)) => {
                let verdict = Verdict::TooThin { mode, thickness: thickness.clone() };
                let problem = Problem::Verdict { verdict, arch: given.arch.clone() };
                let start: Vec<f64> =
                    subject.system().values(&at).iter().map(Drawable::double).collect();
                certified(&problem, &start, question.digits)?
            }
            (None, Some(_), Some(_)) => return Err("the thickness is too near to the least".into()),
            _ => certificate,
        };
        // In the second arithmetic too.
        check::<AstroInterval>(&file)?;
        proved.certificate = Some(written(&file)?);
    }
    Ok(proved)
}

/// Digits of a safety.
const SAFETY: usize = 4;

fn subject(name: &str, given: &Given) -> Result<Problem, String> {
    let arch = given.arch.clone();
    Ok(match name {
        "slides" => Problem::Verdict { verdict: Verdict::Slides, arch },
        "too_wide" => Problem::Verdict { verdict: Verdict::TooWide, arch },
        name => {
            let mode = Mode::named(name).ok_or("there is no such subject")?;
            Problem::State { mode, arch }
        }
    })
}

/// A line of thrust inside an arch that is thicker than its least thickness, and the certificate of it.
fn standing(
    given: &Given,
    least: &Configuration<DoubleDoubleBall>,
    eta: DoubleDoubleBall,
    digits: usize,
) -> Result<(Standing, Certificate), String> {
    let arch = &given.arch;
    let thickness = given.thickness.as_ref().ok_or("no thickness is given")?;
    let at = least.map_ref(Drawable::double).with(Unknown::Thickness, eta.double());
    let line = solve::standing(arch.weight(), &at, arch.is_limited(), &least.thrust.double());
    let line = line.ok_or("no line of thrust inside the arch is found here")?;
    let (found, start) = line.stated(thickness);
    let verdict = Verdict::Stands(found.clone());
    let problem = Problem::Verdict { verdict, arch: arch.clone() };
    Ok((found, certified(&problem, &start, digits)?))
}

/// A certificate with as many of these digits as are decided, accepted in balls of double-doubles.
fn certified(problem: &Problem, start: &[f64], digits: usize) -> Result<Certificate, String> {
    let found = candidate(problem, start).ok_or("no candidate was found")?;
    let mut last = String::new();
    for digits in (1..=digits.min(16)).rev() {
        match accepted(problem, &found, digits) {
            Err(rounding @ Refusal::Rounding(_)) => last = rounding.to_string(),
            found => return found.map_err(|refusal| refusal.to_string()),
        }
    }
    Err(last)
}

/// Where the root of a certificate is proved to be.
fn enclosed(problem: &Problem, certificate: &Certificate) -> Configuration<DoubleDoubleBall> {
    let bits = BITS as usize;
    let sides = certificate.root.centre.iter().zip(&certificate.root.radius);
    let root: Vec<DoubleDoubleBall> = sides
        .map(|(centre, radius)| {
            <DoubleDoubleBall as Engine>::exact(centre, bits).widened_by(radius)
        })
        .collect();
    problem.system().place(problem.given(BITS), &root)
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
    let centre: Vec<Dyadic> = found.root.iter().map(|x| (*x).into()).collect();
    let witness = |power: i32| {
        // A power of two has one bit.
        let side =
            |x: &DoubleDouble| (x.hi().abs().max(1e-9).log2().floor() + f64::from(power)).exp2();
        let radius = found.root.iter().map(|x| side(x).into()).collect();
        Witness { centre: centre.clone(), radius }
    };
    let row = |row: &Vec<f64>| row.iter().map(|x| (*x).into()).collect();
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

/// Its values, if the checker accepts it.
fn check<E: Engine>(certificate: &Certificate) -> Result<BTreeMap<&'static str, String>, String> {
    let accepted = check_certificate::<E>(certificate, certificate.digits);
    let accepted = accepted.map_err(|refusal| refusal.to_string())?;
    Ok(accepted.values.into_iter().map(|(of, value)| (of.name(), value)).collect())
}

fn written(certificate: &Certificate) -> Result<String, String> {
    let mut bytes = Vec::new();
    certificate.write(&mut bytes).map_err(|error| error.to_string())?;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checked;

    fn question(arch: [&str; 3], subject: &str, start: &[(&str, f64)]) -> Question {
        let [weight, half_opening, friction] = arch.map(str::to_owned);
        let start = start.iter().map(|(name, x)| ((*name).to_owned(), *x)).collect();
        let (subject, half_opening) = (subject.to_owned(), Some(half_opening));
        let friction = Some(friction);
        let question = Question { weight, half_opening, friction, ..Question::default() };
        Question { subject, start, digits: 12, file: true, ..question }
    }

    const RIGHT: [&str; 3] = ["heyman", "90deg", "0.38"];
    const START: [(&str, f64); 3] =
        [("rotation_joint", 0.96), ("thickness", 0.122), ("thrust", 0.6)];

    fn sentence(proved: &Proved) -> String {
        let checked = checked(proved.certificate.as_ref().unwrap().as_bytes());
        assert!(checked.accepted, "{}", checked.sentence);
        checked.sentence
    }

    #[test]
    fn a_state_is_proved_from_a_rough_start() {
        let found = proof(&question(RIGHT, "[s,r,r]", &START)).unwrap();
        assert_eq!((found.digits, &found.values["thickness"][..]), (12, "0.122191586363"));
        assert!(sentence(&found).contains("[s,r,r]"));
    }

    /// As the command does for 2.3 and 1.05, without the thickness of the mechanism.
    #[test]
    fn an_arch_of_which_a_mechanism_is_known_may_move() {
        let start = [("rotation_joint", 1.104), ("thickness", 0.513), ("thrust", 0.186)];
        let of =
            |mu: &str| proof(&question(["milankovitch", "2.3", mu], "[s,r,r]", &start)).unwrap();
        assert!(of("1.05").may_move.unwrap().contains("dilatancy"));
        assert_eq!(of("1.02495").meaning, None);
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

    /// The verdict is that of the least thickness, 0.12219, and each has its certificate; next to it there is none.
    #[test]
    fn a_thickness_is_enough_or_not_enough_with_a_certificate() {
        let of = |thickness: &str| {
            let thickness = Some(thickness.to_owned());
            let drawing = Some("moving".to_owned());
            proof(&Question { thickness, drawing, ..question(RIGHT, "[s,r,r]", &START) })
        };
        for (thickness, safety) in [("0.1222", "1.000"), ("0.2", "1.637"), ("1.9", "15.55")] {
            let found = of(thickness).unwrap();
            assert_eq!((found.stands, &found.values["geometric_safety"][..]), (Some(true), safety));
            assert!(
                sentence(&found)
                    .contains("stands (an admissible symmetric state exists) half_opening")
            );
            assert_eq!((found.meaning, found.may_move), (Some(STANDS), None));
            let drawing = found.drawing.unwrap();
            assert!(drawing.contains("id=\"thrust\"") && !drawing.contains("mechanism"));
        }
        for thickness in ["0.122", "0.01"] {
            let found = of(thickness).unwrap();
            assert_eq!(found.stands, Some(false));
            assert!(sentence(&found).contains("does not stand"));
            let drawing = found.drawing.unwrap();
            assert!(drawing.contains("id=\"thrust\"") && drawing.contains("<animateTransform"));
        }
        // The least thickness to 40 digits: this arithmetic does not tell on which side it is.
        assert!(of("0.1221915863625461515247988393786000989752").unwrap_err().contains("too near"));
        assert!(of("2.1").is_err() && of("0").is_err() && of("x").is_err());
    }

    #[test]
    fn an_arch_is_given_by_its_span_and_rise_too() {
        let start = [("rotation_joint", 0.7), ("thickness", 0.0258), ("thrust", 0.81)];
        let of = |span: &str, rise: &str, thickness: &str| {
            let (span, rise) = (Some(span.to_owned()), Some(rise.to_owned()));
            let thickness = Some(thickness.to_owned());
            let question = question(["heyman", "1", "0.6"], "[r,r,r]", &start);
            proof(&Question { half_opening: None, span, rise, thickness, ..question })
        };
        let found = of("10m", "3m", "60cm").unwrap();
        for (name, value) in [
            ("given_half_opening_degrees", "61.9275130641"),
            ("radius_m", "5.96666666667"),
            ("least_thickness_m", "0.148120669442"),
            ("given_thickness", "0.100558659218"),
            ("given_thickness_m", "0.6"),
            ("geometric_safety", "3.897"),
        ] {
            assert_eq!(found.values[name], value, "{name}");
        }
        assert!(sentence(&found).contains("2 atan 3/5"));
        assert!(found.command.ends_with(
            "--half-opening '2atan(3/5)' --friction 0.6 --thickness 18/179 -o arch.json"
        ));
        let ratio = of("10m", "3m", "18/179r").unwrap();
        assert_eq!(ratio.values["given_thickness_m"], "0.6");
        assert!(of("10", "3m", "60cm").is_err());
        let error = of("10m", "3m", "0.6").unwrap_err();
        assert!(error.contains("0.6m") && error.contains("0.6r"), "{error}");
    }

    #[test]
    fn the_picture_has_the_blocks_of_the_mode_and_moves_if_asked() {
        let of = |drawing: &str| {
            let drawing = Some(drawing.to_owned());
            proof(&Question { drawing, ..question(RIGHT, "[s,r,r]", &START) }).unwrap().drawing
        };
        let (still, moving) = (of("still").unwrap(), of("moving").unwrap());
        // Two blocks of each half; a hinge at each haunch and at the crown, both shoulders slide.
        assert_eq!(still.matches("<g transform=").count(), 4);
        assert_eq!(still.matches("<circle").count(), 3);
        assert!(!still.contains("animate") && moving.matches("<animateTransform").count() == 8);
    }

    #[test]
    fn too_little_friction_is_proved() {
        let start = [("friction", 0.31), ("thrust", 0.66), ("sliding_joint", 0.47)];
        let slides = |mu| proof(&question(["heyman", "90deg", mu], "slides", &start));
        let found = slides("0.3").unwrap();
        assert!(found.values["friction"].starts_with("0.309"), "{:?}", found.values);
        let of = question(["heyman", "90deg", "0.3"], "slides", &start);
        let (thickness, drawing) = (Some("0.2".to_owned()), Some("still".to_owned()));
        let drawing = proof(&Question { thickness, drawing, ..of }).unwrap().drawing.unwrap();
        assert_eq!(drawing.matches("<g transform=").count(), 4, "two blocks of each half");
        assert!(slides("0.31").is_err());
    }

    /// Beyond B the friction with which it slides is not enough, beyond L none is: what the page adds to a proof that
    /// it slides.
    #[test]
    fn more_friction_is_proved_not_to_help() {
        let of = |alpha, mu, subject, start: &[(&str, f64)]| {
            proof(&question(["milankovitch", alpha, mu], subject, start))
        };
        let start = [("friction", 2.26), ("thrust", 0.0427), ("sliding_joint", 0.2)];
        let slides = of("155.2deg", "0.9", "slides", &start).unwrap();
        assert!(slides.values["friction"].starts_with("2.25996463"), "{:?}", slides.values);
        let start = [("half_opening", 2.64), ("thrust", 0.0427), ("sliding_joint", 0.2)];
        for mu in ["inf", "2.259964657"] {
            assert!(of("155.2deg", mu, "too_wide", &start).is_ok(), "{mu}");
        }
        // Short of L friction helps, and short of B that with which it slides.
        for (alpha, mu) in [("151.5deg", "inf"), ("149deg", "2")] {
            assert!(of(alpha, mu, "too_wide", &start).is_err(), "{alpha}");
        }
    }

    /// The limit is not what is given.
    #[test]
    fn too_wide_an_arch_is_proved_beyond_the_limit() {
        let start = [("half_opening", 2.65)];
        let found = proof(&question(["milankovitch", "3", "inf"], "too_wide", &start)).unwrap();
        let [limit, given] = ["half_opening", "given_half_opening"].map(|name| &found.values[name]);
        assert!(limit.starts_with("2.648388") && given == "3", "{:?}", found.values);
    }
}
