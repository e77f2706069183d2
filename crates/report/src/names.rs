//! The names of values in programs, and the comments about them.
//!
//! A name is the point, the weight and the quantity: `T_HEYMAN_THICKNESS`. The points are `T`, `S`, `J`,
//! `B`, `SB`, and `ROTATION_END` and `OVERTURNING_END` for `l` and `L`, which many languages do not tell
//! apart. An arch is `STATE_` with the line of its query. The same name with `LOWER`, `UPPER`, `ERROR` added
//! is what its double leaves open. No text from outside becomes part of a name.

use super::answer::Answer;
use super::answers::{Answers, TOOL};
use super::find;
use super::subject::Subject;
use super::value::Value;
use super::words::model;
use crate::problem::{Landmark, Quantity};

/// A value with its names.
pub(super) struct Named<'a> {
    /// The point, the weight and the quantity; or the arch and the quantity.
    pub words: Vec<String>,
    /// The value.
    pub value: &'a Value,
    quantity: Quantity,
}

impl<'a> Named<'a> {
    /// The values of an answer.
    pub(super) fn all(answer: &'a Answer) -> impl Iterator<Item = Self> {
        answer.values.iter().map(|(quantity, value)| {
            let mut words = match &answer.subject {
                Subject::Landmark { landmark, weight } => {
                    let point = match landmark {
                        Landmark::RotationEnd => "rotation_end",
                        Landmark::OverturningEnd => "overturning_end",
                        other => other.symbol(),
                    };
                    vec![point.to_owned(), weight.name().to_owned()]
                }
                Subject::Arch { line, .. } | Subject::Query { line } => {
                    vec![format!("state_{line}")]
                }
                Subject::Sought { line, .. } => vec![format!("found_{line}")],
            };
            words.push(quantity.name().to_owned());
            Self { words, value, quantity: *quantity }
        })
    }

    /// The name in capitals.
    pub(super) fn capitals(&self) -> String {
        self.words.join("_").to_uppercase()
    }

    /// The comment on the value: its symbol, and its exact value if there is one.
    pub(super) fn remark(&self) -> String {
        let symbol = self.quantity.symbol();
        match &self.value.exact {
            Some(exact) => format!("{symbol}: {} exactly", safe(exact)),
            None => symbol.to_owned(),
        }
    }

