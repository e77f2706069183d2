//! A run that is ended leaves nothing half-written, whoever writes and whatever ends it.

use crate::program::{Scratch, command};
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const PLAN: &str = "schema = \"couplet.sweep/1\"\ndigits = 30\nchunk = 50_000\n[sample]\n\
    count = 200_000\nhard = true\n";
const SCENE: &str = "schema = \"couplet.scene/1\"\n[[constants]]\nlandmarks = \"T\"\noutput = \"quick.csv\"\n\
    [[constants]]\nlandmarks = \"S\"\ndigits = 1_000_000\noutput = \"slow.csv\"\n";

/// Every way in which the program writes, each busy for long or waiting for rows.
const WRITERS: [&[&str]; 10] = [
    &["sweep", "plan.toml", "-o", "o"],
    &["run", "scene.toml", "-o", "o"],
    &["states", "-", "-o", "o.csv"],
    &["states", "-", "-o", "o.parquet"],
    &["judge", "-", "-o", "o.csv"],
    &["sample", "--hard", "--count", "10000000", "-o", "o.csv"],
    &["sample", "--assemblies", "--count", "100000", "-o", "o.csv"],
    &["sample", "--assemblies", "--count", "100000", "--format", "obj", "-o", "o/new"],
    &["sample", "--assemblies", "--count", "100000", "--format", "dxf", "-o", "there"],
    &["constants", "T", "--digits", "1000000", "-o", "o.json"],
];

/// Hidden names in a folder and in those within it.
fn hidden(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name().into_string().unwrap();
        match name.starts_with(".couplet-") {
            true => found.push(name),
            false => found.extend(hidden(&entry.path())),
        }
    }
    found
}

/// Has a writer begin in a folder, and ends it by a signal; its exit code.
fn ended(scratch: &Scratch, folder: &str, arguments: &[&str], signal: &str) -> Option<i32> {
    let mut child = command(arguments);
    child.current_dir(scratch.path(folder)).stdin(Stdio::piped()).stderr(Stdio::null());
    // Rows are waited for as long as somebody holds the other end.
    let mut child = child.stdout(Stdio::null()).spawn().unwrap();
    let mut rows = child.stdin.take().unwrap();
    // Who reads none has perhaps ended its input.
    let _ = rows.write_all(b"half_opening,friction,thickness\n1,1,0.5\n");
    while hidden(&scratch.folder().join(folder)).is_empty() {
        std::thread::sleep(Duration::from_millis(5));
        let is_over = child.try_wait().unwrap().is_some();
        // What is written in a moment may have been.
        let is_quick = ["certify", "run"].contains(&arguments[0]);
        if is_quick && (is_over || !scratch.files("o").is_empty()) {
            break;
        }
        assert!(!is_over, "{arguments:?} ended too early");
    }
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let ended = child.wait().unwrap();
    drop(rows);
    ended.code()
}

#[test]
fn whatever_ends_a_writer_leaves_nothing_half_written() {
    for arguments in WRITERS {
        for signal in ["-INT", "-TERM", "-HUP"] {
            let scratch = Scratch::new();
            scratch.write("plan.toml", PLAN);
            scratch.write("scene.toml", SCENE);
            fs::create_dir(scratch.path("there")).unwrap();
            assert_eq!(ended(&scratch, ".", arguments, signal), Some(130), "{arguments:?}");
            let left = hidden(scratch.folder());
            assert!(left.is_empty(), "{arguments:?} {signal} leaves {left:?}");
            // What is not whole is not there at all.
            let (there, folders) = (scratch.files("."), ["plan.toml", "scene.toml", "there", "o"]);
            let is_known = |name: &String| folders.contains(&&name[..]);
            assert!(there.iter().all(is_known), "{arguments:?}: {there:?}");
            assert!(scratch.files("there").is_empty() && scratch.files("o/new").is_empty());
        }
    }
}

/// Each certificate is written when all are there, in a moment.
#[test]
fn certificates_are_whole_whatever_ends_who_writes_them() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        let scratch = Scratch::new();
        let all = ["certify", "all", "--digits", "300", "-o", "o"];
        let code = ended(&scratch, ".", &all, signal);
        assert!([Some(0), Some(130)].contains(&code), "{code:?}");
        assert_eq!(hidden(scratch.folder()), [""; 0]);
        for name in scratch.files("o") {
            let file = scratch.path(&format!("o/{name}"));
            assert!(command(["check", &file]).output().unwrap().status.success(), "{name}");
        }
    }
}

/// A folder of bodies appears at once: killed for good, the same command can be given again.
#[test]
fn bodies_that_were_killed_are_drawn_again() {
    let scratch = Scratch::new();
    for (folder, out) in [("new", "o/new"), ("old", "."), ("older", "o")] {
        fs::create_dir(scratch.path(folder)).unwrap();
        if out == "o" {
            fs::create_dir(scratch.path("older/o")).unwrap();
        }
        let draw =
            |count| ["sample", "--assemblies", "--count", count, "--format", "obj", "-o", out];
        assert_eq!(ended(&scratch, folder, &draw("100000"), "-KILL"), None);
        let bodies = || -> Vec<String> {
            let names = scratch.files(&format!("{folder}/{out}")).into_iter();
            names.filter(|name| !name.starts_with(".couplet-")).collect()
        };
        assert!(bodies().is_empty(), "{out}: {:?}", bodies());
        let mut again = command(draw("1"));
        let again = again.current_dir(scratch.path(folder)).status().unwrap();
        assert!(again.success(), "{out}");
        assert_eq!(bodies(), ["001-above.obj", "001-below.obj", "assemblies.json"]);
    }
}
