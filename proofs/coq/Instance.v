(** * From the printed equations to a table of numbers

    What the generated files share.  Each of them states printed equations of [Arch], clears their
    denominators to get functions that [Contraction] can work with, and gives a table of numbers.  Here
    is what does not depend on the numbers: for each printed equation, that it holds exactly where its
    cleared form vanishes as long as no denominator does; and the tactics that check a table.

    Nothing the generator prints is trusted except the statements of its theorems. *)

From Coq Require Export Reals List Lra Lia.
From Coquelicot Require Export Coquelicot.
From Couplet Require Export Arch Moments Cubics Overturning IntervalZ OneRoot Contraction.
Export ListNotations.
Open Scope R_scope.

(** ** An equation of the landmarks that is not printed

    At the widest rotational joint the thickness is a double root of (2) = (5): there the difference
    of the two thrusts has slope zero besides. *)
Definition double_thickness (delta beta eta : R) : Prop :=
  is_derive (fun e => h_lower delta beta e - h_tangency delta beta e) eta 0.

(** ** The printed equations and their cleared forms

    In [Moments] and [Sliding] a cleared equation reads [h * d = n]; here it reads [r = 0] with any
    way of writing [d * h - n]. *)

Ltac cleared_by equation Hr := rewrite equation by easy; rewrite Hr; split; intros; lra.

Lemma cleared_lower delta beta eta h r :
  2 + eta - (2 - eta) * cos beta <> 0 ->
  r = (2 + eta - (2 - eta) * cos beta) * h
      - ((2 - eta) * beta * sin beta - 2 * (1 - cos beta) * fac delta eta) ->
  (h = h_lower delta beta eta <-> r = 0).
Proof. intros Hd Hr. cleared_by lower_thrust_cleared Hr. Qed.

Lemma cleared_upper delta alpha beta eta h r :
  (2 - eta) * cos beta - (2 + eta) * cos alpha <> 0 ->
  r = ((2 - eta) * cos beta - (2 + eta) * cos alpha) * h
      - ((2 + eta) * alpha * sin alpha - (2 - eta) * beta * sin beta
         - 2 * (cos beta - cos alpha) * fac delta eta) ->
  (h = h_upper delta alpha beta eta <-> r = 0).
Proof. intros Hd Hr. cleared_by upper_thrust_cleared Hr. Qed.

Lemma cleared_whole delta alpha eta h r :
  1 - cos alpha <> 0 -> 2 + eta <> 0 ->
  r = (1 - cos alpha) * (2 + eta) * h
      - ((2 + eta) * alpha * sin alpha - 2 * (1 - cos alpha) * fac delta eta) ->
  (h = h_whole delta alpha eta <-> r = 0).
Proof. intros Ha He Hr. cleared_by whole_thrust_cleared Hr. Qed.

Lemma cleared_tangency delta beta eta h r :
  sin beta <> 0 -> 2 - eta <> 0 ->
  r = sin beta * (2 - eta) * h
      - ((2 - eta) * (sin beta + beta * cos beta) - 2 * sin beta * fac delta eta) ->
  (h = h_tangency delta beta eta <-> r = 0).
Proof. intros Hs He Hr. cleared_by tangency_cleared Hr. Qed.

(** (5) in the limit [beta -> 0] is [h = end_of_rotation], by [tangency_at_crown]. *)
Lemma cleared_tangency_at_crown delta eta h r :
  2 - eta <> 0 ->
  r = (2 - eta) * h - (2 * (2 - eta) - 2 * fac delta eta) ->
  (h = end_of_rotation delta eta <-> r = 0).
Proof.
  intros He Hr.
  replace (end_of_rotation delta eta) with ((2 * (2 - eta) - 2 * fac delta eta) / (2 - eta))
    by (unfold end_of_rotation, fac; field; easy).
  cleared_by (equals_quotient h (2 * (2 - eta) - 2 * fac delta eta) (2 - eta)) Hr.
Qed.

Lemma cleared_shoulder_sliding alpha h mu r :
  h * cos alpha + alpha * sin alpha <> 0 ->
  r = (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha) ->
  (mu = mu_ss alpha h <-> r = 0).
Proof. intros Hd Hr. unfold mu_ss. cleared_by equals_quotient Hr. Qed.

