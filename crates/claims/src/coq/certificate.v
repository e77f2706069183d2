(** * <<title>>. Written by `couplet prove --coq`. *)
From Couplet Require Import <<theory>>.

Definition this : <<type>> :=
  <<term>>.

Theorem claim : <<claim>> this.
Proof. apply <<theorem>>. vm_cast_no_check (eq_refl true). Qed.
