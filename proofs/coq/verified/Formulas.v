(** * Formulas: what they mean, their partial derivatives, and enclosures of both

    The residuals of the equations and the signs of a state are polynomials in the unknowns and in their sines and
    cosines; (5) has a cotangent as well.  So a formula is a tree of such terms.  An enclosure is computed from those of
    the unknowns and of their functions, which are computed once. *)

From Coq Require Import Reals ZArith Lra Lia Bool List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Interval.Interval Real.Xreal.
From Couplet Require Import Contraction Enclosures.
Import ListNotations.
Open Scope R_scope.

(** ** Names *)

(** The numbers of a state: half opening, joint that opens and joint that slides, thickness, thrust,
    friction; of an asymmetric one besides the moment of the thrust and the vertical force at the crown, the
    hinge next to it, the rates at which the shoulder slips, an inner joint slips and the shoulder opens, and
    the power of friction; and any joint. *)
Inductive name :=
  | Alpha | BetaR | BetaS | Eta | Thrust | Mu
  | Moment | Force | Hinge | Slip | InnerSlip | Opening | Power | Joint.

Definition same (a b : name) : bool :=
  match a, b with
  | Alpha, Alpha | BetaR, BetaR | BetaS, BetaS | Eta, Eta | Thrust, Thrust | Mu, Mu | Moment, Moment
  | Force, Force | Hinge, Hinge | Slip, Slip | InnerSlip, InnerSlip | Opening, Opening | Power, Power
  | Joint, Joint => true
  | _, _ => false
  end.

Lemma same_spec (a b : name) : reflect (a = b) (same a b).
Proof. destruct a, b; constructor; easy. Qed.

(** A number for each. *)
Definition configuration := name -> R.

(** ** Formulas *)

Inductive formula :=
  | Int (z : Z) | Ratio (p : Z) (q : positive)
  | Val (n : name) | Sin (n : name) | Cos (n : name) | Cot (n : name)
  | Opp (f : formula)
  | Add (f g : formula) | Sub (f g : formula) | Mul (f g : formula).

Declare Scope formula_scope.
Delimit Scope formula_scope with formula.
Bind Scope formula_scope with formula.
Notation "- f" := (Opp f) : formula_scope.
Notation "f + g" := (Add f g) : formula_scope.
Notation "f - g" := (Sub f g) : formula_scope.
Notation "f * g" := (Mul f g) : formula_scope.
Arguments Int z%Z.
Notation "0" := (Int 0) : formula_scope.
Notation "1" := (Int 1) : formula_scope.
Notation "2" := (Int 2) : formula_scope.

Fixpoint meaning (x : configuration) (f : formula) : R :=
  match f with
  | Int z => IZR z
  | Ratio p q => IZR p / IZR (Zpos q)
  | Val n => x n
  | Sin n => sin (x n)
  | Cos n => cos (x n)
  | Cot n => cos (x n) / sin (x n)
  | Opp f => - meaning x f
  | Add f g => meaning x f + meaning x g
  | Sub f g => meaning x f - meaning x g
  | Mul f g => meaning x f * meaning x g
  end.

(** Only the names in it matter. *)
Fixpoint mentions (n : name) (f : formula) : bool :=
  match f with
  | Int _ | Ratio _ _ => false
  | Val m | Sin m | Cos m | Cot m => same m n
  | Opp f => mentions n f
  | Add f g | Sub f g | Mul f g => mentions n f || mentions n g
  end.

Lemma meaning_alike x y f : (forall n, mentions n f = true -> x n = y n) -> meaning x f = meaning y f.
Proof.
  induction f; intros Hall; cbn [meaning mentions] in *; try easy;
    try (rewrite Hall by (now destruct (same_spec n n)); easy);
    rewrite ?IHf, ?IHf1, ?IHf2; try easy; intros n Hn; apply Hall; rewrite ?Hn, ?orb_true_r; easy.
