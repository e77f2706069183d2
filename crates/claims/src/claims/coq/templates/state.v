(** * An arch at its least thickness: [<<mode>>], <<weight>>

    The printed equations of its collapse mode have exactly one solution in a box; here are its digits,
    and what makes it **the** state of this arch: it is admissible at every joint of the half arch, and
    up to the physical limit the arch stands exactly from that thickness on.  No thinner arch stands,
    whatever the thrust and its place in the crown.

    The claims are in the names of [Arch], [Contact], [FrictionModes] and [States].  The table of numbers
    between them is what [Contraction] asks for.

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** The arch *)

<<arch>>

