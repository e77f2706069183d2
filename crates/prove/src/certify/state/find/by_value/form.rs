//! Equations in which a value leaves one or two unknowns, and where the search for these starts.

use crate::arch::{Ring, SelfWeight, thrust};
use crate::certify::state::rotation::JointForm;
use crate::number::{Angle, Ball, Enclosure, Field, Real, Stumpff};
use crate::prover::Undecided;
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::ensure;
use crate::prover::root::Form;
use rug::Float;

/// A candidate: the thickness of (5) by `beta cot(beta) - h`.
pub(super) fn touching_start(weight: SelfWeight, rest: &Float) -> Float {
    let sum = rest.clone() + 1u32;
    match weight {
        SelfWeight::Heyman => rest.clone() * 2u32 / sum,
        SelfWeight::Milankovitch => {
            let root = (sum.clone() * &sum * 9u32 + rest.clone() * 12u32).sqrt();
            rest.clone() * 12u32 / (sum * 3u32 + root)
        }
    }
}

/// (2) and (5) for the joint and the thickness, at a thrust.
pub(super) struct TouchingForm<'a> {
    pub weight: SelfWeight,
    pub thrust: &'a Ball,
    pub joint: JointForm,
}

impl Form<Ball> for TouchingForm<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let (thrust, ring) = (number(self.thrust), Ring::new(self.weight, &x[1]));
        let haunch = self.joint.haunch(x[0].clone());
        let both = thrust::touching(&haunch.versine, &haunch.excess, &ring);
        let tangency = thrust::tangency(&haunch.times_cotangent, &ring);
        [both, tangency].map(|of| of.residual(&thrust)).into()
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&Ball) -> T, x: &[T]) -> bool {
        let (haunch, ring) = (self.joint.haunch(x[0].clone()), Ring::new(self.weight, &x[1]));
        let divisors = [ring.intrados(), x[1].clone()];
        haunch.excess.is_bounded() && divisors.iter().all(|x| x.is_positive().is_proved())
    }
}

/// `A = alpha cot(alpha/2)` for half of the half opening.
struct OpeningForm<'a> {
    opening_variable: &'a Ball,
    half: JointForm,
}

impl Form<Ball> for OpeningForm<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let times_cotangent = self.half.haunch(x[0].clone()).times_cotangent;
        vec![times_cotangent * x[0].int(2) - number(self.opening_variable)]
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&Ball) -> T, x: &[T]) -> bool {
        self.half.haunch(x[0].clone()).times_cotangent.is_bounded()
    }
}

/// The half opening of an opening variable between 0 and 2.
pub(super) fn half_opening_of(a: &Ball, bits: u32) -> Result<Angle<Ball>, Undecided> {
    /// Below this `2 - A` the leading term is used.
    const NARROW: f64 = 1e-3;
    let rest = a.int(2) - a;
    let start = match rest.candidate() {
        // A = 2 - alpha²/6 - ….
        rest if rest < NARROW => (rest * 3u32 / 2u32).sqrt(),
        _ => {
            let (mut low, mut high) = (0.0f64, std::f64::consts::PI);
            let a = a.mid().to_f64();
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let value = thrust::opening_variable(&Angle::new(middle)).value();
                if value > a { low = middle } else { high = middle }
            }
            Float::with_val(bits, 0.5 * low)
        }
    };
    let (half, start) = JointForm::near::<Ball>(start, bits);
    let form = OpeningForm { opening_variable: a, half };
    let (root, sines) = Ball::rooted(&form, bits, &[start])?;
    let half = Ball::angle(&sines, &half.rad(&root[0]));
    let rad = half.rad.clone() * half.rad.int(2);
    let inside = (rad.pi() - &rad).is_positive().is_proved() && rad.is_positive().is_proved();
    ensure(inside, "a half opening between 0 and pi")?;
    let (sin, one) = (half.sin.clone() * half.sin.int(2), rad.int(1));
    Ok(Angle { rad, cos: one - &(sin.clone() * &half.sin), sin: sin * &half.cos })
}
