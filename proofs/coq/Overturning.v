(** * Purely overturning states and the end of rotation: (13)-(16)

    [A(alpha)] falls strictly, so that equal [A] means equal half-angle of embrace. (13) follows from (4), and from (3)
    at the crown, with [h = 0]; (14), (15) are the inverses, with their branch and range, and the values at [l] and [L].
    (16) **as printed is false**: it does not follow from (5) and does not have the root the paper gives; the corrected
    equation does both.

    The paper's comparison of the two self-weights (Sec. 3: [beta_r] wider and [eta] lower for Milankovitch's) holds at
    J and B with equality only: [beta_r = 0] defines both points and [eta = 2] defines B, for either weight. *)

From Couplet Require Import Moments Cubics.

(** ** [A] falls strictly from 2 to 0 *)

Lemma derivative_of_A (alpha : R) : 1 - cos alpha <> 0 -> is_derive A alpha (- (alpha - sin alpha) / (1 - cos alpha)).
Proof.
  intros HD. unfold A. auto_derive; [exact HD|].
  transitivity (((sin alpha + alpha * cos alpha) * (1 - cos alpha) - alpha * sin alpha ^ 2)
                / (1 - cos alpha) ^ 2); [field; easy|].
  replace (sin alpha ^ 2) with ((1 - cos alpha) * (1 + cos alpha)) by (assert (Hcircle := circle alpha); lra).
  field; easy.
Qed.

Theorem A_strictly_decreasing (a b : R) : 0 < a -> a < b -> b < 2 * PI -> A b < A a.
Proof.
  intros Ha Hab Hb. destruct (MVT_cor2 A (fun x => - (x - sin x) / (1 - cos x)) a b Hab) as (c & Hc & Hin).
  { intros c Hc. apply is_derive_Reals, derivative_of_A. positive. }
  assert (0 < 1 - cos c) by positive. assert (sin c < c) by (apply sin_lt_x; lra).
  assert (0 < (c - sin c) / (1 - cos c)) by positive.
  replace (- (c - sin c) / (1 - cos c)) with (- ((c - sin c) / (1 - cos c))) in Hc by (field; lra). nra.
Qed.

(** Equal [A], equal half-angle. *)
Theorem A_injective (a b : R) : 0 < a < 2 * PI -> 0 < b < 2 * PI -> A a = A b -> a = b.
Proof.
  intros Ha Hb H. destruct (Rtotal_order a b) as [Hlt | [Heq | Hgt]]; [|easy|].
  - assert (A b < A a) by (apply A_strictly_decreasing; lra). lra.
  - assert (A a < A b) by (apply A_strictly_decreasing; lra). lra.
Qed.

(** It takes a value between two of its values once. *)
Theorem half_opening v lo hi : 0 < lo -> lo < hi -> hi < 2 * PI -> v < A lo -> A hi < v ->
  exists alpha, lo < alpha < hi /\ A alpha = v /\ (forall other, 0 < other < 2 * PI -> A other = v -> other = alpha).
Proof.
  intros H0 Hlohi Hpi Hlo Hhi.
  destruct (Ranalysis5.IVT_interv (fun x => v - A x) lo hi) as [alpha [Halpha Hroot]]; try lra.
  - intros x Hx. assert (0 < 1 - cos x) by positive.
    apply continuity_pt_filterlim, (ex_derive_continuous (fun x => v - A x)).
    apply @ex_derive_minus; [apply ex_derive_const | eexists; apply derivative_of_A; lra].
  - assert (alpha <> lo /\ alpha <> hi) by (split; intros ->; lra). exists alpha. split; [lra | split; [lra |]].
    intros other Hother Hv. apply A_injective; [exact Hother | lra | lra].
Qed.

(** ** (13) *)

(** From (4): no thrust. *)
Theorem overturning_from_whole_thrust (delta alpha eta : R) :
  h_whole delta alpha eta = 0 <-> A alpha = A_overturning delta eta.
Proof. unfold h_whole, A_overturning, fac. split; lra. Qed.

