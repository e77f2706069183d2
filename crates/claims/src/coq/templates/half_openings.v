(** * The half openings at l and L

    Where rotation and overturning end, [A] has an exact value, which it takes only once between 0 and
    two straight angles.  So the landmarks l and L are unique not only in a box.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
From Couplet Require RotationEndHeyman RotationEndMilankovitch.
From Couplet Require OverturningEndHeyman OverturningEndMilankovitch.
Open Scope R_scope.
