(** * The point sb: widest rotational joint, Milankovitch's self-weight

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
  h = h_lower 1 beta_r eta /\
  h = h_whole 1 alpha eta /\
  h = h_tangency 1 beta_r eta /\
  double_thickness 1 beta_r eta.

(** In this box nothing else solves them. *)
Definition wide (alpha beta_r eta h : R) : Prop :=
  2.06 <= alpha <= 2.33 /\
  1.07 <= beta_r <= 1.169 /\
  0.369 <= eta <= 0.426 /\
  0.234 <= h <= 0.321.

(** In this one lies the solution. *)
Definition narrow (alpha beta_r eta h : R) : Prop :=
  Rabs (alpha - 2.196404448812123636437088116361977022) <= 1e-30 /\
  Rabs (beta_r - 1.119864231443751759677211632949239426) <= 1e-30 /\
  Rabs (eta - 0.397561006245891605806105864906444394) <= 1e-30 /\
  Rabs (h - 0.277707643556489867007222871184993356) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (alpha beta_r eta h : R) : list R :=
  [ (2 + eta - (2 - eta) * cos beta_r) * h - ((2 - eta) * beta_r * sin beta_r - 2 * ((1 - cos beta_r) * (1 + 1/12 * eta ^ 2)));
    (1 - cos alpha) * (2 + eta) * h - (alpha * sin alpha * (2 + eta) - 2 * ((1 + 1/12 * eta ^ 2) * (1 - cos alpha)));
    (2 - eta) * h * sin beta_r - ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * ((1 + 1/12 * eta ^ 2) * sin beta_r));
    (sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r)) * (2 + eta - (2 - eta) * cos beta_r) - (1 + cos beta_r) * ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * ((1 + 1/12 * eta ^ 2) * sin beta_r)) - ((beta_r * sin beta_r + 1/3 * (eta * (1 - cos beta_r))) * (2 - eta) + ((2 - eta) * beta_r * sin beta_r - 2 * ((1 - cos beta_r) * (1 + 1/12 * eta ^ 2)))) * sin beta_r ].
Definition jacobian (alpha beta_r eta h : R) : list (list R) :=
  [ [0;
     sin beta_r * (2 - eta) * h + (2 * (sin beta_r * (1 + 1/12 * eta ^ 2)) - ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r)));
     (1 + cos beta_r) * h + (beta_r * sin beta_r + 1/3 * (eta * (1 - cos beta_r)));
     2 + eta - (2 - eta) * cos beta_r];
    [sin alpha * (2 + eta) * h + (2 * (sin alpha * (1 + 1/12 * eta ^ 2)) - (sin alpha + cos alpha * alpha) * (2 + eta));
     0;
     (1 - cos alpha) * h + (1/3 * (eta * (1 - cos alpha)) - alpha * sin alpha);
     (1 - cos alpha) * (2 + eta)];
    [0;
     cos beta_r * ((2 - eta) * h) + (2 * (cos beta_r * (1 + 1/12 * eta ^ 2)) - (cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta));
     sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r) - h * sin beta_r;
     (2 - eta) * sin beta_r];
    [0;
     (cos beta_r + (cos beta_r - sin beta_r * beta_r) + 1/3 * (cos beta_r * eta)) * (2 + eta - (2 - eta) * cos beta_r) + sin beta_r * (2 - eta) * (sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r)) + (sin beta_r * ((sin beta_r + beta_r * cos beta_r) * (2 - eta) - 2 * ((1 + 1/12 * eta ^ 2) * sin beta_r)) - ((cos beta_r + (cos beta_r - sin beta_r * beta_r)) * (2 - eta) - 2 * (cos beta_r * (1 + 1/12 * eta ^ 2))) * (1 + cos beta_r)) - (((sin beta_r + cos beta_r * beta_r + 1/3 * (sin beta_r * eta)) * (2 - eta) + ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * beta_r) - 2 * (sin beta_r * (1 + 1/12 * eta ^ 2)))) * sin beta_r + cos beta_r * ((beta_r * sin beta_r + 1/3 * (eta * (1 - cos beta_r))) * (2 - eta) + ((2 - eta) * beta_r * sin beta_r - 2 * ((1 - cos beta_r) * (1 + 1/12 * eta ^ 2)))));
     1/3 * (sin beta_r * (2 + eta - (2 - eta) * cos beta_r)) + (1 + cos beta_r) * (sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r)) + (sin beta_r + beta_r * cos beta_r + 1/3 * (eta * sin beta_r)) * (1 + cos beta_r) - (1/3 * ((1 - cos beta_r) * (2 - eta)) - (beta_r * sin beta_r + 1/3 * (eta * (1 - cos beta_r))) - (beta_r * sin beta_r + 1/3 * (eta * (1 - cos beta_r)))) * sin beta_r;
     0] ].

