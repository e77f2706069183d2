//! The domains of the map as areas: cells in which each arch is proved to have one mode.

use super::map_of_weights::room_falls_along_sliding;
use super::tiling::{falls_with_the_thickness, thrust_at_triple_is_below_half};
use super::{Checked, Derivation, Support, claims, lemmas};
use crate::arch::SelfWeight;
use crate::atlas::Areas;
use crate::number::{Ball, Enclosure};
use rug::Rational;
use rug::float::Round;
use std::sync::OnceLock;

claims! {
    Ours("map-areas", "Sec. 3, Fig. 6", areas):
        "in the plane of friction angles up to a right one and thicknesses up to 2, cells in each of which one mode \
         is proved fill more than 99 % of the area; the others are cut by lines between modes";
}

/// The finest cells of a map, along each axis.
const PARTS: u32 = 512;
/// Shares are given in hundredths of a percent.
const SHARES: i32 = 10_000;

/// The cells of a weight, computed once.
fn cells(weight: SelfWeight) -> &'static Areas {
    static CELLS: [OnceLock<Areas>; 2] = [OnceLock::new(), OnceLock::new()];
    let index = usize::from(weight == SelfWeight::Milankovitch);
    CELLS[index].get_or_init(|| Areas::new(weight, PARTS))
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
    lemmas(d, ["map-columns", "curve-order", "friction-rotation", "sliding-order", "curve-joint"])?;
    lemmas(d, ["map-T-inner", "map-B"])?;
    falls_with_the_thickness(d)?;
    for weight in SelfWeight::ALL {
        thrust_at_triple_is_below_half(d, weight)?;
    }
    room_falls_along_sliding(d)?;
    d.conclude(
        "Where an inner joint slides and the shoulder turns, mu >= mu_T: h is at most h_T, below 1/2. With pure sliding \
         at one friction and such a mode at less, both purely sliding states are between T and B.",
    )?;
    d.theorems(["Cells.cell_of_one_mode"])?;
    // They tell the mode of a corner.
    d.theorems(["Cells.thrust_of_crown", "Cells.inner_joint_slides_where_it_asks_more"])?;
    d.theorems(["Cells.crown_turns_where_rotation_asks_more", "Cells.mode_under_a_crown"])?;
    d.theorems(["Cells.mode_where_an_inner_joint_slides"])?;
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
    d.conclude(
        "At a corner the comparisons of these theorems are decided in balls, and each is strict. At one on an edge they \
         are those of the limit, and hold beside it. A line passes through a cell that has corners in two domains. \
         Where l of Heyman's weight, eta = 1, is a corner, nothing is decided.",
    )
}
