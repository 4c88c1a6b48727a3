(* slipproof-check-verified CERT|STATEMENT|FOLDER...: the extracted checker on files. Exit codes: 0 if all certificates
   are accepted, 5 if one is rejected, otherwise 3 if one is missing or cannot be read; 2 for wrong usage.
   slipproof-check-verified --compare RECORD: on what the tests of slipproof-check recorded, `VERDICT S C`, then S bytes
   of a statement and C of a certificate, again and again; 5 if a verdict differs. *)

let usage = "usage: slipproof-check-verified CERT|STATEMENT|FOLDER...\n       slipproof-check-verified --compare RECORD\n"

(* A check may allocate 8 GB in all and hold 1 GB; beyond that the certificate is rejected. The largest shipped proof
   allocates 0.4 GB. *)
exception Too_much

let most_samples = 1_024
let most_held = 1 lsl 27 (* words *)

let bounded work =
  let samples = ref 0 in
  let count _ =
    incr samples;
    if !samples > most_samples || (Gc.quick_stat ()).heap_words > most_held then raise Too_much;
    None
  in
  Gc.Memprof.start ~sampling_rate:1e-6 ~callstack_size:0
    { Gc.Memprof.null_tracker with alloc_minor = count; alloc_major = count };
  match Fun.protect ~finally:Gc.Memprof.stop work with
  | result -> result
  | exception (Stack_overflow | Too_much) -> Gc.compact (); None

let explode text = List.init (String.length text) (String.get text)

(* Statement after statement is often the same. *)
let last = ref ("", None)

let reading statement =
  if fst !last <> statement || snd !last = None then last := (statement, Checker.read_statement (explode statement));
  snd !last

let judge statement certificate =
  match bounded (fun () -> reading statement) with
  | None -> "unreadable"
  | Some read -> (
      match bounded (fun () -> Some (Checker.accepts_for read (explode certificate))) with
      | Some true -> "accepted"
      | Some false | None -> "rejected")

let content path =
  let file = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in file) (fun () -> really_input_string file (in_channel_length file))

let rec files path =
  if Sys.is_directory path then
    let entries = Sys.readdir path in
    Array.sort compare entries;
    let kept below = Sys.is_directory below || List.exists (Filename.check_suffix below) [ ".cert"; ".statement" ] in
    List.concat_map files (List.filter kept (List.map (Filename.concat path) (Array.to_list entries)))
  else [ path ]

let certificates path = List.sort_uniq compare (List.map (fun file -> Filename.remove_extension file ^ ".cert") (files path))

let verdict path =
  match content (Filename.remove_extension path ^ ".statement") with
  | exception (Sys_error _ | End_of_file) -> "unreadable"
  | _ when not (Sys.file_exists path) -> "missing"
  | statement -> (
      match content path with
      | certificate -> judge statement certificate
      | exception (Sys_error _ | End_of_file) -> "unreadable")

let check paths =
  let count = Hashtbl.create 4 in
  let counted verdict = Option.value ~default:0 (Hashtbl.find_opt count verdict) in
  let tell path =
    let found = verdict path in
    Hashtbl.replace count found (counted found + 1);
    Printf.printf "%s %s\n" found path
  in
  let below path = match certificates path with [] | (exception Sys_error _) -> [ path ] | found -> found in
  List.iter (fun path -> List.iter tell (below path)) paths;
  let result, code =
    if counted "rejected" > 0 then ("REJECTED", 5)
    else if counted "unreadable" + counted "missing" > 0 then ("UNREADABLE", 3)
    else ("ACCEPTED", 0)
  in
  Printf.printf "s %s %d accepted, %d rejected, %d missing, %d unreadable\n" result (counted "accepted")
    (counted "rejected") (counted "missing") (counted "unreadable");
  code

let compare_with record =
  let input = open_in_bin record in
  let pairs = ref 0 and accepted = ref 0 and different = ref 0 in
  let compare_one verdict s c =
    let statement = really_input_string input s in
    let certificate = really_input_string input c in
    let found = judge statement certificate in
    incr pairs;
    if found = "accepted" then incr accepted;
    if found <> verdict then begin
      incr different;
      Printf.printf "slipproof-check: %s; verified: %s\n%s%s\n" verdict found statement certificate
    end
  in
  (try
     while true do
       Scanf.sscanf (input_line input) "%s %d %d" compare_one
     done
   with End_of_file -> ());
  Printf.printf "s %s %d pairs, %d accepted, %d judged differently\n"
    (if !different = 0 then "ALIKE" else "DIFFERENT")
    !pairs !accepted !different;
  if !different > 0 then 5 else 0

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [ "--compare"; record ] -> exit (compare_with record)
  | first :: _ as paths when not (String.starts_with ~prefix:"-" first) -> exit (check paths)
  | _ -> prerr_string usage; exit 2