Definition centre : list R :=
  [ 2.196404448812123636437088116361977022;
    1.119864231443751759677211632949239426;
    0.397561006245891605806105864906444394;
    0.277707643556489867007222871184993356 ].
Definition radii : list R :=
  [0.14; 0.05; 0.029; 0.044].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [-0.607943; 0.3009751; -0.0770655; 0.2052813];
    [-0.6551968; 0; 0.7719249; 0];
    [0.0489018; 0; -0.057614; 0.1534679];
    [0.5458744; 0; 0.0502297; -0.1337981] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [0; 0; 1.4814253; 1.6992106];
    [3.3225335; 0; -1.1299677; 3.8015495];
    [0; 1.2954628; 1.2574087; 1.4422612];
    [0; 0.4863354; 6.5160221; 0] ].
Definition spreads : list (list R) :=
  [ [0; 0.36; 0.18; 0.13];
    [1.6; 0; 0.5; 0.37];
    [0; 0.45; 0.17; 0.067];
    [0; 2.4; 0.79; 0] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 6e-36.
Definition factor : R := 0.9.

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
  radicand 1 (f_of beta_r) (g_of beta_r) (sin beta_r) = 0.
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
  fac 1 2 * (1 - cos alpha) < 2 * normal_force alpha h.
Proof. unfold narrow. signs. Qed.

(** The line of thrust is inside at every joint, and no thinner arch stands. *)
Theorem state alpha beta_r eta h : wide alpha beta_r eta h -> equations alpha beta_r eta h ->
  thrust_inside 1 alpha eta h (at_crown eta h) /\
  stands_without_limit_from 1 alpha eta.
Proof.
  intros W E. pose proof (signs alpha beta_r eta h (digits alpha beta_r eta h W E)) as S.
  unfold equations in E.
  eapply (rotational_without_limit 1 alpha) with (beta := beta_r); [lra | tauto | tauto | known ..].
Qed.

Theorem least_thickness : exists alpha beta_r eta h, narrow alpha beta_r eta h /\
  stands_without_limit_from 1 alpha eta.
Proof.
  destruct one_solution as (alpha & beta_r & eta & h & N & E & _).
  exists alpha, beta_r, eta, h. split; [exact N |].
  exact (proj2 (state alpha beta_r eta h (narrow_is_wide alpha beta_r eta h N) E)).
Qed.

(** ** The printed values

    Is the last digit right, that is, the value the nearest of its length? *)

Corollary sec_2_1_rotation_joint_right alpha beta_r eta h :
  wide alpha beta_r eta h -> equations alpha beta_r eta h ->
  Rabs (beta_r - 1.119864231443752) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_r eta h W) in E. unfold narrow in E. compare. Qed.

Corollary sec_2_1_half_opening_right alpha beta_r eta h :
  wide alpha beta_r eta h -> equations alpha beta_r eta h ->
  Rabs (alpha - 2.196404448812124) <= 5e-16.
Proof. intros W E. apply (digits alpha beta_r eta h W) in E. unfold narrow in E. compare. Qed.
