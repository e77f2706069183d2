(** * The widest rotational joint as a zero of (12)

    In [<<first>>, <<last>>] the radicand (12) has exactly one zero, and it is the joint of the point sb.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
From Couplet Require WidestJointHeyman WidestJointMilankovitch.
Open Scope R_scope.
