//! Pieces of files.

use crate::ask::Field;
use crate::rows::{Columns, Purpose, Role, RowColumn};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};

/// Refuses a table that asks for more than states, or for less.
pub(super) fn asks_states(header: &[String]) -> Result<(), String> {
    let mut columns = Columns::own(Purpose::Ask);
    columns.places(header)?;
    if columns.all.iter().any(|column| column.role == Role::GivenThickness) {
        return Err(format!("it has a column for the thickness; {LEAST}"));
    }
    let of_forces = |column: &&RowColumn| OF_FORCES.contains(&column.role);
    if let Some(column) = columns.all.iter().find(of_forces) {
        return Err(format!("it has a column '{}'; {FORCES}", column.theirs));
    }
    Ok(())
}

/// Some bytes of a file.
pub(super) fn bytes_of(file: &mut File, offset: u64, length: u64) -> io::Result<Vec<u8>> {
    file.seek(SeekFrom::Start(offset))?;
    let mut bytes = Vec::new();
    file.take(length).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Why a thickness is refused.
pub(super) const LEAST: &str = "a sweep asks for the least one, and `couplet states` answers both";

/// Roles that make forces of sizes, and the reason why they are refused.
pub(super) const OF_FORCES: [Role; 2] = [Role::Size(Field::Density), Role::Size(Field::Depth)];
pub(super) const FORCES: &str = "a sweep has no forces, and `couplet states` answers both";

/// Message where a file is no longer what the sweep was made of.
pub(super) const CHANGED: &str = "it has changed since the sweep began; run again for a new one";
