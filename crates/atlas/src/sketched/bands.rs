//! Bands of lines of thrust of all arches of a survey, as doubles for the eye.
//!
//! A state of an arch is a thrust `h` and a crown moment `p`; its line of thrust has at a joint `beta` the radius
//! `rho = (p + fac (1 - cos beta))/N(beta)`. In a survey let the **safe arch** have the least half opening, the largest
//! friction and the largest thickness, and the **unsafe arch** the opposite; where span, rise and thickness are
//! measured neither need be one of the survey.
//!
//! **All lines.** Let an arch of the survey have a joint `beta`. Its half opening is at least `beta`, and at least that
//! of the safe arch; it has no more friction and no more thickness than this. So what it bears is borne by the safe
//! arch with the half opening `max(beta, that of the safe arch)`, of which each joint is one of its own (the claim
//! `survey-corners`). The band at `beta` therefore goes from the least `rho(beta)` of this arch's admissible states to
//! the largest. Two things are left, both of Milankovitch's weight: the `fac` of a thinner arch is less, so that the
//! lower edge takes that of the thinnest; and each line lies within its own faces, which are within those of the
//! thickest.
//!
//! **What each bears.** The states of the unsafe arch are admissible in every arch of the survey. Its own band holds
//! their lines.
//!
//! **Extremes.** The admissible states of an arch are a convex set: `h` between two ends, `p` from `lo(h)`, which is
//! convex, to `up(h)`, the lesser of two linear functions (see [`contact`]). As `N > 0`, `rho` at a joint is a quotient
//! of linear functions of `h` and `p`, which grows with `p`, and on a segment its extremes are at the ends: the largest
//! is where `up` begins, bends, or ends; the least lies on `lo`, of which so many points are looked at that no eye
//! misses one between.

use super::range::moments;
use crate::arch::{Configuration, Ring, SelfWeight, Unknown, contact, statics};
use crate::certify::Undecided;
use crate::certify::state::{Limit, assessment_enclosed, raised};
use crate::number::{Angle, Ball, Drawable, ExactNumber};
use crate::problem::Arch;
use crate::problem::survey::{Bounding, Side, Survey};
use rug::Rational;

/// Safe or unsafe arch of a survey, with a band of lines of thrust.
#[derive(Clone, Debug)]
pub struct BandedArch {
    /// The half opening, rad.
    pub half_opening: f64,
    /// The thickness, in units of `r`.
    pub thickness: f64,
    /// Joints from the crown on, rad, each with the radii of the lower and the upper edge, in units of `r`; none where
    /// no line of thrust is admissible.
    pub band: Vec<[f64; 3]>,
}

/// Digits for which an arch is proved.
const DIGITS: usize = 10;
/// Thrusts that are looked at, of a whole arch and where the half opening is another at each joint.
const THRUSTS: [u32; 2] = [64, 16];
/// Distance of two joints of a band, rad.
const STEP: f64 = 0.02;
/// Most steps beyond the least half opening.
const MOST_STEPS: f64 = 40.0;
/// Steps that are halved at the end of a band.
const HALVINGS: u32 = 12;

/// Thrust with the least and the largest crown moment that fit it.
type ThrustAt = [f64; 3];

impl BandedArch {
    /// The unsafe arch of a survey with the band of what each arch bears, and the safe one with the band of all lines;
    /// `None` for arches without a thickness.
    pub fn of(survey: &Survey) -> Result<Option<[Self; 2]>, Undecided> {
        let at = |side| {
            let Bounding { arch, thickness } =
                survey.corner(side).or_else(|| survey.beyond(side))?;
            Some((arch, thickness?))
        };
        let (Some(worst), Some(best)) = (at(Side::Unsafe), at(Side::Safe)) else {
            return Ok(None);
        };
        let thin: Ball = worst.1.enclosure(64);
        let of = |(arch, eta): &(Arch, ExactNumber)| {
            Self::new((arch, eta), thin.double(), worst.0.half_opening())
        };
        Ok(Some([of(&worst)?, of(&best)?]))
    }

