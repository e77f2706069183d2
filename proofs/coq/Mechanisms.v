(** * Symmetric mechanisms: seven modes, one thickness, one half-angle

    A mechanism without dilatancy gives rates that are not negative to joints at their limit, so that neither the thrust
    [h] nor the crown moment [p] works on it: [u] to the hinge at the crown's extrados, [l] to that at the intrados of
    [beta], [v] to that at the shoulder's extrados, [s] to the joint [sigma] that slides inwards and [t] to the shoulder
    that slides outwards. It is a sum of four, each with one rate inside and one at the shoulder. Friction is not
    associated, and yet the margins with the scaled rates add up to the same for all thrusts: so a thicker arch has no
    mechanism but pure sliding, and a narrower one has none at all.

    [Modes] proves that a mechanism, which may give a rate to any joint, is one of [moves]; [Room] that an arch without
    room has such rates, and [Attained] that the least thickness and the widest half-angle are attained. *)

From Couplet Require Export Moments Cubics Sliding Joining Contact FrictionModes.

(** ** The lever arm of the haunch *)

(** [x sin x + cos x] grows as far as the right angle. *)
Lemma moment_of_weight_grows (x y : R) : 0 <= x -> x <= y -> y <= PI / 2 -> x * sin x + cos x <= y * sin y + cos y.
Proof.
  intros Hx Hxy Hy. destruct (Req_dec x y) as [-> | Hne]; [lra|].
  destruct (MVT_cor2 (fun t => t * sin t + cos t) (fun t => t * cos t) x y) as (c & Hc & Hin); [lra| |].
  { intros c Hc. auto_derive; [easy | ring]. }
  assert (0 <= cos c) by positive. assert (0 <= c * cos c * (y - x)) by positive. lra.
Qed.

