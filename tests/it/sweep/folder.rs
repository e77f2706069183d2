//! The folder of a sweep: what is in it and does not belong there, and with which record it is opened.

use super::{files, folder, look, planned, sweep, sweeps};
use crate::export::parquet::read;
use crate::program::{couplet, said};
use parquet::record::Field;
use sha2::{Digest, Sha256};
use std::fs;

#[test]
fn a_folder_is_looked_through_with_a_hundred_rows_and_says_so() {
    let scratch =
        planned("[grid]\nhalf_opening = 1\nfriction = { from = 0.3, to = 0.5, steps = 150 }\n");
    sweep(&scratch, "out", &[]);
    let (code, out, message) = said(&couplet(["sweep", &folder(&scratch, "out")]));
    assert_eq!(code, Some(0));
    assert!(out.contains("; 100 rows proved again bit for bit"), "{out}");
    assert_eq!(
        message,
        "couplet: up to 100 rows are proved again; --verify N for another number\n"
    );
}

/// By its name where the record is beside it, and else by that of the folder that it leads to.
#[test]
#[cfg(unix)]
fn a_link_to_a_folder_is_looked_through() {
    use std::os::unix::fs::symlink;
    let scratch = planned("[sample]\ncount = 3\n");
    sweep(&scratch, "out", &[]);
    let home = folder(&scratch, "out");
    let looked = |path: &str| look(path, "0").0;
    symlink(&home, scratch.path("link")).unwrap();
    assert_eq!(looked(&scratch.path("link")), Some(0));
    fs::rename(&home, scratch.path("elsewhere")).unwrap();
    symlink(scratch.path("elsewhere"), &home).unwrap();
    assert_eq!((looked(&home), looked(&format!("{home}/"))), (Some(0), Some(0)));
    assert_eq!(looked(&scratch.path("elsewhere")), Some(2));
}

/// A record of 20 GB, which takes no room on the disk.
#[test]
#[cfg(target_os = "linux")]
fn a_record_that_is_too_large_is_not_read() {
    let scratch = planned("[sample]\ncount = 3\n");
    sweep(&scratch, "out", &[]);
    let (home, whole) = (folder(&scratch, "out"), scratch.path("out"));
    let record = format!("{home}.json");
    let first = fs::read(&record).unwrap();
    let small = |arguments: &[&str]| {
        let line = "ulimit -v 4000000; exec \"$0\" \"$@\"";
        let mut program = std::process::Command::new("sh");
        program.args(["-c", line, env!("CARGO_BIN_EXE_couplet")]).args(arguments);
        said(&program.args(["--threads", "1"]).output().unwrap())
    };
    for size in [(16 << 20) + 1, 20_000_000_000] {
        fs::File::options().write(true).open(&record).unwrap().set_len(size).unwrap();
        let (code, _, message) = small(&["sweep", &home]);
        assert_eq!((code, message.lines().count()), (Some(2), 1), "{message}");
        assert!(message.ends_with("is not the record of a sweep of this version\n"), "{message}");
        // Who has the plan writes the record anew.
        let (code, _, message) = small(&["sweep", &scratch.path("plan.toml"), "-o", &whole]);
        assert_eq!((code, fs::read(&record).unwrap() == first), (Some(0), true), "{message}");
    }
}

#[test]
fn of_many_other_sweeps_some_are_named_and_the_rest_counted() {
    let scratch = planned("[sample]\ncount = 3\n");
    fs::create_dir(scratch.path("out")).unwrap();
    (0..300).for_each(|k| scratch.write(&format!("out/sweep-{k:016x}.json"), "{}"));
    let (code, _, message) = sweep(&scratch, "out", &[]);
    assert_eq!(code, Some(0), "{message}");
    assert!(message.ends_with(", sweep-0000000000000009 and 290 more\n"), "{message}");
    assert!(!message.contains("sweep-000000000000000a"), "{message}");
}

