//! Claims of the paper, one statement at a time, each proved or refuted, for a reader and for Coq.
//!
//! | claims about | file |
//! |---|---|
//! | what `r`, `w`, `h` are: (1) | `units.rs` |
//! | moments, tangency, centroids: (2)–(6) | `moments.rs` |
//! | the cubics and their abbreviations: (7), (8) | `cubics.rs` |
//! | the curve of rotational states, the widest joint | `curve.rs` |
//! | the closed forms (9)–(11), their branches, the range of (12) | `branches.rs` |
//! | purely overturning states: (13)–(16) | `overturning.rs` |
//! | their trends, Fig. 3, with both weights | `trends.rs` |
//! | how rotation and overturning join | `joining.rs` |
//! | sliding: (17), (18) | `sliding.rs` |
//! | how many equations rule a state | `counts.rs` |
//! | (2)–(5), (17), (18) in forms that are regular everywhere | `regular.rs` |
//! | series for small openings and about `l` | `asymptotics.rs` |
//! | the landmarks | `landmarks.rs` |
//! | values of few digits, frictions that suffice | `rounded.rs` |
//! | certificates as Coq theorems | [`coq`] |
//! | the two weights at one half opening | `same_opening.rs`, `differences.rs` |
//! | the two weights compared at the landmarks | `weights.rs` |
//! | friction along sliding and along rotation | `frictions.rs`, with the states of `along.rs` |
//! | the two weights compared on the map | `map_of_weights.rs`, `border.rs` |
//! | which joints can be at their limits | `contacts.rs` |
//! | why there are seven modes | `modes.rs` |
//! | how the blocks move in each | `mechanisms.rs` |
//! | where on the map the modes are | `domains.rs` |
//! | why they fill it | `tiling.rs` |
//! | its lines as curves without gaps | `lines.rs` |
//! | its domains as areas, cell by cell | `areas.rs` |
//! | the landmarks as states of the whole arch | `admissible.rs` |
//! | one least thickness, one half opening | `uniqueness.rs` |
//! | asymmetric mechanisms above the least thickness | `asymmetric.rs` |
//! | where symmetric states have them too | `asymmetric_begins.rs` |
//! | arches of stones: (19), (20) | `stones.rs` |
//! | which there are | `asymmetric_kinds.rs` |
//! | where, and how many | `asymmetric_number.rs`, with the boxes of `asymmetric_cover` |
//! | all arches between measured ends | `surveys.rs` |
//! | of one rise the longer arch has the larger geometric safety | `safeties.rs`, with the letters of `rises.rs` |
//! | signs by algebra | `sign.rs` |
//! | what the paper says, place by place, and what decides it | `index.rs`, `sentences.rs` |
//!
//! A claim is decided by a [`Derivation`]: the equations of `arch` are evaluated over
//! [`symbolic`] numbers, and each step is checked exactly, or in balls over a whole
//! range. A person can read the steps; a test makes each of them in turn on a false twin, and then the claim
//! must fail.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod admissible;
mod along;
mod areas;
mod asymmetric;
mod asymmetric_begins;
mod asymmetric_cover;
mod asymmetric_kinds;
mod asymmetric_number;
mod asymptotics;
mod border;
mod branches;
mod claim;
mod contacts;
pub mod coq;
mod counts;
mod cubics;
mod curve;
mod derivation;
mod differences;
mod domains;
mod frictions;
mod index;
mod joining;
mod landmarks;
mod letters;
mod lines;
mod map_of_weights;
mod measured;
mod mechanisms;
mod modes;
mod moments;
mod overturning;
mod regular;
mod rises;
mod rounded;
mod safeties;
mod same_opening;
mod sentence;
mod sentences;
mod sign;
mod sliding;
mod states;
mod stones;
mod surveys;
mod tiling;
mod trends;
mod uniqueness;
mod units;
mod weights;

pub use claim::{Claim, Decision, Finding};
pub use derivation::{Argument, Derivation, DerivationStep, Formula, Support};
pub use index::index;
pub use sentence::{Decided, Sentence};

use claim::{claims, lemmas};
use derivation::Checked;

use couplet_atlas as atlas;
use couplet_check::{arch, check, problem};
use couplet_judge::judge;
use couplet_number::{number, symbolic};
use couplet_prove::{certify, prover};
use couplet_solve as solve;

