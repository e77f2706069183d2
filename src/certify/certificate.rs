//! Makes certificates: what the solver knows, put into a form that can be checked without it.
//!
//! The large box has the shape in which the Krawczyk operator contracts best; the small box has **the
//! same shape**, so that the slopes of the large one prove it too. Nothing is handed out that the checker
//! does not accept.

use super::root::{Equations, Ladder, Operator, inverse_jacobian, largest_boxes};
use super::state::{Certify, Figure, Outcome, bits_lost};
use super::{CertifiedLandmark, Undecided, Value};
use crate::arch::{SelfWeight, Unknown};
use crate::check::{
    Certificate, ClaimFile, EXTRA_BITS, Refusal, SCHEMA, ValueFile, WITNESS_BITS, Witness,
    check_certificate,
};
use crate::number::{AstroInterval, Ball, Dyadic, Magnitude, Rounded, bits_of};
use crate::problem::{Arch, Friction, Landmark, Problem, Quantity};
use rug::Float;

/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 64;
/// How often the precision is raised.
const ATTEMPTS: u32 = 8;
/// Up to this many digits a certificate is released only if the second arithmetic accepts it too; beyond,
/// that would take as long as everything else.
const SECOND_CHECK: usize = 1000;
/// The precision of the inverse in bits, and of the large box where nothing cancels.
const BITS: u32 = 64;
/// The scales on which a large box is tried.
const LADDER: Ladder = Ladder { step: 0.8, trials: 800 };
/// The most bits that an arch loses; the format leaves room for a little more.
const MOST_LOST: u32 = EXTRA_BITS as u32 - 64;
/// The part of a large box into which it is mapped, so that a checker has room to spare.
const ROOM: f64 = 0.9;

/// A certificate of a landmark with `digits` significant digits of each of its quantities, 1 to
/// [`MAX_DIGITS`](super::MAX_DIGITS); else, or if a proof fails, undecided.
pub fn certify_landmark(
    landmark: Landmark,
    weight: SelfWeight,
    digits: usize,
) -> Result<Certificate, Undecided> {
    landmark_certificate(&CertifiedLandmark::new(landmark, weight)?, digits)
}

/// The same of a landmark that is proved already.
pub(super) fn landmark_certificate(
    point: &CertifiedLandmark,
    digits: usize,
) -> Result<Certificate, Undecided> {
    let problem = Problem::Landmark { landmark: point.landmark(), weight: point.weight() };
    let values: Vec<ValueFile> = point
        .constants(digits)?
        .into_iter()
        .map(|constant| value_file(constant.quantity, &constant.value))
        .collect();
    attempt(digits, 0, |bits| {
        let refined = point.enclosure(bits)?;
        let at = refined.configuration();
        let centre =
            problem.system().unknowns.iter().map(|&unknown| at.value(unknown).mid().clone());
        Ok(Root { problem: problem.clone(), centre: centre.collect(), values: values.clone() })
    })
}

/// A certificate of the state of an arch at its least thickness, with `digits` significant digits of
/// each value, at least one. Undecided if the arch does not stand, if a comparison stays open, or if the
/// friction is given as an angle: the format has the coefficient only.
pub fn certify_state(arch: &Arch, digits: usize) -> Result<Certificate, Undecided> {
    if matches!(arch.friction(), Friction::Angle(_)) {
        return Err(Undecided::new("a certificate takes the friction as a coefficient"));
    }
    // A tiny half opening and a large friction at once need no more than each.
    attempt(digits, bits_lost(arch).min(MOST_LOST), |bits| {
        let Outcome::Stands(state) = arch.state(bits)? else {
            return Err(Undecided::new("the arch does not stand: there is no state to certify"));
        };
        let problem = Problem::State { mode: state.mode, arch: arch.clone() };
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
        let mut values = Vec::new();
        for (quantity, ball) in stated {
            if let Some(ball) = ball {
                let rounding = || Undecided::new(format!("the rounding of {}", quantity.name()));
                let figure = Figure::new(ball, digits).ok_or_else(rounding)?;
                values.push(value_file(quantity, &Value::Finite(figure.decimal)));
            }
        }
        Ok(Root { problem, centre, values })
    })
}

