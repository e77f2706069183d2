(** * Verdicts on an arch that is not at its least thickness

    An arch **stands** where a thrust and its moment at the crown leave a few numbers positive: those at crown and
    shoulder, that at the joint where the moment about the intrados is least, and friction at the shoulder and inside.

    An arch is **too wide** where not even the physical limit is enough at the least thrust that friction allows: then
    no thickness is. *)

From Couplet Require Import Moments Overturning Sliding States.

(** ** The line of thrust *)

Section Inside.

Variables (delta alpha eta h p : R).
Hypotheses (opening : 0 < alpha < PI) (thickness : 0 < eta <= 2) (thrust : 0 < h)
  (compression : 0 < normal_force alpha h) (crown : p <= at_crown eta h)
  (shoulder : p <= at_shoulder delta alpha eta h).

(** Moment about the intrados at a joint. *)
Definition room (x : R) : R := p + fac delta eta * (1 - cos x) - intrados eta * normal_force x h.

Lemma inside_if_room : (forall x, 0 <= x <= alpha -> 0 <= room x) -> thrust_inside delta alpha eta h p.
Proof.
  unfold room, at_crown, at_shoulder in *. intros Hroom x Hx. specialize (Hroom x Hx). split; [|split].
  - apply Rlt_le, (normal_force_positive alpha); lra.
  - lra.
  - apply (extrados_safe delta alpha); try lra. unfold extrados; lra.
Qed.

(** Least at the crown, from which it grows. *)
Theorem inside_nearest_at_crown : 0 <= room 0 -> intrados eta * (2 - h) <= fac delta eta ->
  thrust_inside delta alpha eta h p.
Proof.
  intros Hroom Haway. apply inside_if_room. intros x Hx.
  assert (H := margin_falls_from_crown (intrados eta) (fac delta eta) h ltac:(unfold intrados; lra) x ltac:(lra) ltac:(lra)).
  unfold room, margin in *. lra.
Qed.

(** Least at a joint between, where it is stationary. *)
Theorem inside_nearest_at_haunch (beta : R) : 0 < beta < PI -> eta < 2 -> h = h_tangency delta beta eta ->
  0 <= room beta -> thrust_inside delta alpha eta h p.
Proof.
  intros Hb He H5 Hroom. apply inside_if_room. intros x Hx. unfold room in *.
  assert (H := intrados_safe delta beta eta h p Hb ltac:(lra) ltac:(lra) H5 x ltac:(lra)). lra.
Qed.

(** Least at the shoulder, as far as which it falls. *)
Theorem inside_nearest_at_shoulder : 0 <= room alpha ->
  fac delta eta * sin alpha <= intrados eta * ((1 - h) * sin alpha + alpha * cos alpha) ->
  thrust_inside delta alpha eta h p.
Proof.
  intros Hroom Hnearer. apply inside_if_room. intros x Hx. destruct (Req_dec x alpha) as [-> | Hne]; [easy|].
  assert (HS : 0 < sin alpha) by positive.
  assert (H : margin (intrados eta) (fac delta eta) h x <= margin (intrados eta) (fac delta eta) h alpha).
  { apply margin_rises; try (unfold intrados; lra). unfold direction, cot.
    apply (Rmult_le_reg_r (sin alpha)); [easy|]. field_simplify; lra. }
  unfold room, margin in *. lra.
Qed.

End Inside.

(** ** Friction *)

(** Inwards no joint asks for more than the steepest, even if that is beyond the shoulder. *)
Lemma steepness_below_mu_is (h alpha x : R) : 0 < h < 1 -> alpha <= PI -> 0 < normal_force alpha h ->
  0 <= x <= alpha -> steepness x h <= mu_is h.
Proof.
  intros Hh Ha HN Hx. rewrite mu_is_from_statics by easy.
  destruct (Rtotal_order x (beta_s h)) as [Hless | [-> | Hmore]]; [| lra |]; apply Rlt_le;
    [apply steepness_grows_before_beta_s | apply (steepness_falls_after_beta_s h alpha)]; lra.
Qed.

(** Outwards no joint asks for more than the shoulder, and inwards none for more than a bound. *)
Lemma friction_within (h alpha mu : R) : 0 < h < 1 -> 0 < alpha < PI -> 0 < normal_force alpha h ->
  mu_ss alpha h <= mu -> (forall x, 0 <= x <= alpha -> steepness x h <= mu) ->
  forall x, 0 <= x <= alpha -> friction_holds x mu h.
