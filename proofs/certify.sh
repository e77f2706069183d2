#!/usr/bin/env bash
# The certificates of the arches that the lists of this folder name, made by the program $1 in the folders states, asymmetric and surveys
# of $2.
set -euo pipefail
program=$1 into=$2 lists=$(dirname "$0")
mkdir -p "$into"/{states,asymmetric,surveys}
while read -r name weight alpha mu; do
    "$program" certify state --weight "$weight" --alpha "$alpha" --mu "$mu" --digits 30 --output "$into/states/$name.json"
done <"$lists/states/arches.txt"
while read -r name weight alpha mu mode; do
    "$program" certify asymmetric --weight "$weight" --alpha "$alpha" --mu "$mu" --mode "$mode" --digits 30 \
        --output "$into/asymmetric/$name.json"
done <"$lists/asymmetric/arches.txt"
while read -r name arches; do
    # shellcheck disable=SC2086 # options
    "$program" certify survey $arches --digits 10 --output "$into/surveys/$name.json"
done <"$lists/surveys/arches.txt"
