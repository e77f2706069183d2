(** * The root of a certificate

    From its boxes and its matrix: that a system has a solution in the small box, and what surrounds it. *)

From Coq Require Import Reals ZArith Lra Lia Bool List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Interval.Interval.
From Couplet Require Import Contraction Enclosures Formulas Krawczyk Equations Certificate.
Import ListNotations.
Open Scope R_scope.

(** Computed once for all names. *)
Definition remembered (E : surroundings) : surroundings :=
  let alpha := E Alpha in let beta_r := E BetaR in let beta_s := E BetaS in
  let eta := E Eta in let h := E Thrust in let mu := E Mu in
  let p := E Moment in let v := E Force in let b0 := E Hinge in
  let slip := E Slip in let inner := E InnerSlip in let opening := E Opening in
  let power := E Power in let joint := E Joint in
  fun n => match n with
    | Alpha => alpha | BetaR => beta_r | BetaS => beta_s | Eta => eta | Thrust => h | Mu => mu
    | Moment => p | Force => v | Hinge => b0 | Slip => slip | InnerSlip => inner | Opening => opening
    | Power => power | Joint => joint
    end.

(** ** Boxes *)

Definition bits (d : dyadic) : Z := Z.log2 (Z.abs (mantissa d)) + 1.
Definition longest (l : list dyadic) : Z := fold_right (fun d n => Z.max (bits d) n) 0%Z l.

Definition are_positive (l : list dyadic) : bool := forallb (fun r => (0 <? mantissa r)%Z) l.

(** All of a box, and its centre: each unknown with its functions. *)
Definition boxes (prec : Z) (unknowns : list name) (b : box) : list functions :=
  map (fun nb => functions_of prec (fst nb) (around prec (fst (snd nb)) (snd (snd nb))))
    (combine unknowns (combine (centre b) (radius b))).
Definition points (prec : Z) (unknowns : list name) (c : list dyadic) : list functions :=
  map (fun nc => functions_of prec (fst nc) (exact (snd nc))) (combine unknowns c).

(** Sine and cosine of a box from those of its centre: they differ by its radius at most. *)
Definition spread (prec : Z) (F : functions) (r : dyadic) : functions :=
  let e := symmetric r in
  let s := I.add prec (sine F) e in
  let c := I.add prec (cosine F) e in
  Functions (I.add prec (itself F) e) s c anything.

(** One box lies inside the other. *)
Definition is_inside (prec : Z) (n : nat) (b B : box) : bool :=
  forallb (fun i =>
    let r := exact (nth i (radius b) nought) in let R := exact (nth i (radius B) nought) in
    let d := I.sub prec (exact (nth i (centre b) nought)) (exact (nth i (centre B) nought)) in
    is_positive (I.sub prec R (I.add prec r (I.abs d)))) (seq 0 n).

(** ** The root *)

Record system := System { unknowns : list name; zeros : list formula; divisors : list formula }.

(** What surrounds the root, if there is one in the small box; [full] bits are enough for it. *)
Definition located (c : certificate) (full : Z) (given : Z -> surroundings) (s : system) : option surroundings :=
  let u := unknowns s in
  let n := length u in
  let wide := (longest (centre (unique c)) + 64)%Z in
  let has_size (b : box) := Nat.eqb (length (centre b)) n && Nat.eqb (length (radius b)) n in
  if negb (distinct u && Nat.eqb (length (zeros s)) n
           && has_size (unique c) && has_size (root c)
           && is_square n (inverse c) && is_regular n (map integers (inverse c))
           && are_positive (radius (unique c)) && are_positive (radius (root c))) then None
  else
    let G := given wide in
    let X := remembered (sited G u (boxes wide u (unique c))) in
    let m := remembered (sited G u (points wide u (centre (unique c)))) in
    if negb (forallb (is_defined X) (zeros s)
             && forallb (fun f => is_not_zero (enclosed wide X f)) (divisors s)) then None
    else
      match bounds wide u (zeros s) (inverse c) X with
      | None => None
      | Some C =>
          if negb (narrows wide u (inverse c) C (map (enclosed wide m) (zeros s)) (radius (unique c))
                   && is_inside full n (root c) (unique c)) then None
          else
            let G := given full in
            let at_m := points full u (centre (root c)) in
            let m := remembered (sited G u at_m) in
            if narrows wide u (inverse c) C (map (enclosed full m) (zeros s)) (radius (root c))
            then
              Some (remembered
                (sited G u (map (fun Fr => spread full (fst Fr) (snd Fr)) (combine at_m (radius (root c))))))
            else None
      end.

(** ** What is found is there *)

(** A test of many conditions, taken apart. *)
Ltac conditions :=
  repeat match goal with
    | H : (_ && _)%bool = true |- _ => apply andb_true_iff in H; destruct H
    | H : negb _ = false |- _ => apply negb_false_iff in H
    | H : Nat.eqb _ _ = true |- _ => apply Nat.eqb_eq in H
    end.

