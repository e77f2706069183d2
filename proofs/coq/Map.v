(** * The map of the modes, by columns and by rows

    A mode moves an arch if one of its admissible states has the joints of that mode at their limits. Where nothing
    wider stands one moves. At a given friction the modes follow each other as the thickness grows, each on an interval
    or not at all, and at a given half-angle as the friction does. Two things are asked of numbers, which balls prove
    for the claims: that the friction of the shoulder grows along the rotational states, and for the rows that an inner
    joint slides at a thrust of at most 1/2 where the shoulder turns, and that no half-angle has both this and
    [[s,r,r]]. *)

From Coq Require Import Lia Compare_dec Classical.
From Couplet Require Import Overturning Room Modes Attained Order.

(** In the tube of a piece there is one solution at each value of the parameter. *)
Definition piece (point : Type) (solves : R -> point -> Prop) (a b : R) (tube : R -> point -> Prop) : Prop :=
  forall t, a <= t <= b -> exists! x, tube t x /\ solves t x.

(** Two pieces of which the second goes on with the solution at the end of the first are one, and so any number is. *)
Theorem pieces_are_one (point : Type) (solves : R -> point -> Prop) (a b c : R) (first next : R -> point -> Prop) :
  piece point solves a b first -> piece point solves b c next -> (forall x, first b x -> solves b x -> next b x) ->
  piece point solves a c (fun t x => (t <= b /\ first t x) \/ (b <= t /\ next t x)).
Proof.
  intros Hfirst Hnext Hnode t Ht. destruct (Rle_lt_dec t b) as [Hle | Hlt].
  - destruct (Hfirst t ltac:(lra)) as (x & (Hx & Hs) & Honly). exists x. split; [now split; [left |] |].
    intros y [[(_ & Hy) | (Hge & Hy)] Hys]; [now apply Honly |]. assert (E : t = b) by lra. subst t.
    destruct (Hnext b ltac:(lra)) as (z & _ & Hz). rewrite <- (Hz y (conj Hy Hys)). symmetry. apply Hz.
    split; [now apply Hnode | easy].
  - destruct (Hnext t ltac:(lra)) as (x & (Hx & Hs) & Honly). exists x.
    split; [split; [right; split; lra || easy | easy] |]. intros y [[(H & _) | (_ & Hy)] Hys]; [lra | now apply Honly].
Qed.

Inductive mode := RRR | SRR | RRS | RSR | RS | SS.

(** The limits of each mode in a state, with its haunch and the joint that slides inwards. *)
Definition has_limits (delta alpha eta mu h p beta sigma : R) (m : mode) : Prop :=
  match m with
  | RRR => 0 < beta < alpha /\ crown_gap eta h p = 0 /\ haunch_gap delta beta eta h p = 0 /\
           shoulder_gap delta alpha eta h p = 0
  | SRR => 0 < beta < alpha /\ crown_gap eta h p = 0 /\ haunch_gap delta beta eta h p = 0 /\
           outward_gap alpha mu h = 0
  | SS => 0 < sigma < alpha /\ inward_gap sigma mu h = 0 /\ outward_gap alpha mu h = 0
  | RRS | RSR | RS =>
      0 < sigma < alpha /\ inward_gap sigma mu h = 0 /\
      0 <= beta < alpha /\ haunch_gap delta beta eta h p = 0 /\ shoulder_gap delta alpha eta h p = 0 /\
      match m with
      | RRS => sigma <= beta
      | RSR => 0 < beta <= sigma
      | _ => beta = 0
      end
  end.

Definition mode_moves (delta alpha eta mu : R) (m : mode) : Prop :=
  exists h p beta sigma, admissible_state delta alpha eta mu h p /\
    has_limits delta alpha eta mu h p beta sigma m.