#[test]
fn what_was_forged_is_found() {
    let scratch = planned(
        "chunk = 50\n[grid]\nhalf_opening = 0.5\nfriction = { from = 0.15, to = 0.5, steps = 50 }\n",
    );
    sweep(&scratch, "out", &[]);
    let home = folder(&scratch, "out");
    let looked = || look(&home, "50");
    let (code, out, message) = looked();
    assert_eq!((code, message.as_str()), (Some(0), ""));
    assert!(out.contains("50 rows proved again bit for bit, 20 of them certified"), "{out}");
    let name = files(&scratch, "out").into_keys().next().unwrap();
    let content = fs::read(format!("{home}/{name}")).unwrap();
    let put = |name: &str, content: &[u8]| fs::write(format!("{home}/{name}"), content).unwrap();
    // The name with another hash: the size is the same.
    let named = |content: &[u8]| {
        let hash: String =
            Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect();
        let (rest, _) = name.rsplit_once('-').unwrap();
        format!("{rest}-{}.parquet", &hash[..16])
    };
    // The last bit of a value, in a file with the name of its content.
    let Some(Field::Double(value)) = read(content.clone()).0[49].get("thickness").cloned() else {
        panic!()
    };
    let bytes = value.to_le_bytes();
    let place = content.windows(8).position(|window| window == bytes).unwrap();
    let mut forged = content.clone();
    forged[place] ^= 1;
    fs::remove_file(format!("{home}/{name}")).unwrap();
    put(&named(&forged), &forged);
    let (code, _, message) = looked();
    assert_eq!(code, Some(1));
    assert!(message.contains("its thickness is not what is proved"), "{message}");
    fs::remove_file(format!("{home}/{}", named(&forged))).unwrap();
    // Another content under the name, no part, a part twice, and a part that the sweep does not have.
    put(&name, &forged);
    assert!(looked().2.contains("part 0 is missing or spoiled"));
    fs::remove_file(format!("{home}/{name}")).unwrap();
    assert!(looked().2.contains("part 0 is missing or spoiled"));
    put(&name, &content);
    let mut twice = content.clone();
    // Within the text of what wrote it, at the end.
    let tool = twice.windows(8).rposition(|window| window == b"couplet ").unwrap();
    twice[tool] = b'C';
    put(&named(&twice), &twice);
    assert!(looked().2.contains("does not belong here"));
    let (code, _, message) = sweep(&scratch, "out", &[]);
    assert_eq!(code, Some(2), "{message}");
    assert!(message.contains("another build; take it away"), "{message}");
    fs::rename(
        format!("{home}/{}", named(&twice)),
        format!("{home}/{}", name.replace("-00000000-", "-00000007-")),
    )
    .unwrap();
    assert!(
        looked().2.contains("part-00000007-") && looked().2.contains(" is no part of the sweep")
    );
}

#[test]
fn a_name_tells_what_is_in_a_part_and_what_it_tells_wrong_is_found() {
    let scratch = planned("[grid]\nhalf_opening = 2.3\nfriction = [0.1, 1, 1.2, \"inf\"]\n");
    let (_, first, _) = sweep(&scratch, "out", &[]);
    assert!(first.ends_with("(1 computed, 0 kept): stands 2, falls 2\n"), "{first}");
    let (home, sweep_name) = (folder(&scratch, "out"), sweeps(&scratch, "out").remove(0));
    let (name, content) = files(&scratch, "out").pop_first().unwrap();
    let digits = &sweep_name["sweep-".len()..][..8];
    assert!(
        name.starts_with(&format!("part-00000000-{digits}-2-2-0-0-{}-", content.len())),
        "{name}"
    );
    // A second start does not look into it: what is wrong inside is told from then on.
    let (code, again, _) = sweep(&scratch, "out", &[]);
    assert_eq!(
        (code, again),
        (Some(0), first.replace("(1 computed, 0 kept)", "(0 computed, 1 kept)"))
    );
    for (wrong, is_seen) in [
        (name.replace(digits, "01234567"), true),
        (name.replace("-2-2-0-0-", "-2-3-0-0-"), true),
        (name.replace("-2-2-0-0-", "-3-1-0-0-"), false),
    ] {
        fs::rename(format!("{home}/{name}"), format!("{home}/{wrong}")).unwrap();
        let (code, _, message) = sweep(&scratch, "out", &[]);
        let line = format!(
            "couplet: {home}/{wrong} is a part of another sweep or another build; take it away\n"
        );
        let expected = if is_seen { (Some(2), line.as_str()) } else { (Some(0), "") };
        assert_eq!((code, message.as_str()), expected);
        let (code, _, message) = look(&home, "0");
        assert_eq!(code, Some(1));
        assert!(
            message.starts_with(&format!("couplet: {wrong} does not belong here\n")),
            "{message}"
        );
        fs::rename(format!("{home}/{wrong}"), format!("{home}/{name}")).unwrap();
    }
}