(** Comparisons of integers. *)
Ltac in_integers :=
  repeat match goal with
    | H : (_ <=? _)%Z = true |- _ => apply Z.leb_le in H
    | H : (_ <? _)%Z = true |- _ => apply Z.ltb_lt in H
    end.

Lemma each_one {A} (test : A -> bool) l a : forallb test l = true -> In a l -> test a = true.
Proof. intros H. exact (proj1 (forallb_forall test l) H a). Qed.

Lemma surrounds_remembered E x : surrounds E x -> surrounds (remembered E) x.
Proof. intros HE []; apply HE. Qed.

Section Box.

Variables (prec : Z) (u : list name).
Notation n := (length u).

Lemma surrounds_box G g b x : surrounds G g -> length (centre b) = n -> length (radius b) = n ->
  boxed u (centre b) (radius b) x -> surrounds (remembered (sited G u (boxes prec u b))) (place g u x).
Proof.
  intros HG Hc Hr Hx. apply surrounds_remembered, surrounds_sited; [exact HG | |].
  - unfold boxes. rewrite map_length, !combine_length, Hc, Hr, !Nat.min_id. easy.
  - intros i Hi. unfold boxes.
    set (f := fun nb : name * (dyadic * dyadic) =>
                functions_of prec (fst nb) (around prec (fst (snd nb)) (snd (snd nb)))).
    rewrite (nth_indep _ _ (f (Alpha, (nought, nought))))
      by (rewrite map_length, !combine_length, Hc, Hr, !Nat.min_id; easy).
    rewrite map_nth, !combine_nth by (rewrite ?combine_length, ?Hc, ?Hr, ?Nat.min_id; easy).
    apply covers_functions, has_around. simpl. specialize (Hx i Hi). now rewrite Rmult_1_l in Hx.
Qed.

Lemma points_nth c i : length c = n -> (i < n)%nat ->
  nth i (points prec u c) (plain anything) = functions_of prec (nth i u Alpha) (exact (nth i c nought)).
Proof.
  intros Hc Hi. unfold points. set (f := fun nc : name * dyadic => functions_of prec (fst nc) (exact (snd nc))).
  rewrite (nth_indep _ _ (f (Alpha, nought))) by (rewrite map_length, combine_length, Hc, Nat.min_id; easy).
  now rewrite map_nth, combine_nth by easy.
Qed.

Lemma points_length c : length c = n -> length (points prec u c) = n.
Proof. intros Hc. unfold points. rewrite map_length, combine_length, Hc. apply Nat.min_id. Qed.

Lemma surrounds_centre G g c : surrounds G g -> length c = n ->
  surrounds (remembered (sited G u (points prec u c))) (place g u (entry c)).
Proof.
  intros HG Hc. apply surrounds_remembered, surrounds_sited; [exact HG | now apply points_length |]. intros i Hi.
  rewrite points_nth by easy. apply covers_functions, has_exact.
Qed.

(** Sine and cosine move no faster than the angle. *)
Lemma sine_moves x y : Rabs (sin x - sin y) <= Rabs (x - y).
Proof.
  destruct (MVT_gen sin y x cos) as (t & _ & Ht).
  - intros t _. apply is_derive_sin.
  - intros t _. apply continuity_sin.
  - rewrite Ht, Rabs_mult. destruct (COS_bound t). assert (Rabs (cos t) <= 1) by (apply Rabs_le; lra).
    pose proof (Rabs_pos (x - y)). nra.
Qed.

Lemma cosine_moves x y : Rabs (cos x - cos y) <= Rabs (x - y).
Proof.
  rewrite <- !sin_shift, (Rabs_minus_sym x y). replace (y - x) with ((PI / 2 - x) - (PI / 2 - y)) by ring.
  apply sine_moves.
Qed.

Lemma covers_spread F c r x : covers F c -> Rabs (x - c) <= value r -> covers (spread prec F r) x.
Proof.
  intros (Hc & Hs & Hcos & _) Hx.
  assert (moved : forall X y z, has X y -> Rabs (z - y) <= value r -> has (I.add prec X (symmetric r)) z).
  { intros X y z HX Hz. replace z with (y + (z - y)) by ring. apply has_add; [exact HX |]. now apply has_symmetric. }
  refine (conj (moved _ _ _ Hc Hx) (conj (moved _ _ _ Hs _) (conj (moved _ _ _ Hcos _) _))).
  - eapply Rle_trans; [apply sine_moves | exact Hx].
  - eapply Rle_trans; [apply cosine_moves | exact Hx].
  - apply has_anything.
Qed.

