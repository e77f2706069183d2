(** * An arch that slides, Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import Sound.

Definition this : certificate :=
  Certificate (Slides (Arch Milankovitch (TimesPi 1 2) (Coefficient (Fraction 3 10)))) 30
    (Box [(Dyadic (2852009082599055217) (-63)); (Dyadic (17919701563729115375) (-65)); (Dyadic (9219606731222487253) (-64))] [(Dyadic (217591025) (-31)); (Dyadic (1367164731) (-33)); (Dyadic (595854677) (-33))])
    [[(Dyadic (15010710898531524131) (-65)); (Dyadic (2429230265371113857) (-62)); (Dyadic (-14593752337642400235) (-64))]; [(Dyadic (-13314718605425662987) (-65)); (Dyadic (15263303911135750393) (-64)); (Dyadic (-11461906283061559093) (-63))]; [(Dyadic (-1522282439601687793) (-67)); (Dyadic (6980263031546930123) (-68)); (Dyadic (17799053298895409539) (-64))]]
    (Box [(Dyadic (55165878683670871448478690081184113385004617) (-147)); (Dyadic (43327179800361545763531917634948020493617243) (-146)); (Dyadic (89166564992541580396620203504504631890968413) (-147))] [(Dyadic (217591025) (-163)); (Dyadic (1367164731) (-165)); (Dyadic (595854677) (-165))])
    [((Plain Mu), Decimal 309215444330228612685033707936 (-30));
     ((Plain Thrust), Decimal 485714484142174946857937626996 (-30));
     ((Plain BetaS), Decimal 499795882372670042124496495535 (-30))].

Theorem claim : claim_of this.
Proof. apply sound. vm_cast_no_check (eq_refl true). Qed.
