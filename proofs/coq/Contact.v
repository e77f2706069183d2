(** * The state on the whole half arch, and no thinner arch

    The printed equations fix the line of thrust at three joints. A purely rotational state (2), (4), (5) is admissible
    at **every** joint; **no thinner arch stands**, for any thrust and any place of it in the crown, without asking
    anything of friction; **every thicker arch stands**, up to the physical limit, with the same thrust. So the
    thickness of the state is the least one, and **each half-angle has at most one rotational state**. All of it rests
    on the statics only, for any weight [0 <= delta <= 1].

    [p = h (1 + e0)] is the moment of the crown's thrust about the centre; for given [eta] the conditions are linear in
    [(h, p)]. *)

From Couplet Require Import Moments Cubics Sliding Joining.

(** A joint stands if it is in compression (or free of force) and its pressure point lies between
    intrados and extrados; multiplied by the normal force. *)
Definition joint_stands (delta beta eta h p : R) : Prop :=
  0 <= normal_force beta h /\
  intrados eta * normal_force beta h <= p + fac delta eta * (1 - cos beta) <=
  extrados eta * normal_force beta h.

(** Where there is compression this is what it says. *)
Theorem joint_stands_iff_thrust_inside (delta beta eta h crown : R) : 0 < normal_force beta h ->
  joint_stands delta beta eta h (h * crown) <-> intrados eta <= pressure_point delta beta eta h crown <= extrados eta.
Proof.
  intros HN. unfold joint_stands, pressure_point. set (N := normal_force beta h) in *. set (M := h * crown + _).
  assert (E : M = M / N * N) by (field; lra). split; intros H; [split|repeat split]; nra.
Qed.

(** ** [beta cot beta] falls *)

Lemma times_cosine_below_sine (x : R) : 0 < x < PI -> x * cos x < sin x.
Proof.
  intros Hx. destruct (MVT_cor2 (fun t => sin t - t * cos t) (fun t => t * sin t) 0 x) as (c & Hc & Hin); [lra | |].
  - intros c Hc. auto_derive; [easy | ring].
  - rewrite sin_0, Rmult_0_l in Hc. assert (0 < sin c) by positive. assert (0 < c * sin c * (x - 0)) by positive. lra.
Qed.

Lemma times_cotangent_below_one (x : R) : 0 < x < PI -> x * cot x < 1.
Proof.
  intros Hx. assert (HS : 0 < sin x) by positive. assert (H := times_cosine_below_sine x Hx).
  apply (Rmult_lt_reg_r (sin x)); [easy|]. unfold cot. field_simplify; lra.
Qed.

Theorem times_cotangent_falls (a b : R) : 0 < a -> a < b -> b < PI -> b * cot b < a * cot a.
Proof.
  intros Ha Hab Hb.
  destruct (MVT_cor2 (fun x => x * cot x) (fun x => (sin x * cos x - x) / sin x ^ 2) a b Hab) as (c & Hc & Hin).
  { intros c Hc. assert (HS : sin c <> 0) by positive. unfold cot. auto_derive; [exact HS|].
    transitivity ((sin c * cos c - c * (sin c ^ 2 + cos c ^ 2)) / sin c ^ 2); [|rewrite circle]; field; exact HS. }
  assert (0 < sin c) by positive. assert (sin c < c) by (apply sin_lt_x; lra).
  destruct (COS_bound c). assert (0 < (c - sin c * cos c) / sin c ^ 2) by positive. nra.
Qed.

Lemma times_cotangent_injective (a b : R) : 0 < a < PI -> 0 < b < PI -> a * cot a = b * cot b -> a = b.
Proof.
  intros Ha Hb E.
  destruct (Rtotal_order a b) as [H | [H | H]]; [exfalso | easy | exfalso]; apply times_cotangent_falls in H; lra.
Qed.

(** ** The shape of the margins

    The margins at extrados and intrados are, up to constants, [margin] and minus [margin] with these as [a] and
    [m = fac].  It first rises and then falls. *)

Section Shape.

Variables (a m h : R).
Hypothesis a_not_negative : 0 <= a.

Definition margin (x : R) : R := a * normal_force x h + m * cos x.
Definition direction (x : R) : R := a * (1 - h + x * cot x) - m.

