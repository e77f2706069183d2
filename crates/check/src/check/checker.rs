//! The checker: from a certificate and the equations to a verdict.
//!
//! It believes nothing that a certificate says about residuals, slopes or roundings; it computes them
//! from the claim. What it takes are witnesses: where to look, and how to precondition. What it proves:
//!
//! 1. **One root in the large box.** With the slopes of the residuals on the box, the Krawczyk operator
//!    maps the box into itself, and no denominator of the equations vanishes there.
//! 2. **The root in the small box**, which lies inside the large one. The same slopes hold on it, so
//!    that only the residuals at its centre are evaluated to full precision.
//! 3. **The claim**: the physical range; for a state, that it is admissible on the whole half arch, that
//!    no thinner arch stands, and that it is the mode stated; for a landmark, the same of each mode that
//!    meets there; for another verdict, what decides it; for an asymmetric solution, that it is admissible on the
//!    whole arch and that its joints move their way.
//! 4. **The decimals** are the correct rounding of everything in the small box.

use super::decimals::Decimals;
use super::format::{Certificate, Witness};
use super::krawczyk;
use super::refusal::Refusal;
use super::whole;
use crate::arch::{Configuration, Unknown};
use crate::number::{Angle, AstroInterval, Dual, Dyadic, Enclosure, Engine};
use crate::problem::{Problem, Quantity, System, Verdict};

/// The verdict of a successful check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Accepted {
    /// Problem that was claimed.
    pub problem: Problem,
    /// Number of digits that the values have.
    pub digits: usize,
    /// The values, each proved to be the correct rounding, in one spelling whatever that of the file is.
    pub values: Vec<(Quantity, String)>,
}

/// Bits of a radius; enough for an entry of the inverse where little cancels.
pub const WITNESS_BITS: usize = 256;
/// Bits that the centre of a large box and an entry of the inverse may have, and the centre of a small box beyond its
/// digits: an arch with a tiny opening loses many.
pub const EXTRA_BITS: usize = 24_000;
/// Bits beyond the longest number, of a box or of the claim, to work in.
const GUARD: usize = 64;
/// The largest number of digits of any certificate.
pub const MAX_DIGITS: usize = 1_000_000;

/// The digits up to which a certificate is checked in the second arithmetic, astro-float, by default: at
/// this size that takes some seconds.
pub const ASTRO_DIGITS: usize = 50_000;

/// Checks the bytes of a file in pure Rust, up to [`ASTRO_DIGITS`] digits.
///
/// Guaranteed if it is accepted: the equations of the claim have exactly one root in the stated box, the
/// conditions of the claim hold there, and each value is its correct rounding. Nothing of the file is
/// believed. A [`Refusal`] names the place and says nothing about the truth.
///
/// ```
/// let file = include_bytes!("../../../../proofs/constants/triple-point-heyman.json");
/// let accepted = couplet_check::check::verify(file)?;
/// assert_eq!(accepted.digits, 100);
/// assert!(couplet_check::check::verify(b"{}").is_err());
/// # Ok::<(), couplet_check::check::Refusal>(())
/// ```
///
/// See also: [`check`] for another arithmetic or another limit.
pub fn verify(bytes: &[u8]) -> Result<Accepted, Refusal> {
    check::<AstroInterval>(bytes, ASTRO_DIGITS)
}

/// Checks the bytes of a file in the arithmetic `E`, up to `max_digits` digits and never more than
/// [`MAX_DIGITS`]. Whatever the bytes are, the answer is a verdict: a [`Refusal`] names the place.
pub fn check<E: Engine>(bytes: &[u8], max_digits: usize) -> Result<Accepted, Refusal> {
    check_certificate::<E>(&Certificate::read(bytes)?, max_digits)
}

