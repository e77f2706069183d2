//! Texts that are meant as ranges, which readers of one number refuse as such.

/// Sign between the two ends of a range.
pub const BETWEEN: &str = "..";
/// Signs between a value and how far off it may be.
pub const PLUS_MINUS: [&str; 2] = ["±", "+-"];

/// Commands that tell of ranges, for who asks elsewhere.
pub const TELL_OF_RANGES: &str = "`couplet assess`, `state`, `voussoirs`, `find half-opening`, `find friction`, `draw` and `certify survey`";

/// Tells whether a text is meant as a range: `0.5..0.7`, `0.6±0.1`, `0.6+-10%`.
pub fn is_range(text: &str) -> bool {
    text.contains(BETWEEN) || PLUS_MINUS.iter().any(|sign| text.contains(sign))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::ExactNumber;

    #[test]
    fn a_range_is_no_number_and_is_refused_as_a_range() {
        for text in ["0.5..0.7", "80deg±1deg", "1e-5+-1%", ".."] {
            let error = text.parse::<ExactNumber>().unwrap_err().to_string();
            assert!(is_range(text) && error.contains("is a range: one value"), "{text}: {error}");
        }
        for text in ["1e+5", "-1", "1,5", "a.b"] {
            let error = text.parse::<ExactNumber>().err().map(|error| error.to_string());
            let error = error.unwrap_or_default();
            assert!(!is_range(text) && !error.contains("range"), "{text}: {error}");
        }
    }
}
