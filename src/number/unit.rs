//! Units of angles, as they are written behind a number.

/// The unit that is written behind a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    None,
    Radians,
    Degrees,
}

/// How units are written, in any case, with or without a space before them.
const UNITS: [(&str, Unit); 6] = [
    ("°", Unit::Degrees),
    ("degrees", Unit::Degrees),
    ("degree", Unit::Degrees),
    ("deg", Unit::Degrees),
    ("radians", Unit::Radians),
    ("rad", Unit::Radians),
];

/// A text without its unit.
pub(super) fn unit(text: &str) -> (&str, Unit) {
    let text = text.trim();
    let behind = |(written, unit): &(&str, Unit)| {
        let (number, end) = text.split_at_checked(text.len().checked_sub(written.len())?)?;
        end.eq_ignore_ascii_case(written).then(|| (number.trim_end(), *unit))
    };
    UNITS.iter().find_map(behind).unwrap_or((text, Unit::None))
}

/// Whether a number is written with the unit of an angle.
pub(crate) fn is_angle(text: &str) -> bool {
    unit(text).1 != Unit::None
}
