//! Part of a survey that stands, between two proved bounds.
//!
//! Every measure is taken to be spread evenly between its ends, which says nothing of how likely an arch is. The box of
//! all measures but the thickness is cut into boxes; in each the arches of the [two sides](Side) say from which
//! thickness on all of its arches stand, and up to which none does. Where these have states of one mode and all least
//! thicknesses lie within the range, the share is that of their [mean](super::mean), which is known more closely. The
//! box that leaves most open is halved until little is open in all.

use super::largest::Largest;
use super::mean::least_thicknesses;
use crate::certify::state::{Certify, Outcome, state_enclosed};
use crate::number::{Ball, Decimal, DoubleBall, Enclosure, ExactNumber, Form, Rounded};
use crate::problem::measures::{Length, of_span_and_rise};
use crate::problem::survey::{Shape, Side, Survey};
use crate::problem::{Arch, Friction};
use crate::prover::Undecided;
use num_bigint::BigInt;
use num_rational::BigRational;
use rug::Float;
use rug::float::Round;
use std::collections::BinaryHeap;

/// Part of a survey that stands, from 0 to 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Share {
    /// No less stands, rounded down.
    pub lower: Decimal,
    /// No more stands, rounded up.
    pub upper: Decimal,
}

/// Digits of the bounds.
const DIGITS: usize = 4;

/// Distance between the bounds that is aimed at.
const NEAR: f64 = 1e-3;
/// Most boxes that are halved: some seconds, more where each has the measures of a circle.
const MOST_HALVINGS: usize = 30_000;
const MOST_MEASURED_HALVINGS: usize = 8_000;
/// Bits of the values.
const BITS: u32 = 100;

/// Box of a survey with the shares of its thicknesses that stand in all of its arches, and in any.
struct Cell {
    survey: Survey,
    /// Halvings that led to it: its part of the whole is a power of two.
    depth: i32,
    stands: [f64; 2],
}

impl Cell {
    fn part(&self) -> f64 {
        0.5f64.powi(self.depth)
    }

    fn gap(&self) -> f64 {
        (self.stands[1] - self.stands[0]) * self.part()
    }
}

/// A box by what it leaves open.
fn open_by_gap(cell: Cell) -> Largest<Cell> {
    Largest { size: cell.gap(), of: cell }
}

/// The part of a survey's arches that stands, to about a thousandth; to wider bounds where too many boxes would have to
/// be looked at. Undecided if the survey has no thickness, or if the ends of a range have no number midway: an angle in
/// degrees and one in radians, or unlimited friction.
pub fn share(survey: &Survey) -> Result<Share, Undecided> {
    share_to(survey, NEAR)
}

/// The part that stands, to bounds so far apart.
fn share_to(survey: &Survey, near: f64) -> Result<Share, Undecided> {
    let whole = Cell { survey: survey.clone(), depth: 0, stands: closer(survey, stands(survey)?) };
    let mut settled = [0.0f64; 2];
    let mut gap = whole.gap();
    let mut open = BinaryHeap::from([open_by_gap(whole)]);
    let most = match survey.shape() {
        Shape::Free { .. } => MOST_HALVINGS,
        Shape::Spanned { .. } => MOST_MEASURED_HALVINGS,
    };
    for _ in 0..most {
        if gap <= near {
            break;
        }
        let Some(Largest { of: cell, .. }) = open.pop() else { break };
        gap -= cell.gap();
        for (survey, stands) in best_halves(&cell.survey)? {
            let stands = closer(&survey, stands);
            let half = Cell { survey, stands, depth: cell.depth + 1 };
            gap += half.gap();
            if half.stands[0] == half.stands[1] {
                settled = add(settled, &half);
            } else {
                open.push(open_by_gap(half));
            }
        }
    }
    let [lower, upper] = open.iter().fold(settled, |sum, cell| add(sum, &cell.of));
    let rounded = |x: f64| {
        let exact = Float::with_val(53, x).to_rational();
        exact.and_then(|exact| Rounded::from_rational(&exact, DIGITS))
    };
    let bounds = rounded(lower.max(0.0)).zip(rounded(upper.min(1.0)));
    let (lower, upper) = bounds.ok_or_else(|| Undecided::rounding("the rounding of the share"))?;
    Ok(Share { lower: lower.lower, upper: upper.upper })
}

/// Adds the shares of a box, rounded outwards.
fn add([lower, upper]: [f64; 2], cell: &Cell) -> [f64; 2] {
    let [all, any] = cell.stands.map(|x| x * cell.part());
    [(lower + all).next_down().max(0.0), (upper + any).next_up()]
}

