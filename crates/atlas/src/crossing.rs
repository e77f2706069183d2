//! Crossings of a curve of the map with a half opening, a thickness or a friction: once, or nowhere, either proved.

use super::cell::TubeCell;
use super::form::CurveForm;
use super::law::Law;
use super::place::Place;
use super::trace::Trace;
use super::tube::Tube;
use super::variable::Variable;
use crate::certify::Undecided;
use crate::number::{Ball, Enclosure, Real, Stumpff, Ternary};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::halve::halve;
use crate::prover::ladder::Rooted;
use crate::prover::root::{self, root_near, rooted_near};
use rug::Float;

/// The one point of a curve in which a variable has a value.
#[derive(Clone, Debug)]
pub(super) struct Crossing {
    pub form: CurveForm,
    s: Ball,
    root: Vec<Ball>,
}

/// The equations of a form, and perhaps one more: the parameter is the first unknown.
struct Closed<'a> {
    form: &'a CurveForm,
    by: Closing<'a>,
}

/// Equation that closes a form with one unknown more than equations.
enum Closing<'a> {
    Value(Variable, &'a Ball),
    Law(Law),
    /// None, for a form that is closed: it has as many equations as unknowns.
    Nothing,
}

impl root::Form<Ball> for Closed<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let (s, unknowns) = (&x[0], &x[1..]);
        let mut residuals = self.form.residuals(&number, s, unknowns);
        residuals.extend(match self.by {
            Closing::Value(variable, value) => {
                let known = self.form.value(variable, s, unknowns);
                known.map(|known| known.clone() - number(value))
            }
            Closing::Law(law) => Some(self.form.residual(law, &number, s, unknowns)),
            Closing::Nothing => None,
        });
        residuals
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> bool {
        self.form.divisors(&number, &x[0], &x[1..]).iter().all(Enclosure::excludes_zero)
    }
}

/// The equations of a form at a parameter.
struct AtParameter<'a> {
    form: &'a CurveForm,
    s: &'a Ball,
}

impl root::Form<Ball> for AtParameter<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        self.form.residuals(&number, &number(self.s), x)
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> bool {
        self.form.divisors(&number, &number(self.s), x).iter().all(Enclosure::excludes_zero)
    }
}

/// The point of a tube at a parameter, in more digits than the tube tells.
pub(super) fn in_tube(
    form: &CurveForm,
    tube: &Tube,
    s: &Ball,
    bits: u32,
) -> Result<Place, Undecided> {
    let start: Vec<Float> = tube.enclosure(s).iter().map(|x| x.candidate()).collect();
    let Rooted { values, sines } = rooted_near(&AtParameter { form, s }, bits, &start)?;
    let few = |x: &Ball| x.with_precision(BITS);
    match tube.holds(&few(s), &values.iter().map(few).collect::<Vec<_>>()) {
        true => Ok(Place::by(form, s, &values, |x| sines.ball(x.clone()), |x| x.ball)),
        false => Err(Undecided::new("the point found is on another branch")),
    }
}

/// Bits in which crossings are enclosed.
pub(super) const BITS: u32 = 128;

/// Number of times that a piece is halved.
const DEPTH: u32 = 12;

/// Cells next to each other, on all of which the variable rises, or on all falls.
struct MonotoneRun<'a> {
    /// The place of the first one on the curve.
    first: usize,
    rises: bool,
    cells: Vec<TubeCell<'a>>,
}

impl MonotoneRun<'_> {
    /// Tells whether the value is on the run, of so many parts of the curve.
    fn has(&self, trace: &Trace, parts: usize, variable: Variable, value: &Ball) -> Ternary {
        let of_curve = |place: &Place| place.coordinate(variable).cloned();
        let inner =
            |cell: Option<&TubeCell>, which: usize| Some(cell?.ends(variable)?[which].clone());
        let [start, end] = &trace.ends;
        let from = match self.first {
            0 => of_curve(start),
            _ => inner(self.cells.first(), 0),
        };
        let to = match self.first + self.cells.len() == parts {
            true => of_curve(end),
            false => inner(self.cells.last(), 1),
        };
        let (Some(from), Some(to)) = (from, to) else { return Ternary::Undecided };
        let (low, high) = if self.rises { (from, to) } else { (to, from) };
        low.is_less_than(value).and(value.is_less_than(&high))
    }
}

impl Crossing {
    /// A root of a form with one equation more than its own, proved to be the only one in a box.
    pub(super) fn proved(
        form: &CurveForm,
        also: Option<Law>,
        start: Vec<Float>,
    ) -> Result<Self, Undecided> {
        let by = also.map_or(Closing::Nothing, Closing::Law);
        let mut root = root_near(&Closed { form, by }, BITS, start)?;
        let s = root.remove(0);
        Ok(Self { form: form.clone(), s, root })
    }

    /// A point that is known to be on a form.
    pub(super) fn known(form: &CurveForm, s: Ball, root: Vec<Ball>) -> Self {
        Self { form: form.clone(), s, root }
    }

