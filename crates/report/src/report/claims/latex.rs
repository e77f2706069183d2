//! Claims as a LaTeX document: words as text, each formula in a paragraph of its own.

use super::decided::{Claims, as_printed, lead, remarks, summary};
use std::io;

const HEAD: &str = r"\documentclass{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{amsmath}
\begin{document}
\raggedright";

/// Writes all claims.
pub(super) fn claims(report: &Claims, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "{HEAD}")?;
    writeln!(out, "{}\n", plain(&summary(&report.decisions)))?;
    for decision in &report.decisions {
        let claim = &decision.claim;
        let title = format!("{}, {}: {}", claim.id, claim.place, as_printed(decision));
        writeln!(out, "\\subsection*{{{}}}", plain(&title))?;
        writeln!(out, "{}.\n", plain(claim.statement))?;
        if let Some(argument) = decision.derivation.argument() {
            writeln!(out, "\\textit{{Proved by checks {}.}}\n", argument.words())?;
        }
        for (kind, words) in remarks(decision) {
            writeln!(out, "\\textit{{{kind}:}} {}.\n", plain(words))?;
        }
        if !report.show {
            continue;
        }
        for step in decision.derivation.steps() {
            let [_, lead] = lead(step.support);
            writeln!(out, "\\textit{{{lead}}}{}", plain(&step.words))?;
            match &step.formula {
                Some(formula) => {
                    // Within a line of text, so that a long formula can be broken at its signs.
                    writeln!(out, "\\begin{{quote}}\n${}$\n\\end{{quote}}", formula.latex)?;
                }
                None => writeln!(out)?,
            }
        }
    }
    writeln!(out, "\\end{{document}}")
}

/// Words with what LaTeX would take for commands written out.
fn plain(words: &str) -> String {
    let mut text = String::new();
    for c in words.chars() {
        match c {
            '_' | '&' | '%' | '#' | '$' | '{' | '}' => text.extend(['\\', c]),
            '^' => text += r"\textasciicircum{}",
            '~' => text += r"\textasciitilde{}",
            '\\' => text += r"\textbackslash{}",
            '<' | '>' => text += &format!("${c}$"),
            '√' => text += r"$\surd$",
            '−' => text += "$-$",
            'π' => text += r"$\pi$",
            '°' => text += r"$^\circ$",
            '≃' => text += r"$\simeq$",
            c => text.push(c),
        }
    }
    text
}
