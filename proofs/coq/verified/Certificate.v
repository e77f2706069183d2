(** * A certificate, and what it claims

    Of a certificate only the subject and the values are a claim; boxes and matrix say where to look.
    [claim_of] is all that the checker's theorem is about.  Its words are those of [Arch], [Contact],
    [FrictionModes] and [States]. *)

From Coq Require Import Reals ZArith List.
From Couplet Require Import Arch States Verdicts Whole Enclosures Formulas Equations.
Import ListNotations.
Open Scope R_scope.

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

Record arch := Arch { self_weight : weight; half_opening : number; its_friction : friction }.

(** ** What is said of it *)

(** [[r,r,r]], [[s,r,r]], [[r,r,s]], [[r,s,r]], [[r,s]], [[r]] *)
Inductive mode :=
  | Rotational | SlidingRotational | RotationalSliding | RotationalSlidingRotational
  | OverturningSliding | Overturning.
(** T, S, J, B, l, L, sb *)
Inductive landmark := Triple | Shift | Junction | Border | RotationEnd | OverturningEnd | WidestJoint.
(** Where the line of thrust comes nearest to the intrados. *)
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

(** A mode's equations; the thrust's moment at the crown; and the order of the joints. *)
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
  match m with
  | Rotational | SlidingRotational => 0 < x BetaR < x Alpha
  | RotationalSliding => 0 < x BetaS < x BetaR /\ x BetaR < x Alpha
  | RotationalSlidingRotational => 0 < x BetaR < x BetaS /\ x BetaS < x Alpha
  | OverturningSliding => x BetaR = 0 /\ 0 < x BetaS < x Alpha
  | Overturning => x BetaR = 0 /\ x Thrust = 0
  end.

(** It stands: an admissible symmetric state exists. *)
Definition stands (a : arch) (eta : R) : Prop :=
  let d := flag (self_weight a) in
  let alpha := real (half_opening a) in
  match coefficient (its_friction a) with
  | Some mu => arch_stands d alpha eta mu
  | None => exists h p, thrust_inside d alpha eta h p
  end.

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
  List.Forall (printed d x) (equations m) /\ in_order m x /\
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
  | RotationEnd => x BetaR = 0 /\ x Thrust = 0
  | OverturningEnd => x BetaR = 0 /\ x Thrust = 0 /\ x Eta = 2
  end.
Definition friction_there (l : landmark) (x : configuration) : option R :=
  match l with Triple | Shift | Junction | Border => Some (x Mu) | _ => None end.
Definition moment_there (l : landmark) (d : R) (x : configuration) : R :=
  match l with
  | Triple | WidestJoint => at_crown (x Eta) (x Thrust)
  | _ => at_shoulder d (x Alpha) (x Eta) (x Thrust)
  end.

(** An asymmetric solution of (19), with its rates. *)
Definition is_asymmetric (k : kind) (d : R) (x : configuration) : Prop :=
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
Record certificate := Certificate {
  about : subject; digits : Z; unique : box; inverse : list (list dyadic); root : box;
  values : list (quantity * written) }.

Definition values_hold (c : certificate) (mu : option R) (x : configuration) : Prop :=
  forall q v, In (q, v) (values c) -> is_value (digits c) mu x q v.

Definition claim_of (c : certificate) : Prop :=
  match about c with
  | State m a =>
      exists x, is_state m a x /\ values_hold c (coefficient (its_friction a)) x
  | TooThin m a t =>
      (exists x, is_state m a x /\ values_hold c (coefficient (its_friction a)) x /\ real t < x Eta) /\
      0 < real t /\ ~ stands a (real t)
  | Slides a =>
      (exists x, x Alpha = real (half_opening a) /\
         List.Forall (printed (flag (self_weight a)) x) [ShoulderSliding; InnerSliding; Steepest] /\
         values_hold c (Some (x Mu)) x) /\
      forall eta, ~ stands a eta
  | TooWide a =>
      (exists x, x BetaR = 0 /\ x Eta = 2 /\
         match coefficient (its_friction a) with
         | Some mu => x Mu = mu /\
             List.Forall (printed (flag (self_weight a)) x) [UpperThrust BetaR; InnerSliding; Steepest]
         | None => x Thrust = 0 /\ printed (flag (self_weight a)) x WholeThrust
         end /\
         values_hold c (coefficient (its_friction a)) x /\ x Alpha < real (half_opening a)) /\
      forall eta, 0 < eta <= 2 -> ~ stands a eta
  | Stands a t h p _ =>
      0 < real t <= 2 /\ stands a (real t) /\
      exists x, x Alpha = real (half_opening a) /\ x Eta = real t /\ x Thrust = value h /\
        values_hold c (coefficient (its_friction a)) x /\
        is_admissible (flag (self_weight a)) (coefficient (its_friction a)) x (value p)
  | Landmark l w =>
      exists x, List.Forall (printed (flag w) x) (equations_of l) /\ is_fixed l x /\
        values_hold c (friction_there l x) x /\
        is_least (flag w) (friction_there l x) x (moment_there l (flag w) x)
  | Asymmetric k a =>
      exists x, x Alpha = real (half_opening a) /\ coefficient (its_friction a) = Some (x Mu) /\
        is_asymmetric k (flag (self_weight a)) x /\ is_power k x /\ values_hold c (Some (x Mu)) x
  end.
