(** * An arch at its least thickness: [[r,r,r]], Milankovitch's self-weight

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

Definition alpha : R := PI / 2.
Definition mu : R := 0.5.

(** ** What is claimed *)

(** (2); (4); (5). *)
Definition equations (beta_r eta h : R) : Prop :=
  h = h_lower 1 beta_r eta /\
  h = h_whole 1 alpha eta /\
  h = h_tangency 1 beta_r eta.

(** In this box nothing else solves them. *)
Definition wide (beta_r eta h : R) : Prop :=
  0.89 <= beta_r <= 1.011 /\
  0.091 <= eta <= 0.124 /\
  0.6133 <= h <= 0.6284.

(** In this one lies the solution. *)
Definition narrow (beta_r eta h : R) : Prop :=
  Rabs (beta_r - 0.950924736464500277957538204918847011) <= 1e-30 /\
  Rabs (eta - 0.107478038107476313306661592329791385) <= 1e-30 /\
  Rabs (h - 0.620881206171871975730069927696990323) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (beta_r eta h : R) : list R :=
  [ (2 + eta - (2 - eta) * cos beta_r) * h - ((2 - eta) * beta_r * sin beta_r - 2 * ((1 - cos beta_r) * (1 + 1/12 * eta ^ 2)));
    (1 - cos alpha) * (2 + eta) * h - (alpha * sin alpha * (2 + eta) - 2 * ((1 + 1/12 * eta ^ 2) * (1 - cos alpha)));
    (2 - eta) * h * sin beta_r - ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * ((1 + 1/12 * eta ^ 2) * sin beta_r)) ].
Definition jacobian (beta_r eta h : R) : list (list R) :=
  [ [sin beta_r * (2 - eta) * h + (2 * (sin beta_r * (1 + 1/12 * eta ^ 2)) - ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r)));
     (1 + cos beta_r) * h + (beta_r * sin beta_r + 1/3 * (eta * (1 - cos beta_r)));
     2 + eta - (2 - eta) * cos beta_r];
    [0;
     (1 - cos alpha) * h + (1/3 * (eta * (1 - cos alpha)) - alpha * sin alpha);
     (1 - cos alpha) * (2 + eta)];
    [cos beta_r * ((2 - eta) * h) + (2 * (cos beta_r * (1 + 1/12 * eta ^ 2)) - (cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta));
     sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r) - h * sin beta_r;
     (2 - eta) * sin beta_r] ].

Definition centre : list R :=
  [ 0.950924736464500277957538204918847011;
    0.107478038107476313306661592329791385;
    0.620881206171871975730069927696990323 ].
Definition radii : list R :=
  [0.061; 0.017; 0.0076].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [-0.6349672; -0.3538481; 0.8996279];
    [0.4529352; -0.2166491; 0];
    [0.1964543; 0.3805323; 0] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [0; 1.7705918; 1.008054];
    [0; -0.9140891; 2.107478];
    [1.1115707; 0.8901669; 1.540424] ].
Definition spreads : list (list R) :=
  [ [0.43; 0.15; 0.14];
    [0; 0.014; 0.018];
    [0.58; 0.17; 0.09] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 2e-36.
Definition factor : R := 0.89.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat) (x 1%nat) (x 2%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat) (x 1%nat) (x 2%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb alpha mu].

Notation box d x := (within 3 (entry radii) d x (entry centre)).

Lemma derivatives j : (j < 3)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum 3 (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < 3)%nat -> (k < 3)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  generalize (bounds Hx 0 ltac:(lia)).
  generalize (bounds Hx 1 ltac:(lia)).
  generalize (bounds Hx 2 ltac:(lia)).
  generalize (x 0%nat) (x 1%nat) (x 2%nat). clear x Hx.
  cbv [entry centre radii nth]. intros beta_r eta h B0 B1 B2.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < 3)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec 140)). Qed.

Lemma contracts i : (i < 3)%nat ->
  sum 3 (fun k =>
    (Rabs (unit_entry i k - sum 3 (fun j => entries inverse i j * entries slopes j k))
     + sum 3 (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < 3)%nat ->
  sum 3 (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-30 * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < 3)%nat ->
  sum 3 (fun k =>
    Rabs (unit_entry j k - sum 3 (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < 3)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box 1e-30 x /\ solves 3 F x /\
  (forall y, box 1 y -> solves 3 F y -> forall i, (i < 3)%nat -> y i = x i).
Proof.
  apply (one_root_from_table 3 F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor 1e-30);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared beta_r eta h :
  wide beta_r eta h ->
  (equations beta_r eta h <-> vanish (residuals beta_r eta h)).
Proof.
  unfold wide, equations, residuals, alpha, mu; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_lower; clearing | intros E0].
  apply both_under; [apply cleared_whole; clearing | intros E1].
  apply cleared_tangency; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide beta_r eta h :
  narrow beta_r eta h -> wide beta_r eta h.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists beta_r eta h,
  narrow beta_r eta h /\ equations beta_r eta h /\
  (forall beta_r' eta' h',
     wide beta_r' eta' h' -> equations beta_r' eta' h' ->
     beta_r' = beta_r /\ eta' = eta /\ h' = h).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros beta_r' eta' h' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 3)%nat -> entry [beta_r'; eta'; h'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia].
Qed.

Corollary digits beta_r eta h :
  wide beta_r eta h -> equations beta_r eta h ->
  narrow beta_r eta h.
Proof.
  destruct one_solution as (beta_r' & eta' & h' & N & _ & unique).
  intros W E. specialize (unique beta_r eta h W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: the ends of the arch and the joints that open or slide. *)
Lemma signs beta_r eta h : narrow beta_r eta h ->
  0 < alpha /\
  alpha < PI /\
  0 < normal_force alpha h /\
  0 < eta /\
  eta < 2 /\
  0 < h /\
  h < 1 /\
  0 < beta_r /\
  beta_r < alpha /\
  Arch.beta_s h < alpha /\
  mu_ss alpha h < mu /\
  mu_is h < mu /\
  fac 1 2 * (1 - cos alpha) < 2 * normal_force alpha h.
Proof. unfold narrow, alpha, mu. signs. Qed.

(** The line of thrust is inside, and friction holds, at every joint, and no thinner arch stands. *)
Theorem state beta_r eta h : wide beta_r eta h -> equations beta_r eta h ->
  admissible 1 alpha eta mu h (at_crown eta h) /\
  stands_from 1 alpha mu eta.
Proof.
  intros W E. pose proof (signs beta_r eta h (digits beta_r eta h W E)) as S.
  unfold equations in E.
  eapply (rotational 1 alpha mu) with (beta := beta_r); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists eta, Rabs (eta - 0.107478038107476313306661592329791385) <= 1e-30 /\
  stands_from 1 alpha mu eta.
Proof.
  destruct one_solution as (beta_r & eta & h & N & E & _).
  exists eta. split; [unfold narrow in N; tauto |].
  exact (proj2 (state beta_r eta h (narrow_is_wide beta_r eta h N) E)).
Qed.
