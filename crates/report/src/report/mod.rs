//! Output only: what was found, written in a format.
//!
//! An [`Answer`] is a landmark or an arch with what became of it and its proved values: all that a format
//! sees. [`Format`] is the one list of formats, one file each.
//!
//! ```
//! use couplet_prove::prelude::{Arch, Certify};
//! use couplet_report::report::{Answer, Answers, Content, Format, Report};
//!
//! let arch = Arch::parse("heyman", "pi/2", "0.38")?;
//! let answer = Answer::state(1, &arch, &arch.certify(12));
//! let report = Report::Answers(Answers::arch(12, answer));
//! let format = Format::named(Content::Answers, "python").unwrap();
//! let mut file = Vec::new();
//! report.write(format, &mut file)?;
//! let file = String::from_utf8(file)?;
//! assert!(file.contains("STATE_1_THICKNESS_DECIMAL = Decimal(\"0.122191586363\")"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! See also [`certify`](crate::certify), which finds what is written here, and
//! `scene`, which writes many reports at once.

mod answer;
mod answers;
mod audit;
mod branch;
mod by_value;
mod c;
mod claims;
mod column;
mod columns;
mod complementarity;
mod csv;
mod document;
mod drawn;
mod equation;
mod fields;
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
mod map;
mod map_asked;
mod matlab;
mod names;
#[cfg(feature = "parquet")]
mod parquet;
mod plain;
mod programme;
mod python;
mod rows;
mod rust;
mod sampled;
mod sketched;
#[cfg(feature = "study")]
pub mod study;
mod subject;
mod table;
mod tilt;
mod toml;
mod understood;
mod value;
mod voussoirs;
pub mod words;

pub use answer::{Answer, Fingerprint, Proof, Status};
pub use answers::{Answers, Scope};
pub use audit::Audit;
pub use branch::{BranchArch, BranchArches};
pub use by_value::ByValue;
pub use claims::{Claims, Index};
pub use complementarity::ComplementarityArch;
pub use drawn::{Axes, Branches, Drawing, Mark, Marked, Plane, Shown, Unit, View};
pub use equation::{EquationFound, EvaluatedEquation};
pub use format::{Content, Format};
pub use given::GivenDoubles;
pub use json::answers as write_json;
pub use kept::Kept;
pub use map::{Map, MapDifferences, MapPoint};
pub use map_asked::MapAsked;
pub use programme::{AtThickness, ProgrammeFound};
pub use rows::Rows;
pub use sketched::{Sketched, Style, arches_of_figure};
pub use subject::Subject;
pub use tilt::TiltedArch;
pub use understood::Understood;
pub use value::Value;
pub use voussoirs::{GivenThickness, VoussoirArch, VoussoirArches};

use crate::picture::Print;
use std::io;

/// Everything that can be written at once.
#[derive(Debug)]
pub enum Report {
    /// Landmarks or arches.
    Answers(Answers),
    /// Printed numbers against certified values.
    Audit(Audit),
    /// Claims of the paper.
    Claims(Claims),
    /// The paper, place by place.
    Index(Index),
    /// Curves of the map.
    Map(Map),
    /// A point of a curve of the map, for each weight.
    MapPoints(Vec<MapPoint>),
    /// Difference between two weights of the lines of the map.
    MapDifferences(MapDifferences),
    /// Arches of voussoirs.
    Voussoirs(VoussoirArches),
    /// Arches under a horizontal acceleration.
    Tilted(Vec<TiltedArch>),
    /// Solutions of the complementarity problem.
    Complementarity(Vec<ComplementarityArch>),
    /// States by another quantity than the half opening.
    ByValue(Vec<ByValue>),
    /// Equations of the paper.
    Equations(Vec<EvaluatedEquation>),
    /// Asymmetric solutions over friction.
    Branches(BranchArches),
    /// Arches to be drawn.
    Sketched(Sketched),
}

impl Report {
    /// Writes the report. A format that cannot write it is an error.
    pub fn write(&self, format: &Format, out: &mut dyn io::Write) -> io::Result<()> {
        self.printed((format, &Print::default()), out)
    }

    /// Writes the report; a picture is printed as asked for, and an invalid input if it cannot be.
    pub fn printed(&self, how: (&Format, &Print), out: &mut dyn io::Write) -> io::Result<()> {
        match self {
            Self::Answers(answers) => format::ANSWERS.write(answers, how, out),
            Self::Audit(audit) => format::AUDIT.write(audit, how, out),
            Self::Claims(claims) => format::CLAIMS.write(claims, how, out),
            Self::Index(index) => format::INDEX.write(index, how, out),
            Self::Map(map) => format::MAP.write(map, how, out),
            Self::MapPoints(points) => format::MAP_POINTS.write(points, how, out),
            Self::MapDifferences(all) => format::MAP_DIFFERENCES.write(all, how, out),
            Self::Tilted(arches) => format::TILTED.write(arches, how, out),
            Self::Voussoirs(arches) => format::VOUSSOIRS.write(arches, how, out),
            Self::Complementarity(arches) => format::COMPLEMENTARITY.write(arches, how, out),
            Self::ByValue(all) => format::BY_VALUE.write(all, how, out),
            Self::Equations(all) => format::EQUATION.write(all, how, out),
            Self::Branches(arches) => format::BRANCH.write(arches, how, out),
            Self::Sketched(sketched) => format::DRAWING.write(sketched, how, out),
        }
    }
}
