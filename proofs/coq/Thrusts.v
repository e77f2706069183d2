(** * What an arch asks of its thrust

    The thickness is [tau] and the radius of the centroids [centroids], both to the radius of the extrados.  An arch
    that stands has a state with a thrust of at most 1. *)

From Couplet Require Import Overturning Mechanisms.

Definition slenderness (eta : R) : R := 2 * eta / (2 + eta).
Definition centroids (delta tau : R) : R := 1 - tau / 2 + delta * tau ^ 2 / (6 * (2 - tau)).

(** The thrust that a haunch asks for, (2). *)
Definition asked (delta x tau : R) : R :=
  ((1 - tau) * (x * sin x) - centroids delta tau * (1 - cos x)) / (1 - cos x + tau * cos x).

Lemma slenderness_between (eta : R) : 0 < eta <= 2 -> 0 < slenderness eta <= 1.
Proof.
  intros He. assert (E : 1 - slenderness eta = (2 - eta) / (2 + eta)) by (unfold slenderness; field; lra).
  assert (0 <= (2 - eta) / (2 + eta)) by positive. split; [apply Rdiv_lt_0_compat |]; lra.
Qed.

Lemma scaled_radii (delta eta : R) : 0 < eta -> intrados eta = extrados eta * (1 - slenderness eta) /\
  fac delta eta = extrados eta * centroids delta (slenderness eta) /\ 0 < extrados eta.
Proof.
  intros He. unfold intrados, extrados, fac, centroids, slenderness.
  repeat split; [field; lra | field; split; lra | lra].
Qed.

Lemma joint_scaled (delta x eta h q : R) : 0 < eta -> let tau := slenderness eta in
  joint_stands delta x eta h (extrados eta * q) <-> 0 <= normal_force x h /\
    (1 - tau) * normal_force x h <= q + centroids delta tau * (1 - cos x) <= normal_force x h.
Proof.
  intros He tau. destruct (scaled_radii delta eta He) as (Ei & Ef & Hp). unfold joint_stands. rewrite Ei, Ef.
  fold tau. set (N := normal_force x h). set (g := centroids delta tau). set (V := 1 - cos x).
  replace (extrados eta * q + extrados eta * g * V) with (extrados eta * (q + g * V)) by ring.
  rewrite Rmult_assoc. split; intros (HN & Hin & Hout); repeat split; try easy;
    first [apply Rmult_le_compat_l | apply (Rmult_le_reg_l (extrados eta))]; lra.
Qed.

