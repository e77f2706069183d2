(** * An arch at its least thickness: [[r,s,r]], Milankovitch's self-weight

    The certificate, and that the verified checker accepts it: what it claims is [claim_of] in
    [Certificate].

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Sound.
From Couplet Require Import Enclosures Formulas Equations Certificate.
From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Definition this : certificate :=
  Certificate (State RotationalSlidingRotational (Arch Milankovitch (Fraction 317 125) (Coefficient (Fraction 8 5)))) 30
    (Box [(Dyadic (145615065714005634737416045345056406867) (-129)); (Dyadic (37508620749256551033929804427244571769) (-125)); (Dyadic (218222120250177328842038924607801077039) (-131)); (Dyadic (92401655743028788486883411731446700391) (-128))]
      [(Dyadic (2777386965) (-41)); (Dyadic (148319337) (-44)); (Dyadic (2756344833) (-65)); (Dyadic (4093150223) (-67))])
    [ [(Dyadic (299573805920206200057106366363440799981) (-124)); (Dyadic (132526663866020635535245630170648652917) (-124)); (Dyadic (-24170898418670291990330411957247570367) (-121)); (Dyadic (5033651500183722361838295651661740475) (-116))];
      [(Dyadic (-174939960460387050919630378406986995777) (-127)); (Dyadic (204396803276515033721480250863868175503) (-256)); (Dyadic (49401044426447733464272918054649396923) (-126)); (Dyadic (-164606304378494008743084344839451046869) (-125))];
      [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (55512123134262653369528649591320119701) (-128)); (Dyadic (-92484334525960701116184464382587527859) (-126))];
      [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (171656051213597462971803662838163177719) (-129)); (Dyadic (218417380163714834308697938414933468569) (-130))] ]
    (Box [(Dyadic (610753852584516689801683068654951467547652451) (-151)); (Dyadic (1288786395488991224035867970997531577129640478461) (-160)); (Dyadic (15356016553792159180016758475153657894620182347098057) (-177)); (Dyadic (208070031186360651762979610742733570282147082408333447) (-179))]
      [(Dyadic (2777386965) (-173)); (Dyadic (148319337) (-176)); (Dyadic (2756344833) (-197)); (Dyadic (4093150223) (-199))])
    [ ((Plain Eta), Decimal 881823435957734254482435124691 (-30));
      ((Plain Thrust), Decimal 801621467432954249987753348483 (-31));
      (IntrinsicThrust, Decimal 706888596749208687411065451916 (-31));
      ((Plain BetaR), Decimal 213962108926787236263337247252 (-30));
      ((Plain BetaS), Decimal 271544060831390299966991836828 (-30)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
