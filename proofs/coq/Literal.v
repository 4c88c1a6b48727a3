(** Texts in files of Coq. A literal of [string] has ten nodes for each character, this one hardly more than one. *)
From Coq Require Import Init.Byte String List.
Import ListNotations.

Inductive literal :=
| End
| One (a : byte) (rest : literal)
| Eight (a b c d e f g h : byte) (rest : literal).

Fixpoint of_bytes (bytes : list byte) : literal :=
  match bytes with
  | [] => End
  | a :: b :: c :: d :: e :: f :: g :: h :: rest => Eight a b c d e f g h (of_bytes rest)
  | a :: rest => One a (of_bytes rest)
  end.

Fixpoint to_bytes (l : literal) : list byte :=
  match l with
  | End => []
  | One a rest => a :: to_bytes rest
  | Eight a b c d e f g h rest => a :: b :: c :: d :: e :: f :: g :: h :: to_bytes rest
  end.

Declare Scope literal_scope.
Delimit Scope literal_scope with literal.
String Notation literal of_bytes to_bytes : literal_scope.

Definition text (l : literal) : string := string_of_list_byte (to_bytes l).
