//! Balls of doubles: random formulas at hard arguments hold what MPFR finds.

use crate::hard::config;
use couplet::number::{
    Ball, DoubleBall, DoubleDouble, DoubleDoubleBall, Enclosure, Real, Ternary, TripleWordBall,
};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use rug::Float;

/// Bits of the truth: far more than any formula here loses.
const BITS: u32 = 3000;

/// A number and a radius, and where within the radius the truth is, from -1 to 1.
type Leaf = (DoubleDouble, f64, f64);

/// What is done with two numbers that stand before.
type Step = (u8, usize, usize);

trait Doubles: Real + Enclosure + Copy {
    fn leaf(mid: DoubleDouble, rad: f64) -> Self;
    /// The midpoint and the radius, exactly.
    fn parts(self) -> (Float, Float);
    /// The same with a radius that is wrong.
    fn shrunk(self, factor: f64) -> Self;
}

impl Doubles for DoubleDoubleBall {
    fn leaf(mid: DoubleDouble, rad: f64) -> Self {
        Self::new(mid, rad)
    }
    fn parts(self) -> (Float, Float) {
        let mid = Float::with_val(BITS, self.mid().hi()) + self.mid().lo();
        (mid, Float::with_val(53, self.rad()))
    }
    fn shrunk(self, factor: f64) -> Self {
        Self::new(self.mid(), self.rad() * factor)
    }
}

impl Doubles for TripleWordBall {
    /// A low part far below is cut off.
    fn leaf(mid: DoubleDouble, rad: f64) -> Self {
        Self::new(mid.into(), rad).widened(mid.hi().abs() * 2f64.powi(-190))
    }
    fn parts(self) -> (Float, Float) {
        (self.to_ball(BITS).mid().clone(), Float::with_val(53, self.rad()))
    }
    fn shrunk(self, factor: f64) -> Self {
        Self::new(self.mid(), self.rad() * factor)
    }
}

impl Doubles for DoubleBall {
    fn leaf(mid: DoubleDouble, rad: f64) -> Self {
        Self::new(mid.hi(), rad)
    }
    fn parts(self) -> (Float, Float) {
        (Float::with_val(BITS, self.mid()), Float::with_val(53, self.rad()))
    }
    fn shrunk(self, factor: f64) -> Self {
        Self::new(self.mid(), self.rad() * factor)
    }
}

/// Mantissas that carry and cancel; exponents near zero, spread, or at the ends of the range; low parts of every size.
fn double_double() -> impl Strategy<Value = DoubleDouble> {
    let mantissa = || {
        prop_oneof![Just(0u64), Just(1), Just((1 << 52) - 1), any::<u64>()]
            .prop_map(|m| f64::from_bits(1023 << 52 | m & ((1 << 52) - 1)))
    };
    let exponent =
        prop_oneof![6 => -3i32..3, 3 => -60i32..20, 1 => -235i32..-200, 1 => 200i32..230];
    let below = prop_oneof![Just(0), 0i32..60, 60i32..500];
    (mantissa(), exponent, mantissa(), below, -1i32..=1, any::<bool>()).prop_map(
        |(high, exponent, low, below, sign, minus)| {
            let lo = f64::from(sign) * low * 2f64.powi(exponent - 53 - below);
            let x = DoubleDouble::sum(high * 2f64.powi(exponent), lo);
            if minus { -x } else { x }
        },
    )
}

fn leaf() -> impl Strategy<Value = Leaf> {
    let relative = prop_oneof![2 => Just(0.0), 3 => (0i32..120).prop_map(|k| 2f64.powi(-k))];
    let place = prop_oneof![Just(-1.0), Just(1.0), -1.0f64..=1.0];
    (double_double(), relative, place).prop_map(|(x, part, place)| (x, x.hi().abs() * part, place))
}

fn formula() -> impl Strategy<Value = (Vec<Leaf>, Vec<Step>)> {
    let step = (0u8..10, any::<prop::sample::Index>(), any::<prop::sample::Index>());
    (prop::collection::vec(leaf(), 3), prop::collection::vec(step, 12)).prop_map(
        |(leaves, steps)| {
            let place = |(count, (kind, i, j)): (usize, (u8, prop::sample::Index, _))| {
                let j: prop::sample::Index = j;
                (kind, i.index(3 + count), j.index(3 + count))
            };
            (leaves, steps.into_iter().enumerate().map(place).collect())
        },
    )
}

