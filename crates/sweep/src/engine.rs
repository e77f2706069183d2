//! The arithmetics that check a certificate, those that are built in.

#[cfg(feature = "malachite")]
use crate::check::MALACHITE_DIGITS;
use crate::check::{Accepted, MAX_DIGITS, Refusal, check, verify};

/// An arithmetic that checks a certificate.
///
/// ```
/// use couplet_sweep::engine::Engine;
/// assert!(Engine::named("astro")?.check(b"{}").is_err());
/// assert!(Engine::named("gmp").is_err());
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// Pure Rust, shares nothing with MPFR.
    Astro,
    /// Pure Rust, quicker; in part MPFR's algorithms.
    #[cfg(feature = "malachite")]
    Malachite,
    /// Balls of MPFR.
    Mpfr,
}

const BUILT_IN: &str =
    if cfg!(feature = "malachite") { "astro, malachite, mpfr" } else { "astro, mpfr" };

impl Engine {
    /// The arithmetic of a name; else a sentence that says which are built in.
    pub fn named(name: &str) -> Result<Self, String> {
        match name {
            "astro" => Ok(Self::Astro),
            #[cfg(feature = "malachite")]
            "malachite" => Ok(Self::Malachite),
            "mpfr" => Ok(Self::Mpfr),
            _ if name == "malachite" => Err(format!("{name} is not built in; here are {BUILT_IN}")),
            _ => Err(format!("an arithmetic is one of {BUILT_IN}")),
        }
    }

    /// Checks the bytes of a certificate: that the equations have the root claimed, and that every digit is right.
    pub fn check(self, bytes: &[u8]) -> Result<Accepted, Refusal> {
        match self {
            Self::Astro => verify(bytes),
            #[cfg(feature = "malachite")]
            Self::Malachite => check::<crate::number::MalachiteInterval>(bytes, MALACHITE_DIGITS),
            Self::Mpfr => check::<crate::number::Ball>(bytes, MAX_DIGITS),
        }
    }

    /// What has to be known of an acceptance by this arithmetic.
    pub fn remark(self) -> &'static str {
        match self {
            #[cfg(feature = "malachite")]
            Self::Malachite => "  (by malachite, which is no witness beside mpfr)",
            _ => "",
        }
    }
}
