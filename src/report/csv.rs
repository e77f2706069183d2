//! CSV: one row per constant or printed number, with a header.

use super::{AssessReport, Audit, Constants, StateAt, StateOf, StateReport, reason, texts};
use crate::certify::state::{Figure, Frictions};
use std::io;

pub fn constants(report: &Constants, out: &mut dyn io::Write) -> io::Result<()> {
    let mut csv = ::csv::Writer::from_writer(out);
    csv.write_record(["weight", "landmark", "quantity", "value", "lower", "upper", "exact"])
        .map_err(io_error)?;
    let proved = report.landmarks.iter().filter_map(|entry| entry.outcome.as_ref().ok());
    for constant in proved.flat_map(|proved| &proved.constants) {
        let [value, lower, upper] = texts(&constant.value);
        csv.write_record([
            constant.weight.name(),
            constant.landmark.symbol(),
            constant.quantity.name(),
            &value,
            &lower,
            &upper,
            constant.exact.as_deref().unwrap_or_default(),
        ])
        .map_err(io_error)?;
    }
    csv.flush()
}

pub fn audit(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    let mut csv = ::csv::Writer::from_writer(out);
    csv.write_record([
        "place",
        "weight",
        "landmark",
        "quantity",
        "printed",
        "error_units",
        "correct_digits",
        "verdict",
    ])
    .map_err(io_error)?;
    for entry in &report.printed {
        csv.write_record([
            entry.printed.place,
            entry.printed.weight.name(),
            entry.printed.landmark.symbol(),
            entry.printed.quantity.name(),
            entry.printed.text,
            &entry.error_units.to_string(),
            &entry.correct_digits.to_string(),
            entry.verdict.name(),
        ])
        .map_err(io_error)?;
    }
    csv.flush()
}

/// The columns of a state.
pub const STATE_COLUMNS: [&str; 14] = [
    "weight",
    "half_opening",
    "friction",
    "verdict",
    "stands",
    "mode",
    "thickness",
    "thrust",
    "intrinsic_thrust",
    "rotation_joint",
    "sliding_joint",
    "sliding_friction",
    "rotational_friction",
    "reason",
];

/// The fields of a state, in the order of [`STATE_COLUMNS`].
pub fn state_record(report: &StateReport) -> Vec<String> {
    let mut record =
        vec![report.weight.name().to_owned(), report.half_opening.clone(), report.friction.clone()];
    let value = |figure: &Figure| figure.decimal.value.to_string();
    match &report.outcome {
        StateOf::Stands(state) => {
            record.extend(["proved", "true", state.mode.label()].map(str::to_owned));
            record.extend(
                [&state.thickness, &state.thrust, &state.intrinsic_thrust, &state.rotation_joint]
                    .map(value),
            );
            record.push(state.sliding_joint.as_ref().map(value).unwrap_or_default());
            record.extend(match &state.frictions {
                Some(Frictions { sliding, rotational }) => {
                    [value(sliding), rotational.as_ref().map_or("inf".to_owned(), value)]
                }
                None => [const { String::new() }; 2],
            });
            record.push(String::new());
        }
        StateOf::Falls(fall) => {
            record.extend(["proved", "false"].map(str::to_owned));
            record.resize(STATE_COLUMNS.len() - 1, String::new());
            record.push(reason(*fall).to_owned());
        }
        StateOf::Undecided(doubt) => {
            record.push("undecided".to_owned());
            record.resize(STATE_COLUMNS.len() - 1, String::new());
            record.push(doubt.reason.to_string());
        }
    }
    record
}

/// The columns of a state that hold values.
pub const STATE_VALUES: [&str; 7] = [
    "thickness",
    "thrust",
    "intrinsic_thrust",
    "rotation_joint",
    "sliding_joint",
    "sliding_friction",
    "rotational_friction",
];

