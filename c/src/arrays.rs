//! Many arches, in arrays of doubles.

use crate::answer::Answer;
use crate::asked::named;
use crate::border::{Array, answered, apart, optional, text};
use crate::failure::{Failure, wrong};
use crate::texts::exact;
use crate::threads::{checked, on_threads};
use couplet::ask::array_note;
use couplet::certify::batch::{BatchColumns, DoubleArches, DoubleUnits, RowVerdict};
use couplet::certify::state::Certify;
use couplet::problem::Quantity;
use couplet::report;
use couplet::sweep::parse;
use std::ffi::{c_char, c_int};
use std::mem::MaybeUninit;
use std::ops::Range;

/// As many rows are answered before they are written: half openings that occur often are counted among these.
const ROWS: usize = 1 << 16;

/// The states of `n` arches, or with thicknesses whether they stand, proved; each double is exactly the number that it
/// is.
///
/// weight: as for `couplet_state`, of all. half_opening, friction: `n` doubles each; infinity is a friction. thickness:
/// `n` doubles, or NULL. quantities: names with commas ("thickness,thrust"), those of `couplet_state`, or with
/// thicknesses those of `couplet_assess`; NULL for none. asymmetric_thickness costs rows only where such mechanisms are
/// known. threads: 1 for the calling thread alone, up to 1024, or 0 for one on each core; they end with the call.
///
/// verdict: `n` bytes, `COUPLET_STANDS`, `COUPLET_FALLS`, `COUPLET_UNDECIDED` or `COUPLET_REFUSED`. mode: `n` bytes,
/// which `couplet_mode_name` names, or NULL. values: for each quantity `n` nearest doubles, then `n` lower bounds, then
/// `n` upper bounds: the place of row i is `values[(3*q + b)*n + i]`, in a language with columns `values(i, b, q)`. Not
/// a number where there is no value. NULL without quantities.
///
/// A row that makes no sense, or is undecided, is a row: its verdict says so, the code is `COUPLET_OPEN`, and the
/// reason counts such rows and has that of the first. Rows of one half opening share its proofs, and no bit depends on
/// it, nor on the threads. Nothing may overlap what is written; if the code is 2 or more, nothing that is written may
/// be used.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments, reason = "C has no other way")]
pub unsafe extern "C" fn couplet_states(
    weight: *const c_char,
    n: usize,
    half_opening: *const f64,
    friction: *const f64,
    thickness: *const f64,
    quantities: *const c_char,
    threads: usize,
    verdict: *mut u8,
    mode: *mut u8,
    values: *mut f64,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: the caller promises texts, arrays of `n` that nobody else writes, and a place for the answer.
    unsafe {
        answered(answer, || {
            let weight = parse::weight(text(weight, "weight")?).map_err(wrong)?;
            let possible = match thickness.is_null() {
                true => &Quantity::STATE_ROW[..],
                false => &Quantity::ASSESSMENT_ROW[..],
            };
            let names = optional(quantities, "quantities")?.unwrap_or_default();
            let quantities = named(names, possible)?;
            let threads = checked(threads)?;
            let count = 3 * quantities.len();
            let half_opening = Array::new(half_opening, Some(n), "half_opening")?;
            let friction = Array::new(friction, Some(n), "friction")?;
            let given = if thickness.is_null() { 0 } else { n };
            let etas = Array::new(thickness, Some(given), "thickness")?;
            let verdict = Array::new(verdict, Some(n), "verdict")?;
            let wanted = if mode.is_null() { 0 } else { n };
            let mode = Array::new(mode, Some(wanted), "mode")?;
            let values = Array::new(values, n.checked_mul(count), "values")?;
            apart(
                &[half_opening.place(), friction.place(), etas.place()],
                &[verdict.place(), mode.place(), values.place()],
            )?;
            let arches = DoubleArches {
                weight,
                half_openings: half_opening.values(),
                frictions: friction.values(),
                thicknesses: (!thickness.is_null()).then(|| etas.values()),
                units: DoubleUnits::default(),
            };
            let mut written =
                Written { verdict: verdict.places(), mode: mode.places(), values: values.places() };
            let mut work = || written.answer(&arches, &quantities);
            let open = match threads {
                1 => work(),
                threads => on_threads(threads, work)?,
            }?;
            Ok(Answer::rows(open.said(&arches)).with_note(array_note(arches.frictions)))
        })
    }
}

