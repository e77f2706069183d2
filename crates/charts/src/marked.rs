//! Arches to mark in a map, as they are asked for in words.

use super::mark::Mark;
use crate::arch::SelfWeight;
use crate::ask::Range;
use crate::certify::{Error, Undecided};
use crate::number::ExactNumber;
use crate::problem::survey::{Shape, Survey, SurveyError};
use crate::problem::{Arch, ArchError, Friction, thickness};
use std::fmt;
use std::str::FromStr;

/// An arch to mark, or all between two ends, but for their weight.
#[derive(Clone, Debug)]
pub struct Marked {
    /// Text as it was asked for.
    text: String,
    /// Least and largest half opening, rad.
    half_opening: [ExactNumber; 2],
    /// Least and largest friction.
    friction: [Friction; 2],
    /// Least and largest thickness, if it is given.
    thickness: Option<[ExactNumber; 2]>,
    /// True if a part of the text is a range.
    is_range: bool,
}

/// The two ends of a part of a mark, and whether it is a range.
fn ends<T, E: ToString>(
    text: &str,
    read: impl Fn(&str) -> Result<T, E>,
) -> Result<([T; 2], bool), String> {
    let range = Range::read(text).map_err(|error| error.to_string())?;
    let is_range = range.is_some();
    let [lower, upper] =
        range.map_or_else(|| [text, text].map(str::to_owned), |range| [range.lower, range.upper]);
    let read = |text: String| read(&text).map_err(|error| error.to_string());
    Ok(([read(lower)?, read(upper)?], is_range))
}

impl FromStr for Marked {
    type Err = String;

    /// A half opening, a friction and, if the arch has one, a thickness, each of which may be a range:
    /// `80deg,0.6,0.15`, `78deg..82deg,0.6±10%`.
    fn from_str(text: &str) -> Result<Self, String> {
        let parts: Vec<&str> = text.split(',').collect();
        let (half_opening, friction, eta) = match parts[..] {
            [alpha, mu] => (alpha, mu, None),
            [alpha, mu, eta] => (alpha, mu, Some(eta)),
            _ => {
                let form =
                    "a mark is a half opening, a friction and perhaps a thickness: 80deg,0.6,0.15";
                return Err(form.into());
            }
        };
        let (half_opening, is_wide) = ends(half_opening, str::parse::<ExactNumber>)?;
        let (friction, is_rough) = ends(friction, str::parse::<Friction>)?;
        let eta = eta.map(|eta| ends(eta, |eta| thickness(eta, None))).transpose()?;
        let (eta, is_thick) = eta.unzip();
        let is_range = is_wide || is_rough || is_thick == Some(true);
        let marked =
            Self { text: text.to_owned(), half_opening, friction, thickness: eta, is_range };
        // Any weight will do to see whether it is an arch.
        match is_range {
            true => marked.survey(SelfWeight::Heyman).map(drop).map_err(|error| error.to_string()),
            false => marked.arch(SelfWeight::Heyman).map(drop).map_err(|error| error.to_string()),
        }?;
        Ok(marked)
    }
}

impl fmt::Display for Marked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.text)
    }
}

impl Marked {
    fn arch(&self, weight: SelfWeight) -> Result<Arch, ArchError> {
        Arch::new(weight, self.half_opening[0].clone(), self.friction[0].clone())
    }

    fn survey(&self, weight: SelfWeight) -> Result<Survey, SurveyError> {
        let shape = Shape::Free {
            half_opening: self.half_opening.clone(),
            thickness: self.thickness.clone(),
        };
        Survey::new(weight, self.friction.clone(), shape)
    }

    /// Frictions of the arch, or of the ends.
    pub fn frictions(&self) -> &[Friction] {
        &self.friction[..if self.is_range { 2 } else { 1 }]
    }

    /// Mark with what is proved of it.
    pub fn proved(&self, weight: SelfWeight) -> Result<Mark, Error> {
        let open = |of: String| {
            move |mut undecided: Undecided| {
                undecided.reason = format!("{of}: {undecided}").into();
                undecided
            }
        };
        if self.is_range {
            let no_survey = |error: SurveyError| Undecided::new(error.to_string());
            let mark = Mark::of_range(&self.text, &self.survey(weight).map_err(no_survey)?);
            return Ok(Error::apart(mark)?.map_err(open(format!("{weight}, {}", self.text)))?);
        }
        let arch = self.arch(weight)?;
        let thickness = self.thickness.as_ref().map(|[eta, _]| eta);
        let mark = Error::apart(Mark::new(&arch, thickness))?;
        Ok(mark.map_err(open(arch.to_string()))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_arch_is_no_mark() {
        for (text, words) in [
            ("1", "a mark is a half opening"),
            ("1,2,1,1", "a mark is a half opening"),
            ("4,1", "between 0 and pi"),
            ("1,-1", "friction"),
            ("1,1,3", "the thickness 3 is not between 0 and 2"),
            ("1,1,x", "'x' is no thickness"),
            ("1,1,60cm", "is a length"),
            ("1.5..1,1", "the range 1.5..1 is empty"),
            ("1..,1", "half a range"),
            ("1,30..32deg", "write 30deg..32deg"),
            ("1..4,1", "between 0 and pi"),
            ("1,0.5..0.7,0.1..3", "the thickness 3 is not between 0 and 2"),
        ] {
            let error = text.parse::<Marked>().unwrap_err();
            assert!(error.contains(words), "{text}: {error}");
        }
        let marked: Marked = "80deg,0.6,0.15".parse().unwrap();
        assert_eq!((marked.to_string().as_str(), marked.frictions().len()), ("80deg,0.6,0.15", 1));
        let range: Marked = "80deg±2deg,0.5..inf".parse().unwrap();
        assert_eq!(range.frictions(), ["0.5", "inf"].map(|mu| mu.parse().unwrap()));
    }
}
