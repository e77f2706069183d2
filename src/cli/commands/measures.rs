//! The arguments of an arch that is measured in metres.

use crate::number::ExactNumber;
use crate::problem::measures::{
    Circle, Length, MeasureError, Measures, UnitWeight, of_span_and_rise,
};
use crate::problem::{Quantity, ThicknessError};
use crate::sweep::failure::Failure;
use clap::Args;

/// An arch as it is measured; all lengths with their unit (10m, 60cm, 600mm, 33ft, 7in).
#[derive(Args)]
#[command(next_help_heading = "In metres")]
pub(super) struct MeasureArguments {
    /// Span, with --rise instead of the half opening.
    #[arg(
        long,
        value_name = "LENGTH",
        requires = "rise",
        conflicts_with = "half_opening",
        allow_hyphen_values = true
    )]
    span: Option<Length>,

    /// Rise, from the springing joints' height to the crown.
    #[arg(long, value_name = "LENGTH", requires = "span", allow_hyphen_values = true)]
    rise: Option<Length>,

    /// Radius, with --half-opening.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    radius: Option<Length>,

    /// Circle at which these are measured: intrados (if not given: the clear span), centreline or extrados.
    #[arg(long, value_name = "CIRCLE")]
    measured_at: Option<Circle>,

    /// Density of the material (2400kg/m3, 24kN/m3); with --depth, forces are told in kN.
    #[arg(long, value_name = "DENSITY", requires = "depth", allow_hyphen_values = true)]
    density: Option<UnitWeight>,

    /// Depth of the arch, across its span.
    #[arg(long, value_name = "LENGTH", requires = "density", allow_hyphen_values = true)]
    depth: Option<Length>,
}

/// Measures of an arch, and the half opening that follows from them.
#[derive(Default)]
pub(super) struct MeasuredArch {
    /// The half opening, where it follows.
    pub half_opening: Option<ExactNumber>,
    /// The sizes, if any is given.
    pub measures: Option<Measures>,
}

impl MeasuredArch {
    /// The thickness-to-radius ratio that a text says, of an arch that may be measured: then as a length too.
    pub(super) fn thickness(&self, text: &str) -> Result<ExactNumber, Failure> {
        crate::problem::thickness(text, self.measures.as_ref()).map_err(|error| {
            let lengths = match error {
                ThicknessError::Length(_) => {
                    ", or the arch in metres: --span and --rise, or --radius"
                }
                ThicknessError::NoRatio(_) => {
                    ", or of an arch in metres a length in m, cm, mm, ft or in"
                }
                _ => "",
            };
            Failure::Input(format!("{error}{lengths}"))
        })
    }

    /// Quantities that can be asked of an arch, and of one that is measured.
    pub(super) fn quantities(&self, usual: &[Quantity], of_measured: &[Quantity]) -> Vec<Quantity> {
        let Some(measures) = &self.measures else { return usual.to_vec() };
        let told = |of: &&Quantity| measures.has_forces() || !of.is_force();
        usual.iter().chain(of_measured.iter().filter(told)).copied().collect()
    }
}

impl MeasureArguments {
    /// Measures that are given.
    pub(super) fn measured(&self) -> Result<MeasuredArch, Failure> {
        let made = self.span.as_ref().zip(self.rise.as_ref());
        let made = made.map(|(span, rise)| of_span_and_rise(span, rise));
        let (half_opening, radius) = match (made, &self.radius) {
            (Some((_, made)), Some(given)) if made != *given => {
                let error =
                    MeasureError::Radius { given: given.to_string(), made: made.to_string() };
                return Err(error.into());
            }
            (Some((half_opening, radius)), _) => (Some(half_opening), radius),
            (None, Some(radius)) => (None, radius.clone()),
            (None, None) if self.density.is_some() => {
                return Err("forces need a size: give --span and --rise, or --radius".into());
            }
            (None, None) if self.measured_at.is_some() => {
                return Err(
                    "--measured-at needs a size: give --span and --rise, or --radius".into()
                );
            }
            (None, None) => return Ok(MeasuredArch::default()),
        };
        let circle = self.measured_at.unwrap_or_default();
        let loaded = self.density.clone().zip(self.depth.clone());
        Ok(MeasuredArch { half_opening, measures: Some(Measures::new(circle, radius, loaded)) })
    }
}
