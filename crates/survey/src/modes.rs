//! Modes that occur in a rectangle of half openings and frictions.
//!
//! At a given half opening the modes follow each other in one order as the friction grows, at a given friction in
//! another as the half opening does, each on an interval or not at all (the claims `map-rows` and `map-columns`). So
//! the states at four corners leave few modes to the arches between them, and halves of the rectangle fewer.

use super::answer::ModesFound;
use crate::arch::{SelfWeight, Unknown};
use crate::certify::CertifiedLandmark;
use crate::certify::state::{Certify, Outcome, state_enclosed};
use crate::number::{Ball, DoubleBall, Enclosure, ExactNumber, Ternary};
use crate::problem::survey::{frictions_in_order, in_order};
use crate::problem::{Arch, Friction, Landmark, Mode};
use std::collections::VecDeque;
use std::f64::consts::FRAC_PI_2;
use std::sync::OnceLock;

/// Mode of the state, `None` where nothing stands.
type Place = Option<Mode>;

/// Orders in which modes follow each other as the friction grows.
const ROWS: [&[Place]; 3] = [
    &[None, Some(Mode::SlidingRotational), Some(Mode::Rotational)],
    &[
        None,
        Some(Mode::OverturningSliding),
        Some(Mode::RotationalSlidingRotational),
        Some(Mode::RotationalSliding),
        Some(Mode::Rotational),
    ],
    // With unlimited friction at the end.
    &[None, Some(Mode::OverturningSliding), Some(Mode::Overturning)],
];

/// Orders in which they do as the half opening grows.
const COLUMNS: [&[Place]; 2] = [
    &[
        Some(Mode::Rotational),
        Some(Mode::SlidingRotational),
        Some(Mode::RotationalSliding),
        Some(Mode::RotationalSlidingRotational),
        Some(Mode::OverturningSliding),
        None,
    ],
    &[Some(Mode::Rotational), Some(Mode::Overturning), None],
];

/// Most rectangles that are looked at for the modes of one survey.
const MOST_CELLS: usize = 64;
/// Parts of the half openings at whose ends thin strips are looked for.
const PARTS: i32 = 16;
/// Most halvings between two frictions at a half opening.
const MOST_STEPS: usize = 24;
/// Bits of the states that double-doubles leave open.
const BITS: u32 = 192;

/// A rectangle of half openings and frictions.
type Cell = ([ExactNumber; 2], [Friction; 2]);

/// Modes over a rectangle of half openings (rad) and frictions.
pub(super) fn modes(
    weight: SelfWeight,
    half_opening: &[ExactNumber; 2],
    friction: &[Friction; 2],
) -> ModesFound {
    let mut seen: Vec<Place> = Vec::new();
    let mut waiting: VecDeque<Cell> = [(half_opening.clone(), friction.clone())].into();
    let mut left: Vec<Place> = Vec::new();
    let mut cells = 0;
    while let Some((alphas, mus)) = waiting.pop_front() {
        cells += 1;
        let at = |alpha: &ExactNumber, mu: &Friction| place(weight, alpha, mu);
        let corners = [
            [at(&alphas[0], &mus[0]), at(&alphas[0], &mus[1])],
            [at(&alphas[1], &mus[0]), at(&alphas[1], &mus[1])],
        ];
        see(&mut seen, corners.iter().flatten().copied());
        let mut possible = possible(&corners);
        possible.retain(|place| is_on_side(*place, weight, &alphas));
        let is_open = possible.iter().any(|place| !seen.contains(place));
        if cells == 1 && is_open {
            for alpha in columns(&alphas) {
                let ends = mus.each_ref().map(|mu| at(&alpha, mu));
                look_between(weight, &alpha, mus.clone(), ends, &mut seen);
            }
        }
        if possible.iter().all(|place| seen.contains(place)) {
            continue;
        }
        let may_halve = cells + waiting.len() < MOST_CELLS;
        match may_halve.then(|| halves(alphas, mus)).flatten() {
            Some(halves) => waiting.extend(halves),
            None => left.extend(possible),
        }
    }
    let all = |of: &dyn Fn(Mode) -> bool| Mode::ALL.into_iter().filter(|m| of(*m)).collect();
    ModesFound {
        occur: all(&|mode| seen.contains(&Some(mode))),
        may_occur: all(&|mode| left.contains(&Some(mode)) && !seen.contains(&Some(mode))),
        some_fall: match (seen.contains(&None), left.contains(&None)) {
            (true, _) => Some(true),
            (false, true) => None,
            (false, false) => Some(false),
        },
    }
}

