(** Statements and certificates as data (FORMAT.md, "Statements" and "Certificates"). Names and numbers are tokens. *)
From Coq Require Import String List.
Import ListNotations.

(** An expression as it is written, parentheses included. *)
Inductive expr :=
| Num (token : string)
| Name (name : string)
| Paren (e : expr)
| Neg (e : expr)
| Pow (base : expr) (exponent : string)
| Mul (a b : expr)
| Div (a b : expr)
| Add (a b : expr)
| Sub (a b : expr).

Inductive rel := Lt | Le | Eq | Ne | Ge | Gt.

(** A formula as it is written, braces included. *)
Inductive formula :=
| False_
| Named (name : string)
| Chain (first : expr) (links : list (rel * expr))
| Braces (f : formula)
| And (f g : formula)
| Or (f g : formula).

Inductive abbreviation :=
| Let (name : string) (e : expr)
| Define (name : string) (f : formula).

Inductive premise :=
| Real (names : list string)
| Abbreviate (a : abbreviation)
| Assume (name : string) (f : formula).

(** [unknowns] are those of the line [exists], none if there is no such line. *)
Record statement := Statement {
  theorem : string;
  premises : list premise;
  unknowns : list string;
  abbreviations : list abbreviation;
  conclusion : formula
}.

(** What the grammar says of priorities: sums of products of powers, left to right. A data structure that stands for a
    text is grouped; the levels are those of EXPRESSION (4), PRODUCT (3), POWER (2), a power without a sign (1), a base (0). *)
Fixpoint grouped (level : nat) (e : expr) : bool :=
  match e with
  | Num _ | Name _ => true
  | Paren a => grouped 4 a
  | Pow a _ => Nat.leb 1 level && grouped 0 a
  | Neg a => Nat.leb 2 level && grouped 2 a
  | Mul a b | Div a b => Nat.leb 3 level && grouped 3 a && grouped 2 b
  | Add a b | Sub a b => Nat.leb 4 level && grouped 4 a && grouped 3 b
  end.

(** The levels are those of FORMULA (2), CONJUNCTION (1), UNIT (0). *)
Fixpoint grouped_formula (level : nat) (f : formula) : bool :=
  match f with
  | False_ | Named _ => true
  | Chain e links => grouped 4 e && negb (match links with [] => true | _ => false end)
                     && forallb (fun link => grouped 4 (snd link)) links
  | Braces g => grouped_formula 2 g
  | And g h => Nat.leb 1 level && grouped_formula 1 g && grouped_formula 0 h
  | Or g h => Nat.leb 2 level && grouped_formula 2 g && grouped_formula 1 h
  end.

Definition grouped_abbreviation (a : abbreviation) : bool :=
  match a with Let _ e => grouped 4 e | Define _ f => grouped_formula 2 f end.

Definition grouped_premise (p : premise) : bool :=
  match p with Real _ => true | Abbreviate a => grouped_abbreviation a | Assume _ f => grouped_formula 2 f end.

Definition grouped_statement (s : statement) : bool :=
  forallb grouped_premise (premises s) && forallb grouped_abbreviation (abbreviations s)
  && grouped_formula 2 (conclusion s).

(** Certificates *)

Inductive sign := Zero | Positive | NonNegative.

(** A line of an identity. *)
Inductive summand :=
| Term (coefficient : string) (factors : list (string * nat))
| Equation (name : string) (factor : expr).

Definition identity := list summand.

Inductive proof :=
| Have (name : string) (p : expr) (s : sign) (refutation : identity) (other : identity) (rest : proof)
| Witness (name : string) (values : list (string * expr)) (rest : proof)
| Split (name : string) (p : expr) (negative zero positive : proof)
| Cases (name : string) (alternatives : branches)
| Contradiction (refutation : identity)
with branches :=
| End
| Branch (p : proof) (rest : branches).

Scheme proof_ind_ := Induction for proof Sort Prop
with branches_ind_ := Induction for branches Sort Prop.
Combined Scheme proof_branches_ind from proof_ind_, branches_ind_.
