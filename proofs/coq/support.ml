(* What the programs of this folder share: a bound on memory; files of others, their bytes and names, and what cannot be
   read. *)

exception Too_much

(* The result of some work; nothing if it allocates too many samples of a million words in all, or holds too many words. *)
let bounded_by ~most_samples ~most_held work =
  let samples = ref 0 in
  let count _ =
    incr samples;
    if !samples > most_samples || (Gc.quick_stat ()).heap_words > most_held then raise Too_much;
    None
  in
  Gc.Memprof.start ~sampling_rate:1e-6 ~callstack_size:0
    { Gc.Memprof.null_tracker with alloc_minor = count; alloc_major = count };
  match Fun.protect ~finally:Gc.Memprof.stop work with
  | result -> Some result
  | exception (Stack_overflow | Too_much | Out_of_memory | Z.Overflow) -> Gc.compact (); None

(* A check of a certificate may allocate 8 GB in all and hold 1 GB; beyond that it is rejected. The largest shipped proof
   allocates 0.4 GB. *)
let bounded work = Option.join (bounded_by ~most_samples:1_024 ~most_held:(1 lsl 27) work)

let explode text = List.init (String.length text) (String.get text)
let implode letters = String.of_seq (List.to_seq letters)

type file = Text of string | Too_long | No_text

(* Opens regular files only: others may have no end, or wait for a writer. *)
let load_file path most =
  let read file =
    let text = Buffer.create 4096 in
    (try
       while Buffer.length text <= most do
         Buffer.add_channel text file (min 65536 (most + 1 - Buffer.length text))
       done
     with End_of_file -> ());
    if Buffer.length text > most then Too_long else Text (Buffer.contents text)
  in
  try
    if (Unix.stat path).st_kind <> Unix.S_REG then No_text
    else
      let file = open_in_bin path in
      Fun.protect ~finally:(fun () -> close_in_noerr file) (fun () -> read file)
  with Unix.Unix_error _ | Sys_error _ -> No_text

let is_folder path = try Sys.is_directory path with Sys_error _ -> false
let kind path = try Some (Unix.lstat path).st_kind with Unix.Unix_error _ -> None

let is_below path root =
  try
    let root = Unix.realpath root and path = Unix.realpath path in
    path = root || root = "/" || String.starts_with ~prefix:(root ^ "/") path
  with Unix.Unix_error _ -> false

(* Theorem files (proofs/FORMAT.md). A part of FILE.theorems is called NAME.statement, NAME.cert or claims.canonical, and
   has the path FILE.theorems/PART. *)
exception Malformed

let theorem_name line =
  let is_letter_or_digit c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') in
  let is_in_name c = is_letter_or_digit c || List.mem c [ '_'; '\''; '.'; '-' ] in
  if not (String.starts_with ~prefix:"theorem " line) then raise Malformed;
  let name = String.sub line 8 (String.length line - 8) in
  let size = String.length name in
  if size = 0 || size > 100 || (not (is_letter_or_digit name.[0])) || not (String.for_all is_in_name name) then raise Malformed;
  name

(* The parts by name; raises Malformed. *)
let split text =
  let parts = Hashtbl.create 64 and size = String.length text in
  let line_end start = Option.value (String.index_from_opt text start '\n') ~default:size in
  let line start = String.sub text start (line_end start - start) in
  let theorem = ref "" and present = ref None in
  let finish stop =
    let add (part, start) =
      if Hashtbl.mem parts part then raise Malformed;
      Hashtbl.add parts part (String.sub text start (stop - start))
    in
    Option.iter add !present
  in
  let begin_part part start = finish start; present := Some (part, start) in
  let rec read start =
    if start < size then begin
      let next = min size (line_end start + 1) in
      (match line start with
      | "slipproof-claims 1" -> if start > 0 then raise Malformed else begin_part "claims.canonical" start
      | "slipproof-statement 1" -> theorem := theorem_name (line next); begin_part (!theorem ^ ".statement") start
      | "slipproof-certificate 1" | "slipproof-undecided 1" ->
          if !theorem = "" then raise Malformed else begin_part (!theorem ^ ".cert") start
      | _ -> if !present = None then raise Malformed);
      read next
    end
  in
  read 0;
  finish size;
  if !present = None then raise Malformed;
  parts

let most_of_theorems = 1 lsl 28 (* bytes *)
let is_theorem_file path =
  Filename.check_suffix path ".theorems" && Filename.basename path <> ".theorems" && not (is_folder path)

let last_file = ref ("", None)

(* Of a theorem file that cannot be read or split none. *)
let parts_of file =
  let read () =
    match load_file file most_of_theorems with
    | Text text -> ( try Some (split text) with Malformed -> None)
    | Too_long | No_text -> None
  in
  if fst !last_file <> file then last_file := (file, read ());
  snd !last_file

(* The paths of those parts whose names end so. *)
let parts_ending file ending =
  let add part _ found = if Filename.check_suffix part ending then Filename.concat file part :: found else found in
  match parts_of file with None -> [] | Some parts -> List.sort compare (Hashtbl.fold add parts [])

let part path = Option.bind (parts_of (Filename.dirname path)) (fun parts -> Hashtbl.find_opt parts (Filename.basename path))

(* A file, or a part of a theorem file. *)
let load path most =
  if not (is_theorem_file (Filename.dirname path)) then load_file path most
  else match part path with None -> No_text | Some text -> if String.length text > most then Too_long else Text text

let is_missing path =
  if is_theorem_file (Filename.dirname path) then part path = None
  else match Unix.lstat path with exception Unix.Unix_error (Unix.ENOENT, _, _) -> true | exception Unix.Unix_error _ -> false | _ -> false

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

(* Runs a program on its arguments and ends with its exit code. *)
let run_program name run =
  let say message = prerr_endline (name ^ ": " ^ message) in
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
