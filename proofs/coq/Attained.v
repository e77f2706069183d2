(** * The limit of arches that stand stands

    So the least thickness of an arch is attained, and so is the widest half-angle of a thickness; there every state
    moves, and to each thickness and friction belongs one half-angle with a mechanism. Thrusts of at most 1 are enough,
    so that their limit is one. *)

From Coq Require Import Classical.
From Couplet Require Import Overturning Surveys Thrusts Room.

(** ** Limits, without choosing a sequence *)

Section Limits.

(** [near d t]: the thing [t] is as near as [d]; things that are nearer are near. *)
Variables (T : Type) (near : R -> T -> Prop).
Hypothesis nearer : forall d d' t, 0 < d <= d' -> near d t -> near d' t.

Definition tends (f : T -> R) (l : R) : Prop :=
  forall eps, 0 < eps -> exists d, 0 < d /\ forall t, near d t -> Rabs (f t - l) < eps.

(** Coquelicot's limit along a filter. *)
Definition vicinity (P : T -> Prop) : Prop := exists d, 0 < d /\ forall t, near d t -> P t.

Instance vicinity_is_filter : Filter vicinity.
Proof.
  constructor.
  - exists 1. split; [lra | easy].
  - intros P Q (d & Hd & HP) (e & He & HQ). destruct (below_both d e Hd He) as (c & Hc & H1 & H2). exists c.
    split; [easy|]. intros t Ht. split; [apply HP | apply HQ]; apply (nearer c); easy.
  - intros P Q H (d & Hd & HP). exists d. split; [easy|]. intros t Ht. now apply H, HP.
Qed.

Lemma tends_along (f : T -> R) (l : R) : tends f l <-> filterlim f vicinity (locally l).
Proof.
  split.
  - intros H P [eps HP]. destruct (H eps (cond_pos eps)) as (d & Hd & Hall). exists d. split; [easy|]. intros t Ht.
    apply HP, Hall, Ht.
  - intros H eps Heps. apply (H (fun y => Rabs (y - l) < eps)). now exists (mkposreal eps Heps).
Qed.

Lemma tends_constant (c : R) : tends (fun _ => c) c.
Proof. intros eps Heps. exists 1. split; [lra|]. intros t _. now rewrite Rminus_eq_0, Rabs_R0. Qed.

Lemma tends_plus (f g : T -> R) (l m : R) : tends f l -> tends g m -> tends (fun t => f t + g t) (l + m).
Proof. rewrite !tends_along. intros Hf Hg. exact (filterlim_comp_2 f g Rplus Hf Hg (filterlim_plus l m)). Qed.

Lemma tends_times (f g : T -> R) (l m : R) : tends f l -> tends g m -> tends (fun t => f t * g t) (l * m).
Proof. rewrite !tends_along. intros Hf Hg. exact (filterlim_comp_2 f g Rmult Hf Hg (filterlim_mult l m)). Qed.

Lemma tends_through (c : R -> R) (f : T -> R) (l : R) : continuity c -> tends f l -> tends (fun t => c (f t)) (c l).
Proof.
  rewrite !tends_along. intros Hc Hf. apply (filterlim_comp _ _ _ f c _ (locally l)); [easy|].
  apply continuity_pt_filterlim, Hc.
Qed.

Lemma tends_opp (f : T -> R) (l : R) : tends f l -> tends (fun t => - f t) (- l).
Proof. apply tends_through. reg. Qed.

(** A limit of numbers that are not negative is not, as long as there is something near. *)
Lemma limit_not_negative (f : T -> R) (l : R) : tends f l ->
  (forall d, 0 < d -> exists t, near d t /\ 0 <= f t) -> 0 <= l.
Proof.
  intros Hf Hsome. apply Rnot_lt_le. intros Hl. destruct (Hf (- l) ltac:(lra)) as (d & Hd & H).
  destruct (Hsome d Hd) as (t & Ht & Hpos). assert (A := H t Ht). apply Rabs_def2 in A. lra.
Qed.

End Limits.

(** The limit of an expression, by those of its variables. *)
Ltac tending := unfold Rminus, Rdiv;
  repeat first [assumption | apply tends_constant | apply tends_plus | apply tends_times | apply tends_opp].

(** What numbers of a bounded range do however near, they do near one of them. *)
Lemma number_that_is_met (P : R -> R -> Prop) (low high : R) : (forall d d' x, 0 < d <= d' -> P d x -> P d' x) ->
  (forall d, 0 < d -> exists x, low <= x <= high /\ P d x) ->
  exists x0, forall d, 0 < d -> exists x, Rabs (x - x0) < d /\ P d x.
Proof.
  intros Hnearer Hsome. set (S := fun t => forall d, 0 < d -> exists x, t <= x <= high /\ P d x).
  destruct (completeness S) as (x0 & Hupper & Hleast).
  - exists high. intros t Ht. destruct (Ht 1 ltac:(lra)) as (x & Hx & _). lra.
  - exists low. exact Hsome.
  - exists x0. intros d Hd. assert (Hbelow : exists t, S t /\ x0 - d < t).
    { destruct (classic (exists t, S t /\ x0 - d < t)) as [H | H]; [easy | exfalso].
      enough (x0 <= x0 - d) by lra. apply Hleast. intros t Ht. apply Rnot_lt_le. intros Hlt. apply H. now exists t. }
    assert (Habove : exists d', 0 < d' /\ forall x, P d' x -> x <= high -> x < x0 + d).
    { destruct (classic (exists d', 0 < d' /\ forall x, P d' x -> x <= high -> x < x0 + d)) as [H | H];
        [easy | exfalso]. enough (S (x0 + d)) by (assert (x0 + d <= x0) by (now apply Hupper); lra). intros d' Hd'.
      apply NNPP. intros Hnone. apply H. exists d'. split; [easy|]. intros x Hx Hhigh.
      apply Rnot_le_lt. intros Hle. apply Hnone. exists x. split; [lra | easy]. }
    destruct Hbelow as (t & Ht & Hlow), Habove as (d' & Hd' & Hhigh).
    destruct (below_both d d' Hd Hd') as (e & He & E1 & E2). destruct (Ht e He) as (x & Hx & HP). exists x. split.
    + assert (x < x0 + d) by (apply Hhigh; [apply (Hnearer e); [lra | easy] | lra]). apply Rabs_def1; lra.
    + apply (Hnearer e); [lra | easy].
Qed.

(** ** Arches near an arch *)

(** Half-angle, thickness, thrust and moment of a state. *)
Record state_of_arch := { at_alpha : R; at_eta : R; at_h : R; at_p : R }.

Section Limit.

Variables (delta mu alpha eta : R).
Hypotheses (flag : 0 <= delta <= 1) (rough : 0 < mu) (opening : 0 < alpha <= PI) (thickness : 0 <= eta <= 2).

Definition is_near (d : R) (t : state_of_arch) : Prop :=
  Rabs (at_alpha t - alpha) < d /\ Rabs (at_eta t - eta) < d /\
  0 < at_alpha t <= PI /\ 0 < at_eta t <= 2 /\
  admissible_state delta (at_alpha t) (at_eta t) mu (at_h t) (at_p t).

Ltac its_distance := intros e He; exists e; split; [easy |]; intros t Ht; hnf in Ht; unfold is_near in Ht; tauto.

Lemma is_nearer (d d' : R) (t : state_of_arch) : 0 < d <= d' -> is_near d t -> is_near d' t.
Proof. intros Hd (Ha & He & H). repeat split; try apply H; lra. Qed.

Lemma facts_of_near (d : R) (t : state_of_arch) : is_near d t ->
  0 < at_h t /\ intrados (at_eta t) * at_h t <= at_p t <= extrados (at_eta t) * at_h t.
Proof.
  intros (_ & _ & Ha & He & Hall). split.
  - apply (friction_needs_thrust delta (at_alpha t) (at_eta t) mu (at_h t) (at_p t)); [lra | lra | exact Hall].
  - destruct (Hall 0 ltac:(lra)) as [(_ & Hin & Hout) _]. unfold normal_force in *. rewrite cos_0, sin_0 in *. lra.
Qed.

(** *** Bounded thrusts *)

Lemma limit_of_bounded_thrusts (H : R) : (forall d, 0 < d -> exists t, is_near d t /\ at_h t <= H) ->
  0 < eta /\ arch_stands delta alpha eta mu.
Proof.
  intros Hsome.
  destruct (number_that_is_met (fun d h => exists t, is_near d t /\ at_h t <= H /\ h = at_h t) 0 H) as (h & Hh).
  { intros d d' x Hd (t & Ht & E). exists t. split; [now apply (is_nearer d) | easy]. }
  { intros d Hd. destruct (Hsome d Hd) as (t & Ht & HH). exists (at_h t). destruct (facts_of_near d t Ht) as [Hpos _].
    split; [lra | now exists t]. }
  destruct (number_that_is_met (fun d p => exists t, is_near d t /\ Rabs (at_h t - h) < d /\ at_h t <= H /\
    p = at_p t) 0 (2 * H)) as (p & Hp).
  { intros d d' x Hd (t & Ht & Hclose & E). exists t. split; [now apply (is_nearer d)|]. split; [lra | easy]. }
  { intros d Hd. destruct (Hh d Hd) as (x & Hx & t & Ht & HH & ->). exists (at_p t).
    destruct (facts_of_near d t Ht) as [Hpos Hmoment]. assert (Ht' := Ht). destruct Ht' as (_ & _ & _ & D & _).
    assert (0 <= intrados (at_eta t) * at_h t) by positive.
    assert (extrados (at_eta t) * at_h t <= 2 * H) by (apply Rmult_le_compat; try (unfold extrados; lra); lra).
    split; [lra|]. exists t. exact (conj Ht (conj Hx (conj HH eq_refl))). }
  set (near := fun d t => is_near d t /\ Rabs (at_h t - h) < d /\ Rabs (at_p t - p) < d).
  assert (Hnear : forall d, 0 < d -> exists t, near d t).
  { intros d Hd. destruct (Hp d Hd) as (x & Hx & t & Ht & Hclose & _ & ->). now exists t. }
  assert (Hnearer : forall d d' t, 0 < d <= d' -> near d t -> near d' t).
  { intros d d' t Hd (Ht & A & B). split; [now apply (is_nearer d) | split; lra]. }
  assert (Te : tends _ near at_eta eta) by its_distance. assert (Th : tends _ near at_h h) by its_distance.
  assert (Tp : tends _ near at_p p) by its_distance. assert (Ta : tends _ near at_alpha alpha) by its_distance.
  (* each joint is a limit of joints of the arches *)
  assert (Hall : forall x, 0 <= x <= alpha -> 0 <= shoulder_gap delta x eta h p /\ 0 <= haunch_gap delta x eta h p /\
    0 <= inward_gap x mu h /\ 0 <= outward_gap x mu h).
  { intros x Hx. set (y := fun t => x * / alpha * at_alpha t). assert (Ty : tends _ near y x).
    { replace x with (x * / alpha * alpha) by (field; lra). now tending. }
    assert (TS := tends_through _ _ sin y x continuity_sin Ty).
    assert (TC := tends_through _ _ cos y x continuity_cos Ty).
    assert (Harches : forall d, 0 < d -> exists t, near d t /\
      0 <= shoulder_gap delta (y t) (at_eta t) (at_h t) (at_p t) /\
      0 <= haunch_gap delta (y t) (at_eta t) (at_h t) (at_p t) /\
      0 <= inward_gap (y t) mu (at_h t) /\ 0 <= outward_gap (y t) mu (at_h t)).
    { intros d Hd. destruct (Hnear d Hd) as (t & Ht). exists t. split; [easy |].
      destruct Ht as ((_ & _ & Ha & _ & Hstate) & _). apply (margins_not_negative Hstate).
      assert (0 <= x * / alpha <= 1).
      { split; [apply Rdiv_le_0_compat; lra |]. apply (Rmult_le_reg_r alpha); [lra |]. field_simplify; lra. }
      unfold y. nra. }
    repeat split;
      [apply (limit_not_negative _ near (fun t => shoulder_gap delta (y t) (at_eta t) (at_h t) (at_p t)))
      | apply (limit_not_negative _ near (fun t => haunch_gap delta (y t) (at_eta t) (at_h t) (at_p t)))
      | apply (limit_not_negative _ near (fun t => inward_gap (y t) mu (at_h t)))
      | apply (limit_not_negative _ near (fun t => outward_gap (y t) mu (at_h t)))];
      try (intros d Hd; destruct (Harches d Hd) as (t & Ht & HU & HL & HI & HO); now exists t);
      unfold shoulder_gap, haunch_gap, inward_gap, outward_gap, normal_force, shear_force, intrados, extrados, fac;
      simpl; now tending. }
  assert (He : 0 < eta).
  { destruct (Req_dec eta 0) as [E | E]; [exfalso | lra]. assert (Hline : forall x, 0 < x <= alpha -> A x = h + 1).
    { intros x Hx. destruct (Hall x ltac:(lra)) as (U & L & _). destruct (Hall 0 ltac:(lra)) as (U0 & L0 & _).
      assert (Hv : 0 < 1 - cos x) by positive.
      unfold shoulder_gap, haunch_gap, extrados, intrados, fac, normal_force in *.
      rewrite E, cos_0, sin_0 in *. unfold A. apply (Rmult_eq_reg_r (1 - cos x)); [|lra].
      replace (x * sin x / (1 - cos x) * (1 - cos x)) with (x * sin x) by (field; lra). lra. }
    assert (HPI := PI_RGT_0). assert (Habsurd : alpha = alpha / 2); [|lra]. apply A_injective; try lra.
    rewrite !Hline; lra. }
  split; [easy|]. now apply (stands_by_margins delta alpha eta mu h p).
Qed.

Theorem limit_of_arches_stands : (forall d, 0 < d -> exists alpha' eta', Rabs (alpha' - alpha) < d /\
    Rabs (eta' - eta) < d /\ 0 < alpha' <= PI /\ 0 < eta' <= 2 /\ arch_stands delta alpha' eta' mu) -> 0 < eta /\
  arch_stands delta alpha eta mu.
Proof.
  intros Hsome. apply (limit_of_bounded_thrusts 1). intros d Hd.
  destruct (Hsome d Hd) as (a & e & Ha & He & Ha' & He' & Hstands).
  destruct (thrust_at_most_one delta flag a e mu Ha' He' rough Hstands) as (h & p & Hh & Hall).
  exists {| at_alpha := a; at_eta := e; at_h := h; at_p := p |}.
  exact (conj (conj Ha (conj He (conj Ha' (conj He' Hall)))) Hh).
Qed.

End Limit.

(** ** The least thickness and the widest half-angle *)

(** The least of a set of numbers to which all limits of it belong. *)
Lemma least_is_attained (E : R -> Prop) (low high : R) : E high -> (forall x, E x -> low <= x) ->
  (forall x, low <= x <= high -> (forall d, 0 < d -> exists y, Rabs (y - x) < d /\ E y) -> E x) ->
  exists x, E x /\ forall y, E y -> x <= y.
Proof.
  intros Hhigh Hlow Hclosed. destruct (completeness (fun y => E (- y))) as (m & Hupper & Hleast).
  - exists (- low). intros y Hy. apply Hlow in Hy. lra.
  - exists (- high). now rewrite Ropp_involutive.
  - exists (- m). split.
    + assert (- high <= m) by (apply Hupper; now rewrite Ropp_involutive).
      assert (m <= - low) by (apply Hleast; intros y Hy; apply Hlow in Hy; lra). apply Hclosed; [lra |]. intros d Hd.
      apply NNPP. intros Hnone. enough (m <= m - d) by lra. apply Hleast. intros y Hy. apply Rnot_lt_le. intros Hlt.
      apply Hnone. exists (- y). split; [|easy]. assert (y <= m) by (now apply Hupper). apply Rabs_def1; lra.
    + intros y Hy. assert (- y <= m) by (apply Hupper; now rewrite Ropp_involutive). lra.
Qed.

(** An arch that stands with some thickness stands exactly from one thickness on, and moves there in
    each of its states. *)
Theorem least_thickness_is_attained (delta alpha mu eta0 : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < mu ->
  0 < eta0 <= 2 -> arch_stands delta alpha eta0 mu -> exists eta, 0 < eta <= eta0 /\
  (forall eta', 0 < eta' <= 2 -> arch_stands delta alpha eta' mu <-> eta <= eta') /\
  (forall h p, admissible_state delta alpha eta mu h p -> state_moves delta alpha eta mu h p).
Proof.
  intros Hd Ha Hmu He0 Hstands.
  destruct (least_is_attained (fun e => 0 < e <= eta0 /\ arch_stands delta alpha e mu) 0 eta0)
    as (eta & (He & Heta) & Hleast); [split; [lra | easy] | intros x Hx; lra | |].
  { intros x Hx0 Hx. destruct (limit_of_arches_stands delta mu alpha x Hd Hmu ltac:(lra) ltac:(lra)) as [Hpos H].
    - intros d Hd'. destruct (Hx d Hd') as (y & Hy & Hy0 & H). exists alpha, y.
      replace (alpha - alpha) with 0 by ring. rewrite Rabs_R0. repeat split; try easy; lra.
    - split; [lra | easy]. }
  assert (Hexactly : forall eta', 0 < eta' <= 2 -> arch_stands delta alpha eta' mu <-> eta <= eta').
  { intros eta' He'. split.
    - intros H. destruct (Rle_lt_dec eta' eta0) as [Hle | Hlt]; [|lra]. apply Hleast. split; [lra | easy].
    - intros Hle. apply (narrower_rougher_thicker_stands delta alpha alpha eta eta' mu mu); try easy; lra. }
  exists eta. split; [easy | split; [easy|]]. intros h p Hstate. apply moves_if_none_thinner; try easy; try lra.
  intros eta' He' H. apply Hexactly in H; lra.
Qed.

(** Above the least thickness no hinge moves: what is left is pure sliding, *)
Theorem only_sliding_above_the_least (delta alpha beta sigma eta eta' mu h p u l v s t : R) : 0 <= delta <= 1 ->
  0 < alpha < PI -> 0 < mu -> 0 < eta < eta' -> eta' <= 2 -> 0 <= beta <= alpha -> 0 < sigma <= alpha ->
  arch_stands delta alpha eta mu -> admissible_state delta alpha eta' mu h p -> 0 < u + l + v + s + t ->
  moves delta alpha beta sigma eta' mu h p u l v s t ->
  u = 0 /\ l = 0 /\ v = 0 /\ 0 < s /\ 0 < t /\ inward_gap sigma mu h = 0 /\ outward_gap alpha mu h = 0.
Proof.
  intros Hd Ha Hmu He He' Hb Hs Hstands Hstate Hsome Hmoves.
  assert (HN : forall x, 0 <= x <= alpha -> 0 < normal_force x h)
    by (intros x Hx; apply (@compressed delta alpha eta' mu h p); try easy; lra).
  destruct (no_motion_above_the_least delta alpha beta sigma eta eta' mu h p u l v s t)
    as (-> & -> & ->); try easy; try lra; try (apply HN; lra).
  destruct Hmoves as ((_ & _ & _ & Hs0 & Ht0) & (_ & Hbalance) & _ & _ & _ & HI & HO).
  assert (0 < sin sigma) by positive. assert (0 < sin alpha) by positive.
  assert (E : s * sin sigma = t * sin alpha) by lra. assert (0 < s).
  { destruct (Req_dec s 0) as [Z | Z]; [|lra]. rewrite Z, Rmult_0_l in E.
    assert (t = 0) by (apply (factor_zero t (sin alpha)); lra). lra. }
  assert (0 < t).
  { destruct (Req_dec t 0) as [Z | Z]; [|lra]. rewrite Z, Rmult_0_l in E.
    assert (s = 0) by (apply (factor_zero s (sin sigma)); lra). lra. }
  repeat split; try easy; [apply (Rmult_eq_reg_l s) | apply (Rmult_eq_reg_l t)]; lra.
Qed.

(** and then it moves the arch at each thickness that stands, as the thrust is the same in all states. *)
Theorem sliding_does_not_see_the_thickness (sigma alpha mu h h' : R) : 0 < sigma -> 0 < alpha ->
  0 < normal_force sigma h -> 0 < normal_force alpha h -> inward_gap sigma mu h = 0 -> outward_gap alpha mu h = 0 ->
  0 <= inward_gap sigma mu h' -> 0 <= outward_gap alpha mu h' -> h' = h.
Proof.
  intros Hs Ha HNs HNa HI HO HI' HO'. destruct (slip_rows_are_scaled sigma mu h h' HNs) as [Hin _].
  destruct (slip_rows_are_scaled alpha mu h h' HNa) as [_ Hout]. assert (E := Hin HI). assert (E' := Hout HO).
  assert (0 <= normal_force sigma h * inward_gap sigma mu h') by positive.
  assert (0 <= normal_force alpha h * outward_gap alpha mu h') by positive.
  apply Rle_antisym; apply Rnot_lt_le; intros Hless.
  - assert (0 < alpha * (h' - h)) by positive. lra.
  - assert (0 < sigma * (h - h')) by positive. lra.
Qed.

(** To each thickness and friction belongs one half-angle: narrower arches stand, wider ones do not,
    and there alone the states move. *)
Theorem one_half_angle (delta eta mu : R) : 0 <= delta <= 1 -> 0 < eta <= 2 -> 0 < mu -> exists alpha,
  0 < alpha < PI /\ (forall alpha', 0 < alpha' <= PI -> arch_stands delta alpha' eta mu <-> alpha' <= alpha) /\
  (forall h p, admissible_state delta alpha eta mu h p -> state_moves delta alpha eta mu h p) /\
  (forall alpha' h p, 0 < alpha' < alpha -> admissible_state delta alpha' eta mu h p ->
    ~ state_moves delta alpha' eta mu h p).
Proof.
  intros Hd He Hmu. assert (HPI := PI_RGT_0).
  destruct (narrow_arch_stands delta eta mu He Hmu) as (alpha0 & Ha0 & Hstands0).
  assert (Hflat : ~ arch_stands delta PI eta mu)
    by (intros H; apply (no_flat_arch delta) in H; lra).
  destruct (least_is_attained (fun x => alpha0 <= PI - x /\ 0 <= x /\
    arch_stands delta (PI - x) eta mu) 0 (PI - alpha0)) as (x & (Hx & Hx0 & Hstands) & Hleast).
  { replace (PI - (PI - alpha0)) with alpha0 by ring. repeat split; try lra. exact Hstands0. }
  { intros y Hy. lra. }
  { intros y Hy0 Hy.
    split; [lra | split; [lra|]]. apply (limit_of_arches_stands delta mu (PI - y) eta Hd Hmu); try lra. intros d Hd'.
    destruct (Hy d Hd') as (z & Hz & Hz0 & Hz1 & H). exists (PI - z), eta.
    replace (PI - z - (PI - y)) with (- (z - y)) by ring. rewrite Rabs_Ropp. replace (eta - eta) with 0 by ring.
    rewrite Rabs_R0. repeat split; try easy; lra. }
  assert (Hpos : 0 < x).
  { destruct (Req_dec x 0) as [E | E]; [exfalso | lra]. apply Hflat. revert Hstands. rewrite E, Rminus_0_r. easy. }
  assert (Hexactly : forall alpha', 0 < alpha' <= PI -> arch_stands delta alpha' eta mu <-> alpha' <= PI - x).
  { intros alpha' Ha'. split.
    - intros H. destruct (Rle_lt_dec alpha0 alpha') as [Hle | Hlt]; [|lra]. enough (x <= PI - alpha') by lra.
      apply Hleast. replace (PI - (PI - alpha')) with alpha' by ring. repeat split; try lra. exact H.
    - intros Hle. apply (narrower_rougher_thicker_stands delta (PI - x) alpha' eta eta mu mu); try easy; lra. }
  exists (PI - x). split; [lra|]. split; [easy|]. split.
  - intros h p Hstate. apply moves_if_none_wider; try easy; try lra. intros alpha' Ha' H. apply Hexactly in H; lra.
  - intros alpha' h p Ha' Hstate (beta & sigma & u & l & v & s & t & Hb & Hs & Hsome & Hmoves).
    assert (HN : forall y, 0 <= y <= alpha' -> 0 < normal_force y h)
      by (intros y Hy; apply (@compressed delta alpha' eta mu h p); try easy; lra).
    destruct (no_motion_below_the_widest delta alpha' (PI - x) beta sigma eta mu h p u l v s t)
      as (-> & -> & -> & -> & ->); try easy; try lra; apply HN; lra.
Qed.

(** ** Along a way *)

(** Where each arch that stands is followed by some that stand, all do. *)
Theorem goes_on_standing (delta mu : R) (alpha eta : R -> R) : 0 <= delta <= 1 -> 0 < mu ->
  (forall t, 0 <= t <= 1 -> (0 < alpha t <= PI /\ continuity_pt alpha t) /\ 0 < eta t <= 2 /\ continuity_pt eta t) ->
  arch_stands delta (alpha 0) (eta 0) mu ->
  (forall t, 0 <= t < 1 -> arch_stands delta (alpha t) (eta t) mu ->
     exists u, t < u /\ forall s, t < s < u -> arch_stands delta (alpha s) (eta s) mu) ->
  forall t, 0 <= t <= 1 -> arch_stands delta (alpha t) (eta t) mu.
Proof.
  intros Hd Hmu Hway Hfirst Hnext t Ht. set (stands := fun s => arch_stands delta (alpha s) (eta s) mu).
  destruct (completeness (fun y => 0 <= y <= t /\ forall s, 0 <= s <= y -> stands s)) as (T & Hup & Hleast).
  { exists t. intros y Hy. lra. }
  { exists 0. split; [lra |]. intros s Hs. now replace s with 0 by lra. }
  assert (HT : 0 <= T <= t).
  { split; [apply Hup | apply Hleast; intros y Hy; lra]. split; [lra |]. intros s Hs. now replace s with 0 by lra. }
  assert (Hbelow : forall s, 0 <= s < T -> stands s).
  { intros s Hs. apply NNPP. intros Hno. enough (T <= s) by lra. apply Hleast. intros y [Hy Hall].
    apply Rnot_lt_le. intros Hlt. apply Hno, Hall. lra. }
  assert (Hat : stands T).
  { destruct (Req_dec T 0) as [-> | Hne]; [easy |]. destruct (Hway T ltac:(lra)) as ((Ha & Ca) & He & Ce).
    apply (limit_of_arches_stands delta mu (alpha T) (eta T)); try easy; try lra. intros d Hd'.
    destruct (Ca d Hd') as (d1 & Hd1 & H1), (Ce d Hd') as (d2 & Hd2 & H2).
    destruct (below_both d1 d2 Hd1 Hd2) as (e0 & He0 & M & M').
    destruct (below_both T e0) as (e & Hpos & L & L'); [lra | easy |]. exists (alpha (T - e / 2)), (eta (T - e / 2)).
    assert (Hnear : forall d, e <= d -> D_x no_cond T (T - e / 2) /\ Rabs (T - e / 2 - T) < d)
      by (intros d' Hle; split; [split; [easy | lra] | apply Rabs_def1; lra]).
    destruct (Hway (T - e / 2) ltac:(lra)) as ((Ha' & _) & He' & _). assert (S := Hbelow (T - e / 2) ltac:(lra)).
    repeat split; try easy; try lra; [apply H1 | apply H2]; apply Hnear; lra. }
  destruct (Req_dec T t) as [<- | Hne]; [easy |]. destruct (Hnext T ltac:(lra) Hat) as (u & Hu & Hall).
  set (y := Rmin ((T + u) / 2) t). assert (y <= (T + u) / 2) by apply Rmin_l. assert (y <= t) by apply Rmin_r.
  assert (T < y) by (apply Rmin_glb_lt; lra). enough (y <= T) by lra. apply Hup. split; [lra |]. intros s Hs.
  destruct (Rtotal_order s T) as [H' | [-> | H']]; [apply Hbelow | easy | apply Hall]; lra.
Qed.
