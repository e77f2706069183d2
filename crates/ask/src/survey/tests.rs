//! Ranges that are read, and those that are refused.

use super::*;
use crate::problem::survey::Side;

const ASSESS: ArchQuestion =
    ArchQuestion { refuses: &[], needs: &[Field::Thickness], unlimited: false, example: "" };

fn asked(words: &str) -> ArchAsked {
    let pairs = words.split_whitespace().map(|pair| pair.split_once('=').unwrap());
    ArchAsked::of(pairs.map(|(name, text)| (Field::named(name).unwrap(), text)))
}

fn read(words: &str) -> Result<SurveyGiven, Misfit> {
    SurveyGiven::read(&ASSESS, &asked(words), Spelling::Key)
}

#[test]
fn a_length_that_would_take_minutes_is_refused() {
    let of = |zeros: usize| {
        let long = format!("1.{}1m", "0".repeat(zeros));
        read(&format!("span={long}..2m rise=1m mu=1 eta=10cm..20cm"))
    };
    assert!(of(200).is_ok());
    let misfit = of(400).unwrap_err();
    assert_eq!(misfit.field, Some(Field::Span));
    assert!(misfit.message.contains("at most 300 characters"), "{misfit}");
}

/// The questions about the arches that decide where half opening and thickness are free.
fn corners(words: &str) -> [String; 2] {
    let given = read(words).unwrap();
    let survey = given.survey(SelfWeight::Heyman).unwrap();
    [Side::Unsafe, Side::Safe].map(|side| {
        let corner = survey.corner(side).unwrap();
        let one = given.one(&corner.arch, corner.thickness.as_ref(), None);
        // It is that arch.
        let read = super::super::ArchGiven::new(&one, Spelling::Option).unwrap();
        let arch = read.arch(SelfWeight::Heyman).unwrap();
        assert_eq!((&arch, &read.thickness), (&corner.arch, &corner.thickness));
        one.options()
    })
}

#[test]
fn the_arches_that_decide_are_asked_for_in_the_words_of_the_question() {
    let of = |worst: &str, best: &str| [worst.to_owned(), best.to_owned()];
    assert_eq!(
        corners("alpha=80deg±1deg mu=0.6±10% eta=0.1..0.12"),
        of(
            " --half-opening 81deg --friction 0.54 --thickness 0.1",
            " --half-opening 79deg --friction 0.66 --thickness 0.12"
        )
    );
    assert_eq!(
        corners("span=10m±2cm rise=3m±1cm eta=0.1r phi=31deg..32deg measured_at=extrados"),
        of(
            " --friction-angle 31deg --thickness 0.1r --span 9.98m --rise 3.01m --measured-at extrados",
            " --friction-angle 32deg --thickness 0.1r --span 10.02m --rise 2.99m --measured-at extrados"
        )
    );
    assert_eq!(
        corners("radius=5m±1cm alpha=1 eta=50cm±1cm mu=0.5..inf"),
        of(
            " --half-opening 1 --friction 0.5 --thickness 49cm --radius 5.01m",
            " --half-opening 1 --friction inf --thickness 51cm --radius 4.99m"
        )
    );
    assert_eq!(
        corners("span=9m..10m radius=6m..7m eta=0.1r mu=0.5"),
        of(
            " --friction 0.5 --thickness 0.1r --span 10m --radius 6m",
            " --friction 0.5 --thickness 0.1r --span 9m --radius 7m"
        )
    );
    assert_eq!(
        corners("rise=2m..3m radius=6m eta=50cm..60cm mu=0.5"),
        of(
            " --friction 0.5 --thickness 50cm --rise 3m --radius 6m",
            " --friction 0.5 --thickness 60cm --rise 2m --radius 6m"
        )
    );
    assert_eq!(
        corners("span=1467mm rise=593mm radius=750mm eta=5cm mu=0.5..0.6"),
        of(
            " --friction 0.5 --thickness 5cm --span 1467mm --rise 593mm --radius 750mm",
            " --friction 0.6 --thickness 5cm --span 1467mm --rise 593mm --radius 750mm"
        )
    );
    assert_eq!(
        corners("span=10m rise=3m eta=60cm mu=0.5±0.1"),
        of(
            " --friction 0.4 --thickness 60cm --span 10m --rise 3m",
            " --friction 0.6 --thickness 60cm --span 10m --rise 3m"
        )
    );
}

