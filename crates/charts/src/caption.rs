//! Caption of a map: what is said below.

use super::plane::PlaneAxis;
use super::sheet::Sheet;
use crate::atlas::Coordinate;
use crate::picture::path::ROUNDED;
use crate::picture::{Point, text};
use crate::report::words;
use std::collections::BTreeMap;

/// Caption of a picture: what the picture shows, how far it is proved, if its lines in a frame of a size are off by no
/// more than so much along each axis, and the command, each a paragraph.
pub(super) fn caption(
    shows: &str,
    sheets: &[Sheet],
    (off, size): (&[(PlaneAxis, f64)], Point),
    more: &str,
    command: &str,
) -> Vec<String> {
    let weights: Vec<String> = sheets.iter().map(|sheet| words::model(sheet.weight)).collect();
    let (weights, proved) = (weights.join(" and "), proved(sheets, off, size));
    vec![format!("{shows}. {weights}.{more} {proved}"), format!("Command: {command}")]
}

/// Words on the levels of a map, if it has any.
pub(super) fn of_levels(sheets: &[Sheet]) -> String {
    let levels = sheets.iter().flat_map(|sheet| &sheet.levels);
    let mut names: Vec<&str> = levels.map(|level| level.contour.name()).collect();
    names.dedup();
    match names.is_empty() {
        true => String::new(),
        false => format!(" Thin lines: equal {}.", names.join(" and ")),
    }
}

/// Statement of how near the lines drawn in a frame of a size are to the true ones, by how far they are off
/// along each axis, and what is not proved.
fn proved(sheets: &[Sheet], off: &[(PlaneAxis, f64)], size: Point) -> String {
    let mut open: Vec<String> = Vec::new();
    for sheet in sheets {
        open.extend(sheet.open().iter().map(|curve| format!("{curve} ({})", sheet.weight.name())));
    }
    let open = match open.is_empty() {
        true => "nothing is left open".to_owned(),
        false => format!("not proved, and dotted or left out, are parts of {}", open.join(", ")),
    };
    format!("{}; {open}.", told(off, size))
}

/// Statement of how near lines are to the true ones, in words.
pub(super) fn told(off: &[(PlaneAxis, f64)], size: Point) -> String {
    let mut units: BTreeMap<&str, f64> = BTreeMap::new();
    for (axis, off) in off {
        let most = units.entry(unit(axis.coordinate)).or_default();
        *most = most.max(off + rounding(axis, size));
    }
    let widths = units.into_iter().map(|(unit, off)| format!("{} in {unit}", upwards(off)));
    let widths: Vec<String> = widths.collect();
    let widths = widths.join(" and ");
    format!("Each line is proved to lie within {widths} of where it is drawn")
}

/// Unit in which a distance along an axis is told.
fn unit(coordinate: Coordinate) -> &'static str {
    match coordinate {
        Coordinate::HalfOpening | Coordinate::FrictionAngle => "radians",
        Coordinate::RotationJoint => "radians of βᵣ",
        Coordinate::OpeningVariable => "A",
        Coordinate::Friction => "μ",
        Coordinate::Thickness => "η",
        Coordinate::LogThickness => "decades of η",
        Coordinate::Thrust => "h",
    }
}

/// Effect on a place in a frame of a size, in η or rad, of rounding the file to thousandths of a unit.
fn rounding(axis: &PlaneAxis, (width, height): Point) -> f64 {
    let length = (axis.range[1] - axis.range[0]) / axis.unit;
    ROUNDED / 2.0 * length / width.min(height)
}

/// Text of a width to two digits, rounded up: `9.3×10⁻⁵`.
fn upwards(width: f64) -> String {
    let order = width.log10().floor() as i32;
    let digits = (width / 10f64.powi(order - 1)).ceil();
    let (digits, order) = if digits >= 100.0 { (10.0, order + 1) } else { (digits, order) };
    format!("{:.1}×{}", digits / 10.0, text::power_of_ten(order.into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::SIZE;
    use crate::plane::Plane;

    #[test]
    fn widths_are_rounded_up() {
        let widths = [9.21e-5, 9.991e-5, 1e-12, 0.5].map(upwards);
        assert_eq!(widths[..2], ["9.3×10⁻⁵", "1.0×10⁻⁴"]);
        assert!(widths[2].ends_with("10⁻¹²") && widths[3].starts_with("5."), "{widths:?}");
    }

    #[test]
    fn a_thousandth_of_a_unit_is_little() {
        for plane in Plane::ALL {
            for axis in plane.axes() {
                let away = rounding(&axis, SIZE);
                assert!(1e-7 < away && away < 3e-6, "{axis:?} {away}");
            }
        }
    }
}