(** From (3) with the rotational joint at the crown. Unlike (4) it has a denominator of its own,
    which is positive for [alpha >= PI/2]. *)
Theorem overturning_from_upper_thrust (delta alpha eta : R) : 1 - cos alpha <> 0 -> 2 + eta <> 0 ->
  (2 - eta) - (2 + eta) * cos alpha <> 0 -> h_upper delta alpha 0 eta = 0 <-> A alpha = A_overturning delta eta.
Proof.
  intros HA He HD. rewrite <- overturning_from_whole_thrust.
  assert (HD' : (2 - eta) * cos 0 - (2 + eta) * cos alpha <> 0) by (rewrite cos_0; lra).
  transitivity (0 = h_upper delta alpha 0 eta); [split; congruence|]. rewrite (upper_thrust_cleared _ _ _ _ _ HD').
  transitivity (0 = h_whole delta alpha eta); [|split; congruence].
  rewrite (whole_thrust_cleared _ _ _ _ HA He), cos_0, sin_0. split; lra.
Qed.

(** ** (14): Heyman *)

Theorem A_heyman_from_13 (eta : R) : A_overturning 0 eta = A_heyman eta.
Proof. unfold A_overturning, A_heyman. rewrite Rmult_0_l. lra. Qed.

Theorem inverse_heyman (A eta : R) : 0 < A -> -2 < eta -> A = A_heyman eta <-> eta = eta_heyman A.
Proof. intros HA He. unfold A_heyman, eta_heyman. split; [intros -> | intros ->]; field; lra. Qed.

(** [eta] in [0, 2] exactly for [A] in [1/2, 1]. *)
Theorem range_heyman (A : R) : 0 < A -> 0 <= eta_heyman A <= 2 <-> 1 / 2 <= A <= 1.
Proof.
  intros HA. unfold eta_heyman. assert (E : 2 * (1 / A - 1) * A = 2 - 2 * A) by (field; lra).
  set (eta := 2 * (1 / A - 1)) in *. split; intros H; nra.
Qed.

(** ** (15): Milankovitch *)

Theorem A_milankovitch_from_13 (eta : R) : 2 + eta <> 0 -> A_overturning 1 eta = A_milankovitch eta.
Proof. unfold A_overturning, A_milankovitch. intros He. field. exact He. Qed.

(** The equation behind (15) and its two roots. *)
Lemma quadratic_of_milankovitch (A eta : R) : 2 + eta <> 0 ->
  A = A_milankovitch eta <-> (eta - 3 * A) ^ 2 = 3 * (3 * A ^ 2 + 4 * A - 4).
Proof. intros He. unfold A_milankovitch. rewrite equals_quotient by nonzero. split; intros H; nra. Qed.

Definition eta_milankovitch_other (A : R) : R := 3 * A + sqrt (3 * (3 * A ^ 2 + 4 * A - 4)).

(** Below [A = 2/3] there is no overturning state. *)
Theorem A_milankovitch_at_least_2_3 (eta : R) : -2 < eta -> 2 / 3 <= A_milankovitch eta.
Proof.
  intros He. unfold A_milankovitch. apply (Rmult_le_reg_r (6 * (2 + eta))); [lra|].
  replace ((12 + eta ^ 2) / (6 * (2 + eta)) * (6 * (2 + eta))) with (12 + eta ^ 2) by (field; lra).
  assert (0 <= (eta - 2) ^ 2) by apply pow2_ge_0. nra.
Qed.

(** (15) right is the inverse on the branch [eta <= 2]. *)
Theorem inverse_milankovitch (A eta : R) : 2 / 3 <= A -> -2 < eta <= 2 ->
  A = A_milankovitch eta <-> eta = eta_milankovitch A.
Proof.
  intros HA He. rewrite quadratic_of_milankovitch by lra. unfold eta_milankovitch.
  assert (Hrad : 0 <= 3 * (3 * A ^ 2 + 4 * A - 4)) by nra. split; intros H.
  - rewrite <- H. assert (E : sqrt ((eta - 3 * A) ^ 2) = 3 * A - eta).
    { replace ((eta - 3 * A) ^ 2) with ((3 * A - eta) ^ 2) by ring. apply sqrt_pow2. lra. }
    lra.
  - rewrite H.
    replace (3 * A - sqrt (3 * (3 * A ^ 2 + 4 * A - 4)) - 3 * A) with (- sqrt (3 * (3 * A ^ 2 + 4 * A - 4))) by ring.
    replace ((- sqrt (3 * (3 * A ^ 2 + 4 * A - 4))) ^ 2)
      with (sqrt (3 * (3 * A ^ 2 + 4 * A - 4)) * sqrt (3 * (3 * A ^ 2 + 4 * A - 4))) by ring. now apply sqrt_sqrt.
Qed.

(** Both roots: (15) right and another one, which is not below the physical limit 2. *)
Theorem both_roots_milankovitch (A eta : R) : 2 / 3 <= A -> 2 + eta <> 0 ->
  A = A_milankovitch eta <-> eta = eta_milankovitch A \/ eta = eta_milankovitch_other A.
Proof.
  intros HA He. rewrite (quadratic_of_milankovitch A eta He). unfold eta_milankovitch, eta_milankovitch_other.
  assert (Hroot : sqrt (3 * (3 * A ^ 2 + 4 * A - 4)) ^ 2 = 3 * (3 * A ^ 2 + 4 * A - 4)) by (apply pow2_sqrt; nra).
  set (root := sqrt _) in *. rewrite <- Hroot. split.
  - intros H. assert (E : (eta - 3 * A - root) * (eta - 3 * A + root) = 0) by lra. apply Rmult_integral in E.
    destruct E; [right | left]; lra.
  - intros [-> | ->]; ring.
Qed.

Theorem other_root_beyond_limit (A : R) : 2 / 3 <= A -> 2 <= eta_milankovitch_other A.
Proof.
  intros HA. unfold eta_milankovitch_other. assert (0 <= sqrt (3 * (3 * A ^ 2 + 4 * A - 4))) by apply sqrt_pos. lra.
Qed.

(** [eta] in [0, 2] exactly for [A] in [2/3, 1]. *)
Theorem range_milankovitch (A : R) : 2 / 3 <= A -> eta_milankovitch A <= 2 /\ (0 <= eta_milankovitch A <-> A <= 1).
Proof.
  intros HA. unfold eta_milankovitch. assert (Hrad : 0 <= 3 * (3 * A ^ 2 + 4 * A - 4)) by nra.
  assert (Hroot := pow2_sqrt _ Hrad). assert (Hpos := sqrt_pos (3 * (3 * A ^ 2 + 4 * A - 4))).
  set (root := sqrt _) in *. repeat split; intros; nra.
Qed.

(** ** The end of rotation: (16) *)

(** [beta cot beta] is 1 in the limit. *)
Theorem times_cotangent_at_crown : is_lim (fun beta => beta * cot beta) 0 1.
Proof.
  apply (is_lim_ext_loc (fun beta => cos beta / (sin beta / beta))).
  { exists (mkposreal PI PI_RGT_0). intros x Hball Hx. unfold cot. assert (Hdist : Rabs x < PI).
    { revert Hball. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
      now rewrite Ropp_0, Rplus_0_r. }
    assert (sin x <> 0).
    { apply Rabs_def2 in Hdist. destruct (Rtotal_order x 0) as [Hneg | [H0 | Hpos]]; [|easy|].
      - assert (0 < sin (- x)) by positive. rewrite sin_neg in *. lra.
      - assert (0 < sin x) by positive. lra. }
    field. split; assumption. }
  replace (Finite 1) with (Rbar_div (cos 0) 1) by (rewrite cos_0; simpl; f_equal; field). apply is_lim_div;
    [apply is_lim_continuity, continuity_cos | exact is_lim_sinc_0 | injection; lra | easy].
Qed.

(** (5) at the crown: its limit is the left side of the corrected (16). *)
Theorem tangency_at_crown (delta eta : R) : 2 - eta <> 0 ->
  is_lim (fun beta => h_tangency delta beta eta) 0 (end_of_rotation delta eta).
Proof.
  intros He. unfold h_tangency.
  replace (end_of_rotation delta eta) with (1 + (1 - 2 / (2 - eta) * fac delta eta))
    by (unfold end_of_rotation, fac; field; easy).
  apply (is_lim_ext (fun beta => beta * cot beta + (1 - 2 / (2 - eta) * fac delta eta))).
  { intros beta. ring. }
  apply (is_lim_plus' _ _ 0 1); [exact times_cotangent_at_crown | apply is_lim_const].
Qed.

(** (2) at the crown: no thrust, whatever the thickness. So (5) decides. *)
Theorem lower_thrust_at_crown (delta eta : R) : h_lower delta 0 eta = 0.
Proof.
  unfold h_lower. rewrite sin_0, cos_0. replace ((2 - eta) * 0 * 0 - 2 * (1 - 1) * fac delta eta) with 0 by ring.
  apply Rmult_0_l.
Qed.

(** The corrected (16) is what (5) says at the crown without thrust. *)
Theorem corrected_16_is_tangency_at_crown (delta eta : R) : 2 - eta <> 0 ->
  is_lim (fun beta => h_tangency delta beta eta) 0 0 <-> end_of_rotation delta eta = 0.
Proof.
  intros He. pose proof (tangency_at_crown delta eta He) as Hlim. split; intros H.
  - apply is_lim_unique in H, Hlim. rewrite Hlim in H. now injection H.
  - now rewrite H in Hlim.
Qed.

(** Its roots: 1 for Heyman, [2 (2 sqrt 3 - 3)] for Milankovitch. *)
Theorem end_of_rotation_heyman (eta : R) : 2 - eta <> 0 -> end_of_rotation 0 eta = 0 <-> eta = 1.
Proof.
  intros He. unfold end_of_rotation.
  replace (1 - eta / (2 - eta) * (1 + 0 * eta / 6)) with (2 * (1 - eta) / (2 - eta)) by (field; easy).
  rewrite quotient_equals by easy. split; intros; lra.
Qed.

Lemma sqrt_3_square : sqrt 3 ^ 2 = 3.
Proof. apply pow2_sqrt. lra. Qed.

Lemma sqrt_3_bounds : 1.732 < sqrt 3 < 1.7321.
Proof. assert (H := sqrt_3_square). assert (Hpos : 0 < sqrt 3) by (apply sqrt_lt_R0; lra). split; nra. Qed.

Lemma eta_l_in_the_arch : 0 < eta_l_milankovitch < 2.
Proof. unfold eta_l_milankovitch. assert (H := sqrt_3_bounds). lra. Qed.

Theorem end_of_rotation_milankovitch (eta : R) : 0 <= eta -> 2 - eta <> 0 ->
  end_of_rotation 1 eta = 0 <-> eta = eta_l_milankovitch.
Proof.
  intros H0 He. unfold end_of_rotation, eta_l_milankovitch. assert (H := sqrt_3_square). assert (Hb := sqrt_3_bounds).
  replace (1 - eta / (2 - eta) * (1 + 1 * eta / 6))
    with (((6 + 4 * sqrt 3 + eta) * (2 * (2 * sqrt 3 - 3) - eta)) / (6 * (2 - eta))).
  - rewrite quotient_equals by nonzero. rewrite Rmult_0_l. split.
    + intros E. apply Rmult_integral in E. destruct E; lra.
    + intros ->. ring.
  - apply (Rmult_eq_reg_r (6 * (2 - eta))); [|nonzero].
    transitivity (16 * sqrt 3 ^ 2 - (6 + eta) ^ 2); [|rewrite H]; field; easy.
Qed.

(** *** (16) as printed *)

(** For Heyman nothing is wrong with it. *)
Theorem printed_16_heyman (eta : R) : end_of_rotation_printed 0 eta = end_of_rotation 0 eta.
Proof. unfold end_of_rotation_printed, end_of_rotation. f_equal. f_equal. field. Qed.

(** For Milankovitch it is a cubic, [eta^3 + 24 eta - 24 = 0]. *)
Lemma printed_16_cleared (eta : R) : 2 - eta <> 0 ->
  end_of_rotation_printed 1 eta = 0 <-> eta ^ 3 + 24 * eta - 24 = 0.
Proof.
  intros He. unfold end_of_rotation_printed.
  replace (1 - eta / (2 - eta) * (1 + 1 * eta ^ 2 / 12))
    with ((- (eta ^ 3 + 24 * eta - 24)) / (12 * (2 - eta))) by (field; easy).
  rewrite quotient_equals by nonzero. split; intros; lra.
Qed.

(** Refuted: the thickness the paper gives is not a root. *)
Theorem printed_16_does_not_have_its_root : end_of_rotation_printed 1 eta_l_milankovitch <> 0.
Proof.
  assert (He := eta_l_in_the_arch). rewrite printed_16_cleared by lra. unfold eta_l_milankovitch in *.
  assert (H := sqrt_3_square). assert (Hb := sqrt_3_bounds).
  replace ((2 * (2 * sqrt 3 - 3)) ^ 3 + 24 * (2 * (2 * sqrt 3 - 3)) - 24)
    with (64 * sqrt 3 * sqrt 3 ^ 2 - 288 * sqrt 3 ^ 2 + 432 * sqrt 3 - 216 + 96 * sqrt 3 - 144 - 24) by ring.
  rewrite H. lra.
Qed.

(** Its only root is another number. *)
Theorem root_of_printed_16 : exists root, 0.96 < root < 0.97 /\ forall eta, 2 - eta <> 0 ->
  end_of_rotation_printed 1 eta = 0 <-> eta = root.
Proof.
  destruct (IVT (fun x => x ^ 3 + 24 * x - 24) 0.96 0.97) as (root & Hin & Hroot); try lra.
  { reg. }
  exists root. split; [nra|]. intros eta He. rewrite (printed_16_cleared eta He). split.
  - intros H. assert (E : (eta - root) * (eta ^ 2 + eta * root + root ^ 2 + 24) = 0) by lra.
    apply Rmult_integral in E. destruct E as [E | E]; [lra | nra].
  - now intros ->.
Qed.

(** Refuted: it is not what (5) says at the crown without thrust. *)
Theorem printed_16_does_not_follow_from_5 :
  ~ (forall eta, 0 < eta < 2 -> is_lim (fun beta => h_tangency 1 beta eta) 0 0 <-> end_of_rotation_printed 1 eta = 0).
Proof.
  intros H. assert (He := eta_l_in_the_arch). apply printed_16_does_not_have_its_root, H; [easy|].
  apply corrected_16_is_tangency_at_crown; [lra|]. now apply end_of_rotation_milankovitch; lra.
Qed.

(** ** The values at [l] and [L] *)

Theorem A_l_heyman : A_heyman 1 = 2 / 3.
Proof. unfold A_heyman. lra. Qed.

Theorem A_l_milankovitch : A_milankovitch eta_l_milankovitch = sqrt 3 - 1.
Proof.
  assert (He := eta_l_in_the_arch). unfold A_milankovitch. rewrite quotient_equals by nonzero.
  unfold eta_l_milankovitch. assert (H := sqrt_3_square). nra.
Qed.

Theorem A_L_heyman : A_heyman 2 = 1 / 2.
Proof. unfold A_heyman. lra. Qed.

Theorem A_L_milankovitch : A_milankovitch 2 = 2 / 3.
Proof. unfold A_milankovitch. lra. Qed.

(** At [A = 2/3] the term under the square root of (15) is 0 and [eta = 2], with a vertical tangent. *)
Theorem radicand_of_15_at_L : 3 * (3 * (2 / 3) ^ 2 + 4 * (2 / 3) - 4) = 0.
Proof. field. Qed.

Theorem eta_L_milankovitch : eta_milankovitch (2 / 3) = 2.
Proof. unfold eta_milankovitch. rewrite radicand_of_15_at_L, sqrt_0. lra. Qed.

Theorem vertical_tangent_at_L : is_derive A_milankovitch 2 0.
Proof. unfold A_milankovitch. auto_derive; [lra | field]. Qed.

(** The physical limit of Milankovitch's overturning arch has the half-angle at which Heyman's rotation ends. *)
Theorem L_of_milankovitch_is_l_of_heyman (alpha_L alpha_l : R) : 0 < alpha_L < 2 * PI -> 0 < alpha_l < 2 * PI ->
  h_whole 1 alpha_L 2 = 0 -> h_whole 0 alpha_l 1 = 0 -> alpha_L = alpha_l.
Proof.
  intros HL Hl EL El. apply A_injective; try easy. apply overturning_from_whole_thrust in EL, El. rewrite EL, El.
  rewrite A_milankovitch_from_13, A_heyman_from_13, A_L_milankovitch, A_l_heyman; lra.
Qed.

(** ** The slopes of the overturning branch where it joins the rotational states *)

Theorem slope_at_l_heyman : is_derive eta_heyman (2 / 3) (- 9 / 2).
Proof. unfold eta_heyman. auto_derive; [lra | field]. Qed.

Lemma root_of_15_at_l : sqrt (3 * (3 * (sqrt 3 - 1) ^ 2 + 4 * (sqrt 3 - 1) - 4)) = 3 - sqrt 3.
Proof.
  assert (H := sqrt_3_square). assert (Hb := sqrt_3_bounds).
  replace (3 * (3 * (sqrt 3 - 1) ^ 2 + 4 * (sqrt 3 - 1) - 4)) with ((3 - sqrt 3) ^ 2) by nra. apply sqrt_pow2. lra.
Qed.

Theorem eta_milankovitch_at_l : eta_milankovitch (sqrt 3 - 1) = eta_l_milankovitch.
Proof. unfold eta_milankovitch, eta_l_milankovitch. rewrite root_of_15_at_l. ring. Qed.

Theorem slope_at_l_milankovitch : is_derive eta_milankovitch (sqrt 3 - 1) (- 4 * sqrt 3).
Proof.
  assert (H := sqrt_3_square). assert (Hb := sqrt_3_bounds). set (A := sqrt 3 - 1).
  assert (Hslope : is_derive eta_milankovitch A (3 - 3 * (6 * A + 4) / (2 * sqrt (3 * (3 * A ^ 2 + 4 * A - 4))))).
  { assert (0 < 3 * (3 * A ^ 2 + 4 * A - 4)) by (unfold A; nra). unfold eta_milankovitch.
    auto_derive; [simpl in *; lra|].
    replace (3 * (3 * (A * (A * 1)) + 4 * A + - (4))) with (3 * (3 * A ^ 2 + 4 * A - 4)) by ring. field.
    apply Rgt_not_eq, sqrt_lt_R0; easy. }
  unfold A in *. rewrite root_of_15_at_l in Hslope.
  replace (- 4 * sqrt 3) with (3 - 3 * (6 * (sqrt 3 - 1) + 4) / (2 * (3 - sqrt 3))); [easy|].
  apply (Rmult_eq_reg_r (2 * (3 - sqrt 3))); [|nonzero].
  transitivity (2 * 3 * (3 - sqrt 3) - 3 * (6 * (sqrt 3 - 1) + 4)); [field; lra | nra].
Qed.

(** At the same thickness [A] is larger for Milankovitch's weight, by at most 1/6. *)
Theorem overturning_weights_apart (eta : R) : -2 < eta ->
  A_overturning 1 eta - A_overturning 0 eta = eta ^ 2 / (6 * (2 + eta)).
Proof. intros H. unfold A_overturning, fac. field. lra. Qed.
