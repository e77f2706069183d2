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
  Certificate (Asymmetric SlidesAlone (Arch Heyman (Fraction 9 4) (Coefficient (Fraction 101 100)))) 30
    (Box [(Dyadic (9037111111418079255) (-65)); (Dyadic (2813912891283965145) (-63)); (Dyadic (16434246635879152789) (-68)); (Dyadic (146292678339068519) (-58)); (Dyadic (8582651579347790659) (-67)); (Dyadic (10176566229735621213) (-63))]
      [(Dyadic (1834551969) (-41)); (Dyadic (883207475) (-40)); (Dyadic (4108561661) (-39)); (Dyadic (1388139551) (-37)); (Dyadic (998577719) (-37)); (Dyadic (325676709) (-36))])
    [ [(Dyadic (-2870977168473924081) (-62)); (Dyadic (2606985977758079715) (-62)); (Dyadic (-2870977168473924081) (-62)); (Dyadic (759558569397867309) (-62)); (Dyadic (-5618124855005489739) (-62)); (Dyadic (12254155900742818411) (-65))];
      [(Dyadic (-341146875265859923) (-58)); (Dyadic (3012188859786828889) (-63)); (Dyadic (-13546623773221933823) (-66)); (Dyadic (219404120372697887) (-61)); (Dyadic (-9839613043513068403) (-63)); (Dyadic (7079407446995838013) (-65))];
      [(Dyadic (12859365043914019277) (-61)); (Dyadic (-11676924748996222393) (-61)); (Dyadic (12859365043914019277) (-61)); (Dyadic (-1701065585504496725) (-60)); (Dyadic (1317569331829039805) (-58)); (Dyadic (-1715233337657986245) (-59))];
      [(Dyadic (9443116784375149035) (-60)); (Dyadic (-14136375012713492519) (-61)); (Dyadic (9443116784375149035) (-60)); (Dyadic (-16474817851321510753) (-63)); (Dyadic (7455575972106718805) (-60)); (Dyadic (-16612032511403052275) (-62))];
      [(Dyadic (12980079945268234557) (-61)); (Dyadic (-9920457629621672645) (-61)); (Dyadic (12980079945268234557) (-61)); (Dyadic (-13804206970425920143) (-63)); (Dyadic (1318904409515152751) (-58)); (Dyadic (-13919178776744877547) (-62))];
      [(Dyadic (-9511415248581600247) (-61)); (Dyadic (11575015837166411641) (-62)); (Dyadic (-9511415248581600247) (-61)); (Dyadic (-15671770854089971593) (-64)); (Dyadic (-11077333871052916643) (-62)); (Dyadic (13602110812289806595) (-63))] ]
    (Box [(Dyadic (2796850421073810907800199425560604389668053885) (-153)); (Dyadic (6966910870363419612422047063141849738310649227) (-154)); (Dyadic (158942280672233336134959551496325310513326687) (-151)); (Dyadic (362203127940459964780513177630425427459887601) (-149)); (Dyadic (83006312760238554924397236215941829062468711) (-150)); (Dyadic (1574747349778648643974161997208407807928384053) (-150))]
      [(Dyadic (1834551969) (-173)); (Dyadic (883207475) (-172)); (Dyadic (4108561661) (-171)); (Dyadic (1388139551) (-169)); (Dyadic (998577719) (-169)); (Dyadic (325676709) (-168))])
    [ ((Plain Eta), Decimal 507554686956611791197460297596 (-30));
      ((Plain Thrust), Decimal 244951387499809326081991253795 (-30));
      (IntrinsicThrust, Decimal 124326224802053433111912466529 (-30));
      ((Plain Moment), Decimal 305085046991504206467894604316 (-30));
      ((Plain Force), Decimal 556813934555711568573516663765 (-31));
      ((Plain Hinge), Decimal 581583093000938773340485849216 (-31));
      ((Plain BetaR), Decimal 110334552147219795319834128833 (-29));
      ((Plain Slip), Decimal 117649683020138309398552707196 (-29));
      ((Plain Power), Decimal 184592726506351656248594534881 (-29)) ].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
