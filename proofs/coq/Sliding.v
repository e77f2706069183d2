(** * Sliding: (17) and (18)

    A joint slides inwards when [T/N] reaches the friction coefficient, outwards (at the shoulder) when [-T/N] does:
    (17), both forms, is [-T/N] at the shoulder. [T/N] has the derivative [(h (1-h) - beta^2) / N^2], so it grows up to
    [beta_s] and falls after it: exactly one inner joint can slide, as far as the joints carry compression, that is on
    [[0, alpha]] as soon as [N(alpha) > 0] and [alpha <= PI], and so on [[0, PI/2]]. (18) is [T/N] at [beta_s], its
    maximum, and falls strictly with the thrust on [(0, 1)]. *)

From Couplet Require Import Moments Cubics.

(** The slope of the resultant in a joint. *)
Definition steepness (beta h : R) : R := shear_force beta h / normal_force beta h.

(** ** (17) *)

(** Left: the shoulder slides outwards at the friction [-T/N]. *)
Theorem shoulder_friction_from_statics (alpha h : R) : mu_ss alpha h = - steepness alpha h.
Proof. unfold mu_ss, steepness, shear_force, normal_force, Rdiv. ring. Qed.

(** Right: the same solved for the thrust. *)
Theorem shoulder_thrust_from_statics (alpha mu h : R) : normal_force alpha h <> 0 ->
  sin alpha - mu * cos alpha <> 0 -> mu = mu_ss alpha h <-> h = h_mu alpha mu.
Proof.
  unfold mu_ss, h_mu, normal_force. intros HN HD. rewrite (equals_quotient mu) by exact HN.
  replace (alpha * ((cos alpha + mu * sin alpha) / (sin alpha - mu * cos alpha)))
    with (alpha * (cos alpha + mu * sin alpha) / (sin alpha - mu * cos alpha)) by (field; easy).
  rewrite (equals_quotient h) by exact HD. split; lra.
Qed.

(** The denominator on the right never vanishes where the shoulder slides. *)
Theorem shoulder_thrust_denominator (alpha mu h : R) : alpha <> 0 ->
  mu * normal_force alpha h = - shear_force alpha h -> sin alpha - mu * cos alpha <> 0.
Proof.
  unfold normal_force, shear_force. intros Ha Hmu HD.
  assert (Hother : alpha * (cos alpha + mu * sin alpha) = 0) by nra. apply Rmult_integral in Hother.
  destruct Hother as [H | Hother]; [easy|]. assert (Hcircle := circle alpha). nra.
Qed.

(** The shoulder bears every thrust up to that one. *)
Theorem no_shoulder_sliding (alpha mu h : R) : 0 < sin alpha - mu * cos alpha ->
  - shear_force alpha h <= mu * normal_force alpha h <-> h <= h_mu alpha mu.
Proof.
  intros HD. unfold h_mu, shear_force, normal_force. set (D := sin alpha - mu * cos alpha) in *.
  assert (E : alpha * ((cos alpha + mu * sin alpha) / D) * D = alpha * (cos alpha + mu * sin alpha)) by (field; lra).
  set (h_max := alpha * (_ / D)) in *. unfold D in *. split; intros H; nra.
Qed.

(** ** Where the joints carry compression *)

Lemma normal_force_at_crown (h : R) : normal_force 0 h = h.
Proof. unfold normal_force. rewrite cos_0, sin_0. ring. Qed.

Lemma normal_force_positive_to_quarter (beta h : R) : 0 < h -> 0 <= beta <= PI / 2 -> 0 < normal_force beta h.
Proof.
  intros Hh Hb. unfold normal_force. assert (HPI := PI2_3_2). assert (0 <= cos beta) by positive.
  assert (0 <= sin beta) by positive. assert (Hcircle := circle beta).
  destruct (Req_dec beta 0) as [-> | Hne]; [rewrite cos_0, sin_0; lra|]. assert (0 < sin beta) by positive. nra.
Qed.

(** Compression at the shoulder means compression everywhere. *)
Theorem normal_force_positive (alpha beta h : R) :
  0 < h -> 0 <= beta <= alpha -> alpha <= PI -> 0 < normal_force alpha h -> 0 < normal_force beta h.
