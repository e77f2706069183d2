#!/usr/bin/env bash
# Builds the library for C and puts it together in a folder, target/c if none is named: include, lib, and what pkg-config
# reads. The folder may be moved, or copied into /usr/local.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=${1:-target/c}
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)

cargo build --locked --release --package couplet-c
made=${CARGO_TARGET_DIR:-target}/release

rm -rf "$folder"
mkdir -p "$folder/include" "$folder/lib/pkgconfig"
cp c/include/* "$folder/include"
if [ -e "$made/libcouplet_c.so" ]; then
    # The static library is one object that offers what the shared one does: a program may have a GMP, an MPFR or parts of
    # Rust of its own. Without groups, of which a linker keeps one program-wide by a name, it keeps what is its own. The
    # bitcode of Rust's own objects is none any more once it is joined.
    joined=$(mktemp -d)
    trap 'rm -rf "$joined"' EXIT
    nm -D --defined-only --format=posix "$made/libcouplet_c.so" | cut -d ' ' -f 1 >"$joined/offered"
    ld -r --force-group-allocation -o "$joined/all.o" --whole-archive "$made/libcouplet_c.a"
    objcopy --keep-global-symbols="$joined/offered" --remove-section=.llvmbc --remove-section=.llvmcmd \
        --strip-unneeded "$joined/all.o" "$joined/couplet_c.o"
    ar crsD "$folder/lib/libcouplet_c.a" "$joined/couplet_c.o"
    # Programs look for the name with the number, linkers for the one without.
    cp "$made/libcouplet_c.so" "$folder/lib/libcouplet_c.so.0"
    ln -s libcouplet_c.so.0 "$folder/lib/libcouplet_c.so"
else
    # Elsewhere it has them all.
    cp "$made/libcouplet_c.a" "$folder/lib"
    for library in libcouplet_c.dylib couplet_c.dll couplet_c.dll.lib; do
        if [ -e "$made/$library" ]; then cp "$made/$library" "$folder/lib"; fi
    done
fi
cat >"$folder/lib/pkgconfig/couplet_c.pc" <<PC
prefix=\${pcfiledir}/../..

Name: couplet_c
Description: Certified states and constants of circular masonry arches with finite friction
Version: $version
Cflags: -I\${prefix}/include
Libs: -L\${prefix}/lib -lcouplet_c
Libs.private: -lm -lpthread -ldl
PC
