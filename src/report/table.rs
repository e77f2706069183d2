//! Tables for a person at a terminal.

use super::answer::{Answer, Status};
use super::answers::{Answers, Scope};
use super::columns;
use super::find;
use super::subject::Subject;
use super::words::{count, list, model};
use crate::certify::state::Fall;
use crate::problem::Quantity;
use std::io;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    match report.scope {
        Scope::Constants => {
            writeln!(out, "Landmark constants, {}", rounding(report))?;
            report.list.iter().try_for_each(|answer| constants(answer, out))
        }
        Scope::Point => report.list.iter().try_for_each(|answer| point(answer, out)),
        Scope::Arch => report.list.iter().try_for_each(|answer| arch(report, answer, out)),
        Scope::Arches | Scope::Mixed => arches(report, out),
        Scope::Found => find::table(report, out),
    }
}

fn rounding(report: &Answers) -> String {
    let digits = count(report.digits, "significant digit", "significant digits");
    format!("correctly rounded to {digits}")
}

/// The symbol, the name and the weight of a landmark.
fn title(subject: &Subject) -> String {
    let Subject::Landmark { landmark, weight } = subject else { return String::new() };
    format!("{}  {}, {}", landmark.symbol(), landmark.name(), model(*weight))
}

fn constants(answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "\n{}", title(&answer.subject))?;
    if let Some(reason) = answer.status.reason() {
        writeln!(out, "   {}: {reason}", answer.status.name())?;
    }
    if let Some(proof) = &answer.proof {
        let radius = |(unknown, radius): &(&str, f64)| {
            format!("{unknown} ±{:.1}%", (1000.0 * radius).floor() / 10.0)
        };
        let radii: Vec<String> = proof.radii.iter().map(radius).collect();
        writeln!(out, "   proved: one solution of {}", proof.equations.join(", "))?;
        writeln!(out, "   in the box {}", radii.join(", "))?;
    }
    for (quantity, value) in &answer.values {
        let exact = match (value.closed_form(), &value.exact) {
            (Some(exact), _) => format!("  = {exact}"),
            (None, Some(_)) => "  exactly".to_owned(),
            (None, None) => String::new(),
        };
        let (name, symbol) = (quantity.name(), quantity.symbol());
        writeln!(out, "   {name:<23} {symbol:<19} {}{exact}", value.text())?;
    }
    Ok(())
}

fn point(answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    let modes: Vec<_> = answer.modes.iter().map(|mode| mode.label()).collect();
    writeln!(out, "{}", title(&answer.subject))?;
    writeln!(out, "   modes that meet here (proved): {}", modes.join(" "))?;
    for (quantity, value) in &answer.values {
        let (name, symbol) = (quantity.name(), quantity.symbol());
        writeln!(out, "   {name:<23} {symbol:<19} {}", value.text())?;
    }
    Ok(())
}

fn arch(report: &Answers, answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    let Subject::Arch { weight, half_opening, friction, thickness, .. } = &answer.subject else {
        return Ok(());
    };
    let eta = thickness.as_ref().map_or(String::new(), |eta| format!(" thickness {eta},"));
    let weight = model(*weight);
    writeln!(out, "Arch of half opening {half_opening},{eta} friction {friction}, {weight}\n")?;
    match &answer.status {
        _ if !answer.open.is_empty() || thickness.is_some() && !answer.values.is_empty() => {
            assessment(&report.quantities, answer, out)
        }
        Status::Undecided(undecided) => find::undecided(undecided, out),
        _ if thickness.is_some() => assessment(&report.quantities, answer, out),
        Status::Falls(fall) => falls(*fall, answer, out),
        _ => state(&report.quantities, answer, out),
    }?;
    asymmetric(answer, out)
}

/// What the static theorem does not exclude.
fn asymmetric(answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    if answer.asymmetric.is_empty() {
        return Ok(());
    }
    let at: Vec<String> = answer.asymmetric.iter().map(ToString::to_string).collect();
    writeln!(
        out,
        "\nasymmetric mechanism at the thickness {} (couplet complementarity)",
        list(at.iter().map(String::as_str))
    )?;
    writeln!(
        out,
        "   there an admissible state exists, and also a motion that friction without dilatancy does not forbid"
    )
}

fn falls(fall: Fall, answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    let (word, why) = (super::words::reason(fall), fall.reason());
    writeln!(out, "does not stand at any thickness ({word}): {why}")?;
    let words = [
        "this half opening stands with a friction from",
        "this friction carries a half opening up to",
    ];
    for (index, (words, value)) in words.iter().zip(&answer.enough).enumerate() {
        let Some(value) = value else { continue };
        let unit = if index == 1 { " rad" } else { "" };
        writeln!(out, "   {words:<45} {}{unit}", value.text())?;
    }
    Ok(())
}

