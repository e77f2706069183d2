//! The claims of certificates by statics alone: forces and moments on blocks cut out of the ring, with enclosures of their
//! own. Nothing that judges reads an equation of the paper, which the solver and every checker have from one text.

mod ball;
mod decide;
mod file;
mod found;
mod judge;
mod made;
mod ring;

use couplet_check::arch::SelfWeight;
use couplet_check::check::{Certificate, check_file};
use couplet_check::problem::{Arch, Mode, Nearest, Problem, Standing, Verdict};
use couplet_number::number::{AstroInterval, Dyadic, ExactNumber};
use found::{Found, found};
use judge::{judge, judge_once};
use made::made;
use rug::{Float, Integer, Rational};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::PathBuf;

const PROOFS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../proofs");

fn stored(folder: &str) -> Vec<(String, Value)> {
    let files = std::fs::read_dir(format!("{PROOFS}/{folder}")).unwrap();
    let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|end| end == "json"));
    files.sort();
    let read = |path: &PathBuf| serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    files.iter().map(|path| (path.display().to_string(), read(path))).collect()
}

/// Those of arches, and each part of a survey.
#[test]
fn stored_certificates_of_arches_are_right() {
    for (name, json) in stored("states") {
        assert_eq!(judge(&json), Ok(()), "{name}");
    }
    for (name, json) in stored("surveys") {
        for part in json["parts"].as_array().unwrap() {
            assert_eq!(judge(&part["certificate"]), Ok(()), "{name}");
        }
    }
}

/// A sequence of numbers, always the same.
struct Numbers(u64);

impl Numbers {
    /// From 0 to below 1.
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() * n as f64) as usize
    }

    /// A hair, of any size down to 1e-12.
    fn hair(&mut self) -> Rational {
        Rational::from_f64(10f64.powf(-12.0 * self.next())).unwrap()
    }
}

fn exact(x: &Rational) -> ExactNumber {
    format!("{}/{}", x.numer(), x.denom()).parse().unwrap()
}

/// A number of twelve places.
fn short(x: &Rational) -> Rational {
    let twelve = Integer::from(Integer::u_pow_u(10, 12));
    Rational::from((Integer::from(x.numer() * &twelve) / x.denom(), twelve))
}

/// A random arch: ordinary, flat, or one that needs nearly the friction it has.
fn arch(numbers: &mut Numbers) -> (SelfWeight, Rational, Option<Rational>) {
    let weight = SelfWeight::ALL[numbers.below(2)];
    let alpha = match numbers.below(6) {
        0 => 10f64.powf(-3.0 * numbers.next()),
        1 => 2.2 + 0.6 * numbers.next(),
        2 => 2.4 + 0.5 * numbers.next(),
        _ => 0.3 + 2.4 * numbers.next(),
    };
    let mu = match numbers.below(6) {
        0 => None,
        1 => Some(5.0 * numbers.next()),
        _ => Some(2.0 * numbers.next()),
    };
    let rational = |x: f64| short(&Rational::from_f64(x).unwrap());
    (weight, rational(alpha), mu.map(rational))
}

/// The certificate of a random arch, as the checker accepts it.
fn certificate(numbers: &mut Numbers) -> Result<Value, String> {
    let (weight, alpha, mut mu) = arch(numbers);
    let small = alpha.denom().significant_bits().saturating_sub(alpha.numer().significant_bits());
    let bits = 160 + 12 * small;
    let ball = |x: &Rational| ball::Ball::new(x, bits);
    let heavy = weight == SelfWeight::Milankovitch;
    if let Some(mu) = mu.as_mut().filter(|_| numbers.below(3) > 0) {
        // Between what pure sliding asks for and somewhat more.
        let least = &found(heavy, &ball(&alpha), Some(&ball(&Rational::new())))?.values["friction"];
        let more = Rational::from_f64(0.7 * numbers.next().powi(2)).unwrap();
        *mu = short(&(least * more + least));
    }
    let Found { subject, values } = found(heavy, &ball(&alpha), mu.as_ref().map(ball).as_ref())?;
    let digits = 8 + numbers.below(20);
    if subject == "slides" && numbers.below(2) == 0 {
        // Hardly too little friction.
        let least = &values["friction"];
        mu = Some(short(&(least - least * numbers.hair())));
    }
    let friction = mu.as_ref().map_or("inf".into(), |mu| format!("{}/{}", mu.numer(), mu.denom()));
    let arch = Arch::new(weight, exact(&alpha), friction.parse().unwrap()).unwrap();
    let verdict = |verdict| Problem::Verdict { verdict, arch: arch.clone() };
    let accepted = |certificate: Certificate| {
        let bytes = serde_json::to_vec(&certificate).unwrap();
        check_file::<AstroInterval>(&bytes, 60)
            .map_err(|refusal| format!("{subject}: {refusal}"))?;
        Ok(serde_json::from_slice(&bytes).unwrap())
    };
    let at_root = |problem: &Problem| {
        accepted(made(problem, &values, digits).ok_or(format!("{subject}: no root"))?)
    };
    // A root of another mode's equations is no state: if the checker takes it for one, it is judged.
    for mode in Mode::ALL.into_iter().filter(|mode| mode.label() != subject) {
        let mut values = values.clone();
        let half = Rational::from(&alpha / 2);
        for (name, start) in [("rotation_joint", half.clone()), ("sliding_joint", half / 2)] {
            values.entry(name).or_insert(start);
        }
        values.entry("thickness").or_insert(Rational::from(1));
        if mode.exists_with(mu.is_some()) && mode != Mode::Sliding {
            let other = made(&Problem::State { mode, arch: arch.clone() }, &values, digits);
            if let Some(Ok(json)) = other.map(accepted) {
                return Ok(json);
            }
        }
    }
    let Some(mode) = Mode::named(subject) else {
        return at_root(&verdict(if subject == "slides" {
            Verdict::Slides
        } else {
            Verdict::TooWide
        }));
    };
    let least = values["thickness"].clone();
    match numbers.below(4) {
        0 => {
            let thickness = &least - &least * numbers.hair();
            if thickness <= 0 {
                return Err("no thickness".into());
            }
            at_root(&verdict(Verdict::TooThin { mode, thickness: exact(&thickness) }))
        }
        1 => {
            let eta = (&least + &least * numbers.hair()).min(2.into());
            let ring = ring::Ring::new(heavy, &ball(&eta), mu.as_ref().map(ball));
            let decided = decide::Arch { ring, half_opening: ball(&alpha) }.decide(&[])?;
            // Forces that may be borne no more: what the checker takes is judged.
            let [thrust, crown_moment] = decided.forces.map(|x| {
                let off = &least * numbers.hair() * [0, 0, -1, 1][numbers.below(4)];
                x.rational() * (off + 1i32)
            });
            let nearest = |nearest| {
                let dyadic = |x: &Rational| Dyadic::from(&Float::with_val(bits, x));
                verdict(Verdict::Stands(Standing {
                    thickness: exact(&eta),
                    thrust: dyadic(&thrust),
                    crown_moment: dyadic(&crown_moment),
                    nearest,
                }))
            };
            let all = Nearest::ALL.map(|place| {
                made(&nearest(place), &values, digits).map_or(Err("no root".into()), accepted)
            });
            let none = || at_root(&Problem::State { mode, arch: arch.clone() });
            all.into_iter().reduce(|a, b| a.or(b)).unwrap().or_else(|_: String| none())
        }
        _ => at_root(&Problem::State { mode, arch: arch.clone() }),
    }
}

