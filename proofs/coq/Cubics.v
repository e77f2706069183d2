(** * The cubic problem (7), its abbreviations (8) and its discriminant (12)

    (2) and (5) together say [2 eta S h = (g - f) (2 - eta)] (haunch) and [h (2 - eta) S = f (2 - eta) - 2 S fac_M]
    (tangency), and (4) adds [A S (2 + eta) = g (2 - eta)]. So [h] and [A] are Moebius functions of [eta], and their
    cubics are the one in [eta] after these substitutions, for any delta_M; the printed ones are delta_M = 1. *)

From Couplet Require Import Moments.

(** Products and powers of what does not vanish. *)
Ltac nonzero :=
  repeat match goal with
    | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified
    | |- _ / _ <> 0 => apply Rmult_integral_contrapositive_currified
    | |- / _ <> 0 => apply Rinv_neq_0_compat
    | |- _ ^ _ <> 0 => apply pow_nonzero
    end; first [assumption | lra].

(** ** (8) *)

Lemma circle (beta : R) : sin beta ^ 2 + cos beta ^ 2 = 1.
Proof. rewrite <- !Rsqr_pow2. apply sin2_cos2. Qed.

(** [f] is the derivative of [beta sin beta]. *)
Theorem f_is_derivative (beta : R) : is_derive (fun b => b * sin b) beta (f_of beta).
Proof. unfold f_of. auto_derive; [easy | ring]. Qed.

(** The two forms of [g]. *)
Theorem g_first_form (beta : R) : g_of beta = g_first beta.
Proof.
  unfold g_of, g_first, f_of.
  transitivity (beta * (sin beta ^ 2 + cos beta ^ 2) + sin beta * cos beta); [rewrite circle|]; ring.
Qed.

(** The link. *)
Theorem link_of_f_and_g (beta : R) : beta * sin beta ^ 2 + cos beta * f_of beta - g_of beta = 0.
Proof. rewrite g_first_form. unfold g_first. ring. Qed.

(** The difference that all of (7) and (12) contain; it shows its sign. *)
Theorem g_minus_f (beta : R) : g_of beta - f_of beta = (beta - sin beta) * (1 - cos beta).
Proof. unfold g_of, f_of. ring. Qed.

Theorem g_minus_f_positive (beta : R) : 0 < beta < 2 * PI -> 0 < g_of beta - f_of beta.
Proof.
  intros Hb. rewrite g_minus_f. apply Rmult_lt_0_compat; [assert (sin beta < beta) by (apply sin_lt_x; lra); lra
    | now apply versine_positive].
Qed.

Theorem g_positive (beta : R) : 0 < beta -> 0 < g_of beta.
Proof.
  intros Hb. unfold g_of. assert (Hs : - (2 * beta) < sin (2 * beta)).
  { assert (sin (2 * beta) > - (2 * beta)); [|lra]. assert (H := sin_lt_x (2 * beta)).
    destruct (SIN_bound (2 * beta)). destruct (Rle_lt_dec 1 beta); [lra|].
    assert (0 < sin (2 * beta)) by (apply sin_gt_0; assert (HPI := PI2_3_2); lra). lra. }
  rewrite sin_2a in Hs. lra.
Qed.

(** The factor that the first cubic and (9) divide by. *)
Theorem three_g_minus_2_S_positive (beta : R) : 0 < beta < PI -> 0 < 3 * g_of beta - 2 * sin beta.
Proof.
  intros Hb. unfold g_of. assert (0 < sin beta) by positive.
  assert (sin beta < beta) by (apply sin_lt_x; lra). destruct (Rle_lt_dec beta (PI / 2)) as [Hc | Hc].
  - assert (0 <= cos beta) by positive. nra.
  - assert (HPI := PI2_3_2). assert (Hcircle := circle beta). destruct (SIN_bound beta). nra.
Qed.

(** ** (2), (4), (5) in terms of [f], [g], [S] *)

(** (5): [beta cot beta + 1 = f / S]. *)
Lemma tangency_in_f (delta beta eta h : R) : sin beta <> 0 -> 2 - eta <> 0 -> h = h_tangency delta beta eta <->
  h * (2 - eta) * sin beta = f_of beta * (2 - eta) - 2 * sin beta * fac delta eta.
