(* slipproof-check-verified CERT|STATEMENT|FOLDER...: the extracted checker on files, which it finds and names as
   slipproof-check does. Exit codes: 0 if all certificates are accepted, 5 if one is rejected, otherwise 3 if one is
   missing or cannot be read, 4 if the search for one ended without; 2 for wrong usage, 6 if the result cannot be written.
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

let judge_certificate read certificate =
  let text = explode certificate in
  match bounded (fun () -> Some (Checker.accepts_for read text)) with
  | Some true -> "accepted"
  | _ when bounded (fun () -> Some (Checker.is_undecided read text)) = Some true -> "undecided"
  | _ -> "rejected"

let judge statement certificate =
  match bounded (fun () -> reading statement) with
  | None -> "unreadable"
  | Some read -> judge_certificate read certificate

(* Bytes; slipproof-check refuses longer files, too. *)
let most_of_statement = 1_048_576
let most_of_certificate = 50_000_000

type file = Text of string | Too_long | No_text

(* Opens regular files only: others may have no end, or wait for a writer. *)
let load path most =
  let read file =
    let text = Buffer.create 4096 in
    (try Buffer.add_channel text file (most + 1) with End_of_file -> ());
    if Buffer.length text > most then Too_long else Text (Buffer.contents text)
  in
  try
    if (Unix.stat path).st_kind <> Unix.S_REG then No_text
    else
      let file = open_in_bin path in
      Fun.protect ~finally:(fun () -> close_in_noerr file) (fun () -> read file)
  with Unix.Unix_error _ | Sys_error _ -> No_text

(* As std::filesystem does it: of `.cert` none, of `..cert` `.cert`. *)
let split_extension path =
  let name = Filename.basename path in
  match String.rindex_opt name '.' with
  | Some place when place > 0 && name <> ".." ->
      let size = String.length path - String.length name + place in
      (String.sub path 0 size, String.sub path size (String.length path - size))
  | _ -> (path, "")

let extension path = snd (split_extension path)
let with_extension path other = fst (split_extension path) ^ other

let verdict path =
  match load (with_extension path ".statement") most_of_statement with
  | _ when extension path <> ".cert" -> "unreadable"
  | No_text | Too_long -> "unreadable"
  | Text statement -> (
      match bounded (fun () -> reading statement) with
      | None -> "unreadable"
      | Some read -> (
          match Unix.lstat path with
          | exception Unix.Unix_error (Unix.ENOENT, _, _) -> "missing"
          | exception Unix.Unix_error _ -> "unreadable"
          | _ -> (
              match load path most_of_certificate with
              | Text certificate -> judge_certificate read certificate
              | Too_long -> "rejected"
              | No_text -> "unreadable")))

module Paths = Set.Make (struct
  type t = string

  let compare a b = compare (String.split_on_char '/' a) (String.split_on_char '/' b)
end)

let is_folder path = try Sys.is_directory path with Sys_error _ -> false
let kind path = try Some (Unix.lstat path).st_kind with Unix.Unix_error _ -> None

let is_below path root =
  try
    let root = Unix.realpath root and path = Unix.realpath path in
    path = root || root = "/" || String.starts_with ~prefix:(root ^ "/") path
  with Unix.Unix_error _ -> false

(* The certificates of all statements in a folder and below, and those without a statement; and what `verdict` then
   calls unreadable: what cannot be looked at, folders that cannot be listed, and links to folders elsewhere, which are
   not followed. *)
let rec find root folder found =
  let add found name =
    let path = Filename.concat folder name in
    let kind = kind path in
    if kind = Some Unix.S_DIR then find root path found
    else if List.mem (extension path) [ ".cert"; ".statement" ] then Paths.add (with_extension path ".cert") found
    else if kind = None || (is_folder path && not (is_below path root)) then Paths.add path found
    else found
  in
  match Sys.readdir folder with
  | exception Sys_error _ -> Paths.add folder found
  | names -> Array.fold_left add found names

(* Of an argument that is a folder without any, the folder. *)
let certificates path =
  if is_folder path then match Paths.elements (find path path Paths.empty) with [] -> [ path ] | found -> found
  else if extension path = ".statement" then [ with_extension path ".cert" ]
  else [ path ]

(* How many bytes from a place are one character that can be shown, as in src/proofs/check/files.cpp. *)
let shown_character text place =
  let byte i = if place + i < String.length text then Char.code text.[place + i] else 0 in
  let first = byte 0 and second = byte 1 in
  if first < 0x80 then if first >= 0x20 && first <> 0x7f then 1 else 0
  else
    let size = if first >= 0xf0 then 4 else if first >= 0xe0 then 3 else 2 in
    let follows i = byte i >= 0x80 && byte i < 0xc0 in
    let control = first < 0xc2 || (first = 0xc2 && second < 0xa0) || first > 0xf4 in
    let direction = first = 0xe2 && (second = 0x80 || second = 0x81) in
    if control || direction || not (List.for_all follows (List.init (size - 1) succ)) then 0 else size

(* A name in which a byte that cannot be shown is \xHH: otherwise it could pass for other lines. *)
let printable text =
  let result = Buffer.create (String.length text) in
  let rec add place =
    if place < String.length text then begin
      let size = shown_character text place in
      if size = 0 then Printf.bprintf result "\\x%02x" (Char.code text.[place])
      else Buffer.add_string result (String.sub text place size);
      add (place + max size 1)
    end
  in
  add 0;
  Buffer.contents result

(* Each verdict, the summary's word if it is the worst, and the exit code then; the worst first. *)
let worst = [ ("rejected", "REJECTED", 5); ("unreadable", "UNREADABLE", 3); ("missing", "MISSING", 3);
              ("undecided", "UNDECIDED", 4); ("accepted", "ACCEPTED", 0) ]

let check paths =
  let found = List.concat_map (fun path -> List.map (fun path -> (verdict path, path)) (certificates path)) paths in
  List.iter (fun (verdict, path) -> Printf.printf "%s %s\n" verdict (printable path)) found;
  let count verdict = List.length (List.filter (fun (other, _) -> other = verdict) found) in
  let _, word, code = List.find (fun (verdict, _, _) -> count verdict > 0) worst in
  Printf.printf "s %s %d accepted, %d rejected, %d missing, %d undecided, %d unreadable\n" word (count "accepted")
    (count "rejected") (count "missing") (count "undecided") (count "unreadable");
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

let run = function
  | [ "--compare"; record ] -> compare_with record
  | first :: _ as paths when not (String.starts_with ~prefix:"-" first) -> check paths
  | _ -> prerr_string usage; 2

let say message = prerr_endline ("slipproof-check-verified: " ^ message)

let () =
  let code = try run (List.tl (Array.to_list Sys.argv)) with
    | Sys_error message -> say message; 6
    | failure -> say (Printexc.to_string failure); 70
  in
  match flush stdout with
  | () -> exit code
  | exception Sys_error _ ->
      say "standard output cannot be written";
      (* Of what could not be written nothing is left to try again at exit. *)
      Unix._exit 6
