//! The hash of a landmark's certificate: what ties a number that was handed on to a proof of it.

use super::certificate::landmark_certificate;
use super::landmark::CertifiedLandmark;
use crate::prover::{Error, Refused, Undecided};
use sha2::{Digest, Sha256};

/// The largest number of digits for which a hash is made: a certificate costs several times as much as
/// the digits themselves.
pub const MAX_FINGERPRINT_DIGITS: usize = 10_000;

/// SHA-256, in hexadecimal, of the file that `couplet certify` writes for a landmark with `digits`
/// digits.
///
/// `couplet certify T --weight heyman --digits 30 | sha256sum` prints the same. An error says why there
/// is none; beyond [`MAX_FINGERPRINT_DIGITS`] it is refused at once.
pub fn fingerprint(point: &CertifiedLandmark, digits: usize) -> Result<String, Error> {
    Refused::digits_to(digits, MAX_FINGERPRINT_DIGITS)?;
    let mut file = Vec::new();
    landmark_certificate(point, digits)?
        .write(&mut file)
        .map_err(|error| Undecided::new(format!("the certificate cannot be written: {error}")))?;
    Ok(Sha256::digest(&file).iter().map(|byte| format!("{byte:02x}")).collect())
}
