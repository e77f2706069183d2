(* couplet-verified: certificates checked by a function of which Coq has proved that what it accepts is true. *)

let usage = "couplet-verified: usage: couplet-verified check FILE..."
let largest = 64 lsl 20

(* The bytes of a file; what keeps them from being read, without the name that the system puts before it. *)
let read path =
  match Sys.is_directory path with
  | true -> Error "a folder"
  | exception Sys_error _ -> Error "no such file"
  | false -> (
      try
        let channel = open_in_bin path in
        let bytes () =
          let size = in_channel_length channel in
          if size > largest then raise (Reader.Beyond "more than 64 MiB") else really_input_string channel size
        in
        Ok (Fun.protect ~finally:(fun () -> close_in channel) bytes)
      with Sys_error _ | End_of_file -> Error "cannot be read")

(* One line for each file, whatever its name is: 0 accepted, 1 refused, 3 not checked or not read. *)
let check path =
  let name = String.escaped path in
  let say word words = Printf.printf "%s  %s: %s\n%!" word name words in
  let answer is_proved statement = if is_proved then (say "accepted" statement; 0) else (say "refused" "the claim is not proved"; 1) in
  match Result.map Reader.file (read path) with
  | Ok (Reader.Single c) -> answer (Verified.check c) (Statement.statement c)
  | Ok (Reader.Survey c) -> answer (Verified.check_survey c) (Statement.of_survey c)
  | Error reason -> Printf.eprintf "couplet-verified: %s: %s\n%!" name reason; 3
  | exception (Reader.Refused reason | Json.Malformed reason) -> say "refused" reason; 1
  | exception Reader.Beyond what -> say "not checked" what; 3

let () =
  match Array.to_list Sys.argv with
  | _ :: "check" :: (_ :: _ as files) when not (List.exists (fun f -> f <> "" && f.[0] = '-') files) ->
      let codes = List.map check files in
      exit (if List.mem 1 codes then 1 else List.fold_left max 0 codes)
  | [ _; ("--help" | "-h") ] -> print_endline usage
  | _ -> prerr_endline usage; exit 2
