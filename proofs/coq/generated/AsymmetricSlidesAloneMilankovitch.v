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
  Certificate (Asymmetric SlidesAlone (Arch Milankovitch (Fraction 9 4) (Coefficient (Fraction 99 100)))) 30
    (Box [(Dyadic (8104990151041007029) (-65)); (Dyadic (5087474015825002675) (-64)); (Dyadic (12683226956367943117) (-67)); (Dyadic (10232444449967472207) (-64)); (Dyadic (50694033614586169) (-59)); (Dyadic (4904100734677115675) (-62))]
      [(Dyadic (4120161109) (-42)); (Dyadic (810395639) (-39)); (Dyadic (2536645391) (-38)); (Dyadic (3465308529) (-38)); (Dyadic (1189463053) (-37)); (Dyadic (597696995) (-36))])
    [ [(Dyadic (-15124638473181054003) (-65)); (Dyadic (883645735831460909) (-61)); (Dyadic (-15124638473181054003) (-65)); (Dyadic (13672742919418156075) (-67)); (Dyadic (-2436338210463794219) (-61)); (Dyadic (1036037307326263407) (-62))];
      [(Dyadic (-12021035082921084739) (-63)); (Dyadic (7872691614230695177) (-64)); (Dyadic (-2797663046066308931) (-63)); (Dyadic (15226872625593422359) (-67)); (Dyadic (-5484451973578277087) (-62)); (Dyadic (9230398439871277169) (-65))];
      [(Dyadic (9311734036295333305) (-61)); (Dyadic (-17408995980082466193) (-62)); (Dyadic (9311734036295333305) (-61)); (Dyadic (-8417850505188599629) (-63)); (Dyadic (7774798891355163385) (-61)); (Dyadic (-2551414071710419921) (-60))];
      [(Dyadic (14182708118404841791) (-61)); (Dyadic (-10231862772878190231) (-61)); (Dyadic (14182708118404841791) (-61)); (Dyadic (-9894917697750551307) (-63)); (Dyadic (5634629123480741019) (-60)); (Dyadic (-2999106747844484069) (-60))];
      [(Dyadic (18268380174528665807) (-62)); (Dyadic (-13500220055624547285) (-62)); (Dyadic (18268380174528665807) (-62)); (Dyadic (-2080306122215337691) (-61)); (Dyadic (3745224534990765681) (-60)); (Dyadic (-10088508576699426433) (-62))];
      [(Dyadic (-10140621906410726343) (-61)); (Dyadic (11877775101430420485) (-62)); (Dyadic (-10140621906410726343) (-61)); (Dyadic (-9650320022693954297) (-63)); (Dyadic (-12121486815819654615) (-62)); (Dyadic (13926189686790969147) (-63))] ]
    (Box [(Dyadic (2508372956496831112287967421940793390804416077) (-153)); (Dyadic (3148993891506877581048941447299753056700457373) (-153)); (Dyadic (61332322174341896859306649596991893388614547) (-149)); (Dyadic (791697042773637743931261939685043861942399083) (-150)); (Dyadic (15689043491093797567610912844403825722037321) (-147)); (Dyadic (379436416009103177918705306485075245184943281) (-148))]
      [(Dyadic (4120161109) (-174)); (Dyadic (810395639) (-171)); (Dyadic (2536645391) (-170)); (Dyadic (3465308529) (-170)); (Dyadic (1189463053) (-169)); (Dyadic (597696995) (-168))])
    [ ((Plain Eta), Decimal 554701925124598792378007171150 (-30));
      ((Plain Thrust), Decimal 219686198243306913439383545379 (-30));
      (IntrinsicThrust, Decimal 121860357088866598253865945274 (-30));
      ((Plain Moment), Decimal 275792519021051073247243614677 (-30));
      ((Plain Force), Decimal 859448888763802255214130767056 (-31));
      ((Plain Hinge), Decimal 879401302031800214551688013833 (-31));
      ((Plain BetaR), Decimal 106340733412493743696975018574 (-29));
      ((Plain Slip), Decimal 118405580231708000666730803623 (-29));
      ((Plain Power), Decimal 181200118550133571298302867011 (-29)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
