#!/usr/bin/env bash
# Fuzz targets: `run.sh build` compiles them, `run.sh TARGET [OPTION…]` runs one with options of libFuzzer. What is found new
# is kept in corpus/, what fails in artifacts/. Needs cargo-fuzz; without a sanitizer the stable compiler is enough.
set -euo pipefail
cd "$(dirname "$0")"

programs=target/x86_64-unknown-linux-gnu/release
if [ "$1" = build ]; then
  RUSTC_BOOTSTRAP=1 cargo fuzz build --fuzz-dir . --sanitizer none --target x86_64-unknown-linux-gnu
  exec ./seeds.py
fi
target=$1
shift
mkdir -p "corpus/$target" "artifacts/$target"
words=words.dict
if [ "$target" = certificate ]; then words=certificate.dict; fi
exec "$programs/$target" -dict=$words -artifact_prefix="artifacts/$target/" -max_len=6000 -timeout=20 -rss_limit_mb=2048 \
  -print_final_stats=1 "$@" "corpus/$target" "seeds/$target"
