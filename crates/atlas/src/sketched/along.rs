//! The modes that an arch of one half opening passes as its friction grows, each at a friction of its own.

use super::{NoSketch, Sketch};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{Ball, Drawable, ExactNumber};
use crate::problem::{Arch, Friction, Mode};
use crate::{Contour, Level, NoLevel, Part, Place};

/// An arch in one of the modes, and the frictions between which it collapses so: where the mode changes, proved, or
/// `None` where the range ends that is looked at.
#[derive(Clone, Debug)]
pub struct Passed {
    /// The arch, at a friction between.
    pub sketch: Sketch,
    /// The frictions.
    pub between: [Option<Ball>; 2],
}

/// Half-width of the tubes of the line of the half opening: only its ends are asked for.
const TOLERANCE: f64 = 1e-3;
/// Decimals of the middle of a range, counted from its width.
const FINER: i32 = 2;

impl Passed {
    /// The modes of a half opening between two frictions, from the least on; before the first nothing stands.
    pub fn along_friction(
        weight: SelfWeight,
        half_opening: &ExactNumber,
        [from, to]: [f64; 2],
    ) -> Result<Vec<Self>, NoSketch> {
        let level = Level::new(weight, &Contour::HalfOpening(half_opening.clone()), TOLERANCE);
        let level = level.map_err(|none| match none {
            NoLevel::Undecided(of, open) => NoSketch::Undecided(open.about(&of)),
            NoLevel::Outside(_) => NoSketch::TooWide(half_opening.to_string()),
        })?;
        if level.has_gap() {
            return Err(Undecided::new("the modes along the whole range of friction").into());
        }
        let stands = |part: &&Part| part.mode != Mode::Sliding;
        let end = |place: &Place| place.friction.clone().filter(|_| !place.is_unlimited);
        let parts = level.parts.iter().filter(stands);
        let mut all: Vec<(Option<Mode>, [Option<Ball>; 2])> =
            parts.map(|part| (Some(part.mode), part.ends().each_ref().map(end))).collect();
        let first = all.first().and_then(|(_, [from, _])| from.clone());
        all.insert(0, (None, [None, first]));
        let seen = |(mode, between): (Option<Mode>, [Option<Ball>; 2])| {
            let [low, high] = between.each_ref().map(|end| end.as_ref().map(Drawable::double));
            let ends = [low.map_or(from, |x| x.max(from)), high.map_or(to, |x| x.min(to))];
            (ends[0] < ends[1]).then(|| {
                let arch = Arch::new(weight, half_opening.clone(), middle(ends)?);
                let sketch = Sketch::least(&arch.map_err(|_| outside())?, false)?;
                let is_it = match mode {
                    Some(mode) => sketch.collapses.iter().any(|found| found.mode == mode),
                    None => sketch.falls(),
                };
                let within = [low.filter(|x| *x > from), high.filter(|x| *x < to)];
                let between = [0, 1].map(|k| between[k].clone().filter(|_| within[k].is_some()));
                is_it.then_some(Self { sketch, between }).ok_or_else(|| outside().into())
            })
        };
        all.into_iter().filter_map(seen).collect()
    }
}

fn outside() -> Undecided {
    Undecided::new("a friction at which the arch collapses so")
}

/// A short decimal near the middle of a range.
fn middle([low, high]: [f64; 2]) -> Result<Friction, Undecided> {
    let decimals = (FINER - (high - low).log10().floor() as i32).max(0) as usize;
    let text = format!("{:.decimals$}", (low + high) / 2.0);
    text.parse().map_err(|_| outside())
}
