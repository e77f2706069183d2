(** * The point T: triple point, Milankovitch's self-weight

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
  h = h_lower 1 beta_r eta /\
  h = h_whole 1 alpha eta /\
  h = h_tangency 1 beta_r eta /\
  mu = mu_ss alpha h /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_r beta_s eta h mu : R) : Prop :=
  2.407 <= alpha <= 2.454 /\
  1.02 <= beta_r <= 1.065 /\
  0.307 <= beta_s <= 0.33 /\
  0.598 <= eta <= 0.639 /\
  0.105 <= h <= 0.124 /\
  1.204 <= mu <= 1.351.

(** In this one lies the solution. *)
Definition narrow (alpha beta_r beta_s eta h mu : R) : Prop :=
  Rabs (alpha - 2.430069103769348675466472108313614411) <= 1e-30 /\
  Rabs (beta_r - 1.042556808593598844072126150544290437) <= 1e-30 /\
  Rabs (beta_s - 0.318732185304502740470729432219472114) <= 1e-30 /\
  Rabs (eta - 0.618318241074323446374432256517065273) <= 1e-30 /\
  Rabs (h - 0.114760082479740779277603541601717163) <= 1e-30 /\
  Rabs (mu - 1.277021363435197837077818625099227966) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_r beta_s eta h mu : R) : list R :=
  [ (2 + eta - (2 - eta) * cos beta_r) * h - ((2 - eta) * beta_r * sin beta_r - 2 * ((1 - cos beta_r) * (1 + 1/12 * eta ^ 2)));
    (1 - cos alpha) * (2 + eta) * h - (alpha * sin alpha * (2 + eta) - 2 * ((1 + 1/12 * eta ^ 2) * (1 - cos alpha)));
    (2 - eta) * h * sin beta_r - ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * ((1 + 1/12 * eta ^ 2) * sin beta_r));
    (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha);
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (alpha beta_r beta_s eta h mu : R) : list (list R) :=
  [ [0;
     sin beta_r * (2 - eta) * h + (2 * (sin beta_r * (1 + 1/12 * eta ^ 2)) - ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r)));
     0;
     (1 + cos beta_r) * h + (beta_r * sin beta_r + 1/3 * (eta * (1 - cos beta_r)));
     2 + eta - (2 - eta) * cos beta_r;
     0];
    [sin alpha * (2 + eta) * h + (2 * (sin alpha * (1 + 1/12 * eta ^ 2)) - (sin alpha + cos alpha * alpha) * (2 + eta));
     0;
     0;
     (1 - cos alpha) * h + (1/3 * (eta * (1 - cos alpha)) - alpha * sin alpha);
     (1 - cos alpha) * (2 + eta);
     0];
    [0;
     cos beta_r * ((2 - eta) * h) + (2 * (cos beta_r * (1 + 1/12 * eta ^ 2)) - (cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta));
     0;
     sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r) - h * sin beta_r;
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
  [ 2.430069103769348675466472108313614411;
    1.042556808593598844072126150544290437;
    0.318732185304502740470729432219472114;
    0.618318241074323446374432256517065273;
    0.114760082479740779277603541601717163;
    1.277021363435197837077818625099227966 ].
Definition radii : list R :=
  [0.024; 0.023; 0.012; 0.021; 0.01; 0.074].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.3196295; 0.3672341; 0; 0.1831629; -0.4735975; 2.2675483];
    [-1.4080496; -0.1403944; 1.0294153; -0.1688256; 0.4365261; -2.0900531];
    [-0.1188321; -0.1365305; 0; -0.1641792; 0.4245121; -0.4638162];
    [1.0116398; 0.1847233; 0; 0.2221315; -0.5743571; 2.7499774];
    [-0.0983169; -0.1129599; 0; -0.1358354; 0.3512245; -1.6816357];
    [0.7183705; 0.8253622; 0; 0.9925058; -0.8423853; 4.0332756] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [0; 0; 0; 1.1752784; 1.9219318; 0];
    [4.6529628; 0; 0; -1.0229271; 4.6013484; 0];
    [0; 0.9714252; 0; 1.4680537; 1.1933526; 0];
    [-3.8693773; 0; 0; 0; -1.6201634; 1.4998914];
    [0; 0; 3.0521302; 0; 0.5494624; 0.5800801];
    [0; 0; 0.6374644; 0; -0.7704798; 0] ].
Definition spreads : list (list R) :=
  [ [0; 0.15; 0; 0.061; 0.063; 0];
    [0.31; 0; 0; 0.11; 0.083; 0];
    [0; 0.17; 0; 0.067; 0.037; 0];
    [0.31; 0; 0; 0; 0.11; 0.075];
    [0; 0; 0.21; 0; 0.045; 0.028];
    [0; 0; 0.026; 0; 0.022; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 5e-36.
Definition factor : R := 0.9.

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
  fac 1 2 * (1 - cos alpha) < 2 * normal_force alpha h /\
  0 < sin alpha - mu * cos alpha /\
  0 < (2 - eta) * cos beta_r - (2 + eta) * cos alpha /\
  beta_s < beta_r.
Proof. unfold narrow. signs. Qed.

(** What is zero, as other modes or the limit begin here. *)
Lemma ties alpha beta_r beta_s eta h mu : wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  mu_ss alpha h = mu /\
  mu_is h = mu /\
  at_crown eta h = at_shoulder 1 alpha eta h.
Proof.
  intros W E. pose proof (signs alpha beta_r beta_s eta h mu (digits alpha beta_r beta_s eta h mu W E)) as S.
  unfold equations in E. ties.
Qed.

(** The line of thrust is inside, and friction holds, at every joint, and no thinner arch stands. *)
Theorem state alpha beta_r beta_s eta h mu : wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  admissible 1 alpha eta mu h (at_crown eta h) /\
  stands_from 1 alpha mu eta.
Proof.
  intros W E. pose proof (signs alpha beta_r beta_s eta h mu (digits alpha beta_r beta_s eta h mu W E)) as S.
  pose proof (ties alpha beta_r beta_s eta h mu W E) as Z.
  unfold equations in E.
  eapply (rotational 1 alpha mu) with (beta := beta_r); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha beta_r beta_s eta h mu, narrow alpha beta_r beta_s eta h mu /\
  stands_from 1 alpha mu eta.
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

Corollary table_2_thickness_wrong alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  5e-17 < Rabs (eta - 0.6183182410743238).
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_friction_right alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  Rabs (mu - 1.277021363435198) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_half_opening_right alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  Rabs (alpha - 2.430069103769349) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_thrust_right alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  Rabs (h - 0.1147600824797408) <= 5e-17.
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_rotation_joint_wrong alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  5e-16 < Rabs (beta_r - 1.042556808593598).
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.

Corollary table_2_sliding_joint_right alpha beta_r beta_s eta h mu :
  wide alpha beta_r beta_s eta h mu -> equations alpha beta_r beta_s eta h mu ->
  Rabs (beta_s - 0.3187321853045027) <= 5e-17.
Proof. intros W E. apply (digits alpha beta_r beta_s eta h mu W) in E. unfold narrow in E. compare. Qed.
