//! Whatever the survey, and whatever is done to its certificate: what is accepted is so of arches in it.

use super::originals::answers;
use super::spoiler::spoiled;
use super::survey::{free, made, spanned};
use crate::arches::{H, M};
use crate::hard::{config, weights};
use couplet::certify::state::Certify;
use couplet::certify::{Error, certify_survey};
use couplet::check::{AcceptedFile, AcceptedSurvey};
use couplet::number::{AstroInterval, Enclosure, ExactNumber};
use couplet::problem::measures::{Circle, Length, Measures, of_span_and_rise};
use couplet::problem::survey::{Shape, Survey, SurveyVerdict};
use couplet::problem::{Arch, Friction};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde_json::Value;
use std::cell::Cell;

/// The largest number of digits in this file.
const MAX_DIGITS: usize = 40;

/// Both ends, and where they are of one form what lies in the middle.
fn some([first, last]: &[ExactNumber; 2]) -> Vec<ExactNumber> {
    let middle = (first.form() == last.form()).then(|| {
        let sum = first.factor() + last.factor();
        let below = sum.denom() * 2i32;
        ExactNumber::fraction(sum.numer().clone(), below, first.form()).unwrap()
    });
    [Some(first.clone()), middle, Some(last.clone())].into_iter().flatten().collect()
}

fn lengths(range: &[Length; 2]) -> Vec<Length> {
    let exact = range.each_ref().map(|length| ExactNumber::rational(length.metres().clone()));
    some(&exact).iter().map(|x| format!("{}m", x.factor()).parse().unwrap()).collect()
}

/// Arches of a survey with their thicknesses: its ends, and some between.
fn arches(survey: &Survey) -> Vec<(Arch, ExactNumber)> {
    let mut shapes = Vec::new();
    match survey.shape() {
        Shape::Free { half_opening, thickness } => {
            for alpha in some(half_opening) {
                let thicknesses = some(thickness.as_ref().unwrap());
                shapes.extend(thicknesses.into_iter().map(|eta| (alpha.clone(), eta)));
            }
        }
        Shape::Spanned { circle, span, rise, thickness } => {
            for span in lengths(span) {
                for rise in lengths(rise) {
                    let (alpha, radius) = of_span_and_rise(&span, &rise);
                    let measures = Measures::new(*circle, radius, None);
                    shapes.extend(
                        thickness.iter().map(|t| (alpha.clone(), measures.thickness(t).unwrap())),
                    );
                }
            }
        }
    }
    let with = |friction: &Friction| {
        let arch = |(alpha, eta): &(ExactNumber, ExactNumber)| {
            let arch = Arch::new(survey.weight(), alpha.clone(), friction.clone());
            (arch.unwrap(), eta.clone())
        };
        shapes.iter().map(arch).collect::<Vec<_>>()
    };
    survey.friction().iter().flat_map(with).collect()
}

/// Whether the solver says the same of these arches.
fn is_so(verdict: SurveyVerdict, survey: &Survey) -> bool {
    let stands = |(arch, eta): (Arch, ExactNumber)| arch.certify_thickness(&eta, 2).unwrap().stands;
    let found: Vec<bool> = arches(survey).into_iter().filter_map(|of| stands(of).ok()).collect();
    match verdict {
        SurveyVerdict::AllStand => found.iter().all(|stands| *stands),
        SurveyVerdict::NoneStands => !found.contains(&true),
        // Of a course the extremes may lie elsewhere than at these arches, if hardly ever.
        SurveyVerdict::BothOccur => found.contains(&true) && found.contains(&false),
    }
}

fn accepted(bytes: &[u8]) -> Option<AcceptedSurvey> {
    let file = answers(bytes, MAX_DIGITS).into_iter().find_map(Result::ok)?;
    match file {
        AcceptedFile::Survey(accepted) => Some(accepted),
        AcceptedFile::Certificate(_) => None,
    }
}

