(** * An arch whose states leave no room moves

    A state leaves room where no joint is at a limit. If none does, five of the margins have no common point where they
    are positive, and their multipliers, Gordan's theorem of [Cones], are the rates of a mechanism. If one does, thinner
    arches stand and wider ones. So an arch moves at its least thickness, and with its widest half-angle. *)

From Coq Require Import List Classical.
Import ListNotations.
From Couplet Require Export Mechanisms.
From Couplet Require Cones.

Definition admissible_state (delta alpha eta mu h p : R) : Prop :=
  forall x, 0 <= x <= alpha -> joint_stands delta x eta h p /\ friction_holds x mu h.

(** [shoulder_gap] and [haunch_gap] are the distances from the extrados and the intrados at any joint. *)
Definition leaves_room (delta alpha eta mu h p : R) : Prop :=
  forall x, 0 <= x <= alpha ->
    0 < shoulder_gap delta x eta h p /\ 0 < haunch_gap delta x eta h p /\
    0 < inward_gap x mu h /\ 0 < outward_gap x mu h.

(** A mechanism moves the state: its joints with a rate are at their limits. *)
Definition state_moves (delta alpha eta mu h p : R) : Prop :=
  exists beta sigma u l v s t, 0 <= beta <= alpha /\ 0 < sigma <= alpha /\
    0 < u + l + v + s + t /\ moves delta alpha beta sigma eta mu h p u l v s t.

Lemma below_both (a b : R) : 0 < a -> 0 < b -> exists e, 0 < e /\ e <= a /\ e <= b.
Proof. exists (Rmin a b). auto using Rmin_glb_lt, Rmin_l, Rmin_r. Qed.

(** ** A little way in a direction *)

(** A function that is not negative and another that is positive where the first is zero. *)
Lemma positive_in_direction (a b : R) (f g : R -> R) : a <= b -> continuity f -> continuity g ->
  (forall x, a <= x <= b -> 0 <= f x) -> (forall x, a <= x <= b -> f x = 0 -> 0 < g x) ->
  exists e, 0 < e /\ forall t, 0 < t <= e -> forall x, a <= x <= b -> 0 < f x + t * g x.
