//! The formats of a scene's outputs, by their names and by the ends of file names: the only place that
//! knows them.

use super::schema::Kind;
use crate::report::{ClaimFormat, Format};

/// How an output is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputFormat {
    /// Constants, arches, an audit.
    Report(Format),
    /// Claims.
    Claims(ClaimFormat),
}

/// A format of one kind of item.
struct Known {
    name: &'static str,
    /// What the name of a file ends with.
    extension: &'static str,
    format: OutputFormat,
}

const REPORTS: &[Known] = &[
    Known { name: "table", extension: "txt", format: OutputFormat::Report(Format::Table) },
    Known { name: "json", extension: "json", format: OutputFormat::Report(Format::Json) },
    Known { name: "csv", extension: "csv", format: OutputFormat::Report(Format::Csv) },
];

const CLAIMS: &[Known] = &[
    Known { name: "text", extension: "txt", format: OutputFormat::Claims(ClaimFormat::Text) },
    Known { name: "latex", extension: "tex", format: OutputFormat::Claims(ClaimFormat::Latex) },
    Known { name: "json", extension: "json", format: OutputFormat::Claims(ClaimFormat::Json) },
];

fn known(kind: Kind) -> &'static [Known] {
    match kind {
        Kind::Constants | Kind::Arches | Kind::Audit => REPORTS,
        Kind::Claims => CLAIMS,
    }
}

impl OutputFormat {
    /// The names of the formats of a kind of item.
    pub fn names(kind: Kind) -> Vec<&'static str> {
        known(kind).iter().map(|known| known.name).collect()
    }

    /// The ends of file names that tell the format.
    pub fn extensions(kind: Kind) -> Vec<&'static str> {
        known(kind).iter().map(|known| known.extension).collect()
    }

    /// The format of a name.
    pub fn named(kind: Kind, name: &str) -> Option<Self> {
        known(kind).iter().find(|known| known.name == name).map(|known| known.format)
    }

    /// The format that the end of a file name tells.
    pub fn of_extension(kind: Kind, extension: &str) -> Option<Self> {
        known(kind).iter().find(|known| known.extension == extension).map(|known| known.format)
    }

    /// The format for standard output, if none is named: for a person.
    pub fn for_a_person(kind: Kind) -> Self {
        known(kind)[0].format
    }

    /// The name of the format.
    pub fn name(self) -> &'static str {
        let found = REPORTS.iter().chain(CLAIMS).find(|known| known.format == self);
        found.map_or("", |known| known.name)
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
