(** * The seven modes are all there are

    A symmetric mechanism gives rates that are not negative to finitely many joints of the half arch, each at a limit,
    so that neither the thrust nor the crown moment works on them: hinges at both faces, and joints that slide along
    themselves, without dilatancy. In an admissible state few joints are at their limits, so that it is one of
    [Mechanisms.moves], and with it a sum of four: [x1] is [[r,r,r]], with unlimited friction and no thrust [[r]]; [x2]
    is [[s,r,r]]; [x3] is [[r,r,s]], [[r,s,r]] or [[r,s]], as [beta] is below [sigma], above it or at the crown; [x4] is
    [[s,s]]. The haunch is off the shoulder, it is off the crown where that turns, and the joint that slides inwards is
    off the shoulder. *)

From Coq Require Import List Classical.
Import ListNotations.
From Couplet Require Import Overturning Room.

(** ** Mechanisms of finitely many joints *)

Inductive way := AboutExtrados | AboutIntrados | SlidesInwards | SlidesOutwards.

Record motion := { moves_by : way; at_joint : R; rate : R }.

Definition gap (delta eta mu h p : R) (m : motion) : R :=
  match moves_by m with
  | AboutExtrados => shoulder_gap delta (at_joint m) eta h p
  | AboutIntrados => haunch_gap delta (at_joint m) eta h p
  | SlidesInwards => inward_gap (at_joint m) mu h
  | SlidesOutwards => outward_gap (at_joint m) mu h
  end.

(** The work of a unit thrust on a unit rate, and that of a unit moment. *)
Definition thrust_row (eta : R) (m : motion) : R :=
  match moves_by m with
  | AboutExtrados => extrados eta * cos (at_joint m)
  | AboutIntrados => - (intrados eta * cos (at_joint m))
  | SlidesInwards => sin (at_joint m)
  | SlidesOutwards => - sin (at_joint m)
  end.
Definition moment_row (m : motion) : R := match moves_by m with AboutExtrados => -1 | AboutIntrados => 1 | _ => 0 end.

Fixpoint work (row : motion -> R) (motions : list motion) : R :=
  match motions with
  | m :: rest => rate m * row m + work row rest
  | [] => 0
  end.

Definition is_mechanism (delta alpha eta mu h p : R) (motions : list motion) : Prop :=
  (forall m, In m motions -> 0 <= at_joint m <= alpha /\ 0 <= rate m /\
     rate m * gap delta eta mu h p m = 0) /\
  work (thrust_row eta) motions = 0 /\ work moment_row motions = 0.

(** The rates of each way, added up. *)
Definition of_way (w : way) (m : motion) : R :=
  match w, moves_by m with
  | AboutExtrados, AboutExtrados | AboutIntrados, AboutIntrados
  | SlidesInwards, SlidesInwards | SlidesOutwards, SlidesOutwards => 1
  | _, _ => 0
  end.

(** What the hinges of a mechanism do, where each is at the crown, the haunch or the shoulder, and so
    do the joints that slide. *)
Lemma gathered (delta alpha eta mu h p beta sigma : R) (motions : list motion) :
  (forall m, In m motions -> 0 <= at_joint m <= alpha /\ 0 <= rate m /\ rate m * gap delta eta mu h p m = 0) ->
  (forall x, 0 <= x <= alpha -> shoulder_gap delta x eta h p = 0 -> x = 0 \/ x = alpha) ->
  (forall x, 0 <= x <= alpha -> haunch_gap delta x eta h p = 0 -> x = beta) ->
  (forall m, In m motions -> 0 < rate m -> moves_by m = SlidesInwards -> at_joint m = sigma) ->
  (forall m, In m motions -> 0 < rate m -> moves_by m = SlidesOutwards -> at_joint m = alpha) ->
  exists u l v s t,
    (0 <= u /\ 0 <= l /\ 0 <= v /\ 0 <= s /\ 0 <= t) /\
    u * crown_gap eta h p = 0 /\ l * haunch_gap delta beta eta h p = 0 /\
    v * shoulder_gap delta alpha eta h p = 0 /\ s * inward_gap sigma mu h = 0 /\
    t * outward_gap alpha mu h = 0 /\
    work (thrust_row eta) motions
    = u * extrados eta - l * (intrados eta * cos beta) + v * (extrados eta * cos alpha)
      + s * sin sigma - t * sin alpha /\
    work moment_row motions = l - u - v /\
    work (of_way AboutExtrados) motions = u + v /\ work (of_way AboutIntrados) motions = l /\
    work (of_way SlidesInwards) motions = s /\ work (of_way SlidesOutwards) motions = t.
