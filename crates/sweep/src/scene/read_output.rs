//! Destinations of the items of a scene, and how pictures are printed: each file is inside the folder of outputs, and
//! one item alone writes it.

use super::manifest;
use super::schema::ItemKind;
use super::table::TableReader;
use super::value::{TomlReader, TomlValue};
use crate::picture::{Font, PaperLength, Print};
use crate::report::Format;
use crate::report::words::{distinct, list};
use std::path::{Component, Path, PathBuf};

/// The files that the items so far write, in small letters and as they are, with the lines where the scene says so.
#[derive(Default)]
pub(super) struct OutputFiles(Vec<(PathBuf, PathBuf, usize)>);

/// The file and the format of an item; a file name tells its format unless one is given.
pub(super) fn output(
    table: &mut TableReader,
    kind: ItemKind,
    files: &mut OutputFiles,
) -> Option<(Option<PathBuf>, &'static Format)> {
    let (output, named) = (table.get("output"), table.get("format"));
    let reader = &mut *table.reader;
    let before = reader.faults.len();
    let path = output.and_then(|value| file(reader, value, files));
    let (content, names) = (kind.content(), Format::names(kind.content()));
    let format = match (named, output) {
        (None, None) => Format::all(content).next(),
        (Some(value), _) => {
            let name = value.get_ref().as_str().unwrap_or_default();
            let none = || reader.reject(("format", value), &format!("one of {names}"));
            Format::named(content, name).or_else(none)
        }
        // What the file's name ends with tells it.
        (None, Some(value)) => {
            let end = path.as_ref()?.extension().and_then(|end| end.to_str()).unwrap_or_default();
            Format::named(content, end).or_else(|| {
                let ends = list(distinct(Format::all(content).map(|format| format.extension)));
                let shown = reader.source.shown(value.span());
                let message = format!(
                    "output {shown} does not tell a format by its end ({ends}); give it such an end, or a format, one \
                     of {names}"
                );
                reader.refuse(value.span(), message)
            })
        }
    }?;
    if let (Some(message), Some(value)) = (format.missing(), named.or(output)) {
        reader.fault(value.span(), message);
    }
    if let (true, None, Some(value)) = (format.is_binary, output, named) {
        reader.reject::<()>(("format", value), "text; give it an output");
    }
    (reader.faults.len() == before).then_some((path, format))
}

fn file(reader: &mut TomlReader, value: &TomlValue, files: &mut OutputFiles) -> Option<PathBuf> {
    let text = reader.text(("output", value))?;
    let all = || Path::new(text).components();
    let path: PathBuf = all().filter(|part| matches!(part, Component::Normal(_))).collect();
    let is_file = !text.ends_with(['/', '\\'])
        && !text.contains(char::is_control)
        && all().all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
        && !path.as_os_str().is_empty();
    if !is_file {
        let allowed = "a file inside the folder of outputs (a relative path without ..)";
        return reader.reject(("output", value), allowed);
    }
    // On some file systems names that differ in case are one.
    let key = PathBuf::from(path.to_string_lossy().to_lowercase());
    let clash = files.0.iter().find_map(|(other, its, line)| {
        if key == *other && path == *its {
            Some(format!("is already written by the item whose output is in line {line}"))
        } else if key == *other {
            Some(format!("differs in case only from the output in line {line}"))
        } else {
            let is_within = key.starts_with(other) || other.starts_with(&key);
            is_within
                .then(|| format!("and the output in line {line} cannot be a file and its folder"))
        }
    });
    let is_own = key == Path::new(manifest::NAME);
    let own = is_own.then(|| "is where the run keeps its own record".to_owned());
    if let Some(reason) = own.or(clash) {
        let shown = reader.source.shown(value.span());
        return reader.refuse(value.span(), format!("output {shown} {reason}"));
    }
    files.0.push((key, path.clone(), reader.source.place(value.span().start).line));
    Some(path)
}

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
