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

let is_folder path = try Sys.is_directory path with Sys_error _ -> false
let kind path = try Some (Unix.lstat path).st_kind with Unix.Unix_error _ -> None

let is_below path root =
  try
    let root = Unix.realpath root and path = Unix.realpath path in
    path = root || root = "/" || String.starts_with ~prefix:(root ^ "/") path
  with Unix.Unix_error _ -> false

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
