//! Claims as a LaTeX document: words as text, each formula in a paragraph of its own.

use super::decided::{Claims, as_printed, lead, remarks, summary};
use crate::names::in_latex;
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
    writeln!(out, "{}\n", in_latex(&summary(&report.decisions)))?;
    for decision in &report.decisions {
        let claim = &decision.claim;
        let title = format!("{}, {}: {}", claim.id, claim.place, as_printed(decision));
        writeln!(out, "\\subsection*{{{}}}", in_latex(&title))?;
        writeln!(out, "{}.\n", in_latex(claim.statement))?;
        if let Some(beside) = decision.derivation.beside_checks() {
            writeln!(out, "\\textit{{Proved by checks{beside}.}}\n")?;
        }
        for (kind, words) in remarks(decision) {
            writeln!(out, "\\textit{{{kind}:}} {}.\n", in_latex(words))?;
        }
        if !report.show {
            continue;
        }
        for step in decision.derivation.steps() {
            let [_, lead] = lead(step.support);
            writeln!(out, "\\textit{{{lead}}}{}", in_latex(&step.words))?;
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

#[cfg(test)]
mod tests {
    use super::in_latex;
    use crate::claims::claims;

    /// A sign that LaTeX does not know becomes a question mark.
    #[test]
    fn every_sign_of_a_statement_is_kept() {
        for claim in claims() {
            let written = in_latex(claim.statement);
            assert!(!written.contains('?'), "{}: {written}", claim.id);
        }
        assert!(in_latex("橋").contains('?'));
    }
}
