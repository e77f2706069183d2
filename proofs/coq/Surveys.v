(** * All arches between measured ends: which of them decide

    The states of an arch are among those of each narrower, rougher and thicker one.  Where span, rise and thickness
    are measured they make half-angle and thickness-to-radius ratio together; an arch does not change with its scale, so
    that the arches on two edges of the rectangle of spans and rises decide for all. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Couplet Require Import Arch Moments Cubics Sliding Joining Contact FrictionModes.
Open Scope R_scope.

(** ** Half-angle, friction and thickness, each for itself *)

(** What a joint bears it bears in a thicker arch, up to the physical limit. *)
Lemma joint_stands_if_thicker (delta beta eta eta' h p : R) :
  0 <= delta <= 1 -> 0 < eta <= eta' -> eta' <= 2 -> 0 <= p ->
  joint_stands delta beta eta h p -> joint_stands delta beta eta' h p.
Proof.
  intros Hd He He' Hp (HN & Hin & Hout). assert (HV := COS_bound beta).
  unfold joint_stands, intrados, extrados, fac in *.
  set (N := normal_force beta h) in *. set (V := 1 - cos beta) in *.
  assert (0 <= V) by (unfold V; lra). assert (0 <= (eta' - eta) * N) by (apply Rmult_le_pos; lra).
  assert (Hsquare : 0 <= delta * (eta' * eta' - eta * eta)) by (apply Rmult_le_pos; nra).
  split; [easy | split].
  - assert (0 <= delta * (eta' * eta' - eta * eta) * V) by (apply Rmult_le_pos; lra). nra.
  - apply (Rmult_le_reg_l (1 + eta / 2)); [lra|].
    apply Rle_trans with ((1 + eta' / 2) * (p + (1 + delta * eta ^ 2 / 12) * V)).
    + assert (0 <= (eta' - eta) * p) by (apply Rmult_le_pos; lra).
      assert (Hsum : delta * (2 * (eta + eta') + eta * eta') <= 12).
      { assert (eta * eta' <= 4) by nra.
        assert (0 <= (1 - delta) * (2 * (eta + eta') + eta * eta')) by (apply Rmult_le_pos; nra). lra. }
      assert (0 <= (eta' - eta) * (12 - delta * (2 * (eta + eta') + eta * eta')) * V)
        by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
      lra.
    + rewrite <- Rmult_assoc, (Rmult_comm (1 + eta / 2)), Rmult_assoc.
      apply Rmult_le_compat_l; lra.
Qed.

(** With more friction, too. *)
Lemma friction_holds_if_rougher (beta mu mu' h : R) :
  0 <= normal_force beta h -> mu <= mu' -> friction_holds beta mu h -> friction_holds beta mu' h.
Proof.
  unfold friction_holds. intros HN Hmu H.
  assert (mu * normal_force beta h <= mu' * normal_force beta h) by now apply Rmult_le_compat_r. lra.
Qed.

(** So the widest, least rough and thinnest arch decides whether all stand, its opposite whether any does. *)
Theorem narrower_rougher_thicker_stands (delta alpha alpha' eta eta' mu mu' : R) :
  0 <= delta <= 1 -> 0 <= alpha' <= alpha -> 0 < eta <= eta' -> eta' <= 2 -> mu <= mu' ->
  arch_stands delta alpha eta mu -> arch_stands delta alpha' eta' mu'.
Proof.
  intros Hd Ha He He' Hmu (h & p & Hall). exists h, p.
  assert (Hp : 0 <= p).
  { destruct (Hall 0 ltac:(lra)) as [(HN & Hin & _) _].
    assert (0 <= intrados eta * normal_force 0 h) by (apply Rmult_le_pos; [unfold intrados|]; lra).
    rewrite cos_0 in Hin. lra. }
  intros x Hx. destruct (Hall x ltac:(lra)) as [Hjoint Hfriction]. split.
  - now apply (joint_stands_if_thicker delta x eta).
  - apply (friction_holds_if_rougher x mu); [apply Hjoint | easy | easy].
Qed.

(** ** Span, rise and thickness *)

Definition opening (span rise : R) : R := 2 * atan (2 * rise / span).
Definition radius (span rise : R) : R := (span ^ 2 / 4 + rise ^ 2) / (2 * rise).

(** The thickness to the radius of the centreline; [c] is 1, 0, -1 where [r] is that of the intrados, the centreline,
    the extrados. *)
Definition ratio (c t r : R) : R := t / (r + c * t / 2).

(** An arch of these measures, with room for its intrados. *)
Definition measured_stands (delta c span rise t mu : R) : Prop :=
  arch_stands delta (opening span rise) (ratio c t (radius span rise)) mu.

Lemma radius_positive (span rise : R) : 0 < span -> 0 < rise -> 0 < radius span rise.
Proof. intros Hs Hf. apply Rdiv_lt_0_compat; nra. Qed.

(** The ratio is no larger on a larger circle and of a thinner arch. *)
Lemma ratio_grows (c t t' r r' : R) : 0 < t <= t' -> 0 < r <= r' -> 0 < r + c * t' / 2 -> 0 < r' + c * t / 2 ->
  ratio c t r' <= ratio c t' r.
Proof.
  intros Ht Hr Hc Hc'. unfold ratio. apply (Rmult_le_reg_r ((r + c * t' / 2) * (r' + c * t / 2))).
  - now apply Rmult_lt_0_compat.
  - replace (t / (r' + c * t / 2) * ((r + c * t' / 2) * (r' + c * t / 2)))
      with (t * (r + c * t' / 2)) by (field; lra).
    replace (t' / (r + c * t' / 2) * ((r + c * t' / 2) * (r' + c * t / 2)))
      with (t' * (r' + c * t / 2)) by (field; lra).
    assert (t * r <= t' * r') by (apply Rmult_le_compat; lra). lra.
Qed.

(** An arch that is scaled keeps its half-angle, and its radius follows. *)
Lemma scaled (k span rise : R) : 0 < k -> 0 < span -> 0 < rise ->
  opening (k * span) (k * rise) = opening span rise /\ radius (k * span) (k * rise) = k * radius span rise.
Proof.
  intros Hk Hs Hf. split.
  - unfold opening. f_equal. f_equal. field. lra.
  - unfold radius. field. lra.
Qed.

(** If the thinnest arches with the longest span or the highest rise stand, all do: each that has room for its
    thickness, which is at most twice the radius of its centreline. *)
Theorem outer_edges_decide (delta c mu mu' span_1 rise_1 t_0 : R) :
  0 <= delta <= 1 -> -1 <= c <= 1 -> mu <= mu' ->
  (forall span rise, 0 < span <= span_1 -> 0 < rise <= rise_1 -> span = span_1 \/ rise = rise_1 ->
    measured_stands delta c span rise t_0 mu) ->
  forall span rise t, 0 < span <= span_1 -> 0 < rise <= rise_1 -> 0 < t_0 <= t ->
    t <= 2 * (radius span rise + c * t / 2) -> measured_stands delta c span rise t mu'.
Proof.
  intros Hd Hc Hmu Hedges span rise t Hs Hf Ht Hroom.
  assert (Hr := radius_positive span rise ltac:(lra) ltac:(lra)). set (r := radius span rise) in *.
  assert (Hlarger : exists k, 1 <= k /\ k * span <= span_1 /\ k * rise <= rise_1 /\
    (k * span = span_1 \/ k * rise = rise_1)).
  { assert (H : forall x x_1, 0 < x <= x_1 -> 1 <= x_1 / x /\ x_1 / x * x = x_1).
    { intros x x_1 Hx. split; [|field; lra]. apply (Rmult_le_reg_r x); [lra|]. field_simplify; lra. }
    destruct (H span span_1 Hs) as [Hs1 Hs2], (H rise rise_1 Hf) as [Hf1 Hf2].
    destruct (Rle_dec (span_1 / span) (rise_1 / rise)).
    - exists (span_1 / span). repeat split; try lra. rewrite <- Hf2. apply Rmult_le_compat_r; lra.
    - exists (rise_1 / rise). repeat split; try lra. rewrite <- Hs2. apply Rmult_le_compat_r; lra. }
  destruct Hlarger as (k & Hk & Hks & Hkf & Hedge).
  assert (Hstands := Hedges (k * span) (k * rise) ltac:(nra) ltac:(nra) Hedge).
  unfold measured_stands in *. destruct (scaled k span rise ltac:(lra) ltac:(lra) ltac:(lra)) as [Ha Hkr].
  rewrite Ha, Hkr in Hstands. fold r in Hstands |- *. revert Hstands.
  assert (Hthin : 0 < r + c * t_0 / 2) by (destruct (Rle_dec 0 c); nra).
  assert (r <= k * r) by nra.
  apply narrower_rougher_thicker_stands; try easy.
  - split; [|lra]. unfold opening. assert (Hatan := atan_increasing 0 (2 * rise / span)).
    rewrite atan_0 in Hatan. assert (0 < 2 * rise / span) by (apply Rdiv_lt_0_compat; lra). lra.
  - split; [apply Rdiv_lt_0_compat; lra | apply ratio_grows; lra].
  - unfold ratio. apply (Rmult_le_reg_r (r + c * t / 2)); [lra|]. field_simplify; lra.
Qed.

(** On a step along an edge the half-angle is largest at the highest rise or the shortest span, *)
Lemma opening_grows (span span' rise rise' : R) :
  0 < span' <= span -> 0 < rise <= rise' -> opening span rise <= opening span' rise'.
Proof.
  intros Hs Hf. unfold opening. assert (H : 2 * rise / span <= 2 * rise' / span').
  { apply Rmult_le_compat; try lra; [apply Rlt_le, Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]. }
  destruct H as [H | ->]; [apply atan_increasing in H|]; lra.
Qed.

(** and the radius at one of the two ends; it is nowhere less than half the span. *)
Theorem radius_of_step (span rise_0 rise rise_1 : R) : 0 < span -> 0 < rise_0 <= rise -> rise <= rise_1 ->
  span / 2 <= radius span rise <= Rmax (radius span rise_0) (radius span rise_1).
Proof.
  intros Hs Hf Hf'.
  assert (Hdiff : forall x y, 0 < x -> 0 < y ->
    radius span y - radius span x = (y - x) * (x * y - span ^ 2 / 4) / (2 * x * y))
    by (intros; unfold radius; field; lra).
  split.
  - assert (H := Hdiff (span / 2) rise ltac:(lra) ltac:(lra)).
    replace (radius span (span / 2)) with (span / 2) in H by (unfold radius; field; lra).
    replace ((rise - span / 2) * (span / 2 * rise - span ^ 2 / 4) / (2 * (span / 2) * rise))
      with ((rise - span / 2) ^ 2 / (2 * rise)) in H by (field; lra).
    assert (0 <= (rise - span / 2) ^ 2 / (2 * rise)) by (apply Rdiv_le_0_compat; [apply pow2_ge_0 | lra]). lra.
  - assert (Hsign : forall x y, 0 < x <= y -> 0 <= x * y - span ^ 2 / 4 -> radius span x <= radius span y).
    { intros x y Hx H. assert (0 < x * y) by (apply Rmult_lt_0_compat; lra).
      assert (0 <= (y - x) * (x * y - span ^ 2 / 4) / (2 * x * y))
        by (apply Rdiv_le_0_compat; [apply Rmult_le_pos|]; lra).
      assert (E := Hdiff x y ltac:(lra) ltac:(lra)). lra. }
    destruct (Rle_dec 0 (rise * rise_1 - span ^ 2 / 4)) as [H | H].
    + apply Rle_trans with (radius span rise_1); [apply Hsign; lra | apply Rmax_r].
    + apply Rle_trans with (radius span rise_0); [|apply Rmax_l].
      assert (E := Hdiff rise_0 rise ltac:(lra) ltac:(lra)).
      assert (0 < rise_0 * rise) by (apply Rmult_lt_0_compat; lra).
      assert (rise_0 * rise <= rise_1 * rise) by (apply Rmult_le_compat_r; lra).
      assert (0 <= (rise - rise_0) * (span ^ 2 / 4 - rise_0 * rise) / (2 * rise_0 * rise))
        by (apply Rdiv_le_0_compat; [apply Rmult_le_pos|]; lra).
      replace ((rise - rise_0) * (rise_0 * rise - span ^ 2 / 4) / (2 * rise_0 * rise))
        with (- ((rise - rise_0) * (span ^ 2 / 4 - rise_0 * rise) / (2 * rise_0 * rise))) in E
        by (field; lra). lra.
Qed.