Proof. intros HS He. rewrite (tangency_cleared _ _ _ _ HS He). unfold f_of. split; lra. Qed.

(** With (5), (2) is the haunch relation. *)
Theorem haunch_relation (delta beta eta h : R) : sin beta <> 0 -> 2 - eta <> 0 ->
  2 + eta - (2 - eta) * cos beta <> 0 -> h = h_tangency delta beta eta -> h = h_lower delta beta eta <->
  2 * eta * sin beta * h = (g_of beta - f_of beta) * (2 - eta).
Proof.
  intros HS He HD. rewrite (tangency_in_f _ _ _ _ HS He), (lower_thrust_cleared _ _ _ _ HD). rewrite g_first_form.
  unfold g_first. intros H5. split; intros H; [apply (f_equal (fun x => x * sin beta)) in H; nra
    | apply (Rmult_eq_reg_r (sin beta)); [nra | easy]].
Qed.

(** With (2) and (5), (4) is the shoulder relation. *)
Theorem shoulder_relation (delta alpha beta eta h : R) : sin beta <> 0 -> 2 - eta <> 0 -> 2 + eta <> 0 ->
  2 + eta - (2 - eta) * cos beta <> 0 -> h = h_lower delta beta eta -> h = h_tangency delta beta eta ->
  h = h_whole delta alpha eta <-> A alpha * sin beta * (2 + eta) = g_of beta * (2 - eta).
Proof.
  intros HS Hi He HD H2 H5. apply (haunch_relation _ _ _ _ HS Hi HD H5) in H2.
  apply (tangency_in_f _ _ _ _ HS Hi) in H5.
  assert (E : h_whole delta alpha eta * (2 + eta) = A alpha * (2 + eta) - 2 * fac delta eta)
    by (unfold h_whole; field; easy). split; intros H.
  - rewrite <- H in E. nra.
  - apply (Rmult_eq_reg_r ((2 + eta) * sin beta)); [nra | now apply Rmult_integral_contrapositive].
Qed.

(** ** (7) in the thickness *)

(** The two relations give the cubic, and the cubic gives the second from the first. *)
Lemma pol_eta_from_relations (delta f g S eta h : R) :
  2 - eta <> 0 -> h * (2 - eta) * S = f * (2 - eta) - 2 * S * fac delta eta ->
  2 * eta * S * h = (g - f) * (2 - eta) <-> pol_eta delta f g S eta = 0.
Proof.
  intros He H5. unfold pol_eta, fac in *.
  assert (E : delta * S * eta ^ 3 + 3 * (f + g) * eta ^ 2 - 12 * (g - S) * eta + 12 * (g - f)
              = 3 * (2 - eta) * ((g - f) * (2 - eta) - 2 * eta * S * h)).
  { transitivity (3 * (g - f) * (2 - eta) ^ 2 - 6 * eta * (h * (2 - eta) * S)); [rewrite H5; field | ring]. }
  rewrite E. split; intros H; [rewrite H; ring | apply (Rmult_eq_reg_l (3 * (2 - eta))); lra].
Qed.

(** (7), second line, for any delta_M: (2) = (5) exactly where the cubic vanishes. *)
Theorem cubic_in_thickness_from_2_5 (delta beta eta : R) : sin beta <> 0 -> 2 - eta <> 0 ->
  2 + eta - (2 - eta) * cos beta <> 0 -> h_lower delta beta eta = h_tangency delta beta eta <->
  pol_eta delta (f_of beta) (g_of beta) (sin beta) eta = 0.
Proof.
  intros HS He HD. assert (H5 : h_tangency delta beta eta = h_tangency delta beta eta) by easy.
  apply (tangency_in_f _ _ _ _ HS He) in H5. rewrite <- (pol_eta_from_relations _ _ _ _ _ _ He H5).
  rewrite <- (haunch_relation _ _ _ (h_tangency delta beta eta) HS He HD) by easy. split; congruence.
Qed.

