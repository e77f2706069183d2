#!/usr/bin/env bash
# A built couplet checks itself, in a minute or so: stored certificates in two arithmetics; the same made anew, byte for byte; the
# numbers of the paper; the examples of the pages. The argument is the program.
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")/.."
house=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

failed() { echo "couplet: $*" >&2; exit 1; }

stored=(proofs/constants/*.json proofs/states/*.json proofs/asymmetric/*.json proofs/surveys/*.json)
for engine in astro mpfr; do
    "$program" check --engine $engine "${stored[@]}" >"$work/said" || failed "a stored certificate: $(grep -v ': accepted' "$work/said")"
    echo "${#stored[@]} stored certificates accepted by $engine"
done

"$program" certify all --digits 100 --output "$work/constants" >/dev/null
diff -r proofs/constants "$work/constants" >/dev/null || failed "the landmarks have other certificates than proofs/constants"
proofs/certify.sh "$program" "$work"
for file in "$work"/{states,asymmetric,surveys}/*.json; do cmp "proofs/${file#"$work"/}" "$file"; done
echo "${#stored[@]} certificates are made byte for byte as they are stored"

"$program" audit >"$work/audit"
diff <(sed -n '2,21p' tests/it/snapshots/audit.txt) <(head -20 "$work/audit") || failed "the audit is not as stored"
echo "the numbers of the paper are judged as stored"

# The commands of the blocks marked `console`. A line of them that is shown has to be printed; `…` stands for what may be.
PATH=$(dirname "$program"):$PATH
count=0
example() {
    local shown
    [ -n "$command" ] || return 0
    case $command in "cat "*) sed '/^$/d' "$work/shown" >"${command#cat }" ;; esac
    bash -c "$command" </dev/null >"$work/printed" 2>"$work/error" || failed "$page: $command: $(cat "$work/error")"
    while IFS= read -r shown; do
        case $shown in
        "" | "…") ;;
        *"…") grep -qF -- "${shown%…}" "$work/printed" || failed "$page: $command does not print: $shown" ;;
        *) grep -qxF -- "$shown" "$work/printed" || failed "$page: $command does not print: $shown" ;;
        esac
    done <"$work/shown"
    count=$((count + 1))
    command=""
}
for page in README.md docs/commands.md; do
    rm -rf "$work/folder" && mkdir "$work/folder" && cd "$work/folder"
    inside="" command=""
    while IFS= read -r line; do
        case $line in
        '```console') inside=yes ;;
        '```'*) example; inside="" ;;
        '$ '*) [ -n "$inside" ] && example && command=${line#'$ '} && : >"$work/shown" ;;
        *) [ -z "$command" ] || printf '%s\n' "$line" >>"$work/shown" ;;
        esac
    done <"$house/$page"
    cd "$house"
done
echo "$count examples of the pages print what is shown"
