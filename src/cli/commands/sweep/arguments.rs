//! Arguments of the command.

use clap::Args;
use std::path::PathBuf;

/// Prove many arches, into a partitioned Parquet data set.
///
/// A plan is a TOML file with a grid, a sample or a data set; --schema prints one with every key. The parts go
/// into a folder whose name tells the sweep, so that two sweeps never meet and the same one finds its own. A run
/// that was stopped goes on where it was: parts that are there are kept, by their names and sizes. The bytes are
/// the same however many threads, processes or machines share the work, and whatever happened meanwhile.
///
/// Needs the feature parquet.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The plan; `-` is standard input. Or the folder of a sweep, which is looked through as by --verify 100.
    #[arg(value_name = "PLAN", required_unless_present = "schema")]
    pub(super) plan: Option<PathBuf>,

    /// Where the folder of the sweep is, made if need be; the current folder if not given.
    #[arg(short, long, value_name = "FOLDER")]
    pub(super) output: Option<PathBuf>,

    /// Only a share of the parts, the K-th of N: for job arrays. All shares together are the sweep.
    #[arg(long, value_name = "K/N", value_parser = share, allow_hyphen_values = true)]
    pub(super) only: Option<Share>,

    /// Look through the parts: their content, notes and rows; and prove N rows again, drawn from all, some of
    /// them with a certificate that the second arithmetic checks. What is missing or spoiled is computed before.
    #[arg(long, value_name = "N", value_parser = sample, allow_hyphen_values = true)]
    pub(super) verify: Option<usize>,

    /// Print a plan that explains every key.
    #[arg(long, conflicts_with_all = ["plan", "output", "only", "verify"])]
    pub(super) schema: bool,
}

/// The `k`-th share of `n`, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Share {
    pub k: usize,
    pub n: usize,
}

fn share(text: &str) -> Result<Share, String> {
    let numbers = text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    let share = numbers.filter(|&(k, n)| 1 <= k && k <= n);
    let wrong = || "a share is K/N, the K-th of N: 1/4, 2/4, 3/4, 4/4".to_owned();
    share.map(|(k, n)| Share { k, n }).ok_or_else(wrong)
}

fn sample(text: &str) -> Result<usize, String> {
    let wrong =
        "rows to prove again are a whole number from 0 on: 100, 1000; more than there are is all";
    text.parse().map_err(|_| wrong.to_owned())
}
