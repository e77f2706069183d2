(** * Linear inequalities without a strict solution have multipliers

    Gordan's theorem, for affine forms on any space with straight lines, by one form after the other: if finitely many
    forms are positive at no common point, a sum of them with factors that are not negative, and not all zero, is a
    constant that is not positive. *)

From Coq Require Import Reals Lra List Classical.
Import ListNotations.
Open Scope R_scope.

(** The sum of the values with factors, and that of the first factors. *)
Fixpoint weighted {V} (k : nat -> R) (forms : list (V -> R)) (x : V) : R :=
  match forms with f :: rest => k 0%nat * f x + weighted (fun i => k (S i)) rest x | [] => 0 end.
Fixpoint sum (k : nat -> R) (n : nat) : R :=
  match n with S m => k 0%nat + sum (fun i => k (S i)) m | O => 0 end.

(** A factor more in front of others. *)
Definition onto (a : R) (k : nat -> R) (i : nat) : R := match i with S j => k j | O => a end.

Lemma no_factors {V} (forms : list (V -> R)) x : weighted (fun _ => 0) forms x = 0 /\ forall n, sum (fun _ => 0) n = 0.
Proof. split; [induction forms as [| f forms IH] | induction n as [| n IH]]; simpl; lra. Qed.

Lemma weighted_positive {V} (forms : list (V -> R)) x : (forall f, In f forms -> 0 < f x) ->
  forall k, (forall i, 0 <= k i) -> 0 <= weighted k forms x /\ (0 < sum k (length forms) -> 0 < weighted k forms x).
