//! The arguments that describe an arch.

use crate::arch::SelfWeight;
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::{Arch, Friction};
use crate::report::words::list;
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use clap::Args;

/// An arch, all of it exact: `0.1` is one tenth, `80deg` and `pi/2` are what they say.
#[derive(Args)]
pub(super) struct ArchArguments {
    #[command(flatten)]
    shape: ShapeArguments,

    /// Self-weight model: heyman, milankovitch or both.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weights)]
    pub weight: Weights,

    /// Significant digits, 1 to 10000; values are correctly rounded to them.
    #[arg(long, default_value = "30", value_parser = parse::state_digits, allow_negative_numbers = true)]
    pub digits: usize,
}

/// An arch without its self-weight.
#[derive(Args, Clone)]
pub(super) struct ShapeArguments {
    /// Half opening in radians (2.45, 1/3, pi/2) or degrees (80deg, 80°), between 0 and pi.
    #[arg(long, visible_alias = "alpha", value_name = "ANGLE", allow_hyphen_values = true)]
    half_opening: Option<String>,

    /// Friction coefficient mu (0.6, 3/5, inf), or an angle with its unit (31deg).
    #[arg(
        long,
        visible_alias = "mu",
        value_name = "MU",
        allow_hyphen_values = true,
        conflicts_with = "friction_angle"
    )]
    friction: Option<String>,

    /// Friction angle phi instead of the coefficient (21deg, pi/6).
    #[arg(long, visible_alias = "phi", value_name = "ANGLE", allow_hyphen_values = true)]
    friction_angle: Option<String>,
}

impl ArchArguments {
    /// The arches described, with each self-weight asked for; its half opening may follow from other arguments.
    pub(super) fn arches(
        &self,
        needs: &Missing,
        made: Option<&ExactNumber>,
    ) -> Result<Vec<Arch>, Failure> {
        let shape = self.shape.with_half_opening(made);
        self.weight.all().into_iter().map(|weight| shape.arch(weight, needs)).collect()
    }

    /// The half opening and the friction, where they are given.
    pub(super) fn given(&self) -> Result<(Option<ExactNumber>, Option<Friction>), ParseExactError> {
        let half_opening = self.shape.half_opening.as_deref().map(str::parse);
        let friction = self.shape.friction_text();
        Ok((half_opening.transpose()?, friction.as_deref().map(str::parse).transpose()?))
    }

    /// The half opening alone, between 0 and pi.
    pub(super) fn half_opening(&self, needs: &Missing) -> Result<ExactNumber, Failure> {
        let any = ShapeArguments { friction: Some("inf".to_owned()), ..self.shape.clone() };
        Ok(any.arch(SelfWeight::Milankovitch, needs)?.half_opening().clone())
    }
}

/// Options that a command misses beside the arch, and a command line that has everything.
pub(super) struct Missing {
    /// The option that is missing beside the arch.
    pub option: Option<&'static str>,
    /// Shown if anything is missing.
    pub example: &'static str,
}

impl ShapeArguments {
    /// Shape with a half opening that follows from other arguments, if it does.
    pub(super) fn with_half_opening(&self, made: Option<&ExactNumber>) -> Self {
        let half_opening = made.map(ExactNumber::to_string).or_else(|| self.half_opening.clone());
        Self { half_opening, ..self.clone() }
    }

    /// Tells whether any of the arguments is given.
    pub(super) fn is_given(&self) -> bool {
        self.half_opening.is_some() || self.has_friction()
    }

    /// The friction, if one is given that can be read.
    pub(super) fn friction(&self) -> Option<Friction> {
        self.friction_text()?.parse().ok()
    }

    /// Tells whether a friction is given.
    pub(super) fn has_friction(&self) -> bool {
        self.friction.is_some() || self.friction_angle.is_some()
    }

    /// The arch of the half opening, whatever its friction: it is unlimited.
    pub(super) fn without_friction(
        &self,
        weight: SelfWeight,
        needs: &Missing,
    ) -> Result<Arch, Failure> {
        let friction = Some("inf".to_owned()).filter(|_| self.half_opening.is_some());
        Self { friction, ..self.clone() }.arch(weight, needs)
    }

    /// The friction as [`Friction`] reads it.
    fn friction_text(&self) -> Option<String> {
        match (&self.friction, &self.friction_angle) {
            (Some(mu), _) => Some(mu.clone()),
            (None, phi) => phi.as_ref().map(|phi| format!("tan({phi})")),
        }
    }

    /// The arch described. All that is missing is told at once.
    pub(super) fn arch(&self, weight: SelfWeight, needs: &Missing) -> Result<Arch, Failure> {
        let friction = self.friction_text();
        let (Some(alpha), Some(mu), true) = (&self.half_opening, &friction, needs.option.is_none())
        else {
            let alpha = self.half_opening.is_none().then_some("--half-opening");
            let mu = friction.is_none().then_some("--friction (or --friction-angle)");
            let missing: Vec<&str> = alpha.into_iter().chain(mu).chain(needs.option).collect();
            let verb = if missing.len() == 1 { "is" } else { "are" };
            let missing = list(missing);
            return Err(format!("{missing} {verb} missing; for example: {}", needs.example).into());
        };
        Ok(Arch::parse(weight.name(), alpha, mu)?)
    }
}
