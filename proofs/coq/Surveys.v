(** * All arches between measured ends: which of them decide

    The states of an arch are among those of each narrower, rougher and thicker one.  Where span, rise and thickness
    are measured they make half-angle and thickness-to-radius ratio together; an arch does not change with its scale, so
    that the arches on two edges of the rectangle of spans and rises decide for all. *)

From Couplet Require Import Moments Cubics Sliding Joining Contact FrictionModes States.

(** ** Half-angle, friction and thickness, each for itself *)

(** More friction bears what less does, as more thickness does. *)
Lemma friction_holds_if_rougher (beta mu mu' h : R) :
  0 <= normal_force beta h -> mu <= mu' -> friction_holds beta mu h -> friction_holds beta mu' h.
Proof. unfold friction_holds. nra. Qed.

(** So a state of an arch is one of each narrower, rougher and thicker one: the widest, least rough and thinnest decides
    whether all stand, its opposite whether any does, also where friction has no limit. *)
Theorem narrower_thicker_stands (delta alpha alpha' eta eta' h p : R) : 0 <= delta <= 1 -> 0 <= alpha' <= alpha ->
  0 < eta <= eta' -> eta' <= 2 -> (forall x, 0 <= x <= alpha -> joint_stands delta x eta h p) ->
  forall x, 0 <= x <= alpha' -> joint_stands delta x eta' h p.
Proof.
  intros Hd Ha He He' Hall. assert (0 <= p).
  { destruct (Hall 0 ltac:(lra)) as (HN & Hin & _). assert (0 <= intrados eta * normal_force 0 h) by positive.
    rewrite cos_0 in Hin. lra. }
  intros x Hx. apply (joint_stands_if_thicker delta x eta); try easy. apply Hall. lra.
Qed.

Theorem admissible_if_narrower_rougher_thicker (delta alpha alpha' eta eta' mu mu' h p : R) :
  0 <= delta <= 1 -> 0 <= alpha' <= alpha -> 0 < eta <= eta' -> eta' <= 2 -> mu <= mu' ->
  admissible delta alpha eta mu h p -> admissible delta alpha' eta' mu' h p.
Proof.
  intros Hd Ha He He' Hmu Hall x Hx. split.
  - apply (narrower_thicker_stands delta alpha alpha' eta eta' h p); try easy. now apply Hall.
  - destruct (Hall x ltac:(lra)) as [Hjoint Hfriction].
    apply (friction_holds_if_rougher x mu); [apply Hjoint | easy | easy].
Qed.

Corollary narrower_rougher_thicker_stands (delta alpha alpha' eta eta' mu mu' : R) :
  0 <= delta <= 1 -> 0 <= alpha' <= alpha -> 0 < eta <= eta' -> eta' <= 2 -> mu <= mu' ->
  arch_stands delta alpha eta mu -> arch_stands delta alpha' eta' mu'.
Proof.
  intros Hd Ha He He' Hmu (h & p & Hall). exists h, p.
  now apply (admissible_if_narrower_rougher_thicker delta alpha alpha' eta eta' mu mu').
Qed.

(** ** Span, rise and thickness *)

Definition opening (span rise : R) : R := 2 * atan (2 * rise / span).
Definition radius (span rise : R) : R := (span ^ 2 / 4 + rise ^ 2) / (2 * rise).

(** The thickness to the radius of the centreline; [c] is 1, 0, -1 where [r] is that of the intrados, the centreline,
    the extrados. *)
Definition ratio (c t r : R) : R := t / (r + c * t / 2).

Lemma radius_positive (span rise : R) : 0 < span -> 0 < rise -> 0 < radius span rise.
Proof. intros Hs Hf. apply Rdiv_lt_0_compat; nra. Qed.

(** The ratio is no larger on a larger circle and of a thinner arch. *)
Lemma ratio_grows (c t t' r r' : R) : 0 < t <= t' -> 0 < r <= r' -> 0 < r + c * t' / 2 -> 0 < r' + c * t / 2 ->
  ratio c t r' <= ratio c t' r.
Proof.
  intros Ht Hr Hc Hc'. unfold ratio. apply (Rmult_le_reg_r ((r + c * t' / 2) * (r' + c * t / 2))).
  - positive.
  - replace (t / (r' + c * t / 2) * ((r + c * t' / 2) * (r' + c * t / 2)))
      with (t * (r + c * t' / 2)) by (field; lra).
    replace (t' / (r + c * t' / 2) * ((r + c * t' / 2) * (r' + c * t / 2)))
      with (t' * (r' + c * t / 2)) by (field; lra). nra.
Qed.

(** It is one where the thickness is at most twice the radius of the centreline, and so on each larger circle. *)
Lemma ratio_between (c t t' r r' : R) : -1 <= c <= 1 -> 0 < t <= t' -> r <= r' -> t' <= 2 * (r + c * t' / 2) ->
  0 < r' + c * t / 2 /\ 0 < ratio c t r' <= 2.
Proof.
  intros Hc Ht Hr Hroom. assert (t <= 2 * (r' + c * t / 2)) by nra. assert (Hp : 0 < r' + c * t / 2) by lra.
  unfold ratio. split; [exact Hp | split].
  - positive.
  - apply (Rmult_le_reg_r (r' + c * t / 2)); [exact Hp |]. field_simplify; lra.
Qed.

(** The half-angle grows with the slope alone, *)
Lemma opening_grows (span span' rise rise' : R) : 0 < span -> 0 < span' -> rise * span' <= rise' * span ->
  opening span rise <= opening span' rise'.
Proof.
  intros Hs Hs' Hf. unfold opening. assert (H : 2 * rise / span <= 2 * rise' / span').
  { apply (Rmult_le_reg_r (span * span')); [positive |]. field_simplify; lra. }
  destruct H as [H | ->]; [apply atan_increasing in H|]; lra.
Qed.

Lemma opening_between (span rise : R) : 0 < span -> 0 < rise -> 0 < opening span rise < PI.
Proof.
  intros Hs Hf. unfold opening. assert (H : 0 < 2 * rise / span) by positive.
  apply atan_increasing in H. rewrite atan_0 in H. assert (B := atan_bound (2 * rise / span)). lra.
Qed.

(** and the radius with the size: an arch that is scaled keeps its half-angle. *)
Lemma radius_of_scaled (span span' rise rise' : R) : 0 < span <= span' -> 0 < rise -> rise' * span = rise * span' ->
  radius span rise <= radius span' rise'.
Proof.
  intros Hs Hf H. assert (Hr := radius_positive span rise ltac:(lra) Hf).
  assert (E : rise' = span' / span * rise) by (apply (Rmult_eq_reg_r span); [field_simplify|]; lra).
  assert (K : radius span' rise' = span' / span * radius span rise) by (rewrite E; unfold radius; field; lra).
  assert (1 <= span' / span) by (apply (Rmult_le_reg_r span); [lra | field_simplify; lra]). nra.
Qed.

(** With the span, *)
Lemma radius_of_spans (span span' rise : R) : 0 < span <= span' -> 0 < rise -> radius span rise <= radius span' rise.
Proof. intros Hs Hf. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra | nra]. Qed.

(** and between two rises of one span it is at most that of an end, and at least half the span or that of an end. *)
Theorem radius_of_rises (span rise_0 rise rise_1 : R) : 0 < span -> 0 < rise_0 <= rise -> rise <= rise_1 ->
  span / 2 <= radius span rise <= Rmax (radius span rise_0) (radius span rise_1) /\
  (span / 2 <= rise_0 \/ rise_1 <= span / 2 -> Rmin (radius span rise_0) (radius span rise_1) <= radius span rise).
Proof.
  intros Hs Hf Hf'.
  assert (Hdiff : forall x y, 0 < x -> 0 < y -> radius span y - radius span x
    = (y - x) * (x * y - span ^ 2 / 4) / (2 * x * y)) by (intros; unfold radius; field; lra).
  assert (grows : forall x y, 0 < x <= y -> span ^ 2 / 4 <= x * y -> radius span x <= radius span y).
  { intros x y Hx H. assert (0 <= (y - x) * (x * y - span ^ 2 / 4) / (2 * x * y)) by positive.
    assert (E := Hdiff x y ltac:(lra) ltac:(lra)). lra. }
  assert (falls : forall x y, 0 < x <= y -> x * y <= span ^ 2 / 4 -> radius span y <= radius span x).
  { intros x y Hx H. assert (0 <= (y - x) * (span ^ 2 / 4 - x * y) / (2 * x * y)) by positive.
    assert (E := Hdiff x y ltac:(lra) ltac:(lra)). lra. }
  split; [split |].
  - replace (span / 2) with (radius span (span / 2)) by (unfold radius; field; lra).
    destruct (Rle_dec rise (span / 2)); [apply falls | apply grows]; nra.
  - destruct (Rle_dec (span ^ 2 / 4) (rise * rise_1)) as [H | H].
    + apply Rle_trans with (radius span rise_1); [apply grows; lra | apply Rmax_r].
    + apply Rle_trans with (radius span rise_0); [apply falls; nra | apply Rmax_l].
  - intros [H | H].
    + apply Rle_trans with (radius span rise_0); [apply Rmin_l | apply grows; nra].
    + apply Rle_trans with (radius span rise_1); [apply Rmin_r | apply falls; nra].
Qed.

(** ** The least thickness *)

(** It is no less in a wider arch, and no larger with more friction, whatever the modes there are. *)
Corollary least_thickness_is_monotone (delta alpha alpha' mu mu' eta eta' : R) :
  0 <= delta <= 1 -> 0 <= alpha' <= alpha -> mu <= mu' -> 0 < eta <= 2 ->
  stands_from delta alpha mu eta -> stands_from delta alpha' mu' eta' -> eta' <= eta.
Proof.
  intros Hd Ha Hmu He from from'. apply (from' eta He).
  apply (narrower_rougher_thicker_stands delta alpha alpha' eta eta mu mu'); try easy; try lra. apply from; lra.
Qed.
