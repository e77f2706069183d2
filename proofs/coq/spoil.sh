#!/bin/sh
# After `make`: wrong copies of files do not compile, each for the reason it should.
#
# Usage: spoil.sh [MODULE]..., by default a landmark, a state and an asymmetric solution, and the hand files whose
# theorems the claims use.
set -eu
# Two at a time: each takes some seconds a copy.
[ $# -gt 0 ] || {
  printf '%s\n' TripleMilankovitch StateSlidingRotationalHeyman AsymmetricSlidesInsideMilankovitch \
    Cones Room Modes Attained Order Map Cells TwoWeights | xargs -n 1 -P 2 "$0"
  exit
}
cd "$(dirname "$0")"
here=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wrong=0

# The last Lemma, Theorem or Corollary that begins at or before a line.
statement_at() {
  head -n "$2" "$1" | sed -nE "s/^(Lemma|Theorem|Corollary) ([A-Za-z0-9_']+).*/\2/p" | tail -n 1
}

# What coqc stops at in a copy; nothing if it compiles.
refused_at() {
  if coqc -q -w -ambiguous-paths -R "$here" Couplet "$1" > /dev/null 2> "$work/message"; then
    return
  fi
  line=$(sed -nE 's/^File "[^"]*", line ([0-9]+), .*/\1/p' "$work/message" | tail -n 1)
  statement_at "$1" "${line:-1}"
}

# spoiled WHAT STATEMENT PERL: the copy that PERL makes is refused at STATEMENT.
spoiled() {
  copy="$work/Spoiled.v"
  perl -0777 -pe "$3" "$source" > "$copy"
  if cmp -s "$copy" "$source"; then
    found="nothing to spoil"
  else
    found=$(refused_at "$copy")
  fi
  if [ "$found" = "$2" ]; then
    echo "spoil.sh: $1: refused at $2"
  else
    echo "spoil.sh: $1: ${found:-accepted}, not refused at $2" >&2
    wrong=1
  fi
}

# The untouched copy compiles.
untouched() {
  cp "$source" "$work/Untouched.v"
  found=$(refused_at "$work/Untouched.v")
  if [ -n "$found" ]; then
    cat "$work/message" >&2
    echo "spoil.sh: the untouched copy is refused at $found" >&2
    exit 1
  fi
  echo "spoil.sh: the untouched copy of $module: accepted"
}

# One solution: the claim, the table and its check.
spoil_solution() {
  spoiled "a shifted centre" residuals_hold \
    's/(Definition centre.*?\.\d{30})(\d)/$1 . ($2 + 5) % 10/se'
  spoiled "a shifted centre with a bound that allows it" starts \
    's/(Definition centre.*?\.\d{28})(\d)/$1 . ($2 + 5) % 10/se; s/(Definition size : R := )\S+\./${1}1e-27./'
  spoiled "a wrong digit in the claim" one_solution \
    's/(Definition narrow.*?\.\d{28})(\d)/$1 . ($2 + 5) % 10/se'
  spoiled "a wrong sign in an equation" derivatives \
    's/(Definition residuals.*?\w) - /$1 + /s'
  spoiled "a wrong partial derivative" derivatives \
    's/(Definition jacobian.*?)\bcos\b/$1sin/s'
  spoiled "a singular preconditioner" contracts \
    's/(Definition inverse.*?\n  \[ )(\[.*?\])(;\s*)\[.*?\]/$1$2$3$2/s'
}

# What only the equations of T have, or its printed values.
spoil_landmark() {
  spoiled "a box too wide in the claim" one_solution \
    's/(Definition wide.*?<= \w+ <= \d\.\d)(\d)/$1 . ($2 + 1) % 10/se'
  spoiled "a wrong sign in (18), its derivatives and their values" residuals_hold \
    's/beta_s \^ 2 - /beta_s ^ 2 + /; s/h - \(1 - h\)/1 - h - h/; s/-(0\.\d+; 0\] \]\.)/$1/'
  spoiled "a spoiled preconditioner" contracts \
    's/(Definition inverse.*?\[ \[)/${1}1 + /s'
  spoiled "slopes that are too narrow" slopes_hold \
    's/(Definition spreads.*?)0\.\d+/${1}0.0000001/s'
  spoiled "another printed equation" cleared \
    's/(Definition equations.*?h_\w+ )(\d)/$1 . (1 - $2)/se'
  spoiled "a printed value that is off" "$(sed -nE 's/^Corollary (table_\w+_right).*/\1/p' "generated/$module.v" | head -n 1)" \
    's/(_right .*?Rabs \([^)]*\d)(\d)\)/$1 . (($2 + 5) % 10) . ")"/se'
}

