(** * The two self-weights compared

    At T, S, J and B: in which direction the true weight moves each quantity, from the digits of both.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
From Couplet Require TripleHeyman TripleMilankovitch ShiftHeyman ShiftMilankovitch.
From Couplet Require JunctionHeyman JunctionMilankovitch BorderHeyman BorderMilankovitch.
Open Scope R_scope.
