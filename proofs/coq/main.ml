(* slipproof-check-verified CERT|STATEMENT|THEOREMS|FOLDER...: the extracted checker on files, which it finds and names as
   slipproof-check does. Exit codes: 0 if all certificates are accepted, 5 if one is rejected, otherwise 3 if one is
   missing or cannot be read, 4 if the search for one ended without; 2 for wrong usage, 6 if the result cannot be written.
   slipproof-check-verified --compare RECORD: on what the tests of slipproof-check recorded, `VERDICT S C`, then S bytes
   of a statement and C of a certificate, again and again; 5 if a verdict differs. *)

open Support

let usage = "usage: slipproof-check-verified CERT|STATEMENT|THEOREMS|FOLDER...\n       slipproof-check-verified --compare RECORD\n"

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
      | Some _ when is_missing path -> "missing"
      | Some read -> (
          match load path most_of_certificate with
          | Text certificate -> judge_certificate read certificate
          | Too_long -> "rejected"
          | No_text -> "unreadable"))

module Paths = Set.Make (struct
  type t = string

  let compare a b = compare (String.split_on_char '/' a) (String.split_on_char '/' b)
end)

(* Of a theorem file that cannot be split the file, which `verdict` calls unreadable. *)
let certificates_of_file path =
  match parts_ending path ".statement" with
  | [] -> [ path ]
  | statements -> List.map (fun statement -> with_extension statement ".cert") statements

(* The certificates of all statements in a folder and below, and those without a statement; and what `verdict` then
   calls unreadable: what cannot be looked at, folders that cannot be listed, and links to folders elsewhere, which are
   not followed. *)
let rec find root folder found =
  let add found name =
    let path = Filename.concat folder name in
    let kind = kind path in
    if kind = Some Unix.S_DIR then find root path found
    else if is_theorem_file path then List.fold_left (fun found path -> Paths.add path found) found (certificates_of_file path)
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
  else if is_theorem_file path then certificates_of_file path
  else if extension path = ".statement" then [ with_extension path ".cert" ]
  else [ path ]

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

let () = run_program "slipproof-check-verified" run
