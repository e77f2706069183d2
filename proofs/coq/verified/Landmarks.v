(** * What follows from the certificate of a landmark

    In the words of [States], whatever the landmark; and from the digits of the certificate, whether the last digit of a
    printed value is right, and which of two values is the smaller one. *)

From Coq Require Import Lra Lia Bool.
From Coq Require Export Reals.
From Coquelicot Require Import Coquelicot.
From Couplet Require Import Root.
From Couplet Require Export Arch States Sound.

(** ** The state *)

Section Landmark.

Variables (c : certificate) (l : landmark) (w : weight) (x : configuration).
Hypothesis here : is_landmark c l w x.

(** What else solves the equations in the large box is the same. *)
Theorem one_solution y : in_box (landmark_unknowns l) (unique c) y -> solves_there l w y ->
  forall n, In n (landmark_unknowns l) -> y n = x n.
Proof. destruct here as (_ & (_ & only) & _). now apply only. Qed.

(** The equations of each of its modes hold, where the haunch is the crown with the limit of (5), and the line of thrust
    of each is the same: it is admissible at every joint, and the arch stands exactly from there on. *)
Theorem state_of_each_mode m : In m (modes_of l) ->
  is_state_there l (flag w) x m /\
  match friction_there l x with
  | Some mu =>
      admissible (flag w) (x Alpha) (x Eta) mu (x Thrust) (crown_moment m (flag w) x) /\
      stands_from (flag w) (x Alpha) mu (x Eta)
  | None =>
      thrust_inside (flag w) (x Alpha) (x Eta) (x Thrust) (crown_moment m (flag w) x) /\
      stands_without_limit_from (flag w) (x Alpha) (x Eta)
  end.
Proof.
  intros Hm. destruct here as (_ & _ & _ & least & states & _). assert (Hstate := states m Hm).
  split; [exact Hstate |]. rewrite (proj1 Hstate). unfold is_least, is_admissible in least.
  now destruct (friction_there l x).
Qed.

(** At less friction nothing stands. *)
Theorem less_friction : friction_there l x <> None ->
  forall mu, 0 <= mu < x Mu -> stands_at_no_thickness (x Alpha) mu.
Proof. destruct here as (_ & _ & _ & _ & _ & _ & _ & _ & less). unfold is_least_friction in less. now destruct l. Qed.

(** It is a solution in the large box; where its joints are, and what is zero there. *)
Theorem forces_and_joints : List.Forall (holds (flag w) x) (equations_of l) /\ is_fixed l x /\
  in_box (landmark_unknowns l) (unique c) x /\ 0 < x Alpha < PI /\ 0 < x Eta <= 2 /\
  0 < normal_force (x Alpha) (x Thrust) /\ (l = WidestJoint -> 0 < x BetaR < x Alpha) /\ (l = Triple ->
    x BetaS < x BetaR < x Alpha /\ at_crown (x Eta) (x Thrust) = at_shoulder (flag w) (x Alpha) (x Eta) (x Thrust)) /\
  (friction_there l x <> None -> 0 < x BetaS < x Alpha /\ 0 < x Thrust < 1 /\ x Mu = mu_ss (x Alpha) (x Thrust) /\
    x Mu = mu_is (x Thrust) /\ x BetaS = beta_s (x Thrust)).
Proof.
  destruct here as ((hold & fixed) & (box & _) & _ & _ & _ & (half & thick & order) & (slides & zero) & (N & h & _) & _).
  refine (conj hold (conj fixed (conj box (conj half (conj thick (conj N (conj _ (conj _ _)))))))).
  - intros E. now rewrite E in order.
  - intros E. rewrite E in *. cbn in order. split; [lra | exact zero].
  - intros Hl. destruct l; try easy; cbn in *; repeat split; try apply slides; lra.
Qed.

(** ** Its digits *)

Definition alike (p q : quantity) : bool :=
  match p, q with
  | Plain a, Plain b | Degrees a, Degrees b => same a b
  | IntrinsicThrust, IntrinsicThrust | OpeningVariable, OpeningVariable | FrictionAngle, FrictionAngle
  | FrictionAngleDegrees, FrictionAngleDegrees => true
  | _, _ => false
  end.