Proof.
  intros Hh Ha HN Hout Hin x Hx. assert (0 < normal_force x h) by (apply (normal_force_positive alpha); lra).
  assert (crown : steepness 0 h = 0) by (unfold steepness, shear_force; rewrite sin_0; unfold Rdiv; ring).
  assert (0 <= mu) by (rewrite <- crown; apply Hin; lra).
  assert (outwards := proj2 (no_outward_sliding h alpha mu Hh ltac:(lra) HN ltac:(lra)) Hout x Hx).
  specialize (Hin x Hx). apply steepness_at_most in Hin; [|easy]. apply Rabs_le. lra.
Qed.

Theorem friction_by_steepest (h alpha mu : R) : 0 < h < 1 -> 0 < alpha < PI -> 0 < normal_force alpha h ->
  mu_ss alpha h <= mu -> mu_is h <= mu -> forall x, 0 <= x <= alpha -> friction_holds x mu h.
Proof.
  intros Hh Ha HN Hout Hin. apply friction_within; try easy. intros x Hx.
  assert (H := steepness_below_mu_is h alpha x Hh ltac:(lra) HN Hx). lra.
Qed.

(** An arch that ends before the steepest joint asks for most at the shoulder. *)
Theorem friction_of_short_arch (h alpha mu : R) : 0 < h < 1 -> 0 < alpha < PI -> 0 < normal_force alpha h ->
  alpha <= beta_s h -> mu_ss alpha h <= mu -> - mu <= mu_ss alpha h ->
  forall x, 0 <= x <= alpha -> friction_holds x mu h.
Proof.
  intros Hh Ha HN Hs Hout Hin. apply friction_within; try easy. intros x Hx.
  replace (mu_ss alpha h) with (- steepness alpha h) in Hin
    by (unfold mu_ss, steepness, shear_force, normal_force in *; field; lra).
  destruct (Req_dec x alpha) as [-> | Hne]; [lra|].
  assert (H := steepest_joint_of_short_arch h alpha x ltac:(lra) Hs ltac:(lra)). lra.
Qed.

(** ** Too wide *)

(** The share of the limit that the shoulder bears falls with the half-angle, *)
Definition share (alpha h : R) : R := normal_force alpha h / (1 - cos alpha).

Lemma share_is (alpha h : R) : 0 < alpha < PI -> share alpha h = h * (cos alpha / (1 - cos alpha)) + A alpha.
Proof. unfold share, normal_force, A. lra. Qed.

Lemma share_falls (a b h : R) : 0 < a -> a < b -> b < PI -> 0 <= h -> share b h < share a h.
Proof.
  intros Ha Hab Hb Hh. rewrite !share_is by lra. assert (HA := A_strictly_decreasing a b Ha Hab ltac:(lra)).
  assert (0 < 1 - cos a) by positive. assert (0 < 1 - cos b) by positive.
  assert (cos b < cos a) by (apply cos_decreasing_1; lra). assert (cos b / (1 - cos b) <= cos a / (1 - cos a)).
  { apply (Rmult_le_reg_r ((1 - cos a) * (1 - cos b))); [positive|]. field_simplify; lra. }
  nra.
Qed.