Proof.
  intros Hall HU HL HI HO. induction motions as [|m motions IH].
  { exists 0, 0, 0, 0, 0. simpl. repeat split; lra. }
  destruct IH as (u & l & v & s & t & Hpos & Eu & El & Ev & Es & Et & W & M & Wu & Wl & Ws & Wt);
    [now intros n Hn; apply Hall; right | now intros n Hn; apply HI; right | now intros n Hn; apply HO; right |].
  destruct (Hall m (or_introl eq_refl)) as (Hx & Hrate & Hzero). assert (HI' := HI m (or_introl eq_refl)).
  assert (HO' := HO m (or_introl eq_refl)). clear Hall HI HO. destruct (Req_dec (rate m) 0) as [E0 | E0].
  { exists u, l, v, s, t. simpl. rewrite E0, !Rmult_0_l, !Rplus_0_l. tauto. }
  assert (Hgap : gap delta eta mu h p m = 0) by (apply (Rmult_eq_reg_l (rate m)); lra).
  assert (0 < rate m) by lra. destruct m as [w x k]. unfold gap in Hgap. destruct w; simpl in *.
  - destruct (HU x Hx Hgap) as [-> | ->].
    + exists (u + k), l, v, s, t.
      assert (Hc : crown_gap eta h p = 0) by (rewrite <- Hgap; symmetry; apply gap_at_crown).
      unfold thrust_row, moment_row, of_way in *. simpl. rewrite W, M, Wu, Wl, Ws, Wt, cos_0. repeat split; nra.
    + exists u, l, (v + k), s, t. unfold thrust_row, moment_row, of_way in *. simpl. repeat split; nra.
  - assert (x = beta) by (now apply HL). subst x. exists u, (l + k), v, s, t.
    unfold thrust_row, moment_row, of_way in *. simpl. repeat split; nra.
  - assert (x = sigma) by (now apply HI'). subst x. exists u, l, v, (s + k), t.
    unfold thrust_row, moment_row, of_way in *. simpl. repeat split; nra.
  - assert (x = alpha) by (now apply HO'). subst x. exists u, l, v, s, (t + k).
    unfold thrust_row, moment_row, of_way in *. simpl. repeat split; nra.
Qed.

(** ** Where the joints are *)

(** [alpha^2] is more than what [A] is below 2. *)
Lemma A_above_parabola (alpha : R) : 0 < alpha < PI -> 2 - alpha ^ 2 < A alpha.
Proof.
  intros Ha. assert (0 < 1 - cos alpha) by positive. unfold A. apply (Rmult_lt_reg_r (1 - cos alpha)); [easy|].
  replace (alpha * sin alpha / (1 - cos alpha) * (1 - cos alpha)) with (alpha * sin alpha) by (field; lra).
  destruct (MVT_cor2 (fun t => t * sin t - (2 - t ^ 2) * (1 - cos t)) (fun t =>
    t - sin t + t * (1 - cos t) + t ^ 2 * sin t) 0 alpha) as (c & Hc & Hin); [lra | |].
  - intros c Hc. auto_derive; [easy | ring].
  - rewrite cos_0, sin_0 in Hc. assert (sin c < c) by (apply sin_lt_x; lra). assert (0 < sin c) by positive.
    assert (0 <= c * (1 - cos c)) by (apply Rmult_le_pos; destruct (COS_bound c); lra).
    assert (0 < c ^ 2 * sin c) by positive. nra.
Qed.

Section Places.

(** The state says of which arch it is. *)
Context {delta alpha eta mu h p : R}.
Hypotheses (state : admissible_state delta alpha eta mu h p) (flag : 0 <= delta <= 1)
  (opening : 0 < alpha < PI) (thickness : 0 < eta <= 2) (rough : 0 < mu).

Let thrust : 0 < h := thrust_positive state opening rough.
Let carries := compressed state flag opening thickness rough.

(** No joint is at both faces, *)
Lemma not_at_both_faces (x : R) : 0 <= x <= alpha ->
  shoulder_gap delta x eta h p = 0 -> haunch_gap delta x eta h p <> 0.
Proof.
  intros Hx EU EL. assert (HN := carries x Hx). unfold shoulder_gap, haunch_gap, extrados, intrados in *. nra.
Qed.

(** nor does one slide both ways. *)
Lemma not_both_ways : inward_gap alpha mu h = 0 -> outward_gap alpha mu h <> 0.
Proof.
  assert (HN := carries alpha ltac:(lra)). unfold inward_gap, outward_gap in *. nra.
Qed.

(** The intrados is not reached at a shoulder that slides outwards: the line of thrust comes from below. *)
Lemma intrados_free_at_sliding_shoulder : outward_gap alpha mu h = 0 -> haunch_gap delta alpha eta h p <> 0.
Proof.
  intros EO EL. assert (HN := carries alpha ltac:(lra)).
  assert (HS : 0 < sin alpha) by positive. assert (Hfac := centroids_positive delta eta ltac:(lra)).
  set (D := (fac delta eta - intrados eta) * sin alpha - intrados eta * shear_force alpha h). assert (HD : 0 < D).
  { unfold outward_gap in EO. unfold D. assert (0 < (fac delta eta - intrados eta) * sin alpha) by positive.
    assert (0 <= intrados eta * - shear_force alpha h) by (apply Rmult_le_pos; unfold intrados; nra). lra. }
  assert (Hderive : derivable_pt_lim (fun x => haunch_gap delta x eta h p) alpha D).
  { unfold haunch_gap, normal_force. auto_derive; [easy|]. unfold D, shear_force. ring. }
  destruct (Hderive D HD) as (d & Hd). set (k := - Rmin (pos d / 2) (alpha / 2)). assert (Hpos := cond_pos d).
  assert (Hk : 0 < - k) by (unfold k; rewrite Ropp_involutive; apply Rmin_glb_lt; lra).
  assert (B1 : - k <= pos d / 2) by (unfold k; rewrite Ropp_involutive; apply Rmin_l).
  assert (B2 : - k <= alpha / 2) by (unfold k; rewrite Ropp_involutive; apply Rmin_r).
  assert (Hclose : Rabs k < d) by (rewrite Rabs_left; lra). assert (H := Hd k ltac:(lra) Hclose).
  apply Rabs_def2 in H. destruct (margins_not_negative state (alpha + k) ltac:(lra)) as (_ & HL & _).
  set (L := haunch_gap delta (alpha + k) eta h p) in *. assert (E : (L - 0) / k = - (L / - k)) by (field; lra).
  assert (0 <= L / - k) by positive. nra.
Qed.

(** A shoulder on the extrados asks for a thrust. *)
Lemma thrust_of_extrados : shoulder_gap delta alpha eta h p = 0 -> A alpha <= h + 1.
Proof.
  intros EU. destruct (margins_not_negative state 0 ltac:(lra)) as (HU & _).
  assert (0 < 1 - cos alpha) by positive. assert (fac delta eta <= extrados eta).
  { unfold fac, extrados. nra. }
  unfold A. apply (Rmult_le_reg_r (1 - cos alpha)); [easy|].
  replace (alpha * sin alpha / (1 - cos alpha) * (1 - cos alpha)) with (alpha * sin alpha) by (field; lra).
  unfold shoulder_gap, normal_force in EU, HU. rewrite cos_0, sin_0 in HU.
  apply (Rmult_le_reg_l (extrados eta)); [unfold extrados; lra|]. nra.
Qed.

(** So the joint where [T/N] is largest is above a shoulder at a limit, *)
Lemma steepest_joint_above : h < 1 ->
  shoulder_gap delta alpha eta h p = 0 \/ outward_gap alpha mu h = 0 -> beta_s h < alpha.
Proof.
  intros H1 Hlimit. assert (HN := carries alpha ltac:(lra)). destruct Hlimit as [EU | EO].
  - assert (HA := thrust_of_extrados EU). assert (Hparabola := A_above_parabola alpha opening).
    assert (Hsquare := beta_s_square h ltac:(lra)). nra.
  - apply Rnot_le_lt. intros H.
    assert (Hgrows := steepness_grows_before_beta_s h 0 alpha ltac:(lra) ltac:(lra) ltac:(lra) H).
    assert (Hshoulder := proj2 (steepness_at_limit alpha mu h HN) EO). unfold steepness at 1 in Hgrows.
    unfold shear_force in Hgrows. rewrite sin_0, Rmult_0_l, Rmult_0_r, Rminus_0_r in Hgrows. lra.
Qed.

(** and if one slides inwards it is that one. *)
Lemma slides_at_steepest_joint (sigma : R) : 0 < sigma <= alpha -> inward_gap sigma mu h = 0 ->
  shoulder_gap delta alpha eta h p = 0 \/ outward_gap alpha mu h = 0 ->
  h < 1 /\ sigma = beta_s h /\ beta_s h < alpha /\ mu = mu_is h.
Proof.
  intros Hs EI Hlimit. assert (HNa := carries alpha ltac:(lra)). assert (HNs := carries sigma ltac:(lra)).
  assert (Hsteep := proj1 (steepness_at_limit sigma mu h HNs) EI). assert (H1 : h < 1).
  { assert (Hbelow := times_cosine_below_sine sigma ltac:(lra)). assert (0 < sin sigma) by positive.
    unfold inward_gap, shear_force in EI. nra. }
  assert (Hb := beta_s_positive h ltac:(lra)). assert (Habove := steepest_joint_above H1 Hlimit).
  assert (Es : sigma = beta_s h).
  { destruct (Req_dec sigma (beta_s h)) as [E | E]; [easy | exfalso].
    assert (Hless := steepest_joint h alpha sigma ltac:(lra) ltac:(lra) HNa ltac:(lra) ltac:(lra) E).
    destruct (margins_not_negative state (beta_s h) ltac:(lra)) as (_ & _ & HI & _).
    assert (steepness (beta_s h) h <= mu); [|lra]. apply steepness_at_most; [apply carries; lra |].
    unfold inward_gap in HI. lra. }
  repeat split; try easy. rewrite mu_is_from_statics by lra. now rewrite <- Es.
Qed.

(** So a shoulder on the extrados does not slide inwards, *)
Lemma extrados_free_at_inward_shoulder : shoulder_gap delta alpha eta h p = 0 -> inward_gap alpha mu h <> 0.
Proof. intros EU EI. destruct (slides_at_steepest_joint alpha) as (_ & Es & Habove & _); try lra; tauto || easy. Qed.

(** So few joints are at their limits. *)
Theorem limits_of_a_state (x y : R) : 0 <= x <= alpha -> 0 <= y <= alpha -> (shoulder_gap delta x eta h p = 0 ->
    x = 0 \/ x = alpha) /\ (haunch_gap delta x eta h p = 0 -> haunch_gap delta y eta h p = 0 -> x = y) /\
  (inward_gap x mu h = 0 -> inward_gap y mu h = 0 -> x = y) /\ (outward_gap x mu h = 0 -> x = alpha) /\
  (inward_gap x mu h = 0 -> shoulder_gap delta alpha eta h p = 0 \/ outward_gap alpha mu h = 0 -> 0 < x < alpha).
Proof.
  split; [|split; [|split; [|split]]].
  - now apply (extrados_reached state).
  - now apply (intrados_reached_once state).
  - now apply (inward_limit_reached_once state).
  - now apply (outward_limit_reached state).
  - intros EI Hlimit. destruct (Req_dec x 0) as [-> | Hne].
    + unfold inward_gap, shear_force in EI. rewrite normal_force_at_crown, sin_0 in EI. nra.
    + destruct (slides_at_steepest_joint x ltac:(lra) EI Hlimit) as (_ & E & Habove & _). lra.
Qed.

(** and what slides inside and at the shoulder is the purely sliding state of the half-angle. *)
Theorem sliding_is_pure (sigma : R) : 0 < sigma <= alpha -> inward_gap sigma mu h = 0 -> outward_gap alpha mu h = 0 ->
  h < 1 /\ sigma = beta_s h /\ mu = mu_is h /\ mu = mu_ss alpha h.
Proof.
  intros Hs EI EO. destruct (slides_at_steepest_joint sigma Hs EI (or_intror EO)) as (H1 & Es & _ & Emu).
  assert (HN := carries alpha ltac:(lra)). repeat split; try easy.
  rewrite shoulder_friction_from_statics, (proj2 (steepness_at_limit alpha mu h HN) EO). ring.
Qed.

(** ** With finite friction *)

(** Every mechanism is one of [moves], with a single haunch and a single joint that slides inwards. *)
Theorem mechanism_is_one_of_moves (motions : list motion) : is_mechanism delta alpha eta mu h p motions ->
  exists beta sigma u l v s t, 0 <= beta <= alpha /\ 0 < sigma <= alpha /\
    moves delta alpha beta sigma eta mu h p u l v s t /\
    work (of_way AboutExtrados) motions = u + v /\ work (of_way AboutIntrados) motions = l /\
    work (of_way SlidesInwards) motions = s /\ work (of_way SlidesOutwards) motions = t.
Proof.
  intros (Hall & Wthrust & Wmoment).
  destruct (@haunch_of_state delta alpha eta mu h p) as (beta & Hb & Hbeta); try easy.
  destruct (@slip_of_state delta alpha eta mu h p) as (sigma & Hs & Hsigma); try easy.
  destruct (gathered delta alpha eta mu h p beta sigma motions)
    as (u & l & v & s & t & Hpos & Eu & El & Ev & Es & Et & W & M & Hways); try easy.
  - intros x Hx E. now apply (@extrados_reached delta alpha eta mu h p).
  - intros m Hm Hrate E. destruct (Hall m Hm) as (Hx & _ & Hzero). unfold gap in Hzero. rewrite E in Hzero.
    apply Hsigma; [easy|]. apply (Rmult_eq_reg_l (rate m)); lra.
  - intros m Hm Hrate E. destruct (Hall m Hm) as (Hx & _ & Hzero). unfold gap in Hzero. rewrite E in Hzero.
    apply (@outward_limit_reached delta alpha eta mu h p); try easy. apply (Rmult_eq_reg_l (rate m)); lra.
  - exists beta, sigma, u, l, v, s, t. repeat split; try easy; try apply Hpos; try apply Hways; try lra.
    replace l with (u + v) in W by lra. lra.
Qed.

(** And that is a sum of the modes, with the joints where these have them. *)
Theorem sum_of_modes (beta sigma u l v s t : R) : 0 <= beta <= alpha -> 0 < sigma <= alpha ->
  moves delta alpha beta sigma eta mu h p u l v s t -> let a := extrados eta - intrados eta * cos beta in
  let b := intrados eta * cos beta - extrados eta * cos alpha in exists x1 x2 x3 x4, 0 <= x1 /\ 0 <= x2 /\ 0 <= x3 /\
  0 <= x4 /\ a * u = x1 + x2 /\ b * v = x1 + x3 /\ sin sigma * s = x3 + x4 /\ sin alpha * t = x2 + x4 /\ l = u + v /\
  0 < a /\ (0 < v -> 0 < b) /\ (0 < x1 \/ 0 < x2 -> 0 < beta < alpha) /\ (0 < x3 -> 0 <= beta < alpha) /\
  (0 < x3 \/ 0 < x4 -> 0 < sigma < alpha) /\ (0 < u + l + v + s + t -> 0 < x1 + x2 + x3 + x4).
Proof.
  intros Hb Hs Hmoves a b. destruct (four_supports delta alpha beta sigma eta mu h p u l v s t)
    as (x1 & x2 & x3 & x4 & P1 & P2 & P3 & P4 & Eu & Ev & Es & Et & El); try easy; try lra. fold a in Eu.
  fold b in Ev. destruct Hmoves as ((Hu & Hl & Hv & Hs0 & Ht) & _ & HC & HL & HU & HI & HO). assert (Ha : 0 < a).
  { unfold a, extrados, intrados. destruct (COS_bound beta).
    assert (-1 < cos beta) by (rewrite <- cos_PI; apply cos_decreasing_1; lra). nra. }
  assert (Hzero : forall k g, 0 < k -> k * g = 0 -> g = 0) by (intros k g Hk E; apply (Rmult_eq_reg_l k); lra).
  assert (HSs : 0 < sin sigma) by positive. assert (HSa : 0 < sin alpha) by positive.
  assert (Hfactor : forall k g x, 0 <= k -> g * k = x -> 0 < x -> 0 < k)
    by (intros k g x Hk E Hx; destruct (Req_dec k 0) as [Z | Z]; [rewrite Z in E|]; lra).
  assert (Harm : 0 < v -> 0 < b).
  { intros Hv0. apply (lever_positive_in_any_state delta alpha beta eta h p); try easy; try lra;
      [apply (Hzero l); [lra | easy] | apply (Hzero v); [lra | easy]]. }
  assert (Hcrown : 0 < u -> 0 < beta).
  { intros Hu0. destruct (Req_dec beta 0) as [E | E]; [exfalso | lra]. apply (not_at_both_faces 0); [lra | |].
    - rewrite gap_at_crown. now apply (Hzero u).
    - assert (EL := Hzero l _ ltac:(lra) HL). now rewrite E in EL. }
  assert (Hshoulder : 0 < v -> beta < alpha).
  { intros Hv0. destruct (Req_dec beta alpha) as [E | E]; [exfalso | lra].
    apply (not_at_both_faces alpha); [lra | now apply (Hzero v)|]. assert (EL := Hzero l _ ltac:(lra) HL).
    now rewrite E in EL. }
  exists x1, x2, x3, x4. do 11 (split; [easy|]). split; [|split; [|split]].
  - split.
    + destruct H as [H | H]; apply Hcrown, (Hfactor u a (x1 + x2)); try easy; lra.
    + destruct H as [H | H].
      * apply Hshoulder, (Hfactor v b (x1 + x3)); try easy; lra.
      * assert (Ht0 : 0 < t) by (apply (Hfactor t (sin alpha) (x2 + x4)); try easy; lra).
        assert (Hu0 : 0 < u) by (apply (Hfactor u a (x1 + x2)); try easy; lra).
        destruct (Req_dec beta alpha) as [E | E]; [exfalso | lra].
        apply intrados_free_at_sliding_shoulder; [now apply (Hzero t)|]. assert (EL := Hzero l _ ltac:(lra) HL).
        now rewrite E in EL.
  - split; [lra|]. apply Hshoulder, (Hfactor v b (x1 + x3)); try easy; lra.
  - intros H. assert (Hs1 : 0 < s) by (apply (Hfactor s (sin sigma) (x3 + x4)); try easy; lra).
    assert (EI := Hzero s _ Hs1 HI). destruct (Req_dec sigma alpha) as [E | E]; [exfalso | lra]. rewrite E in EI.
    destruct H as [H | H].
    + assert (Hv0 : 0 < v) by (apply (Hfactor v b (x1 + x3)); try easy; lra).
      apply extrados_free_at_inward_shoulder; [now apply (Hzero v) | easy].
    + assert (Ht0 : 0 < t) by (apply (Hfactor t (sin alpha) (x2 + x4)); try easy; lra).
      apply not_both_ways; [easy | now apply (Hzero t)].
  - intros Hsome. apply Rnot_le_lt. intros Hnone. assert (Eu0 : u = 0) by (apply (Hzero a); lra).
    assert (Es0 : s = 0) by (apply (Hzero (sin sigma)); lra).
    assert (Et0 : t = 0) by (apply (Hzero (sin alpha)); lra).
    assert (0 < b * v) by (apply Rmult_lt_0_compat; [apply Harm|]; lra). lra.
Qed.

End Places.

(** ** With unlimited friction *)

(** Hinges alone are left, and the only mode is [[r,r,r]], or [[r]] where there is no thrust: then the
    haunch is at the crown, which opens at both faces. *)
Theorem modes_without_limit (delta alpha eta h p : R) (motions : list motion) : 0 <= delta <= 1 -> 0 < alpha < PI ->
  0 < eta <= 2 -> (forall x, 0 <= x <= alpha -> joint_stands delta x eta h p) -> (forall m, In m motions ->
    moves_by m = AboutExtrados \/ moves_by m = AboutIntrados) -> is_mechanism delta alpha eta 0 h p motions ->
  exists beta u v, 0 <= beta <= alpha /\ moves delta alpha beta alpha eta 0 h p u (u + v) v 0 0 /\
  work (of_way AboutExtrados) motions = u + v /\ work (of_way AboutIntrados) motions = u + v /\
  (extrados eta - intrados eta * cos beta) * u = (intrados eta * cos beta - extrados eta * cos alpha) * v /\
  (0 < u + v -> (0 < u /\ 0 < v) /\ (0 < h -> 0 < beta < alpha) /\ (h = 0 -> beta = 0 /\ p = 0)).
Proof.
  intros Hd Ha He Hstate Hhinges (Hall & Wthrust & Wmoment). assert (HPI := PI_RGT_0).
  assert (Hgaps : forall x, 0 <= x <= alpha -> 0 <= shoulder_gap delta x eta h p /\ 0 <= haunch_gap delta x eta h p).
  { intros x Hx. destruct (Hstate x Hx) as (_ & Hin & Hout). unfold shoulder_gap, haunch_gap. lra. }
  assert (Hcrown := gap_at_crown delta eta h p).
  assert (Hh : 0 <= h) by (destruct (Hstate 0 ltac:(lra)) as (HN & _); rewrite normal_force_at_crown in HN; lra).
  assert (Hextrados : forall x, 0 <= x <= alpha -> shoulder_gap delta x eta h p = 0 -> x = 0 \/ x = alpha).
  { intros x Hx E. destruct (Req_dec x 0) as [H0 | H0]; [now left|].
    destruct (Req_dec x alpha) as [H1 | H1]; [now right | exfalso]. destruct (Hgaps 0 ltac:(lra)) as [HC _].
    destruct (Hgaps alpha ltac:(lra)) as [HS _]. assert (H : 0 < shoulder_gap delta x eta h p); [|lra].
    apply (extrados_clear_within delta x alpha); try easy; lra. }
  destruct (named_if_once (fun x => haunch_gap delta x eta h p = 0) alpha) as (beta & Hb & Hbeta); [lra | |].
  { intros x y. apply intrados_touched_once; try easy; try lra. now apply Hgaps. }
  destruct (gathered delta alpha eta 0 h p beta alpha motions)
    as (u & l & v & s & t & Hpos & Eu & El & Ev & Es & Et & W & M & Wu & Wl & Ws & Wt); try easy.
  1-2: intros m Hm _ E; destruct (Hhinges m Hm) as [H | H]; rewrite H in E; easy.
  assert (Hslips : forall w, w = SlidesInwards \/ w = SlidesOutwards -> work (of_way w) motions = 0).
  { intros w Hw. clear - Hhinges Hw. induction motions as [|m motions IH]; [easy|]. simpl.
    rewrite IH; [|now intros n Hn; apply Hhinges; right].
    destruct (Hhinges m (or_introl eq_refl)) as [E | E]; destruct Hw as [-> | ->]; unfold of_way; rewrite E; ring. }
  rewrite (Hslips SlidesInwards) in Ws by tauto. rewrite (Hslips SlidesOutwards) in Wt by tauto. subst s t.
  rewrite Wthrust in W. assert (El' : l = u + v) by lra. rewrite El' in El, W, Wl, Hpos. clear El' M l.
  assert (Hmoves : moves delta alpha beta alpha eta 0 h p u (u + v) v 0 0) by (repeat split; try easy; lra).
  destruct (four_supports delta alpha beta alpha eta 0 h p u (u + v) v 0 0)
    as (x1 & x2 & x3 & x4 & P1 & P2 & P3 & P4 & Fu & Fv & Fs & Ft & _); try easy; try lra.
  assert (x2 = 0 /\ x3 = 0 /\ x4 = 0) as (-> & -> & ->) by lra. exists beta, u, v. split; [easy|]. split; [easy|].
  split; [easy|]. split; [easy|]. split; [lra|]. intros Hsome.
  assert (HL : haunch_gap delta beta eta h p = 0) by (apply (Rmult_eq_reg_l (u + v)); lra).
  assert (Harm : 0 < v -> 0 < intrados eta * cos beta - extrados eta * cos alpha).
  { intros Hv0. apply (lever_positive_in_any_state delta alpha beta eta h p); try easy; try lra.
    apply (Rmult_eq_reg_l v); lra. }
  assert (Harm' : 0 < extrados eta - intrados eta * cos beta).
  { unfold extrados, intrados. destruct (COS_bound beta). nra. }
  assert (Hv0 : 0 < v).
  { destruct (Req_dec v 0) as [Z | Z]; [exfalso | lra]. rewrite Z, Rmult_0_r in Fv. assert (u = 0); [|lra].
    apply (Rmult_eq_reg_l (extrados eta - intrados eta * cos beta)); lra. }
  assert (Hu0 : 0 < u) by nra. assert (HC : crown_gap eta h p = 0) by (apply (Rmult_eq_reg_l u); lra).
  assert (HS : shoulder_gap delta alpha eta h p = 0) by (apply (Rmult_eq_reg_l v); lra). split; [easy|]. split.
  - split.
    + destruct (Req_dec beta 0) as [E | E]; [exfalso | lra]. rewrite E in HL. unfold haunch_gap, normal_force in HL.
      rewrite cos_0, sin_0 in HL. unfold crown_gap, extrados, intrados in *. nra.
    + destruct (Req_dec beta alpha) as [E | E]; [exfalso | lra]. rewrite E in HL.
      assert (Hfac := centroids_positive delta eta ltac:(lra)). assert (Hv : 0 < 1 - cos alpha) by positive.
      assert (0 < fac delta eta * (1 - cos alpha)) by positive. assert (0 <= p).
      { destruct (Hgaps 0 ltac:(lra)) as [_ HL0]. unfold haunch_gap, normal_force in HL0. rewrite cos_0, sin_0 in HL0.
        assert (0 <= intrados eta * h) by positive. lra. }
      unfold shoulder_gap, haunch_gap, extrados, intrados in HS, HL. nra.
  - intros Hh0. split.
    + symmetry. apply Hbeta; [lra|]. unfold haunch_gap, normal_force, crown_gap in *. rewrite cos_0, sin_0, Hh0 in *.
      lra.
    + unfold crown_gap in HC. nra.
Qed.