(** (18) is two equations, the joint and the friction there; the first has a square root. *)
Lemma cleared_inner_sliding beta h mu r s :
  0 < beta -> (1 - h) * sin beta + beta * cos beta <> 0 ->
  r = ((1 - h) * sin beta + beta * cos beta) * mu - ((1 - h) * cos beta - beta * sin beta) ->
  s = beta ^ 2 - (1 - h) * h ->
  (mu = mu_is h /\ beta = beta_s h <-> r = 0 /\ s = 0).
Proof.
  intros Hbeta Hd Hr Hs.
  assert (joint : beta = beta_s h <-> s = 0).
  { rewrite Hs. unfold beta_s. split.
    - intros H. assert (0 < h * (1 - h)) by (apply sqrt_lt_0_alt; rewrite sqrt_0; lra).
      rewrite H, pow2_sqrt by lra. ring.
    - intros H. replace (h * (1 - h)) with (beta ^ 2) by lra. now rewrite sqrt_pow2 by lra. }
  assert (friction : mu = mu_inner beta h <-> r = 0)
    by (unfold mu_inner; cleared_by equals_quotient Hr).
  rewrite <- joint, <- friction. unfold mu_is.
  split; intros [H Hj]; (split; [| exact Hj]); rewrite <- Hj in *; exact H.
