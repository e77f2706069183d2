(** * An arch at its least thickness: [[r,r,s]], Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (State RotationalSliding (Arch Milankovitch (Fraction 49 20) (Coefficient (Fraction 27 20)))) 30
    (Box [(Dyadic (578544836952029883) (-59)); (Dyadic (5997440304982203879) (-63)); (Dyadic (15545944505814016305) (-67)); (Dyadic (11326131529798935379) (-65))] [(Dyadic (2369719653) (-35)); (Dyadic (3558526923) (-38)); (Dyadic (2794709657) (-63)); (Dyadic (3574562415) (-65))])
    [[(Dyadic (14715774339729075147) (-64)); (Dyadic (8830333381280333113) (-63)); (Dyadic (-1742308612081767891) (-61)); (Dyadic (18037168087852464581) (-62))]; [(Dyadic (-4389878715630802259) (-63)); (Dyadic (-5253514171323817151) (-127)); (Dyadic (10489824441465914967) (-65)); (Dyadic (-13574426866081531677) (-63))]; [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (15933459423150812551) (-66)); (Dyadic (-10309399402732660423) (-63))]; [(Dyadic (0) (0)); (Dyadic (0) (0)); (Dyadic (5120796950460008955) (-64)); (Dyadic (3537601311213080389) (-64))]]
    (Box [(Dyadic (89525477273093724887988535198840826959146163) (-146)); (Dyadic (232014733961293516481414501956097737819866899) (-148)); (Dyadic (4926706470977470717061792550859760232516027350283) (-165)); (Dyadic (14357577432013494532501230259344031613169238283867) (-165))] [(Dyadic (2369719653) (-167)); (Dyadic (3558526923) (-170)); (Dyadic (2794709657) (-195)); (Dyadic (3574562415) (-197))])
    [((Plain Eta), Decimal 650243780801383172790041106182 (-30));
     ((Plain Thrust), Decimal 105343417540891550592461472845 (-30));
     (IntrinsicThrust, Decimal 684989021043280686087691282518 (-31));
     ((Plain BetaR), Decimal 100361531056586038811577705434 (-29));
     ((Plain BetaS), Decimal 306995410261614388468836037496 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
