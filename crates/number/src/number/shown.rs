//! Text from outside in a message: on one line, and nothing in it that a terminal would obey.

/// Characters of a text that are shown.
const SHOWN: usize = 40;

/// A text with escapes for what is not to be seen.
///
/// ```
/// assert_eq!(couplet_number::number::visible("1\u{1b}[2K'"), r"1\u{1b}[2K'");
/// ```
pub fn visible(text: &str) -> String {
    let visible = |c: char| {
        let is_quote = matches!(c, '"' | '\'' | '\\');
        let escaped = (!is_quote).then(|| c.escape_debug());
        is_quote.then_some(c).into_iter().chain(escaped.into_iter().flatten())
    };
    text.chars().flat_map(visible).collect()
}

/// A text on one line as it is shown, and not all of a long one: 40 characters at the most.
///
/// ```
/// assert_eq!(couplet_number::number::shown(&"1".repeat(50)).chars().count(), 40);
/// ```
pub fn shown(text: &str) -> String {
    match text.char_indices().nth(SHOWN) {
        None => visible(text),
        Some(_) => visible(&text.chars().take(SHOWN - 1).collect::<String>()) + "…",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_shown_is_obeyed() {
        assert_eq!(shown("a\tb\nc\u{9b}d\u{202e}e\u{7f}"), r"a\tb\nc\u{9b}d\u{202e}e\u{7f}");
        assert_eq!(shown("π/2 'β' \\"), "π/2 'β' \\");
        assert_eq!(shown(&"β".repeat(40)), "β".repeat(40));
        assert_eq!(shown(&"β".repeat(41)), "β".repeat(39) + "…");
    }
}
