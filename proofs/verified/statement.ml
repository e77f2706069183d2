(* What an accepted certificate claims, in words, from nothing but the value of which Coq has proved it: so that a reader
   that mistakes a name or a number is seen. The words are those of `couplet check --statement`. *)

module Integer = Z
open Verified

let of_weight = function Heyman -> "heyman" | Milankovitch -> "milankovitch"

let of_mode = function
  | Rotational -> "[r,r,r]"
  | SlidingRotational -> "[s,r,r]"
  | RotationalSliding -> "[r,r,s]"
  | RotationalSlidingRotational -> "[r,s,r]"
  | OverturningSliding -> "[r,s]"
  | Overturning -> "[r]"

let of_landmark = function
  | Triple -> "T" | Shift -> "S" | Junction -> "J" | Border -> "B" | RotationEnd -> "l" | OverturningEnd -> "L"
  | WidestJoint -> "sb"

let of_kind = function
  | SlidesInside -> "inner_sliding" | OpensAtShoulder -> "shoulder_opening" | SlidesAlone -> "shoulder_sliding"

let of_name = function
  | Alpha -> "half_opening" | BetaR -> "rotation_joint" | BetaS -> "sliding_joint" | Eta -> "thickness"
  | Thrust -> "thrust" | Mu -> "friction" | Moment -> "crown_moment" | Force -> "vertical_force" | Hinge -> "crown_hinge"
  | Slip -> "shoulder_slip" | InnerSlip -> "inner_slip" | Opening -> "shoulder_opening" | Power -> "power"
  | Joint -> "joint"

let of_quantity = function
  | Plain n -> of_name n
  | Degrees n -> of_name n ^ "_degrees"
  | IntrinsicThrust -> "intrinsic_thrust"
  | OpeningVariable -> "A"
  | FrictionAngle -> "friction_angle"
  | FrictionAngleDegrees -> "friction_angle_degrees"

(* As it is given, in lowest terms or not. *)
let fraction p q = Integer.to_string p ^ "/" ^ Integer.to_string q

let number = function
  | Fraction (p, q) -> fraction p q
  | TimesPi (p, q) -> fraction p q ^ " pi"
  | TwiceArctangent (p, q) -> if Integer.equal p q then "1/2 pi" else "2 atan " ^ fraction p q

let friction = function Coefficient mu -> number mu | Angle phi -> "tan " ^ number phi | Unlimited -> "inf"

(* All the digits, with a point among them or a power of ten behind them. *)
let written = function
  | Infinite -> "inf"
  | Decimal (m, e) ->
      let all = Integer.to_string m in
      let n = String.length all in
      let point = n + Integer.to_int e in
      let split k = String.sub all 0 k ^ if k < n then "." ^ String.sub all k (n - k) else "" in
      if all = "0" then all
      else if 0 < point && point <= n then split point
      else if -6 < point && point <= 0 then "0." ^ String.make (-point) '0' ^ all
      else split 1 ^ "e" ^ string_of_int (point - 1)

let arch a = Printf.sprintf "half opening %s, friction %s" (number a.half_opening) (friction a.its_friction)
let thick a t = Printf.sprintf "%s, thickness %s" (arch a) (number t)
let exists = "(an admissible symmetric state exists)"
let stands = "stands " ^ exists

let statement c =
  let subject, weight, says =
    match c.about with
    | State (m, a) ->
        ( arch a, a.self_weight,
          Printf.sprintf
            "the arch %s exactly from a least thickness on, up to 2, and at the least one it has a state of %s, the only \
             solution of its equations in the large box"
            stands (of_mode m) )
    | TooThin (m, a, t) ->
        ( thick a t, a.self_weight,
          Printf.sprintf "the arch does not stand, as its least thickness, of %s, is larger" (of_mode m) )
    | Slides a ->
        (arch a, a.self_weight, "the arch stands at no thickness, as its friction is below that of pure sliding")
    | TooWide a ->
        ( arch a, a.self_weight,
          "the arch stands at no thickness up to 2, as its half opening is beyond a bound for its friction" )
    | Stands (a, t, _, _, _) -> (thick a t, a.self_weight, "the arch " ^ stands)
    | Landmark (l, w) ->
        let sliding, none =
          match l with
          | Triple | Shift | Junction | Border -> ([ "[s,s]" ], ", and none of its half opening with less friction")
          | _ -> ([], "")
        in
        let modes = String.concat ", " (List.map of_mode (modes_of l) @ sliding) in
        ( "landmark " ^ of_landmark l, w,
          Printf.sprintf
            "its equations have a solution, the only one in the large box, that is a state of %s, admissible at every joint, \
             and no thinner arch of its half opening and friction stands%s" modes none )
    | Asymmetric (k, a) ->
        ( arch a, a.self_weight,
          Printf.sprintf
            "the complementarity problem (19) of the whole arch has an asymmetric solution, %s, admissible at every joint"
            (of_kind k) )
  in
  let values = List.map (fun (q, v) -> of_quantity q ^ " = " ^ written v) c.values in
  let rounded =
    if values = [] then ""
    else
      let digits = Integer.to_string c.digits in
      Printf.sprintf "; there %s, each correctly rounded to %s significant digit%s" (String.concat ", " values) digits
        (if digits = "1" then "" else "s")
  in
  Printf.sprintf "%s, %s weight: %s%s" subject (of_weight weight) says rounded

(* A length in lowest terms. *)
let length l =
  let common = Integer.gcd l.qnum l.qden in
  fraction (Integer.div l.qnum common) (Integer.div l.qden common)

let of_survey c =
  let s = c.of_survey in
  let range write (a, b) = write a ^ " to " ^ write b in
  let shape =
    match s.its_shape with
    | Free (half_openings, thicknesses) ->
        Printf.sprintf "half opening %s, thickness %s" (range number half_openings) (range number thicknesses)
    | Spanned (circle, spans, rises, thicknesses) ->
        let circle = List.find (fun (_, c) -> c = circle) Reader.circles in
        Printf.sprintf "span %s m and rise %s m at the %s, thickness %s m" (range length spans) (range length rises)
          (fst circle) (range length thicknesses)
  in
  let says =
    match c.its_verdict with
    | AllStand -> "every arch stands"
    | NoneStands -> "no arch stands"
    | BothOccur -> "one arch stands and one does not"
  in
  Printf.sprintf "all arches with %s, friction %s, %s weight: %s %s" shape (range friction s.frictions)
    (of_weight s.survey_weight) says exists
