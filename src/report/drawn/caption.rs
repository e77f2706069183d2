//! What is said below.

use super::page::SIZE;
use super::plane::Plane;
use super::sheet::Sheet;
use crate::picture::path::ROUNDED;
use crate::picture::text;
use crate::report::words;

/// What the picture shows, how far it is proved, and the command, each a paragraph.
pub(super) fn caption(shows: &str, sheets: &[&Sheet], plane: Plane, command: &str) -> Vec<String> {
    let weights: Vec<String> = sheets.iter().map(|sheet| words::model(sheet.weight)).collect();
    let weights = weights.join(" and ");
    let proved = proved(sheets, Some(rounding(plane)));
    let levels = match sheets.iter().all(|sheet| sheet.levels.is_empty()) {
        true => String::new(),
        false => format!(
            " Thin lines: equal {}; their straight parts rest on the claims unique-thicker and map-rows of \
             couplet prove.",
            plane.contour_name()
        ),
    };
    vec![format!("{shows}. {weights}.{levels} {proved}"), format!("Command: {command}")]
}

/// How near the drawn lines are to the true ones if they are the cubics themselves, but for rounding, else how near
/// the curves are known; and what is not proved.
pub(super) fn proved(sheets: &[&Sheet], rounding: Option<f64>) -> String {
    let width = sheets.iter().map(|sheet| sheet.width()).fold(0.0, f64::max);
    let mut open: Vec<String> = Vec::new();
    for sheet in sheets {
        open.extend(sheet.open().iter().map(|curve| format!("{curve} ({})", sheet.weight.name())));
    }
    let open = match open.is_empty() {
        true => "nothing is left open".to_owned(),
        false => format!("not proved, and dotted or left out, are parts of {}", open.join(", ")),
    };
    let width = upwards(width + rounding.unwrap_or(0.0));
    let is_near = match rounding {
        Some(_) => format!("Each line is proved to lie within {width} of where it is drawn"),
        None => format!("Each curve is proved in tubes no wider than {width} to either side"),
    };
    format!("{is_near}, in η and in radians; {open}.")
}

/// What the rounding of the file to thousandths of a unit makes of a place in the frame, in η or rad.
fn rounding(plane: Plane) -> f64 {
    let ranges = plane.axes().map(|axis| {
        let length = axis.range[1] - axis.range[0];
        length / axis.shown(1.0)
    });
    ROUNDED / 2.0 * ranges[0].max(ranges[1]) / SIZE.0.min(SIZE.1)
}

/// To two digits, rounded up: `9.3×10⁻⁵`.
fn upwards(width: f64) -> String {
    let order = width.log10().floor() as i32;
    let digits = (width / 10f64.powi(order - 1)).ceil();
    let (digits, order) = if digits >= 100.0 { (10.0, order + 1) } else { (digits, order) };
    format!("{:.1}×{}", digits / 10.0, text::power_of_ten(order.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_are_rounded_up() {
        let widths = [9.21e-5, 9.991e-5, 1e-12, 0.5].map(upwards);
        assert_eq!(widths[..2], ["9.3×10⁻⁵", "1.0×10⁻⁴"]);
        assert!(widths[2].ends_with("10⁻¹²") && widths[3].starts_with("5."), "{widths:?}");
    }

    #[test]
    fn a_thousandth_of_a_unit_is_little() {
        for plane in Plane::ALL {
            let away = rounding(plane);
            assert!(1e-7 < away && away < 3e-6, "{plane:?} {away}");
        }
    }
}
