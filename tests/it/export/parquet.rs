//! Parquet files, read back.

use super::expected::{all, of};
use crate::program::{Scratch, fed};
use parquet::basic::ColumnOrder;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::statistics::Statistics;
use parquet::record::{Field, Row};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;

fn opened(file: Vec<u8>) -> SerializedFileReader<File> {
    let scratch = Scratch::new();
    scratch.write("table.parquet", file);
    SerializedFileReader::new(File::open(scratch.path("table.parquet")).unwrap()).unwrap()
}

/// The rows by column, and the metadata.
pub(crate) fn read(file: Vec<u8>) -> (Vec<BTreeMap<String, Field>>, BTreeMap<String, String>) {
    let reader = opened(file);
    let notes = reader.metadata().file_metadata().key_value_metadata().unwrap();
    let notes = notes.iter().map(|note| (note.key.clone(), note.value.clone().unwrap()));
    let row = |row: Result<Row, _>| row.unwrap().into_columns().into_iter().collect();
    (reader.get_row_iter(None).unwrap().map(row).collect(), notes.collect())
}

/// The least and the largest value of each column of doubles, row group by row group, as a reader takes them that knows
/// no order but that of the type.
pub(crate) fn groups(file: Vec<u8>) -> Vec<Vec<(String, f64, f64)>> {
    let metadata = opened(file).metadata().clone();
    let is_known = |of: &ColumnOrder| matches!(of, ColumnOrder::TYPE_DEFINED_ORDER(_));
    assert!(metadata.file_metadata().column_orders().unwrap().iter().all(is_known));
    let bounds = |column: &ColumnChunkMetaData| {
        let Statistics::Double(of) = column.statistics()? else { return None };
        Some((column.column_path().string(), *of.min_opt()?, *of.max_opt()?))
    };
    let groups = metadata.row_groups().iter();
    groups.map(|group| group.columns().iter().filter_map(bounds).collect()).collect()
}

pub(crate) fn text(field: &Field) -> &str {
    if let Field::Str(text) = field { text } else { "" }
}

fn double(field: &Field) -> u64 {
    if let Field::Double(x) = field { x.to_bits() } else { panic!("{field:?}") }
}

#[test]
fn constants_are_read_back_bit_for_bit() {
    let (rows, notes) = read(super::constants("parquet"));
    assert_eq!(notes["couplet.digits"], "3");
    assert_eq!(notes["couplet.schema"], "couplet.constants/1");
    assert!(notes["couplet.tool"].starts_with("couplet "));
    assert_eq!(rows.len(), all().len());
    for row in rows {
        let value = of(["landmark", "weight", "quantity"].map(|name| text(&row[name])));
        value.check(
            ["double", "double_lower", "double_upper", "double_error"].map(|key| double(&row[key])),
        );
        assert_eq!((text(&row["value"]), text(&row["status"])), (value.text.as_str(), "proved"));
        assert_eq!(text(&row["certificate_sha256"]).len(), 64);
        assert_eq!((&row["mode"], &row["line"]), (&Field::Null, &Field::Null));
    }
}

#[test]
fn states_have_a_row_for_each_value_and_for_each_that_has_none() {
    let mut input =
        String::from("weight,alpha,mu\nheyman,pi/2,0.38\nheyman,2.6,0.3\nheyman,banana,1\n");
    for i in 1..=3000 {
        input += &format!("milankovitch,{i}/1200,2\n");
    }
    let output = fed("states --format parquet --digits 5", &input);
    assert_eq!(output.status.code(), Some(2), "one row is bad");
    let half_opening = groups(output.stdout.clone()).into_iter().flatten();
    let half_opening = half_opening.filter(|(name, ..)| name == "half_opening_rad");
    let upper = half_opening.map(|(_, _, upper)| upper).fold(0.0, f64::max);
    assert_eq!(upper, 2.6, "is told by the groups");
    let (rows, notes) = read(output.stdout);
    assert_eq!(notes["couplet.schema"], "couplet.states/2");
    let line = |row: &BTreeMap<String, Field>| match row["line"] {
        Field::Long(line) => line,
        _ => panic!("{row:?}"),
    };
    let lines: BTreeSet<i64> = rows.iter().map(line).collect();
    assert_eq!(lines, (2..=3004).collect(), "two groups");
    assert_eq!(text(&rows[0]["value"]), "0.12219");
    assert_eq!(double(&rows[0]["double"]), 0.12219158636254615f64.to_bits(), "of the true value");
    assert_eq!((text(&rows[0]["mode"]), text(&rows[0]["half_opening"])), ("[s,r,r]", "pi/2"));
    let of = |line| rows.iter().find(|row| row["line"] == Field::Long(line)).unwrap();
    let fallen = of(3);
    assert_eq!((text(&fallen["reason"]), &fallen["can_stand"]), ("sliding", &Field::Bool(false)));
    assert_eq!(text(&fallen["quantity"]), "sliding_friction");
    assert_eq!(of(4)["quantity"], Field::Null);
    assert_eq!(text(&of(4)["status"]), "refused");
    assert!(text(&of(4)["reason"]).contains("banana"));
    let kept = fed("states --format parquet --keep all", "alpha,mu,id,mode\n1,1,7,x\n");
    let (kept, _) = read(kept.stdout);
    assert_eq!((text(&kept[0]["id"]), text(&kept[0]["input_mode"])), ("7", "x"));
    assert_eq!(double(&kept[0]["half_opening_deg"]), 57.29577951308232f64.to_bits());
    let assessed = "weight,alpha,mu,thickness\nheyman,pi/2,0.38,0.2\n";
    let (rows, _) = read(fed("states --format parquet", assessed).stdout);
    let cells = ["quantity", "thickness"].map(|name| text(&rows[0][name]));
    assert_eq!(cells, ["least_thickness", "0.2"]);
}

