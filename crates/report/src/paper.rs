//! Tables as a paper prints them, in LaTeX and Markdown: one row an arch, one column a quantity with its symbol and
//! unit, angles in degrees. Two weights stand side by side, with their difference.

use super::answer::{Answer, Status};
use super::answers::Answers;
use super::names::in_latex;
use super::numbers::in_digits;
use super::tabular::Tabular;
use super::value::Value;
use super::words::{author, distinct};
use crate::arch::SelfWeight;
use crate::number::{Ball, ExactNumber, Rounded, bits_of, degrees};
use crate::problem::Quantity;
use rug::Float;
use rug::float::Round;
use std::io;

/// Bits beyond those of the digits in which an angle is turned into degrees and a difference is taken.
const GUARD: u32 = 32;
/// Sign of a cell where there is no value.
const NONE: &str = "–";

/// Quantities of a table of measured arches.
const BUILT: [Quantity; 8] = {
    use Quantity::*;
    [
        Span,
        Rise,
        GivenThicknessInMetres,
        ThicknessInMetres,
        GeometricSafety,
        Force,
        LeastForce,
        LargestForce,
    ]
};

/// A table with headings.
#[derive(Debug)]
pub(super) struct PaperTable {
    headings: Vec<Heading>,
    rows: Vec<Vec<String>>,
}

/// Heading of a column.
#[derive(Clone, Debug)]
struct Heading {
    latex: String,
    words: String,
}

impl Heading {
    /// Heading of a column with a name, which is that of a quantity or says itself what it is.
    fn named(name: &str) -> Self {
        match Quantity::named(name) {
            Some(quantity) => {
                Self { latex: quantity.latex().into(), words: quantity.symbol().into() }
            }
            None => Self::words(&name.replace('_', " ")),
        }
    }

    /// Heading of half openings, each in the unit that it was given in.
    fn half_opening() -> Self {
        Self { latex: r"$\alpha$".into(), words: "alpha".into() }
    }

    fn words(words: &str) -> Self {
        Self { latex: in_latex(words), words: words.to_owned() }
    }

    /// Heading in degrees of what is in radians.
    fn in_degrees(self) -> Self {
        let turned = |text: String| match text.strip_suffix("rad") {
            Some(symbol) => format!("{symbol}deg"),
            None => text,
        };
        Self { latex: turned(self.latex), words: turned(self.words) }
    }

    /// Heading with whose value it is.
    fn of(self, whom: &str) -> Self {
        Self {
            latex: format!("{} ({whom})", self.latex),
            words: format!("{} ({whom})", self.words),
        }
    }
}

impl From<&Tabular> for PaperTable {
    fn from(table: &Tabular) -> Self {
        let is_number = |k: usize| table.rows.iter().all(|row| row[k].parse::<f64>().is_ok());
        let heading = |(k, name): (usize, &String)| match name.as_str() {
            "half_opening" if !is_number(k) => Heading::half_opening(),
            name => Heading::named(name),
        };
        let headings = table.header.iter().enumerate().map(heading).collect();
        Self { headings, rows: table.rows.clone() }
    }
}

