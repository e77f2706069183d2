//! Assemblies of stones near a threshold.

use crate::strategies::assemblies::pair;
use crate::strategies::assembly::Assembly;
use crate::strategies::margin::Margin;
use crate::strategies::sample::Draw;
use proptest::prelude::*;

/// Places after which everything was drawn once.
const PLACES: u64 = 64;

/// Assemblies of 2 to 60 stones, 0.1 % above their threshold or below it, with the proved verdict and its proof: an
/// oracle for programs that tell whether stones stand. A failure shrinks to no simpler one.
///
/// ```
/// use couplet_judge::strategies::assembly;
/// use proptest::test_runner::{Config, TestRunner};
///
/// let mut runner = TestRunner::new(Config::with_cases(4));
/// let verdict = runner.run(&assembly(), |drawn| {
///     // A program of one's own would be asked about `Blocks::of(&drawn)` and `drawn.friction` here.
///     assert_eq!(drawn.stands(), drawn.safety.double > 1.0);
///     Ok(())
/// });
/// assert!(verdict.is_ok());
/// ```
pub fn assembly() -> impl Strategy<Value = Assembly> {
    let drawn = (any::<u64>(), 0..PLACES, any::<bool>()).no_shrink();
    drawn.prop_map(|(seed, place, is_above)| {
        let [above, below] = pair(&mut Draw(seed), place, Margin::default());
        if is_above { above } else { below }
    })
}
