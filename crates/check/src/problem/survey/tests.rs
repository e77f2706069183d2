//! Arches that decide, steps of a course, and what is no survey.

use super::*;

fn numbers(range: [&str; 2]) -> [ExactNumber; 2] {
    range.map(|x| x.parse().unwrap())
}

fn frictions(range: [&str; 2]) -> [Friction; 2] {
    range.map(|x| x.parse().unwrap())
}

fn lengths(range: [&str; 2]) -> [Length; 2] {
    range.map(|x| x.parse().unwrap())
}

fn free(alpha: [&str; 2], mu: [&str; 2], eta: [&str; 2]) -> Result<Survey, SurveyError> {
    let shape = Shape::Free { half_opening: numbers(alpha), thickness: Some(numbers(eta)) };
    Survey::new(SelfWeight::Heyman, frictions(mu), shape)
}

fn spanned(span: [&str; 2], rise: [&str; 2], t: [&str; 2]) -> Survey {
    let shape = Shape::Spanned {
        circle: Circle::Intrados,
        span: lengths(span),
        rise: lengths(rise),
        thickness: lengths(t),
    };
    Survey::new(SelfWeight::Heyman, frictions(["0.5", "0.6"]), shape).unwrap()
}

#[test]
fn the_corners_are_the_widest_thinnest_and_the_narrowest_thickest_arch() {
    let survey = free(["80deg", "1.5"], ["31deg", "0.7"], ["0.1", "0.2"]).unwrap();
    let worst = survey.corner(Side::Unsafe).unwrap();
    assert_eq!(worst.arch.to_string(), "heyman, half opening 1.5, friction tan(31deg)");
    assert_eq!(worst.thickness.unwrap().to_string(), "0.1");
    let best = survey.corner(Side::Safe).unwrap();
    assert_eq!(best.arch.to_string(), "heyman, half opening 80deg, friction 0.7");
    assert!(survey.course(Side::Safe).is_none());
}

