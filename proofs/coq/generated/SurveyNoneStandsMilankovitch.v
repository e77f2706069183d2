(** * All arches of a survey, Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import SurveySound.

Definition this : survey_certificate :=
  SurveyCertificate (Survey Milankovitch ((Coefficient (Fraction 1 2)), Unlimited) (Spanned AtIntrados ((Qmake 99 10), (Qmake 101 10)) ((Qmake 47 10), (Qmake 49 10)) ((Qmake 2 25), (Qmake 1 10)))) NoneStands
    [Part (Some (((Qmake 101 10), (Qmake 47 10)), ((Qmake 99 10), (Qmake 47 10))))
    (Certificate (TooThin Rotational (Arch Milankovitch (TwiceArctangent 94 101) Unlimited) (Fraction 376 18825)) 10
    (Box [(Dyadic (4240669369136784107) (-62)); (Dyadic (829657022948188063) (-63)); (Dyadic (752923593650125741) (-60))] [(Dyadic (3666306341) (-36)); (Dyadic (3318628093) (-38)); (Dyadic (2984651565) (-39))])
    [[(Dyadic (-12191091124465716877) (-64)); (Dyadic (-1972963354213081097) (-62)); (Dyadic (6982681421287606417) (-63))]; [(Dyadic (16725690303992589893) (-65)); (Dyadic (-16071721911767010403) (-66)); (Dyadic (791400954534502399) (-125))]; [(Dyadic (3711834158624888731) (-64)); (Dyadic (7724804676756671649) (-64)); (Dyadic (11240381636896045597) (-130))]]
    (Box [(Dyadic (4446664124411972531815799) (-82)); (Dyadic (869958442494919246335055) (-83)); (Dyadic (25263923524328775967625121) (-85))] [(Dyadic (3666306341) (-102)); (Dyadic (3318628093) (-104)); (Dyadic (2984651565) (-105))])
    [((Plain Eta), Decimal 8995159467 (-11));
     ((Plain Thrust), Decimal 6530571168 (-10));
     (IntrinsicThrust, Decimal 5874352906 (-11));
     ((Plain BetaR), Decimal 9195485886 (-10))]);
     Part (Some (((Qmake 99 10), (Qmake 47 10)), ((Qmake 99 10), (Qmake 49 10))))
    (Certificate (TooThin Rotational (Arch Milankovitch (TwiceArctangent 94 99) Unlimited) (Fraction 392 19601)) 10
    (Box [(Dyadic (2140836708597409689) (-61)); (Dyadic (6979948666899722513) (-66)); (Dyadic (11884165492442379871) (-64))] [(Dyadic (1900499651) (-35)); (Dyadic (3489974335) (-38)); (Dyadic (780122567) (-37))])
    [[(Dyadic (-12049594854736596245) (-64)); (Dyadic (-3743053677272717419) (-63)); (Dyadic (6915309976585796151) (-63))]; [(Dyadic (1044936954276627949) (-61)); (Dyadic (-16046052101872248243) (-66)); (Dyadic (-12535221029252067239) (-129))]; [(Dyadic (14750960618034382449) (-66)); (Dyadic (1879519905714928263) (-62)); (Dyadic (-11059671529947575753) (-130))]]
    (Box [(Dyadic (4489659985108474924053869) (-82)); (Dyadic (914875831667880429223419) (-83)); (Dyadic (12461450715403260915689223) (-84))] [(Dyadic (1900499651) (-101)); (Dyadic (3489974335) (-104)); (Dyadic (780122567) (-103))])
    [((Plain Eta), Decimal 9459594386 (-11));
     ((Plain Thrust), Decimal 6442419023 (-10));
     (IntrinsicThrust, Decimal 6094267082 (-11));
     ((Plain BetaR), Decimal 9284399242 (-10))])].

Theorem claim : claim_of_survey this.
Proof. apply sound_survey. vm_cast_no_check (eq_refl true). Qed.
