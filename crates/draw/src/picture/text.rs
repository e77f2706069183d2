//! The width of a text, its lines, powers of ten.

/// Height of a line in font sizes.
pub const LEADING: f64 = 1.3;

/// Advance widths of DejaVu Sans from the space to the tilde, in thousandths of the size, rounded up.
#[rustfmt::skip]
const ADVANCES: [u16; 95] = [
    318, 401, 460, 838, 637, 951, 780, 275, 391, 391, 500, 838, 318, 361, 318, 337,
    637, 637, 637, 637, 637, 637, 637, 637, 637, 637, 337, 337, 838, 838, 838, 531,
    1000, 685, 687, 699, 771, 632, 576, 775, 752, 295, 295, 656, 558, 863, 749, 788,
    604, 788, 695, 635, 611, 732, 685, 989, 686, 611, 686, 391, 337, 391, 838, 500,
    500, 613, 635, 550, 635, 616, 353, 635, 634, 278, 278, 580, 278, 975, 634, 612,
    635, 635, 412, 521, 393, 634, 592, 818, 592, 592, 525, 637, 337, 637, 838,
];

/// The width of a text in DejaVu Sans, which is among the widest. Other characters than those of
/// formulas are taken as wide.
pub fn width(text: &str, size: f64) -> f64 {
    let advance = |c: char| match c {
        ' '..='~' => ADVANCES[c as usize - ' ' as usize],
        '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' => 401,
        '×' | '−' | '≥' | '≤' | '±' => 838,
        'ᵣ' | 'ₛ' | 'ₗ' | 'ₕ' | 'ₘ' | '°' | '–' | 'ℓ' => 500,
        '⁻' => 528,
        'α'..='ω' => 700,
        '·' => 318,
        _ => 1000,
    };
    text.chars().map(|c| f64::from(advance(c))).sum::<f64>() * size / 1000.0
}

/// The width of the widest of some texts.
pub fn widest(texts: impl IntoIterator<Item: AsRef<str>>, size: f64) -> f64 {
    texts.into_iter().map(|text| width(text.as_ref(), size)).fold(0.0, f64::max)
}

/// A text in lines no wider than `limit`, unless a word is.
pub fn wrap(text: &str, size: f64, limit: f64) -> Vec<String> {
    let words = text.split(|c: char| c.is_whitespace() || c.is_control());
    let mut lines: Vec<String> = Vec::new();
    for word in words.filter(|word| !word.is_empty()) {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(" ", size) + width(word, size) <= limit => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// `10^exponent`, written with raised digits.
pub fn power_of_ten(exponent: i64) -> String {
    let raised = |c: char| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    };
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

/// A number with so many decimals, with a minus sign as wide as a plus.
pub fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().any(|c| matches!(c, '1'..='9')) => format!("−{digits}"),
        Some(digits) => digits.to_owned(),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_hold_all_words_in_their_width() {
        let text = "the quick brown\u{1} fox  jumps\nover the lazy dog";
        let lines = wrap(text, 10.0, 80.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| width(line, 10.0) <= 80.0));
        assert_eq!(lines.join(" "), "the quick brown fox jumps over the lazy dog");
        assert_eq!(wrap("incomprehensibilities", 10.0, 20.0).len(), 1);
        assert!(wrap(" \n", 10.0, 80.0).is_empty());
    }

    #[test]
    fn numbers_read_well() {
        assert_eq!(power_of_ten(-20_000), "10⁻²⁰⁰⁰⁰");
        assert_eq!(power_of_ten(0), "10⁰");
        assert_eq!(number(-0.25, 2), "−0.25");
        assert_eq!(number(-0.001, 1), "0.0");
    }
}
