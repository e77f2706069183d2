(** * The checker

    From a certificate to yes or no; [Sound] has the theorem.  Nothing of a certificate is believed. *)

From Coq Require Import Reals ZArith Bool List.
From Interval Require Import Interval.Interval.
From Couplet Require Import Enclosures Formulas Krawczyk Equations Certificate Root WholeArch.
Import ListNotations.

(** ** What is given *)

Definition quotient (prec p : Z) (q : positive) : enclosure := I.div prec (integer prec p) (integer prec (Zpos q)).

Definition enclosed_number (prec : Z) (n : number) : enclosure :=
  match n with
  | Fraction p q => quotient prec p q
  | TimesPi p q => I.mul prec (quotient prec p q) (I.pi prec)
  | TwiceArctangent p q => I.mul prec (integer prec 2) (I.atan prec (quotient prec p q))
  end.

(** Nothing that is asked for where there is no limit. *)
Definition enclosed_friction (prec : Z) (f : friction) : enclosure :=
  match f with
  | Coefficient mu => enclosed_number prec mu
  | Angle phi => let x := enclosed_number prec phi in I.div prec (I.sin prec x) (I.cos prec x)
  | Unlimited => exact nought
  end.

(** An arch, as [is_arch] says. *)
Definition numerator (n : number) : Z := match n with Fraction p _ | TimesPi p _ | TwiceArctangent p _ => p end.
Definition is_below (prec : Z) (n : number) (limit : enclosure) : bool :=
  is_positive (I.sub prec limit (enclosed_number prec n)).
Definition is_given (prec : Z) (a : arch) : bool :=
  (0 <? numerator (half_opening a))%Z && is_below prec (half_opening a) (I.pi prec) &&
  match its_friction a with
  | Coefficient mu => (0 <=? numerator mu)%Z
  | Angle phi => (0 <=? numerator phi)%Z && is_below prec phi (I.div prec (I.pi prec) (integer prec 2))
  | Unlimited => true
  end.

(** Numbers that are enclosed, and zero for the others. *)
Definition given (l : Z -> list (name * enclosure)) (prec : Z) : surroundings :=
  let known := l prec in
  remembered (fun n =>
    functions_of prec n
      match find (fun nX => same n (fst nX)) known with Some nX => snd nX | None => exact nought end).

Definition its_opening (a : arch) (prec : Z) : list (name * enclosure) :=
  [(Alpha, enclosed_number prec (half_opening a))].
Definition its_numbers (a : arch) (prec : Z) : list (name * enclosure) :=
  (Mu, enclosed_friction prec (its_friction a)) :: its_opening a prec.
Definition two : dyadic := Dyadic 2 0.

(** ** Decimals *)

Definition enclosed_quantity (prec : Z) (limited : bool) (E : surroundings) (q : quantity) : enclosure :=
  let degrees X := I.div prec (I.mul prec (integer prec 180) X) (I.pi prec) in
  let angle := if limited then I.atan prec (itself (E Mu))
               else I.div prec (I.pi prec) (integer prec 2) in
  match q with
  | Plain n => itself (E n)
  | Degrees n => degrees (itself (E n))
  | IntrinsicThrust => I.mul prec (itself (E Eta)) (itself (E Thrust))
  | OpeningVariable =>
      let F := E Alpha in
      I.div prec (I.mul prec (itself F) (sine F)) (I.sub prec (integer prec 1) (cosine F))
  | FrictionAngle => angle
  | FrictionAngleDegrees => degrees angle
  end.

(** [m / 20 * 10 ^ e] *)
Definition twentieths (prec m e : Z) : enclosure :=
  if (0 <=? e)%Z then I.div prec (integer prec (m * 10 ^ e)) (integer prec 20)
  else I.div prec (integer prec m) (integer prec (20 * 10 ^ (- e))).

(** Largest size of a power of ten. *)
Definition most : Z := 20000.

