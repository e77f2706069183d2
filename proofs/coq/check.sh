#!/bin/sh
# After `make`: nothing is left unproved in the text, and the theorems assume nothing but axioms.txt.
#
# The theorems are those listed in hand_theorems.txt (`Module.name` and what it says, one a line) and
# every Theorem and Corollary of the generated files.
set -eu
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "check.sh: $*" >&2; exit 1; }

# --- The text ---------------------------------------------------------------------------------

# Files without their comments, which may nest.
without_comments() {
  perl -0777 -pe 's/(\((?:\*)(?:(?>[^(*]+|\((?!\*)|\*(?!\)))|(?1))*\*\))/ /g' "$1"
}

for file in *.v verified/*.v generated/*.v; do
  [ -f "$file" ] || continue
  without_comments "$file" > "$work/text"
  if grep -nwE 'Admitted|admit|give_up|Axioms?|Parameters?|Conjectures?|bypass_check' "$work/text"; then
    fail "$file leaves something unproved"
  fi
  # Without a precision the tactic computes with the processor's floats and assumes what they do.
  calls=$(grep -owE 'interval|interval_intro' "$work/text" | wc -l)
  precise=$(grep -oE '\binterval(_intro [^.;]*)? with \(i_prec [0-9]+' "$work/text" | wc -l)
  [ "$calls" = "$precise" ] || fail "$file calls interval without i_prec"
done

# --- The assumptions --------------------------------------------------------------------------

sed 's/#.*//; s/[[:space:]]//g; /^$/d' axioms.txt | sort > "$work/allowed"
{
  [ ! -f hand_theorems.txt ] || sed 's/#.*//; s/[[:space:]].*//; /^$/d' hand_theorems.txt
  for file in generated/*.v; do
    [ -f "$file" ] || continue
    module=$(basename "$file" .v)
    sed -nE "s/^(Theorem|Corollary) ([A-Za-z0-9_']+).*/$module.\2/p" "$file"
  done
} > "$work/theorems"
[ -s "$work/theorems" ] || fail "there are no theorems"

# The names under a list of theorems, each of which is named first.
assumptions() {
  {
    cut -d. -f1 "$1" | sort -u | sed 's/.*/From Couplet Require &./'
    # One term with all of them is looked through once.
    echo 'Definition everything := ('
    sed 's/.*/@&,/' "$1"
    echo 'I).'
    echo 'Print Assumptions everything.'
  } > "$work/Everything.v"
  coqc -q -w -ambiguous-paths $(cat _CoqProject) "$work/Everything.v" > "$work/out" ||
    fail "the theorems cannot be loaded: run make first"
  sed -nE '/^(Axioms:|Closed under)/d; s/^([A-Za-z][A-Za-z0-9_.]*).*/\1/p' "$work/out" | sort -u
}

assumptions "$work/theorems" > "$work/used"
if cmp -s "$work/used" "$work/allowed"; then
  echo "check.sh: $(wc -l < "$work/theorems") theorems assume only the axioms of the real numbers"
  sed "s/^/  /" "$work/used"
  exit 0
fi
comm -13 "$work/used" "$work/allowed" | sed 's/$/ is allowed but not used/' >&2
comm -23 "$work/used" "$work/allowed" | sed 's/$/ is used but not allowed/' >&2
fail "the assumptions are not those of axioms.txt"
