//! Makes the certificate of an asymmetric solution of (19).

use super::asymmetric::{found, root};
use super::certificate::{Root, attempt};
use super::verdict::rounded;
use crate::arch::asymmetric::AsymmetricMode;
use crate::check::Certificate;
use crate::number::list;
use crate::problem::{Arch, Known, Problem, Quantity};
use crate::prover::{Error, Refused, Undecided};

/// Quantities stated of a solution, if its kind has it.
const STATED: [Quantity; 12] = list![Quantity:
    Thickness Thrust IntrinsicThrust CrownMoment VerticalForce CrownHinge RotationJoint SlidingJoint
    ShoulderSlip ShoulderOpening InnerSlip Power
];

/// The kinds of asymmetric solutions that the search finds for an arch, each once. Nothing is proved of them, nor
/// that they are all.
pub fn asymmetric_kinds(arch: &Arch) -> Vec<AsymmetricMode> {
    let mut kinds: Vec<AsymmetricMode> = Vec::new();
    for candidate in found(arch) {
        if !kinds.contains(&candidate.mode) {
            kinds.push(candidate.mode);
        }
    }
    kinds
}

/// A certificate of the asymmetric solution of a kind that the search finds for an arch, with `digits` significant
/// digits of each value; else undecided. With unlimited friction there is none.
pub fn certify_asymmetric(
    arch: &Arch,
    mode: AsymmetricMode,
    digits: usize,
) -> Result<Certificate, Error> {
    Refused::digits(digits)?;
    Refused::certifiable([arch.half_opening()], [arch.friction()])?;
    let candidate = found(arch).into_iter().find(|candidate| candidate.mode == mode);
    let candidate = candidate.ok_or_else(Undecided::no_solution)?;
    let problem = Problem::Asymmetric { mode, arch: arch.clone() };
    let made = attempt(digits, 0, |bits| {
        let at = root(&problem, &candidate, bits)?;
        let stated = STATED.into_iter().filter(|quantity| problem.has(*quantity));
        let values = stated.filter_map(|quantity| match problem.known(quantity, &at) {
            Some(Known::Enclosed(ball)) => Some(rounded(quantity, &ball, digits)),
            _ => None,
        });
        let values = values.collect::<Result<_, _>>()?;
        let unknowns = problem.system().values(&at);
        let centre = unknowns.iter().map(|x| x.mid().clone()).collect();
        Ok(Root { problem: problem.clone(), centre, values })
    });
    Ok(made?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::check;
    use crate::number::{AstroInterval, Ball};

    /// Both arithmetics accept a solution of each kind for each weight, to few and to many digits.
    #[test]
    fn a_solution_of_each_kind_has_a_certificate() {
        for (weight, alpha, mu, mode) in [
            ("milankovitch", "2.3", "1.05", AsymmetricMode::InnerSliding),
            ("milankovitch", "2.3", "1.07", AsymmetricMode::ShoulderOpening),
            ("milankovitch", "2.25", "0.99", AsymmetricMode::ShoulderSliding),
            ("heyman", "2.3", "1.09", AsymmetricMode::InnerSliding),
            ("heyman", "2.4", "tan(51.115deg)", AsymmetricMode::InnerSliding),
        ] {
            let arch = Arch::parse(weight, alpha, mu).unwrap();
            for digits in [1, 30] {
                let made = certify_asymmetric(&arch, mode, digits).unwrap();
                let bytes = serde_json::to_vec(&made).unwrap();
                let by_mpfr = check::<Ball>(&bytes, digits).unwrap();
                assert_eq!(by_mpfr, check::<AstroInterval>(&bytes, digits).unwrap());
                assert!(
                    matches!(by_mpfr.problem, Problem::Asymmetric { mode: of, .. } if of == mode)
                );
                assert_eq!(by_mpfr.values.len(), made.values.len());
            }
        }
    }

    /// Where no solution is found, and of a kind that is not found.
    #[test]
    fn what_is_not_found_has_no_certificate() {
        for (alpha, mu) in [("pi/2", "0.35"), ("2.3", "inf"), ("2.3", "1.07")] {
            let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
            assert!(certify_asymmetric(&arch, AsymmetricMode::InnerSliding, 5).is_err());
        }
    }
}
