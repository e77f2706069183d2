//! Scales: the place of a value on an axis, and the ticks.

use super::text;

/// Scale that gives the place of a value on an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Values lie by their decimal logarithm.
    Log10,
    /// Evenly, since it is a decimal logarithm already; the ticks say of what.
    Exponent,
    /// Values lie as with `Exponent`, but from high to low: the distance to something, ever closer.
    Approach,
}

impl Scale {
    /// The place of a value, if it has one.
    pub fn place(self, value: f64) -> Option<f64> {
        let place = match self {
            Self::Linear | Self::Exponent | Self::Approach => value,
            Self::Log10 if value > 0.0 => value.log10(),
            Self::Log10 => return None,
        };
        (place.abs() < LARGEST).then_some(place)
    }
}

/// No place is larger, so that differences are finite.
const LARGEST: f64 = 1e300;
/// Part of the range, free at each end.
const PADDING: f64 = 0.04;
/// Ticks on an axis at most.
const MOST: usize = 8;

/// A stretch of an axis, with ticks.
pub struct Ruler {
    low: f64,
    high: f64,
    falling: bool,
    /// Ticks in the order of the axis.
    pub ticks: Vec<Tick>,
}

/// A labelled place.
#[derive(Debug)]
pub struct Tick {
    /// Place of the tick.
    pub place: f64,
    /// Text that is written there.
    pub label: String,
}

impl Ruler {
    /// Covers the places with as many ticks as there is room for, on so many units of length with so
    /// much `between` any two neighbours.
    pub fn new(
        scale: Scale,
        places: impl Iterator<Item = f64>,
        length: f64,
        between: impl Fn(&Tick, &Tick) -> f64,
    ) -> Self {
        let (low, high) = range(scale, places);
        let unit = length / (high - low);
        let fits = |ticks: &Vec<Tick>| {
            let apart = |pair: &[Tick]| {
                (pair[1].place - pair[0].place) * unit >= between(&pair[0], &pair[1])
            };
            ticks.len() <= MOST && ticks.windows(2).all(apart)
        };
        let ticks = match scale {
            Scale::Linear => even(low, high).find(fits),
            Scale::Log10 | Scale::Exponent | Scale::Approach => {
                within_decades(low, high).into_iter().chain(decades(low, high)).find(fits)
            }
        };
        let mut ticks = ticks.unwrap_or_default();
        let falling = scale == Scale::Approach;
        if falling {
            ticks.reverse();
        }
        Self { low, high, falling, ticks }
    }

    /// Share of a place, from 0 at the start to 1 at the end.
    pub fn share(&self, place: f64) -> f64 {
        let from = if self.falling { self.high - place } else { place - self.low };
        from / (self.high - self.low)
    }
}

/// Range of an axis: all places, some room beside them, and not too little.
fn range(scale: Scale, places: impl Iterator<Item = f64>) -> (f64, f64) {
    let ends = places.fold(None, |ends, p| match ends {
        None => Some((p, p)),
        Some((low, high)) => Some((p.min(low), p.max(high))),
    });
    let (low, high): (f64, f64) = ends.unwrap_or((0.0, 1.0));
    let size = low.abs().max(high.abs());
    let least = match scale {
        // A decade has at least three ticks.
        Scale::Log10 | Scale::Exponent | Scale::Approach => f64::max(1.0, 1e-9 * size),
        Scale::Linear if high - low > f64::max(1e-9 * size, 1e-290) => 0.0,
        Scale::Linear if size > 1e-280 => 0.2 * size,
        Scale::Linear => 1.0,
    };
    let missing = (least - (high - low)).max(0.0) / 2.0;
    let (low, high) = (low - missing, high + missing);
    let padding = PADDING * (high - low);
    (low - padding, high + padding)
}

/// Multiples of 1, 2 or 5 times a power of ten, from fine to coarse.
fn even(low: f64, high: f64) -> impl Iterator<Item = Vec<Tick>> {
    let order = (high - low).log10().floor() as i32 - 1;
    let steps = (order..=order + 2).flat_map(|k| [1.0, 2.0, 5.0].map(|m| (m * power(k), k)));
    steps.map(move |(step, order)| {
        let places: Vec<f64> = multiples(low, high, step).collect();
        let size = places.iter().fold(0.0, |size: f64, place| size.max(place.abs()));
        let label = |place: f64| {
            if size < 1e6 && order >= -5 {
                return text::number(place, order.min(0).unsigned_abs() as usize);
            }
            let common = (size.log10() + 1e-9).floor() as i32;
            let decimals = (common - order).max(0).unsigned_abs();
            let mantissa = text::number(place / power(common), decimals as usize);
            format!("{mantissa}×{}", text::power_of_ten(common.into()))
        };
        places.iter().map(|&place| Tick { place, label: label(place) }).collect()
    })
}

