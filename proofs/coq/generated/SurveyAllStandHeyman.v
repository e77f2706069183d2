(** * All arches of a survey, Heyman's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import SurveySound.

Definition this : survey_certificate :=
  SurveyCertificate (Survey Heyman ((Coefficient (Fraction 7 10)), (Coefficient (Fraction 4 5))) (Spanned AtIntrados ((Qmake 9 1), (Qmake 11 1)) ((Qmake 2 1), (Qmake 3 1)) ((Qmake 11 50), (Qmake 1 2)))) AllStand
    [Part (Some (((Qmake 11 1), (Qmake 2 1)), ((Qmake 11 1), (Qmake 3 1))))
    (Certificate (Stands (Arch Heyman (TwiceArctangent 6 11) (Coefficient (Fraction 7 10))) (Fraction 88 3469) (Dyadic (116870126185) (-37)) (Dyadic (29391304459) (-35)) AtHaunch) 10
    (Box [(Dyadic (215046273853119135866727541514894714253) (-128))] [(Dyadic (3819989195) (-37))])
    [[(Dyadic (96791965741925842771782424724335742403) (-126))]]
    (Box [(Dyadic (901969446607233004042358794286088959568817701) (-150))] [(Dyadic (3819989195) (-172))])
    []);
     Part (Some (((Qmake 11 1), (Qmake 3 1)), ((Qmake 10 1), (Qmake 3 1))))
    (Certificate (Stands (Arch Heyman (TwiceArctangent 3 5) (Coefficient (Fraction 7 10))) (Fraction 132 3991) (Dyadic (56745207887) (-36)) (Dyadic (228781210381) (-38)) AtHaunch) 10
    (Box [(Dyadic (115106022343651054775471284918607289795) (-127))] [(Dyadic (1277933563) (-35))])
    [[(Dyadic (22504665407411177995395189522347354147) (-124))]]
    (Box [(Dyadic (3862317199520519949191826497754033840122852393) (-152))] [(Dyadic (1277933563) (-171))])
    []);
     Part (Some (((Qmake 10 1), (Qmake 3 1)), ((Qmake 9 1), (Qmake 3 1))))
    (Certificate (Stands (Arch Heyman (TwiceArctangent 2 3) (Coefficient (Fraction 7 10))) (Fraction 66 1733) (Dyadic (53940555711) (-36)) (Dyadic (6850711083) (-33)) AtHaunch) 10
    (Box [(Dyadic (127832019629210751753816364966836929103) (-127))] [(Dyadic (443506411) (-33))])
    [[(Dyadic (80020664868951883068401995033364501803) (-126))]]
    (Box [(Dyadic (1072332702517754345848077989691727998167455083) (-150))] [(Dyadic (443506411) (-167))])
    [])].

Theorem claim : claim_of_survey this.
Proof. apply sound_survey. vm_cast_no_check (eq_refl true). Qed.
