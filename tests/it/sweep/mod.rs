//! `couplet sweep`: the same bytes whoever computes them and whatever happens meanwhile.

mod folder;

use crate::export::parquet::{read, text};
use crate::house::hash;
use crate::program::{Scratch, command, ended, fed, limited, printed, refused, said, start, tells};
use couplet::certify::state::{Answer, Certify};
use couplet::problem::Arch;
use parquet::record::Field;
use rug::Rational;
use std::collections::BTreeMap;
use std::fs;
use std::time::{Duration, Instant};

const HEAD: &str = "schema = \"couplet.sweep/1\"\n";

/// A folder with a plan, whose text is given behind its first line.
fn planned(plan: &str) -> Scratch {
    let scratch = Scratch::new();
    scratch.write("plan.toml", HEAD.to_owned() + plan);
    scratch
}

/// Runs the plan of a folder into `out`, with more arguments, which ends with this exit code; standard output and
/// standard error.
fn sweep(code: i32, scratch: &Scratch, out: &str, more: &[&str]) -> (String, String) {
    let (plan, out) = (scratch.path("plan.toml"), scratch.path(out));
    ended(code, [&["sweep", &plan, "-o", &out], more].concat(), "")
}

/// Looks through a sweep, of which some rows are proved again.
fn look(code: i32, home: &str, rows: &str) -> (String, String) {
    ended(code, ["sweep", home, "--verify", rows], "")
}

/// The names of the sweeps in a folder, each of which has a record.
fn sweeps(scratch: &Scratch, out: &str) -> Vec<String> {
    let names = scratch.files(out).into_iter().filter(|name| !name.starts_with(".couplet-"));
    let (records, folders): (Vec<_>, Vec<_>) = names.partition(|name| name.ends_with(".json"));
    assert_eq!(records, folders.iter().map(|name| format!("{name}.json")).collect::<Vec<_>>());
    folders
}

/// The names and the content of the parts of the only sweep in a folder.
fn files(scratch: &Scratch, out: &str) -> BTreeMap<String, Vec<u8>> {
    let folder = folder(scratch, out);
    let content = |name: String| {
        let content = fs::read(format!("{folder}/{name}")).unwrap();
        (name, content)
    };
    let parts = scratch.files(&format!("{out}/{}", sweeps(scratch, out)[0]));
    assert!(parts.iter().all(|name| name.starts_with("part-")), "{parts:?}");
    parts.into_iter().map(content).collect()
}

/// The path of the only sweep in a folder.
fn folder(scratch: &Scratch, out: &str) -> String {
    let sweeps = sweeps(scratch, out);
    assert_eq!(sweeps.len(), 1, "{sweeps:?}");
    scratch.path(&format!("{out}/{}", sweeps[0]))
}

fn parts(files: &BTreeMap<String, Vec<u8>>) -> Vec<&Vec<u8>> {
    files.values().collect()
}

/// All rows of the only sweep in a folder.
fn rows(scratch: &Scratch, out: &str) -> Vec<BTreeMap<String, Field>> {
    let files = files(scratch, out);
    parts(&files).into_iter().flat_map(|part| read(part.clone()).0).collect()
}

const GRID: &str = "chunk = 24\nquantities = [\"thickness\", \"thrust\", \"sliding_joint\"]\n[grid]\n\
    half_opening = [0.5, \"80deg\", 2.3, 2.62]\nfriction = { from = 0.05, to = 1.2, steps = 12 }\n";

