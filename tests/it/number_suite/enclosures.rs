//! One suite for every enclosure: random formulas at hard arguments hold what MPFR finds, what is told of signs and
//! order is true, and radii that are too small are seen.

use crate::hard::config;
use couplet::number::{
    AstroInterval, Ball, Branchless, Dekker, DoubleBall, DoubleDouble, DoubleDoubleBall,
    DoubleDoubleBy, Edge, Enclosure, Field, FloatBall, Fused, Magnitude, Midpoint, Product, Real,
    Ternary, TripleWord, TripleWordBall,
};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use rug::Float;
use rug::float::Constant;

/// Bits of the truth: far more than any formula here loses.
const BITS: u32 = 3000;

/// A number and a radius, and where within the radius the truth is, from -1 to 1.
type Leaf = (DoubleDouble, f64, f64);

/// What is done with two numbers that stand before.
type Step = (u8, usize, usize);

/// Numbers, steps, and the bits of results where there is a choice.
type Formula = (Vec<Leaf>, Vec<Step>, u32);

fn float(x: DoubleDouble) -> Float {
    Float::with_val(BITS, x.hi()) + x.lo()
}

fn limits(mid: &Float, rad: &Float) -> [Float; 2] {
    [Float::with_val(BITS, mid - rad), Float::with_val(BITS, mid + rad)]
}

/// How an enclosure is made, and what it holds.
trait Held: Enclosure {
    /// All numbers within `rad` of `mid`, with results of `bits` bits where there is a choice.
    fn around(mid: DoubleDouble, rad: f64, bits: u32) -> Self;
    /// The least and the largest of its numbers; `None` for the whole line.
    fn limits(&self) -> Option<[Float; 2]>;
    /// The whole line, and what is made of no number.
    fn nothing() -> Vec<Self>;
    /// What this type tells besides is true.
    fn tells(&self, _truth: &Ball) {}
}

impl Held for Ball {
    fn around(mid: DoubleDouble, rad: f64, bits: u32) -> Self {
        Self::new(float(mid), Magnitude::upper(&Float::with_val(53, rad)), bits)
    }
    fn limits(&self) -> Option<[Float; 2]> {
        self.is_bounded().then(|| limits(self.mid(), &self.rad().to_float()))
    }
    fn nothing() -> Vec<Self> {
        vec![Self::whole(64), Self::from(f64::NAN), Self::from(f64::INFINITY)]
    }
}

impl Held for AstroInterval {
    fn around(mid: DoubleDouble, rad: f64, bits: u32) -> Self {
        let [low, high] = limits(&float(mid), &Float::with_val(53, rad));
        Self::between(&low, &high, bits as usize)
    }
    fn limits(&self) -> Option<[Float; 2]> {
        self.ends().map(Into::into)
    }
    fn nothing() -> Vec<Self> {
        vec![Self::whole(64), Self::integer(1, 64) / Self::integer(0, 64)]
    }
}

/// The midpoint of a ball of floats.
trait Middle: Midpoint {
    fn ball<E: Edge>(mid: DoubleDouble, rad: f64) -> FloatBall<Self, E>;
    fn value(self) -> Float;
}

impl Middle for f64 {
    fn ball<E: Edge>(mid: DoubleDouble, rad: f64) -> FloatBall<Self, E> {
        FloatBall::<DoubleDouble, E>::new(mid, rad).in_doubles()
    }
    fn value(self) -> Float {
        Float::with_val(BITS, self)
    }
}

impl<P: Product> Middle for DoubleDoubleBy<P> {
    fn ball<E: Edge>(mid: DoubleDouble, rad: f64) -> FloatBall<Self, E> {
        FloatBall::new(Self::sum(mid.hi(), mid.lo()), rad)
    }
    fn value(self) -> Float {
        Float::with_val(BITS, self.hi()) + self.lo()
    }
}

impl Middle for TripleWord {
    /// A low part far below is cut off.
    fn ball<E: Edge>(mid: DoubleDouble, rad: f64) -> FloatBall<Self, E> {
        FloatBall::new(mid.into(), rad).widened(mid.hi().abs() * 2f64.powi(-190))
    }
    fn value(self) -> Float {
        TripleWordBall::exact(self).to_ball(BITS).mid().clone()
    }
}

