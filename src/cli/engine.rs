//! The arithmetics that check a certificate, those that are built in.

#[cfg(feature = "malachite")]
use crate::check::MALACHITE_DIGITS;
#[cfg(feature = "mpfr")]
use crate::check::MAX_DIGITS;
#[cfg(any(feature = "malachite", feature = "mpfr"))]
use crate::check::check;
use crate::check::{Accepted, Refusal, verify};

/// An arithmetic that checks a certificate.
///
/// ```
/// use couplet::cli::Engine;
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
    #[cfg(feature = "mpfr")]
    Mpfr,
}

const BUILT_IN: &str = match (cfg!(feature = "malachite"), cfg!(feature = "mpfr")) {
    (false, false) => "astro",
    (false, true) => "astro, mpfr",
    (true, false) => "astro, malachite",
    (true, true) => "astro, malachite, mpfr",
};

impl Engine {
    /// The arithmetic of a name; else a sentence that says which are built in.
    pub fn named(name: &str) -> Result<Self, String> {
        match name {
            "astro" => Ok(Self::Astro),
            #[cfg(feature = "malachite")]
            "malachite" => Ok(Self::Malachite),
            #[cfg(feature = "mpfr")]
            "mpfr" => Ok(Self::Mpfr),
            _ if ["malachite", "mpfr"].contains(&name) => {
                Err(format!("{name} is not built in; here are {BUILT_IN}"))
            }
            _ => Err(format!("an arithmetic is one of {BUILT_IN}")),
        }
    }

    /// Checks the bytes of a certificate: that the equations have the root claimed, and that every digit is right.
    pub fn check(self, bytes: &[u8]) -> Result<Accepted, Refusal> {
        match self {
            Self::Astro => verify(bytes),
            #[cfg(feature = "malachite")]
            Self::Malachite => check::<crate::number::MalachiteInterval>(bytes, MALACHITE_DIGITS),
            #[cfg(feature = "mpfr")]
            Self::Mpfr => check::<crate::number::Ball>(bytes, MAX_DIGITS),
        }
    }

    /// What has to be known of an acceptance by this arithmetic.
    pub(super) fn remark(self) -> &'static str {
        match self {
            #[cfg(feature = "malachite")]
            Self::Malachite => "  (by malachite, which is no witness beside mpfr)",
            _ => "",
        }
    }
}
