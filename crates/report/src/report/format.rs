//! The one list of formats: commands, scenes, help and errors read it. A format is a file and a row here.

use super::answers::Answers;
use super::audit::{self, Audit};
use super::branch::{self, BranchArches};
use super::by_value::{self, ByValue};
use super::claims::{self, Claims, Index};
use super::complementarity::{self, ComplementarityArch};
use super::equation::{self, EvaluatedEquation};
use super::judged::{self, JudgeSummary, JudgedLines};
use super::map::{self, Map, MapDifferences, MapPoint};
#[cfg(feature = "parquet")]
use super::parquet;
use super::rows::Rows;
use super::sampled::{self, SampledLines};
use super::sketched::{self, Sketched};
use super::tilt::{self, TiltedArch};
use super::voussoirs::{self, VoussoirArches};
use super::words::{distinct, list};
use super::{c, csv, drawn, fortran, json, julia, latex, matlab, plain, python, rust, table, toml};
use crate::picture::Print;
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
    /// States by another quantity than the half opening.
    ByValue,
    /// Equations of the paper.
    Equation,
    /// Asymmetric solutions over friction.
    Branch,
    /// Arches to be drawn.
    Drawing,
}

/// Writes all at once.
type Writer<T> = fn(&T, &mut dyn io::Write) -> io::Result<()>;

/// Opens a file of arches that come one after the other.
type Opener = fn(Answers) -> io::Result<Box<dyn Rows>>;

/// Writers by the names of formats.
type Named<W> = &'static [(&'static str, W)];

/// Writers of something at once, one for each format that it has.
pub(super) struct Writers<T: ?Sized + 'static> {
    texts: Named<Writer<T>>,
    /// The picture as SVG, of what can be drawn.
    picture: Option<fn(&T, &Print) -> io::Result<String>>,
}

impl<T: ?Sized> Writers<T> {
    fn has(&self, format: &Format) -> bool {
        if format.is_picture { self.picture.is_some() } else { format.of(self.texts).is_some() }
    }

    /// Writes it, a picture as it is printed. A format that cannot write it is an error.
    pub(super) fn write(
        &self,
        it: &T,
        (format, print): (&Format, &Print),
        out: &mut dyn io::Write,
    ) -> io::Result<()> {
        match (self.picture, format.of(self.texts)) {
            (Some(picture), _) if format.is_picture => {
                out.write_all(&format.drawn(picture(it, print)?, print)?)
            }
            (_, Some(write)) => write(it, out),
            (_, None) => unsupported(),
        }
    }
}

pub(super) const ANSWERS: Writers<Answers> = Writers {
    texts: &[
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
    ],
    picture: None,
};
const ROWS: Named<Opener> =
    &[("csv", csv::rows), ("jsonl", json::lines), ("parquet", parquet::rows)];
pub(super) const AUDIT: Writers<Audit> = Writers {
    texts: &[("table", audit::table), ("json", audit::json), ("csv", audit::csv)],
    picture: None,
};
pub(super) const CLAIMS: Writers<Claims> = Writers {
    texts: &[("text", claims::text), ("json", claims::json), ("latex", claims::latex)],
    picture: None,
};
pub(super) const INDEX: Writers<Index> =
    Writers { texts: &[("text", claims::index_text), ("json", claims::index_json)], picture: None };
const JUDGED: Named<Writer<JudgeSummary>> = &[("table", judged::table), ("json", judged::json)];
const JUDGED_LINES: Named<JudgedLines> = &[("csv", judged::CSV), ("jsonl", judged::JSON_LINES)];
const SAMPLES: Named<SampledLines> = &[("csv", sampled::CSV), ("jsonl", sampled::JSON_LINES)];
pub(super) const MAP: Writers<Map> = Writers {
    texts: &[
        ("table", map::table),
        ("json", map::json),
        ("csv", map::csv),
        ("parquet", parquet::map),
        ("html", map::html),
    ],
    picture: Some(|map, print| map.drawing.svg((&map.traces, &map.levels, &map.borders), print)),
};
pub(super) const MAP_POINTS: Writers<[MapPoint]> = Writers {
    texts: &[("table", map::point_table), ("json", map::point_json), ("csv", map::point_csv)],
    picture: None,
};
pub(super) const MAP_DIFFERENCES: Writers<MapDifferences> = Writers {
    texts: &[
        ("table", map::difference_table),
        ("json", map::difference_json),
        ("csv", map::difference_csv),
    ],
    picture: Some(|all, print| drawn::differences(&all.differences, &all.command, print)),
};
pub(super) const VOUSSOIRS: Writers<VoussoirArches> = Writers {
    texts: &[("table", voussoirs::table), ("json", voussoirs::json), ("csv", voussoirs::csv)],
    picture: Some(|all, print| voussoirs::figure(all).svg(print)),
};
pub(super) const TILTED: Writers<[TiltedArch]> = Writers {
    texts: &[("table", tilt::table), ("json", tilt::json), ("csv", tilt::csv)],
    picture: None,
};
pub(super) const COMPLEMENTARITY: Writers<[ComplementarityArch]> = Writers {
    texts: &[
        ("table", complementarity::table),
        ("json", complementarity::json),
        ("csv", complementarity::csv),
    ],
    picture: None,
};
pub(super) const BY_VALUE: Writers<[ByValue]> = Writers {
    texts: &[
        ("table", by_value::table),
        ("plain", by_value::plain),
        ("json", by_value::json),
        ("csv", by_value::csv),
    ],
    picture: None,
};
pub(super) const EQUATION: Writers<[EvaluatedEquation]> =
    Writers { texts: &[("table", equation::table), ("json", equation::json)], picture: None };
