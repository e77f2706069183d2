(** * (2)-(6) follow from the equilibrium of the half arch

    (6) is the centroid of a wedge of the ring. (2) and (4): the line of thrust passes through the extrados of the crown
    and the intrados of the haunch, or the extrados of the shoulder, exactly for the printed thrust; (3) the same for
    the part below the haunch. (5): where the line of thrust is on the intrados it touches it exactly for the printed
    thrust.

    Each theorem names the denominators that must not vanish, and the joints that must carry a normal force; in an arch,
    [0 < eta < 2] and [0 < beta < alpha < PI], the lever arms in (2) and (4) are positive. *)

From Coq Require Export Reals Lra.
From Coquelicot Require Export Coquelicot.
From Couplet Require Export Arch.

(** ** (6): the centroid of a thin wedge *)

(** An integral from a primitive. *)
Lemma integral_of_derivative (F F' : R -> R) (a b I : R) : (forall x, is_derive F x (F' x)) ->
  (forall x, continuous F' x) -> I = F b - F a -> is_RInt F' a b I.
Proof. intros HF HF' ->. apply (is_RInt_derive F F'); auto. Qed.

(** The area of the wedge per unit angle is the thickness, whatever the weight model. *)
Theorem wedge_area (eta : R) : is_RInt (fun rho => rho) (intrados eta) (extrados eta) eta.
Proof.
  apply (integral_of_derivative (fun x => x ^ 2 / 2)); [intros x; auto_derive; [easy | field]
    | intros x; apply continuous_id | unfold extrados, intrados; field].
Qed.

(** The first moment of the wedge about the centre, per unit angle. *)
Theorem wedge_moment (eta : R) : is_RInt (fun rho => rho * rho) (intrados eta) (extrados eta) (eta * fac 1 eta).
Proof.
  apply (integral_of_derivative (fun x => x ^ 3 / 3)).
  - intros x. auto_derive; [easy | field].
  - intros x. apply (continuous_mult (fun y : R => y) (fun y : R => y)); apply continuous_id.
  - unfold extrados, intrados, fac; field.
Qed.

(** (6) for delta_M = 1: the centroid lies at [1 + eta^2/12]. *)
Theorem centroid_of_wedge (eta : R) : eta <> 0 ->
  RInt (fun rho => rho * rho) (intrados eta) (extrados eta)
  / RInt (fun rho => rho) (intrados eta) (extrados eta) = fac 1 eta.
Proof.
  intros Heta. rewrite (is_RInt_unique _ _ _ _ (wedge_moment eta)), (is_RInt_unique _ _ _ _ (wedge_area eta)).
  field; exact Heta.
Qed.

Theorem centroid_on_centreline (eta : R) : fac 0 eta = 1.
Proof. unfold fac; field. Qed.

Theorem centroid_factor_at_least_1 (delta eta : R) : 0 <= delta ->
  1 <= fac delta eta /\ fac delta eta - 1 = delta * eta ^ 2 / 12.
Proof.
  intros Hdelta; unfold fac; split; [|ring].
  assert (0 <= delta * eta ^ 2) by (apply Rmult_le_pos; [easy | apply pow2_ge_0]). lra.
Qed.

(** The moment about the centre of the weight between the crown and [beta]: each slice acts at the
    radius [fac], at the horizontal distance [fac sin theta]. *)
Theorem moment_of_weight (delta eta beta : R) :
  is_RInt (fun theta => fac delta eta * sin theta) 0 beta (fac delta eta * (1 - cos beta)).
Proof.
  apply (integral_of_derivative (fun x => - fac delta eta * cos x)).
  - intros x. auto_derive; [easy | ring].
  - intros x. apply (continuous_scal_r (fac delta eta) sin), continuous_sin.
  - rewrite cos_0; ring.
Qed.

(** (1): the intrinsic thrust [eta h] is [H / (gamma d r^2)], free of the thickness. *)
Theorem intrinsic_thrust (H gamma r t d : R) : gamma <> 0 -> r <> 0 -> t <> 0 -> d <> 0 ->
  let w := gamma * t * d in t / r * (H / (w * r)) = H / (gamma * d * r ^ 2).
Proof. intros Hg Hr Ht Hd w. unfold w. field. auto. Qed.

(** ** Equilibrium of the part above a joint

    On it act the thrust [h] at the radius [crown] of the crown, its weight [beta] with the moment above, and in the
    joint the forces [N] at the radius [rho] and [T] along the radius. *)

