(** * The half openings at l and L

    Where rotation and overturning end, [A] has an exact value, which it takes only once between 0
    and two straight angles.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
Open Scope R_scope.

Theorem end_of_rotation_heyman : exists alpha,
  Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\ A alpha = 2/3 /\
  (forall other, 0 < other < 2 * PI -> A other = 2/3 -> other = alpha).
Proof.
  destruct (half_opening (2/3) 2.64838889915100541147745903938347 2.64838889915100541147745903938547) as [alpha [H [HA unique]]];
    [lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.

Theorem end_of_rotation_milankovitch : exists alpha,
  Rabs (alpha - 2.59084344300895490419429585352135) <= 1e-30 /\ A alpha = sqrt 3 - 1 /\
  (forall other, 0 < other < 2 * PI -> A other = sqrt 3 - 1 -> other = alpha).
Proof.
  destruct (half_opening (sqrt 3 - 1) 2.59084344300895490419429585352035 2.59084344300895490419429585352235) as [alpha [H [HA unique]]];
    [lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.

Theorem end_of_overturning_heyman : exists alpha,
  Rabs (alpha - 2.78649815065117703204215667394221) <= 1e-30 /\ A alpha = 0.5 /\
  (forall other, 0 < other < 2 * PI -> A other = 0.5 -> other = alpha).
Proof.
  destruct (half_opening (0.5) 2.78649815065117703204215667394121 2.78649815065117703204215667394321) as [alpha [H [HA unique]]];
    [lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.

Theorem end_of_overturning_milankovitch : exists alpha,
  Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\ A alpha = 2/3 /\
  (forall other, 0 < other < 2 * PI -> A other = 2/3 -> other = alpha).
Proof.
  destruct (half_opening (2/3) 2.64838889915100541147745903938347 2.64838889915100541147745903938547) as [alpha [H [HA unique]]];
    [lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.