/// Every cell that both formats have of an arch is the same in both, of bad rows too, and neither has a value that the
/// other has not.
#[test]
fn states_are_those_of_csv_cell_by_cell() {
    let mut input = String::from(
        "weight,alpha,mu,eta,id,mode\nheyman,pi/2,0.38,0.2,7,x\nheyman,2.6,0.3,,8,\n\
         heyman,banana,1,,9,\"a,b\"\n,80deg,tan(31deg),0.1,,y\n1,2\nheyman,1,inf,1e-7,,z\n\
         heyman,1,0.6,2.1,,z\nheyman,1e-400,0.6,,,\n,80deg,0.2193941786949380,,,\n",
    );
    for k in 1..400 {
        let eta = if k % 3 == 0 { String::new() } else { format!("{k}/300") };
        input += &format!("milankovitch,{k}/150,{k}/170,{eta},{k},\n");
    }
    let asked = ["states", "--keep", "all", "--columns", "all", "--format"];
    let written = |format: &str| fed([&asked[..], &[format]].concat(), &input).stdout;
    let (rows, _) = read(written("parquet"));
    let shown = |field: &Field| match field {
        Field::Null => String::new(),
        Field::Str(text) => text.clone(),
        Field::Bool(truth) => truth.to_string(),
        Field::Long(number) => number.to_string(),
        Field::Double(x) => format!("{x:?}"),
        other => panic!("{other:?}"),
    };
    let mut all: BTreeMap<String, Vec<&BTreeMap<String, Field>>> = BTreeMap::new();
    rows.iter().for_each(|row| all.entry(shown(&row["line"])).or_default().push(row));
    let mut compared = 0;
    for row in crate::program::rows(written("csv")) {
        let same = all.remove(&row["line"]).unwrap();
        // The thickness of a state is the least one, in a table that has a column for another.
        let quantity = |of: &BTreeMap<String, Field>| match text(&of["quantity"]) {
            "thickness" => "least_thickness".to_owned(),
            other => other.to_owned(),
        };
        let quantities: Vec<String> = same.iter().map(|of| quantity(of)).collect();
        let is_told = |name: &str| quantities.iter().any(|of| of == name);
        for of in &same {
            let has = |name: &str| of.get(name).map(&shown);
            let why = [&*row["reason"], &row["error"]].concat();
            assert_eq!(has("reason"), Some(why), "{row:?}");
            let verdict = if row["error"].is_empty() { &row["verdict"] } else { "refused" };
            assert_eq!(has("status").as_deref(), Some(verdict), "{row:?}");
            for (name, cell) in &row {
                let value = match name.strip_suffix("_double") {
                    Some(of) if is_told(of) => None,
                    _ if name == "verdict" || name == "reason" => None,
                    _ => has(name),
                };
                assert!(value.is_none_or(|value| value == *cell), "{name} in {row:?}");
            }
            // The joint that limits a thrust has no column of its own there.
            let quantity = quantity(of);
            if let Some(value) = row.get(&quantity) {
                assert_eq!(has("value").as_ref(), Some(value), "{quantity} in {row:?}");
                let double = row.get(&format!("{quantity}_double"));
                let is_same = double.is_none_or(|double| has("double").as_ref() == Some(double));
                assert!(is_same, "{quantity} in {row:?}");
                compared += 1;
            }
        }
        let told = row.keys().filter_map(|name| name.strip_suffix("_hex"));
        for name in told.filter(|name| !row[*name].is_empty()) {
            assert!(is_told(name), "{name} in {row:?}");
        }
    }
    assert!(all.is_empty() && compared > 1500, "{compared}");
}

#[test]
fn no_queries_make_a_file_without_rows() {
    let output = fed("states --format parquet", "weight,alpha,mu\n");
    assert_eq!(output.status.code(), Some(0));
    assert!(read(output.stdout).0.is_empty());
}
