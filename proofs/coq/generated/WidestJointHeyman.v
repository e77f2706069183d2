(** * The point sb: widest rotational joint, Heyman's self-weight

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what makes it **the** state of its arch: it is admissible at every joint of
    the half arch, and up to the physical limit the arch stands exactly from that thickness on.  At last
    what follows for the values that the paper prints.  The table of numbers between the claim and the
    theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** What is claimed *)

(** (2); (4); (5); d/d eta of (2) = (5). *)
Definition equations (alpha beta_r eta h : R) : Prop :=
  h = h_lower 0 beta_r eta /\
  h = h_whole 0 alpha eta /\
  h = h_tangency 0 beta_r eta /\
  double_thickness 0 beta_r eta.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_r eta h : R) : Prop :=
  2.1 <= alpha <= 2.37 /\
  1.082 <= beta_r <= 1.177 /\
  0.392 <= eta <= 0.451 /\
  0.225 <= h <= 0.308.

(** In this one lies the solution. *)
Definition narrow (alpha beta_r eta h : R) : Prop :=
  Rabs (alpha - 2.230312828619945767618840353057568905) <= 1e-30 /\
  Rabs (beta_r - 1.129085087576186994051896032959304768) <= 1e-30 /\
  Rabs (eta - 0.421414173598685603920346611575470896) <= 1e-30 /\
  Rabs (h - 0.266956770136077484920868551242805036) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_r eta h : R) : list R :=
  [ (2 + eta - (2 - eta) * cos beta_r) * h - ((2 - eta) * beta_r * sin beta_r - 2 * (1 - cos beta_r));
    (1 - cos alpha) * (2 + eta) * h - (alpha * sin alpha * (2 + eta) - 2 * (1 - cos alpha));
    (2 - eta) * h * sin beta_r - ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * sin beta_r);
    (sin beta_r + beta_r * cos beta_r) * (2 + eta - (2 - eta) * cos beta_r) - (1 + cos beta_r) * ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * sin beta_r) - (beta_r * sin beta_r * (2 - eta) + ((2 - eta) * beta_r * sin beta_r - 2 * (1 - cos beta_r))) * sin beta_r ].
Definition jacobian (alpha beta_r eta h : R) : list (list R) :=
  [ [0;
     sin beta_r * (2 - eta) * h + (2 * sin beta_r - ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r)));
     (1 + cos beta_r) * h + beta_r * sin beta_r;
     2 + eta - (2 - eta) * cos beta_r];
    [sin alpha * (2 + eta) * h + (2 * sin alpha - (sin alpha + cos alpha * alpha) * (2 + eta));
     0;
     (1 - cos alpha) * h - alpha * sin alpha;
     (1 - cos alpha) * (2 + eta)];
    [0;
     cos beta_r * ((2 - eta) * h) + (2 * cos beta_r - (cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta));
     sin beta_r + beta_r * cos beta_r - h * sin beta_r;
     (2 - eta) * sin beta_r];
    [0;
     (cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 + eta - (2 - eta) * cos beta_r) + sin beta_r * (2 - eta) * (sin beta_r + beta_r * cos beta_r) + (sin beta_r * ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * sin beta_r) - ((cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta) - 2 * cos beta_r) * (1 + cos beta_r)) - (((sin beta_r + cos beta_r * beta_r) * (2 - eta) + ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r) - 2 * sin beta_r)) * sin beta_r + cos beta_r * (beta_r * sin beta_r * (2 - eta) + ((2 - eta) * beta_r * sin beta_r - 2 * (1 - cos beta_r))));
     (1 + cos beta_r) * (sin beta_r + beta_r * cos beta_r) + (sin beta_r + beta_r * cos beta_r) * (1 + cos beta_r) + (beta_r * sin beta_r + beta_r * sin beta_r) * sin beta_r;
     0] ].

Definition centre : list R :=
  [ 2.230312828619945767618840353057568905;
    1.129085087576186994051896032959304768;
    0.421414173598685603920346611575470896;
    0.266956770136077484920868551242805036 ].
Definition radii : list R :=
  [0.14; 0.048; 0.03; 0.042].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [-0.5833256; 0.2867881; -0.0708483; 0.2206694];
    [-0.6300799; 0; 0.7711511; 0];
    [0.045194; 0; -0.0553127; 0.1722811];
    [0.5362723; 0; 0.0443934; -0.1382711] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [0; 0; 1.4017945; 1.7465891];
    [3.4868951; 0; -1.3320603; 3.905099];
    [0; 1.2967628; 1.1453561; 1.4270755];
    [0; 0.4163395; 5.8044667; 0] ].
