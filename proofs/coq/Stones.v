(** * Arches of stones: each joint is judged by itself

    Finitely many joints, those of the crown and of the shoulder among them. Of the thrusts that friction leaves the one
    next to that of (4) is the best for the intrados of every joint. *)

From Coq Require Import List.
From Couplet Require Import Moments Contact FrictionModes Mechanisms Surveys.

Section Stones.

Variables (delta alpha mu : R) (joints : list R).
Hypotheses (weight : 0 <= delta <= 1) (opening : 0 < alpha < PI) (within : forall x, In x joints -> 0 <= x <= alpha)
  (crown : In 0 joints) (shoulder : In alpha joints).

(** Friction is enough at all joints. *)
Definition is_held (h : R) : Prop := forall x, In x joints -> friction_holds x mu h.
Definition stones_stand (eta : R) : Prop :=
  exists h p, is_held h /\ forall x, In x joints -> joint_stands delta x eta h p.
(** A joint alone between crown and shoulder, with the friction of all. *)
Definition joint_alone (x eta : R) : Prop :=
  exists h p, is_held h /\ forall y, In y (0 :: x :: alpha :: nil) -> joint_stands delta y eta h p.

Lemma held_between h k m : is_held h -> is_held k -> h <= m <= k -> is_held m.
Proof.
  intros Hh Hk Hm x Hx. assert (A := Hh x Hx). assert (B := Hk x Hx).
  unfold friction_holds, normal_force, shear_force in *. rewrite Rabs_le_between in *.
  destruct (Req_dec h k) as [<- | Hne]; [replace m with h by lra; exact A |]. nra.
Qed.

Section Thickness.

Variable eta : R.
Hypothesis thick : 0 < eta <= 2.

(** The largest moment at the crown that the extrados allows, and the room that it leaves to the intrados. *)
Definition lead (h : R) : R := extrados eta * (normal_force alpha h - h) - fac delta eta * (1 - cos alpha).
Definition largest_moment (h : R) : R := extrados eta * h + Rmin 0 (lead h).
Definition room_at (x h : R) : R := haunch_gap delta x eta h (largest_moment h).

Lemma room_of_joint x h p : (forall y, In y (0 :: x :: alpha :: nil) -> joint_stands delta y eta h p) ->
  0 <= h /\ 0 <= room_at x h.
Proof.
  intros H. destruct (H 0 ltac:(simpl; auto)) as (N & _ & U0). destruct (H x ltac:(simpl; auto)) as (_ & L & _).
  destruct (H alpha ltac:(simpl; auto)) as (_ & _ & U). unfold normal_force in N, U0. rewrite cos_0, sin_0 in N, U0.
  enough (p <= largest_moment h) by (unfold room_at, haunch_gap; lra). unfold largest_moment, lead.
  apply Rmin_case; lra.
Qed.

Lemma joint_of_room x h : 0 <= x <= alpha -> 0 <= h -> 0 <= room_at x h ->
  joint_stands delta x eta h (largest_moment h).
Proof.
  intros Hx Hh Hroom. assert (m0 := Rmin_l 0 (lead h)). assert (m1 := Rmin_r 0 (lead h)).
  assert (U : largest_moment h + fac delta eta * (1 - cos x) <= extrados eta * normal_force x h).
  { apply (extrados_safe delta alpha); try easy; unfold largest_moment, lead, extrados in *; lra. }
  unfold room_at, haunch_gap in Hroom. refine (conj _ (conj _ U)); [| lra]. unfold extrados, intrados in *. nra.
Qed.

(** Up to the thrust of (4) the room grows with the thrust, and from there on it falls or is no question. *)
Lemma room_grows x h k : h <= k -> 0 <= lead k -> 0 <= room_at x h -> 0 <= room_at x k.
Proof.
  intros Hhk Hk. unfold room_at, largest_moment. rewrite (Rmin_left 0 (lead k)) by exact Hk.
  assert (m := Rmin_l 0 (lead h)). unfold haunch_gap, normal_force, extrados, intrados in *. destruct (COS_bound x).
  assert (0 <= ((1 + eta / 2) - (1 - eta / 2) * cos x) * (k - h)) by positive. lra.
Qed.

Lemma room_falls x h k : 0 <= x <= alpha -> 0 <= h <= k -> lead h <= 0 -> 0 <= room_at x k -> 0 <= room_at x h.
Proof.
  intros Hx Hhk Hh. unfold room_at, largest_moment. rewrite (Rmin_right 0 (lead h)) by exact Hh.
  assert (m := Rmin_r 0 (lead k)).
  destruct (Rle_dec (intrados eta * cos x - extrados eta * cos alpha) 0) as [Hno | Harm].
  - set (p := extrados eta * h + lead h).
    assert (H := room_without_lever delta alpha x eta h p weight Hx opening thick ltac:(lra) Hno).
    assert (Z : shoulder_gap delta alpha eta h p = 0) by (unfold shoulder_gap, p, lead; ring). lra.
  - unfold haunch_gap, lead, normal_force, extrados, intrados in *. nra.
