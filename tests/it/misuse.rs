//! Wrong questions through the public face: each door refuses them with what was wrong and what is allowed, and no
//! proof is begun.

use crate::arches::{H, M, arch, number};
use couplet::arch::asymmetric::AsymmetricMode;
use couplet::atlas::{Curve, NoPoint, point};
use couplet::certify::batch::{SharedOpening, SharedOpenings};
use couplet::certify::state::find::{Question, find};
use couplet::certify::state::{
    Balls, Certify, Inquiry, NoState, Wanted, measured_assessment, measured_state,
};
use couplet::certify::{
    CertifiedLandmark, MAX_DIGITS, MAX_FINGERPRINT_DIGITS, MOST_ENUMERATED_STONES,
    MOST_JOINTED_STONES, MOST_TILTED_STONES, Open, assess_voussoirs, asymmetric,
    asymmetric_thicknesses, certify_arch, certify_asymmetric, certify_landmark, enumerate,
    fingerprint, least_solution, programme, tilted, tilted_stones, voussoirs,
};
use couplet::problem::measures::{Circle, Measures};
use couplet::problem::stones::Stones;
use couplet::problem::{Extent, Landmark, Quantity, Slope};
use couplet::{Error, Refused};

/// What a door refuses, if it does.
trait Refuses {
    fn refused(self) -> Option<Refused>;
}

impl<T> Refuses for Result<T, Error> {
    fn refused(self) -> Option<Refused> {
        match self {
            Err(Error::Refused(refused)) => Some(refused),
            _ => None,
        }
    }
}

impl<T> Refuses for Result<T, Refused> {
    fn refused(self) -> Option<Refused> {
        self.err()
    }
}

fn stones(count: u64) -> Stones {
    Stones::equal(count, number("1")).unwrap()
}

fn measures() -> Measures {
    Measures::new(Circle::default(), "2.5m".parse().unwrap(), None)
}

/// Everything that takes digits of an arch.
fn of_an_arch(digits: usize) -> Vec<(&'static str, Option<Refused>)> {
    let (arch, eta, mu) = (arch(M, "1", "0.6"), number("0.1"), "0.6".parse().unwrap());
    let question = Question::Friction { half_opening: number("1"), thickness: None };
    let (measures, inner) = (measures(), AsymmetricMode::InnerSliding);
    let by_mpfr = Inquiry::new(&arch, digits, false);
    let least = match arch.least(digits) {
        Err(NoState::Refused(refused)) => Some(refused),
        _ => None,
    };
    vec![
        ("least", least),
        ("certify", arch.certify(digits).refused()),
        ("certify_alone", arch.certify_alone(digits).refused()),
        ("certify_thickness", arch.certify_thickness(&eta, digits).refused()),
        ("Inquiry::state", Inquiry::new(&arch, digits, true).state(digits, true).refused()),
        ("Inquiry::assess", by_mpfr.assess(&eta, digits, Wanted::Everything).refused()),
        ("SharedOpening", SharedOpening::new(M, number("1"), digits).refused()),
        ("SharedOpenings", SharedOpenings::new(Balls::DoubleDoubles, digits, true).refused()),
        ("find", find(M, &question, digits).refused()),
        ("measured_state", measured_state(&arch, &measures, digits).refused()),
        ("measured_assessment", measured_assessment((&arch, &eta), &measures, digits).refused()),
        ("certify_arch", certify_arch(&arch, None, digits).refused()),
        ("certify_asymmetric", certify_asymmetric(&arch, inner, digits).refused()),
        ("asymmetric", asymmetric(&arch, digits).refused()),
        ("voussoirs", voussoirs(&stones(7), M, &mu, digits).refused()),
        ("assess_voussoirs", assess_voussoirs(&stones(7), M, &mu, &eta, digits).refused()),
        ("enumerate", enumerate(&arch, 3, Extent::Whole, digits).refused()),
        ("least_solution", least_solution(&arch, 3, Extent::Whole, digits).refused()),
    ]
}

/// Everything that takes digits of an arch under an acceleration.
fn of_a_tilted_arch(digits: usize) -> [Option<Refused>; 2] {
    let (arch, eta, tilt) = (arch(M, "1", "0.6"), number("0.1"), "0.1".parse().unwrap());
    let stones = tilted_stones(&arch, &stones(7), &eta, &tilt, digits);
    [tilted(&arch, &eta, &tilt, digits).refused(), stones.refused()]
}

#[test]
fn no_door_of_an_arch_answers_to_no_digits_or_to_too_many() {
    for asked in [0, MAX_DIGITS + 1, usize::MAX] {
        let expected = Refused::Digits { asked, most: MAX_DIGITS };
        assert_eq!(expected.to_string(), "digits are a whole number from 1 to 1000000");
        for (door, refused) in of_an_arch(asked) {
            assert_eq!(refused.as_ref(), Some(&expected), "{door}, {asked} digits");
        }
        assert!(of_a_tilted_arch(asked).iter().all(|refused| refused.as_ref() == Some(&expected)));
    }
    // A hint has twelve at the most.
    assert!(asymmetric_thicknesses(&arch(M, "2.3", "1.05"), 0).is_err());
}

