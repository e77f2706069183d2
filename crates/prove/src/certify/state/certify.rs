//! Questions that can be proved of an arch: the door to this folder.

use super::assess::{Assessment, AssessmentDigits, Wanted};
use super::balls::Balls;
use super::digits::{Answer, Digits};
use super::inquiry::Inquiry;
use super::mode::{outcome, pure_sliding};
use super::query::{DOUBLE, Query, bits_lost};
use super::state::{Fall, Outcome};
use crate::number::{Ball, DoubleBall, ExactNumber, says};
use crate::problem::Arch;
use crate::prover::decide::require;
use crate::prover::{Error, Refused, Undecided};
use std::borrow::Borrow;

/// Fewer bits tell nothing of any arch.
const LEAST_BITS: u32 = 32;

/// Reason why an arch has no least thickness to show.
#[derive(Clone, Debug, PartialEq)]
pub enum NoState {
    /// The arch stands at no thickness, which is proved.
    Falls(Fall),
    /// The question makes no sense.
    Refused(Refused),
    /// The proof did not succeed.
    Undecided(Undecided),
}

says!(NoState {
    Self::Falls(fall) => "the arch stands at no thickness: {}", fall.reason();
} from {
    Refused => Self::Refused;
    Undecided => Self::Undecided;
});

impl From<Error> for NoState {
    fn from(error: Error) -> Self {
        match error {
            Error::Refused(refused) => refused.into(),
            Error::Undecided(undecided) => undecided.into(),
        }
    }
}

/// Proofs about an arch.
///
/// Digits are from 1 to [`MAX_DIGITS`](crate::certify::MAX_DIGITS); others are refused, as is a thickness
/// that is none.
///
/// ```
/// use couplet_prove::prelude::*;
/// let arch = Arch::parse("milankovitch", "80deg", "0.6")?;
/// let state = arch.least(17)?;
/// assert_eq!(format!("{} {}", state.mode, state.thickness), "[r,r,r] 0.068650463330373536");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// See also: [`Inquiry`] for several questions about one arch, [`CertifiedLandmark`] for the landmarks.
///
/// [`CertifiedLandmark`]: crate::certify::CertifiedLandmark
pub trait Certify: Borrow<Arch> {
    /// The state at the least thickness, correctly rounded to `digits` significant digits.
    fn least(&self, digits: usize) -> Result<Digits, NoState> {
        match self.certify(digits)? {
            Answer::Stands(state) => Ok(*state),
            Answer::Falls { fall, .. } => Err(NoState::Falls(fall)),
        }
    }

    /// The state with the proof that the arch stands at no thickness as one of the answers: the precision
    /// is raised until every comparison and every rounding is decided. Undecided if the arch lies on a
    /// boundary, or nearer to one than 8192 bits or four times those of the digits can tell.
    ///
    /// [`Balls::DoubleDoubles`] are asked first; the bounds in the field `binary` of a figure are others than those of
    /// [`Balls::Mpfr`], just as valid, and the nearest quadruple is not known.
    fn certify(&self, digits: usize) -> Result<Answer, Error> {
        Balls::DoubleDoubles.state(self.borrow(), digits, true)
    }

    /// State without the frictions at which the mode changes: nothing is evaluated that the proof of the
    /// state does not need.
    fn certify_alone(&self, digits: usize) -> Result<Answer, Error> {
        Balls::DoubleDoubles.state(self.borrow(), digits, false)
    }

    /// Proves what holds for the arch with a given thickness `t/r` in `(0, 2]`, in the same way.
    fn certify_thickness(
        &self,
        thickness: &ExactNumber,
        digits: usize,
    ) -> Result<AssessmentDigits, Refused> {
        Balls::DoubleDoubles.assess(self.borrow(), thickness, digits, Wanted::Everything)
    }

    /// The state in enclosures, proved with numbers of `bits` bits (and never fewer than 32): 64 are enough for an
    /// ordinary arch. What these cannot tell is undecided; more bits may.
    fn state(&self, bits: u32) -> Result<Outcome, Undecided> {
        outcome(&Query::new(self.borrow(), bits.max(LEAST_BITS)), true)
    }

    /// State in enclosures without the frictions at which the mode changes.
    fn state_alone(&self, bits: u32) -> Result<Outcome, Undecided> {
        outcome(&Query::new(self.borrow(), bits.max(LEAST_BITS)), false)
    }

    /// The state, without the frictions at which its mode changes, in balls of doubles: the same proof at a fraction of
    /// its cost, for a verdict, a mode and about thirteen digits. More arches are undecided than with 64 bits: those
    /// next to where the mode changes, and those of tiny half openings.
    ///
    /// ```
    /// use couplet_prove::certify::state::Outcome;
    /// use couplet_prove::prelude::*;
    /// let arch = Arch::parse("milankovitch", "80deg", "0.6")?;
    /// let Outcome::Stands(state) = arch.state_in_doubles()? else { panic!() };
    /// assert!((state.thickness.mid() - 0.068650463330373536).abs() <= state.thickness.rad());
    /// assert!(state.thickness.rad() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn state_in_doubles(&self) -> Result<Outcome<DoubleBall>, Undecided> {
        let found: Outcome<DoubleBall> = outcome(&Query::new(self.borrow(), DOUBLE), false)?;
        match &found {
            // The thickness of a tiny half opening is out of the range of these balls.
            Outcome::Stands(state) => require(&state.thickness, "a positive thickness")?,
            Outcome::Falls(_) => {}
        }
        Ok(found)
    }

    /// Proves what holds for the arch with a given thickness in `(0, 2]`, in enclosures.
    fn assess(&self, thickness: &ExactNumber, bits: u32) -> Result<Assessment, Refused> {
        Refused::thickness(thickness)?;
        let bits = bits.max(LEAST_BITS);
        Ok(Inquiry::new(self.borrow(), 1, false).assessment(thickness, bits, Wanted::Everything))
    }

    /// The friction below which nothing stands at this half opening: that of the purely sliding state.
    fn sliding_friction(&self, bits: u32) -> Result<Ball, Undecided> {
        pure_sliding(&Query::new(self.borrow(), bits.max(LEAST_BITS)))
    }

    /// Bits that the printed equations lose to cancellation for this arch: what [`Certify::state`] may
    /// need beyond 64.
    fn bits_lost(&self) -> u32 {
        bits_lost(self.borrow())
    }
}

impl Certify for Arch {}
