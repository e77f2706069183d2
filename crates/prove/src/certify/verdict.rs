//! Makes the certificate of an arch, whatever the verdict is: its state at the least thickness, why it stands at no
//! thickness, or that it stands or does not at one that is given.

use super::certificate::{Root, attempt, value_file};
use super::constant::Value;
use super::state::{Certify, Fall, Figure, Outcome, State, bits_lost};
use crate::arch::Unknown;
use crate::check::{Certificate, EXTRA_BITS, ValueFile};
use crate::number::{Ball, ExactNumber};
use crate::problem::{Arch, Problem, Quantity, Verdict};
use crate::prover::decide::decide;
use crate::prover::posed::Posed;
use crate::prover::root::root_near;
use crate::prover::{Error, Refused, Undecided};
use crate::solve::{self, start};
use rug::Float;
use std::cell::Cell;

/// The most bits that an arch loses; the format leaves room for a little more.
const MOST_LOST: u32 = EXTRA_BITS as u32 - 64;

/// A certificate of what an arch does, with `digits` significant digits of each value: of its state at
/// the least thickness, or why it stands at no thickness; with a `thickness`, in `(0, 2]`, that it stands with it or
/// does not. Digits beyond [`MAX_DIGITS`](super::MAX_DIGITS) and any other thickness are refused;
/// undecided if a comparison stays open.
pub fn certify_arch(
    arch: &Arch,
    thickness: Option<&ExactNumber>,
    digits: usize,
) -> Result<Certificate, Error> {
    Refused::digits(digits)?;
    Refused::certifiable([arch.half_opening()], [arch.friction()])?;
    thickness.map_or(Ok(()), Refused::thickness)?;
    let too_wide = |bits| limit(arch, Verdict::TooWide, widest(arch, bits), bits, digits);
    let slides = Cell::new(false);
    let found = made(arch, digits, |bits| {
        let state = match arch.state_alone(bits)? {
            Outcome::Stands(state) => state,
            Outcome::Falls(Fall::Sliding) => {
                slides.set(true);
                let alpha =
                    Float::with_val(bits, arch.half_opening().enclosure::<Ball>(bits).mid());
                return limit(arch, Verdict::Slides, start::sliding(&alpha).to_vec(), bits, digits);
            }
            Outcome::Falls(Fall::Thickness) => return too_wide(bits),
        };
        let Some(thickness) = thickness else { return state_root(arch, &state, None, digits) };
        let margin = thickness.enclosure::<Ball>(bits) - &state.thickness;
        match decide(&margin, "whether the thickness is enough", &[])? {
            false => state_root(arch, &state, Some(thickness), digits),
            true => standing(arch, thickness, &state, bits),
        }
    });
    // Next to half a turn the friction of pure sliding is beyond all numbers. The widest half opening is not, and
    // is another reason.
    Ok(match found {
        Err(open) if slides.get() => made(arch, digits, too_wide).map_err(|_| open)?,
        found => found?,
    })
}

fn made(
    arch: &Arch,
    digits: usize,
    find: impl Fn(u32) -> Result<Root, Undecided>,
) -> Result<Certificate, Undecided> {
    // A tiny half opening and a large friction at once need no more than each.
    attempt(digits, bits_lost(arch).min(MOST_LOST), find)
}

/// The state at the least thickness; with a thickness, that this is less.
fn state_root(
    arch: &Arch,
    state: &State,
    thickness: Option<&ExactNumber>,
    digits: usize,
) -> Result<Root, Undecided> {
    let (mode, arch) = (state.mode, arch.clone());
    let problem = match thickness.cloned() {
        None => Problem::State { mode, arch },
        Some(thickness) => Problem::Verdict { verdict: Verdict::TooThin { mode, thickness }, arch },
    };
    let value = |&unknown| state.value(unknown).map(|x| x.mid().clone());
    let centre: Option<Vec<Float>> = problem.system().unknowns.iter().map(value).collect();
    let centre = centre.ok_or_else(|| Undecided::new("an unknown has no value"))?;
    let intrinsic = state.thickness.clone() * &state.thrust;
    let stated = [
        (Quantity::Thickness, Some(&state.thickness)),
        (Quantity::Thrust, Some(&state.thrust)),
        (Quantity::IntrinsicThrust, Some(&intrinsic)),
        (Quantity::RotationJoint, Some(&state.rotation_joint)),
        (Quantity::SlidingJoint, state.sliding_joint.as_ref()),
    ];
    let known = stated.into_iter().filter(|(quantity, _)| problem.has(*quantity));
    let values = known
        .filter_map(|(quantity, ball)| Some(rounded(quantity, ball?, digits)))
        .collect::<Result<_, _>>()?;
    Ok(Root { problem, centre, values })
}

