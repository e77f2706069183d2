(** * The order of the modes on the map

    Two arches, each in an admissible state at a limit, of which the second has no more friction and no less thickness
    than the first. Where a joint slides inwards in the first, the crown does not turn in the second; where the shoulder
    slides in the first under a crown that turns, it does not turn in the second; where a joint slides inwards and the
    shoulder turns in both, the haunch of the second is no farther from the crown; at one friction, what slides alone
    does so with more thickness too. So at a given friction the modes follow each other as the thickness grows, and at a
    given half-angle as the friction does, and no arch need be compared with those between. *)

From Couplet Require Import Overturning Room Modes.

(** ** Haunches *)

(** Where the intrados is touched inside, (5) holds; at the crown the line of thrust goes away from it. *)
Lemma haunch_of_wide_arch (delta alpha eta h p beta : R) : 0 < alpha < PI -> 0 < eta <= 2 ->
  (forall x, 0 <= x <= alpha -> 0 <= haunch_gap delta x eta h p) -> haunch_gap delta beta eta h p = 0 ->
  0 < beta < alpha -> intrados eta * (h - 1 - beta * cot beta) + fac delta eta = 0.
Proof.
  intros Ha He Hall E Hb.
  set (D := (fac delta eta - intrados eta * (1 - h)) * sin beta - intrados eta * (beta * cos beta)).
  assert (0 < sin beta) by positive. assert (Hderive : derivable_pt_lim (fun x => haunch_gap delta x eta h p) beta D).
  { apply is_derive_Reals. unfold haunch_gap, normal_force. auto_derive; [easy|]. unfold D. ring. }
  assert (HD : D = 0).
  { assert (Hpr : derivable_pt (fun x => haunch_gap delta x eta h p) beta) by (now exists D).
    rewrite <- (derive_pt_eq_0 _ _ _ Hpr Hderive). apply (deriv_minimum _ 0 alpha beta Hpr); try easy; try lra.
    intros x Hx0 Hx1. cbv beta. rewrite E. apply Hall. lra. }
  apply (Rmult_eq_reg_r (sin beta)); [|lra]. unfold cot. unfold D in HD. rewrite Rmult_0_l, <- HD. field. lra.
Qed.

Lemma haunch_at_crown (delta alpha eta h p : R) : 0 < alpha < PI -> 0 < eta <= 2 ->
  (forall x, 0 <= x <= alpha -> 0 <= haunch_gap delta x eta h p) -> haunch_gap delta 0 eta h p = 0 ->
  0 <= intrados eta * (h - 2) + fac delta eta.
