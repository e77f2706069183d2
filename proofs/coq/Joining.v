(** * Rotational and overturning states join with a common slope

    At the end of rotation [l] (Sec. 2.1, Fig. 4) the curve [eta(A)] of the purely rotational states continues as that
    of the purely overturning ones, (14) or (15). Here: the secants of the rotational curve from [l] tend to the slope
    of the overturning curve there, [- 9/2] for Heyman's and [- 4 sqrt 3] for Milankovitch's self-weight.

    Rotational states are taken as any sequence of solutions of (2), (4), (5) whose haunch tends to the crown and
    whose thickness tends to [eta_l]. With [s = (sin b / b - 1)/b^2] and [c = (cos b - 1)/b^2], which tend to [- 1/6]
    and [- 1/2], the cubic (7) gives the thickness and the shoulder relation gives [A] to the order [b^2]; the slope
    is the quotient of the two. Such sequences exist: every haunch near the crown has a rotational state near [l]. *)

From Coq Require Import Ranalysis5.
From Couplet Require Import Moments Cubics Overturning.

(** A purely rotational state: (2), (4) and (5) give the same thrust. *)
Definition rotational_state (delta alpha beta eta : R) : Prop :=
  h_lower delta beta eta = h_tangency delta beta eta /\
  h_lower delta beta eta = h_whole delta alpha eta.

(** ** Sine and cosine near 0 *)

Definition sine_defect (b : R) : R := (sin b / b - 1) / b ^ 2.
Definition cosine_defect (b : R) : R := (cos b - 1) / b ^ 2.

Lemma sine_by_defect (b : R) : b <> 0 -> sin b = b * (1 + b ^ 2 * sine_defect b).
Proof. intros Hb. unfold sine_defect. field. easy. Qed.

Lemma cosine_by_defect (b : R) : b <> 0 -> cos b = 1 + b ^ 2 * cosine_defect b.
Proof. intros Hb. unfold cosine_defect. field. easy. Qed.