Qed.

(** Of two thrusts one, or that of (4) between them, leaves room wherever one of them does. *)
Lemma nearest_thrust h k : 0 <= h <= k -> exists m, h <= m <= k /\
  forall x, 0 <= x <= alpha -> 0 <= room_at x h \/ 0 <= room_at x k -> 0 <= room_at x m.
Proof.
  intros Hhk. destruct (Rle_dec 0 (lead k)) as [Hk | Hk].
  { exists k. split; [lra |]. intros x _ [H | H]; [apply (room_grows x h); easy || lra | exact H]. }
  destruct (Rle_dec (lead h) 0) as [Hh | Hh].
  { exists h. split; [lra |]. intros x Hx [H | H]; [exact H | apply (room_falls x h k); easy || lra]. }
  assert (V : 0 < extrados eta * (1 - cos alpha)) by positive.
  set (m := h + lead h / (extrados eta * (1 - cos alpha))).
  assert (E : forall t, lead t = (m - t) * (extrados eta * (1 - cos alpha)))
    by (intros t; unfold m, lead, normal_force; field; unfold extrados in *; split; nra).
  assert (h <= m) by (rewrite E in Hh; nra). assert (m <= k) by (rewrite E in Hk; nra).
  assert (Z : lead m = 0) by (rewrite E; ring). exists m. split; [lra |].
  intros x Hx [H' | H']; [apply (room_grows x h) | apply (room_falls x m k)]; easy || lra.
Qed.

Lemma one_thrust l : (forall x, In x l -> 0 <= x <= alpha /\ joint_alone x eta) -> l <> nil ->
  exists h, is_held h /\ 0 <= h /\ forall x, In x l -> 0 <= room_at x h.
Proof.
  induction l as [| x [| y l] IH]; [easy | |]; intros Hall _.
  - destruct (Hall x ltac:(now left)) as (_ & h & p & Hheld & H). exists h. apply room_of_joint in H.
    split; [easy | split; [easy |]]. now intros ? [<- | []].
  - destruct IH as (h & Hheld & Hh & Hroom); [intros z Hz; apply Hall; now right | easy |].
    destruct (Hall x ltac:(now left)) as (_ & k & p & Hheld' & H). apply room_of_joint in H as [Hk Hx].
    assert (best : exists m, is_held m /\ 0 <= m /\
              forall x, 0 <= x <= alpha -> 0 <= room_at x h \/ 0 <= room_at x k -> 0 <= room_at x m).
    { destruct (Rle_dec h k); [destruct (nearest_thrust h k) as (m & Hm & H) | destruct (nearest_thrust k h) as (m & Hm & H)];
        try lra; exists m; (split; [| split; [lra |]]).
      - now apply (held_between h k).
      - exact H.
      - now apply (held_between k h).
      - intros z Hz [A | A]; apply H; tauto. }
    destruct best as (m & Hheld'' & Hm & Hbest). exists m. split; [easy | split; [easy |]]. intros z Hz.
    apply Hbest; [now apply Hall |]. destruct Hz as [<- | Hz]; [now right | left; now apply Hroom].
Qed.

Theorem each_joint_by_itself : stones_stand eta <-> forall x, In x joints -> joint_alone x eta.
Proof.
  split.
  - intros (h & p & Hheld & H) x Hx. exists h, p. split; [easy |]. intros y [<- | [<- | [<- | []]]]; now apply H.
  - intros H. destruct (one_thrust joints) as (h & Hheld & Hh & Hroom).
    + split; [now apply within | now apply H].
    + intros E. now rewrite E in crown.
    + exists h, (largest_moment h). split; [easy |]. intros x Hx.
      apply joint_of_room; [now apply within | exact Hh | now apply Hroom].
Qed.

End Thickness.

(** A joint that stands alone does in a thicker arch: so the least thickness is the largest of those of the joints. *)
Theorem least_thickness_of_stones (least : R -> R) :
  (forall x eta, In x joints -> 0 < eta <= 2 -> (joint_alone x eta <-> least x <= eta)) ->
  forall eta, 0 < eta <= 2 -> (stones_stand eta <-> forall x, In x joints -> least x <= eta).
Proof. intros H eta He. rewrite each_joint_by_itself by exact He. split; intros Hall x Hx; apply H; auto. Qed.

Theorem joint_alone_in_thicker x eta eta' : 0 < eta <= eta' -> eta' <= 2 -> joint_alone x eta -> joint_alone x eta'.
Proof.
  intros He He' (h & p & Hheld & H). exists h, p. split; [easy |]. intros y Hy.
  apply (joint_stands_if_thicker delta y eta); try easy; [| now apply H].
  destruct (H 0 ltac:(simpl; auto)) as (N & L & _). unfold normal_force, intrados in *. rewrite cos_0, sin_0 in *.
  nra.
Qed.

End Stones.
