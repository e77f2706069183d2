//! Many arches, in arrays of doubles: a half opening, a friction and perhaps a thickness each.
//!
//! A double is the number that it is, exactly.

use super::arches::{BatchArches, Threads, grouped};
use super::batch::Batch;
use super::columns::BatchColumns;
use super::opening::tangent;
use crate::arch::SelfWeight;
use crate::certify::state::{InLanes, LaneColumns};
use crate::lanes::Lanes;
use crate::number::{DoubleDouble, DoubleDoubleBall, ExactNumber, Field, Real};
use crate::problem::{Arch, Friction, Quantity};
use crate::prover::Refused;
use std::borrow::Cow;
use std::ops::Range;

/// With so many digits a decimal number tells the double.
const DIGITS: usize = 17;

/// Arches in arrays of doubles.
///
/// ```
/// use couplet_prove::certify::batch::{DoubleArches, DoubleUnits, RowVerdict};
/// use couplet_prove::prelude::*;
/// let (half_openings, frictions) = (&[2.45, 2.45, 4.0], &[1.35, 0.1, 1.0]);
/// let weight = SelfWeight::Milankovitch;
/// let units = DoubleUnits::default();
/// let arches = DoubleArches { weight, half_openings, frictions, thicknesses: None, units };
/// let found = arches.columns(&[Quantity::Thickness])?;
/// assert_eq!((found.mode(0), found.double(0, 0)), (Mode::named("rrs"), Some(0.65024378080138357)));
/// assert_eq!(found.verdicts, [RowVerdict::Stands, RowVerdict::Falls, RowVerdict::Refused]);
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
    /// Units of the half openings and the frictions, where they are others.
    pub units: DoubleUnits,
}

/// Units of angles and frictions in arrays: radians and coefficients, unless others are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DoubleUnits {
    /// True if half openings are in degrees.
    pub has_degrees: bool,
    /// Unit of friction angles, `true` for degrees, where frictions are such.
    pub friction_angles: Option<bool>,
}

/// A double as it goes into lanes; of an angle in degrees its radians.
#[inline(always)]
fn number(x: f64, is_in_degrees: bool) -> DoubleDoubleBall {
    let x = DoubleDoubleBall::exact(DoubleDouble::exact(x));
    if is_in_degrees { x.pi() * x / x.int(180) } else { x }
}

/// An angle as the number that it is.
fn angle(x: f64, is_in_degrees: bool) -> Result<ExactNumber, String> {
    let x = exact(x)?;
    Ok(if is_in_degrees { x.degrees() } else { x })
}

/// A double as the number that it is.
fn exact(x: f64) -> Result<ExactNumber, String> {
    ExactNumber::try_from(x).map_err(|_| format!("{x} is no number"))
}

impl DoubleArches<'_> {
    /// Columns of rows with the quantities: those of [`Quantity::STATE_ROW`], or of [`Quantity::ASSESSMENT_ROW`] where
    /// there are thicknesses. A row with a number out of its range is
    /// [`RowVerdict::Refused`](super::RowVerdict::Refused), and no other is. All are refused where the lengths of the
    /// arrays differ, or a quantity is asked for that such arches do not have.
    ///
    /// ```
    /// use couplet_prove::certify::Refused;
    /// use couplet_prove::certify::batch::{DoubleArches, DoubleUnits};
    /// use couplet_prove::prelude::*;
    /// let (weight, half_openings) = (SelfWeight::Heyman, &[1.0, 1.2][..]);
    /// let units = DoubleUnits::default();
    /// let arches = DoubleArches { weight, half_openings, frictions: &[0.5], thicknesses: None, units };
    /// let safety = [Quantity::GeometricSafety];
    /// assert_eq!(arches.columns(&safety), Err(Refused::Lengths(vec![2, 1])));
    /// // A safety is that of a thickness.
    /// let arches = DoubleArches { half_openings: &[1.0], ..arches };
    /// assert!(matches!(arches.columns(&safety), Err(Refused::NoSuchQuantity { .. })));
    /// assert!(DoubleArches { thicknesses: Some(&[0.1]), ..arches }.columns(&safety).is_ok());
    /// ```
    ///
    /// Inside a pool of rayon its threads share the work; elsewhere all is done in the thread that calls.
    pub fn columns(&self, quantities: &[Quantity]) -> Result<BatchColumns, Refused> {
        Ok(self.batch(quantities)?.columns(self, Threads::Pool))
    }

    /// A row as it goes into lanes, with its friction there.
    #[inline(always)]
    fn with_friction(
        &self,
        row: usize,
        friction: Option<DoubleDoubleBall>,
    ) -> (SelfWeight, InLanes) {
        let alpha = number(self.half_openings[row], self.units.has_degrees);
        let thickness = self.thicknesses.map(|etas| number(etas[row], false));
        (self.weight, ((alpha, friction), thickness))
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
}

