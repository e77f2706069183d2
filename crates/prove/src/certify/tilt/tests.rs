use super::*;
use crate::solve::tilt::TiltNear;

fn found(arch: [&str; 3], eta: &str, tilt: &str) -> TiltDigits {
    let [weight, alpha, mu] = arch;
    let arch = Arch::parse(weight, alpha, mu).unwrap();
    tilted(&arch, &eta.parse().unwrap(), &tilt.parse().unwrap(), 12).unwrap()
}

fn proof(alpha: &str, mu: &str, eta: &str, bits: u32) -> TiltProof {
    TiltProof::new(&Arch::parse("heyman", alpha, mu).unwrap(), &eta.parse().unwrap(), bits)
}

fn near(proof: &TiltProof) -> Box<TiltNear> {
    match proof.search().candidate() {
        TiltCandidate::Limited(near) => near,
        other => panic!("{other:?}"),
    }
}

/// Joints beside the true ones give a bound that is a little higher; rates below zero give none, and so does a
/// state beyond the limit.
#[test]
fn what_is_beyond_the_limit_is_refused() {
    for (alpha, mu, eta) in
        [("pi/2", "0.6", "0.15"), ("pi/2", "0.4", "0.15"), ("2.3", "1.05", "0.7")]
    {
        let proof = proof(alpha, mu, eta, 200);
        let near = near(&proof);
        let (best, _) = proof.bound_above(&near.touches).unwrap();
        let low = proof.bound_below(&near.limit, &near.inside).unwrap();
        assert!((best.clone() - &low).is_positive().is_proved());
        assert!((best.clone() - low).mid().to_f64() < 1e-15, "{alpha} {mu}");
        let mut moved = near.touches.clone();
        moved.iter_mut().filter(|touch| touch.is_inside).for_each(|touch| touch.joint += 0.01);
        let (higher, _) = proof.bound_above(&moved).unwrap();
        assert!((higher - best).is_positive().is_proved(), "{alpha} {mu}");
        // A joint that the arch does not have.
        let mut beyond = near.touches.clone();
        beyond.iter_mut().filter(|touch| touch.is_inside).for_each(|touch| touch.joint += 3);
        assert!(proof.bound_above(&beyond).is_err(), "{alpha} {mu}");
        let other_way = [0, 1, 2, 3].map(|k| {
            let way = Float::with_val(200, &near.inside[k] - &near.limit[k]);
            Float::with_val(200, &near.limit[k] - way)
        });
        assert!(proof.bound_below(&near.limit, &other_way).is_err(), "{alpha} {mu}");
        let same = vec![near.touches[0].clone(); near.touches.len()];
        assert!(proof.bound_above(&same).is_err(), "{alpha} {mu}");
        let mut wrong = near.touches.clone();
        wrong[0].contact = match wrong[0].contact {
            Contact::Extrados => Contact::Intrados,
            Contact::Intrados => Contact::Extrados,
            Contact::Inwards => Contact::Outwards,
            Contact::Outwards => Contact::Inwards,
        };
        let bound = proof.bound_above(&wrong);
        assert!(bound.is_err() || bound.unwrap().0.mid() > &near.limit[3], "{alpha} {mu}");
    }
}

/// Straight lines through a thick, flat arch bear any acceleration; through one whose chord does not fit none does.
#[test]
fn a_flat_thick_arch_has_no_limit() {
    assert!(proof("0.5", "2", "0.7", 100).unlimited().is_ok());
    assert!(proof("0.5", "0.5", "0.7", 100).unlimited().is_err(), "it slides");
    assert!(proof("1.2", "2", "0.7", 100).unlimited().is_err(), "the chord leaves it");
}

/// Next to the largest on either side, and to the side that is not asked for.
#[test]
fn an_acceleration_is_compared_with_the_largest() {
    let at = |tilt: &str| found(["milankovitch", "pi/2", "0.4"], "0.15", tilt).is_admissible;
    assert_eq!((at("0"), at("0.0524")), (Ok(true), Ok(true)));
    assert_eq!((at("0.0525"), at("5deg")), (Ok(false), Ok(false)));
    let LargestTilt::Limited(figure, _) =
        found(["milankovitch", "pi/2", "0.4"], "0.15", "0").largest.unwrap()
    else {
        panic!()
    };
    let [lower, upper] = [&figure.decimal.lower, &figure.decimal.upper].map(|x| x.to_string());
    assert_eq!((at(&lower), at(&upper)), (Ok(true), Ok(false)));
}

/// Where so large an acceleration is borne that no limit is seen, a state inside all conditions still tells of a
/// smaller one; of one beyond the limit there is no such state.
#[test]
fn a_state_tells_of_an_acceleration_alone() {
    let found = found(["milankovitch", "0.01", "0.01"], "0.1", "0.1");
    assert_eq!(found.is_admissible, Ok(true));
    let named = format!("the largest tilt: {UNBOUNDED}");
    assert_eq!(found.largest.unwrap_err().reason, named);
    let proof = proof("pi/2", "0.4", "0.15", 100);
    let has_state = |tilt: &str| proof.has_state(&tilt.parse().unwrap());
    assert!(has_state("0") && has_state("0.05") && !has_state("0.053"));
}

/// Where no proof of the largest succeeds, as its conditions are not told, the acceleration asked for is decided
/// all the same.
#[test]
fn an_acceleration_is_decided_where_the_largest_is_not() {
    let of = |tilt: &str| found(["milankovitch", "1.27", "0.769"], "1.5", tilt);
    assert_eq!(of("0.1").is_admissible, Ok(true));
    assert_ne!(of("1.3").is_admissible, Ok(true));
}

/// Against a linear programme over 8001 joints, whose value is a little above.
#[test]
fn known_values() {
    for (alpha, mu, eta, known) in [
        ("pi/2", "inf", "0.15", 0.144_326_446_1),
        ("pi/2", "0.7", "0.15", 0.144_326_446_1),
        ("pi/2", "0.4", "0.15", 0.052_468_929_7),
        ("1.2", "0.6", "0.1", 0.356_507_933_9),
        ("2.3", "1.05", "0.7", 0.014_735_46),
        ("2.4", "1.35", "0.8", 0.061_346_71),
        ("0.5", "0.3", "0.1", 3.412_445_34),
        ("2.3", "5", "1.2", 0.360_668_73),
        ("1.2", "0.6", "1.5", 0.954_236_95),
        ("pi/2", "inf", "1.5", 2.009_739_66),
        // The intrados is one point.
        ("pi/2", "1", "2", 0.866_676_31),
        ("2.3", "3", "2", 0.396_260_47),
    ] {
        let found = found(["milankovitch", alpha, mu], eta, "0.01");
        let Ok(LargestTilt::Limited(largest, limits)) = &found.largest else {
            panic!("{alpha} {mu} {eta}: {found:?}")
        };
        let off = (largest.double - known) / known;
        assert!((-2e-5..1e-9).contains(&off), "{alpha} {mu} {eta}: {largest} {known} {limits:?}");
        assert_eq!(found.is_admissible, Ok(true));
    }
}
