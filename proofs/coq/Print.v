(** A statement as the tokens of its lines, and what it means that a text states it. *)
From Coq Require Import String List.
From Slipproof Require Import Text Syntax.
Import ListNotations.
Local Open Scope string_scope.

Fixpoint print (e : expr) (after : list string) : list string :=
  match e with
  | Num token => token :: after
  | Name name => name :: after
  | Paren a => "(" :: print a (")" :: after)
  | Neg a => "-" :: print a after
  | Pow a n => print a ("^" :: n :: after)
  | Mul a b => print a ("*" :: print b after)
  | Div a b => print a ("/" :: print b after)
  | Add a b => print a ("+" :: print b after)
  | Sub a b => print a ("-" :: print b after)
  end.

Definition print_rel (r : rel) : string :=
  match r with Lt => "<" | Le => "<=" | Eq => "=" | Ne => "!=" | Ge => ">=" | Gt => ">" end.

Fixpoint print_formula (f : formula) (after : list string) : list string :=
  match f with
  | False_ => "false" :: after
  | Named name => name :: after
  | Chain e links =>
      print e (fold_right (fun link after => print_rel (fst link) :: print (snd link) after) after links)
  | Braces g => "{" :: print_formula g ("}" :: after)
  | And g h => print_formula g ("and" :: print_formula h after)
  | Or g h => print_formula g ("or" :: print_formula h after)
  end.

Definition print_abbreviation (a : abbreviation) : list string :=
  match a with
  | Let name e => "let" :: name :: "=" :: print e []
  | Define name f => "define" :: name :: ":" :: print_formula f []
  end.

Definition print_premise (p : premise) : list string :=
  match p with
  | Real names => "real" :: names
  | Abbreviate a => print_abbreviation a
  | Assume name f => "assume" :: name :: ":" :: print_formula f []
  end.

Definition print_statement (s : statement) : list (list string) :=
  map print_premise (premises s)
  ++ match unknowns s with [] => [] | names => ["exists" :: names] end
  ++ map print_abbreviation (abbreviations s)
  ++ ["show" :: print_formula (conclusion s) []].

(** The lines of the text that count are the two headers, byte for byte, and then, token for token, those of [s]. *)
Definition states (text : string) (s : statement) : Prop :=
  exists header title body,
    lines text = Some (header :: title :: body)
    /\ raw header = "slipproof-statement 1"
    /\ raw title = "theorem " ++ theorem s
    /\ map words body = print_statement s
    /\ grouped_statement s = true.