Lemma alike_sound p q : alike p q = true -> p = q.
Proof. destruct p, q; simpl; try easy; destruct (same_spec n n0); now subst. Qed.

(** A value of the certificate; infinite if it has none. *)
Definition written_of (q : quantity) : written :=
  match find (fun qv => alike q (fst qv)) (values c) with Some qv => snd qv | None => Infinite end.

Lemma is_written q m e : written_of q = Decimal m e -> m <> 0%Z ->
  Rabs (value_of (friction_there l x) x q - IZR m * powerRZ 10 e) < powerRZ 10 e / 2.
Proof.
  unfold written_of. destruct (find _ _) as [[p v] |] eqn:Hfind; [| easy]. simpl. intros -> Hm.
  apply find_some in Hfind as [Hin Heq]. apply alike_sound in Heq. cbn [fst] in Heq. subst p.
  destruct here as (_ & _ & hold & _). destruct (hold q _ Hin) as [_ [_ [[-> _] | [_ Hround]]]]; [easy |].
  assert (0 < powerRZ 10 e) by (apply powerRZ_lt; lra). apply Rabs_lt_between'.
  destruct (m =? 10 ^ (digits c - 1))%Z; lra.
Qed.

(** A printed value [p / 10 ^ k] in units of the last digit of the certificate, and how far it is from that. *)
Definition units (k : positive) (e : Z) : Z := (10 ^ (- Zpos k - e))%Z.
Definition off (m e p : Z) (k : positive) : Z := Z.abs (m - p * units k e).
Definition is_right (v : written) (p : Z) (k : positive) : bool :=
  match v with
  | Decimal m e => (0 <? m)%Z && (e <=? - Zpos k)%Z && (2 * off m e p k + 1 <=? units k e)%Z
  | Infinite => false
  end.
Definition is_wrong (v : written) (p : Z) (k : positive) : bool :=
  match v with
  | Decimal m e => (0 <? m)%Z && (e <=? - Zpos k)%Z && (units k e + 1 <=? 2 * off m e p k)%Z
  | Infinite => false
  end.

Lemma in_units m e p k : (e <= - Zpos k)%Z -> let u := powerRZ 10 e in 0 < u /\
  Rabs (IZR m * u - IZR p / IZR (Z.pow_pos 10 k)) = IZR (off m e p k) * u /\
  IZR 5 / IZR (Z.pow_pos 10 (Pos.succ k)) = IZR (units k e) * u / 2.
Proof.
  intros He u. assert (positive : 0 < u) by (apply powerRZ_lt; lra).
  assert (unit : IZR (units k e) * u = / powerRZ 10 (Zpos k)).
  { unfold units, u. rewrite power_of_ten, <- powerRZ_add by (lia || lra).
    now replace (- Zpos k - e + e)%Z with (- Zpos k)%Z by lia. }
  assert (k_positive : 0 < powerRZ 10 (Zpos k)) by (apply powerRZ_lt; lra).
  change (Z.pow_pos 10 k) with (10 ^ Zpos k)%Z. change (Z.pow_pos 10 (Pos.succ k)) with (10 ^ Zpos (Pos.succ k))%Z.
  rewrite !power_of_ten by lia. split; [exact positive | split].
  - unfold Rdiv, off. rewrite <- unit, abs_IZR, minus_IZR, mult_IZR. rewrite <- (Rabs_pos_eq u) at 3 by lra.
    rewrite <- Rabs_mult. f_equal. ring.
  - rewrite unit, Pos2Z.inj_succ. unfold Z.succ. rewrite powerRZ_add by lra. rewrite powerRZ_1. field. lra.
Qed.

Theorem right_there q p k : is_right (written_of q) p k = true ->
  Rabs (value_of (friction_there l x) x q - IZR p / IZR (Z.pow_pos 10 k)) <= IZR 5 / IZR (Z.pow_pos 10 (Pos.succ k)).