impl PaperTable {
    /// Arches, each in a row.
    pub(super) fn of(report: &Answers) -> Self {
        let weights = distinct(report.list.iter().filter_map(|answer| answer.subject.weight()));
        let whole = [&Quantity::MEASURED_STATE[..], &Quantity::MEASURED_ASSESSMENT];
        // Without a choice, what who builds reads.
        let is_chosen = |of: &Quantity| report.quantities.contains(of);
        let is_built =
            whole.iter().any(|all| all.iter().filter(|of| !of.is_force()).all(is_chosen));
        let asked: Vec<Quantity> = match is_built {
            true => BUILT.into_iter().filter(is_chosen).collect(),
            false => report.quantities.clone(),
        };
        let asked = asked.into_iter().chain([Quantity::AsymmetricThickness]);
        let is_known = |&of: &Quantity| report.list.iter().any(|answer| answer.value(of).is_some());
        let quantities: Vec<Quantity> = asked.filter(is_known).collect();
        let whom = |heading: Heading, weight: SelfWeight| match weights.len() {
            1 => heading,
            _ => heading.of(author(weight)),
        };
        let mut headings = vec![Heading::half_opening(), Heading::named("friction")];
        if report.have_assessments() {
            headings.push(Heading::named("thickness"));
        }
        if is_built {
            headings = vec![Heading::named("friction")];
        }
        // The safety of an arch that has a least thickness says whether it stands.
        let is_told = !is_built
            || report.have_states()
            || report.list.iter().any(|of| {
                let safety = Quantity::GeometricSafety;
                let told = of.value(safety).map(|x| number(safety, x, report.digits));
                of.stands.is_none() || told.is_none_or(|text| text.parse() == Ok(1.0))
            });
        if is_told {
            let told = if report.have_states() { "mode" } else { "verdict" };
            headings.extend(weights.iter().map(|&weight| whom(Heading::words(told), weight)));
        }
        for of in &quantities {
            let heading = match of {
                Quantity::GeometricSafety if is_built => Heading::words("safety"),
                of => Heading::named(of.name()).in_degrees(),
            };
            if is_given(*of) {
                headings.push(heading);
                continue;
            }
            headings.extend(weights.iter().map(|&weight| whom(heading.clone(), weight)));
            if let [one, other] = weights[..] {
                headings.push(heading.of(&format!("{} less {}", author(other), author(one))));
            }
        }
        // Each weight has the same arches in the same order; their given values alone do not tell them apart.
        let of_weight = |weight: &SelfWeight| -> Vec<&Answer> {
            report.list.iter().filter(|answer| answer.subject.weight() == Some(*weight)).collect()
        };
        let arches: Vec<Vec<&Answer>> = weights.iter().map(of_weight).collect();
        let row = |place: usize| {
            let answers: Vec<Option<&Answer>> =
                arches.iter().map(|all| all.get(place).copied()).collect();
            let given = answers.iter().flatten().next().map(|answer| answer.subject.given());
            let given = given.map(|all| if is_built { vec![all[1]] } else { all.to_vec() });
            let given = given.into_iter().flatten().flatten();
            let mut cells: Vec<String> = given.map(printed).collect();
            if is_told {
                cells.extend(answers.iter().map(|answer| answer.map_or(NONE.into(), verdict)));
            }
            for &quantity in &quantities {
                let values: Vec<Option<&Value>> = answers
                    .iter()
                    .map(|answer| answer.and_then(|answer| answer.value(quantity)))
                    .collect();
                let cell = |value: Option<&Value>| {
                    value.map_or(NONE.into(), |x| number(quantity, x, report.digits))
                };
                if is_given(quantity) {
                    cells.push(cell(values.iter().flatten().next().copied()));
                    continue;
                }
                cells.extend(values.iter().copied().map(cell));
                if let [Some(one), Some(other)] = values[..] {
                    cells.push(difference(quantity, one, other, report.digits));
                } else if weights.len() == 2 {
                    cells.push(NONE.into());
                }
            }
            cells
        };
        let rows = (0..arches.first().map_or(0, Vec::len)).map(row).collect();
        Self { headings, rows }
    }

    /// Writes a `tabular` of the package booktabs, with numbers of siunitx.
    pub(super) fn latex(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let line = |cells: Vec<String>| {
            let line = cells.join(" & ");
            // At the end of the row before, LaTeX takes these for its options.
            let guard = if line.starts_with(['[', '*']) { "{}" } else { "" };
            format!("{guard}{line} \\\\")
        };
        writeln!(out, "% Needs \\usepackage{{booktabs,siunitx}}.")?;
        writeln!(out, "\\begin{{tabular}}{{{}}}\n\\toprule", "l".repeat(self.headings.len()))?;
        writeln!(
            out,
            "{}\n\\midrule",
            line(self.headings.iter().map(|of| of.latex.clone()).collect())
        )?;
        for row in &self.rows {
            writeln!(out, "{}", line(row.iter().map(|cell| latex(cell)).collect()))?;
        }
        writeln!(out, "\\bottomrule\n\\end{{tabular}}")
    }

    /// Writes a table of Markdown with pipes.
    pub(super) fn markdown(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let line = |cells: Vec<String>| format!("| {} |", cells.join(" | "));
        let cell = |text: &str| text.replace('|', "\\|").replace('\n', " ");
        writeln!(out, "{}", line(self.headings.iter().map(|of| cell(&of.words)).collect()))?;
        writeln!(out, "|{}", " --- |".repeat(self.headings.len()))?;
        self.rows.iter().try_for_each(|row| {
            writeln!(out, "{}", line(row.iter().map(|text| cell(&printed(text))).collect()))
        })
    }
}

/// Mode or verdict of an arch, or why it has none.
fn verdict(answer: &Answer) -> String {
    match (&answer.status, answer.modes.first(), answer.stands) {
        (Status::Proved, Some(mode), _) => mode.label().to_owned(),
        (Status::Proved, None, Some(true)) => "stands".to_owned(),
        (Status::Proved, None, Some(false)) => "collapses".to_owned(),
        (Status::Falls(fall), ..) => format!("falls ({})", super::words::reason(*fall)),
        (status, ..) => status.name().to_owned(),
    }
}

