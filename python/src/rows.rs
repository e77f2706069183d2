//! Many arches, in arrays of doubles: a half opening, a friction and perhaps a thickness each.
//!
//! A double is the number that it is, exactly. Rows of one half opening share its proofs ([`Column`]), wherever they
//! stand, and no bit depends on it.

use crate::pool::on_threads;
use crate::{CoupletError, asked};
use couplet::arch::SelfWeight;
use couplet::certify::Undecided;
use couplet::certify::state::{Answer, AssessmentDigits, Certify, Column, Figure};
use couplet::cli::parse;
use couplet::number::ExactNumber;
use couplet::problem::{Arch, Friction, Mode, Quantity, is_thickness};
use couplet::rug::Rational;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use rayon::prelude::*;
use std::collections::HashMap;

/// The codes of the verdicts, as `couplet.VERDICTS` lists them.
const STANDS: u8 = 0;
const FALLS: u8 = 1;
const UNDECIDED: u8 = 2;
const REFUSED: u8 = 3;
/// Where there is no mode.
const NO_MODE: u8 = 255;

/// With so many digits a decimal number tells the double.
const DIGITS: usize = 17;
/// As many rows of a half opening as cost less together.
const SHARED: usize = 4;

/// What is known of a row: the nearest double of each value with its bounds, not a number where there is none.
struct Row {
    verdict: u8,
    mode: u8,
    values: Vec<[f64; 3]>,
}

impl Row {
    /// Without values.
    fn without(verdict: u8, quantities: &[Quantity]) -> Self {
        Self { verdict, mode: NO_MODE, values: vec![[f64::NAN; 3]; quantities.len()] }
    }

    /// With those of the figures that are asked for.
    fn with<'a>(
        (verdict, mode): (u8, u8),
        quantities: &[Quantity],
        figures: impl Iterator<Item = (Quantity, Option<&'a Figure>)>,
    ) -> Self {
        let mut row = Self { mode, ..Self::without(verdict, quantities) };
        for (of, figure) in figures {
            let places = quantities.iter().zip(&mut row.values).filter(|(asked, _)| **asked == of);
            for (_, value) in places {
                *value = match figure {
                    Some(figure) => [figure.double, figure.binary.lower, figure.binary.upper],
                    None => [f64::INFINITY; 3],
                };
            }
        }
        row
    }

    fn state(found: Result<&Answer, &Undecided>, quantities: &[Quantity]) -> Self {
        match found {
            Ok(Answer::Stands(digits)) => {
                let mode = Mode::ALL.iter().position(|mode| *mode == digits.mode);
                let mode = mode.and_then(|mode| u8::try_from(mode).ok()).unwrap_or(NO_MODE);
                Self::with((STANDS, mode), quantities, digits.figures())
            }
            Ok(Answer::Falls { enough, .. }) => {
                let sliding = enough.as_ref().and_then(|enough| enough.sliding_friction.as_ref());
                let sliding = sliding.map(|figure| (Quantity::SlidingFriction, Some(figure)));
                Self::with((FALLS, NO_MODE), quantities, sliding.into_iter())
            }
            Err(_) => Self::without(UNDECIDED, quantities),
        }
    }

    fn assessment(found: &Result<AssessmentDigits, Undecided>, quantities: &[Quantity]) -> Self {
        let Ok(digits) = found else { return Self::without(UNDECIDED, quantities) };
        let verdict = match digits.stands {
            Ok(true) => STANDS,
            Ok(false) => FALLS,
            Err(_) => UNDECIDED,
        };
        Self::with((verdict, NO_MODE), quantities, digits.figures())
    }
}

/// The doubles of an array, in the order of bytes of this machine.
fn doubles(bytes: &[u8]) -> Vec<f64> {
    bytes.as_chunks().0.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect()
}

/// A double as the number that it is; none for one that is no number.
fn exact(x: f64) -> Option<ExactNumber> {
    Rational::from_f64(x).map(|x| ExactNumber::from(&x))
}

fn friction(mu: f64) -> Option<Friction> {
    if mu == f64::INFINITY {
        return Some(Friction::Infinite);
    }
    exact(mu).map(Friction::Coefficient)
}

/// What is asked of every row.
struct Asked {
    weight: SelfWeight,
    quantities: Vec<Quantity>,
}

impl Asked {
    fn refused(&self) -> Row {
        Row::without(REFUSED, &self.quantities)
    }

