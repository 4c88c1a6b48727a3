(* Reads what Canonical.v prints. Nothing rests on it: what it reads is printed again, and compared with the text. *)
open Judge
open Support

exception Unreadable of string

let unreadable found = raise (Unreadable found)
let rec nat n = if n = 0 then O else S (nat (n - 1))

(* Terms and conditions: tokens to a tree and the tokens after it. *)

let is_name token = match token.[0] with 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false
let is_number token = match token.[0] with '0' .. '9' -> true | _ -> false
let number token = Big_int_Z.big_int_of_string token

let expect token = function
  | first :: rest when first = token -> rest
  | rest -> unreadable ("expected " ^ token ^ String.concat " " (" in" :: rest))

let rec sum tokens =
  let rec more a = function
    | "+" :: rest -> let b, rest = product rest in more (Plus0 (a, b)) rest
    | "-" :: rest -> let b, rest = product rest in more (Difference (a, b)) rest
    | rest -> (a, rest)
  in
  let a, rest = product tokens in
  more a rest

and product tokens =
  let rec more a = function
    | "*" :: rest -> let b, rest = signed rest in more (Product (a, b)) rest
    | "/" :: rest -> let b, rest = signed rest in more (Quotient (a, b)) rest
    | rest -> (a, rest)
  in
  let a, rest = signed tokens in
  more a rest

and signed = function
  | "-" :: rest -> let a, rest = signed rest in (Minus a, rest)
  | tokens -> (
      match primary tokens with
      | a, "^" :: "-" :: k :: rest -> (Power (a, Big_int_Z.minus_big_int (number k)), rest)
      | a, "^" :: k :: rest -> (Power (a, number k), rest)
      | read -> read)

and primary = function
  | "(" :: rest -> let a, rest = sum rest in (a, expect ")" rest)
  | "abs" :: "(" :: rest -> let a, rest = sum rest in (Absolute a, expect ")" rest)
  | "sign" :: "(" :: rest -> let a, rest = sum rest in (Signum a, expect ")" rest)
  | "min" :: "(" :: rest -> two (fun a b -> Minimum (a, b)) rest
  | "max" :: "(" :: rest -> two (fun a b -> Maximum (a, b)) rest
  | token :: rest when is_number token -> (Number (number token), rest)
  | token :: rest when is_name token -> (Symbol (explode token), rest)
  | rest -> unreadable (String.concat " " ("expected a number in" :: rest))

and two make rest =
  let a, rest = sum rest in
  let b, rest = sum (expect "," rest) in
  (make a b, expect ")" rest)

let relation = function
  | "<" -> Some Lt0 | "<=" -> Some Le | "=" -> Some Eq0 | "!=" -> Some Ne | ">=" -> Some Ge | ">" -> Some Gt0 | _ -> None

let rec links = function
  | token :: rest when relation token <> None ->
      let b, rest = sum rest in
      let more, rest = links rest in
      ((Option.get (relation token), b) :: more, rest)
  | rest -> ([], rest)

let rec disjunction tokens =
  let rec more a = function
    | "or" :: rest -> let b, rest = conjunction rest in more (Either (a, b)) rest
    | rest -> (a, rest)
  in
  let a, rest = conjunction tokens in
  more a rest

and conjunction tokens =
  let rec more a = function
    | "and" :: rest -> let b, rest = negation rest in more (Both (a, b)) rest
    | rest -> (a, rest)
  in
  let a, rest = negation tokens in
  more a rest

and negation = function
  | "not" :: rest -> let a, rest = negation rest in (Not a, rest)
  | "true" :: rest -> (Constant true, rest)
  | "false" :: rest -> (Constant false, rest)
  | tokens -> (
      (* A parenthesis may hold a term or a condition. *)
      match comparison tokens with
      | read -> read
      | exception Unreadable why -> (
          match tokens with
          | "(" :: rest -> let a, rest = disjunction rest in (a, expect ")" rest)
          | _ -> unreadable why))

