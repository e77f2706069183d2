(** ** What is claimed *)

(** <<labels>>. *)
Definition equations (<<args>> : R) : Prop :=
  <<equations>>.

(** In this box nothing else solves them. *)
Definition wide (<<args>> : R) : Prop :=
  <<wide>>.

(** In this one lies the solution. *)
Definition narrow (<<args>> : R) : Prop :=
  <<narrow>>.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (<<args>> : R) : list R :=
  [ <<residuals>> ].
Definition jacobian (<<args>> : R) : list (list R) :=
  [ <<jacobian>> ].

Definition centre : list R :=
  [ <<centre>> ].
Definition radii : list R :=
  [<<radii>>].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ <<inverse>> ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ <<slopes>> ].
Definition spreads : list (list R) :=
  [ <<spreads>> ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := <<size>>.
Definition factor : R := <<factor>>.

Definition F (j : nat) (x : point) : R :=
  entry (residuals <<coordinates>>) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian <<coordinates>>) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb].

Notation box d x := (within <<n>> (entry radii) d x (entry centre)).

Lemma derivatives j : (j < <<n>>)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum <<n>> (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < <<n>>)%nat -> (k < <<n>>)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  <<bounds>>
  generalize <<coordinates>>. clear x Hx.
  cbv [entry centre radii nth]. intros <<args>> <<hypotheses>>.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < <<n>>)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec <<precision>>)). Qed.

Lemma contracts i : (i < <<n>>)%nat ->
  sum <<n>> (fun k =>
    (Rabs (unit_entry i k - sum <<n>> (fun j => entries inverse i j * entries slopes j k))
     + sum <<n>> (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < <<n>>)%nat ->
  sum <<n>> (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * <<radius>> * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < <<n>>)%nat ->
  sum <<n>> (fun k =>
    Rabs (unit_entry j k - sum <<n>> (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < <<n>>)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box <<radius>> x /\ solves <<n>> F x /\
  (forall y, box 1 y -> solves <<n>> F y -> forall i, (i < <<n>>)%nat -> y i = x i).
Proof.
  apply (one_root_from_table <<n>> F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor <<radius>>);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared <<args>> :
  wide <<args>> ->
  (equations <<args>> <-> vanish (residuals <<args>>)).
Proof.
  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].
  <<clearing>>
Qed.

(** ** The theorem *)

Lemma narrow_is_wide <<args>> :
  narrow <<args>> -> wide <<args>>.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists <<args>>,
  narrow <<args>> /\ equations <<args>> /\
  (forall <<others>>,
     wide <<others>> -> equations <<others>> ->
     <<equal>>).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists <<witnesses>>.
  assert (N : narrow <<coordinates>>)
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros <<others>> W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < <<n>>)%nat -> entry [<<others_list>>] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [<<same>>].
Qed.

Corollary digits <<args>> :
  wide <<args>> -> equations <<args>> ->
  narrow <<args>>.
Proof.
  destruct one_solution as (<<pattern>> & N & _ & unique).
  intros W E. specialize (unique <<args>> W E). clear W E.
  conjuncts. subst. exact N.
Qed.
