//! The door: the pages that a newcomer reads, and what the program gives to a shell and a manual.

#[cfg(feature = "study")]
mod architecture;
#[cfg(feature = "mpfr")]
mod columns;
mod manual;
#[cfg(feature = "study")]
mod pages;
#[cfg(feature = "mpfr")]
mod pictures;
