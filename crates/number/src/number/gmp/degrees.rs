//! Radians as degrees.

use super::sine::known_pi;
use super::{Ball, Real};
use std::sync::{PoisonError, RwLock};

/// Bits of `180/pi` beyond those of an angle.
const GUARD: u32 = 8;

/// An angle of so many radians in degrees: a product with `180/pi`, which is kept from one use to the next.
pub fn degrees(radians: &Ball) -> Ball {
    static KNOWN: RwLock<Option<Ball>> = RwLock::new(None);
    let prec = radians.prec() + GUARD;
    let known = KNOWN.read().unwrap_or_else(PoisonError::into_inner).clone();
    let factor = known.filter(|factor| factor.prec() >= prec).unwrap_or_else(|| {
        let like = Ball::integer(180, prec);
        // Where angles are known to as many digits, pi mostly is.
        let pi = known_pi(prec).unwrap_or_else(|| like.pi());
        let factor = like / pi;
        let mut known = KNOWN.write().unwrap_or_else(PoisonError::into_inner);
        if known.as_ref().is_none_or(|known| known.prec() < prec) {
            *known = Some(factor.clone());
        }
        factor
    });
    (radians.clone() * factor.with_precision(prec)).with_precision(radians.prec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Enclosure, Magnitude};

    #[test]
    fn products_and_quotients_overlap() {
        for prec in [64, 3000, 200, 4000] {
            let angle = Ball::integer(5, prec) / Ball::integer(7, prec);
            let quotient = Ball::integer(180, prec) * &angle / angle.pi();
            let ours = degrees(&angle);
            assert!(ours.overlaps(&quotient) && ours.prec() == prec);
            assert!(ours.rad() < Magnitude::power_of_two(8 - i64::from(prec)));
        }
    }
}
