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
    #[arg(long, value_name = "FROM..TO", value_parser = range, allow_hyphen_values = true)]
    half_opening_range: Option<AxisRange>,

    /// For a map, the frictions shown, in their unit (0..45).
    #[arg(long, value_name = "FROM..TO", value_parser = range, allow_hyphen_values = true)]
    friction_range: Option<AxisRange>,

    /// For a map, the thicknesses shown (0..0.5).
    #[arg(long, value_name = "FROM..TO", value_parser = range, allow_hyphen_values = true)]
    thickness_range: Option<AxisRange>,
}

/// From where to where an axis goes.
#[derive(Clone, Copy, Debug)]
struct AxisRange([f64; 2]);

fn range(text: &str) -> Result<AxisRange, String> {
    Shown::range_of(text).map(AxisRange)
}

impl AxesArguments {
    /// The axes of a map.
    pub(super) fn axes(&self) -> Axes {
        let of = |unit, range: Option<AxisRange>| Shown {
            unit,
            range: range.map(|AxisRange(ends)| ends),
        };
        Axes {
            half_opening: of(Unit::named(&self.half_opening_unit), self.half_opening_range),
            friction: of(Unit::named(&self.friction_unit), self.friction_range),
            thickness: of(Unit::named(&self.scale), self.thickness_range),
        }
    }
}
