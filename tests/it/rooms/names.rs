//! What each file declares, imports and names, and the file that a name stands for.

use super::source::{bare, floors, sources, tokens, whole};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// `certify::state` as its parts; the front of a folder has the name of the folder.
pub(super) type Module = Vec<String>;

/// A path by the names in it.
pub(super) type Names = Vec<String>;

/// What stands in a file.
#[derive(Debug, Default)]
pub(super) struct File {
    /// Its place below `src`.
    pub place: String,
    /// The modules that it declares, each in a file of its own.
    children: BTreeSet<String>,
    /// Everything else that it declares.
    items: BTreeSet<String>,
    /// What it imports: the path, the name that it gets here (`*` for all), and whether others see it.
    imports: Vec<(Names, String, bool)>,
    /// The paths in its code.
    paths: Vec<Names>,
    /// The headers of its `impl` blocks.
    pub impls: Vec<Names>,
}

/// All files of a crate.
pub(super) struct Tree {
    files: BTreeMap<Module, File>,
    /// The rooms that are crates as a whole: there, `crate` is the room.
    whole: BTreeSet<String>,
}

impl Tree {
    /// The whole house: the rooms of every crate, as if they were of one. What a crate calls by the name of another
    /// one's room is that room.
    pub(super) fn of_the_house() -> Self {
        let mut texts = BTreeMap::<String, String>::new();
        let mut rooms = BTreeSet::new();
        for floor in floors() {
            let room = whole(&floor);
            rooms.extend(room.map(str::to_owned));
            if let Some(room) = room {
                texts.entry("lib.rs".to_owned()).or_default().push_str(&format!("mod {room};\n"));
            }
            for path in sources(&floor) {
                let place = path.strip_prefix(&floor).unwrap().to_str().unwrap();
                let place = match room {
                    Some(room) => format!("{room}/{}", place.replace("lib.rs", "mod.rs")),
                    None => place.to_owned(),
                };
                let text = fs::read_to_string(&path).unwrap();
                let is_own = |line: &&str| !line.contains("use couplet_");
                let text = text.lines().filter(is_own).map(|line| format!("{line}\n"));
                texts.entry(place).or_default().extend(text);
            }
        }
        Self { whole: rooms, ..Self::new(texts) }
    }

    /// A crate of these files: the place below `src` and the text.
    pub(super) fn new<P: Into<String>, T: AsRef<str>>(
        texts: impl IntoIterator<Item = (P, T)>,
    ) -> Self {
        let file = |(place, text): (P, T)| {
            let place: String = place.into();
            let names = place.trim_end_matches(".rs").split('/').map(str::to_owned);
            let mut module: Module = names.collect();
            module.pop_if(|last| *last == "mod" || *last == "lib");
            (module, File { place, ..File::read(&bare(text.as_ref())) })
        };
        let mut files: BTreeMap<Module, File> = texts.into_iter().map(file).collect();
        // What is declared by nobody is compiled for tests only, or is another program.
        let is_declared = |module: &Module| {
            let front = module.split_last().map(|(last, front)| (last, files.get(front)));
            front.is_none_or(|(last, front)| front.is_some_and(|f| f.children.contains(last)))
        };
        let declared: BTreeSet<Module> = files.keys().filter(|m| is_declared(m)).cloned().collect();
        files.retain(|module, _| declared.contains(module));
        Self { files, whole: BTreeSet::new() }
    }

    pub(super) fn files(&self) -> impl Iterator<Item = (&Module, &File)> {
        self.files.iter()
    }

    pub(super) fn place(&self, module: &[String]) -> &str {
        &self.files[module].place
    }

    /// The files whose items a file names, itself among them. What it hands on is not named.
    pub(super) fn used_by(&self, module: &Module) -> BTreeSet<Module> {
        let file = &self.files[module];
        let imported = file.imports.iter().filter(|(_, name, public)| !public && name != "*");
        let paths = imported.map(|(path, ..)| path).chain(&file.paths);
        paths.filter_map(|path| self.owner(module, path)).collect()
    }

    /// The file of the item that a path stands for, seen from a file.
    pub(super) fn owner(&self, from: &Module, path: &[String]) -> Option<Module> {
        match self.resolve(from.clone(), path, &mut BTreeSet::new())? {
            Meant::Item(module) => Some(module),
            Meant::Module(_) => None,
        }
    }

