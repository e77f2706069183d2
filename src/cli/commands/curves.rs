//! Curves of the map, levels and landmarks, computed on all cores.

use super::constants::proved;
use crate::arch::SelfWeight;
use crate::atlas::{Border, Contour, Curve, Level, NoLevel, Trace};
use crate::certify::{Undecided, quantities};
use crate::problem::Landmark;
use crate::report::{Answer, Format};
use crate::sweep::failure::Failure;
use rayon::prelude::*;

/// Curves on all cores, and what of them is not proved. A picture needs all: without one it would show other domains.
pub(super) fn traced(
    asked: Vec<(SelfWeight, Curve)>,
    tolerance: f64,
    format: &Format,
) -> Result<(Vec<Trace>, Vec<String>), Failure> {
    let traced: Vec<Result<Trace, Undecided>> =
        asked.into_par_iter().map(|(weight, curve)| Trace::new(curve, weight, tolerance)).collect();
    let (mut traces, mut open) = (Vec::new(), Vec::new());
    for trace in traced {
        match trace {
            Ok(trace) => traces.push(trace),
            Err(undecided) => open.push(undecided.to_string()),
        }
    }
    if format.is_picture || format.is_page() {
        Failure::of_open(&open)?;
    }
    Ok((traces, open))
}

/// Digits of the landmarks on a page.
const LANDMARK_DIGITS: usize = 15;

/// The landmarks of a page.
pub(super) fn landmarks(weights: &[SelfWeight]) -> Vec<Answer> {
    let points =
        weights.iter().flat_map(|&weight| Landmark::ALL.map(|landmark| (landmark, weight)));
    let answer = |point: (Landmark, SelfWeight)| {
        let asked: Vec<_> = quantities(point.0).map(|of| (of, LANDMARK_DIGITS)).collect();
        let answer = proved(point, &asked, None, &|| ());
        answer.unwrap_or_else(|error| Answer::landmark(point, Err(&error)))
    };
    points.map(answer).collect()
}

/// Levels, by the curves that are there already or by others; what is not proved of them is added to what stays open.
pub(super) fn levels(
    contours: &[Contour],
    weights: &[SelfWeight],
    traces: &[Trace],
    tolerance: f64,
    open: &mut Vec<String>,
) -> Result<Vec<Level>, Failure> {
    if contours.is_empty() {
        return Ok(Vec::new());
    }
    let mut levels = Vec::new();
    for weight in weights {
        let has_all = Level::curves().all(|curve| {
            traces.iter().any(|trace| trace.curve == curve && trace.weight == *weight)
        });
        let others = if has_all { Vec::new() } else { Level::lines(*weight)? };
        let lines = if has_all { traces } else { &others[..] };
        let found: Vec<Result<Level, NoLevel>> = contours
            .par_iter()
            .map(|contour| Level::among(lines, *weight, contour, tolerance))
            .collect();
        for level in found {
            match level {
                Ok(level) => levels.push(level),
                Err(NoLevel::Outside(why)) => return Err(why.into()),
                Err(undecided) => open.push(undecided.to_string()),
            }
        }
    }
    Ok(levels)
}

/// The lines between asymmetric branches.
pub(super) fn borders(weights: &[SelfWeight], tolerance: f64) -> Result<Vec<Border>, Failure> {
    let all = weights.par_iter().map(|weight| Border::all(*weight, tolerance));
    let all: Result<Vec<Vec<Border>>, Undecided> = all.collect();
    Ok(all?.into_iter().flatten().collect())
}
