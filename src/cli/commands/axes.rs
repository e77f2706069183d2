//! The axes of a map: units, ranges, a scale.

use crate::report::{Axes, Shown, Unit};
use clap::Args;

/// How a map shows its quantities, and from where to where.
#[derive(Args)]
pub(super) struct AxesArguments {
    /// For a map, how the half opening is shown: deg, rad, or A = alpha cot(alpha/2).
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = ["deg", "rad", "A"], ignore_case = true)]
    half_opening_unit: String,

    /// For a map, how the friction is shown: as an angle, deg or rad, or as its coefficient, mu.
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = ["deg", "rad", "mu"], ignore_case = true)]
    friction_unit: String,

    /// For a map, how the thickness is shown: linear, or log, for thin arches.
    #[arg(long, value_name = "SCALE", default_value = "linear", value_parser = ["linear", "log"])]
    scale: String,

    /// For a map, the half openings shown, in their unit (120..160).
    #[arg(long, value_name = "FROM..TO", value_parser = Shown::range_of, allow_hyphen_values = true)]
    half_opening_range: Option<[f64; 2]>,

    /// For a map, the frictions shown, in their unit (0..45).
    #[arg(long, value_name = "FROM..TO", value_parser = Shown::range_of, allow_hyphen_values = true)]
    friction_range: Option<[f64; 2]>,

    /// For a map, the thicknesses shown (0..0.5).
    #[arg(long, value_name = "FROM..TO", value_parser = Shown::range_of, allow_hyphen_values = true)]
    thickness_range: Option<[f64; 2]>,
}

impl AxesArguments {
    /// The axes of a map.
    pub(super) fn axes(&self) -> Axes {
        let of = |unit: &str, range| Shown { unit: Unit::named(unit), range };
        Axes {
            half_opening: of(&self.half_opening_unit, self.half_opening_range),
            friction: of(&self.friction_unit, self.friction_range),
            thickness: of(&self.scale, self.thickness_range),
        }
    }
}