/// A value, an angle in degrees; sizes have digits of their own, which are fewer.
fn number(quantity: Quantity, value: &Value, digits: usize) -> String {
    match enclosure(value, digits) {
        Some(angle) if is_in_radians(quantity) => rounded(&degrees(&angle), digits),
        Some(ball) if !quantity.is_measured() => rounded(&ball, digits),
        _ => printed(&value.text()),
    }
}

/// Tells whether a quantity is what was given, whatever the weight.
fn is_given(quantity: Quantity) -> bool {
    use Quantity::{GivenThicknessInMetres, Rise, Span};
    matches!(quantity, Span | Rise | GivenThicknessInMetres)
}

fn is_in_radians(quantity: Quantity) -> bool {
    quantity.symbol().ends_with("rad")
}

/// The second value less the first.
fn difference(quantity: Quantity, one: &Value, other: &Value, digits: usize) -> String {
    let (Some(one), Some(other)) = (enclosure(one, digits), enclosure(other, digits)) else {
        return NONE.to_owned();
    };
    let difference = other - one;
    rounded(&if is_in_radians(quantity) { degrees(&difference) } else { difference }, digits)
}

/// Unit of a quantity that is in radians, with the angle in degrees too, in six digits or as many as are proved.
pub(super) fn in_degrees_too(quantity: Quantity, value: &Value) -> String {
    const DIGITS: usize = 6;
    match enclosure(value, DIGITS) {
        Some(angle) if is_in_radians(quantity) => {
            format!(" rad = {} deg", rounded(&degrees(&angle), DIGITS))
        }
        _ => String::new(),
    }
}

/// The bounds of a value, which is not infinite.
fn enclosure(value: &Value, digits: usize) -> Option<Ball> {
    let bits = bits_of(digits) + GUARD;
    let decimal = value.decimal.as_ref()?;
    let bound = |text: String| Some(text.parse::<ExactNumber>().ok()?.enclosure::<Ball>(bits));
    Some(bound(decimal.lower.to_string())?.hull(&bound(decimal.upper.to_string())?))
}

/// A number in so many digits, or in as many as are proved; a bound of its size where not even its sign is.
fn rounded(ball: &Ball, digits: usize) -> String {
    let most = || Rounded::most(ball, digits).map(|rounded| rounded.value.to_string());
    in_digits(ball, digits).or_else(most).unwrap_or_else(|| format!("0 ± {:.0e}", 2.0 * size(ball)))
}

/// A bound of the size of a number.
fn size(ball: &Ball) -> f64 {
    let bound = |x: Float| x.abs().to_f64_round(Round::Up);
    bound(ball.lower()).max(bound(ball.upper()))
}

/// A given value as one prints it: degrees with their sign, infinity as one.
fn printed(text: &str) -> String {
    match text {
        "inf" => "∞".to_owned(),
        "" => NONE.to_owned(),
        text => match text.strip_suffix("deg") {
            Some(degrees) => format!("{degrees}°"),
            None => text.replace("pi", "π"),
        },
    }
}

/// A cell in LaTeX.
fn latex(cell: &str) -> String {
    let cell = printed(cell);
    match (cell.strip_suffix('°'), &cell[..]) {
        (Some(degrees), _) if degrees.parse::<f64>().is_ok() => format!(r"\ang{{{degrees}}}"),
        (_, NONE) => "--".to_owned(),
        (_, text) if text.parse::<f64>().is_ok() => format!(r"\num{{{text}}}"),
        (_, text) => in_latex(text),
    }
}

#[cfg(test)]
mod tests {
    use super::super::format::Format;
    use super::super::reported::Reported;
    use super::*;
    use crate::certify::state::Inquiry;
    use crate::problem::Arch;

