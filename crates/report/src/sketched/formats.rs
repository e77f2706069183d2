//! The formats in which arches are drawn.

use super::{Sketched, dxf, json, lean, picture};
use crate::format::{Content, Format};
use crate::picture::Print;
use crate::record::Record;
use crate::reported::Reported;
use std::io;

impl Reported for Sketched {
    fn content() -> Content {
        Content(&["json", "svg", "png", "pdf", "dxf"])
    }

    fn records(&self) -> Vec<Record> {
        vec![json::record(self)]
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        picture::picture(self, print)
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        match format.name {
            "json" => Some(lean::write(&json::record(self), out)),
            "dxf" => Some(dxf::dxf(self, out)),
            _ => None,
        }
    }
}
