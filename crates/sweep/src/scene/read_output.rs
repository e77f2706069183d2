//! Destinations of the items of a scene: each file inside the folder of outputs, and written by one item only.

use super::fault::Position;
use super::manifest;
use super::schema::ItemKind;
use super::table::TableReader;
use super::value::{TomlReader, TomlValue};
use crate::report::Format;
use crate::report::words::{distinct, list};
use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};

/// The files that the items so far write, and where the scene says so.
#[derive(Default)]
pub(super) struct OutputFiles(HashMap<String, (PathBuf, Position)>);

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
    let format = match (named, output, &path) {
        (Some(value), _, _) => format(reader, kind, value),
        (None, None, _) => Format::all(kind.content()).next(),
        (None, Some(value), Some(path)) => format_of(reader, kind, value, path),
        (None, Some(_), None) => None,
    }?;
    if let (Some(message), Some(value)) = (format.missing(), named.or(output)) {
        reader.fault(value.span(), message);
    }
    if let (true, None, Some(value)) = (format.is_binary, output, named) {
        reader.reject::<()>("format", value, "text; give it an output");
    }
    (reader.faults.len() == before).then_some((path, format))
}

/// The format of a name.
fn format(reader: &mut TomlReader, kind: ItemKind, value: &TomlValue) -> Option<&'static Format> {
    let name = value.get_ref().as_str().unwrap_or_default();
    Format::named(kind.content(), name).or_else(|| {
        let names = Format::names(kind.content());
        reader.reject("format", value, &format!("one of {names}"))
    })
}

/// The format that the end of a file's name tells.
fn format_of(
    reader: &mut TomlReader,
    kind: ItemKind,
    value: &TomlValue,
    path: &Path,
) -> Option<&'static Format> {
    let end = path.extension().and_then(|end| end.to_str()).unwrap_or_default();
    Format::named(kind.content(), end).or_else(|| {
        let ends = list(distinct(Format::all(kind.content()).map(|format| format.extension)));
        let message = format!(
            "output {} does not tell a format by its end ({ends}); give it such an end, or a format, \
             one of {}",
            reader.source.shown(value.span()),
            Format::names(kind.content())
        );
        reader.refuse(value.span(), message)
    })
}

fn file(reader: &mut TomlReader, value: &TomlValue, files: &mut OutputFiles) -> Option<PathBuf> {
    let text = reader.text("output", value)?;
    let inside =
        |component: &Component| matches!(component, Component::Normal(_) | Component::CurDir);
    let is_file = !text.is_empty()
        && !text.ends_with(['/', '\\'])
        && !text.contains(char::is_control)
        && Path::new(text).components().all(|component| inside(&component));
    let path: PathBuf = Path::new(text)
        .components()
        .filter(|component| matches!(component, Component::Normal(_)))
        .collect();
    if !is_file || path.as_os_str().is_empty() {
        let allowed = "a file inside the folder of outputs (a relative path without ..)";
        return reader.reject("output", value, allowed);
    }
    let mut fault = |reason: String| {
        let shown = reader.source.shown(value.span());
        reader.refuse(value.span(), format!("output {shown} {reason}"))
    };
    // On some file systems names that differ in case are one.
    let key = |path: &Path| path.to_string_lossy().to_lowercase();
    if key(&path) == manifest::NAME {
        return fault("is where the run keeps its own record".to_owned());
    }
    if let Some((other, at)) = files.0.get(&key(&path)) {
        let reason = if *other == path {
            format!("is already written by the item whose output is in line {}", at.line)
        } else {
            format!("differs in case only from the output in line {}", at.line)
        };
        return fault(reason);
    }
    let within = |inner: &Path, outer: &str| inner.ancestors().skip(1).any(|a| key(a) == outer);
    let clash = files
        .0
        .iter()
        .find(|(other, (file, _))| within(&path, other) || within(file, &key(&path)))
        .map(|(_, (_, at))| at.line);
    if let Some(line) = clash {
        return fault(format!("and the output in line {line} cannot be a file and its folder"));
    }
    let place = reader.source.place(value.span().start);
    files.0.insert(key(&path), (path.clone(), place));
    Some(path)
}