#[test]
fn what_is_no_range_of_arches_is_refused() {
    let points = free(["pi/2", "90deg"], ["1/2", "0.5"], ["1/5", "0.2"]);
    assert!(points.is_ok(), "one arch in two spellings");
    for (alpha, mu, eta, why) in [
        (["1.5", "80deg"], ["0", "1"], ["0.1", "0.2"], "1.5..80deg is empty"),
        (["1", "180deg"], ["0", "1"], ["0.1", "0.2"], "not between 0 and pi"),
        (["1", "2"], ["inf", "1"], ["0.1", "0.2"], "inf..1 is empty"),
        (["1", "2"], ["45deg", "0.99"], ["0.1", "0.2"], "tan(45deg)..0.99 is empty"),
        (["1", "2"], ["-0.1", "1"], ["0.1", "0.2"], "negative"),
        (["1", "2"], ["0", "1"], ["0", "0.2"], "0 is not between"),
        (["1", "2"], ["0", "1"], ["0.1", "2.01"], "2.01 is not between"),
        (["1", "2"], ["45deg", "1"], ["0.1", "0.2"], "stays open"),
    ] {
        let error = free(alpha, mu, eta).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
}

/// The arches of a rectangle, on a grid, are bounded by a step of each course.
#[test]
fn a_course_bounds_every_arch_of_its_rectangle() {
    let number = |n: i32, d: i32| BigRational::new(n.into(), d.into());
    for (span, rise) in [
        (["9.8m", "10.2m"], ["2.9m", "3.1m"]),
        (["5m", "6m"], ["2m", "4m"]),
        (["3m", "3m"], ["2m", "3m"]),
    ] {
        let survey = spanned(span, rise, ["50cm", "60cm"]);
        let [unsafely, safely] =
            [Side::Unsafe, Side::Safe].map(|side| survey.course(side).unwrap());
        let [[span_0, span_1], [rise_0, rise_1]] =
            [lengths(span), lengths(rise)].map(|x| x.map(|x| x.metres().clone()));
        let eta = |at: &SpanAndRise, t: &BigRational| {
            t / (&circle(&at[0], &at[1])[1] + t / BigInt::from(2))
        };
        for i in 0..=6 {
            for j in 0..=6 {
                let at = [
                    &span_0 + (&span_1 - &span_0) * number(i, 6),
                    &rise_0 + (&rise_1 - &rise_0) * number(j, 6),
                ];
                let q = &at[1] / &at[0];
                for (side, course, t) in
                    [(Side::Unsafe, &unsafely, number(1, 2)), (Side::Safe, &safely, number(3, 5))]
                {
                    let q_of = |at: &SpanAndRise| &at[1] / &at[0];
                    let step = course.windows(2).find(|step| q_of(&step[1]) >= q).unwrap();
                    let bound = survey.bounding(side, [&step[0], &step[1]]).unwrap();
                    let bound_eta = bound.thickness.unwrap().factor().clone();
                    let tangent = ExactNumber::twice_arctangent(q.clone() * BigInt::from(2));
                    let range = [&tangent, bound.arch.half_opening()].map(Clone::clone);
                    match side {
                        Side::Unsafe => {
                            assert!(in_order(&range).is_ok() && bound_eta <= eta(&at, &t));
                        }
                        Side::Safe => {
                            let [a, b] = range;
                            assert!(in_order(&[b, a]).is_ok() && bound_eta >= eta(&at, &t));
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn a_step_lies_on_one_leg_and_goes_its_way() {
    let survey = spanned(["9m", "10m"], ["2m", "3m"], ["50cm", "60cm"]);
    let place = |[span, rise]: [i32; 2]| -> SpanAndRise {
        [span, rise].map(|tenths| BigRational::new(tenths.into(), 10.into()))
    };
    let has = |side, first, last| survey.has_step(side, [&place(first), &place(last)]);
    for (side, first, last) in [
        (Side::Unsafe, [100, 20], [100, 30]),
        (Side::Unsafe, [100, 22], [100, 22]),
        (Side::Unsafe, [98, 30], [95, 30]),
        (Side::Safe, [100, 20], [90, 20]),
        (Side::Safe, [90, 20], [90, 30]),
    ] {
        assert!(has(side, first, last), "{side:?} {first:?} {last:?}");
        assert!(first == last || !has(side, last, first), "{side:?} {first:?} {last:?}");
    }
    for (side, first, last) in [
        (Side::Unsafe, [100, 29], [99, 30]),
        (Side::Unsafe, [100, 19], [100, 21]),
        (Side::Unsafe, [100, 29], [100, 31]),
        (Side::Unsafe, [90, 30], [89, 30]),
        (Side::Unsafe, [95, 20], [95, 20]),
        (Side::Unsafe, [100, 20], [90, 30]),
        (Side::Safe, [100, 30], [90, 30]),
        (Side::Safe, [91, 20], [90, 21]),
    ] {
        assert!(!has(side, first, last), "{side:?} {first:?} {last:?}");
    }
}

/// Ends of many digits that differ in the last one: their continued fractions are long.
#[test]
fn long_ends_are_compared() {
    let long = |last: &str| format!("1.{}{last}", "37".repeat(9_000));
    let (low, high) = (long("1"), long("2"));
    let made = |range: [&str; 2]| free(range, ["0", "1"], ["0.1", "0.2"]);
    assert!(made([&low, &high]).is_ok());
    assert!(made([&high, &low]).unwrap_err().to_string().contains("is empty"));
}

#[test]
fn a_thickness_beyond_the_least_radius_is_refused() {
    let shape = Shape::Spanned {
        circle: Circle::Extrados,
        span: lengths(["4m", "6m"]),
        rise: lengths(["1m", "4m"]),
        thickness: lengths(["1m", "2.1m"]),
    };
    let made = Survey::new(SelfWeight::Heyman, frictions(["1", "1"]), shape);
    assert!(made.unwrap_err().to_string().contains("at most 2 m"));
}
