//! Balls of doubles: a [`FloatBall`] of 53 bits.

use super::FloatBall;

/// All real numbers within a radius of a double.
pub type DoubleBall = FloatBall<f64>;

impl DoubleBall {
    /// A double not above any number of the ball; `-inf` for the whole line.
    pub fn lower(&self) -> f64 {
        (self.mid - self.rad).next_down()
    }

    /// A double not below any number of the ball; `+inf` for the whole line.
    pub fn upper(&self) -> f64 {
        (self.mid + self.rad).next_up()
    }
}

/// The set of a ball of MPFR, but for roundings: outward.
#[cfg(feature = "mpfr")]
impl From<&super::Ball> for DoubleBall {
    fn from(ball: &super::Ball) -> Self {
        use rug::float::Round;
        let (low, high) =
            (ball.lower().to_f64_round(Round::Down), ball.upper().to_f64_round(Round::Up));
        let mid = ball.mid().to_f64();
        let rad = (high - mid).max(mid - low);
        Self::new(mid, if rad > 0.0 { rad.next_up() } else { rad })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Enclosure, Real, Ternary};

    #[test]
    fn signs_are_decided_only_when_they_are_known() {
        let sign = |mid, rad| DoubleBall::new(mid, rad).is_positive();
        assert_eq!([sign(1.0, 0.5), sign(-1.0, 1.0)], [Ternary::True, Ternary::False]);
        assert_eq!([sign(1.0, 1.0), sign(0.0, 0.0)], [Ternary::Undecided, Ternary::False]);
        assert_eq!(DoubleBall::WHOLE.is_positive(), Ternary::Undecided);
        let (inner, outer) = (DoubleBall::new(1.0, 0.25), DoubleBall::new(1.0, 0.5));
        assert!(
            inner.lies_inside(&outer) && !outer.lies_inside(&inner) && !inner.lies_inside(&inner)
        );
        assert!(
            inner.lies_inside(&DoubleBall::WHOLE)
                && !DoubleBall::WHOLE.lies_inside(&DoubleBall::WHOLE)
        );
        assert!(!inner.overlaps(&DoubleBall::new(2.0, 0.5)) && inner.overlaps(&DoubleBall::WHOLE));
    }

    #[test]
    fn roots_next_to_the_end_of_the_domain() {
        assert!(!DoubleBall::exact(-1.0).sqrt().is_bounded());
        assert!(!DoubleBall::new(1.0, 1.0f64.next_up()).sqrt().is_bounded());
        let half = DoubleBall::new(1.0, 1.0).sqrt();
        assert!(half.lower() <= 0.0 && half.upper() >= 2f64.sqrt());
        assert_eq!(DoubleBall::exact(0.0).sqrt().rad(), 0.0);
    }
}
