(** * The point L, Heyman's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Landmarks.

Definition this : certificate :=
  Certificate (Landmark OverturningEnd Heyman) 100
    (Box [(Dyadic (6425227280865903159) (-61))] [(Dyadic (4015767051) (-33))])
    [[(Dyadic (15127602940437894091) (-67))]]
    (Box [(Dyadic (214440658980858270403718410401082067985913057517602757450480955410341341346612435028349064452418995604384689638871) (-375))] [(Dyadic (4015767051) (-398))])
    [((Plain Eta), Decimal 2000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 (-99));
     ((Plain Mu), Infinite);
     (FrictionAngle, Decimal 1570796326794896619231321691639751442098584699687552910487472296153908203143104499314017412671058534 (-99));
     (FrictionAngleDegrees, Decimal 9000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 (-98));
     ((Plain Alpha), Decimal 2786498150651177032042156673942213066365073915373836591204634832318798428842569948940320128441954287 (-99));
     ((Degrees Alpha), Decimal 1596545836533214835727751866883406538796909789553300885012904211227441269170430929400962009087062606 (-97));
     ((Plain Thrust), Decimal 0 (0));
     (IntrinsicThrust, Decimal 0 (0));
     ((Plain BetaR), Decimal 0 (0));
     ((Degrees BetaR), Decimal 0 (0));
     ((Plain BetaS), Decimal 0 (0));
     ((Degrees BetaS), Decimal 0 (0));
     (OpeningVariable, Decimal 5000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 (-100))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.

(** Is the last digit of a printed value right? *)
Corollary table_3_A_right x : is_landmark this OverturningEnd Heyman x -> Rabs (A (x Alpha) - 0.5) <= 5e-2.
Proof. intros here. exact (right_there _ _ _ _ here OpeningVariable 5 1 eq_refl). Qed.
Corollary table_3_half_opening_right x : is_landmark this OverturningEnd Heyman x -> Rabs (x Alpha - 2.786498150651177) <= 5e-16.
Proof. intros here. exact (right_there _ _ _ _ here (Plain Alpha) 2786498150651177 15 eq_refl). Qed.
Corollary table_3_half_opening_degrees_right x : is_landmark this OverturningEnd Heyman x -> Rabs (180 * x Alpha / PI - 159.7) <= 5e-2.
Proof. intros here. exact (right_there _ _ _ _ here (Degrees Alpha) 1597 1 eq_refl). Qed.