#[test]
fn no_door_of_a_landmark_answers_to_no_digits_or_to_too_many() {
    let triple = CertifiedLandmark::new(Landmark::Triple, H).unwrap();
    for asked in [0, MAX_DIGITS + 1, usize::MAX] {
        let expected = Some(Refused::Digits { asked, most: MAX_DIGITS });
        assert_eq!(triple.constants(asked).refused(), expected);
        assert_eq!(triple.constant(Quantity::Thickness, asked).refused(), expected);
        let with_another = [(Quantity::Thickness, 5), (Quantity::Thrust, asked)];
        assert_eq!(triple.constants_of(&with_another).refused(), expected);
        assert_eq!(certify_landmark(Landmark::Triple, H, asked).refused(), expected);
        let of_a_curve = point(Curve::Rotation, H, &number("1"), asked);
        let Err(NoPoint::Refused(of_a_curve)) = of_a_curve else { panic!("{asked}") };
        assert_eq!(Some(of_a_curve), expected);
        let hashed = Some(Refused::Digits { asked, most: MAX_FINGERPRINT_DIGITS });
        assert_eq!(fingerprint(&triple, asked).refused(), hashed);
    }
}

#[test]
fn what_is_no_thickness_is_said_to_be_none_for_the_true_reason() {
    let (arch, stones, mu) = (arch(M, "1", "0.6"), stones(7), "0.6".parse().unwrap());
    let tilt: Slope = "0.1".parse().unwrap();
    for (text, words) in [
        ("0", "the thickness 0 is not between 0 and 2"),
        ("-1/10", "the thickness -1/10 is not between 0 and 2"),
        ("2.000001", "the thickness 2.000001 is not between 0 and 2"),
        ("5/2", "the thickness 5/2 is not between 0 and 2"),
        // It is 0.157.
        ("pi/20", "the thickness pi/20 is no ratio of thickness to radius (0.12, 3/25)"),
    ] {
        let (eta, friction) = (number(text), "0.6".parse().unwrap());
        let given = || Some(number(text));
        let question = Question::Friction { half_opening: number("1"), thickness: given() };
        let widest = Question::HalfOpening { friction, thickness: given() };
        let doors = [
            find(M, &widest, 5).refused(),
            arch.certify_thickness(&eta, 5).refused(),
            arch.assess(&eta, 64).refused(),
            Inquiry::new(&arch, 5, false).assess(&eta, 5, Wanted::Standing).refused(),
            find(M, &question, 5).refused(),
            measured_assessment((&arch, &eta), &measures(), 5).refused(),
            certify_arch(&arch, Some(&eta), 5).refused(),
            assess_voussoirs(&stones, M, &mu, &eta, 5).refused(),
            programme(&arch, &eta, (3, Extent::Whole)).refused(),
            tilted(&arch, &eta, &tilt, 5).refused(),
            tilted_stones(&arch, &stones, &eta, &tilt, 5).refused(),
        ];
        for (place, refused) in doors.into_iter().enumerate() {
            let told = refused.map(|refused| refused.to_string());
            assert_eq!(told.as_deref(), Some(words), "door {place}");
        }
    }
}

#[test]
fn a_number_of_stones_has_its_bounds() {
    let (arch, eta) = (arch(M, "1", "0.6"), number("0.1"));
    let tilt: Slope = "0.1".parse().unwrap();
    let expected = |asked, most| Some(Refused::StoneCount { asked, most });
    for asked in [0, 1, 101, u64::MAX] {
        let all = enumerate(&arch, asked, Extent::Whole, 5).refused();
        assert_eq!(all, expected(asked, MOST_ENUMERATED_STONES));
        let least = least_solution(&arch, asked, Extent::Whole, 5).refused();
        assert_eq!(least, expected(asked, MOST_JOINTED_STONES));
        let at = programme(&arch, &eta, (asked, Extent::Whole)).refused();
        assert_eq!(at, expected(asked, MOST_JOINTED_STONES));
    }
    let many = tilted_stones(&arch, &stones(3000), &eta, &tilt, 5).refused();
    assert_eq!(many, expected(3000, MOST_TILTED_STONES));
}

/// `?` makes one error of a landmark that has no such quantity, a text that is no number and a proof.
#[test]
fn one_error_holds_what_was_asked_wrongly_and_what_stayed_open() {
    fn asked(half_opening: &str, quantity: Quantity) -> Result<f64, Error> {
        let widest = CertifiedLandmark::new(Landmark::WidestJoint, H)?;
        let constant = widest.constant(quantity, 10)?;
        let arch = couplet::problem::Arch::parse("heyman", half_opening, "inf")?;
        arch.state_alone(64)?;
        Ok(constant.double)
    }
    assert!(asked("1", Quantity::Thickness).is_ok());
    let told = |half_opening, quantity| asked(half_opening, quantity).unwrap_err().to_string();
    let why = "there is no friction here; the quantities are thickness, ";
    assert!(told("1", Quantity::Friction).starts_with(why));
    assert!(told("4", Quantity::Thickness).contains("is not between 0 and pi"));
    assert!(told("x", Quantity::Thickness).contains("'x'"));
    // No candidate is found where no asymmetric solution is: that is open, and was asked rightly.
    let arch = arch(M, "pi/2", "0.35");
    let open = Error::apart(certify_asymmetric(&arch, AsymmetricMode::InnerSliding, 5)).unwrap();
    assert_eq!(open.unwrap_err().kind, Open::Root);
}

/// What is proved with no bits is proved with a few, or stays open.
#[test]
fn no_bits_are_no_panic() {
    let arch = arch(M, "1", "0.6");
    for bits in [0, 1, 2, 31] {
        let found = arch.state(bits).map(|found| format!("{found:?}"));
        assert_eq!(found, arch.state(32).map(|found| format!("{found:?}")));
        assert_eq!(arch.state_alone(bits).is_ok(), arch.state_alone(32).is_ok());
        assert_eq!(arch.sliding_friction(bits).is_ok(), arch.sliding_friction(32).is_ok());
        assert!(arch.assess(&number("0.1"), bits).is_ok());
    }
}