(** Taylor's bounds. *)
Lemma sine_defect_bounds (b : R) : 0 < b <= 1 -> - 1 / 6 <= sine_defect b <= - 1 / 6 + b ^ 2 / 120.
Proof.
  intros Hb. assert (HPI := PI2_3_2). destruct (sin_bound b 0) as [Hlow Hup]; [lra | lra |].
  unfold sin_approx, sin_term in Hlow, Hup. simpl in Hlow, Hup. assert (0 < b ^ 3) by positive.
  assert (E : sine_defect b * b ^ 3 = sin b - b) by (unfold sine_defect; field; lra).
  split; apply (Rmult_le_reg_r (b ^ 3)); try easy; rewrite E; field_simplify; lra.
Qed.

Lemma cosine_defect_bounds (b : R) : 0 < b <= 1 -> - 1 / 2 <= cosine_defect b <= - 1 / 2 + b ^ 2 / 24.
Proof.
  intros Hb. assert (HPI := PI2_3_2). destruct (cos_bound b 0) as [Hlow Hup]; [lra | lra |].
  unfold cos_approx, cos_term in Hlow, Hup. simpl in Hlow, Hup. assert (0 < b ^ 2) by positive.
  assert (E : cosine_defect b * b ^ 2 = cos b - 1) by (unfold cosine_defect; field; lra).
  split; apply (Rmult_le_reg_r (b ^ 2)); try easy; rewrite E; field_simplify; lra.
Qed.

(** ** The cubic (7) near the crown *)

Lemma l_is_root (delta l : R) : l < 2 -> end_of_rotation delta l = 0 -> delta * l ^ 2 + 12 * l - 12 = 0.
Proof.
  intros Hl H.
  assert (E : end_of_rotation delta l * (6 * (2 - l)) = 12 - 12 * l - delta * l ^ 2)
    by (unfold end_of_rotation; field; lra). rewrite H in E. lra.
Qed.

(** What multiplies [b^2] in it, *)
Definition second_order (delta b x : R) : R :=
  let s := sine_defect b in let c := cosine_defect b in
  delta * s * x ^ 3 + 6 * (s + c) * x ^ 2 - 12 * c * x + b ^ 2 * s * c * (3 * x ^ 2 - 12 * x + 12).

(** beside what vanishes at [l]. *)
Lemma cubic_near_crown (delta l b x : R) : b <> 0 -> delta * l ^ 2 + 12 * l - 12 = 0 ->
  pol_eta delta (f_of b) (g_of b) (sin b) x
  = b * (x * (delta * (x + l) + 12) * (x - l) + b ^ 2 * second_order delta b x).
Proof.
  intros Hb Hroot. unfold pol_eta, f_of, g_of, second_order. cbv zeta.
  rewrite (sine_by_defect b), (cosine_by_defect b) by exact Hb. set (s := sine_defect b). set (c := cosine_defect b).
  clearbody s c.
  transitivity (b * (x * (delta * (x + l) + 12) * (x - l) + b ^ 2 *
    (delta * s * x ^ 3 + 6 * (s + c) * x ^ 2 - 12 * c * x + b ^ 2 * s * c * (3 * x ^ 2 - 12 * x + 12)) + x *
    (delta * l ^ 2 + 12 * l - 12))); [ring | rewrite Hroot; ring].
Qed.

(** ** Limits *)

Lemma limit_is (u : nat -> R) (l l' : R) : is_lim_seq u l -> l = l' -> is_lim_seq u l'.
Proof. now intros H <-. Qed.

Lemma limit_opp (u : nat -> R) (l : R) : is_lim_seq u l -> is_lim_seq (fun n => - u n) (- l).
Proof. intros H. now apply (is_lim_seq_opp u l). Qed.

(** A limit by the rules for sums, products and quotients. *)
Ltac limits :=
  eapply limit_is;
  [ repeat first
      [ eassumption
      | apply is_lim_seq_const
      | eapply limit_opp
      | eapply is_lim_seq_minus'
      | eapply is_lim_seq_plus'
      | eapply is_lim_seq_div'
      | eapply is_lim_seq_mult' ]
  | ].

Section Near_the_crown.

Variables (b : nat -> R).
Hypotheses (b_positive : forall n, 0 < b n) (b_to_crown : is_lim_seq b 0).

Lemma b_eventually_small : eventually (fun n => 0 < b n <= 1).
Proof.
  apply is_lim_seq_spec in b_to_crown. destruct (b_to_crown (mkposreal 1 Rlt_0_1)) as [N HN]. exists N. intros n Hn.
  specialize (HN n Hn). simpl in HN. apply Rabs_def2 in HN. specialize (b_positive n). lra.
Qed.

Lemma squeezed (x : R -> R) (l k : R) : (forall t, 0 < t <= 1 -> l <= x t <= l + t ^ 2 / k) -> k <> 0 ->
  is_lim_seq (fun n => x (b n)) l.
Proof.
  intros Hx Hk. apply (is_lim_seq_le_le_loc (fun _ => l) _ (fun n => l + b n * b n / k)).
  - destruct b_eventually_small as [N HN]. exists N. intros n Hn. replace (b n * b n) with (b n ^ 2) by ring.
    now apply Hx, HN.
  - apply is_lim_seq_const.
  - limits. field. easy.
Qed.

Lemma sine_defect_limit : is_lim_seq (fun n => sine_defect (b n)) (- 1 / 6).
Proof. apply (squeezed sine_defect _ 120); [exact sine_defect_bounds | lra]. Qed.

Lemma cosine_defect_limit : is_lim_seq (fun n => cosine_defect (b n)) (- 1 / 2).
Proof. apply (squeezed cosine_defect _ 24); [exact cosine_defect_bounds | lra]. Qed.

(** ** The rotational curve to the order [b^2] *)

Variables (delta l : R) (alpha eta : nat -> R).
Hypotheses (haunch_in_arch : forall n, b n < PI) (thickness_in_arch : forall n, 0 < eta n < 2)
  (states : forall n, rotational_state delta (alpha n) (b n) (eta n)) (delta_not_negative : 0 <= delta)
  (l_in_arch : 0 < l < 2) (l_ends_rotation : end_of_rotation delta l = 0) (eta_to_l : is_lim_seq eta l).

(** What [eta] and [A] grow with [b^2]. *)
Let eta_rate : R := (delta * l ^ 2 / 6 + 4 * l - 6) / (2 * delta * l + 12).
Let A_rate : R := - (1 / 3) * ((2 - l) / (2 + l)) - 8 * eta_rate / (2 + l) ^ 2.

Lemma thickness_to_second_order (n : nat) :
  let s := sine_defect (b n) in let c := cosine_defect (b n) in
  (eta n - l) / (b n * b n)
  = - (delta * s * eta n * eta n * eta n + 6 * (s + c) * eta n * eta n - 12 * c * eta n
       + b n * b n * s * c * (3 * eta n * eta n - 12 * eta n + 12))
    / (eta n * (delta * (eta n + l) + 12)).
Proof.
  intros s c. specialize (b_positive n). specialize (haunch_in_arch n). specialize (thickness_in_arch n).
  destruct (states n) as [H25 _]. apply cubic_in_thickness_in_the_arch in H25; [|lra|lra].
  rewrite (cubic_near_crown delta l) in H25; [|lra | apply l_is_root; lra]. unfold second_order in H25.
  cbv zeta in H25. fold s c in H25. clearbody s c. set (x := eta n) in *. set (t := b n) in *.
  assert (HD : delta * (x + l) + 12 <> 0) by (assert (0 <= delta * (x + l)) by positive; lra).
  apply Rmult_integral in H25. destruct H25 as [H25 | H25]; [lra|].
  apply (Rmult_eq_reg_r (t ^ 2 * (x * (delta * (x + l) + 12)))); [|nonzero].
  transitivity (x * (delta * (x + l) + 12) * (x - l)); [field; lra|].
  transitivity (- (t ^ 2 * (delta * s * x ^ 3 + 6 * (s + c) * x ^ 2 - 12 * c * x
                     + t ^ 2 * s * c * (3 * x ^ 2 - 12 * x + 12)))); [lra|]. field. split; [easy | lra].
Qed.

Lemma eta_rate_limit : is_lim_seq (fun n => (eta n - l) / (b n * b n)) eta_rate.
Proof.
  assert (Hs := sine_defect_limit). assert (Hc := cosine_defect_limit). assert (0 < 2 * delta * l + 12).
  { assert (0 <= delta * l) by positive. lra. }
  eapply is_lim_seq_ext; [intros n; symmetry; apply thickness_to_second_order|]. unfold eta_rate. limits;
    [apply Rmult_integral_contrapositive_currified; lra | field; lra].
Qed.

(** [A] from the shoulder relation. *)
Lemma opening_to_second_order (n : nat) :
  let s := sine_defect (b n) in let c := cosine_defect (b n) in
  1 + b n * b n * s <> 0 ->
  (A (alpha n) - 2 * ((2 - l) / (2 + l))) / (b n * b n)
  = (c - s + b n * b n * s * c) / (1 + b n * b n * s) * ((2 - eta n) / (2 + eta n))
    - 8 * ((eta n - l) / (b n * b n)) / ((2 + eta n) * (2 + l)).
Proof.
  intros s c Hsinc. specialize (b_positive n). specialize (haunch_in_arch n). specialize (thickness_in_arch n).
  destruct (states n) as [H25 H24]. assert (HS : sin (b n) <> 0) by positive.
  assert (HA : A (alpha n) * sin (b n) * (2 + eta n) = g_of (b n) * (2 - eta n)).
  { apply (shoulder_relation delta _ _ _ (h_lower delta (b n) (eta n))); try easy; try lra.
    apply Rgt_not_eq, lever_of_lower_thrust_positive; lra. }
  unfold g_of in HA. rewrite (sine_by_defect (b n)), (cosine_by_defect (b n)) in HA by lra. fold s c in HA.
  assert (EA : A (alpha n) = (b n + b n * (1 + b n ^ 2 * s) * (1 + b n ^ 2 * c)) * (2 - eta n)
                             / (b n * (1 + b n ^ 2 * s) * (2 + eta n))).
  { apply equals_quotient; [|lra]. replace (1 + b n ^ 2 * s) with (1 + b n * b n * s) by ring. nonzero. }
  rewrite EA. clearbody s c. field. repeat split; lra.
Qed.

Lemma A_rate_limit : is_lim_seq (fun n => (A (alpha n) - 2 * ((2 - l) / (2 + l))) / (b n * b n)) A_rate.
Proof.
  assert (Hs := sine_defect_limit). assert (Hc := cosine_defect_limit). assert (Hrate := eta_rate_limit).
  eapply is_lim_seq_ext_loc.
  - destruct b_eventually_small as [N HN]. exists N. intros n Hn. symmetry. apply opening_to_second_order.
    specialize (HN n Hn). assert (Hbounds := sine_defect_bounds (b n) HN). nra.
  - unfold A_rate. limits; [lra | lra | nra | field; lra].
Qed.

Lemma quotient_of_rates (x y t : R) : t <> 0 -> (x / t) / (y / t) = x / y.
Proof.
  intros Ht. destruct (Req_dec y 0) as [-> | Hy]; [|field; auto]. unfold Rdiv. rewrite Rmult_0_l, Rinv_0. ring.
Qed.

(** The slope of the secants. *)
Theorem secant_slopes_of_rotation : A_rate <> 0 ->
  is_lim_seq (fun n => (eta n - l) / (A (alpha n) - 2 * ((2 - l) / (2 + l)))) (eta_rate / A_rate).
Proof.
  intros HA. assert (Heta := eta_rate_limit). assert (Hopening := A_rate_limit).
  apply (is_lim_seq_ext (fun n => ((eta n - l) / (b n * b n))
           / ((A (alpha n) - 2 * ((2 - l) / (2 + l))) / (b n * b n)))).
  - intros n. specialize (b_positive n). apply quotient_of_rates, Rgt_not_eq. nra.
  - limits. reflexivity.
Qed.

End Near_the_crown.

(** ** The common slopes *)

(** Heyman: [- 9/2], the slope of (14) ([slope_at_l_heyman]). *)
Theorem rotation_joins_overturning_heyman (alpha b eta : nat -> R) : (forall n, 0 < b n < PI) ->
  (forall n, 0 < eta n < 2) -> (forall n, rotational_state 0 (alpha n) (b n) (eta n)) -> is_lim_seq b 0 ->
  is_lim_seq eta 1 -> is_lim_seq (fun n => (eta n - 1) / (A (alpha n) - 2 / 3)) (- 9 / 2) /\
  is_derive eta_heyman (2 / 3) (- 9 / 2).
Proof.
  intros Hb He Hstates Hb0 He1. split; [|exact slope_at_l_heyman].
  assert (Hl : end_of_rotation 0 1 = 0) by (apply end_of_rotation_heyman; lra).
  eapply limit_is; [eapply is_lim_seq_ext; [|apply (secant_slopes_of_rotation b ltac:(apply Hb) Hb0 0 1 alpha eta
    ltac:(apply Hb) He Hstates ltac:(lra) ltac:(lra) Hl He1)]|].
  - intros n. cbv beta. do 2 f_equal. lra.
  - replace (_ - _) with (1 / 27) by field. lra.
  - field.
Qed.

(** Milankovitch: [- 4 sqrt 3], the slope of (15) ([slope_at_l_milankovitch]). *)
Theorem rotation_joins_overturning_milankovitch (alpha b eta : nat -> R) : (forall n, 0 < b n < PI) ->
  (forall n, 0 < eta n < 2) -> (forall n, rotational_state 1 (alpha n) (b n) (eta n)) -> is_lim_seq b 0 ->
  is_lim_seq eta eta_l_milankovitch ->
  is_lim_seq (fun n => (eta n - eta_l_milankovitch) / (A (alpha n) - (sqrt 3 - 1))) (- 4 * sqrt 3) /\
  is_derive eta_milankovitch (sqrt 3 - 1) (- 4 * sqrt 3).
Proof.
  intros Hb He Hstates Hb0 Hel. split; [|exact slope_at_l_milankovitch]. assert (Hin := eta_l_in_the_arch).
  assert (H3 := sqrt_3_square). assert (Hbounds := sqrt_3_bounds).
  assert (Hl : end_of_rotation 1 eta_l_milankovitch = 0) by (apply end_of_rotation_milankovitch; lra).
  set (l := eta_l_milankovitch) in *. assert (Hratio : (2 - l) / (2 + l) = (sqrt 3 - 1) / 2).
  { apply (Rmult_eq_reg_r (2 * (2 + l))); [|lra]. transitivity (2 * (2 - l)); [field; lra|].
    transitivity ((sqrt 3 - 1) * (2 + l)); [|field; lra]. unfold l, eta_l_milankovitch. nra. }
  assert (Heta_rate : (1 * l ^ 2 / 6 + 4 * l - 6) / (2 * 1 * l + 12) = 1 - 2 * sqrt 3 / 3).
  { apply quotient_equals; [lra|]. unfold l, eta_l_milankovitch. nra. }
  assert (HA_rate : - (1 / 3) * ((2 - l) / (2 + l)) - 8 * ((1 * l ^ 2 / 6 + 4 * l - 6) / (2 * 1 * l + 12)) / (2 + l) ^
    2 = 1 / 6 - sqrt 3 / 12).
  { rewrite Hratio, Heta_rate. replace ((2 + l) ^ 2) with (64 - 32 * sqrt 3) by (unfold l, eta_l_milankovitch; nra).
    apply (Rmult_eq_reg_r (64 - 32 * sqrt 3)); [|lra]. field_simplify; [|lra]. nra. }
  eapply limit_is; [eapply is_lim_seq_ext; [|apply (secant_slopes_of_rotation b ltac:(apply Hb) Hb0 1 l alpha eta
    ltac:(apply Hb) He Hstates ltac:(lra) ltac:(lra) Hl Hel)]|].
  - intros n. cbv beta. rewrite Hratio. do 2 f_equal. lra.
  - rewrite HA_rate. lra.
  - rewrite HA_rate, Heta_rate. apply quotient_equals; [lra | nra].
Qed.

(** ** There are such states

    Near the crown each haunch has a rotational state with a thickness near [eta_l], for both
    self-weights and any mixture of them, so that the two theorems above are not empty. *)

Lemma second_order_bounded (delta b x : R) : 0 <= delta <= 1 -> 0 < b <= 1 -> 0 <= x <= 2 ->
  - 42 <= second_order delta b x <= 42.
Proof.
  intros Hd Hb Hx. unfold second_order. cbv zeta. assert (0 <= b ^ 2 <= 1) by (simpl; nra).
  assert (Hs := sine_defect_bounds b Hb). assert (Hc := cosine_defect_bounds b Hb). set (s := sine_defect b) in *.
  set (c := cosine_defect b) in *. assert (- 1 / 6 <= s <= 0) by lra. assert (- 1 / 2 <= c <= 0) by lra.
  set (t := b ^ 2) in *. clearbody s c t. clear Hs Hc Hb. assert (0 <= x ^ 2 <= 4) by (simpl; nra).
  assert (0 <= x ^ 3 <= 8) by (simpl in *; nra). assert (0 <= delta * x ^ 3 <= 8) by nra.
  assert (- 2 <= s * (delta * x ^ 3) <= 0) by nra. assert (- 16 <= 6 * (s + c) * x ^ 2 <= 0) by nra.
  assert (0 <= - 12 * c * x <= 12) by nra. assert (0 <= 3 * x ^ 2 - 12 * x + 12 <= 12) by (split; nra).
  set (q := 3 * x ^ 2 - 12 * x + 12) in *. assert (0 <= s * c <= 1 / 12) by nra.
  assert (0 <= t * (s * c) <= 1 / 12) by nra. assert (0 <= t * (s * c) * q <= 1) by nra.
  replace (delta * s * x ^ 3) with (s * (delta * x ^ 3)) by ring.
  replace (t * s * c * q) with (t * (s * c) * q) by ring. lra.
Qed.

Theorem rotational_states_near_the_end (delta l eps : R) : 0 <= delta <= 1 -> 0 < l < 2 ->
  end_of_rotation delta l = 0 -> 0 < eps -> exists b0, 0 < b0 /\ forall b, 0 < b < b0 ->
  exists alpha eta, 0 < alpha < PI /\ 0 < eta < 2 /\ Rabs (eta - l) < eps /\ rotational_state delta alpha b eta.
Proof.
  intros Hd Hl Hend Heps. assert (Hroot := l_is_root delta l (proj2 Hl) Hend). assert (Hl9 : 9 / 10 < l <= 1) by nra.
  set (e := Rmin (eps / 2) (1 / 10)). assert (He : 0 < e) by (apply Rmin_pos; lra).
  assert (He1 := Rmin_l (eps / 2) (1 / 10)). assert (He2 := Rmin_r (eps / 2) (1 / 10)). fold e in He1, He2.
  exists (e / 10). split; [lra|]. intros b Hb. assert (Hb1 : 0 < b <= 1) by lra. assert (HPI := PI2_3_2).
  (* the thickness: the cubic changes its sign between l - e and l + e *)
  set (P := fun x => pol_eta delta (f_of b) (g_of b) (sin b) x).
  assert (HP : forall x, l - e <= x <= l + e -> exists F, 8 <= F /\
    - (e / 2) < P x / b - F * (x - l) < e / 2).
  { intros x Hx. exists (x * (delta * (x + l) + 12)). assert (0 <= delta * (x + l)) by positive. split; [nra|].
    assert (Hbound := second_order_bounded delta b x Hd Hb1 ltac:(lra)). assert (0 < b ^ 2 < e / 100) by (simpl; nra).
    unfold P. rewrite (cubic_near_crown delta l) by lra.
    replace (_ / b - _) with (b ^ 2 * second_order delta b x) by (field; lra). nra. }
  assert (Hsign : forall x, P x / b * b = P x) by (intros; field; lra).
  destruct (IVT P (l - e) (l + e)) as (eta & Heta & Hzero).
  - unfold P, pol_eta. reg.
  - lra.
  - destruct (HP (l - e)) as (F & HF & H); [lra|]. assert (P (l - e) / b < 0) by nra. rewrite <- Hsign. nra.
  - destruct (HP (l + e)) as (F & HF & H); [lra|]. assert (P (l + e) / b > 0) by nra. rewrite <- Hsign. nra.
  - (* the half-angle *)
    assert (HS : 0 < sin b) by positive. assert (Hg := g_positive b ltac:(lra)). assert (Hsin : 5 / 6 * b <= sin b).
    { rewrite (sine_by_defect b) by lra. assert (H := sine_defect_bounds b Hb1).
      assert (- 1 / 6 <= b ^ 2 * sine_defect b) by (simpl; nra). nra. }
    assert (HgS : g_of b <= 11 / 5 * sin b) by (unfold g_of; destruct (COS_bound b); nra).
    set (v := g_of b * (2 - eta) / (sin b * (2 + eta))).
    assert (Hv : v * (sin b * (2 + eta)) = g_of b * (2 - eta)) by (unfold v; field; lra).
    assert (0 < sin b * (2 + eta)) by positive.
    destruct (half_opening v (PI / 2) PI) as (alpha & Halpha & HA & _); try lra.
    + apply Rle_lt_trans with (3 / 2); [|unfold A; rewrite sin_PI2, cos_PI2; lra].
      apply (Rmult_le_reg_r (sin b * (2 + eta))); [easy|]. rewrite Hv. nra.
    + unfold A. rewrite sin_PI. replace (_ / _) with 0 by (unfold Rdiv; ring). nra.
    + apply cubic_in_thickness_in_the_arch in Hzero; [|lra..]. exists alpha, eta. repeat split; try lra.
      * apply Rabs_def1; lra.
      * apply (shoulder_relation delta alpha b eta (h_lower delta b eta)); try easy; try lra;
          [apply Rgt_not_eq, lever_of_lower_thrust_positive; lra | rewrite HA; lra].
Qed.
