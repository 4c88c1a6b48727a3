(* slipproof-judge-verified --at POINTS CLAIMS: what the claims of a canonical file are worth at points, which are lines
   `CLAIM NAME=VALUE ...` with rational values: right, wrong, nothing, no-value, no-point, or unknown.
   slipproof-judge-verified FOLDER...: judges the claims of papers, from theorem files in these folders and below, or files
   `claims.canonical` with the statements and certificates beside each; writes a line for each certificate and each claim. Exit
   codes: 0 if each claim is proved or refuted and each certificate accepted, 5 if a certificate is rejected, otherwise 3
   if a file cannot be read, 4 if a claim is open; 2 for wrong usage, 6 if the result cannot be written. *)
open Support

let usage = "usage: slipproof-judge-verified FOLDER...\n       slipproof-judge-verified --at POINTS CLAIMS\n"
let most_of_statement = 1_048_576
let most_of_certificate = 50_000_000
let most_of_claims = 16_777_216

(* The parts of a theorem file; the file itself if it has none. *)
let parts file = match parts_ending file "" with [] -> [ file ] | parts -> parts

(* The regular files in a folder and below, and the parts of theorem files, by name; folders that are links are not
   followed. *)
let rec files folder =
  match Sys.readdir folder with
  | exception Sys_error _ when is_theorem_file folder -> parts folder
  | exception Sys_error _ -> []
  | names ->
      Array.sort compare names;
      List.concat_map
        (fun name ->
          let path = Filename.concat folder name in
          match kind path with Some Unix.S_DIR -> files path | Some Unix.S_REG -> if is_theorem_file path then parts path else [ path ] | _ -> [])
        (Array.to_list names)

let text path most = match load path most with Text text -> Some text | _ -> None

(* A statement and its certificate, and what the checker says. *)
let check statement_path =
  let certificate_path = Filename.chop_suffix statement_path ".statement" ^ ".cert" in
  let texts = (text statement_path most_of_statement, text certificate_path most_of_certificate) in
  let verdict =
    match texts with
    | None, _ -> "unreadable"
    | _, None -> "missing"
    | Some statement, Some certificate -> (
        match bounded (fun () -> Judge.read_statement (explode statement)) with
        | None -> "unreadable"
        | Some read ->
            let certificate = explode certificate in
            if bounded (fun () -> Some (Judge.accepts_for read certificate)) = Some true then "accepted"
            else if bounded (fun () -> Some (Judge.is_undecided read certificate)) = Some true then "undecided"
            else "rejected")
  in
  (statement_path, certificate_path, texts, verdict)

let verdicts = Hashtbl.create 16
let say verdict path =
  Hashtbl.replace verdicts verdict (1 + Option.value (Hashtbl.find_opt verdicts verdict) ~default:0);
  Printf.printf "%s %s\n" verdict (printable path)

let rational text =
  let integer digits = try Big_int_Z.big_int_of_string digits with Invalid_argument _ -> failwith ("no number: " ^ text) in
  match String.index_opt text '/' with
  | None -> { Judge.qnum = integer text; qden = Big_int_Z.unit_big_int }
  | Some i ->
      let divisor = integer (String.sub text (i + 1) (String.length text - i - 1)) in
      if Big_int_Z.sign_big_int divisor <= 0 then failwith "a divisor that is not positive";
      { Judge.qnum = integer (String.sub text 0 i); qden = divisor }

(* The numbers that a statement or a certificate gives to names: a point at which the claim may be wrong. *)
let point_of text =
  List.filter_map
    (fun line ->
      match String.split_on_char ' ' line with
      | [ ("let" | "set"); name; "="; number ] -> ( try Some (explode name, rational number) with Failure _ -> None)
      | _ -> None)
    (String.split_on_char '\n' text)

(* The texts that the checker accepts of the statements whose names begin with that of the claim. *)
let texts_of name folder checked =
  let is_its path =
    Filename.dirname path = folder
    &&
    let statement = Filename.chop_suffix (Filename.basename path) ".statement" in
    statement = name || String.starts_with ~prefix:(name ^ ".") statement
  in
  List.filter_map
    (function
      | path, _, (Some statement, Some certificate), "accepted" when is_its path ->
          Some (statement, certificate)
      | _ -> None)
    checked

(* A claim with fifty certificates takes as long as all of them. *)
let bounded_for_claim work = Option.join (bounded_by ~most_samples:8_192 ~most_held:(1 lsl 27) work)

