//! The one list of formats: commands, scenes, help and errors read it. A format is a file and a row here.

use super::answers::Answers;
use super::audit::{self, Audit};
use super::branch::{self, BranchArches};
use super::claims::{self, Claims, Index};
use super::complementarity::{self, ComplementarityArches};
use super::judged::{self, JudgeSummary, JudgedLines};
use super::map::{self, Map, MapDifferences, MapPoints};
#[cfg(feature = "parquet")]
use super::parquet;
use super::rows::Rows;
use super::sampled::{self, SampledLines};
use super::sketched::{self, Sketched};
use super::tilt::{self, TiltedArches};
use super::voussoirs::{self, VoussoirArches};
use super::words::{distinct, list};
use super::{c, csv, fortran, json, julia, latex, matlab, plain, python, rust, table, toml};
use std::io;

/// Content that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Landmarks or arches.
    Answers,
    /// Arches as they come.
    Rows,
    /// Printed numbers against certified values.
    Audit,
    /// Claims of the paper.
    Claims,
    /// The paper, place by place.
    Index,
    /// Other people's results: all of them in summary, or each as it comes.
    Judged,
    /// Arches that were drawn.
    Samples,
    /// Curves of the map.
    Map,
    /// A figure of the paper.
    Figure,
    /// A point of a curve of the map.
    MapPoint,
    /// Difference between two weights of the lines of the map.
    MapDifference,
    /// Arches of voussoirs.
    Voussoirs,
    /// Arches under a horizontal acceleration.
    Tilted,
    /// Solutions of the complementarity problem.
    Complementarity,
    /// Asymmetric solutions over friction.
    Branch,
    /// Arches to be drawn.
    Drawing,
}

/// Opens a file of arches that come one after the other.
type Opener = fn(Answers) -> io::Result<Box<dyn Rows>>;

