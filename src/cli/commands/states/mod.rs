//! `couplet states`: a row for each arch, or for all arches between two ends.

mod arches;
mod arguments;
mod counts;
mod opened;
mod ranges;

use crate::sweep::failure::Failure;
pub(crate) use arguments::Arguments;

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    match arguments.ranges {
        true => ranges::run(arguments),
        false => arches::run(arguments),
    }
}
