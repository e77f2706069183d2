//! Arches that are marked in a map.

use super::parse::thickness;
use crate::arch::SelfWeight;
use crate::cli::failure::Failure;
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::{Arch, ArchError, Friction};
use crate::report::Mark;

/// An arch to mark, but for its weight.
#[derive(Clone, Debug)]
pub(super) struct Marked {
    half_opening: ExactNumber,
    friction: Friction,
    thickness: Option<ExactNumber>,
}

pub(super) fn marked(text: &str) -> Result<Marked, String> {
    let wrong = |error: ParseExactError| error.to_string();
    let parts: Vec<&str> = text.split(',').collect();
    let (half_opening, friction, eta) = match parts[..] {
        [alpha, mu] => (alpha, mu, None),
        [alpha, mu, eta] => (alpha, mu, Some(eta)),
        _ => {
            return Err(
                "a mark is a half opening, a friction and perhaps a thickness: 80deg,0.6,0.15"
                    .into(),
            );
        }
    };
    let marked = Marked {
        half_opening: half_opening.parse().map_err(wrong)?,
        friction: friction.parse().map_err(wrong)?,
        thickness: eta.map(thickness).transpose()?,
    };
    // Any weight will do to see whether it is an arch.
    marked.arch(SelfWeight::Heyman).map_err(|error| error.to_string())?;
    Ok(marked)
}

impl Marked {
    fn arch(&self, weight: SelfWeight) -> Result<Arch, ArchError> {
        Arch::new(weight, self.half_opening.clone(), self.friction.clone())
    }

    /// With what is proved of it.
    pub(super) fn proved(&self, weight: SelfWeight) -> Result<Mark, Failure> {
        let arch = self.arch(weight).map_err(|error| Failure::Input(error.to_string()))?;
        Mark::new(&arch, self.thickness.as_ref())
            .map_err(|undecided| Failure::Undecided(format!("{arch}: {undecided}")))
    }
}
