(** * The least friction of an arch: [[s,s]], any self-weight

    The printed equations of pure sliding have exactly one solution in a box; here are its digits.  With
    less friction than its [mu] no arch of this half-angle stands, whatever the thickness, the thrust and
    its place in the crown.

    The claims are in the names of [Arch], [FrictionModes] and [States].  The table of numbers between
    them is what [Contraction] asks for.

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import States.
Open Scope R_scope.

(** ** The arch *)

Definition alpha : R := PI / 2.

(** ** What is claimed *)

(** (17); (18); beta_s^2 = h (1 - h). *)
Definition equations (mu h beta_s : R) : Prop :=
  mu = mu_ss alpha h /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (mu h beta_s : R) : Prop :=
  0.211 <= mu <= 0.408 /\
  0.34 <= h <= 0.63 /\
  0.432 <= beta_s <= 0.567.

(** In this one lies the solution. *)
Definition narrow (mu h beta_s : R) : Prop :=
  Rabs (mu - 0.309215444330228612685033707936104794) <= 1e-30 /\
  Rabs (h - 0.485714484142174946857937626996190132) <= 1e-30 /\
  Rabs (beta_s - 0.499795882372670042124496495535132112) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (mu h beta_s : R) : list R :=
  [ (h * cos alpha + alpha * sin alpha) * mu - (h * sin alpha - alpha * cos alpha);
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (mu h beta_s : R) : list (list R) :=
  [ [h * cos alpha + alpha * sin alpha;
     cos alpha * mu - sin alpha;
     0];
    [(1 - h) * sin beta_s + beta_s * cos beta_s;
     cos beta_s - sin beta_s * mu;
     (cos beta_s * (1 - h) + (cos beta_s - sin beta_s * beta_s)) * mu + (sin beta_s * (1 - h) + (sin beta_s + cos beta_s * beta_s))];
    [0;
     h - (1 - h);
     2 * beta_s] ].

Definition centre : list R :=
  [ 0.309215444330228612685033707936104794;
    0.485714484142174946857937626996190132;
    0.499795882372670042124496495535132112 ].
Definition radii : list R :=
  [0.099; 0.15; 0.068].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.4068661; 0.5267554; -0.791129];
    [-0.3608962; 0.8274254; -1.2427024];
    [-0.0103154; 0.02365; 0.9648886] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [1.5707963; -1; 0];
    [0.6851305; 0.72949; 1.5012775];
    [0; -0.028571; 0.9995918] ].
Definition spreads : list (list R) :=
  [ [0.0000001; 0.0000001; 0];
    [0.21; 0.12; 0.5];
    [0; 0.32; 0.15] ].

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
   entry entries nth sum unit_entry Nat.eqb alpha].

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
  cbv [entry centre radii nth]. intros mu h beta_s B0 B1 B2.
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

Lemma cleared mu h beta_s :
  wide mu h beta_s ->
  (equations mu h beta_s <-> vanish (residuals mu h beta_s)).
Proof.
  unfold wide, equations, residuals, alpha; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_shoulder_sliding; clearing | intros E0].
  apply cleared_inner_sliding; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide mu h beta_s :
  narrow mu h beta_s -> wide mu h beta_s.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists mu h beta_s,
  narrow mu h beta_s /\ equations mu h beta_s /\
  (forall mu' h' beta_s',
     wide mu' h' beta_s' -> equations mu' h' beta_s' ->
     mu' = mu /\ h' = h /\ beta_s' = beta_s).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros mu' h' beta_s' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 3)%nat -> entry [mu'; h'; beta_s'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia].
Qed.

Corollary digits mu h beta_s :
  wide mu h beta_s -> equations mu h beta_s ->
  narrow mu h beta_s.
Proof.
  destruct one_solution as (mu' & h' & beta_s' & N & _ & unique).
  intros W E. specialize (unique mu h beta_s W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: the joints that slide, and the friction of the arch. *)
Lemma signs mu h beta_s : narrow mu h beta_s ->
  0 < beta_s /\
  beta_s < alpha /\
  0 < normal_force alpha h /\
  0 < alpha /\
  alpha < PI /\
  0 <= 0.3 /\
  0.3 < mu.
Proof. unfold narrow, alpha. signs. Qed.

(** At less friction nothing stands. *)
Theorem state mu h beta_s : wide mu h beta_s -> equations mu h beta_s ->
  forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu'.
Proof.
  intros W E. pose proof (signs mu h beta_s (digits mu h beta_s W E)) as S.
  unfold equations in E.
  apply (purely_sliding alpha mu h beta_s); [tauto | tauto | known ..].
Qed.

Theorem least_friction : exists mu, Rabs (mu - 0.309215444330228612685033707936104794) <= 1e-30 /\
  (forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu').
Proof.
  destruct one_solution as (mu & h & beta_s & N & E & _).
  exists mu. split; [unfold narrow in N; tauto |].
  exact (state mu h beta_s (narrow_is_wide mu h beta_s N) E).
Qed.

(** That of the certificate is less. *)
Theorem stands_not : stands_at_no_thickness alpha 0.3.
Proof.
  destruct one_solution as (mu & h & beta_s & N & E & _).
  apply (state mu h beta_s (narrow_is_wide mu h beta_s N) E).
  pose proof (signs mu h beta_s N). tauto.
Qed.