#[test]
fn each_row_of_a_grid_is_what_its_arch_has_alone() {
    let scratch = planned(GRID);
    let (out, _) = sweep(0, &scratch, "out", &[]);
    let told = ": 48 rows in 2 parts (2 computed, 0 kept): stands 24, falls 24\n";
    assert!(out.ends_with(told), "{out}");
    let rows = rows(&scratch, "out");
    let mut sides = [0; 3];
    for (place, row) in rows.iter().enumerate() {
        assert_eq!(row["row"], Field::Long(place as i64));
        let [weight, alpha, mu] = ["weight", "half_opening", "friction"].map(|of| text(&row[of]));
        let arch = Arch::parse(weight, alpha, mu).unwrap();
        let Answer::Stands(state) = arch.certify_alone(40).unwrap() else {
            assert_eq!((text(&row["verdict"]), &row["mode"]), ("falls", &Field::Null));
            assert_eq!((&row["thickness"], &row["thickness_side"]), (&Field::Null, &Field::Null));
            continue;
        };
        assert_eq!((text(&row["verdict"]), text(&row["mode"])), ("stands", state.mode.label()));
        for (name, figure) in [
            ("thickness", Some(&state.thickness)),
            ("thrust", Some(&state.thrust)),
            ("sliding_joint", state.sliding_joint.as_ref()),
        ] {
            let (value, side) = (&row[name], &row[&format!("{name}_side")]);
            let Some(figure) = figure else {
                assert_eq!((value, side), (&Field::Null, &Field::Null));
                continue;
            };
            let (Field::Double(value), Field::Byte(side)) = (value, side) else {
                panic!("{row:?}")
            };
            assert_eq!(value.to_bits(), figure.double.to_bits());
            // Forty digits tell on which side of the double the value is.
            let exact = Rational::from_f64(*value).unwrap();
            let digits = figure.decimal.value.to_rational();
            assert_eq!(*side, digits.cmp(&exact) as i8, "{name} {alpha} {mu}");
            sides[(side + 1) as usize] += 1;
        }
        assert_eq!(row["reason"], Field::Null);
    }
    assert!(sides[0] > 5 && sides[2] > 5, "{sides:?}");
}

#[test]
fn the_bytes_are_the_same_for_one_thread_for_more_and_in_shares() {
    let scratch = planned(GRID);
    sweep(0, &scratch, "one", &["--threads", "1"]);
    sweep(0, &scratch, "more", &["--threads", "3"]);
    for share in ["2/2", "1/2"] {
        sweep(0, &scratch, "shares", &["--only", share]);
    }
    let one = files(&scratch, "one");
    assert_eq!(parts(&one).len(), 2);
    assert_eq!((&files(&scratch, "more"), &files(&scratch, "shares")), (&one, &one));
    let name = sweeps(&scratch, "one")[0].clone();
    let hash = hash(scratch.read(&format!("one/{name}.json")));
    assert_eq!(name, format!("sweep-{}", &hash[..16]), "the name is the hash of the record");
    let (_, notes) = read(parts(&one)[1].clone());
    let told = ["plan", "rows", "schema"].map(|key| &notes[&format!("couplet.{key}")][..]);
    assert_eq!(told, [&hash, "24..48", "couplet.sweep/1"]);
}

#[test]
fn what_is_missing_or_spoiled_is_computed_again_and_nothing_else() {
    let scratch = planned("chunk = 5\n[sample]\ncount = 20\n");
    sweep(0, &scratch, "out", &[]);
    let whole = files(&scratch, "out");
    let names: Vec<&String> = whole.keys().collect();
    let path = |place: usize| format!("{}/{}", folder(&scratch, "out"), names[place]);
    fs::remove_file(path(0)).unwrap();
    // Cut behind the footer's beginning, and a byte in the middle.
    let content = &whole[names[1]];
    fs::write(path(1), &content[..content.len() - 9]).unwrap();
    let mut content = whole[names[2]].clone();
    content[60] ^= 1;
    fs::write(path(2), &content).unwrap();
    let before = fs::metadata(path(3)).unwrap().modified().unwrap();
    let (out, _) = sweep(0, &scratch, "out", &[]);
    // A size is seen, and a content that has it is read where that is asked.
    assert!(out.contains("(2 computed, 2 kept)"), "{out}");
    assert_ne!(files(&scratch, "out"), whole);
    let (out, _) = sweep(0, &scratch, "out", &["--verify", "0"]);
    assert!(out.contains("(1 computed, 3 kept)"), "{out}");
    assert_eq!(files(&scratch, "out"), whole);
    assert_eq!(fs::metadata(path(3)).unwrap().modified().unwrap(), before);
}