Proof.
  induction forms as [| f forms IH]; intros Hpos k Hk; simpl; [lra |].
  destruct (IH (fun g Hg => Hpos g (or_intror Hg)) (fun i => k (S i))) as [H H']; [easy |].
  assert (Hf := Hpos f (or_introl eq_refl)). destruct (Hk 0%nat) as [H0 | <-]; [nra |].
  rewrite Rmult_0_l, !Rplus_0_l. easy.
Qed.

(** Not both. *)
Theorem no_strict_point_with_multipliers {V} (forms : list (V -> R)) k c x : (forall i, 0 <= k i) ->
  0 < sum k (length forms) -> c <= 0 -> weighted k forms x = c -> ~ (forall f, In f forms -> 0 < f x).
Proof. intros Hk Hsum Hc E Hall. destruct (weighted_positive forms x Hall k Hk) as [_ H]. specialize (H Hsum). lra. Qed.

Section Space.

(** [line x y t] is a point of the line through [x] and [y], [x] for 0 and [y] for 1. *)
Context {V : Type}.
Variable line : V -> V -> R -> V.
Definition affine (f : V -> R) : Prop := forall x y t, f (line x y t) = f x + t * (f y - f x).
Definition holds_lines (inside : V -> Prop) : Prop := forall x y t, inside x -> inside y -> inside (line x y t).

Lemma weighted_affine forms (H : forall f, In f forms -> affine f) k : affine (weighted k forms).
Proof.
  revert H k. induction forms as [| f forms IH]; intros H k x y t; simpl; [ring |].
  rewrite (H f (or_introl eq_refl)), (IH (fun g Hg => H g (or_intror Hg))). ring.
Qed.

(** What is positive stays so a little way in any direction. *)
Lemma a_little_way (forms : list (V -> R)) x y : (forall f, In f forms -> affine f /\ 0 < f x) ->
  exists e, 0 < e /\ forall t, 0 < t <= e -> forall f, In f forms -> 0 < f (line x y t).
Proof.
  induction forms as [| f forms IH]; intros H; [exists 1; split; [lra | easy] |].
  destruct IH as (e & He & Hall); [intros g Hg; apply H; now right |]. destruct (H f (or_introl eq_refl)) as [Ha Hf].
  set (D := Rabs (f y - f x) + 1). assert (HD : 0 < D) by (unfold D; assert (A := Rabs_pos (f y - f x)); lra).
  exists (Rmin e (f x / (2 * D))). split; [apply Rmin_glb_lt; [easy | apply Rdiv_lt_0_compat; lra] |].
  intros t [Ht Ht'] g [<- | Hg].
  - rewrite Ha. assert (B := Rle_trans _ _ _ Ht' (Rmin_r _ _)). apply (Rmult_le_compat_r D) in B; [| lra].
    replace (f x / (2 * D) * D) with (f x / 2) in B by (field; lra). assert (A := Rle_abs (- (f y - f x))).
    rewrite Rabs_Ropp in A. unfold D in B. nra.
  - apply Hall; [| easy]. assert (B := Rle_trans _ _ _ Ht' (Rmin_l _ _)). lra.
Qed.

(** A form that is constant where another is zero is a multiple of it and a constant. *)
Lemma level (inside : V -> Prop) (f g : V -> R) c x y : affine f -> affine g -> holds_lines inside ->
  (forall z, inside z -> f z = 0 -> g z = c) -> inside x -> inside y -> f x <> f y ->
  g x * f y - g y * f x = c * (f y - f x).
Proof.
  intros Hf Hg Hlines Hc Hx Hy Hne. set (t := f x / (f x - f y)). assert (E := Hc (line x y t) (Hlines _ _ _ Hx Hy)).
  rewrite Hf, Hg in E. rewrite <- E by (unfold t; field; lra). unfold t. field. lra.
Qed.

(** Either all forms are positive at one point of a part of the space that has the lines through its points, or a sum of
    them with factors that are not negative, and not all zero, is there a constant that is not positive. *)
Theorem strict_point_or_multipliers (forms : list (V -> R)) : (forall f, In f forms -> affine f) ->
  forall inside : V -> Prop, (exists x, inside x) -> holds_lines inside ->
  (exists x, inside x /\ forall f, In f forms -> 0 < f x) \/
  (exists k c, (forall i, 0 <= k i) /\ 0 < sum k (length forms) /\ c <= 0 /\
     forall x, inside x -> weighted k forms x = c).
Proof.
  induction forms as [| f forms IH]; intros H inside [o Ho] Hlines; [left; now exists o |].
  assert (Hf := H f (or_introl eq_refl)). assert (Hforms := fun g Hg => H g (or_intror Hg)). specialize (IH Hforms).
  destruct (IH inside) as [(x & Hx & Hpos) | (k & c & Hk & Hsum & Hc & E)]; [now exists o | easy | |].
  2:{ right. exists (onto 0 k), c. split; [intros [| i]; [apply Rle_refl | apply Hk] |]. split; [| split; [easy |]].
      - change (0 < 0 + sum k (length forms)). lra.
      - intros z Hz. change (0 * f z + weighted k forms z = c). rewrite (E z Hz). ring. }
  destruct (Rlt_le_dec 0 (f x)) as [Hfx | Hfx]; [left; exists x; split; [easy |]; intros g [<- | Hg]; auto |].
  destruct (classic (exists y, inside y /\ 0 < f y)) as [(y & Hy & Hfy) | Hnone].
  2:{ right. exists (onto 1 (fun _ => 0)), (f x). destruct (no_factors forms x) as [_ Z].
      split; [intros [| i]; simpl; lra | split; [| split; [easy |]]].
      - change (0 < 1 + sum (fun _ => 0) (length forms)). rewrite Z. lra.
      - intros z Hz. change (1 * f z + weighted (fun _ => 0) forms z = f x). destruct (no_factors forms z) as [-> _].
        destruct (Req_dec (f z) (f x)) as [-> | Hne]; [ring | exfalso]. apply Hnone.
        exists (line x z ((1 - f x) / (f z - f x))). split; [now apply Hlines |]. rewrite Hf.
        replace (f x + (1 - f x) / (f z - f x) * (f z - f x)) with 1 by (field; lra). lra. }
  destruct (IH (fun z => inside z /\ f z = 0)) as [(z & [Hz Ez] & Hpos') | (k & c & Hk & Hsum & Hc & E)].
  - exists (line x y (f x / (f x - f y))). split; [now apply Hlines |]. rewrite Hf. field. lra.
  - intros u v t [Hu Eu] [Hv Ev]. split; [now apply Hlines |]. rewrite Hf, Eu, Ev. ring.
  - left. destruct (a_little_way forms z y) as (e & He & Hall); [auto |]. exists (line z y e).
    split; [now apply Hlines |]. intros g [<- | Hg]; [rewrite Hf, Ez; nra | apply Hall; [lra | easy]].
  - right. set (g := weighted k forms). assert (Hg : affine g) by now apply weighted_affine.
    destruct (weighted_positive forms x Hpos k Hk) as [_ Hgx]. specialize (Hgx Hsum). fold g in Hgx.
    assert (Hfx' : f x < 0) by (destruct Hfx as [? | Z]; [easy |]; assert (E' := E x (conj Hx Z)); fold g in E'; lra).
    assert (Hlevel := fun u v => level inside f g c u v Hf Hg Hlines (fun z Hz Ez => E z (conj Hz Ez))).
    exists (onto (- ((g x - c) / f x)) k), c. split; [| split; [| split; [easy |]]].
    + assert (0 < - ((g x - c) / f x)).
      { replace (- ((g x - c) / f x)) with ((g x - c) / - f x) by (field; lra). apply Rdiv_lt_0_compat; lra. }
      intros [| i]; [apply Rlt_le; easy | apply Hk].
    + change (0 < - ((g x - c) / f x) + sum k (length forms)).
      replace (- ((g x - c) / f x)) with ((g x - c) / - f x) by (field; lra).
      assert (0 < (g x - c) / - f x) by (apply Rdiv_lt_0_compat; lra). lra.
    + intros z Hz. change (- ((g x - c) / f x) * f z + g z = c). apply (Rmult_eq_reg_r (f x)); [| lra].
      replace ((- ((g x - c) / f x) * f z + g z) * f x) with (g z * f x - g x * f z + c * f z) by (field; lra).
      destruct (Req_dec (f z) (f x)) as [Ez | Ez].
      * assert (A := Hlevel z y Hz Hy ltac:(lra)). assert (B := Hlevel x y Hx Hy ltac:(lra)). rewrite Ez in *.
        assert (g z = g x) by (apply (Rmult_eq_reg_r (f y)); lra). nra.
      * assert (A := Hlevel z x Hz Hx Ez). lra.
Qed.

End Space.