Definition holds_value (prec digits : Z) (limited : bool) (E : surroundings)
    (qv : quantity * written) : bool :=
  let '(q, v) := qv in
  match v with
  | Infinite => match q with Plain Mu => negb limited | _ => false end
  | Decimal m e =>
      match q with Plain Mu => limited | _ => true end &&
      let X := enclosed_quantity prec limited E q in
      let below := (if (m =? 10 ^ (digits - 1))%Z then 1 else 10)%Z in
      if (m =? 0)%Z then is_zero X
      else
        (0 <? digits)%Z && (Z.abs e <=? most)%Z && (10 ^ (digits - 1) <=? m)%Z && (m <? 10 ^ digits)%Z
        && is_positive (I.sub prec X (twentieths prec (20 * m - below) e))
        && is_positive (I.sub prec (twentieths prec (20 * m + 10) e) X)
  end.

Definition hold_values (prec : Z) (limited : bool) (E : surroundings) (c : certificate) : bool :=
  forallb (fun qv => is_result (about c) (fst qv) && holds_value prec (digits c) limited E qv) (values c).

(** ** Signs *)

Definition are_all_positive (prec : Z) (E : surroundings) (l : list formula) : bool :=
  forallb (fun f => is_positive (enclosed prec E f)) l.

(** Below a half turn. *)
Definition is_open (prec : Z) (X : enclosure) : bool := is_positive (I.sub prec (I.pi prec) X).

(** The steepest joint, computed from the thrust. *)
Definition with_steepest (prec : Z) (E : surroundings) : surroundings :=
  let h := itself (E Thrust) in
  let b := functions_of prec BetaS (I.sqrt prec (I.mul prec h (I.sub prec (integer prec 1) h))) in
  fun n => match n with BetaS => b | _ => E n end.

(** One joint for both. *)
Definition with_one_joint (E : surroundings) : surroundings := fun n => match n with BetaR => E BetaS | _ => E n end.

Local Open Scope formula_scope.
(** What the limit leaves; what the extrados leaves at the shoulder; the room next to the crown; and what
    friction leaves. *)
Definition limit (w : weight) : formula :=
  2 * normal Alpha - (1 - Cos Alpha) * match w with Heyman => 1 | Milankovitch => Ratio 4 3 end.
Definition extrados_at_shoulder (w : weight) : formula :=
  outer * normal Alpha - 2 * centroid w * (1 - Cos Alpha) - outer * Val Thrust.
Definition next_to_crown (w : weight) : formula := centroid w - inner * (2 - Val Thrust) * Ratio 1 2.
Definition grip_at_shoulder : formula := normal Alpha * Val Mu - shoulder_slides.
Definition grip_inside : formula := inner_carries * Val Mu - inner_slides.

Definition haunch : list formula := [Val BetaR; Val Alpha - Val BetaR].
Definition some_thrust : list formula := [Val Thrust; 1 - Val Thrust].
Definition steepest : list formula := [Val BetaS; Val Alpha - Val BetaS; inner_carries].
Definition thick (w : weight) : list formula := [Val Eta; inner; limit w].
Definition carried : list formula := [Val Alpha; normal Alpha].

(** ** States *)

(** A mode that slides needs a limit, and one without thrust none. *)
Definition fits (m : mode) (f : friction) : bool :=
  match m with Rotational => true | Overturning => negb (is_limited f) | _ => is_limited f end.

Definition signs (w : weight) (m : mode) (limited : bool) : list formula :=
  carried ++ thick w ++
  match m with
  | Rotational =>
      some_thrust ++ haunch ++ (if limited then steepest ++ [grip_at_shoulder; grip_inside] else [])
  | SlidingRotational =>
      some_thrust ++ haunch ++ steepest ++
      [extrados_at_shoulder w; Sin Alpha - Val Mu * Cos Alpha; grip_inside]
  | RotationalSliding | RotationalSlidingRotational =>
      some_thrust ++ haunch ++ steepest ++
      [- extrados_at_shoulder w; grip_at_shoulder; upper_lever BetaR;
       match m with RotationalSliding => Val BetaR - Val BetaS | _ => Val BetaS - Val BetaR end]
  | OverturningSliding =>
      some_thrust ++ steepest ++ [next_to_crown w; grip_at_shoulder; upper_lever BetaR]
  | Overturning => [next_to_crown w; upper_lever BetaR]
  end.
Local Close Scope formula_scope.

Definition system_of (w : weight) (u : list name) (e : list equation) : system :=
  System u (map (cleared w) e) (flat_map denominator e).

