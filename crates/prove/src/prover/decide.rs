//! Signs: what is decided, and what is required for a proof to go on.

use super::Undecided;
use super::arithmetic::Arithmetic;
use crate::arch::Configuration;
use crate::number::{Enclosure, Engine, Ternary};
use crate::problem::{Condition, Mode};

/// Decides whether a margin is positive, if that can be told.
pub fn decide<E: Arithmetic>(
    margin: &E,
    question: &'static str,
    between: &[Mode],
) -> Result<bool, Undecided> {
    match margin.is_positive() {
        Ternary::True => Ok(true),
        Ternary::False => Ok(false),
        Ternary::Undecided => {
            // A margin without bound is no difference that is nearly zero.
            let gap = Some(margin.bound()).filter(|gap| gap.is_finite());
            let between = if gap.is_some() { between } else { &[] };
            Err(Undecided { gap, ..Undecided::new(question).between(between) })
        }
    }
}

/// Requires a margin to be positive for a proof to go on; where it is not, nothing is known.
pub(crate) fn require<E: Arithmetic>(margin: &E, question: &'static str) -> Result<(), Undecided> {
    ensure(decide(margin, question, &[])?, question)
}

/// Checks a statement that has to be proved.
pub fn ensure(is_proved: bool, question: &'static str) -> Result<(), Undecided> {
    if is_proved { Ok(()) } else { Err(Undecided::new(question)) }
}

/// Bits that tell nearly every sign.
pub(crate) const FEW: u32 = 256;

/// The proof of some signs of a state in few of its bits, where they are enough, or else in all.
pub(crate) fn in_few_bits<E: Engine, T>(
    at: &Configuration<E>,
    bits: u32,
    proof: impl Fn(&Configuration<E>, u32) -> Result<T, Undecided>,
) -> Result<T, Undecided> {
    let few = (bits > 2 * FEW).then(|| proof(&at.map_ref(|x| x.with_bits(FEW as usize)), FEW));
    few.and_then(Result::ok).map_or_else(|| proof(at, bits), Ok)
}

/// Tells whether a number is proved to be positive.
pub fn is_positive(x: &impl Enclosure) -> bool {
    x.is_positive().is_proved()
}

/// Requires a condition of a mode. A candidate that is proved to fail it is not the state of the arch: then it
/// is beside the point, not on a boundary.
pub(crate) fn require_condition<E: Arithmetic>(
    condition: Condition,
    margin: &E,
    mode: Mode,
) -> Result<(), Undecided> {
    match decide(margin, condition.label(), &[mode])? {
        true => Ok(()),
        false => Err(Undecided::new(format!(
            "the root found for {mode} is not the state of the arch, as this fails: {}",
            condition.label()
        ))),
    }
}
