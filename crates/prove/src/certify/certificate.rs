//! Makes certificates: what the solver knows, put into a form that can be checked without it.
//!
//! The large box has the shape in which the Krawczyk operator contracts best; the small box has **the
//! same shape**, so that the slopes of the large one prove it too. Nothing is handed out that the checker
//! does not accept.

use super::constant::{Constant, Value};
use super::landmark::CertifiedLandmark;
use crate::arch::{SelfWeight, Unknown};
use crate::check::{
    Certificate, ClaimFile, EXTRA_BITS, Refusal, SCHEMA, ValueFile, WITNESS_BITS, Witness,
    check_certificate,
};
use crate::number::{AstroInterval, Ball, DoubleBall, Dyadic, Magnitude, Rounded, bits_of};
use crate::problem::{Landmark, Problem, Quantity};
use crate::prover::operator::{Equations, Operator, Scales, inverse_jacobian, largest_boxes};
use crate::prover::{Error, Refused, Undecided};
use rug::Float;

/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 64;
/// Number of times that the precision is raised.
const ATTEMPTS: u32 = 8;
/// Up to this many digits a certificate is released only if the second arithmetic accepts it too; beyond,
/// that would take as long as everything else.
const SECOND_CHECK: usize = 1000;
/// The precision of the inverse in bits, and of the large box where nothing cancels.
const BITS: u32 = 64;
/// The scales on which a large box is tried.
const LADDER: Scales = Scales { step: 0.8, trials: 800 };
/// Bits by which a large box may be larger than is expected of one for a tiny half opening.
const SPARE: u32 = 24;
/// The part of a large box into which it is mapped, so that a checker has room to spare.
const ROOM: f64 = 0.9;

/// A certificate of a landmark with `digits` significant digits of each of its quantities, 1 to
/// [`MAX_DIGITS`](super::MAX_DIGITS); undecided if a proof fails.
pub fn certify_landmark(
    landmark: Landmark,
    weight: SelfWeight,
    digits: usize,
) -> Result<Certificate, Error> {
    Refused::digits(digits)?;
    Ok(landmark_certificate(&CertifiedLandmark::new(landmark, weight)?, digits)?)
}

/// Certificate of a landmark that is proved already.
pub(super) fn landmark_certificate(
    point: &CertifiedLandmark,
    digits: usize,
) -> Result<Certificate, Undecided> {
    let problem = Problem::Landmark { landmark: point.landmark(), weight: point.weight() };
    attempt(digits, 0, |bits| {
        let enclosed = point.enclosure(bits)?;
        let rounding = || Undecided::rounding("a rounding is not decided");
        let constants = enclosed.constants(digits).ok_or_else(rounding)?;
        let file = |constant: &Constant| value_file(constant.quantity, &constant.value);
        let at = enclosed.configuration();
        let centre =
            problem.system().unknowns.iter().map(|&unknown| at.value(unknown).mid().clone());
        let values = constants.iter().map(file).collect();
        Ok(Root { problem: problem.clone(), centre: centre.collect(), values })
    })
}

/// A value as the file has it.
pub(super) fn value_file(quantity: Quantity, value: &Value) -> ValueFile {
    let text = match value {
        Value::Finite(Rounded { value, .. }) => value.to_string(),
        Value::Infinite => "inf".to_owned(),
    };
    ValueFile { quantity: quantity.name().to_owned(), value: text }
}

/// Knowledge that the solver has of a root.
pub(super) struct Root {
    pub problem: Problem,
    pub centre: Vec<Float>,
    pub values: Vec<ValueFile>,
}

/// Makes a certificate from what `find` finds with ever more bits, until the checker accepts it.
pub(super) fn attempt(
    digits: usize,
    lost: u32,
    find: impl Fn(u32) -> Result<Root, Undecided>,
) -> Result<Certificate, Undecided> {
    let mut reason = Undecided::root("no attempt was made");
    for attempt in 0..ATTEMPTS {
        let bits = bits_of(digits) + lost + (GUARD << attempt);
        // Next to a limit the box is examined with more bits too.
        let wide = ((BITS << attempt.min(6)) + lost).min(EXTRA_BITS as u32);
        let made = find(bits).and_then(|root| {
            let small = bits_of(digits) + GUARD / 2 + further(&root.problem, attempt);
            // A rotational joint that is as good as in the crown loses bits that nothing told of before.
            let spare = attempt.checked_sub(ATTEMPTS / 2).map_or(0, |late| GUARD << late);
            root.certificate(digits, small, wide, lost, spare)
        });
        let checked = made.and_then(|certificate| {
            let refused = |refusal: Refusal| Undecided::new(refusal.to_string());
            check_certificate::<Ball>(&certificate, digits).map_err(refused)?;
            if digits <= SECOND_CHECK {
                check_certificate::<AstroInterval>(&certificate, digits).map_err(refused)?;
            }
            Ok(certificate)
        });
        match checked {
            Ok(certificate) => return Ok(certificate),
            Err(undecided) => reason = undecided.at(bits),
        }
    }
    Err(reason)
}

/// Bits of a small box beyond its digits. What a verdict compares may be nearer than any digits tell: what is given to
/// its limit, or a line of thrust to the intrados, which is as near as its witnesses are long.
fn further(problem: &Problem, attempt: u32) -> u32 {
    match problem {
        Problem::Verdict { .. } | Problem::Asymmetric { .. } => {
            problem.witness_bits() as u32 + ((GUARD << attempt) - GUARD) / 2
        }
        _ => 0,
    }
}

