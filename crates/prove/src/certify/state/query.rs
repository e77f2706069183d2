//! An arch at one precision: what every step of a proof reads.

use crate::arch::{Configuration, SelfWeight};
use crate::number::{Ball, bits_of};
use crate::problem::{Arch, Friction, System};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::FEW;
use crate::prover::posed::Posed;
use crate::prover::{Undecided, raise};

/// Bits beyond the digits asked for, at the first attempt.
pub(super) const GUARD: u32 = 48;
/// The bits of a double-double.
pub(crate) const DOUBLE_DOUBLE: u32 = 106;
/// The bits of a double.
pub(super) const DOUBLE: u32 = 53;

/// An arch in numbers of some bits.
#[derive(Clone)]
pub(super) struct Query<E = Ball> {
    pub weight: SelfWeight,
    pub bits: u32,
    /// Given variables: the half opening and, if finite, the friction.
    pub given: Configuration<E>,
    pub is_limited: bool,
}

impl<E: Arithmetic> Query<E> {
    /// The arch in numbers of `bits` bits, where they can have so many.
    pub(super) fn new(arch: &Arch, bits: u32) -> Self {
        let is_limited = arch.is_limited();
        Self { weight: arch.weight(), bits, given: arch.given(bits), is_limited }
    }

    /// The arch in few of these bits, where they are many: few mostly tell a sign.
    pub(super) fn in_few_bits(&self) -> Option<Self> {
        let given = || self.given.map_ref(|x| x.with_bits(FEW as usize));
        (self.bits > 2 * FEW).then(|| Self { bits: FEW, given: given(), ..*self })
    }

    /// The answer that few of these bits tell, or else all.
    pub(super) fn by_few_bits<T>(
        &self,
        proof: impl Fn(&Self) -> Result<T, Undecided>,
    ) -> Result<T, Undecided> {
        let few = self.in_few_bits().and_then(|few| proof(&few).ok());
        few.map_or_else(|| proof(self), Ok)
    }

    /// The friction, where it is limited.
    pub(super) fn friction(&self) -> Option<&E> {
        self.is_limited.then_some(&self.given.friction)
    }

    /// The half opening as a candidate.
    pub(super) fn alpha(&self) -> E::Candidate {
        self.given.half_opening.rad.candidate()
    }

    /// The root of a system next to a start value, proved to exist and to be unique in a box.
    pub(super) fn root(
        &self,
        system: System,
        start: &[E::Candidate],
    ) -> Result<Configuration<E>, Undecided> {
        let posed = Posed { system: &system, given: &self.given };
        posed.root(self.bits, start)
    }
}

/// Bits that the printed equations lose by cancellation: the thickness falls like the fourth power of a
/// small half opening, the thrust like the inverse square of a large friction.
pub fn bits_lost(arch: &Arch) -> u32 {
    let friction = match arch.friction() {
        Friction::Coefficient(mu) => exponent(&mu.enclosure(64)).max(64) - 64,
        _ => 0,
    };
    let opening = exponent(&arch.half_opening().enclosure(64));
    opening.min(0).unsigned_abs() * 6 + friction.unsigned_abs() * 4
}

/// Bits lost, where equations that lose none are used for small half openings, at a precision of `bits` bits.
pub(super) fn bits_lost_unless_small(arch: &Arch, bits: u32) -> u32 {
    let opening: Ball = arch.half_opening().enclosure(64);
    let is_small = opening.mid().get_exp().is_some_and(|e| Ball::is_small(2 * i64::from(e), bits));
    if is_small { 0 } else { bits_lost(arch) }
}

/// Answer that a proof about an arch finds, with more bits until it decides everything, first with enough for
/// `digits` digits; what stays undecided otherwise.
pub fn raised<T>(
    arch: &Arch,
    digits: usize,
    proof: impl FnMut(u32) -> Result<Option<T>, Undecided>,
) -> Result<T, Undecided> {
    let first = bits_of(digits) + GUARD;
    raise(first + bits_lost_unless_small(arch, first), proof)
}

fn exponent(x: &Ball) -> i32 {
    x.mid().get_exp().unwrap_or(0)
}
