(** * Up to the right angle nothing moves asymmetrically

    An arch whose half opening is at most the right angle, in a state with a vertical force [v] in the crown:
    whichever joints are at their limits, at any number of places, without dilatancy no rates fit but zero. So
    there the complementarity problem (19) of the whole arch has symmetric states alone.

    Let [v] be positive. The mirror image of a joint bears more than the joint itself, so that the line of
    thrust reaches the extrados on the right and the intrados on the left ([extrados_on_the_right],
    [intrados_on_the_left]), and no joint slides inwards as seen on the right ([nothing_slides_inwards]). Each
    joint that moves then moves what is left of it upwards, if at all, and the left springing stays. *)

From Couplet Require Import Whole.
From Coq Require Import List.

(** ** What is claimed *)

(** Ways in which a joint gives way, as seen on the right. *)
Inductive release := opens_above | opens_below | slips_in | slips_out.

Definition margin_of (delta eta mu h p v : R) (how : release) (x : R) : R :=
  match how with
  | opens_above => from_extrados delta eta h p v x
  | opens_below => from_intrados delta eta h p v x
  | slips_in => against_inwards mu h v x
  | slips_out => against_outwards mu h v x
  end.

(** What a joint adds at the rate one, without dilatancy: the velocity to the right and upwards, and the rotation. *)
Definition row (eta : R) (how : release) (x : R) : R * R * R :=
  match how with
  | opens_above => turns_above eta x
  | opens_below => turns_below eta x
  | slips_in => scaled (-1) (slips_outwards x)
  | slips_out => slips_outwards x
  end.

(** A joint that may move: how, where, and its rate. *)
Record moving := joint { how : release; place : R; rate : R }.

Definition total (eta : R) (motion : list moving) : R * R * R :=
  fold_right (fun j sum => plus (scaled (rate j) (row eta (how j) (place j))) sum) (0, 0, 0) motion.

(** A motion that (19) allows: each joint is one of the arch, its rate is not negative, only joints at their limit
    have one, and the springings do not move. *)
Definition allowed (delta alpha eta mu h p v : R) (j : moving) : Prop :=
  - alpha <= place j <= alpha /\ 0 <= rate j /\
  rate j * margin_of delta eta mu h p v (how j) (place j) = 0.

Definition is_motion (delta alpha eta mu h p v : R) (motion : list moving) : Prop :=
  Forall (allowed delta alpha eta mu h p v) motion /\ total eta motion = (0, 0, 0).

(** ** A joint and its mirror image *)

