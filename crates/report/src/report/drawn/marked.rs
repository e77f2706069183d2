//! Arches to mark in a map, as they are asked for in words.

use super::mark::Mark;
use crate::arch::SelfWeight;
use crate::certify::{Error, Undecided};
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::{Arch, ArchError, Friction, thickness};
use std::fmt;
use std::str::FromStr;

/// An arch to mark, but for its weight.
#[derive(Clone, Debug)]
pub struct Marked {
    /// Text as it was asked for.
    text: String,
    half_opening: ExactNumber,
    friction: Friction,
    thickness: Option<ExactNumber>,
}

impl FromStr for Marked {
    type Err = String;

    /// A half opening, a friction and, if the arch has one, a thickness: `80deg,0.6,0.15`.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = |error: ParseExactError| error.to_string();
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
        let marked = Self {
            text: text.to_owned(),
            half_opening: half_opening.parse().map_err(wrong)?,
            friction: friction.parse().map_err(wrong)?,
            thickness: eta
                .map(|eta| thickness(eta, None))
                .transpose()
                .map_err(|e| e.to_string())?,
        };
        // Any weight will do to see whether it is an arch.
        marked.arch(SelfWeight::Heyman).map_err(|error| error.to_string())?;
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
        Arch::new(weight, self.half_opening.clone(), self.friction.clone())
    }

    /// Friction of the arch.
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// Mark with what is proved of it.
    pub fn proved(&self, weight: SelfWeight) -> Result<Mark, Error> {
        let arch = self.arch(weight)?;
        let open = |mut undecided: Undecided| {
            undecided.reason = format!("{arch}: {undecided}").into();
            undecided
        };
        let mark = Error::apart(Mark::new(&arch, self.thickness.as_ref()))?;
        Ok(mark.map_err(open)?)
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
        ] {
            let error = text.parse::<Marked>().unwrap_err();
            assert!(error.contains(words), "{text}: {error}");
        }
        let marked: Marked = "80deg,0.6,0.15".parse().unwrap();
        assert_eq!(marked.to_string(), "80deg,0.6,0.15");
    }
}
