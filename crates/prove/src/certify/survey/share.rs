//! Part of a survey that stands, between two proved bounds.
//!
//! Every measure is taken to be spread evenly between its ends, which says nothing of how likely an arch is. The box of
//! all measures but the thickness is cut into boxes; in each the arches of the [two sides](Side) say from which thickness
//! on all of its arches stand, and up to which none does. The box that leaves most open is halved until little is open in
//! all.

use crate::certify::state::{Outcome, state_enclosed};
use crate::number::{Ball, DoubleBall, Enclosure, ExactNumber, Field, Form};
use crate::problem::Friction;
use crate::problem::measures::Length;
use crate::problem::survey::{Bounding, Shape, Side, Survey};
use crate::prover::Undecided;
use num_bigint::BigInt;
use num_rational::BigRational;
use rug::float::Round;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Part of a survey that stands, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// No less stands.
    pub lower: f64,
    /// No more stands.
    pub upper: f64,
}

/// Distance between the bounds that is aimed at.
const NEAR: f64 = 1e-3;
/// Most boxes that are halved.
const MOST_HALVINGS: usize = 150_000;
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

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.gap().total_cmp(&other.gap())
    }
}

/// The part of a survey's arches that stands, to about a thousandth; wider bounds where too many boxes would have to be
/// looked at. Undecided if the survey has no thickness, or if the ends of a range have no number midway: an angle in
/// degrees and one in radians, or unlimited friction.
pub fn share(survey: &Survey) -> Result<Share, Undecided> {
    let whole = Cell { survey: survey.clone(), depth: 0, stands: stands(survey)? };
    let mut settled = [0.0f64; 2];
    let mut open = BinaryHeap::from([whole]);
    let mut gap = open.peek().map_or(0.0, Cell::gap);
    for _ in 0..MOST_HALVINGS {
        if gap <= NEAR {
            break;
        }
        let Some(cell) = open.pop() else { break };
        gap -= cell.gap();
        for half in halves(&cell.survey)? {
            let half = Cell { stands: stands(&half)?, survey: half, depth: cell.depth + 1 };
            gap += half.gap();
            if half.stands[0] == half.stands[1] {
                settled = add(settled, &half);
            } else {
                open.push(half);
            }
        }
    }
    let [lower, upper] = open.iter().fold(settled, add);
    Ok(Share { lower: lower.max(0.0), upper: upper.min(1.0) })
}

/// Adds the shares of a box, rounded outwards.
fn add([lower, upper]: [f64; 2], cell: &Cell) -> [f64; 2] {
    let [all, any] = cell.stands.map(|x| x * cell.part());
    [(lower + all).next_down().max(0.0), (upper + any).next_up()]
}

