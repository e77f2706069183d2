//! Report of what was proved, curve by curve, for a person.

use super::Map;
use super::rows::weight_of;
use crate::atlas::{Part, Piece, Trace};
use crate::report::Record;
use crate::report::words::{aligned, count};

/// Titles of the columns that name a curve.
pub(super) const TITLES: [&str; 5] = ["curve", "weight", "parameter", "from", "to"];

pub(super) fn names(trace: &Trace) -> [String; 5] {
    let [from, to] = trace.curve.ends().map(|end| end.to_string());
    let weight = weight_of(trace.curve, trace.weight).unwrap_or("any").to_owned();
    let parameter = trace.curve.parameter().name().to_owned();
    [trace.curve.to_string(), weight, parameter, from, to]
}

/// Summary of the curves.
pub(super) fn say(report: &Map, record: &mut Record) {
    let tolerance = report.tolerance;
    record
        .say(format!("The curves of the map, in tubes of a half-width of at most {tolerance:?}\n"));
    let titles = TITLES.into_iter().chain(["pieces", "widest"]).map(str::to_owned).collect();
    let cells = |trace: &Trace| -> Vec<String> {
        let found = [trace.pieces().count().to_string(), format!("{:.1e}", trace.width())];
        names(trace).into_iter().chain(found).collect()
    };
    let rows: Vec<Vec<String>> =
        std::iter::once(titles).chain(report.traces.iter().map(cells)).collect();
    let mut lines = aligned(&rows);
    let has_traces = !report.traces.is_empty();
    record.say_all(lines.next().filter(|_| has_traces));
    for (line, trace) in lines.zip(&report.traces) {
        record.say(line);
        record.say_all(trace.gaps().map(gap));
    }
    if has_traces && !(report.levels.is_empty() && report.borders.is_empty()) {
        record.say("");
    }
    for level in &report.levels {
        let modes: Vec<&str> = level.parts.iter().map(|part| part.mode.label()).collect();
        let (weight, modes) = (level.weight.name(), modes.join(" "));
        record.say(format!("{}, {weight}: {modes}", level.contour));
        let pieces = level.parts.iter().flat_map(Part::pieces);
        record.say_all(pieces.filter(|piece| !piece.is_proved()).map(gap));
    }
    for border in &report.borders {
        let (line, weight) = (border.line.name(), border.weight.name());
        let (pieces, width) = (border.section.pieces().count(), border.section.width());
        record.say(format!("{line}, {weight}: {pieces} pieces, widest {width:.1e}"));
        record.say_all(border.section.pieces().filter(|piece| !piece.is_proved()).map(gap));
    }
    record.say(format!("\n{}", verdict(report)));
}

/// Summary of the curves in a line: what was traced, and what is proved of it.
pub(super) fn summary(report: &Map) -> String {
    let curves = count(report.traces.len() as u64, "curve", "curves");
    let lines = match report.levels.len() + report.borders.len() {
        0 => String::new(),
        n => format!(" and {}", count(n as u64, "line of one value", "lines of one value")),
    };
    let (width, verdict) = (report.tolerance, verdict(report));
    format!("{curves}{lines}, in tubes of a half-width of at most {width:?}; {verdict}")
}

/// Statement of what is proved of all pieces, in words.
pub(super) fn verdict(report: &Map) -> String {
    let of_levels = report.levels.iter().flat_map(|level| &level.parts).flat_map(Part::pieces);
    let of_borders = report.borders.iter().flat_map(|border| border.section.pieces());
    let all = report.traces.iter().flat_map(Trace::pieces).chain(of_levels).chain(of_borders);
    match all.filter(|piece| !piece.is_proved()).count() {
        0 => {
            "proved: for each value of the parameter exactly one solution in the tube, from end to end"
                .to_owned()
        }
        n => format!("{} not proved", count(n as u64, "piece is", "pieces are")),
    }
}

/// A piece that is not proved.
fn gap(piece: Piece) -> String {
    let [from, to] = piece.range();
    format!("   not proved between {from} and {to}")
}
