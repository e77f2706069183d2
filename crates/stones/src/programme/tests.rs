use super::*;
use crate::problem::stones::Stones;
use crate::{Voussoirs, voussoirs};

fn found(arch: &Arch, eta: &str, stones: u64) -> Programme {
    programme(arch, &eta.parse().unwrap(), (stones, Extent::Whole)).unwrap()
}

fn arch(weight: &str, alpha: &str, mu: &str) -> Arch {
    Arch::parse(weight, alpha, mu).unwrap()
}

fn least(arch: &Arch, eta: &str, stones: u64) -> f64 {
    match found(arch, eta, stones) {
        Programme::Least { lower, upper: Some(upper) } => {
            assert!(lower > 0.0 && lower <= upper && upper - lower < 1e-10, "{lower} {upper}");
            lower
        }
        other => panic!("{eta}: {other:?}"),
    }
}

/// Something is admissible exactly from the least thickness of the stones on, which is proved by other means.
#[test]
fn nothing_is_admissible_below_the_least_thickness_of_the_stones() {
    for (weight, alpha, mu, stones) in [
        ("milankovitch", "2.3", "1.05", 8),
        ("heyman", "pi/2", "0.35", 7),
        ("heyman", "pi/2", "0.6", 6),
        ("milankovitch", "2.45", "1.35", 5),
    ] {
        let arch = arch(weight, alpha, mu);
        let divided = Stones::equal(stones, arch.half_opening().clone()).unwrap();
        let Ok(Voussoirs::Stands(state)) = voussoirs(&divided, arch.weight(), arch.friction(), 6)
        else {
            panic!("{alpha} {mu}");
        };
        let eta = state.thickness.double;
        let below = found(&arch, &format!("{:.6}", eta - 1e-5), stones);
        assert_eq!(below, Programme::NothingAdmissible, "{alpha} {mu} {stones}");
        assert!(least(&arch, &format!("{:.6}", eta + 1e-5), stones) < 1e-4);
    }
}

/// Well above the least thickness the least value falls to zero again and rises: where two straight lines to it
/// meet the axis, next to the asymmetric solution of the arch with a joint at every angle, 0.577518.
#[test]
fn the_least_value_vanishes_a_second_time() {
    let arch = arch("milankovitch", "2.3", "1.0454");
    let at = |eta: f64| least(&arch, &format!("{eta:.9}"), 26);
    let zero = |a: f64, b: f64| a - at(a) * (b - a) / (at(b) - at(a));
    let falling = zero(0.5760, 0.5761);
    let rising = zero(0.5764, 0.5763);
    assert!((falling - rising).abs() < 1e-6, "{falling} {rising}");
    for by in [-0.001, 0.001] {
        assert!(at(falling) < at(falling + by) / 1000.0, "{} {}", at(falling), at(falling + by));
    }
}