/// Adds what is known to what was seen.
fn see(seen: &mut Vec<Place>, found: impl Iterator<Item = Option<Place>>) {
    for place in found.flatten() {
        if !seen.contains(&place) {
            seen.push(place);
        }
    }
}

/// Half openings from the first to the last.
fn columns(alphas: &[ExactNumber; 2]) -> impl Iterator<Item = ExactNumber> {
    let [a, b] = alphas.each_ref().map(|x| x.enclosure::<DoubleBall>(53).mid());
    let at = move |k: i32| a + (b - a) * f64::from(k) / f64::from(PARTS);
    let inner = (1..PARTS).filter_map(move |k| inside(at(k), alphas));
    let [first, last] = alphas.clone();
    [first, last].into_iter().chain(inner)
}

/// Looks for places between two frictions at a half opening, by halving: a strip may be thin.
fn look_between(
    weight: SelfWeight,
    alpha: &ExactNumber,
    mut mus: [Friction; 2],
    mut ends: [Option<Place>; 2],
    seen: &mut Vec<Place>,
) {
    for _ in 0..MOST_STEPS {
        let [low, high] = ends;
        let unseen = between(&ROWS, low, high).into_iter().any(|place| !seen.contains(&place));
        if low.is_none() || high.is_none() || !unseen {
            return;
        }
        let Some(middle) = middle_friction(&mus) else { return };
        let found = place(weight, alpha, &middle);
        see(seen, [found].into_iter());
        // The half in which more is unseen.
        let missing = |first, last| {
            between(&ROWS, first, last).into_iter().filter(|place| !seen.contains(place)).count()
        };
        let [first, last] = mus;
        if missing(low, found) >= missing(found, high) {
            (mus, ends) = ([first, middle], [low, found]);
        } else {
            (mus, ends) = ([middle, last], [found, high]);
        }
    }
}

/// State of an arch; `None` if it is not proved, as on a line between two modes.
fn place(weight: SelfWeight, alpha: &ExactNumber, mu: &Friction) -> Option<Place> {
    let arch = Arch::new(weight, alpha.clone(), mu.clone()).ok()?;
    let quick = arch.state_in_doubles().ok().map(|outcome| match outcome {
        Outcome::Stands(state) => Some(state.mode),
        Outcome::Falls(_) => None,
    });
    let slow = || match state_enclosed(&arch, BITS, false).ok()? {
        Outcome::Stands(state) => Some(Some(state.mode)),
        Outcome::Falls(_) => Some(None),
    };
    quick.or_else(slow).filter(|place| *place != Some(Mode::Sliding))
}

/// Every place that the corners of a rectangle do not exclude inside. A corner that is not known excludes nothing.
fn possible(corners: &[[Option<Place>; 2]; 2]) -> Vec<Place> {
    let [[low_narrow, high_narrow], [low_wide, high_wide]] = *corners;
    let low = between(&COLUMNS, low_narrow, low_wide);
    let high = between(&COLUMNS, high_narrow, high_wide);
    let mut all: Vec<Place> = Vec::new();
    for first in &low {
        for last in &high {
            for place in between(&ROWS, Some(*first), Some(*last)) {
                if !all.contains(&place) {
                    all.push(place);
                }
            }
        }
    }
    all
}

/// Tells whether a mode lies on the side of T on which the half openings are: `[s,r,r]` is left of it, the modes with
/// an inner sliding joint are right of it (the claim `map-columns`).
fn is_on_side(place: Place, weight: SelfWeight, [first, last]: &[ExactNumber; 2]) -> bool {
    let Some(mode) = place else { return true };
    let Some(triple) = half_opening_of_t(weight) else { return true };
    let below = |a: &Ball, b: &Ball| (b.clone() - a).is_positive() == Ternary::True;
    match mode {
        Mode::SlidingRotational => !below(&triple, &first.enclosure(BITS)),
        _ if mode.slides_inside() => !below(&last.enclosure(BITS), &triple),
        _ => true,
    }
}

/// Half opening of T, proved once for each weight.
fn half_opening_of_t(weight: SelfWeight) -> Option<Ball> {
    static PROVED: [OnceLock<Option<Ball>>; 2] = [const { OnceLock::new() }; 2];
    let proved = || {
        let triple = CertifiedLandmark::new(Landmark::Triple, weight).ok()?;
        triple.enclosure(BITS).ok()?.value(Unknown::HalfOpening)
    };
    let index = SelfWeight::ALL.iter().position(|x| *x == weight)?;
    PROVED.get(index)?.get_or_init(proved).clone()
}

