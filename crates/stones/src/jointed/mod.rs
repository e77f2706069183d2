//! All solutions of the complementarity problem (19) of an arch of equal stones, at any thickness up to 2.
//!
//! The conditions hold at the joints between the stones. Their coefficients are polynomials in the thickness `eta`:
//! of the rows of the static matrix, and of the matrix of compatibility without dilatancy.
//!
//! 1. **A vertex is enough.** A solution is an admissible state with rates of conditions that are zero there. The
//!    states at which these are zero are a face of the admissible ones, and have the same rates; the face has a
//!    vertex, as the hinges' rows leave no direction free. And of the conditions that are zero at a vertex three
//!    have independent rows, or two in a half arch.
//! 2. **All triples are looked at**, each on all of the range: on a piece of thicknesses it is proved to be no
//!    vertex, or to bear no motion together with every condition that may be zero there (`vertex`); or to have
//!    exactly one solution (`event`); or, where its conditions may be dependent, to bear no motion anywhere on the
//!    line of two of them (`line`); or the piece is halved. What stays open after many halvings is said. So
//!    **completeness** rests on signs of polynomials in balls and on nothing that is found by a search: neither the
//!    order of the pieces nor the directions `y` are trusted.
//! 3. **Where the range begins.** Below the least thickness nothing is admissible, as proved with the voussoirs: an
//!    admissible state and its mirror image have a symmetric one between them. At the least thickness is the
//!    symmetric solution (`least`). Next to it all conditions that touch there are nearly zero on every piece; the
//!    slopes of the polynomials tell their signs.
//! 4. **Digits** of a solution follow from its equations in balls of more bits (`refine`).
//!
//! Where a joint bears nothing, `N = T = 0`, both of its slips are zero and their motions are opposite: a
//! degenerate solution of (19), in which no block moves. It is not counted: of the two slips of a joint one rate at
//! most is positive.

#[cfg(test)]
mod brute_force;
mod conditions;
mod event;
mod found;
mod least;
mod line;
mod polynomial;
mod refine;
mod sweep;
mod vertex;

pub(super) use conditions::limits_at_joint;
pub use found::{Enumeration, JointedMotion, JointedSolution, LeastSolution, Standing};

use super::programme::MOST_JOINTED_STONES;
use super::voussoirs::{Voussoirs, voussoirs};
use crate::number::DoubleBall;
use crate::problem::stones::Stones;
use crate::problem::{Arch, Extent};
use crate::prover::{Error, Refused, Undecided};

use conditions::Conditions;
use event::Event;
use refine::StonesInDigits;
use sweep::sweep;
use vertex::ThicknessPiece;

/// More stones are refused: the cost grows with the cube of their number.
pub const MOST_ENUMERATED_STONES: u64 = 60;

/// Bits of what is given, before it is rounded to doubles.
const BITS: u32 = 106;
/// Digits of the least thickness where it begins.
const START_DIGITS: usize = 17;

/// All solutions of (19) between so many equal stones, 2 to [`MOST_ENUMERATED_STONES`], to `digits` significant digits.
///
/// Undecided where the least thickness is. With unlimited friction nothing slides, and the hinges alone are left.
pub fn enumerate(
    arch: &Arch,
    stones: u64,
    extent: Extent,
    digits: usize,
) -> Result<Enumeration, Error> {
    let (equal, number, found) = standing((arch, stones, MOST_ENUMERATED_STONES), digits)?;
    let nothing = |standing| Enumeration {
        extent,
        stones,
        standing,
        solutions: Vec::new(),
        open: Vec::new(),
        triples: 0,
    };
    let state = match found {
        Voussoirs::Slides | Voussoirs::TooThick => return Ok(nothing(Standing::Never)),
        Voussoirs::AnyThickness => None,
        Voussoirs::Stands(state) => Some(state),
    };
    let conditions: Conditions<DoubleBall> = Conditions::new(arch, number, extent, BITS);
    let start = match &state {
        Some(state) => least::start(&conditions, number, state),
        None => Some(least::start_at_zero(&conditions)),
    };
    let low = state.as_ref().map_or(0.0, |state| state.thickness.double.next_down());
    let swept = sweep(&conditions, ThicknessPiece { low, high: 2.0 }, start.as_ref());
    let of = StonesInDigits { arch, stones: &equal, number, extent, digits };
    let least: Option<Result<JointedSolution, Undecided>> =
        state.as_ref().map(|state| least::solution(&of, state));
    let others = alone(&conditions, swept.events).into_iter().map(|event| of.of(&event));
    Ok(Enumeration {
        standing: match (&least, &state) {
            (Some(Ok(least)), _) => Standing::From(Box::new(least.thickness.clone())),
            (_, Some(state)) => Standing::From(Box::new(state.thickness.clone())),
            (_, None) => Standing::Always,
        },
        solutions: least.into_iter().chain(others).collect(),
        open: joined(swept.open),
        triples: swept.triples,
        ..nothing(Standing::Always)
    })
}

