//! Balls without a branch: a midpoint of one or two doubles, and a radius that is a double.
//!
//! **What is not a number is the whole line.** Where both parts of a ball are finite, the true value lies within the
//! radius of the midpoint; where one is not, nothing is known. Each operation on such a ball gives such a ball: its
//! radius is a sum and product of sizes in which the operands occur, and a comparison with it is false. So there is
//! nothing to decide on the way, and many balls go through one text at a time.
//!
//! With `u = 2^-53` each operation rounds its midpoint `m`, whose leading double is `hi`, with an error of at most
//! [`UNIT`](Midpoint::UNIT)` |hi|` where nothing underflows (`number/float_ball.rs` and `double_double.rs` have the
//! proofs), and adds that to a radius computed from the radii of the operands. The formula of a radius has positive
//! terms only and at most ten roundings on any path, each of which takes away less than a part `u`; [`UP`] `= 1 + 16
//! u`, and `(1 - u)^11 (1 + 16 u) > 1`. What has to be bounded from below is multiplied by [`DOWN`] in the same way.
//! `|m| <= (1 + u) |hi|` counts as a rounding.
//!
//! **Underflow.** A sum of doubles does not underflow. In a product of midpoints, and in that of a quotient with its
//! divisor, each of at most six operations errs by less than `2^-1072` for it, the error of a product among them; so
//! the result errs by less than `2^-1069`, and that of a quotient, whose divisor is above [`LEAST_DIVISOR`] `= 2^-60`,
//! by less than `2^-1000`, as does a term of the radius. [`TINY`] `= 2^-990` has room for them. **Overflow** gives what
//! is not a finite number, and never a finite one again: in a midpoint it makes the radius infinite, and a divisor that
//! is infinite has an infinite radius. So the radius alone tells whether anything is known.

use crate::number::{DoubleDoubleBy, Field, Product, operators, power_of_two};

/// The midpoint of a [`LaneBall`]: a number that is led by a double.
pub(super) trait Midpoint: Field + Copy {
    /// Above the error of every operation, as a part of the leading double of the result.
    const UNIT: f64;

    /// The double `x`.
    fn exact(x: f64) -> Self;

    /// The leading double, the nearest to the number.
    fn hi(self) -> f64;

    /// Rest that the leading double leaves.
    fn lo(self) -> f64;

    /// The square root of a positive number.
    fn root(self) -> Self;
}

/// Half the distance from one to the next double.
const U: f64 = power_of_two(-53);
/// Rounds a radius up.
const UP: f64 = 1.0 + 16.0 * U;
/// Rounds a lower bound down.
const DOWN: f64 = 1.0 - 16.0 * U;
/// Above what underflow takes away.
const TINY: f64 = power_of_two(-990);
/// The least divisor that divides.
const LEAST_DIVISOR: f64 = power_of_two(-60);

impl Midpoint for f64 {
    const UNIT: f64 = U;

