//! Pieces of a file of a data set, a table of text or JSON lines: a piece is read without the rest of the file, and its
//! hash says whether it still is what it was.

use super::listed::Listed;
use crate::arch::SelfWeight;
use crate::ask::Field;
use crate::check::reason;
use crate::rows::{
    ArchReader, BYTE_ORDER_MARK, Columns, GivenRows, Keep, Purpose, ReadRow, Role, TextRows,
    json_lines,
};
use crate::scene::{FilePiece, TextSlice, hash_of};
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Cursor, Read, Seek, SeekFrom};
use std::iter;
use std::path::Path;

/// Formats that are no text, by their beginnings.
const OTHERS: [(&[u8], &str); 7] = [
    (b"PAR1", "Parquet"),
    (b"ARROW1", "Arrow"),
    (b"FEA1", "Feather"),
    (b"PK\x03\x04", "a workbook or an archive"),
    (b"\x1F\x8B", "compressed by gzip"),
    (b"\x28\xB5\x2F\xFD", "compressed by zstd"),
    (b"\xFD7zXZ", "compressed by xz"),
];
/// Bytes that are looked at to tell a text.
const BEGINNING: u64 = 4096;

/// Refuses what is no text, by its beginning.
fn is_text(beginning: &[u8]) -> Result<(), String> {
    let other = OTHERS.iter().find(|(first, _)| beginning.starts_with(first));
    match other.map(|(_, name)| *name).or(beginning.contains(&0).then_some("no text")) {
        None => Ok(()),
        Some(name) => Err(format!(
            "it is {name}; a sweep reads CSV and JSON lines (docs/sweeps.md), and couplet.add_states of Python proves \
             tables of pandas, polars and pyarrow (docs/python.md)"
        )),
    }
}

/// The rows of a table, or of lines of JSON.
fn open(mut input: impl BufRead + Send + 'static) -> Result<TextRows, String> {
    let first = input.fill_buf().map_err(|error| reason(&error))?.trim_ascii_start().first();
    if matches!(first, Some(b'{' | b'[')) {
        return json_lines(Box::new(input)).ok_or_else(|| {
            "it is JSON without an object on each line, which a sweep reads: jq -c '.[]' makes lines of a list"
                .to_owned()
        });
    }
    let table = TextRows::open(Box::new(input)).map_err(|error| error.to_string())?;
    let mut columns = Columns::own(Purpose::Ask);
    columns.places(&table.header)?;
    asks_states(|field| columns.has(field))?;
    Ok(table)
}

/// The next rows, at most so many, and their lines.
fn listed(rows: TextRows, most: usize, weight: SelfWeight) -> Result<(Vec<u64>, Listed), String> {
    let (columns, keep) = (Columns::own(Purpose::Ask), Keep::Named(Vec::new()));
    let GivenRows { columns, spelling, rows, .. } = GivenRows::of_text(rows, columns, keep)?;
    let reader = ArchReader { columns, weight, doubles: false, spelling };
    let (mut lines, mut listed) = (Vec::new(), Listed::default());
    for (line, row) in rows.take(most) {
        lines.push(line);
        let mut texts = Default::default();
        let arch = row.and_then(|ReadRow { cells, .. }| {
            asks_states(|field| reader.given(&cells, Role::Given(field)).is_some())?;
            texts = reader.described(&cells);
            reader.arch(&cells)
        });
        match arch {
            Ok((arch, ..)) => listed.push(arch),
            Err(error) => listed.refuse(&texts, error),
        }
    }
    Ok((lines, listed))
}

/// Refuses what asks for more than states, by the fields that it has.
fn asks_states(has: impl Fn(Field) -> bool) -> Result<(), String> {
    let (what, why) = if has(Field::Thickness) {
        ("thickness", "asks for the least one")
    } else if [Field::Density, Field::Depth].into_iter().any(has) {
        ("density or a depth", "has no forces")
    } else {
        return Ok(());
    };
    Err(format!("it has a {what}; a sweep {why}, and `couplet states` answers both"))
}

