//! Arches of voussoirs, against a programme over all joints and against the arch with a joint at every angle.

mod programme;
mod told;

pub(crate) use programme::Programme;

use crate::arches::stands;
use crate::program::object;
use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Figure, Inquiry, Wanted};
use couplet::certify::{
    VoussoirAssessment, VoussoirDigits, VoussoirLimit, VoussoirStanding, Voussoirs,
    assess_voussoirs, voussoirs,
};
use couplet::number::Decimal;
use couplet::problem::stones::Stones;
use couplet::problem::{Arch, Friction, Mode};

fn found(stones: &Stones, weight: SelfWeight, friction: &str, digits: usize) -> Voussoirs {
    let friction: Friction = friction.parse().unwrap();
    voussoirs(stones, weight, &friction, digits).unwrap_or_else(|undecided| {
        panic!("{undecided}: {stones:?}, {}, {friction}", weight.name())
    })
}

fn assessed(
    stones: &Stones,
    weight: SelfWeight,
    friction: &str,
    thickness: &str,
    digits: usize,
) -> VoussoirAssessment {
    let (friction, thickness) = (friction.parse().unwrap(), thickness.parse().unwrap());
    assess_voussoirs(stones, weight, &friction, &thickness, digits).unwrap()
}

fn equal(stones: u64, half_opening: &str) -> Stones {
    Stones::equal(stones, half_opening.parse().unwrap()).unwrap()
}

/// The angles of the joints of the half arch, in doubles.
fn joints(stones: u64, half_opening: f64) -> Vec<f64> {
    let joint = |j: u64| half_opening * (2 * j + stones % 2) as f64 / stones as f64;
    (0..=stones / 2).map(joint).collect()
}

/// Next to the least thickness on either side, and where friction is next to what is needed.
#[test]
fn a_given_thickness_is_compared_with_the_least() {
    let stones = equal(20, "pi/2");
    let assess = |mu: &str, eta: &str| assessed(&stones, SelfWeight::Milankovitch, mu, eta, 20);
    let stands =
        |mu: &str, eta: &str| matches!(assess(mu, eta).standing, Ok(VoussoirStanding::Stands(_)));
    // The least thickness is 0.15025383190820...
    assert!(stands("0.35", "0.1502538319082060") && !stands("0.35", "0.1502538319082"));
    let needed = assess("inf", "0.2").required_friction.unwrap().unwrap();
    let (more, less) = (&needed.decimal.upper, &needed.decimal.lower);
    assert!(stands(&more.to_string(), "0.2") && !stands(&less.to_string(), "0.2"));
    assert!(assess("inf", "0.2").friction_safety.unwrap().is_none());
    let (weight, mu) = (SelfWeight::Heyman, "1".parse().unwrap());
    for wrong in ["0", "-1", "2.1", "pi"] {
        let found = assess_voussoirs(&stones, weight, &mu, &wrong.parse().unwrap(), 10);
        assert!(found.is_err(), "{wrong}");
    }
}

/// A keystone that reaches beyond a right angle on both sides: with unlimited friction no thrust is too small. The
/// friction that it asks for is proved all the same: with the next larger number it stands, with the next smaller one
/// it falls.
#[test]
fn a_keystone_beyond_a_right_angle_asks_for_a_friction() {
    let stones = Stones::joints(vec!["2.00789".parse().unwrap(), "2.6309".parse().unwrap()]);
    let stones = stones.unwrap();
    let assess = |mu: &str, eta: &str| assessed(&stones, SelfWeight::Milankovitch, mu, eta, 9);
    for eta in ["0.8498609", "0.8517507"] {
        let free = assess("inf", eta);
        let needed = free.required_friction.unwrap().unwrap();
        assert!(needed.to_string().starts_with("0.39787"), "{needed}");
        let Ok(VoussoirStanding::Stands([least, largest])) = free.standing else { panic!("{eta}") };
        assert!(least.thrust.is_none() && largest.thrust.is_some());
        let stands = |mu: &Decimal| match assess(&mu.to_string(), eta).standing.unwrap() {
            VoussoirStanding::Stands([least, _]) => least.thrust.is_some(),
            VoussoirStanding::Falls(_) => false,
        };
        assert!(stands(&needed.decimal.upper) && !stands(&needed.decimal.lower));
    }
}

