//! Certificates of surveys, and their spoiled copies.

use super::originals::{file_alike, state, to_value, verdict};
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled};
use crate::arches::{H, M, number};
use crate::program::Json;
use couplet::arch::SelfWeight;
use couplet::certify::{certify_arch, certify_survey};
use couplet::check::{AcceptedFile, Refusal, SurveyRefusal};
use couplet::problem::Arch;
use couplet::problem::measures::Circle;
use couplet::problem::survey::{Shape, Side, Survey, SurveyVerdict};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::fmt::Debug;
use std::str::FromStr;
use std::sync::Mutex;

fn ends<T: FromStr<Err: Debug>>(range: &str) -> [T; 2] {
    let (first, last) = range.split_once("..").unwrap_or((range, range));
    [first, last].map(|text| text.parse().unwrap())
}

/// The survey of these ranges: half openings, frictions and thicknesses.
pub(super) fn free(weight: SelfWeight, [alpha, mu, eta]: [&str; 3]) -> Survey {
    let shape = Shape::Free { half_opening: ends(alpha), thickness: Some(ends(eta)) };
    Survey::new(weight, ends(mu), shape).unwrap()
}

/// The survey of these ranges: spans, rises, thicknesses and frictions.
pub(super) fn spanned(circle: Circle, [span, rise, t, mu]: [&str; 4]) -> Survey {
    let [span, rise, thickness] = [span, rise, t].map(ends);
    Survey::new(H, ends(mu), Shape::Spanned { circle, span, rise, thickness }).unwrap()
}

/// The certificate of a survey with 5 digits, which is made once.
pub(super) fn made(survey: &Survey) -> Original {
    static MADE: Mutex<Option<HashMap<String, &'static Value>>> = Mutex::new(None);
    let mut made = MADE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let make = || serde_json::to_value(certify_survey(survey, 5).unwrap()).unwrap();
    let made = made.get_or_insert_default().entry(format!("{survey:?}"));
    Original(made.or_insert_with(|| Box::leak(Box::new(make()))))
}

pub(super) fn all() -> Original {
    made(&free(M, ["70deg..80deg", "1/2..3/5", "1/10..1/5"]))
}

pub(super) fn none() -> Original {
    made(&free(M, ["80deg..90deg", "0.5..inf", "0.01..0.05"]))
}

/// None stands for want of friction.
fn none_as_they_slide() -> Original {
    made(&free(M, ["80deg..90deg", "0.1..tan(10deg)", "0.01..2"]))
}

fn both() -> Original {
    made(&free(M, ["70deg..80deg", "1/2..3/5", "0.06..0.2"]))
}

/// Covered by three steps, of which two lie on one leg.
pub(super) fn all_measured() -> Original {
    made(&spanned(Circle::Intrados, ["9m..11m", "2m..3m", "22cm..50cm", "0.7..0.8"]))
}

pub(super) fn none_measured() -> Original {
    made(&spanned(Circle::Centreline, ["9m..11m", "4.5m..5.5m", "5cm..10cm", "0.5..inf"]))
}

pub(super) fn both_measured() -> Original {
    made(&spanned(Circle::Extrados, ["9.9m..10.1m", "2.95m..3.05m", "10cm..50cm", "0.5..0.6"]))
}

fn originals() -> [Original; 7] {
    [all(), none(), none_as_they_slide(), both(), all_measured(), none_measured(), both_measured()]
}

fn format(words: &str) -> Refusal {
    Refusal::Format(words.to_owned())
}

fn given(place: &'static str, text: &str) -> Refusal {
    SurveyRefusal::Given { place, text: text.into() }.into()
}

fn arch(part: usize, place: &'static str) -> Refusal {
    SurveyRefusal::Arch { part, place }.into()
}

fn claim(part: usize, stands: bool, verdict: SurveyVerdict) -> Refusal {
    SurveyRefusal::Claim { part, stands, verdict }.into()
}

/// Objects of a file that are its own, and not of the certificates in it.
const OBJECTS: [&str; 5] = ["", "/survey", "/survey/spanned", "/parts/1", "/parts/1/step"];

