//! The axes of a map: units, ranges, a scale.

use crate::cli::failure::Failure;
use crate::number::shown;
use crate::report::{Axes, Plane, Shown, Unit};
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
    half_opening_range: Option<Range>,

    /// For a map, the frictions shown, in their unit (0..45).
    #[arg(long, value_name = "FROM..TO", value_parser = range, allow_hyphen_values = true)]
    friction_range: Option<Range>,

    /// For a map, the thicknesses shown (0..0.5).
    #[arg(long, value_name = "FROM..TO", value_parser = range, allow_hyphen_values = true)]
    thickness_range: Option<Range>,
}

/// From where to where an axis goes.
#[derive(Clone, Copy, Debug)]
struct Range([f64; 2]);

fn range(text: &str) -> Result<Range, String> {
    let wrong =
        || format!("'{}' is no range: two numbers, the smaller first, as in 0..0.5", shown(text));
    let (from, to) = text.split_once("..").ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse().ok().filter(|x: &f64| (0.0..=1e3).contains(x));
    let (from, to) = (number(from).ok_or_else(wrong)?, number(to).ok_or_else(wrong)?);
    // Closer ends would ask more of the drawing than its numbers tell.
    (to - from > 1e-6 * to).then_some(Range([from, to])).ok_or_else(wrong)
}

/// The least thickness of a logarithmic axis.
const THINNEST: f64 = 1e-9;

impl AxesArguments {
    /// The axes of a map, which have to be those of its plane.
    pub(super) fn axes(&self, plane: Plane, is_map: bool) -> Result<Axes, Failure> {
        let unit = |unit: &str| match unit.to_ascii_lowercase().as_str() {
            "rad" => Unit::Radians,
            "mu" | "a" | "log" => Unit::Derived,
            _ => Unit::Usual,
        };
        let of = |unit, range: Option<Range>| Shown { unit, range: range.map(|Range(ends)| ends) };
        let axes = Axes {
            half_opening: of(unit(&self.half_opening_unit), self.half_opening_range),
            friction: of(unit(&self.friction_unit), self.friction_range),
            thickness: of(unit(&self.scale), self.thickness_range),
        };
        let fault = |message: String| Err(Failure::Input(message));
        if axes != Axes::default() && !is_map {
            return fault(
                "units, ranges and a scale are for a map as svg or png, without --lines".into(),
            );
        }
        let name = plane.name();
        for (quantity, asked) in [
            ("opening", axes.half_opening),
            ("friction", axes.friction),
            ("thickness", axes.thickness),
        ] {
            if asked != Shown::default() && !name.contains(quantity) {
                return fault(format!("the plane {name} has no axis of {quantity}"));
            }
        }
        let thinnest = self.thickness_range.map_or(1.0, |Range([from, _])| from);
        if axes.thickness.unit == Unit::Derived && thinnest < THINNEST {
            return fault(format!(
                "with --scale log a --thickness-range begins at {THINNEST:e} or above"
            ));
        }
        Ok(axes)
    }
}