#[test]
fn stones_stay_where_they_are() {
    for (words, best) in [
        (
            "alpha=1 stones=5 mu=0.5..0.6 eta=0.1",
            " --half-opening 1 --friction 0.6 --thickness 0.1 --stones 5",
        ),
        ("joints=0,0.5,1 mu=0.6 eta=0.1..0.2", " --friction 0.6 --thickness 0.2 --joints 0,0.5,1"),
        (
            "span=10m rise=3m stones=5 phi=31deg eta=50cm±2cm",
            " --friction-angle 31deg --thickness 52cm --stones 5 --span 10m --rise 3m",
        ),
    ] {
        let given = read(words).unwrap();
        assert_eq!(corners(words)[1], best);
        let [alpha, same] = given.half_opening();
        assert_eq!((&alpha, given.stones.unwrap().half_opening()), (&same, &alpha));
    }
}

/// The number in place of what is sought is in no text.
#[test]
fn what_is_sought_has_a_number_that_is_not_told() {
    for (sought, words, worst) in [
        (Sought::HalfOpening, "mu=0.5..0.6 eta=0.1", " --friction 0.5 --thickness 0.1"),
        (Sought::Friction, "alpha=1..2 eta=0.1", " --half-opening 2 --thickness 0.1"),
    ] {
        let given = SurveyGiven::seeking(sought, &asked(words), Spelling::Key).unwrap();
        let corner = given.survey(SelfWeight::Heyman).unwrap().corner(Side::Unsafe).unwrap();
        let one = given.one(&corner.arch, corner.thickness.as_ref(), None);
        assert_eq!(one.options(), worst);
    }
}

#[test]
fn measured_spans_rises_and_thicknesses_are_lengths() {
    let given = read("span=33ft±1in rise=3m eta=60cm±2cm mu=0.6").unwrap();
    assert!(matches!(given.shape, Shape::Spanned { .. }));
    let arch = Arch::parse("heyman", "1", "0.6").unwrap();
    let [span, rise, t] = ["10.05m", "300cm", "0.58m"].map(|x| x.parse().unwrap());
    let one = given.one(&arch, None, Some(&[span, rise, t]));
    assert_eq!(one.options(), " --friction 0.6 --thickness 58cm --span 10.05m --rise 3m");
    let one = given.one(&arch, Some(&"1/10".parse().unwrap()), None);
    assert_eq!(one.options(), " --half-opening 1 --friction 0.6 --thickness 1/10");
    let [narrow, wide] = given.half_opening();
    assert!(in_order(&[narrow, wide]).is_ok());
}

