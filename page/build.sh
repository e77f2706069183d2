#!/usr/bin/env bash
# Builds the part of the page that is WebAssembly, and prints its path; `build.sh --ready` says only whether that can be done.
# The target comes from rustup, or its standard library is compiled from the sources that Debian packages.
set -euo pipefail
cd "$(dirname "$0")"

target=wasm32-unknown-unknown
debian=/usr/lib/rustlib/src/rust/library
# Below target/ of the repository, as everything that is built.
out=${COUPLET_PAGE_TARGET:-$(cd .. && pwd)/target/page-build}

linker() {
  find "$(rustc --print sysroot 2>/dev/null || echo /nonexistent)" -name rust-lld 2>/dev/null | head -n 1 | grep . || command -v wasm-ld
}

# Debian's compiler may be older than the code asks for.
is_new_enough() {
  oldest=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' ../Cargo.toml)
  printf '%s\n' "$oldest" "$(/usr/bin/rustc --version | cut -d' ' -f2)" | sort --version-sort --check=quiet
}

if [ -d "$(rustc --print sysroot 2>/dev/null)/lib/rustlib/$target" ]; then
  how=rustup
elif [ -d "$debian" ] && [ -x /usr/bin/rustc ] && [ -x /usr/bin/cargo ] && is_new_enough && linker >/dev/null; then
  how=debian
else
  echo "couplet: the page needs the target $target (rustup target add $target; on Debian, where its Rust is new enough: apt-get install rustc-web cargo-web rust-web-src lld)" >&2
  exit 1
fi
if [ "${1:-}" = --ready ]; then exit 0; fi

# No path of this machine stands in the file.
export RUSTFLAGS="--remap-path-prefix=$(cd .. && pwd)=/couplet --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=/cargo"
# What is loaded is small rather than quick.
options=(--quiet --locked --release --package couplet-page --target $target --target-dir "$out"
  --config profile.release.lto=true --config profile.release.codegen-units=1
  --config 'profile.release.panic="abort"' --config profile.release.strip=true)
if [ $how = rustup ]; then
  cargo build "${options[@]}" >&2
else
  # Only the nightly compiler has this option by right.
  linker=$(linker)
  PATH=/usr/bin:/bin RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker \
    /usr/bin/cargo build "${options[@]}" -Zbuild-std=std,panic_abort >&2
fi
echo "$out/$target/release/couplet_page.wasm"
