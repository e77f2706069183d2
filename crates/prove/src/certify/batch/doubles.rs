//! Many arches, in arrays of doubles: a half opening, a friction and perhaps a thickness each.
//!
//! A double is the number that it is, exactly.

use super::arches::{BatchArches, Threads, grouped};
use super::batch::Batch;
use super::columns::BatchColumns;
use super::row::BatchRow;
use crate::arch::SelfWeight;
use crate::lanes::LaneArch;
use crate::number::{DoubleDouble, DoubleDoubleBall, ExactNumber};
use crate::problem::{Arch, Friction, Quantity};
use crate::prover::Refused;
use std::borrow::Cow;
use std::sync::Arc;

/// With so many digits a decimal number tells the double.
const DIGITS: usize = 17;

/// Arches in arrays of doubles.
///
/// ```
/// use couplet_prove::certify::batch::{DoubleArches, RowVerdict};
/// use couplet_prove::prelude::*;
/// let (half_openings, frictions) = (&[2.45, 2.45, 4.0], &[1.35, 0.1, 1.0]);
/// let weight = SelfWeight::Milankovitch;
/// let arches = DoubleArches { weight, half_openings, frictions, thicknesses: None };
/// let rows = arches.rows(&[Quantity::Thickness])?;
/// assert_eq!((rows[0].mode, rows[0].doubles(0)[0]), (Mode::named("rrs"), 0.65024378080138357));
/// assert_eq!(rows[1].verdict, RowVerdict::Falls);
/// assert_eq!(rows[2].verdict, RowVerdict::Refused);
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
///
/// See also: [`Balls::state`](crate::certify::state::Balls::state) and
/// [`Balls::assess`](crate::certify::state::Balls::assess), which answer one.
#[derive(Clone, Copy, Debug)]
pub struct DoubleArches<'a> {
    /// The self-weight model of all.
    pub weight: SelfWeight,
    /// In `(0, pi)`, rad.
    pub half_openings: &'a [f64],
    /// From 0 to infinity.
    pub frictions: &'a [f64],
    /// In `(0, 2]`, for arches that have them.
    pub thicknesses: Option<&'a [f64]>,
}

/// A double as the number that it is.
fn exact(x: f64) -> Result<ExactNumber, String> {
    ExactNumber::try_from(x).map_err(|_| format!("{x} is no number"))
}

