(** * The checker

    From a certificate to yes or no; [Sound] has the theorem.  Nothing of a certificate is believed. *)

From Coq Require Import Reals ZArith Bool List.
From Interval Require Import Interval.Interval.
From Couplet Require Import Enclosures Formulas Krawczyk Equations Certificate.
Import ListNotations.

(** ** What is given *)

Definition quotient (prec p : Z) (q : positive) : enclosure :=
  I.div prec (integer prec p) (integer prec (Zpos q)).

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

(** Computed once for all names. *)
Definition remembered (E : surroundings) : surroundings :=
  let alpha := E Alpha in let beta_r := E BetaR in let beta_s := E BetaS in
  let eta := E Eta in let h := E Thrust in let mu := E Mu in
  let p := E Moment in let v := E Force in let b0 := E Hinge in
  fun n => match n with
    | Alpha => alpha | BetaR => beta_r | BetaS => beta_s | Eta => eta | Thrust => h | Mu => mu
    | Moment => p | Force => v | Hinge => b0
    end.

Definition surroundings_of (prec : Z) (X : name -> enclosure) : surroundings :=
  remembered (fun n => functions_of prec n (X n)).

(** ** Boxes *)

Definition bits (d : dyadic) : Z := Z.log2 (Z.abs (mantissa d)) + 1.
Definition longest (l : list dyadic) : Z := fold_right (fun d n => Z.max (bits d) n) 0%Z l.

Definition are_positive (l : list dyadic) : bool := forallb (fun r => (0 <? mantissa r)%Z) l.

(** All of a box, and its centre: each unknown with its functions. *)
Definition boxes (prec : Z) (unknowns : list name) (b : box) : list functions :=
  map (fun nb => functions_of prec (fst nb) (around prec (fst (snd nb)) (snd (snd nb))))
    (combine unknowns (combine (centre b) (radius b))).
Definition points (prec : Z) (unknowns : list name) (c : list dyadic) : list functions :=
  map (fun nc => functions_of prec (fst nc) (exact (snd nc))) (combine unknowns c).

(** Sine and cosine of a box from those of its centre: they differ by its radius at most. *)
Definition spread (prec : Z) (F : functions) (r : dyadic) : functions :=
  let e := symmetric r in
  let s := I.add prec (sine F) e in
  let c := I.add prec (cosine F) e in
  Functions (I.add prec (itself F) e) s c anything.

(** One box lies inside the other. *)
Definition is_inside (prec : Z) (n : nat) (b B : box) : bool :=
  forallb (fun i =>
    let r := exact (nth i (radius b) nought) in let R := exact (nth i (radius B) nought) in
    let d := I.sub prec (exact (nth i (centre b) nought)) (exact (nth i (centre B) nought)) in
    is_positive (I.sub prec R (I.add prec r (I.abs d)))) (seq 0 n).

(** ** The root *)

Record system := System { unknowns : list name; zeros : list formula; divisors : list formula }.

(** What surrounds the root, if there is one in the small box. *)
Definition located (c : certificate) (given : Z -> surroundings) (s : system) : option surroundings :=
  let u := unknowns s in
  let n := length u in
  let wide := (longest (centre (unique c)) + 64)%Z in
  let full := (longest (centre (root c)) + 64)%Z in
  let has_size (b : box) := Nat.eqb (length (centre b)) n && Nat.eqb (length (radius b)) n in
  if negb (distinct u && Nat.eqb (length (zeros s)) n
           && has_size (unique c) && has_size (root c)
           && is_square n (inverse c) && is_regular n (map integers (inverse c))
           && are_positive (radius (unique c)) && are_positive (radius (root c))) then None
  else
    let G := given wide in
    let X := remembered (sited G u (boxes wide u (unique c))) in
    let m := remembered (sited G u (points wide u (centre (unique c)))) in
    if negb (forallb (is_defined X) (zeros s)
             && forallb (fun f => is_not_zero (enclosed wide X f)) (divisors s)) then None
    else
      match bounds wide u (zeros s) (inverse c) X with
      | None => None
      | Some C =>
          if negb (narrows wide u (inverse c) C (map (enclosed wide m) (zeros s)) (radius (unique c))
                   && is_inside full n (root c) (unique c)) then None
          else
            let G := given full in
            let at_m := points full u (centre (root c)) in
            let m := remembered (sited G u at_m) in
            if narrows wide u (inverse c) C (map (enclosed full m) (zeros s)) (radius (root c))
            then
              Some (remembered
                (sited G u (map (fun Fr => spread full (fst Fr) (snd Fr)) (combine at_m (radius (root c))))))
            else None
      end.

(** ** Decimals *)

Definition enclosed_quantity (prec : Z) (E : surroundings) (q : quantity) : enclosure :=
  match q with
  | Plain n => itself (E n)
  | Degrees n => I.div prec (I.mul prec (integer prec 180) (itself (E n))) (I.pi prec)
  | IntrinsicThrust => I.mul prec (itself (E Eta)) (itself (E Thrust))
  end.

(** [m / 20 * 10 ^ e] *)
Definition twentieths (prec m e : Z) : enclosure :=
  if (0 <=? e)%Z then I.div prec (integer prec (m * 10 ^ e)) (integer prec 20)
  else I.div prec (integer prec m) (integer prec (20 * 10 ^ (- e))).

