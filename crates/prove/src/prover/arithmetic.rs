//! The numbers in which a proof about an arch runs.

use super::Undecided;
use super::in_doubles::{self, Doubles};
use super::operator::Form;
use super::root::rooted_near;
use super::sines::Sines;
use crate::number::{
    Angle, Ball, DoubleBall, DoubleDoubleBall, Engine, Field, Magnitude, Stumpff, Ternary,
    TripleWordBall, stumpff_terms,
};
use crate::solve::start::Start;
use rug::Float;
use rug::float::Round;

/// Enclosures in which a proof about an arch runs: balls of as many bits as it takes, or of doubles, which cost a
/// tenth where they are enough.
pub trait Arithmetic: Engine + Stumpff {
    /// The numbers in which candidates are found.
    type Candidate: Start;
    /// The sines and cosines that are known of angles nearby.
    type Sines;
    /// Numbers in which signs are decided: these, or some with fewer bits.
    type Signs: Arithmetic;

    /// A ball of MPFR in these numbers, to at least `bits` bits where they can have so many.
    fn from_ball(ball: &Ball, bits: u32) -> Self;

    /// The midpoint, as a candidate.
    fn candidate(&self) -> Self::Candidate;

    /// The set, or one that holds it, in the numbers in which signs are decided.
    fn for_signs(&self) -> Self::Signs;

    /// An enclosure of this one and another; tight where they differ by little.
    fn hull_with(&self, other: &Self) -> Self;

    /// A bound of the size of all its numbers, rounded up.
    fn bound(&self) -> f64;

    /// `1 - x`, with as many bits as these numbers can have.
    fn rest_to_one(&self) -> Self;

    /// Tells whether an angle is so small, in numbers of `bits` bits, that equations are used in variables in
    /// which nothing cancels; `2^exponent` bounds its square.
    fn is_small(exponent: i64, bits: u32) -> bool;

    /// Encloses the root of equations next to a start value, proved to exist and to be unique in a box on which
    /// the equations are regular, in doubles of one or two; with the sines and cosines that it took.
    fn rooted<const N: usize>(
        equations: &impl Form<Self>,
        bits: u32,
        start: &[Self::Candidate; N],
    ) -> Result<([Self; N], Self::Sines), Undecided>;

    /// The root of as many equations as the start value has numbers: in doubles one to four.
    fn rooted_of_few(
        equations: &impl Form<Self>,
        bits: u32,
        start: &[Self::Candidate],
    ) -> Result<(Vec<Self>, Self::Sines), Undecided>;

    /// The root alone.
    fn root_near<const N: usize>(
        equations: &impl Form<Self>,
        bits: u32,
        start: &[Self::Candidate; N],
    ) -> Result<[Self; N], Undecided> {
        Self::rooted(equations, bits, start).map(|(root, _)| root)
    }

    /// An angle with its sine and cosine, near those of a root.
    fn angle(sines: &Self::Sines, rad: &Self) -> Angle<Self>;
}

/// An enclosure of the larger of two numbers; of both, where that is not decided.
pub fn larger<E: Arithmetic>(a: E, b: E) -> E {
    match a.is_less_than(&b) {
        Ternary::True => b,
        Ternary::False => a,
        Ternary::Undecided => a.hull_with(&b),
    }
}

/// An enclosure of the lesser of two numbers; of both, where that is not decided.
pub fn lesser<E: Arithmetic>(a: E, b: E) -> E {
    -larger(-a, -b)
}

/// The square of an angle is below two to this power: then the series of the start values hold.
const SMALL: i64 = -4;
/// A candidate has at most so many bits, or this part of more: what is next to a limit takes many.
const CANDIDATE: u32 = 16_384;
const CANDIDATE_PART: u32 = 16;
/// More terms than this, and sines and cosines with a few more bits are cheaper.
const MANY_TERMS: i32 = 24;

impl Arithmetic for Ball {
    type Candidate = Float;
    type Sines = Sines;
    type Signs = Self;

    fn from_ball(ball: &Ball, bits: u32) -> Self {
        ball.with_precision(bits)
    }

    fn candidate(&self) -> Float {
        Float::with_val(self.prec().min(CANDIDATE.max(self.prec() / CANDIDATE_PART)), self.mid())
    }

    fn for_signs(&self) -> Self {
        self.clone()
    }

    fn hull_with(&self, other: &Self) -> Self {
        self.hull(other)
    }

    fn bound(&self) -> f64 {
        Magnitude::upper(self.mid()).plus(self.rad()).to_float().to_f64_round(Round::Up)
    }

    fn rest_to_one(&self) -> Self {
        // As many bits as the difference from one has: they cost nothing.
        let gap = self.mid().get_exp().map_or(0, |exponent| exponent.min(0).unsigned_abs());
        Self::integer(1, self.prec() + gap) - self
    }

    fn is_small(exponent: i64, bits: u32) -> bool {
        exponent <= SMALL && stumpff_terms(bits, exponent) <= MANY_TERMS
    }

    fn rooted<const N: usize>(
        equations: &impl Form<Self>,
        bits: u32,
        start: &[Float; N],
    ) -> Result<([Self; N], Sines), Undecided> {
        let (root, sines) = Self::rooted_of_few(equations, bits, start)?;
        Ok((root.try_into().map_err(|_| Undecided::no_solution())?, sines))
    }

    fn rooted_of_few(
        equations: &impl Form<Self>,
        bits: u32,
        start: &[Float],
    ) -> Result<(Vec<Self>, Sines), Undecided> {
        rooted_near(equations, bits, start).map(|root| (root.values, root.sines))
    }

    fn angle(sines: &Sines, rad: &Self) -> Angle<Self> {
        sines.angle(rad)
    }
}

/// In balls of doubles the square of an angle is below two to this power where sines and cosines lose more digits than
/// can be spared: until then they are much cheaper.
const SMALL_IN_DOUBLES: i64 = -6;

/// Balls led by a double, with the numbers in which their signs are decided.
macro_rules! led_by_doubles {
    ($($ball:ty: $signs:ty),+) => {$(
        impl Arithmetic for $ball {
            type Candidate = f64;
            type Sines = ();
            type Signs = $signs;

            fn from_ball(ball: &Ball, _bits: u32) -> Self {
                ball.into()
            }

            fn candidate(&self) -> f64 {
                self.nearest()
            }

            fn for_signs(&self) -> $signs {
                (*self).into()
            }

            fn hull_with(&self, other: &Self) -> Self {
                self.hull(other)
            }

            fn bound(&self) -> f64 {
                self.size()
            }

            fn rest_to_one(&self) -> Self {
                self.int(1) - self
            }

            fn is_small(exponent: i64, _bits: u32) -> bool {
                exponent <= SMALL_IN_DOUBLES
            }

            fn rooted<const N: usize>(
                equations: &impl Form<Self>,
                _bits: u32,
                start: &[f64; N],
            ) -> Result<([Self; N], ()), Undecided> {
                in_doubles::root_near::<_, N, 2>(equations, *start).map(|root| (root, ()))
            }

            fn rooted_of_few(
                equations: &impl Form<Self>,
                _bits: u32,
                start: &[f64],
            ) -> Result<(Vec<Self>, ()), Undecided> {
                in_doubles::root_of_few(equations, start).map(|root| (root, ()))
            }

            fn angle((): &(), rad: &Self) -> Angle<Self> {
                Angle::new(*rad)
            }
        }
    )+};
}

led_by_doubles! {
    DoubleBall: DoubleBall,
    DoubleDoubleBall: DoubleDoubleBall,
    TripleWordBall: DoubleDoubleBall
}
