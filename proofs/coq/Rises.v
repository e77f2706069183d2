(** * Of arches with one thickness and one rise the longer stand more easily

    The thickness is [tau] and the radius of the centroids [centroids], both to the radius of the extrados.  Where the
    thickness over the rise of the extrados is kept, [tau] is proportional to [1 - cos alpha]. *)

From Coq Require Import Ranalysis5.
From Couplet Require Import Overturning Surveys Thrusts Room Attained IntervalZ.

(** Cusa's inequality. *)
Lemma cusa (x : R) : 0 < x < PI -> 3 * sin x < x * (2 + cos x).
Proof.
  intros Hx. enough (0 < x * (2 + cos x) - 3 * sin x) by lra. apply (grows (fun t => t * (2 + cos t) - 3 * sin t)
    (fun t => 2 * (1 - cos t) - t * sin t)); [lra | at_zero | growing |]. intros c Hc. apply lag_positive. lra.
Qed.

(** What [A] lacks of 2 grows faster than the versine. *)
Lemma lack_of_A_grows (a b : R) : 0 < a < b -> b < PI -> (2 - A a) * (1 - cos b) < (2 - A b) * (1 - cos a).
Proof.
  intros Ha Hb. set (f := fun y => (2 - A y) / (1 - cos y)).
  destruct (MVT_cor2 f (fun y => (2 * y + y * cos y - 3 * sin y) / (1 - cos y) ^ 2) a b) as (c & Hc & Hin); [lra | |].
  - intros c Hc. assert (HV : 1 - cos c <> 0) by positive. apply is_derive_Reals. unfold f, A. auto_derive; [easy |].
    transitivity ((- (3 * sin c + c * cos c) * (1 - cos c) + 2 * c * sin c ^ 2) / (1 - cos c) ^ 3); [field; easy |].
    replace (sin c ^ 2) with ((1 - cos c) * (1 + cos c)) by (assert (H := circle c); lra). field; easy.
  - assert (0 < 1 - cos c) by positive. assert (K := cusa c ltac:(lra)).
    assert (0 < (2 * c + c * cos c - 3 * sin c) / (1 - cos c) ^ 2) by positive.
    assert (Hf : f a < f b) by nra. assert (0 < 1 - cos a) by positive. assert (0 < 1 - cos b) by positive.
    unfold f in Hf. apply (Rmult_lt_compat_r ((1 - cos a) * (1 - cos b))) in Hf; [field_simplify in Hf; lra | nra].
Qed.

Lemma versine_grows (a b : R) : 0 <= a -> a < b -> b <= PI -> 1 - cos a < 1 - cos b.
Proof. intros. assert (cos b < cos a) by (apply cos_decreasing_1; lra). lra. Qed.

(** ** Rotation *)

Lemma quotient_falls (n d d' : R) : 0 <= n -> 0 < d' <= d -> n / d <= n / d'.
Proof. intros Hn Hd. apply Rmult_le_compat_l; [easy |]. apply Rinv_le_contravar; lra. Qed.

Section Ring.

Variable delta : R. Hypothesis flag : 0 <= delta <= 1.

(** What a haunch asks of [A], [asked + centroids], lacks the less of 2 the thinner the ring is. *)
Lemma lack_of_haunch_falls (x tau tau' : R) : 0 <= x <= PI / 2 -> 0 < tau' <= tau -> tau <= 1 ->
  (2 - (asked delta x tau + centroids delta tau)) / tau <= (2 - (asked delta x tau' + centroids delta tau')) / tau'.
Proof.
  intros Hx Ht Ht1. destruct (haunch_signs x tau) as (HC & HV & Hb & Hl & Hw); try lra.
  destruct (haunch_signs x tau') as (_ & _ & _ & _ & Hw'); try lra.
  assert (E : forall t, 0 < t <= 1 -> 0 < 1 - cos x + t * cos x -> (2 - (asked delta x t + centroids delta t)) / t
    = 1 / 2 + (2 * (1 - cos x) - x * sin x) / (t * (1 - cos x + t * cos x))
      + (cos x + x * sin x - (1 - cos x) / 2) / (1 - cos x + t * cos x)
      - delta * cos x / 6 * ((t / (2 - t)) * (t / (1 - cos x + t * cos x)))).
  { intros t Ht0 Hw0. unfold asked, centroids. field. lra. }
  rewrite !E by lra. set (w := 1 - cos x + tau * cos x) in *. set (w' := 1 - cos x + tau' * cos x) in *.
  assert (Hww : w' <= w) by (unfold w, w'; nra).
  assert (H1 : (2 * (1 - cos x) - x * sin x) / (tau * w) <= (2 * (1 - cos x) - x * sin x) / (tau' * w')).
  { apply quotient_falls; [easy | split; [apply Rmult_lt_0_compat | apply Rmult_le_compat]; lra]. }
  assert (H2 : (cos x + x * sin x - (1 - cos x) / 2) / w <= (cos x + x * sin x - (1 - cos x) / 2) / w')
    by (apply quotient_falls; lra). assert (H3 : tau' / (2 - tau') * (tau' / w') <= tau / (2 - tau) * (tau / w)).
  { assert (Q : forall a b c d, 0 < b -> 0 < d -> a * d <= c * b -> a / b <= c / d).
    { intros a b c d Hb0 Hd0 H. apply (Rmult_le_reg_r (b * d)); [nra |]. field_simplify; lra. }
    apply Rmult_le_compat; try positive; apply Q; unfold w, w' in *; nra. }
  assert (0 <= delta * cos x / 6) by (assert (0 <= delta * cos x) by nra; lra). nra.
Qed.

(** So where crown, haunch and shoulder leave room they do in the longer arch. *)
Theorem rotation_goes_on (x alpha alpha' tau tau' : R) : 0 <= x <= PI / 2 -> 0 < alpha' < alpha -> alpha < PI ->
  0 < tau' -> tau <= 1 -> tau' * (1 - cos alpha) = tau * (1 - cos alpha') ->
  asked delta x tau + centroids delta tau <= A alpha -> asked delta x tau' + centroids delta tau' <= A alpha'.
Proof.
  intros Hx Ha Ha1 Ht' Ht Hway HA. assert (HV' : 0 < 1 - cos alpha') by positive.
  assert (HV := versine_grows alpha' alpha ltac:(lra) ltac:(lra) ltac:(lra)). assert (Htt : tau' < tau) by nra.
  assert (H1 := lack_of_A_grows alpha' alpha Ha Ha1). assert (H2 := lack_of_haunch_falls x tau tau' Hx ltac:(lra) Ht).
  set (a := asked delta x tau + centroids delta tau) in *. set (a' := asked delta x tau' + centroids delta tau') in *.
  set (V := 1 - cos alpha) in *. set (V' := 1 - cos alpha') in *.
  apply (Rmult_le_compat_r (tau * tau' * V')) in H2; [|positive].
  replace ((2 - a) / tau * (tau * tau' * V')) with ((2 - a) * (tau' * V')) in H2 by (field; lra).
  replace ((2 - a') / tau' * (tau * tau' * V')) with ((2 - a') * (tau' * V)) in H2 by (rewrite Hway; field; lra).
  assert (0 <= tau' * ((2 - A alpha) * V' - (2 - A alpha') * V)) by positive.
  assert (0 <= tau' * V' * (A alpha - a)) by positive.
  apply (Rmult_le_reg_r (tau' * V)); [apply Rmult_lt_0_compat|]; lra.
Qed.

(** ** Between haunch and shoulder, the thrust being kept *)

(** The centroids' radius is a convex number of [tau]. *)
Lemma chord_of_centroids (tau tau' : R) : 0 < tau' <= tau -> tau <= 1 ->
  (centroids delta tau' - centroids delta tau) * tau' <= (1 - centroids delta tau') * (tau - tau').
Proof.
  intros Ht Ht1. unfold centroids. set (k := fun t => t / (2 - t)). assert (k tau' <= k tau).
  { apply (Rmult_le_reg_r ((2 - tau') * (2 - tau))); [nra |]. unfold k. field_simplify; nra. }
  replace (delta * tau ^ 2 / (6 * (2 - tau))) with (delta * tau / 6 * k tau) by (unfold k; field; lra).
  replace (delta * tau' ^ 2 / (6 * (2 - tau'))) with (delta * tau' / 6 * k tau') by (unfold k; field; lra).
  assert (0 <= delta * tau * tau' / 6 * (k tau - k tau')).
  { apply Rmult_le_pos; [|lra]. assert (0 <= delta * tau * tau') by positive. lra. }
  nra.
Qed.

Lemma depth_goes_on (x h alpha alpha' tau tau' : R) : 0 <= x <= PI / 2 -> x <= alpha' ->
  0 < alpha' < alpha -> alpha < PI -> 0 < tau' -> tau <= 1 -> tau' * (1 - cos alpha) = tau * (1 - cos alpha') ->
  h <= 1 -> A alpha' - centroids delta tau' < h ->
  (1 - tau) * normal_force x h <= normal_force alpha h - centroids delta tau * (cos x - cos alpha) ->
  (1 - tau') * normal_force x h <= normal_force alpha' h - centroids delta tau' * (cos x - cos alpha').
Proof.
  intros Hx Hxa Ha Ha1 Ht' Ht Hway Hh HA HM. assert (HV' : 0 < 1 - cos alpha') by positive.
  assert (HV := versine_grows alpha' alpha ltac:(lra) ltac:(lra) ltac:(lra)). assert (Htt : tau' < tau) by nra.
  assert (Hv : 1 - cos x <= 1 - cos alpha').
  { destruct (Req_dec x alpha') as [-> | Hne]; [lra |]. apply Rlt_le, versine_grows; lra. }
  destruct (haunch_signs x tau Hx) as (_ & Hv0 & _ & Hlag & _); [lra |].
  assert (Hchord := chord_of_centroids tau tau' ltac:(lra) Ht). assert (Hl := lack_of_A_grows alpha' alpha Ha Ha1).
  rewrite (normal_force_by_A alpha) in HM by lra. rewrite (normal_force_by_A alpha') by lra. unfold normal_force in *.
  set (V := 1 - cos alpha) in *. set (V' := 1 - cos alpha') in *. set (v := 1 - cos x) in *.
  set (b := x * sin x) in *. replace (cos alpha) with (1 - V) in * by (unfold V; lra).
  replace (cos alpha') with (1 - V') in * by (unfold V'; lra). replace (cos x) with (1 - v) in * by (unfold v; lra).
  set (g := centroids delta tau) in *. set (g' := centroids delta tau') in *. set (a := A alpha) in *.
  set (a' := A alpha') in *. assert (Hg : V' * (g' - g) <= (2 - a') * (V - V')).
  { apply Rnot_lt_le. intros H. assert (H1 := Rmult_lt_compat_l tau' _ _ Ht' H).
    assert (V' * ((g' - g) * tau') <= V' * ((1 - g') * (tau - tau'))) by (apply Rmult_le_compat_l; lra).
    assert (0 <= tau' * ((V - V') * (1 - a' + g'))) by positive.
    assert ((tau' * V - tau * V') * (1 - g') = 0) by (rewrite Hway; ring). lra. }
  apply (Rmult_le_reg_l V); [lra |]. assert (P1 : 0 <= (V - V') * (v * (h + g' - a') + (2 * v - b)))
    by (apply Rmult_le_pos; [lra |]; apply Rplus_le_le_0_compat; [apply Rmult_le_pos |]; lra).
  assert (P2 : 0 <= V * ((2 - a) * V' - (2 - a') * V)) by positive.
  assert (P3 : 0 <= (V - v) * ((2 - a') * (V - V') - V' * (g' - g))) by positive.
  assert (P4 : 0 <= V' * (h + (a - h) * V - g * (1 - v - (1 - V)) - (1 - tau) * (h * (1 - v) + b))) by positive.
  assert (P5 : (tau' * V - tau * V') * (h * (1 - v) + b) = 0) by (rewrite Hway; ring). lra.
Qed.

(** ** The thrust of a haunch *)

Definition asked_slope (x tau : R) : R :=
  (- (x * sin x) - (- (1 / 2) + delta * (tau * (4 - tau)) / (6 * (2 - tau) ^ 2)) * (1 - cos x)
    - asked delta x tau * cos x) / (1 - cos x + tau * cos x).

Lemma derivative_of_asked (x tau : R) : 2 - tau <> 0 -> 1 - cos x + tau * cos x <> 0 ->
  is_derive (asked delta x) tau (asked_slope x tau).
Proof. intros H2 Hw. unfold asked_slope, asked, centroids. auto_derive; [repeat split; lra |]. field. easy. Qed.

Lemma asked_falls (x tau : R) : 0 < x <= PI / 2 -> 0 < tau <= 1 -> 0 < asked delta x tau -> asked_slope x tau < 0.
Proof.
  intros Hx Ht Hh. destruct (haunch_signs x tau ltac:(lra) Ht) as (HC & _ & Hb & _ & Hw).
  assert (0 < 1 - cos x) by positive.
  assert (0 <= delta * (tau * (4 - tau)) / (6 * (2 - tau) ^ 2) * (1 - cos x)) by positive.
  assert (0 <= asked delta x tau * cos x) by positive. unfold asked_slope.
  apply (Rmult_lt_reg_r (1 - cos x + tau * cos x)); [easy |]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** It grows less than half the thickness and what it lacks of 1 fall. *)
Lemma growth_of_asked (x tau : R) : 0 <= x <= PI / 2 -> 0 < tau <= 1 ->
  asked delta x tau < 1 /\ 0 < 1 - asked delta x tau + tau / 2 + tau * asked_slope x tau.
Proof.
  intros Hx Ht. destruct (haunch_signs x tau Hx Ht) as (HC & Hv & Hb & Hl & Hw).
  destruct (lack_of_asked delta flag x tau Hx Ht) as [E HPw]. cbv zeta in E, HPw.
  set (P := 2 * (1 - cos x) - x * sin x + _ + _) in *. set (w := 1 - cos x + tau * cos x) in *. split; [lra |].
  assert (E' : 1 - asked delta x tau + tau / 2 + tau * asked_slope x tau = (2 * (1 - cos x) - x * sin x) / w
    + tau * cos x * (P / w) / w + (tau / 2 - delta * (tau / (2 - tau)) ^ 2 / 3 * ((1 - cos x) / w))).
  { unfold asked_slope. rewrite E. unfold P, w in *. field. lra. }
  rewrite E'. assert (0 <= (2 * (1 - cos x) - x * sin x) / w) by positive. assert (0 <= tau * cos x) by positive.
  assert (0 <= tau * cos x * (P / w) / w) by positive. assert (0 <= tau / (2 - tau) <= tau).
  { split; [positive |]. apply (Rmult_le_reg_r (2 - tau)); [lra |]. assert (0 <= tau * (1 - tau)) by positive.
    field_simplify; lra. }
  assert (0 <= (1 - cos x) / w <= 1).
  { split; [positive |]. apply (Rmult_le_reg_r w); [easy |]. field_simplify; [unfold w |]; lra. }
  set (q := tau / (2 - tau)) in *. set (z := (1 - cos x) / w) in *. assert (q * q <= tau * tau) by nra.
  assert (0 <= q ^ 2 <= tau) by nra. assert (0 <= delta * q ^ 2 <= tau) by nra. nra.
Qed.

Lemma versine_against_sine (x : R) : 0 < x <= PI / 2 -> 0 < (2 - x ^ 2 / 6) * (1 - cos x) - x * sin x.
Proof.
  intros Hx. set (f2 := fun t => (cos t - 1) / 3 + t * sin t / 3 - t ^ 2 * cos t / 6).
  set (f1 := fun t => sin t - t * (1 + 2 * cos t) / 3 - t ^ 2 * sin t / 6).
  assert (H2 : forall t, 0 < t <= PI / 2 -> 0 < f2 t).
  { intros t Ht. apply (grows f2 (fun c => c ^ 2 * sin c / 6)); unfold f2; [lra | at_zero | growing |]. intros c Hc.
    assert (0 < sin c) by positive. assert (0 < c ^ 2 * sin c) by positive. lra. }
  assert (H1 : forall t, 0 < t <= PI / 2 -> 0 < f1 t).
  { intros t Ht. apply (grows f1 f2); [lra | unfold f1; at_zero | unfold f1, f2; growing |]. intros. apply H2. lra. }
  apply (grows (fun t => (2 - t ^ 2 / 6) * (1 - cos t) - t * sin t) f1); [lra | at_zero | unfold f1; growing |].
  intros c Hc. apply H1. lra.
Qed.

Lemma versine_against_slope (x : R) : 0 < x <= PI / 2 ->
  0 <= (x ^ 2 / 2 - x ^ 4 / 12) * cos x + (x * sin x - (1 - cos x) / 2) * x ^ 2 / 2 - x * sin x + 1 - cos x.
Proof.
  intros Hx. destruct (Rle_lt_dec x 1) as [Hx1 | Hx1].
  - rewrite (sine_by_defect x), (cosine_by_defect x) by lra. assert (HS := sine_defect_bounds x ltac:(lra)).
    assert (HC := cosine_defect_bounds x ltac:(lra)). set (s := sine_defect x) in *. set (c := cosine_defect x) in *.
    assert (0 < x ^ 2 <= 1) by nra. replace (x ^ 4) with (x ^ 2 * x ^ 2) by ring. set (y := x ^ 2) in *.
    replace (x * (x * (1 + y * s))) with (y * (1 + y * s)) by (unfold y; ring).
    assert (0 <= y * (1 - 3 * y / 4 + y * y / 12) * (- 1 / 2 + y / 24 - c)) by positive.
    assert (0 <= y * y * (1 - y / 2) * (- 1 / 6 + y / 120 - s)) by positive. nra.
  - interval with (i_prec 53, i_bisect x, i_taylor x).
Qed.

(** What a haunch asks for leaves [1 - h] at least as large as [tau] and the joint make it. *)
Lemma thrust_of_a_thin_haunch (x tau : R) : 0 < x <= PI / 2 -> 0 < tau <= 1 ->
  asked delta x tau * (tau + x ^ 2 / 2) <= x ^ 2 / 2 - x ^ 4 / 12.
Proof.
  intros Hx Ht. destruct (haunch_signs x tau ltac:(lra) Ht) as (HC & Hv & Hb & _ & Hw).
  assert (H0 := versine_against_sine x Hx). assert (H1 := versine_against_slope x Hx).
  apply (Rmult_le_reg_r (1 - cos x + tau * cos x)); [easy |].
  assert (E : asked delta x tau * (1 - cos x + tau * cos x) = (1 - tau) * (x * sin x) - (1 - tau / 2) * (1 - cos x)
    - delta * tau ^ 2 / (6 * (2 - tau)) * (1 - cos x)) by (unfold asked, centroids; field; lra).
  assert (0 <= delta * tau ^ 2 / (6 * (2 - tau)) * (1 - cos x)) by positive.
  assert (P : 0 <= (tau + x ^ 2 / 2) * (delta * tau ^ 2 / (6 * (2 - tau)) * (1 - cos x))) by positive.
  assert (P0 : 0 <= x ^ 2 / 2 * ((2 - x ^ 2 / 6) * (1 - cos x) - x * sin x)) by positive.
  assert (P1 := Rmult_le_pos tau _ ltac:(lra) H1).
  assert (P2 : 0 <= tau ^ 2 * (x * sin x - (1 - cos x) / 2)) by positive.
  replace (asked delta x tau * (tau + x ^ 2 / 2) * (1 - cos x + tau * cos x))
    with ((tau + x ^ 2 / 2) * (asked delta x tau * (1 - cos x + tau * cos x))) by ring. rewrite E. lra.
Qed.

(** ** A shoulder that slides *)

(** Where a joint's resultant is, by the angle whose tangent is [x/h]. *)
Lemma forces_by_angle (x h : R) : 0 < h -> let t := atan (x / h) in 0 < cos t /\
  shear_force x h * cos t = h * sin (t - x) /\ normal_force x h * cos t = h * cos (t - x).
Proof.
  intros Hh t. assert (Ht := atan_bound (x / h)). fold t in Ht. assert (0 < cos t) by positive.
  assert (E : x * cos t = h * sin t).
  { replace x with (h * tan t) at 1 by (unfold t; rewrite tan_atan; field; lra). unfold tan. field. lra. }
  rewrite sin_minus, cos_minus. unfold shear_force, normal_force. split; [easy | split].
  - transitivity (x * cos t * cos x - h * sin x * cos t); [ring | rewrite E; ring].
  - transitivity (x * cos t * sin x + h * cos x * cos t); [ring | rewrite E; ring].
Qed.

(** The joint half-way does not slide inwards, so that the thrust is not small. *)
Lemma thrust_of_sliding_shoulder (a h mu : R) : 0 < a <= PI / 2 -> 0 < h ->
  0 <= inward_gap (a / 2) mu h -> outward_gap a mu h = 0 -> 1 - a ^ 2 / 4 <= h.
Proof.
  intros Ha Hh HI HO. apply Rnot_lt_le. intros Hless. assert (PI / 2 < 1.58) by interval with (i_prec 53).
  destruct (forces_by_angle (a / 2) h Hh) as (C1 & S1 & N1). destruct (forces_by_angle a h Hh) as (C2 & S2 & N2).
  set (t1 := atan (a / 2 / h)) in *. set (t2 := atan (a / h)) in *. set (h1 := 1 - a ^ 2 / 4) in *.
  assert (3 / 2 * a < atan (a / 2 / h1) + atan (a / h1)).
  { set (f := fun t => atan (t / 2 / (1 - t ^ 2 / 4)) + atan (t / (1 - t ^ 2 / 4)) - 3 / 2 * t). assert (0 < f a).
    { apply (grows f (fun t => 3 * (t ^ 2 / 4) ^ 2 * (1 - t ^ 2 / 4) / (2 * (1 + (t ^ 2 / 4) ^ 3)))); [lra | | |].
      - unfold f. replace (0 / 2 / (1 - 0 ^ 2 / 4)) with 0 by field. replace (0 / (1 - 0 ^ 2 / 4)) with 0 by field.
        rewrite atan_0. lra.
      - intros c Hc. assert (0 < 1 - c ^ 2 / 4) by nra. unfold f. auto_derive; [repeat split; lra |].
        assert (0 <= c ^ 2 / 4) by nra. field. repeat split; nra.
      - intros c Hc. assert (0 < c ^ 2 / 4 < 1) by nra.
        apply Rdiv_lt_0_compat; [repeat apply Rmult_lt_0_compat; nra |]. assert (0 < (c ^ 2 / 4) ^ 3) by positive.
        lra. }
    unfold f, h1 in *. lra. }
  assert (Hmore : forall x, 0 < x -> atan (x / h1) < atan (x / h)).
  { intros x Hx. apply atan_increasing, Rmult_lt_compat_l; [easy |]. apply Rinv_lt_contravar; [|easy].
    assert (0 < h1) by (unfold h1; nra). nra. }
  assert (M1 := Hmore (a / 2) ltac:(lra)). assert (M2 := Hmore a ltac:(lra)). fold t1 in M1. fold t2 in M2.
  assert (B1 := atan_bound (a / 2 / h)). assert (B2 := atan_bound (a / h)). fold t1 in B1. fold t2 in B2.
  assert (HS : 0 < sin ((t1 - a / 2) + (t2 - a))) by positive. rewrite sin_plus in HS.
  assert (0 < normal_force a h) by (apply normal_force_positive_to_quarter; lra). unfold inward_gap, outward_gap in *.
  assert (K : shear_force (a / 2) h * normal_force a h + normal_force (a / 2) h * shear_force a h <= 0) by nra.
  apply (Rmult_le_compat_r (cos t1 * cos t2)) in K; [|nra].
  replace ((shear_force (a / 2) h * normal_force a h + normal_force (a / 2) h * shear_force a h) * (cos t1 * cos t2))
    with (shear_force (a / 2) h * cos t1 * (normal_force a h * cos t2)
      + normal_force (a / 2) h * cos t1 * (shear_force a h * cos t2)) in K by ring. rewrite S1, S2, N1, N2 in K.
  assert (0 < h * h) by nra. nra.
Qed.

(** As the half-angle falls, the friction of a shoulder that slides grows more than the thrust of the haunch takes. *)
Lemma shoulder_is_relieved (x y tau : R) : 0 < x <= PI / 2 -> 0 < y < PI -> 0 < tau <= 1 -> 0 < asked delta x tau ->
  (y <= PI / 2 -> 1 - y ^ 2 / 4 <= asked delta x tau) ->
  0 < y ^ 2 - asked delta x tau * (1 - asked delta x tau) + A y * (tau * asked_slope x tau).
Proof.
  intros Hx Hy Ht Hh Hnarrow. destruct (growth_of_asked x tau ltac:(lra) Ht) as (Hh1 & Hgrowth).
  assert (Hthin := thrust_of_a_thin_haunch x tau Hx Ht). set (h := asked delta x tau) in *.
  assert (0 < 1 - cos y) by positive. assert (0 < sin y) by positive.
  assert (0 < A y) by (unfold A; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
  assert (1.57 < PI / 2 < 1.58) by (split; interval with (i_prec 53)).
  assert (0 < A y * (1 - h + tau / 2 + tau * asked_slope x tau)) by positive.
  destruct (Rle_lt_dec y (PI / 2)) as [Hn | Hwide].
  - specialize (Hnarrow Hn). assert (A y < 2).
    { assert (L := lag_positive y Hy). apply (Rmult_lt_reg_r (1 - cos y)); [easy |]. unfold A. field_simplify; lra. }
    assert (tau * h <= 3 / 4 * (1 - h) ^ 2) by (assert (K := pow2_ge_0 (x ^ 2 - 3 * (1 - h))); lra).
    set (L := 1 - h) in *. replace h with (1 - L) in * by (unfold L; ring).
    assert (0 < L < 0.63) by (unfold L in *; nra). assert (0 <= (1 - L) * (y ^ 2 - 4 * L)) by positive.
    assert (Q' : A y * (L + tau / 2) <= 2 * (L + tau / 2)) by (apply Rmult_le_compat_r; lra).
    apply (Rmult_lt_reg_l (1 - L)); [lra |]. assert (0 < L * (1 - 3 / 4 * L - L ^ 2)) by positive.
    assert (0 < (1 - L) * (A y * (tau * asked_slope x tau) + (2 * L + tau))) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (cos y <= 0) by (apply cos_le_0; lra). assert (sin y <= 1 - cos y) by (destruct (SIN_bound y); lra).
    assert (A y <= y). { apply (Rmult_le_reg_r (1 - cos y)); [easy |]. unfold A.
                         replace (y * sin y / (1 - cos y) * (1 - cos y)) with (y * sin y) by (field; lra).
                         apply Rmult_le_compat_l; lra. }
    assert (A y * (1 - h + tau / 2) <= y * (1 - h + 1 / 2)) by (apply Rmult_le_compat; lra).
    assert (1.57 * (0.07 + h) <= y * (y - 3 / 2 + h)) by (apply Rmult_le_compat; lra). assert (0 <= h * h) by positive. lra.
Qed.

(** What is left wherever it is reached is not passed: a number that falls where it is zero and is not negative at the
    end is not at the beginning. *)
Lemma left_where_reached (f f' : R -> R) (a b : R) : a <= b ->
  (forall x, a <= x <= b -> derivable_pt_lim f x (f' x)) -> 0 <= f b ->
  (forall x, a <= x <= b -> f x = 0 -> f' x < 0) -> 0 <= f a.
Proof.
  intros Hab Hd Hb Hfalls. assert (Hlimit : forall g x, continuity_pt g x ->
    (forall d, 0 < d -> exists y, Rabs (y - x) < d /\ 0 <= g y) -> 0 <= g x).
  { intros g x Hg Hsome. apply Rnot_lt_le. intros Hneg. destruct (Hg (- g x) ltac:(lra)) as (d & Hd0 & H).
    destruct (Hsome d Hd0) as (y & Hy & Hpos). destruct (Req_dec x y) as [<- | Hne]; [lra |].
    assert (K := H y (conj (conj I Hne) Hy)). apply Rabs_def2 in K. lra. }
  assert (Hc : forall x, a <= x <= b -> continuity_pt f x)
    by (intros x Hx; apply derivable_continuous_pt; exists (f' x); now apply Hd).
  destruct (least_is_attained (fun x => a <= x <= b /\ 0 <= f x) a b) as (z & (Hz & Hfz) & Hleast);
    [lra | intros; lra | |].
  { intros x Hx Hnear. split; [easy |]. apply Hlimit; [now apply Hc |]. intros d Hd0.
    destruct (Hnear d Hd0) as (y & Hy & _ & H). now exists y. }
  destruct (Req_dec z a) as [-> | Hne]; [easy | exfalso].
  assert (Hbelow : forall d, 0 < d -> let k := Rmin (d / 2) (z - a) in 0 < k < d /\ f (z - k) < 0).
  { intros d Hd0 k. assert (k <= d / 2) by apply Rmin_l. assert (k <= z - a) by apply Rmin_r.
    assert (0 < k) by (apply Rmin_glb_lt; lra). split; [lra |]. apply Rnot_le_lt. intros Hno.
    enough (z <= z - k) by lra. apply Hleast. split; [lra | easy]. }
  assert (Hzero : f z = 0).
  { enough (0 <= - f z) by lra. apply (Hlimit (fun x => - f x)); [now apply continuity_pt_opp, Hc |]. intros d Hd0.
    destruct (Hbelow d Hd0) as [Hk Hneg]. eexists. split; [|apply Rlt_le, Ropp_0_gt_lt_contravar, Hneg].
    apply Rabs_def1; lra. }
  assert (Hf := Hfalls z Hz Hzero). destruct (Hd z Hz (- f' z) ltac:(lra)) as ([d Hd0] & H).
  destruct (Hbelow d Hd0) as [Hk Hneg]. set (k := Rmin (d / 2) (z - a)) in *.
  specialize (H (- k) ltac:(lra) ltac:(rewrite Rabs_Ropp, Rabs_pos_eq; simpl; lra)). apply Rabs_def2 in H.
  replace (z + - k) with (z - k) in H by ring. replace ((f (z - k) - f z) / - k) with (- f (z - k) / k) in H
    by (rewrite Hzero; field; lra). assert (0 < - f (z - k) / k) by positive. lra.
Qed.

(** A thrust that grows with that of a haunch is borne by the shoulder's friction. *)
Lemma shoulder_goes_on (x k mu h0 alpha alpha' : R) : 0 < x <= PI / 2 -> 0 < alpha' < alpha -> alpha < PI -> 0 < mu ->
  0 < k -> k * (1 - cos alpha) <= 1 -> 0 < h0 ->
  (forall y, 0 <= y <= alpha -> y <= PI / 2 -> 0 <= inward_gap y mu h0) -> 0 <= outward_gap alpha mu h0 ->
  asked delta x (k * (1 - cos alpha)) <= h0 < asked delta x (k * (1 - cos alpha')) ->
  0 <= outward_gap alpha' mu (asked delta x (k * (1 - cos alpha'))).
Proof.
  intros Hx Ha Ha1 Hmu Hk Hk1 Hh0 HI HO Hh. set (r := fun y => asked delta x (k * (1 - cos y))).
  set (r' := fun y => k * sin y * asked_slope x (k * (1 - cos y))).
  assert (Ht : forall y, alpha' <= y <= alpha -> 0 < k * (1 - cos y) <= 1).
  { intros y Hy. assert (0 < 1 - cos y) by positive. split; [positive |].
    assert (cos alpha <= cos y) by (apply cos_decr_1; lra). nra. }
  assert (Hr : forall y, alpha' <= y <= alpha -> is_derive r y (r' y)).
  { intros y Hy. destruct (haunch_signs x (k * (1 - cos y))) as (_ & _ & _ & _ & Hw); [lra | now apply Ht |].
    assert (T := Ht y Hy). apply (is_derive_comp (asked delta x) (fun y => k * (1 - cos y)));
      [apply derivative_of_asked; lra | auto_derive; [easy | ring]]. }
  destruct (f_interv_is_interv (fun y => - r y) alpha' alpha (- h0)) as (z & Hz & Ez); [lra | unfold r; lra | |].
  { intros y Hy. apply continuity_pt_opp, derivable_continuous_pt. exists (r' y). now apply is_derive_Reals, Hr. }
  assert (Hmore : forall y, alpha' <= y <= z -> h0 <= r y).
  { intros y Hy. enough (0 <= r y - h0) by lra.
    apply (left_where_reached (fun y => r y - h0) r' y z); [lra | | lra |].
    - intros c Hc. replace (r' c) with (r' c - 0) by ring. apply (derivable_pt_lim_minus r (fun _ => h0));
        [apply is_derive_Reals, Hr; lra | apply derivable_pt_lim_const].
    - intros c Hc E. assert (T := Ht c ltac:(lra)). apply (asked_falls x _ Hx) in T; [|fold (r c); lra].
      assert (0 < k * sin c) by positive. unfold r'. nra. }
  set (slope := fun y => mu * ((1 - r y) * sin y + y * cos y + r' y * cos y)
    + ((1 - r y) * cos y - y * sin y - r' y * sin y)).
  apply (left_where_reached (fun y => outward_gap y mu (r y)) slope alpha' z); [lra | | |].
  - intros y Hy. assert (D := Hr y ltac:(lra)). apply is_derive_Reals. unfold slope, outward_gap, normal_force.
    unfold shear_force. auto_derive; [repeat split; now exists (r' y) |].
    replace (Derive (fun t : R => r t) y) with (r' y) by (symmetry; now apply is_derive_unique). ring.
  - cbv beta. replace (r z) with h0 by lra. destruct (Req_dec z alpha) as [-> | Hne]; [easy |].
    apply Rlt_le, (no_outward_limit_within z alpha); lra.
  - intros y Hy E. assert (T := Ht y ltac:(lra)). assert (M := Hmore y Hy). cbv beta in E.
    assert (0 < 1 - cos y) by positive. assert (0 < sin y) by positive. assert (0 < normal_force y (r y)).
    { destruct (Rle_lt_dec y (PI / 2)); [apply normal_force_positive_to_quarter; lra |].
      assert (cos y < 0) by (apply cos_lt_0; lra). unfold outward_gap, shear_force in E.
      apply (Rmult_lt_reg_l mu); [easy |]. assert (0 < r y * sin y) by positive. nra. }
    assert (0 < y ^ 2 - r y * (1 - r y) + A y * (k * (1 - cos y) * asked_slope x (k * (1 - cos y)))).
    { apply (shoulder_is_relieved x y); try easy; [lra | fold (r y); lra |]. intros Hn. fold (r y).
      apply (thrust_of_sliding_shoulder y (r y) mu); [lra | lra | | easy]. assert (0 <= cos (y / 2)) by positive.
      assert (0 < sin (y / 2)) by positive. specialize (HI (y / 2) ltac:(lra) ltac:(lra)).
      unfold inward_gap, normal_force, shear_force in *. assert (0 <= mu * cos (y / 2)) by positive.
      assert (0 <= (r y - h0) * (mu * cos (y / 2) + sin (y / 2))) by positive. lra. }
    apply (Rmult_lt_reg_l (normal_force y (r y))); [easy |].
    assert (EA : A y * (k * (1 - cos y) * asked_slope x (k * (1 - cos y))) = y * r' y)
      by (unfold A, r'; field; lra). assert (C := circle y). unfold outward_gap in E.
    replace (normal_force y (r y) * slope y) with (- (y ^ 2 - r y * (1 - r y) + y * r' y)); [lra |].
    transitivity (- shear_force y (r y) * ((1 - r y) * sin y + y * cos y + r' y * cos y)
      + normal_force y (r y) * ((1 - r y) * cos y - y * sin y - r' y * sin y)).
    + unfold shear_force, normal_force.
      transitivity (- (y ^ 2 - r y * (1 - r y) + y * r' y) * (sin y ^ 2 + cos y ^ 2)); [rewrite C |]; ring.
    + replace (- shear_force y (r y)) with (mu * normal_force y (r y)) by lra. unfold slope. ring.
Qed.

(** ** The longer arch stands *)

Lemma rotation_of_one_rise (alpha alpha' eta eta' h x : R) : 0 < alpha' < alpha -> alpha < PI -> 0 < eta <= 2 ->
  0 < eta' <= 2 -> slenderness eta' * (1 - cos alpha) = slenderness eta * (1 - cos alpha') -> 0 <= h ->
  (forall y, 0 <= y <= alpha -> y <= PI / 2 -> asked delta y (slenderness eta) <= h /\
     clear_of_shoulder delta alpha (slenderness eta) h y) -> 0 <= x <= alpha' -> x <= PI / 2 ->
  asked delta x (slenderness eta') + centroids delta (slenderness eta') <= A alpha'.
Proof.
  intros Ha Ha1 He He' Hway Hh Hall Hx Hx'. assert (T := slenderness_between eta He).
  assert (T' := slenderness_between eta' He'). destruct (Hall 0 ltac:(lra) ltac:(lra)) as [_ H0].
  destruct (Hall x ltac:(lra) Hx') as [H1 H2].
  apply (rotation_goes_on x alpha alpha' (slenderness eta) (slenderness eta')); try easy; try lra.
  apply (room_for_rotation delta flag alpha eta h x); easy || lra.
Qed.

Definition all_joints_stand (alpha eta : R) : Prop :=
  exists h p, forall x, 0 <= x <= alpha -> joint_stands delta x eta h p.

(** Where friction has no limit rotation decides. *)
Lemma longer_joints_of_one_rise (alpha alpha' eta eta' : R) : 0 < alpha' < alpha -> alpha < PI -> 0 < eta <= 2 ->
  0 < eta' <= 2 -> slenderness eta' * (1 - cos alpha) = slenderness eta * (1 - cos alpha') ->
  all_joints_stand alpha eta -> all_joints_stand alpha' eta'.
Proof.
  intros Ha Ha1 He He' Hway (h & p & Hall). assert (Hh : 0 <= h).
  { destruct (Hall 0 ltac:(lra)) as [H _]. now rewrite normal_force_at_crown in H. }
  assert (Hrotation : forall x, 0 <= x <= alpha' -> x <= PI / 2 -> _) by (intros x Hx Hx';
    exact (rotation_of_one_rise alpha alpha' eta eta' h x Ha Ha1 He He' Hway Hh (fun y Hy Hy' =>
      demands_of_joints delta alpha eta h p y ltac:(lra) He Hall Hy Hy') Hx Hx')). set (tau := slenderness eta') in *.
  exists (A alpha' - centroids delta tau). assert (H0 := Hrotation 0 ltac:(lra) ltac:(lra)). unfold asked in H0.
  rewrite sin_0, cos_0 in H0. apply (joints_of_a_thrust delta flag); [lra | easy | unfold Rdiv in H0; lra |].
  intros x Hx Hx'. fold tau. specialize (Hrotation x Hx Hx'). split; lra.
Qed.

Lemma longer_arch_of_one_rise (alpha alpha' eta eta' mu : R) : 0 < alpha' < alpha -> alpha < PI -> 0 < eta <= 2 ->
  0 < eta' <= 2 -> 0 < mu -> slenderness eta' * (1 - cos alpha) = slenderness eta * (1 - cos alpha') ->
  arch_stands delta alpha eta mu -> arch_stands delta alpha' eta' mu.
Proof.
  intros Ha Ha1 He He' Hmu Hway Hstands. assert (T := slenderness_between eta He).
  assert (T' := slenderness_between eta' He'). set (tau := slenderness eta) in *. set (tau' := slenderness eta') in *.
  assert (HV : 0 < 1 - cos alpha) by positive.
  destruct (thrust_of_an_arch delta flag alpha eta mu ltac:(lra) He Hmu Hstands) as (h & Hh & HO & Hall).
  fold tau in Hall.
  assert (Hrotation : forall x, 0 <= x <= alpha' -> x <= PI / 2 ->
    asked delta x tau' + centroids delta tau' <= A alpha').
  { intros x Hx Hx'. apply (rotation_of_one_rise alpha alpha' eta eta' h x); try easy; try lra.
    intros y Hy Hy'. destruct (Hall y Hy Hy') as (H1 & H2 & _). easy. }
  set (m := Rmin alpha' (PI / 2)). assert (M1 : m <= alpha') by apply Rmin_l.
  assert (M2 : m <= PI / 2) by apply Rmin_r. assert (M0 : 0 < m) by (apply Rmin_glb_lt; lra).
  destruct (continuity_ab_maj (fun x => asked delta x tau') 0 m ltac:(lra)) as (x & Hmax & Hx).
  { intros c Hc. destruct (haunch_signs c tau' ltac:(lra) T') as (_ & _ & _ & _ & Hw). unfold asked. reg. lra. }
  assert (Hmost : forall y, 0 <= y <= alpha' -> y <= PI / 2 -> asked delta y tau' <= asked delta x tau')
    by (intros y Hy Hy'; apply Hmax; split; [lra | now apply Rmin_glb]).
  destruct (Rle_lt_dec (asked delta x tau') h) as [Hle | Hgt].
  - exists h. apply (arch_of_a_thrust delta flag alpha' eta' mu h); try easy; try lra.
    + apply Rlt_le, (no_outward_limit_within alpha' alpha); lra.
    + intros y Hy Hy'. destruct (Hall y ltac:(lra) Hy') as (_ & H2 & H3). fold tau'. split; [|split; [|easy]].
      * apply Rle_trans with (asked delta x tau'); [now apply Hmost | easy].
      * intros HA. apply (depth_goes_on y h alpha alpha' tau tau'); try easy; lra.
  - exists (asked delta x tau').
    apply (arch_of_a_thrust delta flag alpha' eta' mu (asked delta x tau')); try easy; try lra.
    + assert (E : forall y t, t * (1 - cos alpha) = tau * (1 - cos y) -> tau / (1 - cos alpha) * (1 - cos y) = t)
        by (intros y t E; apply (Rmult_eq_reg_r (1 - cos alpha)); [field_simplify|]; lra).
      assert (Hk : 0 < tau / (1 - cos alpha)) by positive.
      assert (H := shoulder_goes_on x (tau / (1 - cos alpha)) mu h alpha alpha').
      rewrite (E alpha tau), (E alpha' tau') in H by (easy || lra). apply H; try easy; try lra.
      * split; [|lra]. destruct (Req_dec x 0) as [E0 | Hne]; [exfalso | lra]. revert Hgt. rewrite E0. unfold asked.
        rewrite sin_0, cos_0. unfold Rdiv. ring_simplify ((1 - tau') * (0 * 0) - centroids delta tau' * (1 - 1)). lra.
      * intros y Hy Hy'. now apply Hall.
      * split; [apply Hall; lra | easy].
    + intros y Hy Hy'. destruct (Hall y ltac:(lra) Hy') as (_ & _ & H3). fold tau'. repeat split.
      * now apply Hmost.
      * intros HA. specialize (Hrotation x ltac:(lra) ltac:(lra)). lra.
      * unfold inward_gap, normal_force, shear_force in *. assert (0 <= cos y) by positive.
        assert (0 <= sin y) by positive. assert (0 <= mu * cos y) by positive.
        assert (0 <= (asked delta x tau' - h) * (mu * cos y + sin y)) by positive. lra.
Qed.

Lemma slenderness_tells_the_thickness (eta eta' : R) : 0 < eta -> 0 < eta' ->
  slenderness eta <= slenderness eta' -> eta <= eta'.
Proof.
  intros He He' H. apply (Rmult_le_compat_r ((2 + eta) * (2 + eta'))) in H; [|nra]. unfold slenderness in H.
  field_simplify in H; lra.
Qed.

(** A longer arch of no thinner ring over its rise stands. *)
Theorem longer_arch_stands (alpha alpha' eta eta' : R) : 0 < alpha' <= alpha -> alpha < PI -> 0 < eta <= 2 ->
  0 < eta' <= 2 -> slenderness eta * (1 - cos alpha') <= slenderness eta' * (1 - cos alpha) ->
  (forall mu mu', 0 < mu <= mu' -> arch_stands delta alpha eta mu -> arch_stands delta alpha' eta' mu') /\
  (all_joints_stand alpha eta -> all_joints_stand alpha' eta').
Proof.
  intros Ha Ha1 He He' Hway. assert (T := slenderness_between eta He). assert (T' := slenderness_between eta' He').
  assert (HV : 0 < 1 - cos alpha) by positive. assert (HV' : 0 < 1 - cos alpha') by positive.
  assert (HVV : cos alpha <= cos alpha') by (apply cos_decr_1; lra).
  set (tau := slenderness eta * (1 - cos alpha') / (1 - cos alpha)). set (eta1 := 2 * tau / (2 - tau)).
  assert (Etau : tau * (1 - cos alpha) = slenderness eta * (1 - cos alpha')) by (unfold tau; field; lra).
  assert (Htau : 0 < tau) by (apply Rdiv_lt_0_compat; positive). assert (Htau' : tau <= slenderness eta')
    by (apply (Rmult_le_reg_r (1 - cos alpha)); lra).
  assert (He1 : 0 < eta1) by (apply Rdiv_lt_0_compat; lra).
  assert (E1 : slenderness eta1 = tau) by (unfold slenderness, eta1; field; lra).
  assert (Hless : eta1 <= eta') by (apply slenderness_tells_the_thickness; lra).
  destruct (Rle_lt_or_eq_dec alpha' alpha) as [Hlt | E]; [lra | |].
  - split.
    + intros mu mu' Hmu H.
      apply (narrower_rougher_thicker_stands delta alpha' alpha' eta1 eta' mu mu'); try easy; try lra.
      apply (longer_arch_of_one_rise alpha alpha' eta eta1 mu); try easy; try lra. now rewrite E1.
    + intros H. destruct (longer_joints_of_one_rise alpha alpha' eta eta1) as (h & p & Hall); try easy; try lra.
      * now rewrite E1.
      * exists h, p. apply (narrower_thicker_stands delta alpha' alpha' eta1 eta'); easy || lra.
  - assert (eta <= eta') by (apply slenderness_tells_the_thickness; try lra; rewrite E in Etau; nra). rewrite E.
    split.
    + intros mu mu' Hmu. apply (narrower_rougher_thicker_stands delta alpha alpha eta eta' mu mu'); easy || lra.
    + intros (h & p & Hall). exists h, p. apply (narrower_thicker_stands delta alpha alpha eta eta'); easy || lra.
Qed.

End Ring.

(** ** Longer spans *)

Lemma versine_of_opening (span rise : R) : 0 < span -> 0 < rise ->
  (1 - cos (opening span rise)) * radius span rise = rise.
Proof.
  intros Hs Hf. unfold opening. set (t := atan (2 * rise / span)). assert (HC : cos t <> 0).
  { assert (B := atan_bound (2 * rise / span)). apply Rgt_not_eq, cos_gt_0; unfold t; lra. }
  assert (E : sin t = 2 * rise / span * cos t).
  { replace (2 * rise / span) with (tan t) by apply tan_atan. unfold tan. field. easy. }
  assert (K := circle t). rewrite cos_2a_sin. rewrite E in *. unfold radius.
  apply (Rmult_eq_reg_r (2 * rise)); [|lra].
  transitivity (2 * rise ^ 2 * ((2 * rise / span * cos t) ^ 2 + cos t ^ 2)); [field | rewrite K; ring]; lra.
Qed.

(** If an arch stands, so does each with the same weight, thickness and rise, no less friction and a longer span,
    wherever the rise is measured. *)
Theorem longer_span_stands (delta c t span span' rise : R) : 0 <= delta <= 1 -> -1 <= c <= 1 -> 0 < t ->
  0 < span <= span' -> 0 < rise -> t <= 2 * (radius span rise + c * t / 2) ->
  let alpha s := opening s rise in let eta s := ratio c t (radius s rise) in
  (forall mu mu', 0 < mu <= mu' -> arch_stands delta (alpha span) (eta span) mu ->
     arch_stands delta (alpha span') (eta span') mu') /\
  (all_joints_stand delta (alpha span) (eta span) -> all_joints_stand delta (alpha span') (eta span')).
Proof.
  intros Hd Hc Ht Hs Hf Hroom alpha eta. assert (Hr := radius_of_spans span span' rise Hs Hf).
  assert (Hr0 := radius_positive span rise ltac:(lra) Hf).
  destruct (ratio_between c t t (radius span rise) (radius span rise)) as (Hp & He); try lra.
  destruct (ratio_between c t t (radius span rise) (radius span' rise)) as (Hp' & He'); try lra.
  assert (Hs' : 0 < span') by lra. assert (E := versine_of_opening span rise ltac:(lra) Hf).
  assert (E' := versine_of_opening span' rise Hs' Hf). assert (Ha := opening_between span rise ltac:(lra) Hf).
  assert (Ha' := opening_between span' rise Hs' Hf). assert (alpha span' <= alpha span) by (apply opening_grows; nra).
  apply longer_arch_stands; try easy. unfold alpha, eta.
  replace (slenderness (ratio c t (radius span rise))) with (t / (radius span rise + c * t / 2 + t / 2))
    by (unfold slenderness, ratio; field; lra).
  replace (slenderness (ratio c t (radius span' rise))) with (t / (radius span' rise + c * t / 2 + t / 2))
    by (unfold slenderness, ratio; field; lra). set (r := radius span rise) in *. set (r' := radius span' rise) in *.
  clearbody r r'.
  replace (1 - cos (opening span rise)) with (rise / r) by (apply (Rmult_eq_reg_r r); [field_simplify|]; lra).
  replace (1 - cos (opening span' rise)) with (rise / r') by (apply (Rmult_eq_reg_r r'); [field_simplify|]; lra).
  apply (Rmult_le_reg_r (r * r' * (r + c * t / 2 + t / 2) * (r' + c * t / 2 + t / 2)));
    [positive |]. field_simplify; [|lra | lra]. assert (0 <= t * rise * (t * ((c + 1) * (r' - r)))) by positive. nra.
Qed.