/// All values of a formula. A step that leaves the range or the domain is left out in both arithmetics alike.
fn values<E: Doubles>(leaves: &[Leaf], steps: &[Step]) -> (Vec<E>, Vec<Ball>) {
    let mut found: Vec<E> = leaves.iter().map(|(mid, rad, _)| E::leaf(*mid, *rad)).collect();
    let truth = |((mid, rad, place), enclosure): (&Leaf, &E)| {
        // A double ball has no low part, and a tiny midpoint is only within the radius.
        let (kept, _) = enclosure.parts();
        let mid = if kept.is_zero() { Float::with_val(BITS, mid.hi()) } else { kept };
        Ball::exact(mid + Float::with_val(BITS, *rad) * *place, BITS)
    };
    let mut truths: Vec<Ball> = leaves.iter().zip(&found).map(truth).collect();
    for (kind, i, j) in steps {
        let value = apply(*kind, &found[*i], &found[*j]);
        let (value, truth) = match value.is_bounded() {
            true => (value, apply(*kind, &truths[*i], &truths[*j])),
            false => (found[*i], truths[*i].clone()),
        };
        found.push(value);
        truths.push(truth);
    }
    (found, truths)
}

fn apply<E: Enclosure>(kind: u8, x: &E, y: &E) -> E {
    match kind {
        0 => x.clone() + y,
        1 => x.clone() - y,
        2 => x.clone() * y,
        3 => x.clone() / y,
        4 => x.square().sqrt(),
        5 => x.sqrt(),
        6 => x.sin_cos().0,
        7 => x.sin_cos().1,
        8 => x.square(),
        _ => x.pi() - y,
    }
}

/// Whether an enclosure holds a number that is known to some thousand bits: it lies at most as far from the
/// midpoint as the radius, and what those bits leave open.
fn holds<E: Doubles>(enclosure: E, truth: &Ball) -> bool {
    let (mid, rad) = enclosure.parts();
    let distance = Float::with_val(2 * BITS, truth.mid() - &mid).abs();
    truth.is_bounded() && distance - truth.rad().to_float() <= rad
}

fn check<E: Doubles>(leaves: &[Leaf], steps: &[Step]) {
    let (found, truths) = values::<E>(leaves, steps);
    for (index, (enclosure, truth)) in found.iter().zip(&truths).enumerate() {
        let step = index.checked_sub(leaves.len()).map(|i| steps[i]);
        assert!(holds(*enclosure, truth), "{index}, {step:?}: {enclosure:?} {truth:?}");
        let sign = enclosure.is_positive();
        assert!(sign == Ternary::Undecided || sign == truth.is_positive(), "{enclosure:?}");
    }
    for (a, x) in found.iter().zip(&truths) {
        for (b, y) in found.iter().zip(&truths) {
            let less = a.is_less_than(b);
            assert!(less == Ternary::Undecided || less == x.is_less_than(y), "{a:?} < {b:?}");
            assert!(a.overlaps(b) || !x.overlaps(y), "{a:?} {b:?}");
            assert!(!a.lies_inside(b) || holds(*b, x), "{a:?} {b:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(1500))]

    #[test]
    fn a_formula_over_double_balls_holds_the_truth((leaves, steps) in formula()) {
        check::<DoubleBall>(&leaves, &steps);
    }

    #[test]
    fn a_formula_over_double_double_balls_holds_the_truth((leaves, steps) in formula()) {
        check::<DoubleDoubleBall>(&leaves, &steps);
    }

    #[test]
    fn a_formula_over_balls_of_three_words_holds_the_truth((leaves, steps) in formula()) {
        check::<TripleWordBall>(&leaves, &steps);
    }
}

/// How many enclosures of some formulas do not hold the truth with radii scaled by a factor.
fn misses<E: Doubles>(factor: f64) -> usize {
    let mut runner = TestRunner::deterministic();
    let formulas = (0..300).map(|_| formula().new_tree(&mut runner).unwrap().current());
    formulas
        .map(|(leaves, steps)| {
            let (found, truths) = values::<E>(&leaves, &steps);
            found.iter().zip(&truths).filter(|(a, x)| !holds(a.shrunk(factor), x)).count()
        })
        .sum()
}

/// False twin: radii that are a little too small are found out.
#[test]
fn radii_that_are_too_small_are_seen() {
    let counts = [1.0, 0.5, 1e-3]
        .map(|factor| (misses::<DoubleBall>(factor), misses::<DoubleDoubleBall>(factor)));
    assert_eq!(counts[0], (0, 0));
    assert!(counts[1].0 > 20 && counts[1].1 > 20, "{counts:?}");
    assert!(counts[2].0 > counts[1].0 && counts[2].1 > counts[1].1, "{counts:?}");
}
