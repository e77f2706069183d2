#!/bin/sh
# Replays this bundle by the small checker alone: every file is the one of MANIFEST, every certificate is accepted, and
# proves what index.jsonl says.
#
#     ./replay_check.sh [COUPLET_CHECK]
#
# Exit codes: 0 all holds; 1 a file is named that does not; 2 bad usage; 3 something could not be run.
# Nothing is said of THEOREM_MAP.json but that it is the file of MANIFEST.
set -eu
LC_ALL=C
export LC_ALL

failed() { code=$1; shift; echo "replay_check.sh: $*" >&2; exit "$code"; }

[ $# -le 1 ] || failed 2 "usage: replay_check.sh [COUPLET_CHECK]"
checker=${1:-couplet-check}
checker=$(command -v -- "$checker") || failed 3 "${1:-couplet-check} is not there; it is made by cargo install --path crates/check"
case $checker in /*) ;; *) checker=$PWD/$checker ;; esac
cd "$(dirname "$0")"
work=$(mktemp -d) || failed 3 "no folder for intermediate files"
trap 'rm -rf "$work"' EXIT

# The last line of MANIFEST is the hash of the lines before it.
[ -f MANIFEST ] || failed 1 "MANIFEST: missing"
sed '$d' MANIFEST >"$work/lines"
(cd "$work" && sha256sum <lines | sed 's/-$/MANIFEST/' >last)
sed -n '$p' MANIFEST | cmp -s - "$work/last" || failed 1 "MANIFEST: changed"

# Every file is there, as it was, and no other.
sed 's/^[0-9a-f]*  //' "$work/lines" | sort >"$work/named"
find . ! -type d ! -path ./MANIFEST | sed 's|^\./||' | sort >"$work/found"
comm -13 "$work/named" "$work/found" | sed 's/$/: not in MANIFEST/' >"$work/faults"
sha256sum --check --quiet "$work/lines" 2>/dev/null |
  sed -n 's/: FAILED$/: changed/p; s/: FAILED open or read$/: missing, or not to be read/p' >>"$work/faults"
if [ -s "$work/faults" ]; then cat "$work/faults"; failed 1 "$(wc -l <"$work/faults") files are not those of MANIFEST"; fi

# Every certificate is told of in the index, and the checker says of it what the index says.
grep '^certificates/.*\.json$' "$work/found" >"$work/certificates" || failed 1 "there are no certificates"
sed -n 's/^{"file": "\([^"]*\)", "statement": "\([^"]*\)", .*}$/\1: accepted  \2/p' index.jsonl >"$work/told"
[ "$(wc -l <index.jsonl)" -eq "$(wc -l <"$work/told")" ] || failed 1 "index.jsonl: a line without a file and a statement"
xargs "$checker" --statement <"$work/certificates" >"$work/said" 2>"$work/errors" || [ -s "$work/said" ] ||
  failed 3 "the checker does not run: $(cat "$work/errors")"
sort "$work/told" >"$work/told.sorted"
sort "$work/said" >"$work/said.sorted"
if ! cmp -s "$work/told.sorted" "$work/said.sorted"; then
  comm -13 "$work/told.sorted" "$work/said.sorted" | sed '/: accepted  /s/: accepted  .*/: index.jsonl says something else of it/'
  sed 's/: accepted  .*//' "$work/told.sorted" | comm -23 - "$work/certificates" | sed 's/$/: index.jsonl tells of it, but it is not there/'
  failed 1 "index.jsonl and the checker differ"
fi
echo "replay_check.sh: $(wc -l <"$work/found") files are those of MANIFEST, $(wc -l <"$work/said") certificates prove what index.jsonl says"
