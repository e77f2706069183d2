(** * Up to the right angle nothing moves asymmetrically

    An arch whose half opening is at most the right angle, in a state with a vertical force [v] in the crown: whichever
    joints are at their limits, at any number of places, without dilatancy no rates fit but zero. So there the
    complementarity problem (19) of the whole arch has symmetric states alone.

    Let [v] be positive. The mirror image of a joint bears more than the joint itself, so that the line of thrust
    reaches the extrados on the right and the intrados on the left, and no joint slides inwards as seen on the right.
    Each joint that moves then moves what is left of it upwards, if at all, and the left springing stays. *)

From Couplet Require Import Whole Contact.
From Coq Require Import List Classical.
Import ListNotations.

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
  Hypotheses (Hdelta : 0 <= delta) (Halpha : 0 < alpha < PI) (Heta : 0 < eta <= 2) (Hmu : 0 <= mu) (Hv : 0 < v)
    (Hall : whole_admissible delta alpha eta mu h p v).

  Lemma thrust_positive : 0 < h.
  Proof.
    destruct (Hall 0 ltac:(lra)) as (_ & _ & _ & Hout). unfold against_outwards, whole_normal, whole_shear in Hout.
    rewrite cos_0, sin_0 in Hout. nra.
  Qed.

  Lemma moment_grows x : 0 <= p /\ 0 <= fac delta eta * (1 - cos x) /\ (cos x < 1 -> 0 < whole_moment delta eta p x).
  Proof.
    assert (Hh := thrust_positive). destruct (Hall 0 ltac:(lra)) as (_ & HL & _).
    unfold from_intrados, whole_moment, whole_normal, intrados in *. rewrite cos_0, sin_0 in HL.
    assert (0 < fac delta eta) by (unfold fac; nra). destruct (COS_bound x). repeat split; nra.
  Qed.

  Lemma signs_at x : - alpha <= x <= alpha -> (0 < x -> 0 < sin x) /\ (x < 0 -> sin x < 0) /\ (x <> 0 -> cos x < 1).
  Proof.
    split; [intros; positive | split; [intros; apply sin_lt_0_var; lra |]]. intros Hne. rewrite <- cos_0.
    destruct (Rlt_le_dec 0 x); [| rewrite <- (cos_neg x)]; apply cos_decreasing_1; lra.
  Qed.

  Lemma normal_positive x : - alpha <= x <= alpha -> 0 < whole_normal h v x.
  Proof.
    intros Hx. assert (Hh := thrust_positive). destruct (Req_dec x 0) as [-> | Hne].
    - unfold whole_normal. rewrite cos_0, sin_0. lra.
    - assert (HM := proj2 (proj2 (moment_grows x)) (proj2 (proj2 (signs_at x Hx)) Hne)).
      destruct (Hall x Hx) as (HU & _). unfold from_extrados, extrados in HU. nra.
  Qed.

  (** How far the line of thrust is from a circle, and the slope of that. *)
  Definition face (r x : R) : R := r * whole_normal h v x - whole_moment delta eta p x.
  Definition face_slope (r x : R) : R := r * normal_slope h v x - fac delta eta * sin x.

  (** A margin that is zero inside the arch has no slope there. *)
  Lemma level (f : R -> R) x l : - alpha < x < alpha -> (forall y, - alpha <= y <= alpha -> 0 <= f y) -> f x = 0 ->
    is_derive f x l -> l = 0.
  Proof.
    intros Hx Hf H0 Hl. apply is_derive_Reals in Hl. assert (pr : derivable_pt f x) by (now exists l).
    rewrite <- (derive_pt_eq_0 f x l pr Hl). apply (deriv_minimum f (- alpha) alpha x pr); try lra.
    intros y Ha Hb. rewrite H0. apply Hf. lra.
  Qed.

  Lemma level_extrados x : - alpha < x < alpha -> from_extrados delta eta h p v x = 0 ->
    face_slope (extrados eta) x = 0.
  Proof. intros Hx H0. exact (level _ x _ Hx (fun y H => proj1 (Hall y H)) H0 (extrados_has_slope _ _ _ _ _ _)). Qed.

  Lemma level_intrados x : - alpha < x < alpha -> from_intrados delta eta h p v x = 0 ->
    face_slope (intrados eta) x = 0.
  Proof.
    intros Hx H0.
    assert (E := level _ x _ Hx (fun y Hy => proj1 (proj2 (Hall y Hy))) H0 (intrados_has_slope _ _ _ _ _ _)).
    unfold intrados_slope, face_slope in *. lra.
  Qed.

  Lemma extrados_on_the_right x : - alpha <= x <= alpha -> from_extrados delta eta h p v x = 0 -> 0 < x.
  Proof.
    intros Hx H0. apply Rnot_le_lt. intros [Hneg | ->].
    - assert (Hs := proj1 (proj2 (signs_at x Hx)) Hneg). destruct (Hall (- x) ltac:(lra)) as (HU & _).
      unfold from_extrados, whole_moment, whole_normal in *. rewrite sin_neg, cos_neg in HU.
      assert (0 < extrados eta * (v * - sin x)) by positive. lra.
    - assert (Hl := level_extrados 0 ltac:(lra) H0). unfold face_slope, normal_slope, extrados in Hl.
      rewrite sin_0, cos_0 in Hl. nra.
  Qed.

  (** Where the whole radius is the thickness the intrados is the centre, reached in the crown alone. *)
  Lemma intrados_on_the_left x : - alpha <= x <= alpha -> from_intrados delta eta h p v x = 0 ->
    x <= 0 /\ (x = 0 <-> eta = 2).
  Proof.
    intros Hx H0. assert (Hlimit : eta = 2 -> x = 0).
    { destruct (Req_dec x 0) as [H | Hne]; [easy |].
      assert (HM := proj2 (proj2 (moment_grows x)) (proj2 (proj2 (signs_at x Hx)) Hne)).
      unfold from_intrados, intrados in H0. nra. }
    split; [| split; [intros -> | exact Hlimit]].
    - apply Rnot_lt_le. intros Hpos. assert (Hs := proj1 (signs_at x Hx) Hpos).
      destruct (Hall (- x) ltac:(lra)) as (_ & HL & _). unfold from_intrados, whole_moment, whole_normal in *.
      rewrite sin_neg, cos_neg in HL. assert (0 < intrados eta * (v * sin x)) by positive. lra.
    - assert (Hl := level_intrados 0 ltac:(lra) H0). unfold face_slope, normal_slope, intrados in Hl.
      rewrite sin_0, cos_0 in Hl. nra.
  Qed.

  Lemma normal_and_shear_of_thrust x : cos x * whole_normal h v x - sin x * whole_shear h v x = h.
  Proof.
    unfold whole_normal, whole_shear. transitivity (h * (sin x * sin x + cos x * cos x)); [ring |].
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

  (** ** Which joints slide outwards *)

  (** A joint and two about it, as far on either side. *)
  Lemma outwards_about x t : against_outwards mu h v (x + t) + against_outwards mu h v (x - t)
    = 2 * cos t * against_outwards mu h v x + 2 * (t * sin t) * (mu * cos x - sin x).
  Proof.
    unfold against_outwards, whole_normal, whole_shear. rewrite sin_plus, sin_minus, cos_plus, cos_minus. ring.
  Qed.

  Lemma inner_slip_is_upright x : - alpha < x < alpha -> against_outwards mu h v x = 0 -> sin x <= mu * cos x.
  Proof.
    intros Hx H0. set (t := Rmin (alpha - x) (alpha + x)). assert (Ht : 0 < t) by (apply Rmin_glb_lt; lra).
    assert (t <= alpha - x) by apply Rmin_l. assert (t <= alpha + x) by apply Rmin_r.
    assert (Hs : 0 < sin t) by positive.
    assert (Habout := outwards_about x t). assert (0 <= against_outwards mu h v (x + t)) by (apply Hall; lra).
    assert (0 <= against_outwards mu h v (x - t)) by (apply Hall; lra). assert (0 < t * sin t) by positive. nra.
  Qed.

  Lemma outward_force x : - alpha <= x <= alpha -> against_outwards mu h v x = 0 ->
    exists n, 0 < n /\ h = n * (cos x + mu * sin x) /\ x - v = n * (sin x - mu * cos x).
  Proof.
    intros Hx H0. exists (whole_normal h v x). assert (HN := normal_positive x Hx).
    assert (Hforce := normal_and_shear_of_thrust x). unfold against_outwards in H0.
    assert (HT : whole_shear h v x = - mu * whole_normal h v x) by lra. split; [easy | split].
    - nra.
    - replace (whole_normal h v x * (sin x - mu * cos x))
        with (sin x * whole_normal h v x + cos x * whole_shear h v x) by (rewrite HT; ring).
      unfold whole_normal, whole_shear. assert (H := sin2_cos2 x). unfold Rsqr in H.
      transitivity ((x - v) * (sin x * sin x + cos x * cos x)); [rewrite H |]; ring.
  Qed.

  Lemma slides_upwards x : - alpha <= x <= alpha -> against_outwards mu h v x = 0 -> x = alpha \/ 0 < cos x.
  Proof.
    intros Hx H0. destruct (Req_dec x alpha) as [E | Hne]; [now left | right]. apply Rnot_le_lt. intros Hc.
    destruct (outward_force x Hx H0) as (n & Hn & Eh & _). assert (Hh := thrust_positive).
    assert (0 < cos x + mu * sin x) by nra. destruct (signs_at x Hx) as (_ & Hneg & _).
    assert (Hup := inner_slip_is_upright x ltac:(nra) H0). nra.
  Qed.

  (** Beside the right springing less than half a turn is between the two. *)
  Lemma slips_are_apart x : - alpha <= x < alpha -> against_outwards mu h v x = 0 ->
    against_outwards mu h v alpha = 0 -> 0 < sin (alpha - x).
  Proof.
    intros Hx H0 H1. destruct (outward_force x ltac:(lra) H0) as (n & Hn & Eh & Ex).
    destruct (outward_force alpha ltac:(lra) H1) as (m & Hm & Eh' & Ea). assert (Hh := thrust_positive).
    assert (E : h * (alpha - v) - h * (x - v) = m * n * (1 + mu * mu) * sin (alpha - x)).
    { rewrite Ex, Ea. rewrite Eh at 1. rewrite Eh' at 1. rewrite sin_minus. ring. }
    assert (0 < m * n * (1 + mu * mu)) by positive. nra.
  Qed.

  (** ** Each face is reached at one joint inside, and one joint slides there *)

  Lemma face_from r x t : face r (x + t) = cos t * face r x + sin t * face_slope r x
    - (1 - cos t) * (p + fac delta eta) + r * (t * sin (x + t) - sin t * sin x).
  Proof. unfold face, face_slope, whole_normal, whole_moment, normal_slope. rewrite sin_plus, cos_plus. ring. Qed.

  (** From either of two joints where a face is touched to the other. *)
  Lemma touched_once r x y : r <> 0 -> sin x + sin y <> 0 -> face r x = 0 -> face_slope r x = 0 -> face r y = 0 ->
    face_slope r y = 0 -> x = y.
  Proof.
    intros Hr Hs Ax Bx Ay By. assert (Hx := face_from r x (y - x)). assert (Hy := face_from r y (- (y - x))).
    replace (x + (y - x)) with y in Hx by ring. replace (y + - (y - x)) with x in Hy by ring.
    rewrite sin_neg, cos_neg, Ax, Ay, By in Hy. rewrite Ax, Bx, Ay in Hx.
    assert (E : r * (sin x + sin y) * ((y - x) - sin (y - x)) = 0) by lra. apply Rmult_integral in E.
    destruct E as [E | E]; [now apply Rmult_integral in E as [E | E] |].
    destruct (Rtotal_order x y) as [H | [H | H]]; [| easy |]; exfalso.
    - assert (sin (y - x) < y - x) by (apply sin_lt_x; lra). lra.
    - assert (sin (x - y) < x - y) by (apply sin_lt_x; lra). rewrite <- (Ropp_minus_distr y x), sin_neg in *. lra.
  Qed.

  Lemma one_hinge_above x y : 0 < x < alpha -> 0 < y < alpha -> from_extrados delta eta h p v x = 0 ->
    from_extrados delta eta h p v y = 0 -> x = y.
  Proof.
    intros Hx Hy H0 H1. assert (0 < sin x) by positive. assert (0 < sin y) by positive.
    exact (touched_once (extrados eta) x y ltac:(unfold extrados; lra) ltac:(lra) H0 (level_extrados x ltac:(lra) H0)
      H1 (level_extrados y ltac:(lra) H1)).
  Qed.

  (** The haunch is not below the horizontal. *)
  Lemma haunch_is_inside x : - alpha <= x <= alpha -> from_intrados delta eta h p v x = 0 -> - (PI / 2) <= x.
  Proof.
    intros Hx H0. apply Rnot_lt_le. intros H.
    destruct (MVT_cor2 (from_intrados delta eta h p v) (intrados_slope delta eta h v) x (- (PI / 2)) H)
      as (c & Hc & Hin).
    { intros c _. apply is_derive_Reals, intrados_has_slope. }
    destruct (Hall (- (PI / 2)) ltac:(lra)) as (_ & HL & _). assert (Hh := thrust_positive).
    assert (Hs : sin c < 0) by (apply sin_lt_0_var; lra).
    assert (Hcos : cos c < 0) by (rewrite <- cos_neg; apply cos_lt_0; lra).
    assert (HI : 0 <= intrados eta < 1) by (unfold intrados; lra).
    assert (Hf : 1 <= fac delta eta) by (unfold fac; nra). assert (0 <= intrados eta * h) by positive.
    assert ((fac delta eta - intrados eta + intrados eta * h) * sin c < 0) by nra.
    assert (0 <= intrados eta * ((c - v) * cos c)) by positive. unfold intrados_slope, normal_slope in Hc. nra.
  Qed.

  Lemma one_haunch x y : - alpha < x < alpha -> - alpha < y < alpha -> from_intrados delta eta h p v x = 0 ->
    from_intrados delta eta h p v y = 0 -> x = y.
  Proof.
    intros Hx Hy H0 H1. destruct (intrados_on_the_left x ltac:(lra) H0) as [Hlx Hcx].
    destruct (intrados_on_the_left y ltac:(lra) H1) as [Hly Hcy].
    destruct (Req_dec eta 2) as [E | E]; [now rewrite (proj2 Hcx E), (proj2 Hcy E) |].
    assert (sin x < 0) by (apply sin_lt_0_var; lra). assert (sin y < 0) by (apply sin_lt_0_var; lra).
    assert (Sx := level_intrados x Hx H0). assert (Sy := level_intrados y Hy H1). unfold from_intrados in *.
    apply (touched_once (intrados eta)); try easy; unfold face, intrados in *; lra.
  Qed.

  Lemma one_inner_slip x y : - alpha < x < alpha -> - alpha < y < alpha -> against_outwards mu h v x = 0 ->
    against_outwards mu h v y = 0 -> x = y.
  Proof.
    assert (Hplace : forall z, - alpha < z < alpha -> against_outwards mu h v z = 0 ->
      z <= v /\ (z - v) * (z - v) = h * (1 - h)).
    { intros z Hz H0. assert (Hup := inner_slip_is_upright z Hz H0).
      assert (Hl := level (against_outwards mu h v) z _ Hz (fun y Hy => proj2 (proj2 (proj2 (Hall y Hy)))) H0
        (outwards_has_slope mu h v z)). destruct (outward_force z ltac:(lra) H0) as (n & Hn & Eh & Ez).
      unfold outwards_slope, normal_slope, shear_slope in Hl. nra. }
    intros Hx Hy H0 H1. destruct (Hplace x Hx H0) as [Hxv Ex], (Hplace y Hy H1) as [Hyv Ey].
    assert (E : (x - y) * ((v - x) + (v - y)) = 0) by lra. destruct (Rmult_integral _ _ E); lra.
  Qed.

  (** ** All joints together *)

  (** What a joint adds along a direction and to the rotation. *)
  Definition along (a b c : R) (j : moving) : R :=
    let '(across, upwards, turn) := row eta (how j) (place j) in rate j * (a * across + b * upwards + c * turn).

  Lemma total_along a b c motion : let '(across, upwards, turn) := total eta motion in
    fold_right (fun j sum => along a b c j + sum) 0 motion = a * across + b * upwards + c * turn.
  Proof.
    induction motion as [| j rest IH]; simpl; [ring |]. unfold along at 1.
    destruct (total eta rest) as [[x y] z], (row eta (how j) (place j)) as [[x' y'] z']. simpl. rewrite IH. ring.
  Qed.

  Lemma part_of_a_sum (f : moving -> R) (motion : list moving) : (forall j, In j motion -> 0 <= f j) ->
    let sum := fold_right (fun j sum => f j + sum) 0 motion in 0 <= sum /\ forall j, In j motion -> f j <= sum.
  Proof.
    induction motion as [| j rest IH]; intros Hpos; [now split; [simpl; lra |] |].
    destruct IH as [H0 Hrest]; [now intros; apply Hpos; right |]. assert (Hj := Hpos j (or_introl eq_refl)). simpl.
    split; [lra |]. intros i [<- | Hi]; [lra |]. specialize (Hrest i Hi). lra.
  Qed.

  Section Motion.
    Variable motion : list moving.
    Hypothesis Hmotion : is_motion delta alpha eta mu h p v motion.

    (** Where a joint that moves is. *)
    Lemma where_it_moves j : In j motion -> rate j <> 0 ->
      0 < rate j /\ - alpha <= place j <= alpha /\ margin_of delta eta mu h p v (how j) (place j) = 0 /\
      match how j with
      | opens_above => 0 < sin (place j)
      | opens_below => place j <= 0 /\ sin (place j) <= 0
      | slips_in => False
      | slips_out => place j = alpha \/ 0 < cos (place j)
      end.
    Proof.
      intros Hj Hne. destruct (proj1 (Forall_forall _ _) (proj1 Hmotion) j Hj) as (Hx & Hr & H0).
      destruct (Rmult_integral _ _ H0) as [H | H]; [easy |]. repeat split; try easy; [lra |].
      destruct (signs_at (place j) Hx) as (Hpos & Hneg & _). destruct j as [[] x r]; simpl in *.
      - now apply Hpos, extrados_on_the_right.
      - destruct (intrados_on_the_left x Hx H) as [[Hleft | ->] _]; [| rewrite sin_0; lra]. lra.
      - now apply (nothing_slides_inwards x).
      - now apply slides_upwards.
    Qed.

    (** Where no joint adds less than nothing none adds anything, *)
    Lemma none_along a b c : (forall j, In j motion -> rate j <> 0 -> 0 <= along a b c j) ->
      forall j, In j motion -> along a b c j = 0.
    Proof.
      intros Hsome j Hj. assert (Hpos : forall i, In i motion -> 0 <= along a b c i).
      { intros i Hi. destruct (Req_dec (rate i) 0) as [E | E]; [| now apply Hsome]. unfold along.
        destruct (row eta (how i) (place i)) as [[x y] z]. nra. }
      assert (Hsum := total_along a b c motion). rewrite (proj2 Hmotion) in Hsum.
      destruct (part_of_a_sum _ _ Hpos) as [_ Hpart]. specialize (Hpart j Hj). specialize (Hpos j Hj). lra.
    Qed.

    (** and where each adds something none moves. *)
    Lemma none_moves a b c : (forall j, In j motion -> rate j <> 0 -> 0 < along a b c j) ->
      forall j, In j motion -> rate j = 0.
    Proof.
      intros Hall' j Hj. apply NNPP. intros Hr. assert (H := Hall' j Hj Hr).
      rewrite (none_along a b c) in H; [lra | | easy]. intros i Hi Hi'. now apply Rlt_le, Hall'.
    Qed.

    Definition moves_at (way : release) (x : R) : Prop :=
      exists j, In j motion /\ rate j <> 0 /\ how j = way /\ place j = x.

    Lemma at_its_limit way x : moves_at way x -> - alpha <= x <= alpha /\ margin_of delta eta mu h p v way x = 0.
    Proof. intros (j & Hj & Hr & <- & <-). now destruct (where_it_moves j Hj Hr) as (_ & Hx & H0 & _). Qed.

    (** Some joint moves downwards: the right springing of a horseshoe. *)
    Lemma springing_slides : (exists j, In j motion /\ rate j <> 0) -> cos alpha < 0 /\ moves_at slips_out alpha.
    Proof.
      intros (some & Hin & Hsome). apply NNPP. intros Hno. assert (0 < sin alpha) by positive.
      assert (0 < extrados eta) by (unfold extrados; lra). assert (0 <= intrados eta < 1) by (unfold intrados; lra).
      assert (Hup : forall j, In j motion -> along 0 1 0 j = 0).
      { apply none_along. intros j Hj Hr. destruct (where_it_moves j Hj Hr) as (Hp & _ & _ & Hx). unfold along.
        destruct j as [[] x r]; simpl in *; [| | easy |]; (apply Rmult_le_pos; [lra |]); [nra | nra |].
        destruct Hx as [-> | Hx]; [| lra]. apply Rnot_lt_le. intros Hc. apply Hno. split; [lra |].
        now exists (joint slips_out alpha r). }
      apply Hsome, (none_moves 1 0 1); [| exact Hin]. intros j Hj Hr.
      destruct (where_it_moves j Hj Hr) as (Hp & _ & _ & Hx). specialize (Hup j Hj). unfold along in *.
      destruct j as [[] x r]; simpl in *; [| | easy |].
      - assert (0 < r * (extrados eta * sin x)) by positive. lra.
      - apply Rmult_lt_0_compat; [easy |]. destruct (COS_bound x). nra.
      - destruct Hx as [-> | Hx]; nra.
    Qed.

    (** It slides, and a motion has the hinges inside too. *)
    Lemma hinges_move : moves_at slips_out alpha -> cos alpha < 0 ->
      (exists b0, b0 < alpha /\ moves_at opens_above b0) /\ exists x, moves_at opens_below x.
    Proof.
      intros Hfoot Hca. destruct (at_its_limit _ _ Hfoot) as [_ Hslides].
      destruct Hfoot as (foot & Hin & Hfr & Hfw & Hfx). assert (Hcircle := sin2_cos2 alpha). unfold Rsqr in Hcircle.
      assert (Hhinge : exists b0, b0 < alpha /\ moves_at opens_above b0).
      { apply NNPP. intros Hno. assert (Hadds : forall j, In j motion -> rate j <> 0 ->
          (how j = slips_out /\ place j = alpha) \/ 0 < along (- cos alpha) (sin alpha) 1 j).
        { intros j Hj Hne. destruct (where_it_moves j Hj Hne) as (Hr & Hx & H0 & _). unfold along.
          destruct j as [[] x r]; simpl in *; [right | right | now destruct (nothing_slides_inwards x) |];
            [| | destruct (Req_dec x alpha) as [E | E]; [now left | right]]; (apply Rmult_lt_0_compat; [easy |]).
          - destruct (Rlt_le_dec x alpha) as [H | H].
            { elim Hno. now exists x; split; [| exists (joint opens_above x r)]. }
            replace x with alpha by lra. unfold extrados. nra.
          - replace (_ + _) with (1 - intrados eta * cos (alpha - x)) by (rewrite cos_minus; ring).
            destruct (COS_bound (alpha - x)). unfold intrados. nra.
          - replace (_ + _) with (sin (alpha - x)) by (rewrite sin_minus; ring). apply slips_are_apart; try easy.
            lra. }
        apply Hfr, (none_moves 0 (-1) 0); [| exact Hin]. intros j Hj Hne. destruct (Hadds j Hj Hne) as [[E E'] | H].
        - destruct (where_it_moves j Hj Hne) as [Hr _]. unfold along. rewrite E, E'. simpl. nra.
        - rewrite none_along in H; [lra | | easy]. intros i Hi Hi'.
          destruct (Hadds i Hi Hi') as [[E E'] | Hi'']; [| lra]. unfold along. rewrite E, E'. simpl. lra. }
      split; [exact Hhinge |]. destruct Hhinge as (b0 & _ & hinge & Hj & Hhr & Hhw & _).
      apply NNPP. intros Hno. assert (E : along 0 0 (-1) hinge = 0).
      { apply none_along; [| easy]. intros j Hi Hne. destruct (where_it_moves j Hi Hne) as (Hr & _). unfold along.
        destruct j as [[] x r]; simpl in *; try lra. elim Hno. now exists x, (joint opens_below x r). }
      unfold along in E. rewrite Hhw in E. simpl in E. lra.
    Qed.

    (** What moves: the right springing slides, the extrados opens inside the right half, the intrados on the left; and
        besides the springing may open above and one joint inside slide. *)
    Theorem joints_of_a_motion : (exists j, In j motion /\ rate j <> 0) -> PI / 2 < alpha /\
      exists b0 b1 b2, 0 < b0 < alpha /\ (0 <= b1 <= PI / 2 /\ (b1 = 0 <-> eta = 2)) /\ moves_at slips_out alpha /\
      moves_at opens_above b0 /\ moves_at opens_below (- b1) /\ forall way x, moves_at way x ->
      In (way, x) [(slips_out, alpha); (opens_above, alpha); (opens_above, b0); (opens_below, - b1); (slips_out, b2)].
    Proof.
      intros Hsome. destruct (springing_slides Hsome) as [Hca Hfoot]. assert (Hwide : PI / 2 < alpha).
      { apply Rnot_le_lt. intros H. assert (0 <= cos alpha) by positive. lra. }
      destruct (hinges_move Hfoot Hca) as [(b0 & Hb0 & Habove) (x1 & Hbelow)].
      assert (Hinside : forall x, moves_at opens_below x -> - alpha < x <= 0 /\ - (PI / 2) <= x /\
        from_intrados delta eta h p v x = 0).
      { intros x Hx. destruct (at_its_limit _ _ Hx) as [Hin H0]. simpl in H0.
        assert (- (PI / 2) <= x) by (now apply haunch_is_inside). destruct (intrados_on_the_left x Hin H0). lra. }
      assert (Hslips : forall x, moves_at slips_out x -> x <> alpha ->
        - alpha < x < alpha /\ against_outwards mu h v x = 0).
      { intros x Hx Hne. destruct (at_its_limit _ _ Hx) as [Hin H0].
        destruct (slides_upwards x Hin H0) as [E | Hc]; [easy |]. split; [| easy]. split; [| lra]. apply Rnot_le_lt.
        intros H. replace x with (- alpha) in Hc by lra. rewrite cos_neg in Hc. lra. }
      assert (Hslip : exists b2, forall x, moves_at slips_out x -> x <> alpha -> x = b2).
      { destruct (classic (exists x, moves_at slips_out x /\ x <> alpha)) as [(b2 & Hb2 & Hne) | Hno].
        - exists b2. intros x Hx E. now apply one_inner_slip; apply Hslips.
        - exists 0. intros x Hx E. elim Hno. now exists x. }
      destruct Hslip as [b2 Hslip]. destruct (at_its_limit _ _ Habove) as [Hin0 H0].
      assert (Hpos := extrados_on_the_right b0 Hin0 H0). destruct (Hinside x1 Hbelow) as (Hin1 & Hx1 & H1).
      destruct (intrados_on_the_left x1 ltac:(lra) H1) as [_ Hcrown]. split; [easy |]. exists b0, (- x1), b2.
      rewrite Ropp_involutive. split; [lra | split].
      { lra. }
      repeat split; try easy. intros way x Hx. destruct (at_its_limit _ _ Hx) as [Hin Hz]. simpl.
      destruct way; simpl in Hz; [| | now destruct (nothing_slides_inwards x Hin) |].
      - destruct (Req_dec x alpha) as [-> | E]; [tauto |]. assert (Hx0 := extrados_on_the_right x Hin Hz).
        rewrite (one_hinge_above b0 x) by (easy || lra). tauto.
      - destruct (Hinside x Hx) as (Hx' & _). rewrite (one_haunch x1 x) by (easy || lra). tauto.
      - destruct (Req_dec x alpha) as [-> | E]; [tauto |]. rewrite (Hslip x) by easy. tauto.
    Qed.
  End Motion.
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
    { induction l as [| [way x r] l IH]; [simpl; repeat f_equal; ring |]. unfold total in *. simpl. rewrite IH.
      destruct (fold_right _ _ l) as [[a b] c]. destruct way; simpl; unfold slips_outwards, scaled;
        simpl; rewrite ?sin_neg, ?cos_neg; repeat apply f_equal2; ring. }
    rewrite H, Htotal. simpl. repeat f_equal. ring.
Qed.

Theorem no_asymmetric_motion_up_to_the_right_angle (delta alpha eta mu h p v : R) (motion : list moving) :
  0 <= delta -> 0 < alpha <= PI / 2 -> 0 < eta <= 2 -> 0 <= mu -> whole_admissible delta alpha eta mu h p v ->
  v <> 0 -> is_motion delta alpha eta mu h p v motion -> Forall (fun j => rate j = 0) motion.
Proof.
  intros Hd Ha He Hm Hall Hv Hmotion. assert (Hca : 0 <= cos alpha) by positive.
  apply Forall_forall. intros j Hj. apply NNPP. intros Hne. destruct (Rlt_le_dec 0 v) as [Hpos | Hneg].
  - assert (H := springing_slides delta alpha eta mu h p v Hd ltac:(lra) He Hm Hpos Hall motion Hmotion).
    destruct H as [H _]; [now exists j | lra].
  - assert (H := springing_slides delta alpha eta mu h p (- v) Hd ltac:(lra) He Hm ltac:(lra)
      (mirrored_state _ _ _ _ _ _ _ Hall) _ (mirrored_motion _ _ _ _ _ _ _ _ Hmotion)).
    destruct H as [H _]; [| lra]. exists (mirrored j). now split; [apply in_map |].
Qed.
