(** * The point T: triple point, Heyman's self-weight

    The equations of the landmark as the paper prints them, the box in which they have exactly one
    solution, its digits, and what makes it **the** state of its arch: it is admissible at every joint of
    the half arch, and up to the physical limit the arch stands exactly from that thickness on.  At last
    what follows for the values that the paper prints.  The table of numbers between the claim and the
    theorem is what [Contraction] asks for.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** What is claimed *)

(** (2); (4); (5); (17); (18); beta_s^2 = h (1 - h). *)
Definition equations (alpha beta_r beta_s eta h mu : R) : Prop :=
  h = h_lower 0 beta_r eta /\
  h = h_whole 0 alpha eta /\
  h = h_tangency 0 beta_r eta /\
  mu = mu_ss alpha h /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_r beta_s eta h mu : R) : Prop :=
  2.466 <= alpha <= 2.509 /\
  1.015 <= beta_r <= 1.06 /\
  0.286 <= beta_s <= 0.309 /\
  0.66 <= eta <= 0.699 /\
  0.0889 <= h <= 0.1068 /\
  1.337 <= mu <= 1.494.

(** In this one lies the solution. *)
Definition narrow (alpha beta_r beta_s eta h mu : R) : Prop :=
  Rabs (alpha - 2.487161163767181653012592142022701431) <= 1e-30 /\
  Rabs (beta_r - 1.037485213550072354936837293229760044) <= 1e-30 /\
  Rabs (beta_s - 0.297051916410146152643560060593360392) <= 1e-30 /\
  Rabs (eta - 0.67960473209888551478753489620968411) <= 1e-30 /\
  Rabs (h - 0.097805819339638452214665565824976141) <= 1e-30 /\
  Rabs (mu - 1.415270827756885046883080205106552137) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_r beta_s eta h mu : R) : list R :=
  [ (2 + eta - (2 - eta) * cos beta_r) * h - ((2 - eta) * beta_r * sin beta_r - 2 * (1 - cos beta_r));
    (1 - cos alpha) * (2 + eta) * h - (alpha * sin alpha * (2 + eta) - 2 * (1 - cos alpha));
    (2 - eta) * h * sin beta_r - ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * sin beta_r);
    (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha);
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (alpha beta_r beta_s eta h mu : R) : list (list R) :=
  [ [0;
     sin beta_r * (2 - eta) * h + (2 * sin beta_r - ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r)));
     0;
     (1 + cos beta_r) * h + beta_r * sin beta_r;
     2 + eta - (2 - eta) * cos beta_r;
     0];
    [sin alpha * (2 + eta) * h + (2 * sin alpha - (sin alpha + cos alpha * alpha) * (2 + eta));
     0;
     0;
     (1 - cos alpha) * h - alpha * sin alpha;
     (1 - cos alpha) * (2 + eta);
     0];
    [0;
     cos beta_r * ((2 - eta) * h) + (2 * cos beta_r - (cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta));
     0;
     sin beta_r + beta_r * cos beta_r - h * sin beta_r;
     (2 - eta) * sin beta_r;
     0];
    [(sin alpha + cos alpha * alpha - sin alpha * h) * mu - (cos alpha * h + (sin alpha * alpha - cos alpha));
     0;
     0;
     0;
     cos alpha * mu - sin alpha;
     h * cos alpha + alpha * sin alpha];
    [0;
     0;
     (cos beta_s * (1 - h) + (cos beta_s - sin beta_s * beta_s)) * mu + (sin beta_s * (1 - h) + (sin beta_s + cos beta_s * beta_s));
     0;
     cos beta_s - sin beta_s * mu;
     (1 - h) * sin beta_s + beta_s * cos beta_s];
    [0;
     0;
     2 * beta_s;
     0;
     h - (1 - h);
     0] ].

Definition centre : list R :=
  [ 2.487161163767181653012592142022701431;
    1.037485213550072354936837293229760044;
    0.297051916410146152643560060593360392;
    0.67960473209888551478753489620968411;
    0.097805819339638452214665565824976141;
    1.415270827756885046883080205106552137 ].
