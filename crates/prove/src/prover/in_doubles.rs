//! Exactly one root in a box, in balls led by a double: search in doubles, and one step that proves.
//!
//! Newton's method settles in doubles `m`, with an approximate inverse `Y` of the Jacobian. The residuals at `m`
//! are then enclosed in the numbers of the result, and the slopes in balls of doubles on a box just
//! wide enough. In the operator of [`check::krawczyk`](crate::check::krawczyk),
//!
//! ```text
//! K(X) = m - Y F(m) + (I - Y F'(X)) (X - m)
//! ```
//!
//! the last term is a product of two small numbers, so that double-doubles gain nearly all their digits in this one
//! step; where they do not, it is repeated from the middle of `K(X)`. Numbers of more bits take a step of Newton's
//! method with the same inverse before. Any matrix `Y` and any point `m` will do: what the search finds is trusted for
//! nothing.

use super::Undecided;
use super::operator::Form;
use crate::check::krawczyk;
use crate::number::{DoubleBall, Enclosure, FloatBall, Gradient, Midpoint, Stumpff};
use crate::problem::tally;
use crate::solve::invert;
use std::array;

/// Balls of doubles, of double-doubles or of three words.
pub trait Doubles: Enclosure + Stumpff + Copy + From<DoubleBall> + Into<DoubleBall> {
    /// The relative radius that is as good as these numbers have.
    const NARROW: f64;
    /// The bits of a midpoint.
    const BITS: u32;

    /// The double nearest to the midpoint.
    fn nearest(&self) -> f64;

    /// A bound of the size of all its numbers.
    fn bound(&self) -> f64;

    /// All numbers within a radius of a midpoint, that of this one.
    fn around(&self, radius: f64) -> Self;

    /// The radius.
    fn radius(&self) -> f64;
}

impl<M: Midpoint> Doubles for FloatBall<M>
where
    Self: From<DoubleBall> + Into<DoubleBall>,
{
    const NARROW: f64 = match M::BITS == <f64 as Midpoint>::BITS {
        true => f64::INFINITY,
        false => (1u64 << 20) as f64 * M::UNIT,
    };
    const BITS: u32 = M::BITS;

    fn nearest(&self) -> f64 {
        self.mid().hi()
    }

    fn bound(&self) -> f64 {
        self.size()
    }

    fn around(&self, radius: f64) -> Self {
        Self::new(self.mid(), radius)
    }

    fn radius(&self) -> f64 {
        self.rad()
    }
}

/// Steps of Newton's method after which no candidate is found.
const STEPS: usize = 12;
/// A relative step after which a candidate is as good as doubles have it, and the inverse with it.
const LAST_STEP: f64 = 1.0 / (1u64 << 40) as f64;
/// Relative steps below this one that do not get shorter are the rounding of doubles.
const SHORT_STEP: f64 = 1.0 / (1u64 << 24) as f64;
/// Bits beyond which a candidate in doubles is bettered before a box is tried.
const FEW_BITS: u32 = 106;
/// Boxes that are tried, each about the middle of the image of the one before.
const BOXES: usize = 3;
/// Ratio of the width of a box to the correction that the residuals ask for.
const INFLATION: f64 = 4.0;

/// The root next to a start value whose length is one of some: the last of them is the number of slopes, so that the
/// equations have one code for all.
macro_rules! root_of {
    ($($name:ident: $($n:literal)+, $slopes:literal, $words:literal;)+) => {$(
        #[doc = concat!("Encloses the root of ", $words, " equations next to a start value, as [`root_near`] does.")]
        pub fn $name<E: Doubles>(
            equations: &impl Form<E>,
            start: &[f64],
        ) -> Result<Vec<E>, Undecided> {
            match start.len() {
                $($n => {
                    let start = array::from_fn::<f64, $n, _>(|k| start[k]);
                    root_near::<E, $n, $slopes>(equations, start).map(Vec::from)
                })+
                _ => Err(Undecided::no_solution()),
            }
        }
    )+};
}

