//! What is written: whole, alone, and nothing if the run is interrupted.

use crate::program::{Scratch, command, ended, printed, said, start, tells};

#[test]
fn a_folder_is_no_file_to_write() {
    let scratch = Scratch::new();
    let path = scratch.path("");
    let (_, message) = ended(3, ["constants", "L", "--output", &path], "");
    assert_eq!(message.lines().count(), 1, "{message}");
    tells(&message, [path]);
}

#[test]
fn a_file_appears_whole_and_alone() {
    let scratch = Scratch::new();
    let path = scratch.path("constants.json");
    std::fs::write(&path, "old").unwrap();
    let asked = ["constants", "L", "--format", "json", "--output", &path];
    assert_eq!(printed(asked), "");
    assert_eq!(scratch.json("constants.json")["schema"], "couplet.constants/1");
    assert_eq!(scratch.files(".").len(), 1, "nothing is left beside it");
    ended(2, ["constants", "L", "--digits", "0", "--output", &path], "");
    assert!(scratch.read("constants.json").contains("couplet.constants/1"), "kept");
}

/// In every command that has `--output`.
#[test]
fn a_dash_is_standard_output() {
    let scratch = Scratch::new();
    for arguments in [
        "constants L --digits 5",
        "state --alpha 1 --mu 1 --digits 5",
        "certify L --digits 5",
        "certify state --alpha 1 --mu 1 --digits 5",
    ] {
        let plain = printed(arguments);
        for option in ["-o", "--output"] {
            let mut asked = command(format!("{arguments} {option} -"));
            let output = asked.current_dir(scratch.folder()).output().unwrap();
            assert_eq!(said(&output), (Some(0), plain.clone(), String::new()), "{arguments}");
        }
    }
    assert!(scratch.files(".").is_empty());
}

/// Without a thread to spare: one line, no panic.
#[cfg(target_os = "linux")]
#[test]
fn threads_of_the_environment_have_the_limit_of_the_option() {
    let run =
        |threads| said(&command("states -").env("RAYON_NUM_THREADS", threads).output().unwrap());
    let message = "couplet: RAYON_NUM_THREADS=20000: threads are a whole number from 1 to 1024\n";
    assert_eq!(run("20000"), (Some(2), String::new(), message.to_owned()));
    for usual in ["2", "0", "many"] {
        assert!(!run(usual).2.contains("threads"), "{usual}");
    }
}

#[test]
fn threads_that_cannot_start_are_a_resource_failure() {
    // No address space has a stack of this size.
    let no_thread = |arguments: &str| {
        let mut command = command(arguments);
        command.env("RUST_MIN_STACK", (1u64 << 60).to_string()).output().unwrap()
    };
    for arguments in ["constants L", "states", "prove eq-7"] {
        let (code, output, message) = said(&no_thread(arguments));
        assert_eq!((code, output.as_str()), (Some(3), ""), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.starts_with("couplet: cannot start threads ("), "{message}");
    }
    // What needs none goes on.
    assert_eq!(no_thread("completions bash").status.code(), Some(0));
}

#[cfg(unix)]
#[test]
fn a_device_is_written_to_and_not_replaced() {
    printed("constants L --output /dev/null");
    assert!(!std::fs::metadata("/dev/null").unwrap().is_file());
}

/// A reader that stops early has what it wanted.
#[test]
fn a_closed_pipe_is_no_failure() {
    for format in ["table", "json", "csv"] {
        let mut child = start(format!("constants --digits 5000 --format {format}"));
        drop(child.stdout.take());
        let (code, _, message) = said(&child.wait_with_output().unwrap());
        assert_eq!((code, message.as_str()), (Some(0), ""), "{format}");
    }
}
