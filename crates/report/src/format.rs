//! The one list of formats: commands, scenes, help and errors read it.

use super::words::{distinct, list};
use crate::certify::MAX_DIGITS;
use crate::certify::state::Balls;

/// Digits beyond those that are printed, where what is printed is computed from what is proved.
const GUARD_DIGITS: usize = 16;

/// Names of the formats in which something is written, in the order of the list of formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Content(pub &'static [&'static str]);

impl Content {
    /// Arches as they come.
    pub const ROWS: Self = Self(&["csv", "csv2", "jsonl", "parquet", "latex", "markdown"]);
    /// Other people's results: all of them in summary, or each as it comes.
    pub const JUDGED: Self = Self(&["table", "json", "csv", "jsonl"]);
    /// Arches that were drawn from a seed.
    pub const SAMPLES: Self = Self(&["csv", "jsonl"]);
    /// Assemblies of stones: with their answers, or the bodies alone, a file each in a folder.
    pub const ASSEMBLIES: Self = Self(&["json", "csv", "obj", "dxf"]);
    /// Arches and assemblies drawn from a seed.
    pub const DRAWN: Self = Self(&["csv", "jsonl", "json", "obj", "dxf"]);
    /// Ranges as they come.
    pub const RANGES: Self = Self(&["csv", "jsonl"]);
    /// A picture, and nothing beside.
    pub const FIGURE: Self = Self(&["svg", "png", "pdf"]);
    /// Records with rows.
    pub const RECORDS: Self = Self(&["table", "json", "csv", "csv2", "latex", "markdown"]);
    /// Records with rows and a picture.
    pub const DRAWN_RECORDS: Self =
        Self(&["table", "json", "csv", "csv2", "latex", "markdown", "svg", "png", "pdf"]);

    /// Tells whether it can be written in a format.
    pub fn is_written_as(self, format: &Format) -> bool {
        self.0.contains(&format.name)
    }
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

static FORMATS: [Format; 23] = [
    text("table", "txt"),
    text("text", "txt"),
    text("plain", "txt"),
    Format { has_certificates: true, ..text("json", "json") },
    text("csv", "csv"),
    text("csv2", "csv"),
    text("jsonl", "jsonl"),
    language("toml", "toml"),
    Format { has_certificates: true, ..text("latex", "tex") },
    text("markdown", "md"),
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
    text("obj", "obj"),
];

impl Format {
    /// The formats in which something can be written, the usual one first.
    pub fn all(content: Content) -> impl Iterator<Item = &'static Self> {
        FORMATS.iter().filter(move |format| content.is_written_as(format))
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
        let by = |text: fn(&Self) -> &str| {
            Self::all(content).find(|format| text(format).eq_ignore_ascii_case(name))
        };
        by(|format| format.name).or_else(|| by(|format| format.extension))
    }

    /// Tells whether the format is a table of a paper.
    fn is_for_paper(&self) -> bool {
        matches!(self.name, "latex" | "markdown")
    }

    /// Tells whether a person reads the format, and no program.
    pub fn is_for_people(&self) -> bool {
        self.name == "table" || self.is_for_paper()
    }

    /// Digits to which arches are proved for the format: a table for a paper turns angles into degrees and takes
    /// differences, and rounds these once.
    pub fn proved_digits(&self, digits: usize) -> usize {
        if self.is_for_paper() { MAX_DIGITS.min(digits + GUARD_DIGITS) } else { digits }
    }

    /// Balls that arches are asked of for the format.
    pub fn balls(&self) -> Balls {
        if self.has_errors { Balls::Mpfr } else { Balls::DoubleDoubles }
    }

    /// Tells whether the format is a drawing, and nothing beside.
    pub fn is_drawing(&self) -> bool {
        self.is_picture || self.name == "dxf"
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
