//! Many arches, in arrays of doubles: a half opening, a friction and perhaps a thickness each.
//!
//! A double is the number that it is, exactly. Rows of one half opening share its proofs ([`Column`]), wherever they
//! stand, and no bit depends on it.

use super::certify::Certify;
use super::column::Column;
use super::digits::{Answer, AssessmentDigits};
use crate::arch::SelfWeight;
use crate::certify::asymmetric_thicknesses;
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction, Mode, Quantity};
use crate::prover::Figure;
use crate::prover::{Error, Refused};
use rayon::prelude::*;
use rug::Rational;
use std::collections::HashMap;

/// With so many digits a decimal number tells the double.
const DIGITS: usize = 17;
/// As many rows of a half opening as cost less together.
const SHARED: usize = 4;

/// What became of a row, by the code that it has in arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum RowVerdict {
    /// The arch stands: at some thickness, or at the one that it has.
    Stands = 0,
    /// It does not.
    Falls = 1,
    /// Nothing is known.
    Undecided = 2,
    /// The row makes no sense: a number is none, or out of its range.
    Refused = 3,
}

/// What is known of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What became of it.
    pub verdict: RowVerdict,
    /// How an arch collapses at its least thickness, where that is asked and known.
    pub mode: Option<Mode>,
    /// For each quantity the double nearest to the value with outward bounds: not a number where there is no value,
    /// infinite where it is.
    pub values: Vec<[f64; 3]>,
}

impl Row {
    /// The place of the mode in [`Mode::ALL`]; 255 where there is none.
    pub fn mode_code(&self) -> u8 {
        let place = self.mode.and_then(|mode| Mode::ALL.iter().position(|of| *of == mode));
        place.and_then(|place| u8::try_from(place).ok()).unwrap_or(u8::MAX)
    }

    fn without(verdict: RowVerdict, quantities: &[Quantity]) -> Self {
        Self { verdict, mode: None, values: vec![[f64::NAN; 3]; quantities.len()] }
    }

    /// With those of the figures that are asked for.
    fn with<'a>(
        (verdict, mode): (RowVerdict, Option<Mode>),
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

    fn state(found: Result<&Answer, &Error>, quantities: &[Quantity]) -> Self {
        match found {
            Ok(Answer::Stands(digits)) => {
                let is = (RowVerdict::Stands, Some(digits.mode));
                Self::with(is, quantities, digits.figures())
            }
            Ok(Answer::Falls { enough, .. }) => {
                let sliding = enough.as_ref().and_then(|enough| enough.sliding_friction.as_ref());
                let sliding = sliding.map(|figure| (Quantity::SlidingFriction, Some(figure)));
                Self::with((RowVerdict::Falls, None), quantities, sliding.into_iter())
            }
            Err(Error::Undecided(_)) => Self::without(RowVerdict::Undecided, quantities),
            Err(Error::Refused(_)) => Self::without(RowVerdict::Refused, quantities),
        }
    }

