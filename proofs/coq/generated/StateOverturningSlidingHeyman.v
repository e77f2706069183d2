(** * An arch at its least thickness: [[r,s]], Heyman's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State OverturningSliding (Arch Heyman (Fraction 53 20) (Coefficient (Fraction 2 1)))) 30
    (Box [(Dyadic (5382107375393765717) (-62)); (Dyadic (8078938409696785277) (-67)); (Dyadic (8392599522867732743) (-65))] [(Dyadic (2670310111) (-33)); (Dyadic (3762048859) (-36)); (Dyadic (1108063567) (-36))])
    [[(Dyadic (-14670968944628759795) (-64)); (Dyadic (2943545831790859257) (-63)); (Dyadic (-14065446232126824559) (-62))]; [(Dyadic (0) (0)); (Dyadic (8168043268459977089) (-66)); (Dyadic (-9757549226294165449) (-63))]; [(Dyadic (0) (0)); (Dyadic (7993740423766390519) (-65)); (Dyadic (9392875117419975151) (-66))]]
    (Box [(Dyadic (52052548560414791047873924783892395633066573) (-145)); (Dyadic (19533674477117589859329549559115478980608315) (-148)); (Dyadic (162336484110083512857534730567906260734024561) (-149))] [(Dyadic (2670310111) (-165)); (Dyadic (3762048859) (-168)); (Dyadic (1108063567) (-168))])
    [((Plain Eta), Decimal 116705850179043542809241297070 (-29));
     ((Plain Thrust), Decimal 547450160948115054905908488709 (-31));
     (IntrinsicThrust, Decimal 638906364641039897082305961779 (-31));
     ((Plain BetaR), Decimal 0 (0));
     ((Plain BetaS), Decimal 227481865887350094751681565693 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
