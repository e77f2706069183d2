//! Certificates at roots of the equations that the checker reads, for it to accept, next to where the statics say that
//! one is.

use couplet_check::check::{Certificate, ClaimFile, SCHEMA, ValueFile, Witness};
use couplet_check::problem::Problem;
use couplet_number::number::{Ball, Dual, Dyadic};
use rug::{Float, Rational};
use std::collections::BTreeMap;

/// A certificate with values of so many digits, where Newton's method finds its way.
pub(crate) fn made(
    problem: &Problem,
    start: &BTreeMap<&str, Rational>,
    digits: usize,
) -> Option<Certificate> {
    let bits = 256 + 4 * digits as u32;
    let system = problem.system();
    let names: Vec<&str> = system.unknowns.iter().map(|unknown| unknown.name()).collect();
    let first = names.iter().map(|name| Some(Float::with_val(bits, start.get(name)?)));
    let mut x = first.collect::<Option<Vec<Float>>>()?;
    let mut inverse = Vec::new();
    for _ in 0..8 {
        let balls: Vec<Ball> = x.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
        let at = system.place(problem.given(bits), &balls);
        let residuals = system.residuals(&system.variables(&at));
        let slopes = |r: &Dual<Ball>| (0..x.len()).map(|k| r.derivative(k).mid().clone()).collect();
        inverse = inverted(residuals.iter().map(slopes).collect())?;
        for (x, row) in x.iter_mut().zip(&inverse) {
            for (y, r) in row.iter().zip(&residuals) {
                *x -= Float::with_val(bits, y * r.value().mid());
            }
        }
    }
    let dyadic = |bits: u32, x: &Float| Dyadic::from(&Float::with_val(bits, x));
    let radius = |shift: i32| -> Vec<Dyadic> {
        let size =
            |x: &Float| x.get_exp().map(|exponent| Dyadic::new(false, vec![1], exponent - shift));
        x.iter().map(|x| size(x).unwrap_or_else(|| Dyadic::new(false, vec![1], -shift))).collect()
    };
    let mut known: BTreeMap<&str, Float> = names.iter().copied().zip(x.iter().cloned()).collect();
    if let (Problem::State { .. }, Some(eta), Some(h)) =
        (problem, known.get("thickness"), known.get("thrust"))
    {
        known.insert("intrinsic_thrust", Float::with_val(bits, eta * h));
    }
    let value = |(name, x): (&&str, &Float)| ValueFile {
        quantity: (*name).to_owned(),
        value: decimal(x, digits),
    };
    Some(Certificate {
        schema: SCHEMA.to_owned(),
        tool: "a test".to_owned(),
        claim: ClaimFile::new(problem),
        digits,
        unique: Witness { centre: x.iter().map(|x| dyadic(64, x)).collect(), radius: radius(36) },
        inverse: inverse.iter().map(|row| row.iter().map(|y| dyadic(64, y)).collect()).collect(),
        root: Witness {
            centre: x.iter().map(|x| dyadic(bits, x)).collect(),
            radius: radius(64 + 4 * digits as i32),
        },
        values: known.iter().map(value).collect(),
    })
}

/// A number rounded to so many digits.
fn decimal(x: &Float, digits: usize) -> String {
    let (_, text, exponent) = x.to_sign_string_exp(10, Some(digits));
    format!("{}.{}e{}", &text[..1], &text[1..], exponent.expect("not zero") - 1)
}

/// The inverse of a matrix by elimination, where a pivot is left.
fn inverted(mut rows: Vec<Vec<Float>>) -> Option<Vec<Vec<Float>>> {
    let n = rows.len();
    for (i, row) in rows.iter_mut().enumerate() {
        let bits = row[0].prec();
        row.extend((0..n).map(|k| Float::with_val(bits, u32::from(i == k))));
    }
    for k in 0..n {
        let size = |row: &Vec<Float>| Float::with_val(64, row[k].abs_ref());
        let pivot = (k..n).max_by(|a, b| size(&rows[*a]).total_cmp(&size(&rows[*b])))?;
        rows.swap(k, pivot);
        let head = rows[k][k].clone();
        if head.is_zero() || !head.is_finite() {
            return None;
        }
        rows[k].iter_mut().for_each(|x| *x /= &head);
        for i in (0..n).filter(|i| *i != k) {
            let (factor, own) = (rows[i][k].clone(), rows[k].clone());
            rows[i].iter_mut().zip(own).for_each(|(x, y)| *x -= y * &factor);
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}