Definition radii : list R :=
  [0.022; 0.023; 0.012; 0.02; 0.009; 0.079].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.4405538; 0.3426009; 0; 0.1706569; -0.4472118; 2.4780382];
    [-1.5518764; -0.1471139; 1.0875046; -0.1744291; 0.4570972; -2.5328137];
    [-0.1707299; -0.1327697; 0; -0.1574216; 0.4125283; -0.6026463];
    [1.2039589; 0.1891937; 0; 0.224322; -0.587843; 3.2572876];
    [-0.1260974; -0.0980608; 0; -0.1162682; 0.3046844; -1.688282];
    [1.1500796; 0.8943704; 0; 1.0604315; -0.9544653; 5.2887723] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [0; 0; 0; 1.0409371; 2.0083324; 0];
    [5.0335112; 0; 0; -1.3385512; 4.8055874; 0];
    [0; 0.9195363; 0; 1.3043495; 1.13703; 0];
    [-4.2452751; 0; 0; 0; -1.7315758; 1.4363571];
    [0; 0; 3.291979; 0; 0.5419502; 0.5481166];
    [0; 0; 0.5941038; 0; -0.8043884; 0] ].
Definition spreads : list (list R) :=
  [ [0; 0.14; 0; 0.051; 0.06; 0];
    [0.29; 0; 0; 0.08; 0.077; 0];
    [0; 0.16; 0; 0.057; 0.035; 0];
    [0.33; 0; 0; 0; 0.11; 0.07];
    [0; 0; 0.22; 0; 0.047; 0.028];
    [0; 0; 0.026; 0; 0.019; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 3e-36.
Definition factor : R := 0.89.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb].

Notation box d x := (within 6 (entry radii) d x (entry centre)).

Lemma derivatives j : (j < 6)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum 6 (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < 6)%nat -> (k < 6)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  generalize (bounds Hx 0 ltac:(lia)).
  generalize (bounds Hx 1 ltac:(lia)).
  generalize (bounds Hx 2 ltac:(lia)).
  generalize (bounds Hx 3 ltac:(lia)).
  generalize (bounds Hx 4 ltac:(lia)).
  generalize (bounds Hx 5 ltac:(lia)).
  generalize (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat). clear x Hx.
  cbv [entry centre radii nth]. intros alpha beta_r beta_s eta h mu B0 B1 B2 B3 B4 B5.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < 6)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec 140)). Qed.

