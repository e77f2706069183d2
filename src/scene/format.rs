//! The formats of a scene's outputs, by their names and by the ends of file names: the only place that
//! knows them.

use super::schema::Kind;
use crate::report::export::ExportFormat as E;
use crate::report::{ClaimFormat, ConstantsFormat, Format};

/// How an output is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputFormat {
    /// Constants.
    Constants(ConstantsFormat),
    /// Arches, or an audit.
    Report(Format),
    /// Claims.
    Claims(ClaimFormat),
}

/// A format of one kind of item: its name, what the name of a file ends with, and itself.
type Known = (&'static str, &'static str, OutputFormat);

const fn export(format: E) -> OutputFormat {
    OutputFormat::Constants(ConstantsFormat::Export(format))
}

const CONSTANTS: &[Known] = &[
    ("table", "txt", OutputFormat::Constants(ConstantsFormat::Table)),
    ("json", "json", export(E::Json)),
    ("csv", "csv", OutputFormat::Constants(ConstantsFormat::Csv)),
    ("toml", "toml", export(E::Toml)),
    ("latex", "tex", export(E::Latex)),
    ("c", "h", export(E::C)),
    ("rust", "rs", export(E::Rust)),
    ("python", "py", export(E::Python)),
    ("julia", "jl", export(E::Julia)),
    ("matlab", "m", export(E::Matlab)),
    ("fortran", "f90", export(E::Fortran)),
    #[cfg(feature = "parquet")]
    ("parquet", "parquet", export(E::Parquet)),
];

const REPORTS: &[Known] = &[
    ("table", "txt", OutputFormat::Report(Format::Table)),
    ("json", "json", OutputFormat::Report(Format::Json)),
    ("csv", "csv", OutputFormat::Report(Format::Csv)),
];

const CLAIMS: &[Known] = &[
    ("text", "txt", OutputFormat::Claims(ClaimFormat::Text)),
    ("latex", "tex", OutputFormat::Claims(ClaimFormat::Latex)),
    ("json", "json", OutputFormat::Claims(ClaimFormat::Json)),
];

fn known(kind: Kind) -> &'static [Known] {
    match kind {
        Kind::Constants => CONSTANTS,
        Kind::Arches | Kind::Audit => REPORTS,
        Kind::Claims => CLAIMS,
    }
}

impl OutputFormat {
    /// The names of the formats of a kind of item.
    pub fn names(kind: Kind) -> Vec<&'static str> {
        known(kind).iter().map(|(name, ..)| *name).collect()
    }

    /// The ends of file names that tell the format.
    pub fn extensions(kind: Kind) -> Vec<&'static str> {
        known(kind).iter().map(|(_, extension, _)| *extension).collect()
    }

    /// The format of a name.
    pub fn named(kind: Kind, name: &str) -> Option<Self> {
        known(kind).iter().find(|(known, ..)| *known == name).map(|(.., format)| *format)
    }

    /// The format that the end of a file name tells.
    pub fn of_extension(kind: Kind, extension: &str) -> Option<Self> {
        known(kind).iter().find(|(_, known, _)| *known == extension).map(|(.., format)| *format)
    }

    /// The format for standard output, if none is named: for a person.
    pub fn for_a_person(kind: Kind) -> Self {
        let (.., format) = known(kind)[0];
        format
    }

    /// The name of the format.
    pub fn name(self) -> &'static str {
        let all = CONSTANTS.iter().chain(REPORTS).chain(CLAIMS);
        let found = all.into_iter().find(|(.., format)| *format == self);
        found.map_or("", |(name, ..)| *name)
    }

    /// Whether it names the certificate of each landmark by its hash.
    pub fn has_certificates(self) -> bool {
        matches!(self, Self::Constants(ConstantsFormat::Export(_)))
    }

    /// Whether it is not text.
    pub fn is_binary(self) -> bool {
        matches!(self, Self::Constants(format) if format.is_binary())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_format_has_the_name_by_which_it_is_found() {
        for kind in Kind::ALL {
            for name in OutputFormat::names(kind) {
                assert_eq!(OutputFormat::named(kind, name).map(OutputFormat::name), Some(name));
            }
            assert_eq!(OutputFormat::named(kind, "xml"), None);
        }
    }
}