Section Right.
  Variables delta alpha eta mu h p v : R.
  Hypothesis Hdelta : 0 <= delta.
  Hypothesis Halpha : 0 < alpha < PI.
  Hypothesis Heta : 0 < eta <= 2.
  Hypothesis Hmu : 0 <= mu.
  Hypothesis Hv : 0 < v.
  Hypothesis Hall : whole_admissible delta alpha eta mu h p v.

  Lemma thrust_positive : 0 < h.
  Proof.
    destruct (Hall 0 ltac:(lra)) as (_ & _ & _ & Hout).
    unfold against_outwards, whole_normal, whole_shear in Hout. rewrite cos_0, sin_0 in Hout.
    apply Rnot_le_lt. intros Hh. assert (mu * h <= 0) by nra. lra.
  Qed.

  Lemma moment_grows x : 0 <= p /\ 0 <= fac delta eta * (1 - cos x) /\ (cos x < 1 -> 0 < whole_moment delta eta p x).
  Proof.
    assert (Hh := thrust_positive). destruct (Hall 0 ltac:(lra)) as (_ & HL & _).
    unfold from_intrados, whole_moment, whole_normal, intrados in *. rewrite cos_0, sin_0 in HL.
    assert (0 < fac delta eta) by (unfold fac; nra). destruct (COS_bound x). repeat split; nra.
  Qed.

  Lemma signs_at x : - alpha <= x <= alpha -> (0 < x -> 0 < sin x) /\ (x < 0 -> sin x < 0) /\ (x <> 0 -> cos x < 1).
  Proof.
    intros Hx. split; [intros; apply sin_gt_0; lra | split; [intros; apply sin_lt_0_var; lra |]]. intros Hne.
    rewrite <- cos_0. destruct (Rlt_le_dec 0 x); [| rewrite <- (cos_neg x)]; apply cos_decreasing_1; lra.
  Qed.

  Lemma normal_positive x : - alpha <= x <= alpha -> 0 < whole_normal h v x.
  Proof.
    intros Hx. assert (Hh := thrust_positive). destruct (Req_dec x 0) as [-> | Hne].
    - unfold whole_normal. rewrite cos_0, sin_0. lra.
    - assert (HM := proj2 (proj2 (moment_grows x)) (proj2 (proj2 (signs_at x Hx)) Hne)).
      destruct (Hall x Hx) as (HU & _). unfold from_extrados, extrados in HU. nra.
  Qed.

  Lemma extrados_on_the_right x : - alpha <= x <= alpha -> from_extrados delta eta h p v x = 0 -> 0 <= x.
  Proof.
    intros Hx H0. destruct (Hall (- x) ltac:(lra)) as (HU & _). apply Rnot_lt_le. intros Hneg.
    assert (Hs := proj1 (proj2 (signs_at x Hx)) Hneg).
    unfold from_extrados, whole_moment, whole_normal in *. rewrite sin_neg, cos_neg in HU.
    assert (0 < extrados eta * (v * - sin x)) by (repeat apply Rmult_lt_0_compat; unfold extrados; lra). lra.
  Qed.

  (** Where the whole radius is the thickness the intrados is the centre, reached in the crown alone. *)
  Lemma intrados_on_the_left x : - alpha <= x <= alpha -> from_intrados delta eta h p v x = 0 ->
    x <= 0 /\ (eta = 2 -> x = 0).
  Proof.
    intros Hx H0. assert (Hlimit : eta = 2 -> x = 0).
    { intros E. destruct (Req_dec x 0) as [H | Hne]; [easy |].
      assert (HM := proj2 (proj2 (moment_grows x)) (proj2 (proj2 (signs_at x Hx)) Hne)).
      unfold from_intrados, intrados in H0. rewrite E in *. lra. }
    split; [| easy]. apply Rnot_lt_le. intros Hpos. assert (Hs := proj1 (signs_at x Hx) Hpos).
    destruct (Hall (- x) ltac:(lra)) as (_ & HL & _). unfold from_intrados, whole_moment, whole_normal in *.
    rewrite sin_neg, cos_neg in HL.
    assert (0 < intrados eta * (v * sin x)) by (repeat apply Rmult_lt_0_compat; unfold intrados; lra). lra.
  Qed.

  Lemma normal_and_shear_of_thrust x :
    cos x * whole_normal h v x - sin x * whole_shear h v x = h.
  Proof.
    unfold whole_normal, whole_shear.
    transitivity (h * (sin x * sin x + cos x * cos x)); [ring |].
    assert (H := sin2_cos2 x). unfold Rsqr in H. rewrite H. ring.
  Qed.

  (** The mirror image of a joint that did so would be beyond its limit. *)
  Lemma nothing_slides_inwards x : - alpha <= x <= alpha -> against_inwards mu h v x <> 0.
  Proof.
    intros Hx H0. assert (Hh := thrust_positive). assert (HN := normal_positive x Hx).
    assert (Hforce := normal_and_shear_of_thrust x). destruct (Hall (- x) ltac:(lra)) as (_ & _ & _ & Hmirror).
    replace (against_outwards mu h v (- x)) with (against_inwards mu h v x + 2 * v * (mu * sin x - cos x)) in Hmirror
      by (unfold against_outwards, against_inwards, whole_normal, whole_shear; rewrite sin_neg, cos_neg; ring).
    assert (HT : whole_shear h v x = mu * whole_normal h v x) by (unfold against_inwards in H0; lra).
    rewrite HT in Hforce. nra.
  Qed.

  (** Nothing moves downwards in an arch that is no horseshoe. *)
  Hypothesis Hnarrow : alpha <= PI / 2.

  (** ** All joints together *)

  Lemma none_of_a_sum (f : moving -> R) (motion : list moving) : Forall (fun j => 0 <= f j) motion ->
    fold_right (fun j sum => f j + sum) 0 motion = 0 -> Forall (fun j => f j = 0) motion.
  Proof.
    induction motion as [| j rest IH]; intros Hpos Hsum; [constructor |].
    inversion Hpos as [| ? ? Hj Hrest]; subst. simpl in Hsum.
    assert (H0 : 0 <= fold_right (fun j sum => f j + sum) 0 rest).
    { clear - Hrest. induction rest; simpl; [lra |]. inversion Hrest; subst.
      specialize (IHrest H2). lra. }
    constructor; [lra |]. apply IH; [easy | lra].
  Qed.

  Definition across_of (j : moving) : R := rate j * fst (fst (row eta (how j) (place j))).
  Definition upwards_of (j : moving) : R := rate j * snd (fst (row eta (how j) (place j))).
  Definition turn_of (j : moving) : R := rate j * snd (row eta (how j) (place j)).

  Lemma total_by_components motion : total eta motion =
    (fold_right (fun j sum => across_of j + sum) 0 motion,
     fold_right (fun j sum => upwards_of j + sum) 0 motion,
     fold_right (fun j sum => turn_of j + sum) 0 motion).
  Proof.
    induction motion as [| j rest IH]; [easy |]. simpl. rewrite IH.
    unfold across_of, upwards_of, turn_of. destruct (row eta (how j) (place j)) as [[a b] c]. easy.
  Qed.

  Lemma upwards_not_negative j : allowed delta alpha eta mu h p v j -> 0 <= upwards_of j.
  Proof.
    intros (Hx & Hr & H0). unfold upwards_of. destruct j as [way x r]; simpl in *.
    destruct (Req_dec r 0) as [-> | Hne]; [lra |]. destruct (Rmult_integral _ _ H0) as [H | H]; [easy |].
    apply Rmult_le_pos; [easy |]. destruct way; simpl in *.
    - assert (Hright := extrados_on_the_right x Hx H). apply Rmult_le_pos; [unfold extrados; lra | apply sin_ge_0; lra].
    - destruct (intrados_on_the_left x Hx H) as [Hleft _]. assert (Hs := sin_ge_0 (- x) ltac:(lra) ltac:(lra)).
      rewrite sin_neg in Hs. unfold intrados. nra.
    - now destruct (nothing_slides_inwards x Hx).
    - apply cos_ge_0; lra.
  Qed.

  (** A hinge that does not move upwards is in the crown. *)
  Lemma hinges_are_at_the_crown j : allowed delta alpha eta mu h p v j -> upwards_of j = 0 -> rate j <> 0 ->
    how j = opens_above \/ how j = opens_below -> margin_of delta eta mu h p v (how j) 0 = 0.
  Proof.
    intros (Hx & _ & H0) Hup Hr Hhow. unfold upwards_of in Hup. destruct j as [way x r]; simpl in *.
    destruct (Rmult_integral _ _ H0) as [H | H]; [easy |]. destruct (Rmult_integral _ _ Hup) as [H' | H']; [easy |].
    assert (E : x = 0); [| rewrite E in H; exact H]. destruct (signs_at x Hx) as (Hpos & Hneg & _).
    destruct Hhow as [-> | ->]; simpl in *.
    - assert (Hright := extrados_on_the_right x Hx H). unfold extrados in H'. destruct (Req_dec x 0); [easy | nra].
    - destruct (intrados_on_the_left x Hx H) as [Hleft Hlimit]. unfold intrados in H'.
      destruct (Req_dec eta 2) as [E | E]; [now apply Hlimit |]. destruct (Req_dec x 0) as [Z | Z]; [easy |].
      specialize (Hneg ltac:(lra)). assert (0 < 1 - eta / 2) by lra. nra.
  Qed.

  Theorem nothing_moves motion : is_motion delta alpha eta mu h p v motion ->
    Forall (fun j => rate j = 0) motion.
  Proof.
    intros [Hallowed Htotal]. rewrite total_by_components in Htotal. injection Htotal as Hacross Hup Hturn.
    assert (Hup0 : Forall (fun j => upwards_of j = 0) motion).
    { apply none_of_a_sum; [| easy]. eapply Forall_impl; [apply upwards_not_negative | easy]. }
    rewrite Forall_forall in Hallowed, Hup0.
    (* a hinge at the extrados needs one at the intrados, and both would be at the crown *)
    assert (Hturn0 : forall j, In j motion -> turn_of j = 0).
    { assert (Hboth : from_extrados delta eta h p v 0 = 0 -> from_intrados delta eta h p v 0 <> 0).
      { intros HU HL. assert (Hh := thrust_positive).
        unfold from_extrados, from_intrados, whole_normal, extrados, intrados in *. rewrite cos_0, sin_0 in *. nra. }
      assert (Hone : exists s, s <> 0 /\ forall j, In j motion -> 0 <= s * turn_of j).
      { destruct (Req_dec (from_extrados delta eta h p v 0) 0) as [HU | HU]; [exists (-1) | exists 1]; (split; [lra |]);
          intros j Hj; assert (Hcrown := hinges_are_at_the_crown j (Hallowed j Hj) (Hup0 j Hj));
          destruct (Hallowed j Hj) as (_ & Hr & _); unfold turn_of; destruct j as [[] x r]; simpl in *; try lra;
          (destruct (Req_dec r 0) as [-> | Hne]; [lra |]); specialize (Hcrown Hne); tauto. }
      destruct Hone as (s & Hs & Hone). assert (Hnone := none_of_a_sum (fun j => s * turn_of j) motion).
      rewrite !Forall_forall in Hnone. intros j Hj. apply (Rmult_eq_reg_l s); [| easy]. rewrite Rmult_0_r.
      apply Hnone; [easy | | easy]. transitivity (s * fold_right (fun j sum => turn_of j + sum) 0 motion).
      - clear. induction motion; simpl; [ring |]. rewrite IHmotion. ring.
      - rewrite Hturn. ring. }
    assert (Hhinges : forall j, In j motion -> how j = opens_above \/ how j = opens_below -> rate j = 0).
    { intros j Hj Hhow. assert (H := Hturn0 j Hj). unfold turn_of in H.
      destruct j as [[] x r]; simpl in *; [lra | lra | |]; now destruct Hhow. }
    (* what slides does so at the right springing alone, to the right *)
    assert (Hslips : forall j, In j motion -> rate j <> 0 -> how j = slips_out /\ sin (place j) = 1).
    { intros j Hj Hne. assert (Hup' := Hup0 j Hj). destruct (Hallowed j Hj) as (Hx & Hr & H0).
      assert (Hno := Hhinges j Hj). unfold upwards_of in Hup'. destruct j as [way x r]; simpl in *.
      destruct (Rmult_integral _ _ H0) as [H | H]; [easy |].
      destruct way; simpl in *; [now elim Hne; apply Hno; left | now elim Hne; apply Hno; right | |].
      - now destruct (nothing_slides_inwards x Hx).
      - split; [easy |]. destruct (Rmult_integral _ _ Hup') as [H' | HC]; [easy |].
        assert (Hh := thrust_positive). assert (Hforce := normal_and_shear_of_thrust x).
        assert (HN := normal_positive x Hx). unfold against_outwards in H.
        rewrite HC in Hforce. assert (Hcircle := sin2_cos2 x). unfold Rsqr in Hcircle.
        rewrite HC in Hcircle. assert (mu * whole_normal h v x >= 0) by nra. nra. }
    assert (Hacross0 : Forall (fun j => across_of j = 0) motion).
    { apply none_of_a_sum; [| easy]. apply Forall_forall. intros j Hj.
      destruct (Req_dec (rate j) 0) as [Hr | Hr]; [unfold across_of; rewrite Hr; lra |].
      destruct (Hslips j Hj Hr) as [Hhow Hs]. destruct (Hallowed j Hj) as (_ & Hpos & _).
      unfold across_of. rewrite Hhow. simpl. rewrite Hs. lra. }
    rewrite Forall_forall in *. intros j Hj. destruct (Req_dec (rate j) 0) as [Hr | Hr]; [easy |].
    destruct (Hslips j Hj Hr) as [Hhow Hs]. assert (H := Hacross0 j Hj).
    unfold across_of in H. rewrite Hhow in H. simpl in H. rewrite Hs in H. lra.
  Qed.
End Right.

(** ** Either sign of the vertical force *)

Definition mirrored_way (way : release) : release :=
  match way with slips_in => slips_out | slips_out => slips_in | same => same end.

Definition mirrored (j : moving) : moving := joint (mirrored_way (how j)) (- place j) (rate j).

Lemma mirrored_margin delta eta mu h p v way x :
  margin_of delta eta mu h p (- v) (mirrored_way way) (- x) = margin_of delta eta mu h p v way x.
Proof.
  destruct way; simpl; unfold from_extrados, from_intrados, against_inwards, against_outwards, whole_moment,
    whole_normal, whole_shear; rewrite sin_neg, cos_neg; ring.
Qed.

Lemma mirrored_state delta alpha eta mu h p v :
  whole_admissible delta alpha eta mu h p v -> whole_admissible delta alpha eta mu h p (- v).
Proof.
  intros Hall x Hx. destruct (Hall (- x) ltac:(lra)) as (HU & HL & HI & HO).
  assert (H := mirrored_margin delta eta mu h p v). assert (E : - - x = x) by ring.
  assert (H1 := H opens_above (- x)). assert (H2 := H opens_below (- x)). assert (H3 := H slips_in (- x)).
  assert (H4 := H slips_out (- x)). simpl in *. rewrite E in *. lra.
Qed.

Lemma mirrored_motion delta alpha eta mu h p v motion :
  is_motion delta alpha eta mu h p v motion -> is_motion delta alpha eta mu h p (- v) (map mirrored motion).
Proof.
  intros [Hallowed Htotal]. split.
  - apply Forall_map. eapply Forall_impl; [| exact Hallowed]. intros [way x r] (Hx & Hr & H0).
    unfold allowed, mirrored. simpl in *. rewrite mirrored_margin. repeat split; try lra.
  - assert (H : forall l, total eta (map mirrored l)
              = (fst (fst (total eta l)), - snd (fst (total eta l)), snd (total eta l))).
    { induction l as [| [way x r] l IH]; [simpl; repeat f_equal; ring |]. simpl map. unfold total in *. simpl.
      rewrite IH. destruct (fold_right _ _ l) as [[a b] c]. destruct way; simpl; unfold slips_outwards, scaled;
        simpl; rewrite ?sin_neg, ?cos_neg; repeat apply f_equal2; ring. }
    rewrite H, Htotal. simpl. repeat f_equal. ring.
Qed.

Theorem no_asymmetric_motion_up_to_the_right_angle (delta alpha eta mu h p v : R) (motion : list moving) :
  0 <= delta -> 0 < alpha <= PI / 2 -> 0 < eta <= 2 -> 0 <= mu ->
  whole_admissible delta alpha eta mu h p v -> v <> 0 ->
  is_motion delta alpha eta mu h p v motion -> Forall (fun j => rate j = 0) motion.
Proof.
  intros Hd Ha He Hm Hall Hv Hmotion. destruct (Rlt_le_dec 0 v) as [Hpos | Hneg].
  - apply (nothing_moves delta alpha eta mu h p v); easy || lra.
  - assert (H : Forall (fun j => rate j = 0) (map mirrored motion)).
    { apply (nothing_moves delta alpha eta mu h p (- v)); try lra.
      - now apply mirrored_state.
      - now apply mirrored_motion. }
    rewrite Forall_map in H. exact H.
Qed.
