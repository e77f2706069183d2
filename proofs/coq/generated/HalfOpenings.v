(** * The half openings at l and L

    Where rotation and overturning end, [A] has an exact value, which it takes only once between 0 and
    two straight angles.  So the landmarks l and L are unique not only in a box.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
From Couplet Require RotationEndHeyman RotationEndMilankovitch.
From Couplet Require OverturningEndHeyman OverturningEndMilankovitch.
Open Scope R_scope.

(** ** The point l: end of rotation, Heyman's self-weight *)

Theorem opening_of_end_of_rotation_heyman : exists alpha,
  Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\ A alpha = 2 / 3 /\
  (forall other, 0 < other < 2 * PI -> A other = 2 / 3 -> other = alpha).
Proof.
  destruct (half_opening (2 / 3) 2.64838889915100541147745903938347 2.64838889915100541147745903938547)
    as [alpha [H [HA unique]]];
    [ lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.

Theorem only_end_of_rotation_heyman : exists alpha,
  Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\
  (forall other eta, 0 < other < 2 * PI -> 0 <= eta < 2 ->
     (RotationEndHeyman.equations other eta <-> eta = 1 /\ other = alpha)).
Proof.
  destruct opening_of_end_of_rotation_heyman as [alpha [H [HA unique]]]. exists alpha. split; [exact H |].
  intros other eta Ho He. unfold RotationEndHeyman.equations. rewrite rotation_end_heyman by exact He.
  split; intros [H1 H2]; (split; [exact H1 |]); [now apply unique | now subst].
Qed.

(** ** The point l: end of rotation, Milankovitch's self-weight *)

Theorem opening_of_end_of_rotation_milankovitch : exists alpha,
  Rabs (alpha - 2.59084344300895490419429585352135) <= 1e-30 /\ A alpha = sqrt 3 - 1 /\
  (forall other, 0 < other < 2 * PI -> A other = sqrt 3 - 1 -> other = alpha).
Proof.
  destruct (half_opening (sqrt 3 - 1) 2.59084344300895490419429585352035 2.59084344300895490419429585352235)
    as [alpha [H [HA unique]]];
    [ lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.

Theorem only_end_of_rotation_milankovitch : exists alpha,
  Rabs (alpha - 2.59084344300895490419429585352135) <= 1e-30 /\
  (forall other eta, 0 < other < 2 * PI -> 0 <= eta < 2 ->
     (RotationEndMilankovitch.equations other eta <-> eta = eta_l_milankovitch /\ other = alpha)).
Proof.
  destruct opening_of_end_of_rotation_milankovitch as [alpha [H [HA unique]]]. exists alpha. split; [exact H |].
  intros other eta Ho He. unfold RotationEndMilankovitch.equations. rewrite rotation_end_milankovitch by exact He.
  split; intros [H1 H2]; (split; [exact H1 |]); [now apply unique | now subst].
Qed.

(** ** The point L: end of overturning, Heyman's self-weight *)

Theorem opening_of_end_of_overturning_heyman : exists alpha,
  Rabs (alpha - 2.78649815065117703204215667394221) <= 1e-30 /\ A alpha = 1 / 2 /\
  (forall other, 0 < other < 2 * PI -> A other = 1 / 2 -> other = alpha).
Proof.
  destruct (half_opening (1 / 2) 2.78649815065117703204215667394121 2.78649815065117703204215667394321)
    as [alpha [H [HA unique]]];
    [ lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.

Theorem only_end_of_overturning_heyman : exists alpha,
  Rabs (alpha - 2.78649815065117703204215667394221) <= 1e-30 /\
  (forall other, 0 < other < 2 * PI -> (OverturningEndHeyman.equations other <-> other = alpha)).
Proof.
  destruct opening_of_end_of_overturning_heyman as [alpha [H [HA unique]]]. exists alpha. split; [exact H |].
  intros other Ho. unfold OverturningEndHeyman.equations. rewrite overturning_end_heyman.
  split; intros E; [now apply unique | now subst].
Qed.

(** ** The point L: end of overturning, Milankovitch's self-weight *)

Theorem opening_of_end_of_overturning_milankovitch : exists alpha,
  Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\ A alpha = 2 / 3 /\
  (forall other, 0 < other < 2 * PI -> A other = 2 / 3 -> other = alpha).
Proof.
  destruct (half_opening (2 / 3) 2.64838889915100541147745903938347 2.64838889915100541147745903938547)
    as [alpha [H [HA unique]]];
    [ lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.

Theorem only_end_of_overturning_milankovitch : exists alpha,
  Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\
  (forall other, 0 < other < 2 * PI -> (OverturningEndMilankovitch.equations other <-> other = alpha)).
Proof.
  destruct opening_of_end_of_overturning_milankovitch as [alpha [H [HA unique]]]. exists alpha. split; [exact H |].
  intros other Ho. unfold OverturningEndMilankovitch.equations. rewrite overturning_end_milankovitch.
  split; intros E; [now apply unique | now subst].
Qed.
