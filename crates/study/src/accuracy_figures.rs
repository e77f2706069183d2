//! The figures of the study of accuracy, from its rows.

use super::accuracy::{COMMAND, SINES};
use super::row::{Measurement, quartiles};
use couplet_draw::picture::figure::{Axis, Figure, Kind, Panel, PlottedLine, Scale};

/// Digits that a method has to reach to count in the performance profile.
const TARGET: f64 = 12.0;

/// Name and figure.
pub fn figures(rows: &[Measurement]) -> Vec<(&'static str, Figure)> {
    vec![
        ("error-against-time", error_against_time(rows)),
        ("performance-profile", profile(rows)),
        ("overestimation", overestimation(rows)),
    ]
}

/// The values of a key in the order in which they come.
pub(super) fn distinct<'a, R, T: PartialEq>(rows: &'a [R], key: impl Fn(&'a R) -> T) -> Vec<T> {
    rows.iter().map(key).fold(Vec::new(), |mut all, value| {
        if !all.contains(&value) {
            all.push(value);
        }
        all
    })
}

/// The median of some numbers.
fn median(values: Vec<f64>) -> Option<f64> {
    quartiles(values).map(|[_, median, _]| median)
}

/// A method without the number of joints behind it.
fn family(row: &Measurement) -> &str {
    row.method.split(", 1").next().unwrap_or(&row.method)
}

/// A method at one precision, over all cases of a kind of quantity.
struct ProfilePoint {
    /// The quartiles of its times.
    times: [f64; 3],
    /// The median of its correct digits; not a number where no case has any.
    digits: f64,
    /// True if the method has no value in some case.
    fails: bool,
}

impl ProfilePoint {
    fn of(rows: &[&Measurement]) -> Option<Self> {
        let times = quartiles(rows.iter().map(|row| row.cpu_seconds).collect())?;
        let digits = rows.iter().filter_map(|row| Some(-row.error_relative_log10?));
        let digits = median(digits.filter(|digits| digits.is_finite()).collect());
        let fails = rows.iter().any(|row| row.error_relative_log10.is_none());
        Some(Self { times, digits: digits.unwrap_or(f64::NAN), fails })
    }
}

/// The lines of a method: its medians, the quartiles of its times as bars, and a mark where a case has no value, at one
/// digit if none has.
fn lines_of(method: &str, rows: &[Measurement]) -> [PlottedLine; 3] {
    let keys = distinct(rows, |row| (row.precision_bits, &row.method));
    let points = keys.into_iter().filter_map(|key| {
        let group = rows.iter().filter(|row| (row.precision_bits, &row.method) == key);
        ProfilePoint::of(&group.collect::<Vec<_>>())
    });
    let points: Vec<ProfilePoint> = points.collect();
    let line =
        |kind, points: Vec<(f64, f64)>| PlottedLine { label: method.to_owned(), points, kind };
    let median = |point: &ProfilePoint| (point.times[1], point.digits);
    let bar = |point: &ProfilePoint| {
        let [low, _, high] = point.times;
        [(low, point.digits), (high, point.digits), (f64::NAN, f64::NAN)]
    };
    let failures = points.iter().filter(|point| point.fails);
    let failure = |point: &ProfilePoint| match point.digits.is_nan() {
        true => (point.times[1], 1.0),
        false => median(point),
    };
    let kind = if method == COMMAND { Kind::Bold } else { Kind::Measured };
    [
        line(kind, points.iter().map(median).collect()),
        line(Kind::Spread, points.iter().flat_map(bar).collect()),
        line(Kind::Failures, failures.map(failure).collect()),
    ]
}

/// Correct digits (the median over the cases) against CPU time, a panel for each kind of quantity. With
/// logarithmic axes sixteen digits and twenty thousand fit one panel, and where a method stops to improve
/// its line turns flat.
fn error_against_time(rows: &[Measurement]) -> Figure {
    let (sines, rows): (Vec<Measurement>, Vec<Measurement>) =
        rows.iter().cloned().partition(|row| row.quantity == SINES);
    let sine_points: Vec<(f64, f64)> = sines
        .iter()
        .filter_map(|row| Some((row.cpu_seconds, -row.error_relative_log10?)))
        .collect();
    let panels = distinct(&rows, |row| &row.quantity).into_iter().map(|quantity| {
        let here: Vec<Measurement> =
            rows.iter().filter(|r| r.quantity == *quantity).cloned().collect();
        let lines = distinct(&here, family).into_iter().flat_map(|method| {
            let of_method = here.iter().filter(|row| family(row) == method);
            lines_of(method, &of_method.cloned().collect::<Vec<_>>())
        });
        let unit = PlottedLine {
            label: "for comparison: a sine and a cosine".into(),
            points: sine_points.clone(),
            kind: Kind::Reference,
        };
        Panel {
            title: quantity.clone(),
            x: Axis { label: "CPU time (s)".into(), scale: Scale::Log10 },
            y: Axis { label: "correct digits (median case)".into(), scale: Scale::Log10 },
            lines: lines.chain([unit]).collect(),
        }
    });
    Figure {
        title: "Correct digits against run time, for the median case (the table has the worst); bars: quartiles of the \
                time over the cases; crossed rings: no value in some case"
            .into(),
        panels: panels.collect(),
        columns: 2,
    }
}

