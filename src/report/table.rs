//! Tables for a person at a terminal.

use super::{AssessReport, Audit, Constants, Proved, StateAt, StateOf, StateReport, reason, texts};
use crate::arch::SelfWeight;
use crate::certify::state::{Fall, Figure};
use crate::judge::PrintedVerdict;
use std::io;

pub fn constants(report: &Constants, out: &mut dyn io::Write) -> io::Result<()> {
    let digits = report.digits;
    let plural = if digits == 1 { "" } else { "s" };
    writeln!(out, "Landmark constants, correctly rounded to {digits} significant digit{plural}")?;
    for entry in &report.landmarks {
        let (symbol, name) = (entry.landmark.symbol(), entry.landmark.name());
        let weight = title(entry.weight);
        writeln!(out, "\n{symbol}  {name}, {weight} self-weight")?;
        match &entry.outcome {
            Ok(proved) => landmark(proved, out)?,
            Err(reason) => writeln!(out, "   {reason}")?,
        }
    }
    Ok(())
}

fn landmark(proved: &Proved, out: &mut dyn io::Write) -> io::Result<()> {
    let equations: Vec<_> = proved.system.equations.iter().map(|e| e.label()).collect();
    let radii: Vec<String> = proved
        .system
        .unknowns
        .iter()
        .zip(&proved.relative_radii)
        .map(|(unknown, radius)| {
            format!("{} ±{:.1}%", unknown.name(), (1000.0 * radius).floor() / 10.0)
        })
        .collect();
    writeln!(out, "   proved: one solution of {}", equations.join(", "))?;
    writeln!(out, "   in the box {}", radii.join(", "))?;
    for constant in &proved.constants {
        let [value, ..] = texts(&constant.value);
        let exact = match constant.exact.as_deref() {
            Some(exact) if exact != value => format!("  = {exact}"),
            Some(_) => "  exactly".to_owned(),
            None => String::new(),
        };
        let (name, symbol) = (constant.quantity.name(), constant.quantity.symbol());
        writeln!(out, "   {name:<23} {symbol:<19} {value}{exact}")?;
    }
    Ok(())
}

pub fn audit(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(
        out,
        "Printed numbers against certified values; errors in units of the last printed place\n"
    )?;
    writeln!(
        out,
        "{:<8} {:<12} {:<2} {:<20} {:<20} {:>8} {:>7}  verdict",
        "place", "weight", "", "quantity", "printed", "error", "digits"
    )?;
    for entry in &report.printed {
        let printed = entry.printed;
        writeln!(
            out,
            "{:<8} {:<12} {:<2} {:<20} {:<20} {:>8} {:>7}  {}",
            printed.place,
            printed.weight.name(),
            printed.landmark.symbol(),
            printed.quantity.name(),
            printed.text,
            entry.error_units.to_string(),
            entry.correct_digits,
            entry.verdict.name(),
        )?;
    }
    let count = |verdict| report.printed.iter().filter(|entry| entry.verdict == verdict).count();
    let (right, faithful, wrong) = (
        count(PrintedVerdict::CorrectlyRounded),
        count(PrintedVerdict::Faithful),
        count(PrintedVerdict::Wrong),
    );
    let all = report.printed.len();
    writeln!(
        out,
        "\n{all} printed numbers: {right} correctly rounded, {faithful} faithful, {wrong} wrong"
    )?;
    if report.comparisons.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nMilankovitch's weight compared with Heyman's\n")?;
    writeln!(out, "{:<2} {:<20} {:<8} {:<10} verdict", "", "quantity", "claimed", "certified")?;
    for entry in &report.comparisons {
        writeln!(
            out,
            "{:<2} {:<20} {:<8} {:<10} {}",
            entry.landmark.symbol(),
            entry.quantity.name(),
            entry.claimed.name(),
            entry.certified.name(),
            entry.verdict(),
        )?;
    }
    Ok(())
}

fn title(weight: SelfWeight) -> &'static str {
    match weight {
        SelfWeight::Heyman => "Heyman-like",
        SelfWeight::Milankovitch => "Milankovitch-like",
    }
}

