//! Text from outside in a message.

/// Characters that are shown.
const SHOWN: usize = 40;

/// A text from outside in a message: not all of a long one, and escapes for what a terminal would obey.
///
/// ```
/// assert_eq!(couplet::number::shown("1\u{1b}[2K'"), r"1\u{1b}[2K'");
/// assert_eq!(couplet::number::shown(&"1".repeat(50)).chars().count(), 40);
/// ```
pub fn shown(text: &str) -> String {
    let mut shown: String = text.chars().take(SHOWN).flat_map(harmless).collect();
    if text.chars().nth(SHOWN).is_some() {
        shown.pop();
        shown.push('…');
    }
    shown
}

/// A character, or its escape where it is not to be seen.
fn harmless(c: char) -> impl Iterator<Item = char> {
    let is_plain = matches!(c, '\'' | '"' | '\\');
    let plain = is_plain.then_some(c);
    plain.into_iter().chain(c.escape_debug().filter(move |_| !is_plain))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_shown_is_obeyed() {
        assert_eq!(shown("a\tb\nc\u{9b}d\u{202e}e\u{7f}"), r"a\tb\nc\u{9b}d\u{202e}e\u{7f}");
        assert_eq!(shown("π/2 'β' \\"), "π/2 'β' \\");
        assert_eq!(shown(&"β".repeat(41)), "β".repeat(39) + "…");
    }
}