impl<M: Middle, E: Edge> Held for FloatBall<M, E>
where
    Self: Real,
{
    fn around(mid: DoubleDouble, rad: f64, _bits: u32) -> Self {
        M::ball(mid, rad)
    }
    fn limits(&self) -> Option<[Float; 2]> {
        let limits = || limits(&self.mid().value(), &Float::with_val(53, self.rad()));
        self.is_bounded().then(limits)
    }
    fn nothing() -> Vec<Self> {
        let all = [f64::NAN, f64::INFINITY, -f64::INFINITY];
        let one = Self::WHOLE.int(1).mid();
        let of_no_radius = [f64::NAN, f64::INFINITY].map(|rad| Self::new(one, rad));
        let of_no_number = all.map(|x| M::ball::<Branchless>(DoubleDouble::exact(x), 0.0).mid());
        of_no_number.map(Self::exact).into_iter().chain(of_no_radius).collect()
    }
    fn tells(&self, truth: &Ball) {
        let size = Float::with_val(BITS, self.size()) + truth.rad().to_float();
        assert!(!self.is_bounded() || truth.mid().clone().abs() <= size, "{self:?}");
        let by = self.size() / 8.0;
        for by in [by, -by] {
            let moved = Ball::exact(Float::with_val(2 * BITS, truth.mid() + by), 2 * BITS);
            assert!(holds(&self.widened(by.abs()), &moved.widened(truth.rad()), 1.0), "{self:?}");
        }
    }
}

/// Mantissas that carry and cancel; exponents near zero, spread, at the ends of the range, or where products underflow;
/// low parts of every size.
fn double_double() -> impl Strategy<Value = DoubleDouble> {
    let mantissa = || {
        prop_oneof![Just(0u64), Just(1), Just((1 << 52) - 1), any::<u64>()]
            .prop_map(|m| f64::from_bits(1023 << 52 | m & ((1 << 52) - 1)))
    };
    let exponent = prop_oneof![6 => -3i32..3, 3 => -60i32..20, 1 => -235i32..-200, 1 => 200i32..230, 1 => -500i32..400];
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
    let relative = prop_oneof![2 => Just(0.0), 3 => (-1i32..120).prop_map(|k| 2f64.powi(-k))];
    let place = prop_oneof![Just(-1.0), Just(0.0), Just(1.0), -1.0f64..=1.0];
    (double_double(), relative, place).prop_map(|(x, part, place)| (x, x.hi().abs() * part, place))
}

fn formula() -> impl Strategy<Value = Formula> {
    let step = (0u8..10, any::<prop::sample::Index>(), any::<prop::sample::Index>());
    (prop::collection::vec(leaf(), 3), prop::collection::vec(step, 12), 2u32..300).prop_map(
        |(leaves, steps, bits)| {
            let place = |(count, (kind, i, j)): (usize, (u8, prop::sample::Index, _))| {
                let j: prop::sample::Index = j;
                (kind, i.index(3 + count), j.index(3 + count))
            };
            (leaves, steps.into_iter().enumerate().map(place).collect(), bits)
        },
    )
}

/// All values of a formula. A step that leaves the range or the domain is left out in both arithmetics alike.
fn values<E: Held>((leaves, steps, bits): &Formula) -> (Vec<E>, Vec<Ball>) {
    let mut found: Vec<E> = leaves.iter().map(|(x, rad, _)| E::around(*x, *rad, *bits)).collect();
    let truth = |(mid, rad, place): &Leaf| {
        Ball::exact(float(*mid) + Float::with_val(BITS, *rad) * *place, BITS)
    };
    let mut truths: Vec<Ball> = leaves.iter().map(truth).collect();
    for (kind, i, j) in steps {
        let value = apply(*kind, &found[*i], &found[*j]);
        let truth = apply(*kind, &truths[*i], &truths[*j]);
        // The truth about zero has a square that balls do not know to be positive.
        let is_known = value.is_bounded() && (*kind != SIZE || truth.is_bounded());
        let (value, truth) = match is_known {
            true => (value, truth),
            false => (found[*i].clone(), truths[*i].clone()),
        };
        found.push(value);
        truths.push(truth);
    }
    (found, truths)
}

/// The step that finds the size of a number.
const SIZE: u8 = 4;

