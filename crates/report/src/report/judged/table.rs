//! All rows for a person at a terminal: verdicts, numbers, a histogram, the worst rows.

use super::row::{JudgedRow, certified, digits};
use super::summary::{JudgeSummary, QuantitySummary};
use crate::judge::{CorrectDigits, Judged, Verdict};
use crate::report::words::{count, shortened};
use std::io;

/// The whole summary.
pub fn write(summary: &JudgeSummary, out: &mut dyn io::Write) -> io::Result<()> {
    verdicts(summary, out)?;
    numbers(summary, out)?;
    histogram(summary, out)?;
    if !summary.worst.is_empty() {
        writeln!(out, "\nworst rows")?;
        summary.worst.iter().try_for_each(|row| judged_row(row, out))?;
    }
    if !summary.unjudged.is_empty() {
        writeln!(out, "\nfirst rows that are not judged")?;
        for row in &summary.unjudged {
            let reason = row.reason().map_or(String::new(), |reason| format!(": {reason}"));
            writeln!(out, "   line {}: {}{reason}", row.line, row.verdict().name())?;
        }
    }
    Ok(())
}

/// Number of rows that have each verdict, and how many pass.
pub fn verdicts(summary: &JudgeSummary, out: &mut dyn io::Write) -> io::Result<()> {
    let (rows, accepted) = (summary.rows, summary.accepted());
    let demanded = count(summary.demand.digits, "digit", "digits");
    let demanded = match summary.demand.or_as_printed {
        true => format!("every number right as printed, or correct to {demanded}"),
        false => format!("every number correct to {demanded}"),
    };
    let rows = count(rows, "row", "rows");
    writeln!(out, "{rows}: {accepted} accepted ({demanded})")?;
    if let Some(weight) = summary.assumed {
        writeln!(out, "weight: {}, as neither the rows nor --weight say any", weight.name())?;
    }
    writeln!(out)?;
    for verdict in Verdict::ALL {
        let rows = summary.count(verdict);
        if rows > 0 {
            let side = match verdict {
                Verdict::Thinner => " (the unsafe side)",
                Verdict::Thicker => " (the safe side)",
                _ => "",
            };
            writeln!(out, "{rows:>9}  {}{side}", verdict.name())?;
        }
    }
    Ok(())
}

fn numbers(summary: &JudgeSummary, out: &mut dyn io::Write) -> io::Result<()> {
    if summary.quantities.is_empty() {
        return Ok(());
    }
    let titles = "numbers,judged,rounded,faithful,wrong,doubles,digits,relative error";
    let cells = |m: &QuantitySummary| {
        let relative = m.largest_relative.as_ref().map_or(String::new(), ToString::to_string);
        let counts = [m.judged, m.correctly_rounded, m.faithful, m.wrong(), m.nearest_doubles];
        let counts = counts.map(|count| count.to_string());
        [&[m.quantity.name().to_owned()], &counts[..], &[digits(m.least), relative]].concat()
    };
    let titles = titles.split(',').map(str::to_owned).collect();
    writeln!(out)?;
    for row in std::iter::once(titles).chain(summary.quantities.iter().map(cells)) {
        let [name, counts @ .., digits, relative] = &row[..] else { continue };
        let counts: String = counts.iter().map(|count| format!(" {count:>9}")).collect();
        writeln!(out, "{name:<19}{counts} {digits:>7} {relative:>14}")?;
    }
    writeln!(
        out,
        "rounded, faithful, wrong: in the last printed place; doubles: the nearest to the truth;"
    )?;
    writeln!(out, "digits, relative error: of the worst")?;
    if summary.thinner + summary.thicker > 0 {
        let (thinner, thicker) = (summary.thinner, summary.thicker);
        writeln!(
            out,
            "thicknesses below the least: {thinner} (the unsafe side, even if only by rounding); above: {thicker}"
        )?;
    }
    Ok(())
}

/// Characters of the longest bar.
const BAR: u64 = 40;

fn histogram(summary: &JudgeSummary, out: &mut dyn io::Write) -> io::Result<()> {
    let Some(most) = summary.histogram.values().max() else { return Ok(()) };
    writeln!(out, "\ncorrect digits of the worst number of a row")?;
    for (correct, rows) in &summary.histogram {
        let name = match correct {
            CorrectDigits::Exact => "exact".to_owned(),
            CorrectDigits::Digits(digits) => digits.to_string(),
        };
        let bar = "#".repeat((rows * BAR).div_ceil(*most) as usize);
        writeln!(out, "{name:>9}  {bar:<40} {rows:>9}")?;
    }
    Ok(())
}

/// The fault of a row, and its worst number.
fn judged_row(row: &JudgedRow, out: &mut dyn io::Write) -> io::Result<()> {
    let what = match row.verdict() {
        Verdict::Correct => match row.correct_digits() {
            Some(CorrectDigits::Digits(digits)) => {
                format!("correct to {}", count(digits, "digit", "digits"))
            }
            _ => "correct".to_owned(),
        },
        verdict => verdict.name().to_owned(),
    };
    let thickness = row.thickness.as_deref().map(|eta| format!(", thickness {}", shortened(eta)));
    writeln!(
        out,
        "   line {}: {what}; {}, half opening {}, friction {}{}",
        row.line,
        shortened(&row.weight),
        shortened(&row.half_opening),
        shortened(&row.friction),
        thickness.unwrap_or_default()
    )?;
    let modes = row.modes().unwrap_or_default();
    match row.verdict() {
        Verdict::WrongMode => {
            let claimed = row.claimed_mode.unwrap_or_default();
            writeln!(out, "      mode {claimed}, certified {modes}")?;
        }
        Verdict::Falls => match row.reason() {
            Some(reason) => writeln!(out, "      it falls by {reason}")?,
            None => writeln!(out, "      it falls at this thickness")?,
        },
        Verdict::Stands if row.thickness.is_some() => writeln!(out, "      it stands")?,
        Verdict::Stands => writeln!(out, "      it stands, and collapses as {modes}")?,
        _ => {}
    }
    if let Some(boundary) = row.judgement().and_then(|found| found.boundary.as_ref()) {
        let (claimed, quantity) = (row.claimed_mode.unwrap_or_default(), boundary.quantity.name());
        let within = &boundary.within;
        writeln!(
            out,
            "      it is {claimed} at a {quantity} less than {within} away, within its rounding"
        )?;
    }
    match row.numbers().iter().min_by_key(|number| number.correct_digits) {
        Some(number) if number.correct_digits != CorrectDigits::Exact => {
            writeln!(out, "      {}", number_text(number))
        }
        _ => Ok(()),
    }
}

/// Powers of ten beyond which ulp are not shown.
const MANY_ULP: i64 = 6;

fn number_text(number: &Judged) -> String {
    let mut text = format!(
        "{} {}, certified {}",
        number.quantity.name(),
        shortened(&number.claimed),
        shortened(&certified(&number.certified))
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