and comparison tokens =
  let a, rest = sum tokens in
  match links rest with
  | [], _ -> unreadable (String.concat " " ("expected a comparison in" :: tokens))
  | more, rest -> (Compare (a, more), rest)

let whole read tokens =
  match read tokens with
  | value, [] -> value
  | _, rest -> unreadable (String.concat " " ("expected the end of the line at" :: rest))

let condition tokens = whole disjunction tokens
let term tokens = whole sum tokens

(* Lines *)

(* Takes lines from the front as long as they are of a kind. *)
let rec many read lines =
  match lines with
  | line :: rest -> (
      match read line with
      | Some one -> let more, rest = many read rest in (one :: more, rest)
      | None -> ([], lines))
  | [] -> ([], [])

let optional read = function
  | line :: rest as lines -> ( match read line with Some one -> (Some one, rest) | None -> (None, lines))
  | [] -> (None, [])

let needed what read lines =
  match optional read lines with
  | Some one, rest -> (one, rest)
  | None, line :: _ -> unreadable ("expected " ^ what ^ " at " ^ String.concat " " line)
  | None, [] -> unreadable ("expected " ^ what)

let domain word = function
  | first :: name :: ":" :: rest when first = word -> Some (explode name, condition rest)
  | _ -> None

let angle = function "angle" :: c :: s :: ":" :: rest -> Some ((explode c, explode s), condition rest) | _ -> None
let value word = function
  | first :: name :: "=" :: rest when first = word -> Some (explode name, term rest)
  | _ -> None

let plain word = function first :: "=" :: rest when first = word -> Some (term rest) | _ -> None
let name word = function [ first; name ] when first = word -> Some (explode name) | _ -> None
let names word = function first :: rest when first = word -> Some (List.map explode rest) | _ -> None
let assumption = function "assume" :: ":" :: rest -> Some (condition rest) | _ -> None

let start = function
  | "rest" :: rest -> (Rest, rest)
  | "slides" :: "+" :: rest -> (SlidesForward, rest)
  | "slides" :: "-" :: rest -> (SlidesBackward, rest)
  | "open" :: rest -> (Apart, rest)
  | rest -> unreadable (String.concat " " ("expected a state in" :: rest))

let rec split_at token seen = function
  | first :: rest when first = token -> Some (List.rev seen, rest)
  | first :: rest -> split_at token (first :: seen) rest
  | [] -> None

(* A name of several tokens, up to a colon. *)
let named tokens =
  match split_at ":" [] tokens with
  | Some (name, rest) -> (explode (String.concat "" name), rest)
  | None -> unreadable "expected a colon after a name"

let equation = function
  | "equation" :: rest -> (
      let name, rest = named rest in
      match split_at "=" [] rest with
      | Some (left, right) -> Some ((name, term left), term right)
      | None -> unreadable "expected = in an equation")
  | _ -> None

let contact = function
  | ("contact" :: first) :: lines ->
      let begins, first = start first in
      let bilateral, first = match first with "bilateral" :: rest -> (true, rest) | rest -> (false, rest) in
      let needs, name_ = match split_at ":" [] first with Some read -> read | None -> unreadable "expected a name" in
      let lift_needs = match needs with "needs" :: rest -> List.map explode rest | _ -> [] in
      let (gap_name, gap), lines = needed "gap" (value "gap") lines in
      let slip, lines = optional (value "slip") lines in
      let normal0, lines = needed "normal" (name "normal") lines in
      let tangent, lines = optional (name "tangent") lines in
      let friction, lines =
        if tangent = None then (None, lines)
        else
          let at_rest, lines = needed "static" (plain "static") lines in
          let sliding, lines = needed "kinetic" (plain "kinetic") lines in
          (Some (at_rest, sliding), lines)
      in
      Some
        ( { contact_name = explode (String.concat "" name_); gap_name; gap; begins; bilateral; lift_needs; normal0; friction;
            slip_name = (match slip with Some (name, _) -> name | None -> []); slip = Option.map snd slip;
            tangent = Option.value tangent ~default:[] },
          lines )
  | _ -> None