/// A value of a certificate.
pub(super) fn rounded(
    quantity: Quantity,
    ball: &Ball,
    digits: usize,
) -> Result<ValueFile, Undecided> {
    let rounding = || Undecided::rounding(format!("the rounding of {quantity}"));
    let figure = Figure::new(ball, digits).ok_or_else(rounding)?;
    Ok(value_file(quantity, &Value::Finite(figure.decimal)))
}

/// The limit beyond which an arch stands at no thickness, near some start values.
fn limit(
    arch: &Arch,
    verdict: Verdict,
    start: Vec<Float>,
    bits: u32,
    digits: usize,
) -> Result<Root, Undecided> {
    let problem = Problem::Verdict { verdict, arch: arch.clone() };
    let (system, given) = (problem.system(), problem.given(bits));
    let root = root_near(&Posed { system: &system, given: &given }, bits, start)?;
    let mut values = Vec::new();
    for (unknown, ball) in system.unknowns.iter().zip(&root) {
        let of_it = |quantity: &Quantity| quantity.variable() == Some(*unknown);
        if let Some(quantity) = Quantity::LANDMARK.into_iter().find(of_it) {
            values.push(rounded(quantity, ball, digits)?);
        }
    }
    let centre = root.iter().map(|x| x.mid().clone()).collect();
    Ok(Root { problem, centre, values })
}

/// Start values of the half opening beyond which no arch stands with the friction.
fn widest(arch: &Arch, bits: u32) -> Vec<Float> {
    let at = |h| Float::with_val(bits, start::widest_touching(arch.weight(), 2.0, h, 0.0));
    if !arch.is_limited() {
        return vec![at(0.0)];
    }
    let given = arch.given::<Ball>(bits);
    let [h, joint] = start::inner_sliding(&Float::with_val(bits, given.friction.mid()));
    vec![at(h.to_f64()), h, joint]
}

