//! Permissions of a page: its own style and script, told by their hashes, and nothing else.

use sha2::{Digest, Sha256};

/// The content security policy of a page with one style and one script.
pub(super) fn policy(style: &str, script: &str) -> String {
    let [style, script] = [style, script].map(|text| base64(&Sha256::digest(text)));
    format!(
        "default-src 'none'; style-src 'sha256-{style}'; script-src 'sha256-{script}'; base-uri 'none'; form-action \
         'none'"
    )
}

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

fn base64(bytes: &[u8]) -> String {
    let letters = bytes.chunks(3).flat_map(|chunk| {
        let byte = |index: usize| u32::from(chunk.get(index).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        let letter = move |k: usize| char::from(LETTERS[(bits >> (18 - 6 * k) & 63) as usize]);
        let used = chunk.len() + 1;
        (0..4).map(move |k| if k < used { letter(k) } else { '=' })
    });
    letters.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of RFC 4648.
    #[test]
    fn letters_stand_for_six_bits() {
        for (text, letters) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(text.as_bytes()), letters);
        }
    }

    #[test]
    fn another_script_has_another_policy() {
        let one = policy("p {}", "f();");
        assert!(one.starts_with("default-src 'none';") && !one.contains("unsafe"), "{one}");
        assert_ne!(one, policy("p {}", "g();"));
        assert_ne!(one, policy("q {}", "f();"));
    }
}
