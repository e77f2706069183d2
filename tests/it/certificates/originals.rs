//! Valid certificates to spoil, and certificates of any root of the equations, whether it is the one
//! claimed or not.

use crate::arches::{M, arch, number};
use couplet::arch::SelfWeight;
use couplet::arch::asymmetric::AsymmetricMode;
use couplet::certify::{certify_arch, certify_asymmetric, certify_landmark};
use couplet::check::{
    Accepted, AcceptedFile, Certificate, ClaimFile, Refusal, SCHEMA, ValueFile, Witness, check_file,
};
use couplet::number::{AstroInterval, Ball, Dyadic};
use couplet::problem::{Landmark, Mode, Problem};
use couplet::solve::inverse;
use rug::Float;
use serde_json::Value;
use std::collections::HashMap;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::PathBuf;
use std::sync::Mutex;

/// The answers of all arithmetics that are built in, the independent one first.
pub(super) fn answers(bytes: &[u8], max_digits: usize) -> Vec<Result<AcceptedFile, Refusal>> {
    let all =
        [check_file::<AstroInterval>(bytes, max_digits), check_file::<Ball>(bytes, max_digits)];
    keep_for_others(bytes, &all[0]);
    all.into()
}

/// Keeps a file with the answer in its name, where `COUPLET_KEEP_CERTIFICATES` names a folder: for a checker that is
/// another program (`make verified-test`).
fn keep_for_others(bytes: &[u8], answer: &Result<AcceptedFile, Refusal>) {
    let Some(folder) = std::env::var_os("COUPLET_KEEP_CERTIFICATES") else { return };
    let mut hasher = DefaultHasher::new();
    bytes.hash(&mut hasher);
    let word = match answer {
        Ok(_) => "accepted",
        Err(Refusal::Limit(..)) => "limit",
        Err(_) => "refused",
    };
    let file = PathBuf::from(folder).join(format!("{word}-{:016x}.json", hasher.finish()));
    fs::write(file, bytes).expect("the folder can be written");
}

/// The answer of all arithmetics, which has to be the same, on a file of either kind.
pub(super) fn file_alike(bytes: &[u8], max_digits: usize) -> Result<AcceptedFile, Refusal> {
    let mut answers = answers(bytes, max_digits);
    let first = answers.remove(0);
    assert!(answers.iter().all(|other| *other == first), "{first:?} {answers:?}");
    first
}

/// The same on a certificate that is none of a survey.
pub(super) fn alike(bytes: &[u8], max_digits: usize) -> Result<Accepted, Refusal> {
    file_alike(bytes, max_digits).map(|file| file.certificate().expect("no survey").clone())
}

pub(super) fn to_value(certificate: &Certificate) -> Value {
    serde_json::to_value(certificate).unwrap()
}

/// What has been made once.
fn kept(name: String, make: impl FnOnce() -> Certificate) -> &'static Value {
    static MADE: Mutex<Option<HashMap<String, &'static Value>>> = Mutex::new(None);
    let mut made = MADE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let made = made.get_or_insert_default();
    made.entry(name).or_insert_with(|| Box::leak(Box::new(to_value(&make()))))
}

/// The certificate of a landmark with 30 digits, for Heyman's weight.
pub(super) fn landmark(symbol: &str) -> &'static Value {
    kept(symbol.to_owned(), || {
        let landmark = Landmark::ALL.into_iter().find(|l| l.symbol() == symbol).unwrap();
        certify_landmark(landmark, SelfWeight::Heyman, 30).unwrap()
    })
}

/// The certificate of a state with 20 digits, for Milankovitch's weight.
pub(super) fn state(half_opening: &str, friction: &str) -> &'static Value {
    kept(format!("{half_opening} {friction}"), || {
        certify_arch(&arch(M, half_opening, friction), None, 20).unwrap()
    })
}

/// The certificate of an arch with a thickness, or of why it stands at none, with 20 digits, for Milankovitch's weight.
pub(super) fn verdict(half_opening: &str, friction: &str, thickness: &str) -> &'static Value {
    kept(format!("{half_opening} {friction} {thickness}"), || {
        let thickness = number(thickness);
        certify_arch(&arch(M, half_opening, friction), Some(&thickness), 20).unwrap()
    })
}