/// Shares of the thicknesses with which all arches of a survey stand, and with which any does.
fn stands(survey: &Survey) -> Result<[f64; 2], Undecided> {
    let least = |side| least(survey, side);
    let missing = || Undecided::new("a survey without thickness has no part that stands");
    let [thin, thick] = thicknesses(survey).ok_or_else(missing)?;
    let is_one = match survey.shape() {
        Shape::Free { thickness: Some([a, b]), .. } => a.factor() == b.factor(),
        Shape::Free { .. } => true,
        Shape::Spanned { thickness: [a, b], .. } => a.metres() == b.metres(),
    };
    // What is not proved leaves everything open.
    let shares = [Side::Unsafe, Side::Safe].map(|side| match least(side) {
        Err(_) => [0.0, 1.0],
        Ok(None) => [0.0, 0.0],
        Ok(Some(least)) if is_one => {
            let room = thin.clone() - least;
            [
                f64::from(room.is_positive().is_proved()),
                f64::from(!(-room).is_positive().is_proved()),
            ]
        }
        Ok(Some(least)) => {
            let share = (thick.clone() - least) / (thick.clone() - &thin);
            let ends =
                [share.lower().to_f64_round(Round::Down), share.upper().to_f64_round(Round::Up)];
            ends.map(|end| end.clamp(0.0, 1.0))
        }
    });
    Ok([shares[0][0], shares[1][1].max(shares[0][0])])
}

/// Shares of a survey's thicknesses, closer than these where all of its arches have states of one mode and a least
/// thickness within the range: there the share is that of the mean.
fn closer(survey: &Survey, [all, any]: [f64; 2]) -> [f64; 2] {
    let share = || {
        let ends: [DoubleBall; 2] = thicknesses(survey)?.each_ref().map(DoubleBall::from);
        let [thin, thick] = ends;
        let least = least_thicknesses(survey)?;
        let is_within = [least.all - thin, thick - least.all];
        let is_proved = is_within.iter().all(|x| x.is_positive().is_proved());
        is_proved.then(|| (thick - least.mean) / (thick - thin))
    };
    match share() {
        Some(share) if all < any => [share.lower().max(all), share.upper().min(any)],
        _ => [all, any],
    }
}

/// Thinnest and thickest arch of a survey: ratios, or in metres.
fn thicknesses(survey: &Survey) -> Option<[Ball; 2]> {
    match survey.shape() {
        Shape::Free { thickness, .. } => {
            thickness.as_ref().map(|range| range.each_ref().map(|x| x.enclosure(BITS)))
        }
        Shape::Spanned { thickness, .. } => Some(thickness.each_ref().map(metres)),
    }
}

fn metres(length: &Length) -> Ball {
    ExactNumber::rational(length.metres().clone()).enclosure(BITS)
}

/// Thickness from which the arches of a side stand: its ratio, or in metres; `None` if none is enough.
fn least(survey: &Survey, side: Side) -> Result<Option<Ball>, Undecided> {
    if let Some(corner) = survey.corner(side) {
        return least_of(&corner.arch);
    }
    let decisive = || {
        let place = survey.decisive(side)?;
        let arch = survey.bounding(side, [&place; 2])?.arch;
        let [span, rise] = place.map(Length::of_metres);
        let (_, radius) = of_span_and_rise(&span?, &rise?);
        Some((arch, radius, survey.thickness_at(side)?.0))
    };
    let (arch, radius, circle) = decisive().ok_or_else(Undecided::no_solution)?;
    let Some(least) = least_of(&arch)? else { return Ok(None) };
    Ok(Some(circle.centreline(metres(&radius), &least) * least))
}

/// Least thickness of an arch.
fn least_of(arch: &Arch) -> Result<Option<Ball>, Undecided> {
    let in_doubles = arch.state_in_doubles();
    Ok(match in_doubles {
        Ok(Outcome::Stands(state)) => {
            let end = |x: f64| Ball::exact(Float::with_val(BITS, x), BITS);
            Some(end(state.thickness.lower()).hull(&end(state.thickness.upper())))
        }
        Ok(Outcome::Falls(_)) => None,
        Err(_) => match state_enclosed(arch, BITS, false)? {
            Outcome::Stands(state) => Some(state.thickness),
            Outcome::Falls(_) => None,
        },
    })
}