    /// Band of an arch up to its own shoulder and on to that of a wider one, of which some lines may be those of arches
    /// down to a thickness.
    fn new(
        (arch, eta): (&Arch, &ExactNumber),
        thin: f64,
        wide: &ExactNumber,
    ) -> Result<Self, Undecided> {
        let [own, wide]: [Ball; 2] = [arch.half_opening(), wide].map(|alpha| alpha.enclosure(64));
        let (half_opening, wide) = (own.double(), wide.double());
        let thick: Ball = eta.enclosure(64);
        let thickness = thick.double();
        let edges = |joint: f64, states: &[ThrustAt]| {
            edges(arch.weight(), joint, [thin, thickness], states)
        };
        let mut band = Vec::new();
        if let Some(all) = states(arch, eta, THRUSTS[0])? {
            let steps = (half_opening / STEP).ceil().max(8.0);
            let joints = (0..=steps as u32).map(|k| half_opening * f64::from(k) / steps);
            band.extend(joints.map(|joint| edges(joint, &all)));
            let at = |joint: f64| {
                let alpha = Rational::from_f64(joint).map(|joint| ExactNumber::from(&joint));
                let cut = Arch::new(arch.weight(), alpha?, arch.friction().clone()).ok()?;
                // What stays open next to the widest arch that stands is seen nowhere.
                let states = states(&cut, eta, THRUSTS[1]).ok()??;
                Some(edges(joint, &states))
            };
            beyond([half_opening, wide], at, &mut band);
        }
        Ok(Self { half_opening, thickness, band })
    }
}

/// Adds the edges at joints from the first to the last, as far as there are any.
fn beyond([first, last]: [f64; 2], at: impl Fn(f64) -> Option<[f64; 3]>, band: &mut Vec<[f64; 3]>) {
    let steps = ((last - first) / STEP).ceil().min(MOST_STEPS);
    let mut reached = first;
    for k in 1..=steps.max(0.0) as u32 {
        let joint = first + (last - first) * f64::from(k) / steps;
        if let Some(edges) = at(joint) {
            band.push(edges);
            reached = joint;
            continue;
        }
        let mut open = joint;
        for _ in 0..HALVINGS {
            let middle = (reached + open) / 2.0;
            match at(middle) {
                Some(edges) => {
                    band.push(edges);
                    reached = middle;
                }
                None => open = middle,
            }
        }
        return;
    }
}

/// Admissible states of an arch, at some thrusts from the least to the largest; none if it does not stand.
fn states(
    arch: &Arch,
    eta: &ExactNumber,
    thrusts: u32,
) -> Result<Option<Vec<ThrustAt>>, Undecided> {
    raised(arch, DIGITS, |bits| {
        let found = assessment_enclosed(arch, eta, bits);
        if !found.stands.clone()? {
            return Ok(Some(None));
        }
        let [least, largest] = found.thrust;
        let bound = |limit: Option<Limit>| Some(limit?.thrust?.double());
        let (least, largest) = (bound(least?).unwrap_or(0.0), bound(largest?));
        let at = arch.given(bits).with(Unknown::Thickness, eta.enclosure::<Ball>(bits));
        let of =
            |thrust: f64| Configuration { thrust: at.thickness.of_double(thrust), ..at.clone() };
        let share = |k: u32| f64::from(k) / f64::from(thrusts);
        let thrust = |k| match largest {
            Some(largest) => least + (largest - least) * share(k),
            // Without a bound the lines come near to straight ones.
            None => least + share(k) / (1.01 - share(k)),
        };
        let mut all: Vec<f64> = (0..=thrusts).map(thrust).collect();
        all.extend(bend(arch.weight(), [all[0], all[all.len() - 1]], of));
        let state = |thrust: f64| {
            let [lower, upper] = moments(arch.weight(), &of(thrust)).ok()?;
            Some([thrust, lower.double(), upper.double()])
        };
        Ok(Some(Some(all.into_iter().filter_map(state).collect())))
    })
}

/// The thrust between two others where the crown's extrados and the shoulder's bound the crown moment alike.
fn bend(
    weight: SelfWeight,
    [least, largest]: [f64; 2],
    of: impl Fn(f64) -> Configuration<Ball>,
) -> Option<f64> {
    let difference = |thrust: f64| {
        let at = of(thrust);
        (contact::crown_moment(&at) - contact::shoulder_moment(weight, &at)).double()
    };
    let [first, last] = [least, largest].map(difference);
    (first * last < 0.0).then(|| least + (largest - least) * first / (first - last))
}