/// The fields of each of these objects.
fn fields(original: Original) -> Vec<(&'static str, String)> {
    let keys = |place: &'static str| {
        let object = original.0.pointer(place).unwrap().as_object().unwrap();
        object.keys().map(move |key| (place, key.clone())).collect::<Vec<_>>()
    };
    OBJECTS.into_iter().flat_map(keys).collect()
}

/// Every field left out.
fn left_out() -> Cases {
    let reason = |place: &str, key: &str| match (place, key) {
        // Without its schema it is looked at as any other certificate.
        ("", "schema") => format("unknown field `parts`"),
        ("/survey", "spanned") => SurveyRefusal::Shape.into(),
        (_, "step") => SurveyRefusal::Step(2).into(),
        _ => format(&format!("missing field `{key}`")),
    };
    let case = |(place, key): (&'static str, String)| {
        (all_measured().without(place, &key), reason(place, &key))
    };
    fields(all_measured()).into_iter().map(case).collect()
}

/// Every field twice.
fn doubled() -> Cases {
    let text = all_measured().0.to_string();
    let case = |(place, key): (&'static str, String)| {
        let object = all_measured().0.pointer(place).unwrap();
        let twice = object.to_string().replacen('{', &format!("{{\"{key}\":{},", object[&key]), 1);
        let bytes = text.replacen(&object.to_string(), &twice, 1);
        (Spoiled::new(&key, bytes), format(&format!("duplicate field `{key}`")))
    };
    fields(all_measured()).into_iter().map(case).collect()
}

/// A field too many in every object.
fn one_more() -> Cases {
    let case = |place| {
        let copy = all_measured().changed(place, |copy| {
            copy.pointer_mut(place).unwrap()["extra"] = json!(1);
        });
        (copy, format("unknown field `extra`"))
    };
    OBJECTS.map(case).into()
}

/// Every field null.
fn nothing() -> Cases {
    let case = |(place, key): (&'static str, String)| {
        let reason = match (place, key.as_str()) {
            ("", "schema") => "unknown field `parts`",
            _ => "invalid type: null, expected ",
        };
        (all_measured().with(&format!("{place}/{key}"), Value::Null), format(reason))
    };
    fields(all_measured()).into_iter().map(case).collect()
}

/// A range of another number of ends.
fn other_ends() -> Cases {
    let ranges = [
        (all(), "/survey/friction", "friction"),
        (all(), "/survey/free/half_opening", "half_opening"),
        (all(), "/survey/free/thickness", "thickness"),
        (all_measured(), "/survey/spanned/span", "span"),
        (all_measured(), "/survey/spanned/rise", "rise"),
        (all_measured(), "/survey/spanned/thickness", "thickness"),
        (all_measured(), "/parts/1/step/span", "span"),
        (all_measured(), "/parts/1/step/rise", "rise"),
    ];
    let case = |(original, place, name): (Original, &str, &'static str)| {
        [0, 1, 3]
            .map(|ends| (original.with(place, vec!["1/1"; ends]), SurveyRefusal::Ends(name).into()))
    };
    ranges.into_iter().flat_map(case).collect()
}

/// A text as a refusal shows it.
fn shortened(text: &str) -> String {
    if text.len() > 40 { format!("{}…", &text[..40]) } else { text.to_owned() }
}

/// Neither a friction nor a length is given like this.
fn not_given_as(text: &str) -> Cases {
    let shown = shortened(text);
    vec![
        (all().with("/survey/friction/0", text), given("friction", &shown)),
        (all_measured().with("/survey/spanned/span/1", text), given("span", &shown)),
        (all_measured().with("/parts/0/step/rise/0", text), given("rise", &shown)),
    ]
}

/// No length is given like this.
fn no_length(text: &str) -> Cases {
    let shown = shortened(text);
    vec![
        (all_measured().with("/survey/spanned/thickness/0", text), given("thickness", &shown)),
        (all_measured().with("/parts/2/step/span/1", text), given("span", &shown)),
    ]
}

/// A copy with other parts, of those of one that is accepted.
fn parts(original: Original, chosen: &[usize]) -> Spoiled {
    original.changed(&format!("parts {chosen:?}"), |copy| {
        let old = copy["parts"].list().to_vec();
        copy["parts"] = chosen.iter().map(|&k| old[k].clone()).collect();
    })
}