Proof.
  intros Hab Hf Hg Hnotneg Hpos. set (m := fun x => (f x + g x + Rabs (f x - g x)) / 2).
  assert (Hm : forall x, (m x = f x \/ m x = g x) /\ f x <= m x /\ g x <= m x).
  { intros x. unfold m, Rabs. destruct (Rcase_abs (f x - g x)); lra. }
  assert (Hcontinuous : continuity m).
  { unfold m. intros x. assert (Hfx := Hf x). assert (Hgx := Hg x).
    apply continuity_pt_mult; [|apply continuity_pt_const; now intros u v].
    apply continuity_pt_plus; [now apply continuity_pt_plus|].
    apply (continuity_pt_comp (fun y => f y - g y) Rabs); [now apply continuity_pt_minus | apply Rcontinuity_abs]. }
  destruct (continuity_ab_min m a b Hab (fun x _ => Hcontinuous x)) as (x0 & Hleast & Hx0).
  destruct (continuity_ab_min g a b Hab (fun x _ => Hg x)) as (x1 & Hlow & _). assert (Hm0 : 0 < m x0).
  { destruct (Hm x0) as (_ & H1 & H2). assert (H3 := Hnotneg x0 Hx0). destruct (Req_dec (f x0) 0) as [E | E]; [|lra].
    assert (H4 := Hpos x0 Hx0 E). lra. }
  set (G := Rabs (g x1) + 1). assert (HG : 0 < G) by (unfold G; assert (H := Rabs_pos (g x1)); lra).
  exists (m x0 / (2 * G)). split; [positive|]. intros t Ht x Hx. assert (Hmx := Hleast x Hx).
  assert (H0 := Hnotneg x Hx). assert (HtG : t * G <= m x0 / 2).
  { replace (m x0 / 2) with (m x0 / (2 * G) * G) by (field; lra). apply Rmult_le_compat_r; lra. }
  destruct (Hm x) as ([E | E] & _).
  - assert (Hgx : - G <= g x).
    { assert (H := Hlow x Hx). assert (H' := Rle_abs (- g x1)). rewrite Rabs_Ropp in H'. unfold G. lra. }
    assert (t * - G <= t * g x) by (apply Rmult_le_compat_l; lra). lra.
  - assert (0 < t * g x) by positive. lra.
Qed.

(** The margins at two states on a line, at one joint. *)
Lemma margins_on_a_line (delta x eta mu h p h' p' t : R) :
  shoulder_gap delta x eta (h + t * (h' - h)) (p + t * (p' - p))
  = shoulder_gap delta x eta h p
    + t * (shoulder_gap delta x eta h' p' - shoulder_gap delta x eta h p) /\
  haunch_gap delta x eta (h + t * (h' - h)) (p + t * (p' - p))
  = haunch_gap delta x eta h p
    + t * (haunch_gap delta x eta h' p' - haunch_gap delta x eta h p) /\
  inward_gap x mu (h + t * (h' - h))
  = inward_gap x mu h + t * (inward_gap x mu h' - inward_gap x mu h) /\
  outward_gap x mu (h + t * (h' - h))
  = outward_gap x mu h + t * (outward_gap x mu h' - outward_gap x mu h).
Proof. unfold shoulder_gap, haunch_gap, inward_gap, outward_gap, normal_force, shear_force. repeat split; ring. Qed.

Lemma margins_continuous (delta eta mu h p : R) : continuity (fun x => shoulder_gap delta x eta h p) /\
  continuity (fun x => haunch_gap delta x eta h p) /\ continuity (fun x => inward_gap x mu h) /\
  continuity (fun x => outward_gap x mu h).
Proof. unfold shoulder_gap, haunch_gap, inward_gap, outward_gap, normal_force, shear_force. repeat split; reg. Qed.

(** ** The joints at a limit *)

Lemma centroids_positive (delta eta : R) : 0 <= delta -> 1 <= fac delta eta.
Proof. intros Hd. unfold fac. assert (0 <= delta * eta ^ 2) by positive. lra. Qed.

Lemma at_one_joint (P : R -> Prop) (alpha : R) : (forall x y, 0 <= x -> x < y <= alpha -> P x -> ~ P y) ->
  forall x y, 0 <= x <= alpha -> 0 <= y <= alpha -> P x -> P y -> x = y.
Proof.
  intros H x y Hx Hy Px Py.
  destruct (Rtotal_order x y) as [L | [E | L]]; [now destruct (H x y) | easy | now destruct (H y x)].
Qed.

Lemma named_if_once (P : R -> Prop) (alpha : R) : 0 <= alpha ->
  (forall x y, 0 <= x <= alpha -> 0 <= y <= alpha -> P x -> P y -> x = y) ->
  exists b, 0 <= b <= alpha /\ forall x, 0 <= x <= alpha -> P x -> x = b.
Proof.
  intros Ha H. destruct (classic (exists b, 0 <= b <= alpha /\ P b)) as [(b & Hb & Pb) | Hnone].
  - exists b. split; [easy|]. intros x Hx Px. now apply H.
  - exists 0. split; [lra|]. intros x Hx Px. elim Hnone. now exists x.
Qed.

(** The line of thrust touches the intrados at one joint only, whatever the thrust. *)
Lemma intrados_touched_once (delta alpha eta h p x y : R) : 0 <= delta -> alpha < PI -> 0 < eta <= 2 ->
  (forall z, 0 <= z <= alpha -> 0 <= haunch_gap delta z eta h p) -> 0 <= x <= alpha -> 0 <= y <= alpha ->
  haunch_gap delta x eta h p = 0 -> haunch_gap delta y eta h p = 0 -> x = y.
Proof.
  intros Hd Ha He Hall. apply (at_one_joint (fun x => haunch_gap delta x eta h p = 0)). clear x y.
  intros x y Hx Hy Ex Ey. destruct (Req_dec eta 2) as [E2 | E2].
  - assert (cos y < cos x) by (apply cos_decreasing_1; lra). assert (Hfac := centroids_positive delta eta Hd).
    assert (0 < fac delta eta * (cos x - cos y)) by positive. unfold haunch_gap, intrados in *. rewrite E2 in *. lra.
  - set (z := (x + y) / 2). assert (Hz := Hall z ltac:(unfold z; lra)).
    assert (H := margin_between (intrados eta) (fac delta eta) h x z y
                   ltac:(unfold intrados; lra) Hx ltac:(unfold z; lra) ltac:(lra)).
    assert (Hleast : p + fac delta eta <= Rmin (margin (intrados eta) (fac delta eta) h x)
      (margin (intrados eta) (fac delta eta) h y)) by (apply Rmin_glb; unfold haunch_gap, margin in *; lra).
    unfold haunch_gap, margin in *. lra.
Qed.

(** At a limit of friction [T/N] is the friction. *)
Lemma steepness_at_limit (x mu h : R) : 0 < normal_force x h ->
  (inward_gap x mu h = 0 -> steepness x h = mu) /\ (outward_gap x mu h = 0 -> steepness x h = - mu).
Proof.
  intros HN. unfold inward_gap, outward_gap, steepness.
  split; intros E; (apply (Rmult_eq_reg_r (normal_force x h)); [field_simplify |]; lra).
Qed.

Section State.

(** The state says of which arch it is. *)
Context {delta alpha eta mu h p : R}.
Hypotheses (state : admissible_state delta alpha eta mu h p) (flag : 0 <= delta <= 1)
  (opening : 0 < alpha < PI) (thickness : 0 < eta <= 2) (rough : 0 < mu).

Lemma thrust_positive : 0 < h.
Proof. apply (friction_needs_thrust delta alpha eta mu h p); [lra | lra | exact state]. Qed.

Lemma moment_not_negative : 0 <= p.
Proof.
  assert (Hh := thrust_positive). destruct (state 0 ltac:(lra)) as [(_ & Hlow & _) _].
  rewrite normal_force_at_crown, cos_0 in Hlow. assert (0 <= intrados eta * h) by positive. lra.
Qed.

Lemma compressed (x : R) : 0 <= x <= alpha -> 0 < normal_force x h.
Proof.
  intros Hx. assert (Hh := thrust_positive). assert (Hp := moment_not_negative).
  destruct (Req_dec x 0) as [-> | Hne]; [unfold normal_force; rewrite cos_0, sin_0; lra|].
  destruct (state x Hx) as [(HN & _ & Hout) _]. destruct (Req_dec (normal_force x h) 0) as [E | E]; [|lra].
  rewrite E in Hout. exfalso. assert (0 < 1 - cos x) by positive. assert (0 < fac delta eta * (1 - cos x)).
  { assert (Hfac := centroids_positive delta eta ltac:(lra)). positive. }
  lra.
Qed.

Lemma margins_not_negative (x : R) : 0 <= x <= alpha -> 0 <= shoulder_gap delta x eta h p /\
  0 <= haunch_gap delta x eta h p /\ 0 <= inward_gap x mu h /\ 0 <= outward_gap x mu h.
Proof.
  intros Hx. destruct (state x Hx) as [(_ & Hin & Hout) Hf]. unfold friction_holds in Hf. apply Rabs_le_between in Hf.
  unfold shoulder_gap, haunch_gap, inward_gap, outward_gap. lra.
Qed.

Lemma haunch_not_negative (x : R) : 0 <= x <= alpha -> 0 <= haunch_gap delta x eta h p.
Proof. intros Hx. now destruct (margins_not_negative x Hx) as (_ & H & _). Qed.

Lemma extrados_reached (x : R) : 0 <= x <= alpha -> shoulder_gap delta x eta h p = 0 -> x = 0 \/ x = alpha.
Proof.
  intros Hx E. destruct (Req_dec x 0) as [H0 | H0]; [now left|].
  destruct (Req_dec x alpha) as [H1 | H1]; [now right | exfalso].
  destruct (margins_not_negative alpha ltac:(lra)) as (Hs & _).
  destruct (margins_not_negative 0 ltac:(lra)) as (Hc & _). assert (H : 0 < shoulder_gap delta x eta h p); [|lra].
  apply (extrados_clear_within delta x alpha); try easy; try lra. rewrite gap_at_crown in Hc. lra.
Qed.

Lemma outward_limit_reached (x : R) : 0 <= x <= alpha -> outward_gap x mu h = 0 -> x = alpha.
Proof.
  intros Hx E. destruct (Req_dec x alpha) as [H1 | H1]; [easy | exfalso]. assert (Hh := thrust_positive).
  destruct (Req_dec x 0) as [-> | H0].
  - unfold outward_gap, normal_force, shear_force in E. rewrite cos_0, sin_0 in E.
    assert (0 < mu * h) by positive. lra.
  - destruct (margins_not_negative alpha ltac:(lra)) as (_ & _ & _ & Ho). assert (H : 0 < outward_gap x mu h); [|lra].
    apply (no_outward_limit_within x alpha); lra.
Qed.

Lemma intrados_reached_once (x y : R) : 0 <= x <= alpha -> 0 <= y <= alpha ->
  haunch_gap delta x eta h p = 0 -> haunch_gap delta y eta h p = 0 -> x = y.
Proof.
  apply intrados_touched_once; try easy; try lra. intros z Hz.
  now destruct (margins_not_negative z Hz) as (_ & HL & _).
Qed.

Lemma inward_limit_reached_once (x y : R) : 0 <= x <= alpha -> 0 <= y <= alpha ->
  inward_gap x mu h = 0 -> inward_gap y mu h = 0 -> x = y.
Proof.
  assert (Hh := thrust_positive). assert (Hsteep : forall x, 0 <= x <= alpha -> steepness x h <= mu).
  { intros z Hz. destruct (margins_not_negative z Hz) as (_ & _ & HI & _).
    apply steepness_at_most; [now apply compressed |]. unfold inward_gap in HI. lra. }
  assert (Hlimit : forall x, 0 <= x <= alpha -> inward_gap x mu h = 0 -> steepness x h = mu)
    by (intros z Hz; apply (steepness_at_limit z mu h (compressed z Hz))).
  apply (at_one_joint (fun x => inward_gap x mu h = 0)). clear x y. intros x y Hx Hy Ex Ey.
  destruct (Rle_lt_dec h 1) as [H1 | H1].
  - apply Hlimit in Ex, Ey; try lra. assert (HN := compressed alpha ltac:(lra)).
    assert (Hb : 0 <= beta_s h) by apply sqrt_pos. destruct (Rle_lt_dec y (beta_s h)) as [Hs | Hs].
    + assert (steepness x h < steepness y h) by (apply steepness_grows_before_beta_s; lra). lra.
    + destruct (Rle_lt_dec (beta_s h) x) as [Hs' | Hs'].
      * assert (steepness y h < steepness x h) by (apply (steepness_falls_after_beta_s h alpha); lra). lra.
      * assert (steepness x h < steepness (beta_s h) h) by (apply steepness_grows_before_beta_s; lra).
        assert (steepness (beta_s h) h <= mu) by (apply Hsteep; lra). lra.
  - assert (HN := compressed y ltac:(lra)). assert (H := times_cosine_below_sine y ltac:(lra)).
    assert (0 < sin y) by positive. assert (0 < mu * normal_force y h) by positive.
    unfold inward_gap, shear_force in Ey. nra.
Qed.

(** So they are named, if there are any. *)
Lemma haunch_of_state : exists beta, 0 <= beta <= alpha /\
  forall x, 0 <= x <= alpha -> haunch_gap delta x eta h p = 0 -> x = beta.
Proof. apply (named_if_once (fun x => haunch_gap delta x eta h p = 0)); [lra | exact intrados_reached_once]. Qed.

Lemma slip_of_state : exists sigma, 0 < sigma <= alpha /\
  forall x, 0 <= x <= alpha -> inward_gap x mu h = 0 -> x = sigma.
Proof.
  assert (Hh := thrust_positive).
  destruct (classic (exists b, 0 <= b <= alpha /\ inward_gap b mu h = 0)) as [(b & Hb & E) | Hnone].
  - exists b. split; [|intros x Hx Ex; now apply inward_limit_reached_once].
    destruct (Req_dec b 0) as [-> | Hne]; [exfalso | lra]. unfold inward_gap, normal_force, shear_force in E.
    rewrite cos_0, sin_0 in E. assert (0 < mu * h) by positive. lra.
  - exists alpha. split; [lra|]. intros x Hx Ex. exfalso. apply Hnone. now exists x.
Qed.

(** ** Multipliers are rates *)

(** The margins as forms of [h] and [p]. *)
Definition forms (beta sigma : R) : list (R * R -> R) :=
  [fun x => crown_gap eta (fst x) (snd x); fun x => haunch_gap delta beta eta (fst x) (snd x);
   fun x => shoulder_gap delta alpha eta (fst x) (snd x); fun x => inward_gap sigma mu (fst x);
   fun x => outward_gap alpha mu (fst x)].
Definition line (x y : R * R) (t : R) : R * R := (fst x + t * (fst y - fst x), snd x + t * (snd y - snd x)).

Lemma forms_affine (beta sigma : R) : forall f, In f (forms beta sigma) -> Cones.affine line f.
Proof.
  intros f [<- | [<- | [<- | [<- | [<- | []]]]]] x y t; simpl;
    unfold crown_gap, haunch_gap, shoulder_gap, inward_gap, outward_gap, normal_force, shear_force; ring.
Qed.

(** What the thrust does to the limit of friction that is reached at a joint. *)
Lemma row_of_slip (x m : R) : m * normal_force x h = shear_force x h -> normal_force x h * (m * cos x + sin x) = x.
Proof.
  intros E. transitivity (m * normal_force x h * cos x + normal_force x h * sin x); [ring |]. rewrite E.
  unfold shear_force, normal_force. transitivity (x * (sin x ^ 2 + cos x ^ 2)); [| rewrite (circle x)]; ring.
Qed.

(** What a multiplier of the friction at a joint is as a rate. *)
Lemma rate_of_slip (x row k : R) : 0 < x < PI -> 0 < normal_force x h -> 0 <= k ->
  (k = 0 \/ normal_force x h * row = x) ->
  exists s, 0 <= s /\ s * sin x = k * row /\ (k = 0 -> s = 0) /\ (0 < k -> 0 < s).
Proof.
  intros Hx HN Hk Hrow. assert (HS : 0 < sin x) by positive. exists (k * (x / (normal_force x h * sin x))).
  assert (Hscale : 0 < x / (normal_force x h * sin x)) by positive. repeat split.
  - positive.
  - destruct Hrow as [-> | Hrow]; [ring|]. assert (E : row = x / normal_force x h).
    { apply (Rmult_eq_reg_l (normal_force x h)); [rewrite Hrow; field|]; lra. }
    rewrite E. field. lra.
  - intros ->. ring.
  - intros H. positive.
Qed.

Lemma multipliers_are_rates (beta sigma : R) (k : nat -> R) (c : R) : 0 <= beta <= alpha -> 0 < sigma <= alpha ->
  (forall i, 0 <= k i) -> 0 < Cones.sum k 5 -> c <= 0 ->
  (forall x, True -> Cones.weighted k (forms beta sigma) x = c) -> exists u l v s t, 0 < u + l + v + s + t /\
  moves delta alpha beta sigma eta mu h p u l v s t.
Proof.
  intros Hb Hs Hk Hsum Hc Hconstant. simpl in Hsum. set (k1 := k 0%nat) in *. set (k2 := k 1%nat) in *.
  set (k3 := k 2%nat) in *. set (k4 := k 3%nat) in *. set (k5 := k 4%nat) in *.
  assert (H1 := Hk 0%nat : 0 <= k1). assert (H2 := Hk 1%nat : 0 <= k2). assert (H3 := Hk 2%nat : 0 <= k3).
  assert (H4 := Hk 3%nat : 0 <= k4). assert (H5 := Hk 4%nat : 0 <= k5).
  assert (Hwork : forall h' p', k1 * crown_gap eta h' p' + k2 * haunch_gap delta beta eta h' p' + k3 * shoulder_gap
    delta alpha eta h' p' + k4 * inward_gap sigma mu h' + k5 * outward_gap alpha mu h' = c).
  { intros h' p'. rewrite <- (Hconstant (h', p') I). simpl. fold k1 k2 k3 k4 k5. ring. }
  clear Hconstant.
  (* in the state each term is zero *)
  destruct (margins_not_negative 0 ltac:(lra)) as (M1 & _). destruct (margins_not_negative beta Hb) as (_ & M2 & _).
  destruct (margins_not_negative sigma ltac:(lra)) as (_ & _ & M4 & _).
  destruct (margins_not_negative alpha ltac:(lra)) as (M3 & _ & _ & M5). rewrite gap_at_crown in M1.
  assert (W := Hwork h p). assert (P1 := Rmult_le_pos _ _ H1 M1). assert (P2 := Rmult_le_pos _ _ H2 M2).
  assert (P3 := Rmult_le_pos _ _ H3 M3). assert (P4 := Rmult_le_pos _ _ H4 M4). assert (P5 := Rmult_le_pos _ _ H5 M5).
  assert (Z1 : k1 * crown_gap eta h p = 0) by lra. assert (Z2 : k2 * haunch_gap delta beta eta h p = 0) by lra.
  assert (Z3 : k3 * shoulder_gap delta alpha eta h p = 0) by lra. assert (Z4 : k4 * inward_gap sigma mu h = 0) by lra.
  assert (Z5 : k5 * outward_gap alpha mu h = 0) by lra.
  (* neither the moment nor the thrust works *)
  assert (Hmoment : k2 = k1 + k3).
  { assert (Wp := Hwork h (p + 1)). unfold crown_gap, haunch_gap, shoulder_gap in W, Wp. lra. }
  assert (Hthrust : k1 * extrados eta - k2 * (intrados eta * cos beta) + k3 * (extrados eta * cos alpha) + k4 *
    (mu * cos sigma + sin sigma) - k5 * (sin alpha - mu * cos alpha) = 0).
  { assert (Wh := Hwork (h + 1) p).
    unfold crown_gap, haunch_gap, shoulder_gap, inward_gap, outward_gap, normal_force, shear_force in W, Wh. lra. }
  assert (HNs := compressed sigma ltac:(lra)). assert (HNa := compressed alpha ltac:(lra)).
  destruct (rate_of_slip sigma (mu * cos sigma + sin sigma) k4) as (s & Hs0 & Es & Hs1 & Hs2); try easy; try lra.
  { destruct (Req_dec k4 0) as [E | E]; [now left | right]. apply row_of_slip, (Rmult_eq_reg_l k4); [|easy].
    unfold inward_gap in Z4. lra. }
  destruct (rate_of_slip alpha (sin alpha - mu * cos alpha) k5) as (t & Ht0 & Et & Ht1 & Ht2); try easy; try lra.
  { destruct (Req_dec k5 0) as [E | E]; [now left | right].
    replace (sin alpha - mu * cos alpha) with (- mu * cos alpha + sin alpha) by ring.
    apply row_of_slip, (Rmult_eq_reg_l k5); [|easy]. unfold outward_gap in Z5. lra. }
  exists k1, k2, k3, s, t. split.
  - destruct (Rlt_dec 0 k4) as [L4 | L4]; [specialize (Hs2 L4); lra|].
    destruct (Rlt_dec 0 k5) as [L5 | L5]; [specialize (Ht2 L5); lra | lra].
  - unfold moves, in_balance. repeat split; try lra.
    + rewrite Es, Et, Hmoment in *. lra.
    + destruct (Req_dec k4 0) as [E | E]; [rewrite (Hs1 E); ring|]. replace (inward_gap sigma mu h) with 0; [ring|].
      symmetry. apply (Rmult_eq_reg_l k4); lra.
    + destruct (Req_dec k5 0) as [E | E]; [rewrite (Ht1 E); ring|]. replace (outward_gap alpha mu h) with 0; [ring|].
      symmetry. apply (Rmult_eq_reg_l k5); lra.
Qed.

(** Every admissible state either moves or has one that leaves room beside it. *)
Theorem moves_or_leaves_room :
  state_moves delta alpha eta mu h p \/ exists h' p', leaves_room delta alpha eta mu h' p'.
Proof.
  assert (Hh := thrust_positive).
  destruct haunch_of_state as (beta & Hb & Hbeta), slip_of_state as (sigma & Hs & Hsigma).
  destruct (Cones.strict_point_or_multipliers line (forms beta sigma) (forms_affine beta sigma) (fun _ => True))
    as [([h' p'] & _ & Hstrict) | (k & c & Hnotneg & Hsum & Hc & Hconstant)]; [now exists (h, p) | easy | |].
  - right. assert (C := Hstrict _ (or_introl eq_refl)). assert (L := Hstrict _ (or_intror (or_introl eq_refl))).
    assert (U := Hstrict _ (or_intror (or_intror (or_introl eq_refl)))).
    assert (I := Hstrict _ (or_intror (or_intror (or_intror (or_introl eq_refl))))).
    assert (O := Hstrict _ (or_intror (or_intror (or_intror (or_intror (or_introl eq_refl)))))).
    simpl in C, L, U, I, O. destruct (margins_continuous delta eta mu h p) as (CU & CL & CI & CO).
    destruct (margins_continuous delta eta mu h' p') as (CU' & CL' & CI' & CO').
    assert (Hway : forall f g : R -> R, continuity f -> continuity g -> (forall x, 0 <= x <= alpha -> 0 <= f x) ->
      (forall x, 0 <= x <= alpha -> f x = 0 -> 0 < g x) -> exists e, 0 < e /\ forall t, 0 < t <= e -> forall x,
      0 <= x <= alpha -> 0 < f x + t * (g x - f x)).
    { intros f g Hf Hg Hnotneg Hpos. apply (positive_in_direction 0 alpha f (fun x => g x - f x)); try easy; try lra.
      - intros x. now apply continuity_pt_minus.
      - intros x Hx E. assert (H := Hpos x Hx E). lra. }
    destruct (Hway _ _ CU CU') as (e1 & He1 & HU).
    { intros x Hx. now destruct (margins_not_negative x Hx). }
    { intros x Hx E. destruct (extrados_reached x Hx E) as [-> | ->]; [|easy]. unfold shoulder_gap, normal_force.
      rewrite cos_0, sin_0. unfold crown_gap in C. lra. }
    destruct (Hway _ _ CL CL') as (e2 & He2 & HL).
    { intros x Hx. now destruct (margins_not_negative x Hx) as (_ & H & _). }
    { intros x Hx E. now rewrite (Hbeta x Hx E). }
    destruct (Hway _ _ CI CI') as (e3 & He3 & HI).
    { intros x Hx. now destruct (margins_not_negative x Hx) as (_ & _ & H & _). }
    { intros x Hx E. now rewrite (Hsigma x Hx E). }
    destruct (Hway _ _ CO CO') as (e4 & He4 & HO).
    { intros x Hx. now destruct (margins_not_negative x Hx) as (_ & _ & _ & H). }
    { intros x Hx E. now rewrite (outward_limit_reached x Hx E). }
    destruct (below_both e1 e2 He1 He2) as (d & Hd & B1 & B2), (below_both e3 e4 He3 He4) as (d' & Hd' & B3 & B4).
    destruct (below_both d d' Hd Hd') as (e & He & B & B'). exists (h + e * (h' - h)), (p + e * (p' - p)).
    intros x Hx. destruct (margins_on_a_line delta x eta mu h p h' p' e) as (-> & -> & -> & ->).
    repeat split; [apply HU | apply HL | apply HI | apply HO]; lra.
  - left. exists beta, sigma.
    destruct (multipliers_are_rates beta sigma k c Hb Hs Hnotneg Hsum Hc Hconstant)
      as (u & l & v & s & t & Hsome & Hmoves). exists u, l, v, s, t. tauto.
Qed.

End State.

(** ** Where there is room, thinner and wider arches stand *)

Lemma stands_by_margins (delta alpha eta mu h p : R) : 0 < eta -> (forall x, 0 <= x <= alpha ->
    0 <= shoulder_gap delta x eta h p /\ 0 <= haunch_gap delta x eta h p /\ 0 <= inward_gap x mu h /\
    0 <= outward_gap x mu h) -> arch_stands delta alpha eta mu.
Proof.
  intros He Hall. exists h, p. intros x Hx. destruct (Hall x Hx) as (HU & HL & HI & HO).
  unfold shoulder_gap, haunch_gap, inward_gap, outward_gap, extrados, intrados in *.
  assert (0 <= normal_force x h) by (apply (Rmult_le_reg_l eta); lra).
  split; [repeat split; unfold extrados, intrados; lra|]. unfold friction_holds. apply Rabs_le_between. lra.
Qed.

(** Room at the faces is enough for a thinner one. *)
Theorem thinner_arch_stands (delta alpha eta mu h p : R) : 0 <= delta <= 1 -> 0 <= alpha -> 0 < eta <= 2 ->
  (forall x, 0 <= x <= alpha -> 0 < shoulder_gap delta x eta h p /\ 0 < haunch_gap delta x eta h p /\
    0 <= inward_gap x mu h /\ 0 <= outward_gap x mu h) -> exists eta', 0 < eta' < eta /\
  arch_stands delta alpha eta' mu.
Proof.
  intros Hd Ha He Hroom. destruct (margins_continuous delta eta mu h p) as (CU & CL & _).
  destruct (positive_in_direction 0 alpha (fun x => shoulder_gap delta x eta h p)
              (fun x => - (normal_force x h / 2))) as (e1 & He1 & HU); try easy.
  { unfold normal_force. reg. }
  { intros x Hx. destruct (Hroom x Hx). lra. }
  { intros x Hx E. destruct (Hroom x Hx). lra. }
  destruct (positive_in_direction 0 alpha (fun x => haunch_gap delta x eta h p)
              (fun x => - (normal_force x h / 2 + (1 - cos x) / 3))) as (e2 & He2 & HL); try easy.
  { unfold normal_force. reg. }
  { intros x Hx. destruct (Hroom x Hx) as (_ & H & _). lra. }
  { intros x Hx E. destruct (Hroom x Hx) as (_ & H & _). lra. }
  destruct (below_both e1 e2 He1 He2) as (e & He0 & B1 & B2).
  destruct (below_both (eta / 2) e ltac:(lra) He0) as (t & Ht & B0 & B). exists (eta - t). split; [lra|].
  apply (stands_by_margins delta alpha (eta - t) mu h p); [lra|]. intros x Hx. assert (HU' := HU t ltac:(lra) x Hx).
  assert (HL' := HL t ltac:(lra) x Hx). destruct (Hroom x Hx) as (_ & _ & HI & HO).
  assert (Hv : 0 <= 1 - cos x) by (destruct (COS_bound x); lra).
  assert (Hcut : 0 <= t * (delta * (2 * eta - t)) * (1 - cos x)) by positive.
  assert (Hcut' : 0 <= t * (4 - delta * (2 * eta - t)) * (1 - cos x)).
  { apply Rmult_le_pos; [apply Rmult_le_pos|]; try lra.
    assert (delta * (2 * eta - t) <= 1 * (2 * eta - t)) by (apply Rmult_le_compat_r; lra). lra. }
  unfold shoulder_gap, haunch_gap, extrados, intrados, fac in *. repeat split; try lra.
Qed.

Lemma margins_positive_near (delta eta mu h p x0 : R) : 0 < shoulder_gap delta x0 eta h p ->
  0 < haunch_gap delta x0 eta h p -> 0 < inward_gap x0 mu h -> 0 < outward_gap x0 mu h -> exists d, 0 < d /\
  forall x, Rabs (x - x0) < d -> 0 < shoulder_gap delta x eta h p /\ 0 < haunch_gap delta x eta h p /\
  0 < inward_gap x mu h /\ 0 < outward_gap x mu h.
Proof.
  intros HU HL HI HO. destruct (margins_continuous delta eta mu h p) as (CU & CL & CI & CO).
  assert (Hnear : forall f : R -> R, continuity f -> 0 < f x0 ->
            exists d, 0 < d /\ forall x, Rabs (x - x0) < d -> 0 < f x).
  { intros f Hf Hpos. destruct (Hf x0 (f x0) Hpos) as (d & Hd & H). exists d. split; [easy|]. intros x Hx.
    destruct (Req_dec x0 x) as [<- | Hne]; [easy|]. assert (Hclose := H x (conj (conj I Hne) Hx)). simpl in Hclose.
    unfold R_dist in Hclose. apply Rabs_def2 in Hclose. lra. }
  destruct (Hnear _ CU HU) as (d1 & Hd1 & H1). destruct (Hnear _ CL HL) as (d2 & Hd2 & H2).
  destruct (Hnear _ CI HI) as (d3 & Hd3 & H3). destruct (Hnear _ CO HO) as (d4 & Hd4 & H4).
  exists (Rmin (Rmin d1 d2) (Rmin d3 d4)). split; [repeat apply Rmin_glb_lt; easy|]. intros x Hx.
  apply Rmin_Rgt_l in Hx. destruct Hx as [Hx Hx']. apply Rmin_Rgt_l in Hx, Hx'.
  repeat split; [apply H1 | apply H2 | apply H3 | apply H4]; lra.
Qed.

Theorem wider_arch_stands (delta alpha eta mu h p : R) : 0 < alpha < PI -> 0 < eta ->
  leaves_room delta alpha eta mu h p -> exists alpha', alpha < alpha' < PI /\ arch_stands delta alpha' eta mu.
Proof.
  intros Ha He Hroom. destruct (Hroom alpha ltac:(lra)) as (HU & HL & HI & HO).
  destruct (margins_positive_near delta eta mu h p alpha HU HL HI HO) as (d & Hd & H).
  destruct (below_both (d / 2) ((PI - alpha) / 2)) as (t & Ht & B1 & B2); [lra | lra |]. exists (alpha + t).
  split; [lra|]. apply (stands_by_margins delta (alpha + t) eta mu h p He). intros x Hx.
  destruct (Rle_lt_dec x alpha) as [Hin | Hout]; [destruct (Hroom x ltac:(lra)) as (U & L & I & O); lra
    | destruct (H x) as (U & L & I & O); [rewrite Rabs_pos_eq; lra | lra]].
Qed.

(** Very narrow arches have room. *)
Theorem narrow_arch_stands (delta eta mu : R) : 0 < eta <= 2 -> 0 < mu ->
  exists alpha, 0 < alpha < PI /\ arch_stands delta alpha eta mu.
Proof.
  intros He Hmu. assert (HPI := PI_RGT_0). destruct (margins_positive_near delta eta mu 1 1 0) as (d & Hd & H).
  1-4: unfold shoulder_gap, haunch_gap, inward_gap, outward_gap, normal_force, shear_force;
    rewrite cos_0, sin_0; unfold extrados, intrados; lra.
  destruct (below_both (d / 2) (PI / 2)) as (t & Ht & B1 & B2); [lra | lra |]. exists t. split; [lra|].
  apply (stands_by_margins delta t eta mu 1 1); [lra|]. intros x Hx.
  destruct (H x) as (U & L & I & O); [rewrite Rabs_pos_eq; lra | lra].
Qed.

(** ** What cannot be thinner, or wider, moves *)

Theorem moves_if_none_thinner (delta alpha eta mu h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 ->
  0 < mu -> (forall eta', 0 < eta' < eta -> ~ arch_stands delta alpha eta' mu) ->
  admissible_state delta alpha eta mu h p -> state_moves delta alpha eta mu h p.
Proof.
  intros Hd Ha He Hmu Hnone Hstate.
  destruct (moves_or_leaves_room Hstate Hd Ha He Hmu) as [Hmoves | (h' & p' & Hroom)]; [easy | exfalso].
  destruct (thinner_arch_stands delta alpha eta mu h' p' Hd ltac:(lra) He)
    as (eta' & He' & Hstands); [|now apply (Hnone eta')].
  intros x Hx. destruct (Hroom x Hx) as (HU & HL & HI & HO). lra.
Qed.

Theorem moves_if_none_wider (delta alpha eta mu h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 ->
  0 < mu -> (forall alpha', alpha < alpha' < PI -> ~ arch_stands delta alpha' eta mu) ->
  admissible_state delta alpha eta mu h p -> state_moves delta alpha eta mu h p.
Proof.
  intros Hd Ha He Hmu Hnone Hstate.
  destruct (moves_or_leaves_room Hstate Hd Ha He Hmu) as [Hmoves | (h' & p' & Hroom)]; [easy | exfalso].
  destruct (wider_arch_stands delta alpha eta mu h' p' Ha ltac:(lra) Hroom) as (alpha' & Ha' & Hstands).
  now apply (Hnone alpha').
Qed.