# What makes T a state: signs, what is zero, and less friction.
spoil_landmark_state() {
  spoiled "a condition with a flipped sign" signs \
    's/beta_s < beta_r\b/beta_r < beta_s/'
  spoiled "a tie that is none" ties \
    's/(Lemma ties.*?)mu_is h = mu\b/$1mu_is h = eta/s'
  spoiled "a tie that is left out" state \
    's/  mu_ss alpha h = mu \/\\\n//'
  spoil_stands
  spoiled "a thinner thickness claimed" least_thickness \
    's/(Theorem least_thickness.*?stands_from \d alpha mu )eta/$1(eta - 1e-9)/s'
  spoiled "a friction that is no less" less_friction \
    's/(Theorem less_friction.*?mu\x27) < mu/$1 <= mu/s'
}

# What is made of a solution, for a thickness that is an unknown and for a thrust at the crown's extrados.
spoil_stands() {
  spoiled "a condition that is left out" state \
    's/  0 < normal_force alpha h \/\\\n//'
  spoiled "a line of thrust elsewhere in the crown" state \
    's/(Theorem state.*?)at_crown eta h/$1intrados eta * h/s'
  spoiled "friction at a joint beyond the shoulder" state \
    's/(Theorem state.*?admissible \d )alpha/$1(2 * alpha)/s'
  spoiled "an arch that stands thinner" state \
    's/(Theorem state.*?stands_from \d alpha mu )eta/$1(eta - 1e-9)/s'
}

# A certificate: what it claims, and where to look.
spoil_certificate() {
  spoiled "another last digit" claim \
    's/(Decimal \d{29})(\d)/$1 . ($2 + 1) % 10/e'
  spoiled "an arch with less friction" claim \
    's/(Coefficient \(Fraction )(\d+)/$1 . ($2 - 1)/e'
  spoiled "the other weight" claim \
    's/Arch (Heyman|Milankovitch)/"Arch " . ($1 eq "Heyman" ? "Milankovitch" : "Heyman")/e'
  spoiled "a value without the power of ten" claim \
    's/(Decimal \d+) \(-\d+\)/$1 (0)/'
  spoiled "a box elsewhere" claim \
    's/(\(Box \[\(Dyadic \()(-?\d)/$1 . "1" . $2/e'
  spoiled "a matrix that is not the inverse" claim \
    's/(\n    \[ \[\(Dyadic \([^)]*\) \()-?\d+/${1}3/'
  spoiled "a value that is not stated" claim \
    's/\(Plain Eta\)/(Plain Mu)/'
  spoiled "a claim that is not this one" claim \
    's/claim_of this/stands (Arch Heyman (Fraction 1 1) Unlimited) 0/'
}

# The theorems that the claims use: each says too much with one sign or one hypothesis changed.
spoil_hand() {
  case $module in
    Cones) spoiled "multipliers that leave room" strict_point_or_multipliers \
      's/(Theorem strict_point_or_multipliers.*?)c <= 0/$1c < 0/s' ;;
    Room) spoiled "a line of thrust on a face" thinner_arch_stands \
      's/(Theorem thinner_arch_stands.*?)0 < shoulder_gap/$1 0 <= shoulder_gap/s' ;;
    Modes) spoiled "a haunch off the crown where an inner joint slides" sum_of_modes \
      's/(Theorem sum_of_modes.*?0 < x3 -> )0 <= beta/${1}0 < beta/s' ;;
    Attained) spoiled "the widest half-angle without a mechanism" one_half_angle \
      's/(Theorem one_half_angle.*?0 < alpha. )< alpha ->/$1<= alpha ->/s' ;;
    Order) spoiled "a haunch that falls strictly" haunch_falls \
      's/(Theorem haunch_falls.*?beta2 )<= beta1/$1< beta1/s' ;;
    Map) spoiled "rows without the condition on the thrust" modes_of_a_row \
      's/(Theorem modes_of_a_row.*?h <= 1 )\/ 2\)/$1)/s' ;;
    Cells) spoiled "a cell with a corner of another mode" cell_of_one_mode \
      's/(Theorem cell_of_one_mode.*?alpha2 eta2 mu2 )m ->/$1m2 ->/s; s/(Theorem cell_of_one_mode.*?)\(m m. : mode\)/$1(m m2 m\x27 : mode)/s' ;;
    TwoWeights) spoiled "a shoulder that slides" heavier_is_thicker \
      's/(Theorem heavier_is_thicker .*?)m <> SRR -> /$1/s' ;;
  esac
}

for module; do
  source=generated/$module.v
  if [ -f "$source" ]; then
    untouched
    case $module in
      State* | Slides* | Asymmetric*) spoil_certificate ;;
      *) spoil_solution; spoil_landmark; spoil_landmark_state ;;
    esac
  else
    source=$module.v
    spoil_hand
  fi
done
exit $wrong
