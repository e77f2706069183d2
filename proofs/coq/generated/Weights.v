(** * The two self-weights compared

    At T, S, J and B: in which direction the true weight moves each quantity, from the digits of both.

    Written by `couplet prove --coq` from the equations of the program. *)

From Couplet Require Import Instance.
From Couplet Require TripleHeyman TripleMilankovitch ShiftHeyman ShiftMilankovitch.
From Couplet Require JunctionHeyman JunctionMilankovitch BorderHeyman BorderMilankovitch.
Open Scope R_scope.

(** The point T: triple point; the primed variables are Milankovitch's. *)
Theorem triple_point alpha beta_r beta_s eta h mu alpha' beta_r' beta_s' eta' h' mu' :
  TripleHeyman.wide alpha beta_r beta_s eta h mu -> TripleHeyman.equations alpha beta_r beta_s eta h mu ->
  TripleMilankovitch.wide alpha' beta_r' beta_s' eta' h' mu' ->
  TripleMilankovitch.equations alpha' beta_r' beta_s' eta' h' mu' ->
  eta' < eta /\ mu' < mu /\ alpha' < alpha /\ h < h' /\ beta_r < beta_r' /\ beta_s < beta_s'.
Proof.
  intros W E W' E'.
  apply (TripleHeyman.digits alpha beta_r beta_s eta h mu W) in E.
  apply (TripleMilankovitch.digits alpha' beta_r' beta_s' eta' h' mu' W') in E'.
  unfold TripleHeyman.narrow in E. unfold TripleMilankovitch.narrow in E'.
  conjuncts. repeat split; lra.
Qed.

(** The point S: shift point; the primed variables are Milankovitch's. *)
Theorem shift_point alpha beta_s eta h mu alpha' beta_s' eta' h' mu' :
  ShiftHeyman.wide alpha beta_s eta h mu -> ShiftHeyman.equations alpha beta_s eta h mu ->
  ShiftMilankovitch.wide alpha' beta_s' eta' h' mu' ->
  ShiftMilankovitch.equations alpha' beta_s' eta' h' mu' ->
  eta' < eta /\ mu' < mu /\ alpha' < alpha /\ h < h' /\ beta_s < beta_s'.
Proof.
  intros W E W' E'.
  apply (ShiftHeyman.digits alpha beta_s eta h mu W) in E.
  apply (ShiftMilankovitch.digits alpha' beta_s' eta' h' mu' W') in E'.
  unfold ShiftHeyman.narrow in E. unfold ShiftMilankovitch.narrow in E'.
  conjuncts. repeat split; lra.
Qed.

(** The point J: junction point; the primed variables are Milankovitch's. *)
Theorem junction_point alpha beta_s eta h mu alpha' beta_s' eta' h' mu' :
  JunctionHeyman.wide alpha beta_s eta h mu -> JunctionHeyman.equations alpha beta_s eta h mu ->
  JunctionMilankovitch.wide alpha' beta_s' eta' h' mu' ->
  JunctionMilankovitch.equations alpha' beta_s' eta' h' mu' ->
  eta' < eta /\ mu' < mu /\ alpha' < alpha /\ h < h' /\ beta_s < beta_s'.
Proof.
  intros W E W' E'.
  apply (JunctionHeyman.digits alpha beta_s eta h mu W) in E.
  apply (JunctionMilankovitch.digits alpha' beta_s' eta' h' mu' W') in E'.
  unfold JunctionHeyman.narrow in E. unfold JunctionMilankovitch.narrow in E'.
  conjuncts. repeat split; lra.
Qed.

(** The point B: border point; the primed variables are Milankovitch's. *)
Theorem border_point alpha beta_s h mu alpha' beta_s' h' mu' :
  BorderHeyman.wide alpha beta_s h mu -> BorderHeyman.equations alpha beta_s h mu ->
  BorderMilankovitch.wide alpha' beta_s' h' mu' ->
  BorderMilankovitch.equations alpha' beta_s' h' mu' ->
  mu' < mu /\ alpha' < alpha /\ h < h' /\ beta_s < beta_s'.
Proof.
  intros W E W' E'.
  apply (BorderHeyman.digits alpha beta_s h mu W) in E.
  apply (BorderMilankovitch.digits alpha' beta_s' h' mu' W') in E'.
  unfold BorderHeyman.narrow in E. unfold BorderMilankovitch.narrow in E'.
  conjuncts. repeat split; lra.
Qed.
