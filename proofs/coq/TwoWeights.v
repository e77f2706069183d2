(** * Two weights at one half-angle and one friction

    With a larger flag [delta'] the centroids are farther out.  Where an arch is at its least thickness and its shoulder
    turns, the arch with [delta'] is thicker; where both shoulders slide under a crown that turns it is thinner. *)

From Coq Require Import Lia Compare_dec Classical.
From Couplet Require Import Overturning Surveys Room Modes Attained Order Map.

Section Weights.

Variables (delta delta' alpha eta : R).
Hypotheses (flags : 0 <= delta < delta') (flag' : delta' <= 1) (opening : 0 < alpha < PI) (thickness : 0 < eta <= 2).

Lemma centroid_factor_grows : fac delta eta < fac delta' eta.
Proof. unfold fac. assert (0 < (delta' - delta) * eta ^ 2) by positive. lra. Qed.

(** With no less thrust than that of a hinge at the haunch and one at the shoulder the other weight has
    no room between the two. *)
Lemma no_room_with_more_thrust (beta h0 p0 h p : R) : 0 <= beta < alpha -> 0 <= h0 <= h ->
  haunch_gap delta beta eta h0 p0 = 0 -> shoulder_gap delta alpha eta h0 p0 = 0 ->
  0 <= haunch_gap delta' beta eta h p -> shoulder_gap delta' alpha eta h p < 0.
Proof.
  intros Hb Hh EL EU HL. assert (Hfac := centroid_factor_grows).
  assert (Harm := lever_positive_in_any_state delta alpha beta eta h0 p0 ltac:(lra) ltac:(lra) opening
                    thickness ltac:(lra) EL EU). assert (cos alpha < cos beta) by (apply cos_decreasing_1; lra).
  unfold haunch_gap, shoulder_gap, normal_force in *. nra.
Qed.

(** With a hinge at the crown too it has none with any thrust. *)
Lemma no_room_under_rotation (beta h0 p0 h p : R) : 0 < beta < alpha -> 0 < cos beta -> 0 <= h0 ->
  crown_gap eta h0 p0 = 0 -> haunch_gap delta beta eta h0 p0 = 0 -> shoulder_gap delta alpha eta h0 p0 = 0 ->
  0 <= crown_gap eta h p -> 0 <= haunch_gap delta' beta eta h p -> shoulder_gap delta' alpha eta h p < 0.
Proof.
  intros Hb Hcos Hh EC EL EU HC HL. assert (Hfac := centroid_factor_grows).
  assert (Harm := lever_positive_in_any_state delta alpha beta eta h0 p0 ltac:(lra) ltac:(lra) opening
                    thickness Hh EL EU). set (a := extrados eta - intrados eta * cos beta).
  set (b := intrados eta * cos beta - extrados eta * cos alpha) in *. assert (0 < a).
  { unfold a, extrados, intrados. destruct (COS_bound beta). nra. }
  (* the work of the mechanism of rotation is that of the heavier weight alone *)
  assert (Hwork : b * crown_gap eta h p + (a + b) * haunch_gap delta' beta eta h p + a * shoulder_gap delta' alpha eta
    h p = b * crown_gap eta h0 p0 + (a + b) * haunch_gap delta beta eta h0 p0 + a * shoulder_gap delta alpha eta h0 p0
    - (fac delta' eta - fac delta eta) * (1 - cos alpha) * (eta * cos beta)).
  { unfold a, b, crown_gap, haunch_gap, shoulder_gap, normal_force, extrados, intrados. field. }
  assert (0 < 1 - cos alpha) by positive.
  assert (0 < (fac delta' eta - fac delta eta) * (1 - cos alpha) * (eta * cos beta)) by positive. nra.
Qed.

(** A haunch that the line of thrust touches is below a right angle. *)
Lemma haunch_below_right_angle (beta h p : R) : 0 < beta < alpha -> 0 < h ->
  (forall x, 0 <= x <= alpha -> 0 <= haunch_gap delta x eta h p) -> haunch_gap delta beta eta h p = 0 -> 0 < cos beta.
Proof.
  intros Hb Hh Hall EL. assert (HS : 0 < sin beta) by positive.
  assert (Htouch := haunch_of_wide_arch delta alpha eta h p beta opening thickness Hall EL Hb).
  assert (Hfac := centroids_positive delta eta ltac:(lra)). assert (Hcot : 0 < beta * cot beta).
  { unfold intrados in Htouch. nra. }
  unfold cot in Hcot. apply Rnot_le_lt. intros H. assert (0 <= beta * - (cos beta / sin beta)).
  { apply Rmult_le_pos; [lra|]. replace (- (cos beta / sin beta)) with (- cos beta / sin beta) by (field; lra).
    positive. }
  lra.
Qed.

(** Where the shoulder turns the other weight does not stand with as little. *)
Theorem heavier_is_thicker (mu : R) (m : mode) : 0 < mu ->
  m <> SRR -> m <> SS -> mode_moves delta alpha eta mu m -> ~ arch_stands delta' alpha eta mu.
Proof.
  intros Hmu N1 N2 (h0 & p0 & beta & sigma & Hstate & Hlimits) (h & p & Hall). assert (flag : 0 <= delta <= 1) by lra.
  assert (Hh0 := thrust_positive Hstate opening Hmu). assert (Hh := thrust_positive Hall opening Hmu).
  assert (Hgaps : forall x, 0 <= x <= alpha ->
            0 <= shoulder_gap delta' x eta h p /\ 0 <= haunch_gap delta' x eta h p).
  { intros x Hx. destruct (margins_not_negative Hall x Hx) as (A & B & _). lra. }
  assert (HL0 := haunch_not_negative Hstate). destruct (Hgaps alpha ltac:(lra)) as [HU _].
  destruct (le_lt_dec 2 (rank m)) as [R2 | R2].
  - destruct (le_lt_dec 5 (rank m)) as [R5 | R5]; [now destruct m; simpl in R5; try lia|].
    destruct (slip_of_mode R2 Hlimits) as [Hs EI]. destruct (haunch_of_mode R2 R5 Hlimits) as (Hb & EL & EU).
    destruct (slides_at_steepest_joint Hstate flag opening thickness Hmu sigma Hs EI
                (or_introl EU)) as (H1 & _ & Habove & Emu).
    assert (Hb0 := beta_s_positive h0 ltac:(lra)). assert (Hmore : h0 <= h).
    { destruct (Hall (beta_s h0) ltac:(lra)) as [[HN _] Hf]. apply (thrust_at_least_h_is mu h0 h); easy || lra. }
    destruct (Hgaps beta ltac:(lra)) as [_ HL].
    assert (H := no_room_with_more_thrust beta h0 p0 h p Hb ltac:(lra) EL EU HL). lra.
  - destruct m; simpl in R2; try lia; [|easy]. destruct Hlimits as (Hb & EC & EL & EU).
    assert (Hcos := haunch_below_right_angle beta h0 p0 Hb Hh0 HL0 EL). destruct (Hgaps 0 ltac:(lra)) as [HC _].
    destruct (Hgaps beta ltac:(lra)) as [_ HL]. rewrite gap_at_crown in HC.
    assert (H := no_room_under_rotation beta h0 p0 h p Hb Hcos ltac:(lra) EC EL EU HC HL). lra.
Qed.

(** So one that stands is thicker, unless the shoulder slides under a crown that turns. *)
Theorem heavier_is_thicker_unless_the_shoulder_slides (mu : R) : 0 < mu -> arch_stands delta alpha eta mu ->
  (forall eta', 0 < eta' < eta -> ~ arch_stands delta alpha eta' mu) -> mode_moves delta alpha eta mu SRR \/
  (forall eta', 0 < eta' <= eta -> ~ arch_stands delta' alpha eta' mu).
Proof.
  intros Hmu (h & p & Hstate) Hnone.
  destruct (a_hinge_at_the_least_thickness delta alpha eta mu h p ltac:(lra) opening thickness Hmu Hnone Hstate)
    as (m & N & Hm). destruct (classic (m = SRR)) as [-> | N']; [now left | right]. intros eta' He' H.
  apply (heavier_is_thicker mu m Hmu N' N Hm).
  apply (narrower_rougher_thicker_stands delta' alpha alpha eta' eta mu mu); easy || lra.
Qed.

(** The same without a limit of friction, [[r,r,r]] and, with no thrust and the haunch at the crown, [[r]]. *)
Theorem heavier_is_thicker_without_limit (beta h0 p0 : R) :
  (forall x, 0 <= x <= alpha -> joint_stands delta x eta h0 p0) -> crown_gap eta h0 p0 = 0 ->
  haunch_gap delta beta eta h0 p0 = 0 -> shoulder_gap delta alpha eta h0 p0 = 0 -> (0 < h0 /\ 0 < beta < alpha) \/
  (h0 = 0 /\ beta = 0) -> ~ (exists h p, forall x, 0 <= x <= alpha -> joint_stands delta' x eta h p).
Proof.
  intros Hstate EC EL EU Hcase (h & p & Hall).
  assert (Hgaps : forall x, 0 <= x <= alpha ->
            0 <= shoulder_gap delta' x eta h p /\ 0 <= haunch_gap delta' x eta h p).
  { intros x Hx. destruct (Hall x Hx) as (_ & Hin & Hout). unfold shoulder_gap, haunch_gap. lra. }
  assert (HL0 : forall x, 0 <= x <= alpha -> 0 <= haunch_gap delta x eta h0 p0).
  { intros x Hx. destruct (Hstate x Hx) as (_ & Hin & _). unfold haunch_gap. lra. }
  destruct (Hgaps alpha ltac:(lra)) as [HU _]. destruct Hcase as [[Hh0 Hb] | [Eh Eb]].
  - assert (Hcos := haunch_below_right_angle beta h0 p0 Hb Hh0 HL0 EL). destruct (Hgaps 0 ltac:(lra)) as [HC _].
    destruct (Hgaps beta ltac:(lra)) as [_ HL]. rewrite gap_at_crown in HC.
    assert (H := no_room_under_rotation beta h0 p0 h p Hb Hcos ltac:(lra) EC EL EU HC HL). lra.
  - assert (Hh : 0 <= h) by (destruct (Hall 0 ltac:(lra)) as (HN & _); rewrite normal_force_at_crown in HN; lra).
    destruct (Hgaps 0 ltac:(lra)) as [_ HL]. subst h0 beta.
    assert (H := no_room_with_more_thrust 0 0 p0 h p ltac:(lra) ltac:(lra) EL EU HL). lra.
Qed.

End Weights.

(** Where the shoulders slide under crowns that turn the other weight is the thinner one. *)
Theorem heavier_is_thinner_where_shoulders_slide (delta delta' alpha eta eta' mu : R) :
  0 <= delta < delta' -> delta' <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 -> 0 < eta' <= 2 -> 0 < mu ->
  mode_moves delta alpha eta mu SRR -> mode_moves delta' alpha eta' mu SRR -> eta' < eta.
Proof.
  intros Hd Hd' Ha He He' Hmu (h & p & beta & sigma & S & Hb & EC & EL & EO)
    (h' & p' & beta' & sigma' & S' & Hb' & EC' & EL' & EO'). assert (Hh := thrust_positive S Ha Hmu).
  assert (HN := compressed S ltac:(lra) Ha He Hmu). assert (HN' := compressed S' ltac:(lra) Ha He' Hmu).
  (* friction gives one thrust *)
  assert (E : h' = h).
  { destruct (slip_rows_are_scaled alpha mu h h' (HN alpha ltac:(lra))) as [_ Hout].
    apply (Rmult_eq_reg_l alpha); nra. }
  subst h'. apply Rnot_le_lt. intros Hthick. assert (HU := margins_not_negative S).
  destruct (HU beta' ltac:(lra)) as (_ & L & _). assert (fac delta eta < fac delta' eta').
  { unfold fac. assert (0 < (delta' - delta) * eta' ^ 2) by positive.
    assert (delta * eta ^ 2 <= delta * eta' ^ 2) by (apply Rmult_le_compat_l; nra). lra. }
  assert (0 < 1 - cos beta') by positive. assert (HNb := HN' beta' ltac:(lra)).
  unfold shoulder_gap, haunch_gap, crown_gap, extrados, intrados in *. nra.
Qed.