/// A part with a certificate that is right, and is one of another arch.
fn certificate_of(original: Original, arch: &str, thickness: &str) -> Spoiled {
    let words: Vec<&str> = arch.split(' ').collect();
    let arch = Arch::parse(words[0], words[1], words[2]).unwrap();
    let made = certify_arch(&arch, Some(&number(thickness)), 5).unwrap();
    original.with("/parts/0/certificate", to_value(&made))
}

/// The ends of a step of `all_measured`, or of all of them from it on to the next.
fn with_step(part: usize, span: [&str; 2], rise: [&str; 2]) -> Spoiled {
    all_measured()
        .with(&format!("/parts/{part}/step"), json!({"span": span.to_vec(), "rise": rise.to_vec()}))
}

/// The two steps of `all_measured` on one leg meet elsewhere on it: their arches decide other steps.
fn a_step_that_is_longer() -> Spoiled {
    all_measured().changed("longer", |copy| {
        let end = copy["parts"][2]["step"].clone();
        let [first, last] =
            [0, 1].map(|k| [&end["span"][k], &end["rise"][k]].map(|text| text.text().to_owned()));
        let near = |a: &str, b: &str| {
            let [a, b] = [a, b].map(|text| text.parse::<rug::Rational>().unwrap());
            let near: rug::Rational = (a + b) / 2;
            format!("{}/{}", near.numer(), near.denom())
        };
        for (k, name) in ["span", "rise"].into_iter().enumerate() {
            let middle = near(&first[k], &last[k]);
            copy["parts"][1]["step"][name][1] = json!(middle);
            copy["parts"][2]["step"][name][0] = json!(middle);
        }
    })
}

const ALL: SurveyVerdict = SurveyVerdict::AllStand;
const NONE: SurveyVerdict = SurveyVerdict::NoneStands;
const BOTH: SurveyVerdict = SurveyVerdict::BothOccur;

