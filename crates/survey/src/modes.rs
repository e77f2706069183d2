//! Modes that occur in a rectangle of half openings and frictions.
//!
//! At a given half opening the modes follow each other in one order as the friction grows, at a given friction in
//! another as the half opening does, each on an interval or not at all (the claims `map-rows` and `map-columns`). So
//! the states at four corners leave few modes to the arches between them, and halves of the rectangle fewer. Here
//! `[s,s]`, at the end of each order, stands for all arches of which nothing stands.

use super::answer::ModesFound;
use crate::arch::{SelfWeight, Unknown};
use crate::certify::CertifiedLandmark;
use crate::certify::state::{Certify, Outcome, state_enclosed};
use crate::number::{Ball, DoubleBall, Enclosure, ExactNumber, Ternary};
use crate::problem::survey::{frictions_in_order, in_order};
use crate::problem::{Arch, Friction, Landmark, Mode};
use std::collections::{HashSet, VecDeque};
use std::sync::OnceLock;

/// Most rectangles that are looked at for the modes of one survey.
const MOST_CELLS: usize = 64;
/// Parts of the half openings at whose ends thin strips are looked for.
const PARTS: i32 = 16;
/// Most halvings between two frictions at a half opening.
const MOST_STEPS: usize = 24;
/// Bits of the states that double-doubles leave open.
const BITS: u32 = 192;

/// A rectangle of half openings and frictions.
type StateRectangle = ([ExactNumber; 2], [Friction; 2]);

