//! The folder of a sweep: what is in it and does not belong there, and with which record it is opened.

use super::{files, folder, look, planned, sweep, sweeps};
use crate::export::parquet::read;
use crate::house::hash;
use crate::program::{ended, limited, said, tells};
use parquet::record::Field;
use std::fs;

#[test]
fn a_folder_is_looked_through_with_a_hundred_rows_and_says_so() {
    let scratch =
        planned("[grid]\nhalf_opening = 1\nfriction = { from = 0.3, to = 0.5, steps = 150 }\n");
    sweep(0, &scratch, "out", &[]);
    let (out, message) = ended(0, ["sweep", &folder(&scratch, "out")], "");
    tells(&out, ["; 100 rows proved again bit for bit"]);
    let told = "couplet: up to 100 rows are proved again; --verify N for another number\n";
    assert_eq!(message, told);
}

/// By its name where the record is beside it, and else by that of the folder that it leads to.
#[test]
#[cfg(unix)]
fn a_link_to_a_folder_is_looked_through() {
    use std::os::unix::fs::symlink;
    let scratch = planned("[sample]\ncount = 3\n");
    sweep(0, &scratch, "out", &[]);
    let home = folder(&scratch, "out");
    symlink(&home, scratch.path("link")).unwrap();
    look(0, &scratch.path("link"), "0");
    fs::rename(&home, scratch.path("elsewhere")).unwrap();
    symlink(scratch.path("elsewhere"), &home).unwrap();
    look(0, &home, "0");
    look(0, &format!("{home}/"), "0");
    look(2, &scratch.path("elsewhere"), "0");
}