Lemma surrounds_spread G g c r x : surrounds G g -> length c = n -> length r = n -> boxed u c r x ->
  surrounds (remembered
    (sited G u (map (fun Fr => spread prec (fst Fr) (snd Fr)) (combine (points prec u c) r))))
    (place g u x).
Proof.
  intros HG Hc Hr Hx. assert (Hlength := points_length c Hc).
  apply surrounds_remembered, surrounds_sited; [exact HG | |].
  - rewrite map_length, combine_length, Hlength, Hr. apply Nat.min_id.
  - intros i Hi. set (f := fun Fr : functions * dyadic => spread prec (fst Fr) (snd Fr)).
    rewrite (nth_indep _ _ (f (plain anything, nought)))
      by (rewrite map_length, combine_length, Hlength, Hr, Nat.min_id; easy).
    rewrite map_nth, combine_nth, points_nth by congruence. unfold f. simpl fst. simpl snd.
    apply (covers_spread _ (value (nth i c nought))); [apply covers_functions, has_exact
      | specialize (Hx i Hi); now rewrite Rmult_1_l in Hx].
Qed.

Lemma is_inside_sound b B x : is_inside prec n b B = true ->
  boxed u (centre b) (radius b) x -> boxed u (centre B) (radius B) x.
Proof.
  intros Htest Hx i Hi. specialize (Hx i Hi). rewrite Rmult_1_l in Hx |- *.
  apply (each_one _ _ i) in Htest; [| apply in_seq; lia].
  assert (H := is_positive_sound _
    (entry (radius B) i - (entry (radius b) i + Rabs (entry (centre b) i - entry (centre B) i))) Htest).
  assert (0 < entry (radius B) i - (entry (radius b) i + Rabs (entry (centre b) i - entry (centre B) i))).
  { apply H. apply has_sub; [apply has_exact |]. apply has_add; [apply has_exact |].
    apply has_abs, has_sub; apply has_exact. }
  replace (x i - entry (centre B) i)
    with ((x i - entry (centre b) i) + (entry (centre b) i - entry (centre B) i)) by ring.
  eapply Rle_trans; [apply Rabs_triang | lra].
Qed.

End Box.

Lemma are_positive_sound l n i : are_positive l = true -> length l = n -> (i < n)%nat -> 0 < entry l i.
Proof.
  intros Hall <- Hi. apply (each_one _ _ (nth i l nought)) in Hall; [| now apply nth_In]. apply Z.ltb_lt in Hall.
  unfold entry, value. apply Rmult_lt_0_compat; [now apply IZR_lt | apply powerRZ_lt; lra].
Qed.

(** ** The root *)

Lemma place_given g u x n : existsb (same n) u = false -> place g u x n = g n.
Proof.
  revert x. induction u as [| m u IH]; intros x Habsent; [easy |]. simpl in *. apply orb_false_elim in Habsent.
  destruct Habsent as [Hm Hu]. destruct (same_spec m n) as [-> | _]; [| now apply IH]. destruct (same_spec n n); easy.
Qed.

Lemma place_own g u y : (forall n, existsb (same n) u = false -> y n = g n) ->
  forall n, place g u (fun i => y (nth i u Alpha)) n = y n.
Proof.
  intros Hy n. destruct (existsb (same n) u) eqn:Hn; [| now rewrite place_given, Hy]. clear Hy.
  induction u as [| m u IH]; [easy |]. simpl in *. destruct (same_spec m n) as [-> | Hne]; [easy |].
  destruct (same_spec n m); [congruence | now apply IH].
Qed.

Lemma place_alike g u x y n : (forall i, (i < length u)%nat -> x i = y i) -> place g u x n = place g u y n.
Proof.
  revert x y. induction u as [| m u IH]; intros x y Hall; [easy |]. simpl in *.
  destruct (same m n); [apply Hall; lia | apply IH; intros i Hi; apply Hall; lia].
Qed.

Lemma place_entry g u x i : distinct u = true -> (i < length u)%nat -> place g u x (nth i u Alpha) = x i.
Proof.
  revert x i. induction u as [| m u IH]; intros x i Hu Hi; [now apply Nat.nlt_0_r in Hi |]. simpl in *.
  apply andb_true_iff in Hu as [Hm Hu]. apply negb_true_iff in Hm. destruct i as [| i].
  - now destruct (same_spec m m).
  - destruct (same_spec m (nth i u Alpha)) as [Heq | _]; [| apply (IH (fun i => x (S i))); [easy | lia]].
    assert (Hin : existsb (same m) u = true)
      by (apply existsb_exists; exists m; split; [rewrite Heq; apply nth_In; lia | now destruct (same_spec m m)]).
    congruence.
Qed.

