#!/usr/bin/env bash
# Builds the library for C and puts it together in a folder, target/c if none is named: include, lib, and what pkg-config
# and CMake read. The folder may be moved, or copied into a prefix. With a version of glibc as a second argument it is built by
# cargo-zigbuild for Linux with that glibc, which may be older than that of this machine. COUPLET_PROFILE names cargo's profile.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=${1:-target/c}
glibc=${2:-}
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
# The number in the name of the shared library, and of its symbols. It rises when a program that was linked with it could
# not go on.
number=0
profile=${COUPLET_PROFILE:-release}
# A fault in the library is a status of its caller and does not end it.
export CARGO_PROFILE_RELEASE_PANIC=unwind
made=${CARGO_TARGET_DIR:-target}/${profile/#dev/debug}
cargo=cargo
linker=(${CC:-cc})
# What unwinds the stack is gcc's part of every system, or zig's and in the library.
libraries="-lm -lpthread -ldl"
if [ -n "$glibc" ]; then
    target=$(uname -m)-unknown-linux-gnu
    made=${CARGO_TARGET_DIR:-target}/$target/$profile
    cargo="cargo-zigbuild"
    linker=(python-zig cc -target "$(uname -m)-linux-gnu.$glibc")
    libraries+=" -lunwind"
fi
# Fills in a file of c/package.
packaged() { sed "s/@VERSION@/$version/; s/@NUMBER@/$number/" "c/package/$1" >"$folder/lib/$2/$1"; }
# With TOGETHER it is built of the crates that the command was built of (Makefile), whatever else it then knows.
build() {
    if [ -n "${TOGETHER:-}" ]; then
        cargo build --locked --profile "$profile" --package couplet $TOGETHER
    else
        "$cargo" rustc --locked --profile "$profile" --package couplet-c ${glibc:+--target "$target.$glibc"} "$@"
    fi
}

rm -rf "$folder"
mkdir -p "$folder/include" "$folder/lib/pkgconfig"
cp c/include/* "$folder/include"
packaged couplet_c.pc pkgconfig
if [ "$(uname -s)" = Linux ]; then
    build --crate-type staticlib
    # The static library is one object that offers the functions of the header alone: a program may have a GMP, an MPFR or
    # parts of Rust of its own. Without groups, of which a linker keeps one program-wide by a name, it keeps what is its
    # own. The bitcode of Rust's own objects is none any more once it is joined.
    joined=$(mktemp -d)
    trap 'rm -rf "$joined"' EXIT
    ld -r --force-group-allocation -o "$joined/all.o" --whole-archive "$made/libcouplet_c.a"
    objcopy --wildcard --keep-global-symbol='couplet_*' --remove-section=.llvmbc --remove-section=.llvmcmd \
        --strip-unneeded "$joined/all.o" "$joined/couplet_c.o"
    ar crsD "$folder/lib/libcouplet_c.a" "$joined/couplet_c.o"
    # The shared one is linked from that object and not by rustc, which has a list of symbols of its own, and linkers take
    # no versions beside it. Programs look for the name with the number, linkers for the one without.
    echo "COUPLET_C_$number { global: couplet_*; local: *; };" >"$joined/symbols"
    "${linker[@]}" -shared -o "$folder/lib/libcouplet_c.so.$number" -s -Wl,--version-script="$joined/symbols" \
        -Wl,-soname,"libcouplet_c.so.$number" -Wl,--gc-sections,--no-undefined,--as-needed,-z,relro,-z,now \
        "$joined/couplet_c.o" $libraries
    ln -s "libcouplet_c.so.$number" "$folder/lib/libcouplet_c.so"
    mkdir -p "$folder/lib/cmake/couplet_c"
    packaged couplet_cConfig.cmake cmake/couplet_c
    packaged couplet_cConfigVersion.cmake cmake/couplet_c
else
    # Elsewhere they are as they are made: the static one has all symbols.
    build
    for library in libcouplet_c.a libcouplet_c.dylib couplet_c.lib couplet_c.dll couplet_c.dll.lib; do
        if [ -e "$made/$library" ]; then cp "$made/$library" "$folder/lib"; fi
    done
fi
