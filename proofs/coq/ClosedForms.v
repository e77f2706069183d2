(** * The closed forms (9)-(11) over the complex numbers

    Each printed formula is a root of its cubic (7), for either square root (12), for every cube root [u] of the printed
    base, not 0, and for both printed signs. The factors [1 + i sqrt 3], [1 - i sqrt 3] are cube roots of -8; with the
    third one, -2, which the paper does not print, one gets the third root, and the cubic is the product of the three
    linear factors: nothing is lost. [f], [g], [S] are any complex numbers here, with [S] and, for (9), [3 g - 2 S] not
    0; in the arch both are positive, and so is what could make [u] vanish in (9) and (10). *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Couplet Require Import Arch Moments Cubics.
Open Scope C_scope.

(** ** Rings with numerals and powers

    Coquelicot tells [ring] and [field] that C is a field, but not that [RtoC 3] is a numeral. *)

Fixpoint Cpower (z : C) (n : nat) : C :=
  match n with O => 1 | S m => z * Cpower z m end.
Infix "^" := Cpower : C_scope.

Lemma Cpower_add (z : C) (m n : nat) : z ^ (m + n) = z ^ m * z ^ n.
Proof. induction m as [|m IH]; simpl; [|rewrite IH]; ring. Qed.

Lemma C_power_theory : power_theory (RtoC 1) Cmult (@eq C) N.to_nat Cpower.
Proof.
  constructor. destruct n as [|p]; [easy|]. simpl. induction p as [p IH | p IH |].
  - rewrite Pos2Nat.inj_xI. simpl. now rewrite Nat.add_0_r, Cpower_add, IH.
  - rewrite Pos2Nat.inj_xO. simpl. now rewrite Nat.add_0_r, Cpower_add, IH.
  - simpl. ring.
Qed.

Lemma C_numerals : ring_morph (RtoC 0) (RtoC 1) Cplus Cmult Cminus Copp (@eq C)
  0%Z 1%Z Z.add Z.mul Z.sub Z.opp Z.eqb (fun z => RtoC (IZR z)).
Proof.
  constructor; try easy; intros; [now rewrite plus_IZR, RtoC_plus | now rewrite minus_IZR, RtoC_minus
    | now rewrite mult_IZR, RtoC_mult | now rewrite opp_IZR, RtoC_opp | now apply Z.eqb_eq in H as ->].
Qed.

Ltac C_numeral t :=
  match t with
  | RtoC (IZR ?z) => match isZcst z with true => z | _ => constr:(InitialRing.NotConstant) end
  | _ => constr:(InitialRing.NotConstant)
  end.

Add Field C_field_with_numerals : C_field_theory
  (morphism C_numerals, constants [C_numeral], power_tac C_power_theory [Rpow_tac]).

Lemma RtoC_power (x : R) (n : nat) : RtoC (pow x n) = RtoC x ^ n.
Proof. induction n as [|n IH]; simpl; [easy|]. now rewrite RtoC_mult, IH. Qed.

Lemma RtoC_nonzero (x : R) : x <> 0%R -> RtoC x <> 0.
Proof. intros H E. now apply H, RtoC_inj. Qed.

Lemma C_integral (x y : C) : x * y = 0 -> x <> 0 -> y = 0.
Proof. intros H Hx. transitivity (/ x * (x * y)); [field; easy | rewrite H; ring]. Qed.

Lemma C_product_nonzero (x y : C) : x <> 0 -> y <> 0 -> x * y <> 0.
Proof. exact (Cmult_neq_0 x y). Qed.

Lemma C_power_nonzero (x : C) (n : nat) : x <> 0 -> x ^ n <> 0.
Proof. intros Hx. induction n as [|n IH]; simpl; [apply RtoC_nonzero; lra|]. now apply C_product_nonzero. Qed.

Lemma C_numeral_nonzero (z : Z) : z <> 0%Z -> RtoC (IZR z) <> 0.
Proof. intros H. apply RtoC_nonzero. now apply not_0_IZR. Qed.

Ltac C_nonzero :=
  cbv beta; repeat split;
  repeat first [apply C_product_nonzero | apply C_power_nonzero];
  first [assumption | apply C_numeral_nonzero; discriminate].

(** ** The cubics and the formulas *)

(** (7), (12) over C. *)
Definition cubic_A (f g S A : C) : C :=
  S ^ 2 * (3 * g - 2 * S) * A ^ 3 + 3 * g * S * (g - f) * A ^ 2 - 3 * f * g ^ 2 * A + 2 * g ^ 3.
Definition cubic_eta (f g S eta : C) : C := S * eta ^ 3 + 3 * (f + g) * eta ^ 2 - 12 * (g - S) * eta + 12 * (g - f).
Definition cubic_h (f g S h : C) : C :=
  6 * S ^ 2 * h ^ 3 - 3 * S * (3 * f - g - 2 * S) * h ^ 2 - 3 * (g - f) * (f - 2 * S) * h
  + 2 * (g - f) ^ 2.
Definition radicand_C (f g S : C) : C :=
  9 * S ^ 2 * (g - f) ^ 2
  - 2 * S * (g - S) * (9 * f ^ 2 - g ^ 2 - 16 * g * S + 8 * S ^ 2)
  - 3 * (f + g) ^ 2 * (f ^ 2 - 2 * g * S + S ^ 2).

Ltac push_RtoC :=
  repeat first [rewrite RtoC_plus | rewrite RtoC_minus | rewrite RtoC_mult | rewrite RtoC_power].

(** They are those of [Arch] on real arguments. *)
Theorem cubic_A_on_reals (f g S A : R) : RtoC (pol_A_printed f g S A) = cubic_A f g S A.
Proof. unfold pol_A_printed, cubic_A. push_RtoC. ring. Qed.
Theorem cubic_eta_on_reals (f g S eta : R) : RtoC (pol_eta_printed f g S eta) = cubic_eta f g S eta.
Proof. unfold pol_eta_printed, cubic_eta. push_RtoC. ring. Qed.
Theorem cubic_h_on_reals (f g S h : R) : RtoC (pol_h_printed f g S h) = cubic_h f g S h.
Proof. unfold pol_h_printed, cubic_h. push_RtoC. ring. Qed.
Theorem radicand_on_reals (f g S : R) : RtoC (radicand_printed f g S) = radicand_C f g S.
Proof. unfold radicand_printed, radicand_C. push_RtoC. ring. Qed.

(** The signs that the formulas leave open, and the factor that goes with them. *)
Inductive branch := plus | minus | unprinted.
Definition opposite (b : branch) : branch := match b with plus => minus | minus => plus | unprinted => unprinted end.
Definition factor (b : branch) : C :=
  match b with plus => 1 + Ci * sqrt 3 | minus => 1 - Ci * sqrt 3 | unprinted => - (2) end.

(** [2^(2/3)] *)
Definition two_to_two_thirds : C := Rpower 2 (2 / 3).

(** What stands under the cube roots. *)
Definition base_A (f g S root : C) : C :=
  (g - f) * (2 * (f + g) ^ 2 + f * (g - 6 * S)) + 2 * S * (3 * g - 2 * S) ^ 2
  + (3 * g - 2 * S) * root.
Definition base_eta (f g S root : C) : C := (f + g) ^ 3 + 6 * g * S * (f + g) - 12 * f * S ^ 2 + 2 * S * root.
Definition base_h (f g S root : C) : C :=
  - g * (9 * f ^ 2 - g ^ 2)
  - 2 * S * (9 * f * (g - f) - 12 * g * (g - S) - 4 * S ^ 2) + 3 * (g - f) * root.

(** (9), (10), (11), with [u] for the cube root. *)
Definition closed_A (b : branch) (f g S u : C) : C :=
  g / (S * (3 * g - 2 * S))
  * (- (g - f)
     + (factor b / two_to_two_thirds) * (((f + g) ^ 2 - f * (g + 2 * S)) / u)
     + (two_to_two_thirds / factor b) * u).
Definition closed_eta (b : branch) (f g S u : C) : C :=
  1 / S
  * (- (f + g)
     + (factor (opposite b) / 2) * (((f + g) ^ 2 + 4 * S * (g - S)) / u)
     + (2 / factor (opposite b)) * u).
Definition closed_h (b : branch) (f g S u : C) : C :=
  1 / (6 * S)
  * (3 * f - g - 2 * S
     + (factor b / 2) * ((3 * f ^ 2 + g ^ 2 - 4 * S * (2 * g - S)) / u)
     + (2 / factor b) * u).

(** ** The factors are the cube roots of -8 *)

Lemma i_sqrt_3_square : (Ci * sqrt 3) ^ 2 = - (3).
Proof.
  replace ((Ci * sqrt 3) ^ 2) with ((Ci * Ci) * (RtoC (sqrt 3) * RtoC (sqrt 3))) by ring.
  rewrite <- RtoC_mult, sqrt_sqrt by lra. replace (Ci * Ci) with (- (1)); [ring|].
  unfold Ci, Cmult, Copp, RtoC; simpl. f_equal; ring.
Qed.

Theorem factor_cube (b : branch) : factor b ^ 3 = - (8).
Proof. destruct b; simpl factor; ring [i_sqrt_3_square]. Qed.

Lemma factor_nonzero (b : branch) : factor b <> 0.
Proof.
  intros H. assert (E := factor_cube b). rewrite H in E. apply (C_numeral_nonzero 8); [discriminate|].
  transitivity (- (- (8))); [ring|]. rewrite <- E. ring.
Qed.

Lemma factor_inverse (b : branch) :
  2 / factor b
  = match b with plus => factor minus / 2 | minus => factor plus / 2 | unprinted => - (1) end.
Proof.
  assert (H2 : RtoC 2 <> 0) by C_nonzero. assert (Hplus := factor_nonzero plus).
  assert (Hminus := factor_nonzero minus).
  assert (E : factor plus * factor minus = 4) by (simpl factor; ring [i_sqrt_3_square]). destruct b.
  - transitivity (4 / (2 * factor plus)); [field; C_nonzero | rewrite <- E; field; C_nonzero].
  - transitivity (4 / (2 * factor minus)); [field; C_nonzero | rewrite <- E; field; C_nonzero].
  - simpl factor. field. C_nonzero.
Qed.

Lemma two_to_two_thirds_cube : two_to_two_thirds ^ 3 = 4.
Proof.
  unfold two_to_two_thirds. rewrite <- RtoC_power. f_equal. rewrite <- Rpower_pow by apply exp_pos.
  rewrite Rpower_mult. replace (2 / 3 * INR 3)%R with (INR 2) by (simpl; field). rewrite Rpower_pow by lra. ring.
Qed.

Lemma two_to_two_thirds_nonzero : two_to_two_thirds <> 0.
Proof. apply RtoC_nonzero, Rgt_not_eq, exp_pos. Qed.

(** ** Cardano's formula, once for all *)

(** The depressed cubic with the roots [w p + t / w], [w] the cube roots of 1 up to sign. *)
Definition cardano (b : branch) (p t : C) : C := factor b / 2 * p + 2 / factor b * t.

Lemma cardano_factors (p t Y : C) :
  (Y - cardano plus p t) * (Y - cardano minus p t) * (Y - cardano unprinted p t)
  = Y ^ 3 - 3 * (p * t) * Y + (p ^ 3 + t ^ 3).
Proof.
  (* everything in terms of the cube root w = (1 + i sqrt 3)/2 of -1 *)
  unfold cardano. rewrite !factor_inverse. set (w := factor plus / 2).
  assert (Hminus : factor minus / 2 = 1 - w) by (unfold w; simpl factor; field; C_nonzero).
  assert (Hthird : factor unprinted / 2 = - (1)) by (simpl factor; field; C_nonzero). assert (Hw : w ^ 2 = w - 1).
  { unfold w. simpl factor. set (j := Ci * sqrt 3). assert (Hj : j ^ 2 = - (3)) by apply i_sqrt_3_square.
    transitivity ((1 + 2 * j + j ^ 2) / 4); [|rewrite Hj]; field; C_nonzero. }
  rewrite Hminus, Hthird. ring [Hw].
Qed.

(** With [P + D] under the cube root: the shape of (10) and (11), *)
Lemma cube_root_sum (q P D u : C) : u <> 0 -> u ^ 3 = P + D -> q ^ 3 = P ^ 2 - D ^ 2 ->
  (q / u) * u = q /\ (q / u) ^ 3 + u ^ 3 = 2 * P.
Proof.
  intros Hu Hu3 Hq. split; [field; exact Hu|]. replace ((q / u) ^ 3) with (q ^ 3 / u ^ 3) by (field; exact Hu).
  assert (u ^ 3 <> 0) by C_nonzero. rewrite Hq. replace (P ^ 2 - D ^ 2) with (u ^ 3 * (P - D)) by (rewrite Hu3; ring).
  replace (u ^ 3 * (P - D) / u ^ 3) with (P - D) by (field; assumption). rewrite Hu3. ring.
Qed.

(** and the shape of (9), which has [2^(2/3)] in the place of 2. *)
Lemma cube_root_sum_9 (q P D u c : C) : c <> 0 -> c ^ 3 = 4 -> u <> 0 -> u ^ 3 = P + D -> 4 * q ^ 3 = P ^ 2 - D ^ 2 ->
  (2 * q / (c * u)) * (c * u / 2) = q /\ (2 * q / (c * u)) ^ 3 + (c * u / 2) ^ 3 = P.
Proof.
  intros Hc Hc3 Hu Hu3 Hq. split; [field; C_nonzero|].
  replace ((2 * q / (c * u)) ^ 3) with (2 * (4 * q ^ 3) / (c ^ 3 * u ^ 3)) by (field; C_nonzero).
  replace ((c * u / 2) ^ 3) with (c ^ 3 * u ^ 3 / 8) by (field; C_nonzero). assert (u ^ 3 <> 0) by C_nonzero.
  rewrite Hc3, Hq. replace (P ^ 2 - D ^ 2) with (u ^ 3 * (P - D)) by (rewrite Hu3; ring).
  replace (2 * (u ^ 3 * (P - D)) / (4 * u ^ 3)) with ((P - D) / 2) by (field; C_nonzero). rewrite Hu3. field.
  C_nonzero.
Qed.

Lemma product_zero (b : branch) (lead X x1 x2 x3 : C) :
  X = match b with plus => x1 | minus => x2 | unprinted => x3 end ->
  lead * ((X - x1) * (X - x2) * (X - x3)) = 0.
Proof. intros ->. destruct b; ring. Qed.

(** ** (9) *)

Theorem cubic_in_opening_factors (f g S root u X : C) : S <> 0 -> 3 * g - 2 * S <> 0 -> u <> 0 ->
  root ^ 2 = radicand_C f g S -> u ^ 3 = base_A f g S root ->
  cubic_A f g S X
  = S ^ 2 * (3 * g - 2 * S)
    * ((X - closed_A plus f g S u) * (X - closed_A minus f g S u)
       * (X - closed_A unprinted f g S u)).
Proof.
  intros HS HL Hu Hroot Hbase. unfold base_A in Hbase. set (L := 3 * g - 2 * S) in *.
  set (q := (f + g) ^ 2 - f * (g + 2 * S)).
  set (P := (g - f) * (2 * (f + g) ^ 2 + f * (g - 6 * S)) + 2 * S * L ^ 2) in *.
  assert (Hc := two_to_two_thirds_nonzero). set (c := two_to_two_thirds) in *.
  assert (Hq : 4 * q ^ 3 = P ^ 2 - (L * root) ^ 2).
  { transitivity (P ^ 2 - L ^ 2 * root ^ 2); [|ring]. rewrite Hroot. unfold q, P, L, radicand_C. ring. }
  destruct (cube_root_sum_9 q P (L * root) u c Hc two_to_two_thirds_cube Hu Hbase Hq) as [Hpt Hsum].
  assert (Hclosed : forall b, closed_A b f g S u
    = (- g * (g - f) + cardano b (g * (2 * q / (c * u))) (g * (c * u / 2))) / (S * L)).
  { intros b. assert (Hb := factor_nonzero b). unfold closed_A, cardano. fold L q c. field. C_nonzero. }
  rewrite !Hclosed. set (p := 2 * q / (c * u)) in *. set (t := c * u / 2) in *. set (W := S * L * X + g * (g - f)).
  transitivity (((W - cardano plus (g * p) (g * t)) * (W - cardano minus (g * p) (g * t))
                 * (W - cardano unprinted (g * p) (g * t))) / (S * L ^ 2)).
  - rewrite cardano_factors.
    replace (W ^ 3 - 3 * (g * p * (g * t)) * W + ((g * p) ^ 3 + (g * t) ^ 3))
      with (W ^ 3 - 3 * g ^ 2 * (p * t) * W + g ^ 3 * (p ^ 3 + t ^ 3)) by ring. rewrite Hpt, Hsum.
    replace (W ^ 3 - 3 * g ^ 2 * q * W + g ^ 3 * P) with (S * L ^ 2 * cubic_A f g S X)
      by (unfold W, q, P, L, cubic_A; ring). field. C_nonzero.
  - unfold W. field. C_nonzero.
Qed.

(** Each branch of (9) is a root of the first cubic (7). *)
Theorem closed_form_9 (b : branch) (f g S root u : C) : S <> 0 -> 3 * g - 2 * S <> 0 -> u <> 0 ->
  root ^ 2 = radicand_C f g S -> u ^ 3 = base_A f g S root -> cubic_A f g S (closed_A b f g S u) = 0.
Proof.
  intros. rewrite (cubic_in_opening_factors f g S root u) by assumption. apply (product_zero b). now destruct b.
Qed.

(** ** (10) *)

Theorem cubic_in_thickness_factors (f g S root u X : C) :
  S <> 0 -> u <> 0 -> root ^ 2 = radicand_C f g S -> u ^ 3 = base_eta f g S root ->
  cubic_eta f g S X
  = S * ((X - closed_eta plus f g S u) * (X - closed_eta minus f g S u)
         * (X - closed_eta unprinted f g S u)).
Proof.
  intros HS Hu Hroot Hbase. unfold base_eta in Hbase. set (q := (f + g) ^ 2 + 4 * S * (g - S)).
  set (P := (f + g) ^ 3 + 6 * g * S * (f + g) - 12 * f * S ^ 2) in *.
  assert (Hq : q ^ 3 = P ^ 2 - (2 * S * root) ^ 2).
  { transitivity (P ^ 2 - 4 * S ^ 2 * root ^ 2); [|ring]. rewrite Hroot. unfold q, P, radicand_C. ring. }
  destruct (cube_root_sum q P (2 * S * root) u Hu Hbase Hq) as [Hpt Hsum].
  assert (Hclosed : forall b, closed_eta b f g S u = (- (f + g) + cardano (opposite b) (q / u) u) / S).
  { intros b. assert (Hb := factor_nonzero (opposite b)). unfold closed_eta, cardano. fold q. field. C_nonzero. }
  rewrite !Hclosed. simpl opposite. set (p := q / u) in *. set (W := S * X + (f + g)).
  transitivity (((W - cardano plus p u) * (W - cardano minus p u) * (W - cardano unprinted p u)) / S ^ 2).
  - rewrite cardano_factors, Hpt, Hsum.
    replace (W ^ 3 - 3 * q * W + 2 * P) with (S ^ 2 * cubic_eta f g S X) by (unfold W, q, P, cubic_eta; ring). field.
    C_nonzero.
  - unfold W. field. C_nonzero.
Qed.

(** Each branch of (10) is a root of the second cubic (7). *)
Theorem closed_form_10 (b : branch) (f g S root u : C) : S <> 0 -> u <> 0 -> root ^ 2 = radicand_C f g S ->
  u ^ 3 = base_eta f g S root -> cubic_eta f g S (closed_eta b f g S u) = 0.
Proof.
  intros. rewrite (cubic_in_thickness_factors f g S root u) by assumption. apply (product_zero b). now destruct b.
Qed.

(** ** (11) *)

Theorem cubic_in_thrust_factors (f g S root u X : C) :
  S <> 0 -> u <> 0 -> root ^ 2 = radicand_C f g S -> u ^ 3 = base_h f g S root ->
  cubic_h f g S X
  = 6 * S ^ 2 * ((X - closed_h plus f g S u) * (X - closed_h minus f g S u)
                 * (X - closed_h unprinted f g S u)).
Proof.
  intros HS Hu Hroot Hbase. unfold base_h in Hbase. set (m := 3 * f - g - 2 * S).
  set (q := 3 * f ^ 2 + g ^ 2 - 4 * S * (2 * g - S)).
  set (P := - g * (9 * f ^ 2 - g ^ 2) - 2 * S * (9 * f * (g - f) - 12 * g * (g - S) - 4 * S ^ 2)) in *.
  assert (Hq : q ^ 3 = P ^ 2 - (3 * (g - f) * root) ^ 2).
  { transitivity (P ^ 2 - 9 * (g - f) ^ 2 * root ^ 2); [|ring]. rewrite Hroot. unfold q, P, radicand_C. ring. }
  destruct (cube_root_sum q P (3 * (g - f) * root) u Hu Hbase Hq) as [Hpt Hsum].
  assert (Hclosed : forall b, closed_h b f g S u = (m + cardano b (q / u) u) / (6 * S)).
  { intros b. assert (Hb := factor_nonzero b). unfold closed_h, cardano. fold q m. field. C_nonzero. }
  rewrite !Hclosed. set (p := q / u) in *. set (W := 6 * S * X - m).
  transitivity (((W - cardano plus p u) * (W - cardano minus p u) * (W - cardano unprinted p u)) / (36 * S)).
  - rewrite cardano_factors, Hpt, Hsum.
    replace (W ^ 3 - 3 * q * W + 2 * P) with (36 * S * cubic_h f g S X) by (unfold W, q, P, m, cubic_h; ring). field.
    C_nonzero.
  - unfold W. field. C_nonzero.
Qed.

(** Each branch of (11) is a root of the third cubic (7). *)
Theorem closed_form_11 (b : branch) (f g S root u : C) : S <> 0 -> u <> 0 -> root ^ 2 = radicand_C f g S ->
  u ^ 3 = base_h f g S root -> cubic_h f g S (closed_h b f g S u) = 0.
Proof.
  intros. rewrite (cubic_in_thrust_factors f g S root u) by assumption. apply (product_zero b). now destruct b.
Qed.

(** ** In the arch

    [S], [3 g - 2 S] and, for (9) and (10), the cube root do not vanish, whatever square root is chosen; and a real
    value of a formula is a root of the real cubic, so that (10) gives a thickness for which (2) and (5) agree. *)

Lemma cube_root_9_nonzero (f g S root u : C) : (f + g) ^ 2 - f * (g + 2 * S) <> 0 -> root ^ 2 = radicand_C f g S ->
  u ^ 3 = base_A f g S root -> u <> 0.
Proof.
  intros Hq Hroot Hbase Hu. apply (C_power_nonzero _ 3 Hq). apply (C_integral 4); [|C_nonzero].
  transitivity (base_A f g S root * base_A f g S (- root)).
  - unfold base_A.
    transitivity (((g - f) * (2 * (f + g) ^ 2 + f * (g - 6 * S)) + 2 * S * (3 * g - 2 * S) ^ 2) ^ 2 - (3 * g - 2 * S)
      ^ 2 * root ^ 2); [rewrite Hroot; unfold radicand_C|]; ring.
  - rewrite <- Hbase, Hu. ring.
Qed.

Lemma cube_root_10_nonzero (f g S root u : C) : (f + g) ^ 2 + 4 * S * (g - S) <> 0 -> root ^ 2 = radicand_C f g S ->
  u ^ 3 = base_eta f g S root -> u <> 0.
Proof.
  intros Hq Hroot Hbase Hu. apply (C_power_nonzero _ 3 Hq).
  transitivity (base_eta f g S root * base_eta f g S (- root)).
  - unfold base_eta.
    transitivity (((f + g) ^ 3 + 6 * g * S * (f + g) - 12 * f * S ^ 2) ^ 2 - 4 * S ^ 2 * root ^ 2);
      [rewrite Hroot; unfold radicand_C|]; ring.
  - rewrite <- Hbase, Hu. ring.
Qed.

Open Scope R_scope.

Lemma numerator_9_positive (beta : R) : 0 < beta < PI ->
  0 < (f_of beta + g_of beta) ^ 2 - f_of beta * (g_of beta + 2 * sin beta).
Proof.
  intros Hb. assert (H3 := three_g_minus_2_S_positive beta Hb). assert (HS : 0 < sin beta) by positive.
  assert (Hg := g_positive beta (proj1 Hb)). set (f := f_of beta) in *. set (g := g_of beta) in *.
  set (S := sin beta) in *.
  replace ((f + g) ^ 2 - f * (g + 2 * S))
    with ((f + (g - 2 * S) / 2) ^ 2 + (g + 2 * S) * (3 * g - 2 * S) / 4) by field.
  assert (0 <= (f + (g - 2 * S) / 2) ^ 2) by apply pow2_ge_0.
  assert (0 < (g + 2 * S) * (3 * g - 2 * S)) by positive. lra.
Qed.

Lemma numerator_10_positive (beta : R) : 0 < beta < PI ->
  0 < (f_of beta + g_of beta) ^ 2 + 4 * sin beta * (g_of beta - sin beta).
Proof.
  intros Hb. assert (0 < sin beta) by positive. assert (0 < g_of beta - sin beta).
  { unfold g_of. assert (sin beta < beta) by (apply sin_lt_x; lra). destruct (Rle_lt_dec beta (PI / 2)) as [Hc | Hc].
    - assert (0 <= cos beta) by positive. nra.
    - assert (HPI := PI2_3_2). assert (Hcircle := circle beta). destruct (SIN_bound beta). nra. }
  assert (0 <= (f_of beta + g_of beta) ^ 2) by apply pow2_ge_0. nra.
Qed.

Theorem closed_form_9_in_the_arch (b : branch) (beta x : R) (root u : C) : 0 < beta < PI -> let f := f_of beta in
  let g := g_of beta in let S := sin beta in (root ^ 2)%C = radicand_printed f g S -> (u ^ 3)%C = base_A f g S root ->
  RtoC x = closed_A b f g S u -> pol_A_printed f g S x = 0.
Proof.
  intros Hb f g S Hroot Hbase Hx. rewrite radicand_on_reals in Hroot. apply RtoC_inj. rewrite cubic_A_on_reals, Hx.
  apply (closed_form_9 b f g S root u); try easy.
  - apply RtoC_nonzero, Rgt_not_eq, sin_gt_0; lra.
  - rewrite <- !RtoC_mult, <- RtoC_minus. now apply RtoC_nonzero, Rgt_not_eq, three_g_minus_2_S_positive.
  - apply (cube_root_9_nonzero f g S root u); try easy. assert (Hq := numerator_9_positive beta Hb). fold f g S in Hq.
    apply Rgt_not_eq, RtoC_nonzero in Hq. intros H. apply Hq. rewrite <- H. push_RtoC. ring.
Qed.

Theorem closed_form_10_in_the_arch (b : branch) (beta x : R) (root u : C) : 0 < beta < PI -> let f := f_of beta in
  let g := g_of beta in let S := sin beta in (root ^ 2)%C = radicand_printed f g S ->
  (u ^ 3)%C = base_eta f g S root -> RtoC x = closed_eta b f g S u -> pol_eta_printed f g S x = 0 /\
  (0 < x < 2 -> h_lower 1 beta x = h_tangency 1 beta x).
Proof.
  intros Hb f g S Hroot Hbase Hx. rewrite radicand_on_reals in Hroot. assert (Hpol : pol_eta_printed f g S x = 0).
  { apply RtoC_inj. rewrite cubic_eta_on_reals, Hx. apply (closed_form_10 b f g S root u); try easy.
    - apply RtoC_nonzero, Rgt_not_eq, sin_gt_0; lra.
    - apply (cube_root_10_nonzero f g S root u); try easy. assert (Hq := numerator_10_positive beta Hb).
      fold f g S in Hq. apply Rgt_not_eq, RtoC_nonzero in Hq. intros H. apply Hq. rewrite <- H. push_RtoC. ring. }
  split; [easy|]. intros Hin. apply cubic_in_thickness_in_the_arch; try easy. now rewrite pol_eta_is_printed.
Qed.

(** In (11) the cube root can vanish for some haunch and square root, so that this is asked for. *)
Theorem closed_form_11_in_the_arch (b : branch) (beta x : R) (root u : C) : 0 < beta < PI -> let f := f_of beta in
  let g := g_of beta in let S := sin beta in u <> RtoC 0 -> (root ^ 2)%C = radicand_printed f g S ->
  (u ^ 3)%C = base_h f g S root -> RtoC x = closed_h b f g S u -> pol_h_printed f g S x = 0.
Proof.
  intros Hb f g S Hu Hroot Hbase Hx. rewrite radicand_on_reals in Hroot. apply RtoC_inj. rewrite cubic_h_on_reals, Hx.
  apply (closed_form_11 b f g S root u); try easy. apply RtoC_nonzero, Rgt_not_eq, sin_gt_0; lra.
Qed.