root_of! {
    root_of_few: 1 2 3 4, 4, "one to four";
    root_of_many: 5 6 7, 7, "five to seven";
}

/// Encloses the root of as many equations as unknowns next to a start value, proved to exist and to be unique
/// in a box on which the equations are regular. The equations are evaluated with `S` slopes, of which `N` are those of
/// unknowns: each `S` is compiled for itself.
pub fn root_near<E: Doubles, const N: usize, const S: usize>(
    equations: &impl Form<E>,
    start: [f64; N],
) -> Result<[E; N], Undecided> {
    let (candidate, inverse) =
        settle::<E, N, S>(equations, start).ok_or_else(Undecided::no_solution)?;
    let mut centre = candidate.map(|x| E::from(DoubleBall::exact(x)));
    if E::BITS > FEW_BITS {
        centre = correction(equations, &centre, &inverse).middle(&centre);
    }
    let mut found = None;
    for _ in 0..BOXES {
        let Image { middle, proved } = image::<E, N, S>(equations, &centre, &inverse);
        let is_narrow = |x: &E| x.radius() <= E::NARROW * x.nearest().abs();
        found = proved.or(found);
        if found.is_some_and(|image| image.iter().all(is_narrow)) {
            break;
        }
        centre = middle;
    }
    found.ok_or_else(Undecided::not_alone)
}

/// Newton's method in doubles for positive unknowns: a candidate, and an approximate inverse of the Jacobian there.
fn settle<E: Doubles, const N: usize, const S: usize>(
    equations: &impl Form<E>,
    mut x: [f64; N],
) -> Option<([f64; N], [[f64; N]; N])> {
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        tally::newton_step();
        let number = |given: &E| Gradient::<f64, S>::constant(given.nearest());
        let residuals = equations.at(number, &Gradient::variables(&x));
        // Only a square system has a Jacobian, and a root to prove.
        if residuals.len() != N {
            return None;
        }
        let inverse = invert(array::from_fn(|e| array::from_fn(|k| residuals[e].slopes[k])))?;
        let mut longest = 0.0f64;
        for (x, row) in x.iter_mut().zip(&inverse) {
            let step: f64 = row.iter().zip(&residuals).map(|(y, r)| y * r.value).sum();
            // A variable never crosses zero: a longer step stops half-way there.
            let next = if *x - step > 0.0 { *x - step } else { *x / 2.0 };
            longest = longest.max(((*x - next) / next).abs());
            *x = next;
        }
        if longest <= LAST_STEP || (longest <= SHORT_STEP && longest >= last) {
            return Some((x, inverse));
        }
        last = longest;
    }
    None
}

/// Result of a step of the operator.
struct Image<E, const N: usize> {
    /// A better centre.
    middle: [E; N],
    /// The image, if it is proved to hold the only root in the box.
    proved: Option<[E; N]>,
}

/// Step of Newton's method.
struct Correction<E, const N: usize> {
    /// `Y F(m)`.
    steps: [E; N],
    /// Sizes of the steps, and of what they are made of: any will do, these are not rounded.
    sizes: [f64; N],
}

fn correction<E: Doubles, const N: usize>(
    equations: &impl Form<E>,
    centre: &[E; N],
    inverse: &[[f64; N]; N],
) -> Correction<E, N> {
    let residuals = equations.at(|given| *given, centre);
    let steps = array::from_fn(|k| {
        let terms = inverse[k].iter().zip(&residuals);
        let terms = terms.map(|(y, r)| E::from(DoubleBall::exact(*y)) * r);
        terms.fold(centre[k].int(0), |sum, term| sum + term)
    });
    let sizes = array::from_fn(|k| {
        let terms = inverse[k].iter().zip(&residuals).map(|(y, r)| y.abs() * r.bound());
        terms.sum::<f64>()
    });
    Correction { steps, sizes }
}

