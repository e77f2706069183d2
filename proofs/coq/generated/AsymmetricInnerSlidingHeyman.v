(** * An asymmetric solution of the complementarity problem (19): Heyman's self-weight

    One shoulder slides outwards and a joint of the other half inwards, between a hinge next to the crown and one at the far
    haunch.  The equations that put these joints at their limits have exactly one solution in a box; here are its digits, and
    what makes it a solution of (19): **it is admissible at every joint of the whole arch**, the motion fits without
    dilatancy, and each joint moves its way.  Beside it the arch has its symmetric state, at its least thickness.

    The claims are in the names of [Arch] and [Whole].  The table of numbers between them is what [Contraction] asks for.

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Whole.
Open Scope R_scope.

(** ** The arch *)

Definition alpha : R := 2.3.
Definition mu : R := 1.09.


(** ** What is claimed *)

(** E(b0) = 0; E'(b0) = 0; I(-b1) = 0; I'(-b1) = 0; O(alpha) = 0; O(-b2) = 0; O'(-b2) = 0. *)
Definition equations (h p v eta b0 beta_r beta_s : R) : Prop :=
  from_extrados 0 eta h p v b0 = 0 /\
  extrados_slope 0 eta h v b0 = 0 /\
  from_intrados 0 eta h p v (- beta_r) = 0 /\
  intrados_slope 0 eta h v (- beta_r) = 0 /\
  against_outwards mu h v alpha = 0 /\
  against_outwards mu h v (- beta_s) = 0 /\
  outwards_slope mu h v (- beta_s) = 0.

(** In this box nothing else solves them. *)
Definition wide (h p v eta b0 beta_r beta_s : R) : Prop :=
  0.205 <= h <= 0.224 /\
  0.257 <= p <= 0.282 /\
  0.1415 <= v <= 0.1564 /\
  0.62 <= eta <= 0.685 /\
  0.1371 <= b0 <= 0.1516 /\
  0.988 <= beta_r <= 1.091 /\
  0.249 <= beta_s <= 0.274.

(** In this one lies the solution. *)
Definition narrow (h p v eta b0 beta_r beta_s : R) : Prop :=
  Rabs (h - 0.214149495681506145028841231345842151) <= 1e-30 /\
  Rabs (p - 0.269830518514894853617284857704195799) <= 1e-30 /\
  Rabs (v - 0.148977835350378244338682345786468974) <= 1e-30 /\
  Rabs (eta - 0.652991389316020670879410693527709314) <= 1e-30 /\
  Rabs (b0 - 0.144329213362508980449383439219675219) <= 1e-30 /\
  Rabs (beta_r - 1.039004989165914226760930281842009683) <= 1e-30 /\
  Rabs (beta_s - 0.26125318393127325711739942494077631) <= 1e-30.

(** ** The table *)

(** The equations cleared of denominators, and their partial derivatives. *)
Definition residuals (h p v eta b0 beta_r beta_s : R) : list R :=
  [ - (p - 1/2 * ((2 + eta) * cos b0 * h) + (1 - cos b0 - 1/2 * ((2 + eta) * (b0 - v) * sin b0)));
    - (1/2 * ((2 + eta) * sin b0 * h) + (sin b0 - (1/2 * ((2 + eta) * (b0 - v) * cos b0) + 1/2 * ((2 + eta) * sin b0))));
    - (1/2 * ((2 - eta) * cos beta_r * h) - p + (1/2 * ((2 - eta) * (beta_r + v) * sin beta_r) - (1 - cos beta_r)));
    - (1/2 * ((2 - eta) * sin beta_r * h) + (sin beta_r - (1/2 * ((2 - eta) * (beta_r + v) * cos beta_r) + 1/2 * ((2 - eta) * sin beta_r))));
    (cos alpha + mu * sin alpha) * (alpha - v) - (sin alpha - mu * cos alpha) * h;
    (sin beta_s + mu * cos beta_s) * h + (mu * sin beta_s - cos beta_s) * (beta_s + v);
    - ((cos beta_s - mu * sin beta_s) * h + (mu * sin beta_s - cos beta_s + (sin beta_s + mu * cos beta_s) * (beta_s + v))) ].
Definition jacobian (h p v eta b0 beta_r beta_s : R) : list (list R) :=
  [ [1/2 * ((2 + eta) * cos b0);
     -1;
     - (1/2 * ((2 + eta) * sin b0));
     1/2 * (cos b0 * h) + 1/2 * ((b0 - v) * sin b0);
     - (1/2 * (sin b0 * (2 + eta) * h) + (sin b0 - 1/2 * ((2 + eta) * sin b0 + cos b0 * ((2 + eta) * (b0 - v)))));
     0;
     0];
    [- (1/2 * ((2 + eta) * sin b0));
     0;
     - (1/2 * ((2 + eta) * cos b0));
     1/2 * ((b0 - v) * cos b0) + 1/2 * sin b0 - 1/2 * (sin b0 * h);
     - (1/2 * (cos b0 * (2 + eta) * h) + (cos b0 - (1/2 * ((2 + eta) * cos b0 - sin b0 * ((2 + eta) * (b0 - v))) + 1/2 * (cos b0 * (2 + eta)))));
     0;
     0];
    [- (1/2 * ((2 - eta) * cos beta_r));
     1;
     - (1/2 * ((2 - eta) * sin beta_r));
     1/2 * (cos beta_r * h) + 1/2 * ((beta_r + v) * sin beta_r);
     0;
     1/2 * (sin beta_r * (2 - eta) * h) - (1/2 * ((2 - eta) * sin beta_r + cos beta_r * ((2 - eta) * (beta_r + v))) - sin beta_r);
     0];
    [- (1/2 * ((2 - eta) * sin beta_r));
     0;
     1/2 * ((2 - eta) * cos beta_r);
     1/2 * (sin beta_r * h) - (1/2 * ((beta_r + v) * cos beta_r) + 1/2 * sin beta_r);
     0;
     - (1/2 * (cos beta_r * (2 - eta) * h) + (cos beta_r - (1/2 * ((2 - eta) * cos beta_r - sin beta_r * ((2 - eta) * (beta_r + v))) + 1/2 * (cos beta_r * (2 - eta)))));
     0];
    [mu * cos alpha - sin alpha;
     0;
     - (cos alpha + mu * sin alpha);
     0;
     0;
     0;
     0];
    [sin beta_s + mu * cos beta_s;
     0;
     mu * sin beta_s - cos beta_s;
     0;
     0;
     0;
     (cos beta_s - sin beta_s * mu) * h + ((cos beta_s * mu + sin beta_s) * (beta_s + v) + (mu * sin beta_s - cos beta_s))];
    [mu * sin beta_s - cos beta_s;
     0;
     - (sin beta_s + mu * cos beta_s);
     0;
     0;
     0;
     (sin beta_s + cos beta_s * mu) * h - (cos beta_s * mu + sin beta_s + ((cos beta_s - sin beta_s * mu) * (beta_s + v) + (sin beta_s + mu * cos beta_s)))] ].

Definition centre : list R :=
  [ 0.214149495681506145028841231345842151;
    0.269830518514894853617284857704195799;
    0.148977835350378244338682345786468974;
    0.652991389316020670879410693527709314;
    0.144329213362508980449383439219675219;
    1.039004989165914226760930281842009683;
    0.26125318393127325711739942494077631 ].
Definition radii : list R :=
  [0.01; 0.013; 0.0075; 0.033; 0.0073; 0.052; 0.013].

(** About the inverse of the Jacobian at the centre. *)
Definition inverse : list (list R) :=
  [ [0; 0; 0; 0; -0.5705589; 0.1221441; 0];
    [-0.8427896; 0; 0.1572104; 0; -0.5858617; 0.2270003; 0];
    [0; 0; 0; 0; -1.0929792; -1.2268748; 0];
    [1.488353; 0; 1.488353; 0; -0.4299507; -1.5849327; 0];
    [-0.0595239; 0.7376934; -0.0595239; 0; -1.1215185; -1.1074948; 0];
    [-1.6229623; 0; -1.6229623; -1.7041817; 0.397145; 0.8933892; 0];
    [0; 0; 0; 0; 0.6954116; 0.5815565; -0.3812997] ].

(** The Jacobian at the centre, and how far it can be from that in the wide box. *)
Definition slopes : list (list R) :=
  [ [1.3127036; -1; -0.1907881; 0.1056271; 0; 0; 0];
    [-0.1907881; 0; -1.3127036; 0.0542138; 1.3555767; 0; 0];
    [-0.3415193; 1; -0.5804934; 0.5662565; 0; 0; 0];
    [-0.5804934; 0; 0.3415193; -0.6398624; 0; -0.5867919; 0];
    [-1.4719461; 0; -0.1465427; 0; 0; 0; 0];
    [1.3113045; 0; -0.6845294; 0; 0; 0; 0];
    [-0.6845294; 0; -1.3113045; 0; 0; 0; -2.622609] ].
Definition spreads : list (list R) :=
  [ [0.019; 0; 0.013; 0.0066; 0.046; 0; 0];
    [0.013; 0; 0.019; 0.014; 0.06; 0; 0];
    [0.043; 0; 0.036; 0.054; 0; 0.16; 0];
    [0.036; 0; 0.043; 0.069; 0; 0.23; 0];
    [0.0000001; 0; 0.0000001; 0; 0; 0; 0];
    [0.018; 0; 0.019; 0; 0; 0; 0.065];
    [0.019; 0; 0.018; 0; 0; 0; 0.075] ].

(** The residuals at the centre, and the factor of contraction. *)
Definition size : R := 3e-36.
Definition factor : R := 0.88.

Definition F (j : nat) (x : point) : R :=
  entry (residuals (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat) (x 6%nat)) j.
Definition J (j k : nat) (x : point) : R :=
  entries (jacobian (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat) (x 6%nat)) j k.

(** ** Its check *)

Ltac reduce := cbv beta iota zeta delta
  [F J residuals jacobian centre radii inverse slopes spreads size factor
   entry entries nth sum unit_entry Nat.eqb alpha mu].

Notation box d x := (within 7 (entry radii) d x (entry centre)).

Lemma derivatives j : (j < 7)%nat -> forall (x u : point) (t : R),
  box 1 (fun i => x i + t * u i) ->
  is_derive (fun s => F j (fun i => x i + s * u i)) t
    (sum 7 (fun k => J j k (fun i => x i + t * u i) * u k)).
Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.

Lemma slopes_hold x : box 1 x -> forall j k, (j < 7)%nat -> (k < 7)%nat ->
  Rabs (J j k x - entries slopes j k) <= entries spreads j k.
Proof.
  intros Hx j k Hj Hk. unfold J.
  generalize (bounds Hx 0 ltac:(lia)).
  generalize (bounds Hx 1 ltac:(lia)).
  generalize (bounds Hx 2 ltac:(lia)).
  generalize (bounds Hx 3 ltac:(lia)).
  generalize (bounds Hx 4 ltac:(lia)).
  generalize (bounds Hx 5 ltac:(lia)).
  generalize (bounds Hx 6 ltac:(lia)).
  generalize (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat) (x 6%nat). clear x Hx.
  cbv [entry centre radii nth]. intros h p v eta b0 beta_r beta_s B0 B1 B2 B3 B4 B5 B6.
  each j ltac:(each k ltac:(reduce; slope)).
Qed.

Lemma residuals_hold j : (j < 7)%nat -> Rabs (F j (entry centre)) <= size.
Proof. intros Hj. each j ltac:(reduce; interval with (i_prec 140)). Qed.

Lemma contracts i : (i < 7)%nat ->
  sum 7 (fun k =>
    (Rabs (unit_entry i k - sum 7 (fun j => entries inverse i j * entries slopes j k))
     + sum 7 (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)
  <= factor * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma starts i : (i < 7)%nat ->
  sum 7 (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-30 * entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma regular j : (j < 7)%nat ->
  sum 7 (fun k =>
    Rabs (unit_entry j k - sum 7 (fun i => entries slopes j i * entries inverse i k))) <= 1 / 2.
Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.

Lemma radii_positive i : (i < 7)%nat -> 0 < entry radii i.
Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.

Lemma root : exists x, box 1e-30 x /\ solves 7 F x /\
  (forall y, box 1 y -> solves 7 F y -> forall i, (i < 7)%nat -> y i = x i).
Proof.
  apply (one_root_from_table 7 F J (entries inverse) (entries slopes) (entries spreads)
    (entry centre) (entry radii) (fun _ => size) factor 1e-30);
    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold
    | exact residuals_hold | exact contracts | exact starts | exact regular ].
Qed.

(** ** The cleared equations are the printed ones *)

Lemma cleared h p v eta b0 beta_r beta_s :
  wide h p v eta b0 beta_r beta_s ->
  (equations h p v eta b0 beta_r beta_s <-> vanish (residuals h p v eta b0 beta_r beta_s)).
Proof.
  unfold wide, equations, residuals, alpha, mu; intros W; conjuncts; cbn [vanish].
  apply both_under; [apply cleared_margin; margins | intros E0].
  apply both_under; [apply cleared_margin; margins | intros E1].
  apply both_under; [apply cleared_margin; margins | intros E2].
  apply both_under; [apply cleared_margin; margins | intros E3].
  apply both_under; [apply cleared_margin; margins | intros E4].
  apply both_under; [apply cleared_margin; margins | intros E5].
  apply cleared_margin; margins.
Qed.

(** ** The theorem *)

Lemma narrow_is_wide h p v eta b0 beta_r beta_s :
  narrow h p v eta b0 beta_r beta_s -> wide h p v eta b0 beta_r beta_s.
Proof. narrow_to_wide narrow wide. Qed.

Theorem one_solution : exists h p v eta b0 beta_r beta_s,
  narrow h p v eta b0 beta_r beta_s /\ equations h p v eta b0 beta_r beta_s /\
  (forall h' p' v' eta' b0' beta_r' beta_s',
     wide h' p' v' eta' b0' beta_r' beta_s' -> equations h' p' v' eta' b0' beta_r' beta_s' ->
     h' = h /\ p' = p /\ v' = v /\ eta' = eta /\ b0' = b0 /\ beta_r' = beta_r /\ beta_s' = beta_s).
Proof.
  destruct root as [x [Hx [Hroot Hunique]]].
  exists (x 0%nat), (x 1%nat), (x 2%nat), (x 3%nat), (x 4%nat), (x 5%nat), (x 6%nat).
  assert (N : narrow (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat) (x 6%nat))
    by (unfold narrow; repeat split; digits Hx reduce).
  split; [exact N | split].
  - apply cleared; [now apply narrow_is_wide |]. apply vanish_entries. exact Hroot.
  - intros h' p' v' eta' b0' beta_r' beta_s' W E. apply cleared in E; [| exact W].
    assert (same : forall i, (i < 7)%nat -> entry [h'; p'; v'; eta'; b0'; beta_r'; beta_s'] i = x i).
    { apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |].
      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }
    repeat split; [apply (same 0%nat); lia | apply (same 1%nat); lia | apply (same 2%nat); lia | apply (same 3%nat); lia | apply (same 4%nat); lia | apply (same 5%nat); lia | apply (same 6%nat); lia].
Qed.

Corollary digits h p v eta b0 beta_r beta_s :
  wide h p v eta b0 beta_r beta_s -> equations h p v eta b0 beta_r beta_s ->
  narrow h p v eta b0 beta_r beta_s.
Proof.
  destruct one_solution as (h' & p' & v' & eta' & b0' & beta_r' & beta_s' & N & _ & unique).
  intros W E. specialize (unique h p v eta b0 beta_r beta_s W E). clear W E.
  conjuncts. subst. exact N.
Qed.

(** ** The solution *)

(** The order of the joints and the rates. *)
Lemma signs h p v eta b0 beta_r beta_s : narrow h p v eta b0 beta_r beta_s ->
  0 < v /\ beta_r < alpha /\ beta_s < beta_r /\ - beta_s < b0 /\ b0 < alpha /\
  0 < determinant alpha beta_s /\
  0 < shoulder_slip alpha eta b0 beta_r beta_s /\ 0 < inner_slip alpha eta b0 beta_r beta_s.
Proof.
  unfold narrow, shoulder_slip, inner_slip, determinant, across, upwards, extrados, intrados, alpha, mu;
    intros; conjuncts; repeat split; first [lra | interval with (i_prec 90)].
Qed.

Ltac apart := unfold narrow, alpha, mu in *; conjuncts.

Lemma inside_extrados h p v eta b0 beta_r beta_s : narrow h p v eta b0 beta_r beta_s -> equations h p v eta b0 beta_r beta_s ->
  forall x, - alpha <= x <= alpha -> 0 <= from_extrados 0 eta h p v x.
Proof.
  intros N E x Hx.
  assert (near : forall y, (-0.356) <= y <= (0.645) -> 0 <= from_extrados 0 eta h p v y).
  { apply (touching _ (extrados_slope 0 eta h v) (extrados_bend 0 eta h v) (-0.356) (0.645) b0);
      [intros; apply extrados_has_slope | intros; apply extrados_has_bend | unfold equations in E; tauto ..
      | clear E Hx x; intros x Hx; apart; positive x | clear E Hx; apart; lra]. }
  assert (left : forall y, - alpha <= y <= (-0.356) -> 0 <= from_extrados 0 eta h p v y)
    by (clear E Hx near x; intros x Hx; apart; positive x).
  assert (right : forall y, (0.645) <= y <= alpha -> 0 <= from_extrados 0 eta h p v y)
    by (clear E Hx near left x; intros x Hx; apart; positive x).
  destruct (Rle_dec x (-0.356)); [apply left; lra |].
  destruct (Rle_dec x (0.645)); [apply near; lra | apply right; lra].
Qed.

Lemma inside_intrados h p v eta b0 beta_r beta_s : narrow h p v eta b0 beta_r beta_s -> equations h p v eta b0 beta_r beta_s ->
  forall x, - alpha <= x <= alpha -> 0 <= from_intrados 0 eta h p v x.
Proof.
  intros N E x Hx.
  assert (near : forall y, (-1.14) <= y <= (-0.939) -> 0 <= from_intrados 0 eta h p v y).
  { apply (touching _ (intrados_slope 0 eta h v) (intrados_bend 0 eta h v) (-1.14) (-0.939)
      (- beta_r));
      [intros; apply intrados_has_slope | intros; apply intrados_has_bend | unfold equations in E; tauto ..
      | clear E Hx x; intros x Hx; apart; positive x | clear E Hx; apart; lra]. }
  assert (left : forall y, - alpha <= y <= (-1.14) -> 0 <= from_intrados 0 eta h p v y)
    by (clear E Hx near x; intros x Hx; apart; positive x).
  assert (right : forall y, (-0.939) <= y <= alpha -> 0 <= from_intrados 0 eta h p v y)
    by (clear E Hx near left x; intros x Hx; apart; positive x).
  destruct (Rle_dec x (-1.14)); [apply left; lra |].
  destruct (Rle_dec x (-0.939)); [apply near; lra | apply right; lra].
Qed.

Lemma friction_inwards h p v eta b0 beta_r beta_s : narrow h p v eta b0 beta_r beta_s ->
  forall x, - alpha <= x <= alpha -> 0 <= against_inwards mu h v x.
Proof. intros N x Hx. apart. positive x. Qed.

Lemma friction_outwards h p v eta b0 beta_r beta_s : narrow h p v eta b0 beta_r beta_s -> equations h p v eta b0 beta_r beta_s ->
  forall x, - alpha <= x <= alpha -> 0 <= against_outwards mu h v x.
Proof.
  intros N E x Hx.
  assert (near : forall y, (-0.662) <= y <= (0.139) -> 0 <= against_outwards mu h v y).
  { apply (touching _ (outwards_slope mu h v) (outwards_bend mu h v) (-0.662) (0.139) (- beta_s));
      [intros; apply outwards_has_slope | intros; apply outwards_has_bend | unfold equations in E; tauto ..
      | clear E Hx x; intros x Hx; apart; positive x | clear E Hx; apart; lra]. }
  assert (last : forall y, (1.999) <= y <= alpha -> 0 <= against_outwards mu h v y).
  { apply (falling _ (outwards_slope mu h v) (1.999) alpha);
      [intros; apply outwards_has_slope | unfold equations in E; tauto
      | clear E Hx near x; intros x Hx; apart; positive x]. }
  assert (left : forall y, - alpha <= y <= (-0.662) -> 0 <= against_outwards mu h v y)
    by (clear E Hx near last x; intros x Hx; apart; positive x).
  assert (right : forall y, (0.139) <= y <= (1.999) -> 0 <= against_outwards mu h v y)
    by (clear E Hx near last left x; intros x Hx; apart; positive x).
  destruct (Rle_dec x (-0.662)); [apply left; lra |].
  destruct (Rle_dec x (0.139)); [apply near; lra |].
  destruct (Rle_dec x (1.999)); [apply right; lra | apply last; lra].
Qed.

(** It solves (19). *)
Theorem solution h p v eta b0 beta_r beta_s : wide h p v eta b0 beta_r beta_s -> equations h p v eta b0 beta_r beta_s ->
  asymmetric_solution 0 alpha mu eta h p v b0 beta_r beta_s
    (shoulder_slip alpha eta b0 beta_r beta_s) (inner_slip alpha eta b0 beta_r beta_s).
Proof.
  intros W E. pose proof (digits h p v eta b0 beta_r beta_s W E) as N.
  destruct (signs h p v eta b0 beta_r beta_s N) as (Hv & H1 & H2 & H3 & H4 & Hd & Hs & Hu).
  unfold asymmetric_solution. split.
  { intros x Hx. repeat split; [now apply (inside_extrados h p v eta b0 beta_r beta_s) | now apply (inside_intrados h p v eta b0 beta_r beta_s)
      | now apply (friction_inwards h p v eta b0 beta_r beta_s) | now apply (friction_outwards h p v eta b0 beta_r beta_s)]. }
  assert (F := rates_fit alpha eta b0 beta_r beta_s ltac:(lra)).
  unfold equations in E. repeat split; first [tauto | lra].
Qed.

Corollary asymmetric_thickness : exists eta, Rabs (eta - 0.652991389316020670879410693527709314) <= 1e-30 /\
  exists h p v b0 b1 b2 s u, asymmetric_solution 0 alpha mu eta h p v b0 b1 b2 s u.
Proof.
  destruct one_solution as (h & p & v & eta & b0 & beta_r & beta_s & N & E & _).
  exists eta. split; [unfold narrow in N; tauto |].
  exists h, p, v, b0, beta_r, beta_s. eexists. eexists.
  exact (solution h p v eta b0 beta_r beta_s (narrow_is_wide h p v eta b0 beta_r beta_s N) E).
Qed.
