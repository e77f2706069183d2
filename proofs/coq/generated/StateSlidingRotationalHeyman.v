(** * An arch at its least thickness: [[s,r,r]], Heyman's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State SlidingRotational (Arch Heyman (TimesPi 1 2) (Coefficient (Fraction 19 50)))) 30
    (Box [(Dyadic (2245284993337513557) (-61)); (Dyadic (18032295372723736699) (-67)); (Dyadic (344090924258663335) (-59))] [(Dyadic (1506785253) (-36)); (Dyadic (1512658573) (-39)); (Dyadic (2495052031) (-38))])
    [[(Dyadic (-4046600433377990043) (-63)); (Dyadic (13204804514352179329) (-64)); (Dyadic (8082494742747656339) (-63))]; [(Dyadic (2653807146294029631) (-62)); (Dyadic (15197480680852313463) (-128)); (Dyadic (5660377052469714269) (-63))]; [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (-1) (0))]]
    (Box [(Dyadic (694882048214779080395869338515328961933939557) (-149)); (Dyadic (697590638816100111128311133298213496702793511) (-152)); (Dyadic (425963932294512497589410638648061091018696023) (-149))] [(Dyadic (1506785253) (-168)); (Dyadic (1512658573) (-171)); (Dyadic (2495052031) (-170))])
    [((Plain Eta), Decimal 122191586362546151524798839379 (-30));
     ((Plain Thrust), Decimal 596902604182060715307902242823 (-30));
     (IntrinsicThrust, Decimal 729364761089409735331034628635 (-31));
     ((Plain BetaR), Decimal 973737147050253418996670592431 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
