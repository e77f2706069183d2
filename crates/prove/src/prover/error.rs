//! Reasons why there is no answer: one type for `?`.

use super::{Refused, Undecided};
use crate::number::{ParseExactError, says};
use crate::problem::ArchError;
use crate::problem::stones::StonesError;

/// Why there is no answer: the question made no sense, or the proof did not succeed.
///
/// ```
/// use couplet_prove::prelude::*;
/// fn thrust(half_opening: &str, digits: usize) -> Result<String, couplet_prove::certify::Error> {
///     let arch = Arch::parse("heyman", half_opening, "inf")?;
///     match arch.certify(digits)? {
///         Answer::Stands(state) => Ok(state.thrust.to_string()),
///         Answer::Falls { fall, .. } => Ok(fall.reason().to_owned()),
///     }
/// }
/// assert_eq!(thrust("80deg", 5).unwrap(), "0.69718");
/// assert!(matches!(thrust("80deg", 0), Err(couplet_prove::certify::Error::Refused(_))));
/// assert!(matches!(thrust("80", 5), Err(couplet_prove::certify::Error::Refused(_))), "no half opening");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// The question makes no sense.
    Refused(Refused),
    /// The proof did not succeed.
    Undecided(Undecided),
}

says!(Error {
} from {
    Refused => Self::Refused;
    Undecided => Self::Undecided;
});

impl Error {
    /// An answer or the proof that did not succeed, apart from a question that makes no sense.
    pub fn apart<T>(found: Result<T, Self>) -> Result<Result<T, Undecided>, Refused> {
        match found {
            Ok(found) => Ok(Ok(found)),
            Err(Self::Undecided(undecided)) => Ok(Err(undecided)),
            Err(Self::Refused(refused)) => Err(refused),
        }
    }
}

impl From<ArchError> for Error {
    fn from(error: ArchError) -> Self {
        Refused::from(error).into()
    }
}

impl From<ParseExactError> for Error {
    fn from(error: ParseExactError) -> Self {
        ArchError::from(error).into()
    }
}

impl From<StonesError> for Error {
    fn from(error: StonesError) -> Self {
        Refused::from(error).into()
    }
}