let rubbing = function
  | ("friction" :: first) :: lines ->
      let rub_begins, first = start first in
      let holder, first = match first with "at" :: i :: rest -> (Some (nat (int_of_string i)), rest) | rest -> (None, rest) in
      let rubbing_name = match first with ":" :: name -> explode (String.concat "" name) | _ -> unreadable "expected a name" in
      let (rub_name, rub), lines = needed "slip" (value "slip") lines in
      let resistance, lines = needed "tangent" (name "tangent") lines in
      let static_limit, lines = needed "static" (plain "static") lines in
      let kinetic_limit, lines = needed "kinetic" (plain "kinetic") lines in
      Some ({ rubbing_name; rub_name; rub; static_limit; kinetic_limit; resistance; rub_begins; holder }, lines)
  | _ -> None

let rec blocks read lines =
  match read lines with Some (one, rest) -> let more, rest = blocks read rest in (one :: more, rest) | None -> ([], lines)

let link = function
  | "link" :: force :: rest ->
      let link_name, rest = named rest in
      Some { link_name; link_force = explode force; zero0 = term rest }
  | _ -> None

let mechanism lines =
  let parameters, lines = many (domain "parameter") lines in
  let angles, lines = many angle lines in
  let assumptions, lines = many assumption lines in
  let definitions, lines = many (value "let") lines in
  let load, lines = optional (domain "load") lines in
  let accelerations, lines = needed "accelerations" (names "accelerations") lines in
  let forces, lines = needed "forces" (names "forces") lines in
  let by_virtual_work, lines =
    needed "motion" (function [ "motion" ] -> Some true | [ "equations" ] -> Some false | _ -> None) lines
  in
  let equations, lines = many equation lines in
  let contacts, lines = blocks contact lines in
  let rubbings, lines = blocks rubbing lines in
  let links, lines = many link lines in
  ({ parameters; angles; assumptions; definitions; load; accelerations; forces; by_virtual_work; equations; contacts; rubbings; links }, lines)

let setting = function
  | [ "setting"; _; motions ] :: lines ->
      let paper_parameters, lines = many (domain "parameter") lines in
      let paper_angles, lines = many angle lines in
      let (force, force_domain), lines =
        needed "force"
          (function
            | "force" :: ":" :: rest -> Some ([], condition rest)
            | "force" :: name :: ":" :: rest -> Some (explode name, condition rest)
            | _ -> None)
          lines
      in
      let paper_definitions, lines = many (value "let") lines in
      let scene, lines = many (value "scene") lines in
      let (), lines = needed "mechanism" (function [ "mechanism" ] -> Some () | _ -> None) lines in
      let of_mechanism, lines = mechanism lines in
      Some ({ of_mechanism; paper_parameters; paper_angles; force; force_domain; paper_definitions; scene; strict = motions = "strict" }, lines)
  | _ -> None

let rec mode = function
  | [] -> []
  | tokens ->
      let state, rest =
        match tokens with
        | "stick" :: "~" :: rest -> (PulledStick, rest)
        | "stick" :: rest -> (Stick, rest)
        | "slip" :: "+" :: "~" :: rest -> (PulledForward, rest)
        | "slip" :: "-" :: "~" :: rest -> (PulledBackward, rest)
        | "slip" :: "+" :: rest -> (SlipForward, rest)
        | "slip" :: "-" :: rest -> (SlipBackward, rest)
        | "lift" :: rest -> (Lift, rest)
        | "touch" :: rest -> (Touch, rest)
        | "free" :: rest -> (Free, rest)
        | rest -> unreadable (String.concat " " ("expected a state in" :: rest))
      in
      state :: (match rest with "/" :: rest -> mode rest | [] -> [] | _ -> unreadable "expected / in a mode")

let mode_line = function "mode" :: rest -> Some (mode rest) | _ -> None
let put words tokens =
  let rec after words tokens =
    match (words, tokens) with
    | [], ":" :: rest -> Some (condition rest)
    | w :: words, t :: tokens when w = t -> after words tokens
    | _ -> None
  in
  after words tokens

