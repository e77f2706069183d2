(** * Exactly one root of [n] equations in [n] unknowns: Krawczyk's test

    Given equations [F_j(x) = 0], a centre [c], radii [r_i > 0] and any matrix [Y], the fixed points of [T(x) = x - Y
    F(x)] are the roots of [F] if [Y] is regular. Distances are measured in units of the radii, by the norm [max_i
    |u_i| / r_i]; the box has the radius 1. If [|I - Y F'(x)| <= C] in the box and [C r + |Y F(c)| < r] (Krawczyk
    1969, Moore 1977), then [T] shrinks distances there by a factor [q < 1] and maps the box into itself. So two roots
    in the box are at distance 0, and the iterates of [T] from [c] stay there and converge, to a fixed point: the box
    holds **exactly one** root. This is Banach's theorem, proved here for the norm at hand.

    A point is a function from indices to reals of which the first [n] values matter. *)

From Coq Require Import Reals Lra Lia FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Definition point := nat -> R.

(** ** Finite sums *)

Fixpoint sum (n : nat) (f : nat -> R) : R :=
  match n with
  | O => 0
  | S m => sum m f + f m
  end.

Lemma sum_eq n f g : (forall i, (i < n)%nat -> f i = g i) -> sum n f = sum n g.
Proof.
  induction n as [| n IH]; intros H; simpl; [easy |]. rewrite IH by (intros; apply H; lia). now rewrite H by lia.
Qed.

Lemma sum_le n f g : (forall i, (i < n)%nat -> f i <= g i) -> sum n f <= sum n g.
Proof.
  induction n as [| n IH]; intros H; simpl; [lra |]. apply Rplus_le_compat; [apply IH; intros |]; apply H; lia.
Qed.

Lemma sum_zero n f : (forall i, (i < n)%nat -> f i = 0) -> sum n f = 0.
Proof. intros H. rewrite (sum_eq n f (fun _ => 0)) by exact H. clear H. induction n as [| n IH]; simpl; lra. Qed.

Lemma sum_minus n f g : sum n (fun i => f i - g i) = sum n f - sum n g.
Proof. induction n as [| n IH]; simpl; [| rewrite IH]; lra. Qed.

Lemma sum_plus n f g : sum n (fun i => f i + g i) = sum n f + sum n g.
Proof. induction n as [| n IH]; simpl; [| rewrite IH]; lra. Qed.

Lemma sum_mult n a f : sum n (fun i => a * f i) = a * sum n f.
Proof. induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.

Lemma sum_exchange n m (f : nat -> nat -> R) :
  sum n (fun i => sum m (fun j => f i j)) = sum m (fun j => sum n (fun i => f i j)).
Proof.
  induction n as [| n IH]; simpl.
  - symmetry. now apply sum_zero.
  - rewrite IH. clear IH. induction m as [| m IH]; simpl; [| rewrite <- IH]; ring.
Qed.

Lemma Rabs_sum n f : Rabs (sum n f) <= sum n (fun i => Rabs (f i)).
Proof. induction n as [| n IH]; simpl; [rewrite Rabs_R0; lra | pose proof (Rabs_triang (sum n f) (f n)); lra]. Qed.

(** The entries of the identity matrix. *)
Definition unit_entry (i k : nat) : R := if Nat.eqb i k then 1 else 0.

Lemma sum_unit n i (u : point) : (i < n)%nat -> sum n (fun k => unit_entry i k * u k) = u i.
Proof.
  induction n as [| n IH]; intros Hi; [lia |]. simpl. unfold unit_entry at 2.
  destruct (Nat.eqb_spec i n) as [-> | Hn].
  - rewrite sum_zero; [ring |]. intros k Hk. unfold unit_entry. destruct (Nat.eqb_spec n k); [lia | ring].
  - rewrite IH by lia. ring.
Qed.

(** ** A sequence of bounds that tends to zero *)

Lemma powers_vanish q a : 0 <= q < 1 -> is_lim_seq (fun k => q ^ k * a) 0.
Proof.
  intros Hq. replace (Finite 0) with (Rbar_mult 0 a) by (simpl; f_equal; ring).
  apply is_lim_seq_scal_r, is_lim_seq_geom. rewrite Rabs_pos_eq; lra.
