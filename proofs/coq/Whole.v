(** * The whole arch: asymmetric solutions of the complementarity problem (19)

    Without symmetry the crown bears a vertical force [v] beside the thrust [h] and the moment [p] about the centre: it
    carries [v] of the weight of the right half.  Joints [x] are angles from the crown, positive to the right.  The line of
    thrust is inside the faces, and no joint slides, where four margins are not negative.  Here are the margins with their
    slopes along the arch, what makes one nowhere negative next to a joint where it is zero, and the motion.
    The verified checker adds the numbers. *)

From Couplet Require Export Moments.

(** ** What is claimed *)

(** Forces on a joint, with [x - v] for the weight above it, and the moment of what is above it. *)
Definition whole_normal (h v x : R) : R := h * cos x + (x - v) * sin x.
Definition whole_shear (h v x : R) : R := (x - v) * cos x - h * sin x.
Definition whole_moment (delta eta p x : R) : R := p + fac delta eta * (1 - cos x).

(** The margins: how far the line of thrust is from the extrados and from the intrados, times the normal force, and how much
    friction has to spare against sliding inwards and outwards, as seen on the right. *)
Definition from_extrados (delta eta h p v x : R) : R :=
  extrados eta * whole_normal h v x - whole_moment delta eta p x.
Definition from_intrados (delta eta h p v x : R) : R :=
  whole_moment delta eta p x - intrados eta * whole_normal h v x.
Definition against_inwards (mu h v x : R) : R := mu * whole_normal h v x - whole_shear h v x.
Definition against_outwards (mu h v x : R) : R := mu * whole_normal h v x + whole_shear h v x.

(** Admissible at every joint. *)
Definition whole_admissible (delta alpha eta mu h p v : R) : Prop :=
  forall x, - alpha <= x <= alpha ->
    0 <= from_extrados delta eta h p v x /\ 0 <= from_intrados delta eta h p v x /\
    0 <= against_inwards mu h v x /\ 0 <= against_outwards mu h v x.

(** The relative velocity, to the right and upwards, and the rotation that a joint adds at the rate one: a hinge at the
    extrados or the intrados turns about its face, a slip is along the joint and does not open it. *)
Definition turns_above (eta x : R) : R * R * R := (- extrados eta * cos x, extrados eta * sin x, -1).
Definition turns_below (eta x : R) : R * R * R := (intrados eta * cos x, - intrados eta * sin x, 1).
Definition slips_outwards (x : R) : R * R * R := (sin x, cos x, 0).

Definition scaled (rate : R) (row : R * R * R) : R * R * R := let '(a, b, c) := row in (rate * a, rate * b, rate * c).
Definition plus (x y : R * R * R) : R * R * R :=
  let '(a, b, c) := x in let '(a', b', c') := y in (a + a', b + b', c + c').

(** The right shoulder slides outwards by [s], the hinge right of the crown and that at the left haunch turn by one, and a
    joint of the left half slides inwards, which is outwards as seen on the right, by [u]: together they fit, that is the
    springings do not move. *)
Definition fits (alpha eta b0 b1 b2 s u : R) : Prop :=
  plus (plus (scaled s (slips_outwards alpha)) (turns_above eta b0))
       (plus (scaled u (slips_outwards (- b2))) (turns_below eta (- b1))) = (0, 0, 0).

(** An asymmetric solution of (19): admissible, each joint that moves is at its limit and moves its way, and the motion fits. *)
Definition asymmetric_solution (delta alpha mu eta h p v b0 b1 b2 s u : R) : Prop :=
  whole_admissible delta alpha eta mu h p v /\
  against_outwards mu h v alpha = 0 /\ from_extrados delta eta h p v b0 = 0 /\
  against_outwards mu h v (- b2) = 0 /\ from_intrados delta eta h p v (- b1) = 0 /\
  (- alpha < - b1 < - b2 /\ - b2 < b0 < alpha) /\ 0 < v /\
  0 < s /\ 0 < u /\ fits alpha eta b0 b1 b2 s u.

(** Where no inner joint slides, the right shoulder may open about its extrados by [w] besides, and the left haunch turns by
    as much more. *)
Definition fits_at_shoulder (alpha eta b0 b1 s w : R) : Prop :=
  plus (plus (scaled s (slips_outwards alpha)) (scaled w (turns_above eta alpha)))
       (plus (turns_above eta b0) (scaled (1 + w) (turns_below eta (- b1)))) = (0, 0, 0).

