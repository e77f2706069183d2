
(** ** The solution *)

(** The order of the joints and the rates. *)
Lemma signs <<args>> : narrow <<args>> ->
  0 < v /\ beta_r < alpha /\ beta_s < beta_r /\ - beta_s < b0 /\ b0 < alpha /\
  0 < determinant alpha beta_s /\
  0 < shoulder_slip alpha eta b0 beta_r beta_s /\ 0 < inner_slip alpha eta b0 beta_r beta_s.
Proof.
  unfold narrow, shoulder_slip, inner_slip, determinant, across, upwards, extrados, intrados<<unfolded>>;
    intros; conjuncts; repeat split; first [lra | interval with (i_prec 90)].
Qed.

Ltac apart := unfold narrow<<unfolded>> in *; conjuncts.

Lemma inside_extrados <<args>> : narrow <<args>> -> equations <<args>> ->
  forall x, - alpha <= x <= alpha -> 0 <= from_extrados <<delta>> eta h p v x.
Proof.
  intros N E x Hx.
  assert (near : forall y, <<crown_low>> <= y <= <<crown_high>> -> 0 <= from_extrados <<delta>> eta h p v y).
  { apply (touching _ (extrados_slope <<delta>> eta h v) (extrados_bend <<delta>> eta h v) <<crown_low>> <<crown_high>> b0);
      [intros; apply extrados_has_slope | intros; apply extrados_has_bend | unfold equations in E; tauto ..
      | clear E Hx x; intros x Hx; apart; positive x | clear E Hx; apart; lra]. }
  assert (left : forall y, - alpha <= y <= <<crown_low>> -> 0 <= from_extrados <<delta>> eta h p v y)
    by (clear E Hx near x; intros x Hx; apart; positive x).
  assert (right : forall y, <<crown_high>> <= y <= alpha -> 0 <= from_extrados <<delta>> eta h p v y)
    by (clear E Hx near left x; intros x Hx; apart; positive x).
  destruct (Rle_dec x <<crown_low>>); [apply left; lra |].
  destruct (Rle_dec x <<crown_high>>); [apply near; lra | apply right; lra].
Qed.

Lemma inside_intrados <<args>> : narrow <<args>> -> equations <<args>> ->
  forall x, - alpha <= x <= alpha -> 0 <= from_intrados <<delta>> eta h p v x.
Proof.
  intros N E x Hx.
  assert (near : forall y, <<haunch_low>> <= y <= <<haunch_high>> -> 0 <= from_intrados <<delta>> eta h p v y).
  { apply (touching _ (intrados_slope <<delta>> eta h v) (intrados_bend <<delta>> eta h v) <<haunch_low>> <<haunch_high>>
      (- beta_r));
      [intros; apply intrados_has_slope | intros; apply intrados_has_bend | unfold equations in E; tauto ..
      | clear E Hx x; intros x Hx; apart; positive x | clear E Hx; apart; lra]. }
  assert (left : forall y, - alpha <= y <= <<haunch_low>> -> 0 <= from_intrados <<delta>> eta h p v y)
    by (clear E Hx near x; intros x Hx; apart; positive x).
  assert (right : forall y, <<haunch_high>> <= y <= alpha -> 0 <= from_intrados <<delta>> eta h p v y)
    by (clear E Hx near left x; intros x Hx; apart; positive x).
  destruct (Rle_dec x <<haunch_low>>); [apply left; lra |].
  destruct (Rle_dec x <<haunch_high>>); [apply near; lra | apply right; lra].
Qed.

Lemma friction_inwards <<args>> : narrow <<args>> ->
  forall x, - alpha <= x <= alpha -> 0 <= against_inwards mu h v x.
Proof. intros N x Hx. apart. positive x. Qed.

Lemma friction_outwards <<args>> : narrow <<args>> -> equations <<args>> ->
  forall x, - alpha <= x <= alpha -> 0 <= against_outwards mu h v x.
Proof.
  intros N E x Hx.
  assert (near : forall y, <<inner_low>> <= y <= <<inner_high>> -> 0 <= against_outwards mu h v y).
  { apply (touching _ (outwards_slope mu h v) (outwards_bend mu h v) <<inner_low>> <<inner_high>> (- beta_s));
      [intros; apply outwards_has_slope | intros; apply outwards_has_bend | unfold equations in E; tauto ..
      | clear E Hx x; intros x Hx; apart; positive x | clear E Hx; apart; lra]. }
  assert (last : forall y, <<shoulder_low>> <= y <= alpha -> 0 <= against_outwards mu h v y).
  { apply (falling _ (outwards_slope mu h v) <<shoulder_low>> alpha);
      [intros; apply outwards_has_slope | unfold equations in E; tauto
      | clear E Hx near x; intros x Hx; apart; positive x]. }
  assert (left : forall y, - alpha <= y <= <<inner_low>> -> 0 <= against_outwards mu h v y)
    by (clear E Hx near last x; intros x Hx; apart; positive x).
  assert (right : forall y, <<inner_high>> <= y <= <<shoulder_low>> -> 0 <= against_outwards mu h v y)
    by (clear E Hx near last left x; intros x Hx; apart; positive x).
  destruct (Rle_dec x <<inner_low>>); [apply left; lra |].
  destruct (Rle_dec x <<inner_high>>); [apply near; lra |].
  destruct (Rle_dec x <<shoulder_low>>); [apply right; lra | apply last; lra].
Qed.

(** It solves (19). *)
Theorem solution <<args>> : wide <<args>> -> equations <<args>> ->
  asymmetric_solution <<delta>> alpha mu eta h p v b0 beta_r beta_s
    (shoulder_slip alpha eta b0 beta_r beta_s) (inner_slip alpha eta b0 beta_r beta_s).
Proof.
  intros W E. pose proof (digits <<args>> W E) as N.
  destruct (signs <<args>> N) as (Hv & H1 & H2 & H3 & H4 & Hd & Hs & Hu).
  unfold asymmetric_solution. split.
  { intros x Hx. repeat split; [now apply (inside_extrados <<args>>) | now apply (inside_intrados <<args>>)
      | now apply (friction_inwards <<args>>) | now apply (friction_outwards <<args>>)]. }
  assert (F := rates_fit alpha eta b0 beta_r beta_s ltac:(lra)).
  unfold equations in E. repeat split; first [tauto | lra].
Qed.

Corollary asymmetric_thickness : exists eta, Rabs (eta - <<thickness>>) <= <<radius>> /\
  exists h p v b0 b1 b2 s u, asymmetric_solution <<delta>> alpha mu eta h p v b0 b1 b2 s u.
Proof.
  destruct one_solution as (<<witness>> & N & E & _).
  exists eta. split; [unfold narrow in N; tauto |].
  exists h, p, v, b0, beta_r, beta_s. eexists. eexists.
  exact (solution <<args>> (narrow_is_wide <<args>> N) E).
Qed.
