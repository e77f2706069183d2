(** * A certificate, and what it claims

    Of a certificate only the subject and the values are a claim; boxes and matrix say where to look.  [claim_of] is all
    that the checker's theorem is about, in the words of [Arch], [Contact], [FrictionModes] and [States]. *)

From Coq Require Import Reals ZArith Bool List.
From Couplet Require Import Arch States Verdicts Whole Enclosures Formulas Equations.
Import ListNotations.

(** ** What is given *)

(** Exact numbers; an angle in radians. *)
Inductive number :=
  | Fraction (p : Z) (q : positive) | TimesPi (p : Z) (q : positive) | TwiceArctangent (p : Z) (q : positive).
Definition fraction (p : Z) (q : positive) : R := IZR p / IZR (Zpos q).
Definition real (n : number) : R :=
  match n with
  | Fraction p q => fraction p q
  | TimesPi p q => fraction p q * PI
  | TwiceArctangent p q => 2 * atan (fraction p q)
  end.

Inductive friction := Coefficient (mu : number) | Angle (phi : number) | Unlimited.
Definition coefficient (f : friction) : option R :=
  match f with
  | Coefficient mu => Some (real mu)
  | Angle phi => Some (tan (real phi))
  | Unlimited => None
  end.

Definition is_limited (f : friction) : bool := match f with Unlimited => false | _ => true end.

Record arch := Arch { self_weight : weight; half_opening : number; its_friction : friction }.
(** A half opening below half a turn; no friction is negative, and an angle of it is acute. *)
Definition is_arch (a : arch) : Prop :=
  0 < real (half_opening a) < PI /\
  match its_friction a with
  | Coefficient mu => 0 <= real mu
  | Angle phi => 0 <= real phi < PI / 2
  | Unlimited => True
  end.

(** ** What is said of it *)

(** [[r,r,r]], [[s,r,r]], [[r,r,s]], [[r,s,r]], [[r,s]], [[r]] *)
Inductive mode :=
  | Rotational | SlidingRotational | RotationalSliding | RotationalSlidingRotational
  | OverturningSliding | Overturning.
(** T, S, J, B, l, L, sb *)
Inductive landmark := Triple | Shift | Junction | Border | RotationEnd | OverturningEnd | WidestJoint.
(** Where the moment about the intrados is least: a hint for the checker, of which nothing is claimed. *)
Inductive nearest := AtCrown | AtHaunch | AtShoulder.

(** How the motion of an asymmetric solution of (19) closes, beside the slip of the right shoulder: another joint slides
    inwards, the shoulder opens, or it is the slip alone. *)
Inductive kind := SlidesInside | OpensAtShoulder | SlidesAlone.

Inductive subject :=
  | State (m : mode) (a : arch)
  | TooThin (m : mode) (a : arch) (thickness : number)
  | Slides (a : arch)
  | TooWide (a : arch)
  | Stands (a : arch) (thickness : number) (h p : dyadic) (there : nearest)
  | Landmark (l : landmark) (w : weight)
  | Asymmetric (k : kind) (a : arch).

(** A mode's equations; the thrust's moment at the crown; the thickness, and the order of the joints. *)
Definition equations (m : mode) : list equation :=
  match m with
  | Rotational => [LowerThrust BetaR; WholeThrust; Tangency BetaR]
  | SlidingRotational => [LowerThrust BetaR; Tangency BetaR; ShoulderSliding]
  | RotationalSliding | RotationalSlidingRotational =>
      [UpperThrust BetaR; Tangency BetaR; InnerSliding; Steepest]
  | OverturningSliding => [UpperThrust BetaR; InnerSliding; Steepest]
  | Overturning => [WholeThrust]
  end.
Definition crown_moment (m : mode) (d : R) (x : configuration) : R :=
  match m with
  | Rotational | SlidingRotational => at_crown (x Eta) (x Thrust)
  | _ => at_shoulder d (x Alpha) (x Eta) (x Thrust)
  end.
Definition in_order (m : mode) (x : configuration) : Prop :=
  0 < x Eta < 2 /\
  match m with
  | Rotational | SlidingRotational => 0 < x BetaR < x Alpha
  | RotationalSliding => 0 < x BetaS < x BetaR /\ x BetaR < x Alpha
  | RotationalSlidingRotational => 0 < x BetaR < x BetaS /\ x BetaS < x Alpha
  | OverturningSliding => x BetaR = 0 /\ 0 < x BetaS < x Alpha
  | Overturning => x BetaR = 0 /\ x Thrust = 0
  end.

(** An equation holds as it is printed: nothing is divided by zero. *)
Definition holds (d : R) (x : configuration) (e : equation) : Prop :=
  printed d x e /\ (forall f, In f (denominator e) -> meaning x f <> 0) /\
  match e with Tangency b | DoubleThickness b => sin (x b) <> 0 | _ => True end.

(** It stands: an admissible symmetric state exists. *)
Definition stands_with (w : weight) (alpha eta : R) (mu : option R) : Prop :=
  match mu with
  | Some mu => arch_stands (flag w) alpha eta mu
  | None => exists h p, thrust_inside (flag w) alpha eta h p
  end.
Definition stands (a : arch) (eta : R) : Prop :=
  stands_with (self_weight a) (real (half_opening a)) eta (coefficient (its_friction a)).

(** The state is admissible at every joint, and the arch stands exactly from its thickness on. *)
Definition is_admissible (d : R) (mu : option R) (x : configuration) (p : R) : Prop :=
  match mu with
  | Some mu => admissible d (x Alpha) (x Eta) mu (x Thrust) p
  | None => thrust_inside d (x Alpha) (x Eta) (x Thrust) p
  end.
Definition is_least (d : R) (mu : option R) (x : configuration) (p : R) : Prop :=
  is_admissible d mu x p /\
  match mu with
  | Some mu => stands_from d (x Alpha) mu (x Eta)
  | None => stands_without_limit_from d (x Alpha) (x Eta)
  end.

(** The state of an arch. *)
Definition is_state (m : mode) (a : arch) (x : configuration) : Prop :=
  let d := flag (self_weight a) in
  x Alpha = real (half_opening a) /\
  match coefficient (its_friction a) with Some mu => x Mu = mu | None => True end /\
  List.Forall (holds d x) (equations m) /\ in_order m x /\
  is_least d (coefficient (its_friction a)) x (crown_moment m d x).

(** The landmarks: equations, what is fixed, and the state's moment at the crown. *)
Definition equations_of (l : landmark) : list equation :=
  match l with
  | Triple => [LowerThrust BetaR; WholeThrust; Tangency BetaR; ShoulderSliding; InnerSliding; Steepest]
  | Shift => [UpperThrust BetaS; Tangency BetaS; ShoulderSliding; InnerSliding; Steepest]
  | Junction => [UpperThrust BetaR; TangencyAtCrown; ShoulderSliding; InnerSliding; Steepest]
  | Border => [UpperThrust BetaR; ShoulderSliding; InnerSliding; Steepest]
  | RotationEnd => [WholeThrust; TangencyAtCrown]
  | OverturningEnd => [WholeThrust]
  | WidestJoint => [LowerThrust BetaR; WholeThrust; Tangency BetaR; DoubleThickness BetaR]
  end.
Definition is_fixed (l : landmark) (x : configuration) : Prop :=
  match l with
  | Triple | WidestJoint => True
  | Shift => x BetaR = x BetaS
  | Junction => x BetaR = 0
  | Border => x BetaR = 0 /\ x Eta = 2
  | RotationEnd => x BetaR = 0 /\ x BetaS = 0 /\ x Thrust = 0
  | OverturningEnd => x BetaR = 0 /\ x BetaS = 0 /\ x Thrust = 0 /\ x Eta = 2
  end.
(** The modes that meet there, but for pure sliding, whose equations are among those of T, S, J and B. Those of each mode
    hold, where the haunch is the crown with the limit of (5). And the order of the joints. *)
Definition modes_of (l : landmark) : list mode :=
  match l with
  | Triple => [Rotational; SlidingRotational; RotationalSliding]
  | Shift => [RotationalSliding; RotationalSlidingRotational]
  | Junction => [RotationalSlidingRotational; OverturningSliding]
  | Border => [OverturningSliding]
  | RotationEnd => [Rotational; Overturning]
  | OverturningEnd => [Overturning]
  | WidestJoint => [Rotational]
  end.
Definition friction_there (l : landmark) (x : configuration) : option R :=
  match l with Triple | Shift | Junction | Border => Some (x Mu) | _ => None end.
Definition moment_there (l : landmark) (d : R) (x : configuration) : R :=
  match l with
  | Triple | WidestJoint => at_crown (x Eta) (x Thrust)
  | _ => at_shoulder d (x Alpha) (x Eta) (x Thrust)
  end.
Definition is_state_there (l : landmark) (d : R) (x : configuration) (m : mode) : Prop :=
  crown_moment m d x = moment_there l d x /\
  forall e, In e (equations m) ->
    holds d x match l, e with (Junction | RotationEnd), Tangency _ => TangencyAtCrown | _, _ => e end.
Definition in_order_there (l : landmark) (x : configuration) : Prop :=
  0 < x Alpha < PI /\ 0 < x Eta <= 2 /\
  match l with
  | Triple => 0 < x BetaS < x BetaR /\ x BetaR < x Alpha
  | Shift | Junction | Border => 0 < x BetaS < x Alpha
  | WidestJoint => 0 < x BetaR < x Alpha
  | RotationEnd | OverturningEnd => True
  end.
(** What is zero there, as modes meet or the limit begins: friction at the shoulder and inside, and the room at the
    extrados, next to the crown, or up to the limit; at sb the radicand (12). *)
Definition is_zero_there (l : landmark) (d : R) (x : configuration) : Prop :=
  match friction_there l x with
  | Some mu => mu = mu_ss (x Alpha) (x Thrust) /\ mu = mu_is (x Thrust) /\ x BetaS = beta_s (x Thrust)
  | None => True
  end /\
  match l with
  | Triple => at_crown (x Eta) (x Thrust) = at_shoulder d (x Alpha) (x Eta) (x Thrust)
  | Shift => True
  | Junction | RotationEnd => intrados (x Eta) * (2 - x Thrust) = fac d (x Eta)
  | Border | OverturningEnd => fac d 2 * (1 - cos (x Alpha)) = 2 * normal_force (x Alpha) (x Thrust)
  | WidestJoint => radicand d (f_of (x BetaR)) (g_of (x BetaR)) (sin (x BetaR)) = 0
  end.
(** And what is not, of that which the theorems of its modes in [States] ask for. *)
Definition is_left_there (l : landmark) (d : R) (x : configuration) : Prop :=
  0 < normal_force (x Alpha) (x Thrust) /\
  match l with
  | RotationEnd | OverturningEnd => True
  | _ => 0 < x Thrust < 1
  end /\
  match l with
  | Border | OverturningEnd => intrados (x Eta) * (2 - x Thrust) < fac d (x Eta)
  | _ => x Eta < 2 /\ fac d 2 * (1 - cos (x Alpha)) < 2 * normal_force (x Alpha) (x Thrust)
  end /\
  match l with
  | WidestJoint => True
  | _ => 0 < (2 - x Eta) * cos (x BetaR) - (2 + x Eta) * cos (x Alpha)
  end /\
  match l with
  | Triple => 0 < sin (x Alpha) - x Mu * cos (x Alpha)
  | Shift | Junction => at_shoulder d (x Alpha) (x Eta) (x Thrust) < at_crown (x Eta) (x Thrust)
  | _ => True
  end.
(** With less friction nothing stands, whatever its thickness and its weight. *)
Definition is_least_friction (l : landmark) (x : configuration) : Prop :=
  match friction_there l x with
  | Some mu => forall mu', 0 <= mu' < mu -> stands_at_no_thickness (x Alpha) mu'
  | None => True
  end.

(** An asymmetric solution of (19), with its rates. *)
Definition is_asymmetric (k : kind) (d : R) (x : configuration) : Prop :=
  0 < x Eta <= 2 /\ (forall j, - x Alpha <= j <= x Alpha -> 0 <= whole_normal (x Thrust) (x Force) j) /\
  match k with
  | SlidesInside =>
      asymmetric_solution d (x Alpha) (x Mu) (x Eta) (x Thrust) (x Moment) (x Force) (x Hinge) (x BetaR) (x BetaS)
        (x Slip) (x InnerSlip)
  | OpensAtShoulder =>
      shoulder_solution d (x Alpha) (x Mu) (x Eta) (x Thrust) (x Moment) (x Force) (x Hinge) (x BetaR)
        (x Slip) (x Opening) /\ 0 < x Opening
  | SlidesAlone =>
      shoulder_solution d (x Alpha) (x Mu) (x Eta) (x Thrust) (x Moment) (x Force) (x Hinge) (x BetaR) (x Slip) 0
  end.
(** What friction takes. *)
Definition is_power (k : kind) (x : configuration) : Prop :=
  x Power = x Mu * whole_normal (x Thrust) (x Force) (x Alpha) * x Slip
    + match k with
      | SlidesInside => x Mu * whole_normal (x Thrust) (x Force) (- x BetaS) * x InnerSlip
      | _ => 0
      end.

(** ** Decimals *)

Inductive quantity :=
  | Plain (n : name) | Degrees (n : name) | IntrinsicThrust | OpeningVariable
  | FrictionAngle | FrictionAngleDegrees.
(** The variables that a quantity is made of, *)
Definition variables (q : quantity) : list name :=
  match q with
  | Plain n | Degrees n => [n]
  | IntrinsicThrust => [Eta; Thrust]
  | OpeningVariable => [Alpha]
  | FrictionAngle | FrictionAngleDegrees => [Mu]
  end.
(** what is solved for, *)
Definition unknowns_of (m : mode) : list name :=
  match m with
  | Rotational | SlidingRotational => [BetaR; Eta; Thrust]
  | RotationalSliding | RotationalSlidingRotational => [BetaR; Eta; Thrust; BetaS]
  | OverturningSliding => [Eta; Thrust; BetaS]
  | Overturning => [Eta]
  end.
Definition slides_inside (m : mode) : bool :=
  match m with RotationalSliding | RotationalSlidingRotational | OverturningSliding => true | _ => false end.
Definition asymmetric_unknowns (k : kind) : list name :=
  [Thrust; Moment; Force; Eta; Hinge; BetaR] ++ match k with SlidesInside => [BetaS] | _ => [] end.
Definition unknowns_too_wide (f : friction) : list name := if is_limited f then [Alpha; Thrust; BetaS] else [Alpha].
Definition landmark_unknowns (l : landmark) : list name :=
  match l with
  | Triple => [Alpha; BetaR; BetaS; Eta; Thrust; Mu]
  | Shift | Junction => [Alpha; BetaS; Eta; Thrust; Mu]
  | Border => [Alpha; BetaS; Thrust; Mu]
  | RotationEnd => [Alpha; Eta]
  | OverturningEnd => [Alpha]
  | WidestJoint => [Alpha; BetaR; Eta; Thrust]
  end.
Definition unknowns_standing (there : nearest) : list name := match there with AtHaunch => [BetaR] | _ => [] end.
(** and what is a result: what is given is none. *)
Definition results (s : subject) : list name :=
  match s with
  | State m _ => [Eta; Thrust; BetaR] ++ (if slides_inside m then [BetaS] else [])
  | TooThin m _ _ => unknowns_of m
  | Slides _ => [Mu; Thrust; BetaS]
  | TooWide a => unknowns_too_wide (its_friction a)
  | Stands _ _ _ _ there => unknowns_standing there
  | Landmark l _ => [Alpha; BetaR; Eta; Thrust] ++ match l with WidestJoint => [] | _ => [BetaS; Mu] end
  | Asymmetric k _ => asymmetric_unknowns k ++ [Slip; Power] ++
      match k with SlidesInside => [InnerSlip] | OpensAtShoulder => [Opening] | SlidesAlone => [] end
  end.
(** Only of results is something said, and A belongs to landmarks. *)
Definition is_result (s : subject) (q : quantity) : bool :=
  match q, s with OpeningVariable, Landmark _ _ => true | OpeningVariable, _ => false | _, _ => true end
  && forallb (fun n => existsb (same n) (results s)) (variables q).

(** Of friction without limit the angle is a right one. *)
Definition friction_angle (mu : option R) : R := match mu with Some mu => atan mu | None => PI / 2 end.
Definition value_of (mu : option R) (x : configuration) (q : quantity) : R :=
  match q with
  | Plain n => x n
  | Degrees n => 180 * x n / PI
  | IntrinsicThrust => x Eta * x Thrust
  | OpeningVariable => A (x Alpha)
  | FrictionAngle => friction_angle mu
  | FrictionAngleDegrees => 180 * friction_angle mu / PI
  end.

(** [m * 10 ^ e], which is the correct rounding of a number to so many digits; zero is exact. Below a power
    of ten the unit of the last digit is ten times as fine. *)
Inductive written := Infinite | Decimal (m e : Z).
Definition is_rounding (digits : Z) (m e : Z) (x : R) : Prop :=
  let unit := powerRZ 10 e in
  m = 0%Z /\ x = 0 \/
  (10 ^ (digits - 1) <= m < 10 ^ digits)%Z /\
  IZR m * unit - (if (m =? 10 ^ (digits - 1))%Z then unit / 20 else unit / 2) < x < IZR m * unit + unit / 2.
Definition is_value (digits : Z) (mu : option R) (x : configuration) (q : quantity) (v : written) : Prop :=
  match v with
  | Infinite => q = Plain Mu /\ mu = None
  | Decimal m e => (q = Plain Mu -> mu <> None) /\ is_rounding digits m e (value_of mu x q)
  end.

(** ** The certificate *)

Record box := Box { centre : list dyadic; radius : list dyadic }.
Definition in_box (u : list name) (b : box) (x : configuration) : Prop :=
  forall i, (i < length u)%nat ->
    Rabs (x (nth i u Alpha) - value (nth i (centre b) (Dyadic 0 0))) <= value (nth i (radius b) (Dyadic 0 0)).
Record certificate := Certificate {
  about : subject; digits : Z; unique : box; inverse : list (list dyadic); root : box;
  values : list (quantity * written) }.

Definition values_hold (c : certificate) (mu : option R) (x : configuration) : Prop :=
  forall q v, In (q, v) (values c) -> is_result (about c) q = true /\ is_value (digits c) mu x q v.

(** A solution is the only one that the large box has beside what is given. *)
Definition is_only (c : certificate) (w : weight) (u : list name) (e : list equation) (x : configuration) : Prop :=
  in_box u (unique c) x /\
  forall y, in_box u (unique c) y -> (forall n, ~ In n u -> y n = x n) -> List.Forall (holds (flag w) y) e ->
    forall n, y n = x n.
Definition is_only_state (c : certificate) (m : mode) (a : arch) : configuration -> Prop :=
  is_only c (self_weight a) (unknowns_of m) (equations m).

(** A landmark: a solution of its equations, the only one in the large box; a state of each of its modes, from whose
    thickness on the arch stands. *)
Definition solves_there (l : landmark) (w : weight) (x : configuration) : Prop :=
  List.Forall (holds (flag w) x) (equations_of l) /\ is_fixed l x.
Definition is_landmark (c : certificate) (l : landmark) (w : weight) (x : configuration) : Prop :=
  let d := flag w in
  solves_there l w x /\
  (in_box (landmark_unknowns l) (unique c) x /\
   forall y, in_box (landmark_unknowns l) (unique c) y -> solves_there l w y ->
     forall n, In n (landmark_unknowns l) -> y n = x n) /\
  values_hold c (friction_there l x) x /\
  is_least d (friction_there l x) x (moment_there l d x) /\
  (forall m, In m (modes_of l) -> is_state_there l d x m) /\
  in_order_there l x /\ is_zero_there l d x /\ is_left_there l d x /\ is_least_friction l x.

Definition claim_of (c : certificate) : Prop :=
  match about c with
  | State m a =>
      is_arch a /\
      exists x, is_state m a x /\ is_only_state c m a x /\ values_hold c (coefficient (its_friction a)) x
  | TooThin m a t =>
      is_arch a /\
      (exists x, is_state m a x /\ is_only_state c m a x /\ values_hold c (coefficient (its_friction a)) x /\
         real t < x Eta) /\
      0 < real t /\ ~ stands a (real t)
  | Slides a =>
      is_arch a /\
      (exists x, x Alpha = real (half_opening a) /\
         List.Forall (holds (flag (self_weight a)) x) [ShoulderSliding; InnerSliding; Steepest] /\
         0 < x BetaS < x Alpha /\ (exists mu, coefficient (its_friction a) = Some mu /\ mu < x Mu) /\
         values_hold c (Some (x Mu)) x) /\
      forall eta, ~ stands a eta
  | TooWide a =>
      is_arch a /\
      (exists x, x BetaR = 0 /\ x Eta = 2 /\
         match coefficient (its_friction a) with
         | Some mu => x Mu = mu /\
             List.Forall (holds (flag (self_weight a)) x) [UpperThrust BetaR; InnerSliding; Steepest]
         | None => x Thrust = 0 /\ holds (flag (self_weight a)) x WholeThrust
         end /\
         values_hold c (coefficient (its_friction a)) x /\ x Alpha < real (half_opening a)) /\
      forall eta, 0 < eta <= 2 -> ~ stands a eta
  | Stands a t h p _ =>
      is_arch a /\ 0 < real t <= 2 /\ stands a (real t) /\
      exists x, x Alpha = real (half_opening a) /\ x Eta = real t /\ x Thrust = value h /\
        values_hold c (coefficient (its_friction a)) x /\
        is_admissible (flag (self_weight a)) (coefficient (its_friction a)) x (value p)
  | Landmark l w => exists x, is_landmark c l w x
  | Asymmetric k a =>
      is_arch a /\
      exists x, x Alpha = real (half_opening a) /\ coefficient (its_friction a) = Some (x Mu) /\
        is_asymmetric k (flag (self_weight a)) x /\ is_power k x /\ values_hold c (Some (x Mu)) x
  end.
