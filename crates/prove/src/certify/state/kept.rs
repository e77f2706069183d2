//! The states that were proved last, kept for the next question of the same arch: its thrusts, or its sizes in metres.

use super::mode::outcome;
use super::query::Query;
use super::state::Outcome;
use crate::problem::Arch;
use crate::prover::Undecided;
use std::cell::RefCell;

/// As many as one question asks for: the state with the friction of the arch, and the one with unlimited friction in
/// few bits and in all.
const KEPT: usize = 3;

/// A state with what it was asked by: the arch, its bits, and whether the frictions at which the mode changes are told.
type Kept = ((Arch, u32, bool), Result<Outcome, Undecided>);

thread_local! {
    static LAST: RefCell<Vec<Kept>> = const { RefCell::new(Vec::new()) };
    static QUERY: RefCell<Option<((Arch, u32), Query)>> = const { RefCell::new(None) };
}

/// The state of an arch in numbers of `bits` bits, with the frictions at which its mode changes if they are asked for,
/// or if they were before.
pub(super) fn kept_outcome(arch: &Arch, bits: u32, frictions: bool) -> Result<Outcome, Undecided> {
    let is_it = |((of, to, has_frictions), _): &&Kept| {
        of == arch && *to == bits && (*has_frictions || !frictions)
    };
    let found = LAST.with_borrow(|last| last.iter().find(is_it).map(|(_, found)| found.clone()));
    found.unwrap_or_else(|| {
        let found = outcome(&kept_query(arch, bits), frictions);
        LAST.with_borrow_mut(|last| {
            last.insert(0, ((arch.clone(), bits, frictions), found.clone()));
            last.truncate(KEPT);
        });
        found
    })
}

/// The arch in numbers of `bits` bits: sine and cosine of its half opening are kept.
pub(super) fn kept_query(arch: &Arch, bits: u32) -> Query {
    let is_it = |((of, to), _): &&((Arch, u32), Query)| of == arch && *to == bits;
    let kept =
        QUERY.with_borrow(|kept| kept.as_ref().filter(is_it).map(|(_, query)| query.clone()));
    kept.unwrap_or_else(|| {
        let query = Query::new(arch, bits);
        QUERY.set(Some(((arch.clone(), bits), query.clone())));
        query
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Only the same question has the same answer: another arch, other bits, or frictions that were not asked for have
    /// a proof of their own.
    #[test]
    fn what_is_kept_is_that_of_the_same_question() {
        let arch = |alpha| Arch::parse("heyman", alpha, "1").unwrap();
        let (wide, narrow) = (arch("80deg"), arch("1"));
        let told = |arch: &Arch, bits, frictions| match kept_outcome(arch, bits, frictions) {
            Ok(Outcome::Stands(state)) => {
                (state.thickness.prec(), state.thickness.mid().to_f64(), state.frictions.is_some())
            }
            other => panic!("{other:?}"),
        };
        let plain = told(&wide, 200, false);
        assert_eq!((plain.0, plain.2), (200, false));
        assert_eq!(told(&wide, 200, false), plain);
        assert!(told(&wide, 200, true).2, "asked for afterwards");
        assert_eq!(told(&wide, 300, false).0, 300);
        assert_ne!(told(&narrow, 200, false).1, plain.1);
        assert_eq!(told(&wide, 200, false).1, plain.1);
    }
}