/// Range that is halved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Across {
    Friction,
    HalfOpening,
    Span,
    Rise,
}

/// Half of a survey, with its shares.
type Half = (Survey, [f64; 2]);

/// The two halves of a survey that leave least open together.
fn best_halves(survey: &Survey) -> Result<[Half; 2], Undecided> {
    let ranges: &[Across] = match survey.shape() {
        Shape::Free { .. } => &[Across::HalfOpening, Across::Friction],
        Shape::Spanned { .. } => &[Across::Span, Across::Rise, Across::Friction],
    };
    let mut best: Option<(f64, [Half; 2])> = None;
    for across in ranges {
        let Some([first, second]) = halves(survey, *across)? else { continue };
        let (one, other) = (stands(&first)?, stands(&second)?);
        let gap = one[1] - one[0] + other[1] - other[0];
        if best.as_ref().is_none_or(|(least, _)| gap < *least) {
            best = Some((gap, [(first, one), (second, other)]));
        }
    }
    best.map(|(_, halves)| halves).ok_or_else(no_middle)
}

/// Two halves of a survey across a range; `None` if that is one number.
fn halves(survey: &Survey, across: Across) -> Result<Option<[Survey; 2]>, Undecided> {
    let of = |friction: &[Friction; 2], shape: Shape| {
        Survey::new(survey.weight(), friction.clone(), shape)
            .map_err(|_| Undecided::new("whether half of a range is one"))
    };
    let (mus, shape) = (survey.friction(), survey.shape());
    let [first, second] = match (across, shape) {
        (Across::Friction, _) => {
            let middle = match mus {
                [a, b] if a == b => return Ok(None),
                [Friction::Coefficient(a), Friction::Coefficient(b)] => {
                    middle(a, b)?.map(Friction::Coefficient)
                }
                [Friction::Angle(a), Friction::Angle(b)] => middle(a, b)?.map(Friction::Angle),
                _ => return Err(no_middle()),
            };
            let Some(middle) = middle else { return Ok(None) };
            let [a, b] = mus.clone();
            let parts = [[a, middle.clone()], [middle, b]];
            parts.map(|friction| of(&friction, shape.clone()))
        }
        (Across::HalfOpening, Shape::Free { half_opening: [a, b], thickness }) => {
            let Some(middle) = middle(a, b)? else { return Ok(None) };
            let parts = [[a.clone(), middle.clone()], [middle, b.clone()]];
            parts.map(|half_opening| {
                of(mus, Shape::Free { half_opening, thickness: thickness.clone() })
            })
        }
        (across, Shape::Spanned { circle, span, rise, thickness }) => {
            let [a, b] = if across == Across::Span { span } else { rise };
            let middle = (a.metres() + b.metres()) / BigInt::from(2);
            let Some(middle) = Length::of_metres(middle).filter(|_| a != b) else {
                return Ok(None);
            };
            [[a.clone(), middle.clone()], [middle, b.clone()]].map(|half| {
                let [span, rise] = match across {
                    Across::Span => [half, rise.clone()],
                    _ => [span.clone(), half],
                };
                let thickness = thickness.clone();
                of(mus, Shape::Spanned { circle: *circle, span, rise, thickness })
            })
        }
        (_, Shape::Free { .. }) => return Ok(None),
    };
    Ok(Some([first?, second?]))
}

/// Number midway between the ends of a range; `None` if they are one.
fn middle(first: &ExactNumber, last: &ExactNumber) -> Result<Option<ExactNumber>, Undecided> {
    if first.form() == last.form() && first.factor() == last.factor() {
        return Ok(None);
    }
    if first.form() != last.form() || first.form() == Form::TwiceArctangent {
        return Err(no_middle());
    }
    let middle: BigRational = (first.factor() + last.factor()) / BigInt::from(2);
    let (numerator, denominator) = middle.into_raw();
    Ok(ExactNumber::fraction(numerator, denominator, first.form()))
}