impl BatchArches for DoubleArches<'_> {
    fn count(&self) -> usize {
        self.half_openings.len()
    }

    fn openings(&self, rows: &[usize]) -> Vec<Vec<usize>> {
        grouped(rows, |row| Some(self.half_openings[row].to_bits()))
    }

    #[inline(always)]
    fn in_lanes(&self, row: usize) -> Option<(SelfWeight, InLanes)> {
        let friction = match (self.frictions[row], self.units.friction_angles) {
            (phi, Some(is_in_degrees)) => Some(tangent(&number(phi, is_in_degrees))?),
            (mu, None) => (mu != f64::INFINITY).then(|| number(mu, false)),
        };
        Some(self.with_friction(row, friction))
    }

    fn many_in_lanes(&self, rows: Range<usize>) -> [LaneColumns; 2] {
        let Some(is_in_degrees) = self.units.friction_angles else {
            return LaneColumns::by_weight(rows.map(|row| self.in_lanes(row)));
        };
        let angles = self.frictions[rows.clone()].iter().map(|phi| [number(*phi, is_in_degrees)]);
        let frictions = Lanes::of(self.weight).tangents(&angles.collect::<Vec<_>>());
        let row = |(row, friction): (usize, Option<[DoubleDoubleBall; 1]>)| {
            Some(self.with_friction(row, Some(friction?[0])))
        };
        LaneColumns::by_weight(rows.zip(frictions).map(row))
    }

    fn have_thicknesses(&self) -> bool {
        self.thicknesses.is_some()
    }

    fn thickness(&self, row: usize) -> Result<ExactNumber, String> {
        exact(self.thicknesses.map_or(f64::NAN, |etas| etas[row]))
    }

    fn arch(&self, row: usize) -> Result<Cow<'_, Arch>, String> {
        let half_opening = angle(self.half_openings[row], self.units.has_degrees)?;
        let friction = match (self.frictions[row], self.units.friction_angles) {
            (phi, Some(is_in_degrees)) => Friction::Angle(angle(phi, is_in_degrees)?),
            (f64::INFINITY, None) => Friction::Infinite,
            (mu, None) => Friction::Coefficient(exact(mu)?),
        };
        let arch = Arch::new(self.weight, half_opening, friction);
        arch.map(Cow::Owned).map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{RowVerdict, in_lanes};
    use super::*;
    use crate::certify::asymmetric_thicknesses;
    use crate::certify::state::Certify;

    fn columns(
        quantities: &[Quantity],
        (half_openings, frictions): (&[f64], &[f64]),
        thicknesses: Option<&[f64]>,
    ) -> Result<BatchColumns, Refused> {
        let weight = SelfWeight::Milankovitch;
        let units = DoubleUnits::default();
        DoubleArches { weight, half_openings, frictions, thicknesses, units }.columns(quantities)
    }

    fn first(columns: &BatchColumns, row: usize) -> [f64; 3] {
        columns.values[0].each_ref().map(|column| column[row])
    }

    /// Rows of half openings that occur once, and so often that they share their proofs.
    fn grid() -> (Vec<f64>, Vec<f64>) {
        let alphas = [0.7, 1.4, 2.45, 2.61, 3.0];
        let mus = [0.05, 0.3, 0.6, 1.35, 2.5, f64::INFINITY];
        let rows = alphas.iter().flat_map(|&alpha| mus.iter().map(move |&mu| (alpha, mu)));
        rows.chain([(1.1, 0.4), (1.2, 0.4)]).unzip()
    }

    /// Bits, as what is not a number is not equal to itself.
    fn bits(columns: &BatchColumns) -> Vec<(RowVerdict, u8, Vec<[u64; 3]>)> {
        let row = |row: usize| {
            let values = columns.values.iter();
            let bits = values.map(|of| of.each_ref().map(|column| column[row].to_bits()));
            (columns.verdicts[row], columns.modes[row], bits.collect())
        };
        (0..columns.verdicts.len()).map(row).collect()
    }

    #[test]
    fn a_row_is_what_it_is_alone_whatever_the_threads() {
        let asked = [Quantity::Thrust, Quantity::Thickness];
        let (alphas, mus) = grid();
        let rows =
            |alphas: &[f64], mus: &[f64]| bits(&columns(&asked, (alphas, mus), None).unwrap());
        let together = rows(&alphas, &mus);
        let alone = alphas.iter().zip(&mus).flat_map(|(&alpha, &mu)| rows(&[alpha], &[mu]));
        assert_eq!(together, alone.collect::<Vec<_>>());
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        assert_eq!(together, pool.install(|| rows(&alphas, &mus)));
        let falls = together.iter().filter(|(verdict, ..)| *verdict == RowVerdict::Falls).count();
        assert!((5..25).contains(&falls), "{falls}");
    }

    #[test]
    fn a_row_with_frictions_is_what_it_is_alone() {
        let asked = [Quantity::SlidingFriction, Quantity::RotationalFriction];
        let (alphas, mus) = grid();
        let columns = |alphas: &[f64], mus: &[f64]| columns(&asked, (alphas, mus), None).unwrap();
        let together = columns(&alphas, &mus);
        let alone = alphas.iter().zip(&mus);
        let alone = alone.flat_map(|(&alpha, &mu)| bits(&columns(&[alpha], &[mu])));
        assert_eq!(bits(&together), alone.collect::<Vec<_>>());
        assert!(together.values[0][0].iter().filter(|x| **x > 0.0).count() > 20);
    }

    /// Number of some arches whose rows are proved together; these, and all others, are what they are one by one.
    fn together(arches: &DoubleArches, quantities: &[Quantity]) -> usize {
        let found = arches.columns(quantities).unwrap();
        let batch = arches.batch(quantities).unwrap();
        let rows: Vec<usize> = (0..arches.count()).collect();
        let mut expected = BatchColumns::open(rows.len(), quantities.len());
        for (row, of) in batch.one_by_one(&rows, arches, Threads::Pool) {
            expected.put(row, &of);
        }
        for (row, (one, other)) in bits(&found).into_iter().zip(bits(&expected)).enumerate() {
            let eta = arches.thicknesses.map(|etas| etas[row]);
            assert_eq!(one, other, "{:?} {eta:?}", arches.in_lanes(row));
        }
        assert_eq!((found.verdicts.len(), found.reasons), (rows.len(), expected.reasons));
        let proved = in_lanes::columns(quantities, arches, Threads::One);
        proved.verdicts.iter().filter(|verdict| **verdict != RowVerdict::Undecided).count()
    }

    /// Quantities of states, all or without the frictions at which the mode changes.
    fn of_states(frictions: bool) -> Vec<Quantity> {
        let all = Quantity::STATE.into_iter();
        all.filter(|of| frictions || !of.is_friction()).collect()
    }

    /// Thicknesses of arches: around the least by a random factor, or so near to it that few bits tell them apart; and
    /// what is no thickness or nearly none.
    fn thicknesses(arches: &DoubleArches, from: usize) -> Vec<f64> {
        let least = arches.columns(&[Quantity::Thickness]).unwrap();
        let [least, ..] = &least.values[0];
        let eta = |(row, least): (usize, &f64)| {
            let part = ((from + row + 1) as f64 * 0.381_966_011_250_105).fract();
            let least = if least.is_nan() { 2.0 * part } else { *least };
            let steps = (row / 8 % 16) as f64 - 8.0;
            match row % 8 {
                0 => least + steps * (least.next_up() - least),
                1 => least * (1.0 + steps * 10f64.powf(-16.0 * part)),
                2 if row % 256 == 2 => [2.0, 0.0, -0.0, -1.0, f64::NAN, 5e-324, 2.1][row / 256 % 7],
                2 => 2.0 * part,
                3 => 2.0 - part * (2.0 - least),
                _ => least * (0.5 + 2.0 * part),
            }
        };
        least.iter().enumerate().map(eta).collect()
    }

    /// Number of arches that are proved together, at their least thickness or, where that is asked, with one.
    fn proved(
        weight: SelfWeight,
        (half_openings, frictions): &(Vec<f64>, Vec<f64>),
        (asked, from, units): (&[Quantity], usize, DoubleUnits),
    ) -> usize {
        let arches = DoubleArches { weight, half_openings, frictions, thicknesses: None, units };
        if Quantity::STATE.contains(&asked[0]) {
            return together(&arches, asked);
        }
        let etas = thicknesses(&arches, from);
        together(&DoubleArches { thicknesses: Some(&etas), ..arches }, asked)
    }

    /// Quantities of an arch with a thickness that its least thickness tells.
    const OF_STANDING: [Quantity; 2] = [Quantity::LeastThickness, Quantity::GeometricSafety];

    /// Radians and coefficients, degrees, and degrees and friction angles in radians.
    const UNITS: [DoubleUnits; 3] = [
        DoubleUnits { has_degrees: false, friction_angles: None },
        DoubleUnits { has_degrees: true, friction_angles: Some(true) },
        DoubleUnits { has_degrees: true, friction_angles: Some(false) },
    ];

    /// Arches in other units, as doubles have them.
    fn in_units((alphas, mus): (Vec<f64>, Vec<f64>), units: DoubleUnits) -> (Vec<f64>, Vec<f64>) {
        let angle = |x: f64, is_in_degrees| if is_in_degrees { x.to_degrees() } else { x };
        let friction = |mu: f64| units.friction_angles.map_or(mu, |unit| angle(mu.atan(), unit));
        let alphas = alphas.into_iter().map(|alpha| angle(alpha, units.has_degrees));
        (alphas.collect(), mus.into_iter().map(friction).collect())
    }

    #[test]
    fn many_in_other_units_are_what_they_are_one_by_one() {
        for (weight, units) in SelfWeight::ALL.into_iter().zip([UNITS[1], UNITS[2]]) {
            let (mut alphas, mut mus) = in_units(spread(4_000, 7), units);
            // Those of unlimited friction have a right angle now, or next to one.
            let proved_all =
                proved(weight, &(alphas.clone(), mus.clone()), (&of_states(true), 0, units));
            assert!(proved_all > 4_000 * 2 / 3, "{proved_all}");
            let odd = [f64::NAN, f64::INFINITY, -1.0, 0.0, 180.0, 200.0, 90.0, 1e300, 5e-324, 4.0];
            for x in odd {
                alphas.extend([x, 1.0, 80.0, x]);
                mus.extend([0.4, x, x, x]);
            }
            let (alphas, mus) = (alphas.split_off(3_000), mus.split_off(3_000));
            assert!(proved(weight, &(alphas, mus), (&Quantity::ASSESSMENT, 0, units)) > 400);
        }
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

    /// Narrow arches, whose frictions are like the cube of the half opening.
    fn narrow(count: usize, from: usize) -> (Vec<f64>, Vec<f64>) {
        let (alphas, mus) = spread(count, from);
        let alphas = alphas.iter().map(|alpha| 0.05 * alpha);
        alphas.zip(mus).map(|(alpha, mu)| (alpha, mu * alpha.powi(3))).unzip()
    }

    #[test]
    fn many_at_a_time_are_what_they_are_one_by_one() {
        for (weight, frictions) in SelfWeight::ALL.into_iter().zip([false, true]) {
            let all = [(spread(20_000, 0), 9), (wide(10_000, 0), 9), (narrow(5_000, 0), 8)];
            for (arches, part) in all {
                let count = arches.0.len();
                let proved = proved(weight, &arches, (&of_states(frictions), 0, UNITS[0]));
                assert!(proved > count * part / 10, "{proved} of {count}");
            }
        }
    }

    #[test]
    fn many_with_a_thickness_are_what_they_are_one_by_one() {
        for (place, weight) in SelfWeight::ALL.into_iter().enumerate() {
            for (arches, part) in [(spread(5_000, place), 7), (wide(3_000, place), 5)] {
                let count = arches.0.len();
                let found = proved(weight, &arches, (&Quantity::ASSESSMENT, place, UNITS[0]));
                assert!(found > count * part / 10, "{found} of {count}");
                let found = proved(weight, &arches, (&OF_STANDING, place, UNITS[0]));
                assert!(found > count * 3 / 4, "{found} of {count}");
            }
        }
    }

    /// Next to the least thickness, too, the verdict and the safety are what they are beside the thrusts.
    #[test]
    fn no_value_depends_on_what_else_is_asked() {
        let units = UNITS[0];
        for (weight, (half_openings, frictions)) in
            [(SelfWeight::Heyman, spread(2_000, 3)), (SelfWeight::Milankovitch, wide(1_000, 3))]
        {
            let (half_openings, frictions) = (&half_openings[..], &frictions[..]);
            let least = DoubleArches { weight, half_openings, frictions, thicknesses: None, units };
            let etas = thicknesses(&least, 3);
            let arches = DoubleArches { thicknesses: Some(&etas), ..least };
            let rows: Vec<usize> = (0..arches.count()).collect();
            let alone = |quantities: &[Quantity]| {
                let mut found = BatchColumns::open(rows.len(), OF_STANDING.len());
                let batch = arches.batch(quantities).unwrap();
                for (row, of) in batch.one_by_one(&rows, &arches, Threads::One) {
                    found.put(row, &of);
                }
                found
            };
            let [few, all] = [alone(&OF_STANDING), alone(&Quantity::ASSESSMENT)];
            assert_eq!(bits(&few), bits(&all));
            let told = few.verdicts.iter().filter(|of| **of == RowVerdict::Stands).count();
            assert!(told > rows.len() / 4, "{told}");
        }
    }

    /// `cargo test --release -p couplet-prove --lib ten_million -- --ignored --nocapture`
    #[test]
    #[ignore = "a quarter of an hour with optimisation"]
    fn ten_million_at_a_time_are_what_they_are_one_by_one() {
        let piece = |k: usize| {
            let (count, from) = (100_000, 50_000 + 100_000 * k);
            let arches = if k % 4 < 2 { spread(count, from) } else { wide(count, from) };
            let (states, units) = (of_states(k % 8 < 4), UNITS[k / 16 % 3]);
            let asked = [&Quantity::ASSESSMENT[..], &OF_STANDING, &states][k / 4 % 3];
            let weight = SelfWeight::ALL[k % 2];
            let proved = proved(weight, &in_units(arches, units), (asked, from, units));
            println!("{k}: proved together {proved} of {count}");
        };
        let pool = rayon::ThreadPoolBuilder::new().build().unwrap();
        pool.install(|| (0..100).for_each(piece));
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
            for at in [0.125, 0.00390625, 2.5625, end, 1e-3, 3.1, std::f64::consts::PI] {
                arches.extend(near_one.map(|by| (at * (1.0 + by), f64::INFINITY)));
                arches.extend(near_one.map(|by| (at * (1.0 + by), 3.0)));
            }
            let odd = [f64::NAN, -1.0, 0.0, -0.0, 4.0, f64::INFINITY, 1e-300, 5e-324];
            arches.extend(odd.into_iter().flat_map(|x| [(x, 1.0), (1.0, x), (x, x)]));
            let (alphas, mus): (Vec<f64>, Vec<f64>) = arches.into_iter().unzip();
            let count = alphas.len();
            let arches = (alphas, mus);
            let states = proved(weight, &arches, (&of_states(true), 0, UNITS[0]));
            assert!((200..700).contains(&states), "{states} of {count}");
            let thick = proved(weight, &arches, (&Quantity::ASSESSMENT, 0, UNITS[0]));
            assert!((200..700).contains(&thick), "{thick} of {count}");
        }
    }

    #[test]
    fn a_value_is_that_of_the_arch() {
        let asked = [Quantity::RotationalFriction, Quantity::Thickness];
        let found = columns(&asked, (&[1.5], &[0.5]), None).unwrap();
        let values = [0, 1].map(|place| found.values[place].each_ref().map(|column| column[0]));
        let arch = Arch::parse("milankovitch", "1.5", "0.5").unwrap();
        let state = arch.least(17).unwrap();
        let rotational = state.frictions.unwrap().rotational.unwrap();
        assert_eq!([values[0][0], values[1][0]], [rotational.double, state.thickness.double]);
        assert_eq!(found.mode(0), Some(state.mode));
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
            let found = columns(&[Quantity::AsymmetricThickness], arches, etas).unwrap();
            let [value, lower, upper] = first(&found, 0);
            assert_eq!(value, known);
            assert!(lower <= value && value <= upper && lower < upper);
            assert_eq!([1, 3].map(|row| found.double(0, row)), [None; 2]);
            assert_eq!(found.double(0, 2).is_none(), etas.is_some(), "one falls");
        }
    }

    #[test]
    fn a_row_that_makes_no_sense_is_refused_and_no_other() {
        let found = |arches: (&[f64], &[f64]), etas: &[f64]| {
            columns(&[Quantity::GeometricSafety], arches, Some(etas)).unwrap()
        };
        let nan = f64::NAN;
        let rows = [(nan, 1.0, 0.1), (1.0, nan, 0.1), (1.0, 1.0, nan), (4.0, 1.0, 0.1)];
        let rows =
            [&rows[..], &[(1.0, -1.0, 0.1), (1.0, 1.0, 0.0), (1.0, 1.0, 2.5), (-0.0, 1.0, 1.0)]];
        for &(alpha, mu, eta) in rows.concat().iter() {
            let found = found((&[1.0, alpha], &[1.0, mu]), &[0.1, eta]);
            let expected = [RowVerdict::Stands, RowVerdict::Refused];
            assert_eq!(found.verdicts, expected, "{alpha} {mu} {eta}");
            assert!(first(&found, 1).iter().all(|x| x.is_nan()) && found.modes[1] == 255);
        }
        assert!(found((&[], &[]), &[]).verdicts.is_empty());
    }

    #[test]
    fn arrays_of_other_lengths_and_quantities_of_other_arches_are_refused() {
        let safety = |arches: (&[f64], &[f64]), etas: Option<&[f64]>| {
            columns(&[Quantity::Thickness, Quantity::GeometricSafety], arches, etas)
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
