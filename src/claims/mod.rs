//! What is claimed, in a form that others can check.

pub mod coq;
