//! Output only: what was found, written in a format, be it a table, JSON, CSV, LaTeX or another language. Nothing is
//! computed here. Pictures of arches, and maps, are made by crates above.
//!
//! A result makes [`Record`]s, and each format of records is written once ([`Reported`]). An [`Answer`] is a landmark
//! or an arch with what became of it and its proved values, which languages write too. [`Format`] is the one list of
//! formats.
//!
//! ```
//! use couplet_prove::prelude::{Arch, Certify};
//! use couplet_report::{Answer, Answers, Format, Reported};
//!
//! let arch = Arch::parse("heyman", "pi/2", "0.38")?;
//! let answer = Answer::state(1, &arch, &arch.certify(12));
//! let report = Answers::arch(12, answer);
//! let format = Format::named(Answers::content(), "python").unwrap();
//! let mut file = Vec::new();
//! report.write(format, &mut file)?;
//! let file = String::from_utf8(file)?;
//! assert!(file.contains("STATE_1_THICKNESS_DECIMAL = Decimal(\"0.122191586363\")"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! See also [`certify`], which finds what is written here, and
//! `scene`, which writes many reports at once.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod answer;
mod answered;
mod answers;
pub mod assembled;
mod audit;
mod by_value;
mod c;
mod claimed;
mod column;
mod columns;
mod complementarity;
mod csv;
mod document;
mod equation;
mod find;
mod format;
mod fortran;
mod given;
mod jointed;
mod json;
pub mod judged;
mod julia;
mod kept;
mod latex;
mod listing;
mod matlab;
mod names;
pub mod numbers;
mod paper;
#[cfg_attr(not(feature = "parquet"), path = "parquet_missing.rs")]
mod parquet;
#[cfg(feature = "parquet")]
mod parquet_file;
mod plain;
mod programme;
mod python;
mod record;
mod reported;
mod rows;
mod rust;
mod sampled;
mod sizes;
#[cfg(feature = "study")]
pub mod study;
mod subject;
mod survey;
mod surveyed_cells;
mod surveyed_rows;
mod table;
mod tabular;
mod tilt;
mod tilt_record;
mod toml;
mod understood;
mod value;
mod value_row;
mod voussoirs;
pub mod words;

pub use answer::{Answer, Extent, Fingerprint, Proof, Status};
pub use answered::open_rows;
pub use answers::{Answers, Scope, TOOL};
pub use audit::Audit;
pub use by_value::ByValue;
pub use claimed::{Claims, Index};
pub use column::{Column, NamedColumn};
pub use columns::Beside;
pub use complementarity::{ComplementarityArch, SolutionsFound};
pub use equation::EvaluatedEquation;
pub use format::{Content, Format};
pub use given::GivenDoubles;
pub use kept::Kept;
pub use parquet::parquet_rows;
#[cfg(feature = "parquet")]
pub use parquet_file::{ParquetColumn, ParquetFile, ParquetTable, Texts};
pub use programme::{AtThickness, ProgrammeFound};
pub use record::{Record, Symbol};
pub use reported::Reported;
pub use rows::Rows;
pub use sampled::{sampled_header, sampled_row};
pub use sizes::Sizes;
pub use subject::Subject;
pub use survey::{MEANING, MeasureAlone, SurveyedArches};
pub use surveyed_cells::SurveyedCells;
pub use surveyed_rows::{SurveyedCell, SurveyedRow, SurveyedRows};
pub use tabular::Tabular;
pub use tilt::{JointAtLimit, TiltedArch};
pub use understood::Understood;
pub use value::Value;
pub use voussoirs::{GivenThickness, VoussoirArch, VoussoirArches};

use couplet_ask as ask;
use couplet_check::{arch, problem};
use couplet_claims as claims;
use couplet_draw::picture;
use couplet_judge::{judge, strategies};
use couplet_number::number;
use couplet_prove::certify;
