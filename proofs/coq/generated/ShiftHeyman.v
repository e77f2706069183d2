(** * The point S: shift point, Heyman's self-weight

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what makes it **the** state of its arch: it is admissible at every joint of
    the half arch, and up to the physical limit the arch stands exactly from that thickness on.  At last
    what follows for the values that the paper prints.  The table of numbers between the claim and the
    theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** What is claimed *)

(** (3); (5); (17); (18); beta_s^2 = h (1 - h). *)
Definition equations (alpha beta_s eta h mu : R) : Prop :=
  h = h_upper 0 alpha beta_s eta /\
  h = h_tangency 0 beta_s eta /\
  mu = mu_ss alpha h /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_s eta h mu : R) : Prop :=
  2.561 <= alpha <= 2.64 /\
  0.223 <= beta_s <= 0.28 /\
  0.867 <= eta <= 1.04 /\
  0.047 <= h <= 0.088 /\
  1.59 <= mu <= 1.94.

(** In this one lies the solution. *)
Definition narrow (alpha beta_s eta h mu : R) : Prop :=
  Rabs (alpha - 2.600211150484513538075196105330454576) <= 1e-30 /\
  Rabs (beta_s - 0.251608196838607690217056034117831508) <= 1e-30 /\
  Rabs (eta - 0.953366396820924820676309027120986123) <= 1e-30 /\
  Rabs (h - 0.067919781425226031995878837870092436) <= 1e-30 /\
  Rabs (mu - 1.765868462744652712229744287085860308) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_s eta h mu : R) : list R :=
  [ ((2 - eta) * cos beta_s - (2 + eta) * cos alpha) * h - ((2 + eta) * alpha * sin alpha - (2 - eta) * beta_s * sin beta_s - 2 * (cos beta_s - cos alpha));
    (2 - eta) * h * sin beta_s - ((sin beta_s + beta_s * cos beta_s) * (2 - eta) - 2 * sin beta_s);
    (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha);
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (alpha beta_s eta h mu : R) : list (list R) :=
  [ [sin alpha * (2 + eta) * h + (2 * sin alpha - ((2 + eta) * sin alpha + cos alpha * ((2 + eta) * alpha)));
     (2 - eta) * sin beta_s + cos beta_s * ((2 - eta) * beta_s) - 2 * sin beta_s - sin beta_s * (2 - eta) * h;
     - ((cos beta_s + cos alpha) * h + (alpha * sin alpha + beta_s * sin beta_s));
     (2 - eta) * cos beta_s - (2 + eta) * cos alpha;
     0];
    [0;
     cos beta_s * ((2 - eta) * h) + (2 * cos beta_s - (cos beta_s + (cos beta_s - sin beta_s * beta_s)) * (2 - eta));
     sin beta_s + beta_s * cos beta_s - h * sin beta_s;
     (2 - eta) * sin beta_s;
     0];
    [(sin alpha + cos alpha * alpha - sin alpha * h) * mu - (cos alpha * h + (sin alpha * alpha - cos alpha));
     0;
     0;
     cos alpha * mu - sin alpha;
     h * cos alpha + alpha * sin alpha];
    [0;
     (cos beta_s * (1 - h) + (cos beta_s - sin beta_s * beta_s)) * mu + (sin beta_s * (1 - h) + (sin beta_s + cos beta_s * beta_s));
     0;
     cos beta_s - sin beta_s * mu;
     (1 - h) * sin beta_s + beta_s * cos beta_s];
    [0;
     2 * beta_s;
     0;
     h - (1 - h);
     0] ].

Definition centre : list R :=
  [ 2.600211150484513538075196105330454576;
    0.251608196838607690217056034117831508;
    0.953366396820924820676309027120986123;
    0.067919781425226031995878837870092436;
    1.765868462744652712229744287085860308 ].
Definition radii : list R :=
  [0.04; 0.029; 0.087; 0.021; 0.18].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.1963197; 0.5819198; 0.0413092; -0.1112953; 0.8156624];
    [-0.0816252; -0.2419489; -0.0967413; 0.2606407; -0.0211526];
    [0.0335973; 2.2015833; 0.0398192; -0.1072809; 0.642525];
    [-0.0475319; -0.1408913; -0.0563343; 0.1517758; -1.1695101];
    [0.7251542; 2.1494615; 0.859445; -0.213522; 1.4743719] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [6.1932868; 0; -1.4101569; 3.5447064; 0];
    [0; 0.0440803; 0.4757383; 0.2605718; 0];
    [-5.2255671; 0; 0; -2.0286654; 1.2817348];
    [0; 3.9184578; 0; 0.5288794; 0.4757383];
    [0; 0.5032164; 0; -0.8641604; 0] ].
Definition spreads : list (list R) :=
  [ [0.78; 0.19; 0.15; 0.25; 0];
    [0; 0.26; 0.07; 0.057; 0];
    [0.78; 0; 0; 0.25; 0.14];
    [0; 0.55; 0; 0.12; 0.066];
    [0; 0.061; 0; 0.045; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 3e-36.
Definition factor : R := 0.76.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb].

Notation box d x := (within 5 (entry radii) d x (entry centre)).

Lemma derivatives j : (j < 5)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum 5 (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < 5)%nat -> (k < 5)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  generalize (bounds Hx 0 ltac:(lia)).
  generalize (bounds Hx 1 ltac:(lia)).
  generalize (bounds Hx 2 ltac:(lia)).
  generalize (bounds Hx 3 ltac:(lia)).
  generalize (bounds Hx 4 ltac:(lia)).
  generalize (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat). clear x Hx.
  cbv [entry centre radii nth]. intros alpha beta_s eta h mu B0 B1 B2 B3 B4.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < 5)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec 140)). Qed.

