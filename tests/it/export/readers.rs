//! Rows of arches, opened by other programs without any surgery on their texts.

use crate::program::{Scratch, printed};
use crate::tool::{has, has_module};

/// A sweep in degrees, whose texts are fractions, and every kind of friction.
const QUERIES: &str = "weight,alpha,mu,eta\nheyman,1140/199deg,0.6,\nheyman,pi/2,35deg,0.2\n\
    milankovitch,1.5,inf,1/7\nmilankovitch,2.6,0.3,\n";

/// What is given, as doubles; a thickness that is not given is none.
const EXPECTED: [[f64; 3]; 4] = [
    [0.099_983_685_792_639_98, 5.728_643_216_080_402, 0.6],
    [std::f64::consts::FRAC_PI_2, 90.0, 0.700_207_538_209_709_8],
    [1.5, 85.943_669_269_623_48, f64::INFINITY],
    [2.6, 148.969_026_734_014_02, 0.3],
];

/// The names of these columns, as all the programs here write a list.
const COLUMNS: &str = "\"half_opening_rad\", \"half_opening_deg\", \"friction_double\"";

fn written() -> Scratch {
    let scratch = Scratch::new();
    scratch.write("queries.csv", QUERIES);
    for format in ["csv", "jsonl"] {
        let (queries, file) = (scratch.path("queries.csv"), scratch.path("states") + "." + format);
        printed(["states", &queries, "--format", format, "--columns", "doubles", "-o", &file]);
    }
    scratch
}

/// A program in a file beside the rows, which prints the numbers where there is what runs it.
fn read_by(command: &[&str], file: &str, program: String, allowed: f64) {
    if !has(command[0], "--version") {
        return;
    }
    let scratch = written();
    scratch.write(file, program);
    compare(&scratch.run(command[0], &[&command[1..], &[file]].concat()), allowed);
}

/// Whether a program prints the numbers, row by row. Not every reader rounds correctly.
fn compare(printed: &str, allowed: f64) {
    let rows: Vec<Vec<f64>> = printed
        .lines()
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), EXPECTED.len(), "{printed}");
    for (found, expected) in rows.iter().flatten().zip(EXPECTED.iter().flatten()) {
        let is_same = found == expected || (found - expected).abs() <= allowed * expected;
        assert!(is_same, "{found} for {expected}: {printed}");
    }
}

#[test]
fn python_reads_rows_with_its_own_modules() {
    let table = format!(
        "import csv\nfor r in csv.DictReader(open('states.csv')):\n  \
         print(*[repr(float(r[c])) for c in [{COLUMNS}]])\n"
    );
    read_by(&["python3"], "table.py", table, 0.0);
    let lines = format!(
        "import json\nfor l in open('states.jsonl'):\n  r = json.loads(l)\n  \
         print(*[repr(float('inf') if r[c] is None else r[c]) for c in [{COLUMNS}]])\n"
    );
    read_by(&["python3"], "lines.py", lines, 0.0);
}

#[test]
fn pandas_reads_rows() {
    if !has_module("pandas") {
        return;
    }
    let program = format!(
        "import pandas\nt = pandas.read_csv('states.csv')\n\
         assert t['can_stand'].notna().sum() == 2 and t['least_thickness'].dtype == float\n\
         for r in t[[{COLUMNS}]].itertuples(index=False): print(*[repr(float(x)) for x in r])\n"
    );
    read_by(&["python3"], "table.py", program, 1e-15);
}

#[test]
fn r_reads_rows() {
    let program = format!(
        "t <- read.csv('states.csv')\nstopifnot(is.numeric(t$least_thickness))\n\
         for (i in 1:nrow(t)) cat(sprintf('%.17g', unlist(t[i, c({COLUMNS})])), '\\n')\n"
    );
    read_by(&["Rscript", "--vanilla"], "table.R", program, 1e-15);
}

#[test]
fn julia_reads_rows() {
    let program = format!(
        "using DelimitedFiles\nt, h = readdlm(\"states.csv\", ','; header=true)\n\
         for i in 1:size(t, 1)\n  println(join([Float64(t[i, findfirst(==(c), vec(h))]) for c in [{COLUMNS}]], \" \"))\nend\n"
    );
    read_by(&["julia"], "table.jl", program, 0.0);
}
