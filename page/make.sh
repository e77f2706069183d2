#!/usr/bin/env bash
# Makes the page, INDEX.html, of the map that a program writes: page/make.sh PROGRAM INDEX.html
set -euo pipefail

program=$(realpath "$1")
page=$(realpath -m "$2")
mkdir -p "$(dirname "$page")"
map=$(mktemp -d)
trap 'rm -rf "$map"' EXIT
(cd "$map" && "$program" map -o map.html >/dev/null)
wasm=$("$(dirname "$0")/build.sh")
"$(dirname "$0")/assemble.py" "$map/map.html" "$wasm" "$page"
