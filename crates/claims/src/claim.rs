//! A claim, what decides it and what comes out, and how the proof of one uses others.

use super::derivation::{Checked, Derivation, Support};
use crate::certify::Undecided;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// A statement of the paper, or one that it leaves implicit.
#[derive(Clone, Copy)]
pub struct Claim {
    /// A stable name.
    pub id: &'static str,
    /// The equation, table or section.
    pub place: &'static str,
    /// Statement that is claimed, as it is printed where it is.
    pub statement: &'static str,
    pub(super) decide: Decide,
}

type Prove = fn(&mut Derivation) -> Checked;
type Find = fn(&mut Derivation) -> Checked<Finding>;

/// Means by which a claim is decided.
#[derive(Clone, Copy)]
pub(super) enum Decide {
    /// A proof of the statement as it is printed.
    AsPrinted(Prove),
    /// A proof of what the paper leaves implicit.
    Implicit(Prove),
    /// A proof of what no sentence of the paper rests on.
    Ours(Prove),
    /// A proof of bounds, where the paper has no number or a rounded one.
    Measured(Prove),
    /// A derivation that finds how far the statement holds.
    Finds(Find),
}

/// Finding of a completed derivation on the statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// The statement holds as it is printed.
    AsPrinted,
    /// The statement holds; the paper does not state it.
    Implicit,
    /// The statement holds as it is printed, but in some places only with equality.
    Equality {
        /// Place where both sides are the same: `thickness at B is 2 for both weights`.
        at: String,
    },
    /// The statement speaks of an amount without a number, or with a rounded one: "about", "limited", "suffices".
    Measured {
        /// The number with which it is proved.
        holds_with: String,
        /// A number with which it is refuted, the printed one above all.
        fails_with: String,
    },
    /// The statement is false as printed.
    Misprint {
        /// Place where it fails: a point with the two values, or the difference that is not zero.
        counterexample: String,
        /// Statement that holds instead, and is proved by the derivation.
        corrected: &'static str,
    },
}

/// Decision on a claim.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Decision {
    /// The claim.
    pub claim: Claim,
    /// The finding, or why there is none.
    pub outcome: Result<Finding, Undecided>,
    /// The steps, as far as they went.
    pub derivation: Derivation,
    /// Time that it took.
    pub time: Duration,
}

/// The claims of a file, in the order of the paper: how each is decided, its id and place, what decides it, and its
/// statement.
macro_rules! claims {
    ($($kind:ident($id:literal, $place:literal, $decide:expr): $says:literal;)+) => {
        pub(super) const CLAIMS: &[$crate::Claim] = &[$($crate::Claim {
            id: $id,
            place: $place,
            statement: $says,
            decide: $crate::claim::Decide::$kind($decide),
        }),+];
    };
}
pub(super) use claims;

/// The name of a claim, which is the same in every run.
impl fmt::Debug for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id)
    }
}

impl Claim {
    /// Tells whether a name means this claim: its id, or the beginning of it up to a hyphen.
    pub fn is_named(&self, name: &str) -> bool {
        self.id.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    }

    /// Tells whether the claim decides no sentence of the paper.
    pub fn is_ours(&self) -> bool {
        matches!(self.decide, Decide::Ours(_))
    }

    /// Decides the claim, once in a process.
    pub fn decide(&self) -> Decision {
        static KNOWN: Mutex<BTreeMap<&str, Decision>> = Mutex::new(BTreeMap::new());
        let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let decided = known().get(self.id).cloned();
        decided.unwrap_or_else(|| {
            // Not under the lock: a claim uses others.
            let decision = self.decide_with(Derivation::new());
            known().insert(self.id, decision.clone());
            decision
        })
    }

    pub(super) fn decide_with(&self, mut derivation: Derivation) -> Decision {
        let start = Instant::now();
        let outcome = match self.decide {
            Decide::AsPrinted(prove) => prove(&mut derivation).map(|()| Finding::AsPrinted),
            Decide::Implicit(prove) | Decide::Ours(prove) => {
                prove(&mut derivation).map(|()| Finding::Implicit)
            }
            Decide::Measured(prove) => prove(&mut derivation).map(|()| {
                let [holds_with, fails_with] = derivation.numbers();
                Finding::Measured { holds_with, fails_with }
            }),
            Decide::Finds(find) => find(&mut derivation),
        };
        derivation.weigh_words();
        Decision { claim: *self, outcome, derivation, time: start.elapsed() }
    }
}

/// Uses claims in the proof of another by their ids, which are decided too. One that does not hold as it is stated
/// cannot be used.
pub(super) fn lemmas<const N: usize>(d: &mut Derivation, ids: [&str; N]) -> Checked {
    for id in ids {
        let claim = super::claims().into_iter().find(|claim| claim.id == id);
        let claim = claim.ok_or_else(|| Undecided::new(format!("there is no claim {id}")))?;
        d.use_claim(format!("{id}: {}", claim.statement), used(&claim)?);
    }
    Ok(())
}

/// Supports of a claim that is used, if it holds as it is stated.
fn used(claim: &Claim) -> Checked<Vec<Support>> {
    let Decision { outcome, derivation, .. } = claim.decide();
    match outcome {
        Ok(Finding::AsPrinted | Finding::Implicit) => Ok(derivation.supports().collect()),
        Ok(_) => Err(Undecided::new(format!("{} does not hold as it is stated", claim.id))),
        Err(undecided) => Err(undecided.about(claim.id)),
    }
}
