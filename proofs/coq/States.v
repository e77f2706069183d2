(** * The state of an arch from a handful of signs

    For each mode with a thickness: where its printed equations hold and a few numbers are positive, the state is
    **admissible at every joint** of the half arch, and the arch stands **exactly** from its thickness on, up to the
    physical limit. Purely sliding states bound the friction. The verified checker adds the numbers.

    Where modes meet, some of these numbers are zero: friction at the shoulder or inside, the room at the extrados,
    that of the intrados next to the crown, or what the limit leaves. Of those it is asked that they are not negative,
    so that each theorem holds for the landmarks too. *)

From Couplet Require Import Moments Cubics Overturning Sliding Joining.
From Couplet Require Export Arch DoubleThickness Contact FrictionModes.

(** ** What is claimed *)

(** The line of thrust is inside at every joint of the half arch, *)
Definition thrust_inside (delta alpha eta h p : R) : Prop :=
  forall x, 0 <= x <= alpha -> joint_stands delta x eta h p.

(** and friction holds there. *)
Definition admissible (delta alpha eta mu h p : R) : Prop :=
  forall x, 0 <= x <= alpha -> joint_stands delta x eta h p /\ friction_holds x mu h.

(** Up to the physical limit the arch stands exactly from a thickness on, *)
Definition stands_from (delta alpha mu eta : R) : Prop :=
  forall eta', 0 < eta' <= 2 -> (arch_stands delta alpha eta' mu <-> eta <= eta').