fn det(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// All bases of four rates that fit.
fn bases(motions: &[[f64; 3]]) -> Vec<([usize; 4], [f64; 4])> {
    let n = motions.len();
    let mut bases = Vec::new();
    for i in 0..n {
        for j in 0..i {
            for k in 0..j {
                for l in 0..k {
                    let m = [i, j, k, l].map(|x| &motions[x]);
                    let rates = [
                        det(m[1], m[2], m[3]),
                        -det(m[0], m[2], m[3]),
                        det(m[0], m[1], m[3]),
                        -det(m[0], m[1], m[2]),
                    ];
                    let sum: f64 = rates.iter().sum();
                    let levels = rates.map(|rate| rate / sum);
                    if sum.abs() > 1e-12 && levels.iter().all(|level| *level > -1e-9) {
                        bases.push(([i, j, k, l], levels));
                    }
                }
            }
        }
    }
    bases
}

/// All triples of conditions, and all bases of four rates, in doubles.
fn by_enumeration(arch: &Arch, eta: &str, stones: i32) -> f64 {
    let all = conditions(arch, &eta.parse().unwrap(), (stones, Extent::Whole));
    let n = all.len();
    let middle = |x: &[DoubleBall; 3]| x.map(|x| x.mid());
    let rows: Vec<[f64; 3]> = all.iter().map(|c| middle(&parts(&c.row).0)).collect();
    let motions: Vec<[f64; 3]> = all.iter().map(|c| middle(&c.motion)).collect();
    let bases = bases(&motions);
    let mut least = f64::INFINITY;
    for i in 0..n {
        for j in 0..i {
            for k in 0..j {
                let whole = det(&rows[i], &rows[j], &rows[k]);
                if whole.abs() < 1e-9 {
                    continue;
                }
                let loads = [i, j, k].map(|x| -all[x].row[3].mid());
                let x = [0, 1, 2].map(|place| {
                    let mut r = [rows[i], rows[j], rows[k]];
                    for (row, load) in r.iter_mut().zip(loads) {
                        row[place] = load;
                    }
                    det(&r[0], &r[1], &r[2]) / whole
                });
                let gap = |c: usize| {
                    -(rows[c].iter().zip(&x).map(|(a, b)| a * b).sum::<f64>() + all[c].row[3].mid())
                };
                let gaps: Vec<f64> = (0..n).map(gap).collect();
                if gaps.iter().all(|gap| *gap > -1e-9) {
                    let value = |(columns, levels): &([usize; 4], [f64; 4])| {
                        columns.iter().zip(levels).map(|(c, level)| gaps[*c] * level).sum()
                    };
                    least = bases.iter().map(value).fold(least, f64::min);
                }
            }
        }
    }
    least
}

/// Another way, which knows neither lines nor prices, finds the same least value.
#[test]
fn enumeration_finds_the_same() {
    for (weight, alpha, mu, eta) in [
        ("heyman", "2.3", "1.1", "0.55"),
        ("milankovitch", "pi/2", "0.5", "0.2"),
        ("milankovitch", "1", "0.7", "2"),
    ] {
        let arch = arch(weight, alpha, mu);
        let other = by_enumeration(&arch, eta, 4);
        approx::assert_relative_eq!(least(&arch, eta, 4), other, max_relative = 1e-6);
    }
}

/// A crown that bears nothing is admissible from the thickness on at which two halves stand each for itself;
/// thinner, nothing costs nothing. At joints that bear something no state is found.
#[test]
fn a_joint_that_bears_nothing_costs_nothing() {
    let arch = arch("heyman", "1.868", "1.411");
    for extent in [Extent::Whole, Extent::Half] {
        let at = |eta: &str| programme(&arch, &eta.parse().unwrap(), (4, extent)).unwrap();
        assert_eq!(at("1.041"), Programme::Idle);
        assert!(matches!(at("0.6"), Programme::Least { lower, .. } if lower > 0.0));
        let all = conditions(&arch, &"1.041".parse().unwrap(), (4, extent));
        let search = RateSearch::new(all, extent);
        for at in search.all.chunks_exact(4) {
            let state = search.state_without(at);
            assert_eq!(state.is_some(), at[0].joint == 0, "{extent:?} {}", at[0].joint);
            assert!(state.is_none_or(|forces| forces.iter().all(|x| !x.excludes_zero())));
        }
    }
    assert!(by_enumeration(&arch, "1.041", 4) < 1e-9);
}

/// Of the hinges of a solid arch at the centre only those nearest to the crown make lines; of a thinner one all do.
#[test]
fn hinges_at_the_centre_follow_from_each_other() {
    let arch = arch("milankovitch", "1", "0.7");
    for (stones, eta, kept) in [(4, "2", 1), (5, "2", 1), (4, "1.999", 5)] {
        let eta = eta.parse().unwrap();
        let search =
            RateSearch::new(conditions(&arch, &eta, (stones, Extent::Whole)), Extent::Whole);
        let lines = search.all.iter().zip(&search.follows).filter(|(_, follows)| !**follows);
        let intrados: Vec<i32> = lines
            .filter(|(at, _)| at.contact == Contact::Intrados)
            .map(|(at, _)| at.joint)
            .collect();
        assert_eq!(intrados.len(), kept, "{intrados:?}");
        assert!(kept > 1 || intrados == [stones % 2], "{intrados:?}");
    }
}

#[test]
fn three_parallel_conditions_are_seen() {
    assert!(!has_triangle(&[]) && !has_triangle(&[[1, 0], [3, 2], [4, 0]]));
    assert!(has_triangle(&[[1, 0], [2, 1], [2, 0]]));
}

/// Next to a friction angle of the half opening a line may be admissible for ever, or end far away: an end that is
/// lost would be a wrong value, so that nothing is said. Beside it all is decided.
#[test]
fn a_line_that_may_have_no_end_is_not_decided() {
    let of = |mu: &str, extent| {
        let arch = arch("milankovitch", "0.5", mu);
        programme(&arch, &"0.7".parse().unwrap(), (4, extent))
    };
    for extent in [Extent::Whole, Extent::Half] {
        let open = of("0.54630248984379051325", extent).unwrap_err();
        assert_eq!(open.to_string(), "undecided: whether a line is admissible as a whole");
        for mu in ["0.546", "0.547"] {
            assert!(matches!(of(mu, extent), Ok(Programme::Least { .. })), "{mu}");
        }
    }
}

#[test]
fn what_it_is_not_asked_for_is_refused() {
    let eta = "1/2".parse().unwrap();
    for stones in [0, 1, MOST_JOINTED_STONES + 1, u64::MAX] {
        assert!(programme(&arch("heyman", "2.3", "1"), &eta, (stones, Extent::Whole)).is_err());
    }
}

/// Slips at a right angle to each other are parallel where the friction is one, and are no vertex; without a limit of
/// friction there are none, and the least value is that of much friction.
#[test]
fn parallel_slips_are_no_obstacle() {
    let least = |mu: &str| match programme(
        &arch("milankovitch", "pi/2", mu),
        &"0.3".parse().unwrap(),
        (6, Extent::Whole),
    ) {
        Ok(Programme::Least { lower, upper: Some(upper) }) => (lower, upper),
        other => panic!("{mu}: {other:?}"),
    };
    let [one, more, free] = ["1", "3", "inf"].map(least);
    assert!(one.0 > 0.0 && one.0 <= more.1);
    assert!(more.0 <= free.1 && free.0 <= more.1, "{more:?} {free:?}");
}

/// With unlimited friction there may be no rates that fit, which looking at all sets of four motions tells too: then
/// (19) has no solution. Where hinges bear rates, and with finite friction, there are some.
#[test]
fn where_no_rates_fit_it_is_proved() {
    let is_none = |mu: &str, eta: &str, stones| {
        let arch = arch("milankovitch", "pi/3", mu);
        let all = conditions(&arch, &eta.parse().unwrap(), (stones, Extent::Whole));
        let motions: Vec<[f64; 3]> = all.iter().map(|c| c.motion.map(|x| x.mid())).collect();
        let found = found(&arch, eta, stones as u64) == Programme::NoRates;
        assert_eq!(found, bases(&motions).is_empty(), "{mu} {eta} {stones}");
        found
    };
    assert!(is_none("inf", "1.2", 2) && is_none("inf", "1.2", 4));
    assert!(!is_none("inf", "0.02", 2) && !is_none("inf", "0.02", 4) && !is_none("9", "1.2", 2));
    let arch = arch("heyman", "pi/3", "inf");
    let half = programme(&arch, &"1.2".parse().unwrap(), (2, Extent::Half));
    assert_eq!(half, Ok(Programme::NoRates));
}
