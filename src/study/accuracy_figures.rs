//! The figures of the study of accuracy, from its rows.

use super::accuracy::SINES;
use super::row::Row;
use crate::picture::figure::{Axis, Figure, Kind, Line, Panel, Scale};

/// Digits that a method has to reach to count in the performance profile.
const TARGET: f64 = 12.0;

/// Name and figure.
pub fn figures(rows: &[Row]) -> Vec<(&'static str, Figure)> {
    vec![
        ("error-against-time", error_against_time(rows)),
        ("performance-profile", profile(rows)),
        ("overestimation", overestimation(rows)),
    ]
}

/// The values of a key in the order in which they come.
fn distinct<'a, T: PartialEq>(rows: &'a [Row], key: impl Fn(&'a Row) -> T) -> Vec<T> {
    rows.iter().map(key).fold(Vec::new(), |mut all, value| {
        if !all.contains(&value) {
            all.push(value);
        }
        all
    })
}

/// The median of some numbers.
fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// A method without the number of joints behind it.
fn family(row: &Row) -> &str {
    row.method.split(", 1").next().unwrap_or(&row.method)
}

/// Correct digits (the median over the cases) against CPU time, a panel for each kind of quantity. With
/// logarithmic axes sixteen digits and twenty thousand fit one panel, and where a method stops to improve
/// its line turns flat.
fn error_against_time(rows: &[Row]) -> Figure {
    let (sines, rows): (Vec<Row>, Vec<Row>) =
        rows.iter().cloned().partition(|row| row.quantity == SINES);
    let rows = &rows;
    let sine_points: Vec<(f64, f64)> = sines
        .iter()
        .filter_map(|row| Some((row.cpu_seconds, -row.error_relative_log10?)))
        .collect();
    let panels = distinct(rows, |row| &row.quantity).into_iter().map(|quantity| {
        let here: Vec<Row> = rows.iter().filter(|r| r.quantity == *quantity).cloned().collect();
        let lines = distinct(&here, family).into_iter().map(|method| {
            let of_method: Vec<Row> =
                here.iter().filter(|r| family(r) == method).cloned().collect();
            let points = distinct(&of_method, |r| (r.precision_bits, r.method.clone()))
                .into_iter()
                .filter_map(|key| {
                    let group = || {
                        let same = |r: &&Row| (r.precision_bits, r.method.clone()) == key;
                        of_method.iter().filter(same)
                    };
                    let time = median(group().map(|r| r.cpu_seconds).collect())?;
                    let digits = group().filter_map(|r| Some(-r.error_relative_log10?));
                    Some((time, median(digits.filter(|d| d.is_finite()).collect())?))
                });
            Line { label: method.to_owned(), points: points.collect(), kind: Kind::Measured }
        });
        let unit = Line {
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
        title: "Correct digits against run time, for the median case (the table has the worst)"
            .into(),
        panels: panels.collect(),
        columns: 2,
    }
}

/// Dolan and Moré's performance profile: the part of all cases that a method solves to twelve digits in at
/// most so many times the time of the fastest method.
fn profile(rows: &[Row]) -> Figure {
    let rows: &[Row] = &rows.iter().filter(|r| r.quantity != SINES).cloned().collect::<Vec<_>>();
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
        let part = |n: usize| (n + 1) as f64 / cases.len() as f64;
        let points = ratios.iter().enumerate().map(|(n, ratio)| (*ratio, part(n)));
        // More time solves no more: what was reached holds to the end.
        let end = ratios.len().checked_sub(1).map(|last| (slowest, part(last)));
        let points = points.chain(end).collect();
        Line { label: (*method).to_owned(), points, kind: Kind::Steps }
    });
    let panel = Panel {
        title: String::new(),
        x: Axis { label: "CPU time over that of the fastest method".into(), scale: Scale::Log10 },
        y: Axis { label: "part of all cases with 12 digits".into(), scale: Scale::Linear },
        lines: lines.collect(),
    };
    Figure { title: "Performance profile".into(), panels: vec![panel], columns: 1 }
}

/// By how many digits a claimed bound is above the true error, against the precision.
fn overestimation(rows: &[Row]) -> Figure {
    let claims: Vec<Row> =
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
            Line { label: quantity.clone(), points: points.collect(), kind: Kind::Measured }
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
