//! The one list of formats: commands, scenes, help and errors read it. A format is a file and a row here.

use super::answers::Answers;
use super::audit::{self, Audit};
use super::branch::{self, BranchArches};
use super::claims::{self, Claims, Index};
use super::complementarity::{self, ComplementarityArches};
use super::judged::{self, JudgeSummary, JudgedLines};
use super::map::{self, Map, MapDifferences, MapPoints};
use super::rows::Rows;
use super::sampled::{self, SampledLines};
use super::sketched::{self, Sketched};
use super::tilt::{self, TiltedArches};
use super::voussoirs::{self, VoussoirArches};
use super::words::list;
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

/// Writes all at once.
type Writer<T> = fn(&T, &mut dyn io::Write) -> io::Result<()>;
/// Opens a file of arches that come one after the other.
type Opener = fn(Answers) -> io::Result<Box<dyn Rows>>;

/// A format, and what it can write.
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
    pub(super) answers: Option<Writer<Answers>>,
    /// Writer of rows one after another.
    pub rows: Option<Opener>,
    pub(super) audit: Option<Writer<Audit>>,
    pub(super) claims: Option<Writer<Claims>>,
    pub(super) index: Option<Writer<Index>>,
    /// Writer of the summary of judged rows.
    pub judged: Option<Writer<JudgeSummary>>,
    /// Writer of judged rows, one by one.
    pub judged_lines: Option<JudgedLines>,
    /// Writer of arches drawn from a seed, one by one.
    pub samples: Option<SampledLines>,
    pub(super) map: Option<Writer<Map>>,
    pub(super) map_points: Option<Writer<MapPoints>>,
    pub(super) map_differences: Option<Writer<MapDifferences>>,
    pub(super) voussoirs: Option<Writer<VoussoirArches>>,
    /// Writer of arches under a horizontal acceleration.
    pub tilt: Option<Writer<TiltedArches>>,
    pub(super) complementarity: Option<Writer<ComplementarityArches>>,
    pub(super) branch: Option<Writer<BranchArches>>,
    pub(super) drawing: Option<Writer<Sketched>>,
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
        answers: None,
        rows: None,
        audit: None,
        claims: None,
        index: None,
        judged: None,
        judged_lines: None,
        samples: None,
        map: None,
        map_points: None,
        map_differences: None,
        voussoirs: None,
        tilt: None,
        complementarity: None,
        branch: None,
        drawing: None,
    }
}

/// A language of another program.
const fn language(name: &'static str, extension: &'static str, answers: Writer<Answers>) -> Format {
    Format {
        has_errors: true,
        has_certificates: true,
        answers: Some(answers),
        ..text(name, extension)
    }
}

static FORMATS: [Format; 19] = [
    Format {
        answers: Some(table::answers),
        audit: Some(audit::table),
        judged: Some(judged::table),
        map: Some(map::table),
        map_points: Some(map::point_table),
        map_differences: Some(map::difference_table),
        voussoirs: Some(voussoirs::table),
        tilt: Some(tilt::table),
        complementarity: Some(complementarity::table),
        branch: Some(branch::table),
        ..text("table", "txt")
    },
    Format { claims: Some(claims::text), index: Some(claims::index_text), ..text("text", "txt") },
    Format { answers: Some(plain::answers), ..text("plain", "txt") },
    Format {
        audit: Some(audit::json),
        claims: Some(claims::json),
        index: Some(claims::index_json),
        judged: Some(judged::json),
        map: Some(map::json),
        map_points: Some(map::point_json),
        map_differences: Some(map::difference_json),
        voussoirs: Some(voussoirs::json),
        tilt: Some(tilt::json),
        complementarity: Some(complementarity::json),
        branch: Some(branch::json),
        drawing: Some(sketched::json),
        has_errors: false,
        ..language("json", "json", json::answers)
    },
    Format {
        answers: Some(csv::answers),
        rows: Some(csv::rows),
        audit: Some(audit::csv),
        judged_lines: Some(judged::CSV),
        samples: Some(sampled::CSV),
        map: Some(map::csv),
        map_points: Some(map::point_csv),
        map_differences: Some(map::difference_csv),
        voussoirs: Some(voussoirs::csv),
        tilt: Some(tilt::csv),
        complementarity: Some(complementarity::csv),
        branch: Some(branch::csv),
        ..text("csv", "csv")
    },
    Format {
        rows: Some(json::lines),
        judged_lines: Some(judged::JSON_LINES),
        samples: Some(sampled::JSON_LINES),
        ..text("jsonl", "jsonl")
    },
    language("toml", "toml", toml::answers),
    Format {
        has_errors: false,
        claims: Some(claims::latex),
        ..language("latex", "tex", latex::answers)
    },
    language("c", "h", c::answers),
    language("rust", "rs", rust::answers),
    language("python", "py", python::answers),
    language("julia", "jl", julia::answers),
    language("matlab", "m", matlab::answers),
    language("fortran", "f90", fortran::answers),
    PARQUET,
    Format {
        is_picture: true,
        voussoirs: Some(|all, out| svg(&voussoirs::picture(all), out)),
        map: Some(|map, out| svg(&map::picture(map)?, out)),
        map_differences: Some(|all, out| svg(&map::difference_picture(all), out)),
        branch: Some(|all, out| svg(&branch::picture(all)?, out)),
        drawing: Some(|all, out| svg(&sketched::picture(all), out)),
        ..text("svg", "svg")
    },
    Format { map: Some(map::html), ..text("html", "html") },
    PNG,
    Format { drawing: Some(sketched::dxf), ..text("dxf", "dxf") },
];

