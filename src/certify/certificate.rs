//! Makes certificates: what the solver knows, put into a form that can be checked without it.
//!
//! The large box has the shape in which the Krawczyk operator contracts best; the small box has **the
//! same shape**, so that the slopes of the large one prove it too. Nothing is handed out that the checker
//! does not accept.

use super::state::{Arch, Friction, Outcome};
use super::{CertifiedLandmark, Undecided, Value};
use crate::arch::{SelfWeight, Unknown};
use crate::check::{
    Certificate, ClaimFile, Refusal, SCHEMA, ValueFile, WITNESS_BITS, Witness, check_certificate,
    krawczyk,
};
use crate::number::{
    AstroInterval, Ball, Dual, Enclosure, ExactNumber, Magnitude, Rounded, bits_of,
};
use crate::number::{Dyadic, Engine};
use crate::problem::{Claim, Exact, State, Subject};
use crate::problem::{Landmark, Quantity};
use crate::solve::inverse;
use rug::Float;

/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 64;
/// How often the precision is raised.
const ATTEMPTS: u32 = 8;
/// Up to so many digits the second arithmetic, which encloses less tightly, has to accept too before a
/// certificate is given away; beyond it takes as long as everything else.
const SECOND_CHECK: usize = 1000;
/// The precision of the inverse in bits, and of the large box where nothing cancels.
const BITS: u32 = 64;
/// A large box is tried with the scales `0.8^k`.
const TRIALS: i32 = 800;

/// A certificate of a landmark with `digits` significant digits of each of its quantities, 1 to
/// [`MAX_DIGITS`](super::MAX_DIGITS); else, or if a proof fails, undecided.
pub fn certify_landmark(
    landmark: Landmark,
    weight: SelfWeight,
    digits: usize,
) -> Result<Certificate, Undecided> {
    let point = CertifiedLandmark::new(landmark, weight)?;
    let claim = Claim { weight, subject: Subject::Landmark(landmark) };
    let values: Vec<ValueFile> = point
        .constants(digits, &|| ())?
        .into_iter()
        .map(|constant| value_file(constant.quantity, &constant.value))
        .collect();
    attempt(digits, 0, |bits| {
        let refined = point.enclosure(bits)?;
        let unknowns = claim.unknowns().iter();
        let centre: Option<Vec<Float>> =
            unknowns.map(|&unknown| Some(refined.value(unknown)?.mid().clone())).collect();
        let centre = centre.ok_or_else(|| Undecided("an unknown has no value".into()))?;
        Ok(Root { claim: claim.clone(), centre, values: values.clone() })
    })
}

/// A certificate of the state of an arch at its least thickness, with `digits` significant digits of
/// each value, at least one. Undecided if the arch does not stand, if a comparison stays open, or if the
/// friction is given as an angle: the format has the coefficient only.
pub fn certify_state(arch: &Arch, digits: usize) -> Result<Certificate, Undecided> {
    let given = |x: &ExactNumber| Exact {
        numerator: x.factor().numer().to_string(),
        denominator: x.factor().denom().to_string(),
        times_pi: !x.is_rational(),
    };
    let friction = match arch.friction() {
        Friction::Coefficient(mu) => Some(given(mu)),
        Friction::Infinite => None,
        Friction::Angle(_) => {
            return Err(Undecided("a certificate takes the friction as a coefficient".into()));
        }
    };
    attempt(digits, arch.bits_lost(), |bits| {
        let doubt = |doubt: super::state::Doubt| Undecided(doubt.question.to_owned());
        let Outcome::Stands(state) = arch.state(bits).map_err(doubt)? else {
            return Err(Undecided("the arch does not stand: there is no state to certify".into()));
        };
        let subject = State {
            mode: state.mode,
            half_opening: given(arch.half_opening()),
            friction: friction.clone().filter(|_| state.mode != crate::problem::Mode::Overturning),
        };
        let claim = Claim { weight: arch.weight(), subject: Subject::State(subject) };
        let value = |unknown: &Unknown| match unknown {
            Unknown::RotationJoint => Some(&state.rotation_joint),
            Unknown::SlidingJoint => state.sliding_joint.as_ref(),
            Unknown::Thickness => Some(&state.thickness),
            Unknown::Thrust => Some(&state.thrust),
            Unknown::HalfOpening | Unknown::Friction => None,
        };
        let values = claim.unknowns().iter().map(|unknown| Some(value(unknown)?.clone()));
        let values: Option<Vec<Ball>> = values.collect();
        let balls = values.ok_or_else(|| Undecided("an unknown has no value".into()))?;
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
                let rounded = super::state::Figure::new(ball, digits)
                    .ok_or_else(|| Undecided(format!("the rounding of {}", quantity.name())))?;
                values.push(value_file(quantity, &Value::Finite(rounded.decimal)));
            }
        }
        let centre = balls.iter().map(|x| x.mid().clone()).collect();
        Ok(Root { claim, centre, values })
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
    claim: Claim,
    centre: Vec<Float>,
    values: Vec<ValueFile>,
}