Qed.

(** The sines by which it divides. *)
Fixpoint divides (f : formula) : list name :=
  match f with
  | Cot n => [n]
  | Opp f => divides f
  | Add f g | Sub f g | Mul f g => divides f ++ divides g
  | _ => []
  end.

Definition defined (x : configuration) (f : formula) : Prop := forall n, In n (divides f) -> sin (x n) <> 0.

(** ** Partial derivatives *)

(** Products and sums in which a derivative is often zero. *)
Definition is_nil (f : formula) : bool := match f with Int Z0 => true | _ => false end.
Definition add0 (f g : formula) : formula := if is_nil f then g else if is_nil g then f else Add f g.
Definition sub0 (f g : formula) : formula := if is_nil g then f else if is_nil f then Opp g else Sub f g.
Definition mul0 (f g : formula) : formula := if is_nil f || is_nil g then Int 0 else Mul f g.
Definition opp0 (f : formula) : formula := if is_nil f then Int 0 else Opp f.

Fixpoint slope (k : name) (f : formula) : formula :=
  match f with
  | Int _ | Ratio _ _ => Int 0
  | Val n => if same n k then Int 1 else Int 0
  | Sin n => if same n k then Cos n else Int 0
  | Cos n => if same n k then Opp (Sin n) else Int 0
  | Cot n => if same n k then Opp (Add (Int 1) (Mul (Cot n) (Cot n))) else Int 0
  | Opp f => opp0 (slope k f)
  | Add f g => add0 (slope k f) (slope k g)
  | Sub f g => sub0 (slope k f) (slope k g)
  | Mul f g => add0 (mul0 (slope k f) g) (mul0 f (slope k g))
  end.

Lemma meaning_nil x f : is_nil f = true -> meaning x f = 0.
Proof. now destruct f as [[] | | | | | | | | |]. Qed.

Ltac of_nils x f g :=
  destruct (is_nil f) eqn:Hf, (is_nil g) eqn:Hg; try apply (meaning_nil x) in Hf; try apply (meaning_nil x) in Hg;
  simpl; rewrite ?Hf, ?Hg; ring.

Lemma meaning_add x f g : meaning x (add0 f g) = meaning x f + meaning x g.
Proof. unfold add0. of_nils x f g. Qed.

Lemma meaning_sub x f g : meaning x (sub0 f g) = meaning x f - meaning x g.
Proof. unfold sub0. of_nils x f g. Qed.

Lemma meaning_mul x f g : meaning x (mul0 f g) = meaning x f * meaning x g.
Proof. unfold mul0. of_nils x f g. Qed.

Lemma meaning_opp x f : meaning x (opp0 f) = - meaning x f.
Proof. unfold opp0. destruct (is_nil f) eqn:Hf; [rewrite (meaning_nil x f Hf); simpl; ring | easy]. Qed.

(** ** Unknowns *)

(** A system solves for some of the numbers; the others are given. *)
Fixpoint place (given : configuration) (unknowns : list name) (x : point) : configuration :=
  match unknowns with
  | [] => given
  | n :: rest => fun m => if same n m then x 0%nat else place given rest (fun i => x (S i)) m
  end.

Fixpoint distinct (names : list name) : bool :=
  match names with
  | [] => true
  | n :: rest => negb (existsb (same n) rest) && distinct rest
  end.

Lemma sum_shift n f : Contraction.sum (S n) f = f 0%nat + Contraction.sum n (fun i => f (S i)).
Proof.
  induction n as [| n IH]; [simpl; ring |].
  change (Contraction.sum (S (S n)) f) with (Contraction.sum (S n) f + f (S n)). rewrite IH. simpl. ring.
Qed.

(** Along a line a number moves as its unknown does, and not at all if it is given. *)
Definition rate (unknowns : list name) (u : point) (n : name) : R :=
  Contraction.sum (length unknowns)
    (fun k => (if same n (nth k unknowns Alpha) then 1 else 0) * u k).

