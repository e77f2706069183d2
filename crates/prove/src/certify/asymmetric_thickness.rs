//! The thicknesses of asymmetric solutions, which go with each verdict that an arch stands: in balls of
//! double-doubles first, in balls of MPFR what those leave open.

use super::asymmetric::{CertifiedAsymmetric, certified, found};
use super::state::{DOUBLE_DOUBLE, Tier};
use crate::number::DoubleDoubleBall;
use crate::problem::asymmetric_region::may_move_asymmetrically;
use crate::problem::{Arch, Problem};
use crate::prover::figure::{Figure, Figured};
use crate::prover::posed::Posed;
use crate::prover::{Refused, in_doubles};
use crate::solve::asymmetric::AsymmetricCandidate;

/// The thicknesses of the asymmetric solutions that are found and proved for an arch, the largest first, to
/// `digits` significant digits; [`most_asymmetric`](super::most_asymmetric) says how many there can be. Nothing is
/// computed outside the [table](crate::problem::asymmetric_region) that holds them all.
/// Digits beyond [`MAX_DIGITS`](super::MAX_DIGITS) are refused.
pub fn asymmetric_thicknesses(arch: &Arch, digits: usize) -> Result<Vec<Figure>, Refused> {
    Refused::digits(digits)?;
    if !may_move_asymmetrically(arch) {
        return Ok(Vec::new());
    }
    let thickness = |candidate: &AsymmetricCandidate| {
        let is_quick = Tier::DoubleDoubles.has(digits);
        let quick = is_quick.then(|| in_double_doubles(arch, candidate)).flatten();
        let quick = quick.and_then(|thickness| thickness.figure(digits));
        quick.or_else(|| Some(certified(arch, candidate, digits).ok()?.thickness))
    };
    let mut all: Vec<Figure> = found(arch).iter().filter_map(thickness).collect();
    all.sort_by(|one, other| other.double.total_cmp(&one.double));
    Ok(all)
}

/// The thickness in these numbers, where they are enough for the proof.
fn in_double_doubles(arch: &Arch, candidate: &AsymmetricCandidate) -> Option<DoubleDoubleBall> {
    let problem = Problem::Asymmetric { mode: candidate.mode, arch: arch.clone() };
    let (system, given) = (problem.system(), problem.given::<DoubleDoubleBall>(DOUBLE_DOUBLE));
    let posed = Posed { system: &system, given: &given };
    let root = in_doubles::root_of_many(&posed, &candidate.unknowns).ok()?;
    let at = system.place(given, &root);
    let proved = CertifiedAsymmetric::proved(&problem, &at, DOUBLE_DOUBLE, |x| (*x).into()).ok()?;
    Some(proved.at.thickness)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certify::asymmetric;

    fn arch(weight: &str, alpha: &str, mu: &str) -> Arch {
        Arch::parse(weight, alpha, mu).unwrap()
    }

    /// One of each kind and weight, and two of one arch: in balls of double-doubles, and as balls of MPFR have
    /// them.
    #[test]
    fn double_doubles_prove_the_same_thicknesses() {
        for (weight, alpha, mu) in [
            ("milankovitch", "2.3", "1.05"),
            ("milankovitch", "2.3", "1.07"),
            ("milankovitch", "2.25", "0.99"),
            ("heyman", "2.3", "1.09"),
            ("heyman", "2.25", "1.01"),
            ("heyman", "2.4", "tan(51.115deg)"),
        ] {
            let arch = arch(weight, alpha, mu);
            let mut expected: Vec<String> = asymmetric(&arch, 17)
                .unwrap()
                .found
                .into_iter()
                .map(|solution| solution.unwrap().thickness.to_string())
                .collect();
            expected.sort_by(|one, other| other.cmp(one));
            let all = asymmetric_thicknesses(&arch, 17).unwrap();
            let told: Vec<String> = all.iter().map(ToString::to_string).collect();
            assert_eq!(told, expected, "{weight} {alpha} {mu}");
            assert!(found(&arch).iter().all(|one| in_double_doubles(&arch, one).is_some()));
        }
        assert_eq!(asymmetric_thicknesses(&arch("heyman", "2.3", "1.09"), 5).unwrap().len(), 2);
    }

    #[test]
    fn many_digits_are_those_of_balls_of_mpfr() {
        let eta = &asymmetric_thicknesses(&arch("milankovitch", "2.3", "1.05"), 30).unwrap()[0];
        assert_eq!(eta.to_string(), "0.583084449604488635548325494515");
    }

    #[test]
    fn most_arches_have_none() {
        for (alpha, mu) in [("pi/2", "0.35"), ("2.3", "inf"), ("2.3", "1.2"), ("2.6", "3")] {
            assert!(asymmetric_thicknesses(&arch("heyman", alpha, mu), 17).unwrap().is_empty());
        }
    }
}