    fn assessment(found: &Result<AssessmentDigits, Refused>, quantities: &[Quantity]) -> Self {
        let Ok(digits) = found else { return Self::without(RowVerdict::Refused, quantities) };
        let verdict = match digits.stands {
            Ok(true) => RowVerdict::Stands,
            Ok(false) => RowVerdict::Falls,
            Err(_) => RowVerdict::Undecided,
        };
        Self::with((verdict, None), quantities, digits.figures())
    }
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

/// What is asked of every row of arrays of doubles.
///
/// ```
/// use couplet_prove::certify::state::{Doubles, RowVerdict};
/// use couplet_prove::prelude::*;
/// let asked = Doubles { weight: SelfWeight::Milankovitch, quantities: vec![Quantity::Thickness] };
/// let rows = asked.rows(&[2.45, 2.45, 4.0], &[1.35, 0.1, 1.0], None)?;
/// assert_eq!((rows[0].mode, rows[0].values[0][0]), (Mode::named("rrs"), 0.65024378080138357));
/// assert_eq!(rows[1].verdict, RowVerdict::Falls);
/// assert_eq!(rows[2].verdict, RowVerdict::Refused);
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
///
/// See also: [`Certify::certify_alone`] and [`Certify::certify_thickness`], which answer one.
#[derive(Clone, Debug)]
pub struct Doubles {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The quantities, of [`Quantity::STATE_ROW`], or of [`Quantity::ASSESSMENT_ROW`] where there are thicknesses.
    pub quantities: Vec<Quantity>,
}

impl Doubles {
    /// The answers for half openings in `(0, pi)`, rad, and frictions from 0 to infinity, both of one length; with
    /// thicknesses, of the same length and in `(0, 2]`, for arches that have these. A row with a number out of its range is
    /// [`RowVerdict::Refused`], and no other is. All are refused where the lengths differ, or a quantity is asked for that such
    /// arches do not have.
    ///
    /// ```
    /// use couplet_prove::certify::Refused;
    /// use couplet_prove::certify::state::Doubles;
    /// use couplet_prove::prelude::*;
    /// let asked = Doubles { weight: SelfWeight::Heyman, quantities: vec![Quantity::GeometricSafety] };
    /// assert_eq!(asked.rows(&[1.0, 1.2], &[0.5], None), Err(Refused::Lengths(vec![2, 1])));
    /// // A safety is that of a thickness.
    /// assert!(matches!(asked.rows(&[1.0], &[0.5], None), Err(Refused::NoSuchQuantity { .. })));
    /// assert!(asked.rows(&[1.0], &[0.5], Some(&[0.1])).is_ok());
    /// ```
    ///
    /// Inside a pool of rayon its threads share the work; elsewhere all is done in the thread that calls.
    pub fn rows(
        &self,
        half_openings: &[f64],
        frictions: &[f64],
        thicknesses: Option<&[f64]>,
    ) -> Result<Vec<Row>, Refused> {
        let mut lengths = vec![half_openings.len(), frictions.len()];
        lengths.extend(thicknesses.map(<[f64]>::len));
        if lengths.iter().any(|length| *length != lengths[0]) {
            return Err(Refused::Lengths(lengths));
        }
        let possible = match thicknesses {
            Some(_) => &Quantity::ASSESSMENT_ROW[..],
            None => &Quantity::STATE_ROW,
        };
        self.quantities.iter().try_for_each(|of| Refused::quantity(*of, possible))?;
        let arches: Vec<(f64, f64)> =
            half_openings.iter().copied().zip(frictions.iter().copied()).collect();
        if let Some(etas) = thicknesses {
            let all: Vec<_> = arches.into_iter().zip(etas).collect();
            return Ok(each(&all, |&((alpha, mu), &eta)| {
                self.with_asymmetric(self.assessment(alpha, mu, eta), alpha, mu)
            }));
        }
        let columns = self.columns(half_openings);
        Ok(each(&arches, |&(alpha, mu)| {
            let row = self.state(alpha, mu, columns.get(&alpha.to_bits()));
            self.with_asymmetric(row, alpha, mu)
        }))
    }

    /// The row with the asymmetric thickness of its arch, if it stands and that is asked.
    fn with_asymmetric(&self, mut row: Row, alpha: f64, mu: f64) -> Row {
        let place = self.quantities.iter().position(|of| *of == Quantity::AsymmetricThickness);
        if let Some(place) = place.filter(|_| row.verdict == RowVerdict::Stands)
            && let Some(arch) = self.arch(alpha, mu)
            && let Ok(all) = asymmetric_thicknesses(&arch, DIGITS)
            && let Some(largest) = all.first()
        {
            row.values[place] = [largest.double, largest.binary.lower, largest.binary.upper];
        }
        row
    }

    fn refused(&self) -> Row {
        Row::without(RowVerdict::Refused, &self.quantities)
    }

    fn arch(&self, alpha: f64, mu: f64) -> Option<Arch> {
        Arch::new(self.weight, exact(alpha)?, friction(mu)?).ok()
    }

    /// Whether the frictions at which the mode changes are asked for.
    fn has_frictions(&self) -> bool {
        self.quantities.iter().any(|of| of.is_friction())
    }

