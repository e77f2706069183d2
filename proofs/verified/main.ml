(* couplet-verified: certificates checked by a function of which Coq has proved that what it accepts is true. *)

let usage = "couplet-verified: usage: couplet-verified check FILE..."

let read path =
  let channel = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> really_input_string channel (in_channel_length channel))

(* One line for each file: 0 accepted, 1 refused, 3 not checked. *)
let check path =
  let say word reason = Printf.printf "%s  %s%s\n%!" word path (if reason = "" then "" else ": " ^ reason) in
  match Reader.certificate (read path) with
  | certificate ->
      if Verified.check certificate then (say "accepted" ""; 0)
      else (say "refused" "the claim is not proved"; 1)
  | exception (Reader.Refused reason | Json.Malformed reason) -> say "refused" reason; 1
  | exception Reader.Beyond what -> say "not checked" what; 3
  | exception Sys_error reason -> prerr_endline ("couplet-verified: " ^ reason); 3

let () =
  match Array.to_list Sys.argv with
  | _ :: "check" :: (_ :: _ as files) when not (List.exists (fun f -> f <> "" && f.[0] = '-') files) ->
      let codes = List.map check files in
      exit (if List.mem 1 codes then 1 else List.fold_left max 0 codes)
  | [ _; ("--help" | "-h") ] -> print_endline usage
  | _ -> prerr_endline usage; exit 2