fn originals() -> Vec<&'static Value> {
    let surveys = [
        free(M, ["70deg..80deg", "1/2..3/5", "1/10..1/5"]),
        free(M, ["80deg..90deg", "0.5..inf", "0.01..0.05"]),
        free(H, ["80deg..90deg", "0.1..0.2", "0.01..2"]),
        free(M, ["70deg..80deg", "1/2..3/5", "0.06..0.2"]),
        spanned(Circle::Intrados, ["9m..11m", "2m..3m", "22cm..50cm", "0.7..0.8"]),
        spanned(Circle::Extrados, ["9.9m..10.1m", "2.95m..3.05m", "10cm..50cm", "0.5..0.6"]),
    ];
    surveys.iter().map(|survey| made(survey).0).collect()
}

#[test]
fn what_is_accepted_of_a_survey_after_changes_is_true() {
    spoiled(2000, [[50, 500], [15, 500]], &originals(), |bytes| {
        let accepted = accepted(bytes);
        if let Some(AcceptedSurvey { survey, verdict, .. }) = &accepted {
            assert!(is_so(*verdict, survey), "{verdict:?} {survey:?}");
        }
        accepted.is_some()
    });
}

/// A survey that is made: two ends of everything, between which any arch may be.
fn surveys() -> impl Strategy<Value = Survey> {
    let ends = |size: std::ops::Range<u32>, width: u32| {
        (size, 0..width).prop_map(|(low, more)| [low, low + more])
    };
    let rational = |[low, high]: [u32; 2], below: i32| {
        [low, high].map(|x| {
            ExactNumber::fraction(x.into(), below.into(), couplet::number::Form::Rational).unwrap()
        })
    };
    let metres = |ends: [u32; 2]| ends.map(|cm| format!("{cm}cm").parse::<Length>().unwrap());
    let friction =
        ends(10..160, 40).prop_map(move |mu| rational(mu, 100).map(Friction::Coefficient));
    let free = (ends(20..240, 30), ends(1..600, 300)).prop_map(move |(alpha, eta)| Shape::Free {
        half_opening: rational(alpha, 100),
        thickness: Some(rational(eta, 1000)),
    });
    let circle =
        prop_oneof![Just(Circle::Intrados), Just(Circle::Centreline), Just(Circle::Extrados)];
    let spanned = (circle, ends(300..1000, 100), ends(100..600, 100), ends(5..90, 30)).prop_map(
        move |(circle, span, rise, t)| {
            let [span, rise, thickness] = [span, rise, t].map(metres);
            Shape::Spanned { circle, span, rise, thickness }
        },
    );
    (weights(), friction, prop_oneof![free, spanned])
        .prop_filter_map("a survey", |(weight, mu, shape)| Survey::new(weight, mu, shape).ok())
}

/// The verdict on any survey is the one on its arches; which ones decide is not looked at here.
#[test]
fn a_verdict_on_a_survey_is_that_on_its_arches() {
    let counts: [Cell<u32>; 3] = Default::default();
    let open = Cell::new(0);
    let config = config(150);
    TestRunner::new(config.clone())
        .run(&surveys(), |survey| {
            let made = match certify_survey(&survey, 3) {
                Ok(made) => made,
                Err(Error::Undecided(_)) => {
                    open.set(open.get() + 1);
                    return Ok(());
                }
                Err(error) => panic!("{survey:?}: {error}"),
            };
            let AcceptedSurvey { survey: read, verdict, .. } =
                accepted(&serde_json::to_vec(&made).unwrap()).unwrap();
            let half_openings = [&survey, &read].map(|survey| {
                survey.half_opening().map(|alpha| alpha.enclosure::<AstroInterval>(64))
            });
            let [[a, b], [c, d]] = half_openings;
            assert!(a.overlaps(&c) && b.overlaps(&d));
            if verdict != SurveyVerdict::BothOccur || matches!(survey.shape(), Shape::Free { .. }) {
                assert!(is_so(verdict, &survey), "{verdict:?} {survey:?}");
            }
            let count = &counts[SurveyVerdict::ALL.iter().position(|of| *of == verdict).unwrap()];
            count.set(count.get() + 1);
            Ok(())
        })
        .unwrap_or_else(|failure| panic!("{failure}"));
    let counts = counts.map(|count| count.get());
    let few = config.cases / 15;
    assert!(counts.iter().all(|count| *count >= few), "{counts:?}");
    assert!(open.get() <= config.cases.div_ceil(30), "{open:?} of {}", config.cases);
}
