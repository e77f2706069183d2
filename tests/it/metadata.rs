//! The version, the address and the licence of the repository stand in its Cargo.toml alone; all else derives from
//! these.

use crate::house::{house, read};
use std::fs;
use toml::{Table, Value};

/// What every package has from the workspace.
const SHARED: [&str; 6] =
    ["authors", "edition", "license", "repository", "rust-version", "version"];

/// The packages that are no library for Rust, and so are in no registry.
const UNPUBLISHED: [&str; 3] = ["c", "page", "python"];

fn manifest(folder: &str) -> Table {
    read(&format!("{folder}/Cargo.toml")).parse().unwrap()
}

/// The folders of all packages, the root's among them.
fn folders() -> Vec<String> {
    let crates = fs::read_dir(house("crates")).unwrap();
    let crates = crates.map(|entry| format!("crates/{}", entry.unwrap().file_name().display()));
    crates.chain([".", "c", "page", "python"].map(str::to_owned)).collect()
}

fn of_workspace(key: &str) -> String {
    manifest(".")["workspace"]["package"][key].as_str().unwrap().to_owned()
}

fn derives(value: Option<&Value>) -> bool {
    value.and_then(|value| value.get("workspace")) == Some(&Value::Boolean(true))
}

/// The keys of a package that are its own and should be the workspace's.
fn own(folder: &str, manifest: &Table) -> Vec<&'static str> {
    let package = &manifest["package"];
    let mut keys: Vec<_> = SHARED.into_iter().filter(|key| !derives(package.get(key))).collect();
    let is_unpublished = package.get("publish") == Some(&Value::Boolean(false));
    let is_right = if UNPUBLISHED.contains(&folder) {
        is_unpublished
    } else {
        derives(package.get("publish"))
    };
    if !is_right {
        keys.push("publish");
    }
    keys
}

#[test]
fn every_package_derives_from_the_workspace() {
    let folders = folders();
    assert_eq!(folders.len(), 21);
    for folder in folders {
        assert_eq!(own(&folder, &manifest(&folder)), [""; 0], "{folder}");
    }
}

#[test]
fn a_key_of_its_own_is_seen() {
    let whole = read("crates/number/Cargo.toml");
    for key in SHARED.into_iter().chain(["publish"]) {
        let line = format!("{key}.workspace = true\n");
        let spoiled = whole.replacen(&line, &format!("{key} = \"0\"\n"), 1);
        assert_eq!(own("crates/number", &spoiled.parse().unwrap()), [key]);
        let spoiled = whole.replacen(&line, "", 1);
        assert_eq!(own("crates/number", &spoiled.parse().unwrap()), [key]);
    }
}

/// The crates of the workspace are asked for in one version, that of the workspace.
#[test]
fn the_crates_ask_for_each_other_in_their_own_version() {
    let wanted = format!("={}", of_workspace("version"));
    let manifest = manifest(".");
    let known = manifest["workspace"]["dependencies"].as_table().unwrap();
    let ours: Vec<_> = known.iter().filter(|(name, _)| name.starts_with("couplet")).collect();
    assert_eq!(ours.len(), 18);
    for (name, dependency) in ours {
        assert_eq!(dependency["version"].as_str(), Some(&*wanted), "{name}");
    }
}

/// A line `key: value` of CITATION.cff.
fn cited<'a>(citation: &'a str, key: &str) -> Option<&'a str> {
    let line = citation.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(": "))?;
    Some(line.trim_matches('"'))
}

/// What CITATION.cff and the Python package say otherwise than the workspace. An empty address is none.
fn otherwise(citation: &str, python: &str, version: &str, address: &str) -> Vec<&'static str> {
    let python: Table = python.parse().unwrap();
    let urls = python["project"].get("urls").and_then(|urls| urls.get("Repository"));
    let address = (!address.is_empty()).then_some(address);
    let derives = python["project"]["dynamic"].as_array().unwrap().contains(&"version".into());
    let questions = [
        ("CITATION.cff: version", cited(citation, "version") == Some(version)),
        ("CITATION.cff: repository-code", cited(citation, "repository-code") == address),
        ("pyproject.toml: version", derives && python["project"].get("version").is_none()),
        ("pyproject.toml: Repository", urls.and_then(Value::as_str) == address),
    ];
    questions.into_iter().filter(|(_, is_right)| !is_right).map(|(what, _)| what).collect()
}

#[test]
fn what_is_cited_and_the_python_package_have_its_version_and_address() {
    let citation = read("CITATION.cff");
    let python = read("python/pyproject.toml");
    let version = of_workspace("version");
    let wrong = otherwise(&citation, &python, &version, &of_workspace("repository"));
    assert_eq!(wrong, [""; 0]);
    let wrong = otherwise(&citation, &python, "0.0.9", "https://example.org/other");
    let all =
        ["CITATION.cff: version", "CITATION.cff: repository-code", "pyproject.toml: Repository"];
    assert_eq!(wrong, all);
    let cited = format!("{citation}repository-code: \"https://example.org/couplet\"\n");
    let python =
        format!("{python}\n[project.urls]\nRepository = \"https://example.org/couplet\"\n");
    let wrong = otherwise(&cited, &python, &version, "https://example.org/couplet");
    assert_eq!(wrong, [""; 0]);
    let wrong = otherwise(&cited, &python, &version, "");
    assert_eq!(wrong, ["CITATION.cff: repository-code", "pyproject.toml: Repository"]);
}

/// `c/build.sh` writes the version into the files of CMake and pkg-config.
#[test]
fn the_files_of_the_library_for_c_have_no_version_of_their_own() {
    for file in ["couplet_c.pc", "couplet_cConfigVersion.cmake"] {
        assert_eq!(read(&format!("c/package/{file}")).matches("@VERSION@").count(), 1, "{file}");
    }
    let defined = format!("#define COUPLET_C_VERSION \"{}\"", of_workspace("version"));
    assert!(read("c/include/couplet_c.h").contains(&defined));
}

/// A package holds the texts of its licences, which stand in the repository once.
#[test]
fn every_package_has_the_texts_of_its_licences() {
    for folder in folders() {
        for name in ["LICENSE-APACHE", "LICENSE-MIT"] {
            assert_eq!(read(&format!("{folder}/{name}")), read(name), "{folder}");
        }
    }
}

/// The crate rug that is offered beside balls is named with its major version.
#[test]
fn the_version_of_rug_is_named() {
    let manifest = manifest(".");
    let version = manifest["workspace"]["dependencies"]["rug"]["version"].as_str().unwrap();
    let major = version.split('.').next().unwrap();
    assert!(read("src/lib.rs").contains(&format!("/// The crate rug {major}: ")));
    assert!(read("docs/release.md").contains(&format!("which is rug {major}.")));
}
