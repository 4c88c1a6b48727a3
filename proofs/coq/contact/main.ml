(* slipproof-check-contact-verified [--problem NAME] FILE...: the extracted checker of contact certificates on files, with
   the words of slipproof-check-contact; `-` is standard input. What it does not cover it calls so, and does not accept.
   Exit codes: 0 if all are accepted, 5 if one is rejected, otherwise 3 if one is missing or cannot be read, 4 if one is
   not covered; 2 for wrong usage, 6 if the result cannot be written.
   slipproof-check-contact-verified --compare RECORD: on what the tests of slipproof-check-contact recorded, `VERDICT SIZE`
   and so many bytes, again and again; 5 if a verdict differs that is not `not covered`. *)

module Integer = Z
module Rational = Q
open Contact_checker
open Support

let usage =
  "usage: slipproof-check-contact-verified [--problem NAME] FILE...\n       slipproof-check-contact-verified --compare RECORD\n"

(* A check may allocate 64 GB in all and hold 2 GB; what needs more is not covered. *)
let bounded work = bounded_by ~most_samples:8_192 ~most_held:(1 lsl 28) work

(* The name of a problem: SHA-256, FIPS 180-4. *)
let primes count =
  let rec next found n =
    if List.length found = count then List.rev found
    else next (if List.exists (fun p -> n mod p = 0) found then found else n :: found) (n + 1)
  in
  next [] 2

let low x = x land 0xffffffff

(* Of a prime the first 32 bits behind the point of its root. *)
let bits_of_root degree prime =
  low (Integer.to_int (Integer.logand (Integer.root (Integer.shift_left (Integer.of_int prime) (32 * degree)) degree) (Integer.of_int 0xffffffff)))

let constants_of_rounds = Array.of_list (List.map (bits_of_root 3) (primes 64))

let sha256 text =
  let rotated x n = low ((x lsr n) lor (x lsl (32 - n))) in
  let size = String.length text in
  let padded = Bytes.make ((size + 72) / 64 * 64) '\000' in
  Bytes.blit_string text 0 padded 0 size;
  Bytes.set padded size '\x80';
  Bytes.set_int64_be padded (Bytes.length padded - 8) (Int64.of_int (8 * size));
  let state = Array.of_list (List.map (bits_of_root 2) (primes 8)) in
  let w = Array.make 64 0 in
  for block = 0 to (Bytes.length padded / 64) - 1 do
    for i = 0 to 15 do
      w.(i) <- low (Int32.to_int (Bytes.get_int32_be padded ((64 * block) + (4 * i))))
    done;
    for i = 16 to 63 do
      let x = w.(i - 15) and y = w.(i - 2) in
      w.(i) <- low (w.(i - 16) + w.(i - 7) + (rotated x 7 lxor rotated x 18 lxor (x lsr 3))
                    + (rotated y 17 lxor rotated y 19 lxor (y lsr 10)))
    done;
    let s = Array.copy state in
    for i = 0 to 63 do
      let e = rotated s.(4) 6 lxor rotated s.(4) 11 lxor rotated s.(4) 25 in
      let first = s.(7) + e + ((s.(4) land s.(5)) lxor (lnot s.(4) land s.(6))) + constants_of_rounds.(i) + w.(i) in
      let a = rotated s.(0) 2 lxor rotated s.(0) 13 lxor rotated s.(0) 22 in
      let second = a + ((s.(0) land s.(1)) lxor (s.(0) land s.(2)) lxor (s.(1) land s.(2))) in
      Array.blit s 0 s 1 7;
      s.(4) <- low (s.(4) + first);
      s.(0) <- low (first + second)
    done;
    Array.iteri (fun i x -> state.(i) <- low (state.(i) + x)) s
  done;
  String.concat "" (List.map (Printf.sprintf "%08x") (Array.to_list state))

let rational (x : number) = Rational.make x.num (Integer.mul (Integer.shift_left Integer.one (Integer.to_int x.twos)) x.den)

let canonical_text (i : instance) =
  let text = Buffer.create 4096 in
  let add word numbers =
    Buffer.add_string text word;
    List.iter (fun x -> Buffer.add_char text ' '; Buffer.add_string text (Rational.to_string (rational x))) numbers;
    Buffer.add_char text '\n'
  in
  Printf.bprintf text "slipproof-contact-problem 1\ndimension %s free %s contacts %d\n" (Integer.to_string i.dim)
    (Integer.to_string i.frees) (List.length i.frictions);
  add "mu" i.frictions;
  add "matrix" [];
  List.stable_sort (fun ((a, b), _) ((c, d), _) -> compare (Integer.to_int a, Integer.to_int b) (Integer.to_int c, Integer.to_int d)) i.entries
  |> List.iter (fun ((row, column), x) ->
         if Integer.sign x.num <> 0 then
           add (Integer.to_string row ^ " " ^ Integer.to_string column) [ x ]);
  add "constant" i.constants;
  Buffer.contents text

