(** * An arch at its least thickness: [[r,r,r]], Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State Rotational (Arch Milankovitch (TimesPi 1 2) (Coefficient (Fraction 1 2)))) 30
    (Box [(Dyadic (17541465246920337661) (-64)); (Dyadic (15860958900104144281) (-67)); (Dyadic (11453236710428617651) (-64))] [(Dyadic (4169178821) (-36)); (Dyadic (1982619863) (-37)); (Dyadic (3488473081) (-39))])
    [[(Dyadic (-11713076804191335069) (-64)); (Dyadic (-13054691612844542911) (-65)); (Dyadic (13507717613648099803) (-64))]; [(Dyadic (16710360942130097887) (-65)); (Dyadic (-7992940579495024333) (-65)); (Dyadic (-6118121331507067547) (-128))]; [(Dyadic (14495770442607890995) (-66)); (Dyadic (3509790812579015181) (-63)); (Dyadic (-5307299026554953485) (-129))]]
    (Box [(Dyadic (339301284013995243874528856015489278835429353) (-148)); (Dyadic (153397781905458799110333550875653229146494477) (-150)); (Dyadic (886151268953297655140642187852470789447459285) (-150))] [(Dyadic (4169178821) (-168)); (Dyadic (1982619863) (-169)); (Dyadic (3488473081) (-171))])
    [((Plain Eta), Decimal 107478038107476313306661592330 (-30));
     ((Plain Thrust), Decimal 620881206171871975730069927697 (-30));
     (IntrinsicThrust, Decimal 667310939371563137793975970235 (-31));
     ((Plain BetaR), Decimal 950924736464500277957538204919 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
