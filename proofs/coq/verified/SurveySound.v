(** * What is checked of a survey is true *)

From Coq Require Import Reals Lra Bool.
From Coq Require Export QArith Qreals.
From Interval Require Import Interval.Interval.
From Couplet Require Import Arch States Surveys Root Check SurveyCheck.
From Couplet Require Export Sound SurveyClaim.

(** ** Numbers *)

Lemma same_number_sound a b : is_same_number a b = true -> real a = real b.
Proof.
  assert (one : forall n, real (one_form n) = real n).
  { intros [p q | p q | p q]; try easy. cbn [one_form]. destruct (Z.eqb_spec p (Zpos q)) as [-> | _]; [| easy].
    cbn [real]. unfold fraction. replace (IZR (Zpos q) / IZR (Zpos q)) with 1 by (field; now apply not_0_IZR).
    rewrite atan_1. field. }
  unfold is_same_number. intros H. rewrite <- (one a), <- (one b). conditions.
  match goal with H : Qeq_bool _ _ = true |- _ => apply Qeq_bool_eq, Qeq_eqR in H; rename H into E end.
  destruct (one_form a) as [p q | p q | p q], (one_form b) as [p' q' | p' q' | p' q']; try easy; cbn [real factor] in *;
    change (fraction p q = fraction p' q') in E; now rewrite E.
Qed.

Lemma in_order_sound prec a b : are_in_order prec (a, b) = true -> real a <= real b.
Proof.
  cbn [are_in_order]. destruct (is_same_form a b) eqn:Hform; intros H.
  - apply Qle_bool_iff, Qle_Rle in H. assert (P := PI_RGT_0).
    destruct a as [p q | p q | p q], b as [p' q' | p' q' | p' q']; try discriminate; cbn [real factor] in *;
      change (fraction p q <= fraction p' q') in H; [exact H | apply Rmult_le_compat_r; lra |].
      destruct H as [H | ->]; [apply atan_increasing in H |]; lra.
  - assert (real a < real b); [| lra].
    now apply (difference_sound prec (enclosed_number prec b) (enclosed_number prec a)); try apply has_number.
Qed.

Lemma same_friction_sound f g : is_same_friction f g = true -> coefficient f = coefficient g.
Proof.
  destruct f, g; try easy; cbn [is_same_friction coefficient]; intros H; now rewrite (same_number_sound _ _ H).
Qed.

Lemma frictions_in_order_sound prec f g w alpha beta : are_frictions_in_order prec (f, g) = true ->
  is_arch (Arch w alpha f) -> is_arch (Arch w beta g) -> no_more (coefficient f) (coefficient g).
Proof.
  intros H [_ Hf] [_ Hg]. cbn [its_friction] in *.
  assert (mixed : is_positive (I.sub prec (enclosed_friction prec g) (enclosed_friction prec f)) = true ->
            coefficient_or_zero f < coefficient_or_zero g)
    by (intros Ht; now apply (difference_sound prec _ _ _ _ Ht); apply has_friction).
  destruct f as [a | a |], g as [b | b |]; try easy; cbn [are_frictions_in_order coefficient no_more] in *;
    try (apply Rlt_le; exact (mixed H)); apply in_order_sound in H; [exact H |].
  destruct H as [H | ->]; [| lra]. assert (B := PI_RGT_0). apply Rlt_le, tan_increasing; lra.
Qed.

(** ** Arches *)

Lemma stands_more w alpha alpha' eta eta' mu mu' : stands_with w alpha eta mu -> 0 <= alpha' <= alpha ->
  0 < eta <= eta' -> eta' <= 2 -> no_more mu mu' -> stands_with w alpha' eta' mu'.
