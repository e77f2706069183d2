//! The formats in which arches are drawn.

use super::{Sketched, dxf, json, picture};
use crate::report::format::{Content, Format};
use crate::report::record::Record;
use crate::report::reported::Reported;
use std::io;

impl Reported for Sketched {
    fn content() -> Content {
        Content(&["json", "svg", "png", "dxf"])
    }

    fn records(&self) -> Vec<Record> {
        Vec::new()
    }

    fn picture(&self) -> io::Result<String> {
        Ok(picture::picture(self))
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        match format.name {
            "json" => Some(json::json(self, out)),
            "dxf" => Some(dxf::dxf(self, out)),
            _ => None,
        }
    }
}
