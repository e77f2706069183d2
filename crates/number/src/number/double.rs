//! `f64`: a quick look. Nothing that comes out of it is certified.

use super::{Field, Real};

impl Field for f64 {
    fn int(&self, n: i32) -> Self {
        f64::from(n)
    }
}

impl Real for f64 {
    fn pi(&self) -> Self {
        std::f64::consts::PI
    }

    fn sqrt(&self) -> Self {
        f64::sqrt(*self)
    }

    fn sin_cos(&self) -> (Self, Self) {
        f64::sin_cos(*self)
    }
}
