(** * The checker of surveys

    Which arches decide follows from the survey and the steps alone; each has a certificate, which [check] checks. *)

From Coq Require Import Reals ZArith QArith Bool List.
From Interval Require Import Interval.Interval.
From Couplet Require Import Enclosures Equations Certificate SurveyClaim Check.
Import ListNotations.
Open Scope bool_scope.

(** ** Order *)

(** The factor of a number, and its form; a right angle has two. *)
Definition factor (n : number) : Q := match n with Fraction p q | TimesPi p q | TwiceArctangent p q => (p # q) end.
Definition one_form (n : number) : number :=
  match n with TwiceArctangent p q => if (p =? Zpos q)%Z then TimesPi 1 2 else n | _ => n end.
Definition is_same_form (a b : number) : bool :=
  match a, b with
  | Fraction _ _, Fraction _ _ | TimesPi _ _, TimesPi _ _ | TwiceArctangent _ _, TwiceArctangent _ _ => true
  | _, _ => false
  end.
Definition is_same_number (a b : number) : bool :=
  is_same_form (one_form a) (one_form b) && Qeq_bool (factor (one_form a)) (factor (one_form b)).
Definition is_same_friction (f g : friction) : bool :=
  match f, g with
  | Coefficient a, Coefficient b | Angle a, Angle b => is_same_number a b
  | Unlimited, Unlimited => true
  | _, _ => false
  end.

Definition are_in_order (prec : Z) (ends : number * number) : bool :=
  let '(a, b) := ends in
  if is_same_form a b then Qle_bool (factor a) (factor b)
  else is_positive (I.sub prec (enclosed_number prec b) (enclosed_number prec a)).
Definition are_frictions_in_order (prec : Z) (ends : friction * friction) : bool :=
  match ends with
  | (_, Unlimited) => true
  | (Coefficient a, Coefficient b) | (Angle a, Angle b) => are_in_order prec (a, b)
  | (Unlimited, _) => false
  | (f, g) => is_positive (I.sub prec (enclosed_friction prec g) (enclosed_friction prec f))
  end.

(** ** The survey *)

Definition circle_of (at_place : place) : Q :=
  let '(span, rise) := at_place in ((span * span / 4 + rise * rise) / (2 * rise))%Q.
Definition opening_of (at_place : place) : number :=
  let '(span, rise) := at_place in let q := (2 * rise / span)%Q in TwiceArctangent (Qnum q) (Qden q).
Definition outwards (c : circle) (t r : Q) : Q := (r + inject_Z (to_centreline c) * t / 2)%Q.
Definition ratio_of (c : circle) (t r : Q) : number := let q := (t / outwards c t r)%Q in Fraction (Qnum q) (Qden q).

(** Where arches stand least easily, and where most easily. *)
Inductive side := Unsafe | Safe.
Definition end_of {A} (d : side) (ends : A * A) : A := match d with Unsafe => fst ends | Safe => snd ends end.

(** The largest circle of a step, and the least. *)
Definition its_circle (d : side) (step : place * place) : Q :=
  let '(first, last) := step in
  let '(a, b) := (circle_of first, circle_of last) in
  let half := (fst first / 2)%Q in
  match d with
  | Unsafe => if Qle_bool a b then b else a
  | Safe =>
      if Qeq_bool (fst first) (fst last) && negb (Qle_bool half (snd first)) && negb (Qle_bool (snd last) half) then half
      else if Qle_bool a b then a else b
  end.

Definition is_range (l : Q * Q) : bool := (0 <? Qnum (fst l))%Z && Qle_bool (fst l) (snd l).
(** The arches that stand least and most easily have a friction and a half-angle, and all have room. *)
Definition is_survey_at (s : survey) (prec : Z) : bool :=
  let '(least, most) := frictions s in
  are_frictions_in_order prec (least, most) &&
  match its_shape s with
  | Free (narrow, wide) (thin, thick) =>
      is_given prec (Arch Heyman wide least) && is_given prec (Arch Heyman narrow most) &&
      are_in_order prec (narrow, wide) && are_in_order prec (thin, thick) && is_thickness thin && is_thickness thick
  | Spanned c spans rises ts =>
      is_given prec (Arch Heyman (Fraction 1 1) least) && is_given prec (Arch Heyman (Fraction 1 1) most) &&
      is_range spans && is_range rises && is_range ts &&
      let r := its_circle Safe ((fst spans, fst rises), (fst spans, snd rises)) in
      Qle_bool (snd ts) (2 * outwards c (snd ts) r)
  end.
(** Ends of two forms are told apart in as many bits as it takes, and no more: the kernel would compute both sides of an
    [orb]. *)
Definition is_survey (s : survey) : bool :=
  if is_survey_at s 128 then true else if is_survey_at s 1024 then true else is_survey_at s 4096.

(** ** The arches that decide *)

(** A step goes from the largest span and the least rise, on one of two legs: along the largest of both where arches
    stand least easily, along the least of both where most easily. *)
Definition is_step (d : side) (spans rises : Q * Q) (step : place * place) : bool :=
  let '((span, rise), (span', rise')) := step in
  let in_turn a b c e := Qle_bool a b && Qle_bool b c && Qle_bool c e in
  let rises_at at_span := Qeq_bool span at_span && Qeq_bool span' at_span && in_turn (fst rises) rise rise' (snd rises) in
  let narrows_at at_rise := Qeq_bool rise at_rise && Qeq_bool rise' at_rise && in_turn (fst spans) span' span (snd spans) in
  match d with
  | Unsafe => rises_at (snd spans) || narrows_at (snd rises)
  | Safe => narrows_at (fst rises) || rises_at (fst spans)
  end.

(** The arch that decides a part, and its thickness. *)
Definition deciding (s : survey) (d : side) (step : option (place * place)) : option (arch * number) :=
  let of alpha := Arch (survey_weight s) alpha (end_of d (frictions s)) in
  match its_shape s, step with
  | Free (narrow, wide) ts, None => Some (of (match d with Unsafe => wide | Safe => narrow end), end_of d ts)
  | Spanned c spans rises ts, Some step =>
      if is_step d spans rises step then
        Some (of (opening_of (match d with Unsafe => snd step | Safe => fst step end)),
              ratio_of c (end_of d ts) (its_circle d step))
      else None
  | _, _ => None
  end.

(** A certificate of it, that it stands or that it does not. *)
Definition is_decided (c : certificate) (a : arch) (t : number) (stands : bool) : bool :=
  let is_it b :=
    (match self_weight a, self_weight b with
     | Heyman, Heyman | Milankovitch, Milankovitch => true | _, _ => false end)
    && is_same_number (half_opening a) (half_opening b) && is_same_friction (its_friction a) (its_friction b) in
  match about c with
  | Stands b u _ _ _ => stands && is_it b && is_same_number t u
  | TooThin _ b u => negb stands && is_it b && is_same_number t u
  | Slides b | TooWide b => negb stands && is_it b
  | _ => false
  end && check c.

Definition decides (s : survey) (d : side) (stands : bool) (p : part) : bool :=
  match deciding s d (its_step p) with
  | Some (a, t) => is_thickness t && is_decided (its_certificate p) a t stands
  | None => false
  end.

(** Steps without a gap, from one place to another. *)
Definition is_same_place (a b : place) : bool := Qeq_bool (fst a) (fst b) && Qeq_bool (snd a) (snd b).
Fixpoint reaches (from until : place) (l : list part) : bool :=
  match l with
  | Part (Some (first, last)) _ :: l =>
      is_same_place from first && match l with [] => is_same_place last until | _ => reaches last until l end
  | _ => false
  end.
Definition are_all (s : survey) (l : list part) : bool :=
  match its_shape s with
  | Free _ _ => (length l =? 1)%nat
  | Spanned _ spans rises _ => reaches (snd spans, fst rises) (fst spans, snd rises) l
  end.
Definition is_single (p : part) : bool :=
  match its_step p with Some (first, last) => is_same_place first last | None => true end.

Definition check_survey (c : survey_certificate) : bool :=
  let s := of_survey c in
  is_survey s &&
  match its_verdict c, parts c with
  | AllStand, l => are_all s l && forallb (decides s Unsafe true) l
  | NoneStands, l => are_all s l && forallb (decides s Safe false) l
  | BothOccur, [p; q] => is_single p && is_single q && decides s Unsafe false p && decides s Safe true q
  | BothOccur, _ => false
  end.
