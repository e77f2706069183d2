//! The thickness of an arch as it is written: its ratio to the radius of the centreline (`0.1`, `0.1r`), or a
//! length (`60cm`).

use super::arch::is_thickness;
use super::measures::{Length, MeasureError, Measures};
use crate::number::{ExactNumber, ParseExactError, says, shown};

/// Reason why a text is no thickness.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ThicknessError {
    /// The text is no number, of an arch that has only ratios.
    NoRatio(String),
    /// The text is no length and no ratio, of an arch in metres.
    NoLength(String),
    /// A number beside lengths, which could be either.
    NoUnit(String),
    /// A length, of an arch that has none.
    Length(String),
    /// A multiple of pi.
    Irrational(String),
    /// The number is not above 0, or above the physical limit.
    Outside(String),
    /// The intrados is measured, and has no radius.
    Point(String),
    /// A length that is too large.
    Measures(MeasureError),
    /// A number that is not read.
    Number(ParseExactError),
}

says!(ThicknessError {
    Self::NoRatio(text) =>
        "'{text}' is no thickness: give its ratio to the radius, a decimal (0.12) or a fraction (3/25)";
    Self::NoLength(text) =>
        "'{text}' is no thickness: give a length in m, cm, mm, ft or in (60cm), or its ratio to the radius (0.12r)";
    Self::NoUnit(text) =>
        "the thickness {text} has no unit: beside lengths write {text}m (or cm, mm, ft, in), or {text}r, its \
         ratio to the radius of the centreline";
    Self::Length(text) => "the thickness {text} is a length: give its ratio to the radius (0.12)";
    Self::Irrational(text) => "the thickness {text} is no ratio of thickness to radius (0.12, 3/25)";
    Self::Outside(text) => "the thickness {text} is not between 0 and 2";
    Self::Point(text) => "at the thickness {text} the intrados is a point, and has no radius to measure";
} from {
    MeasureError => Self::Measures;
    ParseExactError => Self::Number;
});

/// The ratio of thickness to radius that a text says: of an arch in metres with a unit, a length or `r`; of another
/// with or without `r`.
///
/// ```
/// use couplet_check::problem::thickness;
/// assert_eq!(thickness("0.1", None), thickness("0.1r", None));
/// assert!(thickness("60cm", None).is_err(), "a length beside nothing");
/// ```
pub fn thickness(text: &str, measures: Option<&Measures>) -> Result<ExactNumber, ThicknessError> {
    let text = text.trim();
    let shown = || shown(text);
    // A ratio may say that it is one: `0.1r`.
    let number = text.strip_suffix('r').map_or(text, str::trim_end);
    let eta = match (text.parse::<Length>(), measures) {
        (Ok(length), Some(measures)) => measures.thickness(&length)?,
        (Ok(_), None) => return Err(ThicknessError::Length(shown())),
        (Err(error @ MeasureError::NotPositive(_)), _) => return Err(error.into()),
        (Err(_), _) => {
            let syntax = |error| match error {
                ParseExactError::Syntax(_) if measures.is_some() => {
                    ThicknessError::NoLength(shown())
                }
                ParseExactError::Syntax(_) => ThicknessError::NoRatio(shown()),
                other => other.into(),
            };
            number.parse::<ExactNumber>().map_err(syntax)?
        }
    };
    match measures {
        Some(_) if eta.is_rational() && number == text && text.parse::<Length>().is_err() => {
            Err(ThicknessError::NoUnit(shown()))
        }
        _ => {
            ThicknessError::check(&eta, text)?;
            match measures {
                Some(of) if of.exact_radius(Some(&eta)).is_none() => {
                    Err(ThicknessError::Point(shown()))
                }
                _ => Ok(eta),
            }
        }
    }
}

impl ThicknessError {
    /// Checks that a number that is written so is a thickness.
    pub fn check(eta: &ExactNumber, text: &str) -> Result<(), Self> {
        match eta {
            eta if is_thickness(eta) => Ok(()),
            eta if eta.is_rational() => Err(Self::Outside(shown(text))),
            _ => Err(Self::Irrational(shown(text))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::measures::Circle;
    use super::*;

    fn measures() -> Measures {
        Measures::new(Circle::Intrados, "5m".parse().unwrap(), None)
    }

    #[test]
    fn a_ratio_may_say_that_it_is_one() {
        for text in ["0.1r", "0.1 r", " 1/10r ", "0.1"] {
            let eta = thickness(text, None).unwrap();
            assert_eq!(
                *eta.factor(),
                num_rational::BigRational::new(1.into(), 10.into()),
                "{text}"
            );
        }
        let found = thickness("0.1r", Some(&measures())).unwrap();
        assert_eq!(found.to_string(), "0.1");
        let found = thickness("60cm", Some(&measures())).unwrap();
        assert_eq!(found.to_string(), "6/53");
    }

    #[test]
    fn beside_lengths_a_number_has_a_unit() {
        let measures = measures();
        let refused = |text| thickness(text, Some(&measures)).unwrap_err().to_string();
        for text in ["0.6", "3/5", "7"] {
            let error = refused(text);
            assert!(error.contains(&format!("{text}m (or")), "{error}");
            assert!(error.contains(&format!("{text}r,")), "{error}");
        }
        assert!(refused("60km").contains("m, cm, mm, ft or in"));
        assert!(refused("2r").contains("is a point"));
        assert!(refused("3r").contains("not between 0 and 2"));
        assert!(refused("-1m").contains("not above 0") && refused("").contains("(60cm)"));
    }

    #[test]
    fn without_lengths_a_thickness_is_a_ratio() {
        let refused = |text| thickness(text, None).unwrap_err();
        assert_eq!(refused("60cm"), ThicknessError::Length("60cm".into()));
        assert_eq!(refused("x"), ThicknessError::NoRatio("x".into()));
        assert_eq!(refused("r"), ThicknessError::NoRatio("r".into()));
        assert_eq!(refused("pi/4"), ThicknessError::Irrational("pi/4".into()));
        for text in ["0", "-0.1r", "2.1r"] {
            assert_eq!(refused(text), ThicknessError::Outside(text.into()));
        }
        assert!(refused("1,5").to_string().contains("comma"));
    }
}
