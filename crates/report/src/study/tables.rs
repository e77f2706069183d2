//! The studies for a person at a terminal.

use crate::words::distinct;
use couplet_study::limits::LIMITS;
use couplet_study::row::{Measurement, quartiles};
use couplet_study::stability::Rung;
use std::io;

/// Writes one line for each method at each precision: the quartiles of the times and the worst of the rest
/// over the cases of a quantity.
pub fn accuracy_table<'a>(rows: &'a [Measurement], out: &mut dyn io::Write) -> io::Result<()> {
    let line = |[quantity, method]: [&str; 2],
                [bits, cases, times @ .., error, lost, verdict]: [&str; 8]| {
        let times: String = times.iter().map(|time| format!(" {time:>9}")).collect();
        format!(
            "{quantity:<13} {method:<34} {bits:>6} {cases:>6}{times} {error:>10} {lost:>8} {verdict:>9}"
        )
    };
    let titles = ["bits", "cases", "CPU time", "25 %", "75 %", "rel. error", "lost", "verdicts"];
    writeln!(out, "{}", line(["quantity", "method"], titles))?;
    let key =
        |row: &'a Measurement| (row.quantity.as_str(), row.method.as_str(), row.precision_bits);
    let seen = distinct(rows.iter().map(key));
    let mut last = "";
    for (quantity, method, bits) in seen {
        let is_same = |row: &&'a Measurement| key(row) == (quantity, method, bits);
        let group: Vec<&Measurement> = rows.iter().filter(is_same).collect();
        let times = group.iter().map(|row| row.cpu_seconds).collect();
        let [lower, median, upper] = quartiles(times).unwrap_or_default().map(duration);
        let worst = |f: fn(&Measurement) -> Option<f64>| {
            group.iter().filter_map(|row| f(row)).fold(f64::NEG_INFINITY, f64::max)
        };
        let good =
            group.iter().filter(|r| r.verdict == "proved" || r.verdict == "computed").count();
        let verdict = match (good == group.len(), group[0].verdict.as_str()) {
            (true, verdict) => verdict.to_owned(),
            (false, _) => format!("{} fail", group.len() - good),
        };
        if quantity != last {
            writeln!(out)?;
            last = quantity;
        }
        let (bits, cases) =
            (bits.map_or(String::new(), |of| of.to_string()), group.len().to_string());
        let error = power(worst(|row| row.error_relative_log10));
        let lost = digits(worst(|row| row.digits_lost));
        let cells =
            [&bits, &cases, &median, &lower, &upper, &error, &lost, &verdict].map(|x| &x[..]);
        writeln!(out, "{}", line([quantity, method], cells))?;
    }
    let claims = rows
        .iter()
        .filter_map(|row| Some(row.claimed_relative_log10? >= row.error_relative_log10? - 1e-9));
    let (held, all) = claims.fold((0, 0), |(held, all), holds| (held + i32::from(holds), all + 1));
    writeln!(out, "\nA claimed bound was at least the true error in {held} of {all} rows.")
}

/// Digits lost: a line for each method, a column for each distance.
pub fn stability_table(rungs: &[Rung], out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(
        out,
        "Decimal digits lost at a distance 10^-k from each limit; - where there is no value."
    )?;
    for limit in &LIMITS {
        let here: Vec<&Rung> = rungs.iter().filter(|rung| rung.limit == limit.name).collect();
        if here.is_empty() {
            continue;
        }
        let methods = distinct(here.iter().map(|rung| rung.method));
        let steps = distinct(here.iter().map(|rung| rung.distance_log10));
        writeln!(out, "\n{}: {} ({})", limit.name, limit.words, limit.output)?;
        let line = |name: &str, cells: Vec<String>| {
            let cells: String = cells.iter().map(|cell| format!("{cell:>6}")).collect();
            format!("   {name:<32}{cells}")
        };
        writeln!(out, "{}", line("k", steps.iter().map(|k| (-k).to_string()).collect()))?;
        let find = |method: &str, step: i32| {
            here.iter().find(|rung| rung.method == method && rung.distance_log10 == step)
        };
        let condition = steps.iter().map(|step| {
            let rung = here.iter().find(|rung| rung.distance_log10 == *step);
            rung.map_or("-".into(), |rung| digits(rung.condition_log10.max(0.0)))
        });
        writeln!(out, "{}", line("lost by the problem itself", condition.collect()))?;
        for method in methods {
            let lost = steps.iter().map(|step| {
                find(method, *step).and_then(|rung| rung.digits_lost).map_or("-".into(), digits)
            });
            writeln!(out, "{}", line(method, lost.collect()))?;
        }
        let bits = steps.iter().map(|step| {
            let rung = find("certified", *step).filter(|rung| rung.verdict == "proved");
            rung.map_or("-".into(), |rung| rung.working_bits.to_string())
        });
        writeln!(out, "{}", line("bits for 16 proved digits", bits.collect()))?;
    }
    Ok(())
}

fn digits(x: f64) -> String {
    if x.is_finite() { format!("{x:.1}") } else { "-".into() }
}

/// `10^-x` from its logarithm.
fn power(log10: f64) -> String {
    match log10 {
        x if x == f64::NEG_INFINITY => "0".into(),
        x if x.is_finite() => format!("1e{:.1}", x),
        _ => "-".into(),
    }
}

fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1e-6 => format!("{:.0} ns", 1e9 * s),
        s if s < 1e-3 => format!("{:.1} us", 1e6 * s),
        s if s < 1.0 => format!("{:.2} ms", 1e3 * s),
        s => format!("{s:.2} s"),
    }
}
