//! `couplet sweep`: what is asked, and what is said.

mod arguments;
#[cfg(feature = "parquet")]
mod command;

use crate::sweep::failure::Failure;
pub(crate) use arguments::Arguments;

#[cfg(feature = "parquet")]
pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    command::run(arguments)
}

#[cfg(not(feature = "parquet"))]
pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { plan, output, only, verify, schema } = arguments;
    let _ = (plan, output, only.map(|share| (share.k, share.n)), verify, schema);
    Err(Failure::Input(
        "a sweep writes Parquet, and this couplet was built without the feature parquet (cargo install --path . \
         --features parquet); `couplet states` answers a table"
            .into(),
    ))
}
