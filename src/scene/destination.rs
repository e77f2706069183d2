//! Where the items of a scene go: each file inside the folder of outputs, and written by one item only.

use super::fault::{Place, list};
use super::format::OutputFormat;
use super::manifest;
use super::schema::Kind;
use super::value::{Reader, Value};
use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};

/// The files that the items so far write, and where the scene says so.
#[derive(Default)]
pub struct Files(HashMap<String, (PathBuf, Place)>);

impl Reader<'_> {
    /// The file and the format of an item; a file name tells its format unless one is given.
    pub fn destination(
        &mut self,
        kind: Kind,
        [output, format_value]: [Option<&Value>; 2],
        files: &mut Files,
    ) -> Option<(Option<PathBuf>, OutputFormat)> {
        let before = self.faults.len();
        let path = output.and_then(|value| self.file(value, files));
        let named = format_value.and_then(|value| {
            let text = value.get_ref().as_str();
            let found = text.and_then(|name| OutputFormat::named(kind, name));
            if found.is_none() {
                let names = list(OutputFormat::names(kind));
                self.is_not("format", value, &format!("one of {names}"));
            }
            found
        });
        let told = match (output, &path, format_value) {
            (None, _, _) => Some(OutputFormat::for_a_person(kind)),
            (Some(value), Some(path), None) => {
                let end = path.extension().and_then(|end| end.to_str()).unwrap_or_default();
                let told = OutputFormat::of_extension(kind, &end.to_ascii_lowercase());
                if told.is_none() {
                    let ends = list(OutputFormat::extensions(kind));
                    let names = list(OutputFormat::names(kind));
                    let message = format!(
                        "output {} does not tell a format by its end ({ends}); give it such an end, or a \
                         format, one of {names}",
                        self.source.shown(value.span())
                    );
                    self.fault(value.span(), message);
                }
                told
            }
            _ => None,
        };
        let format = named.or(told)?;
        if let (true, None, Some(value)) = (format.is_binary(), output, format_value) {
            self.is_not("format", value, "text; give it an output");
        }
        (self.faults.len() == before).then_some((path, format))
    }

    fn file(&mut self, value: &Value, files: &mut Files) -> Option<PathBuf> {
        let text = self.text("output", value)?;
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
            self.is_not("output", value, allowed);
            return None;
        }
        let mut fault = |reason: String| {
            let shown = self.source.shown(value.span());
            self.fault(value.span(), format!("output {shown} {reason}"));
            None
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
        let place = self.source.place(value.span().start);
        files.0.insert(key(&path), (path.clone(), place));
        Some(path)
    }
}
