//! The certificate as a file: JSON, `couplet.certificate/1`, described in `docs/certificate.md`.

use super::claim::ClaimFile;
use super::record::record;
use super::refusal::Refusal;
use super::visible::{beginning, shortened};
use crate::number::Dyadic;
use serde::de::DeserializeOwned;
use std::io;

/// The schema of this version.
pub const SCHEMA: &str = "couplet.certificate/1";

record! {
    /// A certificate: a claim about a root, and the witnesses that let a checker prove it.
    pub struct Certificate {
        /// [`SCHEMA`].
        pub schema: String,
        /// Tool that made it, with the version; not checked.
        pub tool: String,
        /// Claim of the certificate.
        pub claim: ClaimFile,
        /// Number of significant digits of the values.
        pub digits: usize,
        /// The witness of existence and uniqueness in a large box.
        pub unique: Witness,
        /// An approximate inverse of the Jacobian at the centre of that box, row by row.
        pub inverse: Vec<Vec<Dyadic>>,
        /// A small box that holds the root.
        pub root: Witness,
        /// The decimal values claimed.
        pub values: Vec<ValueFile>,
    }
}

impl Certificate {
    /// Writes the file, whose bytes depend on the certificate only.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut *out, self)?;
        writeln!(out)
    }
}

record! {
    /// A box: all points within `radius` of `centre`, unknown by unknown.
    pub struct Witness {
        /// The centre.
        pub centre: Vec<Dyadic>,
        /// The radii.
        pub radius: Vec<Dyadic>,
    }
}

record! {
    /// A decimal value.
    pub struct ValueFile {
        /// The name of the quantity.
        pub quantity: String,
        /// The correct rounding, or `inf`.
        pub value: String,
    }
}

impl Certificate {
    /// Reads a file, with or without a byte order mark. A file that is not such a certificate is refused with
    /// the place and the cause.
    pub fn read(bytes: &[u8]) -> Result<Self, Refusal> {
        let certificate: Self = read_json(bytes)?;
        certificate.of_this_schema()?;
        Ok(certificate)
    }

    /// Checks that the certificate is one of this version.
    pub(super) fn of_this_schema(&self) -> Result<(), Refusal> {
        match self.schema == SCHEMA {
            true => Ok(()),
            false => Err(Refusal::Schema(shortened(&self.schema))),
        }
    }
}

/// Record of a file, with or without a byte order mark.
pub(super) fn read_json<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, Refusal> {
    let text = str::from_utf8(bytes).map_err(|error| Refusal::Encoding(error.valid_up_to()))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    serde_json::from_str(text).map_err(|error| Refusal::Format(reason(&error)))
}

/// Reason why a text is not a certificate. The reason may quote the text, which may be long and hold anything.
fn reason(error: &serde_json::Error) -> String {
    let words = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    match words.strip_suffix(&place) {
        Some(words) => beginning(words, 160) + &place,
        None => beginning(&words, 160),
    }
}
