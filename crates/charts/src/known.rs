//! Known values below the lines of both weights: their landmarks and the tangents at T, to 15 digits.

use super::sheet::Sheet;
use crate::arch::SelfWeight;
use crate::atlas::tangent;
use crate::certify::{CertifiedLandmark, Error};
use crate::number::{Rounded, list};
use crate::problem::{Landmark, Line, Quantity};
use crate::report::{Answer, Value, words};

/// Digits, all proved.
const DIGITS: usize = 15;
const LANDMARKS: [Landmark; 6] =
    list![Landmark: Triple Shift Junction Border RotationEnd OverturningEnd];
/// The three curves through T: the other two lines there are one.
pub(super) const TANGENTS: [Line; 3] =
    [Line::RotationShoulder, Line::RotationInner, Line::AboveHaunchEnd];

/// A paragraph for each landmark and each tangent.
pub(super) fn known(sheets: &[Sheet]) -> Vec<String> {
    let each = |of: &dyn Fn(SelfWeight) -> String| -> String {
        sheets.iter().map(|sheet| of(sheet.weight)).collect::<Vec<_>>().join(" | ")
    };
    let title = format!("Landmarks: {}", each(&words::model));
    let point = |landmark: &Landmark| {
        let of = |weight| point(*landmark, weight);
        format!("{}: {}", words::symbol(*landmark), each(&of))
    };
    let line = |line: &Line| {
        let [one, other] = line.modes().map(|mode| mode.label());
        let second = if *line == Line::RotationInner { ", [s,r,r]/[s,s]" } else { "" };
        format!("{one}/{other}{second}: {}", each(&|weight| slope(*line, weight)))
    };
    let tangents = "Slopes dη/dφ at T, φ in rad (thin in the inset):".to_owned();
    let points = LANDMARKS.iter().map(point);
    [title].into_iter().chain(points).chain([tangents]).chain(TANGENTS.iter().map(line)).collect()
}

fn point(landmark: Landmark, weight: SelfWeight) -> String {
    let asked = [(Quantity::Friction, DIGITS), (Quantity::Thickness, DIGITS)];
    let proved = || -> Result<Answer, Error> {
        let point = CertifiedLandmark::new(landmark, weight)?;
        let constants = point.constants_of(&asked)?;
        Ok(Answer::landmark((landmark, weight), Ok((&point, constants))))
    };
    let Ok(answer) = proved() else { return "undecided".to_owned() };
    let text =
        |quantity| answer.value(quantity).map(Value::text).unwrap_or_default().replace("inf", "∞");
    format!("μ = {}, η = {}", text(Quantity::Friction), text(Quantity::Thickness))
}

fn slope(line: Line, weight: SelfWeight) -> String {
    let slope = tangent(line, weight, Landmark::Triple).ok();
    let rounded = slope.and_then(|slope| Rounded::from_ball(&slope, DIGITS));
    rounded.map_or("undecided".to_owned(), |rounded| rounded.value.to_string())
}