Proof.
  intros Hh Hb Ha HN. assert (HPI := PI2_3_2).
  destruct (Rle_lt_dec beta (PI / 2)) as [Hq | Hq]; [apply normal_force_positive_to_quarter; lra|].
  (* beyond a quarter circle, - beta tan beta falls, and N has the sign of - beta tan beta - h *)
  destruct (Req_dec beta alpha) as [-> | Hne]; [easy|]. assert (Halpha : alpha < PI).
  { destruct (Req_dec alpha PI) as [-> | H]; [|lra]. unfold normal_force in HN. rewrite cos_PI, sin_PI in HN. lra. }
  assert (Hcos : forall x, PI / 2 < x < PI -> cos x < 0) by (intros x Hx; apply cos_lt_0; lra).
  assert (Hfall : beta * tan beta < alpha * tan alpha).
  { destruct (MVT_cor2 (fun x => x * tan x) (fun x => (sin x * cos x + x) / cos x ^ 2) beta alpha)
      as (c & Hc & Hin); [lra | |].
    - intros c Hc. apply is_derive_Reals. assert (cos c < 0) by (apply Hcos; lra). assert (Hcircle := circle c).
      unfold tan. auto_derive; [lra|].
      transitivity ((sin c * cos c + c * (sin c ^ 2 + cos c ^ 2)) / cos c ^ 2);
        [field; lra | rewrite Hcircle; field; lra].
    - assert (cos c < 0) by (apply Hcos; lra). assert (0 < sin c * cos c + c).
      { destruct (SIN_bound c), (COS_bound c). assert (0 < sin c) by positive. nra. }
      assert (0 < (sin c * cos c + c) / cos c ^ 2) by positive. nra. }
  assert (Hshape : forall x, cos x < 0 -> normal_force x h = cos x * (h + x * tan x))
    by (intros x Hx; unfold normal_force, tan; field; lra).
  assert (cos alpha < 0) by (apply Hcos; lra). assert (cos beta < 0) by (apply Hcos; lra).
  rewrite Hshape in HN |- * by easy. set (at_alpha := alpha * tan alpha) in *. set (at_beta := beta * tan beta) in *.
  assert (h + at_alpha < 0) by nra. nra.
Qed.

(** ** [T/N] along the arch *)

Theorem derivative_of_steepness (beta h : R) : normal_force beta h <> 0 ->
  is_derive (fun b => steepness b h) beta ((h * (1 - h) - beta ^ 2) / normal_force beta h ^ 2).
Proof.
  unfold steepness, shear_force, normal_force. intros HN. auto_derive; [exact HN|].
  transitivity ((h * (1 - h) - beta ^ 2) * (sin beta ^ 2 + cos beta ^ 2)
                / (h * cos beta + beta * sin beta) ^ 2); [field; easy|]. rewrite circle. field. easy.
Qed.

Lemma beta_s_square (h : R) : 0 <= h <= 1 -> beta_s h ^ 2 = h * (1 - h).
Proof. intros Hh. apply pow2_sqrt. nra. Qed.

Lemma beta_s_positive (h : R) : 0 < h < 1 -> 0 < beta_s h.
Proof. intros Hh. apply sqrt_lt_R0. nra. Qed.

(** The sliding joint is never farther than half a radian from the crown. *)
Theorem beta_s_at_most_one_half (h : R) : 0 <= h <= 1 -> beta_s h <= 1 / 2.
Proof.
  intros Hh. assert (Hsq := beta_s_square h Hh). assert (0 <= (2 * h - 1) ^ 2) by apply pow2_ge_0.
  assert (0 <= beta_s h) by apply sqrt_pos. nra.
Qed.

Lemma normal_force_at_beta_s_positive (h : R) : 0 < h <= 1 -> 0 < normal_force (beta_s h) h.
Proof.
  intros Hh. apply normal_force_positive_to_quarter; [lra|]. assert (H := beta_s_at_most_one_half h ltac:(lra)).
  assert (HPI := PI2_3_2). split; [apply sqrt_pos | lra].
Qed.

(** What a bound of [T/N] says of [T] and [N]. *)
Lemma steepness_at_most (x h m : R) : 0 < normal_force x h -> (steepness x h <= m <->
    shear_force x h <= m * normal_force x h) /\ (- steepness x h <= m <-> - shear_force x h <= m * normal_force x h).
Proof.
  intros HN. unfold steepness.
  assert (E : shear_force x h = shear_force x h / normal_force x h * normal_force x h) by (field; lra).
  set (s := shear_force x h / normal_force x h) in *. rewrite E. repeat split; intros H; nra.
Qed.

Lemma steepness_increment (h a b : R) : a < b -> (forall c, a <= c <= b -> 0 < normal_force c h) ->
  exists c, a < c < b /\ 0 < normal_force c h ^ 2 /\
    steepness b h - steepness a h = (h * (1 - h) - c ^ 2) / normal_force c h ^ 2 * (b - a).
Proof.
  intros Hab HN.
  destruct (MVT_cor2 (fun x => steepness x h)
              (fun x => (h * (1 - h) - x ^ 2) / normal_force x h ^ 2) a b Hab) as (c & Hc & Hin).
  { intros c Hc. apply is_derive_Reals, derivative_of_steepness, Rgt_not_eq, HN, Hc. }
  exists c. repeat split; try easy. apply pow_lt, HN. lra.
