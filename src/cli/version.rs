//! Versions of what the program is made of: what somebody has to know who quotes its numbers.

use std::sync::LazyLock;

/// The version, the commit, the features, and the arithmetic.
pub(super) static LONG: LazyLock<String> = LazyLock::new(|| {
    let features: Vec<&str> =
        FEATURES.into_iter().filter(|(_, on)| *on).map(|(name, _)| name).collect();
    let (version, commit) = (env!("CARGO_PKG_VERSION"), env!("COUPLET_COMMIT"));
    format!(
        "{version}\ncommit: {commit}\nfeatures: {}\narithmetic: {}",
        features.join(", "),
        arithmetic()
    )
});

/// The features with whether they are built in.
macro_rules! built_in {
    ($($name:tt)*) => { [$(($name, cfg!(feature = $name))),*] };
}

const FEATURES: [(&str, bool); 5] = built_in!("system-gmp" "cli" "plots" "parquet" "proptest");

fn arithmetic() -> String {
    use gmp_mpfr_sys::{gmp, mpfr};
    let gmp = [gmp::VERSION, gmp::VERSION_MINOR, gmp::VERSION_PATCHLEVEL];
    let mpfr = [mpfr::VERSION_MAJOR, mpfr::VERSION_MINOR, mpfr::VERSION_PATCHLEVEL];
    let [gmp, mpfr] = [gmp, mpfr].map(|parts| parts.map(|part| part.to_string()).join("."));
    let has = |name| FEATURES.contains(&(name, true));
    let from = if has("system-gmp") { ", of the system or newer" } else { "" };
    format!("GMP {gmp}, MPFR {mpfr}{from}; astro-float")
}
