(** * What the extracted program computes in another way

    CoqInterval's arithmetic over [Z] goes through numbers bit by bit.  The extracted program does three of its
    functions, and Flocq's division, with the library of integers that stands for [Z]; here they are the same. *)

From Coq Require Import ZArith Lia Bool.
From Flocq Require Import Core.Zaux.
From Interval Require Import Float.Generic Float.Specific_stdz.
Open Scope Z_scope.

(** The length of a number. *)
Theorem digits_faster (m nb : positive) : Zpos (StdZRadix2.digits_aux m nb) = Zpos nb + Z.log2 (Zpos m).
Proof.
  revert nb. induction m as [m IH | m IH |]; intros nb; cbn [StdZRadix2.digits_aux]; [| | simpl; lia].
  - rewrite IH, Pos2Z.inj_succ. change (Zpos m~1) with (2 * Zpos m + 1). rewrite Z.log2_succ_double; lia.
  - rewrite IH, Pos2Z.inj_succ. change (Zpos m~0) with (2 * Zpos m). rewrite Z.log2_double; lia.
Qed.

(** Shifted to the left, *)
Theorem shl_faster (m d : positive) : Zpos (StdZRadix2.mantissa_shl m (Zpos d)) = Z.shiftl (Zpos m) (Zpos d).
Proof.
  cbn [StdZRadix2.mantissa_shl]. rewrite iter_pos_nat, Z.shiftl_mul_pow2, <- (positive_nat_Z d) by lia.
  induction (Pos.to_nat d) as [| n IH].
  { change (Z.of_nat 0) with 0. rewrite Z.pow_0_r, Z.mul_1_r. reflexivity. }
  rewrite iter_nat_S, Nat2Z.inj_succ, Z.pow_succ_r by lia. set (k := iter_nat _ n m) in *.
  change (Zpos (xO k)) with (2 * Zpos k). lia.
Qed.

(** and to the right, with the place of what is cut off. *)
Definition cut (rest half : Z) (pos : position) : position :=
  let beyond := (if half <=? rest then rest - half else rest) in
  let more := negb (beyond =? 0) || match pos with pos_Eq => false | _ => true end in
  if half <=? rest then if more then pos_Up else pos_Mi else if more then pos_Lo else pos_Eq.

Definition shifted (m : positive) (n : Z) (pos : position) : positive * position :=
  let q := Z.shiftr (Zpos m) n in
  if q =? 0 then (1%positive, pos_Eq)
  else (Z.to_pos q, cut (Zpos m - q * 2 ^ n) (2 ^ (n - 1)) pos).

Definition is_exact (pos : position) : bool := match pos with pos_Eq => true | _ => false end.

Lemma cut_is_exact (r half : Z) (pos : position) : 0 < half -> 0 <= r ->
  is_exact (cut r half pos) = (r =? 0) && is_exact pos.
Proof.
  intros Hhalf Hr. unfold cut. destruct (Z.leb_spec half r).
  - replace (r =? 0) with false by (symmetry; apply Z.eqb_neq; lia). destruct (_ || _); reflexivity.
  - now destruct (r =? 0), pos.
Qed.

Lemma shifted_step (m : positive) (n : Z) (pos : position) : 1 <= n ->
  StdZRadix2.mantissa_shr_aux (shifted m n pos) = shifted m (n + 1) pos.
Proof.
  intros Hn. unfold shifted. rewrite !Z.shiftr_div_pow2, Z.pow_add_r by lia. change (2 ^ 1) with 2.
  assert (Hhalf : 0 < 2 ^ (n - 1)) by (apply Z.pow_pos_nonneg; lia).
  assert (Hpow : 2 ^ n = 2 * 2 ^ (n - 1)) by (rewrite <- Z.pow_succ_r by lia; f_equal; lia).
  rewrite <- Z.div_div by lia. assert (Hm := Z.div_mod (Zpos m) (2 ^ n) ltac:(lia)).
  assert (Hr := Z.mod_pos_bound (Zpos m) (2 ^ n) ltac:(lia)). set (q := Zpos m / 2 ^ n) in *.
  set (r := Zpos m mod 2 ^ n) in *. replace (Zpos m - q * 2 ^ n) with r by lia. replace (n + 1 - 1) with n by lia.
  assert (Hq : 0 <= q) by (apply Z.div_pos; lia). assert (Hcut := cut_is_exact r (2 ^ (n - 1)) pos Hhalf ltac:(lia)).
  destruct q as [| [p | p |] | p]; try lia; try reflexivity.
  - replace (Zpos p~1 / 2) with (Zpos p) by (apply (Z.div_unique _ 2 _ 1); lia).
    cbn [Z.eqb Z.to_pos StdZRadix2.mantissa_shr_aux]. replace (Zpos m - Zpos p * (2 ^ n * 2)) with (2 ^ n + r) by lia.
    unfold cut at 2. replace (2 ^ n <=? 2 ^ n + r) with true by (symmetry; apply Z.leb_le; lia).
    replace (2 ^ n + r - 2 ^ n) with r by lia. destruct (cut r (2 ^ (n - 1)) pos), (r =? 0), pos; easy.
  - replace (Zpos p~0 / 2) with (Zpos p) by (apply (Z.div_unique _ 2 _ 0); lia).
    cbn [Z.eqb Z.to_pos StdZRadix2.mantissa_shr_aux]. replace (Zpos m - Zpos p * (2 ^ n * 2)) with r by lia.
    unfold cut at 2. replace (2 ^ n <=? r) with false by (symmetry; apply Z.leb_gt; lia).
    destruct (cut r (2 ^ (n - 1)) pos), (r =? 0), pos; easy.
Qed.

Theorem shr_faster (m d : positive) (pos : position) :
  StdZRadix2.mantissa_shr m (Zpos d) pos = shifted m (Zpos d) pos.
Proof.
  cbn [StdZRadix2.mantissa_shr]. rewrite iter_pos_nat, <- (positive_nat_Z d). destruct (Pos2Nat.is_succ d) as [n ->].
  induction n as [| n IH].
  - unfold shifted. change (Z.of_nat 1) with 1. rewrite Z.shiftr_div_pow2 by lia.
    destruct m as [p | p |]; [| | reflexivity].
    + replace (Zpos p~1 / 2 ^ 1) with (Zpos p) by (apply (Z.div_unique _ (2 ^ 1) _ 1); lia).
      replace (Zpos p~1 - Zpos p * 2 ^ 1) with 1 by lia. now destruct pos.
    + replace (Zpos p~0 / 2 ^ 1) with (Zpos p) by (apply (Z.div_unique _ (2 ^ 1) _ 0); lia).
      replace (Zpos p~0 - Zpos p * 2 ^ 1) with 0 by lia. now destruct pos.
  - rewrite iter_nat_S, IH, shifted_step by lia. f_equal. lia.
Qed.

(** Division. *)
Theorem division_faster (a b : Z) : Zfast_div_eucl a b = Z.div_eucl a b.
Proof. apply Zfast_div_eucl_correct. Qed.