impl DoubleArches<'_> {
    /// Rows with the quantities: those of [`Quantity::STATE_ROW`], or of [`Quantity::ASSESSMENT_ROW`] where there are
    /// thicknesses. A row with a number out of its range is [`RowVerdict::Refused`](super::RowVerdict::Refused), and
    /// no other is. All are refused where the lengths of the arrays differ, or a quantity is asked for that such
    /// arches do not have.
    ///
    /// ```
    /// use couplet_prove::certify::Refused;
    /// use couplet_prove::certify::batch::DoubleArches;
    /// use couplet_prove::prelude::*;
    /// let (weight, half_openings) = (SelfWeight::Heyman, &[1.0, 1.2][..]);
    /// let arches = DoubleArches { weight, half_openings, frictions: &[0.5], thicknesses: None };
    /// let safety = [Quantity::GeometricSafety];
    /// assert_eq!(arches.rows(&safety), Err(Refused::Lengths(vec![2, 1])));
    /// // A safety is that of a thickness.
    /// let arches = DoubleArches { half_openings: &[1.0], ..arches };
    /// assert!(matches!(arches.rows(&safety), Err(Refused::NoSuchQuantity { .. })));
    /// assert!(DoubleArches { thicknesses: Some(&[0.1]), ..arches }.rows(&safety).is_ok());
    /// ```
    ///
    /// Inside a pool of rayon its threads share the work; elsewhere all is done in the thread that calls.
    pub fn rows(&self, quantities: &[Quantity]) -> Result<Vec<Arc<BatchRow>>, Refused> {
        let batch = self.batch(quantities)?;
        let Some(etas) = self.thicknesses else { return Ok(batch.states(self, Threads::Pool)) };
        Ok(self.assessments(&batch, etas))
    }

    /// Columns of these rows.
    ///
    /// ```
    /// use couplet_prove::certify::batch::{DoubleArches, RowVerdict};
    /// use couplet_prove::prelude::*;
    /// let (half_openings, frictions) = (&[2.45, 2.45, 4.0], &[1.35, 0.1, 1.0]);
    /// let weight = SelfWeight::Milankovitch;
    /// let arches = DoubleArches { weight, half_openings, frictions, thicknesses: None };
    /// let columns = arches.columns(&[Quantity::Thickness])?;
    /// assert_eq!(columns.values[0][0][0], 0.65024378080138357);
    /// assert_eq!(columns.verdicts, [RowVerdict::Stands, RowVerdict::Falls, RowVerdict::Refused]);
    /// # Ok::<(), couplet_prove::certify::Error>(())
    /// ```
    pub fn columns(&self, quantities: &[Quantity]) -> Result<BatchColumns, Refused> {
        let batch = self.batch(quantities)?;
        Ok(match self.thicknesses {
            None => batch.columns(self, Threads::Pool),
            Some(etas) => BatchColumns::of(&self.assessments(&batch, etas), quantities.len()),
        })
    }

    /// The question, if such arches have an answer to it.
    fn batch(&self, quantities: &[Quantity]) -> Result<Batch, Refused> {
        let mut lengths = vec![self.half_openings.len(), self.frictions.len()];
        lengths.extend(self.thicknesses.map(<[f64]>::len));
        if lengths.iter().any(|length| *length != lengths[0]) {
            return Err(Refused::Lengths(lengths));
        }
        let possible = match self.thicknesses {
            Some(_) => &Quantity::ASSESSMENT_ROW[..],
            None => &Quantity::STATE_ROW,
        };
        quantities.iter().try_for_each(|of| Refused::quantity(*of, possible))?;
        Ok(Batch { quantities: quantities.to_vec(), digits: DIGITS, has_texts: false })
    }

    fn assessments(&self, batch: &Batch, etas: &[f64]) -> Vec<Arc<BatchRow>> {
        let rows: Vec<usize> = (0..etas.len()).collect();
        let asked = |row: usize| Ok((self.arch(row)?.into_owned(), exact(etas[row])?));
        Threads::Pool.each(&rows, |row| Arc::new(batch.assessment(asked(*row))))
    }
}