/// As the stones become many, what is assessed comes to that of the continuous arch.
#[test]
fn many_stones_are_assessed_as_the_continuous_arch() {
    for (alpha, mu, eta) in
        [("80deg", "0.6", "0.12"), ("2.45", "1.35", "0.8"), ("pi/2", "0.35", "0.2")]
    {
        let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
        let eta = eta.parse().unwrap();
        let whole = Inquiry::new(&arch, 12, false).assess(&eta, 12, Wanted::Everything).unwrap();
        let stones = equal(4_000_000, alpha);
        let found = assess_voussoirs(&stones, arch.weight(), arch.friction(), &eta, 12).unwrap();
        let close = |a: &Figure, b: &Figure| (a.double - b.double).abs() < 1e-9;
        let Ok(VoussoirStanding::Stands(ends)) = &found.standing else { panic!("{found:?}") };
        for (end, limit) in ends.iter().zip(&whole.thrust) {
            let thrust = limit.as_ref().unwrap().as_ref().unwrap().thrust.as_ref().unwrap();
            assert!(close(end.thrust.as_ref().unwrap(), thrust), "{alpha}");
        }
        for (a, b) in [
            (&found.geometric_safety, &whole.geometric_safety),
            (&found.required_friction, &whole.required_friction),
            (&found.friction_safety, &whole.friction_safety),
        ] {
            let [a, b] = [a, b].map(|x| x.as_ref().unwrap().as_ref().unwrap());
            assert!(close(a, b));
        }
    }
}

fn state(found: Voussoirs) -> VoussoirDigits {
    match found {
        Voussoirs::Stands(state) => *state,
        other => panic!("{other:?}"),
    }
}

/// More joints never help; and with joints as near as one likes to those of the continuous arch it is as thick.
#[test]
fn the_continuous_arch_is_the_limit() {
    for (alpha, mu) in [
        ("pi/2", "0.6"),
        ("pi/2", "0.35"),
        ("2.45", "1.35"),
        ("2.532", "1.5405"),
        ("2.57", "2.2"),
        ("2.62", "inf"),
    ] {
        for weight in SelfWeight::ALL {
            let arch = Arch::parse(weight.name(), alpha, mu).unwrap();
            let whole = |digits| stands(&arch, digits);
            let fine = whole(40);
            let eta = |stones| state(found(&equal(stones, alpha), weight, mu, 30)).thickness;
            let [few, twice, many] = [20, 40, 1 << 22].map(eta);
            let lower = |figure: &Figure| figure.decimal.lower.to_rational();
            assert!(lower(&few) <= lower(&twice) && lower(&twice) <= lower(&many));
            assert!(lower(&many) <= fine.thickness.decimal.upper.to_rational(), "{alpha} {mu}");
            let gap = fine.thickness.double - many.double;
            assert!(gap < 1e-11, "{alpha} {mu}: {gap}");
            // Joints at forty digits of those that the whole arch has.
            let inner = [Some(&fine.rotation_joint), fine.sliding_joint.as_ref()];
            let inner = inner.into_iter().flatten().filter(|joint| joint.double > 0.0);
            let mut inner: Vec<&Figure> = inner.collect();
            inner.sort_by(|a, b| a.double.total_cmp(&b.double));
            let inner = inner.into_iter().map(|figure| figure.decimal.value.to_string());
            let angles = std::iter::once("0".to_owned()).chain(inner).chain([alpha.to_owned()]);
            let stones = Stones::joints(angles.map(|angle| angle.parse().unwrap()).collect());
            let same = state(found(&stones.unwrap(), weight, mu, 30));
            assert_eq!(same.thickness.to_string(), whole(30).thickness.to_string(), "{alpha} {mu}");
            assert_eq!(same.mode, fine.mode, "{alpha} {mu}");
        }
    }
}

/// The joints that the proof does not look at are admissible too.
#[test]
fn every_joint_is_admissible() {
    for (stones, alpha, mu) in
        [(11, 1.5, 0.6), (40, 2.45, 1.35), (101, 2.57, 2.2), (64, 1.5, 0.35), (9, 2.3, 1.05)]
    {
        for weight in SelfWeight::ALL {
            let given = equal(stones, &alpha.to_string());
            let state = state(found(&given, weight, &mu.to_string(), 15));
            let (eta, h) = (state.thickness.double, state.thrust.double);
            let fac = 1.0 + f64::from(weight.flag()) * eta * eta / 12.0;
            let normal = |b: f64| h * b.cos() + b * b.sin();
            let (_, haunch) = state.contacts[1];
            let joints = joints(stones, alpha);
            let b = joints[haunch as usize];
            let p = (1.0 - eta / 2.0) * normal(b) - fac * (1.0 - b.cos());
            for b in joints {
                let (n, t, m) = (normal(b), b * b.cos() - h * b.sin(), p + fac * (1.0 - b.cos()));
                assert!(m <= (1.0 + eta / 2.0) * n + 1e-13 && m >= (1.0 - eta / 2.0) * n - 1e-13);
                assert!(t.abs() <= mu * n + 1e-13, "{stones} {alpha} {mu} at {b}");
            }
        }
    }
}

