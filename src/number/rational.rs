//! `rug::Rational`: exact arithmetic, for identities at rational points.

use super::{ExactField, Field};
use rug::Rational;

impl Field for Rational {
    fn int(&self, n: i32) -> Self {
        Rational::from(n)
    }

    fn square(&self) -> Self {
        Rational::from(self.square_ref())
    }
}

impl ExactField for Rational {
    fn is_zero(&self) -> bool {
        *self == 0
    }
}
