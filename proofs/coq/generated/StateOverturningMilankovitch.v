(** * An arch at its least thickness: [[r]], Milankovitch's self-weight

    The certificate, and that the verified checker accepts it: what it claims is [claim_of] in
    [Certificate].

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Sound.
From Couplet Require Import Enclosures Formulas Equations Certificate.
From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Definition this : certificate :=
  Certificate (State Overturning (Arch Milankovitch (Fraction 131 50) Unlimited)) 30
    (Box [(Dyadic (1393281328265842705) (-60))]
      [(Dyadic (1660920773) (-31))])
    [ [(Dyadic (-4167000192819591209) (-61))] ]
    (Box [(Dyadic (3368747543455086189659758077798415558774153) (-141))]
      [(Dyadic (1660920773) (-163))])
    [ ((Plain Eta), Decimal 120847891439145273351793208686 (-29));
      ((Plain Thrust), Decimal 0 (0));
      (IntrinsicThrust, Decimal 0 (0));
      ((Plain BetaR), Decimal 0 (0)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