(** The printed equation is the case delta_M = 1. *)
Theorem pol_eta_is_printed (f g S eta : R) : pol_eta 1 f g S eta = pol_eta_printed f g S eta.
Proof. unfold pol_eta, pol_eta_printed. ring. Qed.

(** In an arch thinner than [2 r], with the haunch between crown and springing, no denominator vanishes. *)
Theorem cubic_in_thickness_in_the_arch (delta beta eta : R) : 0 < beta < PI -> 0 < eta < 2 ->
  h_lower delta beta eta = h_tangency delta beta eta <-> pol_eta delta (f_of beta) (g_of beta) (sin beta) eta = 0.
Proof.
  intros Hb He. apply cubic_in_thickness_from_2_5; [positive | lra
    | apply Rgt_not_eq, lever_of_lower_thrust_positive; lra].
Qed.

(** ** (7) in the thrust and in the opening *)

(** The Moebius substitutions carry the cubic in [eta] over. *)
Lemma pol_h_of_thickness (delta f g S eta h : R) : 2 * eta * S * h = (g - f) * (2 - eta) ->
  2 * S * eta ^ 3 * pol_h delta f g S h = (g - f) ^ 2 * pol_eta delta f g S eta.
Proof.
  intros Hh.
  transitivity ((3 / 2) * (2 * eta * S * h) ^ 3 - (3 / 2) * (3 * f - g - 2 * S) * eta * (2 * eta * S * h) ^ 2 - 3 *
    (g - f) * (f - 2 * S) * eta ^ 2 * (2 * eta * S * h) + (3 + delta) * S * (g - f) ^ 2 * eta ^ 3);
    [unfold pol_h; field|]. rewrite Hh. unfold pol_eta. field.
Qed.

Lemma pol_A_of_thickness (delta f g S eta A : R) : A * S * (2 + eta) = g * (2 - eta) ->
  S * (2 + eta) ^ 3 * pol_A delta f g S A = 4 * g ^ 3 * pol_eta delta f g S eta.
Proof.
  intros HA.
  transitivity ((3 * g - (3 + delta) / 2 * S) * (A * S * (2 + eta)) ^ 3 + 3 * g * (g - f - (1 - delta) / 2 * S) *
    (2 + eta) * (A * S * (2 + eta)) ^ 2 - 3 * g ^ 2 * (f - (1 - delta) / 2 * S) * (2 + eta) ^ 2 * (A * S * (2 + eta))
    + (3 + delta) / 2 * S * g ^ 3 * (2 + eta) ^ 3); [unfold pol_A; field|]. rewrite HA. unfold pol_eta. field.
Qed.

(** (7), third line, for any delta_M. *)
Theorem cubic_in_thrust_from_2_5 (delta beta eta h : R) : sin beta <> 0 -> eta <> 0 -> 2 - eta <> 0 ->
  2 + eta - (2 - eta) * cos beta <> 0 -> h = h_lower delta beta eta -> h = h_tangency delta beta eta ->
  pol_h delta (f_of beta) (g_of beta) (sin beta) h = 0.
Proof.
  intros HS H0 He HD H2 H5.
  assert (Heta : pol_eta delta (f_of beta) (g_of beta) (sin beta) eta = 0)
    by (apply cubic_in_thickness_from_2_5; congruence).
  apply (haunch_relation _ _ _ _ HS He HD H5), (pol_h_of_thickness delta) in H2. rewrite Heta, Rmult_0_r in H2.
  apply Rmult_integral in H2. destruct H2 as [H2 | H2]; [|easy]. contradict H2. nonzero.
Qed.

(** (7), first line, for any delta_M. *)
Theorem cubic_in_opening_from_2_4_5 (delta alpha beta eta h : R) : sin beta <> 0 -> 2 - eta <> 0 -> 2 + eta <> 0 ->
  2 + eta - (2 - eta) * cos beta <> 0 -> h = h_lower delta beta eta -> h = h_whole delta alpha eta ->
  h = h_tangency delta beta eta -> pol_A delta (f_of beta) (g_of beta) (sin beta) (A alpha) = 0.
