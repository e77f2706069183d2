(** * The point l, Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Landmarks.

Definition this : certificate :=
  Certificate (Landmark RotationEnd Milankovitch) 100
    (Box [(Dyadic (11948156482058672329) (-62)); (Dyadic (17122327437282811117) (-64))] [(Dyadic (1493519561) (-32)); (Dyadic (2364721435) (-73))])
    [[(Dyadic (6093955507051471139) (-65)); (Dyadic (16525042819794998071) (-68))]; [(Dyadic (0) (0)); (Dyadic (7987674492471257551) (-64))]]
    (Box [(Dyadic (797534604650990999211599377044132865879122936575068553153922678958768219547285488871957118955363627543402113415389) (-377)); (Dyadic (314160274239495642138566577075206323094550146483690588679458579065820172507013888909123776663120055034310275588122502303814253) (-417))] [(Dyadic (1493519561) (-397)); (Dyadic (2364721435) (-438))])
    [((Plain Eta), Decimal 9282032302755091741097853660234894677712210152415225122232279178077320676352001483245847470289943027 (-100));
     ((Plain Mu), Infinite);
     (FrictionAngle, Decimal 1570796326794896619231321691639751442098584699687552910487472296153908203143104499314017412671058534 (-99));
     (FrictionAngleDegrees, Decimal 9000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 (-98));
     ((Plain Alpha), Decimal 2590843443008954904194295853521347980520922908333081926268911481417758851567292994383166621848185548 (-99));
     ((Degrees Alpha), Decimal 1484443946635561419791516615458374809073430394639745709417312666653309580347585234743038186497765667 (-97));
     ((Plain Thrust), Decimal 0 (0));
     (IntrinsicThrust, Decimal 0 (0));
     ((Plain BetaR), Decimal 0 (0));
     ((Degrees BetaR), Decimal 0 (0));
     ((Plain BetaS), Decimal 0 (0));
     ((Degrees BetaS), Decimal 0 (0));
     (OpeningVariable, Decimal 7320508075688772935274463415058723669428052538103806280558069794519330169088000370811461867572485757 (-100))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.

(** Is the last digit of a printed value right? *)
Corollary table_4_thickness_right x : is_landmark this RotationEnd Milankovitch x -> Rabs (x Eta - 0.9282032302755092) <= 5e-17.
Proof. intros here. exact (right_there _ _ _ _ here (Plain Eta) 9282032302755092 16 eq_refl). Qed.
Corollary table_4_A_right x : is_landmark this RotationEnd Milankovitch x -> Rabs (A (x Alpha) - 0.7320508075688773) <= 5e-17.
Proof. intros here. exact (right_there _ _ _ _ here OpeningVariable 7320508075688773 16 eq_refl). Qed.
Corollary table_4_half_opening_right x : is_landmark this RotationEnd Milankovitch x -> Rabs (x Alpha - 2.590843443008955) <= 5e-16.
Proof. intros here. exact (right_there _ _ _ _ here (Plain Alpha) 2590843443008955 15 eq_refl). Qed.
Corollary table_4_half_opening_degrees_right x : is_landmark this RotationEnd Milankovitch x -> Rabs (180 * x Alpha / PI - 148.4) <= 5e-2.
Proof. intros here. exact (right_there _ _ _ _ here (Degrees Alpha) 1484 1 eq_refl). Qed.