/// Dolan and Moré's performance profile: the part of the cases of a method that it solves to twelve digits in at
/// most so many times the time of the fastest method.
fn profile(rows: &[Measurement]) -> Figure {
    let rows: &[Measurement] =
        &rows.iter().filter(|r| r.quantity != SINES).cloned().collect::<Vec<_>>();
    let cases = distinct(rows, |row| (&row.quantity, &row.case));
    let methods = distinct(rows, family);
    let best = |case: &(&String, &String), method: Option<&str>| {
        rows.iter()
            .filter(|r| (&r.quantity, &r.case) == *case)
            .filter(|r| method.is_none_or(|method| family(r) == method))
            .filter(|r| r.error_relative_log10.is_some_and(|e| e <= -TARGET))
            .map(|r| r.cpu_seconds)
            .min_by(f64::total_cmp)
    };
    let profiles = methods.into_iter().map(|method| {
        let mut ratios: Vec<f64> = cases
            .iter()
            .filter_map(|case| Some(best(case, Some(method))? / best(case, None)?))
            .collect();
        ratios.sort_by(f64::total_cmp);
        (method, ratios)
    });
    let profiles: Vec<(&str, Vec<f64>)> = profiles.collect();
    let slowest = profiles.iter().flat_map(|(_, ratios)| ratios).fold(1.0, |a: f64, b| a.max(*b));
    let lines = profiles.iter().map(|(method, ratios)| {
        // A closed form has not failed where there is none.
        let of_method: Vec<Measurement> =
            rows.iter().filter(|row| family(row) == *method).cloned().collect();
        let measured = distinct(&of_method, |row| (&row.quantity, &row.case)).len();
        let part = |n: usize| (n + 1) as f64 / measured as f64;
        let points = ratios.iter().enumerate().map(|(n, ratio)| (*ratio, part(n)));
        // More time solves no more: what was reached holds to the end.
        let end = ratios.len().checked_sub(1).map(|last| (slowest, part(last)));
        let points = points.chain(end).collect();
        let label = match measured == cases.len() {
            true => (*method).to_owned(),
            false => format!("{method} (of {measured} cases)"),
        };
        PlottedLine { label, points, kind: Kind::Steps }
    });
    let panel = Panel {
        title: String::new(),
        x: Axis { label: "CPU time over that of the fastest method".into(), scale: Scale::Log10 },
        y: Axis { label: "part of its cases with 12 digits".into(), scale: Scale::Linear },
        lines: lines.collect(),
    };
    Figure { title: "Performance profile".into(), panels: vec![panel], columns: 1 }
}

/// Number of digits by which a claimed bound is above the true error, against the precision.
fn overestimation(rows: &[Measurement]) -> Figure {
    let claims: Vec<Measurement> =
        rows.iter().filter(|r| r.claimed_relative_log10.is_some()).cloned().collect();
    let panels = distinct(&claims, |row| &row.method).into_iter().map(|method| {
        let lines = distinct(&claims, |r| &r.quantity).into_iter().map(|quantity| {
            let points = distinct(&claims, |r| r.precision_bits).into_iter().filter_map(|bits| {
                let group = claims.iter().filter(|r| {
                    r.method == *method && r.quantity == *quantity && r.precision_bits == bits
                });
                let digits = group
                    .filter_map(|r| Some(r.claimed_relative_log10? - r.error_relative_log10?))
                    .filter(|digits| digits.is_finite());
                Some((f64::from(bits?), median(digits.collect())?))
            });
            PlottedLine { label: quantity.clone(), points: points.collect(), kind: Kind::Measured }
        });
        Panel {
            title: method.clone(),
            x: Axis { label: "precision (bits)".into(), scale: Scale::Log10 },
            y: Axis { label: "claimed over true error (digits)".into(), scale: Scale::Linear },
            lines: lines.collect(),
        }
    });
    Figure { title: "Overestimation".into(), panels: panels.collect(), columns: 2 }
}