(* Of x >= 0 two digits, rounded up: `1.3e-12`. *)
let decimal number =
  let x = rational number in
  if Rational.sign x = 0 then "0"
  else begin
    let dividend = ref (Rational.num x) and divisor = ref (Rational.den x) and exponent = ref 1 in
    let ten = Integer.of_int 10 in
    while Integer.gt !dividend (Integer.mul (Integer.of_int 99) !divisor) do divisor := Integer.mul !divisor ten; incr exponent done;
    while Integer.leq !dividend (Integer.mul (Integer.of_int 9) !divisor) do dividend := Integer.mul !dividend ten; decr exponent done;
    let shown = Integer.to_string (Integer.cdiv !dividend !divisor) in
    Printf.sprintf "%c.%se%d" shown.[0] (String.sub shown 1 (String.length shown - 1)) !exponent
  end

(* What Different.v proves of accepted motions. *)
let motions_in_words about eliminated motions =
  let count = List.length motions in
  let different = are_different about eliminated motions and reach = greatest_reach about eliminated motions in
  let all = string_of_int count in
  if count = 0 then "no motion at all"
  else if Rational.sign (rational reach) > 0 then
    "at least " ^ (if count > 1 && different then all ^ " motions" else "one motion")
    ^ ", and every motion is within " ^ decimal reach ^ " of one of " ^ all
  else if count = 1 then "one motion and no other"
  else if different then all ^ " motions and no others"
  else "at least one motion and at most " ^ all

let claim_in_words about = function
  | Eps (bound, moved, _, _) ->
      "a solution of a problem whose constant differs by at most " ^ decimal bound ^ ", within " ^ decimal moved ^ " of the answer"
  | NoneWithin rho -> "no solution within " ^ decimal rho ^ " of the answer"
  | NoSolution _ -> "no solution"
  | Rest _ -> "it can rest"
  | NoRest _ -> "it cannot rest"
  | Enclosure (rho, eta, _, _, _, _, _, _) | Ball (rho, eta, _, _, _, _, _, _, _, _, _, _) -> (
      "a solution within " ^ decimal rho ^ " of the answer"
      ^ match eta with None -> "" | Some eta -> ", its velocities within " ^ decimal eta)
  | Dominant _ -> "one solution, whatever the constant, by a dominant matrix"
  | Definite _ -> "one solution, whatever the constant, by a definite matrix"
  | AllSolutions (eliminated, motions, _) -> motions_in_words about eliminated motions

let problem_in_words (i : instance) =
  Printf.sprintf "%d contacts in dimension %s%s" (List.length i.frictions) (Integer.to_string i.dim)
    (if Integer.sign i.frees > 0 then " and " ^ Integer.to_string i.frees ^ " free unknowns" else "")

let not_covered = ("not covered", "the theorem has no such claim or law, or the file is too large; slipproof-check-contact checks it")

(* A verdict, and what it says. *)
let judge_text asked text =
  let found () =
    match read (explode text) with
    | File (c, _) as file -> (
        let own = sha256 (canonical_text c.about) in
        let named = Option.map implode c.problem_name in
        match judge file with
        | _ when named <> None && named <> Some own -> ("rejected", "it names another problem, and has the numbers of " ^ own)
        | _ when asked <> "" && asked <> own -> ("rejected", "it is about another problem, " ^ own)
        | Accepted ->
            ( "accepted",
              String.concat "; " (List.map (claim_in_words c.about) c.claims)
              ^ ", " ^ problem_in_words c.about ^ ", "
              ^ (if named = None then "names no problem, has the numbers of " else "of the problem ")
              ^ own )
        | _ -> ("rejected", "a condition does not hold; slipproof-check-contact says which"))
    | NotCoveredFile -> not_covered
    | UnreadableFile -> ("unreadable", "it is no certificate; slipproof-check-contact says where")
  in
  match bounded found with Some verdict -> verdict | None -> not_covered

let most_of_file = 1 lsl 28 (* bytes, as in slipproof-check-contact *)

(* The certificates in a text, each with its first line: what is before the first belongs to it. *)
let certificates_in text =
  let size = String.length text in
  let rec split parts start line place number begun =
    if place >= size then List.rev ((line, String.sub text start (size - start)) :: parts)
    else
      let stop = Option.value (String.index_from_opt text place '\n') ~default:size in
      let is_header = String.sub text place (stop - place) = "slipproof-contact 1" in
      if is_header && begun then
        split ((line, String.sub text start (place - start)) :: parts) place number (stop + 1) (number + 1) true
      else split parts start line (stop + 1) (number + 1) (begun || is_header)
  in
  split [] 0 1 0 1 false

