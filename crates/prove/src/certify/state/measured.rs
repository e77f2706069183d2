//! Sizes of a measured arch in metres and kilonewtons.

use super::assess::Assessment;
use super::query::raised;
use super::quick::{assessment_enclosed, state_enclosed};
use super::state::Outcome;
use crate::number::{Ball, ExactNumber, degrees};
use crate::problem::measures::Measures;
use crate::problem::{Arch, Quantity};
use crate::prover::figure::{Figure, Figured, optional};
use crate::prover::{Error, Refused};
use std::cell::LazyCell;

/// Values with their names; `None` for a thrust without bound.
pub type Measured = Vec<(Quantity, Option<Figure>)>;

/// The sizes of an arch at its least thickness, of [`Quantity::MEASURED_STATE`]; if it does not stand its shape alone.
pub fn measured_state(arch: &Arch, measures: &Measures, digits: usize) -> Result<Measured, Error> {
    Refused::digits(digits)?;
    let found = raised(arch, digits, |bits| {
        let state = match state_enclosed(arch, bits, false)? {
            Outcome::Stands(state) => Some(state),
            Outcome::Falls(_) => None,
        };
        let state = state.as_ref().map(|state| [&state.thickness, &state.thrust]);
        Ok(measured_least(arch.half_opening(), measures, state, (bits, digits)))
    });
    Ok(found?)
}

/// The least thickness of an arch in metres; `None` if it does not stand.
pub fn least_in_metres(
    arch: &Arch,
    measures: &Measures,
    digits: usize,
) -> Result<Option<Figure>, Error> {
    Refused::digits(digits)?;
    let found = raised(arch, digits, |bits| match state_enclosed(arch, bits, false)? {
        Outcome::Stands(state) => {
            let alpha = arch.half_opening().enclosure(bits);
            let sizes = measures.sizes(&state.thickness, &alpha, bits);
            Ok(sizes.thickness.figure(digits).map(Some))
        }
        Outcome::Falls(_) => Ok(Some(None)),
    });
    Ok(found?)
}

/// The sizes of an arch of a given thickness, of [`Quantity::MEASURED_ASSESSMENT`]; what stays undecided is left out.
pub fn measured_assessment(
    (arch, thickness): (&Arch, &ExactNumber),
    measures: &Measures,
    digits: usize,
) -> Result<Measured, Error> {
    Refused::digits(digits)?;
    Refused::thickness(thickness)?;
    let found = raised(arch, digits, |bits| {
        let found: Assessment = assessment_enclosed(arch, thickness, bits);
        let [least, largest] = found.thrust.map(|limit| limit.ok().flatten());
        let thrusts = [(Quantity::LeastForce, least), (Quantity::LargestForce, largest)];
        let thrusts = thrusts.into_iter().filter_map(|(of, limit)| Some((of, limit?.thrust)));
        let known = (found.least_thickness.ok().flatten(), thrusts.collect());
        Ok(measured_of((arch.half_opening(), thickness), measures, known, (bits, digits)))
    });
    Ok(found?)
}

/// The least thickness of an arch over the radius, and thrusts over `w r` by the names of their forces; `None` for one
/// without bound.
pub type KnownRatios = (Option<Ball>, Vec<(Quantity, Option<Ball>)>);