    fn arches(friction: &str, quantities: &[Quantity]) -> String {
        let answer = |weight| {
            let arch = Arch::parse(weight, "80deg", friction).unwrap();
            Answer::state(1, &arch, &Inquiry::new(&arch, 12, false).state(12, false))
        };
        let list = ["heyman", "milankovitch"].map(answer).to_vec();
        let report =
            Answers { list, quantities: quantities.to_vec(), ..Answers::arches(12, false) };
        let mut out = Vec::new();
        PaperTable::of(&report).markdown(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn two_weights_stand_side_by_side_with_the_digits_of_their_difference() {
        let table = arches("inf", &[Quantity::Thickness, Quantity::RotationJoint]);
        let row: Vec<&str> = table.lines().nth(2).unwrap().split(" | ").collect();
        assert_eq!(row[..2], ["| 80°", "∞"], "{table}");
        let numbers: Vec<f64> =
            row[4..].iter().map(|x| x.trim_end_matches(" |").parse().unwrap()).collect();
        let [heyman, milankovitch, difference, joint, ..] = numbers[..] else { panic!("{table}") };
        assert!((milankovitch - heyman - difference).abs() < 1e-11 && difference > 1e-5, "{table}");
        assert!(49.0 < joint && joint < 51.0, "in degrees: {table}");
    }

    /// Of few digits as of many: beta_r is 57.5029237…, beta_s 17.5895414… degrees.
    #[test]
    fn an_angle_has_the_digits_that_are_asked_for() {
        let arch = Arch::parse("milankovitch", "2.45", "1.35").unwrap();
        let quantities = vec![Quantity::Thickness, Quantity::RotationJoint, Quantity::SlidingJoint];
        for (digits, cells) in [
            (1, "0.7 | 60 | 20"),
            (2, "0.65 | 58 | 18"),
            (3, "0.650 | 57.5 | 17.6"),
            (4, "0.6502 | 57.50 | 17.59"),
            (5, "0.65024 | 57.503 | 17.590"),
            (6, "0.650244 | 57.5029 | 17.5895"),
        ] {
            for (name, cells) in [
                ("markdown", cells.to_owned()),
                ("latex", format!("\\num{{{}}}", cells.replace(" | ", "} & \\num{"))),
            ] {
                let format = Format::named(Answers::content(), name).unwrap();
                let proved = format.proved_digits(digits);
                let state = Inquiry::new(&arch, proved, false).state(proved, false);
                let list = vec![Answer::state(1, &arch, &state)];
                let quantities = quantities.clone();
                let report = Answers { list, quantities, ..Answers::arches(digits, false) };
                let mut out = Vec::new();
                report.write(format, &mut out).unwrap();
                let table = String::from_utf8(out).unwrap();
                assert!(table.contains(&cells), "{digits}: {table}");
            }
        }
    }

    /// Arches of one half opening that are measured are not one arch.
    #[test]
    fn arches_given_alike_keep_their_rows() {
        let arch = Arch::parse("heyman", "80deg", "0.6").unwrap();
        let answer = Answer::state(1, &arch, &Inquiry::new(&arch, 6, false).state(6, false));
        let report = Answers { list: vec![answer.clone(), answer], ..Answers::arches(6, false) };
        assert_eq!(PaperTable::of(&report).rows.len(), 2);
    }

    #[test]
    fn what_does_not_stand_has_dashes_and_its_reason() {
        let table = arches("0.1", &[Quantity::Thickness, Quantity::SlidingFriction]);
        let row = table.lines().nth(2).unwrap();
        assert!(
            row.contains("falls (sliding) | falls (sliding)") && !table.contains("eta = t/r"),
            "{table}"
        );
    }

    #[test]
    fn cells_are_as_one_prints_them() {
        for (cell, markdown, tex) in [
            ("80deg", "80°", r"\ang{80}"),
            ("inf", "∞", r"$\infty$"),
            ("pi/2", "π/2", r"$\pi$/2"),
            ("-1.5e-9", "-1.5e-9", r"\num{-1.5e-9}"),
            ("", "–", "--"),
            (r"\input{x}", r"\input{x}", r"\textbackslash{}input\{x\}"),
        ] {
            assert_eq!((&printed(cell)[..], latex(cell)), (markdown, tex.to_owned()), "{cell}");
        }
    }

    #[test]
    fn a_row_never_begins_with_an_option_of_the_row_before() {
        let heading = Heading::named("mode");
        let rows = ["[r,r,r]", "*", "r"].map(|cell| vec![cell.to_owned()]).to_vec();
        let mut out = Vec::new();
        PaperTable { headings: vec![heading], rows }.latex(&mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        let rows: Vec<&str> = text.lines().skip(5).take(3).collect();
        assert_eq!(rows, [r"{}[r,r,r] \\", r"{}* \\", r"r \\"], "{text}");
    }

    #[test]
    fn a_difference_of_which_not_even_the_sign_is_known_is_bounded() {
        let near = Ball::integer(-1, 64).hull(&Ball::integer(2, 64));
        let bound: f64 = rounded(&near, 5).strip_prefix("0 ± ").unwrap().parse().unwrap();
        assert!(bound >= 2.0, "{bound}");
    }
}