fn apply<E: Enclosure>(kind: u8, x: &E, y: &E) -> E {
    match kind {
        0 => x.clone() + y,
        1 => x.clone() - y,
        2 => x.clone() * y,
        3 => x.clone() / y,
        SIZE => x.square().sqrt(),
        5 => x.sqrt(),
        6 => x.sin_cos().0,
        7 => x.sin_cos().1,
        8 => x.square(),
        _ => x.pi() - y,
    }
}

/// Whether an enclosure, its radius multiplied by `factor`, holds a number that is known to some thousand bits: it lies
/// at most as far from the middle as the radius, and what those bits leave open.
fn holds<E: Held>(enclosure: &E, truth: &Ball, factor: f64) -> bool {
    let Some([low, high]) = enclosure.limits() else { return true };
    let half = |x: Float| x / 2u32;
    let middle = half(Float::with_val(2 * BITS, &low + &high));
    let radius = half(Float::with_val(2 * BITS, &high - &low));
    let distance = Float::with_val(2 * BITS, truth.mid() - &middle).abs();
    truth.is_bounded() && distance - truth.rad().to_float() <= radius * factor
}

fn check<E: Held>(formula: &Formula) {
    let (found, truths) = values::<E>(formula);
    for (index, (enclosure, truth)) in found.iter().zip(&truths).enumerate() {
        let step = index.checked_sub(formula.0.len()).map(|i| formula.1[i]);
        assert!(holds(enclosure, truth, 1.0), "{index}, {step:?}: {enclosure:?} {truth:?}");
        let sign = enclosure.is_positive();
        assert!(sign == Ternary::Undecided || sign == truth.is_positive(), "{enclosure:?}");
        assert!(!enclosure.excludes_zero() || truth.excludes_zero(), "{enclosure:?}");
        enclosure.tells(truth);
    }
    for (a, x) in found.iter().zip(&truths) {
        for (b, y) in found.iter().zip(&truths) {
            let less = a.is_less_than(b);
            assert!(less == Ternary::Undecided || less == x.is_less_than(y), "{a:?} < {b:?}");
            assert!(a.overlaps(b) || !x.overlaps(y), "{a:?} {b:?}");
            assert!(!a.lies_inside(b) || holds(b, x, 1.0), "{a:?} {b:?}");
        }
    }
    let [(x, r, _), (y, s, _), ..] = formula.0[..] else { return };
    let is_moderate = |x: DoubleDouble| (1e-9..1e9).contains(&x.hi().abs());
    if is_moderate(x) && is_moderate(y) && s < y.hi().abs() / 2.0 && formula.2 > 8 {
        let [a, b] = [(x, r), (y, s)].map(|(x, rad)| E::around(x, rad, formula.2));
        assert!((0..4).all(|kind| apply(kind, &a, &b).is_bounded()), "{a:?} {b:?}");
    }
}

/// How many enclosures of some formulas do not hold the truth with radii scaled by a factor.
fn misses<E: Held>(factor: f64) -> usize {
    let mut runner = TestRunner::deterministic();
    let formulas = (0..300).map(|_| formula().new_tree(&mut runner).unwrap().current());
    let misses = |formula| {
        let (found, truths) = values::<E>(&formula);
        found.iter().zip(&truths).filter(|(a, x)| !holds(*a, x, factor)).count()
    };
    formulas.map(misses).sum()
}

/// Products and quotients are no wider than they have to be, so that a false value is seen.
fn is_narrow<E: Held>() {
    let of = |x: f64| E::around(DoubleDouble::exact(x), 1e-10, 100);
    let (third, e) = (of(1.0 / 3.0), of(std::f64::consts::E));
    let radii = [2e-10, 2e-10, 3.06e-10, 4.2e-11, 1e-10, 8.66e-11];
    for (kind, radius) in radii.into_iter().enumerate() {
        let found = apply(kind as u8, &third, &e);
        let [low, high] = found.limits().unwrap();
        let found_radius = (high - low) / 2u32;
        assert!(found_radius < 1.02 * radius && found_radius > 0.98 * radius, "{kind} {found:?}");
    }
}

