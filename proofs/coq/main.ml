(* slipproof-check-verified CERT|FOLDER...: the extracted checker on files. Exit codes: 0 if all certificates are
   accepted, 5 if one is rejected, 3 if one cannot be read, 2 for wrong usage. *)

let usage = "usage: slipproof-check-verified CERT|FOLDER...\n"

let content path =
  let file = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in file) (fun () -> really_input_string file (in_channel_length file))

let explode text = List.init (String.length text) (String.get text)

let rec certificates path =
  if Sys.is_directory path then
    let entries = Sys.readdir path in
    Array.sort compare entries;
    List.concat_map
      (fun entry ->
        let below = Filename.concat path entry in
        if Sys.is_directory below || Filename.check_suffix below ".cert" then certificates below else [])
      (Array.to_list entries)
  else [ path ]

let verdict certificate =
  let statement = Filename.remove_extension certificate ^ ".statement" in
  match (content statement, content certificate) with
  | exception Sys_error message -> `Unreadable message
  | statement, certificate -> (
      match Checker.accepts (explode statement) (explode certificate) with
      | true -> `Accepted
      | false -> `Rejected
      | exception Stack_overflow -> `Rejected)

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [] -> prerr_string usage; exit 2
  | first :: _ when String.length first > 0 && first.[0] = '-' -> prerr_string usage; exit 2
  | paths ->
      let accepted = ref 0 and rejected = ref 0 and unreadable = ref 0 in
      let judge path =
        match verdict path with
        | `Accepted -> incr accepted; Printf.printf "accepted %s\n" path
        | `Rejected -> incr rejected; Printf.printf "rejected %s\n" path
        | `Unreadable message -> incr unreadable; Printf.printf "unreadable %s\n" message
      in
      List.iter (fun path -> List.iter judge (certificates path)) paths;
      Printf.printf "s %s %d accepted, %d rejected, %d unreadable\n"
        (if !rejected + !unreadable = 0 then "ACCEPTED" else "REJECTED")
        !accepted !rejected !unreadable;
      exit (if !rejected > 0 then 5 else if !unreadable > 0 then 3 else 0)