/// An admissible state of an arch that stands, from the one at its least thickness.
fn standing(
    arch: &Arch,
    thickness: &ExactNumber,
    state: &State,
    bits: u32,
) -> Result<Root, Undecided> {
    let float = |x: &Ball| Float::with_val(bits, x.mid());
    let given = arch.given::<Ball>(bits).map_ref(float);
    let eta = float(&thickness.enclosure(bits));
    let given = given.with(Unknown::Thickness, eta);
    let found = solve::standing(arch.weight(), &given, arch.is_limited(), &float(&state.thrust));
    let found =
        found.ok_or_else(|| Undecided::root("no line of thrust inside the arch is found"))?;
    let (standing, centre) = found.stated(thickness);
    let problem = Problem::Verdict { verdict: Verdict::Stands(standing), arch: arch.clone() };
    Ok(Root { problem, centre, values: Vec::new() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::check;
    use crate::number::AstroInterval;
    use rug::ops::Pow;

    /// Problem of a certificate that both arithmetics accept.
    fn accepted(certificate: &Certificate, digits: usize) -> Problem {
        let bytes = serde_json::to_vec(certificate).unwrap();
        let by_mpfr = check::<Ball>(&bytes, digits).unwrap();
        let by_astro = check::<AstroInterval>(&bytes, digits).unwrap();
        assert_eq!(by_mpfr, by_astro);
        assert_eq!(by_mpfr.values.len(), certificate.values.len());
        by_mpfr.problem
    }

    #[test]
    fn a_state_of_each_mode_has_a_certificate() {
        let cases = [
            ("pi/2", "1/2"),
            ("pi/2", "0.38"),
            ("2.45", "1.35"),
            ("2.56", "1.8"),
            ("2.6", "2"),
            ("2.5", "inf"),
            ("2.62", "inf"),
            ("1/1000000", "1"),
            ("1e-12", "1"),
            ("1e-30", "inf"),
            ("1e-30", "1.2e-91"),
            ("1e-300", "1e300"),
            ("1e-1000", "1"),
            ("2.6", "1e100"),
            // Next to the end of rotation.
            ("2.59084318392461", "inf"),
            ("2.590843443", "inf"),
        ];
        for (alpha, mu) in cases {
            let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
            let certificate =
                certify_arch(&arch, None, 25).unwrap_or_else(|e| panic!("{alpha} {mu}: {e}"));
            accepted(&certificate, 25);
        }
    }

    /// A verdict is the one that the solver has.
    fn every_verdict_has_a_certificate(weight: &str) {
        let verdict = |alpha: &str, mu: &str, eta: Option<&str>| {
            let arch = Arch::parse(weight, alpha, mu).unwrap();
            let eta: Option<ExactNumber> = eta.map(|eta| eta.parse().unwrap());
            let made = certify_arch(&arch, eta.as_ref(), 20);
            let made = made.unwrap_or_else(|e| panic!("{weight} {alpha} {mu} {eta:?}: {e}"));
            match accepted(&made, 20) {
                Problem::Verdict { verdict: Verdict::Slides, .. } => "slides",
                Problem::Verdict { verdict: Verdict::TooWide, .. } => "too wide",
                Problem::Verdict { verdict: Verdict::TooThin { .. }, .. } => "too thin",
                Problem::Verdict { verdict: Verdict::Stands(_), .. } => "stands",
                Problem::State { .. } => "state",
                Problem::Landmark { .. } => "landmark",
                Problem::Asymmetric { .. } => "asymmetric",
            }
        };
        for (alpha, mu) in [
            ("1.5", "0.1"),
            ("pi/2", "0"),
            ("3", "1"),
            ("1e-30", "1e-92"),
            ("1/100", "tan(1e-8)"),
            ("3.1415", "1000"),
        ] {
            assert_eq!(verdict(alpha, mu, None), "slides", "{alpha} {mu}");
            assert_eq!(verdict(alpha, mu, Some("1")), "slides", "{alpha} {mu}");
        }
        for (alpha, mu) in [("2.85", "inf"), ("2.8", "4"), ("2.85", "1e30"), ("3", "tan(89deg)")] {
            assert_eq!(verdict(alpha, mu, None), "too wide", "{alpha} {mu}");
        }
        for (alpha, mu, thin, thick) in [
            ("pi/2", "inf", "0.107", "0.108"),
            ("pi/2", "1/2", "1e-300", "2"),
            ("pi/2", "0.38", "0.12", "0.123"),
            ("80deg", "0.35", "0.05", "0.15"),
            ("2.45", "1.35", "0.5", "0.8"),
            ("2.56", "1.8", "0.5", "1.2"),
            ("2.6", "2", "0.5", "1.5"),
            ("2.6", "tan(89.9deg)", "0.5", "2"),
            ("2.62", "inf", "0.5", "1.3"),
            ("1/10", "1/30", "1e-6", "1"),
            ("1e-30", "1.2e-91", "3e-122", "4e-122"),
            ("1e-30", "1.5e-91", "2e-122", "1"),
            ("1e-5", "inf", "2.08e-22", "2.09e-22"),
        ] {
            assert_eq!(verdict(alpha, mu, Some(thin)), "too thin", "{alpha} {mu}");
            assert_eq!(verdict(alpha, mu, Some(thick)), "stands", "{alpha} {mu}");
            assert_eq!(verdict(alpha, mu, None), "state", "{alpha} {mu}");
        }
    }

    #[test]
    fn every_verdict_has_a_certificate_for_heyman() {
        every_verdict_has_a_certificate("heyman");
    }

    #[test]
    fn every_verdict_has_a_certificate_for_milankovitch() {
        every_verdict_has_a_certificate("milankovitch");
    }

    /// Far nearer than the digits of the certificate.
    #[test]
    fn beside_the_least_thickness_there_are_certificates_too() {
        for mu in ["1/2", "0.38", "inf"] {
            let arch = Arch::parse("milankovitch", "pi/2", mu).unwrap();
            let least = arch.least(40).unwrap().thickness.decimal.value;
            let beside = |step: i32| {
                let one = rug::Rational::from((step, 1)) / rug::Integer::from(10).pow(45);
                ExactNumber::from(&(least.to_rational() + one))
            };
            for (step, stands) in [(-1_000_000, false), (1_000_000, true)] {
                let made = certify_arch(&arch, Some(&beside(step)), 5).unwrap();
                assert_eq!(made.claim.stands.is_some(), stands, "{mu}");
                accepted(&made, 5);
            }
        }
    }
}