Theorem equilibrium_of_upper_part (delta beta eta h crown N T rho : R) : normal_force beta h <> 0 ->
  h - N * cos beta + T * sin beta = 0 /\ N * sin beta + T * cos beta - beta = 0 /\
  h * crown + fac delta eta * (1 - cos beta) - N * rho = 0 <-> N = normal_force beta h /\ T = shear_force beta h /\
  rho = pressure_point delta beta eta h crown.
Proof.
  intros HN. assert (Hcircle := sin2_cos2 beta); unfold Rsqr in Hcircle. split.
  - intros (Hx & Hy & Hm). assert (Hforces : N = normal_force beta h /\ T = shear_force beta h).
    { unfold normal_force, shear_force. revert Hx Hy Hcircle. generalize (sin beta) (cos beta).
      intros s c Hx Hy Hcircle. replace h with (N * c - T * s) by lra. replace beta with (N * s + T * c) by lra.
      split; [transitivity (N * (s * s + c * c)); [rewrite Hcircle|]; ring
        | transitivity (T * (s * s + c * c)); [rewrite Hcircle|]; ring]. }
    destruct Hforces as [EN ET]. repeat split; [easy | easy |]. unfold pressure_point. rewrite <- EN in HN |- *.
    apply (Rmult_eq_reg_l N); [|easy]. field_simplify; [lra | easy].
  - intros (-> & -> & ->). unfold pressure_point. repeat split.
    + unfold normal_force, shear_force.
      transitivity (h - h * (sin beta * sin beta + cos beta * cos beta)); [|rewrite Hcircle]; ring.
    + unfold normal_force, shear_force.
      transitivity (beta * (sin beta * sin beta + cos beta * cos beta) - beta); [|rewrite Hcircle]; ring.
    + field; exact HN.
Qed.

(** ** Denominators that vanish nowhere in the arch *)

Lemma lever_of_lower_thrust_positive (beta eta : R) : 0 < eta -> 0 < 2 + eta - (2 - eta) * cos beta.
Proof. intros Heta. destruct (COS_bound beta). nra. Qed.

Lemma versine_positive (alpha : R) : 0 < alpha < 2 * PI -> 0 < 1 - cos alpha.
Proof.
  intros [H0 H1]. replace alpha with (2 * (alpha / 2)) by field. rewrite cos_2a_sin.
  assert (0 < sin (alpha / 2)) by (apply sin_gt_0; lra). nra.
Qed.

(** A product, a quotient or a power of what is, a sine, a cosine or a versine in its range. *)
Ltac positive := first [
  match goal with
  | |- 0 < _ * _ => apply Rmult_lt_0_compat
  | |- 0 <= _ * _ => apply Rmult_le_pos
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat
  | |- 0 <= _ / _ => apply Rdiv_le_0_compat
  | |- 0 < _ ^ _ => apply pow_lt
  | |- 0 <= _ ^ 2 => apply pow2_ge_0
  | |- 0 < sin _ => apply sin_gt_0
  | |- 0 <= sin _ => apply sin_ge_0
  | |- 0 < cos _ => apply cos_gt_0
  | |- 0 <= cos _ => apply cos_ge_0
  | |- 0 < 1 - cos _ => apply versine_positive
  | |- _ <> 0 => apply not_eq_sym, Rlt_not_eq
  end; positive | lra | unfold intrados, extrados; lra | nra ].

(** ** Clearing denominators *)

Lemma equals_quotient (x n d : R) : d <> 0 -> x = n / d <-> x * d = n.
Proof. intros Hd. split; [intros -> | intros <-]; field; exact Hd. Qed.

Lemma quotient_equals (x n d : R) : d <> 0 -> n / d = x <-> n = x * d.
Proof. intros Hd. split; [intros <- | intros ->]; field; exact Hd. Qed.

(** (2), (3), (4), (5) without denominators. *)
Lemma lower_thrust_cleared (delta beta eta h : R) : 2 + eta - (2 - eta) * cos beta <> 0 ->
  h = h_lower delta beta eta <->
  h * (2 + eta - (2 - eta) * cos beta) = (2 - eta) * beta * sin beta - 2 * (1 - cos beta) * fac delta eta.
Proof. exact (equals_quotient _ _ _). Qed.

Lemma upper_thrust_cleared (delta alpha beta eta h : R) : (2 - eta) * cos beta - (2 + eta) * cos alpha <> 0 ->
  h = h_upper delta alpha beta eta <->
  h * ((2 - eta) * cos beta - (2 + eta) * cos alpha)
  = (2 + eta) * alpha * sin alpha - (2 - eta) * beta * sin beta
    - 2 * (cos beta - cos alpha) * fac delta eta.
Proof. exact (equals_quotient _ _ _). Qed.