impl Root {
    /// The certificate, with a small box of about `2^-bits` of the large one, which is examined with
    /// `wide` bits. Where the equations lose `lost` bits, the centre has more, and `spare` ones, so that a checker, who
    /// takes its precision from there, does not miss them.
    fn certificate(
        self,
        digits: usize,
        bits: u32,
        wide: u32,
        lost: u32,
        spare: u32,
    ) -> Result<Certificate, Undecided> {
        let large = LargeBox::new(&self.problem, &self.centre, wide, lost)
            .ok_or_else(Undecided::not_alone)?;
        let dyadic = |x: &Float| Dyadic::from(x);
        let magnitude = |x: &Magnitude| Dyadic::from(&x.to_float());
        let small = large.radius.iter().map(|radius| magnitude(&radius.shifted(-i64::from(bits))));
        // The centre need not be known better than a fraction of the radius.
        let centre = self.centre.iter().zip(&large.radius).map(|(x, radius)| {
            let size = i64::from(x.get_exp().unwrap_or(0));
            let kept = i64::from(bits) + 12 + i64::from(lost / 3 + spare);
            let last = radius.exponent().unwrap_or(0) - kept;
            let useful = u32::try_from(size - last).unwrap_or(2).clamp(2, x.prec());
            dyadic(&Float::with_val(useful, x))
        });
        Ok(Certificate {
            schema: SCHEMA.to_owned(),
            tool: concat!("couplet ", env!("CARGO_PKG_VERSION")).to_owned(),
            claim: ClaimFile::new(&self.problem),
            digits,
            root: Witness { centre: centre.collect(), radius: small.collect() },
            unique: Witness {
                centre: large.centre.iter().map(dyadic).collect(),
                radius: large.radius.iter().map(magnitude).collect(),
            },
            inverse: large.inverse.iter().map(|row| row.iter().map(dyadic).collect()).collect(),
            values: self.values,
        })
    }
}

/// A box in which the root is unique.
struct LargeBox {
    centre: Vec<Float>,
    radius: Vec<Magnitude>,
    inverse: Vec<Vec<Float>>,
}

impl LargeBox {
    /// Looks for a box that is mapped into itself with room to spare, in both arithmetics: neither always encloses
    /// more tightly.
    fn new(problem: &Problem, root: &[Float], bits: u32, lost: u32) -> Option<Self> {
        let centre: Vec<Float> = root.iter().map(|x| Float::with_val(bits, x)).collect();
        if centre.is_empty() {
            return Some(Self { centre, radius: Vec::new(), inverse: Vec::new() });
        }
        let points: Vec<Ball> = centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
        // The inverse only has to be near; the worse the condition, the nearer.
        let near = bits.min(WITNESS_BITS as u32 + lost);
        let inverse: Vec<Vec<Float>> = inverse_jacobian(&problem.slopes(bits, &points), bits)?
            .into_iter()
            .map(|row| row.into_iter().map(|y| Float::with_val(near, y)).collect())
            .collect();
        let by_mpfr = Operator::<_, Ball>::new(problem, bits, &centre, &inverse);
        let by_astro = Operator::<_, AstroInterval>::new(problem, bits, &centre, &inverse);
        let part = Magnitude::upper(&Float::with_val(53, ROOM));
        // A thrust near one varies as much as it lacks to one.
        let room = |(unknown, x): (&Unknown, &Float)| match unknown {
            Unknown::Thrust if *x > 0.5f64 => Magnitude::lower(&Float::with_val(bits, 1 - x)),
            _ => Magnitude::lower(x),
        };
        // The slopes of a tiny half opening are differences of what is as much larger as its inverse square: only
        // on a box that is as much smaller do their enclosures tell anything. That is a third of the bits lost.
        let smaller = -i64::from((lost / 3).saturating_sub(SPARE));
        let unknowns = problem.system().unknowns.iter().zip(&centre);
        let values: Vec<Magnitude> = unknowns.map(|pair| room(pair).shifted(smaller)).collect();
        let in_doubles = Operator::<_, DoubleBall>::new(problem, bits, &centre, &inverse);
        let target = |radii: &[Magnitude]| -> Vec<Magnitude> {
            radii.iter().map(|r| r.times(part)).collect()
        };
        let seems = |radii: &[Magnitude]| in_doubles.image_in(radii, &target(radii)).is_some();
        let boxes = largest_boxes(&values, LADDER, seems, |radii| {
            let image = by_mpfr.image_in(radii, &target(radii))?;
            by_astro.image_in(radii, &target(radii)).map(|_| image)
        });
        let (radius, _) = boxes.into_iter().last()?;
        Some(Self { centre, radius, inverse })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::check;

    fn accepted(certificate: &Certificate, digits: usize) {
        let bytes = serde_json::to_vec(certificate).unwrap();
        let by_mpfr = check::<Ball>(&bytes, digits).unwrap();
        let by_astro = check::<AstroInterval>(&bytes, digits).unwrap();
        assert_eq!(by_mpfr, by_astro);
        assert_eq!(by_mpfr.values.len(), certificate.values.len());
    }

    #[test]
    fn every_landmark_has_a_certificate() {
        for landmark in Landmark::ALL {
            for weight in SelfWeight::ALL {
                accepted(&certify_landmark(landmark, weight, 30).unwrap(), 30);
            }
        }
    }

    /// Next to J the rotational joint of `[r,s,r]` is 2e-12.
    #[test]
    fn a_joint_as_good_as_in_the_crown_has_a_certificate() {
        let [alpha, mu] = ["2.603266515104792749814523154060566601303", "1.7772136083882352571832"];
        let arch = crate::problem::Arch::parse("heyman", alpha, mu).unwrap();
        accepted(&crate::certify::certify_arch(&arch, None, 30).unwrap(), 30);
    }
}
