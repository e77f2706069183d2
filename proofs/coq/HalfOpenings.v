(** * The half openings at l and L

    Where rotation and overturning end, [A] has an exact value, which it takes only once between 0 and
    two straight angles.  So the landmarks l and L are unique not only in a box. *)

From Coq Require Import List.
From Couplet Require Import Moments Cubics Overturning IntervalZ.
From Couplet Require Import Formulas Equations Certificate.
Import ListNotations.

(** ** One value of [A], from a bracket as wide as two units of the last decimal. *)
Ltac opening v lo hi :=
  let alpha := fresh "alpha" in
  destruct (Overturning.half_opening v lo hi) as [alpha [? [? ?]]];
  [ lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
  | unfold A; interval with (i_prec 140) |];
  exists alpha; split; [apply Rabs_le; lra | now split].

Theorem opening_of_two_thirds : exists alpha, Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\
  A alpha = 2 / 3 /\ (forall other, 0 < other < 2 * PI -> A other = 2 / 3 -> other = alpha).
Proof. opening (2 / 3) 2.64838889915100541147745903938347 2.64838889915100541147745903938547. Qed.

Theorem opening_of_root : exists alpha, Rabs (alpha - 2.59084344300895490419429585352135) <= 1e-30 /\
  A alpha = sqrt 3 - 1 /\ (forall other, 0 < other < 2 * PI -> A other = sqrt 3 - 1 -> other = alpha).
Proof. opening (sqrt 3 - 1) 2.59084344300895490419429585352035 2.59084344300895490419429585352235. Qed.

Theorem opening_of_half : exists alpha, Rabs (alpha - 2.78649815065117703204215667394221) <= 1e-30 /\
  A alpha = 1 / 2 /\ (forall other, 0 < other < 2 * PI -> A other = 1 / 2 -> other = alpha).
Proof. opening (1 / 2) 2.78649815065117703204215667394121 2.78649815065117703204215667394321. Qed.

(** ** The ends of rotation and of overturning in closed form *)

Ltac at_rotation_end l :=
  match goal with thickness : end_of_rotation _ ?eta = 0 <-> _, opening : h_whole _ _ _ = 0 <-> _ |- _ =>
    split; intros [? ?];
    [ assert (eta = l) as -> by (apply thickness; lra); split; [easy | rewrite (proj1 opening); lra]
    | subst; split; symmetry; [apply opening; lra | now apply thickness] ]
  end.

Lemma rotation_end_heyman alpha eta : 0 <= eta < 2 ->
  (0 = h_whole 0 alpha eta /\ 0 = end_of_rotation 0 eta <-> eta = 1 /\ A alpha = 2 / 3).
Proof.
  intros He. pose proof (end_of_rotation_heyman eta ltac:(lra)) as thickness.
  pose proof (overturning_from_whole_thrust 0 alpha eta) as opening. pose proof A_l_heyman.
  pose proof (A_heyman_from_13 1). at_rotation_end 1.
Qed.

Lemma rotation_end_milankovitch alpha eta : 0 <= eta < 2 ->
  (0 = h_whole 1 alpha eta /\ 0 = end_of_rotation 1 eta <-> eta = eta_l_milankovitch /\ A alpha = sqrt 3 - 1).
Proof.
  intros He. pose proof (end_of_rotation_milankovitch eta ltac:(lra) ltac:(lra)) as thickness.
  pose proof (overturning_from_whole_thrust 1 alpha eta) as opening. pose proof A_l_milankovitch.
  pose proof (A_milankovitch_from_13 eta ltac:(lra)). at_rotation_end eta_l_milankovitch.
Qed.

Lemma overturning_end_heyman alpha : 0 = h_whole 0 alpha 2 <-> A alpha = 1 / 2.
Proof.
  pose proof (overturning_from_whole_thrust 0 alpha 2) as opening. pose proof A_L_heyman.
  pose proof (A_heyman_from_13 2). split; intros; [rewrite (proj1 opening) | symmetry; apply opening]; lra.
Qed.