Lemma whole_thrust_cleared (delta alpha eta h : R) : 1 - cos alpha <> 0 -> 2 + eta <> 0 ->
  h = h_whole delta alpha eta <->
  h * ((1 - cos alpha) * (2 + eta)) = (2 + eta) * alpha * sin alpha - 2 * (1 - cos alpha) * fac delta eta.
Proof.
  intros HA He.
  replace (h_whole delta alpha eta) with (((2 + eta) * alpha * sin alpha - 2 * (1 - cos alpha) * fac delta eta) /
    ((1 - cos alpha) * (2 + eta))) by (unfold h_whole, A; field; auto). apply equals_quotient.
  now apply Rmult_integral_contrapositive.
Qed.

Lemma tangency_cleared (delta beta eta h : R) : sin beta <> 0 -> 2 - eta <> 0 -> h = h_tangency delta beta eta <->
  h * (sin beta * (2 - eta)) = (2 - eta) * (sin beta + beta * cos beta) - 2 * sin beta * fac delta eta.
Proof.
  intros HS He.
  replace (h_tangency delta beta eta) with (((2 - eta) * (sin beta + beta * cos beta) - 2 * sin beta * fac delta eta)
    / (sin beta * (2 - eta))) by (unfold h_tangency, cot; field; auto). apply equals_quotient.
  now apply Rmult_integral_contrapositive.
Qed.

(** ** (2), (3), (4): where the line of thrust is *)

(** (2): thrust at the crown's extrados, line of thrust at the haunch's intrados. *)
Theorem lower_thrust_from_moments (delta beta eta h : R) :
  normal_force beta h <> 0 -> 2 + eta - (2 - eta) * cos beta <> 0 ->
  pressure_point delta beta eta h (extrados eta) = intrados eta <-> h = h_lower delta beta eta.
Proof.
  intros HN HD. rewrite (lower_thrust_cleared _ _ _ _ HD). unfold pressure_point. rewrite (quotient_equals _ _ _ HN).
  unfold normal_force, intrados, extrados. split; lra.
Qed.

(** (4): thrust at the crown's extrados, line of thrust at the shoulder's extrados. *)
Theorem whole_thrust_from_moments (delta alpha eta h : R) : normal_force alpha h <> 0 -> 1 - cos alpha <> 0 ->
  2 + eta <> 0 -> pressure_point delta alpha eta h (extrados eta) = extrados eta <-> h = h_whole delta alpha eta.
Proof.
  intros HN HA He. rewrite (whole_thrust_cleared _ _ _ _ HA He). unfold pressure_point.
  rewrite (quotient_equals _ _ _ HN). unfold normal_force, extrados. split; lra.
Qed.

(** (3): line of thrust at the shoulder's extrados and at the haunch's intrados, wherever it is at the crown. *)
Theorem upper_thrust_from_moments (delta alpha beta eta h crown : R) : normal_force alpha h <> 0 ->
  normal_force beta h <> 0 -> (2 - eta) * cos beta - (2 + eta) * cos alpha <> 0 ->
  pressure_point delta alpha eta h crown = extrados eta ->
  pressure_point delta beta eta h crown = intrados eta <-> h = h_upper delta alpha beta eta.
Proof.
  intros Ha Hb HD. rewrite (upper_thrust_cleared _ _ _ _ _ HD). unfold pressure_point.
  rewrite (quotient_equals _ _ _ Ha), (quotient_equals _ _ _ Hb). unfold normal_force, intrados, extrados. split; lra.
Qed.

(** The three equations are linear in the thrust. *)
Ltac clear_thrusts :=
  intros HL HA He HU; rewrite (lower_thrust_cleared _ _ _ _ HL), (whole_thrust_cleared _ _ _ _ HA He),
    (upper_thrust_cleared _ _ _ _ _ HU); lra.

(** (2) and (4) imply (3), for any weight and even where a joint carries no normal force. *)
Theorem lower_and_whole_imply_upper (delta alpha beta eta h : R) : 2 + eta - (2 - eta) * cos beta <> 0 ->
  1 - cos alpha <> 0 -> 2 + eta <> 0 -> (2 - eta) * cos beta - (2 + eta) * cos alpha <> 0 ->
  h = h_lower delta beta eta -> h = h_whole delta alpha eta -> h = h_upper delta alpha beta eta.
Proof. clear_thrusts. Qed.

(** (3) and (4) imply (2). *)
Theorem upper_and_whole_imply_lower (delta alpha beta eta h : R) : 2 + eta - (2 - eta) * cos beta <> 0 ->
  1 - cos alpha <> 0 -> 2 + eta <> 0 -> (2 - eta) * cos beta - (2 + eta) * cos alpha <> 0 ->
  h = h_upper delta alpha beta eta -> h = h_whole delta alpha eta -> h = h_lower delta beta eta.
