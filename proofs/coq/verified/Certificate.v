(** * A certificate, and what it claims

    Of a certificate only the subject and the values are a claim; boxes and matrix say where to look.
    [claim_of] is all that the checker's theorem is about.  Its words are those of [Arch], [Contact],
    [FrictionModes] and [States]. *)

From Coq Require Import Reals ZArith List.
From Couplet Require Import Arch States Enclosures Formulas Equations.
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

Inductive subject :=
  | State (m : mode) (a : arch).

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

(** The state is admissible at every joint, and the arch stands exactly from its thickness on. *)
Definition is_least (d : R) (mu : option R) (x : configuration) (p : R) : Prop :=
  match mu with
  | Some mu => admissible d (x Alpha) (x Eta) mu (x Thrust) p /\ stands_from d (x Alpha) mu (x Eta)
  | None => thrust_inside d (x Alpha) (x Eta) (x Thrust) p /\
            stands_without_limit_from d (x Alpha) (x Eta)
  end.

(** ** Decimals *)

Inductive quantity := Plain (n : name) | Degrees (n : name) | IntrinsicThrust.
Definition value_of (q : quantity) (x : configuration) : R :=
  match q with
  | Plain n => x n
  | Degrees n => 180 * x n / PI
  | IntrinsicThrust => x Eta * x Thrust
  end.

(** [m * 10 ^ e], which is the correct rounding of a number to so many digits; zero is exact. Below a power
    of ten the unit of the last digit is ten times as fine. *)
Record decimal := Decimal { digits_of : Z; power : Z }.
Definition is_rounding (digits : Z) (v : decimal) (x : R) : Prop :=
  let m := digits_of v in
  let unit := powerRZ 10 (power v) in
  m = 0%Z /\ x = 0 \/
  (10 ^ (digits - 1) <= m < 10 ^ digits)%Z /\
  IZR m * unit - (if (m =? 10 ^ (digits - 1))%Z then unit / 20 else unit / 2) < x < IZR m * unit + unit / 2.

(** ** The certificate *)

Record box := Box { centre : list dyadic; radius : list dyadic }.
Record certificate := Certificate {
  about : subject; digits : Z; unique : box; inverse : list (list dyadic); root : box;
  values : list (quantity * decimal) }.

Definition values_hold (c : certificate) (x : configuration) : Prop :=
  forall q v, In (q, v) (values c) -> is_rounding (digits c) v (value_of q x).

Definition claim_of (c : certificate) : Prop :=
  match about c with
  | State m a =>
      let d := flag (self_weight a) in
      exists x : configuration,
        x Alpha = real (half_opening a) /\ coefficient (its_friction a) = match its_friction a with
          Unlimited => None | _ => Some (x Mu) end /\
        List.Forall (printed d x) (equations m) /\ in_order m x /\ values_hold c x /\
        is_least d (coefficient (its_friction a)) x (crown_moment m d x)
  end.
