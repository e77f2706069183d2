//! LaTeX: a table with `siunitx`, each value beside what the paper prints for it.

use super::names::{about, head, safe};
use super::{Export, Exported, Of, Subject};
use crate::arch::SelfWeight;
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

pub fn write(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    for line in head(export) {
        writeln!(out, "{}", format!("% {line}").trim_end())?;
    }
    writeln!(out, "{HEAD}")?;
    for (index, subject) in export.subjects.iter().enumerate() {
        if index > 0 {
            writeln!(out, r"\midrule")?;
        }
        for line in about(subject) {
            writeln!(out, "% {line}")?;
        }
        let (name, weight) = title(&subject.of);
        if let (status, Some(reason)) = subject.status.words() {
            let reason = plain(reason);
            writeln!(out, r"{name} & {weight} & \multicolumn{{3}}{{l}}{{{status}: {reason}}} \\")?;
        }
        for value in &subject.values {
            writeln!(out, "{}", cells(subject, value))?;
        }
    }
    writeln!(out, r"\end{{longtable}}")
}

fn title(of: &Of) -> (String, &'static str) {
    let name = |weight: &SelfWeight| match weight {
        SelfWeight::Heyman => "Heyman",
        SelfWeight::Milankovitch => "Milankovitch",
    };
    match of {
        Of::Landmark { landmark, weight } => {
            (format!("${}$", landmark_symbol(landmark.symbol())), name(weight))
        }
        Of::Arch { number, weight, half_opening, friction, .. } => {
            let (alpha, mu) = (plain(half_opening), plain(friction));
            (format!(r"{number}: $\alpha$ {alpha}, $\mu$ {mu}"), name(weight))
        }
        Of::Query { number } => (number.to_string(), ""),
    }
}

fn landmark_symbol(symbol: &str) -> &str {
    match symbol {
        "l" => r"\ell",
        "sb" => r"s_b",
        other => other,
    }
}

fn cells(subject: &Subject, value: &Exported) -> String {
    let (name, weight) = title(&subject.of);
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
    let printed = printed.join(", ");
    let quantity = value.label.latex;
    format!(r"{name} & {weight} & {quantity} & {number}{exact} & {printed} \\")
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

/// Text from outside, harmless to LaTeX.
fn plain(text: &str) -> String {
    let written = |c: char| match c {
        '_' => r"\_".to_owned(),
        '<' | '>' | '=' => format!("${c}$"),
        '√' => r"$\surd$".to_owned(),
        'π' => r"$\pi$".to_owned(),
        '−' => "$-$".to_owned(),
        c => c.to_string(),
    };
    safe(text).chars().map(written).collect()
}
