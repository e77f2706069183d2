(** * The equation of the widest rotational joint

    An equation of a landmark that is not printed: its form without denominators, and that the radicand (12) vanishes
    where it holds. *)

From Couplet Require Import Moments Cubics.

(** At the widest rotational joint the thickness is a double root of (2) = (5): there the difference
    of the two thrusts has slope zero besides. *)
Definition double_thickness (delta beta eta : R) : Prop :=
  is_derive (fun e => h_lower delta beta e - h_tangency delta beta e) eta 0.

(** With [D / K] for the difference of (2) and (5), its slope is [D' / K] where [D] vanishes. *)
Lemma cleared_double_thickness delta beta eta r :
  2 + eta - (2 - eta) * cos beta <> 0 -> sin beta <> 0 -> 2 - eta <> 0 ->
  h_lower delta beta eta = h_tangency delta beta eta ->
  r = sin beta * ((- beta * sin beta - 2 * (1 - cos beta) * (delta * eta / 6)) * (2 - eta)
                  - ((2 - eta) * beta * sin beta - 2 * (1 - cos beta) * fac delta eta))
      - ((- (beta * cos beta + sin beta) - 2 * (delta * eta / 6) * sin beta)
           * (2 + eta - (2 - eta) * cos beta)
         + ((beta * cos beta + sin beta) * (2 - eta) - 2 * fac delta eta * sin beta)
           * (1 + cos beta)) ->
  (double_thickness delta beta eta <-> r = 0).
Proof.
  intros Hd Hs He H0 Hr. unfold double_thickness. set (K := sin beta * (2 - eta) * (2 + eta - (2 - eta) * cos beta)).
  set (K' := sin beta * (- (2 + eta - (2 - eta) * cos beta) + (2 - eta) * (1 + cos beta))).
  assert (HK : K <> 0) by (now repeat apply Rmult_integral_contrapositive_currified).
  assert (slope : is_derive (fun e => h_lower delta beta e - h_tangency delta beta e) eta
                    (r / K - (h_lower delta beta eta - h_tangency delta beta eta) * (K' / K))).
  { rewrite Hr. unfold K, K', h_lower, h_tangency, fac, cot.
    auto_derive; [repeat split; assumption | field; repeat split; assumption]. }
  rewrite H0 in slope.
  replace (r / K - (h_tangency delta beta eta - h_tangency delta beta eta) * (K' / K))
    with (r / K) in slope by (field; exact HK). split.
  - intros H. apply is_derive_unique in H. apply is_derive_unique in slope. rewrite slope in H.
    apply (Rmult_eq_compat_r K) in H. replace (r / K * K) with r in H by (field; exact HK). lra.
  - intros H. replace 0 with (r / K); [exact slope |]. rewrite H. field. exact HK.
Qed.

(** There the radicand (12) vanishes: a double root has no discriminant. *)
Theorem radicand_at_double_thickness delta beta eta : 2 + eta - (2 - eta) * cos beta <> 0 -> sin beta <> 0 ->
  2 - eta <> 0 -> h_lower delta beta eta = h_tangency delta beta eta -> double_thickness delta beta eta ->
  radicand delta (f_of beta) (g_of beta) (sin beta) = 0.
Proof.
  intros Hd Hs He H0 H1. apply (cleared_double_thickness _ _ _ _ Hd Hs He H0 eq_refl) in H1.
  apply (cubic_in_thickness_from_2_5 _ _ _ Hs He Hd) in H0. unfold pol_eta in H0. set (f := f_of beta) in *.
  set (g := g_of beta) in *. set (S := sin beta) in *. set (a := delta * S). set (b := 3 * (f + g)).
  set (c := - 12 * (g - S)). set (d := 12 * (g - f)). assert (slope : 3 * a * eta ^ 2 + 2 * b * eta + c = 0).
  { apply (f_equal (Rmult 3)) in H1. rewrite Rmult_0_r in H1. rewrite <- H1. unfold a, b, c, f, g, f_of, g_of, fac.
    fold S. assert (circle : S ^ 2 = 1 - cos beta ^ 2) by (pose proof (circle beta) as H; fold S in H; lra).
    field [circle]. }
  assert (linear : c = - (3 * a * eta ^ 2 + 2 * b * eta)) by lra.
  assert (constant : d = 2 * a * eta ^ 3 + b * eta ^ 2).
  { unfold d. assert (H : a * eta ^ 3 + b * eta ^ 2 + c * eta + d = 0) by (unfold a, b, c, d; lra).
    rewrite linear in H. unfold d in H. lra. }
  assert (none : discriminant a b c d = 0) by (unfold discriminant; rewrite linear, constant; ring).
  unfold a, b, c, d in none. rewrite discriminant_in_thickness in none. lra.
Qed.
