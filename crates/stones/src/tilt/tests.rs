use super::*;

fn found(arch: [&str; 3], eta: &str, tilt: &str) -> TiltDigits {
    let [weight, alpha, mu] = arch;
    let arch = Arch::parse(weight, alpha, mu).unwrap();
    tilted(&arch, &eta.parse().unwrap(), &tilt.parse().unwrap(), 12).unwrap()
}

fn proof(alpha: &str, mu: &str, eta: &str, bits: u32) -> TiltProof {
    TiltProof::new(&Arch::parse("heyman", alpha, mu).unwrap(), &eta.parse().unwrap(), bits)
}

/// Conditions that are not those of the limit, joints that the arch does not have, and a state that is not that of the
/// root prove nothing.
#[test]
fn what_is_forged_is_refused() {
    for (alpha, mu, eta) in
        [("pi/2", "0.6", "0.15"), ("pi/2", "0.4", "0.15"), ("2.3", "1.05", "0.7")]
    {
        let proof = proof(alpha, mu, eta, 200);
        let proved = proof.largest().unwrap().unwrap();
        let TiltCandidate::Limited(near) = proof.search().candidate() else {
            panic!("{alpha} {mu}")
        };
        let proves = |near: &TiltNear| {
            let mechanism = proof.mechanism(near)?;
            let weight = Ball::integer(1, 200);
            proof.is_admissible(&mechanism.forces, &weight, &mechanism.zeros())
        };
        assert_eq!(proves(&near), Ok(()), "{alpha} {mu}");
        for k in 0..near.touches.len() {
            let mut forged = near.clone();
            forged.touches.remove(k);
            assert!(proves(&forged).is_err(), "{alpha} {mu}: one is missing, {k}");
            let mut forged = near.clone();
            forged.touches[k] = near.touches[(k + 1) % near.touches.len()];
            assert!(proves(&forged).is_err(), "{alpha} {mu}: one twice, {k}");
            let mut forged = near.clone();
            forged.touches[k].contact = match near.touches[k].contact {
                Contact::Extrados => Contact::Intrados,
                Contact::Intrados => Contact::Extrados,
                Contact::Inwards => Contact::Outwards,
                Contact::Outwards => Contact::Inwards,
            };
            assert!(proves(&forged).is_err(), "{alpha} {mu}: another condition, {k}");
            // Where the margin is not known to be zero it is not seen to be positive.
            let mut zeros = proved.zeros();
            zeros.remove(k);
            let weight = Ball::integer(1, 200);
            assert!(proof.is_admissible(&proved.forces, &weight, &zeros).is_err());
        }
        let narrower = Ball::exact(Float::with_val(200, 0.5), 200);
        assert!(TiltMechanism::new(&proof.joints, &narrower, &near, 200).is_err(), "{alpha} {mu}");
        let mut beyond = proved.clone();
        beyond.forces[3] = beyond.forces[3].clone() + Ball::integer(1, 200).scaled(-60);
        let weight = Ball::integer(1, 200);
        assert!(proof.is_admissible(&beyond.forces, &weight, &beyond.zeros()).is_err());
        // More bits are of the same root, and not of another one.
        let finer = TiltProof { bits: 400, ..self::proof(alpha, mu, eta, 400) };
        assert!(finer.refined(&proved).is_ok() && finer.refined(&beyond).is_err());
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
    let told = |tilt: &str| {
        let tilt = acceleration(&tilt.parse().unwrap(), 100);
        [proof.has_state(&tilt), proof.has_none(&tilt)]
    };
    assert_eq!((told("0"), told("0.05")), ([true, false], [true, false]));
    assert_eq!((told("0.053"), told("0.2")), ([false, true], [false, true]));
}

/// Where no proof of the largest succeeds, as its conditions are not told, the acceleration asked for is decided
/// all the same.
#[test]
fn an_acceleration_is_decided_where_the_largest_is_not() {
    let of = |tilt: &str| found(["milankovitch", "1.27", "0.769"], "1.5", tilt);
    assert_eq!(of("0.1").is_admissible, Ok(true));
    assert_ne!(of("1.3").is_admissible, Ok(true));
}

/// Just above the least thickness the largest acceleration is tiny, and is proved like any other.
#[test]
fn a_tiny_excess_is_decided() {
    for (eta, known) in
        [("0.1074782", 6.2e-7), ("0.107478039", 3.4e-9), ("0.1074780381074763134", 3.3e-19)]
    {
        let found = found(["milankovitch", "pi/2", "inf"], eta, "0.1");
        assert_eq!(found.is_admissible, Ok(false));
        let Ok(LargestTilt::Limited(figure, _)) = &found.largest else { panic!("{found:?}") };
        assert!((figure.double / known - 1.0).abs() < 0.1, "{eta}: {}", figure.double);
    }
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

/// More digits than the proof has bits, where a springing is a number exactly and where slips alone leave the moment.
#[test]
fn there_are_as_many_digits_as_are_asked_for() {
    for (alpha, mu, eta) in [("1", "inf", "0.05"), ("1/2", "0.3", "0.1"), ("pi/2", "0.4", "0.15")] {
        let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
        let of = |digits| {
            let tilt = "0.01".parse().unwrap();
            match tilted(&arch, &eta.parse().unwrap(), &tilt, digits).unwrap().largest {
                Ok(LargestTilt::Limited(figure, _)) => figure.to_string(),
                other => panic!("{alpha}: {other:?}"),
            }
        };
        let [few, many] = [40, 400].map(of);
        assert!(many.len() >= 400 && many.starts_with(&few[..38]), "{alpha}: {few} {many}");
    }
}

/// Where a hinge comes to a springing it lies less than a step of the search from it.
#[test]
fn a_hinge_next_to_a_springing_is_found() {
    for eta in (4035..4100).step_by(5) {
        let eta = format!("0.{eta}");
        let found = found(["heyman", "1.672", "inf"], &eta, "0.1").largest;
        assert!(matches!(found, Ok(LargestTilt::Limited(..))), "{eta}: {found:?}");
    }
    let found = found(["heyman", "1.672", "inf"], "0.4088", "0.1").largest.unwrap();
    let LargestTilt::Limited(tilt, _) = found else { panic!() };
    assert!((tilt.double - 0.60206).abs() < 1e-5, "{}", tilt.double);
}
