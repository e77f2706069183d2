//! Numbers of arches that go through a proof at a time, as processors have lanes for them.
//!
//! A proof is one text. It is compiled for each width, and the compiler puts as many arches into it as a register has
//! doubles. No bit depends on the width: the errors of products are found by a fused multiplication where there is one
//! and without it elsewhere, and are exact both ways.
#![allow(
    unsafe_code,
    reason = "a function for some processors is called where it is known to be on one of them"
)]

use super::piece::{ARCHES, LanePiece, Proof};
use crate::number::{Dekker, DoubleDoubleBall, Fused};

/// Number of arches that go through a proof at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Width {
    /// As every processor has it.
    Any,
    /// Four, on a processor with AVX2 and fused multiplication.
    Four,
    /// Eight, on a processor with AVX-512.
    Eight,
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn prove_four<const IN: usize, const ANGLES: usize, const OUT: usize>(
    piece: &mut LanePiece<IN, OUT>,
    proof: &impl Proof<IN, ANGLES, OUT>,
) {
    piece.prove::<Fused, ANGLES>(proof);
}

#[cfg(all(target_arch = "x86_64", has_avx512))]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn prove_eight<const IN: usize, const ANGLES: usize, const OUT: usize>(
    piece: &mut LanePiece<IN, OUT>,
    proof: &impl Proof<IN, ANGLES, OUT>,
) {
    piece.prove::<Fused, ANGLES>(proof);
}

impl Width {
    /// All of them, the widest last.
    pub const ALL: [Self; 3] = [Self::Any, Self::Four, Self::Eight];

    /// Tells whether this processor has it.
    pub fn is_here(self) -> bool {
        match self {
            Self::Any => true,
            #[cfg(target_arch = "x86_64")]
            Self::Four => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(all(target_arch = "x86_64", has_avx512))]
            Self::Eight => {
                Self::Four.is_here()
                    && is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512dq")
            }
            #[allow(unreachable_patterns, reason = "other processors have other widths")]
            _ => false,
        }
    }

    /// The widest that this processor has.
    pub fn widest() -> Self {
        Self::ALL.into_iter().rev().find(|width| width.is_here()).unwrap_or(Self::Any)
    }

    /// Values that a proof finds for each of some rows, in their order; `None` where it proves nothing. Any number may
    /// be given: what makes no sense has no proof.
    pub(super) fn prove<const IN: usize, const ANGLES: usize, const OUT: usize>(
        self,
        proof: &impl Proof<IN, ANGLES, OUT>,
        rows: &[[DoubleDoubleBall; IN]],
    ) -> Vec<Option<[DoubleDoubleBall; OUT]>> {
        let mut all = Vec::with_capacity(rows.len());
        let mut piece = LanePiece::new();
        for rows in rows.chunks(ARCHES) {
            rows.iter().enumerate().for_each(|(place, row)| piece.put(place, row));
            match self {
                // SAFETY: the processor has what the function is compiled for.
                #[cfg(target_arch = "x86_64")]
                Self::Four if self.is_here() => unsafe { prove_four(&mut piece, proof) },
                // SAFETY: the same.
                #[cfg(all(target_arch = "x86_64", has_avx512))]
                Self::Eight if self.is_here() => unsafe { prove_eight(&mut piece, proof) },
                _ => piece.prove::<Dekker, ANGLES>(proof),
            }
            debug_assert!(piece.is_found_by_any(proof), "{self:?} differs from any processor");
            all.extend((0..rows.len()).map(|place| piece.found(place)));
        }
        all
    }
}
