//! Saving of an arch of voussoirs over one with a joint at every angle.

use crate::number::{Ball, Rounded};
use crate::prover::Figure;
use crate::prover::decide::is_positive;

/// Savings of an arch of voussoirs over one with a joint at every angle, rounded to at most four digits.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct VoussoirLoss {
    /// The difference of the two least thicknesses.
    pub thickness: Rounded,
    /// Part that the difference is of the least thickness with a joint at every angle.
    pub share: Rounded,
}

/// Digits of a loss at most.
const DIGITS: usize = 4;
/// Bits beyond those that the two values have.
const BITS: u32 = 64;

/// The loss, from the digits and doubles of both least thicknesses; `None` where these do not tell it.
pub fn voussoir_loss(continuous: &Figure, stones: &Figure) -> Option<VoussoirLoss> {
    let bits = BITS + 4 * continuous.decimal.value.significant_digits() as u32;
    let continuous = continuous.enclosure(bits);
    let thickness = continuous.clone() - stones.enclosure(bits);
    let share = thickness.clone() / &continuous;
    if !is_positive(&thickness) {
        return None;
    }
    (1..=DIGITS).rev().find_map(|digits| {
        let rounded = |x: &Ball| Rounded::around(x, digits);
        Some(VoussoirLoss { thickness: rounded(&thickness)?, share: rounded(&share)? })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::ExactNumber;

    fn figure(text: &str, digits: usize) -> Figure {
        Figure::exact(&text.parse::<ExactNumber>().unwrap(), digits).unwrap()
    }

    #[test]
    fn a_loss_has_the_digits_that_are_known() {
        let loss = |a: &str, b: &str, digits| voussoir_loss(&figure(a, digits), &figure(b, digits));
        let told = |loss: Option<VoussoirLoss>| {
            loss.map(|loss| (loss.thickness.value.to_string(), loss.share.value.to_string()))
        };
        let pair = |a: &str, b: &str| Some((a.to_owned(), b.to_owned()));
        assert_eq!(told(loss("0.2", "0.1900031", 12)), pair("0.009997", "0.04998"));
        assert_eq!(told(loss("1/3", "0.333331", 8)), pair("0.000002333", "0.000007000"));
        assert_eq!(told(loss("0.2", "0.2", 12)), None);
        assert_eq!(told(loss("1/7", "0.142857142857142857", 9)), None, "nearer than is known");
        assert_eq!(told(loss("0.19", "0.2", 12)), None, "no loss");
    }
}