/// Modes over a rectangle of half openings (rad) and frictions.
pub(super) fn modes(
    weight: SelfWeight,
    half_opening: &[ExactNumber; 2],
    friction: &[Friction; 2],
) -> ModesFound {
    let mut seen = HashSet::new();
    let mut waiting: VecDeque<StateRectangle> = [(half_opening.clone(), friction.clone())].into();
    let mut left = HashSet::new();
    let mut cells = 0;
    while let Some((alphas, mus)) = waiting.pop_front() {
        cells += 1;
        let at = |alpha: &ExactNumber, mu: &Friction| place(weight, alpha, mu);
        let on_side = |alpha: &ExactNumber| mus.each_ref().map(|mu| at(alpha, mu));
        let corners = alphas.each_ref().map(on_side);
        seen.extend(corners.iter().flatten().flatten());
        let mut possible = possible(&corners);
        possible.retain(|mode| is_on_side(*mode, weight, &alphas));
        if cells == 1 && !possible.is_subset(&seen) {
            for alpha in columns(&alphas) {
                look_between(weight, &alpha, mus.clone(), on_side(&alpha), &mut seen);
            }
        }
        if possible.is_subset(&seen) {
            continue;
        }
        let may_halve = cells + waiting.len() < MOST_CELLS;
        match may_halve.then(|| halves(alphas, mus)).flatten() {
            Some(halves) => waiting.extend(halves),
            None => left.extend(possible),
        }
    }
    let all = |of: &dyn Fn(Mode) -> bool| {
        Mode::ALL.into_iter().filter(|mode| *mode != Mode::Sliding && of(*mode)).collect()
    };
    ModesFound {
        occur: all(&|mode| seen.contains(&mode)),
        may_occur: all(&|mode| left.contains(&mode) && !seen.contains(&mode)),
        some_fall: match (seen.contains(&Mode::Sliding), left.contains(&Mode::Sliding)) {
            (true, _) => Some(true),
            (false, true) => None,
            (false, false) => Some(false),
        },
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
    mut ends: [Option<Mode>; 2],
    seen: &mut HashSet<Mode>,
) {
    for _ in 0..MOST_STEPS {
        let [low, high] = ends;
        if low.is_none() || high.is_none() || between(&Mode::ROWS, low, high).is_subset(seen) {
            return;
        }
        let Some(middle) = middle_friction(&mus) else { return };
        let found = place(weight, alpha, &middle);
        seen.extend(found);
        // The half in which more is unseen.
        let missing = |first, last| between(&Mode::ROWS, first, last).difference(seen).count();
        let [first, last] = mus;
        if missing(low, found) >= missing(found, high) {
            (mus, ends) = ([first, middle], [low, found]);
        } else {
            (mus, ends) = ([middle, last], [found, high]);
        }
    }
}

/// Mode of an arch; `None` if it is not proved, as on a line between two modes.
fn place(weight: SelfWeight, alpha: &ExactNumber, mu: &Friction) -> Option<Mode> {
    let arch = Arch::new(weight, alpha.clone(), mu.clone()).ok()?;
    arch.state_in_doubles().map_or_else(|_| told(state_enclosed(&arch, BITS, false).ok()?), told)
}

/// Mode of what is proved of an arch. One that stands and slides with both joints is on the line to those that fall.
fn told<E>(outcome: Outcome<E>) -> Option<Mode> {
    match outcome {
        Outcome::Stands(state) => Some(state.mode).filter(|mode| *mode != Mode::Sliding),
        Outcome::Falls(_) => Some(Mode::Sliding),
    }
}

/// Every place that the corners of a rectangle do not exclude inside. A corner that is not known excludes nothing.
fn possible(corners: &[[Option<Mode>; 2]; 2]) -> HashSet<Mode> {
    let [[low_narrow, high_narrow], [low_wide, high_wide]] = *corners;
    let low = between(&Mode::COLUMNS, low_narrow, low_wide);
    let high = between(&Mode::COLUMNS, high_narrow, high_wide);
    let pairs = low.iter().flat_map(|first| high.iter().map(move |last| (*first, *last)));
    pairs.flat_map(|(first, last)| between(&Mode::ROWS, Some(first), Some(last))).collect()
}

/// Tells whether a mode lies on the side of T on which the half openings are: `[s,r,r]` is left of it, the modes with
/// an inner sliding joint are right of it (the claim `map-columns`).
fn is_on_side(mode: Mode, weight: SelfWeight, [first, last]: &[ExactNumber; 2]) -> bool {
    let Some(triple) = half_opening_of_t(weight) else { return true };
    let below = |a: &Ball, b: &Ball| (b.clone() - a).is_positive() == Ternary::True;
    match mode {
        Mode::Sliding => true,
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
fn between(orders: &[&[Mode]], first: Option<Mode>, last: Option<Mode>) -> HashSet<Mode> {
    let part = |order: &&[Mode]| {
        let index = |place| order.iter().position(|of| *of == place);
        let from = first.map_or(Some(0), index)?;
        order.get(from..=last.map_or(Some(order.len() - 1), index)?).map(<[Mode]>::to_vec)
    };
    orders.iter().filter_map(part).flatten().collect()
}

/// Halves of a rectangle, across its longer side; `None` if doubles tell no middle.
fn halves(alphas: [ExactNumber; 2], mus: [Friction; 2]) -> Option<[StateRectangle; 2]> {
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
    let grip = mu.grip::<DoubleBall>(53);
    grip.normal.mid().atan2(grip.shear.mid())
}

/// Friction of the angle midway between those of two, if it is proved to lie between them.
fn middle_friction(mus: &[Friction; 2]) -> Option<Friction> {
    let [first, last] = mus.each_ref().map(angle);
    let middle = ExactNumber::try_from(f64::midpoint(first, last).tan()).ok()?;
    between_ends(Friction::Coefficient(middle), mus, frictions_in_order)
}

/// A double, if it is proved to lie between two numbers.
fn inside(x: f64, ends: &[ExactNumber; 2]) -> Option<ExactNumber> {
    between_ends(ExactNumber::try_from(x).ok()?, ends, in_order)
}

fn between_ends<T: Clone, E>(
    middle: T,
    [first, last]: &[T; 2],
    in_order: impl Fn(&[T; 2]) -> Result<(), E>,
) -> Option<T> {
    let pairs = [[first, &middle], [&middle, last]].map(|pair| pair.map(T::clone));
    pairs.iter().all(|pair| in_order(pair).is_ok()).then_some(middle)
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
        let [rrr, srr, rrs] = [Mode::Rotational, Mode::SlidingRotational, Mode::RotationalSliding];
        assert_eq!(between(&Mode::ROWS, Some(srr), Some(rrr)), [srr, rrr].into());
        assert!(between(&Mode::ROWS, Some(srr), Some(rrs)).is_empty());
        assert_eq!(between(&Mode::COLUMNS, Some(srr), Some(rrs)), [srr, rrs].into());
        assert_eq!(between(&Mode::ROWS, None, Some(rrs)).len(), 4);
    }
}