Qed.

(** [T/N] grows from the crown to [beta_s], *)
Theorem steepness_grows_before_beta_s (h a b : R) :
  0 < h <= 1 -> 0 <= a -> a < b -> b <= beta_s h -> steepness a h < steepness b h.
Proof.
  intros Hh Ha Hab Hb. assert (Hsq := beta_s_square h ltac:(lra)).
  assert (Hhalf := beta_s_at_most_one_half h ltac:(lra)). assert (HPI := PI2_3_2).
  destruct (steepness_increment h a b Hab) as (c & Hin & HN & Hc);
    [intros c Hc; apply normal_force_positive_to_quarter; lra |].
  assert (0 < (h * (1 - h) - c ^ 2) / normal_force c h ^ 2) by positive. nra.
Qed.

(** and falls from [beta_s] to the shoulder. *)
Theorem steepness_falls_after_beta_s (h alpha a b : R) : 0 < h <= 1 -> alpha <= PI -> 0 < normal_force alpha h ->
  beta_s h <= a -> a < b -> b <= alpha -> steepness b h < steepness a h.
Proof.
  intros Hh Halpha HNalpha Ha Hab Hb. assert (Hsq := beta_s_square h ltac:(lra)).
  assert (0 <= beta_s h) by apply sqrt_pos.
  destruct (steepness_increment h a b Hab) as (c & Hin & HN & Hc);
    [intros c Hc; apply (normal_force_positive alpha); lra |].
  assert (0 < - (h * (1 - h) - c ^ 2) / normal_force c h ^ 2) by positive. unfold Rdiv in *. nra.
Qed.

(** So [beta_s] is the only joint of the half arch where [T/N] is largest. *)
Theorem steepest_joint (h alpha beta : R) : 0 < h <= 1 -> alpha <= PI -> 0 < normal_force alpha h ->
  beta_s h <= alpha -> 0 <= beta <= alpha -> beta <> beta_s h -> steepness beta h < steepness (beta_s h) h.
Proof.
  intros Hh Ha HN Hs Hb Hne. destruct (Rtotal_order beta (beta_s h)) as [H | [H | H]]; [|easy|];
    [apply steepness_grows_before_beta_s | apply (steepness_falls_after_beta_s h alpha)]; lra.
Qed.

(** If the arch ends before [beta_s] the shoulder is where [T/N] is largest. *)
Theorem steepest_joint_of_short_arch (h alpha beta : R) :
  0 < h <= 1 -> alpha <= beta_s h -> 0 <= beta < alpha -> steepness beta h < steepness alpha h.
Proof. intros Hh Ha Hb. apply steepness_grows_before_beta_s; lra. Qed.

(** ** (18) *)

(** The printed quotient is [T/N] where [beta^2 = h (1-h)]. *)
Theorem inner_friction_from_statics (beta h : R) : beta <> 0 -> h <> 0 -> beta ^ 2 = h * (1 - h) ->
  normal_force beta h <> 0 -> mu_inner beta h = steepness beta h.
Proof.
  intros Hb Hh Hsq HN.
  assert (Hdenominator : h * ((1 - h) * sin beta + beta * cos beta) = beta * normal_force beta h).
  { unfold normal_force. transitivity (h * beta * cos beta + h * (1 - h) * sin beta); [|rewrite <- Hsq]; ring. }
  assert (Hnumerator : h * ((1 - h) * cos beta - beta * sin beta) = beta * shear_force beta h).
  { unfold shear_force. transitivity (h * (1 - h) * cos beta - h * beta * sin beta); [|rewrite <- Hsq]; ring. }
  assert (HD : (1 - h) * sin beta + beta * cos beta <> 0).
  { intros H. rewrite H, Rmult_0_r in Hdenominator. apply eq_sym in Hdenominator. contradict Hdenominator. nonzero. }
  unfold mu_inner, steepness.
  transitivity (beta * shear_force beta h / (beta * normal_force beta h));
    [rewrite <- Hnumerator, <- Hdenominator|]; field; auto.
Qed.

Theorem mu_is_from_statics (h : R) : 0 < h < 1 -> mu_is h = steepness (beta_s h) h.
Proof.
  intros Hh. apply inner_friction_from_statics; [apply Rgt_not_eq, beta_s_positive, Hh | lra
    | apply beta_s_square; lra | apply Rgt_not_eq, normal_force_at_beta_s_positive; lra].
Qed.

(** No inner joint slides exactly for a friction of at least (18). *)
Theorem no_inner_sliding (h alpha mu : R) : 0 < h < 1 -> alpha <= PI -> 0 < normal_force alpha h ->
  beta_s h <= alpha -> (forall beta, 0 <= beta <= alpha -> shear_force beta h <= mu * normal_force beta h) <->
  mu_is h <= mu.
