(** * An arch at its least thickness: [[s,r,r]], Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State SlidingRotational (Arch Milankovitch (TimesPi 7 18) (Angle (TimesPi 1 15)))) 30
    (Box [(Dyadic (7251987960515023617) (-63)); (Dyadic (12330444356792912055) (-68)); (Dyadic (14082648981293541081) (-64))] [(Dyadic (3114705113) (-38)); (Dyadic (2647942763) (-42)); (Dyadic (937182285) (-38))])
    [[(Dyadic (-18317570154947377239) (-65)); (Dyadic (16482093876709227367) (-64)); (Dyadic (3784105234513999427) (-61))]; [(Dyadic (4949980479400632841) (-63)); (Dyadic (8845576501019110743) (-127)); (Dyadic (3758479003638678013) (-63))]; [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (-10638334393313302275) (-63))]]
    (Box [(Dyadic (561095391296067069657895576184434223022287847) (-149)); (Dyadic (954021923215900816563651383796652164175389043) (-154)); (Dyadic (544796094785773336046307248137576383529256735) (-149))] [(Dyadic (3114705113) (-170)); (Dyadic (2647942763) (-174)); (Dyadic (937182285) (-170))])
    [((Plain Eta), Decimal 417771704979578237913438311429 (-31));
     ((Plain Thrust), Decimal 763421930993461656612847622000 (-30));
     (IntrinsicThrust, Decimal 318936081729940399088861887002 (-31));
     ((Plain BetaR), Decimal 786262110162911115462182496457 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