/// Checks a certificate that has been read.
pub fn check_certificate<E: Engine>(
    certificate: &Certificate,
    max_digits: usize,
) -> Result<Accepted, Refusal> {
    let problem = certificate.claim.resolve()?;
    let system = problem.system();
    let digits = certificate.digits;
    if !(1..=MAX_DIGITS).contains(&digits) {
        return Err(Refusal::Digits(digits, MAX_DIGITS));
    }
    if digits > max_digits {
        return Err(Refusal::Limit(digits, max_digits));
    }
    sizes(&system, certificate)?;
    if problem.witness_bits() > EXTRA_BITS {
        return Err(Refusal::Large { place: "claim", bits: EXTRA_BITS });
    }
    let longest = |witness| longest(witness).max(problem.witness_bits()) + GUARD;
    let (wide, bits) = (longest(&certificate.unique), longest(&certificate.root));
    let domain = boxed::<E>(&certificate.unique, wide);
    let inverse: Vec<Vec<E>> = certificate.inverse.iter().map(|row| exact(row, wide)).collect();
    let given = problem.given::<E>(wide as u32);
    let at = system.place(given.clone(), &domain);
    if !system.denominators(&at).iter().all(Enclosure::excludes_zero) {
        return Err(Refusal::Denominator("unique"));
    }
    let slopes: Vec<Dual<E>> = system.residuals(&system.variables(&at));
    // The operator is applied to distances from the centre, which have few bits, as have residuals near a root.
    let contracts = |place, centre: &Configuration<E>, radius: &[Dyadic]| {
        let residuals = system.residuals(centre);
        let residuals: Vec<E> = residuals.iter().map(|x| x.with_bits(wide)).collect();
        let origin = vec![E::zero(wide); radius.len()];
        let around = |radius| E::zero(wide).widened_by(radius);
        let distances: Vec<E> = radius.iter().map(around).collect();
        let image = krawczyk::image(&origin, &residuals, &slopes, &inverse, &distances);
        let fails = (0..image.len()).find(|&k| !image[k].lies_inside(&distances[k]));
        fails.map_or(Ok(()), |k| {
            Err(Refusal::Contraction { place, unknown: system.unknowns[k].name() })
        })
    };
    let centre = system.place(given, &exact(&certificate.unique.centre, wide));
    contracts("unique", &centre, &certificate.unique.radius)?;

    let small = boxed::<E>(&certificate.root, bits);
    let outside = (0..small.len()).find(|&k| !small[k].lies_inside(&domain[k]));
    if let Some(k) = outside {
        return Err(Refusal::Outside(system.unknowns[k].name()));
    }
    let given = problem.given::<E>(bits as u32);
    let centre = system.place(given.clone(), &exact(&certificate.root.centre, bits));
    contracts("root", &centre, &certificate.root.radius)?;

    // On the small box sine and cosine differ from those at its centre by its radius at most.
    let at = system.place_with(given, &small, |k, rad| {
        let Some(Angle { sin, cos, .. }) = centre.angle(system.unknowns[k]) else {
            return Angle::new(rad.clone());
        };
        let radius = &certificate.root.radius[k];
        Angle { rad: rad.clone(), sin: sin.widened_by(radius), cos: cos.widened_by(radius) }
    });
    // Few bits tell most signs.
    let holds = |at: &Configuration<E>, bits| problem.first_failure(at, bits as u32);
    let near = at.map_ref(|x| x.with_bits(wide));
    if let Some(condition) = holds(&near, wide).and_then(|_| holds(&at, bits)) {
        return Err(Refusal::Condition(condition.label()));
    }
    // That an asymmetric solution is admissible is seen on the whole arch.
    if let Problem::Asymmetric { mode, arch } = &problem
        && let Some(contact) = whole::first_failure(*mode, arch.weight(), &(&near).into())
    {
        return Err(Refusal::Condition(whole::label(contact)));
    }
    let values = Decimals::new(&problem, &at, digits, bits).accept(&certificate.values)?;
    // What stands needs no value.
    let stands = matches!(&problem, Problem::Verdict { verdict: Verdict::Stands(_), .. });
    if values.is_empty() && !stands {
        return Err(Refusal::NoValues);
    }
    Ok(Accepted { problem, digits, values })
}

/// The bits of the longest number of a box.
fn longest(witness: &Witness) -> usize {
    witness.centre.iter().map(Dyadic::bits).max().unwrap_or(0)
}

/// Checks the sizes of everything before anything is computed.
fn sizes(system: &System, certificate: &Certificate) -> Result<(), Refusal> {
    let n = system.unknowns.len();
    let size = |place, found: usize| {
        if found == n { Ok(()) } else { Err(Refusal::Size { place, found, expected: n }) }
    };
    let allowed = certificate.digits * 10 / 3 + EXTRA_BITS;
    let bounded = |place, bits: usize, numbers: &[Dyadic]| {
        let fits = |x: &Dyadic| x.bits() <= bits;
        if numbers.iter().all(fits) { Ok(()) } else { Err(Refusal::Large { place, bits }) }
    };
    size("inverse", certificate.inverse.len())?;
    for row in &certificate.inverse {
        size("inverse", row.len())?;
        bounded("inverse", EXTRA_BITS, row)?;
    }
    let boxes = [("unique", &certificate.unique, EXTRA_BITS), ("root", &certificate.root, allowed)];
    for (place, witness, bits) in boxes {
        size(place, witness.centre.len())?;
        size(place, witness.radius.len())?;
        bounded(place, bits, &witness.centre)?;
        bounded(place, WITNESS_BITS, &witness.radius)?;
        let flat = |radius: &Dyadic| radius.is_zero() || radius.is_negative();
        if let Some(k) = witness.radius.iter().position(flat) {
            let unknown: Unknown = system.unknowns[k];
            return Err(Refusal::Radius { place, unknown: unknown.name() });
        }
    }
    Ok(())
}

fn exact<E: Engine>(values: &[Dyadic], bits: usize) -> Vec<E> {
    values.iter().map(|x| E::exact(x, bits)).collect()
}

fn boxed<E: Engine>(witness: &Witness, bits: usize) -> Vec<E> {
    let sides = witness.centre.iter().zip(&witness.radius);
    sides.map(|(centre, radius)| E::exact(centre, bits).widened_by(radius)).collect()
}