Qed.

Lemma zero_if_below_powers q a x : 0 <= q < 1 -> (forall k, Rabs x <= q ^ k * a) -> x = 0.
Proof.
  intros Hq H. destruct (Req_dec x 0) as [| Hx]; [easy |]. exfalso.
  apply (Rabs_no_R0 x Hx), Rle_antisym; [| apply Rabs_pos].
  exact (is_lim_seq_le _ _ _ _ H (is_lim_seq_const (Rabs x)) (powers_vanish q a Hq)).
Qed.

(** ** Banach's theorem in the weighted norm *)

Section Banach.

Variables (n : nat) (r : point).

(** The distance of [x] and [y] is at most [d]. *)
Definition within (d : R) (x y : point) : Prop := forall i, (i < n)%nat -> Rabs (x i - y i) <= d * r i.

Hypothesis radii : forall i, (i < n)%nat -> 0 < r i.

Lemma within_self d x : 0 <= d -> within d x x.
Proof. intros Hd i Hi. specialize (radii i Hi). rewrite Rminus_eq_0, Rabs_R0. apply Rmult_le_pos; lra. Qed.

Lemma within_sym d x y : within d x y -> within d y x.
Proof. intros H i Hi. rewrite Rabs_minus_sym. now apply H. Qed.

Lemma within_trans d e x y z : within d x y -> within e y z -> within (d + e) x z.
Proof.
  intros Hxy Hyz i Hi. specialize (Hxy i Hi). specialize (Hyz i Hi).
  replace (x i - z i) with ((x i - y i) + (y i - z i)) by ring. pose proof (Rabs_triang (x i - y i) (y i - z i)). lra.
Qed.

Lemma same_if_below_powers q a x y : 0 <= q < 1 ->
  (forall k, within (q ^ k * a) x y) -> forall i, (i < n)%nat -> x i = y i.
Proof.
  intros Hq H i Hi. apply Rminus_diag_uniq, (zero_if_below_powers q (a * r i)); [easy |]. intros k.
  specialize (H k i Hi). lra.
Qed.

Variables (c : point) (q : R) (T : point -> point).
Notation box x := (within 1 x c).
Hypothesis factor : 0 <= q < 1.
Hypothesis shrinks : forall d x y, 0 <= d -> box x -> box y -> within d x y -> within (q * d) (T x) (T y).
Hypothesis stays : forall x, box x -> box (T x).

Lemma shrunk_twice d x y k : 0 <= d -> box x -> box y -> within (q ^ k * d) x y -> within (q ^ S k * d) (T x) (T y).
Proof.
  intros Hd Hx Hy H. simpl. rewrite Rmult_assoc. apply shrinks; [| easy | easy | exact H].
  apply Rmult_le_pos; [apply pow_le; lra | easy].
Qed.

(** Two fixed points in the box are the same. *)
Lemma fixed_point_unique x y : box x -> box y -> (forall i, (i < n)%nat -> T x i = x i) ->
  (forall i, (i < n)%nat -> T y i = y i) -> forall i, (i < n)%nat -> x i = y i.
Proof.
  intros Hx Hy Fx Fy. apply (same_if_below_powers q 2); [easy |]. induction k as [| k IH].
  - rewrite Rmult_1_l. replace 2 with (1 + 1) by ring. apply within_trans with c; [easy | now apply within_sym].
  - intros i Hi. rewrite <- (Fx i Hi), <- (Fy i Hi). apply shrunk_twice; auto; lra.
Qed.

Fixpoint iterate (k : nat) : point :=
  match k with
  | O => c
  | S m => T (iterate m)
  end.

Lemma iterate_stays k : box (iterate k).
Proof. induction k as [| k IH]; [apply within_self; lra | now apply stays]. Qed.

(** All later iterates are as near to the [k]-th as the box allows, times [q^k]. *)
Lemma iterate_settles m k : within (q ^ k * 1) (iterate (k + m)) (iterate k).
Proof.
  induction k as [| k IH]; [rewrite Rmult_1_l; apply iterate_stays |].
  apply shrunk_twice; auto using iterate_stays; lra.
Qed.

Lemma iterate_converges i : (i < n)%nat -> ex_finite_lim_seq (fun k => iterate k i).
Proof.
  intros Hi. apply ex_lim_seq_cauchy_corr. intros tolerance. pose proof (powers_vanish q (2 * r i) factor) as small.
  apply is_lim_seq_spec in small. destruct (small tolerance) as [N HN]. exists N. intros k m Hk Hm.
  specialize (HN N (le_n N)). rewrite Rminus_0_r in HN. pose proof (Rle_abs (q ^ N * (2 * r i))).
  pose proof (iterate_settles (k - N) N i Hi) as Ak. pose proof (iterate_settles (m - N) N i Hi) as Am.
  replace (N + (k - N))%nat with k in Ak by lia. replace (N + (m - N))%nat with m in Am by lia.
  replace (iterate k i - iterate m i) with ((iterate k i - iterate N i) - (iterate m i - iterate N i)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra.
Qed.

Definition limit : point := fun i => real (Lim_seq (fun k => iterate k i)).

Lemma limit_near_iterate k : within (q ^ k * 1) limit (iterate k).
Proof.
  intros i Hi. assert (tends : is_lim_seq (fun m => iterate (k + m) i - iterate k i) (limit i - iterate k i)).
  { apply is_lim_seq_minus'; [| apply is_lim_seq_const].
    apply is_lim_seq_ext with (fun m => iterate (m + k) i); [intros m; now rewrite Nat.add_comm |].
    apply (is_lim_seq_incr_n (fun m => iterate m i)). now apply Lim_seq_correct', iterate_converges. }
  exact (is_lim_seq_le _ _ _ _ (fun m => iterate_settles m k i Hi)
           (is_lim_seq_abs _ _ tends) (is_lim_seq_const (q ^ k * 1 * r i))).
Qed.

Theorem fixed_point : box limit /\ (forall i, (i < n)%nat -> T limit i = limit i).
Proof.
  assert (inside : box limit) by (pose proof (limit_near_iterate 0) as H; now rewrite Rmult_1_l in H).
  split; [exact inside |]. apply (same_if_below_powers q (2 * q)); [easy |]. intros k.
  replace (q ^ k * (2 * q)) with (q ^ S k * 1 + q ^ S k * 1) by (simpl; ring).
  apply within_trans with (iterate (S k)); [apply shrunk_twice; auto using iterate_stays, limit_near_iterate; lra
    | apply within_sym, limit_near_iterate].
Qed.

End Banach.

(** Finitely many strict bounds leave room for one factor. *)
Lemma common_factor n (a r : point) : (forall i, (i < n)%nat -> 0 < r i) -> (forall i, (i < n)%nat -> a i < r i) ->
  exists q, 0 <= q < 1 /\ forall i, (i < n)%nat -> a i <= q * r i.
Proof.
  intros radii. induction n as [| n IH]; intros below; [exists 0; split; [lra |]; intros; lia |].
  destruct IH as (q & Hq & Hall); [auto | auto |]. assert (Hr := radii n ltac:(lia)).
  assert (Ha := below n ltac:(lia)). exists (Rmax q (a n / r n)). split.
  - split; [eapply Rle_trans; [apply Hq | apply Rmax_l] |]. apply Rmax_lub_lt; [lra |].
    apply (Rmult_lt_reg_r (r n)); [easy |]. field_simplify; lra.
  - intros i Hi. destruct (Nat.eq_dec i n) as [-> | Hn].
    + apply Rle_trans with (a n / r n * r n); [right; field; lra |]. apply Rmult_le_compat_r; [lra | apply Rmax_r].
    + eapply Rle_trans; [apply Hall; lia |]. apply Rmult_le_compat_r; [apply Rlt_le, radii; lia | apply Rmax_l].
Qed.

(** ** Roots of a system *)

Section System.

Variables (n : nat) (F : nat -> point -> R) (J : nat -> nat -> point -> R) (Y C : nat -> nat -> R) (c r : point).

Notation box x := (within n r 1 x c).
Notation along x u t := (fun i : nat => x i + t * u i).

Hypothesis radii : forall i, (i < n)%nat -> 0 < r i.

(** [J] is the derivative of [F]: along every straight line [x + t u], wherever it is in the box. *)
Hypothesis derivatives : forall j, (j < n)%nat -> forall (x u : point) (t : R), box (along x u t) ->
  is_derive (fun s => F j (along x u s)) t (sum n (fun k => J j k (along x u t) * u k)).

(** |I - Y J| <= C in the box, entry by entry. *)
Hypothesis bounded : forall x, box x -> forall i k, (i < n)%nat -> (k < n)%nat ->
  Rabs (unit_entry i k - sum n (fun j => Y i j * J j k x)) <= C i k.

(** C r + |Y F(c)| < r, row by row. *)
Hypothesis inside : forall i, (i < n)%nat ->
  sum n (fun k => C i k * r k) + Rabs (sum n (fun j => Y i j * F j c)) < r i.

(** [Y] is regular. *)
Hypothesis regular : forall v : point,
  (forall i, (i < n)%nat -> sum n (fun j => Y i j * v j) = 0) -> forall j, (j < n)%nat -> v j = 0.

Definition step (x : point) : point := fun i => x i - sum n (fun j => Y i j * F j x).

Definition solves (x : point) : Prop := forall j, (j < n)%nat -> F j x = 0.

Lemma fixed_if_solves x : solves x -> forall i, (i < n)%nat -> step x i = x i.
Proof. intros Hx i Hi. unfold step. rewrite sum_zero; [ring |]. intros j Hj. rewrite (Hx j Hj). ring. Qed.

Lemma solves_if_fixed x : (forall i, (i < n)%nat -> step x i = x i) -> solves x.
Proof.
  intros Hx j Hj. apply (regular (fun j => F j x)); [| exact Hj]. intros i Hi. specialize (Hx i Hi).
  unfold step in Hx. lra.
Qed.

Lemma is_derive_sum m (g : nat -> R -> R) (g' : nat -> R) t : (forall j, (j < m)%nat -> is_derive (g j) t (g' j)) ->
  is_derive (fun s => sum m (fun j => g j s)) t (sum m g').
Proof.
  induction m as [| m IH]; intros H; simpl; [apply @is_derive_const
    | apply @is_derive_plus; [apply IH; intros |]; apply H; lia].
Qed.

(** The derivative of a component of [T] along a line is that component of [(I - Y J) u]. *)
Lemma step_derivative (x u : point) t i : (i < n)%nat -> box (along x u t) ->
  is_derive (fun s => step (along x u s) i) t
    (sum n (fun k => (unit_entry i k - sum n (fun j => Y i j * J j k (along x u t))) * u k)).
Proof.
  intros Hi Hbox. unfold step.
  replace (sum n (fun k => (unit_entry i k - sum n (fun j => Y i j * J j k (along x u t))) * u k))
    with (u i - sum n (fun j => Y i j * sum n (fun k => J j k (along x u t) * u k))).
  - apply @is_derive_minus.
    + auto_derive; [easy | ring].
    + apply is_derive_sum. intros j Hj. apply is_derive_scal. now apply derivatives.
  - rewrite <- (sum_unit n i u Hi) at 1.
    rewrite (sum_eq n (fun j => Y i j * _) (fun j => sum n (fun k => Y i j * (J j k (along x u t) * u k))))
      by (intros; now rewrite sum_mult). rewrite sum_exchange, <- sum_minus. apply sum_eq. intros k Hk.
    rewrite (sum_eq n _ (fun j => u k * (Y i j * J j k (along x u t)))) by (intros; ring). rewrite sum_mult. ring.
Qed.

Lemma between_in_box x y t : box x -> box y -> 0 <= t <= 1 -> box (along y (fun i => x i - y i) t).
Proof.
  intros Hx Hy Ht i Hi. specialize (Hx i Hi). specialize (Hy i Hi).
  replace (y i + t * (x i - y i) - c i) with (t * (x i - c i) + (1 - t) * (y i - c i)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite !Rabs_mult. rewrite (Rabs_pos_eq t), (Rabs_pos_eq (1 - t)) by lra.
  replace (1 * r i) with (t * (1 * r i) + (1 - t) * (1 * r i)) by ring.
  apply Rplus_le_compat; apply Rmult_le_compat_l; lra.
Qed.

(** How far [T] moves two points apart, by the mean value theorem along the line from [y] to [x]. *)
Lemma step_moves d x y i : 0 <= d -> box x -> box y -> within n r d x y -> (i < n)%nat ->
  Rabs (step x i - step y i) <= d * sum n (fun k => C i k * r k).
Proof.
  intros Hd Hx Hy Hxy Hi. set (u := fun i => x i - y i). set (g := fun s => step (along y u s) i).
  set (g' := fun t => sum n (fun k => (unit_entry i k - sum n (fun j => Y i j * J j k (along y u t))) * u k)).
  assert (slope : forall t, 0 <= t <= 1 -> is_derive g t (g' t)).
  { intros t Ht. apply step_derivative; [easy | now apply between_in_box]. }
  assert (left : Rmin 0 1 = 0) by (apply Rmin_left; lra). assert (right : Rmax 0 1 = 1) by (apply Rmax_right; lra).
  destruct (MVT_gen g 0 1 g') as [t [Ht Hg]].
  { intros t Ht. apply slope. lra. }
  { intros t Ht. apply continuity_pt_filterlim, (ex_derive_continuous g). exists (g' t). apply slope. lra. }
  assert (ends : step x i - step y i = g' t).
  { assert (at_x : along y u 1 = x) by (apply functional_extensionality; intros k; unfold u; ring).
    assert (at_y : along y u 0 = y) by (apply functional_extensionality; intros k; unfold u; ring). unfold g in Hg.
    rewrite at_x, at_y in Hg. rewrite Hg. ring. }
  rewrite ends, <- sum_mult. unfold g'. eapply Rle_trans; [apply Rabs_sum |]. apply sum_le. intros k Hk.
  rewrite Rabs_mult. specialize (Hxy k Hk). fold (u k) in Hxy.
  assert (Hb := bounded (along y u t) ltac:(apply between_in_box; [easy | easy | lra]) i k Hi Hk).
  replace (d * (C i k * r k)) with (C i k * (d * r k)) by ring.
  apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | exact Hb | exact Hxy].
Qed.

Lemma step_stays x : box x -> box (step x).
Proof.
  intros Hx i Hi. assert (centre : box c) by (apply (within_self n r radii); lra).
  replace (step x i - c i) with ((step x i - step c i) - sum n (fun j => Y i j * F j c)) by (unfold step; ring).
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp.
  assert (moved := step_moves 1 x c i ltac:(lra) Hx centre Hx Hi). specialize (inside i Hi). lra.
Qed.

Theorem one_root_by_krawczyk :
  exists x, box x /\ solves x /\ (forall y, box y -> solves y -> forall i, (i < n)%nat -> y i = x i).
Proof.
  destruct (common_factor n (fun i => sum n (fun k => C i k * r k)) r radii) as (q & Hq & contracts).
  { intros i Hi. specialize (inside i Hi). pose proof (Rabs_pos (sum n (fun j => Y i j * F j c))). lra. }
  assert (shrinks : forall d x y, 0 <= d -> box x -> box y -> within n r d x y -> within n r (q * d) (step x) (step y)).
  { intros d x y Hd Hx Hy Hxy i Hi. eapply Rle_trans; [now apply (step_moves d) |].
    replace (q * d * r i) with (d * (q * r i)) by ring. apply Rmult_le_compat_l; [easy | now apply contracts]. }
  destruct (fixed_point n r radii c q step Hq shrinks step_stays) as [Hbox Hfixed]. exists (limit c step).
  split; [exact Hbox | split; [now apply solves_if_fixed |]]. intros y Hy Hsolves.
  now apply (fixed_point_unique n r c q step Hq shrinks); [| | apply fixed_if_solves |].
Qed.

End System.