#[test]
fn two_and_three_stones_stand_at_any_thickness() {
    for weight in SelfWeight::ALL {
        for (stones, mu) in [(2, "inf"), (3, "inf"), (2, "0.9"), (3, "0.6")] {
            let any = found(&equal(stones, "pi/2"), weight, mu, 10);
            assert!(matches!(any, Voussoirs::AnyThickness), "{stones} {mu}: {any:?}");
        }
        let four = found(&equal(4, "pi/2"), weight, "inf", 10);
        assert!(matches!(four, Voussoirs::Stands(_)));
    }
}

/// With few stones the crown can be open although friction is finite: no joint is near enough to it to slide.
#[test]
fn a_crown_between_few_stones_opens() {
    let arch = state(found(&equal(6, "2.637566"), SelfWeight::Heyman, "2.056972", 20));
    assert_eq!((arch.mode, arch.thrust.double), (Mode::Overturning, 0.0));
    assert!(arch.sliding_joint.is_none());
    let arch = state(found(&equal(60, "2.637566"), SelfWeight::Heyman, "2.056972", 20));
    assert_eq!(arch.mode, Mode::OverturningSliding);
}

/// Stones that nobody checked, as a program can make them, are not an arch.
#[test]
fn unchecked_stones_prove_nothing() {
    let angles = ["0", "1.05", "0.2", "0.7", "1.25", "pi/2"].map(|angle| angle.parse().unwrap());
    let wide = Stones::Equal { stones: 10, half_opening: "pi".parse().unwrap() };
    let mu = |text: &str| text.parse::<Friction>().unwrap();
    for (stones, friction) in [
        (Stones::Joints(angles.to_vec()), mu("inf")),
        (wide, mu("inf")),
        (equal(10, "1"), mu("-1")),
        (equal(10, "1"), mu("tan(120deg)")),
    ] {
        let found = voussoirs(&stones, SelfWeight::Heyman, &friction, 10);
        assert!(found.is_err(), "{stones:?} {friction}: {found:?}");
    }
}

/// With joints where the arch with all joints turns and slides, the same three conditions hold: the value is the
/// same, to twice the digits to which the joints are. With a joint moved it is lower.
#[test]
fn joints_where_the_arch_gives_way_lose_nothing() {
    for (weight, alpha, mu) in [
        ("milankovitch", "pi/2", "0.35"),
        ("heyman", "1.2", "inf"),
        ("milankovitch", "2.45", "1.35"),
    ] {
        let arch = Arch::parse(weight, alpha, mu).unwrap();
        let Ok(Answer::Stands(state)) = Inquiry::new(&arch, 24, false).state(24, false) else {
            panic!("{alpha} {mu}")
        };
        let of = |moved: f64| {
            let rounded = |figure: &Figure| figure.to_string();
            let turns = match moved == 0.0 {
                true => rounded(&state.rotation_joint),
                false => (state.rotation_joint.double + moved).to_string(),
            };
            let joints = [Some("0".to_owned()), state.sliding_joint.as_ref().map(rounded)];
            let joints = joints.into_iter().flatten().chain([turns, alpha.to_owned()]);
            let stones = Stones::joints(joints.map(|joint| joint.parse().unwrap()).collect());
            match found(&stones.unwrap(), arch.weight(), mu, 24) {
                Voussoirs::Stands(found) => (found.thickness.to_string(), found.thickness.double),
                other => panic!("{other:?}"),
            }
        };
        assert_eq!(of(0.0).0, state.thickness.to_string(), "{alpha} {mu}");
        assert!(of(0.01).1 < state.thickness.double - 1e-7, "{alpha} {mu}: false twin");
    }
}