#[cfg(feature = "parquet")]
const PARQUET: Format = Format {
    is_binary: true,
    rows: Some(super::parquet::rows),
    map: Some(map::parquet::parquet),
    ..language("parquet", "parquet", super::parquet::answers)
};

/// A stand-in that names the missing feature.
#[cfg(not(feature = "parquet"))]
const PARQUET: Format = Format {
    is_binary: true,
    missing: Some("parquet"),
    rows: Some(|_| Err(io::ErrorKind::Unsupported.into())),
    map: Some(|_, _| Err(io::ErrorKind::Unsupported.into())),
    ..language("parquet", "parquet", |_, _| Err(io::ErrorKind::Unsupported.into()))
};

const PNG: Format = Format {
    is_binary: true,
    is_picture: true,
    missing: if cfg!(feature = "plots") { None } else { Some("plots") },
    voussoirs: Some(|all, out| png(&voussoirs::picture(all), out)),
    map: Some(|map, out| png(&map::picture(map)?, out)),
    map_differences: Some(|all, out| png(&map::difference_picture(all), out)),
    branch: Some(|all, out| png(&branch::picture(all)?, out)),
    drawing: Some(|all, out| png(&sketched::picture(all), out)),
    ..text("png", "png")
};

fn svg(picture: &str, out: &mut dyn io::Write) -> io::Result<()> {
    out.write_all(picture.as_bytes())
}

#[cfg(feature = "plots")]
fn png(picture: &str, out: &mut dyn io::Write) -> io::Result<()> {
    out.write_all(&crate::picture::png::render(picture))
}

#[cfg(not(feature = "plots"))]
fn png(_: &str, _: &mut dyn io::Write) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

impl Format {
    /// The formats in which something can be written, the usual one first.
    pub fn all(content: Content) -> impl Iterator<Item = &'static Self> {
        FORMATS.iter().filter(move |format| match content {
            Content::Answers => format.answers.is_some(),
            Content::Rows => format.rows.is_some(),
            Content::Audit => format.audit.is_some(),
            Content::Claims => format.claims.is_some(),
            Content::Index => format.index.is_some(),
            Content::Judged => format.judged.is_some() || format.judged_lines.is_some(),
            Content::Samples => format.samples.is_some(),
            Content::Map => format.map.is_some(),
            Content::Figure => format.is_picture,
            Content::MapPoint => format.map_points.is_some(),
            Content::MapDifference => format.map_differences.is_some(),
            Content::Voussoirs => format.voussoirs.is_some(),
            Content::Tilted => format.tilt.is_some(),
            Content::Complementarity => format.complementarity.is_some(),
            Content::Branch => format.branch.is_some(),
            Content::Drawing => format.drawing.is_some(),
        })
    }

    /// Names of the formats in a sentence.
    pub fn names(content: Content) -> String {
        list(Self::all(content).map(|format| format.name))
    }

    /// Endings of the names of their files: `.txt, .json or .csv`.
    pub fn extensions(content: Content) -> String {
        let mut ends: Vec<String> = Vec::new();
        for format in Self::all(content) {
            let end = format!(".{}", format.extension);
            if !ends.contains(&end) {
                ends.push(end);
            }
        }
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
