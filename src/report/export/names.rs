//! What values are called in a program, and what is said of them in its comments.
//!
//! A name is the point, the weight and the quantity: `T_HEYMAN_THICKNESS`. The points are `T`, `S`, `J`,
//! `B`, `SB`, and `ROTATION_END` and `OVERTURNING_END` for `l` and `L`, which many languages do not tell
//! apart. An arch is `STATE_` with the line of its query. No text from outside becomes part of a name.

use super::{Certificate, Export, Exported, Of, Subject, TOOL};
use crate::arch::SelfWeight;
use crate::problem::Landmark;

/// The words of a subject's names: the point and the weight, or the arch.
pub fn words(of: &Of) -> Vec<String> {
    let point = |landmark: &Landmark| match landmark {
        Landmark::RotationEnd => "rotation_end",
        Landmark::OverturningEnd => "overturning_end",
        other => other.symbol(),
    };
    match of {
        Of::Landmark { landmark, weight } => vec![point(landmark).into(), weight.name().into()],
        Of::Arch { number, .. } | Of::Query { number } => vec![format!("state_{number}")],
    }
}

/// The name of a value in capitals.
pub fn capitals(subject: &Subject, value: &Exported) -> String {
    format!("{}_{}", words(&subject.of).join("_"), value.label.name).to_uppercase()
}

/// What stands at the top of a file.
pub fn head(export: &Export) -> Vec<String> {
    let digits = export.digits;
    let plural = if digits == 1 { "" } else { "s" };
    vec![
        format!("{}, made by {TOOL}.", export.title),
        String::new(),
        format!("Every value is proved. Its text is the true value rounded to the nearest with {digits}"),
        format!("significant digit{plural}, exact where it ends before; inf is exactly infinite. Lengths are in"),
        "units of the centreline radius, forces of weight per length times radius, angles in radians".into(),
        "unless the name says degrees. A is alpha cot(alpha/2).".into(),
    ]
}

/// What is said in a program besides.
const NUMBERS: [&str; 6] = [
    "After each title stands the command that writes the certificate of the values, and the SHA-256 of",
    "what it writes (| sha256sum).",
    "",
    "Numbers are doubles, bit for bit: the nearest to the true value (not to its text), one not above",
    "it (LOWER), one not below it (UPPER), and a bound of the error of the nearest (ERROR).",
    "ROTATION_END and OVERTURNING_END are the points l and L.",
];

/// The top of a program.
pub fn preface(export: &Export) -> Vec<String> {
    head(export).into_iter().chain(NUMBERS.map(str::to_owned)).collect()
}

/// What is said of a subject before its values.
pub fn about(subject: &Subject) -> Vec<String> {
    let model = |weight: &SelfWeight| match weight {
        SelfWeight::Heyman => "Heyman's self-weight",
        SelfWeight::Milankovitch => "Milankovitch-like self-weight",
    };
    let title = match &subject.of {
        Of::Landmark { landmark, weight } => {
            format!("{}, {}, {}", landmark.symbol(), landmark.name(), model(weight))
        }
        Of::Arch { number, weight, half_opening, friction, thickness, mode, .. } => {
            let thickness = thickness.as_ref().map(|eta| format!(", thickness {}", safe(eta)));
            let mode = mode.map(|mode| format!(", collapses as {}", mode.label()));
            let (alpha, mu) = (safe(half_opening), safe(friction));
            let weight = model(weight);
            format!(
                "{number}: half opening {alpha}, friction {mu}{}, {weight}{}",
                thickness.unwrap_or_default(),
                mode.unwrap_or_default(),
            )
        }
        Of::Query { number } => format!("{number}: not read"),
    };
    let none = if subject.values.is_empty() { ", no values" } else { "" };
    let mut lines = match subject.status.words() {
        (status, None) => vec![format!("{title}: {status}{none}")],
        (status, Some(reason)) => vec![format!("{title}: {status}{none}: {}", safe(reason))],
    };
    match &subject.certificate {
        Certificate::Hash { command, sha256 } => {
            lines.push(format!("certificate: {command}"));
            lines.push(format!("sha256 of its output: {sha256}"));
        }
        Certificate::None(reason) => lines.push(format!("no certificate hash: {}", safe(reason))),
    }
    lines
}

/// What is said of a value: its symbol, and that it is exact.
pub fn remark(value: &Exported) -> String {
    let symbol = value.label.symbol;
    match &value.exact {
        Some(exact) => format!("{symbol}: {} exactly", safe(exact)),
        None => symbol.to_owned(),
    }
}

/// Text that ends no comment and no string of any language, and starts nothing in it: what is not a
/// letter, a digit or harmless becomes `_`.
pub fn safe(text: &str) -> String {
    let harmless = |c: char| c.is_ascii_alphanumeric() || " .,:;()[]+-/=<>'√π−".contains(c);
    text.chars().map(|c| if harmless(c) { c } else { '_' }).collect()
}

/// The bits of a double in hexadecimal.
pub fn bits(x: f64) -> String {
    format!("{:016x}", x.to_bits())
}

/// The doubles of a value, with what is added to its name.
pub fn doubles(value: &Exported) -> [(&'static str, f64); 4] {
    let binary = &value.binary;
    [
        ("", value.double),
        ("_LOWER", binary.lower),
        ("_UPPER", binary.upper),
        ("_ERROR", binary.error),
    ]
}

#[cfg(test)]
mod tests {
    use super::safe;

    #[test]
    fn text_from_outside_ends_no_comment_and_no_string() {
        assert_eq!(safe("2(2√3−3), pi/2, [r,r,s], 1e-3"), "2(2√3−3), pi/2, [r,r,s], 1e-3");
        let hostile = "*/\"\"\"\n\r\\%}{#$`&~^?!|\u{2028}é";
        assert_eq!(safe(hostile).replace('_', ""), "/");
    }
}