/// Makes a certificate from what `find` finds with ever more bits, until the checker accepts it.
fn attempt(
    digits: usize,
    lost: u32,
    find: impl Fn(u32) -> Result<Root, Undecided>,
) -> Result<Certificate, Undecided> {
    let mut reason = Undecided("no attempt was made".into());
    for attempt in 0..ATTEMPTS {
        let bits = bits_of(digits) + lost + (GUARD << attempt);
        // Next to a limit the box is examined with more bits too.
        let wide = (BITS << attempt.min(6)) + lost;
        let made =
            find(bits).and_then(|root| root.certificate(digits, bits_of(digits) + GUARD / 2, wide));
        let checked = made.and_then(|certificate| {
            let refused = |refusal: Refusal| Undecided(refusal.to_string());
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
    /// `wide` bits.
    fn certificate(self, digits: usize, bits: u32, wide: u32) -> Result<Certificate, Undecided> {
        let large = LargeBox::new(&self.claim, &self.centre, wide)
            .ok_or_else(|| Undecided("no box around the root is mapped into itself".into()))?;
        let dyadic = |x: &Float| Dyadic::from(x);
        let magnitude = |x: &Magnitude| Dyadic::from(&x.to_float());
        let small = large.radius.iter().map(|radius| magnitude(&radius.shifted(-i64::from(bits))));
        // The centre need not be known better than a fraction of the radius.
        let centre = self.centre.iter().zip(&large.radius).map(|(x, radius)| {
            let size = i64::from(x.get_exp().unwrap_or(0));
            let last = radius.exponent().unwrap_or(0) - i64::from(bits) - 12;
            let useful = u32::try_from(size - last).unwrap_or(2).clamp(2, x.prec());
            dyadic(&Float::with_val(useful, x))
        });
        Ok(Certificate {
            schema: SCHEMA.to_owned(),
            tool: concat!("couplet ", env!("CARGO_PKG_VERSION")).to_owned(),
            claim: ClaimFile::new(&self.claim),
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
    /// Looks for a box that is mapped into itself with room to spare: the radii in proportion to the
    /// values at first, then to those of the image.
    fn new(claim: &Claim, root: &[Float], bits: u32) -> Option<Self> {
        let centre: Vec<Float> = root.iter().map(|x| Float::with_val(bits, x)).collect();
        let balls: Vec<Ball> = centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
        let slopes = claim.residuals(&claim.variables(&balls));
        let jacobian = slopes.iter().map(|r: &Dual<Ball>| {
            (0..balls.len()).map(|k| Float::with_val(bits, r.derivative(k).mid())).collect()
        });
        // The inverse only has to be near; the worse the condition, the nearer.
        let near = bits.min(WITNESS_BITS as u32);
        let inverse: Vec<Vec<Float>> = inverse(jacobian.collect())?
            .into_iter()
            .map(|row| row.into_iter().map(|y| Float::with_val(near, y)).collect())
            .collect();
        let mut shape: Vec<Magnitude> = centre.iter().map(Magnitude::lower).collect();
        let mut best = None;
        for _ in 0..4 {
            let found = (0..TRIALS).find_map(|trial| {
                let scale = Magnitude::upper(&Float::with_val(53, 0.8f64.powi(trial)));
                let radius: Vec<Magnitude> = shape.iter().map(|s| s.times(scale)).collect();
                let image = contracted::<Ball>(claim, &centre, &radius, &inverse)?;
                // The other arithmetic encloses less tightly, and has to succeed as well.
                contracted::<AstroInterval>(claim, &centre, &radius, &inverse)?;
                Some((radius, image))
            });
            let Some((radius, image)) = found else { break };
            let values: Vec<Magnitude> = centre.iter().map(Magnitude::lower).collect();
            let image: Vec<Magnitude> = image.iter().map(Ball::rad).collect();
            let widest = image.iter().zip(&values).map(|(i, v)| i.over(*v)).max()?;
            shape = image.iter().map(|i| i.over(widest)).collect();
            best = Some(radius);
        }
        Some(Self { centre, radius: best?, inverse })
    }
}

/// The image of the box, if it lies in the interior of a box nine tenths as large and no denominator
/// vanishes.
fn contracted<E: Engine>(
    claim: &Claim,
    centre: &[Float],
    radius: &[Magnitude],
    inverse: &[Vec<Float>],
) -> Option<Vec<E>> {
    let bits = centre.iter().map(|x| x.prec()).max().unwrap_or(BITS) as usize;
    let exact = |x: &Float| E::exact(&Dyadic::from(x), bits);
    let around = |factor: f64| -> Vec<E> {
        let factor = Magnitude::upper(&Float::with_val(53, factor));
        let side = |(x, r): (&Float, &Magnitude)| {
            E::around(&Dyadic::from(x), &Dyadic::from(&r.times(factor).to_float()), bits)
        };
        centre.iter().zip(radius).map(side).collect()
    };
    let (points, domain): (Vec<E>, Vec<E>) = (centre.iter().map(exact).collect(), around(1.0));
    if !claim.denominators(&claim.configuration(&domain)).iter().all(Enclosure::excludes_zero) {
        return None;
    }
    let rows: Vec<Vec<E>> = inverse.iter().map(|row| row.iter().map(exact).collect()).collect();
    let residuals = claim.residuals(&claim.configuration(&points));
    let slopes = claim.residuals(&claim.variables(&domain));
    let image = krawczyk::image(&points, &residuals, &slopes, &rows, &domain);
    krawczyk::is_contracted(&image, &around(0.9)).then_some(image)
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
            // Next to the end of rotation.
            ("2.59084318392461", "inf"),
            ("2.590843443", "inf"),
        ];
        for (alpha, mu) in cases {
            let friction = match mu {
                "inf" => Friction::Infinite,
                mu => Friction::Coefficient(mu.parse().unwrap()),
            };
            let arch =
                Arch::new(SelfWeight::Milankovitch, alpha.parse().unwrap(), friction).unwrap();
            let certificate =
                certify_state(&arch, 25).unwrap_or_else(|e| panic!("{alpha} {mu}: {e}"));
            accepted(&certificate, 25);
        }
    }
}
