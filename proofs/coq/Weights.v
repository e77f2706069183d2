(** * The two self-weights compared

    At T, S, J and B: in which direction the true weight moves each quantity, from the digits of both.  [x] is Heyman's,
    [y] is Milankovitch's. *)

From Couplet Require Import Landmarks.
From Couplet Require LandmarkTripleHeyman LandmarkTripleMilankovitch LandmarkShiftHeyman LandmarkShiftMilankovitch.
From Couplet Require LandmarkJunctionHeyman LandmarkJunctionMilankovitch LandmarkBorderHeyman LandmarkBorderMilankovitch.

Ltac by_digits here there :=
  repeat split;
  match goal with
  | |- _ ?n < _ => first [ exact (smaller_there (Plain n) _ _ _ _ _ _ _ _ here there eq_refl)
                         | exact (smaller_there (Plain n) _ _ _ _ _ _ _ _ there here eq_refl) ]
  end.

Theorem triple_point x y : is_landmark LandmarkTripleHeyman.this Triple Heyman x ->
  is_landmark LandmarkTripleMilankovitch.this Triple Milankovitch y ->
  y Eta < x Eta /\ y Mu < x Mu /\ y Alpha < x Alpha /\ x Thrust < y Thrust /\ x BetaR < y BetaR /\ x BetaS < y BetaS.
Proof. intros here there. by_digits here there. Qed.

Theorem shift_point x y : is_landmark LandmarkShiftHeyman.this Shift Heyman x ->
  is_landmark LandmarkShiftMilankovitch.this Shift Milankovitch y ->
  y Eta < x Eta /\ y Mu < x Mu /\ y Alpha < x Alpha /\ x Thrust < y Thrust /\ x BetaS < y BetaS.
Proof. intros here there. by_digits here there. Qed.

Theorem junction_point x y : is_landmark LandmarkJunctionHeyman.this Junction Heyman x ->
  is_landmark LandmarkJunctionMilankovitch.this Junction Milankovitch y ->
  y Eta < x Eta /\ y Mu < x Mu /\ y Alpha < x Alpha /\ x Thrust < y Thrust /\ x BetaS < y BetaS.
Proof. intros here there. by_digits here there. Qed.

Theorem border_point x y : is_landmark LandmarkBorderHeyman.this Border Heyman x ->
  is_landmark LandmarkBorderMilankovitch.this Border Milankovitch y ->
  y Mu < x Mu /\ y Alpha < x Alpha /\ x Thrust < y Thrust /\ x BetaS < y BetaS.
Proof. intros here there. by_digits here there. Qed.