impl BatchArches for DoubleArches<'_> {
    fn count(&self) -> usize {
        self.half_openings.len()
    }

    fn openings(&self, rows: &[usize]) -> Vec<Vec<usize>> {
        grouped(rows, |row| Some(self.half_openings[row].to_bits()))
    }

    fn in_lanes(&self, row: usize) -> Option<(SelfWeight, LaneArch)> {
        let number = |x: f64| DoubleDoubleBall::exact(DoubleDouble::exact(x));
        let [alpha, mu] = [self.half_openings[row], self.frictions[row]];
        let friction = (mu != f64::INFINITY).then(|| number(mu));
        Some((self.weight, (number(alpha), friction)))
    }

    fn arch(&self, row: usize) -> Result<Cow<'_, Arch>, String> {
        let friction = match self.frictions[row] {
            f64::INFINITY => Friction::Infinite,
            mu => Friction::Coefficient(exact(mu)?),
        };
        let arch = Arch::new(self.weight, exact(self.half_openings[row])?, friction);
        arch.map(Cow::Owned).map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{RowVerdict, in_lanes};
    use super::*;
    use crate::certify::asymmetric_thicknesses;
    use crate::certify::state::Certify;

    fn rows(
        quantities: &[Quantity],
        (half_openings, frictions): (&[f64], &[f64]),
        thicknesses: Option<&[f64]>,
    ) -> Result<Vec<Arc<BatchRow>>, Refused> {
        let weight = SelfWeight::Milankovitch;
        DoubleArches { weight, half_openings, frictions, thicknesses }.rows(quantities)
    }

    fn first(row: &BatchRow) -> [f64; 3] {
        row.doubles(0)
    }

    /// Rows of half openings that occur once, and so often that they share their proofs.
    fn grid() -> (Vec<f64>, Vec<f64>) {
        let alphas = [0.7, 1.4, 2.45, 2.61, 3.0];
        let mus = [0.05, 0.3, 0.6, 1.35, 2.5, f64::INFINITY];
        let rows = alphas.iter().flat_map(|&alpha| mus.iter().map(move |&mu| (alpha, mu)));
        rows.chain([(1.1, 0.4), (1.2, 0.4)]).unzip()
    }

    /// Bits, as what is not a number is not equal to itself.
    fn bits(rows: &[Arc<BatchRow>]) -> Vec<(RowVerdict, u8, Vec<[u64; 3]>)> {
        let row = |row: &Arc<BatchRow>| {
            let values =
                (0..row.values.len()).map(|place| row.doubles(place).map(f64::to_bits)).collect();
            (row.verdict, row.mode_code(), values)
        };
        rows.iter().map(row).collect()
    }

    #[test]
    fn a_row_is_what_it_is_alone_whatever_the_threads() {
        let asked = [Quantity::Thrust, Quantity::Thickness];
        let (alphas, mus) = grid();
        let rows = |alphas: &[f64], mus: &[f64]| rows(&asked, (alphas, mus), None).unwrap();
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
        let asked = [Quantity::SlidingFriction, Quantity::RotationalFriction];
        let (alphas, mus) = grid();
        let rows = |alphas: &[f64], mus: &[f64]| rows(&asked, (alphas, mus), None).unwrap();
        let together = rows(&alphas, &mus);
        let alone = alphas.iter().zip(&mus).flat_map(|(&alpha, &mu)| rows(&[alpha], &[mu]));
        assert_eq!(bits(&together), bits(&alone.collect::<Vec<_>>()));
        let is_known = |row: &&Arc<BatchRow>| first(row)[0] > 0.0;
        assert!(together.iter().filter(is_known).count() > 20);
    }

    /// Number of some arches whose rows are proved together; these, and all others, are what they are one by one.
    fn together(
        weight: SelfWeight,
        (half_openings, frictions): (&[f64], &[f64]),
        frictions_too: bool,
    ) -> usize {
        use Quantity as Q;
        let mut quantities =
            vec![Q::Thickness, Q::Thrust, Q::SlidingJoint, Q::IntrinsicThrust, Q::RotationJoint];
        quantities.extend(
            frictions_too
                .then_some([Q::RotationalFriction, Q::SlidingFriction])
                .into_iter()
                .flatten(),
        );
        let arches = DoubleArches { weight, half_openings, frictions, thicknesses: None };
        let found = arches.rows(&quantities).unwrap();
        let columns = arches.columns(&quantities).unwrap();
        let batch = Batch { quantities, digits: DIGITS, has_texts: false };
        let rows: Vec<usize> = (0..half_openings.len()).collect();
        let mut expected = batch.by_openings(&rows, &arches, Threads::Pool);
        expected.sort_by_key(|(row, _)| *row);
        assert_eq!(found.len(), expected.len());
        for (row, (found, (_, expected))) in found.iter().zip(&expected).enumerate() {
            let [alpha, mu] = [half_openings[row], frictions[row]];
            let bits = |row| bits(std::slice::from_ref(row));
            assert_eq!(bits(found), bits(expected), "{weight:?} {alpha:e} {mu:e}");
            assert_eq!(found.reason, expected.reason, "{alpha:e} {mu:e}");
            let in_columns = |k: usize| columns.values[k].each_ref().map(|of| of[row].to_bits());
            let in_columns: Vec<_> = (0..batch.quantities.len()).map(in_columns).collect();
            let in_columns = (columns.verdicts[row], columns.modes[row], in_columns);
            assert_eq!(bits(found)[0], in_columns, "{alpha:e} {mu:e}");
        }
        in_lanes::rows(&batch.quantities, &arches, Threads::One).len()
    }

    /// Half openings and frictions all over the map, in no order; every fourth without friction's limit.
    fn spread(count: usize, from: usize) -> (Vec<f64>, Vec<f64>) {
        let part = |k: usize, step: f64| ((from + k + 1) as f64 * step).fract();
        let arch = |k| {
            let mu = 3.0 * part(k, 0.569_840_290_998_053_3);
            let mu = if k % 4 == 0 { f64::INFINITY } else { mu };
            (2.7 * part(k, 0.754_877_666_246_692_8), mu)
        };
        (0..count).map(arch).unzip()
    }

    /// Wide arches, which have every mode.
    fn wide(count: usize, from: usize) -> (Vec<f64>, Vec<f64>) {
        let (alphas, mus) = spread(count, from);
        let alphas = alphas.iter().map(|alpha| 2.38 + 0.42 / 2.7 * alpha);
        (alphas.collect(), mus.iter().map(|mu| 0.9 + mu).collect())
    }

    #[test]
    fn many_at_a_time_are_what_they_are_one_by_one() {
        for (weight, frictions) in SelfWeight::ALL.into_iter().zip([false, true]) {
            for (alphas, mus) in [spread(20_000, 0), wide(10_000, 0)] {
                let proved = together(weight, (&alphas, &mus), frictions);
                assert!(proved > alphas.len() * 9 / 10, "{proved} of {}", alphas.len());
            }
        }
    }

    /// `cargo test --release -p couplet-prove --lib ten_million -- --ignored --nocapture`
    #[test]
    #[ignore = "minutes with optimisation"]
    fn ten_million_at_a_time_are_what_they_are_one_by_one() {
        let piece = |k: usize| {
            let (count, from) = (100_000, 50_000 + 100_000 * k);
            let (alphas, mus) = if k % 4 < 2 { spread(count, from) } else { wide(count, from) };
            together(SelfWeight::ALL[k % 2], (&alphas, &mus), k % 8 < 4)
        };
        println!("proved together: {}", (0..100).map(piece).sum::<usize>());
    }

    /// Next to the friction at which a joint slides, to the ends of what is proved together, and to that of rotation.
    #[test]
    fn many_next_to_where_the_mode_changes_are_what_they_are_one_by_one() {
        for (weight, end) in [(SelfWeight::Heyman, 2.648), (SelfWeight::Milankovitch, 2.590)] {
            let mut arches = Vec::new();
            for k in 0..40 {
                let alpha = 0.2 + 2.3 * f64::from(k) / 40.0;
                let arch = Arch::new(weight, exact(alpha).unwrap(), Friction::Infinite).unwrap();
                let state = arch.least(DIGITS).unwrap();
                let mu = state.frictions.unwrap().rotational.unwrap().double;
                let steps = [0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-6];
                let around = steps.into_iter().flat_map(|by| [mu * (1.0 - by), mu * (1.0 + by)]);
                arches.extend(around.map(|mu| (alpha, mu)));
            }
            let near_one = [-1e-6, -1e-12, -1e-16, 0.0, 1e-16, 1e-12, 1e-6];
            for at in [0.125, 2.5625, end, 1e-3, 3.1, std::f64::consts::PI] {
                arches.extend(near_one.map(|by| (at * (1.0 + by), f64::INFINITY)));
                arches.extend(near_one.map(|by| (at * (1.0 + by), 3.0)));
            }
            let odd = [f64::NAN, -1.0, 0.0, -0.0, 4.0, f64::INFINITY, 1e-300, 5e-324];
            arches.extend(odd.into_iter().flat_map(|x| [(x, 1.0), (1.0, x), (x, x)]));
            let (alphas, mus): (Vec<f64>, Vec<f64>) = arches.into_iter().unzip();
            let proved = together(weight, (&alphas, &mus), true);
            assert!((200..700).contains(&proved), "{proved} of {}", alphas.len());
        }
    }

    #[test]
    fn a_value_is_that_of_the_arch() {
        let asked = [Quantity::RotationalFriction, Quantity::Thickness];
        let row = &rows(&asked, (&[1.5], &[0.5]), None).unwrap()[0];
        let values = [0, 1].map(|place| row.doubles(place));
        let arch = Arch::parse("milankovitch", "1.5", "0.5").unwrap();
        let state = arch.least(17).unwrap();
        let rotational = state.frictions.unwrap().rotational.unwrap();
        assert_eq!([values[0][0], values[1][0]], [rotational.double, state.thickness.double]);
        assert_eq!(row.mode, Some(state.mode));
        let [value, lower, upper] = values[1];
        assert!(lower <= value && value <= upper && lower < upper);
    }

    #[test]
    fn the_asymmetric_thickness_is_there_for_arches_that_have_one_and_stand() {
        let arches: (&[f64], &[f64]) = (&[2.3, 2.3, 2.3, 1.5], &[1.05, 1.2, 1.05, 0.6]);
        // The double next to 2.3 is another half opening.
        let numbers = (exact(2.3).unwrap(), Friction::Coefficient(exact(1.05).unwrap()));
        let arch = Arch::new(SelfWeight::Milankovitch, numbers.0, numbers.1).unwrap();
        let known = asymmetric_thicknesses(&arch, DIGITS).unwrap()[0].double;
        approx::assert_abs_diff_eq!(known, 0.583_084_449_604_488_6, epsilon = 1e-15);
        for etas in [None, Some(&[0.55, 0.55, 0.5, 0.2][..])] {
            let rows = rows(&[Quantity::AsymmetricThickness], arches, etas).unwrap();
            let [value, lower, upper] = first(&rows[0]);
            assert_eq!(value, known);
            assert!(lower <= value && value <= upper && lower < upper);
            assert!(first(&rows[1])[0].is_nan() && first(&rows[3])[0].is_nan());
            assert_eq!(first(&rows[2])[0].is_nan(), etas.is_some(), "one falls");
        }
    }

    #[test]
    fn a_row_that_makes_no_sense_is_refused_and_no_other() {
        let found = |arches: (&[f64], &[f64]), etas: &[f64]| {
            rows(&[Quantity::GeometricSafety], arches, Some(etas)).unwrap()
        };
        let nan = f64::NAN;
        let rows = [(nan, 1.0, 0.1), (1.0, nan, 0.1), (1.0, 1.0, nan), (4.0, 1.0, 0.1)];
        let rows =
            [&rows[..], &[(1.0, -1.0, 0.1), (1.0, 1.0, 0.0), (1.0, 1.0, 2.5), (-0.0, 1.0, 1.0)]];
        for &(alpha, mu, eta) in rows.concat().iter() {
            let found = found((&[1.0, alpha], &[1.0, mu]), &[0.1, eta]);
            let verdicts = found.iter().map(|row| row.verdict).collect::<Vec<_>>();
            assert_eq!(verdicts, [RowVerdict::Stands, RowVerdict::Refused], "{alpha} {mu} {eta}");
            assert!(first(&found[1]).iter().all(|x| x.is_nan()) && found[1].mode_code() == 255);
        }
        assert!(found((&[], &[]), &[]).is_empty());
    }

    #[test]
    fn arrays_of_other_lengths_and_quantities_of_other_arches_are_refused() {
        let safety = |arches: (&[f64], &[f64]), etas: Option<&[f64]>| {
            rows(&[Quantity::Thickness, Quantity::GeometricSafety], arches, etas)
        };
        let lengths = |all: &[usize]| Err(Refused::Lengths(all.to_vec()));
        assert_eq!(safety((&[1.0, 1.2, 1.4], &[0.6]), None), lengths(&[3, 1]));
        assert_eq!(safety((&[1.0], &[0.6]), Some(&[])), lengths(&[1, 1, 0]));
        for (thicknesses, quantity) in
            [(None, Quantity::GeometricSafety), (Some(&[0.1][..]), Quantity::Thickness)]
        {
            let refused = safety((&[1.0], &[0.6]), thicknesses).unwrap_err();
            let told =
                matches!(&refused, Refused::NoSuchQuantity { quantity: of, .. } if *of == quantity);
            assert!(told, "{refused}");
        }
    }
}
