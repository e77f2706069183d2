(** * An arch at its least thickness: [[r]], Milankovitch's self-weight

    The printed equations of its collapse mode have exactly one solution in a box; here are its digits,
    and what makes it **the** state of this arch: it is admissible at every joint of the half arch, and
    up to the physical limit the arch stands exactly from that thickness on.  No thinner arch stands,
    whatever the thrust and its place in the crown.

    The claims are in the names of [Arch], [Contact], [FrictionModes] and [States].  The table of numbers
    between them is what [Contraction] asks for.

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** The arch *)

Definition alpha : R := 2.62.

(** ** What is claimed *)

(** (4). *)
Definition equations (eta : R) : Prop :=
  0 = h_whole 1 alpha eta.

(** In this box nothing else solves them. *)
Definition wide (eta : R) : Prop :=
  0.47 <= eta <= 1.94.

(** In this one lies the solution. *)
Definition narrow (eta : R) : Prop :=
  Rabs (eta - 1.208478914391452733517932086855156362) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (eta : R) : list R :=
  [ 2 * ((1 + 1/12 * eta ^ 2) * (1 - cos alpha)) - alpha * sin alpha * (2 + eta) ].
Definition jacobian (eta : R) : list (list R) :=
  [ [1/3 * (eta * (1 - cos alpha)) - alpha * sin alpha] ].

Definition centre : list R :=
  [ 1.208478914391452733517932086855156362 ].
Definition radii : list R :=
  [0.74].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [-1.8071484] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [-0.553358] ].
Definition spreads : list (list R) :=
  [ [0.49] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 1e-36.
Definition factor : R := 0.89.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb alpha].

Notation box d x := (within 1 (entry radii) d x (entry centre)).

Lemma derivatives j : (j < 1)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum 1 (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < 1)%nat -> (k < 1)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  generalize (bounds Hx 0 ltac:(lia)).
  generalize (x 0%nat). clear x Hx.
  cbv [entry centre radii nth]. intros eta B0.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < 1)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec 140)). Qed.

Lemma contracts i : (i < 1)%nat ->
  sum 1 (fun k =>
    (Rabs (unit_entry i k - sum 1 (fun j => entries inverse i j * entries slopes j k))
     + sum 1 (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < 1)%nat ->
  sum 1 (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-30 * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < 1)%nat ->
  sum 1 (fun k =>
    Rabs (unit_entry j k - sum 1 (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < 1)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box 1e-30 x /\ solves 1 F x /\
  (forall y, box 1 y -> solves 1 F y -> forall i, (i < 1)%nat -> y i = x i).
Proof.
  apply (one_root_from_table 1 F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor 1e-30);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared eta :
  wide eta ->
  (equations eta <-> vanish (residuals eta)).
Proof.
  unfold wide, equations, residuals, alpha; intros W; conjuncts; cbn [vanish].
  apply cleared_whole; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide eta :
  narrow eta -> wide eta.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists eta,
  narrow eta /\ equations eta /\
  (forall eta',
     wide eta' -> equations eta' ->
     eta' = eta).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat).
  assert (N : narrow (x 0%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros eta' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 1)%nat -> entry [eta'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia].
Qed.

Corollary digits eta :
  wide eta -> equations eta ->
  narrow eta.
Proof.
  destruct one_solution as (eta' & N & _ & unique).
  intros W E. specialize (unique eta W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: the ends of the arch and the joints that open or slide. *)
Lemma signs eta : narrow eta ->
  0 < alpha /\
  alpha < PI /\
  0 < normal_force alpha 0 /\
  0 < eta /\
  eta < 2 /\
  intrados eta * (2 - 0) < fac 1 eta /\
  0 < (2 - eta) * cos 0 - (2 + eta) * cos alpha /\
  fac 1 2 * (1 - cos alpha) < 2 * normal_force alpha 0.
Proof. unfold narrow, alpha. signs. Qed.

(** The line of thrust is inside at every joint, and no thinner arch stands. *)
Theorem state eta : wide eta -> equations eta ->
  thrust_inside 1 alpha eta 0 0 /\
  stands_without_limit_from 1 alpha eta.
Proof.
  intros W E. pose proof (signs eta (digits eta W E)) as S.
  unfold equations in E.
  eapply (overturning 1 alpha); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists eta, Rabs (eta - 1.208478914391452733517932086855156362) <= 1e-30 /\
  stands_without_limit_from 1 alpha eta.
Proof.
  destruct one_solution as (eta & N & E & _).
  exists eta. split; [unfold narrow in N; tauto |].
  exact (proj2 (state eta (narrow_is_wide eta N) E)).
Qed.
