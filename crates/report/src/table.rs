//! Tables for a person at a terminal.

use super::answer::{Answer, Status};
use super::answers::{Answers, Scope};
use super::columns::TableColumn;
use super::find;
use super::paper::in_degrees_too;
use super::sizes;
use super::subject::Subject;
use super::tabular::Tabular;
use super::words::{aligned, count, labels, may_move, model};
use crate::ask::Field;
use crate::certify::state::Fall;
use crate::problem::Quantity;
use crate::problem::asymmetric_region::STANDS;
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
    writeln!(out, "{}", title(&answer.subject))?;
    writeln!(out, "   modes that meet here (proved): {}", labels(&answer.modes).join(" "))?;
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
    let words = answer.asked.as_ref().map_or_else(
        || format!("half opening {half_opening},{eta} friction {friction}, {}", model(*weight)),
        |asked| asked.with_weight(*weight),
    );
    writeln!(out, "Arch of {words}\n")?;
    match (thickness, &answer.status) {
        (_, Status::Undecided(undecided))
            if thickness.is_none() || answer.values.is_empty() && answer.open.is_empty() =>
        {
            find::undecided(undecided, out)
        }
        (Some(_), _) => assessment(&report.quantities, answer, out),
        (None, Status::Falls(fall)) => {
            falls(*fall, answer, out)?;
            if answer.measured_at.is_some() {
                writeln!(out)?;
            }
            measured(&report.quantities, answer, out).map(|_| ())
        }
        (None, _) => state(&report.quantities, answer, out),
    }?;
    asymmetric(answer, out)
}

/// Writes what the static theorem does not exclude.
fn asymmetric(answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    match may_move(&answer.asymmetric) {
        Some(words) => writeln!(out, "\n{words}"),
        None => Ok(()),
    }
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
        let of = [Quantity::SlidingFriction, Quantity::HalfOpening][index];
        writeln!(out, "   {words:<45} {}{}", value.text(), in_degrees_too(of, value))?;
    }
    Ok(())
}

fn state(asked: &[Quantity], answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    let mode = labels(&answer.modes).join(" ");
    writeln!(out, "stands from the thickness below on: {STANDS}; collapses there as {mode}")?;
    writeln!(out, "proved: one solution, admissible on the whole half arch, none thinner\n")?;
    if measured(asked, answer, out)? {
        writeln!(out, "\n{RATIOS}")?;
    }
    let ratios = asked.iter().filter(|quantity| !quantity.is_measured());
    let (frictions, others): (Vec<Quantity>, Vec<Quantity>) =
        ratios.partition(|quantity| quantity.is_friction());
    for quantity in others {
        let value = answer.value(quantity).map_or("none inside".into(), |value| {
            // The symbol has the radians already.
            value.text() + in_degrees_too(quantity, value).trim_start_matches(" rad")
        });
        let (name, symbol) = (quantity.name(), quantity.symbol());
        writeln!(out, "   {name:<20} {symbol:<12} {value}")?;
    }
    let known = frictions.into_iter().filter_map(|of| Some((of, answer.value(of)?)));
    for (index, (quantity, value)) in known.enumerate() {
        if index == 0 {
            writeln!(out, "\nat this half opening")?;
        }
        let words = match quantity == Quantity::SlidingFriction {
            true => "nothing stands below the friction",
            false => "collapse is purely rotational from",
        };
        writeln!(out, "   {words:<39} {}", value.text())?;
    }
    Ok(())
}

/// Heading of what is in no unit, below what is measured.
const RATIOS: &str = "as ratios, lengths in r and forces in w r";

/// The sizes of an arch that is measured, or why they are not proved; whether there is anything of them.
fn measured(asked: &[Quantity], answer: &Answer, out: &mut dyn io::Write) -> io::Result<bool> {
    let sizes = asked.iter().filter(|of| of.is_measured());
    let found: Vec<_> = sizes.filter_map(|of| Some((of, answer.value(*of)?))).collect();
    let open = answer.open.iter().find(|(of, _)| of.is_measured());
    let (Some(circle), true) = (answer.measured_at, !found.is_empty() || open.is_some()) else {
        return Ok(false);
    };
    writeln!(out, "as measured")?;
    let found = found.into_iter().map(|(of, value)| (*of, value));
    let lines = sizes::measured(circle, found, answer.asked.as_deref());
    lines.iter().try_for_each(|line| writeln!(out, "{line}"))?;
    open.map_or(Ok(()), |(_, undecided)| writeln!(out, "   {undecided}"))?;
    Ok(true)
}

