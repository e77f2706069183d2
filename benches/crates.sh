#!/usr/bin/env bash
# What each choice of features costs: crates, and seconds of a build from nothing on this machine.
#
# Rust's crates are compiled afresh each time; so are GMP and MPFR, whose own cache is set aside.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo "features crates seconds"
for features in none check check,malachite check,cli mpfr mpfr,study mpfr,proptest default default,plots default,parquet; do
    chosen="--locked --no-default-features --features=${features/none/}"
    # shellcheck disable=SC2086
    crates=$(cargo tree $chosen -e normal,build --prefix none --no-dedupe | awk '{print $1, $2}' | sort -u | wc -l)
    rm -rf "$folder/target" "$folder/cache"
    start=$(date +%s.%N)
    # shellcheck disable=SC2086
    GMP_MPFR_SYS_CACHE="$folder/cache" cargo build --quiet --release $chosen --target-dir "$folder/target"
    echo "$features $((crates - 1)) $(echo "$start $(date +%s.%N)" | awk '{printf "%.0f", $2 - $1}')"
done
