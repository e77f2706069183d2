(* From a file to a certificate of the checker: names to constructors, text to numbers. It decides nothing. *)

module Integer = Z
open Verified

exception Refused of string

(* What is beyond this checker is not refused. *)
exception Beyond of string

let most_digits = 1000
let most_bits = 4000
let most_exponent = 100_000

let refused reason = raise (Refused reason)

(* The fields of an object, each once, all of [required] and none but these and [optional]. *)
let fields ?(optional = []) required = function
  | Json.Object entries ->
      let names = List.map fst entries in
      List.iter
        (fun name ->
          if not (List.mem name (required @ optional)) then refused ("unknown field " ^ String.escaped name))
        names;
      if List.length (List.sort_uniq compare names) <> List.length names then refused "a field twice";
      List.iter (fun name -> if not (List.mem name names) then refused ("missing field " ^ name)) required;
      fun name -> List.assoc_opt name entries
  | _ -> refused "an object is expected"

let get field name = match field name with Some v -> v | None -> refused ("missing field " ^ name)
let text = function Json.Text t -> t | _ -> refused "a text is expected"
let list = function Json.List l -> l | _ -> refused "a list is expected"
let texts v = List.map text (list v)

let is_decimal t = t <> "" && String.for_all (fun c -> c >= '0' && c <= '9') t
let is_hexadecimal t = t <> "" && String.for_all (fun c -> (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f')) t

(* Leading zeros do not count. *)
let stripped t =
  let n = String.length t in
  let rec first i = if i + 1 < n && t.[i] = '0' then first (i + 1) else i in
  let i = first 0 in
  String.sub t i (n - i)

let after prefix t =
  let k = String.length prefix in
  if String.length t >= k && String.sub t 0 k = prefix then Some (String.sub t k (String.length t - k)) else None

let before suffix t =
  let k = String.length suffix and n = String.length t in
  if n >= k && String.sub t (n - k) k = suffix then Some (String.sub t 0 (n - k)) else None

let split c t =
  match String.index_opt t c with
  | Some i -> Some (String.sub t 0 i, String.sub t (i + 1) (String.length t - i - 1))
  | None -> None

let signed t = match after "-" t with Some rest -> (true, rest) | None -> (false, t)

(* `-0x1f3p-12` *)
let dyadic v =
  let t = text v in
  let bad () = refused "a number is -0x1f3p-12" in
  let negative, rest = signed t in
  match Option.bind (after "0x" rest) (split 'p') with
  | Some (m, e) when is_hexadecimal m ->
      let negative_power, size = signed e in
      if not (is_decimal size) then bad ();
      let size = stripped size in
      if String.length size > 8 || int_of_string size > 10_000_000 then bad ();
      if int_of_string size > most_exponent then
        raise (Beyond (Printf.sprintf "an exponent beyond %d" most_exponent));
      let exponent = if negative_power then -int_of_string size else int_of_string size in
      let m = Integer.of_string_base 16 m in
      { mantissa = (if negative then Integer.neg m else m); exponent = Integer.of_int exponent }
  | _ -> bad ()

let fraction t =
  match split '/' t with
  | Some (p, q)
    when is_decimal p && is_decimal q && String.length p <= 100_000 && String.length q <= 100_000 ->
      let q = Integer.of_string q in
      if Integer.sign q = 0 then refused "a denominator is zero";
      (Integer.of_string p, q)
  | _ -> refused "a fraction is expected"

(* `49/20`, `1/2 pi`, `2 atan 3/5` *)
let number t =
  match (before " pi" t, after "2 atan " t) with
  | Some t, _ -> let p, q = fraction t in TimesPi (p, q)
  | None, Some t -> let p, q = fraction t in TwiceArctangent (p, q)
  | None, None -> let p, q = fraction t in Fraction (p, q)

let friction t =
  match after "tan " t with
  | _ when t = "inf" -> Unlimited
  | Some t -> Angle (number t)
  | None -> Coefficient (number t)

let named what names t =
  match List.assoc_opt t names with Some v -> v | None -> refused ("unknown " ^ what ^ " " ^ String.escaped t)

let weights = [ ("heyman", Heyman); ("milankovitch", Milankovitch) ]

let modes =
  [
    ("[r,r,r]", Rotational); ("[s,r,r]", SlidingRotational); ("[r,r,s]", RotationalSliding);
    ("[r,s,r]", RotationalSlidingRotational); ("[r,s]", OverturningSliding); ("[r]", Overturning);
  ]

let landmarks =
  [
    ("T", Triple); ("S", Shift); ("J", Junction); ("B", Border); ("l", RotationEnd); ("L", OverturningEnd);
    ("sb", WidestJoint);
  ]

let kinds =
  [ ("inner_sliding", SlidesInside); ("shoulder_opening", OpensAtShoulder); ("shoulder_sliding", SlidesAlone) ]

let places = [ ("crown", AtCrown); ("haunch", AtHaunch); ("shoulder", AtShoulder) ]

let quantities =
  [
    ("thickness", Plain Eta); ("thrust", Plain Thrust); ("intrinsic_thrust", IntrinsicThrust);
    ("friction", Plain Mu); ("friction_angle", FrictionAngle); ("friction_angle_degrees", FrictionAngleDegrees);
    ("half_opening", Plain Alpha); ("half_opening_degrees", Degrees Alpha); ("A", OpeningVariable);
    ("rotation_joint", Plain BetaR); ("rotation_joint_degrees", Degrees BetaR);
    ("sliding_joint", Plain BetaS); ("sliding_joint_degrees", Degrees BetaS);
    ("crown_moment", Plain Moment); ("vertical_force", Plain Force); ("crown_hinge", Plain Hinge);
    ("crown_hinge_degrees", Degrees Hinge); ("shoulder_slip", Plain Slip); ("inner_slip", Plain InnerSlip);
    ("shoulder_opening", Plain Opening); ("power", Plain Power);
  ]

let arch weight field =
  {
    self_weight = weight;
    half_opening = number (text (get field "half_opening"));
    its_friction = friction (text (get field "friction"));
  }

(* The names of unknowns and equations that a file has to state. *)
let alpha = "half_opening" and beta_r = "rotation_joint" and beta_s = "sliding_joint"
let eta = "thickness" and thrust = "thrust" and mu = "friction"
let steepest = "beta_s^2 = h (1 - h)" and at_crown = "(5) at beta_r -> 0"

let of_mode = function
  | Rotational -> ([ beta_r; eta; thrust ], [ "(2)"; "(4)"; "(5)" ])
  | SlidingRotational -> ([ beta_r; eta; thrust ], [ "(2)"; "(5)"; "(17)" ])
  | RotationalSliding | RotationalSlidingRotational ->
      ([ beta_r; eta; thrust; beta_s ], [ "(3)"; "(5)"; "(18)"; steepest ])
  | OverturningSliding -> ([ eta; thrust; beta_s ], [ "(3)"; "(18)"; steepest ])
  | Overturning -> ([ eta ], [ "(4)" ])

let of_landmark = function
  | Triple -> ([ alpha; beta_r; beta_s; eta; thrust; mu ], [ "(2)"; "(4)"; "(5)"; "(17)"; "(18)"; steepest ])
  | Shift -> ([ alpha; beta_s; eta; thrust; mu ], [ "(3)"; "(5)"; "(17)"; "(18)"; steepest ])
  | Junction -> ([ alpha; beta_s; eta; thrust; mu ], [ "(3)"; at_crown; "(17)"; "(18)"; steepest ])
  | Border -> ([ alpha; beta_s; thrust; mu ], [ "(3)"; "(17)"; "(18)"; steepest ])
  | RotationEnd -> ([ alpha; eta ], [ "(4)"; at_crown ])
  | OverturningEnd -> ([ alpha ], [ "(4)" ])
  | WidestJoint -> ([ alpha; beta_r; eta; thrust ], [ "(2)"; "(4)"; "(5)"; "d/d eta of (2) = (5)" ])

let of_kind k =
  let unknowns = [ thrust; "crown_moment"; "vertical_force"; eta; "crown_hinge"; beta_r ] in
  let equations = [ "E(b0) = 0"; "E'(b0) = 0"; "I(-b1) = 0"; "I'(-b1) = 0"; "O(alpha) = 0" ] in
  match k with
  | SlidesInside -> (unknowns @ [ beta_s ], equations @ [ "O(-b2) = 0"; "O'(-b2) = 0" ])
  | OpensAtShoulder -> (unknowns, equations @ [ "E(alpha) = 0" ])
  | SlidesAlone -> (unknowns, equations @ [ "(2 - eta) cos(b1 + alpha) = (2 + eta) cos(alpha - b0)" ])

let contacts k =
  let slides = "slides outwards, right shoulder" and crown = "hinge at the extrados, right crown" in
  let haunch = "hinge at the intrados, left haunch" in
  match k with
  | SlidesInside -> [ slides; crown; "slides inwards, left inner"; haunch ]
  | OpensAtShoulder -> [ slides; "hinge at the extrados, right shoulder"; crown; haunch ]
  | SlidesAlone -> [ slides; crown; haunch ]

(* The subject of a claim, and the names that go with it. *)
let subject claim =
  let subjects = [ "landmark"; "state"; "slides"; "too_wide"; "too_thin"; "stands"; "asymmetric" ] in
  let field = fields ~optional:subjects [ "weight"; "unknowns"; "equations" ] claim in
  let weight = named "weight" weights (text (get field "weight")) in
  let found = List.filter (fun name -> field name <> None) subjects in
  let there = [ "half_opening"; "friction" ] in
  let about, names =
    match found with
    | [ "landmark" ] ->
        let l = named "landmark" landmarks (text (get field "landmark")) in
        (Landmark (l, weight), of_landmark l)
    | [ "state" ] ->
        let f = fields ("mode" :: there) (get field "state") in
        let m = named "mode" modes (text (get f "mode")) in
        (State (m, arch weight f), of_mode m)
    | [ "too_thin" ] ->
        let f = fields ("mode" :: "thickness" :: there) (get field "too_thin") in
        let m = named "mode" modes (text (get f "mode")) in
        (TooThin (m, arch weight f, number (text (get f "thickness"))), of_mode m)
    | [ "slides" ] ->
        let f = fields there (get field "slides") in
        (Slides (arch weight f), ([ mu; thrust; beta_s ], [ "(17)"; "(18)"; steepest ]))
    | [ "too_wide" ] ->
        let a = arch weight (fields there (get field "too_wide")) in
        ( TooWide a,
          if a.its_friction = Unlimited then ([ alpha ], [ "(4)" ])
          else ([ alpha; thrust; beta_s ], [ "(3)"; "(18)"; steepest ]) )
    | [ "stands" ] ->
        let f =
          fields ([ "thickness"; "thrust"; "crown_moment"; "nearest" ] @ there) (get field "stands")
        in
        let there = named "place" places (text (get f "nearest")) in
        ( Stands
            ( arch weight f, number (text (get f "thickness")), dyadic (get f "thrust"),
              dyadic (get f "crown_moment"), there ),
          if there = AtHaunch then ([ beta_r ], [ "(5)" ]) else ([], []) )
    | [ "asymmetric" ] ->
        let f = fields ("mode" :: "contacts" :: there) (get field "asymmetric") in
        let k = named "mode" kinds (text (get f "mode")) in
        if texts (get f "contacts") <> contacts k then refused "the contacts are not those of the kind";
        (Asymmetric (k, arch weight f), of_kind k)
    | _ -> refused "exactly one subject is expected"
  in
  let unknowns, equations = names in
  if texts (get field "unknowns") <> unknowns then refused "the unknowns are not those of the subject";
  if texts (get field "equations") <> equations then refused "the equations are not those of the subject";
  about

(* A decimal as a mantissa of all the digits and a power of ten. *)
let written digits t =
  let bad () = refused "a value is no decimal" in
  if t = "inf" then Infinite
  else begin
    let mantissa, power = match split 'e' t with Some parts -> parts | None -> (t, "0") in
    let whole, part = match split '.' mantissa with Some parts -> parts | None -> (mantissa, "") in
    let sound = is_decimal whole && (is_decimal part || not (String.contains mantissa '.')) in
    if not (sound && (String.length whole = 1 || whole.[0] <> '0')) then bad ();
    let negative, size = signed power in
    if not (is_decimal size) then bad ();
    let size = stripped size in
    if String.length size > 7 || int_of_string size > 3_000_000 then bad ();
    let power = if negative then -int_of_string size else int_of_string size in
    let all = stripped (whole ^ part) in
    if all = "0" then if t = "0" then Decimal (Integer.zero, Integer.zero) else bad ()
    else begin
      let power = power - String.length part in
      (* Zeros at the end of a whole number only show its size. *)
      let n = String.length all in
      let rec zeros k = if k < n - digits && all.[n - 1 - k] = '0' then zeros (k + 1) else k in
      let left_out = if String.contains mantissa '.' then 0 else zeros 0 in
      let all = String.sub all 0 (n - left_out) and power = power + left_out in
      let missing = digits - String.length all in
      if missing < 0 then bad ();
      Decimal (Integer.of_string (all ^ String.make missing '0'), Integer.of_int (power - missing))
    end
  end

let value digits v =
  let f = fields [ "quantity"; "value" ] v in
  (named "quantity" quantities (text (get f "quantity")), written digits (text (get f "value")))

let bits d = Integer.numbits d.mantissa

let box most v =
  let f = fields [ "centre"; "radius" ] v in
  let centre = List.map dyadic (list (get f "centre")) and radius = List.map dyadic (list (get f "radius")) in
  if List.exists (fun d -> bits d > most) centre || List.exists (fun d -> bits d > 256) radius then
    refused "a number is too long";
  { centre; radius }

let single json =
  let field = fields [ "schema"; "tool"; "claim"; "digits"; "unique"; "inverse"; "root"; "values" ] json in
  if text (get field "schema") <> "couplet.certificate/1" then refused "another schema";
  ignore (text (get field "tool"));
  let about = subject (get field "claim") in
  let digits =
    match get field "digits" with
    | Json.Integer t when is_decimal t && String.length t <= 7 -> int_of_string t
    | _ -> refused "digits are 1 to 1000000"
  in
  if digits < 1 || digits > 1_000_000 then refused "digits are 1 to 1000000";
  if digits > most_digits then raise (Beyond (Printf.sprintf "more than %d digits" most_digits));
  let values = List.map (value digits) (list (get field "values")) in
  let names = List.map fst values in
  if List.length (List.sort_uniq compare names) <> List.length names then refused "a quantity twice";
  (match (values, about) with
  | [], Stands _ -> ()
  | [], _ -> refused "no value"
  | _ -> ());
  let root = box ((digits * 10 / 3) + 24_000) (get field "root") and unique = box 24_000 (get field "unique") in
  let forces = match about with Stands (_, _, h, p, _) -> [ h; p ] | _ -> [] in
  if List.exists (fun d -> bits d > 24_000) forces then refused "a number is too long";
  if List.exists (fun d -> bits d > most_bits) (forces @ root.centre @ unique.centre) then
    raise (Beyond (Printf.sprintf "a number of more than %d bits" most_bits));
  let inverse = List.map (fun row -> List.map dyadic (list row)) (list (get field "inverse")) in
  if List.exists (List.exists (fun d -> bits d > 24_000)) inverse then refused "a number is too long";
  { about; digits = Integer.of_int digits; unique; inverse; root; values }

(* A file is a certificate of one arch or landmark, or of a survey. *)
type file = Single of certificate | Survey of survey_certificate

let circles = [ ("intrados", AtIntrados); ("centreline", AtCentreline); ("extrados", AtExtrados) ]
let verdicts = [ ("all_stand", AllStand); ("none_stands", NoneStands); ("both_occur", BothOccur) ]

let ends read v = match list v with [ a; b ] -> (read (text a), read (text b)) | _ -> refused "two ends are expected"

let length t =
  if List.exists (fun integer -> String.length integer > 300) (String.split_on_char '/' t) then
    refused "a length has more than 300 digits";
  let qnum, qden = fraction t in
  if Integer.sign qnum = 0 then refused "a length is zero";
  { qnum; qden }

let shape field =
  match (field "free", field "spanned") with
  | Some v, None ->
      let f = fields [ "half_opening"; "thickness" ] v in
      Free (ends number (get f "half_opening"), ends number (get f "thickness"))
  | None, Some v ->
      let f = fields [ "circle"; "span"; "rise"; "thickness" ] v in
      let range name = ends length (get f name) in
      Spanned (named "circle" circles (text (get f "circle")), range "span", range "rise", range "thickness")
  | _ -> refused "a survey is free or spanned"

(* The sides of the parts follow from the verdict. *)
let part side v =
  let f = fields ~optional:[ "step" ] [ "side"; "certificate" ] v in
  if text (get f "side") <> side then refused "a part is not on the side of the verdict";
  let step v =
    let f = fields [ "span"; "rise" ] v in
    let (span, span'), (rise, rise') = (ends length (get f "span"), ends length (get f "rise")) in
    ((span, rise), (span', rise'))
  in
  { its_step = Option.map step (f "step"); its_certificate = single (get f "certificate") }

let survey json =
  let field = fields [ "schema"; "tool"; "survey"; "verdict"; "parts" ] json in
  ignore (text (get field "tool"));
  let f = fields ~optional:[ "free"; "spanned" ] [ "weight"; "friction" ] (get field "survey") in
  let of_survey =
    {
      survey_weight = named "weight" weights (text (get f "weight"));
      frictions = ends friction (get f "friction");
      its_shape = shape f;
    }
  in
  let its_verdict = named "verdict" verdicts (text (get field "verdict")) in
  let side i =
    match (its_verdict, i) with AllStand, _ | BothOccur, 0 -> "unsafe" | NoneStands, _ | BothOccur, _ -> "safe"
  in
  { of_survey; its_verdict; parts = List.mapi (fun i v -> part (side i) v) (list (get field "parts")) }

let file bytes =
  match Json.read bytes with
  | Json.Object entries as json when List.assoc_opt "schema" entries = Some (Json.Text "couplet.survey-certificate/1") ->
      Survey (survey json)
  | json -> Single (single json)