(** and is at the limit only beyond a semicircle. *)
Lemma wide_at_limit (alpha h : R) : 0 < alpha < PI -> 0 <= h -> share alpha h <= 2 / 3 -> cos alpha < 0.
Proof.
  intros Ha Hh Hshare. apply Rnot_le_lt. intros Hcos. assert (Hquarter : alpha <= PI / 2).
  { apply Rnot_lt_le. intros H. assert (cos alpha < 0) by (apply cos_lt_0; lra). lra. }
  rewrite share_is in Hshare by easy. assert (Hv : 0 < 1 - cos alpha) by positive.
  assert (0 <= h * (cos alpha / (1 - cos alpha)))
    by (apply Rmult_le_pos; [easy|]; apply Rmult_le_pos; [easy | now apply Rlt_le, Rinv_0_lt_compat]).
  assert (H2 : A (PI / 2) = PI / 2) by (unfold A; rewrite sin_PI2, cos_PI2; field). assert (HPI := PI2_3_2).
  destruct (Req_dec alpha (PI / 2)) as [-> | Hne]; [lra|].
  assert (HA := A_strictly_decreasing alpha (PI / 2) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(** At the limit the half-angle [alpha0] just stands with the thrust [h0]; a wider arch whose thrust is no
    smaller does not at any thickness. *)
Lemma wider_does_not_stand (delta alpha0 alpha eta h0 h p : R) : delta = 0 \/ delta = 1 -> 0 < alpha0 ->
  alpha0 < alpha -> alpha < PI -> 0 < eta <= 2 -> 0 <= h0 <= h ->
  2 * normal_force alpha0 h0 = fac delta 2 * (1 - cos alpha0) -> ~ thrust_inside delta alpha eta h p.
Proof.
  intros Hd Ha0 Ha Hopen He Hh Hlimit Hall. assert (0 < 1 - cos alpha0) by positive.
  assert (0 < 1 - cos alpha) by positive. assert (Hshare : share alpha0 h0 = fac delta 2 / 2).
  { unfold share. apply (Rmult_eq_reg_r (2 * (1 - cos alpha0))); [|lra]. field_simplify; lra. }
  assert (cos alpha0 < 0).
  { apply (wide_at_limit alpha0 h0); try lra. rewrite Hshare. destruct Hd as [-> | ->]; unfold fac; lra. }
  assert (cos alpha < cos alpha0) by (apply cos_decreasing_1; lra). assert (share alpha h < fac delta 2 / 2).
  { rewrite <- Hshare. apply Rle_lt_trans with (share alpha h0); [|apply share_falls; lra]. rewrite !share_is by lra.
    assert (cos alpha / (1 - cos alpha) <= 0) by (rewrite <- (Rmult_0_l (/ (1 - cos alpha))); apply Rmult_le_compat_r;
      [now apply Rlt_le, Rinv_0_lt_compat | lra]). nra. }
  assert (Hat : thrust_inside delta alpha 2 h p)
    by (apply (thicker_stands delta alpha eta); try easy; destruct Hd as [-> | ->]; lra).
  destruct (Hat 0 ltac:(lra)) as (_ & Hcrown & _), (Hat alpha ltac:(lra)) as (_ & _ & Hshoulder).
  assert (E : share alpha h * (1 - cos alpha) = normal_force alpha h) by (unfold share; field; lra).
  rewrite cos_0 in Hcrown. unfold intrados, extrados in *. nra.
Qed.

(** Friction asks for the least thrust [h0], *)
Theorem too_wide (delta alpha0 alpha mu h0 : R) :
  delta = 0 \/ delta = 1 -> 0 < alpha0 -> alpha0 < alpha -> alpha < PI -> 0 < h0 < 1 ->
  mu = mu_is h0 -> beta_s h0 <= alpha0 -> 2 * normal_force alpha0 h0 = fac delta 2 * (1 - cos alpha0) ->
  forall eta, 0 < eta <= 2 -> ~ arch_stands delta alpha eta mu.
Proof.
  intros Hd Ha0 Ha Hopen Hh0 Hmu Hs Hlimit eta He (h & p & Hall). assert (joint := beta_s_positive h0 Hh0).
  destruct (Hall (beta_s h0) ltac:(lra)) as [(HN & _) Hfriction]. destruct (Hall 0 ltac:(lra)) as [(HN0 & _) _].
  rewrite normal_force_at_crown in HN0. assert (h0 <= h) by (apply (thrust_at_least_h_is mu); try easy; lra).
  apply (wider_does_not_stand delta alpha0 alpha eta h0 h p); try easy; try lra. intros x Hx. now apply Hall.
Qed.

(** and no friction for none. *)
Theorem too_wide_without_limit (delta alpha0 alpha : R) : delta = 0 \/ delta = 1 -> 0 < alpha0 -> alpha0 < alpha ->
  alpha < PI -> 2 * normal_force alpha0 0 = fac delta 2 * (1 - cos alpha0) ->
  forall eta h p, 0 < eta <= 2 -> ~ thrust_inside delta alpha eta h p.
Proof.
  intros Hd Ha0 Ha Hopen Hlimit eta h p He Hall. destruct (Hall 0 ltac:(lra)) as (HN0 & _).
  rewrite normal_force_at_crown in HN0. now apply (wider_does_not_stand delta alpha0 alpha eta 0 h p); try lra.
Qed.