/// A part that is not held in memory as a whole has several row groups, each of whole half openings.
#[test]
fn a_large_part_has_row_groups_and_is_looked_through_group_by_group() {
    let scratch = planned(
        "chunk = 600_000\n[grid]\nhalf_opening = [0.5, 0.6, 0.7, 0.8, 1, 2]\nfriction = { from = 0.1, to = 1, steps = 100_000 }\n",
    );
    sweep(0, &scratch, "out", &["--threads", "1"]);
    let files = files(&scratch, "out");
    let groups = crate::export::parquet::groups(parts(&files)[0].clone());
    let half_opening = |group: &[(String, f64, f64)]| {
        group.iter().find(|(name, ..)| name == "half_opening_rad").map(|of| (of.1, of.2))
    };
    let found: Vec<_> = groups.iter().map(|group| half_opening(group)).collect();
    assert_eq!(found, [Some((0.5, 1.0)), Some((2.0, 2.0))]);
    let (out, message) = look(0, &folder(&scratch, "out"), "3");
    assert_eq!(message, "");
    tells(&out, ["600000 rows in 1 part are there"]);
}

#[test]
fn more_than_a_thousand_parts_are_in_folders_of_a_thousand() {
    let scratch = planned(
        "chunk = 1\n[grid]\nhalf_opening = 1\nfriction = { from = 0.3, to = 0.5, steps = 1001 }\n",
    );
    sweep(0, &scratch, "out", &[]);
    let home = folder(&scratch, "out");
    let name = sweeps(&scratch, "out").remove(0);
    let names = |folder: &str| scratch.files(&format!("out/{name}/{folder}"));
    let last = names("001");
    assert_eq!(names(""), ["000", "001"]);
    assert_eq!((names("000").len(), last.len()), (1000, 1));
    assert!(last[0].starts_with("part-00001000-"), "{last:?}");
    fs::remove_file(format!("{home}/001/{}", last[0])).unwrap();
    tells(&sweep(0, &scratch, "out", &[]).0, ["(1 computed, 1000 kept)"]);
    tells(&look(0, &home, "0").0, ["1001 rows in 1001 parts are there"]);
    // A part in the folder of others, a file that is no folder, and a folder that is not needed.
    fs::rename(format!("{home}/001/{}", last[0]), format!("{home}/000/{}", last[0])).unwrap();
    fs::remove_dir(format!("{home}/001")).unwrap();
    fs::write(format!("{home}/001"), "").unwrap();
    fs::create_dir(format!("{home}/002")).unwrap();
    let (_, message) = look(1, &home, "0");
    let strays = [&format!("000/{}", last[0]), "001", "002"];
    tells(&message, strays.map(|stray| format!("couplet: {stray} is no part of the sweep\n")));
}

#[test]
fn nothing_is_lost_when_a_worker_is_killed() {
    let scratch = planned("chunk = 60\n[sample]\ncount = 1200\n");
    let (plan, out) = (scratch.path("plan.toml"), scratch.path("out"));
    let share =
        |share: &str| start(["sweep", &plan, "-o", &out, "--only", share, "--threads", "1"]);
    let (mut killed, other) = (share("1/2"), share("2/2"));
    let begun = Instant::now();
    let is_begun = || {
        let sweeps = scratch.files("out");
        let folder = sweeps.iter().find(|name| name.starts_with("sweep-"));
        let names = folder.map(|name| scratch.files(&format!("out/{name}"))).unwrap_or_default();
        // A part of an even number is of the first share.
        let of_first =
            |name: &String| name.as_bytes().get(12).is_some_and(|c| (c - b'0').is_multiple_of(2));
        names.iter().filter(|name| name.starts_with("part-")).any(of_first)
    };
    while !is_begun() && begun.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(2));
    }
    killed.kill().unwrap();
    killed.wait().unwrap();
    assert_eq!(other.wait_with_output().unwrap().status.code(), Some(0));
    let (out, _) = sweep(0, &scratch, "out", &["--verify", "5"]);
    tells(&out, ["1200 rows in 20 parts are there and as the plan asks; 5 rows proved again"]);
    sweep(0, &scratch, "fresh", &[]);
    // What the killed one was writing, if it was, is beside the folder, and cleared after an hour.
    assert_eq!(files(&scratch, "out"), files(&scratch, "fresh"));
}

