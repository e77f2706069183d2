//! The paper, place by place: each equation and each sentence that says how much, or which is more, with what
//! decides it. The sentences are in our own words.

use super::sentence::Sentence;
use super::sentences;

/// The index, in the order of the paper.
pub fn index() -> Vec<Sentence> {
    [sentences::EQUATIONS, sentences::MAP, sentences::ILLUSTRATION, sentences::CONCLUSIONS].concat()
}

#[cfg(test)]
mod tests {
    use super::super::{Decided, Finding, claims};
    use super::*;
    use std::collections::BTreeSet;

    fn named() -> BTreeSet<&'static str> {
        let ids = index().into_iter().flat_map(|sentence| match sentence.decided {
            Decided::Claims(ids) => ids.to_vec(),
            Decided::Audit | Decided::Open(_) => Vec::new(),
        });
        ids.collect()
    }

    #[test]
    fn what_decides_a_sentence_is_a_claim() {
        let all: BTreeSet<_> = claims().iter().map(|claim| claim.id).collect();
        let unknown: Vec<_> = named().difference(&all).copied().collect();
        assert!(unknown.is_empty(), "{unknown:?}");
        let is_empty = |sentence: &Sentence| matches!(sentence.decided, Decided::Claims([]));
        assert!(!index().iter().any(is_empty));
    }

    /// And nothing else is: what the paper does not state has no place in it.
    #[test]
    fn what_the_paper_states_is_in_the_index() {
        let named = named();
        for claim in claims() {
            let is_stated = claim.decide().outcome != Ok(Finding::Implicit);
            assert_eq!(named.contains(claim.id), is_stated, "{}", claim.id);
        }
    }

    #[test]
    fn every_equation_is_in_the_index() {
        for n in 1..=20 {
            let place = format!("Eq. ({n})");
            assert!(index().iter().any(|sentence| sentence.place == place), "{place}");
        }
    }
}
