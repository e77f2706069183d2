//! Reading from TOML to the plan of a sweep, `couplet.sweep/1`, or to everything that is wrong with it. Keys may be
//! added, none changes its meaning.

use super::axes::axes;
use super::fault::Fault;
use super::sweep_record::{
    DataFile, MAX_CHUNK, MAX_SAMPLE, SWEEP_DIGITS, SWEEP_SCHEMA, SweepArches, SweepRecord, VERSION,
};
use super::table::TableReader;
use super::value::{Entry, TomlReader};
use crate::arch::SelfWeight;
use crate::ask::{ArchGiven, ArchQuestion};
use crate::certify::MAX_DIGITS;
use crate::problem::Quantity;
use toml::de::{DeTable, DeValue};

/// A plan with every key and what it means, which is itself a plan.
pub const SWEEP_EXAMPLE: &str = include_str!("sweep.toml");

/// The arches of one weight, and how many they are.
type OfOneWeight = (u64, SweepArches);

/// The kinds of arches, of which a plan has one: the table, its keys, and its reader.
const KINDS: [Kind; 3] = [
    ("grid", &["half_opening", "friction", "friction_angle"], grid),
    ("sample", &["count", "seed", "hard"], sample),
    ("data", &["files"], data),
];
type Kind = (&'static str, &'static [&'static str], fn(&mut TableReader) -> Option<OfOneWeight>);

const KEYS: [&str; 8] =
    ["schema", "weight", "quantities", "digits", "chunk", "grid", "sample", "data"];

/// Reads a plan from a file's bytes: the record of its sweep as far as the plan tells it, and remarks on what is swept
/// all the same. Nothing is computed; the faults are all there are, in the order of the file.
pub fn read_sweep(bytes: &[u8]) -> Result<(SweepRecord, Vec<Fault>), Vec<Fault>> {
    TomlReader::file(bytes, "a plan", SWEEP_SCHEMA, plan)
}

fn plan(reader: &mut TomlReader, root: &DeTable) -> Option<SweepRecord> {
    reader.unknown_keys(root, "a plan", &KEYS);
    let mut table = TableReader { reader, span: 0..0, table: root };
    let given = table.if_given("weight", TomlReader::weights);
    let quantities = match table.get("quantities") {
        None => Some(vec![Quantity::Thickness]),
        Some(_) => table.quantities(&Quantity::STATE_ROW),
    };
    let digits =
        table.or("digits", SWEEP_DIGITS, |reader, at| reader.whole(at, SWEEP_DIGITS..=MAX_DIGITS));
    let chunk = table.or("chunk", 0, |reader, at| reader.whole(at, 1..=MAX_CHUNK));
    let (kind, arches) = arches(&mut table)?;
    let given = given?;
    table.span = table.get("weight").map_or(0..0, |value| value.span());
    match (&given, kind) {
        (Some(_), "sample") => table.refuse("a sample draws its own weights; leave weight out")?,
        (Some(all), "data") if all.len() > 1 => {
            table.refuse("a data set has one weight, that of the rows without one")?
        }
        _ => {}
    }
    let (weights, (count, arches)) = (given.unwrap_or(vec![SelfWeight::Milankovitch]), arches?);
    Some(SweepRecord {
        schema: SWEEP_SCHEMA.to_owned(),
        couplet: VERSION.to_owned(),
        quantities: quantities?,
        digits: digits?,
        rows: weights.len() as u64 * count,
        chunk: chunk? as u64,
        weights,
        arches,
    })
}

/// The kind of the arches, and the arches if nothing is wrong with them.
fn arches(plan: &mut TableReader) -> Option<(&'static str, Option<OfOneWeight>)> {
    let there = KINDS.into_iter().filter_map(|kind| Some((kind, plan.get(kind.0)?)));
    let ((kind, keys, read), value) = match there.collect::<Vec<_>>()[..] {
        [one] => one,
        [] => return plan.refuse("the plan has no arches; give [grid], [sample] or [data]"),
        [_, (_, value), ..] => {
            let message = "a plan has one of [grid], [sample] and [data]";
            return plan.reader.refuse(value.span(), message);
        }
    };
    let DeValue::Table(table) = value.get_ref() else {
        return plan.reader.reject((kind, value), &format!("a table [{kind}]"));
    };
    let mut table = TableReader { reader: plan.reader, span: value.span(), table };
    table.reader.unknown_keys(table.table, &format!("[{kind}]"), keys);
    Some((kind, read(&mut table)))
}

fn grid(table: &mut TableReader) -> Option<OfOneWeight> {
    let (mut half_opening, mut friction) = (Vec::new(), Vec::new());
    for axis in axes(table, Some(&ArchQuestion::ANY), false)? {
        for part in axis.parts(table) {
            let of: ArchGiven = part?;
            half_opening.extend(of.half_opening);
            friction.extend(of.friction);
        }
    }
    table.remark_on(&friction);
    let count = half_opening.len() as u64 * friction.len() as u64;
    Some((count, SweepArches::Grid { half_opening, friction }))
}

fn sample(table: &mut TableReader) -> Option<OfOneWeight> {
    let count = match table.get("count") {
        Some(value) => table.reader.whole(("count", value), 1..=MAX_SAMPLE),
        None => table.refuse("count is missing; give a whole number"),
    };
    let seed = table.or("seed", 1, |reader, at| reader.whole(at, 0..=usize::MAX >> 1));
    let hard = table.truth("hard");
    Some((count? as u64, SweepArches::Sample { seed: seed? as u64, hard: hard? }))
}

fn data(table: &mut TableReader) -> Option<OfOneWeight> {
    let Some(value) = table.get("files") else {
        return table.refuse("files is missing; give paths, as \"arches.csv\"");
    };
    let read = |reader: &mut TomlReader, at| path(reader, at).map(|path| (path.clone(), path));
    let files = table.reader.each_once(("files", value), "paths of files", read);
    let file = |file: String| DataFile { file, ..DataFile::default() };
    files.map(|all| (0, SweepArches::Data { files: all.into_iter().map(file).collect() }))
}

fn path(reader: &mut TomlReader, at: Entry) -> Option<String> {
    let text = reader.text(at)?;
    match text.is_empty() || text.contains(char::is_control) {
        true => reader.reject(at, "the path of a file"),
        false => Some(text.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(text: &str) -> String {
        let faults = read_sweep(text.as_bytes()).err().unwrap();
        let line = |fault: &Fault| format!("{}: {}", fault.place.line, fault.message);
        faults.iter().map(line).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn the_example_is_a_plan_whichever_table_it_has() {
        let (plan, _) = read_sweep(SWEEP_EXAMPLE.as_bytes()).unwrap();
        let SweepArches::Grid { half_opening, friction } = plan.arches else { panic!() };
        assert_eq!((half_opening.len(), friction.len()), (40, 100));
        assert_eq!((plan.rows, plan.chunk), (4000, 4000));
        assert_eq!(half_opening[39].to_string(), "140deg");
        let head = "schema = \"couplet.sweep/1\"\n";
        for table in ["sample", "data"] {
            let lines = SWEEP_EXAMPLE.lines().skip_while(|line| *line != format!("# [{table}]"));
            let lines = lines.take_while(|line| !line.is_empty());
            let lines: Vec<&str> = lines.map(|line| line.trim_start_matches("# ")).collect();
            let (plan, _) = read_sweep((head.to_owned() + &lines.join("\n")).as_bytes()).unwrap();
            match plan.arches {
                SweepArches::Sample { seed, hard } => {
                    assert_eq!((plan.rows, seed, hard), (1_000_000, 1, false));
                }
                SweepArches::Data { files } => assert_eq!(files.len(), 2),
                SweepArches::Grid { .. } => panic!("{table}"),
            }
        }
    }

    /// A path and a value of an axis count once, and that is told.
    #[test]
    fn what_is_listed_twice_counts_once() {
        let read = |rest: &str| {
            read_sweep(format!("schema = \"couplet.sweep/1\"\n{rest}").as_bytes()).unwrap()
        };
        let (plan, notes) = read("[data]\nfiles = [\"a\", \"a\"]\n");
        assert!(matches!(&plan.arches, SweepArches::Data { files } if files.len() == 1));
        assert_eq!(notes[0].message, "files \"a\" is listed twice and counts once");
        let (plan, notes) = read(
            "[grid]\nhalf_opening = [1, \"1.0\"]\nfriction = [\"31deg\", 1, \"tan(31deg)\"]\n",
        );
        let SweepArches::Grid { half_opening, friction } = plan.arches else { panic!() };
        let friction: Vec<String> = friction.iter().map(ToString::to_string).collect();
        assert_eq!((half_opening.len(), friction), (1, vec!["tan(31deg)".into(), "1".into()]));
        assert_eq!(notes.len(), 2);
    }

    #[test]
    fn every_fault_of_a_plan_is_told() {
        let head = "schema = \"couplet.sweep/1\"\n";
        for (rest, words) in [
            ("", "the plan has no arches; give [grid], [sample] or [data]"),
            ("[grid]\nfriction = 1\n", "2: half_opening is missing"),
            (
                "[grid]\nhalf_opening = 4\nfriction = 1\n",
                "3: the half opening 4 is not between 0 and pi",
            ),
            ("[sample]\ncount = 0\n", "3: count 0 is not a whole number from 1"),
            ("[sample]\nseed = 1\n", "2: count is missing"),
            ("weight = \"heyman\"\n[sample]\ncount = 9\n", "2: a sample draws its own weights"),
            ("weight = \"both\"\n[data]\nfiles = \"a\"\n", "2: a data set has one weight"),
            ("digits = 16\n[sample]\ncount = 9\n", "2: digits 16 is not a whole number from 17"),
            ("[sample]\ncount = 9\n[data]\nfiles = \"a\"\n", "4: a plan has one of"),
            (
                "chunks = 3\n[sample]\ncount = 9\n",
                "unknown key \"chunks\" in a plan (did you mean \"chunk\"?)",
            ),
            (
                "quantities = \"safety\"\n[sample]\ncount = 9\n",
                "2: quantities \"safety\" is not one of",
            ),
        ] {
            let found = faults(&(head.to_owned() + rest));
            assert!(found.contains(words), "{found}");
        }
        assert!(faults("[sample]\ncount = 9\n").contains("schema is missing; a plan has schema ="));
        assert!(faults("schema = \"couplet.sweep/2\"\n").contains("is not one that is read here"));
        assert!(faults("schema = ").contains("not TOML"));
    }
}
