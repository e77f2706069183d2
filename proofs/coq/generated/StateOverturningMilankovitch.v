(** * An arch at its least thickness: [[r]], Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State Overturning (Arch Milankovitch (Fraction 131 50) Unlimited)) 30
    (Box [(Dyadic (1393281328265842705) (-60))] [(Dyadic (1660920773) (-31))])
    [[(Dyadic (-4167000192819591209) (-61))]]
    (Box [(Dyadic (3368747543455086189659758077798415558774153) (-141))] [(Dyadic (1660920773) (-163))])
    [((Plain Eta), Decimal 120847891439145273351793208686 (-29));
     ((Plain Thrust), Decimal 0 (0));
     (IntrinsicThrust, Decimal 0 (0));
     ((Plain BetaR), Decimal 0 (0))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