Definition full_bits (c : certificate) : Z := (longest (centre (root c)) + 64)%Z.

(** What surrounds the state. *)
Definition state_found (c : certificate) (m : mode) (a : arch) : option surroundings :=
  let full := full_bits c in
  let w := self_weight a in
  let limited := is_limited (its_friction a) in
  match located c full (given (its_numbers a)) (system_of w (unknowns_of m) (equations m)) with
  | None => None
  | Some E =>
      let steep := if limited && negb (slides_inside m) then with_steepest full E else E in
      if fits m (its_friction a) && is_given full a
         && are_all_positive full steep (signs w m limited)
         && hold_values full limited E c
      then Some E else None
  end.

Definition check_state (c : certificate) (m : mode) (a : arch) : bool :=
  match state_found c m a with Some _ => true | None => false end.

(** ** The other verdicts *)

(** A fraction above zero and at most two. *)
Definition is_thickness (t : number) : bool :=
  match t with Fraction p q => (0 <? p)%Z && (p <=? 2 * Zpos q)%Z | _ => false end.

Definition check_too_thin (c : certificate) (m : mode) (a : arch) (t : number) : bool :=
  let full := full_bits c in
  match state_found c m a with
  | Some E => is_thickness t && is_positive (I.sub full (itself (E Eta)) (enclosed_number full t))
  | None => false
  end.

Definition check_slides (c : certificate) (a : arch) : bool :=
  let full := full_bits c in
  let w := self_weight a in
  let mu := enclosed_friction full (its_friction a) in
  match located c full (given (its_opening a))
          (system_of w [Mu; Thrust; BetaS] [ShoulderSliding; InnerSliding; Steepest]) with
  | None => false
  | Some E =>
      is_limited (its_friction a) && is_positive (I.sub full (itself (E Mu)) mu)
      && is_given full a && are_all_positive full E (carried ++ steepest)
      && hold_values full true E c
  end.

Definition check_too_wide (c : certificate) (a : arch) : bool :=
  let full := full_bits c in
  let w := self_weight a in
  let limited := is_limited (its_friction a) in
  let alpha := enclosed_number full (half_opening a) in
  let numbers prec := [(Eta, exact two); (Mu, enclosed_friction prec (its_friction a))] in
  let u := unknowns_too_wide (its_friction a) in
  let e := if limited then [UpperThrust BetaR; InnerSliding; Steepest] else [WholeThrust] in
  match located c full (given numbers) (system_of w u e) with
  | None => false
  | Some E =>
      is_given full a && is_positive (I.sub full alpha (itself (E Alpha)))
      && are_all_positive full E (Val Alpha :: (if limited then steepest ++ [upper_lever BetaR] else []))
      && hold_values full limited E c
  end.

Local Open Scope formula_scope.
(** Twice the moment about the intrados, at a joint. *)
Definition room (w : weight) (joint : name) : formula :=
  2 * Val Moment + 2 * centroid w * (1 - Cos joint) - inner * normal joint.
Definition room_at_crown : formula := 2 * Val Moment - inner * Val Thrust.
Definition still_nearer (w : weight) : formula :=
  inner * ((1 - Val Thrust) * Sin Alpha + Val Alpha * Cos Alpha) - 2 * centroid w * Sin Alpha.
Definition standing_signs (w : weight) (there : nearest) : list formula :=
  carried ++ some_thrust ++
  [outer * Val Thrust - 2 * Val Moment;
   outer * normal Alpha - 2 * Val Moment - 2 * centroid w * (1 - Cos Alpha)] ++
  match there with
  | AtCrown => [room_at_crown; next_to_crown w]
  | AtHaunch => haunch ++ [room w BetaR]
  | AtShoulder => [room w Alpha; still_nearer w]
  end.
(** Friction at the shoulder is enough for a short arch, whose steepest joint is beyond it. *)
Definition enough (prec : Z) (E : surroundings) : bool :=
  let steep := with_steepest prec E in
  are_all_positive prec E [grip_at_shoulder] &&
  if are_all_positive prec steep [Val BetaS - Val Alpha]
  then are_all_positive prec E [normal Alpha * Val Mu + shoulder_slides]
  else are_all_positive prec steep [inner_carries; grip_inside].