    /// Crossing where a curve has the value; `None` where it is proved to have it nowhere.
    ///
    /// On each run of parts next to each other on which the value may be, the variable rises, or falls: so it is
    /// there once if it lies between the values at the ends of the run, else nowhere. On one run only it is there.
    pub(super) fn find(
        trace: &Trace,
        variable: Variable,
        value: &Ball,
    ) -> Result<Option<Self>, Undecided> {
        let failed = |what: &str| Undecided::new(format!("{}: {what}", trace.curve));
        let open = || failed("it is not proved to be there once at most");
        // In order: nothing where the value is not, else with whether the variable rises.
        let mut parts = Vec::new();
        for piece in trace.pieces() {
            let whole = TubeCell::new(&piece).ok_or_else(open)?;
            halve(whole, DEPTH, TubeCell::halves, |cell| {
                let rises = || cell.rises(variable).ok_or_else(open);
                let rises = cell.may_have(variable, value).then(rises).transpose()?;
                parts.push(rises.map(|rises| (cell.clone(), rises)));
                Ok(())
            })?;
        }
        let count = parts.len();
        let mut runs: Vec<MonotoneRun> = Vec::new();
        for (index, part) in parts.into_iter().enumerate() {
            let Some((cell, rises)) = part else { continue };
            match runs.last_mut() {
                Some(run) if run.first + run.cells.len() == index => {
                    if run.rises != rises {
                        return Err(failed("it may be there more than once"));
                    }
                    run.cells.push(cell);
                }
                _ => runs.push(MonotoneRun { first: index, rises, cells: vec![cell] }),
            }
        }
        let mut found = None;
        for run in runs {
            match run.has(trace, count, variable, value) {
                Ternary::True if found.is_some() => return Err(failed("it is there twice")),
                Ternary::True => {
                    let crossing = Self::on(&run.cells, variable, value);
                    let crossing = crossing.ok_or_else(|| failed("the point is not proved"))?;
                    found = Some(crossing);
                }
                Ternary::False => {}
                Ternary::Undecided => return Err(failed("this may be the value at an end of it")),
            }
        }
        Ok(found)
    }

    /// The root in cells that follow each other, if it is proved to be on the curve.
    fn on(cells: &[TubeCell], variable: Variable, value: &Ball) -> Option<Self> {
        let aim = value.mid().to_f64();
        let ends = |cell: &TubeCell| Some(cell.ends(variable)?.map(|end| end.mid().to_f64()));
        let off = |cell: &&TubeCell| {
            let [from, to] = ends(cell).unwrap_or([f64::NAN; 2]);
            (from.min(to) - aim).max(aim - from.max(to))
        };
        let cell = cells.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let ([from, to], [low, high]) = (ends(cell)?, cell.range());
        let share = ((aim - from) / (to - from)).clamp(0.0, 1.0);
        let about = Ball::exact(Float::with_val(53, low + share * (high - low)), BITS);
        let number = |x: &Ball| Float::with_val(BITS, x.mid());
        let start =
            [about.clone()].iter().chain(&cell.tube.enclosure(&about)).map(number).collect();
        let form = cell.form;
        let by = Closing::Value(variable, value);
        let mut root = root_near(&Closed { form, by }, BITS, start).ok()?;
        let s = root.remove(0);
        // In each cell that the parameter may be in the root is that of the curve; there is one, and no gap.
        let may_be_in = |cell: &&TubeCell| {
            let [low, high] = cell.range();
            s.lower() <= high && s.upper() >= low && std::ptr::eq(cell.form, form)
        };
        let around: Vec<&TubeCell> = cells.iter().filter(may_be_in).collect();
        let is_covered = s.lower() >= around.first()?.range()[0]
            && s.upper() <= around.last()?.range()[1]
            && around.iter().all(|cell| cell.tube.holds(&s, &root));
        is_covered.then(|| Self { form: form.clone(), s, root })
    }

    /// The left side of another equation.
    pub(super) fn residual(&self, law: Law) -> Ball {
        self.form.residual(law, &Ball::clone, &self.s, &self.root)
    }

    pub(super) fn place(&self) -> Place {
        Place::new(&self.form, &self.s, &self.root)
    }

    pub(super) fn value(&self, variable: Variable) -> Ball {
        self.form.spot(&Ball::clone, &self.s, &self.root).get(variable).clone()
    }
}

#[cfg(test)]
mod tests {
    use super::super::curve::Curve;
    use super::*;
    use crate::arch::SelfWeight;

    fn find(curve: &str, variable: Variable, value: &str) -> Result<Option<Crossing>, Undecided> {
        let curve = Curve::named(curve).unwrap();
        let trace = Trace::new(curve, SelfWeight::Heyman, 1e-4).unwrap();
        let value: crate::number::ExactNumber = value.parse().unwrap();
        Crossing::find(&trace, variable, &value.enclosure(BITS))
    }

    #[test]
    fn a_value_is_there_once_or_nowhere() {
        for (curve, variable, value, is_there) in [
            ("rrr/srr", Variable::HalfOpening, "80deg", true),
            ("rrr/srr", Variable::HalfOpening, "2.6", false),
            ("rrr/srr", Variable::Thickness, "1/10", true),
            ("rrs/ss", Variable::FrictionAngle, "1", true),
            ("rrs/ss", Variable::Thickness, "0.9", true),
            ("rrs/ss", Variable::FrictionAngle, "0.5", false),
            ("limit", Variable::FrictionAngle, "80deg", true),
            ("rotation", Variable::HalfOpening, "1/2", true),
        ] {
            let found = find(curve, variable, value).unwrap();
            assert_eq!(found.is_some(), is_there, "{curve} {variable:?} {value}");
            let exact: crate::number::ExactNumber = value.parse().unwrap();
            assert!(found.is_none_or(|at| at.value(variable).overlaps(&exact.enclosure(BITS))));
        }
    }

    /// The rotational joint is widest at `sb`, so that some values are there twice.
    #[test]
    fn what_may_be_there_twice_is_undecided() {
        assert!(find("rotation", Variable::JointSquare, "1.15").is_err());
        // And what is at an end may be there or not: mu = 0, or no thickness.
        assert!(find("rrr/srr", Variable::Thickness, "0").is_err());
    }
}