Lemma rate_absent rest u n : existsb (same n) rest = false -> rate rest u n = 0.
Proof.
  revert u. induction rest as [| m rest IH]; intros u Habsent; [easy |]. simpl in Habsent.
  apply orb_false_elim in Habsent. destruct Habsent as [Hm Hrest]. unfold rate. simpl length. rewrite sum_shift.
  simpl nth. rewrite Hm. change (Contraction.sum _ _) with (rate rest (fun i => u (S i)) n). rewrite IH by easy. ring.
Qed.

Lemma place_moves given unknowns (x u : point) n s : distinct unknowns = true ->
  place given unknowns (fun i => x i + s * u i) n = place given unknowns x n + s * rate unknowns u n.
Proof.
  revert x u. induction unknowns as [| m rest IH]; intros x u Hdistinct.
  - unfold rate. simpl. ring.
  - simpl in Hdistinct. apply andb_true_iff in Hdistinct. destruct Hdistinct as [Hm Hrest]. apply negb_true_iff in Hm.
    unfold rate. simpl length. rewrite sum_shift. simpl nth. simpl place.
    change (Contraction.sum _ _) with (rate rest (fun i => u (S i)) n). destruct (same_spec m n) as [-> | Hne].
    + rewrite rate_absent by easy. destruct (same_spec n n); [ring | easy].
    + destruct (same_spec n m) as [Heq | _]; [now symmetry in Heq |].
      rewrite (IH (fun i => x (S i)) (fun i => u (S i))) by easy. ring.
Qed.

(** The derivative of a formula along a line. *)
Lemma slope_along given unknowns (x u : point) (t : R) f : distinct unknowns = true ->
  defined (place given unknowns (fun i => x i + t * u i)) f ->
  is_derive (fun s => meaning (place given unknowns (fun i => x i + s * u i)) f) t
    (Contraction.sum (length unknowns)
       (fun k => meaning (place given unknowns (fun i => x i + t * u i))
                         (slope (nth k unknowns Alpha) f) * u k)).