    fn resolve(
        &self,
        mut from: Module,
        path: &[String],
        seen: &mut BTreeSet<(Module, Names)>,
    ) -> Option<Meant> {
        let Some((first, rest)) = path.split_first() else { return Some(Meant::Module(from)) };
        if !seen.insert((from.clone(), path.to_vec())) {
            return None;
        }
        let file = self.files.get(&from)?;
        match first.as_str() {
            "crate" => {
                let room = from.first().filter(|room| self.whole.contains(*room)).cloned();
                let own = room.and_then(|room| self.resolve(vec![room], rest, seen));
                return own.or_else(|| self.resolve(Vec::new(), rest, seen));
            }
            "self" => return self.resolve(from, rest, seen),
            "super" => {
                from.pop()?;
                return self.resolve(from, rest, seen);
            }
            name if file.children.contains(name) => {
                from.push(name.to_owned());
                return self.resolve(from, rest, seen);
            }
            name if file.items.contains(name) => return Some(Meant::Item(from)),
            _ => {}
        }
        file.imports.iter().find_map(|(import, name, _)| match name.as_str() {
            "*" => match self.resolve(from.clone(), import, seen)? {
                Meant::Module(module) if module != from => self.resolve(module, path, seen),
                _ => None,
            },
            name if name == first => self.resolve(from.clone(), &[import, rest].concat(), seen),
            _ => None,
        })
    }
}

/// All paths that a code names or imports.
pub(super) fn paths_in(code: &str) -> Vec<Names> {
    let File { imports, mut paths, .. } = File::read(code);
    paths.extend(imports.into_iter().map(|(path, ..)| path));
    paths
}

enum Meant {
    Module(Module),
    Item(Module),
}

impl File {
    fn read(code: &str) -> Self {
        let tokens = tokens(code);
        let (mut file, mut depth, mut public, mut at) = (Self::default(), 0usize, false, 0);
        while at < tokens.len() {
            let next = tokens.get(at + 1).copied().unwrap_or_default();
            match tokens[at] {
                // What a macro is given stands in the file as if there were no macro: it may be a type.
                "{" if depth == 0 && at > 0 && tokens[at - 1] == "!" => {}
                "{" => depth += 1,
                "}" => depth = usize::saturating_sub(depth, 1),
                "pub" => {
                    // With what stands in parentheses behind it.
                    let close = |end| tokens[at..].iter().position(|t| *t == end).unwrap();
                    at += if next == "(" { close(")") + 1 } else { 1 };
                    public = true;
                    continue;
                }
                "use" => {
                    at = file.import(&tokens, at + 1, &[], public);
                    public = false;
                    continue;
                }
                "mod" if depth == 0 && tokens.get(at + 2) == Some(&";") => {
                    file.children.insert(next.to_owned());
                }
                "fn" | "struct" | "enum" | "trait" | "type" | "const" | "static" if depth == 0 => {
                    file.items.insert(next.to_owned());
                }
                // An item, not `impl Trait` in a signature.
                "impl" if at == 0 || ["}", ";", "]"].contains(&tokens[at - 1]) => {
                    let header = tokens[at + 1..].iter().take_while(|token| **token != "{");
                    file.impls.push(header.map(|token| (*token).to_owned()).collect());
                }
                word if is_name(word) && (at == 0 || !["::", "."].contains(&tokens[at - 1])) => {
                    file.paths.push(path(&tokens[at..]));
                }
                _ => {}
            }
            public = false;
            at += 1;
        }
        file
    }

    /// Reads what comes after `use` or, in braces, after a path; returns where it ends.
    fn import(&mut self, tokens: &[&str], mut at: usize, before: &[String], public: bool) -> usize {
        let mut path = before.to_vec();
        loop {
            match tokens[at] {
                "{" => {
                    while tokens[at] != "}" {
                        // Behind the brace or a comma.
                        at += 1;
                        if tokens[at] != "}" {
                            at = self.import(tokens, at, &path, public);
                        }
                    }
                    return at + 1;
                }
                "*" => {
                    self.imports.push((path, "*".to_owned(), public));
                    return at + 1;
                }
                "::" => {}
                "as" => {
                    self.imports.push((path, tokens[at + 1].to_owned(), public));
                    return at + 2;
                }
                "," | ";" | "}" => {
                    path.pop_if(|last| last == "self");
                    let name = path.last().cloned().unwrap_or_default();
                    self.imports.push((path, name, public));
                    return at;
                }
                name => path.push(name.to_owned()),
            }
            at += 1;
        }
    }
}

pub(super) fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// The path that tokens begin with.
pub(super) fn path<T: AsRef<str>>(tokens: &[T]) -> Names {
    let mut names = vec![tokens[0].as_ref().to_owned()];
    for pair in tokens[1..].chunks_exact(2) {
        match [pair[0].as_ref(), pair[1].as_ref()] {
            ["::", name] if is_name(name) => names.push(name.to_owned()),
            _ => break,
        }
    }
    names
}