/// Each joint is judged by itself (`stones-joints`): with unlimited friction the least thickness is the largest of
/// those of the arches that have this joint alone between crown and shoulder, to the last digit. Without the joint that
/// decides it is less.
#[test]
fn each_joint_is_judged_by_itself() {
    type AngleText = fn(u64) -> String;
    let cases: [(SelfWeight, u64, AngleText); 3] = [
        (SelfWeight::Milankovitch, 6, |joint| format!("{joint}pi/12")),
        (SelfWeight::Heyman, 5, |joint| format!("{}/25", 12 * joint)),
        (SelfWeight::Milankovitch, 4, |joint| format!("{joint}/4")),
    ];
    for (weight, half, angle) in cases {
        let name = angle(half);
        let least = |inner: &[u64]| {
            let all = [&[0], inner, &[half]].concat();
            let angles = all.into_iter().map(|joint| angle(joint).parse().unwrap()).collect();
            let found = found(&Stones::joints(angles).unwrap(), weight, "inf", 30);
            let VoussoirDigits { mode: by, thickness, .. } = state(found);
            (by, thickness.double, thickness.to_string())
        };
        let inner: Vec<u64> = (1..half).collect();
        let (by, _, all) = least(&inner);
        assert_eq!(by, Mode::Rotational, "{name}");
        let one = |joint: &u64| (*joint, least(&[*joint]));
        let largest = inner.iter().map(one).max_by(|a, b| a.1.1.total_cmp(&b.1.1)).unwrap();
        assert_eq!(largest.1.2, all, "{name}");
        let others: Vec<u64> = inner.into_iter().filter(|joint| *joint != largest.0).collect();
        assert!(least(&others).1 < largest.1.1, "{name}: false twin");
    }
}

/// Exact ties: a semicircle of thickness 2 bears any thrust, and two stones whose shoulder bears no shear force
/// need no friction.
#[test]
fn ties_are_decided() {
    let of = |line: &str| object(format!("voussoirs --digits 6 {line}"))["assessment"].clone();
    for stones in [3, 4, 8, 9] {
        for mu in ["0.6", "inf"] {
            let found = of(&format!("--alpha pi/2 --mu {mu} --stones {stones} --eta 2"));
            assert!(found["required_friction"]["value"].is_string(), "{stones} {mu}: {found}");
        }
    }
    let found = of("--alpha 0.5 --mu 0.7 --stones 2 --eta 0.3");
    assert_eq!(found["required_friction"]["value"], "0", "{found}");
    // With an intrados near the centre's height the thrust is not free to be so small.
    let found = of("--alpha 2 --mu 5 --stones 2 --eta 0.3");
    assert_ne!(found["required_friction"]["value"], "0", "{found}");
}

/// Joints that slide at exactly no thrust: the angle of the joint and that of friction are together a right angle,
/// or differ by one. With a little more friction or less, which is no tie, it is nearly so.
#[test]
fn slips_at_no_thrust_are_decided() {
    let assess = |alpha: &str, mu: &str, stones, weight| {
        assessed(&equal(stones, alpha), weight, mu, "1", 12).standing.unwrap()
    };
    let thrusts = |ends: &[VoussoirLimit; 2]| {
        ends.each_ref().map(|end| end.thrust.as_ref().map(|thrust| thrust.double).unwrap())
    };
    for weight in SelfWeight::ALL {
        // The shoulder bears none, and a joint above it asks for some.
        for (mu, sign) in [("45deg", 0.0), ("1", 0.0), ("44.9999deg", -1.0), ("45.0001deg", 1.0)] {
            let VoussoirStanding::Falls(ends) = assess("3pi/4", mu, 9, weight) else { panic!() };
            let [least, most] = thrusts(&ends);
            assert!((least - 0.151_149_947).abs() < 1e-5, "{mu}: {least}");
            assert!(most.abs() < 1e-5 && most * sign >= 0.0 && (most == 0.0) == (sign == 0.0));
        }
        // A joint and the crown ask for none; with less friction the joint asks for some.
        for (mu, is_some) in [("60deg", false), ("59.9999deg", true), ("60.0001deg", false)] {
            let VoussoirStanding::Stands(ends) = assess("2pi/3", mu, 8, weight) else { panic!() };
            let [least, most] = thrusts(&ends);
            assert!((0.0..1e-5).contains(&least) && (least > 0.0) == is_some, "{mu}: {least}");
            assert!(most > 0.5, "{mu}: {most}");
        }
    }
}

/// Two stones without friction have one thrust, at which the shoulder bears no shear force, and a least thickness, to
/// which that of little friction comes; with a joint between, nothing stands.
#[test]
fn two_stones_need_no_friction() {
    let of = |stones, friction| found(&equal(stones, "1"), SelfWeight::Milankovitch, friction, 9);
    let [none, little] = ["0", "1e-15"].map(|friction| state(of(2, friction)));
    assert_eq!(none.thrust.to_string(), "0.642092616", "the cotangent of 1");
    assert_eq!(none.thickness.to_string(), little.thickness.to_string());
    for stones in [3, 4] {
        assert!(matches!(of(stones, "0"), Voussoirs::Slides), "{stones}");
    }
}
