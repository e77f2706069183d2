(** * From the printed equations to a table of numbers

    What the generated files share.  Each of them states printed equations of [Arch], clears their
    denominators to get functions that [Contraction] can work with, and gives a table of numbers.  Here
    is what does not depend on the numbers: for each printed equation, that it holds exactly where its
    cleared form vanishes as long as no denominator does; and the tactics that check a table.

    Nothing the generator prints is trusted except the statements of its theorems. *)

From Coq Require Export Reals List Lra Lia.
From Coquelicot Require Export Coquelicot.
From Couplet Require Export Arch IntervalZ OneRoot Contraction.
Export ListNotations.
Open Scope R_scope.

(** ** Two equations of the landmarks that [Arch] does not have *)

(** (5) in the limit [beta -> 0], where [beta * cot beta] tends to 1. *)
Definition h_tangency_crown (delta eta : R) : R := 2 - 2 / (2 - eta) * fac delta eta.

Lemma h_tangency_crown_is_the_limit delta eta :
  is_lim (fun beta => h_tangency delta beta eta) 0 (h_tangency_crown delta eta).
Proof.
  apply is_lim_ext with
    (fun beta => / (sin beta / beta) * cos beta + (1 - 2 / (2 - eta) * fac delta eta)).
  { intros beta. unfold h_tangency, cot, Rdiv. rewrite Rinv_mult, Rinv_inv. ring. }
  replace (Finite (h_tangency_crown delta eta))
    with (Finite (/ 1 * cos 0 + (1 - 2 / (2 - eta) * fac delta eta)))
    by (unfold h_tangency_crown; rewrite cos_0, Rinv_1; f_equal; ring).
  apply is_lim_plus'; [| apply is_lim_const].
  apply (is_lim_mult _ _ 0 (/ 1) (cos 0)); [| | easy].
  - apply (is_lim_inv _ 0 1); [exact is_lim_sinc_0 |]. injection. lra.
  - apply is_lim_continuity, continuity_cos.
Qed.

(** At the widest rotational joint the thickness is a double root of (2) = (5): there the difference
    of the two thrusts has slope zero besides. *)
Definition double_thickness (delta beta eta : R) : Prop :=
  is_derive (fun e => h_lower delta beta e - h_tangency delta beta e) eta 0.

(** ** The printed equations and their cleared forms *)

Lemma cleared (x n d r : R) : d <> 0 -> r = d * x - n -> (x = n / d <-> r = 0).
Proof.
  intros Hd ->. split.
  - intros ->. field. exact Hd.
  - intros H. apply (Rmult_eq_reg_l d); [| exact Hd].
    replace (d * (n / d)) with n by (field; exact Hd). lra.
Qed.

Lemma cleared_lower delta beta eta h r :
  2 + eta - (2 - eta) * cos beta <> 0 ->
  r = (2 + eta - (2 - eta) * cos beta) * h
      - ((2 - eta) * beta * sin beta - 2 * (1 - cos beta) * fac delta eta) ->
  (h = h_lower delta beta eta <-> r = 0).
Proof. apply cleared. Qed.

Lemma cleared_upper delta alpha beta eta h r :
  (2 - eta) * cos beta - (2 + eta) * cos alpha <> 0 ->
  r = ((2 - eta) * cos beta - (2 + eta) * cos alpha) * h
      - ((2 + eta) * alpha * sin alpha - (2 - eta) * beta * sin beta
         - 2 * (cos beta - cos alpha) * fac delta eta) ->
  (h = h_upper delta alpha beta eta <-> r = 0).
Proof. apply cleared. Qed.

Lemma cleared_whole delta alpha eta h r :
  1 - cos alpha <> 0 -> 2 + eta <> 0 ->
  r = (1 - cos alpha) * (2 + eta) * h
      - ((2 + eta) * alpha * sin alpha - 2 * fac delta eta * (1 - cos alpha)) ->
  (h = h_whole delta alpha eta <-> r = 0).
Proof.
  intros Ha He Hr.
  replace (h_whole delta alpha eta) with
    (((2 + eta) * alpha * sin alpha - 2 * fac delta eta * (1 - cos alpha))
     / ((1 - cos alpha) * (2 + eta))) by (unfold h_whole, A; field; auto).
  apply cleared; [now apply Rmult_integral_contrapositive | exact Hr].
Qed.

Lemma cleared_tangency delta beta eta h r :
  sin beta <> 0 -> 2 - eta <> 0 ->
  r = sin beta * (2 - eta) * h
      - ((beta * cos beta + sin beta) * (2 - eta) - 2 * fac delta eta * sin beta) ->
  (h = h_tangency delta beta eta <-> r = 0).
Proof.
  intros Hs He Hr.
  replace (h_tangency delta beta eta) with
    (((beta * cos beta + sin beta) * (2 - eta) - 2 * fac delta eta * sin beta)
     / (sin beta * (2 - eta))) by (unfold h_tangency, cot; field; auto).
  apply cleared; [now apply Rmult_integral_contrapositive | exact Hr].
Qed.

Lemma cleared_tangency_crown delta eta h r :
  2 - eta <> 0 ->
  r = (2 - eta) * h - (2 * (2 - eta) - 2 * fac delta eta) ->
  (h = h_tangency_crown delta eta <-> r = 0).
Proof.
  intros He Hr.
  replace (h_tangency_crown delta eta) with ((2 * (2 - eta) - 2 * fac delta eta) / (2 - eta))
    by (unfold h_tangency_crown; field; auto).
  now apply cleared.
Qed.

Lemma cleared_shoulder_sliding alpha h mu r :
  h * cos alpha + alpha * sin alpha <> 0 ->
  r = (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha) ->
  (mu = mu_ss alpha h <-> r = 0).
Proof. apply cleared. Qed.

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
  rewrite <- joint. clear joint. unfold mu_is.
  split; intros [H Hj]; (split; [| exact Hj]); rewrite <- Hj in *;
    apply (cleared mu _ _ r Hd Hr); exact H.
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

(** An equation whose cleared form needs those before it. *)
Lemma both (P P' Q Q' : Prop) : (P <-> P') -> (Q <-> Q') -> (P /\ Q <-> P' /\ Q').
Proof. tauto. Qed.
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
Ltac compare := conjuncts; unfold A; interval with (i_prec 130).

(** An inequality between numbers. *)
Ltac arithmetic := interval with (i_prec 53).

(** A bound of a slope; many slopes are constant. *)
Ltac slope :=
  first [rewrite Rminus_eq_0, Rabs_R0; apply Rle_refl | interval with (i_prec 53)].

(** What the lemmas on cleared forms leave to show. *)
Ltac clearing :=
  match goal with
  | |- _ <> _ => interval with (i_prec 53)
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
