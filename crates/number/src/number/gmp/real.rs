//! Real functions of balls: by MPFR, and sines of all digits by anchors, which are made of balls.

use super::{Ball, Real, SineAnchor};

impl Real for Ball {
    fn pi(&self) -> Self {
        self.pi_by_mpfr()
    }

    fn sqrt(&self) -> Self {
        self.sqrt_by_mpfr()
    }

    fn sin_cos(&self) -> (Self, Self) {
        SineAnchor::sin_cos(self).unwrap_or_else(|| self.sin_cos_by_mpfr())
    }
}
