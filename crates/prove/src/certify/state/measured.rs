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
type Measured = Vec<(Quantity, Option<Figure>)>;

/// The sizes of an arch at its least thickness, of [`Quantity::MEASURED_STATE`]; if it does not stand its shape alone.
pub fn measured_state(arch: &Arch, measures: &Measures, digits: usize) -> Result<Measured, Error> {
    Refused::digits(digits)?;
    let found = raised(arch, digits, |bits| {
        let mut sized = shape(arch, measures, bits);
        if let Outcome::Stands(state) = state_enclosed(arch, bits, false)? {
            let sizes = measures.sizes(&state.thickness, &half_opening(arch, bits), bits);
            let force = sizes.force.map(|force| force * &state.thrust);
            sized.push(size(Quantity::Radius, sizes.radius, measures.exact_radius(None)));
            sized.push(size(Quantity::ThicknessInMetres, sizes.thickness, None));
            let forces = [(Quantity::Weight, sizes.weight), (Quantity::Force, force)];
            sized.extend(forces.into_iter().filter_map(|(of, x)| Some((of, Some(x?.into())))));
        }
        Ok(figures(sized, digits))
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
            let sizes = measures.sizes(&state.thickness, &half_opening(arch, bits), bits);
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
        let alpha = half_opening(arch, bits);
        let sizes = measures.sizes(&thickness.enclosure(bits), &alpha, bits);
        let least = found.least_thickness.ok().flatten();
        let least = least.map(|eta| measures.sizes(&eta, &alpha, bits).thickness);
        let [least_thrust, largest_thrust] = found.thrust.map(|limit| {
            let (limit, force) = limit.ok().flatten().zip(sizes.force.clone())?;
            Some(limit.thrust.map(|thrust| force * thrust))
        });
        let radius = measures.exact_radius(Some(thickness));
        let metres = radius.as_ref().map(|radius| radius.factor() * thickness.factor());
        let (eta, metres) = (thickness.enclosure(bits), metres.map(ExactNumber::rational));
        let both = radius.as_ref().zip(metres.as_ref()).map(<[_; 2]>::from);
        let exact = both.and_then(|both| measures.exact_weight(arch.half_opening(), both));
        let weight = sizes.weight.map(|weight| Some(MeasuredSize::new(weight, exact)));
        let mut sized = shape(arch, measures, bits);
        sized.extend([
            size(Quantity::Radius, sizes.radius, radius),
            size(Quantity::GivenThicknessInMetres, sizes.thickness, metres),
            size(Quantity::GivenThickness, eta, Some(thickness.clone())),
        ]);
        let enclosed = |x: Option<Option<Ball>>| x.map(|x| x.map(MeasuredSize::from));
        let rest = [
            (Quantity::ThicknessInMetres, enclosed(least.map(Some))),
            (Quantity::Weight, weight),
            (Quantity::LeastForce, enclosed(least_thrust)),
            (Quantity::LargestForce, enclosed(largest_thrust)),
        ];
        sized.extend(rest.into_iter().filter_map(|(of, x)| Some((of, x?))));
        Ok(figures(sized, digits))
    });
    Ok(found?)
}

fn half_opening(arch: &Arch, bits: u32) -> Ball {
    arch.half_opening().enclosure(bits)
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

impl From<Ball> for MeasuredSize {
    fn from(enclosed: Ball) -> Self {
        Self::Enclosed(enclosed)
    }
}

fn size(of: Quantity, enclosed: Ball, exact: Option<ExactNumber>) -> MeasuredQuantity {
    (of, Some(MeasuredSize::new(enclosed, exact)))
}

/// Sizes of an arch that are the same whatever its thickness.
fn shape(arch: &Arch, measures: &Measures, bits: u32) -> Vec<MeasuredQuantity> {
    let alpha = half_opening(arch, bits);
    let enclosed = LazyCell::new(|| measures.span_and_rise(&alpha, bits));
    let exact = measures.exact_span_and_rise(arch.half_opening());
    let enclosed = |k: usize| MeasuredSize::Enclosed(enclosed[k].clone());
    let lengths = exact.into_iter().enumerate().map(|(k, exact)| {
        let size = exact.map_or_else(|| enclosed(k), MeasuredSize::Exact);
        ([Quantity::Span, Quantity::Rise][k], Some(size))
    });
    let given = arch.half_opening();
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