/// The sizes of an arch of a given thickness of which some ratios are known, in balls of some bits; `None` if their
/// rounding to `digits` digits is not decided.
pub fn measured_of(
    (half_opening, thickness): (&ExactNumber, &ExactNumber),
    measures: &Measures,
    (least, thrusts): KnownRatios,
    (bits, digits): (u32, usize),
) -> Option<Measured> {
    let alpha: Ball = half_opening.enclosure(bits);
    let sizes = measures.sizes(&thickness.enclosure(bits), &alpha, bits);
    let least = least.map(|eta| measures.sizes(&eta, &alpha, bits).thickness);
    let radius = measures.exact_radius(Some(thickness));
    let metres = radius.as_ref().map(|radius| radius.factor() * thickness.factor());
    let force = measures.exact_force(thickness).filter(|_| half_opening.is_rational());
    let exact = force.map(|force| force.factor() * (half_opening.factor() + half_opening.factor()));
    let mut sized = shape(half_opening, measures, bits);
    sized.extend([
        size(Quantity::Radius, sizes.radius, radius),
        size(Quantity::GivenThicknessInMetres, sizes.thickness, metres.map(ExactNumber::rational)),
        size(Quantity::GivenThickness, thickness.enclosure(bits), Some(thickness.clone())),
    ]);
    sized.extend(least.map(|least| size(Quantity::ThicknessInMetres, least, None)));
    let weight = |weight| size(Quantity::Weight, weight, exact.map(ExactNumber::rational));
    sized.extend(sizes.weight.map(weight));
    if let Some(force) = sizes.force {
        let told = |h| MeasuredSize::Enclosed(force.clone() * h);
        sized.extend(thrusts.into_iter().map(|(of, thrust)| (of, thrust.map(told))));
    }
    figures(sized, digits)
}

/// The sizes of an arch at its least thickness, of which thickness and thrust are known, in balls of some bits; `None`
/// if their rounding to `digits` digits is not decided, and of an arch without a state its shape alone.
pub fn measured_least(
    half_opening: &ExactNumber,
    measures: &Measures,
    state: Option<[&Ball; 2]>,
    (bits, digits): (u32, usize),
) -> Option<Measured> {
    let mut sized = shape(half_opening, measures, bits);
    if let Some([thickness, thrust]) = state {
        let sizes = measures.sizes(thickness, &half_opening.enclosure(bits), bits);
        let force = sizes.force.map(|force| force * thrust);
        sized.push(size(Quantity::Radius, sizes.radius, measures.exact_radius(None)));
        sized.push(size(Quantity::ThicknessInMetres, sizes.thickness, None));
        let forces = [(Quantity::Weight, sizes.weight), (Quantity::Force, force)];
        sized.extend(forces.into_iter().filter_map(|(of, x)| Some(size(of, x?, None))));
    }
    figures(sized, digits)
}

/// A size; the number itself where it is rational: no ball decides a tie.
enum MeasuredSize {
    Enclosed(Ball),
    Exact(ExactNumber),
}

impl MeasuredSize {
    fn new(enclosed: Ball, exact: Option<ExactNumber>) -> Self {
        exact.map_or(Self::Enclosed(enclosed), Self::Exact)
    }
}

/// A quantity with its size; `None` if it has no bound.
type MeasuredQuantity = (Quantity, Option<MeasuredSize>);

fn size(of: Quantity, enclosed: Ball, exact: Option<ExactNumber>) -> MeasuredQuantity {
    (of, Some(MeasuredSize::new(enclosed, exact)))
}

/// Sizes of an arch that are the same whatever its thickness.
fn shape(given: &ExactNumber, measures: &Measures, bits: u32) -> Vec<MeasuredQuantity> {
    let alpha: Ball = given.enclosure(bits);
    let enclosed = LazyCell::new(|| measures.span_and_rise(&alpha, bits));
    let exact = measures.exact_span_and_rise(given);
    let enclosed = |k: usize| MeasuredSize::Enclosed(enclosed[k].clone());
    let lengths = exact.into_iter().enumerate().map(|(k, exact)| {
        let size = exact.map_or_else(|| enclosed(k), MeasuredSize::Exact);
        ([Quantity::Span, Quantity::Rise][k], Some(size))
    });
    let angle = size(Quantity::HalfOpeningDegrees, degrees(&alpha), given.in_degrees());
    lengths.chain([angle]).collect()
}

/// All values, if they are decided.
fn figures(sized: Vec<MeasuredQuantity>, digits: usize) -> Option<Measured> {
    let figure = |size: MeasuredSize| match size {
        MeasuredSize::Exact(exact) => Figure::exact(&exact, digits),
        MeasuredSize::Enclosed(enclosed) => enclosed.figure(digits),
    };
    sized.into_iter().map(|(of, size)| Some((of, optional(size, figure)?))).collect()
}
