//! The domains of the map as areas: cells in which each arch is proved to have one mode.

use super::curve::STATES_IN_ORDER;
use super::frictions::{FRICTION_FOR_ROTATION_GROWS, SLIDING_STATES_IN_ORDER};
use super::tiling::{COLUMNS, falls_with_the_thickness, thrust_at_triple_is_below_half};
use super::{Checked, Derivation, Support, claims, lemmas};
use crate::arch::SelfWeight;
use crate::atlas::{Areas, Curve, Trace, Variable};
use crate::number::{Ball, Enclosure, Ternary};
use crate::problem::Line;
use rug::Rational;
use rug::float::Round;
use std::sync::OnceLock;

claims! {
    Implicit("map-areas", "Sec. 3, Fig. 6", areas):
        "in the plane of friction angles up to a right one and thicknesses up to 2, cells in each of which one mode \
         is proved fill more than 99 % of the area; the others are cut by lines between modes";
}

/// The finest cells of a map, along each axis.
const PARTS: u32 = 512;
/// Half-width of the tubes of lines.
const TOLERANCE: f64 = 1e-7;
/// Shares are given in hundredths of a percent.
const SHARES: i32 = 10_000;

/// The cells of a weight, computed once.
fn cells(weight: SelfWeight) -> &'static Areas {
    static CELLS: [OnceLock<Areas>; 2] = [OnceLock::new(), OnceLock::new()];
    let index = usize::from(weight == SelfWeight::Milankovitch);
    CELLS[index].get_or_init(|| Areas::new(weight, PARTS))
}

/// Tells whether a quantity grows with the friction angle all along a line.
fn grows(quantity: Variable, line: Line, weight: SelfWeight) -> Checked<Ternary> {
    let trace = Trace::new(Curve::Line(line), weight, TOLERANCE)?;
    let slopes = trace.pieces().map(|piece| {
        let slope = piece.slope_of(quantity, Variable::FrictionAngle);
        slope.map_or(Ternary::Undecided, |slope| slope.is_positive())
    });
    Ok(slopes.fold(Ternary::True, Ternary::and))
}

/// The share of an area in hundredths of a percent, rounded.
fn share(area: &Ball, round: Round) -> i32 {
    let bound = if round == Round::Down { area.lower() } else { area.upper() };
    let share = (bound * SHARES).to_f64_round(round);
    if round == Round::Down { share.floor() as i32 } else { share.ceil() as i32 }
}

fn percent(share: i32) -> String {
    format!("{}.{:02} %", share / 100, share % 100)
}

fn areas(d: &mut Derivation) -> Checked {
    lemmas(d, [&COLUMNS, &STATES_IN_ORDER, &FRICTION_FOR_ROTATION_GROWS])?;
    lemmas(d, [&SLIDING_STATES_IN_ORDER])?;
    falls_with_the_thickness(d)?;
    for weight in SelfWeight::ALL {
        thrust_at_triple_is_below_half(d, weight)?;
        for line in [Line::AboveHaunchEnd, Line::BelowHaunchEnd, Line::CrownEnd] {
            let words = format!("eta grows with the friction along {line}, {weight}");
            // The joint of the haunch falls.
            let quantities = [Variable::Thickness, Variable::JointSquare];
            d.certain(Support::Balls, words, quantities, |x| grows(x, line, weight))?;
        }
    }
    d.argue(
        "With more friction, or with less thickness, h_R - h_s grows: h_R falls with the thickness, h_s with the \
         friction. So does mu - M(alpha_0), below the inner divide. Above it a state that stands as [s,s] does so \
         with more thickness, and with less friction, as the line at which it stops to stand grows, and ends in B, at \
         the thickness 2; and beta_r grows with less thickness and, as h_s falls, with more friction, while beta_s \
         falls with more friction, as h_s <= h_T < 1/2 there. So an arch between two others, of which one has less \
         friction and more thickness, and both of which have one mode, has this mode too: a cell is in one domain if \
         two of its corners are.",
    )?;
    for weight in SelfWeight::ALL {
        let areas = cells(weight);
        let most = Ball::enclosing(&Rational::from((99, 100)), 64);
        let words =
            format!("{} cells, each in one domain, fill more than 99 %, {weight}", areas.cells);
        d.less(words, [&most, &areas.proved])?;
        let words = format!(
            "the others have corners in two domains, but for at most one beside l, {weight}"
        );
        d.proved_elsewhere(words, areas.open <= 1)?;
        for (mode, [proved, perhaps]) in &areas.domains {
            let (low, high) = (share(proved, Round::Down), share(perhaps, Round::Up));
            let bound = |share: i32| Ball::enclosing(&Rational::from((share, SHARES)), 64);
            let words =
                format!("{mode} has between {} and {}, {weight}", percent(low), percent(high));
            // Next to these bounds are others as wide, between which it is not.
            let ranges = [[low, high], [high, 2 * high - low]];
            d.certain(Support::Balls, words, ranges, |[low, high]| {
                Ok(bound(low).is_less_than(proved).and(perhaps.is_less_than(&bound(high))))
            })?;
        }
    }
    d.argue(
        "At a corner the comparisons are decided in balls; that they tell the mode, and that two corners are enough, \
         is said above. A line passes through a cell that has corners in two domains. Where l of Heyman's weight, eta \
         = 1, is a corner, nothing is decided.",
    )
}