Definition shoulder_solution (delta alpha mu eta h p v b0 b1 s w : R) : Prop :=
  whole_admissible delta alpha eta mu h p v /\
  against_outwards mu h v alpha = 0 /\ from_extrados delta eta h p v b0 = 0 /\
  from_intrados delta eta h p v (- b1) = 0 /\ w * from_extrados delta eta h p v alpha = 0 /\
  (- alpha < - b1 < b0 /\ b0 < alpha) /\ 0 < v /\ 0 < s /\ 0 <= w /\ fits_at_shoulder alpha eta b0 b1 s w.

(** ** Slopes *)

Definition normal_slope (h v x : R) : R := (1 - h) * sin x + (x - v) * cos x.
Definition shear_slope (h v x : R) : R := (1 - h) * cos x - (x - v) * sin x.

Definition extrados_slope (delta eta h v x : R) : R := extrados eta * normal_slope h v x - fac delta eta * sin x.
Definition intrados_slope (delta eta h v x : R) : R := fac delta eta * sin x - intrados eta * normal_slope h v x.
Definition inwards_slope (mu h v x : R) : R := mu * normal_slope h v x - shear_slope h v x.
Definition outwards_slope (mu h v x : R) : R := mu * normal_slope h v x + shear_slope h v x.

Ltac whole := unfold from_extrados, from_intrados, against_inwards, against_outwards, extrados_slope, intrados_slope,
  inwards_slope, outwards_slope, whole_moment, whole_normal, whole_shear, normal_slope, shear_slope, extrados, intrados, fac in *.
Ltac derive := whole; auto_derive; [easy | field].

Lemma extrados_has_slope delta eta h p v x :
  is_derive (from_extrados delta eta h p v) x (extrados_slope delta eta h v x).
Proof. derive. Qed.
Lemma intrados_has_slope delta eta h p v x :
  is_derive (from_intrados delta eta h p v) x (intrados_slope delta eta h v x).
Proof. derive. Qed.
Lemma inwards_has_slope mu h v x : is_derive (against_inwards mu h v) x (inwards_slope mu h v x).
Proof. derive. Qed.
Lemma outwards_has_slope mu h v x : is_derive (against_outwards mu h v) x (outwards_slope mu h v x).
Proof. derive. Qed.

(** ** Next to a joint where a margin is zero *)