(** The mean value theorem, also from the crown, where the derivative needs no quotient. *)
Lemma margin_increment (x y : R) : 0 <= x -> x < y -> y < PI ->
  exists c, x < c < y /\ margin y - margin x = sin c * direction c * (y - x).
Proof.
  intros Hx Hxy Hy. set (slope := fun t => a * (sin t * (1 - h) + t * cos t) - m * sin t).
  destruct (MVT_cor2 margin slope x y Hxy) as (c & Hc & Hin).
  { intros c Hc. unfold margin, normal_force, slope. auto_derive; [easy | ring]. }
  exists c. split; [easy|]. rewrite Hc. unfold slope, direction, cot. field. positive.
Qed.

Lemma margin_rises (x y : R) : 0 <= x -> x < y -> y < PI -> 0 <= direction y ->
  margin x <= margin y /\ (0 < a -> margin x < margin y).
Proof.
  intros Hx Hxy Hy Hdir. destruct (margin_increment x y Hx Hxy Hy) as (c & Hin & Hc).
  assert (0 < sin c * (y - x)) by positive. assert (y * cot y < c * cot c) by (apply times_cotangent_falls; lra).
  split; [assert (0 <= direction c) by (unfold direction in *; nra); nra |]. intros Ha.
  assert (0 < direction c) by (unfold direction in *; nra). nra.
Qed.

Lemma margin_falls (x y : R) : 0 < x -> x < y -> y < PI -> direction x <= 0 ->
  margin y <= margin x /\ (0 < a -> margin y < margin x).
Proof.
  intros Hx Hxy Hy Hdir. destruct (margin_increment x y (Rlt_le _ _ Hx) Hxy Hy) as (c & Hin & Hc).
  assert (0 < sin c * (y - x)) by positive. assert (c * cot c < x * cot x) by (apply times_cotangent_falls; lra).
  split; [assert (direction c <= 0) by (unfold direction in *; nra); nra |]. intros Ha.
  assert (direction c < 0) by (unfold direction in *; nra). nra.
Qed.

(** From the crown on, if it falls next to it. *)
Lemma margin_falls_from_crown (x : R) : a * (2 - h) <= m -> 0 <= x < PI -> margin x <= margin 0.
Proof.
  intros Haway Hx. destruct (Req_dec x 0) as [-> | Hne]; [lra|].
  destruct (margin_increment 0 x) as (c & Hin & Hc); try lra. assert (0 < sin c) by positive.
  assert (Hk := times_cotangent_below_one c ltac:(lra)). assert (direction c <= 0) by (unfold direction; nra).
  assert (sin c * direction c <= 0) by nra. nra.
Qed.

(** So it is least at crown or shoulder, *)
Lemma margin_least_at_the_ends (alpha x : R) : alpha < PI -> 0 <= x <= alpha ->
  Rmin (margin 0) (margin alpha) <= margin x.
Proof.
  intros Ha Hx. destruct (Req_dec x 0) as [-> | H0]; [apply Rmin_l|].
  destruct (Req_dec x alpha) as [-> | Hne]; [apply Rmin_r|]. destruct (Rle_lt_dec 0 (direction x)) as [Hdir | Hdir].
  - apply Rle_trans with (margin 0); [apply Rmin_l | apply margin_rises; lra].
  - apply Rle_trans with (margin alpha); [apply Rmin_r | apply margin_falls; lra].
Qed.

(** and largest where it is stationary. *)
Lemma margin_largest_where_stationary (x y : R) : 0 < x < PI -> 0 <= y < PI -> direction x = 0 ->
  margin y <= margin x.
Proof.
  intros Hx Hy Hdir. destruct (Rtotal_order y x) as [H | [-> | H]];
    [apply margin_rises; lra | lra | apply margin_falls; lra].
Qed.

End Shape.

(** ** Admissible everywhere *)

(** The extrados is safe as soon as it is at crown and shoulder. *)
Theorem extrados_safe (delta alpha eta h p : R) : 0 <= extrados eta -> 0 < alpha < PI -> p <= extrados eta * h ->
  p + fac delta eta * (1 - cos alpha) <= extrados eta * normal_force alpha h -> forall x, 0 <= x <= alpha ->
  p + fac delta eta * (1 - cos x) <= extrados eta * normal_force x h.