/// The values of a state, in the order of [`STATE_VALUES`].
pub fn state_values<'a>(report: &'a StateReport) -> [Option<&'a Figure>; 7] {
    let StateOf::Stands(state) = &report.outcome else { return [None; 7] };
    let frictions = state.frictions.as_ref();
    [
        Some(&state.thickness),
        Some(&state.thrust),
        Some(&state.intrinsic_thrust),
        Some(&state.rotation_joint),
        state.sliding_joint.as_ref(),
        frictions.map(|frictions| &frictions.sliding),
        frictions.and_then(|frictions| frictions.rotational.as_ref()),
    ]
}

pub fn state(report: &StateReport, out: &mut dyn io::Write) -> io::Result<()> {
    one(&STATE_COLUMNS, &state_record(report), out)
}

pub fn state_at(report: &StateAt, out: &mut dyn io::Write) -> io::Result<()> {
    let mut csv = ::csv::Writer::from_writer(out);
    csv.write_record(["weight", "landmark", "modes", "quantity", "value", "lower", "upper"])
        .map_err(io_error)?;
    let modes: Vec<_> = report.modes.iter().map(|mode| mode.label()).collect();
    for constant in &report.constants {
        let [value, lower, upper] = texts(&constant.value);
        csv.write_record([
            report.weight.name(),
            report.landmark.symbol(),
            &modes.join(" "),
            constant.quantity.name(),
            &value,
            &lower,
            &upper,
        ])
        .map_err(io_error)?;
    }
    csv.flush()
}

/// The columns of an assessment.
pub const ASSESS_COLUMNS: [&str; 14] = [
    "weight",
    "half_opening",
    "friction",
    "thickness",
    "verdict",
    "stands",
    "least_thickness",
    "geometric_safety",
    "required_friction",
    "friction_safety",
    "least_thrust",
    "largest_thrust",
    "limited_by",
    "reason",
];

/// The columns of an assessment that hold values.
pub const ASSESS_VALUES: [&str; 6] = [
    "least_thickness",
    "geometric_safety",
    "required_friction",
    "friction_safety",
    "least_thrust",
    "largest_thrust",
];

/// The fields of an assessment, in the order of [`ASSESS_COLUMNS`].
pub fn assess_record(report: &AssessReport) -> Vec<String> {
    let mut record = vec![
        report.weight.name().to_owned(),
        report.half_opening.clone(),
        report.friction.clone(),
        report.thickness.clone(),
    ];
    let value =
        |x: &Option<Figure>| x.as_ref().map(|x| x.decimal.value.to_string()).unwrap_or_default();
    match report.outcome {
        Ok(found) => {
            record.extend(["proved".to_owned(), found.stands.to_string()]);
            record.push(value(&found.least_thickness.clone().ok()));
            record.extend(
                [&found.geometric_safety, &found.required_friction, &found.friction_safety]
                    .map(value),
            );
            match &found.thrust {
                Some(limits) => {
                    record.extend(limits.each_ref().map(|limit| {
                        limit
                            .thrust
                            .as_ref()
                            .map_or("inf".to_owned(), |x| x.decimal.value.to_string())
                    }));
                    record.push(limits.each_ref().map(|limit| limit.limited_by).join("; "));
                }
                None => record.resize(ASSESS_COLUMNS.len() - 1, String::new()),
            }
            record.push(
                found
                    .least_thickness
                    .as_ref()
                    .err()
                    .map(|f| reason(*f))
                    .unwrap_or_default()
                    .to_owned(),
            );
        }
        Err(doubt) => {
            record.push("undecided".to_owned());
            record.resize(ASSESS_COLUMNS.len() - 1, String::new());
            record.push(doubt.reason.to_string());
        }
    }
    record
}

pub fn assess(report: &AssessReport, out: &mut dyn io::Write) -> io::Result<()> {
    one(&ASSESS_COLUMNS, &assess_record(report), out)
}

/// A header and one row.
fn one(columns: &[&str], record: &[String], out: &mut dyn io::Write) -> io::Result<()> {
    let mut csv = ::csv::Writer::from_writer(out);
    csv.write_record(columns).map_err(io_error)?;
    csv.write_record(record).map_err(io_error)?;
    csv.flush()
}

/// The error of the stream itself: its kind tells a closed pipe from a full disk.
pub fn io_error(error: ::csv::Error) -> io::Error {
    match error.into_kind() {
        ::csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
