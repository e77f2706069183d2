//! The least thickness of an arch of voussoirs, proved.
//!
//! Three conditions hold with equality; their multipliers leave a polynomial `W` in the thickness
//! ([`combination`](crate::arch::joint::combination)). The proof, in balls:
//!
//! 1. **None thinner stands.** The multipliers are positive from 0 to the thickness, and so is `W` below it: by the
//!    coefficients of Bernstein's form, which bound a polynomial on an interval. Any admissible thrust and moment
//!    would make the combination zero or negative.
//! 2. **One thickness.** `W` changes its sign between two numbers next to each other: there is the root, and the
//!    thrust and the moment follow.
//! 3. **Admissible at every joint**, by signs at a few, so that the cost does not depend on the number of stones.
//!
//! **Thicker arches stand.** At the thrust of the state let `n = N(alpha)/(cos beta_0 - cos alpha)`. That the
//! moments have room between the extrados of the shoulder and the intrados of the first joint says `(1 + eta/2) n -
//! 1 - delta_M eta²/12 >= 0`, as `N >= 0` there. For Heyman's weight the left side grows. For Milankovitch's it is
//! concave and, if `n < 2/3`, at most its value `(3n² + 4n - 4)/4 < 0` at `eta = 3n`; so `n >= 2/3`, and it is not
//! negative at 2 either, for joints below the first still less. The room below the shoulder's extrados is concave
//! in `eta` at every joint, that below the first joint's grows, and friction does not see the thickness: so there
//! is room from the least thickness up to 2.
//!
//! With unlimited friction the value is that to which those of large frictions come: a keystone may hang between joints
//! that bear shear alone.
//!
//! | file | what it does |
//! |---|---|
//! | `joints` | the joints in balls, and the conditions there |
//! | `polynomial` | signs and roots of polynomials in the thickness |
//! | `admissible` | step 3 |
//! | `thickness` | the least thickness |
//! | `thrusts` | the range of thrusts at a given thickness |
//! | `friction` | the friction that this asks for |
//! | `assess` | an arch of a given thickness |
//! | `measured` | its sizes in metres and kilonewtons |
//! | `loss` | what an arch needs less than one with a joint at every angle |
//!
//! The search is in [`solve`](crate::solve::voussoirs), and nothing here rests on it.

mod admissible;
mod assess;
mod friction;
mod joints;
mod loss;
mod measured;
mod polynomial;
mod thickness;
mod thrusts;

pub use assess::VoussoirAssessment;
pub use loss::{VoussoirLoss, voussoir_loss};
pub use measured::measured_voussoirs;
pub use thickness::{VoussoirDigits, Voussoirs};
pub use thrusts::{VoussoirLimit, VoussoirStanding};

use crate::arch::SelfWeight;
use crate::number::{ExactNumber, bits_of};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Friction};
use crate::prover::{Error, Refused, raise};
use joints::{StoneAngles, StoneJoints};
use thickness::least;

/// Bits beyond those of the digits.
const GUARD: u32 = 64;

/// The least thickness of an arch of voussoirs with this self-weight and friction, to `digits` significant digits.
pub fn voussoirs(
    stones: &Stones,
    weight: SelfWeight,
    friction: &Friction,
    digits: usize,
) -> Result<Voussoirs, Error> {
    let arch = checked(stones, weight, friction, digits)?;
    let angles = StoneAngles::new(stones);
    Ok(raise(bits_of(digits) + GUARD, |bits| {
        let joints = StoneJoints::new(&angles, weight, arch.friction(), bits);
        Ok(least(&joints)?.rounded(&joints, digits))
    })?)
}

/// Proves what holds for an arch of voussoirs with a thickness in `(0, 2]`, to `digits` significant digits.
pub fn assess_voussoirs(
    stones: &Stones,
    weight: SelfWeight,
    friction: &Friction,
    thickness: &ExactNumber,
    digits: usize,
) -> Result<VoussoirAssessment, Refused> {
    let arch = checked(stones, weight, friction, digits)?;
    Refused::thickness(thickness)?;
    Ok(assess::assessed(stones, &arch, thickness, (bits_of(digits) + GUARD, digits)))
}

/// A certificate from elsewhere may not have been made by those who check it.
fn checked(
    stones: &Stones,
    weight: SelfWeight,
    friction: &Friction,
    digits: usize,
) -> Result<Arch, Refused> {
    Refused::digits(digits)?;
    stones.check()?;
    Ok(Arch::new(weight, stones.half_opening().clone(), friction.clone())?)
}