Local Close Scope formula_scope.

Definition check_stands (c : certificate) (a : arch) (t : number) (h p : dyadic) (there : nearest) : bool :=
  let full := (Z.max (longest (centre (root c))) (longest [h; p]) + 64)%Z in
  let w := self_weight a in
  let limited := is_limited (its_friction a) in
  let numbers prec :=
    (Eta, enclosed_number prec t) :: (Thrust, exact h) :: (Moment, exact p) :: its_numbers a prec in
  let u := unknowns_standing there in
  let e := match there with AtHaunch => [Tangency BetaR] | _ => [] end in
  match located c full (given numbers) (system_of w u e) with
  | None => false
  | Some E =>
      is_thickness t && is_given full a && are_all_positive full E (standing_signs w there)
      && (if limited then enough full E else true)
      && hold_values full limited E c
  end.

(** ** Landmarks *)

Definition landmark_limited (l : landmark) : bool :=
  match l with Triple | Shift | Junction | Border => true | _ => false end.
Definition landmark_given (l : landmark) (prec : Z) : list (name * enclosure) :=
  match l with Border | OverturningEnd => [(Eta, exact two)] | _ => [] end.

Local Open Scope formula_scope.
Definition landmark_signs (w : weight) (l : landmark) : list formula :=
  carried ++
  match l with
  | Triple => thick w ++ some_thrust ++ haunch ++ steepest ++
      [upper_lever BetaR; Val BetaR - Val BetaS; Sin Alpha - Val Mu * Cos Alpha]
  | Shift => thick w ++ some_thrust ++ steepest ++ [- extrados_at_shoulder w; upper_lever BetaS]
  | Junction => thick w ++ some_thrust ++ steepest ++ [- extrados_at_shoulder w; upper_lever BetaR]
  | Border => some_thrust ++ steepest ++ [next_to_crown w; upper_lever BetaR]
  | RotationEnd => thick w ++ [upper_lever BetaR]
  | OverturningEnd => [next_to_crown w; upper_lever BetaR]
  | WidestJoint => thick w ++ some_thrust ++ haunch
  end.
Local Close Scope formula_scope.

Definition check_landmark (c : certificate) (l : landmark) (w : weight) : bool :=
  let full := full_bits c in
  match located c full (given (landmark_given l)) (system_of w (landmark_unknowns l) (equations_of l)) with
  | None => false
  | Some E =>
      let E := match l with Shift => with_one_joint E | _ => E end in
      is_open full (itself (E Alpha)) && are_all_positive full E (landmark_signs w l)
      && hold_values full (landmark_limited l) E c
  end.

(** ** Asymmetric solutions *)

Local Open Scope formula_scope.
Definition asymmetric_zeros (w : weight) (k : kind) : list formula :=
  [margin_at w FromExtrados (right Hinge); margin_slope_at w FromExtrados (right Hinge);
   margin_at w FromIntrados (left BetaR); margin_slope_at w FromIntrados (left BetaR);
   margin_at w AgainstOutwards (right Alpha)] ++
  match k with
  | SlidesInside => [margin_at w AgainstOutwards (left BetaS); margin_slope_at w AgainstOutwards (left BetaS)]
  | OpensAtShoulder => [margin_at w FromExtrados (right Alpha)]
  | SlidesAlone =>
      [inner * (Cos BetaR * Cos Alpha - Sin BetaR * Sin Alpha)
       - outer * (Cos Hinge * Cos Alpha + Sin Hinge * Sin Alpha)]
  end.

(** Numerators and denominator of the rates. *)
Definition gap_across : formula := half_outer * Cos Hinge - half_inner * Cos BetaR.
Definition gap_upwards : formula := - (half_outer * Sin Hinge) - half_inner * Sin BetaR.
Definition gap_along : formula := Sin Alpha * gap_upwards - Cos Alpha * gap_across.
Definition arm_upwards : formula := half_outer * Sin Alpha + half_inner * Sin BetaR.
Definition arm_across : formula := half_outer * Cos Alpha - half_inner * Cos BetaR.
Definition rate_divisor (k : kind) : formula :=
  match k with
  | SlidesInside => Sin Alpha * Cos BetaS + Cos Alpha * Sin BetaS
  | OpensAtShoulder => Sin Alpha * arm_upwards + Cos Alpha * arm_across
  | SlidesAlone => Sin Alpha
  end.