Proof.
  intros Hdistinct. set (n := length unknowns). set (at_ s := place given unknowns (fun i => x i + s * u i)).
  assert (moves : forall m, is_derive (fun s => at_ s m) t (rate unknowns u m)).
  { intros m. apply (is_derive_ext (fun s => place given unknowns x m + s * rate unknowns u m)).
    - intros s. unfold at_. now rewrite place_moves.
    - auto_derive; [easy | ring]. }
  assert (leaf : forall m (d : R) (F : formula), (forall k, meaning (at_ t) (if same m k then F else Int 0)
    = if same m k then d else 0) -> Contraction.sum n (fun k => meaning (at_ t)
    (if same m (nth k unknowns Alpha) then F else Int 0) * u k) = d * rate unknowns u m).
  { intros m d F HF. unfold rate. fold n. rewrite <- sum_mult. apply sum_eq. intros k Hk. rewrite HF.
    destruct (same m _); ring. }
  assert (choice : forall (b : bool) (F : formula) (d : R), meaning (at_ t) F = d ->
            meaning (at_ t) (if b then F else Int 0) = if b then d else 0).
  { now intros [] F d HF. }
  assert (value_is : forall (f : R -> R) (d e : R), is_derive f t d -> d = e -> is_derive f t e)
    by (intros f0 d e Hd <-; exact Hd). change (place given unknowns (fun i => x i + t * u i)) with (at_ t).
  induction f as [z | p q | m | m | m | m | f IH | f IHf g IHg | f IHf g IHg | f IHf g IHg];
    intros Hdefined; simpl slope.
  8-10: assert (Hf : defined (at_ t) f) by (intros o Ho; apply Hdefined; simpl; apply in_or_app; tauto).
  8-10: assert (Hg : defined (at_ t) g) by (intros o Ho; apply Hdefined; simpl; apply in_or_app; tauto).
  - apply (value_is _ 0); [exact (is_derive_const (IZR z) t) |]. symmetry. apply sum_zero. intros k _. simpl. ring.
  - apply (value_is _ 0); [exact (is_derive_const (IZR p / IZR (Zpos q)) t) |]. symmetry. apply sum_zero. intros k _.
    simpl. ring.
  - apply (value_is _ _ _ (moves m)). rewrite (leaf m 1); [ring |]. intros k. now apply choice.
  - apply (value_is _ _ _ (is_derive_comp sin (fun s => at_ s m) t _ _ (is_derive_sin _) (moves m))).
    rewrite (leaf m (cos (at_ t m))); [apply Rmult_comm |]. intros k. now apply choice.
  - apply (value_is _ _ _ (is_derive_comp cos (fun s => at_ s m) t _ _ (is_derive_cos _) (moves m))).
    rewrite (leaf m (- sin (at_ t m))); [apply Rmult_comm |]. intros k. now apply choice.
  - assert (Hs : sin (at_ t m) <> 0) by (apply Hdefined; simpl; tauto).
    set (d := - (1 + cos (at_ t m) / sin (at_ t m) * (cos (at_ t m) / sin (at_ t m)))).
    assert (Hd : is_derive (fun y => cos y / sin y) (at_ t m) d).
    { unfold d. auto_derive; [easy |]. field. easy. }
    apply (value_is _ _ _ (is_derive_comp (fun y => cos y / sin y) (fun s => at_ s m) t _ _ Hd (moves m))).
    rewrite (leaf m d); [apply Rmult_comm |]. intros k. apply choice. unfold d. simpl. field. easy.
  - apply (value_is _ _ _ (is_derive_opp _ _ _ (IH Hdefined))). change (opp ?a) with (- a).
    rewrite <- (Rmult_1_l (Contraction.sum _ _)), Ropp_mult_distr_l, <- sum_mult. apply sum_eq. intros k _.
    rewrite meaning_opp. ring.
  - apply (value_is _ _ _ (is_derive_plus _ _ _ _ _ (IHf Hf) (IHg Hg))). change (plus ?a ?b) with (a + b).
    rewrite <- sum_plus. apply sum_eq. intros k _. rewrite meaning_add. ring.
  - apply (value_is _ _ _ (is_derive_minus _ _ _ _ _ (IHf Hf) (IHg Hg))). change (minus ?a ?b) with (a - b).
    rewrite <- sum_minus. apply sum_eq. intros k _. rewrite meaning_sub. ring.
  - apply (value_is _ _ _ (is_derive_mult _ _ _ _ _ (IHf Hf) (IHg Hg) Rmult_comm)). change (plus ?a ?b) with (a + b).
    change (mult ?a ?b) with (a * b). rewrite (Rmult_comm (Contraction.sum _ _)), <- !sum_mult, <- sum_plus.
    apply sum_eq. intros k _. rewrite meaning_add, !meaning_mul. unfold at_. ring.
Qed.

(** ** Enclosures *)

(** A number and its functions. *)
Record functions := Functions {
  itself : enclosure; sine : enclosure; cosine : enclosure; cotangent : enclosure }.

Definition covers (X : functions) (x : R) : Prop :=
  has (itself X) x /\ has (sine X) (sin x) /\ has (cosine X) (cos x) /\
  has (cotangent X) (cos x / sin x).

(** Those of each number of a configuration. *)
Definition surroundings := name -> functions.
Definition surrounds (E : surroundings) (x : configuration) : Prop := forall n, covers (E n) (x n).

Section Enclosed.

Variable prec : I.precision.

(** Of a number whose functions nobody asks for, *)
Definition plain (X : enclosure) : functions := Functions X anything anything anything.