Proof.
  intros HS Hi He HD H2 H4 H5.
  assert (Heta : pol_eta delta (f_of beta) (g_of beta) (sin beta) eta = 0)
    by (apply cubic_in_thickness_from_2_5; congruence).
  apply (shoulder_relation _ _ _ _ _ HS Hi He HD H2 H5), (pol_A_of_thickness delta (f_of beta)) in H4.
  rewrite Heta, Rmult_0_r in H4. apply Rmult_integral in H4. destruct H4 as [H4 | H4]; [|easy]. contradict H4.
  nonzero.
Qed.

(** The printed equations are the case delta_M = 1. *)
Theorem pol_A_is_printed (f g S A : R) : pol_A 1 f g S A = pol_A_printed f g S A.
Proof. unfold pol_A, pol_A_printed. field. Qed.

Theorem pol_h_is_printed (f g S h : R) : pol_h 1 f g S h = pol_h_printed f g S h.
Proof. unfold pol_h, pol_h_printed. field. Qed.

(** (7) in the arch: a purely rotational state with a haunch at [beta] satisfies all three. *)
Theorem cubic_problem_in_the_arch (delta alpha beta eta h : R) : 0 < beta < PI -> 0 < eta < 2 ->
  h = h_lower delta beta eta -> h = h_whole delta alpha eta -> h = h_tangency delta beta eta ->
  pol_A delta (f_of beta) (g_of beta) (sin beta) (A alpha) = 0 /\
  pol_eta delta (f_of beta) (g_of beta) (sin beta) eta = 0 /\ pol_h delta (f_of beta) (g_of beta) (sin beta) h = 0.
Proof.
  intros Hb He H2 H4 H5. assert (HS : sin beta <> 0) by positive.
  assert (HD : 2 + eta - (2 - eta) * cos beta <> 0) by (apply Rgt_not_eq, lever_of_lower_thrust_positive; lra).
  repeat split.
  - apply (cubic_in_opening_from_2_4_5 delta alpha beta eta h); try easy; lra.
  - apply cubic_in_thickness_from_2_5; try easy; [lra | congruence].
  - apply (cubic_in_thrust_from_2_5 delta beta eta h); try easy; lra.
Qed.

Theorem printed_cubic_problem_in_the_arch (alpha beta eta h : R) : 0 < beta < PI -> 0 < eta < 2 ->
  h = h_lower 1 beta eta -> h = h_whole 1 alpha eta -> h = h_tangency 1 beta eta ->
  pol_A_printed (f_of beta) (g_of beta) (sin beta) (A alpha) = 0 /\
  pol_eta_printed (f_of beta) (g_of beta) (sin beta) eta = 0 /\
  pol_h_printed (f_of beta) (g_of beta) (sin beta) h = 0.
Proof. rewrite <- pol_A_is_printed, <- pol_eta_is_printed, <- pol_h_is_printed. apply cubic_problem_in_the_arch. Qed.

