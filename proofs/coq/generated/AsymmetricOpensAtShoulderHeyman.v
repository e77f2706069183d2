(** * An asymmetric solution of the complementarity problem (19), Heyman's self-weight

    The certificate, and that the verified checker accepts it: what it claims is [claim_of] in
    [Certificate].

    Written by `couplet prove --coq` from a certificate. *)

From Couplet Require Import Sound.
From Couplet Require Import Enclosures Formulas Equations Certificate.
From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Definition this : certificate :=
  Certificate (Asymmetric OpensAtShoulder (Arch Heyman (Fraction 23 10) (Coefficient (Fraction 109 100)))) 30
    (Box [(Dyadic (1984972942724321317) (-63)); (Dyadic (10025035414968804979) (-65)); (Dyadic (1275717621954284321) (-63)); (Dyadic (11792484542468348393) (-64)); (Dyadic (2483950174926131703) (-64)); (Dyadic (4826783953354504665) (-62))]
      [(Dyadic (4161756439) (-42)); (Dyadic (2220387671) (-41)); (Dyadic (2612669691) (-38)); (Dyadic (2852178897) (-38)); (Dyadic (2517219165) (-38)); (Dyadic (3069384535) (-39))])
    [ [(Dyadic (16486303547710923469) (-64)); (Dyadic (16486303547710923469) (-131)); (Dyadic (15912714418802185689) (-65)); (Dyadic (-1) (-64)); (Dyadic (2684508677177956479) (-63)); (Dyadic (-266560823072182207) (-59))];
      [(Dyadic (6396699389886050479) (-63)); (Dyadic (6396699389886050479) (-130)); (Dyadic (8292477864347403875) (-63)); (Dyadic (-7) (-66)); (Dyadic (1017697009600261517) (-60)); (Dyadic (-1831898390598355603) (-61))];
      [(Dyadic (-5174890243059653443) (-59)); (Dyadic (-9786576261487041347) (-126)); (Dyadic (-2497423098760294265) (-59)); (Dyadic (3) (-62)); (Dyadic (-1404755623846097411) (-57)); (Dyadic (1338733572149679589) (-58))];
      [(Dyadic (-5773729511668909829) (-59)); (Dyadic (-10385415530096297733) (-126)); (Dyadic (-292920521060926555) (-56)); (Dyadic (1) (-60)); (Dyadic (-6636406424492953207) (-59)); (Dyadic (13721461372725989555) (-61))];
      [(Dyadic (-9499780602609116023) (-60)); (Dyadic (6864409484242482869) (-63)); (Dyadic (-9236356385149181647) (-61)); (Dyadic (1) (-61)); (Dyadic (-5195284524406676569) (-59)); (Dyadic (305100150627157825) (-56))];
      [(Dyadic (10887951835848972379) (-61)); (Dyadic (10887951835848972379) (-128)); (Dyadic (13382929715022429913) (-63)); (Dyadic (-15614033339165183365) (-63)); (Dyadic (14966245770586252813) (-61)); (Dyadic (-15084438814186729801) (-62))] ]
    (Box [(Dyadic (2457277482696563221482018153705508742382484647) (-153)); (Dyadic (3102598183860952745374319184437163819562854645) (-153)); (Dyadic (49351935094973082318926872371308875846661219) (-148)); (Dyadic (912399298610969177921803818644563480149624011) (-150)); (Dyadic (192186336070686417901781171112430049238127277) (-150)); (Dyadic (1493817279209429654339167946678947844630646193) (-150))]
      [(Dyadic (4161756439) (-174)); (Dyadic (2220387671) (-173)); (Dyadic (2612669691) (-170)); (Dyadic (2852178897) (-170)); (Dyadic (2517219165) (-170)); (Dyadic (3069384535) (-171))])
    [ ((Plain Eta), Decimal 639271867997295655130423352654 (-30));
      ((Plain Thrust), Decimal 215211197682665393419873569512 (-30));
      (IntrinsicThrust, Decimal 137578464356532771972148923293 (-30));
      ((Plain Moment), Decimal 271729129403832470375288391491 (-30));
      ((Plain Force), Decimal 138313581720087650753649910300 (-30));
      ((Plain Hinge), Decimal 134655208800033037792735968614 (-30));
      ((Plain BetaR), Decimal 104664192966902513103479452412 (-29));
      ((Plain Slip), Decimal 123681811598107470009209349533 (-29));
      ((Plain Opening), Decimal 367936439718726971971982664947 (-31));
      ((Plain Power), Decimal 197985383775065663943309850061 (-29)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