Proof.
  intros H Ha He He' Hmu. assert (weight := flag_between w).
  assert (inside : forall h p, thrust_inside (flag w) alpha eta h p -> thrust_inside (flag w) alpha' eta' h p)
    by (intros h p Hall; exact (narrower_thicker_stands _ _ _ _ _ _ _ weight Ha He He' Hall)).
  destruct mu, mu'; try easy; cbn [stands_with no_more] in *.
  - now apply (narrower_rougher_thicker_stands _ alpha alpha' eta eta' r).
  - destruct H as (h & p & Hall). exists h, p. apply inside. intros x Hx. now apply Hall.
  - destruct H as (h & p & Hall). exists h, p. now apply inside.
Qed.

Lemma decided_sound c a t b : is_decided c a t b = true -> is_thickness t = true ->
  if b then stands a (real t) else ~ stands a (real t).
Proof.
  unfold is_decided. intros H Ht. apply andb_true_iff in H as [H Hcheck]. apply sound in Hcheck.
  unfold claim_of in Hcheck. apply is_thickness_sound in Ht.
  destruct (about c) as [| m a' u | a' | a' | a' u h p place | |]; try easy; conditions; destruct b; try easy.
  all: assert (E : forall eta, stands a' eta = stands a eta).
  all: try (intros eta; unfold stands;
    repeat match goal with
      | H : is_same_number (half_opening _) _ = true |- _ => apply same_number_sound in H
      | H : is_same_friction _ _ = true |- _ => apply same_friction_sound in H
      end;
    replace (self_weight a') with (self_weight a) by (destruct (self_weight a), (self_weight a'); easy); congruence).
  all: try match goal with H : is_same_number ?t _ = true |- context [real ?t] => apply same_number_sound in H as -> end.
  all: rewrite <- E; now apply Hcheck.
Qed.

(** ** Circles *)

Lemma Q2R_whole z : Q2R (z # 1) = IZR z.
Proof. unfold Q2R. simpl. field. Qed.

Lemma not_zero (x : Q) : Q2R x <> 0 -> ~ (x == 0)%Q.
Proof. intros H E. apply Qeq_eqR in E. apply H. rewrite E. apply (Q2R_whole 0). Qed.

Ltac in_reals := rewrite ?Q2R_plus, ?Q2R_mult, ?Q2R_whole in *.

(** Positive measures. *)
Definition is_real (p : place) : Prop := 0 < Q2R (fst p) /\ 0 < Q2R (snd p).
Definition radius_at (p : place) : R := Surveys.radius (Q2R (fst p)) (Q2R (snd p)).

Lemma circle_of_is p : is_real p -> Q2R (circle_of p) = radius_at p.
Proof.
  destruct p as [s f]. unfold is_real, radius_at, circle_of, Surveys.radius. cbn [fst snd]. intros [Hs Hf].
  rewrite Q2R_div, Q2R_plus, Q2R_div by (apply not_zero; in_reals; lra). in_reals. field. lra.
Qed.

Lemma opening_of_is p : is_real p -> real (opening_of p) = opening (Q2R (fst p)) (Q2R (snd p)).
Proof.
  destruct p as [s f]. unfold is_real, opening_of. cbn [fst snd real]. intros [Hs Hf].
  change (fraction _ _) with (Q2R (2 * f / s)). rewrite Q2R_div by (apply not_zero; lra). now in_reals.
Qed.

Lemma ratio_of_is c t r : is_thickness (ratio_of c t r) = true -> 0 < Q2R t ->
  real (ratio_of c t r) = ratio (IZR (to_centreline c)) (Q2R t) (Q2R r) /\
  0 < Q2R r + IZR (to_centreline c) * Q2R t / 2.
Proof.
  intros H Ht. apply is_thickness_sound in H. revert H.
  change (real (ratio_of c t r)) with (Q2R (t / outwards c t r)).
  assert (E : Q2R (outwards c t r) = Q2R r + IZR (to_centreline c) * Q2R t / 2).
  { unfold outwards. rewrite Q2R_plus, Q2R_div by easy. unfold inject_Z. now in_reals. }
  destruct (Qeq_dec (outwards c t r) 0) as [Hzero | Hne].
  - assert (Hq : (t / outwards c t r == 0)%Q) by (rewrite Hzero; unfold Qdiv; apply Qmult_0_r). apply Qeq_eqR in Hq.
    rewrite Hq, (Q2R_whole 0). lra.
  - rewrite Q2R_div by exact Hne. rewrite E. intros [H _]. split; [reflexivity |]. apply Rnot_le_lt. intros Hle.
    destruct Hle as [Hle | Hle]; [| rewrite Hle in H; unfold Rdiv in H; rewrite Rinv_0 in H; lra].
    apply Rinv_lt_0_compat in Hle. unfold Rdiv in H. nra.
Qed.

(** Comparisons, in real numbers. *)
Lemma above_sound a b : Qle_bool a b = false -> Q2R b < Q2R a.
Proof. intros H. apply Qlt_Rlt. apply Qnot_le_lt. intros Hle. apply Qle_bool_iff in Hle. congruence. Qed.
Lemma unequal_sound a b : Qeq_bool a b = false -> Q2R a <> Q2R b.
Proof. intros H E. apply eqR_Qeq, Qeq_eq_bool in E. congruence. Qed.
Ltac compared := repeat match goal with
  | H : Qle_bool _ _ = true |- _ => apply Qle_bool_iff, Qle_Rle in H
  | H : Qle_bool _ _ = false |- _ => apply above_sound in H
  | H : Qeq_bool _ _ = true |- _ => apply Qeq_bool_eq, Qeq_eqR in H
  | H : Qeq_bool _ _ = false |- _ => apply unequal_sound in H
  end.

Lemma largest_circle first last : is_real first -> is_real last ->
  Rmax (radius_at first) (radius_at last) = Q2R (its_circle Unsafe (first, last)).
Proof.
  intros H H'. unfold its_circle. rewrite <- circle_of_is, <- (circle_of_is last) by easy.
  destruct (Qle_bool (circle_of first) (circle_of last)) eqn:Hle; compared; [apply Rmax_right | apply Rmax_left]; lra.
Qed.

Lemma least_circle first last : is_real first -> is_real last -> let half := Q2R (fst first) / 2 in
  let least := Q2R (its_circle Safe (first, last)) in Q2R (fst first) = Q2R (fst last) /\
  Q2R (snd first) < half < Q2R (snd last) /\ least = half \/
  (Q2R (fst first) = Q2R (fst last) -> half <= Q2R (snd first) \/ Q2R (snd last) <= half) /\
  least = Rmin (radius_at first) (radius_at last).
Proof.
  intros H H'. cbv zeta. unfold its_circle.
  assert (E : Q2R (fst first / 2) = Q2R (fst first) / 2) by (rewrite Q2R_div by easy; now in_reals).
  assert (F : Q2R (if Qle_bool (circle_of first) (circle_of last) then circle_of first else circle_of last)
    = Rmin (radius_at first) (radius_at last)).
  { rewrite <- circle_of_is, <- (circle_of_is last) by easy.
    destruct (Qle_bool _ _) eqn:Hle; compared; symmetry; [apply Rmin_left | apply Rmin_right]; lra. }
  destruct (Qeq_bool (fst first) (fst last)) eqn:H1, (Qle_bool (fst first / 2) (snd first)) eqn:H2,
    (Qle_bool (snd last) (fst first / 2)) eqn:H3; cbn [andb negb]; compared; rewrite ?E in *;
    first [left; now repeat split | right; split; [intros; tauto | exact F]].
Qed.

Lemma least_circle_positive first last : is_real first -> is_real last -> 0 < Q2R (its_circle Safe (first, last)).
Proof.
  intros [Hs Hf] [Hs' Hf']. destruct (least_circle first last ltac:(easy) ltac:(easy)) as [(_ & _ & ->) | (_ & ->)]; [lra |].
  apply Rmin_glb_lt; now apply radius_positive.
Qed.

(** ** Steps *)

(** On which leg a step is. *)
Definition rises_at (rises : Q * Q) (at_span : Q) (step : place * place) : Prop :=
  let '((s, f), (s', f')) := step in
  Q2R s = Q2R at_span /\ Q2R s' = Q2R at_span /\ Q2R (fst rises) <= Q2R f <= Q2R f' /\ Q2R f' <= Q2R (snd rises).
Definition narrows_at (spans : Q * Q) (at_rise : Q) (step : place * place) : Prop :=
  let '((s, f), (s', f')) := step in
  Q2R f = Q2R at_rise /\ Q2R f' = Q2R at_rise /\ Q2R (fst spans) <= Q2R s' <= Q2R s /\ Q2R s <= Q2R (snd spans).

Lemma step_sound d spans rises step : is_step d spans rises step = true ->
  match d with
  | Unsafe => rises_at rises (snd spans) step \/ narrows_at spans (snd rises) step
  | Safe => narrows_at spans (fst rises) step \/ rises_at rises (fst spans) step
  end.
Proof.
  destruct step as [[s f] [s' f']]. unfold is_step.
  destruct d; intros H; apply orb_true_iff in H as [H | H]; conditions; compared; [left | right | left | right];
    cbn [rises_at narrows_at]; lra.
Qed.

(** An arch between the slopes of the ends. *)
Definition slopes_between (span rise : R) (first last : place) : Prop :=
  Q2R (snd first) * span <= rise * Q2R (fst first) /\ rise * Q2R (fst last) <= Q2R (snd last) * span.

(** Some step is as steep. *)
Lemma reaches_sound span rise l : forall from until, reaches from until l = true -> slopes_between span rise from until ->
  exists p first last, In p l /\ its_step p = Some (first, last) /\ slopes_between span rise first last.
Proof.
  unfold slopes_between. induction l as [| [[[first last] |] c] l IH]; try easy. intros from until H Hbetween.
  cbn [reaches] in H. unfold is_same_place in H. conditions. compared.
  replace (Q2R (fst from)) with (Q2R (fst first)) in Hbetween by easy.
  replace (Q2R (snd from)) with (Q2R (snd first)) in Hbetween by easy.
  destruct (Rle_dec (rise * Q2R (fst last)) (Q2R (snd last) * span)) as [Hle | Hlt].
  - exists (Part (Some (first, last)) c), first, last. simpl. tauto.
  - destruct l as [| next l].
    + conditions. compared. exfalso. apply Hlt. replace (Q2R (fst last)) with (Q2R (fst until)) by easy.
      now replace (Q2R (snd last)) with (Q2R (snd until)) by easy.
    + destruct (IH last until) as (p & first' & last' & Hin & Hp); [easy | lra |]. exists p, first', last'.
      split; [now right | easy].
Qed.

Section Rectangle.

Variables (spans rises : Q * Q).
Hypothesis spans_ordered : 0 < Q2R (fst spans) <= Q2R (snd spans).
Hypothesis rises_ordered : 0 < Q2R (fst rises) <= Q2R (snd rises).

Lemma ends_are_real d first last : is_step d spans rises (first, last) = true -> is_real first /\ is_real last /\
  (between spans (Q2R (fst first)) /\ between rises (Q2R (snd first))).
Proof.
  intros H. apply step_sound in H. destruct first as [s f], last as [s' f']. unfold is_real, between in *.
  cbn [fst snd]. destruct d, H as [H | H]; cbn [rises_at narrows_at] in H; lra.
Qed.

Variables (span rise : R).
Hypotheses (span_between : between spans span) (rise_between : between rises rise).

Lemma unsafe_step first last : is_step Unsafe spans rises (first, last) = true -> slopes_between span rise first last ->
  opening span rise <= real (opening_of last) /\ Surveys.radius span rise <= Q2R (its_circle Unsafe (first, last)).
Proof.
  intros Hstep [Hfirst Hlast]. destruct (ends_are_real _ _ _ Hstep) as (Hr & Hr' & _). rewrite opening_of_is by easy.
  rewrite <- largest_circle by easy. apply step_sound in Hstep. unfold between, radius_at, is_real in *.
  destruct first as [s f], last as [s' f']. cbn [fst snd] in *. split; [apply opening_grows; lra |].
  destruct Hstep as [(E1 & E2 & Hf & Hf') | (E1 & E2 & Hs & Hs')]; rewrite E1, E2 in *.
  - set (S := Q2R (snd spans)) in *. set (rise' := rise * S / span).
    assert (E : rise' * span = rise * S) by (unfold rise'; field; lra).
    apply Rle_trans with (Surveys.radius S rise'); [apply radius_of_scaled; lra |].
    apply radius_of_rises; [lra | |]; [split; [lra |] |]; apply (Rmult_le_reg_r span); lra.
  - set (F := Q2R (snd rises)) in *. set (span' := span * F / rise).
    assert (E : F * span = rise * span') by (unfold span'; field; lra). apply Rle_trans with (Surveys.radius span' F).
    + apply radius_of_scaled; [| lra | exact E]. split; [lra |]. apply (Rmult_le_reg_l rise); [lra |]. rewrite <- E.
      apply Rmult_le_compat_r; lra.
    + apply Rle_trans with (Surveys.radius (Q2R s) F); [| apply Rmax_l]. apply radius_of_spans; [| lra].
      split; [unfold span'; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra |].
      apply (Rmult_le_reg_l rise); lra.
Qed.

(** On the circles of a rising step. *)
Lemma circles_of_rises first last rise' : is_real first -> is_real last -> Q2R (fst first) = Q2R (fst last) ->
  Q2R (snd first) <= rise' <= Q2R (snd last) ->
  Q2R (its_circle Safe (first, last)) <= Surveys.radius (Q2R (fst first)) rise'.
Proof.
  intros H H' Hs Hf.
  destruct (radius_of_rises (Q2R (fst first)) (Q2R (snd first)) rise' (Q2R (snd last))) as [Hmost Hleast];
    try lra; [apply H | split; [apply H | apply Hf] |].
  destruct (least_circle first last H H') as [(_ & _ & ->) | (Hno & ->)]; [apply Hmost |]. unfold radius_at.
  rewrite <- Hs. now apply Hleast, Hno.
Qed.

Lemma safe_step first last : is_step Safe spans rises (first, last) = true -> slopes_between span rise first last ->
  real (opening_of first) <= opening span rise /\ Q2R (its_circle Safe (first, last)) <= Surveys.radius span rise.
Proof.
  intros Hstep [Hfirst Hlast]. destruct (ends_are_real _ _ _ Hstep) as (Hr & Hr' & _). rewrite opening_of_is by easy.
  apply step_sound in Hstep. split; [apply opening_grows; unfold between, is_real in *; lra |].
  destruct Hstep as [Hleg | Hleg].
  - destruct (least_circle first last Hr Hr') as [(Es & Hhalf & ->) | (_ & ->)];
      unfold between, is_real, radius_at in *; destruct first as [s f], last as [s' f']; cbn [fst snd narrows_at] in *; [lra |].
    destruct Hleg as (E1 & E2 & Hs & Hs'). rewrite E1, E2 in *. set (F := Q2R (fst rises)) in *.
    set (span' := span * F / rise). assert (E : rise * span' = F * span) by (unfold span'; field; lra).
    apply Rle_trans with (Surveys.radius (Q2R s') F); [apply Rmin_r |]. apply Rle_trans with (Surveys.radius span' F).
    + apply radius_of_spans; [split; [lra |] | lra]. apply (Rmult_le_reg_l rise); lra.
    + apply radius_of_scaled; [| lra | exact E]. split.
      * unfold span'. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra.
      * apply (Rmult_le_reg_l rise); [lra |]. rewrite E. apply Rmult_le_compat_r; lra.
  - assert (Hs : Q2R (fst first) = Q2R (fst last)) by (destruct first, last; cbn [rises_at fst] in *; lra).
    assert (S : Q2R (fst first) = Q2R (fst spans)) by (destruct first, last; cbn [rises_at fst] in *; lra).
    rewrite <- Hs in Hlast. unfold between in *. set (rise' := rise * Q2R (fst first) / span).
    assert (E : rise' * span = rise * Q2R (fst first)) by (unfold rise'; field; lra).
    apply Rle_trans with (Surveys.radius (Q2R (fst first)) rise').
    + apply circles_of_rises; try easy. split; apply (Rmult_le_reg_r span); lra.
    + apply radius_of_scaled; [lra | | lra]. unfold rise'.
      apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [lra |] | lra]. apply Hr.
Qed.

(** The least circle of all. *)
Lemma circle_of_all : Q2R (its_circle Safe ((fst spans, fst rises), (fst spans, snd rises))) <= Surveys.radius span rise.
Proof.
  unfold between in *. apply Rle_trans with (Surveys.radius (Q2R (fst spans)) rise).
  - now apply (circles_of_rises (fst spans, fst rises) (fst spans, snd rises)); unfold is_real; cbn [fst snd]; try lra.
  - apply radius_of_spans; lra.
Qed.

End Rectangle.

(** ** The survey *)

Lemma range_sound l : is_range l = true -> 0 < Q2R (fst l) <= Q2R (snd l).
Proof.
  unfold is_range. intros H. conditions. compared. split; [| easy].
  match goal with H : (0 <? _)%Z = true |- _ => apply Z.ltb_lt in H end. unfold Q2R.
  apply Rmult_lt_0_compat; [now apply IZR_lt | now apply Rinv_0_lt_compat, IZR_lt].
Qed.

Definition is_not_negative (mu : option R) : Prop := match mu with Some mu => 0 <= mu | None => True end.
Definition is_sound (s : survey) : Prop :=
  let '(least, most) := frictions s in
  no_more (coefficient least) (coefficient most) /\ is_not_negative (coefficient least) /\
  match its_shape s with
  | Free alphas etas =>
      0 < real (fst alphas) <= real (snd alphas) /\ real (snd alphas) < PI /\
      0 < real (fst etas) <= real (snd etas) /\ real (snd etas) <= 2
  | Spanned c spans rises ts =>
      0 < Q2R (fst spans) <= Q2R (snd spans) /\ 0 < Q2R (fst rises) <= Q2R (snd rises) /\
      0 < Q2R (fst ts) <= Q2R (snd ts) /\
      Q2R (snd ts) <= 2 * (Q2R (its_circle Safe ((fst spans, fst rises), (fst spans, snd rises)))
                           + IZR (to_centreline c) * Q2R (snd ts) / 2)
  end.

Lemma is_survey_sound s : is_survey s = true -> is_sound s.
Proof.
  intros H. assert (Hsome : exists prec, is_survey_at s prec = true).
  { unfold is_survey in H. destruct (is_survey_at s 128) eqn:H128; [now exists 128%Z |].
    destruct (is_survey_at s 1024) eqn:H1024; [now exists 1024%Z | now exists 4096%Z]. }
  clear H. destruct Hsome as [prec H]. revert H. unfold is_survey_at, is_sound.
  destruct (frictions s) as [least most]. intros H.
  assert (not_negative : forall w alpha, is_arch (Arch w alpha least) -> is_not_negative (coefficient least)).
  { intros w alpha Harch. apply friction_not_negative in Harch. cbn [its_friction] in Harch.
    unfold coefficient_or_zero in Harch. now destruct (coefficient least). }
  destruct (its_shape s) as [[narrow wide] [thin thick] | c spans rises ts]; cbv zeta in H; conditions;
    repeat match goal with
      | H : is_given _ _ = true |- _ => apply is_given_sound in H
      | H : are_in_order _ _ = true |- _ => apply in_order_sound in H
      | H : is_range _ = true |- _ => apply range_sound in H
      | H : is_thickness _ = true |- _ => apply is_thickness_sound in H
      end.
  - split; [eapply frictions_in_order_sound; eassumption | split; [eapply not_negative; eassumption |]].
    repeat match goal with H : is_arch _ |- _ => destruct H as [H _]; cbn [half_opening] in H end. cbn [fst snd]. lra.
  - split; [eapply frictions_in_order_sound; eassumption | split; [eapply not_negative; eassumption |]]. compared.
    unfold outwards, inject_Z in *. rewrite Q2R_mult, Q2R_plus, Q2R_div in * by easy. in_reals. tauto.
Qed.

Lemma outwards_between c : -1 <= IZR (to_centreline c) <= 1.
Proof. destruct c; simpl; lra. Qed.

Lemma no_more_refl a : no_more a a.
Proof. destruct a; [apply Rle_refl | easy]. Qed.

Lemma surveyed_is_arch s alpha eta mu : is_sound s -> surveyed s alpha eta mu ->
  0 < alpha < PI /\ 0 < eta <= 2 /\ is_not_negative mu.
Proof.
  unfold is_sound, surveyed. destruct (frictions s) as [least most]. intros (_ & Hmu & Hs) (Hleast & _ & H).
  assert (is_not_negative mu).
  { cbn [fst] in Hleast. destruct mu, (coefficient least); cbn [is_not_negative no_more] in *; easy || lra. }
  destruct (its_shape s) as [alphas etas | c spans rises ts]; [split; [lra | split; [lra | easy]] |].
  destruct Hs as (Hspans & Hrises & Hts & Hroom). destruct H as (span & rise & t & Hspan & Hrise & Ht & -> & ->).
  assert (all := circle_of_all spans rises ltac:(easy) ltac:(easy) span rise Hspan Hrise). unfold between in *.
  split; [apply opening_between; lra | split; [| easy]].
  apply (ratio_between _ t (Q2R (snd ts)) _ _ (outwards_between c) ltac:(lra) all Hroom).
Qed.

(** How an arch that decides compares with one of the survey. *)
Definition is_beside (d : side) (a : arch) (t : number) (alpha eta : R) (mu : option R) : Prop :=
  match d with
  | Unsafe => alpha <= real (half_opening a) /\ real t <= eta /\ no_more (coefficient (its_friction a)) mu
  | Safe => real (half_opening a) <= alpha /\ eta <= real t /\ no_more mu (coefficient (its_friction a))
  end.

Lemma some_part_decides s d b l alpha eta mu : is_sound s -> are_all s l = true -> forallb (decides s d b) l = true ->
  surveyed s alpha eta mu -> exists a t, self_weight a = survey_weight s /\ is_thickness t = true /\
  0 < real (half_opening a) /\ is_beside d a t alpha eta mu /\ if b then stands a (real t) else ~ stands a (real t).
Proof.
  intros Hs Hall Hdecides Harch.
  assert (one : forall p a t, In p l -> deciding s d (its_step p) = Some (a, t) ->
    is_thickness t = true /\ if b then stands a (real t) else ~ stands a (real t)).
  { intros p a t Hp Hd. apply (each_one _ _ p) in Hdecides; [| exact Hp]. unfold decides in Hdecides.
    rewrite Hd in Hdecides. apply andb_true_iff in Hdecides as [Ht Hc]. split; [exact Ht |].
    now apply (decided_sound (its_certificate p)). }
  assert (known : forall p, In p l -> deciding s d (its_step p) <> None).
  { intros p Hp E. apply (each_one _ _ p) in Hdecides; [| exact Hp]. unfold decides in Hdecides. now rewrite E in Hdecides. }
  unfold is_sound, surveyed, are_all, deciding in *. destruct (frictions s) as [least most].
  destruct (its_shape s) as [[narrow wide] [thin thick] | c spans rises ts].
  - destruct l as [| p [|]]; try easy. specialize (one p). specialize (known p ltac:(now left)).
    destruct (its_step p) as [step |]; [easy |]. destruct (one _ _ ltac:(now left) eq_refl) as [Ht Hb].
    eexists; eexists. split; [| split; [exact Ht | split; [| split; [| exact Hb]]]]; [easy | |];
      cbn [fst snd] in *; [destruct d; cbn [half_opening]; lra |]. destruct d; cbn [is_beside half_opening its_friction end_of fst snd]; tauto.
  - destruct Hs as (_ & _ & Hspans & Hrises & Hts & Hroom).
    destruct Harch as (Hleast & Hmost & span & rise & t & Hspan & Hrise & Ht & -> & ->).
    destruct (reaches_sound span rise l _ _ Hall) as (p & first & last & Hp & Estep & Hslopes).
    { unfold slopes_between, between in *. cbn [fst snd]. split; apply Rmult_le_compat; lra. }
    specialize (one p). specialize (known p Hp). rewrite Estep in *.
    destruct (is_step d spans rises (first, last)) eqn:Hstep; [| easy].
    destruct (one _ _ Hp eq_refl) as [Hthick Hb].
    destruct (ends_are_real spans rises ltac:(easy) ltac:(easy) _ _ _ Hstep) as (Hr & Hr' & _).
    eexists; eexists. split; [| split; [exact Hthick | split; [| split; [| exact Hb]]]]; [easy | |].
    { destruct d; cbn [half_opening fst snd]; rewrite opening_of_is by easy; apply opening_between; first [apply Hr | apply Hr']. }
    destruct (ratio_of_is _ _ _ Hthick) as [Eratio Hpositive]; [destruct d; cbn [end_of]; lra |].
    assert (all := circle_of_all spans rises ltac:(easy) ltac:(easy) span rise Hspan Hrise).
    assert (Hradius : 0 < Surveys.radius span rise) by (unfold between in *; apply radius_positive; lra).
    unfold between in Ht. assert (B := outwards_between c).
    destruct (ratio_between _ t (Q2R (snd ts)) _ _ B ltac:(lra) all Hroom) as [Hout _].
    destruct d; cbn [is_beside half_opening its_friction end_of fst snd] in *; rewrite Eratio.
    + destruct (unsafe_step spans rises) with (span := span) (rise := rise) (first := first) (last := last) as [Ha Hc]; try easy.
      split; [exact Ha | split; [| exact Hleast]]. apply ratio_grows; try lra.
    + destruct (safe_step spans rises) with (span := span) (rise := rise) (first := first) (last := last) as [Ha Hc]; try easy.
      split; [exact Ha | split; [| exact Hmost]].
      assert (P := least_circle_positive first last Hr Hr'). apply ratio_grows; lra.
Qed.

Lemma single_is_surveyed s d p a t : is_sound s -> is_single p = true -> deciding s d (its_step p) = Some (a, t) ->
  is_thickness t = true -> surveyed s (real (half_opening a)) (real t) (coefficient (its_friction a)).
Proof.
  unfold is_sound, surveyed, deciding, is_single, is_same_place. intros Hs Hsingle Hd Hthick.
  destruct (frictions s) as [least most]. destruct Hs as (Hmu & _ & Hs).
  assert (friction : forall alpha, a = Arch (survey_weight s) alpha (end_of d (least, most)) ->
    no_more (coefficient least) (coefficient (its_friction a)) /\ no_more (coefficient (its_friction a)) (coefficient most)).
  { intros alpha ->. destruct d; cbn [its_friction end_of fst snd]; split; easy || apply no_more_refl. }
  cbn [fst snd]. destruct (its_shape s) as [[narrow wide] [thin thick] | c spans rises ts], (its_step p) as [[first last] |]; try easy.
  - injection Hd as <- <-. destruct (friction _ eq_refl) as [Hleast Hmost]. cbn [fst snd half_opening] in *.
    destruct d; cbn [end_of fst snd]; repeat split; easy || lra.
  - destruct (is_step d spans rises (first, last)) eqn:Hstep; [| easy]. injection Hd as <- <-.
    destruct (friction _ eq_refl) as [Hleast Hmost]. split; [exact Hleast | split; [exact Hmost |]].
    destruct Hs as (Hspans & Hrises & Hts & _). conditions. compared.
    destruct (ends_are_real spans rises ltac:(easy) ltac:(easy) _ _ _ Hstep) as (Hr & Hr' & Hspan & Hrise).
    exists (Q2R (fst first)), (Q2R (snd first)), (Q2R (end_of d ts)).
    split; [exact Hspan | split; [exact Hrise | split; [unfold between; destruct d; cbn [end_of]; lra |]]].
    cbn [half_opening]. destruct (ratio_of_is _ _ _ Hthick) as [-> _]; [destruct d; cbn [end_of]; lra |].
    assert (same : radius_at last = radius_at first) by (unfold radius_at; congruence). split.
    + destruct d; cbn [fst snd]; rewrite opening_of_is by easy; congruence.
    + enough (E : Q2R (its_circle d (first, last)) = radius_at first) by (unfold its_circle in E; now rewrite E).
      destruct d.
      * rewrite <- largest_circle, same by easy. now apply Rmax_left, Rle_refl.
      * destruct (least_circle first last Hr Hr') as [(_ & Hhalf & _) | (_ & ->)]; [lra |].
        rewrite same. now apply Rmin_left, Rle_refl.
Qed.

(** ** The theorem *)

Theorem sound_survey c : check_survey c = true -> claim_of_survey c.
Proof.
  unfold check_survey, claim_of_survey. cbv zeta. set (s := of_survey c). intros H.
  apply andb_true_iff in H as [Hsurvey H]. apply is_survey_sound in Hsurvey.
  assert (single : forall d b p, is_single p = true -> decides s d b p = true ->
    exists alpha eta mu, surveyed s alpha eta mu /\
      if b then stands_with (survey_weight s) alpha eta mu else ~ stands_with (survey_weight s) alpha eta mu).
  { intros d b p Hp Hd. unfold decides in Hd. destruct (deciding s d (its_step p)) as [[a t] |] eqn:E; [| easy].
    apply andb_true_iff in Hd as [Ht Hc]. exists (real (half_opening a)), (real t), (coefficient (its_friction a)).
    split; [now apply (single_is_surveyed s d p) |]. assert (W : self_weight a = survey_weight s).
    { revert E. unfold deciding. destruct (its_shape s) as [[] |], (its_step p) as [[] |]; try easy;
        [now intros [= <- _] | destruct (is_step _ _ _ _); [now intros [= <- _] | easy]]. }
    assert (D := decided_sound _ _ _ _ Hc Ht). unfold stands in D. now rewrite W in D. }
  refine (conj _ (conj _ _)).
  - intros alpha eta mu Harch. now apply (surveyed_is_arch s).
  - assert (Hs := Hsurvey). unfold is_sound in Hs. unfold surveyed. destruct (frictions s) as [least most].
    cbn [fst snd]. destruct Hs as (Hmu & _ & Hs). destruct (its_shape s) as [alphas etas | k spans rises ts].
    + exists (real (fst alphas)), (real (fst etas)), (coefficient least).
      split; [apply no_more_refl | split; [exact Hmu |]]. lra.
    + eexists; eexists; exists (coefficient least). split; [apply no_more_refl | split; [exact Hmu |]].
      exists (Q2R (fst spans)), (Q2R (fst rises)), (Q2R (fst ts)). unfold between. repeat split; lra.
  - destruct (its_verdict c).
    + conditions. intros alpha eta mu Harch.
      destruct (surveyed_is_arch s alpha eta mu Hsurvey Harch) as (Ha & He & _).
      destruct (some_part_decides s Unsafe true (parts c) alpha eta mu) as (a & t & W & Ht & Hp & (Ha' & He' & Hmu) & Hb); try easy.
      apply is_thickness_sound in Ht. unfold stands in Hb. rewrite W in Hb.
      apply (stands_more _ _ _ _ _ _ _ Hb); try easy; lra.
    + conditions. intros alpha eta mu Harch Hstands.
      destruct (surveyed_is_arch s alpha eta mu Hsurvey Harch) as (Ha & He & _).
      destruct (some_part_decides s Safe false (parts c) alpha eta mu) as (a & t & W & Ht & Hp & (Ha' & He' & Hmu) & Hb); try easy.
      apply is_thickness_sound in Ht. apply Hb. unfold stands. rewrite W.
      apply (stands_more _ _ _ _ _ _ _ Hstands); try easy; lra.
    + destruct (parts c) as [| p [| q [|]]]; try easy. conditions.
      split; [now apply (single Safe true q) | now apply (single Unsafe false p)].
Qed.
