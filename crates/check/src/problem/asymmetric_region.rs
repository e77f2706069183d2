//! Half openings and frictions between which an asymmetric mechanism of (19) is known, as a table; and what
//! "stands" means.
//!
//! An arch stands if it has an admissible state; and if it has one, it has a symmetric one. With friction that
//! does not slide without opening, the static theorem ends there: some horseshoes have, at a thickness above the
//! least, an admissible state and an asymmetric mechanism that (19) does not exclude. Their half openings and
//! frictions lie between the edge of `[s,s]` and the lines that `couplet map --plane opening-friction
//! --asymmetric` proves. There are no other kinds, and with Milankovitch's weight none outside (the claims
//! `asymmetric-kinds` and `asymmetric-number`); with Heyman's none outside the table, as a long test of these
//! claims proves in boxes of forces for both; that none lie between it and the lines is not proved. The table
//! holds the lines at 40 half openings, by a test.

use super::Arch;
use crate::arch::SelfWeight;
use crate::number::DoubleBall;

/// Property proved of an arch that stands.
pub const STANDS: &str = "an admissible symmetric state exists";
/// Possibility that standing leaves open where friction is limited.
pub const MAY_MOVE: &str = "friction without dilatancy may let such an arch move";
/// The command that looks for such a motion.
pub const LOOK: &str = "couplet complementarity";

/// A half opening (rad), and the least and the largest friction there.
type RegionNode = [f64; 3];

/// Nodes from `couplet map --asymmetric` and `couplet map --curve srr/ss,rrr/srr`, rounded outward by 0.0005
/// to 0.006 of the friction; straight lines between.
const MILANKOVITCH: &[RegionNode] = &[
    [2.2, 0.87, 0.875],
    [2.225, 0.906, 0.938],
    [2.247, 0.938, 1.001],
    [2.28, 0.99, 1.045],
    [2.32, 1.057, 1.102],
    [2.36, 1.13, 1.163],
    [2.4, 1.209, 1.228],
    [2.4325, 1.28, 1.285],
];
/// Nodes of the region for Heyman's weight.
const HEYMAN: &[RegionNode] = &[
    [2.19, 0.857, 0.862],
    [2.22, 0.898, 0.936],
    [2.247, 0.938, 1.011],
    [2.267, 0.969, 1.047],
    [2.31, 1.039, 1.108],
    [2.35, 1.11, 1.169],
    [2.39, 1.188, 1.234],
    [2.44, 1.296, 1.324],
    [2.49, 1.42, 1.425],
];

/// Every friction.
const ALL: [f64; 2] = [0.0, f64::INFINITY];

/// Tells whether an asymmetric mechanism is known of arches with this half opening and friction, or next to
/// them; also of numbers that doubles do not hold.
pub fn may_move_asymmetrically(arch: &Arch) -> bool {
    let range = |x: DoubleBall| [x.lower(), x.upper()];
    let half_opening = range(arch.half_opening().enclosure(53));
    // Most arches are told by their half opening, which spares the rest.
    let may = |frictions| some_may_move(arch.weight(), half_opening, frictions);
    arch.is_limited() && may(ALL) && may(range(arch.given::<DoubleBall>(53).friction))
}

/// Tells whether an asymmetric mechanism is known of any arch in a range of half openings (rad) and one of
/// frictions.
pub fn some_may_move(weight: SelfWeight, half_openings: [f64; 2], frictions: [f64; 2]) -> bool {
    let table = match weight {
        SelfWeight::Milankovitch => MILANKOVITCH,
        SelfWeight::Heyman => HEYMAN,
    };
    let [narrow, wide] =
        [half_openings[0].max(table[0][0]), half_openings[1].min(table[table.len() - 1][0])];
    // Both bounds grow with the half opening, so that its ends tell of all between.
    let bound = |alpha: f64, column: usize| {
        let after = table.iter().position(|node| node[0] >= alpha)?.max(1);
        let (from, to) = (table[after - 1], table[after]);
        Some(from[column] + (alpha - from[0]) / (to[0] - from[0]) * (to[column] - from[column]))
    };
    narrow <= wide
        && bound(narrow, 1).is_none_or(|least| least <= frictions[1])
        && bound(wide, 2).is_none_or(|largest| largest >= frictions[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn may_move(weight: &str, alpha: &str, mu: &str) -> bool {
        may_move_asymmetrically(&Arch::parse(weight, alpha, mu).unwrap())
    }

    #[test]
    fn known_arches_are_inside_and_others_are_not() {
        for (alpha, mu) in
            [("2.3", "1.05"), ("2.25", "0.96"), ("2.4", "1.22"), ("2.3", "tan(0.81)")]
        {
            assert!(may_move("milankovitch", alpha, mu), "{alpha} {mu}");
        }
        assert!(may_move("heyman", "2.4", "1.24") && !may_move("milankovitch", "2.4", "1.24"));
        for (alpha, mu) in [
            ("pi/2", "0.5"),
            ("2.3", "1"),
            ("2.3", "1.1"),
            ("2.3", "inf"),
            ("2.6", "1.3"),
            ("1e-30", "1.05"),
            ("2.3", "1e30"),
        ] {
            let found = ["heyman", "milankovitch"].map(|weight| may_move(weight, alpha, mu));
            assert_eq!(found, [false; 2], "{alpha} {mu}");
        }
    }

    #[test]
    fn a_range_reaches_what_any_of_its_arches_does() {
        let weight = SelfWeight::Milankovitch;
        let [all, none] = [[0.0, 4.0], [0.0, 2.1]];
        assert!(some_may_move(weight, all, [1.05, 1.05]) && !some_may_move(weight, none, all));
        assert!(some_may_move(weight, [2.3, 2.3], [1.03, f64::INFINITY]));
        assert!(!some_may_move(weight, [2.3, 2.3], [1.08, f64::INFINITY]));
        assert!(!some_may_move(weight, all, [0.0, 0.8]) && !some_may_move(weight, all, [1.3, 9.0]));
        assert!(some_may_move(weight, [f64::NEG_INFINITY, f64::INFINITY], [0.0, f64::INFINITY]));
    }
}