refusals! {
    // The file.
    every_field_of_a_survey_left_out: left_out();
    every_field_of_a_survey_twice: doubled();
    a_field_too_many_in_every_object: one_more();
    every_field_of_a_survey_null: nothing();
    a_certificate_as_a_survey:
        Original(verdict("1.5", "0.1", "1")).with("/schema", "couplet.survey-certificate/1")
        => format("unknown field `claim`");
    a_survey_in_a_survey: all().changed("nested", |copy| copy["parts"][0]["certificate"] = copy.clone())
        => format("unknown field `parts`");
    too_many_parts: all().with("/parts", vec![all().0["parts"][0].clone(); 4097])
        => format("a list of more than 4096 entries");
    a_range_that_is_too_long: all().with("/survey/friction", vec!["1/2"; 33])
        => format("a list of more than 32 entries");
    two_shapes: all().changed("two", |copy| {
        copy["survey"]["spanned"] = all_measured().0["survey"]["spanned"].clone();
    }) => SurveyRefusal::Shape.into();
    ranges_of_other_ends: other_ends();
    texts_that_are_nothing_given: [
        "", "0.5", "-1/2", "1/2 m", "1/0",
    ].into_iter().flat_map(not_given_as).collect();
    an_end_of_many_digits: not_given_as(&format!("1/{}", "7".repeat(100_001)));
    texts_that_are_no_lengths: [
        "0/1", "inf", "1/1 pi",
    ].into_iter().flat_map(no_length).collect();
    a_length_of_many_digits: no_length(&format!("1/{}", "7".repeat(301)));

    // The parts that a verdict takes.
    no_parts: parts(all(), &[]) => SurveyRefusal::Parts { found: 0, expected: 1 }.into();
    no_steps: parts(all_measured(), &[]) => SurveyRefusal::End.into();
    a_part_twice: parts(all(), &[0, 0]) => SurveyRefusal::Parts { found: 2, expected: 1 }.into();
    one_of_both: parts(both(), &[0]) => SurveyRefusal::Parts { found: 1, expected: 2 }.into();
    one_of_both_measured: parts(both_measured(), &[1]) => SurveyRefusal::Parts { found: 1, expected: 2 }.into();
    both_the_other_way_round: parts(both(), &[1, 0]) => SurveyRefusal::Side(1, Side::Unsafe).into();
    both_measured_the_other_way_round: parts(both_measured(), &[1, 0]) => SurveyRefusal::Side(1, Side::Unsafe).into();
    a_step_of_a_free_survey: all().changed("step", |copy| {
        copy["parts"][0]["step"] = json!({"span": ["1/1", "1/1"], "rise": ["1/1", "1/1"]});
    }) => SurveyRefusal::Step(1).into();
    all_as_none_on_the_other_side: all().changed("none", |copy| {
        copy["verdict"] = json!("none_stands");
        copy["parts"][0]["side"] = json!("safe");
    }) => claim(1, false, NONE);
    none_as_all: none().changed("all", |copy| {
        copy["verdict"] = json!("all_stand");
        copy["parts"][0]["side"] = json!("unsafe");
    }) => claim(1, true, ALL);
    both_as_all: both().changed("all", |copy| {
        copy["verdict"] = json!("all_stand");
        copy["parts"][0] = copy["parts"][1].clone();
        copy["parts"][0]["side"] = json!("unsafe");
        copy["parts"].as_array_mut().unwrap().pop();
    }) => arch(1, "half_opening");
    both_as_none: both().changed("none", |copy| {
        copy["verdict"] = json!("none_stands");
        copy["parts"].as_array_mut().unwrap().pop();
        copy["parts"][0]["side"] = json!("safe");
    }) => arch(1, "half_opening");
    one_that_stands_for_one_that_does_not: both().changed("stands", |copy| {
        copy["parts"][0]["certificate"] = copy["parts"][1]["certificate"].clone();
    }) => claim(1, false, BOTH);

    // The course.
    the_first_step_is_missing: parts(all_measured(), &[1, 2]) => SurveyRefusal::Gap(1).into();
    a_step_in_the_middle_is_missing: parts(all_measured(), &[0, 2]) => SurveyRefusal::Gap(2).into();
    the_last_step_is_missing: parts(all_measured(), &[0, 1]) => SurveyRefusal::End.into();
    a_step_twice: parts(all_measured(), &[0, 0, 1, 2]) => SurveyRefusal::Gap(2).into();
    steps_in_another_order: parts(all_measured(), &[1, 0, 2]) => SurveyRefusal::Gap(1).into();
    a_step_beyond_the_last: parts(all_measured(), &[0, 1, 2, 2]) => SurveyRefusal::Gap(4).into();
    a_step_beside_the_course: with_step(0, ["10/1", "10/1"], ["2/1", "3/1"]) => SurveyRefusal::Beside(1).into();
    a_step_across_the_survey: with_step(0, ["11/1", "9/1"], ["2/1", "3/1"]) => SurveyRefusal::Beside(1).into();
    a_step_beyond_the_survey: with_step(2, ["11/1", "8/1"], ["3/1", "3/1"]) => SurveyRefusal::Beside(3).into();
    a_step_backwards: with_step(2, ["9/1", "11/1"], ["3/1", "3/1"]) => SurveyRefusal::Beside(3).into();
    a_step_of_the_other_course: with_step(0, ["11/1", "9/1"], ["2/1", "2/1"]) => SurveyRefusal::Beside(1).into();
    a_step_that_covers_more_than_its_arch: a_step_that_is_longer() => arch(2, "half_opening");
    a_step_for_a_single_arch: both_measured().changed("wide", |copy| {
        let rise = copy["survey"]["spanned"]["rise"].clone();
        let long = copy["survey"]["spanned"]["span"][1].clone();
        copy["parts"][0]["step"] = json!({"span": [long, long], "rise": rise});
    }) => SurveyRefusal::Wide(1).into();
    a_thicker_arch_that_stands: certificate_of(all(), "milankovitch 80deg 1/2", "0.11") => arch(1, "thickness");
    a_narrower_arch_that_stands: certificate_of(all(), "milankovitch 79deg 1/2", "0.1") => arch(1, "half_opening");
    a_rougher_arch_that_stands: certificate_of(all(), "milankovitch 80deg inf", "0.1") => arch(1, "friction");
    an_arch_of_another_weight_that_stands: certificate_of(all(), "heyman 80deg 1/2", "0.1") => arch(1, "weight");
    an_arch_that_is_nearly_that: certificate_of(all(), "milankovitch 1.3962634015954636 1/2", "0.1") => arch(1, "half_opening");
    a_thinner_arch_that_does_not_stand: certificate_of(none(), "milankovitch 80deg inf", "0.049") => arch(1, "thickness");
    a_narrow_arch_that_slides: certificate_of(none_as_they_slide(), "milankovitch 81deg tan(10deg)", "1") => arch(1, "half_opening");
    an_arch_that_does_not_stand: certificate_of(all(), "milankovitch 80deg 1/2", "0.01") => claim(1, true, ALL);
    a_state: all().with("/parts/0/certificate", state("2.45", "1.35").clone()) => claim(1, true, ALL);
    a_state_where_none_stands: none().with("/parts/0/certificate", state("2.45", "1.35").clone()) => claim(1, false, NONE);
}