/// A record of 20 GB, which takes no room on the disk.
#[test]
#[cfg(target_os = "linux")]
fn a_record_that_is_too_large_is_not_read() {
    let scratch = planned("[sample]\ncount = 3\n");
    sweep(0, &scratch, "out", &[]);
    let (home, whole) = (folder(&scratch, "out"), scratch.path("out"));
    let record = format!("{home}.json");
    let first = fs::read(&record).unwrap();
    let small = |arguments: &[&str]| {
        said(&limited("ulimit -v 4000000", [arguments, &["--threads", "1"]].concat()))
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
    let (_, message) = sweep(0, &scratch, "out", &[]);
    assert!(message.ends_with(", sweep-0000000000000009 and 290 more\n"), "{message}");
    assert!(!message.contains("sweep-000000000000000a"), "{message}");
}

#[test]
fn what_was_forged_is_found() {
    let scratch = planned(
        "chunk = 50\n[grid]\nhalf_opening = 0.5\nfriction = { from = 0.15, to = 0.5, steps = 50 }\n",
    );
    sweep(0, &scratch, "out", &[]);
    let home = folder(&scratch, "out");
    let (out, message) = look(0, &home, "50");
    assert_eq!(message, "");
    tells(&out, ["50 rows proved again bit for bit, 20 of them certified"]);
    let finds = |words: &[&str]| tells(&look(1, &home, "50").1, words);
    let (name, content) = files(&scratch, "out").pop_first().unwrap();
    let put = |name: &str, content: &[u8]| fs::write(format!("{home}/{name}"), content).unwrap();
    let remove = |name: &str| fs::remove_file(format!("{home}/{name}")).unwrap();
    // The name with another hash: the size is the same.
    let named = |content: &[u8]| {
        format!("{}-{}.parquet", name.rsplit_once('-').unwrap().0, &hash(content)[..16])
    };
    // The last bit of a value, in a file with the name of its content.
    let Field::Double(value) = read(content.clone()).0[49]["thickness"] else { panic!() };
    let bytes = value.to_le_bytes();
    let place = content.windows(8).position(|window| window == bytes).unwrap();
    let mut forged = content.clone();
    forged[place] ^= 1;
    remove(&name);
    put(&named(&forged), &forged);
    finds(&["its thickness is not what is proved"]);
    remove(&named(&forged));
    // Another content under the name, no part, a part twice, and a part that the sweep does not have.
    put(&name, &forged);
    finds(&["part 0 is missing or spoiled"]);
    remove(&name);
    finds(&["part 0 is missing or spoiled"]);
    put(&name, &content);
    let mut twice = content.clone();
    // Within the text of what wrote it, at the end.
    let tool = twice.windows(8).rposition(|window| window == b"couplet ").unwrap();
    twice[tool] = b'C';
    put(&named(&twice), &twice);
    finds(&["does not belong here"]);
    tells(&sweep(2, &scratch, "out", &[]).1, ["another build; take it away"]);
    remove(&named(&twice));
    put(&name.replace("-00000000-", "-00000007-"), &twice);
    finds(&["part-00000007-", " is no part of the sweep"]);
}

#[test]
fn a_name_tells_what_is_in_a_part_and_what_it_tells_wrong_is_found() {
    let scratch = planned("[grid]\nhalf_opening = 2.3\nfriction = [0.1, 1, 1.2, \"inf\"]\n");
    let (first, _) = sweep(0, &scratch, "out", &[]);
    assert!(first.ends_with("(1 computed, 0 kept): stands 2, falls 2\n"), "{first}");
    let (home, sweep_name) = (folder(&scratch, "out"), sweeps(&scratch, "out").remove(0));
    let (name, content) = files(&scratch, "out").pop_first().unwrap();
    let digits = &sweep_name["sweep-".len()..][..8];
    let begins = format!("part-00000000-{digits}-2-2-0-0-{}-", content.len());
    assert!(name.starts_with(&begins), "{name}");
    // A second start does not look into it: what is wrong inside is told from then on.
    let (again, _) = sweep(0, &scratch, "out", &[]);
    assert_eq!(again, first.replace("(1 computed, 0 kept)", "(0 computed, 1 kept)"));
    for (wrong, code) in [
        (name.replace(digits, "01234567"), 2),
        (name.replace("-2-2-0-0-", "-2-3-0-0-"), 2),
        (name.replace("-2-2-0-0-", "-3-1-0-0-"), 0),
    ] {
        let [right_path, path] = [&name, &wrong].map(|name| format!("{home}/{name}"));
        fs::rename(&right_path, &path).unwrap();
        let line =
            format!("couplet: {path} is a part of another sweep or another build; take it away\n");
        let (_, message) = sweep(code, &scratch, "out", &[]);
        assert_eq!(message, if code == 2 { line.as_str() } else { "" });
        let (_, message) = look(1, &home, "0");
        let line = format!("couplet: {wrong} does not belong here\n");
        assert!(message.starts_with(&line), "{message}");
        fs::rename(path, right_path).unwrap();
    }
}

#[test]
fn what_is_no_part_is_named_by_a_second_run_and_by_a_look() {
    let scratch = planned("chunk = 5\n[sample]\ncount = 10\n");
    sweep(0, &scratch, "out", &[]);
    let (home, whole) = (folder(&scratch, "out"), files(&scratch, "out"));
    let (name, content) = whole.first_key_value().unwrap();
    let is_named = |stray: &str| {
        let said = format!("{stray} is no part of the sweep");
        let line = format!("couplet: {home}/{said}; take it away\n");
        assert_eq!(sweep(2, &scratch, "out", &[]), (String::new(), line));
        let (_, message) = look(1, &home, "0");
        assert!(message.starts_with(&format!("couplet: {said}\n")), "{message}");
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
    let part = format!("{home}/{name}");
    fs::remove_file(&part).unwrap();
    fs::create_dir(&part).unwrap();
    is_named(name);
    fs::remove_dir(&part).unwrap();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("nowhere", &part).unwrap();
        is_named(name);
        fs::remove_file(&part).unwrap();
        // A pipe: who opens it waits.
        assert!(std::process::Command::new("mkfifo").arg(&part).status().unwrap().success());
        is_named(name);
        fs::remove_file(&part).unwrap();
    }
    fs::write(format!("{home}/.hidden"), "").unwrap();
    sweep(0, &scratch, "out", &[]);
}

#[test]
fn a_folder_is_opened_with_its_own_record_of_this_version_alone() {
    let scratch = planned("[sample]\ncount = 10\n");
    sweep(0, &scratch, "out", &[]);
    let (home, name) = (folder(&scratch, "out"), sweeps(&scratch, "out").remove(0));
    let record = scratch.read(&format!("out/{name}.json"));
    let looked = |home: &str| {
        let (out, message) = look(2, home, "0");
        assert_eq!((out.as_str(), message.lines().count()), ("", 1), "{message}");
        message
    };
    // A record under the name that it has.
    let named = |record: &str| {
        let name = format!("sweep-{}", &hash(record)[..16]);
        scratch.write(&format!("out/{name}.json"), record);
        fs::create_dir_all(scratch.path(&format!("out/{name}"))).unwrap();
        scratch.path(&format!("out/{name}"))
    };
    let version = format!("\"couplet\":\"{}\"", env!("CARGO_PKG_VERSION"));
    let older = named(&record.replace(&version, "\"couplet\":\"0.0.9\""));
    tells(&looked(&older), ["couplet 0.0.9 began it, and this is "]);
    let many = record.replace("\"rows\":10,", "\"rows\":1000000000000000000,");
    assert!(looked(&named(&many)).ends_with("its record contradicts itself\n"));
    scratch.write(&format!("out/{name}.json"), many);
    assert!(looked(&home).contains(&format!("{name}.json is the record of sweep-")));
    fs::remove_file(scratch.path(&format!("out/{name}.json"))).unwrap();
    assert!(looked(&home).contains(&format!("it has no {name}.json beside it")));
    scratch.write(&format!("out/{name}/_plan.json"), &record);
    assert!(looked(&home).contains("move _plan.json beside it, as sweep-"));
    fs::rename(format!("{home}/_plan.json"), format!("{home}.json")).unwrap();
    look(0, &home, "0");
}