/// Shares of the thicknesses with which all arches of a survey stand, and with which any does.
fn stands(survey: &Survey) -> Result<[f64; 2], Undecided> {
    let least = |side| least(survey, side);
    let [thin, thick]: [Ball; 2] = match survey.shape() {
        Shape::Free { thickness: Some(range), .. } => range.each_ref().map(|x| x.enclosure(BITS)),
        Shape::Spanned { thickness, .. } => thickness.each_ref().map(|x| metres(x)),
        Shape::Free { thickness: None, .. } => {
            return Err(Undecided::new("a survey without thickness has no part that stands"));
        }
    };
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

fn metres(length: &Length) -> Ball {
    ExactNumber::rational(length.metres().clone()).enclosure(BITS)
}

/// Thickness from which the arches of a side stand: its ratio, or in metres; `None` if none is enough.
fn least(survey: &Survey, side: Side) -> Result<Option<Ball>, Undecided> {
    let state = |of: &Bounding| match state_enclosed(&of.arch, BITS, false)? {
        Outcome::Stands(state) => Ok::<_, Undecided>(Some(state.thickness)),
        Outcome::Falls(_) => Ok(None),
    };
    if let Some(corner) = survey.corner(side) {
        return state(&corner);
    }
    let bounding = survey.outermost(side).ok_or_else(Undecided::no_solution)?;
    let (arch, radius, circle) = bounding;
    let Some(least) = state(&Bounding { arch, thickness: None })? else { return Ok(None) };
    let radius = metres(&radius);
    let half = least.ratio(circle.to_centreline(), 2);
    Ok(Some(least.clone() * radius / (least.int(1) - half * least)))
}

/// Two halves of a survey, across the range that is widest as an angle or over its size.
fn halves(survey: &Survey) -> Result<[Survey; 2], Undecided> {
    let double = |x: &ExactNumber| x.enclosure::<DoubleBall>(53).mid();
    let apart = |[a, b]: [f64; 2]| (b - a) / (a.abs() + b.abs()).max(f64::MIN_POSITIVE);
    let lengths = |range: &[Length; 2]| {
        apart(range.each_ref().map(|x| double(&ExactNumber::rational(x.metres().clone()))))
    };
    let mus = survey.friction();
    let by_friction = match mus {
        [Friction::Coefficient(a), Friction::Coefficient(b)]
        | [Friction::Angle(a), Friction::Angle(b)] => apart([double(a), double(b)]),
        [Friction::Infinite, Friction::Infinite] => 0.0,
        _ => f64::INFINITY,
    };
    let of = |friction: [Friction; 2], shape: Shape| {
        Survey::new(survey.weight(), friction, shape)
            .map_err(|_| Undecided::new("whether half of a range is one"))
    };
    let by_shape = match survey.shape() {
        Shape::Free { half_opening, .. } => apart(half_opening.each_ref().map(double)),
        Shape::Spanned { span, rise, .. } => lengths(span).max(lengths(rise)),
    };
    if by_friction > by_shape {
        let [first, middle, last] = match mus {
            [Friction::Coefficient(a), Friction::Coefficient(b)] => {
                thirds(a, b)?.map(Friction::Coefficient)
            }
            [Friction::Angle(a), Friction::Angle(b)] => thirds(a, b)?.map(Friction::Angle),
            _ => return Err(no_middle()),
        };
        let shape = survey.shape();
        return Ok([
            of([first, middle.clone()], shape.clone())?,
            of([middle, last], shape.clone())?,
        ]);
    }
    let parts = match survey.shape() {
        Shape::Free { half_opening: [a, b], thickness } => {
            let [first, middle, last] = thirds(a, b)?;
            [[first, middle.clone()], [middle, last]]
                .map(|half_opening| Shape::Free { half_opening, thickness: thickness.clone() })
        }
        Shape::Spanned { circle, span, rise, thickness } => {
            let by_span = lengths(span) >= lengths(rise);
            let [a, b] = if by_span { span } else { rise };
            let middle = Length::of_metres((a.metres() + b.metres()) / BigInt::from(2));
            let middle = middle.ok_or_else(no_middle)?;
            [[a.clone(), middle.clone()], [middle, b.clone()]].map(|half| {
                let [span, rise] = match by_span {
                    true => [half, rise.clone()],
                    false => [span.clone(), half],
                };
                Shape::Spanned { circle: *circle, span, rise, thickness: thickness.clone() }
            })
        }
    };
    let [first, second] = parts.map(|shape| of(mus.clone(), shape));
    Ok([first?, second?])
}

/// First end, middle and last end of a range.
fn thirds(first: &ExactNumber, last: &ExactNumber) -> Result<[ExactNumber; 3], Undecided> {
    let middle: BigRational = (first.factor() + last.factor()) / BigInt::from(2);
    let [numerator, denominator] = [middle.numer().clone(), middle.denom().clone()];
    let is_even = first.form() == last.form() && first.form() != Form::TwiceArctangent;
    let middle = is_even.then(|| ExactNumber::fraction(numerator, denominator, first.form()));
    let middle = middle.flatten().ok_or_else(no_middle)?;
    Ok([first.clone(), middle, last.clone()])
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
    use crate::certify::state::{Balls, Certify};
    use crate::problem::Arch;
    use crate::problem::measures::{Circle, Measures, of_span_and_rise};

    fn of(alpha: [&str; 2], mu: [&str; 2], eta: [&str; 2]) -> Result<Share, Undecided> {
        let shape = Shape::Free {
            half_opening: alpha.map(|x| x.parse().unwrap()),
            thickness: Some(eta.map(|x| x.parse().unwrap())),
        };
        share(&Survey::new(SelfWeight::Heyman, mu.map(|x| x.parse().unwrap()), shape).unwrap())
    }

    #[test]
    fn the_share_of_a_range_of_thicknesses_is_known() {
        let least = Arch::parse("heyman", "pi/2", "inf").unwrap().least(10).unwrap();
        let expected = (0.2 - least.thickness.double) / 0.1;
        let found = of(["pi/2", "pi/2"], ["inf", "inf"], ["0.1", "0.2"]).unwrap();
        assert!(found.lower <= expected && expected <= found.upper, "{found:?} {expected}");
        assert!(found.upper - found.lower < 1e-12, "{found:?}");
    }

    /// Against a grid of arches, whose share differs by what the cells on the border hold at most.
    #[test]
    fn the_share_of_a_box_is_that_of_a_fine_grid() {
        let found = of(["1.4", "1.6"], ["0.33", "0.5"], ["0.09", "0.13"]).unwrap();
        assert!(found.upper - found.lower <= 1.001e-3, "{found:?}");
        let (mut sum, n) = (0.0, 24);
        for i in 0..n {
            for j in 0..n {
                let at = |k: i32| (f64::from(k) + 0.5) / f64::from(n);
                let arch =
                    Arch::from_doubles(SelfWeight::Heyman, 1.4 + 0.2 * at(i), 0.33 + 0.17 * at(j));
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
            thickness: lengths(["20cm", "30cm"]),
        };
        let mus = ["0.5".parse().unwrap(), "0.5".parse().unwrap()];
        let found = share(&Survey::new(SelfWeight::Heyman, mus, shape).unwrap()).unwrap();
        assert!(found.upper - found.lower <= 1.001e-3, "{found:?}");
        let n = 40;
        let mut stand = 0;
        for i in 0..n {
            for j in 0..n {
                let span: Length =
                    format!("{}m", 9.5 + (f64::from(i) + 0.5) / f64::from(n)).parse().unwrap();
                let t = 0.2 + 0.1 * (f64::from(j) + 0.5) / f64::from(n);
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
        for (alpha, mu) in [(["80deg", "1.5"], ["0.5", "0.6"]), (["1", "1.5"], ["0.3", "inf"])] {
            assert!(of(alpha, mu, ["0.05", "0.06"]).is_err());
        }
    }
}
