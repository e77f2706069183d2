(** * An asymmetric solution of the complementarity problem (19): <<weight>>

    One shoulder slides outwards and a joint of the other half inwards, between a hinge next to the crown and one at the far
    haunch.  The equations that put these joints at their limits have exactly one solution in a box; here are its digits, and
    what makes it a solution of (19): **it is admissible at every joint of the whole arch**, the motion fits without
    dilatancy, and each joint moves its way.  Beside it the arch has its symmetric state, at its least thickness.

    The claims are in the names of [Arch] and [Whole].  The table of numbers between them is what [Contraction] asks for.

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Whole.
Open Scope R_scope.

(** ** The arch *)

<<arch>>


