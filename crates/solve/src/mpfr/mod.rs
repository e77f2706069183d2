//! Candidates to any number of bits: what needs MPFR.

pub mod expansion;
mod root;
pub mod voussoir_thrust;
pub mod voussoirs;

pub use root::{Candidate, newton};

use super::linear::Approximate;
use super::start::Start;
use crate::number::Dyadic;
use rug::Float;

impl Approximate for Float {
    fn exponent(&self) -> i64 {
        self.get_exp().map_or(i64::MIN, i64::from)
    }

    fn bits(&self) -> u32 {
        self.prec()
    }
}

impl Start for Float {
    const KEPT: u32 = 32;

    fn exact(&self) -> Dyadic {
        Dyadic::from(self)
    }

    fn to_double(&self) -> f64 {
        self.to_f64()
    }

    fn cut(self, bits: u32) -> Self {
        Self::with_val(bits, self)
    }

    fn like(&self, x: f64) -> Self {
        Self::with_val(self.prec(), x)
    }

    fn exponent_of_size(&self) -> Option<i64> {
        self.get_exp().map(i64::from)
    }

    fn shifted(self, power: i64) -> Self {
        self << i32::try_from(power).unwrap_or(i32::MIN)
    }

    fn cube_root(self) -> Self {
        self.cbrt()
    }

    fn arctangent(self) -> Self {
        self.atan()
    }
}
