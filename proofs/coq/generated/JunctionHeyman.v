(** * The point J: junction point, Heyman's self-weight

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what makes it **the** state of its arch: it is admissible at every joint of
    the half arch, and up to the physical limit the arch stands exactly from that thickness on.  At last
    what follows for the values that the paper prints.  The table of numbers between the claim and the
    theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** What is claimed *)

(** (3); (5) at beta_r -> 0; (17); (18); beta_s^2 = h (1 - h). *)
Definition equations (alpha beta_s eta h mu : R) : Prop :=
  h = h_upper 0 alpha 0 eta /\
  h = end_of_rotation 0 eta /\
  mu = mu_ss alpha h /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_s eta h mu : R) : Prop :=
  2.55 <= alpha <= 2.657 /\
  0.181 <= beta_s <= 0.32 /\
  0.93 <= eta <= 1.001 /\
  0.005 <= h <= 0.13 /\
  1.52 <= mu <= 2.03.

(** In this one lies the solution. *)
Definition narrow (alpha beta_s eta h mu : R) : Prop :=
  Rabs (alpha - 2.603266515104792749814523154060566601) <= 1e-30 /\
  Rabs (beta_s - 0.250336761122831140143585155102542099) <= 1e-30 /\
  Rabs (eta - 0.965241477208419802744589991555533058) <= 1e-30 /\
  Rabs (h - 0.067181901914290812036928639710403442) <= 1e-30 /\
  Rabs (mu - 1.777213608388235257183196847555738852) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_s eta h mu : R) : list R :=
  [ (2 - eta - (2 + eta) * cos alpha) * h - ((2 + eta) * alpha * sin alpha - 2 * (1 - cos alpha));
    (2 - eta) * h - (2 * (2 - eta) - 2);
    (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha);
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (alpha beta_s eta h mu : R) : list (list R) :=
  [ [sin alpha * (2 + eta) * h + (2 * sin alpha - ((2 + eta) * sin alpha + cos alpha * ((2 + eta) * alpha)));
     0;
     (-1 - cos alpha) * h - alpha * sin alpha;
     2 - eta - (2 + eta) * cos alpha;
     0];
    [0;
     0;
     2 - h;
     2 - eta;
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
  [ 2.603266515104792749814523154060566601;
    0.250336761122831140143585155102542099;
    0.965241477208419802744589991555533058;
    0.067181901914290812036928639710403442;
    1.777213608388235257183196847555738852 ].
Definition radii : list R :=
  [0.054; 0.07; 0.036; 0.063; 0.26].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.1923476; 0.1337698; 0.0378961; -0.1021784; 0.8038972];
    [-0.0801103; -0.0557134; -0.0949958; 0.2561352; -0.0178564];
    [0.0248059; 0.5346308; 0.0294152; -0.0793116; 0.6239906];
    [-0.0463348; -0.032224; -0.0549444; 0.1481455; -1.1655476];
    [0.7179847; 0.4993288; 0.8513959; -0.1842063; 1.4492592] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [6.2348127; 0; -1.3441953; 3.5806202; 0];
    [0; 0; 1.9328181; 1.0347585; 0];
    [-5.2578367; 0; 0; -2.0385584; 1.2770134];
    [0; 3.9390928; 0; 0.5285595; 0.4736208];
    [0; 0.5006735; 0; -0.8656362; 0] ].
Definition spreads : list (list R) :=
  [ [0.87; 0; 0.18; 0.17; 0];
    [0; 0; 0.067; 0.038; 0];
    [1.2; 0; 0; 0.35; 0.23];
    [0; 1.1; 0; 0.24; 0.17];
    [0; 0.15; 0; 0.14; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 3e-36.
Definition factor : R := 0.89.

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
  apply both_under; [apply cleared_tangency_at_crown; clearing | intros E1].
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
  0 < (2 - eta) * cos 0 - (2 + eta) * cos alpha /\
  fac 0 2 * (1 - cos alpha) < 2 * normal_force alpha h.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha beta_s eta h mu : wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  mu_ss alpha h = mu /\
  intrados eta * (2 - h) = fac 0 eta.
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
  eapply (overturning_sliding 0 alpha mu) with (joint := beta_s); [lra | tauto | tauto | known ..].
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
  5e-17 < Rabs (eta - 0.9652414772084208).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_friction_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-16 < Rabs (mu - 1.777213608388237).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_half_opening_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-16 < Rabs (alpha - 2.603266515104794).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_thrust_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-18 < Rabs (h - 0.06718190191428895).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_sliding_joint_wrong alpha beta_s eta h mu :
  wide alpha beta_s eta h mu -> equations alpha beta_s eta h mu ->
  5e-17 < Rabs (beta_s - 0.2503367611228279).
Proof. intros W E. apply (digits alpha beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.
