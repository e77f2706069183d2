(** * The point l: end of rotation, Milankovitch's self-weight

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what makes it **the** state of its arch: it is admissible at every joint of
    the half arch, and up to the physical limit the arch stands exactly from that thickness on.  At last
    what follows for the values that the paper prints.  The table of numbers between the claim and the
    theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** What is claimed *)

(** (4); (5) at beta_r -> 0. *)
Definition equations (alpha eta : R) : Prop :=
  0 = h_whole 1 alpha eta /\
  0 = end_of_rotation 1 eta.

(** In this box nothing else solves them. *)
Definition wide (alpha eta : R) : Prop :=
  2.29 <= alpha <= 2.9 /\
  0.82 <= eta <= 1.03.

(** In this one lies the solution. *)
Definition narrow (alpha eta : R) : Prop :=
  Rabs (alpha - 2.590843443008954904194295853521347981) <= 1e-30 /\
  Rabs (eta - 0.928203230275509174109785366023489468) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha eta : R) : list R :=
  [ 2 * ((1 + 1/12 * eta ^ 2) * (1 - cos alpha)) - alpha * sin alpha * (2 + eta);
    2 * (1 + 1/12 * eta ^ 2) - 2 * (2 - eta) ].
Definition jacobian (alpha eta : R) : list (list R) :=
  [ [2 * (sin alpha * (1 + 1/12 * eta ^ 2)) - (sin alpha + cos alpha * alpha) * (2 + eta);
     1/3 * (eta * (1 - cos alpha)) - alpha * sin alpha];
    [0;
     1/3 * eta + 2] ].

Definition centre : list R :=
  [ 2.590843443008954904194295853521347981;
    0.928203230275509174109785366023489468 ].
Definition radii : list R :=
  [0.31; 0.11].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.165177; 0.055989];
    [0; 0.4330127] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [6.0541118; -0.7828034];
    [0; 2.3094011] ].
Definition spreads : list (list R) :=
  [ [4.8; 1.3];
    [0; 0.039] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 6e-36.
Definition factor : R := 0.87.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat) (x 1%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat) (x 1%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb].

Notation box d x := (within 2 (entry radii) d x (entry centre)).

Lemma derivatives j : (j < 2)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum 2 (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < 2)%nat -> (k < 2)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  generalize (bounds Hx 0 ltac:(lia)).
  generalize (bounds Hx 1 ltac:(lia)).
  generalize (x 0%nat) (x 1%nat). clear x Hx.
  cbv [entry centre radii nth]. intros alpha eta B0 B1.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < 2)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec 140)). Qed.

Lemma contracts i : (i < 2)%nat ->
  sum 2 (fun k =>
    (Rabs (unit_entry i k - sum 2 (fun j => entries inverse i j * entries slopes j k))
     + sum 2 (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < 2)%nat ->
  sum 2 (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-30 * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < 2)%nat ->
  sum 2 (fun k =>
    Rabs (unit_entry j k - sum 2 (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < 2)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box 1e-30 x /\ solves 2 F x /\
  (forall y, box 1 y -> solves 2 F y -> forall i, (i < 2)%nat -> y i = x i).
Proof.
  apply (one_root_from_table 2 F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor 1e-30);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared alpha eta :
  wide alpha eta ->
  (equations alpha eta <-> vanish (residuals alpha eta)).
Proof.
  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_whole; clearing | intros E0].
  apply cleared_tangency_at_crown; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide alpha eta :
  narrow alpha eta -> wide alpha eta.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists alpha eta,
  narrow alpha eta /\ equations alpha eta /\
  (forall alpha' eta',
     wide alpha' eta' -> equations alpha' eta' ->
     alpha' = alpha /\ eta' = eta).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat).
  assert (N : narrow (x 0%nat) (x 1%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros alpha' eta' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 2)%nat -> entry [alpha'; eta'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia].
Qed.

Corollary digits alpha eta :
  wide alpha eta -> equations alpha eta ->
  narrow alpha eta.
Proof.
  destruct one_solution as (alpha' & eta' & N & _ & unique).
  intros W E. specialize (unique alpha eta W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: what the theorem of each of its modes asks for, and is not zero. *)
Lemma signs alpha eta : narrow alpha eta ->
  0 < alpha /\
  alpha < PI /\
  0 < eta /\
  eta < 2 /\
  0 < normal_force alpha 0 /\
  0 < 1 /\
  fac 1 2 * (1 - cos alpha) < 2 * normal_force alpha 0 /\
  0 < (2 - eta) * cos 0 - (2 + eta) * cos alpha.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha eta : wide alpha eta -> equations alpha eta ->
  intrados eta * (2 - 0) = fac 1 eta.
Proof.
  intros W E. pose proof (signs alpha eta (digits alpha eta W E)) as S.
  unfold equations in E. ties.
Qed.

(** The line of thrust is inside at every joint, and no thinner arch stands. *)
Theorem state alpha eta : wide alpha eta -> equations alpha eta ->
  thrust_inside 1 alpha eta 0 0 /\
  stands_without_limit_from 1 alpha eta.
Proof.
  intros W E. pose proof (signs alpha eta (digits alpha eta W E)) as S.
  pose proof (ties alpha eta W E) as Z.
  unfold equations in E.
  eapply (overturning 1 alpha); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha eta, narrow alpha eta /\
  stands_without_limit_from 1 alpha eta.
Proof.
  destruct one_solution as (alpha & eta & N & E & _).
  exists alpha, eta. split; [exact N |].
  exact (proj2 (state alpha eta (narrow_is_wide alpha eta N) E)).
Qed.

(** ** The printed values

    Is the last digit right, that is, the value the nearest of its length? *)

Corollary table_4_thickness_right alpha eta :
  wide alpha eta -> equations alpha eta ->
  Rabs (eta - 0.9282032302755092) <= 5e-17.
Proof. intros W E. apply (digits alpha eta W) in E. unfold narrow in E. compare. Qed.

Corollary table_4_A_right alpha eta :
  wide alpha eta -> equations alpha eta ->
  Rabs (A alpha - 0.7320508075688773) <= 5e-17.
Proof. intros W E. apply (digits alpha eta W) in E. unfold narrow in E. compare. Qed.

Corollary table_4_half_opening_right alpha eta :
  wide alpha eta -> equations alpha eta ->
  Rabs (alpha - 2.590843443008955) <= 5e-16.
Proof. intros W E. apply (digits alpha eta W) in E. unfold narrow in E. compare. Qed.

Corollary table_4_half_opening_degrees_right alpha eta :
  wide alpha eta -> equations alpha eta ->
  Rabs (180 / PI * alpha - 148.4) <= 0.05.
Proof. intros W E. apply (digits alpha eta W) in E. unfold narrow in E. compare. Qed.