Lemma contracts i : (i < 5)%nat ->
  sum 5 (fun k =>
    (Rabs (unit_entry i k - sum 5 (fun j => entries inverse i j * entries slopes j k))
     + sum 5 (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < 5)%nat ->
  sum 5 (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-30 * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < 5)%nat ->
  sum 5 (fun k =>
    Rabs (unit_entry j k - sum 5 (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < 5)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box 1e-30 x /\ solves 5 F x /\
  (forall y, box 1 y -> solves 5 F y -> forall i, (i < 5)%nat -> y i = x i).
Proof.
  apply (one_root_from_table 5 F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor 1e-30);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared alpha beta_s eta h mu :
  wide alpha beta_s eta h mu ->
  (equations alpha beta_s eta h mu <-> vanish (residuals alpha beta_s eta h mu)).
Proof.
  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_upper; clearing | intros E0].
  apply both_under; [apply cleared_tangency; clearing | intros E1].
  apply both_under; [apply cleared_shoulder_sliding; clearing | intros E2].
  apply cleared_inner_sliding; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide alpha beta_s eta h mu :
  narrow alpha beta_s eta h mu -> wide alpha beta_s eta h mu.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists alpha beta_s eta h mu,
  narrow alpha beta_s eta h mu /\ equations alpha beta_s eta h mu /\
  (forall alpha' beta_s' eta' h' mu',
     wide alpha' beta_s' eta' h' mu' -> equations alpha' beta_s' eta' h' mu' ->
     alpha' = alpha /\ beta_s' = beta_s /\ eta' = eta /\ h' = h /\ mu' = mu).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat), (x 3%nat), (x 4%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros alpha' beta_s' eta' h' mu' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 5)%nat -> entry [alpha'; beta_s'; eta'; h'; mu'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia | apply (same 3%nat); lia | apply (same 4%nat); lia].
Qed.

Corollary digits alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  narrow alpha beta_s eta h mu.
Proof.
  destruct one_solution as (alpha' & beta_s' & eta' & h' & mu' & N & _ & unique).
  intros W E. specialize (unique alpha beta_s eta h mu W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: what the theorem of each of its modes asks for, and is not zero. *)
Lemma signs alpha beta_s eta h mu : narrow alpha beta_s eta h mu ->
  0 < alpha /\
  alpha < PI /\
  0 < beta_s /\
  beta_s < alpha /\
  0 < eta /\
  eta < 2 /\
  0 < h /\
  h < 1 /\
  0 < mu /\
  0 < normal_force alpha h /\
  at_shoulder 0 alpha eta h < at_crown eta h /\
  0 < (2 - eta) * cos beta_s - (2 + eta) * cos alpha /\
  fac 0 2 * (1 - cos alpha) < 2 * normal_force alpha h.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha beta_s eta h mu : wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  mu_ss alpha h = mu.
Proof.
  intros W E. pose proof (signs alpha beta_s eta h mu (digits alpha beta_s eta h mu W E)) as S.
  unfold equations in E. ties.
Qed.

(** The line of thrust is inside, and friction holds, at every joint, and no thinner arch stands. *)
Theorem state alpha beta_s eta h mu : wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  admissible 0 alpha eta mu h (at_shoulder 0 alpha eta h) /\
  stands_from 0 alpha mu eta.
Proof.
  intros W E. pose proof (signs alpha beta_s eta h mu (digits alpha beta_s eta h mu W E)) as S.
  pose proof (ties alpha beta_s eta h mu W E) as Z.
  unfold equations in E.
  eapply (rotational_sliding 0 alpha mu) with (beta := beta_s) (joint := beta_s); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha beta_s eta h mu, narrow alpha beta_s eta h mu /\
  stands_from 0 alpha mu eta.
Proof.
  destruct one_solution as (alpha & beta_s & eta & h & mu & N & E & _).
  exists alpha, beta_s, eta, h, mu. split; [exact N |].
  exact (proj2 (state alpha beta_s eta h mu (narrow_is_wide alpha beta_s eta h mu N) E)).
Qed.

(** At less friction nothing stands. *)
Theorem less_friction alpha beta_s eta h mu : wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu'.
Proof.
  intros W E. pose proof (signs alpha beta_s eta h mu (digits alpha beta_s eta h mu W E)) as S.
  unfold equations in E.
  apply (purely_sliding alpha mu h beta_s); [tauto | tauto | known ..].
Qed.

(** ** The printed values

    Is the last digit right, that is, the value the nearest of its length? *)

Corollary table_1_thickness_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-17 < Rabs (eta - 0.9533663968209255).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_friction_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-16 < Rabs (mu - 1.765868462744654).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_half_opening_right alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  Rabs (alpha - 2.600211150484514) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_thrust_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-18 < Rabs (h - 0.06791978142522512).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_rotation_joint_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-17 < Rabs (beta_s - 0.2516081968386061).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_sliding_joint_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-17 < Rabs (beta_s - 0.2516081968386061).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.
