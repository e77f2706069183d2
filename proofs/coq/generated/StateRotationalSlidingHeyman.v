(** * An arch at its least thickness: [[r,r,s]], Heyman's self-weight

    The certificate, and that the verified checker accepts it: what it claims is [claim_of] in
    [Certificate].

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Sound.
From Couplet Require Import Enclosures Formulas Equations Certificate.
From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Definition this : certificate :=
  Certificate (State RotationalSliding (Arch Heyman (Fraction 64 25) (Coefficient (Fraction 9 5)))) 30
    (Box [(Dyadic (287433439836343471696187970857333623823) (-128)); (Dyadic (276498680802183899002331194123319971111) (-128)); (Dyadic (5592033752021580975297381461526528215) (-126)); (Dyadic (337310502900072587581108554674594186809) (-130))]
      [(Dyadic (1595576115) (-35)); (Dyadic (1597115535) (-38)); (Dyadic (2234728961) (-69)); (Dyadic (666824147) (-69))])
    [ [(Dyadic (191215807746887266764030192160204489261) (-127)); (Dyadic (28761137767189727343623159458636015681) (-124)); (Dyadic (-116395154924829435631507817320444847851) (-127)); (Dyadic (233702132072021331155893462008657656535) (-125))];
      [(Dyadic (-83949887236405348965519598301733732487) (-127)); (Dyadic (-298013559609763360235597138726601306005) (-255)); (Dyadic (280919601652780604550433437457525593527) (-130)); (Dyadic (-282019942709286100369708348242172507411) (-127))];
      [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (181401614487756382892287097369417463829) (-130)); (Dyadic (-91056075518079955027485255569783753613) (-126))];
      [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (158941208984417547762146377744396344645) (-129)); (Dyadic (96611499398145920938937992846354406611) (-129))] ]
    (Box [(Dyadic (150697903304916846088650998864849730967096773) (-147)); (Dyadic (579859761441661568160536868418108724054823915) (-149)); (Dyadic (50368562243695257426577142058462731923261060332130541) (-179)); (Dyadic (1519111455168921515785670612487461881163091524286197595) (-182))]
      [(Dyadic (1595576115) (-167)); (Dyadic (1597115535) (-170)); (Dyadic (2234728961) (-201)); (Dyadic (666824147) (-201))])
    [ ((Plain Eta), Decimal 812556593231955130329204721434 (-30));
      ((Plain Thrust), Decimal 657340408510892901295645092116 (-31));
      (IntrinsicThrust, Decimal 534126282933312819391471497194 (-31));
      ((Plain BetaR), Decimal 844690961912599006470406282016 (-30));
      ((Plain BetaS), Decimal 247816619145037596333034524666 (-30)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