let reference word = function
  | region :: forces :: rest -> (
      match (put [ word; "region" ] region, put [ word; "forces" ] forces) with
      | Some r, Some f -> Some ((r, f), rest)
      | _ -> None)
  | _ -> None

let model lines =
  let of_model, lines = optional (function [ "of"; "the"; "model" ] -> Some () | _ -> None) lines in
  let m, lines = if of_model = None then (None, lines) else optional mode_line lines in
  (Option.map (fun () -> m) of_model, lines)

let interval = function
  | ("one" :: "mode" :: m) :: rest -> Option.map (fun (r, rest) -> ((mode m, r), rest)) (reference "one" rest)
  | _ -> None

let kind = function
  | [ "interval" ] :: lines -> let m, lines = needed "mode" mode_line lines in (Interval m, lines)
  | [ "impossible" ] :: lines -> let ms, lines = many mode_line lines in (Impossible ms, lines)
  | [ "motions" ] :: lines -> let ms, lines = many mode_line lines in (Motions ms, lines)
  | [ "exists" ] :: lines -> let ms, lines = many mode_line lines in (Exists ms, lines)
  | [ "formula" ] :: lines ->
      let ms, lines = many mode_line lines in
      let holds, lines = needed "holds" (put [ "holds" ]) lines in
      (Formula (ms, holds), lines)
  | [ "equivalence" ] :: lines -> let holds, lines = needed "holds" (put [ "holds" ]) lines in (Equivalence holds, lines)
  | [ "cover" ] :: lines -> let rs, lines = blocks (reference "one") lines in (Cover rs, lines)
  | [ "consequence" ] :: lines ->
      let model, lines = model lines in
      let hypotheses, lines = many (put [ "given" ]) lines in
      let equations, lines = many (put [ "follows" ]) lines in
      (Consequence (model, hypotheses, equations), lines)
  | [ "system" ] :: lines ->
      let model, lines = model lines in
      let given, lines = many (put [ "given" ]) lines in
      let hypotheses, lines = many (put [ "from" ]) lines in
      let equations, lines = many (put [ "follows" ]) lines in
      (System (model, given, hypotheses, equations), lines)
  | [ "unique" ] :: lines ->
      let claims, lines = blocks interval lines in
      let except, lines = blocks (reference "except") lines in
      let ms, lines = many mode_line lines in
      (Unique (claims, except, ms), lines)
  | [ "limit"; parameter ] :: lines ->
      let holds, lines = needed "holds" (put [ "holds" ]) lines in
      let from, lines = optional (plain "from") lines in
      (Limit (explode parameter, holds, from), lines)
  | [ "force"; "-"; "cover" ] :: lines -> let rs, lines = blocks (reference "one") lines in (ForceCover rs, lines)
  | line :: _ -> unreadable ("expected a kind at " ^ String.concat " " line)
  | [] -> unreadable "expected a kind"

let claim = function
  | ("claim" :: rest) :: lines -> (
      match List.rev rest with
      | i :: "in" :: name ->
          let kind_of_it, lines = kind lines in
          let its_region, lines = needed "region" (put [ "region" ]) lines in
          let its_forces, lines = needed "forces" (put [ "forces" ]) lines in
          Some ({ name_of = List.rev_map explode name; setting_number = nat (int_of_string i); kind_of_it; its_region; its_forces }, lines)
      | _ -> unreadable "expected in SETTING after the name of a claim")
  | _ -> None

let file text =
  match Judge.lines (explode text) with
  | None | Some [] -> unreadable "expected lines of printable ASCII"
  | Some (_ :: body) -> (
      let lines = List.map (fun line -> List.map implode line.words) body in
      let settings, lines = blocks setting lines in
      match blocks claim lines with
      | claims, [] -> { settings; claims }
      | _, line :: _ -> unreadable ("expected a claim at " ^ String.concat " " line))
