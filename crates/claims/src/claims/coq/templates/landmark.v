(** * <<title>>, <<weight>>

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what follows for the values that the paper prints.  The table of numbers
    between the claim and the theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
Open Scope R_scope.