/// The claims of these files.
macro_rules! of_files {
    ($($file:ident)+) => { [$($file::CLAIMS),+].concat() };
}

/// All claims, in the order of the paper.
pub fn claims() -> Vec<Claim> {
    of_files! {
        units moments cubics curve branches overturning trends joining sliding counts regular asymptotics
        landmarks rounded same_opening differences weights frictions map_of_weights border contacts modes
        mechanisms domains tiling lines areas admissible uniqueness stones asymmetric asymmetric_begins
        asymmetric_kinds asymmetric_number rises surveys safeties
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::{BTreeMap, BTreeSet};
    use std::sync::OnceLock;

    /// All claims, decided once for these tests.
    fn decisions() -> &'static [Decision] {
        static DECIDED: OnceLock<Vec<Decision>> = OnceLock::new();
        DECIDED.get_or_init(|| claims().iter().map(Claim::decide).collect())
    }

    #[test]
    fn every_claim_is_decided() {
        for Decision { claim, outcome, derivation, time } in decisions() {
            println!("{:20} {time:?}", claim.id);
            assert!(outcome.is_ok(), "{}: {outcome:?}", claim.id);
            assert!(!derivation.twins().is_empty(), "{} checks nothing", claim.id);
        }
    }

    #[test]
    fn no_claim_survives_a_false_twin_of_any_of_its_checks() {
        let mut survivors = Vec::new();
        for Decision { claim, derivation, .. } in decisions() {
            for index in 0..derivation.twins().len() {
                let spoiled = claim.decide_with(Derivation::spoiled(index));
                survivors.extend(spoiled.outcome.is_ok().then(|| format!("{} {index}", claim.id)));
            }
        }
        assert!(survivors.is_empty(), "{survivors:?}");
    }

    /// The number of checks with each twin is told in `proofs/README.md`, and held here.
    #[test]
    fn what_false_twins_change_is_told() {
        let mut counts = BTreeMap::new();
        for twin in decisions().iter().flat_map(|decision| decision.derivation.twins()) {
            *counts.entry(*twin).or_insert(0) += 1;
        }
        let told = include_str!("../../../proofs/README.md");
        let rows = told.lines().skip_while(|line| !line.starts_with("| checks |")).skip(2);
        let numbers = rows.map_while(|row| row.split('|').nth(1)?.trim().parse().ok());
        let counts = counts.into_values();
        assert_eq!(numbers.collect::<Vec<i32>>(), counts.collect::<Vec<_>>());
    }

    /// A theorem that a claim uses is one of those of `proofs/coq`, whose assumptions `make proofs` looks at, and says
    /// what it says there.
    #[test]
    fn theorems_that_are_used_are_listed() {
        let list = include_str!("hand_theorems.txt");
        let listed: BTreeSet<String> = list
            .lines()
            .filter_map(|line| {
                let [name, _, says] = line.split('\t').collect::<Vec<_>>()[..] else { return None };
                Some(format!("{name}: {says}"))
            })
            .collect();
        let steps = decisions().iter().flat_map(|decision| decision.derivation.steps());
        let used: Vec<_> = steps.filter(|step| step.support == Support::Theorem).collect();
        assert!(used.len() > 5);
        for step in used {
            assert!(listed.contains(&step.words), "{}", step.words);
            assert!(!listed.contains(&step.words.replace(": ", ": not ")), "{}", step.words);
        }
    }

    /// A bound in a proof is the rational that was used: no decimal has more digits than are proved of any number.
    #[test]
    fn no_step_shows_the_noise_of_a_double() {
        let significant = |number: &str| {
            let digits = number.chars().filter(char::is_ascii_digit);
            digits.skip_while(|digit| *digit == '0').count()
        };
        for step in decisions().iter().flat_map(|decision| decision.derivation.steps()) {
            let shown = step.formula.as_ref().map_or("", |formula| &formula.text);
            for text in [&step.words, shown] {
                let numbers = text.split(|c: char| !c.is_ascii_digit() && c != '.');
                for number in numbers.filter(|number| number.trim_matches('.').contains('.')) {
                    assert!(significant(number) <= 12, "{number} in {text}");
                }
            }
        }
    }

    #[test]
    fn every_claim_has_a_name_of_its_own() {
        let names: BTreeSet<_> = claims().iter().map(|claim| claim.id).collect();
        assert_eq!(names.len(), claims().len());
    }
}