fn no_middle() -> Undecided {
    Undecided::new(
        "a range whose ends have no number midway: give both in one unit, and a friction with a limit",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::certify::state::Balls;
    use crate::problem::measures::{Circle, Measures};

    /// Debug builds are slow, and a thousandth of three ranges takes seconds.
    const TENFOLD: f64 = 10.0;

    /// Bounds as doubles.
    #[derive(Debug)]
    struct Bounds {
        lower: f64,
        upper: f64,
    }

    fn doubles(share: Share) -> Bounds {
        let [lower, upper] = [share.lower, share.upper].map(|x| x.to_rational().to_f64());
        Bounds { lower, upper }
    }

    fn of(alpha: [&str; 2], mu: [&str; 2], eta: [&str; 2]) -> Result<Bounds, Undecided> {
        let shape = Shape::Free {
            half_opening: alpha.map(|x| x.parse().unwrap()),
            thickness: Some(eta.map(|x| x.parse().unwrap())),
        };
        let survey = Survey::new(SelfWeight::Heyman, mu.map(|x| x.parse().unwrap()), shape);
        share_to(&survey.unwrap(), TENFOLD * NEAR).map(doubles)
    }

    #[test]
    fn the_share_of_a_range_of_thicknesses_is_known() {
        let least = Arch::parse("heyman", "pi/2", "inf").unwrap().least(10).unwrap();
        let expected = (0.2 - least.thickness.double) / 0.1;
        let found = of(["pi/2", "pi/2"], ["inf", "inf"], ["0.1", "0.2"]).unwrap();
        assert!(found.lower <= expected && expected <= found.upper, "{found:?} {expected}");
        assert!(found.upper - found.lower < 1.001e-4, "{found:?}");
    }

    /// Against a grid of arches, whose share differs by what the cells on the border hold at most.
    #[test]
    fn the_share_of_a_box_is_that_of_a_fine_grid() {
        let found = of(["1.4", "1.6"], ["0.36", "0.4"], ["0.09", "0.13"]).unwrap();
        assert!(found.upper - found.lower <= 1.02e-2, "{found:?}");
        let (mut sum, n) = (0.0, 24);
        for i in 0..n {
            for j in 0..n {
                let at = |k: i32| (f64::from(k) + 0.5) / f64::from(n);
                let arch =
                    Arch::from_doubles(SelfWeight::Heyman, 1.4 + 0.2 * at(i), 0.36 + 0.04 * at(j));
                let Ok(state) = arch.unwrap().least(8) else { continue };
                sum += ((0.13 - state.thickness.double) / 0.04).clamp(0.0, 1.0);
            }
        }
        let expected = sum / f64::from(n * n);
        assert!(
            (found.lower - 2e-3..found.upper + 2e-3).contains(&expected),
            "{found:?} {expected}"
        );
    }

    #[test]
    fn the_share_of_measured_arches_is_that_of_a_grid() {
        let lengths = |range: [&str; 2]| range.map(|x| x.parse::<Length>().unwrap());
        let (span, rise) = (lengths(["9.5m", "10.5m"]), lengths(["3m", "3m"]));
        let shape = Shape::Spanned {
            circle: Circle::Intrados,
            span,
            rise: rise.clone(),
            thickness: lengths(["10cm", "20cm"]),
        };
        let mus = ["0.5".parse().unwrap(), "0.5".parse().unwrap()];
        let found = share(&Survey::new(SelfWeight::Heyman, mus, shape).unwrap());
        let found = doubles(found.unwrap());
        assert!(found.upper - found.lower <= 1.201e-3, "{found:?}");
        let n = 40;
        let mut stand = 0;
        for i in 0..n {
            for j in 0..n {
                let span: Length =
                    format!("{}m", 9.5 + (f64::from(i) + 0.5) / f64::from(n)).parse().unwrap();
                let t = 0.1 + 0.1 * (f64::from(j) + 0.5) / f64::from(n);
                let (alpha, radius) = of_span_and_rise(&span, &rise[0]);
                let eta = Measures::new(Circle::Intrados, radius, None)
                    .thickness(&format!("{t}m").parse().unwrap())
                    .unwrap();
                let arch = Arch::new(SelfWeight::Heyman, alpha, "0.5".parse().unwrap()).unwrap();
                stand +=
                    i32::from(Balls::DoubleDoubles.assess(&arch, &eta, 6).unwrap().stands.unwrap());
            }
        }
        let expected = f64::from(stand) / f64::from(n * n);
        assert!(
            (found.lower - 0.02..found.upper + 0.02).contains(&expected),
            "{found:?} {expected}"
        );
        assert!(found.lower > 0.0 && found.upper < 1.0, "{found:?}");
    }

    #[test]
    fn a_range_without_middle_has_no_share() {
        for (alpha, mu) in [(["80deg", "1.5"], ["0.5", "0.6"]), (["1", "1"], ["0.05", "inf"])] {
            assert!(of(alpha, mu, ["0.001", "0.09"]).is_err());
        }
    }
}