#[test]
fn what_makes_no_range_of_arches_is_refused_with_its_field() {
    use Field as F;
    for (words, field, why) in [
        ("alpha=1..2 eta=0.1", None, "friction (or friction_angle) is missing"),
        ("alpha=1..2 mu=1", None, "thickness is missing"),
        (
            "alpha=1..2 mu=1 eta=0.1 stones=3",
            Some(F::Stones),
            "stones does not go with the range of half_opening, which moves the joints",
        ),
        (
            "span=10m rise=2m±1cm mu=1 eta=0.1r stones=3",
            Some(F::Stones),
            "stones does not go with the range of rise",
        ),
        ("alpha=1 mu=1..2 eta=0.1 stones=3..4", Some(F::Stones), "one number of stones"),
        ("alpha=1..2 mu=1 eta=0.1 tilt=0.1", Some(F::Tilt), "level ground"),
        ("alpha=1 mu=1 eta=0.1 tilt=0.1..0.2", Some(F::Tilt), "tilt does not go with a range:"),
        ("joints=0,1..2 mu=1 eta=0.1", Some(F::Joints), "one value is read here"),
        (
            "alpha=1 radius=5m mu=1..2 eta=1m density=24kN/m3..22kN/m3 depth=1m",
            Some(F::Density),
            "24kN/m3..22kN/m3 is empty",
        ),
        ("alpha=1 radius=5m mu=1..2 eta=1m density=24kN/m3", Some(F::Density), "needs depth"),
        ("alpha=80..82deg mu=1 eta=0.1", Some(F::HalfOpening), "write 80deg..82deg"),
        (
            "alpha=82deg..80deg mu=1 eta=0.1",
            Some(F::HalfOpening),
            "82deg..80deg is empty: give the lower end first",
        ),
        (
            "alpha=90deg..180deg mu=1 eta=0.1",
            Some(F::HalfOpening),
            "180deg is not between 0 and pi",
        ),
        ("alpha=1 mu=0.7..0.6 eta=0.1", Some(F::Friction), "0.7..0.6 is empty"),
        ("alpha=1 mu=0.1±0.2 eta=0.1", Some(F::Friction), "the friction -0.1 is negative"),
        (
            "alpha=1 phi=89deg±2deg eta=0.1",
            Some(F::FrictionAngle),
            "91deg is not between 0 and pi/2",
        ),
        ("alpha=1 phi=32deg..31deg eta=0.1", Some(F::FrictionAngle), "is empty"),
        ("alpha=1 mu=1 eta=0.2..0.1", Some(F::Thickness), "0.2..0.1 is empty"),
        ("alpha=1 mu=1 eta=1.9±10%", Some(F::Thickness), "2.09 is not between 0 and 2"),
        ("alpha=1 mu=1 eta=50cm..60cm", Some(F::Thickness), "50cm is a length"),
        (
            "span=10m±1cm rise=3m mu=1 eta=50..60",
            Some(F::Thickness),
            "the thickness 50 has no unit",
        ),
        ("span=10m±1cm rise=3m mu=1 eta=0.1r..60cm", Some(F::Thickness), "two of a kind"),
        ("span=10m±1cm rise=3m mu=1 eta=60cm..50cm", Some(F::Thickness), "60cm..50cm is empty"),
        (
            "span=10m±1cm rise=3m mu=1 eta=5.5m±1m measured_at=extrados",
            Some(F::Thickness),
            "too large for this extrados",
        ),
        ("span=11m..10m rise=3m mu=1 eta=60cm", Some(F::Span), "11m..10m is empty"),
        ("span=1m±2m rise=3m mu=1 eta=60cm", Some(F::Span), "-1m is not above 0"),
        ("span=10m±1cm rise=3 mu=1 eta=60cm", Some(F::Rise), "is not a length"),
        ("span=10m±1cm rise=3m radius=5m mu=1 eta=60cm", Some(F::Radius), "the rest follows"),
        ("span=10m..11m alpha=1 mu=1 eta=60cm", Some(F::Radius), "the rest follows"),
        ("span=10m..11m radius=6m..7m mu=1 eta=60cm", Some(F::Thickness), "is a ratio"),
        ("span=10m..13m radius=6m mu=1 eta=0.1r", Some(F::Span), "its diameter is 12 m"),
        ("radius=6m..5m alpha=1 mu=1 eta=60cm", Some(F::Radius), "is empty"),
        (
            "radius=5m..6m alpha=1 mu=1 eta=6m measured_at=extrados",
            Some(F::Thickness),
            "at most 5 m",
        ),
        (
            "span=10m±1cm rise=3m mu=1 eta=60cm measured_at=top",
            Some(F::MeasuredAt),
            "one of intrados",
        ),
    ] {
        let misfit = read(words).unwrap_err();
        assert_eq!(misfit.field, field, "{words}: {misfit}");
        assert!(misfit.message.contains(why), "{words}: {misfit}");
    }
}

/// The range of one arch is that arch.
#[test]
fn a_range_without_extent_is_one_arch() {
    let given = read("alpha=1..1 mu=0.6±0 eta=0.1±0%").unwrap();
    let survey = given.survey(SelfWeight::Milankovitch).unwrap();
    assert_eq!(survey.corner(Side::Unsafe), survey.corner(Side::Safe));
}
