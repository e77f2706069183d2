//! Arches drawn from a seed: the same ones always, for whoever tests a solver without property tests.

use super::places::{DIGITS, beside};
use crate::arch::{SelfWeight, Unknown};
use crate::problem::{Arch, Landmark};

/// An arch that was drawn.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The arch.
    pub arch: Arch,
    /// The family that it was drawn from: `ordinary`, `part of pi`, `tiny opening`, `half a turn`,
    /// `no friction`, `tiny friction`, `huge friction`, `unlimited friction`, `friction angle`, or
    /// `beside T` and so on.
    pub family: String,
}

/// Arches without end: ordinary ones, with decimals of 1 to 17 places; or hard ones, half of them next to a
/// landmark, of which they share 3 to 40 digits, the others with an opening like `3e-60`, `0.9999pi` or
/// `5pi/12`, or with a friction like `0`, `1e80`, `inf` or an angle.
///
/// ```
/// use couplet_judge::strategies::samples;
/// let [first, again] = [1, 1].map(|seed| samples(seed, true).nth(99).unwrap().arch.to_string());
/// assert_eq!(first, again);
/// ```
pub fn samples(seed: u64, hard: bool) -> impl Iterator<Item = Sample> {
    let mut draw = Draw(seed);
    std::iter::repeat_with(move || draw.sample(hard)).flatten()
}

/// Random numbers by splitmix64 (Steele, Lea and Flood, 2014): its state.
pub struct Draw(pub u64);

/// The largest power of ten of a tiny or huge number, and the most places of a decimal.
const MAX_POWER: u64 = 100;
const MAX_PLACES: u64 = 17;

impl Draw {
    /// The next number.
    pub fn number(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from `low` to `high`, both of them among the possible ones.
    pub fn between(&mut self, low: u64, high: u64) -> u64 {
        let count = u128::from(high - low + 1);
        low + ((u128::from(self.number()) * count) >> 64) as u64
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.between(0, all.len() as u64 - 1) as usize]
    }

    /// A decimal from 0 to just below `limit`.
    fn decimal(&mut self, limit: u64) -> String {
        let places = self.between(1, MAX_PLACES) as usize;
        let mut digits = [b'0'; MAX_PLACES as usize];
        digits[..places].fill_with(|| b'0' + self.between(0, 9) as u8);
        // The digits are drawn before what stands in front of them.
        let mut text = self.between(0, limit - 1).to_string();
        text.reserve(1 + places);
        text.push('.');
        text.extend(digits[..places].iter().map(|&digit| char::from(digit)));
        text
    }

    /// A number with up to three digits and a large power of ten, of this sign.
    fn far(&mut self, sign: &str) -> String {
        format!("{}e{sign}{}", self.between(1, 999), self.between(4, MAX_POWER))
    }

    /// A part of pi, `5pi/12`, below `pi/divisor`.
    fn part_of_pi(&mut self, divisor: u64) -> String {
        let whole = self.between(divisor + 1, 12);
        format!("{}pi/{whole}", self.between(1, (whole - 1) / divisor))
    }

    /// An arch, unless what is drawn is outside the domain.
    fn sample(&mut self, hard: bool) -> Option<Sample> {
        let weight = self.one_of(&SelfWeight::ALL);
        let kind = if hard { self.between(1, 16) } else { 0 };
        let (half_opening, friction, family) = match kind {
            0 => (self.decimal(4), self.decimal(5), "ordinary".to_owned()),
            1 => (self.part_of_pi(1), self.decimal(3), "part of pi".into()),
            2 => (self.far("-"), self.decimal(3), "tiny opening".into()),
            3 => {
                let nines = "9".repeat(self.between(1, 60) as usize);
                (format!("0.{nines}pi"), self.decimal(5), "half a turn".into())
            }
            4 => (self.decimal(4), self.one_of(&["0", "0.0"]).to_owned(), "no friction".into()),
            5 => (self.decimal(4), self.far("-"), "tiny friction".into()),
            6 => (self.decimal(4), self.far(""), "huge friction".into()),
            7 => (self.decimal(4), "inf".into(), "unlimited friction".into()),
            8 => (self.decimal(4), format!("tan({})", self.part_of_pi(2)), "friction angle".into()),
            _ => return self.beside_a_landmark(weight),
        };
        let arch = Arch::parse(weight.name(), &half_opening, &friction).ok()?;
        Some(Sample { arch, family })
    }

    /// Half opening and, where the landmark has one, friction just below or above those of a landmark.
    fn beside_a_landmark(&mut self, weight: SelfWeight) -> Option<Sample> {
        let landmark = self.one_of(&Landmark::ALL);
        let mut near = |unknown| {
            let (digits, above) = (self.between(3, DIGITS as u64), self.one_of(&[false, true]));
            beside(landmark, weight, unknown, digits as usize, above)
        };
        let (half_opening, friction) = (near(Unknown::HalfOpening)?, near(Unknown::Friction));
        let friction = friction.unwrap_or_else(|| self.decimal(5));
        let arch = Arch::parse(weight.name(), &half_opening, &friction).ok()?;
        Some(Sample { arch, family: format!("beside {landmark}") })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn a_seed_draws_the_same_arches_and_every_family() {
        let drawn = |seed| -> Vec<Sample> { samples(seed, true).take(400).collect() };
        let texts = |all: &[Sample]| all.iter().map(|s| s.arch.to_string()).collect::<Vec<_>>();
        let (first, other) = (drawn(1), drawn(2));
        assert_eq!(texts(&first), texts(&drawn(1)));
        assert_ne!(texts(&first), texts(&other));
        let families: BTreeSet<&str> = first.iter().map(|sample| sample.family.as_str()).collect();
        assert_eq!(families.len(), 8 + Landmark::ALL.len(), "{families:?}");
        assert!(samples(1, false).take(50).all(|sample| sample.family == "ordinary"));
    }

    #[test]
    fn numbers_are_drawn_from_the_whole_range() {
        let mut draw = Draw(7);
        let seen: BTreeSet<u64> = (0..200).map(|_| draw.between(3, 6)).collect();
        assert_eq!(seen, BTreeSet::from([3, 4, 5, 6]));
        // The first number of the reference implementation with the state 0.
        assert_eq!(Draw(0).number(), 0xe220_a839_7b1d_cdaf);
        for _ in 0..200 {
            assert!(draw.part_of_pi(2).parse::<crate::number::ExactNumber>().is_ok());
        }
    }
}
