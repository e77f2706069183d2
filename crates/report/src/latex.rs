//! LaTeX with `siunitx`: arches in a table for a paper, other values each beside what the paper prints for it.

use super::answers::Answers;
use super::find;
use super::listing::comments;
use super::names::{about, head, plain, safe};
use super::paper::PaperTable;
use super::subject::Subject;
use super::value::Value;
use super::words::author;
use crate::problem::Landmark;
use std::io;

const HEAD: &str = r"%
% Needs \usepackage{booktabs,longtable,siunitx}.
\begin{longtable}{lllll}
\toprule
 & weight & quantity & certified value & printed, not certified \\
\midrule
\endhead
\bottomrule
\endfoot";

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    comments(head(report), "% ", out)?;
    if report.has_row_each() {
        comments(report.list.iter().flat_map(about), "% ", out)?;
        return PaperTable::of(report).latex(out);
    }
    writeln!(out, "{HEAD}")?;
    for (index, answer) in report.list.iter().enumerate() {
        if index > 0 {
            writeln!(out, r"\midrule")?;
        }
        comments(about(answer), "% ", out)?;
        let title = title(&answer.subject);
        if let Some(reason) = answer.status.reason() {
            let (status, reason) = (answer.status.name(), plain(reason));
            writeln!(out, r"{title} & \multicolumn{{3}}{{l}}{{{status}: {reason}}} \\")?;
        }
        for (quantity, value) in &answer.values {
            writeln!(out, r"{title} & {} & {} \\", quantity.latex(), cells(value))?;
        }
    }
    writeln!(out, r"\end{{longtable}}")
}

/// The name of a subject, and its weight.
fn title(subject: &Subject) -> String {
    let name = match subject {
        Subject::Landmark { landmark, .. } => match landmark {
            Landmark::RotationEnd => r"$\ell$".to_owned(),
            Landmark::WidestJoint => r"$s_b$".to_owned(),
            other => format!("${}$", other.symbol()),
        },
        Subject::Arch { line, half_opening, friction, .. } => {
            let (alpha, mu) = (plain(half_opening), plain(friction));
            format!(r"{line}: $\alpha$ {alpha}, $\mu$ {mu}")
        }
        Subject::Sought { .. } => plain(&find::asked(subject)),
        Subject::Query { line } => line.to_string(),
    };
    format!("{name} & {}", subject.weight().map_or("", author))
}

/// The value, and what the paper prints for it.
fn cells(value: &Value) -> String {
    let number = match &value.decimal {
        Some(decimal) => format!(r"\num{{{}}}", decimal.value),
        None => r"$\infty$".into(),
    };
    let exact = match value.closed_form() {
        Some(closed) => format!(" ${{}} = {}$", formula(closed)),
        None if value.exact.is_some() && value.decimal.is_some() => " exactly".into(),
        None => String::new(),
    };
    let printed: Vec<String> = value.printed.iter().map(|text| printed(text)).collect();
    format!("{number}{exact} & {}", printed.join(", "))
}

/// A number as the paper prints it: decimal, or a fraction.
fn printed(text: &str) -> String {
    if text.contains('/') { format!("${text}$") } else { format!(r"\num{{{text}}}") }
}

/// An exact value: its roots are of whole numbers.
fn formula(text: &str) -> String {
    let mut formula = String::new();
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '√' => {
                formula += r"\sqrt{";
                while let Some(digit) = rest.next_if(char::is_ascii_digit) {
                    formula.push(digit);
                }
                formula.push('}');
            }
            'π' => formula += r"\pi ",
            '−' => formula.push('-'),
            c => formula += &safe(&c.to_string()),
        }
    }
    formula
}
