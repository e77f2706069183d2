(** * An arch at its least thickness: [[r,s,r]], Heyman's self-weight

    The certificate, and that the verified checker accepts it: what it claims is [claim_of] in
    [Certificate].

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Sound.
From Couplet Require Import Enclosures Formulas Equations Certificate.
From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Definition this : certificate :=
  Certificate (State RotationalSlidingRotational (Arch Heyman (Fraction 5221 2000) (Coefficient (Fraction 2 1)))) 30
    (Box [(Dyadic (251707903100948953933237978199806407851) (-130)); (Dyadic (82159712974146983023092369368744529721) (-126)); (Dyadic (74515054615469321667974661098920741961) (-130)); (Dyadic (154816135511477959497008066718965779051) (-129))]
      [(Dyadic (480094725) (-39)); (Dyadic (2948823111) (-50)); (Dyadic (2436571499) (-67)); (Dyadic (3468502481) (-69))])
    [ [(Dyadic (920392919983679482033370943267974845) (-116)); (Dyadic (332082603683024345852333389146632837539) (-125)); (Dyadic (-28056136775176025171719329717813592411) (-122)); (Dyadic (268127018122456469667697702057190639409) (-122))];
      [(Dyadic (-249699870292276943057429958070032200359) (-128)); (Dyadic (-182762150922527960235346233731523519611) (-255)); (Dyadic (197570462255936766451722110861349377325) (-129)); (Dyadic (-59004447202428606113425176255342169203) (-124))];
      [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (150673803756267278494647655326361901883) (-130)); (Dyadic (-179995013364071117058012682903759082185) (-127))];
      [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (294916967577770288148988392004692546459) (-130)); (Dyadic (86633981703680417685930667866410720021) (-129))] ]
    (Box [(Dyadic (2111478929615845202555991569830721631352651531) (-153)); (Dyadic (5645972484363330969299983027614558715683118480173) (-162)); (Dyadic (20974123262482487198040413960703050227272032751050793) (-178)); (Dyadic (348614945100216175775953587486664448523142220946230133) (-180))]
      [(Dyadic (480094725) (-171)); (Dyadic (2948823111) (-182)); (Dyadic (2436571499) (-199)); (Dyadic (3468502481) (-201))])
    [ ((Plain Eta), Decimal 965782784662903802501289936885 (-30));
      ((Plain Thrust), Decimal 547450160948115054905908488709 (-31));
      (IntrinsicThrust, Decimal 528717940904625430651789809534 (-31));
      ((Plain BetaR), Decimal 184925761345305774602404404803 (-30));
      ((Plain BetaS), Decimal 227481865887350094751681565693 (-30)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
