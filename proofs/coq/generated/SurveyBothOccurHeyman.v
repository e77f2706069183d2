(** * All arches of a survey, Heyman's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import SurveySound.

Definition this : survey_certificate :=
  SurveyCertificate (Survey Heyman ((Angle (TimesPi 29 180)), (Angle (TimesPi 11 60))) (Spanned AtIntrados ((Qmake 99 10), (Qmake 101 10)) ((Qmake 59 20), (Qmake 61 20)) ((Qmake 1 10), (Qmake 1 2)))) BothOccur
    [Part (Some (((Qmake 101 10), (Qmake 59 20)), ((Qmake 101 10), (Qmake 59 20))))
    (Certificate (TooThin Rotational (Arch Heyman (TwiceArctangent 59 101) (Angle (TimesPi 29 180))) (Fraction 59 3450)) 10
    (Box [(Dyadic (6405543617025824527) (-63)); (Dyadic (13998676766608578511) (-69)); (Dyadic (7579850205917113341) (-63))] [(Dyadic (2139355935) (-36)); (Dyadic (2187293245) (-39)); (Dyadic (4288088005) (-41))])
    [[(Dyadic (-4346683284384169673) (-62)); (Dyadic (-13831339552819302891) (-63)); (Dyadic (9429089472498180229) (-63))]; [(Dyadic (8602112712070932511) (-64)); (Dyadic (-2110011131854399641) (-63)); (Dyadic (4396986811901920099) (-126))]; [(Dyadic (8401688111534808029) (-65)); (Dyadic (15852880301808513833) (-64)); (Dyadic (17178157534389245647) (-129))]]
    (Box [(Dyadic (6716699303766470979193647) (-83)); (Dyadic (917417280576459801294053) (-85)); (Dyadic (127168784152315888621011917) (-87))] [(Dyadic (2139355935) (-102)); (Dyadic (2187293245) (-105)); (Dyadic (4288088005) (-107))])
    [((Plain Eta), Decimal 2371468088 (-11));
     ((Plain Thrust), Decimal 8218090060 (-10));
     (IntrinsicThrust, Decimal 1948893832 (-11));
     ((Plain BetaR), Decimal 6944904306 (-10))]);
     Part (Some (((Qmake 101 10), (Qmake 59 20)), ((Qmake 101 10), (Qmake 59 20))))
    (Certificate (Stands (Arch Heyman (TwiceArctangent 59 101) (Angle (TimesPi 11 60))) (Fraction 295 3568) (Dyadic (29767791419) (-35)) (Dyadic (29715498787) (-35)) AtHaunch) 10
    (Box [(Dyadic (175731091792648788339460363547591313807) (-128))] [(Dyadic (2497289015) (-37))])
    [[(Dyadic (124280505473411091549968864276880884007) (-126))]]
    (Box [(Dyadic (184267405307568495881837990167279109466877557) (-148))] [(Dyadic (2497289015) (-170))])
    [])].

Theorem claim : claim_of_survey this.
Proof. apply sound_survey. vm_cast_no_check (eq_refl true). Qed.
