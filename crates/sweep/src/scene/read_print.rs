//! Reading from TOML to how a picture is printed.

use super::table::TableReader;
use super::value::TomlReader;
use crate::picture::{Font, PaperLength, Print};
use crate::report::Format;

/// Printing of a picture; keys of it in an item that is none are a fault.
pub(super) fn print(table: &mut TableReader, format: Option<&'static Format>) -> Option<Print> {
    let width = table.if_given("width", |reader, at| reader.said(at, PaperLength::width));
    let font_size =
        table.if_given("font_size", |reader, at| reader.said(at, PaperLength::font_size));
    let font = table.if_given("font", |reader, at| reader.said(at, str::parse::<Font>));
    let [caption, title] = ["caption", "title"].map(|key| table.or(key, true, TomlReader::truth));
    let details = table.or("full_caption", false, TomlReader::truth)?;
    let (width, font_size, font) = (width?, font_size?, font?);
    let print = Print { width, font_size, font, caption: caption?, details, title: title? };
    let is_picture = format.is_none_or(|format| format.is_picture);
    match is_picture || print == Print::default() {
        true => Some(print),
        false => table.refuse(
            "width, font_size, font, caption, full_caption and title are of svg, png and pdf; leave them out",
        ),
    }
}