    #[inline(always)]
    fn exact(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn hi(self) -> f64 {
        self
    }

    #[inline(always)]
    fn lo(self) -> f64 {
        0.0
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl<P: Product> Midpoint for DoubleDoubleBy<P> {
    const UNIT: f64 = Self::UNIT;

    #[inline(always)]
    fn exact(x: f64) -> Self {
        Self::exact(x)
    }

    #[inline(always)]
    fn hi(self) -> f64 {
        self.hi()
    }

    #[inline(always)]
    fn lo(self) -> f64 {
        self.lo()
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// All real numbers within a radius of a midpoint; the whole line where either is not finite.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaneBall<M> {
    mid: M,
    rad: f64,
}

impl<M: Midpoint> LaneBall<M> {
    /// All numbers within `rad >= 0` of `mid`.
    #[inline(always)]
    pub(super) fn new(mid: M, rad: f64) -> Self {
        Self { mid, rad }
    }

    /// The number `x`; the whole line if it is none.
    #[inline(always)]
    pub(super) fn exact(x: f64) -> Self {
        Self::new(M::exact(x), if x.is_finite() { 0.0 } else { f64::NAN })
    }

    /// The midpoint.
    #[inline(always)]
    pub(super) fn mid(&self) -> M {
        self.mid
    }

    /// The radius.
    #[inline(always)]
    pub(super) fn rad(&self) -> f64 {
        self.rad
    }

    /// The result of an operation on midpoints, with what its radius is but for the error of that.
    #[inline(always)]
    fn rounded(mid: M, rad: f64) -> Self {
        Self::new(mid, (rad + (M::UNIT * mid.hi().abs() + TINY)) * UP)
    }

    /// A bound of the size of all its numbers.
    #[inline(always)]
    pub(super) fn size(&self) -> f64 {
        (self.mid.hi().abs() + self.rad) * UP
    }

    /// The ball with a radius that is larger by `by >= 0`.
    #[inline(always)]
    pub(super) fn widened(self, by: f64) -> Self {
        Self::new(self.mid, (self.rad + by) * UP)
    }

    /// Tells whether all its numbers are positive: `true` is a proof.
    #[inline(always)]
    pub(super) fn is_positive(&self) -> bool {
        self.mid.hi() * DOWN > self.rad
    }

    /// The ball around the leading double of the midpoint.
    #[inline(always)]
    pub(super) fn in_doubles(&self) -> LaneBall<f64> {
        LaneBall::new(self.mid.hi(), (self.rad + self.mid.lo().abs()) * UP)
    }

    /// The square root; the whole line unless every number of the ball is positive.
    ///
    /// Radius: `|√x - √m| = |x - m| / (√x + √m)` is at most `r / (√(m-r) + √m)`.
    #[inline(always)]
    pub(super) fn sqrt(&self) -> Self {
        let (low, root) = ((self.mid.hi() * DOWN - self.rad) * DOWN, self.mid.root());
        let rad = self.rad / ((low.sqrt() + root.hi()) * DOWN);
        Self::rounded(root, if low > LEAST_DIVISOR { rad } else { f64::NAN })
    }
}

impl LaneBall<f64> {
    /// The ball in numbers of two doubles.
    #[inline(always)]
    pub(super) fn in_double_doubles<P: Product>(&self) -> LaneBall<DoubleDoubleBy<P>> {
        LaneBall::new(DoubleDoubleBy::exact(self.mid), self.rad)
    }
}

impl<M: Midpoint> Field for LaneBall<M> {
    #[inline(always)]
    fn int(&self, n: i32) -> Self {
        Self::exact(f64::from(n))
    }
}

impl<M: Midpoint> LaneBall<M> {
    #[inline(always)]
    fn negated(self) -> Self {
        Self::new(-self.mid, self.rad)
    }

    #[inline(always)]
    fn plus(self, other: &Self) -> Self {
        Self::rounded(self.mid + other.mid, self.rad + other.rad)
    }

    #[inline(always)]
    fn minus(self, other: &Self) -> Self {
        Self::rounded(self.mid - other.mid, self.rad + other.rad)
    }

    /// Product of balls: for `|x - a| <= r` and `|y - b| <= s`, `|xy - ab| <= |a| s + (|b| + s) r`.
    #[inline(always)]
    fn times(self, other: &Self) -> Self {
        let (a, b) = (self.mid.hi().abs(), other.mid.hi().abs());
        Self::rounded(self.mid * other.mid, a * other.rad + (b + other.rad) * self.rad)
    }

    /// Quotient of balls: for `|x - a| <= r` and `|y - b| <= s`, `|x/y - a/b| <= (r + |a/b| s) / (|b| - s)`; the whole
    /// line where a divisor may be small.
    #[inline(always)]
    fn over(self, other: &Self) -> Self {
        let least = other.mid.hi().abs() * DOWN - other.rad * UP;
        let quotient = self.mid / other.mid;
        let rad = (self.rad + quotient.hi().abs() * other.rad) / (least * DOWN);
        Self::rounded(quotient, if least > LEAST_DIVISOR { rad } else { f64::NAN })
    }
}

operators!([M: Midpoint] LaneBall<M>);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use crate::number::{Dekker, DoubleDouble, Fused};
    use proptest::prelude::*;
    use rug::{Float, Rational};

    type Long = LaneBall<DoubleDouble>;

    /// Mantissas that carry and tie, exponents as far as products underflow, low parts and radii of every size.
    fn hard() -> impl Strategy<Value = Long> {
        let mantissa = || {
            prop_oneof![Just(0u64), Just(1), Just((1 << 52) - 1), any::<u64>()]
                .prop_map(|m| f64::from_bits(1023 << 52 | m & ((1 << 52) - 1)))
        };
        let exponent = prop_oneof![-3i32..3, -40i32..40, -500i32..400];
        let radius = prop_oneof![Just(f64::INFINITY), (-1i32..120).prop_map(f64::from)];
        let signs = (any::<bool>(), -1i32..=1);
        (mantissa(), exponent, mantissa(), 0i32..70, radius, signs).prop_map(
            |(high, exponent, low, below, radius, (minus, sign))| {
                let power = |e: i32| 2f64.powi(e);
                let hi = if minus { -high } else { high } * power(exponent);
                let lo = f64::from(sign) * low * power(exponent - 54 - below);
                LaneBall::new(DoubleDouble::sum(hi, lo), high * power(exponent) * (-radius).exp2())
            },
        )
    }

    fn exact(x: f64) -> Rational {
        Rational::from_f64(x).unwrap()
    }

    fn middle<M: Midpoint>(x: &LaneBall<M>) -> Rational {
        exact(x.mid.hi()) + exact(x.mid.lo())
    }

    /// The middle of a ball and its ends.
    fn points<M: Midpoint>(x: &LaneBall<M>) -> [Rational; 3] {
        [-1, 0, 1].map(|by| middle(x) + exact(x.rad) * Rational::from(by))
    }

    fn is_known<M: Midpoint>(x: &LaneBall<M>) -> bool {
        x.mid.hi().is_finite() && x.mid.lo().is_finite() && x.rad.is_finite()
    }

    fn holds<M: Midpoint>(x: &LaneBall<M>, number: &Rational) -> bool {
        !is_known(x) || (middle(x) - number).abs() <= exact(x.rad)
    }

    /// Number of operations that tell nothing; the others hold what they do to middles and ends.
    fn all_hold<M: Midpoint>(a: LaneBall<M>, b: LaneBall<M>) -> Result<usize, TestCaseError> {
        let [sum, difference, product, quotient] = [a + b, a - b, a * b, a / b];
        for x in points(&a) {
            prop_assert!(holds(&-a, &-x.clone()));
            prop_assert!(!a.is_positive() || x > 0);
            prop_assert!(exact(a.size()) >= x.clone().abs());
            for y in points(&b) {
                prop_assert!(holds(&sum, &Rational::from(&x + &y)));
                prop_assert!(holds(&difference, &Rational::from(&x - &y)));
                prop_assert!(holds(&product, &Rational::from(&x * &y)));
                prop_assert!(y != 0 || !is_known(&quotient));
                prop_assert!(y == 0 || holds(&quotient, &Rational::from(&x / &y)));
            }
        }
        let all = [sum, difference, product, quotient];
        Ok(all.iter().filter(|x| !is_known(x)).count())
    }

    proptest! {
        #![proptest_config(config(4000))]

        #[test]
        fn each_operation_holds_the_truth(a in hard(), b in hard()) {
            let fused = |x: &Long| {
                let mid = DoubleDoubleBy::<Fused>::sum(x.mid.hi(), x.mid.lo());
                LaneBall::new(mid, x.rad)
            };
            let unknown = all_hold(a, b)?;
            all_hold(fused(&a), fused(&b))?;
            all_hold(a.in_doubles(), b.in_doubles())?;
            let is_moderate = |x: &Long| (1e-9..1e9).contains(&x.mid.hi().abs());
            let is_narrow = b.rad < b.mid.hi().abs() / 2.0;
            prop_assert!(unknown == 0 || !(is_moderate(&a) && is_moderate(&b) && is_narrow));
            for x in points(&a) {
                prop_assert!(holds(&a.in_doubles(), &x));
                prop_assert!(holds(&a.in_doubles().in_double_doubles::<Dekker>(), &middle(&a.in_doubles())));
                prop_assert!(holds(&a.widened(b.rad), &(x + exact(b.rad))));
            }
        }

        #[test]
        fn a_root_holds_the_truth(a in hard()) {
            let fused = LaneBall::new(DoubleDoubleBy::<Fused>::sum(a.mid.hi(), a.mid.lo()), a.rad);
            root_holds(a)?;
            root_holds(fused)?;
            root_holds(a.in_doubles())?;
        }
    }

    fn root_holds<M: Midpoint>(a: LaneBall<M>) -> Result<(), TestCaseError> {
        let root = a.sqrt();
        for x in points(&a) {
            let truth = Float::with_val(2000, &x).sqrt();
            let truth = if x < 0 { None } else { truth.to_rational() };
            prop_assert!(!is_known(&root) || truth.is_some());
            let is_near =
                |truth: Rational| (middle(&root) - truth).abs() <= exact(root.rad) + exact(1e-300);
            prop_assert!(!is_known(&root) || truth.is_none_or(is_near));
        }
        Ok(())
    }

    /// A radius is no larger than what it is made of, so that a false value is seen.
    #[test]
    fn a_radius_is_not_much_wider_than_it_has_to_be() {
        let [third, e] = [1.0 / 3.0, std::f64::consts::E].map(|x| LaneBall::new(x, 1e-10));
        for (found, radius) in [(third + e, 2e-10), (third * e, 3.06e-10), (third / e, 4.2e-11)] {
            assert!(found.rad() < 1.02 * radius && found.rad() > 0.98 * radius, "{found:?}");
        }
        let root = third.sqrt();
        assert!(root.rad() < 8.8e-11 && root.rad() > 8.6e-11, "{root:?}");
    }

    #[test]
    fn what_is_no_number_stays_none() {
        let nothing = [f64::NAN, f64::INFINITY, -f64::INFINITY];
        let one = Long::exact(1.0);
        let known = |x: Long| is_known(&x) || x.is_positive() || x.size() < 1e300;
        for x in nothing
            .map(Long::exact)
            .into_iter()
            .chain([f64::NAN, f64::INFINITY].map(|rad| LaneBall::new(one.mid, rad)))
        {
            let more =
                [x + one, one - x, x * one, one / x, x / one, x * Long::exact(0.0), x * x - x];
            assert!(!more.into_iter().any(known), "{x:?} {more:?}");
            assert!(!is_known(&x.in_doubles().sqrt()) && !x.in_doubles().is_positive());
        }
        let around = |rad| LaneBall::new(one.mid, rad);
        for divisor in [around(1.0), around(2.0), Long::exact(0.0), Long::exact(1e-20)] {
            assert!(!is_known(&(one / divisor)), "{divisor:?}");
        }
        assert!(
            !is_known(&around(1.0).in_doubles().sqrt())
                && !is_known(&LaneBall::<f64>::exact(-1.0).sqrt())
        );
    }
}