Theorem located_sound c full given g s E : (forall prec, surrounds (given prec) g) ->
  located c full given s = Some E -> exists x : configuration, surrounds E x /\
  (forall n, existsb (same n) (unknowns s) = false -> x n = g n) /\ (forall f, In f (zeros s) -> meaning x f = 0 /\
    defined x f) /\ (forall f, In f (divisors s) -> meaning x f <> 0) /\ in_box (unknowns s) (unique c) x /\
  (forall y, in_box (unknowns s) (unique c) y -> (forall n, existsb (same n) (unknowns s) = false -> y n = g n) ->
    (forall f, In f (zeros s) -> meaning y f = 0) -> forall n, y n = x n).
Proof.
  intros Hg. unfold located. set (u := unknowns s). set (n := length u).
  set (wide := (longest (centre (unique c)) + 64)%Z). cbv zeta.
  set (X := remembered (sited (given wide) u (boxes wide u (unique c)))).
  repeat match goal with
    | |- (if ?b then _ else _) = _ -> _ => destruct b eqn:?; try easy
    | |- match ?b with Some _ => _ | None => _ end = _ -> _ => destruct b as [C |] eqn:HC; try easy
    end.
  intros [= <-]. conditions. set (m := remembered (sited (given full) u (points full u (centre (root c))))) in *.
  assert (within : forall x, boxed u (centre (root c)) (radius (root c)) x -> surrounds X (place g u x)).
  { intros x Hx. apply surrounds_box; auto. now apply (is_inside_sound full u (root c) (unique c)). }
  assert (one : forall prec (b : box), (forall x, boxed u (centre b) (radius b) x -> surrounds X (place g u x)) ->
    length (centre b) = n -> length (radius b) = n -> are_positive (radius b) = true ->
    narrows wide u (inverse c) C (map (enclosed prec (remembered (sited (given prec) u (points prec u (centre b)))))
    (zeros s)) (radius b) = true -> exists x, boxed u (centre b) (radius b) x /\
    solves n (residual u (zeros s) g) x /\ forall y, boxed u (centre b) (radius b) y ->
    solves n (residual u (zeros s) g) y -> forall i, (i < n)%nat -> y i = x i).
  { intros prec b Hin Hc Hr Hpositive Hnarrows.
    set (m' := remembered (sited (given prec) u (points prec u (centre b)))) in *.
    apply (one_root wide u (zeros s) (inverse c) g ltac:(easy) C (centre b) (radius b) (map (enclosed prec m') (zeros s)));
      auto.
    - intros y Hy f Hf. apply (is_defined_sound X); [now apply (each_one _ (zeros s)) | now apply Hin].
    - intros y Hy. now apply (bounds_hold wide u (zeros s) (inverse c) g ltac:(easy) X), Hin.
    - intros i Hi. now apply (are_positive_sound _ n).
    - intros j Hj. unfold residual. rewrite (nth_indep _ _ (enclosed prec m' (Int 0))) by (rewrite map_length; lia).
      rewrite map_nth. apply has_meaning, surrounds_centre; auto. }
  destruct (one full (root c)) as (x & Hx & Hsolves & _); auto.
  destruct (one wide (unique c)) as (z & _ & _ & Hz); auto; [intros y Hy; now apply surrounds_box |].
  assert (inside := is_inside_sound full u (root c) (unique c) x ltac:(easy) Hx).
  assert (as_boxed : forall y : configuration, in_box u (unique c) y <->
            boxed u (centre (unique c)) (radius (unique c)) (fun i => y (nth i u Alpha))).
  { intros y. unfold in_box, boxed, Contraction.within, entry.
    split; intros Hb i Hi; specialize (Hb i Hi); now rewrite Rmult_1_l in *. }
  exists (place g u x). refine (conj _ (conj _ (conj _ (conj _ (conj _ _))))).
  - now apply surrounds_spread.
  - intros k Hk. now apply place_given.
  - intros f Hf. split.
    + destruct (In_nth _ _ (Int 0) Hf) as (j & Hj & <-). apply Hsolves. lia.
    + apply (is_defined_sound X); [now apply (each_one _ (zeros s)) | now apply within].
  - intros f Hf. apply (is_not_zero_sound (enclosed wide X f)); [| now apply has_meaning, within].
    now apply (each_one (fun f => is_not_zero (enclosed wide X f)) (divisors s)).
  - apply as_boxed. intros i Hi. rewrite place_entry by easy. now apply inside.
  - intros y Hy Hsame Hzero k. apply as_boxed in Hy. rewrite <- (place_own g u y Hsame k). apply place_alike.
    intros i Hi. rewrite (Hz x inside Hsolves i Hi). apply (Hz (fun i => y (nth i u Alpha))); [exact Hy | | exact Hi].
    intros j Hj. unfold residual. rewrite (functional_extensionality _ _ (place_own g u y Hsame)).
    apply Hzero, nth_In. lia.
Qed.