fn value_file(quantity: Quantity, value: &Value) -> ValueFile {
    let text = match value {
        Value::Finite(Rounded { value, .. }) => value.to_string(),
        Value::Infinite => "inf".to_owned(),
    };
    ValueFile { quantity: quantity.name().to_owned(), value: text }
}

/// What the solver knows of a root.
struct Root {
    problem: Problem,
    centre: Vec<Float>,
    values: Vec<ValueFile>,
}

/// Makes a certificate from what `find` finds with ever more bits, until the checker accepts it.
fn attempt(
    digits: usize,
    lost: u32,
    find: impl Fn(u32) -> Result<Root, Undecided>,
) -> Result<Certificate, Undecided> {
    let mut reason = Undecided::new("no attempt was made");
    for attempt in 0..ATTEMPTS {
        let bits = bits_of(digits) + lost + (GUARD << attempt);
        // Next to a limit the box is examined with more bits too.
        let wide = ((BITS << attempt.min(6)) + lost).min(EXTRA_BITS as u32);
        let small = bits_of(digits) + GUARD / 2;
        let made = find(bits).and_then(|root| root.certificate(digits, small, wide, lost));
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
            Err(undecided) => reason = undecided,
        }
    }
    Err(reason)
}

impl Root {
    /// The certificate, with a small box of about `2^-bits` of the large one, which is examined with
    /// `wide` bits. Where the equations lose `lost` bits, the centre has as many more, so that a checker, who takes
    /// its precision from there, does not miss them.
    fn certificate(
        self,
        digits: usize,
        bits: u32,
        wide: u32,
        lost: u32,
    ) -> Result<Certificate, Undecided> {
        let large = LargeBox::new(&self.problem, &self.centre, wide, lost)
            .ok_or_else(|| Undecided::new("no box around the root is mapped into itself"))?;
        let claim = ClaimFile::new(&self.problem)
            .ok_or_else(|| Undecided::new("a certificate has no words for the problem"))?;
        let dyadic = |x: &Float| Dyadic::from(x);
        let magnitude = |x: &Magnitude| Dyadic::from(&x.to_float());
        let small = large.radius.iter().map(|radius| magnitude(&radius.shifted(-i64::from(bits))));
        // The centre need not be known better than a fraction of the radius.
        let centre = self.centre.iter().zip(&large.radius).map(|(x, radius)| {
            let size = i64::from(x.get_exp().unwrap_or(0));
            let last = radius.exponent().unwrap_or(0) - i64::from(bits) - 12 - i64::from(lost);
            let useful = u32::try_from(size - last).unwrap_or(2).clamp(2, x.prec());
            dyadic(&Float::with_val(useful, x))
        });
        Ok(Certificate {
            schema: SCHEMA.to_owned(),
            tool: concat!("couplet ", env!("CARGO_PKG_VERSION")).to_owned(),
            claim,
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
    /// Looks for a box that is mapped into itself with room to spare, in both arithmetics: the other
    /// encloses less tightly.
    fn new(problem: &Problem, root: &[Float], bits: u32, lost: u32) -> Option<Self> {
        let centre: Vec<Float> = root.iter().map(|x| Float::with_val(bits, x)).collect();
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
        let values: Vec<Magnitude> =
            problem.system().unknowns.iter().zip(&centre).map(room).collect();
        let boxes = largest_boxes(&values, LADDER, |radii| {
            let target: Vec<Magnitude> = radii.iter().map(|r| r.times(part)).collect();
            let image = by_mpfr.image_in(radii, &target)?;
            by_astro.image_in(radii, &target).map(|_| image)
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
            ("2.6", "1e100"),
            // Next to the end of rotation.
            ("2.59084318392461", "inf"),
            ("2.590843443", "inf"),
        ];
        for (alpha, mu) in cases {
            let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
            let certificate =
                certify_state(&arch, 25).unwrap_or_else(|e| panic!("{alpha} {mu}: {e}"));
            accepted(&certificate, 25);
        }
    }
}
