//! The name of a part, which tells all that a second run has to know of it: whose part it is, its verdicts, its size
//! and its hash.

use std::fmt;

/// Digits of a hash that are in names, and of the name of the sweep in those of parts.
pub(super) const SHOWN: usize = 16;
const SWEEP: usize = 8;

/// Name of the file of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PartName {
    pub part: usize,
    /// The first digits of the hash of the record.
    sweep: String,
    /// Numbers of rows with each verdict.
    pub counts: [u64; 4],
    pub bytes: u64,
    /// The first digits of the hash of the file.
    hash: String,
}

impl PartName {
    /// The name of a part of the sweep whose record has this hash.
    pub(super) fn new(part: usize, plan: &str, counts: [u64; 4], bytes: u64, hash: &str) -> Self {
        let (sweep, hash) = (plan[..SWEEP].to_owned(), hash[..SHOWN].to_owned());
        Self { part, sweep, counts, bytes, hash }
    }

    /// The name that a file has, if it is one as it is written here.
    pub(super) fn read(name: &str) -> Option<Self> {
        let fields: Vec<&str> =
            name.strip_prefix("part-")?.strip_suffix(".parquet")?.split('-').collect();
        let [part, sweep, stands, falls, undecided, refused, bytes, hash] = fields[..] else {
            return None;
        };
        let is_hash = |text: &str, digits| {
            text.len() == digits && text.bytes().all(|c| c.is_ascii_hexdigit())
        };
        let number = |text: &str| text.parse::<u64>().ok();
        let read = Self {
            part: part.parse().ok()?,
            sweep: sweep.to_owned(),
            counts: [number(stands)?, number(falls)?, number(undecided)?, number(refused)?],
            bytes: number(bytes)?,
            hash: hash.to_owned(),
        };
        // In one form alone.
        let is_one = is_hash(sweep, SWEEP) && is_hash(hash, SHOWN) && read.to_string() == name;
        is_one.then_some(read)
    }

    /// Tells whether the file is a part of this sweep with so many rows.
    pub(super) fn is_of(&self, plan: &str, rows: u64) -> bool {
        let all = self.counts.iter().try_fold(0u64, |all, count| all.checked_add(*count));
        plan.starts_with(&self.sweep) && all == Some(rows)
    }

    /// Tells whether a content with this hash is what was written.
    pub(super) fn has(&self, hash: &str) -> bool {
        hash.starts_with(&self.hash)
    }
}

impl fmt::Display for PartName {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { part, sweep, counts: [stands, falls, undecided, refused], bytes, hash } = self;
        let counts = format!("{stands}-{falls}-{undecided}-{refused}");
        write!(f, "part-{part:08}-{sweep}-{counts}-{bytes}-{hash}.parquet")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_read_in_the_one_form_in_which_it_is_written() {
        let plan = "0123456789abcdef0123";
        let name = PartName::new(12, plan, [20, 4, 0, 1], 4567, "fedcba9876543210ffff");
        let text = "part-00000012-01234567-20-4-0-1-4567-fedcba9876543210.parquet";
        assert_eq!((name.to_string(), PartName::read(text)), (text.to_owned(), Some(name.clone())));
        assert!(name.is_of(plan, 25) && !name.is_of(plan, 24) && !name.is_of("1", 25));
        assert!(name.has("fedcba98765432100000") && !name.has("fedcba9876543211"));
        for (from, to) in [
            ("part-0", "part-"),
            ("-20-", "-020-"),
            ("-4567-", "-+4567-"),
            ("fed", "xed"),
            ("-1-", "-"),
            (".parquet", ".parquet.gz"),
            ("-01234567-", "-0123456-"),
        ] {
            assert_eq!(PartName::read(&text.replacen(from, to, 1)), None, "{to}");
        }
        let many = "part-00000000-01234567-18446744073709551615-1-0-0-1-fedcba9876543210.parquet";
        assert!(!PartName::read(many).unwrap().is_of(plan, 0));
    }
}