    fn arch(&self, alpha: f64, mu: f64) -> Option<Arch> {
        Arch::new(self.weight, exact(alpha)?, friction(mu)?).ok()
    }

    /// The state of an arch; in its column, where there is one.
    fn state(&self, alpha: f64, mu: f64, column: Option<&Column>) -> Row {
        let quantities = &self.quantities;
        if let Some(column) = column {
            if let Some(found) = column.shared_at(mu) {
                return Row::state(Ok(found), quantities);
            }
            let found = friction(mu).and_then(|mu| column.certify_alone(mu).ok());
            return found
                .map_or_else(|| self.refused(), |found| Row::state(found.as_deref(), quantities));
        }
        let Some(arch) = self.arch(alpha, mu) else { return self.refused() };
        let found = match quantities.iter().any(|of| of.is_friction()) {
            true => arch.certify(DIGITS),
            false => arch.certify_alone(DIGITS),
        };
        Row::state(found.as_ref(), quantities)
    }

    fn assessment(&self, alpha: f64, mu: f64, eta: f64) -> Row {
        let eta = exact(eta).filter(is_thickness);
        let Some((arch, eta)) = self.arch(alpha, mu).zip(eta) else { return self.refused() };
        Row::assessment(&arch.certify_thickness(&eta, DIGITS), &self.quantities)
    }

    /// The half openings of so many rows that a column is cheaper.
    fn columns(&self, alphas: &[f64]) -> HashMap<u64, Column> {
        if self.quantities.iter().any(|of| of.is_friction()) {
            return HashMap::new();
        }
        let mut counts: HashMap<u64, usize> = HashMap::new();
        alphas.iter().for_each(|alpha| *counts.entry(alpha.to_bits()).or_default() += 1);
        let many = counts.into_par_iter().filter(|(_, count)| *count >= SHARED);
        let column = |(bits, _)| {
            let alpha = exact(f64::from_bits(bits))?;
            Some((bits, Column::new(self.weight, alpha, DIGITS).ok()?))
        };
        many.filter_map(column).collect()
    }

    fn rows(&self, alphas: &[f64], mus: &[f64], etas: Option<&[f64]>) -> Vec<Row> {
        let arches = alphas.par_iter().zip(mus);
        if let Some(etas) = etas {
            let row = |((&alpha, &mu), &eta)| self.assessment(alpha, mu, eta);
            return arches.zip(etas).map(row).collect();
        }
        let columns = self.columns(alphas);
        let row =
            |(&alpha, &mu): (&f64, &f64)| self.state(alpha, mu, columns.get(&alpha.to_bits()));
        arches.map(row).collect()
    }
}

/// Verdicts, modes, and for each quantity the nearest doubles with their bounds, as bytes of arrays.
type Columns<'py> = (Bound<'py, PyBytes>, Bound<'py, PyBytes>, Vec<[Bound<'py, PyBytes>; 3]>);

/// The arches of arrays of doubles of one length, as bytes.
#[pyfunction]
pub(crate) fn states<'py>(
    py: Python<'py>,
    weight: &str,
    arrays: (PyBackedBytes, PyBackedBytes, Option<PyBackedBytes>),
    names: Vec<String>,
    threads: usize,
) -> PyResult<Columns<'py>> {
    let weight = parse::weight(weight).map_err(CoupletError::new_err)?;
    let possible =
        if arrays.2.is_some() { &Quantity::ASSESSMENT[..] } else { &Quantity::STATE[..] };
    let quantities = names.iter().map(|name| asked::quantity(name, possible));
    let asked = Asked { weight, quantities: quantities.collect::<PyResult<_>>()? };
    let (alphas, mus) = (doubles(&arrays.0), doubles(&arrays.1));
    let etas = arrays.2.as_deref().map(doubles);
    let rows = py.detach(|| on_threads(threads, || asked.rows(&alphas, &mus, etas.as_deref())))?;
    let codes =
        |code: fn(&Row) -> u8| PyBytes::new(py, &rows.iter().map(code).collect::<Vec<u8>>());
    let column = |quantity: usize, bound: usize| {
        let bytes = rows.iter().flat_map(|row| row.values[quantity][bound].to_ne_bytes());
        PyBytes::new(py, &bytes.collect::<Vec<u8>>())
    };
    let values = (0..names.len()).map(|quantity| [0, 1, 2].map(|bound| column(quantity, bound)));
    Ok((codes(|row| row.verdict), codes(|row| row.mode), values.collect()))
}