/// Where answers are written.
struct Written<'a> {
    verdict: &'a mut [MaybeUninit<u8>],
    /// Empty if nobody asks.
    mode: &'a mut [MaybeUninit<u8>],
    values: &'a mut [MaybeUninit<f64>],
}

/// The rows that are not decided.
#[derive(Default)]
struct Open {
    undecided: usize,
    refused: usize,
    first: Option<usize>,
}

impl Written<'_> {
    fn answer(&mut self, arches: &DoubleArches, of: &[Quantity]) -> Result<Open, Failure> {
        let mut open = Open::default();
        let count = self.verdict.len();
        for start in (0..count).step_by(ROWS) {
            let rows = start..count.min(start + ROWS);
            let piece = DoubleArches {
                half_openings: &arches.half_openings[rows.clone()],
                frictions: &arches.frictions[rows.clone()],
                thicknesses: arches.thicknesses.map(|etas| &etas[rows.clone()]),
                ..*arches
            };
            self.write(rows, &piece.columns(of).map_err(wrong)?, &mut open);
        }
        Ok(open)
    }

    fn write(&mut self, rows: Range<usize>, found: &BatchColumns, open: &mut Open) {
        let count = self.verdict.len();
        for (at, verdict) in rows.clone().zip(&found.verdicts) {
            self.verdict[at].write(*verdict as u8);
            open.count(at, *verdict);
        }
        for (place, code) in self.mode.iter_mut().skip(rows.start).zip(&found.modes) {
            place.write(*code);
        }
        for (column, values) in found.values.iter().flatten().enumerate() {
            let places = &mut self.values[column * count + rows.start..];
            places.iter_mut().zip(values).for_each(|(place, x)| {
                place.write(*x);
            });
        }
    }
}

impl Open {
    fn count(&mut self, at: usize, verdict: RowVerdict) {
        match verdict {
            RowVerdict::Stands | RowVerdict::Falls => return,
            RowVerdict::Undecided => self.undecided += 1,
            RowVerdict::Refused => self.refused += 1,
        }
        self.first = self.first.or(Some(at));
    }

    /// How many there are, and why the first is; none if all are decided.
    fn said(&self, arches: &DoubleArches) -> Option<String> {
        let first = self.first?;
        let counts = [(self.undecided, "undecided"), (self.refused, "refused")];
        let counts = counts.iter().filter(|(count, _)| *count > 0);
        let counts: Vec<_> = counts.map(|(count, what)| format!("{count} {what}")).collect();
        let (all, counts) = (arches.half_openings.len(), counts.join(" and "));
        let why = why(arches, first);
        Some(format!("of {all} rows {counts}; the first is row {first}, counted from 0: {why}"))
    }
}

/// Why a row is not decided.
fn why(arches: &DoubleArches, row: usize) -> String {
    // What has no exact text is no number.
    let text = |x: f64| Some(exact(x)).filter(|text| !text.is_empty()).unwrap_or(x.to_string());
    let [alpha, mu] = [arches.half_openings[row], arches.frictions[row]].map(text);
    let arch = parse::arch([arches.weight.name(), &alpha, &mu]).map_err(wrong);
    let found = arch.and_then(|arch| {
        let Some(etas) = arches.thicknesses else {
            return Ok(report::Answer::state(1, &arch, &arch.certify_alone(17)));
        };
        let eta = parse::thickness(&text(etas[row])).map_err(wrong)?;
        let found = arch.certify_thickness(&eta, 17);
        Ok(report::Answer::assessment(report::Extent::ALL, 1, (&arch, &eta), &found))
    });
    match found {
        Ok(found) => found.reason().unwrap_or_default().into_owned(),
        Err(Failure::Usage(why) | Failure::Resource(why) | Failure::Fault(why)) => why,
    }
}