Definition spreads : list (list R) :=
  [ [0; 0.34; 0.15; 0.13];
    [1.6; 0; 0.47; 0.37];
    [0; 0.43; 0.15; 0.066];
    [0; 2.2; 0.61; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 6e-36.
Definition factor : R := 0.84.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb].

Notation box d x := (within 4 (entry radii) d x (entry centre)).

Lemma derivatives j : (j < 4)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum 4 (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < 4)%nat -> (k < 4)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  generalize (bounds Hx 0 ltac:(lia)).
  generalize (bounds Hx 1 ltac:(lia)).
  generalize (bounds Hx 2 ltac:(lia)).
  generalize (bounds Hx 3 ltac:(lia)).
  generalize (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat). clear x Hx.
  cbv [entry centre radii nth]. intros alpha beta_r eta h B0 B1 B2 B3.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < 4)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec 140)). Qed.

Lemma contracts i : (i < 4)%nat ->
  sum 4 (fun k =>
    (Rabs (unit_entry i k - sum 4 (fun j => entries inverse i j * entries slopes j k))
     + sum 4 (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < 4)%nat ->
  sum 4 (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-30 * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < 4)%nat ->
  sum 4 (fun k =>
    Rabs (unit_entry j k - sum 4 (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < 4)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box 1e-30 x /\ solves 4 F x /\
  (forall y, box 1 y -> solves 4 F y -> forall i, (i < 4)%nat -> y i = x i).
Proof.
  apply (one_root_from_table 4 F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor 1e-30);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared alpha beta_r eta h :
  wide alpha beta_r eta h ->
  (equations alpha beta_r eta h <-> vanish (residuals alpha beta_r eta h)).
Proof.
  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_lower; clearing | intros E0].
  apply both_under; [apply cleared_whole; clearing | intros E1].
  apply both_under; [apply cleared_tangency; clearing | intros E2].
  apply cleared_double_thickness; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide alpha beta_r eta h :
  narrow alpha beta_r eta h -> wide alpha beta_r eta h.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists alpha beta_r eta h,
  narrow alpha beta_r eta h /\ equations alpha beta_r eta h /\
  (forall alpha' beta_r' eta' h',
     wide alpha' beta_r' eta' h' -> equations alpha' beta_r' eta' h' ->
     alpha' = alpha /\ beta_r' = beta_r /\ eta' = eta /\ h' = h).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat), (x 3%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros alpha' beta_r' eta' h' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 4)%nat -> entry [alpha'; beta_r'; eta'; h'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia | apply (same 3%nat); lia].
Qed.

Corollary digits alpha beta_r eta h :
  wide alpha beta_r eta h -> equations alpha beta_r eta h ->
  narrow alpha beta_r eta h.
Proof.
  destruct one_solution as (alpha' & beta_r' & eta' & h' & N & _ & unique).
  intros W E. specialize (unique alpha beta_r eta h W E). clear W E.
  conjuncts. subst. exact N.
Qed.

Corollary radicand_vanishes alpha beta_r eta h :
  wide alpha beta_r eta h -> equations alpha beta_r eta h ->
  radicand 0 (f_of beta_r) (g_of beta_r) (sin beta_r) = 0.
Proof.
  unfold wide, equations. intros W E. conjuncts.
  apply radicand_at_double_thickness with eta; try assumption; clearing.
Qed.

(** ** The state *)

(** What is left to look at: what the theorem of each of its modes asks for, and is not zero. *)
Lemma signs alpha beta_r eta h : narrow alpha beta_r eta h ->
  0 < alpha /\
  alpha < PI /\
  0 < beta_r /\
  beta_r < alpha /\
  0 < eta /\
  eta < 2 /\
  0 < h /\
  h < 1 /\
  0 < normal_force alpha h /\
  fac 0 2 * (1 - cos alpha) < 2 * normal_force alpha h.
Proof. unfold narrow. signs. Qed.

(** The line of thrust is inside at every joint, and no thinner arch stands. *)
Theorem state alpha beta_r eta h : wide alpha beta_r eta h -> equations alpha beta_r eta h ->
  thrust_inside 0 alpha eta h (at_crown eta h) /\
  stands_without_limit_from 0 alpha eta.
Proof.
  intros W E. pose proof (signs alpha beta_r eta h (digits alpha beta_r eta h W E)) as S.
  unfold equations in E.
  eapply (rotational_without_limit 0 alpha) with (beta := beta_r); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha beta_r eta h, narrow alpha beta_r eta h /\
  stands_without_limit_from 0 alpha eta.
Proof.
  destruct one_solution as (alpha & beta_r & eta & h & N & E & _).
  exists alpha, beta_r, eta, h. split; [exact N |].
  exact (proj2 (state alpha beta_r eta h (narrow_is_wide alpha beta_r eta h N) E)).
Qed.
