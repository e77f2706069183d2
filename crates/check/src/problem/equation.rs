//! The equations by their numbers in the paper, and the two forms in which they are used; those of an asymmetric
//! state, which have none, by what they say.

use crate::arch::asymmetric::Asymmetric;
use crate::arch::small::{self, Scaled};
use crate::arch::{Configuration, Quotient, Ring, SelfWeight, sliding, thrust};
use crate::number::{Dual, Field, worded};

worded! {
    /// An equation of a system, named by its number in the paper.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Equation {
        /// (2).
        LowerThrust = "(2)",
        /// (3).
        UpperThrust = "(3)",
        /// (4).
        WholeThrust = "(4)",
        /// (5).
        Tangency = "(5)",
        /// (5) in the limit `beta_r -> 0`, where `beta cot(beta) = 1`.
        TangencyAtCrown = "(5) at beta_r -> 0",
        /// `d/d eta` of (2) = (5), cleared of denominators: with (2) and (5) themselves it says that
        /// the thickness is a double root of the cubic (7), so that the radicand (12) is zero. The
        /// radicand itself would make the Jacobian singular there; this keeps the root simple.
        DoubleThickness = "d/d eta of (2) = (5)",
        /// (17).
        ShoulderSliding = "(17)",
        /// (18), at the joint given by [`Equation::Steepest`].
        InnerSliding = "(18)",
        /// `beta_s² = h (1 - h)`, the other half of (18).
        Steepest = "beta_s^2 = h (1 - h)",
        /// The line of thrust meets the extrados at the hinge next to the crown. Like what follows of an
        /// [asymmetric state](crate::arch::asymmetric).
        CrownHinge = "E(b0) = 0",
        /// The line of thrust touches the extrados there.
        CrownTangency = "E'(b0) = 0",
        /// The line of thrust meets the intrados at the left haunch.
        HaunchHinge = "I(-b1) = 0",
        /// The line of thrust touches the intrados there.
        HaunchTangency = "I'(-b1) = 0",
        /// The right shoulder is at its limit of friction.
        ShoulderSlides = "O(alpha) = 0",
        /// An inner joint of the left half is at its limit of friction.
        InnerSlides = "O(-b2) = 0",
        /// The inner joint is where friction is nearest to its limit.
        InnerSteepest = "O'(-b2) = 0",
        /// The line of thrust meets the extrados at the right shoulder.
        ShoulderOpens = "E(alpha) = 0",
        /// The two hinges and the shoulder alone fit.
        Fits = "(2 - eta) cos(b1 + alpha) = (2 + eta) cos(alpha - b0)",
    }
    /// All equations, in the order of the paper; then those of asymmetric states.
    pub const ALL;
    /// The number in the paper, and what is special about it.
    pub fn label -> &'static str;
}

impl Equation {
    /// Tells whether the equation is one of the paper's, of half an arch.
    pub fn is_symmetric(self) -> bool {
        self as usize <= Self::Steepest as usize
    }

    /// The equation as a quotient and what it is equal to; `cotangent` is `beta cot(beta)` at the rotational joint.
    fn quotient<T: Field>(
        self,
        weight: SelfWeight,
        at: &Configuration<T>,
        cotangent: impl FnOnce() -> T,
    ) -> Option<(Quotient<T>, &T)> {
        let ring = || Ring::new(weight, &at.thickness);
        let thrust = match self {
            Self::LowerThrust => thrust::lower(&at.rotation_joint, &ring()),
            Self::UpperThrust => thrust::upper(&at.half_opening, &at.rotation_joint, &ring()),
            Self::WholeThrust => thrust::whole(&at.half_opening, &ring()),
            Self::Tangency => thrust::tangency(&cotangent(), &ring()),
            Self::TangencyAtCrown => thrust::tangency(&at.thrust.int(1), &ring()),
            Self::ShoulderSliding => {
                return Some((sliding::shoulder(&at.half_opening, &at.thrust), &at.friction));
            }
            Self::InnerSliding => {
                return Some((sliding::inner(&at.sliding_joint, &at.thrust), &at.friction));
            }
            _ => return None,
        };
        Some((thrust, &at.thrust))
    }

    /// The equation with its denominator cleared: zero where it holds.
    pub fn residual<T: Field>(self, weight: SelfWeight, at: &Configuration<T>) -> T {
        let cotangent = || at.rotation_joint.times_cotangent();
        match self {
            Self::DoubleThickness => {
                let eta = Dual::variable(at.thickness.clone(), 0);
                let joint = at.rotation_joint.clone().map(Dual::constant);
                let ring = Ring::new(weight, &eta);
                let tangency = thrust::tangency(&joint.times_cotangent(), &ring);
                thrust::lower(&joint, &ring).difference(&tangency).derivative(0)
            }
            Self::Steepest => sliding::steepest(&at.sliding_joint.rad, &at.thrust),
            _ => match self.quotient(weight, at, cotangent) {
                Some((quotient, value)) => quotient.residual(value),
                None => self.asymmetric(&at.into(), &Ring::new(weight, &at.thickness)),
            },
        }
    }

    /// The residual of an equation of an asymmetric state: a margin or its slope along the arch, which are zero.
    fn asymmetric<T: Field>(self, at: &Asymmetric<T>, ring: &Ring<T>) -> T {
        let [value, slope] = match self {
            Self::CrownHinge | Self::CrownTangency => at.crown(ring),
            Self::HaunchHinge | Self::HaunchTangency => at.haunch(ring),
            Self::InnerSlides | Self::InnerSteepest => at.inner_slides(ring),
            Self::ShoulderSlides => return at.shoulder_slides(ring),
            Self::ShoulderOpens => return at.shoulder_opens(ring),
            _ => return at.misfit(ring),
        };
        match self {
            Self::CrownTangency | Self::HaunchTangency | Self::InnerSteepest => slope,
            _ => value,
        }
    }

    /// The denominator that [`Equation::residual`] has cleared, if any: where it is not zero, the
    /// residual is zero exactly where the printed equation holds.
    pub fn denominator<T: Field>(self, weight: SelfWeight, at: &Configuration<T>) -> Option<T> {
        // That of (5) is the same at every joint.
        let found = self.quotient(weight, at, || at.thrust.int(1));
        found.map(|(quotient, _)| quotient.denominator)
    }

    /// The equation in scaled variables, cleared of denominators that are positive for small half
    /// openings: zero where it holds. `None` for one that no state of a small half opening needs.
    pub fn scaled_residual<T: Field>(self, weight: SelfWeight, at: &Scaled<T>) -> Option<T> {
        Some(match self {
            Self::LowerThrust => small::lower(weight, at),
            Self::WholeThrust => small::whole(weight, at),
            Self::Tangency => small::tangency(weight, at),
            Self::ShoulderSliding => small::shoulder(at).residual(&at.friction),
            Self::InnerSliding => small::inner(at).residual(&at.friction),
            Self::Steepest => small::steepest(at),
            _ => return None,
        })
    }
}