(** Without it there is room between the intrados of a joint and the shoulder's extrados, whatever the thrust: *)
Lemma room_without_lever (delta alpha beta eta h p : R) : 0 <= delta <= 1 -> 0 <= beta <= alpha -> 0 < alpha < PI ->
  0 < eta <= 2 -> 0 <= h -> intrados eta * cos beta - extrados eta * cos alpha <= 0 ->
  0 < haunch_gap delta beta eta h p + shoulder_gap delta alpha eta h p.
Proof.
  intros Hd Hb Ha He Hh Harm. assert (Hcos : cos alpha <= cos beta) by (apply cos_decr_1; lra).
  assert (Hnarrow : 0 <= cos alpha) by (unfold intrados, extrados in Harm; nra). assert (HaPI : alpha <= PI / 2).
  { apply Rnot_lt_le. intros H. assert (cos alpha < 0) by (apply cos_lt_0; lra). lra. }
  assert (Hgrow := moment_of_weight_grows beta alpha ltac:(lra) ltac:(lra) HaPI).
  assert (HSb : 0 <= beta * sin beta) by positive. assert (HSa : 0 < alpha * sin alpha) by positive.
  set (D := alpha * sin alpha + cos alpha - (beta * sin beta + cos beta)).
  assert (Hsum : extrados eta * D + eta * (beta * sin beta) + eta * (6 - delta * eta) / 12 * (cos beta - cos alpha)
    = h * (intrados eta * cos beta - extrados eta * cos alpha) + (haunch_gap delta beta eta h p + shoulder_gap delta
    alpha eta h p)).
  { unfold haunch_gap, shoulder_gap, normal_force, D, extrados, intrados, fac. field. }
  assert (0 <= D) by (unfold D; lra). assert (Hgain : 0 < eta * (6 - delta * eta) / 12) by positive.
  assert (0 <= extrados eta * D) by positive.
  (* not each term is zero, or the weight of the shoulder would be *)
  apply Rnot_le_lt. intros Hnone. assert (HD0 : D = 0) by (unfold extrados in *; nra).
  assert (Hb0 : beta * sin beta = 0) by nra. unfold D in HD0. nra.
Qed.

(** so with the line of thrust on both there is one. *)
Theorem lever_positive_in_any_state (delta alpha beta eta h p : R) : 0 <= delta <= 1 -> 0 <= beta <= alpha ->
  0 < alpha < PI -> 0 < eta <= 2 -> 0 <= h -> haunch_gap delta beta eta h p = 0 ->
  shoulder_gap delta alpha eta h p = 0 -> 0 < intrados eta * cos beta - extrados eta * cos alpha.
Proof.
  intros Hd Hb Ha He Hh HL HU. apply Rnot_le_lt. intros Harm.
  assert (H := room_without_lever delta alpha beta eta h p Hd Hb Ha He Hh Harm). lra.
Qed.

(** ** Mechanisms *)

Definition inward_gap (sigma mu h : R) : R := mu * normal_force sigma h - shear_force sigma h.
Definition outward_gap (alpha mu h : R) : R := mu * normal_force alpha h + shear_force alpha h.

(** Neither [p] nor [h] works on the rates: the haunch turns as crown and shoulder together, and
    what the thrust does inside it does at the shoulder too. *)
Definition in_balance (alpha beta sigma eta u l v s t : R) : Prop :=
  l = u + v /\
  u * (extrados eta - intrados eta * cos beta) + s * sin sigma
  = v * (intrados eta * cos beta - extrados eta * cos alpha) + t * sin alpha.

(** A mechanism moves in a state where the joints with a rate are at their limits. *)
Definition moves (delta alpha beta sigma eta mu h p u l v s t : R) : Prop :=
  (0 <= u /\ 0 <= l /\ 0 <= v /\ 0 <= s /\ 0 <= t) /\
  in_balance alpha beta sigma eta u l v s t /\
  u * crown_gap eta h p = 0 /\ l * haunch_gap delta beta eta h p = 0 /\
  v * shoulder_gap delta alpha eta h p = 0 /\
  s * inward_gap sigma mu h = 0 /\ t * outward_gap alpha mu h = 0.

(** The four with one rate inside and one at the shoulder: [x1] is the part of [[r,r,r]], [x2] of [[s,r,r]], [x3] of
    [[r,r,s]], [[r,s,r]] and [[r,s]], which differ in the order of the joints, and [x4] of [[s,s]]. *)
Theorem four_supports (delta alpha beta sigma eta mu h p u l v s t : R) : 0 <= delta <= 1 -> 0 <= beta <= alpha ->
  0 < alpha < PI -> 0 < sigma < PI -> 0 < eta <= 2 -> 0 <= h -> moves delta alpha beta sigma eta mu h p u l v s t ->
  let a := extrados eta - intrados eta * cos beta in let b := intrados eta * cos beta - extrados eta * cos alpha in
  exists x1 x2 x3 x4, 0 <= x1 /\ 0 <= x2 /\ 0 <= x3 /\ 0 <= x4 /\ a * u = x1 + x2 /\ b * v = x1 + x3 /\
  sin sigma * s = x3 + x4 /\ sin alpha * t = x2 + x4 /\ l = u + v.
Proof.
  intros Hd Hb Ha Hs He Hh ((Hu & Hl & Hv & Hs0 & Ht) & (Hp & Hbalance) & _ & HL & HU & _ & _) a b.
  fold a b in Hbalance. assert (HSs : 0 < sin sigma) by positive. assert (HSa : 0 < sin alpha) by positive.
  assert (Hau : 0 <= a * u).
  { apply Rmult_le_pos; [|easy]. unfold a, extrados, intrados. destruct (COS_bound beta). nra. }
  assert (Hbv : 0 <= b * v).
  { destruct (Req_dec v 0) as [-> | Hne]; [lra|]. apply Rmult_le_pos; [apply Rlt_le|easy].
    apply (lever_positive_in_any_state delta alpha beta eta h p); try easy; [apply (Rmult_eq_reg_l l); lra
      | apply (Rmult_eq_reg_l v); lra]. }
  assert (Hss : 0 <= sin sigma * s) by positive. assert (Htt : 0 <= sin alpha * t) by positive. set (x := a * u) in *.
  set (y := b * v) in *. set (z := sin sigma * s) in *. set (w := sin alpha * t) in *.
  assert (Hsum : x + z = y + w) by (unfold x, y, z, w; lra). destruct (Req_dec (x + z) 0) as [H0 | H0].
  - exists 0, 0, 0, 0. lra.
  - assert (HF : 0 < x + z) by lra. assert (Hpart : forall i j, 0 <= i -> 0 <= j -> 0 <= i * j / (x + z)).
    { intros i j Hi Hj. apply Rmult_le_pos; [positive|]. now apply Rlt_le, Rinv_0_lt_compat. }
    exists (x * y / (x + z)), (x * w / (x + z)), (z * y / (x + z)), (z * w / (x + z)).
    repeat split; try (now apply Hpart); try easy.
    + replace (x * y / (x + z) + x * w / (x + z)) with (x * (y + w) / (x + z)) by (field; lra). rewrite <- Hsum.
      field. lra.
    + field. lra.
    + replace (z * y / (x + z) + z * w / (x + z)) with (z * (y + w) / (x + z)) by (field; lra). rewrite <- Hsum.
      field. lra.
    + field. lra.
Qed.

(** ** Friction is not associated, but its rows are scaled by a positive number *)

Theorem slip_rows_are_scaled (x mu h h' : R) : 0 < normal_force x h ->
  (inward_gap x mu h = 0 -> normal_force x h * inward_gap x mu h' = x * (h' - h)) /\
  (outward_gap x mu h = 0 -> normal_force x h * outward_gap x mu h' = - (x * (h' - h))).
