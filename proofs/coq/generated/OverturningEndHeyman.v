(** * The point L: end of overturning, Heyman's self-weight

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what makes it **the** state of its arch: it is admissible at every joint of
    the half arch, and up to the physical limit the arch stands exactly from that thickness on.  At last
    what follows for the values that the paper prints.  The table of numbers between the claim and the
    theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** What is claimed *)

(** (4). *)
Definition equations (alpha : R) : Prop :=
  0 = h_whole 0 alpha 2.

(** In this box nothing else solves them. *)
Definition wide (alpha : R) : Prop :=
  2.33 <= alpha <= 3.24.

(** In this one lies the solution. *)
Definition narrow (alpha : R) : Prop :=
  Rabs (alpha - 2.786498150651177032042156673942213066) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha : R) : list R :=
  [ 2 * (1 - cos alpha) - 4 * (alpha * sin alpha) ].
Definition jacobian (alpha : R) : list (list R) :=
  [ [2 * sin alpha - 4 * (sin alpha + cos alpha * alpha)] ].

Definition centre : list R :=
  [ 2.786498150651177032042156673942213066 ].
Definition radii : list R :=
  [0.46].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.1025086] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [9.7552767] ].
Definition spreads : list (list R) :=
  [ [8.4] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 8e-36.
Definition factor : R := 0.87.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb].

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
  cbv [entry centre radii nth]. intros alpha B0.
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

Lemma cleared alpha :
  wide alpha ->
  (equations alpha <-> vanish (residuals alpha)).
Proof.
  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].
  apply cleared_whole; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide alpha :
  narrow alpha -> wide alpha.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists alpha,
  narrow alpha /\ equations alpha /\
  (forall alpha',
     wide alpha' -> equations alpha' ->
     alpha' = alpha).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat).
  assert (N : narrow (x 0%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros alpha' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 1)%nat -> entry [alpha'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia].
Qed.

Corollary digits alpha :
  wide alpha -> equations alpha ->
  narrow alpha.
Proof.
  destruct one_solution as (alpha' & N & _ & unique).
  intros W E. specialize (unique alpha W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: what the theorem of each of its modes asks for, and is not zero. *)
Lemma signs alpha : narrow alpha ->
  0 < alpha /\
  alpha < PI /\
  0 < normal_force alpha 0 /\
  0 < 2 /\
  intrados 2 * (2 - 0) < fac 0 2 /\
  0 < (2 - 2) * cos 0 - (2 + 2) * cos alpha.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha : wide alpha -> equations alpha ->
  fac 0 2 * (1 - cos alpha) = 2 * normal_force alpha 0.
Proof.
  intros W E. pose proof (signs alpha (digits alpha W E)) as S.
  unfold equations in E. ties.
Qed.

(** The line of thrust is inside at every joint, and no thinner arch stands. *)
Theorem state alpha : wide alpha -> equations alpha ->
  thrust_inside 0 alpha 2 0 0 /\
  stands_without_limit_from 0 alpha 2.
Proof.
  intros W E. pose proof (signs alpha (digits alpha W E)) as S.
  pose proof (ties alpha W E) as Z.
  unfold equations in E.
  eapply (overturning 0 alpha); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha, narrow alpha /\
  stands_without_limit_from 0 alpha 2.
Proof.
  destruct one_solution as (alpha & N & E & _).
  exists alpha. split; [exact N |].
  exact (proj2 (state alpha (narrow_is_wide alpha N) E)).
Qed.

(** ** The printed values

    Is the last digit right, that is, the value the nearest of its length? *)

Corollary table_3_A_right alpha :
  wide alpha -> equations alpha ->
  Rabs (A alpha - 0.5) <= 0.05.
Proof. intros W E. apply (digits alpha W) in E. unfold narrow in E. compare. Qed.

Corollary table_3_half_opening_right alpha :
  wide alpha -> equations alpha ->
  Rabs (alpha - 2.786498150651177) <= 5e-16.
Proof. intros W E. apply (digits alpha W) in E. unfold narrow in E. compare. Qed.

Corollary table_3_half_opening_degrees_right alpha :
  wide alpha -> equations alpha ->
  Rabs (180 / PI * alpha - 159.7) <= 0.05.
Proof. intros W E. apply (digits alpha W) in E. unfold narrow in E. compare. Qed.
