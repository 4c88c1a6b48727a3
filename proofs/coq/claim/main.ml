(* slipproof-judge-verified FOLDER...: judges the claims of papers, from files `claims.canonical` in these folders and
   below, with the statements and certificates beside each; writes a line for each certificate and each claim. Exit
   codes: 0 if each claim is proved or refuted and each certificate accepted, 5 if a certificate is rejected, otherwise 3
   if a file cannot be read, 4 if a claim is open; 2 for wrong usage, 6 if the result cannot be written. *)
open Support

let usage = "usage: slipproof-judge-verified FOLDER...\n"
let most_of_statement = 1_048_576
let most_of_certificate = 50_000_000
let most_of_claims = 16_777_216

(* The regular files in a folder and below, by name; folders that are links are not followed. *)
let rec files folder =
  match Sys.readdir folder with
  | exception Sys_error _ -> []
  | names ->
      Array.sort compare names;
      List.concat_map
        (fun name ->
          let path = Filename.concat folder name in
          match kind path with Some Unix.S_DIR -> files path | Some Unix.S_REG -> [ path ] | _ -> [])
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
          Some (explode statement, explode certificate)
      | _ -> None)
    checked

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
                let texts = texts_of name folder checked in
                let verdict = bounded (fun () -> Some (Judge.judge is_stated file claim texts)) in
                let word = match verdict with Some Judge.Proved -> "proved" | Some Judge.Refuted -> "refuted" | _ -> "open" in
                say word (Filename.concat folder name))
              file.claims)

let judge folder =
  let all = files folder in
  let ending suffix = List.filter (fun path -> Filename.check_suffix path suffix) all in
  let checked = List.map check (ending ".statement") in
  List.iter (fun (_, certificate, _, verdict) -> say verdict certificate) checked;
  let claims = ending "claims.canonical" in
  if claims = [] then say "unreadable" folder;
  List.iter (judge_claims checked) claims

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

let () =
  let code =
    match List.tl (Array.to_list Sys.argv) with
    | first :: _ as folders when not (String.starts_with ~prefix:"-" first) -> List.iter judge folders; summary ()
    | _ -> prerr_string usage; 2
  in
  match flush stdout with
  | () -> exit code
  | exception Sys_error _ ->
      prerr_endline "slipproof-judge-verified: standard output cannot be written";
      Unix._exit 6
