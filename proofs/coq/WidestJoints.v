(** * The widest rotational joint as a zero of (12)

    In [0.25, 2.4] the radicand (12) has exactly one zero, and it is the joint of the point sb. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Couplet Require Import Arch IntervalZ Landmarks.
From Couplet Require LandmarkWidestJointHeyman LandmarkWidestJointMilankovitch.

(** The radicand at a joint, and its derivative. *)
Definition radicand_at (delta beta : R) : R := radicand delta (f_of beta) (g_of beta) (sin beta).
Definition slope_at (delta beta : R) : R :=
  let f := f_of beta in let g := g_of beta in let S := sin beta in
  let f' := 2 * cos beta - beta * sin beta in
  let g' := 1 + (cos beta ^ 2 - sin beta ^ 2) in
  let S' := cos beta in
  delta ^ 2 * (9 * (2 * (S' * S * (g - f) ^ 2 + (g' - f') * (g - f) * S ^ 2)))
  - delta * (2 * ((S' * (g - S) + (g' - S') * S) * (9 * f ^ 2 - g ^ 2 - 16 * g * S + 8 * S ^ 2)
                  + (18 * (f' * f) - 2 * (g' * g) - 16 * (g' * S + S' * g) + 16 * (S' * S)) * (S * (g - S))))
  - 3 * (2 * ((f' + g') * (f + g) * (f ^ 2 - 2 * (g * S) + S ^ 2))
         + (2 * (f' * f) - 2 * (g' * S + S' * g) + 2 * (S' * S)) * (f + g) ^ 2).

Lemma derivative delta beta : is_derive (radicand_at delta) beta (slope_at delta beta).
Proof. unfold radicand_at, radicand, f_of, g_of, slope_at. cbv zeta. auto_derive; [exact I | unfold f_of, g_of; ring]. Qed.

(** One root where it rises, none before and behind. *)
Theorem one_joint delta slope first rise top last a b : first <= rise -> rise <= a -> a < b -> b <= top ->
  top <= last -> (forall x, first <= x <= rise -> radicand_at delta x < 0) ->
  (forall x, is_derive (radicand_at delta) x (slope x)) -> (forall x, rise <= x <= top -> 0 < slope x) ->
  (forall x, top <= x <= last -> 0 < radicand_at delta x) -> radicand_at delta a < 0 -> 0 < radicand_at delta b ->
  exists beta, a < beta < b /\ radicand_at delta beta = 0 /\
    (forall other, first <= other <= last -> radicand_at delta other = 0 -> other = beta).
Proof.
  intros H1 H2 H3 H4 H5 before Hslope rising behind Ha Hb.
  destruct (Ranalysis5.IVT_interv (radicand_at delta) a b) as [beta [Hbeta Hroot]]; try lra.
  { intros x Hx. apply continuity_pt_filterlim, (ex_derive_continuous (radicand_at delta)). now exists (slope x). }
  assert (beta <> a /\ beta <> b) by (split; intros ->; lra). exists beta. split; [lra | split; [exact Hroot |]].
  intros other Hother Hzero. destruct (Rlt_or_le other rise) as [Hr | Hr]; [specialize (before other); lra |].
  destruct (Rlt_or_le top other) as [Ht | Ht]; [specialize (behind other); lra |].
  assert (grows := incr_function_le (radicand_at delta) rise top slope (fun x _ _ => Hslope x)
    (fun x Hx Hx' => rising x (conj Hx Hx'))). cbn in grows.
  destruct (Rtotal_order other beta) as [Hless | [Hsame | Hmore]]; [apply grows in Hless; lra | exact Hsame | apply grows in Hmore; lra].
Qed.

(** With the signs by intervals, from a bracket as wide as two units of the last decimal. *)
Ltac at_joint := unfold slope_at, radicand_at, radicand, f_of, g_of; cbv zeta.
Ltac widest_joint delta lo hi :=
  let beta := fresh "beta" in
  destruct (one_joint delta (slope_at delta) 0.25 0.9 1.6 2.4 lo hi) as [beta [? [? ?]]]; try lra;
  [ intros x Hx; at_joint; interval with (i_prec 53, i_bisect x)
  | apply derivative
  | intros x Hx; at_joint; interval with (i_prec 53, i_bisect x)
  | intros x Hx; at_joint; interval with (i_prec 53, i_bisect x)
  | at_joint; interval with (i_prec 140)
  | at_joint; interval with (i_prec 140)
  | exists beta; split; [apply Rabs_le; lra | now split] ].

Theorem widest_joint_heyman : exists beta, Rabs (beta - 1.1290850875761869940518960329593) <= 1e-30 /\
  radicand 0 (f_of beta) (g_of beta) (sin beta) = 0 /\
  (forall other, 0.25 <= other <= 2.4 -> radicand 0 (f_of other) (g_of other) (sin other) = 0 -> other = beta).
Proof. widest_joint 0 1.1290850875761869940518960329583 1.1290850875761869940518960329603. Qed.

Theorem widest_joint_milankovitch : exists beta, Rabs (beta - 1.11986423144375175967721163294924) <= 1e-30 /\
  radicand 1 (f_of beta) (g_of beta) (sin beta) = 0 /\
  (forall other, 0.25 <= other <= 2.4 -> radicand 1 (f_of other) (g_of other) (sin other) = 0 -> other = beta).
Proof. widest_joint 1 1.11986423144375175967721163294824 1.11986423144375175967721163295024. Qed.

(** They are the joints of the landmark, by its printed hundredths. *)
Ltac that_of_landmark one hundredths :=
  intros here Hbeta Hzero; destruct one as [joint [_ [_ unique]]];
  transitivity joint; [now apply unique | symmetry]; apply unique;
  [ assert (near := right_there _ _ _ _ here (Plain BetaR) hundredths 2 eq_refl);
    apply Rabs_le_between' in near; cbn in near; lra
  | now destruct here as (_ & _ & _ & _ & _ & _ & (_ & zero) & _) ].

Theorem joint_of_sb_heyman x beta : is_landmark LandmarkWidestJointHeyman.this WidestJoint Heyman x ->
  0.25 <= beta <= 2.4 -> radicand 0 (f_of beta) (g_of beta) (sin beta) = 0 -> beta = x BetaR.
Proof. that_of_landmark widest_joint_heyman 113%Z. Qed.

Theorem joint_of_sb_milankovitch x beta : is_landmark LandmarkWidestJointMilankovitch.this WidestJoint Milankovitch x ->
  0.25 <= beta <= 2.4 -> radicand 1 (f_of beta) (g_of beta) (sin beta) = 0 -> beta = x BetaR.
Proof. that_of_landmark widest_joint_milankovitch 112%Z. Qed.
