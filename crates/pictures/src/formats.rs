//! The formats in which arches are drawn.

use super::lean::write_lean;
use super::{Sketched, dxf, json, page};
use crate::picture::Print;
use crate::report::{Content, Format, Record, Reported};
use std::io;

impl Reported for Sketched {
    fn content() -> Content {
        Content(&["json", "svg", "png", "pdf", "dxf"])
    }

    fn records(&self) -> Vec<Record> {
        vec![json::record(self)]
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        page::picture(self, print)
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        match format.name {
            "json" => Some(write_lean(&self.records(), out)),
            "dxf" => Some(dxf::dxf(self, out)),
            _ => None,
        }
    }
}
