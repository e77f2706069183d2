//! The closed forms (9)–(11) of the purely rotational state.
//!
//! Each is Cardano's formula for one of the cubics (7), for Milankovitch's self-weight:
//!
//! ```text
//! x = scale (shift + (1 ± k)/2 P/u + 2/(1 ± k) u)        u³ = X + c q
//! ```
//!
//! with `q` = `SQRT` of (12), so that `q²` is the [radicand](super::cubic::radicand), and `k = i√3`.
//! They are written over any field in which such `q`, `u`, `k` exist: formulas modulo these relations,
//! or complex numbers. Where the paper has `±` a function takes `k` and stands for the upper sign, with
//! `-k` for the lower; the same `k` in all three gives one state.
//!
//! In (9) the cube root of 2 is printed besides. As `2^(2/3) v = 2 (v / 2^(1/3))`, it is gone if `u` is
//! the cube root of **half** the bracket, and the formula has the shape of the other two.

use super::cubic::Abbreviations;
use crate::number::Field;

/// Cardano's three roots, of which two are meaningful, up to scale and shift.
fn two_terms<T: Field>(product: &T, u: &T, k: &T) -> T {
    let turn = k.int(1) + k;
    turn.clone() / k.int(2) * product / u + k.int(2) / turn * u
}

/// Eq. (9), `A_M`; `u` is a cube root of [`opening_cube`].
pub fn opening_variable<T: Field>(at: &Abbreviations<T>, u: &T, k: &T) -> T {
    opening_variable_from(at, two_terms(&opening_product(at), u, k))
}

/// Eq. (9) from the sum of its two terms.
pub fn opening_variable_from<T: Field>(at: &Abbreviations<T>, terms: T) -> T {
    let Abbreviations { sin, f, g } = at;
    let scale = g.clone() / (sin.clone() * opening_root_factor(at));
    scale * (f.clone() - g + terms)
}

/// `P` of (9): `(f + g)² - f (g + 2S)`.
pub fn opening_product<T: Field>(at: &Abbreviations<T>) -> T {
    let Abbreviations { sin, f, g } = at;
    (f.clone() + g).square() - (g.clone() + sin.int(2) * sin) * f
}

/// `2c` of (9): `3g - 2S`, the factor of the square root in the bracket.
pub fn opening_root_factor<T: Field>(at: &Abbreviations<T>) -> T {
    at.g.int(3) * &at.g - at.sin.int(2) * &at.sin
}

/// `u³` of (9), **half** of
/// `(g - f)(2(f + g)² + f(g - 6S)) + 2S(3g - 2S)² + (3g - 2S) SQRT`.
pub fn opening_cube<T: Field>(at: &Abbreviations<T>, q: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let inner = f.int(2) * (f.clone() + g).square() + (g.clone() - sin.int(6) * sin) * f;
    let factor = opening_root_factor(at);
    let bracket = (g.clone() - f) * inner + sin.int(2) * sin * factor.square() + factor * q;
    bracket / f.int(2)
}

/// Eq. (10), `eta_M`; `u` is a cube root of [`thickness_cube`]. The signs are printed the other way
/// round, `∓`.
pub fn thickness<T: Field>(at: &Abbreviations<T>, u: &T, k: &T) -> T {
    thickness_from(at, two_terms(&thickness_product(at), u, &-k.clone()))
}

/// Eq. (10) from the sum of its two terms.
pub fn thickness_from<T: Field>(at: &Abbreviations<T>, terms: T) -> T {
    let Abbreviations { sin, f, g } = at;
    let shift = f.clone() + g;
    (terms - shift) / sin
}

/// `P` of (10): `(f + g)² + 4S (g - S)`.
pub fn thickness_product<T: Field>(at: &Abbreviations<T>) -> T {
    let Abbreviations { sin, f, g } = at;
    (f.clone() + g).square() + sin.int(4) * sin * (g.clone() - sin)
}

/// `u³` of (10): `(f + g)³ + 6gS (f + g) - 12fS² + 2S SQRT`.
pub fn thickness_cube<T: Field>(at: &Abbreviations<T>, q: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let sum = f.clone() + g;
    let middle = g.int(6) * g * sin * &sum;
    sum.square() * &sum + middle - f.int(12) * f * sin.square() + sin.int(2) * sin * q
}

/// Eq. (11), `h_M`; `u` is a cube root of [`thrust_cube`].
pub fn thrust<T: Field>(at: &Abbreviations<T>, u: &T, k: &T) -> T {
    thrust_from(at, two_terms(&thrust_product(at), u, k))
}

/// Eq. (11) from the sum of its two terms.
pub fn thrust_from<T: Field>(at: &Abbreviations<T>, terms: T) -> T {
    let Abbreviations { sin, f, g } = at;
    let shift = f.int(3) * f - g - sin.int(2) * sin;
    (shift + terms) / (sin.int(6) * sin)
}

/// `P` of (11): `3f² + g² - 4S (2g - S)`.
pub fn thrust_product<T: Field>(at: &Abbreviations<T>) -> T {
    let Abbreviations { sin, f, g } = at;
    f.int(3) * f.square() + g.square() - sin.int(4) * sin * (g.int(2) * g - sin)
}

/// `u³` of (11): `-g (9f² - g²) - 2S (9f (g - f) - 12g (g - S) - 4S²) + 3 (g - f) SQRT`.
pub fn thrust_cube<T: Field>(at: &Abbreviations<T>, q: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let first = (f.int(9) * f.square() - g.square()) * g;
    let second = f.int(9) * f * (g.clone() - f)
        - g.int(12) * g * (g.clone() - sin)
        - sin.int(4) * sin.square();
    f.int(3) * (g.clone() - f) * q - first - sin.int(2) * sin * second
}