/// Some bytes of a file.
fn bytes_of(file: &mut File, offset: u64, length: u64) -> io::Result<Vec<u8>> {
    file.seek(SeekFrom::Start(offset))?;
    let mut bytes = Vec::new();
    file.take(length).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The pieces of a file, with at most so many rows each, and the head of a table; or what is wrong with the file.
pub(super) fn slices(
    path: &Path,
    rows: u64,
) -> Result<(Option<FilePiece>, Vec<TextSlice>), String> {
    let read = |error: io::Error| reason(&error);
    // A pipe would be waited for.
    if !fs::metadata(path).map_err(read)?.is_file() {
        return Err("it is a folder, a pipe or a device".into());
    }
    let mut file = File::open(path).map_err(read)?;
    let beginning = bytes_of(&mut file, 0, BEGINNING).map_err(read)?;
    is_text(&beginning)?;
    let start =
        if beginning.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() as u64 } else { 0 };
    file.seek(SeekFrom::Start(start)).map_err(read)?;
    let mut all = open(BufReader::new(file.try_clone().map_err(read)?))?;
    let head = all.is_table().then(|| all.looked());
    let mut pieces = Vec::new();
    loop {
        let (line, offset) = all.begin();
        match iter::from_fn(|| all.pass()).take(rows as usize).count() as u64 {
            0 => break,
            rows => pieces.push((rows, line, start + offset, all.looked() - offset)),
        }
    }
    let mut piece = |offset, bytes| -> Result<FilePiece, String> {
        let sha256 = hash_of(&bytes_of(&mut file, offset, bytes).map_err(read)?);
        Ok(FilePiece { offset, bytes, sha256 })
    };
    let head = head.map(|bytes| piece(start, bytes)).transpose()?;
    let slices = pieces.into_iter().map(|(rows, line, offset, bytes)| {
        Ok(TextSlice { rows, line, piece: piece(offset, bytes)? })
    });
    Ok((head, slices.collect::<Result<_, String>>()?))
}

