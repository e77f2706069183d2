//! All rows for a person at a terminal: verdicts, numbers, a histogram, the worst rows.

use super::row::{JudgedRow, certified, digits};
use super::summary::{JudgeSummary, QuantitySummary};
use crate::judge::{CorrectDigits, Judged, Verdict};
use crate::record::Record;
use crate::words::{count, shortened};

/// The whole summary.
pub(super) fn say(summary: &JudgeSummary, record: &mut Record) {
    record.say_all(verdicts(summary));
    numbers(summary, record);
    histogram(summary, record);
    if !summary.worst.is_empty() {
        record.say("\nworst rows");
        summary.worst.iter().for_each(|row| judged_row(row, record));
    }
    if !summary.unjudged.is_empty() {
        record.say("\nfirst rows that are not judged");
        for row in &summary.unjudged {
            let reason = row.reason().map_or(String::new(), |reason| format!(": {reason}"));
            record.say(format!("   line {}: {}{reason}", row.line, row.verdict().name()));
        }
    }
}

/// Number of rows that have each verdict, and how many pass.
pub fn verdicts(summary: &JudgeSummary) -> Vec<String> {
    let (rows, accepted) = (summary.rows, summary.accepted());
    let demanded = count(summary.demand.digits, "digit", "digits");
    let demanded = match summary.demand.or_as_printed {
        true => format!("every number right as printed, or correct to {demanded}"),
        false => format!("every number correct to {demanded}"),
    };
    let rows = count(rows, "row", "rows");
    let mut lines = vec![format!("{rows}: {accepted} accepted ({demanded})")];
    lines.extend(summary.assumed.map(|weight| {
        format!("weight: {}, as neither the rows nor --weight say any", weight.name())
    }));
    lines.push(String::new());
    for verdict in Verdict::ALL {
        let rows = summary.count(verdict);
        let side = match verdict {
            Verdict::Thinner => " (the unsafe side)",
            Verdict::Thicker => " (the safe side)",
            _ => "",
        };
        lines.extend((rows > 0).then(|| format!("{rows:>9}  {}{side}", verdict.name())));
    }
    lines
}

fn numbers(summary: &JudgeSummary, record: &mut Record) {
    if summary.quantities.is_empty() {
        return;
    }
    let titles = "numbers,judged,rounded,faithful,wrong,doubles,digits,relative error";
    let cells = |m: &QuantitySummary| {
        let relative = m.largest_relative.as_ref().map_or(String::new(), ToString::to_string);
        let counts = [m.judged, m.correctly_rounded, m.faithful, m.wrong(), m.nearest_doubles];
        let counts = counts.map(|count| count.to_string());
        [&[m.quantity.name().to_owned()], &counts[..], &[digits(m.least), relative]].concat()
    };
    let titles = titles.split(',').map(str::to_owned).collect();
    record.say("");
    for row in std::iter::once(titles).chain(summary.quantities.iter().map(cells)) {
        let [name, counts @ .., digits, relative] = &row[..] else { continue };
        let counts: String = counts.iter().map(|count| format!(" {count:>9}")).collect();
        record.say(format!("{name:<19}{counts} {digits:>7} {relative:>14}"));
    }
    record.say(
        "rounded, faithful, wrong: in the last printed place; doubles: the nearest to the truth;",
    );
    record.say("digits, relative error: of the worst");
    if summary.thinner + summary.thicker > 0 {
        let (thinner, thicker) = (summary.thinner, summary.thicker);
        record.say(format!("thicknesses below the least: {thinner} (the unsafe side, even if only by rounding); above: {thicker}"
        ));
    }
}

/// Characters of the longest bar.
const BAR: u64 = 40;

fn histogram(summary: &JudgeSummary, record: &mut Record) {
    let Some(most) = summary.histogram.values().max() else { return };
    record.say("\ncorrect digits of the worst number of a row");
    for (correct, rows) in &summary.histogram {
        let name = match correct {
            CorrectDigits::Exact => "exact".to_owned(),
            CorrectDigits::Digits(digits) => digits.to_string(),
        };
        let bar = "#".repeat((rows * BAR).div_ceil(*most) as usize);
        record.say(format!("{name:>9}  {bar:<40} {rows:>9}"));
    }
}

/// The fault of a row, and its worst number.
fn judged_row(row: &JudgedRow, record: &mut Record) {
    let what = match row.verdict() {
        Verdict::Correct => match row.correct_digits() {
            Some(CorrectDigits::Digits(digits)) => {
                format!("correct to {}", count(digits, "digit", "digits"))
            }
            _ => "correct".to_owned(),
        },
        verdict => verdict.name().to_owned(),
    };
    let thickness =
        row.thickness().map(|eta| format!(", thickness {}", shortened(&eta.to_string())));
    record.say(format!(
        "   line {}: {what}; {}, half opening {}, friction {}{}",
        row.line,
        shortened(&row.weight),
        shortened(&row.half_opening),
        shortened(&row.friction),
        thickness.unwrap_or_default()
    ));
    let modes = row.modes().unwrap_or_default();
    match row.verdict() {
        Verdict::WrongMode => {
            let claimed = row.claimed_mode().unwrap_or_default();
            record.say(format!("      mode {claimed}, certified {modes}"));
        }
        Verdict::Falls => match row.reason() {
            Some(reason) => record.say(format!("      it falls by {reason}")),
            None => record.say("      it falls at this thickness"),
        },
        Verdict::Stands if row.thickness().is_some() => record.say("      it stands"),
        Verdict::Stands => record.say(format!("      it stands, and collapses as {modes}")),
        _ => {}
    }
    if let Some(boundary) = row.judgement().and_then(|found| found.boundary.as_ref()) {
        let (claimed, quantity) =
            (row.claimed_mode().unwrap_or_default(), boundary.quantity.name());
        let within = &boundary.within;
        record.say(format!(
            "      it is {claimed} at a {quantity} less than {within} away, within its rounding"
        ));
    }
    match row.numbers().iter().min_by_key(|number| number.correct_digits) {
        Some(number) if number.correct_digits != CorrectDigits::Exact => {
            record.say(format!("      {}", number_text(number)));
        }
        _ => {}
    }
}

/// Powers of ten beyond which ulp are not shown.
const MANY_ULP: i64 = 6;

fn number_text(number: &Judged) -> String {
    let mut text = format!(
        "{} {}, certified {}",
        number.quantity.name(),
        shortened(&number.claimed),
        shortened(&certified(&number.certified).to_string())
    );
    if let Some(errors) = &number.errors {
        let relative = match &errors.relative {
            Some(relative) => format!(", relative {relative}"),
            None => String::new(),
        };
        let units = errors.units.to_string();
        let noun = if units == "1" { "unit" } else { "units" };
        text += &format!(": error {}{relative}", errors.absolute);
        text += &format!(", {units} {noun} of the last place");
        // A number with few digits is many ulp away, which tells nothing.
        if let Some(ulp) = errors.ulp.as_ref().filter(|ulp| ulp.magnitude() <= MANY_ULP) {
            text += &format!(", {ulp} ulp of a double");
        }
    }
    text
}