Proof.
  intros HN. unfold inward_gap, outward_gap.
  assert (Hmixed : shear_force x h * normal_force x h' - shear_force x h' * normal_force x h = x * (h' - h)).
  { unfold shear_force, normal_force.
    transitivity (x * (h' - h) * (sin x ^ 2 + cos x ^ 2)); [ring | rewrite circle; ring]. }
  nra.
Qed.

(** So with the rates of sliding joints scaled the margins add up to zero in every state. *)
Theorem work_is_the_same (delta alpha beta sigma eta mu h p u l v s t h' p' : R) : 0 < alpha -> 0 < sigma ->
  0 < normal_force sigma h -> 0 < normal_force alpha h -> moves delta alpha beta sigma eta mu h p u l v s t ->
  u * crown_gap eta h' p' + l * haunch_gap delta beta eta h' p'
  + v * shoulder_gap delta alpha eta h' p'
  + s * (sin sigma * normal_force sigma h / sigma) * inward_gap sigma mu h'
  + t * (sin alpha * normal_force alpha h / alpha) * outward_gap alpha mu h' = 0.
Proof.
  intros Ha Hs HNs HNa (_ & (Hp & Hbalance) & HC & HL & HU & HI & HO).
  destruct (slip_rows_are_scaled sigma mu h h' HNs) as [Hin _].
  destruct (slip_rows_are_scaled alpha mu h h' HNa) as [_ Hout].
  assert (Hinner : s * (sin sigma * normal_force sigma h / sigma) * inward_gap sigma mu h'
                   = s * sin sigma * (h' - h)).
  { destruct (Req_dec s 0) as [-> | Hne]; [lra|].
    assert (E : inward_gap sigma mu h = 0) by (apply (Rmult_eq_reg_l s); lra).
    transitivity (s * sin sigma / sigma * (normal_force sigma h * inward_gap sigma mu h'));
      [field; lra | rewrite (Hin E); field; lra]. }
  assert (Houter : t * (sin alpha * normal_force alpha h / alpha) * outward_gap alpha mu h'
                   = - (t * sin alpha * (h' - h))).
  { destruct (Req_dec t 0) as [-> | Hne]; [lra|].
    assert (E : outward_gap alpha mu h = 0) by (apply (Rmult_eq_reg_l t); lra).
    transitivity (t * sin alpha / alpha * (normal_force alpha h * outward_gap alpha mu h'));
      [field; lra | rewrite (Hout E); field; lra]. }
  assert (Hhinges : u * (crown_gap eta h' p' - crown_gap eta h p)
                    + l * (haunch_gap delta beta eta h' p' - haunch_gap delta beta eta h p)
                    + v * (shoulder_gap delta alpha eta h' p' - shoulder_gap delta alpha eta h p)
                    = (u * (extrados eta - intrados eta * cos beta)
                       - v * (intrados eta * cos beta - extrados eta * cos alpha)) * (h' - h)).
  { subst l. unfold crown_gap, haunch_gap, shoulder_gap, normal_force. ring. }
  replace (u * (extrados eta - intrados eta * cos beta) - v * (intrados eta * cos beta - extrados eta * cos alpha))
    with (t * sin alpha - s * sin sigma) in Hhinges by lra. lra.
Qed.

Lemma factor_zero (a b : R) : 0 < b -> a * b = 0 -> a = 0.
Proof. intros Hb H. apply (Rmult_eq_reg_r b); lra. Qed.

(** ** Thicker arches have room *)

(** With the same thrust, between the intrados of any joint and the extrados of crown and shoulder. *)
Theorem thicker_arch_has_room (delta alpha beta eta eta' h p : R) : 0 <= delta <= 1 -> 0 <= beta <= alpha ->
  0 < alpha < PI -> 0 < eta < eta' -> eta' <= 2 -> 0 < h ->
  (forall x, 0 <= x <= alpha -> joint_stands delta x eta h p) -> exists p', 0 < crown_gap eta' h p' /\
  0 < haunch_gap delta beta eta' h p' /\ 0 < shoulder_gap delta alpha eta' h p'.
Proof.
  intros Hd Hb Ha He He' Hh Hall. exists p. destruct (Hall 0 ltac:(lra)) as (_ & Hlow & Hcrown).
  rewrite normal_force_at_crown, cos_0 in Hlow, Hcrown. assert (0 < (eta' - eta) * h) by positive.
  assert (0 <= intrados eta * h) by positive. assert (Hp : 0 <= p) by lra.
  assert (Hroom := fun x Hx H => room_if_thicker delta x eta eta' h p Hd He He' Hp Hx (Hall x H)).
  split; [unfold crown_gap, extrados in *; lra | split; [| apply Hroom; lra]].
  destruct (Req_dec beta 0) as [-> | Hne]; [| apply Hroom; lra]. unfold haunch_gap, intrados in *.
  rewrite normal_force_at_crown, cos_0. lra.
Qed.

(** Finite friction needs a thrust: next to the crown the weight has no other hold. *)
Lemma friction_needs_thrust (delta alpha eta mu h p : R) : 0 < alpha -> 0 <= mu ->
  (forall x, 0 <= x <= alpha -> joint_stands delta x eta h p /\ friction_holds x mu h) -> 0 < h.
Proof.
  intros Ha Hmu Hall. assert (Hh : 0 <= h).
  { destruct (Hall 0 ltac:(lra)) as [[H _] _]. rewrite normal_force_at_crown in H. lra. }
  destruct (Req_dec h 0) as [E | Hne]; [|lra]. subst h. set (x := Rmin alpha (/ (mu + 2))).
  assert (Hinv : 0 < / (mu + 2)) by (apply Rinv_0_lt_compat; lra). assert (Hx : 0 < x) by (apply Rmin_glb_lt; lra).
  assert (Hx1 : x <= alpha) by apply Rmin_l. assert (Hx2 : (mu + 2) * x <= 1).
  { replace 1 with ((mu + 2) * / (mu + 2)) by (field; lra). apply Rmult_le_compat_l; [lra | apply Rmin_r]. }
  destruct (Hall x ltac:(lra)) as [_ H]. unfold friction_holds in H. assert (Habs := Rle_abs (shear_force x 0)).
  unfold shear_force, normal_force in *. assert (Hsin : sin x < x) by (apply sin_lt_x; lra).
  assert (Hhalf : sin (x / 2) < x / 2) by (apply sin_lt_x; lra).
  assert (Hhalf0 : 0 <= sin (x / 2)) by (apply sin_ge_0; assert (HPI := PI2_3_2); nra).
  assert (Hcos : cos x = 1 - 2 * sin (x / 2) * sin (x / 2))
    by (replace (cos x) with (cos (2 * (x / 2))) by (f_equal; field); apply cos_2a_sin).
  assert (mu * sin x < cos x) by nra. nra.
Qed.

(** ** No motion above the least thickness *)

(** Where a thinner arch stands, no hinge moves: what is left is [[s,s]], and the friction is that
    of the purely sliding state. *)
Theorem no_motion_above_the_least (delta alpha beta sigma eta eta' mu h p u l v s t : R) : 0 <= delta <= 1 ->
  0 <= beta <= alpha -> 0 < alpha < PI -> 0 < sigma <= alpha -> 0 <= mu -> 0 < eta < eta' -> eta' <= 2 ->
  0 < normal_force sigma h -> 0 < normal_force alpha h -> arch_stands delta alpha eta mu ->
  moves delta alpha beta sigma eta' mu h p u l v s t -> u = 0 /\ l = 0 /\ v = 0.
Proof.
  intros Hd Hb Ha Hs Hmu He He' HNs HNa (h0 & p0 & Hall) Hmoves.
  assert (0 < h0) by (apply (friction_needs_thrust delta alpha eta mu h0 p0); [lra | lra | exact Hall]).
  destruct (thicker_arch_has_room delta alpha beta eta eta' h0 p0) as (p' & Hc & Hi & Ho); try easy.
  { now apply Hall. }
  assert (Hwork := work_is_the_same delta alpha beta sigma eta' mu h p u l v s t h0 p'
                     ltac:(lra) ltac:(lra) HNs HNa Hmoves). destruct Hmoves as ((Hu & Hl & Hv & Hs0 & Ht) & _).
  destruct (Hall sigma ltac:(lra)) as [_ Hfs]. destruct (Hall alpha ltac:(lra)) as [_ Hfa].
  apply Rabs_le_between in Hfs, Hfa. assert (0 <= inward_gap sigma mu h0) by (unfold inward_gap; lra).
  assert (0 <= outward_gap alpha mu h0) by (unfold outward_gap; lra).
  assert (0 <= s * (sin sigma * normal_force sigma h / sigma) * inward_gap sigma mu h0) by positive.
  assert (0 <= t * (sin alpha * normal_force alpha h / alpha) * outward_gap alpha mu h0) by positive.
  assert (0 <= u * crown_gap eta' h0 p') by positive. assert (0 <= l * haunch_gap delta beta eta' h0 p') by positive.
  assert (0 <= v * shoulder_gap delta alpha eta' h0 p') by positive. repeat split.
  - apply (factor_zero u (crown_gap eta' h0 p')); lra.
  - apply (factor_zero l (haunch_gap delta beta eta' h0 p')); lra.
  - apply (factor_zero v (shoulder_gap delta alpha eta' h0 p')); lra.
Qed.

(** ** No motion below the widest half-angle

    So to each thickness and friction belongs one half-angle with a mechanism. *)

(** A margin between two joints is above the lesser of theirs. *)
Lemma margin_between (a m h x z y : R) : 0 < a -> 0 <= x -> x < z < y -> y < PI ->
  Rmin (margin a m h x) (margin a m h y) < margin a m h z.
Proof.
  intros Ha Hx Hz Hy. destruct (Rle_lt_dec 0 (direction a m h z)) as [Hdir | Hdir].
  - apply Rle_lt_trans with (margin a m h x); [apply Rmin_l | apply margin_rises; lra].
  - apply Rle_lt_trans with (margin a m h y); [apply Rmin_r | apply margin_falls; lra].
Qed.

(** Within a wider arch the line of thrust is off the extrados, *)
Lemma extrados_clear_within (delta alpha alpha' eta h p : R) : 0 < eta -> 0 < alpha < alpha' -> alpha' < PI ->
  0 <= crown_gap eta h p -> 0 <= shoulder_gap delta alpha' eta h p -> 0 < shoulder_gap delta alpha eta h p.
Proof.
  intros He Ha Ha' Hc Hs.
  assert (H := margin_between (extrados eta) (fac delta eta) h 0 alpha alpha'
                 ltac:(unfold extrados; lra) ltac:(lra) Ha Ha').
  assert (Hleast : p + fac delta eta <= Rmin (margin (extrados eta) (fac delta eta) h 0)
                                             (margin (extrados eta) (fac delta eta) h alpha')).
  { unfold crown_gap, shoulder_gap in *. apply Rmin_glb; unfold margin; [|lra]. unfold normal_force.
    rewrite cos_0, sin_0. lra. }
  unfold shoulder_gap, margin in *. lra.
Qed.

(** and no joint is about to slide outwards. *)
Lemma no_outward_limit_within (alpha alpha' mu h : R) : 0 < alpha < alpha' -> alpha' < PI -> 0 <= mu -> 0 < h ->
  0 <= outward_gap alpha' mu h -> 0 < outward_gap alpha mu h.
Proof.
  intros Ha Ha' Hmu Hh Hgap. set (phi := atan mu). assert (0 <= phi < PI / 2).
  { split; [|apply atan_bound]. destruct (Req_dec mu 0) as [E | Hne].
    - unfold phi. rewrite E, atan_0. lra.
    - unfold phi. rewrite <- atan_0. apply Rlt_le, atan_increasing. lra. }
  assert (HC : 0 < cos phi) by positive. assert (Hslope : mu * cos phi = sin phi).
  { replace mu with (tan phi) by apply tan_atan. unfold tan. field. lra. }
  assert (Hturned : forall x, outward_gap x mu h * cos phi = x * cos (x - phi) - h * sin (x - phi)).
  { intros x. rewrite cos_minus, sin_minus. unfold outward_gap, normal_force, shear_force. rewrite <- Hslope. ring. }
  assert (Hgap' := Rmult_le_pos _ _ Hgap (Rlt_le _ _ HC)). rewrite Hturned in Hgap'.
  apply (Rmult_lt_reg_r (cos phi)); [easy|]. rewrite Rmult_0_l, Hturned. set (y := alpha - phi) in *.
  set (y' := alpha' - phi) in *. destruct (Rle_lt_dec y 0) as [Hy | Hy].
  - assert (HPI := PI2_3_2). assert (0 < cos y) by (apply cos_gt_0; unfold y in *; lra).
    assert (0 < alpha * cos y) by positive.
    assert (0 <= h * sin (- y)) by (apply Rmult_le_pos; [lra | apply sin_ge_0; unfold y in *; lra]).
    rewrite sin_neg in *. lra.
  - assert (y < y' < PI) by (unfold y, y'; lra). assert (0 < sin y) by positive. assert (0 < sin y') by positive.
    assert (y' * cot y' < y * cot y) by (apply times_cotangent_falls; lra). assert (cot y' <= cot y).
    { apply Rlt_le, Rminus_gt_0_lt. unfold cot.
      replace (cos y / sin y - cos y' / sin y') with (sin (y' - y) / (sin y * sin y'))
        by (rewrite sin_minus; field; lra). apply Rdiv_lt_0_compat; positive. }
    assert (Hbound : h <= alpha' * cot y').
    { apply (Rmult_le_reg_r (sin y')); [easy|]. unfold cot.
      replace (alpha' * (cos y' / sin y') * sin y') with (alpha' * cos y') by (field; lra). lra. }
    assert (Hless : h < alpha * cot y).
    { replace alpha with (y + phi) by (unfold y; ring). replace alpha' with (y' + phi) in Hbound by (unfold y'; ring).
      nra. }
    apply (Rmult_lt_compat_r (sin y)) in Hless; [|easy]. unfold cot in Hless.
    replace (alpha * (cos y / sin y) * sin y) with (alpha * cos y) in Hless by (field; lra). lra.
Qed.

Theorem no_motion_below_the_widest (delta alpha alpha' beta sigma eta mu h p u l v s t : R) : 0 <= delta <= 1 ->
  0 <= beta <= alpha -> 0 < alpha < alpha' -> alpha' < PI -> 0 < sigma <= alpha -> 0 <= mu -> 0 < eta <= 2 ->
  0 < normal_force sigma h -> 0 < normal_force alpha h -> arch_stands delta alpha' eta mu ->
  moves delta alpha beta sigma eta mu h p u l v s t -> u = 0 /\ l = 0 /\ v = 0 /\ s = 0 /\ t = 0.
Proof.
  intros Hd Hb Ha Ha' Hs Hmu He HNs HNa (h0 & p0 & Hall) Hmoves.
  assert (0 < h0) by (apply (friction_needs_thrust delta alpha' eta mu h0 p0); [lra | lra | exact Hall]).
  destruct (Hall 0 ltac:(lra)) as [(_ & _ & Hcrown) _]. destruct (Hall beta ltac:(lra)) as [(_ & Hhaunch & _) _].
  destruct (Hall sigma ltac:(lra)) as [_ Hfs]. destruct (Hall alpha' ltac:(lra)) as [(_ & _ & Hshoulder) Hfa].
  apply Rabs_le_between in Hfs, Hfa.
  replace (normal_force 0 h0) with h0 in Hcrown by (unfold normal_force; rewrite cos_0, sin_0; ring).
  rewrite cos_0 in Hcrown. assert (0 <= crown_gap eta h0 p0) by (unfold crown_gap; lra).
  assert (0 <= haunch_gap delta beta eta h0 p0) by (unfold haunch_gap; lra).
  assert (0 < shoulder_gap delta alpha eta h0 p0).
  { apply (extrados_clear_within delta alpha alpha'); try lra. unfold shoulder_gap. lra. }
  assert (0 < outward_gap alpha mu h0).
  { apply (no_outward_limit_within alpha alpha'); try lra. unfold outward_gap. lra. }
  assert (0 <= inward_gap sigma mu h0) by (unfold inward_gap; lra).
  assert (Hwork := work_is_the_same delta alpha beta sigma eta mu h p u l v s t h0 p0
                     ltac:(lra) ltac:(lra) HNs HNa Hmoves).
  destruct Hmoves as ((Hu & Hl & Hv & Hs0 & Ht) & (Hp & Hbalance) & _).
  assert (0 <= s * (sin sigma * normal_force sigma h / sigma) * inward_gap sigma mu h0) by positive.
  assert (0 <= t * (sin alpha * normal_force alpha h / alpha) * outward_gap alpha mu h0) by positive.
  assert (0 <= u * crown_gap eta h0 p0) by positive. assert (0 <= l * haunch_gap delta beta eta h0 p0) by positive.
  assert (0 <= v * shoulder_gap delta alpha eta h0 p0) by positive.
  assert (Ev : v = 0) by (apply (factor_zero v (shoulder_gap delta alpha eta h0 p0)); lra). assert (Et : t = 0).
  { apply (factor_zero t (sin alpha * normal_force alpha h / alpha * outward_gap alpha mu h0));
      [positive | lra]. }
  (* what moves inside has nothing at the shoulder to carry it *)
  subst v t. assert (0 < extrados eta - intrados eta * cos beta).
  { unfold extrados, intrados. destruct (COS_bound beta).
    assert (-1 < cos beta) by (rewrite <- cos_PI; apply cos_decreasing_1; lra). nra. }
  assert (0 < sin sigma) by positive. assert (0 <= u * (extrados eta - intrados eta * cos beta)) by positive.
  assert (0 <= s * sin sigma) by positive.
  assert (Eu : u = 0) by (apply (factor_zero u (extrados eta - intrados eta * cos beta)); lra).
  assert (Es : s = 0) by (apply (factor_zero s (sin sigma)); lra). repeat split; lra.
Qed.

(** ** The shoulder's hinge and rotation

    So where an inner joint slides and the shoulder turns, the thrust and the thickness are at least
    those of pure rotation: such modes begin at [T]. *)
Theorem shoulder_hinge_keeps_rotation (delta alpha beta eta0 eta h p : R) : 0 <= delta <= 1 -> 0 < beta < alpha ->
  alpha < PI -> 0 < eta0 < 2 -> 0 < eta <= 2 -> rotational_state delta alpha beta eta0 ->
  (forall x, 0 <= x <= alpha -> joint_stands delta x eta h p) -> shoulder_gap delta alpha eta h p = 0 ->
  eta0 <= eta /\ h_lower delta beta eta0 <= h.
Proof.
  intros Hd Hb Ha He0 He Hstate Hall HU. assert (Hthick : eta0 <= eta).
  { apply (rotational_thickness_is_least delta alpha beta eta0 Hd Hb Ha He0 Hstate eta He). now exists h, p. }
  split; [easy|]. destruct (Hall 0 ltac:(lra)) as (_ & _ & Hcrown). destruct Hstate as [_ H24].
  rewrite normal_force_at_crown, cos_0 in Hcrown. assert (Hv : 0 < 1 - cos alpha) by positive.
  set (h0 := h_lower delta beta eta0) in *. apply whole_thrust_cleared in H24; [|lra|lra].
  assert (Hfalls : 0 <= (eta - eta0) * (1 - delta / 12 * (2 * eta + 2 * eta0 + eta * eta0))).
  {
    assert (delta * (2 * eta + 2 * eta0 + eta * eta0) <= 1 * 12) by (apply Rmult_le_compat; nra). nra. }
  assert (Hcut : (2 + eta) * fac delta eta0 - (2 + eta0) * fac delta eta
    = (eta - eta0) * (1 - delta / 12 * (2 * eta + 2 * eta0 + eta * eta0))) by (unfold fac; field).
  unfold shoulder_gap, normal_force, extrados in *.
  assert (Hmore : fac delta eta * (1 - cos alpha) * (2 + eta0)
                  <= fac delta eta0 * (1 - cos alpha) * (2 + eta)) by nra. apply Rnot_lt_le. intros Hless.
  assert (Hpos : 0 < (2 + eta) * (2 + eta0) * ((h0 - h) * (1 - cos alpha))) by positive. nra.
Qed.

(** ** Symmetric states are enough *)

(** With a vertical force [v] in the crown; [x] runs from one shoulder to the other. *)
Definition whole_normal (x h v : R) : R := h * cos x + (x - v) * sin x.
Definition whole_shear (x h v : R) : R := (x - v) * cos x - h * sin x.

Definition whole_joint_stands (delta x eta mu h p v : R) : Prop :=
  0 <= whole_normal x h v /\
  intrados eta * whole_normal x h v <= p + fac delta eta * (1 - cos x) <=
  extrados eta * whole_normal x h v /\
  Rabs (whole_shear x h v) <= mu * whole_normal x h v.

(** The mean of a state and its mirror image. *)
Theorem symmetric_mean_stands (delta alpha eta mu h p v : R) :
  (forall x, - alpha <= x <= alpha -> whole_joint_stands delta x eta mu h p v) -> arch_stands delta alpha eta mu.
Proof.
  intros Hall. exists h, p. intros x Hx. destruct (Hall x ltac:(lra)) as (HN & HM & HT).
  destruct (Hall (- x) ltac:(lra)) as (HN' & HM' & HT').
  unfold joint_stands, friction_holds, whole_normal, whole_shear in *. rewrite cos_neg, sin_neg in *.
  apply Rabs_le_between in HT, HT'. unfold normal_force, shear_force. split; [lra|]. apply Rabs_le_between. lra.
Qed.
