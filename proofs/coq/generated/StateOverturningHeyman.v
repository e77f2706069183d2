(** * An arch at its least thickness: [[r]], Heyman's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State Overturning (Arch Heyman (Fraction 27 10) Unlimited)) 30
    (Box [(Dyadic (11991898737503461595) (-63))] [(Dyadic (2792081501) (-31))])
    [[(Dyadic (-7993038220434263461) (-63))]]
    (Box [(Dyadic (1812164501246501143489193595754213996632625) (-140))] [(Dyadic (2792081501) (-163))])
    [((Plain Eta), Decimal 130016426634274309277312020229 (-29));
     ((Plain Thrust), Decimal 0 (0));
     (IntrinsicThrust, Decimal 0 (0));
     ((Plain BetaR), Decimal 0 (0))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
