//! The arithmetics that check a certificate, those that are built in.

use super::accepted_file::{AcceptedFile, verify_file};
use super::refusal::Refusal;

/// An arithmetic that checks a certificate.
///
/// ```
/// use couplet_check::check::Engine;
/// assert!(Engine::named("astro", &[])?.check(b"{}").is_err());
/// assert!(Engine::named("gmp", &[]).is_err());
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Engine {
    name: &'static str,
    check: fn(&[u8]) -> Result<AcceptedFile, Refusal>,
}

impl Engine {
    /// Pure Rust, shares nothing with MPFR.
    pub const ASTRO: Self = Self::new("astro", verify_file);

    /// An arithmetic that a program brings along, of which nothing has to be known.
    pub const fn new(
        name: &'static str,
        check: fn(&[u8]) -> Result<AcceptedFile, Refusal>,
    ) -> Self {
        Self { name, check }
    }

    /// The arithmetic of a name, of those here and of `others`; else a sentence that says which are built in.
    pub fn named(name: &str, others: &[Self]) -> Result<Self, String> {
        let all = [&[Self::ASTRO], others].concat();
        if let Some(engine) = all.iter().find(|engine| engine.name == name) {
            return Ok(*engine);
        }
        let names = all.iter().map(|engine| engine.name).collect::<Vec<_>>().join(", ");
        Err(match name {
            "mpfr" => format!("{name} is not built in; here are {names}"),
            _ => format!("an arithmetic is one of {names}"),
        })
    }

    /// Checks the bytes of a certificate of either kind: that the equations have the root claimed, and that every digit
    /// is right; of a survey, that its verdict follows from such certificates.
    pub fn check(self, bytes: &[u8]) -> Result<AcceptedFile, Refusal> {
        (self.check)(bytes)
    }
}