(** and the same if friction has no limit. *)
Definition stands_without_limit_from (delta alpha eta : R) : Prop :=
  forall eta', 0 < eta' <= 2 -> ((exists h p, thrust_inside delta alpha eta' h p) <-> eta <= eta').

(** Without enough friction it stands at no thickness, whatever the self-weight. *)
Definition stands_at_no_thickness (alpha mu : R) : Prop := forall delta eta, ~ arch_stands delta alpha eta mu.

(** The moments [p] of the crown's thrust that put it on the extrados at crown and shoulder. *)
Definition at_crown (eta h : R) : R := extrados eta * h.
Definition at_shoulder (delta alpha eta h : R) : R :=
  extrados eta * normal_force alpha h - fac delta eta * (1 - cos alpha).

(** ** The line of thrust *)

(** With a hinge at the haunch. *)
Theorem inside_with_haunch (delta alpha beta eta h p : R) : 0 < beta < alpha -> alpha < PI -> 0 < eta < 2 -> 0 < h ->
  0 < normal_force alpha h -> p <= at_crown eta h -> p <= at_shoulder delta alpha eta h ->
  intrados eta * normal_force beta h <= p + fac delta eta * (1 - cos beta) -> h = h_tangency delta beta eta ->
  thrust_inside delta alpha eta h p.
Proof.
  unfold at_crown, at_shoulder. split; [|split].
  - apply Rlt_le, (normal_force_positive alpha); lra.
  - apply (intrados_safe delta beta); try easy; lra.
  - apply (extrados_safe delta alpha); try lra. unfold extrados; lra.
Qed.

(** With the crown's intrados as hinge, from which the line of thrust goes away. *)
Theorem inside_from_crown (delta alpha eta h p : R) : 0 < alpha < PI -> 0 < eta <= 2 -> 0 <= h ->
  (forall x, 0 <= x <= alpha -> 0 <= normal_force x h) -> p = intrados eta * h -> p = at_shoulder delta alpha eta h ->
  intrados eta * (2 - h) <= fac delta eta -> thrust_inside delta alpha eta h p.
Proof.
  unfold at_shoulder. intros Ha He Hh HN Hcrown Hshoulder Haway x Hx.
  assert (0 <= intrados eta) by (unfold intrados; lra). split; [now apply HN|split].
  - enough (margin (intrados eta) (fac delta eta) h x <= margin (intrados eta) (fac delta eta) h 0)
      by (unfold margin, normal_force in *; rewrite cos_0, sin_0 in *; lra). apply margin_falls_from_crown; lra.
  - apply (extrados_safe delta alpha); try easy; try lra; [unfold extrados; lra
      | unfold extrados, intrados in *; nra].
Qed.

(** ** Friction *)

Lemma mu_is_positive (h : R) : 0 < h < 1 -> 0 < mu_is h.
Proof.
  intros Hh. rewrite mu_is_from_statics by easy. assert (Hs := beta_s_positive h Hh).
  replace 0 with (steepness 0 h) by (unfold steepness, shear_force; rewrite sin_0, !Rmult_0_l, Rmult_0_r; lra).
  apply steepness_grows_before_beta_s; lra.
Qed.

(** Friction holds everywhere if it does at the steepest joint and at the shoulder. *)
Lemma admissible_by_two_joints (delta alpha eta mu h p : R) : thrust_inside delta alpha eta h p -> 0 < h < 1 ->
  0 < alpha < PI -> 0 < normal_force alpha h -> beta_s h <= alpha -> mu_is h <= mu -> mu_ss alpha h <= mu ->
  admissible delta alpha eta mu h p.
Proof.
  intros Hin Hh Ha HN Hs His Hss x Hx. split; [now apply Hin|]. assert (Hmu := mu_is_positive h Hh).
  now apply (friction_by_two_joints h alpha mu); try lra.
Qed.

(** ** From the state's thickness on *)

Lemma thicker_stands (delta alpha eta eta' h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= eta' ->
  eta' <= 2 -> 0 <= h -> thrust_inside delta alpha eta h p -> thrust_inside delta alpha eta' h p.
Proof.
  intros Hd Ha He He' Hh Hall x Hx. apply (joint_stands_if_thicker delta x eta); try easy; [| now apply Hall].
  destruct (Hall 0 ltac:(lra)) as (_ & Hin & _). rewrite normal_force_at_crown, cos_0 in Hin.
  assert (0 <= intrados eta * h) by positive. lra.
Qed.

Lemma stands_from_there (delta alpha eta mu h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 -> 0 <= h ->
  admissible delta alpha eta mu h p -> (forall eta', 0 < eta' < eta -> ~ arch_stands delta alpha eta' mu) ->
  stands_from delta alpha mu eta.
Proof.
  intros Hd Ha He Hh Hstands Hnone eta' He'. split.
  - intros H. apply Rnot_lt_le. intros Hthin. apply (Hnone eta'); [lra | exact H].
  - exists h, p. intros x Hx. split; [| now apply Hstands]. apply (thicker_stands delta alpha eta); try lra.
    intros y Hy. now apply Hstands.
Qed.

Lemma stands_without_limit_from_there (delta alpha eta h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 ->
  0 <= h -> thrust_inside delta alpha eta h p -> (forall eta', 0 < eta' < eta ->
    ~ exists h p, thrust_inside delta alpha eta' h p) -> stands_without_limit_from delta alpha eta.
Proof.
  intros Hd Ha He Hh Hstands Hnone eta' He'. split.
  - intros H. apply Rnot_lt_le. intros Hthin. apply (Hnone eta'); [lra | exact H].
  - exists h, p. now apply (thicker_stands delta alpha eta).
Qed.

(** ** The modes *)

Section Modes.

Variables (delta alpha mu : R).
Hypotheses (weight : 0 <= delta <= 1) (opening : 0 < alpha < PI).

(** The haunch is on the intrados by (2) if the crown is on the extrados, *)
Lemma haunch_from_crown (beta eta h : R) : 0 < eta <= 2 -> h = h_lower delta beta eta ->
  intrados eta * normal_force beta h = at_crown eta h + fac delta eta * (1 - cos beta).
Proof.
  intros He H2. apply lower_thrust_cleared in H2; [|apply Rgt_not_eq, lever_of_lower_thrust_positive; lra].
  unfold at_crown, extrados, intrados, normal_force. lra.
Qed.

(** by (3) if the shoulder is, *)
Lemma haunch_from_shoulder (beta eta h : R) : 0 < (2 - eta) * cos beta - (2 + eta) * cos alpha ->
  h = h_upper delta alpha beta eta ->
  intrados eta * normal_force beta h = at_shoulder delta alpha eta h + fac delta eta * (1 - cos beta).
Proof.
  intros Hlever H3. apply upper_thrust_cleared in H3; [|lra]. unfold at_shoulder, extrados, intrados, normal_force.
  lra.
Qed.

(** and by (4) both are. *)
Lemma shoulder_from_crown (eta h : R) : 0 < eta <= 2 -> h = h_whole delta alpha eta ->
  at_crown eta h = at_shoulder delta alpha eta h.
Proof.
  intros He H4. assert (Hv : 0 < 1 - cos alpha) by positive.
  apply whole_thrust_cleared in H4; [|lra|lra]. unfold at_crown, at_shoulder, extrados, normal_force. lra.
Qed.

(** *** What is zero where modes meet *)

(** The room next to the crown, where the rotational joint reaches it, *)
Theorem no_room_next_to_crown (eta h : R) : eta < 2 -> h = end_of_rotation delta eta ->
  intrados eta * (2 - h) = fac delta eta.
Proof. intros He ->. unfold end_of_rotation, intrados, fac. field. lra. Qed.

(** and what the limit leaves, at the limit: where an inner joint slides, *)
Theorem nothing_left_at_border (h : R) : 0 < (2 - 2) * cos 0 - (2 + 2) * cos alpha -> h = h_upper delta alpha 0 2 ->
  fac delta 2 * (1 - cos alpha) = 2 * normal_force alpha h.
Proof.
  intros Hlever H3. apply haunch_from_shoulder in H3; [|easy]. unfold at_shoulder, extrados, intrados in H3.
  rewrite cos_0 in H3. lra.
Qed.

(** and without thrust. *)
Theorem nothing_left_at_end_of_overturning : 0 = h_whole delta alpha 2 ->
  fac delta 2 * (1 - cos alpha) = 2 * normal_force alpha 0.
Proof. intros H4. apply shoulder_from_crown in H4; [|lra]. unfold at_crown, at_shoulder, extrados in H4. lra. Qed.

(** *** [[r,r,r]] *)

Theorem rotational_inside (beta eta h : R) : h = h_lower delta beta eta /\ h = h_whole delta alpha eta /\
  h = h_tangency delta beta eta -> 0 < eta -> eta < 2 -> 0 < h -> 0 < beta -> beta < alpha ->
  0 < normal_force alpha h -> thrust_inside delta alpha eta h (at_crown eta h).
Proof.
  intros (H2 & H4 & H5) **. assert (Hs := shoulder_from_crown eta h ltac:(lra) H4).
  assert (Hh := haunch_from_crown beta eta h ltac:(lra) H2).
  apply (inside_with_haunch delta alpha beta); try easy; lra.
Qed.

Lemma none_thinner_than_rotational (beta eta h : R) : h = h_lower delta beta eta /\ h = h_whole delta alpha eta /\
  h = h_tangency delta beta eta -> 0 < eta < 2 -> 0 < beta < alpha -> forall eta', 0 < eta' < eta ->
  ~ exists h p, thrust_inside delta alpha eta' h p.
Proof.
  intros (H2 & H4 & H5) He Hb eta' He' (h' & p & Hall).
  apply (rotational_thickness_is_least delta alpha beta eta) with (eta' := eta') in weight; try lra;
    [assert (eta <= eta') by (apply weight; now exists h', p); lra | split; congruence].
Qed.

Theorem rotational (beta eta h : R) : h = h_lower delta beta eta /\ h = h_whole delta alpha eta /\
  h = h_tangency delta beta eta -> 0 < eta -> eta < 2 -> 0 < h -> h < 1 -> 0 < beta -> beta < alpha ->
  0 < normal_force alpha h -> beta_s h <= alpha -> mu_ss alpha h <= mu -> mu_is h <= mu ->
  admissible delta alpha eta mu h (at_crown eta h) /\ stands_from delta alpha mu eta.
Proof.
  intros E **.
  assert (A : admissible delta alpha eta mu h (at_crown eta h))
    by (apply admissible_by_two_joints; try lra; now apply (rotational_inside beta)).
  split; [exact A|]. apply (stands_from_there _ _ _ _ h (at_crown eta h)); try easy; try lra.
  intros eta' He' (h' & p & Hall). apply (none_thinner_than_rotational beta eta h E ltac:(lra) ltac:(lra) eta' He').
  exists h', p. intros x Hx. now apply Hall.
Qed.

Theorem rotational_without_limit (beta eta h : R) :
  h = h_lower delta beta eta /\ h = h_whole delta alpha eta /\ h = h_tangency delta beta eta ->
  0 < eta -> eta < 2 -> 0 < h -> 0 < beta -> beta < alpha -> 0 < normal_force alpha h ->
  thrust_inside delta alpha eta h (at_crown eta h) /\ stands_without_limit_from delta alpha eta.
Proof.
  intros E **. assert (A := rotational_inside beta eta h E ltac:(easy)).
  specialize (A ltac:(easy) ltac:(easy) ltac:(easy) ltac:(easy) ltac:(easy)). split; [exact A|].
  apply (stands_without_limit_from_there _ _ _ h (at_crown eta h)); try easy; try lra.
  apply (none_thinner_than_rotational beta eta h E); lra.
Qed.

(** *** [[s,r,r]] *)

Theorem sliding_rotational (beta eta h : R) :
  h = h_lower delta beta eta /\ h = h_tangency delta beta eta /\ mu = mu_ss alpha h -> 0 < eta -> eta < 2 -> 0 < h ->
  h < 1 -> 0 < beta -> beta < alpha -> 0 < normal_force alpha h -> at_crown eta h <= at_shoulder delta alpha eta h ->
  beta_s h <= alpha -> mu_is h <= mu -> 0 < sin alpha - mu * cos alpha ->
  admissible delta alpha eta mu h (at_crown eta h) /\ stands_from delta alpha mu eta.
Proof.
  intros (H2 & H5 & H17) **. assert (Hh := haunch_from_crown beta eta h ltac:(lra) H2).
  assert (A : admissible delta alpha eta mu h (at_crown eta h)).
  { apply admissible_by_two_joints; try lra. apply (inside_with_haunch delta alpha beta); try easy; lra. }
  split; [exact A|]. apply (stands_from_there _ _ _ _ h (at_crown eta h)); try easy; try lra. intros eta' He'.
  apply (no_thinner_arch_with_sliding_shoulder delta alpha beta eta eta' mu); try easy; try lra. rewrite <- H2.
  apply shoulder_thrust_from_statics; try easy; lra.
Qed.

(** *** [[r,r,s]], [[r,s,r]] *)

Theorem rotational_sliding (beta eta h joint : R) : h = h_upper delta alpha beta eta /\
  h = h_tangency delta beta eta /\ mu = mu_is h /\ joint = beta_s h -> 0 < eta -> eta < 2 -> 0 < h -> h < 1 ->
  0 < beta -> beta < alpha -> 0 < normal_force alpha h -> at_shoulder delta alpha eta h <= at_crown eta h ->
  joint <= alpha -> mu_ss alpha h <= mu -> 0 < (2 - eta) * cos beta - (2 + eta) * cos alpha ->
  admissible delta alpha eta mu h (at_shoulder delta alpha eta h) /\ stands_from delta alpha mu eta.
Proof.
  intros (H3 & H5 & H18 & ->) **. assert (Hh := haunch_from_shoulder beta eta h ltac:(lra) H3).
  assert (A : admissible delta alpha eta mu h (at_shoulder delta alpha eta h)).
  { apply admissible_by_two_joints; try lra. apply (inside_with_haunch delta alpha beta); try easy; lra. }
  split; [exact A|]. apply (stands_from_there _ _ _ _ h (at_shoulder delta alpha eta h)); try easy; try lra.
  intros eta' He'. apply (no_thinner_arch_with_sliding_joint delta alpha beta eta eta' mu h); try easy; lra.
Qed.

(** *** [[r,s]] *)

Theorem overturning_sliding (eta h joint : R) : h = h_upper delta alpha 0 eta /\ mu = mu_is h /\ joint = beta_s h ->
  0 < eta -> eta <= 2 -> 0 < h -> h < 1 -> 0 < normal_force alpha h -> intrados eta * (2 - h) <= fac delta eta ->
  joint <= alpha -> mu_ss alpha h <= mu -> 0 < (2 - eta) * cos 0 - (2 + eta) * cos alpha ->
  admissible delta alpha eta mu h (at_shoulder delta alpha eta h) /\ stands_from delta alpha mu eta.
Proof.
  intros (H3 & H18 & ->) **. assert (Hh := haunch_from_shoulder 0 eta h ltac:(lra) H3).
  assert (A : admissible delta alpha eta mu h (at_shoulder delta alpha eta h)).
  { apply admissible_by_two_joints; try lra. apply inside_from_crown; try easy; try lra.
    - intros x Hx. apply Rlt_le, (normal_force_positive alpha); lra.
    - unfold normal_force in Hh. rewrite cos_0, sin_0 in Hh. lra. }
  split; [exact A|]. apply (stands_from_there _ _ _ _ h (at_shoulder delta alpha eta h)); try easy; try lra.
  intros eta' He'. apply (no_thinner_arch_with_sliding_joint delta alpha 0 eta eta' mu h); try easy; lra.
Qed.

(** *** [[r]] *)

(** Without thrust, at unlimited friction. *)
Theorem overturning (eta : R) : 0 = h_whole delta alpha eta -> 0 < eta -> eta <= 2 ->
  intrados eta * (2 - 0) <= fac delta eta -> 0 < (2 - eta) * cos 0 - (2 + eta) * cos alpha ->
  thrust_inside delta alpha eta 0 0 /\ stands_without_limit_from delta alpha eta.
Proof.
  intros H4 **. assert (Hs := shoulder_from_crown eta 0 ltac:(lra) H4). unfold at_crown in Hs.
  assert (A : thrust_inside delta alpha eta 0 0).
  { apply inside_from_crown; try easy; try lra. intros x Hx. unfold normal_force. rewrite Rmult_0_l, Rplus_0_l.
    apply Rmult_le_pos; [lra | positive]. }
  split; [exact A|]. apply (stands_without_limit_from_there _ _ _ 0 0); try easy; try lra.
  intros eta' He' (h & p & Hall).
  apply (no_thinner_arch_by_mechanism 0 1 delta alpha 0 eta eta' 0 0 h p); try apply Hall; try lra.
  - unfold mechanism, haunch_gap, shoulder_gap. unfold at_shoulder in Hs. unfold normal_force in *.
    rewrite cos_0, sin_0. lra.
  - destruct (Hall 0 ltac:(lra)) as [HN _]. unfold normal_force in HN. rewrite cos_0, sin_0 in *.
    unfold thrust_arm, extrados, intrados. rewrite cos_0. nra.
Qed.

End Modes.

(** *** [[s,s]] *)

Theorem purely_sliding (alpha mu h joint : R) : 0 < alpha < PI ->
  mu = mu_ss alpha h /\ mu = mu_is h /\ joint = beta_s h -> 0 < joint -> joint <= alpha -> 0 < normal_force alpha h ->
  forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu'.
Proof.
  intros opening (H17 & H18 & ->) Hs Ha HN mu' Hmu delta eta. assert (Hh : 0 < h < 1).
  { assert (Hsq : 0 < h * (1 - h)) by (apply sqrt_lt_0_alt; rewrite sqrt_0; exact Hs). nra. }
  assert (Hmore : mu * normal_force alpha h = h * sin alpha - alpha * cos alpha)
    by (rewrite H17; unfold mu_ss, normal_force in *; field; lra).
  (* what is left of the shoulder's bound grows as the friction falls *)
  assert (Hbound : 0 < sin alpha - mu' * cos alpha).
  { assert (HS : 0 < sin alpha) by positive. assert (Hcircle := circle alpha).
    assert (E : (sin alpha - mu * cos alpha) * normal_force alpha h = alpha).
    { transitivity (sin alpha * normal_force alpha h - cos alpha * (mu * normal_force alpha h)); [ring|].
      rewrite Hmore. unfold normal_force.
      transitivity (alpha * (sin alpha ^ 2 + cos alpha ^ 2)); [ring | rewrite Hcircle; ring]. }
    assert (0 < sin alpha - mu * cos alpha) by nra. destruct (Rle_lt_dec 0 (cos alpha)); nra. }
  now apply (no_arch_below_purely_sliding delta alpha eta mu mu' h); try lra.
Qed.
