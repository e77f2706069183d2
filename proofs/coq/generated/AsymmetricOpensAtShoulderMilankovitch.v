(** * An asymmetric solution of the complementarity problem (19), Milankovitch's self-weight

    The certificate, and that the verified checker accepts it: what it claims is [claim_of] in
    [Certificate].

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Sound.
From Couplet Require Import Enclosures Formulas Equations Certificate.
From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Definition this : certificate :=
  Certificate (Asymmetric OpensAtShoulder (Arch Milankovitch (Fraction 23 10) (Coefficient (Fraction 107 100)))) 30
    (Box [(Dyadic (15236168881786655147) (-66)); (Dyadic (4753016252367611615) (-64)); (Dyadic (6983230784208707335) (-69)); (Dyadic (18318203367100292191) (-65)); (Dyadic (7155421561998584559) (-69)); (Dyadic (10164583937809868077) (-63))]
      [(Dyadic (2353741239) (-42)); (Dyadic (2803841107) (-43)); (Dyadic (815081341) (-37)); (Dyadic (4019070141) (-39)); (Dyadic (852992721) (-37)); (Dyadic (330264505) (-36))])
    [ [(Dyadic (-1481140285291757411) (-60)); (Dyadic (-1) (-67)); (Dyadic (-5210617802273391273) (-63)); (Dyadic (3) (-66)); (Dyadic (-4758705010979005421) (-61)); (Dyadic (13277008960121336029) (-64))];
      [(Dyadic (-9587240006179293849) (-63)); (Dyadic (-1) (-68)); (Dyadic (1221493300225250303) (-64)); (Dyadic (0) (0)); (Dyadic (-4450938275514239281) (-62)); (Dyadic (1949229238874286383) (-64))];
      [(Dyadic (16413016556989581701) (-60)); (Dyadic (1) (-64)); (Dyadic (14435154642359144265) (-61)); (Dyadic (-1) (-61)); (Dyadic (8803754451950059231) (-59)); (Dyadic (-9195439235810009567) (-60))];
      [(Dyadic (9936639890132078353) (-59)); (Dyadic (1) (-64)); (Dyadic (9672496632624362597) (-60)); (Dyadic (-1) (-61)); (Dyadic (5142539989328332483) (-58)); (Dyadic (-5100391573819897053) (-59))];
      [(Dyadic (8367445987805256999) (-59)); (Dyadic (3785882911377861007) (-62)); (Dyadic (7356093249849989195) (-60)); (Dyadic (-1) (-61)); (Dyadic (2243177863411606007) (-57)); (Dyadic (-4689399362880262401) (-59))];
      [(Dyadic (-11577030078188742381) (-60)); (Dyadic (0) (0)); (Dyadic (-1537387236965363319) (-58)); (Dyadic (-7699304023143484455) (-62)); (Dyadic (-5342250760817872991) (-59)); (Dyadic (339217570645455569) (-56))] ]
    (Box [(Dyadic (4715365876019415081523571402841714427654508263) (-154)); (Dyadic (2941974563090006024924365380128461564637886077) (-153)); (Dyadic (33768831997430484621998943072474898607649279) (-151)); (Dyadic (88581396077756722439682728191357413710713499) (-147)); (Dyadic (17300747753054657928760688621108015608509013) (-150)); (Dyadic (3145786359822973354975295555380416796020875727) (-151))]
      [(Dyadic (2353741239) (-174)); (Dyadic (2803841107) (-175)); (Dyadic (815081341) (-169)); (Dyadic (4019070141) (-171)); (Dyadic (852992721) (-169)); (Dyadic (330264505) (-168))])
    [ ((Plain Eta), Decimal 496515897166035477330853706015 (-30));
      ((Plain Thrust), Decimal 206488592524864128753117125381 (-30));
      (IntrinsicThrust, Decimal 102524868772034839714219407119 (-30));
      ((Plain Moment), Decimal 257661527333793756049517110241 (-30));
      ((Plain Force), Decimal 118300531050105207863759065475 (-31));
      ((Plain Hinge), Decimal 121217556290132608367776422196 (-31));
      ((Plain BetaR), Decimal 110204639877847224634733206671 (-29));
      ((Plain Slip), Decimal 114364392144099809899750106074 (-29));
      ((Plain Opening), Decimal 475791420582292427048968347952 (-31));
      ((Plain Power), Decimal 191964336239808659159039614737 (-29)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
