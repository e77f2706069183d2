//! The paper, place by place: each equation and each sentence that says how much, or which is more, with what
//! decides it. The sentences are in our own words.

use super::sentence::Sentence;
use super::sentences::SENTENCES;

/// The index, in the order of the paper.
pub fn index() -> Vec<Sentence> {
    SENTENCES.to_vec()
}

#[cfg(test)]
mod tests {
    use super::super::{Decided, Finding, claims};
    use super::*;
    use std::collections::BTreeSet;

    fn named() -> BTreeSet<&'static str> {
        let ids = index().into_iter().flat_map(|sentence| match sentence.decided {
            Decided::Claims(ids) | Decided::Reading(ids, _) => ids.to_vec(),
            Decided::Audit | Decided::Opinion | Decided::Open(_) => Vec::new(),
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

    /// Each claim decides a sentence or is ours.
    #[test]
    fn every_claim_is_in_the_index_or_ours() {
        let named = named();
        for claim in claims() {
            assert_ne!(named.contains(claim.id), claim.is_ours(), "{claim:?}");
        }
    }

    #[test]
    fn what_is_ours_the_paper_does_not_state() {
        for claim in claims().iter().filter(|claim| claim.is_ours()) {
            assert_eq!(claim.decide().outcome, Ok(Finding::Implicit), "{}", claim.id);
        }
    }

    /// A sentence that is refuted has one claim: what holds beside it is another row.
    #[test]
    fn what_is_refuted_stands_alone() {
        let several = index().into_iter().filter_map(|sentence| match sentence.decided {
            Decided::Claims(ids) if ids.len() > 1 => Some(ids),
            _ => None,
        });
        let several: BTreeSet<_> = several.flatten().copied().collect();
        for claim in claims().iter().filter(|claim| several.contains(claim.id)) {
            let is_refuted = matches!(claim.decide().outcome, Ok(Finding::Misprint { .. }));
            assert!(!is_refuted, "{}", claim.id);
        }
    }

    /// Two rows of one place that say the same would be one row.
    #[test]
    fn no_sentence_is_there_twice() {
        let all: BTreeSet<_> =
            index().iter().map(|sentence| (sentence.place, sentence.says)).collect();
        assert_eq!(all.len(), index().len());
    }

    #[test]
    fn every_equation_is_in_the_index() {
        for n in 1..=20 {
            let place = format!("Eq. ({n})");
            assert!(index().iter().any(|sentence| sentence.place == place), "{place}");
        }
    }
}
