//! Formats that are not there are named in one line.

const EVERY_FORMAT: &str = "one of table, plain, json, csv, csv2, toml, latex, markdown, c, rust, python, julia, matlab, fortran, parquet";

wrong_uses! {
    constants_for_cpp: ["constants", "--format", "cpp"] => EVERY_FORMAT;
    constants_in_no_format: ["constants", "--format", ""] => EVERY_FORMAT;
    states_in_toml: ["states", "--format", "toml"] => "one of csv, csv2, jsonl, latex, markdown, parquet";
    an_audit_in_toml: ["audit", "--format", "toml"] => "one of table, json, csv, csv2, latex, markdown";
    a_state_for_cpp: ["state", "--alpha", "1", "--mu", "1", "--format", "cpp"] => EVERY_FORMAT;
    #[cfg(not(feature = "parquet"))]
    constants_in_parquet: ["constants", "--format", "parquet"] => "--features parquet";
    #[cfg(not(feature = "parquet"))]
    states_in_parquet: ["states", "--format", "parquet"] => "--features parquet";
}