(** It falls to zero. *)
Lemma falling (f f' : R -> R) a b : (forall x, is_derive f x (f' x)) ->
  f b = 0 -> (forall x, a <= x <= b -> f' x <= 0) -> forall x, a <= x <= b -> 0 <= f x.
Proof.
  intros Hf Hb Hfall x Hx. destruct (Req_dec x b) as [-> | Hne]; [lra |].
  destruct (MVT_cor2 f f' x b ltac:(lra)) as (c & Hc & Hin).
  { intros c _. apply is_derive_Reals, Hf. }
  assert (f' c <= 0) by (apply Hfall; lra). assert (f' c * (b - x) <= 0) by nra. lra.
Qed.

(** It rises from zero. *)
Lemma rising (f f' : R -> R) a b : (forall x, is_derive f x (f' x)) ->
  f a = 0 -> (forall x, a <= x <= b -> 0 <= f' x) -> forall x, a <= x <= b -> 0 <= f x.
Proof.
  intros Hf Ha Hrise x Hx. destruct (Req_dec x a) as [-> | Hne]; [lra |].
  destruct (MVT_cor2 f f' a x ltac:(lra)) as (c & Hc & Hin).
  { intros c _. apply is_derive_Reals, Hf. }
  assert (0 <= f' c) by (apply Hrise; lra). assert (0 <= f' c * (x - a)) by nra. lra.
Qed.

(** It touches zero, where it bends away. *)
Lemma touching (f f' f'' : R -> R) a b c : (forall x, is_derive f x (f' x)) -> (forall x, is_derive f' x (f'' x)) ->
  f c = 0 -> f' c = 0 -> (forall x, a <= x <= b -> 0 <= f'' x) -> a <= c <= b -> forall x, a <= x <= b -> 0 <= f x.
Proof.
  intros Hf Hf' H0 H1 Hbend Hc x Hx. destruct (Rle_dec x c) as [Hxc | Hxc].
  - apply (falling f f' a c Hf H0); [| lra]. intros y Hy. assert (H : 0 <= - f' y).
    { apply (falling (fun t => - f' t) (fun t => - f'' t) a c); [| lra | | exact Hy].
      - intros t. evar_last; [apply @is_derive_opp, Hf' | reflexivity].
      - intros t Ht. specialize (Hbend t ltac:(lra)). lra. }
    lra.
  - apply (rising f f' c b Hf H0); [| lra]. intros y Hy. apply (rising f' f'' c b Hf' H1); [| exact Hy]. intros t Ht.
    apply Hbend. lra.
Qed.

(** ** The rates *)

(** Two velocities have to fit, as the rotations do. *)
Definition determinant (alpha b2 : R) : R := sin alpha * cos b2 + cos alpha * sin b2.
Definition across (eta b0 b1 : R) : R := extrados eta * cos b0 - intrados eta * cos b1.
Definition upwards (eta b0 b1 : R) : R := - (extrados eta * sin b0) - intrados eta * sin b1.
Definition shoulder_slip (alpha eta b0 b1 b2 : R) : R :=
  (across eta b0 b1 * cos b2 + upwards eta b0 b1 * sin b2) / determinant alpha b2.
Definition inner_slip (alpha eta b0 b1 b2 : R) : R :=
  (sin alpha * upwards eta b0 b1 - cos alpha * across eta b0 b1) / determinant alpha b2.

Theorem rates_fit alpha eta b0 b1 b2 : determinant alpha b2 <> 0 ->
  fits alpha eta b0 b1 b2 (shoulder_slip alpha eta b0 b1 b2) (inner_slip alpha eta b0 b1 b2).
Proof.
  intros Hd.
  unfold fits, plus, scaled, slips_outwards, turns_above, turns_below, shoulder_slip, inner_slip, across, upwards.
  rewrite !sin_neg, !cos_neg. unfold determinant in *.
  repeat (apply f_equal2; [| try (field; exact Hd)]); try (field; exact Hd); try ring.
Qed.

(** The shoulder's opening does so too, *)
Definition shoulder_determinant (alpha eta b1 : R) : R :=
  sin alpha * (extrados eta * sin alpha + intrados eta * sin b1)
  + cos alpha * (extrados eta * cos alpha - intrados eta * cos b1).
Definition slip_of_opening (alpha eta b0 b1 : R) : R :=
  (across eta b0 b1 * (extrados eta * sin alpha + intrados eta * sin b1)
   + upwards eta b0 b1 * (extrados eta * cos alpha - intrados eta * cos b1)) / shoulder_determinant alpha eta b1.
Definition shoulder_opening (alpha eta b0 b1 : R) : R :=
  (sin alpha * upwards eta b0 b1 - cos alpha * across eta b0 b1) / shoulder_determinant alpha eta b1.

Theorem opening_fits alpha eta b0 b1 : shoulder_determinant alpha eta b1 <> 0 ->
  fits_at_shoulder alpha eta b0 b1 (slip_of_opening alpha eta b0 b1) (shoulder_opening alpha eta b0 b1).
Proof.
  intros Hd. unfold fits_at_shoulder, plus, scaled, slips_outwards, turns_above, turns_below, slip_of_opening,
    shoulder_opening, across, upwards. rewrite !sin_neg, !cos_neg. unfold shoulder_determinant in *.
  repeat (apply f_equal2; [| try (field; exact Hd)]); try (field; exact Hd); try ring.
Qed.

(** and the slip alone where the hinges and the shoulder are in one motion. *)
Theorem slip_alone_fits alpha eta b0 b1 : sin alpha <> 0 ->
  intrados eta * (cos b1 * cos alpha - sin b1 * sin alpha)
    = extrados eta * (cos b0 * cos alpha + sin b0 * sin alpha) ->
  fits_at_shoulder alpha eta b0 b1 (across eta b0 b1 / sin alpha) 0.
Proof.
  intros Hs Hfit. unfold fits_at_shoulder, plus, scaled, slips_outwards, turns_above, turns_below, across.
  rewrite !sin_neg, !cos_neg. apply f_equal2; [apply f_equal2 |]; [field; easy | | ring].
  apply (Rmult_eq_reg_r (sin alpha)); [| easy]. field_simplify; [| easy]. lra.
Qed.
