(** * An arch at its least thickness: [[r,r,s]], Milankovitch's self-weight

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

Definition alpha : R := 2.45.
Definition mu : R := 1.35.

(** ** What is claimed *)

(** (3); (5); (18); beta_s^2 = h (1 - h). *)
Definition equations (beta_r eta h beta_s : R) : Prop :=
  h = h_upper 1 alpha beta_r eta /\
  h = h_tangency 1 beta_r eta /\
  mu = mu_is h /\
  beta_s = Arch.beta_s h.

(** In this box nothing else solves them. *)
Definition wide (beta_r eta h beta_s : R) : Prop :=
  0.953 <= beta_r <= 1.054 /\
  0.618 <= eta <= 0.683 /\
  0.1001 <= h <= 0.1106 /\
  0.292 <= beta_s <= 0.321.

(** In this one lies the solution. *)
Definition narrow (beta_r eta h beta_s : R) : Prop :=
  Rabs (beta_r - 1.003615310565860388115777054340430586) <= 1e-30 /\
  Rabs (eta - 0.650243780801383172790041106182161871) <= 1e-30 /\
  Rabs (h - 0.105343417540891550592461472844863688) <= 1e-30 /\
  Rabs (beta_s - 0.306995410261614388468836037496394531) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (beta_r eta h beta_s : R) : list R :=
  [ ((2 - eta) * cos beta_r - (2 + eta) * cos alpha) * h - ((2 + eta) * alpha * sin alpha - (2 - eta) * beta_r * sin beta_r - 2 * ((cos beta_r - cos alpha) * (1 + 1/12 * eta ^ 2)));
    (2 - eta) * h * sin beta_r - ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * ((1 + 1/12 * eta ^ 2) * sin beta_r));
    ((1 - h) * sin beta_s + beta_s * cos beta_s) * mu - ((1 - h) * cos beta_s - beta_s * sin beta_s);
    beta_s ^ 2 - (1 - h) * h ].
Definition jacobian (beta_r eta h beta_s : R) : list (list R) :=
  [ [(2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r) - 2 * (sin beta_r * (1 + 1/12 * eta ^ 2)) - sin beta_r * (2 - eta) * h;
     1/3 * (eta * (cos beta_r - cos alpha)) - (alpha * sin alpha + beta_r * sin beta_r) - (cos beta_r + cos alpha) * h;
     (2 - eta) * cos beta_r - (2 + eta) * cos alpha;
     0];
    [cos beta_r * ((2 - eta) * h) + (2 * (cos beta_r * (1 + 1/12 * eta ^ 2)) - (cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta));
     sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r) - h * sin beta_r;
     (2 - eta) * sin beta_r;
     0];
    [0;
     0;
     cos beta_s - sin beta_s * mu;
     (cos beta_s * (1 - h) + (cos beta_s - sin beta_s * beta_s)) * mu + (sin beta_s * (1 - h) + (sin beta_s + cos beta_s * beta_s))];
    [0;
     0;
     h - (1 - h);
     2 * beta_s] ].

Definition centre : list R :=
  [ 1.003615310565860388115777054340430586;
    0.650243780801383172790041106182161871;
    0.105343417540891550592461472844863688;
    0.306995410261614388468836037496394531 ].
Definition radii : list R :=
  [0.051; 0.033; 0.0053; 0.015].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0.7977437; 1.135126; -0.7556058; 3.911187];
    [-0.4759516; 0; 0.2843272; -1.4717422];
    [0; 0; 0.2159386; -1.1177473];
    [0; 0; 0.277599; 0.1917737] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [0; -2.101054; 2.766466; 0];
    [0.8809595; 1.4765785; 1.1384098; 0];
    [0; 0; 0.5452814; 3.1781556];
    [0; 0; -0.7893132; 0.6139908] ].
Definition spreads : list (list R) :=
  [ [0.29; 0.11; 0.11; 0];
    [0.36; 0.14; 0.071; 0];
    [0; 0; 0.026; 0.08];
    [0; 0; 0.012; 0.032] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 1e-36.
Definition factor : R := 0.88.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb alpha mu].

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
  cbv [entry centre radii nth]. intros beta_r eta h beta_s B0 B1 B2 B3.
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

Lemma cleared beta_r eta h beta_s :
  wide beta_r eta h beta_s ->
  (equations beta_r eta h beta_s <-> vanish (residuals beta_r eta h beta_s)).
Proof.
  unfold wide, equations, residuals, alpha, mu; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_upper; clearing | intros E0].
  apply both_under; [apply cleared_tangency; clearing | intros E1].
  apply cleared_inner_sliding; clearing.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide beta_r eta h beta_s :
  narrow beta_r eta h beta_s -> wide beta_r eta h beta_s.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists beta_r eta h beta_s,
  narrow beta_r eta h beta_s /\ equations beta_r eta h beta_s /\
  (forall beta_r' eta' h' beta_s',
     wide beta_r' eta' h' beta_s' -> equations beta_r' eta' h' beta_s' ->
     beta_r' = beta_r /\ eta' = eta /\ h' = h /\ beta_s' = beta_s).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat), (x 3%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros beta_r' eta' h' beta_s' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 4)%nat -> entry [beta_r'; eta'; h'; beta_s'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia | apply (same 3%nat); lia].
Qed.

Corollary digits beta_r eta h beta_s :
  wide beta_r eta h beta_s -> equations beta_r eta h beta_s ->
  narrow beta_r eta h beta_s.
Proof.
  destruct one_solution as (beta_r' & eta' & h' & beta_s' & N & _ & unique).
  intros W E. specialize (unique beta_r eta h beta_s W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The state *)

(** What is left to look at: the ends of the arch and the joints that open or slide. *)
Lemma signs beta_r eta h beta_s : narrow beta_r eta h beta_s ->
  0 < alpha /\
  alpha < PI /\
  0 < normal_force alpha h /\
  0 < eta /\
  eta < 2 /\
  0 < h /\
  h < 1 /\
  0 < beta_r /\
  beta_r < alpha /\
  at_shoulder 1 alpha eta h < at_crown eta h /\
  beta_s < alpha /\
  mu_ss alpha h < mu /\
  0 < (2 - eta) * cos beta_r - (2 + eta) * cos alpha /\
  beta_s < beta_r /\
  fac 1 2 * (1 - cos alpha) < 2 * normal_force alpha h.
Proof. unfold narrow, alpha, mu. signs. Qed.

(** The line of thrust is inside, and friction holds, at every joint, and no thinner arch stands. *)
Theorem state beta_r eta h beta_s : wide beta_r eta h beta_s -> equations beta_r eta h beta_s ->
  admissible 1 alpha eta mu h (at_shoulder 1 alpha eta h) /\
  stands_from 1 alpha mu eta.
Proof.
  intros W E. pose proof (signs beta_r eta h beta_s (digits beta_r eta h beta_s W E)) as S.
  unfold equations in E.
  eapply (rotational_sliding 1 alpha mu) with (beta := beta_r) (joint := beta_s); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists eta, Rabs (eta - 0.650243780801383172790041106182161871) <= 1e-30 /\
  stands_from 1 alpha mu eta.
Proof.
  destruct one_solution as (beta_r & eta & h & beta_s & N & E & _).
  exists eta. split; [unfold narrow in N; tauto |].
  exact (proj2 (state beta_r eta h beta_s (narrow_is_wide beta_r eta h beta_s N) E)).
Qed.