Lemma contracts i : (i < 6)%nat ->
  sum 6 (fun k =>
    (Rabs (unit_entry i k - sum 6 (fun j => entries inverse i j * entries slopes j k))
     + sum 6 (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < 6)%nat ->
  sum 6 (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-30 * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < 6)%nat ->
  sum 6 (fun k =>
    Rabs (unit_entry j k - sum 6 (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < 6)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box 1e-30 x /\ solves 6 F x /\
  (forall y, box 1 y -> solves 6 F y -> forall i, (i < 6)%nat -> y i = x i).
Proof.
  apply (one_root_from_table 6 F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor 1e-30);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu ->
  (equations alpha beta_r beta_s eta h mu <-> vanish (residuals alpha beta_r beta_s eta h mu)).
Proof.
  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_lower; clearing | intros E0].
  apply both_under; [apply cleared_whole; clearing | intros E1].
  apply both_under; [apply cleared_tangency; clearing | intros E2].
  apply both_under; [apply cleared_shoulder_sliding; clearing | intros E3].
  apply cleared_inner_sliding; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide alpha beta_r beta_s eta h mu :
  narrow alpha beta_r beta_s eta h mu -> wide alpha beta_r beta_s eta h mu.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists alpha beta_r beta_s eta h mu,
  narrow alpha beta_r beta_s eta h mu /\ equations alpha beta_r beta_s eta h mu /\
  (forall alpha' beta_r' beta_s' eta' h' mu',
     wide alpha' beta_r' beta_s' eta' h' mu' -> equations alpha' beta_r' beta_s' eta' h' mu' ->
     alpha' = alpha /\ beta_r' = beta_r /\ beta_s' = beta_s /\ eta' = eta /\ h' = h /\ mu' = mu).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat), (x 3%nat), (x 4%nat), (x 5%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros alpha' beta_r' beta_s' eta' h' mu' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 6)%nat -> entry [alpha'; beta_r'; beta_s'; eta'; h'; mu'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia | apply (same 3%nat); lia | apply (same 4%nat); lia | apply (same 5%nat); lia].
Qed.

Corollary digits alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  narrow alpha beta_r beta_s eta h mu.
Proof.
  destruct one_solution as (alpha' & beta_r' & beta_s' & eta' & h' & mu' & N & _ & unique).
  intros W E. specialize (unique alpha beta_r beta_s eta h mu W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: what the theorem of each of its modes asks for, and is not zero. *)
Lemma signs alpha beta_r beta_s eta h mu : narrow alpha beta_r beta_s eta h mu ->
  0 < alpha /\
  alpha < PI /\
  0 < beta_r /\
  beta_r < alpha /\
  0 < beta_s /\
  beta_s < alpha /\
  0 < eta /\
  eta < 2 /\
  0 < h /\
  h < 1 /\
  0 < mu /\
  0 < normal_force alpha h /\
  Arch.beta_s h < alpha /\
  fac 0 2 * (1 - cos alpha) < 2 * normal_force alpha h /\
  0 < sin alpha - mu * cos alpha /\
  0 < (2 - eta) * cos beta_r - (2 + eta) * cos alpha /\
  beta_s < beta_r.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha beta_r beta_s eta h mu : wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  mu_ss alpha h = mu /\
  mu_is h = mu /\
  at_crown eta h = at_shoulder 0 alpha eta h.
Proof.
  intros W E. pose proof (signs alpha beta_r beta_s eta h mu (digits alpha beta_r beta_s eta h mu W E)) as S.
  unfold equations in E. ties.
Qed.

(** The line of thrust is inside, and friction holds, at every joint, and no thinner arch stands. *)
Theorem state alpha beta_r beta_s eta h mu : wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  admissible 0 alpha eta mu h (at_crown eta h) /\
  stands_from 0 alpha mu eta.
Proof.
  intros W E. pose proof (signs alpha beta_r beta_s eta h mu (digits alpha beta_r beta_s eta h mu W E)) as S.
  pose proof (ties alpha beta_r beta_s eta h mu W E) as Z.
  unfold equations in E.
  eapply (rotational 0 alpha mu) with (beta := beta_r); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha beta_r beta_s eta h mu, narrow alpha beta_r beta_s eta h mu /\
  stands_from 0 alpha mu eta.
Proof.
  destruct one_solution as (alpha & beta_r & beta_s & eta & h & mu & N & E & _).
  exists alpha, beta_r, beta_s, eta, h, mu. split; [exact N |].
  exact (proj2 (state alpha beta_r beta_s eta h mu (narrow_is_wide alpha beta_r beta_s eta h mu N) E)).
Qed.

(** At less friction nothing stands. *)
Theorem less_friction alpha beta_r beta_s eta h mu : wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu'.
Proof.
  intros W E. pose proof (signs alpha beta_r beta_s eta h mu (digits alpha beta_r beta_s eta h mu W E)) as S.
  unfold equations in E.
  apply (purely_sliding alpha mu h beta_s); [tauto | tauto | known ..].
Qed.

(** ** The printed values

    Is the last digit right, that is, the value the nearest of its length? *)

Corollary table_1_thickness_wrong alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  5e-17 < Rabs (eta - 0.6796047320988860).
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_friction_wrong alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  5e-16 < Rabs (mu - 1.415270827756886).
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_half_opening_right alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  Rabs (alpha - 2.487161163767182) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_thrust_wrong alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  5e-18 < Rabs (h - 0.09780581933963814).
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_rotation_joint_right alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  Rabs (beta_r - 1.037485213550072) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_1_sliding_joint_wrong alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  5e-17 < Rabs (beta_s - 0.2970519164101457).
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.