Lemma covers_plain X x : has X x -> covers (plain X) x.
Proof. intros Hx. refine (conj Hx (conj _ (conj _ _))); apply has_anything. Qed.

(** of an angle, *)
Definition angle (X : enclosure) : functions := Functions X (I.sin prec X) (I.cos prec X) anything.

Lemma covers_angle X x : has X x -> covers (angle X) x.
Proof.
  intros Hx. refine (conj Hx (conj _ (conj _ _))); [now apply has_sin | now apply has_cos | apply has_anything].
Qed.

(** and of one with its cotangent. *)
Definition angle_with_cotangent (X : enclosure) : functions :=
  let s := I.sin prec X in let c := I.cos prec X in Functions X s c (I.div prec c s).

Lemma covers_angle_with_cotangent X x : has X x -> covers (angle_with_cotangent X) x.
Proof.
  intros Hx. assert (Hs := has_sin prec X x Hx). assert (Hc := has_cos prec X x Hx).
  refine (conj Hx (conj Hs (conj Hc _))). now apply has_div.
Qed.

(** What is asked for is known from the name. *)
Definition functions_of (n : name) (X : enclosure) : functions :=
  match n with
  | Alpha | Hinge => angle X
  | BetaR | BetaS => angle_with_cotangent X
  | _ => plain X
  end.

Lemma covers_functions n X x : has X x -> covers (functions_of n X) x.
Proof. intros Hx. destruct n; simpl; auto using covers_plain, covers_angle, covers_angle_with_cotangent. Qed.

Fixpoint sited (given : surroundings) (unknowns : list name) (X : list functions) : surroundings :=
  match unknowns, X with
  | n :: rest, F :: others => fun m => if same n m then F else sited given rest others m
  | _, _ => given
  end.

Lemma surrounds_sited G given unknowns X x : surrounds G given -> length X = length unknowns ->
  (forall i, (i < length unknowns)%nat -> covers (nth i X (plain anything)) (x i)) ->
  surrounds (sited G unknowns X) (place given unknowns x).
Proof.
  intros HG. revert X x. induction unknowns as [| n rest IH]; intros X x Hlength Hall m.
  - destruct X; [apply HG | easy].
  - destruct X as [| F others]; [easy |]. simpl. destruct (same n m).
    + exact (Hall 0%nat ltac:(simpl; lia)).
    + apply IH; [now injection Hlength |]. intros i Hi. apply (Hall (S i)). simpl. lia.
Qed.

Fixpoint enclosed (E : surroundings) (f : formula) : enclosure :=
  match f with
  | Int z => integer prec z
  | Ratio p q => I.div prec (integer prec p) (integer prec (Zpos q))
  | Val n => itself (E n)
  | Sin n => sine (E n)
  | Cos n => cosine (E n)
  | Cot n => cotangent (E n)
  | Opp f => I.neg (enclosed E f)
  | Add f g => I.add prec (enclosed E f) (enclosed E g)
  | Sub f g => I.sub prec (enclosed E f) (enclosed E g)
  | Mul f g => I.mul prec (enclosed E f) (enclosed E g)
  end.

Theorem has_meaning E x f : surrounds E x -> has (enclosed E f) (meaning x f).
Proof.
  intros HE. induction f; cbn [enclosed meaning]; try apply HE; [apply has_integer | apply has_div; apply has_integer
    | now apply has_neg | now apply has_add | now apply has_sub | now apply has_mul].
Qed.

(** No formula divides by a sine that may be zero. *)
Definition is_defined (E : surroundings) (f : formula) : bool :=
  forallb (fun n => is_not_zero (sine (E n))) (divides f).

Lemma is_defined_sound E x f : is_defined E f = true -> surrounds E x -> defined x f.
Proof.
  intros Hall HE n Hn. apply (proj1 (forallb_forall _ _)) with (x := n) in Hall; [| exact Hn].
  apply (is_not_zero_sound _ _ Hall), HE.
Qed.

End Enclosed.