/// Places that one of the orders has from the first to the last.
fn between(orders: &[&[Place]], first: Option<Place>, last: Option<Place>) -> Vec<Place> {
    let mut all: Vec<Place> = Vec::new();
    for order in orders {
        let index = |place: Place| order.iter().position(|x| *x == place);
        let (Some(from), Some(to)) =
            (first.map_or(Some(0), index), last.map_or(Some(order.len() - 1), index))
        else {
            continue;
        };
        for place in order.get(from..=to).unwrap_or_default() {
            if !all.contains(place) {
                all.push(*place);
            }
        }
    }
    all
}

/// Halves of a rectangle, across its longer side; `None` if doubles tell no middle.
fn halves(alphas: [ExactNumber; 2], mus: [Friction; 2]) -> Option<[Cell; 2]> {
    let ends = alphas.each_ref().map(|x| x.enclosure::<DoubleBall>(53).mid());
    let frictions = mus.each_ref().map(angle);
    let wide = ends[1] - ends[0] >= frictions[1] - frictions[0];
    if wide {
        let middle = inside(f64::midpoint(ends[0], ends[1]), &alphas)?;
        let [first, last] = alphas;
        Some([([first, middle.clone()], mus.clone()), ([middle, last], mus)])
    } else {
        let middle = middle_friction(&mus)?;
        let [first, last] = mus;
        Some([(alphas.clone(), [first, middle.clone()]), (alphas, [middle, last])])
    }
}

/// Angle of a friction, about.
fn angle(mu: &Friction) -> f64 {
    match mu {
        Friction::Infinite => FRAC_PI_2,
        _ => {
            let grip = mu.grip::<DoubleBall>(53);
            grip.normal.mid().atan2(grip.shear.mid())
        }
    }
}

/// Friction of the angle midway between those of two, if it is proved to lie between them.
fn middle_friction(mus: &[Friction; 2]) -> Option<Friction> {
    let [first, last] = mus;
    let middle = ExactNumber::try_from(f64::midpoint(angle(first), angle(last)).tan()).ok()?;
    let middle = Friction::Coefficient(middle);
    let is_inside = frictions_in_order(&[first.clone(), middle.clone()]).is_ok()
        && frictions_in_order(&[middle.clone(), last.clone()]).is_ok();
    is_inside.then_some(middle)
}

/// A double, if it is proved to lie between two numbers.
fn inside(x: f64, ends: &[ExactNumber; 2]) -> Option<ExactNumber> {
    let middle = ExactNumber::try_from(x).ok()?;
    let [first, last] = ends;
    let is_inside = in_order(&[first.clone(), middle.clone()]).is_ok()
        && in_order(&[middle.clone(), last.clone()]).is_ok();
    is_inside.then_some(middle)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(alpha: [&str; 2], mu: [&str; 2]) -> ModesFound {
        let alphas = alpha.map(|x| x.parse().unwrap());
        modes(SelfWeight::Milankovitch, &alphas, &mu.map(|x| x.parse().unwrap()))
    }

    #[test]
    fn a_rectangle_inside_one_mode_has_that_mode() {
        let one = found(["1.4", "1.6"], ["0.5", "0.7"]);
        assert_eq!(one.occur, [Mode::Rotational]);
        assert!(one.may_occur.is_empty() && one.some_fall == Some(false));
    }

    #[test]
    fn modes_between_the_corners_are_found() {
        // From falls to rotation, with the sliding of the shoulder on the way, however thin its strip.
        let all = found(["1.5", "1.5"], ["0.2", "0.5"]);
        assert_eq!(all.occur, [Mode::Rotational, Mode::SlidingRotational]);
        assert_eq!((all.may_occur.len(), all.some_fall), (0, Some(true)));
        // Before T nothing slides inside, however far the corners are apart.
        let all = found(["80deg", "100deg"], ["0.3", "0.75"]);
        assert_eq!(all.occur, [Mode::Rotational, Mode::SlidingRotational]);
        assert_eq!((all.may_occur.len(), all.some_fall), (0, Some(true)));
        // Everything beyond T.
        let all = found(["2", "2.62"], ["0.6", "inf"]);
        assert_eq!(all.occur.len(), 6, "{all:?}");
        assert!(all.may_occur.is_empty(), "{all:?}");
    }

    #[test]
    fn an_order_has_no_place_outside_its_ends() {
        let [rrr, srr, rrs] =
            [Mode::Rotational, Mode::SlidingRotational, Mode::RotationalSliding].map(Some);
        assert_eq!(between(&ROWS, Some(srr), Some(rrr)), [srr, rrr]);
        assert!(between(&ROWS, Some(srr), Some(rrs)).is_empty());
        assert_eq!(between(&COLUMNS, Some(srr), Some(rrs)), [srr, rrs]);
        assert_eq!(between(&ROWS, None, Some(rrs)).len(), 4);
    }
}