pub fn state(report: &StateReport, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(
        out,
        "Arch of half opening {}, friction {}, {} self-weight\n",
        report.half_opening,
        report.friction,
        title(report.weight)
    )?;
    match &report.outcome {
        StateOf::Stands(state) => {
            writeln!(
                out,
                "stands from the thickness below on; collapses there as {}",
                state.mode.label()
            )?;
            writeln!(
                out,
                "proved: one solution, admissible on the whole half arch, none thinner\n"
            )?;
            let mut row = |name: &str, symbol: &str, value: Option<&Figure>, none: &str| {
                let value = value.map_or_else(|| none.to_owned(), |x| x.decimal.value.to_string());
                writeln!(out, "   {name:<20} {symbol:<12} {value}")
            };
            row("thickness", "eta = t/r", Some(&state.thickness), "")?;
            row("thrust", "h = H/(w r)", Some(&state.thrust), "")?;
            row("intrinsic_thrust", "eta h", Some(&state.intrinsic_thrust), "")?;
            row("rotation_joint", "beta_r, rad", Some(&state.rotation_joint), "")?;
            row("sliding_joint", "beta_s, rad", state.sliding_joint.as_ref(), "none inside")?;
            let Some(frictions) = &state.frictions else { return Ok(()) };
            writeln!(out)?;
            writeln!(out, "at this half opening")?;
            let limit = |x: &Figure| x.decimal.value.to_string();
            let sliding = limit(&frictions.sliding);
            writeln!(out, "   nothing stands below the friction       {sliding}")?;
            let rotational = frictions.rotational.as_ref().map_or("inf".to_owned(), limit);
            writeln!(out, "   collapse is purely rotational from      {rotational}")
        }
        StateOf::Falls(fall) => {
            let why = match fall {
                Fall::Sliding => {
                    "it slides: the friction is below that of the purely sliding state"
                }
                Fall::Thickness => "it would have to be thicker than twice its radius",
            };
            writeln!(out, "does not stand at any thickness ({}): {why}", reason(*fall))
        }
        StateOf::Undecided(doubt) => {
            let between: Vec<_> = doubt.between.iter().map(|mode| mode.label()).collect();
            writeln!(out, "undecided: {}", doubt.question)?;
            writeln!(
                out,
                "   between {}; the difference is below {:.1e}",
                between.join(" and "),
                doubt.gap
            )
        }
    }
}

pub fn state_at(report: &StateAt, out: &mut dyn io::Write) -> io::Result<()> {
    let modes: Vec<_> = report.modes.iter().map(|mode| mode.label()).collect();
    let (symbol, name) = (report.landmark.symbol(), report.landmark.name());
    writeln!(out, "{symbol}  {name}, {} self-weight", title(report.weight))?;
    writeln!(out, "   modes that meet here: {}", modes.join(" "))?;
    for constant in &report.constants {
        let [value, ..] = texts(&constant.value);
        writeln!(
            out,
            "   {:<23} {:<19} {value}",
            constant.quantity.name(),
            constant.quantity.symbol()
        )?;
    }
    Ok(())
}

pub fn assess(report: &AssessReport, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(
        out,
        "Arch of half opening {}, thickness {}, friction {}, {} self-weight\n",
        report.half_opening,
        report.thickness,
        report.friction,
        title(report.weight)
    )?;
    let found = match report.outcome {
        Ok(found) => found,
        Err(doubt) => return writeln!(out, "undecided: {}", doubt.question),
    };
    writeln!(out, "{}, proved\n", if found.stands { "stands" } else { "collapses" })?;
    let value = |x: &Figure| x.decimal.value.to_string();
    let least = match &found.least_thickness {
        Ok(least) => value(least),
        Err(fall) => format!("none is enough ({})", reason(*fall)),
    };
    let or = |x: &Option<Figure>, none: &str| x.as_ref().map_or_else(|| none.to_owned(), value);
    writeln!(out, "   least thickness          {least}")?;
    writeln!(out, "   geometric safety factor  {}", or(&found.geometric_safety, "none"))?;
    writeln!(
        out,
        "   required friction        {}",
        or(&found.required_friction, "none is enough")
    )?;
    writeln!(
        out,
        "   friction safety factor   {}",
        or(&found.friction_safety, "unbounded or none")
    )?;
    for (name, limit) in ["least", "largest"].iter().zip(found.thrust.iter().flatten()) {
        let joint =
            limit.joint.as_ref().map_or_else(String::new, |j| format!(", at {} rad", value(j)));
        writeln!(out, "   {name:<7} thrust           {}", or(&limit.thrust, "unbounded"))?;
        writeln!(out, "           limited by       {}{joint}", limit.limited_by)?;
    }
    Ok(())
}
