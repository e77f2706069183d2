//! Arches that are there, by rows, and the threads that answer them.

use crate::arch::SelfWeight;
use crate::certify::state::{InLanes, LaneColumns};
use crate::number::ExactNumber;
use crate::problem::Arch;
use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::HashMap;
use std::hash::Hash;
use std::ops::Range;

/// Arches of a batch, by rows.
pub trait BatchArches: Sync {
    /// Number of rows.
    fn count(&self) -> usize;

    /// The rows of each half opening and weight among some rows: every row once.
    fn openings(&self, rows: &[usize]) -> Vec<Vec<usize>>;

    /// The weight of a row, with its numbers in enclosures, where they are known; these need not be those of an arch.
    fn in_lanes(&self, row: usize) -> Option<(SelfWeight, InLanes)>;

    /// Rows that follow each other as they go into lanes, by their weights; each by its place from the first of these.
    fn many_in_lanes(&self, rows: Range<usize>) -> [LaneColumns; 2] {
        LaneColumns::by_weight(rows.map(|row| self.in_lanes(row)))
    }

    /// The arch of a row, or why there is none.
    fn arch(&self, row: usize) -> Result<Cow<'_, Arch>, String>;

    /// Tells whether every arch has a thickness.
    fn have_thicknesses(&self) -> bool {
        false
    }

    /// The thickness of a row where every arch has one, or why it has none.
    fn thickness(&self, _row: usize) -> Result<ExactNumber, String> {
        Err("the thickness is empty".to_owned())
    }
}

/// Some rows by their keys; each row without a key is by itself.
pub fn grouped<K: Eq + Hash>(rows: &[usize], key: impl Fn(usize) -> Option<K>) -> Vec<Vec<usize>> {
    let (mut groups, mut place_of) = (Vec::new(), HashMap::new());
    for &row in rows {
        let place =
            key(row).map_or(groups.len(), |key| *place_of.entry(key).or_insert(groups.len()));
        match groups.get_mut(place) {
            None => groups.push(vec![row]),
            Some(group) => group.push(row),
        }
    }
    groups
}

/// Threads that a batch is answered in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Threads {
    /// The one that asks.
    One,
    /// Threads of the pool of rayon in which it is asked, if it is one: the global pool is not asked for, as a forked
    /// process would wait for it for ever.
    Pool,
}

impl Threads {
    /// The answers to each of some questions.
    pub fn each<A: Sync, B: Send>(self, all: &[A], of: impl Fn(&A) -> B + Send + Sync) -> Vec<B> {
        match rayon::current_thread_index().filter(|_| self == Self::Pool) {
            Some(_) => all.par_iter().map(of).collect(),
            None => all.iter().map(of).collect(),
        }
    }
}