/// Every so many powers of ten, from all to few.
fn decades(low: f64, high: f64) -> impl Iterator<Item = Vec<Tick>> {
    let steps = [1.0, 2.0, 3.0, 5.0].into_iter();
    let more = (1..).flat_map(|k| [1.0, 2.0, 5.0].map(|m| m * power(k)));
    let steps = steps.chain(more).take_while(move |step| *step < 10.0 * (high - low));
    steps.map(move |step| {
        let tick = |place: f64| Tick { place, label: text::power_of_ten(place as i64) };
        // At most so many that one too many is seen.
        multiples(low, high, step).take(MOST + 1).map(tick).collect()
    })
}

/// 1, 2 and 5 times powers of ten, if few enough.
fn within_decades(low: f64, high: f64) -> Option<Vec<Tick>> {
    let label = |digit: i32, order: i32| match order {
        0..=3 => (digit * 10_i32.pow(order.unsigned_abs())).to_string(),
        -3..0 => format!("0.{digit:0>0$}", order.unsigned_abs() as usize),
        _ if digit == 1 => text::power_of_ten(order.into()),
        _ => format!("{digit}×{}", text::power_of_ten(order.into())),
    };
    let orders = (low.floor() as i32)..=(high.floor() as i32);
    let tick = |digit: i32, order: i32| Tick {
        place: f64::from(order) + f64::from(digit).log10(),
        label: label(digit, order),
    };
    let all = |order: i32| [1, 2, 5].map(|digit| tick(digit, order));
    let within = |tick: &Tick| (low..=high).contains(&tick.place);
    let are_orders = low.abs().max(high.abs()) < f64::from(i32::MAX);
    (are_orders && high - low < 3.0).then(|| orders.flat_map(all).filter(within).collect())
}

fn multiples(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let (first, last) = ((low / step).ceil(), (high / step).floor());
    (0..=(last - first) as i64).map(move |k| (first + k as f64) * step)
}

/// A power of ten, rounded once.
fn power(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().expect("a number")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;

    fn labels(scale: Scale, places: &[f64]) -> Vec<String> {
        let ruler = Ruler::new(scale, places.iter().copied(), 300.0, |_, _| 30.0);
        ruler.ticks.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(labels(Scale::Linear, &[0.0, 1.0]), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(Scale::Linear, &[-30.0, 55.0]).first().unwrap(), "−20");
        assert_eq!(labels(Scale::Log10, &[-60.0, -1.0])[1], "10⁻⁵⁰");
        assert_eq!(labels(Scale::Approach, &[-60.0, -1.0])[1], "10⁻¹⁰");
        assert_eq!(labels(Scale::Exponent, &[-20e3, 0.0])[0], "10⁻²⁰⁰⁰⁰");
        assert_eq!(labels(Scale::Log10, &[-1.0, -1.0]), ["0.05", "0.1", "0.2"]);
        assert_eq!(labels(Scale::Log10, &[-7.3, -6.7])[1], "10⁻⁷");
        assert_eq!(labels(Scale::Log10, &[3.0, 4.2])[1], "2000");
        assert_eq!(labels(Scale::Linear, &[3e8, 5e8])[1], "3.5×10⁸");
        assert_eq!(labels(Scale::Linear, &[9e-8, 1.1e-7])[0], "0.90×10⁻⁷");
    }

    #[test]
    fn powers_beyond_all_measure_have_ticks_too() {
        let place = 2471872785.678318;
        assert!(!labels(Scale::Exponent, &[place, place * (1.0 + 1e-9)]).is_empty());
    }

    #[test]
    fn what_has_no_place_has_none() {
        assert_eq!(Scale::Log10.place(0.0), None);
        assert_eq!(Scale::Log10.place(f64::NAN), None);
        assert_eq!(Scale::Linear.place(f64::NEG_INFINITY), None);
        assert_eq!(Scale::Exponent.place(-20e3), Some(-20e3));
    }

    proptest! {
        #![proptest_config(config(256))]
        #[test]
        fn every_range_has_ticks_within(a in any::<f64>(), b in any::<f64>(), near in -17..1) {
            let b = if near < 0 { a + a * power(near) } else { b };
            for scale in [Scale::Linear, Scale::Exponent, Scale::Approach, Scale::Log10] {
                let places: Vec<f64> = [a, b].into_iter().filter_map(|v| scale.place(v)).collect();
                let ruler = Ruler::new(scale, places.iter().copied(), 300.0, |_, _| 30.0);
                let within = |share: f64| (-1e-9..=1.0 + 1e-9).contains(&share);
                prop_assert!(!ruler.ticks.is_empty() && ruler.ticks.len() <= MOST);
                prop_assert!(ruler.ticks.iter().all(|tick| within(ruler.share(tick.place))));
                prop_assert!(places.iter().all(|place| within(ruler.share(*place))));
            }
        }
    }
}