    /// The state of an arch; in its column, where there is one.
    fn state(&self, alpha: f64, mu: f64, column: Option<&Column>) -> Row {
        let quantities = &self.quantities;
        if let Some(column) = column {
            let Some(friction) = friction(mu) else { return self.refused() };
            if self.has_frictions() {
                return Row::state(column.certify(friction).as_ref(), quantities);
            }
            return match column.shared_at(mu) {
                Some(found) => Row::state(Ok(found), quantities),
                None => Row::state(column.certify_alone(friction).as_deref(), quantities),
            };
        }
        let Some(arch) = self.arch(alpha, mu) else { return self.refused() };
        let found = match self.has_frictions() {
            true => arch.certify(DIGITS),
            false => arch.certify_alone(DIGITS),
        };
        Row::state(found.as_ref(), quantities)
    }

    fn assessment(&self, alpha: f64, mu: f64, eta: f64) -> Row {
        let Some((arch, eta)) = self.arch(alpha, mu).zip(exact(eta)) else { return self.refused() };
        Row::assessment(&arch.certify_thickness(&eta, DIGITS), &self.quantities)
    }

    /// The half openings of so many rows that a column is cheaper.
    fn columns(&self, alphas: &[f64]) -> HashMap<u64, Column> {
        let mut counts: HashMap<u64, usize> = HashMap::new();
        alphas.iter().for_each(|alpha| *counts.entry(alpha.to_bits()).or_default() += 1);
        let many: Vec<u64> = counts
            .into_iter()
            .filter(|(_, count)| *count >= SHARED)
            .map(|(bits, _)| bits)
            .collect();
        let column = |bits: &u64| {
            let alpha = exact(f64::from_bits(*bits))?;
            Some((*bits, Column::new(self.weight, alpha, DIGITS).ok()?))
        };
        each(&many, column).into_iter().flatten().collect()
    }
}

/// The same of each, in the threads of the pool that this is called in, if it is one: the global pool is not asked for,
/// as a forked process would wait for it for ever.
fn each<A: Sync, B: Send>(all: &[A], of: impl Fn(&A) -> B + Send + Sync) -> Vec<B> {
    match rayon::current_thread_index() {
        Some(_) => all.par_iter().map(of).collect(),
        None => all.iter().map(of).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(quantities: &[Quantity]) -> Doubles {
        Doubles { weight: SelfWeight::Milankovitch, quantities: quantities.to_vec() }
    }

    /// Rows of half openings that occur once, and so often that they share a column.
    fn grid() -> (Vec<f64>, Vec<f64>) {
        let alphas = [0.7, 1.4, 2.45, 2.61, 3.0];
        let mus = [0.05, 0.3, 0.6, 1.35, 2.5, f64::INFINITY];
        let rows = alphas.iter().flat_map(|&alpha| mus.iter().map(move |&mu| (alpha, mu)));
        rows.chain([(1.1, 0.4), (1.2, 0.4)]).unzip()
    }

    /// Bits, as what is not a number is not equal to itself.
    fn bits(rows: &[Row]) -> Vec<(RowVerdict, u8, Vec<[u64; 3]>)> {
        let row = |row: &Row| {
            let values = row.values.iter().map(|value| value.map(f64::to_bits)).collect();
            (row.verdict, row.mode_code(), values)
        };
        rows.iter().map(row).collect()
    }

    #[test]
    fn a_row_is_what_it_is_alone_whatever_the_threads() {
        let asked = asked(&[Quantity::Thrust, Quantity::Thickness]);
        let (alphas, mus) = grid();
        let rows = |alphas: &[f64], mus: &[f64]| asked.rows(alphas, mus, None).unwrap();
        let together = bits(&rows(&alphas, &mus));
        let alone = alphas.iter().zip(&mus).flat_map(|(&alpha, &mu)| rows(&[alpha], &[mu]));
        assert_eq!(together, bits(&alone.collect::<Vec<_>>()));
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        assert_eq!(together, bits(&pool.install(|| rows(&alphas, &mus))));
        let falls = together.iter().filter(|(verdict, ..)| *verdict == RowVerdict::Falls).count();
        assert!((5..25).contains(&falls), "{falls}");
    }

    #[test]
    fn a_row_with_frictions_is_what_it_is_alone() {
        let asked = asked(&[Quantity::SlidingFriction, Quantity::RotationalFriction]);
        let (alphas, mus) = grid();
        let rows = |alphas: &[f64], mus: &[f64]| asked.rows(alphas, mus, None).unwrap();
        let together = rows(&alphas, &mus);
        let alone = alphas.iter().zip(&mus).flat_map(|(&alpha, &mu)| rows(&[alpha], &[mu]));
        assert_eq!(bits(&together), bits(&alone.collect::<Vec<_>>()));
        let is_known = |row: &&Row| row.values[0][0] > 0.0;
        assert!(together.iter().filter(is_known).count() > 20);
    }

    #[test]
    fn a_value_is_that_of_the_arch() {
        let asked = asked(&[Quantity::RotationalFriction, Quantity::Thickness]);
        let row = &asked.rows(&[1.5], &[0.5], None).unwrap()[0];
        let arch = Arch::parse("milankovitch", "1.5", "0.5").unwrap();
        let state = arch.least(17).unwrap();
        let rotational = state.frictions.unwrap().rotational.unwrap();
        assert_eq!(
            [row.values[0][0], row.values[1][0]],
            [rotational.double, state.thickness.double]
        );
        assert_eq!(row.mode, Some(state.mode));
        let [value, lower, upper] = row.values[1];
        assert!(lower <= value && value <= upper && lower < upper);
    }

    #[test]
    fn the_asymmetric_thickness_is_there_for_arches_that_have_one_and_stand() {
        let asked = asked(&[Quantity::AsymmetricThickness]);
        let (alphas, mus) = ([2.3, 2.3, 2.3, 1.5], [1.05, 1.2, 1.05, 0.6]);
        // The double next to 2.3 is another half opening.
        let arch = asked.arch(2.3, 1.05).unwrap();
        let known = asymmetric_thicknesses(&arch, DIGITS).unwrap()[0].double;
        approx::assert_abs_diff_eq!(known, 0.583_084_449_604_488_6, epsilon = 1e-15);
        for etas in [None, Some(&[0.55, 0.55, 0.5, 0.2][..])] {
            let rows = asked.rows(&alphas, &mus, etas).unwrap();
            let [value, lower, upper] = rows[0].values[0];
            assert_eq!(value, known);
            assert!(lower <= value && value <= upper && lower < upper);
            assert!(rows[1].values[0][0].is_nan() && rows[3].values[0][0].is_nan());
            assert_eq!(rows[2].values[0][0].is_nan(), etas.is_some(), "one falls");
        }
    }

    #[test]
    fn a_row_that_makes_no_sense_is_refused_and_no_other() {
        let asked = asked(&[Quantity::GeometricSafety]);
        let nan = f64::NAN;
        let rows = [(nan, 1.0, 0.1), (1.0, nan, 0.1), (1.0, 1.0, nan), (4.0, 1.0, 0.1)];
        let rows =
            [&rows[..], &[(1.0, -1.0, 0.1), (1.0, 1.0, 0.0), (1.0, 1.0, 2.5), (-0.0, 1.0, 1.0)]];
        for &(alpha, mu, eta) in rows.concat().iter() {
            let found = asked.rows(&[1.0, alpha], &[1.0, mu], Some(&[0.1, eta])).unwrap();
            let verdicts = found.iter().map(|row| row.verdict).collect::<Vec<_>>();
            assert_eq!(verdicts, [RowVerdict::Stands, RowVerdict::Refused], "{alpha} {mu} {eta}");
            assert!(found[1].values[0].iter().all(|x| x.is_nan()) && found[1].mode_code() == 255);
        }
        assert!(asked.rows(&[], &[], Some(&[])).unwrap().is_empty());
    }

    #[test]
    fn arrays_of_other_lengths_and_quantities_of_other_arches_are_refused() {
        let safety = asked(&[Quantity::Thickness, Quantity::GeometricSafety]);
        let lengths = |all: &[usize]| Err(Refused::Lengths(all.to_vec()));
        assert_eq!(safety.rows(&[1.0, 1.2, 1.4], &[0.6], None), lengths(&[3, 1]));
        assert_eq!(safety.rows(&[1.0], &[0.6], Some(&[])), lengths(&[1, 1, 0]));
        for (thicknesses, quantity) in
            [(None, Quantity::GeometricSafety), (Some(&[0.1][..]), Quantity::Thickness)]
        {
            let refused = safety.rows(&[1.0], &[0.6], thicknesses).unwrap_err();
            let told =
                matches!(&refused, Refused::NoSuchQuantity { quantity: of, .. } if *of == quantity);
            assert!(told, "{refused}");
        }
    }
}
