//! A file of either kind, told apart by its schema: the certificate of a point or an arch, or that of a survey.

use super::checker::{ASTRO_DIGITS, Accepted, check};
use super::refusal::Refusal;
use super::statement::{statement, survey_statement};
use super::summary::summary;
use super::survey_checker::{AcceptedSurvey, check_survey};
use super::survey_file::{SURVEYS, SurveyCertificate};
use super::survey_summary::survey_summary;
use crate::number::{AstroInterval, Engine};
use serde::de::{Deserializer, IgnoredAny, MapAccess, Visitor};
use std::fmt;

/// The verdict of a successful check of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "there is one for each file")]
pub enum AcceptedFile {
    /// Certificate of a landmark or an arch.
    Certificate(Accepted),
    /// Certificate of a survey.
    Survey(AcceptedSurvey),
}

impl AcceptedFile {
    /// Summary of what was accepted: the end of the line that `couplet check` gives a file.
    pub fn summary(&self) -> String {
        match self {
            Self::Certificate(accepted) => summary(accepted),
            Self::Survey(accepted) => survey_summary(accepted),
        }
    }

    /// Statement that is proved, in one sentence, with every digit.
    ///
    /// ```
    /// let file = include_bytes!("../../../../proofs/states/sliding.json");
    /// let accepted = couplet_check::check::verify_file(file)?;
    /// let start = "half opening 1/2 pi, friction 3/10, milankovitch weight: the arch stands at no thickness, ";
    /// assert!(accepted.statement().starts_with(start));
    /// # Ok::<(), couplet_check::check::Refusal>(())
    /// ```
    pub fn statement(&self) -> String {
        match self {
            Self::Certificate(accepted) => statement(accepted),
            Self::Survey(accepted) => survey_statement(accepted),
        }
    }

    /// Problem, digits and values, of a certificate that has them.
    pub fn certificate(&self) -> Option<&Accepted> {
        match self {
            Self::Certificate(accepted) => Some(accepted),
            Self::Survey(_) => None,
        }
    }
}

/// Checks the bytes of a file of either kind in the arithmetic `E`, as [`check`] and [`check_survey`] do.
pub fn check_file<E: Engine>(bytes: &[u8], max_digits: usize) -> Result<AcceptedFile, Refusal> {
    if is_survey(bytes) {
        let certificate = SurveyCertificate::read(bytes)?;
        return Ok(AcceptedFile::Survey(check_survey::<E>(&certificate, max_digits)?));
    }
    Ok(AcceptedFile::Certificate(check::<E>(bytes, max_digits)?))
}

/// Checks the bytes of a file of either kind in pure Rust, up to [`ASTRO_DIGITS`] digits.
pub fn verify_file(bytes: &[u8]) -> Result<AcceptedFile, Refusal> {
    check_file::<AstroInterval>(bytes, ASTRO_DIGITS)
}

/// Tells whether the first schema of a text is one of surveys, of whatever version. Nothing else is looked at: what
/// reads the file says what is wrong with it.
fn is_survey(bytes: &[u8]) -> bool {
    let Ok(text) = str::from_utf8(bytes) else { return false };
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut is_survey = false;
    // Reading ends at the schema, for which serde has no other word than an error.
    let _ = serde_json::Deserializer::from_str(text).deserialize_map(SchemaOf(&mut is_survey));
    is_survey
}

/// Reader of an object up to its schema.
struct SchemaOf<'a>(&'a mut bool);

impl<'de> Visitor<'de> for SchemaOf<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(name) = map.next_key::<String>()? {
            if name == "schema" {
                *self.0 = map.next_value::<String>()?.starts_with(SURVEYS);
                return Ok(());
            }
            map.next_value::<IgnoredAny>()?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_survey_is_known_by_its_first_schema() {
        for (text, expected) in [
            (r#"{"schema": "couplet.survey-certificate/1"}"#, true),
            (r#"{"schema": "couplet.survey-certificate/2"}"#, true),
            (
                "\u{feff}{\"tool\": [{}], \"schema\": \"couplet.survey-certificate\\u002f1\", nothing",
                true,
            ),
            (
                r#"{"schema": "couplet.certificate/1", "schema": "couplet.survey-certificate/1"}"#,
                false,
            ),
            (r#"{"claim": {"schema": "couplet.survey-certificate/1"}}"#, false),
            (r#"["schema", "couplet.survey-certificate/1"]"#, false),
            (r#"{"schema": 1}"#, false),
            ("", false),
        ] {
            assert_eq!(is_survey(text.as_bytes()), expected, "{text}");
        }
        assert!(!is_survey(b"\xff"));
    }
}