/// The rows of a slice, and their lines.
pub(super) fn read(
    path: &Path,
    head: Option<&FilePiece>,
    slice: &TextSlice,
    weight: SelfWeight,
) -> Result<(Vec<u64>, Listed), String> {
    let mut file = File::open(path).map_err(|error| reason(&error))?;
    let mut input = |of: &FilePiece| {
        let bytes = bytes_of(&mut file, of.offset, of.bytes).map_err(|error| reason(&error))?;
        let is_same = hash_of(&bytes) == of.sha256;
        is_same.then(|| Box::new(Cursor::new(bytes))).ok_or_else(|| {
            "it has changed since the sweep began; run again for a new one".to_owned()
        })
    };
    let table = head.map(|head| TextRows::open(input(head)?).map_err(|error| error.to_string()));
    let (table, rows) = (table.transpose()?, input(&slice.piece)?);
    let rows = match table {
        Some(table) => table.with_rows(rows, slice.line),
        None => TextRows::of_objects(rows, slice.line),
    };
    let (lines, listed) = listed(rows, slice.rows as usize, weight)?;
    match lines.len() as u64 == slice.rows {
        true => Ok((lines, listed)),
        false => Err(format!(
            "{} rows from line {} on, where {} were counted; this couplet is not the one that counted them",
            lines.len(),
            slice.line,
            slice.rows
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::io::Write;
    use tempfile::NamedTempFile;

    /// The lines of rows, what they say, and why they cannot be read.
    type Told = Vec<(u64, Vec<Vec<u8>>, Option<String>)>;

    fn told((lines, listed): (Vec<u64>, Listed)) -> Told {
        let row = |(row, line)| {
            let texts = listed.texts.iter().map(|texts| texts.of(row).to_vec()).collect();
            (line, texts, listed.arches[row].clone().err())
        };
        lines.into_iter().enumerate().map(row).collect()
    }

    fn file(text: &str) -> NamedTempFile {
        let mut file = NamedTempFile::new().unwrap();
        file.write_all(text.as_bytes()).unwrap();
        file
    }

    /// The rows of all pieces of a text.
    fn in_pieces(text: &str, most: u64) -> Result<Told, String> {
        let file = file(text);
        let (head, slices) = slices(file.path(), most)?;
        let read = |slice| read(file.path(), head.as_ref(), slice, SelfWeight::Heyman).map(told);
        Ok(slices.iter().map(read).collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// The rows of a text as one reader has them.
    fn at_once(text: &str) -> Result<Told, String> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text).to_owned();
        listed(open(Cursor::new(text))?, usize::MAX, SelfWeight::Heyman).map(told)
    }

    fn is_the_same_in_pieces(text: &str) -> Told {
        let whole = at_once(text).unwrap();
        for most in [1, 2, 3, 5, 100] {
            assert_eq!(in_pieces(text, most).as_ref(), Ok(&whole), "{most}: {text}");
        }
        whole
    }

    #[test]
    fn pieces_have_the_rows_of_the_file() {
        let rows = |text: &str| {
            let found = is_the_same_in_pieces(text);
            found.into_iter().map(|(line, _, error)| (line, error)).collect::<Vec<_>>()
        };
        let lines = |text: &str| rows(text).into_iter().map(|row| row.0).collect::<Vec<_>>();
        let beyond = "weight,half_opening,friction\nmilankovitch,1.0,0.6\nmilankovitch,\"1.1\n\",\".7\n\
                      heyman,1.25,0.8\nmilankovitch,1.2,0.8\nheyman,1.3,\".9\",extra\nheyman,1.4,0.9\n";
        assert_eq!(lines(beyond), [2, 3, 4, 5, 6, 7, 8]);
        let bad = "# x\nnote,half_opening,friction\n\"a,1,0.6\n\"b\",1.1,0.6\n\" c\",1.2,0.7\n\
                   \" d\",1.3,0.8\n";
        assert_eq!(lines(bad), [3, 4, 5, 6]);
        assert_eq!(rows("# by hand\nhalf_opening,friction\n1,0.6"), [(3, None)]);
        assert_eq!(rows("# half_opening,friction\n1,0.6"), [(2, None)]);
        let open = rows("# x\nhalf_opening,friction\n\"1,0.6\n1.1,0.9\n1.2,0.7\n");
        let error = "the quote that opens in line 3 is not closed";
        assert_eq!(open, [(3, Some(error.to_owned())), (4, None), (5, None)]);
    }

    #[test]
    fn a_quote_is_looked_for_as_far_as_in_the_file() {
        let many = "1,0.6\n".repeat(100_000);
        let text =
            format!("half_opening,friction\n1,\"2\n{many}1,\"{}\n1,2\n", "x".repeat(1 << 19));
        let found = in_pieces(&text, 40_000).unwrap();
        assert_eq!(found.len(), 100_003);
        assert_eq!(Ok(found), at_once(&text));
    }

    #[test]
    fn rows_that_are_not_those_that_were_counted_are_told() {
        let file = file("half_opening,friction\n1,0.6\n");
        let (head, mut slices) = slices(file.path(), 1).unwrap();
        slices[0].rows = 2;
        let read = read(file.path(), head.as_ref(), &slices[0], SelfWeight::Heyman);
        assert!(read.is_err_and(|error| error.starts_with("1 rows from line 2 on, where 2")));
    }

    #[test]
    fn lines_of_json_are_rows_at_their_lines() {
        let text = "\u{feff}{\"alpha\": \"80deg\", \"mu\": 0.60}\n\n{\"alpha\": 1}\n[1]\n\
                    {\"mu\": 1, \"alpha\": 2, \"eta\": 0.1}\n  \n{\"phi\": \"35deg\", \"alpha\": 2}";
        let found = is_the_same_in_pieces(text);
        let lines: Vec<u64> = found.iter().map(|row| row.0).collect();
        assert_eq!(lines, [1, 3, 4, 5, 7]);
        assert_eq!(found[0].1, [&b"heyman"[..], b"80deg", b"0.60"]);
        let errors: Vec<&str> = found.iter().filter_map(|row| row.2.as_deref()).collect();
        assert_eq!(errors.len(), 3, "{errors:?}");
        assert!(errors[2].starts_with("it has a thickness; a sweep asks"), "{errors:?}");
        for text in ["[{\"alpha\": 1, \"mu\": 1}]", "{\n\"alpha\": 1, \"mu\": 1}\n"] {
            assert!(in_pieces(text, 1).is_err_and(|error| error.contains("jq -c '.[]'")), "{text}");
        }
    }

    #[test]
    fn what_is_no_text_is_named_with_what_reads_it() {
        let refused = |bytes: &[u8]| {
            let mut file = NamedTempFile::new().unwrap();
            file.write_all(bytes).unwrap();
            slices(file.path(), 1).unwrap_err()
        };
        for (bytes, name) in [
            (&b"PAR1\x15\x04"[..], "Parquet"),
            (b"\x1F\x8B\x08", "compressed by gzip"),
            (b"\x28\xB5\x2F\xFD", "compressed by zstd"),
            (b"ARROW1\0\0", "Arrow"),
            (b"PK\x03\x04", "a workbook or an archive"),
            (b"\xFF\xFEa\0,\0", "no text"),
        ] {
            let error = refused(bytes);
            assert!(error.starts_with(&format!("it is {name}; a sweep reads CSV")), "{error}");
            assert!(error.contains("couplet.add_states") && !error.contains('\n'), "{error}");
        }
    }

    const HEADS: [&str; 7] = [
        "{\"alpha\": 1, \"mu\": 1}\n",
        "half_opening,friction\n",
        "# x\nhalf_opening,friction\n",
        "\n# half_opening,friction\n",
        "# x\nnote,half_opening,friction\n",
        "\u{feff}half_opening;friction\n",
        "# x\n# \"half_opening\";friction\n1;2\n",
    ];

    proptest! {
        #![proptest_config(crate::number::test_config::config(400))]
        /// Whatever a table is cut into, its rows are the same, at the same lines, for the same reasons.
        #[test]
        fn pieces_of_any_text_have_its_rows(head in 0..HEADS.len(), text in "[a1\",.\n#;]{0,40}") {
            let text = HEADS[head].to_owned() + &text;
            let whole = at_once(&text);
            for most in 1..=3 {
                prop_assert_eq!(&in_pieces(&text, most), &whole);
            }
        }
    }
}