fn stays_nothing<E: Held>() {
    let around = |x: f64, rad| E::around(DoubleDouble::exact(x), rad, 64);
    let one = around(1.0, 0.0);
    for x in E::nothing() {
        let with_one = (0..4).flat_map(|kind| [apply(kind, &x, &one), apply(kind, &one, &x)]);
        let more = [x.clone(), x.sqrt(), x.clone() * around(0.0, 0.0), x.square() - &x, -x.clone()];
        for none in with_one.chain(more) {
            let is_none = !none.is_bounded() && none.is_positive() == Ternary::Undecided;
            assert!(is_none && none.overlaps(&one) && !none.lies_inside(&one), "{x:?} {none:?}");
        }
        assert!(!x.lies_inside(&x) && !x.excludes_zero() && x.sin_cos().0.overlaps(&one), "{x:?}");
        assert!(x.midpoint().is_bounded() && !x.midpoint().excludes_zero(), "{x:?}");
    }
    for none in [around(1.0, 1.0), around(1.0, 2.0), around(0.0, 0.0)].map(|x| one.clone() / x) {
        assert!(!none.is_bounded(), "{none:?}");
    }
    assert!(!around(-1.0, 0.0).sqrt().is_bounded() && !around(1.0, 1.5).sqrt().is_bounded());
}

macro_rules! enclosure_suite {
    ($($name:ident: $type:ty;)*) => {$(
        mod $name {
            use super::*;

            proptest! {
                #![proptest_config(config(1000))]
                #[test]
                fn a_formula_holds_the_truth(formula in formula()) {
                    check::<$type>(&formula);
                }
            }

            /// False twin.
            #[test]
            fn radii_that_are_too_small_are_seen() {
                let [none, some, more] = [1.0, 0.5, 1e-3].map(misses::<$type>);
                assert!(none == 0 && some > 20 && more > some, "{none} {some} {more}");
            }

            #[test]
            fn a_radius_is_not_much_wider_than_it_has_to_be() {
                is_narrow::<$type>();
            }

            #[test]
            fn what_is_no_number_stays_none() {
                stays_nothing::<$type>();
            }
        }
    )*};
}

enclosure_suite! {
    ball: Ball;
    astro: AstroInterval;
    double_ball: DoubleBall;
    double_double_ball: DoubleDoubleBall;
    triple_word_ball: TripleWordBall;
    branchless: FloatBall<f64, Branchless>;
    branchless_of_two: FloatBall<DoubleDoubleBy<Dekker>, Branchless>;
    branchless_fused: FloatBall<DoubleDoubleBy<Fused>, Branchless>;
}

/// What is out of the range of a settled ball is widened, or the whole line; and pi is within its radius, not within a
/// quarter of it.
fn settles<M: Middle>() {
    let of = |x: f64| -> FloatBall<M> { M::ball(DoubleDouble::exact(x), 0.0) };
    let ball = |x: f64, rad: f64| FloatBall::<M>::new(of(x).mid(), rad);
    let (zero, one, tiny) = (of(0.0), of(1.0), of(1e-67));
    assert!(tiny.mid().value() == 0 && tiny.rad() >= 1e-67 && tiny.rad() < 1.1e-67);
    assert!((0.0..1e-99).contains(&ball(1.0, f64::from_bits(1)).rad()) && zero.rad() == 0.0);
    assert!(of(-0.0).is_bounded() && (zero * of(3.0)).rad() == 0.0 && zero.sqrt().rad() == 0.0);
    let out = [of(1e67), ball(1.0, 1e67), ball(0.0, f64::NAN), ball(0.0, -1.0)];
    let (huge, small) = (of(1e60), of(1e-60));
    let more = [huge * huge, huge / small, FloatBall::WHOLE * zero, one.widened(f64::INFINITY)];
    assert!(out.into_iter().chain(more).all(|x| !x.is_bounded()));
    assert!((small * small).rad() >= 1e-120);
    let pi = one.pi();
    let error = (Float::with_val(BITS, Constant::Pi) - pi.mid().value()).abs();
    assert!(error <= pi.rad() && error > 0.25 * pi.rad());
}

#[test]
fn what_is_out_of_range_is_settled() {
    settles::<f64>();
    settles::<DoubleDouble>();
    settles::<TripleWord>();
}

/// Where products underflow, the error of a quotient would have no bound.
#[test]
fn nothing_is_divided_by_less_than_the_least_divisor() {
    let of = |x: f64| FloatBall::<f64, Branchless>::exact(x);
    assert!(!(of(1.0) / of(1e-20)).is_bounded() && !of(1e-20).sqrt().is_bounded());
    assert!((of(1.0) / of(1e-18)).is_bounded() && of(1e-18).sqrt().is_bounded());
}