/// What writes something in each format that it has.
pub(super) struct Writers<W: 'static>(&'static [(&'static str, W)]);

/// Writers of all at once.
type AtOnce<T> = Writers<fn(&T, &mut dyn io::Write) -> io::Result<()>>;

impl<W: Copy> Writers<W> {
    fn of(&self, format: &Format) -> Option<W> {
        self.0.iter().find(|(name, _)| *name == format.name).map(|(_, writer)| *writer)
    }
}

impl<T> AtOnce<T> {
    /// Writes it. A format that cannot write it is an error.
    pub(super) fn write(&self, it: &T, format: &Format, out: &mut dyn io::Write) -> io::Result<()> {
        self.of(format).map_or_else(unsupported, |write| write(it, out))
    }
}

pub(super) const ANSWERS: AtOnce<Answers> = Writers(&[
    ("table", table::answers),
    ("plain", plain::answers),
    ("json", json::answers),
    ("csv", csv::answers),
    ("toml", toml::answers),
    ("latex", latex::answers),
    ("c", c::answers),
    ("rust", rust::answers),
    ("python", python::answers),
    ("julia", julia::answers),
    ("matlab", matlab::answers),
    ("fortran", fortran::answers),
    ("parquet", parquet::answers),
]);
const ROWS: Writers<Opener> =
    Writers(&[("csv", csv::rows), ("jsonl", json::lines), ("parquet", parquet::rows)]);
pub(super) const AUDIT: AtOnce<Audit> =
    Writers(&[("table", audit::table), ("json", audit::json), ("csv", audit::csv)]);
pub(super) const CLAIMS: AtOnce<Claims> =
    Writers(&[("text", claims::text), ("json", claims::json), ("latex", claims::latex)]);
pub(super) const INDEX: AtOnce<Index> =
    Writers(&[("text", claims::index_text), ("json", claims::index_json)]);
const JUDGED: AtOnce<JudgeSummary> = Writers(&[("table", judged::table), ("json", judged::json)]);
const JUDGED_LINES: Writers<JudgedLines> =
    Writers(&[("csv", judged::CSV), ("jsonl", judged::JSON_LINES)]);
const SAMPLES: Writers<SampledLines> =
    Writers(&[("csv", sampled::CSV), ("jsonl", sampled::JSON_LINES)]);
pub(super) const MAP: AtOnce<Map> = Writers(&[
    ("table", map::table),
    ("json", map::json),
    ("csv", map::csv),
    ("parquet", parquet::map),
    ("svg", svg),
    ("html", map::html),
    ("png", png),
]);
pub(super) const MAP_POINTS: AtOnce<MapPoints> =
    Writers(&[("table", map::point_table), ("json", map::point_json), ("csv", map::point_csv)]);
pub(super) const MAP_DIFFERENCES: AtOnce<MapDifferences> = Writers(&[
    ("table", map::difference_table),
    ("json", map::difference_json),
    ("csv", map::difference_csv),
    ("svg", svg),
    ("png", png),
]);
pub(super) const VOUSSOIRS: AtOnce<VoussoirArches> = Writers(&[
    ("table", voussoirs::table),
    ("json", voussoirs::json),
    ("csv", voussoirs::csv),
    ("svg", svg),
    ("png", png),
]);
pub(super) const TILTED: AtOnce<TiltedArches> =
    Writers(&[("table", tilt::table), ("json", tilt::json), ("csv", tilt::csv)]);
pub(super) const COMPLEMENTARITY: AtOnce<ComplementarityArches> = Writers(&[
    ("table", complementarity::table),
    ("json", complementarity::json),
    ("csv", complementarity::csv),
]);
pub(super) const BRANCH: AtOnce<BranchArches> = Writers(&[
    ("table", branch::table),
    ("json", branch::json),
    ("csv", branch::csv),
    ("svg", svg),
    ("png", png),
]);
pub(super) const DRAWING: AtOnce<Sketched> =
    Writers(&[("json", sketched::json), ("svg", svg), ("png", png), ("dxf", sketched::dxf)]);

impl Content {
    /// Tells whether it can be written in a format.
    pub fn is_written_as(self, format: &Format) -> bool {
        match self {
            Self::Answers => ANSWERS.of(format).is_some(),
            Self::Rows => format.rows().is_some(),
            Self::Audit => AUDIT.of(format).is_some(),
            Self::Claims => CLAIMS.of(format).is_some(),
            Self::Index => INDEX.of(format).is_some(),
            Self::Judged => format.judged().is_some() || format.judged_lines().is_some(),
            Self::Samples => format.samples().is_some(),
            Self::Map => MAP.of(format).is_some(),
            Self::Figure => format.is_picture,
            Self::MapPoint => MAP_POINTS.of(format).is_some(),
            Self::MapDifference => MAP_DIFFERENCES.of(format).is_some(),
            Self::Voussoirs => VOUSSOIRS.of(format).is_some(),
            Self::Tilted => TILTED.of(format).is_some(),
            Self::Complementarity => COMPLEMENTARITY.of(format).is_some(),
            Self::Branch => BRANCH.of(format).is_some(),
            Self::Drawing => DRAWING.of(format).is_some(),
        }
    }
}

/// Content that can be drawn.
pub(super) trait Pictured {
    /// The picture as SVG.
    fn picture(&self) -> io::Result<String>;
}

fn svg(of: &impl Pictured, out: &mut dyn io::Write) -> io::Result<()> {
    out.write_all(of.picture()?.as_bytes())
}

#[cfg(feature = "plots")]
fn png(of: &impl Pictured, out: &mut dyn io::Write) -> io::Result<()> {
    out.write_all(&crate::picture::png::render(&of.picture()?))
}

#[cfg(not(feature = "plots"))]
fn png<T>(_: &T, _: &mut dyn io::Write) -> io::Result<()> {
    unsupported()
}

/// Stand-ins of a format that is not built in.
#[cfg(not(feature = "parquet"))]
mod parquet {
    use super::{Answers, Rows, io, unsupported};

    pub(super) fn answers<T>(_: &T, _: &mut dyn io::Write) -> io::Result<()> {
        unsupported()
    }

    pub(super) use answers as map;

    pub(super) fn rows(_: Answers) -> io::Result<Box<dyn Rows>> {
        unsupported()
    }
}

fn unsupported<T>() -> io::Result<T> {
    Err(io::ErrorKind::Unsupported.into())
}

/// A format.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// Name of the format on the command line and in scenes.
    pub name: &'static str,
    /// Ending of the names of its files.
    pub extension: &'static str,
    /// True if the format is not text.
    pub is_binary: bool,
    /// True if the format is a picture, and nothing beside.
    pub is_picture: bool,
    /// True if the format has, of arches, the error of each double, or quadruples: of both more is known with
    /// more bits.
    pub has_errors: bool,
    /// True if the format names the certificate of each landmark by its hash.
    pub has_certificates: bool,
    /// The feature without which it is not built in, where that is missing.
    missing: Option<&'static str>,
}

const fn text(name: &'static str, extension: &'static str) -> Format {
    Format {
        name,
        extension,
        is_binary: false,
        is_picture: false,
        has_errors: false,
        has_certificates: false,
        missing: None,
    }
}

/// A language of another program.
const fn language(name: &'static str, extension: &'static str) -> Format {
    Format { has_errors: true, has_certificates: true, ..text(name, extension) }
}

static FORMATS: [Format; 19] = [
    text("table", "txt"),
    text("text", "txt"),
    text("plain", "txt"),
    Format { has_certificates: true, ..text("json", "json") },
    text("csv", "csv"),
    text("jsonl", "jsonl"),
    language("toml", "toml"),
    Format { has_certificates: true, ..text("latex", "tex") },
    language("c", "h"),
    language("rust", "rs"),
    language("python", "py"),
    language("julia", "jl"),
    language("matlab", "m"),
    language("fortran", "f90"),
    Format {
        is_binary: true,
        missing: if cfg!(feature = "parquet") { None } else { Some("parquet") },
        ..language("parquet", "parquet")
    },
    Format { is_picture: true, ..text("svg", "svg") },
    text("html", "html"),
    Format {
        is_binary: true,
        is_picture: true,
        missing: if cfg!(feature = "plots") { None } else { Some("plots") },
        ..text("png", "png")
    },
    text("dxf", "dxf"),
];

impl Format {
    /// The formats in which something can be written, the usual one first.
    pub fn all(content: Content) -> impl Iterator<Item = &'static Self> {
        FORMATS.iter().filter(move |format| content.is_written_as(format))
    }

    /// Writer of rows one after another.
    pub fn rows(&self) -> Option<Opener> {
        ROWS.of(self)
    }

    /// Writer of the summary of judged rows.
    pub fn judged(&self) -> Option<fn(&JudgeSummary, &mut dyn io::Write) -> io::Result<()>> {
        JUDGED.of(self)
    }

    /// Writer of judged rows, one by one.
    pub fn judged_lines(&self) -> Option<JudgedLines> {
        JUDGED_LINES.of(self)
    }

    /// Writer of arches drawn from a seed, one by one.
    pub fn samples(&self) -> Option<SampledLines> {
        SAMPLES.of(self)
    }

    /// Names of the formats in a sentence.
    pub fn names(content: Content) -> String {
        list(Self::all(content).map(|format| format.name))
    }

    /// Endings of the names of their files: `.txt, .json or .csv`.
    pub fn extensions(content: Content) -> String {
        let ends = distinct(Self::all(content).map(|format| format!(".{}", format.extension)));
        match ends.split_last() {
            Some((last, others)) if !others.is_empty() => {
                format!("{} or {last}", list(others.iter().map(String::as_str)))
            }
            _ => ends.concat(),
        }
    }

    /// The format of a name, or of what the name of a file ends with, whatever the case.
    pub fn named(content: Content, name: &str) -> Option<&'static Self> {
        let named = Self::all(content).find(|format| format.name.eq_ignore_ascii_case(name));
        named.or_else(|| Self::of_extension(content, name))
    }

    /// The format that the end of a file's name tells.
    pub fn of_extension(content: Content, extension: &str) -> Option<&'static Self> {
        Self::all(content).find(|format| format.extension.eq_ignore_ascii_case(extension))
    }

    /// Tells whether the format is a page that holds the whole map.
    pub fn is_page(&self) -> bool {
        self.name == "html"
    }

    /// Reason why the format cannot be used, if it is not built in.
    pub fn missing(&self) -> Option<String> {
        let feature = self.missing?;
        Some(format!(
            "this couplet was built without the feature {feature} (cargo install --path . --features {feature})"
        ))
    }
}