(** The converses, if delta_M is not 0: a root of the cubic in [A] or in [h] is that of a state, whose thickness the
    two relations give; for delta_M = 0 the roots that Heyman's quadratics leave out are the exceptions. *)
Theorem state_of_opening_root (delta alpha beta : R) : delta <> 0 -> sin beta <> 0 -> g_of beta <> 0 ->
  pol_A delta (f_of beta) (g_of beta) (sin beta) (A alpha) = 0 ->
  let eta := 2 * (g_of beta - A alpha * sin beta) / (g_of beta + A alpha * sin beta) in
  2 - eta <> 0 -> 2 + eta - (2 - eta) * cos beta <> 0 ->
  h_lower delta beta eta = h_tangency delta beta eta /\ h_lower delta beta eta = h_whole delta alpha eta.
Proof.
  intros Hd HS Hg HA eta Hi HD. assert (Hsum : g_of beta + A alpha * sin beta <> 0).
  { intros H. assert (E : A alpha = - g_of beta / sin beta) by (apply equals_quotient; lra). rewrite E in HA.
    assert (E0 : 4 * delta * g_of beta ^ 3 = 0) by (rewrite <- HA; unfold pol_A; field; easy).
    contradict E0. nonzero. }
  assert (Hx : 2 + eta = 4 * g_of beta / (g_of beta + A alpha * sin beta)) by (unfold eta; field; easy).
  assert (He : 2 + eta <> 0) by (rewrite Hx; nonzero).
  assert (HM : A alpha * sin beta * (2 + eta) = g_of beta * (2 - eta)) by (unfold eta; field; easy).
  assert (E := pol_A_of_thickness delta (f_of beta) _ _ _ _ HM). rewrite HA, Rmult_0_r in E. symmetry in E.
  apply Rmult_integral in E. destruct E as [E | E]; [contradict E; nonzero|].
  apply (cubic_in_thickness_from_2_5 delta beta eta HS Hi HD) in E. split; [easy|].
  now apply (shoulder_relation delta alpha beta eta (h_lower delta beta eta) HS Hi He HD).
Qed.

Theorem state_of_thrust_root (delta beta h : R) : delta <> 0 -> sin beta <> 0 -> g_of beta - f_of beta <> 0 ->
  pol_h delta (f_of beta) (g_of beta) (sin beta) h = 0 ->
  let eta := 2 * (g_of beta - f_of beta) / (2 * sin beta * h + (g_of beta - f_of beta)) in
  2 - eta <> 0 -> 2 + eta - (2 - eta) * cos beta <> 0 -> h = h_lower delta beta eta /\ h = h_tangency delta beta eta.
Proof.
  intros Hd HS Hk Hh eta Hi HD. assert (Hsum : 2 * sin beta * h + (g_of beta - f_of beta) <> 0).
  { intros H. assert (E : h = - (g_of beta - f_of beta) / (2 * sin beta)) by (apply equals_quotient; lra).
    rewrite E in Hh. assert (E0 : delta / 2 * (g_of beta - f_of beta) ^ 2 = 0)
      by (rewrite <- Hh; unfold pol_h; field; easy). contradict E0. nonzero. }
  assert (He : eta <> 0) by (unfold eta; nonzero).
  assert (HM : 2 * eta * sin beta * h = (g_of beta - f_of beta) * (2 - eta)) by (unfold eta; field; easy).
  assert (E := pol_h_of_thickness delta _ _ _ _ _ HM). rewrite Hh, Rmult_0_r in E. symmetry in E.
  apply Rmult_integral in E. destruct E as [E | E]; [contradict E; nonzero|].
  apply (cubic_in_thickness_from_2_5 delta beta eta HS Hi HD) in E.
  assert (H5 := proj1 (haunch_relation delta beta eta (h_tangency delta beta eta) HS Hi HD eq_refl)).
  enough (h = h_tangency delta beta eta) by (split; congruence).
  apply (Rmult_eq_reg_l (2 * eta * sin beta)); [|nonzero]. rewrite HM, H5; congruence.
Qed.

(** ** Heyman: delta_M = 0 *)

(** In [eta] the cubic becomes the quadratic; in [A] and [h] it keeps a third root, negative in the
    arch, beside the quadratic. *)
Theorem heyman_in_thickness (f g S eta : R) : pol_eta 0 f g S eta = 3 * heyman_eta f g S eta.
Proof. unfold pol_eta, heyman_eta. ring. Qed.

Theorem heyman_in_opening (f g S A : R) : pol_A 0 f g S A = 3 / 2 * (g + S * A) * heyman_A f g S A.
Proof. unfold pol_A, heyman_A. field. Qed.

Theorem heyman_in_thrust (f g S h : R) : pol_h 0 f g S h = 3 / 2 * ((g - f) + 2 * S * h) * heyman_h f g S h.
Proof. unfold pol_h, heyman_h. field. Qed.

(** Heyman's states: the quadratics. *)
Theorem heyman_quadratics_in_the_arch (alpha beta eta h : R) : 0 < beta < PI -> 0 < eta < 2 ->
  h = h_lower 0 beta eta -> h = h_whole 0 alpha eta -> h = h_tangency 0 beta eta ->
  heyman_A (f_of beta) (g_of beta) (sin beta) (A alpha) = 0 /\ heyman_h (f_of beta) (g_of beta) (sin beta) h = 0.
Proof.
  intros Hb He H2 H4 H5. assert (HS : 0 < sin beta) by positive. assert (HS' : sin beta <> 0) by lra.
  assert (Hi : 2 - eta <> 0) by lra. assert (Hx : 2 + eta <> 0) by lra.
  assert (HD : 2 + eta - (2 - eta) * cos beta <> 0) by (apply Rgt_not_eq, lever_of_lower_thrust_positive; lra).
  assert (Hk : 0 < g_of beta - f_of beta) by (apply g_minus_f_positive; lra).
  assert (Hg : 0 < g_of beta) by (apply g_positive; lra).
  destruct (cubic_problem_in_the_arch 0 alpha beta eta h Hb He H2 H4 H5) as (HA & _ & Hh).
  rewrite heyman_in_opening in HA. rewrite heyman_in_thrust in Hh.
  apply (haunch_relation _ _ _ _ HS' Hi HD H5) in H2 as Hhaunch.
  apply (shoulder_relation _ _ _ _ _ HS' Hi Hx HD H2 H5) in H4 as Hshoulder. split.
  - apply Rmult_integral in HA. destruct HA as [HA | HA]; [|easy]. exfalso. nra.
  - apply Rmult_integral in Hh. destruct Hh as [Hh | Hh]; [|easy]. exfalso. nra.
Qed.

(** ** (12): the discriminants *)

(** Of [a x^3 + b x^2 + c x + d]. *)
Definition discriminant (a b c d : R) : R :=
  b ^ 2 * c ^ 2 - 4 * a * c ^ 3 - 4 * b ^ 3 * d - 27 * a ^ 2 * d ^ 2 + 18 * a * b * c * d.

Theorem radicand_is_printed (f g S : R) : radicand 1 f g S = radicand_printed f g S.
Proof. unfold radicand, radicand_printed. ring. Qed.

(** For any delta_M: a square, a constant, and (12). *)
Theorem discriminant_in_thickness (delta f g S : R) :
  discriminant (delta * S) (3 * (f + g)) (- 12 * (g - S)) (12 * (g - f)) = - 432 * radicand delta f g S.
Proof. unfold discriminant, radicand. ring. Qed.

Theorem discriminant_in_opening (delta f g S : R) :
  discriminant (S ^ 2 * (3 * g - (3 + delta) / 2 * S))
    (3 * g * S * (g - f - (1 - delta) / 2 * S))
    (- 3 * g ^ 2 * (f - (1 - delta) / 2 * S)) ((3 + delta) / 2 * g ^ 3)
  = - 27 * (S * g ^ 3) ^ 2 * radicand delta f g S.
Proof. unfold discriminant, radicand. field. Qed.

Theorem discriminant_in_thrust (delta f g S : R) :
  discriminant (6 * S ^ 2) (- 3 * S * (3 * f - g - 2 * S)) (- 3 * (g - f) * (f - 2 * S))
    ((3 + delta) / 2 * (g - f) ^ 2)
  = - 27 * (S * (g - f)) ^ 2 * radicand delta f g S.
Proof. unfold discriminant, radicand. field. Qed.

(** At delta_M = 0 the radicand is a square times the discriminant of Heyman's quadratics. *)
Theorem radicand_heyman (f g S : R) : radicand 0 f g S = - 3 * (f + g) ^ 2 * (f ^ 2 - 2 * g * S + S ^ 2).
Proof. unfold radicand. ring. Qed.

Theorem discriminant_heyman_in_thickness (f g S : R) :
  (4 * (g - S)) ^ 2 - 4 * (f + g) * (4 * (g - f)) = 16 * (f ^ 2 - 2 * g * S + S ^ 2).
Proof. ring. Qed.

Theorem discriminant_heyman_in_opening (f g S : R) :
  (2 * f * g) ^ 2 - 4 * (S * (2 * g - S)) * g ^ 2 = (2 * g) ^ 2 * (f ^ 2 - 2 * g * S + S ^ 2).
Proof. ring. Qed.

Theorem discriminant_heyman_in_thrust (f g S : R) :
  (2 * (f - S)) ^ 2 - 4 * (2 * S) * (g - f) = 4 * (f ^ 2 - 2 * g * S + S ^ 2).
Proof. ring. Qed.
