//! Checks: the operator behind every proof, and what a stranger needs to verify a result.
//!
//! This room sees the number traits and the equations, never a solver, and builds without a C compiler. The program
//! `couplet-check` is its command.

mod accepted_file;
mod checker;
mod claim;
mod decimals;
mod engine;
mod files;
mod format;
mod given;
pub mod krawczyk;
mod record;
mod refusal;
mod statement;
mod summary;
mod survey_checker;
mod survey_cover;
mod survey_file;
mod survey_refusal;
mod survey_summary;
mod visible;
pub mod whole;

pub use crate::number::visible;
pub use accepted_file::{AcceptedFile, check_file, verify_file};
pub use checker::{
    ASTRO_DIGITS, Accepted, EXTRA_BITS, MAX_DIGITS, WITNESS_BITS, check, check_certificate, verify,
};
pub use claim::{ArchFile, AsymmetricFile, ClaimFile, StandsFile, StateFile, TooThinFile};
pub use engine::Engine;
pub use files::{CheckFailure, Words, check_files, print, read, reason};
pub use format::{Certificate, SCHEMA, ValueFile, Witness};
pub use refusal::Refusal;
pub use summary::summary;
pub use survey_checker::{AcceptedSurvey, check_survey};
pub use survey_file::{
    FreeFile, MAX_LENGTH_DIGITS, MAX_PARTS, PartFile, Parts, SURVEY_SCHEMA, SpannedFile, StepFile,
    SurveyCertificate, SurveyFile,
};
pub use survey_refusal::SurveyRefusal;
pub use visible::visible_name;