Qed.

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
  intros Hd Hs He H0 Hr. unfold double_thickness.
  set (K := sin beta * (2 - eta) * (2 + eta - (2 - eta) * cos beta)).
  set (K' := sin beta * (- (2 + eta - (2 - eta) * cos beta) + (2 - eta) * (1 + cos beta))).
  assert (HK : K <> 0) by (now repeat apply Rmult_integral_contrapositive_currified).
  assert (slope : is_derive (fun e => h_lower delta beta e - h_tangency delta beta e) eta
                    (r / K - (h_lower delta beta eta - h_tangency delta beta eta) * (K' / K))).
  { rewrite Hr. unfold K, K', h_lower, h_tangency, fac, cot.
    auto_derive; [repeat split; assumption | field; repeat split; assumption]. }
  rewrite H0 in slope.
  replace (r / K - (h_tangency delta beta eta - h_tangency delta beta eta) * (K' / K))
    with (r / K) in slope by (field; exact HK).
  split.
  - intros H. apply is_derive_unique in H. apply is_derive_unique in slope.
    rewrite slope in H. apply (Rmult_eq_compat_r K) in H.
    replace (r / K * K) with r in H by (field; exact HK). lra.
  - intros H. replace 0 with (r / K); [exact slope |]. rewrite H. field. exact HK.
Qed.

(** There the radicand (12) vanishes: a double root has no discriminant. *)
Theorem radicand_at_double_thickness delta beta eta :
  2 + eta - (2 - eta) * cos beta <> 0 -> sin beta <> 0 -> 2 - eta <> 0 ->
  h_lower delta beta eta = h_tangency delta beta eta -> double_thickness delta beta eta ->
  radicand delta (f_of beta) (g_of beta) (sin beta) = 0.
Proof.
  intros Hd Hs He H0 H1.
  apply (cleared_double_thickness _ _ _ _ Hd Hs He H0 eq_refl) in H1.
  apply (cubic_in_thickness_from_2_5 _ _ _ Hs He Hd) in H0. unfold pol_eta in H0.
  set (f := f_of beta) in *. set (g := g_of beta) in *. set (S := sin beta) in *.
  set (a := delta * S). set (b := 3 * (f + g)).
  set (c := - 12 * (g - S)). set (d := 12 * (g - f)).
  assert (slope : 3 * a * eta ^ 2 + 2 * b * eta + c = 0).
  { apply (f_equal (Rmult 3)) in H1. rewrite Rmult_0_r in H1. rewrite <- H1.
    unfold a, b, c, f, g, f_of, g_of, fac. fold S.
    assert (circle : S ^ 2 = 1 - cos beta ^ 2)
      by (pose proof (circle beta) as H; fold S in H; lra).
    field [circle]. }
  assert (linear : c = - (3 * a * eta ^ 2 + 2 * b * eta)) by lra.
  assert (constant : d = 2 * a * eta ^ 3 + b * eta ^ 2).
  { unfold d. assert (H : a * eta ^ 3 + b * eta ^ 2 + c * eta + d = 0)
      by (unfold a, b, c, d; lra). rewrite linear in H. unfold d in H. lra. }
  assert (none : discriminant a b c d = 0)
    by (unfold discriminant; rewrite linear, constant; ring).
  unfold a, b, c, d in none. rewrite discriminant_in_thickness in none. lra.
Qed.

(** An equation whose cleared form may need those before it. *)
Lemma both_under (P P' Q Q' : Prop) : (P <-> P') -> (P -> (Q <-> Q')) -> (P /\ Q <-> P' /\ Q').
Proof. tauto. Qed.

(** ** Lists as points and matrices *)

Definition entry (l : list R) (i : nat) : R := nth i l 0.
Definition entries (m : list (list R)) (i k : nat) : R := nth k (nth i m []) 0.

(** All numbers of a list are zero. *)
Fixpoint vanish (l : list R) : Prop :=
  match l with
  | [] => True
  | [x] => x = 0
  | x :: rest => x = 0 /\ vanish rest
  end.

Lemma vanish_entries (l : list R) :
  vanish l <-> forall j, (j < length l)%nat -> entry l j = 0.
Proof.
  induction l as [| x rest IH]; [split; [simpl; lia | easy] |].
  assert (step : vanish (x :: rest) <-> x = 0 /\ vanish rest) by (destruct rest; simpl; tauto).
  rewrite step, IH. unfold entry. split.
  - intros [Hx Hrest] [| j] Hj; [exact Hx | apply (Hrest j)]. simpl in Hj. lia.
  - intros H. split; [apply (H 0%nat); simpl; lia |].
    intros j Hj. apply (H (S j)). simpl. lia.
Qed.

Lemma bounds {n r x c} : within n r 1 x c -> forall i, (i < n)%nat ->
  c i - r i <= x i <= c i + r i.
Proof. intros H i Hi. specialize (H i Hi). apply Rabs_le_between' in H. lra. Qed.

(** ** Tactics *)

(** A goal about an index [i < n], for each index. *)
Ltac each i tac := first [exfalso; lia | destruct i as [| i]; [tac | each i tac]].

(** Hypotheses taken apart and made into bounds. *)
Ltac conjuncts :=
  repeat match goal with
    | H : _ /\ _ |- _ => destruct H
    | H : Rabs (_ - _) <= _ |- _ => apply Rabs_le_between' in H
    end.

(** A printed value against the digits. *)
Ltac compare := conjuncts; unfold A; interval with (i_prec 90).

(** An inequality between numbers; few bits are enough unless the half opening is small. *)
Ltac arithmetic := first [interval with (i_prec 53) | interval with (i_prec 300)].

(** A bound of a slope; many slopes are constant. *)
Ltac slope :=
  first [rewrite Rminus_eq_0, Rabs_R0; apply Rle_refl | arithmetic].

(** What the lemmas on cleared forms leave to show. *)
Ltac clearing :=
  match goal with
  | |- _ <> _ => arithmetic
  | |- 0 < _ => lra
  | |- h_lower _ _ _ = h_tangency _ _ _ => congruence
  | |- _ => unfold fac; rewrite ?sin_0, ?cos_0; field
  end.

(** A coordinate of the root to its digits, from [Hx], that it lies in the small box. *)
Ltac digits Hx reduce :=
  match goal with
  | |- Rabs (?x ?k - _) <= _ =>
      eapply Rle_trans; [apply (Hx k); lia | reduce; arithmetic]
  end.

(** A coordinate in the wide box. *)
Ltac inside := apply Rabs_le; lra.

Ltac narrow_to_wide narrow wide := unfold narrow, wide; intros; conjuncts; lra.

(** ** One unknown, in the widest bracket *)

(** [A] takes a value once. *)
Theorem half_opening v lo hi :
  0 < lo -> lo < hi -> hi < 2 * PI -> v < A lo -> A hi < v ->
  exists alpha, lo < alpha < hi /\ A alpha = v /\
    (forall other, 0 < other < 2 * PI -> A other = v -> other = alpha).
Proof.
  intros H0 Hlohi Hpi Hlo Hhi.
  assert (between : forall x, lo <= x <= hi -> 0 < 1 - cos x) by (intros; apply versine_positive; lra).
  destruct (one_root_decreasing (fun x => A x - v) (fun x => - (x - sin x) / (1 - cos x)) lo hi)
    with (a := lo) (b := hi) as [alpha [Halpha [Hroot _]]]; try lra.
  - intros x Hx. specialize (between x Hx).
    evar_last; [apply @is_derive_minus; [apply derivative_of_A; lra | apply @is_derive_const] |].
    apply Rminus_0_r.
  - intros x Hx. specialize (between x Hx). assert (sin x < x) by (apply sin_lt_x; lra).
    assert (0 < (x - sin x) / (1 - cos x)) by (apply Rdiv_lt_0_compat; lra). lra.
  - exists alpha. split; [lra | split; [lra |]].
    intros other Hother Hv. apply A_injective; [exact Hother | lra | lra].
Qed.

(** The radicand (12) at a joint. *)
Definition radicand_at (delta beta : R) : R := radicand delta (f_of beta) (g_of beta) (sin beta).

(** One root where it rises, none before and behind. *)
Theorem one_joint delta slope first rise top last a b :
  first <= rise -> rise <= a -> a < b -> b <= top -> top <= last ->
  (forall x, first <= x <= rise -> radicand_at delta x < 0) ->
  (forall x, is_derive (radicand_at delta) x (slope x)) ->
  (forall x, rise <= x <= top -> 0 < slope x) ->
  (forall x, top <= x <= last -> 0 < radicand_at delta x) ->
  radicand_at delta a < 0 -> 0 < radicand_at delta b ->
  exists beta, a < beta < b /\ radicand_at delta beta = 0 /\
    (forall other, first <= other <= last -> radicand_at delta other = 0 -> other = beta).
Proof.
  intros H1 H2 H3 H4 H5 before Hslope rising behind Ha Hb.
  destruct (one_root_increasing (radicand_at delta) slope rise top) with (a := a) (b := b)
    as [beta [Hbeta [Hroot Hunique]]]; auto.
  exists beta. split; [exact Hbeta | split; [exact Hroot |]]. intros other Hother Hzero.
  destruct (Rlt_or_le other rise) as [Hr | Hr]; [specialize (before other); lra |].
  destruct (Rlt_or_le top other) as [Ht | Ht]; [specialize (behind other); lra |].
  apply Hunique; [lra | exact Hzero].
Qed.

(** ** The ends of rotation and of overturning in closed form *)

Lemma rotation_end_heyman alpha eta : 0 <= eta < 2 ->
  (0 = h_whole 0 alpha eta /\ 0 = end_of_rotation 0 eta <-> eta = 1 /\ A alpha = 2 / 3).
Proof.
  intros He. pose proof (end_of_rotation_heyman eta ltac:(lra)) as thickness.
  pose proof (overturning_from_whole_thrust 0 alpha eta) as opening.
  pose proof A_l_heyman. pose proof (A_heyman_from_13 1).
  split; intros [H1 H2].
  - assert (eta = 1) as -> by (apply thickness; lra).
    split; [easy |]. rewrite (proj1 opening); lra.
  - subst. split; symmetry; [apply opening; lra | now apply thickness].
Qed.

Lemma rotation_end_milankovitch alpha eta : 0 <= eta < 2 ->
  (0 = h_whole 1 alpha eta /\ 0 = end_of_rotation 1 eta
   <-> eta = eta_l_milankovitch /\ A alpha = sqrt 3 - 1).
Proof.
  intros He. pose proof (end_of_rotation_milankovitch eta ltac:(lra) ltac:(lra)) as thickness.
  pose proof (overturning_from_whole_thrust 1 alpha eta) as opening.
  pose proof A_l_milankovitch. pose proof (A_milankovitch_from_13 eta ltac:(lra)).
  split; intros [H1 H2].
  - assert (eta = eta_l_milankovitch) as -> by (apply thickness; lra).
    split; [easy |]. rewrite (proj1 opening); lra.
  - subst. split; symmetry; [apply opening; lra | now apply thickness].
Qed.

Lemma overturning_end_heyman alpha : 0 = h_whole 0 alpha 2 <-> A alpha = 1 / 2.
Proof.
  pose proof (overturning_from_whole_thrust 0 alpha 2) as opening.
  pose proof A_L_heyman. pose proof (A_heyman_from_13 2).
  split; intros; [rewrite (proj1 opening) | symmetry; apply opening]; lra.
Qed.

Lemma overturning_end_milankovitch alpha : 0 = h_whole 1 alpha 2 <-> A alpha = 2 / 3.
Proof.
  pose proof (overturning_from_whole_thrust 1 alpha 2) as opening.
  pose proof A_L_milankovitch. pose proof (A_milankovitch_from_13 2 ltac:(lra)).
  split; intros; [rewrite (proj1 opening) | symmetry; apply opening]; lra.
Qed.
