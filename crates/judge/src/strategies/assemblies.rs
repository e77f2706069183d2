//! Assemblies drawn from a seed, each twice: above its threshold and below it.

use super::assembly::{Assembly, Base, Near, Surveyed};
use super::margin::Margin;
use super::places::{above_sliding, half_openings};
use super::sample::Draw;
use crate::arch::SelfWeight;
use crate::number::ExactNumber;
use crate::problem::Mode;
use crate::problem::measures::{Circle, Length, Measures, of_span_and_rise};
use crate::problem::stones::Stones;
use rug::Rational;
use std::f64::consts::FRAC_PI_2;

/// The fewest and the most stones.
const STONES: [u64; 2] = [2, 60];
/// Stones of an assembly whose crown can open at a limited friction: an even number.
const FEW: [u64; 2] = [2, 6];
/// Least half opening, rad.
const NARROWEST: f64 = 0.35;
/// Half opening from which the clear span at the springings says little of an arch, rad.
const HORSESHOE: f64 = 2.0;
/// Digits of a thickness that is given.
const DIGITS: usize = 3;

/// Assemblies without end, each by a margin above its threshold, where it stands, and as much below it, where it falls:
/// 2 to 60 stones, all modes, both self-weights, measured in metres or not.
///
/// ```
/// use couplet_judge::strategies::{Margin, assemblies};
/// let [above, below] = assemblies(1, Margin::default()).next().unwrap();
/// assert!(above.stands() && !below.stands());
/// ```
pub fn assemblies(seed: u64, margin: Margin) -> impl Iterator<Item = [Assembly; 2]> {
    let mut draw = Draw(seed);
    (0u64..).map(move |place| pair(&mut draw, place, margin))
}

/// A number in `[0, 1)`.
fn part(draw: &mut Draw) -> f64 {
    draw.between(0, (1 << 53) - 1) as f64 / (1u64 << 53) as f64
}

/// The assemblies above and below the threshold at a place of the turn.
pub(super) fn pair(draw: &mut Draw, place: u64, margin: Margin) -> [Assembly; 2] {
    // Each mode in its turn, and two or three stones, whatever theirs.
    let turns = Mode::ALL.len() as u64 + 1;
    let is_odd = |period: u64| (place / (turns * period)) % 2 == 1;
    let mode = Mode::ALL.get((place % turns) as usize).copied();
    let weight = SelfWeight::ALL[usize::from(is_odd(2))];
    let near = if is_odd(4) { Near::Thickness } else { Near::Friction };
    // Drawn once: of three stones far more have a threshold than of two.
    let few = draw.between(STONES[0], STONES[0] + 1);
    loop {
        if let Some(pair) = assembly(draw, (mode, near, margin), few, weight, is_odd(1)) {
            return pair;
        }
    }
}

/// An assembly of the mode, unless what is drawn collapses otherwise.
fn assembly(
    draw: &mut Draw,
    (mode, near, margin): (Option<Mode>, Near, Margin),
    few: u64,
    weight: SelfWeight,
    is_surveyed: bool,
) -> Option<[Assembly; 2]> {
    let [fewest, most] = STONES;
    let stones = match mode {
        None => few,
        Some(Mode::Overturning) => 2 * draw.between(FEW[0], FEW[1]),
        Some(_) => draw.between(fewest, most),
    };
    let widest = stones as f64 * FRAC_PI_2 / 2.0;
    let [low, high] = mode.and_then(|mode| half_openings(mode, weight)).unwrap_or([0.0, 2.6]);
    let [low, high] = [low.max(NARROWEST), high.min(widest)];
    let alpha = low + part(draw) * (high - low);
    let (half_opening, surveyed) = opening(draw, alpha, is_surveyed)?;
    let stones = Stones::equal(stones, half_opening).ok()?;
    let base = Base { weight, stones, surveyed, margin };
    let any = Rational::from((draw.between(2, 120), 100));
    let Some(mode) = mode.filter(|mode| *mode != Mode::Sliding) else {
        let pair = base.near_friction(&any, DIGITS)?;
        return (mode.is_none() || pair[0].mode == mode).then_some(pair);
    };
    let places = if is_surveyed { 2 } else { draw.between(2, 6) as usize };
    let friction = format!("{:.places$}", above_sliding(alpha, part(draw)));
    let has_slip = !matches!(mode, Mode::Rotational | Mode::Overturning);
    let pair = match near {
        Near::Friction if has_slip => base.near_friction(&base.least(&friction, mode)?, DIGITS)?,
        _ => base.near_thickness(&friction, mode)?,
    };
    (pair[0].mode == Some(mode)).then_some(pair)
}

/// A half opening near this one, as it is written, or by span and rise.
fn opening(
    draw: &mut Draw,
    alpha: f64,
    is_surveyed: bool,
) -> Option<(ExactNumber, Option<Surveyed>)> {
    if !is_surveyed {
        let text = match draw.between(0, 2) {
            0 => format!("{}deg", alpha.to_degrees().round()),
            _ => format!("{alpha:.*}", draw.between(2, 12) as usize),
        };
        return Some((text.parse().ok()?, None));
    }
    // In decimetres and centimetres, as it is surveyed.
    let span = draw.between(20, 300);
    let rise = (span as f64 * 5.0 * (alpha / 2.0).tan()).round();
    let (span, rise) = (format!("{}m", span as f64 / 10.0), format!("{}m", rise / 100.0));
    let lengths: [Length; 2] = [span.parse().ok()?, rise.parse().ok()?];
    let (half_opening, radius) = of_span_and_rise(&lengths[0], &lengths[1]);
    let circle = if alpha < HORSESHOE { Circle::Intrados } else { Circle::Centreline };
    let measures = Measures::new(circle, radius, None);
    Some((half_opening, Some(Surveyed { span, rise, measures })))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn a_seed_draws_the_same_assemblies_and_every_kind() {
        let drawn = |seed, count| -> Vec<[Assembly; 2]> {
            assemblies(seed, Margin::default()).take(count).collect()
        };
        let first = drawn(1, 32);
        let shown = |all: &[[Assembly; 2]]| format!("{all:?}");
        assert_eq!(shown(&first[..4]), shown(&drawn(1, 4)));
        assert_ne!(shown(&first[..4]), shown(&drawn(2, 4)));
        let kinds: BTreeSet<String> = first
            .iter()
            .map(|[above, _]| {
                format!("{:?} {} {}", above.mode, above.weight, above.surveyed.is_some())
            })
            .collect();
        // Seven modes, both weights, measured and not.
        assert!(kinds.len() >= 28, "{kinds:?}");
        assert!(first.iter().any(|[above, _]| above.near == Near::Thickness));
        assert!(first.iter().any(|[above, _]| above.near == Near::Friction));
    }
}