/// Words on an arch of a given thickness, in the order of [`Quantity::ASSESSMENT`]: its words, and those
/// where there is none; without these it is left out then.
const ASSESSED: [(Quantity, &str, Option<&str>); 6] = [
    (Quantity::LeastThickness, "least thickness", Some("none is enough")),
    (Quantity::GeometricSafety, "geometric safety factor", Some("none")),
    (Quantity::RequiredFriction, "required friction", Some("none is enough")),
    (Quantity::FrictionSafety, "friction safety factor", Some("none")),
    (Quantity::LeastThrust, "least thrust", None),
    (Quantity::LargestThrust, "largest thrust", None),
];

/// Thickness over the least from which an arch that collapses is told that a ring is not all of a bridge.
const NEARLY: f64 = 0.95;

fn assessment(asked: &[Quantity], answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    match (&answer.status, answer.stands) {
        (Status::Undecided(undecided), _) => writeln!(out, "{undecided}\n")?,
        (_, Some(true)) => writeln!(out, "stands, proved: {STANDS}\n")?,
        (_, Some(false)) => {
            writeln!(out, "collapses, proved")?;
            let thickness = answer.asked.as_ref().and_then(|asked| asked.text(Field::Thickness));
            let safety = answer.value(Quantity::GeometricSafety);
            if let Some(text) =
                thickness.filter(|_| safety.is_some_and(|x| x.binary.lower > NEARLY))
            {
                writeln!(
                    out,
                    "   it has nearly its least thickness: by fill, of which nothing is said, such a ring may stand;\n   \
                     a tolerance tells of every arch inside (--thickness {text}±5%)"
                )?;
            }
            writeln!(out)?;
        }
        (_, None) => {}
    }
    // In the order in which who builds reads: is it safe, how large is all, and then what has no unit.
    let is_safety = |of: &&Quantity| {
        matches!(of, Quantity::GeometricSafety | Quantity::FrictionSafety)
            && answer.measured_at.is_some()
    };
    let (safety, ratios): (Vec<&Quantity>, Vec<&Quantity>) = asked.iter().partition(is_safety);
    assessed(&safety, answer, out)?;
    if !safety.is_empty() {
        writeln!(out)?;
    }
    let has_ratios = ratios.iter().any(|of| !of.is_measured());
    if measured(asked, answer, out)? && has_ratios {
        writeln!(out, "\n{RATIOS}")?;
    }
    assessed(&ratios, answer, out)
}

/// Values of an arch of a thickness, in the order in which they are asked for.
fn assessed(asked: &[&Quantity], answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    for quantity in asked {
        let told = ASSESSED.iter().find(|(of, ..)| of == *quantity);
        let Some(&(quantity, name, none)) = told else { continue };
        let value = answer.value(quantity);
        let text = match (value, answer.why_open(quantity), answer.status.reason()) {
            (Some(value), ..) if value.decimal.is_some() => value.text(),
            (_, Some(open), _) => open.to_string(),
            (Some(_), None, _) => "unbounded".into(),
            (None, None, reason) => match (none, reason) {
                (None, _) => continue,
                (Some(none), Some(reason)) if quantity == Quantity::LeastThickness => {
                    format!("{none} ({reason})")
                }
                (Some(none), _) => none.into(),
            },
        };
        writeln!(out, "   {name:<24} {text}")?;
        if let Some(limit) = value.and_then(|value| value.limited_by) {
            let joint = quantity.joint().and_then(|of| Some((of, answer.value(of)?)));
            let joint = joint.map_or(String::new(), |(of, joint)| {
                format!(", at {}{}", joint.text(), in_degrees_too(of, joint))
            });
            writeln!(out, "           limited by       {limit}{joint}")?;
        }
    }
    Ok(())
}