Definition slip_numerator (k : kind) : formula :=
  match k with
  | SlidesInside => gap_across * Cos BetaS + gap_upwards * Sin BetaS
  | OpensAtShoulder => gap_across * arm_upwards + gap_upwards * arm_across
  | SlidesAlone => gap_across
  end.
Definition asymmetric_signs (k : kind) : list formula :=
  [Val Alpha; Val Eta; inner; Val Force; Val Alpha - Val Hinge; Val Alpha - Val BetaR;
   rate_divisor k; slip_numerator k] ++
  match k with
  | SlidesInside => [Val Hinge + Val BetaS; Val BetaR - Val BetaS; gap_along]
  | OpensAtShoulder => [Val Hinge + Val BetaR; gap_along]
  | SlidesAlone => [Val Hinge + Val BetaR]
  end.
Local Close Scope formula_scope.

(** The rates, computed, and the power that friction takes. *)
Definition with_slips (prec : Z) (k : kind) (E : surroundings) : surroundings :=
  let rate f := I.div prec (enclosed prec E f) (enclosed prec E (rate_divisor k)) in
  let s := plain (rate (slip_numerator k)) in
  let other := plain (rate gap_along) in
  fun n => match n with Slip => s | InnerSlip | Opening => other | _ => E n end.
Definition power_of (k : kind) : formula :=
  let taken j rate := (Val Mu * normal_at j * Val rate)%formula in
  match k with
  | SlidesInside => (taken (right Alpha) Slip + taken (left BetaS) InnerSlip)%formula
  | _ => taken (right Alpha) Slip
  end.
Definition with_rates (prec : Z) (k : kind) (E : surroundings) : surroundings :=
  let F := with_slips prec k E in
  let P := plain (enclosed prec F (power_of k)) in
  fun n => match n with Power => P | _ => F n end.

(** Bits for the pieces of the arch. *)
Definition piece_bits : Z := 64.

(** Sets next to the joints that are at their limits. *)
Definition near_joint (w : weight) (E : surroundings) (m : margin) (X : enclosure) : list enclosure :=
  match neighbourhood piece_bits 22 2 (bends_away piece_bits w E m) X with Some near => [near] | None => [] end.
Definition near_end (w : weight) (E : surroundings) (m : margin) : list enclosure :=
  match neighbourhood piece_bits 22 2 (falls piece_bits w E m) (itself (E Alpha)) with Some near => [near] | None => [] end.

Definition known_margins (w : weight) (k : kind) (E : surroundings) : list known_margin :=
  [(FromExtrados, near_joint w E FromExtrados (itself (E Hinge))
      ++ match k with OpensAtShoulder => near_end w E FromExtrados | _ => [] end);
   (FromIntrados, near_joint w E FromIntrados (I.neg (itself (E BetaR))));
   (AgainstInwards, []);
   (AgainstOutwards, near_end w E AgainstOutwards
      ++ match k with SlidesInside => near_joint w E AgainstOutwards (I.neg (itself (E BetaS))) | _ => [] end)].

Definition check_asymmetric (c : certificate) (k : kind) (a : arch) : bool :=
  let full := full_bits c in
  let w := self_weight a in
  match located c full (given (its_numbers a)) (System (asymmetric_unknowns k) (asymmetric_zeros w k) []) with
  | None => false
  | Some E =>
      is_limited (its_friction a) && is_given full a && are_all_positive full E (asymmetric_signs k)
      && whole_covered piece_bits w E (known_margins w k E)
      && hold_values full true (with_rates full k E) c
  end.

(** ** The certificate *)

Definition check (c : certificate) : bool :=
  match about c with
  | State m a => check_state c m a
  | TooThin m a t => check_too_thin c m a t
  | Slides a => check_slides c a
  | TooWide a => check_too_wide c a
  | Stands a t h p there => check_stands c a t h p there
  | Landmark l w => check_landmark c l w
  | Asymmetric k a => check_asymmetric c k a
  end.