(** Largest size of a power of ten. *)
Definition most : Z := 20000.

Definition holds_value (prec digits : Z) (E : surroundings) (qv : quantity * decimal) : bool :=
  let '(q, v) := qv in
  let m := digits_of v in
  let e := power v in
  let X := enclosed_quantity prec E q in
  let below := (if (m =? 10 ^ (digits - 1))%Z then 1 else 10)%Z in
  if (m =? 0)%Z then is_zero X
  else
    (0 <? digits)%Z && (Z.abs e <=? most)%Z && (10 ^ (digits - 1) <=? m)%Z && (m <? 10 ^ digits)%Z
    && is_positive (I.sub prec X (twentieths prec (20 * m - below) e))
    && is_positive (I.sub prec (twentieths prec (20 * m + 10) e) X).

(** ** States *)

Definition unknowns_of (m : mode) : list name :=
  match m with
  | Rotational | SlidingRotational => [BetaR; Eta; Thrust]
  | RotationalSliding | RotationalSlidingRotational => [BetaR; Eta; Thrust; BetaS]
  | OverturningSliding => [Eta; Thrust; BetaS]
  | Overturning => [Eta]
  end.

Definition system_of (w : weight) (u : list name) (e : list equation) : system :=
  System u (map (cleared w) e) (flat_map denominator e).

Definition given_enclosures (a : arch) (prec : Z) : surroundings :=
  surroundings_of prec (fun n =>
    match n with
    | Alpha => enclosed_number prec (half_opening a)
    | Mu => enclosed_friction prec (its_friction a)
    | _ => exact nought
    end).

Definition is_limited (f : friction) : bool := match f with Unlimited => false | _ => true end.

(** A mode that slides needs a limit, and one without thrust none. *)
Definition fits (m : mode) (f : friction) : bool :=
  match m with Rotational => true | Overturning => negb (is_limited f) | _ => is_limited f end.

(** Where no inner joint slides, the steepest is computed from the thrust. *)
Definition with_steepest (prec : Z) (E : surroundings) : surroundings :=
  let h := itself (E Thrust) in
  let b := functions_of prec BetaS (I.sqrt prec (I.mul prec h (I.sub prec (integer prec 1) h))) in
  fun n => match n with BetaS => b | _ => E n end.

Definition slides_inside (m : mode) : bool :=
  match m with RotationalSliding | RotationalSlidingRotational | OverturningSliding => true | _ => false end.

(** What is a result: the rest is given, or the mode has none. *)
Definition speaks_of (m : mode) (q : quantity) : bool :=
  match q with
  | IntrinsicThrust | Plain (Eta | Thrust | BetaR) | Degrees BetaR => true
  | Plain BetaS | Degrees BetaS => slides_inside m
  | _ => false
  end.

Local Open Scope formula_scope.
(** What the limit leaves; what the extrados leaves at the shoulder; the room next to the crown. *)
Definition limit (w : weight) : formula :=
  2 * normal Alpha - (1 - Cos Alpha) * match w with Heyman => 1 | Milankovitch => Ratio 4 3 end.
Definition extrados_at_shoulder (w : weight) : formula :=
  outer * normal Alpha - 2 * centroid w * (1 - Cos Alpha) - outer * Val Thrust.
Definition next_to_crown (w : weight) : formula :=
  centroid w - inner * (2 - Val Thrust) * Ratio 1 2.
Definition grip_at_shoulder : formula := normal Alpha * Val Mu - shoulder_slides.
Definition grip_inside : formula := inner_carries * Val Mu - inner_slides.

(** What has to be positive. *)
Definition haunch : list formula := [Val BetaR; Val Alpha - Val BetaR].
Definition some_thrust : list formula := [Val Thrust; 1 - Val Thrust].
Definition steepest : list formula := [Val BetaS; Val Alpha - Val BetaS; inner_carries].
Definition signs (w : weight) (m : mode) (limited : bool) : list formula :=
  [Val Alpha; normal Alpha; Val Eta; inner; limit w] ++
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

Definition are_all_positive (prec : Z) (E : surroundings) (l : list formula) : bool :=
  forallb (fun f => is_positive (enclosed prec E f)) l.

(** Below a half turn. *)
Definition is_open (prec : Z) (E : surroundings) : bool :=
  is_positive (I.sub prec (I.pi prec) (itself (E Alpha))).

Definition check_state (c : certificate) (m : mode) (a : arch) : bool :=
  let w := self_weight a in
  let full := (longest (centre (root c)) + 64)%Z in
  fits m (its_friction a) &&
  match located c (given_enclosures a) (system_of w (unknowns_of m) (equations m)) with
  | None => false
  | Some E =>
      let limited := is_limited (its_friction a) in
      let S := if limited && negb (slides_inside m) then with_steepest full E else E in
      is_open full E && are_all_positive full S (signs w m limited)
      && forallb (fun qv => speaks_of m (fst qv)) (values c)
      && forallb (holds_value full (digits c) E) (values c)
  end.

Definition check (c : certificate) : bool :=
  match about c with
  | State m a => check_state c m a
  end.