(** A state that moves is moved by a mode. *)
Theorem a_mode_moves (delta alpha eta mu h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 -> 0 < mu ->
  admissible_state delta alpha eta mu h p -> state_moves delta alpha eta mu h p ->
  exists m, mode_moves delta alpha eta mu m.
Proof.
  intros Hd Ha He Hmu Hstate (beta & sigma & u & l & v & s & t & Hb & Hs & Hsome & Hmoves).
  destruct (sum_of_modes Hstate Hd Ha He Hmu beta sigma u l v s t Hb Hs Hmoves)
    as (x1 & x2 & x3 & x4 & P1 & P2 & P3 & P4 & Eu & Ev & Es & Et & El & Harm & Harm' & B12 & B3 & S34 & Hsum).
  specialize (Hsum Hsome). destruct Hmoves as ((Hu & Hl & Hv & Hs0 & Ht) & _ & HC & HL & HU & HI & HO).
  assert (Hrate : forall k g x, 0 <= k -> g * k = x -> 0 < x -> 0 < k)
    by (intros k g x Hk E Hx; destruct (Req_dec k 0) as [Z | Z]; [rewrite Z in E|]; lra).
  assert (Hzero : forall k g, 0 < k -> k * g = 0 -> g = 0) by (intros k g Hk E; apply (Rmult_eq_reg_l k); lra).
  assert (Hgive : forall m, has_limits delta alpha eta mu h p beta sigma m -> exists m,
    mode_moves delta alpha eta mu m) by (intros m Hm; exists m, h, p, beta, sigma; now split).
  destruct (Rlt_dec 0 x1) as [H1 | H1].
  { assert (U0 := Hrate u _ _ Hu Eu ltac:(lra)). assert (V0 := Hrate v _ _ Hv Ev ltac:(lra)). apply (Hgive RRR).
    simpl. split; [apply B12; now left|]. split; [now apply (Hzero u)|].
    split; [apply (Hzero l); lra | now apply (Hzero v)]. }
  destruct (Rlt_dec 0 x2) as [H2 | H2].
  { assert (U0 := Hrate u _ _ Hu Eu ltac:(lra)). assert (T0 := Hrate t _ _ Ht Et ltac:(lra)). apply (Hgive SRR).
    simpl. split; [apply B12; now right|]. split; [now apply (Hzero u)|].
    split; [apply (Hzero l); lra | now apply (Hzero t)]. }
  destruct (Rlt_dec 0 x3) as [H3 | H3].
  { assert (S0 := Hrate s _ _ Hs0 Es ltac:(lra)). assert (V0 := Hrate v _ _ Hv Ev ltac:(lra)).
    assert (EI := Hzero s _ S0 HI). assert (EU := Hzero v _ V0 HU). assert (EL := Hzero l _ ltac:(lra) HL).
    assert (S34' := S34 (or_introl H3)). assert (B3' := B3 H3).
    destruct (Rle_lt_dec sigma beta) as [Hhigh | Hlow]; [apply (Hgive RRS); simpl; repeat split; easy || lra|].
    destruct (Req_dec beta 0) as [E | E]; [apply (Hgive RS) | apply (Hgive RSR)]; simpl; repeat split; easy || lra. }
  assert (S0 := Hrate s _ _ Hs0 Es ltac:(lra)). assert (T0 := Hrate t _ _ Ht Et ltac:(lra)). apply (Hgive SS). simpl.
  split; [apply S34; right; lra|]. split; [now apply (Hzero s) | now apply (Hzero t)].
Qed.

(** With its thrust kept a state has the line of thrust on both faces, or there is one off both. *)
Lemma on_both_faces_or_off (delta alpha eta mu h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 ->
  0 < mu -> admissible_state delta alpha eta mu h p -> (exists beta, 0 <= beta <= alpha /\
    haunch_gap delta beta eta h p = 0 /\ (shoulder_gap delta 0 eta h p = 0 \/
    shoulder_gap delta alpha eta h p = 0)) \/ (exists p', forall x, 0 <= x <= alpha ->
    0 < shoulder_gap delta x eta h p' /\ 0 < haunch_gap delta x eta h p').
Proof.
  intros Hd Ha He Hmu Hstate. destruct (margins_continuous delta eta mu h p) as (CU & CL & _).
  assert (Hgaps : forall x, 0 <= x <= alpha -> 0 <= shoulder_gap delta x eta h p /\ 0 <= haunch_gap delta x eta h p).
  { intros x Hx. destruct (margins_not_negative Hstate x Hx) as (A & B & _). lra. }
  assert (Hmoved : forall x t, shoulder_gap delta x eta h (p + t) = shoulder_gap delta x eta h p - t /\
                               haunch_gap delta x eta h (p + t) = haunch_gap delta x eta h p + t)
    by (intros x t; unfold shoulder_gap, haunch_gap; lra).
  assert (Hway : forall f g : R -> R, continuity f -> continuity g -> (forall x, 0 <= x <= alpha -> 0 <= f x) ->
    (forall x, 0 <= x <= alpha -> 0 <= g x) -> (forall x, 0 <= x <= alpha -> g x <> 0) -> exists e, 0 < e /\ forall x,
    0 <= x <= alpha -> 0 < f x + e /\ 0 < g x - e).
  { intros f g Hf Hg Hpf Hpg Hne.
    destruct (positive_in_direction 0 alpha g (fun _ => -1)) as (e & He' & H); try easy; try lra.
    { intros x. apply continuity_pt_const. now intros u v. }
    { intros x Hx E. now destruct (Hne x Hx). }
    exists e. split; [easy|]. intros x Hx. assert (A := Hpf x Hx). assert (B := H e ltac:(lra) x Hx). lra. }
  destruct (classic (exists x, 0 <= x <= alpha /\ shoulder_gap delta x eta h p = 0))
    as [(x & Hx & EU) | Hoff].
  - destruct (classic (exists y, 0 <= y <= alpha /\ haunch_gap delta y eta h p = 0))
      as [(y & Hy & EL) | Hoff].
    + left. exists y. split; [easy | split; [easy|]].
      destruct (extrados_reached Hstate Hd Ha He x Hx EU) as [-> | ->]; tauto.
    + right. destruct (Hway _ _ CU CL (fun z Hz => proj1 (Hgaps z Hz)) (fun z Hz => proj2 (Hgaps z Hz)))
        as (e & He' & H); [intros z Hz E; apply Hoff; now exists z |].
      exists (p + - e). intros z Hz. destruct (Hmoved z (- e)) as (-> & ->). destruct (H z Hz). lra.
  - right. destruct (Hway _ _ CL CU (fun z Hz => proj2 (Hgaps z Hz)) (fun z Hz => proj1 (Hgaps z Hz)))
      as (e & He' & H); [intros z Hz E; apply Hoff; now exists z |].
    exists (p + e). intros z Hz. destruct (Hmoved z e) as (-> & ->). destruct (H z Hz). lra.
Qed.

(** So where none thinner stands it is not pure sliding alone that moves. *)
Theorem a_hinge_at_the_least_thickness (delta alpha eta mu h p : R) : 0 <= delta <= 1 -> 0 < alpha < PI ->
  0 < eta <= 2 -> 0 < mu -> (forall eta', 0 < eta' < eta -> ~ arch_stands delta alpha eta' mu) ->
  admissible_state delta alpha eta mu h p -> exists m, m <> SS /\ mode_moves delta alpha eta mu m.
Proof.
  intros Hd Ha He Hmu Hnone Hstate.
  destruct (a_mode_moves delta alpha eta mu h p Hd Ha He Hmu Hstate
              (moves_if_none_thinner delta alpha eta mu h p Hd Ha He Hmu Hnone Hstate)) as (m & Hm).
  destruct m; try (eexists; split; [|exact Hm]; easy). clear h p Hstate.
  destruct Hm as (h & p & beta0 & sigma & Hstate & Hs & EI & EO).
  destruct (on_both_faces_or_off delta alpha eta mu h p Hd Ha He Hmu Hstate)
    as [(beta & Hb & EL & Hface) | (p' & Hoff)].
  - assert (Hshoulder : beta <> alpha).
    { intros E. rewrite E in EL. now apply (intrados_free_at_sliding_shoulder Hstate Hd Ha He Hmu EO). }
    destruct Hface as [EC | EU].
    + exists SRR. split; [easy|]. exists h, p, beta, sigma. split; [easy|]. simpl. assert (Hcrown : beta <> 0).
      { intros E. rewrite E in EL. now apply (not_at_both_faces Hstate Hd Ha He Hmu 0 ltac:(lra) EC). }
      split; [lra|]. split; [|easy]. rewrite gap_at_crown in EC. lra.
    + assert (Hgive : forall m, m <> SS -> has_limits delta alpha eta mu h p beta sigma m ->
                exists m, m <> SS /\ mode_moves delta alpha eta mu m)
        by (intros m N Hm; exists m; split; [easy | exists h, p, beta, sigma; now split]).
      destruct (Rle_lt_dec sigma beta) as [Hhigh | Hlow];
        [apply (Hgive RRS); [easy|]; simpl; repeat split; easy || lra|].
      destruct (Req_dec beta 0) as [E | E]; [apply (Hgive RS) | apply (Hgive RSR)]; try easy; simpl;
        repeat split; easy || lra.
  - exfalso. destruct (thinner_arch_stands delta alpha eta mu h p' Hd ltac:(lra) He) as (eta' & He' & H).
    + intros x Hx. destruct (Hoff x Hx). destruct (margins_not_negative Hstate x Hx) as (_ & _ & A & B). easy.
    + now apply (Hnone eta').
Qed.

(** To each thickness and friction belongs one half-angle, and a mode moves it. *)
Corollary each_point_has_a_mode (delta eta mu : R) : 0 <= delta <= 1 -> 0 < eta <= 2 -> 0 < mu -> exists alpha,
  0 < alpha < PI /\ (forall alpha', 0 < alpha' <= PI -> arch_stands delta alpha' eta mu <-> alpha' <= alpha) /\
  exists m, mode_moves delta alpha eta mu m.
Proof.
  intros Hd He Hmu. destruct (one_half_angle delta eta mu Hd He Hmu) as (alpha & Ha & Hexactly & Hmoves & _).
  exists alpha. split; [easy | split; [easy|]].
  destruct (proj2 (Hexactly alpha ltac:(lra)) ltac:(lra)) as (h & p & Hstate).
  apply (a_mode_moves delta alpha eta mu h p); try easy. now apply Hmoves.
Qed.

(** ** Columns *)

Definition rank (m : mode) : nat := match m with RRR => 0 | SRR => 1 | RRS => 2 | RSR => 3 | RS => 4 | SS => 5 end.

(** The shoulder's friction grows along the rotational states. *)
Definition friction_grows (delta : R) : Prop :=
  forall alpha beta eta alpha' beta' eta', 0 < eta < eta' -> eta' < 2 ->
    0 < beta < alpha -> alpha < PI -> 0 < beta' < alpha' -> alpha' < PI ->
    rotational_state delta alpha beta eta -> rotational_state delta alpha' beta' eta' ->
    mu_ss alpha (h_lower delta beta eta) < mu_ss alpha' (h_lower delta beta' eta').

(** What the limits of a mode have in common. *)
Lemma shoulder_of_mode {delta alpha eta mu h p beta sigma : R} {m : mode} :
  has_limits delta alpha eta mu h p beta sigma m -> shoulder_at_limit delta alpha eta mu h p.
Proof. destruct m; simpl; unfold shoulder_at_limit; tauto. Qed.

Lemma slip_of_mode {delta alpha eta mu h p beta sigma : R} {m : mode} : (2 <= rank m)%nat ->
  has_limits delta alpha eta mu h p beta sigma m -> 0 < sigma <= alpha /\ inward_gap sigma mu h = 0.
Proof. destruct m; simpl; intros Hr H; lia || (split; [lra | tauto]). Qed.

Lemma crown_of_mode {delta alpha eta mu h p beta sigma : R} {m : mode} : (rank m < 2)%nat ->
  has_limits delta alpha eta mu h p beta sigma m ->
  0 < beta < alpha /\ crown_gap eta h p = 0 /\ haunch_gap delta beta eta h p = 0.
Proof. destruct m; simpl; intros Hr H; lia || tauto. Qed.

Lemma haunch_of_mode {delta alpha eta mu h p beta sigma : R} {m : mode} :
  (2 <= rank m)%nat -> (rank m < 5)%nat -> has_limits delta alpha eta mu h p beta sigma m ->
  0 <= beta < alpha /\ haunch_gap delta beta eta h p = 0 /\ shoulder_gap delta alpha eta h p = 0.
Proof. destruct m; simpl; intros Hr Hr' H; lia || tauto. Qed.

(** As the thickness grows the modes follow each other. *)
Theorem modes_of_a_column (delta mu alpha1 eta1 alpha2 eta2 : R) (m1 m2 : mode) : 0 <= delta <= 1 -> 0 < mu ->
  friction_grows delta -> 0 < alpha1 < PI -> 0 < alpha2 < PI -> 0 < eta1 -> eta1 < eta2 -> eta2 <= 2 ->
  mode_moves delta alpha1 eta1 mu m1 -> mode_moves delta alpha2 eta2 mu m2 -> (rank m1 <= rank m2)%nat.
Proof.
  intros Hd Hmu Hgrows Ha1 Ha2 He1 He He2 (h1 & p1 & b1 & s1 & S1 & L1) (h2 & p2 & b2 & s2 & S2 & L2).
  assert (Sh1 := shoulder_of_mode L1). assert (Sh2 := shoulder_of_mode L2).
  destruct (le_lt_dec 2 (rank m1)) as [R1 | R1].
  - destruct (slip_of_mode R1 L1) as [Hs1 EI1]. destruct (le_lt_dec 2 (rank m2)) as [R2 | R2].
    + destruct (slip_of_mode R2 L2) as [Hs2 EI2].
      destruct (le_lt_dec 5 (rank m2)) as [R2' | R2']; [destruct m1, m2; simpl in *; lia|].
      destruct (haunch_of_mode R2 R2' L2) as (Hb2 & EL2 & EU2). destruct (le_lt_dec 5 (rank m1)) as [R1' | R1'].
      * exfalso. destruct m1; simpl in R1'; try lia. simpl in L1.
        apply (sliding_comes_last S1 S2 Hd Ha1 ltac:(lra) Hmu Ha2 ltac:(lra) Hmu ltac:(lra) s1 s2 b2); easy || lra || tauto.
      * destruct (haunch_of_mode R1 R1' L1) as (Hb1 & EL1 & EU1).
        destruct (haunch_falls S1 S2 Hd Ha1 ltac:(lra) Hmu Ha2 ltac:(lra) Hmu ltac:(lra) ltac:(lra) s1 b1 s2 b2 Hs1 EI1 Sh1 Hs2 EI2 Sh2
                    Hb1 EL1 Hb2 EL2) as (Hfall & Hstrict & Hslip). specialize (Hstrict (or_introl He)).
        specialize (Hslip (or_intror eq_refl)). apply Nat.nlt_ge. intros Hless.
        destruct m1, m2; simpl in R1, R1', R2, R2', Hless; try lia; simpl in L1, L2; lra.
    + exfalso. destruct (crown_of_mode R2 L2) as (Hb2 & EC2 & EL2).
      destruct (crown_turns_first S1 S2 Hd Ha1 ltac:(lra) Hmu Ha2 ltac:(lra) Hmu ltac:(lra) ltac:(lra) s1 b2 Hs1 EI1 Sh1 Hb2 EC2 EL2 Sh2) as (E & _).
      lra.
  - destruct m1; simpl in R1; try lia; [simpl; lia|]. destruct m2; simpl; try lia. exfalso. simpl in L1, L2.
    apply (shoulder_turns_first delta alpha1 eta1 mu h1 p1 alpha2 eta2 mu h2 p2 b1 b2); easy || lra || tauto.
Qed.

(** So each moves on an interval or not at all. *)
Theorem intervals_of_a_column (delta mu alpha1 eta1 alpha eta alpha2 eta2 : R) (m m' : mode) : 0 <= delta <= 1 ->
  0 < mu -> friction_grows delta -> 0 < alpha1 < PI -> 0 < alpha < PI -> 0 < alpha2 < PI -> 0 < eta1 ->
  eta1 < eta < eta2 -> eta2 <= 2 -> mode_moves delta alpha1 eta1 mu m -> mode_moves delta alpha2 eta2 mu m ->
  mode_moves delta alpha eta mu m' -> m' = m.
Proof.
  intros Hd Hmu Hgrows Ha1 Ha Ha2 He1 He He2 M1 M2 M.
  assert (H1 := modes_of_a_column delta mu alpha1 eta1 alpha eta m m' Hd Hmu Hgrows Ha1 Ha He1 ltac:(lra)
      ltac:(lra) M1 M).
  assert (H2 := modes_of_a_column delta mu alpha eta alpha2 eta2 m' m Hd Hmu Hgrows Ha Ha2 ltac:(lra)
      ltac:(lra) He2 M M2). destruct m, m'; simpl in H1, H2; try lia; easy.
Qed.

(** [[s,r,r]] is where the shoulder asks for more friction than an inner joint along rotation. *)
Theorem sliding_shoulder_before_T (delta alpha eta mu : R) :
  0 <= delta <= 1 -> 0 < alpha < PI -> 0 < eta <= 2 -> 0 < mu -> mode_moves delta alpha eta mu SRR ->
  exists alpha0 beta, alpha <= alpha0 < PI /\ rotational_state delta alpha0 beta eta /\
    mu_is (h_lower delta beta eta) <= mu <= mu_ss alpha0 (h_lower delta beta eta).
Proof.
  intros Hd Ha He Hmu (h & p & beta & sigma & Hstate & Hb & EC & EL & EO).
  destruct (rotational_state_of_crown Hstate Hd Ha He Hmu beta Hb EC EL)
    as (alpha0 & Ha0 & Hrotation & Eh & _ & _ & Hmore). exists alpha0, beta. rewrite <- Eh. auto.
Qed.

(** ** Rows *)

Definition rank_of_row (m : mode) : nat :=
  match m with SS => 0 | RS => 1 | RSR => 2 | RRS => 3 | SRR => 3 | RRR => 4 end.

(** As the friction grows the modes that move at the least thicknesses follow each other. *)
Theorem modes_of_a_row (delta alpha mu1 eta1 mu2 eta2 : R) (m1 m2 : mode) : 0 <= delta <= 1 -> 0 < alpha < PI ->
  0 < mu1 < mu2 -> 0 < eta1 <= 2 -> 0 < eta2 <= 2 -> (forall eta', 0 < eta' < eta2 ->
    ~ arch_stands delta alpha eta' mu2) -> (forall eta mu h p beta sigma m, 0 < eta <= 2 -> 0 < mu ->
    admissible_state delta alpha eta mu h p -> (2 <= rank m)%nat -> (rank m < 5)%nat ->
    has_limits delta alpha eta mu h p beta sigma m -> h <= 1 / 2) -> (forall eta mu eta' mu' m, 0 < eta <= 2 ->
    0 < mu -> 0 < eta' <= 2 -> 0 < mu' -> (2 <= rank m)%nat -> (rank m < 5)%nat ->
    mode_moves delta alpha eta mu SRR -> ~ mode_moves delta alpha eta' mu' m) -> mode_moves delta alpha eta1 mu1 m1 ->
  mode_moves delta alpha eta2 mu2 m2 -> (rank_of_row m1 <= rank_of_row m2)%nat.
Proof.
  intros Hd Ha Hmu He1 He2 Hleast Hhalf Hexclude M1 M2. destruct M1 as (h1 & p1 & b1 & s1 & S1 & L1) eqn:D1.
  destruct M2 as (h2 & p2 & b2 & s2 & S2 & L2) eqn:D2. clear D1 D2. assert (Sh1 := shoulder_of_mode L1).
  assert (Sh2 := shoulder_of_mode L2).
  assert (HN1 : forall x, 0 <= x <= alpha -> 0 < normal_force x h1)
    by (intros x Hx; apply (@compressed delta alpha eta1 mu1 h1 p1); easy || lra).
  (* more friction is no harm *)
  assert (S1' : admissible_state delta alpha eta1 mu2 h1 p1).
  { intros x Hx. destruct (S1 x Hx) as [Hj Hf]. split; [easy|]. unfold friction_holds in *.
    assert (mu1 * normal_force x h1 <= mu2 * normal_force x h1)
      by (apply Rmult_le_compat_r; [apply Rlt_le, HN1, Hx | lra]). lra. }
  assert (Hthin : eta2 <= eta1).
  { apply Rnot_lt_le. intros H. apply (Hleast eta1); [lra|]. now exists h1, p1. }
  (* the margins of friction of the first state grow *)
  assert (Hmargins : forall x, 0 <= x <= alpha -> 0 < inward_gap x mu2 h1 /\ 0 < outward_gap x mu2 h1).
  { intros x Hx. destruct (margins_not_negative S1 x Hx) as (_ & _ & HI & HO).
    assert (H := Rmult_lt_0_compat _ _ (Rlt_Rminus _ _ (proj2 Hmu)) (HN1 x Hx)). unfold inward_gap, outward_gap in *.
    lra. }
  assert (Hsliding : m2 = SS -> False).
  { intros ->. simpl in L2. destruct L2 as (Hs2 & EI2 & EO2).
    assert (HN2 : forall x, 0 <= x <= alpha -> 0 < normal_force x h2)
      by (intros x Hx; apply (@compressed delta alpha eta2 mu2 h2 p2); easy || lra).
    destruct (Hmargins s2 ltac:(lra)) as [HI _]. destruct (Hmargins alpha ltac:(lra)) as [_ HO].
    assert (E := sliding_does_not_see_the_thickness s2 alpha mu2 h2 h1 ltac:(lra) ltac:(lra)
                   (HN2 s2 ltac:(lra)) (HN2 alpha ltac:(lra)) EI2 EO2 ltac:(lra) ltac:(lra)). rewrite E in HO. lra. }
  destruct (le_lt_dec 2 (rank m2)) as [R2 | R2].
  - (* an inner joint slides in the rougher arch: the crown does not turn in the smoother one *)
    destruct (slip_of_mode R2 L2) as [Hs2 EI2].
    destruct (le_lt_dec 5 (rank m2)) as [R2' | R2'];
      [exfalso; apply Hsliding; destruct m2; simpl in R2'; lia || easy|].
    destruct (le_lt_dec 2 (rank m1)) as [R1 | R1].
    + destruct (slip_of_mode R1 L1) as [Hs1 EI1].
      destruct (le_lt_dec 5 (rank m1)) as [R1' | R1']; [destruct m1; simpl in R1'; simpl; lia|].
      destruct (haunch_of_mode R1 R1' L1) as (Hb1 & EL1 & EU1).
      destruct (haunch_of_mode R2 R2' L2) as (Hb2 & EL2 & EU2).
      destruct (haunch_falls S2 S1 Hd Ha He2 ltac:(lra) Ha He1 ltac:(lra) ltac:(lra) ltac:(lra) s2 b2 s1 b1 Hs2 EI2 Sh2 Hs1 EI1 Sh1
                  Hb2 EL2 Hb1 EL1) as (Hfall & Hstrict & Hslip). specialize (Hstrict (or_intror (proj2 Hmu))).
      specialize (Hslip (or_introl (Hhalf eta1 mu1 h1 p1 b1 s1 m1 He1 (proj1 Hmu) S1 R1 R1' L1))). apply Nat.nlt_ge.
      intros Hless. destruct m1, m2; simpl in R1, R1', R2, R2', Hless; try lia; simpl in L1, L2; lra.
    + exfalso. destruct (crown_of_mode R1 L1) as (Hb1 & EC1 & EL1).
      destruct (crown_turns_first S2 S1 Hd Ha He2 ltac:(lra) Ha He1 ltac:(lra) ltac:(lra) ltac:(lra) s2 b1 Hs2 EI2 Sh2 Hb1 EC1 EL1 Sh1) as (_ & E & _).
      lra.
  - destruct m2; simpl in R2; try lia; [destruct m1; simpl; lia|]. destruct (le_lt_dec 2 (rank m1)) as [R1 | R1].
    + destruct (le_lt_dec 5 (rank m1)) as [R1' | R1']; [destruct m1; simpl in R1'; simpl; lia|]. exfalso.
      apply (Hexclude eta2 mu2 eta1 mu1 m1 He2 ltac:(lra) He1 (proj1 Hmu) R1 R1'); [now exists h2, p2, b2, s2
        | now exists h1, p1, b1, s1].
    + (* both crowns turn: if the smoother arch is purely rotational so is the rougher one *)
      destruct m1; simpl in R1; try lia. exfalso. destruct (crown_of_mode (m := RRR) R1 L1) as (Hb1 & EC1 & EL1).
      destruct (crown_of_mode (m := SRR) ltac:(simpl; lia) L2) as (Hb2 & EC2 & EL2). simpl in L1, L2.
      assert (Hsame : eta1 = eta2).
      { destruct (rotational_state_of_crown S1 Hd Ha He1 ltac:(lra) b1 Hb1 EC1 EL1)
          as (alpha0 & Ha0 & Hrotation & _ & _ & Eshoulder & _). rewrite (Eshoulder ltac:(tauto)) in Hrotation.
        assert (Ht := crown_is_thin S1 Hd Ha He1 ltac:(lra) b1 Hb1 EC1 EL1). apply Rle_antisym; [|easy].
        apply (rotational_thickness_is_least delta alpha b1 eta1 Hd Hb1 ltac:(lra) ltac:(lra) Hrotation eta2 He2).
        exists h2, p2. intros x Hx. now apply S2. }
      destruct (crown_thrust_is_less S1 S2 Hd Ha He1 ltac:(lra) Ha He2 ltac:(lra) ltac:(lra) b2 Hb2 EC2 EL2 Sh1) as [Hle _].
      destruct (crown_thrust_is_less S2 S1 Hd Ha He2 ltac:(lra) Ha He1 ltac:(lra) ltac:(lra) b1 Hb1 EC1 EL1 Sh2) as [Hge _].
      assert (E : h1 = h2) by lra. destruct (Hmargins alpha ltac:(lra)) as [_ HO]. rewrite E in HO.
      destruct L2 as (_ & _ & _ & EO). lra.
Qed.