fn arches(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    let what = match report.have_assessments() {
        true => "Arches of given thickness",
        false => "Arches at their least thickness",
    };
    writeln!(out, "{what}, {}; stands: {STANDS}", rounding(report))?;
    let asked = report.list.first().and_then(|answer| answer.asked.as_ref());
    if let Some(asked) = asked.filter(|of| report.list.iter().all(|x| x.asked.as_ref() == Some(of)))
    {
        writeln!(out, "{}", asked.in_words())?;
    }
    writeln!(out)?;
    let columns = TableColumn::told(report);
    let rows = report.list.iter().map(|answer| TableColumn::texts(&columns, answer).collect());
    let table = Tabular { header: TableColumn::names(&columns), rows: rows.collect() };
    let Tabular { header, rows } = table.without_empty();
    aligned(&[vec![header], rows].concat()).try_for_each(|line| writeln!(out, "{line}"))
}

#[cfg(test)]
mod tests {
    use super::super::answer::Extent;
    use super::*;
    use crate::certify::state::{Inquiry, Wanted};
    use crate::certify::{Error, Undecided};
    use crate::problem::Arch;
    use crate::problem::measures::Circle;

    fn arch(friction: &str) -> Arch {
        Arch::parse("milankovitch", "80deg", friction).unwrap()
    }

    fn state(friction: &str) -> Answer {
        Answer::state(1, &arch(friction), &Inquiry::new(&arch(friction), 5, false).state(5, false))
    }

    fn told(answer: Answer, quantities: &[&[Quantity]]) -> String {
        let mut out = Vec::new();
        let report = Answers { quantities: quantities.concat(), ..Answers::arch(5, answer) };
        answers(&report, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn what_stays_open_changes_nothing_of_what_is_said_besides() {
        let open = || Error::from(Undecided::new("the rounding"));
        let (state_of, assessed) = (Quantity::STATE, Quantity::ASSESSMENT);
        let stands = told(
            state("0.6").measured(Circle::Intrados, Err(open())),
            &[&state_of, &[Quantity::Radius]],
        );
        assert!(stands.contains("\nstands from the thickness below on"), "{stands}");
        assert!(stands.contains("\n   thickness            eta = t/r    0.068650\n"), "{stands}");
        assert!(stands.contains("intrados\n   undecided: the rounding\n\nas ratios"), "{stands}");
        let falls = told(state("0.01").measured(Circle::Intrados, Err(open())), &[&state_of]);
        assert!(falls.contains("\ndoes not stand at any thickness"), "{falls}");
        let unknown =
            Answer::state(1, &arch("0.6"), &Err(open())).measured(Circle::Intrados, Err(open()));
        let unknown = told(unknown, &[&state_of]);
        assert!(unknown.ends_with("\n\nundecided: the rounding\n"), "{unknown}");
        for (eta, verdict, thrusts) in
            [("0.1", "stands, proved", 1), ("0.05", "collapses, proved", 0)]
        {
            let (arch, eta) = (arch("0.6"), eta.parse().unwrap());
            let mut found =
                Inquiry::new(&arch, 5, false).assess(&eta, 5, Wanted::Everything).unwrap();
            found.required_friction = Err(Undecided::new("the rounding"));
            let answer = Answer::assessment(Extent::ALL, 1, (&arch, &eta), &Ok(found));
            let table = told(
                answer.measured(Circle::Intrados, Err(open())),
                &[&assessed, &[Quantity::Radius]],
            );
            assert!(table.contains(verdict), "{table}");
            assert!(
                table.contains("\n   required friction        undecided: the rounding\n"),
                "{table}"
            );
            assert!(table.contains("intrados\n   undecided: the rounding\n\nas ratios"), "{table}");
            assert_eq!(table.matches("largest thrust").count(), thrusts);
        }
    }

    #[test]
    fn whatever_is_asked_of_a_thickness_has_words() {
        assert_eq!(ASSESSED.map(|(quantity, ..)| quantity), Quantity::ASSESSMENT);
    }
}
