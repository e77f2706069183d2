//! Products of long integers, in one place: whoever multiplies faster than GMP does it here.

use rug::Integer;
use std::collections::{BTreeMap, BTreeSet};

/// `a b`.
pub(super) fn product(a: &Integer, b: &Integer) -> Integer {
    Integer::from(a * b)
}

/// `a²`.
pub(super) fn square(a: &Integer) -> Integer {
    Integer::from(a.square_ref())
}

/// The powers `base^n` for `n = count`, its halves, their halves and so on, odd numbers rounded both ways.
pub(super) fn halving_powers(base: &Integer, count: u32) -> BTreeMap<u32, Integer> {
    let mut open = BTreeSet::from([count]);
    let mut wanted = BTreeSet::new();
    while let Some(n) = open.pop_last() {
        wanted.insert(n);
        if n > 1 {
            open.extend([n / 2, n - n / 2]);
        }
    }
    let mut powers: BTreeMap<u32, Integer> = BTreeMap::new();
    for n in wanted {
        let half = powers.get(&(n / 2));
        let power = match half {
            Some(half) if n.is_multiple_of(2) => square(half),
            Some(half) => product(&square(half), base),
            None => base.clone(),
        };
        powers.insert(n, power);
    }
    powers
}

/// A number of exactly `bits` bits that look like drawn ones.
#[cfg(test)]
pub(super) fn scrambled(seed: u64, bits: u32) -> Integer {
    use rug::ops::Pow;
    let power = Integer::from(seed | 1 << 40 | 1).pow(bits / 40 + 4);
    (power >> 20u32).keep_bits(bits - 1) + (Integer::from(1) << (bits - 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::ops::Pow;

    #[test]
    fn the_powers_are_powers() {
        for count in [1, 2, 3, 7, 100, 129] {
            let powers = halving_powers(&Integer::from(-3), count);
            assert!(powers.contains_key(&count) && powers.contains_key(&1));
            for (n, power) in powers {
                assert_eq!(power, Integer::from(-3).pow(n));
            }
        }
    }
}
