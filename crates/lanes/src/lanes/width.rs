//! Numbers of arches that go through the proof at a time, as processors have lanes for them.
//!
//! The proof is one text. It is compiled for each width, and the compiler puts as many arches into it as a register has
//! doubles. No bit depends on the width: the errors of products are found by a fused multiplication where there is one
//! and without it elsewhere, and are exact both ways.
#![allow(
    unsafe_code,
    reason = "a function for some processors is called where it is known to be on one of them"
)]

use super::ball::LaneBall;
use super::rotation::{Rotation, rotation};
use super::start::{StartTable, Starts};
use super::state::RotationalState;
use crate::arch::SelfWeight;
use crate::number::{Dekker, DoubleDoubleBy, Fused, Product};

/// Number of arches that go through the proof at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Width {
    /// As every processor has it.
    Any,
    /// Four, on a processor with AVX2 and fused multiplication.
    Four,
    /// Eight, on a processor with AVX-512.
    Eight,
}

/// Arches that are one call of the proof.
const ARCHES: usize = 64;

/// Columns of numbers, of which each is two doubles and a radius.
type Column = [[f64; ARCHES]; 3];

/// The values of some states, apart by what they are.
struct Columns([Column; 4]);

/// Arches of one call of the proof.
struct Piece<'a> {
    weight: SelfWeight,
    table: &'a StartTable,
    half_openings: [f64; ARCHES],
    frictions: [f64; ARCHES],
}