Lemma overturning_end_milankovitch alpha : 0 = h_whole 1 alpha 2 <-> A alpha = 2 / 3.
Proof.
  pose proof (overturning_from_whole_thrust 1 alpha 2) as opening. pose proof A_L_milankovitch.
  pose proof (A_milankovitch_from_13 2 ltac:(lra)).
  split; intros; [rewrite (proj1 opening) | symmetry; apply opening]; lra.
Qed.

(** ** The landmarks *)

(** The equations of a landmark without thrust, as they are printed. *)
Definition solves (l : landmark) (w : weight) (x : configuration) : Prop :=
  x Thrust = 0 /\ List.Forall (printed (flag w) x) (equations_of l).

Lemma solves_at_rotation_end w x : x Thrust = 0 ->
  (solves RotationEnd w x <-> 0 = h_whole (flag w) (x Alpha) (x Eta) /\ 0 = end_of_rotation (flag w) (x Eta)).
Proof.
  intros Hh. unfold solves. cbn [equations_of]. rewrite !List.Forall_cons_iff. cbn [printed]. rewrite Hh.
  split; [tauto | intros; repeat split; try tauto; apply List.Forall_nil].
Qed.

Lemma solves_at_overturning_end w x : x Thrust = 0 -> x Eta = 2 ->
  (solves OverturningEnd w x <-> 0 = h_whole (flag w) (x Alpha) 2).
Proof.
  intros Hh He. unfold solves. cbn [equations_of]. rewrite !List.Forall_cons_iff. cbn [printed]. rewrite Hh, He.
  split; [tauto | intros; repeat split; try tauto; apply List.Forall_nil].
Qed.

(** One half-angle with this [A], where the equations ask for it. *)
Ltac alone one solved closed v :=
  let alpha := fresh "alpha" in let unique := fresh "unique" in
  destruct one as [alpha [? [? unique]]]; exists alpha; split; [assumption |]; intros x; intros;
  rewrite solved by assumption; cbn [flag]; rewrite closed by assumption;
  assert (A (x Alpha) = v <-> x Alpha = alpha) by (split; intros E; [now apply unique | now rewrite E]); tauto.

Theorem only_end_of_rotation_heyman : exists alpha, Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\
  (forall x, x Thrust = 0 -> 0 < x Alpha < 2 * PI -> 0 <= x Eta < 2 -> (solves RotationEnd Heyman x <-> x Eta = 1 /\
    x Alpha = alpha)).
Proof. alone opening_of_two_thirds solves_at_rotation_end rotation_end_heyman (2 / 3). Qed.

Theorem only_end_of_rotation_milankovitch : exists alpha,
  Rabs (alpha - 2.59084344300895490419429585352135) <= 1e-30 /\ (forall x, x Thrust = 0 -> 0 < x Alpha < 2 * PI ->
    0 <= x Eta < 2 -> (solves RotationEnd Milankovitch x <-> x Eta = eta_l_milankovitch /\ x Alpha = alpha)).
Proof. alone opening_of_root solves_at_rotation_end rotation_end_milankovitch (sqrt 3 - 1). Qed.

Theorem only_end_of_overturning_heyman : exists alpha, Rabs (alpha - 2.78649815065117703204215667394221) <= 1e-30 /\
  (forall x, x Thrust = 0 -> x Eta = 2 -> 0 < x Alpha < 2 * PI -> (solves OverturningEnd Heyman x <->
    x Alpha = alpha)).
Proof. alone opening_of_half solves_at_overturning_end overturning_end_heyman (1 / 2). Qed.

Theorem only_end_of_overturning_milankovitch : exists alpha,
  Rabs (alpha - 2.64838889915100541147745903938447) <= 1e-30 /\ (forall x, x Thrust = 0 -> x Eta = 2 ->
    0 < x Alpha < 2 * PI -> (solves OverturningEnd Milankovitch x <-> x Alpha = alpha)).
Proof. alone opening_of_two_thirds solves_at_overturning_end overturning_end_milankovitch (2 / 3). Qed.