/// A joint with the least and the largest radius there of lines of thrust of these states, in arches from the thinnest
/// to the thickest.
fn edges(weight: SelfWeight, joint: f64, etas: [f64; 2], states: &[ThrustAt]) -> [f64; 3] {
    let [thin, thick] = etas.map(|eta| Ring::new(weight, &eta).centroid_factor);
    let faces = [1.0 - etas[1] / 2.0, 1.0 + etas[1] / 2.0];
    let angle = Angle::new(joint);
    let radius = |h: f64, p: f64, fac: f64| statics::pressure_radius(&angle, &h, &p, &fac);
    let lower = states.iter().map(|[h, p, _]| radius(*h, *p, thin)).fold(faces[1], f64::min);
    let upper = states.iter().map(|[h, _, p]| radius(*h, *p, thick)).fold(faces[0], f64::max);
    [joint, lower.max(faces[0]), upper.min(faces[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Sketch;
    use crate::certify::state::find::{Finding, Question, find};
    use crate::problem::survey::Shape;

    fn survey(weight: SelfWeight, alpha: [&str; 2], mu: [&str; 2], eta: [&str; 2]) -> Survey {
        let numbers = |range: [&str; 2]| range.map(|x| x.parse().unwrap());
        let shape = Shape::Free { half_opening: numbers(alpha), thickness: Some(numbers(eta)) };
        Survey::new(weight, mu.map(|x| x.parse().unwrap()), shape).unwrap()
    }

    /// Edges between two joints of a band.
    fn between(band: &[[f64; 3]], joint: f64) -> Option<[f64; 2]> {
        let after = band.iter().position(|[at, ..]| *at >= joint)?;
        let (a, b) = (band[after.max(1) - 1], band[after.max(1)]);
        let share = (joint - a[0]) / (b[0] - a[0]);
        Some([1, 2].map(|k| a[k] + share * (b[k] - a[k])))
    }

    /// The most by which a line of an arch is outside a band.
    fn outside(band: &[[f64; 3]], sketch: &Sketch) -> f64 {
        let lines = sketch.forces.iter().flat_map(|of| &of.thrust_lines);
        let off = lines.flat_map(|line| &line.points).map(|[joint, offset]| {
            let radius = 1.0 + offset * sketch.thickness();
            between(band, *joint)
                .map_or(f64::INFINITY, |[lower, upper]| (lower - radius).max(radius - upper))
        });
        off.fold(0.0, f64::max)
    }

    /// The extreme lines of the arches of a grid lie in the band, joint by joint; those of an arch that is no part of
    /// the survey do not.
    #[test]
    fn every_line_of_every_arch_lies_in_the_band() {
        for weight in SelfWeight::ALL {
            let all = survey(weight, ["1.2", "1.5"], ["0.5", "0.9"], ["0.15", "0.3"]);
            let [worst, best] = BandedArch::of(&all).unwrap().unwrap();
            for alpha in ["1.2", "1.31", "1.5"] {
                for mu in ["0.5", "0.6", "0.9"] {
                    for eta in ["0.15", "0.22", "0.3"] {
                        let arch = Arch::parse(weight.name(), alpha, mu).unwrap();
                        let sketch = Sketch::standing(&arch, &eta.parse().unwrap(), false);
                        let off = outside(&best.band, &sketch.unwrap());
                        assert!(off < 3e-4, "{arch} {eta}: {off}");
                    }
                }
            }
            let rough = Arch::parse(weight.name(), "0.9", "1.5").unwrap();
            let sketch = Sketch::standing(&rough, &"0.4".parse().unwrap(), false).unwrap();
            assert!(outside(&best.band, &sketch) > 1e-2);
            // What each bears is borne by the safe arch.
            for [joint, lower, upper] in &worst.band {
                let edges = between(&best.band, joint.min(1.5 - 1e-9)).unwrap();
                assert!(edges[0] < lower + 3e-4 && upper - 3e-4 < edges[1], "{joint}");
            }
        }
    }

    /// No arch so wide stands: the band ends at the widest that does.
    #[test]
    fn a_band_ends_where_no_arch_stands() {
        let all = survey(SelfWeight::Heyman, ["1", "2"], ["0.4", "0.6"], ["0.05", "0.1"]);
        let [worst, best] = BandedArch::of(&all).unwrap().unwrap();
        assert!(worst.band.is_empty());
        let [last, ..] = best.band[best.band.len() - 1];
        let (friction, thickness) = ("0.6".parse().unwrap(), Some("0.1".parse().unwrap()));
        let question = Question::HalfOpening { friction, thickness };
        let found = find(SelfWeight::Heyman, &question, 8).unwrap();
        let Finding::Found(found) = found else { panic!("{found:?}") };
        assert!((last - found.figures[0].1.double).abs() < 1e-4, "{last}");
    }

    /// Flat enough an arch bears any thrust: the band has edges all the same.
    #[test]
    fn a_thrust_without_bound_has_a_band() {
        let all = survey(SelfWeight::Milankovitch, ["0.3", "0.35"], ["0.5", "inf"], ["0.2", "0.3"]);
        for of in BandedArch::of(&all).unwrap().unwrap() {
            assert!(of.band.len() > 8);
            assert!(of.band.iter().all(|[_, lower, upper]| lower < upper), "{of:?}");
        }
    }
}