#[test]
fn what_is_no_part_is_named_by_a_second_run_and_by_a_look() {
    let scratch = planned("chunk = 5\n[sample]\ncount = 10\n");
    sweep(&scratch, "out", &[]);
    let (home, whole) = (folder(&scratch, "out"), files(&scratch, "out"));
    let (name, content) = whole.first_key_value().unwrap();
    let is_named = |stray: &str| {
        let (code, out, message) = sweep(&scratch, "out", &[]);
        let line = format!("couplet: {home}/{stray} is no part of the sweep; take it away\n");
        assert_eq!((code, out.as_str(), message), (Some(2), "", line));
        let (code, _, message) = look(&home, "0");
        assert_eq!(code, Some(1));
        assert!(
            message.starts_with(&format!("couplet: {stray} is no part of the sweep\n")),
            "{message}"
        );
    };
    for stray in [
        "copy.parquet",
        "_plan.json",
        &name.replace("-00000000-", "-00000099-"),
        &name.replace("-00000000-", "-0-"),
    ] {
        fs::write(format!("{home}/{stray}"), content).unwrap();
        is_named(stray);
        fs::remove_file(format!("{home}/{stray}")).unwrap();
    }
    fs::remove_file(format!("{home}/{name}")).unwrap();
    fs::create_dir(format!("{home}/{name}")).unwrap();
    is_named(name);
    fs::remove_dir(format!("{home}/{name}")).unwrap();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("nowhere", format!("{home}/{name}")).unwrap();
        is_named(name);
        fs::remove_file(format!("{home}/{name}")).unwrap();
        // A pipe: who opens it waits.
        let made = std::process::Command::new("mkfifo").arg(format!("{home}/{name}")).status();
        assert!(made.unwrap().success());
        is_named(name);
        fs::remove_file(format!("{home}/{name}")).unwrap();
    }
    fs::write(format!("{home}/.hidden"), "").unwrap();
    assert_eq!(sweep(&scratch, "out", &[]).0, Some(0));
}

#[test]
fn a_folder_is_opened_with_its_own_record_of_this_version_alone() {
    let scratch = planned("[sample]\ncount = 10\n");
    sweep(&scratch, "out", &[]);
    let (home, name) = (folder(&scratch, "out"), sweeps(&scratch, "out").remove(0));
    let record = scratch.read(&format!("out/{name}.json"));
    let looked = |home: &str| {
        let (code, out, message) = look(home, "0");
        assert_eq!((code, out.as_str(), message.lines().count()), (Some(2), "", 1), "{message}");
        message
    };
    // A record under the name that it has.
    let named = |record: &str| {
        let hash: String =
            Sha256::digest(record).iter().map(|byte| format!("{byte:02x}")).collect();
        let name = format!("sweep-{}", &hash[..16]);
        scratch.write(&format!("out/{name}.json"), record);
        fs::create_dir_all(scratch.path(&format!("out/{name}"))).unwrap();
        scratch.path(&format!("out/{name}"))
    };
    let version = format!("\"couplet\":\"{}\"", env!("CARGO_PKG_VERSION"));
    let older = named(&record.replace(&version, "\"couplet\":\"0.0.9\""));
    assert!(looked(&older).contains("couplet 0.0.9 began it, and this is "));
    let many = record.replace("\"rows\":10,", "\"rows\":1000000000000000000,");
    assert!(looked(&named(&many)).ends_with("its record contradicts itself\n"));
    scratch.write(&format!("out/{name}.json"), many);
    assert!(looked(&home).contains(&format!("{name}.json is the record of sweep-")));
    fs::remove_file(scratch.path(&format!("out/{name}.json"))).unwrap();
    assert!(looked(&home).contains(&format!("it has no {name}.json beside it")));
    scratch.write(&format!("out/{name}/_plan.json"), &record);
    assert!(looked(&home).contains("move _plan.json beside it, as sweep-"));
    fs::rename(format!("{home}/_plan.json"), format!("{home}.json")).unwrap();
    assert_eq!(look(&home, "0").0, Some(0));
}
