(** * Cells of the map: two corners are enough

    What tells the mode of a point of the map: the thrust [hR] of the rotational state of its thickness, the thrust
    [hs] at which an inner joint slides, the half-angle [alphaP] that just slides. No other mode than the one told can
    move an arch there. And from a point with more friction and less thickness to one with less and more the modes
    come in one order, so that between two points of one mode there is no other. *)

From Coq Require Import Lia Compare_dec.
From Couplet Require Import Overturning Room Modes Attained Order Map.

(** The distances of the shoulder from the extrados and of a joint from the intrados, added up: no
    moment of the crown changes it. *)
Definition shoulder_room (delta alpha beta eta h : R) : R :=
  shoulder_gap delta alpha eta h 0 + haunch_gap delta beta eta h 0.

Lemma shoulder_room_of_state (delta alpha beta eta h p : R) :
  shoulder_room delta alpha beta eta h = shoulder_gap delta alpha eta h p + haunch_gap delta beta eta h p.
Proof. unfold shoulder_room, shoulder_gap, haunch_gap. ring. Qed.

(** ** Where a shoulder just slides *)

(** A shoulder that does not slide is within one that just does, *)
Lemma shoulder_that_just_slides (alpha mu h : R) : 0 < alpha < PI -> 0 < mu -> 0 < h ->
  0 <= outward_gap alpha mu h -> exists alpha', alpha <= alpha' < PI /\ outward_gap alpha' mu h = 0.
Proof.
  intros Ha Hmu Hh HO. destruct (Req_dec (outward_gap alpha mu h) 0) as [E | E].
  { exists alpha. split; [lra | easy]. }
  assert (Hcontinuous : continuity (fun x => - outward_gap x mu h))
    by (unfold outward_gap, normal_force, shear_force; reg). assert (outward_gap PI mu h < 0).
  { unfold outward_gap, normal_force, shear_force. rewrite cos_PI, sin_PI. assert (0 < mu * h) by positive. lra. }
  destruct (IVT (fun x => - outward_gap x mu h) alpha PI Hcontinuous ltac:(lra) ltac:(lra) ltac:(lra))
    as (x & Hx & Ex). exists x. destruct (Req_dec x PI) as [-> | Hne]; lra.
Qed.

(** and there is one. *)
Lemma one_shoulder_just_slides (alpha alpha' mu h : R) : 0 < alpha < PI -> 0 < alpha' < PI -> 0 < mu -> 0 < h ->
  0 <= outward_gap alpha mu h -> outward_gap alpha' mu h = 0 -> alpha <= alpha'.
Proof.
  intros Ha Ha' Hmu Hh HO EO. apply Rnot_lt_le. intros H.
  assert (0 < outward_gap alpha' mu h) by (apply (no_outward_limit_within alpha' alpha); lra). lra.
Qed.