/// The solution at the least thickness of so many equal stones, 2 to [`MOST_JOINTED_STONES`], to `digits`
/// significant digits: there the programme (20) is zero. Or that there is no least thickness.
pub fn least_solution(
    arch: &Arch,
    stones: u64,
    extent: Extent,
    digits: usize,
) -> Result<LeastSolution, Error> {
    let (equal, number, found) = standing((arch, stones, MOST_JOINTED_STONES), digits)?;
    let of = StonesInDigits { arch, stones: &equal, number, extent, digits };
    Ok(match found {
        Voussoirs::Stands(state) => LeastSolution::From(Box::new(least::solution(&of, &state)?)),
        Voussoirs::AnyThickness => LeastSolution::Always,
        Voussoirs::Slides | Voussoirs::TooThick => LeastSolution::Never,
    })
}

/// The stones, and from which thickness on they stand.
fn standing(
    (arch, stones, most): (&Arch, u64, u64),
    digits: usize,
) -> Result<(Stones, i32, Voussoirs), Error> {
    Refused::digits(digits)?;
    let number = Refused::stones(stones, most)?;
    let equal = Stones::equal(stones, arch.half_opening().clone())?;
    let found = voussoirs(&equal, arch.weight(), arch.friction(), digits.max(START_DIGITS))?;
    Ok((equal, number, found))
}

/// Each solution once: a vertex on two pieces, and others with the same conditions, find it again. On pieces that
/// overlap their polynomial is monotone, so that together they have one zero.
fn alone(conditions: &Conditions<DoubleBall>, mut events: Vec<Event>) -> Vec<Event> {
    let name = |event: &Event| {
        let own = event.kind.conditions();
        let other = conditions.mirrored(&own);
        own.min(other)
    };
    events.sort_by(|a, b| name(a).cmp(&name(b)).then(a.piece.low.total_cmp(&b.piece.low)));
    events.dedup_by(|b, a| name(a) == name(b) && b.piece.low <= a.piece.high);
    events.sort_by(|a, b| a.piece.low.total_cmp(&b.piece.low));
    events
}