impl<E: Doubles, const N: usize> Correction<E, N> {
    /// A better centre.
    fn middle(&self, centre: &[E; N]) -> [E; N] {
        array::from_fn(|k| (centre[k] - self.steps[k]).midpoint())
    }
}

/// The image of a box about a centre, just wide enough for what the residuals there ask for.
fn image<E: Doubles, const N: usize, const S: usize>(
    equations: &impl Form<E>,
    centre: &[E; N],
    inverse: &[[f64; N]; N],
) -> Image<E, N> {
    let exact = |x: f64| DoubleBall::exact(x);
    let correction = correction(equations, centre, inverse);
    let domain: [E; N] = array::from_fn(|k| centre[k].around(INFLATION * correction.sizes[k]));
    let coarse = domain.map(Into::into);
    let middle = correction.middle(centre);
    if !equations.is_regular(|given| (*given).into(), &coarse) {
        return Image { middle, proved: None };
    }
    let variables = Gradient::<DoubleBall, S>::variables(&coarse);
    let slopes = equations.at(|given| Gradient::constant((*given).into()), &variables);
    let offsets: [DoubleBall; N] = array::from_fn(|k| (domain[k] - centre[k]).into());
    let spread = krawczyk::spread(&slopes, &inverse.map(|row| row.map(exact)), &offsets);
    let image: [E; N] = array::from_fn(|k| centre[k] - correction.steps[k] + E::from(spread[k]));
    Image { middle, proved: krawczyk::is_contracted(&image, &domain).then_some(image) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::DoubleDoubleBall;
    use crate::number::{Ball, Real};
    use rug::Rational;
    use std::cell::Cell;

    /// `x² - 2x + 1 = 2^-2k` as it stands: the smaller the right-hand side, the fewer digits doubles leave of the root.
    struct Close {
        k: u32,
        /// Number of boxes that were tried.
        boxes: Cell<usize>,
    }

    impl<E> Form<E> for Close {
        fn at<T: Real + Stumpff>(&self, _: impl Fn(&E) -> T, x: &[T]) -> Vec<T> {
            let [x] = x else { return Vec::new() };
            let right = (0..self.k).fold(x.int(1), |power, _| power.ratio(1, 4) * power);
            vec![x.square() - x.int(2) * x + x.int(1) - right]
        }

        fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&E) -> T, _: &[T]) -> bool {
            self.boxes.set(self.boxes.get() + 1);
            true
        }
    }

    /// The root by as many boxes as it takes, and their number.
    fn found(k: u32) -> (DoubleDoubleBall, usize) {
        let equations = Close { k, boxes: Cell::new(0) };
        let start = 1.0 + 1.1 / f64::from(1 << k);
        let [root] = root_near::<DoubleDoubleBall, 1, 2>(&equations, [start]).unwrap();
        (root, equations.boxes.get())
    }

    #[test]
    fn a_box_that_leaves_the_root_wide_is_followed_by_others() {
        for (k, boxes) in [(1, 1), (10, 2), (18, 3)] {
            let (root, tried) = found(k);
            assert_eq!(tried, boxes, "{k}");
            assert!(root.radius() <= DoubleDoubleBall::NARROW * root.nearest(), "{k} {root:?}");
            let truth = Rational::from(1) + (Rational::from(1) >> k);
            let root: Ball = root.to_ball(256);
            assert!(root.contains(&truth), "{k} {root:?}");
            assert!(!root.contains(&(truth + (Rational::from(1) >> 70))), "{k}");
        }
    }

    /// Two roots that doubles cannot tell from one.
    #[test]
    fn a_root_that_may_be_double_is_undecided() {
        let equations = Close { k: 30, boxes: Cell::new(0) };
        let proved = root_near::<DoubleDoubleBall, 1, 2>(&equations, [1.0]);
        assert!(proved.is_err(), "{proved:?}");
    }
}
