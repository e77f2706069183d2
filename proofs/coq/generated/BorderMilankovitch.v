(** * The point B: border point, Milankovitch's self-weight

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what makes it **the** state of its arch: it is admissible at every joint of
    the half arch, and up to the physical limit the arch stands exactly from that thickness on.  At last
    what follows for the values that the paper prints.  The table of numbers between the claim and the
    theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** What is claimed *)

(** (3); (17); (18); beta_s^2 = h (1 - h). *)
Definition equations (alpha beta_s h mu : R) : Prop :=
  h = h_upper 1 alpha 0 2 /\
  mu = mu_ss alpha h /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_s h mu : R) : Prop :=
  2.59 <= alpha <= 2.657 /\
  0.163 <= beta_s <= 0.322 /\
  0.007 <= h <= 0.118 /\
  1.55 <= mu <= 2.16.

(** In this one lies the solution. *)
Definition narrow (alpha beta_s h mu : R) : Prop :=
  Rabs (alpha - 2.623074865083552325583875077140612665) <= 1e-30 /\
  Rabs (beta_s - 0.24204173803283023882193983529644889) <= 1e-30 /\
  Rabs (h - 0.062489089221712346251713216810171903) <= 1e-30 /\
  Rabs (mu - 1.853774888450580791376169722459876007) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_s h mu : R) : list R :=
  [ - (4 * (cos alpha * h) + (4 * (alpha * sin alpha) - 8/3 * (1 - cos alpha)));
    (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha);
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (alpha beta_s h mu : R) : list (list R) :=
  [ [4 * (sin alpha * h) - (4 * (sin alpha + cos alpha * alpha) - 8/3 * sin alpha);
     0;
     - (4 * cos alpha);
     0];
    [(sin alpha + cos alpha * alpha - sin alpha * h) * mu - (cos alpha * h + (sin alpha * alpha - cos alpha));
     0;
     cos alpha * mu - sin alpha;
     h * cos alpha + alpha * sin alpha];
    [0;
     (cos beta_s * (1 - h) + (cos beta_s - sin beta_s * beta_s)) * mu + (sin beta_s * (1 - h) + (sin beta_s + cos beta_s * beta_s));
     cos beta_s - sin beta_s * mu;
     (1 - h) * sin beta_s + beta_s * cos beta_s];
    [0;
     2 * beta_s;
     h - (1 - h);
     0] ].

Definition centre : list R :=
  [ 2.623074865083552325583875077140612665;
    0.24204173803283023882193983529644889;
    0.062489089221712346251713216810171903;
    1.853774888450580791376169722459876007 ].
Definition radii : list R :=
  [0.034; 0.08; 0.056; 0.31].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.1287497; 0.0190246; -0.0515539; 0.4343891];
    [-0.0542064; -0.0848894; 0.2300378; 0.1274801];
    [-0.0299883; -0.0469629; 0.1272625; -1.0723036];
    [0.5153197; 0.8070111; -0.0115213; 0.0970776] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [8.5762217; 0; 3.4742188; 0];
    [-5.476375; 0; -2.1056982; 1.2457031];
    [0; 4.0788477; 0.5265279; 0.459694];
    [0; 0.4840835; -0.8750218; 0] ].
Definition spreads : list (list R) :=
  [ [0.67; 0; 0.074; 0];
    [1.1; 0; 0.36; 0.16];
    [0; 1.2; 0.29; 0.19];
    [0; 0.17; 0.12; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 5e-36.
Definition factor : R := 0.89.

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
  cbv [entry centre radii nth]. intros alpha beta_s h mu B0 B1 B2 B3.
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

Lemma cleared alpha beta_s h mu :
  wide alpha beta_s h mu ->
  (equations alpha beta_s h mu <-> vanish (residuals alpha beta_s h mu)).
Proof.
  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_upper; clearing | intros E0].
  apply both_under; [apply cleared_shoulder_sliding; clearing | intros E1].
  apply cleared_inner_sliding; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide alpha beta_s h mu :
  narrow alpha beta_s h mu -> wide alpha beta_s h mu.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists alpha beta_s h mu,
  narrow alpha beta_s h mu /\ equations alpha beta_s h mu /\
  (forall alpha' beta_s' h' mu',
     wide alpha' beta_s' h' mu' -> equations alpha' beta_s' h' mu' ->
     alpha' = alpha /\ beta_s' = beta_s /\ h' = h /\ mu' = mu).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat), (x 3%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros alpha' beta_s' h' mu' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 4)%nat -> entry [alpha'; beta_s'; h'; mu'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia | apply (same 3%nat); lia].
Qed.

Corollary digits alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  narrow alpha beta_s h mu.
Proof.
  destruct one_solution as (alpha' & beta_s' & h' & mu' & N & _ & unique).
  intros W E. specialize (unique alpha beta_s h mu W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: what the theorem of each of its modes asks for, and is not zero. *)
Lemma signs alpha beta_s h mu : narrow alpha beta_s h mu ->
  0 < alpha /\
  alpha < PI /\
  0 < beta_s /\
  beta_s < alpha /\
  0 < h /\
  h < 1 /\
  0 < mu /\
  0 < normal_force alpha h /\
  0 < 2 /\
  intrados 2 * (2 - h) < fac 1 2 /\
  0 < (2 - 2) * cos 0 - (2 + 2) * cos alpha.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha beta_s h mu : wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  mu_ss alpha h = mu /\
  fac 1 2 * (1 - cos alpha) = 2 * normal_force alpha h.
Proof.
  intros W E. pose proof (signs alpha beta_s h mu (digits alpha beta_s h mu W E)) as S.
  unfold equations in E. ties.
Qed.

(** The line of thrust is inside, and friction holds, at every joint, and no thinner arch stands. *)
Theorem state alpha beta_s h mu : wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  admissible 1 alpha 2 mu h (at_shoulder 1 alpha 2 h) /\
  stands_from 1 alpha mu 2.
Proof.
  intros W E. pose proof (signs alpha beta_s h mu (digits alpha beta_s h mu W E)) as S.
  pose proof (ties alpha beta_s h mu W E) as Z.
  unfold equations in E.
  eapply (overturning_sliding 1 alpha mu) with (joint := beta_s); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha beta_s h mu, narrow alpha beta_s h mu /\
  stands_from 1 alpha mu 2.
Proof.
  destruct one_solution as (alpha & beta_s & h & mu & N & E & _).
  exists alpha, beta_s, h, mu. split; [exact N |].
  exact (proj2 (state alpha beta_s h mu (narrow_is_wide alpha beta_s h mu N) E)).
Qed.

(** At less friction nothing stands. *)
Theorem less_friction alpha beta_s h mu : wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu'.
Proof.
  intros W E. pose proof (signs alpha beta_s h mu (digits alpha beta_s h mu W E)) as S.
  unfold equations in E.
  apply (purely_sliding alpha mu h beta_s); [tauto | tauto | known ..].
Qed.

(** ** The printed values

    Is the last digit right, that is, the value the nearest of its length? *)

Corollary table_2_friction_right alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  Rabs (mu - 1.853774888450581) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_half_opening_right alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  Rabs (alpha - 2.623074865083552) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_thrust_wrong alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  5e-18 < Rabs (h - 0.06248908922171234).
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_sliding_joint_right alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  Rabs (beta_s - 0.2420417380328302) <= 5e-17.
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.
