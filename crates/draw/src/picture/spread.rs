//! Labels pushed apart.

/// Places at least `gap` apart, in the given order and between `low` and `high` if there is room, with
/// the least sum of squared distances to the sorted `wanted` ones.
pub fn spread(wanted: &[f64], gap: f64, low: f64, high: f64) -> Vec<f64> {
    // Without the gaps the places need only not decrease: neighbours that do are pooled at their mean.
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for (k, place) in wanted.iter().enumerate() {
        let mut pool = (place - k as f64 * gap, 1);
        while let Some(&(mean, size)) = pools.last().filter(|last| last.0 > pool.0) {
            pool.0 = (mean * size as f64 + pool.0 * pool.1 as f64) / (size + pool.1) as f64;
            pool.1 += size;
            pools.pop();
        }
        pools.push(pool);
    }
    let last = (high - wanted.len().saturating_sub(1) as f64 * gap).max(low);
    let flat = pools.into_iter().flat_map(|(mean, size)| std::iter::repeat_n(mean, size));
    flat.enumerate().map(|(k, place)| place.clamp(low, last) + k as f64 * gap).collect()
}

#[cfg(test)]
mod tests {
    use super::spread;
    use proptest::prelude::*;

    #[test]
    fn what_is_apart_stays_and_what_is_not_moves_little() {
        assert_eq!(spread(&[10.0, 50.0], 10.0, 0.0, 100.0), [10.0, 50.0]);
        assert_eq!(spread(&[50.0, 50.0, 50.0], 10.0, 0.0, 100.0), [40.0, 50.0, 60.0]);
        assert_eq!(spread(&[100.0, 100.0], 10.0, 0.0, 100.0), [90.0, 100.0]);
        assert_eq!(spread(&[], 10.0, 0.0, 100.0), [0.0; 0]);
    }

    proptest! {
        #![proptest_config(crate::number::test_config::config(256))]

        #[test]
        fn places_are_apart_and_within(mut wanted in prop::collection::vec(-50.0..150.0, 1..10)) {
            wanted.sort_by(f64::total_cmp);
            let places = spread(&wanted, 10.0, 0.0, 100.0);
            prop_assert!(places.windows(2).all(|pair| pair[1] - pair[0] > 10.0 - 1e-9));
            prop_assert!(places[0] >= 0.0 && places[places.len() - 1] <= 100.0 + 1e-9);
        }
    }
}