/// Copies of a certificate that say something else, which is false.
fn spoiled(json: &Value) -> Vec<(String, Value)> {
    let mut copies = Vec::new();
    for (k, value) in json["values"].as_array().unwrap().iter().enumerate() {
        let (number, power) = value["value"].as_str().unwrap().split_once('e').unwrap_or(("0", ""));
        if json["claim"]["stands"].is_object() || number == "0" {
            continue;
        }
        let digits: Integer = number.replace('.', "").parse().unwrap();
        for by in [-1, 1] {
            let other = Integer::from(&digits + by).to_string();
            if other.len() + 1 == number.len() {
                let mut copy = json.clone();
                copy["values"][k]["value"] =
                    json!(format!("{}.{}e{power}", &other[..1], &other[1..]));
                copies.push((format!("{} {by}", value["quantity"]), copy));
            }
        }
    }
    let claim = json["claim"].as_object().unwrap();
    let (subject, _) =
        claim.iter().find(|(_, subject)| subject["half_opening"].is_string()).unwrap();
    let mut change = |field: &str, to: Value| {
        let mut copy = json.clone();
        copy["claim"][subject][field] = to;
        copies.push((field.to_owned(), copy));
    };
    for mode in Mode::ALL.map(Mode::label) {
        let said = &claim[subject]["mode"];
        if said.is_string() && mode != "[s,s]" && said != mode {
            change("mode", json!(mode));
        }
    }
    match subject.as_str() {
        "too_thin" => change("thickness", json!("2/1")),
        "slides" => change("friction", json!("10/1")),
        "too_wide" => change("half_opening", json!("1/10")),
        "stands" => change("thrust", json!("0x3p0")),
        _ => {}
    }
    copies
}

/// `COUPLET_STATICS` says how many, `COUPLET_STATICS_SEED` which.
#[test]
fn random_certificates_are_right_and_their_neighbours_are_not() {
    let count = std::env::var("COUPLET_STATICS").map_or(10, |n| n.parse().unwrap());
    let seed: u64 = std::env::var("COUPLET_STATICS_SEED").map_or(1, |n| n.parse().unwrap());
    let mut numbers = Numbers(0x9E37_79B9_7F4A_7C15 ^ seed.wrapping_mul(0xD134_2543_DE82_EF95));
    let (mut kinds, mut not_made) = (BTreeMap::<String, usize>::new(), Vec::new());
    for _ in 0..count {
        let json = match certificate(&mut numbers) {
            Ok(json) => json,
            Err(why) => {
                not_made.push(why);
                assert!(8 * not_made.len() <= count, "of {count} not made: {not_made:?}");
                continue;
            }
        };
        let claim = json["claim"].as_object().unwrap();
        let (name, subject) = claim.iter().find(|(_, x)| x["half_opening"].is_string()).unwrap();
        *kinds.entry(format!("{name} {}", subject["mode"])).or_default() += 1;
        if let Err(why) = judge(&json) {
            panic!("judged false, {why}: {json}");
        }
        let mut copies = spoiled(&json);
        let (what, copy) = copies.swap_remove(numbers.below(copies.len()));
        assert!(judge_once(&copy, 1).is_err(), "{what} is not seen: {json}");
    }
    println!("{kinds:?}\nnot made: {not_made:?}");
}