Proof.
  intros He Ha Hcrown Hshoulder x Hx.
  assert (H := margin_least_at_the_ends (extrados eta) (fac delta eta) h He alpha x ltac:(lra) Hx).
  assert (Hends : p + fac delta eta <= Rmin (margin (extrados eta) (fac delta eta) h 0)
    (margin (extrados eta) (fac delta eta) h alpha)).
  { apply Rmin_glb; unfold margin, normal_force in *; rewrite ?cos_0, ?sin_0; lra. }
  unfold margin in *. lra.
Qed.

(** The intrados is safe as soon as the line of thrust touches it from outside at one joint: at the
    intrados and with (5). *)
Theorem intrados_safe (delta beta eta h p : R) : 0 < beta < PI -> 0 < eta < 2 ->
  intrados eta * normal_force beta h <= p + fac delta eta * (1 - cos beta) -> h = h_tangency delta beta eta ->
  forall x, 0 <= x < PI -> intrados eta * normal_force x h <= p + fac delta eta * (1 - cos x).
Proof.
  intros Hb He Htouch H5 x Hx. assert (Hi : 0 <= intrados eta) by (unfold intrados; lra).
  assert (Hstationary : direction (intrados eta) (fac delta eta) h beta = 0).
  { unfold direction, intrados. rewrite H5. unfold h_tangency. field. lra. }
  assert (H := margin_largest_where_stationary _ (fac delta eta) h Hi beta x Hb Hx Hstationary). unfold margin in H.
  lra.
Qed.

(** The thrust of a rotational state is positive: by the haunch relation it is [(g - f) (2 - eta) / (2 eta S)]. *)
Theorem rotational_thrust_positive (delta alpha beta eta : R) : 0 < beta < PI -> 0 < eta < 2 ->
  rotational_state delta alpha beta eta -> 0 < h_lower delta beta eta.
Proof.
  intros Hb He [H25 _]. assert (HS : 0 < sin beta) by positive.
  assert (Hk : 0 < g_of beta - f_of beta) by (apply g_minus_f_positive; lra).
  assert (Hh : 2 * eta * sin beta * h_lower delta beta eta = (g_of beta - f_of beta) * (2 - eta)).
  { apply (haunch_relation delta beta eta (h_lower delta beta eta)); try easy; try lra.
    apply Rgt_not_eq, lever_of_lower_thrust_positive; lra. }
  apply (Rmult_lt_reg_l (2 * eta * sin beta)); [repeat apply Rmult_lt_0_compat; nra | nra].
Qed.

(** A purely rotational state stands at every joint. *)
Theorem rotational_state_stands (delta alpha beta eta : R) : 0 <= delta -> 0 < beta < PI -> 0 < alpha < PI ->
  0 < eta < 2 -> rotational_state delta alpha beta eta -> let h := h_lower delta beta eta in
  forall x, 0 <= x <= alpha -> 0 < normal_force x h /\
  intrados eta <= pressure_point delta x eta h (extrados eta) <= extrados eta.
Proof.
  intros Hd Hb Ha He Hstate h x Hx. assert (Hh := rotational_thrust_positive delta alpha beta eta Hb He Hstate).
  fold h in Hh. destruct Hstate as [H25 H24].
  assert (Hfac : 1 <= fac delta eta) by (now apply centroid_factor_at_least_1).
  assert (Hversine : 0 < 1 - cos alpha) by positive. assert (H2 : h = h_lower delta beta eta) by easy.
  apply lower_thrust_cleared in H2; [|apply Rgt_not_eq, lever_of_lower_thrust_positive; lra].
  apply whole_thrust_cleared in H24; [fold h in H24 | lra | lra].
  assert (Hshoulder : h * extrados eta + fac delta eta * (1 - cos alpha) = extrados eta * normal_force alpha h)
    by (unfold extrados, normal_force; lra).
    assert (HNalpha : 0 < normal_force alpha h) by (unfold extrados in *; nra).
  assert (HN : 0 < normal_force x h) by (apply (normal_force_positive alpha); lra). split; [easy|].
  apply joint_stands_iff_thrust_inside; [easy|]. split; [lra|]. split.
  - apply (intrados_safe delta beta); try easy; [|lra]. unfold intrados, extrados, normal_force. lra.
  - apply (extrados_safe delta alpha); try easy; try lra; unfold extrados; lra.
