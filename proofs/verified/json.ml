(* JSON as docs/certificate.md asks for it: strict, no duplicates, no half of a surrogate pair, no long list but one. *)

type t =
  | Object of (string * t) list
  | List of t list
  | Text of string
  | Integer of string
  | Other

exception Malformed of string

let malformed place = raise (Malformed ("no certificate: malformed JSON at byte " ^ string_of_int place))

(* Deepest nesting, and the most entries of a list. *)
let deepest = 64
let longest = function "parts" -> 4096 | _ -> 32

(* UTF-8 without surrogates and overlong forms. *)
let is_utf8 text =
  let n = String.length text in
  let byte i = if i < n then Char.code text.[i] else 0 in
  let follows i = byte i land 0xc0 = 0x80 in
  let rec from i =
    i >= n
    ||
    let b = byte i and c = byte (i + 1) in
    if b < 0x80 then from (i + 1)
    else if b >= 0xc2 && b < 0xe0 then follows (i + 1) && from (i + 2)
    else if b >= 0xe0 && b < 0xf0 then
      follows (i + 1) && follows (i + 2)
      && (b <> 0xe0 || c >= 0xa0)
      && (b <> 0xed || c < 0xa0)
      && from (i + 3)
    else
      b >= 0xf0 && b < 0xf5
      && follows (i + 1) && follows (i + 2) && follows (i + 3)
      && (b <> 0xf0 || c >= 0x90)
      && (b <> 0xf4 || c < 0x90)
      && from (i + 4)
  in
  from 0

let read text =
  if not (is_utf8 text) then raise (Malformed "no certificate: not UTF-8");
  let n = String.length text in
  let at = ref (if n >= 3 && String.sub text 0 3 = "\xef\xbb\xbf" then 3 else 0) in
  let peek () = if !at < n then text.[!at] else '\000' in
  let skip () = while !at < n && String.contains " \t\n\r" text.[!at] do incr at done in
  let expect c = if !at < n && text.[!at] = c then incr at else malformed !at in
  let word w value =
    let k = String.length w in
    if !at + k <= n && String.sub text !at k = w then (at := !at + k; value) else malformed !at
  in
  let hex4 () =
    let digit c =
      match c with
      | '0' .. '9' -> Char.code c - 48
      | 'a' .. 'f' -> Char.code c - 87
      | 'A' .. 'F' -> Char.code c - 55
      | _ -> malformed !at
    in
    if !at + 4 > n then malformed !at;
    let value = ref 0 in
    for _ = 1 to 4 do value := (16 * !value) + digit text.[!at]; incr at done;
    !value
  in
  let string () =
    expect '"';
    let out = Buffer.create 64 in
    let rec go () =
      if !at >= n then malformed !at;
      let c = text.[!at] in
      incr at;
      match c with
      | '"' -> ()
      | '\\' ->
          let e = peek () in
          incr at;
          (match e with
          | '"' | '\\' | '/' -> Buffer.add_char out e
          | 'b' -> Buffer.add_char out '\b'
          | 'f' -> Buffer.add_char out '\012'
          | 'n' -> Buffer.add_char out '\n'
          | 'r' -> Buffer.add_char out '\r'
          | 't' -> Buffer.add_char out '\t'
          | 'u' ->
              let high = hex4 () in
              let code =
                if high >= 0xd800 && high < 0xdc00 then begin
                  expect '\\'; expect 'u';
                  let low = hex4 () in
                  if low < 0xdc00 || low > 0xdfff then malformed !at;
                  0x10000 + ((high - 0xd800) * 0x400) + (low - 0xdc00)
                end
                else high
              in
              if Uchar.is_valid code then Buffer.add_utf_8_uchar out (Uchar.of_int code) else malformed !at
          | _ -> malformed !at);
          go ()
      | c when Char.code c < 32 -> malformed !at
      | c -> Buffer.add_char out c; go ()
    in
    go ();
    Buffer.contents out
  in
  let is_digit c = c >= '0' && c <= '9' in
  let number () =
    let start = !at in
    let digits () = if not (is_digit (peek ())) then malformed !at; while is_digit (peek ()) do incr at done in
    if peek () = '-' then incr at;
    if peek () = '0' then incr at else digits ();
    let whole = !at in
    if peek () = '.' then (incr at; digits ());
    if peek () = 'e' || peek () = 'E' then begin
      incr at;
      if peek () = '+' || peek () = '-' then incr at;
      digits ()
    end;
    if !at = whole then Integer (String.sub text start (whole - start)) else Other
  in
  let rec value name depth =
    if depth > deepest then malformed !at;
    skip ();
    let v =
      match peek () with
      | '{' -> incr at; Object (entries depth '}' (field depth) [])
      | '[' ->
          incr at;
          let list = entries depth ']' (fun () -> value "" (depth + 1)) [] in
          if List.length list > longest name then malformed !at;
          List list
      | '"' -> Text (string ())
      | 't' -> word "true" Other
      | 'f' -> word "false" Other
      | 'n' -> word "null" Other
      | _ -> number ()
    in
    skip ();
    v
  and field depth () =
    skip ();
    let name = string () in
    skip ();
    expect ':';
    (name, value name (depth + 1))
  and entries : 'a. int -> char -> (unit -> 'a) -> 'a list -> 'a list =
   fun depth close entry sofar ->
    skip ();
    if sofar = [] && peek () = close then (incr at; [])
    else begin
      let sofar = entry () :: sofar in
      skip ();
      match peek () with
      | ',' -> incr at; more depth close entry sofar
      | c when c = close -> incr at; List.rev sofar
      | _ -> malformed !at
    end
  and more : 'a. int -> char -> (unit -> 'a) -> 'a list -> 'a list =
   fun depth close entry sofar ->
    let sofar = entry () :: sofar in
    skip ();
    match peek () with
    | ',' -> incr at; more depth close entry sofar
    | c when c = close -> incr at; List.rev sofar
    | _ -> malformed !at
  in
  let v = value "" 0 in
  if !at < n then malformed !at;
  v
