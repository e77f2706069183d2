//! The formats in which arches are drawn.

use super::{Sketched, dxf, json, picture};
use crate::picture::Print;
use crate::report::format::{Content, Format};
use crate::report::record::Record;
use crate::report::reported::Reported;
use std::io;

impl Reported for Sketched {
    fn content() -> Content {
        Content(&["json", "svg", "png", "pdf", "dxf"])
    }

    fn records(&self) -> Vec<Record> {
        Vec::new()
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        picture::picture(self, print)
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        match format.name {
            "json" => Some(json::json(self, out)),
            "dxf" => Some(dxf::dxf(self, out)),
            _ => None,
        }
    }
}