/// The certificate of an asymmetric solution with 20 digits.
pub(super) fn asymmetric(
    weight: SelfWeight,
    half_opening: &str,
    friction: &str,
    mode: AsymmetricMode,
) -> &'static Value {
    kept(format!("{weight:?} {half_opening} {friction} {mode}"), || {
        certify_asymmetric(&arch(weight, half_opening, friction), mode, 20).unwrap()
    })
}

pub(super) fn landmark_problem(landmark: Landmark, weight: SelfWeight) -> Problem {
    Problem::Landmark { landmark, weight }
}

/// The claim that an arch of this half opening and friction collapses in this mode.
pub(super) fn state_problem(
    weight: SelfWeight,
    mode: Mode,
    half_opening: &str,
    friction: &str,
) -> Problem {
    Problem::State { mode, arch: arch(weight, half_opening, friction) }
}

/// The root of a certificate, roughly.
pub(super) fn root(certificate: &Value) -> Vec<f64> {
    let number = |text: &Value| -> f64 {
        let number: Dyadic = text.as_str().unwrap().parse().unwrap();
        let mantissa = rug::Integer::from_digits(number.words(), rug::integer::Order::Lsf);
        let size = (Float::with_val(64, mantissa) << number.exponent()).to_f64();
        if number.is_negative() { -size } else { size }
    };
    certificate["root"]["centre"].as_array().unwrap().iter().map(number).collect()
}

#[track_caller]
pub(super) fn is_near(one: &[f64], other: &[f64], within: f64) {
    let is_near = one.iter().zip(other).all(|(a, b)| (a - b).abs() < within);
    assert!(is_near, "{one:?} and {other:?}");
}

/// A certificate with right witnesses for the root of the equations next to `start`. Its only value is of
/// no importance.
pub(super) fn at_root(problem: &Problem, start: &[f64]) -> Certificate {
    let mut certificate = find_root(problem, start).expect("a root");
    certificate.values =
        vec![ValueFile { quantity: "thickness".to_owned(), value: "1".to_owned() }];
    certificate
}

/// The same without a value, where Newton's method finds its way.
pub(super) fn find_root(problem: &Problem, start: &[f64]) -> Option<Certificate> {
    const BITS: u32 = 256;
    let mut x: Vec<Float> = start.iter().map(|v| Float::with_val(BITS, v)).collect();
    let n = x.len();
    let mut y = Vec::new();
    for _ in 0..20 {
        let balls: Vec<Ball> = x.iter().map(|x| Ball::exact(x.clone(), BITS)).collect();
        let system = problem.system();
        let at = system.place(problem.given(BITS), &balls);
        let residuals = system.residuals(&system.variables(&at));
        let row = |r: &couplet::number::Dual<Ball>| {
            (0..n).map(|k| Float::with_val(BITS, r.derivative(k).mid())).collect()
        };
        y = inverse(residuals.iter().map(row).collect())?;
        if !y.iter().flatten().all(Float::is_finite) {
            return None;
        }
        for (x, row) in x.iter_mut().zip(&y) {
            for (y, r) in row.iter().zip(&residuals) {
                *x -= Float::with_val(BITS, y * r.value().mid());
            }
        }
    }
    let dyadic = |bits: u32, x: &Float| Dyadic::from(&Float::with_val(bits, x));
    let radius = |exponent: i32| vec![Dyadic::new(false, vec![1], exponent); n];
    Some(Certificate {
        schema: SCHEMA.to_owned(),
        tool: "a test".to_owned(),
        claim: ClaimFile::new(problem),
        digits: 5,
        unique: Witness { centre: x.iter().map(|x| dyadic(64, x)).collect(), radius: radius(-30) },
        inverse: y.iter().map(|row| row.iter().map(|y| dyadic(64, y)).collect()).collect(),
        root: Witness { centre: x.iter().map(|x| dyadic(200, x)).collect(), radius: radius(-100) },
        values: Vec::new(),
    })
}
