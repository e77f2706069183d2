//! What a measured arch has in metres and kilonewtons.

use super::assess::Assessment;
use super::figure::{Figure, Figured};
use super::quick::{assessment_enclosed, state_enclosed};
use super::raise::raised;
use super::state::Outcome;
use crate::certify::Undecided;
use crate::number::{Ball, ExactNumber, Form, degrees};
use crate::problem::measures::Measures;
use crate::problem::{Arch, Quantity};

/// Values with their names; `None` for a thrust without bound.
type Measured = Vec<(Quantity, Option<Figure>)>;

/// The sizes of an arch at its least thickness, of [`Quantity::MEASURED_STATE`]; none if it does not stand.
pub fn measured_state(
    arch: &Arch,
    measures: &Measures,
    digits: usize,
) -> Result<Measured, Undecided> {
    raised(arch, digits, |bits| {
        let Outcome::Stands(state) = state_enclosed(arch, bits, false)? else {
            return Ok(Some(Vec::new()));
        };
        let alpha = half_opening(arch, bits);
        let sizes = measures.sizes(&state.thickness, &alpha, bits);
        let force = sizes.force.map(|force| force * &state.thrust);
        let rounded = Rounding { measures, arch, digits };
        let sized = [
            (Quantity::ThicknessInMetres, Some(sizes.thickness)),
            (Quantity::Weight, sizes.weight),
            (Quantity::Force, force),
        ];
        let sized = sized.into_iter().filter_map(|(of, x)| Some((of, Some(x?))));
        Ok(rounded.figures(&alpha, (&sizes.radius, None), sized))
    })
}

/// The sizes of an arch of a given thickness, of [`Quantity::MEASURED_ASSESSMENT`]; what stays undecided is left out.
pub fn measured_assessment(
    (arch, thickness): (&Arch, &ExactNumber),
    measures: &Measures,
    digits: usize,
) -> Result<Measured, Undecided> {
    raised(arch, digits, |bits| {
        let found: Assessment = assessment_enclosed(arch, thickness, bits)?;
        let alpha = half_opening(arch, bits);
        let sizes = measures.sizes(&thickness.enclosure(bits), &alpha, bits);
        let least = found.least_thickness.ok().flatten();
        let least = least.map(|eta| Some(measures.sizes(&eta, &alpha, bits).thickness));
        let [least_thrust, largest_thrust] = found.thrust.map(|limit| {
            let (limit, force) = limit.ok().flatten().zip(sizes.force.clone())?;
            Some(limit.thrust.map(|thrust| force * thrust))
        });
        let rounded = Rounding { measures, arch, digits };
        let sized = [
            (Quantity::ThicknessInMetres, least),
            (Quantity::Weight, sizes.weight.map(Some)),
            (Quantity::LeastForce, least_thrust),
            (Quantity::LargestForce, largest_thrust),
        ];
        let sized = sized.into_iter().filter_map(|(of, x)| Some((of, x?)));
        Ok(rounded.figures(&alpha, (&sizes.radius, Some(thickness)), sized))
    })
}

fn half_opening(arch: &Arch, bits: u32) -> Ball {
    arch.half_opening().enclosure(bits)
}

/// How the values of an arch are rounded.
struct Rounding<'a> {
    measures: &'a Measures,
    arch: &'a Arch,
    digits: usize,
}

impl Rounding<'_> {
    /// All values, if the balls decide them. What is known exactly is rounded so: no ball decides a tie.
    fn figures(
        &self,
        alpha: &Ball,
        (radius, thickness): (&Ball, Option<&ExactNumber>),
        sized: impl Iterator<Item = (Quantity, Option<Ball>)>,
    ) -> Option<Measured> {
        let digits = self.digits;
        let exact = self.measures.exact_radius(thickness);
        let radius = match exact {
            Some(exact) => Figure::exact(&exact, digits),
            None => radius.figure(digits),
        };
        let mut found = Vec::new();
        // Another angle is told in degrees well enough by what was given.
        if self.arch.half_opening().form() == Form::TwiceArctangent {
            found.push((Quantity::HalfOpeningDegrees, Some(degrees(alpha).figure(digits)?)));
        }
        found.push((Quantity::Radius, Some(radius?)));
        for (of, x) in sized {
            let figure = match x {
                Some(x) => Some(x.figure(digits)?),
                None => None,
            };
            found.push((of, figure));
        }
        Some(found)
    }
}