Proof.
  intros Hh Ha HN Hs. rewrite mu_is_from_statics by easy. assert (Hs0 : 0 <= beta_s h) by apply sqrt_pos. split.
  - intros H. apply steepness_at_most; [apply normal_force_at_beta_s_positive | apply H]; lra.
  - intros Hmu beta Hb. assert (HNb : 0 < normal_force beta h) by (apply (normal_force_positive alpha); lra).
    apply steepness_at_most; [easy|]. destruct (Req_dec beta (beta_s h)) as [-> | Hne]; [easy|].
    assert (steepness beta h < steepness (beta_s h) h) by (apply (steepest_joint h alpha); lra). lra.
Qed.

(** Of all joints only the shoulder can slide outwards, from the friction (17) downwards. *)
Theorem no_outward_sliding (h alpha mu : R) : 0 < h < 1 -> 0 <= alpha <= PI -> 0 < normal_force alpha h -> 0 <= mu ->
  (forall beta, 0 <= beta <= alpha -> - shear_force beta h <= mu * normal_force beta h) <-> mu_ss alpha h <= mu.
Proof.
  intros Hh Ha HN Hmu. rewrite shoulder_friction_from_statics. split.
  - intros H. apply steepness_at_most; [easy|]. apply H; lra.
  - intros Hshoulder beta Hb. assert (HNb : 0 < normal_force beta h) by (apply (normal_force_positive alpha); lra).
    apply steepness_at_most; [easy|]. destruct (Rle_lt_dec beta (beta_s h)) as [Hbefore | Hafter].
    + (* not below the crown, where T = 0 *)
      assert (Hcrown : steepness 0 h = 0).
      { unfold steepness, shear_force. rewrite sin_0, !Rmult_0_l, Rmult_0_r. lra. }
      destruct (Req_dec beta 0) as [-> | Hne]; [lra|].
      assert (steepness 0 h < steepness beta h) by (apply steepness_grows_before_beta_s; lra). lra.
    + (* not below the shoulder *)
      destruct (Req_dec beta alpha) as [-> | Hne]; [easy|].
      assert (steepness alpha h < steepness beta h) by (apply (steepness_falls_after_beta_s h alpha); lra). lra.
Qed.

(** *** More thrust, less inner sliding *)

Theorem steepness_falls_with_thrust (beta h1 h2 : R) : 0 < beta -> h1 < h2 -> 0 < normal_force beta h1 ->
  0 < normal_force beta h2 -> steepness beta h2 < steepness beta h1.
Proof.
  intros Hb Hh H1 H2.
  assert (E : steepness beta h1 - steepness beta h2
              = beta * (h2 - h1) / (normal_force beta h1 * normal_force beta h2)).
  { unfold steepness, shear_force, normal_force in *.
    transitivity (beta * (h2 - h1) * (sin beta ^ 2 + cos beta ^ 2)
                  / ((h1 * cos beta + beta * sin beta) * (h2 * cos beta + beta * sin beta)));
      [field; lra | rewrite circle; field; lra]. }
  assert (0 < beta * (h2 - h1) / (normal_force beta h1 * normal_force beta h2)) by positive. lra.
Qed.

(** The friction (18) falls strictly: a smaller thrust needs more friction. *)
Theorem mu_is_strictly_decreasing (h1 h2 : R) : 0 < h1 -> h1 < h2 -> h2 < 1 -> mu_is h2 < mu_is h1.
Proof.
  intros H1 H12 H2. rewrite !mu_is_from_statics by lra. assert (HPI := PI2_3_2).
  assert (Hhalf1 := beta_s_at_most_one_half h1 ltac:(lra)). assert (Hhalf2 := beta_s_at_most_one_half h2 ltac:(lra)).
  assert (Hpos := beta_s_positive h2 ltac:(lra)).
  assert (HN : forall h, 0 < h -> 0 < normal_force (beta_s h2) h)
    by (intros h Hh; apply normal_force_positive_to_quarter; lra). apply Rlt_le_trans with (steepness (beta_s h2) h1).
  - apply steepness_falls_with_thrust; try easy; apply HN; lra.
  - destruct (Req_dec (beta_s h2) (beta_s h1)) as [-> | Hne]; [lra|].
    apply Rlt_le, (steepest_joint h1 (PI / 2)); try easy; try lra. apply normal_force_positive_to_quarter; lra.
Qed.

Lemma mu_is_injective (h1 h2 : R) : 0 < h1 < 1 -> 0 < h2 < 1 -> mu_is h1 = mu_is h2 -> h1 = h2.
Proof.
  intros H1 H2 E. destruct (Rtotal_order h1 h2) as [H | [H | H]]; [exfalso | easy | exfalso];
    apply mu_is_strictly_decreasing in H; lra.
Qed.
