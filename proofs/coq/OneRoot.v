(** * Exactly one root: a sign change and a slope of one sign

    Let [f] be differentiable on [lo, hi] with a derivative that is positive there (or negative there),
    and let it change its sign between two points [a < b] of [lo, hi].  Then [f] has a root between [a]
    and [b], and no other root in the whole of [lo, hi].

    The two brackets do different work: a narrow [a, b] gives the digits of the root, a wide [lo, hi]
    says how far around there is no other. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Section OneRoot.

Variables (f f' : R -> R) (lo hi : R).
Hypothesis differentiable : forall x, lo <= x <= hi -> is_derive f x (f' x).

Lemma continuous_within x : lo <= x <= hi -> continuity_pt f x.
Proof.
  intros Hx. apply continuity_pt_filterlim.
  apply (ex_derive_continuous f). exists (f' x). now apply differentiable.
Qed.

(** The mean value theorem, on a part of the bracket. *)
Lemma slope_between x y : lo <= x -> x < y -> y <= hi ->
  exists z, lo <= z <= hi /\ f y - f x = f' z * (y - x).
Proof.
  intros Hx Hxy Hy.
  assert (left : Rmin x y = x) by (apply Rmin_left; lra).
  assert (right : Rmax x y = y) by (apply Rmax_right; lra).
  destruct (MVT_gen f x y f') as [z [Hz Hf]].
  - intros z Hz. apply differentiable. lra.
  - intros z Hz. apply continuous_within. lra.
  - exists z. split; [lra | exact Hf].
Qed.

Lemma increasing : (forall x, lo <= x <= hi -> 0 < f' x) ->
  forall x y, lo <= x -> x < y -> y <= hi -> f x < f y.
Proof.
  intros Hslope x y Hx Hxy Hy.
  destruct (slope_between x y Hx Hxy Hy) as [z [Hz Hf]].
  specialize (Hslope z Hz).
  assert (0 < f' z * (y - x)) by (apply Rmult_lt_0_compat; lra).
  lra.
Qed.

Theorem one_root_increasing (a b : R) :
  lo <= a -> a < b -> b <= hi ->
  f a < 0 -> 0 < f b ->
  (forall x, lo <= x <= hi -> 0 < f' x) ->
  exists x, a < x < b /\ f x = 0 /\ (forall y, lo <= y <= hi -> f y = 0 -> y = x).
Proof.
  intros Ha Hab Hb Hfa Hfb Hslope.
  destruct (Ranalysis5.IVT_interv f a b) as [x [Hx Hfx]]; try easy.
  { intros x Hx. apply continuous_within. lra. }
  assert (x <> a) by (intros ->; lra).
  assert (x <> b) by (intros ->; lra).
  exists x. split; [lra | split; [exact Hfx |]].
  intros y Hy Hfy. pose proof (increasing Hslope) as order.
  destruct (Rtotal_order x y) as [H1 | [H1 | H1]]; [| easy |].
  - specialize (order x y). lra.
  - specialize (order y x). lra.
Qed.

End OneRoot.

(** The falling case is the rising one of [- f]. *)
Theorem one_root_decreasing (f f' : R -> R) (lo hi a b : R) :
  (forall x, lo <= x <= hi -> is_derive f x (f' x)) ->
  lo <= a -> a < b -> b <= hi ->
  0 < f a -> f b < 0 ->
  (forall x, lo <= x <= hi -> f' x < 0) ->
  exists x, a < x < b /\ f x = 0 /\ (forall y, lo <= y <= hi -> f y = 0 -> y = x).
Proof.
  intros Hd Ha Hab Hb Hfa Hfb Hslope.
  destruct (one_root_increasing (fun x => - f x) (fun x => - f' x) lo hi) with (a := a) (b := b)
    as [x [Hx [Hfx Hunique]]]; try lra.
  - intros x Hx. apply @is_derive_opp. now apply Hd.
  - intros x Hx. specialize (Hslope x Hx). lra.
  - exists x. split; [exact Hx | split; [lra |]].
    intros y Hy Hfy. apply Hunique; [exact Hy | lra].
Qed.