#[test]
#[cfg(unix)]
fn a_full_disk_is_one_line_and_leaves_nothing_half_written() {
    let scratch = planned("chunk = 200\n[sample]\ncount = 200\n");
    // No file may have more than 8 blocks of 512 bytes or a kilobyte, as the shell has it; a part has more.
    let (plan, out) = (scratch.path("plan.toml"), scratch.path("out"));
    let asked = ["sweep", &plan, "-o", &out, "--threads", "1"];
    let (code, out, message) = said(&limited("trap '' XFSZ; ulimit -f 8", asked));
    assert_eq!((code, out.as_str()), (Some(3), ""), "{message}");
    assert!(message.starts_with("couplet: cannot write "), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(files(&scratch, "out").is_empty() && scratch.files("out").len() == 2);
    sweep(0, &scratch, "out", &[]);
}

#[test]
fn another_plan_is_another_sweep_and_the_first_stays() {
    let scratch = planned(GRID);
    sweep(0, &scratch, "out", &[]);
    let first = files(&scratch, "out");
    let name = sweeps(&scratch, "out")[0].clone();
    scratch.write("plan.toml", HEAD.to_owned() + &GRID.replace("2.62", "2.63"));
    let (_, message) = sweep(0, &scratch, "out", &[]);
    tells(&message, ["other sweeps stay as they are", &name]);
    assert_eq!(sweeps(&scratch, "out").len(), 2);
    for (file, content) in &first {
        assert_eq!(&fs::read(scratch.path(&format!("out/{name}/{file}"))).unwrap(), content);
    }
    // The first plan in other words finds its parts.
    let words = "# As before.\n".to_owned() + HEAD + &GRID.replace("0.05", "\"0.05\"");
    scratch.write("plan.toml", words);
    let (out, _) = sweep(0, &scratch, "out", &[]);
    tells(&out, [format!("{name}: 48 rows in 2 parts (0 computed, 2 kept)")]);
}

#[test]
fn a_sample_is_what_the_command_draws() {
    let scratch = planned("chunk = 700\n[sample]\ncount = 1001\nseed = 5\nhard = true\n");
    sweep(0, &scratch, "out", &["--only", "2/2"]);
    let rows = rows(&scratch, "out");
    let drawn = |seed: &str, count: &str| {
        let sample = printed(["sample", "--hard", "--seed", seed, "--count", count]);
        sample.lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
    };
    let sample = [drawn("5", "1000"), drawn("6", "1")].concat();
    assert_eq!(rows.len(), 301);
    for (row, line) in rows.iter().zip(&sample[700..]) {
        let cells = [text(&row["weight"]), text(&row["half_opening"]), text(&row["friction"])];
        assert!(line.contains(&cells.join(",")), "{line} is not {cells:?}");
    }
}

const TABLE: &str =
    "id;alpha;mu\n1;80deg;0,6\n2;x;1\n3;1,2;\n4;\"1.3\n\";1\n\n5;2,5;inf\n6;1\n7;1;35deg\n";

#[test]
fn a_bad_row_is_a_row_and_a_bad_file_is_named() {
    let scratch = planned(
        "chunk = 2\n[data]\nfiles = [\"a.csv\", \"none.csv\", \"numpy.txt\", \"json\", \"thick\"]\n",
    );
    scratch.write("a.csv", TABLE);
    scratch.write("numpy.txt", "# alpha mu\n0.5 0.6\n# A remark.\n\n1 nan\n1.5 0.7\n");
    scratch.write("json", "[{\"alpha\": 1}]");
    scratch.write("thick", "alpha,mu,eta\n1,1,1\n");
    let (out, message) = sweep(2, &scratch, "out", &[]);
    assert!(out.contains("10 rows in 6 parts (6 computed, 0 kept): stands 6, refused 4"), "{out}");
    let lines: Vec<&str> = message.lines().collect();
    assert_eq!(lines[0], "couplet: none.csv: no such file or folder");
    assert!(lines[1].starts_with("couplet: json: it is JSON"), "{message}");
    assert!(lines[2].contains("thick"), "{message}");
    assert_eq!(lines[3], "couplet: 3 files or pieces could not be read; the rest is there");
    let rows = rows(&scratch, "out");
    for (place, (file, line, why)) in [
        ("a.csv", 2, ""),
        ("a.csv", 3, "'x' is not a number"),
        ("a.csv", 4, "the friction is empty"),
        ("a.csv", 5, ""),
        ("a.csv", 8, ""),
        ("a.csv", 9, "2 fields where the header has 3"),
        ("a.csv", 10, ""),
        ("numpy.txt", 2, ""),
        ("numpy.txt", 5, "'nan' is not a friction"),
        ("numpy.txt", 6, ""),
    ]
    .into_iter()
    .enumerate()
    {
        let row = &rows[place];
        let verdict = if why.is_empty() { "stands" } else { "refused" };
        assert_eq!((text(&row["file"]), text(&row["verdict"])), (file, verdict), "{row:?}");
        let reason = text(&row["reason"]);
        assert!(reason.starts_with(why) && reason.is_empty() == why.is_empty(), "{row:?}");
        assert_eq!((&row["row"], &row["line"]), (&Field::Long(place as i64), &Field::Long(line)));
    }
    assert_eq!(rows.len(), 10);
    assert_eq!(text(&rows[0]["friction"]), "0.6");
    assert_eq!(text(&rows[1]["half_opening"]), "x");
    // Another content of the same file is another sweep; and an opened one does not read it.
    scratch.write("a.csv", TABLE.replace("80deg", "81deg"));
    sweep(2, &scratch, "out", &[]);
    assert_eq!(sweeps(&scratch, "out").len(), 2);
}

#[test]
fn a_file_that_changes_meanwhile_is_named_and_the_rest_goes_on() {
    let scratch = planned("chunk = 1\n[data]\nfiles = [\"a.csv\", \"b.csv\"]\n");
    for name in ["a.csv", "b.csv"] {
        scratch.write(name, "alpha,mu\n1,1\n2,1\n");
    }
    sweep(0, &scratch, "out", &[]);
    scratch.write("a.csv", "alpha,mu\n1,1\n2,3\n");
    let mut look = command(["sweep", &folder(&scratch, "out")]);
    let (code, out, message) = said(&look.current_dir(scratch.folder()).output().unwrap());
    assert_eq!(code, Some(1));
    tells(&message, ["a.csv: it has changed since the sweep began"]);
    tells(&out, ["3 rows in 3 parts are there"]);
}

#[test]
fn lines_of_json_are_a_table_and_what_is_no_text_is_refused_with_what_reads_it() {
    let scratch = planned("chunk = 2\n[data]\nfiles = [\"in.jsonl\", \"in.parquet\"]\n");
    let states = "alpha,mu\n0.5,0.6\n1/3,inf\n1.5,tan(35deg)\n";
    let written = |format| fed(["states", "--format", format], states).stdout;
    scratch.write("in.jsonl", written("jsonl"));
    scratch.write("in.parquet", written("parquet"));
    let (out, message) = sweep(2, &scratch, "out", &[]);
    assert!(out.contains("3 rows in 2 parts (2 computed, 0 kept): stands 3\n"), "{out}");
    let line = "couplet: in.parquet: it is Parquet; a sweep reads CSV and JSON lines (docs/sweeps.md), and \
                couplet.add_states of Python proves tables of pandas, polars and pyarrow (docs/python.md)\n";
    assert!(message.starts_with(line), "{message}");
    let rows = rows(&scratch, "out");
    let third = rows.iter().find(|row| text(&row["half_opening"]) == "1/3").unwrap();
    assert_eq!((text(&third["friction"]), &third["line"]), ("inf", &Field::Long(2)));
}

#[test]
fn a_plan_without_a_file_that_can_be_read_has_no_rows() {
    let scratch = planned("[data]\nfiles = [\"none.csv\"]\n");
    let (out, message) = sweep(2, &scratch, "out", &[]);
    assert!(out.ends_with(": 0 rows in 0 parts (0 computed, 0 kept)\n"), "{out}");
    assert!(message.starts_with("couplet: none.csv: no such file or folder\n"), "{message}");
}

#[test]
fn a_sweep_of_too_many_parts_is_refused_before_it_begins() {
    let scratch = planned("chunk = 1\n[sample]\ncount = 10_000_000_000\n");
    let (_, message) = sweep(2, &scratch, "out", &[]);
    let line = "couplet: a sweep has at most 1000000 parts, and this would have 10000000000: give a larger chunk\n";
    assert_eq!(message, line);
}

#[test]
fn more_digits_are_there_as_text() {
    let scratch = planned("digits = 20\n[grid]\nhalf_opening = \"80deg\"\nfriction = \"inf\"\n");
    sweep(0, &scratch, "out", &[]);
    let row = &rows(&scratch, "out")[0];
    let state = printed("state --alpha 80deg --mu inf --digits 20 --quantity eta --plain");
    assert_eq!(text(&row["thickness_text"]), state.trim());
    assert_eq!(row["friction_double"], Field::Double(f64::INFINITY));
}

#[test]
fn faults_of_a_plan_are_told_with_their_places() {
    let scratch = planned("weight = \"heymann\"\n[grid]\nhalf_opening = 1\n");
    let (_, message) = sweep(2, &scratch, "out", &[]);
    let faults = [
        "plan.toml:2:10: weight \"heymann\" is not one of",
        "plan.toml:3:1: friction (or friction_angle) is missing",
    ];
    tells(&message, faults);
    assert!(message.ends_with("plan.toml has 2 errors; nothing was computed\n"), "{message}");
    assert!(scratch.files("out").is_empty());
    refused(["sweep", &scratch.path(""), "-o", "x"], "", "--output belongs to a plan");
}

#[test]
fn the_plans_of_the_page_are_plans() {
    let page = include_str!("../../../docs/sweeps.md");
    let plans: Vec<&str> =
        page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert_eq!(plans.len(), 3);
    for plan in plans.into_iter().chain([&*printed("sweep --schema")]) {
        assert!(couplet::scene::read_sweep(plan.as_bytes()).is_ok(), "{plan}");
    }
}

/// A plan that asks for it gets it, alone and beside rows that share their proofs; one that does not has the rows
/// it had.
#[test]
fn the_asymmetric_thickness_is_there_if_it_is_asked() {
    let grid = "[grid]\nhalf_opening = [1.5, 2.3]\nfriction = [0.9, 1.03, 1.05, 1.07, 1.2]\n";
    let scratch =
        planned(&format!("quantities = [\"thickness\", \"asymmetric_thickness\"]\n{grid}"));
    sweep(0, &scratch, "out", &[]);
    sweep(0, &scratch, "out", &["--verify", "10"]);
    let all = rows(&scratch, "out");
    for (place, row) in all.iter().enumerate() {
        let eta = &row["asymmetric_thickness"];
        assert_eq!(matches!(eta, Field::Double(_)), (6..9).contains(&place), "{row:?}");
    }
    assert_eq!(all[7]["asymmetric_thickness"], Field::Double(0.583_084_449_604_488_7));
    let without = planned(grid);
    sweep(0, &without, "out", &[]);
    assert!(!rows(&without, "out")[0].contains_key("asymmetric_thickness"));
}
