(** * An arch at its least thickness: [[r,s]], Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State OverturningSliding (Arch Milankovitch (Fraction 64 25) (Coefficient (Fraction 9 5)))) 30
    (Box [(Dyadic (9093193986694119463) (-63)); (Dyadic (4850316114043251733) (-66)); (Dyadic (2285704875290229645) (-63))] [(Dyadic (4234348417) (-32)); (Dyadic (4047564027) (-40)); (Dyadic (1235527119) (-40))])
    [[(Dyadic (-11331895614650166779) (-63)); (Dyadic (10599085270805922669) (-64)); (Dyadic (-332518784206511551) (-56))]; [(Dyadic (0) (0)); (Dyadic (9833801226000171295) (-66)); (Dyadic (-2468079872367661023) (-61))]; [(Dyadic (0) (0)); (Dyadic (4308110101959452029) (-64)); (Dyadic (10474639753455181159) (-66))]]
    (Box [(Dyadic (2748249248319751447515746650661986906733807) (-141)); (Dyadic (375275032547826002736219332057705014372326883) (-152)); (Dyadic (2829565583111572108763587870611738192221320279) (-153))] [(Dyadic (4234348417) (-164)); (Dyadic (4047564027) (-172)); (Dyadic (1235527119) (-172))])
    [((Plain Eta), Decimal 985886067520588942149927838368 (-30));
     ((Plain Thrust), Decimal 657340408510892901295645092116 (-31));
     (IntrinsicThrust, Decimal 648062750369181677015669901574 (-31));
     ((Plain BetaR), Decimal 0 (0));
     ((Plain BetaS), Decimal 247816619145037596333034524666 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
