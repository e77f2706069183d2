(** * The point B: border point, Heyman's self-weight

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
  h = h_upper 0 alpha 0 2 /\
  mu = mu_ss alpha h /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_s h mu : R) : Prop :=
  2.759 <= alpha <= 2.79 /\
  0.112 <= beta_s <= 0.241 /\
  0.001 <= h <= 0.064 /\
  2.3 <= mu <= 3.09.

(** In this one lies the solution. *)
Definition narrow (alpha beta_s h mu : R) : Prop :=
  Rabs (alpha - 2.774176793356033265242390916035499667) <= 1e-30 /\
  Rabs (beta_s - 0.176012667650840456741777030274936813) <= 1e-30 /\
  Rabs (h - 0.032004764098570356599256093888968766) <= 1e-30 /\
  Rabs (mu - 2.690297881776621269028013655346458687) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_s h mu : R) : list R :=
  [ - (4 * (cos alpha * h) + (4 * (alpha * sin alpha) - 2 * (1 - cos alpha)));
    (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha);
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (alpha beta_s h mu : R) : list (list R) :=
  [ [4 * (sin alpha * h) - (4 * (sin alpha + cos alpha * alpha) - 2 * sin alpha);
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
  [ 2.774176793356033265242390916035499667;
    0.176012667650840456741777030274936813;
    0.032004764098570356599256093888968766;
    2.690297881776621269028013655346458687 ].
Definition radii : list R :=
  [0.016; 0.065; 0.032; 0.4].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.110506; 0.0088407; -0.0249293; 0.3999507];
    [-0.0499317; -0.0609761; 0.1719437; 0.0821468];
    [-0.0187793; -0.0229331; 0.0646679; -1.0374916];
    [0.850774; 1.0389577; -0.0125058; 0.2006349] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [9.6836736; 0; 3.7330348; 0];
    [-7.9296955; 0; -2.8699489; 0.9666293];
    [0; 5.6476746; 0.5134644; 0.3427943];
    [0; 0.3520253; -0.9359905; 0] ].
Definition spreads : list (list R) :=
  [ [0.28; 0; 0.025; 0];
    [1.3; 0; 0.43; 0.082];
    [0; 1.3; 0.3; 0.15];
    [0; 0.14; 0.068; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 1e-35.
Definition factor : R := 0.73.

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
  intrados 2 * (2 - h) < fac 0 2 /\
  0 < (2 - 2) * cos 0 - (2 + 2) * cos alpha.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha beta_s h mu : wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  mu_ss alpha h = mu /\
  fac 0 2 * (1 - cos alpha) = 2 * normal_force alpha h.
Proof.
  intros W E. pose proof (signs alpha beta_s h mu (digits alpha beta_s h mu W E)) as S.
  unfold equations in E. ties.
Qed.

(** The line of thrust is inside, and friction holds, at every joint, and no thinner arch stands. *)
Theorem state alpha beta_s h mu : wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  admissible 0 alpha 2 mu h (at_shoulder 0 alpha 2 h) /\
  stands_from 0 alpha mu 2.
Proof.
  intros W E. pose proof (signs alpha beta_s h mu (digits alpha beta_s h mu W E)) as S.
  pose proof (ties alpha beta_s h mu W E) as Z.
  unfold equations in E.
  eapply (overturning_sliding 0 alpha mu) with (joint := beta_s); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha beta_s h mu, narrow alpha beta_s h mu /\
  stands_from 0 alpha mu 2.
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

Corollary table_1_friction_wrong alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  5e-16 < Rabs (mu - 2.690297881776622).
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_half_opening_wrong alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  5e-16 < Rabs (alpha - 2.774176793356034).
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_thrust_right alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  Rabs (h - 0.03200476409857036) <= 5e-18.
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_sliding_joint_right alpha beta_s h mu :
  wide alpha beta_s h mu -> equations alpha beta_s h mu ->
  Rabs (beta_s - 0.1760126676508405) <= 5e-17.
Proof. intros W E. apply (digits alpha beta_s h mu W) in E. unfold narrow in E. compare. Qed.
