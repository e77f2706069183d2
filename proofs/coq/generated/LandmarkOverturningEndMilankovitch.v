(** * The point L, Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Landmarks.

Definition this : certificate :=
  Certificate (Landmark OverturningEnd Milankovitch) 100
    (Box [(Dyadic (12213538057572993107) (-62))] [(Dyadic (763346129) (-31))])
    [[(Dyadic (16963001734354299359) (-67))]]
    (Box [(Dyadic (203812179325801306112128932366267206384951177919917767473001794150162080105714211578934001589159723115832808885977) (-375))] [(Dyadic (763346129) (-396))])
    [((Plain Eta), Decimal 2000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 (-99));
     ((Plain Mu), Infinite);
     (FrictionAngle, Decimal 1570796326794896619231321691639751442098584699687552910487472296153908203143104499314017412671058534 (-99));
     (FrictionAngleDegrees, Decimal 9000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 (-98));
     ((Plain Alpha), Decimal 2648388899151005411477459039384470488123444665890103333661279173459287430347611167891294645022953230 (-99));
     ((Degrees Alpha), Decimal 1517415064306508166445629434612950366291260781356655201468204444394349524829627008299041303475973931 (-97));
     ((Plain Thrust), Decimal 0 (0));
     (IntrinsicThrust, Decimal 0 (0));
     ((Plain BetaR), Decimal 0 (0));
     ((Degrees BetaR), Decimal 0 (0));
     ((Plain BetaS), Decimal 0 (0));
     ((Degrees BetaS), Decimal 0 (0));
     (OpeningVariable, Decimal 6666666666666666666666666666666666666666666666666666666666666666666666666666666666666666666666666667 (-100))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.

(** Is the last digit of a printed value right? *)
Corollary table_4_half_opening_right x : is_landmark this OverturningEnd Milankovitch x -> Rabs (x Alpha - 2.648388899151005) <= 5e-16.
Proof. intros here. exact (right_there _ _ _ _ here (Plain Alpha) 2648388899151005 15 eq_refl). Qed.
Corollary table_4_half_opening_degrees_right x : is_landmark this OverturningEnd Milankovitch x -> Rabs (180 * x Alpha / PI - 151.7) <= 5e-2.
Proof. intros here. exact (right_there _ _ _ _ here (Degrees Alpha) 1517 1 eq_refl). Qed.
