#!/bin/sh
# After `make`: wrong copies of files do not compile, each for the reason it should.
#
# Usage: spoil.sh [MODULE]..., by default a landmark that is soon checked, what is printed of another, a state, an asymmetric
# solution and a survey, and the hand files whose theorems the claims use.
set -eu
# Two at a time: each takes some seconds a copy.
[ $# -gt 0 ] || {
  printf '%s\n' LandmarkTripleMilankovitch LandmarkRotationEndMilankovitch StateSlidingRotationalHeyman \
    AsymmetricSlidesInsideMilankovitch SurveyAllStandHeyman Surveys Rises Landmarks Cones Room Modes Attained Order Map Cells TwoWeights \
    Programme Asymmetric | xargs -n 1 -P 2 "$0"
  exit
}
cd "$(dirname "$0")"
here=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wrong=0

# The last Lemma, Theorem or Corollary that begins at or before a line.
statement_at() {
  head -n "$2" "$1" | sed -nE "s/^ *(Lemma|Theorem|Corollary) ([A-Za-z0-9_']+).*/\2/p" | tail -n 1
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

# A certificate: what it claims, and where to look.
spoil_certificate() {
  spoiled "another last digit" claim \
    's/(Decimal \d{29})(\d)/$1 . ($2 + 1) % 10/e'
  spoiled "a value without the power of ten" claim \
    's/(Decimal \d+) \(-\d+\)/$1 (0)/'
  spoiled "a box elsewhere" claim \
    's/(\(Box \[\(Dyadic \()(-?\d)/$1 . "1" . $2/e'
  spoiled "a box that is too large" claim \
    's/(\(Box \[.*?\]\s*\[\(Dyadic \(\d+\) \()-\d+/${1}-31/s'
  spoiled "a matrix that is not the inverse" claim \
    's/(\n    \[\[\(Dyadic \([^)]*\) \()-?\d+/${1}3/'
  spoiled "a value that is not stated" claim \
    's/\(Plain Eta\)/(Plain Mu)/'
  spoiled "a claim that is not this one" claim \
    's/claim_of this/stands (Arch Heyman (Fraction 1 1) Unlimited) 0/'
}

# What is given of an arch.
spoil_arch() {
  spoiled "an arch with less friction" claim \
    's/(Coefficient \(Fraction )(\d+)/$1 . ($2 - 1)/e'
  spoiled "the other weight" claim \
    's/Arch (Heyman|Milankovitch)/"Arch " . ($1 eq "Heyman" ? "Milankovitch" : "Heyman")/e'
}

# Which arches are meant, and which of them are looked at.
spoil_survey() {
  spoiled "another verdict" claim 's/AllStand$/NoneStands/m'
  spoiled "the other weight" claim 's/\(Survey Heyman/(Survey Milankovitch/'
  spoiled "a higher rise" claim 's/(\(Qmake 2 1\), \(Qmake )3 1/${1}4 1/'
  spoiled "a step that is left out" claim 's/;\n *Part .*?(;\n *Part )/$1/s'
  spoiled "a step that goes back" claim 's/(Some \()(.*?), (\(\(Qmake .*?\)\))\)/$1$3, $2)/'
  spoiled "a part that is not right" claim 's/(Stands .*?Dyadic \(?)(\d+)/$1 . "9" . $2/e'
}

# Which landmark it is.
spoil_landmark() {
  spoiled "another landmark" claim \
    's/\(Landmark (\w+)/"(Landmark " . ($1 eq "RotationEnd" ? "WidestJoint" : "RotationEnd")/e'
  spoiled "the other weight" claim \
    's/(\(Landmark \w+ )(Heyman|Milankovitch)/$1 . ($2 eq "Heyman" ? "Milankovitch" : "Heyman")/e'
}

# The values that the paper prints, right and wrong.
spoil_printed() {
  spoiled "a printed value that is off" "$(first right)" \
    's/(_right x .*?- [\d.]*)(\d)(\) <= .*?\) \d*)\d( \d+ eq_refl)/$1 . ($2 + 5) % 10 . $3 . ($2 + 5) % 10 . $4/se'
  spoiled "a wrong digit called right" "$(first wrong)" \
    's/(\S+) < (Rabs \([^)]*\))(.*?)wrong_there/$2 <= $1$3right_there/s'
}
first() {
  sed -nE "s/^Corollary (table_\w+_$1) .*/\1/p" "$source" | head -n 1
}

# The theorems that the claims use: each says too much with one sign or one hypothesis changed.
spoil_hand() {
  case $module in
    Landmarks)
      spoiled "a friction that is no less" less_friction \
        's/(Theorem less_friction.*?0 <= mu )</$1<=/s'
      spoiled "an arch that stands thinner" state_of_each_mode \
        's/(stands_from .flag w. .x Alpha. mu )\(x Eta\)/$1(x Eta - 1)/'
      spoiled "friction at a joint beyond the shoulder" state_of_each_mode \
        's/(admissible .flag w. )\(x Alpha\)/$1(2 * x Alpha)/'
      spoiled "a line of thrust elsewhere in the crown" state_of_each_mode \
        's/(admissible .*?)\(crown_moment m .flag w. x\)/$1(intrados (x Eta) * x Thrust)/'
      spoiled "a solution outside the box" one_solution \
        's/(Theorem one_solution y : )in_box .*? -> /$1/'
      spoiled "less friction than an inner joint asks for" forces_and_joints \
        's/(Theorem forces_and_joints.*?x Mu )= mu_is/$1< mu_is/s'
      spoiled "a last digit that is only nearly right" right_there \
        's/off m e p k \+ 1 <=/off m e p k <=/' ;;
    Surveys)
      spoiled "a thickness beyond the limit" narrower_thicker_stands \
        's/(Theorem narrower_thicker_stands.*?)eta. <= 2 ->/$1/s'
      spoiled "a least thickness that falls" least_thickness_is_monotone \
        's/(Corollary least_thickness_is_monotone.*?)eta. <= eta\./$1eta\x27 < eta./s'
      spoiled "a largest circle inside a step" radius_of_rises \
        's/(Theorem radius_of_rises.*?)Rmax \(/${1}Rmin (/s' ;;
    Rises)
      spoiled "a wider arch" longer_arch_stands \
        's/(Theorem longer_arch_stands.*?0 < alpha. )<= alpha ->/$1< PI ->/s'
      spoiled "a shorter span" longer_span_stands \
        's/(Theorem longer_span_stands.*?0 < span )<= span. ->/$1-> 0 < span\x27 ->/s' ;;
    Cones) spoiled "multipliers that leave room" strict_point_or_multipliers \
      's/(Theorem strict_point_or_multipliers.*?)c <= 0/$1c < 0/s' ;;
    Room) spoiled "a line of thrust on a face" thinner_arch_stands \
      's/(Theorem thinner_arch_stands.*?)0 < shoulder_gap/$1 0 <= shoulder_gap/s' ;;
    Modes) spoiled "a haunch off the crown where an inner joint slides" sum_of_modes \
      's/(Theorem sum_of_modes.*?0 < x3 -> )0 <= beta/${1}0 < beta/s' ;;
    Attained) spoiled "the widest half-angle without a mechanism" one_half_angle \
      's/(Theorem one_half_angle.*?0 < alpha. )< alpha ->/$1<= alpha ->/s' ;;
    Programme) spoiled "a least value where no rates fit" least_value_is_attained \
      's/(Theorem least_value_is_attained.*?) -> \(exists k, fit k\)/$1/s' ;;
    Asymmetric)
      spoiled "a horseshoe" no_asymmetric_motion_up_to_the_right_angle 's/(Theorem no_asymmetric_motion.*?PI) \/ 2/$1/s'
      spoiled "a haunch off the crown at the limit" joints_of_a_motion 's/(Theorem joints_of_a_motion.*?)0 <= b1/${1}0 < b1/s' ;;
    Order) spoiled "a haunch that falls strictly" haunch_falls \
      's/(Theorem haunch_falls.*?beta2 )<= beta1/$1< beta1/s' ;;
    Map)
      spoiled "pieces that do not meet" pieces_are_one 's/(Theorem pieces_are_one.*?) -> \(forall x, .*?next b x\) ->/$1 ->/s'
      spoiled "rows without the condition on the thrust" modes_of_a_row \
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
      LandmarkTriple*) spoil_printed ;;
      Landmark*) spoil_certificate; spoil_landmark ;;
      Survey*) spoil_survey ;;
      *) spoil_certificate; spoil_arch ;;
    esac
  else
    source=$module.v
    [ -f "$source" ] || source=verified/$module.v
    spoil_hand
  fi
done
exit $wrong
