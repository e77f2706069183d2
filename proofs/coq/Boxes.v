(** * Larger boxes

    The box of a certificate has the shape in which it is checked best.  At T, S and B others reach further in some
    directions; they too have one solution, of the same digits. *)

From Coq Require Import ZArith List.
From Couplet Require Import Landmarks.
From Couplet Require LandmarkTripleHeyman LandmarkTripleMilankovitch LandmarkShiftMilankovitch.
From Couplet Require LandmarkBorderHeyman LandmarkBorderMilankovitch.
Import ListNotations.
Open Scope Z_scope.

(** The certificate with a large box of other radii, in units of [2 ^ -20], and a small one of the same shape. *)
Definition widened (c : certificate) (radii : list Z) : certificate :=
  let scaled e := map (fun r => Dyadic r e) radii in
  Certificate (about c) (digits c) (Box (centre (unique c)) (scaled (-20))) (inverse c)
    (Box (centre (root c)) (scaled (-380))) (filter (fun qv => match fst qv with Plain _ => true | _ => false end) (values c)).

Ltac computed := apply sound; vm_cast_no_check (eq_refl true).

Theorem triple_heyman : claim_of (widened LandmarkTripleHeyman.this [22900; 23609; 12529; 20558; 9432; 82554]).
Proof. computed. Qed.

Theorem triple_milankovitch : claim_of (widened LandmarkTripleMilankovitch.this [25094; 23653; 12303; 21687; 10235; 77573]).
Proof. computed. Qed.

Theorem shift_milankovitch : claim_of (widened LandmarkShiftMilankovitch.this [49001; 36389; 97029; 30989; 176071]).
Proof. computed. Qed.

Theorem border_heyman : claim_of (widened LandmarkBorderHeyman.this [16592; 68145; 33550; 419119]).
Proof. computed. Qed.

Theorem border_milankovitch : claim_of (widened LandmarkBorderMilankovitch.this [35574; 83843; 58208; 321101]).
Proof. computed. Qed.
