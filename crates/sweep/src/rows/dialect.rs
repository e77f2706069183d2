//! Dialect of a table: how its fields are separated, which its header tells.

use std::borrow::Cow;

/// Separator of the fields of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dialect {
    /// A comma, a semicolon or a tab; a field may be quoted.
    Separated(u8),
    /// Blanks, any number of them, as NumPy writes.
    Blanks,
}

impl Dialect {
    /// Separator of the names of a header: that of comma, semicolon and tab which makes the most fields, or
    /// else blanks.
    pub(super) fn of(header: &[u8]) -> Self {
        let fields = |separator: u8| {
            let mut state = QuoteState::Start;
            header.iter().filter(|&&c| state.pass(c, &[separator]) == QuoteState::Start).count()
        };
        let most = |best: u8, next: u8| if fields(next) > fields(best) { next } else { best };
        match [b';', b'\t'].into_iter().fold(b',', most) {
            separator if fields(separator) > 0 => Self::Separated(separator),
            _ if words(header).count() > 1 => Self::Blanks,
            _ => Self::Separated(b','),
        }
    }

    /// The characters behind which a field begins.
    pub(super) fn separators(&self) -> &[u8] {
        match self {
            Self::Separated(separator) => std::slice::from_ref(separator),
            Self::Blanks => &[],
        }
    }

    /// The fields of a row, without blanks around them; those that are not read are empty, whatever their encoding.
    pub(super) fn fields(
        self,
        record: &[u8],
        is_read: impl Fn(usize) -> bool,
    ) -> Result<Vec<String>, String> {
        let text = |(place, field): (usize, &[u8])| match std::str::from_utf8(field) {
            _ if !is_read(place) => Ok(String::new()),
            Ok(text) => Ok(text.trim().to_owned()),
            Err(_) => Err(format!("field {} is not valid UTF-8", place + 1)),
        };
        match self {
            Self::Blanks => words(record).enumerate().map(text).collect(),
            Self::Separated(separator) => {
                let fields = unquoted(record, separator);
                fields.iter().map(AsRef::as_ref).enumerate().map(text).collect()
            }
        }
    }
}

/// Words of a text, which have blanks between them.
fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// The fields of a row, without their quotes; none of an empty one. A reader of the CSV library is made for a file:
/// one a row costs as much as a state.
fn unquoted(record: &[u8], separator: u8) -> Vec<Cow<'_, [u8]>> {
    if !record.contains(&b'"') {
        // Nearly all rows: what is between two separators is a field.
        let line = record.split(|&c| c == b'\n').next().filter(|line| !line.is_empty());
        return line.map_or_else(Vec::new, |line| {
            line.split(|&c| c == separator).map(Cow::Borrowed).collect()
        });
    }
    let (mut fields, mut field) = (Vec::new(), Vec::new());
    let mut state = QuoteState::Start;
    let is_end = |state: QuoteState, c: u8| c == b'\n' && state != QuoteState::Quoted;
    for &c in record {
        let before = state;
        if is_end(before, c) {
            break;
        }
        match (before, state.pass(c, &[separator])) {
            (_, QuoteState::Start) => fields.push(Cow::Owned(std::mem::take(&mut field))),
            // A quote at an end of a field.
            (QuoteState::Quoted, QuoteState::Closing) | (QuoteState::Start, QuoteState::Quoted) => {
            }
            _ => field.push(c),
        }
    }
    if record.first().is_some_and(|c| !is_end(QuoteState::Start, *c)) {
        fields.push(Cow::Owned(field));
    }
    fields
}

/// Place of a character in a row. A quote is one only where a field begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum QuoteState {
    /// The character is at the beginning of a field.
    Start,
    /// The character is in a field without quotes.
    Field,
    /// The character is between quotes.
    Quoted,
    /// Behind a quote, which ends the field unless another follows.
    Closing,
}

impl QuoteState {
    /// The state behind a character.
    pub(super) fn pass(&mut self, c: u8, separators: &[u8]) -> Self {
        *self = match (*self, c) {
            (Self::Start | Self::Closing, b'"') => Self::Quoted,
            (Self::Quoted, b'"') => Self::Closing,
            (Self::Quoted, _) => Self::Quoted,
            (_, c) if separators.contains(&c) => Self::Start,
            _ => Self::Field,
        };
        *self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_header_tells_what_separates_its_names() {
        for (header, dialect) in [
            ("weight,alpha,mu\n", Dialect::Separated(b',')),
            ("weight;alpha;mu", Dialect::Separated(b';')),
            ("alpha\tmu\teta", Dialect::Separated(b'\t')),
            ("\"a;b;c\",d", Dialect::Separated(b',')),
            ("alpha  mu eta\n", Dialect::Blanks),
            ("alpha\n", Dialect::Separated(b',')),
            ("", Dialect::Separated(b',')),
        ] {
            assert_eq!(Dialect::of(header.as_bytes()), dialect, "{header}");
        }
    }

    #[test]
    fn fields_are_those_of_the_dialect() {
        let fields =
            |dialect: Dialect, row: &str| dialect.fields(row.as_bytes(), |_| true).unwrap();
        let comma = Dialect::Separated(b',');
        assert_eq!(fields(comma, " a , \"b,c\",\"d\"\"e\"\r\n"), ["a", "\"b", "c\"", "d\"e"]);
        assert_eq!(fields(comma, "\"b,c\",\r\n"), ["b,c", ""]);
        assert_eq!(fields(Dialect::Separated(b';'), "1,5;inf\n"), ["1,5", "inf"]);
        assert_eq!(fields(Dialect::Blanks, "  1.0e+00   2\n"), ["1.0e+00", "2"]);
        let bad = |is_read: fn(usize) -> bool| comma.fields(b"1,\xFF\n", is_read);
        assert_eq!(bad(|_| true), Err("field 2 is not valid UTF-8".to_owned()));
        assert_eq!(bad(|place| place == 0), Ok(vec!["1".to_owned(), String::new()]));
    }

    proptest! {
        #![proptest_config(crate::number::test_config::config(256))]
        /// Each row is split as the CSV library splits it.
        #[test]
        fn rows_are_split_as_by_a_reader(row in "[a\",; \r\t\u{e9}]{0,12}\n?") {
            let mut reader = ::csv::ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .terminator(::csv::Terminator::Any(b'\n'))
                .from_reader(row.as_bytes());
            let mut fields = ::csv::ByteRecord::new();
            reader.read_byte_record(&mut fields).unwrap();
            let found = unquoted(row.as_bytes(), b',');
            prop_assert_eq!(found, fields.iter().map(Cow::Borrowed).collect::<Vec<_>>());
        }
    }
}