(* The verdicts on a text's certificates, with a line where there are several. *)
let judge_all asked text =
  match certificates_in text with
  | [ (_, text) ] -> [ ("", judge_text asked text) ]
  | several -> List.map (fun (line, text) -> (":" ^ string_of_int line, judge_text asked text)) several

let only verdict message = [ ("", (verdict, message)) ]

let judge_channel asked channel =
  let text = Buffer.create 65536 in
  (try
     while Buffer.length text <= most_of_file do
       Buffer.add_channel text channel 65536
     done
   with End_of_file -> ());
  if Buffer.length text > most_of_file then only "unreadable" "it has more than 268435456 bytes"
  else judge_all asked (Buffer.contents text)

(* Opens regular files only: others may have no end, or wait for a writer. *)
let judge_file asked path =
  if path = "-" then judge_channel asked stdin
  else
    match Unix.stat path with
    | exception Unix.Unix_error ((Unix.ENOENT | Unix.ENOTDIR), _, _) -> (
        match Unix.lstat path with
        | { st_kind = Unix.S_LNK; _ } -> only "unreadable" "it is a link to nothing"
        | _ | (exception Unix.Unix_error _) -> only "missing" "there is no such file")
    | exception Unix.Unix_error (error, _, _) -> only "unreadable" (Unix.error_message error)
    | { st_kind = Unix.S_REG; st_size; _ } when st_size > most_of_file -> only "unreadable" "it has more than 268435456 bytes"
    | { st_kind = Unix.S_REG; _ } -> (
        match open_in_bin path with
        | exception Sys_error _ -> only "unreadable" "the file cannot be opened"
        | channel ->
            Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () ->
                try judge_channel asked channel with Sys_error _ -> only "unreadable" "it cannot be read"))
    | _ -> only "unreadable" "it is not a regular file"

(* A name in which a byte that is not printable ASCII is \xHH: otherwise it could pass for other lines. *)
let printable text =
  let shown c = if c >= ' ' && c <= '~' then String.make 1 c else Printf.sprintf "\\x%02x" (Char.code c) in
  String.concat "" (List.map shown (explode text))

(* Each verdict, the summary's word if it is the worst, and the exit code then; the worst first. *)
let worst = [ ("rejected", "REJECTED", 5); ("unreadable", "UNREADABLE", 3); ("missing", "MISSING", 3);
              ("not covered", "NOT COVERED", 4); ("accepted", "ACCEPTED", 0) ]

let check asked paths =
  let show path =
    let show_one (place, (verdict, message)) =
      let name = if List.length paths > 1 || place <> "" then printable path ^ place ^ ": " else "" in
      Printf.printf "%s%s%s%s\n" name verdict (if verdict = "accepted" then "\n" ^ name else ": ") message;
      verdict
    in
    List.map show_one (judge_file asked path)
  in
  let found = List.concat_map show paths in
  let count verdict = List.length (List.filter (String.equal verdict) found) in
  let _, word, code = List.find (fun (verdict, _, _) -> count verdict > 0) worst in
  Printf.printf "s %s %d accepted, %d rejected, %d missing, 0 undecided, %d unreadable%s\n" word (count "accepted")
    (count "rejected") (count "missing") (count "unreadable")
    (match count "not covered" with 0 -> "" | beyond -> Printf.sprintf ", %d not covered" beyond);
  code

let compare_with record =
  let input = open_in_bin record in
  let all = ref 0 and accepted = ref 0 and beyond = ref 0 and different = ref 0 in
  let compare_one verdict size =
    let text = really_input_string input size in
    let found, _ = judge_text "" text in
    incr all;
    if found = "accepted" then incr accepted;
    if found = "not covered" then incr beyond
    else if found <> verdict then begin
      incr different;
      Printf.printf "slipproof-check-contact: %s; verified: %s\n%s\n" verdict found text
    end
  in
  (try
     while true do
       Scanf.sscanf (input_line input) "%s %d" compare_one
     done
   with End_of_file -> ());
  Printf.printf "s %s %d texts, %d accepted, %d not covered, %d judged differently\n"
    (if !different = 0 then "ALIKE" else "DIFFERENT")
    !all !accepted !beyond !different;
  if !different > 0 then 5 else 0

let is_name text =
  String.length text = 64 && List.for_all (fun c -> (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f')) (explode text)

let run = function
  | [ "--help" ] -> print_string usage; 0
  | [ "--compare"; record ] -> compare_with record
  | "--problem" :: name :: first :: rest when is_name name && (first = "-" || not (String.starts_with ~prefix:"-" first)) ->
      check name (first :: rest)
  | first :: _ as paths when first = "-" || not (String.starts_with ~prefix:"-" first) -> check "" paths
  | _ -> prerr_string usage; 2

let () = run_program "slipproof-check-contact-verified" run