Proof.
  intros Ha He Hall E. apply Rnot_lt_le. intros Hneg. assert (Hp : p = intrados eta * h).
  { unfold haunch_gap, normal_force in E. rewrite cos_0, sin_0 in E. lra. }
  (* next to the crown the weight has no lever yet *)
  assert (Hexpand : forall x, haunch_gap delta x eta h p
            = (intrados eta * h + fac delta eta) * (1 - cos x) - intrados eta * (x * sin x)).
  { intros x. unfold haunch_gap, normal_force. rewrite Hp. ring. }
  set (slope := fun t => (intrados eta * (h - 1) + fac delta eta) * sin t - intrados eta * (t * cos t)).
  set (k := intrados eta * (h - 1) + fac delta eta) in *. assert (Hin : k < intrados eta) by (unfold k; lra).
  assert (Hpositive : 0 <= intrados eta) by (unfold intrados; lra).
  assert (Hc : continuity_pt (fun t => k - intrados eta * cos t) 0) by reg.
  destruct (Hc (intrados eta - k) ltac:(lra)) as (d & Hd & Hnear). set (x := Rmin (d / 2) (Rmin (alpha / 2) 1)).
  assert (Hx : 0 < x) by (unfold x; repeat apply Rmin_glb_lt; lra). assert (X1 : x <= d / 2) by apply Rmin_l.
  assert (X2 : x <= alpha / 2) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_l]).
  assert (X3 : x <= 1) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_r]). assert (HPI := PI2_3_2).
  destruct (MVT_cor2 (fun x => haunch_gap delta x eta h p) slope 0 x Hx) as (c & Hc' & Hin').
  { intros c Hc'. apply is_derive_Reals. unfold haunch_gap, normal_force. auto_derive; [easy|]. unfold slope, k. ring. }
  cbv beta in Hc'. rewrite E in Hc'. assert (HL := Hall x ltac:(lra)). assert (Hbelow : slope c < 0).
  { unfold slope. fold k. assert (HS : 0 < sin c) by positive.
    assert (Hsc : sin c < c) by (apply sin_lt_x; lra). assert (Hcos : 0 < cos c) by positive.
    assert (Hclose : k - intrados eta * cos c < 0).
    { assert (H := Hnear c). simpl in H. unfold R_dist in H. rewrite cos_0 in H.
      assert (Hball : Rabs (k - intrados eta * cos c - (k - intrados eta * 1)) < intrados eta - k).
      { apply H. split; [split; [exact I | lra]|]. rewrite Rminus_0_r, Rabs_pos_eq; lra. }
      apply Rabs_def2 in Hball. lra. }
    assert ((k - intrados eta * cos c) * sin c < 0) by nra.
    assert (0 <= intrados eta * cos c * (c - sin c)) by positive. lra. }
  assert (slope c * (x - 0) < 0) by nra. lra.
Qed.

Lemma A_above_times_cotangent (x : R) : 0 < x < PI -> x * cot x + 1 < A x.
Proof.
  intros Hx. assert (0 < sin x) by positive. assert (sin x < x) by (apply sin_lt_x; lra).
  assert (0 < 1 - cos x) by positive. unfold A, cot. apply Rminus_gt_0_lt.
  replace (x * sin x / (1 - cos x) - (x * (cos x / sin x) + 1)) with ((x - sin x) / sin x).
  - positive.
  - apply (Rmult_eq_reg_r (sin x * (1 - cos x))); [|positive].
    replace ((x - sin x) / sin x * (sin x * (1 - cos x))) with ((x - sin x) * (1 - cos x)) by (field; lra).
    replace ((x * sin x / (1 - cos x) - (x * (cos x / sin x) + 1)) * (sin x * (1 - cos x)))
      with (x * sin x ^ 2 - (x * cos x + sin x) * (1 - cos x)) by (field; lra).
    replace (sin x ^ 2) with (1 - cos x ^ 2) by (assert (Hcircle := circle x); lra). ring.
Qed.

(** ** Two arches *)

Section Two.

(** The state says of which arch it is. *)
Context {delta alpha1 eta1 mu1 h1 p1 alpha2 eta2 mu2 h2 p2 : R}.
Hypotheses (state1 : admissible_state delta alpha1 eta1 mu1 h1 p1)
  (state2 : admissible_state delta alpha2 eta2 mu2 h2 p2) (flag : 0 <= delta <= 1) (opening1 : 0 < alpha1 < PI)
  (thickness1 : 0 < eta1 <= 2) (rough1 : 0 < mu1) (opening2 : 0 < alpha2 < PI) (thickness2 : 0 < eta2 <= 2)
  (rough2 : 0 < mu2) (smoother : mu2 <= mu1) (thicker : eta1 <= eta2).

Let thrust1 : 0 < h1 := thrust_positive state1 opening1 rough1.
Let thrust2 : 0 < h2 := thrust_positive state2 opening2 rough2.
Let carries1 := compressed state1 flag opening1 thickness1 rough1.
Let carries2 := compressed state2 flag opening2 thickness2 rough2.
Let steepest1 := slides_at_steepest_joint state1 flag opening1 thickness1 rough1.
Let steepest2 := slides_at_steepest_joint state2 flag opening2 thickness2 rough2.

Definition shoulder_at_limit (alpha eta mu h p : R) : Prop :=
  shoulder_gap delta alpha eta h p = 0 \/ outward_gap alpha mu h = 0.

(** The friction that an inner joint asks for is no more than there is. *)
Lemma inner_friction_is_enough : shoulder_at_limit alpha2 eta2 mu2 h2 p2 -> h2 < 1 -> mu_is h2 <= mu2.
Proof.
  intros Hlimit H1. assert (Hh := thrust2).
  assert (Hb := steepest_joint_above state2 flag opening2 thickness2 rough2 H1 Hlimit).
  assert (Hb0 := beta_s_positive h2 ltac:(lra)). assert (HN := carries2 (beta_s h2) ltac:(lra)).
  destruct (margins_not_negative state2 (beta_s h2) ltac:(lra)) as (_ & _ & HI & _). unfold inward_gap in HI.
  rewrite mu_is_from_statics by lra. apply steepness_at_most; [easy | lra].
Qed.

(** Where a joint slides inwards the thrust is the least that the friction allows. *)
Lemma sliding_thrust_is_less (sigma : R) :
  0 < sigma <= alpha1 -> inward_gap sigma mu1 h1 = 0 -> shoulder_at_limit alpha1 eta1 mu1 h1 p1 ->
  shoulder_at_limit alpha2 eta2 mu2 h2 p2 -> h1 <= h2 /\ (h1 = h2 -> mu1 = mu2).
Proof.
  intros Hs EI Hlimit1 Hlimit2. assert (Hh1 := thrust1). assert (Hh2 := thrust2).
  destruct (steepest1 sigma Hs EI Hlimit1) as (H1 & _ & _ & Emu).
  destruct (Rle_lt_dec 1 h2) as [H2 | H2]; [lra|]. assert (Hfriction := inner_friction_is_enough Hlimit2 H2). split.
  - apply Rnot_lt_le. intros Hless. assert (mu_is h1 < mu_is h2) by (apply mu_is_strictly_decreasing; lra). lra.
  - intros E. rewrite E in Emu. lra.
Qed.

(** A crown that turns above a haunch. *)
Lemma crown_is_thin (beta : R) : 0 < beta < alpha2 ->
  crown_gap eta2 h2 p2 = 0 -> haunch_gap delta beta eta2 h2 p2 = 0 -> eta2 < 2.
Proof.
  intros Hb EC EL. assert (Hh := thrust2). destruct (Req_dec eta2 2) as [E | E]; [exfalso | lra].
  assert (Hfac := centroids_positive delta eta2 ltac:(lra)).
  assert (0 <= fac delta eta2 * (1 - cos beta)) by (apply Rmult_le_pos; destruct (COS_bound beta); lra).
  unfold crown_gap, haunch_gap, extrados, intrados in EC, EL. rewrite E in EC, EL, H. lra.
Qed.

(** *** Crowns that turn come first *)

Lemma crown_thrust_is_less (beta : R) : 0 < beta < alpha2 ->
  crown_gap eta2 h2 p2 = 0 -> haunch_gap delta beta eta2 h2 p2 = 0 ->
  shoulder_at_limit alpha1 eta1 mu1 h1 p1 -> h2 <= h1 /\ (h1 = h2 -> eta1 = eta2).
Proof.
  intros Hb EC EL Hlimit. assert (Hh1 := thrust1). assert (Hh2 := thrust2).
  assert (Hthin := crown_is_thin beta Hb EC EL). assert (Hfac2 := centroids_positive delta eta2 ltac:(lra)).
  destruct (Rle_lt_dec beta alpha1) as [Hin | Hout].
  - (* the haunch is a joint of the first arch *)
    destruct (margins_not_negative state1 0 ltac:(lra)) as (C1 & _).
    destruct (margins_not_negative state1 beta ltac:(lra)) as (_ & L1 & _). assert (HN := carries2 beta ltac:(lra)).
    assert (cos beta < 1) by (rewrite <- cos_0; apply cos_decreasing_1; lra).
    set (room := fun eta h => extrados eta * h + fac delta eta * (1 - cos beta) - intrados eta * normal_force beta h).
    assert (0 <= room eta1 h1).
    { unfold room. unfold shoulder_gap, haunch_gap in C1, L1. unfold normal_force at 1 in C1.
      rewrite cos_0, sin_0 in C1. lra. }
    assert (R2 : room eta2 h2 = 0) by (unfold room, crown_gap, haunch_gap in *; lra).
    assert (Hgrows : room eta2 h2 - room eta1 h2 = (eta2 - eta1) *
      ((h2 + normal_force beta h2) / 2 + delta * (eta1 + eta2) / 12 * (1 - cos beta)))
      by (unfold room, extrados, intrados, fac; field).
    assert (0 < (h2 + normal_force beta h2) / 2 + delta * (eta1 + eta2) / 12 * (1 - cos beta)).
    { assert (0 <= delta * (eta1 + eta2) / 12 * (1 - cos beta)) by positive. lra. }
    assert (Hlinear : room eta1 h1 - room eta1 h2 = (h1 - h2) * (extrados eta1 - intrados eta1 * cos beta))
      by (unfold room, normal_force; ring). assert (0 < extrados eta1 - intrados eta1 * cos beta).
    { unfold extrados, intrados. destruct (COS_bound beta). nra. }
    assert (0 <= (eta2 - eta1) * ((h2 + normal_force beta h2) / 2 + delta * (eta1 + eta2) / 12 *
      (1 - cos beta))) by positive. split.
    + apply Rnot_lt_le. intros Hless. assert ((h1 - h2) * (extrados eta1 - intrados eta1 * cos beta) < 0) by nra. lra.
    + intros E. assert (Hsame : room eta1 h1 = room eta1 h2) by (now rewrite E). apply Rle_antisym; [easy|].
      apply Rnot_lt_le. intros Hless.
      assert (0 < (eta2 - eta1) * ((h2 + normal_force beta h2) / 2 + delta * (eta1 + eta2) / 12 * (1 - cos beta)))
        by positive. lra.
  - (* it is beyond *)
    assert (Htouch := haunch_of_wide_arch delta alpha2 eta2 h2 p2 beta opening2 thickness2
                        (haunch_not_negative state2) EL Hb). assert (h2 < beta * cot beta).
    { unfold intrados in Htouch. assert (0 < 1 - eta2 / 2 < 1) by lra. apply Rnot_le_lt. intros Hle.
      assert (0 <= (1 - eta2 / 2) * (h2 - beta * cot beta)) by positive. lra. }
    assert (beta * cot beta < alpha1 * cot alpha1) by (apply times_cotangent_falls; lra). enough (h2 < h1) by lra.
    destruct Hlimit as [EU | EO].
    + assert (HA := thrust_of_extrados state1 flag opening1 thickness1 EU).
      assert (Hcot := A_above_times_cotangent alpha1 opening1). lra.
    + assert (HN := carries1 alpha1 ltac:(lra)). assert (0 < sin alpha1) by positive.
      assert (0 < mu1 * normal_force alpha1 h1) by positive. enough (alpha1 * cot alpha1 < h1) by lra.
      apply (Rmult_lt_reg_r (sin alpha1)); [easy|]. unfold cot.
      replace (alpha1 * (cos alpha1 / sin alpha1) * sin alpha1) with (alpha1 * cos alpha1) by (field; lra).
      unfold outward_gap, shear_force in EO. lra.
Qed.

(** Where a joint slides in the first arch the crown does not turn in the second, unless both are one
    point of the map. *)
Theorem crown_turns_first (sigma beta : R) : 0 < sigma <= alpha1 -> inward_gap sigma mu1 h1 = 0 ->
  shoulder_at_limit alpha1 eta1 mu1 h1 p1 -> 0 < beta < alpha2 -> crown_gap eta2 h2 p2 = 0 ->
  haunch_gap delta beta eta2 h2 p2 = 0 -> shoulder_at_limit alpha2 eta2 mu2 h2 p2 ->
  eta1 = eta2 /\ mu1 = mu2 /\ h1 = h2.
Proof.
  intros Hs EI Hlimit1 Hb EC EL Hlimit2. destruct (sliding_thrust_is_less sigma Hs EI Hlimit1 Hlimit2) as [Hle Hmu].
  destruct (crown_thrust_is_less beta Hb EC EL Hlimit1) as [Hge Heta]. assert (E : h1 = h2) by lra. auto.
Qed.

(** *** Haunches fall *)

Theorem haunch_falls (sigma1 beta1 sigma2 beta2 : R) : 0 < sigma1 <= alpha1 -> inward_gap sigma1 mu1 h1 = 0 ->
  shoulder_at_limit alpha1 eta1 mu1 h1 p1 -> 0 < sigma2 <= alpha2 -> inward_gap sigma2 mu2 h2 = 0 ->
  shoulder_at_limit alpha2 eta2 mu2 h2 p2 -> 0 <= beta1 < alpha1 -> haunch_gap delta beta1 eta1 h1 p1 = 0 ->
  0 <= beta2 < alpha2 -> haunch_gap delta beta2 eta2 h2 p2 = 0 -> beta2 <= beta1 /\
  (eta1 < eta2 \/ mu2 < mu1 -> beta2 = 0 \/ beta2 < beta1) /\ (h2 <= 1 / 2 \/ mu1 = mu2 -> sigma1 <= sigma2).
Proof.
  intros Hs1 EI1 Hlimit1 Hs2 EI2 Hlimit2 Hb1 EL1 Hb2 EL2. assert (Hh1 := thrust1). assert (Hh2 := thrust2).
  destruct (sliding_thrust_is_less sigma1 Hs1 EI1 Hlimit1 Hlimit2) as [Hle Hsame].
  destruct (steepest1 sigma1 Hs1 EI1 Hlimit1) as (H1 & Es1 & _ & M1).
  destruct (steepest2 sigma2 Hs2 EI2 Hlimit2) as (H2 & Es2 & _ & M2). assert (HL1 := haunch_not_negative state1).
  assert (HL2 := haunch_not_negative state2).
  assert (Hfalls : 0 < beta2 -> beta2 <= beta1 /\ (eta1 < eta2 \/ mu2 < mu1 -> beta2 < beta1)).
  { intros Hpos.
    assert (T2 := haunch_of_wide_arch delta alpha2 eta2 h2 p2 beta2 opening2 thickness2 HL2 EL2 ltac:(lra)).
    assert (Hfac1 := centroids_positive delta eta1 ltac:(lra)). assert (Hfac : fac delta eta1 <= fac delta eta2).
    { unfold fac. assert (delta * eta1 ^ 2 <= delta * eta2 ^ 2) by (apply Rmult_le_compat_l; nra). lra. }
    assert (Hthin : eta2 < 2).
    { destruct (Req_dec eta2 2) as [E | E]; [exfalso | lra]. unfold intrados in T2. rewrite E in T2, Hfac. lra. }
    assert (Hin : 0 < intrados eta2 <= intrados eta1) by (unfold intrados; lra).
    set (k := h2 - 1 - beta2 * cot beta2) in *. assert (Hk : k < 0).
    { apply Rnot_le_lt. intros Hk. assert (0 <= intrados eta2 * k) by positive. lra. }
    (* the same sum at the first arch is not positive, and negative if that is thinner *)
    assert (Hfirst : intrados eta1 * k + fac delta eta1 <= 0).
    { assert (0 <= (intrados eta1 - intrados eta2) * - k) by positive. lra. }
    assert (Hthinner : eta1 < eta2 -> intrados eta1 * k + fac delta eta1 < 0).
    { intros Heta. assert (0 < (intrados eta1 - intrados eta2) * - k) by positive. lra. }
    assert (Hrougher : mu2 < mu1 -> h1 < h2).
    { intros Hmu. destruct (Req_dec h1 h2) as [E | E]; [rewrite (Hsame E) in Hmu; lra | lra]. }
    destruct (Req_dec beta1 0) as [E | E].
    - exfalso. rewrite E in EL1. assert (T1 := haunch_at_crown delta alpha1 eta1 h1 p1 opening1 thickness1 HL1 EL1).
      assert (Hcot := times_cotangent_below_one beta2 ltac:(lra)).
      assert (0 < intrados eta1 * (k - (h1 - 2))) by (apply Rmult_lt_0_compat; unfold k; lra). lra.
    - assert (T1 := haunch_of_wide_arch delta alpha1 eta1 h1 p1 beta1 opening1 thickness1 HL1 EL1 ltac:(lra)).
      set (k1 := h1 - 1 - beta1 * cot beta1) in *. assert (Hk1 : k <= k1).
      { apply Rnot_lt_le. intros H. assert (0 < intrados eta1 * (k - k1)) by positive. lra. }
      split.
      + apply Rnot_lt_le. intros Hless.
        assert (Hcot : beta2 * cot beta2 < beta1 * cot beta1) by (apply times_cotangent_falls; lra).
        unfold k, k1 in Hk1. lra.
      + intros Hstrict. destruct (Rtotal_order beta2 beta1) as [H | [H | H]]; [easy | exfalso | exfalso].
        * unfold k, k1 in *. rewrite H in *. destruct Hstrict as [Heta | Hmu]; [|specialize (Hrougher Hmu); lra].
          specialize (Hthinner Heta).
          assert (0 <= intrados eta1 * (h2 - 1 - beta1 * cot beta1 - (h1 - 1 - beta1 * cot beta1))) by positive. lra.
        * assert (Hcot : beta2 * cot beta2 < beta1 * cot beta1) by (apply times_cotangent_falls; lra).
          unfold k, k1 in Hk1. lra. }
  split; [|split].
  - destruct (Req_dec beta2 0) as [E | E]; [lra | apply Hfalls; lra].
  - intros Hstrict. destruct (Req_dec beta2 0) as [E | E]; [now left | right]. apply Hfalls; [lra | easy].
  - intros [Hhalf | Emu]; rewrite Es1, Es2; [unfold beta_s; apply sqrt_le_1; nra
      | rewrite (mu_is_injective h1 h2); lra].
Qed.

(** *** What slides alone comes last *)

Theorem sliding_comes_last (sigma1 sigma2 beta2 : R) : mu1 = mu2 -> eta1 < eta2 -> 0 < sigma1 <= alpha1 ->
  inward_gap sigma1 mu1 h1 = 0 -> outward_gap alpha1 mu1 h1 = 0 -> 0 < sigma2 <= alpha2 ->
  inward_gap sigma2 mu2 h2 = 0 -> 0 <= beta2 < alpha2 -> haunch_gap delta beta2 eta2 h2 p2 = 0 ->
  shoulder_gap delta alpha2 eta2 h2 p2 <> 0.
Proof.
  intros Emu Hthick Hs1 EI1 EO1 Hs2 EI2 Hb2 EL2 EU2. assert (Hh1 := thrust1). assert (Hh2 := thrust2).
  destruct (steepest1 sigma1 Hs1 EI1 (or_intror EO1)) as (H1 & _ & _ & M1).
  destruct (steepest2 sigma2 Hs2 EI2 (or_introl EU2)) as (H2 & _ & _ & M2).
  assert (E : h1 = h2) by (apply mu_is_injective; lra). assert (Hwithin : alpha2 <= alpha1).
  { apply Rnot_lt_le. intros Hwide. destruct (margins_not_negative state2 alpha2 ltac:(lra)) as (_ & _ & _ & HO).
    assert (H : 0 < outward_gap alpha1 mu2 h2) by (apply (no_outward_limit_within alpha1 alpha2); lra).
    rewrite <- E, <- Emu in H. lra. }
  destruct (thicker_arch_has_room delta alpha2 beta2 eta1 eta2 h1 p1) as (p & _ & HL & HU); try easy; try lra.
  { intros x Hx. now destruct (state1 x ltac:(lra)). }
  rewrite E in HL, HU. unfold haunch_gap, shoulder_gap in *. lra.
Qed.

(** *** Shoulders that turn come first *)

(** A crown that turns is that of a rotational state, no narrower than the arch; if the shoulder slides
    it asks there for at least the friction there is, and an inner joint for no more. *)
Theorem rotational_state_of_crown (beta : R) : 0 < beta < alpha2 -> crown_gap eta2 h2 p2 = 0 ->
  haunch_gap delta beta eta2 h2 p2 = 0 -> exists alpha0, alpha2 <= alpha0 < PI /\
  rotational_state delta alpha0 beta eta2 /\ h2 = h_lower delta beta eta2 /\ h2 < 1 /\
  (shoulder_gap delta alpha2 eta2 h2 p2 = 0 -> alpha0 = alpha2) /\
  (outward_gap alpha2 mu2 h2 = 0 -> mu_is h2 <= mu2 <= mu_ss alpha0 h2).
Proof.
  intros Hb EC EL. assert (Hh := thrust2). assert (HPI := PI2_3_2). assert (Hthin := crown_is_thin beta Hb EC EL).
  assert (Hfac := centroids_positive delta eta2 ltac:(lra)).
  assert (Htouch := haunch_of_wide_arch delta alpha2 eta2 h2 p2 beta opening2 thickness2
                      (haunch_not_negative state2) EL Hb). assert (HSb : 0 < sin beta) by positive.
  assert (Hlever := lever_of_lower_thrust_positive beta eta2 ltac:(lra)). assert (E2 : h2 = h_lower delta beta eta2).
  { apply lower_thrust_cleared; [lra|]. unfold crown_gap, haunch_gap, extrados, intrados, normal_force in EC, EL.
    lra. }
  assert (E5 : h2 = h_tangency delta beta eta2).
  { apply tangency_cleared; [lra | lra|]. unfold intrados, cot in Htouch.
    assert (Hscaled : sin beta * ((1 - eta2 / 2) * (h2 - 1 - beta * (cos beta / sin beta)) + fac delta eta2) = 0)
      by (rewrite Htouch; ring).
    replace (sin beta * ((1 - eta2 / 2) * (h2 - 1 - beta * (cos beta / sin beta)) + fac delta eta2))
      with ((1 - eta2 / 2) * ((h2 - 1) * sin beta - beta * cos beta) + fac delta eta2 * sin beta)
      in Hscaled by (field; lra). lra. }
  assert (H1 : h2 < 1).
  { assert (Hcot := times_cotangent_below_one beta ltac:(lra)). unfold intrados in Htouch. apply Rnot_le_lt. intros H.
    assert (0 < (1 - eta2 / 2) * (h2 - beta * cot beta)) by positive. lra. }
  (* the extrados is reached at some joint beyond *)
  set (level := fun x => (extrados eta2 * h2 + fac delta eta2) * (1 - cos x) - extrados eta2 * (x * sin x)).
  assert (Hlevel : forall x, level x = - shoulder_gap delta x eta2 h2 p2).
  { intros x. unfold level, shoulder_gap, crown_gap, normal_force in *. replace p2 with (extrados eta2 * h2) by lra.
    ring. }
  assert (Hcontinuous : continuity level) by (unfold level; reg).
  destruct (margins_not_negative state2 alpha2 ltac:(lra)) as (HU & _). assert (Hpi : 0 < level PI).
  { unfold level. rewrite cos_PI, sin_PI. assert (0 < extrados eta2 * h2) by positive. lra. }
  assert (Halpha0 : exists alpha0, alpha2 <= alpha0 < PI /\ level alpha0 = 0).
  { destruct (Req_dec (shoulder_gap delta alpha2 eta2 h2 p2) 0) as [Z | Z].
    - exists alpha2. split; [lra|]. rewrite Hlevel, Z. ring.
    - destruct (IVT level alpha2 PI Hcontinuous ltac:(lra) ltac:(rewrite Hlevel; lra) Hpi) as (a & Ha & Ea). exists a.
      split; [|easy]. destruct (Req_dec a PI) as [-> | Hne]; lra. }
  destruct Halpha0 as (alpha0 & Ha0 & E0). assert (Hv : 0 < 1 - cos alpha0) by positive.
  assert (E4 : h2 = h_whole delta alpha0 eta2).
  { apply whole_thrust_cleared; [lra | lra|]. unfold level, extrados in E0. lra. }
  assert (Hstate : rotational_state delta alpha0 beta eta2) by (split; congruence). exists alpha0. split; [easy|].
  split; [easy|]. split; [easy|]. split; [easy|]. split.
  - intros EU. destruct (Req_dec alpha0 alpha2) as [E | E]; [easy | exfalso].
    assert (H : 0 < shoulder_gap delta alpha2 eta2 h2 p2); [|lra].
    apply (extrados_clear_within delta alpha2 alpha0); try lra. assert (H := Hlevel alpha0). lra.
  - intros EO. split; [apply inner_friction_is_enough; [now right | easy]|].
    assert (Hstands := rotational_state_stands delta alpha0 beta eta2 ltac:(lra) ltac:(lra) ltac:(lra)
                         ltac:(lra) Hstate alpha0 ltac:(lra)). cbv zeta in Hstands. rewrite <- E2 in Hstands.
    destruct Hstands as [HN0 _]. assert (HN := carries2 alpha2 ltac:(lra)).
    assert (Hsteep := proj2 (steepness_at_limit alpha2 mu2 h2 HN) EO). rewrite shoulder_friction_from_statics.
    assert (Hb2 := steepest_joint_above state2 flag opening2 thickness2 rough2 H1 (or_intror EO)).
    destruct (Req_dec alpha0 alpha2) as [E | E]; [rewrite E; lra|].
    assert (steepness alpha0 h2 < steepness alpha2 h2) by (apply (steepness_falls_after_beta_s h2 alpha0); lra). lra.
Qed.

End Two.

Arguments shoulder_at_limit : clear implicits.

(** Where the friction of the shoulder grows along the rotational states, one that slides in the first
    arch does not turn in the second. *)
Theorem shoulder_turns_first (delta alpha1 eta1 mu1 h1 p1 alpha2 eta2 mu2 h2 p2 beta1 beta2 : R) : 0 <= delta <= 1 ->
  0 < alpha1 < PI -> 0 < eta1 <= 2 -> 0 < mu1 -> admissible_state delta alpha1 eta1 mu1 h1 p1 -> 0 < alpha2 < PI ->
  0 < eta2 <= 2 -> 0 < mu2 -> admissible_state delta alpha2 eta2 mu2 h2 p2 -> mu2 <= mu1 -> eta1 < eta2 ->
  (forall alpha beta eta alpha' beta' eta', 0 < eta < eta' -> eta' < 2 -> 0 < beta < alpha -> alpha < PI ->
    0 < beta' < alpha' -> alpha' < PI -> rotational_state delta alpha beta eta ->
    rotational_state delta alpha' beta' eta' ->
    mu_ss alpha (h_lower delta beta eta) < mu_ss alpha' (h_lower delta beta' eta')) -> 0 < beta1 < alpha1 ->
  crown_gap eta1 h1 p1 = 0 -> haunch_gap delta beta1 eta1 h1 p1 = 0 -> outward_gap alpha1 mu1 h1 = 0 ->
  0 < beta2 < alpha2 -> crown_gap eta2 h2 p2 = 0 -> haunch_gap delta beta2 eta2 h2 p2 = 0 ->
  shoulder_gap delta alpha2 eta2 h2 p2 <> 0.
Proof.
  intros Hd Ha1 He1 Hm1 S1 Ha2 He2 Hm2 S2 Hmu Heta Hgrows Hb1 EC1 EL1 EO1 Hb2 EC2 EL2 EU2.
  destruct (rotational_state_of_crown S1 Hd Ha1 He1 Hm1 beta1 Hb1 EC1 EL1) as (a1 & Ha1' & R1 & E1 & _ & _ & F1).
  destruct (F1 EO1) as [_ M1].
  destruct (rotational_state_of_crown S2 Hd Ha2 He2 Hm2 beta2 Hb2 EC2 EL2) as (a2 & Ha2' & R2 & E2 & _ & F2 & _).
  rewrite (F2 EU2) in R2, Ha2'. clear F1 F2. assert (Hthin := crown_is_thin S2 Hd Ha2 He2 Hm2 beta2 Hb2 EC2 EL2).
  assert (H := Hgrows a1 beta1 eta1 alpha2 beta2 eta2 ltac:(lra) Hthin ltac:(lra) ltac:(lra) Hb2 ltac:(lra) R1 R2).
  rewrite <- E1, <- E2 in H. assert (HN := compressed S2 Hd Ha2 He2 Hm2 alpha2 ltac:(lra)).
  destruct (margins_not_negative S2 alpha2 ltac:(lra)) as (_ & _ & _ & HO). assert (mu_ss alpha2 h2 <= mu2); [|lra].
  rewrite shoulder_friction_from_statics. apply steepness_at_most; [easy|]. unfold outward_gap in HO. lra.
Qed.
