(** * The least friction of an arch: [[s,s]], any self-weight

    The printed equations of pure sliding have exactly one solution in a box; here are its digits.  With
    less friction than its [mu] no arch of this half-angle stands, whatever the thickness, the thrust and
    its place in the crown.

    The claims are in the names of [Arch], [FrictionModes] and [States].  The table of numbers between
    them is what [Contraction] asks for.

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** The arch *)

<<arch>>