let judge_claims checked path =
  let folder = Filename.dirname path in
  match text path most_of_claims with
  | None -> say "unreadable" path
  | Some claims -> (
      match Canonical.file claims with
      | exception (Canonical.Unreadable _ | Failure _ | Stack_overflow) -> say "unreadable" path
      | file ->
          let is_stated = bounded (fun () -> Some (Judge.stated (explode claims) file)) = Some true in
          if not is_stated then say "unreadable" path
          else
            List.iter
              (fun (claim : Judge.named_claim) ->
                let name = String.concat "" (List.map implode claim.name_of) in
                let its = texts_of name folder checked in
                let texts = List.map (fun (statement, certificate) -> (explode statement, explode certificate)) its in
                let points = List.concat_map (fun (statement, certificate) -> [ point_of statement; point_of certificate ]) its in
                let verdict = bounded_for_claim (fun () -> Some (Judge.judge is_stated file claim texts points)) in
                let word = match verdict with Some Judge.Proved -> "proved" | Some Judge.Refuted -> "refuted" | _ -> "open" in
                say word (Filename.concat folder name))
              file.claims)

let judge folder =
  let all = files folder in
  let ending suffix = List.filter (fun path -> Filename.check_suffix path suffix) all in
  let checked = List.map check (ending ".statement") in
  List.iter (fun (_, certificate, _, verdict) -> say verdict certificate) checked;
  List.iter (say "unreadable") (List.filter is_theorem_file all);
  let claims = ending "claims.canonical" in
  if claims = [] then say "unreadable" folder;
  List.iter (judge_claims checked) claims

(* Claims at points. *)

let assignment word =
  match String.index_opt word '=' with
  | Some i -> (explode (String.sub word 0 i), rational (String.sub word (i + 1) (String.length word - i - 1)))
  | None -> failwith ("expected NAME=VALUE, found " ^ word)

let worth claim point =
  match bounded (fun () -> Judge.run claim point) with
  | Some Judge.Right -> "right"
  | Some Judge.Wrong -> "wrong"
  | Some Judge.SaysNothing -> "nothing"
  | Some Judge.NoValue -> "no-value"
  | None -> if Judge.no_point claim point then "no-point" else "unknown"

let at_points points claims =
  match (text points most_of_claims, text claims most_of_claims) with
  | Some points, Some claims ->
      let file = Canonical.file claims in
      if not (Judge.stated (explode claims) file) then failwith "the claims were not read as they are written";
      let claim_called name =
        match List.find_opt (fun (n : Judge.named_claim) -> String.concat "" (List.map implode n.name_of) = name) file.claims with
        | Some named -> Option.get (Judge.claim_of file named)
        | None -> failwith ("found no claim " ^ name)
      in
      let known = Hashtbl.create 64 in
      let find name =
        match Hashtbl.find_opt known name with
        | Some claim -> claim
        | None -> let claim = claim_called name in Hashtbl.replace known name claim; claim
      in
      List.iter
        (fun line ->
          match List.filter (( <> ) "") (String.split_on_char ' ' line) with
          | name :: values -> print_endline (worth (find name) (List.map assignment values))
          | [] -> ())
        (String.split_on_char '\n' points);
      0
  | _ -> failwith "a file cannot be read"

let summary () =
  let count verdict = Option.value (Hashtbl.find_opt verdicts verdict) ~default:0 in
  let word, code =
    if count "rejected" > 0 then ("REJECTED", 5)
    else if count "unreadable" + count "missing" > 0 then ("UNREADABLE", 3)
    else if count "open" + count "undecided" > 0 then ("OPEN", 4)
    else ("JUDGED", 0)
  in
  Printf.printf "s %s %d proved, %d refuted, %d open; %d certificates accepted, %d not\n" word (count "proved")
    (count "refuted") (count "open") (count "accepted")
    (count "rejected" + count "missing" + count "undecided" + count "unreadable");
  code

let run = function
  | [ "--at"; points; claims ] -> (
      try at_points points claims
      with Failure found | Canonical.Unreadable found -> prerr_endline ("slipproof-judge-verified: " ^ found); 3)
  | first :: _ as folders when not (String.starts_with ~prefix:"-" first) -> List.iter judge folders; summary ()
  | _ -> prerr_string usage; 2

let () = run_program "slipproof-judge-verified" run
