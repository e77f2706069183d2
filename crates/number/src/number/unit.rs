//! Units of angles, as they are written behind a number.

use super::spelt;

/// The unit that is written behind a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum AngleUnit {
    None,
    Radians,
    Degrees,
    /// A hundredth of a right angle.
    Gons,
}

/// Spellings of units, in any case, with or without a space before them.
const UNITS: [(&str, AngleUnit); 7] = [
    ("°", AngleUnit::Degrees),
    ("degrees", AngleUnit::Degrees),
    ("degree", AngleUnit::Degrees),
    ("deg", AngleUnit::Degrees),
    ("gon", AngleUnit::Gons),
    ("radians", AngleUnit::Radians),
    ("rad", AngleUnit::Radians),
];

/// A text without its unit.
pub(super) fn unit(text: &str) -> (&str, AngleUnit) {
    let text = text.trim();
    let behind = |(written, unit): &(&str, AngleUnit)| {
        let (number, end) = text.split_at_checked(text.len().checked_sub(written.len())?)?;
        end.eq_ignore_ascii_case(written).then(|| (number.trim_end(), *unit))
    };
    UNITS.iter().find_map(behind).unwrap_or((text, AngleUnit::None))
}

/// Tells whether a number is written with the unit of an angle.
pub fn is_angle(text: &str) -> bool {
    let text = spelt(text);
    unit(&text).1 != AngleUnit::None || minutes(&text).is_some()
}

/// Degrees and what stands behind them, minutes and perhaps seconds: `80°30'15"`.
pub(super) fn minutes(text: &str) -> Option<[&str; 3]> {
    let (degrees, rest) = text.split_once('°')?;
    let (minutes, seconds) = rest.split_once(['\'', '′'])?;
    let seconds = match seconds.trim() {
        "" => "0",
        seconds => seconds.strip_suffix(['"', '″'])?,
    };
    Some([degrees, minutes, seconds].map(str::trim))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::ExactNumber;
    use num_rational::BigRational;

    #[test]
    fn units_are_read_in_their_usual_spellings() {
        for text in
            ["80deg", "80°", "80 deg", " 80 ° ", "80degrees", "80 Degrees", "80DEG", "80 degree"]
        {
            let number: ExactNumber = text.parse().unwrap();
            assert_eq!(
                (number.to_string().as_str(), number.is_in_degrees()),
                ("80deg", true),
                "{text}"
            );
            assert_eq!(*number.factor(), BigRational::new(4.into(), 9.into()));
            assert!(is_angle(text));
        }
        for text in ["1.5rad", "1.5 rad", "1.5 radians", "1.5"] {
            let number: ExactNumber = text.parse().unwrap();
            assert_eq!(
                (number.to_string().as_str(), number.is_in_degrees()),
                ("1.5", false),
                "{text}"
            );
        }
        for (text, degrees) in [
            ("88gon", "79.2deg"),
            ("80°30'15\"", "19321/240deg"),
            ("80° 30' 36\"", "80.51deg"),
            ("80º15'", "80.25deg"),
            ("10°20'", "31/3deg"),
        ] {
            assert_eq!(text.parse::<ExactNumber>().unwrap().to_string(), degrees, "{text}");
            assert!(is_angle(text));
        }
        for text in ["80°60'", "80°30'60\"", "80.5°30'", "80°-30'", "80°30\"", "80°30'x"] {
            assert!(text.parse::<ExactNumber>().is_err(), "{text}");
        }
        assert!(!is_angle("pi/6") && is_angle("0.5rad"));
    }
}
