//! Arches as they come, in any order: from its third arch on a half opening shares its proofs.
//!
//! Nothing is known of what comes. Sharing costs about as much as two arches, so that what is shared costs at most
//! twice what it would alone, and no digit depends on it.

use super::opening::{ALONE, SharedOpening};
use crate::arch::SelfWeight;
use crate::certify::state::{Answer, Balls};
use crate::number::ExactNumber;
use crate::problem::Arch;
use crate::prover::{Error, Refused};
use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Arches that are asked the same, by any number of threads.
///
/// ```
/// use couplet_prove::certify::batch::SharedOpenings;
/// use couplet_prove::certify::state::{Answer, Balls};
/// use couplet_prove::prelude::*;
/// let openings = SharedOpenings::new(Balls::DoubleDoubles, 17, true)?;
/// for friction in ["0.1", "0.35", "0.6", "1.2"] {
///     let arch = Arch::parse("milankovitch", "80deg", friction)?;
///     assert_eq!(matches!(openings.state(&arch)?, Answer::Stands(_)), friction != "0.1");
/// }
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
#[derive(Debug)]
pub struct SharedOpenings {
    balls: Balls,
    digits: usize,
    frictions: bool,
    seen: Mutex<HashMap<(SelfWeight, ExactNumber), Seen>>,
}

/// State of a half opening and weight.
#[derive(Clone, Debug)]
enum Seen {
    /// Number of arches so far, each proved alone.
    Arches(usize),
    /// An arch whose thread makes the shared proofs. Others do not wait for it: its proof may wait for the work of
    /// this one.
    Begun,
    /// The shared proofs.
    Shared(Arc<SharedOpening>),
}

/// Number of half openings that are remembered, a few megabytes; then all are forgotten.
const MOST: usize = 4096;

impl SharedOpenings {
    /// Values to `digits` significant digits; `frictions` says whether the frictions at which the mode changes are
    /// asked for. Arches that are asked of balls of MPFR alone share nothing. Digits beyond
    /// [`MAX_DIGITS`](crate::certify::MAX_DIGITS) are refused.
    pub fn new(balls: Balls, digits: usize, frictions: bool) -> Result<Self, Refused> {
        Refused::digits(digits)?;
        Ok(Self { balls, digits, frictions, seen: Mutex::default() })
    }

    /// State of an arch, as [`Balls::state`] finds it.
    pub fn state(&self, arch: &Arch) -> Result<Answer, Error> {
        let shares = self.balls == Balls::DoubleDoubles;
        match shares.then(|| self.opening(arch)).flatten() {
            Some(opening) => opening.state(arch, self.frictions).map(Cow::into_owned),
            None => self.balls.state(arch, self.digits, self.frictions),
        }
    }

    /// Proofs that the half opening of an arch shares, if it does by now.
    fn opening(&self, arch: &Arch) -> Option<Arc<SharedOpening>> {
        let key = (arch.weight(), arch.half_opening().clone());
        {
            let mut all = self.seen.lock().unwrap_or_else(PoisonError::into_inner);
            if all.len() >= MOST && !all.contains_key(&key) {
                all.clear();
            }
            match all.entry(key.clone()).or_insert(Seen::Arches(0)) {
                Seen::Shared(opening) => return Some(Arc::clone(opening)),
                Seen::Begun => return None,
                Seen::Arches(count) if *count < ALONE => {
                    *count += 1;
                    return None;
                }
                seen => *seen = Seen::Begun,
            }
        }
        let opening = Arc::new(SharedOpening::new(key.0, key.1.clone(), self.digits).ok()?);
        let seen = Seen::Shared(Arc::clone(&opening));
        self.seen.lock().unwrap_or_else(PoisonError::into_inner).insert(key, seen);
        Some(opening)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certify::state::{Certify, Figure};
    use std::thread;

    fn shared_by(openings: &SharedOpenings) -> usize {
        let seen = openings.seen.lock().unwrap();
        seen.values().filter(|seen| matches!(seen, Seen::Shared(_))).count()
    }

    /// Answer about an arch, as text.
    fn told(found: &Result<Answer, Error>) -> String {
        let shown = |x: Option<&Figure>| match x {
            Some(x) => format!("{:?} {:?}", x.decimal, [x.double, x.binary.lower, x.binary.upper]),
            None => "none".to_owned(),
        };
        match found {
            Ok(Answer::Stands(state)) => {
                let figures = state.figures().map(|(of, x)| format!("{of:?} {}", shown(x)));
                format!("{:?} {}", state.mode, figures.collect::<Vec<_>>().join(" "))
            }
            Ok(Answer::Falls { fall, enough }) => {
                let enough = enough.as_deref().map(|enough| {
                    let all = [&enough.sliding_friction, &enough.friction, &enough.half_opening];
                    all.map(|x| shown(x.as_ref())).join(" ")
                });
                format!("{fall:?} {enough:?}")
            }
            Err(undecided) => undecided.to_string(),
        }
    }

    fn arches() -> Vec<Arch> {
        let frictions = ["1/10", "0.3", "0.5", "45deg", "2", "inf", "0.7"];
        let arch = |mu| SelfWeight::ALL.map(|w| ["1", "2.45"].map(|a| (w, a, mu)));
        let all = frictions.into_iter().flat_map(arch).flatten();
        all.map(|(weight, alpha, mu)| Arch::parse(weight.name(), alpha, mu).unwrap()).collect()
    }

    #[test]
    fn an_arch_is_answered_as_alone_whoever_came_before() {
        for frictions in [false, true] {
            let openings = SharedOpenings::new(Balls::DoubleDoubles, 17, frictions).unwrap();
            for arch in arches() {
                let alone = match frictions {
                    true => arch.certify(17),
                    false => arch.certify_alone(17),
                };
                assert_eq!(told(&openings.state(&arch)), told(&alone), "{arch}");
            }
            assert_eq!(shared_by(&openings), 4);
        }
    }

    #[test]
    fn threads_may_ask_at_a_time() {
        let openings = SharedOpenings::new(Balls::DoubleDoubles, 17, true).unwrap();
        let all = || arches().iter().map(|arch| told(&openings.state(arch))).collect::<Vec<_>>();
        let found: Vec<Vec<String>> = thread::scope(|scope| {
            let threads = [(); 3].map(|()| scope.spawn(all));
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        });
        assert!(found.iter().all(|told| *told == found[0] && told.len() == 28));
    }

    #[test]
    fn half_openings_that_do_not_come_again_are_forgotten() {
        let openings = SharedOpenings::new(Balls::DoubleDoubles, 1, false).unwrap();
        let alpha = |place: usize| ExactNumber::from(&rug::Rational::from((1, place + 1)));
        let arch = |place| {
            Arch::new(SelfWeight::Heyman, alpha(place), crate::problem::Friction::Infinite).unwrap()
        };
        (0..MOST).for_each(|place| assert!(openings.opening(&arch(place)).is_none()));
        assert_eq!(openings.seen.lock().unwrap().len(), MOST);
        assert!(openings.opening(&arch(MOST)).is_none());
        assert_eq!(openings.seen.lock().unwrap().len(), 1);
        (0..ALONE).for_each(|_| assert!(openings.opening(&arch(0)).is_none()));
        assert!(openings.opening(&arch(0)).is_some());
        assert_eq!(shared_by(&openings), 1);
    }
}
