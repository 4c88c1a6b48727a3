(* slipproof-check-verified CERT|FOLDER...: the extracted checker on files. Exit codes: 0 if all certificates are
   accepted, 5 if one is rejected, otherwise 3 if one cannot be read, 2 for wrong usage.
   slipproof-check-verified --compare RECORD: on what the tests of slipproof-check recorded, `VERDICT S C`, then S bytes
   of a statement and C of a certificate, again and again; 5 if a verdict differs. *)

let usage = "usage: slipproof-check-verified CERT|FOLDER...\n       slipproof-check-verified --compare RECORD\n"

(* A check may allocate 32 GB in all and hold 4 GB; beyond that the certificate is rejected. The largest shipped proof needs a tenth. *)
exception Too_much

let most_samples = 4_096
let most_held = 1 lsl 29 (* words *)
let samples = ref 0

let watch () =
  let count _ =
    incr samples;
    if !samples > most_samples || (Gc.quick_stat ()).heap_words > most_held then raise Too_much;
    None
  in
  Gc.Memprof.start ~sampling_rate:1e-6 ~callstack_size:0
    { Gc.Memprof.null_tracker with alloc_minor = count; alloc_major = count }

let explode text = List.init (String.length text) (String.get text)

(* Statement after statement is often the same. *)
let last = ref ("", None)

let reading statement =
  if fst !last <> statement || snd !last = None then last := (statement, Checker.read_statement (explode statement));
  snd !last

let accepts statement certificate =
  samples := 0;
  match Option.fold ~none:false ~some:(fun read -> Checker.accepts_for read (explode certificate)) (reading statement) with
  | accepted -> accepted
  | exception (Stack_overflow | Too_much) -> false

let content path =
  let file = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in file) (fun () -> really_input_string file (in_channel_length file))

let rec certificates path =
  if Sys.is_directory path then
    let entries = Sys.readdir path in
    Array.sort compare entries;
    let kept below = Filename.check_suffix below ".cert" || Sys.is_directory below in
    List.concat_map certificates (List.filter kept (List.map (Filename.concat path) (Array.to_list entries)))
  else [ path ]

let verdict path =
  match content (Filename.remove_extension path ^ ".statement"), content path with
  | statement, certificate -> if accepts statement certificate then "accepted" else "rejected"
  | exception (Sys_error _ | End_of_file) -> "unreadable"

let check paths =
  let count = Hashtbl.create 3 in
  let counted verdict = Option.value ~default:0 (Hashtbl.find_opt count verdict) in
  let judge path =
    let found = verdict path in
    Hashtbl.replace count found (counted found + 1);
    Printf.printf "%s %s\n" found path
  in
  let below path = try certificates path with Sys_error _ -> [ path ] in
  List.iter (fun path -> List.iter judge (below path)) paths;
  let accepted = counted "accepted" and rejected = counted "rejected" and unreadable = counted "unreadable" in
  Printf.printf "s %s %d accepted, %d rejected, %d unreadable\n"
    (if rejected + unreadable = 0 then "ACCEPTED" else "REJECTED")
    accepted rejected unreadable;
  if rejected > 0 then 5 else if unreadable > 0 then 3 else 0

let compare_with record =
  let input = open_in_bin record in
  let pairs = ref 0 and accepted = ref 0 and different = ref 0 in
  let judge verdict s c =
    let statement = really_input_string input s in
    let certificate = really_input_string input c in
    let found = accepts statement certificate in
    incr pairs;
    if found then incr accepted;
    if found <> (verdict = "accepted") then begin
      incr different;
      Printf.printf "slipproof-check: %s; verified: %s\n%s%s\n" verdict
        (if found then "accepted" else "rejected")
        statement certificate
    end
  in
  (try
     while true do
       Scanf.sscanf (input_line input) "%s %d %d" judge
     done
   with End_of_file -> ());
  Printf.printf "s %s %d pairs, %d accepted, %d judged differently\n"
    (if !different = 0 then "ALIKE" else "DIFFERENT")
    !pairs !accepted !different;
  if !different > 0 then 5 else 0

let () =
  watch ();
  match List.tl (Array.to_list Sys.argv) with
  | [ "--compare"; record ] -> exit (compare_with record)
  | first :: _ as paths when not (String.starts_with ~prefix:"-" first) -> exit (check paths)
  | _ -> prerr_string usage; exit 2
