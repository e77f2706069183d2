//! The door: the pages that a newcomer reads, and what the program gives to a shell and a manual.

mod architecture;
mod columns;
mod limits;
mod manual;
mod named;
mod pages;
mod pictures;
mod published;
mod questions;