pub(super) const BRANCH: Writers<BranchArches> = Writers {
    texts: &[("table", branch::table), ("json", branch::json), ("csv", branch::csv)],
    picture: Some(branch::picture),
};
pub(super) const DRAWING: Writers<Sketched> = Writers {
    texts: &[("json", sketched::json), ("dxf", sketched::dxf)],
    picture: Some(sketched::picture),
};

impl Content {
    /// Tells whether it can be written in a format.
    pub fn is_written_as(self, format: &Format) -> bool {
        match self {
            Self::Answers => ANSWERS.has(format),
            Self::Rows => format.rows().is_some(),
            Self::Audit => AUDIT.has(format),
            Self::Claims => CLAIMS.has(format),
            Self::Index => INDEX.has(format),
            Self::Judged => format.judged().is_some() || format.judged_lines().is_some(),
            Self::Samples => format.samples().is_some(),
            Self::Map => MAP.has(format),
            Self::Figure => format.is_picture,
            Self::MapPoint => MAP_POINTS.has(format),
            Self::MapDifference => MAP_DIFFERENCES.has(format),
            Self::Voussoirs => VOUSSOIRS.has(format),
            Self::Tilted => TILTED.has(format),
            Self::Complementarity => COMPLEMENTARITY.has(format),
            Self::ByValue => BY_VALUE.has(format),
            Self::Equation => EQUATION.has(format),
            Self::Branch => BRANCH.has(format),
            Self::Drawing => DRAWING.has(format),
        }
    }
}

/// Renderers of pictures, where they are built in.
#[cfg(feature = "plots")]
use crate::picture::{pdf::render as pdf, png::render as png};

#[cfg(not(feature = "plots"))]
fn png(_: &str, _: &Print) -> io::Result<Vec<u8>> {
    unsupported()
}

#[cfg(not(feature = "plots"))]
use png as pdf;

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

/// A picture that a renderer makes of SVG.
const fn rendered(name: &'static str) -> Format {
    Format {
        is_binary: true,
        is_picture: true,
        missing: if cfg!(feature = "plots") { None } else { Some("plots") },
        ..text(name, name)
    }
}

static FORMATS: [Format; 20] = [
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
    rendered("png"),
    rendered("pdf"),
    text("dxf", "dxf"),
];

impl Format {
    /// The formats in which something can be written, the usual one first.
    pub fn all(content: Content) -> impl Iterator<Item = &'static Self> {
        FORMATS.iter().filter(move |format| content.is_written_as(format))
    }

    fn of<W: Copy>(&self, writers: Named<W>) -> Option<W> {
        writers.iter().find(|(name, _)| *name == self.name).map(|(_, writer)| *writer)
    }

    /// The bytes of a picture that is drawn as SVG.
    pub(super) fn drawn(&self, svg: String, print: &Print) -> io::Result<Vec<u8>> {
        match self.name {
            "png" => png(&svg, print),
            "pdf" => pdf(&svg, print),
            _ => Ok(svg.into_bytes()),
        }
    }

    /// Writer of rows one after another.
    pub fn rows(&self) -> Option<Opener> {
        self.of(ROWS)
    }

    /// Writer of the summary of judged rows.
    pub fn judged(&self) -> Option<Writer<JudgeSummary>> {
        self.of(JUDGED)
    }

    /// Writer of judged rows, one by one.
    pub fn judged_lines(&self) -> Option<JudgedLines> {
        self.of(JUDGED_LINES)
    }

    /// Writer of arches drawn from a seed, one by one.
    pub fn samples(&self) -> Option<SampledLines> {
        self.of(SAMPLES)
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
