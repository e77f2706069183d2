(** * An arch at its least thickness: [[r,r,r]], Heyman's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State Rotational (Arch Heyman (TimesPi 1 2) Unlimited)) 30
    (Box [(Dyadic (17545447362564116185) (-64)); (Dyadic (7926673122903062799) (-66)); (Dyadic (11469659945610006215) (-64))] [(Dyadic (2084274527) (-35)); (Dyadic (3963336563) (-38)); (Dyadic (1802674627) (-38))])
    [[(Dyadic (-11657963177304654147) (-64)); (Dyadic (-13097921195677819167) (-65)); (Dyadic (1687928848833260955) (-61))]; [(Dyadic (4171139711347008117) (-63)); (Dyadic (-15965562991705839947) (-66)); (Dyadic (0) (0))]; [(Dyadic (15026916223087358851) (-66)); (Dyadic (1738947424163070701) (-62)); (Dyadic (0) (0))]]
    (Box [(Dyadic (339378309332690526901526594964393747839810075) (-148)); (Dyadic (153324156830765398583091196593651330454097137) (-150)); (Dyadic (887421955228650230022269936695297341229976279) (-150))] [(Dyadic (2084274527) (-167)); (Dyadic (3963336563) (-170)); (Dyadic (1802674627) (-170))])
    [((Plain Eta), Decimal 107426452755424482251226616141 (-30));
     ((Plain Thrust), Decimal 621771511535017068147116404380 (-30));
     (IntrinsicThrust, Decimal 667947079085853795703897757754 (-31));
     ((Plain BetaR), Decimal 951140607386103937413903746402 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