Lemma grows (f f' : R -> R) (x : R) : 0 < x -> f 0 = 0 -> (forall c, 0 <= c <= x -> is_derive f c (f' c)) ->
  (forall c, 0 < c < x -> 0 < f' c) -> 0 < f x.
Proof.
  intros Hx H0 Hd Hp. destruct (MVT_cor2 f f' 0 x Hx) as (c & Hc & Hin); [intros; now apply is_derive_Reals, Hd |].
  assert (0 < f' c * (x - 0)) by (apply Rmult_lt_0_compat; [apply Hp |]; lra). lra.
Qed.

Ltac growing := let c := fresh "c" in intros c ?; auto_derive; [try easy | try field; try easy].
Ltac at_zero := rewrite ?sin_0, ?cos_0; lra.

Lemma lag_positive (x : R) : 0 < x < PI -> 0 < 2 * (1 - cos x) - x * sin x.
Proof.
  intros Hx. apply (grows (fun t => 2 * (1 - cos t) - t * sin t) (fun t => sin t - t * cos t));
    [lra | at_zero | growing |]. intros c Hc. assert (K := times_cosine_below_sine c ltac:(lra)). lra.
Qed.

Lemma normal_force_by_A (a h : R) : 0 < a < PI -> normal_force a h = h + (A a - h) * (1 - cos a).
Proof.
  intros Ha. assert (0 < 1 - cos a) by positive. unfold normal_force, A. field. lra.
Qed.

Section Ring.

Variable delta : R.
Hypothesis flag : 0 <= delta <= 1.

Lemma haunch_signs (x tau : R) : 0 <= x <= PI / 2 -> 0 < tau <= 1 -> 0 <= cos x /\ 0 <= 1 - cos x /\
  1 - cos x <= x * sin x /\ 0 <= 2 * (1 - cos x) - x * sin x /\ 0 < 1 - cos x + tau * cos x.
Proof.
  intros Hx Ht. assert (0 <= cos x) by positive. destruct (COS_bound x).
  assert (M := moment_of_weight_grows 0 x ltac:(lra) ltac:(lra) ltac:(lra)). rewrite sin_0, cos_0 in M.
  repeat split; try lra; [|nra]. destruct (Req_dec x 0) as [-> | Hne]; [rewrite sin_0, cos_0; lra |].
  apply Rlt_le, lag_positive. lra.
Qed.

Lemma lack_of_asked (x tau : R) : 0 <= x <= PI / 2 -> 0 < tau <= 1 ->
  let P := 2 * (1 - cos x) - x * sin x + tau * (cos x + x * sin x - (1 - cos x) / 2)
    + delta * tau ^ 2 / (6 * (2 - tau)) * (1 - cos x) in
  asked delta x tau = 1 - P / (1 - cos x + tau * cos x) /\ 0 < P / (1 - cos x + tau * cos x).
Proof.
  intros Hx Ht P. destruct (haunch_signs x tau Hx Ht) as (HC & Hv & Hb & Hl & Hw).
  split; [unfold asked, centroids, P; field; lra |]. apply Rdiv_lt_0_compat; [|easy].
  assert (0 <= delta * tau ^ 2 / (6 * (2 - tau)) * (1 - cos x)) by positive.
  assert (0 < tau * (cos x + x * sin x - (1 - cos x) / 2)) by positive. unfold P. lra.
Qed.

(** A joint's intrados with the line of thrust on the crown's extrados, and with it on the shoulder's. *)
Lemma asked_at_most (x tau h : R) : 0 <= x <= PI / 2 -> 0 < tau <= 1 ->
  asked delta x tau <= h <-> (1 - tau) * normal_force x h <= h + centroids delta tau * (1 - cos x).
Proof.
  intros Hx Ht. destruct (haunch_signs x tau Hx Ht) as (_ & _ & _ & _ & Hw).
  assert (E : asked delta x tau * (1 - cos x + tau * cos x)
    = (1 - tau) * (x * sin x) - centroids delta tau * (1 - cos x)) by (unfold asked; field; lra).
  unfold normal_force. split; intros H; [apply (Rmult_le_compat_r (1 - cos x + tau * cos x)) in H; lra
    | apply (Rmult_le_reg_r (1 - cos x + tau * cos x)); lra].
Qed.

Definition clear_of_shoulder (alpha tau h x : R) : Prop :=
  (1 - tau) * normal_force x h <= normal_force alpha h - centroids delta tau * (cos x - cos alpha).

Lemma clear_with_less_thrust (alpha eta h h0 x : R) : 0 < alpha < PI -> 0 < eta <= 2 -> 0 <= x <= alpha ->
  0 <= h <= h0 -> clear_of_shoulder alpha (slenderness eta) h0 x -> clear_of_shoulder alpha (slenderness eta) h x.
Proof.
  intros Ha He Hx Hh H0. unfold clear_of_shoulder in *. set (tau := slenderness eta) in *.
  destruct (Rle_lt_dec (cos alpha) ((1 - tau) * cos x)) as [Harm | Harm].
  - assert (0 <= (h0 - h) * ((1 - tau) * cos x - cos alpha)) by positive. unfold normal_force in *. lra.
  - destruct (scaled_radii delta eta ltac:(lra)) as (Ei & Ef & Hp). fold tau in Ei, Ef.
    assert (H := room_without_lever delta alpha x eta h 0 flag Hx Ha He ltac:(lra)). rewrite Ei in H.
    apply (Rmult_le_reg_l (extrados eta)); [easy |]. unfold haunch_gap, shoulder_gap in H. rewrite Ei, Ef in H.
    assert (0 <= extrados eta * (cos alpha - (1 - tau) * cos x)) by positive. lra.
Qed.

(** What crown, haunch and shoulder ask of [A]. *)
Lemma room_for_rotation (alpha eta h x : R) : let tau := slenderness eta in 0 < alpha < PI -> 0 < eta <= 2 ->
  0 <= x <= alpha -> x <= PI / 2 -> 0 <= h -> clear_of_shoulder alpha tau h 0 -> clear_of_shoulder alpha tau h x ->
  asked delta x tau <= h -> asked delta x tau + centroids delta tau <= A alpha.
Proof.
  intros tau Ha He Hx Hx' Hh H0 HM Hask.
  destruct (Rle_lt_dec h (A alpha - centroids delta tau)) as [Hle | Hlt]; [lra |].
  assert (HV : 0 < 1 - cos alpha) by positive. set (a := A alpha - centroids delta tau) in *. assert (Ha0 : 0 <= a).
  { apply (clear_with_less_thrust alpha eta 0 h 0) in H0; try easy; try lra. unfold clear_of_shoulder in H0.
    fold tau in H0. rewrite (normal_force_by_A alpha), normal_force_at_crown, cos_0 in H0 by easy.
    apply (Rmult_le_reg_r (1 - cos alpha)); [easy |]. unfold a. lra. }
  apply (clear_with_less_thrust alpha eta a h x) in HM; try easy; try lra. fold tau in HM.
  enough (asked delta x tau <= a) by (unfold a in *; lra).
  apply asked_at_most; [lra | now apply slenderness_between |]. unfold clear_of_shoulder in HM.
  rewrite (normal_force_by_A alpha) in HM by easy. unfold a in *. lra.
Qed.

Lemma demands_of_joints (alpha eta h p x : R) : let tau := slenderness eta in 0 < alpha < PI -> 0 < eta <= 2 ->
  (forall y, 0 <= y <= alpha -> joint_stands delta y eta h p) -> 0 <= x <= alpha -> x <= PI / 2 ->
  asked delta x tau <= h /\ clear_of_shoulder alpha tau h x.
Proof.
  intros tau Ha He Hall Hx Hx'. assert (Ht := slenderness_between eta He). fold tau in Ht.
  destruct (scaled_radii delta eta ltac:(lra)) as (_ & _ & Hp).
  assert (Hjoint : forall y, 0 <= y <= alpha -> (1 - tau) * normal_force y h
    <= p / extrados eta + centroids delta tau * (1 - cos y) <= normal_force y h).
  { intros y Hy. specialize (Hall y Hy). replace p with (extrados eta * (p / extrados eta)) in Hall by (field; lra).
    apply joint_scaled in Hall; [apply Hall | lra]. }
  assert (Hcrown := Hjoint 0 ltac:(lra)). assert (Hend := Hjoint alpha ltac:(lra)). specialize (Hjoint x Hx).
  rewrite normal_force_at_crown, cos_0 in Hcrown. unfold clear_of_shoulder. split; [apply asked_at_most |]; lra.
Qed.

Lemma joints_of_a_thrust (alpha eta h : R) : let tau := slenderness eta in 0 < alpha < PI -> 0 < eta <= 2 -> 0 <= h ->
  (forall x, 0 <= x <= alpha -> x <= PI / 2 -> asked delta x tau <= h /\
     (A alpha - centroids delta tau < h -> clear_of_shoulder alpha tau h x)) ->
  exists p, forall x, 0 <= x <= alpha -> joint_stands delta x eta h p.
Proof.
  intros tau Ha He Hh Hall. destruct (slenderness_between eta He) as [Ht Ht1]. fold tau in Ht, Ht1.
  assert (HV : 0 < 1 - cos alpha) by positive. set (g := centroids delta tau) in *.
  assert (EN := normal_force_by_A alpha h Ha).
  assert (Hq : exists q, q <= h /\ q <= normal_force alpha h - g * (1 - cos alpha) /\
    forall x, 0 <= x <= alpha -> x <= PI / 2 -> (1 - tau) * normal_force x h <= q + g * (1 - cos x)).
  { destruct (Rle_lt_dec h (A alpha - g)) as [Hle | Hlt].
    - exists h. split; [lra | split; [nra |]]. intros x Hx Hx'. apply asked_at_most; [lra | easy | now apply Hall].
    - exists (normal_force alpha h - g * (1 - cos alpha)). split; [nra | split; [lra |]]. intros x Hx Hx'.
      destruct (Hall x Hx Hx') as [_ H]. specialize (H Hlt). unfold clear_of_shoulder in H. fold g in H. lra. }
  destruct Hq as (q & Hq1 & Hq2 & Hin). assert (Hq0 := Hin 0 ltac:(lra) ltac:(lra)).
  rewrite normal_force_at_crown, cos_0 in Hq0. assert (0 <= (1 - tau) * h) by positive. assert (Hg : 1 - tau <= g).
  { unfold g, centroids. assert (0 <= delta * tau ^ 2 / (6 * (2 - tau))) by positive. lra. }
  exists (extrados eta * q). intros x Hx. apply joint_scaled; [lra |]. fold tau. fold g.
  assert (Hout : q + g * (1 - cos x) <= normal_force x h).
  { assert (M := margin_least_at_the_ends 1 g h ltac:(lra) alpha x ltac:(lra) Hx).
    assert (K : q + g <= Rmin (margin 1 g h 0) (margin 1 g h alpha)); [|unfold margin in *; lra]. unfold margin.
    rewrite normal_force_at_crown, cos_0. apply Rmin_glb; lra. }
  split; [|split; [|easy]].
  - destruct (COS_bound x). assert (0 <= g * (1 - cos x)) by positive. lra.
  - destruct (Rle_lt_dec x (PI / 2)) as [Hn | Hw]; [now apply Hin |].
    destruct (margin_falls (1 - tau) g h ltac:(lra) (PI / 2) x) as [M _]; try lra.
    + unfold direction, cot. rewrite cos_PI2. unfold Rdiv. rewrite Rmult_0_l, Rmult_0_r. nra.
    + assert (K := Hin (PI / 2) ltac:(lra) ltac:(lra)). unfold margin in M. lra.
Qed.

Lemma outward_gap_with_less_thrust (x mu h h0 : R) : 0 < x < PI -> 0 < mu -> 0 <= h < h0 ->
  0 <= outward_gap x mu h0 -> 0 < outward_gap x mu h.
Proof.
  intros Hx Hmu Hh H0. assert (HS : 0 < sin x) by positive.
  unfold outward_gap, normal_force, shear_force in *. destruct (Rle_lt_dec 0 (cos x)) as [HC | HC].
  - assert (P : 0 < x * (mu * sin x + cos x)) by positive. apply (Rmult_lt_reg_l h0); [lra |].
    assert (Q := Rmult_lt_0_compat (h0 - h) _ ltac:(lra) P). assert (Q' := Rmult_le_pos h _ ltac:(lra) H0). lra.
  - assert (0 < (h0 - h) * (sin x - mu * cos x)) by positive. lra.
Qed.

(** Friction besides: a thrust of at most 1 is enough. *)
Lemma thrust_of_an_arch (alpha eta mu : R) : let tau := slenderness eta in 0 < alpha < PI -> 0 < eta <= 2 -> 0 < mu ->
  arch_stands delta alpha eta mu -> exists h, 0 < h <= 1 /\ 0 <= outward_gap alpha mu h /\
    (forall x, 0 <= x <= alpha -> x <= PI / 2 -> asked delta x tau <= h /\ clear_of_shoulder alpha tau h x /\
      0 <= inward_gap x mu h).
Proof.
  intros tau Ha He Hmu (h0 & p0 & Hall). assert (Ht := slenderness_between eta He). fold tau in Ht.
  assert (Hh0 : 0 < h0) by (apply (friction_needs_thrust delta alpha eta mu h0 p0); [lra | lra | exact Hall]).
  assert (Hdemands := fun x => demands_of_joints alpha eta h0 p0 x Ha He (fun y Hy => proj1 (Hall y Hy))).
  assert (Hfriction : forall x, 0 <= x <= alpha -> 0 <= inward_gap x mu h0 /\ 0 <= outward_gap x mu h0).
  { intros x Hx. destruct (Hall x Hx) as [_ Hf]. apply Rcomplements.Rabs_le_between in Hf.
    unfold inward_gap, outward_gap. lra. }
  destruct (Rle_lt_dec h0 1) as [H1 | H1].
  - exists h0. split; [lra | split; [apply Hfriction; lra |]]. intros x Hx Hx'. destruct (Hdemands x Hx Hx').
    repeat split; try easy. now apply Hfriction.
  - exists 1. split; [lra | split].
    + apply Rlt_le, (outward_gap_with_less_thrust alpha mu 1 h0); [easy | easy | lra | apply Hfriction; lra].
    + intros x Hx Hx'. destruct (Hdemands x Hx Hx') as [H2 H3]. repeat split.
      * destruct (lack_of_asked x tau) as [-> HP]; lra.
      * apply (clear_with_less_thrust alpha eta 1 h0); easy || lra.
      * assert (HN := normal_force_positive_to_quarter x 1 ltac:(lra) ltac:(lra)).
        assert (0 < mu * normal_force x 1) by positive. unfold inward_gap, shear_force.
        destruct (Req_dec x 0) as [-> | Hne]; [rewrite sin_0; lra |].
        assert (K := times_cosine_below_sine x ltac:(lra)). lra.
Qed.

Lemma arch_of_a_thrust (alpha eta mu h : R) : let tau := slenderness eta in 0 < alpha < PI -> 0 < eta <= 2 ->
  0 < mu -> 0 < h -> 0 <= outward_gap alpha mu h -> (forall x, 0 <= x <= alpha -> x <= PI / 2 ->
     asked delta x tau <= h /\ (A alpha - centroids delta tau < h -> clear_of_shoulder alpha tau h x) /\
     0 <= inward_gap x mu h) ->
  exists p, forall x, 0 <= x <= alpha -> joint_stands delta x eta h p /\ friction_holds x mu h.
Proof.
  intros tau Ha He Hmu Hh HO Hall. destruct (joints_of_a_thrust alpha eta h Ha He ltac:(lra)) as [p Hp].
  { intros x Hx Hx'. now destruct (Hall x Hx Hx') as (H1 & H2 & _). }
  exists p. intros x Hx. split; [now apply Hp |]. destruct (Hp x Hx) as [HN _].
  assert (0 <= mu * normal_force x h) by positive. apply Rabs_le. split.
  - destruct (Req_dec x 0) as [-> | Hx0]; [unfold shear_force in *; rewrite sin_0; lra |].
    enough (0 <= outward_gap x mu h) by (unfold outward_gap in *; lra).
    destruct (Req_dec x alpha) as [-> | Hne]; [easy |]. apply Rlt_le, (no_outward_limit_within x alpha); lra.
  - destruct (Rle_lt_dec x (PI / 2)) as [Hn | Hw].
    + destruct (Hall x Hx Hn) as (_ & _ & K). unfold inward_gap in K. lra.
    + unfold shear_force. assert (cos x < 0) by (apply cos_lt_0; lra). assert (0 <= sin x) by positive.
      assert (0 <= h * sin x) by positive. nra.
Qed.

Lemma no_flat_arch (alpha eta mu : R) : 0 < alpha <= PI -> 0 < mu -> arch_stands delta alpha eta mu -> alpha < PI.
Proof.
  intros Ha Hmu (h & p & Hall). destruct (Req_dec alpha PI) as [E | Hne]; [exfalso | lra].
  assert (0 < h) by (apply (friction_needs_thrust delta alpha eta mu h p); [lra | lra | exact Hall]).
  destruct (Hall alpha ltac:(lra)) as [(HN & _) _]. unfold normal_force in HN. rewrite E, cos_PI, sin_PI in HN. lra.
Qed.

Theorem thrust_at_most_one (alpha eta mu : R) : 0 < alpha <= PI -> 0 < eta <= 2 -> 0 < mu ->
  arch_stands delta alpha eta mu -> exists h p, h <= 1 /\
    forall x, 0 <= x <= alpha -> joint_stands delta x eta h p /\ friction_holds x mu h.
Proof.
  intros Ha He Hmu Hstands. assert (Hflat := no_flat_arch alpha eta mu Ha Hmu Hstands).
  destruct (thrust_of_an_arch alpha eta mu ltac:(lra) He Hmu Hstands) as (h & Hh & HO & Hall).
  destruct (arch_of_a_thrust alpha eta mu h ltac:(lra) He Hmu ltac:(lra) HO) as [p Hp]; [|now exists h, p].
  intros x Hx Hx'. now destruct (Hall x Hx Hx') as (H1 & H2 & H3).
Qed.

End Ring.