impl Piece<'_> {
    /// The one text of all widths.
    #[inline(always)]
    fn prove<P: Product>(&self, Columns(columns): &mut Columns) {
        let starts = Starts::new(self.table, &self.half_openings);
        let [first, second, third, fourth] = columns;
        for place in 0..ARCHES {
            let given = [self.half_openings[place], self.frictions[place]];
            let Rotation { thickness, thrust, intrinsic_thrust, rotation_joint } =
                rotation::<P, ARCHES>(self.weight, &starts, place, given);
            put(first, place, &thickness);
            put(second, place, &thrust);
            put(third, place, &intrinsic_thrust);
            put(fourth, place, &rotation_joint);
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn prove_four(&self, columns: &mut Columns) {
        self.prove::<Fused>(columns);
    }

    #[cfg(all(target_arch = "x86_64", has_avx512))]
    #[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
    fn prove_eight(&self, columns: &mut Columns) {
        self.prove::<Fused>(columns);
    }
}

#[inline(always)]
fn put<P: Product>(column: &mut Column, place: usize, x: &LaneBall<DoubleDoubleBy<P>>) {
    let [high, low, radius] = column;
    high[place] = x.mid().hi();
    low[place] = x.mid().lo();
    radius[place] = x.rad();
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

    /// The purely rotational states of arches of as many half openings, rad, and frictions, which may be infinite;
    /// `None` where it is not proved that the arch collapses so. Any double may be asked: what makes no sense has no
    /// state.
    ///
    /// ```
    /// use couplet_check::arch::SelfWeight;
    /// use couplet_lanes::lanes::Width;
    /// let states =
    ///     Width::widest().rotational(SelfWeight::Heyman, &[1.5, 1.5, -1.0], &[0.5, 0.01, 0.5]);
    /// let [Some(state), None, None] = &states[..] else { panic!() };
    /// assert_eq!(state.thickness.nearest_double(), Some(0.090140690267333675));
    /// ```
    pub fn rotational(
        self,
        weight: SelfWeight,
        half_openings: &[f64],
        frictions: &[f64],
    ) -> Vec<Option<RotationalState>> {
        let table = StartTable::of(weight);
        let mut columns = Columns([[[f64::NAN; ARCHES]; 3]; 4]);
        let mut all = Vec::with_capacity(half_openings.len());
        for (alphas, mus) in half_openings.chunks(ARCHES).zip(frictions.chunks(ARCHES)) {
            let [half_openings, frictions] = [alphas, mus].map(filled);
            self.prove(&Piece { weight, table, half_openings, frictions }, &mut columns);
            let count = alphas.len().min(mus.len());
            all.extend((0..count).map(|place| columns.state(place)));
        }
        all
    }

    /// Proves a piece in this width, or as every processor can.
    fn prove(self, piece: &Piece, columns: &mut Columns) {
        match self {
            // SAFETY: the processor has what the function is compiled for.
            #[cfg(target_arch = "x86_64")]
            Self::Four if self.is_here() => unsafe { piece.prove_four(columns) },
            // SAFETY: the same.
            #[cfg(all(target_arch = "x86_64", has_avx512))]
            Self::Eight if self.is_here() => unsafe { piece.prove_eight(columns) },
            _ => piece.prove::<Dekker>(columns),
        }
    }
}

/// Some numbers, and behind them what is none.
fn filled(some: &[f64]) -> [f64; ARCHES] {
    let mut all = [f64::NAN; ARCHES];
    all[..some.len()].copy_from_slice(some);
    all
}

impl Columns {
    /// The state in a place, if it is proved.
    fn state(&self, place: usize) -> Option<RotationalState> {
        let number = |column: &Column| column.map(|part| part[place]);
        RotationalState::new(self.0.each_ref().map(number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half openings and frictions, in no order; among them what makes no sense, and what has no such state.
    fn arches(count: usize) -> (Vec<f64>, Vec<f64>) {
        let spread =
            |step: f64, most: f64| (0..count).map(move |k| most * ((k + 1) as f64 * step).fract());
        let frictions = spread(0.569_840_291, 4.0);
        let frictions = frictions.map(|mu| if mu > 2.0 { f64::INFINITY } else { mu });
        let odd = [f64::NAN, f64::INFINITY, -1.0, 0.0, -0.0, 1e300, 5e-324, f64::NEG_INFINITY];
        let half_openings = spread(0.754_877_666, 2.7).chain(odd).chain([1.0; 8]);
        (half_openings.collect(), frictions.chain([1.0; 8]).chain(odd).collect())
    }

    fn bits(state: &Option<RotationalState>) -> Option<[[u64; 3]; 4]> {
        let state = state.as_ref()?;
        let all = [state.thickness, state.thrust, state.intrinsic_thrust, state.rotation_joint];
        Some(all.map(|x| [x.mid().hi(), x.mid().lo(), x.rad()].map(f64::to_bits)))
    }

    #[test]
    fn all_widths_find_the_same_bits() {
        let (alphas, mus) = arches(20_000);
        for weight in SelfWeight::ALL {
            let found = |width: Width| {
                let states = width.rotational(weight, &alphas, &mus);
                states.iter().map(bits).collect::<Vec<_>>()
            };
            let any = found(Width::Any);
            assert_eq!(any.len(), alphas.len());
            let proved = any.iter().flatten().count();
            assert!((10_000..20_000).contains(&proved), "{proved}");
            assert!(any[20_000..20_008].iter().all(Option::is_none));
            let odd = any[20_008..].iter().map(Option::is_some).collect::<Vec<_>>();
            assert_eq!(odd, [false, true, false, false, false, true, false, false]);
            for width in Width::ALL.into_iter().filter(|width| width.is_here()) {
                assert!(found(width) == any, "{width:?}");
            }
        }
    }

    /// No arch is answered by the numbers of another, wherever it stands.
    #[test]
    fn a_place_does_not_matter() {
        let (alphas, mus) = arches(150);
        let weight = SelfWeight::Milankovitch;
        let together = Width::widest().rotational(weight, &alphas, &mus);
        for (place, (alpha, mu)) in alphas.iter().zip(&mus).enumerate() {
            let alone = Width::Any.rotational(weight, &[*alpha], &[*mu]);
            assert_eq!(alone.iter().map(bits).next(), Some(bits(&together[place])), "{alpha} {mu}");
        }
        assert!(Width::Any.rotational(weight, &[], &[]).is_empty());
    }

    #[test]
    fn the_states_are_as_narrow_as_double_doubles_allow() {
        let alphas: Vec<f64> = (0..2000).map(|k| 0.3 + 2.1 * f64::from(k) / 2000.0).collect();
        for weight in SelfWeight::ALL {
            let states = Width::widest().rotational(weight, &alphas, &vec![f64::INFINITY; 2000]);
            for (alpha, state) in alphas.iter().zip(states) {
                let eta = state.unwrap().thickness;
                assert!(eta.rad() < 1e-18 * eta.mid().hi() && eta.rad() > 0.0, "{alpha} {eta:?}");
            }
        }
    }
}