/// The name of a variant. A new one has to be added here, and then needs a case.
pub(super) fn variant(refusal: &SurveyRefusal) -> &'static str {
    match refusal {
        SurveyRefusal::Shape => "Shape",
        SurveyRefusal::Name { .. } => "Name",
        SurveyRefusal::Ends(_) => "Ends",
        SurveyRefusal::Given { .. } => "Given",
        SurveyRefusal::Survey(_) => "Survey",
        SurveyRefusal::Parts { .. } => "Parts",
        SurveyRefusal::Side(..) => "Side",
        SurveyRefusal::Step(_) => "Step",
        SurveyRefusal::Beside(_) => "Beside",
        SurveyRefusal::Gap(_) => "Gap",
        SurveyRefusal::End => "End",
        SurveyRefusal::Wide(_) => "Wide",
        SurveyRefusal::Claim { .. } => "Claim",
        SurveyRefusal::Arch { .. } => "Arch",
    }
}

fn accepted(spoiled: &[u8]) -> SurveyVerdict {
    match file_alike(spoiled, MAX_DIGITS).unwrap() {
        AcceptedFile::Survey(accepted) => accepted.verdict,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_original_surveys_are_accepted() {
    let found = originals().map(|original| accepted(original.0.to_string().as_bytes()));
    assert_eq!(found, [ALL, NONE, NONE, BOTH, ALL, NONE, BOTH]);
    let kinds = |original: Original| {
        let claims = original.0["parts"].list().iter().map(|part| &part["certificate"]["claim"]);
        let all = ["slides", "too_wide", "too_thin", "stands"].into_iter();
        claims.filter_map(|of| all.clone().find(|kind| !of[*kind].is_null())).collect::<Vec<_>>()
    };
    assert_eq!(kinds(all_measured()), ["stands"; 3]);
    assert_eq!(kinds(none_as_they_slide()), ["slides"]);
    assert_eq!(kinds(both_measured()), ["too_thin", "stands"]);
}

/// What does not decide may change: the verdict is one on the other survey then.
#[test]
fn a_verdict_on_other_arches_that_the_same_ones_decide_is_accepted() {
    let changed = |original: Original, place: &str, value: &str| {
        let mut copy = original.0.clone();
        *copy.pointer_mut(place).unwrap() = json!(value);
        accepted(copy.to_string().as_bytes())
    };
    assert_eq!(changed(all(), "/survey/friction/1", "inf"), ALL);
    assert_eq!(changed(all(), "/survey/friction/0", "50/100"), ALL, "not in lowest terms");
    assert_eq!(changed(all(), "/survey/free/half_opening/0", "1/1000"), ALL);
    assert_eq!(changed(none(), "/survey/free/thickness/0", "1/1000"), NONE);
    assert_eq!(changed(none_as_they_slide(), "/survey/free/thickness/1", "1/1"), NONE);
    assert_eq!(changed(all_measured(), "/survey/spanned/thickness/1", "1/1"), ALL);
    assert_eq!(changed(all_measured(), "/parts/0/step/span/0", "110/10"), ALL);
}
