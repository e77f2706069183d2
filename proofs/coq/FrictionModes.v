(** * The least thickness when friction is finite

    An arch stands if at every joint the line of thrust is inside ([Contact]) and friction holds. Where the shoulder
    slides, [[s,r,r]], the thrust is at most (17); where an inner joint slides, [[r,r,s]], [[r,s,r]] and, with the
    rotational joint at the crown, [[r,s]], it is at least that of (18). The mechanism then gains from the other side
    of the balance, and **no thinner arch stands** by the same sum as without friction.

    Purely sliding states [[s,s]] bound the friction, whatever the thickness. *)

From Couplet Require Import Moments Cubics Sliding Joining Contact.

(** Coulomb's law in both directions. *)
Definition friction_holds (beta mu h : R) : Prop := Rabs (shear_force beta h) <= mu * normal_force beta h.

(** There is a thrust, and a place for it in the crown, with which every joint stands and holds. *)
Definition arch_stands (delta alpha eta mu : R) : Prop :=
  exists h p, forall x, 0 <= x <= alpha -> joint_stands delta x eta h p /\ friction_holds x mu h.

(** ** What friction asks of the thrust *)

Lemma thrust_at_most_h_mu (alpha mu h : R) : 0 < sin alpha - mu * cos alpha ->
  friction_holds alpha mu h -> h <= h_mu alpha mu.
Proof.
  intros HD H. apply no_shoulder_sliding; [easy|]. unfold friction_holds in H.
  assert (Habs := Rle_abs (- shear_force alpha h)). rewrite Rabs_Ropp in Habs. lra.
Qed.

Lemma thrust_at_least_h_is (mu h0 h : R) : 0 < h0 < 1 -> mu = mu_is h0 -> 0 <= h ->
  0 <= normal_force (beta_s h0) h -> friction_holds (beta_s h0) mu h -> h0 <= h.
Proof.
  intros Hh0 Hmu Hh HN Hfriction. rewrite mu_is_from_statics in Hmu by easy. assert (Hbeta := beta_s_positive h0 Hh0).
  assert (HN0 := normal_force_at_beta_s_positive h0 ltac:(lra)).
  assert (Hshear : shear_force (beta_s h0) h <= mu * normal_force (beta_s h0) h)
    by (unfold friction_holds in Hfriction; assert (H := Rle_abs (shear_force (beta_s h0) h)); lra).
  (* T/N is larger for the smaller thrust; cleared of the denominators *)
  assert (Hbalance : shear_force (beta_s h0) h * normal_force (beta_s h0) h0 - shear_force (beta_s h0) h0 *
    normal_force (beta_s h0) h = beta_s h0 * (h0 - h)).
  { unfold shear_force, normal_force. set (b := beta_s h0).
    transitivity (b * (h0 - h) * (sin b ^ 2 + cos b ^ 2)); [ring | rewrite circle; ring]. }
  assert (Hsteep : mu * normal_force (beta_s h0) h0 = shear_force (beta_s h0) h0)
    by (rewrite Hmu; unfold steepness; field; lra).
  apply (Rmult_le_compat_r (normal_force (beta_s h0) h0)) in Hshear; nra.
Qed.

(** ** [[s,r,r]] *)

(** The thickness of (2) and (17) is the least; the state also needs (5), which is not used here. *)
Theorem no_thinner_arch_with_sliding_shoulder (delta alpha beta eta eta' mu : R) : 0 <= delta <= 1 ->
  0 < beta < alpha -> alpha < PI -> 0 < eta' < eta -> eta <= 2 -> 0 < sin alpha - mu * cos alpha ->
  h_lower delta beta eta = h_mu alpha mu -> ~ arch_stands delta alpha eta' mu.
Proof.
  intros Hd Hb Ha He' He HD Hstate (h & p & Hall). set (h0 := h_lower delta beta eta) in *.
  assert (Hlever := lever_of_lower_thrust_positive beta eta ltac:(lra)).
  assert (H2 : h0 = h_lower delta beta eta) by easy. apply lower_thrust_cleared in H2; [|lra].
  destruct (Hall 0 ltac:(lra)) as [Hcrown _]. destruct (Hall beta ltac:(lra)) as [Hhaunch _].
  destruct (Hall alpha ltac:(lra)) as [Hshoulder Hfriction]. apply thrust_at_most_h_mu in Hfriction; [|easy].
  revert Hcrown Hhaunch Hshoulder.
  apply (no_thinner_arch_by_mechanism 1 0 delta alpha beta eta eta' h0 (extrados eta * h0)); try lra.
  - unfold mechanism, crown_gap, haunch_gap, extrados, intrados, normal_force. lra.
  - assert (Harm : 0 < thrust_arm 1 0 alpha beta eta) by (unfold thrust_arm, extrados, intrados; lra). nra.
Qed.

(** ** [[r,r,s]], [[r,s,r]] and [[r,s]] *)

(** The thickness of (3) and (18) is the least, if the lever arm in (3) is positive; [beta = 0] is
    the overturning-sliding mode. *)
Theorem no_thinner_arch_with_sliding_joint (delta alpha beta eta eta' mu h0 : R) : 0 <= delta <= 1 ->
  0 <= beta < alpha -> alpha < PI -> 0 < eta' < eta -> eta <= 2 -> 0 < (2 - eta) * cos beta - (2 + eta) * cos alpha ->
  0 < h0 < 1 -> beta_s h0 <= alpha -> mu = mu_is h0 -> h0 = h_upper delta alpha beta eta ->
  ~ arch_stands delta alpha eta' mu.
Proof.
  intros Hd Hb Ha He' He Hlever Hh0 Hs Hmu Hstate (h & p & Hall). apply upper_thrust_cleared in Hstate; [|lra].
  destruct (Hall 0 ltac:(lra)) as [Hcrown _]. destruct (Hall beta ltac:(lra)) as [Hhaunch _].
  destruct (Hall alpha ltac:(lra)) as [Hshoulder _]. assert (0 <= beta_s h0) by apply sqrt_pos.
  destruct (Hall (beta_s h0) ltac:(lra)) as [(HNs & _) Hfriction]. assert (Hh : 0 <= h).
  { destruct Hcrown as [HN0 _]. rewrite normal_force_at_crown in HN0. lra. }
  apply (thrust_at_least_h_is mu h0 h Hh0 Hmu Hh HNs) in Hfriction. revert Hcrown Hhaunch Hshoulder.
  apply (no_thinner_arch_by_mechanism 0 1 delta alpha beta eta eta' h0
           (extrados eta * normal_force alpha h0 - fac delta eta * (1 - cos alpha))); try lra.
  - unfold mechanism, haunch_gap, shoulder_gap, extrados, intrados, normal_force. lra.
  - assert (thrust_arm 0 1 alpha beta eta < 0) by (unfold thrust_arm, extrados, intrados; lra). nra.
Qed.

(** ** [[s,s]] *)

(** At a friction below (17) = (18) no arch of that half-angle stands. *)
Theorem no_arch_below_purely_sliding (delta alpha eta mu mu' h0 : R) : 0 < alpha < PI -> 0 < h0 < 1 ->
  beta_s h0 <= alpha -> mu' < mu -> 0 <= mu' -> 0 < sin alpha - mu' * cos alpha -> 0 < normal_force alpha h0 ->
  mu = mu_is h0 -> mu = mu_ss alpha h0 -> ~ arch_stands delta alpha eta mu'.
Proof.
  intros Ha Hh0 Hs Hless Hmu' HD HN His Hss (h & p & Hall). assert (Hs0 : 0 <= beta_s h0) by apply sqrt_pos.
  destruct (Hall 0 ltac:(lra)) as [(HN0 & _) _]. destruct (Hall (beta_s h0) ltac:(lra)) as [(HNs & _) Hinner].
  destruct (Hall alpha ltac:(lra)) as [(HNa & _) Hshoulder].
  assert (Hh : 0 <= h) by (rewrite normal_force_at_crown in HN0; lra).
  (* an inner joint wants at least h0, *)
  assert (Hmore : h0 <= h).
  { apply (thrust_at_least_h_is mu h0 h Hh0 His Hh HNs).
    apply Rle_trans with (mu' * normal_force (beta_s h0) h); [easy|]. apply Rmult_le_compat_r; lra. }
  (* the shoulder wants less *)
  apply thrust_at_most_h_mu in Hshoulder; [|easy]. assert (Hfewer : h_mu alpha mu' < h0).
  { apply Rnot_le_lt. intros H. apply (no_shoulder_sliding alpha mu' h0 HD) in H.
    assert (E : mu * normal_force alpha h0 = - shear_force alpha h0).
    { rewrite Hss, shoulder_friction_from_statics. unfold steepness. field. lra. }
    nra. }
  lra.
Qed.

(** Friction holds everywhere exactly if the thrust lies between the two sliding equations. *)
Theorem friction_by_two_joints (h alpha mu : R) :
  0 < h < 1 -> 0 < alpha < PI -> 0 < normal_force alpha h -> 0 <= mu -> beta_s h <= alpha ->
  (forall x, 0 <= x <= alpha -> friction_holds x mu h) <-> mu_is h <= mu /\ mu_ss alpha h <= mu.
Proof.
  intros Hh Ha HN Hmu Hs. rewrite <- (no_inner_sliding h alpha mu) by lra.
  rewrite <- (no_outward_sliding h alpha mu) by lra. split.
  - split; intros x Hx; specialize (H x Hx); apply Rabs_le_between in H; lra.
  - intros [Hin Hout] x Hx. apply Rabs_le_between. specialize (Hin x Hx). specialize (Hout x Hx). lra.
Qed.