(** Within it, where there is room at crown and shoulder there is at the joint between. *)
Lemma room_within (delta alpha alpha' beta eta h : R) : 0 < eta -> 0 < alpha < alpha' -> alpha' < PI ->
  0 <= shoulder_room delta 0 beta eta h -> 0 <= shoulder_room delta alpha' beta eta h ->
  0 < shoulder_room delta alpha beta eta h.
Proof.
  intros He Ha Ha' HC HS. set (p := - haunch_gap delta beta eta h 0).
  assert (EL : haunch_gap delta beta eta h p = 0) by (unfold p, haunch_gap; ring).
  rewrite (shoulder_room_of_state _ _ _ _ _ p), EL, Rplus_0_r in HC.
  rewrite (shoulder_room_of_state _ _ _ _ _ p), EL, Rplus_0_r in HS.
  rewrite (shoulder_room_of_state _ _ _ _ _ p), EL, Rplus_0_r.
  apply (extrados_clear_within delta alpha alpha'); try easy. rewrite gap_at_crown in HC. lra.
Qed.

(** ** The rotational state of a thickness *)

(** With enough friction it is admissible. *)
Lemma rotation_with_enough_friction (delta alpha beta eta : R) : 0 <= delta <= 1 -> 0 < beta < alpha -> alpha < PI ->
  0 < eta < 2 -> rotational_state delta alpha beta eta -> let h := h_lower delta beta eta in
  let p := extrados eta * h in 0 < h /\ crown_gap eta h p = 0 /\ haunch_gap delta beta eta h p = 0 /\
  shoulder_gap delta alpha eta h p = 0 /\ 0 < normal_force alpha h /\ exists mu, 0 < mu /\
  admissible_state delta alpha eta mu h p.
Proof.
  intros Hd Hb Ha He Hstate h p. assert (Hh := rotational_thrust_positive delta alpha beta eta ltac:(lra) He Hstate).
  assert (Hstands := rotational_state_stands delta alpha beta eta ltac:(lra) ltac:(lra) ltac:(lra) He Hstate).
  fold h in Hstands. destruct Hstate as [_ H4]. assert (Hlever := lever_of_lower_thrust_positive beta eta ltac:(lra)).
  assert (E2 : h = h_lower delta beta eta) by easy. apply lower_thrust_cleared in E2; [|lra].
  assert (Hv : 0 < 1 - cos alpha) by positive. fold h in H4. apply whole_thrust_cleared in H4; [|lra|lra].
  split; [easy|]. split; [unfold crown_gap, p; ring|].
  split; [unfold haunch_gap, p, normal_force, extrados, intrados; lra|].
  split; [unfold shoulder_gap, p, normal_force, extrados; lra|]. split; [apply Hstands; lra|].
  assert (CN : continuity (fun x => normal_force x h)) by (unfold normal_force; reg).
  assert (CT : continuity (fun x => Rabs (shear_force x h))).
  { intros x.
    apply (continuity_pt_comp (fun y => shear_force y h) Rabs); [unfold shear_force; reg | apply Rcontinuity_abs]. }
  destruct (continuity_ab_min _ 0 alpha ltac:(lra) (fun x _ => CN x)) as (xn & Hn & Hxn).
  destruct (continuity_ab_maj _ 0 alpha ltac:(lra) (fun x _ => CT x)) as (xt & Ht & Hxt).
  destruct (Hstands xn Hxn) as [Hpos _]. set (n := normal_force xn h) in *. set (t := Rabs (shear_force xt h)) in *.
  assert (Ht0 : 0 <= t) by apply Rabs_pos. assert (Hquotient : 0 <= t / n) by positive. exists (t / n + 1).
  split; [lra|]. intros x Hx. destruct (Hstands x Hx) as [HN Hin]. split.
  - unfold p. rewrite Rmult_comm. now apply joint_stands_iff_thrust_inside.
  - unfold friction_holds. assert (A := Ht x Hx). assert (B := Hn x Hx). apply Rle_trans with ((t / n + 1) * n);
      [replace ((t / n + 1) * n) with (t + n) by (field; lra); lra | apply Rmult_le_compat_l; lra].
Qed.

(** ** A point of the map *)

Section Point.

Variables (delta alpha eta mu : R) (m : mode).
Hypotheses (flag : 0 <= delta <= 1) (opening : 0 < alpha < PI) (thickness : 0 < eta <= 2)
  (rough : 0 < mu) (moved : mode_moves delta alpha eta mu m).

(** Crowns that turn have the thrust of rotation, and that is no less than [hs]. *)
Lemma thrust_of_crown (hs : R) : 0 < hs < 1 -> mu = mu_is hs -> (rank m < 2)%nat ->
  exists alpha0 beta0, 0 < beta0 < alpha0 /\ alpha0 < PI /\ eta < 2 /\
    rotational_state delta alpha0 beta0 eta /\ hs <= h_lower delta beta0 eta.
Proof.
  intros Hs Emu Hr. destruct moved as (h & p & beta & sigma & S & L). assert (Sh := shoulder_of_mode L).
  destruct (crown_of_mode Hr L) as (Hb & EC & EL). assert (Hh := thrust_positive S opening rough).
  destruct (rotational_state_of_crown S flag opening thickness rough beta Hb EC EL)
    as (alpha0 & Ha0 & R & Eh & H1 & _). exists alpha0, beta. split; [lra|]. split; [lra|].
  split; [apply (crown_is_thin S flag opening thickness rough beta Hb EC EL)|]. split; [easy|].
  assert (Hfriction := inner_friction_is_enough S flag opening thickness rough Sh H1). apply Rnot_lt_le. intros Hless.
  assert (mu_is hs < mu_is h) by (apply mu_is_strictly_decreasing; lra). lra.
Qed.

(** With the rotational state of the thickness. *)
Section Rotation.

Variables (alpha0 beta0 : R).
Hypotheses (place : 0 < beta0 < alpha0) (within : alpha0 < PI) (thin : eta < 2)
  (rotation : rotational_state delta alpha0 beta0 eta).

(** Crowns that turn have its thrust, inner joints that slide no less. *)
Lemma thrusts_beside_rotation (h p beta sigma : R) : admissible_state delta alpha eta mu h p ->
  has_limits delta alpha eta mu h p beta sigma m ->
  h_lower delta beta0 eta <= h /\ ((rank m < 2)%nat -> h = h_lower delta beta0 eta).
Proof.
  intros S L. assert (Sh := shoulder_of_mode L).
  destruct (rotation_with_enough_friction delta alpha0 beta0 eta flag place within ltac:(lra) rotation)
    as (Hh0 & EC0 & EL0 & EU0 & _ & mu0 & Hmu0 & S0).
  destruct (crown_thrust_is_less S S0 flag opening thickness rough ltac:(lra) thickness Hmu0 ltac:(lra) beta0 place EC0 EL0 Sh) as [Hle _].
  split; [easy|]. intros Hr. destruct (crown_of_mode Hr L) as (Hb & EC & EL).
  destruct (crown_thrust_is_less S0 S flag ltac:(lra) thickness Hmu0 opening thickness rough ltac:(lra) beta Hb EC EL (or_introl EU0)) as [Hge _].
  lra.
Qed.

(** Where the inner joint asks for less thrust the crown turns. *)
Theorem crown_turns_where_rotation_asks_more (hs : R) : 0 < hs < 1 -> mu = mu_is hs ->
  hs < h_lower delta beta0 eta -> (rank m < 2)%nat.
Proof.
  intros Hs Emu Hless. apply Nat.nle_gt. intros Hr. destruct moved as (h & p & beta & sigma & S & L).
  destruct (thrusts_beside_rotation h p beta sigma S L) as [Hge _]. destruct (slip_of_mode Hr L) as [Hsigma EI].
  destruct (slides_at_steepest_joint S flag opening thickness rough sigma Hsigma EI
              (shoulder_of_mode L)) as (H1 & _ & _ & Eh).
  assert (mu_is h < mu_is hs) by (apply mu_is_strictly_decreasing; lra). lra.
Qed.

(** Where it asks for more it does not. *)
Theorem inner_joint_slides_where_it_asks_more (hs : R) : 0 < hs < 1 -> mu = mu_is hs ->
  h_lower delta beta0 eta < hs -> (2 <= rank m)%nat.
Proof.
  intros Hs Emu Hmore. apply Nat.nlt_ge. intros Hr. destruct moved as (h & p & beta & sigma & S & L).
  destruct (thrusts_beside_rotation h p beta sigma S L) as [_ Heq]. specialize (Heq Hr).
  assert (Hh := thrust_positive S opening rough).
  assert (Hfriction := inner_friction_is_enough S flag opening thickness rough (shoulder_of_mode L) ltac:(lra)).
  assert (mu_is hs < mu_is h) by (apply mu_is_strictly_decreasing; lra). lra.
Qed.

(** Under a crown that turns the shoulder turns or slides as that of the rotational state asks for less
    friction or for more. *)
Lemma shoulder_of_rotation : (rank m < 2)%nat -> (m = RRR -> mu_ss alpha0 (h_lower delta beta0 eta) <= mu) /\
  (m = SRR -> mu <= mu_ss alpha0 (h_lower delta beta0 eta)).
Proof.
  intros Hr. destruct moved as (h & p & beta & sigma & S & L).
  destruct (thrusts_beside_rotation h p beta sigma S L) as [_ Heq]. specialize (Heq Hr).
  destruct (crown_of_mode Hr L) as (Hb & EC & EL).
  destruct (rotational_state_of_crown S flag opening thickness rough beta Hb EC EL)
    as (alpha1 & Ha1 & R1 & Eh & _ & Eturns & Eslides). assert (Esame : alpha1 = alpha0).
  { destruct R1 as [_ H1], rotation as [_ H0]. apply A_injective; try lra. unfold h_whole in H1, H0. lra. }
  subst alpha1. rewrite <- Heq. split; intros ->.
  - simpl in L. rewrite (Eturns ltac:(tauto)).
    assert (HN := compressed S flag opening thickness rough alpha ltac:(lra)).
    destruct (margins_not_negative S alpha ltac:(lra)) as (_ & _ & _ & HO). rewrite shoulder_friction_from_statics.
    apply steepness_at_most; [easy|]. unfold outward_gap in HO. lra.
  - simpl in L. tauto.
Qed.

Theorem mode_under_a_crown : (rank m < 2)%nat -> (mu_ss alpha0 (h_lower delta beta0 eta) < mu -> m = RRR) /\
  (mu < mu_ss alpha0 (h_lower delta beta0 eta) -> m = SRR).
Proof.
  intros Hr. destruct (shoulder_of_rotation Hr) as [H1 H2]. destruct m; simpl in Hr; try lia;
    [specialize (H1 eq_refl); split; [easy | lra] | specialize (H2 eq_refl); split; [lra | easy]].
Qed.

End Rotation.

(** Where an inner joint slides: the haunch [betaT] by (5) for [hs], or the crown, and the room at the
    shoulder that just slides. *)
Theorem mode_where_an_inner_joint_slides (hs alphaP betaT : R) : 0 < hs < 1 -> mu = mu_is hs -> (2 <= rank m)%nat ->
  0 < alphaP < PI -> outward_gap alphaP mu hs = 0 -> 0 <= betaT < PI ->
  (0 < betaT -> intrados eta * (hs - 1 - betaT * cot betaT) + fac delta eta = 0) ->
  (betaT = 0 -> 0 <= intrados eta * (hs - 2) + fac delta eta) ->
  (alphaP <= betaT \/ 0 < shoulder_room delta alphaP betaT eta hs -> m = SS) /\
  (betaT < alphaP -> shoulder_room delta alphaP betaT eta hs < 0 ->
     (betaT = 0 -> m = RS) /\ (0 < betaT < beta_s hs -> m = RSR) /\ (beta_s hs < betaT -> m = RRS)).
Proof.
  intros Hs Emu Hr HaP EOP HbT Htouch Hcrown. assert (HPI := PI_RGT_0).
  destruct moved as (h & p & beta & sigma & S & L). destruct (slip_of_mode Hr L) as [Hsigma EI].
  destruct (slides_at_steepest_joint S flag opening thickness rough sigma Hsigma EI
              (shoulder_of_mode L)) as (H1 & Esigma & _ & Eh). assert (Hh := thrust_positive S opening rough).
  assert (E : h = hs) by (apply mu_is_injective; lra). subst h. assert (Hgaps := margins_not_negative S).
  assert (HL := haunch_not_negative S). destruct (Hgaps alpha ltac:(lra)) as (HU & _ & _ & HO).
  assert (Hwithin := one_shoulder_just_slides alpha alphaP mu hs opening HaP rough Hh HO EOP).
  destruct (le_lt_dec 5 (rank m)) as [R5 | R5].
  - (* pure sliding *)
    destruct m; simpl in R5; try lia. simpl in L. assert (Esame : alphaP = alpha).
    { apply Rle_antisym; [|easy]. apply (one_shoulder_just_slides alphaP alpha mu hs); easy || lra || tauto. }
    split; [easy|]. intros Hin Hneg. rewrite Esame in Hneg, Hin. rewrite (shoulder_room_of_state _ _ _ _ _ p) in Hneg.
    assert (A := HL betaT ltac:(lra)). lra.
  - destruct (haunch_of_mode Hr R5 L) as (Hb & EL & EU).
    (* its haunch is betaT *)
    assert (Hfac := centroids_positive delta eta ltac:(lra)). assert (Hsame : beta = betaT).
    { destruct (Req_dec beta 0) as [Z | Z].
      - rewrite Z in EL |- *. assert (K0 := haunch_at_crown delta alpha eta hs p opening thickness HL EL).
        destruct (Req_dec betaT 0) as [Z' | Z']; [easy | exfalso].
        assert (Hcot := times_cotangent_below_one betaT ltac:(lra)).
        assert (0 <= intrados eta * (1 - betaT * cot betaT)) by positive. nra.
      - assert (T := haunch_of_wide_arch delta alpha eta hs p beta opening thickness HL EL ltac:(lra)).
        destruct (Req_dec eta 2) as [E2 | E2]; [unfold intrados in T; rewrite E2 in T, Hfac; lra|].
        assert (Hin : 0 < intrados eta) by (unfold intrados; lra). destruct (Req_dec betaT 0) as [Z' | Z'].
        + assert (Hcot := times_cotangent_below_one beta ltac:(lra)). nra.
        + apply times_cotangent_injective; try lra. apply (Rmult_eq_reg_l (intrados eta)); lra. }
    subst beta. split.
    + (* with room at the shoulder that just slides there is room at each within *)
      intros [Hbeyond | Hpos]; exfalso; [lra|].
      assert (Hzero : shoulder_room delta alpha betaT eta hs = 0)
        by (rewrite (shoulder_room_of_state _ _ _ _ _ p); lra).
      destruct (Req_dec alpha alphaP) as [Esame | Hne]; [rewrite Esame in Hzero; lra|].
      assert (0 < shoulder_room delta alpha betaT eta hs); [|lra]. apply (room_within delta alpha alphaP); try lra.
      rewrite (shoulder_room_of_state _ _ _ _ _ p), EL. destruct (Hgaps 0 ltac:(lra)) as (A & _). lra.
    + destruct m; simpl in Hr, R5; try lia; simpl in L; repeat split; intros; easy || lra.
Qed.

End Point.

(** ** Between two points *)

(** Pure sliding goes on with less friction: along it the shoulder gains room with each haunch up to a right angle. *)
Definition sliding_gains_room (delta : R) : Prop :=
  forall alpha eta mu arch eta' mu' m,
    0 < alpha < PI -> 0 < arch < PI -> 0 < eta <= eta' -> eta' <= 2 -> 0 < mu' < mu ->
    (2 <= rank m)%nat -> (rank m < 5)%nat ->
    mode_moves delta alpha eta mu SS -> mode_moves delta arch eta' mu' m ->
  forall h alpha' h' beta, 0 < h < 1 -> 0 < h' < 1 -> mu = mu_is h -> outward_gap alpha mu h = 0 -> mu' = mu_is h' ->
    0 < alpha' < PI -> outward_gap alpha' mu' h' = 0 -> 0 <= beta < PI / 2 ->
    shoulder_room delta alpha beta eta h < shoulder_room delta alpha' beta eta h'.

(** An inner joint slides at a thrust of at most 1/2 where the shoulder turns. *)
Definition slides_at_small_thrust (delta : R) : Prop :=
  forall alpha eta mu h p beta sigma m,
    0 < alpha < PI -> 0 < eta <= 2 -> 0 < mu -> admissible_state delta alpha eta mu h p ->
    (2 <= rank m)%nat -> (rank m < 5)%nat -> has_limits delta alpha eta mu h p beta sigma m -> h <= 1 / 2.

Lemma sliding_goes_on (delta alpha1 eta1 mu1 alpha2 eta2 mu2 : R) (m : mode) : 0 <= delta <= 1 ->
  sliding_gains_room delta -> 0 < alpha1 < PI -> 0 < alpha2 < PI -> 0 < eta1 <= eta2 -> eta2 <= 2 -> 0 < mu2 ->
  mu2 < mu1 -> (2 <= rank m)%nat -> (rank m < 5)%nat -> mode_moves delta alpha1 eta1 mu1 SS ->
  ~ mode_moves delta alpha2 eta2 mu2 m.
Proof.
  intros Hd Hgain Ha1 Ha2 He He2 Hmu2 Hmu R2 R5 M1 M2. assert (HPI := PI2_3_2).
  assert (Hgain' := Hgain alpha1 eta1 mu1 alpha2 eta2 mu2 m Ha1 Ha2 He He2 (conj Hmu2 Hmu) R2 R5 M1 M2).
  destruct M1 as (h1 & p1 & b1 & s1 & S1 & L1). destruct M2 as (h2 & p2 & b2 & s2 & S2 & L2). simpl in L1.
  destruct L1 as (Hs1 & EI1 & EO1).
  destruct (sliding_is_pure S1 Hd Ha1 ltac:(lra) ltac:(lra) s1 ltac:(lra) EI1 EO1) as (H1 & _ & M1 & _).
  destruct (slip_of_mode R2 L2) as [Hs2 EI2]. destruct (haunch_of_mode R2 R5 L2) as (Hb2 & EL2 & EU2).
  destruct (slides_at_steepest_joint S2 Hd Ha2 ltac:(lra) Hmu2 s2 Hs2 EI2 (or_introl EU2)) as (H2 & _ & _ & M2).
  assert (Hh1 := thrust_positive S1 Ha1 ltac:(lra)). assert (Hh2 := thrust_positive S2 Ha2 Hmu2).
  assert (Hless : h1 < h2).
  { destruct (Rtotal_order h1 h2) as [H | [H | H]]; [easy | rewrite H in M1; lra |].
    apply mu_is_strictly_decreasing in H; lra. }
  destruct (margins_not_negative S2 alpha2 ltac:(lra)) as (_ & _ & _ & HO2).
  destruct (shoulder_that_just_slides alpha2 mu2 h2 Ha2 Hmu2 Hh2 HO2) as (alphaP & HaP & EOP).
  (* the half-angle that just slides is narrower with less friction *)
  assert (Hnarrow : alphaP < alpha1).
  { apply Rnot_le_lt. intros Hwide. assert (Hgap : 0 <= outward_gap alpha1 mu2 h2).
    { destruct (Req_dec alpha1 alphaP) as [E | E]; [rewrite E; lra|].
      apply Rlt_le, (no_outward_limit_within alpha1 alphaP); lra. }
    assert (HN1 := compressed S1 Hd Ha1 ltac:(lra) ltac:(lra) alpha1 ltac:(lra)).
    destruct (slip_rows_are_scaled alpha1 mu1 h1 h2 HN1) as [_ Hrow]. specialize (Hrow EO1).
    assert (Hneg : outward_gap alpha1 mu1 h2 < 0).
    { apply Rnot_le_lt. intros H. assert (0 <= normal_force alpha1 h1 * outward_gap alpha1 mu1 h2) by positive.
      assert (0 < alpha1 * (h2 - h1)) by positive. lra. }
    (* with the larger thrust, too, it is compressed *)
    assert (HNpos : 0 <= normal_force alpha1 h2).
    { apply Rnot_lt_le. intros HNneg. assert (HS : 0 < sin alpha1) by positive. assert (Hcos : cos alpha1 < 0).
      { apply Rnot_le_lt. intros H. assert (0 <= h2 * cos alpha1) by positive.
        assert (0 < alpha1 * sin alpha1) by positive. unfold normal_force in HNneg. lra. }
      assert (0 < h2 * sin alpha1) by positive. assert (0 < mu2 * - normal_force alpha1 h2) by positive.
      assert (0 < alpha1 * - cos alpha1) by positive. unfold outward_gap, shear_force in Hgap. lra. }
    assert (0 <= (mu1 - mu2) * normal_force alpha1 h2) by positive. unfold outward_gap in *. lra. }
  assert (HL2 := haunch_not_negative S2). assert (Hright : b2 < PI / 2).
  { destruct (Req_dec b2 0) as [E | E]; [lra|].
    assert (Htouch := haunch_of_wide_arch delta alpha2 eta2 h2 p2 b2 Ha2 ltac:(lra) HL2 EL2 ltac:(lra)).
    assert (Hfac := centroids_positive delta eta2 ltac:(lra)). apply Rnot_le_lt. intros H.
    assert (HS : 0 < sin b2) by positive. assert (Hcos : cos b2 <= 0) by (apply cos_le_0; lra).
    assert (Hcot : b2 * cot b2 <= 0).
    { unfold cot. replace (b2 * (cos b2 / sin b2)) with (- (b2 * - cos b2 / sin b2)) by (field; lra).
      assert (0 <= b2 * - cos b2 / sin b2) by positive. lra. }
    unfold intrados in Htouch. assert (0 <= (1 - eta2 / 2) * - (b2 * cot b2)) by positive.
    assert (0 <= (1 - eta2 / 2) * h2) by positive. lra. }
  assert (Hroom := Hgain' h1 alphaP h2 b2 ltac:(lra) ltac:(lra) M1 EO1 M2 ltac:(lra) EOP ltac:(lra)).
  destruct (margins_not_negative S1 alpha1 ltac:(lra)) as (U1 & _).
  destruct (margins_not_negative S1 b2 ltac:(lra)) as (_ & L1 & _).
  destruct (margins_not_negative S1 0 ltac:(lra)) as (C1 & _).
  rewrite (shoulder_room_of_state _ alpha1 _ _ _ p1) in Hroom.
  (* at the crown the larger thrust gives room as well *)
  assert (Hcrown : 0 <= shoulder_room delta 0 b2 eta1 h2).
  { assert (Hsum : 0 <= shoulder_room delta 0 b2 eta1 h1) by (rewrite (shoulder_room_of_state _ _ _ _ _ p1); lra).
    assert (0 < (h2 - h1) * (extrados eta1 - intrados eta1 * cos b2)).
    { apply Rmult_lt_0_compat; [lra|]. unfold extrados, intrados. destruct (COS_bound b2).
      assert (-1 < cos b2) by (rewrite <- cos_PI; apply cos_decreasing_1; lra). nra. }
    unfold shoulder_room, shoulder_gap, haunch_gap, normal_force in *. rewrite cos_0, sin_0 in *. lra. }
  assert (Hshoulder : 0 < shoulder_room delta alpha2 b2 eta1 h2).
  { destruct (Req_dec alpha2 alphaP) as [E | E]; [rewrite E; lra|]. apply (room_within delta alpha2 alphaP); lra. }
  (* and more thickness no less *)
  assert (Hzero : shoulder_room delta alpha2 b2 eta2 h2 = 0) by (rewrite (shoulder_room_of_state _ _ _ _ _ p2); lra).
  assert (HNb := compressed S2 Hd Ha2 ltac:(lra) Hmu2 b2 ltac:(lra)).
  assert (Hcos : cos alpha2 <= cos b2) by (apply Rlt_le, cos_decreasing_1; lra).
  assert (Hgrows : (2 + eta1) * shoulder_room delta alpha2 b2 eta2 h2
    = (2 + eta2) * shoulder_room delta alpha2 b2 eta1 h2 + (eta2 - eta1) *
    (2 * normal_force b2 h2 + (cos b2 - cos alpha2) * (1 - delta / 12 * (2 * eta1 + 2 * eta2 + eta1 * eta2)))).
  { unfold shoulder_room, shoulder_gap, haunch_gap, extrados, intrados, fac. field. }
  assert (Hless12 : delta / 12 * (2 * eta1 + 2 * eta2 + eta1 * eta2) <= 1).
  { assert (2 * eta1 + 2 * eta2 + eta1 * eta2 <= 12) by nra.
    assert (delta * (2 * eta1 + 2 * eta2 + eta1 * eta2) <= 1 * 12) by (apply Rmult_le_compat; nra). lra. }
  assert (0 <= (cos b2 - cos alpha2) * (1 - delta / 12 * (2 * eta1 + 2 * eta2 + eta1 * eta2))) by positive.
  assert (0 <= (eta2 - eta1) * (2 * normal_force b2 h2 + (cos b2 - cos alpha2) *
    (1 - delta / 12 * (2 * eta1 + 2 * eta2 + eta1 * eta2)))) by positive.
  assert (0 < (2 + eta2) * shoulder_room delta alpha2 b2 eta1 h2) by positive. rewrite Hzero, Rmult_0_r in Hgrows.
  lra.
Qed.

(** From more friction and less thickness to less and more the modes come in one order, *)
Theorem modes_in_order (delta alpha1 eta1 mu1 alpha2 eta2 mu2 : R) (m1 m2 : mode) : 0 <= delta <= 1 ->
  friction_grows delta -> slides_at_small_thrust delta -> sliding_gains_room delta -> 0 < alpha1 < PI ->
  0 < alpha2 < PI -> 0 < eta1 <= eta2 -> eta2 <= 2 -> 0 < mu2 <= mu1 -> eta1 < eta2 \/ mu2 < mu1 ->
  mode_moves delta alpha1 eta1 mu1 m1 -> mode_moves delta alpha2 eta2 mu2 m2 -> (rank m1 <= rank m2)%nat.
Proof.
  intros Hd Hgrows Hsmall Hgain Ha1 Ha2 He He2 Hmu Hstrict M1 M2. destruct (Req_dec mu1 mu2) as [Emu | Emu].
  { rewrite Emu in M1. apply (modes_of_a_column delta mu2 alpha1 eta1 alpha2 eta2); easy || lra. }
  destruct (le_lt_dec 2 (rank m2)) as [R2 | R2].
  - destruct (le_lt_dec 5 (rank m2)) as [R5 | R5]; [destruct m1, m2; simpl in *; lia|].
    destruct (le_lt_dec 2 (rank m1)) as [R1 | R1]; [|lia]. destruct (le_lt_dec 5 (rank m1)) as [R1' | R1'].
    + exfalso. destruct m1; simpl in R1'; try lia.
      now apply (sliding_goes_on delta alpha1 eta1 mu1 alpha2 eta2 mu2 m2 Hd Hgain Ha1 Ha2 He He2 (proj1 Hmu)
                   ltac:(lra) R2 R5 M1).
    + destruct M1 as (h1 & p1 & b1 & s1 & S1 & L1). destruct M2 as (h2 & p2 & b2 & s2 & S2 & L2).
      assert (Hhalf := Hsmall alpha2 eta2 mu2 h2 p2 b2 s2 m2 Ha2 ltac:(lra) ltac:(lra) S2 R2 R5 L2).
      destruct (slip_of_mode R1 L1) as [Hs1 EI1]. destruct (slip_of_mode R2 L2) as [Hs2 EI2].
      destruct (haunch_of_mode R1 R1' L1) as (Hb1 & EL1 & EU1).
      destruct (haunch_of_mode R2 R5 L2) as (Hb2 & EL2 & EU2).
      destruct (haunch_falls S1 S2 Hd Ha1 ltac:(lra) ltac:(lra) Ha2 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) s1 b1 s2 b2 Hs1 EI1 (or_introl EU1)
                  Hs2 EI2 (or_introl EU2) Hb1 EL1 Hb2 EL2) as (Hfall & Hfalls & Hslip). apply Nat.nlt_ge.
      intros Hless. destruct m1, m2; simpl in R1, R1', R2, R5, Hless; try lia; simpl in L1, L2; lra.
  - destruct (le_lt_dec 2 (rank m1)) as [R1 | R1].
    + destruct M1 as (h1 & p1 & b1 & s1 & S1 & L1). destruct M2 as (h2 & p2 & b2 & s2 & S2 & L2).
      destruct (slip_of_mode R1 L1) as [Hs1 EI1]. destruct (crown_of_mode R2 L2) as (Hb2 & EC2 & EL2).
      destruct (crown_turns_first S1 S2 Hd Ha1 ltac:(lra) ltac:(lra) Ha2 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)
        s1 b2 Hs1 EI1 (shoulder_of_mode L1) Hb2 EC2 EL2 (shoulder_of_mode L2)) as (_ & E & _). lra.
    + destruct m1; simpl in R1; try lia; [simpl; lia|]. destruct m2; simpl in R2; try lia. exfalso.
      (* a shoulder that slides, and one that turns with less friction *)
      destruct M1 as (h1 & p1 & b1 & s1 & S1 & L1). destruct (M2) as (h2 & p2 & b2 & s2 & S2 & L2). simpl in L1, L2.
      destruct L1 as (Hb1 & EC1 & EL1 & EO1).
      destruct (rotational_state_of_crown S1 Hd Ha1 ltac:(lra) ltac:(lra) b1 Hb1 EC1 EL1)
        as (a1 & Ha1' & T1 & E1 & _ & _ & F1). destruct (Req_dec eta1 eta2) as [Eeta | Eeta].
      * rewrite <- Eeta in *. assert (Hthin := crown_is_thin S1 Hd Ha1 ltac:(lra) ltac:(lra) b1 Hb1 EC1 EL1).
        destruct (shoulder_of_rotation delta alpha2 eta1 mu2 RRR Hd Ha2 ltac:(lra) ltac:(lra) M2 a1 b1
                    ltac:(lra) ltac:(lra) Hthin T1 ltac:(simpl; lia)) as [G2 _]. specialize (G2 eq_refl).
        rewrite <- E1 in G2. lra.
      * apply (shoulder_turns_first delta alpha1 eta1 mu1 h1 p1 alpha2 eta2 mu2 h2 p2 b1 b2); easy || lra.
Qed.

(** so that between two points of one mode there is no other. *)
Theorem cell_of_one_mode (delta alpha1 eta1 mu1 alpha eta mu alpha2 eta2 mu2 : R) (m m' : mode) : 0 <= delta <= 1 ->
  friction_grows delta -> slides_at_small_thrust delta -> sliding_gains_room delta -> 0 < alpha1 < PI ->
  0 < alpha < PI -> 0 < alpha2 < PI -> 0 < eta1 <= eta -> eta <= eta2 <= 2 -> 0 < mu2 <= mu -> mu <= mu1 ->
  eta1 < eta \/ mu < mu1 -> eta < eta2 \/ mu2 < mu -> mode_moves delta alpha1 eta1 mu1 m ->
  mode_moves delta alpha2 eta2 mu2 m -> mode_moves delta alpha eta mu m' -> m' = m.
Proof.
  intros Hd Hgrows Hsmall Hgain Ha1 Ha Ha2 He He2 Hmu Hmu1 N1 N2 M1 M2 M.
  assert (H1 := modes_in_order delta alpha1 eta1 mu1 alpha eta mu m m' Hd Hgrows Hsmall Hgain Ha1 Ha
                  ltac:(lra) ltac:(lra) ltac:(lra) N1 M1 M).
  assert (H2 := modes_in_order delta alpha eta mu alpha2 eta2 mu2 m' m Hd Hgrows Hsmall Hgain Ha Ha2
                  ltac:(lra) ltac:(lra) ltac:(lra) N2 M M2). destruct m, m'; simpl in H1, H2; try lia; easy.
Qed.