/// Pieces as few intervals.
fn joined(mut pieces: Vec<ThicknessPiece>) -> Vec<[f64; 2]> {
    pieces.sort_by(|a, b| a.low.total_cmp(&b.low));
    let mut all: Vec<[f64; 2]> = Vec::new();
    for ThicknessPiece { low, high } in pieces {
        match all.last_mut() {
            Some(last) if low <= last[1] => last[1] = last[1].max(high),
            _ => all.push([low, high]),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prover::Figure;
    use crate::{Programme, programme};
    use couplet_judge::strategies::Draw;

    fn arch(weight: &str, alpha: &str, mu: &str) -> Arch {
        Arch::parse(weight, alpha, mu).unwrap()
    }

    fn found(arch: &Arch, stones: u64, extent: Extent) -> Vec<JointedSolution> {
        let all = enumerate(arch, stones, extent, 12).unwrap();
        assert!(all.first_open().is_none(), "{arch:?} {stones}: {:?}", all.open);
        all.solutions.into_iter().map(Result::unwrap).collect()
    }

    /// The symmetric solution is that of the voussoirs; a half arch has no other, the whole one may.
    #[test]
    fn a_half_arch_has_one_solution_and_the_whole_may_have_more() {
        for (weight, alpha, mu, stones, count) in [
            ("milankovitch", "2.3", "1.05", 8, 2),
            ("heyman", "2.3", "1.1", 6, 1),
            ("milankovitch", "pi/2", "0.5", 5, 1),
            ("heyman", "2.45", "1.35", 7, 1),
        ] {
            let arch = arch(weight, alpha, mu);
            let equal = Stones::equal(stones, arch.half_opening().clone()).unwrap();
            let Ok(Voussoirs::Stands(state)) =
                voussoirs(&equal, arch.weight(), arch.friction(), 12)
            else {
                panic!("{alpha} {mu}")
            };
            let least = state.thickness.to_string();
            let half = found(&arch, stones, Extent::Half);
            assert_eq!(half.len(), 1, "{alpha} {mu} {stones}");
            let whole = found(&arch, stones, Extent::Whole);
            assert_eq!(whole.len(), count, "{alpha} {mu} {stones}");
            assert!(whole[0].is_symmetric && whole[0].thickness.to_string() == least);
            assert_eq!(half[0].thickness.to_string(), least);
            assert!(whole[1..].iter().all(|other| !other.is_symmetric));
        }
    }

    /// The programme (20) falls to zero at the asymmetric solution, on both sides of it.
    #[test]
    fn the_programme_vanishes_where_a_solution_is() {
        let arch = arch("milankovitch", "2.3", "1.05");
        let eta = found(&arch, 8, Extent::Whole)[1].thickness.double;
        assert!((eta - 0.684_421_733_0).abs() < 1e-10);
        let least = |by: f64| {
            let at = format!("{:.9}", eta + by).parse().unwrap();
            match programme(&arch, &at, (8, Extent::Whole)) {
                Ok(Programme::Least { upper: Some(upper), .. }) => upper,
                other => panic!("{by}: {other:?}"),
            }
        };
        for side in [-1.0, 1.0] {
            let [near, far] = [1e-5, 1e-3].map(|by| least(side * by));
            assert!(near < far / 50.0 && near > far / 200.0, "{side}: {near} {far}");
        }
    }

    /// With unlimited friction the hinges alone are left: what is found is what is found where no slip matters.
    #[test]
    fn without_a_limit_of_friction_hinges_are_left() {
        for (weight, alpha, stones) in [("milankovitch", "1.2", 6), ("heyman", "pi/2", 5)] {
            for extent in [Extent::Half, Extent::Whole] {
                let all = |mu: &str| found(&arch(weight, alpha, mu), stones, extent);
                let [free, limited] = [all("inf"), all("5")];
                assert_eq!((free.len(), limited.len()), (1, 1), "{alpha} {extent:?}");
                assert_eq!(free[0].thickness.to_string(), limited[0].thickness.to_string());
                let is_hinge = |joint: &JointedMotion| joint.contact.is_hinge();
                assert!(free[0].joints.iter().all(is_hinge), "{:?}", free[0].joints);
            }
        }
    }

    /// Three hinges whose rows become parallel, as the thrust between them has no limit, are no vertex there.
    #[test]
    fn a_vertex_may_go_to_infinity() {
        assert_eq!(found(&arch("milankovitch", "1", "3"), 4, Extent::Whole).len(), 1);
    }

    /// With two or three stones and much friction every thickness stands, and none has a solution: next to zero as
    /// well, where the polynomials have a factor, or a slope. Without the slope three stones stay open there.
    #[test]
    fn where_every_thickness_stands_nothing_is_left() {
        for (weight, alpha, mu, stones) in [
            ("heyman", "2", "5", 2),
            ("heyman", "0.303", "0.79", 3),
            ("milankovitch", "1", "0.8", 3),
        ] {
            let arch = arch(weight, alpha, mu);
            for extent in [Extent::Half, Extent::Whole] {
                let all = enumerate(&arch, stones, extent, 6).unwrap();
                assert!(matches!(all.standing, Standing::Always) && all.solutions.is_empty());
                assert!(all.first_open().is_none(), "{alpha} {mu} {extent:?}: {:?}", all.open);
            }
            let conditions = Conditions::new(&arch, stones as i32, Extent::Whole, BITS);
            let range = ThicknessPiece { low: 0.0, high: 2.0 };
            let open = joined(sweep(&conditions, range, None).open);
            let is_open = open.first().is_some_and(|first| first[0] == 0.0);
            assert_eq!(is_open, stones == 3, "{alpha} {mu}: {open:?}");
        }
    }

    /// A crown that bears nothing: its thrust and moment are zero exactly.
    #[test]
    fn an_arch_that_overturns_has_no_thrust() {
        for extent in [Extent::Half, Extent::Whole] {
            let all = found(&arch("milankovitch", "2.606", "1.888"), 8, extent);
            let [one] = &all[..] else { panic!("{all:?}") };
            assert_eq!([&one.thrust, &one.crown_moment].map(Figure::to_string), ["0", "0"]);
            assert!(one.thickness.to_string().starts_with("1.057804488"));
            assert_eq!(one.joints[one.joints.len() / 2].side, None, "the crown opens");
        }
    }

    /// Number of random arches that stand at some thickness, and of those that have anything left open.
    fn at_random(count: u32) -> [u32; 2] {
        let mut draw = Draw(0);
        let mut between = |low: u64, high: u64| low + draw.number() % (high - low + 1);
        let mut look = || {
            let weight = ["milankovitch", "heyman"][between(0, 1) as usize];
            let [alpha, mu] = [between(1000, 31_415), between(500, 20_000)];
            let [alpha, mu] = [alpha, mu].map(|n| format!("{n}/10000"));
            let all = enumerate(&arch(weight, &alpha, &mu), between(4, 8), Extent::Whole, 6);
            let stands = all.as_ref().is_ok_and(|all| !matches!(all.standing, Standing::Never));
            let is_open = all.map_or(true, |all| all.first_open().is_some());
            [stands || is_open, is_open]
        };
        (0..count).fold([0; 2], |[stand, open], _| {
            let [stands, is_open] = look();
            [stand + u32::from(stands), open + u32::from(is_open)]
        })
    }

    #[test]
    fn arches_at_random_have_nothing_left_open() {
        let [stand, open] = at_random(20);
        assert!(open == 0 && stand >= 10, "{stand} {open}");
    }

    /// The counts of the documentation are those of many arches at random.
    #[test]
    #[ignore = "long"]
    fn many_arches_at_random_have_nothing_left_open() {
        assert_eq!(at_random(3000), [2059, 0]);
    }

    /// As many stones as a table of other values has: there the programme (20) has been seen to vanish.
    #[test]
    #[ignore = "long"]
    fn an_arch_of_many_stones_has_two_solutions() {
        let all = found(&arch("milankovitch", "2.3", "1.0454"), 26, Extent::Whole);
        assert_eq!(all.len(), 2);
        assert!((0.5760..0.5764).contains(&all[1].thickness.double));
    }

    /// Where nothing stands there is nothing, and what is beyond the range is refused.
    #[test]
    fn nothing_stands_and_nothing_is_asked() {
        let none = enumerate(&arch("heyman", "pi/2", "0.1"), 6, Extent::Whole, 6).unwrap();
        assert!(matches!(none.standing, Standing::Never) && none.solutions.is_empty());
        for stones in [0, 1, MOST_ENUMERATED_STONES + 1] {
            assert!(enumerate(&arch("heyman", "2", "1"), stones, Extent::Half, 6).is_err());
        }
    }
}
