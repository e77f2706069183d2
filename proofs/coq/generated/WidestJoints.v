(** * The widest rotational joint as a zero of (12)

    In [0.25, 2.4] the radicand (12) has exactly one zero, and it is the joint of the point sb.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
From Couplet Require WidestJointHeyman WidestJointMilankovitch.
Open Scope R_scope.

(** ** Heyman's self-weight *)

Definition slope_heyman (beta : R) : R :=
  - (3 * (2 * ((cos beta + (cos beta - sin beta * beta) + (1 + (cos beta ^ 2 - sin beta ^ 2))) * (sin beta + beta * cos beta + (beta + sin beta * cos beta)) * ((sin beta + beta * cos beta) ^ 2 - 2 * ((beta + sin beta * cos beta) * sin beta) + sin beta ^ 2)) + (2 * ((cos beta + (cos beta - sin beta * beta)) * (sin beta + beta * cos beta)) - 2 * ((1 + (cos beta ^ 2 - sin beta ^ 2)) * sin beta + cos beta * (beta + sin beta * cos beta)) + 2 * (cos beta * sin beta)) * (sin beta + beta * cos beta + (beta + sin beta * cos beta)) ^ 2)).

Lemma derivative_heyman beta : is_derive (radicand_at 0) beta (slope_heyman beta).
Proof.
  unfold radicand_at, radicand, f_of, g_of, slope_heyman. auto_derive; [exact I | ring].
Qed.

Theorem widest_joint_heyman : exists beta,
  Rabs (beta - 1.1290850875761869940518960329593) <= 1e-30 /\
  radicand 0 (f_of beta) (g_of beta) (sin beta) = 0 /\
  (forall other, 0.25 <= other <= 2.4 ->
     radicand 0 (f_of other) (g_of other) (sin other) = 0 -> other = beta).
Proof.
  destruct (one_joint 0 slope_heyman 0.25 0.9 1.6 2.4
    1.1290850875761869940518960329583 1.1290850875761869940518960329603)
    as [beta [H [Hroot unique]]]; try lra.
  - intros x Hx. unfold radicand_at, radicand, f_of, g_of.
    interval with (i_prec 53, i_bisect x).
  - exact derivative_heyman.
  - intros x Hx. unfold slope_heyman. interval with (i_prec 53, i_bisect x).
  - intros x Hx. unfold radicand_at, radicand, f_of, g_of.
    interval with (i_prec 53, i_bisect x).
  - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).
  - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).
  - exists beta. split; [apply Rabs_le; lra | split; [exact Hroot | exact unique]].
Qed.

(** It is the joint of the landmark. *)
Theorem joint_of_sb_heyman alpha beta_r eta h beta :
  WidestJointHeyman.wide alpha beta_r eta h -> WidestJointHeyman.equations alpha beta_r eta h ->
  0.25 <= beta <= 2.4 -> radicand 0 (f_of beta) (g_of beta) (sin beta) = 0 ->
  beta = beta_r.
Proof.
  intros W E Hbeta Hzero. destruct widest_joint_heyman as [joint [_ [_ unique]]].
  transitivity joint; [now apply unique | symmetry]. apply unique.
  - unfold WidestJointHeyman.wide in W. lra.
  - exact (WidestJointHeyman.radicand_vanishes alpha beta_r eta h W E).
Qed.

(** ** Milankovitch's self-weight *)

Definition slope_milankovitch (beta : R) : R :=
  9 * (2 * (cos beta * sin beta * (beta + sin beta * cos beta - (sin beta + beta * cos beta)) ^ 2) + 2 * ((1 + (cos beta ^ 2 - sin beta ^ 2) - (cos beta + (cos beta - sin beta * beta))) * (beta + sin beta * cos beta - (sin beta + beta * cos beta)) * sin beta ^ 2)) - 2 * ((cos beta * (beta + sin beta * cos beta - sin beta) + (1 + (cos beta ^ 2 - sin beta ^ 2) - cos beta) * sin beta) * (9 * (sin beta + beta * cos beta) ^ 2 - (beta + sin beta * cos beta) ^ 2 - 16 * ((beta + sin beta * cos beta) * sin beta) + 8 * sin beta ^ 2) + (18 * ((cos beta + (cos beta - sin beta * beta)) * (sin beta + beta * cos beta)) - 2 * ((1 + (cos beta ^ 2 - sin beta ^ 2)) * (beta + sin beta * cos beta)) - 16 * ((1 + (cos beta ^ 2 - sin beta ^ 2)) * sin beta + cos beta * (beta + sin beta * cos beta)) + 16 * (cos beta * sin beta)) * (sin beta * (beta + sin beta * cos beta - sin beta))) - 3 * (2 * ((cos beta + (cos beta - sin beta * beta) + (1 + (cos beta ^ 2 - sin beta ^ 2))) * (sin beta + beta * cos beta + (beta + sin beta * cos beta)) * ((sin beta + beta * cos beta) ^ 2 - 2 * ((beta + sin beta * cos beta) * sin beta) + sin beta ^ 2)) + (2 * ((cos beta + (cos beta - sin beta * beta)) * (sin beta + beta * cos beta)) - 2 * ((1 + (cos beta ^ 2 - sin beta ^ 2)) * sin beta + cos beta * (beta + sin beta * cos beta)) + 2 * (cos beta * sin beta)) * (sin beta + beta * cos beta + (beta + sin beta * cos beta)) ^ 2).

Lemma derivative_milankovitch beta : is_derive (radicand_at 1) beta (slope_milankovitch beta).
Proof.
  unfold radicand_at, radicand, f_of, g_of, slope_milankovitch. auto_derive; [exact I | ring].
Qed.

Theorem widest_joint_milankovitch : exists beta,
  Rabs (beta - 1.11986423144375175967721163294924) <= 1e-30 /\
  radicand 1 (f_of beta) (g_of beta) (sin beta) = 0 /\
  (forall other, 0.25 <= other <= 2.4 ->
     radicand 1 (f_of other) (g_of other) (sin other) = 0 -> other = beta).
Proof.
  destruct (one_joint 1 slope_milankovitch 0.25 0.9 1.6 2.4
    1.11986423144375175967721163294824 1.11986423144375175967721163295024)
    as [beta [H [Hroot unique]]]; try lra.
  - intros x Hx. unfold radicand_at, radicand, f_of, g_of.
    interval with (i_prec 53, i_bisect x).
  - exact derivative_milankovitch.
  - intros x Hx. unfold slope_milankovitch. interval with (i_prec 53, i_bisect x).
  - intros x Hx. unfold radicand_at, radicand, f_of, g_of.
    interval with (i_prec 53, i_bisect x).
  - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).
  - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).
  - exists beta. split; [apply Rabs_le; lra | split; [exact Hroot | exact unique]].
Qed.

(** It is the joint of the landmark. *)
Theorem joint_of_sb_milankovitch alpha beta_r eta h beta :
  WidestJointMilankovitch.wide alpha beta_r eta h -> WidestJointMilankovitch.equations alpha beta_r eta h ->
  0.25 <= beta <= 2.4 -> radicand 1 (f_of beta) (g_of beta) (sin beta) = 0 ->
  beta = beta_r.
Proof.
  intros W E Hbeta Hzero. destruct widest_joint_milankovitch as [joint [_ [_ unique]]].
  transitivity joint; [now apply unique | symmetry]. apply unique.
  - unfold WidestJointMilankovitch.wide in W. lra.
  - exact (WidestJointMilankovitch.radicand_vanishes alpha beta_r eta h W E).
Qed.