Qed.

(** ** Thicker arches stand *)

Definition crown_gap (eta h p : R) : R := extrados eta * h - p.
Definition haunch_gap (delta beta eta h p : R) : R :=
  p + fac delta eta * (1 - cos beta) - intrados eta * normal_force beta h.
Definition shoulder_gap (delta alpha eta h p : R) : R :=
  extrados eta * normal_force alpha h - p - fac delta eta * (1 - cos alpha).

Lemma gap_at_crown (delta eta h p : R) : shoulder_gap delta 0 eta h p = crown_gap eta h p.
Proof. unfold shoulder_gap, crown_gap. rewrite normal_force_at_crown, cos_0. ring. Qed.

(** With less thickness the centroids move less than the pressure points. *)
Lemma centroids_move_less (delta eta eta' : R) : 0 <= delta <= 1 -> 0 < eta < eta' -> eta' <= 2 ->
  0 < 12 - delta * (2 * (eta + eta') + eta * eta').
Proof.
  intros Hd He He'. set (x := 2 * (eta + eta') + eta * eta'). assert (0 < x < 12) by (unfold x; split; nra). nra.
Qed.

(** What a joint bears it bears in a thicker arch, up to the physical limit, *)
Theorem joint_stands_if_thicker (delta beta eta eta' h p : R) : 0 <= delta <= 1 -> 0 < eta <= eta' -> eta' <= 2 ->
  0 <= p -> joint_stands delta beta eta h p -> joint_stands delta beta eta' h p.
Proof.
  intros Hd [He [Hlt | <-]] He' Hp H; [| exact H].
  assert (Hless := centroids_move_less delta eta eta' Hd ltac:(lra) He'). assert (HV := COS_bound beta).
  unfold joint_stands, intrados, extrados, fac in *. set (V := 1 - cos beta) in *. assert (0 <= V) by (unfold V; lra).
  split; [easy | split].
  - assert (0 <= delta * (eta' * eta' - eta * eta) * V) by positive. nra.
  - assert (0 <= (eta' - eta) * (12 - delta * (2 * (eta + eta') + eta * eta')) * V) by positive. nra.
Qed.

(** and beside the crown it has room there. *)
Lemma room_if_thicker (delta x eta eta' h p : R) : 0 <= delta <= 1 -> 0 < eta < eta' -> eta' <= 2 -> 0 <= p ->
  0 < x < PI -> joint_stands delta x eta h p -> 0 < haunch_gap delta x eta' h p /\ 0 < shoulder_gap delta x eta' h p.
Proof.
  intros Hd He He' Hp Hx (HN & Hin & Hout). assert (Hless := centroids_move_less delta eta eta' Hd He He').
  assert (0 < 1 - cos x) by positive.
  unfold haunch_gap, shoulder_gap, intrados, extrados, fac in *. set (V := 1 - cos x) in *. split.
  - assert (0 <= delta * (eta' * eta' - eta * eta) * V) by positive.
    assert (0 <= delta * (eta' * eta') * V) by positive. destruct HN as [HN | HN]; nra.
  - assert (0 < (eta' - eta) * (12 - delta * (2 * (eta + eta') + eta * eta')) * V) by positive. nra.
Qed.

(** ** No thinner arch stands

    What is left to the extrados at crown and shoulder and to the intrados at the haunch must not be negative.  Added
    with the rotations of a mechanism, [a] at the crown, [c] at the shoulder and [a + c] at the haunch, the three are
    free of [p]; the mechanism's sliding joint, if any, bounds the thrust on the side that matters.  The sum is 0 at the
    thickness of the state, and would be positive there if a thinner arch stood. *)

Definition mechanism (a c delta alpha beta eta h p : R) : R :=
  a * crown_gap eta h p + (a + c) * haunch_gap delta beta eta h p
  + c * shoulder_gap delta alpha eta h p.

(** The work of a unit thrust. *)
Definition thrust_arm (a c alpha beta eta : R) : R :=
  a * extrados eta - (a + c) * (intrados eta * cos beta) + c * (extrados eta * cos alpha).

Lemma mechanism_of_thrust (a c delta alpha beta eta h p h0 p0 : R) :
  mechanism a c delta alpha beta eta h p - mechanism a c delta alpha beta eta h0 p0
  = thrust_arm a c alpha beta eta * (h - h0).
Proof. unfold mechanism, crown_gap, haunch_gap, shoulder_gap, thrust_arm, normal_force. ring. Qed.

(** For every mechanism with a rotation at the crown or at the shoulder, and every state
    [(eta, h0, p0)] in which it can move. *)
Theorem no_thinner_arch_by_mechanism (a c delta alpha beta eta eta' h0 p0 h p : R) : 0 <= delta <= 1 ->
  0 < alpha < PI -> 0 <= beta < PI -> 0 < eta' < eta -> eta <= 2 -> 0 <= a -> 0 <= c -> (0 < c \/ 0 < a /\
    0 < beta) -> mechanism a c delta alpha beta eta h0 p0 = 0 -> thrust_arm a c alpha beta eta * (h - h0) <= 0 ->
  joint_stands delta 0 eta' h p -> joint_stands delta beta eta' h p -> ~ joint_stands delta alpha eta' h p.
Proof.
  intros Hd Ha Hb He' He Ha0 Hc0 Hmoves Hstate Hfriction (HN0 & Hin0 & Hout0) Sb Sa.
  rewrite normal_force_at_crown, cos_0 in *. assert (Hp : 0 <= p).
  { assert (0 <= intrados eta' * h) by positive. lra. }
  assert (Hthrust := mechanism_of_thrust a c delta alpha beta eta h p h0 p0).
  assert (Hthicker := joint_stands_if_thicker delta beta eta' eta h p Hd ltac:(lra) He Hp Sb).
  destruct (room_if_thicker delta alpha eta' eta h p Hd He' He Hp Ha Sa) as [_ Hshoulder].
  assert (0 <= a * crown_gap eta h p) by (apply Rmult_le_pos; [easy | unfold crown_gap, extrados in *; nra]).
  assert (0 < mechanism a c delta alpha beta eta h p); [unfold mechanism | lra].
  destruct Hmoves as [Hc | [Ha1 Hbeta]].
  - assert (0 <= (a + c) * haunch_gap delta beta eta h p)
      by (apply Rmult_le_pos; [| destruct Hthicker; unfold haunch_gap]; lra). nra.
  - destruct (room_if_thicker delta beta eta' eta h p Hd He' He Hp ltac:(lra) Sb) as [Hhaunch _]. nra.
Qed.

(** [[r,r,r]]: the thickness of (2) and (4), with no friction condition. The lever arm is that
    between the haunch's intrados and the shoulder's extrados. *)
Theorem no_thinner_arch (delta alpha beta eta eta' h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 <= beta < PI ->
  0 < eta' < eta -> eta <= 2 -> 0 < intrados eta * cos beta - extrados eta * cos alpha ->
  h_lower delta beta eta = h_whole delta alpha eta -> joint_stands delta 0 eta' h p ->
  joint_stands delta beta eta' h p -> ~ joint_stands delta alpha eta' h p.
Proof.
  intros Hd Ha Hb He' He Hlower Hstate. assert (Hv : 0 < 1 - cos alpha) by positive.
  assert (Hlever := lever_of_lower_thrust_positive beta eta ltac:(lra)).
  set (lower := intrados eta * cos beta - extrados eta * cos alpha) in *.
  set (upper := extrados eta - intrados eta * cos beta).
  assert (Hupper : 0 < upper) by (unfold upper, extrados, intrados; lra). set (h0 := h_lower delta beta eta) in *.
  assert (H2 : h0 = h_lower delta beta eta) by easy. apply lower_thrust_cleared in H2; [|lra].
  apply whole_thrust_cleared in Hstate; [|lra|lra].
  apply (no_thinner_arch_by_mechanism lower upper delta alpha beta eta eta' h0
           (extrados eta * h0)); try easy; try lra.
  - replace (mechanism _ _ _ _ _ _ _ _) with (lower * 0 + (lower + upper) * 0 + upper * 0).
    + ring.
    + unfold mechanism.
      repeat f_equal; unfold crown_gap, haunch_gap, shoulder_gap, extrados, intrados, normal_force; lra.
  - replace (thrust_arm _ _ _ _ _) with 0; [lra|]. unfold thrust_arm, lower, upper. ring.
Qed.

(** *** The lever arm is positive in every rotational state *)

(** From the semicircle on at once. *)
Lemma lever_positive_from_semicircle (alpha beta eta : R) : 0 < beta < alpha -> PI / 2 <= alpha < PI -> 0 < eta < 2 ->
  0 < intrados eta * cos beta - extrados eta * cos alpha.
Proof.
  intros Hb Ha He. unfold intrados, extrados. assert (cos alpha < cos beta) by (apply cos_decreasing_1; lra).
  assert (cos alpha <= 0) by (apply cos_le_0; lra). nra.
Qed.

(** Below it because [A / cos] grows. *)
Lemma A_over_cos_grows (a b : R) : 0 < a -> a < b -> b < PI / 2 -> A a / cos a < A b / cos b.
Proof.
  intros Ha Hab Hb. set (slope := fun x => (cos x * (sin x - x) + x * sin x ^ 2) / ((1 - cos x) * cos x ^ 2)).
  assert (Hpositive : forall x, 0 < x < PI / 2 ->
            0 < cos x /\ 0 < 1 - cos x /\ 0 < cos x * (sin x - x) + x * sin x ^ 2).
  { intros x Hx. assert (HC : 0 < cos x) by positive. assert (0 < sin x) by positive.
    assert (Hcot := times_cosine_below_sine x ltac:(lra)). assert (Hcircle := circle x). nra. }
  destruct (MVT_cor2 (fun x => A x / cos x) slope a b Hab) as (c & Hc & Hin).
  { intros c Hc. destruct (Hpositive c ltac:(lra)) as (HC & Hv & _). unfold A, slope.
    auto_derive; [repeat split; lra|]. transitivity ((((sin c + c * cos c) * (1 - cos c) - c * sin c ^ 2) * cos c
                   + c * sin c ^ 2 * (1 - cos c)) / ((1 - cos c) ^ 2 * cos c ^ 2)); [field; lra|].
    replace (sin c ^ 2) with ((1 - cos c) * (1 + cos c)) by (assert (Hcircle := circle c); lra). field. lra. }
  destruct (Hpositive c ltac:(lra)) as (HC & Hv & Hn). assert (0 < slope c) by (unfold slope; positive). nra.
Qed.

Theorem lever_positive (delta alpha beta eta : R) : 0 < beta < alpha -> alpha < PI -> 0 < eta < 2 ->
  rotational_state delta alpha beta eta -> 0 < intrados eta * cos beta - extrados eta * cos alpha.
Proof.
  intros Hb Ha He [H25 H24].
  destruct (Rle_lt_dec (PI / 2) alpha) as [Hwide | Hnarrow]; [now apply lever_positive_from_semicircle|].
  assert (HS : 0 < sin beta) by positive. assert (HCb : 0 < cos beta) by positive.
  assert (HCa : 0 < cos alpha) by positive.
  assert (Hg : 0 < g_of beta) by (apply g_positive; lra). assert (Hvb : 0 < 1 - cos beta) by positive.
  assert (Hshoulder : A alpha * sin beta * (2 + eta) = g_of beta * (2 - eta)).
  { apply (shoulder_relation delta alpha beta eta (h_lower delta beta eta)); try easy; try lra.
    apply Rgt_not_eq, lever_of_lower_thrust_positive; lra. }
  (* A sin at the haunch itself is at least g *)
  assert (Hhaunch : g_of beta <= A beta * sin beta).
  { replace (A beta * sin beta) with (beta * (1 + cos beta)).
    - unfold g_of. assert (sin beta < beta) by (apply sin_lt_x; lra). nra.
    - unfold A. symmetry. transitivity (beta * sin beta ^ 2 / (1 - cos beta)); [field; lra|].
      replace (sin beta ^ 2) with ((1 - cos beta) * (1 + cos beta)) by (assert (Hcircle := circle beta); lra). field.
      lra. }
  assert (Hgrows : A beta * cos alpha < A alpha * cos beta).
  { assert (H := A_over_cos_grows beta alpha ltac:(lra) ltac:(lra) Hnarrow).
    apply (Rmult_lt_compat_r (cos alpha * cos beta)) in H; [|positive]. field_simplify in H; lra. }
  assert (Hopen : g_of beta * cos alpha < A alpha * sin beta * cos beta) by nra. unfold intrados, extrados. nra.
Qed.

(** ** A rotational state's thicker arches *)

Theorem thicker_arch_stands (delta alpha beta eta eta' : R) : 0 <= delta <= 1 -> 0 < beta < PI -> 0 < alpha < PI ->
  0 < eta < 2 -> eta <= eta' <= 2 -> rotational_state delta alpha beta eta -> let h := h_lower delta beta eta in
  exists p, forall x, 0 <= x <= alpha -> joint_stands delta x eta' h p.
Proof.
  intros Hd Hb Ha He He' Hstate h. assert (Hh := rotational_thrust_positive delta alpha beta eta Hb He Hstate).
  exists (h * extrados eta). intros x Hx. apply (joint_stands_if_thicker delta x eta); try lra.
  - apply Rmult_le_pos; [fold h in Hh | unfold extrados]; lra.
  - destruct (rotational_state_stands delta alpha beta eta (proj1 Hd) Hb Ha He Hstate x Hx).
    now apply joint_stands_iff_thrust_inside.
Qed.

(** ** The least thickness *)

(** With friction out of question, an arch whose half-angle has a rotational state stands exactly
    from the thickness of that state on. *)
Theorem rotational_thickness_is_least (delta alpha beta eta : R) : 0 <= delta <= 1 -> 0 < beta < alpha ->
  alpha < PI -> 0 < eta < 2 -> rotational_state delta alpha beta eta -> forall eta', 0 < eta' <= 2 ->
  (exists h p, forall x, 0 <= x <= alpha -> joint_stands delta x eta' h p) <-> eta <= eta'.
Proof.
  intros Hd Hb Ha He Hstate eta' He'. assert (Hlever := lever_positive delta alpha beta eta Hb Ha He Hstate). split.
  - intros (h & p & Hall). apply Rnot_lt_le. intros Hthin. destruct Hstate as [_ H24].
    apply (no_thinner_arch delta alpha beta eta eta' h p); try easy; try lra; apply Hall; lra.
  - exists (h_lower delta beta eta). apply (thicker_arch_stands delta alpha beta eta eta'); try easy; lra.
Qed.

(** So a half-angle has at most one rotational state. *)
Theorem rotational_state_unique (delta alpha beta1 beta2 eta1 eta2 : R) : 0 <= delta <= 1 -> 0 < beta1 < alpha ->
  0 < beta2 < alpha -> alpha < PI -> 0 < eta1 < 2 -> 0 < eta2 < 2 -> rotational_state delta alpha beta1 eta1 ->
  rotational_state delta alpha beta2 eta2 ->
  beta1 = beta2 /\ eta1 = eta2 /\ h_lower delta beta1 eta1 = h_lower delta beta2 eta2.
Proof.
  intros Hd Hb1 Hb2 Ha He1 He2 Hstate1 Hstate2.
  assert (L1 := rotational_thickness_is_least delta alpha beta1 eta1 Hd Hb1 Ha He1 Hstate1).
  assert (L2 := rotational_thickness_is_least delta alpha beta2 eta2 Hd Hb2 Ha He2 Hstate2).
  assert (Heta : eta1 = eta2).
  { apply Rle_antisym; [apply L1, L2 | apply L2, L1]; lra. }
  subst eta2. destruct Hstate1 as [H25 H24], Hstate2 as [H25' H24'].
  assert (Hh : h_lower delta beta1 eta1 = h_lower delta beta2 eta1) by congruence. repeat split; [|easy].
  (* the same thrust is tangent at one joint only *)
  apply times_cotangent_injective; try lra. rewrite H25, H25' in Hh. unfold h_tangency in Hh. lra.
Qed.
