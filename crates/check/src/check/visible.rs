//! Text of other people, to be shown: in one line, without control characters, and not too long.

use crate::number::visible;
use std::ffi::OsStr;

/// The name of a file, whatever bytes it has; those that are not UTF-8 as `\xff`.
pub fn visible_name(name: &OsStr) -> String {
    let mut shown = String::new();
    for chunk in name.as_encoded_bytes().utf8_chunks() {
        shown += &visible(chunk.valid());
        shown.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02x}")));
    }
    shown
}

/// The beginning of a text.
pub(super) fn shortened(text: &str) -> String {
    beginning(text, 40)
}

/// Beginning of a text: at most `length` characters of it.
pub(super) fn beginning(text: &str, length: usize) -> String {
    let mut shown = visible(&text.chars().take(length).collect::<String>());
    if text.chars().nth(length).is_some() {
        shown.push('…');
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shown_is_one_line_of_visible_characters() {
        assert_eq!(visible("a'b\\ \u{3b1}"), "a'b\\ \u{3b1}");
        let shown = visible("T\n\r\u{1b}[2K\u{202e}\u{2028}\0");
        assert_eq!(shown, "T\\n\\r\\u{1b}[2K\\u{202e}\\u{2028}\\0");
        assert_eq!(beginning("1234", 3), "123…");
        assert_eq!(shortened(&"7".repeat(40)), "7".repeat(40));
    }

    #[cfg(unix)]
    #[test]
    fn a_name_of_any_bytes_is_shown() {
        use std::os::unix::ffi::OsStrExt;
        assert_eq!(visible_name(OsStr::from_bytes(b"a\xff\nb")), "a\\xff\\nb");
    }
}
