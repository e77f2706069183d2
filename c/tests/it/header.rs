//! The header is that of the source, and the library has its functions and no others.

use crate::library::{here, symbols};
use std::collections::BTreeSet;
use std::fs;

/// The header of the source.
fn made() -> String {
    let config = cbindgen::Config::from_file(here().join("cbindgen.toml")).unwrap();
    let header = cbindgen::Builder::new().with_crate(here()).with_config(config);
    let mut bytes = Vec::new();
    header.generate().unwrap().write(&mut bytes);
    String::from_utf8(bytes).unwrap()
}

/// The functions that a header declares.
fn declared(header: &str) -> BTreeSet<String> {
    let before = header.split('(').map(|text| text.rsplit([' ', '*', '\n']).next().unwrap());
    before.filter(|name| name.starts_with("couplet_")).map(str::to_owned).collect()
}

#[test]
fn the_header_is_that_of_the_source() {
    let (path, made) = (here().join("include/couplet_c.h"), made());
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        return fs::write(path, made).unwrap();
    }
    assert_eq!(fs::read_to_string(path).unwrap_or_default(), made, "make header");
}

#[test]
#[cfg(target_os = "linux")]
fn the_libraries_have_the_functions_of_the_header_and_no_others() {
    let declared = declared(&made());
    assert!(declared.len() > 15 && declared.contains("couplet_states"), "{declared:?}");
    for (file, option) in [("libcouplet_c.so", "-D"), ("libcouplet_c.a", "-g")] {
        assert_eq!(symbols(file, &[option, "--defined-only"]), declared, "{file}");
    }
}

/// The module for Fortran and the manual have every function too.
#[test]
fn every_function_is_in_the_module_and_in_the_manual() {
    let [module, manual] = ["include/couplet_c.f90", "../docs/c.md"]
        .map(|file| fs::read_to_string(here().join(file)).unwrap());
    for name in declared(&made()) {
        let kinds = ["function", "subroutine"].map(|kind| format!("    {kind} {name}("));
        let interfaces = kinds.iter().map(|begin| module.matches(begin.as_str()).count());
        assert_eq!(interfaces.sum::<usize>(), 1, "{name} in Fortran");
        assert!(manual.contains(&format!("`{name}")), "{name} in docs/c.md");
    }
}