Proof.
  unfold is_right. destruct (written_of q) as [| m e] eqn:Hq; [easy |]. intros Htest. conditions. in_integers.
  assert (near := is_written q m e Hq ltac:(lia)). destruct (in_units m e p k ltac:(easy)) as (Hu & Hoff & ->).
  set (u := powerRZ 10 e) in *. assert (Hsize : IZR (2 * off m e p k + 1) <= IZR (units k e)) by (now apply IZR_le).
  rewrite plus_IZR, mult_IZR in Hsize.
  replace (value_of (friction_there l x) x q - IZR p / IZR (Z.pow_pos 10 k))
    with ((value_of (friction_there l x) x q - IZR m * u) + (IZR m * u - IZR p / IZR (Z.pow_pos 10 k))) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Hoff. nra.
Qed.

Theorem wrong_there q p k : is_wrong (written_of q) p k = true ->
  IZR 5 / IZR (Z.pow_pos 10 (Pos.succ k)) < Rabs (value_of (friction_there l x) x q - IZR p / IZR (Z.pow_pos 10 k)).
Proof.
  unfold is_wrong. destruct (written_of q) as [| m e] eqn:Hq; [easy |]. intros Htest. conditions. in_integers.
  assert (near := is_written q m e Hq ltac:(lia)). destruct (in_units m e p k ltac:(easy)) as (Hu & Hoff & ->).
  set (u := powerRZ 10 e) in *.
  assert (Hsize : IZR (units k e) + 1 <= IZR 2 * IZR (off m e p k))
    by (rewrite <- mult_IZR, <- plus_IZR; now apply IZR_le).
  assert (Htriangle := Rabs_triang (value_of (friction_there l x) x q - IZR p / IZR (Z.pow_pos 10 k))
                         (IZR m * u - value_of (friction_there l x) x q)).
  rewrite (Rabs_minus_sym (IZR m * u)) in Htriangle.
  replace (value_of (friction_there l x) x q - IZR p / IZR (Z.pow_pos 10 k)
           + (IZR m * u - value_of (friction_there l x) x q))
    with (IZR m * u - IZR p / IZR (Z.pow_pos 10 k)) in Htriangle by ring. rewrite Hoff in Htriangle. nra.
Qed.

End Landmark.

(** ** Two landmarks *)

(** One value is smaller than another, by their digits. *)
Definition is_smaller (v v' : written) : bool :=
  match v, v' with
  | Decimal m e, Decimal m' e' =>
      let f := Z.min e e' in
      let unit := (10 ^ (e - f))%Z in let unit' := (10 ^ (e' - f))%Z in
      (0 <? m)%Z && (0 <? m')%Z && (2 * m * unit + unit <=? 2 * m' * unit' - unit')%Z
  | _, _ => false
  end.

Theorem smaller_there q c l w x c' l' w' x' : is_landmark c l w x -> is_landmark c' l' w' x' ->
  is_smaller (written_of c q) (written_of c' q) = true ->
  value_of (friction_there l x) x q < value_of (friction_there l' x') x' q.
Proof.
  intros here there. unfold is_smaller. destruct (written_of c q) as [| m e] eqn:Hq; [easy |].
  destruct (written_of c' q) as [| m' e'] eqn:Hq'; [easy |]. intros Htest. conditions. in_integers.
  assert (near := is_written c l w x here q m e Hq ltac:(lia)).
  assert (near' := is_written c' l' w' x' there q m' e' Hq' ltac:(lia)).
  assert (scale : forall k, (Z.min e e' <= k)%Z ->
            powerRZ 10 k = IZR (10 ^ (k - Z.min e e')) * powerRZ 10 (Z.min e e')).
  { intros k Hk. rewrite power_of_ten, <- powerRZ_add by (lia || lra). f_equal. lia. }
  rewrite (scale e) in near by lia. rewrite (scale e') in near' by lia.
  assert (positive : 0 < powerRZ 10 (Z.min e e')) by (apply powerRZ_lt; lra). apply Rabs_lt_between' in near, near'.
  match goal with H : (_ <= _ - _)%Z |- _ => apply IZR_le in H; rewrite plus_IZR, minus_IZR, !mult_IZR in H; rename H into Hsize end.
  nra.
Qed.
