//! The door: the pages that a newcomer reads, and what the program gives to a shell and a manual.

#[cfg(feature = "study")]
mod architecture;
mod manual;
#[cfg(feature = "study")]
mod pages;
