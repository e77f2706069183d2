//! Verdicts on assemblies of stones: how many of each program are right at each margin, and from which on all are.

use crate::format::Content;
use crate::judge::{RowClaim, Said};
use crate::record::Record;
use crate::reported::Reported;
use crate::strategies::Margin;
use crate::tabular::Tabular;
use crate::words::shortened;
use std::collections::BTreeMap;

/// Numbers of verdicts by program and margin: right, unsafe, safe, open.
#[derive(Debug, Default)]
pub struct JudgedAssemblies(BTreeMap<(String, Margin), [u64; 4]>);

const COLUMNS: &str = "program margin right unsafe safe open right_from";

impl JudgedAssemblies {
    /// Adds what a program says of the assembly of this name, whose side of its threshold was proved when it was drawn.
    pub fn add(&mut self, program: &str, id: &str, stands: &str) -> Result<(), String> {
        let no_name =
            || format!("'{}' is no id of `couplet sample --assemblies`: 001-above", shortened(id));
        let mut parts = id.splitn(3, '-').skip(1);
        let truth = match parts.next() {
            Some("above") => true,
            Some("below") => false,
            _ => return Err(no_name()),
        };
        let margin = parts.next().map_or(Ok(Margin::default()), str::parse);
        let said = Said { stands: Some(stands), ..Said::default() };
        let said = RowClaim::read(&said).map_err(|error| error.to_string())?;
        let kind = match (truth, said.can_stand) {
            (_, None) => 3,
            (true, Some(false)) => 2,
            (false, Some(true)) => 1,
            _ => 0,
        };
        let of = (program.to_owned(), margin.map_err(|_| no_name())?);
        self.0.entry(of).or_default()[kind] += 1;
        Ok(())
    }

    /// Tells whether every verdict is right.
    pub fn are_right(&self) -> bool {
        self.0.values().all(is_right)
    }

    fn rows(&self) -> impl Iterator<Item = Record> {
        self.0.iter().map(|((program, margin), counts)| {
            let others = || self.0.iter().filter(|((of, _), _)| of == program).rev();
            let from = others().take_while(|(_, counts)| is_right(counts)).last();
            let mut row = Record::default();
            row.add("program", program.as_str());
            row.add("margin", margin.to_string());
            for (name, count) in ["right", "unsafe", "safe", "open"].into_iter().zip(counts) {
                row.add(name, *count);
            }
            row.add("right_from", from.map(|((_, margin), _)| margin.to_string()));
            row
        })
    }
}

fn is_right([_, others @ ..]: &[u64; 4]) -> bool {
    others.iter().sum::<u64>() == 0
}

impl Reported for JudgedAssemblies {
    fn content() -> Content {
        Content(&["table", "csv"])
    }

    fn records(&self) -> Vec<Record> {
        let mut record = Record::default();
        let titles = COLUMNS.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let rows = self.rows().map(|row| row.texts().collect());
        for row in std::iter::once(titles).chain(rows) {
            let [program, cells @ ..] = &row[..] else { continue };
            let cells: String = cells.iter().map(|cell| format!(" {cell:>10}")).collect();
            record.say(format!("{:<19}{}", shortened(program), cells));
        }
        record.say("\nunsafe: says of what falls that it stands; right_from: the margin from which on all are right");
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        Tabular::of(COLUMNS, self.rows())
    }
}
