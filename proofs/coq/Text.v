(** Text: lines and tokens, names and numbers (FORMAT.md, "Text"). *)
From Coq Require Import Ascii String List Bool NArith ZArith.
Import ListNotations.
Local Open Scope string_scope.

(** [option] stands for all that may be refused. *)
Notation "'let*' x ':=' a 'in' b" := (match a with Some x => b | None => None end)
  (at level 200, x name, a at level 100, b at level 200, right associativity).
Notation "'require' a 'in' b" := (if a then b else None) (at level 200, a at level 100, b at level 200, right associativity).

(** Takes a hypothesis apart that something of this kind is not refused. *)
Ltac options H :=
  repeat match type of H with
         | (match ?a with Some _ => _ | None => None end) = Some _ => let E := fresh "E" in destruct a eqn:E; [|discriminate H]
         | (if ?b then _ else None) = Some _ => let E := fresh "E" in destruct b eqn:E; [|discriminate H]
         end.

Inductive kind := Letter | Digit | Joint | Blank | LineFeed | Sign | Unprintable.

Definition kind_of (c : ascii) : kind :=
  match c with
  | "a" | "b" | "c" | "d" | "e" | "f" | "g" | "h" | "i" | "j" | "k" | "l" | "m"
  | "n" | "o" | "p" | "q" | "r" | "s" | "t" | "u" | "v" | "w" | "x" | "y" | "z"
  | "A" | "B" | "C" | "D" | "E" | "F" | "G" | "H" | "I" | "J" | "K" | "L" | "M"
  | "N" | "O" | "P" | "Q" | "R" | "S" | "T" | "U" | "V" | "W" | "X" | "Y" | "Z" => Letter
  | "0" | "1" | "2" | "3" | "4" | "5" | "6" | "7" | "8" | "9" => Digit
  | "_" | "'" | "." => Joint
  | " " => Blank
  | "010" => LineFeed
  | "!" | """" | "#" | "$" | "%" | "&" | "(" | ")" | "*" | "+" | "," | "-" | "/" | ":" | ";" | "<" | "=" | ">" | "?" | "@"
  | "[" | "\" | "]" | "^" | "`" | "{" | "|" | "}" | "~" => Sign
  | _ => Unprintable
  end%char.

Definition in_word (c : ascii) : bool := match kind_of c with Letter | Digit | Joint => true | _ => false end.

Fixpoint reverse_onto (s t : string) : string :=
  match s with EmptyString => t | String c r => reverse_onto r (String c t) end.
Definition reverse (s : string) : string := reverse_onto s "".

Fixpoint length_onto (s : string) (n : N) : N := match s with EmptyString => n | String _ r => length_onto r (N.succ n) end.
Definition at_most (n : N) (s : string) : bool := N.leb (length_onto s 0) n.

Definition max_line : N := 1048576.
Definition max_name : N := 100.

(** The lines of a text, without their line feeds; [line] and [done] are what was read, backwards. *)
Fixpoint split_lines (text line : string) (done : list string) : list string :=
  match text with
  | EmptyString => rev' (match line with EmptyString => done | _ => reverse line :: done end)
  | String c rest =>
      match kind_of c with
      | LineFeed => split_lines rest "" (reverse line :: done)
      | _ => split_lines rest (String c line) done
      end
  end.

Definition finish_word (word : string) (done : list string) : list string :=
  match word with EmptyString => done | _ => reverse word :: done end.

(** [<=], [>=] and [!=] are one token. *)
Definition before_equals (c : ascii) : bool := (Ascii.eqb c "<" || Ascii.eqb c ">" || Ascii.eqb c "!")%char.

(** The tokens of a line; [word] and [done] are what was read, backwards. *)
Fixpoint tokens (line word : string) (done : list string) : option (list string) :=
  match line with
  | EmptyString => Some (rev' (finish_word word done))
  | String c rest =>
      match kind_of c with
      | Letter | Digit | Joint => tokens rest (String c word) done
      | Blank => tokens rest "" (finish_word word done)
      | Sign =>
          let done := finish_word word done in
          match rest with
          | String d after =>
              if (before_equals c && Ascii.eqb d "=")%char
              then tokens after "" (String c (String d "") :: done)
              else tokens rest "" (String c "" :: done)
          | EmptyString => tokens rest "" (String c "" :: done)
          end
      | LineFeed | Unprintable => None
      end
  end.

(** A line that counts: as it stands, and its tokens. *)
Record line := Line { raw : string; words : list string }.

Fixpoint counting (ls : list string) (done : list line) : option (list line) :=
  match ls with
  | [] => Some (rev' done)
  | l :: rest =>
      require at_most max_line l in
      let* ts := tokens l "" [] in
      match ts with
      | [] => counting rest done
      | t :: _ => if t =? "#" then counting rest done else counting rest (Line l ts :: done)
      end
  end.

(** The lines that count; refused where a byte is not printable ASCII, or a line too long. *)
Definition lines (text : string) : option (list line) := counting (split_lines text "" []) [].

(** Names and numbers *)

Fixpoint all_in (good : ascii -> bool) (s : string) : bool :=
  match s with EmptyString => true | String c r => if good c then all_in good r else false end.

Definition starts_with_letter (s : string) : bool :=
  match s with String c _ => match kind_of c with Letter => true | _ => false end | EmptyString => false end.

Definition is_name (s : string) : bool :=
  starts_with_letter s && all_in in_word s && at_most max_name s && negb ((s =? "and") || (s =? "or") || (s =? "false")).

(** The names of theorems may begin with a digit, and contain [-]. *)
Definition is_theorem_name (s : string) : bool :=
  match s with String c _ => match kind_of c with Letter | Digit => true | _ => false end | EmptyString => false end
  && all_in (fun c => in_word c || Ascii.eqb c "-")%char s && at_most max_name s.

Definition digit (c : ascii) : option Z :=
  match c with
  | "0" => Some 0 | "1" => Some 1 | "2" => Some 2 | "3" => Some 3 | "4" => Some 4
  | "5" => Some 5 | "6" => Some 6 | "7" => Some 7 | "8" => Some 8 | "9" => Some 9
  | _ => None
  end%char%Z.

Fixpoint digits (s : string) (value : Z) : option Z :=
  match s with
  | EmptyString => Some value
  | String c r => let* d := digit c in digits r (10 * value + d)
  end.

(** Numbers below 2^8192 have at most 2467 digits. *)
Definition max_digits : N := 2467.

(** The value of a token that is a NUMBER: digits, the first of them not 0 but in [0]. *)
Definition number (s : string) : option Z :=
  match s with
  | String c r =>
      if (Ascii.eqb c "0")%char && negb (r =? "") then None
      else require at_most max_digits s in digits s 0
  | EmptyString => None
  end.

(** The value of a token that is an EXPONENT: a NUMBER from 1 to 64. *)
Definition exponent (s : string) : option nat :=
  let* n := number s in require (Z.leb 1 n && Z.leb n 64) in Some (Z.to_nat n).