    /// The doubles of the value, each with the suffix of its name.
    pub(super) fn doubles(&self) -> [(&'static str, f64); 4] {
        let Value { double, binary, .. } = self.value;
        [
            ("", *double),
            ("_LOWER", binary.lower),
            ("_UPPER", binary.upper),
            ("_ERROR", binary.error),
        ]
    }
}

/// The top of a file.
pub(super) fn head(report: &Answers) -> Vec<String> {
    let digits = report.digits;
    let noun = if digits == 1 { "digit" } else { "digits" };
    vec![
        format!("{}, made by {TOOL}.", report.title()),
        String::new(),
        format!("Every value is proved. Its text is the true value rounded to the nearest with {digits}"),
        format!("significant {noun}, exact where it ends before; inf is exactly infinite. Lengths are in"),
        "units of the centreline radius, forces of weight per length times radius, angles in radians".into(),
        "unless the name says degrees. A is alpha cot(alpha/2).".into(),
    ]
}

/// Words that a program adds.
const NUMBERS: [&str; 6] = [
    "Each title is followed by the command that writes the certificate of the values, and the SHA-256",
    "of its output (| sha256sum).",
    "",
    "Numbers are doubles, bit for bit: the nearest to the true value (not to its text), one not above",
    "it (LOWER), one not below it (UPPER), and a bound of the error of the nearest (ERROR).",
    "ROTATION_END and OVERTURNING_END are the points l and L.",
];

/// The top of a program.
pub(super) fn preface(report: &Answers) -> Vec<String> {
    head(report).into_iter().chain(NUMBERS.map(str::to_owned)).collect()
}

/// The comments on an answer, before its values.
pub(super) fn about(answer: &Answer) -> Vec<String> {
    let title = match &answer.subject {
        Subject::Landmark { landmark, weight } => {
            format!("{}, {}, {}", landmark.symbol(), landmark.name(), model(*weight))
        }
        Subject::Arch { line, weight, half_opening, friction, thickness, .. } => {
            let thickness = thickness.as_ref().map(|eta| format!("thickness {}", safe(eta)));
            let circle = answer.measured_at.map(|at| format!("measured at its {}", at.name()));
            let mode = answer.modes.first().map(|mode| format!("collapses as {}", mode.label()));
            let (alpha, mu) = (safe(half_opening), safe(friction));
            let shape = Some(format!("{line}: half opening {alpha}, friction {mu}"));
            let parts = [shape, thickness, circle, Some(model(*weight)), mode];
            parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
        }
        Subject::Sought { line, weight, .. } => {
            format!("{line}: {}, {}", safe(&find::asked(&answer.subject)), model(*weight))
        }
        Subject::Query { line } => format!("{line}: not read"),
    };
    let none = if answer.values.is_empty() { ", no values" } else { "" };
    let reason = answer.status.reason().map(|reason| format!(": {}", safe(reason)));
    let mut lines =
        vec![format!("{title}: {}{none}{}", answer.status.name(), reason.unwrap_or_default())];
    match &answer.certificate {
        Ok(fingerprint) => {
            lines.push(format!("certificate: {}", fingerprint.command));
            lines.push(format!("sha256 of its output: {}", fingerprint.sha256));
        }
        Err(reason) => lines.push(format!("no certificate hash: {}", safe(reason))),
    }
    lines
}

/// Text that ends no comment and no string of any language, and starts nothing in it: what is not a
/// letter, a digit or harmless becomes `_`.
pub(super) fn safe(text: &str) -> String {
    let harmless = |c: char| c.is_ascii_alphanumeric() || " .,:;()[]+-/=<>'√π−".contains(c);
    text.chars().map(|c| if harmless(c) { c } else { '_' }).collect()
}

/// Text from outside, harmless to LaTeX.
pub(super) fn plain(text: &str) -> String {
    in_latex(&safe(text))
}

/// Signs that words have, in LaTeX.
const SIGNS: [(char, &str); 19] = [
    ('^', r"\textasciicircum{}"),
    ('~', r"\textasciitilde{}"),
    ('\\', r"\textbackslash{}"),
    ('|', r"\textbar{}"),
    ('<', "$<$"),
    ('>', "$>$"),
    ('−', "$-$"),
    ('±', r"$\pm$"),
    ('×', r"$\times$"),
    ('·', r"$\cdot$"),
    ('√', r"$\surd$"),
    ('∞', r"$\infty$"),
    ('π', r"$\pi$"),
    ('°', r"$^\circ$"),
    ('≃', r"$\simeq$"),
    ('≤', r"$\le$"),
    ('≥', r"$\ge$"),
    ('⁻', "$^-$"),
    ('…', r"\dots{}"),
];

/// Raised digits, in order.
const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/// Words with what LaTeX would take for commands written out, and a question mark for what its fonts have not.
pub(super) fn in_latex(words: &str) -> String {
    let mut text = String::new();
    for c in words.chars() {
        match c {
            '_' | '&' | '%' | '#' | '$' | '{' | '}' => text.extend(['\\', c]),
            c if c.is_whitespace() || c.is_control() => text.push(' '),
            c if RAISED.contains(c) => {
                let digit = RAISED.chars().take_while(|other| *other != c).count();
                text += &format!("$^{digit}$");
            }
            c => match SIGNS.iter().find(|(sign, _)| *sign == c) {
                Some((_, written)) => text += written,
                None if matches!(c, 'Ð' | 'Þ' | 'ð' | 'þ') => text.push('?'),
                None if c.is_ascii() || matches!(c, 'À'..='ÿ' | '–') => text.push(c),
                None => text.push('?'),
            },
        }
    }
    text
}

/// The bits of a double in hexadecimal.
pub(super) fn bits(x: f64) -> String {
    format!("{:016x}", x.to_bits())
}

#[cfg(test)]
mod tests {
    use super::{in_latex, safe};

    #[test]
    fn text_from_outside_ends_no_comment_and_no_string() {
        assert_eq!(safe("2(2√3−3), pi/2, [r,r,s], 1e-3"), "2(2√3−3), pi/2, [r,r,s], 1e-3");
        let hostile = "*/\"\"\"\n\r\\%}{#$`&~^?!|\u{2028}é";
        assert_eq!(safe(hostile).replace('_', ""), "/");
    }

    #[test]
    fn latex_meets_no_character_that_it_does_not_know() {
        assert_eq!(in_latex("Ærø, 5 % – |x|"), r"Ærø, 5 \% – \textbar{}x\textbar{}");
        assert_eq!(in_latex("a\u{2028}b\r\n\tc\0d"), "a b   c d");
        assert_eq!(in_latex("橋\u{301}\u{200b}þ"), "????");
        assert_eq!(in_latex("0 ± 4e-30, 4 mu², 28°"), r"0 $\pm$ 4e-30, 4 mu$^2$, 28$^\circ$");
        assert_eq!(in_latex("⁰¹⁶⁹⁻"), "$^0$$^1$$^6$$^9$$^-$");
    }
}