fn state(asked: &[Quantity], answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    let modes: Vec<&str> = answer.modes.iter().map(|mode| mode.label()).collect();
    let mode = modes.join(" ");
    writeln!(out, "stands from the thickness below on; collapses there as {mode}")?;
    writeln!(out, "proved: one solution, admissible on the whole half arch, none thinner\n")?;
    let (sizes, ratios): (Vec<Quantity>, Vec<Quantity>) =
        asked.iter().partition(|quantity| quantity.is_measured());
    let (frictions, others): (Vec<Quantity>, Vec<Quantity>) =
        ratios.iter().partition(|quantity| quantity.is_friction());
    for quantity in others {
        let value = answer.value(quantity).map_or("none inside".into(), |value| value.text());
        let (name, symbol) = (quantity.name(), quantity.symbol());
        writeln!(out, "   {name:<20} {symbol:<12} {value}")?;
    }
    for (index, quantity) in frictions.into_iter().enumerate() {
        let Some(value) = answer.value(quantity) else { return Ok(()) };
        if index == 0 {
            writeln!(out, "\nat this half opening")?;
        }
        let words = match quantity {
            Quantity::SlidingFriction => "nothing stands below the friction",
            _ => "collapse is purely rotational from",
        };
        writeln!(out, "   {words:<39} {}", value.text())?;
    }
    measured(&sizes, answer, out)
}

/// The sizes of an arch that is measured.
fn measured(sizes: &[Quantity], answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    let found = sizes.iter().filter_map(|of| Some((of, answer.value(*of)?)));
    for (index, (of, value)) in found.enumerate() {
        if index == 0 {
            writeln!(out, "\nas measured")?;
        }
        writeln!(out, "   {:<20} {:<18} {}", of.name(), of.symbol(), value.text())?;
    }
    Ok(())
}

fn assessment(asked: &[Quantity], answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    match (&answer.status, answer.stands) {
        (Status::Undecided(undecided), _) => writeln!(out, "{undecided}\n")?,
        (_, Some(true)) => writeln!(out, "stands, proved\n")?,
        _ => writeln!(out, "collapses, proved\n")?,
    }
    let (sizes, others): (Vec<Quantity>, Vec<Quantity>) =
        asked.iter().partition(|quantity| quantity.is_measured());
    for quantity in others {
        let value = answer.value(quantity);
        let finite = value.filter(|value| value.decimal.is_some()).map(|value| value.text());
        let open = answer.why_open(quantity).map(ToString::to_string);
        let none = |words: &str| {
            finite.clone().or_else(|| open.clone()).unwrap_or_else(|| words.to_owned())
        };
        let (name, text) = match quantity {
            Quantity::LeastThickness => {
                let reason = answer.status.reason().unwrap_or_default();
                ("least thickness", none(&format!("none is enough ({reason})")))
            }
            Quantity::GeometricSafety => ("geometric safety factor", none("none")),
            Quantity::RequiredFriction => ("required friction", none("none is enough")),
            Quantity::FrictionSafety => {
                let words = if value.is_some() { "unbounded" } else { "none" };
                ("friction safety factor", none(words))
            }
            Quantity::LeastThrust => ("least thrust", none("unbounded")),
            _ => ("largest thrust", none("unbounded")),
        };
        if quantity.joint().is_some() && value.is_none() && open.is_none() {
            continue;
        }
        writeln!(out, "   {name:<24} {text}")?;
        if let Some(limit) = value.and_then(|value| value.limited_by) {
            let joint = quantity.joint().and_then(|joint| answer.value(joint));
            let joint = joint.map_or(String::new(), |joint| format!(", at {} rad", joint.text()));
            writeln!(out, "           limited by       {limit}{joint}")?;
        }
    }
    measured(&sizes, answer, out)
}

fn arches(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    let what = match report.have_assessments() {
        true => "Arches of given thickness",
        false => "Arches at their least thickness",
    };
    writeln!(out, "{what}, {}\n", rounding(report))?;
    let header = columns::names(report);
    let rows = report.list.iter().map(|answer| columns::cells(report, answer));
    let rows: Vec<Vec<String>> = std::iter::once(header).chain(rows).collect();
    // A column without a value in any row says nothing.
    let width = |k: &usize| rows.iter().map(|row| row[*k].chars().count()).max().unwrap_or(0);
    let shown = |k: &usize| rows[1..].iter().any(|row| !row[*k].is_empty());
    let widths: Vec<(usize, usize)> =
        (0..rows[0].len()).filter(shown).map(|k| (k, width(&k))).collect();
    for row in &rows {
        let cells: Vec<String> =
            widths.iter().map(|&(k, width)| format!("{:<width$}", row[k])).collect();
        writeln!(out, "{}", cells.join("  ").trim_end())?;
    }
    Ok(())
}
