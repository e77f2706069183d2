//! Results that can be written: each makes records, and each format of records is written here, once.

use super::format::{Content, Format};
use super::json;
use super::paper::PaperTable;
use super::record::Record;
use super::tabular::{Separated, Tabular};
use crate::picture::Print;
#[cfg(feature = "plots")]
use crate::picture::{pdf::render as pdf, png::render as png};
use std::io;
use std::sync::Arc;

/// A result that makes records, from which its formats are written.
pub trait Reported {
    /// The formats in which it is written, the usual one first: those of records with rows, where there are no others.
    fn content() -> Content
    where
        Self: Sized,
    {
        Content::RECORDS
    }

    /// Records of the result: one is an object in JSON, several are a list.
    fn records(&self) -> Vec<Record>;

    /// Rows of the result, in columns.
    fn tabular(&self) -> Tabular {
        Tabular::default()
    }

    /// Picture of the result, as SVG; an invalid input if it cannot be printed so.
    fn picture(&self, _: &Print) -> io::Result<String> {
        unsupported()
    }

    /// A line that says what is in a file of it, if that needs one.
    fn summary(&self) -> Option<String> {
        None
    }

    /// Writes it in a way that no other result has, if it has one for a format.
    fn write_as(&self, _: &Format, _: &mut dyn io::Write) -> Option<io::Result<()>> {
        None
    }

    /// Writes it. A format that cannot write it is an error.
    fn write(&self, format: &Format, out: &mut dyn io::Write) -> io::Result<()> {
        self.printed((format, &Print::default()), out)
    }

    /// Writes it, a picture as it is printed.
    fn printed(
        &self,
        (format, print): (&Format, &Print),
        out: &mut dyn io::Write,
    ) -> io::Result<()> {
        if let Some(done) = self.write_as(format, out) {
            return done;
        }
        match format.name {
            "table" | "text" => {
                let lines: Vec<String> = self.records().iter().map(Record::lines).collect();
                out.write_all(lines.join("\n").as_bytes())
            }
            "plain" => {
                let mut values = self.records().into_iter().flat_map(|record| record.shown());
                values.try_for_each(|value| writeln!(out, "{value}"))
            }
            "json" => match &self.records()[..] {
                [one] => json::write(one, out),
                all => json::write(&all, out),
            },
            "csv" => self.tabular().write(Separated::Comma, out),
            "csv2" => self.tabular().write(Separated::Semicolon, out),
            "latex" => PaperTable::from(&self.tabular()).latex(out),
            "markdown" => PaperTable::from(&self.tabular()).markdown(out),
            _ if format.is_picture => out.write_all(&drawn(self.picture(print)?, (format, print))?),
            _ => unsupported(),
        }
    }
}

/// A result that others have too.
impl<T: Reported> Reported for Arc<T> {
    fn content() -> Content {
        T::content()
    }

    fn records(&self) -> Vec<Record> {
        T::records(self)
    }

    fn tabular(&self) -> Tabular {
        T::tabular(self)
    }
}

impl<T: Reported> Reported for Vec<T> {
    fn content() -> Content {
        T::content()
    }

    fn records(&self) -> Vec<Record> {
        self.iter().flat_map(T::records).collect()
    }

    fn tabular(&self) -> Tabular {
        self.iter().map(T::tabular).collect()
    }
}

/// The bytes of a picture that is drawn as SVG.
pub(super) fn drawn(svg: String, (format, print): (&Format, &Print)) -> io::Result<Vec<u8>> {
    match format.name {
        "png" => png(&svg, print),
        "pdf" => pdf(&svg, print),
        _ => Ok(svg.into_bytes()),
    }
}

#[cfg(not(feature = "plots"))]
fn png(_: &str, _: &Print) -> io::Result<Vec<u8>> {
    unsupported()
}

#[cfg(not(feature = "plots"))]
use png as pdf;

pub(super) fn unsupported<T>() -> io::Result<T> {
    Err(io::ErrorKind::Unsupported.into())
}
