//! The arguments that describe an arch.

use super::parse;
use crate::arch::SelfWeight;
use crate::cli::failure::Failure;
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::{Arch, is_thickness};
use clap::Args;

/// An arch, all of it exact: `0.1` is one tenth, `80deg` and `pi/2` are what they say.
#[derive(Args)]
pub(super) struct ArchArguments {
    /// Half opening in radians (2.45, 1/3, pi/2) or degrees (80deg), between 0 and pi.
    #[arg(long, visible_alias = "alpha", value_name = "ANGLE", allow_hyphen_values = true)]
    pub half_opening: Option<String>,

    /// Friction coefficient mu (0.6, 3/5, inf), or an angle in degrees (31deg).
    #[arg(
        long,
        visible_alias = "mu",
        value_name = "MU",
        allow_hyphen_values = true,
        conflicts_with = "friction_angle"
    )]
    pub friction: Option<String>,

    /// Friction angle phi instead of the coefficient (21deg, pi/6).
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub friction_angle: Option<String>,

    /// Self-weight model: heyman or milankovitch.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weight)]
    pub weight: SelfWeight,

    /// Significant digits, 1 to 10000; values are correctly rounded to them.
    #[arg(long, default_value = "30", value_parser = parse::state_digits, allow_negative_numbers = true)]
    pub digits: usize,
}

impl ArchArguments {
    /// The arch described.
    pub(super) fn arch(&self) -> Result<Arch, Failure> {
        let friction = match (&self.friction, &self.friction_angle) {
            (Some(mu), _) => Some(mu.clone()),
            (None, phi) => phi.as_ref().map(|phi| format!("tan({phi})")),
        };
        let friction = (friction.as_deref(), "--friction or --friction-angle");
        arch(self.weight, self.half_opening.as_deref(), friction)
    }
}

/// An arch from the options that describe it; the second text names those of the friction.
pub(super) fn arch(
    weight: SelfWeight,
    half_opening: Option<&str>,
    (friction, options): (Option<&str>, &str),
) -> Result<Arch, Failure> {
    let missing = |what: &str| Failure::Input(format!("{what} is missing"));
    let half_opening = half_opening.ok_or_else(|| missing("--half-opening"))?;
    let friction = friction.ok_or_else(|| missing(options))?;
    Arch::parse(weight.name(), half_opening, friction)
        .map_err(|error| Failure::Input(error.to_string()))
}

/// A thickness-to-radius ratio between 0 and the physical limit 2.
pub(super) fn thickness(text: &str) -> Result<ExactNumber, String> {
    let thickness: ExactNumber =
        text.parse().map_err(|error: ParseExactError| error.to_string())?;
    is_thickness(&thickness)
        .then_some(thickness)
        .ok_or_else(|| format!("the thickness {text} is not between 0 and 2"))
}