Proof. clear_thrusts. Qed.

(** (2) and (3) imply (4). *)
Theorem lower_and_upper_imply_whole (delta alpha beta eta h : R) : 2 + eta - (2 - eta) * cos beta <> 0 ->
  1 - cos alpha <> 0 -> 2 + eta <> 0 -> (2 - eta) * cos beta - (2 + eta) * cos alpha <> 0 ->
  h = h_lower delta beta eta -> h = h_upper delta alpha beta eta -> h = h_whole delta alpha eta.
Proof. clear_thrusts. Qed.

(** ** (5): tangency *)

(** The derivative of the line of thrust along the arch. *)
Lemma derivative_of_pressure_point (delta beta eta h crown : R) : normal_force beta h <> 0 ->
  is_derive (fun b => pressure_point delta b eta h crown) beta
    ((fac delta eta * sin beta
       - pressure_point delta beta eta h crown * (sin beta * (1 - h) + beta * cos beta))
     / normal_force beta h).
Proof. unfold pressure_point, normal_force. intros HN. auto_derive; [easy|]. field; exact HN. Qed.

(** (5): a line of thrust at the intrados touches it exactly for the printed thrust. *)
Theorem tangency_from_derivative (delta beta eta h crown : R) : normal_force beta h <> 0 -> sin beta <> 0 ->
  2 - eta <> 0 -> pressure_point delta beta eta h crown = intrados eta ->
  is_derive (fun b => pressure_point delta b eta h crown) beta 0 <-> h = h_tangency delta beta eta.
Proof.
  intros HN HS He Hin. rewrite (tangency_cleared _ _ _ _ HS He).
  pose proof (derivative_of_pressure_point delta beta eta h crown HN) as Hslope. rewrite Hin in Hslope.
  unfold intrados in *. set (slope := _ / normal_force beta h) in Hslope. transitivity (slope = 0).
  - split; [intros H | now intros <-]. rewrite <- (is_derive_unique _ _ _ H). symmetry. now apply is_derive_unique.
  - unfold slope. rewrite (quotient_equals _ _ _ HN). split; lra.
Qed.

(** ** Printed forms that are the same *)

(** (4): [alpha sin alpha / (1 - cos alpha) = alpha cot (alpha/2)]. *)
Theorem A_half_angle_form (alpha : R) : sin (alpha / 2) <> 0 -> A alpha = A_half_angle alpha.
Proof.
  intros HS. unfold A, A_half_angle, cot.
  replace (sin alpha) with (2 * sin (alpha / 2) * cos (alpha / 2)) by (rewrite <- sin_2a; f_equal; field).
  replace (1 - cos alpha) with (2 * sin (alpha / 2) * sin (alpha / 2)).
  2: { replace (cos alpha) with (1 - 2 * sin (alpha / 2) * sin (alpha / 2));
         [ring | rewrite <- cos_2a_sin; f_equal; field]. }
  field. exact HS.
Qed.

(** (5): both forms; the second one needs [eta <> 0]. *)
Theorem tangency_second_form (delta beta eta : R) : 2 - eta <> 0 -> eta <> 0 ->
  h_tangency delta beta eta = h_tangency_second delta beta eta.
Proof. unfold h_tangency, h_tangency_second, fac. intros; field. split; assumption. Qed.

(** Heyman's [beta cot beta] is what is left of (5) in a thin arch, with either weight. *)
Theorem tangency_of_thin_arch (delta beta : R) : h_tangency delta beta 0 = beta * cot beta.
Proof. unfold h_tangency, fac; field. Qed.

(** ** The caption of Fig. 1: [r] is not the inner radius

    With the inner radius [r] the ring lies between [r] and [r (1 + eta)], and its centreline has the
    radius [r (1 + eta/2)], in units of which its thickness is [eta / (1 + eta/2)]. *)
Theorem centroid_with_inner_radius (eta : R) : 0 < eta <= 2 ->
  (1 + eta / 2) * fac 1 (eta / (1 + eta / 2)) <> fac 1 eta.
Proof.
  intros H E. assert (P : 0 < eta * (12 + 6 * eta - eta ^ 2)) by nra.
  assert (D : (1 + eta / 2) * fac 1 (eta / (1 + eta / 2)) - fac 1 eta
    = eta * (12 + 6 * eta - eta ^ 2) / (24 * (1 + eta / 2))) by (unfold fac; field; lra).
  assert (0 < eta * (12 + 6 * eta - eta ^ 2) / (24 * (1 + eta / 2))) by positive. lra.
Qed.
