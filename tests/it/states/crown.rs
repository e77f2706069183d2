//! Beside the line `beta_r = 0`, on which the joint of `[r,s,r]` reaches the crown and `[r,s]` begins.

use super::float_text;
use crate::arches::{H, M, at_landmark};
use crate::hard::{config, weights};
use couplet::arch::{Configuration, SelfWeight, Unknown, sliding};
use couplet::number::{Angle, Dual};
use couplet::problem::{Equation, Landmark, Mode};
use couplet::solve::settle;
use proptest::prelude::*;
use rug::Float;
use rug::ops::Pow;

/// The half opening and the friction at which the line has a thrust, by the printed equations.
fn line(weight: SelfWeight, h: &Float) -> [Float; 2] {
    let like = Float::new(h.prec());
    let at = Configuration::zero(&like).with(Unknown::Thrust, h.clone());
    let start = [2.6, 0.95].map(|x| Float::with_val(h.prec(), x)).to_vec();
    let root = settle(start, |x| {
        let mut at = at.clone().map(Dual::constant);
        at.half_opening = Angle::new(x[0].clone()).variable(0);
        at.thickness = Dual::variable(x[1].clone(), 1);
        [Equation::UpperThrust, Equation::TangencyAtCrown].map(|e| e.residual(weight, &at)).into()
    });
    let steepest = Float::with_val(h.prec(), h * (1 - h.clone())).sqrt();
    [root.unwrap()[0].clone(), sliding::inner(&Angle::new(steepest), h).value()]
}

/// Proved to so many digits on the side of the line that `factor` is on.
fn proved_beside(weight: SelfWeight, h: &Float, exponent: u32, above: bool, digits: usize) {
    let [alpha, mu] = line(weight, h);
    let hair = Float::with_val(alpha.prec(), 10).pow(-i64::from(exponent));
    let factor = if above { 1 + hair } else { 1 - hair };
    let text = |x: &Float| float_text(x, exponent as usize + 30);
    let (alpha, mu) = (text(&(alpha * factor)), text(&mu));
    let modes: &[Mode] = match above {
        true => &[Mode::OverturningSliding],
        false => &[Mode::RotationalSlidingRotational, Mode::RotationalSliding],
    };
    let mode = super::digits(weight, &alpha, &mu, digits).mode;
    assert!(modes.contains(&mode), "{weight:?} {alpha} {mu}: {mode:?}");
}

fn largest_thrust(weight: SelfWeight) -> Float {
    at_landmark(Landmark::Junction, weight, Unknown::Thrust, 400).mid().clone()
}

proptest! {
    #![proptest_config(config(200))]

    /// Within the rounding of a double and far below it, at any number of digits.
    #[test]
    fn beside_the_line_every_arch_is_proved(
        weight in weights(), part in 0.01..0.98f64, exponent in 15u32..23, above in any::<bool>(),
        digits in 8usize..51,
    ) {
        let h = largest_thrust(weight) * part;
        proved_beside(weight, &h, exponent, above, digits);
    }
}

/// Towards `l`, where the thrust is as small as one likes, and at any distance.
#[test]
fn beside_the_line_towards_the_end_of_rotation() {
    for weight in [H, M] {
        for (power, exponent) in [(3, 20), (8, 9), (8, 30), (30, 31), (60, 62), (150, 200)] {
            let h = Float::with_val(2000, 10).pow(-power);
            for above in [false, true] {
                for digits in [8, 20, 30] {
                    proved_beside(weight, &h, exponent, above, digits);
                }
            }
        }
    }
}

/// Arches that were undecided at some numbers of digits and proved at others.
#[test]
fn the_number_of_digits_decides_nothing() {
    for (weight, alpha, mu) in [
        (H, "2.604264540182122", "1.8"),
        (M, "2.584477032082509", "5"),
        (M, "2.5603425197286378", "2.2"),
        (H, "2.6384651938221940086", "4"),
        (H, "2.604264540182121955", "1.8"),
    ] {
        for digits in [8, 15, 17, 20, 29, 30, 31, 40, 50] {
            super::digits(weight, alpha, mu, digits);
        }
    }
}

/// Next to `l` with a friction that makes the inner joint slide there.
#[test]
fn beside_the_end_of_rotation_a_large_friction_slides() {
    for weight in [H, M] {
        let end = at_landmark(Landmark::RotationEnd, weight, Unknown::HalfOpening, 6000);
        for (exponent, mu) in [(300, "1e150"), (500, "1e400"), (800, "1e400")] {
            let hair = Float::with_val(6000, 10).pow(-exponent);
            let alpha = float_text(&(end.mid().clone() - hair), 1500);
            super::digits(weight, &alpha, mu, 20);
        }
    }
}
